// Predicates alone (plumb::predicates): a sign that plain doubles get wrong, and a constructed
// point.
#include <cstdio>

#include "plumb/predicates/point_table2.h"

namespace {

// The usual determinant, rounded at every step.
double naive_orientation(plumb::Point2 a, plumb::Point2 b, plumb::Point2 c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

void nearly_on_a_line() {
  plumb::PointTable2 points;
  points.push_back({0.5 + 5 * 0x1p-53, 0.5});  // a hair to the right of the line through the others
  points.push_back({12, 12});
  points.push_back({24, 24});
  const double naive = naive_orientation(points.approx(0), points.approx(1), points.approx(2));
  const plumb::Sign exact = plumb::orient2d(points, 0, 1, 2);
  std::printf("naive determinant %g, exact sign %d\n", naive, static_cast<int>(exact));
}

void crossing_of_two_segments() {
  plumb::PointTable2 points;
  points.push_back({0, 0});
  points.push_back({3, 1});
  points.push_back({0, 1});
  points.push_back({1, 0});
  const plumb::Crossing2 crossing = plumb::make_crossing(points, 0, 1, 2, 3);
  const plumb::RationalPoint2 where = plumb::exact(points, crossing);
  const bool on_line = plumb::orient2d(points, 0, 1, crossing) == plumb::Sign::Zero;
  std::printf("they cross at %s %s, %s the first line\n", where.x.str().c_str(),
              where.y.str().c_str(), on_line ? "exactly on" : "beside");
}

}  // namespace

int main() {
  nearly_on_a_line();
  crossing_of_two_segments();
}
