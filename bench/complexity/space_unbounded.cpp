// What sets that reach to infinity cost: unions and intersections of sets with unbounded facets
// against those of the same sets clipped to a box.
//
//   space_unbounded [--size N] [--limit X] [--json FILE]
//
// prints CPU seconds of both and their ratio for each family; exits 1 if a ratio is above the limit
// (default 10).
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "../report/report.h"
#include "cpu_time.h"
#include "generate/meshes.h"
#include "plumb/space/nef3.h"
#include "plumb/testing/dice.h"

namespace plumb::bench {
namespace {

using testing::Dice;

/// Where every family has its vertices.
constexpr double kClip = 4096;

Nef3 below(std::int64_t a, std::int64_t b, std::int64_t c, std::int64_t d) {
  return Nef3::half_space({a, b, c, d}, Boundary::Closed);
}

/// About tangent to a sphere of radius 256, their normals anywhere.
std::vector<Nef3> half_spaces(std::size_t n) {
  Dice dice(1);
  std::vector<Nef3> sets;
  while (sets.size() < n) {
    const std::int64_t a = dice.between(-9, 9);
    const std::int64_t b = dice.between(-9, 9);
    const std::int64_t c = dice.between(-9, 9);
    const double length = std::sqrt(static_cast<double>(a * a + b * b + c * c));
    if (length > 3) sets.push_back(below(a, b, c, -static_cast<std::int64_t>(256 * length)));
  }
  return sets;
}

/// Square columns in the directions of x and y in turn, n in a plane.
std::vector<Nef3> columns(std::size_t n) {
  std::vector<Nef3> sets;
  for (std::size_t i = 0; i < n; ++i) {
    const auto at = static_cast<std::int64_t>(3 * i);
    const Nef3 along_x = below(0, -1, 0, at) * below(0, 1, 0, -at - 2);
    const Nef3 along_y = below(-1, 0, 0, at) * below(1, 0, 0, -at - 2);
    const Nef3 flat = below(0, 0, -1, 0) * below(0, 0, 1, -2);
    const Nef3 higher = below(0, 0, -1, 1) * below(0, 0, 1, -3);
    sets.push_back(i % 2 == 0 ? along_x * flat : along_y * higher);
  }
  return sets;
}

/// Octants turned and moved, their apexes near the origin.
std::vector<Nef3> corners(std::size_t n) {
  Dice dice(2);
  std::vector<Nef3> sets;
  while (sets.size() < n) {
    Nef3 corner = Nef3::whole();
    for (int side = 0; side < 3; ++side) {
      const std::int64_t a = dice.between(-5, 5) + (side == 0 ? 12 : 0);
      const std::int64_t b = dice.between(-5, 5) + (side == 1 ? 12 : 0);
      const std::int64_t c = dice.between(-5, 5) + (side == 2 ? 12 : 0);
      corner *= below(a, b, c, dice.between(-99, 99));
    }
    sets.push_back(corner);
  }
  return sets;
}

/// Slabs with a sphere of triangles cut out of each.
std::vector<Nef3> pierced_slabs(std::size_t n) {
  std::vector<Nef3> sets;
  for (std::size_t i = 0; i < n; ++i) {
    Context context;
    const auto at = static_cast<std::int64_t>(i);
    const Point3 centre{static_cast<double>(5 * i), 0.5, 1.5};
    const Nef3 ball = Nef3::from_mesh(testing::icosphere_mesh(2, 2, centre),
                                      {.rule = WindingRule::Positive}, context);
    sets.push_back(below(-1, 0, -3, 0) * below(1, 0, 3, -20 - at) - ball);
  }
  return sets;
}

struct Fold {
  const char* name;
  MarkFunction f;
};
constexpr Fold kFolds[] = {{"union", kUnion}, {"intersection", kIntersection}};

double seconds(const std::vector<Nef3>& sets, MarkFunction f) {
  return least_seconds([&] {
    Context context;
    const double start = cpu_seconds();
    Nef3 result = sets.front();
    for (std::size_t i = 1; i < sets.size(); ++i) result = boolean_op(result, sets[i], f, context);
    return cpu_seconds() - start;
  });
}

bool measure(const std::string& name, const std::vector<Nef3>& sets, double limit,
             nlohmann::ordered_json& rows) {
  Context context;
  const Nef3 box =
      Nef3::from_mesh(testing::box_mesh({-kClip, -kClip, -kClip}, {kClip, kClip, kClip}),
                      {.rule = WindingRule::Positive}, context);
  std::vector<Nef3> clipped;
  for (const Nef3& set : sets) clipped.push_back(set * box);
  bool is_within = true;
  for (const Fold& fold : kFolds) {
    const double open = seconds(sets, fold.f);
    const double closed = seconds(clipped, fold.f);
    fmt::print("{:28} n={:<4} {:12}  unbounded {:8.4f} s  in a box {:8.4f} s  ratio {:.2f}\n", name,
               sets.size(), fold.name, open, closed, open / closed);
    const bool is_row_within = open <= limit * closed;
    is_within &= is_row_within;
    rows.push_back({{"family", name},
                    {"sets", sets.size()},
                    {"fold", fold.name},
                    {"unbounded", open},
                    {"in_a_box", closed},
                    {"within", is_row_within}});
  }
  return is_within;
}

}  // namespace
}  // namespace plumb::bench

int main(int argc, char** argv) {
  CLI::App app{"The cost of sets that reach to infinity"};
  std::size_t size = 24;
  double limit = 10;
  std::string json;
  app.add_option("--size", size, "sets in each family (default 24)");
  app.add_option("--limit", limit, "most an unbounded set may cost beside the clipped one");
  app.add_option("--json", json, "write the rows there");
  CLI11_PARSE(app, argc, argv);
  using namespace plumb::bench;
  nlohmann::ordered_json rows = nlohmann::ordered_json::array();
  bool is_within = measure("half-spaces around a sphere", half_spaces(size), limit, rows);
  is_within &= measure("columns along x and y", columns(size), limit, rows);
  is_within &= measure("octants, turned", corners(size), limit, rows);
  is_within &= measure("slabs with a ball cut out", pierced_slabs(size), limit, rows);
  return write_json(json, {{"part", "unbounded"}, {"title", "Unbounded sets"}, {"rows", rows}},
                    is_within ? 0 : 1);
}
