// A random tree, printed with as few parentheses as the ranks allow, must read back as the same
// function.

#include "plumb/base/set_expression.h"

#include <gtest/gtest.h>

#include <array>
#include <memory>
#include <random>

#include "plumb/predicates/error.h"

namespace plumb::set_expression_test {
namespace {

constexpr std::string_view kBinary = "*+-^";

struct Tree {
  char op = 0;  ///< a name in capitals, '!' or one of kBinary
  std::unique_ptr<Tree> first, second;
};

std::unique_ptr<Tree> random_tree(std::mt19937& random, int depth) {
  auto tree = std::make_unique<Tree>();
  const auto choice = static_cast<unsigned>(random() % 6);
  if (depth == 0 || choice == 0) {
    tree->op = static_cast<char>('A' + random() % 4);
  } else if (choice == 1) {
    tree->op = '!';
    tree->first = random_tree(random, depth - 1);
  } else {
    tree->op = kBinary[random() % 4];
    tree->first = random_tree(random, depth - 1);
    tree->second = random_tree(random, depth - 1);
  }
  return tree;
}

int rank(char op) {
  switch (op) {
    case '^':
      return 0;
    case '+':
    case '-':
      return 1;
    case '*':
      return 2;
    default:
      return 3;
  }
}

std::string print(const Tree& tree, int least) {
  if (!tree.first) return std::string(1, tree.op);
  if (tree.op == '!') return "!" + print(*tree.first, 3);
  const int own = rank(tree.op);
  const std::string text =
      print(*tree.first, own) + " " + tree.op + " " + print(*tree.second, own + 1);
  return own < least ? "(" + text + ")" : text;
}

bool apply(char op, bool a, bool b) {
  switch (op) {
    case '*':
      return a && b;
    case '+':
      return a || b;
    case '-':
      return a && !b;
    default:
      return a != b;
  }
}

bool value(const Tree& tree, unsigned members) {
  if (!tree.first) return ((members >> static_cast<unsigned>(tree.op - 'A')) & 1U) != 0;
  if (tree.op == '!') return !value(*tree.first, members);
  return apply(tree.op, value(*tree.first, members), value(*tree.second, members));
}

bool value(const SetExpression& expression, unsigned members) {
  return evaluate<int>(
             expression,
             [&](std::uint32_t name) {
               return static_cast<int>((members >> (expression.names[name][0] - 'A')) & 1U);
             },
             [](int a) { return 1 - a; },
             [](SetOperator op, int a, int b) {
               const char sign = kBinary[op == SetOperator::Intersection ? 0
                                         : op == SetOperator::Union      ? 1
                                         : op == SetOperator::Difference ? 2
                                                                         : 3];
               return apply(sign, a != 0, b != 0) ? 1 : 0;
             }) != 0;
}

TEST(SetExpression, ReadsBackWhatATreePrints) {
  std::mt19937 random(7);
  for (int i = 0; i < 2000; ++i) {
    const auto tree = random_tree(random, 5);
    const std::string text = print(*tree, 0);
    const SetExpression expression = parse_set_expression(text);
    for (unsigned members = 0; members < 16; ++members) {
      ASSERT_EQ(value(expression, members), value(*tree, members)) << text;
    }
  }
}

TEST(SetExpression, NestsWithoutBounds) {
  const std::string deep(100000, '(');
  EXPECT_EQ(parse_set_expression(deep + "a" + std::string(100000, ')')).steps.size(), 1U);
  EXPECT_EQ(parse_set_expression(std::string(100000, '!') + "a").steps.size(), 100001U);
}

TEST(SetExpression, KeepsNamesInOrder) {
  const std::vector<std::string> names{"part_2", "B", "x1"};
  EXPECT_EQ(parse_set_expression("part_2*B+x1-part_2").names, names);
}

TEST(SetExpression, SaysWhereItIsWrong) {
  const std::vector<std::pair<const char*, std::size_t>> wrong{
      {"", 1},   {"A +", 4},        {"+ A", 1}, {"A B", 3},   {"A ! B", 3},
      {"(A", 1}, {"A)", 2},         {"()", 2},  {"A * ", 5},  {"A & B", 3},
      {"2A", 1}, {"A + (B * C", 5}, {"A !", 3}, {"A\n+ %", 5}};
  for (const auto& [text, column] : wrong) {
    try {
      parse_set_expression(text);
      ADD_FAILURE() << text;
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ErrorCode::Syntax);
      EXPECT_EQ(error.place().column, column) << text << ": " << error.what();
    }
  }
}

TEST(SetExpression, SumsOnlyWhereTheyAreAllowed) {
  EXPECT_THROW(parse_set_expression("A @ B"), Error);
  const SetExpression sum = parse_set_expression("A * B @ !C @ D", SetOperators::WithSums);
  const std::vector<SetExpression::Step> expected{
      {SetOperator::Operand, 0},      {SetOperator::Operand, 1},      {SetOperator::Operand, 2},
      {SetOperator::Complement, 0},   {SetOperator::MinkowskiSum, 0}, {SetOperator::Operand, 3},
      {SetOperator::MinkowskiSum, 0}, {SetOperator::Intersection, 0}};
  EXPECT_EQ(sum.steps, expected);
}

}  // namespace
}  // namespace plumb::set_expression_test
