#include "number_argument.h"

#include <algorithm>
#include <cmath>
#include <string_view>

#include "plumb/base/error.h"
#include "plumb/io/number_reader.h"
#include "plumb/io/text_cursor.h"
#include "plumb/io/text_output.h"
#include "plumb/predicates/rounding.h"

namespace plumb::cli {

Rational read_number_argument(const std::string& text, const std::string& name, Session& session) {
  const RoundToNearest rounding;
  ReadNumber number;
  try {
    TextCursor cursor(text, name);
    const bool is_blank = !cursor.next_line();
    const std::string_view token = is_blank ? std::string_view() : cursor.token();
    if (token.size() != text.size()) {
      throw Error(ErrorCode::Usage, "expected a number, found " + plumb::quoted(text));
    }
    NumberReader numbers(session.context().limits(), session.options().exact_decimals, text.size());
    numbers.read(cursor, token, number);
  } catch (const Error& error) {
    throw Error(ErrorCode::Usage, name + ": " + error.message());
  }
  return number.exact();
}

std::string readable(const Rational& value) {
  constexpr std::size_t kLongest = 60;
  constexpr int kDigits = 17;
  std::string exact = format_exact(value);
  if (exact.size() <= kLongest) return exact;
  const double nearest = nearest_double(value);
  const bool is_ordinary = std::isnormal(nearest);
  const auto digits = std::ranges::count_if(exact, [](char c) { return '0' <= c && c <= '9'; });
  return (is_ordinary ? format_double(nearest) : decimal_text(value, kDigits)) +
         " (rounded; the exact number has " + std::to_string(digits) + " digits, --json has them)";
}

}  // namespace plumb::cli
