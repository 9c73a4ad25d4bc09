#include "plumb/sphere/sphere_locator.h"

#include <algorithm>
#include <array>

#include "plumb/base/error.h"
#include "plumb/base/refused_memory.h"
#include "plumb/sphere/sphere_round.h"
#include "plumb/sphere/sphere_vectors.h"
#include "plumb/sphere/sphere_walk.h"

namespace plumb {
namespace {

/// The planes that name it may be nearly parallel; its coordinates never fail.
UnitBall ball_of(const SphereVector& v) {
  Rational largest;
  for (const Rational* x : {&v.x, &v.y, &v.z}) largest = std::max(largest, Rational(abs(*x)));
  const auto scaled = [&](const Rational& x) { return Rational(x / largest).convert_to<double>(); };
  return unit_ball({scaled(v.x), scaled(v.y), scaled(v.z)}, 1e-15);
}

}  // namespace

struct SphereLocator::State {
  explicit State(const NefSphere& s)
      : set(s), map(set.map()), planes(set.planes()), tree(bounds_of(planes, map)), memory(map) {}

  void begin_query() {
    if (planes.size() > 2 * set.planes().size() + 64) planes = PlaneTable(set.planes());
  }
  SphereWalk walk(OrientedPlane circle, CirclePlace from, const UnitBall& start) {
    return SphereWalk(planes, map, tree, memory, circle, from, start);
  }
  SphereCell on_item(SphereDirection u, const UnitBall& ball);
  SphereCell face_around(SphereDirection u, const UnitBall& ball);
  SphereCell locate(SphereDirection u, const UnitBall& ball) {
    const SphereCell item = on_item(u, ball);
    return item.is_valid() ? item : face_around(u, ball);
  }
  template <class Ask>
  std::optional<SphereHit> shoot(const SphereVector& origin, const SphereVector& towards, Ask ask);

  NefSphere set;
  const SphereMap& map;
  PlaneTable planes;
  SphereBoundTree tree;
  WalkMemory memory;
};

/// The point or arc that the direction lies on, if any.
SphereCell SphereLocator::State::on_item(SphereDirection u, const UnitBall& ball) {
  const auto points = static_cast<std::uint32_t>(map.point_count());
  SphereCell found;
  tree.for_each_meeting({SphereBound::Kind::Point, ball, {}, {}}, [&](std::uint32_t item) {
    if (found.is_valid()) return;
    ++memory.asked;
    if (item < points) {
      if (is_same(planes, map.direction[item], u)) found = SphereCell::point(item);
    } else if (is_on_arc(planes, map, item - points, u)) {
      found = SphereCell::arc(item - points);
    }
  });
  return found;
}

/// Of a direction on no item.
SphereCell SphereLocator::State::face_around(SphereDirection u, const UnitBall& ball) {
  if (map.arc_count() == 0) return SphereCell::face(0);
  const PlaneId c = u.p;
  std::optional<PathHit> hit = walk({c, false}, {u.q, false}, ball).next();
  if (!hit) {
    // All of c lies in the face. No arc runs along c, and none is a loop: a loop would meet it.
    const PlaneId r = map.circle[0];
    const CirclePlace corner{c, false};
    hit = walk({r, false}, corner, plumb::ball_of(planes, direction_of(r, corner))).next();
  }
  PLUMB_CHECK(hit.has_value() && hit->entry.is_valid());
  return SphereCell::face(face_of(map, hit->entry));
}

template <class Ask>
std::optional<SphereHit> SphereLocator::State::shoot(const SphereVector& origin,
                                                     const SphereVector& towards, Ask ask) {
  begin_query();
  const OrientedPlane circle = intern_circle_through(planes, origin, towards);
  const SphereDirection u = intern_direction(planes, origin);
  const UnitBall ball = ball_of(origin);
  const SphereCell start = locate(u, ball);
  const CirclePlace from = place_on(planes, circle.plane(), u);
  SphereWalk way = walk(circle, from, ball);
  return ask(SphereRound(planes, map, circle, from, start, origin), [&] { return way.next(); });
}

SphereLocator::SphereLocator(const NefSphere& set) try : state_(std::make_unique<State>(set)) {
} catch (...) {
  rethrow_refused_memory();
}
SphereLocator::~SphereLocator() = default;
SphereLocator::SphereLocator(SphereLocator&&) noexcept = default;
SphereLocator& SphereLocator::operator=(SphereLocator&&) noexcept = default;

const NefSphere& SphereLocator::set() const { return state_->set; }
std::uint64_t SphereLocator::asked() const { return state_->memory.asked; }

SphereLocation SphereLocator::locate(const SphereVector& direction) try {
  state_->begin_query();
  const SphereDirection u = intern_direction(state_->planes, direction);
  const SphereCell cell = state_->locate(u, ball_of(direction));
  return {cell, is_marked(state_->map, cell)};
} catch (...) {
  rethrow_refused_memory();
}

bool SphereLocator::has_on_boundary(const SphereVector& direction) try {
  state_->begin_query();
  const SphereDirection u = intern_direction(state_->planes, direction);
  return state_->on_item(u, ball_of(direction)).is_valid();
} catch (...) {
  rethrow_refused_memory();
}

std::optional<SphereHit> SphereLocator::shoot(const SphereVector& origin,
                                              const SphereVector& towards) try {
  return state_->shoot(origin, towards, [](const SphereRound& round, auto next) {
    return round.first_marked(next);
  });
} catch (...) {
  rethrow_refused_memory();
}

std::optional<SphereHit> SphereLocator::shoot_to_boundary(const SphereVector& origin,
                                                          const SphereVector& towards) try {
  return state_->shoot(origin, towards, [](const SphereRound& round, auto next) {
    return round.first_of_boundary(next);
  });
} catch (...) {
  rethrow_refused_memory();
}

}  // namespace plumb
