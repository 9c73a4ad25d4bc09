// The distance of two sets (distance.h).
//
// Why the boundaries are enough: every vertex, edge and facet of a minimal complex lies in the
// closure of its set, whether it is marked or not; otherwise the set would be empty around it, and
// the complex would not have it. If the closures have no common point, the nearest points lie on
// both boundaries. If they have one, but the boundaries do not meet, let C be the component of the
// closure of A with a common point. Either C lies in B, and so does a part of the boundary of A, or
// C contains a part of the boundary of B. (If C has no boundary, it is the whole space.) The parts
// of a boundary are connected, so one vertex of each is enough.
//
// A set of the plane is searched as a set of the plane z = 0.
// Tested by tests/model/distance_test.cpp against all pairs of cells.
#include "plumb/model/distance.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "plumb/base/internal/union_find.h"
#include "plumb/model/nearest/simplex_tree.h"
#include "plumb/model/transform.h"
#include "plumb/predicates/error.h"
#include "plumb/predicates/point3_signs.h"
#include "plumb/predicates/rounding.h"
#include "plumb/predicates/space/rounded_point3.h"
#include "plumb/space/planar/facet_triangles.h"

namespace plumb {
namespace {

void require_points(bool is_empty) {
  if (is_empty) throw Error(ErrorCode::BadArgument, "an empty set has no distance from others");
}

[[noreturn]] void refuse_two_unbounded() {
  throw Error(ErrorCode::BadArgument, "the distance of two unbounded sets is not computed");
}

// ---------------------------------------------------------------- the simplices of a set

constexpr std::uint32_t kNo = SimplexTree::kNone;
constexpr std::uint64_t kBytesPerPlace = 40;  // Each vertex has a place and a class.
constexpr std::uint64_t kBytesPerSimplex =
    200;  // A simplex has corners, a facet, a rounded box and nodes of the tree.

}  // namespace

/// The boundary of a set of the plane or of space: a tree of simplices, and the parts of the
/// boundary.
struct SetBoundary {
  SimplexTree tree;
  std::vector<FacetId> facet;  ///< The facet of each triangle; invalid for other simplices.
  UnionFind parts{0};  ///< The vertices; those of one part of the boundary are in one class.

  void add_simplex(FacetId of, std::uint32_t u, std::uint32_t v = kNo, std::uint32_t w = kNo) {
    tree.simplex.push_back({u, v, w});
    facet.push_back(of);
    if (v != kNo) parts.unite(u, v);
    if (w != kNo) parts.unite(u, w);
  }
};

namespace {

/// A part of a boundary.
struct BoundaryPart {
  Box3 box;
  std::uint32_t vertex;  ///< One of its vertices.
};

std::vector<BoundaryPart> parts_of(const SetBoundary& boundary) {
  UnionFind classes = boundary.parts;
  std::vector<std::uint32_t> number(classes.size(), kNo);
  std::vector<BoundaryPart> parts;
  for (std::uint32_t v = 0; v < classes.size(); ++v) {
    std::uint32_t& n = number[classes.root(v)];
    if (n == kNo) {
      n = static_cast<std::uint32_t>(parts.size());
      parts.push_back({{}, v});
    }
    const auto& at = boundary.tree.vertex[v];
    parts[n].box.add({at, at});
  }
  for (BoundaryPart& part : parts) part.box = boundary.tree.widened(part.box);
  return parts;
}

/// Adds the middle of the box of a point if the box is small; otherwise the rounded point.
void add_vertex(SimplexTree& tree, const Point3Table& points, SpacePoint p) {
  PointBox box = points.box(p);
  const auto size = [](const std::array<double, 3>& at) {
    return std::max({std::abs(at[0]), std::abs(at[1]), std::abs(at[2])});
  };
  if (!(box.radius <= size(box.mid) * 0x1p-40)) {
    const Point3 at = rounded(points, p).at;
    box.mid = {at.x, at.y, at.z};
    box.radius = size(box.mid) * 0x1p-53 + std::numeric_limits<double>::denorm_min();
  }
  tree.vertex.push_back(box.mid);
  tree.error = std::max(tree.error, box.radius);
}

/// Adds the nearest doubles of a point.
void add_vertex(SimplexTree& tree, const RationalPoint3& p) {
  std::array<double, 3> at{nearest_double(p.x), nearest_double(p.y), nearest_double(p.z)};
  for (double& x : at) {
    tree.error =
        std::max(tree.error, std::abs(x) * 0x1p-53 + std::numeric_limits<double>::denorm_min());
  }
  tree.vertex.push_back(at);
}

SetBoundary boundary_of(const Nef3& set, Context& context, MemoryCharge& memory) {
  const SpaceComplex& c = set.complex();
  // This is the greatest possible number of simplices.
  const std::size_t most = c.use_count() + c.edge_count() + c.vertex_count();
  memory.add(c.vertex_count() * kBytesPerPlace + most * kBytesPerSimplex, "a distance");
  SetBoundary result;
  result.parts = UnionFind(c.vertex_count());
  result.tree.exact_vertex = [set](std::uint32_t v) {
    const SpaceComplex& complex = set.complex();
    return exact(complex.points(), complex.vertex_point[VertexId(v)]);
  };
  for (const SpacePoint p : c.vertex_point) {
    if (result.tree.vertex.size() % 1024 == 1023) context.checkpoint("distance", 0, 0);
    add_vertex(result.tree, c.points(), p);
  }
  FacetTriangles triangles(c);
  for (std::uint32_t f = 0; f < c.facet_count(); ++f) {
    if (f % 1024 == 1023) context.checkpoint("distance", f, c.facet_count());
    triangles.for_each(FacetId(f), [&result, f](VertexId u, VertexId v, VertexId w) {
      result.add_simplex(FacetId(f), u.value(), v.value(), w.value());
    });
  }
  for (std::uint32_t e = 0; e < c.edge_count(); ++e) {
    if (c.edge_use[EdgeId(e)].is_valid()) continue;
    result.add_simplex(FacetId(), c.origin[HalfedgeId(2 * e)].value(),
                       c.origin[HalfedgeId(2 * e + 1)].value());
  }
  for (std::uint32_t v = 0; v < c.vertex_count(); ++v) {
    const bool is_isolated =
        c.star_of(VertexId(v)).empty() && !c.vertex_facet[VertexId(v)].is_valid();
    if (is_isolated) result.add_simplex(FacetId(), v);
  }
  result.tree.build(context);
  return result;
}

SetBoundary boundary_of(const Nef2& set, Context& context, MemoryCharge& memory) {
  const PlaneComplex& c = set.complex();
  // This is the greatest possible number of simplices.
  const std::size_t most = c.edge_count() + c.vertex_count();
  memory.add(c.vertex_count() * kBytesPerPlace + most * kBytesPerSimplex, "a distance");
  SetBoundary result;
  result.parts = UnionFind(c.vertex_count());
  result.tree.exact_vertex = [set](std::uint32_t v) {
    const PlaneComplex& complex = set.complex();
    RationalPoint2 at = exact(complex.points, complex.vertex_point[VertexId(v)]);
    return RationalPoint3{std::move(at.x), std::move(at.y), 0};
  };
  for (const std::uint32_t p : c.vertex_point) {
    if (result.tree.vertex.size() % 1024 == 1023) context.checkpoint("distance", 0, 0);
    const RationalPoint2 at = exact(c.points, p);
    add_vertex(result.tree, {at.x, at.y, 0});
  }
  for (std::uint32_t e = 0; e < c.edge_count(); ++e) {
    const VertexId v = c.dcel.origin(first_half(EdgeId(e)));
    const VertexId w = c.dcel.origin(twin(first_half(EdgeId(e))));
    result.add_simplex(FacetId(), v.value(), w.value());
  }
  for (std::uint32_t v = 0; v < c.vertex_count(); ++v) {
    if (c.dcel.is_isolated(VertexId(v))) result.add_simplex(FacetId(), v);
  }
  result.tree.build(context);
  return result;
}

/// Returns a tree of one point.
SimplexTree tree_of(const RationalPoint3& p, Context& context) {
  SimplexTree tree;
  add_vertex(tree, p);
  tree.simplex.push_back({0, kNo, kNo});
  tree.exact_vertex = [p](std::uint32_t) { return p; };
  tree.build(context);
  return tree;
}

// ---------------------------------------------------------------- the cells of simplices

EdgeId edge_between(const SpaceComplex& c, VertexId v, VertexId w) {
  for (const HalfedgeId h : c.star_of(v)) {
    if (c.target(h) == w) return SpaceComplex::edge_of(h);
  }
  return EdgeId();
}

/// Returns the corners of the face of a simplex.
std::vector<std::uint32_t> corners_of(const SimplexTree& tree, std::uint32_t simplex,
                                      SimplexFace face) {
  std::vector<std::uint32_t> corners;
  for (std::uint32_t i = 0; i < 3; ++i) {
    if ((face >> i & 1U) != 0) corners.push_back(tree.simplex[simplex][i]);
  }
  return corners;
}

/// Returns the cell that contains the relative interior of the face of a simplex.
SpaceLocation cell_of(const Nef3& set, const SetBoundary& boundary, std::uint32_t simplex,
                      SimplexFace face) {
  const std::vector<std::uint32_t> corners = corners_of(boundary.tree, simplex, face);
  const SpaceComplex& c = set.complex();
  const VertexId v(corners[0]);
  if (corners.size() == 1) return {v, c.vertex_mark[v] == 1};
  if (corners.size() == 2) {
    const EdgeId e = edge_between(c, v, VertexId(corners[1]));
    if (e.is_valid()) return {e, c.edge_mark[e] == 1};
  }
  const FacetId f = boundary.facet[simplex];
  return {f, c.facet_mark[f] == 1};
}
PlaneLocation cell_of(const Nef2& set, const SetBoundary& boundary, std::uint32_t simplex,
                      SimplexFace face) {
  const std::vector<std::uint32_t> corners = corners_of(boundary.tree, simplex, face);
  const PlaneComplex& c = set.complex();
  PlaneLocation location;
  if (corners.size() == 1) {
    location.vertex = VertexId(corners[0]);
    location.marked = c.mark(location.vertex);
  } else {
    location.edge = EdgeId(simplex);  // The simplices of edges come first.
    location.marked = c.mark(location.edge);
  }
  return location;
}

// ---------------------------------------------------------------- the two kinds of sets

RationalPoint3 point_of_set(const Nef3*, RationalPoint3 p) { return p; }
RationalPoint2 point_of_set(const Nef2*, RationalPoint3 p) {
  return {std::move(p.x), std::move(p.y)};
}
RationalPoint3 in_space(const RationalPoint3& p) { return p; }
RationalPoint3 in_space(const RationalPoint2& p) { return {p.x, p.y, 0}; }

/// Returns the cell of a point if the point lies in the closure of the set.
std::optional<SpaceLocation> cell_in_closure(const Nef3& set, const RationalPoint3& p,
                                             Context& context) {
  const SpaceLocation at = set.locate(p, context);
  if (at.item.kind() == SpaceItem::Kind::Volume && !at.marked) return std::nullopt;
  return at;
}
std::optional<PlaneLocation> cell_in_closure(const Nef2& set, const RationalPoint3& p,
                                             Context& context) {
  const PlaneLocation at = set.locate(RationalPoint2{p.x, p.y}, context);
  if (at.face.is_valid() && !at.marked) return std::nullopt;
  return at;
}

}  // namespace

template <class Set>
struct DistanceOf;
template <>
struct DistanceOf<Nef3> {
  using Type = SpaceDistance;
};
template <>
struct DistanceOf<Nef2> {
  using Type = PlaneDistance;
};

namespace {

template <class Distance>
Distance swapped(Distance d) {
  std::swap(d.at_a, d.at_b);
  std::swap(d.cell_a, d.cell_b);
  return d;
}

}  // namespace

/// A bounded set with the tree of its boundary.
template <class Set>
struct PreparedSet {
  using Distance = typename DistanceOf<Set>::Type;

  PreparedSet(const Set& of, Context& context, MemoryCharge& memory)
      : set(of), boundary(boundary_of(of, context, memory)) {}

  /// Returns the distance if a part of the boundary of this set lies in the closure of another set.
  std::optional<Distance> as_contained_in(const PreparedSet& other, Context& context) const {
    const Box3 around = other.boundary.tree.bounds();
    if (!boundary.tree.bounds().meets(around)) return std::nullopt;
    for (const BoundaryPart& part : parts_of(boundary)) {
      if (!part.box.meets(around)) continue;
      const RationalPoint3 p = boundary.tree.exact_vertex(part.vertex);
      const auto cell = cell_in_closure(other.set, p, context);
      if (!cell) continue;
      const auto at = point_of_set(&set, p);
      return Distance{0, at, at, *cell_in_closure(set, p, context), *cell};
    }
    return std::nullopt;
  }

  Distance to(const PreparedSet& other, Context& context) const {
    const auto found = SimplexTree::nearest(boundary.tree, other.boundary.tree, context);
    const NearestPoints& points = found.points;
    if (!points.squared.is_zero()) {
      if (auto inside = as_contained_in(other, context)) return *inside;
      if (auto inside = other.as_contained_in(*this, context)) return swapped(*inside);
    }
    return {points.squared, point_of_set(&set, points.a), point_of_set(&set, points.b),
            cell_of(set, boundary, found.a, points.face_a),
            cell_of(other.set, other.boundary, found.b, points.face_b)};
  }

  Set set;
  SetBoundary boundary;
};

namespace {

// ---------------------------------------------------------------- unbounded sets

/// A box with exact bounds.
struct ExactBox {
  RationalPoint3 low;
  RationalPoint3 high;

  explicit ExactBox(const SimplexTree& tree) : low(tree.exact_vertex(0)), high(low) {
    for (std::uint32_t v = 1; v < tree.vertex.size(); ++v) add(tree.exact_vertex(v));
  }
  void add(const RationalPoint3& p) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
  Rational side() const { return std::max({high.x - low.x, high.y - low.y, high.z - low.z}); }
};

/// Returns the part of a set within a box that is grown by a margin.
Nef3 cut_off(const Nef3& set, const ExactBox& box, const Rational& margin, Context& context) {
  const std::array<HalfSpace3, 6> sides{
      HalfSpace3{{-1, 0, 0, box.low.x - margin}}, HalfSpace3{{1, 0, 0, -box.high.x - margin}},
      HalfSpace3{{0, -1, 0, box.low.y - margin}}, HalfSpace3{{0, 1, 0, -box.high.y - margin}},
      HalfSpace3{{0, 0, -1, box.low.z - margin}}, HalfSpace3{{0, 0, 1, -box.high.z - margin}}};
  return boolean_op(set, Nef3::intersection(sides, context), kIntersection, context);
}
Nef2 cut_off(const Nef2& set, const ExactBox& box, const Rational& margin, Context& context) {
  PointTable2 corners;
  corners.push_back(box.low.x - margin, box.low.y - margin);
  corners.push_back(box.high.x + margin, box.low.y - margin);
  corners.push_back(box.high.x + margin, box.high.y + margin);
  corners.push_back(box.low.x - margin, box.high.y + margin);
  const std::array<std::uint32_t, 4> ring{0, 1, 2, 3};
  const std::array<std::uint32_t, 2> begin{0, 4};
  const Nef2 square =
      Nef2::polygons(corners, ring, begin, WindingRule::NonZero, Boundary::Closed, context);
  return boolean_op(set, square, kIntersection, context);
}

/// Returns the distance of an unbounded set and a bounded one. Points of `a` that were cut off are
/// farther from `b` than the margin.
template <class Set>
typename DistanceOf<Set>::Type distance_to_bounded(const Set& a, const PreparedSet<Set>& b,
                                                   Context& context) {
  const ExactBox box(b.boundary.tree);
  Rational margin = std::max(box.side(), Rational(1));
  for (Rational factor = 16;; factor *= factor) {
    context.checkpoint("distance", 0, 0);
    const Set near = cut_off(a, box, margin, context);
    if (near.is_empty()) {
      margin *= factor;
      continue;
    }
    MemoryCharge memory(context);
    auto result = PreparedSet<Set>(near, context, memory).to(b, context);
    if (result.squared <= margin * margin) {
      result.cell_a = *cell_in_closure(a, in_space(result.at_a), context);
      return result;
    }
    margin = result.squared + 1;  // The margin is at least the distance.
  }
}

template <class Set>
typename DistanceOf<Set>::Type distance_of(const Set& a, const Set& b, Context& context) {
  require_points(a.is_empty() || b.is_empty());
  const bool a_is_bounded = a.is_bounded(), b_is_bounded = b.is_bounded();
  if (!a_is_bounded && !b_is_bounded) refuse_two_unbounded();
  MemoryCharge memory(context);
  const PreparedSet<Set> bounded(b_is_bounded ? b : a, context, memory);
  if (!a_is_bounded) return distance_to_bounded(a, bounded, context);
  if (!b_is_bounded) return swapped(distance_to_bounded(b, bounded, context));
  return PreparedSet<Set>(a, context, memory).to(bounded, context);
}

}  // namespace

double root_of(const Rational& square) {
  if (square.sign() < 0) throw Error(ErrorCode::BadArgument, "a negative number has no root");
  if (square.is_zero()) return 0;
  // The root of num / den is the root of num * den * 4^k, divided by den * 2^k. If the radicand has
  // at least 128 bits, the integer part of the root has 64 bits, and its relative error is below
  // 2^-63.
  const Integer den = denominator(square);
  Integer radicand = numerator(square) * den;
  const std::size_t bits = mpz_sizeinbase(radicand.mpz(), 2);
  const unsigned long k = bits >= 128 ? 0 : static_cast<unsigned long>((129 - bits) / 2);
  mpz_mul_2exp(radicand.mpz(), radicand.mpz(), 2 * k);
  mpz_sqrt(radicand.mpz(), radicand.mpz());
  Integer scaled = den;
  mpz_mul_2exp(scaled.mpz(), scaled.mpz(), k);
  return nearest_double(Rational(std::move(radicand), std::move(scaled)));
}

SpaceDistance distance(const Nef3& a, const Nef3& b, Context& context) {
  return distance_of(a, b, context);
}
SpaceDistance distance(const Nef3& a, const RationalPoint3& p, Context& context) {
  return distance_of(a, Nef3::point(p), context);
}
PlaneDistance distance(const Nef2& a, const Nef2& b, Context& context) {
  return distance_of(a, b, context);
}
PlaneDistance distance(const Nef2& a, const RationalPoint2& p, Context& context) {
  return distance_of(a, Nef2::point(p), context);
}

struct DistanceIndex::State {
  PreparedSet<Nef3> prepared;
};

DistanceIndex::DistanceIndex(const Nef3& set, Context& context) {
  require_points(set.is_empty());
  if (!set.is_bounded()) {
    throw Error(ErrorCode::BadArgument, "an unbounded set cannot be prepared for distances");
  }
  MemoryCharge memory(context);
  state_ = std::make_shared<const State>(State{PreparedSet<Nef3>(set, context, memory)});
}
DistanceIndex::DistanceIndex(const DistanceIndex&) = default;
DistanceIndex& DistanceIndex::operator=(const DistanceIndex&) = default;
DistanceIndex::~DistanceIndex() = default;

SpaceDistance DistanceIndex::to(const DistanceIndex& other, Context& context) const {
  return state_->prepared.to(other.state_->prepared, context);
}

SpaceDistance DistanceIndex::to(const RationalPoint3& p, Context& context) const {
  const auto& [set, boundary] = state_->prepared;
  if (const auto cell = cell_in_closure(set, p, context))
    return {0, p, p, *cell, {VertexId(0), true}};
  const auto found = SimplexTree::nearest(boundary.tree, tree_of(p, context), context);
  const NearestPoints& points = found.points;
  return {points.squared,
          points.a,
          p,
          cell_of(set, boundary, found.a, points.face_a),
          {VertexId(0), true}};
}

}  // namespace plumb
