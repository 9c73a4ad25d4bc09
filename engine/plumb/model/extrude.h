// Extrusions: solids that a set of the plane, the outline, sweeps along the z-axis or around the
// z-axis.
//
// Main flow of both functions:
//  1. ends       triangulates the regularization of the outline (space/planar). The triangles form
//                the two ends of the solid
//  2. sides      makes a strip of faces from each edge of the outline
//  3. from_mesh  makes the set from all faces (Nef3::from_mesh()). The set contains the points
//                whose winding number is at least 1
// The outline may touch itself, and may have holes and several parts. The faces of a twisted solid
// may cross each other.
//
// Numbers: an extrusion along the z-axis without twist and scale is exact. In all other cases, the
// corners of the solid are rounded to doubles.
//
// Cost: O(n log n + n s) for n corners of the outline and s slices, plus the cost of from_mesh().
#pragma once

#include <array>
#include <cstdint>

#include "plumb/base/context.h"
#include "plumb/plane/nef2.h"
#include "plumb/space/nef3.h"

#pragma GCC visibility push(default)
namespace plumb {

/// Options of linear_extrusion().
struct LinearExtrusion {
  double height = 1;  ///< The height, which must be positive.
  /// Whether the solid extends from z = -height / 2 to z = height / 2, instead of from 0 to height.
  bool centred = false;
  double twist = 0;          ///< The angle in degrees by which the top is turned clockwise.
  std::uint32_t slices = 1;  ///< The number of layers of equal height; at least 1.
  std::array<double, 2> scale = {1, 1};  ///< The factors of x and y at the top; each is at least 0.
};

/// Returns the closed solid between an outline at the bottom and its image at the top. The solid is
/// empty if the outline has no area. Throws Error{BadArgument} if the outline is unbounded or an
/// option is out of its range, and Error{NotFinite} if a number is not finite.
[[nodiscard]] Nef3 linear_extrusion(const Nef2& outline, const LinearExtrusion& options,
                                    Context& context = unlimited_context());

/// Returns the closed solid that an outline sweeps when it turns around the z-axis. Before the
/// turn, the point (x, y) of the outline lies at (x, 0, y). For a full turn, the point lies at (-x,
/// 0, y) instead. `angle` is the angle of the turn in degrees. A negative angle turns the outline
/// clockwise. An angle of 360 or more stands for a full turn. The turn consists of `steps` equal
/// steps. Throws Error{BadArgument} in three cases: the outline has points on both sides of the
/// line x = 0, the outline is unbounded, or a step is 180 degrees or more.
[[nodiscard]] Nef3 rotational_extrusion(const Nef2& outline, double angle, std::uint32_t steps,
                                        Context& context = unlimited_context());

}  // namespace plumb
#pragma GCC visibility pop
