#include "plumb/sphere/sphere_walk.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace plumb {
namespace {

constexpr double kLongest = 1.5;     // of a piece: less than a half-circle
constexpr double kShortest = 1e-10;  // no shorter ones tell things apart
constexpr std::size_t kFew = 16;
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

/// The next one, of length step_. Where doubles say too little: the whole circle.
SphereBound SphereWalk::piece() const {
  if (!way_.is_sharp()) return {SphereBound::Kind::Circle, {}, {}, way_.normal};
  return {SphereBound::Kind::ShortArc, way_.at(done_), way_.at(std::min(done_ + step_, kRound)),
          way_.normal};
}

/// Finds the items of a piece that is short enough.
void SphereWalk::find_few() {
  std::vector<std::uint32_t>& found = memory_.found;
  for (;; step_ /= 2) {
    const bool takes_all = !way_.is_sharp() || step_ < kShortest;
    const std::size_t most = kFew + 2 * asked_;
    found.clear();
    const bool is_complete = tree_.find_meeting(piece(), [&](std::uint32_t item) {
      if (memory_.last_walk[item] != memory_.walk) found.push_back(item);
      return takes_all || found.size() <= most;
    });
    if (is_complete) return;
  }
}

void SphereWalk::look_further() {
  find_few();
  done_ = std::min(done_ + step_, kRound);
  step_ = std::min(2 * step_, kLongest);
  is_round_ = done_ == kRound || !way_.is_sharp();
  std::vector<PathHit>& hits = memory_.hits;
  const std::size_t first = hits.size();
  const Leg leg(planes_, map_, circle_.plane(), from_, from_);
  const auto points = static_cast<std::uint32_t>(map_.point_count());
  for (const std::uint32_t item : memory_.found) {
    memory_.last_walk[item] = memory_.walk;
    if (item < points) {
      leg.add_point(item, hits);
    } else {
      leg.add_arc(item - points, hits);
    }
  }
  asked_ += memory_.found.size();
  memory_.asked += memory_.found.size();
  if (circle_.is_opposite()) {
    for (std::size_t i = first; i < hits.size(); ++i) std::swap(hits[i].entry, hits[i].exit);
  }
  std::sort(hits.begin() + static_cast<std::ptrdiff_t>(taken_), hits.end(),
            [&](const PathHit& x, const PathHit& y) { return is_before(x, y); });
}

}  // namespace plumb
