// Checks a divided surface. The audit checks from scratch all invariants that the headers of
// plumb/surface state.
//
// Main flow of audit(); each step relies on the steps before it:
//  1. links     half-edges, twins, pieces and loops are consistent. In each face that polygons
//               touch, the half-edges on the boundary run along the sides of the face
//  2. faces     in each face that polygons touch, the number of pieces agrees with Euler's formula.
//               The areas of these pieces add up to the area of the face
//  3. flow      polygons are closed: each polygon enters every node as often as it leaves the node
//  4. places    each crossing lies on its two segments and inside its face; crossings are distinct
//  5. cells     neighbouring pieces with different cells are separated by an arc; the graph of
//               cells contains each pair of neighbouring cells
//  6. labels    from one side of an arc to the other, labels change by the multiplicities of the
//               arc. If a shape has no label, its Separation::cycle is a closed walk over cells.
//               The multiplicities of the arcs that this walk crosses do not add up to zero
#pragma once

#include <optional>
#include <string>

#include "plumb/surface/surface.h"

#pragma GCC visibility push(default)
namespace plumb {

/// Returns the first broken invariant and the cells that violate it, or no value if all invariants
/// hold. The cost is linear in the sizes of the mesh, the arrangement and the labels. In addition,
/// each crossing needs rational arithmetic.
std::optional<std::string> audit(const SurfaceDivision& division);

}  // namespace plumb
#pragma GCC visibility pop
