#include "number_argument.h"

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
  const std::string exact = format_exact(value);
  return exact.size() <= kLongest ? exact : decimal_text(value, kDigits) + " (rounded)";
}

}  // namespace plumb::cli
