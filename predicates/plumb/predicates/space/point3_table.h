// A table of points of space. A point is an input point or a constructed point. A constructed point
// is the common point of three planes, or the intersection of a plane with a line through two input
// points. The coordinates of a constructed point are not stored, so they are never rounded. The
// table stores the definition of the point and a box of doubles that contains the point. The box
// decides nearly every predicate.
//
// A constructed point takes 45 bytes. Input points take no memory here, because the PlaneTable
// stores them. Several threads may call const members at the same time.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "plumb/predicates/space/plane_table.h"

#pragma GCC visibility push(default)
namespace plumb {

/// An input point or a constructed point, in 32 bits. A default-constructed SpacePoint is not
/// valid.
class SpacePoint {
 public:
  constexpr SpacePoint() = default;
  constexpr explicit SpacePoint(InputPointId p) : code_(p.value()) {}
  /// Returns the constructed point with this index in its Point3Table.
  static constexpr SpacePoint constructed(std::size_t index) {
    SpacePoint p;
    p.code_ = kConstructed | static_cast<std::uint32_t>(index);
    return p;
  }

  constexpr bool is_valid() const { return code_ != ~std::uint32_t{0}; }
  constexpr bool is_input() const { return (code_ & kConstructed) == 0; }
  /// Returns the id of an input point. Requires is_input().
  constexpr InputPointId input() const { return InputPointId(code_); }
  /// Returns the index of a constructed point in its Point3Table. Requires a constructed point.
  constexpr std::size_t index() const { return code_ & ~kConstructed; }
  friend constexpr auto operator<=>(SpacePoint, SpacePoint) = default;

 private:
  static constexpr std::uint32_t kConstructed = std::uint32_t{1} << 31;
  std::uint32_t code_ = ~std::uint32_t{0};
};

/// A cube around a point: each coordinate of the point differs from the same coordinate of mid by
/// at most the radius. The radius may be infinite. It is infinite for every point that depends on
/// the frame, that is, for a point P0 + u R with u not zero. For such a point, mid approximates the
/// direction u if u is known, and otherwise mid is 0. The error of each coordinate of mid is at
/// most kDirectionError times the largest magnitude of the coordinates of u. Each coordinate of mid
/// has the same sign as the corresponding coordinate of u.
struct PointBox {
  std::array<double, 3> mid;  ///< The centre of the cube, or the direction u.
  double radius;              ///< Half of the side length.
};
/// A bound on the error of a direction u in a PointBox. The bound is relative to the largest
/// magnitude of the coordinates of u.
inline constexpr double kDirectionError = 0x1p-30;

/// Whether `box` belongs to a point that depends on the frame and has a known direction u.
inline bool is_far(const PointBox& box) {
  return !(box.radius < std::numeric_limits<double>::infinity()) &&
         (box.mid[0] != 0 || box.mid[1] != 0 || box.mid[2] != 0);
}

/// The definition of a constructed point. It consists of three planes, or of a line through two
/// input points and one plane.
class PointSource {
 public:
  constexpr PointSource() = default;
  constexpr PointSource(PlaneId p, PlaneId q, PlaneId r) : code_{p.value(), q.value(), r.value()} {}
  constexpr PointSource(InputPointId a, InputPointId b, PlaneId p)
      : code_{a.value() | kLine, b.value(), p.value()} {}

  constexpr bool is_line() const { return (code_[0] & kLine) != 0; }
  /// Returns the first (i = 0) or the second (i = 1) input point that defines the line. Requires
  /// is_line().
  constexpr InputPointId end(std::size_t i) const { return InputPointId(code_[i] & ~kLine); }
  /// Returns the number of planes in the definition: one or three.
  constexpr std::size_t plane_count() const { return is_line() ? 1 : 3; }
  constexpr PlaneId plane(std::size_t i) const { return PlaneId(code_[is_line() ? 2 : i]); }
  constexpr bool has_plane(PlaneId p) const {
    return code_[2] == p.value() ||
           (!is_line() && (code_[0] == p.value() || code_[1] == p.value()));
  }
  /// Returns the definition of the same point with other ids. The caller passes two functions:
  /// `plane` returns the new id of a plane, and `input` returns the new id of an input point.
  template <class PlaneMap, class InputMap>
  constexpr PointSource mapped(const PlaneMap& plane, const InputMap& input) const {
    if (is_line()) return {input(end(0)), input(end(1)), plane(this->plane(0))};
    return {plane(this->plane(0)), plane(this->plane(1)), plane(this->plane(2))};
  }

 private:
  static constexpr std::uint32_t kLine = std::uint32_t{1} << 31;
  std::array<std::uint32_t, 3> code_{};
};

/// The constructed points whose definitions refer to one table of planes. The opening comment of
/// this file describes the table.
class Point3Table {
 public:
  /// Constructs an empty table of points. The table of planes must outlive the table of points and
  /// must not be moved. Planes may be added to the table of planes at any time.
  explicit Point3Table(const PlaneTable& planes) : planes_(&planes) {}
  /// Copies the points of `other`. The definitions of the copies refer to `planes`. Requires that
  /// `planes` contains all planes and input points of other.planes() under the same ids.
  Point3Table(const PlaneTable& planes, const Point3Table& other) : Point3Table(other) {
    planes_ = &planes;
  }

  const PlaneTable& planes() const { return *planes_; }
  std::size_t size() const { return boxes_.size(); }
  /// Reserves memory for `points` constructed points, including the points that are already in the
  /// table.
  void reserve(std::size_t points);

  /// Adds the common point of three planes and returns it. If the planes have no common point or
  /// more than one, adds nothing and returns a point that is not valid. Equal points are not
  /// merged; equal() recognizes them. Cost: about 25 ns if a computation in doubles gives a box
  /// whose size is at most 2^-34 times its coordinates. Otherwise the cost is 150 ns for a point on
  /// the line of an edge, and 500 ns for any other point.
  SpacePoint add(PlaneId p, PlaneId q, PlaneId r);
  /// Adds the intersection of the plane with the line through two input points. Returns a point
  /// that is not valid if the line is parallel to the plane or lies in it.
  SpacePoint add(InputPointId a, InputPointId b, PlaneId p);
  /// Adds the point that `source` defines, for example a point from another table. Requires that
  /// the point exists and that `box` contains it. Also requires that `is_nearest` is true only if
  /// the middle of `box` is the point rounded to the nearest doubles.
  SpacePoint add(const PointSource& source, const PointBox& box, bool is_nearest = false);
  /// Adds the constructed points of `other` and copies their boxes. Requires that the planes of
  /// `other` were merged into the table of planes of this table. Plane i of `other` has the id
  /// plane_map[i] in this table, and input point i of `other` has the id i + input_offset. Returns
  /// a number n: the constructed point with index i in `other` has the index i + n in this table.
  std::uint32_t merge(const Point3Table& other, std::span<const PlaneId> plane_map,
                      std::uint32_t input_offset);

  /// Returns the definition of a point. Requires a constructed point.
  const PointSource& source(SpacePoint p) const { return sources_[p.index()]; }
  /// Returns the box around a point. The box of an input point has the point itself as its centre
  /// and radius 0.
  PointBox box(SpacePoint p) const {
    if (!p.is_input()) return boxes_[p.index()];
    const Point3& at = planes_->point(p.input());
    return {{at.x, at.y, at.z}, 0};
  }
  /// Whether the middle of the box is known to be the point rounded to the nearest doubles. If the
  /// result is true and the radius is 0, the middle is the point itself. The result is true for
  /// every input point. It is also true for a constructed point if its box was computed with more
  /// precision than doubles have. For two kinds of such points the result may be false
  /// nevertheless:
  ///   - points that depend on the frame;
  ///   - points with a coordinate that is a double or half-way between two doubles, unless a plane
  ///     or line of the point's definition is orthogonal to the axis of that coordinate.
  bool is_nearest(SpacePoint p) const { return p.is_input() || is_nearest_[p.index()] != 0; }
  /// Returns a box around P0, where P0 + u R is the point p. For a point that does not depend on
  /// the frame, u is 0 and the result is box(p). Cost: about 25 ns for a point that depends on the
  /// frame.
  PointBox near_box(SpacePoint p) const;
  /// Whether one of the planes that define the point belongs to the frame. If so, the coordinates
  /// of the point grow with R.
  bool depends_on_frame(SpacePoint p) const;

 private:
  bool depends_on_frame(const PointSource& source) const;
  SpacePoint add_new(const PointSource& source, const PointBox& fast);

  const PlaneTable* planes_;
  std::vector<PointBox> boxes_;
  std::vector<PointSource> sources_;
  std::vector<std::uint8_t> is_nearest_;
};

}  // namespace plumb
#pragma GCC visibility pop
