// Points of a plane as algorithms on them ask: by index, exact, whatever they are held as.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "plumb/predicates/point3_signs.h"
#include "plumb/predicates/point_table2.h"
#include "plumb/predicates/sign.h"
#include "plumb/predicates/space/rounded_point3.h"

#pragma GCC visibility push(default)
namespace plumb {

class PlanarPoints {
 public:
  virtual std::uint32_t size() const = 0;
  /// Positive: i, j, k turn left.
  virtual Sign orient(std::uint32_t i, std::uint32_t j, std::uint32_t k) const = 0;
  /// Lexicographic order, x first.
  virtual Sign compare(std::uint32_t i, std::uint32_t j) const = 0;
  /// For i, j, k counter-clockwise. Positive: l inside their circle.
  virtual Sign incircle(std::uint32_t i, std::uint32_t j, std::uint32_t k,
                        std::uint32_t l) const = 0;

 protected:
  ~PlanarPoints() = default;
};

// Points of space seen along a coordinate axis, as points of the plane: where questions about
// points of one plane are asked.

/// The axis to look along, and from which side.
struct FlatView {
  std::size_t axis = 2;
  bool is_mirrored = false;  ///< from -axis: counter-clockwise there is counter-clockwise here

  /// Looks onto the positive side of the (canonical) plane: along the axis that its normal is
  /// nearest to. Orientations of its points then have the signs seen from its positive side.
  static FlatView of_plane(const PlaneTable& planes, PlaneId plane);
  /// The coordinate of space that is x (0) or y (1) of the view.
  std::size_t coordinate(std::size_t i) const {
    const bool is_second = (i == 1) != is_mirrored;
    return (axis + (is_second ? 2 : 1)) % 3;
  }
};

/// A list of points in a view. Predicates by index, exact. Ladder: doubles with the points' boxes,
/// or with the nearest doubles where they are given; input points go on as orient2d() does, others
/// in integers, circles in rationals.
class FlatPoints final : public PlanarPoints {
 public:
  explicit FlatPoints(const Point3Table& points) : points_(points) {}

  void reset(FlatView view);
  void push_back(SpacePoint p);
  /// Closer than boxes are, so that filters decide more. Requires nearest == rounded(points, p).
  void push_back(SpacePoint p, const RoundedPoint3& nearest);
  std::uint32_t size() const override { return static_cast<std::uint32_t>(at_.size()); }
  Sign orient(std::uint32_t i, std::uint32_t j, std::uint32_t k) const override;
  Sign compare(std::uint32_t i, std::uint32_t j) const override;
  Sign incircle(std::uint32_t i, std::uint32_t j, std::uint32_t k, std::uint32_t l) const override;
  /// The side of a plane of space. Also of points of the frame.
  Sign side(std::uint32_t i, PlaneId plane) const {
    return plumb::side(points_, at_[i].point, plane);
  }
  /// The same points in a table of the plane.
  PointTable2 table() const;

 private:
  struct Entry {
    Point2 mid;
    double radius;
    SpacePoint point;
    bool is_nearest;  // mid is; orders of different ones are those of the points
  };
  /// (x w, y w, w) with w > 0.
  using HomogeneousPoint = std::array<Integer, 3>;

  Sign compare_along(std::size_t i, std::size_t j, std::size_t side) const;
  const HomogeneousPoint& homogeneous_point(std::uint32_t i) const;
  const RationalPoint2& exact_point(std::uint32_t i) const;

  const Point3Table& points_;
  FlatView view_;
  std::vector<Entry> at_;
  // When asked.
  mutable std::vector<std::optional<HomogeneousPoint>> homogeneous_;
  mutable std::vector<std::optional<RationalPoint2>> exact_;
};

}  // namespace plumb
#pragma GCC visibility pop
