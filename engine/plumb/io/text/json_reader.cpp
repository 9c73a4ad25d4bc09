// Places of JSON tokens, and JSON as a flat list of values.
//
// nlohmann-json reports events without places. JsonPlaces lets it read through an iterator that
// records how far it has read, so each token is found between the end of the last one and that
// position. JsonValues keeps 8 bytes for each value: its first byte, and the number of the value
// after it, which makes skipping a subtree O(1) and lists linked. Memory is known before parsing: a
// scan counts separators outside of quotes, which bounds the number of values, and the list is
// reserved once; if the parser reports more, the text is not JSON, and parsing will fail. Tested by
// tests/io/json_reader_test.cpp.
#include "plumb/io/text/json_reader.h"

#include <algorithm>
#include <charconv>
#include <nlohmann/json.hpp>
#include <utility>

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

/// The parser reads a long token to its end before it reports it.
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
constexpr std::size_t kBytesPerCheckpoint = 1U << 20U;
/// The parser keeps two copies of its last text, in buffers that double one at a time.
constexpr std::uint64_t kParsingBytes = 5;

/// Returns a bound on the number of values: they begin at the start of the text, or after brackets,
/// commas and colons outside of quotes.
std::uint64_t count_values(std::string_view text, Context& context) {
  std::uint64_t values = 1;
  bool is_quoted = false, is_escaped = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (i % kBytesPerCheckpoint == 0) context.checkpoint("read", i, text.size());
    const char c = text[i];
    const bool ends_quotes = c == '"' && !is_escaped;
    const bool is_mark = !is_quoted && (c == '[' || c == '{' || c == ',' || c == ':');
    is_escaped = is_quoted && c == '\\' && !is_escaped;
    is_quoted = is_quoted != ends_quotes;
    values += is_mark ? 1 : 0;
  }
  return values;
}

}  // namespace

/// Follows the parser's events. Of several open lists and objects the current one is the last.
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
  bool binary(binary_t&) override { return false; }  // Does not occur in texts.
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

  /// Whether the list is full. Further values are dropped: the parser is about to find that this is
  /// no JSON.
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

JsonValues::JsonValues(std::string_view text, const std::string& name, const Fail& fail,
                       Context& context)
    : text_(text), context_(context), charge_(context) {
  if (text.size() >= 0xffff'ffff) fail(0, ErrorCode::ResourceLimit, "JSON of more than 2^32 bytes");
  // In JSON a comma, a colon or a bracket goes with every value but one.
  const std::uint64_t values =
      std::min<std::uint64_t>(count_values(text, context), text.size() / 2 + 1);
  charge_.add(values * sizeof(Span), "the JSON");
  MemoryCharge parsing(context);
  parsing.add(kParsingBytes * text.size(), "the JSON");
  spans_.reserve(values);
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
    return all.substr(0, all.find_first_of(",]} \t\r\n"));
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
