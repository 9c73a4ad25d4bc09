// A scanner for the XML of drawings, and for the values of SVG attributes.
//
// The whole text is checked once for UTF-8 and control characters, so later steps may search bytes.
// The scanner then moves from tag to tag; open elements are a stack of names, whose depth and whose
// attributes are limited and charged. It skips the declarations of document types and never
// resolves references or loads anything, so entity expansion (the "billion laughs") cannot occur.
//
// In values, a number ends where its longest valid prefix ends: "1.2.3" is 1.2 and .3, and "1em" is
// 1 followed by a unit that is refused. Format: W3C, XML 1.0, and SVG 1.1; docs/formats.md, section
// Drawings.
// Tested by tests/io/svg_reader_test.cpp.
#include "plumb/io/svg/svg_syntax.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

#include "plumb/io/text/input_cursors.h"
#include "plumb/io/text/watched_scan.h"
#include "plumb/predicates/error.h"
#include "plumb/predicates/rounding.h"

namespace plumb {
namespace {

constexpr std::size_t kMostNested = 256;
constexpr std::size_t kMostAttributes = 4096;  // The limit applies to one element.
constexpr std::size_t kStepsPerCheckpoint = 1024;
constexpr std::size_t kBytesPerCheckpoint = std::size_t{1} << 16U;
constexpr std::size_t kLongestCharacter = 4;
constexpr std::string_view kBlanks = " \t\r\n";

bool is_blank(char c) { return kBlanks.find(c) != kBlanks.npos; }
/// Whether the byte ends a name. If any other byte cannot be a part of a name, the text is not
/// mark-up.
bool ends_name(char c) {
  constexpr std::string_view kMarks = "=<>/\"'&?!";
  return is_blank(c) || kMarks.find(c) != kMarks.npos;
}

/// Whether the XML declaration names an encoding whose first 128 characters are ASCII and whose
/// characters are single bytes, such as ISO-8859-1 or windows-1252.
bool declares_single_bytes(std::string_view text) {
  constexpr std::array<std::string_view, 3> kFamilies{"iso-8859-", "windows-125", "cp125"};
  constexpr std::string_view kEncoding = "encoding";
  if (!text.starts_with("<?xml")) return false;
  std::string_view declaration = text.substr(0, text.find("?>"));
  const std::size_t at = declaration.find(kEncoding);
  if (at == declaration.npos) return false;
  declaration.remove_prefix(at + kEncoding.size());
  declaration.remove_prefix(
      std::min(declaration.find_first_not_of(" \t\r\n=\"'"), declaration.size()));
  return std::ranges::any_of(kFamilies, [&](std::string_view family) {
    return std::ranges::equal(declaration.substr(0, family.size()), family, {},
                              [](char c) { return c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c; });
  });
}

}  // namespace

std::size_t find_entity(std::string_view text) {
  constexpr std::array<std::string_view, 6> kKnown{"#", "amp;", "lt;", "gt;", "quot;", "apos;"};
  for (std::size_t at = text.find('&'); at != text.npos; at = text.find('&', at + 1)) {
    const std::string_view name = text.substr(at + 1);
    const bool is_known = std::ranges::any_of(
        kKnown, [&](std::string_view known) { return name.starts_with(known); });
    if (!is_known) return at;
  }
  return text.npos;
}

XmlScanner::XmlScanner(std::string_view text, const std::string& name, Context& context)
    : p_(text.data()),
      end_(text.data() + text.size()),
      tag_(p_),
      cursor_(text, name),
      context_(context) {
  p_ = tag_ = cursor_.position();
  is_utf8_ = !declares_single_bytes({p_, static_cast<std::size_t>(end_ - p_)});
  require_text();
}

/// Checks the whole text in blocks. Lines are not counted here.
void XmlScanner::require_text() const {
  const char* at = p_;
  for (const char* begin = at; at != end_; begin = at) {
    const auto bytes = static_cast<std::size_t>(end_ - begin);
    const auto all = static_cast<std::size_t>(end_ - p_);
    context_.checkpoint("read", all - bytes, all);
    const char* const end = begin + std::min(bytes, kBytesPerCheckpoint);
    while (at != end) {
      at += text_prefix({at, static_cast<std::size_t>(end - at)});
      if (at == end) break;
      const bool is_single_byte = !is_utf8_ && static_cast<unsigned char>(*at) >= 0x80;
      if (*at == '\n' || *at == '\r' || is_single_byte) {
        ++at;
      } else if (end == end_ || static_cast<std::size_t>(end - at) >= kLongestCharacter) {
        fail(ErrorCode::NotText, "a byte that is no text: is this XML?", at);
      } else {
        break;  // Possibly a character that continues behind the end of the block.
      }
    }
  }
}

XmlScanner XmlScanner::of_element() const {
  XmlScanner scanner = *this;
  scanner.p_ = tag_;
  scanner.attributes_ = {};
  scanner.open_ = {};
  scanner.is_empty_ = scanner.has_root_ = false;
  return scanner;
}

void XmlScanner::release_attributes() {
  context_.release_memory(2 * sizeof(XmlAttribute) * attributes_.size());
  attributes_.clear();
}

TextCursor XmlScanner::cursor_at(const char* where) const {
  TextCursor cursor = cursor_;
  cursor.move_to(where);
  return cursor;
}

void XmlScanner::fail(ErrorCode code, const std::string& message, const char* where) const {
  cursor_at(where).fail(code, message);
}

std::optional<std::string_view> XmlScanner::attribute(std::string_view name) const {
  std::optional<std::string_view> found;
  for (const XmlAttribute& a : attributes_) {
    if (a.name != name) continue;
    if (found) fail(ErrorCode::Syntax, quoted(name) + " is given twice", a.name.data());
    found = a.value;
  }
  return found;
}

// ---------------------------------------------------------------- between tags

bool XmlScanner::skip_from(std::string_view open, std::string_view close, const char* what) {
  std::string_view rest(p_, static_cast<std::size_t>(end_ - p_));
  if (!take_prefix(rest, open)) return false;
  const std::size_t found = rest.find(close);
  if (found == rest.npos) fail(ErrorCode::Syntax, std::string(what) + " without an end", p_);
  p_ = rest.data() + found + close.size();
  return true;
}

void XmlScanner::skip_document_type() {
  const char* const found = std::find_if(p_, end_, [](char c) { return c == '[' || c == '>'; });
  if (found == end_) fail(ErrorCode::Syntax, "a document type without an end", p_);
  declares_entities_ = *found == '[';
  const char* const last = declares_entities_ ? end_of_subset(found) : found;
  if (last == end_ || *last != '>') fail(ErrorCode::Syntax, "a document type without an end", p_);
  p_ = last + 1;
}

/// Returns the first byte that is not a blank after the declarations that begin with '['. Strings
/// and comments in these declarations may contain brackets.
const char* XmlScanner::end_of_subset(const char* from) const {
  const char* at = from + 1;
  while (at != end_ && *at != ']') {
    const std::string_view rest(at, static_cast<std::size_t>(end_ - at));
    std::string_view close;
    if (rest.starts_with("<!--")) close = "-->";
    if (*at == '"' || *at == '\'') close = rest.substr(0, 1);
    const std::size_t found = close.empty() ? 0 : rest.find(close, 1);
    if (found == rest.npos) return end_;
    at += found + std::max<std::size_t>(close.size(), 1);
  }
  return at == end_ ? end_ : std::find_if_not(at + 1, end_, is_blank);
}

/// Moves to the next tag. Returns false at the end of the text.
bool XmlScanner::find_tag() {
  for (;;) {
    if (steps_++ % kStepsPerCheckpoint == 0) context_.checkpoint("read", steps_, steps_);
    const char* const tag = std::find(p_, end_, '<');
    const char* const stray = std::find_if_not(p_, tag, is_blank);
    if (open_.empty() && stray != tag) {
      fail(ErrorCode::Syntax, "text outside of the root element", stray);
    }
    const std::string_view between(p_, static_cast<std::size_t>(tag - p_));
    const std::size_t entity = declares_entities_ ? find_entity(between) : between.npos;
    if (entity != between.npos) {
      fail(ErrorCode::Syntax, "a reference to an entity: entities are not expanded", p_ + entity);
    }
    p_ = tag;
    cursor_.move_to(p_);
    if (p_ == end_) return false;
    const std::string_view rest(p_, static_cast<std::size_t>(end_ - p_));
    if (open_.empty() && rest.starts_with("<![CDATA[")) {
      fail(ErrorCode::Syntax, "CDATA outside of the root element", p_);
    }
    if (skip_from("<!--", "-->", "a comment") || skip_from("<?", "?>", "an instruction") ||
        skip_from("<![CDATA[", "]]>", "CDATA")) {
      continue;
    }
    if (!rest.starts_with("<!")) return true;
    if (has_root_) fail(ErrorCode::Syntax, "a declaration in the middle of the document", p_);
    skip_document_type();
  }
}

// ---------------------------------------------------------------- tags

void XmlScanner::skip_blanks() {
  p_ = find_watched(p_, end_, context_, [](char c) { return !is_blank(c); });
}

std::string_view XmlScanner::take_name(const char* what) {
  const char* const first = p_;
  p_ = std::find_if(p_, end_, ends_name);
  if (p_ == first) fail(ErrorCode::Syntax, "expected " + std::string(what), first);
  return {first, static_cast<std::size_t>(p_ - first)};
}

void XmlScanner::take(char c, const char* what) {
  if (p_ == end_ || *p_ != c) fail(ErrorCode::Syntax, "expected " + std::string(what), p_);
  ++p_;
}

void XmlScanner::read_attribute() {
  if (attributes_.size() == kMostAttributes) {
    fail(ErrorCode::Syntax, "an element of more than 4096 attributes", tag_);
  }
  XmlAttribute attribute;
  attribute.name = take_name("an attribute, '>' or '/>'");
  skip_blanks();
  take('=', "'=' and a value in quotes");
  skip_blanks();
  const char quote = peek();
  if (quote != '"' && quote != '\'') fail(ErrorCode::Syntax, "expected a value in quotes", p_);
  const char* const first = ++p_;
  p_ = find_watched(p_, end_, context_, [quote](char c) { return c == quote || c == '<'; });
  if (peek() != quote) fail(ErrorCode::Syntax, "a value without its closing quote", first - 1);
  attribute.value = {first, static_cast<std::size_t>(p_ - first)};
  ++p_;
  with_place(cursor_, [&] { context_.charge_memory(2 * sizeof(XmlAttribute), "the drawing"); });
  attributes_.push_back(attribute);
}

void XmlScanner::read_start() {
  if (open_.empty() && std::exchange(has_root_, true)) {
    fail(ErrorCode::Syntax, "a second root element", tag_);
  }
  if (open_.size() == kMostNested) {
    fail(ErrorCode::Syntax, "elements nested more than 256 deep", tag_);
  }
  release_attributes();
  ++p_;
  element_ = take_name("the name of an element");
  for (;;) {
    const char* const before = p_;
    skip_blanks();
    if (p_ == end_) fail(ErrorCode::Syntax, "a tag without an end", tag_);
    if (*p_ == '>' || *p_ == '/') break;
    if (p_ == before) fail(ErrorCode::Syntax, "expected a blank before an attribute", p_);
    if (steps_++ % kStepsPerCheckpoint == 0) context_.checkpoint("read", steps_, steps_);
    read_attribute();
  }
  is_empty_ = *p_ == '/';
  if (is_empty_) ++p_;
  take('>', "'>'");
  open_.push_back(element_);
}

void XmlScanner::read_end() {
  p_ += 2;
  const char* const where = p_;
  element_ = take_name("the name of an element");
  if (open_.empty() || open_.back() != element_) {
    fail(ErrorCode::Syntax,
         open_.empty() ? "an end without a start"
                       : "expected the end of " + quoted(open_.back()) + ", found that of " +
                             quoted(element_),
         where);
  }
  skip_blanks();
  take('>', "'>'");
  open_.pop_back();
}

XmlScanner::Event XmlScanner::next() {
  if (std::exchange(is_empty_, false)) {
    open_.pop_back();
    return Event::End;
  }
  if (!find_tag()) {
    if (!open_.empty()) fail(ErrorCode::Syntax, quoted(open_.back()) + " is not ended", end_);
    if (!has_root_) fail(ErrorCode::CountMismatch, "the file has no content", end_);
    return Event::Done;
  }
  tag_ = p_;
  if (p_ + 1 != end_ && p_[1] == '/') {
    read_end();
    return Event::End;
  }
  read_start();
  return Event::Start;
}

namespace {

bool is_value_blank(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }
bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_ascii_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }
bool is_sign(char c) { return c == '+' || c == '-'; }

std::size_t digits(std::string_view text, std::size_t from) {
  while (from < text.size() && is_digit(text[from])) ++from;
  return from;
}

/// Returns the length of the number at the beginning of `text`, or 0 if there is none. In "1em" the
/// number is 1, in "1.2.3" it is 1.2.
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
  while (!rest_.empty() && is_value_blank(rest_.front())) rest_.remove_prefix(1);
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
  // Longer values are refused in any case, and this value may be a hundred times as long.
  constexpr std::size_t kMost = std::size_t{1} << 21U;
  const std::string_view token = rest_.substr(0, number_length(rest_.substr(0, kMost)));
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

double SvgValue::length(double whole) {
  skip_blanks();
  double value = number_alone();
  if (whole > 0 && peek() == '%') {
    value *= whole / 100;
    rest_.remove_prefix(1);
  } else if (!rest_.empty() && !is_value_blank(rest_.front()) && rest_.front() != ',') {
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
  const auto end = std::find_if_not(rest_.begin(), rest_.end(), is_ascii_letter);
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
