// Laws of sets for any program of records, under RapidCheck: a program that breaks one is shrunk,
// record by record and byte by byte, before it is shown.
#pragma once

#include <gtest/gtest-spi.h>
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "generate/set_program.h"
#include "oracle/set_laws.h"

namespace plumb::testing {

/// The first expectation of `check()` that fails, or "".
template <class Check>
std::string first_failure(Check check) {
  ::testing::TestPartResultArray results;
  {
    const ::testing::ScopedFakeTestPartResultReporter reporter(
        ::testing::ScopedFakeTestPartResultReporter::INTERCEPT_ONLY_CURRENT_THREAD, &results);
    check();
  }
  return results.size() == 0 ? "" : results.GetTestPartResult(0).message();
}

/// `flaw(program)` is "" for every program of at most `most` records.
template <class Flaw>
void expect_no_flaw_of_programs(const std::string& law, std::size_t most, Flaw flaw) {
  using Record = std::array<std::uint8_t, kProgramRecord>;
  EXPECT_TRUE(rc::check(law, [&](const std::vector<Record>& records) {
    std::vector<std::uint8_t> program;
    for (std::size_t i = 0; i < std::min(most, records.size()); ++i) {
      program.insert(program.end(), records[i].begin(), records[i].end());
    }
    RC_ASSERT(flaw(std::span<const std::uint8_t>(program)) == "");
  }));
}

/// The `i`-th of `count` parts of a program, whole records.
inline std::span<const std::uint8_t> part_of_program(std::span<const std::uint8_t> program,
                                                     std::size_t i, std::size_t count) {
  const std::size_t records = program.size() / kProgramRecord;
  const std::size_t begin = records * i / count, end = records * (i + 1) / count;
  return program.subspan(begin * kProgramRecord, (end - begin) * kProgramRecord);
}

/// Sets made by `make(program)` of a third of a program each obey the laws of sets. `all` is the
/// whole of their space.
template <class Nef, class Make>
void expect_programs_obey_the_laws(const Nef& all, Make make) {
  const auto flaw = [&](std::span<const std::uint8_t> program) {
    const Nef a = make(part_of_program(program, 0, 3));
    const Nef b = make(part_of_program(program, 1, 3));
    const Nef c = make(part_of_program(program, 2, 3));
    return first_failure([&] { expect_laws(a, b, c, all); });
  };
  expect_no_flaw_of_programs("sets of programs obey the laws", 18, flaw);
}

}  // namespace plumb::testing
