// Is a divided surface what its headers promise? Everything from scratch.
//
// Main flow of audit(), each step relying on those before:
//  1. links     half-edges, twins, pieces and loops hold together; sides run along the sides of their faces
//  2. faces     each touched face has as many pieces as Euler's formula says, and they share its area
//  3. flow      polygons are cycles: at every node as much of each arrives as leaves
//  4. places    crossings lie on both their segments, inside their face, apart from each other
//  5. cells     differ across arcs only; the graph has each pair of neighbours
//  6. labels    jump across arcs by the multiplicities; certificates are cycles around which
//               these do not add up to zero
#pragma once

#include <optional>
#include <string>

#include "plumb/surface/surface.h"

#pragma GCC visibility push(default)
namespace plumb {

/// The first broken invariant and where, or none. O(mesh + arrangement + labels), and rationals for each
/// crossing.
std::optional<std::string> audit(const SurfaceDivision& division);

}  // namespace plumb
#pragma GCC visibility pop
