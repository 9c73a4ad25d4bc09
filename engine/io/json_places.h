// Where the tokens of a JSON text lie: the parser tells what they are, not where. For readers that listen to
// the events of nlohmann::json and call find_token() at the start of each (find_number() for numbers).
#pragma once

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <string>
#include <string_view>

#include "plumb/base/context.h"
#include "plumb/io/text_cursor.h"

namespace plumb {

class JsonPlaces {
 public:
  /// `text` must outlive it; `name` is the file in messages.
  JsonPlaces(std::string_view text, std::string name, Context& context);

  /// Walks the text and tells how far the parser has read.
  struct Iterator {
    using iterator_category = std::input_iterator_tag;
    using value_type = char;
    using difference_type = std::ptrdiff_t;
    using pointer = const char*;
    using reference = const char&;

    const char* at;
    const char** read_to;

    reference operator*() const { return *at; }
    Iterator& operator++() {
      *read_to = ++at;
      return *this;
    }
    Iterator operator++(int) {
      const Iterator old = *this;
      ++*this;
      return old;
    }
    friend bool operator==(const Iterator& a, const Iterator& b) { return a.at == b.at; }
  };
  /// What the parser reads. The object must stay where it is meanwhile.
  Iterator begin() { return {text_.data(), &read_to_}; }
  Iterator end() { return {text_.data() + text_.size(), &read_to_}; }

  /// The token of an event starts behind the last one, blanks and separators, and ends where the parser
  /// stands.
  void find_token();
  /// The parser sees that a number has ended by looking at what follows it.
  void find_number();

  const char* token() const { return token_; }
  std::string_view token_text() const {
    return {token_, static_cast<std::size_t>(token_end_ - token_)};
  }
  /// A cursor at the present token.
  const TextCursor& cursor_at_token() {
    cursor_.move_to(token_);
    return cursor_;
  }

  /// Fails anywhere before the position of the parser.
  [[noreturn]] void fail(ErrorCode code, const std::string& message, const char* where) const;
  /// What the parser complains of, at one of its positions: `id` and `what` are those of its exception.
  [[noreturn]] void fail_syntax(std::size_t position, int id, std::string_view what) const;

 private:
  std::string_view text_;
  std::string name_;
  TextCursor cursor_;
  Context& context_;
  const char* read_to_;
  const char* token_ = nullptr;  // the token of the current event
  const char* token_end_;
  std::size_t tokens_ = 0;
};

}  // namespace plumb
