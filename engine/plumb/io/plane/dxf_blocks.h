// The blocks of a drawing, and how inserts place their curves: for the reader of DXF.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "plumb/base/context.h"
#include "plumb/io/plane/dxf_curves.h"
#include "plumb/io/svg/svg_outline.h"
#include "plumb/predicates/point.h"

namespace plumb {

/// Curves and inserts that were read together. They belong to one block, or to the drawing itself.
struct DxfBlock {
  Point2 base;  ///< The point of the block that an insert places.
  std::uint32_t first_curve = 0, end_curve = 0;
  std::uint32_t first_insert = 0, end_insert = 0;
};

/// A block that is placed in a rectangular array.
struct DxfInsert {
  std::string_view block;  ///< The name of the block.
  std::string_view layer;  ///< The layer that replaces layer 0 of the block.
  SvgTransform placing;    ///< Applied after the scales and the step of the array.
  Point2 scale{1, 1};
  Point2 spacing;  ///< The distances of columns and of rows.
  std::uint32_t columns = 1, rows = 1;
  std::size_t line = 0;  ///< The place where the text states it.
};

/// Orders names of blocks. As in all programs that draw, large and small letters are equal.
struct DxfNameOrder {
  bool operator()(std::string_view a, std::string_view b) const;
};

/// Everything that a drawing states.
struct DxfContent {
  DxfCurves curves;
  std::vector<DxfInsert> inserts;
  DxfBlock drawing;
  std::map<std::string_view, DxfBlock, DxfNameOrder>
      blocks;  ///< The blocks that are inserted, by name.
};

/// Returns the curves of the drawing and of its inserts on a layer, each with its final transform
/// and layer, in the order in which the text states them. An empty name stands for all layers.
/// Inserts of blocks that are missing are left out. `charge` pays for the result. Errors at the
/// line of an insert in file `name`: BadShape for a block that contains itself; ResourceLimit
/// beyond 64 nested blocks or 2^20 placed entities, and as the context says; Cancelled.
std::vector<DxfCurve> placed_curves(const DxfContent& content, std::string_view only_layer,
                                    const std::string& name, MemoryCharge& charge,
                                    Context& context);

}  // namespace plumb
