// Boxes beyond all bounds, of any shape, that frame an unbounded set while it is mapped.
//
// A far box is |n_i.x| <= s R for three normals n_i and the R of the frame (frame.h): a linear map takes a
// framed complex to one in such a box, and six cuts bring it back into the cube. What lies outside has
// the mark kBeyond.
//
// A shift takes a far box to one whose planes have offsets s R + c. Leaving out c changes nothing if
// the complex meets the box in general position: no edge that reaches it runs towards an edge of the
// box, no facet that reaches it is parallel to one of its diagonals. (Then everything on an edge of the box is a facet
// crossing it alone, and where two facets follow each other on it at a distance that does not grow with R, they are
// parallel: both move by as much.) Whether it does is a matter of directions.
#pragma once

#include "plumb/base/context.h"
#include "plumb/space/rational_matrix.h"
#include "plumb/space/space_complex.h"

namespace plumb {

struct FarBox {
  RationalMatrix normal;
  Rational size;  ///< s > 0
};

/// The far plane n.x + d R = 0, with its positive side. Requires n and d that are not zero. Planes made on the
/// way stay in the table.
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
