// Labels of cells. The label of a shape is a function that assigns an integer to each cell. The
// label on the left side of an arc minus the label on its right side is the multiplicity of the
// shape along the arc.
//
// Main flow of label_cells():
//  1. tree       grows a tree of cells in each component of the mesh. If the caller states a cell
//                in which labels are zero, this cell is the root. Otherwise the root is the largest
//                cell at the mesh border. In a component without border, the root is the largest
//                cell
//  2. potential  computes labels along the tree, starting with zero at the root. Labels are stored
//                as sparse vectors
//  3. check      visits each edge of the graph that is not in the tree. It checks that the labels
//                at the two ends of the edge differ by the jump of the edge. If they do not for
//                some shape, this shape has no label. The edge and the tree then contain a closed
//                walk over cells that proves that there is no label
//  4. shift      adds a constant to the labels of a shape in each component of the mesh. If a level
//                is given for the shape and the component, the constant is chosen so that the
//                labels agree with this level. Otherwise it is chosen by the rules of SurfaceScene
//
// Cost: O(E + L) for E edges of the graph, where L is the number of entries of all labels and
// jumps. Proof: docs/design/surface.md, section Labels.
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

/// The changes of labels along the edges of the graph of cells. Each edge has a sparse vector with
/// one entry for each shape: the label in cell `to` minus the label in cell `from`.
struct CellJumps {
  explicit CellJumps(Context& context) : memory(std::make_unique<MemoryCharge>(context)) {}

  /// The charge for the memory of the two lists below. The charge is released when the lists are
  /// destroyed.
  std::unique_ptr<MemoryCharge> memory;
  std::vector<std::uint32_t> begin = {0};
  std::vector<SignedEntry> entries;
  std::span<const SignedEntry> operator[](std::size_t e) const {
    return std::span(entries).subspan(begin[e], begin[e + 1] - begin[e]);
  }
};

/// Returns the jumps for the polygons, where each polygon is treated as a shape. Throws the errors
/// of the Context.
CellJumps jumps_of_polygons(const SurfaceArrangement& arrangement, const SurfaceCells& cells,
                            Context& context);
/// Returns the jumps for shapes. Each shape is a list of polygons, whose sum it is. Throws the
/// errors of the Context.
CellJumps jumps_of_shapes(const CellJumps& polygons,
                          std::span<const std::vector<std::uint32_t>> shapes, Context& context);

/// A known label of a shape in a cell.
struct CellLevel {
  std::uint32_t shape;
  CellId cell;
  std::int32_t label;
};

/// The labels of all cells as sparse vectors, and for each shape whether it has a label.
struct CellLabels {
  std::vector<Separation> separation;  ///< Whether the label of each shape exists.
  IdVector<CellId, std::uint32_t>
      begin;  ///< The first entry of each cell. The last value is the number of entries.
  std::vector<SignedEntry> entries;
  std::span<const SignedEntry> operator[](CellId c) const {
    return std::span(entries).subspan(begin[c], begin[c.value() + 1] - begin[c]);
  }
};

/// Returns the labels. For each shape without a label, the result has a closed walk over cells that
/// proves that there is no label. In the component of the cell `outside`, labels are zero in this
/// cell; `outside` may be invalid. `levels` take precedence over `outside`. There is at most one
/// level for each pair of a shape and a component. Throws the errors of the Context.
CellLabels label_cells(const SurfaceCells& cells, const CellJumps& jumps, std::size_t shapes,
                       CellId outside, std::span<const CellLevel> levels, Context& context);

}  // namespace plumb
#pragma GCC visibility pop
