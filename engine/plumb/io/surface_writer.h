// Writes divided surfaces in several formats:
//   - OBJ and PLY: the triangles, each with the cell to which it belongs
//   - Graphviz: the graph of the cells
//   - JSON: polygons on the surface, such as the borders of cells, as a scene
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

/// Selects the cells that are written. The span has one flag for each cell. A cell is selected if
/// its flag is not 0. An empty span selects all cells.
using CellChoice = std::span<const std::uint8_t>;

/// Writes the triangles of the chosen cells as OBJ. Coordinates are doubles. The triangles of a
/// cell form a group; the group of cell 3 is `g cell_3`. `cells` is the number of all cells of the
/// divided surface.
void write_surface_obj(std::ostream& out, const SurfaceTriangulation& triangles, std::size_t cells,
                       CellChoice chosen);
/// Writes the triangles of the chosen cells as text PLY. Coordinates are doubles. Each triangle has
/// a property `cell`, the index of its cell.
void write_surface_ply(std::ostream& out, const SurfaceTriangulation& triangles, CellChoice chosen);

/// A directed edge of the graph of cells. The edge joins two cells that share a part of their
/// borders. The polygons that run along this part are listed in `polygons`. The first of these
/// polygons determines the direction of the edge. The edge leads from the cell to the right of this
/// polygon to the cell to the left of this polygon. The label of `to` is the sum of the label of
/// `from` and the entries of `polygons`.
struct CellStep {
  CellId from;  ///< The cell to the right of the first polygon.
  CellId to;    ///< The cell to the left of the first polygon.
  /// The polygons between the two cells, in ascending order of their indices. Each entry consists
  /// of the index of a polygon and a value. The value is the coefficient of this polygon in the
  /// label of `to`, minus its coefficient in the label of `from`. The value of the first entry is
  /// positive.
  std::vector<SignedEntry> polygons;
};
/// Returns an edge of the graph, directed so that the entry of its first polygon is positive.
CellStep upward_step(const SurfaceDivision& division, const CellEdge& edge);

/// Writes the graph of the chosen cells for Graphviz. The graph has one node for each chosen cell.
/// The node shows the label and the area of the cell. Two chosen cells can be neighbours along
/// several parts of their borders. If the same polygons run along two such parts, the two parts are
/// represented by one edge of the graph. Otherwise they are represented by different edges. The
/// edge has the direction that upward_step() returns. The text of an edge lists its polygons, as in
/// "+0 -2*3". Each entry consists of a sign, a factor followed by "*" unless the factor is 1, and
/// the index of a polygon.
void write_cell_graph(std::ostream& out, const SurfaceDivision& division, CellChoice chosen);

/// Writes a scene as JSON. read_scene_file() reads exactly the same points from this text. Every
/// point of a polygon becomes a control point in the file. `model` is the path of the model and is
/// written unchanged.
void write_scene(std::ostream& out, const SurfaceScene& scene, const std::string& model);

}  // namespace plumb
#pragma GCC visibility pop
