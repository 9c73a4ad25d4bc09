// Expressions over named sets: "(A + B) * !C".
//
//   !  complement    *  intersection    +  union    -  difference    ^  symmetric difference
//
// ! binds tightest, then *, then + and -, then ^; operators of one rank group from the left. Names
// are letters, digits and underscores, not starting with a digit.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#pragma GCC visibility push(default)
namespace plumb {

/// What a step of an expression does.
enum class SetOperator : std::uint8_t {
  Operand,
  Complement,
  Intersection,
  Union,
  Difference,
  SymmetricDifference,
};

/// In postfix order: operands are pushed, operators take one (Complement) or two and push their result.
struct SetExpression {
  /// An operand or an operator.
  struct Step {
    SetOperator op;      ///< what is done
    std::uint32_t name;  ///< of an operand: index into names
    friend bool operator==(const Step&, const Step&) = default;
  };
  std::vector<Step> steps;         ///< in postfix order
  std::vector<std::string> names;  ///< in the order of their first appearance
};

/// Throws Error{Syntax} with the column. O(length), whatever the nesting.
SetExpression parse_set_expression(std::string_view text);

/// The value of an expression: `operand(i)` gives that of names[i], `complement(a)`, `combine(op, a, b)`.
template <class Set, class Operand, class Complement, class Combine>
Set evaluate(const SetExpression& expression, Operand operand, Complement complement,
             Combine combine) {
  std::vector<Set> stack;
  for (const SetExpression::Step& step : expression.steps) {
    if (step.op == SetOperator::Operand) {
      stack.push_back(operand(step.name));
    } else if (step.op == SetOperator::Complement) {
      stack.back() = complement(stack.back());
    } else {
      const Set second = std::move(stack.back());
      stack.pop_back();
      stack.back() = combine(step.op, stack.back(), second);
    }
  }
  return std::move(stack.back());
}

}  // namespace plumb
#pragma GCC visibility pop
