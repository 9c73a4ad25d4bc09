// Bytes of numbers in both orders, against bytes that are written down here.
#include "plumb/io/text/byte_order.h"

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <limits>
#include <string>

namespace plumb::byte_order_test {
namespace {

template <class Number>
std::string bytes(Number value, std::endian order) {
  const auto all = to_bytes(value, order);
  return {all.begin(), all.end()};
}

TEST(ByteOrder, is_that_of_the_file_and_not_of_the_processor) {
  EXPECT_EQ(bytes(std::uint32_t{0x01020304}, std::endian::big), "\x01\x02\x03\x04");
  EXPECT_EQ(bytes(std::uint32_t{0x01020304}, std::endian::little), "\x04\x03\x02\x01");
  EXPECT_EQ(bytes(std::uint16_t{0xfe41}, std::endian::big), "\xfe\x41");
  EXPECT_EQ(bytes(std::int8_t{-2}, std::endian::big), "\xfe");
  EXPECT_EQ(bytes(-1.5F, std::endian::big), std::string("\xbf\xc0\0\0", 4));
  EXPECT_EQ(bytes(1.0, std::endian::little), std::string("\0\0\0\0\0\0\xf0\x3f", 8));
}

TEST(ByteOrder, is_undone_by_reading_at_any_place) {
  const std::array<double, 5> numbers{-0.0, 1, -2.5e300, std::numeric_limits<double>::denorm_min(),
                                      std::numeric_limits<double>::infinity()};
  for (const std::endian order : {std::endian::little, std::endian::big}) {
    for (const double number : numbers) {
      for (std::size_t gap = 0; gap < sizeof(double); ++gap) {
        const std::string file = std::string(gap, 'x') + bytes(number, order);
        const auto read = from_bytes<double>(file.data() + gap, order);
        EXPECT_EQ(std::bit_cast<std::uint64_t>(read), std::bit_cast<std::uint64_t>(number));
      }
    }
  }
}

}  // namespace
}  // namespace plumb::byte_order_test
