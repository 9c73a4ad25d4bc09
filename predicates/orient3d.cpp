// orient3d beyond its filter.
#include <bit>
#include <cstdlib>

#include "plumb/predicates/big_rung.h"
#include "plumb/predicates/exact_rung.h"
#include "plumb/predicates/input_predicates.h"
#include "plumb/predicates/small_rung.h"

namespace plumb::rung {

namespace {

/// The axes' grids are independent: scaling a column keeps the sign.
struct Grids3 {
  Grid x, y, z;
  int bits() const { return std::max({x.bits(), y.bits(), z.bits()}); }
};

Grids3 grids(const Point3& a, const Point3& b, const Point3& c, const Point3& d) {
  return {Grid{a.x, b.x, c.x, d.x}, Grid{a.y, b.y, c.y, d.y}, Grid{a.z, b.z, c.z, d.z}};
}

template <int L>
struct Columns {
  std::array<Fixed<L>, 3> x, y, z;
};

template <int L>
Columns<L> columns(const Grids3& g, const Point3& a, const Point3& b, const Point3& c,
                   const Point3& d) {
  return {differences<L, 3>(g.x, {a.x, b.x, c.x}, d.x),
          differences<L, 3>(g.y, {a.y, b.y, c.y}, d.y),
          differences<L, 3>(g.z, {a.z, b.z, c.z}, d.z)};
}

/// The power of two that makes integers of the coordinates on a grid, in doubles and without an error, subnormal ones being far
/// from such a grid; 0: not in doubles.
double scale_of(const Grid& g) {
  if (g.bits() > kOneLimbBits || std::abs(g.low()) > 1000) return 0;
  return std::bit_cast<double>(static_cast<std::uint64_t>(1023 - g.low()) << 52);
}

std::array<Fixed<1>, 3> scaled_differences(double scale, const std::array<double, 3>& values,
                                           double origin) {
  const auto at = [scale](double v) { return Fixed<1>(static_cast<std::int64_t>(v * scale)); };
  const Fixed<1> o = at(origin);
  return {at(values[0]) - o, at(values[1]) - o, at(values[2]) - o};
}

template <int Minor, int To, int L>
FilteredSign determinant(const Columns<L>& m) {
  return filtered(dot<To>(m.z, cyclic_minors<Minor>(m.x, m.y)).sign());
}

/// Every difference is <= 2^62. A minor is <= 2^(bx+by+1), the determinant < 2^(bx+by+bz+3).
FilteredSign one_limb(const Columns<1>& m) {
  const int xy = magnitude_bits(m.x) + magnitude_bits(m.y);
  if (xy <= 61) return determinant<1, 2>(m);                         // 62, 126 bits
  if (xy + magnitude_bits(m.z) <= 124) return determinant<2, 2>(m);  // 125, 127 bits
  return determinant<2, 3>(m);                                       // 125, 189 bits
}

}  // namespace

FilteredSign orient3d_small(const Point3& a, const Point3& b, const Point3& c, const Point3& d) {
  return small_sign<12>(detail::orient3d(a, b, c, d),
                        {a.x, a.y, a.z, b.x, b.y, b.z, c.x, c.y, c.z, d.x, d.y, d.z});
}

FilteredSign orient3d_exact(const Point3& a, const Point3& b, const Point3& c, const Point3& d) {
  const Grids3 g = grids(a, b, c, d);
  if (g.bits() <= kOneLimbBits) return one_limb(columns<1>(g, a, b, c, d));
  // Differences <= 2^126: minors <= 2^253, the determinant < 2^381.
  if (g.bits() <= kTwoLimbBits) return determinant<4, 6>(columns<2>(g, a, b, c, d));
  return FilteredSign::Unsure;
}

FilteredSign orient3d_exact(const Grid& grid, const Point3& a, const Point3& b, const Point3& c,
                            const Point3& d) {
  const double scale = scale_of(grid);
  if (scale == 0) return orient3d_exact(a, b, c, d);
  return one_limb({scaled_differences(scale, {a.x, b.x, c.x}, d.x),
                   scaled_differences(scale, {a.y, b.y, c.y}, d.y),
                   scaled_differences(scale, {a.z, b.z, c.z}, d.z)});
}

Sign orient3d_big(const Point3& a, const Point3& b, const Point3& c, const Point3& d) {
  const Grids3 g = grids(a, b, c, d);
  return big_orient3d(big_differences<3>({a.x, b.x, c.x}, d.x, g.x),
                      big_differences<3>({a.y, b.y, c.y}, d.y, g.y),
                      big_differences<3>({a.z, b.z, c.z}, d.z, g.z));
}

Sign orient3d_beyond_filter(const Point3& a, const Point3& b, const Point3& c, const Point3& d) {
  const FilteredSign small = orient3d_small(a, b, c, d);
  if (is_decided(small)) return decide(Predicate::Orient3d, Rung::Small, small);
  const FilteredSign exact = orient3d_exact(a, b, c, d);
  if (is_decided(exact)) return decide(Predicate::Orient3d, Rung::Exact, exact);
  count_rung(Predicate::Orient3d, Rung::Big);
  return orient3d_big(a, b, c, d);
}

}  // namespace plumb::rung
