// TextCursor: lines, tokens and places of a text, and the definition of text.
//
// Tokens are found byte by byte, without a check of their characters; only when a token is reported
// is it validated, so good input is read at full speed and an error still names the first byte that
// is not text (UTF-8 by RFC 3629, without control characters but tab). Invariant: the position lies
// in the line that line_begin_ starts, so a column is a difference of pointers.
// Tested by tests/io/map_io_test.cpp and tests/io/off_test.cpp.
#include "plumb/io/text/input_cursors.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdint>
#include <cstring>
#include <utility>

#include "plumb/io/text/watched_scan.h"

namespace plumb {
namespace {

constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

unsigned byte_at(std::string_view text, std::size_t i) {
  return static_cast<unsigned char>(text[i]);
}

/// Returns the length of the well-formed UTF-8 sequence at the start of `text` (RFC 3629: no
/// overlong forms, no surrogates, nothing above U+10FFFF), or 0 if there is none. Requires a first
/// byte >= 0x80.
std::size_t sequence_length(std::string_view text) {
  const unsigned lead = byte_at(text, 0);
  const std::size_t length = lead < 0xC2   ? 0
                             : lead < 0xE0 ? 2
                             : lead < 0xF0 ? 3
                             : lead < 0xF5 ? 4
                                           : 0;
  if (length == 0 || text.size() < length) return 0;
  for (std::size_t i = 1; i < length; ++i) {
    if ((byte_at(text, i) & 0xC0U) != 0x80U) return 0;
  }
  const unsigned second = byte_at(text, 1);
  const bool wrong = (lead == 0xE0 && second < 0xA0) || (lead == 0xED && second > 0x9F) ||
                     (lead == 0xF0 && second < 0x90) || (lead == 0xF4 && second > 0x8F);
  return wrong ? 0 : length;
}

std::string hex_byte(unsigned byte) {
  constexpr std::string_view kDigits = "0123456789abcdef";
  return {'0', 'x', kDigits[byte >> 4U], kDigits[byte & 15U]};
}

}  // namespace

std::size_t text_prefix(std::string_view text) {
  std::size_t i = 0;
  while (i < text.size()) {
    const unsigned byte = byte_at(text, i);
    const bool plain = (byte >= 0x20 && byte < 0x7F) || byte == '\t';
    const std::size_t length = plain ? 1 : byte < 0x80 ? 0 : sequence_length(text.substr(i));
    if (length == 0) return i;
    i += length;
  }
  return i;
}

bool ends_lines_with_cr(std::string_view text) {
  const std::size_t end = text.find_first_of("\r\n");
  return end != text.npos && text[end] == '\r' && text.substr(end + 1, 1) != "\n";
}

std::string with_line_feeds(std::string_view text, std::size_t length) {
  std::string copy(text);
  std::replace(copy.begin(), copy.begin() + static_cast<std::ptrdiff_t>(length), '\r', '\n');
  return copy;
}

std::string quoted(std::string_view token) {
  constexpr std::size_t kMost = 32;
  const std::size_t shown = text_prefix(token.substr(0, kMost));
  const bool whole = shown == token.size();
  token = token.substr(0, shown);
  std::string text("'");
  text.append(token).append(whole ? "'" : "...'");
  return text;
}

TextCursor::TextCursor(std::string_view text, std::string name, const Context* context)
    : begin_(text.data()),
      p_(begin_),
      end_(begin_ + text.size()),
      line_begin_(begin_),
      name_(std::move(name)),
      context_(context) {
  if (text.starts_with(kByteOrderMark)) p_ += kByteOrderMark.size();
}

bool TextCursor::next_line() {
  for (;;) {
    if (line_ != 0) {
      if (p_ == end_) return false;
      ++p_;  // The '\n' that ended the previous line.
      line_begin_ = p_;
    }
    ++line_;
    if (at_line_end()) continue;
    if (*p_ != '#') return true;
    skip_comment();
  }
}

namespace {

/// Returns the first character for which `ends` holds, or `end`.
template <class Ends>
const char* end_of_token(const char* p, const char* end, const Context* context, Ends ends) {
  return context == nullptr ? std::find_if(p, end, ends) : find_watched(p, end, *context, ends);
}

}  // namespace

std::string_view TextCursor::take_to(const char* to) {
  const char* const first = p_;
  p_ = to;
  if (p_ == first) fail(ErrorCode::NotText, "a carriage return inside a line");
  return {first, static_cast<std::size_t>(p_ - first)};
}

std::string_view TextCursor::token() {
  return take_to(end_of_token(p_, end_, context_, ends_token));
}

std::string_view TextCursor::word(std::string_view marks) {
  // The code is a loop, because std::string_view::find() calls a function for each character.
  const auto is_mark = [&](char c) {
    for (const char mark : marks) {
      if (c == mark) return true;
    }
    return false;
  };
  if (is_mark(*p_)) return {p_++, 1};
  const auto ends_word = [&](char c) { return ends_token(c) || is_mark(c); };
  return take_to(end_of_token(p_, end_, context_, ends_word));
}

void TextCursor::move_to(const char* where) {
  line_ = std::max<std::size_t>(line_, 1);
  while (const void* found = std::memchr(p_, '\n', static_cast<std::size_t>(where - p_))) {
    p_ = static_cast<const char*>(found) + 1;
    line_begin_ = p_;
    ++line_;
  }
  p_ = where;
}

/// Skips a carriage return at the end of the line, which belongs to the end of the line.
bool TextCursor::skip_carriage_return() {
  if (p_ + 1 != end_ && p_[1] != '\n') return false;
  ++p_;
  return true;
}

void TextCursor::skip_comment() {
  const char* const line_end = std::find(p_, end_, '\n');
  const char* last = line_end;
  if (last != p_ && last[-1] == '\r') --last;
  const char* const control = std::find_if(p_, last, [](char c) {
    return (static_cast<unsigned char>(c) < 0x20 && c != '\t') || c == 0x7F;
  });
  if (control != last) require_text({control, 1});
  p_ = line_end;
}

void TextCursor::require_text(std::string_view text) const {
  const std::size_t good = text_prefix(text);
  if (good == text.size()) return;
  const unsigned byte = byte_at(text, good);
  fail(ErrorCode::NotText,
       "byte " + hex_byte(byte) + (byte < 0x80 ? " is a control character" : " is not UTF-8") +
           ": is this a text file?",
       text.data() + good);
}

void TextCursor::fail(ErrorCode code, std::string message, const char* where) const {
  if (where == nullptr) where = p_;
  // At the end of a text that ends with a line break, the place is the line after the line break.
  const auto column = static_cast<std::size_t>(where - line_begin_) + 1;
  throw Error(code, std::move(message), {name_, std::max<std::size_t>(line_, 1), column});
}

void TextCursor::fail_token(std::string_view token, std::string_view what) const {
  require_text(token);
  fail(ErrorCode::Syntax, "expected " + std::string(what) + ", found " + quoted(token),
       token.data());
}

}  // namespace plumb
