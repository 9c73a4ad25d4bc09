// Tested by tests/plane/layer_operations_test.cpp.
#include "plumb/plane/layer_dissolve.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "plumb/plane/layer/covered_cells.h"
#include "plumb/plane/layer/labelled_layer.h"
#include "plumb/predicates/error.h"

namespace plumb {

DissolvedLayer dissolve_layer(const Layer& layer, std::span<const std::uint32_t> group,
                              std::size_t group_count, Context& context) {
  const bool is_each_right = group.size() == layer.feature_count() &&
                             std::all_of(group.begin(), group.end(), [&](std::uint32_t g) {
                               return g < group_count || g == LayerRegion::kNobody;
                             });
  if (!is_each_right) throw Error(ErrorCode::BadArgument, "each feature needs a group");
  if (group_count >= LayerRegion::kNobody) throw Error(ErrorCode::BadArgument, "too many groups");
  constexpr std::uint64_t kGroupBytes = 48;
  // This memory remains charged, because the layer that is returned has the groups.
  context.charge_memory(kGroupBytes * group_count, "the groups");
  const auto features = static_cast<std::uint32_t>(layer.feature_count());
  const CoveredCells cells(layer, context);
  std::vector<std::uint32_t> label(cells.complex().face_count(), kNoLabel);
  for (std::size_t f = 0; f < label.size(); ++f) {
    for (const std::uint32_t feature : cells.features(FaceId(f))) {
      if (label[f] == kNoLabel) label[f] = group[feature];
    }
  }
  const RoundedLabels rounded = rounded_labels(cells.complex(), label, context);
  Layer result = layer_of_labels(rounded.labelled, group_count, nullptr, context);
  result.crs = layer.crs;
  return {std::move(result), count_overlaps(cells, {0, features}, group), rounded.rounding};
}

}  // namespace plumb
