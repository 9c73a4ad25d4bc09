// Readers, and surfaces, which are read from scenes.
#include <array>
#include <cstdio>
#include <memory>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include "generate/counted_memory.h"
#include "plumb/io/mesh_io.h"
#include "plumb/io/nef3_reader.h"
#include "plumb/io/scene_reader.h"
#include "plumb/io/solid_io.h"
#include "plumb/io/surface_writer.h"
#include "plumb/io/svg_reader.h"
#include "plumb/predicates/error.h"
#include "plumb/surface/exponential_map.h"
#include "plumb/surface/surface.h"
#include "plumb/surface/surface_audit.h"
#include "plumb/surface/surface_homology.h"
#include "plumb/surface/trace.h"
#include "plumb/surface/triangulation.h"
#include "system/digest.h"
#include "system/public_operations.h"

namespace plumb::testing {
namespace {

std::string contents(const std::string& path) {
  std::FILE* const file = std::fopen(path.c_str(), "rb");
  PLUMB_CHECK(file != nullptr);
  std::string text;
  for (int c = 0; (c = std::fgetc(file)) != EOF;) text.push_back(static_cast<char>(c));
  std::fclose(file);
  return text;
}

std::uint64_t sum_of_text(const std::string& text) {
  Digest out;
  out << text;
  return out.value();
}

struct Surfaces {
  SurfaceScene scene;
  std::unique_ptr<SurfaceDivision> division;
  SetExpression first = parse_set_expression("A");

  Surfaces() : scene(read()) {
    Context context;
    division = std::make_unique<SurfaceDivision>(scene, context);
  }
  static SurfaceScene read() {
    Context context;
    return read_scene_file("corpus/scenes/torus.json", {}, context).scene;
  }
  SurfaceResult result(Context& context) const {
    return division->evaluate(first, WindingRule::EvenOdd, context);
  }
};

}  // namespace

OperationRoom surface_operations() {
  const auto s = std::make_shared<const Surfaces>();
  return {"surface",
          [s] { return digest_of(s->scene) ^ digest_of(*s->division); },
          {
              {"divide",
               [s](Context& own) { return digest_of(SurfaceDivision(own_copy(s->scene), own)); }},
              {"evaluate", [s](Context& own) { return digest_of(s->result(own)); }},
              {"result_scene",
               [s](Context& own) { return digest_of(result_scene(*s->division, s->result(own))); }},
              {"triangulate_surface, write_surface_obj",
               [s](Context& own) {
                 Digest out;
                 write_surface_obj(out, triangulate_surface(*s->division, own),
                                   s->division->cell_count(), {});
                 return out.value();
               }},
              {"audit", [s](Context&) { return std::uint64_t{audit(*s->division).has_value()}; }},
              {"homology",
               [s](Context& own) {
                 const SurfaceHomology homology(*s->scene.mesh, own);
                 Digest out;
                 out.add(homology.generator_count());
                 out.add_all(homology.class_of(s->scene.polygons, 0, own));
                 return out.value();
               }},
              {"trace",
               [s](Context& own) {
                 Tracer tracer(*s->scene.mesh);
                 SurfacePolygons polygons =
                     unrefused([s] { return SurfacePolygons(*s->scene.mesh); });
                 const auto control = unrefused([&polygons] {
                   SurfacePointTable& points = polygons.points;
                   return std::array<SurfacePointId, 3>{points.add_vertex(VertexId(0)),
                                                        points.add_vertex(VertexId(9)),
                                                        points.add_vertex(VertexId(40))};
                 });
                 const bool is_closed = !add_traced_polygon(tracer, control, polygons, own);
                 return digest_of(polygons) + std::uint64_t{is_closed};
               }},
              {"exponential_map",
               [s](Context& own) {
                 SurfacePointTable points(*s->scene.mesh);
                 const SurfacePointId centre =
                     unrefused([&points] { return points.add_in_face(FaceId(0), 0.25, 0.25); });
                 const ExponentialMap map(points, centre, FaceId(0), 30);
                 const std::optional<SurfacePointId> end = map.add({0.3, 0.1}, points, own);
                 Digest out;
                 if (end) add(points, *end, out);
                 return out.value();
               }},
          }};
}

OperationRoom reader_operations() {
  const auto texts = std::make_shared<std::vector<std::string>>();
  OperationRoom room{"readers",
                     [texts] {
                       std::uint64_t sum = 0;
                       for (const std::string& text : *texts) sum += sum_of_text(text);
                       return sum;
                     },
                     {}};
  for (const std::string path :
       {"corpus/solids/square-hole.obj", "corpus/solids/tetrahedron.stl",
        "corpus/solids/l-block.ply", "corpus/solids/tetrahedron.binary.stl",
        "corpus/solids/two-tetrahedra.off", "corpus/fuzz/gltf_reader/tetrahedron.glb"}) {
    texts->push_back(contents(path));
    room.operations.push_back({path,
                               [texts, i = texts->size() - 1, path](Context& own) {
                                 return digest_of(read_solid(path, (*texts)[i], {}, own).set);
                               },
                               path.ends_with(".glb")});
  }
  for (const std::string path :
       {"corpus/plane/star.wkt", "corpus/plane/frame.geojson", "corpus/plane/quadrant.nef2"}) {
    texts->push_back(contents(path));
    const PlaneFormat format = plane_format_of(path).value();
    room.operations.push_back({path, [texts, i = texts->size() - 1, format](Context& own) {
                                 return digest_of(read_plane_set((*texts)[i], format, {}, own).set,
                                                  own);
                               }});
  }
  texts->push_back(contents("corpus/scenes/rosette.svg"));
  room.operations.push_back({"read_svg", [texts, i = texts->size() - 1](Context& own) {
                               const SvgDrawing drawing = read_svg((*texts)[i], {}, 0.5, own);
                               Digest out;
                               for (const Point2 p : drawing.points) {
                                 out.add_bits(p.x);
                                 out.add_bits(p.y);
                               }
                               out.add_all(drawing.ring_begin);
                               out.add_all(drawing.shape_begin);
                               return out.value();
                             }});
  Context context;
  std::ostringstream nef;
  write_nef3(nef, read_solid_file("corpus/solids/l-block.off", {}, context).set.complex());
  texts->push_back(nef.str());
  room.operations.push_back({"read_nef3", [texts, i = texts->size() - 1](Context& own) {
                               Digest out;
                               write_nef3(out, read_nef3((*texts)[i], {}, own), own);
                               return out.value();
                             }});
  room.operations.push_back(
      {"read_half_spaces_file", [path = std::string("corpus/solids/octahedron.txt")](Context& own) {
         Digest out;
         const HalfSpaceList all = read_half_spaces_file(path, {}, own);
         for (std::size_t i = 0; i < all.size(); ++i) {
           const HalfSpace3 half_space = all[i];
           const Plane3& plane = half_space.plane;
           for (const Rational* number : {&plane.a, &plane.b, &plane.c, &plane.d}) {
             out.add(*number);
           }
           out.add(static_cast<std::uint64_t>(half_space.boundary));
         }
         return out.value();
       }});
  room.operations.push_back(
      {"read_scene_file",
       [path = std::string("corpus/scenes/torus-rosette.json")](Context& own) {
         return digest_of(read_scene_file(path, {}, own).scene);
       },
       true});
  room.operations.push_back({"a refusal", [](Context& own) -> std::uint64_t {
                               try {
                                 read_mesh("OFF\n3 1 0\n0 0 x\n1 0 0\n0 1 0\n3 0 1 2\n",
                                           MeshFormat::Off, {}, own);
                               } catch (const Error& error) {
                                 if (error.code() == ErrorCode::Syntax) return 1;
                                 throw;
                               }
                               return 2;
                             }});
  return room;
}

}  // namespace plumb::testing
