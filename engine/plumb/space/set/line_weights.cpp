// Both functions divide volumes of tetrahedra. Let the line go through a and b.
//
// - Let A and B be the signed volumes of the tetrahedra of the three points of the plane with a and
//   with b. At the common point, the weight of a is B / (B - A), and the weight of b is
//   A / (A - B).
// - Let c0, c1, c2 be the corners of the triangle, and let x = w0 c0 + w1 c1 + w2 c2 be the common
//   point, with w0 + w1 + w2 = 1. The vector x - a is a multiple s of d = b - a. Then
//   w0 det(c0 - a, c1 - a, c2 - a) = det(x - a, c1 - a, c2 - a) = s det(d, c1 - a, c2 - a). So w0
//   is proportional to det(d, c1 - a, c2 - a), and the other weights likewise, with the same
//   factor.
//
// Error bounds (nearest_quotient.h). Differences have no error, the products of two have 9 u^2
// terms, minors 15, products of a minor and a difference 24, determinants 36, and sums of
// determinants at most 48. The bound of the quotient covers 2^7.
//
// Tested by tests/space/line_weights_test.cpp.
#include "plumb/space/set/line_weights.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>

#include "plumb/predicates/arithmetic/nearest_quotient.h"

namespace plumb {
namespace {

using twofold::difference;
using twofold::nearest_to;
using twofold::negative;
using twofold::product;
using twofold::quotient;
using twofold::sum;

using Vector = std::array<Twofold, 3>;

/// Whether the coordinates of all points are in the range in which nothing overflows or becomes
/// subnormal. Zero is recognized by its bits, as subnormal numbers may compare as zero.
bool are_in_range(std::span<const Point3> points) {
  const auto is_in_range = [](double c) {
    return std::bit_cast<std::uint64_t>(c) << 1 == 0 ||
           (std::fabs(c) >= 0x1p-60 && std::fabs(c) <= 0x1p60);
  };
  return std::ranges::all_of(points, [&](const Point3& p) {
    return is_in_range(p.x) && is_in_range(p.y) && is_in_range(p.z);
  });
}

Vector between(const Point3& from, const Point3& to) {
  return {difference(to.x, from.x), difference(to.y, from.y), difference(to.z, from.z)};
}

Vector cross(const Vector& a, const Vector& b) {
  const auto minor = [&](std::size_t i, std::size_t j) {
    return sum(product(a[i], b[j]), negative(product(a[j], b[i])));
  };
  return {minor(1, 2), minor(2, 0), minor(0, 1)};
}

Twofold dot(const Vector& a, const Vector& b) {
  return sum(sum(product(a[0], b[0]), product(a[1], b[1])), product(a[2], b[2]));
}

/// Returns the quotients by their sum, rounded, if they are certain and positive.
template <std::size_t N>
std::optional<std::array<double, N>> shares(const std::array<Twofold, N>& parts) {
  Twofold whole = parts[0];
  for (std::size_t i = 1; i < N; ++i) whole = sum(whole, parts[i]);
  std::array<double, N> result;
  for (std::size_t i = 0; i < N; ++i) {
    result[i] = nearest_to(quotient(parts[i], whole));
    if (!(result[i] > 0)) return {};
  }
  return result;
}

}  // namespace

std::optional<std::array<double, 2>> weights_on_line(const LineEnds& line,
                                                     const TrianglePoints& plane) {
  if (!are_in_range(line) || !are_in_range(plane)) return {};
  const Vector normal = cross(between(plane[0], plane[1]), between(plane[0], plane[2]));
  const Twofold at_a = dot(normal, between(plane[0], line[0]));
  const Twofold at_b = dot(normal, between(plane[0], line[1]));
  return shares(std::array{at_b, negative(at_a)});
}

std::optional<std::array<double, 3>> weights_of_corners(const TrianglePoints& triangle,
                                                        const LineEnds& line) {
  if (!are_in_range(line) || !are_in_range(triangle)) return {};
  const Vector along = between(line[0], line[1]);
  std::array<Vector, 3> corner;
  for (std::size_t i = 0; i < 3; ++i) corner[i] = between(line[0], triangle[i]);
  return shares(std::array{dot(along, cross(corner[1], corner[2])),
                           dot(along, cross(corner[2], corner[0])),
                           dot(along, cross(corner[0], corner[1]))});
}

}  // namespace plumb
