// A face of the plane on its own, to be cut: half-edges without faces or labels (internal to
// plane_partition).
//
// The region lies to the left of the half-edges that have a next one; their twins outside have
// none. A corner is the wedge of the region between a half-edge h and the previous half-edge,
// counter-clockwise from h. It is named by h; an isolated vertex has one corner, all around. The
// boundary loops are at first the outer ring, holes, slits and points, and at the end the convex
// parts.
//
// Vertices of the face are input points, even if the set knows them as crossings; vertices that
// cuts make are crossings. Ends at infinity are vertices without a point, joined by frame edges
// without a line, as in PlaneComplex. A region whose boundary does not reach infinity, but whose
// interior does, has a frame of one vertex and one edge.
#pragma once

#include <cstdint>
#include <vector>

#include "plumb/plane/plane_complex.h"

namespace plumb {

/// The phase of all checkpoints of convex partitions of the plane.
inline constexpr const char* kPartitionPhase = "convex partition";

/// A direction along a line: from a to b, or from b to a if `back`. Every line runs from its lesser
/// point to the greater.
struct Heading {
  PlaneLine line;
  bool back;
  Heading reversed() const { return {line, !back}; }
};

/// The region in flat arrays, and the operations that cut it.
struct PlaneRegion {
  static constexpr std::uint32_t kAtInfinity = ~std::uint32_t{0};

  PlanePoints points;
  /// Dense index of each vertex's point, or kAtInfinity.
  IdVector<VertexId, std::uint32_t> vertex_point;
  /// Whether each vertex belongs to the set and to this region.
  IdVector<VertexId, std::uint8_t> vertex_mark;
  /// Origin of each half-edge; 2e runs along the line of e.
  IdVector<HalfedgeId, VertexId> origin;
  /// Neighbours around a loop; invalid for half-edges outside.
  IdVector<HalfedgeId, HalfedgeId> next, prev;
  IdVector<EdgeId, PlaneLine> line;                            ///< Line of each edge.
  IdVector<EdgeId, std::uint8_t> edge_mark, is_cut, is_frame;  ///< Flags of each edge.
  std::vector<Corner> loops;  ///< A corner of each loop, as the face was before cuts.
  /// First of the input points that lie to the right of isolated vertices, in the order of loops.
  std::uint32_t first_level_point = 0;

  // --- reading --------------------------------------------------------------------------------

  std::size_t vertex_count() const { return vertex_point.size(); }
  std::size_t halfedge_count() const { return origin.size(); }
  std::uint32_t point(VertexId v) const { return vertex_point[v]; }
  bool is_at_infinity(VertexId v) const { return point(v) == kAtInfinity; }
  VertexId start(HalfedgeId h) const { return origin[h]; }
  VertexId target(HalfedgeId h) const { return start(twin(h)); }
  HalfedgeId after(HalfedgeId h) const { return next[h]; }
  HalfedgeId before(HalfedgeId h) const { return prev[h]; }
  bool is_inside(HalfedgeId h) const { return after(h).is_valid(); }
  bool is_on_frame(HalfedgeId h) const { return is_frame[edge_of(h)] != 0; }
  /// Whether no vertex is at infinity.
  bool is_bounded() const;

  Heading heading(HalfedgeId h) const { return {line[edge_of(h)], (h.value() & 1U) != 0}; }
  /// Returns Positive if the second heading leads left of the first.
  Sign cross(Heading x, Heading y) const;
  /// Whether two headings with cross() Zero lead the same way.
  static bool is_same_way(Heading x, Heading y) { return x.back == y.back; }
  /// Returns Positive if the point lies left of the heading's line.
  Sign side(Heading x, std::uint32_t point) const;
  /// Returns Positive if the point is ahead of the other. Requires a line that holds both.
  Sign ahead(Heading x, std::uint32_t point, std::uint32_t of) const;
  /// Whether the turn from one leaving half-edge counter-clockwise to another, of the same vertex,
  /// is at most half a turn.
  bool is_convex_turn(HalfedgeId from, HalfedgeId to) const;
  /// Whether the corner spans more than half a turn. No corner at infinity does.
  bool is_reflex(HalfedgeId corner) const;
  /// Whether the heading leads into the corner, along neither side.
  bool leads_into(HalfedgeId corner, Heading x) const;

  /// Returns the heading of the line from one vertex of the face to another.
  Heading from_to(VertexId a, VertexId b) const;
  std::size_t count_loops() const;
  std::uint64_t count_reflex_corners() const;

  // --- cutting --------------------------------------------------------------------------------

  VertexId add_vertex(std::uint32_t at, bool mark);
  /// Adds an edge without links and returns its half-edge that runs along the heading.
  HalfedgeId new_edge(VertexId from, VertexId to, Heading along);
  /// Adds a cut from one corner to another and returns the half-edge that leads there.
  HalfedgeId add_edge(Corner from, Corner to, Heading along);
  /// Puts a vertex on a half-edge and returns the half-edge that leads on from it.
  HalfedgeId split_edge(HalfedgeId h, VertexId at);
  /// Removes a cut again.
  void remove_edge(HalfedgeId h);

  VertexId vertex_at(Corner c) const { return c.is_halfedge() ? start(c.halfedge()) : c.other(); }

 private:
  void link(HalfedgeId a, HalfedgeId b) {
    next[a] = b;
    prev[b] = a;
  }
};

/// Makes regions of the faces of one complex, in O(size of the face) each.
class RegionMaker {
 public:
  explicit RegionMaker(const PlaneComplex& complex);

  /// Returns the region of a face.
  PlaneRegion region(FaceId face);
  /// Returns the marked face that a vertex goes to, the least one at it; an invalid id if there is
  /// none.
  FaceId owner(VertexId v) const { return owner_[v]; }

 private:
  VertexId vertex(VertexId v);
  EdgeId edge(EdgeId e);
  std::uint32_t input(std::uint32_t point);
  PlaneLine line(PlaneLine l) { return {input(l.a), input(l.b)}; }
  void add_loop(LoopId l);
  void add_frame();
  void forget();

  const PlaneComplex& c_;
  IdVector<VertexId, FaceId> owner_;
  PlaneRegion region_;
  FaceId face_;
  // Numbers in the current region, and the cells that have a number. forget() resets them.
  IdVector<VertexId, VertexId> vertex_;
  IdVector<EdgeId, EdgeId> edge_;
  std::vector<std::uint32_t> input_;
  std::vector<VertexId> vertices_;
  std::vector<EdgeId> edges_;
  std::vector<std::uint32_t> inputs_;
};

}  // namespace plumb
