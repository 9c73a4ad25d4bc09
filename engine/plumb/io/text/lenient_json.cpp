// Replaces the parts of a text that are not JSON.
//
// The copy is made in one pass. Outside of quotes, a word is a run of characters without blanks and
// marks; every word that is not JSON is replaced, even in the place of a name, because the parser
// detects this error afterwards. Inside quotes, UTF-8 is checked as the parser checks it. Tested by
// tests/io/json_reader_test.cpp.
#include "plumb/io/text/lenient_json.h"

#include <algorithm>
#include <array>
#include <cstdint>

#include "plumb/io/text/utf8.h"
#include "plumb/predicates/error.h"

namespace plumb {
namespace {

constexpr std::string_view kReplacement = "\xEF\xBF\xBD";  // This is the character U+FFFD.
constexpr std::ptrdiff_t kBytesPerCheck = std::ptrdiff_t{1} << 16;

bool ends_word(char c) {
  return static_cast<unsigned char>(c) <= 0x20 ||
         std::string_view(",:\"[]{}").find(c) != std::string_view::npos;
}

bool is_hex_digit(char c) {
  return ('0' <= c && c <= '9') || ('a' <= c && c <= 'f') || ('A' <= c && c <= 'F');
}

/// Whether the word is a word of JSON or a number, which the parser checks.
bool is_of_json(std::string_view word) {
  if (word == "null" || word == "true" || word == "false") return true;
  return word.find_first_not_of("+-.0123456789Ee") == word.npos &&
         word.find_first_of("0123456789") != word.npos;
}

/// Returns the code of an escape \uXXXX at `p`, or no value if there is none.
std::optional<std::uint32_t> escaped_code(const char* p, const char* end) {
  if (end - p < 6 || p[0] != '\\' || p[1] != 'u') return {};
  if (!std::all_of(p + 2, p + 6, is_hex_digit)) return {};
  return static_cast<std::uint32_t>(std::stoul(std::string(p + 2, p + 6), nullptr, 16));
}

bool is_high_half(std::uint32_t code) { return code >= 0xD800 && code < 0xDC00; }
bool is_low_half(std::uint32_t code) { return code >= 0xDC00 && code < 0xE000; }

}  // namespace

JsonCopy::JsonCopy(std::string_view text, Context& context)
    : context_(context),
      charge_(context),
      begin_(text.data()),
      end_(text.data() + text.size()),
      next_check_(begin_) {
  for (const char* p = begin_; p != end_;) {
    watch(p);
    if (*p == '"') {
      p = add_quoted(p);
    } else if (ends_word(*p)) {
      add({p++, 1});
    } else {
      p = add_word(p);
    }
  }
}

void JsonCopy::watch(const char* p) {
  if (p < next_check_) return;
  context_.checkpoint("read", static_cast<std::size_t>(p - begin_),
                      static_cast<std::size_t>(end_ - begin_));
  next_check_ = p + std::min(kBytesPerCheck, end_ - p);
}

void JsonCopy::add(std::string_view piece) {
  if (text_.size() + piece.size() > charged_) {
    const std::size_t room =
        std::max<std::size_t>(2 * text_.size(), static_cast<std::size_t>(end_ - begin_)) +
        piece.size();
    charge_.add(room - charged_, "the JSON");
    charged_ = room;
    text_.reserve(room);
  }
  text_ += piece;
}

/// Adds a piece that replaces the text up to `end`, and counts it.
void JsonCopy::replace(std::string_view piece, const char* end, std::size_t& count) {
  constexpr std::uint64_t kGrowth = 2;
  charge_.add(kGrowth * sizeof(behind_[0]), "the JSON");
  add(piece);
  behind_.emplace_back(text_.size(), static_cast<std::size_t>(end - begin_));
  ++count;
}

const char* JsonCopy::add_word(const char* p) {
  const char* const end = std::find_if(p, end_, ends_word);
  const std::string_view word(p, static_cast<std::size_t>(end - p));
  if (is_of_json(word)) {
    add(word);
  } else {
    replace(word == "True" ? "true" : word == "False" ? "false" : "null", end, replaced_.words);
  }
  return end;
}

/// Adds a text with its quotes. A text without an end is left to the parser.
const char* JsonCopy::add_quoted(const char* p) {
  constexpr std::string_view kDigits = "0123456789abcdef";
  add({p++, 1});
  while (p != end_ && *p != '"') {
    watch(p);
    const auto byte = static_cast<unsigned char>(*p);
    if (byte == '\\') {
      p = add_escape(p);
    } else if (byte < 0x20) {
      const std::string escape = {'\\', 'u', '0', '0', kDigits[byte >> 4U], kDigits[byte & 15U]};
      replace(escape, p + 1, replaced_.pieces);
      ++p;
    } else if (const std::size_t count = utf8_bytes(p, end_); count > 0) {
      add({p, count});
      p += count;
    } else {
      replace(kReplacement, p + 1, replaced_.pieces);
      ++p;
    }
  }
  if (p == end_) return p;
  add({p, 1});
  return p + 1;
}

const char* JsonCopy::add_escape(const char* p) {
  constexpr std::string_view kKnown = "\"\\/bfnrt";
  if (const auto code = escaped_code(p, end_)) {
    const auto next = escaped_code(p + 6, end_);
    const bool is_pair = is_high_half(*code) && next && is_low_half(*next);
    const std::ptrdiff_t size = is_pair ? 12 : 6;
    if (!is_pair && (is_high_half(*code) || is_low_half(*code))) {
      replace(kReplacement, p + size, replaced_.pieces);
    } else {
      add({p, static_cast<std::size_t>(size)});
    }
    return p + size;
  }
  if (p + 1 != end_ && kKnown.find(p[1]) != kKnown.npos) {
    add({p, 2});
    return p + 2;
  }
  replace("\\\\", p + 1, replaced_.pieces);
  return p + 1;
}

std::size_t JsonCopy::byte_of_text(std::size_t byte_of_copy) const {
  const auto after =
      std::upper_bound(behind_.begin(), behind_.end(), byte_of_copy,
                       [](std::size_t byte, const auto& piece) { return byte < piece.first; });
  const auto [copied, at] =
      after == behind_.begin() ? std::pair<std::size_t, std::size_t>{0, 0} : *std::prev(after);
  // Inside of a replaced piece, the byte lies before the end of that piece.
  const std::size_t limit =
      after == behind_.end() ? static_cast<std::size_t>(end_ - begin_) : after->second;
  return std::min(at + (byte_of_copy - copied), limit);
}

std::string JsonReplaced::note() const {
  std::string text = "not JSON, replaced:";
  if (words > 0) text += " words such as NaN by null (" + std::to_string(words) + ')';
  if (words > 0 && pieces > 0) text += ',';
  if (pieces > 0) text += " characters of texts (" + std::to_string(pieces) + ')';
  return text;
}

LenientJson::LenientJson(std::string_view text, const std::string& name,
                         const JsonValues::Fail& fail, Context& context) {
  try {
    values_.emplace(text, name, fail, context);
    return;
  } catch (const Error& error) {
    if (error.code() != ErrorCode::Syntax) throw;
    copy_.emplace(text, context);
    if (copy_->replaced().is_none()) throw;
    // The copy may be longer than the text.
    const auto fail_in_text = [&](std::size_t byte, ErrorCode code, const std::string& what) {
      fail(copy_->byte_of_text(byte), code, what);
    };
    try {
      values_.emplace(copy_->text(), name, fail_in_text, context);
    } catch (const Error& other) {
      if (other.code() != ErrorCode::Syntax) throw;
      throw error;
    }
  }
}

std::size_t LenientJson::byte(JsonValues::Id value) const {
  const std::size_t byte = values_->byte(value);
  return copy_ ? copy_->byte_of_text(byte) : byte;
}

}  // namespace plumb
