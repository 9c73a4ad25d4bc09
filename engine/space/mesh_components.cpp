#include "plumb/space/mesh_components.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "plumb/base/union_find.h"
#include "plumb/predicates/point3_signs.h"

namespace plumb {
namespace {

constexpr std::uint32_t kNone = ~std::uint32_t{0};

class Joiner {
 public:
  Joiner(const SpaceComplex& complex, std::span<const std::int32_t> jump)
      : complex_(complex), jump_(jump), classes_(complex.facet_count()) {}

  std::vector<std::uint32_t> run(std::size_t& count) {
    std::vector<UseId> rest;  // of edges that are not plain and balanced
    for (const UseId u : complex_.edge_use) {
      const UseId v = complex_.use_radial[u.value()];
      const bool is_plain = complex_.use_radial[v.value()] == u;  // one facet or two at the edge
      const std::uint32_t f = facet(u), g = facet(v);
      if (is_plain) classes_.unite(f, g);
      if (!is_plain || !is_balanced(u, f, v, g)) rest.push_back(u);
    }
    for (const UseId u : rest) {
      if (!is_plain(u)) unite_unbalanced(u);
    }
    std::uint32_t open = kNone;
    for (const UseId u : rest) open = unite_unbalanced(u, open);
    return numbers(count);
  }

 private:
  std::uint32_t facet(UseId u) const { return complex_.use_facet[u.value()].value(); }

  /// One facet or two at its edge.
  bool is_plain(UseId u) const {
    return complex_.use_radial[complex_.use_radial[u.value()].value()] == u;
  }

  /// Of a plain one, of facets f and g: do two facets rise to the same side? They do at most edges of most meshes.
  bool is_balanced(UseId u, std::uint32_t f, UseId v, std::uint32_t g) const {
    const bool is_one_way = complex_.use_halfedge[u.value()] == complex_.use_halfedge[v.value()];
    return v != u && (is_one_way ? jump_[f] == -jump_[g] : jump_[f] == jump_[g]);
  }

  /// Components that run through the edge more often one way than the other belong together, and to
  /// `one`. Returns one of them.
  std::uint32_t unite_unbalanced(UseId first, std::uint32_t one = kNone) {
    sums_.clear();
    UseId u = first;
    do {
      const std::int32_t jump = jump_[facet(u)];
      const bool is_reverse = SpaceComplex::is_reverse(complex_.use_halfedge[u.value()]);
      sum_of(classes_.root(facet(u))) += is_reverse ? -jump : jump;
      u = complex_.use_radial[u.value()];
    } while (u != first);
    for (const auto& [root, sum] : sums_) {
      if (sum == 0) continue;
      if (one == kNone) one = root;
      classes_.unite(one, root);
    }
    return one;
  }
  std::int32_t& sum_of(std::uint32_t root) {
    for (auto& [r, sum] : sums_) {
      if (r == root) return sum;
    }
    return sums_.emplace_back(root, 0).second;
  }

  std::vector<std::uint32_t> numbers(std::size_t& count) {
    std::vector<std::uint32_t> number(classes_.size(), kNone);
    count = 0;
    for (std::uint32_t f = 0; f < classes_.size(); ++f) {
      const std::uint32_t root = classes_.root(f);
      if (number[root] == kNone) number[root] = static_cast<std::uint32_t>(count++);
      number[f] = number[root];
    }
    return number;
  }

  const SpaceComplex& complex_;
  std::span<const std::int32_t> jump_;
  UnionFind classes_;
  std::vector<std::pair<std::uint32_t, std::int32_t>> sums_;
};

// ---------------------------------------------------------------- volumes

/// Six times the volume of the cone over each facet, from the first corner of its component, summed.
class VolumeSigns {
 public:
  VolumeSigns(const SpaceComplex& complex, std::span<const std::int32_t> jump,
              const MeshComponents& components, std::size_t count)
      : complex_(complex), jump_(jump), component_(components.of_facet), apex_(count) {}

  std::vector<Sign> run() {
    std::vector<Sum> sums(apex_.size());
    for (std::uint32_t f = 0; f < complex_.facet_count(); ++f) add(f, sums[component_[f]]);
    std::vector<Sign> signs;
    bool is_unsure = false;
    for (Sum& s : sums) {
      s.is_sure = std::fabs(s.value) > s.error();  // not where something overflowed
      is_unsure = is_unsure || !s.is_sure;
      signs.push_back(sign_of(s.value));
    }
    if (is_unsure) decide(sums, signs);
    return signs;
  }

 private:
  struct Sum {
    double value = 0;
    double size = 0;   ///< sum of the magnitudes of all products
    double reach = 1;  ///< of differences of coordinates
    double terms = 0;
    bool is_sure = false;
    /// A term is off by less than 12 roundings of its magnitude, each partial sum by one more;
    /// flushed subnormals lose less than 2^-1000 times the square of the reach.
    double error() const { return (terms + 16) * (0x1p-51 * size + 0x1p-990 * reach * reach); }
  };

  UseId first_use(std::uint32_t f) const { return complex_.cycles_of(FacetId(f))[0]; }
  UseId next(UseId u) const { return complex_.use_next[u.value()]; }

  /// Calls visit(a, b, c) for a fan of the facet, canonical side out.
  template <class Visit>
  void for_fan(std::uint32_t f, const Visit& visit) const {
    const UseId first = first_use(f);
    for (UseId u = next(first); next(u) != first; u = next(u)) {
      visit(point(first), point(u), point(next(u)));
    }
  }
  SpacePoint point(UseId u) const { return complex_.vertex_point[complex_.use_origin(u).value()]; }

  SpacePoint apex(std::uint32_t f) {
    SpacePoint& p = apex_[component_[f]];
    if (!p.is_valid()) p = point(first_use(f));
    return p;
  }

  using Vector3 = std::array<double, 3>;

  Vector3 middle(SpacePoint p) const {
    if (!p.is_input()) return complex_.points().box(p).mid;
    const Point3& at = complex_.planes().point(p.input());
    return {at.x, at.y, at.z};
  }

  void add(std::uint32_t f, Sum& sum) {
    const Vector3 o = middle(apex(f));
    const auto from_apex = [&](SpacePoint p) {
      const Vector3 m = middle(p), d{m[0] - o[0], m[1] - o[1], m[2] - o[2]};
      // Constructed points are not what their boxes say.
      if (!p.is_input()) sum.reach = std::numeric_limits<double>::infinity();
      for (const double x : d) sum.reach = std::max(sum.reach, std::fabs(x));
      return d;
    };
    const double times = -jump_[f];
    for_fan(f, [&](SpacePoint p, SpacePoint q, SpacePoint r) {
      const Vector3 a = from_apex(p), b = from_apex(q), c = from_apex(r);
      double value = 0, size = 0;
      for (std::size_t k = 0; k < 3; ++k) {
        const double s = b[(k + 1) % 3] * c[(k + 2) % 3], t = b[(k + 2) % 3] * c[(k + 1) % 3];
        value += a[k] * (s - t);
        size += std::fabs(a[k]) * (std::fabs(s) + std::fabs(t));
      }
      sum.value += times * value;
      sum.size += std::fabs(times) * size;
      sum.terms += 1;
    });
  }

  void decide(const std::vector<Sum>& sums, std::vector<Sign>& signs) const {
    std::vector<Rational> exact(sums.size());
    for (std::uint32_t f = 0; f < complex_.facet_count(); ++f) {
      if (!sums[component_[f]].is_sure) exact[component_[f]] += exact_cone(f);
    }
    for (std::size_t c = 0; c < sums.size(); ++c) {
      if (!sums[c].is_sure) signs[c] = sign_of(exact[c]);
    }
  }

  /// From the origin: the whole is closed.
  Rational exact_cone(std::uint32_t f) const {
    Rational sum;
    for_fan(f, [&](SpacePoint p, SpacePoint q, SpacePoint r) {
      const RationalPoint3 a = exact(complex_.points(), p), b = exact(complex_.points(), q),
                           c = exact(complex_.points(), r);
      sum += a.x * (b.y * c.z - b.z * c.y) + a.y * (b.z * c.x - b.x * c.z) +
             a.z * (b.x * c.y - b.y * c.x);
    });
    return -jump_[f] * sum;
  }

  const SpaceComplex& complex_;
  std::span<const std::int32_t> jump_;
  const std::vector<std::uint32_t>& component_;
  std::vector<SpacePoint> apex_;  // per component
};

}  // namespace

MeshComponents find_components(const SpaceComplex& complex, std::span<const std::int32_t> jump) {
  MeshComponents components;
  std::size_t count = 0;
  components.of_facet = Joiner(complex, jump).run(count);
  components.volume = VolumeSigns(complex, jump, components, count).run();
  return components;
}

}  // namespace plumb
