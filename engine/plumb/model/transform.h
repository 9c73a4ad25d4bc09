// Constructs affine maps of space: exactly orthogonal rotations, reflections, translations,
// scalings, and scalings to a given size. Nef3::transformed() applies a map to a set.
#pragma once

#include <array>
#include <optional>

#include "plumb/base/context.h"
#include "plumb/predicates/rational_point.h"
#include "plumb/space/nef3.h"

#pragma GCC visibility push(default)
namespace plumb {

/// Returns the map that first applies `first` and then `second`.
[[nodiscard]] AffineMap3 composed(const AffineMap3& second, const AffineMap3& first);
/// Returns the determinant of the linear part.
[[nodiscard]] Rational determinant(const AffineMap3& map);

/// Returns the map that multiplies x, y and z by the given factors.
[[nodiscard]] AffineMap3 scaling(const std::array<Rational, 3>& factors);
/// Returns the translation by the vector `by`.
[[nodiscard]] AffineMap3 translation(const std::array<Rational, 3>& by);
/// Returns the reflection in the plane through the origin with the given normal. Throws
/// Error{BadArgument} if the normal is zero.
[[nodiscard]] AffineMap3 reflection(const std::array<Rational, 3>& normal);
/// Returns a rotation about an axis through the origin. The matrix has rational entries and is
/// exactly orthogonal. It approximates the rotation by `degrees` about `axis` with an error of at
/// most 2^-50 in each entry. A rotation about a coordinate axis by a multiple of 90 degrees is
/// exact. Throws Error{BadArgument} if the axis is zero, and Error{NotFinite} if a number is not
/// finite.
[[nodiscard]] AffineMap3 rotation(const std::array<double, 3>& axis, double degrees);

/// The smallest axis-parallel box that contains a bounded set.
struct BoundingBox3 {
  RationalPoint3 low;   ///< The least coordinates.
  RationalPoint3 high;  ///< The greatest coordinates.
};

/// Returns the bounding box of the closure of a set, or nullopt if the set is empty. Throws
/// Error{BadArgument} if the set is unbounded. Cost: O(n) for n vertices.
[[nodiscard]] std::optional<BoundingBox3> bounding_box(const Nef3& set);

/// Returns the scaling about the origin that scales `box` to the given size. Along an axis whose
/// entry in `size` is 0, the factor is 1. If the entry of this axis in `is_automatic` is true, the
/// factor is instead the greatest factor of the other axes. Throws Error{BadArgument} if a size is
/// negative. Also throws Error{BadArgument} if the size along an axis is positive, but the box has
/// the length 0 along this axis.
[[nodiscard]] AffineMap3 resizing(const BoundingBox3& box, const std::array<Rational, 3>& size,
                                  const std::array<bool, 3>& is_automatic = {});

}  // namespace plumb
#pragma GCC visibility pop
