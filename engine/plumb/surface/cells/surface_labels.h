// Labels of cells: for each shape the integer function that jumps across arcs by their multiplicity
// there.
//
// Main flow of label_cells():
//  1. tree       of cells, in each component of the mesh, from the cell where labels are to be zero
//                if that is known, else from the largest (at the border, if there is one)
//  2. potential  along the tree, zero at its root; sparse
//  3. check      every other edge of the graph; what fails has no label, and a cycle proves it
//  4. shift      each shape and component to its zero, or to the level that is given
// Cost: O(edges + sum of the lengths of labels and jumps).
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

/// What cell edges do to shapes: the edge's sparse vector over shapes, from `from` to `to`.
struct CellJumps {
  explicit CellJumps(Context& context) : memory(std::make_unique<MemoryCharge>(context)) {}

  std::unique_ptr<MemoryCharge> memory;  ///< theirs; given back with them
  std::vector<std::uint32_t> begin = {0};
  std::vector<SignedEntry> entries;
  std::span<const SignedEntry> operator[](std::size_t e) const {
    return std::span(entries).subspan(begin[e], begin[e + 1] - begin[e]);
  }
};

/// Every polygon is a shape.
CellJumps jumps_of_polygons(const SurfaceArrangement& arrangement, const SurfaceCells& cells,
                            Context& context);
/// Shapes are sums of polygons.
CellJumps jumps_of_shapes(const CellJumps& polygons,
                          std::span<const std::vector<std::uint32_t>> shapes, Context& context);

/// A label that is given.
struct CellLevel {
  std::uint32_t shape;
  CellId cell;
  std::int32_t label;
};

struct CellLabels {
  std::vector<Separation> separation;  ///< per shape
  std::vector<std::uint32_t> begin;    ///< per cell, and one more
  std::vector<SignedEntry> entries;
  std::span<const SignedEntry> operator[](CellId c) const {
    return std::span(entries).subspan(begin[c.value()], begin[c.value() + 1] - begin[c.value()]);
  }
};

/// `outside`: the cell where labels are zero, for its component; may be invalid. `levels` come
/// first; at most one for a shape in a component.
CellLabels label_cells(const SurfaceCells& cells, const CellJumps& jumps, std::size_t shapes,
                       CellId outside, std::span<const CellLevel> levels, Context& context);

}  // namespace plumb
#pragma GCC visibility pop
