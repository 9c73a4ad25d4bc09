#include "plumb/plane/arrangement.h"

#include <algorithm>
#include <utility>

#include "plumb/plane/plane_rules.h"
#include "plumb/plane/scene_order.h"

namespace plumb {
namespace {

PlaneComplex arranged_in_order(PlaneScene& scene, OriginsRule& rule, Context& context) {
  OrderedScene ordered = in_sweep_order(scene);
  PlaneBuilder<OriginsRule> builder(ordered.scene, rule, context);
  sweep(ordered.scene.points, ordered.scene.curves, ordered.scene.stops, builder, context);
  builder.rename_points(ordered.point);
  for (SegmentId& s : rule.origins) s = ordered.curve[s.value()];
  ordered = {};
  return builder.build(std::move(scene.points));
}

// Where some points are no doubles, exact arithmetic takes more time than the caches.
bool is_worth_ordering(const PlaneScene& scene) {
  return scene.points.crossings.empty() && scene.points.inputs.all_double();
}

Arrangement arrange(PlaneScene scene, Context& context) {
  OriginsRule rule;
  Arrangement result;
  result.complex = is_worth_ordering(scene) ? arranged_in_order(scene, rule, context)
                                            : build_complex(scene, rule, context);
  result.origin_begin = std::move(rule.origin_begin);
  result.origins = std::move(rule.origins);
  for (std::size_t e = 0; e + 1 < result.origin_begin.size(); ++e) {
    std::sort(result.origins.begin() + result.origin_begin[e],
              result.origins.begin() + result.origin_begin[e + 1]);
  }
  return result;
}

}  // namespace

Arrangement arrange(const PlanePoints& points, std::span<const SweepCurve> curves,
                    std::span<const std::uint32_t> isolated, Context& context) {
  return arrange(
      PlaneScene{points, {curves.begin(), curves.end()}, {isolated.begin(), isolated.end()}},
      context);
}

Arrangement arrange(PointTable2 points, std::span<const SweepSegment> segments, Context& context) {
  PlaneScene scene;
  scene.points.inputs = std::move(points);
  scene.curves.reserve(segments.size());
  for (const SweepSegment& s : segments) scene.curves.push_back({s.from, s.to, s.from, s.to});
  return arrange(std::move(scene), context);
}

}  // namespace plumb
