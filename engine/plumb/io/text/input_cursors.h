// Two cursors, which read input from the beginning to the end. TextCursor reads the lines and
// tokens of a text. BinaryInput reads the binary part of a file. Each error that a cursor throws
// contains a position in the input. Rules for texts:
//   - Lines end with LF or CRLF. Blanks are spaces and tabs.
//   - Blank lines are skipped. A line is a comment if its first character other than a blank is
//     '#'. Comments are skipped, too.
//   - Comments may have any encoding that is compatible with ASCII. They must not contain control
//     characters.
//   - A byte order mark at the start is skipped.
//   - Columns are counted in bytes, starting at 1.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>

#include "plumb/io/text/byte_order.h"
#include "plumb/predicates/error.h"

#pragma GCC visibility push(default)
namespace plumb {

class Context;

/// Reads the lines and tokens of a text.
class TextCursor {
 public:
  /// Starts before the first line of `text`. Requires that the bytes of `text` outlive the cursor.
  /// `name` is the name of the file in messages. The limits of `context`, which may be null, are
  /// checked inside long tokens.
  TextCursor(std::string_view text, std::string name, const Context* context = nullptr);

  /// Moves to the first token of the next line that has a token. Returns false at the end of the
  /// text. Requires that the current line is finished (at_line_end()).
  bool next_line();

  /// Skips blanks. Returns true if the current line has no more tokens.
  bool at_line_end() {
    while (p_ != end_ && (*p_ == ' ' || *p_ == '\t')) ++p_;
    return p_ == end_ || *p_ == '\n' || (*p_ == '\r' && skip_carriage_return());
  }

  /// Skips blanks, and a comment that follows them on the same line. Returns true if the current
  /// line has no more tokens. This function is for formats in which a comment may end a line.
  bool at_line_end_or_comment() {
    if (at_line_end()) return true;
    if (*p_ != '#') return false;
    skip_comment();
    return true;
  }

  /// Moves to the next token, on this line or on a later one. Comments may end lines. Returns false
  /// at the end of the text. This function is for formats whose records need not be lines.
  bool find_token() {
    while (at_line_end_or_comment()) {
      if (!next_line()) return false;
    }
    return true;
  }

  /// Returns the next token. The token ends before the next blank or at the end of the line.
  /// Requires !at_line_end().
  std::string_view token();

  /// Returns the next token in formats with punctuation. Each character in `marks` is a token of
  /// its own. Any other token ends before the next character in `marks`, before the next blank, or
  /// at the end of the line. Requires !at_line_end().
  std::string_view word(std::string_view marks);

  /// Moves to `where` and counts the line breaks on the way. Requires that `where` is at or after
  /// the current position. A parser that does not read line by line calls this function to add a
  /// position to its errors.
  void move_to(const char* where);

  /// Reads a token of 1 to 9 digits into `value` and returns true. If the next token has any other
  /// form, returns false and does not move. The caller must then read the token with token(). This
  /// function is inline because readers call it very often. Requires !at_line_end().
  bool short_number(std::uint32_t& value) {
    const char* q = p_;
    std::uint32_t v = 0;
    while (q != end_ && *q >= '0' && *q <= '9' && q - p_ < 9) {
      v = v * 10 + static_cast<std::uint32_t>(*q++ - '0');
    }
    if (q == p_ || (q != end_ && !ends_token(*q))) return false;
    value = v;
    p_ = q;
    return true;
  }

  const char* position() const { return p_; }
  /// Returns the text from the current position to the end.
  std::string_view rest() const { return {p_, bytes_left()}; }
  /// Skips `bytes` bytes of the line.
  void skip(std::size_t bytes) { p_ += bytes; }
  /// Moves back to `where`. Requires that `where` is a position in the current line, before the
  /// current position.
  void move_back(const char* where) { p_ = where; }
  const char* line_start() const { return line_begin_; }
  std::size_t line() const { return line_; }
  std::size_t bytes_left() const { return static_cast<std::size_t>(end_ - p_); }
  std::size_t bytes_read() const { return static_cast<std::size_t>(p_ - begin_); }

  /// Throws Error{code} with the position `where`. Requires that `where` is a pointer into the
  /// current line, or null. If `where` is null, the error has the current position.
  [[noreturn]] void fail(ErrorCode code, std::string message, const char* where = nullptr) const;

  /// Throws the error for an unexpected `token` of the current line. If a byte of the token is not
  /// text, the error is Error{NotText} at the first such byte. Otherwise the error is Error{Syntax}
  /// with the message "expected WHAT, found 'TOKEN'".
  [[noreturn]] void fail_token(std::string_view token, std::string_view what) const;

  static constexpr bool ends_token(char c) {
    return c == ' ' || c == '\n' || c == '\r' || c == '\t';
  }

 private:
  bool skip_carriage_return();
  void skip_comment();
  /// Takes the characters before `to`. Throws Error{NotText} if there are none.
  std::string_view take_to(const char* to);
  /// Throws Error{NotText} at the first byte of `text` that is not text. Requires that `text` is a
  /// part of the current line.
  void require_text(std::string_view text) const;

  const char* begin_;
  const char* p_;
  const char* end_;
  const char* line_begin_;
  std::size_t line_ = 0;
  std::string name_;
  const Context* context_;
};

/// Removes `prefix` from the front of `text`. Returns false if `text` does not start with `prefix`.
inline bool take_prefix(std::string_view& text, std::string_view prefix) {
  if (!text.starts_with(prefix)) return false;
  text.remove_prefix(prefix.size());
  return true;
}

/// Whether the lines of `text` end with CR alone. Some old programs write such texts. The first
/// line break decides. For such a text, pass with_line_feeds() of the text to TextCursor.
bool ends_lines_with_cr(std::string_view text);
/// Returns a copy of `text` in which each CR among the first `length` bytes is replaced by LF.
std::string with_line_feeds(std::string_view text, std::size_t length);

/// Returns the length of the longest prefix of `text` that is valid UTF-8 and has no control
/// characters except tabs.
std::size_t text_prefix(std::string_view text);

/// Returns `token` in quotes, for a message. The quoted text ends before the first control
/// character of the token. It has at most 32 bytes. A longer token is cut between two characters.
std::string quoted(std::string_view token);

// The cursor over the binary part of a file.

/// Reads numbers of fixed size, in either byte order, from the binary part of a file.
class BinaryInput {
 public:
  /// Starts at byte `start` of the file with the contents `bytes`. Requires that `bytes` outlives
  /// this object. `name` is the name of the file in messages.
  BinaryInput(std::string_view bytes, std::size_t start, std::endian order, std::string name)
      : bytes_(bytes), at_(start), order_(order), name_(std::move(name)) {}

  std::size_t position() const { return at_; }
  std::size_t bytes_read() const { return at_; }
  std::size_t bytes_left() const { return bytes_.size() - at_; }

  /// Changes the byte order of the numbers that follow.
  void set_order(std::endian order) { order_ = order; }

  /// Skips bytes. Requires that `bytes` is at most bytes_left().
  void skip(std::size_t bytes) { at_ += bytes; }

  /// Returns the next integer or floating-point number. Requires that sizeof(Number) is at most
  /// bytes_left().
  template <class Number>
  Number take() {
    const auto number = from_bytes<Number>(bytes_.data() + at_, order_);
    at_ += sizeof(Number);
    return number;
  }

  /// Throws Error{code} with the text "FILE: at byte N: message". N is counted from 0.
  [[noreturn]] void fail(ErrorCode code, const std::string& message, std::size_t at) const {
    throw Error(code, "at byte " + std::to_string(at) + ": " + message, {name_});
  }
  [[noreturn]] void fail(ErrorCode code, const std::string& message) const {
    fail(code, message, at_);
  }

 private:
  std::string_view bytes_;
  std::size_t at_;
  std::endian order_;
  std::string name_;
};

// Every error of a reader must have a position. But code that checks a limit throws an error
// without a position. The following code adds a position to such errors.

/// Throws errors that concern a whole file. Their position is the name of the file.
struct WholeFile {
  const std::string& name;
  [[noreturn]] void fail(ErrorCode code, const std::string& message) const {
    throw Error(code, message, {name});
  }
};

/// Returns `read()`. If `read()` throws Error{ResourceLimit} without a position, this function
/// throws the same error with the current position of `in`. The type of `in` is TextCursor,
/// BinaryInput or WholeFile.
template <class Input, class Read>
auto with_place(const Input& in, Read read) {
  try {
    return read();
  } catch (const Error& error) {
    if (error.code() != ErrorCode::ResourceLimit || !error.place().file.empty()) throw;
    in.fail(error.code(), error.message());
  }
}

}  // namespace plumb
#pragma GCC visibility pop
