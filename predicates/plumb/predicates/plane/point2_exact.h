// Points and lines of the plane as triples of integers: the arithmetic of the last stage of the
// predicates on points of the plane, by GMP. Internal.
//
// A point P = (X : Y : W) is (X / W, Y / W); a line L = (A : B : C) is A x + B y + C = 0.
//
//   join(P, Q) = P x Q     the line through P and Q
//   meet(L, M) = L x M     the common point of L and M; W = 0 if they are parallel
//   dot(L, P)              = orient2d(P1, P2, P) W_1 W_2 W_P for L = join(P1, P2)
//   meet(L, M).W           = (P2 - P1) x (Q2 - Q1) W_1 .. W_4 for the joins of P1 P2 and Q1 Q2
//
// Input points have W > 0. So every predicate is the sign of one dot product or of one 2 x 2
// determinant, times the sign of the W of a constructed point. Nothing is divided, and no gcd is
// computed.
#pragma once

#include <array>

#include "plumb/predicates/point_table2.h"

namespace plumb::detail {

/// Refers to three integers in a table's limb pool or in a Scratch2. Does not own them.
struct Triple {
  mpz_srcptr x;
  mpz_srcptr y;
  mpz_srcptr w;
};

/// The working integers of one thread. They are kept between calls, so that later calls allocate
/// nothing. Triples that it returns are valid until the next fresh() of that thread.
class Scratch2 {
 public:
  /// Returns this thread's scratch with every slot free.
  static Scratch2& fresh();

  Scratch2();
  ~Scratch2();
  Scratch2(const Scratch2&) = delete;
  Scratch2& operator=(const Scratch2&) = delete;

  /// Returns a point with doubles as coordinates. W is the least power of two that makes integers.
  Triple point(Point2 p);
  /// Returns a rational point. W is the product of the denominators.
  Triple point(const RationalPoint2& p);
  /// Returns point i of the table. W > 0.
  Triple point(const PointTable2& points, std::uint32_t i);
  /// Returns the cross product: the line through two points, or the common point of two lines.
  Triple cross(const Triple& p, const Triple& q);
  /// Returns the line through points i and j of the table.
  Triple line(const PointTable2& points, std::uint32_t i, std::uint32_t j) {
    return cross(point(points, i), point(points, j));
  }
  /// Returns the crossing. W may have any sign, but is not zero.
  Triple point(const PointTable2& points, const Crossing2& p) {
    return cross(line(points, p.a, p.b), line(points, p.c, p.d));
  }

  /// Returns the sign of the dot product of l and p.
  Sign dot_sign(const Triple& l, const Triple& p);
  /// Returns the order of p / pw and q / qw. Requires denominators other than zero, of any sign.
  Sign compare_quotients(mpz_srcptr p, mpz_srcptr pw, mpz_srcptr q, mpz_srcptr qw);
  /// Returns the lexicographic order of two points.
  Sign compare_xy(const Triple& p, const Triple& q);

 private:
  struct Slot {
    mpz_t x, y, w;
    HomogeneousView2 view;
  };
  /// The most that one predicate takes: 8 points, 4 lines and 2 crossings.
  static constexpr std::size_t kSlots = 14;
  /// Coordinates with more limbs than this make the next fresh() free the memory.
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

/// Returns the sign of an integer of GMP.
inline Sign sign_of_mpz(mpz_srcptr n) { return sign_of(mpz_sgn(n)); }

/// Returns n / d in lowest terms. Requires d other than zero.
Rational to_rational(mpz_srcptr n, mpz_srcptr d);

}  // namespace plumb::detail
