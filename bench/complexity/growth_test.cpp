// That a family above its bound fails, by calls of predicates or by allocations alone, and so does one of too few sizes.
#include "growth.h"

#include <fmt/core.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <list>
#include <stdexcept>
#include <string>
#include <vector>

#include "plumb/predicates/input_predicates.h"
#include "plumb/predicates/rung_counters.h"

namespace plumb::bench {
namespace {

/// So many questions and so many blocks.
Work asking(std::size_t size, std::size_t questions, std::size_t blocks) {
  return measured(static_cast<double>(size), [=] {
    double sum = 0;
    for (std::size_t i = 0; i < questions; ++i) {
      sum += static_cast<double>(orient2d({0, 0}, {1, 0}, {static_cast<double>(i), 1}));
    }
    return std::list<double>(blocks, sum);
  });
}
/// More than linear, and by far not what takes the time.
std::size_t somewhat_more(std::size_t n) {
  return static_cast<std::size_t>(std::pow(static_cast<double>(n), 1.4));
}
Work linear(std::size_t n) { return asking(n, n, n); }
Work too_many_calls(std::size_t n) { return asking(n, somewhat_more(n), 400 * n); }
Work too_many_blocks(std::size_t n) { return asking(n, 2000 * n, somewhat_more(n)); }
Work impossible(std::size_t) { throw std::runtime_error("no such input"); }

const std::vector<std::size_t> kSizes = sizes_between(10, 1000);
const std::vector<Family> kFamilies{
    {"linear", "n questions and blocks", "n", {1, 0}, kSizes, linear},
    {"calls", "n^1.4 questions", "n", {1, 0}, kSizes, too_many_calls},
    {"as-claimed", "the same, claimed as such", "n", {1.4, 0}, kSizes, too_many_calls},
    {"allocations", "n^1.4 blocks", "n", {1, 0}, kSizes, too_many_blocks},
    {"five-sizes", "a size too few", "n", {1, 0}, {10, 30, 100, 300, 1000}, linear},
    {"narrow", "less than two decades", "n", {1, 0}, {11, 30, 100, 300, 600, 1000}, linear},
    {"impossible", "no input can be made", "n", {1, 0}, kSizes, impossible},
};

/// By what is the same on a busy machine.
int status_of(std::string family) {
  std::array<std::string, 2> words{"growth_test", "--work"};
  std::array<char*, 4> arguments{words[0].data(), words[1].data(), family.data(), nullptr};
  return growth_main("Families that are made up", kFamilies, 3, arguments.data());
}

bool are_calls_counted() {
  reset_rung_counts();
  static_cast<void>(orient2d({0, 0}, {1, 0}, {0, 1}));
  return rung_counts() != RungCounts{};
}

}  // namespace
}  // namespace plumb::bench

int main() {
  using namespace plumb::bench;
  struct Expected {
    const char* family;
    int status;
  };
  const std::array<Expected, 8> all{{{"linear", 0},
                                     {"calls", are_calls_counted() ? 1 : 0},
                                     {"as-claimed", 0},
                                     {"allocations", 1},
                                     {"five-sizes", 1},
                                     {"narrow", 1},
                                     {"impossible", 1},
                                     {"no-such-family", 2}}};
  int failures = 0;
  for (const Expected& e : all) {
    const int status = status_of(e.family);
    if (status == e.status) continue;
    fmt::print(stderr, "{}: exit status {}, not {}\n", e.family, status, e.status);
    ++failures;
  }
  return failures == 0 ? 0 : 1;
}
