// An affine map of points and planes in integers of fixed widths. Internal.
#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "plumb/predicates/arithmetic/fixed.h"
#include "plumb/predicates/space/plane_exact.h"
#include "plumb/space/set/integer_map.h"

namespace plumb {

/// An IntegerMap whose numbers have at most 254 bits. It maps planes whose normals have at most 317
/// bits and offsets at most 446, and points whose coordinates have at most 61 bits on their grid,
/// without an allocation.
class FixedMap {
 public:
  /// Returns the map, if its numbers are short enough.
  static std::optional<FixedMap> of(const IntegerMap& map);

  /// Computes the image of a plane up to a positive factor, with the image of its positive side as
  /// its positive side. Returns false if the numbers of the plane are too long. Requires a plane
  /// that does not belong to the frame.
  bool image_of_plane(const exact3::Operand& plane, exact3::LongPlane& image) const;

  /// The image of a point: its coordinates are x 2^exponent.
  struct Point {
    std::array<exact3::LongPlane::Number, 3> x;
    int exponent = 0;

    /// Returns the point if its coordinates are doubles far from the ends of their range.
    std::optional<Point3> as_doubles() const;
    /// Returns the plane through the point across an axis.
    exact3::LongPlane plane_across(std::size_t axis) const;
  };
  /// Whether image_of_point() can succeed: the common denominator of the map is a power of two.
  bool maps_points() const { return maps_points_; }
  /// Computes the image of an input point. Returns false if its numbers are too long. Requires
  /// maps_points().
  bool image_of_point(const Point3& point, const Grid& grid, Point& image) const;

 private:
  static constexpr int kLong = 4, kShort = 2;
  template <int L>
  using Rows = std::array<exact3::Vector<Fixed<L>>, 3>;

  static bool fits(const IntegerRow& row);
  void set_planes(const std::array<IntegerRow, 4>& matrix);
  bool set_points(const IntegerMap& map);
  template <class W>
  bool image(const exact3::FixedPlane<W>& plane, exact3::LongPlane& image) const;

  /// The map of planes across one axis, without the common factor of its numbers.
  struct Across {
    exact3::Vector<Fixed<kLong>> normal;  // A column of normal_.
    Fixed<kLong> offset;
    Fixed<kLong> factor;
    int lift = 0;
  };
  static Across across(const std::array<IntegerRow, 4>& matrix, std::size_t axis);

  // A plane n.x + d 2^s = 0 goes to n' = normal_ n, d' = 2^lift_ (offset_.n + factor_ d 2^s).
  Rows<kLong> normal_;
  Rows<kShort> short_normal_;
  bool is_short_ = false;  // Whether short_normal_ has the numbers of normal_.
  exact3::Vector<Fixed<kLong>> offset_;
  Fixed<kLong> factor_;
  int lift_ = 0;
  std::array<Across, 3> across_;
  // A point p goes to 2^point_exponent_ (point_ p + shift_).
  Rows<kLong> point_;
  exact3::Vector<Fixed<kLong>> shift_;
  int point_exponent_ = 0;
  bool maps_points_ = false;
};

}  // namespace plumb
