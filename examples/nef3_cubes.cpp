// Sets of space: two cubes, each of six half-spaces; is a point in them, what they make together,
// as a mesh.
#include <array>
#include <iostream>

#include "plumb/plumb.h"

namespace {

using plumb::Boundary;
using plumb::Nef3;
using plumb::Point3;

const char* yes_or_no(bool answer) { return answer ? "yes" : "no"; }

/// The closed cube between two corners. A half-space is what lies below its plane: a x + b y + c z
/// + d <= 0.
Nef3 cube(const Point3& min, const Point3& max) {
  const std::array<plumb::HalfSpace3, 6> sides = {{
      {{-1, 0, 0, min.x}},  // x >= min.x
      {{1, 0, 0, -max.x}},  // x <= max.x
      {{0, -1, 0, min.y}},  // y >= min.y
      {{0, 1, 0, -max.y}},  // y <= max.y
      {{0, 0, -1, min.z}},  // z >= min.z
      {{0, 0, 1, -max.z}},  // z <= max.z
  }};
  return Nef3::intersection(sides);
}

}  // namespace

int main() {
  const Nef3 first = cube({0, 0, 0}, {5, 5, 5});
  const Nef3 second = cube({3, 3, 3}, {8, 8, 8});
  std::cout << "first cube contains (2,2,2): " << yes_or_no(first.contains(Point3{2, 2, 2})) << "\n"
            << "first cube contains (6,6,6): " << yes_or_no(first.contains(Point3{6, 6, 6}))
            << "\n";

  const Nef3 both = first * second;
  const Nef3 either = first + second;
  const Nef3 rest = first - second;
  std::cout << "intersection is empty: " << yes_or_no(both.is_empty()) << "\n"
            << "union is bounded: " << yes_or_no(either.is_bounded()) << "\n"
            << "difference is empty: " << yes_or_no(rest.is_empty())
            << "\n"
            // The second cube is closed, so the difference is open where it was cut.
            << "difference contains (3,3,3): " << yes_or_no(rest.contains(Point3{3, 3, 3})) << "\n"
            << "difference and second cube make the union: " << yes_or_no(rest + second == either)
            << "\n";

  const plumb::MeshOfComplex made = both.to_polygons({.faces = plumb::MeshFaces::Polygons});
  std::cout << "intersection as a mesh: " << made.mesh.points.size() << " vertices, "
            << made.mesh.face_count() << " faces\n";
}
