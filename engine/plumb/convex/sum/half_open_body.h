// A convex piece of a set with the marks of its boundary, as an operand of Minkowski sums.
//
// Notation
//   face     a vertex, an edge or a facet of the closure of the piece (ConvexBody). The complex of
//            the piece can divide the relative interior of an edge or facet into several items with
//            different marks
//   inner    in the interior of the closure of the set from which the piece was cut
//
// The marks of inner items do not change the sum of two sets if each of the sets is the union of
// pieces of dimension 3. Let U be the interior of the closure of A. The sum U + B is open, so it
// does not change if U is replaced by the interiors of the pieces of A, which are dense in U, and
// B by the interiors of the pieces of B. So U + B is in the union of the interiors of the sums of
// pieces, with or without the marks of inner items. Nearly all faces with items of different marks
// consist of facets of the set and of walls, which are inner.
//
// Main flow of HalfOpenBody
//  1. assign   finds the face whose relative interior contains an item, by the planes of the facets
//              around the item
//  2. judge    finds whether all items of a face that are not inner have the same mark
//  3. part     returns the items of a face as a set, for faces whose items have different marks
//
// half_open_sum() marks a face F + G of the sum if F and G are marked. If F + G has the dimensions
// of F and G together, every point of F + G is the sum of one pair of points, so F + G is not
// marked if F or G is not. Otherwise, F and G are parallel, and other marked faces in the closures
// of F and G can have sums in F + G. The caller adds the sums of such faces.
// Cost: O(n log n) for n items, and a location in the set for each item of a face that step 2 does
// not decide. Proof: docs/design/walls.md, section Minkowski sums.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <utility>
#include <vector>

#include "plumb/base/context.h"
#include "plumb/convex/sum/convex_sum.h"
#include "plumb/space/nef3.h"

namespace plumb {

/// The marks of the items in the relative interior of a face, except for inner items.
enum class FaceMark : std::uint8_t {
  None,    ///< No item is marked.
  All,     ///< All items are marked.
  Uneven,  ///< Some items are marked.
};

/// A face of a ConvexBody: its dimension from 0 to 2, and its number among faces of this dimension.
struct BodyFace {
  std::uint32_t dimension = 0;
  std::uint32_t number = 0;
};

/// A convex set of dimension 3 as an operand of half_open_sum().
class HalfOpenBody {
 public:
  /// Requires that `piece` is bounded, convex and of dimension 3, that `hull` is the closure of the
  /// set from which it was cut, and that is_wall() is right for all facets of the piece.
  HalfOpenBody(const Nef3& piece, const Nef3& hull, Context& context);

  const ConvexBody& body() const { return body_; }
  /// Returns the face with these vertices: one, the two of an edge, or the corners of a facet in
  /// their order. O(log k) for k edges at the first vertex.
  BodyFace face_of(std::span<const std::uint32_t> vertices) const;
  FaceMark mark(BodyFace face) const { return mark_[code(face)]; }
  /// Returns the marked items in the relative interior of a face, or in all of the face, as a set.
  /// O(n) for a piece of n items.
  Nef3 part(BodyFace face, bool with_boundary, Context& context) const;
  /// Whether part() of the same face is not empty. O(log n) for each face in question, and O(k) for
  /// the k items in them.
  bool has_part(BodyFace face, bool with_boundary) const;
  std::size_t bytes() const;

 private:
  friend class HalfOpenReader;
  std::uint32_t code(BodyFace face) const { return first_[face.dimension] + face.number; }
  std::uint32_t edge_between(std::uint32_t v, std::uint32_t w) const;
  std::vector<std::uint32_t> closure_of(BodyFace face) const;
  /// Calls visit for each marked item of a face, or of a face and its boundary.
  template <class Visit>
  void for_each_marked(BodyFace face, bool with_boundary, const Visit& visit) const;

  Nef3 piece_;
  ConvexBody body_;
  std::array<std::uint32_t, 3> first_{};            // The code of the first face of each dimension.
  std::vector<std::array<std::uint32_t, 3>> link_;  // Vertex, neighbour, edge; ascending.
  std::vector<std::pair<std::uint32_t, SpaceItem>> item_;  // Code of a face, item; ascending.
  std::vector<FaceMark> mark_;                             // One entry for each code.
};

/// Returns the sum of two pieces, up to the sums of parallel faces. Calls visit for each pair of
/// faces whose sum is a facet or an edge of the sum of which only a part may be marked. The sum of
/// the pieces is the union of the result and of the sums of the marked items of these faces. If
/// `is_parallel`, items in the boundary of the faces are needed, too. Throws the errors of the
/// Context.
Nef3 half_open_sum(const HalfOpenBody& a, const HalfOpenBody& b,
                   const std::function<void(BodyFace, BodyFace, bool is_parallel)>& visit,
                   Context& context);

}  // namespace plumb
