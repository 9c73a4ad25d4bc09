// NefSphere: where directions lie, and what great circles meet.
#include <algorithm>
#include <utility>

#include "plumb/base/error.h"
#include "plumb/sphere/nef_sphere.h"
#include "plumb/sphere/sphere_overlay.h"
#include "plumb/sphere/sphere_path.h"
#include "plumb/sphere/sphere_vectors.h"

namespace plumb {
namespace {

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

// Once around on a great circle: what is met, and what lies between.
class Round {
 public:
  Round(const NefSphere& set, const SphereVector& origin, const SphereVector& towards)
      : map_(set.map()), origin_(origin), planes_(set.planes()) {
    const SphereVector normal = cross(origin, towards);
    if (normal.is_zero()) {
      throw Error(ErrorCode::BadArgument,
                  "two directions that are the same or opposite lie on no one great circle");
    }
    circle_ = intern_circle(planes_, normal);
    const SphereDirection u = intern_direction(planes_, origin);
    start_ = locate(planes_, map_, u);
    const PlaneId c = circle_.plane();
    const CirclePlace place = place_on(planes_, c, u);
    walk_leg(planes_, map_, c, place, place, hits_);
    starts_with_hit_ =
        !hits_.empty() && turn_on(planes_, c, place, hits_.front().place) == TurnClass::None;
    if (circle_.is_opposite()) turn_back();
  }

  std::optional<SphereHit> first_marked() const {
    if (is_marked(map_, start_)) return SphereHit{{start_, true}, origin_};
    SphereCell between = starts_with_hit_ ? after(hits_.front()) : start_;
    if (is_marked(map_, between)) return SphereHit{{between, true}, origin_};
    for (std::size_t i = first_later(); i < hits_.size(); ++i) {
      if (is_marked(map_, hits_[i].cell)) return SphereHit{{hits_[i].cell, true}, at(hits_[i])};
      between = after(hits_[i]);
      if (is_marked(map_, between)) return SphereHit{{between, true}, at(hits_[i])};
    }
    return std::nullopt;
  }

  std::optional<SphereHit> first_of_boundary() const {
    if (start_.kind() != SphereCell::Kind::Face) {
      return SphereHit{{start_, is_marked(map_, start_)}, origin_};
    }
    if (hits_.empty()) return std::nullopt;
    const PathHit& hit = hits_.front();
    return SphereHit{{hit.cell, is_marked(map_, hit.cell)}, at(hit)};
  }

 private:
  std::size_t first_later() const { return starts_with_hit_ ? 1 : 0; }

  /// As met clockwise.
  void turn_back() {
    std::reverse(hits_.begin() + static_cast<std::ptrdiff_t>(first_later()), hits_.end());
    for (PathHit& hit : hits_) std::swap(hit.entry, hit.exit);
  }

  /// The face or arc that one goes on in.
  SphereCell after(const PathHit& hit) const {
    if (hit.exit.half_arc != SphereMap::kNone)
      return SphereCell::face(map_.face[hit.exit.half_arc]);
    if (hit.exit.point != SphereMap::kNone)
      return SphereCell::face(map_.point_face[hit.exit.point]);
    std::uint32_t h = map_.first_out[hit.cell.index()];
    while (heading_of(map_, h) != circle_) h = map_.clockwise(h);
    return SphereCell::arc(h / 2);
  }

  SphereVector at(const PathHit& hit) const {
    return exact_direction(planes_, direction_of(circle_.plane(), hit.place));
  }

  const SphereMap& map_;
  SphereVector origin_;
  PlaneTable planes_;
  OrientedPlane circle_;
  SphereCell start_;
  std::vector<PathHit> hits_;
  bool starts_with_hit_ = false;
};

}  // namespace

std::vector<SphereLocation> NefSphere::locate(std::span<const SphereVector> directions) const {
  PlaneTable table(planes());
  std::vector<SphereLocation> locations;
  for (const SphereVector& v : directions) {
    const SphereCell cell = plumb::locate(table, map(), intern_direction(table, v));
    locations.push_back({cell, is_marked(map(), cell)});
  }
  return locations;
}

SphereLocation NefSphere::locate(const SphereVector& direction) const {
  return locate({&direction, 1}).front();
}

bool NefSphere::has_on_boundary(const SphereVector& direction) const {
  return locate(direction).cell.kind() != SphereCell::Kind::Face;
}

std::optional<SphereHit> NefSphere::shoot(const SphereVector& origin,
                                          const SphereVector& towards) const {
  return Round(*this, origin, towards).first_marked();
}

std::optional<SphereHit> NefSphere::shoot_to_boundary(const SphereVector& origin,
                                                      const SphereVector& towards) const {
  return Round(*this, origin, towards).first_of_boundary();
}

}  // namespace plumb
