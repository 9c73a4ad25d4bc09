// How the time of convexity tests and convex decomposition grows, family by family.
//
//   convex_families [--most N] [--slack X]
//
// prints the time at every size and the fitted exponent; exits 1 if one is above its limit by more than the slack.
// --most: percent of the full sizes (default 100).
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "cpu_time.h"
#include "generate/meshes.h"
#include "generate/voxel_mesh.h"
#include "plumb/convex/convexity.h"
#include "plumb/convex/decompose.h"
#include "power_fit.h"

namespace plumb::bench {
namespace {

Nef3 solid(const PolygonMesh& mesh) {
  Context context;
  return Nef3::mesh(mesh, WindingRule::Positive, context);
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

double seconds_to_decompose(const Nef3& set) {
  return least_seconds([&] {
    Context context;
    const double start = cpu_seconds();
    decompose(set, {}, context);
    return cpu_seconds() - start;
  });
}

double stars(int size) { return seconds_to_decompose(solid(testing::star_prism(size))); }
double combs(int size) { return seconds_to_decompose(solid(testing::comb_block(size, size))); }
double discs(int size) { return seconds_to_decompose(solid(notched_disc(size))); }

/// A prism over n corners, and pyramids on both of its ends: quads, and two vertices beside n faces each.
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

double seconds_to_test(const PolygonMesh& mesh) {
  return least_seconds([&] {
    Context context;
    const double start = cpu_seconds();
    is_convex_mesh(mesh, context);
    return cpu_seconds() - start;
  });
}
double spheres(int depth) { return seconds_to_test(testing::icosphere_mesh(depth, 1, {0, 0, 0})); }
double pencils(int size) { return seconds_to_test(pencil(size)); }

struct Family {
  const char* name;
  const char* unit;
  std::vector<int> sizes;
  double (*seconds)(int);
  double (*count)(int);  ///< what the exponent is of
  double limit;
};

const std::vector<Family> kFamilies{
    {"stars", "reflex edges", {64, 128, 256, 512, 1024}, stars, [](int n) { return 1.0 * n; }, 1.2},
    {"combs", "reflex edges", {4, 8, 16, 32}, combs, [](int n) { return 2.0 * n; }, 2.1},
    {"one notch",
     "corners",
     {125, 250, 500, 1000, 2000},
     discs,
     [](int n) { return 1.0 * n; },
     1.1},
    {"convexity of spheres",
     "triangles",
     {4, 5, 6, 7},
     spheres,
     [](int depth) { return 20 * std::pow(4.0, depth); },
     1.1},
    {"convexity of pencils",
     "corners",
     {1000, 4000, 16000, 64000},
     pencils,
     [](int n) { return 1.0 * n; },
     1.1},
};

bool measure(const Family& family, double most, double slack) {
  fmt::print("{}\n", family.name);
  const auto wanted =
      static_cast<std::size_t>(std::ceil(static_cast<double>(family.sizes.size()) * most / 100));
  std::vector<Sample> samples;
  for (std::size_t i = 0; i < std::max<std::size_t>(3, wanted); ++i) {
    const double count = family.count(family.sizes[i]), seconds = family.seconds(family.sizes[i]);
    samples.push_back({count, seconds});
    fmt::print("  {:9.0f} {}  {:.6f} s\n", count, family.unit, seconds);
  }
  const PowerFit fit = fit_power(samples);
  const bool is_within = fit.slope <= family.limit + slack;
  fmt::print("  exponent {:.3f} +- {:.3f}, limit {}{}\n", fit.slope, fit.half_width, family.limit,
             is_within ? "" : ": EXCEEDED");
  return is_within;
}

}  // namespace
}  // namespace plumb::bench

int main(int argc, char** argv) {
  CLI::App app{"Growth of convexity tests and convex decomposition"};
  double most = 100, slack = 0;
  app.add_option("--most", most, "percent of the full sizes (default 100)");
  app.add_option("--slack", slack, "how far above its limit an exponent may be");
  CLI11_PARSE(app, argc, argv);
  using namespace plumb::bench;
  bool is_within = true;
  for (const Family& family : kFamilies) is_within &= measure(family, most, slack);
  return is_within ? 0 : 1;
}
