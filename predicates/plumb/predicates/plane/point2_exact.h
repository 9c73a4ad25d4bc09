// Points and lines of the plane as integer triples: the Big rung's arithmetic. Internal.
//
// Notation: a point P = (X : Y : W) is (X / W, Y / W); a line L = (A : B : C) is A x + B y + C = 0.
//   join(P, Q) = P x Q     the line through P and Q
//   meet(L, M) = L x M     the point where L and M meet; W = 0 when they are parallel
//   dot(L, P)              = orient2d(P1, P2, P) W_1 W_2 W_P for L = join(P1, P2)
//   meet(L, M).W           = (P2 - P1) x (Q2 - Q1) W_1 .. W_4 for the joins of P1 P2 and Q1 Q2
// so that, input points having W > 0, every predicate is the sign of one dot product or of one 2 x
// 2 determinant, times the sign of the W of a constructed point. No gcd, no division, anywhere.
#pragma once

#include <array>

#include "plumb/predicates/point_table2.h"

namespace plumb::detail {

/// Three integers somewhere: in a table's limb pool or in Scratch2.
struct Triple {
  mpz_srcptr x;
  mpz_srcptr y;
  mpz_srcptr w;
};

/// The working integers of one thread, kept between calls so that a warm Big rung allocates
/// nothing. Triples it returns are valid until the next fresh() of that thread.
class Scratch2 {
 public:
  /// This thread's scratch with every slot free.
  static Scratch2& fresh();

  Scratch2();
  ~Scratch2();
  Scratch2(const Scratch2&) = delete;
  Scratch2& operator=(const Scratch2&) = delete;

  Triple point(Point2 p);  ///< W is the least power of two that serves
  Triple point(const RationalPoint2& p);
  Triple point(const PointTable2& points, std::uint32_t i);
  Triple cross(const Triple& p, const Triple& q);
  Triple line(const PointTable2& points, std::uint32_t i, std::uint32_t j) {
    return cross(point(points, i), point(points, j));
  }
  Triple point(const PointTable2& points, const Crossing2& p) {
    return cross(line(points, p.a, p.b), line(points, p.c, p.d));
  }

  Sign dot_sign(const Triple& l, const Triple& p);
  /// Order of p / pw and q / qw; nonzero denominators of any sign.
  Sign compare_quotients(mpz_srcptr p, mpz_srcptr pw, mpz_srcptr q, mpz_srcptr qw);
  Sign compare_xy(const Triple& p, const Triple& q);

 private:
  struct Slot {
    mpz_t x, y, w;
    HomogeneousView2 view;
  };
  /// Two crossings take 8 points, 4 lines and themselves.
  static constexpr std::size_t kSlots = 14;
  /// Coordinates longer than this make the next fresh() hand the memory back.
  static constexpr std::size_t kLongLimbs = 64;

  Slot& next() { return slots_[used_++]; }
  Triple own(const Slot& slot) { return {slot.x, slot.y, slot.w}; }
  void note_length(mpz_srcptr n) { is_long_ = is_long_ || mpz_size(n) > kLongLimbs; }
  void shrink();

  std::array<Slot, kSlots> slots_;
  mpz_t sum_;
  std::size_t used_ = 0;
  bool is_long_ = false;
};

inline Sign sign_of_mpz(mpz_srcptr n) { return sign_of(mpz_sgn(n)); }

/// n / d as a public number.
Rational to_rational(mpz_srcptr n, mpz_srcptr d);

}  // namespace plumb::detail
