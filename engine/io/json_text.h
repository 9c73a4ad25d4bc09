// JSON that becomes a tree in memory: what the tree takes, and a text that a parser can be stopped in.
#pragma once

#include <cstddef>
#include <cstdint>
#include <iterator>
#include <string_view>

#include "plumb/base/context.h"

namespace plumb {

/// No less than nlohmann::json takes for `text`, whatever it holds, while it is parsed and after. O(bytes).
inline std::uint64_t bytes_of_json_tree(std::string_view text) {
  constexpr std::uint64_t kAny = 6;       // of a text, as it grows, and once more as it is kept
  constexpr std::uint64_t kQuote = 40;    // half a text
  constexpr std::uint64_t kElement = 48;  // after a comma, as lists grow
  constexpr std::uint64_t kMember = 112;  // of an object
  constexpr std::uint64_t kOpening =
      128;  // a list or object, its first element, the parser's place
  std::uint64_t bytes = kAny * text.size();
  for (const char c : text) {
    if (c == '"') bytes += kQuote;
    if (c == ',') bytes += kElement;
    if (c == ':') bytes += kMember;
    if (c == '[' || c == '{') bytes += kOpening;
  }
  return bytes;
}

/// A place in a text; stepping on it makes a checkpoint now and then.
struct WatchedText {
  using iterator_category = std::input_iterator_tag;
  using value_type = char;
  using difference_type = std::ptrdiff_t;
  using pointer = const char*;
  using reference = const char&;

  static WatchedText begin(std::string_view text, Context& context) {
    return {text.data(), text, &context};
  }
  static WatchedText end(std::string_view text, Context& context) {
    return {text.data() + text.size(), text, &context};
  }

  const char* at;
  std::string_view text;
  Context* context;

  reference operator*() const { return *at; }
  WatchedText& operator++() {
    constexpr std::size_t kBytesPerCheckpoint = 65536;
    const auto read = static_cast<std::size_t>(++at - text.data());
    if (read % kBytesPerCheckpoint == 0) context->checkpoint("read", read, text.size());
    return *this;
  }
  WatchedText operator++(int) {
    const WatchedText old = *this;
    ++*this;
    return old;
  }
  friend bool operator==(const WatchedText& a, const WatchedText& b) { return a.at == b.at; }
};

}  // namespace plumb
