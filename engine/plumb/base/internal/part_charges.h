// Memory that jobs hold for the caller that joins their parts (parallel.h).
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "plumb/base/context.h"

namespace plumb {

/// The bytes that the parts made by jobs are charged for. Each job raises the charge of its own
/// part, and the caller releases it once it has joined the part. Destruction releases all charges,
/// also if an error ends the jobs.
class PartCharges {
 public:
  /// Makes `parts` charges of 0 bytes. Requires that the context outlives the charges.
  PartCharges(Context& context, std::size_t parts) : context_(context), bytes_(parts, 0) {}
  ~PartCharges() {
    for (const std::uint64_t bytes : bytes_) context_.release_memory(bytes);
  }
  PartCharges(const PartCharges&) = delete;
  PartCharges& operator=(const PartCharges&) = delete;

  /// Raises the charge of a part to `bytes` unless it is greater already. `own` is the context of
  /// the job that makes the part. Throws as Context::charge_memory does.
  void raise(std::size_t part, std::uint64_t bytes, std::string_view what, Context& own) {
    if (bytes <= bytes_[part]) return;
    own.charge_memory(bytes - bytes_[part], what);
    bytes_[part] = bytes;
  }
  /// Releases the charge of a part. No job may be running.
  void release(std::size_t part) {
    context_.release_memory(bytes_[part]);
    bytes_[part] = 0;
  }

 private:
  Context& context_;
  std::vector<std::uint64_t> bytes_;  // One entry for each part, written by its job alone.
};

}  // namespace plumb
