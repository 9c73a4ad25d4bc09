// Arithmetic on long numbers stops within the limits of a watched Context, on every thread, and
// only there.
#include "plumb/base/arithmetic_watch.h"

#include <gtest/gtest.h>

#include <atomic>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "plumb/base/internal/parallel.h"
#include "plumb/predicates/error.h"
#include "plumb/predicates/rational.h"

namespace plumb {
namespace {

/// A fraction of two numbers of so many digits.
Rational long_fraction(std::size_t digits) {
  return Rational(std::string(digits, '7') + "/" + std::string(digits - 1, '1') + "3");
}

/// Adds up fractions until something is thrown, at most `most` times; returns how often. There are
/// no checkpoints.
std::size_t sums_until_stopped(std::size_t digits, std::size_t most) {
  std::size_t done = 0;
  try {
    const Rational step = long_fraction(digits);
    for (Rational sum = 0; done < most; ++done) {
      sum = sum / step + step;
      if (mpz_size(mpq_numref(sum.mpq())) > 4 * digits) sum = step;
    }
  } catch (const Error&) {
  }
  return done;
}

TEST(ArithmeticWatch, stops_long_numbers_after_a_bounded_work) {
  std::stop_source stop;
  stop.request_stop();
  const Context context({}, stop.get_token());
  const ArithmeticWatch watch(context);
  // A gcd of 20,000 digits takes about a millisecond, one of 30 digits half a microsecond.
  EXPECT_LT(sums_until_stopped(20'000, 100), 10U);
  EXPECT_LT(sums_until_stopped(30, 1'000'000), 100'000U);
}

TEST(ArithmeticWatch, keeps_the_time_limit) {
  const Context context(Limits{.max_seconds = 1e-9});
  const ArithmeticWatch watch(context);
  try {
    sums_until_stopped(20'000, 100);
    Rational sum = 0;
    for (int i = 0; i < 100; ++i) sum += long_fraction(20'000);
    FAIL() << "nothing was thrown";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::ResourceLimit);
  }
}

TEST(ArithmeticWatch, leaves_unwatched_arithmetic_alone) {
  std::stop_source stop;
  stop.request_stop();
  const Context context({}, stop.get_token());
  EXPECT_EQ(sums_until_stopped(20'000, 50), 50U);
  {
    const ArithmeticWatch watch(context);
    EXPECT_TRUE(ArithmeticWatch::is_active());
  }
  EXPECT_FALSE(ArithmeticWatch::is_active());
  EXPECT_EQ(sums_until_stopped(20'000, 50), 50U);
}

TEST(ArithmeticWatch, gives_back_the_watch_before_it) {
  std::stop_source stop;
  stop.request_stop();
  const Context stopped({}, stop.get_token());
  const Context free_to_run;
  const ArithmeticWatch outer(stopped);
  {
    const ArithmeticWatch inner(free_to_run);
    EXPECT_EQ(sums_until_stopped(20'000, 50), 50U);
  }
  EXPECT_LT(sums_until_stopped(20'000, 50), 10U);
}

TEST(ArithmeticWatch, holds_in_all_jobs_and_only_if_the_caller_watches) {
  for (const bool is_watched : {false, true}) {
    Context context({}, {}, {}, 4);
    std::optional<ArithmeticWatch> watch;
    if (is_watched) watch.emplace(context);
    std::atomic<int> watched = 0;
    run_jobs(context, 16, [&](std::size_t, Context&) { watched += ArithmeticWatch::is_active(); });
    EXPECT_EQ(watched, is_watched ? 16 : 0);
  }
}

TEST(ArithmeticWatch, a_job_is_stopped_by_the_failure_of_an_earlier_one) {
  Context context({}, {}, {}, 2);
  const ArithmeticWatch watch(context);
  std::atomic<bool> is_begun = false;
  const auto job = [&](std::size_t i, Context&) {
    if (i == 1) {
      is_begun = true;
      sums_until_stopped(2'000, 10'000'000);
      return;
    }
    while (!is_begun) {
    }
    throw Error(ErrorCode::BadArgument, "the first job fails");
  };
  EXPECT_THROW(run_jobs(context, 2, job), Error);
}

}  // namespace
}  // namespace plumb
