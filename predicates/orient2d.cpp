// orient2d and cross_sign beyond their filters. Both are one determinant of two directions.
#include "plumb/predicates/big_rung.h"
#include "plumb/predicates/exact_rung.h"
#include "plumb/predicates/input_predicates.h"
#include "plumb/predicates/small_rung.h"

namespace plumb::rung {

namespace {

/// The axes' grids are independent: scaling a column keeps the sign.
struct Direction2 {
  const Point2& from;
  const Point2& to;
};

struct Grids2 {
  Grid x, y;
  int bits() const { return std::max(x.bits(), y.bits()); }
};

Grids2 grids(const Direction2& u, const Direction2& v) {
  return {Grid{u.from.x, u.to.x, v.from.x, v.to.x}, Grid{u.from.y, u.to.y, v.from.y, v.to.y}};
}

/// |det| <= 2^(2b+1): with b <= 62 in one limb 125 bits of 127, with b <= 126 in two 253 of 255.
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
