// A closed bounded convex set of dimension 0 to 3 by its vertices, edges and facets: what Minkowski
// sums are made of.
//
// Notation
//   facet    a cycle of vertices, counter-clockwise seen from outside, and an outer normal. A
//            polygon has two facets, one for each side; segments and points have none
//   edge     from end[0] to end[1]; side[0] is the facet to its left seen from outside, side[1]
//            that to its right (none: of a segment)
//
// Every number is known exactly and, for filters, as a ball of doubles.
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

/// A vector of space.
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

struct ConvexBody {
  struct Edge {
    std::array<std::uint32_t, 2> end;
    std::array<std::uint32_t, 2> side;
  };

  unsigned dimension = 0;
  std::vector<RationalPoint3> point;
  std::vector<BallVector> rough_point;
  std::vector<std::uint32_t> star_begin;  ///< per vertex: entries into neighbour
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

/// The closure of a bounded convex set that is not empty, by its complex. Requires the minimal
/// complex of a closed convex set. O(n).
ConvexBody convex_body_of(const SpaceComplex& complex);
/// What it takes, of numbers of ordinary length. O(1).
std::size_t memory_bytes(const ConvexBody& body);
/// A point, a segment or a triangle: one to three points, not on a line.
ConvexBody convex_body_of(std::span<const RationalPoint3> points);

// The directions of the facets of a Minkowski sum, by walks in one operand's normal fan (internal
// to convex_sum).

/// A facet of a + b: its outer normal and the faces of the operands there, by their vertices: one,
/// the two of an edge, or the corners of a facet, counter-clockwise seen from outside.
struct FacetDirection {
  const RationalPoint3& normal;
  const BallVector& rough_normal;
  std::span<const std::uint32_t> face_a;
  std::span<const std::uint32_t> face_b;
};

/// Calls visit for every facet of the sum, once. Requires a sum of dimension 3 (so one operand has
/// facets).
void for_each_direction(const ConvexBody& a, const ConvexBody& b,
                        const std::function<void(const FacetDirection&)>& visit, Context& context);

// The Minkowski sum of two closed bounded convex sets of any dimension, by their merged normal
// fans.
//
// For a direction u let A(u) be the face of A where u is greatest: a vertex, an edge or a facet. A
// facet of A + B with outer normal u is A(u) + B(u), and no vertex of the sum is a + b for two
// pairs of vertices. So facets can be made one by one, each from its pair of faces, and fit
// together by the names (a, b) of their corners; nothing is degenerate. Directions:
//   normals of facets of A and of B where an edge of A and an edge of B, not parallel, are both
//   extreme: arcs of the two Gaussian maps cross
//
// Main flow of convex_sum():
//  1. facet_directions   of each facet of one operand the face of the other: climb from vertex to
//                        vertex, from where the facet beside it ended
//  2. edge_directions    for each edge of one operand turn u about it, from one of its facets'
//                        normals to the other, and follow the extreme vertex of the other operand
//                        (gift wrapping around its silhouette)
//  3. merge              the cycles of A(u) and B(u) by the angles of their edges; parallel ones
//                        add up
//  4. link               (link_facets.h) vertices, facets, marks: a minimal complex
//
// Cost: steps 1 and 2 O(degree) for each vertex passed; a vertex is passed for every facet of the
// sum at it, so it is output-sensitive where degrees are bounded. Signs: degree 3 in differences,
// balls of doubles, then rationals. Source: Fukuda, J. Symb. Comput. 38 (2004); Fogel, Halperin,
// CAD 39 (2007) 929-940.

/// What belongs to the result.
enum class SumMarks : std::uint8_t {
  Closed,  ///< all of it
  Open,    ///< its relative interior
};

Nef3 convex_sum(const ConvexBody& a, const ConvexBody& b, SumMarks marks, Context& context);

}  // namespace plumb
