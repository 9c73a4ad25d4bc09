// Marked arrangements on so small a grid that degenerate positions are the rule.
#pragma once

#include <cstdint>
#include <vector>

#include "plumb/plane/arrangement.h"
#include "plumb/testing/dice.h"

namespace plumb::testing {

/// The arrangement of a few segments, rays and lines, many of them vertical, concurrent or on one
/// line, and of two points. Each mark is 1 in one of `odds` cases.
inline PlaneComplex random_complex(Dice& dice, std::size_t odds = 2) {
  constexpr std::uint32_t kNoEnd = SweepCurve::kUnbounded;
  PlanePoints points;
  const std::uint32_t n = 5 + dice.below(5);
  for (std::uint32_t i = 0; i < n; ++i) {
    points.inputs.push_back(
        Point2{static_cast<double>(dice.between(0, 3)), static_cast<double>(dice.between(0, 3))});
  }
  std::vector<SweepCurve> curves;
  for (std::uint32_t i = dice.below(9); i > 0; --i) {
    const std::uint32_t a = dice.below(n), b = dice.below(n);
    if (points.inputs.approx(a) == points.inputs.approx(b)) continue;
    const std::uint32_t kind = dice.below(8);
    curves.push_back(
        {kind == 0 || kind == 1 ? kNoEnd : a, kind == 0 || kind == 2 ? kNoEnd : b, a, b});
  }
  const std::vector<std::uint32_t> isolated{dice.below(n), dice.below(n)};
  PlaneComplex complex = arrange(points, curves, isolated).complex;
  for (std::vector<std::uint8_t>* marks : std::initializer_list<std::vector<std::uint8_t>*>{
           &complex.marks.vertex, &complex.marks.edge, &complex.marks.face}) {
    for (std::uint8_t& mark : *marks) mark = dice.below(odds) == 0 ? 1 : 0;
  }
  return complex;
}

}  // namespace plumb::testing
