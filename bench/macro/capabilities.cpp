// Every capability on real and on generated inputs: CPU time and the largest resident set, a process for each. Exit
// status 1 when one of them fails.
//
//   capabilities [--most PERCENT] [--json FILE]     (from the root of the tree: corpus/)
#include <fmt/core.h>

#include <algorithm>
#include <exception>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "../complexity/cpu_time.h"
#include "../complexity/plane_jobs.h"
#include "../text_of.h"
#include "generate/mesh_solid.h"
#include "generate/meshes.h"
#include "generate/sphere_families.h"
#include "generate/voxel_mesh.h"
#include "macro_report.h"
#include "plumb/base/error.h"
#include "plumb/convex/convexity.h"
#include "plumb/convex/decompose.h"
#include "plumb/convex/minkowski.h"
#include "plumb/convex/plane_partition.h"
#include "plumb/io/map_reader.h"
#include "plumb/io/map_writer.h"
#include "plumb/io/nef3_reader.h"
#include "plumb/io/nef3_writer.h"
#include "plumb/io/plane_io.h"
#include "plumb/io/scene_reader.h"
#include "plumb/io/solid_io.h"
#include "plumb/plane/map_check.h"
#include "plumb/plane/map_overlay.h"
#include "plumb/space/space_audit.h"
#include "plumb/space/space_measure.h"
#include "plumb/space/to_mesh.h"
#include "plumb/surface/surface.h"
#include "plumb/testing/map_families.h"

namespace plumb::bench {
namespace {

using Once = std::function<Timing()>;

struct Job {
  std::string capability;
  std::string input;
  bool is_real;  ///< a file of the corpus, not generated
  std::string unit;
  std::function<Once()> prepare;
};

/// Times `work`; `size` tells the size of what it made.
template <class Work, class Size>
Once timed(Work work, Size size) {
  return [=] {
    const double start = cpu_seconds();
    const auto result = work();
    const double seconds = cpu_seconds() - start;
    return Timing{seconds, static_cast<double>(size(result))};
  };
}

PolygonMesh mesh_of(const std::string& file) {
  Context context;
  return read_mesh_file(file, {}, {}, context).mesh;
}

PolygonMesh shifted(const PolygonMesh& mesh) {
  double low = mesh.points[0].x, high = low;
  for (const Point3& p : mesh.points) low = std::min(low, p.x), high = std::max(high, p.x);
  const double step = (high - low) / 7;
  return testing::moved(mesh, {step, step / 2, step / 3});
}

// ---------------------------------------------------------------- the plane

Once check_of(const Map& map) {
  return timed(
      [map] {
        Context context;
        return check_map(map, {}, context);
      },
      [](const MapReport& report) { return report.regions.size(); });
}

Map map_of(const std::string& file) {
  Context context;
  return read_map_file(file, {}, context);
}

Once overlay_of(const Map& a, const Map& b) {
  Context context;
  return timed(
      [first = check_map(a, {}, context), second = check_map(b, {}, context)] {
        Context own;
        return overlay_maps(first, second, own);
      },
      [](const MapOverlay& overlay) { return overlay.complex.face_count(); });
}

void add_plane(std::vector<Job>& jobs, const MacroOptions& options) {
  for (const char* const name : {"us-counties", "world-countries"}) {
    const std::string file = fmt::format("corpus/maps/{}.clean.map", name);
    jobs.push_back({"map check", file, true, "regions", [file] { return check_of(map_of(file)); }});
  }
  const auto faces = static_cast<std::uint32_t>(options.size(100000, 1000));
  jobs.push_back({"map check", "hexagons", false, "regions", [faces] {
                    return check_of(to_map(testing::map_family("hexagons").make(faces)));
                  }});
  jobs.push_back({"map overlay", "corpus/maps: us-states over us-counties", true, "faces", [] {
                    return overlay_of(map_of("corpus/maps/us-states.clean.map"),
                                      map_of("corpus/maps/us-counties.clean.map"));
                  }});
  const std::size_t corners = options.size(30000, 100);
  jobs.push_back({"plane Boolean", "union of two stars", false, "edges", [corners] {
                    const Nef2 a = Nef2::polygon(testing::star_polygon(corners, 1));
                    const Nef2 b = Nef2::polygon(testing::star_polygon(corners, 2));
                    return timed(
                        [a, b] {
                          Context context;
                          return combine(a, b, kUnion, context);
                        },
                        [](const Nef2& set) { return set.complex().edge_count(); });
                  }});
  const std::size_t segments = options.size(2000, 50);
  jobs.push_back(
      {"plane arrangement", fmt::format("{} long segments", segments), false, "faces", [segments] {
         return timed(
             [scene = scene_of(testing::long_segments(segments))] { return arranged(scene); },
             [](const Arrangement& a) { return a.complex.face_count(); });
       }});
  const std::size_t tips = options.size(4000, 50);
  jobs.push_back({"convex pieces of the plane", "star, by diagonals", false, "pieces", [tips] {
                    return timed(
                        [set = Nef2::polygon(testing::star_polygon(tips, 1))] {
                          Context context;
                          return decompose(set, {PartitionMethod::Diagonals, false}, context);
                        },
                        [](const auto& result) { return result.pieces.size(); });
                  }});
}

// ---------------------------------------------------------------- space

Once union_of_meshes(const PolygonMesh& a, const PolygonMesh& b) {
  return timed(
      [a, b] {
        Context context;
        const Nef3 set = combine(testing::solid(a), testing::solid(b), kUnion, context);
        return mesh_of_complex(set.complex(), {MeshFaces::Triangles, false, false}, context).mesh;
      },
      [](const PolygonMesh& mesh) { return mesh.face_count(); });
}

Once decomposition_of(const PolygonMesh& mesh) {
  return timed(
      [set = testing::solid(mesh)] {
        Context context;
        return decompose(set, {}, context);
      },
      [](const ConvexPieces& result) { return result.pieces.size(); });
}

void add_space(std::vector<Job>& jobs, const MacroOptions& options) {
  jobs.push_back({"space Boolean, mesh to triangles", "corpus/solids/bunny.off and itself moved",
                  true, "triangles", [] {
                    const PolygonMesh bunny = mesh_of("corpus/solids/bunny.off");
                    return union_of_meshes(bunny, shifted(bunny));
                  }});
  const int depth = options.most < 50 ? 3 : 6;
  jobs.push_back({"space Boolean, mesh to triangles",
                  fmt::format("two icospheres of 20 * 4^{}", depth), false, "triangles", [depth] {
                    return union_of_meshes(testing::icosphere_mesh(depth, 1, {0, 0, 0}),
                                           testing::icosphere_mesh(depth, 1, {0.3, 0.2, 0.1}));
                  }});
  jobs.push_back({"is it convex?", "icosphere", false, "yes", [depth] {
                    return timed(
                        [mesh = testing::icosphere_mesh(depth, 1, {0, 0, 0})] {
                          Context context;
                          return is_convex_mesh(mesh, context);
                        },
                        [](bool is_convex) { return is_convex ? 1 : 0; });
                  }});
  jobs.push_back({"convex pieces", "corpus/solids/l-block.off", true, "pieces",
                  [] { return decomposition_of(mesh_of("corpus/solids/l-block.off")); }});
  const auto teeth = static_cast<int>(options.size(32, 2));
  jobs.push_back({"convex pieces", fmt::format("block with {} + {} notches", teeth, teeth), false,
                  "pieces",
                  [teeth] { return decomposition_of(testing::comb_block(teeth, teeth)); }});
  jobs.push_back({"Minkowski sum", "two of corpus/solids/l-block.off", true, "facets", [] {
                    return timed(
                        [set = testing::solid(mesh_of("corpus/solids/l-block.off"))] {
                          Context context;
                          return minkowski_sum(set, set, context);
                        },
                        [](const Nef3& sum) { return sum.counts().facets; });
                  }});
  const std::size_t corners = options.size(10000, 100) / 2 * 2;
  jobs.push_back({"sphere Boolean", "two crowns that cross", false, "arcs", [corners] {
                    const NefSphere a = testing::crown(corners, 0, 0.5, 1.5);
                    const NefSphere b = testing::crown(corners, 0.37, 0.6, 1.4);
                    return timed(
                        [a, b] {
                          Context context;
                          return combine(a, b, kUnion, context);
                        },
                        [](const NefSphere& set) { return set.map().arc_count(); });
                  }});
}

// ---------------------------------------------------------------- surfaces

void add_surfaces(std::vector<Job>& jobs) {
  for (const char* const name : {"bunny.json", "bunny-rosette.json", "torus.json"}) {
    const std::string file = fmt::format("corpus/scenes/{}", name);
    jobs.push_back({"polygons on a surface, with reading", file, true, "cells", [file] {
                      return timed(
                          [file] {
                            Context context;
                            return SurfaceDivision(read_scene_file(file, {}, context).scene,
                                                   context);
                          },
                          [](const SurfaceDivision& division) { return division.cell_count(); });
                    }});
  }
}

// ---------------------------------------------------------------- files

/// Of `text`, in bytes.
template <class Read>
Once reading(std::string text, Read read) {
  const std::size_t size = text.size();
  return timed([text = std::move(text), read] { return read(text); },
               [size](const auto&) { return size; });
}

void add_files(std::vector<Job>& jobs, const MacroOptions& options) {
  const int depth = options.most < 50 ? 3 : 6;
  const std::string input = fmt::format("icosphere of 20 * 4^{}", depth);
  constexpr std::pair<const char*, MeshFormat> kFormats[] = {{"OFF", MeshFormat::Off},
                                                             {"OBJ", MeshFormat::Obj},
                                                             {"STL, text", MeshFormat::Stl},
                                                             {"STL, binary", MeshFormat::StlBinary},
                                                             {"PLY, binary", MeshFormat::Ply}};
  for (const auto& [name, format] : kFormats) {
    jobs.push_back({fmt::format("read {}", name), input, false, "bytes", [=, format = format] {
                      const PolygonMesh mesh = testing::icosphere_mesh(depth, 1, {0, 0, 0});
                      return reading(
                          text_of([&](std::ostream& out) { write_mesh(out, mesh, format); }),
                          [format](const std::string& text) {
                            Context context;
                            return read_mesh(text, format, {}, context);
                          });
                    }});
  }
  jobs.push_back({"read .nef, with its audit", input, false, "bytes", [depth] {
                    const Nef3 set = testing::solid(testing::icosphere_mesh(depth, 1, {0, 0, 0}));
                    return reading(
                        text_of([&](std::ostream& out) { write_nef3(out, set.complex()); }),
                        [](const std::string& text) {
                          Context context;
                          SpaceComplex complex = read_nef3(text, {}, context);
                          PLUMB_CHECK(!audit(complex, true, context));
                          return complex;
                        });
                  }});
  jobs.push_back({"read map", "corpus/maps/us-counties.map", true, "bytes", [] {
                    const Map map = map_of("corpus/maps/us-counties.map");
                    return reading(text_of([&](std::ostream& out) { write_map(out, map); }),
                                   [](const std::string& text) {
                                     Context context;
                                     return read_map(text, {}, context);
                                   });
                  }});
  const std::size_t corners = options.size(100000, 1000);
  jobs.push_back({"read WKT", "a star", false, "bytes", [corners] {
                    Context context;
                    const PlaneText star(Nef2::polygon(testing::star_polygon(corners, 1)),
                                         PlaneFormat::Wkt, context);
                    return reading(text_of([&](std::ostream& out) { star.write(out); }),
                                   [](const std::string& text) {
                                     Context own;
                                     return read_plane_set(text, PlaneFormat::Wkt, {}, own);
                                   });
                  }});
}

int run(const MacroOptions& options, nlohmann::ordered_json& rows) {
  std::vector<Job> jobs;
  add_plane(jobs, options);
  add_space(jobs, options);
  add_surfaces(jobs);
  add_files(jobs, options);
  int status = 0;
  for (const Job& job : jobs) {
    nlohmann::ordered_json& row =
        rows.emplace_back(nlohmann::ordered_json{{"capability", job.capability},
                                                 {"input", job.input},
                                                 {"kind", job.is_real ? "real" : "generated"}});
    Measured m;
    try {
      m = in_own_process(job.prepare);
    } catch (const std::exception& error) {
      row["failure"] = error.what();
      fmt::print("{:36} {:44} FAILED: {}\n", job.capability, job.input, error.what());
      status = 1;
      continue;
    }
    row.update(
        {{"size", m.size}, {"unit", job.unit}, {"seconds", m.seconds}, {"megabytes", m.megabytes}});
    if (!m.calls.empty()) row["calls"] = m.calls;
    fmt::print("{:36} {:44} {:9.0f} {:10} {:10.6f} s {:7.1f} MB\n", job.capability, job.input,
               m.size, job.unit, m.seconds, m.megabytes);
    std::fflush(stdout);
  }
  return status;
}

}  // namespace
}  // namespace plumb::bench

int main(int argc, char** argv) {
  return plumb::bench::macro_main("capabilities", "Capabilities on real and generated inputs", argc,
                                  argv, plumb::bench::run);
}
