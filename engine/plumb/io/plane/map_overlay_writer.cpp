// The cells of two overlaid maps as GeoJSON and as a JSON summary.
//
// Each cell is a feature with the numbers of the faces of both maps that contain it, and its exact
// area. Coordinates come from the rounded overlay, so that cells with a common border keep this
// border. The summary adds up the areas exactly, by where the cells lie.
//
// Tested by tests/cli/map_commands_test.cpp.
#include "plumb/io/plane/map_overlay_writer.h"

#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "plumb/io/text/text_output.h"
#include "plumb/plane/plane_measure.h"
#include "plumb/predicates/arithmetic/rational_sum.h"
#include "plumb/predicates/rounding.h"

namespace plumb {
namespace {

using OrderedJson = nlohmann::ordered_json;

/// The number and total area of the cells of one kind.
struct Part {
  std::size_t cells = 0;
  RationalSum area;
};

/// Bounded cells, by the maps that contain them.
struct Parts {
  Part both, first_only, second_only, neither;

  Part& of(const MapOverlay::Origin& origin) {
    if (origin.first != 0) return origin.second != 0 ? both : first_only;
    return origin.second != 0 ? second_only : neither;
  }
};

Parts parts_of(const OverlayReport& report) {
  Parts parts;
  for (std::size_t f = 1; f < report.areas.cell.size(); ++f) {  // Face 0 is unbounded.
    Part& part = parts.of(report.overlay.origin[f]);
    ++part.cells;
    part.area.add(report.areas.cell[f]);
  }
  return parts;
}

OrderedJson area_json(const Rational& area) {
  return {{"exact", format_exact(area)}, {"double", nearest_double(area)}};
}

OrderedJson part_json(const Part& part) {
  return {{"cells", part.cells}, {"area", area_json(part.area.total())}};
}

OrderedJson map_json(const MapReport& report, const std::vector<Rational>& areas) {
  return {{"regions", report.regions.size() - 1}, {"area", area_json(sum_of(areas))}};
}

// ------------------------------------------------------------------ GeoJSON

void write_id(TextOutput& out, const MapReport& report, std::uint32_t region) {
  const std::optional<std::uint32_t> outer = report.regions[region].outer;
  if (outer) {
    out << *outer + 1;
  } else {
    out << "null";
  }
}

/// The subdivision whose coordinates are written, and its faces for each face of the overlay.
class WrittenCells {
 public:
  explicit WrittenCells(const OverlayReport& report)
      : complex_(report.rounded == nullptr ? report.overlay.complex : report.rounded->complex),
        faces_(report.overlay.complex.face_count()) {
    for (std::size_t f = 0; f < complex_.face_count(); ++f) {
      const FaceId face(f);
      const FaceId exact = report.rounded == nullptr ? face : report.rounded->exact_face[face];
      faces_[exact].push_back(face);
    }
  }

  const std::vector<FaceId>& of(FaceId exact) const { return faces_[exact]; }

  /// Writes the rings of a face as the coordinates of a polygon.
  void write_polygon(TextOutput& out, FaceId face) const {
    out << '[';
    bool is_first = true;
    for (const auto& ring : face_rings(complex_, face)) {
      if (!is_first) out << ',';
      is_first = false;
      write_ring(out, ring);
    }
    out << ']';
  }

 private:
  /// Writes a ring, with the first position again at the end, as the format requires.
  void write_ring(TextOutput& out, const std::vector<VertexId>& ring) const {
    out << '[';
    for (std::size_t i = 0; i <= ring.size(); ++i) {
      const Point2 p = nearest_doubles(ring[i < ring.size() ? i : 0]);
      out << (i == 0 ? "[" : ",[") << p.x << ',' << p.y << ']';
    }
    out << ']';
  }
  Point2 nearest_doubles(VertexId v) const {
    const std::uint32_t p = complex_.vertex_point[v];
    if (p < complex_.points.inputs.size()) return complex_.points.inputs.approx(p);
    const RationalPoint2 at = exact(complex_.points, p);
    return {nearest_double(at.x), nearest_double(at.y)};
  }

  const PlaneComplex& complex_;
  IdVector<FaceId, std::vector<FaceId>> faces_;
};

void write_feature(TextOutput& out, const OverlayReport& report, const WrittenCells& cells,
                   FaceId f) {
  const MapOverlay::Origin& origin = report.overlay.origin[f.value()];
  const bool is_one = cells.of(f).size() == 1;
  out << R"({"type":"Feature","geometry":{"type":")" << (is_one ? "Polygon" : "MultiPolygon")
      << R"(","coordinates":)" << (is_one ? "" : "[");
  for (std::size_t i = 0; i < cells.of(f).size(); ++i) {
    if (i > 0) out << ',';
    cells.write_polygon(out, cells.of(f)[i]);
  }
  out << (is_one ? "" : "]") << R"(},"properties":{"a":)";
  write_id(out, report.first, origin.first);
  out << ",\"b\":";
  write_id(out, report.second, origin.second);
  out << ",\"area\":" << area_json(report.areas.cell[f.value()]).dump() << "}}";
}

}  // namespace

void write_overlay_geojson(std::ostream& stream, const OverlayReport& report) {
  TextOutput out(stream);
  const WrittenCells cells(report);
  out << R"({"type":"FeatureCollection","features":[)";
  bool is_first = true;
  for (std::size_t f = 1; f < report.overlay.complex.face_count(); ++f) {
    if (cells.of(FaceId(f)).empty()) continue;
    if (!is_first) out << ",\n";
    is_first = false;
    write_feature(out, report, cells, FaceId(f));
  }
  out << "]}\n";
  out.flush();
}

void write_overlay_json(std::ostream& out, const OverlayReport& report) {
  const PlaneComplex& complex = report.overlay.complex;
  const Parts parts = parts_of(report);
  const OrderedJson json = {{"vertices", complex.vertex_count()},
                            {"edges", complex.edge_count()},
                            {"faces", complex.face_count()},
                            {"a", map_json(report.first, report.areas.first)},
                            {"b", map_json(report.second, report.areas.second)},
                            {"both", part_json(parts.both)},
                            {"only_a", part_json(parts.first_only)},
                            {"only_b", part_json(parts.second_only)},
                            {"neither", part_json(parts.neither)},
                            {"areas_add_up", report.areas.add_up()}};
  out << json.dump() << '\n';
}

void write_overlay_text(std::ostream& stream, const OverlayReport& report) {
  TextOutput out(stream);
  const PlaneComplex& complex = report.overlay.complex;
  const Parts parts = parts_of(report);
  // The exact areas of cells at crossings have many digits.
  const auto short_text = [](const Rational& area) {
    const std::string exact = format_exact(area);
    return exact.size() <= 40 ? exact : "about " + format_double(nearest_double(area));
  };
  const auto line = [&](const char* name, std::size_t cells, const char* unit,
                        const Rational& area) {
    out << name << std::uint64_t{cells} << unit << short_text(area) << '\n';
  };
  out << std::uint64_t{complex.vertex_count()} << " vertices, "
      << std::uint64_t{complex.edge_count()} << " edges, " << std::uint64_t{complex.face_count()}
      << " faces\n";
  line("a: ", report.first.regions.size() - 1, " regions, area ", sum_of(report.areas.first));
  line("b: ", report.second.regions.size() - 1, " regions, area ", sum_of(report.areas.second));
  line("in both: ", parts.both.cells, " cells, area ", parts.both.area.total());
  line("in a only: ", parts.first_only.cells, " cells, area ", parts.first_only.area.total());
  line("in b only: ", parts.second_only.cells, " cells, area ", parts.second_only.area.total());
  line("in neither: ", parts.neither.cells, " cells, area ", parts.neither.area.total());
  out << (report.areas.add_up() ? "the areas of the cells add up to every region's, exactly\n"
                                : "the areas of the cells do not add up\n");
  out.flush();
}

}  // namespace plumb
