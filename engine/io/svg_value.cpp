#include "plumb/io/svg_value.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

#include "plumb/base/error.h"
#include "plumb/predicates/rounding.h"

namespace plumb {
namespace {

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }
bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }
bool is_sign(char c) { return c == '+' || c == '-'; }

std::size_t digits(std::string_view text, std::size_t from) {
  while (from < text.size() && is_digit(text[from])) ++from;
  return from;
}

/// How long the number is that `text` begins with; 0 if it begins with none. In "1em" it is 1, in "1.2.3" it is 1.2.
std::size_t number_length(std::string_view text) {
  std::size_t at = !text.empty() && is_sign(text[0]) ? 1 : 0;
  const std::size_t whole = at;
  at = digits(text, at);
  std::size_t count = at - whole;
  if (at < text.size() && text[at] == '.') {
    const std::size_t fraction = at + 1;
    at = digits(text, fraction);
    count += at - fraction;
  }
  if (count == 0) return 0;
  if (at < text.size() && (text[at] == 'e' || text[at] == 'E')) {
    std::size_t exponent = at + 1;
    if (exponent < text.size() && is_sign(text[exponent])) ++exponent;
    if (const std::size_t end = digits(text, exponent); end > exponent) at = end;
  }
  return at;
}

struct Unit {
  std::string_view name;
  double pixels;
};
constexpr std::array kUnits{Unit{"px", 1},         Unit{"in", 96},        Unit{"cm", 96 / 2.54},
                            Unit{"mm", 96 / 25.4}, Unit{"pt", 96 / 72.0}, Unit{"pc", 16}};

}  // namespace

void SvgValue::fail(ErrorCode code, const std::string& message, const char* where) const {
  TextCursor cursor = start_;
  cursor.move_to(where);
  cursor.fail(code, message);
}

void SvgValue::fail_expected(const std::string& what) const {
  const std::string found = rest_.empty() ? "the end of the value" : quoted(rest_.substr(0, 1));
  fail(ErrorCode::Syntax, "expected " + what + ", found " + found, rest_.data());
}

void SvgValue::skip() {
  if (comma_ != nullptr) fail_expected("a number after the comma");
  rest_.remove_prefix(1);
}

void SvgValue::skip_blanks() {
  while (!rest_.empty() && is_blank(rest_.front())) rest_.remove_prefix(1);
}

bool SvgValue::at_end() {
  skip_blanks();
  if (rest_.empty() && comma_ != nullptr) fail_expected("more after the comma");
  return rest_.empty();
}

void SvgValue::skip_separator() {
  skip_blanks();
  comma_ = nullptr;
  if (peek() != ',') return;
  comma_ = rest_.data();
  rest_.remove_prefix(1);
  skip_blanks();
}

double SvgValue::number_alone() {
  const std::string_view token = rest_.substr(0, number_length(rest_));
  if (token.empty()) fail_expected("a number");
  cursor_.move_to(token.data());
  numbers_.read(cursor_, token, number_);
  rest_.remove_prefix(token.size());
  const double value = number_.is_double() ? number_.as_double() : nearest_double(number_.exact());
  if (!std::isfinite(value)) {
    fail(ErrorCode::NumberOutOfRange, "a number beyond the largest double", token.data());
  }
  return value;
}

double SvgValue::number() {
  skip_blanks();
  const double value = number_alone();
  skip_separator();
  return value;
}

double SvgValue::length() {
  skip_blanks();
  double value = number_alone();
  if (!rest_.empty() && !is_blank(rest_.front()) && rest_.front() != ',') {
    const auto unit = std::find_if(kUnits.begin(), kUnits.end(),
                                   [this](const Unit& u) { return rest_.starts_with(u.name); });
    if (unit == kUnits.end()) fail_expected("a number, or a length in px, in, cm, mm, pt or pc");
    value *= unit->pixels;
    rest_.remove_prefix(unit->name.size());
    if (!std::isfinite(value)) {
      fail(ErrorCode::NumberOutOfRange, "a length beyond the largest double", rest_.data());
    }
  }
  skip_separator();
  return value;
}

bool SvgValue::flag() {
  skip_blanks();
  if (peek() != '0' && peek() != '1') fail_expected("a flag, 0 or 1");
  const bool value = peek() == '1';
  rest_.remove_prefix(1);
  skip_separator();
  return value;
}

std::string_view SvgValue::word() {
  skip_blanks();
  const auto end = std::find_if_not(rest_.begin(), rest_.end(), is_letter);
  const std::string_view word = rest_.substr(0, static_cast<std::size_t>(end - rest_.begin()));
  rest_.remove_prefix(word.size());
  comma_ = nullptr;
  return word;
}

void SvgValue::take(char c) {
  skip_blanks();
  if (peek() != c) fail_expected("'" + std::string(1, c) + "'");
  skip();
  skip_separator();
  if (c == '(' && comma_ != nullptr) fail_expected("a number");
}

}  // namespace plumb
