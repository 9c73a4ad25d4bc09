#include "plumb/predicates/input/determinants.h"

namespace plumb::rung {

namespace {

Integer minor2(const Integer& x0, const Integer& y0, const Integer& x1, const Integer& y1) {
  Integer minor = x0 * y1;
  minor.subtract_product(x1, y0);
  return minor;
}

/// Returns det [x y z] of the rows i, j, k.
template <std::size_t N>
Integer minor3(const std::array<Integer, N>& x, const std::array<Integer, N>& y,
               const std::array<Integer, N>& z, std::size_t i, std::size_t j, std::size_t k) {
  Integer minor = z[i] * minor2(x[j], y[j], x[k], y[k]);
  minor.add_product(z[j], minor2(x[k], y[k], x[i], y[i]));
  minor.add_product(z[k], minor2(x[i], y[i], x[j], y[j]));
  return minor;
}

}  // namespace

Integer big_on_grid(const Grid& grid, double value) {
  const Decomposed d = decompose(value);
  if (d.mantissa == 0) return 0;
  return Integer(d.mantissa) << (d.exponent - grid.low());
}

Sign big_cross(const std::array<Integer, 2>& x, const std::array<Integer, 2>& y) {
  return sign_of(minor2(x[0], y[0], x[1], y[1]));
}

Sign big_orient3d(const std::array<Integer, 3>& x, const std::array<Integer, 3>& y,
                  const std::array<Integer, 3>& z) {
  return sign_of(minor3(x, y, z, 0, 1, 2));
}

Sign big_incircle(const std::array<Integer, 3>& x, const std::array<Integer, 3>& y) {
  std::array<Integer, 3> lift;
  for (std::size_t i = 0; i < 3; ++i) {
    lift[i] = x[i] * x[i];
    lift[i].add_product(y[i], y[i]);
  }
  return sign_of(minor3(x, y, lift, 0, 1, 2));
}

Sign big_insphere(const std::array<Integer, 4>& x, const std::array<Integer, 4>& y,
                  const std::array<Integer, 4>& z) {
  std::array<Integer, 4> lift;
  for (std::size_t i = 0; i < 4; ++i) {
    lift[i] = x[i] * x[i];
    lift[i].add_product(y[i], y[i]).add_product(z[i], z[i]);
  }
  // Expands by the last column. The sign of row 3 (d) is positive, and the signs alternate.
  Integer det = lift[3] * minor3(x, y, z, 0, 1, 2);
  det.subtract_product(lift[2], minor3(x, y, z, 0, 1, 3));
  det.add_product(lift[1], minor3(x, y, z, 0, 2, 3));
  det.subtract_product(lift[0], minor3(x, y, z, 1, 2, 3));
  return sign_of(det);
}

}  // namespace plumb::rung
