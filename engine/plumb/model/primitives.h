// Meshes of simple solids, and plane sets of simple shapes: the primitives of constructive solid
// geometry. Their vertices are those of OpenSCAD: doubles on circles, in the same places.
//
// Sines and cosines of multiples of 30 and 45 degrees are the nearest doubles of the exact values,
// so that symmetric shapes have symmetric coordinates. Spheres and cones are convex exactly: they
// are the convex hulls of their vertices (hull.h). Four vertices of a sphere that should lie in one
// plane usually do not after rounding, and a triangulation that ignores this gives a solid with
// shallow dents.
//
// Cost: O(n log n) for n vertices of spheres and cones, O(n) for all others. Errors: every function
// throws Error{NotFinite} if a number is not finite, Error{BadArgument} if a number is out of the
// range that is stated for it, and Error{ResourceLimit} for more than 2^20 chords of a circle.
// Lengths must not vanish when they are halved.
#pragma once

#include <array>
#include <cstdint>

#include "plumb/base/context.h"
#include "plumb/plane/nef2.h"
#include "plumb/space/mesh_arrays.h"

#pragma GCC visibility push(default)
namespace plumb {

/// How a circle is divided into chords: OpenSCAD's variables $fn, $fa and $fs.
struct CircleDivision {
  double count = 0;   ///< The number of chords; if it is not positive, the other two decide.
  double angle = 12;  ///< The least angle of a chord in degrees.
  double length = 2;  ///< The least length of a chord.
};

/// Returns the number of chords of a circle. If `count` is positive, this is the integer part of
/// `count`, and at least 3. Otherwise it is ceil(max(min(360 / angle, 2 pi radius / length), 5)).
/// It is 3 if the radius is less than 2^-20. Throws Error{ResourceLimit} if there are more than
/// 2^20 chords.
[[nodiscard]] std::uint32_t chords_of(double radius, const CircleDivision& division);

/// Returns the cosine of an angle in degrees; exact for multiples of 60 and 90 degrees, and the
/// nearest double for multiples of 30 and 45 degrees.
[[nodiscard]] double cosine_of_degrees(double angle);
/// Returns the sine of an angle in degrees, with the same exact values.
[[nodiscard]] double sine_of_degrees(double angle);

/// Where a solid lies with respect to the origin.
enum class Placement : std::uint8_t {
  Corner,   ///< From the origin upward; a box lies in the first octant.
  Centred,  ///< The centre is the origin.
};

/// Returns a box with the given side lengths. Requires lengths > 0.
[[nodiscard]] PolygonMesh box_mesh(const std::array<double, 3>& size, Placement placement);
/// Returns a ball with its centre at the origin: (chords + 1) / 2 rings of `chords` vertices each.
/// Ring i lies at the polar angle 180 (i + 1/2) / rings degrees. Requires radius > 0 and chords >=
/// 3.
[[nodiscard]] PolygonMesh sphere_mesh(double radius, std::uint32_t chords,
                                      Context& context = unlimited_context());
/// Returns a cylinder, a cone or a frustum along the z-axis: two rings of `chords` vertices, or one
/// ring and a tip if a radius is 0. Requires height > 0, radii >= 0 of which one is positive, and
/// chords >= 3.
[[nodiscard]] PolygonMesh cylinder_mesh(double height, double bottom_radius, double top_radius,
                                        std::uint32_t chords, Placement placement,
                                        Context& context = unlimited_context());
/// Returns a torus around the z-axis. `radius` is the distance of the centre of the tube from the
/// axis. Requires radius > tube_radius > 0, and at least 3 chords each.
[[nodiscard]] PolygonMesh torus_mesh(double radius, double tube_radius, std::uint32_t chords,
                                     std::uint32_t tube_chords,
                                     Context& context = unlimited_context());

/// Returns a closed rectangle. Requires lengths > 0.
[[nodiscard]] Nef2 rectangle(const std::array<double, 2>& size, Placement placement);
/// Returns the closed regular polygon inscribed in a circle around the origin; its first corner
/// lies on the positive x-axis. Requires radius > 0 and chords >= 3.
[[nodiscard]] Nef2 disk(double radius, std::uint32_t chords,
                        Context& context = unlimited_context());

}  // namespace plumb
#pragma GCC visibility pop
