// Convex decomposition and Minkowski sums, in plumb and in CGAL: CPU time, pieces and volumes.
//
//   convex_peer [--most PERCENT] [--rounds N] [--json FILE] [--walls FILE.off...] [--sums A.off
//   B.off]
//
// Time: user and system, of the operation alone; reading and making sets from meshes are left out.
// Vertical walls against convex_decomposition_3: the answer is the volume of all pieces.
// minkowski_sum against minkowski_sum_3: the volume of the sum. Without files: blocks with notches
// on both sides, also along a saddle, an L, and sums of these.
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Nef_polyhedron_3.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/convert_nef_polyhedron_to_polygon_mesh.h>
#include <CGAL/boost/graph/copy_face_graph.h>
#include <CGAL/convex_decomposition_3.h>
#include <CGAL/minkowski_sum_3.h>
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "../complexity/cpu_time.h"
#include "generate/mesh_solid.h"
#include "generate/voxel_mesh.h"
#include "peer_report.h"
#include "plumb/convex/minkowski.h"
#include "plumb/convex/walls.h"
#include "plumb/io/mesh_io.h"
#include "plumb/space/space_measure.h"

namespace plumb::bench {
namespace {

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using PeerSet = CGAL::Nef_polyhedron_3<Kernel>;
using PeerMesh = CGAL::Surface_mesh<Kernel::Point_3>;

PeerSet peer_set(const PolygonMesh& mesh) {
  PeerMesh result;
  std::vector<PeerMesh::Vertex_index> vertices;
  for (const Point3& p : mesh.points) vertices.push_back(result.add_vertex({p.x, p.y, p.z}));
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    std::vector<PeerMesh::Vertex_index> corners;
    for (const std::uint32_t v : mesh.face(f)) corners.push_back(vertices[v]);
    result.add_face(corners);
  }
  CGAL::Polygon_mesh_processing::triangulate_faces(result);
  return PeerSet(result);
}

double peer_volume(const PeerSet& set) {
  PeerMesh mesh;
  CGAL::convert_nef_polyhedron_to_polygon_mesh(set, mesh, true);
  return CGAL::to_double(CGAL::Polygon_mesh_processing::volume(mesh));
}

/// Of all marked volumes, which the outer one is not: shells of CGAL's pieces are meshes, volume by
/// volume.
double volume_of_pieces(PeerSet& set) {
  double sum = 0;
  for (auto v = set.volumes_begin(); v != set.volumes_end(); ++v) {
    if (!v->mark()) continue;
    CGAL::Polyhedron_3<Kernel> piece;
    set.convert_inner_shell_to_polyhedron(v->shells_begin(), piece);
    PeerMesh mesh;
    CGAL::copy_face_graph(piece, mesh);
    CGAL::Polygon_mesh_processing::triangulate_faces(mesh);
    sum += CGAL::to_double(CGAL::Polygon_mesh_processing::volume(mesh));
  }
  return sum;
}

struct Solid {
  std::string name;
  PolygonMesh mesh;
};

Solid solid_of_file(const std::string& file) {
  Context context;
  return {file, read_mesh_file(file, {}, {}, context).mesh};
}
Solid comb(int teeth) {
  return {fmt::format("block with {} + {} notches", teeth, teeth),
          testing::comb_block(teeth, teeth)};
}

Solid saddle(int notches) {
  return {fmt::format("block with {} + {} notches along a saddle", notches, notches),
          testing::saddle_block(notches)};
}

void compare_walls(PeerReport& report, const Solid& solid, int rounds) {
  const Nef3 set = testing::solid(solid.mesh);
  const PeerSet peer = peer_set(solid.mesh);
  ConvexPieces pieces;
  report.compare(
      {"convex pieces by walls", solid.name, "CGAL convex_decomposition_3", "volume", 1e-9, rounds},
      [&] {
        pieces = {};  // those of the last round, untimed
        return timed_run(
            [&] {
              Context context;
              pieces = decompose_by_walls(set, {DecomposeMethod::Walls, false}, context);
            },
            [&] {
              Rational volume = 0;
              for (const Nef3& piece : pieces.pieces) {
                volume += *marked_volume(piece.complex());
              }
              return volume.convert_to<double>();
            });
      },
      [&] {
        PeerSet copy = peer;
        return timed_run([&] { CGAL::convex_decomposition_3(copy); },
                         [&] { return volume_of_pieces(copy); });
      });
}

void compare_sums(PeerReport& report, const Solid& a, const Solid& b, int rounds) {
  const Nef3 own_a = testing::solid(a.mesh), own_b = testing::solid(b.mesh);
  const PeerSet peer_a = peer_set(a.mesh), peer_b = peer_set(b.mesh);
  report.compare(
      {"Minkowski sum", a.name + " + " + b.name, "CGAL minkowski_sum_3", "volume", 1e-9, rounds},
      [&] {
        Nef3 sum;
        return timed_run(
            [&] {
              Context context;
              sum = minkowski_sum(own_a, own_b, context);
            },
            [&] { return marked_volume(sum.complex())->convert_to<double>(); });
      },
      [&] {
        PeerSet first = peer_a, second = peer_b, sum;
        return timed_run([&] { sum = CGAL::minkowski_sum_3(first, second); },
                         [&] { return peer_volume(sum); });
      });
}

}  // namespace
}  // namespace plumb::bench

int main(int argc, char** argv) {
  using namespace plumb::bench;
  CLI::App app("Convex decomposition and Minkowski sums against CGAL");
  std::vector<std::string> walls, sums;
  PeerOptions options;
  options.add_to(app);
  options.add_most_to(app);
  app.add_option("--walls", walls, "OFF files to decompose");
  app.add_option("--sums", sums, "two OFF files to add")->expected(2);
  CLI11_PARSE(app, argc, argv);
  PeerReport report("Convex pieces and Minkowski sums beside CGAL");
  report.use("CGAL", CGAL_VERSION_STR);
  for (const std::string& file : walls) compare_walls(report, solid_of_file(file), options.rounds);
  if (!sums.empty()) {
    compare_sums(report, solid_of_file(sums[0]), solid_of_file(sums[1]), options.rounds);
  }
  if (walls.empty() && sums.empty()) {
    const Solid l = solid_of_file("corpus/solids/l-block.off");
    compare_walls(report, l, options.rounds);
    for (const auto& [teeth, least] : {std::pair{8, 2}, {24, 3}}) {
      compare_walls(report, comb(std::max(least, static_cast<int>(teeth * options.most / 100))),
                    options.rounds);
    }
    compare_walls(report, saddle(std::max(2, static_cast<int>(8 * options.most / 100))),
                  options.rounds);
    compare_sums(report, l, l, options.rounds);
    compare_sums(report, comb(2), l, options.rounds);
  }
  return report.finish(options.json);
}
