#include "plumb/plane/arrangement.h"

#include <utility>

#include "plumb/base/refused_memory.h"
#include "plumb/plane/plane_rules.h"
#include "plumb/plane/scene_order.h"

namespace plumb {
namespace {

PlaneComplex arranged_in_order(PlaneScene& scene, OrderedScene ordered, OriginsRule& rule,
                               Context& context) {
  PlaneBuilder<OriginsRule> builder(ordered.scene, rule, context);
  sweep(ordered.scene.points, ordered.scene.curves, ordered.scene.stops, builder, context);
  builder.rename_points(ordered.point);
  ordered = {};
  return builder.build(std::move(scene.points));
}

// Where some points are no doubles, exact arithmetic takes more time than the caches.
bool is_worth_ordering(const PlaneScene& scene) {
  return scene.points.crossings.empty() && scene.points.inputs.all_double();
}

Arrangement arrange(PlaneScene scene, Context& context) {
  const bool is_ordered = is_worth_ordering(scene);
  OrderedScene ordered = is_ordered ? in_sweep_order(scene) : OrderedScene();
  OriginsRule rule(scene.curves.size(), std::move(ordered.curve), context);
  Arrangement result;
  result.complex = is_ordered ? arranged_in_order(scene, std::move(ordered), rule, context)
                              : build_complex(scene, rule, context);
  result.origin_sets = std::move(rule.sets);
  result.origins = std::move(rule.origins);
  return result;
}

}  // namespace

Arrangement arrange(const PlanePoints& points, std::span<const SweepCurve> curves,
                    std::span<const std::uint32_t> isolated, Context& context) try {
  return arrange(
      PlaneScene{points, {curves.begin(), curves.end()}, {isolated.begin(), isolated.end()}},
      context);
} catch (...) {
  rethrow_refused_memory();
}

Arrangement arrange(PointTable2 points, std::span<const SweepSegment> segments,
                    Context& context) try {
  PlaneScene scene;
  scene.points.inputs = std::move(points);
  scene.curves.reserve(segments.size());
  for (const SweepSegment& s : segments) scene.curves.push_back({s.from, s.to, s.from, s.to});
  return arrange(std::move(scene), context);
} catch (...) {
  rethrow_refused_memory();
}

}  // namespace plumb
