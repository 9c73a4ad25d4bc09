// Reading of JSON with the places of its tokens: JsonPlaces for readers that follow a parser's
// events, and JsonValues, a flat list of all values.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <iterator>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "plumb/base/context.h"
#include "plumb/io/text/input_cursors.h"
#include "plumb/predicates/error.h"

namespace plumb {

/// A place in a text that a parser steps through; `on_step(at)` is called for each.
template <class OnStep>
struct SteppedText {
  using iterator_category = std::input_iterator_tag;
  using value_type = char;
  using difference_type = std::ptrdiff_t;
  using pointer = const char*;
  using reference = const char&;

  const char* at;
  OnStep on_step;

  reference operator*() const { return *at; }
  SteppedText& operator++() {
    on_step(++at);
    return *this;
  }
  SteppedText operator++(int) {
    const SteppedText old = *this;
    ++*this;
    return old;
  }
  friend bool operator==(const SteppedText& a, const SteppedText& b) { return a.at == b.at; }
};

// The places of the tokens of a JSON text. The parser reports tokens, but not their places. For
// readers that follow the events of nlohmann::json and call find_token() at the start of each
// (find_number() for numbers).

/// Finds the token of each event.
class JsonPlaces {
 public:
  /// `text` must outlive it; `name` is the file in messages.
  JsonPlaces(std::string_view text, std::string name, Context& context);

  /// Reports how far the parser has read.
  struct Reach {
    JsonPlaces* places;
    void operator()(const char* at) const {
      places->read_to_ = at;
      if (at >= places->next_check_) places->check_limits();
    }
  };
  using Iterator = SteppedText<Reach>;
  /// Returns what the parser reads. The object must stay where it is meanwhile.
  Iterator begin() { return {text_.data(), {this}}; }
  Iterator end() { return {text_.data() + text_.size(), {this}}; }

  /// Finds the token of an event: it starts behind the last token, blanks and separators, and ends
  /// where the parser stands.
  void find_token();
  /// Does the same for a number. The parser finds the end of a number only by reading the next
  /// character.
  void find_number();

  /// Returns where the parser took a zero byte for the end of the text although more than such
  /// bytes and blanks follow; else null.
  const char* early_end() const;
  /// Throws at that place after the parser has ended.
  void require_end() const;

  const char* token() const { return token_; }
  std::string_view token_text() const {
    return {token_, static_cast<std::size_t>(token_end_ - token_)};
  }
  /// Returns a cursor at the current token.
  const TextCursor& cursor_at_token() {
    cursor_.move_to(token_);
    return cursor_;
  }

  /// Throws anywhere before the position of the parser.
  [[noreturn]] void fail(ErrorCode code, const std::string& message, const char* where) const;
  /// Throws the error of the parser, at one of its positions. `id` and `what` come from the
  /// exception of the parser.
  [[noreturn]] void fail_syntax(std::size_t position, int id, std::string_view what) const;

 private:
  void check_limits();

  std::string_view text_;
  std::string name_;
  TextCursor cursor_;
  Context& context_;
  const char* read_to_;
  const char* next_check_;
  const char* token_ = nullptr;  // The token of the current event.
  const char* token_end_;
  std::size_t tokens_ = 0;
};

// A JSON text as a flat list of its values: 8 bytes for each value, independent of its place and
// contents. Texts and numbers stay in the JSON and are read on demand.
//  1. count   A pass over the bytes counts values, so that the list is charged and reserved before
//             it is filled, for no more values than a text of its size can hold
//  2. list    a pass over texts of the usual form lists the values. For others,
//             nlohmann-json splits the text into events (no recursion, no tree); each value notes
//             where it begins and, when it ends, which value comes after it
//
// A name comes before its member as one more value. Cost: O(bytes).

/// The values of a JSON text.
class JsonValues {
 public:
  /// A value by its number in the text. The document itself is number 0.
  using Id = std::uint32_t;
  static constexpr Id kDocument = 0;

  /// Throws an error at a byte of the text. Does not return.
  using Fail = std::function<void(std::size_t byte, ErrorCode code, const std::string& what)>;

  /// Keeps the text, which must outlive it, and the context. `name` is the file in messages. Throws
  /// errors of `fail` for Syntax, NumberOutOfRange and ResourceLimit, and Error{Cancelled}.
  JsonValues(std::string_view text, const std::string& name, const Fail& fail, Context& context);

  bool is_object(Id value) const { return first_byte(value) == '{'; }
  bool is_list(Id value) const { return first_byte(value) == '['; }
  bool is_text(Id value) const { return first_byte(value) == '"'; }
  bool is_true(Id value) const { return first_byte(value) == 't'; }
  bool is_false(Id value) const { return first_byte(value) == 'f'; }
  bool is_number(Id value) const {
    const char c = first_byte(value);
    return c == '-' || ('0' <= c && c <= '9');
  }

  /// The values of a list in their order: for (const Id item : values.items(list)).
  class Items {
   public:
    struct Iterator {
      using iterator_category = std::forward_iterator_tag;
      using value_type = Id;
      using difference_type = std::ptrdiff_t;
      using pointer = const Id*;
      using reference = Id;

      const JsonValues* values;
      Id at;

      Id operator*() const { return at; }
      Iterator& operator++() {
        at = values->spans_[at].next;
        return *this;
      }
      friend bool operator==(const Iterator& a, const Iterator& b) { return a.at == b.at; }
    };

    Items(const JsonValues* values, Id first, Id last)
        : values_(values), first_(first), last_(last) {}
    Iterator begin() const { return {values_, first_}; }
    Iterator end() const { return {values_, last_}; }
    bool empty() const { return first_ == last_; }
    std::size_t size() const {  ///< Cost: O(size).
      return static_cast<std::size_t>(std::distance(begin(), end()));
    }

   private:
    const JsonValues* values_;
    Id first_, last_;
  };
  Items items(Id list) const { return {this, list + 1, spans_[list].next}; }

  /// Returns the member of that name, the last if there are several. Cost: O(members).
  std::optional<Id> find(Id object, std::string_view name) const;

  /// Returns the text of a value, its escapes resolved. Requires is_text().
  std::string text(Id value) const;
  /// Returns the part of the JSON that `text` would return; no value if it has escapes.
  std::optional<std::string_view> plain_text(Id value) const;
  /// Returns a number without a sign, a point and an exponent; no value for any other, or one
  /// beyond 64 bits.
  std::optional<std::uint64_t> count(Id value) const;
  /// Returns the nearest double. Requires is_number().
  double number(Id value) const;

  /// Returns the byte of the text at which a value begins.
  std::size_t byte(Id value) const { return spans_[value].begin; }
  /// Returns a value as it stands in the text. Cost: O(bytes of the value).
  std::string_view source(Id value) const;

 private:
  struct Span {
    std::uint32_t begin;  ///< First byte.
    /// The value after all values that this value contains. While this value is open: the value
    /// that contains it.
    Id next;
  };
  friend class JsonListener;
  friend class PlainJson;

  char first_byte(Id value) const { return text_[spans_[value].begin]; }
  std::string_view rest(Id value) const { return text_.substr(spans_[value].begin); }
  std::string_view quoted(Id value) const;

  std::string_view text_;
  Context& context_;
  MemoryCharge charge_;
  std::vector<Span> spans_;
  mutable std::size_t members_seen_ = 0;
};

}  // namespace plumb
