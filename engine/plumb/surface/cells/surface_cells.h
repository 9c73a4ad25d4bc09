// The cells that polygons cut a surface into, and which lie across arcs from each other.
//
// Main flow of make_cells():
//  1. join      pieces across half-edges without arc, faces across mesh edges (union-find)
//  2. number    cells in the order of their first face
//  3. measure   areas, which cells are at the mesh border
//  4. graph     arcs between cells; equal ones once
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "plumb/surface/cells/surface_arrangement.h"
#include "plumb/surface/surface_path.h"

#pragma GCC visibility push(default)
namespace plumb {

/// From cell `from` to cell `to` labels grow by sign times the bundle. from <= to.
struct CellEdge {
  CellId from;
  CellId to;
  std::uint32_t bundle;
  std::int32_t sign;
};

struct SurfaceCells {
  std::vector<CellId> of_piece;
  std::vector<CellId> of_face;           ///< of faces that are not touched
  std::vector<double> area;              ///< per cell; beyond doubles the largest
  std::vector<std::uint32_t> component;  ///< of the mesh
  std::vector<std::uint8_t> is_at_border;
  std::vector<CellEdge> edges;  ///< different ones; by (from, to)

  std::size_t size() const { return area.size(); }
};

/// O(mesh + arrangement), nearly.
SurfaceCells make_cells(const SurfaceMesh& mesh, const SurfaceArrangement& arrangement,
                        Context& context);

/// The cell at the first corner of a face.
CellId cell_at_corner(const SurfaceArrangement& arrangement, const SurfaceCells& cells, FaceId f);

// The border of selected cells as closed polygons.
//
// Main flow of trace_borders():
//  1. start     at each half-edge of an arc with a selected cell to its left and another, not
//               selected, to its right, that no loop has used
//  2. follow    around the selected side: where several borders meet in a point, turning about it
//               within the selected cells (their exact angular order is that of the half-edges) to
//               the next border; along the mesh border where the selected cells end there
//  3. name      corners: control points of generators, and points where two strands of generators
//               meet. Crossings with other polygons are left out: the border runs straight through
//               them.
// Cost: O(half-edges of the arrangement), and of the mesh border where it is followed.

/// `is_selected` per cell; `generators` ascending. Loops that are nothing but mesh border are left
/// out.
SurfacePolygons trace_borders(const SurfacePolygons& polygons,
                              const SurfaceArrangement& arrangement, const SurfaceCells& cells,
                              std::span<const std::uint8_t> is_selected,
                              std::span<const std::uint32_t> generators, Context& context);

}  // namespace plumb
#pragma GCC visibility pop
