// Audit of a divided surface: checks every invariant that its headers promise, from scratch.
//
// Main flow of audit(); each step relies on the steps before it:
//  1. links     half-edges, twins, pieces and loops are consistent; sides run along the sides of
//               their faces
//  2. faces     each touched face has as many pieces as Euler's formula says, and the shares of its
//               pieces add up to its area
//  3. flow      polygons are cycles: at every node, each polygon arrives as often as it leaves
//  4. places    crossings lie on both their segments, inside their face, and are distinct
//  5. cells     cells differ across arcs only; the graph contains each pair of neighbours
//  6. labels    labels jump across arcs by the multiplicities; certificates are cycles around which
//               these multiplicities do not add up to zero
#pragma once

#include <optional>
#include <string>

#include "plumb/surface/surface.h"

#pragma GCC visibility push(default)
namespace plumb {

/// Returns the first broken invariant and the cells concerned, or no value if all invariants hold.
/// Costs O(mesh + arrangement + labels), and rational arithmetic for each crossing.
std::optional<std::string> audit(const SurfaceDivision& division);

}  // namespace plumb
#pragma GCC visibility pop
