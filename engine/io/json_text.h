// Texts that a JSON parser steps through and can be stopped in, and what the tree it makes of them takes.
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

/// A place in a text, for a parser to step through it; `on_step(at)` is told of each.
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

/// Makes a checkpoint now and then.
struct CheckpointSteps {
  const char* begin;
  std::size_t size;
  Context* context;

  void operator()(const char* at) const {
    constexpr std::size_t kBytesPerCheckpoint = 65536;
    const auto read = static_cast<std::size_t>(at - begin);
    if (read % kBytesPerCheckpoint == 0) context->checkpoint("read", read, size);
  }
};

}  // namespace plumb
