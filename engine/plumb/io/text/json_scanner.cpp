// Tokens of JSON texts.
//
// The position stands behind the current token. What may come next depends on two things only: the
// innermost open bracket, and whether a bracket, a name or a value stands before the position
// (Before). So the grammar is a few comparisons per token, and nesting costs a bit per bracket
// instead of a call. A skipped value is only searched for quotes and brackets. Its contents have no
// meaning, and in many files they contain words that are not JSON.
// Tested by tests/io/json_scanner_test.cpp.
#include "plumb/io/text/json_scanner.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <nlohmann/json.hpp>
#include <utility>

#include "plumb/io/text/watched_scan.h"

namespace plumb {
namespace {

constexpr std::size_t kStepsPerCheckpoint = 4096;
constexpr char kRecordSeparator = '\x1e';  // The record separator of RFC 8142.

constexpr bool is_blank(char c) { return c == ' ' || c == '\n' || c == '\r' || c == '\t'; }
constexpr bool is_json_digit(char c) { return '0' <= c && c <= '9'; }
constexpr bool is_control(char c) { return static_cast<unsigned char>(c) < 0x20; }
constexpr bool is_mark(char c) {
  return c == ',' || c == ':' || c == '"' || c == '[' || c == ']' || c == '{' || c == '}';
}
constexpr bool is_quote_or_bracket(char c) { return is_mark(c) && c != ',' && c != ':'; }
constexpr bool is_of_number(char c) {
  return is_json_digit(c) || c == '.' || c == '-' || c == '+' || c == 'e' || c == 'E';
}

/// Returns a table of the characters for which `is_one` holds: loops look up one byte per step.
template <class Predicate>
constexpr std::array<bool, 256> table_of(Predicate is_one) {
  std::array<bool, 256> table{};
  for (int c = 0; c < 256; ++c) table[static_cast<std::size_t>(c)] = is_one(static_cast<char>(c));
  return table;
}

constexpr auto kQuotesAndBrackets = table_of(is_quote_or_bracket);
constexpr auto kOfNumber = table_of(is_of_number);

bool has(const std::array<bool, 256>& table, char c) {
  return table[static_cast<unsigned char>(c)];
}

std::string hex_byte(char c) {
  constexpr std::string_view kDigits = "0123456789abcdef";
  const auto byte = static_cast<unsigned char>(c);
  return {'0', 'x', kDigits[byte >> 4U], kDigits[byte & 15U]};
}

}  // namespace

JsonScanner::JsonScanner(std::string_view text, std::string name, Context& context)
    : text_(text),
      name_(std::move(name)),
      cursor_(text, name_),
      context_(context),
      p_(cursor_.position()),
      end_(text.data() + text.size()),
      token_(p_) {}

void JsonScanner::check_context() {
  if (steps_++ % kStepsPerCheckpoint != 0) return;
  context_.checkpoint("read", static_cast<std::size_t>(p_ - text_.data()), text_.size());
}

void JsonScanner::skip_blanks() {
  p_ = find_watched(p_, end_, context_, [](char c) { return !is_blank(c); });
}

JsonToken JsonScanner::next() {
  check_context();
  if (before_ == Before::Name) take_colon();
  skip_blanks();
  if (open_.empty()) {
    while (at(kRecordSeparator)) {
      ++p_;
      skip_blanks();
    }
    token_ = p_;
    return p_ == end_ && has_value_ ? JsonToken::End : read_value();
  }
  if (before_ == Before::Name) return read_value();
  const bool in_object = open_.back();
  if (at(in_object ? '}' : ']')) return close();
  if (before_ == Before::Value) {
    if (!at(',')) fail_expected(in_object ? "',' or '}'" : "',' or ']'");
    ++p_;
    skip_blanks();
  }
  return in_object ? read_name() : read_value();
}

void JsonScanner::take_colon() {
  skip_blanks();
  if (!at(':')) fail_expected("':'");
  ++p_;
  skip_blanks();
}

JsonToken JsonScanner::read_name() {
  token_ = p_;
  if (!at('"')) fail_expected(before_ == Before::Bracket ? "a name or '}'" : "a name");
  read_string();
  before_ = Before::Name;
  return JsonToken::Name;
}

JsonToken JsonScanner::read_value() {
  token_ = p_;
  before_ = Before::Value;
  has_value_ = true;
  if (p_ == end_) fail_expected("a value");
  switch (*p_) {
    case '{':
    case '[':
      return open();
    case '"':
      read_string();
      return JsonToken::String;
    case '-':
      return p_ + 1 != end_ && is_json_digit(p_[1]) ? read_number() : read_word();
    default:
      return is_json_digit(*p_) ? read_number() : read_word();
  }
}

JsonToken JsonScanner::read_number() {
  p_ = find_watched(p_, end_, context_, [](char c) { return !has(kOfNumber, c); });
  return JsonToken::Number;
}

JsonToken JsonScanner::read_word() {
  p_ = end_of_word(p_);
  if (p_ == token_) fail_expected("a value");
  return token_text() == "null" ? JsonToken::Null : JsonToken::Word;
}

const char* JsonScanner::end_of_word(const char* first) const {
  return find_watched(first, end_, context_,
                      [](char c) { return is_control(c) || c == ' ' || is_mark(c); });
}

JsonToken JsonScanner::open() {
  open_bracket();
  before_ = Before::Bracket;
  return open_.back() ? JsonToken::BeginObject : JsonToken::BeginArray;
}

JsonToken JsonScanner::close() {
  token_ = p_;
  const bool is_object = open_.back();
  close_bracket();
  before_ = Before::Value;
  return is_object ? JsonToken::EndObject : JsonToken::EndArray;
}

void JsonScanner::open_bracket() { open_.push_back(*p_++ == '{'); }

/// Reads a closing bracket, which must match the innermost open bracket.
void JsonScanner::close_bracket() {
  if (*p_ != (open_.back() ? '}' : ']')) fail_expected(open_.back() ? "'}'" : "']'");
  ++p_;
  open_.pop_back();
}

void JsonScanner::read_string() {
  for (const char* p = p_ + 1; p != end_; ++p) {
    p = find_watched(p, end_, context_,
                     [](char c) { return c == '"' || c == '\\' || is_control(c); });
    if (p == end_) break;
    if (*p == '"') {
      p_ = p + 1;
      return;
    }
    if (is_control(*p)) fail(ErrorCode::Syntax, "not JSON: a control character in a string", p);
    if (++p == end_) break;
  }
  fail(ErrorCode::Syntax, "not JSON: a string that does not end", p_);
}

std::string_view JsonScanner::string_text() {
  const std::string_view plain = token_text().substr(1, token_text().size() - 2);
  if (plain.find('\\') == plain.npos) return plain;
  const auto value = nlohmann::json::parse(token_text(), nullptr, false);
  if (!value.is_string()) return plain;
  decoded_ = value.get<std::string>();
  return decoded_;
}

std::string_view JsonScanner::skip_value() {
  take_colon();
  token_ = p_;
  before_ = Before::Value;
  if (p_ == end_) fail_expected("a value");
  if (*p_ == '"') {
    skip_string();
  } else if (*p_ == '{' || *p_ == '[') {
    skip_brackets();
  } else {
    read_word();
  }
  return token_text();
}

/// Skips a string with any content. Quotes after an odd number of backslashes are a part of it.
void JsonScanner::skip_string() {
  const char* quote = p_;
  std::ptrdiff_t backslashes = 0;
  do {
    ++quote;
    quote =
        static_cast<const char*>(std::memchr(quote, '"', static_cast<std::size_t>(end_ - quote)));
    if (quote == nullptr) fail(ErrorCode::Syntax, "not JSON: a string that does not end", p_);
    const char* before = quote;
    while (before[-1] == '\\') --before;  // The search stops at the first quote.
    backslashes = quote - before;
  } while (backslashes % 2 != 0);
  p_ = quote + 1;
}

/// Skips a list or an object, up to its closing bracket.
void JsonScanner::skip_brackets() {
  const std::size_t outer = open_.size();
  open_bracket();
  while (open_.size() > outer) {
    check_context();
    p_ = find_watched(p_, end_, context_, [](char c) { return has(kQuotesAndBrackets, c); });
    if (p_ == end_) fail_expected(open_.back() ? "'}'" : "']'");
    if (*p_ == '"') {
      skip_string();
    } else if (*p_ == '{' || *p_ == '[') {
      open_bracket();
    } else {
      close_bracket();
    }
  }
}

void JsonScanner::fail(ErrorCode code, const std::string& message, const char* where) const {
  TextCursor cursor(text_, name_);
  if (where > cursor.position()) cursor.move_to(where);
  cursor.fail(code, message);
}

void JsonScanner::fail_expected(const char* what) const {
  const std::string expected = std::string("expected ") + what;
  if (p_ == end_) {
    fail(ErrorCode::Syntax, "not JSON: unexpected end of input; " + expected, p_);
  }
  const std::string_view word(p_, static_cast<std::size_t>(end_of_word(p_ + 1) - p_));
  const std::string found = text_prefix(word) == 0 ? "byte " + hex_byte(*p_) : quoted(word);
  fail(ErrorCode::Syntax, "not JSON: " + expected + ", found " + found, p_);
}

}  // namespace plumb
