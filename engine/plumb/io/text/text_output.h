// Numbers and text, formatted fast, to any std::ostream.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <memory>
#include <ostream>
#include <string>
#include <string_view>
#include <utility>

#include "plumb/base/context.h"
#include "plumb/predicates/point_table2.h"
#include "plumb/predicates/rational.h"

#pragma GCC visibility push(default)
namespace plumb {

/// Returns the shortest text that reads back as `value` under the rules of record_reader.h: a whole
/// number below 2^63 in magnitude as an integer, else the shortest decimal. Requires a finite
/// value.
std::string format_double(double value);

/// Returns "p/q", or "p" if q = 1.
std::string format_exact(const Rational& value);

/// A block of text on its way to a stream. It is written when it is full and on flush(), which must
/// be called before the end of its life: the destructor drops what is left, because it may run when
/// writing has failed.
class TextOutput {
 public:
  explicit TextOutput(std::ostream& out);
  /// Checks the context at each block.
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
  /// Writes as format_double() does.
  TextOutput& operator<<(double value);

  void flush();

 private:
  static constexpr std::size_t kBlock = std::size_t{1} << 16;

  /// Returns where at least `bytes` (<= kBlock) can be written.
  char* room(std::size_t bytes) {
    if (kBlock - used_ < bytes) flush();
    return block_.get() + used_;
  }

  std::ostream& out_;
  Context* context_ = nullptr;
  std::unique_ptr<char[]> block_;
  std::size_t used_ = 0;
};

/// Writes the coordinates of point i, "x y": doubles as format_double() does, others exactly.
void write_point(TextOutput& out, const PointTable2& points, std::uint32_t i);

// Numbers of fixed size as little-endian bytes.

template <class Number>
void put_little_endian(TextOutput& out, Number value) {
  char raw[sizeof(Number)];
  std::memcpy(raw, &value, sizeof(Number));
  if constexpr (std::endian::native == std::endian::big) {
    for (std::size_t i = 0; i < sizeof(Number) / 2; ++i) {
      std::swap(raw[i], raw[sizeof(Number) - 1 - i]);
    }
  }
  out << std::string_view(raw, sizeof(Number));
}

}  // namespace plumb
#pragma GCC visibility pop
