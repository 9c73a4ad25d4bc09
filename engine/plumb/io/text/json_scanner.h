// Tokens of JSON texts with their places, for readers that read some values and skip all others.
//
// Broader than JSON where files are, and where nothing depends on it:
//   - a text may hold several values one after the other, with blanks or record separators (RFC
//     8142) between them
//   - a value that is skipped may hold anything between its brackets and quotes: NaN, bytes that
//     are not UTF-8, values without commas
//   - a number may have a form that JSON does not know, such as 1. or 01; its reader judges it
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "plumb/base/context.h"
#include "plumb/io/text/input_cursors.h"
#include "plumb/predicates/error.h"

namespace plumb {

/// Kinds of tokens. Commas and colons are no tokens.
enum class JsonToken : std::uint8_t {
  BeginObject,
  EndObject,
  BeginArray,
  EndArray,
  Name,  ///< The name of a member; its value follows.
  String,
  Number,
  Null,
  Word,  ///< Another word: true, false, or a word that is not JSON, such as NaN.
  End,   ///< The end of the text.
};

/// Splits a JSON text into tokens. Throws Error{Syntax} with the place where the text is not JSON,
/// and the errors of the Context. Cost: O(bytes); memory is one bit for each open bracket.
class JsonScanner {
 public:
  /// Keeps `text` and `context`, which must outlive it. `name` is the file in messages.
  JsonScanner(std::string_view text, std::string name, Context& context);

  /// Finds the next token. After Name it is the beginning of a value. End comes after at least one
  /// value.
  JsonToken next();
  /// Passes over the value of the name that next() found, and returns its text.
  std::string_view skip_value();

  const char* token() const { return token_; }
  std::string_view token_text() const { return {token_, static_cast<std::size_t>(p_ - token_)}; }
  /// Returns the text of a Name or a String without its quotes, its escapes resolved. The view is
  /// valid until the next call.
  std::string_view string_text();
  /// Returns a cursor at the current token.
  const TextCursor& cursor_at_token() {
    cursor_.move_to(token_);
    return cursor_;
  }

  /// Throws anywhere before the end of the current token.
  [[noreturn]] void fail(ErrorCode code, const std::string& message, const char* where) const;

 private:
  /// The kind of token before the position.
  enum class Before : std::uint8_t { Bracket, Name, Value };

  bool at(char c) const { return p_ != end_ && *p_ == c; }
  void skip_blanks();
  void check_context();
  void take_colon();
  JsonToken read_value();
  JsonToken read_name();
  JsonToken read_number();
  JsonToken read_word();
  JsonToken open();
  JsonToken close();
  void open_bracket();
  void close_bracket();
  void read_string();
  void skip_string();
  void skip_brackets();
  const char* end_of_word(const char* first) const;
  [[noreturn]] void fail_expected(const char* what) const;

  std::string_view text_;
  std::string name_;
  TextCursor cursor_;
  Context& context_;
  const char* p_;
  const char* end_;
  const char* token_;
  std::vector<bool> open_;  // For each open bracket, whether it belongs to an object.
  Before before_ = Before::Bracket;
  bool has_value_ = false;
  std::size_t steps_ = 0;
  std::string decoded_;
};

}  // namespace plumb
