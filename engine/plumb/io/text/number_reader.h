// Text to numbers, exactly, behind limits.
//
//   integer   [+-]digits                       exact, whatever its size
//   fraction  [+-]digits/digits                exact; denominator not 0
//   decimal   [+-]digits[.digits][(e|E)[+-]digits], with a point or an exponent (one side of the
//             point may be empty): the nearest double, or exactly as written on request
//
// No hexadecimal, no nan, no inf. The length and the exponent of a token are checked before any
// number library sees it: a bomb ("1e999999999", a million digits, "1/0") costs no more than
// reading its bytes.
#pragma once

#include <cstdint>
#include <string_view>

#include "plumb/base/context.h"
#include "plumb/io/text/input_cursors.h"
#include "plumb/predicates/point_table2.h"
#include "plumb/predicates/rational.h"

namespace plumb {

/// Decimal text is rounded to nearest, whatever mode the caller is in: readers hold one of these.
class RoundToNearest {
 public:
  RoundToNearest();
  ~RoundToNearest();
  RoundToNearest(const RoundToNearest&) = delete;
  RoundToNearest& operator=(const RoundToNearest&) = delete;

 private:
  int before_;
};

/// A number as read: a double when a double holds it exactly (or when that is what was asked for),
/// else a rational.
class ReadNumber {
 public:
  bool is_double() const { return is_double_; }
  /// Requires is_double().
  double as_double() const { return double_; }
  /// The exact value; always available.
  Rational exact() const { return is_double_ ? Rational(double_) : exact_; }

  void set(double value) {
    double_ = value;
    is_double_ = true;
  }
  void set(Rational value);

 private:
  bool is_double_ = true;
  double double_ = 0;
  Rational exact_;
};

/// The memory that a PointTable2 takes for (x, y) besides its two doubles, at most; 0 if those say
/// it all.
std::size_t exact_bytes(const ReadNumber& x, const ReadNumber& y);
void push_point(PointTable2& points, const ReadNumber& x, const ReadNumber& y);

/// Reads the numbers of one file. Numbers written with exponents can be far larger than their
/// text: the reader keeps an account of the digits they expand to, and stops at 4 digits for each
/// byte of the file plus 32 million. Requires the rounding mode to nearest (RoundToNearest).
class NumberReader {
 public:
  NumberReader(const Limits& limits, bool exact_decimals, std::size_t file_bytes);

  /// The number `token` of the cursor's line. Errors, at their place: Syntax, NotText,
  /// NumberOutOfRange (too many digits, too large an exponent, beyond the largest double, zero
  /// denominator), ResourceLimit (expansion).
  void read(const TextCursor& cursor, std::string_view token, ReadNumber& number);

  /// The same for the next token of the cursor, which is taken. Hot path: a number of ordinary
  /// length is looked at once. Requires !at_line_end().
  void read_next(TextCursor& cursor, ReadNumber& number) {
    if (!read_ordinary(cursor, number)) read(cursor, cursor.token(), number);
  }

 private:
  bool read_ordinary(TextCursor& cursor, ReadNumber& number) const;
  void read_integer(std::string_view token, ReadNumber& number) const;
  void read_fraction(const TextCursor& cursor, std::string_view token, std::size_t slash,
                     ReadNumber& number) const;
  void read_nearest(const TextCursor& cursor, std::string_view token, ReadNumber& number) const;
  void read_exact_decimal(const TextCursor& cursor, std::string_view token, ReadNumber& number);

  std::uint32_t max_digits_;
  std::uint32_t max_exponent_;
  bool exact_decimals_;
  std::uint64_t expansion_left_;  // digits
};

}  // namespace plumb
