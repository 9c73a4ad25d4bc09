// Lists of half-spaces: what lines say, and the place of what is wrong.
#include "plumb/io/solid/half_space_reader.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "expect_refusals.h"

namespace plumb::half_space_reader_test {
namespace {

HalfSpaceList read(const std::string& text, bool exact = false, Limits limits = {}) {
  Context context(limits);
  return read_half_spaces(text, {.name = "some.file", .exact_decimals = exact}, context);
}

void expect_line(const HalfSpace3& read, const Plane3& plane, Boundary boundary) {
  EXPECT_EQ(read.plane.a, plane.a);
  EXPECT_EQ(read.plane.b, plane.b);
  EXPECT_EQ(read.plane.c, plane.c);
  EXPECT_EQ(read.plane.d, plane.d);
  EXPECT_EQ(read.boundary, boundary);
}

TEST(HalfSpaceReader, ReadsNumbersOfEveryKind) {
  const HalfSpaceList list = read(
      "# a comment\n\n1 -2 +3 0.1 closed\r\n  1/3 0 -0 0 open"
      "\n0 0 5e-1 123456789012345678901234567890 open");
  ASSERT_EQ(list.size(), 3U);
  expect_line(list[0], {1, -2, 3, Rational(0.1)}, Boundary::Closed);
  expect_line(list[1], {Rational(1, 3), 0, 0, 0}, Boundary::Open);
  expect_line(list[2], {0, 0, Rational(1, 2), Rational("123456789012345678901234567890")},
              Boundary::Open);
  const HalfSpaceList exact = read("0.1 1e400 1e-400 0 closed", true);
  ASSERT_EQ(exact.size(), 1U);
  const Rational large(pow(Integer(10), 400));
  expect_line(exact[0], {Rational(1, 10), large, 1 / large, 0}, Boundary::Closed);
}

TEST(HalfSpaceReader, ReadsAsManyLinesAsThereAre) {
  EXPECT_EQ(read("").size(), 0U);
  EXPECT_EQ(read("\n\n# nothing\n").size(), 0U);
  std::string text;
  for (int i = 0; i < 3000; ++i)
    text += "0 0 1 " + std::to_string(i % 10) + (i % 2 == 0 ? " open\n" : " closed\n");
  const HalfSpaceList list = read(text);
  ASSERT_EQ(list.size(), 3000U);
  for (int i = 0; i < 3000; ++i) {
    expect_line(list[static_cast<std::size_t>(i)], {0, 0, 1, i % 10},
                i % 2 == 0 ? Boundary::Open : Boundary::Closed);
  }
}

TEST(HalfSpaceReader, RefusesHostileTextsWithTheirPlace) {
  const std::string good = "1 0 0 0 closed\n";
  testing::expect_refusals(
      {{"too few numbers", good + "1 0 0 closed\n", 2, 7, "expected a number"},
       {"nothing after three", good + "1 0 0\n", 2, 6, "expected a number"},
       {"nothing after four", good + "1 0 0 0\n", 2, 8, "expected closed or open"},
       {"no such word", good + "1 0 0 0 shut\n", 2, 9, "expected closed or open, found 'shut'"},
       {"more than a line", good + " 1 0 0 0 open 5\n", 2, 15, "nothing may follow"},
       {"no normal", good + " 0 -0 0/7 1 open\n", 2, 2, "no plane"},
       {"no exponent", good + "1 0 0 1e open", 2, 7, "expected a number, found '1e'"},
       {"hexadecimal", good + "1 0 0 0x1p3 open", 2, 7, "expected a number, found '0x1p3'"},
       {"infinite", good + "1 0 inf 0 open", 2, 5, "expected a number, found 'inf'"},
       {"beyond doubles", good + "1 0 1e999 0 open", 2, 5, "larger than the largest double"},
       {"nothing below", good + "1 0 0 5/0 open", 2, 9, "the denominator is 0"}},
      [](const std::string& text) { read(text); });
}

TEST(HalfSpaceReader, TellsLimitsWithTheirPlace) {
  Limits limits;
  limits.max_memory_bytes = 1000;
  const std::string line = "1 0 0 0 closed\n", number(600, '7');
  const std::string lengthy = "1 " + number + " " + number + " 0 open\n";
  testing::expect_refusals(
      {{"many lines", testing::repeated(line, 100), 1, 1, "half-spaces needs"},
       {"long numbers", line + lengthy + lengthy, 3, 603, "half-spaces needs"}},
      [&](const std::string& text) { read(text, false, limits); });
}

}  // namespace
}  // namespace plumb::half_space_reader_test
