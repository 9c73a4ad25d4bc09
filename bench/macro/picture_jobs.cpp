// Pictures: SVG, images, glTF, pages.
#include <fmt/core.h>

#include "generate/mesh_solid.h"
#include "generate/meshes.h"
#include "jobs.h"
#include "plumb/picture/map_svg.h"
#include "plumb/picture/render.h"
#include "plumb/picture/scene_glb.h"
#include "plumb/picture/scene_html.h"
#include "plumb/picture/space_scene.h"
#include "plumb/plane/map_check.h"
#include "plumb/testing/map_families.h"

namespace plumb::bench {
namespace {

Once map_picture(const Map& map) {
  Context context;
  return writing(
      [report = check_map(map, {}, context)](std::ostream& out) { write_map_svg(out, report); });
}

Scene scene_of_mesh(const PolygonMesh& mesh) {
  Context context;
  return scene_of(testing::solid(mesh), context);
}

Once image(const PolygonMesh& mesh) {
  return timed(
      [set = testing::solid(mesh)] {
        Context context;
        return rendered(scene_of(set, context));
      },
      [](const Image& result) { return result.rgb.size() / 3; });
}

void add_mesh_pictures(std::vector<Job>& jobs, const std::string& input, bool is_real,
                       const std::function<PolygonMesh()>& make) {
  jobs.push_back(
      {"picture, with its scene", input, is_real, "pixels", [make] { return image(make()); }});
  jobs.push_back({"glTF of a scene", input, is_real, "bytes", [make] {
                    return writing([scene = scene_of_mesh(make())](std::ostream& out) {
                      write_scene_glb(out, scene, "");
                    });
                  }});
  jobs.push_back({"page of a scene", input, is_real, "bytes", [make] {
                    return writing([scene = scene_of_mesh(make())](std::ostream& out) {
                      write_scene_html(out, scene, {});
                    });
                  }});
}

}  // namespace

void add_picture_jobs(std::vector<Job>& jobs, const MacroOptions& options) {
  const std::string counties = "corpus/maps/us-counties.map";
  jobs.push_back({"SVG of a map", counties, true, "bytes",
                  [counties] { return map_picture(map_of(counties)); }});
  const auto faces = static_cast<std::uint32_t>(options.size(10000, 100));
  jobs.push_back({"SVG of a map", fmt::format("{} hexagons", faces), false, "bytes", [faces] {
                    return map_picture(to_map(testing::map_family("hexagons").make(faces)));
                  }});
  add_mesh_pictures(jobs, "corpus/solids/bunny.off", true,
                    [] { return mesh_of("corpus/solids/bunny.off"); });
  const int depth = options.most < 50 ? 2 : 5;
  add_mesh_pictures(jobs, fmt::format("icosphere of 20 * 4^{}", depth), false, [depth] {
    return testing::icosphere_mesh(depth, 1, {0, 0, 0});
  });
}

}  // namespace plumb::bench
