#include "plumb/testing/map_defects.h"

#include <algorithm>
#include <ostream>

#include "plumb/predicates/error.h"

namespace plumb::testing {
namespace {

// The side of added geometry relative to its host edge. Distances between an edge's midpoint and
// anything else, and sines of angles, are far larger in maps with coordinates of up to 40 bits.
const BigRational& tiny() {
  static const BigRational kTiny = power_of_two(-100);
  return kTiny;
}

struct Corner {
  const Cycle* cycle;
  std::size_t i;
  std::uint32_t previous, vertex, next;
};

Corner corner_at(const TestMap& map, DefectPlace place) {
  const Cycle& cycle = map.cycles[place.cycle % map.cycles.size()];
  const std::size_t i = place.corner % cycle.size();
  return {&cycle, i, cycle[(i + cycle.size() - 1) % cycle.size()], cycle[i],
          cycle[(i + 1) % cycle.size()]};
}

Cycle& chosen(TestMap& map, DefectPlace place) {
  return map.cycles[place.cycle % map.cycles.size()];
}

std::vector<MapEdge> edges_of(const Cycle& cycle) {
  std::vector<MapEdge> edges;
  for (std::size_t i = 0; i < cycle.size(); ++i) {
    edges.push_back({cycle[i], cycle[(i + 1) % cycle.size()]});
  }
  return edges;
}

std::vector<MapEdge> reversed(std::vector<MapEdge> edges) {
  for (MapEdge& e : edges) std::swap(e.from, e.to);
  return edges;
}

void insert_after(Cycle& cycle, std::size_t i, std::vector<std::uint32_t> vertices) {
  cycle.insert(cycle.begin() + static_cast<std::ptrdiff_t>(i) + 1, vertices.begin(),
               vertices.end());
}

// A frame on the edge leaving a corner: point (along, left), in units of the edge.
ExactPoint beside(const TestMap& map, const Corner& corner, const BigRational& along,
                  const BigRational& left) {
  const ExactPoint& p = map.points[corner.vertex];
  const ExactPoint& q = map.points[corner.next];
  const BigRational dx = q.x - p.x;
  const BigRational dy = q.y - p.y;
  return {p.x + along * dx - left * dy, p.y + along * dy + left * dx};
}

// Adds the square [a, a + size] x [l, l + size] of that frame; returns its first vertex.
std::uint32_t add_square(TestMap& map, const Corner& corner, const BigRational& a,
                         const BigRational& l, const BigRational& size) {
  const auto first = static_cast<std::uint32_t>(map.points.size());
  const ExactPoint corners[] = {beside(map, corner, a, l), beside(map, corner, a + size, l),
                                beside(map, corner, a + size, l + size),
                                beside(map, corner, a, l + size)};
  map.points.insert(map.points.end(), std::begin(corners), std::end(corners));
  return first;
}

void list_square(TestMap& map, std::uint32_t v, bool with_outer) {
  map.cycles.push_back({v, v + 1, v + 2, v + 3});
  if (with_outer) map.cycles.push_back({v + 3, v + 2, v + 1, v});
}

void expect_open(DefectExpectation& expected, std::vector<MapEdge> edges) {
  expected.verdict = MapVerdict::Open;
  expected.open = edges.size();
  expected.open_edges = std::move(edges);
  expected.mixed = std::nullopt;
}

DefectExpectation square_expectation(std::uint32_t v, bool with_outer) {
  DefectExpectation expected;
  if (!with_outer) expect_open(expected, edges_of({v, v + 1, v + 2, v + 3}));
  return expected;
}

DefectiveMap refused(TestMap map, const char* reason) {
  DefectiveMap result{std::move(map), {}};
  result.expected.refused = reason;
  return result;
}

DefectiveMap drop(const TestMap& valid, DefectPlace place) {
  DefectiveMap result{valid, {}};
  expect_open(result.expected, reversed(edges_of(chosen(result.map, place))));
  result.map.cycles.erase(result.map.cycles.begin() +
                          static_cast<std::ptrdiff_t>(place.cycle % valid.cycles.size()));
  return result;
}

// The next cycle from `place` on with the wanted orientation.
DefectPlace oriented(const TestMap& map, DefectPlace place, bool counter_clockwise) {
  for (std::size_t tries = 0; tries < map.cycles.size(); ++tries, ++place.cycle) {
    place.cycle %= static_cast<std::uint32_t>(map.cycles.size());
    if ((doubled_area(map, map.cycles[place.cycle]) > 0) == counter_clockwise) break;
  }
  return place;
}

DefectiveMap drop_face(const TestMap& valid, DefectPlace place) {
  return drop(valid, oriented(valid, place, true));
}

DefectiveMap drop_outer(const TestMap& valid, DefectPlace place) {
  return drop(valid, oriented(valid, place, false));
}

DefectiveMap duplicate_face(const TestMap& valid, DefectPlace place) {
  DefectiveMap result{valid, {}};
  Cycle copy = chosen(result.map, place);
  std::rotate(copy.begin(), copy.begin() + 1, copy.end());
  result.expected.verdict = MapVerdict::NotAPlanarSubdivision;
  result.expected.duplicate_edges = edges_of(copy);
  result.expected.duplicate = copy.size();
  result.expected.mixed = std::nullopt;
  result.map.cycles.push_back(std::move(copy));
  return result;
}

DefectiveMap flip_face(const TestMap& valid, DefectPlace place) {
  DefectiveMap result{valid, {}};
  Cycle& cycle = chosen(result.map, place);
  std::reverse(cycle.begin(), cycle.end());
  expect_open(result.expected, edges_of(cycle));
  result.expected.verdict = MapVerdict::NotAPlanarSubdivision;
  result.expected.duplicate = cycle.size();
  result.expected.duplicate_edges = edges_of(cycle);
  return result;
}

// (A map that lists everything twice, once each way, like a nest of rings, stays valid.)
DefectiveMap flip_all(const TestMap& valid, DefectPlace) {
  DefectiveMap result{valid, {}};
  for (Cycle& cycle : result.map.cycles) std::reverse(cycle.begin(), cycle.end());
  result.expected.verdict = std::nullopt;
  result.expected.mixed = std::nullopt;
  return result;
}

// Far outside, so that its edges run across the map. (They may meet nothing when the vertex lay on
// the border; the twin judges.)
DefectiveMap move_vertex(const TestMap& valid, DefectPlace place) {
  DefectiveMap result{valid, {}};
  const Corner corner = corner_at(valid, place);
  const auto [least, greatest] = std::minmax_element(valid.points.begin(), valid.points.end());
  const BigRational width = greatest->x - least->x;
  ExactPoint& moved = result.map.points[corner.vertex];
  moved.x = greatest->x + width + BigRational(1, 3);
  moved.y += width + BigRational(2, 7);
  result.expected.verdict = std::nullopt;
  result.expected.crossing = result.expected.mixed = std::nullopt;
  return result;
}

std::uint32_t add_midpoint(TestMap& map, const Corner& corner) {
  map.points.push_back(beside(map, corner, BigRational(1, 2), 0));
  return static_cast<std::uint32_t>(map.points.size() - 1);
}

DefectiveMap t_junction(const TestMap& valid, DefectPlace place) {
  DefectiveMap result{valid, {}};
  const Corner c = corner_at(valid, place);
  const std::uint32_t middle = add_midpoint(result.map, c);
  insert_after(chosen(result.map, place), c.i, {middle});
  expect_open(result.expected, {{c.next, c.vertex}, {c.vertex, middle}, {middle, c.next}});
  const MapEdge whole{c.vertex, c.next};
  result.expected.crossing = 2;
  result.expected.pairs = {{whole, {c.vertex, middle}}, {whole, {middle, c.next}}};
  const std::vector<ExactPoint>& at = result.map.points;
  result.expected.places = {std::min(at[c.vertex], at[middle]), std::min(at[middle], at[c.next])};
  return result;
}

DefectiveMap t_both(const TestMap& valid, DefectPlace place) {
  DefectiveMap result{valid, {}};
  const Corner c = corner_at(valid, place);
  const std::uint32_t middle = add_midpoint(result.map, c);
  for (Cycle& cycle : result.map.cycles) {
    for (std::size_t i = 0; i < cycle.size(); ++i) {
      const std::uint32_t from = cycle[i];
      const std::uint32_t to = cycle[(i + 1) % cycle.size()];
      if (std::minmax(from, to) != std::minmax(c.vertex, c.next)) continue;
      insert_after(cycle, i, {middle});
      ++i;
    }
  }
  return result;
}

// A square laid over the middle of an edge: two of its sides cross the edge in their middles.
DefectiveMap overlap(const TestMap& valid, DefectPlace place) {
  DefectiveMap result{valid, {}};
  const Corner c = corner_at(valid, place);
  const BigRational start = BigRational(1, 2) - tiny();
  const std::uint32_t v = add_square(result.map, c, start, -tiny(), 2 * tiny());
  list_square(result.map, v, true);
  const MapEdge whole{c.vertex, c.next};
  result.expected.verdict = MapVerdict::Superposed;
  result.expected.crossing = 2;
  result.expected.mixed = std::nullopt;
  result.expected.pairs = {{whole, {v + 1, v + 2}}, {whole, {v + 3, v}}};
  result.expected.places = {beside(valid, c, start + 2 * tiny(), 0), beside(valid, c, start, 0)};
  return result;
}

DefectiveMap island_in(const TestMap& valid, DefectPlace place, bool with_outer) {
  DefectiveMap result{valid, {}};
  const Corner c = corner_at(valid, place);
  const std::uint32_t v = add_square(result.map, c, BigRational(1, 2), tiny(), tiny());
  list_square(result.map, v, with_outer);
  result.expected = square_expectation(v, with_outer);
  return result;
}

DefectiveMap island(const TestMap& valid, DefectPlace place) {
  return island_in(valid, place, true);
}

DefectiveMap island_open(const TestMap& valid, DefectPlace place) {
  return island_in(valid, place, false);
}

struct Box {
  BigRational x1, y1, x2, y2;
};

Box bounds(const TestMap& map) {
  Box box{map.points[0].x, map.points[0].y, map.points[0].x, map.points[0].y};
  for (const ExactPoint& p : map.points) {
    box = {std::min(box.x1, p.x), std::min(box.y1, p.y), std::max(box.x2, p.x),
           std::max(box.y2, p.y)};
  }
  return box;
}

DefectiveMap with_box(const TestMap& valid, const Box& box, bool with_outer) {
  DefectiveMap result{valid, {}};
  const std::uint32_t v = result.map.add_point(box.x1, box.y1);
  result.map.add_point(box.x2, box.y1);
  result.map.add_point(box.x2, box.y2);
  result.map.add_point(box.x1, box.y2);
  list_square(result.map, v, with_outer);
  result.expected = square_expectation(v, with_outer);
  return result;
}

Box far_box(const TestMap& map) {
  const Box box = bounds(map);
  const BigRational width = box.x2 - box.x1;
  return {box.x2 + width, box.y1, box.x2 + 2 * width, box.y2};
}

DefectiveMap far_island(const TestMap& valid, DefectPlace) {
  return with_box(valid, far_box(valid), true);
}

DefectiveMap far_island_open(const TestMap& valid, DefectPlace) {
  return with_box(valid, far_box(valid), false);
}

DefectiveMap frame(const TestMap& valid, DefectPlace) {
  const Box box = bounds(valid);
  return with_box(valid, {box.x1 - 1, box.y1 - 1, box.x2 + 1, box.y2 + 1}, true);
}

// A dangling edge just left of the edge leaving the corner: inside the cycle's own region.
DefectiveMap spike(const TestMap& valid, DefectPlace place) {
  DefectiveMap result{valid, {}};
  const Corner c = corner_at(valid, place);
  result.map.points.push_back(beside(valid, c, tiny(), tiny() * tiny()));
  const auto tip = static_cast<std::uint32_t>(valid.points.size());
  insert_after(chosen(result.map, place), c.i, {tip, c.vertex});
  result.expected.verdict = MapVerdict::Superposed;
  result.expected.twin = 1;
  return result;
}

std::uint64_t degree(const TestMap& map, std::uint32_t vertex) {
  std::uint64_t leaving = 0;  // in a valid map every edge at the vertex leaves it once
  for (const Cycle& cycle : map.cycles) {
    leaving += static_cast<std::uint64_t>(std::count(cycle.begin(), cycle.end(), vertex));
  }
  return leaving;
}

DefectiveMap alias_vertex(const TestMap& valid, DefectPlace place) {
  DefectiveMap result{valid, {}};
  const Corner c = corner_at(valid, place);
  result.map.points.push_back(valid.points[c.vertex]);
  const auto copy = static_cast<std::uint32_t>(valid.points.size());
  chosen(result.map, place)[c.i] = copy;
  expect_open(result.expected,
              {{c.previous, copy}, {copy, c.next}, {c.vertex, c.previous}, {c.next, c.vertex}});
  result.expected.crossing = 2 * degree(valid, c.vertex);
  return result;
}

DefectiveMap repeat_vertex(const TestMap& valid, DefectPlace place) {
  DefectiveMap result = refused(valid, "repeated consecutive vertex");
  const Corner c = corner_at(valid, place);
  insert_after(chosen(result.map, place), c.i, {c.vertex});
  return result;
}

DefectiveMap two_corners(const TestMap& valid, DefectPlace place) {
  DefectiveMap result = refused(valid, "fewer than 3 corners");
  const Corner c = corner_at(valid, place);
  result.map.cycles.push_back({c.vertex, c.next});
  return result;
}

DefectiveMap bad_index(const TestMap& valid, DefectPlace place) {
  DefectiveMap result = refused(valid, "vertex out of range");
  constexpr std::uint32_t kNoVertex = std::uint32_t{1}
                                      << 31U;  // nor will it be one among other maps
  chosen(result.map, place)[corner_at(valid, place).i] = kNoVertex;
  return result;
}

// A T-junction closed by a triangle without area. (Readers refuse it; check_map judges it.)
DefectiveMap sliver(const TestMap& valid, DefectPlace place) {
  DefectiveMap result = t_junction(valid, place);
  const Corner c = corner_at(valid, place);
  const auto middle = static_cast<std::uint32_t>(valid.points.size());
  result.map.cycles.push_back({c.vertex, c.next, middle});
  result.expected.verdict = MapVerdict::Superposed;
  result.expected.open = 0;
  result.expected.open_edges.clear();
  return result;
}

DefectiveMap isolated_vertex(const TestMap& valid, DefectPlace place) {
  DefectiveMap result{valid, {}};
  const Corner c = corner_at(valid, place);
  result.map.points.push_back(beside(valid, c, BigRational(1, 2), tiny()));
  return result;
}

// A triangle in the cycle's own region with a corner at its vertex: the region's boundary touches
// itself there.
DefectiveMap self_touch(const TestMap& valid, DefectPlace place) {
  DefectiveMap result{valid, {}};
  const Corner c = corner_at(valid, place);
  const auto p = static_cast<std::uint32_t>(valid.points.size());
  result.map.points.push_back(beside(valid, c, tiny(), tiny() * tiny()));
  result.map.points.push_back(beside(valid, c, tiny(), 2 * tiny() * tiny()));
  insert_after(chosen(result.map, place), c.i, {p + 1, p, c.vertex});
  result.map.cycles.push_back({c.vertex, p, p + 1});
  return result;
}

// The same triangle, listed as a hole of its own.
DefectiveMap touching_hole(const TestMap& valid, DefectPlace place) {
  DefectiveMap result = self_touch(valid, place);
  const Corner c = corner_at(valid, place);
  const auto p = static_cast<std::uint32_t>(valid.points.size());
  chosen(result.map, {static_cast<std::uint32_t>(place.cycle % valid.cycles.size()), 0}) = *c.cycle;
  result.map.cycles.push_back({c.vertex, p + 1, p});
  return result;
}

// The two faces at an edge bulge over each other.
DefectiveMap lens(const TestMap& valid, DefectPlace place) {
  DefectiveMap result{valid, {}};
  const Corner c = corner_at(valid, place);
  result.map.points.push_back(beside(valid, c, BigRational(1, 2), -tiny()));
  result.map.points.push_back(beside(valid, c, BigRational(1, 2), tiny()));
  const auto right = static_cast<std::uint32_t>(valid.points.size());
  const std::uint32_t left = right + 1;
  insert_after(chosen(result.map, place), c.i, {right});
  for (Cycle& cycle : result.map.cycles) {
    for (std::size_t i = 0; i < cycle.size(); ++i) {
      if (cycle[i] != c.next || cycle[(i + 1) % cycle.size()] != c.vertex) continue;
      insert_after(cycle, i, {left});
    }
  }
  expect_open(result.expected,
              {{c.vertex, right}, {right, c.next}, {c.next, left}, {left, c.vertex}});
  return result;
}

}  // namespace

void PrintTo(const MapDefectMaker& maker, std::ostream* out) { *out << maker.name; }

const std::vector<MapDefectMaker>& map_defect_makers() {
  static const std::vector<MapDefectMaker> kMakers{
      {"drop-face", drop_face},
      {"drop-outer", drop_outer},
      {"duplicate-face", duplicate_face},
      {"flip-face", flip_face},
      {"flip-all", flip_all},
      {"move-vertex", move_vertex},
      {"t-junction", t_junction},
      {"t-both", t_both},
      {"overlap", overlap},
      {"island", island},
      {"island-open", island_open},
      {"far-island", far_island},
      {"far-island-open", far_island_open},
      {"frame", frame},
      {"spike", spike},
      {"alias-vertex", alias_vertex},
      {"repeat-vertex", repeat_vertex},
      {"two-corners", two_corners},
      {"bad-index", bad_index},
      {"sliver", sliver},
      {"isolated-vertex", isolated_vertex},
      {"self-touch", self_touch},
      {"touching-hole", touching_hole},
      {"lens", lens},
  };
  return kMakers;
}

const MapDefectMaker& map_defect_maker(std::string_view name) {
  const auto& makers = map_defect_makers();
  const auto found =
      std::find_if(makers.begin(), makers.end(),
                   [name](const MapDefectMaker& maker) { return maker.name == name; });
  PLUMB_CHECK(found != makers.end());
  return *found;
}

}  // namespace plumb::testing
