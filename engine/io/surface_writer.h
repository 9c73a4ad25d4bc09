// Divided surfaces as files: triangles with their cells, the graph of cells, borders as scenes.
#pragma once

#include <cstdint>
#include <ostream>
#include <span>
#include <string>

#include "plumb/surface/surface.h"
#include "plumb/surface/triangulation.h"

namespace plumb {

/// Which cells are written; empty: all.
using CellChoice = std::span<const std::uint8_t>;

/// Doubles; a group `g cell_3` for each cell.
void write_surface_obj(std::ostream& out, const SurfaceTriangulation& triangles, std::size_t cells,
                       CellChoice chosen);
/// In text, doubles; faces have a property `cell`.
void write_surface_ply(std::ostream& out, const SurfaceTriangulation& triangles, CellChoice chosen);

/// Graphviz: a node a cell with its label and area, an edge for each pair of cells and what is crossed between them:
/// from the right of the polygons to their left.
void write_cell_graph(std::ostream& out, const SurfaceDivision& division, CellChoice chosen);

/// Polygons over the mesh as a scene that reads back as the same points, exactly: JSON, `model` as given. All of
/// them are one shape.
void write_scene(std::ostream& out, const SurfacePolygons& polygons, const std::string& model);

}  // namespace plumb
