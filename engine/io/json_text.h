// A text that a JSON parser steps through.
#pragma once

#include <cstddef>
#include <iterator>

namespace plumb {

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

}  // namespace plumb
