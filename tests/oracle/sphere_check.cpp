#include "oracle/sphere_check.h"

#include "plumb/sphere/sphere_overlay.h"

namespace plumb::testing {
namespace {

std::string to_text(const CellVector& v) {
  return '(' + v[0].str() + ", " + v[1].str() + ", " + v[2].str() + ')';
}

std::string to_text(SphereItems::Item item) {
  static constexpr const char* kNames[] = {"point ", "arc ", "face "};
  return kNames[item.dimension] + std::to_string(item.index);
}

SphereItems::Item item_of(SphereCell cell) { return {static_cast<int>(cell.kind()), cell.index()}; }

bool mark_of(const SphereMap& map, SphereItems::Item item) {
  const std::vector<Mark>& marks = item.dimension == 0   ? map.point_mark
                                   : item.dimension == 1 ? map.arc_mark
                                                         : map.face_mark;
  return marks[item.index] != 0;
}

OrientedPlane plane_in(PlaneTable& planes, const CellVector& n) {
  return planes.intern(to_rational(BigRational(n[0])), to_rational(BigRational(n[1])),
                       to_rational(BigRational(n[2])), Rational(0));
}

}  // namespace

/// (v x e1) x (v x e2) = v (v . e3)
SphereDirection direction_in(PlaneTable& planes, const CellVector& v) {
  std::size_t axis = 0;
  while (v[axis] == 0) ++axis;
  CellVector first{};
  CellVector second{};
  first[(axis + 1) % 3] = 1;
  second[(axis + 2) % 3] = 1;
  const OrientedPlane p = plane_in(planes, cross(v, first));
  const OrientedPlane q = plane_in(planes, cross(v, second));
  const bool is_opposite = (v[axis] < 0) != (p.is_opposite() != q.is_opposite());
  const SphereDirection u{p.plane(), q.plane()};
  return is_opposite ? u.opposite() : u;
}

std::string difference(PlaneTable& planes, const SphereMap& map, const SphereCells& cells,
                       const SphereMarks& marks) {
  const SphereItems items = minimal_items(cells, marks);
  const std::array<std::size_t, 3> count{map.point_count(), map.arc_count(), map.face_count()};
  if (count != items.count) {
    std::string text = "points, arcs, faces: engine";
    for (const std::size_t n : count) text += ' ' + std::to_string(n);
    text += ", twin";
    for (const std::size_t n : items.count) text += ' ' + std::to_string(n);
    return text;
  }
  std::map<SphereItems::Item, SphereItems::Item> engine_item;
  std::map<SphereItems::Item, SphereItems::Item> twin_item;
  for (std::size_t c = 0; c < cells.size(); ++c) {
    const std::string where = "at " + to_text(cells[c].sample) + ": engine ";
    const auto got = item_of(locate(planes, map, direction_in(planes, cells[c].sample)));
    const auto expected = items.item_of[c];
    const bool is_right = engine_item.try_emplace(expected, got).first->second == got &&
                          twin_item.try_emplace(got, expected).first->second == expected;
    if (got.dimension != expected.dimension || !is_right) {
      return where + to_text(got) + ", twin " + to_text(expected);
    }
    if (mark_of(map, got) != marks[c]) return where + (marks[c] ? "unmarked" : "marked");
  }
  return "";
}

}  // namespace plumb::testing
