// The commands that divide the plane: `plumb plane triangulate`, `plumb plane voronoi` and `plumb
// plane arrange`.
//
// The set is triangulated after its coordinates are rounded to doubles, so the triangles are
// written exactly as they were made. Cells and faces are made exactly and then rounded together as
// a layer (repair_layer), so that they share their borders.
// Tested by tests/cli/plane_command_test.cpp.
#include <array>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

#include "plumb/cli/commands/plane_kind.h"
#include "plumb/cli/files/operands.h"
#include "plumb/cli/files/outputs.h"
#include "plumb/cli/session/command.h"
#include "plumb/cli/session/progress.h"
#include "plumb/convex/triangulation.h"
#include "plumb/convex/voronoi.h"
#include "plumb/io/layer_io.h"
#include "plumb/io/mesh_io.h"
#include "plumb/io/text/text_output.h"
#include "plumb/plane/layer.h"
#include "plumb/plane/plane_faces.h"
#include "plumb/plane/plane_rounding.h"
#include "plumb/predicates/error.h"
#include "plumb/predicates/plane/plane_points.h"

namespace plumb::cli {
namespace {

using Json = nlohmann::ordered_json;

/// A format of triangles. `mesh` is empty for GeoJSON.
struct TriangleFormat {
  std::string_view name;
  std::string_view extension;
  std::optional<MeshFormat> mesh;
};

constexpr std::array kTriangleFormats{
    TriangleFormat{"geojson", ".geojson", std::nullopt},
    TriangleFormat{"geojson", ".json", std::nullopt},
    TriangleFormat{"off", ".off", MeshFormat::Off},
    TriangleFormat{"obj", ".obj", MeshFormat::Obj},
    TriangleFormat{"ply", ".ply", MeshFormat::Ply},
    TriangleFormat{"stl", ".stl", MeshFormat::Stl},
    TriangleFormat{"glb", ".glb", MeshFormat::Gltf},
};

/// Layers have one format.
constexpr std::array kCellFormats{TriangleFormat{"geojson", ".geojson", std::nullopt},
                                  TriangleFormat{"geojson", ".json", std::nullopt}};

/// A command that reads sets of the plane and writes a layer or triangles. It writes to the file of
/// -o. If neither -o nor --json is given, it writes to standard output.
class PartitionCommand : public CommandBody {
 public:
  ExitCode run(Session& session) override {
    open_output(session);
    session.expect(stages());
    require_one_stdin(files());
    compute(session);
    if (session.options().json) {
      session.outputs().add("-", [this](std::ostream& out) { out << facts().dump() << '\n'; });
    }
    session.deliver();
    return ExitCode::Yes;
  }

 protected:
  virtual std::span<const TriangleFormat> formats() const { return kCellFormats; }
  virtual ProgressStages stages() const = 0;
  virtual std::vector<std::string> files() const = 0;
  virtual void compute(Session& session) = 0;
  virtual Json facts() const = 0;
  virtual void write(std::ostream& out, const TriangleFormat& format, Session& session) const = 0;

  /// Returns a layer whose coordinates are doubles.
  static Layer rounded(const Layer& layer, Session& session) {
    session.begin("repair");
    return repair_layer(layer, {OwnerRule::First, 0.0}, session.context()).layer;
  }

  PlaneInput input_;

 private:
  void open_output(Session& session) {
    const CommonOptions& common = session.options();
    if (common.out == "-" && common.format.empty()) {
      throw Error(ErrorCode::Usage, "-o - needs --format " + names_of(formats()));
    }
    if (common.json && common.out.empty() && common.format.empty()) return;
    const TriangleFormat* format = &formats().front();
    if (!common.format.empty()) {
      format = &format_named(formats(), common.format);
    } else if (!common.out.empty()) {
      format = &format_of_file(formats(), common.out);
    }
    const std::string out = common.out.empty() ? "-" : common.out;
    session.outputs().add(
        out, [this, format, &session](std::ostream& stream) { write(stream, *format, session); });
  }
};

// --- triangulate --------------------------------------------------------------------------------

PolygonMesh mesh_of(const PlaneTriangulation& triangulation) {
  PolygonMesh mesh;
  for (std::uint32_t i = 0; i < triangulation.points.size(); ++i) {
    const Point2 p = triangulation.points.approx(i);
    mesh.points.push_back({p.x, p.y, 0});
  }
  for (const auto& triangle : triangulation.triangles) mesh.add_face(triangle);
  return mesh;
}

Layer layer_of(const PlaneTriangulation& triangulation) {
  Layer layer;
  layer.points = triangulation.points;
  for (const auto& triangle : triangulation.triangles) {
    layer.ring_corners.insert(layer.ring_corners.end(), triangle.begin(), triangle.end());
    layer.end_ring();
    layer.end_polygon();
    layer.end_feature({}, {});
  }
  return layer;
}

/// Returns the vertices of a set as points.
PointTable2 vertices_of(const Nef2& set) {
  PointTable2 points;
  const PlaneComplex& complex = set.complex();
  for (std::size_t v = 0; v < complex.vertex_count(); ++v) {
    const RationalPoint2 at = exact(complex.points, complex.vertex_point[VertexId(v)]);
    points.push_back(at.x, at.y);
  }
  return points;
}

class PlaneTriangulate : public PartitionCommand {
 public:
  void declare(CLI::App& app) override {
    declare_first<Plane>(app, a_);
    app.add_flag("--points", by_points_, "Triangulate the convex hull of the vertices of A");
    input_.declare(app);
  }

 private:
  std::span<const TriangleFormat> formats() const override { return kTriangleFormats; }
  ProgressStages stages() const override {
    return {Plane::reading(), Plane::combining(), writing()};
  }
  std::vector<std::string> files() const override { return {a_}; }
  void compute(Session& session) override {
    const Nef2 set = std::move(read_sets(input_, {a_}, session).front());
    session.begin("combine");
    Context& context = session.context();
    if (!set.is_bounded()) {
      throw Error(ErrorCode::BadArgument, "an unbounded set cannot be triangulated",
                  {.file = input_name(a_)});
    }
    const Nef2 rounded = round_to_doubles(set, context).set;
    result_ = by_points_ ? delaunay(vertices_of(rounded), context) : delaunay(rounded, context);
  }
  Json facts() const override {
    return {{"points", result_.points.size()}, {"triangles", result_.triangles.size()}};
  }
  void write(std::ostream& out, const TriangleFormat& format, Session& session) const override {
    if (format.mesh) {
      write_mesh(out, mesh_of(result_), *format.mesh);
    } else {
      write_layer_geojson(out, layer_of(result_), session.context());
    }
  }

  std::string a_;
  bool by_points_ = false;
  PlaneTriangulation result_;
};

// --- voronoi ------------------------------------------------------------------------------------

class PlaneVoronoi : public PartitionCommand {
 public:
  void declare(CLI::App& app) override {
    app.add_option("A", a_, "A set, whose vertices are the sites: .wkt, .geojson, .wkb, .nef2")
        ->required()
        ->type_name("");
    app.add_option("--box", box_,
                   "The box of the cells (default: the box of the sites, enlarged by a tenth)")
        ->type_name("X,Y,X,Y");
    input_.declare(app);
  }

 private:
  ProgressStages stages() const override {
    return {Plane::reading(), Plane::combining(), repairing_layer(), writing()};
  }
  std::vector<std::string> files() const override { return {a_}; }
  void compute(Session& session) override {
    const Nef2 set = std::move(read_sets(input_, {a_}, session).front());
    const PointTable2 sites = vertices_of(set);
    const auto [low, high] = box_.empty() ? box_around(sites) : box_of_option(session);
    session.begin("combine");
    Layer cells = voronoi_cells(sites, low, high, session.context());
    cells = rounded(cells, session);
    set_properties(cells, sites);
    result_ = std::move(cells);
  }
  std::pair<RationalPoint2, RationalPoint2> box_of_option(Session& session) const {
    const std::vector<std::string> words = CLI::detail::split(box_, ',');
    if (words.size() != 4) throw Error(ErrorCode::Usage, "--box needs four numbers: X,Y,X,Y");
    std::array<Rational, 4> v;
    for (std::size_t i = 0; i < 4; ++i) v[i] = read_number_argument(words[i], "--box", session);
    if (!(v[0] < v[2] && v[1] < v[3])) {
      throw Error(ErrorCode::Usage, "--box needs its lower left corner first");
    }
    return {{v[0], v[1]}, {v[2], v[3]}};
  }
  /// Returns the box of the sites, enlarged by a tenth of its greater side.
  static std::pair<RationalPoint2, RationalPoint2> box_around(const PointTable2& sites) {
    if (sites.size() == 0) return {{0, 0}, {1, 1}};
    RationalPoint2 low = sites.exact(0);
    RationalPoint2 high = low;
    for (std::uint32_t i = 1; i < sites.size(); ++i) {
      const RationalPoint2 p = sites.exact(i);
      low = {std::min(low.x, p.x), std::min(low.y, p.y)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
    Rational margin = std::max(high.x - low.x, high.y - low.y) / 10;
    if (margin == 0) margin = 1;
    return {{low.x - margin, low.y - margin}, {high.x + margin, high.y + margin}};
  }
  /// Assigns its site to each feature.
  static void set_properties(Layer& cells, const PointTable2& sites) {
    cells.json.clear();
    cells.json_begin = {0};
    for (std::uint32_t i = 0; i < sites.size(); ++i) {
      const Point2 p = sites.approx(i);
      cells.json_begin.push_back(cells.json.size());
      cells.json += Json{{"site", Json::array({p.x, p.y})}}.dump();
      cells.json_begin.push_back(cells.json.size());
    }
  }
  Json facts() const override { return {{"cells", result_.feature_count()}}; }
  void write(std::ostream& out, const TriangleFormat&, Session& session) const override {
    write_layer_geojson(out, result_, session.context());
  }

  std::string a_;
  std::string box_;
  Layer result_;
};

// --- arrange ------------------------------------------------------------------------------------

class PlaneArrange : public PartitionCommand {
 public:
  void declare(CLI::App& app) override {
    declare_first<Plane>(app, a_);
    app.add_option("B", others_, "More sets")->type_name("");
    input_.declare(app);
  }

 private:
  ProgressStages stages() const override {
    ProgressStages all(1 + others_.size(), Plane::reading());
    all.insert(all.end(), {Plane::combining(), repairing_layer(), writing()});
    return all;
  }
  std::vector<std::string> files() const override {
    std::vector<std::string> all{a_};
    all.insert(all.end(), others_.begin(), others_.end());
    return all;
  }
  void compute(Session& session) override {
    const std::vector<Nef2> sets = read_sets(input_, files(), session);
    session.begin("combine");
    Context& context = session.context();
    std::vector<Nef2> lines;
    for (const Nef2& set : sets) lines.push_back(set.boundary(context));
    const Nef2 faces = union_of(lines, context).complement(context);
    Layer layer = layer_of_faces(faces, context);
    const std::vector<Json> members = members_of(faces, sets, context);
    layer = rounded(layer, session);
    set_properties(layer, members);
    result_ = std::move(layer);
  }
  /// Returns for each bounded face the names of the sets that contain it.
  std::vector<Json> members_of(const Nef2& faces, const std::vector<Nef2>& sets,
                               Context& context) const {
    const std::vector<RationalPoint2> inside = points_inside(faces, context);
    std::vector<Json> members;
    for (const RationalPoint2& p : inside) {
      Json names = Json::array();
      for (std::size_t i = 0; i < sets.size(); ++i) {
        if (sets[i].contains(p, context)) names.push_back(input_name(files()[i]));
      }
      members.push_back({{"in", std::move(names)}});
    }
    return members;
  }
  /// Returns a point inside each bounded face, in the order of the faces. The point is the centroid
  /// of a triangle.
  static std::vector<RationalPoint2> points_inside(const Nef2& faces, Context& context) {
    const PlaneComplex& complex = faces.complex();
    std::vector<std::optional<RationalPoint2>> found(complex.face_count());
    const PlaneTriangulation t = delaunay(without_unbounded_faces(faces), context);
    for (const auto& [a, b, c] : t.triangles) {
      const RationalPoint2 p = t.points.exact(a), q = t.points.exact(b), r = t.points.exact(c);
      const RationalPoint2 middle{(p.x + q.x + r.x) / 3, (p.y + q.y + r.y) / 3};
      const FaceId face = faces.locate(middle, context).face;
      if (!found[face.value()]) found[face.value()] = middle;
    }
    std::vector<RationalPoint2> points;
    for (const auto& point : found) {
      if (point) points.push_back(*point);
    }
    return points;
  }
  static Nef2 without_unbounded_faces(const Nef2& faces) {
    PlaneComplex complex = faces.complex();
    for (std::size_t f = 0; f < complex.face_count(); ++f) {
      if (is_unbounded(complex, FaceId(f))) complex.marks.face[FaceId(f)] = 0;
    }
    return Nef2::from_complex(std::move(complex));
  }
  static void set_properties(Layer& layer, const std::vector<Json>& members) {
    layer.json.clear();
    layer.json_begin = {0};
    for (const Json& properties : members) {
      layer.json_begin.push_back(layer.json.size());
      layer.json += properties.dump();
      layer.json_begin.push_back(layer.json.size());
    }
  }
  Json facts() const override { return {{"faces", result_.feature_count()}}; }
  void write(std::ostream& out, const TriangleFormat&, Session& session) const override {
    write_layer_geojson(out, result_, session.context());
  }

  std::string a_;
  std::vector<std::string> others_;
  Layer result_;
};

}  // namespace

std::unique_ptr<CommandBody> make_plane_triangulate() {
  return std::make_unique<PlaneTriangulate>();
}
std::unique_ptr<CommandBody> make_plane_voronoi() { return std::make_unique<PlaneVoronoi>(); }
std::unique_ptr<CommandBody> make_plane_arrange() { return std::make_unique<PlaneArrange>(); }

}  // namespace plumb::cli
