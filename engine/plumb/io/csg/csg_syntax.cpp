// Scanner of OpenSCAD's flattened models.
//
// The scanner runs over bytes; lines and columns are computed only for nodes and errors, by a
// second cursor. Numbers of ordinary size are read by std::from_chars(); all others are left to
// NumberReader, which knows the limits of numbers and their errors.
//
// Tested by tests/io/csg_reader_test.cpp and fuzz/csg_reader.cpp.
#include "plumb/io/csg/csg_syntax.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <system_error>

#include "plumb/io/text/double_text.h"
#include "plumb/io/text/watched_scan.h"
#include "plumb/predicates/error.h"
#include "plumb/predicates/rounding.h"

namespace plumb {
namespace {

bool is_csg_letter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_' || c == '$';
}
bool is_csg_digit(char c) { return c >= '0' && c <= '9'; }
bool is_csg_blank(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }
bool is_modifier(char c) { return c == '#' || c == '%' || c == '!' || c == '*'; }

constexpr std::uint64_t kNodesBetweenReports = 1024;
/// Vectors are as deep as a matrix or a list of points, not much deeper.
constexpr std::size_t kMostVectors = 64;
constexpr double kNotANumber = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

}  // namespace

CsgScanner::CsgScanner(std::string_view text, const std::string& name, Context& context)
    : cursor_(text, name),
      numbers_(context, false, text.size()),
      context_(context),
      memory_(context),
      begin_(text.data()),
      p_(cursor_.position()),
      end_(text.data() + text.size()),
      place_(p_) {}

bool CsgScanner::has(char modifier) const {
  return modifiers_.find(modifier) != std::string_view::npos;
}

void CsgScanner::fail(ErrorCode code, const std::string& message, const char* where) {
  if (where > cursor_.position()) cursor_.move_to(where);
  cursor_.fail(code, message);
}

/// Throws an error for the token at the position of the scanner.
void CsgScanner::fail_unexpected(const char* what) {
  if (p_ > cursor_.position()) cursor_.move_to(p_);
  if (p_ == end_) {
    cursor_.fail(ErrorCode::Syntax, std::string("expected ") + what + ", found the end");
  }
  cursor_.fail_token(token(), what);
}

/// Returns the text that a message quotes: a word, or a single character that does not begin a
/// word.
std::string_view CsgScanner::token() const {
  const char* q = p_;
  while (q != end_ && (is_csg_letter(*q) || is_csg_digit(*q) || *q == '.')) ++q;
  if (q == p_ && q != end_) {
    ++q;
    while (q != end_ && (static_cast<unsigned char>(*q) & 0xc0U) == 0x80U) ++q;
  }
  return {p_, static_cast<std::size_t>(q - p_)};
}

void CsgScanner::skip_comment() {
  const std::string_view rest(p_, static_cast<std::size_t>(end_ - p_));
  const bool is_line = rest[1] == '/';
  const std::size_t close = is_line ? rest.find('\n') : rest.find("*/", 2);
  if (!is_line && close == rest.npos) fail(ErrorCode::Syntax, "this comment does not end", p_);
  p_ = close == rest.npos ? end_ : p_ + close + (is_line ? 1 : 2);
}

/// Returns whether the text has more than blanks and comments.
bool CsgScanner::skip_blanks() {
  for (;;) {
    p_ = find_watched(p_, end_, context_, [](char c) { return !is_csg_blank(c); });
    const bool is_comment = end_ - p_ >= 2 && *p_ == '/' && (p_[1] == '/' || p_[1] == '*');
    if (!is_comment) return p_ != end_;
    skip_comment();
  }
}

/// Returns the next character that is not a blank, or 0 at the end.
char CsgScanner::peek() { return skip_blanks() ? *p_ : '\0'; }

bool CsgScanner::take(char c) {
  if (!skip_blanks() || *p_ != c) return false;
  ++p_;
  return true;
}

void CsgScanner::expect(char c, const char* what) {
  if (!take(c)) fail_unexpected(what);
}

std::string_view CsgScanner::word() {
  const char* const first = p_;
  while (p_ != end_ && (is_csg_letter(*p_) || (p_ != first && is_csg_digit(*p_)))) ++p_;
  return {first, static_cast<std::size_t>(p_ - first)};
}

CsgScanner::Event CsgScanner::next() {
  if (is_node_over_ && !has_braces_.empty() && has_braces_.back() == 0) return close();
  is_node_over_ = false;
  while (take(';')) {
  }
  if (!skip_blanks()) {
    if (!has_braces_.empty()) fail_unexpected("'}'");
    return Event::Done;
  }
  if (*p_ != '}') return read_node();
  if (has_braces_.empty()) fail_unexpected("a node");
  ++p_;
  return close();
}

CsgScanner::Event CsgScanner::close() {
  has_braces_.pop_back();
  is_node_over_ = true;
  return Event::Close;
}

CsgScanner::Event CsgScanner::read_node() {
  if (++nodes_ % kNodesBetweenReports == 0) {
    context_.checkpoint("read", static_cast<std::uint64_t>(p_ - begin_),
                        static_cast<std::uint64_t>(end_ - begin_));
  }
  const char* const modifiers = p_;
  while (skip_blanks() && is_modifier(*p_)) ++p_;
  modifiers_ = {modifiers, static_cast<std::size_t>(p_ - modifiers)};
  place_ = p_;
  name_ = word();
  if (name_.empty()) fail_unexpected("a node");
  cursor_.move_to(place_);
  line_ = static_cast<std::uint32_t>(cursor_.line());
  column_ = static_cast<std::uint32_t>(place_ - cursor_.line_start() + 1);
  read_parameters();
  if (take(';')) {
    is_node_over_ = true;
    return Event::Leaf;
  }
  const bool is_block = take('{');
  const char first = peek();
  if (!is_block && !is_csg_letter(first) && !is_modifier(first)) fail_unexpected("';' or '{'");
  if (has_braces_.size() == has_braces_.capacity()) {
    const std::size_t more = std::max<std::size_t>(has_braces_.capacity(), 64);
    memory_.add(more, "the nodes of a model");
    has_braces_.reserve(has_braces_.size() + more);
  }
  has_braces_.push_back(is_block ? 1 : 0);
  return Event::Open;
}

void CsgScanner::require_braces() {
  if (has_braces_.back() == 0) fail_unexpected("';' or '{'");
}

void CsgScanner::read_parameters() {
  parameters_.clear();
  values_.clear();
  expect('(', "'('");
  if (take(')')) return;
  do {
    if (peek() == ')') break;  // A comma may be the last character of the list.
    if (p_ == end_) fail_unexpected("a parameter or ')'");
    read_parameter();
  } while (take(','));
  expect(')', "',' or ')'");
}

void CsgScanner::read_parameter() {
  const char* const start = p_;
  std::string_view name;
  if (is_csg_letter(peek())) {
    const char* const first = p_;
    name = word();
    if (!take('=')) {  // The word is a value, such as true.
      name = {};
      p_ = first;
    }
  }
  if (p_ == end_) fail(ErrorCode::Syntax, "this parameter has no value", start);
  parameters_.push_back({name, static_cast<std::uint32_t>(values_.size())});
  read_value();
}

void CsgScanner::push(CsgValue::Kind kind, double number, const char* at) {
  if (values_.size() == values_.capacity()) {
    const std::size_t more = std::max<std::size_t>(values_.capacity(), 64);
    memory_.add(more * sizeof(CsgValue), "the parameters of a node");
    values_.reserve(values_.size() + more);
  }
  const auto next = static_cast<std::uint32_t>(values_.size() + 1);
  values_.push_back({kind, number, next, next, at});
}

/// Reads a value with all values within it. `open` contains the vectors that are not closed.
void CsgScanner::read_value() {
  std::vector<std::uint32_t> open;
  do {
    if ((values_.size() & 0xffffU) == 0xffffU) {
      context_.checkpoint("read", static_cast<std::uint64_t>(p_ - begin_),
                          static_cast<std::uint64_t>(end_ - begin_));
    }
  } while (read_vector_step(open));
}

/// Reads a scalar, or a bracket with the comma after it. Returns whether a vector is still open.
bool CsgScanner::read_vector_step(std::vector<std::uint32_t>& open) {
  const char c = peek();
  if (c == '[') {
    if (open.size() == kMostVectors) fail(ErrorCode::Syntax, "vectors are nested too deep", p_);
    open.push_back(static_cast<std::uint32_t>(values_.size()));
    push(CsgValue::Kind::Vector, 0, p_++);
    return true;
  }
  const bool is_end = c == ']' && !open.empty();
  if (is_end) {
    ++p_;
    values_[open.back()].end = static_cast<std::uint32_t>(values_.size());
    open.pop_back();
  } else {
    read_scalar();
  }
  if (open.empty()) return false;
  if (!take(',') && peek() != ']') fail_unexpected("',' or ']'");
  return true;
}

void CsgScanner::read_scalar() {
  const char* const at = p_;
  const char c = peek();
  if (c == '"') return read_text();
  if (is_csg_digit(c) || c == '-' || c == '+' || c == '.') return read_number();
  const char* const first = p_;
  const std::string_view w = word();
  if (w == "true") return push(CsgValue::Kind::Boolean, 1, first);
  if (w == "false") return push(CsgValue::Kind::Boolean, 0, first);
  if (w == "undef") return push(CsgValue::Kind::Undefined, 0, first);
  if (w == "inf") return push(CsgValue::Kind::Number, kInfinity, first);
  if (w == "nan") return push(CsgValue::Kind::Number, kNotANumber, first);
  p_ = first;
  if (at == end_) fail_unexpected("a value");
  fail_unexpected("a number, a vector, a text, true, false or undef");
}

void CsgScanner::read_number() {
  const char* const first = p_;
  const char* const digits = *first == '+' ? first + 1 : first;
  const char* const last = find_watched(digits, end_, context_, [](char c) {
    return !is_csg_digit(c) && !is_csg_letter(c) && c != '.' && c != '-' && c != '+';
  });
  const std::string_view token(first, static_cast<std::size_t>(last - first));
  const std::string_view magnitude(digits + (*digits == '-' ? 1 : 0), last);
  if (magnitude == "inf" || magnitude == "nan") {
    p_ = last;
    const double value = magnitude == "nan" ? kNotANumber : kInfinity;
    return push(CsgValue::Kind::Number, *digits == '-' ? -value : value, first);
  }
  double value = 0;
  constexpr std::ptrdiff_t kMost = 64;  // Longer numbers are rare, and may be very long.
  const auto [end, error] = double_from_chars(digits, std::min(last, digits + kMost), value);
  const bool is_read = error == std::errc() && end == last && std::isfinite(value);
  if (!is_read) {
    if (first > cursor_.position()) cursor_.move_to(first);
    ReadNumber number;
    numbers_.read(cursor_, token, number);
    value = number.is_double() ? number.as_double() : nearest_double(number.exact());
    if (!std::isfinite(value)) {
      fail(ErrorCode::NumberOutOfRange, "the number is beyond the largest double", first);
    }
  }
  p_ = last;
  push(CsgValue::Kind::Number, value, first);
}

void CsgScanner::read_text() {
  const char* const first = p_++;
  while (p_ != end_ && *p_ != '"') p_ += *p_ == '\\' && end_ - p_ > 1 ? 2 : 1;
  if (p_ == end_) fail(ErrorCode::Syntax, "this text does not end", first);
  // OpenSCAD writes a line break within a text without an escape.
  const char* line = first + 1;
  while (line <= p_) {
    const char* const end = std::find_if(line, p_, [](char c) { return c == '\n' || c == '\r'; });
    const std::string_view text(line, static_cast<std::size_t>(end - line));
    const std::size_t good = text_prefix(text);
    if (good != text.size()) fail(ErrorCode::NotText, "a byte that is not text", line + good);
    line = end + 1;
  }
  ++p_;
  push(CsgValue::Kind::Text, 0, first);
}

std::string CsgScanner::text_of(const CsgValue& value) const {
  std::string text;
  for (const char* q = value.at + 1; *q != '"'; ++q) {
    if (*q == '\\') ++q;
    text += *q;
  }
  return text;
}

}  // namespace plumb
