// check_map against its brute-force twin: verdict, counts, every defect, regions.
//
// Input: records of four bytes. The first chooses a map to begin with, {family, size, seed, options};
// each other one is an edit {what, a, b, c}. The mutator works on records, so every input is a map.
#include <cstdio>
#include <cstdlib>

#include "generate/garbage_maps.h"
#include "generate/map_defects.h"
#include "generate/map_families.h"
#include "oracle_reached.h"
#include "plane/checked.h"
#include "record_mutator.h"

namespace plumb::testing {
namespace {

constexpr std::size_t kRecord = 4;
constexpr std::size_t kMaxCorners = 48;  // the twin is quadratic

struct Record {
  std::uint8_t what, a, b, c;
};

Record record_at(const std::uint8_t* data, std::size_t i) {
  const std::uint8_t* at = data + i * kRecord;
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

// Edits stop at the first that makes the map one check_map must refuse.
TestMap decode(const std::uint8_t* data, std::size_t records) {
  TestMap map = first_map(record_at(data, 0));
  for (std::size_t i = 1; i < records; ++i) {
    if (map.corner_count() > kMaxCorners || !refusal(map, {}).empty()) break;
    apply(map, record_at(data, i));
  }
  return map;
}

OracleOptions options_of(const Record& r) { return {kOuterRules[r.c % 3], r.c / 3 % 4 == 0}; }

void run(const std::uint8_t* data, std::size_t size) {
  const std::size_t records = size / kRecord;
  if (records == 0) return;
  const TestMap map = decode(data, records);
  if (map.corner_count() > 2 * kMaxCorners) return;
  const OracleOptions options = options_of(record_at(data, 0));
  if (refusal(map, options).empty()) fuzz::oracle_reached();
  const std::string wrong = disagreement(map, options);
  if (wrong.empty()) return;
  std::fprintf(stderr, "check_map and its twin disagree: %s\n", wrong.c_str());
  std::abort();
}

}  // namespace
}  // namespace plumb::testing

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  plumb::fuzz::begin_input();
  plumb::testing::run(data, size);
  return 0;
}

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size,
                                               std::size_t max_size, unsigned seed) {
  return plumb::fuzz::RecordMutator(plumb::testing::kRecord, seed).mutate(data, size, max_size);
}

extern "C" std::size_t LLVMFuzzerCustomCrossOver(const std::uint8_t* first, std::size_t first_size,
                                                 const std::uint8_t* second,
                                                 std::size_t second_size, std::uint8_t* out,
                                                 std::size_t max_size, unsigned seed) {
  return plumb::fuzz::RecordMutator(plumb::testing::kRecord, seed)
      .cross({first, first_size}, {second, second_size}, out, max_size);
}
