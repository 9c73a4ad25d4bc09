// How what an operation costs grows with its input, held against the bound that is claimed for it.
//
// Main flow of a program of families, growth_main():
//  1. of every family and size, prepare() makes the input and returns the work
//  2. the work runs until it has taken long enough, several times over; a Meter counts each run,
//     small inputs in turn
//  3. time, instructions, allocations, bytes and calls of predicates are each divided by the
//     logarithms of the bound; what is left is fitted as a power of the size
//  4. a table on stdout, on wish JSON; exit status 1 when a power is above the bound's by more than
//     0.15, when all sizes are fewer than six or span less than two decades, or when prepare()
//     throws std::exception: a claim of its own that does not hold
// Instructions, allocations and calls do not depend on how busy the machine is; time does, and on
// the caches. --work leaves time out of the verdict or, if instructions are not counted, judges it
// with more slack. Calls are counted if the build has PLUMB_COUNT_RUNGS.
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <string_view>
#include <vector>

#include "meter.h"

namespace plumb::bench {

/// size^power * log(size)^logs.
struct Bound {
  double power = 1;
  int logs = 0;
};

struct Work {
  double size;  ///< what the bound speaks of
  std::function<void(Meter&)> run;
  std::size_t inputs = 1;  ///< of about that size, which runs take in turn
};

struct Family {
  std::string_view name;
  std::string_view claim;  ///< the operation, and where the claim comes from
  std::string_view unit;   ///< of sizes
  Bound bound;
  std::vector<std::size_t>
      sizes;  ///< what prepare() is given: at least six over two decades, ascending
  std::function<Work(std::size_t size)> prepare;
  double goal =
      0;  ///< most that the power of time alone, logarithms and all, is to be; 0: none is set
};

/// Counts all of a work.
template <class Once>
Work measured(double size, Once once) {
  return {size, [once = std::move(once)](Meter& meter) {
            meter.start();
            {
              const auto result = once();  // destroyed within
              static_cast<void>(result);
            }
            meter.stop();
          }};
}

/// Elements that the inputs of one size are to have together: a processor learns the branches of a
/// small input by heart when it alone is worked on again and again, which no one's work is.
inline constexpr double kVariedElements = 100000;

/// Counts all of a work on one of several inputs of the same size, in turn; `size`: their mean.
/// `once(input)`.
template <class Input, class Once>
Work measured_in_turn(double size, std::vector<Input> inputs, Once once) {
  const std::size_t count = inputs.size();
  return {size,
          [inputs = std::move(inputs), once = std::move(once),
           next = std::size_t{0}](Meter& meter) mutable {
            const Input& input = inputs[next++ % inputs.size()];
            meter.start();
            {
              const auto result = once(input);
              static_cast<void>(result);
            }
            meter.stop();
          },
          count};
}

/// From `least` to `most`, each `factor` times the one before: six sizes over two decades.
std::vector<std::size_t> sizes_between(double least, double most, double factor = 2.51188643150958);

/// The whole program: [--most PERCENT] [--work] [--slack X] [--json FILE] [FAMILY...]. --most
/// leaves out sizes above that share of the largest, but keeps three. --slack is added to the
/// bounds and goals. Exit status 2 if there is no such family, or if the file cannot be written.
int growth_main(std::string_view title, std::span<const Family> families, int argc, char** argv);

}  // namespace plumb::bench
