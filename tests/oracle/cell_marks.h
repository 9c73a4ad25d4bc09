// Marks on the cells of an arrangement, and the set operations on them: what the twins of the plane
// and of space have in common.
//
// Cells: a type with size() and cells[c].around, the cells of higher dimension whose closure
// contains cell c. The interior is "and everything around the cell", the closure "or something
// around it".
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "plumb/base/marks.h"

namespace plumb::testing {

enum class SetOperator {
  Union,
  Intersection,
  Difference,
  SymmetricDifference,  // from here on of one set
  Complement,
  Interior,
  Closure,
  Boundary,
  Exterior,
  Regularization,
};
inline constexpr int kSetOperators = 10;
inline bool is_binary(SetOperator op) { return op <= SetOperator::SymmetricDifference; }
std::string name_of(SetOperator op);

/// Of every cell: does it belong to the set?
using CellMarks = std::vector<bool>;

inline CellMarks complement_of(CellMarks marks) {
  marks.flip();
  return marks;
}

CellMarks combined(MarkFunction f, const CellMarks& first, const CellMarks& second);
/// Requires a binary operator.
MarkFunction function_of(SetOperator op);

template <class Cells>
CellMarks interior_of(const Cells& cells, const CellMarks& marks) {
  CellMarks result = marks;
  for (std::size_t c = 0; c < cells.size(); ++c) {
    for (const std::size_t d : cells[c].around) result[c] = result[c] && marks[d];
  }
  return result;
}

template <class Cells>
CellMarks closure_of(const Cells& cells, const CellMarks& marks) {
  CellMarks result = marks;
  for (std::size_t c = 0; c < cells.size(); ++c) {
    for (const std::size_t d : cells[c].around) result[c] = result[c] || marks[d];
  }
  return result;
}

/// `second` is not read when op is unary.
template <class Cells>
CellMarks apply(SetOperator op, const Cells& cells, const CellMarks& first,
                const CellMarks& second) {
  switch (op) {
    case SetOperator::Complement:
      return complement_of(first);
    case SetOperator::Interior:
      return interior_of(cells, first);
    case SetOperator::Closure:
      return closure_of(cells, first);
    case SetOperator::Boundary:
      return combined(kDifference, closure_of(cells, first), interior_of(cells, first));
    case SetOperator::Exterior:
      return interior_of(cells, complement_of(first));
    case SetOperator::Regularization:
      return closure_of(cells, interior_of(cells, first));
    default:
      return combined(function_of(op), first, second);
  }
}

/// Does no unbounded cell belong to the set?
template <class Cells>
bool is_bounded(const Cells& cells, const CellMarks& marks) {
  for (std::size_t c = 0; c < cells.size(); ++c) {
    if (marks[c] && cells[c].unbounded) return false;
  }
  return true;
}

}  // namespace plumb::testing
