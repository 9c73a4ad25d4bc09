// Divided surfaces as OBJ, PLY, a graph of cells, and scenes.
//
// A mesh is written with the triangles of the chosen cells, grouped by cell. Only the points of
// these triangles are written, with new numbers. A scene is written so that reading it gives the
// same points: decimals are used only well inside a face, where the reader keeps them; on edges and
// near them coordinates are fractions. Weights refer to the face as its author listed it, even if
// the mesh flipped the face. Formats: docs/formats.md, sections Meshes and Scenes.
// Tested by tests/cli/surface_command_test.cpp.
#include "plumb/io/surface_writer.h"

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <ostream>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include "plumb/io/mesh/mesh_formats.h"
#include "plumb/io/text/text_output.h"
#include "plumb/predicates/error.h"
#include "plumb/surface/cells/surface_arrangement.h"

namespace plumb {
namespace {

bool is_chosen(CellChoice chosen, CellId c) { return chosen.empty() || chosen[c.value()] != 0; }

/// The triangles of the chosen cells, and new numbers for the points they use.
struct ChosenTriangles {
  std::vector<std::uint32_t> triangles;  // The triangles, sorted by cell.
  std::vector<std::uint32_t> points;
  std::vector<std::uint32_t> number;

  ChosenTriangles(const SurfaceTriangulation& in, CellChoice chosen)
      : number(in.points.size(), kNone) {
    for (std::uint32_t t = 0; t < in.triangles.size(); ++t) {
      if (is_chosen(chosen, in.cell[t])) triangles.push_back(t);
    }
    std::ranges::stable_sort(triangles, {}, [&](std::uint32_t t) { return in.cell[t]; });
    for (const std::uint32_t t : triangles) {
      for (const std::uint32_t c : in.triangles[t]) number[c] = 0;
    }
    for (std::uint32_t p = 0; p < number.size(); ++p) {
      if (number[p] == kNone) continue;
      number[p] = static_cast<std::uint32_t>(points.size());
      points.push_back(p);
    }
  }
};

/// Returns a text such as "+0 -2*3".
std::string text_of(std::span<const SignedEntry> polygons) {
  std::string text;
  for (const SignedEntry& e : polygons) {
    if (!text.empty()) text += ' ';
    text += (e.value > 0 ? "+" : "-");
    if (std::abs(e.value) != 1) text += std::to_string(std::abs(e.value)) + '*';
    text += std::to_string(e.id);
  }
  return text;
}

// ---------------------------------------------------------------- scenes

using Json = nlohmann::ordered_json;

/// Writes each point once, in the order of its first use.
class SceneWriter {
 public:
  explicit SceneWriter(const SurfaceScene& scene)
      : scene_(scene), polygons_(scene.polygons), mesh_(*scene.mesh) {}

  Json run(const std::string& model) {
    Json polygons = Json::array();
    for (std::size_t p = 0; p < polygons_.size(); ++p) {
      Json polygon = Json::array();
      for (std::uint32_t i = polygons_.begin[p]; i < polygons_.begin[p + 1]; ++i) {
        polygon.push_back(number_of(polygons_.point[i], polygons_.face[i]));
      }
      polygons.push_back(std::move(polygon));
    }
    Json json{{"model", model}, {"points", std::move(points_)}, {"polygons", std::move(polygons)}};
    if (scene_.shapes) json["shapes"] = *scene_.shapes;
    if (scene_.outside.is_valid()) json["outside"] = scene_.outside.value();
    for (const SurfaceLevel& l : scene_.levels) {
      json["levels"].push_back({l.shape, l.face.value(), l.label});
    }
    return json;
  }

 private:
  std::size_t number_of(SurfacePointId p, FaceId f) {
    const auto [place, is_new] = numbers_.emplace(p.value(), points_.size());
    if (is_new) points_.push_back(written(p, f));
    return place->second;
  }

  /// Returns a point in its written form. Decimals are used only well inside of a face, where the
  /// reader finds the same place from them.
  Json written(SurfacePointId p, FaceId f) const {
    constexpr double kClear = 0x1p-30;
    const SurfacePointTable& points = polygons_.points;
    const bool is_flipped = mesh_.is_flipped(f);
    const Point2 near = points.approx(p);
    if (points.place(p) == SurfacePlace::Face && points.parameters().is_double(p.value()) &&
        near.x > kClear && near.y > kClear && near.x + near.y < 1 - kClear) {
      return {f.value(), is_flipped ? near.y : near.x, is_flipped ? near.x : near.y};
    }
    RationalPoint2 at = points.exact_in(p, f);
    if (is_flipped) std::swap(at.x, at.y);
    return {f.value(), number(at.x), number(at.y)};
  }
  static Json number(const Rational& q) {
    if (q == 0) return 0;
    if (q == 1) return 1;
    return format_exact(q);
  }

  const SurfaceScene& scene_;
  const SurfacePolygons& polygons_;
  const SurfaceMesh& mesh_;
  Json points_ = Json::array();
  std::unordered_map<std::uint32_t, std::size_t> numbers_;
};

}  // namespace

void write_surface_obj(std::ostream& stream, const SurfaceTriangulation& in, std::size_t cells,
                       CellChoice chosen) {
  const ChosenTriangles part(in, chosen);
  TextOutput out(stream);
  out << "# plumb: " << std::uint64_t{cells} << " cells\n";
  for (const std::uint32_t p : part.points) {
    out << "v ";
    write_coordinates(out, in.points[p]);
    out << '\n';
  }
  CellId last;
  for (const std::uint32_t t : part.triangles) {
    if (in.cell[t] != last) out << "g cell_" << in.cell[t].value() << '\n';
    last = in.cell[t];
    out << 'f';
    for (const std::uint32_t c : in.triangles[t]) out << ' ' << std::uint64_t{part.number[c]} + 1;
    out << '\n';
  }
  out.flush();
}

void write_surface_ply(std::ostream& stream, const SurfaceTriangulation& in, CellChoice chosen) {
  const ChosenTriangles part(in, chosen);
  TextOutput out(stream);
  out << "ply\nformat ascii 1.0\nelement vertex " << std::uint64_t{part.points.size()}
      << "\nproperty double x\nproperty double y\nproperty double z\nelement face "
      << std::uint64_t{part.triangles.size()}
      << "\nproperty list uchar int vertex_indices\nproperty int cell\nend_header\n";
  for (const std::uint32_t p : part.points) {
    write_coordinates(out, in.points[p]);
    out << '\n';
  }
  for (const std::uint32_t t : part.triangles) {
    out << '3';
    for (const std::uint32_t c : in.triangles[t]) out << ' ' << part.number[c];
    out << ' ' << in.cell[t].value() << '\n';
  }
  out.flush();
}

CellStep upward_step(const SurfaceDivision& division, const CellEdge& edge) {
  const auto bundle = division.arrangement().bundles[edge.bundle];
  CellStep step{edge.from, edge.to, {bundle.begin(), bundle.end()}};
  const bool is_upward = bundle.front().value > 0;
  if (is_upward != (edge.sign > 0)) std::swap(step.from, step.to);
  for (SignedEntry& e : step.polygons) e.value = is_upward ? e.value : -e.value;
  return step;
}

void write_cell_graph(std::ostream& stream, const SurfaceDivision& division, CellChoice chosen) {
  TextOutput out(stream);
  out << "digraph cells {\n  node [shape=ellipse];\n";
  for (std::uint32_t c = 0; c < division.cell_count(); ++c) {
    if (!is_chosen(chosen, CellId(c))) continue;
    out << "  c" << c << " [label=\"" << c << ": ";
    const auto label = division.labels(CellId(c));
    for (const SignedEntry& e : label) {
      out << (e.value > 0 ? "+" : "") << std::to_string(e.value) << "*s" << e.id << ' ';
    }
    out << (label.empty() ? "0 " : "") << "\\narea " << division.area(CellId(c)) << "\"];\n";
  }
  const SurfaceCells& cells = division.cells();
  for (const CellEdge& e : cells.edges) {
    if (!is_chosen(chosen, e.from) || !is_chosen(chosen, e.to)) continue;
    const CellStep step = upward_step(division, e);
    out << "  c" << step.from.value() << " -> c" << step.to.value() << " [label=\""
        << text_of(step.polygons) << "\"];\n";
  }
  out << "}\n";
  out.flush();
}

void write_scene(std::ostream& out, const SurfaceScene& scene, const std::string& model) {
  std::string text;
  try {
    text = SceneWriter(scene).run(model).dump();
  } catch (const Json::type_error&) {  // The path is the only text that comes from the caller.
    throw Error(ErrorCode::BadArgument,
                "the path of the model is not UTF-8, so a scene in JSON cannot name it");
  }
  out << text << '\n';
}

}  // namespace plumb
