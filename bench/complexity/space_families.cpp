// How the time of operations on sets of space grows, family by family, and the length of numbers in a chain.
//
//   space_families [--most N] [--slack X]
//
// prints the time at every size and the fitted exponent; exits 1 if one is above its limit by more than the slack.
// --most bounds the sizes (default 100: percent of the full ones).
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "cpu_time.h"
#include "generate/dice.h"
#include "generate/mesh_solid.h"
#include "generate/meshes.h"
#include "generate/voxel_mesh.h"
#include "plumb/space/nef3.h"
#include "power_fit.h"

namespace plumb::bench {
namespace {

using testing::Dice;
using testing::solid;

/// Unit cubes two apart, size^3 of them.
std::vector<Nef3> separated_cubes(std::size_t size) {
  std::vector<Nef3> sets;
  for (std::size_t i = 0; i < size * size * size; ++i) {
    const Point3 low{2.0 * static_cast<double>(i % size),
                     2.0 * static_cast<double>(i / size % size),
                     2.0 * static_cast<double>(i / size / size)};
    sets.push_back(solid(testing::box_mesh(low, {low.x + 1, low.y + 1, low.z + 1})));
  }
  return sets;
}

/// n thin tetrahedra along a diagonal, so that the boxes of all overlap.
Nef3 needles(std::size_t n, double shift) {
  PolygonMesh mesh;
  const double far = 64;
  for (std::size_t i = 0; i < n; ++i) {
    const double x = static_cast<double>(i % 32) * 4 + shift;
    const double y = static_cast<double>(i / 32) * 4 + shift;
    const auto first = static_cast<std::uint32_t>(mesh.points.size());
    mesh.points.push_back({x, -x + y, y});
    mesh.points.push_back({x + 1, -x + y, y});
    mesh.points.push_back({x, -x + y + 1, y});
    mesh.points.push_back({x + far * 16, -x + y + far * 16, y + far * 16});
    for (const auto& [a, b, c] :
         {std::array<std::uint32_t, 3>{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}) {
      mesh.add_face(std::array{first + a, first + b, first + c});
    }
  }
  return solid(mesh);
}

/// Tangent planes of a sphere, their normals anywhere.
std::vector<HalfSpace3> tangent_planes(std::size_t n) {
  Dice dice(1);
  std::vector<HalfSpace3> result;
  while (result.size() < n) {
    const std::int64_t a = dice.between(-1000000, 1000000);
    const std::int64_t b = dice.between(-1000000, 1000000);
    const std::int64_t c = dice.between(-1000000, 1000000);
    const double length = std::sqrt(static_cast<double>(a * a + b * b + c * c));
    if (length < 100000 || length > 1000000) continue;
    result.push_back({{a, b, c, -static_cast<std::int64_t>(256 * length)}, Boundary::Closed});
  }
  return result;
}

/// Square columns, a width apart, through the plate that they leave holes in.
PolygonMesh columns(std::size_t size) {
  PolygonMesh mesh;
  for (std::size_t i = 0; i < size * size; ++i) {
    const double x = 2 * static_cast<double>(i % size) + 1;
    const double y = 2 * static_cast<double>(i / size) + 1;
    mesh = testing::joined(std::move(mesh), testing::box_mesh({x, y, -1}, {x + 1, y + 1, 2}));
  }
  return mesh;
}

struct Family {
  const char* name;
  double limit;
  std::vector<std::size_t> sizes;
  Sample (*run)(std::size_t size);
};

/// What `make` takes to make a set; to destroy it is not counted.
template <class Make>
Sample sample_of(std::size_t size, Make make) {
  return {static_cast<double>(size), least_seconds([&] {
            Context context;
            const double start = cpu_seconds();
            const Nef3 made = make(context);
            return cpu_seconds() - start;
          })};
}

Sample run_united_grid(std::size_t size) {
  const std::vector<Nef3> cubes = separated_cubes(size);
  return sample_of(cubes.size(), [&](Context& context) { return union_of(cubes, context); });
}

Sample run_grown_grid(std::size_t size) {
  const std::vector<Nef3> cubes = separated_cubes(size);
  return sample_of(cubes.size(), [&](Context& context) {
    Nef3 all;
    for (const Nef3& cube : cubes) all = combine(std::move(all), cube, kUnion, context);
    return all;
  });
}

Sample run_needles(std::size_t n) {
  const Nef3 a = needles(n, 0), b = needles(n, 2);
  return sample_of(n, [&](Context& context) { return combine(a, b, kUnion, context); });
}

Sample run_half_spaces(std::size_t n) {
  const std::vector<HalfSpace3> planes = tangent_planes(n);
  return sample_of(n, [&](Context& context) { return Nef3::intersection(planes, context); });
}

std::vector<Nef3> half_spaces(std::size_t n) {
  std::vector<Nef3> sets;
  for (const HalfSpace3& h : tangent_planes(n))
    sets.push_back(Nef3::half_space(h.plane, h.boundary));
  return sets;
}

Sample run_half_space_chain(std::size_t n) {
  const std::vector<Nef3> sets = half_spaces(n);
  return sample_of(n, [&](Context& context) {
    Nef3 all = Nef3::space();
    for (const Nef3& set : sets) all = combine(std::move(all), set, kIntersection, context);
    return all;
  });
}

/// Any three of the planes meet in a vertex of the result: n^3 / 6 of them, however it is computed.
Sample run_half_space_parity(std::size_t n) {
  const std::vector<Nef3> sets = half_spaces(n);
  return sample_of(n, [&](Context& context) {
    std::vector<Nef3> level = sets;
    while (level.size() > 1) {
      std::vector<Nef3> pairs;
      for (std::size_t i = 0; i + 1 < level.size(); i += 2) {
        pairs.push_back(combine(level[i], level[i + 1], kSymmetricDifference, context));
      }
      if (level.size() % 2 == 1) pairs.push_back(level.back());
      level = std::move(pairs);
    }
    return std::move(level.front());
  });
}

/// Of each of the two.
Sample run_complement_interior(std::size_t depth) {
  const Nef3 ball = solid(testing::icosphere_mesh(static_cast<int>(depth), 1, {0, 0, 0}));
  const SpaceCounts counts = ball.counts();
  Sample sample = sample_of(counts.vertices + counts.edges + counts.facets,
                            [&](Context&) { return (!ball).interior(); });
  sample.seconds /= 2;
  return sample;
}

/// Two facets with all holes, and as many facets in these.
Sample run_columns_and_slab(std::size_t size) {
  const double side = 2 * static_cast<double>(size) + 1;
  const Nef3 slab = solid(testing::box_mesh({0, 0, 0}, {side, side, 1})),
             all = solid(columns(size));
  return sample_of(size * size, [&](Context& context) {
    return combine(slab, all, kSymmetricDifference, context);
  });
}

/// Every corner of one plate is looked for in a large facet of the other.
Sample run_plates(std::size_t size) {
  const PolygonMesh mesh = testing::voxel_mesh(testing::pierced_plate(static_cast<int>(size)));
  const Nef3 plate = solid(mesh), other = solid(testing::moved(mesh, {0.5, 0.25, 0}));
  return sample_of(size * size,
                   [&](Context& context) { return combine(plate, other, kUnion, context); });
}

/// Two facets with all corners, and thin walls in all directions.
Sample run_star_mesh(std::size_t tips) {
  const PolygonMesh mesh = testing::star_prism(static_cast<int>(tips));
  return sample_of(
      tips, [&](Context& context) { return Nef3::mesh(mesh, WindingRule::Positive, context); });
}

const std::vector<Family> kFamilies{
    {"separated cubes, union_of", 1.2, {5, 6, 7, 8, 9, 10}, run_united_grid},
    {"separated cubes, one by one", 1.6, {4, 5, 6, 7, 8}, run_grown_grid},
    {"needles, union of two sets", 1.3, {128, 256, 512, 1024, 2048}, run_needles},
    {"tangent half-spaces, intersection()", 1.3, {256, 1024, 4096, 16384}, run_half_spaces},
    {"tangent half-spaces, one by one", 2.2, {16, 32, 64, 128}, run_half_space_chain},
    {"half-spaces, symmetric difference", 3.3, {8, 12, 16, 24, 32, 48}, run_half_space_parity},
    {"columns through a slab, parity", 1.25, {8, 12, 16, 24, 32, 48, 64}, run_columns_and_slab},
    {"pierced plates, union of two", 1.25, {8, 12, 16, 24, 32, 48}, run_plates},
    {"stars with n tips, from a mesh", 1.25, {500, 1000, 2000, 4000, 8000, 16000}, run_star_mesh},
    {"complement, interior (items)", 1.15, {3, 4, 5, 6}, run_complement_interior},
};

/// The largest coefficient of a plane of the set, in bits.
std::size_t most_bits(const Nef3& set) {
  std::size_t most = 0;
  const SpaceComplex& c = set.complex();
  for (const PlaneId p : c.facet_plane) {
    for (const Integer& x : c.planes().primitive(p)) {
      if (x != 0) most = std::max<std::size_t>(most, msb(abs(x)) + 1);
    }
  }
  return most;
}

/// A drill moves through a block: each step by what it costs for each facet of its result.
bool measure_drill(std::size_t steps, double limit) {
  Context context;
  Nef3 block = solid(testing::box_mesh({0, 0, 0}, {1000, 100, 100}));
  std::vector<Sample> samples;
  std::size_t most = 0;
  double sum = 0, items = 0;
  for (std::size_t i = 0; i < steps; ++i) {
    const double x = 3.25 + 4.75 * static_cast<double>(i);
    const Nef3 drill = solid(testing::icosphere_mesh(2, 7, {x, 50.5, 97.25}));
    const double start = cpu_seconds();
    block = combine(std::move(block), drill, kDifference, context);
    sum += cpu_seconds() - start;
    items += static_cast<double>(block.complex().facet_count());
    most = std::max(most, most_bits(block));
    if ((i + 1) % (steps / 5) == 0) samples.push_back({items, sum});
  }
  const PowerFit fit = fit_power(samples);
  fmt::print(
      "drill, {} subtractions: {:.3f} s, {:.0f} facets written, numbers of {} bits at most\n",
      steps, sum, items, most);
  fmt::print("    time ~ facets written ^ {:.3f} +- {:.3f}   (limit {:.2f})\n", fit.slope,
             fit.half_width, limit);
  return fit.slope <= limit;
}

bool measure(const Family& family, double percent, double slack) {
  std::vector<Sample> samples;
  for (const std::size_t size : family.sizes) {
    const bool is_small = samples.size() < 3;
    const double share = static_cast<double>(size) / static_cast<double>(family.sizes.back());
    if (is_small || share * 100 <= percent) samples.push_back(family.run(size));
  }
  for (const Sample& s : samples) {
    fmt::print("{:38} n={:<8.0f} {:10.5f} s {:10.1f} ns for each\n", family.name, s.size, s.seconds,
               s.seconds / s.size * 1e9);
  }
  const PowerFit fit = fit_power(samples);
  fmt::print("    time ~ n ^ {:.3f} +- {:.3f}   (limit {:.2f})\n", fit.slope, fit.half_width,
             family.limit);
  return fit.slope <= family.limit + slack;
}

}  // namespace
}  // namespace plumb::bench

int main(int argc, char** argv) {
  CLI::App app{"Growth of operations on sets of space"};
  double most = 100, slack = 0;
  std::string only;
  app.add_option("--most", most, "percent of the full sizes (default 100)");
  app.add_option("--slack", slack, "how far above its limit an exponent may be");
  app.add_option("--only", only, "families with this in their names");
  CLI11_PARSE(app, argc, argv);
  using namespace plumb::bench;
  bool is_within = true;
  for (const Family& family : kFamilies) {
    if (std::string(family.name).find(only) == std::string::npos) continue;
    is_within &= measure(family, most, slack);
  }
  if (std::string("drill").find(only) != std::string::npos) {
    is_within &= measure_drill(most < 100 ? 25 : 200, 1.15 + slack);
  }
  return is_within ? 0 : 1;
}
