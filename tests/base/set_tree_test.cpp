// Rewritten expressions have the value of the expression from left to right: on sets of 64
// elements, where all operations are exact and cheap.
#include "plumb/base/set_tree.h"

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <random>
#include <string>
#include <vector>

namespace plumb::set_tree_test {
namespace {

using Bits = std::uint64_t;

Bits combined(SetOperator op, Bits a, Bits b) {
  if (op == SetOperator::Union) return a | b;
  if (op == SetOperator::Intersection) return a & b;
  if (op == SetOperator::Difference) return a & ~b;
  return a ^ b;
}

/// The operations of a tree, which count how often they are called.
struct BitOperations {
  std::size_t calls = 0;

  Bits fold(SetOperator op, const std::vector<Bits>& sets) {
    EXPECT_GE(sets.size(), 2U);
    ++calls;
    Bits value = sets[0];
    for (std::size_t i = 1; i < sets.size(); ++i) value = combined(op, value, sets[i]);
    return value;
  }
  Bits union_of(const std::vector<Bits>& sets) { return fold(SetOperator::Union, sets); }
  Bits intersection_of(const std::vector<Bits>& sets) {
    return fold(SetOperator::Intersection, sets);
  }
  Bits difference_of(const std::vector<Bits>& sets) { return fold(SetOperator::Difference, sets); }
  Bits symmetric_difference(Bits a, Bits b) {
    return fold(SetOperator::SymmetricDifference, {a, b});
  }
  Bits complement(Bits a) {
    ++calls;
    return ~a;
  }
};

Bits value_of(const SetExpression& expression, const std::vector<Bits>& operands) {
  return evaluate<Bits>(
      expression, [&](std::uint32_t i) { return operands[i]; }, [](Bits a) { return ~a; },
      combined);
}

Bits value_of(const SetTree& tree, const std::vector<Bits>& operands,
              std::size_t* calls = nullptr) {
  BitOperations operations;
  const Bits value = evaluate_tree<Bits>(
      tree, [&](std::uint32_t i) { return operands[i]; }, operations);
  if (calls != nullptr) *calls = operations.calls;
  return value;
}

/// Returns an expression in which names occur several times.
SetExpression random_expression(std::mt19937& random, std::size_t operands) {
  SetExpression expression;
  for (std::size_t i = 0; i < operands; ++i) expression.names.push_back("A" + std::to_string(i));
  std::size_t height = 0;
  while (height != 1 || random() % 24 != 0) {
    const auto choice = static_cast<std::uint32_t>(random() % 8);
    if (height == 0 || choice == 0 || (height < 4 && choice < 4)) {
      const auto name = static_cast<std::uint32_t>(random() % operands);
      expression.steps.push_back({SetOperator::Operand, name});
      ++height;
    } else if (choice == 1) {
      expression.steps.push_back({SetOperator::Complement, 0});
    } else if (height > 1) {
      const auto op = static_cast<SetOperator>(2 + random() % 4);
      expression.steps.push_back({op, 0});
      --height;
    }
  }
  return expression;
}

TEST(SetTree, ValuesAreThoseFromLeftToRight) {
  std::mt19937 random(7);
  for (int round = 0; round < 20000; ++round) {
    const SetExpression expression = random_expression(random, 1 + random() % 6);
    std::vector<Bits> operands(expression.names.size());
    for (Bits& bits : operands) bits = (Bits{random()} << 32U) | random();
    ASSERT_EQ(value_of(rewritten(expression), operands), value_of(expression, operands))
        << "round " << round;
  }
}

/// Returns how many operations the rewritten expression takes.
std::size_t calls_of(const std::string& text) {
  const SetExpression expression = parse_set_expression(text);
  std::vector<Bits> operands(expression.names.size());
  for (std::size_t i = 0; i < operands.size(); ++i) operands[i] = Bits{0x9e3779b97f4a7c15U} << i;
  std::size_t calls = 0;
  EXPECT_EQ(value_of(rewritten(expression), operands, &calls), value_of(expression, operands));
  return calls;
}

TEST(SetTree, ChainsBecomeOneOperation) {
  EXPECT_EQ(calls_of("A"), 0U);
  EXPECT_EQ(calls_of("A + B + (C + D) + A"), 1U);
  EXPECT_EQ(calls_of("A * (B * C) * D * B"), 1U);
  EXPECT_EQ(calls_of("A - B - C - (D + E)"), 1U);
  EXPECT_EQ(calls_of("A - B - C * D - E"), 2U);
  EXPECT_EQ(calls_of("A * !B * !C"), 1U);
  EXPECT_EQ(calls_of("A * B - C - D"), 2U);
}

TEST(SetTree, ComplementsAreFew) {
  EXPECT_EQ(calls_of("!!A"), 0U);
  EXPECT_EQ(calls_of("!A * !B * !C"), 2U);  // The complement of a union.
  EXPECT_EQ(calls_of("!(!A + B)"), 1U);     // A - B, without the complement of a complement.
  EXPECT_EQ(calls_of("A - !B"), 1U);        // An intersection.
}

TEST(SetTree, EqualSubexpressionsAreEvaluatedOnce) {
  EXPECT_EQ(calls_of("(A - B) ^ (C + (A - B))"), 3U);
  EXPECT_EQ(calls_of("(A ^ B) + (B ^ A)"), 1U);
}

TEST(SetTree, DepthHasNoLimit) {
  SetTreeBuilder builder;
  SetTreeBuilder::Term term = builder.operand(0);
  for (std::uint32_t i = 1; i < 200000; ++i) {
    const auto op = i % 2 == 0 ? SetOperator::Union : SetOperator::Intersection;
    term = builder.combine(op, term, builder.operand(i));
  }
  const SetTree tree = builder.finish(term);
  std::vector<Bits> operands(200000);
  Bits expected = 0;
  for (std::size_t i = 0; i < operands.size(); ++i) {
    operands[i] = i % 2 == 0 ? Bits{1} << (i % 64) : ~(Bits{1} << (i % 63));
    expected = i % 2 == 0 ? (expected | operands[i]) : (expected & operands[i]);
  }
  EXPECT_EQ(value_of(tree, operands), expected);
}

/// Sets of integers from 0 to 63, with their sums.
struct SumOperations : BitOperations {
  Bits minkowski_sum(const std::vector<Bits>& sets) {
    ++calls;
    Bits sum = 1;
    for (const Bits set : sets) {
      Bits next = 0;
      for (unsigned x = 0; x < 64; ++x) next |= ((set >> x) & 1U) != 0 ? sum << x : 0;
      sum = next;
    }
    return sum;
  }
};

TEST(SetTree, ChainsOfSumsBecomeOneSum) {
  const auto value = [](const std::string& text, std::size_t calls) {
    SumOperations operations;
    const std::array<Bits, 3> operands{0b1001, 0b10, 0b110};
    const SetExpression expression = parse_set_expression(text, SetOperators::WithSums);
    const Bits result = evaluate_tree<Bits>(
        rewritten(expression),
        [&](std::uint32_t i) {
          return operands[static_cast<std::size_t>(expression.names[i][0] - 'A')];
        },
        operations);
    EXPECT_EQ(operations.calls, calls) << text;
    return result;
  };
  EXPECT_EQ(value("A @ B @ C", 1), 0b1101100U);
  EXPECT_EQ(value("C @ (A @ B)", 1), 0b1101100U);
  EXPECT_EQ(value("B @ B @ B", 1), 0b1000U) << "an operand counts as often as it occurs";
  EXPECT_EQ(value("A @ (B + C)", 2), 0b110110U);
  EXPECT_EQ(value("(A @ B) ^ ((A @ B) @ C)", 3), 0b1111110U);
}

}  // namespace
}  // namespace plumb::set_tree_test
