#include "oracle/cell_marks.h"

#include <array>

namespace plumb::testing {

std::string name_of(SetOperator op) {
  static constexpr std::array<const char*, kSetOperators> kNames = {
      "+", "*", "-", "^", "!", "interior", "closure", "boundary", "exterior", "regularization"};
  return kNames[static_cast<std::size_t>(op)];
}

MarkFunction function_of(SetOperator op) {
  switch (op) {
    case SetOperator::Union:
      return kUnion;
    case SetOperator::Intersection:
      return kIntersection;
    case SetOperator::Difference:
      return kDifference;
    default:
      return kSymmetricDifference;
  }
}

CellMarks combined(MarkFunction f, const CellMarks& first, const CellMarks& second) {
  CellMarks result(first.size());
  for (std::size_t c = 0; c < first.size(); ++c) result[c] = f(first[c], second[c]);
  return result;
}

}  // namespace plumb::testing
