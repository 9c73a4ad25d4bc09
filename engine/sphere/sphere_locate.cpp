// Where a direction lies in a map, and what a map is around its centre.
#include "plumb/base/error.h"
#include "plumb/predicates/plane_signs.h"
#include "plumb/sphere/sphere_overlay.h"
#include "plumb/sphere/sphere_path.h"

namespace plumb {
namespace {

bool is_parallel(const PlaneTable& planes, PlaneId p, PlaneId q) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (minor_sign(planes, p, q, axis) != Sign::Zero) return false;
  }
  return true;
}

/// The plane of the map parallel to one that need not pass through the centre, if there is one. Canonical planes
/// that are parallel have normals of one direction, so either names the same directions.
PlaneId plane_like(const PlaneTable& planes, const SphereMap& map, PlaneId plane) {
  PlaneId like = plane;
  const auto look_at = [&](PlaneId p) {
    if (like == plane && p != plane && is_parallel(planes, p, plane)) like = p;
    return p == plane;
  };
  for (const PlaneId c : map.circle) {
    if (look_at(c)) return plane;
  }
  for (const SphereDirection& d : map.direction) {
    if (look_at(d.p) || look_at(d.q)) return plane;
  }
  return like;
}

bool all_are(const std::vector<Mark>& marks, Mark mark) {
  for (const Mark m : marks) {
    if (m != mark) return false;
  }
  return true;
}

bool is_edge(const PlaneTable& planes, const SphereMap& map) {
  if (map.point_count() != 2 || !all_are(map.point_mark, map.centre_mark)) return false;
  for (std::uint32_t a = 0; a < map.arc_count(); ++a) {
    if (map.is_loop(a) || map.origin[2 * a] == map.origin[2 * a + 1]) return false;
  }
  return is_opposite(planes, map.direction[0], map.direction[1]);
}

}  // namespace

// Planes through the centre are told apart by their ids; the direction's need not be through it.
SphereCell locate(const PlaneTable& planes, const SphereMap& map, SphereDirection direction) {
  direction = {plane_like(planes, map, direction.p), plane_like(planes, map, direction.q)};
  for (std::uint32_t v = 0; v < map.point_count(); ++v) {
    if (is_same(planes, map.direction[v], direction)) return SphereCell::point(v);
  }
  for (std::uint32_t a = 0; a < map.arc_count(); ++a) {
    if (is_on_arc(planes, map, a, direction)) return SphereCell::arc(a);
  }
  if (map.arc_count() == 0) return SphereCell::face(0);
  std::vector<PathHit> hits;
  walk_to_arc(planes, map, direction, 0, hits);
  PLUMB_CHECK(!hits.empty() && hits.front().entry.is_valid());
  return SphereCell::face(face_of(map, hits.front().entry));
}

PyramidKind classify(const PlaneTable& planes, const SphereMap& map) {
  if (map.point_count() == 0 && map.arc_count() == 0) {
    return map.face_mark[0] == map.centre_mark ? PyramidKind::Volume : PyramidKind::Vertex;
  }
  if (map.point_count() == 0 && map.arc_count() == 1) {
    return map.arc_mark[0] == map.centre_mark ? PyramidKind::Facet : PyramidKind::Vertex;
  }
  return is_edge(planes, map) ? PyramidKind::Edge : PyramidKind::Vertex;
}

}  // namespace plumb
