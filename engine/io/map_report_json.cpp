#include "plumb/io/map_report_json.h"

#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "plumb/base/refused_memory.h"
#include "plumb/io/map_report_text.h"
#include "plumb/io/text_output.h"

namespace plumb {
namespace {

using Json = nlohmann::ordered_json;

std::string verdict_name(MapVerdict verdict) {
  if (verdict == MapVerdict::NotAPlanarSubdivision) return "not-a-planar-subdivision";
  return std::string(headline(verdict));
}

Json one_based(const std::vector<std::uint32_t>& ids) {
  Json list = Json::array();
  for (const std::uint32_t id : ids) list.push_back(id + 1);
  return list;
}

Json edges_json(const std::vector<MapEdge>& edges) {
  Json list = Json::array();
  for (const MapEdge& edge : edges) list.push_back({edge.from + 1, edge.to + 1});
  return list;
}

Json counts_json(const MapDefectCounts& counts) {
  return {{"duplicate", counts.duplicate},
          {"open", counts.open},
          {"crossing", counts.crossing},
          {"twin", counts.twin},
          {"mixed", counts.mixed ? Json(*counts.mixed) : Json(nullptr)},
          {"nested", counts.nested}};
}

Json defect_json(const MapDefect& defect) {
  Json json = {{"kind", name_of(defect.kind)},
               {"faces", one_based(defect.cycles)},
               {"edges", edges_json(defect.edges)},
               {"point", nullptr},
               {"near", nullptr},
               {"hint", defect.hint}};
  if (defect.point) {
    json["point"] = {format_exact(defect.point->x), format_exact(defect.point->y)};
    json["near"] = {defect.near.x, defect.near.y};
  }
  return json;
}

Json warning_json(const MapWarning& warning) {
  const bool is_face = warning.kind == WarningKind::InferredOuter;
  return {{"kind", name_of(warning.kind)},
          {is_face ? "face" : "vertex", warning.vertex + 1},
          {"text", warning.text}};
}

/// The members before the lists.
Json summary_json(const MapReport& report) {
  return {{"verdict", verdict_name(report.verdict)},
          {"vertices", report.vertices},
          {"edges", report.edges},
          {"faces", report.cycles},
          {"components", report.components},
          {"counts", counts_json(report.counts)}};
}

/// "[a,b,...]", element by element.
template <class Element, class Write>
void write_list(TextOutput& out, const std::vector<Element>& elements, Write write) {
  out << '[';
  bool first = true;
  for (const Element& element : elements) {
    if (!first) out << ',';
    first = false;
    write(element);
  }
  out << ']';
}

/// {"outer":3,"holes":[7,8]}: numbers only, written directly because there can be millions.
void write_region(TextOutput& out, const MapRegion& region) {
  out << "{\"outer\":";
  if (region.outer) {
    out << *region.outer + 1;
  } else {
    out << "null";
  }
  out << ",\"holes\":";
  write_list(out, region.holes, [&](std::uint32_t hole) { out << hole + 1; });
  out << '}';
}

template <class Element>
auto dump_with(TextOutput& out, Json (*to_json)(const Element&)) {
  return [&out, to_json](const Element& element) { out << to_json(element).dump(); };
}

// GeoJSON

Json position(Point2 p) { return {p.x, p.y}; }

Json geometry_json(const MapReport& report, const MapDefect& defect) {
  if (defect.point) return {{"type", "Point"}, {"coordinates", position(defect.near)}};
  if (defect.edges.empty()) return nullptr;
  Json lines = Json::array();
  for (const MapEdge& edge : defect.edges) {
    lines.push_back({position(report.map.points.approx(edge.from)),
                     position(report.map.points.approx(edge.to))});
  }
  return {{"type", "MultiLineString"}, {"coordinates", std::move(lines)}};
}

Json feature_json(const MapReport& report, const MapDefect& defect) {
  return {{"type", "Feature"},
          {"geometry", geometry_json(report, defect)},
          {"properties", defect_json(defect)}};
}

}  // namespace

void write_map_report_json(std::ostream& stream, const MapReport& report) try {
  TextOutput out(stream);
  std::string summary = summary_json(report).dump();
  summary.pop_back();  // the closing brace: the lists follow
  out << summary << ",\"defects\":";
  write_list(out, report.defects, dump_with(out, defect_json));
  out << ",\"warnings\":";
  write_list(out, report.warnings, dump_with(out, warning_json));
  if (report.verdict == MapVerdict::Valid) {
    out << ",\"regions\":";
    write_list(out, report.regions, [&](const MapRegion& region) { write_region(out, region); });
  }
  out << "}\n";
  out.flush();
} catch (...) {
  rethrow_refused_memory();
}

void write_map_report_geojson(std::ostream& stream, const MapReport& report) try {
  TextOutput out(stream);
  out << R"({"type":"FeatureCollection","features":)";
  write_list(out, report.defects,
             [&](const MapDefect& defect) { out << feature_json(report, defect).dump(); });
  out << "}\n";
  out.flush();
} catch (...) {
  rethrow_refused_memory();
}

}  // namespace plumb
