#include "plumb/surface/piece_points.h"

#include <algorithm>
#include <cmath>

#include "plumb/predicates/rational_predicates.h"
#include "plumb/predicates/rounding.h"
#include "plumb/predicates/rung_counters.h"
#include "plumb/predicates/segment2.h"

namespace plumb {

PiecePoints::PiecePoints(const SurfaceDivision& division)
    : mesh_(division.mesh()),
      a_(division.arrangement()),
      points_(division.scene().polygons.points) {}

void PiecePoints::reset(FaceId f) {
  face_ = f;
  at_.clear();
  exact_.clear();
  exact_form_.reset();
  const Point3 &o = mesh_.point(mesh_.corner(f, 0)), &a = mesh_.point(mesh_.corner(f, 1)),
               &b = mesh_.point(mesh_.corner(f, 2));
  const Point3 p{a.x - o.x, a.y - o.y, a.z - o.z}, q{b.x - o.x, b.y - o.y, b.z - o.z};
  form_ = {p.x * p.x + p.y * p.y + p.z * p.z, p.x * q.x + p.y * q.y + p.z * q.z,
           q.x * q.x + q.y * q.y + q.z * q.z};
  form_scale_ = form_[0] + 2 * std::fabs(form_[1]) + form_[2];
}

/// A rounded number of [0, 1] is off by 2^-53 at most.
void PiecePoints::push_back(NodeId n) {
  if (a_.is_crossing(n)) {
    const SurfaceCrossing& c = a_.crossing(n);
    at_.push_back({c.approx, c.radius, n});
    return;
  }
  if (!a_.is_input(n)) {
    const std::uint32_t v = a_.corner(n).value();
    const SurfaceTriangle& t = mesh_.corners(face_);
    at_.push_back({{t[1] == v ? 1.0 : 0.0, t[2] == v ? 1.0 : 0.0}, 0, n});
    return;
  }
  at_.push_back({points_.approx_in(a_.input(n), face_), 0x1p-52, n});
}

const RationalPoint2& PiecePoints::exact_point(std::uint32_t i) const {
  if (exact_.size() < at_.size()) exact_.resize(at_.size());
  if (!exact_[i]) exact_[i] = exact_node(a_, points_, at_[i].node, face_);
  return *exact_[i];
}

const std::array<Rational, 3>& PiecePoints::exact_form() const {
  if (!exact_form_) {
    const auto corner = [&](std::size_t i) {
      const Point3& p = mesh_.point(mesh_.corner(face_, i));
      return RationalPoint3{exact_rational(p.x), exact_rational(p.y), exact_rational(p.z)};
    };
    const RationalPoint3 o = corner(0), a = corner(1), b = corner(2);
    const RationalPoint3 p{a.x - o.x, a.y - o.y, a.z - o.z}, q{b.x - o.x, b.y - o.y, b.z - o.z};
    exact_form_ = {p.x * p.x + p.y * p.y + p.z * p.z, p.x * q.x + p.y * q.y + p.z * q.z,
                   q.x * q.x + q.y * q.y + q.z * q.z};
  }
  return *exact_form_;
}

namespace {

/// A difference is off by e and one rounding, at most 2^-50 with coordinates in [0, 1]: it is counted into e. So
/// the determinant is off by e times the four differences and 2 e^2, and by 2^-50 of its products; the
/// factor 2 pays for the roundings of the bound.
FilteredSign orient_filter(const Point2& a, const Point2& b, const Point2& c, double radii) {
  const double e = radii + 0x1p-50;
  const double ax = a.x - c.x, ay = a.y - c.y, bx = b.x - c.x, by = b.y - c.y;
  const double left = ax * by, right = ay * bx;
  const double sum = std::fabs(ax) + std::fabs(ay) + std::fabs(bx) + std::fabs(by);
  const double error = 2 * (e * sum + 2 * e * e + 0x1p-50 * (std::fabs(left) + std::fabs(right)));
  const double value = left - right;
  if (value > error) return FilteredSign::Positive;
  return value < -error ? FilteredSign::Negative : FilteredSign::Unsure;
}

/// det of the rows (x, y, E x x + 2 F x y + G y y) for a, b, c.
template <class Number, class Point>
Number circle_determinant(const std::array<Number, 3>& form, const Point& a, const Point& b,
                          const Point& c) {
  const auto lift = [&](const Point& p) {
    return Number(form[0] * p.x * p.x + 2 * form[1] * p.x * p.y + form[2] * p.y * p.y);
  };
  return Number((a.x * b.y - a.y * b.x) * lift(c) + (b.x * c.y - b.y * c.x) * lift(a) +
                (c.x * a.y - c.y * a.x) * lift(b));
}

}  // namespace

Sign PiecePoints::orient(std::uint32_t i, std::uint32_t j, std::uint32_t k) const {
  const Entry &a = at_[i], &b = at_[j], &c = at_[k];
  const double radii = 2 * std::max({a.radius, b.radius, c.radius});
  const FilteredSign s = orient_filter(a.mid, b.mid, c.mid, radii);
  if (is_decided(s)) return decide(Predicate::Orient2d, Rung::Filter, s);
  return orient2d(exact_point(i), exact_point(j), exact_point(k));
}

Sign PiecePoints::compare(std::uint32_t i, std::uint32_t j) const {
  const Entry &a = at_[i], &b = at_[j];
  const double x = a.mid.x - b.mid.x;
  if (std::fabs(x) > 2 * (a.radius + b.radius)) return sign_of(x);
  return compare_xy(exact_point(i), exact_point(j));
}

/// With M the largest difference, e <= M / 8 their errors, K = E + 2 |F| + G: E, F and G are off by 2^-50 K
/// (differences of coordinates are rounded once), so a lift, at most K M^2, is off by 3 e K M + 2^-47 K M^2; a
/// cross product, at most 2 M^2, by 5 e M + 2^-50 M^2; each of the three terms by 11 e K M^3 + 2^-45 K M^4. The bound
/// is twice that and more. Nothing underflows that matters for K >= 2^-500 and M >= 2^-100.
Sign PiecePoints::incircle(std::uint32_t i, std::uint32_t j, std::uint32_t k,
                           std::uint32_t l) const {
  const Entry &a = at_[i], &b = at_[j], &c = at_[k], &d = at_[l];
  const double e = 2 * std::max({a.radius, b.radius, c.radius, d.radius}) + 0x1p-52;
  const auto from_d = [](const Point2& p, const Point2& o) { return Point2{p.x - o.x, p.y - o.y}; };
  const Point2 p = from_d(a.mid, d.mid), q = from_d(b.mid, d.mid), r = from_d(c.mid, d.mid);
  const double m = std::max({std::fabs(p.x), std::fabs(p.y), std::fabs(q.x), std::fabs(q.y),
                             std::fabs(r.x), std::fabs(r.y)});
  const double error = 72 * (e + 0x1p-44 * m) * form_scale_ * m * m * m;
  const bool is_in_range = form_scale_ >= 0x1p-500 && form_scale_ <= 0x1p500 && m >= 0x1p-100;
  const double value = circle_determinant(form_, p, q, r);
  if (is_in_range && e <= m / 8 && std::fabs(value) > error) {
    return decide(Predicate::Incircle, Rung::Filter, filtered(sign_of(value)));
  }
  count_rung(Predicate::Incircle, Rung::Big);
  const RationalPoint2& o = exact_point(l);
  const auto exactly = [&](std::uint32_t n) {
    return RationalPoint2{exact_point(n).x - o.x, exact_point(n).y - o.y};
  };
  return sign_of(circle_determinant(exact_form(), exactly(i), exactly(j), exactly(k)));
}

}  // namespace plumb
