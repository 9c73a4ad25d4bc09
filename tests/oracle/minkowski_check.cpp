#include "oracle/minkowski_check.h"

#include "plumb/predicates/point3_signs.h"
#include "plumb/space/space_audit.h"

namespace plumb::testing {

std::vector<RationalPoint3> vertices(const Nef3& set) {
  std::vector<RationalPoint3> points;
  const SpaceComplex& c = set.complex();
  for (const SpacePoint p : c.vertex_point) points.push_back(exact(c.points(), p));
  return points;
}
RationalPoint3 plus(const RationalPoint3& p, const RationalPoint3& q) {
  return {p.x + q.x, p.y + q.y, p.z + q.z};
}

namespace {

RationalPoint3 middle(const RationalPoint3& p, const RationalPoint3& q) {
  return {(p.x + q.x) / 2, (p.y + q.y) / 2, (p.z + q.z) / 2};
}

/// A point in every item of a bounded set, and beside its facets: vertices, middles of edges, of
/// two middles of a facet, and of what the complex has been made of.
std::vector<RationalPoint3> places(const Nef3& set) {
  const SpaceComplex& c = set.complex();
  std::vector<RationalPoint3> points = vertices(set);
  const std::vector<RationalPoint3> vertex = points;
  for (std::size_t e = 0; e < c.edge_count(); ++e) {
    points.push_back(middle(vertex[c.origin[2 * e].value()], vertex[c.origin[2 * e + 1].value()]));
  }
  for (std::size_t u = 0; u < c.use_count(); ++u) {
    const VertexId before = c.use_origin(c.use_prev[u]), after = c.use_origin(c.use_next[u]);
    const RationalPoint3 chord = middle(vertex[before.value()], vertex[after.value()]);
    points.push_back(middle(chord, vertex[c.use_origin(UseId(u)).value()]));
    points.push_back(plus(chord, {Rational(1, 64), Rational(-1, 64), Rational(1, 128)}));
  }
  return points;
}

}  // namespace

bool is_sum(const Nef3& a, const Nef3& b, const RationalPoint3& x) {
  const AffineMap3 mirror{{{{-1, 0, 0}, {0, -1, 0}, {0, 0, -1}}}, {x.x, x.y, x.z}};
  return !(a * b.transformed(mirror)).is_empty();
}

std::string wrong_place(const Nef3& both, const Nef3& a, const Nef3& b, Dice& dice,
                        std::size_t samples) {
  if (const auto flaw = audit(both.complex(), AuditForm::Minimal))
    return flaw->invariant + " at " + flaw->place;
  std::vector<RationalPoint3> where = places(both);
  for (const RationalPoint3& p : places(a)) where.push_back(plus(p, vertices(b)[0]));
  for (std::size_t i = 0; i < samples; ++i) {
    const RationalPoint3& x = where[dice.below(where.size())];
    if (both.contains(x) == is_sum(a, b, x)) continue;
    return x.x.str() + " " + x.y.str() + " " + x.z.str();
  }
  return {};
}

}  // namespace plumb::testing
