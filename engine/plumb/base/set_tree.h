// Represents expressions over sets as trees, and evaluates such trees. An operator of a tree can
// have any number of operands.
//
// Main flow:
//  1. SetTreeBuilder  takes operands and binary operators. Equal subexpressions become one node
//  2. finish()        rewrites the expression:
//                     - chains of unions become one union, and chains of intersections become one
//                       intersection. If an operand occurs twice in a chain, one occurrence is
//                       dropped
//                     - intersections with complements, and chains of differences, become one
//                       difference: (intersection of some operands) - (union of the others)
//                     - unions with complements become the complement of such a difference, so that
//                       few sets are unbounded
//                     - chains of Minkowski sums become one sum
//                     If the value of a node is used by several other nodes, the node is not merged
//                     into a chain. It is evaluated once
//  3. evaluate_tree() calls functions that compute the union, the intersection or the difference of
//                     many sets. Each of these functions can choose the order in which it combines
//                     the sets (an example is union_of() in nef3.h)
// All rewriting steps are identities of Boolean algebra. So the tree has exactly the value of the
// original expression, for every class of sets.
//
// Cost: O(n) for n operators, plus the cost of the operations on sets. No function recurses, so
// expressions may be nested to any depth.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <unordered_map>
#include <utility>
#include <vector>

#include "plumb/base/set_expression.h"

#pragma GCC visibility push(default)
namespace plumb {

/// A rewritten expression. Each node comes after its children in `nodes`.
struct SetTree {
  /// A node. The children of a union, an intersection or a Minkowski sum have no order, and a sum
  /// can have the same child several times. A difference subtracts all other children from its
  /// first child. A complement has one child, and a symmetric difference has two children.
  struct Node {
    SetOperator op = SetOperator::Operand;  ///< The kind of the node.
    std::uint32_t operand = 0;              ///< The number of the operand, if `op` is Operand.
    std::uint32_t first_child = 0;          ///< Index into `children`.
    std::uint32_t child_count = 0;          ///< The number of children; 0 for an operand.
  };
  std::vector<Node> nodes;              ///< All nodes.
  std::vector<std::uint32_t> children;  ///< Indices of nodes.
  /// The node whose value is the value of the whole expression.
  std::uint32_t value = 0;

  /// Returns the children of a node.
  std::span<const std::uint32_t> children_of(const Node& node) const {
    return std::span(children).subspan(node.first_child, node.child_count);
  }
};

/// Collects an expression, and rewrites it.
class SetTreeBuilder {
 public:
  /// A subexpression, as an index that the builder assigns.
  using Term = std::uint32_t;

  /// Returns the term for operand `number`. Calls with the same number return the same term.
  Term operand(std::uint32_t number);
  /// Returns the term for the complement of the term `of`.
  Term complement(Term of);
  /// Returns the term for the value of a binary operator on the terms `a` and `b`. Requires an
  /// operator other than Operand and Complement.
  Term combine(SetOperator op, Term a, Term b);

  /// Returns the rewritten form of the expression whose value is the term `value`.
  [[nodiscard]] SetTree finish(Term value) const;

 private:
  struct Binary {
    SetOperator op;
    std::uint32_t a;
    std::uint32_t b;
    friend bool operator==(const Binary&, const Binary&) = default;
  };
  struct Hash {
    std::size_t operator()(const Binary& binary) const;
  };

  Term add(SetOperator op, std::uint32_t a, std::uint32_t b);

  std::vector<Binary> terms_;
  std::unordered_map<Binary, Term, Hash> known_;
};

/// Returns the rewritten form of a parsed expression. Operand i is expression.names[i].
[[nodiscard]] SetTree rewritten(const SetExpression& expression);

/// Returns the value of a tree. The caller passes two objects. `operand(i)` returns the value of
/// operand i. `operations` has the members complement(a), symmetric_difference(a, b),
/// union_of(sets), intersection_of(sets) and difference_of(sets). The last three take a
/// std::vector<Set> of at least two sets. If the tree has Minkowski sums, the member
/// minkowski_sum(sets) is needed, too. A value is freed as soon as no operation needs it any
/// more.
template <class Set, class Operand, class Operations>
[[nodiscard]] Set evaluate_tree(const SetTree& tree, const Operand& operand,
                                Operations& operations) {
  std::vector<std::uint32_t> users(tree.nodes.size(), 0);
  for (const std::uint32_t child : tree.children) ++users[child];
  ++users[tree.value];
  std::vector<Set> values(tree.nodes.size());
  for (std::size_t i = 0; i < tree.nodes.size(); ++i) {
    const SetTree::Node& node = tree.nodes[i];
    if (users[i] == 0) continue;
    if (node.op == SetOperator::Operand) {
      values[i] = operand(node.operand);
      continue;
    }
    std::vector<Set> sets;
    for (const std::uint32_t child : tree.children_of(node)) {
      const bool is_last = --users[child] == 0;
      sets.push_back(is_last ? std::exchange(values[child], Set()) : values[child]);
    }
    switch (node.op) {
      case SetOperator::Union:
        values[i] = operations.union_of(std::move(sets));
        break;
      case SetOperator::Intersection:
        values[i] = operations.intersection_of(std::move(sets));
        break;
      case SetOperator::Difference:
        values[i] = operations.difference_of(std::move(sets));
        break;
      case SetOperator::SymmetricDifference:
        values[i] = operations.symmetric_difference(std::move(sets[0]), std::move(sets[1]));
        break;
      case SetOperator::MinkowskiSum:
        if constexpr (requires { operations.minkowski_sum(std::move(sets)); }) {
          values[i] = operations.minkowski_sum(std::move(sets));
        }
        break;
      default:
        values[i] = operations.complement(std::move(sets[0]));
    }
  }
  return std::move(values[tree.value]);
}

}  // namespace plumb
#pragma GCC visibility pop
