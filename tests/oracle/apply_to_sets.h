// The operators of the tests' expressions on the engine's sets, Nef2 and Nef3 alike.
#pragma once

#include "oracle/cell_marks.h"

namespace plumb::testing {

/// `second` is read by binary operators only.
template <class Set>
Set apply_to_sets(SetOperator op, const Set& first, const Set& second) {
  switch (op) {
    case SetOperator::Union:
      return first + second;
    case SetOperator::Intersection:
      return first * second;
    case SetOperator::Difference:
      return first - second;
    case SetOperator::SymmetricDifference:
      return first ^ second;
    case SetOperator::Complement:
      return !first;
    case SetOperator::Interior:
      return first.interior();
    case SetOperator::Closure:
      return first.closure();
    case SetOperator::Boundary:
      return first.boundary();
    case SetOperator::Exterior:
      return first.exterior();
    default:
      return first.regularization();
  }
}

}  // namespace plumb::testing
