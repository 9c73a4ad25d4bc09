// How the time of convexity tests and convex decomposition grows, family by family.
//
//   convex_families [--most N] [--slack X]
//
// prints the time at every size and the fitted exponent; exits 1 if one is above its limit by more than the slack.
// --most: percent of the full sizes (default 100).
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
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

double spheres(int depth) {
  const PolygonMesh mesh = testing::icosphere_mesh(depth, 1, {0, 0, 0});
  return least_seconds([&] {
    Context context;
    const double start = cpu_seconds();
    is_convex_mesh(mesh, context);
    return cpu_seconds() - start;
  });
}

struct Family {
  const char* name;
  const char* unit;
  std::vector<int> sizes;
  double (*seconds)(int);
  double (*count)(int);  ///< what the exponent is of
  double limit;
};

const std::vector<Family> kFamilies{
    {"stars", "reflex edges", {16, 32, 64, 128, 256}, stars, [](int n) { return 1.0 * n; }, 2.1},
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
