// Dissolving, overlaying and simplifying two layers: every result is a coverage of doubles, exact
// areas add up, simplifying keeps all rings and ends where a second run ends, and a layer survives
// TopoJSON. Repair covers the gaps of its report and nothing else, also gaps that open outwards,
// and a second repair changes nothing.
//
// Input: a program of records of four bytes, {shape, p, q, r}: a triangle or a parallelogram of
// three points, a nibble for each coordinate. The bits of the first byte say to which layer the
// shape belongs, whether it is a parallelogram, whether it begins a new feature, and to which group
// its feature belongs.
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>
#include <sstream>
#include <string>
#include <vector>

#include "plumb/io/layer_io.h"
#include "plumb/plane/layer.h"
#include "plumb/plane/layer_dissolve.h"
#include "plumb/plane/layer_overlay.h"
#include "plumb/plane/layer_simplify.h"
#include "plumb/predicates/rounding.h"
#include "record_target.h"

namespace plumb::testing {
namespace {

constexpr std::size_t kRecord = 4;
constexpr std::size_t kMostShapes = 8;

std::string geojson(const Layer& layer) {
  std::ostringstream out;
  write_layer_geojson(out, layer);
  return out.str();
}

std::string topojson(const Layer& layer) {
  std::ostringstream out;
  write_layer_topojson(out, layer);
  return out.str();
}

/// Two layers, and a group for each feature of the first one.
struct Layers {
  Layer layer[2];
  std::vector<std::uint32_t> group;
};

void add_shape(std::span<const std::uint8_t> record, Layer& layer) {
  const auto place = [](std::uint8_t byte) {
    return Point2{static_cast<double>(byte & 15), static_cast<double>(byte >> 4)};
  };
  const Point2 p = place(record[1]), q = place(record[2]), r = place(record[3]);
  std::vector<Point2> corners{p, q, r};
  if ((record[0] & 2) != 0) corners.push_back({p.x + r.x - q.x, p.y + r.y - q.y});
  for (const Point2 c : corners) {
    layer.ring_corners.push_back(static_cast<std::uint32_t>(layer.points.size()));
    layer.points.push_back(c);
  }
  layer.end_ring();
  layer.end_polygon();
}

Layers layers_of(std::span<const std::uint8_t> program) {
  Layers layers;
  for (std::size_t i = 0; i + kRecord <= program.size(); i += kRecord) {
    const std::uint8_t bits = program[i];
    Layer& layer = layers.layer[bits & 1];
    add_shape(program.subspan(i, kRecord), layer);
    if ((bits & 4) == 0) continue;
    layer.end_feature("", "{}");
    if ((bits & 1) == 0) layers.group.push_back((bits >> 3) & 1);
  }
  for (const int i : {0, 1}) layers.layer[i].end_feature("", "{}");
  layers.group.push_back(0);
  return layers;
}

std::string coverage_flaw(const Layer& layer, const std::string& what) {
  const RepairedLayer repaired = repair_layer(layer, {OwnerRule::First, 0.0});
  if (repaired.report.count(LayerRegionKind::Overlap) > 0) return what + " has overlaps";
  if (repaired.report.rounding.largest_move != 0) return what + " is not made of doubles";
  if (geojson(repaired.layer) != geojson(layer)) return what + " has other polygons after a repair";
  // Rings of TopoJSON begin at junctions; a repair begins them where it begins those of `layer`.
  const Layer read = read_layer(topojson(layer)).layer;
  if (geojson(repair_layer(read, {OwnerRule::First, 0.0}).layer) != geojson(layer)) {
    return what + " is another one after TopoJSON";
  }
  return {};
}

Rational total(const Layer& first, const Layer& second, OverlayPairs pairs) {
  const LayerOverlay overlay = overlay_layers(first, second, {pairs, true});
  Rational sum = 0;
  for (const Rational& area : overlay.area) sum += area;
  return sum;
}

std::string overlay_flaw(const Layer& first, const Layer& second) {
  const Rational both = total(first, second, OverlayPairs::Both);
  const Rational only_first = total(first, second, OverlayPairs::FirstOnly);
  const Rational only_second = total(second, first, OverlayPairs::FirstOnly);
  if (both + only_first != total(first, second, OverlayPairs::First)) return "areas differ";
  if (both + only_first + only_second != total(second, first, OverlayPairs::All)) {
    return "areas do not add up";
  }
  return coverage_flaw(overlay_layers(first, second).layer, "an overlay");
}

std::uint32_t rings_of(const Layer& layer, std::size_t f) {
  return layer.polygon_begin[layer.feature_begin[f + 1]] -
         layer.polygon_begin[layer.feature_begin[f]];
}

std::string simplify_flaw(const Layer& coverage, double tolerance) {
  const SimplifiedLayer once = simplify_layer(coverage, {tolerance, 0});
  if (once.layer.feature_begin != coverage.feature_begin) return "a polygon is lost";
  // The polygons of a feature may change their order.
  for (std::size_t f = 0; f < coverage.feature_count(); ++f) {
    if (rings_of(once.layer, f) != rings_of(coverage, f)) return "a ring is lost";
  }
  const SimplifiedLayer twice = simplify_layer(once.layer, {tolerance, 0});
  if (geojson(twice.layer) != geojson(once.layer)) return "a second run removes more";
  return coverage_flaw(once.layer, "a simplified layer");
}

double covered_area(const Layer& coverage) {
  const LayerOverlay all = overlay_layers(coverage, Layer(), {OverlayPairs::All, true});
  double sum = 0;
  for (const Rational& area : all.area) sum += nearest_double(area);
  return sum;
}

std::string repair_flaw(const Layer& layer, double gaps_below) {
  const LayerRepairOptions options{OwnerRule::LongestBorder, gaps_below};
  const RepairedLayer repaired = repair_layer(layer, options);
  double expected = covered_area(repair_layer(layer, {OwnerRule::First, 0.0}).layer);
  bool has_open_gap = false;
  for (const LayerRegion& region : repaired.report.regions) {
    if (region.kind == LayerRegionKind::Gap) expected += nearest_double(region.area);
    has_open_gap = has_open_gap || region.is_open;
  }
  constexpr double kRounding = 1e-9;
  if (!(std::fabs(covered_area(repaired.layer) - expected) <= kRounding)) {
    return "repair covers something else than the gaps of its report";
  }
  if (repaired.report.is_stopped) return coverage_flaw(repaired.layer, "a stopped repair");
  const RepairedLayer again = repair_layer(repaired.layer, options);
  if (has_open_gap && again.report.has_defects()) return "a second repair finds a defect";
  if (has_open_gap && geojson(again.layer) != geojson(repaired.layer)) {
    return "a second repair changes something";
  }
  return coverage_flaw(repaired.layer, "a repaired layer");
}

std::string flaw_of(std::span<const std::uint8_t> program) {
  const Layers layers = layers_of(program);
  const Layer& first = layers.layer[0];
  const Layer dissolved = dissolve_layer(first, layers.group, 2).layer;
  std::string flaw = coverage_flaw(dissolved, "a dissolved layer");
  if (flaw.empty()) flaw = repair_flaw(first, 1.5);
  if (flaw.empty()) flaw = repair_flaw(first, 6);
  if (flaw.empty()) flaw = overlay_flaw(first, layers.layer[1]);
  const Layer coverage = overlay_layers(first, layers.layer[1]).layer;
  if (flaw.empty()) flaw = simplify_flaw(coverage, 3);
  if (flaw.empty()) flaw = simplify_flaw(coverage, std::numeric_limits<double>::infinity());
  return flaw.empty() ? flaw : flaw + '\n' + geojson(first) + geojson(layers.layer[1]);
}

}  // namespace
}  // namespace plumb::testing

const plumb::fuzz::RecordTarget plumb::fuzz::kTarget{
    plumb::testing::kRecord, plumb::testing::kMostShapes, plumb::testing::flaw_of};
