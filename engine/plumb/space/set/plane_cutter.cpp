// Cuts the facets of one plane along the source triangles of this plane.
//
// One sweep (plane/arrangement.h) makes the subdivision by the edges of these facets and triangles.
// For each face of the subdivision, the facets and triangles that contain it are found. Across an
// edge, only those facets and triangles change whose boundaries contain the edge. Faces of one
// facet are joined to regions across edges at which the attributes do not change.
//
// Invariants: a vertex of the complex is never dropped; a vertex that cuts have made is dropped if
// joining has left a straight line there. So a facet whose pieces are all joined keeps its corners.
//
// Tested by tests/space/mesh_with_attributes_test.cpp.
#include "plumb/space/set/plane_cutter.h"

#include <algorithm>
#include <array>
#include <bit>
#include <optional>
#include <utility>
#include <vector>

#include "plumb/base/internal/union_find.h"
#include "plumb/plane/arrangement.h"
#include "plumb/predicates/plane/plane_points.h"
#include "plumb/predicates/point3_signs.h"
#include "plumb/space/planar/triangulate.h"

namespace plumb {
namespace {

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

}  // namespace

void cut_plane(CutState& state, PlaneId plane, std::span<const FacetSide> sides) {
  PlaneCutter(state, plane, sides).run();
}

}  // namespace plumb
