#include "plumb/io/map_io.h"

#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cfenv>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <random>
#include <sstream>
#include <string>
#include <vector>

#include "expect_refusals.h"
#include "hostile_maps.h"
#include "plumb/io/plane/wkt.h"
#include "plumb/io/text/input_cursors.h"
#include "plumb/io/text/text_output.h"
#include "plumb/predicates/error.h"
#include "plumb/predicates/plane/plane_points.h"

namespace plumb::map_io_test {
namespace {

Map read(const std::string& text, bool exact_decimals = false, Limits limits = {}) {
  Context context(limits);
  return read_map(text, {"some.file", exact_decimals}, context);
}

/// A map whose first vertex is (`number`, 0) and which has no faces.
RationalPoint2 read_number(const std::string& number, bool exact_decimals = false) {
  return read("1 0\n" + number + " 0\n", exact_decimals).points.exact(0);
}

std::string written(const Map& map) {
  std::ostringstream out;
  write_map(out, map);
  return out.str();
}

TEST(MapReader, refuses_hostile_maps_with_their_place) {
  testing::expect_refusals(testing::hostile_maps(), [](const std::string& bytes) { read(bytes); });
}

TEST(MapReader, accepts_what_the_format_allows) {
  const std::string plain = "3 2\n0 0\n1 0\n0 1\n1 2 3\n3 2 1\n";
  const std::vector<std::string> same{
      plain,
      "3 2\n0 0\n1 0\n0 1\n1 2 3\n3 2 1",                // no last line break
      "3 2\r\n0 0\r\n1 0\r\n0 1\r\n1 2 3\r\n3 2 1\r\n",  // CRLF
      "3 2\r\n0 0\r\n1 0\r\n0 1\r\n1 2 3\r\n3 2 1\r",    // CR at the very end
      "\xEF\xBB\xBF"
      "3 2\n0 0\n1 0\n0 1\n1 2 3\n3 2 1\n",  // byte order mark
      "# gr\xC3\xBC\xDF\r\n\n  # b\n3 2\n\n0 0\n1 0\n#\n0 1\n1 2 3\n \t\n3 2 1\n# end",
      "  3\t 2  \n 0 0 \n\t1 0\n+0 +1\n  1  2\t3\n003 02 1\n",  // blanks, signs, leading zeros
      "3 2\n-0 -0.0\n1.0 0e5\n.0 1.\n1 2 3\n3 2 1\n",           // decimals
      "3 2\n0/7 0\n3/3 0\n0 10/10\n1 2 3\n3 2 1\n",             // fractions
  };
  for (const std::string& text : same) EXPECT_EQ(written(read(text)), plain) << text;
}

/// As RFC 3629 says: by value.
std::string utf8(std::uint32_t code) {
  const auto tail = [&](unsigned shift) {
    return static_cast<char>(0x80U | (code >> shift & 0x3fU));
  };
  if (code < 0x80) return {static_cast<char>(code)};
  if (code < 0x800) return {static_cast<char>(0xc0U | code >> 6U), tail(0)};
  if (code < 0x10000) return {static_cast<char>(0xe0U | code >> 12U), tail(6), tail(0)};
  return {static_cast<char>(0xf0U | code >> 18U), tail(12), tail(6), tail(0)};
}

// What an encoder writes is text, and nothing else: of all beginnings of three bytes, and tails of
// a fourth.
TEST(TextPrefix, is_what_an_encoder_writes) {
  std::vector<bool> is_written(std::size_t{1} << 24U);
  const auto key = [](const std::string& bytes) {
    std::size_t all = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      all = all << 8U | (i < bytes.size() ? static_cast<unsigned char>(bytes[i]) : 0U);
    }
    return all;
  };
  for (std::uint32_t code = 0x80; code < 0x110000; ++code) {
    if (0xd800 <= code && code < 0xe000) continue;
    const std::string bytes = utf8(code);
    is_written[key(bytes)] = true;
    if (code % 61 == 0) {
      ASSERT_EQ(text_prefix(bytes + "x"), bytes.size() + 1) << code;
    }
  }
  for (unsigned lead = 0x80; lead < 0x100; ++lead) {
    const std::size_t length = lead < 0xe0 ? 2 : lead < 0xf0 ? 3 : 4;
    for (unsigned second = 0; second < 0x100; ++second) {
      for (const unsigned third : {0x20U, 0x7fU, 0x80U, 0xbfU, 0xc0U}) {
        std::string bytes{static_cast<char>(lead), static_cast<char>(second)};
        if (length > 2) bytes += static_cast<char>(third);
        const std::size_t expected = is_written[key(bytes)] ? length : 0;
        if (length > 3) bytes += '\x80';
        ASSERT_EQ(text_prefix(bytes), expected) << lead << ' ' << second << ' ' << third;
        ASSERT_EQ(text_prefix(bytes.substr(0, bytes.size() - 1)), 0U);
      }
    }
  }
  for (unsigned byte = 0; byte < 0x80; ++byte) {
    const bool is_plain = byte == '\t' || (byte >= 0x20 && byte != 0x7f);
    EXPECT_EQ(text_prefix(std::string(1, static_cast<char>(byte))), is_plain ? 1U : 0U) << byte;
  }
}

TEST(MapReader, takes_a_bow_tie_of_area_0_for_a_face) {
  EXPECT_EQ(read("4 1\n0 0\n1 1\n1 0\n0 1\n1 2 3 4\n").cycle_count(), 1U);
}

TEST(MapReader, takes_an_empty_map) {
  EXPECT_EQ(read("0 0\n").vertex_count(), 0U);
  EXPECT_EQ(read("0 0").cycle_count(), 0U);
}

TEST(MapReader, reads_integers_and_fractions_exactly) {
  const std::vector<std::string> numbers{
      "9007199254740993",
      "-9007199254740993",
      "18446744073709551617",
      "9999999999999999",
      "1/3",
      "-22/7",
      "123456789012345678901234567890123456789/1000000007",
  };
  for (const std::string& number : numbers) {
    EXPECT_EQ(read_number(number).x, Rational(number)) << number;
  }
  const std::string digits(1000, '9');
  EXPECT_EQ(read_number(digits).x, Rational(digits));
  // plumb writes fractions of many digits, and no other numbers.
  const std::string more(8000, '7');
  EXPECT_EQ(read_number("-" + more + "/" + more + "1").x, Rational("-" + more + "/" + more + "1"));
  EXPECT_THROW(read_number(more), Error);
  EXPECT_THROW(read_number(more + ".5"), Error);
  EXPECT_THROW(read_number(more + more + "/" + more), Error);
  EXPECT_EQ(read_number("2/4").x, Rational(1, 2));
  EXPECT_EQ(read_number("0000000000000000000000000000017").x, 17);
}

TEST(MapReader, reads_decimals_as_the_nearest_double) {
  const std::vector<std::pair<std::string, double>> numbers{
      {"0.1", 0.1},
      {"-1.5e3", -1500},
      {"1E+2", 100},
      {"+.5", 0.5},
      {"9007199254740993.0", 9007199254740992.0},  // a tie goes to even
      {"9007199254740993.00000000000000000000000000000000001", 9007199254740994.0},
      {"1.7976931348623157e308", 1.7976931348623157e308},
      {"4.9406564584124654e-324", 4.9406564584124654e-324},
      {"2.4703282292062327e-324", 0},  // just below half of the least subnormal
      {"2.4703282292062328e-324", 4.9406564584124654e-324},
      {"1e-400", 0},
      {"-1e-999999999", 0},
      {"0e999999999", 0},
      {"0.000e99999999999999999999999", 0},
  };
  for (const auto& [text, value] : numbers) EXPECT_EQ(read_number(text).x, Rational(value)) << text;
}

/// As precise as the text is: whether it has few digits or hundreds, it is rounded once.
TEST(MapReader, reads_long_decimals_as_the_nearest_double) {
  const std::string zeros(100, '0');
  EXPECT_EQ(read_number("0.1" + zeros).x, Rational(0.1));
  EXPECT_EQ(read_number("-" + zeros + "1.5" + zeros + "e3").x, -1500);
  EXPECT_EQ(read_number("+" + zeros + ".5").x, Rational(0.5));
  EXPECT_EQ(read_number("-0." + zeros).x, 0);
  EXPECT_EQ(read_number("0." + zeros + zeros + "1e190").x, Rational(1e-11));
  EXPECT_EQ(read_number("9007199254740993." + zeros).x, Rational(9007199254740992.0));
  EXPECT_EQ(read_number("9007199254740993." + zeros + "1").x, Rational(9007199254740994.0));
  EXPECT_EQ(read_number("2.4703282292062327" + zeros + "e-324").x, 0);
  EXPECT_EQ(read_number("2.4703282292062328" + zeros + "e-324").x, Rational(0x1p-1074));
  EXPECT_EQ(read_number("1" + zeros + ".0e-999999999").x, 0);
  EXPECT_EQ(read_number("1.7976931348623157" + zeros + "e308").x, Rational(1.7976931348623157e308));
  EXPECT_THROW(read_number("1.7976931348623159" + zeros + "e308"), Error);
  EXPECT_THROW(read_number("1" + zeros + ".0e999999999"), Error);
  EXPECT_THROW(read_number("0.1" + zeros + "x"), Error);
  EXPECT_THROW(read_number("0.1" + zeros + "e"), Error);
}

TEST(MapReader, reads_what_100_digits_say_of_a_double) {
  std::mt19937_64 dice(20261122);
  for (int i = 0; i < 2000; ++i) {
    const auto value = std::bit_cast<double>(dice());
    if (!std::isfinite(value)) continue;
    std::array<char, 128> text{};
    std::snprintf(text.data(), text.size(), "%.99e", value);
    EXPECT_EQ(read_number(text.data()).x, Rational(value)) << text.data();
  }
}

TEST(MapReader, reads_decimals_exactly_on_request) {
  EXPECT_EQ(read_number("0.1", true).x, Rational(1, 10));
  EXPECT_EQ(read_number("-12.50e-1", true).x, Rational(-5, 4));
  EXPECT_EQ(read_number("1e25", true).x, Rational("10000000000000000000000000"));
  EXPECT_EQ(read_number(".5e1", true).x, 5);
  EXPECT_EQ(read_number("0e1101", true).x, 0);
  EXPECT_EQ(read_number("1e1098", true).x, Rational("1" + std::string(1098, '0')));
  EXPECT_EQ(read_number("1e-1098", true).x, 1 / Rational("1" + std::string(1098, '0')));
  EXPECT_THROW(read_number("1e1100", true), Error);
  EXPECT_THROW(read_number("1e-1100", true), Error);
  EXPECT_THROW(read_number("." + std::string(3000, '7'), true), Error);
  EXPECT_THROW(read_number("1e-999999999", true), Error);
}

TEST(MapReader, stops_exact_decimals_that_expand_too_far) {
  // Every line is 14 bytes and would take two integers of 3,300 bits.
  std::string text = "160000 0\n";
  for (int i = 0; i < 160000; ++i) text += "1e1000 1e1000\n";
  try {
    read(text, true);
    ADD_FAILURE() << "was read";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::ResourceLimit);
    EXPECT_GT(error.place().line, 1000U);
  }
}

TEST(MapReader, rounds_to_nearest_in_every_rounding_mode) {
  for (const int mode : {FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO}) {
    std::fesetround(mode);
    const Map map = read("1 0\n0.1 1.7976931348623157e22\n");
    EXPECT_EQ(std::fegetround(), mode);
    std::fesetround(FE_TONEAREST);
    EXPECT_EQ(map.points.approx(0), (Point2{0.1, 1.7976931348623157e22}));
  }
}

TEST(MapReader, mixes_kinds_within_a_vertex) {
  const RationalPoint2 p = read("1 0\n1/3 0.1\n").points.exact(0);
  EXPECT_EQ(p.x, Rational(1, 3));
  EXPECT_EQ(p.y, Rational(0.1));
}

TEST(MapReader, round_trips_every_kind_of_number) {
  const std::string text =
      "7 1\n0.1 -0.3333333333333333\n1/3 -7/2\n9007199254740993 123456789012345678901234567890\n"
      "5e-324 1.7976931348623157e+308\n36272 119656\n100000 1e+23\n-4611686018427387904 0\n1 2 3 "
      "4\n";
  EXPECT_EQ(written(read(written(read(text)))), written(read(text)));
  const Map once = read(text);
  const Map twice = read(written(once));
  for (std::uint32_t i = 0; i < 7; ++i) EXPECT_EQ(once.points.exact(i), twice.points.exact(i)) << i;
}

TEST(MapReader, keeps_to_the_memory_limit) {
  std::string text = "20000 0\n";
  for (int i = 0; i < 20000; ++i) text += "0 0\n";
  Limits limits;
  limits.max_memory_bytes = 20000 * sizeof(Point2) + 4;
  EXPECT_EQ(read(text, false, limits).vertex_count(), 20000U);
  limits.max_memory_bytes = 20000 * sizeof(Point2) - 4;
  EXPECT_THROW(read(text, false, limits), Error);
}

TEST(MapReader, stops_when_asked_to) {
  std::stop_source source;
  source.request_stop();
  Context context({}, source.get_token());
  try {
    read_map("1 0\n0 0\n", {}, context);
    ADD_FAILURE() << "went on";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::Cancelled);
  }
}

TEST(MapReader, names_files_it_cannot_open) {
  Context context;
  try {
    read_map_file("no/such.map", {}, context);
    ADD_FAILURE() << "was opened";
  } catch (const Error& error) {
    EXPECT_STREQ(error.what(), "no/such.map: No such file or directory");
  }
  EXPECT_THROW(read_map_file("corpus", {}, context), Error);  // a directory
}

/// Two squares with a common side, the second one clockwise, and a hole of the first one, which
/// touches it at (5, 0) and runs the wrong way.
const std::string kPolygons =
    "GEOMETRYCOLLECTION (MULTIPOLYGON (((0 0, 5 0, 9 0, 9 9, 0 9, 0 0), (5 0, 7 4, 3 4, 5 0)), "
    "((9 0, 9 9, 12 9, 12 0, 9 0))), POINT (1 1))";

TEST(MapOfPolygons, shares_positions_and_turns_rings) {
  Context context;
  const Map map = map_of_polygons(read_wkt(kPolygons, {"some.file"}, context).shapes, context);
  EXPECT_EQ(map.vertex_count(), 9U);
  ASSERT_EQ(map.cycle_count(), 3U);
  EXPECT_EQ(map.cycle(0).size(), 5U);
  for (std::size_t c = 0; c < 3; ++c) {
    EXPECT_EQ(polygon_area_sign(map.points, map.cycle(c)), c < 2 ? Sign::Positive : Sign::Negative);
  }
  for (std::uint32_t v = 0; v < 9; ++v) {
    for (std::uint32_t w = 0; w < v; ++w) {
      EXPECT_NE(compare_xy(map.points, v, w), Sign::Zero);
    }
  }
}

TEST(MapOfPolygons, refuses_an_outer_ring_without_three_corners) {
  Context context;
  const PlaneShapes shapes =
      read_wkt("POLYGON ((0 0, 1 0, 1 0, 0 0))", {"some.file"}, context).shapes;
  EXPECT_THROW(map_of_polygons(shapes, context), Error);
}

TEST(FormatDouble, reads_back_and_is_short) {
  EXPECT_EQ(format_double(100000), "100000");
  EXPECT_EQ(format_double(-0.5), "-0.5");
  EXPECT_EQ(format_double(1e22), "1e+22");
  EXPECT_EQ(format_double(9007199254740992.0), "9007199254740992");
  EXPECT_EQ(format_double(5e-324), "5e-324");
}

}  // namespace
}  // namespace plumb::map_io_test
