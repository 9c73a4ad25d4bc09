// Predicates on input doubles beside CGAL's Exact_predicates_inexact_constructions_kernel: the same
// tuples, in turn. (plumb's own naive expressions: bench/micro/predicates_bench.)
//
//   predicates_peer [--rounds N] [--json FILE]
//
// Seconds are those of all 4096 tuples, the mean of a hundred passes; the answer is the sum of i
// times the i-th sign.
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <string>
#include <tuple>
#include <vector>

#include "../micro/predicate_data.h"
#include "peer_report.h"
#include "plumb/predicates/input_predicates.h"

namespace plumb::bench {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

Kernel::Point_2 convert(const Point2& p) { return {p.x, p.y}; }
Kernel::Point_3 convert(const Point3& p) { return {p.x, p.y, p.z}; }

template <class Point, std::size_t N>
auto convert_all(const Tuples<Point, N>& data) {
  std::vector<std::array<decltype(convert(Point{})), N>> r;
  for (const auto& tuple : data) {
    r.push_back(std::apply([](const auto&... p) { return std::array{convert(p)...}; }, tuple));
  }
  return r;
}

// CGAL's signs of tetrahedra and spheres are the other way round: two corners swapped.
constexpr auto kOrientation3 = [](const auto& a, const auto& b, const auto& c, const auto& d) {
  return CGAL::orientation(b, a, c, d);
};
constexpr auto kSphereSide = [](const auto& a, const auto& b, const auto& c, const auto& d,
                                const auto& e) {
  return CGAL::side_of_oriented_sphere(b, a, c, d, e);
};

#define PLUMB_LIFT(f) [](const auto&... p) { return f(p...); }

template <class Data, class Predicate>
PeerRun run_all(const Data& data, Predicate predicate) {
  constexpr int kPasses = 100;
  double sum = 0;
  PeerRun all = timed_run(
      [&] {
        for (int pass = 0; pass < kPasses; ++pass) {
          sum = 0;
          double place = 0;
          for (const auto& tuple : data) {
            sum += ++place * static_cast<double>(static_cast<int>(std::apply(predicate, tuple)));
          }
        }
      },
      [&] { return sum; });
  all.seconds /= kPasses;
  return all;
}

struct Session {
  PeerReport& report;
  Family family;
  int rounds;

  template <class Data, class Ours, class Theirs>
  void compare(const std::string& name, const Data& data, Ours ours, Theirs theirs) const {
    static constexpr const char* kNames[] = {"random", "near", "degenerate"};
    const auto converted = convert_all(data);
    report.compare(
        {name, fmt::format("{} tuples, {}", data.size(), kNames[static_cast<int>(family)]),
         "CGAL EPICK", "sum of signs by place", 0, rounds},
        [&] { return run_all(data, ours); }, [&] { return run_all(converted, theirs); });
  }
};

}  // namespace
}  // namespace plumb::bench

int main(int argc, char** argv) {
  using namespace plumb::bench;
  CLI::App app{"Predicates beside CGAL's"};
  PeerOptions options;
  options.rounds = 5;
  options.add_to(app);
  CLI11_PARSE(app, argc, argv);
  PeerReport report("Predicates beside CGAL's");
  report.use("CGAL", CGAL_VERSION_STR);
  for (const Family f : {Family::Random, Family::Near, Family::Degenerate}) {
    PredicateData data;
    const Session session{report, f, options.rounds};
    session.compare("orient2d", data.orient2d(f), PLUMB_LIFT(plumb::orient2d),
                    PLUMB_LIFT(CGAL::orientation));
    session.compare("orient3d", data.orient3d(f), PLUMB_LIFT(plumb::orient3d), kOrientation3);
    session.compare("incircle", data.incircle(f), PLUMB_LIFT(plumb::incircle),
                    PLUMB_LIFT(CGAL::side_of_oriented_circle));
    session.compare("insphere", data.insphere(f), PLUMB_LIFT(plumb::insphere), kSphereSide);
  }
  return report.finish(options.json);
}
