// The canonical form of a set of the plane.
//
// The cells of a complex are numbered by the set alone (plane_complex.h). Its coordinates are not:
// a vertex is an input point or a crossing, and a line is given by any two of its input points.
// Here every vertex becomes the input point of the same index. A bounded edge lies on the line
// through its ends. A ray or line is given by two points that depend on its equation alone, those
// with the abscissas 0 and 1, or with the ordinates 0 and 1 if it is vertical.
// Tested by tests/test_laws.py (test_equal_sets_have_equal_bytes_and_hashes).
#include "plane_canonical.h"

#include <algorithm>
#include <map>
#include <utility>

#include "plumb/plane/plane_complex.h"
#include "plumb/predicates/rational_point.h"

namespace plumb::python {
namespace {

struct ByCoordinates {
  bool operator()(const RationalPoint2& p, const RationalPoint2& q) const {
    return p.x != q.x ? p.x < q.x : p.y < q.y;
  }
};

class CanonicalPoints {
 public:
  std::uint32_t add(const RationalPoint2& p) {
    const auto index = static_cast<std::uint32_t>(table_.size());
    const auto [place, is_added] = indices_.emplace(p, index);
    if (is_added) table_.push_back(p.x, p.y);
    return place->second;
  }
  PointTable2 take() { return std::move(table_); }

 private:
  PointTable2 table_;
  std::map<RationalPoint2, std::uint32_t, ByCoordinates> indices_;
};

PlaneLine line_through(const RationalPoint2& p, const RationalPoint2& q, CanonicalPoints& points) {
  if (p.x == q.x) return {points.add({p.x, 0}), points.add({p.x, 1})};
  const Rational slope = (q.y - p.y) / (q.x - p.x);
  const Rational at_zero = p.y - slope * p.x;
  return {points.add({0, at_zero}), points.add({1, at_zero + slope})};
}

}  // namespace

Nef2 canonical(const Nef2& set, Context& context) {
  PlaneComplex complex = set.complex();
  CanonicalPoints points;
  for (std::size_t i = 0; i < complex.vertex_count(); ++i) {
    points.add(exact(complex.points, complex.vertex_point[VertexId(i)]));
    if (i % 1024 == 0) context.checkpoint("number", i, complex.vertex_count());
  }
  for (std::size_t i = 0; i < complex.edge_count(); ++i) {
    const HalfedgeId h(2 * i);
    const VertexId from = complex.dcel.origin(h);
    const VertexId to = complex.dcel.target(h);
    PlaneLine& line = complex.line[EdgeId(i)];
    if (!complex.is_at_infinity(from) && !complex.is_at_infinity(to)) {
      line = {std::min(from, to).value(), std::max(from, to).value()};
    } else {
      const PointTable2& inputs = complex.points.inputs;
      line = line_through(inputs.exact(line.a), inputs.exact(line.b), points);
    }
  }
  for (std::size_t i = 0; i < complex.vertex_count(); ++i) {
    complex.vertex_point[VertexId(i)] = static_cast<std::uint32_t>(i);
  }
  complex.points = {points.take(), {}};
  return Nef2::from_minimal_unchecked(std::move(complex));
}

}  // namespace plumb::python
