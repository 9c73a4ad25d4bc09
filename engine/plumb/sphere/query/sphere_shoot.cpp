#include "plumb/sphere/query/sphere_shoot.h"

#include <algorithm>
#include <utility>

#include "plumb/predicates/error.h"
#include "plumb/sphere/nef_sphere.h"
#include "plumb/sphere/overlay/sphere_overlay.h"
#include "plumb/sphere/set/sphere_vectors.h"
#include "plumb/sphere/sphere_locator.h"

namespace plumb {

bool is_marked(const SphereMap& map, SphereCell cell) {
  switch (cell.kind()) {
    case SphereCell::Kind::Point:
      return map.point_mark[cell.index()] != 0;
    case SphereCell::Kind::Arc:
      return map.arc_mark[cell.index()] != 0;
    case SphereCell::Kind::Face:
      break;
  }
  return map.face_mark[cell.index()] != 0;
}

OrientedPlane intern_circle_through(PlaneTable& planes, const SphereVector& origin,
                                    const SphereVector& towards) {
  const SphereVector normal = cross(origin, towards);
  if (normal.is_zero()) {
    throw Error(ErrorCode::BadArgument,
                "two directions that are the same or opposite lie on no one great circle");
  }
  return intern_circle(planes, normal);
}

bool SphereRound::is_at_start(const PathHit& hit) const {
  return turn_on(planes_, circle_.plane(), from_, hit.place) == TurnClass::None;
}

/// Returns the face or arc in which the shot continues after a hit.
SphereCell SphereRound::after(const PathHit& hit) const {
  if (hit.exit.is_valid()) return SphereCell::face(face_of(map_, hit.exit));
  std::uint32_t h = map_.first_out[hit.cell.index()];
  while (heading_of(map_, h) != circle_) h = map_.clockwise(h);
  return SphereCell::arc(h / 2);
}

SphereVector SphereRound::at(const PathHit& hit) const {
  return exact_direction(planes_, direction_of(circle_.plane(), hit.place));
}

// NefSphere: location of directions, and shots along great circles.

namespace {

/// From this number of directions on, building a locator saves time.
constexpr std::size_t kMany = 16;

/// Returns all cells that are met on a circle from a place on, in the direction of the circle.
/// Against the canonical direction, the order is reversed, except that a hit at the start remains
/// first.
std::vector<PathHit> all_around(const PlaneTable& planes, const SphereMap& map,
                                OrientedPlane circle, CirclePlace from) {
  std::vector<PathHit> hits;
  walk_leg(planes, map, circle.plane(), from, from, hits);
  if (!circle.is_opposite()) return hits;
  const bool starts_with_hit =
      !hits.empty() && turn_on(planes, circle.plane(), from, hits.front().place) == TurnClass::None;
  std::reverse(hits.begin() + (starts_with_hit ? 1 : 0), hits.end());
  for (PathHit& hit : hits) std::swap(hit.entry, hit.exit);
  return hits;
}

template <class Ask>
std::optional<SphereHit> shoot_once(const NefSphere& set, const SphereVector& origin,
                                    const SphereVector& towards, Ask ask) {
  PlaneTable planes(set.planes());
  const OrientedPlane circle = intern_circle_through(planes, origin, towards);
  const SphereDirection u = intern_direction(planes, origin);
  const SphereCell start = locate(planes, set.map(), u);
  const CirclePlace from = place_on(planes, circle.plane(), u);
  const std::vector<PathHit> hits = all_around(planes, set.map(), circle, from);
  std::size_t taken = 0;
  return ask(SphereRound(planes, set.map(), circle, from, start, origin),
             [&] { return taken < hits.size() ? std::optional(hits[taken++]) : std::nullopt; });
}

}  // namespace

std::vector<SphereLocation> NefSphere::locate(std::span<const SphereVector> directions,
                                              Context& context) const {
  context.checkpoint("locate", 0, 0);
  std::vector<SphereLocation> locations;
  locations.reserve(directions.size());
  if (directions.size() > kMany) {
    SphereLocator locator(*this);
    for (const SphereVector& v : directions) locations.push_back(locator.locate(v));
    return locations;
  }
  PlaneTable table(planes());
  for (const SphereVector& v : directions) {
    const SphereCell cell = plumb::locate(table, map(), intern_direction(table, v));
    locations.push_back({cell, is_marked(map(), cell)});
  }
  return locations;
}

SphereLocation NefSphere::locate(const SphereVector& direction, Context& context) const {
  return locate({&direction, 1}, context).front();
}

bool NefSphere::has_on_boundary(const SphereVector& direction, Context& context) const {
  return locate(direction, context).cell.kind() != SphereCell::Kind::Face;
}

std::optional<SphereHit> NefSphere::shoot(const SphereVector& origin, const SphereVector& towards,
                                          Context& context) const {
  context.checkpoint("shoot", 0, 0);
  return shoot_once(*this, origin, towards,
                    [](const SphereRound& round, auto next) { return round.first_marked(next); });
}

std::optional<SphereHit> NefSphere::shoot_to_boundary(const SphereVector& origin,
                                                      const SphereVector& towards,
                                                      Context& context) const {
  context.checkpoint("shoot", 0, 0);
  return shoot_once(*this, origin, towards, [](const SphereRound& round, auto next) {
    return round.first_of_boundary(next);
  });
}

}  // namespace plumb
