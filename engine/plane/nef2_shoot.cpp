// Nef2: ray shooting, element by element (ray_walk.h).
#include "plumb/base/error.h"
#include "plumb/base/refused_memory.h"
#include "plumb/plane/nef2.h"
#include "plumb/plane/nef2_state.h"
#include "plumb/plane/ray_walk.h"

namespace plumb {
namespace {

/// The first element met that is wanted.
template <class Wanted>
std::optional<RayHit> first_met(RayWalk walk, const Wanted& is_wanted) {
  do {
    if (is_wanted(walk.here())) return RayHit{walk.here(), walk.point()};
  } while (walk.advance());
  return std::nullopt;
}

QueryRay2 ray_of(const RationalPoint2& origin, const RationalPoint2& direction) {
  if (direction.x == 0 && direction.y == 0) {
    throw Error(ErrorCode::BadArgument, "a ray needs a direction that is not zero");
  }
  return QueryRay2(origin, direction);
}

}  // namespace

const PlaneTrapezoids& Nef2::trapezoids() const {
  std::call_once(state_->trapezoids_made, [this] {
    state_->trapezoids = std::make_unique<PlaneTrapezoids>(complex(), locator());
  });
  return *state_->trapezoids;
}

std::optional<RayHit> Nef2::shoot(const RationalPoint2& origin,
                                  const RationalPoint2& direction) const try {
  const QueryRay2 ray = ray_of(origin, direction);
  return first_met(RayWalk(complex(), locator(), trapezoids(), ray),
                   [](const PlaneLocation& at) { return at.marked; });
} catch (...) {
  rethrow_refused_memory();
}

std::optional<RayHit> Nef2::shoot_to_boundary(const RationalPoint2& origin,
                                              const RationalPoint2& direction) const try {
  const QueryRay2 ray = ray_of(origin, direction);
  return first_met(RayWalk(complex(), locator(), trapezoids(), ray),
                   [](const PlaneLocation& at) { return !at.face.is_valid(); });
} catch (...) {
  rethrow_refused_memory();
}

}  // namespace plumb
