// The exact rungs of every sign about planes: the narrowest width that holds the operands, then
// wider ones, then mpz. A *form* computes the sign from an array of loaded planes of any number
// type:
//
//   form(const std::array<Plane, K>&) -> Sign      Plane = FixedPlane<W> or BigPlane, aligned
//
// With planes of the frame a form is asked part by part (plane_exact.h).
#pragma once

#include <array>

#include "plumb/predicates/plane_exact.h"
#include "plumb/predicates/rung_counters.h"

namespace plumb::exact3 {

template <std::size_t K>
std::array<Operand, K> operands(const PlaneTable& table, const std::array<PlaneId, K>& ids) {
  std::array<Operand, K> result;
  for (std::size_t i = 0; i < K; ++i) result[i] = operand(table, ids[i]);
  return result;
}

template <std::size_t K>
int width_of(const std::array<Operand, K>& operands) {
  int width = 0;
  for (const Operand& o : operands) width = o.width > width ? o.width : width;
  return width;
}

template <std::size_t K>
bool has_frame(const std::array<Operand, K>& operands) {
  bool any = false;
  for (const Operand& o : operands) any |= o.source.is_frame();
  return any;
}

/// Of one part. Unsure when the operands, or their offsets on a common scale, do not fit W.
template <class W, std::size_t K, class Form>
FilteredSign fixed_part(const std::array<Operand, K>& operands, Part part, const Form& form) {
  if (width_of(operands) > W::kIndex) return FilteredSign::Unsure;
  std::array<FixedPlane<W>, K> planes;
  for (std::size_t i = 0; i < K; ++i) {
    planes[i] = load<W>(operands[i]);
    take_part(operands[i], part, planes[i]);
  }
  if (!align(planes)) return FilteredSign::Unsure;
  return filtered(form(planes));
}

template <std::size_t K, class Form>
Sign big_part(const std::array<Operand, K>& operands, Part part, const Form& form) {
  std::array<BigPlane, K> planes;
  for (std::size_t i = 0; i < K; ++i) {
    planes[i] = load_big(operands[i]);
    take_part(operands[i], part, planes[i]);
  }
  align(planes);
  return form(planes);
}

template <class W, std::size_t K, class Form>
FilteredSign fixed_sign(const std::array<Operand, K>& operands, const Form& form) {
  return by_parts(has_frame(operands),
                  [&](Part part) { return fixed_part<W>(operands, part, form); });
}

template <std::size_t K, class Form>
Sign big_sign(const std::array<Operand, K>& operands, const Form& form) {
  return decided(by_parts(has_frame(operands),
                          [&](Part part) { return filtered(big_part(operands, part, form)); }));
}

/// Of one part; `count(rung)` is told which rung decides.
template <std::size_t K, class Form, class Count>
Sign exact_part(const std::array<Operand, K>& operands, Part part, const Form& form,
                const Count& count) {
  const auto tell = [&](Rung rung, FilteredSign s) {
    if (is_decided(s)) count(rung);
    return s;
  };
  FilteredSign s = tell(Rung::Small, fixed_part<Narrow>(operands, part, form));
  if (!is_decided(s)) s = tell(Rung::Exact, fixed_part<Medium>(operands, part, form));
  if (!is_decided(s)) s = tell(Rung::Exact, fixed_part<Wide>(operands, part, form));
  if (!is_decided(s)) s = tell(Rung::Big, filtered(big_part(operands, part, form)));
  return decided(s);
}

/// With a frame c1 first, then near() -> FilteredSign about c0, a filter, then c0.
template <std::size_t K, class Form, class Near, class Count>
Sign exact_sign(const std::array<Operand, K>& operands, const Form& form, const Near& near,
                const Count& count) {
  if (has_frame(operands)) {
    const Sign infinite = exact_part(operands, Part::Infinite, form, count);
    if (infinite != Sign::Zero) return infinite;
    const FilteredSign finite = near();
    if (is_decided(finite)) return decided(finite);
  }
  return exact_part(operands, Part::Finite, form, count);
}

template <std::size_t K, class Form, class Count>
Sign exact_sign(const std::array<Operand, K>& operands, const Form& form, const Count& count) {
  return exact_sign(
      operands, form, [] { return FilteredSign::Unsure; }, count);
}

}  // namespace plumb::exact3
