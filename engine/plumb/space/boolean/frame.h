// The symbolic cube around unbounded sets. It is added before an operation that needs it and
// dropped when nothing reaches it. The second part has far boxes, which frame an unbounded set
// while an affine map moves it.
//
// Notation: R is the symbolic half side of the cube, larger than every number. What lies on the
// cube and beyond it has the mark kBeyond. Proofs: docs/design/frame.md, "In space: the symbolic
// cube" and "Affine maps: far boxes".
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

/// Whether the complex has a frame: volume 0 is then the beyond. O(1).
bool has_frame(const SpaceComplex& complex);

/// Returns for each volume 1 if it reaches to infinity, else 0. The beyond of a frame counts as
/// unbounded. O(n).
std::vector<std::uint8_t> unbounded_volumes(const SpaceComplex& complex);

/// Returns the same set inside the cube. Requires that the complex has no frame, and that `tables`
/// contains all planes and points of the tables of the complex, with the same ids. O(n), besides
/// the assembly.
SpaceComplex with_frame(const SpaceComplex& complex, const std::shared_ptr<SpaceTables>& tables,
                        Context& context);

/// Returns the complex without its frame if no facet or edge of the set reaches it, else unchanged.
/// O(n).
SpaceComplex without_idle_frame(SpaceComplex complex, Context& context);

// Vectors and 3 x 3 matrices of rationals, for affine maps and the boxes that they move.

/// A vector, or a row of a matrix.
using RationalRow = std::array<Rational, 3>;
using RationalMatrix = std::array<RationalRow, 3>;  ///< Three rows.

/// Returns the columns of determinant(m) m^-1, as rows.
inline RationalMatrix cofactors(const RationalMatrix& m) {
  return {cross(m[1], m[2]), cross(m[2], m[0]), cross(m[0], m[1])};
}

/// Returns the determinant.
inline Rational determinant(const RationalMatrix& m) { return dot(m[0], cross(m[1], m[2])); }

/// Returns |r[0]| + |r[1]| + |r[2]|, the largest r.x in the cube |x|, |y|, |z| <= 1.
inline Rational sum_of_magnitudes(const RationalRow& r) {
  Rational sum = 0;
  for (const Rational& x : r) sum += x < 0 ? Rational(-x) : x;
  return sum;
}

// Far boxes: parallelepipeds beyond all bounds that frame an unbounded set while it is mapped.
//
// A far box is |n_i.x| <= s R for three normals n_i and the R of the frame. A linear map takes a
// framed complex to one in such a box, and six cuts bring it back into the cube. What lies outside
// has the mark kBeyond.
//
// A shift takes a far box to one whose planes have offsets s R + c. Leaving out c changes nothing
// if the complex meets the box in general position: no edge that reaches it runs towards an edge of
// the box, and no facet that reaches it is parallel to one of its diagonals. (Then everything on an
// edge of the box is a facet that crosses it alone, and where two facets follow each other on it at
// a distance that does not grow with R, they are parallel, so both move by the same vector.)
// Whether the position is general depends on directions alone. Proof: docs/design/frame.md, Lemma
// 4.

/// The parallelepiped |normal[i].x| <= size R for i = 0, 1, 2.
struct FarBox {
  RationalMatrix normal;  ///< Three normals, linearly independent.
  Rational size;          ///< The factor s > 0 of R.
};

/// Returns the far plane n.x + d R = 0 with its positive side. Requires that n and d are not zero.
/// Planes of pencils that are made on the way stay in the table.
OrientedPlane far_plane(PlaneTable& planes, const RationalRow& normal, const Rational& d);

/// Returns the cube: the box of every framed complex.
FarBox frame_box();

/// Whether all edges and facets of the set that reach the frame meet a box with these normals in
/// general position. Requires a frame, and normals that are linearly independent. O(n).
bool is_general(const SpaceComplex& complex, const RationalMatrix& normal);

/// Returns a box inside the cube in general position, which is the cube itself if that is. Requires
/// a frame. Expected O(n).
FarBox general_box(const SpaceComplex& complex);

/// Returns the part of a complex inside a box. Requires that the complex is framed by a larger box,
/// or by the same one: then it is returned unchanged. `tables` is the complex's own table or a copy
/// of it. Costs up to six cuts.
SpaceComplex inside(SpaceComplex complex, const FarBox& box,
                    const std::shared_ptr<SpaceTables>& tables, Context& context);

}  // namespace plumb
