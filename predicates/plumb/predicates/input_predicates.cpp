// The predicates on points of doubles, after their filters: small integers, integers of a fixed
// width, and GMP.
//
// The inline filters (input_filters.h) answer most calls; what is left comes here. Each predicate
// first asks whether the filter's own evaluation was exact (small_sign()). Then it brings the
// coordinates onto a common grid, where they are integers, and picks the fewest limbs that hold
// every intermediate value of the determinant. Coordinates of more than 125 bits go to GMP.
//
// The widths follow from the bounds in determinants.h, which docs/design/numbers.md (Fixed widths
// for input points) proves. Comments behind the cases give the bits of minors and determinants.
//
// Tested by tests/predicates/input_predicates_test.cpp,
// tests/predicates/predicate_properties_test.cpp and tests/predicates/rung_reach_test.cpp.

#include "plumb/predicates/input_predicates.h"

#include <bit>
#include <cstdlib>

#include "plumb/predicates/input/determinants.h"

namespace plumb::rung {

namespace {

/// A difference of two points. Both orient2d and cross_sign are a determinant of two differences.
struct Direction2 {
  const Point2& from;
  const Point2& to;
};

/// Each axis has its own grid, because scaling a column of the determinant does not change the
/// sign.
struct Grids2 {
  Grid x, y;
  int bits() const { return std::max(x.bits(), y.bits()); }
};

Grids2 grids(const Direction2& u, const Direction2& v) {
  return {Grid{u.from.x, u.to.x, v.from.x, v.to.x}, Grid{u.from.y, u.to.y, v.from.y, v.to.y}};
}

/// Returns the sign of the determinant in 2 L limbs. Differences are at most 2^b in size, and
/// |det| <= 2^(2b+1): 125 bits of 127 for b = 62 (L = 1), 253 of 255 for b = 126 (L = 2).
template <int L>
FilteredSign determinant(const Grids2& g, const Direction2& u, const Direction2& v) {
  const auto difference = [](const Grid& grid, double to, double from) {
    return on_grid<L>(grid, to) - on_grid<L>(grid, from);
  };
  return filtered(
      minor2<2 * L>(difference(g.x, u.to.x, u.from.x), difference(g.y, u.to.y, u.from.y),
                    difference(g.x, v.to.x, v.from.x), difference(g.y, v.to.y, v.from.y))
          .sign());
}

FilteredSign exact_cross(const Direction2& u, const Direction2& v) {
  const Grids2 g = grids(u, v);
  if (g.bits() <= kOneLimbBits) return determinant<1>(g, u, v);
  if (g.bits() <= kTwoLimbBits) return determinant<2>(g, u, v);
  return FilteredSign::Unsure;
}

Integer big_difference(const Grid& grid, double to, double from) {
  return big_on_grid(grid, to) - big_on_grid(grid, from);
}

Sign big_cross_of(const Direction2& u, const Direction2& v) {
  const Grids2 g = grids(u, v);
  return big_cross({big_difference(g.x, u.to.x, u.from.x), big_difference(g.x, v.to.x, v.from.x)},
                   {big_difference(g.y, u.to.y, u.from.y), big_difference(g.y, v.to.y, v.from.y)});
}

}  // namespace

FilteredSign cross_sign_small(const Point2& a, const Point2& b, const Point2& c, const Point2& d) {
  return small_sign<8>(detail::cross_sign(a, b, c, d), {a.x, a.y, b.x, b.y, c.x, c.y, d.x, d.y});
}

FilteredSign cross_sign_exact(const Point2& a, const Point2& b, const Point2& c, const Point2& d) {
  return exact_cross({a, b}, {c, d});
}

Sign cross_sign_big(const Point2& a, const Point2& b, const Point2& c, const Point2& d) {
  return big_cross_of({a, b}, {c, d});
}

Sign cross_sign_beyond_filter(const Point2& a, const Point2& b, const Point2& c, const Point2& d) {
  const FilteredSign small = cross_sign_small(a, b, c, d);
  if (is_decided(small)) return decide(Predicate::CrossSign, Rung::Small, small);
  const FilteredSign exact = cross_sign_exact(a, b, c, d);
  if (is_decided(exact)) return decide(Predicate::CrossSign, Rung::Exact, exact);
  count_rung(Predicate::CrossSign, Rung::Big);
  return cross_sign_big(a, b, c, d);
}

FilteredSign orient2d_small(const Point2& a, const Point2& b, const Point2& c) {
  return small_sign<6>(detail::orient2d(a, b, c), {a.x, a.y, b.x, b.y, c.x, c.y});
}

FilteredSign orient2d_exact(const Point2& a, const Point2& b, const Point2& c) {
  return exact_cross({c, a}, {c, b});
}

Sign orient2d_big(const Point2& a, const Point2& b, const Point2& c) {
  return big_cross_of({c, a}, {c, b});
}

Sign orient2d_beyond_filter(const Point2& a, const Point2& b, const Point2& c) {
  const FilteredSign small = orient2d_small(a, b, c);
  if (is_decided(small)) return decide(Predicate::Orient2d, Rung::Small, small);
  const FilteredSign exact = orient2d_exact(a, b, c);
  if (is_decided(exact)) return decide(Predicate::Orient2d, Rung::Exact, exact);
  count_rung(Predicate::Orient2d, Rung::Big);
  return orient2d_big(a, b, c);
}

}  // namespace plumb::rung

// The stages of orient3d after its filter.
namespace plumb::rung {

namespace {

/// Each axis has its own grid, because scaling a column of the determinant does not change the
/// sign.
struct Grids3 {
  Grid x, y, z;
  int bits() const { return std::max({x.bits(), y.bits(), z.bits()}); }
};

Grids3 grids(const Point3& a, const Point3& b, const Point3& c, const Point3& d) {
  return {Grid{a.x, b.x, c.x, d.x}, Grid{a.y, b.y, c.y, d.y}, Grid{a.z, b.z, c.z, d.z}};
}

template <int L>
struct OrientColumns {
  std::array<Fixed<L>, 3> x, y, z;
};

template <int L>
OrientColumns<L> columns(const Grids3& g, const Point3& a, const Point3& b, const Point3& c,
                         const Point3& d) {
  return {differences<L, 3>(g.x, {a.x, b.x, c.x}, d.x),
          differences<L, 3>(g.y, {a.y, b.y, c.y}, d.y),
          differences<L, 3>(g.z, {a.z, b.z, c.z}, d.z)};
}

/// Returns the power of two that, in exact products of doubles, makes the coordinates integers on a
/// grid; 0 if there is none. Subnormal coordinates never lie on such a grid, so FTZ and DAZ do not
/// matter.
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
FilteredSign determinant(const OrientColumns<L>& m) {
  return filtered(dot<To>(m.z, cyclic_minors<Minor>(m.x, m.y)).sign());
}

/// Picks the limbs of minors and determinant by the bits of the differences, which are at most 2^62
/// in size. A minor is at most 2^(bx+by+1), the determinant less than 2^(bx+by+bz+3).
FilteredSign orient3d_in_one_limb(const OrientColumns<1>& m) {
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
  if (g.bits() <= kOneLimbBits) return orient3d_in_one_limb(columns<1>(g, a, b, c, d));
  // Differences are at most 2^126, minors at most 2^253, the determinant is less than 2^381.
  if (g.bits() <= kTwoLimbBits) return determinant<4, 6>(columns<2>(g, a, b, c, d));
  return FilteredSign::Unsure;
}

FilteredSign orient3d_exact(const Grid& grid, const Point3& a, const Point3& b, const Point3& c,
                            const Point3& d) {
  const double scale = scale_of(grid);
  if (scale == 0) return orient3d_exact(a, b, c, d);
  return orient3d_in_one_limb({scaled_differences(scale, {a.x, b.x, c.x}, d.x),
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

// The stages of incircle after its filter.
namespace plumb::rung {

namespace {

/// Returns one grid for both axes, because the lift adds the squares of both coordinates.
Grid common_grid(const Point2& a, const Point2& b, const Point2& c, const Point2& d) {
  return {a.x, b.x, c.x, d.x, a.y, b.y, c.y, d.y};
}

template <int L>
struct IncircleColumns {
  std::array<Fixed<L>, 3> x, y;
};

template <int L>
IncircleColumns<L> columns(const Grid& g, const Point2& a, const Point2& b, const Point2& c,
                           const Point2& d) {
  return {differences<L, 3>(g, {a.x, b.x, c.x}, d.x), differences<L, 3>(g, {a.y, b.y, c.y}, d.y)};
}

/// Returns the sign of the determinant in `To` limbs, with `Square` limbs for minors and lifts.
template <int Square, int To, int L>
FilteredSign determinant(const IncircleColumns<L>& m) {
  std::array<Fixed<Square>, 3> lift;
  for (std::size_t i = 0; i < 3; ++i) lift[i] = square<Square>(m.x[i]) + square<Square>(m.y[i]);
  return filtered(dot<To>(lift, cyclic_minors<Square>(m.x, m.y)).sign());
}

/// Picks the limbs by the bits of the differences, which are at most 2^62 in size. Minors and lifts
/// are at most 2^(2b+1), the determinant is less than 2^(4b+4).
FilteredSign incircle_in_one_limb(const IncircleColumns<1>& m) {
  const int b = std::max(magnitude_bits(m.x), magnitude_bits(m.y));
  if (b <= 30) return determinant<1, 2>(m);  // 61, 124 bits
  return determinant<2, 4>(m);               // 125, 252 bits
}

}  // namespace

FilteredSign incircle_small(const Point2& a, const Point2& b, const Point2& c, const Point2& d) {
  return small_sign<8>(detail::incircle(a, b, c, d), {a.x, a.y, b.x, b.y, c.x, c.y, d.x, d.y});
}

FilteredSign incircle_exact(const Point2& a, const Point2& b, const Point2& c, const Point2& d) {
  const Grid g = common_grid(a, b, c, d);
  if (g.bits() <= kOneLimbBits) return incircle_in_one_limb(columns<1>(g, a, b, c, d));
  // Differences are at most 2^126, minors and lifts at most 2^253, the determinant is less than
  // 2^508.
  if (g.bits() <= kTwoLimbBits) return determinant<4, 8>(columns<2>(g, a, b, c, d));
  return FilteredSign::Unsure;
}

Sign incircle_big(const Point2& a, const Point2& b, const Point2& c, const Point2& d) {
  const Grid g = common_grid(a, b, c, d);
  return big_incircle(big_differences<3>({a.x, b.x, c.x}, d.x, g),
                      big_differences<3>({a.y, b.y, c.y}, d.y, g));
}

Sign incircle_beyond_filter(const Point2& a, const Point2& b, const Point2& c, const Point2& d) {
  const FilteredSign small = incircle_small(a, b, c, d);
  if (is_decided(small)) return decide(Predicate::Incircle, Rung::Small, small);
  const FilteredSign exact = incircle_exact(a, b, c, d);
  if (is_decided(exact)) return decide(Predicate::Incircle, Rung::Exact, exact);
  count_rung(Predicate::Incircle, Rung::Big);
  return incircle_big(a, b, c, d);
}

}  // namespace plumb::rung

// The stages of insphere after its filter.
namespace plumb::rung {

namespace {

template <int L>
struct InsphereColumns {
  std::array<Fixed<L>, 4> x, y, z;
};

/// Returns one grid for all axes, because the lift adds the squares of all coordinates.
Grid common_grid(const Point3& a, const Point3& b, const Point3& c, const Point3& d,
                 const Point3& e) {
  return {a.x, b.x, c.x, d.x, e.x, a.y, b.y, c.y, d.y, e.y, a.z, b.z, c.z, d.z, e.z};
}

template <int L>
InsphereColumns<L> columns(const Grid& g, const Point3& a, const Point3& b, const Point3& c,
                           const Point3& d, const Point3& e) {
  return {differences<L, 4>(g, {a.x, b.x, c.x, d.x}, e.x),
          differences<L, 4>(g, {a.y, b.y, c.y, d.y}, e.y),
          differences<L, 4>(g, {a.z, b.z, c.z, d.z}, e.z)};
}

/// Returns the sign of the determinant in `To` limbs, with `Square` limbs for 2 x 2 minors and
/// lifts and `Cube` for 3 x 3 minors. The expansion is that of J. R. Shewchuk (1997): d (abc) - c
/// (abd) + b (acd) - a (bcd), where the letters before the brackets are lifts.
template <int Square, int Cube, int To, int L>
FilteredSign determinant(const InsphereColumns<L>& m) {
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

/// Picks the limbs by the bits of the differences, which are at most 2^62 in size. Minors and lifts
/// are less than 2^(2b+2), 3 x 3 minors less than 2^(3b+3), the determinant less than 2^(5b+7).
FilteredSign insphere_in_one_limb(const InsphereColumns<1>& m) {
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
  if (g.bits() <= kOneLimbBits) return insphere_in_one_limb(columns<1>(g, a, b, c, d, e));
  // Differences are at most 2^126, minors and lifts less than 2^254, 3 x 3 minors less than 2^381,
  // the determinant is less than 2^637.
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
