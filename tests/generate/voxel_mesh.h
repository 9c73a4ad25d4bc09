// Solids of unit cubes: the surface of any set of cells of a grid, non-manifold where cells meet in
// an edge or vertex, with voids and components as they come.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "plumb/space/mesh_arrays.h"
#include "plumb/testing/dice.h"

namespace plumb::testing {

struct VoxelGrid {
  std::array<int, 3> size;
  std::vector<std::uint8_t> is_full;  ///< x fastest, then y

  explicit VoxelGrid(const std::array<int, 3>& cells)
      : size(cells), is_full(static_cast<std::size_t>(cells[0] * cells[1] * cells[2]), 0) {}
  std::uint8_t& at(int x, int y, int z) {
    return is_full[static_cast<std::size_t>(x + size[0] * (y + size[1] * z))];
  }
  /// 0 outside of the grid.
  bool holds(int x, int y, int z) const;
};

/// A square for each side of a full cell without a full neighbour.
PolygonMesh voxel_mesh(const VoxelGrid& grid);

/// Each cell full with a chance of `tenths` in ten; if none is, one.
VoxelGrid random_voxels(Dice& dice, const std::array<int, 3>& size, int tenths);
/// A plate with `holes` by `holes` square holes, a cell apart.
VoxelGrid pierced_plate(int holes);
/// Columns of random heights.
VoxelGrid random_terrain(Dice& dice, int width, int depth, int height);

/// The prism over a star with n tips.
PolygonMesh star_prism(int tips);
/// The cone over a polygon of so many sides, of triangles around its apex and around the middle of
/// its base.
PolygonMesh cone_mesh(int sides, double height);
/// The prism over a comb of so many teeth.
PolygonMesh comb_prism(int teeth);
/// A block with `top` notches along y from above and `bottom` notches along x from below, that
/// do not reach each other; their depths differ, so that no plane holds two of their edges.
PolygonMesh comb_block(int top, int bottom);
/// A block with n notches from above, along x, and n from below, along y, whose bottoms nearly
/// touch where they pass each other: along the lines of the saddle z = x y. The worst known for
/// convex pieces: about n^2 are needed.
PolygonMesh saddle_block(int n);

}  // namespace plumb::testing
