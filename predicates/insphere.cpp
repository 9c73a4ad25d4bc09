// insphere beyond its filter.
#include "plumb/predicates/big_rung.h"
#include "plumb/predicates/exact_rung.h"
#include "plumb/predicates/input_predicates.h"
#include "plumb/predicates/small_rung.h"

namespace plumb::rung {

namespace {

template <int L>
struct Columns {
  std::array<Fixed<L>, 4> x, y, z;
};

/// One grid: the lift adds squares of all axes.
Grid common_grid(const Point3& a, const Point3& b, const Point3& c, const Point3& d,
                 const Point3& e) {
  return {a.x, b.x, c.x, d.x, e.x, a.y, b.y, c.y, d.y, e.y, a.z, b.z, c.z, d.z, e.z};
}

template <int L>
Columns<L> columns(const Grid& g, const Point3& a, const Point3& b, const Point3& c,
                   const Point3& d, const Point3& e) {
  return {differences<L, 4>(g, {a.x, b.x, c.x, d.x}, e.x),
          differences<L, 4>(g, {a.y, b.y, c.y, d.y}, e.y),
          differences<L, 4>(g, {a.z, b.z, c.z, d.z}, e.z)};
}

/// `Square` limbs for 2x2 minors and lifts, `Cube` for 3x3 minors. Shewchuk's expansion:
/// d (abc) - c (abd) + b (acd) - a (bcd), the letters before the brackets being lifts.
template <int Square, int Cube, int To, int L>
FilteredSign determinant(const Columns<L>& m) {
  const auto minor = [&m](std::size_t i, std::size_t j) {
    return minor2<Square>(m.x[i], m.y[i], m.x[j], m.y[j]);
  };
  const auto lift = [&m](std::size_t i) {
    return square<Square>(m.x[i]) + square<Square>(m.y[i]) + square<Square>(m.z[i]);
  };
  const auto cube = [&m](std::size_t i, const Fixed<Square>& jk, std::size_t j,
                         const Fixed<Square>& ik, std::size_t k, const Fixed<Square>& ij) {
    return multiply_to<Cube>(m.z[i], jk) - multiply_to<Cube>(m.z[j], ik) +
           multiply_to<Cube>(m.z[k], ij);
  };
  const auto ab = minor(0, 1), ac = minor(0, 2), ad = minor(0, 3);
  const auto bc = minor(1, 2), bd = minor(1, 3), cd = minor(2, 3);
  const Fixed<To> det = multiply_to<To>(lift(3), cube(0, bc, 1, ac, 2, ab)) -
                        multiply_to<To>(lift(2), cube(0, bd, 1, ad, 3, ab)) +
                        multiply_to<To>(lift(1), cube(0, cd, 2, ad, 3, ac)) -
                        multiply_to<To>(lift(0), cube(1, cd, 2, bd, 3, bc));
  return filtered(det.sign());
}

/// Every difference is <= 2^62. Minors and lifts are < 2^(2b+2), 3x3 minors < 2^(3b+3), the
/// determinant < 2^(5b+7).
FilteredSign one_limb(const Columns<1>& m) {
  const int b = std::max({magnitude_bits(m.x), magnitude_bits(m.y), magnitude_bits(m.z)});
  if (b <= 20) return determinant<1, 1, 2>(m);  // 42, 63, 107 bits
  if (b <= 30) return determinant<1, 2, 3>(m);  // 62, 93, 157 bits
  return determinant<2, 3, 5>(m);               // 126, 189, 317 bits
}

}  // namespace

FilteredSign insphere_small(const Point3& a, const Point3& b, const Point3& c, const Point3& d,
                            const Point3& e) {
  return small_sign<15>(detail::insphere(a, b, c, d, e), {a.x, a.y, a.z, b.x, b.y, b.z, c.x, c.y,
                                                          c.z, d.x, d.y, d.z, e.x, e.y, e.z});
}

FilteredSign insphere_exact(const Point3& a, const Point3& b, const Point3& c, const Point3& d,
                            const Point3& e) {
  const Grid g = common_grid(a, b, c, d, e);
  if (g.bits() <= kOneLimbBits) return one_limb(columns<1>(g, a, b, c, d, e));
  // Differences <= 2^126: minors and lifts < 2^254, 3x3 minors < 2^381, the determinant < 2^637.
  if (g.bits() <= kTwoLimbBits) return determinant<4, 6, 10>(columns<2>(g, a, b, c, d, e));
  return FilteredSign::Unsure;
}

Sign insphere_big(const Point3& a, const Point3& b, const Point3& c, const Point3& d,
                  const Point3& e) {
  const Grid g = common_grid(a, b, c, d, e);
  return big_insphere(big_differences<4>({a.x, b.x, c.x, d.x}, e.x, g),
                      big_differences<4>({a.y, b.y, c.y, d.y}, e.y, g),
                      big_differences<4>({a.z, b.z, c.z, d.z}, e.z, g));
}

Sign insphere_beyond_filter(const Point3& a, const Point3& b, const Point3& c, const Point3& d,
                            const Point3& e) {
  const FilteredSign small = insphere_small(a, b, c, d, e);
  if (is_decided(small)) return decide(Predicate::Insphere, Rung::Small, small);
  const FilteredSign exact = insphere_exact(a, b, c, d, e);
  if (is_decided(exact)) return decide(Predicate::Insphere, Rung::Exact, exact);
  count_rung(Predicate::Insphere, Rung::Big);
  return insphere_big(a, b, c, d, e);
}

}  // namespace plumb::rung
