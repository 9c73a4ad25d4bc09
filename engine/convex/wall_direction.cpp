#include "plumb/convex/wall_direction.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

#include "plumb/convex/convexity.h"
#include "plumb/predicates/plane_signs.h"
#include "plumb/predicates/rounding.h"

namespace plumb {
namespace {

constexpr std::size_t kMaxEdges = 1500;     // compared with each other
constexpr std::size_t kMaxCandidates = 12;  // besides the axes
constexpr unsigned kMaxBits = 64;  // of a direction's coordinates: they lengthen every wall's

using Vector2 = std::array<double, 2>;

/// Coprime, the first that is not zero positive; false: zero, or too long.
bool normalise(VerticalDirection& v) {
  Integer common = gcd(gcd(v[0], v[1]), v[2]);
  if (common == 0) return false;
  const auto leading = std::find_if(v.begin(), v.end(), [](const Integer& x) { return x != 0; });
  if (*leading < 0) common = -common;
  for (Integer& x : v) {
    x /= common;
    if (x != 0 && msb(abs(x)) >= kMaxBits) return false;
  }
  return true;
}

class DirectionChoice {
 public:
  DirectionChoice(const SpaceComplex& complex, Context& context) : c_(complex), context_(context) {
    find_reflex_edges();
  }

  VerticalChoice run() {
    std::vector<VerticalDirection> candidates{{0, 0, 1}, {0, 1, 0}, {1, 0, 0}};
    add_shared(edge_directions(), candidates);
    add_shared(normals(), candidates);
    std::size_t best = 0;
    double least = -1;
    for (std::size_t i = 0; i < candidates.size(); ++i) {
      const double pieces = expected_pieces(candidates[i]);
      if (least >= 0 && pieces >= least) continue;
      least = pieces;
      best = i;
    }
    return {candidates[best], least};
  }

 private:
  using Counts = std::map<VerticalDirection, std::size_t>;

  void find_reflex_edges() {
    edges_ = reflex_edges(c_);
    if (edges_.size() <= kMaxEdges) return;
    std::vector<EdgeId> sample;
    for (std::size_t i = 0; i < kMaxEdges; ++i) {
      sample.push_back(edges_[i * edges_.size() / kMaxEdges]);
    }
    edges_ = std::move(sample);
  }

  Counts edge_directions() const {
    Counts counts;
    for (const EdgeId e : edges_) {
      const auto& [p, q] = c_.edge_planes[e.value()];
      const IntegerRow m = c_.planes().coefficients(p), n = c_.planes().coefficients(q);
      VerticalDirection d{m[1] * n[2] - m[2] * n[1], m[2] * n[0] - m[0] * n[2],
                          m[0] * n[1] - m[1] * n[0]};
      if (normalise(d)) ++counts[d];
    }
    return counts;
  }

  Counts normals() const {
    Counts counts;
    for (const EdgeId e : edges_) {
      for (const PlaneId p : c_.edge_planes[e.value()]) {
        const IntegerRow n = c_.planes().coefficients(p);
        VerticalDirection d{n[0], n[1], n[2]};
        if (normalise(d)) ++counts[d];
      }
    }
    return counts;
  }

  /// The most frequent first.
  static void add_shared(const Counts& counts, std::vector<VerticalDirection>& candidates) {
    std::vector<std::pair<std::size_t, const VerticalDirection*>> order;
    for (const auto& [direction, count] : counts) {
      if (count > 1) order.emplace_back(count, &direction);
    }
    std::stable_sort(order.begin(), order.end(),
                     [](const auto& x, const auto& y) { return x.first > y.first; });
    for (std::size_t i = 0; i < order.size() && i < kMaxCandidates / 2; ++i) {
      if (std::find(candidates.begin(), candidates.end(), *order[i].second) == candidates.end()) {
        candidates.push_back(*order[i].second);
      }
    }
  }

  // ---- what a direction costs

  struct Shadow {
    Vector2 from, to;
  };

  double expected_pieces(const VerticalDirection& up) const {
    std::size_t axis = 0;
    for (std::size_t i = 1; i < 3; ++i) {
      if (abs(up[i]) > abs(up[axis])) axis = i;
    }
    const auto slope = [&](std::size_t i) {
      return nearest_double(Rational(up[(axis + 1 + i) % 3], up[axis]));
    };
    const Vector2 slopes{slope(0), slope(1)};
    const auto shadow = [&](VertexId v) {
      const auto at = c_.points().box(c_.vertex_point[v.value()]).mid;
      return Vector2{at[(axis + 1) % 3] - slopes[0] * at[axis],
                     at[(axis + 2) % 3] - slopes[1] * at[axis]};
    };
    std::vector<Shadow> shadows;
    double pieces = 1;
    for (const EdgeId e : edges_) {
      const std::uint32_t h = 2 * e.value();
      pieces += 1;
      if (is_along(e, up)) continue;
      pieces += 0.5;  // it may be cut into two walls, and its ends make vertical edges
      shadows.push_back({shadow(c_.origin[h]), shadow(c_.origin[h + 1])});
    }
    for (std::size_t i = 0; i < shadows.size(); ++i) {
      if (i % 64 == 0) context_.checkpoint("choosing a vertical", i, shadows.size());
      for (std::size_t j = 0; j < i; ++j) pieces += cross(shadows[i], shadows[j]) ? 1 : 0;
    }
    return pieces;
  }

  bool is_along(EdgeId e, const VerticalDirection& up) const {
    const auto holds = [&](PlaneId p) {
      const IntegerRow n = c_.planes().coefficients(p);
      return n[0] * up[0] + n[1] * up[1] + n[2] * up[2] == 0;
    };
    return holds(c_.edge_planes[e.value()][0]) && holds(c_.edge_planes[e.value()][1]);
  }

  static double turn(const Vector2& a, const Vector2& b, const Vector2& c) {
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
  }
  static bool cross(const Shadow& s, const Shadow& t) {
    return turn(s.from, s.to, t.from) * turn(s.from, s.to, t.to) < 0 &&
           turn(t.from, t.to, s.from) * turn(t.from, t.to, s.to) < 0;
  }

  const SpaceComplex& c_;
  Context& context_;
  std::vector<EdgeId> edges_;
};

}  // namespace

VerticalChoice choose_vertical(const SpaceComplex& complex, Context& context) {
  return DirectionChoice(complex, context).run();
}

}  // namespace plumb
