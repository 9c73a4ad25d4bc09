// Every rung of every predicate on input doubles against the oracle, over the adversarial families,
// in all rounding modes with and without FTZ/DAZ.
//
// PLUMB_CASES sets the number of cases in all (default: a few seconds' worth). A case is one tuple
// of points: its sign by the oracle, once, and by the whole ladder and each rung in every mode.
#include "plumb/predicates/input_predicates.h"

#include <gtest/gtest.h>

#include <sstream>
#include <string>
#include <vector>

#include "float_environment.h"
#include "generate/test_share.h"
#include "predicate_cases.h"
#include "predicate_oracle.h"

namespace plumb::test::input_predicates_test {
namespace {

std::uint64_t total_cases() { return plumb::testing::case_count(60000); }

Point2 point(const std::array<double, 2>& p) { return {p[0], p[1]}; }
Point3 point(const std::array<double, 3>& p) { return {p[0], p[1], p[2]}; }

/// The answers of one predicate's rungs on one tuple.
struct Answers {
  Sign ladder;
  FilteredSign filter, small, exact;
  Sign big;
};

#define PLUMB_ANSWERS(name)                                                         \
  [](const auto&... p) {                                                            \
    return Answers{name(p...), rung::name##_filter(p...), rung::name##_small(p...), \
                   rung::name##_exact(p...), rung::name##_big(p...)};               \
  }

struct Counts {
  std::uint64_t cases = 0, zero = 0, filter = 0, small = 0, exact = 0;
};

bool agrees(FilteredSign s, Sign truth) { return !is_decided(s) || decided(s) == truth; }

bool all_right(const Answers& a, Sign truth) {
  return a.ladder == truth && a.big == truth && agrees(a.filter, truth) && agrees(a.small, truth) &&
         agrees(a.exact, truth);
}

template <std::size_t N, std::size_t D>
std::string describe(const Tuple<N, D>& t) {
  std::ostringstream out;
  out << std::hexfloat;
  for (const auto& p : t) {
    for (const double v : p) out << v << ' ';
  }
  return out.str();
}

/// Not inlined: the evaluation must not move out of the scope that sets the mode.
template <class Evaluate, std::size_t N, std::size_t D>
[[gnu::noinline]] Answers evaluate_in(const testing_environment::Setting& mode, Evaluate evaluate,
                                      const Tuple<N, D>& t) {
  const testing_environment::Scope scope(mode);
  return std::apply([&](const auto&... p) { return evaluate(point(p)...); }, t);
}

template <std::size_t N, std::size_t D, class Evaluate>
void check_tuple(Evaluate evaluate, const Tuple<N, D>& t, Counts& counts) {
  const auto truth = static_cast<Sign>(oracle_sign(t));
  const Answers first = evaluate_in(testing_environment::kSettings[0], evaluate, t);
  for (const testing_environment::Setting& mode : testing_environment::kSettings) {
    ASSERT_TRUE(all_right(evaluate_in(mode, evaluate, t), truth))
        << mode.name << ": " << describe(t);
  }
  ++counts.cases;
  counts.zero += truth == Sign::Zero;
  counts.filter += is_decided(first.filter);
  counts.small += is_decided(first.small);
  counts.exact += is_decided(first.exact);
}

template <std::size_t N, std::size_t D, class Evaluate>
void check_families(const char* name, Evaluate evaluate) {
  constexpr auto kFamilies = static_cast<std::uint64_t>(Family::kCount);
  const std::uint64_t each = total_cases() / (4 * kFamilies) + 1;
  Cases<N, D> cases(20240607);
  Counts counts;
  for (std::uint64_t f = 0; f < kFamilies; ++f) {
    for (std::uint64_t i = 0; i < each; ++i) {
      check_tuple<N, D>(evaluate, cases.make(static_cast<Family>(f)), counts);
      if (::testing::Test::HasFatalFailure()) return;
    }
  }
  // The families must reach every rung and many exact zeros, or they test nothing.
  EXPECT_GT(counts.zero, counts.cases / 10);
  EXPECT_GT(counts.filter, counts.cases / 20);
  EXPECT_GT(counts.small, counts.cases / 50);
  EXPECT_GT(counts.exact, counts.cases / 3);
  EXPECT_LT(counts.exact, counts.cases);
  std::cout << name << ": " << counts.cases << " cases x " << testing_environment::kSettings.size()
            << " modes, " << counts.zero << " zeros; decidable by filter " << counts.filter
            << ", small " << counts.small << ", exact " << counts.exact << '\n';
}

TEST(InputPredicates, Orient2dIsRight) {
  check_families<3, 2>("orient2d", PLUMB_ANSWERS(orient2d));
}
TEST(InputPredicates, Orient3dIsRight) {
  check_families<4, 3>("orient3d", PLUMB_ANSWERS(orient3d));
}
TEST(InputPredicates, IncircleIsRight) {
  check_families<4, 2>("incircle", PLUMB_ANSWERS(incircle));
}
TEST(InputPredicates, InsphereIsRight) {
  check_families<5, 3>("insphere", PLUMB_ANSWERS(insphere));
}

/// cross_sign of four points is orient2d of translated ones only without rounding: its own oracle.
TEST(InputPredicates, CrossSignIsRight) {
  Cases<3, 2> cases(7);
  for (std::uint64_t i = 0; i < total_cases() / 10; ++i) {
    const auto family = static_cast<Family>(i % static_cast<std::uint64_t>(Family::kCount));
    const Tuple<3, 2> s = cases.make(family), t = cases.make(family);
    const Tuple<4, 2> four = {s[0], s[1], i % 3 == 0 ? s[2] : t[0], t[1]};
    int unit = 2000;
    for (const auto& p : four) unit = std::min({unit, unit_exponent(p[0]), unit_exponent(p[1])});
    const auto side = [&](std::size_t to, std::size_t from, std::size_t axis) -> Big {
      return to_integer(four[to][axis], unit) - to_integer(four[from][axis], unit);
    };
    const Big truth = side(1, 0, 0) * side(3, 2, 1) - side(1, 0, 1) * side(3, 2, 0);
    for (const testing_environment::Setting& mode : testing_environment::kSettings) {
      ASSERT_TRUE(all_right(evaluate_in(mode, PLUMB_ANSWERS(cross_sign), four),
                            static_cast<Sign>(truth.sign())))
          << mode.name << ": " << describe(four);
    }
  }
}

}  // namespace
}  // namespace plumb::test::input_predicates_test
