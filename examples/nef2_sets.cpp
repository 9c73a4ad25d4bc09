// Sets of the plane: a quadrant from two half-planes; a triangle and a rectangle combined.
#include <iostream>
#include <vector>

#include "plumb/plane/nef2.h"

namespace {

using plumb::Boundary;
using plumb::Line2;
using plumb::Nef2;
using plumb::Point2;

const char* yes_or_no(bool answer) { return answer ? "yes" : "no"; }

/// { x >= 0, y >= 0 }: a half-plane is a line and a point on the side to keep.
Nef2 first_quadrant() {
  const Line2 x_axis{{0, 0}, {1, 0}}, y_axis{{0, 0}, {0, 1}};
  const Nef2 upper = Nef2::half_plane(x_axis, {0, 1}, Boundary::Closed);
  const Nef2 right = Nef2::half_plane(y_axis, {1, 0}, Boundary::Closed);
  return upper * right;
}

}  // namespace

int main() {
  const Nef2 quadrant = first_quadrant();
  std::cout << "first quadrant is empty: " << yes_or_no(quadrant.is_empty()) << "\n"
            << "contains (1,1): " << yes_or_no(quadrant.contains(Point2{1, 1})) << "\n"
            << "contains (-1,1): " << yes_or_no(quadrant.contains(Point2{-1, 1})) << "\n"
            << "contains its corner: " << yes_or_no(quadrant.contains(Point2{0, 0})) << "\n"
            << "its interior does: " << yes_or_no(quadrant.interior().contains(Point2{0, 0}))
            << "\n";

  const Nef2 triangle = Nef2::polygon(std::vector<Point2>{{0, 0}, {5, 0}, {0, 5}});
  const Nef2 rectangle = Nef2::polygon(std::vector<Point2>{{2, 2}, {7, 2}, {7, 7}, {2, 7}});
  const Nef2 both = triangle * rectangle;
  const Nef2 either = triangle + rectangle;
  const Nef2 rest = triangle - rectangle;
  for (const auto& [name, set] :
       {std::pair{"intersection", both}, {"union", either}, {"difference", rest}}) {
    std::cout << name << " is empty: " << yes_or_no(set.is_empty()) << ", area "
              << set.area().value() << "\n";
  }
  // The difference is open where the rectangle was closed: together they are the union again.
  std::cout << "the difference has (2,2): " << yes_or_no(rest.contains(Point2{2, 2})) << "\n"
            << "difference and rectangle make the union: " << yes_or_no(rest + rectangle == either)
            << "\n";
}
