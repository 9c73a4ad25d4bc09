// Marks of cells, and functions that compute the marks of a result from the marks of the operands.
//
// A mark is 1 if the cell belongs to the set and 0 otherwise. An unbounded set is framed by a
// symbolic cube (docs/design/frame.md). Cells outside the cube have a third mark, kBeyond. No
// operation changes the mark kBeyond. Therefore the operations need no special cases for the frame.
#pragma once

#include <array>
#include <cstdint>

#pragma GCC visibility push(default)
namespace plumb {

/// Whether a set contains its boundary (Closed) or not (Open).
enum class Boundary : std::uint8_t { Open, Closed };

/// The form that an audit requires of the representation of a set. The form Any accepts every valid
/// representation. The form Minimal accepts only the representation from which no cell can be
/// removed without changing the set.
enum class AuditForm : std::uint8_t { Any, Minimal };

/// The winding numbers that count as inside: every number except 0 (NonZero), every odd number
/// (EvenOdd), or every positive number (Positive).
enum class WindingRule : std::uint8_t { NonZero, EvenOdd, Positive };

/// A Boolean function of two sets. Each member describes a kind of point and states whether such
/// points belong to the result.
struct MarkFunction {
  bool neither = false;      ///< Value for points in neither set.
  bool first_only = false;   ///< Value for points only in the first set.
  bool second_only = false;  ///< Value for points only in the second set.
  bool both = false;         ///< Value for points in both sets.

  /// Returns whether a point belongs to the result. `first` and `second` state whether the point
  /// belongs to the two sets.
  constexpr bool operator()(bool first, bool second) const {
    return first ? (second ? both : first_only) : (second ? second_only : neither);
  }
};
/// The union: the function of the operator +.
inline constexpr MarkFunction kUnion{false, true, true, true};
/// The intersection: the function of the operator *.
inline constexpr MarkFunction kIntersection{false, false, false, true};
/// The difference: the function of the operator -.
inline constexpr MarkFunction kDifference{false, true, false, false};
/// The symmetric difference: the function of the operator ^.
inline constexpr MarkFunction kSymmetricDifference{false, true, true, false};

/// The mark of a cell: 0, 1 or kBeyond.
using Mark = std::uint8_t;
inline constexpr Mark kBeyond = 2;  ///< The mark of cells beyond the frame.

/// A MarkFunction extended to marks that may be kBeyond. In a set operation, either both marks are
/// kBeyond, or neither mark is kBeyond.
class MarkTable {
 public:
  /// Extends f. The value is kBeyond if at least one of the marks is kBeyond.
  constexpr explicit MarkTable(MarkFunction f)
      : table_{f.neither, f.second_only, kBeyond, f.first_only, f.both,
               kBeyond,   kBeyond,       kBeyond, kBeyond} {}

  /// Returns the table whose value is 1 if the marks differ, and 0 if they are equal. The mark
  /// kBeyond is compared in the same way as 0 and 1.
  static constexpr MarkTable unequal() {
    MarkTable table(kSymmetricDifference);
    table.table_ = {0, 1, 1, 1, 0, 1, 1, 1, 0};
    return table;
  }

  /// Returns the table that combines a set (the first mark) with walls (the second mark), which
  /// divide the set into parts (convex/walls.h). The value is kBeyond for a cell that belongs to
  /// the set and to a wall. The value is also kBeyond if at least one of the marks is kBeyond.
  /// Otherwise the value is the mark of the set.
  static constexpr MarkTable walled() {
    MarkTable table(kDifference);
    table.table_ = {0, 0, kBeyond, 1, kBeyond, kBeyond, kBeyond, kBeyond, kBeyond};
    return table;
  }

  /// Returns the value of the extended function for two marks.
  constexpr Mark operator()(Mark first, Mark second) const { return table_[first * 3U + second]; }

 private:
  std::array<Mark, 9> table_;
};

}  // namespace plumb
#pragma GCC visibility pop
