// Layers as GeoJSON, TopoJSON and WKT, and reports on layers as GeoJSON, text and JSON.
//
// GeoJSON: a report is a layer whose features are the regions of the report. Features are named by
// their numbers from 1 and, if they have any, their ids and names.
//
// TopoJSON: corners with equal coordinates are one vertex. A vertex is a junction if rings pass it
// between different neighbours; rings are cut there to arcs. All rings that share an edge share the
// whole arc around it, because the vertices inside of an arc have the same neighbours in all rings.
// So the first directed edge of an arc identifies the arc and its direction. A ring without a
// junction is one arc that begins at its least vertex.
//
// Tested by tests/io/layer_io_test.cpp.
#include <algorithm>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <numeric>
#include <optional>
#include <ostream>
#include <span>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include "plumb/io/layer_io.h"
#include "plumb/io/plane/gdal_layer.h"
#include "plumb/io/text/text_output.h"
#include "plumb/predicates/rounding.h"

namespace plumb {
namespace {

// The memory of vertices, neighbours, and the table of arcs.
constexpr std::uint64_t kBytesPerArcCorner = 100;
constexpr std::size_t kRingsPerCheckpoint = 256;

/// The arcs of a layer, and the arcs of each ring.
class LayerArcs {
 public:
  LayerArcs(const Layer& layer, Context& context) : layer_(layer), memory_(context) {
    memory_.add(kBytesPerArcCorner * layer.ring_corners.size(), "the arcs of a layer");
    find_vertices();
    find_junctions();
    for (std::size_t r = 0; r < layer.ring_count(); ++r) {
      if (r % kRingsPerCheckpoint == 0) context.checkpoint("arcs", r, layer.ring_count());
      cut_ring(r);
      ring_begin_.push_back(ring_arcs_.size());
    }
  }

  std::size_t arc_count() const { return arc_begin_.size() - 1; }
  std::span<const std::uint32_t> arc(std::size_t i) const {
    return {corners_.data() + arc_begin_[i], corners_.data() + arc_begin_[i + 1]};
  }
  /// Returns the arcs of a ring: i, or -1 - i for arc i from its end to its start.
  std::span<const std::int64_t> arcs_of(std::size_t ring) const {
    return {ring_arcs_.data() + ring_begin_[ring], ring_arcs_.data() + ring_begin_[ring + 1]};
  }

 private:
  static std::uint64_t edge(std::uint32_t from, std::uint32_t to) {
    return std::uint64_t{from} << 32U | to;
  }
  std::uint32_t vertex(std::span<const std::uint32_t> ring, std::size_t i) const {
    return vertex_[ring[i % ring.size()]];
  }
  void find_vertices();
  void find_junctions();
  void cut_ring(std::size_t r);
  void add_arc(std::span<const std::uint32_t> ring, std::size_t begin, std::size_t end);

  const Layer& layer_;
  MemoryCharge memory_;
  std::vector<std::uint32_t> vertex_;  // For each point, the first point with its coordinates.
  std::vector<std::uint8_t> is_junction_;
  std::unordered_map<std::uint64_t, std::int64_t> arc_of_;  // The key is the first directed edge.
  std::vector<std::uint32_t> corners_;
  std::vector<std::size_t> arc_begin_{0};
  std::vector<std::int64_t> ring_arcs_;
  std::vector<std::size_t> ring_begin_{0};
};

void LayerArcs::find_vertices() {
  std::vector<std::uint32_t> order(layer_.points.size());
  std::iota(order.begin(), order.end(), 0U);
  const auto place = [this](std::uint32_t i) {
    const Point2 p = layer_.points.approx(i);
    return std::pair(p.x, p.y);
  };
  std::sort(order.begin(), order.end(), [&](std::uint32_t i, std::uint32_t j) {
    return place(i) != place(j) ? place(i) < place(j) : i < j;
  });
  vertex_.resize(order.size());
  for (std::size_t k = 0; k < order.size(); ++k) {
    const bool is_same = k > 0 && place(order[k - 1]) == place(order[k]);
    vertex_[order[k]] = is_same ? vertex_[order[k - 1]] : order[k];
  }
}

void LayerArcs::find_junctions() {
  constexpr std::uint64_t kUnseen = ~std::uint64_t{0};
  std::vector<std::uint64_t> neighbours(vertex_.size(), kUnseen);
  is_junction_.assign(vertex_.size(), 0);
  for (std::size_t r = 0; r < layer_.ring_count(); ++r) {
    const std::span<const std::uint32_t> ring = layer_.ring(r);
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const std::uint32_t a = vertex(ring, i + ring.size() - 1), b = vertex(ring, i + 1);
      const std::uint64_t beside = edge(std::min(a, b), std::max(a, b));
      std::uint64_t& seen = neighbours[vertex(ring, i)];
      if (seen == kUnseen) seen = beside;
      if (seen != beside) is_junction_[vertex(ring, i)] = 1;
    }
  }
}

void LayerArcs::cut_ring(std::size_t r) {
  const std::span<const std::uint32_t> ring = layer_.ring(r);
  std::size_t start = 0;
  while (start < ring.size() && is_junction_[vertex(ring, start)] == 0) ++start;
  if (start == ring.size()) {
    start = 0;
    for (std::size_t i = 1; i < ring.size(); ++i) {
      if (vertex(ring, i) < vertex(ring, start)) start = i;
    }
    add_arc(ring, start, start + ring.size());
    return;
  }
  std::size_t begin = start;
  for (std::size_t i = start + 1; i <= start + ring.size(); ++i) {
    if (is_junction_[vertex(ring, i)] == 0) continue;
    add_arc(ring, begin, i);
    begin = i;
  }
}

/// Adds the arc of the corners begin, ..., end of a ring, unless the arc is known already.
void LayerArcs::add_arc(std::span<const std::uint32_t> ring, std::size_t begin, std::size_t end) {
  const auto next = static_cast<std::int64_t>(arc_count());
  const std::uint64_t first = edge(vertex(ring, begin), vertex(ring, begin + 1));
  const auto [found, is_new] = arc_of_.try_emplace(first, next);
  ring_arcs_.push_back(found->second);
  if (!is_new) return;
  arc_of_.try_emplace(edge(vertex(ring, end), vertex(ring, end - 1)), -1 - next);
  for (std::size_t i = begin; i <= end; ++i) corners_.push_back(vertex(ring, i));
  arc_begin_.push_back(corners_.size());
}

template <class WriteRing>
void write_polygons(TextOutput& out, const Layer& layer, std::size_t f, const char* const brackets,
                    const WriteRing& write_ring) {
  const char open = brackets[0], close = brackets[1];
  for (std::size_t p = layer.feature_begin[f]; p < layer.feature_begin[f + 1]; ++p) {
    if (p > layer.feature_begin[f]) out << ',';
    out << open;
    for (std::size_t r = layer.polygon_begin[p]; r < layer.polygon_begin[p + 1]; ++r) {
      if (r > layer.polygon_begin[p]) out << ',';
      write_ring(r);
    }
    out << close;
  }
}

void write_number(TextOutput& out, std::int64_t value) {
  if (value < 0) out << '-';
  out << static_cast<std::uint64_t>(value < 0 ? -value : value);
}

void write_topojson_geometry(TextOutput& out, const Layer& layer, const LayerArcs& arcs,
                             std::size_t f) {
  const std::size_t polygons = layer.feature_begin[f + 1] - layer.feature_begin[f];
  out << R"({"type":)"
      << (polygons == 0   ? "null"
          : polygons == 1 ? R"("Polygon")"
                          : R"("MultiPolygon")");
  if (!layer.id(f).empty()) out << R"(,"id":)" << layer.id(f);
  if (!layer.properties(f).empty()) out << R"(,"properties":)" << layer.properties(f);
  if (polygons > 0) {
    out << R"(,"arcs":)" << (polygons > 1 ? "[" : "");
    write_polygons(out, layer, f, "[]", [&](std::size_t r) {
      out << '[';
      bool is_first = true;
      for (const std::int64_t arc : arcs.arcs_of(r)) {
        if (!is_first) out << ',';
        is_first = false;
        write_number(out, arc);
      }
      out << ']';
    });
    if (polygons > 1) out << ']';
  }
  out << '}';
}

}  // namespace

void write_layer_topojson(std::ostream& stream, const Layer& layer, Context& context) {
  const LayerArcs arcs(layer, context);
  TextOutput out(stream, context);
  out << R"({"type":"Topology","objects":{"layer":{"type":"GeometryCollection","geometries":[)"
      << '\n';
  for (std::size_t f = 0; f < layer.feature_count(); ++f) {
    if (f > 0) out << ",\n";
    write_topojson_geometry(out, layer, arcs, f);
  }
  out << "\n]}},\"arcs\":[\n";
  for (std::size_t i = 0; i < arcs.arc_count(); ++i) {
    out << (i == 0 ? "[" : ",\n[");
    bool is_first = true;
    for (const std::uint32_t v : arcs.arc(i)) {
      const Point2 p = layer.points.approx(v);
      out << (is_first ? "[" : ",[") << p.x << ',' << p.y << ']';
      is_first = false;
    }
    out << ']';
  }
  out << "\n]}\n";
  out.flush();
}

void write_layer_wkt(std::ostream& stream, const Layer& layer, Context& context) {
  TextOutput out(stream, context);
  for (std::size_t f = 0; f < layer.feature_count(); ++f) {
    const std::size_t polygons = layer.feature_begin[f + 1] - layer.feature_begin[f];
    out << (polygons == 0 ? "POLYGON EMPTY" : polygons == 1 ? "POLYGON " : "MULTIPOLYGON (");
    write_polygons(out, layer, f, "()", [&](std::size_t r) {
      const std::span<const std::uint32_t> ring = layer.ring(r);
      out << '(';
      for (std::size_t i = 0; i <= ring.size(); ++i) {
        const Point2 p = layer.points.approx(ring[i < ring.size() ? i : 0]);
        out << (i == 0 ? "" : ",") << p.x << ' ' << p.y;
      }
      out << ')';
    });
    out << (polygons > 1 ? ")\n" : "\n");
  }
  out.flush();
}

// ---------------------------------------------------------------- GeoJSON and reports

namespace {

void write_ring(TextOutput& out, const Layer& layer, std::size_t r) {
  const std::span<const std::uint32_t> ring = layer.ring(r);
  out << '[';
  for (std::size_t i = 0; i <= ring.size(); ++i) {
    const Point2 p = layer.points.approx(ring[i < ring.size() ? i : 0]);
    out << (i == 0 ? "[" : ",[") << p.x << ',' << p.y << ']';
  }
  out << ']';
}

void write_polygon(TextOutput& out, const Layer& layer, std::size_t p) {
  out << '[';
  for (std::size_t r = layer.polygon_begin[p]; r < layer.polygon_begin[p + 1]; ++r) {
    if (r > layer.polygon_begin[p]) out << ',';
    write_ring(out, layer, r);
  }
  out << ']';
}

/// Writes the geometry of a feature.
void write_geometry(TextOutput& out, const Layer& layer, std::size_t f) {
  const std::uint32_t begin = layer.feature_begin[f], end = layer.feature_begin[f + 1];
  if (begin == end) {
    out << "null";
    return;
  }
  const bool is_one = end - begin == 1;
  out << R"({"type":")" << (is_one ? "Polygon" : "MultiPolygon") << R"(","coordinates":)"
      << (is_one ? "" : "[");
  for (std::size_t p = begin; p < end; ++p) {
    if (p > begin) out << ',';
    write_polygon(out, layer, p);
  }
  out << (is_one ? "}" : "]}");
}

}  // namespace

std::optional<std::string> feature_name(const Layer& layer, std::uint32_t feature) {
  if (layer.properties(feature).empty()) return {};
  const auto properties = nlohmann::json::parse(layer.properties(feature));
  if (!properties.is_object()) return {};
  for (const char* const name : {"name", "NAME", "Name"}) {
    const auto found = properties.find(name);
    if (found != properties.end() && found->is_string()) return found->get<std::string>();
  }
  return {};
}

namespace {

/// Returns a feature as JSON: its number from 1 and, if it has them, its id and its name.
nlohmann::ordered_json feature_json(const Layer& layer, std::uint32_t feature) {
  nlohmann::ordered_json json = {{"number", feature + 1}};
  if (!layer.id(feature).empty()) json["id"] = nlohmann::ordered_json::parse(layer.id(feature));
  if (const std::optional<std::string> name = feature_name(layer, feature)) json["name"] = *name;
  return json;
}

nlohmann::ordered_json region_json(const Layer& layer, const LayerReport& report, std::size_t i) {
  const LayerRegion& region = report.regions[i];
  nlohmann::ordered_json features = nlohmann::ordered_json::array();
  for (const std::uint32_t f : report.features_of(region)) {
    features.push_back(feature_json(layer, f));
  }
  nlohmann::ordered_json json = {{"kind", name_of(region.kind)},
                                 {"area", nearest_double(region.area)},
                                 {"open", region.is_open},
                                 {"width", region.width},
                                 {"features", std::move(features)},
                                 {"to", nullptr},
                                 {"at", nullptr}};
  if (const std::optional<Point2> at = place_of(report, i)) json["at"] = {at->x, at->y};
  if (region.owner != LayerRegion::kNobody) json["to"] = feature_json(layer, region.owner);
  return json;
}

/// Returns a number with the singular or the plural of a word.
std::string number_of(std::size_t count, const std::string& one) {
  return std::to_string(count) + ' ' + one + (count == 1 ? "" : "s");
}

void write_region(TextOutput& out, const Layer& layer, const LayerReport& report, std::size_t i) {
  const LayerRegion& region = report.regions[i];
  const bool is_place = region.at.has_value();
  const bool is_of_features = is_place || region.kind == LayerRegionKind::Overlap;
  const bool has_one_feature = report.features_of(region).size() == 1;
  out << (region.is_open ? "open " : "") << name_of(region.kind)
      << (is_of_features    ? " of "
          : has_one_feature ? " in "
                            : " between ");
  bool is_first = true;
  for (const std::uint32_t f : report.features_of(region)) {
    if (!is_first) out << ", ";
    is_first = false;
    out << feature_title(layer, f);
  }
  if (region.kind == LayerRegionKind::Nesting) {
    out << ": a hole lies outside of its outer ring, or in another hole";
  } else if (is_of_features && has_one_feature) {
    out << " with itself";
  }
  if (!is_place) {
    out << ": area " << nearest_double(region.area) << ", width " << region.width;
  }
  if (const std::optional<Point2> at = place_of(report, i)) {
    out << ", at " << at->x << ' ' << at->y;
  }
  if (region.owner != LayerRegion::kNobody)
    out << "; goes to " << feature_title(layer, region.owner);
  out << '\n';
}

}  // namespace

/// Returns a corner of a region, or the point of a crossing or of a nesting, as the place of the
/// defect.
std::optional<Point2> place_of(const LayerReport& report, std::size_t region) {
  if (report.regions[region].at) return report.regions[region].at;
  const std::uint32_t polygon = report.shapes.feature_begin[region];
  if (polygon == report.shapes.feature_begin[region + 1]) return {};
  return report.shapes.points.approx(report.shapes.ring(report.shapes.polygon_begin[polygon])[0]);
}

std::string feature_title(const Layer& layer, std::uint32_t feature) {
  std::string title = "feature " + std::to_string(feature + 1);
  // An id may be any text of the file. As JSON in ASCII, it cannot send commands to a terminal.
  const auto ascii = [](const nlohmann::json& json) {
    return json.dump(-1, ' ', true, nlohmann::json::error_handler_t::replace);
  };
  std::string inner;
  if (!layer.id(feature).empty()) inner = ascii(nlohmann::json::parse(layer.id(feature)));
  if (const std::optional<std::string> name = feature_name(layer, feature)) {
    inner += (inner.empty() ? "" : ", ") + ascii(*name);
  }
  return inner.empty() ? title : title + " (" + inner + ')';
}

namespace {

/// Writes the beginning of a collection, up to its features.
void begin_features(TextOutput& out, const std::string& crs) {
  out << R"({"type":"FeatureCollection",)";
  if (!crs.empty()) {
    const nlohmann::ordered_json named = {{"type", "name"}, {"properties", {{"name", crs}}}};
    out << R"("crs":)"
        << named.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace) << ',';
  }
  out << R"("features":[)" << '\n';
}

}  // namespace

void write_layer_geojson(std::ostream& stream, const Layer& layer, Context& context) {
  write_layer_geojson(stream, layer, layer.crs, context);
}

void write_layer_geojson(std::ostream& stream, const Layer& layer, const std::string& crs,
                         Context& context) {
  TextOutput out(stream, context);
  begin_features(out, crs);
  for (std::size_t f = 0; f < layer.feature_count(); ++f) {
    out << (f == 0 ? "" : ",\n") << R"({"type":"Feature",)";
    if (!layer.id(f).empty()) out << R"("id":)" << layer.id(f) << ',';
    out << R"("properties":)" << (layer.properties(f).empty() ? "null" : layer.properties(f))
        << R"(,"geometry":)";
    write_geometry(out, layer, f);
    out << '}';
  }
  out << "\n]}\n";
  out.flush();
}

void write_layer_gpkg(std::ostream& out, const Layer& layer, const std::string& crs,
                      Context& context) {
  write_gdal_layer(out, layer, crs, "GPKG", context);
}

void write_layer_fgb(std::ostream& out, const Layer& layer, const std::string& crs,
                     Context& context) {
  write_gdal_layer(out, layer, crs, "FlatGeobuf", context);
}

Shapefile layer_shapefile(const Layer& layer, const std::string& crs, Context& context) {
  return gdal_shapefile(layer, crs, context);
}

void write_layer_report_geojson(std::ostream& stream, const Layer& layer, const LayerReport& report,
                                Context& context) {
  write_layer_report_geojson(stream, layer, report, layer.crs, context);
}

void write_layer_report_geojson(std::ostream& stream, const Layer& layer, const LayerReport& report,
                                const std::string& crs, Context& context) {
  TextOutput out(stream, context);
  begin_features(out, crs);
  for (std::size_t i = 0; i < report.regions.size(); ++i) {
    out << (i == 0 ? "" : ",\n") << R"({"type":"Feature","properties":)"
        << region_json(layer, report, i).dump() << R"(,"geometry":)";
    if (const std::optional<Point2> at = report.regions[i].at) {
      out << R"({"type":"Point","coordinates":[)" << at->x << ',' << at->y << "]}";
    } else {
      write_geometry(out, report.shapes, i);
    }
    out << '}';
  }
  out << "\n]}\n";
  out.flush();
}

void write_layer_report_text(std::ostream& stream, const Layer& layer, const LayerReport& report) {
  TextOutput out(stream);
  out << number_of(layer.feature_count(), "feature") << ", "
      << number_of(report.count(LayerRegionKind::Overlap), "overlap") << ", "
      << number_of(report.count(LayerRegionKind::Gap), "gap") << " below width "
      << report.gaps_below << ", " << number_of(report.count(LayerRegionKind::Hole), "hole");
  const std::size_t crossings = report.count(LayerRegionKind::Crossing);
  if (crossings > 0) out << ", " << number_of(crossings, "crossing");
  const std::size_t nestings = report.count(LayerRegionKind::Nesting);
  if (nestings > 0) out << ", " << number_of(nestings, "nesting");
  out << '\n';
  for (std::size_t i = 0; i < report.regions.size(); ++i) write_region(out, layer, report, i);
  for (const std::uint32_t f : report.emptied)
    out << feature_title(layer, f) << " has no area left\n";
  out.flush();
}

void write_layer_report_json(std::ostream& out, const Layer& layer, const LayerReport& report) {
  nlohmann::ordered_json regions = nlohmann::ordered_json::array();
  for (std::size_t i = 0; i < report.regions.size(); ++i) {
    regions.push_back(region_json(layer, report, i));
  }
  nlohmann::ordered_json emptied = nlohmann::ordered_json::array();
  for (const std::uint32_t f : report.emptied) emptied.push_back(feature_json(layer, f));
  const nlohmann::ordered_json json = {{"features", layer.feature_count()},
                                       {"overlaps", report.count(LayerRegionKind::Overlap)},
                                       {"gaps", report.count(LayerRegionKind::Gap)},
                                       {"holes", report.count(LayerRegionKind::Hole)},
                                       {"crossings", report.count(LayerRegionKind::Crossing)},
                                       {"nestings", report.count(LayerRegionKind::Nesting)},
                                       {"gaps_below", report.gaps_below},
                                       {"regions", std::move(regions)},
                                       {"emptied", std::move(emptied)},
                                       {"rounding_moved_by", report.rounding.largest_move}};
  out << json.dump() << '\n';
}

}  // namespace plumb
