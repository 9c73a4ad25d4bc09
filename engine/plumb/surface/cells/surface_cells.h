// The cells into which polygons cut a surface, the graph of cells, and the borders of selected
// cells. In the graph, two cells are joined if they are neighbours across an arc.
//
// Main flow of make_cells():
//  1. join      joins pieces that are adjacent at a half-edge without an arc, and also faces
//               without polygons that are adjacent at a mesh edge (union-find)
//  2. number    numbers cells in the order of the first face in each cell
//  3. measure   computes areas, and finds the cells at the mesh border
//  4. graph     makes an edge of the graph for each arc between cells; equal edges are listed once
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "plumb/surface/cells/surface_arrangement.h"
#include "plumb/surface/surface_path.h"

#pragma GCC visibility push(default)
namespace plumb {

/// An edge of the graph of cells. The difference of the labels of polygons, label in `to` minus
/// label in `from`, is `sign` times the bundle with the index `bundle` (SurfaceBundles). `from` is
/// never greater than `to`.
struct CellEdge {
  CellId from;
  CellId to;
  std::uint32_t bundle;
  std::int32_t sign;
};

/// The cells and their graph.
struct SurfaceCells {
  IdVector<PieceId, CellId> of_piece;
  IdVector<FaceId, CellId>
      of_face;  ///< The cell that contains each face; valid only for faces that are not divided.
  IdVector<CellId, double> area;  ///< The area of each cell, but at most the largest double.
  IdVector<CellId, std::uint32_t>
      component;  ///< The component of the mesh that contains each cell.
  IdVector<CellId, std::uint8_t> is_at_border;
  std::vector<CellEdge> edges;  ///< Distinct edges, sorted by (from, to).

  std::size_t size() const { return area.size(); }
};

/// Returns the cells of a subdivision. The cost is nearly linear in the sizes of the mesh and the
/// arrangement.
SurfaceCells make_cells(const SurfaceMesh& mesh, const SurfaceArrangement& arrangement,
                        Context& context);

/// Returns the cell at the first corner of a face.
CellId cell_at_corner(const SurfaceArrangement& arrangement, const SurfaceCells& cells, FaceId f);

// The border of selected cells as closed polygons.
//
// Main flow of trace_borders():
//  1. start     begins a loop at each half-edge of an arc that has a selected cell to its left and
//               an unselected cell to its right. Half-edges that an earlier loop contains are
//               skipped
//  2. follow    follows the border of the selected cells, which are to the left. Several borders
//               may meet in a point. Then the loop turns around the point through selected cells,
//               and continues with the first border that it reaches. The angular order of
//               half-edges around the point is exact. Where selected cells end at the mesh border,
//               the loop follows the mesh border
//  3. name      chooses the corners of the loop. The corners are the control points of the given
//               polygons (`generators`), and the points where the loop changes from one of these
//               polygons to another. Crossings with other polygons are not corners, because the
//               border runs straight through them
//
// Cost: O(half-edges of the arrangement + half-edges of the mesh border that are followed).

/// Returns the border of the selected cells as polygons. `is_selected` has one entry for each cell.
/// `generators` lists polygons in ascending order. If a control point of one of these polygons lies
/// on the border, it becomes a control point of the border. Loops that run only along the mesh
/// border are omitted. Throws the errors of the Context.
SurfacePolygons trace_borders(const SurfacePolygons& polygons,
                              const SurfaceArrangement& arrangement, const SurfaceCells& cells,
                              std::span<const std::uint8_t> is_selected,
                              std::span<const std::uint32_t> generators, Context& context);

}  // namespace plumb
#pragma GCC visibility pop
