// Bounds in doubles and exact nearest points of two simplices (simplex_pair.h).
//
// The bounds: the nearest points in doubles are sought among the pairs of a corner and a simplex,
// and of two edges. Their distance is the upper bound. The lower bound is the gap between the two
// simplices along the direction from one point to the other; it is valid for every direction, so
// nothing has to be proved about the search. Both bounds get a slack for the errors of rounding.
//
// Exact points: the linear systems have at most three unknowns and are solved by Cramer's rule.
// Tested by tests/model/distance_test.cpp.
#include "plumb/model/nearest/simplex_pair.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "plumb/predicates/error.h"

namespace plumb {
namespace {

// ---------------------------------------------------------------- bounds in doubles

using Vector = std::array<double, 3>;

Vector minus(const Vector& a, const Vector& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
Vector along(const Vector& from, double t, const Vector& by) {
  return {from[0] + t * by[0], from[1] + t * by[1], from[2] + t * by[2]};
}
double dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

/// Returns numerator / denominator between 0 and 1, and 0 if the denominator is not positive.
double fraction(double numerator, double denominator) {
  if (!(denominator > 0)) return 0;
  const double t = numerator / denominator;
  return t > 0 ? std::min(t, 1.0) : 0;
}

SimplexFace face_on_edge(double t, std::uint32_t i, std::uint32_t j) {
  if (t == 0) return 1U << i;
  return t == 1 ? 1U << j : 1U << i | 1U << j;
}

/// The nearest pair of points so far.
class NearestInDoubles {
 public:
  NearestInDoubles(const RoundedSimplex& a, const RoundedSimplex& b) : a_(a), b_(b) {
    for (std::uint32_t i = 0; i < a.size; ++i) corner_and_inside(a, i, b, false);
    for (std::uint32_t i = 0; i < b.size; ++i) corner_and_inside(b, i, a, true);
    for (std::uint32_t i = 0; i < edges_of(a); ++i) {
      for (std::uint32_t j = 0; j < edges_of(b); ++j) edges(i, j);
    }
    if (edges_of(a) == 0) corner_and_edges(a, b, false);
    if (edges_of(b) == 0) corner_and_edges(b, a, true);
  }

  DistanceBounds bounds(double slack) const {
    const double upper = std::sqrt(squared_);
    const double lower = upper > 0 ? gap_along(minus(q_, p_), upper) : 0;
    return {std::max(lower - slack, 0.0), upper + slack, face_a_, face_b_, minus(q_, p_)};
  }

 private:
  static std::uint32_t edges_of(const RoundedSimplex& s) { return s.size == 3 ? 3 : s.size - 1; }

  /// Stores a pair of points if it is nearer than the pair so far.
  void take(const Vector& p, SimplexFace face_p, const Vector& q, SimplexFace face_q,
            bool is_swapped) {
    const Vector d = minus(q, p);
    const double squared = dot(d, d);
    if (!(squared < squared_)) return;
    squared_ = squared;
    p_ = p, q_ = q, face_a_ = face_p, face_b_ = face_q;
    if (!is_swapped) return;
    std::swap(p_, q_);
    std::swap(face_a_, face_b_);
  }

  /// Tries a corner of s and the foot of its perpendicular to the triangle t.
  void corner_and_inside(const RoundedSimplex& s, std::uint32_t i, const RoundedSimplex& t,
                         bool is_swapped) {
    if (t.size < 3) return;
    const Vector u = minus(t.corner[1], t.corner[0]), v = minus(t.corner[2], t.corner[0]);
    const Vector w = minus(s.corner[i], t.corner[0]);
    const double uu = dot(u, u), uv = dot(u, v), vv = dot(v, v), uw = dot(u, w), vw = dot(v, w);
    const double det = uu * vv - uv * uv;
    if (!(det > 0)) return;
    const double x = (uw * vv - vw * uv) / det, y = (vw * uu - uw * uv) / det;
    if (!(x > 0 && y > 0 && x + y < 1)) return;
    take(s.corner[i], 1U << i, along(along(t.corner[0], x, u), y, v), 7, is_swapped);
  }

  void corner_and_edges(const RoundedSimplex& s, const RoundedSimplex& t, bool is_swapped) {
    const Vector& p = s.corner[0];
    if (t.size == 1) return take(p, 1, t.corner[0], 1, is_swapped);
    for (std::uint32_t j = 0; j < edges_of(t); ++j) {
      const std::uint32_t k = (j + 1) % t.size;
      const Vector v = minus(t.corner[k], t.corner[j]);
      const double y = fraction(dot(v, minus(p, t.corner[j])), dot(v, v));
      take(p, 1, along(t.corner[j], y, v), face_on_edge(y, j, k), is_swapped);
    }
  }

  /// Tries the nearest points of edge i of the first simplex and edge j of the second simplex.
  void edges(std::uint32_t i, std::uint32_t j) {
    const std::uint32_t i2 = (i + 1) % a_.size, j2 = (j + 1) % b_.size;
    const Vector &p = a_.corner[i], &q = b_.corner[j];
    const Vector u = minus(a_.corner[i2], p), v = minus(b_.corner[j2], q), w = minus(p, q);
    const double uu = dot(u, u), uv = dot(u, v), vv = dot(v, v), uw = dot(u, w), vw = dot(v, w);
    double x = fraction(uv * vw - uw * vv, uu * vv - uv * uv);
    const double y = fraction(uv * x + vw, vv);
    x = fraction(uv * y - uw, uu);
    take(along(p, x, u), face_on_edge(x, i, i2), along(q, y, v), face_on_edge(y, j, j2), false);
  }

  /// Returns how far the second simplex lies beyond the first simplex along a direction.
  double gap_along(const Vector& direction, double length) const {
    const Vector n{direction[0] / length, direction[1] / length, direction[2] / length};
    double high = -std::numeric_limits<double>::infinity();
    double low = std::numeric_limits<double>::infinity();
    for (std::uint32_t i = 0; i < a_.size; ++i) high = std::max(high, dot(n, a_.corner[i]));
    for (std::uint32_t j = 0; j < b_.size; ++j) low = std::min(low, dot(n, b_.corner[j]));
    return low - high;
  }

  const RoundedSimplex& a_;
  const RoundedSimplex& b_;
  double squared_ = std::numeric_limits<double>::infinity();
  Vector p_{};
  Vector q_{};
  SimplexFace face_a_ = 1;
  SimplexFace face_b_ = 1;
};

// ---------------------------------------------------------------- exact points

RationalPoint3 exactly_along(const RationalPoint3& from, const Rational& t,
                             const RationalPoint3& by) {
  return {from.x + t * by.x, from.y + t * by.y, from.z + t * by.z};
}
Rational exact_dot(const RationalPoint3& a, const RationalPoint3& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

/// A system of at most three linear equations with a symmetric matrix.
struct GramSystem {
  std::array<std::array<Rational, 3>, 3> matrix;
  std::array<Rational, 3> right;
  std::uint32_t size = 0;

  /// Replaces unused rows by those of the unit matrix, so that Cramer's rule for three applies.
  void fill_up() {
    for (std::uint32_t i = size; i < 3; ++i) matrix[i][i] = 1;
  }
  static Rational determinant_of(const std::array<std::array<Rational, 3>, 3>& m) {
    return m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) -
           m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
           m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
  }
  /// Returns the solution, or nothing unless there is exactly one.
  std::optional<std::array<Rational, 3>> solution() const {
    const Rational det = determinant_of(matrix);
    if (det == 0) return std::nullopt;
    std::array<Rational, 3> x;
    for (std::uint32_t j = 0; j < size; ++j) {
      auto replaced = matrix;
      for (std::uint32_t i = 0; i < 3; ++i) replaced[i][j] = right[i];
      x[j] = determinant_of(replaced) / det;
    }
    return x;
  }
};

/// A face as a corner, and the directions from this corner to the others.
struct Spanned {
  Spanned(const ExactSimplex& s, SimplexFace face) {
    for (std::uint32_t i = 0; i < s.size; ++i) {
      if ((face >> i & 1U) == 0) continue;
      if (origin == nullptr) {
        origin = &s.corner[i];
        corner[0] = i;
      } else {
        direction[count++] = s.corner[i] - *origin;
        corner[count] = i;
      }
    }
  }
  std::array<std::uint32_t, 3> corner{};
  const RationalPoint3* origin = nullptr;
  std::array<RationalPoint3, 2> direction;
  std::uint32_t count = 0;
};

/// A point, and the face with this point in its relative interior.
struct PointInFace {
  RationalPoint3 at;
  SimplexFace face;
};

/// Returns the point with the given coordinates in a face, or nothing if it lies outside.
std::optional<PointInFace> point_in(const Spanned& face, const Rational* coordinates) {
  PointInFace p{*face.origin, 0};
  Rational left = 1;
  for (std::uint32_t i = 0; i < face.count; ++i) {
    if (coordinates[i].sign() < 0) return std::nullopt;
    if (coordinates[i].is_zero()) continue;
    left -= coordinates[i];
    p.at = exactly_along(p.at, coordinates[i], face.direction[i]);
    p.face |= SimplexFace{1} << face.corner[i + 1];
  }
  if (left.sign() < 0) return std::nullopt;
  if (!left.is_zero()) p.face |= SimplexFace{1} << face.corner[0];
  return p;
}

/// Returns the system whose solution has the coordinates of the nearest points of two faces.
GramSystem system_of(const Spanned& f, const Spanned& g) {
  GramSystem system;
  std::array<RationalPoint3, 3> columns;
  for (std::uint32_t i = 0; i < f.count; ++i) columns[system.size++] = f.direction[i];
  for (std::uint32_t j = 0; j < g.count; ++j) {
    columns[system.size++] = RationalPoint3{0, 0, 0} - g.direction[j];
  }
  const RationalPoint3 w = *g.origin - *f.origin;
  for (std::uint32_t i = 0; i < system.size; ++i) {
    for (std::uint32_t j = i; j < system.size; ++j) {
      system.matrix[i][j] = exact_dot(columns[i], columns[j]);
      system.matrix[j][i] = system.matrix[i][j];
    }
    system.right[i] = exact_dot(columns[i], w);
  }
  system.fill_up();
  return system;
}

/// Whether no corner of `s` lies beyond `p` in the direction n.
bool is_supported(const ExactSimplex& s, const RationalPoint3& p, const RationalPoint3& n) {
  for (std::uint32_t i = 0; i < s.size; ++i) {
    if (exact_dot(n, s.corner[i] - p).sign() > 0) return false;
  }
  return true;
}

std::uint32_t dimension_of(SimplexFace face) {
  return static_cast<std::uint32_t>(std::popcount(face)) - 1;
}

/// Returns the nearest points of the affine hulls of two faces if they are nearest points of the
/// simplices.
std::optional<NearestPoints> nearest_on(const ExactSimplex& a, SimplexFace face_a,
                                        const ExactSimplex& b, SimplexFace face_b) {
  if (dimension_of(face_a) + dimension_of(face_b) > 3) return std::nullopt;
  const Spanned f(a, face_a), g(b, face_b);
  const auto coordinates = system_of(f, g).solution();
  if (!coordinates) return std::nullopt;
  const auto p = point_in(f, coordinates->data());
  if (!p) return std::nullopt;
  const auto q = point_in(g, coordinates->data() + f.count);
  if (!q) return std::nullopt;
  const RationalPoint3 n = q->at - p->at, back = p->at - q->at;
  if (!is_supported(a, p->at, n) || !is_supported(b, q->at, back)) return std::nullopt;
  return NearestPoints{p->at, q->at, exact_dot(n, n), p->face, q->face};
}

}  // namespace

DistanceBounds distance_bounds(const RoundedSimplex& a, const RoundedSimplex& b, double slack) {
  return NearestInDoubles(a, b).bounds(slack);
}

NearestPoints nearest_points(const ExactSimplex& a, SimplexFace guess_a, const ExactSimplex& b,
                             SimplexFace guess_b) {
  const auto all_a = (SimplexFace{1} << a.size) - 1, all_b = (SimplexFace{1} << b.size) - 1;
  if (auto found = nearest_on(a, guess_a, b, guess_b)) return std::move(*found);
  for (std::uint32_t dimensions = 0; dimensions <= 3; ++dimensions) {
    for (SimplexFace f = 1; f <= all_a; ++f) {
      for (SimplexFace g = 1; g <= all_b; ++g) {
        if (dimension_of(f) + dimension_of(g) != dimensions) continue;
        if (auto found = nearest_on(a, f, b, g)) return std::move(*found);
      }
    }
  }
  detail::report_broken_invariant("two simplices have nearest points", __FILE__, __LINE__);
}

}  // namespace plumb
