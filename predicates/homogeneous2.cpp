#include "plumb/predicates/homogeneous2.h"

#include <algorithm>

#include "plumb/predicates/decompose.h"

namespace plumb::detail {

Scratch2::Scratch2() {
  for (Slot& s : slots_) mpz_inits(s.x, s.y, s.w, nullptr);
  mpz_init(sum_);
}

Scratch2::~Scratch2() {
  for (Slot& s : slots_) mpz_clears(s.x, s.y, s.w, nullptr);
  mpz_clear(sum_);
}

Scratch2& Scratch2::fresh() {
  thread_local Scratch2 scratch;
  if (scratch.is_long_) scratch.shrink();
  scratch.used_ = 0;
  return scratch;
}

void Scratch2::shrink() {
  for (Slot& s : slots_) {
    for (mpz_ptr n : {s.x, s.y, s.w}) mpz_realloc2(n, GMP_NUMB_BITS);
  }
  mpz_realloc2(sum_, GMP_NUMB_BITS);
  is_long_ = false;
}

Triple Scratch2::point(Point2 p) {
  const Decomposed x = decompose(p.x);
  const Decomposed y = decompose(p.y);
  const int shift = std::max({0, -x.exponent, -y.exponent});
  const auto scale = [shift](mpz_ptr out, const Decomposed& d) {
    const int bits = d.exponent + shift;
    mpz_set_si(out, d.mantissa);
    mpz_mul_2exp(out, out, static_cast<mp_bitcnt_t>(bits));
  };
  Slot& s = next();
  scale(s.x, x);
  scale(s.y, y);
  scale(s.w, {1, 0});
  return own(s);
}

Triple Scratch2::point(const RationalPoint2& p) {
  mpq_srcptr x = p.x.backend().data();
  mpq_srcptr y = p.y.backend().data();
  Slot& s = next();
  mpz_mul(s.x, mpq_numref(x), mpq_denref(y));
  mpz_mul(s.y, mpq_numref(y), mpq_denref(x));
  mpz_mul(s.w, mpq_denref(x), mpq_denref(y));
  for (mpz_srcptr n : {s.x, s.y, s.w}) note_length(n);
  return own(s);
}

Triple Scratch2::point(const PointTable2& points, std::uint32_t i) {
  if (points.is_double(i)) return point(points.approx(i));
  Slot& s = next();
  s.view = points.homogeneous(i);
  for (mpz_srcptr n : {s.view.x, s.view.y, s.view.w}) note_length(n);
  return {s.view.x, s.view.y, s.view.w};
}

Triple Scratch2::cross(const Triple& p, const Triple& q) {
  const auto minor = [](mpz_ptr out, mpz_srcptr a, mpz_srcptr d, mpz_srcptr b, mpz_srcptr c) {
    mpz_mul(out, a, d);
    mpz_submul(out, b, c);
  };
  Slot& s = next();
  minor(s.x, p.y, q.w, p.w, q.y);
  minor(s.y, p.w, q.x, p.x, q.w);
  minor(s.w, p.x, q.y, p.y, q.x);
  return own(s);
}

Sign Scratch2::dot_sign(const Triple& l, const Triple& p) {
  mpz_mul(sum_, l.x, p.x);
  mpz_addmul(sum_, l.y, p.y);
  mpz_addmul(sum_, l.w, p.w);
  return sign_of_mpz(sum_);
}

Sign Scratch2::compare_quotients(mpz_srcptr p, mpz_srcptr pw, mpz_srcptr q, mpz_srcptr qw) {
  mpz_mul(sum_, p, qw);
  mpz_submul(sum_, q, pw);
  return sign_of_mpz(sum_) * sign_of_mpz(pw) * sign_of_mpz(qw);
}

Sign Scratch2::compare_xy(const Triple& p, const Triple& q) {
  const Sign by_x = compare_quotients(p.x, p.w, q.x, q.w);
  return by_x != Sign::Zero ? by_x : compare_quotients(p.y, p.w, q.y, q.w);
}

Rational to_rational(mpz_srcptr n, mpz_srcptr d) {
  Rational r;
  mpz_set(mpq_numref(r.backend().data()), n);
  mpz_set(mpq_denref(r.backend().data()), d);
  mpq_canonicalize(r.backend().data());
  return r;
}

}  // namespace plumb::detail
