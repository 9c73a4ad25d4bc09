// Elementary functions of doubles that round correctly.
//
// The functions of the C library may differ in the last place from one system to another. Corners
// that are computed with the functions of this header have the same coordinates on every system, so
// files have the same bytes. Each function returns the double that is nearest to the exact value of
// the function at the given doubles, in every rounding mode. A call takes some microseconds.
//
// Source: MPFR (L. Fousse et al., ACM Trans. on Mathematical Software 33, 2007).
#pragma once

#include "plumb/predicates/point.h"

#pragma GCC visibility push(default)
namespace plumb {

/// Returns the sine of an angle in radians. Requires a finite angle.
[[nodiscard]] double sine(double angle);
/// Returns the cosine of an angle in radians. Requires a finite angle.
[[nodiscard]] double cosine(double angle);
/// Returns the vector (cosine(angle), sine(angle)). This takes about as long as sine(angle) alone.
/// Requires a finite angle.
[[nodiscard]] Point2 direction_at(double angle);
/// Returns the tangent of an angle in radians. Requires a finite angle.
[[nodiscard]] double tangent(double angle);
/// Returns the angle in [0, pi] of which x is the cosine. Requires |x| <= 1.
[[nodiscard]] double arc_cosine(double x);
/// Returns the angle in [-pi, pi] from the positive x axis to the vector (x, y), and 0 for the
/// vector zero. Requires finite numbers.
[[nodiscard]] double arc_tangent(double y, double x);

}  // namespace plumb
#pragma GCC visibility pop
