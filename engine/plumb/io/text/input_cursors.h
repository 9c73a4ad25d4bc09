// Cursors over input: TextCursor walks a line-oriented text with lines, tokens and the place of
// every error; BinaryInput walks the binary part of a file.
//
// Lines end with LF or CRLF; blanks are spaces and tabs; blank lines and lines whose first
// non-blank is '#' are skipped. Comments must be UTF-8 without control characters. A byte order
// mark at the start is skipped. Columns count bytes, from 1.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <utility>

#include "plumb/predicates/error.h"

#pragma GCC visibility push(default)
namespace plumb {

/// Walks the lines and tokens of a text.
class TextCursor {
 public:
  /// `text` must outlive the cursor; `name` is the file's name in messages.
  TextCursor(std::string_view text, std::string name);

  /// Moves to the first token of the next line that has one; returns false at the end of the text.
  /// Requires that the current line is finished (at_line_end()).
  bool next_line();

  /// Skips blanks; returns true if the current line has no more tokens.
  bool at_line_end() {
    while (p_ != end_ && (*p_ == ' ' || *p_ == '\t')) ++p_;
    return p_ == end_ || *p_ == '\n' || (*p_ == '\r' && skip_carriage_return());
  }

  /// Does the same for formats in which a comment may end a line; the comment is skipped.
  bool at_line_end_or_comment() {
    if (at_line_end()) return true;
    if (*p_ != '#') return false;
    skip_comment();
    return true;
  }

  /// Returns the next token: everything up to a blank or the end of the line. Requires
  /// !at_line_end().
  std::string_view token();

  /// Does the same for formats with punctuation: returns one of `marks`, or everything up to one of
  /// them, a blank or the end of the line. Requires !at_line_end().
  std::string_view word(std::string_view marks);

  /// Moves to `where`, which is not before the position, counting the line breaks between. For
  /// texts that something else parses.
  void move_to(const char* where);

  /// Sets `value` to a token of 1 to 9 digits and returns true; otherwise returns false and
  /// consumes nothing, and token() must be called. A hot path of readers. Requires !at_line_end().
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
  /// Returns all that follows the position.
  std::string_view rest() const { return {p_, bytes_left()}; }
  /// Skips `bytes` bytes of the line.
  void skip(std::size_t bytes) { p_ += bytes; }
  const char* line_start() const { return line_begin_; }
  std::size_t line() const { return line_; }
  std::size_t bytes_left() const { return static_cast<std::size_t>(end_ - p_); }
  std::size_t bytes_read() const { return static_cast<std::size_t>(p_ - begin_); }

  /// Throws Error{code} at `where`, a pointer into the current line (by default the position).
  [[noreturn]] void fail(ErrorCode code, std::string message, const char* where = nullptr) const;

  /// Throws what is wrong with `token`, a token of the current line: NotText at its first byte that
  /// is not text, else Syntax "expected WHAT, found 'TOKEN'".
  [[noreturn]] void fail_token(std::string_view token, std::string_view what) const;

  static constexpr bool ends_token(char c) {
    return c == ' ' || c == '\n' || c == '\r' || c == '\t';
  }

 private:
  bool skip_carriage_return();
  void skip_comment();
  /// Throws Error{NotText} at the first byte of `text` that is not text; `text` lies in this line.
  void require_text(std::string_view text) const;

  const char* begin_;
  const char* p_;
  const char* end_;
  const char* line_begin_;
  std::size_t line_ = 0;
  std::string name_;
};

/// Removes `prefix` from the front of `text`; returns false if it is not there.
inline bool take_prefix(std::string_view& text, std::string_view prefix) {
  if (!text.starts_with(prefix)) return false;
  text.remove_prefix(prefix.size());
  return true;
}

/// Returns the length of the longest prefix of `text` that is UTF-8 without control characters but
/// tab.
std::size_t text_prefix(std::string_view text);

/// Returns `token` as shown in a message: in quotes, shortened to at most 32 bytes at a character
/// boundary, and to what is before a control character.
std::string quoted(std::string_view token);

// Walks the binary part of a file: numbers of fixed size, in either byte order.

/// Walks the binary part of a file: numbers of fixed size, in either byte order.
class BinaryInput {
 public:
  /// Begins at byte `start` of the file. `bytes` must outlive the input; `name` is the file in
  /// messages.
  BinaryInput(std::string_view bytes, std::size_t start, std::endian order, std::string name)
      : bytes_(bytes),
        at_(start),
        is_swapped_(order != std::endian::native),
        name_(std::move(name)) {}

  std::size_t position() const { return at_; }
  std::size_t bytes_left() const { return bytes_.size() - at_; }

  /// Skips bytes. Requires `bytes` <= bytes_left().
  void skip(std::size_t bytes) { at_ += bytes; }

  /// Returns the next integer or floating-point number. Requires sizeof(Number) <= bytes_left().
  template <class Number>
  Number take() {
    char raw[sizeof(Number)];
    std::memcpy(raw, bytes_.data() + at_, sizeof(Number));
    if (is_swapped_) {
      for (std::size_t i = 0; i < sizeof(Number) / 2; ++i) {
        std::swap(raw[i], raw[sizeof(Number) - 1 - i]);
      }
    }
    at_ += sizeof(Number);
    return std::bit_cast<Number>(raw);
  }

  /// Throws "FILE: at byte N: message", with N counted from 0.
  [[noreturn]] void fail(ErrorCode code, const std::string& message, std::size_t at) const {
    throw Error(code, "at byte " + std::to_string(at) + ": " + message, {name_});
  }
  [[noreturn]] void fail(ErrorCode code, const std::string& message) const {
    fail(code, message, at_);
  }

 private:
  std::string_view bytes_;
  std::size_t at_;
  bool is_swapped_;
  std::string name_;
};

// Places for limits that are met where no place is known: every error of a reader has one.

/// The place of errors that concern a file as a whole.
struct WholeFile {
  const std::string& name;
  [[noreturn]] void fail(ErrorCode code, const std::string& message) const {
    throw Error(code, message, {name});
  }
};

/// Returns `read()`. A limit that is met without a place is thrown at that of `in`: a TextCursor, a
/// BinaryInput or a WholeFile.
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
