#include "plumb/sphere/sphere_walk.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace plumb {
namespace {

constexpr double kLongest = 1.5;                        // of a piece: less than a half-circle
constexpr double kRound = 2 * std::numbers::pi + 1e-3;  // more than all that is off

UnitBall oriented(UnitBall normal, bool is_opposite) {
  if (is_opposite) {
    for (double& x : normal.middle) x = -x;
  }
  return normal;
}

}  // namespace

void WalkMemory::begin() {
  hits.clear();
  if (++walk != 0) return;
  std::fill(last_walk.begin(), last_walk.end(), 0U);
  walk = 1;
}

SphereWalk::SphereWalk(const PlaneTable& planes, const SphereMap& map, const SphereBoundTree& tree,
                       WalkMemory& memory, OrientedPlane circle, CirclePlace from,
                       const UnitBall& start)
    : planes_(planes),
      map_(map),
      tree_(tree),
      memory_(memory),
      circle_(circle),
      from_(from),
      way_{oriented(ball_of(planes, circle.plane()), circle.is_opposite()), start},
      step_(1 / std::sqrt(static_cast<double>(memory.last_walk.size() + 1))) {
  memory_.begin();
}

std::optional<PathHit> SphereWalk::next() {
  for (;;) {
    if (taken_ < memory_.hits.size() && is_certain(memory_.hits[taken_])) {
      return memory_.hits[taken_++];
    }
    if (is_round_) return std::nullopt;
    look_further();
  }
}

/// Doubles take a place just behind the start for one before it, so the half it lies on is asked exactly.
bool SphereWalk::is_certain(const PathHit& hit) const {
  if (is_round_) return true;
  TurnClass turn = turn_on(planes_, circle_.plane(), from_, hit.place);
  if (turn == TurnClass::None) return true;
  const UnitBall at = ball_of(planes_, direction_of(circle_.plane(), hit.place));
  if (at.radius > 1e-3) return false;
  double angle = way_.angle_of(at);
  const bool is_first_half = (turn == TurnClass::Left) != circle_.is_opposite();
  if (angle < (is_first_half ? -1.0 : 1.0)) angle += 2 * std::numbers::pi;
  return angle + way_.slack(at) < done_;
}

bool SphereWalk::is_before(const PathHit& x, const PathHit& y) const {
  const PlaneId c = circle_.plane();
  if (!circle_.is_opposite()) return is_before_on(planes_, c, from_, x.place, y.place);
  const bool starts_x = turn_on(planes_, c, from_, x.place) == TurnClass::None;
  const bool starts_y = turn_on(planes_, c, from_, y.place) == TurnClass::None;
  if (starts_x || starts_y) return starts_x && !starts_y;
  return is_before_on(planes_, c, from_, y.place, x.place);
}

SphereBound SphereWalk::next_piece() {
  if (!way_.is_sharp()) {
    is_round_ = true;
    return {SphereBound::Kind::Circle, {}, {}, way_.normal};
  }
  const double from = done_;
  done_ = std::min(done_ + step_, kRound);
  step_ = std::min(2 * step_, kLongest);
  is_round_ = done_ == kRound;
  return {SphereBound::Kind::ShortArc, way_.at(from), way_.at(done_), way_.normal};
}

void SphereWalk::look_further() {
  std::vector<PathHit>& hits = memory_.hits;
  const std::size_t first = hits.size();
  const Leg leg(planes_, map_, circle_.plane(), from_, from_);
  tree_.for_each_meeting(next_piece(), [&](std::uint32_t item) {
    if (std::exchange(memory_.last_walk[item], memory_.walk) == memory_.walk) return;
    ++memory_.asked;
    const auto points = static_cast<std::uint32_t>(map_.point_count());
    if (item < points) {
      leg.add_point(item, hits);
    } else {
      leg.add_arc(item - points, hits);
    }
  });
  if (circle_.is_opposite()) {
    for (std::size_t i = first; i < hits.size(); ++i) std::swap(hits[i].entry, hits[i].exit);
  }
  std::sort(hits.begin() + static_cast<std::ptrdiff_t>(taken_), hits.end(),
            [&](const PathHit& x, const PathHit& y) { return is_before(x, y); });
}

}  // namespace plumb
