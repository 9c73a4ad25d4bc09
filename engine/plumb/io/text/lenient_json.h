// JSON as programs write it: with NaN, with control characters and bytes that are not UTF-8 in
// texts, and with escapes that JSON does not define.
//
// A text is parsed as it stands. Only if it is not JSON, a copy is made in which each such piece
// is replaced by what JSON has for it:
//   a word outside of texts, such as NaN, -inf or 1.#QNAN   null; True and False become true, false
//   a control character in a text                           its escape
//   bytes that are not UTF-8, half a surrogate pair         U+FFFD
//   a backslash that begins no escape                       an escaped backslash
// If the copy is not JSON either, the error of the text itself is thrown.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "plumb/base/context.h"
#include "plumb/io/text/json_reader.h"

namespace plumb {

/// The counts of replacements in a text, or in several texts.
struct JsonReplaced {
  std::size_t words = 0;   ///< Words outside of texts.
  std::size_t pieces = 0;  ///< Characters and escapes in texts.

  bool is_none() const { return words + pieces == 0; }
  void add(const JsonReplaced& other) {
    words += other.words;
    pieces += other.pieces;
  }
  /// Returns a note for a human reader. Requires !is_none().
  std::string note() const;
};

/// The copy of a text in which everything that is not JSON is replaced.
class JsonCopy {
 public:
  /// Makes the copy. Its memory is charged until the object ends. Cost: O(bytes).
  JsonCopy(std::string_view text, Context& context);

  const std::string& text() const { return text_; }
  const JsonReplaced& replaced() const { return replaced_; }
  /// Returns the byte of the text that became a byte of the copy. Cost: O(log(replaced pieces)).
  std::size_t byte_of_text(std::size_t byte_of_copy) const;

 private:
  const char* add_word(const char* p);
  const char* add_quoted(const char* p);
  const char* add_escape(const char* p);
  void replace(std::string_view piece, const char* end, std::size_t& count);
  void add(std::string_view piece);
  void watch(const char* p);

  Context& context_;
  MemoryCharge charge_;
  const char* begin_;
  const char* end_;
  const char* next_check_;
  std::size_t charged_ = 0;
  JsonReplaced replaced_;
  std::string text_;
  /// For each replaced piece, the offsets at which the text behind it begins: in the copy, and in
  /// the original text.
  std::vector<std::pair<std::size_t, std::size_t>> behind_;
};

/// The values of a text that is JSON, or of its copy.
class LenientJson {
 public:
  /// As JsonValues(). `fail` gets bytes of the text.
  LenientJson(std::string_view text, const std::string& name, const JsonValues::Fail& fail,
              Context& context);

  const JsonValues& values() const { return *values_; }
  /// Returns the byte of the text at which a value begins.
  std::size_t byte(JsonValues::Id value) const;
  /// Returns the replaced pieces. There are none if the text is JSON.
  JsonReplaced replaced() const { return copy_ ? copy_->replaced() : JsonReplaced{}; }

 private:
  std::optional<JsonCopy> copy_;
  std::optional<JsonValues> values_;
};

}  // namespace plumb
