// Scenes from files: a model, polygons traced on it, and drawings placed on it.
//
// SceneMaker turns parsed points into points of the surface, traces each polygon through its
// control points (surface/trace.h), adds shapes and levels, and reports errors at their place in
// the scene's text. A drawing is mapped to the surface by straight lines from its centre
// (surface/exponential_map.h), point by point; its rings are then traced as polygons. Shapes of
// drawings have label zero at the face farthest from the centre, unless the scene says otherwise.
//
// In faces that the mesh flipped, the weights are exchanged, so that a point lies where its author
// placed it. Format: docs/formats.md, section Scenes.
// Tested by tests/io/scene_reader_test.cpp and tests/io/svg_reader_test.cpp.

#include "plumb/io/scene_reader.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "plumb/base/context.h"
#include "plumb/io/mesh_io.h"
#include "plumb/io/surface/scene_parser.h"
#include "plumb/io/svg_reader.h"
#include "plumb/io/text/files.h"
#include "plumb/io/text/foreign_files.h"
#include "plumb/io/text/input_cursors.h"
#include "plumb/predicates/error.h"
#include "plumb/predicates/rounding.h"
#include "plumb/surface/exponential_map.h"
#include "plumb/surface/surface.h"
#include "plumb/surface/trace.h"

namespace plumb {

/// Appends the rings of a drawing as polygons, and its shapes, which scene.shapes must hold.
/// `centre` is a point of scene.polygons in `face`. Errors have their place in the file of the
/// drawing: BadShape for points beyond the border, ResourceLimit for those too far away; Cancelled.
void add_drawing(const DrawingFile& file, const ParsedScene::Drawing& how, SurfacePointId centre,
                 FaceId face, Tracer& tracer, SurfaceScene& scene, Context& context);

/// Returns the first face, of those in the component of `face`, whose first corner is farthest from
/// a point in a straight line: labels of drawings are zero there.
FaceId farthest_face(const SurfaceMesh& mesh, const Point3& from, FaceId face);

namespace {

constexpr std::uint64_t kPointBytes = 96;  // The memory of a control point, in tables and lists.
constexpr std::size_t kDrawnPerCheckpoint = 256;

/// Returns points of the surface for all points of the drawing.
std::vector<SurfacePointId> placed_points(const DrawingFile& file, const ExponentialMap& map,
                                          double scale, SurfacePointTable& points,
                                          Context& context) {
  const SvgDrawing& drawing = file.drawing;
  TextCursor cursor(file.text, file.name);
  std::vector<SurfacePointId> placed;
  for (std::size_t i = 0; i < drawing.points.size(); ++i) {
    if (i % kDrawnPerCheckpoint == 0) context.checkpoint("draw", i, drawing.points.size());
    cursor.move_to(file.text.data() + drawing.places[i]);
    const Point2 p = drawing.points[i];
    const auto at = with_place(cursor, [&] {
      context.charge_memory(kPointBytes, "drawings on the surface");
      return map.add({scale * p.x, scale * p.y}, points, context);
    });
    if (!at) cursor.fail(ErrorCode::BadShape, "what is drawn here lies beyond the border");
    placed.push_back(*at);
  }
  return placed;
}

}  // namespace

void add_drawing(const DrawingFile& file, const ParsedScene::Drawing& how, SurfacePointId centre,
                 FaceId face, Tracer& tracer, SurfaceScene& scene, Context& context) {
  const SvgDrawing& drawing = file.drawing;
  SurfacePolygons& polygons = scene.polygons;
  const ExponentialMap map(polygons.points, centre, face, how.angle);
  const std::vector<SurfacePointId> placed =
      placed_points(file, map, how.scale, polygons.points, context);
  for (std::size_t s = 0; s < drawing.shape_count(); ++s) {
    std::vector<std::uint32_t>& shape = scene.shapes->emplace_back();
    for (std::uint32_t r = drawing.shape_begin[s]; r < drawing.shape_begin[s + 1]; ++r) {
      context.checkpoint("trace", r, drawing.ring_count());
      const auto ring = std::span(placed).subspan(
          drawing.ring_begin[r], drawing.ring_begin[r + 1] - drawing.ring_begin[r]);
      shape.push_back(static_cast<std::uint32_t>(polygons.size()));
      const auto torn = add_traced_polygon(tracer, ring, polygons, context);
      PLUMB_CHECK(!torn);  // Lines never leave their component.
    }
  }
}

FaceId farthest_face(const SurfaceMesh& mesh, const Point3& from, FaceId face) {
  FaceId farthest = face;
  double most = -1;
  for (std::uint32_t i = 0; i < mesh.face_count(); ++i) {
    const FaceId f(i);
    if (mesh.component(f) != mesh.component(face)) continue;
    const Point3& p = mesh.point(mesh.corner(f, 0));
    const double distance = std::hypot(p.x - from.x, p.y - from.y, p.z - from.z);
    if (distance <= most) continue;
    most = distance;
    farthest = f;
  }
  return farthest;
}

namespace {

/// Adds a point on an edge. Decimals are rounded to the nearest double if that is a place inside
/// the edge.
SurfacePointId add_on_edge(SurfacePointTable& points, HalfedgeId h,
                           const Rational& weight_of_target, bool rounds) {
  const SurfaceMesh& mesh = points.mesh();
  const Rational t = mesh.is_upward(h) ? weight_of_target : Rational(1 - weight_of_target);
  const double rounded = nearest_double(t);
  if (rounds && rounded > 0 && rounded < 1) return points.add_on_edge(mesh.edge(h), rounded);
  return points.add_on_edge(mesh.edge(h), t);
}

constexpr std::uint64_t kTracerBytesPerFace = 40;

class SceneMaker {
 public:
  SceneMaker(const ParsedScene& scene, std::shared_ptr<const SurfaceMesh> mesh,
             std::string_view text, const ReadOptions& options, Context& context)
      : in_(scene), mesh_(std::move(mesh)), text_(text), name_(options.name), context_(context) {}

  SurfaceScene run(std::span<const DrawingFile* const> drawings) {
    SurfaceScene scene{mesh_, SurfacePolygons(*mesh_), {}, {}};
    add_points(in_.points, scene.polygons.points);
    MemoryCharge memory(context_);
    memory.add(kTracerBytesPerFace * mesh_->face_count(), "traced paths");
    Tracer tracer(*mesh_, in_.has_shortest_paths ? PathChoice::Shortest : PathChoice::Local);
    trace(tracer, scene.polygons);
    if (in_.shapes) add_shapes(*in_.shapes, scene.shapes.emplace());
    if (!in_.drawings.empty()) draw(drawings, tracer, scene);
    if (in_.outside) {
      require_face(*in_.outside, in_.outside_place);
      scene.outside = FaceId(*in_.outside);
    }
    add_levels(scene);
    return scene;
  }

 private:
  // The pairs of shape and component.
  using Levels = std::set<std::pair<std::uint32_t, std::uint32_t>>;

  [[noreturn]] void fail(ErrorCode code, const std::string& message, std::size_t place) const {
    TextCursor cursor(text_, name_);
    cursor.move_to(text_.data() + place);
    cursor.fail(code, message);
  }

  void require_face(std::uint32_t face, std::size_t place) const {
    if (face < mesh_->face_count()) return;
    fail(ErrorCode::BadIndex,
         "no face " + std::to_string(face) + ": the model has " +
             std::to_string(mesh_->face_count()) + " triangles, counted from 0",
         place);
  }

  static void add_shapes(const ParsedScene::Lists& lists,
                         std::vector<std::vector<std::uint32_t>>& shapes) {
    for (std::size_t s = 0; s < lists.size(); ++s) {
      shapes.emplace_back(lists.items.begin() + lists.begin[s],
                          lists.items.begin() + lists.begin[s + 1]);
    }
  }

  [[noreturn]] void fail_shape(std::uint32_t shape, std::size_t count, std::size_t place) const {
    fail(ErrorCode::BadIndex,
         "no shape " + std::to_string(shape) + ": there are " + std::to_string(count) +
             ", counted from 0",
         place);
  }

  void add_levels(SurfaceScene& scene) const {
    Levels known;
    const std::size_t shapes = scene.shapes ? scene.shapes->size() : scene.polygons.size();
    for (const auto& [level, place] : in_.levels) {
      require_face(level.face.value(), place);
      if (level.shape >= shapes) fail_shape(level.shape, shapes, place);
      if (!known.emplace(level.shape, mesh_->component(level.face)).second) {
        fail(ErrorCode::BadShape,
             "a second level of shape " + std::to_string(level.shape) +
                 " in one component of the model",
             place);
      }
      scene.levels.push_back(level);
    }
  }

  /// Adds points. Their ids are their indices, after the existing points.
  void add_points(const ScenePoints& in, SurfacePointTable& points) const {
    for (std::uint32_t i = 0; i < in.size(); ++i) add_point(in, i, points);
  }

  void add_point(const ScenePoints& in, std::uint32_t i, SurfacePointTable& points) const {
    require_face(in.face[i], in.place[i]);
    const FaceId f(in.face[i]);
    const bool is_flipped = mesh_->is_flipped(f), rounds = in.rounds[i] != 0;
    const Point2 near = in.weights.approx(i);
    if (in.weights.is_double(i) && near.x > 0 && near.y > 0 && near.x + near.y < 1) {
      points.add_in_face(f, is_flipped ? near.y : near.x, is_flipped ? near.x : near.y);
      return;
    }
    auto [u, v] = in.weights.exact(i);
    if (is_flipped) std::swap(u, v);
    const bool is_inside = u > 0 && v > 0 && u + v < 1;
    const auto is_end = [](const Rational& x) { return x.is_zero() || x == 1; };
    const bool is_vertex = is_end(u) && is_end(v);
    if (is_inside || is_vertex) {
      points.add_in_face(f, u, v);
    } else if (v == 0) {
      add_on_edge(points, SurfaceMesh::halfedge(f, 0), u, rounds);
    } else if (u == 0) {
      add_on_edge(points, SurfaceMesh::halfedge(f, 2), 1 - v, rounds);
    } else {
      add_on_edge(points, SurfaceMesh::halfedge(f, 1), v, rounds);
    }
  }

  void draw(std::span<const DrawingFile* const> drawings, Tracer& tracer,
            SurfaceScene& scene) const {
    PLUMB_CHECK(drawings.size() == in_.drawings.size());
    if (!scene.shapes) {
      scene.shapes.emplace();
      for (std::uint32_t p = 0; p < scene.polygons.size(); ++p) scene.shapes->push_back({p});
    }
    const std::size_t first = scene.polygons.points.size();
    add_points(in_.centers, scene.polygons.points);
    const Levels given = given_levels();
    for (std::size_t i = 0; i < drawings.size(); ++i) {
      context_.checkpoint("draw", i, drawings.size());
      const SurfacePointId centre(first + i);
      const FaceId face(in_.centers.face[i]);
      const std::size_t shapes = scene.shapes->size();
      add_drawing(*drawings[i], in_.drawings[i], centre, face, tracer, scene, context_);
      const Point3 from = scene.polygons.points.position(centre);
      add_zeros(shapes, farthest_face(*mesh_, from, face), given, scene);
    }
  }

  /// Gives the shapes from `first` on the label zero in a face, unless the scene states more about
  /// their component.
  void add_zeros(std::size_t first, FaceId face, const Levels& given, SurfaceScene& scene) const {
    const std::uint32_t component = mesh_->component(face);
    if (in_.outside && *in_.outside < mesh_->face_count() &&
        mesh_->component(FaceId(*in_.outside)) == component) {
      return;
    }
    for (auto s = static_cast<std::uint32_t>(first); s < scene.shapes->size(); ++s) {
      if (!given.contains({s, component})) scene.levels.push_back({s, face, 0});
    }
  }

  /// Returns the levels of faces that exist. The other levels are refused later.
  Levels given_levels() const {
    Levels given;
    for (const auto& [level, place] : in_.levels) {
      if (level.face.value() < mesh_->face_count()) {
        given.emplace(level.shape, mesh_->component(level.face));
      }
    }
    return given;
  }

  void trace(Tracer& tracer, SurfacePolygons& polygons) const {
    std::vector<SurfacePointId> control;
    std::vector<FaceId> named;
    for (std::size_t p = 0; p < in_.polygons.size(); ++p) {
      context_.checkpoint("trace", p, in_.polygons.size());
      control.clear();
      named.clear();
      for (std::uint32_t i = in_.polygons.begin[p]; i < in_.polygons.begin[p + 1]; ++i) {
        control.push_back(SurfacePointId(in_.polygons.items[i]));
        named.push_back(FaceId(in_.points.face[in_.polygons.items[i]]));
      }
      const auto torn = add_traced_polygon(tracer, control, named, polygons, context_);
      if (torn) fail_torn(p, *torn);
    }
  }

  [[noreturn]] void fail_torn(std::size_t polygon, std::size_t leg) const {
    const std::uint32_t begin = in_.polygons.begin[polygon];
    const std::size_t size = in_.polygons.begin[polygon + 1] - begin;
    const std::size_t a = begin + leg, b = begin + (leg + 1) % size;
    const auto where = [&](std::size_t i) {
      const std::uint32_t point = in_.polygons.items[i];
      return "point " + std::to_string(point) + " (face " + std::to_string(in_.points.face[point]) +
             ')';
    };
    fail(ErrorCode::BadShape,
         "polygon " + std::to_string(polygon) + ": no path joins " + where(a) + " and " + where(b) +
             ", which lie on different components of the model",
         in_.polygons.places[a]);
  }

  const ParsedScene& in_;
  std::shared_ptr<const SurfaceMesh> mesh_;
  std::string_view text_;
  const std::string& name_;
  Context& context_;
};

/// Throws Error{DegenerateFace} if a face of the file gives no triangle. Scenes name faces by their
/// numbers, so such a face must not be left out.
void require_triangles_of_all(const MeshFile& file, const std::string& name) {
  const auto refuse = [&](const std::string& what) {
    throw Error(ErrorCode::DegenerateFace,
                what + "; remove such faces, and number the faces of the scene without them",
                {name});
  };
  if (file.faces_left_out > 0) {
    refuse("the file has faces of which two corners are equal; their number is " +
           std::to_string(file.faces_left_out));
  }
  for (std::size_t f = 0; f < file.mesh.face_count(); ++f) {
    const std::size_t corners = file.mesh.face(f).size();
    if (corners >= 3) continue;
    refuse("face " + std::to_string(f) + " has " + std::to_string(corners) +
           (corners == 1 ? " corner" : " corners"));
  }
}

/// Returns the surface of a mesh. Errors of the mesh are reported with the name of its file.
SurfaceMesh surface_in(const PolygonMesh& mesh, const std::string& name, Context& context) {
  context.charge_memory(std::uint64_t{60} * (mesh.corners.size() - 2 * mesh.face_count()),
                        "the surface");
  try {
    return fanned_surface(mesh);
  } catch (const Error& error) {
    if (error.code() == ErrorCode::ResourceLimit) throw;
    throw Error(error.code(), error.message(), {name});
  }
}

std::size_t turned_faces(const SurfaceMesh& mesh) {
  std::size_t turned = 0;
  for (std::uint32_t f = 0; f < mesh.face_count(); ++f) turned += mesh.is_flipped(FaceId(f));
  return turned;
}

using SceneNotes = std::vector<std::string>;

void add_notes(const std::string& file, const std::vector<std::string>& notes, SceneNotes& to) {
  for (const std::string& note : notes) to.push_back(file + ": " + note);
}

DrawingFile read_drawing(const std::string& path, std::optional<double> tolerance,
                         Context& context) {
  DrawingFile file{path, read_input(path, context), {}};
  file.drawing = read_svg(file.text, {path, false}, tolerance, context);
  return file;
}

}  // namespace

SurfaceScene make_scene(const ParsedScene& scene, std::shared_ptr<const SurfaceMesh> mesh,
                        std::string_view text, const ReadOptions& options, Context& context,
                        std::span<const DrawingFile* const> drawings) {
  return SceneMaker(scene, std::move(mesh), text, options, context).run(drawings);
}

SurfaceMesh fanned_surface(const PolygonMesh& mesh) {
  std::vector<SurfaceTriangle> triangles;
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    const auto face = mesh.face(f);
    for (std::size_t k = 2; k < face.size(); ++k) {
      triangles.push_back({face[0], face[k - 1], face[k]});
    }
  }
  return {mesh.points, std::move(triangles)};
}

SceneFile read_scene_file(const std::string& path, ReadOptions options, Context& context) {
  options.name = input_name(path);
  const std::string text = read_input(path, context);
  const ParsedScene scene = naming_foreign_files(
      text, "scene", options.name, [&] { return parse_scene(text, options, context); });
  const auto beside = [&](const std::string& name) {
    return named_file(path, name, options.named_files);
  };
  SceneNotes notes;
  const std::string model = beside(scene.model);
  MeshFile file = read_mesh_file(model, {}, options, context);
  require_triangles_of_all(file, model);
  const auto mesh = std::make_shared<const SurfaceMesh>(surface_in(file.mesh, model, context));
  add_notes(model, file.notes, notes);
  if (const std::size_t turned = turned_faces(*mesh); turned > 0) {
    add_notes(model, {{std::to_string(turned) + " faces flipped to agree with their component"}},
              notes);
  }
  std::map<std::pair<std::string, std::optional<double>>, DrawingFile> files;
  std::vector<const DrawingFile*> drawings;
  for (const ParsedScene::Drawing& d : scene.drawings) {
    const std::string name = beside(d.file);
    const auto [entry, is_new] = files.try_emplace({name, d.tolerance});
    drawings.push_back(&entry->second);
    if (!is_new) continue;
    entry->second = read_drawing(name, d.tolerance, context);
    add_notes(name, entry->second.drawing.notes, notes);
  }
  return {make_scene(scene, mesh, text, options, context, drawings), scene.points.size(), model,
          std::move(notes), std::move(file.warnings)};
}

}  // namespace plumb
