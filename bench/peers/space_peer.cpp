// The union of two solids, from mesh to mesh, in plumb and in CGAL: CPU time and peak memory.
//
//   space_peer DIR [--make] [--of FILE,... [--along x]] [--pairs ico5120,...] [--peers
//   nef3,corefinement] [--rounds N]
//              [--json FILE]
//
// reads DIR/PAIR_a.off and DIR/PAIR_b.off; --make writes them first: ico1280 ... ico327680, two
// spheres of so many triangles; bunny, corpus/solids/bunny.off and itself moved; bunny58784, the
// same with every triangle in sixteen on a surface that is wavy; and degenerate ones: cubes19200,
// two cubes of so many triangles, shifted within two of their planes; ico5120-turned, by 1e-12,
// whose planes are nearly parallel; ico20480-twice, the same mesh. --of writes and compares pairs
// of other meshes, each and itself moved: by a seventh of its width in x, half and a third of that
// in y and z; or with --along by a seventh of its width along one axis, so that faces along it
// slide in their planes. Every run is a process of its own (this program again, with --run): plumb
// and the peer in turn, N rounds; plumb-warm runs twice and tells the second, for programs that
// compare with a library already warm. Whatever the engine, malloc keeps what is freed and has huge
// pages (keep_freed_memory.h). Time: user and system, of making sets from the meshes in memory, the
// union and the triangles of the result; reading files is left out. Memory: the largest resident
// set of the whole process, reading included. The answer is the volume, to 1e-9 of it.
//
// Peers, over the exact kernel with lazy constructions (EPECK): nef3 is Nef_polyhedron_3, which
// like plumb holds any set, and is not asked for the two largest pairs; corefinement is
// Polygon_mesh_processing::corefine_and_compute_union, for meshes that bound volumes.
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Nef_polyhedron_3.h>
#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Polygon_mesh_processing/corefinement.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/convert_nef_polyhedron_to_polygon_mesh.h>
#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <exception>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "../complexity/cpu_time.h"
#include "../report/report.h"
#include "generate/meshes.h"
#include "peer_report.h"
#include "plumb/base/keep_freed_memory.h"
#include "plumb/io/mesh_io.h"
#include "plumb/space/nef3.h"
#include "plumb/space/to_mesh.h"

namespace plumb::bench {
namespace {

using Files = std::array<std::string, 2>;

/// Of a closed mesh of triangles around the origin, in doubles.
template <class Corner>
double volume_of(std::size_t triangles, Corner corner) {
  double sum = 0;
  for (std::size_t t = 0; t < triangles; ++t) {
    const Point3 a = corner(t, 0);
    const Point3 b = corner(t, 1);
    const Point3 c = corner(t, 2);
    sum += a.x * (b.y * c.z - b.z * c.y) - a.y * (b.x * c.z - b.z * c.x) +
           a.z * (b.x * c.y - b.y * c.x);
  }
  return sum / 6;
}

// ---------------------------------------------------------------- the engines

PeerRun run_plumb(const Files& files) {
  Context context;
  const PolygonMesh a = read_mesh_file(files[0], {}, {}, context).mesh;
  const PolygonMesh b = read_mesh_file(files[1], {}, {}, context).mesh;
  const double start = cpu_seconds();
  const Nef3 set =
      boolean_op(Nef3::from_mesh(a, {.rule = WindingRule::Positive}, context),
                 Nef3::from_mesh(b, {.rule = WindingRule::Positive}, context), kUnion, context);
  const PolygonMesh mesh =
      mesh_of_complex(set.complex(), {MeshFaces::Triangles, false, false}, context).mesh;
  const double seconds = cpu_seconds() - start;
  const double volume = volume_of(mesh.face_count(), [&](std::size_t f, std::size_t i) {
    return mesh.points[mesh.face(f)[i]];
  });
  return {seconds, volume, 0};
}

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using CgalMesh = CGAL::Surface_mesh<Kernel::Point_3>;

CgalMesh read_cgal(const std::string& file) {
  CgalMesh mesh;
  if (!CGAL::IO::read_polygon_mesh(file, mesh)) throw std::runtime_error("cannot read " + file);
  return mesh;
}

double volume_of(const CgalMesh& mesh) {
  std::vector<std::array<Point3, 3>> triangles;
  for (const auto face : mesh.faces()) {
    std::array<Point3, 3> corners;
    std::size_t i = 0;
    for (const auto v : CGAL::vertices_around_face(mesh.halfedge(face), mesh)) {
      const Kernel::Point_3& p = mesh.point(v);
      corners[i++ % 3] = {CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z())};
    }
    triangles.push_back(corners);
  }
  return volume_of(triangles.size(), [&](std::size_t t, std::size_t i) { return triangles[t][i]; });
}

PeerRun run_nef3(const Files& files) {
  using Nef = CGAL::Nef_polyhedron_3<Kernel>;
  const CgalMesh a = read_cgal(files[0]);
  const CgalMesh b = read_cgal(files[1]);
  const double start = cpu_seconds();
  const Nef set = Nef(a) + Nef(b);
  CgalMesh mesh;
  CGAL::convert_nef_polyhedron_to_polygon_mesh(set, mesh, true);
  const double seconds = cpu_seconds() - start;
  return {seconds, volume_of(mesh), 0};
}

PeerRun run_corefinement(const Files& files) {
  CgalMesh a = read_cgal(files[0]);
  CgalMesh b = read_cgal(files[1]);
  const double start = cpu_seconds();
  CgalMesh mesh;
  if (!CGAL::Polygon_mesh_processing::corefine_and_compute_union(a, b, mesh)) {
    throw std::runtime_error("the union bounds no volume");
  }
  const double seconds = cpu_seconds() - start;
  return {seconds, volume_of(mesh), 0};
}

int run_once(const std::string& engine, const Files& files) {
  keep_freed_memory();
  use_huge_pages();
  if (engine == "plumb-warm") run_plumb(files);
  const PeerRun r = engine.starts_with("plumb") ? run_plumb(files)
                    : engine == "nef3"          ? run_nef3(files)
                                                : run_corefinement(files);
  fmt::print("{:.6f} {:.17g}\n", r.seconds, r.answer);
  return 0;
}

// ---------------------------------------------------------------- pairs of processes

std::string own_path() {
  std::array<char, 4096> path{};
  const auto length = readlink("/proc/self/exe", path.data(), path.size() - 1);
  return {path.data(), static_cast<std::size_t>(std::max<ssize_t>(length, 0))};
}

/// The run in a process of its own; its memory as the kernel saw it.
PeerRun in_process(const std::string& engine, const Files& files) {
  const std::string self = own_path();
  const Finished process = run_apart([&] {
    execl(self.c_str(), self.c_str(), "--run", engine.c_str(), files[0].c_str(), files[1].c_str(),
          nullptr);
    throw std::runtime_error("cannot run " + self);
  });
  PeerRun outcome;
  std::istringstream output(process.output);
  output >> outcome.seconds >> outcome.answer;
  if (!process.is_well || !output) throw std::runtime_error(engine + " failed");
  outcome.megabytes = process.megabytes;
  return outcome;
}

// ---------------------------------------------------------------- pairs

struct MeshPair {
  std::string name;
  std::array<PolygonMesh, 2> meshes;
};

MeshPair spheres(const std::string& name, int depth) {
  return {name,
          {testing::icosphere_mesh(depth, 1, {0, 0, 0}),
           testing::icosphere_mesh(depth, 1, {0.3, 0.2, 0.1})}};
}

double width_along(const PolygonMesh& mesh, double Point3::*axis) {
  const auto [low, high] = std::ranges::minmax(mesh.points, {}, axis);
  return high.*axis - low.*axis;
}

MeshPair itself_moved(const std::string& name, const PolygonMesh& mesh) {
  const double step = width_along(mesh, &Point3::x) / 7;
  return {name, {mesh, testing::moved(mesh, {step, step / 2, step / 3})}};
}

/// `axis`: x, y or z.
MeshPair itself_slid(const std::string& name, const PolygonMesh& mesh, char axis) {
  constexpr std::array kAxes{&Point3::x, &Point3::y, &Point3::z};
  const auto along = kAxes[static_cast<std::size_t>(axis - 'x')];
  Point3 step;
  step.*along = width_along(mesh, along) / 7;
  return {name, {mesh, testing::moved(mesh, step)}};
}

PolygonMesh read_plumb(const std::string& file) {
  Context context;
  return read_mesh_file(file, {}, {}, context).mesh;
}

/// Every triangle in four.
PolygonMesh split(const PolygonMesh& mesh) {
  PolygonMesh result;
  result.points = mesh.points;
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
  const auto middle = [&](std::uint32_t a, std::uint32_t b) {
    const auto next = static_cast<std::uint32_t>(result.points.size());
    const auto [place, is_new] = middles.try_emplace(std::minmax(a, b), next);
    if (is_new) {
      const Point3 p = mesh.points[a], q = mesh.points[b];
      result.points.push_back({(p.x + q.x) / 2, (p.y + q.y) / 2, (p.z + q.z) / 2});
    }
    return place->second;
  };
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    const auto corners = mesh.face(f);
    const std::uint32_t a = corners[0], b = corners[1], c = corners[2];
    const std::uint32_t ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
    for (const auto& [u, v, w] : {std::array{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}}) {
      result.add_face(std::array{u, v, w});
    }
  }
  return result;
}

/// Points move by less than they are apart, so that nothing crosses; the four triangles of one no
/// longer lie in a plane.
PolygonMesh wavy(PolygonMesh mesh) {
  double width = 0;
  for (const Point3& p : mesh.points) width = std::max({width, std::fabs(p.x), std::fabs(p.y)});
  const auto wave = [width](double t) { return width / 500 * std::sin(60 * t / width); };
  for (Point3& p : mesh.points) p = {p.x + wave(p.y), p.y + wave(p.z), p.z + wave(p.x)};
  return mesh;
}

/// Those that Nef_polyhedron_3 is not asked for: it would take minutes and gigabytes.
const std::vector<std::string> kLargePairs{"ico81920", "ico327680"};

bool is_large(const std::string& pair) {
  return std::find(kLargePairs.begin(), kLargePairs.end(), pair) != kLargePairs.end();
}

MeshPair pair_of_the_tree(const std::string& name) {
  if (name == "cubes19200") {  // half of their faces lie in common planes
    return {name,
            {testing::grid_cube_mesh(40, {0, 0, 0}), testing::grid_cube_mesh(40, {3.25, 2.5, 0})}};
  }
  if (name == "ico5120-turned") {
    const PolygonMesh mesh = testing::icosphere_mesh(4, 1, {0, 0, 0});
    return {name, {mesh, testing::turned(mesh, 1e-12)}};
  }
  if (name == "ico20480-twice") {
    const PolygonMesh mesh = testing::icosphere_mesh(5, 1, {0.1, 0.2, 0.3});
    return {name, {mesh, mesh}};
  }
  if (name == "bunny") return itself_moved(name, read_plumb("corpus/solids/bunny.off"));
  if (name == "bunny58784") {
    return itself_moved(name, wavy(split(split(read_plumb("corpus/solids/bunny.off")))));
  }
  for (int depth = 0, triangles = 20; depth < 9; ++depth, triangles *= 4) {
    if (name == fmt::format("ico{}", triangles)) return spheres(name, depth);
  }
  throw std::runtime_error("no pair " + name);
}

void write_pair(const std::string& directory, const MeshPair& pair) {
  std::filesystem::create_directories(directory);
  for (std::size_t i = 0; i < 2; ++i) {
    std::ofstream out(directory + '/' + pair.name + (i == 0 ? "_a.off" : "_b.off"));
    write_mesh(out, pair.meshes[i], MeshFormat::Off);
    if (!out.flush()) throw std::runtime_error("cannot write in " + directory);
  }
}

/// Of a mesh moved, or slid along an axis: "fandisk", "fandisk-z".
std::string pair_of(const std::string& file, const std::string& along) {
  const std::string name = std::filesystem::path(file).stem();
  return along.empty() ? name : name + '-' + along;
}

MeshPair pair_from(const std::string& file, const std::string& along) {
  const PolygonMesh mesh = read_plumb(file);
  const std::string name = pair_of(file, along);
  return along.empty() ? itself_moved(name, mesh) : itself_slid(name, mesh, along[0]);
}

int compare_all(const std::string& directory, const std::vector<std::string>& pairs,
                const std::vector<std::string>& peers, int rounds, const std::string& json) {
  PeerReport report("Union of two solids beside CGAL, from mesh to triangles");
  report.use("CGAL", CGAL_VERSION_STR);
  for (const std::string& peer : peers) {
    const bool is_nef = peer == "nef3";
    for (const std::string& pair : pairs) {
      if (is_nef && is_large(pair)) continue;
      const std::string path = directory + '/' + pair;
      const Files files{path + "_a.off", path + "_b.off"};
      report.compare(
          {"union", "two of " + pair, is_nef ? "CGAL Nef_polyhedron_3" : "CGAL corefinement",
           "volume", 1e-9, rounds},
          [&] { return in_process("plumb", files); }, [&] { return in_process(peer, files); });
    }
  }
  return report.finish(json);
}

}  // namespace
}  // namespace plumb::bench

int main(int argc, char** argv) {
  CLI::App app{"The union of two solids beside CGAL"};
  std::vector<std::string> run;
  std::string directory, along;
  std::vector<std::string> pairs{"ico1280",    "ico5120",    "ico20480",       "bunny",
                                 "bunny58784", "cubes19200", "ico5120-turned", "ico20480-twice",
                                 "ico81920",   "ico327680"},
      files;
  std::vector<std::string> peers{"nef3", "corefinement"};
  plumb::bench::PeerOptions options;
  bool makes = false;
  app.add_option("directory", directory, "of PAIR_a.off and PAIR_b.off");
  app.add_flag("--make", makes, "write the pairs there first");
  app.add_option("--of", files, "write the pairs of these meshes, and compare no others")
      ->delimiter(',');
  app.add_option("--along", along, "x, y or z: they are moved along this axis alone")
      ->check(CLI::IsMember({"x", "y", "z"}));
  app.add_option("--pairs", pairs, "names of pairs")->delimiter(',');
  app.add_option("--peers", peers, "nef3, corefinement")->delimiter(',');
  options.add_to(app);
  app.add_option("--run", run,
                 "ENGINE A B: one run of plumb, plumb-warm, nef3 or corefinement; prints seconds "
                 "and volume")
      ->expected(3);
  CLI11_PARSE(app, argc, argv);
  if (!run.empty()) return plumb::bench::run_once(run[0], {run[1], run[2]});
  // Apart: the memory of this process is the least that the kernel reports of those it starts.
  const auto make = [&] {
    using namespace plumb::bench;
    if (files.empty()) {
      for (const std::string& pair : pairs) write_pair(directory, pair_of_the_tree(pair));
    }
    for (const std::string& file : files) write_pair(directory, pair_from(file, along));
  };
  if ((makes || !files.empty()) && !plumb::bench::run_apart(make).is_well) {
    fmt::print(stderr, "space_peer: no pairs were made\n");
    return 2;
  }
  if (!files.empty()) pairs.clear();
  for (const std::string& file : files) pairs.push_back(plumb::bench::pair_of(file, along));
  return plumb::bench::compare_all(directory, pairs, peers, options.rounds, options.json);
}
