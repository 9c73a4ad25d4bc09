#include "plumb/plane/overlay_areas.h"

#include "plumb/base/refused_memory.h"
#include "plumb/plane/plane_measure.h"
#include "plumb/predicates/polygon.h"
#include "plumb/predicates/rational_sum.h"

namespace plumb {
namespace {

constexpr std::size_t kBetween = 1024;  // areas from one checkpoint to the next

/// Holes are listed clockwise: their areas are negative.
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
                     Context& context) try {
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
} catch (...) {
  rethrow_refused_memory();
}

Rational sum_of(const std::vector<Rational>& areas) {
  RationalSum sum;
  for (const Rational& area : areas) sum.add(area);
  return sum.total();
}

}  // namespace plumb
