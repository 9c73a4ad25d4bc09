// What an overlay of large sphere maps may use. Internal to engine/sphere.
#pragma once

#include <cstdint>

#include "plumb/base/context.h"

namespace plumb {

/// Charges one overlay as it grows, up to its end.
class SphereLimits {
 public:
  explicit SphereLimits(Context& context) : context_(context), memory_(context) {}

  /// Call every few thousand steps, with what has been found so far.
  void look(std::uint64_t pairs, std::uint64_t crossings) {
    context_.checkpoint("overlay", 0, 0);
    const std::uint64_t bytes = kBytesPerPair * pairs + kBytesPerCrossing * crossings;
    if (bytes <= charged_) return;
    memory_.add(bytes - charged_, "an overlay of the sphere");
    charged_ = bytes;
  }

 private:
  static constexpr std::uint64_t kBytesPerPair = 16;        // eight, in arrays that double
  static constexpr std::uint64_t kBytesPerCrossing = 1200;  // a point and a piece more of two arcs

  Context& context_;
  MemoryCharge memory_;
  std::uint64_t charged_ = 0;
};

/// Between two steps; nothing where an overlay is so small that there are no limits.
inline void look(SphereLimits* limits) {
  if (limits != nullptr) limits->look(0, 0);
}

}  // namespace plumb
