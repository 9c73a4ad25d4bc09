#include "plumb/io/map_report_text.h"

#include <cstdint>
#include <limits>
#include <vector>

#include "plumb/base/refused_memory.h"
#include "plumb/io/text_output.h"
#include "plumb/plane/map_edges.h"

namespace plumb {
namespace {

/// Corner positions by half-edge; kNone where no cycle lists the half-edge.
class CornerNumbers {
 public:
  explicit CornerNumbers(const Map& map)
      : edges_(match_twins(map)), corner_of_(edges_.halfedge_count(), kNone) {
    for (std::size_t corner = 0; corner < edges_.at_corner.size(); ++corner) {
      corner_of_[edges_.at_corner[corner]] = static_cast<std::uint32_t>(corner);
    }
  }

  /// 1-based, 0 for none.
  std::uint32_t twin_number(std::size_t corner) const {
    return corner_of_[edges_.at_corner[corner] ^ 1U] + 1;
  }

 private:
  static constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();
  MapEdges edges_;
  std::vector<std::uint32_t> corner_of_;
};

/// Per vertex the number of the first half-edge that leaves it, or 0.
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

/// One line: "1. crossing; faces 3 5; edges 4-9 2-7; at 7/2 5 near 3.5 5: HINT"
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

void write_map_report_text(std::ostream& stream, const MapReport& report) try {
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
} catch (...) {
  rethrow_refused_memory();
}

}  // namespace plumb
