// Walks the binary part of a file: numbers of fixed size, in either byte order.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <utility>

#include "plumb/base/error.h"

namespace plumb {

class BinaryInput {
 public:
  /// From byte `start` of the file on. `bytes` must outlive the input; `name` is the file in
  /// messages.
  BinaryInput(std::string_view bytes, std::size_t start, std::endian order, std::string name)
      : bytes_(bytes),
        at_(start),
        is_swapped_(order != std::endian::native),
        name_(std::move(name)) {}

  std::size_t position() const { return at_; }
  std::size_t bytes_left() const { return bytes_.size() - at_; }

  /// Requires `bytes` <= bytes_left().
  void skip(std::size_t bytes) { at_ += bytes; }

  /// An integer or a floating-point number. Requires sizeof(Number) <= bytes_left().
  template <class Number>
  Number take() {
    char raw[sizeof(Number)];
    std::memcpy(raw, bytes_.data() + at_, sizeof(Number));
    if (is_swapped_) {
      for (std::size_t i = 0; i < sizeof(Number) / 2; ++i) {
        std::swap(raw[i], raw[sizeof(Number) - 1 - i]);
      }
    }
    at_ += sizeof(Number);
    return std::bit_cast<Number>(raw);
  }

  /// Throws "FILE: at byte N: message", N from 0.
  [[noreturn]] void fail(ErrorCode code, const std::string& message, std::size_t at) const {
    throw Error(code, "at byte " + std::to_string(at) + ": " + message, {name_});
  }
  [[noreturn]] void fail(ErrorCode code, const std::string& message) const {
    fail(code, message, at_);
  }

 private:
  std::string_view bytes_;
  std::size_t at_;
  bool is_swapped_;
  std::string name_;
};

}  // namespace plumb
