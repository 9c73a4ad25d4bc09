// What an embedding project does: a predicate, the engine, and an error across the library border.
#include <array>
#include <cstdint>
#include <cstdio>

#include "plumb/base/context.h"
#include "plumb/plane/map_check.h"
#include "plumb/predicates/error.h"
#include "plumb/predicates/point_table2.h"

namespace {

plumb::Map triangle(bool with_outer) {
  plumb::Map map;
  map.points.push_back({0, 0});
  map.points.push_back({1, 0});
  map.points.push_back({0, 1});
  map.add_cycle(std::array<std::uint32_t, 3>{0, 1, 2});
  if (with_outer) map.add_cycle(std::array<std::uint32_t, 3>{2, 1, 0});
  return map;
}

plumb::MapVerdict verdict(plumb::Map map) {
  plumb::Context context;
  return plumb::check_map(std::move(map), {}, context).verdict;
}

bool error_is_caught() {
  try {
    plumb::Map map = triangle(true);
    map.add_cycle(std::array<std::uint32_t, 3>{0, 1, 7});
    verdict(std::move(map));
  } catch (const plumb::Error& error) {
    return error.code() == plumb::ErrorCode::BadIndex;
  }
  return false;
}

}  // namespace

int main() {
  const plumb::Map map = triangle(true);
  const bool left = plumb::orient2d(map.points, 0, 1, 2) == plumb::Sign::Positive;
  const bool valid = verdict(map) == plumb::MapVerdict::Valid;
  const bool open = verdict(triangle(false)) == plumb::MapVerdict::Open;
  const bool caught = error_is_caught();
  std::printf("left %d, valid %d, open %d, error caught %d\n", left, valid, open, caught);
  return left && valid && open && caught ? 0 : 1;
}
