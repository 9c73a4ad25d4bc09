// Where the tokens of a JSON text lie: the parser tells what they are, not where. For readers that listen to
// the events of nlohmann::json and call find_token() at the start of each (find_number() for numbers).
#pragma once

#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>

#include "plumb/base/context.h"
#include "plumb/io/json_text.h"
#include "plumb/io/text_cursor.h"

namespace plumb {

class JsonPlaces {
 public:
  /// `text` must outlive it; `name` is the file in messages.
  JsonPlaces(std::string_view text, std::string name, Context& context);

  /// Tells how far the parser has read.
  struct Reach {
    const char** read_to;
    void operator()(const char* at) const { *read_to = at; }
  };
  using Iterator = SteppedText<Reach>;
  /// What the parser reads. The object must stay where it is meanwhile.
  Iterator begin() { return {text_.data(), {&read_to_}}; }
  Iterator end() { return {text_.data() + text_.size(), {&read_to_}}; }

  /// The token of an event starts behind the last one, blanks and separators, and ends where the parser
  /// stands.
  void find_token();
  /// The parser sees that a number has ended by looking at what follows it.
  void find_number();

  /// The parser takes a zero byte for the end of the text. Where it did so, if more than such bytes and blanks follow; else null.
  const char* early_end() const;
  /// After the parser's end: fails there.
  void require_end() const;

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
