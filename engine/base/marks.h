// Marks, and functions of marks: what a Boolean operation makes of the marks of its operands.
//
// A mark is 0 or 1: does the item belong to the set? kBeyond marks what lies outside the symbolic
// cube that frames an unbounded set: no operation changes it, so the frame needs no case of its own.
#pragma once

#include <array>
#include <cstdint>

#pragma GCC visibility push(default)
namespace plumb {

/// Does a set contain its boundary?
enum class Boundary : std::uint8_t { Open, Closed };

/// A function of two marks: what a point of both, of the first only, ... becomes.
struct MarkFunction {
  bool neither = false;      ///< of points in no set
  bool first_only = false;   ///< of points in the first set alone
  bool second_only = false;  ///< of points in the second set alone
  bool both = false;         ///< of points in both sets

  /// Its value for one point.
  constexpr bool operator()(bool first, bool second) const {
    return first ? (second ? both : first_only) : (second ? second_only : neither);
  }
};
inline constexpr MarkFunction kUnion{false, true, true, true};                 ///< What `+` does.
inline constexpr MarkFunction kIntersection{false, false, false, true};        ///< What `*` does.
inline constexpr MarkFunction kDifference{false, true, false, false};          ///< What `-` does.
inline constexpr MarkFunction kSymmetricDifference{false, true, true, false};  ///< What `^` does.

/// 0, 1 or kBeyond.
using Mark = std::uint8_t;
inline constexpr Mark kBeyond = 2;  ///< The mark of the frame: neither in a set nor outside of it.

/// A MarkFunction on marks that may be kBeyond. Both are beyond or none is.
class MarkTable {
 public:
  /// That function; what is beyond stays beyond.
  constexpr explicit MarkTable(MarkFunction f)
      : table_{f.neither, f.second_only, kBeyond, f.first_only, f.both,
               kBeyond,   kBeyond,       kBeyond, kBeyond} {}

  /// 1 where the marks differ, also beyond.
  static constexpr MarkTable unequal() {
    MarkTable table(kSymmetricDifference);
    table.table_ = {0, 1, 1, 1, 0, 1, 1, 1, 0};
    return table;
  }

  /// Of a set (first) and walls: kBeyond where a wall lies in the set. What was beyond stays it.
  static constexpr MarkTable walled() {
    MarkTable table(kDifference);
    table.table_ = {0, 0, kBeyond, 1, kBeyond, kBeyond, kBeyond, kBeyond, kBeyond};
    return table;
  }

  /// Its value for two marks.
  constexpr Mark operator()(Mark first, Mark second) const { return table_[first * 3U + second]; }

 private:
  std::array<Mark, 9> table_;
};

}  // namespace plumb
#pragma GCC visibility pop
