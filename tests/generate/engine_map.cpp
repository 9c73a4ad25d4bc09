// Test maps into the engine and back.
#include "plumb/testing/test_map.h"

namespace plumb::testing {

Map to_map(const TestMap& map) {
  Map result;
  result.points.reserve(map.points.size());
  for (const ExactPoint& p : map.points) {
    Point2 rounded;
    if (as_double(p.x, rounded.x) && as_double(p.y, rounded.y)) {
      result.points.push_back(rounded);
    } else {
      result.points.push_back(to_rational(p.x), to_rational(p.y));
    }
  }
  for (const Cycle& cycle : map.cycles) result.add_cycle(cycle);
  return result;
}

TestMap from_map(const Map& map) {
  TestMap result;
  for (std::uint32_t i = 0; i < map.points.size(); ++i) {
    result.points.push_back(map.points.is_double(i) ? exact_of(map.points.approx(i))
                                                    : exact_of(map.points.exact(i)));
  }
  for (std::size_t c = 0; c < map.cycle_count(); ++c) {
    result.cycles.emplace_back(map.cycle(c).begin(), map.cycle(c).end());
  }
  return result;
}

}  // namespace plumb::testing
