// The syntax of OpenSCAD's flattened models: nodes with modifiers, a name, parameters, and either a
// semicolon, a block of further nodes, or one further node.
//
//   node       [#%!*]... name ( [parameter [, parameter]...] ) ( ; | { node... } | node )
//   parameter  [name =] value
//   value      number | true | false | undef | "text" | [ [value [, value]...] ]
//
// Blanks, line breaks and comments (// and /* */) may stand between all tokens. Values of one node
// are a flat list in preorder. Nothing recurses.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "plumb/base/context.h"
#include "plumb/io/text/input_cursors.h"
#include "plumb/io/text/record_reader.h"

namespace plumb {

/// A value of a parameter.
struct CsgValue {
  enum class Kind : std::uint8_t { Undefined, Number, Boolean, Text, Vector };
  Kind kind = Kind::Undefined;
  double number = 0;         ///< The number, which is NaN if it is not finite; a Boolean is 0 or 1.
  std::uint32_t first = 0;   ///< The first value within a vector: the value after it.
  std::uint32_t end = 0;     ///< The value after the last value within this one.
  const char* at = nullptr;  ///< The place in the text where it begins.
};

/// A parameter: its name, which may be empty, and the index of its value.
struct CsgParameter {
  std::string_view name;
  std::uint32_t value;
};

/// Reports nodes one after the other.
class CsgScanner {
 public:
  enum class Event : std::uint8_t {
    Leaf,   ///< A node without a block.
    Open,   ///< A node whose block begins. One further node without braces is a block, too.
    Close,  ///< A block ends.
    Done,   ///< The text ends.
  };

  /// `text` must outlive it; `name` is the file in messages.
  CsgScanner(std::string_view text, const std::string& name, Context& context);

  Event next();

  // The node that was reported last.

  std::string_view name() const { return name_; }   ///< Its name.
  const char* place() const { return place_; }      ///< The place where its name begins.
  bool has(char modifier) const;                    ///< Whether it has the modifier.
  std::uint32_t line() const { return line_; }      ///< The line of its name.
  std::uint32_t column() const { return column_; }  ///< The column of its name.
  std::span<const CsgParameter> parameters() const { return parameters_; }
  /// Requires that the last event was Open. Throws Error{Syntax} if the block has no braces, for a
  /// node that has no children.
  void require_braces();
  const CsgValue& value(std::uint32_t i) const { return values_[i]; }
  /// Returns the text of a value of the kind Text, without escapes.
  std::string text_of(const CsgValue& value) const;

  /// Throws Error{code} at a place of the node that was reported last, or after it.
  [[noreturn]] void fail(ErrorCode code, const std::string& message, const char* where);
  [[noreturn]] void fail(ErrorCode code, const std::string& message) {
    fail(code, message, place_);
  }

 private:
  Event close();
  bool skip_blanks();
  void skip_comment();
  char peek();
  bool take(char c);
  void expect(char c, const char* what);
  std::string_view word();
  std::string_view token() const;
  [[noreturn]] void fail_unexpected(const char* what);
  Event read_node();
  void read_parameters();
  void read_parameter();
  void read_value();
  bool read_vector_step(std::vector<std::uint32_t>& open);
  void read_scalar();
  void read_number();
  void read_text();
  void push(CsgValue::Kind kind, double number, const char* at);

  TextCursor cursor_;  // At the place that was last turned into a line and a column.
  NumberReader numbers_;
  Context& context_;
  MemoryCharge memory_;
  const char* begin_;
  const char* p_;
  const char* end_;
  std::vector<std::uint8_t> has_braces_;  // Of each open block.
  bool is_node_over_ = false;             // Whether the last event ended a node.
  std::uint64_t nodes_ = 0;
  std::string_view name_;
  std::string_view modifiers_;
  const char* place_;
  std::uint32_t line_ = 0;
  std::uint32_t column_ = 0;
  std::vector<CsgParameter> parameters_;
  std::vector<CsgValue> values_;
};

}  // namespace plumb
