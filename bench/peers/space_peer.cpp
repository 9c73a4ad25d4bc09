// The union of two solids, from mesh to mesh, in plumb and in CGAL: CPU time and peak memory.
//
//   space_peer DIR [--pairs ico20480,elephant,bunny00] [--peers nef3,corefinement] [--rounds N]
//
// reads DIR/PAIR_a.off and DIR/PAIR_b.off. Every run is a process of its own (this program again, with --run):
// plumb and the peer in turn, N rounds. Time: user and system, of making sets from the meshes in memory, the union
// and the triangles of the result; reading files is left out. Memory: the largest resident set of the whole
// process, reading included. Exit 1 if volumes differ by more than 1e-9 of them.
//
// Peers, over the exact kernel with lazy constructions (EPECK): nef3 is Nef_polyhedron_3, which like plumb
// holds any set; corefinement is Polygon_mesh_processing::corefine_and_compute_union, for meshes that bound
// volumes.
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Nef_polyhedron_3.h>
#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Polygon_mesh_processing/corefinement.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/convert_nef_polyhedron_to_polygon_mesh.h>
#include <fmt/format.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <stdexcept>
#include <string>
#include <vector>

#include "../complexity/cpu_time.h"
#include "plumb/io/solid_io.h"
#include "plumb/space/nef3.h"
#include "plumb/space/to_mesh.h"

namespace plumb::bench {
namespace {

using Files = std::array<std::string, 2>;

/// What a run says of itself.
struct Outcome {
  double seconds = 0;
  double megabytes = 0;
  double volume = 0;
};

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

Outcome run_plumb(const Files& files) {
  Context context;
  const PolygonMesh a = read_mesh_file(files[0], {}, {}, context).mesh;
  const PolygonMesh b = read_mesh_file(files[1], {}, {}, context).mesh;
  const double start = cpu_seconds();
  const Nef3 set = combine(Nef3::mesh(a, WindingRule::Positive, context),
                           Nef3::mesh(b, WindingRule::Positive, context), kUnion, context);
  const PolygonMesh mesh =
      mesh_of_complex(set.complex(), {MeshFaces::Triangles, false, false}, context).mesh;
  const double seconds = cpu_seconds() - start;
  return {seconds, 0, volume_of(mesh.face_count(), [&](std::size_t f, std::size_t i) {
            return mesh.points[mesh.face(f)[i]];
          })};
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

Outcome run_nef3(const Files& files) {
  using Nef = CGAL::Nef_polyhedron_3<Kernel>;
  const CgalMesh a = read_cgal(files[0]);
  const CgalMesh b = read_cgal(files[1]);
  const double start = cpu_seconds();
  const Nef set = Nef(a) + Nef(b);
  CgalMesh mesh;
  CGAL::convert_nef_polyhedron_to_polygon_mesh(set, mesh, true);
  const double seconds = cpu_seconds() - start;
  return {seconds, 0, volume_of(mesh)};
}

Outcome run_corefinement(const Files& files) {
  CgalMesh a = read_cgal(files[0]);
  CgalMesh b = read_cgal(files[1]);
  const double start = cpu_seconds();
  CgalMesh mesh;
  if (!CGAL::Polygon_mesh_processing::corefine_and_compute_union(a, b, mesh)) {
    throw std::runtime_error("the union bounds no volume");
  }
  const double seconds = cpu_seconds() - start;
  return {seconds, 0, volume_of(mesh)};
}

int run_once(const std::string& engine, const Files& files) {
  const Outcome r = engine == "plumb"  ? run_plumb(files)
                    : engine == "nef3" ? run_nef3(files)
                                       : run_corefinement(files);
  fmt::print("{} {}\n", r.seconds, r.volume);
  return 0;
}

// ---------------------------------------------------------------- pairs of processes

std::string own_path() {
  std::array<char, 4096> path{};
  const auto length = readlink("/proc/self/exe", path.data(), path.size() - 1);
  return {path.data(), static_cast<std::size_t>(std::max<ssize_t>(length, 0))};
}

/// The run in a process of its own; its memory as the kernel saw it.
Outcome in_process(const std::string& engine, const Files& files) {
  std::array<int, 2> ends{};
  if (pipe(ends.data()) != 0) throw std::runtime_error("no pipe");
  const std::string self = own_path();
  const pid_t child = fork();
  if (child == 0) {
    dup2(ends[1], STDOUT_FILENO);
    execl(self.c_str(), self.c_str(), "--run", engine.c_str(), files[0].c_str(), files[1].c_str(),
          nullptr);
    _exit(127);
  }
  close(ends[1]);
  FILE* const out = fdopen(ends[0], "r");
  Outcome outcome;
  const bool is_read = std::fscanf(out, "%lf %lf", &outcome.seconds, &outcome.volume) == 2;
  std::fclose(out);
  int status = 0;
  rusage usage{};
  wait4(child, &status, 0, &usage);
  if (!is_read || status != 0) throw std::runtime_error(engine + " failed");
  outcome.megabytes = static_cast<double>(usage.ru_maxrss) / 1024;
  return outcome;
}

/// "0.071 (0.070 .. 0.074)"
std::string summary(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return fmt::format("{:.4f} ({:.4f} .. {:.4f})", values[values.size() / 2], values.front(),
                     values.back());
}

bool compare(const std::string& pair, const std::string& peer, const Files& files, int rounds) {
  std::vector<double> time_ratios;
  std::vector<double> memory_ratios;
  Outcome least_ours{1e300, 1e300, 0};
  Outcome least_theirs = least_ours;
  for (int i = 0; i < rounds; ++i) {
    const Outcome ours = in_process("plumb", files);
    const Outcome theirs = in_process(peer, files);
    time_ratios.push_back(ours.seconds / theirs.seconds);
    memory_ratios.push_back(ours.megabytes / theirs.megabytes);
    least_ours = {std::min(least_ours.seconds, ours.seconds),
                  std::min(least_ours.megabytes, ours.megabytes), ours.volume};
    least_theirs = {std::min(least_theirs.seconds, theirs.seconds),
                    std::min(least_theirs.megabytes, theirs.megabytes), theirs.volume};
  }
  const bool agree =
      std::fabs(least_ours.volume - least_theirs.volume) <= 1e-9 * std::fabs(least_ours.volume);
  fmt::print("{:10} {:13} plumb {:8.3f} s {:7.0f} MB  peer {:8.3f} s {:7.0f} MB\n", pair, peer,
             least_ours.seconds, least_ours.megabytes, least_theirs.seconds,
             least_theirs.megabytes);
  fmt::print(
      "    time ratio {}  memory ratio {}{}\n", summary(time_ratios), summary(memory_ratios),
      agree ? ""
            : fmt::format("  VOLUMES DIFFER: {} and {}", least_ours.volume, least_theirs.volume));
  std::fflush(stdout);
  return agree;
}

}  // namespace
}  // namespace plumb::bench

int main(int argc, char** argv) {
  CLI::App app{"The union of two solids beside CGAL"};
  std::vector<std::string> run;
  std::string directory;
  std::vector<std::string> pairs{"ico20480", "elephant", "bunny00"};
  std::vector<std::string> peers{"nef3", "corefinement"};
  int rounds = 3;
  app.add_option("directory", directory, "of PAIR_a.off and PAIR_b.off");
  app.add_option("--pairs", pairs, "names of pairs")->delimiter(',');
  app.add_option("--peers", peers, "nef3, corefinement")->delimiter(',');
  app.add_option("--rounds", rounds, "of plumb and the peer in turn (default 3)");
  app.add_option("--run", run, "ENGINE A B: one run; prints seconds and volume")->expected(3);
  CLI11_PARSE(app, argc, argv);
  if (!run.empty()) return plumb::bench::run_once(run[0], {run[1], run[2]});
  fmt::print("CGAL {}\n", CGAL_VERSION_STR);
  bool agree = true;
  for (const std::string& peer : peers) {
    for (const std::string& pair : pairs) {
      const std::string path = directory + '/' + pair;
      agree &= plumb::bench::compare(pair, peer, {path + "_a.off", path + "_b.off"}, rounds);
    }
  }
  return agree ? 0 : 1;
}
