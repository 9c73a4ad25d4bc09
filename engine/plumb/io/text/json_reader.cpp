// Places of JSON tokens, and JSON as a flat list of values.
//
// nlohmann-json reports events without places. JsonPlaces lets it read through an iterator that
// records how far it has read, so each token is found between the end of the last one and that
// position. JsonValues keeps 8 bytes for each value: its first byte, and the number of the value
// after it, which makes skipping a subtree O(1) and lists linked. Memory is known before parsing: a
// scan counts separators outside of quotes, which bounds the number of values, and the list is
// reserved once; if the parser reports more, the text is not JSON, and parsing will fail.
//
// A parser that reports events takes most of the time of reading a layer. So PlainJson lists the
// values of most texts by itself. It gives up where a text is not JSON, and where it does not
// decide whether it is JSON. Then the parser reads the text, so errors are always those of the
// parser.
//
// Tested by tests/io/json_reader_test.cpp.
#include "plumb/io/text/json_reader.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <nlohmann/json.hpp>
#include <utility>

#include "plumb/io/text/utf8.h"
#include "plumb/io/text/watched_scan.h"
#include "plumb/predicates/error.h"

namespace plumb {
namespace {

constexpr std::size_t kTokensPerCheckpoint = 4096;

}  // namespace

JsonPlaces::JsonPlaces(std::string_view text, std::string name, Context& context)
    : text_(text),
      name_(std::move(name)),
      cursor_(text, name_),
      context_(context),
      read_to_(cursor_.position()),
      next_check_(read_to_),
      token_end_(cursor_.position()) {}

/// The parser reads a long token to its end before it reports the token.
void JsonPlaces::check_limits() {
  constexpr std::ptrdiff_t kBytesPerCheckpoint = std::ptrdiff_t{1} << 20;
  const char* const end = text_.data() + text_.size();
  next_check_ = read_to_ + std::min(end - read_to_, kBytesPerCheckpoint);
  context_.check_limits("read");
}

void JsonPlaces::find_token() {
  constexpr std::string_view kBetween = " \t\r\n,:";
  token_ =
      std::find_if(token_end_, read_to_, [&](char c) { return kBetween.find(c) == kBetween.npos; });
  token_end_ = read_to_;
  if (tokens_++ % kTokensPerCheckpoint == 0) {
    context_.checkpoint("read", static_cast<std::size_t>(token_ - text_.data()), text_.size());
  }
}

void JsonPlaces::find_number() {
  constexpr std::string_view kNumber = "+-.0123456789Ee";
  find_token();
  token_end_ =
      std::find_if(token_, read_to_, [&](char c) { return kNumber.find(c) == kNumber.npos; });
}

const char* JsonPlaces::early_end() const {
  constexpr std::string_view kNothing(" \t\r\n\0", 5);
  const std::string_view rest = text_.substr(static_cast<std::size_t>(read_to_ - text_.data()));
  return rest.find_first_not_of(kNothing) == rest.npos ? nullptr : read_to_ - 1;
}

void JsonPlaces::require_end() const {
  if (const char* const at = early_end()) fail(ErrorCode::Syntax, "not JSON: byte 0x00", at);
}

void JsonPlaces::fail(ErrorCode code, const std::string& message, const char* where) const {
  TextCursor cursor(text_, name_);
  if (where > cursor.position()) cursor.move_to(where);
  cursor.fail(code, message);
}

void JsonPlaces::fail_syntax(std::size_t position, int id, std::string_view what) const {
  constexpr int kOverflow = 406;
  const std::size_t last = std::min(position - std::min<std::size_t>(position, 1), text_.size());
  if (id == kOverflow) {
    fail(ErrorCode::NumberOutOfRange, "a number too large to be read", text_.data() + last);
  }
  // "[..] parse error at line 1, column 2: syntax error while parsing value - WHY; last read: '..';
  // expected .."
  const std::size_t start = what.find(" - ");
  std::string why(what.substr(start == what.npos ? 0 : start + 3));
  if (const std::size_t read = why.find("; last read: '"); read != why.npos) {
    const std::size_t end = why.rfind("'; expected");
    why.erase(read, end == why.npos ? end : end + 1 - read);
  }
  fail(ErrorCode::Syntax, "not JSON: " + why, text_.data() + last);
}

namespace {

using Json = nlohmann::json;

constexpr std::size_t kMembersPerCheckpoint = 65536;
/// The parser keeps two copies of its last text, in buffers that double one at a time.
constexpr std::uint64_t kParsingBytes = 5;

/// Returns a table of the characters that a text lists: loops look up one byte per step.
constexpr std::array<bool, 256> characters_of(std::string_view characters) {
  std::array<bool, 256> table{};
  for (const char c : characters) table[static_cast<unsigned char>(c)] = true;
  return table;
}

constexpr auto kMarksAndQuotes = characters_of("[{,:\"");
constexpr auto kEnds = characters_of(",]} \t\r\n");  // The characters that end numbers and words.

bool is_in(const std::array<bool, 256>& table, char c) {
  return table[static_cast<unsigned char>(c)];
}

/// Returns the end of a quoted text that begins at `p`: the place after its second quote.
const char* end_of_quoted(const char* p, const char* end, Context& context) {
  for (++p; p != end; ++p) {
    p = find_watched(p, end, context, [](char c) { return c == '"' || c == '\\'; });
    if (p == end) break;
    if (*p == '"') return p + 1;
    if (++p == end) break;
  }
  return end;
}

/// Returns a bound on the number of values. Values begin at the start of the text, or after
/// brackets, commas and colons outside of quotes.
std::uint64_t count_values(std::string_view text, Context& context) {
  const char* const end = text.data() + text.size();
  std::uint64_t values = 1;
  for (const char* p = text.data(); p != end;) {
    p = find_watched(p, end, context, [](char c) { return is_in(kMarksAndQuotes, c); });
    if (p == end) break;
    if (*p == '"') {
      p = end_of_quoted(p, end, context);
      continue;
    }
    if (++values % kMembersPerCheckpoint == 0) {
      context.checkpoint("read", static_cast<std::size_t>(p - text.data()), text.size());
    }
    ++p;
  }
  return values;
}

}  // namespace

/// Processes the events of the parser. The last of the open lists and objects is the current one.
class JsonListener : public nlohmann::json_sax<Json> {
 public:
  JsonListener(std::vector<JsonValues::Span>& spans, std::string_view text, const std::string& name,
               const JsonValues::Fail& fail, Context& context)
      : spans_(spans), begin_(text.data()), places_(text, name, context), fail_(fail) {}

  void listen() {
    Json::sax_parse(places_.begin(), places_.end(), this);
    const char* const end = places_.early_end();
    if (end != nullptr)
      fail_(static_cast<std::size_t>(end - begin_), ErrorCode::Syntax, "not JSON");
  }

  bool null() override { return add_token(); }
  bool boolean(bool) override { return add_token(); }
  bool number_integer(number_integer_t) override { return add_number(); }
  bool number_unsigned(number_unsigned_t) override { return add_number(); }
  bool number_float(number_float_t, const string_t&) override { return add_number(); }
  bool string(string_t&) override { return add_token(); }
  bool key(string_t&) override { return add_token(); }
  bool binary(binary_t&) override { return false; }  // The event does not occur in texts.
  bool start_object(std::size_t) override { return open(); }
  bool end_object() override { return close(); }
  bool start_array(std::size_t) override { return open(); }
  bool end_array() override { return close(); }
  bool parse_error(std::size_t position, const std::string&,
                   const nlohmann::detail::exception& error) override {
    constexpr int kOverflow = 406;
    const bool is_overflow = error.id == kOverflow;
    fail_(position == 0 ? 0 : position - 1,
          is_overflow ? ErrorCode::NumberOutOfRange : ErrorCode::Syntax,
          is_overflow ? "a number too large" : "not JSON");
    return false;
  }

 private:
  static constexpr JsonValues::Id kNone = 0xffff'ffff;

  /// Whether the list is full. Further values are dropped, because the parser is about to find that
  /// the text is not JSON.
  bool is_full() const { return spans_.size() == spans_.capacity(); }
  JsonValues::Id add(JsonValues::Id next) {
    spans_.push_back({static_cast<std::uint32_t>(places_.token() - begin_), next});
    return static_cast<JsonValues::Id>(spans_.size() - 1);
  }
  bool add_here() {
    if (is_full()) return pass_over();
    add(static_cast<JsonValues::Id>(spans_.size() + 1));
    return true;
  }
  bool pass_over() {
    is_passed_over_ = true;
    return true;
  }
  bool add_token() {
    places_.find_token();
    return add_here();
  }
  bool add_number() {
    places_.find_number();
    return add_here();
  }
  bool open() {
    places_.find_token();
    if (is_full()) return pass_over();
    open_ = add(open_);
    return true;
  }
  bool close() {
    places_.find_token();
    if (is_passed_over_) return true;
    const auto next = static_cast<JsonValues::Id>(spans_.size());
    open_ = std::exchange(spans_[open_].next, next);
    return true;
  }

  std::vector<JsonValues::Span>& spans_;
  const char* begin_;
  JsonPlaces places_;
  const JsonValues::Fail& fail_;
  JsonValues::Id open_ = kNone;
  bool is_passed_over_ = false;
};

/// Lists the values of a text without the parser.
class PlainJson {
 public:
  /// Stores a reference to the list, which has enough capacity for all values of the text.
  PlainJson(std::vector<JsonValues::Span>& spans, std::string_view text, Context& context)
      : spans_(spans),
        context_(context),
        begin_(text.data()),
        p_(text.data()),
        end_(text.data() + text.size()) {}

  /// Lists all values. Returns false if the text is not known to be JSON.
  bool list() {
    if (!take_value()) return false;
    for (;;) {
      // A value has ended here.
      skip_blanks();
      if (open_ == kNone) return p_ == end_;
      if (p_ == end_) return false;
      const bool is_object = begin_[spans_[open_].begin] == '{';
      const char mark = *p_++;
      if (mark == ',') {
        if ((is_object && !take_name()) || !take_value()) return false;
      } else if (mark == (is_object ? '}' : ']')) {
        close();
      } else {
        return false;
      }
    }
  }

 private:
  static constexpr JsonValues::Id kNone = 0xffff'ffff;
  static constexpr std::ptrdiff_t kMostOfNumber = 200;

  bool at(char c) const { return p_ != end_ && *p_ == c; }
  bool at_digit() const { return p_ != end_ && '0' <= *p_ && *p_ <= '9'; }
  void skip_blanks() {
    const auto is_blank = [](char c) { return c == ' ' || c == '\n' || c == '\r' || c == '\t'; };
    if (p_ == end_ || !is_blank(*p_)) return;
    p_ = find_watched(p_, end_, context_, [&](char c) { return !is_blank(c); });
  }
  void add(JsonValues::Id next) {
    spans_.push_back({static_cast<std::uint32_t>(p_ - begin_), next});
    if (spans_.size() % kTokensPerCheckpoint == 0) {
      context_.checkpoint("read", static_cast<std::size_t>(p_ - begin_),
                          static_cast<std::size_t>(end_ - begin_));
    }
  }
  bool begins_value() {
    skip_blanks();
    return p_ != end_ && spans_.size() < spans_.capacity();
  }
  void close() {
    open_ = std::exchange(spans_[open_].next, static_cast<JsonValues::Id>(spans_.size()));
  }
  bool take_value();
  bool take_name();
  bool take_text();
  bool take_escape();
  bool take_word(std::string_view word);
  bool take_number();
  bool take_digits();

  std::vector<JsonValues::Span>& spans_;
  Context& context_;
  const char* begin_;
  const char* p_;
  const char* end_;
  JsonValues::Id open_ = kNone;
};

/// Reads a value, or the brackets and names before the first value in it that is not a bracket.
bool PlainJson::take_value() {
  while (begins_value()) {
    const char first = *p_;
    const auto number = static_cast<JsonValues::Id>(spans_.size());
    if (first != '{' && first != '[') {
      add(number + 1);
      if (first == '"') return take_text();
      if (first == 't') return take_word("true");
      if (first == 'f') return take_word("false");
      return first == 'n' ? take_word("null") : take_number();
    }
    add(std::exchange(open_, number));
    ++p_;
    skip_blanks();
    if (at(first == '{' ? '}' : ']')) {
      ++p_;
      close();
      return true;
    }
    if (first == '{' && !take_name()) return false;
  }
  return false;
}

/// Reads the name of a member with its colon.
bool PlainJson::take_name() {
  if (!begins_value() || *p_ != '"') return false;
  add(static_cast<JsonValues::Id>(spans_.size() + 1));
  if (!take_text()) return false;
  skip_blanks();
  if (!at(':')) return false;
  ++p_;
  return true;
}

bool PlainJson::take_text() {
  ++p_;
  for (;;) {
    p_ = find_watched(p_, end_, context_, [](char c) {
      const auto byte = static_cast<unsigned char>(c);
      return c == '"' || c == '\\' || byte < 0x20 || byte >= 0x80;
    });
    if (p_ == end_) return false;
    if (*p_ == '"') {
      ++p_;
      return true;
    }
    if (*p_ == '\\') {
      if (!take_escape()) return false;
      continue;
    }
    const std::size_t bytes = static_cast<unsigned char>(*p_) < 0x20 ? 0 : utf8_bytes(p_, end_);
    if (bytes == 0) return false;
    p_ += bytes;
  }
}

/// Reads an escape. Pairs of surrogates are left to the parser.
bool PlainJson::take_escape() {
  constexpr std::string_view kKnown = "\"\\/bfnrt";
  ++p_;
  if (p_ == end_) return false;
  if (kKnown.find(*p_) != kKnown.npos) {
    ++p_;
    return true;
  }
  if (*p_ != 'u' || end_ - p_ < 5) return false;
  std::uint32_t code = 0;
  const auto [last, error] = std::from_chars(p_ + 1, p_ + 5, code, 16);
  if (error != std::errc() || last != p_ + 5 || (code >= 0xD800 && code < 0xE000)) return false;
  p_ = last;
  return true;
}

bool PlainJson::take_word(std::string_view word) {
  if (!std::string_view(p_, static_cast<std::size_t>(end_ - p_)).starts_with(word)) return false;
  p_ += word.size();
  return true;
}

bool PlainJson::take_digits() {
  if (!at_digit()) return false;
  while (at_digit()) ++p_;
  return true;
}

/// Reads a number. If the number may exceed the largest double, it is left to the parser.
bool PlainJson::take_number() {
  constexpr std::ptrdiff_t kMostOfExponent = 2;
  const char* const first = p_;
  if (at('-')) ++p_;
  if (at('0')) {
    ++p_;
  } else if (!take_digits()) {
    return false;
  }
  if (at('.')) {
    ++p_;
    if (!take_digits()) return false;
  }
  if (at('e') || at('E')) {
    ++p_;
    if (at('-') || at('+')) ++p_;
    const char* const exponent = p_;
    if (!take_digits() || p_ - exponent > kMostOfExponent) return false;
  }
  return p_ - first <= kMostOfNumber;
}

JsonValues::JsonValues(std::string_view text, const std::string& name, const Fail& fail,
                       Context& context)
    : text_(text), context_(context), charge_(context) {
  if (text.size() >= 0xffff'ffff) fail(0, ErrorCode::ResourceLimit, "JSON of more than 2^32 bytes");
  // In JSON, every value except one needs a comma, a colon or a bracket.
  const std::uint64_t values =
      std::min<std::uint64_t>(count_values(text, context), text.size() / 2 + 1);
  charge_.add(values * sizeof(Span), "the JSON");
  spans_.reserve(values);
  if (PlainJson(spans_, text, context).list()) return;
  spans_.clear();
  MemoryCharge parsing(context);
  parsing.add(kParsingBytes * text.size(), "the JSON");
  JsonListener(spans_, text, name, fail, context).listen();
}

std::optional<JsonValues::Id> JsonValues::find(Id object, std::string_view name) const {
  std::optional<Id> found;
  const Id last = spans_[object].next;
  for (Id key = object + 1; key != last; key = spans_[key + 1].next) {
    if (++members_seen_ % kMembersPerCheckpoint == 0) context_.checkpoint("read", 0, 1);
    const auto plain = plain_text(key);
    if (plain ? *plain == name : text(key) == name) found = key + 1;
  }
  return found;
}

/// Returns the text of a value with its quotes.
std::string_view JsonValues::quoted(Id value) const {
  const std::string_view all = rest(value);
  std::size_t end = 1;
  while (all[end] != '"') end += all[end] == '\\' ? 2 : 1;
  return all.substr(0, end + 1);
}

std::string JsonValues::text(Id value) const {
  const std::string_view token = quoted(value);
  MemoryCharge charge(context_);
  charge.add((kParsingBytes + 1) * token.size(), "a text");
  return Json::parse(token).get<std::string>();
}

std::optional<std::string_view> JsonValues::plain_text(Id value) const {
  const std::string_view token = quoted(value);
  if (token.find('\\') != token.npos) return {};
  return token.substr(1, token.size() - 2);
}

std::optional<std::uint64_t> JsonValues::count(Id value) const {
  const std::string_view all = rest(value);
  std::uint64_t count = 0;
  const auto [end, code] = std::from_chars(all.data(), all.data() + all.size(), count);
  if (code != std::errc() || all.starts_with('-')) return {};
  const auto size = static_cast<std::size_t>(end - all.data());
  if (size < all.size() && std::string_view(".eE").find(all[size]) != std::string_view::npos) {
    return {};
  }
  return count;
}

double JsonValues::number(Id value) const {
  const std::string_view all = rest(value);
  return Json::parse(all.substr(0, all.find_first_not_of("+-.0123456789Ee"))).get<double>();
}

std::string_view JsonValues::source(Id value) const {
  const std::string_view all = rest(value);
  if (is_text(value)) return quoted(value);
  if (!is_object(value) && !is_list(value)) {
    const auto end = std::find_if(all.begin(), all.end(), [](char c) { return is_in(kEnds, c); });
    return all.substr(0, static_cast<std::size_t>(end - all.begin()));
  }
  // The text is valid JSON, so only brackets outside of texts matter.
  std::size_t open = 0, i = 0;
  do {
    if (all[i] == '"') {
      for (++i; all[i] != '"'; ++i) i += all[i] == '\\' ? 1 : 0;
    }
    if (all[i] == '{' || all[i] == '[') ++open;
    if (all[i] == '}' || all[i] == ']') --open;
    ++i;
  } while (open > 0);
  return all.substr(0, i);
}

}  // namespace plumb
