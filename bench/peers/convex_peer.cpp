// Convex decomposition and Minkowski sums, in plumb and in CGAL: CPU time, pieces and volumes.
//
//   convex_peer walls FILE.off...          vertical walls against convex_decomposition_3
//   convex_peer sums A.off B.off           minkowski_sum against minkowski_sum_3
//
// Time: user and system, of the operation alone; reading and making sets from meshes are left out. plumb and
// CGAL in turn. Exit 1 if the volumes of the two sums differ by more than 1e-9 of them, or ours of the pieces from
// that of the solid.
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Nef_polyhedron_3.h>
#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/convert_nef_polyhedron_to_polygon_mesh.h>
#include <CGAL/convex_decomposition_3.h>
#include <CGAL/minkowski_sum_3.h>
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include "../complexity/cpu_time.h"
#include "plumb/convex/minkowski.h"
#include "plumb/convex/walls.h"
#include "plumb/io/solid_sets.h"
#include "plumb/space/space_measure.h"

namespace plumb::bench {
namespace {

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
template <class Work>
double seconds_of(const Work& work) {
  const double start = cpu_seconds();
  work();
  return cpu_seconds() - start;
}

using PeerSet = CGAL::Nef_polyhedron_3<Kernel>;
using PeerMesh = CGAL::Surface_mesh<Kernel::Point_3>;

PeerSet peer_set(const std::string& file) {
  PeerMesh mesh;
  CGAL::Polygon_mesh_processing::IO::read_polygon_mesh(file, mesh);
  CGAL::Polygon_mesh_processing::triangulate_faces(mesh);
  return PeerSet(mesh);
}

double peer_volume(const PeerSet& set) {
  PeerMesh mesh;
  CGAL::convert_nef_polyhedron_to_polygon_mesh(set, mesh, true);
  return CGAL::to_double(CGAL::Polygon_mesh_processing::volume(mesh));
}

std::size_t peer_pieces(const PeerSet& set) {
  std::size_t count = 0;
  for (auto v = ++set.volumes_begin(); v != set.volumes_end(); ++v) count += v->mark() ? 1 : 0;
  return count;
}

Nef3 own_set(const std::string& file) {
  Context context;
  return read_solid_file(file, {}, context).set;
}

bool compare_walls(const std::string& file) {
  Context context;
  const Nef3 set = own_set(file);
  ConvexPieces pieces;
  const double own_seconds = seconds_of([&] {
    pieces = decompose_by_walls(set, {DecomposeMethod::Walls, false}, context);
  });
  Rational volume = 0;
  for (const Nef3& piece : pieces.pieces) volume += *marked_volume(piece.complex());
  PeerSet peer = peer_set(file);
  const double peer_seconds = seconds_of([&] { CGAL::convex_decomposition_3(peer); });
  fmt::print("{}: reflex edges {}, pieces {} / {}, seconds {:.4f} / {:.4f}\n", file,
             pieces.reflex_edges, pieces.pieces.size(), peer_pieces(peer), own_seconds,
             peer_seconds);
  std::fflush(stdout);
  return volume == *marked_volume(set.complex());
}

bool compare_sums(const std::string& a, const std::string& b) {
  Context context;
  const Nef3 own_a = own_set(a), own_b = own_set(b);
  Nef3 own;
  const double own_seconds = seconds_of([&] { own = minkowski_sum(own_a, own_b, context); });
  PeerSet peer_a = peer_set(a), peer_b = peer_set(b), peer;
  const double peer_seconds = seconds_of([&] { peer = CGAL::minkowski_sum_3(peer_a, peer_b); });
  const auto volume = marked_volume(own.complex())->convert_to<double>();
  const double other = peer_volume(peer);
  fmt::print("{} + {}: volume {} / {}, seconds {:.4f} / {:.4f}\n", a, b, volume, other, own_seconds,
             peer_seconds);
  return std::fabs(volume - other) <= 1e-9 * volume;
}

}  // namespace
}  // namespace plumb::bench

int main(int argc, char** argv) {
  CLI::App app("Convex decomposition and Minkowski sums against CGAL");
  app.require_subcommand(1);
  std::vector<std::string> files;
  CLI::App* walls = app.add_subcommand("walls");
  walls->add_option("files", files)->required();
  std::string a, b;
  CLI::App* sums = app.add_subcommand("sums");
  sums->add_option("a", a)->required();
  sums->add_option("b", b)->required();
  CLI11_PARSE(app, argc, argv);
  bool agree = true;
  if (sums->parsed()) agree = plumb::bench::compare_sums(a, b);
  for (const std::string& file : files) agree = plumb::bench::compare_walls(file) && agree;
  return agree ? 0 : 1;
}
