#include "plumb/convex/plane_ring.h"

#include <cmath>

#include "plumb/predicates/plane_signs.h"
#include "plumb/predicates/point3_signs.h"

namespace plumb {

std::vector<RingSide> ring_of(const CutSurface& surface, HalfedgeId first) {
  std::vector<RingSide> ring;
  HalfedgeId h = first;
  do {
    const CutSurface::Half& half = surface.half(h);
    ring.push_back({half.origin, surface.target(h), half.other, half.along});
    h = half.next;
  } while (h != first);
  return ring;
}

bool is_hole(const CutSurface& surface, OrientedPlane plane, std::span<const RingSide> ring) {
  const auto point = [&](VertexId v) { return surface.point[v.value()]; };
  VertexId least = ring[0].from;
  for (const RingSide& side : ring) {
    if (side.from != least &&
        compare_xyz(surface.points(), point(side.from), point(least)) == Sign::Negative) {
      least = side.from;
    }
  }
  // A ring that passes the vertex several times is a hole if one of its corners there is.
  for (std::size_t i = 0; i < ring.size(); ++i) {
    if (ring[i].from != least) continue;
    const RingSide& before = ring[i == 0 ? ring.size() - 1 : i - 1];
    const Sign turn = det3_sign(surface.planes(), plane.plane(), before.other, ring[i].other) *
                      before.along * ring[i].along * plane.orientation();
    if (turn != Sign::Positive) return true;  // Zero: there and back, inside another ring
  }
  return false;
}

namespace {

/// An axis that the plane is not perpendicular to: one of the least components of the normal.
std::size_t level_axis(const PlaneRow& row) {
  const std::array<double, 3> n{std::abs(row.n[0]), std::abs(row.n[1]), std::abs(row.n[2])};
  if (n[0] <= n[1] && n[0] <= n[2]) return 0;
  return n[1] <= n[2] ? 1 : 2;
}

}  // namespace

RingPlace place_in(const CutSurface& surface, PlaneId plane, std::span<const RingSide> ring,
                   VertexId v) {
  const Point3Table& points = surface.points();
  const std::size_t axis = level_axis(surface.planes().row(plane));
  const SpacePoint x = surface.point[v.value()];
  int winding = 0;
  for (const RingSide& side : ring) {
    if (side.from == v || side.to == v) return RingPlace::On;
    const Sign a = compare_axis(points, surface.point[side.from.value()], x, axis);
    const Sign b = compare_axis(points, surface.point[side.to.value()], x, axis);
    if (a == b && a != Sign::Zero) continue;
    const Sign left = plumb::side(points, x, side.other) * side.along * Sign::Negative;
    if (left == Sign::Zero && (a != b || a == Sign::Zero)) {
      // On the line, between the ends: or level with both, on the same level line.
      if (a != Sign::Zero || b != Sign::Zero) return RingPlace::On;
      const std::size_t second = (axis + 1) % 3, third = (axis + 2) % 3;
      for (const std::size_t k : {second, third}) {
        const Sign c = compare_axis(points, surface.point[side.from.value()], x, k);
        const Sign d = compare_axis(points, surface.point[side.to.value()], x, k);
        if (c != d) return RingPlace::On;
      }
      continue;
    }
    const bool is_above_a = a == Sign::Positive, is_above_b = b == Sign::Positive;
    if (is_above_a == is_above_b) continue;
    if (is_above_b && left == Sign::Positive) ++winding;
    if (is_above_a && left == Sign::Negative) --winding;
  }
  return winding == 0 ? RingPlace::Outside : RingPlace::Inside;
}

RingPlace place_in(const CutSurface& surface, PlaneId plane, std::span<const RingSide> ring,
                   std::span<const RingSide> other) {
  for (const RingSide& side : other) {
    const RingPlace place = place_in(surface, plane, ring, side.from);
    if (place != RingPlace::On) return place;
  }
  return RingPlace::On;
}

}  // namespace plumb
