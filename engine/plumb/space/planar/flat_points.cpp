#include "plumb/space/planar/flat_points.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <utility>

#include "plumb/predicates/input/rung_counters.h"
#include "plumb/predicates/input_predicates.h"
#include "plumb/predicates/rational_predicates.h"

namespace plumb {

FlatView FlatView::of_plane(const PlaneTable& planes, PlaneId plane) {
  const PlaneRow& row = planes.row(plane);
  FlatView view;
  view.axis = 0;
  for (std::size_t i = 1; i < 3; ++i) {
    if (std::fabs(row.n[i]) > std::fabs(row.n[view.axis])) view.axis = i;
  }
  view.is_mirrored = row.n[view.axis] < 0;  // |n| >= 1/2 there, so the sign is the exact one
  return view;
}

void FlatPoints::reset(FlatView view) {
  view_ = view;
  at_.clear();
  homogeneous_.clear();
  exact_.clear();
}

void FlatPoints::push_back(SpacePoint p) {
  const PointBox box = points_.box(p);
  at_.push_back(
      {{box.mid[view_.coordinate(0)], box.mid[view_.coordinate(1)]}, box.radius, p, p.is_input()});
}

void FlatPoints::push_back(SpacePoint p, const RoundedPoint3& nearest) {
  const std::array c{nearest.at.x, nearest.at.y, nearest.at.z};
  const Point2 mid{c[view_.coordinate(0)], c[view_.coordinate(1)]};
  const double half_ulp = 0x1p-53 * std::max(std::fabs(mid.x), std::fabs(mid.y));
  at_.push_back({mid, nearest.is_exact ? 0 : half_ulp, p, true});
}

const RationalPoint2& FlatPoints::exact_point(std::uint32_t i) const {
  if (exact_.size() < at_.size()) exact_.resize(at_.size());
  if (!exact_[i]) {
    const RationalPoint3 p = exact(points_, at_[i].point);
    const std::array<const Rational*, 3> c{&p.x, &p.y, &p.z};
    exact_[i] = RationalPoint2{*c[view_.coordinate(0)], *c[view_.coordinate(1)]};
  }
  return *exact_[i];
}

const FlatPoints::HomogeneousPoint& FlatPoints::homogeneous_point(std::uint32_t i) const {
  if (homogeneous_.size() < at_.size()) homogeneous_.resize(at_.size());
  if (!homogeneous_[i]) {
    IntegerRow row = homogeneous(points_, at_[i].point);
    homogeneous_[i] = HomogeneousPoint{std::move(row[view_.coordinate(0)]),
                                       std::move(row[view_.coordinate(1)]), std::move(row[3])};
  }
  return *homogeneous_[i];
}

namespace {

/// A difference of coordinates is off by E = the radii (and what subnormals lose, flushed or
/// rounded: 2^-1000 covers it) and one rounding; the determinant by E times the four differences, 2
/// E^2 and 2^-50 of its products; the factor 2 pays for the roundings of the bound. Overflow: not
/// decided.
FilteredSign orient_filter(const Point2& a, const Point2& b, const Point2& c, double radii) {
  const double e = radii + 0x1p-1000;
  const double ax = a.x - c.x, ay = a.y - c.y, bx = b.x - c.x, by = b.y - c.y;
  const double left = ax * by, right = ay * bx;
  const double sum = std::fabs(ax) + std::fabs(ay) + std::fabs(bx) + std::fabs(by);
  const double error = 2 * (e * sum + 2 * e * e + 0x1p-50 * (std::fabs(left) + std::fabs(right)));
  const double value = left - right;
  if (value > error) return FilteredSign::Positive;
  return value < -error ? FilteredSign::Negative : FilteredSign::Unsure;
}

}  // namespace

Sign FlatPoints::orient(std::uint32_t i, std::uint32_t j, std::uint32_t k) const {
  const Entry &a = at_[i], &b = at_[j], &c = at_[k];
  if (a.point.is_input() && b.point.is_input() && c.point.is_input()) {
    return orient2d(a.mid, b.mid, c.mid);
  }
  const double radii = 2 * std::max({a.radius, b.radius, c.radius});
  const FilteredSign s = orient_filter(a.mid, b.mid, c.mid, radii);
  if (is_decided(s)) return decide(Predicate::Orient2d, Rung::Filter, s);
  const auto& [ax, ay, aw] = homogeneous_point(i);
  const auto& [bx, by, bw] = homogeneous_point(j);
  const auto& [cx, cy, cw] = homogeneous_point(k);
  const Integer det =
      ax * (by * cw - bw * cy) - ay * (bx * cw - bw * cx) + aw * (bx * cy - by * cx);
  count_rung(Predicate::Orient2d, Rung::Big);
  return sign_of(det);
}

Sign FlatPoints::compare_along(std::size_t i, std::size_t j, std::size_t side) const {
  const Entry &a = at_[i], &b = at_[j];
  const double x = side == 0 ? a.mid.x : a.mid.y, y = side == 0 ? b.mid.x : b.mid.y;
  const bool are_inputs = a.point.is_input() && b.point.is_input();
  if (are_inputs && std::bit_cast<std::uint64_t>(x) == std::bit_cast<std::uint64_t>(y)) {
    return Sign::Zero;
  }
  if (a.is_nearest && b.is_nearest && (x < y || x > y)) {
    const FilteredSign s = x < y ? FilteredSign::Negative : FilteredSign::Positive;
    return decide(Predicate::CompareAxis, Rung::Filter, s);
  }
  return compare_axis(points_, a.point, b.point, view_.coordinate(side));
}

Sign FlatPoints::compare(std::uint32_t i, std::uint32_t j) const {
  const Sign x = compare_along(i, j, 0);
  return x != Sign::Zero ? x : compare_along(i, j, 1);
}

Sign FlatPoints::incircle(std::uint32_t i, std::uint32_t j, std::uint32_t k,
                          std::uint32_t l) const {
  const Entry &a = at_[i], &b = at_[j], &c = at_[k], &d = at_[l];
  if (a.point.is_input() && b.point.is_input() && c.point.is_input() && d.point.is_input()) {
    return plumb::incircle(a.mid, b.mid, c.mid, d.mid);
  }
  return plumb::incircle(exact_point(i), exact_point(j), exact_point(k), exact_point(l));
}

PointTable2 FlatPoints::table() const {
  PointTable2 table;
  table.reserve(at_.size());
  for (std::uint32_t i = 0; i < size(); ++i) {
    if (at_[i].point.is_input()) {
      table.push_back(at_[i].mid);
    } else {
      table.push_back(exact_point(i).x, exact_point(i).y);
    }
  }
  return table;
}

}  // namespace plumb
