// Capabilities of polygons on surfaces.
#include <fmt/core.h>

#include <memory>

#include "generate/surface_meshes.h"
#include "jobs.h"
#include "plumb/io/scene_reader.h"
#include "plumb/surface/cells/surface_arrangement.h"
#include "plumb/surface/surface.h"
#include "plumb/surface/surface_audit.h"
#include "plumb/surface/surface_homology.h"
#include "plumb/surface/triangulation.h"
#include "traced_polygons.h"

namespace plumb::bench {
namespace {

using Scene = std::shared_ptr<const SurfaceScene>;

SurfaceScene scene_of_file(const std::string& file) {
  Context context;
  return read_scene_file(file, {}, context).scene;
}

SurfaceScene traced_scene(int depth, std::size_t polygons) {
  const auto mesh = std::make_shared<const SurfaceMesh>(testing::sphere_surface(depth));
  return {mesh, traced_polygons(*mesh, polygons), {}, FaceId{}};
}

Once division_of(const Scene& scene) {
  return timed(
      [scene] {
        Context context;
        return SurfaceDivision(SurfaceScene(*scene), context);
      },
      [](const SurfaceDivision& division) { return division.cell_count(); });
}

std::shared_ptr<const SurfaceDivision> divided(const Scene& scene) {
  Context context;
  return std::make_shared<const SurfaceDivision>(SurfaceScene(*scene), context);
}

/// Of the first two shapes.
Once boolean_of(const Scene& scene) {
  return timed(
      [division = divided(scene)] {
        Context context;
        return division->evaluate(parse_set_expression("A + B"), WindingRule::EvenOdd, context);
      },
      [](const SurfaceResult& result) { return result.region.cells; });
}

Once triangles_of(const Scene& scene) {
  return timed(
      [division = divided(scene)] {
        Context context;
        return triangulate_surface(*division, context);
      },
      [](const SurfaceTriangulation& result) { return result.triangles.size(); });
}

Once audit_of(const Scene& scene) {
  const auto division = divided(scene);
  return timed_of(division->arrangement().halfedge_count(),
                  [division] { return audit(*division).has_value(); });
}

Once homology_of(const Scene& scene) {
  return timed_of(scene->mesh->face_count(), [scene] {
    Context context;
    const SurfaceHomology homology(*scene->mesh, context);
    return homology.class_of(scene->polygons, 0, context);
  });
}

void add_scene_jobs(std::vector<Job>& jobs, const std::string& input, bool is_real,
                    const std::function<SurfaceScene()>& make) {
  const auto add = [&](const char* capability, const char* unit, Once (*of)(const Scene&)) {
    jobs.push_back({capability, input, is_real, unit,
                    [make, of] { return of(std::make_shared<const SurfaceScene>(make())); }});
  };
  add("polygons on a surface", "cells", division_of);
  add("surface Boolean", "cells", boolean_of);
  add("triangles of cells", "triangles", triangles_of);
  add("homology of a polygon", "triangles", homology_of);
  add("surface audit", "half-edges", audit_of);
}

/// With the polygons traced.
Once reading_of(const std::string& file) {
  return timed([file] { return scene_of_file(file); },
               [](const SurfaceScene& scene) { return scene.polygons.size(); });
}

}  // namespace

void add_surface_jobs(std::vector<Job>& jobs, const MacroOptions& options) {
  for (const char* const name : {"bunny.json", "bunny-rosette.json", "torus.json"}) {
    const std::string file = fmt::format("corpus/scenes/{}", name);
    jobs.push_back({"geodesics, read and traced", file, true, "polygons",
                    [file] { return reading_of(file); }});
    add_scene_jobs(jobs, file, true, [file] { return scene_of_file(file); });
  }
  const int depth = options.most < 50 ? 3 : 6;
  const std::size_t polygons = options.size(30, 2);
  const std::string input = fmt::format("{} closed geodesics on 20 * 4^{}", polygons, depth);
  const auto make = [=] { return traced_scene(depth, polygons); };
  jobs.push_back(
      {"geodesics, traced", input, false, "polygons", [=] { return timed_of(polygons, make); }});
  add_scene_jobs(jobs, input, false, make);
}

}  // namespace plumb::bench
