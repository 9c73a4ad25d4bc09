// Points that prove verdicts on sets of space.
//
// Every point is tried before it is returned: the set itself locates it exactly. So the search may
// use roundings and guesses; they decide only whether a witness is found.
//
// A point inside a volume is searched beside a facet: m + s u + s^2 n, where m is the middle of an
// edge of the facet, u points from there into the facet, and n points to the side of the volume.
// For small s the point lies in the volume, because the angle between u and the point's direction
// tends to 0 with s. A segment that leaves the set is searched between two such points at a reflex
// edge. A plane between two sets is found by the iteration of E. G. Gilbert, An iterative procedure
// for computing the minimum of a quadratic form on a convex set, SIAM J. Control 4 (1966), and is
// then shifted and tested exactly. Tested by tests/system/certificates_test.py.
#include "plumb/cli/files/witness.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "plumb/base/ids.h"
#include "plumb/convex/convexity.h"
#include "plumb/predicates/point3_signs.h"
#include "plumb/predicates/rounding.h"
#include "plumb/space/space_complex.h"

namespace plumb::cli {
namespace {

using Vector = RationalPoint3;

constexpr int kHalvings = 64;
constexpr std::size_t kSites = 64;  // The greatest number of places that the search tries.
constexpr std::uint32_t kCheckedUses = 1024;
constexpr int kSteps = 16;  // The number of parts into which a segment is divided.

Vector moved(const Vector& p, const Rational& s, const Vector& v) {
  return {p.x + s * v.x, p.y + s * v.y, p.z + s * v.z};
}

Vector cross_product(const Vector& a, const Vector& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

Rational largest(const Vector& v) {
  const auto size = [](const Rational& x) { return x.sign() < 0 ? -x : x; };
  return std::max({size(v.x), size(v.y), size(v.z)});
}

/// The middle of an edge, a direction into a facet, and a direction away from the facet.
struct Site {
  Vector middle;
  Vector inward;
  Vector off;

  Vector at(const Rational& s) const { return moved(moved(middle, s, inward), s * s, off); }
};

/// Searches for witnesses in one set.
class WitnessSearch {
 public:
  WitnessSearch(const Nef3& set, Context& context)
      : set_(set), complex_(set.complex()), context_(context) {}

  std::optional<Vector> inner_point() {
    for (const Site& site : volume_sites(1)) {
      if (auto p = beside(site)) return simplest(std::move(*p));
    }
    return std::nullopt;
  }

  std::optional<LeavingSegment> leaving_segment() {
    for (const EdgeId e : first(reflex_edges(complex_))) {
      if (auto segment = across(e)) return segment;
    }
    return between_volumes();
  }

 private:
  static std::vector<EdgeId> first(std::vector<EdgeId> edges) {
    edges.resize(std::min(edges.size(), kSites));
    return edges;
  }

  bool is_at(const Vector& p, bool is_marked) const {
    const SpaceLocation place = set_.locate(p, context_);
    return place.item.kind() == SpaceItem::Kind::Volume && place.marked == is_marked;
  }

  bool is_finite(UseId u) const {
    const HalfedgeId h = complex_.use_halfedge[u];
    const auto depends = [&](VertexId v) {
      return complex_.points().depends_on_frame(complex_.vertex_point[v]);
    };
    return !depends(complex_.origin[h]) && !depends(complex_.target(h));
  }

  Vector place(VertexId v) const { return exact(complex_.points(), complex_.vertex_point[v]); }

  /// Returns the site at a use; `side` is 0 for the positive side of the facet and 1 for the other.
  Site site_of(UseId u, int side) const {
    const HalfedgeId h = complex_.use_halfedge[u];
    const Vector from = place(complex_.origin[h]);
    const Vector along = place(complex_.target(h)) - from;
    const IntegerRow row =
        complex_.planes().coefficients(complex_.facet_plane[complex_.use_facet[u]]);
    const Vector n{Rational(row[0]), Rational(row[1]), Rational(row[2])};
    const Rational scale = 1 / largest(n);
    const Rational length = largest(along) * (side == 0 ? 1 : -1);
    const Vector none;
    return {moved(from, Rational(1) / 2, along), moved(none, scale, cross_product(n, along)),
            moved(none, scale * length, n)};
  }

  /// Returns the first sites beside marked volumes, at most `each` for each volume.
  std::vector<Site> volume_sites(std::uint32_t each) const {
    IdVector<VolumeId, std::uint32_t> count(complex_.volume_count(), 0);
    std::vector<Site> sites;
    for (std::uint32_t i = 0; i < complex_.use_count() && sites.size() < kSites; ++i) {
      if (i % kCheckedUses == 0) context_.checkpoint("witness", i, complex_.use_count());
      const UseId u(i);
      if (!is_finite(u)) continue;
      const auto& volumes = complex_.facet_volume[complex_.use_facet[u]];
      for (int side = 0; side < 2; ++side) {
        const VolumeId volume = volumes[static_cast<std::size_t>(side)];
        if (complex_.volume_mark[volume] != 1 || count[volume] == each) continue;
        ++count[volume];
        sites.push_back(site_of(u, side));
      }
    }
    return sites;
  }

  /// Returns a point of the set beside the site.
  std::optional<Vector> beside(const Site& site) const {
    Rational s = Rational(1) / 4;
    for (int i = 0; i < kHalvings; ++i, s /= 2) {
      Vector p = site.at(s);
      if (is_at(p, true)) return p;
    }
    return std::nullopt;
  }

  /// Returns a point with short coordinates near an inner point if there is one. Otherwise, returns
  /// the inner point.
  Vector simplest(Vector p) const {
    const std::array<double, 3> near{nearest_double(p.x), nearest_double(p.y), nearest_double(p.z)};
    for (int bits = 2; bits <= 52; bits += 5) {
      const auto rounded = [bits](double x) {
        int exponent = 0;
        const double fraction = std::frexp(x, &exponent);
        return std::ldexp(std::nearbyint(std::ldexp(fraction, bits)), exponent - bits);
      };
      Vector q{Rational(rounded(near[0])), Rational(rounded(near[1])), Rational(rounded(near[2]))};
      if (is_at(q, true)) return q;
    }
    return p;
  }

  /// Returns a point of the segment that lies outside of the set.
  std::optional<Vector> exit_between(const Vector& a, const Vector& b) const {
    for (int i = 1; i < kSteps; ++i) {
      Vector p = moved(a, Rational(i) / kSteps, b - a);
      if (is_at(p, false)) return p;
    }
    return std::nullopt;
  }

  std::optional<LeavingSegment> across(EdgeId e) const {
    const UseId start = complex_.edge_use[e];
    if (!start.is_valid() || !is_finite(start)) return std::nullopt;
    UseId u = start;
    do {
      const UseId next = complex_.use_radial[u];
      if (complex_.volume_mark[complex_.volume_after(u)] == 1) {
        if (auto segment = across(u, next)) return segment;
      }
      u = next;
    } while (u != start);
    return std::nullopt;
  }

  /// Searches near an edge, between points beside the two facets that bound a volume there.
  std::optional<LeavingSegment> across(UseId u, UseId next) const {
    const int side = SpaceComplex::is_reverse(complex_.use_halfedge[u]) ? 1 : 0;
    const int next_side = SpaceComplex::is_reverse(complex_.use_halfedge[next]) ? 0 : 1;
    const Site site = site_of(u, side);
    const Site next_site = site_of(next, next_side);
    Rational s = Rational(1) / 4;
    for (int i = 0; i < kHalvings; ++i, s /= 2) {
      Vector a = site.at(s);
      Vector b = next_site.at(s);
      if (!is_at(a, true) || !is_at(b, true)) continue;
      if (auto p = exit_between(a, b)) return LeavingSegment{std::move(a), std::move(b), *p};
    }
    return std::nullopt;
  }

  std::optional<LeavingSegment> between_volumes() const {
    std::vector<Vector> points;
    for (const Site& site : volume_sites(2)) {
      if (auto p = beside(site)) points.push_back(std::move(*p));
    }
    for (std::size_t i = 1; i < points.size(); ++i) {
      if (auto p = exit_between(points[0], points[i])) {
        return LeavingSegment{points[0], points[i], *p};
      }
    }
    return std::nullopt;
  }

  const Nef3& set_;
  const SpaceComplex& complex_;
  Context& context_;
};

// ---------------------------------------------------------------- separating planes

using Doubles = std::array<double, 3>;

constexpr int kIterations = 1000;

double product(const Doubles& a, const Doubles& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

Rational product(const Vector& a, const Vector& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

std::vector<Vector> vertices_of(const Nef3& set, Context& context) {
  const SpaceComplex& complex = set.complex();
  std::vector<Vector> points;
  for (const SpacePoint p : complex.vertex_point) {
    context.checkpoint("separate", points.size(), 0);
    points.push_back(exact(complex.points(), p));
  }
  return points;
}

std::vector<Doubles> rounded(const std::vector<Vector>& points) {
  std::vector<Doubles> all;
  for (const Vector& p : points) {
    all.push_back({nearest_double(p.x), nearest_double(p.y), nearest_double(p.z)});
  }
  return all;
}

/// Returns the point that is farthest in a direction.
Doubles support(const std::vector<Doubles>& points, const Doubles& direction, double sign) {
  return *std::max_element(points.begin(), points.end(), [&](const Doubles& p, const Doubles& q) {
    return sign * product(p, direction) < sign * product(q, direction);
  });
}

/// Returns an approximation of the vector between the nearest points of the convex hulls of b and
/// a.
Doubles nearest_difference(const std::vector<Doubles>& a, const std::vector<Doubles>& b,
                           Context& context) {
  Doubles v{b[0][0] - a[0][0], b[0][1] - a[0][1], b[0][2] - a[0][2]};
  for (std::uint64_t i = 0; i < kIterations; ++i) {
    context.checkpoint("separate", i, kIterations);
    const Doubles p = support(b, v, -1);
    const Doubles q = support(a, v, 1);
    const Doubles w{p[0] - q[0], p[1] - q[1], p[2] - q[2]};
    const Doubles step{w[0] - v[0], w[1] - v[1], w[2] - v[2]};
    const double length = product(step, step);
    const double descent = -product(v, step);
    if (product(v, w) > 0.5 * product(v, v) || !(descent > 0) || !(length > 0)) break;
    const double t = std::min(1.0, descent / length);
    for (std::size_t k = 0; k < 3; ++k) v[k] += t * step[k];
  }
  return v;
}

/// Returns the plane with this normal in the middle between two sets of points, if it separates
/// them.
std::optional<SeparatingPlane> plane_between(const std::vector<Vector>& a,
                                             const std::vector<Vector>& b, const Vector& normal) {
  Rational below = product(a[0], normal);
  for (const Vector& p : a) below = std::max(below, product(p, normal));
  Rational above = product(b[0], normal);
  for (const Vector& p : b) above = std::min(above, product(p, normal));
  if (!(below < above)) return std::nullopt;
  return SeparatingPlane{normal, -(below + above) / 2};
}

}  // namespace

std::optional<RationalPoint3> inner_point(const Nef3& set, Context& context) {
  return WitnessSearch(set, context).inner_point();
}

std::optional<LeavingSegment> leaving_segment(const Nef3& set, Context& context) {
  return WitnessSearch(set, context).leaving_segment();
}

std::optional<SeparatingPlane> separating_plane(const Nef3& a, const Nef3& b, Context& context) {
  if (a.is_empty() || b.is_empty() || !a.is_bounded() || !b.is_bounded()) return std::nullopt;
  const std::vector<Vector> of_a = vertices_of(a, context);
  const std::vector<Vector> of_b = vertices_of(b, context);
  const Doubles v = nearest_difference(rounded(of_a), rounded(of_b), context);
  if (!std::isfinite(product(v, v))) return std::nullopt;
  return plane_between(of_a, of_b, {Rational(v[0]), Rational(v[1]), Rational(v[2])});
}

}  // namespace plumb::cli
