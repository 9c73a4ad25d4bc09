// Divided surfaces as files: triangles with their cells, the graph of cells, borders as scenes.
#pragma once

#include <cstdint>
#include <ostream>
#include <span>
#include <string>
#include <vector>

#include "plumb/surface/surface.h"
#include "plumb/surface/surface_cells.h"
#include "plumb/surface/triangulation.h"

#pragma GCC visibility push(default)
namespace plumb {

/// Which cells are written; empty: all.
using CellChoice = std::span<const std::uint8_t>;

/// Doubles; a group `g cell_3` for each cell.
void write_surface_obj(std::ostream& out, const SurfaceTriangulation& triangles, std::size_t cells,
                       CellChoice chosen);
/// In text, doubles; faces have a property `cell`.
void write_surface_ply(std::ostream& out, const SurfaceTriangulation& triangles, CellChoice chosen);

/// An edge of the graph of cells, from the right of its first polygon to the left: what labels grow by.
struct CellStep {
  CellId from;                        ///< to the right of the polygons
  CellId to;                          ///< to the left of them
  std::vector<SignedEntry> polygons;  ///< ascending; the first is positive
};
/// The edge of the graph, turned so that its first polygon counts positive.
CellStep upward_step(const SurfaceDivision& division, const CellEdge& edge);

/// Graphviz: a node a cell with its label and area, an edge for each pair of cells and polygons between them
/// (upward_step), named by number: "+0 -2*3".
void write_cell_graph(std::ostream& out, const SurfaceDivision& division, CellChoice chosen);

/// A scene that reads back as the same points, exactly: JSON, `model` as given. Every point of a polygon is a
/// control point of the scene.
void write_scene(std::ostream& out, const SurfaceScene& scene, const std::string& model);

}  // namespace plumb
#pragma GCC visibility pop
