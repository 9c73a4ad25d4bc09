#include "plumb/base/set_expression.h"

#include <algorithm>

#include "plumb/predicates/error.h"

namespace plumb {
namespace {

bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }
bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }

SetOperator binary_operator(char c) {
  switch (c) {
    case '*':
      return SetOperator::Intersection;
    case '+':
      return SetOperator::Union;
    case '-':
      return SetOperator::Difference;
    case '^':
      return SetOperator::SymmetricDifference;
    case '@':
      return SetOperator::MinkowskiSum;
    default:
      return SetOperator::Operand;  // The character is not an operator.
  }
}

/// Returns how strongly an operator binds.
int rank(SetOperator op) {
  if (op == SetOperator::Complement) return 4;
  if (op == SetOperator::MinkowskiSum) return 3;
  if (op == SetOperator::Intersection) return 2;
  return op == SetOperator::SymmetricDifference ? 0 : 1;
}

/// Parses an expression with Dijkstra's shunting-yard algorithm: `waiting_` is the stack of
/// operators and open parentheses.
class Parser {
 public:
  Parser(std::string_view text, SetOperators operators) : text_(text), operators_(operators) {}

  SetExpression run() {
    skip_blanks();
    while (at_ < text_.size()) {
      if (wants_operand_) {
        read_operand();
      } else {
        read_operator();
      }
      skip_blanks();
    }
    if (wants_operand_) fail("a name, ! or ( is missing");
    while (!waiting_.empty()) {
      if (waiting_.back().is_open) fail_at(waiting_.back().column, "this ( is not closed");
      pop();
    }
    return std::move(out_);
  }

 private:
  struct Waiting {
    bool is_open;
    SetOperator op;
    std::size_t column;
  };

  [[noreturn]] void fail_at(std::size_t column, const std::string& what) const {
    throw Error(ErrorCode::Syntax, what, {"expression", 1, column + 1});
  }
  [[noreturn]] void fail(const std::string& what) const { fail_at(at_, what); }

  void skip_blanks() {
    while (at_ < text_.size() && is_blank(text_[at_])) ++at_;
  }

  void read_operand() {
    const char c = text_[at_];
    if (c == '!' || c == '(') {
      waiting_.push_back({c == '(', SetOperator::Complement, at_++});
    } else if (is_letter(c)) {
      read_name();
      wants_operand_ = false;
    } else {
      fail("expected a name, ! or (");
    }
  }

  void read_name() {
    std::size_t end = at_;
    while (end < text_.size() && (is_letter(text_[end]) || is_digit(text_[end]))) ++end;
    const std::string name(text_.substr(at_, end - at_));
    const auto known = std::find(out_.names.begin(), out_.names.end(), name);
    const auto index = static_cast<std::uint32_t>(known - out_.names.begin());
    if (known == out_.names.end()) out_.names.push_back(name);
    out_.steps.push_back({SetOperator::Operand, index});
    at_ = end;
  }

  void read_operator() {
    if (text_[at_] == ')') return close();
    const SetOperator op = binary_operator(text_[at_]);
    const bool has_sums = operators_ == SetOperators::WithSums;
    if (op == SetOperator::MinkowskiSum && !has_sums) {
      fail("@ (Minkowski sum) is not an operator of this expression");
    }
    if (op == SetOperator::Operand) {
      fail(has_sums ? "expected one of + * - ^ @ or )" : "expected one of + * - ^ or )");
    }
    while (!waiting_.empty() && !waiting_.back().is_open && rank(waiting_.back().op) >= rank(op)) {
      pop();
    }
    waiting_.push_back({false, op, at_++});
    wants_operand_ = true;
  }

  void close() {
    while (!waiting_.empty() && !waiting_.back().is_open) pop();
    if (waiting_.empty()) fail("this ) closes nothing");
    waiting_.pop_back();
    ++at_;
  }

  void pop() {
    out_.steps.push_back({waiting_.back().op, 0});
    waiting_.pop_back();
  }

  std::string_view text_;
  SetOperators operators_;
  std::size_t at_ = 0;
  bool wants_operand_ = true;
  std::vector<Waiting> waiting_;
  SetExpression out_;
};

}  // namespace

SetExpression parse_set_expression(std::string_view text, SetOperators operators) {
  return Parser(text, operators).run();
}

}  // namespace plumb
