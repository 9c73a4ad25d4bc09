// Directions as vectors and as pairs of planes, and basic sets: half-spheres, circles, regions,
// arcs and points.
//
// A vector v becomes the pair of planes through the centre with the normals v x e1 and v x e2, for
// two axes e1 and e2 such that v is not orthogonal to the third. Chains of arcs are built as maps
// with their links, and audited by NefSphere::from_complex(), which refuses chains that meet
// themselves.
//
// Tested by tests/sphere/nef_sphere_test.cpp.

#include "plumb/sphere/set/sphere_vectors.h"

#include <algorithm>
#include <array>
#include <tuple>
#include <unordered_map>
#include <utility>

#include "plumb/predicates/arithmetic/double_bits.h"
#include "plumb/predicates/error.h"
#include "plumb/sphere/nef_sphere.h"

namespace plumb {
namespace {

void require_nonzero(const SphereVector& v) {
  if (v.is_zero()) throw Error(ErrorCode::BadArgument, "a direction must not be zero");
}

/// Returns the first three numbers of a row, without a common factor.
SphereVector vector_of(const IntegerRow& row) {
  const IntegerRow r = primitive(row);
  return {Rational(r[0]), Rational(r[1]), Rational(r[2])};
}

/// Moves planes of one table to the centre, into a new table.
class Centring {
 public:
  explicit Centring(const PlaneTable& planes) : planes_(planes) {}

  PlaneId operator()(PlaneId p) {
    const auto [at, is_new] = centred_.try_emplace(p);
    if (is_new) {
      const IntegerRow row = planes_.coefficients(p);
      at->second =
          table_->intern(Rational(row[0]), Rational(row[1]), Rational(row[2]), Rational(0)).plane();
    }
    return at->second;
  }
  std::shared_ptr<const PlaneTable> table() const { return table_; }

 private:
  const PlaneTable& planes_;
  std::unordered_map<PlaneId, PlaneId> centred_;
  std::shared_ptr<PlaneTable> table_ = std::make_shared<PlaneTable>();
};

}  // namespace

SphereVector::SphereVector(double a, double b, double c) {
  if (!is_finite(a) || !is_finite(b) || !is_finite(c)) {
    throw Error(ErrorCode::NotFinite, "the coordinates of a direction must be finite numbers");
  }
  x = a;
  y = b;
  z = c;
}

Rational dot(const SphereVector& u, const SphereVector& v) {
  return u.x * v.x + u.y * v.y + u.z * v.z;
}

SphereVector cross(const SphereVector& u, const SphereVector& v) {
  return {Rational(u.y * v.z - u.z * v.y), Rational(u.z * v.x - u.x * v.z),
          Rational(u.x * v.y - u.y * v.x)};
}

bool is_same_direction(const SphereVector& u, const SphereVector& v) {
  return cross(u, v).is_zero() && dot(u, v) > 0;
}

OrientedPlane intern_circle(PlaneTable& planes, const SphereVector& normal) {
  require_nonzero(normal);
  return planes.intern(normal.x, normal.y, normal.z, Rational(0));
}

/// Since (v x e1) x (v x e2) = v (v . e3), the two planes define v or -v if v . e3 is not zero. The
/// sign of v . e3 and the orientations of the two planes decide which.
SphereDirection intern_direction(PlaneTable& planes, const SphereVector& v) {
  require_nonzero(v);
  const std::array<SphereVector, 3> unit{SphereVector(1, 0, 0), SphereVector(0, 1, 0),
                                         SphereVector(0, 0, 1)};
  std::size_t axis = 0;
  while (dot(v, unit[axis]) == 0) ++axis;
  const OrientedPlane p = intern_circle(planes, cross(v, unit[(axis + 1) % 3]));
  const OrientedPlane q = intern_circle(planes, cross(v, unit[(axis + 2) % 3]));
  const SphereDirection u{p.plane(), q.plane()};
  const bool is_opposite = (dot(v, unit[axis]) < 0) != (p.is_opposite() != q.is_opposite());
  return is_opposite ? u.opposite() : u;
}

SphereVector exact_normal(const PlaneTable& planes, PlaneId circle) {
  IntegerRow row = planes.coefficients(circle);
  row[3] = 0;
  return vector_of(row);
}

SphereVector exact_direction(const PlaneTable& planes, SphereDirection u) {
  const IntegerRow p = planes.coefficients(u.p);
  const IntegerRow q = planes.coefficients(u.q);
  return vector_of({Integer(p[1] * q[2] - p[2] * q[1]), Integer(p[2] * q[0] - p[0] * q[2]),
                    Integer(p[0] * q[1] - p[1] * q[0]), Integer(0)});
}

std::shared_ptr<const PlaneTable> centred(const PlaneTable& planes, SphereMap& map) {
  Centring centring(planes);
  for (PlaneId& c : map.circle) c = centring(c);
  for (SphereDirection& u : map.direction) u = {centring(u.p), centring(u.q)};
  return centring.table();
}

// NefSphere: basic sets.

namespace {

Mark mark_if(bool is_marked) { return is_marked ? 1 : 0; }

/// Returns the set of one circle, with the given marks of the circle and of the face on the side of
/// the normal. The other face is not marked.
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
  return NefSphere::from_minimal_unchecked({std::move(planes), std::move(map)});
}

void require_on(const SphereVector& direction, const SphereVector& normal) {
  if (direction.is_zero() || normal.is_zero()) {
    throw Error(ErrorCode::BadArgument, "a direction must not be zero");
  }
  if (dot(direction, normal) != 0) {
    throw Error(ErrorCode::BadArgument, "an end of an arc does not lie on its circle");
  }
}

/// Returns the normal about which the shorter arc is counter-clockwise.
SphereVector normal_of_shorter(const SphereVector& from, const SphereVector& to) {
  SphereVector normal = cross(from, to);
  if (normal.is_zero()) {
    throw Error(ErrorCode::BadArgument,
                "the ends of an arc are the same or opposite: there is no shorter arc");
  }
  return normal;
}

/// A chain of arcs, as a map under construction.
class Chain {
 public:
  std::uint32_t add_point(const SphereVector& direction, Mark mark) {
    map_.direction.push_back(intern_direction(*planes_, direction));
    map_.point_mark.push_back(mark);
    map_.first_out.push_back(kNone);
    map_.point_face.push_back(kNone);
    return static_cast<std::uint32_t>(map_.point_count() - 1);
  }

  /// Returns the half-arc that leads counter-clockwise about the normal, beginning at `from`.
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

  /// Links one half-arc to the next, and their twins in the other direction.
  void link(std::uint32_t h, std::uint32_t next) {
    map_.next[h] = next;
    map_.next[SphereMap::twin(next)] = SphereMap::twin(h);
  }

  SphereMap& map() { return map_; }
  NefSphere result() const { return NefSphere::from_complex({planes_, map_}); }

 private:
  std::shared_ptr<PlaneTable> planes_ = std::make_shared<PlaneTable>();
  SphereMap map_;
};

/// Returns a vector of the same direction whose first coordinate other than 0 is 1 or -1, so that
/// equal directions have equal vectors.
SphereVector normal_form(const SphereVector& v) {
  if (v.is_zero()) throw Error(ErrorCode::BadArgument, "a direction must not be zero");
  const Rational scale = abs(v.x != 0 ? v.x : v.y != 0 ? v.y : v.z);
  return {Rational(v.x / scale), Rational(v.y / scale), Rational(v.z / scale)};
}

bool comes_before(const SphereVector& u, const SphereVector& v) {
  return std::tie(u.x, u.y, u.z) < std::tie(v.x, v.y, v.z);
}

}  // namespace

NefSphere NefSphere::half_sphere(const SphereVector& normal, Boundary boundary) {
  return loop(normal, mark_if(boundary == Boundary::Closed), 1);
}

NefSphere NefSphere::circle(const SphereVector& normal) { return loop(normal, 1, 0); }

NefSphere NefSphere::convex(std::span<const SphereVector> normals, Boundary boundary,
                            Context& context) {
  std::vector<NefSphere> sides;
  for (const SphereVector& n : normals) sides.push_back(half_sphere(n, boundary));
  return intersection_of(sides, context);
}

/// The chain bounds face 0, which is marked, on the left of its half-arcs, and face 1 on their
/// right.
NefSphere NefSphere::region(std::span<const SphereSide> sides, Boundary boundary) {
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
}

NefSphere NefSphere::polygon(std::span<const SphereVector> corners, Boundary boundary) {
  std::vector<SphereSide> sides;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const SphereVector& to = corners[i + 1 < corners.size() ? i + 1 : 0];
    sides.push_back({corners[i], normal_of_shorter(corners[i], to)});
  }
  return region(sides, boundary);
}

/// An arc from a point to itself is a whole circle with two faces. Any other arc has one face, and
/// next leads from each half-arc to its twin.
NefSphere NefSphere::arc(const SphereVector& from, const SphereVector& to,
                         const SphereVector& normal, Boundary boundary) {
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
}

NefSphere NefSphere::arc(const SphereVector& from, const SphereVector& to, Boundary boundary) {
  return arc(from, to, normal_of_shorter(from, to), boundary);
}

NefSphere NefSphere::point(const SphereVector& direction) { return points({&direction, 1}); }

NefSphere NefSphere::points(std::span<const SphereVector> directions, Context& context) {
  context.checkpoint("points", 0, 0);
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
  return from_minimal_unchecked({std::move(planes), std::move(map)});
}

}  // namespace plumb
