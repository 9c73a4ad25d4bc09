// The canonical form: the cells are ordered, planes and points get names that depend only on the
// set, and the arrays are written.
//
// The order of cells follows from the set (compare_complexes.h). The names follow from the set,
// too: each plane is taken from the first cell in that order that needs it, with primitive
// coefficients; an edge has the first two planes of its facets, or planes through it along axes; a
// point is an input point if it can be, or the first three independent planes at it. So two
// complexes of one set get equal tables and arrays. All names are made from planes of the minimal
// complex, or from planes that one of its edges or points determines. Ids of the old tables are
// never used.
//
// Tested by tests/space/canonical_test.cpp.

#include "plumb/space/canonical.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "plumb/predicates/error.h"
#include "plumb/predicates/plane_signs.h"
#include "plumb/predicates/point3_signs.h"
#include "plumb/predicates/rounding.h"
#include "plumb/predicates/space/query_point3.h"
#include "plumb/space/boolean/frame.h"
#include "plumb/space/complex/tidy_tables.h"
#include "plumb/space/set/compare_complexes.h"
#include "plumb/sphere/sphere_map.h"

namespace plumb {
namespace {

/// The planes across the axes.
constexpr std::array<PlaneId, 3> kAcross = {kPlaneX, kPlaneY, kPlaneZ};

/// Sorts ids and drops repetitions. New ids ascend in the order of their first appearance.
void sort_unique(std::vector<PlaneId>& planes) {
  std::sort(planes.begin(), planes.end());
  planes.erase(std::unique(planes.begin(), planes.end()), planes.end());
}

/// Makes tables of the planes and points that the set itself names (canonical.h).
class Naming {
 public:
  Naming(const SpaceComplex& complex, const CanonicalOrder& order, Context& context)
      : c_(complex),
        order_(order),
        context_(context),
        tables_(std::make_shared<SpaceTables>()),
        plane_(complex.planes().size()) {
    if (has_frame(c_)) tables_->planes.intern_frame();
  }

  /// Fills the tables, facet_plane, edge_planes and vertex_point.
  void run(SpaceComplex& out) {
    name_facets(out);
    name_edges(out);
    name_points(out);
    direct_edges(out);
    out.tables = std::move(tables_);
  }

 private:
  void name_facets(SpaceComplex& out);
  void name_edges(SpaceComplex& out);
  void name_points(SpaceComplex& out);
  void direct_edges(SpaceComplex& out);

  PlaneTable& planes() { return tables_->planes; }
  /// Interns a plane with primitive coefficients, so that the source of the plane is the same, too.
  PlaneId intern(const IntegerRow& row) {
    const IntegerRow least = primitive(row);
    return planes()
        .intern(Rational(least[0]), Rational(least[1]), Rational(least[2]), Rational(least[3]))
        .plane();
  }
  PlaneId plane_of(FacetId f);
  void add_facet_planes(EdgeId e, std::vector<PlaneId>& found);
  std::array<PlaneId, 2> planes_of(EdgeId e);
  std::optional<IntegerRow> plane_along(EdgeId e, std::size_t axis) const;
  std::array<PlaneId, 3> planes_at(const SpaceComplex& out, VertexId v);
  bool is_independent(PlaneId p) const;
  std::optional<Point3> as_doubles(SpacePoint p) const;

  const SpaceComplex& c_;
  const CanonicalOrder& order_;
  Context& context_;
  std::shared_ptr<SpaceTables> tables_;
  std::vector<PlaneId> plane_;  ///< The id in tables_ of each plane of c_, once it is there.
  std::vector<PlaneId> found_;  ///< Memory that is reused.
  std::vector<PlaneId> chosen_;
};

// ---------------------------------------------------------------- planes

/// Returns the new id of a facet's plane. Planes of the frame are in the new table already, in the
/// same order.
PlaneId Naming::plane_of(FacetId f) {
  const PlaneId old = c_.facet_plane[f];
  PlaneId& plane = plane_[old.value()];
  if (plane.is_valid()) return plane;
  if (c_.planes().is_frame(old)) {
    const std::size_t i = c_.planes().source(old).frame_index();
    PLUMB_CHECK(i < planes().frame().size());
    return plane = planes().frame()[i];
  }
  return plane = intern(c_.planes().coefficients(old));
}

void Naming::name_facets(SpaceComplex& out) {
  const auto& facets = order_.facets.ids();
  out.facet_plane.reserve(facets.size());
  for (std::size_t f = 0; f < facets.size(); ++f) {
    if (f % 1024 == 0) context_.checkpoint("names of planes", f, facets.size());
    out.facet_plane.push_back(plane_of(facets[f]));
  }
}

/// Appends the planes of the facets around an edge.
void Naming::add_facet_planes(EdgeId e, std::vector<PlaneId>& found) {
  const UseId first = c_.edge_use[e];
  if (!first.is_valid()) return;
  UseId u = first;
  do {
    found.push_back(plane_of(c_.use_facet[u]));
    u = c_.use_radial[u];
  } while (u != first);
}

/// Returns the plane through the edge along an axis: q_i p - p_i q for the planes p and q of the
/// edge; nothing if the edge runs along the axis. Edges on the frame never need it, because they
/// have two facets in different planes.
std::optional<IntegerRow> Naming::plane_along(EdgeId e, std::size_t axis) const {
  const auto& [p, q] = c_.edge_planes[e];
  PLUMB_CHECK(!c_.planes().is_frame(p) && !c_.planes().is_frame(q));
  const IntegerRow first = c_.planes().coefficients(p), second = c_.planes().coefficients(q);
  if (first[axis] == 0 && second[axis] == 0) return {};
  IntegerRow row;
  for (std::size_t i = 0; i < row.size(); ++i) {
    row[i] = second[axis] * first[i] - first[axis] * second[i];
  }
  return row;
}

/// Returns the two planes that name an edge.
std::array<PlaneId, 2> Naming::planes_of(EdgeId e) {
  found_.clear();
  add_facet_planes(e, found_);
  sort_unique(found_);
  // An edge with facets in fewer than two planes gets planes through it along axes, x first. At
  // most one axis is parallel to the edge, so there are enough.
  for (std::size_t axis = 0; axis < 3 && found_.size() < 2; ++axis) {
    const auto row = plane_along(e, axis);
    if (!row) continue;
    const PlaneId plane = intern(*row);
    if (found_.empty() || found_[0] != plane) found_.push_back(plane);
  }
  PLUMB_CHECK(found_.size() >= 2);
  return {found_[0], found_[1]};
}

void Naming::name_edges(SpaceComplex& out) {
  const auto& edges = order_.edges.ids();
  out.edge_planes.reserve(edges.size());
  for (std::size_t e = 0; e < edges.size(); ++e) {
    if (e % 1024 == 0) context_.checkpoint("names of planes", e, edges.size());
    out.edge_planes.push_back(planes_of(edges[e]));
  }
}

/// Sorts the planes of each edge such that half-edge 2e begins at its lesser vertex.
void Naming::direct_edges(SpaceComplex& out) {
  const auto& edges = order_.edges.ids();
  for (std::size_t e = 0; e < edges.size(); ++e) {
    const std::size_t h = 2 * std::size_t{edges[e].value()};
    VertexId from = order_.vertices(c_.origin[h]), to = order_.vertices(c_.origin[h + 1]);
    if (to < from) std::swap(from, to);
    auto& [p, q] = out.edge_planes[e];
    const Sign along =
        order_along_line(tables_->points, p, q, out.vertex_point[from], out.vertex_point[to]);
    if (along == Sign::Negative) std::swap(p, q);
  }
}

// ---------------------------------------------------------------- points

/// Returns a point as doubles without negative zeros, or nothing if a coordinate is not a double.
std::optional<Point3> Naming::as_doubles(SpacePoint p) const {
  if (p.is_input()) {
    const Point3& at = c_.planes().point(p.input());
    return Point3{at.x + 0.0, at.y + 0.0, at.z + 0.0};
  }
  if (c_.points().depends_on_frame(p)) return {};
  const RationalPoint3 at = exact(c_.points(), p);
  std::array<double, 3> rounded{};
  for (std::size_t i = 0; i < 3; ++i) {
    const RoundedDouble nearest = round_to_double(coordinate(at, i));
    if (nearest.error != Sign::Zero) return {};
    rounded[i] = nearest.value;
  }
  return Point3{rounded[0], rounded[1], rounded[2]};
}

/// Whether the normal of a plane is independent of those of the planes chosen. All these planes are
/// different and have a common point.
bool Naming::is_independent(PlaneId p) const {
  const PlaneTable& planes = tables_->planes;
  if (chosen_.empty()) return true;
  if (chosen_.size() == 2) return det3_sign(planes, chosen_[0], chosen_[1], p) != Sign::Zero;
  for (std::size_t i = 0; i < 3; ++i) {
    if (minor_sign(planes, chosen_[0], p, i) != Sign::Zero) return true;
  }
  return false;
}

/// Returns the three planes that name a point: the first independent ones of facets and edges at
/// it, then planes across axes.
std::array<PlaneId, 3> Naming::planes_at(const SpaceComplex& out, VertexId v) {
  found_.clear();
  for (const HalfedgeId h : c_.star_of(v)) {
    const EdgeId e = SpaceComplex::edge_of(h);
    add_facet_planes(e, found_);
    const auto& [p, q] = out.edge_planes[order_.edges(e)];
    found_.insert(found_.end(), {p, q});
  }
  if (c_.vertex_facet[v].is_valid()) found_.push_back(plane_of(c_.vertex_facet[v]));
  sort_unique(found_);
  chosen_.clear();
  for (std::size_t i = 0; i < found_.size() && chosen_.size() < 3; ++i) {
    if (is_independent(found_[i])) chosen_.push_back(found_[i]);
  }
  // With fewer than three independent planes, as at isolated vertices and ends of free edges in
  // special position, planes across axes complete the point.
  if (chosen_.size() < 3) {
    const RationalPoint3 at = exact(c_.points(), c_.vertex_point[v]);
    for (std::size_t i = 0; i < 3 && chosen_.size() < 3; ++i) {
      if (!is_independent(kAcross[i])) continue;
      std::array<Rational, 3> normal{0, 0, 0};
      normal[i] = 1;
      chosen_.push_back(
          planes().intern(normal[0], normal[1], normal[2], Rational(-coordinate(at, i))).plane());
    }
  }
  std::sort(chosen_.begin(), chosen_.end());
  return {chosen_[0], chosen_[1], chosen_[2]};
}

// Doubles are tried first. An input point needs no planes, whatever its history is.
void Naming::name_points(SpaceComplex& out) {
  const auto& vertices = order_.vertices.ids();
  out.vertex_point.reserve(vertices.size());
  for (std::size_t v = 0; v < vertices.size(); ++v) {
    if (v % 1024 == 0) context_.checkpoint("names of points", v, vertices.size());
    if (const auto at = as_doubles(c_.vertex_point[vertices[v]])) {
      out.vertex_point.emplace_back(planes().add_point(*at));
      continue;
    }
    const auto [p, q, r] = planes_at(out, vertices[v]);
    out.vertex_point.push_back(tables_->points.add(p, q, r));
    PLUMB_CHECK(out.vertex_point.back().is_valid());
  }
}

// ---------------------------------------------------------------- arrays

/// Returns an array in the new order: to[i] = from[ids[i]].
template <class T, class Id>
std::vector<T> reordered(const std::vector<T>& from, const NewOrder<Id>& order) {
  std::vector<T> to;
  to.reserve(from.size());
  for (const Id id : order.ids()) to.push_back(from[id.value()]);
  return to;
}

/// Returns the same for an array of ids, which get their new numbers.
template <class T, class Id>
std::vector<T> renumbered(const std::vector<T>& from, const NewOrder<Id>& order,
                          const NewOrder<T>& numbers) {
  std::vector<T> to = reordered(from, order);
  for (T& id : to) id = numbers(id);
  return to;
}

/// Writes all arrays but those that Naming fills.
class Writing {
 public:
  Writing(const SpaceComplex& complex, const CanonicalOrder& order) : c_(complex), o_(order) {}

  void run(SpaceComplex& out) const {
    write_vertices(out);
    write_edges(out);
    out.list_stars(out.vertex_mark.size());
    write_uses(out);
    write_rings(out);
    write_facets(out);
    out.volume_mark = reordered(c_.volume_mark, o_.volumes);
  }

 private:
  void write_vertices(SpaceComplex& out) const {
    out.vertex_mark = reordered(c_.vertex_mark, o_.vertices);
    out.vertex_volume = renumbered(c_.vertex_volume, o_.vertices, o_.volumes);
    out.vertex_facet = renumbered(c_.vertex_facet, o_.vertices, o_.facets);
  }

  void write_edges(SpaceComplex& out) const {
    out.edge_mark = reordered(c_.edge_mark, o_.edges);
    out.edge_volume = renumbered(c_.edge_volume, o_.edges, o_.volumes);
    out.origin.resize(c_.origin.size());
    for (std::size_t h = 0; h < c_.origin.size(); ++h) {
      out.origin[o_.halfedge(c_, HalfedgeId(h)).value()] = o_.vertices(c_.origin[h]);
    }
  }

  void write_uses(SpaceComplex& out) const {
    out.use_halfedge = reordered(c_.use_halfedge, o_.uses);
    for (HalfedgeId& h : out.use_halfedge) h = o_.halfedge(c_, h);
    out.use_next = renumbered(c_.use_next, o_.uses, o_.uses);
    out.use_prev = renumbered(c_.use_prev, o_.uses, o_.uses);
    out.use_facet = renumbered(c_.use_facet, o_.uses, o_.facets);
  }

  /// Writes radial orders. If the direction of an edge is reversed, the order of its uses is
  /// reversed, too.
  void write_rings(SpaceComplex& out) const {
    out.use_radial.resize(c_.use_count());
    out.edge_use.assign(c_.edge_count(), UseId());
    for (std::size_t u = 0; u < c_.use_count(); ++u) {
      const EdgeId e = SpaceComplex::edge_of(c_.use_halfedge[u]);
      UseId from = o_.uses(UseId(u)), to = o_.uses(c_.use_radial[u]);
      UseId& first = out.edge_use[o_.edges(e)];
      first = std::min(first, from);  // An invalid id is the greatest one.
      if (o_.is_turned(c_, e)) std::swap(from, to);
      out.use_radial[from] = to;
    }
  }

  /// Writes facets with their cycles and inner vertices; facet_origin is dropped.
  void write_facets(SpaceComplex& out) const {
    out.facet_mark = reordered(c_.facet_mark, o_.facets);
    out.facet_volume = reordered(c_.facet_volume, o_.facets);
    for (auto& [above, below] : out.facet_volume) {
      above = o_.volumes(above);
      below = o_.volumes(below);
    }
    out.facet_origin.assign(c_.facet_count(), kNone);
    for (const UseId first : o_.cycles) out.cycle.push_back(o_.uses(first));
    out.cycle_begin = out.inner_begin = {0};
    for (const FacetId f : o_.facets.ids()) {
      out.cycle_begin.push_back(out.cycle_begin.back() +
                                static_cast<std::uint32_t>(c_.cycles_of(f).size()));
      const std::size_t begin = out.inner.size();
      for (const VertexId v : c_.inner_of(f)) out.inner.push_back(o_.vertices(v));
      std::sort(out.inner.begin() + static_cast<std::ptrdiff_t>(begin), out.inner.end());
      out.inner_begin.push_back(static_cast<std::uint32_t>(out.inner.size()));
    }
  }

  const SpaceComplex& c_;
  const CanonicalOrder& o_;
};

}  // namespace

// Naming adds the arrays that refer to tables, Writing all others.
SpaceComplex canonical(const SpaceComplex& minimal, Context& context) {
  MemoryCharge memory(context);
  memory.add(2 * memory_bytes(minimal), "the canonical form");
  const CanonicalOrder order = canonical_order(minimal, context);
  SpaceComplex out;
  Naming(minimal, order, context).run(out);
  Writing(minimal, order).run(out);
  return out;
}

Nef3 canonical(const Nef3& set, Context& context) {
  return Nef3::from_minimal_unchecked(canonical(set.complex(), context));
}

}  // namespace plumb
