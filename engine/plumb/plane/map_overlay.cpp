// The overlay of two checked maps, and the areas of its cells.
//
// Both maps become curves with their regions at the sides, and one sweep that keeps every piece
// (MapOverlayRule) gives the common subdivision with the pair of regions of each face. The areas of
// the faces of each region must add up exactly to the area of the region. This is an independent
// check of the overlay.
//
// Tested by tests/plane/map_overlay_test.cpp.

#include "plumb/plane/map_overlay.h"

#include <utility>

#include "plumb/plane/complex/plane_rules.h"
#include "plumb/plane/plane_measure.h"
#include "plumb/predicates/arithmetic/rational_sum.h"
#include "plumb/predicates/plane/plane_points.h"

namespace plumb {
namespace {

/// One map or two maps as curves of a scene.
struct MapsScene {
  SweepInput scene;
  std::vector<OverlayCurve> sides;

  /// Appends the edges of one map, with the regions beside them.
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

MapOverlay overlay_maps(const MapReport& first, const MapReport& second, Context& context) {
  MapsScene maps;
  maps.append(first, 0);
  maps.append(second, 1);
  return maps.build(context);
}

MapOverlay overlay_map(const MapReport& report, Context& context) {
  MapsScene maps;
  maps.append(report, 0);
  return maps.build(context);
}

namespace {

constexpr std::size_t kBetween = 1024;  // Areas from one checkpoint to the next.

/// Returns the area of a region, or 0 for the unbounded region. Holes are listed clockwise, so
/// their areas are negative.
Rational area_of(const MapReport& report, const MapRegion& region) {
  if (!region.outer) return 0;
  const auto twice = [&report](std::uint32_t cycle) {
    return twice_polygon_area(report.map.points, report.map.cycle(cycle));
  };
  Rational sum = twice(*region.outer);
  for (const std::uint32_t hole : region.holes) sum += twice(hole);
  return sum / 2;
}

std::vector<Rational> areas_of(const MapReport& report, Context& context) {
  std::vector<Rational> areas;
  for (const MapRegion& region : report.regions) {
    if (areas.size() % kBetween == 0) {
      context.checkpoint("areas of regions", areas.size(), report.regions.size());
    }
    areas.push_back(area_of(report, region));
  }
  return areas;
}

/// Returns the bounded regions whose two areas differ.
std::vector<std::uint32_t> differences(const std::vector<Rational>& expected,
                                       const std::vector<RationalSum>& found) {
  std::vector<std::uint32_t> different;
  for (std::uint32_t r = 1; r < expected.size(); ++r) {
    if (expected[r] != found[r].total()) different.push_back(r);
  }
  return different;
}

}  // namespace

OverlayAreas measure(const MapOverlay& overlay, const MapReport& first, const MapReport& second,
                     Context& context) {
  OverlayAreas areas;
  areas.first = areas_of(first, context);
  areas.second = areas_of(second, context);
  std::vector<RationalSum> sum_first(areas.first.size()), sum_second(areas.second.size());
  for (std::size_t f = 0; f < overlay.complex.face_count(); ++f) {
    if (f % kBetween == 0) {
      context.checkpoint("areas of cells", f, overlay.complex.face_count());
    }
    areas.cell.push_back(face_area(overlay.complex, FaceId(f)).value_or(0));
    sum_first[overlay.origin[f].first].add(areas.cell.back());
    sum_second[overlay.origin[f].second].add(areas.cell.back());
  }
  areas.wrong_first = differences(areas.first, sum_first);
  areas.wrong_second = differences(areas.second, sum_second);
  return areas;
}

Rational sum_of(const std::vector<Rational>& areas) {
  RationalSum sum;
  for (const Rational& area : areas) sum.add(area);
  return sum.total();
}

}  // namespace plumb
