#include "plumb/sphere/sphere_round.h"

#include "plumb/base/error.h"
#include "plumb/sphere/sphere_vectors.h"

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

/// The face or arc that one goes on in.
SphereCell SphereRound::after(const PathHit& hit) const {
  if (hit.exit.is_valid()) return SphereCell::face(face_of(map_, hit.exit));
  std::uint32_t h = map_.first_out[hit.cell.index()];
  while (heading_of(map_, h) != circle_) h = map_.clockwise(h);
  return SphereCell::arc(h / 2);
}

SphereVector SphereRound::at(const PathHit& hit) const {
  return exact_direction(planes_, direction_of(circle_.plane(), hit.place));
}

}  // namespace plumb
