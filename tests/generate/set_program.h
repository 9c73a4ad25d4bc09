// What programs that make sets from bytes have in common, in the plane and in space: a stack
// machine of records of eight bytes. The first says how numbers are meant and how what is left is
// combined: {values, operator, unused...}; each later one pushes a set or operates on the sets
// pushed: {what, how, six points}. A leaf without extent pushes nothing. In the end all sets left
// are combined.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "oracle/cell_marks.h"
#include "plumb/testing/dice.h"
#include "plumb/testing/exact.h"

namespace plumb::testing {

inline constexpr std::size_t kProgramRecord = 8;
using ProgramRecord = std::span<const std::uint8_t>;

/// What small coordinates, some with a half or a third, are turned into. Lines stay lines, except
/// under Tenths.
enum class ProgramValues : std::uint8_t {
  Plain,
  Tenths,  ///< times 0.1, rounded: nothing is collinear any more
  Thirds,  ///< no doubles
  Far,     ///< plus 2^60: no doubles, and their nearest ones are all the same
  Large,   ///< times 2^1000
  Small,   ///< times 2^-1060: subnormal
  Uneven,  ///< x times 2^-500, y times 2^500, z as it is
  Long,    ///< times (10^30 + 1) / (10^30 + 7)
};
inline constexpr int kProgramValues = 8;

/// Of axis 0, 1 or 2.
BigRational program_value(ProgramValues values, const BigRational& v, int axis);

/// Leaf kinds come first, then the set operators, then these.
constexpr int program_copy(int leaf_kinds) { return leaf_kinds + kSetOperators; }
constexpr int program_swap(int leaf_kinds) { return program_copy(leaf_kinds) + 1; }
constexpr int program_whats(int leaf_kinds) { return program_swap(leaf_kinds) + 1; }

inline std::uint8_t any_byte(Dice& dice) { return static_cast<std::uint8_t>(dice.below(256)); }

/// Points have the bits of `grid_mask` only, most of them.
std::vector<std::uint8_t> random_set_program(Dice& dice, ProgramValues values, std::size_t records,
                                             int leaf_kinds, std::uint8_t grid_mask);

/// Runs a program. A Language has
///   Set             pointer to an expression; apply() makes larger ones
///   Carrier         a line or plane
///   kLeafKinds
///   leaf(values, what, record)     a Set; null: no extent
///   nothing()                      the empty Set
///   add_carriers(set, carriers)    each unoriented
template <class Language>
class SetProgram {
 public:
  using Set = typename Language::Set;

  /// Stops at a record that would take the expression beyond `max_carriers`.
  SetProgram(std::span<const std::uint8_t> program, std::size_t max_carriers)
      : program_(program), max_carriers_(max_carriers) {}

  Set run() {
    if (program_.size() >= 2) {
      values_ = static_cast<ProgramValues>(program_[0] % kProgramValues);
    }
    for (std::size_t i = kProgramRecord; i + kProgramRecord <= program_.size();
         i += kProgramRecord) {
      if (!step(program_.subspan(i, kProgramRecord))) break;
    }
    return folded();
  }

 private:
  static constexpr int kLeafKinds = Language::kLeafKinds;

  bool step(ProgramRecord r) {
    const int what = r[0] % program_whats(kLeafKinds);
    if (what < kLeafKinds) return push(Language::leaf(values_, what, r));
    if (what == program_copy(kLeafKinds)) {
      if (!stack_.empty()) stack_.push_back(stack_[r[1] % stack_.size()]);
    } else if (what == program_swap(kLeafKinds)) {
      if (stack_.size() >= 2) std::swap(stack_.back(), stack_[stack_.size() - 2]);
    } else {
      operate(static_cast<SetOperator>(what - kLeafKinds));
    }
    return stack_.size() <= 16;
  }

  bool push(const Set& set) {
    if (!set) return true;
    std::vector<typename Language::Carrier> carriers = carriers_;
    Language::add_carriers(*set, carriers);
    std::sort(carriers.begin(), carriers.end());
    carriers.erase(std::unique(carriers.begin(), carriers.end()), carriers.end());
    if (carriers.size() > max_carriers_) return false;
    carriers_ = std::move(carriers);
    stack_.push_back(set);
    return true;
  }

  void operate(SetOperator op) {
    if (stack_.size() < (is_binary(op) ? 2U : 1U)) return;
    Set last = std::move(stack_.back());
    stack_.pop_back();
    if (!is_binary(op)) {
      stack_.push_back(apply(op, std::move(last)));
    } else {
      stack_.back() = apply(op, stack_.back(), std::move(last));
    }
  }

  Set folded() {
    const auto op = static_cast<SetOperator>(program_.size() < 2 ? 0 : program_[1] % 4);
    while (stack_.size() > 1) operate(op);
    return stack_.empty() ? Language::nothing() : stack_.back();
  }

  std::span<const std::uint8_t> program_;
  std::size_t max_carriers_;
  ProgramValues values_ = ProgramValues::Plain;
  std::vector<typename Language::Carrier> carriers_;
  std::vector<Set> stack_;
};

}  // namespace plumb::testing
