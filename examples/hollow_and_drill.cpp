// A block made hollow with walls of 1/4, then drilled through: is it still one piece, is the inside
// still closed?
#include <iostream>
#include <vector>

#include "plumb/convex/minkowski.h"
#include "plumb/space/nef3.h"
#include "plumb/space/space_measure.h"

namespace {

using plumb::Nef3;
using plumb::Rational;

/// The closed box between two corners, made of six half-spaces.
Nef3 box(const plumb::RationalPoint3& low, const plumb::RationalPoint3& high) {
  const std::vector<plumb::HalfSpace3> sides = {
      {{-1, 0, 0, low.x}},  {{0, -1, 0, low.y}},  {{0, 0, -1, low.z}},
      {{1, 0, 0, -high.x}}, {{0, 1, 0, -high.y}}, {{0, 0, 1, -high.z}},
  };
  return Nef3::intersection(sides);
}

void describe(const char* what, const Nef3& set) {
  const plumb::SpaceCounts counts = set.counts();
  std::cout << what << ": volume " << marked_volume(set.complex()).value() << ", "
            << counts.marked_volumes << " of " << counts.volumes << " volumes in it, "
            << (set.is_simple() ? "a manifold" : "no manifold") << '\n';
}

}  // namespace

int main() {
  const Rational wall(1, 4);
  const Nef3 block = box({0, 0, 0}, {4, 3, 2});

  // The erosion by a small box is what is further than a wall from every side. Its interior is
  // taken away: the walls keep both of their sides, and are exactly 1/4 thick.
  const Nef3 corner = box({-wall, -wall, -wall}, {wall, wall, wall});
  const Nef3 hollow = block - minkowski_erosion(block, corner).interior();
  describe("hollow", hollow);

  // A square drill as long as space is wide: no overshoot has to be chosen.
  const std::vector<plumb::HalfSpace3> drill = {
      {{-1, 0, 0, Rational(7, 4)}, plumb::Boundary::Open},
      {{1, 0, 0, Rational(-9, 4)}, plumb::Boundary::Open},
      {{0, -1, 0, Rational(5, 4)}, plumb::Boundary::Open},
      {{0, 1, 0, Rational(-7, 4)}, plumb::Boundary::Open},
  };
  const Nef3 drilled = hollow - Nef3::intersection(drill);
  describe("drilled", drilled);

  const bool is_closed = hollow.is_closed() && drilled.is_closed();
  std::cout << "all walls have their sides: " << (is_closed ? "yes" : "no") << '\n';
  return is_closed ? 0 : 1;
}
