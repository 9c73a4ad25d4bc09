// Convex hulls by Quickhull with exact predicates.
//
// Invariants of HullBuilder: the living faces form a closed convex surface of triangles with
// positive areas; neighbour i of a face lies across the edge from corner i to the next corner; each
// point that is not in the hull so far is in the list of one face that it sees. A face sees a
// point, and the other way round, if the point lies strictly in front of its plane. A point of a
// removed face that is outside of the new hull sees a new face: if it sees a removed face and its
// remaining neighbour across the horizon, it also sees the new face between them, whose plane turns
// from one to the other about their common edge.
//
// A point in the plane of a face does not see it. The edge of the horizon between a face that is
// seen and one that is not does not lie on a line with the point, so new faces have areas.
//
// Tested by tests/model/hull_test.cpp.
#include "plumb/model/hull.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

#include "plumb/predicates/arithmetic/double_bits.h"
#include "plumb/predicates/error.h"
#include "plumb/predicates/input_predicates.h"
#include "plumb/predicates/point3_signs.h"
#include "plumb/predicates/point_table2.h"
#include "plumb/predicates/rational_predicates.h"
#include "plumb/predicates/rounding.h"

namespace plumb {
namespace {

constexpr std::uint32_t kNoIndex = 0xffffffff;
constexpr std::uint64_t kBytesPerHullPoint = 160;
// A point has three fractions of some limbs.
constexpr std::uint64_t kBytesPerExactHullPoint = 300;
constexpr std::uint32_t kStepsPerHullCheckpoint = 1024;

/// Checks the limits from time to time, and charges memory for a list that grows.
class HullSteps {
 public:
  explicit HullSteps(Context& context) : context_(context), memory_(context) {}
  /// Counts a step: one predicate, or one entry of a list that takes `bytes`.
  void step(std::uint64_t bytes = 0) {
    bytes_ += bytes;
    if (++steps_ % kStepsPerHullCheckpoint != 0) return;
    context_.checkpoint("convex hull", 0, 0);
    memory_.add(std::exchange(bytes_, 0), "a convex hull");
  }

 private:
  Context& context_;
  MemoryCharge memory_;
  std::uint32_t steps_ = 0;
  std::uint64_t bytes_ = 0;
};

/// Points of space with their predicates. The coordinates are doubles, or exact numbers with their
/// nearest doubles.
class HullPoints {
 public:
  HullPoints(std::span<const Point3> points, HullSteps& steps)
      : steps_(steps), near_(points.begin(), points.end()) {
    for (const Point3& p : near_) {
      if (is_finite(p.x) && is_finite(p.y) && is_finite(p.z)) continue;
      throw Error(ErrorCode::NotFinite, "the coordinates of a point must be finite");
    }
  }
  HullPoints(std::span<const RationalPoint3> points, HullSteps& steps) : steps_(steps) {
    bool are_doubles = true;
    for (const RationalPoint3& p : points) {
      steps_.step(sizeof(Point3) + kBytesPerExactHullPoint);
      near_.push_back({clamped_to_finite(nearest_double(p.x)),
                       clamped_to_finite(nearest_double(p.y)),
                       clamped_to_finite(nearest_double(p.z))});
      const Point3& q = near_.back();
      are_doubles = are_doubles && exact_rational(q.x) == p.x && exact_rational(q.y) == p.y &&
                    exact_rational(q.z) == p.z;
      largest_ = std::max({largest_, std::fabs(q.x), std::fabs(q.y), std::fabs(q.z)});
    }
    if (!are_doubles) exact_.assign(points.begin(), points.end());
  }

  std::uint32_t size() const { return static_cast<std::uint32_t>(near_.size()); }
  const Point3& near(std::uint32_t i) const { return near_[i]; }
  bool are_doubles() const { return exact_.empty(); }
  const RationalPoint3& exact(std::uint32_t i) const { return exact_[i]; }
  RationalPoint3 rational(std::uint32_t i) const {
    if (!are_doubles()) return exact_[i];
    const Point3& p = near_[i];
    return {exact_rational(p.x), exact_rational(p.y), exact_rational(p.z)};
  }

  /// Whether point p lies strictly in front of the plane of a, b, c.
  bool sees(std::uint32_t p, const std::array<std::uint32_t, 3>& face) const {
    return side(face, p) == Sign::Negative;
  }
  /// Returns Negative if p lies in front of the face.
  Sign side(const std::array<std::uint32_t, 3>& face, std::uint32_t p) const {
    const auto [a, b, c] = face;
    steps_.step();
    if (are_doubles()) return orient3d(near_[a], near_[b], near_[c], near_[p]);
    if (const Sign filtered = filtered_side(face, p); filtered != Sign::Zero) return filtered;
    return orient3d(exact_[a], exact_[b], exact_[c], exact_[p]);
  }
  bool are_equal(std::uint32_t i, std::uint32_t j) const {
    if (!are_doubles()) return exact_[i] == exact_[j];
    return near_[i].x == near_[j].x && near_[i].y == near_[j].y && near_[i].z == near_[j].z;
  }
  /// Returns a view of the points in which i, j, k are not collinear. The view is given by the axis
  /// that it drops.
  std::optional<std::size_t> view_of(std::uint32_t i, std::uint32_t j, std::uint32_t k) const {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const RationalPoint2 a = flat(i, axis), b = flat(j, axis), c = flat(k, axis);
      if (orient2d(a, b, c) != Sign::Zero) return axis;
    }
    return std::nullopt;
  }
  RationalPoint2 flat(std::uint32_t i, std::size_t axis) const {
    const RationalPoint3 p = rational(i);
    steps_.step();
    if (axis == 0) return {p.y, p.z};
    return axis == 1 ? RationalPoint2{p.z, p.x} : RationalPoint2{p.x, p.y};
  }

 private:
  /// Returns the sign of the determinant of the nearest doubles if its error cannot change it, else
  /// Zero. With all coordinates at most M, differences are at most 2 M and have an error of 4 u M,
  /// u = 2^-53, so that the determinant has an error of less than 528 u M^3.
  Sign filtered_side(const std::array<std::uint32_t, 3>& face, std::uint32_t p) const {
    if (!(largest_ > 0x1p-300 && largest_ < 0x1p300)) return Sign::Zero;
    const double value = volume(face, p);
    const double bound = 0x1p-43 * largest_ * largest_ * largest_;
    return value > bound ? Sign::Negative : value < -bound ? Sign::Positive : Sign::Zero;
  }

 public:
  /// Returns about six times the volume of the tetrahedron; positive in front of the face.
  double volume(const std::array<std::uint32_t, 3>& face, std::uint32_t p) const {
    const Point3& o = near_[face[0]];
    const auto from = [&o](const Point3& q) {
      return std::array<double, 3>{q.x - o.x, q.y - o.y, q.z - o.z};
    };
    const auto a = from(near_[face[1]]), b = from(near_[face[2]]), d = from(near_[p]);
    return d[0] * (a[1] * b[2] - a[2] * b[1]) + d[1] * (a[2] * b[0] - a[0] * b[2]) +
           d[2] * (a[0] * b[1] - a[1] * b[0]);
  }

 private:
  HullSteps& steps_;
  std::vector<Point3> near_;
  std::vector<RationalPoint3> exact_;  ///< Empty if all points are doubles.
  double largest_ = 0;                 ///< The greatest magnitude in near_.
};

/// At most four points that are affinely independent, and as many as possible.
using Simplex = std::vector<std::uint32_t>;

/// Returns the point with the greatest value. If `is_new` does not hold for it, returns another
/// point for which it holds, or nothing.
template <class Value, class IsNew>
std::optional<std::uint32_t> farthest(const HullPoints& points, const Value& value,
                                      const IsNew& is_new) {
  std::uint32_t best = 0;
  double most = -1;
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    const double v = value(i);
    if (v > most) {
      most = v;
      best = i;
    }
  }
  if (is_new(best)) return best;
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    if (is_new(i)) return i;
  }
  return std::nullopt;
}

double distance_between(const Point3& a, const Point3& b) {
  return std::hypot(a.x / 4 - b.x / 4, a.y / 4 - b.y / 4, a.z / 4 - b.z / 4);
}

Simplex simplex_of(const HullPoints& points) {
  if (points.size() == 0) return {};
  Simplex simplex{0};
  const auto second = farthest(
      points, [&](std::uint32_t i) { return distance_between(points.near(i), points.near(0)); },
      [&](std::uint32_t i) { return !points.are_equal(i, 0); });
  if (!second) return simplex;
  simplex.push_back(*second);
  const auto third = farthest(
      points,
      [&](std::uint32_t i) {
        return std::min(distance_between(points.near(i), points.near(0)),
                        distance_between(points.near(i), points.near(*second)));
      },
      [&](std::uint32_t i) { return points.view_of(0, *second, i).has_value(); });
  if (!third) return simplex;
  simplex.push_back(*third);
  const std::array<std::uint32_t, 3> face{0, *second, *third};
  const auto fourth = farthest(
      points, [&](std::uint32_t i) { return std::fabs(points.volume(face, i)); },
      [&](std::uint32_t i) { return points.side(face, i) != Sign::Zero; });
  if (fourth) simplex.push_back(*fourth);
  return simplex;
}

/// The hull of points that do not lie in a plane.
class HullBuilder {
 public:
  HullBuilder(const HullPoints& points, const Simplex& simplex, Context& context)
      : points_(points),
        faces_made_(context),
        memory_(context),
        next_(points.size(), kNoIndex),
        face_from_(points.size(), kNoIndex) {
    memory_.add(kBytesPerHullPoint * points.size(), "a convex hull");
    start(simplex);
  }

  /// Returns the corners of the faces.
  std::vector<std::array<std::uint32_t, 3>> triangles() {
    for (std::uint32_t f = 0; f < faces_.size(); ++f) {
      if (faces_[f].is_alive && faces_[f].first != kNoIndex) insert(f);
    }
    std::vector<std::array<std::uint32_t, 3>> result;
    for (const Face& face : faces_) {
      if (face.is_alive) result.push_back(face.corner);
    }
    return result;
  }

 private:
  struct Face {
    std::array<std::uint32_t, 3> corner;
    std::array<std::uint32_t, 3> neighbour;
    std::uint32_t first = kNoIndex;     ///< First of the points that see the face.
    std::uint32_t farthest = kNoIndex;  ///< The farthest of these points, by doubles.
    double distance = 0;                ///< Of this point, times the area of the face.
    bool is_alive = true;
    bool is_seen = false;
  };
  /// An edge of the horizon, directed as in the removed face.
  struct HorizonEdge {
    std::uint32_t from, to;
    std::uint32_t beyond;  ///< The face that stays.
  };

  void start(const Simplex& simplex) {
    std::array<std::uint32_t, 4> v{simplex[0], simplex[1], simplex[2], simplex[3]};
    if (points_.side({v[0], v[1], v[2]}, v[3]) == Sign::Negative) std::swap(v[0], v[1]);
    // Point 3 lies behind the face 0 1 2.
    add_face({v[0], v[1], v[2]}, {1, 2, 3});
    add_face({v[1], v[0], v[3]}, {0, 3, 2});
    add_face({v[2], v[1], v[3]}, {0, 1, 3});
    add_face({v[0], v[2], v[3]}, {0, 2, 1});
    for (std::uint32_t p = 0; p < points_.size(); ++p) {
      if (std::find(v.begin(), v.end(), p) == v.end()) assign(p, 0);
    }
  }

  void add_face(const std::array<std::uint32_t, 3>& corner,
                const std::array<std::uint32_t, 3>& neighbour) {
    faces_made_.step(2 * sizeof(Face));  // The memory of removed faces is not freed.
    Face face;
    face.corner = corner;
    face.neighbour = neighbour;
    faces_.push_back(face);
  }

  /// Puts a point into the list of one of the faces from `first_face` on that it sees, if any.
  void assign(std::uint32_t p, std::uint32_t first_face) {
    for (std::uint32_t f = first_face; f < faces_.size(); ++f) {
      Face& face = faces_[f];
      if (!points_.sees(p, face.corner)) continue;
      next_[p] = face.first;
      face.first = p;
      const double distance = points_.volume(face.corner, p);
      if (face.farthest == kNoIndex || distance > face.distance) {
        face.farthest = p;
        face.distance = distance;
      }
      return;
    }
  }

  void insert(std::uint32_t f) {
    const std::uint32_t p = faces_[f].farthest;
    find_horizon(f, p);
    const auto first_new = static_cast<std::uint32_t>(faces_.size());
    for (const HorizonEdge& e : horizon_) add_cone_face(e, p);
    for (std::uint32_t g = first_new; g < faces_.size(); ++g) link_cone_face(g);
    for (const std::uint32_t g : seen_) {
      for (std::uint32_t q = faces_[g].first; q != kNoIndex;) {
        const std::uint32_t following = next_[q];
        if (q != p) assign(q, first_new);
        q = following;
      }
    }
  }

  /// Fills seen_ with the faces that p sees, and horizon_ with the edges around them.
  void find_horizon(std::uint32_t f, std::uint32_t p) {
    seen_.assign(1, f);
    horizon_.clear();
    faces_[f].is_seen = true;
    for (std::size_t i = 0; i < seen_.size(); ++i) {
      const Face face = faces_[seen_[i]];
      for (std::size_t k = 0; k < 3; ++k) {
        Face& other = faces_[face.neighbour[k]];
        if (other.is_seen) continue;
        if (points_.sees(p, other.corner)) {
          other.is_seen = true;
          seen_.push_back(face.neighbour[k]);
        } else {
          horizon_.push_back({face.corner[k], face.corner[(k + 1) % 3], face.neighbour[k]});
        }
      }
    }
    for (const std::uint32_t g : seen_) faces_[g].is_alive = false;
  }

  void add_cone_face(const HorizonEdge& e, std::uint32_t p) {
    const auto f = static_cast<std::uint32_t>(faces_.size());
    add_face({e.from, e.to, p}, {e.beyond, kNoIndex, kNoIndex});
    face_from_[e.from] = f;
    Face& beyond = faces_[e.beyond];
    for (std::size_t k = 0; k < 3; ++k) {
      if (beyond.corner[k] == e.to && beyond.corner[(k + 1) % 3] == e.from) beyond.neighbour[k] = f;
    }
  }
  void link_cone_face(std::uint32_t f) {
    const std::uint32_t following = face_from_[faces_[f].corner[1]];
    faces_[f].neighbour[1] = following;
    faces_[following].neighbour[2] = f;
  }

  const HullPoints& points_;
  HullSteps faces_made_;
  MemoryCharge memory_;
  std::vector<Face> faces_;
  std::vector<std::uint32_t> next_;       ///< The next point in the list of a face.
  std::vector<std::uint32_t> face_from_;  ///< The new face whose edge on the horizon begins here.
  std::vector<std::uint32_t> seen_;
  std::vector<HorizonEdge> horizon_;
};

PolygonMesh mesh_of(const HullPoints& points,
                    const std::vector<std::array<std::uint32_t, 3>>& triangles) {
  PolygonMesh mesh;
  std::vector<std::uint32_t> number(points.size(), kNoIndex);
  for (std::array<std::uint32_t, 3> triangle : triangles) {
    for (std::uint32_t& corner : triangle) {
      if (number[corner] == kNoIndex) {
        number[corner] = static_cast<std::uint32_t>(mesh.points.size());
        if (!points.are_doubles()) mesh.exact.emplace_back(number[corner], points.exact(corner));
        mesh.points.push_back(points.near(corner));
      }
      corner = number[corner];
    }
    mesh.add_face(triangle);
  }
  return mesh;
}

/// Returns the corners of the convex hull of points of the plane, counter-clockwise: none, one, the
/// two ends of a segment, or more. Points on edges are left out. (A. M. Andrew, Another efficient
/// algorithm for convex hulls in two dimensions, Information Processing Letters 9, 1979.)
std::vector<std::uint32_t> corners_of_hull(const PointTable2& points, Context& context) {
  HullSteps steps(context);
  MemoryCharge memory(context);
  memory.add(2 * sizeof(std::uint32_t) * points.size(), "a convex hull");
  std::vector<std::uint32_t> order(points.size());
  std::iota(order.begin(), order.end(), 0U);
  std::sort(order.begin(), order.end(), [&](std::uint32_t i, std::uint32_t j) {
    steps.step();
    return compare_xy(points, i, j) == Sign::Negative;
  });
  order.erase(std::unique(order.begin(), order.end(),
                          [&](std::uint32_t i, std::uint32_t j) {
                            return compare_xy(points, i, j) == Sign::Zero;
                          }),
              order.end());
  if (order.size() < 3) return order;
  std::vector<std::uint32_t> hull;
  const auto extend = [&](std::uint32_t p, std::size_t fixed) {
    while (hull.size() >= fixed + 2 &&
           orient2d(points, hull[hull.size() - 2], hull.back(), p) != Sign::Positive) {
      steps.step();
      hull.pop_back();
    }
    steps.step();
    hull.push_back(p);
  };
  for (const std::uint32_t p : order) extend(p, 0);
  const std::size_t lower = hull.size() - 1;
  for (auto p = std::next(order.rbegin()); p != order.rend(); ++p) extend(*p, lower);
  hull.pop_back();  // The first point is listed again at the end.
  return hull;
}

Nef2 hull_of_table(const PointTable2& points, Context& context) {
  const std::vector<std::uint32_t> corners = corners_of_hull(points, context);
  const std::vector<std::uint32_t> begin{0, static_cast<std::uint32_t>(corners.size())};
  return Nef2::polygons(points, corners, begin, WindingRule::NonZero, Boundary::Closed, context);
}

/// Returns the hull of points that are coplanar but not collinear.
Nef3 flat_hull(const HullPoints& points, std::size_t axis, Context& context) {
  PointTable2 table;
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    const RationalPoint2 p = points.flat(i, axis);
    table.push_back(p.x, p.y);
  }
  std::vector<RationalPoint3> corners;
  for (const std::uint32_t i : corners_of_hull(table, context))
    corners.push_back(points.rational(i));
  return Nef3::facet(corners, context);
}

/// Returns the hull of collinear points.
Nef3 straight_hull(const HullPoints& points) {
  const auto is_less = [](const RationalPoint3& a, const RationalPoint3& b) {
    if (a.x != b.x) return a.x < b.x;
    return a.y != b.y ? a.y < b.y : a.z < b.z;
  };
  RationalPoint3 low = points.rational(0), high = low;
  for (std::uint32_t i = 1; i < points.size(); ++i) {
    const RationalPoint3 p = points.rational(i);
    if (is_less(p, low)) low = p;
    if (is_less(high, p)) high = p;
  }
  return Nef3::segment(low, high);
}

Nef3 hull_of(const HullPoints& points, Context& context) {
  const Simplex simplex = simplex_of(points);
  switch (simplex.size()) {
    case 0:
      return Nef3::empty();
    case 1:
      return Nef3::point(points.rational(0));
    case 2:
      return straight_hull(points);
    case 3:
      return flat_hull(points, *points.view_of(simplex[0], simplex[1], simplex[2]), context);
    default:
      break;
  }
  const PolygonMesh mesh = mesh_of(points, HullBuilder(points, simplex, context).triangles());
  return Nef3::from_mesh(mesh, {.rule = WindingRule::Positive}, context);
}

template <class Set>
void require_bounded_sets(std::span<const Set> sets) {
  for (const Set& set : sets) {
    if (set.is_bounded()) continue;
    throw Error(ErrorCode::BadArgument, "the convex hull of an unbounded set is not supported");
  }
}

}  // namespace

Nef3 convex_hull(std::span<const Point3> points, Context& context) {
  HullSteps steps(context);
  return hull_of(HullPoints(points, steps), context);
}

Nef3 convex_hull(std::span<const RationalPoint3> points, Context& context) {
  HullSteps steps(context);
  return hull_of(HullPoints(points, steps), context);
}

Nef3 convex_hull(std::span<const Nef3> sets, Context& context) {
  require_bounded_sets(sets);
  HullSteps steps(context);
  std::vector<RationalPoint3> points;
  for (const Nef3& set : sets) {
    const SpaceComplex& c = set.complex();
    for (const SpacePoint p : c.vertex_point) {
      steps.step(kBytesPerExactHullPoint);
      points.push_back(exact(c.points(), p));
    }
  }
  return convex_hull(points, context);
}

PolygonMesh hull_mesh(std::span<const Point3> points, Context& context) {
  HullSteps steps(context);
  const HullPoints table(points, steps);
  const Simplex simplex = simplex_of(table);
  if (simplex.size() < 4) return {};
  return mesh_of(table, HullBuilder(table, simplex, context).triangles());
}

Nef2 convex_hull(std::span<const Point2> points, Context& context) {
  HullSteps steps(context);
  PointTable2 table;
  for (const Point2& p : points) {
    steps.step(sizeof(Point2));
    if (!is_finite(p.x) || !is_finite(p.y)) {
      throw Error(ErrorCode::NotFinite, "the coordinates of a point must be finite");
    }
    table.push_back(p);
  }
  return hull_of_table(table, context);
}

Nef2 convex_hull(std::span<const RationalPoint2> points, Context& context) {
  HullSteps steps(context);
  PointTable2 table;
  for (const RationalPoint2& p : points) {
    steps.step(kBytesPerExactHullPoint);
    table.push_back(p.x, p.y);
  }
  return hull_of_table(table, context);
}

Nef2 convex_hull(std::span<const Nef2> sets, Context& context) {
  require_bounded_sets(sets);
  HullSteps steps(context);
  PointTable2 table;
  for (const Nef2& set : sets) {
    const PlaneComplex& c = set.complex();
    for (const std::uint32_t p : c.vertex_point) {
      steps.step(kBytesPerExactHullPoint);
      const RationalPoint2 at = exact(c.points, p);
      table.push_back(at.x, at.y);
    }
  }
  return hull_of_table(table, context);
}

}  // namespace plumb
