// Points and lines of the plane as integer triples: the Big rung's arithmetic. Internal.
//
// Notation: a point P = (X : Y : W) is (X / W, Y / W); a line L = (A : B : C) is A x + B y + C = 0.
//   join(P, Q) = P x Q     the line through P and Q, its left side positive when W_P W_Q > 0
//   meet(L, M) = L x M     the point where L and M meet; W = 0 when they are parallel
//   dot(L, P)              = orient2d(P1, P2, P) W_1 W_2 W_P for L = join(P1, P2)
// so that with all W > 0 every predicate is the sign of one dot product or of one 2 x 2
// determinant.
#pragma once

#include "plumb/predicates/point_table2.h"

namespace plumb::detail {

struct Triple {
  Integer x;
  Integer y;
  Integer w;
};

/// W > 0. A double point gets the least common power of two as W.
Triple triple(Point2 p);
Triple triple(const PointTable2& points, std::uint32_t i);

inline Triple cross(const Triple& p, const Triple& q) {
  return {p.y * q.w - p.w * q.y, p.w * q.x - p.x * q.w, p.x * q.y - p.y * q.x};
}
inline Triple join(const Triple& p, const Triple& q) { return cross(p, q); }
inline Triple meet(const Triple& l, const Triple& m) { return cross(l, m); }

inline Sign integer_sign(const Integer& n) { return sign_of(n.sign()); }

inline Sign dot_sign(const Triple& l, const Triple& p) {
  return integer_sign(l.x * p.x + l.y * p.y + l.w * p.w);
}

/// Order of p / pw and q / qw for nonzero denominators of any sign.
inline Sign compare_quotients(const Integer& p, const Integer& pw, const Integer& q,
                              const Integer& qw) {
  return integer_sign(p * qw - q * pw) * integer_sign(pw) * integer_sign(qw);
}

inline Sign compare_xy(const Triple& p, const Triple& q) {
  const Sign by_x = compare_quotients(p.x, p.w, q.x, q.w);
  return by_x != Sign::Zero ? by_x : compare_quotients(p.y, p.w, q.y, q.w);
}

}  // namespace plumb::detail
