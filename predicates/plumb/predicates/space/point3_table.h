// Points of space with their definition: an input point, the point where a line through two input
// points meets a plane, or the common point of three planes. Coordinates are never rounded, because
// none are kept: a point is its definition, and a box of doubles around it decides nearly every
// question.
//
// A constructed point takes 45 bytes. Input points cost nothing, as the PlaneTable has them.
// Const members may be called from several threads at once.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "plumb/predicates/space/plane_table.h"

#pragma GCC visibility push(default)
namespace plumb {

/// An input point or a constructed one, in 32 bits. A default-constructed one is no point.
class SpacePoint {
 public:
  constexpr SpacePoint() = default;
  constexpr explicit SpacePoint(InputPointId p) : code_(p.value()) {}
  /// Returns the constructed point with this number in its Point3Table.
  static constexpr SpacePoint constructed(std::size_t index) {
    SpacePoint p;
    p.code_ = kConstructed | static_cast<std::uint32_t>(index);
    return p;
  }

  constexpr bool is_valid() const { return code_ != ~std::uint32_t{0}; }
  constexpr bool is_input() const { return (code_ & kConstructed) == 0; }
  /// Returns the id of an input point. Requires is_input().
  constexpr InputPointId input() const { return InputPointId(code_); }
  /// Returns the number of a constructed point in its Point3Table. Requires a constructed point.
  constexpr std::size_t index() const { return code_ & ~kConstructed; }
  friend constexpr auto operator<=>(SpacePoint, SpacePoint) = default;

 private:
  static constexpr std::uint32_t kConstructed = std::uint32_t{1} << 31;
  std::uint32_t code_ = ~std::uint32_t{0};
};

/// A cube around a point: |coordinate - mid| <= radius for each of the three. The radius may be
/// infinite, and is for every point P0 + u R that depends on the frame. There mid is u if that is
/// known: each of its coordinates is off by at most kDirectionError max |u| and has the sign of
/// u's. If it is not known, mid is 0.
struct PointBox {
  std::array<double, 3> mid;  ///< The middle, or the direction u.
  double radius;              ///< Half of the side.
};
/// The error of a direction u in a PointBox, relative to its largest coordinate.
inline constexpr double kDirectionError = 0x1p-30;

/// Whether it is the box of a point that depends on the frame, with a known u.
inline bool is_far(const PointBox& box) {
  return !(box.radius < std::numeric_limits<double>::infinity()) &&
         (box.mid[0] != 0 || box.mid[1] != 0 || box.mid[2] != 0);
}

/// The definition of a constructed point: three planes, or a line of two input points and a plane.
class PointSource {
 public:
  constexpr PointSource() = default;
  constexpr PointSource(PlaneId p, PlaneId q, PlaneId r) : code_{p.value(), q.value(), r.value()} {}
  constexpr PointSource(InputPointId a, InputPointId b, PlaneId p)
      : code_{a.value() | kLine, b.value(), p.value()} {}

  constexpr bool is_line() const { return (code_[0] & kLine) != 0; }
  /// Returns point i of the line, i = 0 or 1. Requires is_line().
  constexpr InputPointId end(std::size_t i) const { return InputPointId(code_[i] & ~kLine); }
  /// Returns the number of planes on which the point lies by definition: one or three.
  constexpr std::size_t plane_count() const { return is_line() ? 1 : 3; }
  constexpr PlaneId plane(std::size_t i) const { return PlaneId(code_[is_line() ? 2 : i]); }
  constexpr bool has_plane(PlaneId p) const {
    return code_[2] == p.value() ||
           (!is_line() && (code_[0] == p.value() || code_[1] == p.value()));
  }
  /// Returns the same point under other ids: plane(PlaneId) -> PlaneId and input(InputPointId) ->
  /// InputPointId give them.
  template <class PlaneMap, class InputMap>
  constexpr PointSource mapped(const PlaneMap& plane, const InputMap& input) const {
    if (is_line()) return {input(end(0)), input(end(1)), plane(this->plane(0))};
    return {plane(this->plane(0)), plane(this->plane(1)), plane(this->plane(2))};
  }

 private:
  static constexpr std::uint32_t kLine = std::uint32_t{1} << 31;
  std::array<std::uint32_t, 3> code_{};
};

/// The constructed points of space over a table of planes. See the head of this file.
class Point3Table {
 public:
  /// Makes an empty table. The table of planes must outlive it and stay where it is; planes may be
  /// added at any time.
  explicit Point3Table(const PlaneTable& planes) : planes_(&planes) {}
  /// Copies the points of `other` onto another table of planes. Requires that this has all planes
  /// and input points of the other's under the same ids.
  Point3Table(const PlaneTable& planes, const Point3Table& other) : Point3Table(other) {
    planes_ = &planes;
  }

  const PlaneTable& planes() const { return *planes_; }
  std::size_t size() const { return boxes_.size(); }
  /// Reserves memory for so many constructed points in all.
  void reserve(std::size_t points);

  /// Adds the common point of three planes and returns it. Returns a point that is not valid, and
  /// adds nothing, if the planes have no common point or more than one. Equal points are not
  /// merged; equal() finds them. Cost: about 25 ns; where doubles do not give the box to 2^-34 of
  /// its coordinates, 150 ns on the line of an edge and 500 ns elsewhere.
  SpacePoint add(PlaneId p, PlaneId q, PlaneId r);
  /// Adds the point where the line of two input points meets the plane. Returns a point that is not
  /// valid if it does not meet it or lies in it.
  SpacePoint add(InputPointId a, InputPointId b, PlaneId p);
  /// Adds a point that comes from another table. Requires that it exists, that the box contains it,
  /// and that is_nearest() is right for the box.
  SpacePoint add(const PointSource& source, const PointBox& box, bool is_nearest = false);
  /// Adds the points of a table whose planes were merged into those of this table: its plane i is
  /// plane_map[i], its input point i is i + input_offset. Returns the offset by which its
  /// constructed points are renumbered. Boxes are copied.
  std::uint32_t merge(const Point3Table& other, std::span<const PlaneId> plane_map,
                      std::uint32_t input_offset);

  /// Returns the definition of a point. Requires a constructed point.
  const PointSource& source(SpacePoint p) const { return sources_[p.index()]; }
  /// Returns the box around a point. That of an input point is the point itself with radius 0.
  PointBox box(SpacePoint p) const {
    if (!p.is_input()) return boxes_[p.index()];
    const Point3& at = planes_->point(p.input());
    return {{at.x, at.y, at.z}, 0};
  }
  /// Whether the middle of the box is known to be the point's nearest doubles (and with a radius of
  /// 0 the point itself). It is so where plain doubles did not give the box, except for points that
  /// depend on the frame, and for those with a coordinate that is a double, or half-way between
  /// two, where no plane or line of the definition states that coordinate.
  bool is_nearest(SpacePoint p) const { return p.is_input() || is_nearest_[p.index()] != 0; }
  /// Returns a box around P0, the point with 0 for R. That of a point without R is its box. Cost:
  /// about 25 ns for a point with R.
  PointBox near_box(SpacePoint p) const;
  /// Whether one of the planes that define the point is of the frame, so that its coordinates grow
  /// with R.
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
