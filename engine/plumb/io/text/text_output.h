// Fast formatting of numbers and text for any std::ostream.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <ostream>
#include <string>
#include <string_view>

#include "plumb/base/context.h"
#include "plumb/base/internal/message_text.h"
#include "plumb/io/text/byte_order.h"
#include "plumb/predicates/point_table2.h"
#include "plumb/predicates/rational.h"

#pragma GCC visibility push(default)
namespace plumb {

/// Returns the text "p/q" of a rational, or "p" if the denominator q is 1.
std::string format_exact(const Rational& value);

/// A buffer for text that is written to a stream. The contents of the buffer are written to the
/// stream when the buffer is full and when flush() is called. The caller must call flush() at the
/// end: the destructor discards the contents of the buffer, because it may run after writing has
/// failed.
class TextOutput {
 public:
  explicit TextOutput(std::ostream& out);
  /// Makes a buffer that also calls Context::checkpoint() whenever it writes its contents to the
  /// stream.
  TextOutput(std::ostream& out, Context& context) : TextOutput(out) { context_ = &context; }

  TextOutput& operator<<(char c) {
    *room(1) = c;
    ++used_;
    return *this;
  }
  TextOutput& operator<<(std::string_view text);
  TextOutput& operator<<(const char* text) { return *this << std::string_view(text); }
  TextOutput& operator<<(std::uint64_t value);
  TextOutput& operator<<(std::uint32_t value) { return *this << std::uint64_t{value}; }
  /// Writes format_double(value).
  TextOutput& operator<<(double value);

  void flush();

 private:
  static constexpr std::size_t kBlock = std::size_t{1} << 16;

  /// Returns a pointer to free memory for at least `bytes` bytes. Requires that `bytes` is at most
  /// kBlock.
  char* room(std::size_t bytes) {
    if (kBlock - used_ < bytes) flush();
    return block_.get() + used_;
  }

  std::ostream& out_;
  Context* context_ = nullptr;
  std::unique_ptr<char[]> block_;
  std::size_t used_ = 0;
};

/// Writes the coordinates of point i as "x y". A coordinate that is a double is written by
/// format_double(). Any other coordinate is written by format_exact().
void write_point(TextOutput& out, const PointTable2& points, std::uint32_t i);

/// Writes a number of fixed size as little-endian bytes.
template <class Number>
void put_little_endian(TextOutput& out, Number value) {
  const auto bytes = to_bytes(value, std::endian::little);
  out << std::string_view(bytes.data(), bytes.size());
}

}  // namespace plumb
#pragma GCC visibility pop
