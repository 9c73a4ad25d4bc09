// Loading of exact planes, and their determinants in each width.
//
// A plane through input points is computed from them each time, which costs less than fetching
// stored coefficients; other planes are read from their limbs. The width of an operand is the least
// that holds its coefficients by condition (L) of plane_exact.h, which bounds everything that is
// computed from them (docs/design/numbers.md, Planes).
//
// Tested by tests/predicates/plane_exact_test.cpp.

#include "plumb/predicates/space/plane_exact.h"

#include "plumb/predicates/arithmetic/double_bits.h"
#include "plumb/predicates/input_predicates.h"

// Inlines all functions that a function calls. Without this attribute, g++ calls the function of
// every product of a determinant with operands in memory, which takes a tenth of the time. For the
// width Wide, inlining is slower because of accesses to the stack.
#ifdef PLUMB_PORTABLE
#define PLUMB_FLATTEN
#else
#define PLUMB_FLATTEN [[gnu::flatten]]
#endif

namespace plumb::exact3 {

namespace {

/// Returns the three input points of a source.
std::array<const Point3*, 3> corners(const PlaneTable& table, const PlaneSource& source) {
  const std::span<const Point3> points = table.points();
  return {&points[source.code[0]], &points[source.code[1]], &points[source.code[2]]};
}

Grid grid_of(const PlaneTable& table, const PlaneSource& source) {
  Grid grid = table.grid(InputPointId(source.code[0]));
  grid.add(table.grid(InputPointId(source.code[1])));
  grid.add(table.grid(InputPointId(source.code[2])));
  return grid;
}

template <int C>
Fixed<C> on_grid(const Grid& grid, double value) {
  if constexpr (C == 1) {
    return Fixed<1>(grid.to_int64(value));
  } else {
    return grid.to_fixed<C>(value);
  }
}

template <int C>
Vector<Fixed<C>> on_grid(const Grid& grid, const Point3& p) {
  return {on_grid<C>(grid, p.x), on_grid<C>(grid, p.y), on_grid<C>(grid, p.z)};
}

Vector<Integer> on_grid(int low, const Point3& p) {
  return {to_integer(p.x, low), to_integer(p.y, low), to_integer(p.z, low)};
}

template <class Number>
Vector<Number> difference(const Vector<Number>& a, const Vector<Number>& b) {
  return {Number(a[0] - b[0]), Number(a[1] - b[1]), Number(a[2] - b[2])};
}

template <class W>
PLUMB_FLATTEN FixedPlane<W> load_corners(const Grid& grid, const std::array<const Point3*, 3>& at) {
  const auto p = on_grid<W::kCoordinate>(grid, *at[0]);
  const auto q = on_grid<W::kCoordinate>(grid, *at[1]);
  const auto r = on_grid<W::kCoordinate>(grid, *at[2]);
  FixedPlane<W> plane;
  plane.n = cross<Normal<W>>(difference(q, p), difference(r, p));
  plane.d = -dot<Offset<W>>(plane.n, p);
  plane.scale = plane.d.is_zero() ? kAnyScale : grid.low();
  return plane;
}

template <class W>
FixedPlane<W> load_slot(const PlaneTable& table, const PlaneSlot& slot) {
  const std::uint64_t* limbs = table.limbs(slot);
  FixedPlane<W> plane;
  for (std::size_t i = 0; i < 3; ++i) {
    plane.n[i] = fixed_from_limbs<W::kNormal>(limbs + i * slot.limbs, slot.limbs);
  }
  plane.d = fixed_from_limbs<W::kOffset>(limbs + std::size_t{3} * slot.limbs, slot.limbs);
  plane.scale = plane.d.is_zero() ? kAnyScale : slot.scale;
  return plane;
}

template <class W>
bool holds(int normal_bits, int offset_bits) {
  return normal_bits <= 64 * W::kNormal - 3 && offset_bits <= 64 * W::kOffset - 2;
}

int slot_width(const PlaneSlot& slot) {
  if (holds<Narrow>(slot.normal_bits, slot.offset_bits)) return Narrow::kIndex;
  if (holds<Medium>(slot.normal_bits, slot.offset_bits)) return Medium::kIndex;
  return holds<Wide>(slot.normal_bits, slot.offset_bits) ? Wide::kIndex : Wide::kIndex + 1;
}

int grid_width(int bits) {
  if (bits <= Narrow::kMaxBits) return Narrow::kIndex;
  if (bits <= Medium::kMaxBits) return Medium::kIndex;
  return bits <= Wide::kMaxBits ? Wide::kIndex : Wide::kIndex + 1;
}

BigPlane load_big_corners(int low, const std::array<const Point3*, 3>& at) {
  const auto p = on_grid(low, *at[0]);
  BigPlane plane;
  plane.n =
      cross<Integer>(difference(on_grid(low, *at[1]), p), difference(on_grid(low, *at[2]), p));
  plane.d = -dot<Integer>(plane.n, p);
  plane.scale = plane.d.is_zero() ? kAnyScale : low;
  return plane;
}

}  // namespace

// The canonical normal of a plane across an axis points along the axis, towards greater
// coordinates.
FilteredSign side_across(const PlaneTable& table, InputPointId x, const PlaneSource& plane) {
  constexpr std::array kCoordinates{&Point3::x, &Point3::y, &Point3::z};
  const auto [p, q, r] = corners(table, plane);
  for (const auto c : kCoordinates) {
    if (!is_equal(p->*c, q->*c) || !is_equal(p->*c, r->*c)) continue;
    return filtered(compare(table.point(x).*c, p->*c));
  }
  return FilteredSign::Unsure;
}

FilteredSign side_by_corners(const PlaneTable& table, InputPointId x, const PlaneSource& plane) {
  const FilteredSign s = side_across(table, x, plane);
  if (is_decided(s)) return s;
  Grid grid = grid_of(table, plane);
  grid.add(table.grid(x));
  const auto [p, q, r] = corners(table, plane);
  // The sign is positive above the plane.
  return rung::orient3d_exact(grid, *q, *p, *r, table.point(x));
}

Operand operand(const PlaneTable& table, const PlaneSource& source) {
  if (source.is_explicit()) return {&table, source, Grid{}, slot_width(table.slot(source))};
  const Grid grid = grid_of(table, source);
  return {&table, source, grid, grid_width(grid.bits())};
}

// For g++, the definition of a template determines its visibility, not the declaration in the
// header.
#pragma GCC visibility push(default)
template <class W>
FixedPlane<W> load(const Operand& operand) {
  const PlaneTable& table = *operand.table;
  if (operand.source.is_explicit()) return load_slot<W>(table, table.slot(operand.source));
  return load_corners<W>(operand.grid, corners(table, operand.source));
}

#pragma GCC visibility pop

template FixedPlane<Narrow> load(const Operand&);
template FixedPlane<Medium> load(const Operand&);
template FixedPlane<Wide> load(const Operand&);

BigPlane load_big(const Operand& operand) {
  const PlaneTable& table = *operand.table;
  if (!operand.source.is_explicit()) {
    return load_big_corners(operand.grid.low(), corners(table, operand.source));
  }
  const PlaneSlot& slot = table.slot(operand.source);
  const std::uint64_t* limbs = table.limbs(slot);
  BigPlane plane;
  for (std::size_t i = 0; i < 3; ++i) {
    plane.n[i] = integer_from_limbs(limbs + i * slot.limbs, slot.limbs);
  }
  plane.d = integer_from_limbs(limbs + std::size_t{3} * slot.limbs, slot.limbs);
  plane.scale = plane.d.is_zero() ? kAnyScale : slot.scale;
  return plane;
}

template <>
PLUMB_FLATTEN Determinants<FixedPlane<Narrow>> determinants(const FixedPlane<Narrow>& p,
                                                            const FixedPlane<Narrow>& q,
                                                            const FixedPlane<Narrow>& r,
                                                            const FixedPlane<Narrow>& s) {
  return expand(p, q, r, s);
}

template <>
PLUMB_FLATTEN Determinants<FixedPlane<Medium>> determinants(const FixedPlane<Medium>& p,
                                                            const FixedPlane<Medium>& q,
                                                            const FixedPlane<Medium>& r,
                                                            const FixedPlane<Medium>& s) {
  return expand(p, q, r, s);
}

template <>
Determinants<FixedPlane<Wide>> determinants(const FixedPlane<Wide>& p, const FixedPlane<Wide>& q,
                                            const FixedPlane<Wide>& r, const FixedPlane<Wide>& s) {
  return expand(p, q, r, s);
}

template <>
Determinants<BigPlane> determinants(const BigPlane& p, const BigPlane& q, const BigPlane& r,
                                    const BigPlane& s) {
  return expand(p, q, r, s);
}

}  // namespace plumb::exact3
