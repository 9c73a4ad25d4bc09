// Doubles from text by std::strtod(), against std::from_chars() of this library.
#include "plumb/io/text/double_text.h"

#include <gtest/gtest.h>

#include <bit>
#include <charconv>
#include <cstdint>
#include <random>
#include <string>
#include <string_view>

namespace plumb::double_text_test {
namespace {

void expect_same(const std::string& text) {
  const char* const begin = text.data();
  const char* const end = begin + text.size();
  double expected = 7, found = 7;
  const auto by_chars = std::from_chars(begin, end, expected);
  const auto by_strtod = double_by_strtod(begin, end, found);
  if (by_chars.ec == std::errc::invalid_argument) {
    EXPECT_EQ(by_strtod.ec, std::errc::not_supported) << text;
    EXPECT_EQ(by_strtod.ptr, begin) << text;
    return;
  }
  EXPECT_EQ(by_strtod.ec, by_chars.ec) << text;
  EXPECT_EQ(by_strtod.ptr - begin, by_chars.ptr - begin) << text;
  EXPECT_EQ(std::bit_cast<std::uint64_t>(found), std::bit_cast<std::uint64_t>(expected)) << text;
}

TEST(DoubleText, strtod_reads_what_from_chars_reads) {
  std::mt19937 random(1);
  constexpr std::string_view kLetters = "0123456789.-+eE x";
  for (int i = 0; i < 200'000; ++i) {
    std::string text(random() % 14, ' ');
    for (char& c : text) c = kLetters[random() % kLetters.size()];
    expect_same(text);
  }
}

TEST(DoubleText, strtod_rounds_as_from_chars_does) {
  std::mt19937_64 random(2);
  for (int i = 0; i < 50'000; ++i) {
    const std::string digits = std::to_string(random()) + "." + std::to_string(random());
    expect_same(digits + "e" + std::to_string(static_cast<int>(random() % 720) - 380));
  }
  for (const char* text : {"4.9406564584124654e-324", "2.4703282292062327e-324", "1e-400", "1e400",
                           "-1e400", "1.7976931348623159e308", "-0", "9007199254740993"}) {
    expect_same(text);
  }
}

TEST(DoubleText, long_numbers_and_words_are_left_to_the_caller) {
  for (const std::string& text : {std::string(128, '1'), std::string("inf"), std::string("nan")}) {
    double value = 7;
    const auto [end, code] = double_by_strtod(text.data(), text.data() + text.size(), value);
    EXPECT_EQ(code, std::errc::not_supported) << text;
    EXPECT_EQ(end, text.data()) << text;
    EXPECT_EQ(value, 7) << text;
  }
}

}  // namespace
}  // namespace plumb::double_text_test
