// Writes divided surfaces: triangles with their cells (OBJ, PLY), the graph of cells (Graphviz),
// and borders as scenes (JSON).
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

/// Selects the cells that are written: one flag for each cell. An empty span selects all cells.
using CellChoice = std::span<const std::uint8_t>;

/// Writes the triangles as OBJ with doubles as coordinates, and a group such as `g cell_3` for each
/// of the `cells` cells.
void write_surface_obj(std::ostream& out, const SurfaceTriangulation& triangles, std::size_t cells,
                       CellChoice chosen);
/// Writes the triangles as text PLY with doubles as coordinates. Each face has a property `cell`.
void write_surface_ply(std::ostream& out, const SurfaceTriangulation& triangles, CellChoice chosen);

/// An edge of the graph of cells, directed from the right of its first polygon to the left. The
/// label of `to` is the label of `from` plus the entries of `polygons`.
struct CellStep {
  CellId from;                        ///< The cell to the right of the first polygon.
  CellId to;                          ///< The cell to the left of the first polygon.
  std::vector<SignedEntry> polygons;  ///< Signed polygons, ascending; the first is positive.
};
/// Returns the edge of the graph, directed so that its first polygon counts as positive.
CellStep upward_step(const SurfaceDivision& division, const CellEdge& edge);

/// Writes the graph of cells for Graphviz: a node for each cell, with its label and area, and an
/// edge for each pair of cells and set of polygons between them (upward_step). An edge lists its
/// polygons by number: "+0 -2*3".
void write_cell_graph(std::ostream& out, const SurfaceDivision& division, CellChoice chosen);

/// Writes a scene as JSON from which read_scene_file() restores exactly the same points. Every
/// point of a polygon becomes a control point of the scene; `model` is written as given.
void write_scene(std::ostream& out, const SurfaceScene& scene, const std::string& model);

}  // namespace plumb
#pragma GCC visibility pop
