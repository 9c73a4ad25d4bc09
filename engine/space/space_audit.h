// Is a complex in space what space_complex.h promises? Everything from scratch, by exact predicates.
//
// Main flow of audit(), each step relying on those before:
//  1. links     sizes, ids, stars, uses, radial cycles, boundary cycles, free parts
//  2. places    planes and vertices distinct, edges run as their planes say, facets turn counter-clockwise
//               around edges, sphere maps are drawn without crossings
//  3. cycles    simple, outer first and counter-clockwise, holes inside and apart
//  4. meeting   nothing meets but at common vertices and edges
//  5. marks     volumes as find_volumes() finds them, the frame sane, minimal form
#pragma once

#include <optional>
#include <string>

#include "plumb/base/context.h"
#include "plumb/space/space_complex.h"

#pragma GCC visibility push(default)
namespace plumb {

/// A broken invariant and where: "edge 3, facet 5".
struct SpaceFlaw {
  std::string invariant;  ///< what does not hold
  std::string place;      ///< at which item
};

/// The first flaw found, or none. `minimal`: also that no item could go without changing the set (the
/// form of a Nef3). A complex that names a plane or point that is not there is a flaw too; nothing is read
/// before its id was checked.
/// Cost: O(n log n + pairs of boxes that meet), of one facet with n uses and k vertices or edges inside it or in the box of
/// its surface, k holes among them, O(k) times the cycles whose boxes they lie in; around one vertex of degree d without a
/// fan of corners (mesh_fans.h) O(d^2). Memory: about that of the complex.
std::optional<SpaceFlaw> audit(const SpaceComplex& complex, bool minimal);
/// The same, within the limits of a context.
std::optional<SpaceFlaw> audit(const SpaceComplex& complex, bool minimal, Context& context);

}  // namespace plumb
#pragma GCC visibility pop
