#include "plumb/io/half_space_reader.h"

#include <array>

#include "plumb/base/error.h"
#include "plumb/io/number_reader.h"
#include "plumb/io/text_cursor.h"

namespace plumb {
namespace {

Boundary read_boundary(TextCursor& cursor) {
  if (cursor.at_line_end()) cursor.fail(ErrorCode::Syntax, "expected closed or open");
  const char* const begin = cursor.position();
  const std::string_view word = cursor.token();
  if (word == "closed") return Boundary::Closed;
  if (word == "open") return Boundary::Open;
  cursor.fail(ErrorCode::Syntax, "expected closed or open, found " + quoted(word), begin);
}

HalfSpace3 read_line(TextCursor& cursor, NumberReader& numbers) {
  const char* const begin = cursor.position();
  std::array<Rational, 4> row;
  for (Rational& value : row) {
    if (cursor.at_line_end()) {
      cursor.fail(ErrorCode::Syntax, "expected a number: a line is a b c d closed|open");
    }
    ReadNumber number;
    numbers.read_next(cursor, number);
    value = number.exact();
  }
  const Boundary boundary = read_boundary(cursor);
  if (!cursor.at_line_end()) {
    cursor.fail(ErrorCode::Syntax, "nothing may follow on this line");
  }
  if (row[0] == 0 && row[1] == 0 && row[2] == 0) {
    cursor.fail(ErrorCode::DegenerateFace, "a, b and c are all zero: no plane", begin);
  }
  return {{row[0], row[1], row[2], row[3]}, boundary};
}

}  // namespace

std::vector<HalfSpace3> read_half_spaces(std::string_view text, const ReadOptions& options,
                                         Context& context) {
  const RoundToNearest rounding;
  TextCursor cursor(text, options.name);
  NumberReader numbers(context.limits(), options.exact_decimals, text.size());
  MemoryCharge charge(context);
  std::vector<HalfSpace3> half_spaces;
  while (cursor.next_line()) {
    if (half_spaces.size() % 1024 == 0)
      context.checkpoint("read", cursor.bytes_read(), text.size());
    charge.add(sizeof(HalfSpace3), "half-spaces");
    half_spaces.push_back(read_line(cursor, numbers));
  }
  return half_spaces;
}

}  // namespace plumb
