// The same tuples through CGAL's Exact_predicates_inexact_constructions_kernel and through plumb,
// paired in one run. plumb's own naive expressions are in bench/micro/predicates_bench.
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include "../micro/naive_predicates.h"
#include "../micro/predicate_data.h"
#include "../micro/predicates_bench.h"
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

#define PLUMB_LIFT(f) [](const auto&... p) { return f(p...); }

/// naive, plumb and EPICK on the same tuples, one after the other.
template <class Data, class Naive, class Ours, class Theirs>
void trio(const std::string& name, Family f, const Data& data, Naive naive, Ours ours,
          Theirs theirs) {
  measure(name + "/naive", f, data, naive);
  measure(name + "/plumb", f, data, ours);
  measure(name + "/epick", f, convert_all(data), theirs);
}

bool register_all() {
  for (const Family f : {Family::Random, Family::Near, Family::Degenerate}) {
    PredicateData data;
    trio("orient2d", f, data.orient2d(f), PLUMB_LIFT(naive_orient2d), PLUMB_LIFT(orient2d),
         PLUMB_LIFT(CGAL::orientation));
    trio("orient3d", f, data.orient3d(f), PLUMB_LIFT(naive_orient3d), PLUMB_LIFT(orient3d),
         PLUMB_LIFT(CGAL::orientation));
    trio("incircle", f, data.incircle(f), PLUMB_LIFT(naive_incircle), PLUMB_LIFT(incircle),
         PLUMB_LIFT(CGAL::side_of_oriented_circle));
    trio("insphere", f, data.insphere(f), PLUMB_LIFT(naive_insphere), PLUMB_LIFT(insphere),
         PLUMB_LIFT(CGAL::side_of_oriented_sphere));
  }
  return true;
}

const bool registered = register_all();

}  // namespace
}  // namespace plumb::bench
