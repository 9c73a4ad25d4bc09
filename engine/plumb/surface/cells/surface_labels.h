// Labels of cells: for each shape the integer function that jumps across arcs by the multiplicity
// of the shape there.
//
// Main flow of label_cells():
//  1. tree       grows a tree of cells in each component of the mesh, from the cell where labels
//                are to be zero if it is known, else from the largest (at the border, if there is
//                one)
//  2. potential  computes labels along the tree, zero at its root; sparse
//  3. check      checks every other edge of the graph; a shape that fails has no label, and a cycle
//                proves it
//  4. shift      shifts each shape and component to its zero, or to the level that is given
//
// Cost: O(edges + sum of the lengths of labels and jumps). Proof: docs/design/surface.md, section
// Labels.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "plumb/base/context.h"
#include "plumb/surface/cells/surface_cells.h"
#include "plumb/surface/surface.h"

#pragma GCC visibility push(default)
namespace plumb {

/// How labels change across cell edges: for each edge a sparse vector over shapes, from `from` to
/// `to`.
struct CellJumps {
  explicit CellJumps(Context& context) : memory(std::make_unique<MemoryCharge>(context)) {}

  std::unique_ptr<MemoryCharge> memory;  ///< The charge of the lists; released with them.
  std::vector<std::uint32_t> begin = {0};
  std::vector<SignedEntry> entries;
  std::span<const SignedEntry> operator[](std::size_t e) const {
    return std::span(entries).subspan(begin[e], begin[e + 1] - begin[e]);
  }
};

/// Returns the jumps if every polygon is a shape. Throws what the context throws.
CellJumps jumps_of_polygons(const SurfaceArrangement& arrangement, const SurfaceCells& cells,
                            Context& context);
/// Returns the jumps of shapes that are sums of polygons. Throws what the context throws.
CellJumps jumps_of_shapes(const CellJumps& polygons,
                          std::span<const std::vector<std::uint32_t>> shapes, Context& context);

/// A label that is given.
struct CellLevel {
  std::uint32_t shape;
  CellId cell;
  std::int32_t label;
};

/// Sparse labels of all cells, and what each shape separates.
struct CellLabels {
  std::vector<Separation> separation;  ///< Outcome for each shape.
  std::vector<std::uint32_t> begin;    ///< First entry of each cell, and one past the last.
  std::vector<SignedEntry> entries;
  std::span<const SignedEntry> operator[](CellId c) const {
    return std::span(entries).subspan(begin[c.value()], begin[c.value() + 1] - begin[c.value()]);
  }
};

/// Returns the labels, or for each shape without labels a cycle that proves it. `outside` is the
/// cell where labels are zero, for its component; it may be invalid. `levels` take precedence; at
/// most one for a shape in a component. Throws what the context throws.
CellLabels label_cells(const SurfaceCells& cells, const CellJumps& jumps, std::size_t shapes,
                       CellId outside, std::span<const CellLevel> levels, Context& context);

}  // namespace plumb
#pragma GCC visibility pop
