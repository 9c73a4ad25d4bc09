#include "plumb/testing/garbage_maps.h"

#include <algorithm>

#include "plumb/testing/dice.h"

namespace plumb::testing {
namespace {

bool is_well_formed(const Cycle& cycle) {
  if (cycle.size() < 3) return false;
  for (std::size_t i = 0; i < cycle.size(); ++i) {
    if (cycle[i] == cycle[(i + 1) % cycle.size()]) return false;
  }
  return true;
}

Cycle garbage_cycle(std::uint32_t points, Dice& dice) {
  Cycle cycle;
  const std::int64_t corners = dice.between(3, 6);
  while (!is_well_formed(cycle)) {
    cycle.clear();
    for (std::int64_t i = 0; i < corners; ++i) cycle.push_back(dice.below(points));
  }
  return cycle;
}

struct Visit {
  std::size_t cycle;
  std::size_t corner;
};

std::vector<Visit> visits_of(const TestMap& map, std::uint32_t vertex) {
  std::vector<Visit> visits;
  for (std::size_t c = 0; c < map.cycles.size(); ++c) {
    for (std::size_t i = 0; i < map.cycles[c].size(); ++i) {
      if (map.cycles[c][i] == vertex) visits.push_back({c, i});
    }
  }
  return visits;
}

Cycle starting_at(const Cycle& cycle, std::size_t corner) {
  Cycle result = cycle;
  std::rotate(result.begin(), result.begin() + static_cast<std::ptrdiff_t>(corner), result.end());
  return result;
}

void join_cycles(TestMap& map, Visit p, Visit q) {
  Cycle joined = starting_at(map.cycles[p.cycle], p.corner);
  const Cycle tail = starting_at(map.cycles[q.cycle], q.corner);
  joined.insert(joined.end(), tail.begin(), tail.end());
  if (!is_well_formed(joined)) return;
  map.cycles[p.cycle] = std::move(joined);
  map.cycles.erase(map.cycles.begin() + static_cast<std::ptrdiff_t>(q.cycle));
}

void split_cycle(TestMap& map, Visit p, Visit q) {
  const Cycle whole = starting_at(map.cycles[p.cycle], p.corner);
  const std::size_t size = whole.size();
  const auto cut = static_cast<std::ptrdiff_t>((q.corner + size - p.corner) % size);
  Cycle first(whole.begin(), whole.begin() + cut);
  Cycle second(whole.begin() + cut, whole.end());
  if (!is_well_formed(first) || !is_well_formed(second)) return;
  map.cycles[p.cycle] = std::move(first);
  map.cycles.push_back(std::move(second));
}

}  // namespace

TestMap garbage_map(std::uint32_t points, std::uint32_t cycles, std::int64_t range,
                    std::uint64_t seed) {
  Dice dice(seed);
  TestMap map;
  for (std::uint32_t i = 0; i < points; ++i) {
    const std::int64_t x = dice.between(0, range);
    map.add_point(x, dice.between(0, range));
  }
  for (std::uint32_t i = 0; i < cycles; ++i) map.cycles.push_back(garbage_cycle(points, dice));
  return map;
}

TestMap recombined(const TestMap& map, std::uint32_t swaps, std::uint64_t seed) {
  Dice dice(seed);
  TestMap result = map;
  for (std::uint32_t i = 0; i < swaps && !result.cycles.empty(); ++i) {
    const Cycle& some = result.cycles[dice.below(result.cycles.size())];
    const std::vector<Visit> visits = visits_of(result, some[dice.below(some.size())]);
    const Visit p = visits[dice.below(visits.size())];
    const Visit q = visits[dice.below(visits.size())];
    if (p.cycle != q.cycle) {
      join_cycles(result, p, q);
    } else if (p.corner != q.corner) {
      split_cycle(result, p, q);
    }
  }
  return result;
}

TestMap shuffled_cycles(const TestMap& map, std::uint32_t changes, std::uint64_t seed) {
  Dice dice(seed);
  TestMap result = map;
  for (std::uint32_t i = 0; i < changes && result.cycles.size() > 1; ++i) {
    const std::uint32_t c = dice.below(result.cycles.size());
    const std::int64_t change = dice.between(0, 5);
    if (change == 0) result.cycles.push_back(Cycle(result.cycles[c]));
    if (change == 1) std::reverse(result.cycles[c].begin(), result.cycles[c].end());
    if (change >= 2) result.cycles.erase(result.cycles.begin() + c);
  }
  return result;
}

TestMap moved_vertices(const TestMap& map, std::uint32_t moves, std::int64_t range,
                       std::uint64_t seed) {
  Dice dice(seed);
  TestMap result = map;
  for (std::uint32_t i = 0; i < moves && !result.points.empty(); ++i) {
    result.points[dice.below(result.points.size())] = {dice.between(0, range),
                                                       dice.between(0, range)};
  }
  return result;
}

}  // namespace plumb::testing
