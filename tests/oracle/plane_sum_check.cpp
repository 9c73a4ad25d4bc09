#include "oracle/plane_sum_check.h"

#include <vector>

#include "plumb/convex/plane_minkowski.h"
#include "plumb/predicates/rounding.h"

namespace plumb::testing {
namespace {

/// Whether A meets p - B.
bool is_in_sum(const Nef2& a, const Nef2& b, const RationalPoint2& p) {
  AffineMap2 reflection;
  reflection.xx = reflection.yy = -1;
  reflection.x0 = p.x;
  reflection.y0 = p.y;
  return !(a * b.transformed(reflection)).is_empty();
}

RationalPoint2 at(const PlaneComplex& c, VertexId v) { return exact(c.points, c.vertex_point[v]); }

std::vector<RationalPoint2> vertices_of(const Nef2& set) {
  std::vector<RationalPoint2> points;
  const PlaneComplex& c = set.complex();
  for (std::size_t v = 0; v < c.vertex_count(); ++v) points.push_back(at(c, VertexId(v)));
  return points;
}

RationalPoint2 middle(const RationalPoint2& a, const RationalPoint2& b) {
  return {(a.x + b.x) / 2, (a.y + b.y) / 2};
}

std::vector<RationalPoint2> samples(const Nef2& a, const Nef2& b, const Nef2& sum) {
  std::vector<RationalPoint2> points = vertices_of(sum);
  const PlaneComplex& c = sum.complex();
  for (std::size_t e = 0; e < c.edge_count(); ++e) {
    const HalfedgeId h = first_half(EdgeId(e));
    points.push_back(middle(at(c, c.dcel.origin(h)), at(c, c.dcel.target(h))));
  }
  const std::vector<RationalPoint2> vertices_b = vertices_of(b);
  for (const RationalPoint2& p : vertices_of(a)) {
    for (const RationalPoint2& q : vertices_b) points.push_back({p.x + q.x, p.y + q.y});
  }
  const std::size_t n = points.size();
  for (std::size_t i = 0; i + 1 < n; ++i) points.push_back(middle(points[i], points[n - 1 - i]));
  return points;
}

}  // namespace

std::string flaw_of_sum(const Nef2& a, const Nef2& b) {
  const Nef2 sum = minkowski_sum(a, b);
  if (const auto flaw = sum.audit()) return "audit: " + flaw->invariant + " at " + flaw->place;
  if (sum != minkowski_sum(b, a)) return "the sum depends on the order of the operands";
  if (a.is_closed() && b.is_closed() && !sum.is_closed()) return "a sum that is not closed";
  for (const RationalPoint2& p : samples(a, b, sum)) {
    const bool expected = is_in_sum(a, b, p);
    if (sum.contains(p) == expected) continue;
    return (expected ? "a missing point: " : "a superfluous point: ") + exact_text(p.x) + ' ' +
           exact_text(p.y);
  }
  return "";
}

}  // namespace plumb::testing
