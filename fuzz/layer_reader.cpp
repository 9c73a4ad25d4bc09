// The reader of layers, and the repair of what it reads, on arbitrary bytes.
//
// The first byte chooses the rule; the rest is the file. Either the reader throws an Error that
// names the file, or the layer is repaired. The repaired layer is a coverage of doubles: a second
// repair finds no overlap and moves nothing. It has the ids and properties of the file, and it is
// the same after it was written and read. If nothing was rounded and no gap was filled, it covers
// the same points as the set that the union of all polygons is.

#include <algorithm>
#include <cstdint>
#include <sstream>
#include <string>
#include <string_view>

#include "plumb/io/layer_io.h"
#include "plumb/io/plane_io.h"
#include "plumb/testing/oracle_reached.h"
#include "reader_laws.h"

namespace {

using namespace plumb;
using namespace plumb::fuzz;

constexpr std::size_t kMostCorners = 400;

std::string layer_text(const Layer& layer) {
  std::ostringstream out;
  write_layer_geojson(out, layer);
  return out.str();
}

Nef2 set_of(const Layer& layer) {
  PlaneShapes shapes;
  shapes.points = layer.points;
  shapes.ring_corners = layer.ring_corners;
  shapes.ring_begin = layer.ring_begin;
  shapes.polygon_begin = layer.polygon_begin;
  return to_set(shapes).regularization();
}

void require_same_union(const Layer& layer, OwnerRule rule) {
  const RepairedLayer repaired = repair_layer(layer, {rule, 0.0});
  if (repaired.report.rounding.largest_move != 0) return;
  oracle_reached();
  require(set_of(repaired.layer) == set_of(layer),
          "overlaps have owners, and nothing else changes");
}

void require_coverage(const Layer& layer, const LayerRepairOptions& options) {
  const RepairedLayer once = repair_layer(layer, options);
  require(once.layer.points.all_double(), "a repaired layer has doubles");
  require(once.layer.feature_count() == layer.feature_count(), "no feature is lost");
  for (std::size_t f = 0; f < layer.feature_count(); ++f) {
    require(once.layer.id(f) == layer.id(f), "ids are kept");
    require(once.layer.properties(f) == layer.properties(f), "properties are kept");
  }
  const RepairedLayer twice = repair_layer(once.layer, {options.rule, 0.0});
  require(twice.report.count(LayerRegionKind::Overlap) == 0, "a repaired layer has no overlaps");
  require(twice.report.count(LayerRegionKind::Crossing) == 0, "no border crosses itself");
  require(twice.report.rounding.largest_move == 0, "a repaired layer needs no rounding");
  const auto& regions = once.report.regions;
  if (std::any_of(regions.begin(), regions.end(), [](const LayerRegion& r) { return r.is_open; })) {
    require(!repair_layer(once.layer, options).report.has_defects(),
            "a layer with filled gaps has none that is open");
  }
  const std::string text = layer_text(once.layer);
  require(layer_text(twice.layer) == text, "a second repair changes nothing");
  require(layer_text(read_layer(text).layer) == text, "a layer survives its file");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  begin_input();
  if (size == 0) return 0;
  const std::string_view text(reinterpret_cast<const char*>(data) + 1, size - 1);
  Layer layer;
  try {
    layer = read_layer(text, {kFileName, ""}).layer;
  } catch (const Error& error) {
    require_binary_place(error, text);
    return 0;
  }
  if (layer.ring_corners.size() > kMostCorners) return 0;
  try {
    require_same_union(layer, static_cast<OwnerRule>(data[0] % 4));
    require_coverage(layer, {static_cast<OwnerRule>(data[0] % 4), data[0] / 4.0});
  } catch (const Error& error) {
    require(error.code() == ErrorCode::NumberOutOfRange, "only the largest numbers are refused");
  }
  return 0;
}
