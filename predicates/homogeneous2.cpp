#include "plumb/predicates/homogeneous2.h"

#include <algorithm>
#include <bit>

namespace plumb::detail {

namespace {

/// value = mantissa * 2^exponent, from the bits.
struct Dyadic {
  std::int64_t mantissa;
  int exponent;
};

Dyadic dyadic(double value) {
  const auto bits = std::bit_cast<std::uint64_t>(value);
  const auto biased = static_cast<int>((bits >> 52) & 0x7ff);
  auto mantissa = static_cast<std::int64_t>(bits & 0xfffffffffffffULL);
  if (biased != 0) mantissa |= std::int64_t{1} << 52;
  if (mantissa == 0) return {0, 0};
  return {(bits >> 63) != 0 ? -mantissa : mantissa, (biased == 0 ? 1 : biased) - 1075};
}

}  // namespace

Triple triple(Point2 p) {
  const Dyadic x = dyadic(p.x);
  const Dyadic y = dyadic(p.y);
  const int shift = std::max({0, -x.exponent, -y.exponent});
  return {Integer(x.mantissa) << (x.exponent + shift), Integer(y.mantissa) << (y.exponent + shift),
          Integer(1) << shift};
}

Triple triple(const PointTable2& points, std::uint32_t i) {
  if (points.is_double(i)) return triple(points.approx(i));
  const HomogeneousView2 h = points.homogeneous(i);
  return {Integer(h.x), Integer(h.y), Integer(h.w)};
}

}  // namespace plumb::detail
