// Exact points of space in every width, and the forms that compare them.
//
// An operand keeps what defines the point and the least width that holds it; loading computes
// homogeneous coordinates x 2^scale / w by the formulas of point3_exact.h. A point of three planes
// of which two share two input points, as neighbours in a mesh do, is taken as a point on the line
// of these, with smaller numbers. Scales are made equal by shifting the coarser side; if a shift
// breaks the limits (L), the next width is asked.
//
// Tested by tests/predicates/point3_signs_test.cpp, tests/predicates/rounded_point3_test.cpp and
// tests/predicates/frame_test.cpp.

#include "plumb/predicates/space/point3_exact.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdlib>
#include <optional>

#include "plumb/predicates/arithmetic/double_bits.h"

namespace plumb::exact3 {

int width_of_bits(int bits) {
  if (bits <= Narrow::kMaxBits) return Narrow::kIndex;
  if (bits <= Medium::kMaxBits) return Medium::kIndex;
  return bits <= Wide::kMaxBits ? Wide::kIndex : Wide::kIndex + 1;
}

namespace {

/// Sets the line of an operand, and the grid that contains both of its points. If the operand is an
/// input point, the two points are equal.
void set_ends(PointOperand& operand, const PlaneTable& planes, InputPointId a, InputPointId b) {
  operand.ends = {&planes.point(a), &planes.point(b)};
  operand.grid = planes.grid(a);
  operand.grid.add(planes.grid(b));
  operand.width = width_of_bits(operand.grid.bits());
}

/// The numbers that a plane type uses for coordinates and for the values s(y).
template <class Plane>
struct Numbers;
template <class W>
struct Numbers<FixedPlane<W>> {
  using Coordinate = exact3::Coordinate<W>;
  using Offset = exact3::Offset<W>;
  static constexpr int kCoordinateBits = W::kMaxBits;
  static constexpr int kNumeratorBits = 64 * (W::kOffset + 2 * W::kNormal) - 5;
};
template <>
struct Numbers<BigPlane> {
  using Coordinate = Integer;
  using Offset = Integer;
  static constexpr int kCoordinateBits = INT_MAX;
  static constexpr int kNumeratorBits = INT_MAX;
};

/// Returns the integer value / 2^grid.low(). Requires that the type has enough bits for the grid.
template <class Number>
Number on_grid(const Grid& grid, double value) {
  if constexpr (std::is_same_v<Number, Integer>) {
    return to_integer(value, grid.low());
  } else if constexpr (Number::kLimbs == 1) {
    return Number(grid.to_int64(value));
  } else {
    return grid.to_fixed<Number::kLimbs>(value);
  }
}

template <class Plane>
using Coordinates = Vector<typename Numbers<Plane>::Coordinate>;

template <class Plane>
Coordinates<Plane> on_grid(const Grid& grid, const Point3& p) {
  using Number = typename Numbers<Plane>::Coordinate;
  return {on_grid<Number>(grid, p.x), on_grid<Number>(grid, p.y), on_grid<Number>(grid, p.z)};
}

/// Shifts three coordinates. Returns false if a coordinate has more bits than the width allows.
template <class Plane>
bool shift_all(Coordinates<Plane>& x, int shift) {
  return std::all_of(x.begin(), x.end(), [&](auto& c) {
    return shift_within(c, shift, Numbers<Plane>::kCoordinateBits);
  });
}

template <class To, class From>
To widened(const From& x) {
  if constexpr (std::is_same_v<To, Integer>) {
    return x;
  } else {
    return x.template resized<To::kLimbs>();
  }
}

/// Loads the common point of three planes, with all coefficients on the same scale.
template <class Plane>
bool load_three(const PointOperand& operand, Part part, PointOf<Plane>& point) {
  std::array<Plane, 3> planes = {load_as<Plane>(operand.planes[0], part),
                                 load_as<Plane>(operand.planes[1], part),
                                 load_as<Plane>(operand.planes[2], part)};
  if (!align(planes)) return false;
  point = common_point(planes[0], planes[1], planes[2]);
  return true;
}

/// Loads an input point, with w = 1 and without a part with R.
template <class Plane>
bool load_input(const PointOperand& operand, Part part, PointOf<Plane>& point) {
  using T = Types<Plane>;
  if (part == Part::Infinite) {
    for (auto& x : point.x) x = typename T::Numerator(0);
    point.w = typename T::Det3(1);
    point.scale = 0;
    return true;
  }
  const Coordinates<Plane> x = on_grid<Plane>(operand.grid, *operand.ends[0]);
  for (std::size_t i = 0; i < 3; ++i) point.x[i] = widened<typename T::Numerator>(x[i]);
  point.w = typename T::Det3(1);
  point.scale = operand.grid.low();
  return true;
}

/// Sets P1 = (a - b) d, with the w of the finite part.
template <class Plane>
void load_line_infinite(const PointOperand& operand, PointOf<Plane>& point) {
  using T = Types<Plane>;
  using Value = typename Numbers<Plane>::Offset;
  const Plane plane = load_as<Plane>(operand.planes[0], Part::Infinite);
  const Coordinates<Plane> a = on_grid<Plane>(operand.grid, *operand.ends[0]);
  const Coordinates<Plane> b = on_grid<Plane>(operand.grid, *operand.ends[1]);
  for (std::size_t i = 0; i < 3; ++i) {
    point.x[i] = product<typename T::Numerator>(a[i], plane.d) -
                 product<typename T::Numerator>(b[i], plane.d);
  }
  point.w = widened<typename T::Det3>(dot<Value>(plane.n, b)) -
            widened<typename T::Det3>(dot<Value>(plane.n, a));
  point.scale = 0;
}

/// Sets x = a s(b) - b s(a) and w = s(b) - s(a), where the plane and the points are on one scale.
template <class Plane>
bool load_line(const PointOperand& operand, Part part, PointOf<Plane>& point) {
  using T = Types<Plane>;
  using Value = typename Numbers<Plane>::Offset;
  if (part == Part::Infinite) {
    load_line_infinite<Plane>(operand, point);
    return true;
  }
  Plane plane = load_as<Plane>(operand.planes[0], part);
  Coordinates<Plane> a = on_grid<Plane>(operand.grid, *operand.ends[0]);
  Coordinates<Plane> b = on_grid<Plane>(operand.grid, *operand.ends[1]);
  const int low = operand.grid.low(), scale = std::min(low, plane.scale);
  if (!shift_all<Plane>(a, low - scale) || !shift_all<Plane>(b, low - scale)) return false;
  if (plane.scale != kAnyScale && !shift_within(plane.d, plane.scale - scale, offset_bits(plane))) {
    return false;
  }
  const Value at_a = dot<Value>(plane.n, a) + plane.d;
  const Value at_b = dot<Value>(plane.n, b) + plane.d;
  for (std::size_t i = 0; i < 3; ++i) {
    point.x[i] =
        product<typename T::Numerator>(a[i], at_b) - product<typename T::Numerator>(b[i], at_a);
  }
  point.w = widened<typename T::Det3>(at_b) - widened<typename T::Det3>(at_a);
  point.scale = scale;
  return true;
}

}  // namespace

bool has_frame(const PointOperand& operand) {
  const auto end = operand.planes.begin() + static_cast<std::ptrdiff_t>(operand.plane_count);
  return std::any_of(operand.planes.begin(), end,
                     [](const Operand& plane) { return plane.source.is_frame(); });
}

namespace {

/// Returns two input points that occur in the definitions of both planes, if there are two. The
/// line of the planes is the line through these points.
std::optional<std::array<InputPointId, 2>> common_points(const PlaneSource& p,
                                                         const PlaneSource& q) {
  if (p.is_explicit() || q.is_explicit()) return {};
  std::array<InputPointId, 2> common;
  std::size_t count = 0;
  for (const std::uint32_t x : p.code) {
    const bool is_common = x == q.code[0] || x == q.code[1] || x == q.code[2];
    if (is_common && count < 2) common[count++] = InputPointId(x);
  }
  if (count < 2) return {};
  return common;
}

}  // namespace

PointSource as_line(const PlaneTable& planes, const PointSource& source) {
  if (source.is_line()) return source;
  for (std::size_t i = 0; i < 3; ++i) {
    const PlaneId p = source.plane(i), q = source.plane((i + 1) % 3),
                  other = source.plane((i + 2) % 3);
    if (planes.is_frame(other)) continue;
    const auto common = common_points(planes.source(p), planes.source(q));
    if (common) return {(*common)[0], (*common)[1], other};
  }
  return source;
}

bool is_across(const PlaneTable& planes, PlaneId plane, std::size_t axis) {
  const std::size_t i = (axis + 1) % 3, j = (axis + 2) % 3;
  const PlaneRow& row = planes.row(plane);
  // A component that is exactly zero is stored as zero.
  if (row.n[i] != 0 || row.n[j] != 0) return false;
  const PlaneSource& source = planes.source(plane);
  if (!source.is_explicit()) {
    const auto bits = [&](std::size_t k) {
      return std::bit_cast<std::uint64_t>(coordinate(planes.points()[source.code[k]], axis));
    };
    return bits(0) == bits(1) && bits(0) == bits(2);
  }
  const PlaneSlot& slot = planes.slot(source);
  const auto is_zero = [&](std::size_t k) {
    const std::uint64_t* const limbs = planes.limbs(slot) + k * slot.limbs;
    return std::all_of(limbs, limbs + slot.limbs, [](std::uint64_t limb) { return limb == 0; });
  };
  return is_zero(i) && is_zero(j);
}

std::optional<double> coordinate_across(const PlaneTable& planes, PlaneId plane, std::size_t axis) {
  constexpr int kMostBits = 53, kMostScale = 900;
  const PlaneSource& source = planes.source(plane);
  if (!source.is_explicit()) return coordinate(planes.points()[source.code[0]], axis);
  const PlaneSlot& slot = planes.slot(source);
  if (source.is_frame() || slot.limbs != 1 || slot.offset_bits > kMostBits) return {};
  const std::uint64_t* const row = planes.limbs(slot);
  if (row[axis] != 1 || std::abs(slot.scale) > kMostScale) return {};
  return std::ldexp(-static_cast<double>(static_cast<std::int64_t>(row[3])), slot.scale);
}

namespace {

/// Whether two points differ at most in the coordinate along an axis.
bool are_along(const Point3& p, const Point3& q, std::size_t axis) {
  const std::size_t i = (axis + 1) % 3, j = (axis + 2) % 3;
  return is_equal(coordinate(p, i), coordinate(q, i)) &&
         is_equal(coordinate(p, j), coordinate(q, j));
}

/// Whether two of the input points that define a plane show that it is parallel to an axis.
bool is_parallel(const PlaneTable& planes, PlaneId plane, std::size_t axis) {
  const PlaneSource& source = planes.source(plane);
  if (source.is_explicit() || planes.row(plane).n[axis] != 0) return false;
  const auto corner = [&](std::size_t i) { return planes.points()[source.code[i]]; };
  return are_along(corner(0), corner(1), axis) || are_along(corner(1), corner(2), axis) ||
         are_along(corner(2), corner(0), axis);
}

/// Returns an input point that occurs in the definitions of both planes, if there is one.
std::optional<InputPointId> common_point(const PlaneSource& p, const PlaneSource& q) {
  if (p.is_explicit()) return {};
  const auto* const found =
      std::ranges::find_if(p.code, [&](std::uint32_t x) { return q.has_point(InputPointId(x)); });
  if (found == p.code.end()) return {};
  return InputPointId(*found);
}

}  // namespace

std::optional<double> coordinate_along(const PlaneTable& planes, const PointSource& source,
                                       std::size_t axis) {
  const PointSource line = as_line(planes, source);
  if (line.is_line()) {
    const double c = coordinate(planes.point(line.end(0)), axis);
    if (!is_equal(c, coordinate(planes.point(line.end(1)), axis))) return {};
    return c;
  }
  for (std::size_t i = 0; i < 3; ++i) {
    const PlaneId p = source.plane(i), q = source.plane((i + 1) % 3);
    const auto common = common_point(planes.source(p), planes.source(q));
    if (!common) continue;
    for (const std::size_t other : {(axis + 1) % 3, (axis + 2) % 3}) {
      if (is_parallel(planes, p, other) && is_parallel(planes, q, other)) {
        return coordinate(planes.point(*common), axis);
      }
    }
  }
  return {};
}

/// The width is the greatest of the widths of the planes and of the grid of the line's points.
PointOperand operand(const Point3Table& points, const PointSource& given) {
  const PlaneTable& planes = points.planes();
  const PointSource source = as_line(planes, given);
  PointOperand result;
  if (source.is_line()) {
    set_ends(result, planes, source.end(0), source.end(1));
  }
  result.plane_count = source.plane_count();
  for (std::size_t i = 0; i < result.plane_count; ++i) {
    result.planes[i] = operand(planes, source.plane(i));
    result.width = std::max(result.width, result.planes[i].width);
  }
  return result;
}

PointOperand operand(const Point3Table& points, SpacePoint point) {
  if (!point.is_input()) return operand(points, points.source(point));
  PointOperand result;
  set_ends(result, points.planes(), point.input(), point.input());
  return result;
}

namespace {

template <class Plane>
Plane load_whole(const Operand& operand) {
  if constexpr (std::is_same_v<Plane, BigPlane>) {
    return load_big(operand);
  } else if constexpr (std::is_same_v<Plane, FixedPlane<Narrow>>) {
    return load<Narrow>(operand);
  } else if constexpr (std::is_same_v<Plane, FixedPlane<Medium>>) {
    return load<Medium>(operand);
  } else {
    return load<Wide>(operand);
  }
}

}  // namespace

template <class Plane>
Plane load_as(const Operand& operand, Part part) {
  Plane plane = load_whole<Plane>(operand);
  take_part(operand, part, plane);
  return plane;
}

template <class Plane>
bool load_point(const PointOperand& operand, Part part, PointOf<Plane>& point) {
  if (operand.plane_count == 3) return load_three<Plane>(operand, part, point);
  return operand.plane_count == 1 ? load_line<Plane>(operand, part, point)
                                  : load_input<Plane>(operand, part, point);
}

/// The scales are made equal by shifting either the offset or the coordinates, whichever has the
/// coarser scale.
template <class Plane>
FilteredSign side_sign(PointOf<Plane> point, Plane plane) {
  const int shift = plane.scale == kAnyScale ? 0 : plane.scale - point.scale;
  if (!shift_within(plane.d, std::max(shift, 0), offset_bits(plane))) return FilteredSign::Unsure;
  for (auto& x : point.x) {
    if (!shift_within(x, std::max(-shift, 0), Numbers<Plane>::kNumeratorBits)) {
      return FilteredSign::Unsure;
    }
  }
  return filtered(value_sign(point, plane) * sign_of(point.w));
}

/// x / v - y / w has the sign of (x w - y v) v w. The degree in input coordinates is 13.
template <class Plane>
FilteredSign axis_order(const PointOf<Plane>& x, const PointOf<Plane>& y, std::size_t axis) {
  auto a = x.x[axis], b = y.x[axis];
  const int shift = x.scale - y.scale;
  if (!shift_within(a, std::max(shift, 0), Numbers<Plane>::kNumeratorBits) ||
      !shift_within(b, std::max(-shift, 0), Numbers<Plane>::kNumeratorBits)) {
    return FilteredSign::Unsure;
  }
  Sign difference = Sign::Zero;
  if constexpr (std::is_same_v<Plane, BigPlane>) {
    difference = sign_of(Integer(a * y.w - b * x.w));
  } else {
    difference = sign_of(multiply(a, y.w) - multiply(b, x.w));
  }
  return filtered(difference * sign_of(x.w) * sign_of(y.w));
}

#define PLUMB_EXACT3_INSTANCE(PLANE)                                                    \
  template PLANE load_as<PLANE>(const Operand&, Part);                                  \
  template bool load_point<PLANE>(const PointOperand&, Part, PointOf<PLANE>&);          \
  template FilteredSign side_sign<PLANE>(PointOf<PLANE>, PLANE);                        \
  template FilteredSign axis_order<PLANE>(const PointOf<PLANE>&, const PointOf<PLANE>&, \
                                          std::size_t);
PLUMB_EXACT3_INSTANCE(FixedPlane<Narrow>)
PLUMB_EXACT3_INSTANCE(FixedPlane<Medium>)
PLUMB_EXACT3_INSTANCE(FixedPlane<Wide>)
PLUMB_EXACT3_INSTANCE(BigPlane)
#undef PLUMB_EXACT3_INSTANCE

namespace {

const Integer& integer(const Integer& x) { return x; }
template <int L>
Integer integer(const Fixed<L>& x) {
  std::array<std::uint64_t, L> limbs;
  for (int i = 0; i < L; ++i) limbs[static_cast<std::size_t>(i)] = x.limb(i);
  return integer_from_limbs(limbs.data(), L);
}

/// Sets the row in the numbers of Plane. Returns false if the point does not fit into these
/// numbers.
template <class Plane>
bool load_row(const PointOperand& operand, Part part, IntegerRow& row) {
  PointOf<Plane> p;
  if (!load_point<Plane>(operand, part, p)) return false;
  const int up = std::max(p.scale, 0), down = std::max(-p.scale, 0);
  row = {shifted(integer(p.x[0]), up), shifted(integer(p.x[1]), up), shifted(integer(p.x[2]), up),
         shifted(integer(p.w), down)};
  return true;
}

}  // namespace

/// The row is computed in the narrowest width, because GMP takes twenty times as long.
IntegerRow integer_row(const PointOperand& operand, Part part) {
  IntegerRow row;
  const bool is_loaded =
      (operand.width <= Narrow::kIndex && load_row<FixedPlane<Narrow>>(operand, part, row)) ||
      (operand.width <= Medium::kIndex && load_row<FixedPlane<Medium>>(operand, part, row)) ||
      (operand.width <= Wide::kIndex && load_row<FixedPlane<Wide>>(operand, part, row));
  if (!is_loaded) load_row<BigPlane>(operand, part, row);
  return row;
}

/// Both parts have the same w. Divided by the gcd of all coordinates, they are equal rows for equal
/// points up to the sign, which the leading residue takes out.
Fingerprint primitive_fingerprint(const PointOperand& operand) {
  PointOf<BigPlane> finite, infinite;
  load_point<BigPlane>(operand, Part::Finite, finite);
  load_point<BigPlane>(operand, Part::Infinite, infinite);
  const int low = std::min({finite.scale, infinite.scale, 0});
  Integer w = shifted(finite.w, -low), divisor = w;
  for (std::size_t i = 0; i < 3; ++i) {
    finite.x[i] <<= static_cast<unsigned>(finite.scale - low);
    infinite.x[i] <<= static_cast<unsigned>(infinite.scale - low);
    divisor = gcd(divisor, gcd(finite.x[i], infinite.x[i]));
  }
  ResidueRow row;
  for (std::size_t i = 0; i < 3; ++i) {
    row[i] = Residue::of(Integer(finite.x[i] / divisor)) +
             kFrameResidue * Residue::of(Integer(infinite.x[i] / divisor));
  }
  row[3] = Residue::of(Integer(w / divisor));
  return fingerprint(row);
}

}  // namespace plumb::exact3
