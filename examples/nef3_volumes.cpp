// Three cubes combined; the volumes of the result with their marks; its regularization, compared by
// ==.
#include <array>
#include <iostream>

#include "plumb/space/nef3.h"

namespace {

using plumb::Nef3;
using plumb::Point3;

const char* yes_or_no(bool answer) { return answer ? "yes" : "no"; }

/// The closed cube between two corners: min.x <= x <= max.x and so on.
Nef3 cube(const Point3& min, const Point3& max) {
  const std::array<plumb::HalfSpace3, 6> sides = {{{{-1, 0, 0, min.x}},
                                                   {{1, 0, 0, -max.x}},
                                                   {{0, -1, 0, min.y}},
                                                   {{0, 1, 0, -max.y}},
                                                   {{0, 0, -1, min.z}},
                                                   {{0, 0, 1, -max.z}}}};
  return Nef3::intersection(sides);
}

}  // namespace

int main() {
  const Nef3 first = cube({0, 0, 0}, {4, 4, 4});
  const Nef3 second = cube({2, 0, 0}, {6, 4, 4});
  const Nef3 third = cube({0, 2, 0}, {4, 6, 4});
  const Nef3 result = (first + second) * third;
  std::cout << "is empty: " << yes_or_no(result.is_empty()) << "\n"
            << "is bounded: " << yes_or_no(result.is_bounded()) << "\n"
            << "vertices: " << result.counts().vertices << "\n";

  // Volume 0 is what lies around a bounded set. The seams of the union are gone: one volume is
  // left.
  for (const plumb::Mark mark : result.complex().volume_mark) {
    std::cout << "volume mark: " << static_cast<int>(mark) << "\n";
  }
  std::cout << "volumes: " << result.counts().volumes << "\n"
            << "equals its regularization: " << yes_or_no(result.regularization() == result)
            << "\n";

  // A point beside the solid is no part of any volume: regularization drops it.
  const Nef3 with_point = result + Nef3::point({9, 9, 9});
  std::cout << "with a point beside it: " << yes_or_no(with_point.regularization() == with_point)
            << ", but regularized the same as before: "
            << yes_or_no(with_point.regularization() == result) << "\n";
}
