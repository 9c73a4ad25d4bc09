// Affine maps of space: rotations that are exactly orthogonal, reflections, scalings, and maps to a
// given size. Nef3::transformed() applies them.
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

/// Returns the scaling of the axes by the given factors.
[[nodiscard]] AffineMap3 scaling(const std::array<Rational, 3>& factors);
/// Returns the translation by a vector.
[[nodiscard]] AffineMap3 translation(const std::array<Rational, 3>& by);
/// Returns the reflection at the plane through the origin with the given normal. Throws
/// Error{BadArgument} if the normal is zero.
[[nodiscard]] AffineMap3 reflection(const std::array<Rational, 3>& normal);
/// Returns a rotation about an axis through the origin. The matrix has rational entries and is
/// exactly orthogonal. It is the rotation by `degrees` about `axis`, up to an error of 2^-50 in
/// each entry; about a coordinate axis by a multiple of 90 degrees it is exact. Throws
/// Error{BadArgument} if the axis is zero, and Error{NotFinite} if a number is not finite.
[[nodiscard]] AffineMap3 rotation(const std::array<double, 3>& axis, double degrees);

/// The least box that contains a bounded set: the least and the greatest coordinates.
struct BoundingBox3 {
  RationalPoint3 low;   ///< The least coordinates.
  RationalPoint3 high;  ///< The greatest coordinates.
};

/// Returns the bounding box of the closure of a set, or nullopt if the set is empty. Throws
/// Error{BadArgument} if the set is unbounded. O(n).
[[nodiscard]] std::optional<BoundingBox3> bounding_box(const Nef3& set);

/// Returns the scaling about the origin after which the bounding box has the given size; an axis
/// with the size 0 keeps its size, or, if `is_automatic` says so, gets the greatest factor of the
/// others. Throws Error{BadArgument} if a size is negative, or an axis has no extent and a size.
[[nodiscard]] AffineMap3 resizing(const BoundingBox3& box, const std::array<Rational, 3>& size,
                                  const std::array<bool, 3>& is_automatic = {});

}  // namespace plumb
#pragma GCC visibility pop
