// Checks a list of regions, builds its half-edge structure, then breaks it and asks what is wrong.
#include "plumb/plane/map_check.h"

#include <cstdint>
#include <initializer_list>
#include <iostream>
#include <span>

namespace {

void list(plumb::Map& map, std::initializer_list<std::uint32_t> vertices) {
  map.add_cycle(std::span(vertices.begin(), vertices.size()));
}

plumb::Map unit_square_corners() {
  plumb::Map map;
  for (const plumb::Point2 p : {plumb::Point2{0, 0}, {1, 0}, {1, 1}, {0, 1}}) {
    map.points.push_back(p);
  }
  return map;
}

}  // namespace

int main() {
  // Two triangles, counter-clockwise, and the outer boundary, clockwise.
  plumb::Map square = unit_square_corners();
  list(square, {0, 1, 3});
  list(square, {1, 2, 3});
  list(square, {3, 2, 1, 0});
  const plumb::MapReport good = plumb::check_map(square);
  if (good.verdict != plumb::MapVerdict::Valid) return 1;
  const plumb::Dcel dcel = plumb::to_dcel(good).dcel;
  std::cout << "valid: " << good.regions.size() << " regions, " << dcel.halfedge_count()
            << " half-edges\n";

  // The same without the second triangle.
  plumb::Map broken = unit_square_corners();
  list(broken, {0, 1, 3});
  list(broken, {3, 2, 1, 0});
  const plumb::MapReport bad = plumb::check_map(broken);
  if (bad.verdict != plumb::MapVerdict::Open) return 1;
  std::cout << "open: " << bad.counts.open << " edges lack their other side\n";
  for (const plumb::MapDefect& defect : bad.defects) std::cout << defect.hint << "\n";
}
