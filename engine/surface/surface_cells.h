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

#include "plumb/surface/surface_arrangement.h"

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

}  // namespace plumb
#pragma GCC visibility pop
