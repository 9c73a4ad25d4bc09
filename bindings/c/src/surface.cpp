// Scenes of polygons on meshes, and the surfaces that they divide.
//
// A scene is the only handle that a caller changes. A region shares the surface that it is a part
// of. Weights of points are those of the mesh as the caller listed it: where SurfaceMesh has
// flipped a face, they are exchanged.
// Tested by tests/c/interface_test.c.
#include "plumb/surface/surface.h"

#include "files.h"
#include "handles.h"
#include "pictures.h"
#include "plumb/base/set_expression.h"
#include "plumb/io/scene_reader.h"
#include "plumb/io/surface_writer.h"
#include "plumb/picture/scene_glb.h"
#include "plumb/picture/surface_scene.h"
#include "plumb/surface/cells/surface_arrangement.h"
#include "plumb/surface/cells/surface_cells.h"
#include "plumb/surface/surface_arrays.h"
#include "plumb/surface/surface_audit.h"
#include "plumb/surface/surface_homology.h"
#include "plumb/surface/trace.h"
#include "plumb/surface/triangulation.h"
#include "sets.h"

struct plumb_scene {
  plumb::SurfaceScene scene;
};

struct plumb_path {
  std::vector<double> xyz;
  std::vector<std::uint32_t> faces;
  double length = 0;
};

struct plumb_surface {
  std::shared_ptr<const plumb::SurfaceDivision> division;
  std::vector<plumb_label> labels;        // Of all cells.
  std::vector<std::size_t> labels_begin;  // For each cell, and the end.
  std::vector<std::uint32_t> neighbours;  // Pairs of cells.
};

struct plumb_region {
  std::shared_ptr<const plumb::SurfaceDivision> division;
  plumb::SurfaceResult result;
};

namespace plumb::c {
namespace {

SurfaceScene empty_scene(SurfaceMesh mesh) {
  auto shared = std::make_shared<const SurfaceMesh>(std::move(mesh));
  SurfacePolygons polygons(*shared);
  return {std::move(shared), std::move(polygons), {}, FaceId(), {}};
}

void require_below(std::size_t index, std::size_t count, const char* what) {
  if (index >= count) {
    throw Error(ErrorCode::BadIndex, std::string(what) + " " + std::to_string(index) +
                                         " does not exist: there are " + std::to_string(count));
  }
}

std::uint32_t next_index(std::size_t count) { return static_cast<std::uint32_t>(count); }

std::vector<std::vector<std::uint32_t>> shapes_of(const SurfaceScene& scene) {
  if (scene.shapes) return *scene.shapes;
  std::vector<std::vector<std::uint32_t>> shapes;
  for (std::uint32_t p = 0; p < scene.polygons.size(); ++p) shapes.push_back({p});
  return shapes;
}

/// Adds loops to shapes until every one separates. Returns how many were added.
std::size_t separate(SurfaceScene& scene, Context& context) {
  const SurfaceHomology homology(*scene.mesh, context);
  SurfacePolygons polygons = scene.polygons;
  std::vector<std::vector<std::uint32_t>> shapes = shapes_of(scene);
  std::size_t count = 0;
  for (std::vector<std::uint32_t>& shape : shapes) {
    context.checkpoint("homology", 0, 0);
    const std::vector<std::int64_t> kind = homology.class_of(polygons, shape, context);
    if (std::all_of(kind.begin(), kind.end(), [](std::int64_t k) { return k == 0; })) continue;
    const std::vector<std::uint32_t> added = homology.add_repair(shape, polygons, context);
    shape.insert(shape.end(), added.begin(), added.end());
    count += added.size();
  }
  scene.polygons = std::move(polygons);
  scene.shapes = std::move(shapes);
  return count;
}

plumb_path path_of(const SurfacePath& path, const SurfacePointTable& points) {
  plumb_path handle;
  for (const SurfacePointId p : path.points) {
    const Point3 at = points.position(p);
    handle.xyz.insert(handle.xyz.end(), {at.x, at.y, at.z});
  }
  for (const FaceId f : path.faces) handle.faces.push_back(f.value());
  handle.length = path_length(points, path);
  return handle;
}

plumb_surface surface_handle(SurfaceScene scene, Context& context) {
  plumb_surface handle;
  handle.division = std::make_shared<const SurfaceDivision>(std::move(scene), context);
  handle.labels_begin.push_back(0);
  for (std::uint32_t c = 0; c < handle.division->cell_count(); ++c) {
    for (const SignedEntry& e : handle.division->labels(CellId(c))) {
      handle.labels.push_back({e.id, e.value});
    }
    handle.labels_begin.push_back(handle.labels.size());
  }
  for (const CellEdge& edge : handle.division->cells().edges) {
    handle.neighbours.push_back(edge.from.value());
    handle.neighbours.push_back(edge.to.value());
  }
  return handle;
}

const SurfaceResult* result_of(const plumb_surface& surface, const plumb_region* region) {
  if (region == nullptr) return nullptr;
  if (region->division != surface.division) fail_argument("region is of another surface");
  return &region->result;
}

void write_surface(std::ostream& out, const SurfaceDivision& division, const SurfaceResult* result,
                   const std::string& format, Context& context) {
  CellChoice chosen;
  if (result != nullptr) chosen = result->region.is_selected;
  if (format == "obj") {
    write_surface_obj(out, triangulate_surface(division, context), division.cell_count(), chosen);
  } else if (format == "ply") {
    write_surface_ply(out, triangulate_surface(division, context), chosen);
  } else if (format == "glb") {
    write_scene_glb(out, labelled_scene(division, result, context), "");
  } else if (format == "dot") {
    write_cell_graph(out, division, chosen);
  } else {
    fail_format(format, "obj, ply, glb, dot");
  }
}

}  // namespace
}  // namespace plumb::c

using namespace plumb;
using namespace plumb::c;

// --- scenes -------------------------------------------------------------------------------------

plumb_status plumb_scene_new(const double* xyz, std::size_t point_count,
                             const std::uint32_t* triangles, std::size_t triangle_count,
                             plumb_scene** out, plumb_error** error) {
  return make(out, error, [&] {
    return empty_scene(surface_of(mesh_of_triangles(
        finite(xyz, point_count, "xyz", 3), array(triangles, triangle_count, "triangles", 3))));
  });
}

plumb_status plumb_scene_read_file(const char* path, const plumb_read_options* options,
                                   plumb_scene** out, plumb_notes** notes,
                                   const plumb_context* context, plumb_error** error) {
  return make_with_notes(out, notes, error, [&](plumb_notes& told) {
    Call call(context);
    const std::string name = text(path, "path");
    SceneFile file = read_scene_file(name, read_options(options, name), call);
    add_notes(told, file.notes);
    add_warnings(told, file.warnings);
    return std::move(file.scene);
  });
}

plumb_status plumb_scene_write(const plumb_scene* scene, const char* model, plumb_bytes** out,
                               plumb_error** error) {
  return make(out, error, [&] {
    const std::string name = text(model, "model");
    need(scene, "scene");
    return written([&](std::ostream& stream) { write_scene(stream, scene->scene, name); });
  });
}

plumb_status plumb_scene_add_point(plumb_scene* scene, std::uint32_t face,
                                   const plumb_numbers* weights, std::uint32_t* index,
                                   plumb_error** error) {
  return guarded(error, [&] {
    need(index, "index");
    const SurfaceMesh& mesh = *need(scene, "scene").scene.mesh;
    const std::span<const Rational> v = exactly(weights, "weights", 2);
    require_below(face, mesh.face_count(), "face");
    const bool is_flipped = mesh.is_flipped(FaceId(face));
    *index = scene->scene.polygons.points
                 .add_in_face(FaceId(face), v[is_flipped ? 1 : 0], v[is_flipped ? 0 : 1])
                 .value();
  });
}

plumb_status plumb_scene_add_polygon(plumb_scene* scene, const std::uint32_t* points,
                                     std::size_t count, std::uint32_t* index,
                                     const plumb_context* context, plumb_error** error) {
  return guarded(error, [&] {
    need(index, "index");
    Call call(context);
    SurfacePolygons& polygons = need(scene, "scene").scene.polygons;
    if (count == 0) fail_argument("a polygon needs a point");
    std::vector<SurfacePointId> control;
    for (const std::uint32_t point : array(points, count, "points")) {
      require_below(point, polygons.points.size(), "point");
      control.push_back(SurfacePointId(point));
    }
    Tracer tracer(*scene->scene.mesh);
    const std::uint32_t made = next_index(polygons.size());
    const std::optional<std::size_t> stuck = add_traced_polygon(tracer, control, polygons, call);
    if (stuck) {
      throw Error(ErrorCode::BadShape,
                  "no path leads from points[" + std::to_string(*stuck) + "] to the next point");
    }
    *index = made;
  });
}

plumb_status plumb_scene_add_shape(plumb_scene* scene, const std::uint32_t* polygons,
                                   std::size_t count, std::uint32_t* index, plumb_error** error) {
  return guarded(error, [&] {
    need(index, "index");
    SurfaceScene& of = need(scene, "scene").scene;
    const std::span<const std::uint32_t> summands = array(polygons, count, "polygons");
    for (const std::uint32_t p : summands) require_below(p, of.polygons.size(), "polygon");
    std::vector<std::uint32_t> shape(summands.begin(), summands.end());
    if (!of.shapes) of.shapes.emplace();
    of.shapes->push_back(std::move(shape));
    *index = next_index(of.shapes->size() - 1);
  });
}

plumb_status plumb_scene_set_outside(plumb_scene* scene, std::uint32_t face, plumb_error** error) {
  return guarded(error, [&] {
    require_below(face, need(scene, "scene").scene.mesh->face_count(), "face");
    scene->scene.outside = FaceId(face);
  });
}

plumb_status plumb_scene_separate(plumb_scene* scene, std::size_t* added,
                                  const plumb_context* context, plumb_error** error) {
  return guarded(error, [&] {
    Call call(context);
    const std::size_t count = separate(need(scene, "scene").scene, call);
    if (added != nullptr) *added = count;
  });
}

plumb_status plumb_scene_trace(const plumb_scene* scene, std::uint32_t from, std::uint32_t to,
                               plumb_path_choice choice, plumb_path** out,
                               const plumb_context* context, plumb_error** error) {
  return make(out, error, [&] {
    Call call(context);
    SurfacePointTable points = need(scene, "scene").scene.polygons.points;
    require_below(from, points.size(), "point");
    require_below(to, points.size(), "point");
    if (choice != PLUMB_PATH_LOCAL && choice != PLUMB_PATH_SHORTEST) {
      fail_argument("choice is no plumb_path_choice");
    }
    Tracer tracer(*scene->scene.mesh,
                  choice == PLUMB_PATH_SHORTEST ? PathChoice::Shortest : PathChoice::Local);
    const std::optional<SurfacePath> path =
        tracer.trace(points, SurfacePointId(from), SurfacePointId(to), call);
    return path ? path_of(*path, points) : plumb_path();
  });
}

std::size_t plumb_path_count(const plumb_path* path) {
  return path != nullptr ? path->xyz.size() / 3 : 0;
}
const double* plumb_path_points(const plumb_path* path) {
  return path != nullptr ? path->xyz.data() : nullptr;
}
const std::uint32_t* plumb_path_faces(const plumb_path* path) {
  return path != nullptr ? path->faces.data() : nullptr;
}
double plumb_path_length(const plumb_path* path) { return path != nullptr ? path->length : 0; }
void plumb_path_free(plumb_path* path) { delete path; }

std::size_t plumb_scene_polygon_count(const plumb_scene* scene) {
  return scene != nullptr ? scene->scene.polygons.size() : 0;
}
void plumb_scene_free(plumb_scene* scene) { delete scene; }

// --- surfaces -----------------------------------------------------------------------------------

plumb_status plumb_surface_divide(const plumb_scene* scene, plumb_surface** out,
                                  const plumb_context* context, plumb_error** error) {
  return make(out, error, [&] {
    Call call(context);
    return surface_handle(need(scene, "scene").scene, call);
  });
}

plumb_status plumb_surface_describe(const plumb_surface* surface, plumb_surface_info* info,
                                    plumb_error** error) {
  return guarded(error, [&] {
    const SurfaceDivision& division = *need(surface, "surface").division;
    const SurfaceCounts counts = division.counts();
    fill(info,
         {0, counts.triangles, counts.segments, counts.crossings, counts.cells, counts.cell_edges,
          division.shape_count()},
         "info");
  });
}

const plumb_label* plumb_surface_labels(const plumb_surface* surface, std::size_t cell,
                                        std::size_t* count) {
  const bool is_there = surface != nullptr && cell < surface->division->cell_count();
  const std::size_t begin = is_there ? surface->labels_begin[cell] : 0;
  if (count != nullptr) *count = is_there ? surface->labels_begin[cell + 1] - begin : 0;
  return is_there ? surface->labels.data() + begin : nullptr;
}

double plumb_surface_area(const plumb_surface* surface, std::size_t cell) {
  const bool is_there = surface != nullptr && cell < surface->division->cell_count();
  return is_there ? surface->division->area(CellId(cell)) : 0;
}

const std::uint32_t* plumb_surface_neighbours(const plumb_surface* surface, std::size_t* count) {
  if (count != nullptr) *count = surface != nullptr ? surface->neighbours.size() / 2 : 0;
  return surface != nullptr ? surface->neighbours.data() : nullptr;
}

plumb_status plumb_surface_separates(const plumb_surface* surface, std::size_t shape,
                                     bool* over_integers, bool* modulo_2, plumb_error** error) {
  return guarded(error, [&] {
    const SurfaceDivision& division = *need(surface, "surface").division;
    require_below(shape, division.shape_count(), "shape");
    const Separation& found = division.shape_separation(next_index(shape));
    if (over_integers != nullptr) *over_integers = found.over_z;
    if (modulo_2 != nullptr) *modulo_2 = found.mod_2;
  });
}

plumb_status plumb_surface_triangulate(const plumb_surface* surface, plumb_mesh** out,
                                       plumb_indices** cells, const plumb_context* context,
                                       plumb_error** error) {
  if (out != nullptr) *out = nullptr;
  if (cells != nullptr) *cells = nullptr;
  return guarded(error, [&] {
    need(out, "out");
    Call call(context);
    const SurfaceTriangulation found =
        triangulate_surface(*need(surface, "surface").division, call);
    auto mesh = std::make_unique<plumb_mesh>();
    mesh->mesh.points = found.points;
    for (const SurfaceTriangle& corners : found.triangles) mesh->mesh.add_face(corners);
    if (cells != nullptr) {
      auto of = std::make_unique<plumb_indices>();
      for (const CellId cell : found.cell) of->values.push_back(cell.value());
      *cells = of.release();
    }
    *out = mesh.release();
  });
}

plumb_status plumb_surface_audit(const plumb_surface* surface, plumb_bytes** flaw,
                                 plumb_error** error) {
  return report_flaw(flaw, error, [&] { return audit(*need(surface, "surface").division); });
}

void plumb_surface_free(plumb_surface* surface) { delete surface; }

// --- regions ------------------------------------------------------------------------------------

plumb_status plumb_surface_evaluate(const plumb_surface* surface, const char* expression, int rule,
                                    plumb_region** out, const plumb_context* context,
                                    plumb_error** error) {
  return make(out, error, [&] {
    Call call(context);
    const std::shared_ptr<const SurfaceDivision> division = need(surface, "surface").division;
    const SetExpression parsed = parse_set_expression(text(expression, "expression"));
    const WindingRule inside = rule_of(rule).value_or(WindingRule::EvenOdd);
    return plumb_region{division, division->evaluate(parsed, inside, call)};
  });
}

std::size_t plumb_region_cell_count(const plumb_region* region) {
  return region != nullptr ? region->result.region.cells : 0;
}
std::size_t plumb_region_loop_count(const plumb_region* region) {
  return region != nullptr ? region->result.borders.size() : 0;
}
double plumb_region_area(const plumb_region* region) {
  return region != nullptr ? region->result.region.area : 0;
}
bool plumb_region_has(const plumb_region* region, std::size_t cell) {
  return region != nullptr && cell < region->result.region.is_selected.size() &&
         region->result.region.is_selected[cell] != 0;
}

plumb_status plumb_region_to_scene(const plumb_region* region, plumb_scene** out,
                                   plumb_error** error) {
  return make(out, error,
              [&] { return result_scene(*need(region, "region").division, region->result); });
}

void plumb_region_free(plumb_region* region) { delete region; }

plumb_status plumb_surface_write(const plumb_surface* surface, const plumb_region* region,
                                 const char* format, plumb_bytes** out,
                                 const plumb_context* context, plumb_error** error) {
  return make(out, error, [&] {
    Call call(context);
    const std::string name = text(format, "format");
    const SurfaceDivision& division = *need(surface, "surface").division;
    const SurfaceResult* const result = result_of(*surface, region);
    return written(
        [&](std::ostream& stream) { write_surface(stream, division, result, name, call); });
  });
}

plumb_status plumb_surface_draw(const plumb_surface* surface, const plumb_region* region,
                                const char* layer, const char* format, const char* title,
                                plumb_bytes** out, const plumb_context* context,
                                plumb_error** error) {
  return make(out, error, [&] {
    Call call(context);
    const SurfaceDivision& division = *need(surface, "surface").division;
    const SurfaceResult* const result = result_of(*surface, region);
    const SurfaceLayer shown = surface_layer(text(layer, "layer"), result != nullptr);
    return picture_of(division, result, shown,
                      picture(text(format, "format"), text_or_empty(title)), call);
  });
}
