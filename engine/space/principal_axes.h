// The directions in which a cloud of points extends, for boxes that lie along it.
#pragma once

#include <array>

namespace plumb {

using Vector3 = std::array<double, 3>;
using Matrix3 = std::array<Vector3, 3>;  ///< rows

/// Unit vectors, the eigenvectors of a symmetric matrix, as rows (Jacobi): at right angles but for some roundings. The
/// coordinate axes where numbers are not finite.
Matrix3 principal_axes(Matrix3 m);

}  // namespace plumb
