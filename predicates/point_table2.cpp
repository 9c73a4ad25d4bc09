#include "plumb/predicates/point_table2.h"

#include <bit>
#include <cstdlib>

#include "plumb/predicates/rounding.h"

namespace plumb {

namespace {

/// By the bits: under DAZ every comparison and sum would take a subnormal for zero.
double without_negative_zero(double v) {
  constexpr std::uint64_t kNegativeZero = std::uint64_t{1} << 63;
  return std::bit_cast<std::uint64_t>(v) == kNegativeZero ? 0.0 : v;
}

}  // namespace

void PointTable2::reserve(std::size_t points) { points_.reserve(points); }

void PointTable2::push_back(Point2 p) {
  points_.push_back({without_negative_zero(p.x), without_negative_zero(p.y)});
  if (!slot_.empty()) slot_.push_back(kNoSlot);
}

void PointTable2::push_back(const Rational& x, const Rational& y) {
  const RoundedDouble rx = round_to_double(x);
  const RoundedDouble ry = round_to_double(y);
  if (rx.error == Sign::Zero && ry.error == Sign::Zero) {
    push_back(Point2{rx.value, ry.value});
    return;
  }
  slot_.resize(points_.size(), kNoSlot);
  slot_.push_back(static_cast<std::uint32_t>(entries_.size()));
  points_.push_back({clamped_to_finite(rx.value), clamped_to_finite(ry.value)});
  const Integer w = lcm(denominator(x), denominator(y));
  const Integer px = numerator(x) * (w / denominator(x));
  const Integer py = numerator(y) * (w / denominator(y));
  Entry entry{limbs_.size(), 0, 0, 0};
  entry.x_size = append_limbs(px.backend().data());
  entry.y_size = append_limbs(py.backend().data());
  entry.w_size = append_limbs(w.backend().data());
  entries_.push_back(entry);
}

std::int32_t PointTable2::append_limbs(mpz_srcptr value) {
  const mp_limb_t* limbs = mpz_limbs_read(value);
  limbs_.insert(limbs_.end(), limbs, limbs + mpz_size(value));
  const auto size = static_cast<std::int32_t>(mpz_size(value));
  return mpz_sgn(value) < 0 ? -size : size;
}

/// Copies point i of `other`, which is no double.
void PointTable2::append_entry(const PointTable2& other, std::uint32_t i) {
  Entry entry = other.entries_[other.slot_[i]];
  const std::size_t length = static_cast<std::size_t>(std::abs(entry.x_size)) +
                             static_cast<std::size_t>(std::abs(entry.y_size)) +
                             static_cast<std::size_t>(std::abs(entry.w_size));
  const auto first = other.limbs_.begin() + static_cast<std::ptrdiff_t>(entry.begin);
  entry.begin = limbs_.size();
  limbs_.insert(limbs_.end(), first, first + static_cast<std::ptrdiff_t>(length));
  slot_.resize(points_.size(), kNoSlot);
  slot_.push_back(static_cast<std::uint32_t>(entries_.size()));
  points_.push_back(other.points_[i]);
  entries_.push_back(entry);
}

void PointTable2::append(const PointTable2& other) {
  if (other.all_double()) {
    points_.insert(points_.end(), other.points_.begin(), other.points_.end());
    if (!slot_.empty()) slot_.resize(points_.size(), kNoSlot);
    return;
  }
  for (std::uint32_t i = 0; i < other.size(); ++i) {
    if (other.is_double(i)) {
      push_back(other.points_[i]);
    } else {
      append_entry(other, i);
    }
  }
}

PointTable2 PointTable2::subset(std::span<const std::uint8_t> keep) const {
  PointTable2 kept;
  for (std::uint32_t i = 0; i < size(); ++i) {
    if (keep[i] == 0) continue;
    if (is_double(i)) {
      kept.push_back(points_[i]);
    } else {
      kept.append_entry(*this, i);
    }
  }
  return kept;
}

HomogeneousView2 PointTable2::homogeneous(std::uint32_t i) const {
  const Entry& e = entries_[slot_[i]];
  const mp_limb_t* x = limbs_.data() + e.begin;
  const mp_limb_t* y = x + std::abs(e.x_size);
  const mp_limb_t* w = y + std::abs(e.y_size);
  HomogeneousView2 view;
  mpz_roinit_n(view.x, x, e.x_size);
  mpz_roinit_n(view.y, y, e.y_size);
  mpz_roinit_n(view.w, w, e.w_size);
  return view;
}

RationalPoint2 PointTable2::exact(std::uint32_t i) const {
  if (is_double(i)) return {exact_rational(points_[i].x), exact_rational(points_[i].y)};
  const HomogeneousView2 h = homogeneous(i);
  const Integer w(h.w);
  return {Rational(Integer(h.x), w), Rational(Integer(h.y), w)};
}

}  // namespace plumb
