// The Minkowski sum of two closed bounded convex sets of any dimension, by their merged normal
// fans; with the representation of such sets (ConvexBody) and the directions of the sum's facets.
//
// Notation
//   facet    a cycle of vertices, counter-clockwise seen from outside, and an outer normal. A
//            polygon has two facets, one for each side; segments and points have none
//   edge     runs from end[0] to end[1]; side[0] is the facet to its left seen from outside,
//            side[1] that to its right (kNone for a segment)
//   A(u)     the face of A where the direction u is greatest: a vertex, an edge or a facet
//
// A facet of A + B with outer normal u is A(u) + B(u), and no vertex of the sum is a + b for two
// pairs of vertices. So facets can be made one by one, each from its pair of faces, and fit
// together by the names (a, b) of their corners; there are no degenerate cases. There are two kinds
// of directions: the normals of facets of A and of B, and the directions in which an edge of A and
// an edge of B that are not parallel are both extreme. At a direction of the second kind, arcs of
// the two Gaussian maps cross.
//
// Main flow of convex_sum():
//  1. facet_directions   finds for each facet of one operand the face of the other: climbs from
//                        vertex to vertex, from where the facet beside it ended
//  2. edge_directions    turns u about each edge of one operand, from one of its facets' normals to
//                        the other, and follows the extreme vertex of the other operand (gift
//                        wrapping around its silhouette)
//  3. merge              merges the cycles of A(u) and B(u) by the angles of their edges; parallel
//                        edges add up
//  4. link               links vertices, facets and marks to a minimal complex (link_facets.h)
//
// Numbers are known exactly and, for filters, as balls of doubles. Signs have degree 3 in
// differences, by balls of doubles, then rationals. Cost: steps 1 and 2 take O(degree) for each
// vertex passed; a vertex is passed for every facet of the sum at it, so they are output-sensitive
// if degrees are bounded. Proof: docs/design/walls.md, section Minkowski sums. Sources: K. Fukuda,
// Journal of Symbolic Computation 38 (2004); E. Fogel and D. Halperin, Computer-Aided Design 39
// (2007) 929-940.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "plumb/base/context.h"
#include "plumb/predicates/arithmetic/vectors.h"
#include "plumb/predicates/rational_point.h"
#include "plumb/space/nef3.h"
#include "plumb/space/query/space_ray.h"
#include "plumb/space/space_complex.h"

namespace plumb {

/// A vector of space with a bound on the error of each coordinate.
struct BallVector {
  std::array<Ball, 3> at;

  friend BallVector operator-(const BallVector& a, const BallVector& b) {
    return {{a.at[0] - b.at[0], a.at[1] - b.at[1], a.at[2] - b.at[2]}};
  }
};
inline Ball dot(const BallVector& a, const BallVector& b) {
  return a.at[0] * b.at[0] + a.at[1] * b.at[1] + a.at[2] * b.at[2];
}
inline BallVector cross(const BallVector& a, const BallVector& b) {
  return {{a.at[1] * b.at[2] - a.at[2] * b.at[1], a.at[2] * b.at[0] - a.at[0] * b.at[2],
           a.at[0] * b.at[1] - a.at[1] * b.at[0]}};
}

/// A closed bounded convex set of dimension 0 to 3, by its vertices, edges and facets.
struct ConvexBody {
  /// An edge, with its ends and the facets beside it.
  struct Edge {
    std::array<std::uint32_t, 2> end;
    std::array<std::uint32_t, 2> side;
  };

  unsigned dimension = 0;
  std::vector<RationalPoint3> point;
  std::vector<BallVector> rough_point;
  std::vector<std::uint32_t> star_begin;  ///< Begin of each vertex's entries in `neighbour`.
  std::vector<std::uint32_t> neighbour;
  std::vector<Edge> edge;
  std::vector<std::uint32_t> facet_begin = {0};
  std::vector<std::uint32_t> corner;
  std::vector<RationalPoint3> normal;
  std::vector<BallVector> rough_normal;

  std::size_t facet_count() const { return normal.size(); }
  std::span<const std::uint32_t> corners(std::size_t f) const {
    return std::span(corner).subspan(facet_begin[f], facet_begin[f + 1] - facet_begin[f]);
  }
  std::span<const std::uint32_t> star(std::uint32_t v) const {
    return std::span(neighbour).subspan(star_begin[v], star_begin[v + 1] - star_begin[v]);
  }
};

/// Returns the closure of a bounded convex set that is not empty. Requires the minimal complex of a
/// closed convex set. Cost: O(n).
ConvexBody convex_body_of(const SpaceComplex& complex);
/// Returns the memory of a body, estimated for numbers of ordinary length. Cost: O(1).
std::size_t memory_bytes(const ConvexBody& body);
/// Returns a point, a segment or a triangle. Requires one to three points that are not on a line.
ConvexBody convex_body_of(std::span<const RationalPoint3> points);

// The directions of the facets of a Minkowski sum, found by walks in one operand's normal fan.

/// A facet of a + b: its outer normal, and the faces of the operands in that direction by their
/// vertices: one, the two of an edge, or the corners of a facet, counter-clockwise seen from
/// outside.
struct FacetDirection {
  const RationalPoint3& normal;
  const BallVector& rough_normal;
  std::span<const std::uint32_t> face_a;
  std::span<const std::uint32_t> face_b;
};

/// Calls visit for every facet of the sum, once. Requires a sum of dimension 3, so that one operand
/// has facets. Throws the errors of the Context.
void for_each_direction(const ConvexBody& a, const ConvexBody& b,
                        const std::function<void(const FacetDirection&)>& visit, Context& context);

/// The part of the closed sum that belongs to the result.
enum class SumMarks : std::uint8_t {
  Closed,  ///< All of it.
  Open,    ///< Its relative interior.
};

/// Returns the sum of two bodies with the marks that `marks` says. Throws the errors of the
/// Context.
Nef3 convex_sum(const ConvexBody& a, const ConvexBody& b, SumMarks marks, Context& context);

/// Returns the mark of the face of a sum, of dimension 0 to 2, that is the sum of these two faces.
/// Faces are given as in FacetDirection, but the vertices of an edge can be in either order.
using FaceMarker = std::function<Mark(unsigned dimension, std::span<const std::uint32_t> face_a,
                                      std::span<const std::uint32_t> face_b)>;

/// Returns the sum of two bodies of dimension 3. The interior of the sum is marked, and `mark_of`
/// gives the marks of its facets, edges and vertices; it is called once for each of them. Throws
/// the errors of the Context.
Nef3 convex_sum(const ConvexBody& a, const ConvexBody& b, const FaceMarker& mark_of,
                Context& context);

}  // namespace plumb
