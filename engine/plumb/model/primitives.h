// Makes the primitives of constructive solid geometry: meshes of simple solids, and simple sets of
// the plane. Circles are replaced by regular polygons. The vertices have the same positions as in
// OpenSCAD, and their coordinates are doubles.
//
// Sines and cosines of multiples of 30 and 45 degrees are the doubles nearest to the exact values,
// so that symmetric shapes have symmetric coordinates. Spheres and cones are exactly convex,
// because they are computed as the convex hulls of their vertices (hull.h). Without a hull, a
// sphere would usually have shallow dents. The reason is that, after rounding, the four corners of
// a face of the sphere usually do not lie in a common plane.
//
// Cost: O(n log n) for spheres and cones with n vertices, and O(n) for all other shapes. Errors of
// all functions: Error{NotFinite} if a number is not finite. Error{BadArgument} if a number is out
// of the range stated for it. Error{ResourceLimit} if a circle has more than 2^20 chords. A length
// that becomes 0 when it is halved counts as out of range.
#pragma once

#include <array>
#include <cstdint>

#include "plumb/base/context.h"
#include "plumb/plane/nef2.h"
#include "plumb/space/mesh_arrays.h"

#pragma GCC visibility push(default)
namespace plumb {

/// Determines the number of chords that replace a circle. The members are the variables $fn, $fa
/// and $fs of OpenSCAD.
struct CircleDivision {
  /// The number of chords. If it is not positive, `angle` and `length` determine the number.
  double count = 0;
  /// The smallest angle at the centre of the circle that a chord may span, in degrees.
  double angle = 12;
  double length = 2;  ///< The least length of a chord.
};

/// Returns the number of chords of a circle. The number is 3 if the radius is less than 2^-20.
/// Otherwise, if `count` is positive, the number is the integer part of `count`, but at least 3. In
/// all other cases the number is ceil(max(min(360 / angle, 2 pi radius / length), 5)). Throws
/// Error{ResourceLimit} if the number is greater than 2^20.
[[nodiscard]] std::uint32_t chords_of(double radius, const CircleDivision& division);

/// Returns the cosine of an angle in degrees. The cosine is exact for multiples of 60 and 90
/// degrees. For other multiples of 30 and 45 degrees, it is the double nearest to the exact cosine.
[[nodiscard]] double cosine_of_degrees(double angle);
/// Returns the sine of an angle in degrees. It is as exact as cosine_of_degrees(angle - 90).
[[nodiscard]] double sine_of_degrees(double angle);

/// The position of a solid or shape relative to the origin.
enum class Placement : std::uint8_t {
  /// The solid lies above the plane z = 0. A box or rectangle has its lowest corner at the origin.
  Corner,
  Centred,  ///< The centre is the origin.
};

/// Returns a box with the given side lengths. Requires lengths > 0.
[[nodiscard]] PolygonMesh box_mesh(const std::array<double, 3>& size, Placement placement);
/// Returns a ball whose centre is the origin. Its vertices form (chords + 1) / 2 rings, each with
/// `chords` vertices. If there are n rings, ring i lies at the polar angle 180 (i + 1/2) / n
/// degrees. Requires radius > 0 and chords >= 3.
[[nodiscard]] PolygonMesh sphere_mesh(double radius, std::uint32_t chords,
                                      Context& context = unlimited_context());
/// Returns a cylinder, a cone or a frustum around the z-axis. It has a ring of `chords` vertices at
/// the bottom and at the top. If one of the radii is 0, a single vertex replaces the ring. Requires
/// height > 0 and chords >= 3. Both radii must be >= 0, and at least one of them must be > 0.
[[nodiscard]] PolygonMesh cylinder_mesh(double height, double bottom_radius, double top_radius,
                                        std::uint32_t chords, Placement placement,
                                        Context& context = unlimited_context());
/// Returns a torus around the z-axis. `radius` is the distance of the centre of the tube from the
/// axis. Requires radius > tube_radius > 0, chords >= 3 and tube_chords >= 3.
[[nodiscard]] PolygonMesh torus_mesh(double radius, double tube_radius, std::uint32_t chords,
                                     std::uint32_t tube_chords,
                                     Context& context = unlimited_context());

/// Returns a closed rectangle. Requires lengths > 0.
[[nodiscard]] Nef2 rectangle(const std::array<double, 2>& size, Placement placement);
/// Returns the closed regular polygon with `chords` corners that is inscribed in a circle around
/// the origin. One of its corners lies on the positive x-axis. Requires radius > 0 and chords >= 3.
[[nodiscard]] Nef2 disk(double radius, std::uint32_t chords,
                        Context& context = unlimited_context());

}  // namespace plumb
#pragma GCC visibility pop
