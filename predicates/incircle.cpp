// incircle beyond its filter.
#include "plumb/predicates/big_rung.h"
#include "plumb/predicates/exact_rung.h"
#include "plumb/predicates/input_predicates.h"
#include "plumb/predicates/small_rung.h"

namespace plumb::rung {

namespace {

/// One grid: the lift adds squares of both axes.
Grid common_grid(const Point2& a, const Point2& b, const Point2& c, const Point2& d) {
  return {a.x, b.x, c.x, d.x, a.y, b.y, c.y, d.y};
}

template <int L>
struct Columns {
  std::array<Fixed<L>, 3> x, y;
};

template <int L>
Columns<L> columns(const Grid& g, const Point2& a, const Point2& b, const Point2& c,
                   const Point2& d) {
  return {differences<L, 3>(g, {a.x, b.x, c.x}, d.x), differences<L, 3>(g, {a.y, b.y, c.y}, d.y)};
}

/// `Square` limbs for minors and lifts.
template <int Square, int To, int L>
FilteredSign determinant(const Columns<L>& m) {
  std::array<Fixed<Square>, 3> lift;
  for (std::size_t i = 0; i < 3; ++i) lift[i] = square<Square>(m.x[i]) + square<Square>(m.y[i]);
  return filtered(dot<To>(lift, cyclic_minors<Square>(m.x, m.y)).sign());
}

/// Every difference is <= 2^62. Minors and lifts are <= 2^(2b+1), the determinant < 2^(4b+4).
FilteredSign one_limb(const Columns<1>& m) {
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
  if (g.bits() <= kOneLimbBits) return one_limb(columns<1>(g, a, b, c, d));
  // Differences <= 2^126: minors and lifts <= 2^253, the determinant < 2^508.
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
