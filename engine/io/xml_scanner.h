// A strict scanner of XML, as much of it as drawings need: elements and their attributes, in order.
//
// Text between elements, comments, CDATA, processing instructions and a document type without a subset are passed over.
// Nothing is expanded and nothing is loaded: values are bytes of the file, references in them are left as they
// stand, and a document type with a subset of its own (where entities are declared) is refused.
//
// Checked: UTF-8 without control characters, tags that match, one root, attributes in quotes without '<'. Errors at
// their places: NotText, Syntax, CountMismatch (nothing but blanks), ResourceLimit; Cancelled. Cost: O(bytes).
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "plumb/base/context.h"
#include "plumb/io/text_cursor.h"

namespace plumb {

struct XmlAttribute {
  std::string_view name;
  std::string_view value;  ///< without its quotes
};

class XmlScanner {
 public:
  enum class Event : std::uint8_t { Start, End, Done };

  /// `text` must outlive it; `name` is the file in messages.
  XmlScanner(std::string_view text, const std::string& name, Context& context);

  /// An element starts or ends (one without content does both), or there is no more.
  Event next();

  /// Of the element that started or ended last.
  std::string_view element() const { return element_; }
  /// The value of one of the attributes of the element that started last. Fails if it is there twice.
  std::optional<std::string_view> attribute(std::string_view name) const;

  /// A cursor at a byte of the tag read last.
  TextCursor cursor_at(const char* where) const;
  /// At the beginning of that tag.
  const char* tag() const { return tag_; }
  [[noreturn]] void fail(ErrorCode code, const std::string& message, const char* where) const;

 private:
  void require_text() const;
  bool find_tag();
  bool skip_from(std::string_view open, std::string_view close, const char* what);
  void skip_document_type();
  void skip_blanks();
  std::string_view take_name(const char* what);
  void take(char c, const char* what);
  void read_attribute();
  void read_start();
  void read_end();
  char peek() const { return p_ == end_ ? '\0' : *p_; }

  const char* p_;
  const char* end_;
  const char* tag_;
  TextCursor cursor_;  // at the tag read last
  Context& context_;
  std::string_view element_;
  std::vector<XmlAttribute> attributes_;
  std::vector<std::string_view> open_;
  bool is_empty_ = false;  // the element that started last
  bool has_root_ = false;
  std::size_t steps_ = 0;  // tags, comments, attributes
};

}  // namespace plumb
