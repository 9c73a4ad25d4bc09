#include "plumb/space/principal_axes.h"

#include <cmath>
#include <cstddef>

namespace plumb {
namespace {

constexpr Matrix3 kCoordinateAxes = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};

/// A turn in the plane of axes i and j that makes m[i][j] 0 (Jacobi); rows of `axes` follow.
void rotate(Matrix3& m, Matrix3& axes, std::size_t i, std::size_t j) {
  if (m[i][j] == 0) return;
  const double theta = (m[j][j] - m[i][i]) / (2 * m[i][j]);
  const double t = (theta < 0 ? -1 : 1) / (std::fabs(theta) + std::hypot(theta, 1.0));
  const double c = 1 / std::hypot(t, 1.0), s = t * c;
  for (std::size_t k = 0; k < 3; ++k) {
    const double x = m[k][i], y = m[k][j];
    m[k][i] = c * x - s * y;
    m[k][j] = s * x + c * y;
  }
  for (std::size_t k = 0; k < 3; ++k) {
    const double x = m[i][k], y = m[j][k];
    m[i][k] = c * x - s * y;
    m[j][k] = s * x + c * y;
  }
  for (std::size_t k = 0; k < 3; ++k) {
    const double x = axes[i][k], y = axes[j][k];
    axes[i][k] = c * x - s * y;
    axes[j][k] = s * x + c * y;
  }
}

}  // namespace

Matrix3 principal_axes(Matrix3 m) {
  constexpr int kSweeps = 8;
  Matrix3 axes = kCoordinateAxes;
  for (int sweep = 0; sweep < kSweeps; ++sweep) {
    rotate(m, axes, 0, 1);
    rotate(m, axes, 0, 2);
    rotate(m, axes, 1, 2);
  }
  for (const Vector3& axis : axes) {
    if (!std::isfinite(axis[0] + axis[1] + axis[2])) return kCoordinateAxes;
  }
  return axes;
}

}  // namespace plumb
