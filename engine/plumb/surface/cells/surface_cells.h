// The cells into which polygons cut a surface, the graph of cells that are neighbours across arcs,
// and the borders of selected cells.
//
// Main flow of make_cells():
//  1. join      joins pieces across half-edges without arc, and faces across mesh edges
//               (union-find)
//  2. number    numbers cells in the order of their first face
//  3. measure   computes areas, and finds the cells at the mesh border
//  4. graph     lists the arcs between cells; equal arcs are listed once
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "plumb/surface/cells/surface_arrangement.h"
#include "plumb/surface/surface_path.h"

#pragma GCC visibility push(default)
namespace plumb {

/// An edge of the graph of cells. From cell `from` to cell `to`, labels change by `sign` times the
/// bundle (SurfaceBundles). from <= to.
struct CellEdge {
  CellId from;
  CellId to;
  std::uint32_t bundle;
  std::int32_t sign;
};

/// The cells and their graph.
struct SurfaceCells {
  std::vector<CellId> of_piece;
  std::vector<CellId> of_face;  ///< Cell of each face that is not touched.
  std::vector<double> area;  ///< The area of each cell; the largest double if the area exceeds it.
  std::vector<std::uint32_t> component;  ///< The component of the mesh that contains each cell.
  std::vector<std::uint8_t> is_at_border;
  std::vector<CellEdge> edges;  ///< Distinct edges, sorted by (from, to).

  std::size_t size() const { return area.size(); }
};

/// Returns the cells of a subdivision. Cost: nearly O(mesh + arrangement).
SurfaceCells make_cells(const SurfaceMesh& mesh, const SurfaceArrangement& arrangement,
                        Context& context);

/// Returns the cell at the first corner of a face.
CellId cell_at_corner(const SurfaceArrangement& arrangement, const SurfaceCells& cells, FaceId f);

// The border of selected cells as closed polygons.
//
// Main flow of trace_borders():
//  1. start     begins at each half-edge of an arc that has a selected cell to its left and an
//               unselected cell to its right, unless a loop has used this half-edge
//  2. follow    follows the border with the selected cells to its left. At a point where several
//               borders meet, it turns about the point within the selected cells to the next
//               border; half-edges are in exact angular order. It follows the mesh border where the
//               selected cells end there
//  3. name      chooses the corners: control points of generators, and points where two strands of
//               generators meet. Crossings with other polygons are left out, because the border
//               runs straight through them
//
// Cost: O(half-edges of the arrangement + half-edges of the mesh border that are followed).

/// Returns the border of the selected cells as polygons. `is_selected` has one entry for each cell.
/// `generators` lists polygons in ascending order; their control points become control points of
/// the border. Loops that consist of mesh border alone are left out. Throws what the context
/// throws.
SurfacePolygons trace_borders(const SurfacePolygons& polygons,
                              const SurfaceArrangement& arrangement, const SurfaceCells& cells,
                              std::span<const std::uint8_t> is_selected,
                              std::span<const std::uint32_t> generators, Context& context);

}  // namespace plumb
#pragma GCC visibility pop
