// Pictures of everything; but not those of glTF and HTML, whose JSON library allocates in
// destructors.
#include <memory>
#include <string>
#include <vector>

#include "plumb/io/map_io.h"
#include "plumb/io/plane_io.h"
#include "plumb/io/scene_reader.h"
#include "plumb/io/solid_io.h"
#include "plumb/picture/map_svg.h"
#include "plumb/picture/nef2_svg.h"
#include "plumb/picture/overlay_svg.h"
#include "plumb/picture/plane_html.h"
#include "plumb/picture/plane_scene.h"
#include "plumb/picture/render.h"
#include "plumb/picture/space_scene.h"
#include "plumb/picture/space_svg.h"
#include "plumb/picture/surface_scene.h"
#include "plumb/plane/map_overlay.h"
#include "plumb/surface/triangulation.h"
#include "system/digest.h"
#include "system/public_operations.h"

namespace plumb::testing {
namespace {

std::uint64_t digest_of(const Scene& scene) {
  Digest out;
  out.add(scene.triangles.size());
  out.add(scene.points.size());
  return out.value();
}

std::uint64_t digest_of(const Image& image) {
  Digest out;
  out.add_all(image.rgb);
  return out.value();
}

struct Shown {
  MapReport map;
  MapOverlay overlay;
  Nef2 set;
  std::vector<Nef3> solids;
  Scene scene;
  std::unique_ptr<SurfaceDivision> division;

  Shown() {
    Context context;
    map = check_map(read_map("4 2\n0 0\n4 0\n4 4\n0 4\n1 2 3 4\n4 3 2 1\n", {}, context), {},
                    context);
    overlay = overlay_map(map, context);
    set = read_plane_set("POLYGON ((0 0, 9 0, 9 9, 0 9, 0 0), (2 2, 2 4, 4 4, 2 2))",
                         PlaneFormat::Wkt, {}, context)
              .set;
    for (const char* path : {"corpus/solids/tetrahedron.off", "corpus/solids/l-block.off"}) {
      solids.push_back(read_solid_file(path, {}, context).set);
    }
    scene = scene_of(solids[1], context);
    division = std::make_unique<SurfaceDivision>(
        read_scene_file("corpus/scenes/torus.json", {}, context).scene, context);
  }
};

template <class Write>
std::uint64_t written(Write write) {
  Digest out;
  write(out);
  return out.value();
}

}  // namespace

OperationRoom picture_operations() {
  const auto s = std::make_shared<const Shown>();
  const RenderOptions small{60, 45, 8};
  return {
      "pictures",
      [s] { return digest_of(s->scene) ^ digest_of(s->solids[0]); },
      {
          {"write_map_svg",
           [s](Context& own) {
             return written([&](Digest& out) { write_map_svg(out, s->map, {.context = &own}); });
           }},
          {"write_overlay_svg",
           [s](Context&) {
             return written([&](Digest& out) { write_overlay_svg(out, s->overlay); });
           }},
          {"write_nef2_svg",
           [s](Context& own) {
             return written([&](Digest& out) { write_nef2_svg(out, s->set, {.context = &own}); });
           }},
          {"write_plane_html",
           [](Context&) {
             return written([&](Digest& out) { write_plane_html(out, "<svg></svg>", "a title"); });
           }},
          {"scene_of a map", [s](Context& own) { return digest_of(scene_of(s->map, own)); }},
          {"scene_of a set of the plane",
           [s](Context& own) { return digest_of(scene_of(s->set, own)); }},
          {"scene_of a set of space",
           [s](Context& own) { return digest_of(scene_of(s->solids[1], own)); }},
          {"exploded_scene",
           [s](Context& own) { return digest_of(exploded_scene(s->solids, 0.5, own)); }},
          {"scene_of a surface",
           [s](Context& own) {
             return digest_of(
                 scene_of(*s->division, triangulate_surface(*s->division, own), nullptr));
           }},
          {"rendered", [s, small](Context&) { return digest_of(rendered(s->scene, small)); }},
          {"write_space_svg",
           [s](Context& own) {
             return written([&](Digest& out) {
               write_space_svg(out, s->solids[1], s->scene, "no image", "a title", own);
             });
           }},
      }};
}

}  // namespace plumb::testing
