// Location of directions and shots along great circles, in a map that is prepared once.
//
// A SphereWalk goes once around on a great circle, piece by piece, and returns the cells that it
// meets, in order. It does not examine the rest of the map. Main flow of SphereWalk::next():
//  1. certain   returns the nearest thing that has been found and not returned yet, if it surely
//               lies on the pieces that have been searched
//  2. further   otherwise searches one more piece, twice as long as the last; the first is about as
//               long as an arc of a map that is spread evenly. Items whose bounds the piece may
//               meet are asked exactly, over the whole circle (Leg). If they are many more than all
//               that were asked before, the piece is halved first.
// Invariant: all that a searched piece meets has been found, so nothing found later comes before
// what is certain. Doubles decide which items are tested and how long this takes, but never which
// cells are met.
//
// Cost: the items near the way up to the last thing that is taken; a point on the way costs its
// degree.
//
// Tested by tests/sphere/sphere_locator_test.cpp.

#include "plumb/sphere/sphere_locator.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

#include "plumb/predicates/error.h"
#include "plumb/sphere/arcs/sphere_arcs.h"
#include "plumb/sphere/arcs/sphere_bounds.h"
#include "plumb/sphere/query/sphere_shoot.h"
#include "plumb/sphere/set/sphere_vectors.h"

namespace plumb {

/// Memory that walks over one map reuse.
struct WalkMemory {
  explicit WalkMemory(const SphereMap& map) : last_walk(map.point_count() + map.arc_count(), 0) {}
  /// Begins a walk, in which no item has been tested yet.
  void begin();

  std::vector<std::uint32_t> last_walk;  ///< The last walk that asked each point, then each arc.
  std::uint32_t walk = 0;                ///< The number of the walk.
  std::vector<PathHit> hits;             ///< What the walk has found, sorted from taken_ on.
  std::vector<std::uint32_t> found;      ///< The items of a piece.
  std::uint64_t asked = 0;               ///< The number of items that all walks have asked.
};

/// One walk around a great circle.
class SphereWalk {
 public:
  /// Starts at a place on the circle, in the circle's orientation. Requires that `start` contains
  /// the place, that `tree` is over bounds_of() the map, that all arguments outlive the walk, and
  /// that the table does not change.
  SphereWalk(const PlaneTable& planes, const SphereMap& map, const SphereBoundTree& tree,
             WalkMemory& memory, OrientedPlane circle, CirclePlace from, const UnitBall& start);

  /// Returns the next cell that is met, with entry and exit in the direction of the walk. Returns
  /// nothing after the last cell.
  std::optional<PathHit> next();

 private:
  bool is_certain(const PathHit& hit) const;
  bool is_before(const PathHit& x, const PathHit& y) const;
  SphereBound piece() const;
  void find_few();
  void look_further();

  const PlaneTable& planes_;
  const SphereMap& map_;
  const SphereBoundTree& tree_;
  WalkMemory& memory_;
  OrientedPlane circle_;
  CirclePlace from_;
  UnitWay way_;
  double step_;
  double done_ = 0;  ///< The angle that has been searched.
  bool is_round_ = false;
  std::size_t asked_ = 0;
  std::size_t taken_ = 0;
};

namespace {

// The greatest length of a piece, which is less than a half-circle.
constexpr double kLongest = 1.5;
constexpr double kShortest = 1e-10;  // Shorter pieces do not separate items.
constexpr std::size_t kFew = 16;
// The value exceeds a full turn by more than all errors.
constexpr double kRound = 2 * std::numbers::pi + 1e-3;

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

/// Whether a hit surely lies on the pieces that have been searched. In doubles a place just after
/// the start may have the angle of one just before it, so the half of the circle is asked exactly.
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

/// Whether x is met before y. Against the canonical direction, the order is reversed, except that a
/// hit at the start remains first.
bool SphereWalk::is_before(const PathHit& x, const PathHit& y) const {
  const PlaneId c = circle_.plane();
  if (!circle_.is_opposite()) return is_before_on(planes_, c, from_, x.place, y.place);
  const bool starts_x = turn_on(planes_, c, from_, x.place) == TurnClass::None;
  const bool starts_y = turn_on(planes_, c, from_, y.place) == TurnClass::None;
  if (starts_x || starts_y) return starts_x && !starts_y;
  return is_before_on(planes_, c, from_, y.place, x.place);
}

/// Returns the next piece, whose length is step_. If the errors are too large for pieces, returns
/// the whole circle.
SphereBound SphereWalk::piece() const {
  if (!way_.is_sharp()) return {SphereBound::Kind::Circle, {}, {}, way_.normal};
  return {SphereBound::Kind::ShortArc, way_.at(done_), way_.at(std::min(done_ + step_, kRound)),
          way_.normal};
}

/// Halves the next piece until it has few enough items, and finds the items that have not been
/// tested yet.
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

/// Searches one more piece. Items are tested over the whole circle, so each item is tested once in
/// a walk.
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

namespace {

/// Returns a ball around a vector, computed from its coordinates because the planes that define the
/// direction may be nearly parallel.
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

/// Returns the point or arc that contains the direction, or an invalid cell if there is none.
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

/// Returns the face around a direction that is on no point or arc.
SphereCell SphereLocator::State::face_around(SphereDirection u, const UnitBall& ball) {
  if (map.arc_count() == 0) return SphereCell::face(0);
  const PlaneId c = u.p;
  std::optional<PathHit> hit = walk({c, false}, {u.q, false}, ball).next();
  if (!hit) {
    // The whole circle c lies in the face. No arc lies on c, and no arc is a loop, because a loop
    // would meet c. Therefore a walk along the circle of any arc, beginning where it crosses c,
    // first meets the boundary of that face.
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

SphereLocator::SphereLocator(const NefSphere& set) : state_(std::make_unique<State>(set)) {}
SphereLocator::~SphereLocator() = default;
SphereLocator::SphereLocator(SphereLocator&&) noexcept = default;
SphereLocator& SphereLocator::operator=(SphereLocator&&) noexcept = default;

const NefSphere& SphereLocator::set() const { return state_->set; }
std::uint64_t SphereLocator::asked() const { return state_->memory.asked; }

SphereLocation SphereLocator::locate(const SphereVector& direction) {
  state_->begin_query();
  const SphereDirection u = intern_direction(state_->planes, direction);
  const SphereCell cell = state_->locate(u, ball_of(direction));
  return {cell, is_marked(state_->map, cell)};
}

bool SphereLocator::has_on_boundary(const SphereVector& direction) {
  state_->begin_query();
  const SphereDirection u = intern_direction(state_->planes, direction);
  return state_->on_item(u, ball_of(direction)).is_valid();
}

std::optional<SphereHit> SphereLocator::shoot(const SphereVector& origin,
                                              const SphereVector& towards) {
  return state_->shoot(origin, towards, [](const SphereRound& round, auto next) {
    return round.first_marked(next);
  });
}

std::optional<SphereHit> SphereLocator::shoot_to_boundary(const SphereVector& origin,
                                                          const SphereVector& towards) {
  return state_->shoot(origin, towards, [](const SphereRound& round, auto next) {
    return round.first_of_boundary(next);
  });
}

}  // namespace plumb
