// A fuzz target whose inputs are programs of records, mutated as such: the target says what kTarget
// is, record_target.cpp does the rest.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

namespace plumb::fuzz {

struct RecordTarget {
  std::size_t record;       ///< bytes of a record
  std::size_t max_records;  ///< longer inputs are passed over, and those of fewer than two
  /// What differs between engine and twin, or "".
  std::string (*difference)(std::span<const std::uint8_t> program);
};

extern const RecordTarget kTarget;

}  // namespace plumb::fuzz
