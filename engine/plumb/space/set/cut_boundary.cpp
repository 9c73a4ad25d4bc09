// Lays facets over the source triangles of their planes, and cuts them where the source changes.
//
// A facet is whole if its plane has no source triangle, or one that contains all of its vertices.
// All other facets of a plane are cut together: one sweep (plane/arrangement.h) makes the
// subdivision by the edges of these facets and of the source triangles of the plane. Each face of
// the subdivision knows which facets and triangles contain it: crossing an edge, those change whose
// boundary has the edge. Faces of one facet are joined to regions across edges at which the
// attributes do not change.
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
#include <optional>
#include <span>
#include <utility>

#include "plumb/base/internal/union_find.h"
#include "plumb/plane/arrangement.h"
#include "plumb/predicates/plane/plane_points.h"
#include "plumb/predicates/point3_signs.h"
#include "plumb/space/planar/facet_triangles.h"
#include "plumb/space/planar/triangulate.h"
#include "plumb/space/to_mesh.h"

namespace plumb {
namespace {

/// An edge of the boundary of a region, with the region on its left, seen from the positive side.
struct RegionEdge {
  VertexId from;
  VertexId to;
  EdgeId edge;  // The edge of the complex that contains it; invalid for a cut.
};

/// A part of a facet that is triangulated by itself.
struct Region {
  std::uint32_t piece;
  bool is_reversed;  // Whether the outside is the negative side of the plane.
  PlaneId plane;
  std::vector<RegionEdge> edges;
  std::vector<VertexId> inner;  // Vertices inside.
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

/// Vertices that cuts have made inside edges of the complex.
class EdgeCuts {
 public:
  explicit EdgeCuts(const SpaceComplex& complex) : complex_(complex) {}

  void add(EdgeId e, VertexId v) { cuts_.emplace_back(e, v); }
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
  /// Returns the vertex with which a vertex was merged.
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
    return compare_xyz(complex_.points(), complex_.vertex_point[v], complex_.vertex_point[w]);
  }
  std::pair<std::vector<Cut>::const_iterator, std::vector<Cut>::const_iterator> of(EdgeId e) const {
    const auto first =
        std::partition_point(cuts_.begin(), cuts_.end(), [&](const Cut& c) { return c.first < e; });
    const auto last =
        std::partition_point(first, cuts_.end(), [&](const Cut& c) { return c.first == e; });
    return {first, last};
  }

  const SpaceComplex& complex_;
  std::vector<Cut> cuts_;
  std::vector<std::pair<VertexId, VertexId>> merged_;
};

// ---------------------------------------------------------------- one plane

/// What cutting the facets of a plane reads and changes.
struct CutState {
  SpaceComplex& complex;
  SpaceTables& tables;
  const SourceTriangles& sources;
  PieceJoin join;
  Context& context;
  std::vector<BoundaryPiece> pieces;
  std::vector<Region> regions;
  EdgeCuts edge_cuts;
};

/// Cuts the facets of one plane along the source triangles of this plane.
class PlaneCutter {
 public:
  PlaneCutter(CutState& state, PlaneId plane, std::span<const FacetSide> sides)
      : state_(state),
        plane_(plane),
        sides_(sides),
        triangles_(state.sources.in_plane(plane)),
        view_(FlatView::of_plane(state.tables.planes, plane)) {}

  void run() {
    collect_points();
    collect_segments();
    arrangement_ = arrange(std::move(points2_), segments_, state_.context);
    // All points are ends of segments, so the subdivision has kept their indices.
    PLUMB_CHECK(flat().points.inputs.size() == places_.size());
    label_faces();
    choose_triangles();
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
    const SpaceComplex& c = state_.complex;
    for (const FacetSide& side : sides_) {
      for_each_use(c, side.facet, [&](UseId u) { vertices_.push_back(c.use_origin(u)); });
      const auto inner = c.inner_of(side.facet);
      vertices_.insert(vertices_.end(), inner.begin(), inner.end());
    }
    std::sort(vertices_.begin(), vertices_.end());
    vertices_.erase(std::unique(vertices_.begin(), vertices_.end()), vertices_.end());
    for (const VertexId v : vertices_) places_.push_back(c.vertex_point[v]);
  }

  /// Lists the different points: the vertices, then corners of triangles at other places.
  void collect_points() {
    collect_vertices();
    std::vector<SpacePoint> all = places_;
    for (const std::uint32_t t : triangles_) {
      if (state_.sources.is_plane(state_.sources[t])) {
        all.insert(all.end(), 3, all.front());  // A plane has no corners.
        continue;
      }
      for (std::size_t i = 0; i < 3; ++i) all.push_back(state_.sources.place(state_.sources[t], i));
    }
    FlatPoints shown(state_.tables.points);
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
    // The first of equal points comes before the others, so its index is known by then.
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

  /// Whether triangle t of the plane stands for all of the plane.
  bool is_plane(std::uint32_t t) const {
    return state_.sources.is_plane(state_.sources[triangles_[t]]);
  }

  void add_segment(std::uint32_t from, std::uint32_t to, std::uint32_t owner, EdgeId edge) {
    segments_.push_back({from, to});
    owner_.push_back(owner);
    edge_.push_back(edge);
  }

  /// Lists the edges of facets and triangles, and the vertices inside facets as segments without
  /// length. Owners are sides first, then triangles.
  void collect_segments() {
    const SpaceComplex& c = state_.complex;
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

  /// Returns the label of the face behind an edge. An owner whose boundary runs along the edge
  /// twice is on both sides.
  std::vector<std::uint32_t> across(std::vector<std::uint32_t> label, EdgeId e) const {
    for (const SegmentId s : arrangement_->origins_of(e)) {
      const std::uint32_t owner = owner_[s.value()];
      const auto at = std::lower_bound(label.begin(), label.end(), owner);
      if (at != label.end() && *at == owner) {
        label.erase(at);
      } else {
        label.insert(at, owner);
      }
    }
    return label;
  }

  /// Finds the facets and triangles that contain each face, from face 0, which only whole planes
  /// contain.
  void label_faces() {
    MemoryCharge charge(state_.context);
    charge.add(sizeof(label_[0]) * flat().face_count(), "labels of faces");
    label_.assign(flat().face_count(), {});
    for (std::uint32_t t = 0; t < triangles_.size(); ++t) {
      if (is_plane(t)) label_[0].push_back(side_count() + t);
    }
    std::vector<std::uint8_t> is_known(label_.size(), 0);
    std::vector<FaceId> work{FaceId(0)};
    is_known[0] = 1;
    while (!work.empty()) {
      const FaceId f = work.back();
      work.pop_back();
      state_.context.checkpoint("lay facets over sources", 0, 0);
      if (!dcel().first_loop(f).is_valid()) continue;
      for (const LoopId l : dcel().loops_of(f)) {
        if (!dcel().first(l).is_halfedge()) continue;
        for (const HalfedgeId h : dcel().along(l)) {
          const FaceId other = dcel().face(twin(h));
          if (is_known[other.value()] != 0) continue;
          is_known[other.value()] = 1;
          label_[other.value()] = across(label_[f.value()], edge_of(h));
          charge.add(sizeof(std::uint32_t) * label_[other.value()].size(), "labels of faces");
          work.push_back(other);
        }
      }
    }
  }

  bool is_same_side(std::uint32_t triangle, std::uint32_t side) const {
    return state_.sources[triangle].is_opposite == sides_[side].is_reversed;
  }

  /// Finds the side of each face and the first of its triangles, those of the same side before the
  /// others.
  void choose_triangles() {
    side_.assign(label_.size(), kNone);
    triangle_.assign(label_.size(), kNone);
    for (std::size_t f = 0; f < label_.size(); ++f) {
      const auto& label = label_[f];
      if (label.empty() || label.front() >= side_count()) continue;
      side_[f] = label.front();
      for (std::size_t i = 1; i < label.size(); ++i) {
        const std::uint32_t t = triangles_[label[i] - side_count()];
        const bool is_better = triangle_[f] == kNone ||
                               (is_same_side(t, side_[f]) && !is_same_side(triangle_[f], side_[f]));
        if (is_better) triangle_[f] = t;
      }
    }
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
    if (s == kNone || t == kNone || state_.join == PieceJoin::None) return false;
    return state_.sources.has_same_attributes(s, t);
  }

  /// Joins faces of a facet at whose common edge the attributes do not change.
  void join_faces() {
    regions_.emplace(label_.size());
    for (std::size_t e = 0; e < flat().edge_count(); ++e) {
      facet_edge_.push_back(facet_edge(EdgeId(e)));
      const HalfedgeId h = first_half(EdgeId(e));
      const std::uint32_t a = dcel().face(h).value(), b = dcel().face(twin(h)).value();
      if (facet_edge_.back().is_valid() || side_[a] == kNone || side_[a] != side_[b]) continue;
      if (can_join(triangle_[a], triangle_[b])) regions_->unite(a, b);
    }
  }

  /// Finds the edges between different regions and along facets, and the vertices that stay.
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
    const IntegerRow n = state_.tables.planes.coefficients(plane_);
    std::array<Rational, 3> p;
    p[x] = at.x;
    p[y] = at.y;
    p[view_.axis] =
        -(Rational(n[x]) * at.x + Rational(n[y]) * at.y + Rational(n[3])) / Rational(n[view_.axis]);
    return add_point(state_.tables, {p[0], p[1], p[2]});
  }

  /// Returns the vertex at a vertex of the subdivision; makes one if there is none.
  VertexId vertex_at(VertexId v) {
    VertexId& known = vertex_of_[v.value()];
    if (known.is_valid()) return known;
    known = old_vertex(v.value());
    if (known.is_valid()) return known;
    known = VertexId(state_.complex.vertex_point.size());
    state_.complex.vertex_point.push_back(place_of(flat().vertex_point[v]));
    return known;
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
    state_.pieces.push_back({sides_[side].facet, triangle, is_flipped, false});
    state_.regions.push_back({piece, sides_[side].is_reversed, plane_, {}, {}});
    return known;
  }

  void make_regions() {
    region_index_.assign(label_.size(), kNone);
    vertex_of_.assign(flat().vertex_count(), {});
    for (std::uint32_t f = 0; f < label_.size(); ++f) {
      if (side_[f] == kNone) continue;
      BoundaryPiece& piece = state_.pieces[state_.regions[region_of(f)].piece];
      if (piece.triangle == triangle_[f]) continue;
      piece.is_joined = true;
      piece.triangle = std::min(piece.triangle, triangle_[f]);
    }
    for (std::size_t h = 0; h < 2 * flat().edge_count(); ++h) add_region_edge(HalfedgeId(h));
    for (std::size_t v = 0; v < flat().vertex_count(); ++v) add_inner(VertexId(v));
  }

  /// Adds the edge that begins with a half-edge and ends at the next vertex that stays.
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
    state_.regions[region_of(face)].edges.push_back({vertex_at(from), vertex_at(to), edge});
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
    state_.regions[region_of(face.value())].inner.push_back(old_vertex(v.value()));
  }

  CutState& state_;
  PlaneId plane_;
  std::span<const FacetSide> sides_;
  std::span<const std::uint32_t> triangles_;
  FlatView view_;

  std::vector<VertexId> vertices_;  // The vertices of the facets, ascending.
  std::vector<SpacePoint> places_;  // The different points, those of the vertices first.
  // For each vertex and each corner of a triangle, its index in places_.
  std::vector<std::uint32_t> index_of_point_;
  PointTable2 points2_;
  std::vector<SweepSegment> segments_;
  std::vector<std::uint32_t> owner_;  // For each segment, its side or triangle.
  std::vector<EdgeId> edge_;          // For each segment, its edge of the complex.
  std::optional<Arrangement> arrangement_;
  // For each face of the arrangement: what contains it, its side and its triangle.
  std::vector<std::vector<std::uint32_t>> label_;
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

/// Whether two input points have the same coordinates.
bool is_same_input(const PlaneTable& planes, SpacePoint p, SpacePoint q) {
  return p.is_input() && q.is_input() && planes.point(p.input()) == planes.point(q.input());
}

/// Whether all vertices of a facet lie in a triangle of its plane. Vertices that are corners of the
/// triangle need no arithmetic; in general position most vertices are.
bool is_in_triangle(const CutState& state, FacetId f, const SourceTriangle& triangle) {
  const SpaceComplex& c = state.complex;
  std::array<SpacePoint, 3> corners;
  for (std::size_t i = 0; i < 3; ++i) corners[i] = state.sources.place(triangle, i);
  std::vector<SpacePoint> others;
  for_each_use(c, f, [&](UseId u) {
    const SpacePoint p = c.vertex_point[c.use_origin(u)];
    const bool is_corner = std::any_of(corners.begin(), corners.end(), [&](SpacePoint corner) {
      return is_same_input(state.tables.planes, p, corner);
    });
    if (!is_corner) others.push_back(p);
  });
  if (others.empty()) return true;
  FlatPoints shown(state.tables.points);
  shown.reset(FlatView::of_plane(state.tables.planes, triangle.plane));
  for (const SpacePoint p : corners) shown.push_back(p);
  const Sign turn = shown.orient(0, 1, 2);
  for (const SpacePoint p : others) {
    const std::uint32_t v = shown.size();
    shown.push_back(p);
    for (std::uint32_t i = 0; i < 3; ++i) {
      if (shown.orient(i, (i + 1) % 3, v) == -turn) return false;
    }
  }
  return true;
}

/// Whether a facet has one source; `triangle` is then its triangle or kNone.
bool is_whole(const CutState& state, FacetId f, std::uint32_t& triangle) {
  const auto near = state.sources.in_plane(state.complex.facet_plane[f]);
  triangle = near.empty() ? kNone : near.front();
  if (near.empty()) return true;
  const SourceTriangle& first = state.sources[triangle];
  return near.size() == 1 && (state.sources.is_plane(first) || is_in_triangle(state, f, first));
}

void add_whole(CutState& state, const FacetSide& side, std::uint32_t triangle) {
  const bool is_flipped =
      triangle != kNone && state.sources[triangle].is_opposite != side.is_reversed;
  const auto piece = static_cast<std::uint32_t>(state.pieces.size());
  state.pieces.push_back({side.facet, triangle, is_flipped, false});
  state.regions.push_back({piece, side.is_reversed, state.complex.facet_plane[side.facet], {}, {}});
}

/// Makes the region of a whole facet that gets vertices inside its edges.
void fill_whole(const SpaceComplex& c, FacetId f, Region& region) {
  for_each_use(c, f, [&](UseId u) {
    region.edges.push_back(
        {c.use_origin(u), c.use_origin(c.use_next[u]), SpaceComplex::edge_of(c.use_halfedge[u])});
  });
  const auto inner = c.inner_of(f);
  region.inner.assign(inner.begin(), inner.end());
}

/// Cuts all facets with more than one source, plane by plane.
void cut_planes(CutState& state, std::vector<FacetSide> sides) {
  const auto plane_of = [&](const FacetSide& s) { return state.complex.facet_plane[s.facet]; };
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

/// Triangulates regions.
class RegionTriangles {
 public:
  explicit RegionTriangles(const CutState& state)
      : complex_(state.complex), cuts_(state.edge_cuts), shown_(state.tables.points) {}

  /// Calls visit(a, b, c) for each triangle, counter-clockwise seen from the positive side.
  template <class Visit>
  void for_each(const Region& region, const Visit& visit) {
    chains_.clear();
    for (const RegionEdge& e : region.edges) add_chain(e);
    list_vertices(region);
    shown_.reset(FlatView::of_plane(complex_.planes(), region.plane));
    for (const VertexId v : vertices_) shown_.push_back(complex_.vertex_point[v]);
    std::vector<IndexEdge> edges;
    for (const auto& [v, w] : chains_) edges.push_back({index_of(v), index_of(w)});
    std::vector<IndexTriangle> triangles;
    PLUMB_CHECK(triangulate(shown_, edges, triangles));
    for (const IndexTriangle& t : triangles) {
      visit(vertices_[t[0]], vertices_[t[1]], vertices_[t[2]]);
    }
  }

 private:
  void add_chain(const RegionEdge& e) {
    const RegionEdge part{cuts_.merged(e.from), cuts_.merged(e.to), e.edge};
    std::vector<VertexId> chain{part.from};
    if (part.edge.is_valid()) cuts_.append_between(part, chain);
    chain.push_back(part.to);
    for (std::size_t i = 0; i + 1 < chain.size(); ++i) chains_.emplace_back(chain[i], chain[i + 1]);
  }
  void list_vertices(const Region& region) {
    vertices_ = region.inner;
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
  FlatPoints shown_;
  std::vector<std::pair<VertexId, VertexId>> chains_;
  std::vector<VertexId> vertices_;
};

/// Whether a facet has an edge with vertices inside.
bool has_cut_edge(const CutState& state, FacetId f) {
  bool has_cut = false;
  for_each_use(state.complex, f, [&](UseId u) {
    const EdgeId e = SpaceComplex::edge_of(state.complex.use_halfedge[u]);
    has_cut = has_cut || state.edge_cuts.has(e);
  });
  return has_cut;
}

/// Triangulates all regions.
CutBoundary triangulated_regions(CutState& state) {
  CutBoundary result;
  FacetTriangles of_facet(state.complex);
  RegionTriangles of_region(state);
  for (Region& region : state.regions) {
    const FacetId facet = state.pieces[region.piece].facet;
    const auto add = [&](VertexId a, VertexId b, VertexId c) {
      if (region.is_reversed) std::swap(b, c);
      result.triangles.push_back({a, b, c});
      result.piece.push_back(region.piece);
    };
    if (region.edges.empty() && !has_cut_edge(state, facet)) {
      of_facet.for_each(facet, add);
      continue;
    }
    if (region.edges.empty()) fill_whole(state.complex, facet, region);
    of_region.for_each(region, add);
  }
  result.pieces = std::move(state.pieces);
  return result;
}

}  // namespace

CutBoundary cut_boundary(SpaceComplex& complex, SpaceTables& tables, const SourceTriangles& sources,
                         PieceJoin join, Context& context) {
  CutState state{complex, tables, sources, join, context, {}, {}, EdgeCuts(complex)};
  std::vector<FacetSide> to_cut;
  for (const FacetSide& side : boundary_sides(complex)) {
    std::uint32_t triangle = kNone;
    if (is_whole(state, side.facet, triangle)) {
      add_whole(state, side, triangle);
    } else {
      to_cut.push_back(side);
    }
  }
  cut_planes(state, std::move(to_cut));
  state.edge_cuts.sort();
  return triangulated_regions(state);
}

}  // namespace plumb
