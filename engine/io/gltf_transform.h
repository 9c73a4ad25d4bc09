// Where a node of glTF puts its mesh: affine maps of space, in doubles.
#pragma once

#include <array>
#include <cstddef>

#include "plumb/predicates/input_predicates.h"

namespace plumb {

/// x' = m[0][0] x + m[0][1] y + m[0][2] z + m[0][3], and so on.
using GltfTransform = std::array<std::array<double, 4>, 3>;
inline constexpr GltfTransform kGltfIdentity{{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}}};

/// First b, then a.
inline GltfTransform product(const GltfTransform& a, const GltfTransform& b) {
  GltfTransform c{};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 4; ++j) {
      c[i][j] = a[i][0] * b[0][j] + a[i][1] * b[1][j] + a[i][2] * b[2][j];
    }
    c[i][3] += a[i][3];
  }
  return c;
}

/// The exact sign of the determinant, which as a double underflows. Requires finite entries.
inline bool mirrors(const GltfTransform& m) {
  const auto row = [&m](std::size_t i) { return Point3{m[i][0], m[i][1], m[i][2]}; };
  return orient3d(row(0), row(1), row(2), Point3{0, 0, 0}) == Sign::Negative;
}

inline std::array<double, 3> applied(const GltfTransform& m, const std::array<double, 3>& p) {
  std::array<double, 3> q{};
  for (std::size_t k = 0; k < 3; ++k) {
    q[k] = m[k][0] * p[0] + m[k][1] * p[1] + m[k][2] * p[2] + m[k][3];
  }
  return q;
}

/// By columns, as glTF has it.
inline GltfTransform from_matrix(const std::array<double, 16>& m) {
  GltfTransform t{};
  for (std::size_t i = 0; i < 3; ++i) t[i] = {m[i], m[4 + i], m[8 + i], m[12 + i]};
  return t;
}

/// Scaled, turned by a quaternion (x, y, z, w) of any length but zero, moved. Quarter turns are exact.
inline GltfTransform from_parts(const std::array<double, 4>& turn,
                                const std::array<double, 3>& scale,
                                const std::array<double, 3>& move) {
  const auto [x, y, z, w] = turn;
  const double n = x * x + y * y + z * z + w * w;
  GltfTransform t{{{w * w + x * x - y * y - z * z, 2 * (x * y - z * w), 2 * (x * z + y * w), 0},
                   {2 * (x * y + z * w), w * w - x * x + y * y - z * z, 2 * (y * z - x * w), 0},
                   {2 * (x * z - y * w), 2 * (y * z + x * w), w * w - x * x - y * y + z * z, 0}}};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) t[i][j] = t[i][j] / n * scale[j];
    t[i][3] = move[i];
  }
  return t;
}

}  // namespace plumb
