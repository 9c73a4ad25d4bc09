// Reads numbers from text, exactly and within limits, and files of counted records.
//
//   integer   [+-]digits                       exact, whatever its size
//   fraction  [+-]digits/digits                exact; denominator not 0
//   decimal   [+-]digits[.digits][(e|E)[+-]digits], with a point or an exponent (one side of the
//             point may be empty): the nearest double, or exactly as written on request
//
// There is no hexadecimal, nan or inf. The length and the exponent of a token are checked before
// any number library sees it, so a bomb ("1e999999999", a million digits, "1/0") costs no more than
// reading its bytes.
#pragma once

#include <cstdint>
#include <limits>
#include <string>
#include <string_view>

#include "plumb/base/context.h"
#include "plumb/base/internal/round_to_nearest.h"
#include "plumb/io/read_options.h"
#include "plumb/io/text/input_cursors.h"
#include "plumb/predicates/point_table2.h"
#include "plumb/predicates/rational.h"

namespace plumb {

/// Whether a number that is not finite begins here, in the spelling of any C library: nan, -inf,
/// 1.#IND.
bool starts_not_finite(std::string_view text);

/// A number as read: a double if a double holds it exactly or was asked for, else a rational.
class ReadNumber {
 public:
  bool is_double() const { return is_double_; }
  /// Requires is_double().
  double as_double() const { return double_; }
  /// Returns the exact value; always available.
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

/// Returns the most memory that a PointTable2 takes for (x, y) besides its two doubles; 0 if those
/// are exact.
std::size_t exact_bytes(const ReadNumber& x, const ReadNumber& y);
/// Appends the point (x, y).
void push_point(PointTable2& points, const ReadNumber& x, const ReadNumber& y);

/// Which numbers of a format are results of plumb. They may have up to 16,384 digits, whatever the
/// limits of the Context are. This is more than for any double, because the planes through three
/// points have long coefficients.
enum class ResultNumbers : std::uint8_t {
  None,
  Fractions,  ///< Other programs write the same format, but no fractions.
  All,
};

/// Reads the numbers of one file. Numbers written with exponents can be far larger than their text;
/// the reader counts the digits that they expand to, and stops at 4 digits for each byte of the
/// file plus 24 million. Requires rounding to nearest (RoundToNearest).
class NumberReader {
 public:
  /// Keeps the context, whose limits are checked once in a while if numbers are long.
  NumberReader(const Context& context, bool exact_decimals, std::size_t file_bytes,
               ResultNumbers results = ResultNumbers::None);

  /// Reads the number `token` of the cursor's line. Throws with the place: Syntax, NotText,
  /// NumberOutOfRange (too many digits, too large an exponent, beyond the largest double, zero
  /// denominator), ResourceLimit (expansion).
  void read(const TextCursor& cursor, std::string_view token, ReadNumber& number);

  /// Does the same for the next token of the cursor, which is taken. A hot path: a number of
  /// ordinary length is scanned once. Requires !at_line_end().
  void read_next(TextCursor& cursor, ReadNumber& number) {
    if (!read_ordinary(cursor, number)) read(cursor, cursor.token(), number);
  }
  /// Does the same, but takes nothing and returns false if the number is not finite. Each character
  /// in `marks` ends a token, too (TextCursor::word()).
  bool read_next_if_finite(TextCursor& cursor, ReadNumber& number, std::string_view marks) {
    if (read_ordinary(cursor, number)) return true;
    if (starts_not_finite(cursor.rest())) return false;
    read(cursor, cursor.word(marks), number);
    return true;
  }

 private:
  bool read_ordinary(TextCursor& cursor, ReadNumber& number) const;
  void require_few_digits(const TextCursor& cursor, std::string_view token) const;
  void watch(std::size_t bytes);
  void read_integer(std::string_view token, ReadNumber& number) const;
  void read_fraction(const TextCursor& cursor, std::string_view token, std::size_t slash,
                     ReadNumber& number) const;
  void read_nearest(const TextCursor& cursor, std::string_view token, ReadNumber& number) const;
  void read_exact_decimal(const TextCursor& cursor, std::string_view token, ReadNumber& number);

  const Context& context_;
  std::uint32_t max_digits_;
  std::uint32_t max_fraction_digits_;
  std::uint32_t max_exponent_;
  bool exact_decimals_;
  std::uint64_t expansion_left_;     // Digits.
  std::size_t bytes_unchecked_ = 0;  // Of long numbers, since the limits were checked.
};

// Reads files of counted records, with one record on each line. map, OFF, text PLY, .nef2 and .nef
// have this form.
//
// Claims are compared with the bytes that follow before anything is reserved for them. Every error,
// an exhausted memory limit included, is thrown with its place.

/// A cursor over records.
class RecordReader {
 public:
  static constexpr std::uint32_t kMostIds = std::numeric_limits<std::uint32_t>::max() - 1;

  /// `contents` names the data for which memory is charged, such as "the map". All arguments must
  /// outlive the reader.
  RecordReader(std::string_view text, const ReadOptions& options, Context& context,
               std::string_view contents, ResultNumbers results = ResultNumbers::None);

  TextCursor& cursor() { return cursor_; }
  const TextCursor& cursor() const { return cursor_; }

  /// Charges the context; a limit is reported at the place of the cursor.
  void charge(std::uint64_t bytes);

  /// Reads the first line, `MAGIC VERSION`. Throws Error{Syntax}, and Error{UnknownFormat} for
  /// another version.
  void read_magic(std::string_view magic, std::string_view version);
  /// Returns a number of records: at most kMostIds.
  std::uint32_t read_count(std::string_view what);
  /// Throws at `start` unless at least as many bytes follow as `announced` needs.
  void require_bytes(std::uint64_t bytes, const std::string& announced, const char* start) const;

  /// Moves to the line of record `index` of `count`, or throws an error that names the missing
  /// record.
  void next_record(std::string_view what, std::uint32_t index, std::uint32_t count);
  /// Begins the same record where the cursor is, which may be in the middle of a line.
  void begin_record(std::string_view what, std::uint32_t index);
  /// Returns the name of the record that was begun last, such as "face 3", numbered from 1.
  std::string record_name() const;

  /// Reads the next number of the line; throws "face 3 needs NEEDS" if there is none.
  void read_number(ReadNumber& number, std::string_view needs);
  /// Does the same, but takes nothing and returns false if the number is not finite.
  bool read_number_if_finite(ReadNumber& number, std::string_view needs);
  /// Reads two numbers x y and the end of the line, and appends the point; exact numbers are
  /// charged.
  void read_point(PointTable2& points);
  /// Returns the number of a `what`: in the text `lowest` to `count`, with a `lowest` of 0 or 1.
  std::uint32_t read_id(std::string_view what, std::uint32_t count, std::uint32_t lowest = 1);
  /// Does the same for `count` of them numbered from 0.
  std::uint32_t read_index(std::string_view what, std::uint32_t count);
  /// Throws with `expected` if the line goes on.
  void end_line(const std::string& expected);

 private:
  std::uint32_t read_long_id(std::string_view token, std::string_view what) const;

  TextCursor cursor_;
  NumberReader numbers_;
  Context& context_;
  std::size_t total_bytes_;
  std::string_view contents_;
  std::string_view record_;
  std::uint32_t record_index_ = 0;
  ReadNumber x_;
  ReadNumber y_;
};

}  // namespace plumb
