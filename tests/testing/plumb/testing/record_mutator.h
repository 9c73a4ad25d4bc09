// A mutator for inputs that are records of one size: it inserts, erases, swaps and changes records,
// so that what follows a change keeps its meaning.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <random>
#include <span>
#include <vector>

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t max_size);

namespace plumb::fuzz {

class RecordMutator {
 public:
  RecordMutator(std::size_t record, unsigned seed) : record_(record), random_(seed + 1) {}

  /// What LLVMFuzzerCustomMutator does. One time in eight libFuzzer's own mutation, which also
  /// draws on its dictionary of comparisons.
  std::size_t mutate(std::uint8_t* data, std::size_t size, std::size_t max_size) {
    if (random_() % 8 == 0) return LLVMFuzzerMutate(data, size, max_size);
    bytes_.assign(data, data + size);
    bytes_.resize(std::max(record_, size / record_ * record_));
    change();
    const std::size_t kept = std::min(bytes_.size(), max_size);
    std::copy_n(bytes_.begin(), kept, data);
    return kept;
  }

  /// What LLVMFuzzerCustomCrossOver does: records of one program, then records of the other.
  std::size_t cross(std::span<const std::uint8_t> first, std::span<const std::uint8_t> second,
                    std::uint8_t* out, std::size_t max_size) {
    const auto head = first.first(some_records(first.size()));
    const auto tail =
        second.first(second.size() / record_ * record_).last(some_records(second.size()));
    bytes_.assign(head.begin(), head.end());
    bytes_.insert(bytes_.end(), tail.begin(), tail.end());
    const std::size_t kept = std::min(bytes_.size(), max_size);
    std::copy_n(bytes_.begin(), kept, out);
    return kept;
  }

 private:
  std::uint8_t any_byte() { return static_cast<std::uint8_t>(random_() >> 8); }
  std::ptrdiff_t any_record() {
    return static_cast<std::ptrdiff_t>(random_() % (bytes_.size() / record_) * record_);
  }

  /// A number of bytes: whole records of `size`, one at least if there is one.
  std::size_t some_records(std::size_t size) {
    const std::size_t records = size / record_;
    return records == 0 ? 0 : (1 + random_() % records) * record_;
  }

  void change() {
    switch (random_() % 5) {
      case 0:
        return insert_record();
      case 1:
        return erase_record();
      case 2:
        return swap_records();
      case 3:
        bytes_[random_() % record_] = any_byte();  // the first one often says most
        return;
      default:
        bytes_[random_() % bytes_.size()] = any_byte();
        return;
    }
  }

  void insert_record() {
    std::vector<std::uint8_t> record(record_);
    for (std::uint8_t& byte : record) byte = any_byte();
    const std::ptrdiff_t at = any_record() + static_cast<std::ptrdiff_t>(record_);
    bytes_.insert(bytes_.begin() + at, record.begin(), record.end());
  }

  void erase_record() {
    if (bytes_.size() <= record_) return;
    const std::ptrdiff_t at = any_record();
    bytes_.erase(bytes_.begin() + at, bytes_.begin() + at + static_cast<std::ptrdiff_t>(record_));
  }

  void swap_records() {
    const std::ptrdiff_t at = any_record();
    std::swap_ranges(bytes_.begin() + at,
                     bytes_.begin() + at + static_cast<std::ptrdiff_t>(record_),
                     bytes_.begin() + any_record());
  }

  std::size_t record_;
  std::minstd_rand random_;
  std::vector<std::uint8_t> bytes_;
};

}  // namespace plumb::fuzz
