// Booleans of complexes.
//
// Main flow of boolean_op():
//  1. unite tables    both operands refer to one table of planes and points
//  2. meet            (find_contacts.h) every place where an item of one touches an item of the
//                     other
//  3. locate          (vertex_labels.h) every other vertex lies in one volume of the other operand
//  4. overlay         at contacts both sphere maps are laid over each other (sphere_overlay.h);
//                     marks
//  5. select          through the function, minimal form; a vertex in a volume is kept, flipped or
//                     gone
//  6. pair            half-edges that face each other: where nothing touches, the old twins; else
//                     those of one line, in order. The line of a half-edge is named by the items
//                     (of a, of b) it runs in
//  7. join            (assemble.h)
//
// Cost: O((n + m + c) log(n + m + c)) for n + m items, c pairs of boxes that meet, besides the
// overlays: the product of degrees at a contact of two vertices. Source: Hachenberger, Kettner,
// Mehlhorn, CGTA 38 (2007); SPACE.md.
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

/// Makes both refer to one table: that of a, where nobody else needs it as it is, else a copy. b's
/// ids become those there.
std::shared_ptr<SpaceTables> unite_tables(SpaceComplex& a, SpaceComplex& b);

/// f(a, b) in minimal form. Both have a frame or none has. A facet in facets of both has the lesser
/// facet_origin. Tables that only `a` refers to are used as they are; the operands go before the
/// result is made.
SpaceComplex boolean_op(SpaceComplex a, SpaceComplex b, MarkFunction f, Context& context);

/// What facet_origin a facet gets that lies in facets of both operands, by theirs.
using CommonOrigin = std::function<std::uint32_t(std::uint32_t of_a, std::uint32_t of_b)>;

/// boolean_op() of operands that both refer to `tables`; new points are added there. With
/// MarkTable::walled() the first may have a frame and the second none.
SpaceComplex combine_on(const std::shared_ptr<SpaceTables>& tables, const SpaceComplex& a,
                        const SpaceComplex& b, const MarkTable& f, const CommonOrigin& origin,
                        Context& context);

/// A half-space or plane as an operand. Below: n.x + d < 0 for the oriented plane. Beyond: the
/// plane and what lies on that side have the mark kBeyond, the rest 0.
enum class PlaneSet : std::uint8_t {
  OpenBelow,
  ClosedBelow,
  OpenAbove,
  ClosedAbove,
  Plane,
  BeyondBelow,
  BeyondAbove
};

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

/// f(a, h), `tables` being a copy of a's that holds the plane. O(size) besides the join. Requires a
/// frame, or that f of the mark of a's volume 0 does not depend on h.
SpaceComplex combine_with_plane(SpaceComplex a, OrientedPlane plane, PlaneSet h, MarkFunction f,
                                const std::shared_ptr<SpaceTables>& tables, Context& context);

// Two complexes that lie apart, as one: nothing has to meet.

/// A complex and boxes that hold its boundary: one around all, or one for each set that was
/// appended.
struct BoxedComplex {
  const SpaceComplex& complex;
  std::span<const Box3> parts;
};

/// Is it plain that neither boundary meets the other or lies in a bounded volume of it? So it is if
/// the boxes have no point in common, or that of one, moved to infinity along an axis, meets no
/// part or no item of the other. Requires complexes without a frame. O(parts), O(n) if those do not
/// tell; in doubles.
bool are_apart(const BoxedComplex& a, const BoxedComplex& b);

/// Both, with one volume 0, whose mark is that of a's. Requires are_apart(a, b). Adds to a's arrays
/// and, where nobody else needs them, tables: O(b) then.
SpaceComplex appended(SpaceComplex a, SpaceComplex b);

}  // namespace plumb
