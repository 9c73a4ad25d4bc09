#include "plumb/testing/map_program.h"

#include "plumb/testing/garbage_maps.h"
#include "plumb/testing/map_defects.h"
#include "plumb/testing/map_families.h"
#include "plumb/testing/map_oracle.h"

namespace plumb::testing {
namespace {

struct Record {
  std::uint8_t what, a, b, c;
};

Record record_at(std::span<const std::uint8_t> program, std::size_t i) {
  const auto at = program.subspan(i * kMapRecord, kMapRecord);
  return {at[0], at[1], at[2], at[3]};
}

TestMap first_map(const Record& r) {
  const std::uint32_t size = r.a;
  switch (r.what % 10) {
    case 0:
      return grid(1 + size % 3);
    case 1:
      return jittered_triangles(1 + size % 2, r.b);
    case 2:
      return comb(1 + size % 5);
    case 3:
      return fan(1 + size % 8);
    case 4:
      return nest(1 + size % 5);
    case 5:
      return hexagons(1 + size % 2, r.b);
    case 6:
      return garbage_map(3 + size % 8, 1 + size / 8 % 5, 1 + r.b % 8, r.b);
    case 7:
      return line_arrangement(1 + size % 3, r.b);
    case 8:
      return {};
    default:
      return random_subdivision(1 + size % 6, 3 + size / 6 % 20, r.b);
  }
}

void add_triangle(TestMap& map, const Record& r) {
  const std::size_t n = map.points.size();
  if (n >= 3) {
    map.cycles.push_back({static_cast<std::uint32_t>(r.a % n), static_cast<std::uint32_t>(r.b % n),
                          static_cast<std::uint32_t>(r.c % n)});
  }
}

void insert_corner(TestMap& map, const Record& r) {
  if (map.cycles.empty()) return;
  Cycle& cycle = map.cycles[r.a % map.cycles.size()];
  cycle.insert(cycle.begin() + r.c % static_cast<std::ptrdiff_t>(cycle.size()),
               static_cast<std::uint32_t>(r.b % map.points.size()));
}

void remove_corner(TestMap& map, const Record& r) {
  if (map.cycles.empty()) return;
  Cycle& cycle = map.cycles[r.a % map.cycles.size()];
  cycle.erase(cycle.begin() + r.c % static_cast<std::ptrdiff_t>(cycle.size()));
}

void apply_defect(TestMap& map, const Record& r) {
  const auto& makers = map_defect_makers();
  if (!map.cycles.empty()) map = makers[r.c % makers.size()].make(map, {r.a, r.b}).map;
}

BigRational factor(const Record& r) {
  const BigRational fraction(1 + r.b % 7, 1 + r.c % 7);
  return r.b % 2 == 0 ? fraction : power_of_two(4 * (static_cast<int>(r.a) - 128));
}

void apply(TestMap& map, const Record& r) {
  const std::uint64_t seed = r.b + 256U * r.c;
  switch (r.what % 10) {
    case 0:
      return add_triangle(map, r);
    case 1:
      return insert_corner(map, r);
    case 2:
      return remove_corner(map, r);
    case 3:
      return apply_defect(map, r);
    case 4:
      map = recombined(map, r.a % 8, seed);
      return;
    case 5:
      map = shuffled_cycles(map, r.a % 4, seed);
      return;
    case 6:
      map = moved_vertices(map, r.a % 4, 16, seed);
      return;
    case 7:
      map.add_point(r.a % 16, r.b % 16);
      return;
    case 8:
      if (!map.points.empty()) map.points[r.a % map.points.size()] = {r.b % 16, r.c % 16};
      return;
    default:
      map = scaled(map, factor(r));
      return;
  }
}

}  // namespace

TestMap map_of_program(std::span<const std::uint8_t> program, std::size_t max_corners) {
  const std::size_t records = program.size() / kMapRecord;
  if (records == 0) return {};
  TestMap map = first_map(record_at(program, 0));
  for (std::size_t i = 1; i < records; ++i) {
    if (map.corner_count() > max_corners || !refusal(map, {}).empty()) break;
    apply(map, record_at(program, i));
  }
  return map;
}

}  // namespace plumb::testing
