// Solids of OpenSCAD's surface(): fields of heights, from a text with a matrix or an image.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "plumb/base/context.h"
#include "plumb/space/mesh_arrays.h"

namespace plumb {

/// A field has at most this many heights.
inline constexpr std::uint64_t kMostHeights = std::uint64_t{1} << 24U;

/// Heights at the points (column, row) of a grid, row by row.
struct HeightGrid {
  std::size_t rows = 0, columns = 0;
  std::vector<double> heights;

  double at(std::size_t row, std::size_t column) const { return heights[row * columns + column]; }
};

/// Throws Error{ResourceLimit} if there is too little memory for the solid of a grid. It is called
/// as soon as the size of a grid is known, because reading and building a large grid takes seconds.
void require_room_for_solid(std::size_t rows, std::size_t columns, Context& context);

/// Reads a file: an image if it begins like PNG, otherwise a text. Each line of a text is a row of
/// numbers; blank lines and lines that begin with # are passed over. Heights that are missing at
/// the end of a row are 0. `is_inverted` has an effect on images only. The memory of the grid and
/// of reading is charged to `charge`. Errors: Syntax, NotText and NumberOutOfRange with
/// FILE:LINE:COLUMN, and the errors of read_height_image().
HeightGrid read_heights(std::string_view bytes, const std::string& name, bool is_inverted,
                        MemoryCharge& charge, Context& context);

/// Returns the mesh that OpenSCAD makes of a grid: each square is four triangles that meet in the
/// mean of its corners, and the bottom is the plane 1 below the least height, or below 0. A centred
/// field has the middle of the grid at (0, 0). A grid with one row or column has no faces.
/// The memory of the mesh is charged to `charge`.
PolygonMesh surface_mesh(const HeightGrid& grid, bool is_centred, MemoryCharge& charge,
                         Context& context);

}  // namespace plumb
