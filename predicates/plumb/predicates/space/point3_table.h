// Points of space with their provenance: an input point, an input line through a plane, or the
// common point of three planes. Coordinates are never rounded, because none are kept: a point is
// its definition, plus a cached box in doubles that decides nearly every question.
//
// 45 bytes a constructed point. Input points cost nothing: they live in the PlaneTable.
// Const members may be called from many threads at once.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "plumb/predicates/space/plane_table.h"

#pragma GCC visibility push(default)
namespace plumb {

/// An input point or a constructed one, in 32 bits. Default-constructed: no point.
class SpacePoint {
 public:
  constexpr SpacePoint() = default;
  constexpr explicit SpacePoint(InputPointId p) : code_(p.value()) {}
  static constexpr SpacePoint constructed(std::size_t index) {
    SpacePoint p;
    p.code_ = kConstructed | static_cast<std::uint32_t>(index);
    return p;
  }

  constexpr bool is_valid() const { return code_ != ~std::uint32_t{0}; }
  constexpr bool is_input() const { return (code_ & kConstructed) == 0; }
  /// Requires is_input().
  constexpr InputPointId input() const { return InputPointId(code_); }
  /// Requires a constructed point: its number in the Point3Table.
  constexpr std::size_t index() const { return code_ & ~kConstructed; }
  friend constexpr auto operator<=>(SpacePoint, SpacePoint) = default;

 private:
  static constexpr std::uint32_t kConstructed = std::uint32_t{1} << 31;
  std::uint32_t code_ = ~std::uint32_t{0};
};

/// |coordinate - mid| <= radius for each of the three; the radius may be infinite, and is for every
/// point P0 + u R that depends on the frame. There mid is u, if that is known: each coordinate is
/// off by at most kDirectionError max |u| and has the sign of u's; else 0.
struct PointBox {
  std::array<double, 3> mid;
  double radius;
};
inline constexpr double kDirectionError = 0x1p-30;

/// Is it the box of a point of the frame with a known u?
inline bool is_far(const PointBox& box) {
  return !(box.radius < std::numeric_limits<double>::infinity()) &&
         (box.mid[0] != 0 || box.mid[1] != 0 || box.mid[2] != 0);
}

/// Three planes, or a line of two input points and a plane.
class PointSource {
 public:
  constexpr PointSource() = default;
  constexpr PointSource(PlaneId p, PlaneId q, PlaneId r) : code_{p.value(), q.value(), r.value()} {}
  constexpr PointSource(InputPointId a, InputPointId b, PlaneId p)
      : code_{a.value() | kLine, b.value(), p.value()} {}

  constexpr bool is_line() const { return (code_[0] & kLine) != 0; }
  /// Requires is_line(): i = 0, 1.
  constexpr InputPointId end(std::size_t i) const { return InputPointId(code_[i] & ~kLine); }
  /// Planes the point lies on by definition: one or three.
  constexpr std::size_t plane_count() const { return is_line() ? 1 : 3; }
  constexpr PlaneId plane(std::size_t i) const { return PlaneId(code_[is_line() ? 2 : i]); }
  constexpr bool has_plane(PlaneId p) const {
    return code_[2] == p.value() ||
           (!is_line() && (code_[0] == p.value() || code_[1] == p.value()));
  }
  /// The same point under other ids: plane(PlaneId) -> PlaneId, input(InputPointId) ->
  /// InputPointId.
  template <class PlaneMap, class InputMap>
  constexpr PointSource mapped(const PlaneMap& plane, const InputMap& input) const {
    if (is_line()) return {input(end(0)), input(end(1)), plane(this->plane(0))};
    return {plane(this->plane(0)), plane(this->plane(1)), plane(this->plane(2))};
  }

 private:
  static constexpr std::uint32_t kLine = std::uint32_t{1} << 31;
  std::array<std::uint32_t, 3> code_{};
};

class Point3Table {
 public:
  /// The planes must outlive the table and stay where they are; planes may be added at any time.
  explicit Point3Table(const PlaneTable& planes) : planes_(&planes) {}
  /// The same points on a table that has all the planes and input points of the other under the
  /// same ids.
  Point3Table(const PlaneTable& planes, const Point3Table& other) : Point3Table(other) {
    planes_ = &planes;
  }

  const PlaneTable& planes() const { return *planes_; }
  std::size_t size() const { return boxes_.size(); }
  void reserve(std::size_t points);

  /// The common point. Not valid (and nothing added) when the planes have none or many.
  /// Equal points are not merged: ask equal(). Cost: ~25 ns; when doubles do not give the
  /// box to 2^-34 of its coordinates, ~150 ns on the line of an edge and ~500 ns else.
  SpacePoint add(PlaneId p, PlaneId q, PlaneId r);
  /// Where the line of two input points meets the plane. Not valid when it does not, or lies in it.
  SpacePoint add(InputPointId a, InputPointId b, PlaneId p);
  /// A point known to exist, a box that holds it, and is_nearest() of it: one that moves from
  /// another table.
  SpacePoint add(const PointSource& source, const PointBox& box, bool is_nearest = false);
  /// Adds the points of a table whose planes were merged into ours: its plane i is plane_map[i],
  /// its input point i is i + input_offset. Its constructed point i becomes i + the result. Boxes
  /// are copied.
  std::uint32_t merge(const Point3Table& other, std::span<const PlaneId> plane_map,
                      std::uint32_t input_offset);

  /// Requires a constructed point.
  const PointSource& source(SpacePoint p) const { return sources_[p.index()]; }
  /// The box; of an input point: itself, radius 0.
  PointBox box(SpacePoint p) const {
    if (!p.is_input()) return boxes_[p.index()];
    const Point3& at = planes_->point(p.input());
    return {{at.x, at.y, at.z}, 0};
  }
  /// Is the box's mid known to be the nearest doubles (and with a radius of 0 the point itself)? It
  /// is where doubles did not give the box, but for points of the frame, and but for coordinates
  /// that are doubles or half-way and of which no plane or line tells so.
  bool is_nearest(SpacePoint p) const { return p.is_input() || is_nearest_[p.index()] != 0; }
  /// Around P0, the point with 0 for R; of a point without R its box. Cost: ~25 ns if there is R.
  PointBox near_box(SpacePoint p) const;
  /// Is one of the planes that define it of the frame? (Its coordinates then grow with R.)
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
