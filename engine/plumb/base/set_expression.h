// Expressions over named sets, such as "(A + B) * !C".
//
//   !  complement    *  intersection    +  union    -  difference    ^  symmetric difference
//   @  Minkowski sum, only in expressions that may have it
//
// The operator ! binds most tightly, then @, then *, then + and -, then ^. Operators of the same
// precedence associate to the left. A name consists of letters, digits and underscores and does not
// begin with a digit.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#pragma GCC visibility push(default)
namespace plumb {

/// The kind of a step of an expression.
enum class SetOperator : std::uint8_t {
  Operand,
  Complement,
  Intersection,
  Union,
  Difference,
  SymmetricDifference,
  MinkowskiSum,
};

/// The operators that an expression may have.
enum class SetOperators : std::uint8_t {
  Boolean,   ///< The operators of the Boolean algebra.
  WithSums,  ///< The operators of the Boolean algebra, and MinkowskiSum.
};

/// An expression in postfix order. An operand pushes its value. The operator Complement pops one
/// value and pushes its complement. Every other operator pops two values and pushes its result.
struct SetExpression {
  /// One operand or operator.
  struct Step {
    SetOperator op;      ///< The kind of the step.
    std::uint32_t name;  ///< The index into `names` for an operand; 0 for an operator.
    friend bool operator==(const Step&, const Step&) = default;
  };
  std::vector<Step> steps;         ///< The steps in postfix order.
  std::vector<std::string> names;  ///< The distinct names, in the order of first appearance.
};

/// Parses an expression. Throws Error{Syntax}, with the column, if `text` is not an expression. The
/// parser does not recurse, so any depth of parentheses is allowed. Cost: O(length) steps. In
/// addition, each operand needs one search among the distinct names.
SetExpression parse_set_expression(std::string_view text,
                                   SetOperators operators = SetOperators::Boolean);

/// Returns the value of an expression. The caller passes three functions: `operand(i)` returns the
/// value of names[i], `complement(a)` returns the complement of a, and `boolean_op(op, a, b)`
/// returns the value of a binary operator. Requires an expression that parse_set_expression
/// returned.
template <class Set, class Operand, class Complement, class Combine>
Set evaluate(const SetExpression& expression, Operand operand, Complement complement,
             Combine boolean_op) {
  std::vector<Set> stack;
  for (const SetExpression::Step& step : expression.steps) {
    if (step.op == SetOperator::Operand) {
      stack.push_back(operand(step.name));
    } else if (step.op == SetOperator::Complement) {
      stack.back() = complement(stack.back());
    } else {
      const Set second = std::move(stack.back());
      stack.pop_back();
      stack.back() = boolean_op(step.op, stack.back(), second);
    }
  }
  return std::move(stack.back());
}

}  // namespace plumb
#pragma GCC visibility pop
