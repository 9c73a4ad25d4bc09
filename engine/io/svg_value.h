// What stands in attributes of SVG: numbers, lengths, flags, words, with the place of every error.
#pragma once

#include <string>
#include <string_view>
#include <utility>

#include "plumb/io/number_reader.h"
#include "plumb/io/text_cursor.h"

namespace plumb {

/// Walks the value of an attribute. Numbers are separated by blanks, by a comma among them, or by nothing where a
/// sign or a second point tells them apart.
class SvgValue {
 public:
  /// `cursor` stands at the value.
  SvgValue(TextCursor cursor, std::string_view value, NumberReader& numbers)
      : start_(cursor), cursor_(std::move(cursor)), rest_(value), numbers_(numbers) {}

  /// Skips blanks; true when nothing follows. Fails where a comma has promised more.
  bool at_end();
  /// The next byte, if there is one. Call at_end() first.
  char peek() const { return rest_.empty() ? '\0' : rest_.front(); }
  const char* position() const { return rest_.data(); }
  /// Past a byte that is no number.
  void skip();

  /// A finite number, and what separates it from the next.
  double number();
  /// The same with a unit: px is none, in, cm, mm, pt, pc are converted, others fail.
  double length();
  /// One digit, 0 or 1, which needs no separator.
  bool flag();
  /// A word of letters.
  std::string_view word();
  void take(char c);

  [[noreturn]] void fail(ErrorCode code, const std::string& message, const char* where) const;
  [[noreturn]] void fail_expected(const std::string& what) const;
  /// At the number read last.
  const TextCursor& cursor() const { return cursor_; }

 private:
  double number_alone();
  void skip_separator();
  void skip_blanks();

  TextCursor start_;
  TextCursor cursor_;
  std::string_view rest_;
  NumberReader& numbers_;
  const char* comma_ = nullptr;  // the separator before the position, if it has one
  ReadNumber number_;
};

}  // namespace plumb
