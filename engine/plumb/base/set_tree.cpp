// Rewriting of expressions (set_tree.h).
//
// A literal is a term with a sign: the term itself, or its complement. A literal is a conjunction
// (of literals) if it is an intersection, a difference, or the complement of a union; it is a
// disjunction if it is a union, or the complement of an intersection or of a difference. A chain is
// a maximal part of the expression in which conjunctions are literals of conjunctions; by De
// Morgan's laws, all disjunctions are complements of conjunctions. Therefore one form is enough:
//     value of a chain = intersection of its positive literals - union of its negative ones
// with one exception: a disjunction without negative literals is a union. The literals of a chain
// are chains of the other kind, symmetric differences and operands. A term with several users ends
// a chain, so that its value is computed once.
//
// Minkowski sums are associative and commutative, so a chain of them is one sum of its operands. An
// operand that occurs twice is added twice. No rule connects sums and complements.
//
// A chain is walked with a stack, so the depth of expressions has no limit. Tested by
// tests/base/set_tree_test.cpp against the values of expressions from left to right.
#include "plumb/base/set_tree.h"

#include <algorithm>

namespace plumb {
namespace {

/// A term or its complement.
struct Literal {
  std::uint32_t term;
  bool is_positive;
};

/// The literals of a chain, without their signs.
struct Chain {
  std::vector<std::uint32_t> positive;
  std::vector<std::uint32_t> negative;
};

bool is_junction(SetOperator op) {
  return op == SetOperator::Union || op == SetOperator::Intersection ||
         op == SetOperator::Difference;
}

/// Whether a literal of a junction is a conjunction.
bool is_conjunction(SetOperator op, bool is_positive) {
  return (op != SetOperator::Union) == is_positive;
}

/// Rewrites the terms of a builder.
template <class Binary>
class Rewriter {
 public:
  explicit Rewriter(const std::vector<Binary>& terms)
      : terms_(terms), users_(terms.size(), 0), node_(terms.size(), kNone), seen_(terms.size()) {}

  SetTree run(std::uint32_t value) {
    count_users(value);
    // A term is visited twice. The first visit puts the terms that it needs above it on the stack,
    // and the second visit closes it.
    std::vector<std::uint32_t> stack{value};
    std::vector<bool> is_open(terms_.size());
    while (!stack.empty()) {
      const std::uint32_t term = stack.back();
      if (node_[term] != kNone) {
        stack.pop_back();
      } else if (!is_open[term]) {
        is_open[term] = true;
        for (const std::uint32_t needed : needs(term)) stack.push_back(needed);
      } else {
        stack.pop_back();
        close(term);
      }
    }
    tree_.value = node_[value];
    return std::move(tree_);
  }

 private:
  static constexpr std::uint32_t kNone = ~std::uint32_t{0};

  void count_users(std::uint32_t value) {
    std::vector<std::uint32_t> stack{value};
    users_[value] = 1;
    const auto use = [&](std::uint32_t term) {
      if (users_[term]++ == 0) stack.push_back(term);
    };
    while (!stack.empty()) {
      const Binary binary = terms_[stack.back()];
      stack.pop_back();
      if (binary.op == SetOperator::Operand) continue;
      use(binary.a);
      if (binary.op != SetOperator::Complement) use(binary.b);
    }
  }

  /// Returns the literals of the chain that begins at a junction.
  Chain chain_of(std::uint32_t top, bool wants_conjunction) {
    Chain chain;
    std::vector<Literal> stack{{top, true}};
    while (!stack.empty()) {
      const Literal literal = stack.back();
      stack.pop_back();
      const Binary& binary = terms_[literal.term];
      if (binary.op == SetOperator::Complement) {
        stack.push_back({binary.a, !literal.is_positive});
      } else if (goes_on(literal, top, wants_conjunction)) {
        const bool flips_second = binary.op == SetOperator::Difference;
        stack.push_back({binary.b, literal.is_positive != flips_second});
        stack.push_back({binary.a, literal.is_positive});
      } else {
        (literal.is_positive ? chain.positive : chain.negative).push_back(literal.term);
      }
    }
    drop_repeated(chain.positive);
    drop_repeated(chain.negative);
    return chain;
  }

  bool goes_on(const Literal& literal, std::uint32_t top, bool wants_conjunction) const {
    const SetOperator op = terms_[literal.term].op;
    return is_junction(op) && is_conjunction(op, literal.is_positive) == wants_conjunction &&
           (literal.term == top || users_[literal.term] == 1);
  }

  /// Keeps the first of equal terms.
  void drop_repeated(std::vector<std::uint32_t>& terms) {
    const auto is_repeated = [&](std::uint32_t term) {
      if (seen_[term]) return true;
      seen_[term] = true;
      return false;
    };
    terms.erase(std::remove_if(terms.begin(), terms.end(), is_repeated), terms.end());
    for (const std::uint32_t term : terms) seen_[term] = false;
  }

  /// Returns the operands of the chain of Minkowski sums that begins at a sum.
  std::vector<std::uint32_t> summands_of(std::uint32_t top) const {
    std::vector<std::uint32_t> summands, stack{top};
    while (!stack.empty()) {
      const std::uint32_t term = stack.back();
      stack.pop_back();
      const Binary& binary = terms_[term];
      if (binary.op == SetOperator::MinkowskiSum && (term == top || users_[term] == 1)) {
        stack.push_back(binary.b);
        stack.push_back(binary.a);
      } else {
        summands.push_back(term);
      }
    }
    return summands;
  }

  bool is_conjunction_term(std::uint32_t term) const {
    return is_conjunction(terms_[term].op, true);
  }

  /// Returns the terms whose nodes the node of a term has as children or grandchildren.
  std::vector<std::uint32_t> needs(std::uint32_t term) {
    const Binary& binary = terms_[term];
    if (binary.op == SetOperator::Operand) return {};
    if (binary.op == SetOperator::Complement) return {binary.a};
    if (binary.op == SetOperator::MinkowskiSum) return summands_of(term);
    if (!is_junction(binary.op)) return {binary.b, binary.a};
    Chain chain = chain_of(term, is_conjunction_term(term));
    chain.positive.insert(chain.positive.end(), chain.negative.begin(), chain.negative.end());
    std::reverse(chain.positive.begin(), chain.positive.end());
    return std::move(chain.positive);
  }

  void close(std::uint32_t term) {
    const Binary& binary = terms_[term];
    if (binary.op == SetOperator::Operand) {
      tree_.nodes.push_back({binary.op, binary.a, 0, 0});
      node_[term] = static_cast<std::uint32_t>(tree_.nodes.size() - 1);
    } else if (binary.op == SetOperator::Complement) {
      node_[term] = complement(node_[binary.a]);
    } else if (binary.op == SetOperator::MinkowskiSum) {
      std::vector<std::uint32_t> summands = summands_of(term);
      for (std::uint32_t& t : summands) t = node_[t];
      node_[term] = add(binary.op, summands);
    } else if (!is_junction(binary.op)) {
      node_[term] = add(binary.op, {node_[binary.a], node_[binary.b]});
    } else {
      node_[term] = close_chain(term);
    }
  }

  std::uint32_t close_chain(std::uint32_t term) {
    const bool is_conjunction = is_conjunction_term(term);
    Chain chain = chain_of(term, is_conjunction);
    for (std::uint32_t& t : chain.positive) t = node_[t];
    for (std::uint32_t& t : chain.negative) t = node_[t];
    if (is_conjunction) return conjunction(std::move(chain));
    if (chain.negative.empty()) return joined(SetOperator::Union, std::move(chain.positive));
    // A union with complements is the complement of a conjunction with all signs changed.
    std::swap(chain.positive, chain.negative);
    return complement(conjunction(std::move(chain)));
  }

  /// Returns the node of (intersection of the positive nodes) - (union of the negative nodes).
  std::uint32_t conjunction(Chain chain) {
    if (chain.positive.empty()) {
      return complement(joined(SetOperator::Union, std::move(chain.negative)));
    }
    const std::uint32_t first = joined(SetOperator::Intersection, std::move(chain.positive));
    if (chain.negative.empty()) return first;
    chain.negative.insert(chain.negative.begin(), first);
    return add(SetOperator::Difference, chain.negative);
  }

  /// Returns the node of a complement. Two complements cancel. The first complement may then have
  /// no users left.
  std::uint32_t complement(std::uint32_t of) {
    const SetTree::Node& node = tree_.nodes[of];
    if (node.op == SetOperator::Complement) return tree_.children[node.first_child];
    return add(SetOperator::Complement, {of});
  }

  std::uint32_t joined(SetOperator op, std::vector<std::uint32_t> nodes) {
    return nodes.size() == 1 ? nodes[0] : add(op, nodes);
  }

  std::uint32_t add(SetOperator op, const std::vector<std::uint32_t>& children) {
    const auto first = static_cast<std::uint32_t>(tree_.children.size());
    tree_.children.insert(tree_.children.end(), children.begin(), children.end());
    tree_.nodes.push_back({op, 0, first, static_cast<std::uint32_t>(children.size())});
    return static_cast<std::uint32_t>(tree_.nodes.size() - 1);
  }

  const std::vector<Binary>& terms_;
  std::vector<std::uint32_t> users_;  // The number of terms that have this term as an operand.
  std::vector<std::uint32_t> node_;   // The node of a term, once it is closed.
  std::vector<bool> seen_;            // All values are false outside of drop_repeated().
  SetTree tree_;
};

}  // namespace

std::size_t SetTreeBuilder::Hash::operator()(const Binary& binary) const {
  std::uint64_t h = (std::uint64_t{binary.a} << 32U | binary.b) * 0x9e3779b97f4a7c15U;
  h ^= h >> 29U;
  h += static_cast<std::uint64_t>(binary.op);
  h *= 0xbf58476d1ce4e5b9U;
  return static_cast<std::size_t>(h ^ h >> 32U);
}

SetTreeBuilder::Term SetTreeBuilder::add(SetOperator op, std::uint32_t a, std::uint32_t b) {
  const Binary binary{op, a, b};
  const auto [place, is_new] = known_.try_emplace(binary, static_cast<Term>(terms_.size()));
  if (is_new) terms_.push_back(binary);
  return place->second;
}

SetTreeBuilder::Term SetTreeBuilder::operand(std::uint32_t number) {
  return add(SetOperator::Operand, number, 0);
}

SetTreeBuilder::Term SetTreeBuilder::complement(Term of) {
  if (terms_[of].op == SetOperator::Complement) return terms_[of].a;
  return add(SetOperator::Complement, of, 0);
}

SetTreeBuilder::Term SetTreeBuilder::combine(SetOperator op, Term a, Term b) {
  // The other operations are commutative.
  if (op != SetOperator::Difference && a > b) std::swap(a, b);
  return add(op, a, b);
}

SetTree SetTreeBuilder::finish(Term value) const { return Rewriter(terms_).run(value); }

SetTree rewritten(const SetExpression& expression) {
  SetTreeBuilder builder;
  std::vector<SetTreeBuilder::Term> stack;
  for (const SetExpression::Step& step : expression.steps) {
    if (step.op == SetOperator::Operand) {
      stack.push_back(builder.operand(step.name));
    } else if (step.op == SetOperator::Complement) {
      stack.back() = builder.complement(stack.back());
    } else {
      const SetTreeBuilder::Term second = stack.back();
      stack.pop_back();
      stack.back() = builder.combine(step.op, stack.back(), second);
    }
  }
  return builder.finish(stack.back());
}

}  // namespace plumb
