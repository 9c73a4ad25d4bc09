// Which planes cut a piece. CutChooser finds the best plane for each piece anew (the rule Greedy of
// cut_set.h); FixedPlanes chooses one plane for each reflex edge before anything is cut.
//
// Main flow of CutChooser::candidates():
//  1. gather    collects the reflex edges of the piece and their ends in doubles
//  2. propose   lists planes for an edge: the planes of its faces, and the planes through the edge
//               and the end of another reflex edge (in small pieces, any vertex), if edge and
//               vertex belong to the input. Otherwise only planes of the pencil of the two faces
//               with small integer factors are listed, so that numbers stay short
//  3. judge     counts the reflex edges that lie in the plane (resolved) and those it crosses
//               (doubled), against what the planes of its own faces would do for each edge in it.
//               If planes are equally good, the plane that leaves most on both sides wins, because
//               a cut costs the size of the piece
//
// The choice affects the number of pieces alone, so it may be made in doubles: a plane is interned
// from input points or from planes, and the cut takes exact signs. Cost: one product per end for
// each candidate. The number of candidates is bounded so that a cut costs O(size of the piece),
// except for small pieces.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "plumb/base/context.h"
#include "plumb/convex/part/cut_surface.h"

namespace plumb {

/// Returns the plane c[0] p + c[1] q of the primitive rows of two planes, or an invalid id if that
/// is no plane.
PlaneId intern_pencil(PlaneTable& planes, PlaneId p, PlaneId q, std::array<int, 2> c);

/// A plane through a reflex edge, given by the way in which it is interned, and the effects of a
/// cut by this plane.
struct CutCandidate {
  HalfedgeId seed;  ///< A reflex edge in the plane.
  PlaneId plane;    ///< The plane, if it is the plane of a face of the seed. Otherwise not valid.
  /// An input point that the plane holds; not valid if `plane` or `pencil` names the plane.
  InputPointId through;
  /// Factors of the primitive rows of the planes of the seed's and its twin's face.
  std::array<int, 2> pencil{};
  int sheets = 1;    ///< Sheets of the plane at the seed inside the solid: 1 or 2.
  int crossed = 0;   ///< Number of reflex edges that the plane crosses.
  int resolved = 0;  ///< Number of reflex edges in the plane.
  int lesser = 0;    ///< Number of reflex edges on the side of the plane with fewer.
  int score = 0;     ///< Cuts made and caused, less those spared; the least is best.
};

/// Proposes planes for cuts of the pieces of one surface. Scratch memory is kept from call to call.
class CutChooser {
 public:
  explicit CutChooser(CutSurface& surface) : s_(surface) {}

  /// Returns the best candidates in order. The last two are the planes of the faces of one edge,
  /// which can nearly always be cut along. Requires a reflex edge. The span is valid until the next
  /// call.
  std::span<const CutCandidate> candidates(std::span<const FaceId> faces,
                                           std::span<const HalfedgeId> reflex);
  /// Returns the plane of the candidate, or an invalid id if its points or factors span none.
  PlaneId intern(const CutCandidate& candidate);

 private:
  using Row = std::array<double, 4>;
  struct Edge {
    HalfedgeId half;
    std::uint32_t a, b;            // Ends, as indices into ends_.
    std::array<double, 3> n1, n2;  // Unit outward normals of the faces.
    int alone = 0;                 // Number of edges that the worse of its faces' planes crosses.
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
  IdVector<VertexId, std::uint32_t> end_stamp_, end_index_;
  std::uint32_t stamp_ = 0;
  // Vertices that planes may pass through. Vertices of the input come first.
  std::vector<VertexId> targets_;
  std::size_t input_targets_ = 0;
  IdVector<PlaneId, Row> primitive_;  // Rounded primitive rows, filled on demand.
  std::vector<CutCandidate> best_;
  double tolerance_ = 0;
};

// One plane for each reflex edge of a solid, fixed before anything is cut: the classical rule, for
// which the number of pieces is bounded (cut_set.h).
//
// A tip is a vertex where several reflex edges meet. If all of them lead to one side of a plane
// through the tip, the solid may touch the plane there from one side, and PlaneSection::find()
// fails.
//
// The plane of an edge is the plane of the first of its faces that contains no such tip. If both
// contain one, it is the first plane of the pencil between the two faces, by small integer factors,
// that contains none. A tip off the edge's line lies in one plane of the pencil, so one is found.
// Tips on the line are not tested.
//
// Each plane enters the solid on one side of its edge only, so both angles are at most half a turn
// after the cut. Cost: O(n + r t) signs as a rule, for r reflex edges and t ends of reflex edges at
// tips.

class FixedPlanes {
 public:
  /// Chooses planes for the reflex edges of a surface that has not been cut.
  FixedPlanes(CutSurface& surface, std::span<const HalfedgeId> reflex, Context& context);

  /// Returns the plane of a reflex edge of the solid.
  PlaneId plane(EdgeId e) const { return plane_[e]; }

 private:
  void find_tips(std::span<const HalfedgeId> reflex);
  PlaneId choose(HalfedgeId h);
  PlaneId choose_between(HalfedgeId h);
  bool may_touch(PlaneId p, std::array<PlaneId, 2> line) const;
  Sign side_of(VertexId v, PlaneId p) const;

  CutSurface& s_;
  std::vector<std::array<VertexId, 2>> spokes_;  // Edges as (tip, other end), sorted by tips.
  IdVector<EdgeId, PlaneId> plane_;
};

}  // namespace plumb
