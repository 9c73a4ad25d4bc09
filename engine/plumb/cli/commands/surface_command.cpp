// The commands `plumb surface ...`: polygons on meshes, the cells they make, Booleans of them, and
// pictures.
//
// All read a scene and answer as text or JSON; all but `path` divide its surface. Triangles, a
// graph of cells, a scene, or a picture go to a file that is opened before the work. A result of a
// Boolean is also written as a scene, whose model is named relative to the folder of the output, so
// that it can be read again. Tested by tests/cli/surface_command_test.cpp.

#include <algorithm>
#include <array>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <ostream>
#include <sstream>
#include <string>
#include <utility>

#include "plumb/cli/files/operands.h"
#include "plumb/cli/files/outputs.h"
#include "plumb/cli/session/command.h"
#include "plumb/cli/session/progress.h"
#include "plumb/io/surface_writer.h"
#include "plumb/io/text/file_names.h"
#include "plumb/io/text/files.h"
#include "plumb/io/text/text_output.h"
#include "plumb/picture/scene_glb.h"
#include "plumb/picture/surface_scene.h"
#include "plumb/picture/svg/sheet.h"
#include "plumb/predicates/error.h"
#include "plumb/surface/cells/surface_arrangement.h"
#include "plumb/surface/cells/surface_cells.h"
#include "plumb/surface/surface.h"
#include "plumb/surface/trace.h"

namespace plumb::cli {
namespace {

using Json = nlohmann::ordered_json;

// ---------------------------------------------------------------- what all of them do

Json entries_json(std::span<const SignedEntry> entries) {
  Json list = Json::array();
  for (const SignedEntry& e : entries) list.push_back({e.id, e.value});
  return list;
}

enum class SurfaceFile : std::uint8_t { Obj, Ply, Glb, Graph, Scene };
struct Format {
  std::string_view name;
  std::string_view extension;
  SurfaceFile file;
};
constexpr std::array kCellFormats{
    Format{"obj", ".obj", SurfaceFile::Obj},
    Format{"ply", ".ply", SurfaceFile::Ply},
    Format{"glb", ".glb", SurfaceFile::Glb},
    Format{"dot", ".dot", SurfaceFile::Graph},
};
constexpr std::array kResultFormats{
    kCellFormats[0],
    kCellFormats[1],
    kCellFormats[2],
    kCellFormats[3],
    Format{"scene", ".json", SurfaceFile::Scene},
};

/// Returns the path of the model relative to the folder of `out`.
std::string model_beside(const std::string& model, const std::string& out) {
  namespace fs = std::filesystem;
  std::error_code error;
  const fs::path folder = out == "-" ? fs::path() : path_of(out).parent_path();
  const fs::path absolute = fs::absolute(folder.empty() ? fs::path(".") : folder, error);
  const fs::path beside = fs::proximate(fs::absolute(path_of(model), error), absolute, error);
  return error || beside.empty() ? model : file_name_of(beside);
}

/// A command that prints an answer, and may also write a file, for example a file of triangles.
class SurfaceCommand : public CommandBody {
 protected:
  /// Opens the file before the work.
  template <class Table>
  void open(const Table& formats, Session& session) {
    const CommonOptions& common = session.options();
    if (common.out == "-" && common.format.empty()) {
      throw Error(ErrorCode::Usage, "-o - needs --format " + names_of(formats));
    }
    if (!common.out.empty() || !common.format.empty()) {
      path_ = common.out.empty() ? "-" : common.out;
      format_ = common.format.empty() ? format_of_file(formats, path_).file
                                      : format_named(formats, common.format).file;
      session.outputs().add(path_, [this](std::ostream& out) { out << bytes_; });
    }
    if (path_ != "-") {
      session.outputs().add("-", [this](std::ostream& out) { out << answer_; });
    } else if (common.json) {
      throw Error(ErrorCode::Usage, "--json and the file cannot both be standard output");
    }
  }

  void fill(const DividedScene& in, const SurfaceResult* result, Session& session) {
    if (!format_) return;
    const SurfaceDivision& division = in.division;
    CellChoice chosen;
    if (result != nullptr) chosen = result->region.is_selected;
    std::ostringstream out;
    Context& context = session.context();
    switch (*format_) {
      case SurfaceFile::Obj:
        write_surface_obj(out, triangulate_surface(division, context), division.cell_count(),
                          chosen);
        break;
      case SurfaceFile::Ply:
        write_surface_ply(out, triangulate_surface(division, context), chosen);
        break;
      case SurfaceFile::Glb:
        write_scene_glb(out, labelled_scene(division, result, context), title());
        break;
      case SurfaceFile::Graph:
        write_cell_graph(out, division, chosen);
        break;
      case SurfaceFile::Scene:
        write_scene(out, result_scene(division, *result), model_beside(in.model, path_));
        break;
    }
    bytes_ = std::move(out).str();
  }

  ExitCode deliver(const Json& json, const std::string& text, Session& session) {
    answer_ = session.options().json ? json.dump() + '\n' : text;
    session.deliver();
    return ExitCode::Yes;
  }

 private:
  std::string title() const { return path_ == "-" ? "" : file_name_of(path_of(path_).filename()); }

  std::string path_;
  std::optional<SurfaceFile> format_;
  std::string bytes_, answer_;
};

// ---------------------------------------------------------------- cells

/// Computes the cells of a scene, with their labels, areas and neighbours.
class CellsCommand : public SurfaceCommand {
 public:
  void declare(CLI::App& app) override { input_.declare(app); }

  ExitCode run(Session& session) override {
    open(kCellFormats, session);
    session.expect(stages_of_surfaces());
    const DividedScene in = input_.read(session);
    session.begin("result");
    fill(in, nullptr, session);
    return deliver(session.options().json ? json_of(in, session.context()) : Json(),
                   text_of(in.division), session);
  }

 private:
  static Json json_of(const DividedScene& in, Context& context) {
    const SurfaceDivision& division = in.division;
    const SurfaceCounts counts = division.counts();
    Json polygons = Json::array(), shapes = Json::array(), labels = Json::array(),
         areas = Json::array(), graph = Json::array();
    for (std::uint32_t p = 0; p < division.scene().polygons.size(); ++p) {
      charge(2, context);
      polygons.push_back({{"id", p},
                          {"separates", division.polygon_separation(p).over_z},
                          {"length", polygon_length(division.scene().polygons, p)}});
    }
    for (std::uint32_t s = 0; s < division.shape_count(); ++s) {
      const Separation& separation = division.shape_separation(s);
      charge(2 + separation.cycle.size() / 4, context);
      Json cycle = Json::array();
      for (const CellId c : separation.cycle) cycle.push_back(c.value());
      shapes.push_back({{"id", s},
                        {"separates", separation.over_z},
                        {"separates_mod2", separation.mod_2},
                        {"cycle", std::move(cycle)}});
    }
    for (std::uint32_t c = 0; c < division.cell_count(); ++c) {
      charge(1 + division.labels(CellId(c)).size(), context);
      labels.push_back(entries_json(division.labels(CellId(c))));
      areas.push_back(division.area(CellId(c)));
    }
    for (const CellEdge& e : division.cells().edges) {
      const CellStep step = upward_step(division, e);
      charge(3 + step.polygons.size(), context);
      graph.push_back({{"from", step.from.value()},
                       {"to", step.to.value()},
                       {"polygons", entries_json(step.polygons)}});
    }
    Json repairs = Json::array();
    for (const SurfaceRepair& r : in.repairs) {
      repairs.push_back({{"shape", r.shape}, {"class", r.homology}, {"polygons", r.polygons}});
    }
    Json json{{"triangles", counts.triangles},   {"segments", counts.segments},
              {"crossings", counts.crossings},   {"cells", counts.cells},
              {"cell_edges", counts.cell_edges}, {"polygons", std::move(polygons)},
              {"shapes", std::move(shapes)},     {"labels", std::move(labels)},
              {"areas", std::move(areas)},       {"graph", std::move(graph)}};
    if (!repairs.empty()) json["repairs"] = std::move(repairs);
    return json;
  }

  /// Charges memory for lists of two numbers and their text. An object counts as several lists.
  static void charge(std::size_t lists, Context& context) {
    constexpr std::uint64_t kListBytes = 160;
    context.checkpoint("JSON", 0, 1);
    context.charge_memory(kListBytes * lists, "JSON");
  }

  static std::string text_of(const SurfaceDivision& division) {
    constexpr std::uint32_t kMostLines = 40;
    const SurfaceCounts counts = division.counts();
    std::ostringstream out;
    out << counted(counts.triangles, "triangle") << ", " << counted(counts.segments, "segment")
        << ", " << counted(counts.crossings, "crossing") << ", " << counted(counts.cells, "cell")
        << ", " << counted(counts.cell_edges, "edge") << " between cells\n";
    for (std::uint32_t s = 0; s < division.shape_count(); ++s) {
      const Separation& separation = division.shape_separation(s);
      if (separation.over_z) continue;
      out << "shape " << shape_name(s) << " does not separate the surface"
          << (separation.mod_2 ? ", but does modulo 2" : "") << ": see its cycle with --json\n";
    }
    for (std::uint32_t c = 0; c < division.cell_count() && c < kMostLines; ++c) {
      out << "cell " << c << ": " << label_text(division.labels(CellId(c))) << ", area "
          << format_double(division.area(CellId(c))) << '\n';
    }
    if (division.cell_count() > kMostLines) {
      out << "and " << division.cell_count() - kMostLines << " more\n";
    }
    return std::move(out).str();
  }

  SurfaceInput input_;
};

// ---------------------------------------------------------------- Booleans

/// Computes the result of an expression over shapes.
class BooleanCommand : public SurfaceCommand {
 public:
  void declare(CLI::App& app) override {
    input_.declare(app);
    input_.declare_expression(app, true);
  }

  ExitCode run(Session& session) override {
    open(kResultFormats, session);
    session.expect(stages_of_surfaces());
    const DividedScene in = input_.read(session);
    session.begin("result");
    const SurfaceResult result = input_.evaluate(in.division, session.context());
    fill(in, &result, session);
    const std::size_t loops = result.borders.size();
    return deliver({{"cells", result.region.cells}, {"area", result.region.area}, {"loops", loops}},
                   counted(result.region.cells, "cell") + ", area " +
                       format_double(result.region.area) + ", " + counted(loops, "border loop") +
                       '\n',
                   session);
  }

 private:
  SurfaceInput input_;
};

// ---------------------------------------------------------------- pictures

struct ImageFormat {
  std::string_view name;
  std::string_view extension;
  PictureFormat picture;
};
constexpr std::array kPictureFormats{
    ImageFormat{"png", ".png", PictureFormat::Png},
    ImageFormat{"svg", ".svg", PictureFormat::Svg},
    ImageFormat{"html", ".html", PictureFormat::Html},
    ImageFormat{"glb", ".glb", PictureFormat::Glb},
};

/// Draws a divided surface.
class DrawCommand : public CommandBody {
 public:
  void declare(CLI::App& app) override {
    input_.declare(app);
    app.add_option("--what", what_, "polygons, slices, cells, labels, result")
        ->required()
        ->type_name("WHAT")
        ->check(CLI::IsMember(
                    std::vector<std::string>(kSurfaceLayerNames.begin(), kSurfaceLayerNames.end()))
                    .description(""));
    input_.declare_expression(app, false);
  }

  ExitCode run(Session& session) override {
    const ImageFormat& format = open(session);
    session.expect(stages_of_surfaces());
    const DividedScene in = input_.read(session);
    session.begin("result");
    std::optional<SurfaceResult> result;
    if (input_.has_expression()) result = input_.evaluate(in.division, session.context());
    const std::string title = file_name_of(path_of(input_name(input_.file())).filename());
    picture_ = picture_of(in.division, result ? &*result : nullptr, layer(),
                          picture(format.picture, title), session.context());
    if (session.options().json) {
      json_ = Json{{"what", what_}, {"format", format.name}}.dump();
    }
    session.deliver();
    return ExitCode::Yes;
  }

 private:
  SurfaceLayer layer() const {
    const auto found = std::ranges::find(kSurfaceLayerNames, what_);
    return static_cast<SurfaceLayer>(found - kSurfaceLayerNames.begin());
  }

  const ImageFormat& open(Session& session) {
    const CommonOptions& common = session.options();
    if (layer() == SurfaceLayer::Result && !input_.has_expression()) {
      throw Error(ErrorCode::Usage, "--what result needs --op EXPR");
    }
    if (common.format.empty() && (common.out.empty() || common.out == "-")) {
      throw Error(ErrorCode::Usage, "draw needs -o OUT (" + extensions_of(kPictureFormats) +
                                        ") or --format " + names_of(kPictureFormats));
    }
    const ImageFormat& format = common.format.empty()
                                    ? format_of_file(kPictureFormats, common.out)
                                    : format_named(kPictureFormats, common.format);
    session.outputs().add(common.out.empty() ? "-" : common.out,
                          [this](std::ostream& out) { out << picture_; });
    if (common.json) {
      session.outputs().add("-", [this](std::ostream& out) { out << json_ << '\n'; });
    }
    return format;
  }

  SurfaceInput input_;
  std::string what_;
  std::string picture_, json_;
};

// ---------------------------------------------------------------- paths

/// Finds a path between two points of a scene.
class PathCommand : public CommandBody {
 public:
  void declare(CLI::App& app) override {
    input_.declare_file(app);
    app.add_option("--from", from_, "The first point of the path (default 0)")->type_name("POINT");
    app.add_option("--to", to_, "The last point of the path (default 1)")->type_name("POINT");
    app.add_flag("--local", is_local_,
                 "Find a locally shortest path, as polygons use it; this is faster");
  }

  ExitCode run(Session& session) override {
    open(session);
    const SceneFile file = input_.read_undivided(session);
    session.begin("trace");
    const SurfacePolygons& polygons = file.scene.polygons;
    for (const std::uint32_t point : {from_, to_}) {
      if (point < file.point_count) continue;
      throw Error(ErrorCode::Usage, "no point " + std::to_string(point) + ": the scene has " +
                                        std::to_string(file.point_count) + ", counted from 0");
    }
    SurfacePointTable points = polygons.points;
    Tracer tracer(*file.scene.mesh, is_local_ ? PathChoice::Local : PathChoice::Shortest);
    const std::optional<SurfacePath> path =
        tracer.trace(points, SurfacePointId(from_), SurfacePointId(to_), session.context());
    if (!path) {
      throw Error(ErrorCode::BadShape, "no path joins the points " + std::to_string(from_) +
                                           " and " + std::to_string(to_) +
                                           ", which lie on different components of the model");
    }
    const double length = path_length(points, *path);
    if (session.options().json) {
      answer_ = json_of(points, *path, length).dump() + '\n';
    } else {
      answer_ =
          "length " + format_double(length) + ", " + counted(path->faces.size(), "segment") + '\n';
    }
    if (has_file_) polyline_ = obj_of(points, *path);
    session.deliver();
    return ExitCode::Yes;
  }

 private:
  void open(Session& session) {
    const CommonOptions& common = session.options();
    has_file_ = !common.out.empty() || !common.format.empty();
    const bool is_obj =
        common.format.empty() ? common.out.ends_with(".obj") : common.format == "obj";
    if (has_file_ && !is_obj) {
      throw Error(ErrorCode::Usage, "a path is written as a line of .obj: -o OUT.obj");
    }
    const std::string out = common.out.empty() ? "-" : common.out;
    if (has_file_) session.outputs().add(out, [this](std::ostream& to) { to << polyline_; });
    if (!has_file_ || out != "-") {
      session.outputs().add("-", [this](std::ostream& to) { to << answer_; });
    } else if (common.json) {
      throw Error(ErrorCode::Usage, "--json and the file cannot both be standard output");
    }
  }

  static Json json_of(const SurfacePointTable& points, const SurfacePath& path, double length) {
    Json at = Json::array(), faces = Json::array();
    for (const SurfacePointId p : path.points) {
      const Point3 position = points.position(p);
      at.push_back({position.x, position.y, position.z});
    }
    for (const FaceId f : path.faces) faces.push_back(f.value());
    return {{"length", length}, {"points", std::move(at)}, {"faces", std::move(faces)}};
  }

  static std::string obj_of(const SurfacePointTable& points, const SurfacePath& path) {
    std::ostringstream out;
    for (const SurfacePointId p : path.points) {
      const Point3 at = points.position(p);
      out << "v " << format_double(at.x) << ' ' << format_double(at.y) << ' ' << format_double(at.z)
          << '\n';
    }
    if (path.points.size() < 2) return std::move(out).str();
    out << 'l';
    for (std::size_t i = 1; i <= path.points.size(); ++i) out << ' ' << i;
    out << '\n';
    return std::move(out).str();
  }

  SurfaceInput input_;
  std::uint32_t from_ = 0, to_ = 1;
  bool is_local_ = false;
  bool has_file_ = false;
  std::string answer_, polyline_;
};

}  // namespace

std::unique_ptr<CommandBody> make_surface_cells() { return std::make_unique<CellsCommand>(); }
std::unique_ptr<CommandBody> make_surface_boolean() { return std::make_unique<BooleanCommand>(); }
std::unique_ptr<CommandBody> make_surface_draw() { return std::make_unique<DrawCommand>(); }
std::unique_ptr<CommandBody> make_surface_path() { return std::make_unique<PathCommand>(); }

}  // namespace plumb::cli
