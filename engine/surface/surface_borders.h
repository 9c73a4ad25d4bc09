// The border of selected cells as closed polygons.
//
// Main flow of trace_borders():
//  1. start     at each half-edge of an arc with a selected cell to its left and another, not selected, to its
//               right, that no loop has used
//  2. follow    around the selected side: where several borders meet in a point, turning about it within the
//               selected cells (their exact angular order is that of the half-edges) to the next border; along the
//               mesh border where the selected cells end there
//  3. name      corners: control points of generators, and points where two strands of generators meet.
//               Crossings with other polygons are left out: the border runs straight through them.
// Cost: O(half-edges of the arrangement), and of the mesh border where it is followed.
#pragma once

#include <cstdint>
#include <span>

#include "plumb/surface/surface_cells.h"
#include "plumb/surface/surface_path.h"

#pragma GCC visibility push(default)
namespace plumb {

/// `is_selected` per cell; `generators` ascending. Loops that are nothing but mesh border are left out.
SurfacePolygons trace_borders(const SurfacePolygons& polygons,
                              const SurfaceArrangement& arrangement, const SurfaceCells& cells,
                              std::span<const std::uint8_t> is_selected,
                              std::span<const std::uint32_t> generators, Context& context);

}  // namespace plumb
#pragma GCC visibility pop
