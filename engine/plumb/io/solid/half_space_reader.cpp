#include "plumb/io/solid/half_space_reader.h"

#include <algorithm>
#include <utility>

#include "plumb/io/text/input_cursors.h"
#include "plumb/io/text/record_reader.h"
#include "plumb/predicates/error.h"

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

/// Returns a bound on the number of half-spaces. A line has at least 13 bytes: "0 0 1 0 open" and
/// its end.
std::size_t most_lines(std::string_view text) {
  constexpr std::size_t kLeastBytes = 13;
  const auto breaks = static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
  return std::min(breaks, text.size() / kLeastBytes) + 1;
}

class HalfSpaceReader {
 public:
  HalfSpaceReader(std::string_view text, const ReadOptions& options, Context& context)
      : cursor_(text, options.name, &context),
        numbers_(context, options.exact_decimals, text.size()),
        text_(text),
        context_(context) {}

  HalfSpaceList read() {
    return with_place(cursor_, [this] {
      make_room();
      while (cursor_.next_line()) {
        if (list_.size() % kLinesPerCheckpoint == 0) {
          context_.checkpoint("read", cursor_.bytes_read(), text_.size());
        }
        read_line();
      }
      return std::move(list_);
    });
  }

 private:
  static constexpr std::size_t kLinesPerCheckpoint = 1024;

  void make_room() {
    const std::size_t most = most_lines(text_);
    context_.charge_memory(most * HalfSpaceList::kBytes, "half-spaces");
    list_.reserve(most);
  }

  void read_line() {
    const char* const begin = cursor_.position();
    bool has_normal = false;
    for (int k = 0; k < 4; ++k) {
      if (cursor_.at_line_end()) {
        cursor_.fail(ErrorCode::Syntax, "expected a number: a line is a b c d closed|open");
      }
      numbers_.read_next(cursor_, number_);
      has_normal |=
          k < 3 && (number_.is_double() ? number_.as_double() != 0 : number_.exact() != 0);
      add_number();
    }
    const Boundary boundary = read_boundary(cursor_);
    if (!cursor_.at_line_end()) {
      cursor_.fail(ErrorCode::Syntax, "nothing may follow on this line");
    }
    if (!has_normal) {
      cursor_.fail(ErrorCode::DegenerateFace, "a, b and c are all zero: no plane", begin);
    }
    list_.end(boundary);
  }

  void add_number() {
    if (number_.is_double()) return list_.add_number(number_.as_double());
    Rational exact = number_.exact();
    constexpr std::size_t kEntryBytes = sizeof(std::uint64_t) + sizeof(Rational);
    const mpq_srcptr value = std::as_const(exact).mpq();
    const auto limbs = mpz_size(mpq_numref(value)) + mpz_size(mpq_denref(value));
    context_.charge_memory(kEntryBytes + limbs * sizeof(mp_limb_t), "half-spaces");
    list_.add_number(std::move(exact));
  }

  TextCursor cursor_;
  NumberReader numbers_;
  std::string_view text_;
  Context& context_;
  HalfSpaceList list_;
  ReadNumber number_;
};

}  // namespace

HalfSpaceList read_half_spaces(std::string_view text, const ReadOptions& options,
                               Context& context) {
  const RoundToNearest rounding;
  return HalfSpaceReader(text, options, context).read();
}

}  // namespace plumb
