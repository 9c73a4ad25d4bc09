// Randomized incremental intersection of half-spaces. For each half-space that has not been
// inserted yet, one conflict is stored.
//
// Invariant: after each insertion the polytope is the intersection of the cube and the half-spaces
// inserted, each vertex with at least three edges, each facet a convex polygon; and for every later
// half-space that cuts off a part, one vertex of this part is stored. The part that a half-space
// cuts off a convex polytope is connected, so a search from this vertex finds the whole part. If
// another half-space removes this whole part, the part that the first half-space cuts off the rest
// reaches the new facet.
//
// The order is a pseudorandom permutation with a fixed seed: results are reproducible, and the
// expected cost holds for all inputs that were not made to defeat this order. No plane is added;
// new vertices are common points of three planes. An open half-space that only touches is
// remembered, because it takes away the points that it touches. Removed half-edges and vertices
// stay in the arrays, marked by kNone.
//
// Tested by tests/space/half_space_hull_test.cpp.

#include "plumb/space/set/half_space_hull.h"

#include <algorithm>
#include <array>
#include <memory>
#include <numeric>
#include <utility>

#include "plumb/predicates/error.h"
#include "plumb/predicates/point3_signs.h"
#include "plumb/space/complex/tidy_tables.h"

namespace plumb {

std::vector<std::uint8_t> HullPolytope::facets_left(std::size_t bounds) const {
  std::vector<std::uint8_t> is_left(bounds, 0);
  for (const Halfedge& h : halfedge) {
    if (h.facet != kNone) is_left[h.facet] = 1;
  }
  return is_left;
}

namespace {

/// Makes a complex of the polytope: half-edges become edge uses (Weiler), each edge has two.
class ComplexMaker {
 public:
  ComplexMaker(const HullPolytope& polytope, std::span<const HullBound> bounds)
      : polytope_(polytope), bounds_(bounds) {}

  SpaceComplex run(std::span<const std::uint32_t> touching, std::shared_ptr<SpaceTables> tables) {
    SpaceComplex c;
    c.tables = std::move(tables);
    number_items();
    fill_vertices(c);
    fill_edges(c);
    fill_facets(c);
    for (const std::uint32_t b : touching) clear_touched(bounds_[b].plane.plane(), c);
    c.volume_mark = {0, 1};
    return c;
  }

 private:
  const HullBound& bound_of(std::uint32_t h) const { return bounds_[polytope_.halfedge[h].facet]; }

  /// Numbers the elements that were not removed.
  void number_items() {
    std::uint32_t count = 0;
    vertex_number_.assign(polytope_.vertex.size(), kNone);
    for (std::size_t v = 0; v < polytope_.vertex.size(); ++v) {
      if (polytope_.vertex[v].half != kNone) vertex_number_[v] = count++;
    }
    count = 0;
    edge_number_.assign(polytope_.halfedge.size() / 2, kNone);
    for (std::size_t e = 0; e < edge_number_.size(); ++e) {
      if (polytope_.halfedge[2 * e].facet != kNone) edge_number_[e] = count++;
    }
    facet_number_.assign(bounds_.size(), kNone);
    std::uint32_t facets = 0;
    const std::vector<std::uint8_t> is_left = polytope_.facets_left(bounds_.size());
    for (std::size_t b = 0; b < bounds_.size(); ++b) {
      if (is_left[b] != 0) facet_number_[b] = facets++;
    }
  }

  /// Fills vertices and stars. A vertex belongs to the set if no facet at it is open.
  void fill_vertices(SpaceComplex& c) const {
    for (std::uint32_t v = 0; v < polytope_.vertex.size(); ++v) {
      if (vertex_number_[v] == kNone) continue;
      c.vertex_point.push_back(polytope_.vertex[v].point);
      c.star_begin.push_back(static_cast<std::uint32_t>(c.star.size()));
      bool is_closed = true;
      polytope_.for_each_leaving(v, [&](std::uint32_t h) {
        is_closed = is_closed && !bound_of(h).is_open;
        c.star.push_back(halfedge_of(h));
      });
      c.vertex_mark.push_back(is_closed ? 1 : 0);
    }
    c.star_begin.push_back(static_cast<std::uint32_t>(c.star.size()));
    c.vertex_volume.resize(c.vertex_count());
    c.vertex_facet.resize(c.vertex_count());
    for (std::size_t v = 0; v < c.vertex_count(); ++v) {
      std::sort(c.star.begin() + c.star_begin[v], c.star.begin() + c.star_begin[v + 1]);
    }
  }

  HalfedgeId halfedge_of(std::uint32_t h) const {
    return HalfedgeId(2 * edge_number_[h / 2] + h % 2);
  }
  /// Returns the use of a half-edge, which has the same number.
  UseId use_of(std::uint32_t h) const { return UseId(2 * edge_number_[h / 2] + h % 2); }

  /// Fills edges and uses. The edge is convex. Therefore a half-edge with its facet on the left has
  /// the direction of the cross product of the outward normals of this facet and of the facet on
  /// the right.
  void fill_edges(SpaceComplex& c) const {
    for (std::uint32_t e = 0; e < edge_number_.size(); ++e) {
      if (edge_number_[e] == kNone) continue;
      const HullBound &left = bound_of(2 * e), &right = bound_of(2 * e + 1);
      const bool is_turned = left.plane.is_opposite() != right.plane.is_opposite();
      const PlaneId p = left.plane.plane(), q = right.plane.plane();
      c.edge_planes.push_back(is_turned ? std::array{q, p} : std::array{p, q});
      c.edge_mark.push_back(left.is_open || right.is_open ? 0 : 1);
      c.edge_use.push_back(use_of(2 * e));
      for (const std::uint32_t h : {2 * e, 2 * e + 1}) {
        c.origin.emplace_back(vertex_number_[polytope_.halfedge[h].origin]);
        c.use_radial.push_back(use_of(HullPolytope::twin(h)));
        fill_use(h, c);
      }
    }
    c.edge_volume.resize(c.edge_count());
  }

  /// Fills a use. Uses have their direction as seen from the positive side of the canonical plane.
  /// If the inside is on this side, the direction is reversed.
  void fill_use(std::uint32_t h, SpaceComplex& c) const {
    const auto& half = polytope_.halfedge[h];
    const bool is_back = bound_of(h).plane.is_opposite();
    c.use_halfedge.push_back(halfedge_of(is_back ? HullPolytope::twin(h) : h));
    c.use_next.push_back(use_of(is_back ? half.prev : half.next));
    c.use_prev.push_back(use_of(is_back ? half.next : half.prev));
    c.use_facet.emplace_back(facet_number_[half.facet]);
  }

  /// Fills facets. Volume 1 is the inside. Each facet has one cycle, which starts at its least use.
  void fill_facets(SpaceComplex& c) const {
    for (std::size_t b = 0; b < bounds_.size(); ++b) {
      if (facet_number_[b] == kNone) continue;
      const bool is_opposite = bounds_[b].plane.is_opposite();
      c.facet_plane.push_back(bounds_[b].plane.plane());
      c.facet_mark.push_back(bounds_[b].is_open ? 0 : 1);
      c.facet_volume.push_back({VolumeId(is_opposite ? 1 : 0), VolumeId(is_opposite ? 0 : 1)});
      c.facet_origin.push_back(kNone);
    }
    c.cycle.resize(c.facet_count());
    for (std::size_t u = c.use_count(); u-- > 0;) c.cycle[c.use_facet[u].value()] = UseId(u);
    c.cycle_begin.resize(c.facet_count() + 1);
    std::iota(c.cycle_begin.begin(), c.cycle_begin.end(), 0U);
    c.inner_begin.assign(c.facet_count() + 1, 0);
  }

  /// Clears the marks of the vertices and edges on a plane.
  void clear_touched(PlaneId plane, SpaceComplex& c) const {
    std::vector<std::uint8_t> is_on(c.vertex_count());
    for (std::size_t v = 0; v < c.vertex_count(); ++v) {
      is_on[v] = side(c.points(), c.vertex_point[v], plane) == Sign::Zero ? 1 : 0;
      if (is_on[v] != 0) c.vertex_mark[v] = 0;
    }
    for (std::size_t e = 0; e < c.edge_count(); ++e) {
      if (is_on[c.origin[2 * e].value()] != 0 && is_on[c.origin[2 * e + 1].value()] != 0) {
        c.edge_mark[e] = 0;
      }
    }
  }

  const HullPolytope& polytope_;
  std::span<const HullBound> bounds_;
  std::vector<std::uint32_t> vertex_number_, edge_number_, facet_number_;
};

}  // namespace

SpaceComplex complex_of_polytope(const HullPolytope& polytope, std::span<const HullBound> bounds,
                                 std::span<const std::uint32_t> touching,
                                 std::shared_ptr<SpaceTables> tables) {
  return with_used_tables(ComplexMaker(polytope, bounds).run(touching, std::move(tables)));
}

namespace {

constexpr std::uint32_t kPlanesPerCheckpoint = 1024;

/// Inserts all half-spaces.
class HullBuilder {
 public:
  template <class HalfSpaces>
  HullBuilder(const HalfSpaces& half_spaces, Context& context)
      : context_(context), tables_(std::make_shared<SpaceTables>()) {
    take_planes(half_spaces);
  }

  HalfSpaceHull run(std::size_t count) {
    HalfSpaceHull hull;
    hull.needed.resize(count);
    std::iota(hull.needed.begin(), hull.needed.end(), 0U);
    if (has_opposite_ || !insert_all()) return hull;
    hull.needed = needed();
    if (!is_unbounded())
      hull.polytope = complex_of_polytope(polytope_, bounds_, touching_, tables_);
    return hull;
  }

 private:
  /// The side of a vertex relative to the bound that is being inserted. It is valid if `stamp` is
  /// the stamp of this insertion.
  struct Seen {
    std::uint32_t stamp;
    Sign sign;
  };
  /// The half-edges of one facet. The half-edge `first` leads outside, and `last` leads back.
  struct Chain {
    std::uint32_t first;
    std::uint32_t last;
  };

  // ---------------------------------------------------------------- 1. planes

  /// Interns the planes of the cube and of all half-spaces. Two half-spaces on both sides of one
  /// plane leave no interior.
  template <class HalfSpaces>
  void take_planes(const HalfSpaces& half_spaces) {
    for (const PlaneId p : tables_->planes.intern_frame()) {
      const bool is_low = tables_->planes.source(p).frame_index() % 2 == 0;
      bounds_.push_back({{p, is_low}, false, kNone});
    }
    std::vector<std::uint32_t> known;  // The bound of each plane.
    for (std::uint32_t i = 0; i < half_spaces.size(); ++i) {
      if (i % kPlanesPerCheckpoint == 0) context_.checkpoint("planes", i, half_spaces.size());
      const HalfSpace3& half_space = half_spaces[i];
      const Plane3& plane = half_space.plane;
      const OrientedPlane p = tables_->planes.intern(plane.a, plane.b, plane.c, plane.d);
      if (!p.is_valid()) {
        throw Error(ErrorCode::BadArgument, "a plane needs a normal that is not zero");
      }
      const bool is_open = half_space.boundary == Boundary::Open;
      known.resize(std::max<std::size_t>(known.size(), p.plane().value() + 1), kNone);
      std::uint32_t& at = known[p.plane().value()];
      if (at == kNone) {
        at = static_cast<std::uint32_t>(bounds_.size());
        bounds_.push_back({p, is_open, i});
        continue;
      }
      HullBound& other = bounds_[at];
      has_opposite_ |= other.plane != p;
      if (is_open && !other.is_open) other = {p, true, i};
    }
  }

  // ---------------------------------------------------------------- 2. the cube

  /// Starts with the cube. Vertex c has bit k set if it is at +R along axis k.
  void make_cube() {
    const auto& frame = tables_->planes.frame();
    for (std::uint32_t c = 0; c < 8; ++c) {
      std::array<PlaneId, 3> p;
      for (std::size_t k = 0; k < 3; ++k) p[k] = frame[2 * k + (c >> k & 1U)];
      polytope_.add_vertex(tables_->points.add(p[0], p[1], p[2]), kNone);
    }
    using Quad = std::array<std::uint32_t, 4>;
    constexpr std::array<Quad, 6> kFaces{
        {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}}};
    std::array<std::array<std::uint32_t, 8>, 8> between{};
    for (auto& row : between) row.fill(kNone);
    for (std::uint32_t f = 0; f < 6; ++f) {
      std::array<std::uint32_t, 4> cycle{};
      for (std::size_t i = 0; i < 4; ++i) {
        const std::uint32_t a = kFaces[f][i], b = kFaces[f][(i + 1) % 4];
        std::uint32_t& h = between[a][b];
        if (h == kNone) {
          h = polytope_.add_edge(a, b, f);
          between[b][a] = HullPolytope::twin(h);
        }
        polytope_.halfedge[h].facet = f;
        polytope_.vertex[a].half = h;
        cycle[i] = h;
      }
      for (std::size_t i = 0; i < 4; ++i) polytope_.link(cycle[i], cycle[(i + 1) % 4]);
    }
    alive_ = 8;
  }

  // ---------------------------------------------------------------- 3. insertion

  /// Returns on which side of the bound a vertex lies: Positive is outside.
  Sign side_of(std::uint32_t v, const HullBound& b) const {
    return side(tables_->points, polytope_.vertex[v].point, b.plane.plane()) *
           b.plane.orientation();
  }
  /// Whether a vertex on this side is cut off or, if the bound is open, touched.
  static bool is_conflict(Sign s, const HullBound& b) {
    return s == Sign::Positive || (b.is_open && s == Sign::Zero);
  }

  /// Inserts all half-spaces. Returns false if nothing is left inside.
  bool insert_all() {
    make_cube();
    std::vector<std::uint32_t> order(bounds_.size() - 6);
    std::iota(order.begin(), order.end(), 6U);
    shuffle(order);
    conflict_.assign(8, kNone);
    conflict_of_.assign(bounds_.size(), kNone);
    next_conflict_.assign(bounds_.size(), kNone);
    is_to_come_.assign(bounds_.size(), 1);
    constexpr std::array<std::uint32_t, 8> kCorners{0, 1, 2, 3, 4, 5, 6, 7};
    for (const std::uint32_t b : order) give_conflict(b, kCorners);
    for (std::size_t i = 0; i < order.size(); ++i) {
      if (i % 1024 == 0) context_.checkpoint("half-spaces", i, order.size());
      is_to_come_[order[i]] = 0;
      if (conflict_of_[order[i]] != kNone && !insert(order[i])) return false;
    }
    return true;
  }

  /// Permutes by a fixed sequence of pseudorandom numbers (a linear congruential generator), which
  /// depends on the count only.
  static void shuffle(std::vector<std::uint32_t>& order) {
    std::uint64_t state = 0x9e3779b97f4a7c15U;
    for (std::size_t i = order.size(); i > 1; --i) {
      state = state * 6364136223846793005U + 1442695040888963407U;
      std::swap(order[i - 1], order[(state >> 33U) % i]);
    }
  }

  /// Finds the first of these vertices that a bound cuts off, and stores it as the conflict of the
  /// bound. Bounds with the same conflict are linked in a list.
  void give_conflict(std::uint32_t b, std::span<const std::uint32_t> vertices) {
    conflict_of_[b] = kNone;
    for (const std::uint32_t v : vertices) {
      if (!is_conflict(side_of(v, bounds_[b]), bounds_[b])) continue;
      conflict_of_[b] = v;
      next_conflict_[b] = conflict_[v];
      conflict_[v] = b;
      return;
    }
  }

  /// Inserts a bound. Returns false if no part is left inside.
  bool insert(std::uint32_t b) {
    const std::uint32_t start = conflict_of_[b];
    ++stamp_;
    find_outside(start, bounds_[b]);
    if (outside_.empty()) {
      touching_.push_back(b);
      return true;
    }
    if (outside_.size() + on_count_ == alive_) return false;
    find_chains();
    move_ends(b);
    rim_.clear();
    for (const Chain& chain : chains_) close_chain(chain);
    close_facet(b);
    drop_outside();
    return true;
  }

  /// Finds all vertices outside, and the signs of their neighbours. The search continues from
  /// vertices on the plane. Therefore, if an open bound only touches its conflict, the vertices
  /// outside are found from there.
  void find_outside(std::uint32_t start, const HullBound& bound) {
    outside_.clear();
    on_count_ = 0;
    seen_.resize(polytope_.vertex.size(), {0, Sign::Zero});
    queue_.assign(1, start);
    classify(start, bound);
    for (std::size_t i = 0; i < queue_.size(); ++i) {
      const std::uint32_t v = queue_[i];
      if (seen_[v].sign == Sign::Positive) outside_.push_back(v);
      polytope_.for_each_leaving(v, [&](std::uint32_t h) {
        const std::uint32_t w = polytope_.target(h);
        if (seen_[w].stamp == stamp_) return;
        if (classify(w, bound) != Sign::Negative) queue_.push_back(w);
      });
    }
  }
  /// Computes and stores the side of a vertex.
  Sign classify(std::uint32_t v, const HullBound& bound) {
    seen_[v] = {stamp_, side_of(v, bound)};
    on_count_ += seen_[v].sign == Sign::Zero ? 1 : 0;
    return seen_[v].sign;
  }
  /// Returns the side of a vertex that was classified.
  Sign seen_sign(std::uint32_t v) const { return seen_[v].sign; }

  /// Finds the chains of edges with ends outside, one in each facet that keeps a vertex: a convex
  /// polygon crosses a line twice at most.
  void find_chains() {
    chains_.clear();
    loose_.clear();
    for (const std::uint32_t v : outside_) {
      polytope_.for_each_leaving(v, [&](std::uint32_t h) {
        loose_.push_back(h);
        const std::uint32_t first = polytope_.halfedge[h].prev;
        if (seen_sign(polytope_.halfedge[first].origin) == Sign::Positive) return;
        std::uint32_t last = h;
        while (seen_sign(polytope_.target(last)) == Sign::Positive) {
          last = polytope_.halfedge[last].next;
        }
        chains_.push_back({first, last});
      });
    }
  }

  /// Shortens the edges that cross the bound, so that they end there. Removes the other edges with
  /// an end outside.
  void move_ends(std::uint32_t b) {
    auto& half = polytope_.halfedge;
    for (const std::uint32_t h : loose_) {
      const std::uint32_t twin = HullPolytope::twin(h);
      if (seen_sign(half[twin].origin) != Sign::Negative) {
        gone_.push_back(h);
        continue;
      }
      const SpacePoint point =
          tables_->points.add(bounds_[half[h].facet].plane.plane(),
                              bounds_[half[twin].facet].plane.plane(), bounds_[b].plane.plane());
      half[h].origin = polytope_.add_vertex(point, h);
    }
  }

  /// Replaces a chain by one edge along the bound. If a facet keeps only one vertex, the whole
  /// facet is removed. If it keeps one edge, this edge becomes an edge of the new facet.
  void close_chain(const Chain& chain) {
    auto& half = polytope_.halfedge;
    const std::uint32_t from = half[chain.first].origin, to = polytope_.target(chain.last);
    const bool is_from_on = seen_sign(from) == Sign::Zero, is_to_on = seen_sign(to) == Sign::Zero;
    const std::uint32_t before = is_from_on ? half[chain.first].prev : chain.first;
    const std::uint32_t after = is_to_on ? half[chain.last].next : chain.last;
    if (is_from_on && is_to_on && (from == to || before == after)) {
      if (from != to) rim_.push_back(before);
      keep_touching(half[chain.first].facet);
      return;
    }
    const std::uint32_t g =
        polytope_.add_edge(is_from_on ? from : polytope_.target(chain.first),
                           is_to_on ? to : half[chain.last].origin, half[before].facet);
    polytope_.link(before, g);
    polytope_.link(g, after);
    rim_.push_back(HullPolytope::twin(g));
  }

  /// Stores an open bound that has lost its facet, because it still removes the vertex or edge that
  /// it had there.
  void keep_touching(std::uint32_t b) {
    if (bounds_[b].is_open) touching_.push_back(b);
  }

  /// Links the half-edges of the rim to the boundary of the new facet. Each is followed by the
  /// half-edge that leaves its target.
  void close_facet(std::uint32_t b) {
    for (const std::uint32_t h : gone_) {
      polytope_.halfedge[h].facet = polytope_.halfedge[HullPolytope::twin(h)].facet = kNone;
    }
    gone_.clear();
    for (const std::uint32_t h : rim_) {
      polytope_.halfedge[h].facet = b;
      polytope_.vertex[polytope_.halfedge[h].origin].half = h;
    }
    for (const std::uint32_t h : rim_) {
      polytope_.link(h, polytope_.vertex[polytope_.target(h)].half);
    }
  }

  /// Removes the vertices outside. If one of them was the conflict of a later bound, another
  /// conflict is searched along the rim.
  void drop_outside() {
    rim_vertices_.clear();
    for (const std::uint32_t h : rim_) rim_vertices_.push_back(polytope_.halfedge[h].origin);
    alive_ += polytope_.vertex.size() - conflict_.size();
    alive_ -= outside_.size();
    conflict_.resize(polytope_.vertex.size(), kNone);
    for (const std::uint32_t v : outside_) {
      polytope_.vertex[v].half = kNone;
      std::uint32_t b = conflict_[v];
      while (b != kNone) {
        const std::uint32_t next = next_conflict_[b];
        if (conflict_of_[b] == v && is_to_come_[b] != 0) give_conflict(b, rim_vertices_);
        b = next;
      }
    }
  }

  /// Returns the half-spaces with a facet, and the open half-spaces that touch.
  std::vector<std::uint32_t> needed() const {
    const std::vector<std::uint8_t> is_left = polytope_.facets_left(bounds_.size());
    std::vector<std::uint32_t> result;
    for (std::size_t b = 6; b < bounds_.size(); ++b) {
      if (is_left[b] != 0) result.push_back(bounds_[b].index);
    }
    for (const std::uint32_t b : touching_) result.push_back(bounds_[b].index);
    std::sort(result.begin(), result.end());
    return result;
  }

  /// Whether a side of the cube is left.
  bool is_unbounded() const {
    return std::ranges::any_of(polytope_.halfedge, [](const auto& h) { return h.facet < 6; });
  }

  Context& context_;
  std::shared_ptr<SpaceTables> tables_;
  std::vector<HullBound> bounds_;  // The bounds of the cube come first.
  bool has_opposite_ = false;
  HullPolytope polytope_;
  std::size_t alive_ = 0;                 // The number of vertices that were not removed.
  std::vector<std::uint32_t> touching_;   // The open bounds that cut off no part.
  std::vector<std::uint8_t> is_to_come_;  // Whether each bound is still to be inserted.
  // For each bound that is still to be inserted, a vertex or kNone.
  std::vector<std::uint32_t> conflict_of_;
  // For each vertex, the first bound whose conflict it is.
  std::vector<std::uint32_t> conflict_;
  // For each bound, the next bound with the same conflict.
  std::vector<std::uint32_t> next_conflict_;
  // The following members belong to the bound that is being inserted.
  std::uint32_t stamp_ = 0;
  std::size_t on_count_ = 0;
  std::vector<Seen> seen_;  // One entry for each vertex.
  std::vector<std::uint32_t> queue_, outside_, loose_, gone_, rim_, rim_vertices_;
  std::vector<Chain> chains_;
};

}  // namespace

HalfSpaceHull hull_of_half_spaces(std::span<const HalfSpace3> half_spaces, Context& context) {
  return HullBuilder(half_spaces, context).run(half_spaces.size());
}

HalfSpaceHull hull_of_half_spaces(const HalfSpaceList& half_spaces, Context& context) {
  return HullBuilder(half_spaces, context).run(half_spaces.size());
}

}  // namespace plumb
