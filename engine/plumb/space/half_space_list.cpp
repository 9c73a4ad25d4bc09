// A list of half-spaces, each as four numbers: doubles in one array, and the few numbers that are
// not doubles in a sorted list, with 0 in their places.
//
// Tested by tests/space/half_space_hull_test.cpp and tests/io/half_space_reader_test.cpp.

#include "plumb/space/half_space_list.h"

#include <algorithm>
#include <cmath>

#include "plumb/predicates/error.h"
#include "plumb/predicates/rounding.h"

namespace plumb {

void HalfSpaceList::reserve(std::size_t count) {
  numbers_.reserve(4 * count);
  is_open_.reserve(count);
}

void HalfSpaceList::add_number(double value) {
  if (!std::isfinite(value)) throw Error(ErrorCode::NotFinite, "a half-space of no finite number");
  numbers_.push_back(value);
}

void HalfSpaceList::add_number(Rational value) {
  const RoundedDouble near = round_to_double(value);
  if (near.error == Sign::Zero) return add_number(near.value);
  exact_.emplace_back(numbers_.size(), std::move(value));
  numbers_.push_back(0);
}

void HalfSpaceList::end(Boundary boundary) {
  is_open_.push_back(boundary == Boundary::Open ? 1 : 0);
}

Rational HalfSpaceList::number(std::size_t k) const {
  const auto exact =
      std::lower_bound(exact_.begin(), exact_.end(), k,
                       [](const auto& entry, std::size_t place) { return entry.first < place; });
  return exact != exact_.end() && exact->first == k ? exact->second : exact_rational(numbers_[k]);
}

HalfSpace3 HalfSpaceList::operator[](std::size_t i) const {
  return {{number(4 * i), number(4 * i + 1), number(4 * i + 2), number(4 * i + 3)},
          is_open_[i] != 0 ? Boundary::Open : Boundary::Closed};
}

}  // namespace plumb
