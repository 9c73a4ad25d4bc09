// NefSphere: sets to start from.
#include <algorithm>
#include <tuple>
#include <utility>

#include "plumb/base/error.h"
#include "plumb/base/refused_memory.h"
#include "plumb/sphere/nef_sphere.h"
#include "plumb/sphere/sphere_vectors.h"

namespace plumb {
namespace {

constexpr std::uint32_t kNone = SphereMap::kNone;

Mark mark_if(bool is_marked) { return is_marked ? 1 : 0; }

/// One circle, its faces marked on the side of the normal or not at all.
NefSphere loop(const SphereVector& normal, Mark circle, Mark inside) {
  auto planes = std::make_shared<PlaneTable>();
  const OrientedPlane plane = intern_circle(*planes, normal);
  SphereMap map;
  map.circle = {plane.plane()};
  map.arc_mark = {circle};
  map.origin = {kNone, kNone};
  map.next = {0, 1};
  map.face = {0, 1};
  map.face_mark = {0, 0};
  map.face_mark[plane.is_opposite() ? 1 : 0] = inside;
  return NefSphere::from_minimal(std::move(planes), std::move(map));
}

void require_on(const SphereVector& direction, const SphereVector& normal) {
  if (direction.is_zero() || normal.is_zero()) {
    throw Error(ErrorCode::BadArgument, "a direction must not be zero");
  }
  if (dot(direction, normal) != 0) {
    throw Error(ErrorCode::BadArgument, "an end of an arc does not lie on its circle");
  }
}

SphereVector normal_of_shorter(const SphereVector& from, const SphereVector& to) {
  SphereVector normal = cross(from, to);
  if (normal.is_zero()) {
    throw Error(ErrorCode::BadArgument,
                "the ends of an arc are the same or opposite: there is no shorter arc");
  }
  return normal;
}

// A chain of arcs, as a map.
class Chain {
 public:
  std::uint32_t add_point(const SphereVector& direction, Mark mark) {
    map_.direction.push_back(intern_direction(*planes_, direction));
    map_.point_mark.push_back(mark);
    map_.first_out.push_back(kNone);
    map_.point_face.push_back(kNone);
    return static_cast<std::uint32_t>(map_.point_count() - 1);
  }

  /// Returns the half-arc that runs from `from` counter-clockwise about the normal.
  std::uint32_t add_arc(std::uint32_t from, std::uint32_t to, const SphereVector& normal,
                        Mark mark) {
    const OrientedPlane plane = intern_circle(*planes_, normal);
    const std::uint32_t h =
        static_cast<std::uint32_t>(2 * map_.arc_count()) + (plane.is_opposite() ? 1U : 0U);
    map_.circle.push_back(plane.plane());
    map_.arc_mark.push_back(mark);
    for (auto* ids : {&map_.origin, &map_.next, &map_.face}) ids->resize(2 * map_.arc_count(), 0);
    map_.origin[h] = from;
    map_.origin[SphereMap::twin(h)] = to;
    map_.first_out[from] = h;
    if (map_.first_out[to] == kNone) map_.first_out[to] = SphereMap::twin(h);
    return h;
  }

  /// One half-arc after the other, and their twins back.
  void link(std::uint32_t h, std::uint32_t next) {
    map_.next[h] = next;
    map_.next[SphereMap::twin(next)] = SphereMap::twin(h);
  }

  SphereMap& map() { return map_; }
  NefSphere result() const { return NefSphere::from_map(*planes_, map_); }

 private:
  std::shared_ptr<PlaneTable> planes_ = std::make_shared<PlaneTable>();
  SphereMap map_;
};

/// Equal for equal directions: the first coordinate that is not 0 becomes 1 or -1.
SphereVector normal_form(const SphereVector& v) {
  if (v.is_zero()) throw Error(ErrorCode::BadArgument, "a direction must not be zero");
  const Rational scale = abs(v.x != 0 ? v.x : v.y != 0 ? v.y : v.z);
  return {Rational(v.x / scale), Rational(v.y / scale), Rational(v.z / scale)};
}

bool comes_before(const SphereVector& u, const SphereVector& v) {
  return std::tie(u.x, u.y, u.z) < std::tie(v.x, v.y, v.z);
}

}  // namespace

NefSphere NefSphere::half_sphere(const SphereVector& normal, Boundary boundary) try {
  return loop(normal, mark_if(boundary == Boundary::Closed), 1);
} catch (...) {
  rethrow_refused_memory();
}

NefSphere NefSphere::circle(const SphereVector& normal) try {
  return loop(normal, 1, 0);
} catch (...) {
  rethrow_refused_memory();
}

NefSphere NefSphere::convex(std::span<const SphereVector> normals, Boundary boundary) try {
  std::vector<NefSphere> sides;
  for (const SphereVector& n : normals) sides.push_back(half_sphere(n, boundary));
  Context context;
  return intersection_of(sides, context);
} catch (...) {
  rethrow_refused_memory();
}

NefSphere NefSphere::region(std::span<const SphereSide> sides, Boundary boundary) try {
  if (sides.empty()) return empty();
  const Mark border = mark_if(boundary == Boundary::Closed);
  const auto count = static_cast<std::uint32_t>(sides.size());
  Chain chain;
  for (std::uint32_t i = 0; i < count; ++i) {
    require_on(sides[i].from, sides[i].normal);
    require_on(sides[i].from, sides[i == 0 ? count - 1 : i - 1].normal);
    chain.add_point(sides[i].from, border);
  }
  std::vector<std::uint32_t> half;
  for (std::uint32_t i = 0; i < count; ++i) {
    half.push_back(chain.add_arc(i, i + 1 < count ? i + 1 : 0, sides[i].normal, border));
  }
  for (std::uint32_t i = 0; i < count; ++i) {
    chain.link(half[i], half[i + 1 < count ? i + 1 : 0]);
    chain.map().face[SphereMap::twin(half[i])] = 1;
  }
  chain.map().face_mark = {1, 0};
  return chain.result();
} catch (...) {
  rethrow_refused_memory();
}

NefSphere NefSphere::polygon(std::span<const SphereVector> corners, Boundary boundary) try {
  std::vector<SphereSide> sides;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const SphereVector& to = corners[i + 1 < corners.size() ? i + 1 : 0];
    sides.push_back({corners[i], normal_of_shorter(corners[i], to)});
  }
  return region(sides, boundary);
} catch (...) {
  rethrow_refused_memory();
}

NefSphere NefSphere::arc(const SphereVector& from, const SphereVector& to,
                         const SphereVector& normal, Boundary boundary) try {
  require_on(from, normal);
  require_on(to, normal);
  const Mark end = mark_if(boundary == Boundary::Closed);
  Chain chain;
  const std::uint32_t p = chain.add_point(from, end);
  if (is_same_direction(from, to)) {
    const std::uint32_t h = chain.add_arc(p, p, normal, 1);
    chain.link(h, h);
    chain.map().face[SphereMap::twin(h)] = 1;
    chain.map().face_mark = {0, 0};
    return chain.result();
  }
  const std::uint32_t q = chain.add_point(to, end);
  const std::uint32_t h = chain.add_arc(p, q, normal, 1);
  chain.map().next[h] = SphereMap::twin(h);
  chain.map().next[SphereMap::twin(h)] = h;
  chain.map().face_mark = {0};
  return chain.result();
} catch (...) {
  rethrow_refused_memory();
}

NefSphere NefSphere::arc(const SphereVector& from, const SphereVector& to, Boundary boundary) try {
  return arc(from, to, normal_of_shorter(from, to), boundary);
} catch (...) {
  rethrow_refused_memory();
}

NefSphere NefSphere::point(const SphereVector& direction) { return points({&direction, 1}); }

NefSphere NefSphere::points(std::span<const SphereVector> directions) try {
  std::vector<SphereVector> different;
  for (const SphereVector& v : directions) different.push_back(normal_form(v));
  std::sort(different.begin(), different.end(), comes_before);
  different.erase(std::unique(different.begin(), different.end()), different.end());
  auto planes = std::make_shared<PlaneTable>();
  SphereMap map;
  for (const SphereVector& v : different) {
    map.direction.push_back(intern_direction(*planes, v));
    map.point_mark.push_back(1);
    map.first_out.push_back(kNone);
    map.point_face.push_back(0);
  }
  map.face_mark = {0};
  return from_minimal(std::move(planes), std::move(map));
} catch (...) {
  rethrow_refused_memory();
}

}  // namespace plumb
