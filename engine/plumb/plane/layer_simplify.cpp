// Tested by tests/plane/layer_operations_test.cpp.
#include "plumb/plane/layer_simplify.h"

#include <cstdint>

#include "plumb/plane/layer/border_graph.h"
#include "plumb/plane/layer/covered_cells.h"
#include "plumb/plane/layer/labelled_layer.h"

namespace plumb {

SimplifiedLayer simplify_layer(const Layer& layer, const LayerSimplifyOptions& options,
                               Context& context) {
  const CoveredCells cells(layer, context);
  const RoundedLabels rounded = rounded_labels(cells.complex(), first_features(cells), context);
  BorderGraph borders(rounded.labelled, context);
  borders.simplify(options, context);
  const BorderCounts counts = borders.counts();
  SimplifiedLayer result;
  result.corners_before = counts.before;
  result.corners_after = counts.after;
  result.fixed = counts.fixed;
  result.blocked = counts.blocked;
  result.borders_moved = counts.moved;
  result.layer = layer_of_labels(borders.arranged(context), layer.feature_count(), &layer, context);
  result.overlaps =
      count_overlaps(cells, {0, static_cast<std::uint32_t>(layer.feature_count())}, {});
  result.rounding = rounded.rounding;
  return result;
}

}  // namespace plumb
