// A mutator for glTF: bytes changed anywhere break the JSON or the lengths of chunks, and nothing
// of what follows is tried. It changes numbers of the JSON and bytes of the binary chunk, and
// writes the container anew.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <random>
#include <string>
#include <string_view>
#include <vector>

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t max_size);

namespace plumb::fuzz {

class GltfMutator {
 public:
  explicit GltfMutator(unsigned seed) : random_(seed + 1) {}

  /// What LLVMFuzzerCustomMutator does. One time in sixteen libFuzzer's own mutation.
  std::size_t mutate(std::uint8_t* data, std::size_t size, std::size_t max_size) {
    if (random_() % 16 == 0 || !take_apart({reinterpret_cast<const char*>(data), size})) {
      return LLVMFuzzerMutate(data, size, max_size);
    }
    if (!binary_.empty() && random_() % 2 == 0) {
      change_byte();
    } else {
      change_number();
    }
    const std::string bytes = put_together();
    if (bytes.size() > max_size) return LLVMFuzzerMutate(data, size, max_size);
    std::copy(bytes.begin(), bytes.end(), data);
    return bytes.size();
  }

 private:
  static constexpr std::size_t kHeader = 12, kChunk = 8;

  static std::uint32_t number_at(std::string_view bytes, std::size_t at) {
    std::uint32_t value = 0;
    for (std::size_t i = 4; i-- > 0;)
      value = value << 8U | static_cast<std::uint8_t>(bytes[at + i]);
    return value;
  }
  static void append_number(std::string& bytes, std::size_t value) {
    for (unsigned i = 0; i < 4; ++i) bytes += static_cast<char>(value >> (8 * i));
  }

  /// JSON alone, or a container with its JSON and perhaps a binary chunk.
  bool take_apart(std::string_view bytes) {
    binary_.clear();
    is_container_ = bytes.starts_with("glTF");
    if (!is_container_) {
      json_ = bytes;
      return bytes.starts_with("{");
    }
    if (bytes.size() < kHeader + kChunk) return false;
    const std::size_t json = number_at(bytes, kHeader);
    if (json > bytes.size() - kHeader - kChunk) return false;
    json_ = bytes.substr(kHeader + kChunk, json);
    const std::string_view rest = bytes.substr(kHeader + kChunk + json);
    if (rest.size() > kChunk) binary_ = rest.substr(kChunk);
    return true;
  }

  std::string put_together() const {
    if (!is_container_) return json_;
    std::string json = json_.substr(0, json_.find_last_not_of(' ') + 1);
    json.resize((json.size() + 3) / 4 * 4, ' ');
    std::string bytes = "glTF";
    append_number(bytes, 2);
    append_number(bytes,
                  kHeader + kChunk + json.size() + (binary_.empty() ? 0 : kChunk + binary_.size()));
    append_number(bytes, json.size());
    bytes += "JSON" + json;
    if (binary_.empty()) return bytes;
    append_number(bytes, binary_.size());
    return bytes + std::string("BIN\0", 4) + binary_;
  }

  /// Small numbers are indices, bytes that differ in a bit are floats of the same size.
  void change_byte() {
    char& byte = binary_[random_() % binary_.size()];
    const auto bit = static_cast<char>(1U << (random_() >> 8U) % 8);
    byte = random_() % 2 == 0 ? static_cast<char>((random_() >> 8U) % 8)
                              : static_cast<char>(byte ^ bit);
  }

  void change_number() {
    std::vector<std::size_t> starts;
    for (std::size_t i = 1; i < json_.size(); ++i) {
      if (is_digit(json_[i]) && !is_digit(json_[i - 1]) && json_[i - 1] != '.') starts.push_back(i);
    }
    if (starts.empty()) return;
    const std::size_t start = starts[random_() % starts.size()];
    std::size_t end = start;
    while (end < json_.size() && is_digit(json_[end])) ++end;
    json_.replace(start, end - start,
                  other_number(json_.substr(start, std::min<std::size_t>(9, end - start))));
  }
  std::string other_number(const std::string& digits) {
    const std::size_t value = std::stoul(digits);
    switch (random_() % 6) {
      case 0:
        return std::to_string(value + 1);
      case 1:
        return std::to_string(value - (value > 0 ? 1 : 0));
      case 2:
        return std::to_string(value / 2);
      case 3:
        return std::to_string(5120 + random_() % 7);  // types of components
      default:
        return std::to_string(random_() % 8);
    }
  }
  static bool is_digit(char c) { return c >= '0' && c <= '9'; }

  std::minstd_rand random_;
  bool is_container_ = false;
  std::string json_;
  std::string binary_;
};

}  // namespace plumb::fuzz
