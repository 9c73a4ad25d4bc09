// Which plane cuts a piece: candidates through its reflex edges, the best first.
//
// Main flow of CutChooser::candidates():
//  1. gather    the reflex edges of the piece, their ends in doubles
//  2. propose   for an edge: the planes of its faces; the planes through it and the end of another
//               reflex edge (or any vertex, in small pieces), where edge and vertex are of the
//               input; where one is not, only those whose equation is that of the faces' planes
//               with small integer factors, so that numbers stay short
//  3. judge     how many reflex edges lie in the plane (resolved), how many it crosses (doubled),
//               against what the planes of its own faces would do for each edge in it. Of equals
//               the one that leaves most on either side: a cut costs the size of the piece
//
// All of this is about the number of pieces alone and may be done in doubles: a plane is interned
// from input points or from planes, and the cut asks exact signs. Cost: one product an end for each
// candidate; their number is bounded so that a cut costs O(size of the piece) but for small pieces.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "plumb/base/context.h"
#include "plumb/convex/part/cut_surface.h"

namespace plumb {

/// The plane c[0] p + c[1] q of the primitive rows of two planes. Not valid where that is none.
PlaneId intern_pencil(PlaneTable& planes, PlaneId p, PlaneId q, std::array<int, 2> c);

struct CutCandidate {
  HalfedgeId seed;              ///< a reflex edge in the plane
  PlaneId plane;                ///< of a face of the seed; else not valid:
  InputPointId through;         ///< the plane holds this point; else not valid:
  std::array<int, 2> pencil{};  ///< factors of the primitive rows of the seed's and its twin's face
  int sheets = 1;               ///< of the plane at the seed, inside the solid: 1 or 2
  int crossed = 0;              ///< reflex edges
  int resolved = 0;             ///< reflex edges in the plane
  int lesser = 0;               ///< reflex edges on that side of the plane where fewer are
  int score = 0;                ///< cuts made and caused, less those spared: the least is best
};

class CutChooser {
 public:
  explicit CutChooser(CutSurface& surface) : s_(surface) {}

  /// The best candidates, in order; the last ones are the planes of the faces of one edge, which
  /// always do. Requires a reflex edge.
  std::span<const CutCandidate> candidates(std::span<const FaceId> faces,
                                           std::span<const HalfedgeId> reflex);
  /// The candidate's plane. Not valid when it is none.
  PlaneId intern(const CutCandidate& candidate);

 private:
  using Row = std::array<double, 4>;
  struct Edge {
    HalfedgeId half;
    std::uint32_t a, b;            // ends, into ends_
    std::array<double, 3> n1, n2;  // outward normals of the faces
    int alone = 0;                 // edges that the worse of its faces' planes crosses
  };

  void gather(std::span<const FaceId> faces, std::span<const HalfedgeId> reflex);
  std::uint32_t end_of(VertexId v);
  CutCandidate judged_face(const Edge& edge, bool is_first);
  void propose_points(const Edge& edge, std::size_t budget);
  void propose_point(const Edge& edge, VertexId target, bool by_factors);
  std::optional<std::array<int, 2>> small_factors(const Edge& edge,
                                                  const std::array<double, 3>& at);
  const Row& primitive(PlaneId p);
  CutCandidate judged(const Row& row, CutCandidate candidate);
  void keep(const CutCandidate& candidate);

  CutSurface& s_;
  std::vector<Edge> edges_;
  std::vector<VertexId> end_vertex_;
  std::vector<std::array<double, 3>> ends_;
  std::vector<signed char> signs_;
  std::vector<std::uint32_t> end_stamp_, end_index_;  // per vertex
  std::uint32_t stamp_ = 0;
  std::vector<VertexId> targets_;  // what planes may go through, besides: those of the input first
  std::size_t input_targets_ = 0;
  std::vector<Row> primitive_;  // per plane, once asked for; rounded
  std::vector<CutCandidate> best_;
  double tolerance_ = 0;
};

// One plane for each reflex edge of a solid, fixed before anything is cut: the classical rule, with
// which the number of pieces has a bound (cut_set.h).
//
// A tip is a vertex where several reflex edges meet. Where all of them lead to one side of a plane
// through the tip, the solid may touch the plane there from one side, and PlaneSection::find()
// fails.
//
// The plane of an edge: that of a face at it, of the first that holds no such tip, else the first
// of the pencil between both with that property, by small integer factors. A tip off the edge's
// line lies in one plane of the pencil, so one is found. Of tips on the line nothing is asked.
//
// Each plane enters the solid on one side of its edge only: after the cut both angles are at most
// half a turn. Cost: O(n + r t) signs for r reflex edges and t ends of reflex edges at tips, as a
// rule.

class FixedPlanes {
 public:
  /// Of the reflex edges of a surface that has not been cut.
  FixedPlanes(CutSurface& surface, std::span<const HalfedgeId> reflex, Context& context);

  PlaneId plane(EdgeId e) const { return plane_[e.value()]; }

 private:
  void find_tips(std::span<const HalfedgeId> reflex);
  PlaneId choose(HalfedgeId h);
  PlaneId choose_between(HalfedgeId h);
  bool may_touch(PlaneId p, std::array<PlaneId, 2> line) const;
  Sign side_of(VertexId v, PlaneId p) const;

  CutSurface& s_;
  std::vector<std::array<VertexId, 2>> spokes_;  // from tips to the other ends, by tips
  std::vector<PlaneId> plane_;                   // per edge
};

}  // namespace plumb
