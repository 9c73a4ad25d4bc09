// How convexity tests and convex decomposition grow, family by family (growth.h says how it is
// measured).
#include <array>
#include <cmath>
#include <cstdint>
#include <memory>
#include <stdexcept>
#include <utility>
#include <vector>

#include "generate/meshes.h"
#include "generate/voxel_mesh.h"
#include "growth.h"
#include "plumb/convex/convexity.h"
#include "plumb/convex/decompose.h"

namespace plumb::bench {
namespace {

Nef3 solid(const PolygonMesh& mesh) {
  Context context;
  return Nef3::from_mesh(mesh, {.rule = WindingRule::Positive}, context);
}

/// A disc of n corners with one notch: a single reflex edge.
PolygonMesh notched_disc(int n) {
  std::vector<Point2> polygon{{0, 0}};
  for (int i = 1; i < n; ++i) {
    const double angle = 6.0 * i / n;
    polygon.push_back({std::cos(angle), std::sin(angle)});
  }
  return testing::prism_mesh(polygon, 0, 1);
}

Work decomposition(double size, const PolygonMesh& mesh) {
  return measured(size, [set = solid(mesh)] {
    Context context;
    return decompose(set, {}, context);
  });
}
Work stars(std::size_t tips) {
  return decomposition(static_cast<double>(tips), testing::star_prism(static_cast<int>(tips)));
}
Work combs(std::size_t teeth) {
  const int n = static_cast<int>(teeth);
  return decomposition(2.0 * n, testing::comb_block(n, n));
}
Work discs(std::size_t corners) {
  return decomposition(static_cast<double>(corners), notched_disc(static_cast<int>(corners)));
}

/// Reflex edges are pairwise askew: a piece for each pair, and a few more.
Work saddles(std::size_t notches) {
  const int n = static_cast<int>(notches);
  const Nef3 set = solid(testing::saddle_block(n));
  Context context;
  const std::size_t pieces = decompose(set, {}, context).pieces.size();
  if (pieces > (notches + 1) * (notches + 1)) throw std::runtime_error("too many pieces");
  return measured(2.0 * n, [set] {
    Context own;
    return decompose(set, {}, own);
  });
}

/// A prism over n corners, and pyramids on both of its ends: quads, and two vertices beside n faces
/// each.
PolygonMesh pencil(int n) {
  PolygonMesh mesh;
  const auto at = [n](int i, int k) { return static_cast<std::uint32_t>(2 * (i % n) + k); };
  for (int i = 0; i < n; ++i) {
    const double angle = 6.283185307179586 * i / n;
    for (const double z : {0.0, 1.0}) mesh.points.push_back({std::cos(angle), std::sin(angle), z});
  }
  const auto low = static_cast<std::uint32_t>(2 * n), high = low + 1;
  mesh.points.push_back({0, 0, -1});
  mesh.points.push_back({0, 0, 2});
  for (int i = 0; i < n; ++i) {
    mesh.add_face(std::array{at(i, 0), at(i + 1, 0), at(i + 1, 1), at(i, 1)});
    mesh.add_face(std::array{at(i + 1, 0), at(i, 0), low});
    mesh.add_face(std::array{at(i, 1), at(i + 1, 1), high});
  }
  return mesh;
}

/// The same with a step at its side: one reflex edge, and a plane through it meets a share of all
/// faces.
Work stepped_pencils(std::size_t corners) {
  const Nef3 set = solid(pencil(static_cast<int>(corners))) -
                   solid(testing::box_mesh({0.75, -2, 0.5}, {2, 2, 3}));
  return measured(static_cast<double>(set.counts().edges), [set] {
    Context context;
    return decompose(set, {DecomposeMethod::Cuts, false}, context);
  });
}

Work test_of(PolygonMesh mesh) {
  const auto size = static_cast<double>(mesh.face_count());
  return measured(size, [mesh = std::make_shared<const PolygonMesh>(std::move(mesh))] {
    Context context;
    return is_convex_mesh(*mesh, context);
  });
}
Work spheres(std::size_t depth) {
  return test_of(testing::icosphere_mesh(static_cast<int>(depth), 1, {0, 0, 0}));
}
Work pencils(std::size_t corners) { return test_of(pencil(static_cast<int>(corners))); }

const std::vector<Family> kFamilies{
    {"stars",
     "convex decomposition, reflex edges far apart",
     "reflex edges",
     {1, 1},
     {10, 25, 64, 160, 400, 1024},
     stars,
     1.2},
    {"combs",
     "convex decomposition, O(r^2) pieces in the note on decomposition",
     "reflex edges",
     {2, 0},
     {2, 4, 8, 16, 32, 64, 128, 200},
     combs,
     2.1},
    {"saddles",
     "the same, reflex edges along the lines of a saddle: so many pieces are needed",
     "reflex edges",
     {2, 1},
     {1, 2, 4, 10, 25, 64, 100},
     saddles,
     2.1},
    {"one-notch",
     "convex decomposition, one reflex edge",
     "corners",
     {1, 1},
     {20, 50, 125, 320, 800, 2000},
     discs,
     1.1},
    {"stepped-pencils",
     "one cut; third vertex, facet of the cut, both sides: up to O(Sf F Vc^3 (Vp + Sc Sp))",
     "edges",
     {2, 0},
     {40, 100, 250, 640, 1600, 4200},
     stepped_pencils},
    {"convexity-of-spheres",
     "convexity, O(F V) in the note on cutting",
     "faces",
     {1, 0},
     {2, 3, 4, 5, 6, 7},
     spheres,
     1.1},
    {"convexity-of-pencils",
     "the same, two vertices beside every third face",
     "faces",
     {1, 0},
     {640, 1600, 4000, 10000, 25000, 64000},
     pencils,
     1.1},
};

}  // namespace
}  // namespace plumb::bench

int main(int argc, char** argv) {
  return plumb::bench::growth_main("Growth of convexity tests and convex decomposition",
                                   plumb::bench::kFamilies, argc, argv);
}
