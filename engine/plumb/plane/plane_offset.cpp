// Offsets of sets of the plane by chains with winding numbers.
//
// Outline is the list of the corners of a loop, with the growing side on the right of its edges. An
// edge from a to b has the normal n = D (d.y, -d.x) / |d|, where d = b - a and D is the distance.
// Let m be the greater one of |d.x| and |d.y|, and r <= 1 the ratio of the lesser one to m. Then
// n = (d.y / m, -d.x / m) D / sqrt(1 + r^2). The quotients are exact, and only the last factor is a
// double. So n is exactly perpendicular to d, edges parallel to an axis are moved exactly, and
// nothing overflows.
//
// Invariant: all points of a join lie, in counter-clockwise order, in the sector from the normal of
// the incoming edge to the normal of the outgoing edge, so that the join is star-shaped around its
// corner and has the winding number 1. The sector spans more than 0 and at most half a turn.
// Positions on arcs are computed with doubles; a position that is not strictly inside the sector is
// left out.
//
// Tested by tests/plane/plane_offset_test.cpp.
#include "plumb/plane/plane_offset.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "plumb/predicates/arithmetic/double_bits.h"
#include "plumb/predicates/arithmetic/elementary.h"
#include "plumb/predicates/error.h"
#include "plumb/predicates/point_table2.h"
#include "plumb/predicates/rounding.h"

namespace plumb {
namespace {

constexpr int kChordsPerCheckpoint = 1024;   // Computing a chord takes some microseconds.
constexpr double kChordsPerDistance = 1e-3;  // This is the default of OffsetOptions::chord_error.
constexpr std::size_t kCornersPerOffsetCheckpoint = 256;
constexpr std::uint64_t kBytesPerOffsetCorner = 120;  // A point has exact coordinates and an index.
// A point has two fractions, with numerators and denominators of one or two limbs.
constexpr std::uint64_t kBytesPerOutlineCorner = 240;

using Vector = RationalPoint2;

Rational cross(const Vector& a, const Vector& b) { return a.x * b.y - a.y * b.x; }
Rational dot(const Vector& a, const Vector& b) { return a.x * b.x + a.y * b.y; }
Vector turned_left(const Vector& a) { return {-a.y, a.x}; }
Vector scaled(const Vector& a, const Rational& s) { return {a.x * s, a.y * s}; }
Vector sum(const Vector& a, const Vector& b) { return {a.x + b.x, a.y + b.y}; }
Rational absolute(const Rational& x) { return x.sign() < 0 ? -x : x; }

/// Returns the vector to the right of d whose length is `distance`.
Vector right_normal(const Vector& d, double distance) {
  const Rational x = absolute(d.x);
  const Rational y = absolute(d.y);
  const Rational& greater = std::max(x, y);
  const double ratio = nearest_double(std::min(x, y) / greater);
  const Rational length =
      exact_rational(distance) * exact_rational(1 / std::sqrt(1 + ratio * ratio));
  return {d.y / greater * length, -d.x / greater * length};
}

/// Returns the angle from a to b in (0, pi]. Requires cross(a, b) > 0, or that the vectors have
/// opposite directions. Both vectors have approximately the length `distance`.
double angle_between(const Vector& a, const Vector& b, double distance) {
  const Rational unit = exact_rational(distance);
  const double ax = nearest_double(a.x / unit), ay = nearest_double(a.y / unit);
  const double bx = nearest_double(b.x / unit), by = nearest_double(b.y / unit);
  const double angle = arc_tangent(ax * by - ay * bx, ax * bx + ay * by);
  return angle > 0 ? angle : std::numbers::pi;
}

/// Makes the joins of convex corners as offsets from the corner.
class Joiner {
 public:
  /// `distance` is positive. `is_turned` states that the set is on the right of the edges.
  Joiner(double distance, bool is_turned, const OffsetOptions& options, Context& context)
      : distance_(distance),
        is_turned_(is_turned),
        options_(options),
        step_(step(distance, options)),
        context_(context) {}

  /// Returns the points of the join between two normals, without the normals.
  std::vector<Vector> join(const Vector& from, const Vector& to) const {
    switch (options_.join) {
      case OffsetJoin::Round:
        if (options_.arc_step > 0) return stepped_arc(from, to, angle_between(from, to, distance_));
        return arc(from, to, angle_between(from, to, distance_));
      case OffsetJoin::Mitre:
        return mitre(from, to);
      case OffsetJoin::Square:
        return square(from, to);
      default:
        return {};
    }
  }

  /// Returns the polygon around an isolated point.
  std::vector<Vector> around_point() const {
    const Rational d = exact_rational(distance_);
    if (options_.join == OffsetJoin::Bevel) return {{d, 0}, {0, d}, {-d, 0}, {0, -d}};
    if (options_.join != OffsetJoin::Round) return {{d, d}, {-d, d}, {-d, -d}, {d, -d}};
    std::vector<Vector> circle;
    const Vector east{d, 0}, west{-d, 0};
    for (const auto& [from, to] : {std::pair(east, west), std::pair(west, east)}) {
      circle.push_back(from);
      const std::vector<Vector> half = arc(from, to, std::numbers::pi);
      circle.insert(circle.end(), half.begin(), half.end());
    }
    return circle;
  }

 private:
  /// Returns the greatest angle of a chord.
  static double step(double distance, const OffsetOptions& options) {
    if (options.arc_step > 0) return options.arc_step;
    if (options.circle_segments != 0) return 2 * std::numbers::pi / options.circle_segments;
    const double error =
        options.chord_error > 0 ? options.chord_error / distance : kChordsPerDistance;
    const double chord = 2 * arc_cosine(std::max(1 - error, 0.5));
    return std::max(chord, 2 * std::numbers::pi / kMostCircleSegments);
  }

  std::vector<Vector> arc(const Vector& from, const Vector& to, double angle) const {
    const int chords = std::max(1, static_cast<int>(std::ceil(angle / step_ * (1 - 0x1p-40))));
    return points_on_arc(from, to, chords, [&](int i) { return angle * i / chords; });
  }
  std::vector<Vector> stepped_arc(const Vector& from, const Vector& to, double angle) const {
    const int chords = std::max(1, static_cast<int>(std::floor(angle / step_ + 0.5)));
    return points_on_arc(from, to, chords, [&](int i) {
      return is_turned_ ? angle - (chords - i) * step_ : i * step_;
    });
  }

  /// Returns the points between the chords. `angle_of(i)` is the angle at which chord i ends.
  template <class AngleOf>
  std::vector<Vector> points_on_arc(const Vector& from, const Vector& to, int chords,
                                    const AngleOf& angle_of) const {
    const Vector up = turned_left(from);
    std::vector<Vector> points;
    MemoryCharge charge(context_);
    for (int i = 1; i < chords; ++i) {
      if (i % kChordsPerCheckpoint == 0) {
        context_.checkpoint("offset", 0, 0);
        charge.add(kChordsPerCheckpoint * kBytesPerOutlineCorner, "the offset");
      }
      const Point2 unit = direction_at(angle_of(i));
      const Vector at =
          sum(scaled(from, exact_rational(unit.x)), scaled(up, exact_rational(unit.y)));
      // Short numbers are used, because half a unit in the last place does not matter on an arc.
      const Vector rounded{exact_rational(nearest_double(at.x)),
                           exact_rational(nearest_double(at.y))};
      const Vector& last = points.empty() ? from : points.back();
      if (cross(last, rounded).sign() > 0 && cross(rounded, to).sign() > 0) {
        points.push_back(rounded);
      }
    }
    return points;
  }

  std::vector<Vector> mitre(const Vector& from, const Vector& to) const {
    const Rational area = cross(from, to);
    if (area.sign() <= 0) return square(from, to);
    // The scalar product of the point with each of the two normals is the square of the length of
    // this normal.
    const Rational a = dot(from, from), b = dot(to, to);
    const Vector tip{(a * to.y - b * from.y) / area, (b * from.x - a * to.x) / area};
    const Rational limit = exact_rational(options_.mitre_limit) * exact_rational(distance_);
    if (dot(tip, tip) > limit * limit) return square(from, to);
    return {tip};
  }

  std::vector<Vector> square(const Vector& from, const Vector& to) const {
    const Rational reach = exact_rational(tangent(angle_between(from, to, distance_) / 4));
    return {sum(from, scaled(turned_left(from), reach)), sum(to, scaled(turned_left(to), -reach))};
  }

  double distance_;
  bool is_turned_;
  OffsetOptions options_;
  double step_;
  Context& context_;
};

/// The closed chains whose winding numbers count the parts that contain a point.
class RawChains {
 public:
  RawChains(const PlaneComplex& complex, double distance, const OffsetOptions& options,
            Context& context)
      : complex_(complex),
        distance_(std::fabs(distance)),
        joiner_(distance_, distance < 0, options, context),
        context_(context),
        charge_(context) {}

  /// Adds the chains of all loops of the faces whose mark is `mark`.
  void add_faces(bool mark) {
    for (std::uint32_t f = 0; f < complex_.face_count(); ++f) {
      if (complex_.mark(FaceId(f)) != mark) continue;
      for (const LoopId l : complex_.dcel.loops_of(FaceId(f))) add_loop(l);
    }
  }
  /// Reverses every chain.
  void reverse() {
    for (std::size_t c = 0; c + 1 < begin_.size(); ++c) {
      std::reverse(corners_.begin() + begin_[c], corners_.begin() + begin_[c + 1]);
    }
  }
  Nef2 enclosed() const {
    return Nef2::polygons(points_, corners_, begin_, WindingRule::Positive, Boundary::Closed,
                          context_);
  }

 private:
  Vector at(VertexId v) const { return exact(complex_.points, complex_.vertex_point[v]); }

  /// The corners of a loop of a face, with the face on the right. Their memory is charged.
  std::vector<Vector> outline(LoopId l, MemoryCharge& charge) const {
    std::vector<Vector> corners;
    for (const HalfedgeId h : complex_.dcel.along(l)) {
      if (corners.size() % kCornersPerOffsetCheckpoint == 0) {
        context_.checkpoint("offset", 0, 0);
        charge.add(kCornersPerOffsetCheckpoint * kBytesPerOutlineCorner, "the offset");
      }
      corners.push_back(at(complex_.dcel.origin(h)));
    }
    std::reverse(corners.begin(), corners.end());
    return corners;
  }

  void add_loop(LoopId l) {
    const Corner first = complex_.dcel.first(l);
    if (first.is_halfedge()) {
      MemoryCharge charge(context_);
      add_outline(outline(l, charge));
    } else {
      for (const Vector& offset : joiner_.around_point()) push(sum(at(first.other()), offset));
    }
    begin_.push_back(static_cast<std::uint32_t>(corners_.size()));
  }

  void add_outline(const std::vector<Vector>& corners) {
    const std::size_t n = corners.size();
    Vector normal = right_normal(corners[0] - corners[n - 1], distance_);
    for (std::size_t i = 0; i < n; ++i) {
      const Vector next = right_normal(corners[i + 1 < n ? i + 1 : 0] - corners[i], distance_);
      push(sum(corners[i], normal));
      add_corner(corners[i], normal, next);
      push(sum(corners[i], next));
      normal = next;
    }
  }

  void add_corner(const Vector& corner, const Vector& from, const Vector& to) {
    const int turn = cross(from, to).sign();
    const bool goes_back = turn == 0 && dot(from, to).sign() < 0;
    if (turn > 0 || goes_back) {
      for (const Vector& offset : joiner_.join(from, to)) push(sum(corner, offset));
    } else if (turn < 0) {
      push(corner);
    }
  }

  void push(const Vector& p) {
    if (corners_.size() % kCornersPerOffsetCheckpoint == 0) {
      context_.checkpoint("offset", 0, 0);
      charge_.add(kCornersPerOffsetCheckpoint * kBytesPerOffsetCorner, "the offset");
    }
    corners_.push_back(static_cast<std::uint32_t>(points_.size()));
    points_.push_back(p.x, p.y);
  }

  const PlaneComplex& complex_;
  double distance_;
  Joiner joiner_;
  Context& context_;
  MemoryCharge charge_;
  PointTable2 points_;
  std::vector<std::uint32_t> corners_;
  std::vector<std::uint32_t> begin_ = {0};
};

void require_options(const Nef2& set, double distance, const OffsetOptions& options) {
  if (!is_finite(distance)) {
    throw Error(ErrorCode::NotFinite, "the distance of an offset must be a finite number");
  }
  if (!(options.mitre_limit >= 1) || !is_finite(options.mitre_limit)) {
    throw Error(ErrorCode::BadArgument, "the mitre limit must be a number of at least 1");
  }
  if (!(options.chord_error >= 0) || !is_finite(options.chord_error)) {
    throw Error(ErrorCode::BadArgument, "the chord error must be a number of at least 0");
  }
  const std::uint32_t segments = options.circle_segments;
  if (segments == 1 || segments == 2 || segments > kMostCircleSegments) {
    throw Error(ErrorCode::BadArgument, "a circle must have from 3 to 1048576 chords");
  }
  const double least_step = 2 * std::numbers::pi / kMostCircleSegments;
  if (options.arc_step != 0 &&
      !(options.arc_step >= least_step && options.arc_step <= std::numbers::pi)) {
    throw Error(ErrorCode::BadArgument, "the step of an arc must be an angle of at most pi");
  }
  if (!set.is_bounded()) {
    throw Error(ErrorCode::BadArgument, "the offset of an unbounded set is not supported");
  }
}

}  // namespace

Nef2 offset(const Nef2& set, double distance, const OffsetOptions& options, Context& context) {
  require_options(set, distance, options);
  const Nef2 closed = set.closure(context);
  if (distance == 0) return closed.regularization(context);
  RawChains chains(closed.complex(), distance, options, context);
  const bool shrinks = distance < 0;
  chains.add_faces(shrinks);
  // The chains around the marked faces bound the complement, which the set must not contain.
  if (shrinks) chains.reverse();
  return chains.enclosed().regularization(context);
}

}  // namespace plumb
