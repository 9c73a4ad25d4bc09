// Points of a plane as algorithms on them ask: by index, exact, whatever they are held as.
#pragma once

#include <cstdint>

#include "plumb/predicates/sign.h"

namespace plumb {

class PlanarPoints {
 public:
  virtual std::uint32_t size() const = 0;
  /// Positive: i, j, k turn left.
  virtual Sign orient(std::uint32_t i, std::uint32_t j, std::uint32_t k) const = 0;
  /// Lexicographic order, x first.
  virtual Sign compare(std::uint32_t i, std::uint32_t j) const = 0;
  /// For i, j, k counter-clockwise. Positive: l inside their circle.
  virtual Sign incircle(std::uint32_t i, std::uint32_t j, std::uint32_t k,
                        std::uint32_t l) const = 0;

 protected:
  ~PlanarPoints() = default;
};

}  // namespace plumb
