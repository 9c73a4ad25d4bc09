// Marks of cells, and functions that compute the marks of a result from those of the operands.
//
// A mark is 1 if the cell belongs to the set and 0 otherwise. A third mark, kBeyond, belongs to
// what lies outside the symbolic cube that frames an unbounded set (docs/design/frame.md). No
// operation changes it, so that the frame needs no special cases.
#pragma once

#include <array>
#include <cstdint>

#pragma GCC visibility push(default)
namespace plumb {

/// Whether a set contains its boundary (Closed) or not (Open).
enum class Boundary : std::uint8_t { Open, Closed };

/// Which form an audit requires: any valid one, or the minimal form, of which no cell can be
/// removed without changing the set.
enum class AuditForm : std::uint8_t { Any, Minimal };

/// The winding numbers that count as inside: all but 0, the odd ones, or the positive ones.
enum class WindingRule : std::uint8_t { NonZero, EvenOdd, Positive };

/// A Boolean function of two sets. Each member says whether points of that kind belong to the
/// result.
struct MarkFunction {
  bool neither = false;      ///< Value for points in neither set.
  bool first_only = false;   ///< Value for points only in the first set.
  bool second_only = false;  ///< Value for points only in the second set.
  bool both = false;         ///< Value for points in both sets.

  /// Returns whether a point belongs to the result, given its membership in both sets.
  constexpr bool operator()(bool first, bool second) const {
    return first ? (second ? both : first_only) : (second ? second_only : neither);
  }
};
inline constexpr MarkFunction kUnion{false, true, true, true};                 ///< Operator +.
inline constexpr MarkFunction kIntersection{false, false, false, true};        ///< Operator *.
inline constexpr MarkFunction kDifference{false, true, false, false};          ///< Operator -.
inline constexpr MarkFunction kSymmetricDifference{false, true, true, false};  ///< Operator ^.

/// The mark of a cell: 0, 1 or kBeyond.
using Mark = std::uint8_t;
inline constexpr Mark kBeyond = 2;  ///< The mark of the frame, neither in nor outside a set.

/// A MarkFunction extended to marks that may be kBeyond. In set operations either both marks are
/// kBeyond or neither is.
class MarkTable {
 public:
  /// Extends f; the value is kBeyond if a mark is kBeyond.
  constexpr explicit MarkTable(MarkFunction f)
      : table_{f.neither, f.second_only, kBeyond, f.first_only, f.both,
               kBeyond,   kBeyond,       kBeyond, kBeyond} {}

  /// Returns the table whose value is 1 if the marks differ, kBeyond included, and 0 otherwise.
  static constexpr MarkTable unequal() {
    MarkTable table(kSymmetricDifference);
    table.table_ = {0, 1, 1, 1, 0, 1, 1, 1, 0};
    return table;
  }

  /// Returns the table that combines a set (first) with walls (second): kBeyond if a wall lies in
  /// the set, otherwise the mark of the set. The value is kBeyond if a mark is kBeyond.
  static constexpr MarkTable walled() {
    MarkTable table(kDifference);
    table.table_ = {0, 0, kBeyond, 1, kBeyond, kBeyond, kBeyond, kBeyond, kBeyond};
    return table;
  }

  /// Returns the value for two marks.
  constexpr Mark operator()(Mark first, Mark second) const { return table_[first * 3U + second]; }

 private:
  std::array<Mark, 9> table_;
};

}  // namespace plumb
#pragma GCC visibility pop
