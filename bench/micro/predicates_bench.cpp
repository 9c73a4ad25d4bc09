// Predicates on input doubles against the naive expressions, on random, nearly degenerate and
// exactly degenerate input. Counters: CPU time a call, and the share of calls that each rung
// decides.
#include "predicates_bench.h"

#include <benchmark/benchmark.h>

#include "naive_predicates.h"
#include "plumb/predicates/input_predicates.h"
#include "predicate_data.h"

namespace plumb::bench {
namespace {

#define PLUMB_LIFT(f) [](const auto&... p) { return f(p...); }

bool register_all() {
  for (const Family f : {Family::Random, Family::Near, Family::Degenerate}) {
    PredicateData data;
    measure("orient2d/naive", f, data.orient2d(f), PLUMB_LIFT(naive_orient2d));
    measure("orient2d/plumb", f, data.orient2d(f), PLUMB_LIFT(orient2d),
            PLUMB_LIFT(rung::orient2d_filter), PLUMB_LIFT(rung::orient2d_small),
            PLUMB_LIFT(rung::orient2d_exact));
    measure("orient3d/naive", f, data.orient3d(f), PLUMB_LIFT(naive_orient3d));
    measure("orient3d/plumb", f, data.orient3d(f), PLUMB_LIFT(orient3d),
            PLUMB_LIFT(rung::orient3d_filter), PLUMB_LIFT(rung::orient3d_small),
            PLUMB_LIFT(rung::orient3d_exact));
    measure("incircle/naive", f, data.incircle(f), PLUMB_LIFT(naive_incircle));
    measure("incircle/plumb", f, data.incircle(f), PLUMB_LIFT(incircle),
            PLUMB_LIFT(rung::incircle_filter), PLUMB_LIFT(rung::incircle_small),
            PLUMB_LIFT(rung::incircle_exact));
    measure("insphere/naive", f, data.insphere(f), PLUMB_LIFT(naive_insphere));
    measure("insphere/plumb", f, data.insphere(f), PLUMB_LIFT(insphere),
            PLUMB_LIFT(rung::insphere_filter), PLUMB_LIFT(rung::insphere_small),
            PLUMB_LIFT(rung::insphere_exact));
  }
  return true;
}

const bool registered = register_all();

}  // namespace
}  // namespace plumb::bench
