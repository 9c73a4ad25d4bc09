#include "oracle/segments.h"

#include <algorithm>

namespace plumb::testing {
namespace {

ExactPoint exact(const IntegerPoint& p) { return {BigRational(p.x), BigRational(p.y)}; }

bool boxes_apart(const BigInt& a, const BigInt& b, const BigInt& c, const BigInt& d) {
  return std::max(a, b) < std::min(c, d) || std::max(c, d) < std::min(a, b);
}

bool lies_on(const IntegerPoint& p, const IntegerPoint& a, const IntegerPoint& b) {
  return cross(a, b, a, p) == 0 && !boxes_apart(p.x, p.x, a.x, b.x) &&
         !boxes_apart(p.y, p.y, a.y, b.y);
}

// Parallel segments (or points) can only share a stretch between two of their four ends.
std::optional<Meeting> meet_parallel(const IntegerPoint& p, const IntegerPoint& q,
                                     const IntegerPoint& r, const IntegerPoint& s) {
  std::vector<IntegerPoint> shared;
  for (const IntegerPoint& end : {p, q}) {
    if (lies_on(end, r, s)) shared.push_back(end);
  }
  for (const IntegerPoint& end : {r, s}) {
    if (lies_on(end, p, q)) shared.push_back(end);
  }
  if (shared.empty()) return std::nullopt;
  const auto [first, last] = std::minmax_element(shared.begin(), shared.end());
  return Meeting{exact(*first), exact(*last)};
}

bool in_unit_interval(const BigInt& num, const BigInt& den) {
  return den > 0 ? num >= 0 && num <= den : num <= 0 && num >= den;
}

}  // namespace

bool operator<(const IntegerPoint& a, const IntegerPoint& b) {
  return a.x != b.x ? a.x < b.x : a.y < b.y;
}

IntegerPoints over_common_denominator(const std::vector<ExactPoint>& points) {
  IntegerPoints result;
  for (const ExactPoint& p : points) {
    result.denominator = lcm(result.denominator, denominator(p.x));
    result.denominator = lcm(result.denominator, denominator(p.y));
  }
  const auto scaled = [&](const BigRational& value) {
    return BigInt(numerator(value) * (result.denominator / denominator(value)));
  };
  for (const ExactPoint& p : points) result.points.push_back({scaled(p.x), scaled(p.y)});
  return result;
}

BigInt cross(const IntegerPoint& a, const IntegerPoint& b, const IntegerPoint& c,
             const IntegerPoint& d) {
  return (b.x - a.x) * (d.y - c.y) - (b.y - a.y) * (d.x - c.x);
}

std::optional<Meeting> meet(const IntegerPoint& p, const IntegerPoint& q, const IntegerPoint& r,
                            const IntegerPoint& s) {
  if (boxes_apart(p.x, q.x, r.x, s.x) || boxes_apart(p.y, q.y, r.y, s.y)) return std::nullopt;
  const BigInt den = cross(p, q, r, s);
  if (den == 0) return meet_parallel(p, q, r, s);
  const BigInt t = cross(p, r, r, s);  // the point is p + (t / den) (q - p)
  const BigInt u = cross(p, r, p, q);  // and r + (u / den) (s - r)
  if (!in_unit_interval(t, den) || !in_unit_interval(u, den)) return std::nullopt;
  const BigRational at = den > 0 ? BigRational(t, den) : BigRational(-t, -den);
  const ExactPoint point{BigRational(p.x) + at * (q.x - p.x), BigRational(p.y) + at * (q.y - p.y)};
  return Meeting{point, point};
}

bool angle_less(const IntegerPoint& a, const IntegerPoint& b, const IntegerPoint& c,
                const IntegerPoint& d) {
  const auto lower_half = [](const IntegerPoint& from, const IntegerPoint& to) {
    return to.y < from.y || (to.y == from.y && to.x < from.x);
  };
  const bool first = lower_half(a, b);
  const bool second = lower_half(c, d);
  return first != second ? second : cross(a, b, c, d) > 0;
}

}  // namespace plumb::testing
