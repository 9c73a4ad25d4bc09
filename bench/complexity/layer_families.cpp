// How the check, the repair and the simplifying of layers grow with their features (growth.h says
// how it is measured).
#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

#include "growth.h"
#include "plumb/plane/layer.h"
#include "plumb/plane/layer_simplify.h"
#include "plumb/predicates/error.h"
#include "plumb/testing/dice.h"

namespace plumb::bench {
namespace {

using testing::Dice;

/// Squares with common corners that were moved at random. Of every tenth square, one corner was
/// moved once more, for this square alone, so there are overlaps and gaps.
Layer squares(std::size_t features, bool has_defects) {
  const auto side = static_cast<std::size_t>(std::sqrt(static_cast<double>(features)));
  Dice dice(7);
  const auto moved = [&dice](double by) {
    return (static_cast<double>(dice.below(1U << 20U)) / (1U << 20U) - 0.5) * by;
  };
  std::vector<Point2> corners;
  for (std::size_t y = 0; y <= side; ++y) {
    for (std::size_t x = 0; x <= side; ++x) {
      const double dx = moved(0.6);
      corners.push_back({static_cast<double>(x) + dx, static_cast<double>(y) + moved(0.6)});
    }
  }
  Layer layer;
  const std::size_t row = side + 1;
  for (std::size_t i = 0; i < side * side; ++i) {
    const std::size_t at = i / side * row + i % side;
    for (const std::size_t corner : {at, at + 1, at + row + 1, at + row}) {
      Point2 p = corners[corner];
      if (has_defects && i % 10 == 0 && corner == at) p = {p.x + moved(0.2), p.y + moved(0.2)};
      layer.ring_corners.push_back(static_cast<std::uint32_t>(layer.points.size()));
      layer.points.push_back(p);
    }
    layer.end_ring();
    layer.end_polygon();
    layer.end_feature("", "");
  }
  return layer;
}

template <class Once>
Family family(std::string_view name, std::string_view claim, bool has_defects, Once once) {
  return {name,
          claim,
          "features",
          {1, 1},
          sizes_between(1000, 1000000, 3.1622776601683795),
          [has_defects, once](std::size_t features) {
            const auto layer = std::make_shared<const Layer>(squares(features, has_defects));
            return measured(static_cast<double>(layer->feature_count()),
                            [layer, once] { return once(*layer); });
          },
          1.15};
}

std::vector<Family> families() {
  return {family("layer-check", "check_layer() of a coverage", false,
                 [](const Layer& layer) {
                   LayerReport report = check_layer(layer);
                   PLUMB_CHECK(!report.has_defects());
                   return report;
                 }),
          family("layer-repair", "repair_layer(), with a defect at each tenth feature", true,
                 [](const Layer& layer) {
                   RepairedLayer repaired = repair_layer(layer);
                   PLUMB_CHECK(repaired.report.has_defects());
                   return repaired;
                 }),
          family("layer-simplify", "simplify_layer() of a coverage with overlaps", true,
                 [](const Layer& layer) {
                   return simplify_layer(layer, {std::numeric_limits<double>::infinity(), 0.5});
                 })};
}

}  // namespace
}  // namespace plumb::bench

int main(int argc, char** argv) {
  return plumb::bench::growth_main("Growth of layers", plumb::bench::families(), argc, argv);
}
