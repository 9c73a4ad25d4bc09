// Reports on maps as text, JSON and GeoJSON.
//
// A valid map is printed as a DCEL listing, in which every index is 1-based and 0 means none; twins
// are found through the table of edges. Defects are printed with the same data in all three forms:
// cycles, edges, and a place that is exact, with the nearest doubles beside it where these differ.
// Lists that can have millions of entries are written piece by piece; only single entries become
// JSON values. Formats: docs/formats.md, sections DCEL listing, Defects as text, Defects as JSON,
// Defects as GeoJSON.
// Tested by tests/io/map_report_io_test.cpp.
#include "plumb/io/map_report_io.h"

#include <cstdint>
#include <limits>
#include <nlohmann/json.hpp>
#include <ostream>
#include <string>
#include <vector>

#include "plumb/io/text/text_output.h"
#include "plumb/plane/check/map_edges.h"

namespace plumb {
namespace {

/// Corner positions by half-edge, or kNone for half-edges that no cycle lists.
class CornerNumbers {
 public:
  explicit CornerNumbers(const Map& map)
      : edges_(match_twins(map)), corner_of_(edges_.halfedge_count(), kNone) {
    for (std::size_t corner = 0; corner < edges_.at_corner.size(); ++corner) {
      corner_of_[edges_.at_corner[corner]] = static_cast<std::uint32_t>(corner);
    }
  }

  /// Returns the 1-based number of the twin, or 0 if there is none.
  std::uint32_t twin_number(std::size_t corner) const {
    return corner_of_[edges_.at_corner[corner] ^ 1U] + 1;
  }

 private:
  MapEdges edges_;
  std::vector<std::uint32_t> corner_of_;
};

/// Returns for each vertex the number of the first half-edge that leaves it, or 0.
std::vector<std::uint32_t> first_halfedges(const Map& map) {
  std::vector<std::uint32_t> first(map.vertex_count(), 0);
  for (std::size_t corner = map.corners.size(); corner-- > 0;) {
    first[map.corners[corner]] = static_cast<std::uint32_t>(corner) + 1;
  }
  return first;
}

void write_vertices(TextOutput& out, const Map& map) {
  const std::vector<std::uint32_t> first = first_halfedges(map);
  for (std::uint32_t v = 0; v < map.vertex_count(); ++v) {
    write_point(out, map.points, v);
    out << ' ' << first[v] << '\n';
  }
}

void write_faces(TextOutput& out, const Map& map) {
  for (std::size_t c = 0; c < map.cycle_count(); ++c) out << map.cycle_begin[c] + 1 << '\n';
}

void write_halfedges(TextOutput& out, const Map& map) {
  const CornerNumbers numbers(map);
  for (std::size_t c = 0; c < map.cycle_count(); ++c) {
    const std::uint32_t begin = map.cycle_begin[c];
    const std::uint32_t end = map.cycle_begin[c + 1];
    for (std::uint32_t h = begin; h < end; ++h) {
      const std::uint32_t next = h + 1 == end ? begin : h + 1;
      const std::uint32_t prev = h == begin ? end - 1 : h - 1;
      out << map.corners[h] + 1 << ' ' << numbers.twin_number(h) << ' ' << std::uint64_t{c} + 1
          << ' ' << next + 1 << ' ' << prev + 1 << '\n';
    }
  }
}

void write_listing(TextOutput& out, const MapReport& report) {
  const Map& map = report.map;
  out << std::uint64_t{map.vertex_count()} << ' ' << std::uint64_t{report.edges} << ' '
      << std::uint64_t{map.cycle_count()} << '\n';
  write_vertices(out, map);
  write_faces(out, map);
  write_halfedges(out, map);
}

bool is_directed(DefectKind kind) {
  return kind == DefectKind::Duplicate || kind == DefectKind::Open;
}

void write_cycles(TextOutput& out, const std::vector<std::uint32_t>& cycles) {
  if (cycles.empty()) return;
  out << (cycles.size() == 1 ? "; face" : "; faces");
  for (const std::uint32_t cycle : cycles) out << ' ' << cycle + 1;
}

void write_edges(TextOutput& out, const MapDefect& defect) {
  if (defect.edges.empty()) return;
  const char* const link = is_directed(defect.kind) ? "->" : "-";
  out << (defect.edges.size() == 1 ? "; edge" : "; edges");
  for (const MapEdge& edge : defect.edges) out << ' ' << edge.from + 1 << link << edge.to + 1;
}

void write_place(TextOutput& out, const MapDefect& defect) {
  if (!defect.point) return;
  const std::string x = format_exact(defect.point->x);
  const std::string y = format_exact(defect.point->y);
  out << "; at " << x << ' ' << y;
  const bool is_near_needed =
      x != format_double(defect.near.x) || y != format_double(defect.near.y);
  if (is_near_needed) out << " near " << defect.near.x << ' ' << defect.near.y;
}

/// Writes one line: "1. crossing; faces 3 5; edges 4-9 2-7; at 7/2 5 near 3.5 5: HINT".
void write_defect(TextOutput& out, std::size_t number, const MapDefect& defect) {
  out << std::uint64_t{number} << ". " << name_of(defect.kind);
  write_cycles(out, defect.cycles);
  write_edges(out, defect);
  write_place(out, defect);
  out << ": " << defect.hint << '\n';
}

}  // namespace

std::string_view headline(MapVerdict verdict) {
  switch (verdict) {
    case MapVerdict::Valid:
      return "valid";
    case MapVerdict::NotAPlanarSubdivision:
      return "not a planar subdivision";
    case MapVerdict::Open:
      return "open";
    case MapVerdict::Superposed:
      return "superposed";
  }
  return {};
}

std::string_view name_of(DefectKind kind) {
  switch (kind) {
    case DefectKind::Duplicate:
      return "duplicate";
    case DefectKind::Open:
      return "open";
    case DefectKind::Crossing:
      return "crossing";
    case DefectKind::Twin:
      return "twin";
    case DefectKind::Mixed:
      return "mixed";
    case DefectKind::Nested:
      return "nested";
  }
  return {};
}

std::string_view name_of(WarningKind kind) {
  switch (kind) {
    case WarningKind::Pinch:
      return "pinch";
    case WarningKind::IsolatedVertex:
      return "isolated-vertex";
    case WarningKind::InferredOuter:
      return "inferred-outer";
    case WarningKind::MergedVertex:
      return "merged-vertex";
  }
  return {};
}

void write_map_report_text(std::ostream& stream, const MapReport& report) {
  TextOutput out(stream);
  if (report.verdict == MapVerdict::Valid) {
    write_listing(out, report);
  } else {
    out << headline(report.verdict) << '\n';
    for (std::size_t i = 0; i < report.defects.size(); ++i) {
      write_defect(out, i + 1, report.defects[i]);
    }
  }
  out.flush();
}

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

/// Returns the members that precede the lists.
Json summary_json(const MapReport& report) {
  return {{"verdict", verdict_name(report.verdict)},
          {"vertices", report.vertices},
          {"edges", report.edges},
          {"faces", report.cycles},
          {"components", report.components},
          {"counts", counts_json(report.counts)}};
}

/// Writes "[a,b,...]", entry by entry.
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

/// Writes {"outer":3,"holes":[7,8]}. The numbers are written directly, because there can be
/// millions of them.
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

// Defects as GeoJSON.

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

void write_map_report_json(std::ostream& stream, const MapReport& report) {
  TextOutput out(stream);
  std::string summary = summary_json(report).dump();
  summary.pop_back();  // The closing brace is removed, because the lists follow.
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
}

void write_map_report_geojson(std::ostream& stream, const MapReport& report) {
  TextOutput out(stream);
  out << R"({"type":"FeatureCollection","features":)";
  write_list(out, report.defects,
             [&](const MapDefect& defect) { out << feature_json(report, defect).dump(); });
  out << "}\n";
  out.flush();
}

}  // namespace plumb
