// The scene reader and the tracer on arbitrary bytes.
//
// The first byte chooses the mesh, and exact decimals or nearest doubles; the rest is the scene.
// Either the reader throws an Error that names the file, a line and a column inside it, or polygons
// whose segments lie in their faces, and every leg of theirs, traced the other way, is the same
// path.

#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "generate/surface_meshes.h"
#include "plumb/io/surface/scene_parser.h"
#include "plumb/io/svg_reader.h"
#include "plumb/surface/trace.h"
#include "plumb/testing/oracle_reached.h"
#include "reader_laws.h"

namespace {

using namespace plumb;
using namespace plumb::fuzz;

constexpr std::size_t kMostText = 1U << 14U;
constexpr std::size_t kMostLegs = 40;
constexpr std::size_t kMostDrawings = 4;
constexpr const char* kDrawingName = "drawing";

std::shared_ptr<const SurfaceMesh> mesh_number(unsigned i) {
  static const std::array<std::shared_ptr<const SurfaceMesh>, 4> kMeshes{
      std::make_shared<const SurfaceMesh>(plumb::testing::grid_surface(3)),
      std::make_shared<const SurfaceMesh>(plumb::testing::torus_surface(6, 5, .4)),
      std::make_shared<const SurfaceMesh>(plumb::testing::sphere_surface(0)),
      std::make_shared<const SurfaceMesh>(plumb::testing::cylinder_surface(5, 2))};
  return kMeshes[i % kMeshes.size()];
}

/// Whatever files a scene names, they hold this.
DrawingFile drawing_file() {
  const std::string text = "<svg><path d='M0 0l.5 0 0 .5M.1.1h.2v.3'/></svg>";
  Context context;
  return {kDrawingName, text, read_svg(text, {kDrawingName, false}, {}, context)};
}

void require_canonical(SurfacePolygons& polygons, SurfacePointId a, SurfacePointId b,
                       Tracer& tracer, Context& context) {
  const auto there = tracer.trace(polygons.points, a, b, context);
  const auto back = tracer.trace(polygons.points, b, a, context);
  require(there && back, "connected meshes have a path between all points");
  require(there->points.size() == back->points.size(), "a path is the same both ways");
  for (std::size_t i = 0; i < there->points.size(); ++i) {
    require(polygons.points.is_same(there->points[i], back->points[back->points.size() - 1 - i]),
            "a path is the same both ways");
  }
}

void judge(SurfaceScene scene, const ParsedScene& text, Context& context) {
  oracle_reached();
  require_valid(scene.polygons);
  require(scene.polygons.size() == text.polygons.size() + 2 * text.drawings.size(),
          "every polygon is there");
  for (std::size_t i = 0; i < text.points.face.size(); ++i) {
    require(scene.polygons.points.is_in(SurfacePointId(i), FaceId(text.points.face[i])),
            "a point lies in its face");
  }
  Tracer tracer(*scene.mesh);
  const std::size_t legs = std::min(kMostLegs, text.polygons.items.size());
  for (std::size_t i = 1; i < legs; ++i) {
    require_canonical(scene.polygons, SurfacePointId(text.polygons.items[i - 1]),
                      SurfacePointId(text.polygons.items[i]), tracer, context);
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  begin_input();
  if (size == 0 || size > kMostText) return 0;
  const std::string_view text(reinterpret_cast<const char*>(data) + 1, size - 1);
  const ReadOptions options{kFileName, (data[0] & 4U) != 0};
  Context context;
  try {
    const ParsedScene parsed = parse_scene(text, options, context);
    if (parsed.drawings.size() > kMostDrawings) return 0;
    static const DrawingFile kDrawing = drawing_file();
    const std::vector<const DrawingFile*> drawings(parsed.drawings.size(), &kDrawing);
    judge(make_scene(parsed, mesh_number(data[0] & 3U), text, options, context, drawings), parsed,
          context);
  } catch (const Error& error) {
    if (error.place().file != kDrawingName) require_place(error, text);
  }
  return 0;
}
