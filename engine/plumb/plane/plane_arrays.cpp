#include "plumb/plane/plane_arrays.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "plumb/predicates/error.h"

namespace plumb {

PointTable2 points_of(std::span<const double> xy) {
  if (xy.size() % 2 != 0) {
    throw Error(ErrorCode::BadArgument, "the number of coordinates is odd");
  }
  if (xy.size() / 2 >= std::numeric_limits<std::uint32_t>::max()) {
    throw Error(ErrorCode::BadArgument, "more points than 2^32 - 2");
  }
  PointTable2 points;
  points.reserve(xy.size() / 2);
  for (std::size_t i = 0; i < xy.size(); i += 2) {
    if (!std::isfinite(xy[i]) || !std::isfinite(xy[i + 1])) {
      throw Error(ErrorCode::NotFinite,
                  "point " + std::to_string(i / 2) + " has a coordinate that is not finite");
    }
    points.push_back({xy[i], xy[i + 1]});
  }
  return points;
}

Map map_of_cycles(std::span<const double> xy, std::span<const std::uint32_t> cycle_begin,
                  std::span<const std::uint32_t> corners) {
  if (cycle_begin.empty() || cycle_begin.front() != 0 || cycle_begin.back() != corners.size() ||
      !std::is_sorted(cycle_begin.begin(), cycle_begin.end())) {
    throw Error(ErrorCode::BadArgument, "cycle_begin does not divide the corners into cycles");
  }
  return {
      points_of(xy), {corners.begin(), corners.end()}, {cycle_begin.begin(), cycle_begin.end()}};
}

std::vector<double> coordinates_of(const PointTable2& points) {
  std::vector<double> xy;
  xy.reserve(2 * points.size());
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    const Point2 p = points.approx(i);
    xy.insert(xy.end(), {p.x, p.y});
  }
  return xy;
}

}  // namespace plumb
