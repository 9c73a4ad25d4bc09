// Labels of cells. The label of a shape is an integer function on cells. From one side of an arc to
// the other, it changes by the multiplicity of the shape along the arc.
//
// Main flow of label_cells():
//  1. tree       grows a tree of cells in each component of the mesh. The root is the cell where
//                labels must be zero, if it is known. Otherwise it is the largest cell at the mesh
//                border, or the largest cell if there is no border
//  2. potential  computes labels along the tree, zero at its root; sparse
//  3. check      checks the edges of the graph that are not in the tree. A shape that fails has no
//                label, and a cycle proves it
//  4. shift      shifts the labels of each shape in each component to its zero, or to the level
//                that is given
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

/// The changes of labels along the edges of the graph of cells. Each edge has a sparse vector over
/// shapes: label in cell `to` minus label in cell `from`.
struct CellJumps {
  explicit CellJumps(Context& context) : memory(std::make_unique<MemoryCharge>(context)) {}

  /// The charge for the memory of the lists; it is released together with them.
  std::unique_ptr<MemoryCharge> memory;
  std::vector<std::uint32_t> begin = {0};
  std::vector<SignedEntry> entries;
  std::span<const SignedEntry> operator[](std::size_t e) const {
    return std::span(entries).subspan(begin[e], begin[e + 1] - begin[e]);
  }
};

/// Returns the jumps of polygons, each as a shape of its own. Throws what the context throws.
CellJumps jumps_of_polygons(const SurfaceArrangement& arrangement, const SurfaceCells& cells,
                            Context& context);
/// Returns the jumps of shapes that are sums of polygons. Throws what the context throws.
CellJumps jumps_of_shapes(const CellJumps& polygons,
                          std::span<const std::vector<std::uint32_t>> shapes, Context& context);

/// A known label of a shape in a cell.
struct CellLevel {
  std::uint32_t shape;
  CellId cell;
  std::int32_t label;
};

/// Sparse labels of all cells, and whether each shape separates the surface.
struct CellLabels {
  std::vector<Separation> separation;  ///< Whether the label of each shape exists.
  std::vector<std::uint32_t> begin;    ///< First entry of each cell, and one past the last.
  std::vector<SignedEntry> entries;
  std::span<const SignedEntry> operator[](CellId c) const {
    return std::span(entries).subspan(begin[c.value()], begin[c.value() + 1] - begin[c.value()]);
  }
};

/// Returns the labels. For each shape without labels, returns a cycle that proves it. `outside` is
/// the cell of its component where labels are zero; it may be invalid. `levels` take precedence
/// over `outside`. There is at most one level for each pair of a shape and a component. Throws what
/// the context throws.
CellLabels label_cells(const SurfaceCells& cells, const CellJumps& jumps, std::size_t shapes,
                       CellId outside, std::span<const CellLevel> levels, Context& context);

}  // namespace plumb
#pragma GCC visibility pop
