// Lays facets over the source triangles of their planes, and cuts them where the source changes.
//
// A facet is whole if its plane has no source triangle, or one that contains all of its vertices. A
// facet that is exactly one face of a source, and is alone in its plane, needs no overlay, either.
// All other facets of a plane are cut together: one sweep (plane/arrangement.h) makes the
// subdivision by the edges of these facets and of the source triangles of the plane. For each face
// of the subdivision, the facets and triangles that contain it are found. Across an edge, only
// those facets and triangles change whose boundaries contain the edge. Faces of one facet are
// joined to regions across edges at which the attributes do not change.
//
// A cut that ends inside an edge of a facet makes a vertex there. All facets at this edge get the
// vertex, so that triangles meet in common edges. Vertices are therefore collected for each edge
// over all planes, sorted along the edge and merged where they are equal, before any facet is
// triangulated.
//
// Invariants: a vertex of the complex is never dropped; a vertex that cuts have made is dropped if
// joining has left a straight line there. So a facet whose pieces are all joined keeps its corners.
//
// Tested by tests/space/mesh_with_attributes_test.cpp.
#include "plumb/space/set/cut_boundary.h"

#include <algorithm>
#include <array>
#include <bit>
#include <optional>
#include <span>
#include <utility>

#include "plumb/base/internal/union_find.h"
#include "plumb/plane/arrangement.h"
#include "plumb/predicates/plane/plane_points.h"
#include "plumb/predicates/point3_signs.h"
#include "plumb/predicates/space/rounded_point3.h"
#include "plumb/space/planar/facet_triangles.h"
#include "plumb/space/planar/triangulate.h"
#include "plumb/space/to_mesh.h"

namespace plumb {
namespace {

/// An edge of the boundary of a region, with the region on its left, seen from the positive side.
struct RegionEdge {
  VertexId from;
  VertexId to;
  EdgeId edge;  // The edge of the complex that contains it, or an invalid id for a cut.
};

/// The outline of a region.
struct Outline {
  std::vector<RegionEdge> edges;
  std::vector<VertexId> inner;  // The vertices inside.
};

/// A part of a facet that is triangulated separately.
struct Region {
  std::uint32_t piece;
  bool is_reversed;  // Whether the outside is on the negative side of the plane.
  PlaneId plane;
  // The index of the outline in CutState::outlines, or kNone for a whole facet.
  std::uint32_t outline;
};

/// Calls visit(u) for each use of the boundary of a facet.
template <class Visit>
void for_each_use(const SpaceComplex& c, FacetId f, const Visit& visit) {
  for (const UseId first : c.cycles_of(f)) {
    UseId u = first;
    do {
      visit(u);
      u = c.use_next[u];
    } while (u != first);
  }
}

/// The vertices that cuts have made inside of edges of the complex.
class EdgeCuts {
 public:
  explicit EdgeCuts(const GrowingComplex& complex) : complex_(complex) {}

  void add(EdgeId e, VertexId v) { cuts_.emplace_back(e, v); }
  bool is_empty() const { return cuts_.empty(); }
  /// Sorts the vertices along their edges, and merges equal ones.
  void sort() {
    std::sort(cuts_.begin(), cuts_.end(), [this](const Cut& a, const Cut& b) {
      if (a.first != b.first) return a.first < b.first;
      const Sign order = compare(a.second, b.second);
      return order == Sign::Zero ? a.second < b.second : order == Sign::Negative;
    });
    std::size_t kept = 0;
    for (const Cut& cut : cuts_) {
      const bool is_known = kept > 0 && cuts_[kept - 1].first == cut.first &&
                            compare(cuts_[kept - 1].second, cut.second) == Sign::Zero;
      if (is_known) {
        merged_.emplace_back(cut.second, cuts_[kept - 1].second);
      } else {
        cuts_[kept++] = cut;
      }
    }
    cuts_.resize(kept);
    std::sort(merged_.begin(), merged_.end());
  }
  /// Returns the vertex into which a vertex was merged.
  VertexId merged(VertexId v) const {
    const auto found = std::lower_bound(merged_.begin(), merged_.end(), std::pair(v, VertexId(0)));
    return found != merged_.end() && found->first == v ? found->second : v;
  }
  /// Whether an edge has vertices inside.
  bool has(EdgeId e) const {
    const auto [first, last] = of(e);
    return first != last;
  }
  /// Appends the vertices between two points of an edge, in their order from the first one.
  void append_between(const RegionEdge& part, std::vector<VertexId>& vertices) const {
    const bool is_rising = compare(part.from, part.to) == Sign::Negative;
    const VertexId low = is_rising ? part.from : part.to, high = is_rising ? part.to : part.from;
    const auto [first, last] = of(part.edge);
    const auto begin = std::partition_point(
        first, last, [&](const Cut& c) { return compare(c.second, low) != Sign::Positive; });
    const auto end = std::partition_point(
        begin, last, [&](const Cut& c) { return compare(c.second, high) == Sign::Negative; });
    const std::size_t old = vertices.size();
    for (auto c = begin; c != end; ++c) vertices.push_back(c->second);
    if (!is_rising)
      std::reverse(vertices.begin() + static_cast<std::ptrdiff_t>(old), vertices.end());
  }

 private:
  using Cut = std::pair<EdgeId, VertexId>;

  Sign compare(VertexId v, VertexId w) const {
    if (v == w) return Sign::Zero;
    const SpaceComplex& c = complex_.get();
    return compare_xyz(c.points(), c.vertex_point[v], c.vertex_point[w]);
  }
  std::pair<std::vector<Cut>::const_iterator, std::vector<Cut>::const_iterator> of(EdgeId e) const {
    const auto first =
        std::partition_point(cuts_.begin(), cuts_.end(), [&](const Cut& c) { return c.first < e; });
    const auto last =
        std::partition_point(first, cuts_.end(), [&](const Cut& c) { return c.first == e; });
    return {first, last};
  }

  const GrowingComplex& complex_;
  std::vector<Cut> cuts_;
  std::vector<std::pair<VertexId, VertexId>> merged_;
};

// ---------------------------------------------------------------- one plane

/// A set of indices whose least one is found in a few steps. Level 0 has a bit for each index; each
/// further level has a bit for each word of the level below that is not zero.
class IndexSet {
 public:
  IndexSet() : IndexSet(0) {}
  explicit IndexSet(std::size_t size) {
    do {
      size = (size + kBits - 1) / kBits;
      levels_.emplace_back(size, 0);
    } while (size > 1);
  }
  /// Adds the index if the set does not contain it, otherwise removes it.
  void toggle(std::size_t index) {
    levels_[0][index / kBits] ^= std::uint64_t{1} << (index % kBits);
    for (std::size_t level = 1; level < levels_.size(); ++level) {
      index /= kBits;
      const std::uint64_t bit = std::uint64_t{1} << (index % kBits);
      std::uint64_t& word = levels_[level][index / kBits];
      word = levels_[level - 1][index] != 0 ? word | bit : word & ~bit;
    }
  }
  /// Returns the least index, or kNone.
  std::uint32_t first() const {
    std::size_t at = 0;
    for (std::size_t level = levels_.size(); level-- > 0;) {
      if (levels_[level].empty() || levels_[level][at] == 0) return kNone;
      at = kBits * at + static_cast<std::size_t>(std::countr_zero(levels_[level][at]));
    }
    return static_cast<std::uint32_t>(at);
  }

 private:
  static constexpr std::size_t kBits = 64;
  std::vector<std::vector<std::uint64_t>> levels_;
};

/// The data that cutting the facets of a plane reads and changes.
struct CutState {
  GrowingComplex& growing;
  SourceTriangles& sources;
  const AttributeOptions& options;
  Context& context;
  std::vector<BoundaryPiece> pieces;
  std::vector<Region> regions;
  std::vector<Outline> outlines;  // The outlines of the regions that are not whole facets.
  EdgeCuts edge_cuts;

  const SpaceComplex& complex() const { return growing.get(); }
  const SpaceTables& tables() const { return growing.tables(); }
  void add_region(std::uint32_t piece, bool is_reversed, PlaneId plane, Outline outline) {
    regions.push_back({piece, is_reversed, plane, static_cast<std::uint32_t>(outlines.size())});
    outlines.push_back(std::move(outline));
  }
  Outline& outline_of_region(std::uint32_t region) { return outlines[regions[region].outline]; }
};

/// Cuts the facets of one plane along the source triangles of this plane.
class PlaneCutter {
 public:
  PlaneCutter(CutState& state, PlaneId plane, std::span<const FacetSide> sides)
      : state_(state),
        plane_(plane),
        sides_(sides),
        triangles_(state.sources.in_plane(plane)),
        view_(FlatView::of_plane(state.tables().planes, plane)) {}

  void run() {
    collect_points();
    collect_segments();
    arrangement_ = arrange(std::move(points2_), segments_, state_.context);
    // All points are ends of segments, so the subdivision has kept their indices.
    PLUMB_CHECK(flat().points.inputs.size() == places_.size());
    label_faces();
    join_faces();
    find_kept();
    make_regions();
  }

 private:
  const PlaneComplex& flat() const { return arrangement_->complex; }
  const Dcel& dcel() const { return arrangement_->complex.dcel; }
  std::uint32_t side_count() const { return static_cast<std::uint32_t>(sides_.size()); }

  /// Lists the vertices of the facets.
  void collect_vertices() {
    const SpaceComplex& c = state_.complex();
    for (const FacetSide& side : sides_) {
      for_each_use(c, side.facet, [&](UseId u) { vertices_.push_back(c.use_origin(u)); });
      const auto inner = c.inner_of(side.facet);
      vertices_.insert(vertices_.end(), inner.begin(), inner.end());
    }
    std::sort(vertices_.begin(), vertices_.end());
    vertices_.erase(std::unique(vertices_.begin(), vertices_.end()), vertices_.end());
    for (const VertexId v : vertices_) places_.push_back(c.vertex_point[v]);
  }

  /// Lists the different points: first the vertices, and then the corners of triangles at other
  /// places.
  void collect_points() {
    collect_vertices();
    std::vector<SpacePoint> all = places_;
    for (std::uint32_t t = triangles_.first; t != triangles_.end; ++t) {
      if (state_.sources.is_plane(state_.sources[t])) {
        // If the triangle stands for the whole plane, it has no corners.
        all.insert(all.end(), 3, all.front());
        continue;
      }
      for (std::size_t i = 0; i < 3; ++i) all.push_back(state_.sources.place(state_.sources[t], i));
    }
    FlatPoints shown(state_.tables().points);
    shown.reset(view_);
    for (const SpacePoint p : all) shown.push_back(p);
    std::vector<std::uint32_t> order(all.size()), first_of(all.size());
    for (std::uint32_t i = 0; i < order.size(); ++i) order[i] = i;
    std::sort(order.begin(), order.end(), [&](std::uint32_t i, std::uint32_t j) {
      const Sign sign = i == j ? Sign::Zero : shown.compare(i, j);
      return sign == Sign::Zero ? i < j : sign == Sign::Negative;
    });
    for (std::size_t k = 0; k < order.size(); ++k) {
      const bool is_known = k > 0 && shown.compare(order[k - 1], order[k]) == Sign::Zero;
      first_of[order[k]] = is_known ? first_of[order[k - 1]] : order[k];
    }
    // The first of several equal points precedes the others, so its index is known.
    index_of_point_.resize(all.size());
    for (std::uint32_t i = 0; i < all.size(); ++i) {
      const bool is_first = first_of[i] == i;
      if (is_first && i >= vertices_.size()) places_.push_back(all[i]);
      const auto last = static_cast<std::uint32_t>(places_.size() - 1);
      index_of_point_[i] = i < vertices_.size() ? i
                           : is_first           ? last
                                                : index_of_point_[first_of[i]];
    }
    shown.reset(view_);
    for (const SpacePoint p : places_) shown.push_back(p);
    points2_ = shown.table();
  }

  std::uint32_t index_of(VertexId v) const {
    return static_cast<std::uint32_t>(std::lower_bound(vertices_.begin(), vertices_.end(), v) -
                                      vertices_.begin());
  }

  /// Whether triangle t of the plane represents the whole plane.
  bool is_plane(std::uint32_t t) const {
    return state_.sources.is_plane(state_.sources[triangles_[t]]);
  }

  void add_segment(std::uint32_t from, std::uint32_t to, std::uint32_t owner, EdgeId edge) {
    segments_.push_back({from, to});
    owner_.push_back(owner);
    edge_.push_back(edge);
  }

  /// Lists the edges of facets and triangles, and the vertices inside of facets as segments of
  /// length zero. Owners are first the sides, and then the triangles.
  void collect_segments() {
    const SpaceComplex& c = state_.complex();
    for (std::uint32_t s = 0; s < side_count(); ++s) {
      for_each_use(c, sides_[s].facet, [&](UseId u) {
        add_segment(index_of(c.use_origin(u)), index_of(c.use_origin(c.use_next[u])), s,
                    SpaceComplex::edge_of(c.use_halfedge[u]));
      });
      for (const VertexId v : c.inner_of(sides_[s].facet)) {
        add_segment(index_of(v), index_of(v), kNone, {});
      }
    }
    const auto first = static_cast<std::uint32_t>(vertices_.size());
    for (std::uint32_t t = 0; t < triangles_.size(); ++t) {
      if (is_plane(t)) continue;
      for (std::uint32_t i = 0; i < 3; ++i) {
        add_segment(index_of_point_[first + 3 * t + i],
                    index_of_point_[first + 3 * t + (i + 1) % 3], side_count() + t, {});
      }
    }
  }

  /// Crosses an edge, and updates the owners that contain the face. If an owner's boundary uses the
  /// edge twice, the owner is on both sides.
  void cross(EdgeId e) {
    for (const SegmentId s : arrangement_->origins_of(e)) toggle(owner_[s.value()]);
  }
  void toggle(std::uint32_t owner) {
    if (owner < side_count()) return sides_here_.toggle(owner);
    const std::uint32_t t = owner - side_count();
    triangles_here_[state_.sources[triangles_[t]].is_opposite ? 1 : 0].toggle(t);
  }

  /// Finds the side and the triangle of each face. A walk goes from face 0, which only whole planes
  /// contain, to all faces and back. It maintains the sides and triangles that contain the current
  /// face. So the memory does not depend on how many triangles lie over each other.
  void label_faces() {
    const std::size_t faces = flat().face_count();
    MemoryCharge charge(state_.context);
    charge.add(sizeof(Step) * faces, "a walk over faces");
    side_.assign(faces, kNone);
    triangle_.assign(faces, kNone);
    sides_here_ = IndexSet(side_count());
    triangles_here_.fill(IndexSet(triangles_.size()));
    for (std::uint32_t t = 0; t < triangles_.size(); ++t) {
      if (is_plane(t)) toggle(side_count() + t);
    }
    std::vector<std::uint8_t> is_known(faces, 0);
    std::vector<Step> steps{{FaceId(0), {}, false}};
    is_known[0] = 1;
    while (!steps.empty()) {
      const Step step = steps.back();
      steps.pop_back();
      if (step.edge.is_valid()) cross(step.edge);
      if (step.is_return) continue;
      state_.context.checkpoint("lay facets over sources", 0, 0);
      choose_triangle(step.face);
      // The step back from this face is taken after the faces that are reached from it.
      steps.push_back({step.face, step.edge, true});
      add_steps(step.face, is_known, steps);
    }
  }

  /// A step of the walk: to a face across an edge, or back.
  struct Step {
    FaceId face;
    EdgeId edge;
    bool is_return;
  };

  /// Adds the steps from a face to the neighbours that have not been visited.
  void add_steps(FaceId f, std::vector<std::uint8_t>& is_known, std::vector<Step>& steps) const {
    if (!dcel().first_loop(f).is_valid()) return;
    for (const LoopId l : dcel().loops_of(f)) {
      if (!dcel().first(l).is_halfedge()) continue;
      for (const HalfedgeId h : dcel().along(l)) {
        const FaceId other = dcel().face(twin(h));
        if (is_known[other.value()] != 0) continue;
        is_known[other.value()] = 1;
        steps.push_back({other, edge_of(h), false});
      }
    }
  }

  bool is_same_side(std::uint32_t triangle, std::uint32_t side) const {
    return state_.sources[triangle].is_opposite == sides_[side].is_reversed;
  }

  /// Stores the side of a face and the first of its triangles. The triangles with the orientation
  /// of the side have precedence.
  void choose_triangle(FaceId f) {
    const std::uint32_t side = sides_here_.first();
    side_[f.value()] = side;
    if (side == kNone) return;
    const std::size_t same = sides_[side].is_reversed ? 1 : 0;
    std::uint32_t t = triangles_here_[same].first();
    if (t == kNone) t = triangles_here_[1 - same].first();
    if (t != kNone) triangle_[f.value()] = triangles_[t];
  }

  /// Returns the edge of a facet that contains an edge of the subdivision, or an invalid id.
  EdgeId facet_edge(EdgeId e) const {
    for (const SegmentId s : arrangement_->origins_of(e)) {
      if (edge_[s.value()].is_valid()) return edge_[s.value()];
    }
    return {};
  }

  bool can_join(std::uint32_t s, std::uint32_t t) const {
    if (s == t) return true;
    const PieceJoin join = state_.options.join;
    if (s == kNone || t == kNone || join == PieceJoin::None) return false;
    const SourceTriangle &a = state_.sources[s], &b = state_.sources[t];
    if (join == PieceJoin::SameFace && (a.source != b.source || a.face != b.face)) return false;
    return state_.sources.has_same_attributes(s, t);
  }

  /// Joins faces of a facet across edges at which the attributes do not change.
  void join_faces() {
    regions_.emplace(flat().face_count());
    for (std::size_t e = 0; e < flat().edge_count(); ++e) {
      facet_edge_.push_back(facet_edge(EdgeId(e)));
      const HalfedgeId h = first_half(EdgeId(e));
      const std::uint32_t a = dcel().face(h).value(), b = dcel().face(twin(h)).value();
      if (facet_edge_.back().is_valid() || side_[a] == kNone || side_[a] != side_[b]) continue;
      if (can_join(triangle_[a], triangle_[b])) regions_->unite(a, b);
    }
  }

  /// Finds the edges between different regions and along facets, and the vertices that are kept.
  void find_kept() {
    is_kept_.assign(flat().edge_count(), 0);
    ends_.assign(flat().vertex_count(), {});
    degree_.assign(flat().vertex_count(), 0);
    for (std::size_t e = 0; e < flat().edge_count(); ++e) {
      const HalfedgeId h = first_half(EdgeId(e));
      const std::uint32_t a = dcel().face(h).value(), b = dcel().face(twin(h)).value();
      if (side_[a] == kNone && side_[b] == kNone) continue;
      const bool is_border = facet_edge_[e].is_valid() || regions_->root(a) != regions_->root(b);
      if (!is_border) continue;
      is_kept_[e] = 1;
      for (const HalfedgeId out : {h, twin(h)}) {
        const std::size_t v = dcel().origin(out).value();
        if (degree_[v] < 2) ends_[v][degree_[v]] = out;
        ++degree_[v];
      }
    }
    is_dropped_.assign(flat().vertex_count(), 0);
    for (std::size_t v = 0; v < flat().vertex_count(); ++v) {
      is_dropped_[v] = !old_vertex(v).is_valid() && degree_[v] == 2 && is_straight(v) ? 1 : 0;
    }
  }

  /// Whether the two kept edges of a vertex lie on one line.
  bool is_straight(std::size_t v) const {
    const PlaneLine& line = flat().line[edge_of(ends_[v][0])];
    const std::uint32_t far = flat().vertex_point[dcel().target(ends_[v][1])];
    return orient2d(flat().points, line.a, line.b, far) == Sign::Zero;
  }

  /// Returns the vertex of the complex at a vertex of the subdivision, or an invalid id.
  VertexId old_vertex(std::size_t v) const {
    const std::uint32_t point = flat().vertex_point[VertexId(v)];
    return point < vertices_.size() ? vertices_[point] : VertexId();
  }

  /// Returns the place of a point of the subdivision in space.
  SpacePoint place_of(std::uint32_t point) {
    if (point < places_.size()) return places_[point];
    const RationalPoint2 at = exact(flat().points, point);
    const std::size_t x = view_.coordinate(0), y = view_.coordinate(1);
    const IntegerRow n = state_.tables().planes.coefficients(plane_);
    std::array<Rational, 3> p;
    p[x] = at.x;
    p[y] = at.y;
    p[view_.axis] =
        -(Rational(n[x]) * at.x + Rational(n[y]) * at.y + Rational(n[3])) / Rational(n[view_.axis]);
    return add_point(state_.growing.changed_tables(), {p[0], p[1], p[2]});
  }

  /// Returns the vertex at a vertex of the subdivision. If there is none, makes one.
  VertexId vertex_at(VertexId v) {
    VertexId& known = vertex_of_[v.value()];
    if (known.is_valid()) return known;
    known = old_vertex(v.value());
    if (known.is_valid()) return known;
    return known = state_.growing.add_vertex(place_of(flat().vertex_point[v]));
  }

  /// Returns the index of the region of a face.
  std::uint32_t region_of(std::uint32_t face) {
    const std::uint32_t root = regions_->root(face);
    std::uint32_t& known = region_index_[root];
    if (known != kNone) return known;
    const std::uint32_t side = side_[root], triangle = triangle_[root];
    const bool is_flipped = triangle != kNone && !is_same_side(triangle, side);
    known = static_cast<std::uint32_t>(state_.regions.size());
    const auto piece = static_cast<std::uint32_t>(state_.pieces.size());
    state_.pieces.push_back({sides_[side].facet, triangle, is_flipped, PieceCover::Triangle});
    state_.add_region(piece, sides_[side].is_reversed, plane_, {});
    return known;
  }

  void make_regions() {
    region_index_.assign(flat().face_count(), kNone);
    vertex_of_.assign(flat().vertex_count(), {});
    for (std::uint32_t f = 0; f < flat().face_count(); ++f) {
      if (side_[f] == kNone) continue;
      BoundaryPiece& piece = state_.pieces[state_.regions[region_of(f)].piece];
      if (piece.triangle == triangle_[f]) continue;
      piece.cover = PieceCover::Joined;
      piece.triangle = std::min(piece.triangle, triangle_[f]);
    }
    for (std::size_t h = 0; h < 2 * flat().edge_count(); ++h) add_region_edge(HalfedgeId(h));
    for (std::size_t v = 0; v < flat().vertex_count(); ++v) add_inner(VertexId(v));
  }

  /// Adds the edge that begins with a half-edge and ends at the next vertex that is kept.
  void add_region_edge(HalfedgeId h) {
    const std::uint32_t face = dcel().face(h).value();
    const VertexId from = dcel().origin(h);
    if (is_kept_[edge_of(h).value()] == 0 || side_[face] == kNone) return;
    if (is_dropped_[from.value()] != 0) return;
    const EdgeId edge = facet_edge_[edge_of(h).value()];
    VertexId to = dcel().target(h);
    while (is_dropped_[to.value()] != 0) {
      const auto& ends = ends_[to.value()];
      h = edge_of(ends[0]) == edge_of(h) ? ends[1] : ends[0];
      to = dcel().target(h);
    }
    const RegionEdge added{vertex_at(from), vertex_at(to), edge};
    state_.outline_of_region(region_of(face)).edges.push_back(added);
    if (!edge.is_valid()) return;
    for (const VertexId v : {from, to}) {
      if (!old_vertex(v.value()).is_valid()) state_.edge_cuts.add(edge, vertex_at(v));
    }
  }

  /// Adds a vertex of the complex to the region around it if no edge ends there.
  void add_inner(VertexId v) {
    if (degree_[v.value()] != 0 || !old_vertex(v.value()).is_valid()) return;
    const FaceId face = dcel().is_isolated(v) ? dcel().face(dcel().isolated_loop(v))
                                              : dcel().face(dcel().halfedge(v));
    if (side_[face.value()] == kNone) return;
    state_.outline_of_region(region_of(face.value())).inner.push_back(old_vertex(v.value()));
  }

  CutState& state_;
  PlaneId plane_;
  std::span<const FacetSide> sides_;
  TriangleRange triangles_;
  FlatView view_;

  std::vector<VertexId> vertices_;  // The vertices of the facets, ascending.
  std::vector<SpacePoint> places_;  // The different points. Those of the vertices come first.
  // For each vertex and each corner of a triangle, its index in places_.
  std::vector<std::uint32_t> index_of_point_;
  PointTable2 points2_;
  std::vector<SweepSegment> segments_;
  std::vector<std::uint32_t> owner_;  // For each segment, its side or triangle.
  std::vector<EdgeId> edge_;          // For each segment, its edge of the complex.
  std::optional<Arrangement> arrangement_;
  IndexSet sides_here_;  // The sides that contain the face of the walk.
  // The triangles that contain it, by SourceTriangle::is_opposite.
  std::array<IndexSet, 2> triangles_here_;
  // For each face of the arrangement: its side and its triangle.
  std::vector<std::uint32_t> side_;
  std::vector<std::uint32_t> triangle_;
  std::optional<UnionFind> regions_;
  std::vector<EdgeId> facet_edge_;     // For each edge of the arrangement.
  std::vector<std::uint8_t> is_kept_;  // For each edge of the arrangement.
  // For each vertex of the arrangement: its first kept half-edges, and how many there are.
  std::vector<std::array<HalfedgeId, 2>> ends_;
  std::vector<std::uint32_t> degree_;
  std::vector<std::uint8_t> is_dropped_;
  std::vector<VertexId> vertex_of_;
  std::vector<std::uint32_t> region_index_;
};

// ---------------------------------------------------------------- all planes

/// Whether a point is known to be a corner of a triangle without arithmetic.
bool is_known_corner(const CutState& state, const SourceTriangle& triangle,
                     const CornerPoints& corners, SpacePoint p) {
  if (p.is_input()) {
    const std::array<InputPointId, 3>& input = triangle.input;
    if (std::find(input.begin(), input.end(), p.input()) != input.end()) return true;
    return corner_index(corners, state.tables().planes.point(p.input())) < 3;
  }
  std::size_t i = 0;
  while (i < 3 && !state.sources.has_definition_of(triangle, i, p)) ++i;
  return i < 3;
}

/// Whether all vertices of a facet are input points that are known as corners of a triangle.
bool has_only_corners(const SpaceComplex& c, FacetId f, const SourceTriangle& triangle) {
  bool is_corner = true;
  for_each_use(c, f, [&](UseId u) {
    const SpacePoint p = c.vertex_point[c.use_origin(u)];
    is_corner = is_corner && p.is_input() &&
                (p.input() == triangle.input[0] || p.input() == triangle.input[1] ||
                 p.input() == triangle.input[2]);
  });
  return is_corner;
}

/// Whether all vertices of a facet lie in a triangle of its plane. Vertices that are corners of the
/// triangle need no arithmetic; in general position most vertices are.
bool is_in_triangle(CutState& state, FacetId f, const SourceTriangle& triangle) {
  if (has_only_corners(state.complex(), f, triangle)) return true;
  state.sources.place_if_moved(triangle);
  const SpaceComplex& c = state.complex();
  const CornerPoints corners = state.sources.corner_points(triangle);
  // The points, and the edges that contain them.
  std::vector<std::pair<SpacePoint, std::size_t>> others;
  for_each_use(c, f, [&](UseId u) {
    const SpacePoint p = c.vertex_point[c.use_origin(u)];
    if (is_known_corner(state, triangle, corners, p)) return;
    others.emplace_back(p, state.sources.edge_of(triangle, corners, p));
  });
  if (others.empty()) return true;
  std::array<SpacePoint, 3> places{};
  for (std::size_t i = 0; i < 3; ++i) places[i] = state.sources.place(triangle, i);
  FlatPoints shown(state.tables().points);
  shown.reset(FlatView::of_plane(state.tables().planes, triangle.plane));
  for (const SpacePoint p : places) shown.push_back(p);
  const Sign turn = shown.orient(0, 1, 2);
  for (const auto& [p, edge] : others) {
    const std::uint32_t v = shown.size();
    shown.push_back(p);
    for (std::uint32_t i = 0; i < 3; ++i) {
      if (i != edge && shown.orient(i, (i + 1) % 3, v) == -turn) return false;
    }
  }
  return true;
}

/// Returns the uses of a facet if it has only one cycle, with at most `most` uses, and no vertices
/// inside; otherwise nothing.
std::vector<UseId> short_cycle(const SpaceComplex& c, FacetId f, std::size_t most) {
  if (c.cycles_of(f).size() != 1 || !c.inner_of(f).empty()) return {};
  std::vector<UseId> uses;
  const UseId first = c.cycles_of(f)[0];
  UseId u = first;
  do {
    if (uses.size() == most) return {};
    uses.push_back(u);
    u = c.use_next[u];
  } while (u != first);
  return uses;
}

/// If the facet is exactly a face of a source and its corners are doubles, returns the use of the
/// facet at each corner of the face; otherwise nothing.
std::vector<UseId> uses_at_corners(CutState& state, FacetId f, const SourceTriangle& t) {
  const SpaceComplex& c = state.complex();
  const auto corners = state.sources.mesh_of(t).face(t.face);
  const std::size_t n = corners.size();
  std::vector<UseId> uses = short_cycle(c, f, n);
  if (uses.size() != n) return {};
  const auto is_at = [&](UseId u, std::uint32_t point) {
    const SpacePoint p = c.vertex_point[c.use_origin(u)];
    const Point3* const at = state.sources.doubles(t.source, point);
    return p.is_input() && at != nullptr && state.tables().planes.point(p.input()) == *at;
  };
  std::size_t first = 0;
  while (first < n && !is_at(uses[first], corners[0])) ++first;
  if (first == n) return {};
  std::rotate(uses.begin(), uses.begin() + static_cast<std::ptrdiff_t>(first), uses.end());
  if (!is_at(uses[1], corners[1])) std::reverse(uses.begin() + 1, uses.end());
  for (std::size_t i = 0; i < n; ++i) {
    if (!is_at(uses[i], corners[i])) return {};
  }
  return uses;
}

/// Whether all triangles come from one face of a source.
bool are_of_one_face(const SourceTriangles& sources, TriangleRange triangles) {
  const SourceTriangle& first = sources[triangles.first];
  for (std::uint32_t t = triangles.first; t != triangles.end; ++t) {
    if (sources[t].source != first.source || sources[t].face != first.face) return false;
  }
  return true;
}

bool has_channels(const CutState& state, const SourceTriangle& t) {
  return !state.sources.sources()[t.source].source->attributes.channels.empty();
}

std::uint32_t add_piece(CutState& state, const FacetSide& side, std::uint32_t triangle) {
  const bool is_flipped =
      triangle != kNone && state.sources[triangle].is_opposite != side.is_reversed;
  state.pieces.push_back({side.facet, triangle, is_flipped, PieceCover::Triangle});
  return static_cast<std::uint32_t>(state.pieces.size() - 1);
}

void add_whole(CutState& state, const FacetSide& side, std::uint32_t triangle) {
  const std::uint32_t piece = add_piece(state, side, triangle);
  state.regions.push_back(
      {piece, side.is_reversed, state.complex().facet_plane[side.facet], kNone});
}

/// Adds the triangles of a face of a source as regions of a facet that is this face. `uses` are
/// those of uses_at_corners().
void add_triangles_of_face(CutState& state, const FacetSide& side, std::span<const UseId> uses,
                           TriangleRange triangles) {
  const SpaceComplex& c = state.complex();
  const PlaneId plane = c.facet_plane[side.facet];
  for (std::uint32_t t = triangles.first; t != triangles.end; ++t) {
    const SourceTriangle& triangle = state.sources[t];
    const std::uint32_t begin = state.sources.mesh_of(triangle).face_begin[triangle.face];
    std::array<UseId, 3> at{};
    for (std::size_t i = 0; i < 3; ++i) at[i] = uses[triangle.corner[i] - begin];
    // The corners are counter-clockwise seen from outside of the set that the source bounds.
    const bool runs_along = c.use_next[uses[0]] == uses[1];
    if (!runs_along) std::swap(at[1], at[2]);
    std::vector<RegionEdge> edges;
    for (std::size_t i = 0; i < 3; ++i) {
      const UseId from = at[i], to = at[(i + 1) % 3];
      const bool is_side = c.use_next[from] == to;
      edges.push_back({c.use_origin(from), c.use_origin(to),
                       is_side ? SpaceComplex::edge_of(c.use_halfedge[from]) : EdgeId()});
    }
    const std::uint32_t piece = add_piece(state, side, t);
    state.add_region(piece, side.is_reversed, plane, {std::move(edges), {}});
  }
}

/// Adds the regions of a facet that is exactly one polygon of a source, whose triangles are given.
/// Returns false for any other facet.
bool add_untouched(CutState& state, const FacetSide& side, TriangleRange triangles) {
  const SourceTriangle& first = state.sources[triangles.first];
  if (state.sources.is_plane(first) || !are_of_one_face(state.sources, triangles)) return false;
  const std::vector<UseId> uses = uses_at_corners(state, side.facet, first);
  if (uses.empty()) return false;
  const bool is_joined = state.options.join != PieceJoin::None;
  const bool stays_polygon = state.options.faces != MeshFaces::Triangles && is_joined;
  if ((has_channels(state, first) || !is_joined) && !stays_polygon) {
    add_triangles_of_face(state, side, uses, triangles);
    return true;
  }
  add_whole(state, side, triangles.first);
  state.pieces.back().cover = PieceCover::Face;
  return true;
}

/// Adds the region of a facet if it needs no overlay: if its plane has no source triangle, or one
/// that contains the facet, or if the facet is a face of a source. Otherwise returns false.
bool add_without_overlay(CutState& state, const FacetSide& side) {
  const TriangleRange near = state.sources.in_plane(state.complex().facet_plane[side.facet]);
  if (near.is_empty()) {
    add_whole(state, side, kNone);
    return true;
  }
  if (near.size() > 1) return add_untouched(state, side, near);
  const SourceTriangle& only = state.sources[near.first];
  if (!state.sources.is_plane(only) && !is_in_triangle(state, side.facet, only)) return false;
  add_whole(state, side, near.first);
  return true;
}

/// Returns the outline of a whole facet that gets vertices inside its edges.
Outline outline_of_facet(const SpaceComplex& c, FacetId f) {
  Outline outline;
  for_each_use(c, f, [&](UseId u) {
    outline.edges.push_back(
        {c.use_origin(u), c.use_origin(c.use_next[u]), SpaceComplex::edge_of(c.use_halfedge[u])});
  });
  const auto inner = c.inner_of(f);
  outline.inner.assign(inner.begin(), inner.end());
  return outline;
}

/// Cuts all facets with more than one source, plane by plane.
void cut_planes(CutState& state, std::vector<FacetSide> sides) {
  const auto plane_of = [&](const FacetSide& s) { return state.complex().facet_plane[s.facet]; };
  std::sort(sides.begin(), sides.end(), [&](const FacetSide& a, const FacetSide& b) {
    return std::pair(plane_of(a), a.facet) < std::pair(plane_of(b), b.facet);
  });
  for (std::size_t first = 0; first < sides.size();) {
    std::size_t last = first;
    while (last < sides.size() && plane_of(sides[last]) == plane_of(sides[first])) ++last;
    state.context.checkpoint("lay facets over sources", first, sides.size());
    PlaneCutter(state, plane_of(sides[first]), std::span(sides).subspan(first, last - first)).run();
    first = last;
  }
}

/// Makes faces of regions.
class RegionFaces {
 public:
  RegionFaces(const CutState& state, CutBoundary& result)
      : complex_(state.complex()),
        cuts_(state.edge_cuts),
        faces_(state.options.faces),
        shown_(state.tables().points),
        of_facet_(state.complex()),
        result_(result) {}

  /// Adds the faces of a region that has an outline.
  void add(const Region& region, const Outline& outline) {
    chains_.clear();
    for (const RegionEdge& e : outline.edges) add_chain(e);
    if (chains_.size() == 3 && outline.inner.empty()) {
      cycle_ = {chains_[0].first, chains_[1].first, chains_[2].first};
      if (chains_[0].second != cycle_[1]) std::swap(cycle_[1], cycle_[2]);
      return add_face(region, cycle_);
    }
    if (outline.inner.empty() && is_cycle() && may_be_polygon()) return add_face(region, cycle_);
    triangulate_region(region, outline.inner);
  }

  /// Adds the faces of a region that is a whole facet and has no vertices inside its edges.
  void add_facet(const Region& region, FacetId f) {
    if (complex_.cycles_of(f).size() == 1 && complex_.inner_of(f).empty()) {
      cycle_.clear();
      for_each_use(complex_, f, [&](UseId u) { cycle_.push_back(complex_.use_origin(u)); });
      if (cycle_.size() == 3 || (may_be_polygon() && !has_repeats())) {
        return add_face(region, cycle_);
      }
    }
    of_facet_.for_each(f, [&](VertexId a, VertexId b, VertexId c) {
      add_face(region, std::array{a, b, c});
    });
  }

 private:
  void add_face(const Region& region, std::span<const VertexId> cycle) {
    auto& corners = result_.corners;
    corners.insert(corners.end(), cycle.begin(), cycle.end());
    if (region.is_reversed) {
      // The first corner remains the first.
      std::reverse(corners.end() - static_cast<std::ptrdiff_t>(cycle.size()) + 1, corners.end());
    }
    result_.face_begin.push_back(static_cast<std::uint32_t>(corners.size()));
    result_.piece.push_back(region.piece);
  }

  /// Whether the options allow cycle_ as a face.
  bool may_be_polygon() const {
    if (faces_ != MeshFaces::PlanarPolygons) return faces_ == MeshFaces::Polygons;
    return std::all_of(cycle_.begin(), cycle_.end(), [&](VertexId v) {
      return rounded(complex_.points(), complex_.vertex_point[v]).is_exact;
    });
  }
  bool has_repeats() {
    vertices_ = cycle_;
    std::sort(vertices_.begin(), vertices_.end());
    return std::adjacent_find(vertices_.begin(), vertices_.end()) != vertices_.end();
  }

  /// Sets cycle_ to the vertices along chains_. Returns false if they do not form a single cycle
  /// that visits no vertex twice.
  bool is_cycle() {
    std::sort(chains_.begin(), chains_.end());
    const auto next = [&](VertexId v) {
      return std::partition_point(chains_.begin(), chains_.end(),
                                  [v](const auto& e) { return e.first < v; });
    };
    const auto is_same_start = [](const auto& e, const auto& f) { return e.first == f.first; };
    if (std::adjacent_find(chains_.begin(), chains_.end(), is_same_start) != chains_.end()) {
      return false;
    }
    cycle_.clear();
    VertexId v = chains_.front().first;
    do {
      cycle_.push_back(v);
      const auto at = next(v);
      PLUMB_CHECK(at != chains_.end() && at->first == v);
      v = at->second;
    } while (v != cycle_.front());
    return cycle_.size() == chains_.size();
  }

  void triangulate_region(const Region& region, std::span<const VertexId> inner) {
    list_vertices(inner);
    shown_.reset(FlatView::of_plane(complex_.planes(), region.plane));
    for (const VertexId v : vertices_) shown_.push_back(complex_.vertex_point[v]);
    std::vector<IndexEdge> edges;
    for (const auto& [v, w] : chains_) edges.push_back({index_of(v), index_of(w)});
    std::vector<IndexTriangle> triangles;
    PLUMB_CHECK(triangulate(shown_, edges, triangles));
    for (const IndexTriangle& t : triangles) {
      add_face(region, std::array{vertices_[t[0]], vertices_[t[1]], vertices_[t[2]]});
    }
  }
  void add_chain(const RegionEdge& e) {
    const RegionEdge part{cuts_.merged(e.from), cuts_.merged(e.to), e.edge};
    chain_.assign(1, part.from);
    if (part.edge.is_valid()) cuts_.append_between(part, chain_);
    chain_.push_back(part.to);
    for (std::size_t i = 0; i + 1 < chain_.size(); ++i) {
      chains_.emplace_back(chain_[i], chain_[i + 1]);
    }
  }
  void list_vertices(std::span<const VertexId> inner) {
    vertices_.assign(inner.begin(), inner.end());
    for (const auto& [v, w] : chains_) {
      vertices_.push_back(v);
      vertices_.push_back(w);
    }
    std::sort(vertices_.begin(), vertices_.end());
    vertices_.erase(std::unique(vertices_.begin(), vertices_.end()), vertices_.end());
  }
  std::uint32_t index_of(VertexId v) const {
    return static_cast<std::uint32_t>(std::lower_bound(vertices_.begin(), vertices_.end(), v) -
                                      vertices_.begin());
  }

  const SpaceComplex& complex_;
  const EdgeCuts& cuts_;
  MeshFaces faces_;
  FlatPoints shown_;
  FacetTriangles of_facet_;
  CutBoundary& result_;
  std::vector<std::pair<VertexId, VertexId>> chains_;  // The edges of the region.
  std::vector<VertexId> chain_;
  std::vector<VertexId> cycle_;
  std::vector<VertexId> vertices_;
};

/// Whether a facet has an edge with vertices inside.
bool has_cut_edge(const CutState& state, FacetId f) {
  if (state.edge_cuts.is_empty()) return false;
  bool has_cut = false;
  for_each_use(state.complex(), f, [&](UseId u) {
    const EdgeId e = SpaceComplex::edge_of(state.complex().use_halfedge[u]);
    has_cut = has_cut || state.edge_cuts.has(e);
  });
  return has_cut;
}

/// If a face of a source gets vertices inside of its edges and has channels, divides it into its
/// triangles, because a polygon with additional corners may be triangulated in another way.
bool add_triangles_of_cut_face(CutState& state, const Region& region) {
  const BoundaryPiece piece = state.pieces[region.piece];
  if (piece.cover != PieceCover::Face) return false;
  const SourceTriangle& first = state.sources[piece.triangle];
  if (!has_channels(state, first)) return false;
  const auto triangles = state.sources.in_plane(region.plane);
  const std::vector<UseId> uses = uses_at_corners(state, piece.facet, first);
  add_triangles_of_face(state, {piece.facet, region.is_reversed}, uses, triangles);
  return true;
}

/// Makes the faces of all regions.
CutBoundary faces_of_regions(CutState& state) {
  CutBoundary result;
  result.corners.reserve(3 * state.regions.size());
  result.face_begin.reserve(state.regions.size() + 1);
  result.piece.reserve(state.regions.size());
  RegionFaces faces(state, result);
  for (std::size_t r = 0; r < state.regions.size(); ++r) {  // Regions may be added during the loop.
    const Region region = state.regions[r];
    const FacetId facet = state.pieces[region.piece].facet;
    if (region.outline != kNone) {
      faces.add(region, state.outlines[region.outline]);
    } else if (!has_cut_edge(state, facet)) {
      faces.add_facet(region, facet);
    } else if (!add_triangles_of_cut_face(state, region)) {
      faces.add(region, outline_of_facet(state.complex(), facet));
    }
  }
  result.pieces = std::move(state.pieces);
  return result;
}

}  // namespace

CutBoundary cut_boundary(GrowingComplex& complex, SourceTriangles& sources,
                         const AttributeOptions& options, Context& context) {
  CutState state{complex, sources, options, context, {}, {}, {}, EdgeCuts(complex)};
  const std::vector<FacetSide> sides = boundary_sides(complex.get());
  state.pieces.reserve(sides.size());
  state.regions.reserve(sides.size());
  std::vector<FacetSide> to_cut;
  for (std::size_t i = 0; i < sides.size(); ++i) {
    if (i % 4096 == 0) context.checkpoint("find sources of facets", i, sides.size());
    if (!add_without_overlay(state, sides[i])) to_cut.push_back(sides[i]);
  }
  cut_planes(state, std::move(to_cut));
  state.edge_cuts.sort();
  return faces_of_regions(state);
}

}  // namespace plumb
