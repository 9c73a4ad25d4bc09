#include "space/complex_links.h"

#include <algorithm>
#include <set>
#include <vector>

#include "plumb/predicates/point3_signs.h"

namespace plumb::testing {
namespace {

using Vector = RationalPoint3;
Vector operator+(const Vector& a, const Vector& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
Rational dot(const Vector& a, const Vector& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
Vector cross(const Vector& a, const Vector& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

class Checker {
 public:
  explicit Checker(const SpaceComplex& c) : c_(c) {}

  std::string run() {
    check_edges();
    check_uses();
    check_facets();
    check_stars();
    return broken_;
  }

 private:
  void expect(bool holds, const char* law, std::size_t at) {
    if (!holds && broken_.empty()) broken_ = std::string(law) + " at " + std::to_string(at);
  }
  RationalPoint3 at(VertexId v) const { return exact(c_.points(), c_.vertex_point[v.value()]); }
  Vector normal(PlaneId p) const {
    const IntegerRow row = c_.planes().coefficients(p);
    return {Rational(row[0]), Rational(row[1]), Rational(row[2])};
  }
  bool is_on(VertexId v, PlaneId p) const {
    const IntegerRow row = c_.planes().coefficients(p);
    const RationalPoint3 x = at(v);
    return row[0] * x.x + row[1] * x.y + row[2] * x.z + row[3] == 0;
  }
  Vector along(HalfedgeId h) const { return at(c_.target(h)) - at(c_.origin[h.value()]); }

  void check_edges() {
    for (std::size_t e = 0; e < c_.edge_count(); ++e) {
      const HalfedgeId h(2 * e);
      const auto [p, q] = c_.edge_planes[e];
      for (const PlaneId plane : {p, q}) {
        expect(is_on(c_.origin[2 * e], plane) && is_on(c_.origin[2 * e + 1], plane),
               "an edge lies on its planes", e);
      }
      expect(dot(along(h), cross(normal(p), normal(q))) > 0, "2e runs along n_p x n_q", e);
      check_ring(EdgeId(e));
    }
  }

  /// The direction from the edge into the facet.
  Vector into(UseId u) const {
    return cross(normal(c_.facet_plane[c_.use_facet[u.value()].value()]),
                 along(c_.use_halfedge[u.value()]));
  }
  bool in_upper_half(const Vector& d, const Vector& x, const Vector& y) const {
    return dot(d, y) > 0 || (dot(d, y) == 0 && dot(d, x) > 0);
  }

  void check_ring(EdgeId e) {
    const UseId first = c_.edge_use[e.value()];
    expect(first.is_valid(), "an edge has a use", e.value());
    std::vector<UseId> ring;
    UseId u = first;
    do {
      ring.push_back(u);
      expect(SpaceComplex::edge_of(c_.use_halfedge[u.value()]) == e, "a ring is of one edge",
             e.value());
      ++uses_seen_;
      u = c_.use_radial[u.value()];
    } while (u != first && ring.size() <= c_.use_count());
    // In a frame x, y = d x x around the edge, from the first use on, angles ascend.
    const Vector x = into(first), y = cross(along(HalfedgeId(2 * e.value())), x);
    for (std::size_t i = 1; i < ring.size(); ++i) {
      const Vector a = into(ring[i - 1]), b = into(ring[i]);
      const bool upper_a = in_upper_half(a, x, y), upper_b = in_upper_half(b, x, y);
      const Rational turn = dot(a, x) / dot(x, x) * dot(b, y) / dot(y, y) -
                            dot(a, y) / dot(y, y) * dot(b, x) / dot(x, x);
      const bool ascends = upper_a != upper_b ? upper_a : turn >= 0;
      expect(ascends, "uses turn counter-clockwise around 2e", e.value());
    }
  }

  void check_uses() {
    expect(uses_seen_ == c_.use_count(), "every use is in its ring", 0);
    for (std::size_t u = 0; u < c_.use_count(); ++u) {
      const UseId next = c_.use_next[u];
      expect(c_.use_prev[next.value()] == UseId(u), "prev undoes next", u);
      expect(c_.target(c_.use_halfedge[u]) == c_.use_origin(next), "a cycle is a chain", u);
      expect(c_.use_facet[next.value()] == c_.use_facet[u], "a cycle is of one facet", u);
      expect(is_on(c_.use_origin(UseId(u)), c_.facet_plane[c_.use_facet[u].value()]),
             "corners lie on the plane", u);
    }
  }

  void check_facets() {
    std::size_t count = 0;
    for (std::size_t f = 0; f < c_.facet_count(); ++f) {
      Vector area{};
      for (const UseId first : c_.cycles_of(FacetId(f))) {
        UseId u = first;
        do {
          expect(c_.use_facet[u.value()] == FacetId(f), "cycles belong to their facet", f);
          const RationalPoint3 o{};
          const Vector a = at(c_.use_origin(u)) - o;
          area = area + cross(a, at(c_.use_origin(c_.use_next[u.value()])) - o);
          ++count;
          u = c_.use_next[u.value()];
        } while (u != first && count <= c_.use_count());
      }
      expect(dot(area, normal(c_.facet_plane[f])) > 0, "a facet is to the left of its uses", f);
    }
    expect(count == c_.use_count(), "every use is in a cycle", 0);
  }

  void check_stars() {
    std::set<HalfedgeId> seen;
    for (std::size_t v = 0; v < c_.vertex_count(); ++v) {
      for (const HalfedgeId h : c_.star_of(VertexId(v))) {
        expect(c_.origin[h.value()] == VertexId(v) && seen.insert(h).second,
               "a star holds what leaves", v);
      }
    }
    expect(seen.size() == 2 * c_.edge_count(), "every half-edge is in a star", 0);
  }

  const SpaceComplex& c_;
  std::size_t uses_seen_ = 0;
  std::string broken_;
};

}  // namespace

std::string broken_link(const SpaceComplex& complex) { return Checker(complex).run(); }

Rational enclosed_volume(const SpaceComplex& complex, std::span<const std::int32_t> jump) {
  Rational sum = 0;
  const auto at = [&](UseId u) {
    const RationalPoint3 p =
        exact(complex.points(), complex.vertex_point[complex.use_origin(u).value()]);
    return Vector{p.x, p.y, p.z};
  };
  for (std::size_t f = 0; f < complex.facet_count(); ++f) {
    for (const UseId first : complex.cycles_of(FacetId(f))) {
      UseId u = complex.use_next[first.value()];
      for (; complex.use_next[u.value()] != first; u = complex.use_next[u.value()]) {
        sum -= jump[f] * dot(at(first), cross(at(u), at(complex.use_next[u.value()])));
      }
    }
  }
  return sum;
}

}  // namespace plumb::testing
