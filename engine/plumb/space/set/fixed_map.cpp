// Affine maps in integers of fixed widths.
//
// Bounds: the numbers of the map are below 2^254 (long) or 2^126 (short), and those of a plane
// obey (L) of plane_exact.h. With N and D limbs of a plane and L limbs of the map, a component of a
// normal is below 3 2^(64N-3) 2^(64L-2) < 2^(64(N+L)-3), and both parts of the offset are below
// 2^(64 (max(N, D) + 4) - 2). They have at most 11 limbs, and are then brought to a common scale in
// the 12 limbs of a LongPlane if they still fit there.
//
// Tested by tests/space/transform_test.cpp.

#include "plumb/space/set/fixed_map.h"

#include <algorithm>
#include <climits>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <span>
#include <vector>

#include "plumb/predicates/arithmetic/scaled.h"

namespace plumb {
namespace {

using exact3::LongPlane;
using Number = LongPlane::Number;

/// The bits that a sum of two numbers may have, so that the sum of both parts of an offset fits.
constexpr int kMostBits = 64 * LongPlane::kLimbs - 3;

template <int L>
Fixed<L> fixed(const Integer& x) {
  std::vector<std::uint64_t> limbs;
  append_limbs(x, L, limbs);
  return Fixed<L>::from_limbs(limbs.data());
}

/// Returns the least number of trailing zero bits of some numbers; 0 if all are zero.
int common_zeros(std::span<const IntegerRow> rows) {
  int low = INT_MAX;
  for (const IntegerRow& row : rows) {
    for (const Integer& x : row) {
      if (!x.is_zero()) low = std::min(low, trailing_zeros(x));
    }
  }
  return low == INT_MAX ? 0 : low;
}

Integer lowered(const Integer& x, int by) { return x >> static_cast<unsigned>(by); }

/// Sets `sum` to a 2^at_a + b 2^at_b divided by 2^scale with the least of the scales of numbers
/// other than zero. Returns false if this needs too many bits.
bool add_scaled(Number a, int at_a, Number b, int at_b, Number& sum, int& scale) {
  scale = a.is_zero() ? at_b : b.is_zero() ? at_a : std::min(at_a, at_b);
  if (!a.is_zero() && !exact3::shift_within(a, at_a - scale, kMostBits)) return false;
  if (!b.is_zero() && !exact3::shift_within(b, at_b - scale, kMostBits)) return false;
  sum = a + b;
  return true;
}

}  // namespace

std::optional<Point3> FixedMap::Point::as_doubles() const {
  constexpr int kDigits = 53, kMostExponent = 900;
  std::array<double, 3> at{};
  for (std::size_t k = 0; k < 3; ++k) {
    if (x[k].is_zero()) continue;
    const int low = trailing_zeros(x[k]);
    if (bit_length(x[k]) - low > kDigits || std::abs(low + exponent) > kMostExponent) return {};
    const Scaled s = scaled(x[k]);  // Exact, as it keeps 53 bits.
    at[k] = std::ldexp(s.mantissa, s.exponent + exponent);
  }
  return Point3{at[0], at[1], at[2]};
}

LongPlane FixedMap::Point::plane_across(std::size_t axis) const {
  LongPlane plane;
  plane.n[axis] = Number(1);
  plane.d = -x[axis];
  plane.scale = plane.d.is_zero() ? exact3::kAnyScale : exponent;
  return plane;
}

std::optional<FixedMap> FixedMap::of(const IntegerMap& map) {
  if (!std::all_of(map.plane_matrix().begin(), map.plane_matrix().end(), fits)) return {};
  FixedMap result;
  result.set_planes(map.plane_matrix());
  result.maps_points_ = result.set_points(map);
  return result;
}

bool FixedMap::fits(const IntegerRow& row) {
  return std::all_of(row.begin(), row.end(),
                     [](const Integer& x) { return bit_length(x) <= 64 * kLong - 2; });
}

void FixedMap::set_planes(const std::array<IntegerRow, 4>& matrix) {
  const int low = common_zeros({matrix.data(), 3});
  const int offset_low = common_zeros({&matrix[3], 1});
  is_short_ = true;
  for (std::size_t k = 0; k < 3; ++k) {
    for (std::size_t j = 0; j < 3; ++j) {
      const Integer x = lowered(matrix[k][j], low);
      normal_[k][j] = fixed<kLong>(x);
      is_short_ = is_short_ && bit_length(x) <= 64 * kShort - 2;
      if (is_short_) short_normal_[k][j] = fixed<kShort>(x);
    }
    offset_[k] = fixed<kLong>(lowered(matrix[3][k], offset_low));
    across_[k] = across(matrix, k);
  }
  factor_ = fixed<kLong>(lowered(matrix[3][3], offset_low));
  lift_ = offset_low - low;
}

FixedMap::Across FixedMap::across(const std::array<IntegerRow, 4>& matrix, std::size_t axis) {
  Integer common = matrix[3][3];
  for (const IntegerRow& row : matrix) common = gcd(common, row[axis]);
  const IntegerRow column{matrix[0][axis] / common, matrix[1][axis] / common,
                          matrix[2][axis] / common, 0};
  const IntegerRow offset{matrix[3][axis] / common, matrix[3][3] / common, 0, 0};
  const int low = common_zeros({&column, 1}), offset_low = common_zeros({&offset, 1});
  Across result;
  for (std::size_t k = 0; k < 3; ++k) result.normal[k] = fixed<kLong>(lowered(column[k], low));
  result.offset = fixed<kLong>(lowered(offset[0], offset_low));
  result.factor = fixed<kLong>(lowered(offset[1], offset_low));
  result.lift = offset_low - low;
  return result;
}

bool FixedMap::set_points(const IntegerMap& map) {
  const Integer& weight = map.weight();
  if (lsb(weight) != msb(weight)) return false;
  const std::array<IntegerRow, 3>& matrix = map.point_matrix();
  if (!std::all_of(matrix.begin(), matrix.end(), fits)) return false;
  for (std::size_t k = 0; k < 3; ++k) {
    for (std::size_t j = 0; j < 3; ++j) point_[k][j] = fixed<kLong>(matrix[k][j]);
    shift_[k] = fixed<kLong>(matrix[k][3]);
  }
  point_exponent_ = -trailing_zeros(weight);
  return true;
}

namespace {

constexpr int kLimbs = LongPlane::kLimbs;

/// Sets the normal to the products of the rows with n.
template <int L, int N>
void set_normal(const std::array<exact3::Vector<Fixed<L>>, 3>& rows,
                const exact3::Vector<Fixed<N>>& n, LongPlane& image) {
  for (std::size_t k = 0; k < 3; ++k) {
    image.n[k] = exact3::dot<Fixed<N + L>>(rows[k], n).template resized<kLimbs>();
  }
}

/// Sets the offset to (a + b 2^scale) 2^lift. Returns false if this needs too many bits.
template <int A, int B>
bool set_offset(const Fixed<A>& a, const Fixed<B>& b, int scale, int lift, LongPlane& image) {
  const int at_b = scale == exact3::kAnyScale ? 0 : scale;
  if (!add_scaled(a.template resized<kLimbs>(), 0, b.template resized<kLimbs>(), at_b, image.d,
                  image.scale)) {
    return false;
  }
  image.scale = image.d.is_zero() ? exact3::kAnyScale : image.scale + lift;
  return true;
}

/// Returns the only axis along which a normal is not zero; 3 if there are several.
template <class W>
std::size_t only_axis(const exact3::FixedPlane<W>& plane) {
  std::size_t axis = 3;
  for (std::size_t i = 0; i < 3; ++i) {
    if (plane.n[i].is_zero()) continue;
    if (axis != 3) return 3;
    axis = i;
  }
  return axis;
}

}  // namespace

template <class W>
bool FixedMap::image(const exact3::FixedPlane<W>& plane, LongPlane& image) const {
  if (const std::size_t axis = only_axis(plane); axis != 3) {
    const Across& map = across_[axis];
    for (std::size_t k = 0; k < 3; ++k) {
      image.n[k] = multiply(map.normal[k], plane.n[axis]).template resized<kLimbs>();
    }
    return set_offset(multiply(map.offset, plane.n[axis]), multiply(map.factor, plane.d),
                      plane.scale, map.lift, image);
  }
  is_short_ ? set_normal(short_normal_, plane.n, image) : set_normal(normal_, plane.n, image);
  return set_offset(exact3::dot<Fixed<W::kNormal + kLong>>(offset_, plane.n),
                    multiply(factor_, plane.d), plane.scale, lift_, image);
}

namespace {

/// The width of planes that have passed through several maps.
struct Mapped {
  static constexpr int kNormal = 5, kOffset = 7;
};

/// Loads a plane of stored coefficients that is longer than Wide. Returns false if it is too long.
bool load_mapped(const exact3::Operand& operand, exact3::FixedPlane<Mapped>& plane) {
  if (!operand.source.is_explicit()) return false;
  const PlaneTable& table = *operand.table;
  const PlaneSlot& slot = table.slot(operand.source);
  const bool fits =
      slot.normal_bits <= 64 * Mapped::kNormal - 3 && slot.offset_bits <= 64 * Mapped::kOffset - 2;
  if (!fits) return false;
  const std::uint64_t* limbs = table.limbs(slot);
  for (std::size_t i = 0; i < 3; ++i) {
    plane.n[i] = fixed_from_limbs<Mapped::kNormal>(limbs + i * slot.limbs, slot.limbs);
  }
  plane.d = fixed_from_limbs<Mapped::kOffset>(limbs + std::size_t{3} * slot.limbs, slot.limbs);
  plane.scale = plane.d.is_zero() ? exact3::kAnyScale : slot.scale;
  return true;
}

}  // namespace

bool FixedMap::image_of_plane(const exact3::Operand& plane, LongPlane& result) const {
  if (plane.width <= exact3::Medium::kIndex) {
    return image(exact3::load<exact3::Medium>(plane), result);
  }
  if (plane.width <= exact3::Wide::kIndex) return image(exact3::load<exact3::Wide>(plane), result);
  exact3::FixedPlane<Mapped> mapped;
  return load_mapped(plane, mapped) && image(mapped, result);
}

bool FixedMap::image_of_point(const Point3& point, const Grid& grid, Point& image) const {
  if (grid.bits() > exact3::Medium::kMaxBits) return false;
  const exact3::Vector<Fixed<1>> p{Fixed<1>(grid.to_int64(point.x)),
                                   Fixed<1>(grid.to_int64(point.y)),
                                   Fixed<1>(grid.to_int64(point.z))};
  // All coordinates are brought to the scale of the point and the shift, whichever is less.
  const int low = grid.low(), scale = std::min(low, 0);
  for (std::size_t k = 0; k < 3; ++k) {
    Number x = exact3::dot<Fixed<kLong + 1>>(point_[k], p).resized<LongPlane::kLimbs>();
    Number shift = shift_[k].resized<LongPlane::kLimbs>();
    if (!exact3::shift_within(x, low - scale, kMostBits)) return false;
    if (!exact3::shift_within(shift, -scale, kMostBits)) return false;
    image.x[k] = x + shift;
  }
  image.exponent = scale + point_exponent_;
  return true;
}

}  // namespace plumb
