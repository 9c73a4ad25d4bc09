// Solids swept by sets of the plane: along the z-axis, or around it.
//
// Main flow: the regularization of the outline is triangulated for the ends (space/planar), each of
// its edges becomes a strip of faces, and Nef3::from_mesh() makes the set. Points that have the
// winding number 1 or more belong to it. So an outline may touch itself, have holes and several
// parts, and a twisted solid may cross itself.
//
// Numbers: without a twist, the corners of the outline are taken exactly. With a twist, a scale
// other than 1, or a rotation, corners are rounded to doubles.
//
// Cost: O(n log n + n s) for n corners of the outline and s slices, and what from_mesh() takes.
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
  double height = 1;         ///< The height; positive.
  bool centred = false;      ///< Whether z runs from -height / 2 instead of 0.
  double twist = 0;          ///< The angle in degrees by which the top is turned clockwise.
  std::uint32_t slices = 1;  ///< Layers of equal height; at least 1.
  std::array<double, 2> scale = {1, 1};  ///< Factors of x and y at the top; at least 0.
};

/// Returns the closed solid between an outline at the bottom and its image at the top. It is empty
/// if the outline has no area. Throws Error{BadArgument} if the outline is unbounded or an option
/// is out of its range, and Error{NotFinite} if a number is not finite.
[[nodiscard]] Nef3 linear_extrusion(const Nef2& outline, const LinearExtrusion& options,
                                    Context& context = unlimited_context());

/// Returns the closed solid that an outline sweeps when it turns around the z-axis; its point (x,
/// y) starts at (x, 0, y), or at (-x, 0, y) for a full turn. `angle` is in degrees; a negative one
/// turns clockwise, and 360 or more is a full turn. The turn consists of `steps` equal steps.
/// Requires that the outline does not have points on both sides of the line x = 0. Throws
/// Error{BadArgument} if it has, or is unbounded, or if a step is 180 degrees or more.
[[nodiscard]] Nef3 rotational_extrusion(const Nef2& outline, double angle, std::uint32_t steps,
                                        Context& context = unlimited_context());

}  // namespace plumb
#pragma GCC visibility pop
