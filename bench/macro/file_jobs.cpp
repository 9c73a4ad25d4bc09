// Readers and writers, of text in memory.
#include <fmt/core.h>

#include <utility>

#include "../text_of.h"
#include "generate/mesh_solid.h"
#include "generate/meshes.h"
#include "generate/plane_families.h"
#include "jobs.h"
#include "plumb/base/error.h"
#include "plumb/io/map_reader.h"
#include "plumb/io/map_writer.h"
#include "plumb/io/nef3_reader.h"
#include "plumb/io/nef3_writer.h"
#include "plumb/io/plane_io.h"
#include "plumb/io/solid_io.h"
#include "plumb/picture/scene_glb.h"
#include "plumb/picture/space_scene.h"
#include "plumb/space/space_audit.h"
#include "plumb/testing/map_families.h"

namespace plumb::bench {
namespace {

/// Of `text`, in bytes; `read(text, context)`.
template <class Read>
Once reading(std::string text, Read read) {
  const std::size_t size = text.size();
  return timed_of(size, [text = std::move(text), read] {
    Context context;
    return read(text, context);
  });
}

constexpr std::pair<const char*, MeshFormat> kMeshFormats[] = {
    {"OFF", MeshFormat::Off},           {"OBJ", MeshFormat::Obj},
    {"STL, text", MeshFormat::Stl},     {"STL, binary", MeshFormat::StlBinary},
    {"PLY, text", MeshFormat::PlyText}, {"PLY, binary", MeshFormat::Ply}};

void add_meshes(std::vector<Job>& jobs, const std::string& input, bool is_real,
                const std::function<PolygonMesh()>& make) {
  for (const auto& [name, format] : kMeshFormats) {
    const auto write = [format = format](const PolygonMesh& mesh) {
      return [=](std::ostream& out) { write_mesh(out, mesh, format); };
    };
    jobs.push_back(
        {fmt::format("read {}", name), input, is_real, "bytes", [make, write, format = format] {
           return reading(text_of(write(make())), [format](const std::string& text, Context& own) {
             return read_mesh(text, format, {}, own);
           });
         }});
    jobs.push_back({fmt::format("write {}", name), input, is_real, "bytes",
                    [make, write] { return writing(write(make())); }});
  }
  jobs.push_back({"read glTF", input, is_real, "bytes", [make] {
                    Context context;
                    const Scene scene = scene_of(testing::solid(make()), context);
                    return reading(
                        text_of([&](std::ostream& out) { write_scene_glb(out, scene, ""); }),
                        [](const std::string& text, Context& own) {
                          return read_mesh(text, MeshFormat::Gltf, {}, own);
                        });
                  }});
  const auto write_set = [](const Nef3& set) {
    return [=](std::ostream& out) { write_nef3(out, set.complex()); };
  };
  jobs.push_back({"read .nef, with its audit", input, is_real, "bytes", [make, write_set] {
                    return reading(text_of(write_set(testing::solid(make()))),
                                   [](const std::string& text, Context& own) {
                                     SpaceComplex complex = read_nef3(text, {}, own);
                                     PLUMB_CHECK(!audit(complex, true, own));
                                     return complex;
                                   });
                  }});
  jobs.push_back({"write .nef", input, is_real, "bytes",
                  [make, write_set] { return writing(write_set(testing::solid(make()))); }});
}

void add_maps(std::vector<Job>& jobs, const std::string& input, bool is_real,
              const std::function<Map()>& make) {
  const auto write = [](const Map& map) { return [=](std::ostream& out) { write_map(out, map); }; };
  jobs.push_back({"read map", input, is_real, "bytes", [make, write] {
                    return reading(text_of(write(make())),
                                   [](const std::string& text, Context& own) {
                                     return read_map(text, {}, own);
                                   });
                  }});
  jobs.push_back(
      {"write map", input, is_real, "bytes", [make, write] { return writing(write(make())); }});
}

void add_plane_sets(std::vector<Job>& jobs, const std::string& input, bool is_real,
                    const std::function<Nef2()>& make) {
  constexpr std::pair<const char*, PlaneFormat> kFormats[] = {
      {"WKT", PlaneFormat::Wkt}, {"GeoJSON", PlaneFormat::GeoJson}, {".nef2", PlaneFormat::Nef2}};
  for (const auto& [name, format] : kFormats) {
    const auto write = [format = format](const Nef2& set) {
      return [=](std::ostream& out) {
        Context context;
        PlaneText(set, format, context).write(out, context);
      };
    };
    jobs.push_back(
        {fmt::format("read {}", name), input, is_real, "bytes", [make, write, format = format] {
           return reading(text_of(write(make())), [format](const std::string& text, Context& own) {
             return read_plane_set(text, format, {}, own);
           });
         }});
    jobs.push_back({fmt::format("write {}", name), input, is_real, "bytes",
                    [make, write] { return writing(write(make())); }});
  }
}

}  // namespace

void add_file_jobs(std::vector<Job>& jobs, const MacroOptions& options) {
  add_meshes(jobs, "corpus/solids/bunny.off", true,
             [] { return mesh_of("corpus/solids/bunny.off"); });
  const int depth = options.most < 50 ? 3 : 6;
  add_meshes(jobs, fmt::format("icosphere of 20 * 4^{}", depth), false, [depth] {
    return testing::icosphere_mesh(depth, 1, {0, 0, 0});
  });
  const std::string counties = "corpus/maps/us-counties.map";
  add_maps(jobs, counties, true, [counties] { return map_of(counties); });
  const auto faces = static_cast<std::uint32_t>(options.size(100000, 1000));
  add_maps(jobs, "hexagons", false,
           [faces] { return to_map(testing::map_family("hexagons").make(faces)); });
  const std::string frame = "corpus/plane/frame.geojson";
  add_plane_sets(jobs, frame, true, [frame] {
    Context context;
    return read_plane_set_file(frame, {}, {}, context);
  });
  const std::size_t corners = options.size(100000, 1000);
  add_plane_sets(jobs, "a star", false,
                 [corners] { return Nef2::polygon(testing::star_polygon(corners, 1)); });
}

}  // namespace plumb::bench
