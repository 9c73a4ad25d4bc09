// Readers and writers, of text in memory.
#include <fmt/core.h>

#include <utility>

#include "../text_of.h"
#include "generate/mesh_solid.h"
#include "generate/meshes.h"
#include "generate/plane_families.h"
#include "jobs.h"
#include "plumb/io/map_io.h"
#include "plumb/io/mesh_io.h"
#include "plumb/io/nef3_reader.h"
#include "plumb/io/nef3_writer.h"
#include "plumb/io/plane_io.h"
#include "plumb/picture/scene_glb.h"
#include "plumb/picture/space_scene.h"
#include "plumb/predicates/error.h"
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

/// Jobs of one input, which `make()` makes.
template <class Made>
struct Input {
  std::vector<Job>& jobs;
  std::string name;
  bool is_real;
  std::function<Made()> make;

  void add(const std::string& capability, std::function<Once()> prepare) const {
    jobs.push_back({capability, name, is_real, "bytes", std::move(prepare)});
  }
  /// `write(made)` writes to a stream.
  template <class Write, class Read>
  void add_reading(const std::string& format, Write write, Read read) const {
    add("read " + format,
        [make = make, write, read] { return reading(text_of(write(make())), read); });
  }
  template <class Write>
  void add_writing(const std::string& format, Write write) const {
    add("write " + format, [make = make, write] { return writing(write(make())); });
  }
};

constexpr std::pair<const char*, MeshFormat> kMeshFormats[] = {
    {"OFF", MeshFormat::Off},           {"OBJ", MeshFormat::Obj},
    {"STL, text", MeshFormat::Stl},     {"STL, binary", MeshFormat::StlBinary},
    {"PLY, text", MeshFormat::PlyText}, {"PLY, binary", MeshFormat::Ply}};

auto mesh_reader(MeshFormat format) {
  return [=](const std::string& text, Context& own) { return read_mesh(text, format, {}, own); };
}

void add_meshes(const Input<PolygonMesh>& meshes) {
  for (const auto& [name, format] : kMeshFormats) {
    const auto write = [format = format](const PolygonMesh& mesh) {
      return [=](std::ostream& out) { write_mesh(out, mesh, format); };
    };
    meshes.add_reading(name, write, mesh_reader(format));
    meshes.add_writing(name, write);
  }
  const auto write_gltf = [](const PolygonMesh& mesh) {
    return [=](std::ostream& out) {
      Context context;
      write_scene_glb(out, scene_of(testing::solid(mesh), context), "");
    };
  };
  meshes.add_reading("glTF", write_gltf, mesh_reader(MeshFormat::Gltf));
  const auto write_set = [](const PolygonMesh& mesh) {
    return [set = testing::solid(mesh)](std::ostream& out) { write_nef3(out, set.complex()); };
  };
  meshes.add_reading(".nef, with its audit", write_set, [](const std::string& text, Context& own) {
    SpaceComplex complex = read_nef3(text, {}, own);
    PLUMB_CHECK(!audit(complex, AuditForm::Minimal, own));
    return complex;
  });
  meshes.add_writing(".nef", write_set);
}

void add_maps(const Input<Map>& maps) {
  const auto write = [](const Map& map) { return [=](std::ostream& out) { write_map(out, map); }; };
  maps.add_reading("map", write,
                   [](const std::string& text, Context& own) { return read_map(text, {}, own); });
  maps.add_writing("map", write);
}

void add_plane_sets(const Input<Nef2>& sets) {
  constexpr std::pair<const char*, PlaneFormat> kFormats[] = {
      {"WKT", PlaneFormat::Wkt}, {"GeoJSON", PlaneFormat::GeoJson}, {".nef2", PlaneFormat::Nef2}};
  for (const auto& [name, format] : kFormats) {
    const auto write = [format = format](const Nef2& set) {
      return [=](std::ostream& out) {
        Context context;
        PlaneText(set, format, context).write(out, context);
      };
    };
    sets.add_reading(name, write, [format = format](const std::string& text, Context& own) {
      return read_plane_set(text, format, {}, own).set;
    });
    sets.add_writing(name, write);
  }
}

}  // namespace

void add_file_jobs(std::vector<Job>& jobs, const MacroOptions& options) {
  const std::string bunny = "corpus/solids/bunny.off";
  add_meshes({jobs, bunny, true, [bunny] { return mesh_of(bunny); }});
  const int depth = options.most < 50 ? 3 : 6;
  add_meshes({jobs, fmt::format("icosphere of 20 * 4^{}", depth), false, [depth] {
                return testing::icosphere_mesh(depth, 1, {0, 0, 0});
              }});
  const std::string counties = "corpus/maps/us-counties.map";
  add_maps({jobs, counties, true, [counties] { return map_of(counties); }});
  const auto faces = static_cast<std::uint32_t>(options.size(100000, 1000));
  add_maps({jobs, "hexagons", false,
            [faces] { return to_map(testing::map_family("hexagons").make(faces)); }});
  const std::string frame = "corpus/plane/frame.geojson";
  add_plane_sets({jobs, frame, true, [frame] {
                    Context context;
                    return read_plane_set_file(frame, {}, {}, context).set;
                  }});
  const std::size_t corners = options.size(100000, 1000);
  add_plane_sets({jobs, "a star", false,
                  [corners] { return Nef2::polygon(testing::star_polygon(corners, 1)); }});
}

}  // namespace plumb::bench
