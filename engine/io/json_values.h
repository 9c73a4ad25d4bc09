// A JSON text as a flat list of its values: 8 bytes for each, wherever it stands and whatever it holds. Texts and numbers
// stay in the JSON and are read when somebody asks for them.
//
//   1. a pass over the bytes counts values, so that the list is charged and reserved before it is filled; for no more
//      values than a text of its size can hold
//   2. nlohmann-json splits the text into events (no recursion, no tree); each value notes where it begins and, when it
//      ends, which value comes after it
//
// A name comes before its member as one more value. Cost: O(bytes).
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <iterator>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "plumb/base/context.h"
#include "plumb/base/error.h"

namespace plumb {

class JsonValues {
 public:
  /// A value by its number in the text. The document itself is number 0.
  using Id = std::uint32_t;
  static constexpr Id kDocument = 0;

  /// Throws what is wrong at a byte of the text. Does not return.
  using Fail = std::function<void(std::size_t byte, ErrorCode code, const std::string& what)>;

  /// Keeps the text, which must outlive it, and the context. `name` is the file in messages. Errors: those of `fail` for
  /// Syntax, NumberOutOfRange and ResourceLimit; Cancelled.
  JsonValues(std::string_view text, const std::string& name, const Fail& fail, Context& context);

  bool is_object(Id value) const { return first_byte(value) == '{'; }
  bool is_list(Id value) const { return first_byte(value) == '['; }
  bool is_text(Id value) const { return first_byte(value) == '"'; }
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
    std::size_t size() const {  ///< O(size)
      return static_cast<std::size_t>(std::distance(begin(), end()));
    }

   private:
    const JsonValues* values_;
    Id first_, last_;
  };
  Items items(Id list) const { return {this, list + 1, spans_[list].next}; }

  /// The member of that name, the last if there are more. O(members).
  std::optional<Id> find(Id object, std::string_view name) const;

  /// Requires is_text(): what it says, its escapes resolved.
  std::string text(Id value) const;
  /// What `text` would say, where it lies; none if it has escapes.
  std::optional<std::string_view> plain_text(Id value) const;
  /// None if it is not a number without a sign, a point and an exponent, or one beyond 64 bits.
  std::optional<std::uint64_t> count(Id value) const;
  /// Requires is_number(): the nearest double.
  double number(Id value) const;

 private:
  struct Span {
    std::uint32_t begin;  ///< its first byte
    Id next;  ///< the value after all that it holds; while it is open, the one it lies in
  };
  friend class JsonListener;

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
