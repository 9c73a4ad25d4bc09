// Identities that the predicates' contracts promise, on random small, full and wild coordinates.
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cmath>

#include "plumb/predicates/arithmetic/double_bits.h"
#include "plumb/predicates/input_predicates.h"

namespace plumb::test::predicate_properties_test {
namespace {

/// rc::check prints its seed and a shrunk counterexample.
template <class Testable>
void holds(const char* what, Testable testable) {
  EXPECT_TRUE(rc::check(what, testable));
}

/// Small integers (degenerate often), 26-bit ones (exact to translate) and any finite double.
double small_or_full() {
  return *rc::gen::oneOf(
      rc::gen::map(rc::gen::inRange(-4, 5), [](int n) { return double(n); }),
      rc::gen::map(rc::gen::inRange(-(1 << 26), 1 << 26), [](int n) { return double(n) / 1024; }));
}

double wild() {
  const auto bits = *rc::gen::arbitrary<std::uint64_t>();
  const auto v = std::bit_cast<double>(bits);
  return is_finite(v) ? v : small_or_full();
}

double coordinate() { return *rc::gen::inRange(0, 4) == 0 ? wild() : small_or_full(); }
Point2 point2() { return {coordinate(), coordinate()}; }
Point3 point3() { return {coordinate(), coordinate(), coordinate()}; }
Point2 tame2() { return {small_or_full(), small_or_full()}; }
Point3 tame3() { return {small_or_full(), small_or_full(), small_or_full()}; }

TEST(PredicateProperties, SwapsFlipTheSign) {
  holds("orient2d", [] {
    const Point2 a = point2(), b = point2(), c = point2();
    RC_ASSERT(orient2d(a, b, c) == -orient2d(b, a, c));
    RC_ASSERT(orient2d(a, b, c) == -orient2d(a, c, b));
    RC_ASSERT(orient2d(a, a, b) == Sign::Zero);
  });
  holds("cross_sign", [] {
    const Point2 a = point2(), b = point2(), c = point2(), d = point2();
    RC_ASSERT(cross_sign(a, b, c, d) == -cross_sign(b, a, c, d));
    RC_ASSERT(cross_sign(a, b, c, d) == -cross_sign(a, b, d, c));
    RC_ASSERT(cross_sign(a, b, c, d) == -cross_sign(c, d, a, b));
    RC_ASSERT(cross_sign(c, a, c, b) == orient2d(a, b, c));
  });
  holds("orient3d, incircle", [] {
    const Point3 a = point3(), b = point3(), c = point3(), d = point3();
    RC_ASSERT(orient3d(a, b, c, d) == -orient3d(b, a, c, d));
    RC_ASSERT(orient3d(a, b, c, d) == -orient3d(a, b, d, c));
    const Point2 p = point2(), q = point2(), r = point2(), s = point2();
    RC_ASSERT(incircle(p, q, r, s) == -incircle(q, p, r, s));
    RC_ASSERT(incircle(p, q, r, s) == -incircle(p, q, s, r));
  });
  holds("insphere", [] {
    const Point3 a = point3(), b = point3(), c = point3(), d = point3(), e = point3();
    RC_ASSERT(insphere(a, b, c, d, e) == -insphere(b, a, c, d, e));
    RC_ASSERT(insphere(a, b, c, d, e) == -insphere(a, b, c, e, d));
  });
}

TEST(PredicateProperties, CyclicShiftsKeepOrFlipTheSign) {
  holds("an odd number of points keeps it, an even one flips it", [] {
    const Point2 p = point2(), q = point2(), r = point2(), s = point2();
    RC_ASSERT(orient2d(p, q, r) == orient2d(q, r, p));
    RC_ASSERT(incircle(p, q, r, s) == -incircle(q, r, s, p));
    const Point3 a = point3(), b = point3(), c = point3(), d = point3(), e = point3();
    RC_ASSERT(orient3d(a, b, c, d) == -orient3d(b, c, d, a));
    RC_ASSERT(insphere(a, b, c, d, e) == insphere(b, c, d, e, a));
  });
}

TEST(PredicateProperties, SwappedAxesFlipTheSign) {
  const auto flip = [](const Point2& p) { return Point2{p.y, p.x}; };
  const auto flip3 = [](const Point3& p) { return Point3{p.x, p.z, p.y}; };
  holds("a mirror image turns the other way", [=] {
    const Point2 p = point2(), q = point2(), r = point2(), s = point2();
    RC_ASSERT(orient2d(p, q, r) == -orient2d(flip(p), flip(q), flip(r)));
    RC_ASSERT(incircle(p, q, r, s) == -incircle(flip(p), flip(q), flip(r), flip(s)));
    const Point3 a = point3(), b = point3(), c = point3(), d = point3(), e = point3();
    RC_ASSERT(orient3d(a, b, c, d) == -orient3d(flip3(a), flip3(b), flip3(c), flip3(d)));
    RC_ASSERT(insphere(a, b, c, d, e) ==
              -insphere(flip3(a), flip3(b), flip3(c), flip3(d), flip3(e)));
  });
}

TEST(PredicateProperties, RepresentableMovesKeepTheSign) {
  holds("coordinates of 37 bits move exactly by integers, and scale exactly by 2^k", [] {
    const double dx = *rc::gen::inRange(-1000000, 1000000),
                 scale = std::ldexp(1, *rc::gen::inRange(-180, 180));
    const auto move = [=](const Point2& p) {
      return Point2{(p.x + dx) * scale, (p.y - dx) * scale};
    };
    const auto move3 = [=](const Point3& p) {
      return Point3{(p.x + dx) * scale, (p.y - dx) * scale, (p.z + 2 * dx) * scale};
    };
    const Point2 p = tame2(), q = tame2(), r = tame2(), s = tame2();
    RC_ASSERT(orient2d(p, q, r) == orient2d(move(p), move(q), move(r)));
    RC_ASSERT(cross_sign(p, q, r, s) == cross_sign(move(p), move(q), move(r), move(s)));
    RC_ASSERT(incircle(p, q, r, s) == incircle(move(p), move(q), move(r), move(s)));
    const Point3 a = tame3(), b = tame3(), c = tame3(), d = tame3(), e = tame3();
    RC_ASSERT(orient3d(a, b, c, d) == orient3d(move3(a), move3(b), move3(c), move3(d)));
    RC_ASSERT(insphere(a, b, c, d, e) ==
              insphere(move3(a), move3(b), move3(c), move3(d), move3(e)));
  });
}

/// Can x + y + z = 0 with these signs? Only if all are zero or two are opposite.
bool can_cancel(Sign x, Sign y, Sign z) {
  const auto has = [&](Sign s) { return x == s || y == s || z == s; };
  return has(Sign::Negative) == has(Sign::Positive);
}

/// [abc][ade] - [abd][ace] + [abe][acd] = 0 for the brackets of five points of the plane, and the
/// same with one or two more fixed letters: the Grassmann-Plücker relation that every chirotope
/// obeys.
TEST(PredicateProperties, SignsObeyGrassmannPluecker) {
  holds("five points of the plane", [] {
    const Point2 a = point2(), b = point2(), c = point2(), d = point2(), e = point2();
    RC_ASSERT(can_cancel(orient2d(a, b, c) * orient2d(a, d, e),
                         -(orient2d(a, b, d) * orient2d(a, c, e)),
                         orient2d(a, b, e) * orient2d(a, c, d)));
  });
  holds("six points of space", [] {
    const Point3 o = point3(), a = point3(), b = point3(), c = point3(), d = point3(), e = point3();
    RC_ASSERT(can_cancel(orient3d(o, a, b, c) * orient3d(o, a, d, e),
                         -(orient3d(o, a, b, d) * orient3d(o, a, c, e)),
                         orient3d(o, a, b, e) * orient3d(o, a, c, d)));
  });
  holds("six points of the plane, lifted", [] {
    const Point2 o = point2(), a = point2(), b = point2(), c = point2(), d = point2(), e = point2();
    RC_ASSERT(can_cancel(incircle(o, a, b, c) * incircle(o, a, d, e),
                         -(incircle(o, a, b, d) * incircle(o, a, c, e)),
                         incircle(o, a, b, e) * incircle(o, a, c, d)));
  });
  holds("seven points of space, lifted", [] {
    const Point3 n = point3(), o = point3(), a = point3(), b = point3(), c = point3(), d = point3(),
                 e = point3();
    RC_ASSERT(can_cancel(insphere(n, o, a, b, c) * insphere(n, o, a, d, e),
                         -(insphere(n, o, a, b, d) * insphere(n, o, a, c, e)),
                         insphere(n, o, a, b, e) * insphere(n, o, a, c, d)));
  });
}

}  // namespace
}  // namespace plumb::test::predicate_properties_test
