// NefSphere: where directions lie, and what great circles meet.
#include <algorithm>
#include <utility>

#include "plumb/base/refused_memory.h"
#include "plumb/sphere/nef_sphere.h"
#include "plumb/sphere/sphere_locator.h"
#include "plumb/sphere/sphere_overlay.h"
#include "plumb/sphere/sphere_round.h"
#include "plumb/sphere/sphere_vectors.h"

namespace plumb {
namespace {

/// From so many directions on a locator is worth its making.
constexpr std::size_t kMany = 16;

/// All on a circle from a place on, as one goes.
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

std::vector<SphereLocation> NefSphere::locate(std::span<const SphereVector> directions) const try {
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
} catch (...) {
  rethrow_refused_memory();
}

SphereLocation NefSphere::locate(const SphereVector& direction) const try {
  return locate({&direction, 1}).front();
} catch (...) {
  rethrow_refused_memory();
}

bool NefSphere::has_on_boundary(const SphereVector& direction) const {
  return locate(direction).cell.kind() != SphereCell::Kind::Face;
}

std::optional<SphereHit> NefSphere::shoot(const SphereVector& origin,
                                          const SphereVector& towards) const try {
  return shoot_once(*this, origin, towards,
                    [](const SphereRound& round, auto next) { return round.first_marked(next); });
} catch (...) {
  rethrow_refused_memory();
}

std::optional<SphereHit> NefSphere::shoot_to_boundary(const SphereVector& origin,
                                                      const SphereVector& towards) const try {
  return shoot_once(*this, origin, towards, [](const SphereRound& round, auto next) {
    return round.first_of_boundary(next);
  });
} catch (...) {
  rethrow_refused_memory();
}

}  // namespace plumb
