// Points that crowd in tables of those who know the hash function: all have one value of
//
//   h = 0; h = (h ^ h >> 29 ^ bits) K for x, y, z; h ^ h >> 32   with K = 0x9e3779b97f4a7c15
//
// Each step is one to one, so that for any x and y some z gives the value that is wanted.
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>
#include <vector>

#include "plumb/predicates/point.h"

namespace plumb::testing {

inline std::vector<Point3> crowded_points(std::size_t count) {
  constexpr std::uint64_t kFactor = 0x9e3779b97f4a7c15U;
  std::vector<Point3> points;
  for (std::uint32_t i = 1; points.size() < count; ++i) {
    const double x = i % 1000, y = i / 1000;
    std::uint64_t h = 0;
    for (const double value : {x, y}) {
      h = (h ^ h >> 29U ^ std::bit_cast<std::uint64_t>(value)) * kFactor;
    }
    const double z = std::bit_cast<double>(h ^ h >> 29U ^ std::bit_cast<std::uint64_t>(1.5));
    if (std::isfinite(z)) points.push_back({x, y, z});
  }
  return points;
}

}  // namespace plumb::testing
