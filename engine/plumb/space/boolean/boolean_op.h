// Booleans of two complexes of space, and the union of complexes that lie apart.
//
// Main flow of boolean_op():
//  1. unite tables    lets both operands refer to one table of planes and points
//  2. find contacts   finds every contact: a place where a cell of one operand intersects a cell of
//                     the other (find_contacts.h)
//  3. locate          finds the volume of the other operand around every other vertex
//                     (vertex_labels.h)
//  4. overlay         lays both sphere maps over each other at every contact and applies the
//                     function of marks (sphere_overlay.h)
//  5. select          brings these maps into minimal form; a vertex in a volume is kept, flipped or
//                     dropped, as the mark of the volume says
//  6. pair            pairs half-edges that face each other: old twins where nothing touches them,
//                     else those of one line in order along it; the pair of cells (of a, of b) in
//                     which a half-edge runs names its line
//  7. assemble        links corners to facets, and facets to volumes (assemble.h)
//
// No plane is added and no two constructed points are compared for equality. Every step is proved
// in docs/design/boolean.md, Lemmas 1 to 7.
//
// Cost: O((n + m + c) log(n + m + c)) for n and m cells and c pairs of boxes that meet, plus the
// cost of the overlays. The overlay at a contact of two vertices costs the product of their
// degrees. Source: P. Hachenberger, L. Kettner, K. Mehlhorn, Computational Geometry 38 (2007)
// 64-99; docs/design/boolean.md.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <span>

#include "plumb/base/context.h"
#include "plumb/base/internal/box_tree.h"
#include "plumb/base/marks.h"
#include "plumb/space/space_complex.h"

namespace plumb {

/// Makes both complexes refer to one table and returns it: the table of a, which is copied if
/// another complex shares it. The ids of b are replaced by ids of this table. Cost: O(size of b),
/// and of a if its table is copied.
std::shared_ptr<SpaceTables> unite_tables(SpaceComplex& a, SpaceComplex& b);

/// Returns f(a, b) in minimal form. Requires that both operands have a frame or none has. A facet
/// that lies in facets of both gets the lesser facet_origin. Tables to which only `a` refers are
/// used without a copy, and the operands are freed before the result is made. Throws the errors of
/// the Context.
SpaceComplex boolean_op(SpaceComplex a, SpaceComplex b, MarkFunction f, Context& context);

/// Maps the facet_origins of two facets, one of each operand, to the facet_origin of a facet that
/// lies in both.
using CommonOrigin = std::function<std::uint32_t(std::uint32_t of_a, std::uint32_t of_b)>;

/// Returns the Boolean of operands that both refer to `tables`, to which new points are added. With
/// MarkTable::walled() the first operand may have a frame while the second has none. Otherwise as
/// boolean_op().
SpaceComplex boolean_op_on(const std::shared_ptr<SpaceTables>& tables, const SpaceComplex& a,
                           const SpaceComplex& b, const MarkTable& f, const CommonOrigin& origin,
                           Context& context);

/// A half-space or a plane as the second operand. "Below" are the points with n.x + d < 0 for the
/// oriented plane. For the two Beyond values, the plane and the points on that side have the mark
/// kBeyond and all others the mark 0.
enum class PlaneSet : std::uint8_t {
  OpenBelow,    ///< The points below.
  ClosedBelow,  ///< The points below and on the plane.
  OpenAbove,    ///< The points above.
  ClosedAbove,  ///< The points above and on the plane.
  Plane,        ///< The points on the plane.
  BeyondBelow,  ///< The points below and on the plane, with the mark kBeyond.
  BeyondAbove   ///< The points above and on the plane, with the mark kBeyond.
};

/// Returns the same set of points for the plane with the opposite orientation.
constexpr PlaneSet opposite(PlaneSet h) {
  switch (h) {
    case PlaneSet::OpenBelow:
      return PlaneSet::OpenAbove;
    case PlaneSet::ClosedBelow:
      return PlaneSet::ClosedAbove;
    case PlaneSet::OpenAbove:
      return PlaneSet::OpenBelow;
    case PlaneSet::ClosedAbove:
      return PlaneSet::ClosedBelow;
    case PlaneSet::BeyondBelow:
      return PlaneSet::BeyondAbove;
    case PlaneSet::BeyondAbove:
      return PlaneSet::BeyondBelow;
    case PlaneSet::Plane:
      break;
  }
  return PlaneSet::Plane;
}

/// Returns f(a, h) in minimal form. Requires that `tables` is the table of `a` or a copy of it, and
/// holds the plane; and that `a` has a frame, or that f of the mark of volume 0 of `a` does not
/// depend on h. O(n) for n cells of a, besides the assembly.
SpaceComplex boolean_op_with_plane(SpaceComplex a, OrientedPlane plane, PlaneSet h, MarkFunction f,
                                   const std::shared_ptr<SpaceTables>& tables, Context& context);

// Complexes that lie apart. Their union needs no contacts: the arrays are appended.

/// A complex with boxes that hold its boundary: one box around all of it, or one for each set that
/// was appended.
struct BoxedComplex {
  const SpaceComplex& complex;  ///< The complex, without a frame.
  std::span<const Box3> parts;  ///< Boxes whose union holds all its vertices, edges and facets.
};

/// Whether boxes prove that neither boundary meets the other or lies in a bounded volume of the
/// other. They do if the boxes have no point in common, or if the box of one operand, moved to
/// infinity along an axis, meets no part or no cell of the other. False proves nothing. Requires
/// complexes without a frame. O(parts), and O(n) where the parts decide nothing; compares doubles
/// only.
bool are_apart(const BoxedComplex& a, const BoxedComplex& b);

/// Returns the union of both, with one volume 0 that has the mark of a's. Requires are_apart(a, b).
/// Appends to the arrays of a and, if no other complex shares them, to its tables; then it costs
/// O(size of b).
SpaceComplex appended(SpaceComplex a, SpaceComplex b);

}  // namespace plumb
