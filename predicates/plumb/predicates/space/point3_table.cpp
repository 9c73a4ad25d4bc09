// The table of the points of space: each point is kept as its definition and a box of doubles
// around it, from which later questions are filtered.
//
// A new point gets its box from the first of these that gives one no wider than 2^-34 of its
// coordinates: doubles with error bounds (fast_box()); sums of two doubles, which also give the
// nearest doubles (rounded_on_line()); exact integers, the narrowest that hold the planes, which
// also find out that the planes have no common point (exact_box()). A point P0 + u R that depends
// on the frame gets a box around its direction u instead, with an infinite radius.
//
// Error bounds. eps = 2^-52; e and f are the errors of plane rows (PlaneRow), |n_i| <= 1. A prime
// marks what was computed. docs/design/numbers.md (Boxes of constructed points) proves the bounds.
//
//   three planes  w = det3 is off by at most ew = 6 sum e (plane_signs.cpp).
//                 x_i = -sum d m_i with minors m_i, |m_i| <= 2, which are off by at most
//                 e_a + e_b + 6 eps. So x_i is off by at most ex = 4 (sum e)(sum |d|) + 4 sum f:
//                 twice what is needed, which pays for the roundings.
//   line x plane  t = s(a) / (s(a) - s(b)), where s is off by the bound of the side of an input
//                 point (point3_signs.h).
//   quotients     |x/w - x'/w'| <= (ex + |x'/w'| ew) / (|w'| - ew), which for ew <= |w'| / 2 is at
//                 most 2 (ex + |x'/w'| ew) / |w'|; the division adds 2 eps |x'/w'|.
//
// The direction u of a point of three planes is the common point of the planes' rows in units of R
// (filter_stages.h), so the first and the last bound hold for it as they stand. The direction of a
// point on a line from a to b is d (a - b) / n.(b - a), where n is an axis: quotients of two
// differences, each of which is off by at most 3 eps of itself.
//
// Tested by tests/predicates/point3_signs_test.cpp and tests/predicates/frame_test.cpp.

#include "plumb/predicates/space/point3_table.h"

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <limits>
#include <type_traits>

#include "plumb/predicates/space/filter_stages.h"
#include "plumb/predicates/space/point3_exact.h"

namespace plumb {

namespace {

// The width is relative to the coordinates. If a box is wider, a new box is computed exactly.
constexpr double kTooWide = 0x1p-34;
static_assert(kTooWide <= kDirectionError);
constexpr double kRounding = 0x1p-48;
constexpr double kTiny = 0x1p-960;
constexpr PointBox kEverywhere = {{}, std::numeric_limits<double>::infinity()};

double max_abs(const std::array<double, 3>& v) {
  return std::max({std::fabs(v[0]), std::fabs(v[1]), std::fabs(v[2])});
}

/// Whether the box is narrow enough to be stored. Returns false for NaNs.
bool is_good(const PointBox& box) {
  return box.radius <= kTooWide * max_abs(box.mid) && box.radius < 0x1p900;
}

/// Returns the box of a point that depends on the frame, from a box around its direction.
PointBox far_from(const PointBox& direction) {
  if (!is_good(direction)) return kEverywhere;
  return {direction.mid, std::numeric_limits<double>::infinity()};
}

using Row = std::array<double, 3>;

Row cross(const Row& a, const Row& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

double sum(float a, float b, float c) {
  return static_cast<double>(a) + static_cast<double>(b) + static_cast<double>(c);
}

/// Returns a box around the common point of three planes. The box is not good unless the planes
/// certainly have exactly one common point.
PointBox fast_box(const PlaneRow& p, const PlaneRow& q, const PlaneRow& r) {
  const Row qr = cross(q.n, r.n), rp = cross(r.n, p.n), pq = cross(p.n, q.n);
  const double w = pq[0] * r.n[0] + pq[1] * r.n[1] + pq[2] * r.n[2];
  const double e = sum(p.normal_error, q.normal_error, r.normal_error), ew = 6 * e;
  PointBox box = kEverywhere;
  if (!(ew <= std::fabs(w) / 2)) return box;
  const double inverse = -1 / w;
  for (std::size_t i = 0; i < 3; ++i) {
    box.mid[i] = (p.d * qr[i] + q.d * rp[i] + r.d * pq[i]) * inverse;
  }
  const double offsets = std::fabs(p.d) + std::fabs(q.d) + std::fabs(r.d);
  const double ex = 4 * e * offsets + 4 * sum(p.offset_error, q.offset_error, r.offset_error);
  const double largest = max_abs(box.mid);
  box.radius =
      2 * (ex + largest * ew) * std::fabs(inverse) * (1 + kRounding) + kRounding * largest + kTiny;
  return box;
}

/// The value s(a) = n.a + d with a bound of its error.
struct Value {
  double value;
  double error;
};

Value value_at(const PlaneRow& plane, const Point3& a) {
  const double size = std::fabs(a.x) + std::fabs(a.y) + std::fabs(a.z);
  return {plane.n[0] * a.x + plane.n[1] * a.y + plane.n[2] * a.z + plane.d,
          static_cast<double>(plane.normal_error) * size + static_cast<double>(plane.offset_error)};
}

/// Returns a box around the point where the line from a to b cuts the plane. The box is not good
/// unless the line certainly cuts the plane. The test of ew also bounds t: ew is at least 2^-48
/// (|a|_1 + |d|), up to roundings, and |s(a)| is at most |a|_1 + |d|, so that |t| < 2^48. If
/// a + t (b - a) overflows all the same, the box is infinite or NaN, which is_good() refuses.
PointBox fast_box(const Point3& a, const Point3& b, const PlaneRow& plane) {
  const Value at_a = value_at(plane, a), at_b = value_at(plane, b);
  const double w = at_a.value - at_b.value;
  const double ew = at_a.error + at_b.error + kRounding * std::fabs(w);
  PointBox box = kEverywhere;
  if (!(ew <= std::fabs(w) / 2)) return box;
  const double t = at_a.value / w;
  const double et = 2 * (at_a.error + std::fabs(t) * ew) / std::fabs(w) + kRounding * std::fabs(t) +
                    0x1p-1000;  // The last term covers a value of t that was flushed to zero.
  const std::array<double, 3> step = {b.x - a.x, b.y - a.y, b.z - a.z};
  box.mid = {a.x + t * step[0], a.y + t * step[1], a.z + t * step[2]};
  const double size = max_abs({a.x, a.y, a.z}) + std::fabs(t) * max_abs(step);
  box.radius = et * max_abs(step) * (1 + kRounding) + kRounding * size + kTiny;
  return box;
}

/// Returns a box around the direction u of the point where the line from a to b cuts a plane of the
/// cube. The box is not good if a difference may have lost bits because of an underflow or an
/// overflow.
PointBox fast_direction(const Point3& a, const Point3& b, const PlaneRow& far) {
  const std::array<double, 3> step = {b.x - a.x, b.y - a.y, b.z - a.z};
  const double climb = far.n[0] * step[0] + far.n[1] * step[1] + far.n[2] * step[2];
  if (std::isinf(far.offset_error) || !(std::fabs(climb) >= 0x1p-900)) return kEverywhere;
  PointBox box{{-far.d * step[0] / climb, -far.d * step[1] / climb, -far.d * step[2] / climb}, 0};
  box.radius = kRounding * max_abs(box.mid);
  return box;
}

/// Returns a box around the direction u of a point that depends on the frame. The box is good only
/// if the signs of all coordinates are certain, as PointBox requires.
PointBox fast_direction(const PlaneTable& planes, const PointSource& source) {
  const auto row = [&](std::size_t i) { return far_row(planes, source.plane(i)); };
  PointBox box = source.is_line() ? fast_direction(planes.point(source.end(0)),
                                                   planes.point(source.end(1)), row(0))
                                  : fast_box(row(0), row(1), row(2));
  for (const double u : box.mid) {
    if (!(std::fabs(u) > box.radius)) box.radius = kEverywhere.radius;
  }
  return box;
}

/// Returns a box around x 2^scale / w. Both parts are off by less than 2^-51 of themselves, and the
/// division by 2^-52; the largest coordinate's 2^-50 covers them. Coordinates below 2^-900 become
/// 0, for which 2^-890 is added unless the point is the origin exactly.
template <class X, class W>
PointBox box_of(const exact3::Homogeneous<X, W>& p) {
  const Scaled w = scaled(p.w);
  PointBox box{};
  for (std::size_t i = 0; i < 3; ++i) {
    const Scaled x = scaled(p.x[i]);
    const std::int64_t exponent = std::int64_t{x.exponent} - w.exponent + p.scale;
    if (x.mantissa == 0 || exponent < -900) continue;
    if (exponent > 900) return kEverywhere;
    box.mid[i] = x.mantissa / w.mantissa * power_of_two(static_cast<int>(exponent));
  }
  box.radius = 0x1p-50 * max_abs(box.mid);
  const bool is_origin = exact3::sign_of(p.x[0]) == Sign::Zero &&
                         exact3::sign_of(p.x[1]) == Sign::Zero &&
                         exact3::sign_of(p.x[2]) == Sign::Zero;
  if (!is_origin) box.radius += 0x1p-890;
  return box;
}

/// Whether each coordinate of the box is zero if and only if the coordinate of the point is zero.
/// Coordinates below 2^-900 became 0 in box_of().
template <class X, class W>
bool has_exact_signs(const exact3::Homogeneous<X, W>& p, const PointBox& box) {
  for (std::size_t i = 0; i < 3; ++i) {
    if ((exact3::sign_of(p.x[i]) == Sign::Zero) != (box.mid[i] == 0)) return false;
  }
  return true;
}

PointBox box_around(const RoundedPoint3& nearest) {
  PointBox box{{nearest.at.x, nearest.at.y, nearest.at.z}, 0};
  // The distance is at most half a unit in the last place.
  if (!nearest.is_exact) box.radius = 0x1p-53 * max_abs(box.mid);
  return box;
}

/// A box that was computed with exact integers. It is around a constructed point, or around the
/// direction u if the point depends on the frame.
struct ExactBox {
  Sign w;                   ///< Zero if the point does not exist; it then has no box.
  PointBox box;             ///< Around the point or its direction.
  bool is_nearest = false;  ///< Whether the middle is the nearest doubles.
};

/// Sets the box of an exact point. If the numbers have a fixed width, and every coordinate is known
/// to be rounded correctly, the box is around the nearest doubles. Otherwise, it is around the
/// quotients of leading bits.
template <class Plane>
void set_box(const exact3::PointOf<Plane>& point, const PlaneTable& planes,
             const PointSource& source, bool is_framed, ExactBox& result) {
  if constexpr (!std::is_same_v<Plane, exact3::BigPlane>) {
    if (!is_framed) {
      const auto nearest = exact3::rounded_fixed(point, planes, source);
      if (nearest) result.box = box_around(*nearest);
      result.is_nearest = nearest && is_good(result.box);
      if (result.is_nearest) return;
    }
  }
  result.box = box_of(point);
  if (is_framed && !has_exact_signs(point, result.box)) result.box = kEverywhere;
}

/// Makes the box in the narrowest integers. A point of the frame exists if its Infinite part
/// exists, because w has no R, and both parts share it.
ExactBox exact_box(const Point3Table& points, const PointSource& source) {
  const exact3::PointOperand operand = exact3::operand(points, source);
  const bool is_framed = exact3::has_frame(operand);
  const auto part = is_framed ? exact3::Part::Infinite : exact3::Part::Finite;
  ExactBox result;
  result.w = exact3::point_ladder(
      operand.width,
      [&]<class Plane>() {
        exact3::PointOf<Plane> point;
        if (!exact3::load_point<Plane>(operand, part, point)) return FilteredSign::Unsure;
        const Sign sign = exact3::sign_of(point.w);
        if (sign != Sign::Zero) set_box<Plane>(point, points.planes(), source, is_framed, result);
        return filtered(sign);
      },
      [](Rung) {});
  return result;
}

}  // namespace

void Point3Table::reserve(std::size_t points) {
  boxes_.reserve(points);
  sources_.reserve(points);
  is_nearest_.reserve(points);
}

/// Tries the methods in the order of their cost. Only exact_box() can detect that there is no
/// point.
SpacePoint Point3Table::add_new(const PointSource& source, const PointBox& fast) {
  if (is_good(fast)) return add(source, fast);
  const bool is_framed = depends_on_frame(source);
  if (is_framed) {
    const PointBox direction = fast_direction(*planes_, source);
    if (is_good(direction)) return add(source, far_from(direction));
  }
  const auto nearest = exact3::rounded_on_line(*planes_, source);
  if (nearest) return add(source, box_around(*nearest), true);
  const ExactBox found = exact_box(*this, source);
  if (found.w == Sign::Zero) return {};
  return add(source, is_framed ? far_from(found.box) : found.box, found.is_nearest);
}

SpacePoint Point3Table::add(const PointSource& source, const PointBox& box, bool is_nearest) {
  boxes_.push_back(box);
  sources_.push_back(source);
  is_nearest_.push_back(is_nearest ? 1 : 0);
  return SpacePoint::constructed(size() - 1);
}

SpacePoint Point3Table::add(PlaneId p, PlaneId q, PlaneId r) {
  if (p == q || q == r || p == r) return {};
  return add_new({p, q, r}, fast_box(planes_->row(p), planes_->row(q), planes_->row(r)));
}

SpacePoint Point3Table::add(InputPointId a, InputPointId b, PlaneId p) {
  return add_new({a, b, p}, fast_box(planes_->point(a), planes_->point(b), planes_->row(p)));
}

PointBox Point3Table::near_box(SpacePoint p) const {
  if (p.is_input() || !is_far(box(p))) return box(p);
  const PointSource& s = source(p);
  const auto row = [&](std::size_t i) { return near_row(*planes_, s.plane(i)); };
  if (!s.is_line()) return fast_box(row(0), row(1), row(2));
  return fast_box(planes_->point(s.end(0)), planes_->point(s.end(1)), row(0));
}

bool Point3Table::depends_on_frame(SpacePoint p) const {
  return !p.is_input() && depends_on_frame(source(p));
}

bool Point3Table::depends_on_frame(const PointSource& s) const {
  for (std::size_t i = 0; i < s.plane_count(); ++i) {
    if (planes_->is_frame(s.plane(i))) return true;
  }
  return false;
}

std::uint32_t Point3Table::merge(const Point3Table& other, std::span<const PlaneId> plane_map,
                                 std::uint32_t input_offset) {
  const std::size_t offset = size();
  boxes_.insert(boxes_.end(), other.boxes_.begin(), other.boxes_.end());
  is_nearest_.insert(is_nearest_.end(), other.is_nearest_.begin(), other.is_nearest_.end());
  sources_.reserve(boxes_.capacity());
  for (const PointSource& source : other.sources_) {
    sources_.push_back(
        source.mapped([&](PlaneId p) { return plane_map[p.value()]; },
                      [&](InputPointId p) { return InputPointId(p.value() + input_offset); }));
  }
  return static_cast<std::uint32_t>(offset);
}

}  // namespace plumb
