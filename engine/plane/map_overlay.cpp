#include "plumb/plane/map_overlay.h"

#include <utility>

#include "plumb/base/refused_memory.h"
#include "plumb/plane/plane_rules.h"

namespace plumb {
namespace {

struct MapsScene {
  PlaneScene scene;
  std::vector<OverlayCurve> sides;

  /// The edges of one map, with the regions beside them.
  void append(const MapReport& report, std::uint32_t operand) {
    const Dcel dcel = to_dcel(report).dcel;
    const auto first = static_cast<std::uint32_t>(scene.points.inputs.size());
    scene.points.inputs.append(report.map.points);
    for (std::size_t i = 0; i < dcel.edge_count(); ++i) {
      const HalfedgeId h = first_half(EdgeId(i));
      const std::uint32_t from = first + dcel.origin(h).value();
      const std::uint32_t to = first + dcel.target(h).value();
      scene.curves.push_back({from, to, from, to});
      sides.push_back({dcel.face(h).value(), dcel.face(twin(h)).value(), EdgeId(i), operand});
    }
  }

  MapOverlay build(Context& context) {
    MapOverlayRule rule(OverlayLabels(scene.curves, std::move(sides), {0, 0}));
    MapOverlay overlay;
    std::vector<FacePair> labels;
    overlay.complex = build_complex(scene, rule, context, &labels);
    overlay.origin.reserve(labels.size());
    for (const FacePair& l : labels) overlay.origin.push_back({l[0], l[1]});
    return overlay;
  }
};

}  // namespace

MapOverlay overlay_maps(const MapReport& first, const MapReport& second, Context& context) try {
  MapsScene maps;
  maps.append(first, 0);
  maps.append(second, 1);
  return maps.build(context);
} catch (...) {
  rethrow_refused_memory();
}

MapOverlay overlay_map(const MapReport& report, Context& context) try {
  MapsScene maps;
  maps.append(report, 0);
  return maps.build(context);
} catch (...) {
  rethrow_refused_memory();
}

}  // namespace plumb
