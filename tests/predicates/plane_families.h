// Adversarial sets of points of the plane: near-parallel lines, lines through one point and moved
// by one ulp, extreme exponents, subnormals, fractions mixed with doubles.
#pragma once

#include <cstdint>
#include <ostream>
#include <random>
#include <string>
#include <vector>

#include "plumb/predicates/rational_point.h"

namespace plumb {

using TestRandom = std::mt19937_64;

/// Eight points: lines 01, 23 (and 45, 67) are meant to cross.
using EightPoints = std::vector<RationalPoint2>;

struct PlaneFamily {
  std::string name;
  EightPoints (*make)(TestRandom&);
  friend std::ostream& operator<<(std::ostream& out, const PlaneFamily& f) { return out << f.name; }
};

const std::vector<PlaneFamily>& plane_families();

}  // namespace plumb
