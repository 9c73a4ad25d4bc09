// The predicates on points of space: side of a plane, order along an axis, equality, order along a
// line; and fingerprints and exact coordinates.
//
// Each asks, in this order: filters on the cached boxes; identity, by the planes that define a
// point or are known to contain it; exact integers of growing widths. A point of three planes is
// compared with a plane by det4 and det3 of four rows; a point on an input line, which has smaller
// numbers, by its coordinates (point3_exact.h). Numbers c0 + c1 R of the frame are decided part by
// part (filter_stages.h, docs/design/frame.md).
//
// Equality asks fingerprints first: points with different ones differ, and equal ones are confirmed
// by the sides of one point on the planes of the other.
//
// docs/design/numbers.md (Planes, Boxes of constructed points) proves the bounds.
//
// Tested by tests/predicates/point3_signs_test.cpp and tests/predicates/frame_test.cpp.

#include "plumb/predicates/point3_signs.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "plumb/predicates/plane_signs.h"
#include "plumb/predicates/space/filter_stages.h"
#include "plumb/predicates/space/point3_exact.h"

namespace plumb {

using exact3::BigPlane;
using exact3::FixedPlane;
using exact3::Operand;
using exact3::Part;
using exact3::PointOf;
using exact3::PointOperand;

namespace {

/// The side of the common point of p[0], p[1], p[2] on p[3], which is the sign of det4 / det3.
struct SideForm {
  template <class Plane>
  Sign operator()(const std::array<Plane, 4>& p) const {
    const auto both = exact3::determinants(p[0], p[1], p[2], p[3]);
    return exact3::sign_of(both.det4) * exact3::sign_of(both.det3);
  }
};

/// Whether the point is defined by three planes.
bool has_three_planes(const Point3Table& points, SpacePoint x) {
  return !x.is_input() && !points.source(x).is_line();
}

/// Returns the planes of the point and another plane as operands. Requires has_three_planes().
std::array<Operand, 4> with_planes(const Point3Table& points, SpacePoint x, PlaneId plane) {
  const PointSource& source = points.source(x);
  return exact3::operands<4>(points.planes(),
                             {source.plane(0), source.plane(1), source.plane(2), plane});
}

/// Returns the side of a point on a plane, by coordinates in the numbers of Plane.
template <class Plane>
FilteredSign side_in(const PointOperand& x, const Operand& plane) {
  return exact3::by_parts(exact3::has_frame(x) || plane.source.is_frame(), [&](Part part) {
    PointOf<Plane> point;
    if (!exact3::load_point<Plane>(x, part, point)) return FilteredSign::Unsure;
    return exact3::side_sign<Plane>(point, exact3::load_as<Plane>(plane, part));
  });
}

/// Returns the order of two points along an axis, by coordinates in the numbers of Plane.
template <class Plane>
FilteredSign order_in(const PointOperand& x, const PointOperand& y, std::size_t axis) {
  return exact3::by_parts(exact3::has_frame(x) || exact3::has_frame(y), [&](Part part) {
    PointOf<Plane> a, b;
    if (!exact3::load_point<Plane>(x, part, a) || !exact3::load_point<Plane>(y, part, b)) {
      return FilteredSign::Unsure;
    }
    return exact3::axis_order<Plane>(a, b, axis);
  });
}

/// Returns the side of a plane across an axis on which an input point lies. The canonical normal
/// along an axis is positive, so coordinates are compared. Returns Unsure if the definition of the
/// plane does not show that it is across an axis.
FilteredSign side_across(const PlaneTable& planes, InputPointId x, PlaneId plane) {
  const PlaneSource& source = planes.source(plane);
  if (!source.is_explicit()) return exact3::side_across(planes, x, source);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (!exact3::is_across(planes, plane, axis)) continue;
    const std::optional<double> c = exact3::coordinate_across(planes, plane, axis);
    if (!c) return FilteredSign::Unsure;
    return filtered(compare(exact3::coordinate(planes.point(x), axis), *c));
  }
  return FilteredSign::Unsure;
}

/// The exact stages of side(). For an input point and a plane through input points, this is
/// orient3d.
Sign exact_side(const Point3Table& points, SpacePoint x, PlaneId plane) {
  const auto count = [](Rung rung) { count_rung(Predicate::SideOfPlane, rung); };
  if (has_three_planes(points, x)) {
    const auto near = [&] { return rung::near_side_filter(points, x, plane); };
    return exact3::exact_sign(with_planes(points, x, plane), SideForm{}, near, count);
  }
  if (x.is_input()) {
    const FilteredSign s = side_across(points.planes(), x.input(), plane);
    if (is_decided(s)) {
      count(Rung::Small);
      return decided(s);
    }
  }
  const PointOperand point = exact3::operand(points, x);
  const Operand other = exact3::operand(points.planes(), plane);
  const int width = std::max(point.width, other.width);
  if (x.is_input() && !other.source.is_explicit() && width <= exact3::Wide::kIndex) {
    const FilteredSign s = exact3::side_by_corners(points.planes(), x.input(), other.source);
    if (is_decided(s)) {
      count(width == exact3::Narrow::kIndex ? Rung::Small : Rung::Exact);
      return decided(s);
    }
  }
  return exact3::point_ladder(
      width, [&]<class Plane>() { return side_in<Plane>(point, other); }, count);
}

Sign exact_order(const Point3Table& points, SpacePoint x, SpacePoint y, std::size_t axis) {
  const PointOperand a = exact3::operand(points, x), b = exact3::operand(points, y);
  return exact3::point_ladder(
      std::max(a.width, b.width), [&]<class Plane>() { return order_in<Plane>(a, b, axis); },
      [](Rung rung) { count_rung(Predicate::CompareAxis, rung); });
}

}  // namespace

namespace rung {

/// The difference of two doubles is off by one rounding, 2^-52 of it, and by what flushing
/// subnormal operands loses, which 2^-1000 covers. The factors with 2^-50 pay for the rounding of
/// the bound.
FilteredSign compare_axis_filter(const PointBox& x, const PointBox& y, std::size_t axis) {
  const double difference = x.mid[axis] - y.mid[axis];
  const double error = (x.radius + y.radius) * (1 + 0x1p-50) + 0x1p-1000;
  if (difference * (1 - 0x1p-50) > error) return FilteredSign::Positive;
  return difference * (1 - 0x1p-50) < -error ? FilteredSign::Negative : FilteredSign::Unsure;
}

FilteredSign far_side_filter(const Point3Table& points, SpacePoint x, PlaneId plane) {
  if (x.is_input()) return FilteredSign::Unsure;
  const PointBox box = points.box(x);
  if (!is_far(box)) return FilteredSign::Unsure;
  return side_filter(far_box(box), far_row(points.planes(), plane));
}

FilteredSign near_side_filter(const Point3Table& points, SpacePoint x, PlaneId plane) {
  return side_filter(points.near_box(x), near_row(points.planes(), plane));
}

/// Compares the directions u first. If both coordinates of u are known to be 0, c1 is 0, and the
/// boxes around P0 may decide.
FilteredSign far_compare_axis_filter(const Point3Table& points, SpacePoint x, SpacePoint y,
                                     std::size_t axis) {
  const PointBox a = points.box(x), b = points.box(y);
  const auto is_known = [](const PointBox& p) { return is_far(p) || !std::isinf(p.radius); };
  if (!(is_far(a) || is_far(b)) || !is_known(a) || !is_known(b)) return FilteredSign::Unsure;
  const PointBox u = far_box(a), v = far_box(b);
  // The signs of the coordinates of u and v are exact, 0 included.
  if (v.mid[axis] == 0 && u.mid[axis] != 0) return filtered(sign_of(u.mid[axis]));
  if (u.mid[axis] == 0 && v.mid[axis] != 0) return filtered(-sign_of(v.mid[axis]));
  if (u.mid[axis] != 0) return compare_axis_filter(u, v, axis);
  return compare_axis_filter(points.near_box(x), points.near_box(y), axis);
}

// For g++, the definition of a template determines its visibility, not the declaration in the
// header.
#pragma GCC visibility push(default)
template <class W>
FilteredSign side_fixed(const Point3Table& points, SpacePoint x, PlaneId plane) {
  if (has_three_planes(points, x)) {
    return exact3::fixed_sign<W>(with_planes(points, x, plane), SideForm{});
  }
  const PointOperand point = exact3::operand(points, x);
  const Operand other = exact3::operand(points.planes(), plane);
  if (std::max(point.width, other.width) > W::kIndex) return FilteredSign::Unsure;
  return side_in<FixedPlane<W>>(point, other);
}

template <class W>
FilteredSign compare_axis_fixed(const Point3Table& points, SpacePoint x, SpacePoint y,
                                std::size_t axis) {
  const PointOperand a = exact3::operand(points, x), b = exact3::operand(points, y);
  if (std::max(a.width, b.width) > W::kIndex) return FilteredSign::Unsure;
  return order_in<FixedPlane<W>>(a, b, axis);
}

#pragma GCC visibility pop

#define PLUMB_POINT3_INSTANCE(W)                                                          \
  template FilteredSign side_fixed<W>(const Point3Table&, SpacePoint, PlaneId);           \
  template FilteredSign compare_axis_fixed<W>(const Point3Table&, SpacePoint, SpacePoint, \
                                              std::size_t);
PLUMB_POINT3_INSTANCE(exact3::Narrow)
PLUMB_POINT3_INSTANCE(exact3::Medium)
PLUMB_POINT3_INSTANCE(exact3::Wide)
#undef PLUMB_POINT3_INSTANCE

Sign side_big(const Point3Table& points, SpacePoint x, PlaneId plane) {
  if (has_three_planes(points, x)) {
    return exact3::big_sign(with_planes(points, x, plane), SideForm{});
  }
  const PointOperand point = exact3::operand(points, x);
  return decided(side_in<BigPlane>(point, exact3::operand(points.planes(), plane)));
}

Sign compare_axis_big(const Point3Table& points, SpacePoint x, SpacePoint y, std::size_t axis) {
  return decided(order_in<BigPlane>(exact3::operand(points, x), exact3::operand(points, y), axis));
}

}  // namespace rung

bool is_known_on(const Point3Table& points, SpacePoint x, PlaneId plane,
                 std::span<const PlaneId> incident) {
  const PlaneTable& planes = points.planes();
  if (std::find(incident.begin(), incident.end(), plane) != incident.end()) return true;
  if (planes.is_wall_of(plane, incident)) return true;
  if (x.is_input()) return planes.source(plane).has_point(x.input());
  const PointSource& source = points.source(x);
  std::array<PlaneId, 3> own;
  for (std::size_t i = 0; i < source.plane_count(); ++i) own[i] = source.plane(i);
  const std::span<const PlaneId> known = std::span(own).first(source.plane_count());
  return std::find(known.begin(), known.end(), plane) != known.end() ||
         planes.is_wall_of(plane, known);
}

Sign rung::side_without_filter(const Point3Table& points, SpacePoint x, PlaneId plane,
                               std::span<const PlaneId> incident) {
  const FilteredSign s = far_side_filter(points, x, plane);
  if (is_decided(s)) return decide(Predicate::SideOfPlane, Rung::Filter, s);
  if (is_known_on(points, x, plane, incident)) {
    count_rung(Predicate::SideOfPlane, Rung::Identity);
    return Sign::Zero;
  }
  const PlaneSource& source = points.planes().source(plane);
  if (source.is_frame() && !points.depends_on_frame(x)) {  // The point is inside the cube.
    count_rung(Predicate::SideOfPlane, Rung::Identity);
    return sign_of(points.planes().row(plane).d);
  }
  return exact_side(points, x, plane);
}

namespace {

/// Returns the plane across an axis among the three planes that define a point, or an invalid id.
PlaneId plane_across(const Point3Table& points, SpacePoint x, std::size_t axis) {
  if (x.is_input()) return {};
  const PointSource& source = points.source(x);
  for (std::size_t i = 0; i < source.plane_count(); ++i) {
    if (exact3::is_across(points.planes(), source.plane(i), axis)) return source.plane(i);
  }
  return {};
}

/// Compares coordinates that are visible in the definitions of the points: doubles of input points,
/// and of planes and lines across the axis. Returns Unsure if a coordinate is not visible.
FilteredSign order_by_definition(const Point3Table& points, SpacePoint x, SpacePoint y,
                                 std::size_t axis) {
  const PlaneId p = plane_across(points, x, axis), q = plane_across(points, y, axis);
  if (p.is_valid() && p == q) return FilteredSign::Zero;
  const auto known = [&](SpacePoint at, PlaneId across) -> std::optional<double> {
    const PointBox box = points.box(at);
    if (box.radius == 0) return box.mid[axis];
    if (across.is_valid()) return exact3::coordinate_across(points.planes(), across, axis);
    if (at.is_input()) return {};
    return exact3::coordinate_along(points.planes(), points.source(at), axis);
  };
  const std::optional<double> a = known(x, p), b = known(y, q);
  return a && b ? filtered(compare(*a, *b)) : FilteredSign::Unsure;
}

/// The filters of compare_axis().
FilteredSign rough_order(const Point3Table& points, SpacePoint x, SpacePoint y, std::size_t axis) {
  const FilteredSign s = rung::compare_axis_filter(points.box(x), points.box(y), axis);
  return is_decided(s) ? s : rung::far_compare_axis_filter(points, x, y, axis);
}

}  // namespace

Sign compare_axis(const Point3Table& points, SpacePoint x, SpacePoint y, std::size_t axis) {
  if (x == y) return Sign::Zero;
  const FilteredSign s = rough_order(points, x, y, axis);
  if (is_decided(s)) return decide(Predicate::CompareAxis, Rung::Filter, s);
  const FilteredSign shown = order_by_definition(points, x, y, axis);
  if (is_decided(shown)) return decide(Predicate::CompareAxis, Rung::Identity, shown);
  return exact_order(points, x, y, axis);
}

Sign compare_xyz(const Point3Table& points, SpacePoint x, SpacePoint y) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const Sign s = compare_axis(points, x, y, axis);
    if (s != Sign::Zero) return s;
  }
  return Sign::Zero;
}

namespace {

/// Whether the filters show that two points differ along some axis.
bool is_apart(const Point3Table& points, SpacePoint x, SpacePoint y) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (is_decided(rough_order(points, x, y, axis))) {
      count_rung(Predicate::CompareAxis, Rung::Filter);
      return true;
    }
  }
  return false;
}

}  // namespace

bool equal(const Point3Table& points, SpacePoint x, SpacePoint y) {
  if (x == y) return true;
  if (is_apart(points, x, y)) return false;
  if (fingerprint(points, x) != fingerprint(points, y)) return false;
  if (y.is_input() || points.source(y).is_line()) std::swap(x, y);
  if (y.is_input() || points.source(y).is_line()) return compare_xyz(points, x, y) == Sign::Zero;
  const PointSource& source = points.source(y);
  for (std::size_t i = 0; i < 3; ++i) {
    if (side(points, x, source.plane(i)) != Sign::Zero) return false;
  }
  return true;
}

// --- order along a line --------------------------------------------------------------------------

namespace {

/// An axis along which the line of p and q is not constant, and the sign of its direction n_p x n_q
/// along this axis. If possible, it is the axis of the greatest component of this direction in
/// doubles.
struct Direction {
  std::size_t axis;
  Sign sign;
};

Direction direction_of(const PlaneTable& planes, PlaneId p, PlaneId q) {
  const auto &a = planes.row(p).n, &b = planes.row(q).n;
  std::array<std::size_t, 3> axes = {0, 1, 2};
  const auto run = [&](std::size_t i) {
    return std::fabs(a[(i + 1) % 3] * b[(i + 2) % 3] - a[(i + 2) % 3] * b[(i + 1) % 3]);
  };
  for (std::size_t i = 1; i < 3; ++i) {
    if (run(axes[i]) > run(axes[0])) std::swap(axes[0], axes[i]);
  }
  for (const std::size_t axis : axes) {
    const Sign sign = minor_sign(planes, p, q, axis);
    if (sign != Sign::Zero) return {axis, sign};
  }
  return {0, Sign::Zero};
}

}  // namespace

/// Boxes decide along the axis of the greatest component of the line's direction. Otherwise let s
/// be a plane of y that cuts the line, and y = x + l (n_p x n_q). Then 0 = s(y) = s(x) + l det3(p,
/// q, s), so l has the sign of -s(x) det3(p, q, s).
Sign order_along_line(const Point3Table& points, PlaneId p, PlaneId q, SpacePoint x, SpacePoint y) {
  if (x == y) return Sign::Zero;
  const Direction along = direction_of(points.planes(), p, q);
  const FilteredSign s = rough_order(points, y, x, along.axis);
  if (is_decided(s)) return decide(Predicate::CompareAxis, Rung::Filter, s) * along.sign;
  const std::size_t known = y.is_input() ? 0 : points.source(y).plane_count();
  for (std::size_t i = 0; i < known; ++i) {
    const PlaneId cut = points.source(y).plane(i);
    const Sign slope = det3_sign(points.planes(), p, q, cut);
    if (slope != Sign::Zero) return -(side(points, x, cut) * slope);
  }
  return compare_axis(points, y, x, along.axis) * along.sign;
}

// --- fingerprints and output ---------------------------------------------------------------------

namespace {

/// Returns the coordinates (x, w) of a point modulo q, by the formulas of point3_exact.h.
ResidueRow residues(const Point3Table& points, const PointSource& source) {
  const PlaneTable& planes = points.planes();
  const PlaneResidues p = residues(planes, source.plane(0));
  Residues3 x;
  Residue w;
  if (source.is_line()) {
    const Residues3 a = residues(planes.point(source.end(0)));
    const Residues3 b = residues(planes.point(source.end(1)));
    const Residue at_a = dot(p.n, a) + p.d, at_b = dot(p.n, b) + p.d;
    x = at_b * a - at_a * b;
    w = at_b - at_a;
  } else {
    const PlaneResidues q = residues(planes, source.plane(1)),
                        r = residues(planes, source.plane(2));
    const Residues3 qr = cross(q.n, r.n), rp = cross(r.n, p.n), pq = cross(p.n, q.n);
    for (std::size_t i = 0; i < 3; ++i) x[i] = -(p.d * qr[i] + q.d * rp[i] + r.d * pq[i]);
    w = dot(pq, r.n);
  }
  return {x[0], x[1], x[2], w};
}

ResidueRow residues(const Point3Table& points, SpacePoint x) {
  if (!x.is_input()) return residues(points, points.source(x));
  const Residues3 at = residues(points.planes().point(x.input()));
  return {at[0], at[1], at[2], Residue::of(std::uint64_t{1})};
}

}  // namespace

Fingerprint fingerprint(const Point3Table& points, SpacePoint x) {
  const ResidueRow row = residues(points, x);
  if (!leading(row).is_zero()) return fingerprint(row);
  return exact3::primitive_fingerprint(exact3::operand(points, x));
}

std::vector<Fingerprint> fingerprints(const Point3Table& points, std::span<const SpacePoint> x) {
  constexpr std::size_t kBlock = 256;
  std::array<ResidueRow, kBlock> rows;
  std::array<Residue, kBlock> inverses, scratch;
  std::vector<Fingerprint> result;
  result.reserve(x.size());
  while (result.size() < x.size()) {
    const auto block = x.subspan(result.size(), std::min(kBlock, x.size() - result.size()));
    for (std::size_t i = 0; i < block.size(); ++i) {
      rows[i] = residues(points, block[i]);
      inverses[i] = leading(rows[i]);
    }
    invert_all(std::span(inverses).first(block.size()), scratch);
    for (std::size_t i = 0; i < block.size(); ++i) {
      result.push_back(inverses[i].is_zero() ? fingerprint(points, block[i])
                                             : fingerprint(rows[i], inverses[i]));
    }
  }
  return result;
}

namespace {

RationalPoint3 exact_part(const PointOperand& operand, exact3::Part part) {
  const IntegerRow row = exact3::integer_row(operand, part);
  const auto over_w = [&](std::size_t i) { return Rational(row[i], row[3]); };
  return {over_w(0), over_w(1), over_w(2)};
}

}  // namespace

IntegerRow homogeneous(const Point3Table& points, SpacePoint x) {
  IntegerRow row = exact3::integer_row(exact3::operand(points, x));
  if (row[3] < 0) {
    for (Integer& c : row) c = -c;
  }
  return row;
}

RationalPoint3 exact(const Point3Table& points, SpacePoint x) {
  return exact_part(exact3::operand(points, x), exact3::Part::Finite);
}

FramedPoint3 exact_parts(const Point3Table& points, SpacePoint x) {
  const PointOperand operand = exact3::operand(points, x);
  const RationalPoint3 finite = exact_part(operand, exact3::Part::Finite);
  if (!exact3::has_frame(operand)) return {finite, {0, 0, 0}};
  return {finite, exact_part(operand, exact3::Part::Infinite)};
}

}  // namespace plumb
