// That a family above its bound fails, by calls of predicates or allocations alone, and so does one
// of too few sizes.
#include "growth.h"

#include <fmt/format.h>

#include <cmath>
#include <cstddef>
#include <list>
#include <stdexcept>
#include <string>
#include <vector>

#include "plumb/predicates/input/rung_counters.h"
#include "plumb/predicates/input_predicates.h"

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
int status_of(std::vector<std::string> words) {
  words.insert(words.begin(), {"growth_test", "--work"});
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  return growth_main("Families that are made up", kFamilies, static_cast<int>(words.size()),
                     arguments.data());
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
  int failures = 0;
  const auto expect = [&](const std::vector<std::string>& words, int expected) {
    const int status = status_of(words);
    if (status == expected) return;
    fmt::print(stderr, "{}: exit status {}, not {}\n", fmt::join(words, " "), status, expected);
    ++failures;
  };
  expect({"linear"}, 0);
  expect({"calls"}, are_calls_counted() ? 1 : 0);
  expect({"as-claimed"}, 0);
  expect({"allocations"}, 1);
  expect({"five-sizes"}, 1);
  expect({"narrow"}, 1);
  expect({"impossible"}, 1);
  expect({"no-such-family"}, 2);
  return failures == 0 ? 0 : 1;
}
