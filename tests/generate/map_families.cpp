#include "plumb/testing/map_families.h"

#include <algorithm>
#include <cmath>

#include "plumb/testing/dice.h"
#include "plumb/testing/segment_maps.h"

namespace plumb::testing {
namespace {

std::uint32_t root(std::uint32_t faces) {
  return static_cast<std::uint32_t>(std::lround(std::sqrt(static_cast<double>(faces))));
}

void add_lattice(TestMap& map, std::uint32_t side, std::int64_t spacing, std::int64_t jitter,
                 Dice& dice) {
  for (std::uint32_t row = 0; row <= side; ++row) {
    for (std::uint32_t column = 0; column <= side; ++column) {
      map.add_point(column * spacing + dice.between(-jitter, jitter),
                    row * spacing + dice.between(-jitter, jitter));
    }
  }
}

}  // namespace

std::size_t face_count(const TestMap& map) {
  std::size_t faces = 0;
  for (const Cycle& cycle : map.cycles) faces += doubled_area(map, cycle) > 0 ? 1U : 0U;
  return faces;
}

TestMap grid(std::uint32_t side) {
  TestMap map;
  Dice dice(0);
  add_lattice(map, side, 2, 0, dice);
  const std::uint32_t width = side + 1;
  for (std::uint32_t row = 0; row < side; ++row) {
    for (std::uint32_t column = 0; column < side; ++column) {
      const std::uint32_t v = row * width + column;
      map.cycles.push_back({v, v + 1, v + 1 + width, v + width});
    }
  }
  append_missing_cycles(map);
  return map;
}

// Two points of a triangle differ by at least (1 - 2r) along one axis and at most 2r across it
// (r = jitter / spacing): doubled area >= (1 - 2r)^2 - (2r)^2 = 1 - 4r > 0 for r < 1/4.
TestMap jittered_triangles(std::uint32_t side, std::uint64_t seed) {
  TestMap map;
  Dice dice(seed);
  add_lattice(map, side, 1000, 200, dice);
  const std::uint32_t width = side + 1;
  for (std::uint32_t row = 0; row < side; ++row) {
    for (std::uint32_t column = 0; column < side; ++column) {
      const std::uint32_t v = row * width + column;
      map.cycles.push_back({v, v + 1, v + 1 + width});
      map.cycles.push_back({v, v + 1 + width, v + width});
    }
  }
  append_missing_cycles(map);
  return map;
}

TestMap comb(std::uint32_t teeth, std::int64_t height) {
  TestMap map;
  for (std::uint32_t i = 0; i <= teeth; ++i) {  // vertices 2i below, 2i + 1 above
    map.add_point(2 * std::int64_t{i}, 0);
    map.add_point(2 * std::int64_t{i} + 1, height);
  }
  for (std::uint32_t i = 0; i < teeth; ++i) {
    map.cycles.push_back({2 * i, 2 * i + 2, 2 * i + 1});
    map.cycles.push_back({2 * i + 1, 2 * i + 2, 2 * i + 3});
  }
  append_missing_cycles(map);
  return map;
}

TestMap zigzag(std::uint32_t teeth, std::int64_t height) {
  TestMap map;
  Cycle along;
  for (std::uint32_t i = 0; i <= teeth; ++i) along.push_back(map.add_point(i, i % 2 * height));
  const std::uint32_t low_left = map.add_point(0, -1);
  const std::uint32_t low_right = map.add_point(teeth, -1);
  const std::uint32_t high_right = map.add_point(teeth, height + 1);
  const std::uint32_t high_left = map.add_point(0, height + 1);
  Cycle lower{low_left, low_right};
  lower.insert(lower.end(), along.rbegin(), along.rend());
  along.insert(along.end(), {high_right, high_left});
  map.cycles = {std::move(lower), std::move(along)};
  append_missing_cycles(map);
  return map;
}

// The apex lies above every chord of the parabola: on the left of each edge i -> i + 1.
TestMap fan(std::uint32_t size) {
  TestMap map;
  for (std::int64_t i = 0; i <= size; ++i) map.add_point(i, i * i);
  const std::int64_t n = size;
  const std::uint32_t apex = map.add_point(n / 2, n * n + 1);
  for (std::uint32_t i = 0; i < size; ++i) map.cycles.push_back({i, i + 1, apex});
  append_missing_cycles(map);
  return map;
}

TestMap nest(std::uint32_t depth) {
  TestMap map;
  for (std::int64_t r = depth; r > 0; --r) {
    const std::uint32_t v = map.add_point(-r, -r);
    map.add_point(r, -r);
    map.add_point(r, r);
    map.add_point(-r, r);
    map.cycles.push_back({v, v + 1, v + 2, v + 3});
    map.cycles.push_back({v + 3, v + 2, v + 1, v});
  }
  return map;
}

namespace {

// Brick-wall numbering of a hexagonal lattice: vertex (i, j) is a low corner of row j's hexagons
// or a high corner of row j - 1's; corners whose i and j agree in parity sit higher.
std::uint32_t hexagon_corner(std::uint32_t i, std::uint32_t j, std::uint32_t width) {
  return j * width + i;
}

Cycle hexagon(std::uint32_t row, std::uint32_t column, std::uint32_t width) {
  const std::uint32_t i = 2 * column + row % 2;
  return {hexagon_corner(i, row, width),         hexagon_corner(i + 1, row, width),
          hexagon_corner(i + 2, row, width),     hexagon_corner(i + 2, row + 1, width),
          hexagon_corner(i + 1, row + 1, width), hexagon_corner(i, row + 1, width)};
}

}  // namespace

TestMap hexagons(std::uint32_t side, std::uint64_t seed) {
  TestMap map;
  Dice dice(seed);
  const std::uint32_t width = 2 * side + 2;
  for (std::uint32_t j = 0; j <= side; ++j) {
    for (std::uint32_t i = 0; i < width; ++i) {
      const std::int64_t lift = (i + j) % 2 == 0 ? 300 : 0;
      map.add_point(500 * std::int64_t{i} + dice.between(-60, 60),
                    900 * std::int64_t{j} + lift + dice.between(-60, 60));
    }
  }
  for (std::uint32_t row = 0; row < side; ++row) {
    for (std::uint32_t column = 0; column < side; ++column) {
      map.cycles.push_back(hexagon(row, column, width));
    }
  }
  append_missing_cycles(map);
  return map;
}

// x = i rises along the lower chain and falls along the upper one, which stays above it.
TestMap star(std::uint32_t corners, std::uint64_t seed) {
  TestMap map;
  Dice dice(seed);
  const std::int64_t half = corners / 2;
  Cycle outline;
  for (std::int64_t i = 0; i < half; ++i) {
    outline.push_back(map.add_point(i, dice.between(-1000000, -1)));
  }
  for (std::int64_t i = corners - half; i > 0; --i) {
    outline.push_back(map.add_point(i - 1, dice.between(1, 1000000)));
  }
  map.cycles.push_back(std::move(outline));
  append_missing_cycles(map);
  return map;
}

TestMap line_arrangement(std::uint32_t lines, std::uint64_t seed) {
  constexpr std::int64_t kSide = kSegmentRange;
  std::vector<IntegerSegment> segments{
      {0, 0, kSide, 0}, {kSide, 0, kSide, kSide}, {0, kSide, kSide, kSide}, {0, 0, 0, kSide}};
  Dice dice(seed);
  for (std::uint32_t i = 0; i < lines; ++i) {
    const std::int64_t a = dice.between(1, kSide - 1);
    const std::int64_t b = dice.between(1, kSide - 1);
    segments.push_back(i % 2 == 0 ? IntegerSegment{0, a, kSide, b}
                                  : IntegerSegment{a, 0, b, kSide});
  }
  return subdivision_of(segments);
}

namespace {

void add_rectangle(std::vector<IntegerSegment>& segments, std::int64_t range, Dice& dice) {
  const std::int64_t x1 = dice.between(0, range), y1 = dice.between(0, range);
  const std::int64_t x2 = dice.between(x1, range), y2 = dice.between(y1, range);
  segments.insert(segments.end(),
                  {{x1, y1, x2, y1}, {x2, y1, x2, y2}, {x1, y2, x2, y2}, {x1, y1, x1, y2}});
}

void add_triangle(std::vector<IntegerSegment>& segments, std::int64_t range, Dice& dice) {
  std::int64_t at[6];
  for (std::int64_t& value : at) value = dice.between(0, range);
  segments.insert(
      segments.end(),
      {{at[0], at[1], at[2], at[3]}, {at[2], at[3], at[4], at[5]}, {at[4], at[5], at[0], at[1]}});
}

}  // namespace

TestMap random_subdivision(std::uint32_t shapes, std::int64_t range, std::uint64_t seed) {
  Dice dice(seed);
  std::vector<IntegerSegment> segments;
  for (std::uint32_t i = 0; i < shapes; ++i) {
    const std::int64_t kind = dice.between(0, 4);
    if (kind <= 2) add_rectangle(segments, range, dice);
    if (kind == 3) add_triangle(segments, range, dice);
    if (kind == 4) {
      segments.push_back({dice.between(0, range), dice.between(0, range), dice.between(0, range),
                          dice.between(0, range)});
    }
  }
  return subdivision_of(segments);
}

const std::vector<MapFamily>& map_families() {
  static const std::vector<MapFamily> kFamilies{
      {"grid", [](std::uint32_t faces) { return grid(root(faces)); }},
      {"jittered-triangles",
       [](std::uint32_t faces) { return jittered_triangles(root(faces / 2), 1); }},
      {"comb", [](std::uint32_t faces) { return comb(faces / 2); }},
      {"fan", [](std::uint32_t faces) { return fan(faces); }},
      {"nest", [](std::uint32_t faces) { return nest(faces); }},
      {"hexagons", [](std::uint32_t faces) { return hexagons(root(faces), 1); }},
      {"line-arrangement",
       [](std::uint32_t faces) { return line_arrangement(root(faces * 2), 1); }},
  };
  return kFamilies;
}

const MapFamily& map_family(std::string_view name) {
  return *std::ranges::find(map_families(), name, &MapFamily::name);
}

}  // namespace plumb::testing
