// A face of the plane by itself, to be cut up: half-edges without faces or labels (internal to
// plane_partition).
//
// The region lies to the left of the half-edges that have a next one; their twins outside have
// none. A corner is the wedge of the region from a half-edge h counter-clockwise to the one before
// it, and is named by h; an isolated vertex has one corner, all around. Boundary loops, at first
// outer ring, holes, slits and points, are in the end the pieces.
//
// Vertices of the face are input points, also where the set knows them as crossings; vertices that
// cuts make are crossings. Ends at infinity are vertices without a point, joined by frame edges
// without a line, as in PlaneComplex; a region without a boundary that leads there has a frame of
// one vertex and one edge.
#pragma once

#include <cstdint>
#include <vector>

#include "plumb/plane/plane_complex.h"

namespace plumb {

/// The phase of all checkpoints of convex partitions of the plane.
inline constexpr const char* kPartitionPhase = "convex partition";

/// A direction: of a line, from a to b unless back. Every line runs from its lesser point to the
/// greater.
struct Heading {
  PlaneLine line;
  bool back;
  Heading reversed() const { return {line, !back}; }
};

struct PlaneRegion {
  static constexpr std::uint32_t kAtInfinity = ~std::uint32_t{0};

  PlanePoints points;
  std::vector<std::uint32_t> vertex_point;  ///< dense index, or kAtInfinity
  std::vector<std::uint8_t> vertex_mark;    ///< does it belong to the set and to this region?
  std::vector<VertexId> origin;             ///< per half-edge; 2e runs along the line of e
  std::vector<HalfedgeId> next, prev;       ///< invalid: outside
  std::vector<PlaneLine> line;              ///< per edge
  std::vector<std::uint8_t> edge_mark, is_cut, is_frame;  ///< per edge
  std::vector<Corner> loops;  ///< a corner of each loop, as the face was
  /// Input points to the right of the isolated vertices, in the order of loops.
  std::uint32_t first_level_point = 0;

  // --- reading --------------------------------------------------------------------------------

  std::size_t vertex_count() const { return vertex_point.size(); }
  std::size_t halfedge_count() const { return origin.size(); }
  std::uint32_t point(VertexId v) const { return vertex_point[v.value()]; }
  bool is_at_infinity(VertexId v) const { return point(v) == kAtInfinity; }
  VertexId start(HalfedgeId h) const { return origin[h.value()]; }
  VertexId target(HalfedgeId h) const { return start(twin(h)); }
  HalfedgeId after(HalfedgeId h) const { return next[h.value()]; }
  HalfedgeId before(HalfedgeId h) const { return prev[h.value()]; }
  bool is_inside(HalfedgeId h) const { return after(h).is_valid(); }
  bool is_on_frame(HalfedgeId h) const { return is_frame[edge_of(h).value()] != 0; }
  bool is_bounded() const;

  Heading heading(HalfedgeId h) const { return {line[edge_of(h).value()], (h.value() & 1U) != 0}; }
  /// Positive: the second leads left of the first.
  Sign cross(Heading x, Heading y) const;
  /// Of headings with cross 0.
  static bool is_same_way(Heading x, Heading y) { return x.back == y.back; }
  /// Positive: the point lies left.
  Sign side(Heading x, std::uint32_t point) const;
  /// Positive: the point is ahead of the other. Requires a line that holds both.
  Sign ahead(Heading x, std::uint32_t point, std::uint32_t of) const;
  /// From one leaving half-edge counter-clockwise to another, of the same vertex: at most half a
  /// turn?
  bool is_convex_turn(HalfedgeId from, HalfedgeId to) const;
  /// More than half a turn? No corner at infinity is.
  bool is_reflex(HalfedgeId corner) const;
  /// Does the heading lead into the corner, along neither side?
  bool leads_into(HalfedgeId corner, Heading x) const;

  /// A line through two vertices of the face.
  Heading from_to(VertexId a, VertexId b) const;
  std::size_t count_loops() const;
  std::uint64_t count_reflex_corners() const;

  // --- cutting --------------------------------------------------------------------------------

  VertexId add_vertex(std::uint32_t at, bool mark);
  /// A new edge without links; returns the half-edge that runs along the heading.
  HalfedgeId new_edge(VertexId from, VertexId to, Heading along);
  /// A cut from one corner to another; returns the half-edge that leads there.
  HalfedgeId add_edge(Corner from, Corner to, Heading along);
  /// Puts a vertex on a half-edge; returns the half-edge that leads on from it.
  HalfedgeId split_edge(HalfedgeId h, VertexId at);
  /// Takes a cut away again.
  void remove_edge(HalfedgeId h);

  VertexId vertex_at(Corner c) const { return c.is_halfedge() ? start(c.halfedge()) : c.other(); }

 private:
  void link(HalfedgeId a, HalfedgeId b) {
    next[a.value()] = b;
    prev[b.value()] = a;
  }
};

/// Makes regions of the faces of one complex: O(size of the face) each.
class RegionMaker {
 public:
  explicit RegionMaker(const PlaneComplex& complex);

  PlaneRegion region(FaceId face);
  /// The marked face that a vertex goes to; invalid: none is at it.
  FaceId owner(VertexId v) const { return owner_[v.value()]; }

 private:
  VertexId vertex(VertexId v);
  EdgeId edge(EdgeId e);
  std::uint32_t input(std::uint32_t point);
  PlaneLine line(PlaneLine l) { return {input(l.a), input(l.b)}; }
  void add_loop(LoopId l);
  void add_frame();
  void forget();

  const PlaneComplex& c_;
  std::vector<FaceId> owner_;
  PlaneRegion region_;
  FaceId face_;
  // numbers in the region, and what has one
  std::vector<VertexId> vertex_;
  std::vector<EdgeId> edge_;
  std::vector<std::uint32_t> input_;
  std::vector<VertexId> vertices_;
  std::vector<EdgeId> edges_;
  std::vector<std::uint32_t> inputs_;
};

}  // namespace plumb
