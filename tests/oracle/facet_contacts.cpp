#include "oracle/facet_contacts.h"

#include <algorithm>
#include <array>

namespace plumb::testing {
namespace {

using Vector = std::array<Rational, 3>;

Vector vector(const RationalPoint3& p) { return {p.x, p.y, p.z}; }
Vector minus(const Vector& a, const Vector& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
Rational dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

using Points = std::vector<Vector>;

Points vectors(const FacetPolygon& polygon) {
  Points points;
  for (const RationalPoint3& p : polygon) points.push_back(vector(p));
  return points;
}

Vector normal(const Points& polygon) {
  Vector sum{};
  for (std::size_t i = 2; i < polygon.size(); ++i) {
    const Vector n = cross(minus(polygon[i - 1], polygon[0]), minus(polygon[i], polygon[0]));
    for (std::size_t k = 0; k < 3; ++k) sum[k] += n[k];
  }
  return sum;
}

/// The part of a convex polygon (or segment, point) where n.(x - o) >= 0.
Points clip(const Points& points, const Vector& n, const Vector& o) {
  Points kept;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Vector &a = points[i], &b = points[(i + 1) % points.size()];
    const Rational s = dot(n, minus(a, o)), t = dot(n, minus(b, o));
    if (s >= 0) kept.push_back(a);
    if ((s > 0 && t < 0) || (s < 0 && t > 0)) {
      const Rational f = s / (s - t);
      const Vector d = minus(b, a);
      kept.push_back({a[0] + f * d[0], a[1] + f * d[1], a[2] + f * d[2]});
    }
  }
  return kept;
}

Vector negative(const Vector& n) { return {-n[0], -n[1], -n[2]}; }

/// Corners of the common part.
Points common_part(const Points& a, const Points& b) {
  const Vector n = normal(b);
  Points part = clip(clip(a, n, b[0]), negative(n), b[0]);
  for (std::size_t i = 0; i < b.size(); ++i) {
    const Vector inward = cross(n, minus(b[(i + 1) % b.size()], b[i]));
    part = clip(part, inward, b[i]);
  }
  return part;
}

bool is_on_segment(const Vector& x, const Vector& a, const Vector& b) {
  const Vector d = minus(b, a), e = minus(x, a);
  return cross(d, e) == Vector{} && dot(d, e) >= 0 && dot(d, e) <= dot(d, d);
}

bool have_side(const Points& polygon, const Vector& a, const Vector& b) {
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vector &p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
    if ((p == a && q == b) || (p == b && q == a)) return true;
  }
  return false;
}

}  // namespace

bool meet_elsewhere(const FacetPolygon& first, const FacetPolygon& second) {
  const Points a = vectors(first), b = vectors(second);
  const Points part = common_part(a, b);
  if (part.empty()) return false;
  const bool is_point =
      std::ranges::all_of(part, [&](const Vector& x) { return x == part.front(); });
  if (is_point && std::ranges::count(a, part[0]) > 0 && std::ranges::count(b, part[0]) > 0) {
    return false;
  }
  for (std::size_t i = 0; i < a.size(); ++i) {
    const Vector &p = a[i], &q = a[(i + 1) % a.size()];
    if (!have_side(b, p, q)) continue;
    if (std::ranges::all_of(part, [&](const Vector& x) { return is_on_segment(x, p, q); })) {
      return false;
    }
  }
  return true;
}

}  // namespace plumb::testing
