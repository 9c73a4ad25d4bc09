// Two maps laid over each other against brute force: every cell, its regions, and areas.
//
// Input: a program of records of four bytes, {shape, p, q, r}: a triangle or a parallelogram of
// three points, a nibble for each coordinate; the lowest bit of the first byte says of which map. A
// map is the subdivision that its shapes induce, so that every input is two maps.
#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "oracle/overlay_check.h"
#include "plumb/testing/segment_maps.h"
#include "record_target.h"

namespace plumb::testing {
namespace {

constexpr std::size_t kRecord = 4;
constexpr std::size_t kMostShapes = 8;  // the twin is quadratic in lines

struct Place {
  std::int64_t x;
  std::int64_t y;
};

Place place_of(std::uint8_t byte) { return {byte & 15, byte >> 4}; }

void add_shape(std::span<const std::uint8_t> record, std::vector<IntegerSegment>& segments) {
  const Place p = place_of(record[1]), q = place_of(record[2]), r = place_of(record[3]);
  std::vector<Place> corners{p, q, r};
  if ((record[0] & 2) != 0) corners.push_back({p.x + r.x - q.x, p.y + r.y - q.y});
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Place &a = corners[i], &b = corners[(i + 1) % corners.size()];
    segments.push_back({a.x, a.y, b.x, b.y});
  }
}

std::string difference_of(std::span<const std::uint8_t> program) {
  std::array<std::vector<IntegerSegment>, 2> segments;
  for (std::size_t i = 0; i + kRecord <= program.size(); i += kRecord) {
    add_shape(program.subspan(i, kRecord), segments[program[i] & 1]);
  }
  const TestMap one = subdivision_of(segments[0]), two = subdivision_of(segments[1]);
  const std::string wrong = overlay_disagreement(one, two);
  return wrong.empty() ? wrong : wrong + '\n' + to_text(one) + "over\n" + to_text(two);
}

}  // namespace
}  // namespace plumb::testing

const plumb::fuzz::RecordTarget plumb::fuzz::kTarget{
    plumb::testing::kRecord, plumb::testing::kMostShapes, plumb::testing::difference_of};
