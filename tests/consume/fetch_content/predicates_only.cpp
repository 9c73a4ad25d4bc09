// What a project that needs signs and nothing else does.
#include <cstdio>

#include "plumb/predicates/point_table2.h"

int main() {
  plumb::PointTable2 points;
  points.push_back({0, 0});
  points.push_back({1, 1});
  points.push_back({0x1p-60, 0x1p-61});
  const bool right = plumb::orient2d(points, 0, 1, 2) == plumb::Sign::Negative;
  std::printf("right of the line: %d\n", right);
  return right ? 0 : 1;
}
