// Random expressions of sets, which the programs *_agreement give to plumb and to CGAL.
#pragma once

#include <cstdint>

#include "oracle/cell_marks.h"
#include "plumb/testing/dice.h"

namespace plumb::bench {

/// Draws leaves, each opened now and then, and joins them by at most `most_steps` Booleans.
/// `leaf(dice)` draws a set; `applied(op, a, b)` computes a step, for both libraries; no further
/// step is drawn once `is_done()`.
template <class Leaf, class Applied, class IsDone>
void draw_expression(testing::Dice& dice, std::int64_t most_steps, Leaf leaf, Applied applied,
                     IsDone is_done) {
  using testing::SetOperator;
  const auto opened = [&](const auto& set) {
    const std::uint32_t how = dice.below(12);
    if (how > 5) return set;
    return applied(static_cast<SetOperator>(static_cast<int>(SetOperator::Complement) + how), set,
                   set);
  };
  auto set = opened(leaf(dice));
  const std::int64_t steps = dice.between(1, most_steps);
  for (std::int64_t i = 0; i < steps && !is_done(); ++i) {
    const auto other = opened(leaf(dice));
    const auto op = static_cast<SetOperator>(dice.below(4));
    const bool is_first = dice.below(2) == 0;
    set = opened(is_first ? applied(op, set, other) : applied(op, other, set));
  }
}

}  // namespace plumb::bench
