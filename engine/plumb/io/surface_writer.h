// Writes divided surfaces in several formats:
//   - OBJ and PLY: the triangles, each with the cell to which it belongs
//   - Graphviz: the graph of the cells
//   - JSON: the borders of cells as a scene
#pragma once

#include <cstdint>
#include <iosfwd>
#include <span>
#include <string>
#include <vector>

#include "plumb/surface/cells/surface_cells.h"
#include "plumb/surface/surface.h"
#include "plumb/surface/triangulation.h"

#pragma GCC visibility push(default)
namespace plumb {

/// Selects the cells that are written. The span has one flag for each cell; a flag other than 0
/// selects the cell. An empty span selects all cells.
using CellChoice = std::span<const std::uint8_t>;

/// Writes the triangles of the chosen cells as OBJ. Coordinates are doubles. Each cell is a group,
/// such as `g cell_3`. The number of all cells is `cells`.
void write_surface_obj(std::ostream& out, const SurfaceTriangulation& triangles, std::size_t cells,
                       CellChoice chosen);
/// Writes the triangles of the chosen cells as text PLY. Coordinates are doubles. Each face has a
/// property `cell`, the index of its cell.
void write_surface_ply(std::ostream& out, const SurfaceTriangulation& triangles, CellChoice chosen);

/// A directed edge of the graph of cells. It leads from the cell to the right of its first polygon
/// to the cell to the left of this polygon. The label of `to` is the sum of the label of `from` and
/// the entries of `polygons`.
struct CellStep {
  CellId from;  ///< The cell to the right of the first polygon.
  CellId to;    ///< The cell to the left of the first polygon.
  /// The polygons between the two cells, in ascending order. The entry of a polygon states by how
  /// much its number in the label grows. The value of the first entry is positive.
  std::vector<SignedEntry> polygons;
};
/// Returns an edge of the graph, directed so that the entry of its first polygon is positive.
CellStep upward_step(const SurfaceDivision& division, const CellEdge& edge);

/// Writes the graph of the chosen cells for Graphviz. The graph has one node for each cell, with
/// the label and area of the cell. It has one edge for each pair of cells and each set of polygons
/// between them, directed as upward_step() directs it. An edge lists its polygons by index, as in
/// "+0 -2*3".
void write_cell_graph(std::ostream& out, const SurfaceDivision& division, CellChoice chosen);

/// Writes a scene as JSON. read_scene_file() reads exactly the same points from this text. Every
/// point of a polygon becomes a control point of the scene. `model` is written unchanged as the
/// path of the model.
void write_scene(std::ostream& out, const SurfaceScene& scene, const std::string& model);

}  // namespace plumb
#pragma GCC visibility pop
