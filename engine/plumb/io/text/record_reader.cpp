// Numbers from text, and records of lines.
//
// An ordinary number is read by std::from_chars in one scan, which rounds to nearest. Every other
// number is first split into its parts (Decimal), its size is bounded by its digits and exponent
// (Magnitude), and only if that is within limits is it given to GMP, as an integer times a power of
// ten, and rounded exactly. So reading costs time in proportion to the bytes read, plus a bounded
// account of digits that exponents expand to. Rules and limits: docs/formats.md, section Numbers in
// text. Tested by tests/io/map_io_test.cpp and tests/io/off_test.cpp.
#include "plumb/io/text/record_reader.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <string>
#include <system_error>
#include <utility>

#include "plumb/io/text/double_text.h"
#include "plumb/predicates/error.h"
#include "plumb/predicates/rounding.h"

namespace plumb {
namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }

bool all_digits(std::string_view text) {
  return !text.empty() && std::all_of(text.begin(), text.end(), is_digit);
}

bool is_negative(std::string_view token) { return token.starts_with('-'); }

std::string_view without_sign(std::string_view token) {
  if (token.starts_with('-') || token.starts_with('+')) token.remove_prefix(1);
  return token;
}

/// Returns the value of digits. The value of an empty text is zero.
Integer to_integer(std::string_view digits) {
  digits.remove_prefix(std::min(digits.find_first_not_of('0'), digits.size()));
  Integer value;
  if (!digits.empty()) mpz_set_str(value.mpz(), std::string(digits).c_str(), 10);
  return value;
}

Integer power_of_ten(std::uint32_t exponent) {
  Integer value;
  mpz_ui_pow_ui(value.mpz(), 10, exponent);
  return value;
}

/// A decimal number that is split into its parts. Its value has not been computed.
struct Decimal {
  std::string_view whole;
  std::string_view fraction;
  std::int64_t exponent = 0;  // The written exponent, clamped to +-kFarExponent.
  bool well_formed = false;
};

constexpr std::int64_t kFarExponent = 1'000'000'000'000;

/// Parses "[+-]digits", which is not empty. A number with more digits than an int64 holds is
/// clamped, because every limit is smaller.
bool parse_exponent(std::string_view text, std::int64_t& exponent) {
  const std::string_view digits = without_sign(text);
  if (!all_digits(digits)) return false;
  const auto result = std::from_chars(digits.data(), digits.data() + digits.size(), exponent);
  if (result.ec == std::errc::result_out_of_range) exponent = kFarExponent;
  exponent = std::min(exponent, kFarExponent);
  if (is_negative(text)) exponent = -exponent;
  return true;
}

Decimal take_apart(std::string_view token) {
  Decimal decimal;
  std::string_view body = without_sign(token);
  if (const std::size_t e = body.find_first_of("eE"); e != body.npos) {
    if (!parse_exponent(body.substr(e + 1), decimal.exponent)) return decimal;
    body = body.substr(0, e);
  }
  const std::size_t point = body.find('.');
  decimal.whole = body.substr(0, point);
  if (point != body.npos) decimal.fraction = body.substr(point + 1);
  const bool whole_fits = decimal.whole.empty() || all_digits(decimal.whole);
  const bool fraction_fits = decimal.fraction.empty() || all_digits(decimal.fraction);
  decimal.well_formed =
      whole_fits && fraction_fits && !(decimal.whole.empty() && decimal.fraction.empty());
  return decimal;
}

struct Magnitude {
  bool zero = true;
  std::int64_t exponent = 0;  // |value| lies in [10^(exponent-1), 10^exponent).
};

Magnitude magnitude(const Decimal& decimal) {
  const auto whole_size = static_cast<std::int64_t>(decimal.whole.size());
  if (const auto i = decimal.whole.find_first_not_of('0'); i != std::string_view::npos) {
    return {false, whole_size - static_cast<std::int64_t>(i) + decimal.exponent};
  }
  if (const auto i = decimal.fraction.find_first_not_of('0'); i != std::string_view::npos) {
    return {false, decimal.exponent - static_cast<std::int64_t>(i)};
  }
  return {};
}

/// Returns the power of ten by which the integer of all digits is multiplied.
std::int64_t shift_of(const Decimal& decimal) {
  return decimal.exponent - static_cast<std::int64_t>(decimal.fraction.size());
}

/// Returns the exact value. Requires that there are only few digits, and that the shift is small.
Rational exact_value(const Decimal& decimal, bool is_negative) {
  const std::int64_t shift = shift_of(decimal);
  Integer digits = to_integer(std::string(decimal.whole).append(decimal.fraction));
  if (is_negative) digits.negate();
  const Integer power = power_of_ten(static_cast<std::uint32_t>(std::abs(shift)));
  return shift >= 0 ? Rational(Integer(digits * power)) : Rational(digits, power);
}

/// Returns the nearest double. It is infinite if the value exceeds all doubles.
double nearest_value(const Decimal& decimal, bool is_negative) {
  constexpr std::int64_t kBeyond = 330;  // 10^330 and 10^-330 are neither doubles nor next to one.
  const Magnitude size = magnitude(decimal);
  if (size.zero) return is_negative ? -0.0 : 0.0;
  if (size.exponent > kBeyond) return std::numeric_limits<double>::infinity();
  if (size.exponent < -kBeyond) return 0;
  return nearest_double(exact_value(decimal, is_negative));
}

constexpr std::string_view kNumber = "a number";

/// Throws the error for a token that is not a number. If the number has another notation, the error
/// has a hint.
[[noreturn]] void fail_number(const TextCursor& cursor, std::string_view token) {
  constexpr std::string_view kDigits = "+-0123456789";
  const std::size_t mark = token.find_first_not_of(kDigits);
  const bool begins_like_one = mark != token.npos && token.find_first_of("0123456789") < mark;
  const auto ends_like_one = [&](std::size_t from) {
    return token.find_first_not_of(".0123456789eE+-", from) == token.npos;
  };
  if (begins_like_one && token[mark] == ',' && ends_like_one(mark + 1)) {
    cursor.fail(ErrorCode::Syntax,
                "expected " + std::string(kNumber) + ", found " + quoted(token) +
                    "; decimals have a point, and blanks separate numbers",
                token.data());
  }
  const std::size_t exponent = token.find_first_of("dD");
  if (begins_like_one && exponent != token.npos && exponent > mark - 1 &&
      ends_like_one(exponent + 1)) {
    cursor.fail(ErrorCode::Syntax,
                "expected " + std::string(kNumber) + ", found " + quoted(token) +
                    "; exponents begin with e",
                token.data());
  }
  cursor.fail_token(token, kNumber);
}

}  // namespace

bool starts_not_finite(std::string_view text) {
  constexpr std::array<std::string_view, 7> kSpellings{"nan", "NaN", "NAN", "inf",
                                                       "Inf", "INF", "1.#"};
  if (text.starts_with('-') || text.starts_with('+')) text.remove_prefix(1);
  return std::ranges::any_of(kSpellings, [&](auto spelling) { return text.starts_with(spelling); });
}

void ReadNumber::set(Rational value) {
  exact_ = std::move(value);
  is_double_ = false;
}

/// The table stores x and y over a common denominator: three integers, each at most as long as a
/// numerator and the other's denominator together.
std::size_t exact_bytes(const ReadNumber& x, const ReadNumber& y) {
  if (x.is_double() && y.is_double()) return 0;
  const auto limbs = [](const Rational& q) {
    return mpz_size(mpq_numref(q.mpq())) + mpz_size(mpq_denref(q.mpq()));
  };
  constexpr std::size_t kEntryBytes = 32;
  return kEntryBytes + 2 * sizeof(mp_limb_t) * (limbs(x.exact()) + limbs(y.exact()));
}

void push_point(PointTable2& points, const ReadNumber& x, const ReadNumber& y) {
  if (x.is_double() && y.is_double()) {
    points.push_back({x.as_double(), y.as_double()});
  } else {
    points.push_back(x.exact(), y.exact());
  }
}

namespace {

constexpr std::uint32_t kDigitsOfResults = 16'384;

std::uint32_t digits_at_most(const Limits& limits, bool are_results) {
  return std::max(limits.max_number_digits, are_results ? kDigitsOfResults : 0);
}

}  // namespace

NumberReader::NumberReader(const Context& context, bool exact_decimals, std::size_t file_bytes,
                           ResultNumbers results)
    : context_(context),
      max_digits_(digits_at_most(context.limits(), results == ResultNumbers::All)),
      max_fraction_digits_(digits_at_most(context.limits(), results != ResultNumbers::None)),
      max_exponent_(context.limits().max_decimal_exponent),
      exact_decimals_(exact_decimals),
      expansion_left_(4 * static_cast<std::uint64_t>(file_bytes) + 24'000'000) {}

/// Reading long numbers takes more time than is proportional to their bytes.
void NumberReader::watch(std::size_t bytes) {
  constexpr std::size_t kBytesPerCheckpoint = std::size_t{1} << 16;
  bytes_unchecked_ += bytes;
  if (bytes_unchecked_ < kBytesPerCheckpoint) return;
  bytes_unchecked_ = 0;
  context_.check_limits("read");
}

void NumberReader::require_few_digits(const TextCursor& cursor, std::string_view token) const {
  constexpr std::size_t kOthers = 8;  // A sign, a point and an exponent.
  if (token.size() <= max_digits_ + kOthers) return;
  const bool is_fraction = token.find('/') != token.npos;
  const std::uint32_t most = is_fraction ? max_fraction_digits_ : max_digits_;
  if (token.size() <= most + kOthers) return;
  cursor.fail(ErrorCode::NumberOutOfRange,
              "a number of " + std::to_string(token.size()) + " characters; at most " +
                  std::to_string(most) + " digits are read",
              token.data());
}

void NumberReader::read(const TextCursor& cursor, std::string_view token, ReadNumber& number) {
  require_few_digits(cursor, token);
  watch(token.size());
  if (all_digits(without_sign(token))) return read_integer(token, number);
  if (const std::size_t slash = token.find('/'); slash != token.npos) {
    return read_fraction(cursor, token, slash, number);
  }
  return exact_decimals_ ? read_exact_decimal(cursor, token, number)
                         : read_nearest(cursor, token, number);
}

/// Takes an integer that is a double, or a decimal that is to be rounded, of up to kMost
/// characters, and returns true. Otherwise returns false and changes nothing.
bool NumberReader::read_ordinary(TextCursor& cursor, ReadNumber& number) const {
  constexpr std::size_t kMost = 32;
  constexpr std::size_t kExact = 15;  // Integers with so many digits are doubles.
  if (exact_decimals_) return false;
  const std::string_view rest = cursor.rest().substr(0, kMost);
  double value = 0;
  const auto [end, code] = double_from_chars(rest.data(), rest.data() + rest.size(), value);
  const auto size = static_cast<std::size_t>(end - rest.data());
  // The function from_chars also accepts "inf" and "nan".
  if (code != std::errc() || !std::isfinite(value)) return false;
  if (size < rest.size() ? !TextCursor::ends_token(*end) : size == kMost) return false;
  if (size > kExact && rest.substr(0, size).find('.') == rest.npos) return false;
  number.set(value);
  cursor.skip(size);
  return true;
}

void NumberReader::read_integer(std::string_view token, ReadNumber& number) const {
  // All these integers are doubles, because 10^15 < 2^53.
  constexpr std::size_t kDoubleDigits = 15;
  const std::string_view digits = without_sign(token);
  if (digits.size() <= kDoubleDigits) {
    std::int64_t value = 0;
    std::from_chars(digits.data(), digits.data() + digits.size(), value);
    return number.set(static_cast<double>(is_negative(token) ? -value : value));
  }
  Integer value = to_integer(digits);
  if (is_negative(token)) value.negate();
  number.set(Rational(value));
}

void NumberReader::read_fraction(const TextCursor& cursor, std::string_view token,
                                 std::size_t slash, ReadNumber& number) const {
  const std::string_view above = without_sign(token.substr(0, slash));
  const std::string_view below = token.substr(slash + 1);
  if (!all_digits(above) || !all_digits(below)) fail_number(cursor, token);
  Integer denominator = to_integer(below);
  if (denominator == 0) {
    cursor.fail(ErrorCode::NumberOutOfRange, "the denominator is 0", below.data());
  }
  Integer numerator = to_integer(above);
  if (is_negative(token)) numerator.negate();
  number.set(Rational(numerator, denominator));
}

void NumberReader::read_nearest(const TextCursor& cursor, std::string_view token,
                                ReadNumber& number) const {
  // Longer numbers are rare.
  constexpr std::size_t kMost = 64;
  // The function from_chars does not accept a plus sign. The text "+-1" must not become "-1".
  const bool has_plus = token.starts_with('+') && !token.starts_with("+-");
  const std::string_view text = token.substr(has_plus ? 1 : 0);
  double value = 0;
  if (text.size() <= kMost) {
    const char* const last = text.data() + text.size();
    const auto [end, code] = double_from_chars(text.data(), last, value);
    const bool complete = end == last;
    // The function from_chars also accepts "inf" and "nan". These values are not finite, so they
    // are processed below.
    if (complete && code == std::errc() && std::isfinite(value)) return number.set(value);
  }
  const Decimal decimal = take_apart(token);
  if (!decimal.well_formed) fail_number(cursor, token);
  value = nearest_value(decimal, is_negative(token));
  if (!std::isfinite(value)) {
    cursor.fail(ErrorCode::NumberOutOfRange, quoted(token) + " is larger than the largest double",
                token.data());
  }
  number.set(value);
}

void NumberReader::read_exact_decimal(const TextCursor& cursor, std::string_view token,
                                      ReadNumber& number) {
  const Decimal decimal = take_apart(token);
  if (!decimal.well_formed) fail_number(cursor, token);
  if (magnitude(decimal).zero) return number.set(0.0);
  const std::uint64_t distance = static_cast<std::uint64_t>(std::abs(shift_of(decimal)));
  const std::size_t digit_count = decimal.whole.size() + decimal.fraction.size();
  const bool is_far = static_cast<std::uint64_t>(std::abs(decimal.exponent)) > max_exponent_;
  // Checks the numerator and the denominator together, so that the number can be written as p/q and
  // read again.
  if (is_far || digit_count + distance >= max_digits_) {
    cursor.fail(ErrorCode::NumberOutOfRange,
                "written out, " + quoted(token) + " has more than " + std::to_string(max_digits_) +
                    " digits",
                token.data());
  }
  if (distance > expansion_left_) {
    cursor.fail(ErrorCode::ResourceLimit,
                "the exact decimals of this file expand to too many digits", token.data());
  }
  expansion_left_ -= distance;
  number.set(exact_value(decimal, is_negative(token)));
}

namespace {

constexpr std::size_t kLinesPerCheckpoint = 4096;

}  // namespace

RecordReader::RecordReader(std::string_view text, const ReadOptions& options, Context& context,
                           std::string_view contents, ResultNumbers results)
    : cursor_(text, options.name, &context),
      numbers_(context, options.exact_decimals, text.size(), results),
      context_(context),
      total_bytes_(text.size()),
      contents_(contents) {}

void RecordReader::charge(std::uint64_t bytes) {
  try {
    context_.charge_memory(bytes, contents_);
  } catch (const Error& error) {
    cursor_.fail(error.code(), error.message());
  }
}

void RecordReader::read_magic(std::string_view magic, std::string_view version) {
  const std::string line = std::string(magic) + ' ' + std::string(version);
  const bool has_content = cursor_.next_line();
  if (!has_content || cursor_.line() != 1 || cursor_.token() != magic) {
    cursor_.fail(ErrorCode::Syntax, "the first line is not '" + line + "'",
                 has_content && cursor_.line() == 1 ? cursor_.line_start() : nullptr);
  }
  const std::string_view found = cursor_.at_line_end() ? std::string_view() : cursor_.token();
  if (found != version) {
    cursor_.fail(
        ErrorCode::UnknownFormat,
        "version " + quoted(found) + " of the format; this program reads " + std::string(version));
  }
  end_line("the end of the line after '" + line + "'");
}

std::uint32_t RecordReader::read_count(std::string_view what) {
  if (cursor_.at_line_end()) {
    cursor_.fail(ErrorCode::Syntax,
                 "expected " + std::string(what) + ", found the end of the line");
  }
  const std::string_view token = cursor_.token();
  std::uint64_t value = 0;
  const auto [end, code] = std::from_chars(token.data(), token.data() + token.size(), value);
  if (end != token.data() + token.size()) {
    cursor_.fail_token(token, std::string(what) + " (0 or more, digits only)");
  }
  if (code != std::errc() || value > kMostIds) {
    cursor_.fail(ErrorCode::CountMismatch,
                 quoted(token) + ": at most " + std::to_string(kMostIds) + " are possible",
                 token.data());
  }
  return static_cast<std::uint32_t>(value);
}

void RecordReader::require_bytes(std::uint64_t bytes, const std::string& announced,
                                 const char* start) const {
  // The line break of the last line may be missing.
  if (bytes <= std::uint64_t{cursor_.bytes_left()} + 1) return;
  cursor_.fail(ErrorCode::CountMismatch,
               announced + " are announced, but the file is too short for them", start);
}

void RecordReader::begin_record(std::string_view what, std::uint32_t index) {
  record_ = what;
  record_index_ = index;
  if (index % kLinesPerCheckpoint == 0) {
    context_.checkpoint("read", cursor_.bytes_read(), total_bytes_);
  }
}

void RecordReader::next_record(std::string_view what, std::uint32_t index, std::uint32_t count) {
  begin_record(what, index);
  if (cursor_.next_line()) return;
  cursor_.fail(ErrorCode::CountMismatch, "the file ends where " + record_name() + " of " +
                                             std::to_string(count) + " is expected");
}

std::string RecordReader::record_name() const {
  return std::string(record_) + ' ' + std::to_string(std::uint64_t{record_index_} + 1);
}

void RecordReader::read_number(ReadNumber& number, std::string_view needs) {
  if (!read_number_if_finite(number, needs)) numbers_.read_next(cursor_, number);
}

bool RecordReader::read_number_if_finite(ReadNumber& number, std::string_view needs) {
  if (cursor_.at_line_end()) {
    cursor_.fail(ErrorCode::Syntax, record_name() + " needs " + std::string(needs));
  }
  std::uint32_t small = 0;
  if (!cursor_.short_number(small)) return numbers_.read_next_if_finite(cursor_, number, {});
  number.set(small);
  return true;
}

void RecordReader::read_point(PointTable2& points) {
  for (ReadNumber* number : {&x_, &y_}) read_number(*number, "two numbers, x and y");
  if (!cursor_.at_line_end()) {
    end_line("the end of the line after the two numbers of " + record_name());
  }
  if (const std::size_t bytes = exact_bytes(x_, y_)) charge(bytes);
  push_point(points, x_, y_);
}

std::uint32_t RecordReader::read_id(std::string_view what, std::uint32_t count,
                                    std::uint32_t lowest) {
  if (cursor_.at_line_end()) {
    cursor_.fail(ErrorCode::Syntax, record_name() + " needs the number of a " + std::string(what));
  }
  const char* const start = cursor_.position();
  std::uint32_t id = 0;
  if (!cursor_.short_number(id)) id = read_long_id(cursor_.token(), what);
  if (lowest <= id && id <= count) return id;
  const std::string_view token(start, static_cast<std::size_t>(cursor_.position() - start));
  cursor_.fail(ErrorCode::BadIndex,
               record_name() + " names " + std::string(what) + ' ' + quoted(token) +
                   "; ids run from " + std::to_string(lowest) + " to " + std::to_string(count),
               start);
}

std::uint32_t RecordReader::read_index(std::string_view what, std::uint32_t count) {
  if (count > 0) return read_id(what, count - 1, 0);
  cursor_.fail(ErrorCode::BadIndex,
               record_name() + " names a " + std::string(what) + "; there are none");
}

/// Reads ids of any length. An id that is too long, or negative, becomes one beyond every range.
std::uint32_t RecordReader::read_long_id(std::string_view token, std::string_view what) const {
  constexpr std::uint32_t kBeyond = kMostIds + 1;
  const std::string_view digits = token.substr(token.starts_with('-') ? 1 : 0);
  std::uint32_t id = 0;
  const auto [end, code] = std::from_chars(digits.data(), digits.data() + digits.size(), id);
  if (end != digits.data() + digits.size()) {
    cursor_.fail_token(token, "a " + std::string(what) + " id");
  }
  return code == std::errc() && digits.size() == token.size() ? id : kBeyond;
}

void RecordReader::end_line(const std::string& expected) {
  if (!cursor_.at_line_end()) cursor_.fail_token(cursor_.token(), expected);
}

}  // namespace plumb
