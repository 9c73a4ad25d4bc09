#include "plumb/sphere/sphere_boxes.h"

#include <algorithm>
#include <cmath>

#include "plumb/sphere/sphere_arcs.h"

namespace plumb {
namespace {

using Vector = std::array<double, 3>;

constexpr double kRounding = 1e-14;  // more than the roundings of anything below

// The unit vector sought lies within `radius` of `middle`.
struct Ball {
  Vector middle;
  double radius;
};

Vector cross(const Vector& u, const Vector& v) {
  return {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
}

/// |v - exact| <= error. The middle v / |v| is then off by at most 2 error / |v|.
Ball unit_ball(const Vector& v, double error) {
  const double length = std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
  if (!(length > 8 * error)) return {{0, 0, 0}, 1};  // anywhere
  return {{v[0] / length, v[1] / length, v[2] / length}, 2 * error / length + kRounding};
}

Ball ball_of(const PlaneTable& planes, PlaneId circle) {
  const PlaneRow& row = planes.row(circle);
  return unit_ball(row.n, static_cast<double>(row.normal_error));
}

/// A component of the cross product is off by at most the sum of the errors (plane_signs.cpp).
Ball ball_of(const PlaneTable& planes, SphereDirection u) {
  const PlaneRow& p = planes.row(u.p);
  const PlaneRow& q = planes.row(u.q);
  const double errors = static_cast<double>(p.normal_error) + static_cast<double>(q.normal_error);
  return unit_ball(cross(p.n, q.n), 4 * errors);
}

Box3 box_of(const Ball& ball) {
  Box3 box;
  for (std::size_t i = 0; i < 3; ++i) {
    box.low[i] = ball.middle[i] - ball.radius;
    box.high[i] = ball.middle[i] + ball.radius;
  }
  return box;
}

/// How far the circle of a normal goes along an axis, at most.
double reach(const Ball& normal, std::size_t axis) {
  const double n = std::max(0.0, std::fabs(normal.middle[axis]) - normal.radius);
  return std::sqrt(std::max(0.0, 1 - n * n)) + kRounding;
}

Box3 box_of_circle(const Ball& normal) {
  Box3 box;
  for (std::size_t i = 0; i < 3; ++i) {
    box.high[i] = reach(normal, i);
    box.low[i] = -box.high[i];
  }
  return box;
}

/// Requires less than a half-circle, counter-clockwise from p to q.
Box3 box_of_short_arc(const Ball& normal, const Ball& p, const Ball& q) {
  Box3 box = box_of(p);
  box.add(box_of(q));
  const Vector at_p = cross(normal.middle, p.middle);
  const Vector at_q = cross(normal.middle, q.middle);
  const double slack = 2 * (normal.radius + p.radius + q.radius) + kRounding;
  for (std::size_t i = 0; i < 3; ++i) {
    if (at_p[i] > -slack && at_q[i] < slack) box.high[i] = std::max(box.high[i], reach(normal, i));
    if (at_p[i] < slack && at_q[i] > -slack) box.low[i] = std::min(box.low[i], -reach(normal, i));
  }
  return box;
}

bool is_short(const PlaneTable& planes, const SphereMap& map, std::uint32_t arc) {
  return !map.is_loop(arc) && turn_on(planes, map.circle[arc], origin_place(planes, map, 2 * arc),
                                      origin_place(planes, map, 2 * arc + 1)) == TurnClass::Left;
}

}  // namespace

void boxes_of(const PlaneTable& planes, const SphereMap& map, std::vector<Box3>& boxes) {
  boxes.clear();
  for (const SphereDirection u : map.direction) boxes.push_back(box_of(ball_of(planes, u)));
  for (std::uint32_t a = 0; a < map.arc_count(); ++a) {
    const Ball normal = ball_of(planes, map.circle[a]);
    boxes.push_back(is_short(planes, map, a)
                        ? box_of_short_arc(normal,
                                           ball_of(planes, map.direction[map.origin[2 * a]]),
                                           ball_of(planes, map.direction[map.target(2 * a)]))
                        : box_of_circle(normal));
  }
}

}  // namespace plumb
