// A strict scanner of XML, as much of it as drawings need: elements and their attributes, in order.
//
// Text between elements, comments, CDATA, processing instructions and a document type without a
// subset are passed over. Nothing is expanded and nothing is loaded: values are bytes of the file,
// references in them are left as they stand, and a document type with a subset of its own (where
// entities are declared) is refused.
//
// Checked: UTF-8 without control characters, tags that match, one root, attributes in quotes
// without '<'. Errors at their places: NotText, Syntax, CountMismatch (nothing but blanks),
// ResourceLimit; Cancelled. Cost: O(bytes).
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "plumb/base/context.h"
#include "plumb/io/text/input_cursors.h"
#include "plumb/io/text/record_reader.h"

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
  /// The value of one of the attributes of the element that started last. Fails if it is there
  /// twice.
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

// What stands in attributes of SVG: numbers, lengths, flags, words, with the place of every error.

/// Walks the value of an attribute. Numbers are separated by blanks, by a comma among them, or by
/// nothing where a sign or a second point tells them apart.
class SvgValue {
 public:
  /// `cursor` stands at the value.
  SvgValue(TextCursor cursor, std::string_view value, NumberReader& numbers)
      : start_(cursor), cursor_(std::move(cursor)), rest_(value), numbers_(numbers) {}

  /// Skips blanks; true when nothing follows. Fails where a comma has promised more.
  bool at_end();
  /// The next byte, if there is one. Call at_end() first.
  char peek() const { return rest_.empty() ? '\0' : rest_.front(); }
  const char* position() const { return rest_.data(); }
  /// Past a byte that is no number.
  void skip();

  /// A finite number, and what separates it from the next.
  double number();
  /// The same with a unit: px is none, in, cm, mm, pt, pc are converted, others fail.
  double length();
  /// One digit, 0 or 1, which needs no separator.
  bool flag();
  /// A word of letters.
  std::string_view word();
  void take(char c);

  [[noreturn]] void fail(ErrorCode code, const std::string& message, const char* where) const;
  [[noreturn]] void fail_expected(const std::string& what) const;
  /// At the number read last.
  const TextCursor& cursor() const { return cursor_; }

 private:
  double number_alone();
  void skip_separator();
  void skip_blanks();

  TextCursor start_;
  TextCursor cursor_;
  std::string_view rest_;
  NumberReader& numbers_;
  const char* comma_ = nullptr;  // the separator before the position, if it has one
  ReadNumber number_;
};

}  // namespace plumb
