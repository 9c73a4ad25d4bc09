// The symbolic cube around unbounded sets: added before an operation that needs it, dropped when
// nothing reaches it.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "plumb/base/context.h"
#include "plumb/predicates/arithmetic/vectors.h"
#include "plumb/predicates/rational.h"
#include "plumb/space/space_complex.h"

namespace plumb {

/// Is there a frame?
bool has_frame(const SpaceComplex& complex);

/// Per volume: does it reach to infinity? The beyond of a frame does, too. O(n).
std::vector<std::uint8_t> unbounded_volumes(const SpaceComplex& complex);

/// The same set inside the cube. `tables` hold at least what the complex's do, under the same ids.
/// Requires no frame.
SpaceComplex with_frame(const SpaceComplex& complex, const std::shared_ptr<SpaceTables>& tables,
                        Context& context);

/// Without the frame, if no facet or edge of the set reaches it. O(n).
SpaceComplex without_idle_frame(SpaceComplex complex, Context& context);

// Vectors and 3 x 3 matrices of rationals, for maps and the boxes they move.

using RationalRow = std::array<Rational, 3>;
using RationalMatrix = std::array<RationalRow, 3>;  ///< of rows

/// The columns of determinant(m) m^-1, as rows.
inline RationalMatrix cofactors(const RationalMatrix& m) {
  return {cross(m[1], m[2]), cross(m[2], m[0]), cross(m[0], m[1])};
}

inline Rational determinant(const RationalMatrix& m) { return dot(m[0], cross(m[1], m[2])); }

/// |r[0]| + |r[1]| + |r[2]|: the largest r.x in the cube |x|, |y|, |z| <= 1.
inline Rational sum_of_magnitudes(const RationalRow& r) {
  Rational sum = 0;
  for (const Rational& x : r) sum += x < 0 ? Rational(-x) : x;
  return sum;
}

// Boxes beyond all bounds, of any shape, that frame an unbounded set while it is mapped.
//
// A far box is |n_i.x| <= s R for three normals n_i and the R of the frame (frame.h): a linear map
// takes a framed complex to one in such a box, and six cuts bring it back into the cube. What lies
// outside has the mark kBeyond.
//
// A shift takes a far box to one whose planes have offsets s R + c. Leaving out c changes nothing
// if the complex meets the box in general position: no edge that reaches it runs towards an edge of
// the box, no facet that reaches it is parallel to one of its diagonals. (Then everything on an
// edge of the box is a facet crossing it alone, and where two facets follow each other on it at a
// distance that does not grow with R, they are parallel: both move by as much.) Whether it does is
// a matter of directions.

struct FarBox {
  RationalMatrix normal;
  Rational size;  ///< s > 0
};

/// The far plane n.x + d R = 0, with its positive side. Requires n and d that are not zero. Planes
/// made on the way stay in the table.
OrientedPlane far_plane(PlaneTable& planes, const RationalRow& normal, const Rational& d);

/// That of every framed complex.
FarBox frame_box();

/// Does what reaches the frame meet a box with these normals in general position?
/// Requires a frame and normals that are linearly independent.
bool is_general(const SpaceComplex& complex, const RationalMatrix& normal);

/// A box inside the cube in general position: the cube itself if it is. Requires a frame. Expected
/// O(n).
FarBox general_box(const SpaceComplex& complex);

/// The part inside the box. Requires a complex framed by a larger box, or by the same one: then it
/// is returned as it is. `tables`: the complex's own, or a copy.
SpaceComplex inside(SpaceComplex complex, const FarBox& box,
                    const std::shared_ptr<SpaceTables>& tables, Context& context);

}  // namespace plumb
