// The syntax of drawings: a strict scanner of XML, as much of it as drawings need, and the values
// of attributes.
//
// Elements and their attributes are reported in order. Text between elements, comments, CDATA,
// processing instructions and document types are skipped. Nothing is expanded and nothing is
// loaded: values are bytes of the file, and references in them stay as they are. Drawing programs
// declare entities for name spaces; a reference to an entity between elements could stand for
// elements, and is refused.
//
// Checked are control characters, UTF-8 unless the XML declaration names another encoding that has
// ASCII in it, tags that match, one root, and attributes in quotes without '<'. Errors at their
// places: NotText, Syntax, CountMismatch (nothing but blanks), ResourceLimit; Cancelled. Cost:
// O(bytes).
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

/// An attribute of a tag.
struct XmlAttribute {
  std::string_view name;
  std::string_view value;  ///< The value without its quotes.
};

/// Returns the first reference to an entity other than the five of XML and to characters; npos if
/// there is none.
std::size_t find_entity(std::string_view text);

/// Reports the elements of a text one after the other.
class XmlScanner {
 public:
  enum class Event : std::uint8_t { Start, End, Done };

  /// `text` must outlive it; `name` is the file in messages.
  XmlScanner(std::string_view text, const std::string& name, Context& context);

  /// Returns whether an element starts, whether an element ends, or whether the text ends. An
  /// element without content starts and ends.
  Event next();

  /// Returns the name of the element that started or ended last.
  std::string_view element() const { return element_; }
  /// Returns the value of an attribute of the element that started last, or no value. Throws if it
  /// occurs twice.
  std::optional<std::string_view> attribute(std::string_view name) const;

  /// Returns a scanner of the element that started last, alone: it reports the start of this
  /// element first. Once finished(), it must not be asked for more.
  XmlScanner of_element() const;
  /// Whether the root has ended.
  bool finished() const { return has_root_ && open_.empty(); }
  /// Releases the memory that is charged for the attributes of the element that started last.
  void release_attributes();

  /// Returns a cursor at a byte of the tag read last.
  TextCursor cursor_at(const char* where) const;
  /// Returns the beginning of that tag.
  const char* tag() const { return tag_; }
  [[noreturn]] void fail(ErrorCode code, const std::string& message, const char* where) const;

 private:
  void require_text() const;
  bool find_tag();
  bool skip_from(std::string_view open, std::string_view close, const char* what);
  void skip_document_type();
  const char* end_of_subset(const char* from) const;
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
  TextCursor cursor_;  // At the tag read last.
  Context& context_;
  std::string_view element_;
  std::vector<XmlAttribute> attributes_;
  std::vector<std::string_view> open_;
  bool is_empty_ = false;  // Whether the element that started last has no content.
  bool has_root_ = false;
  bool declares_entities_ = false;
  bool is_utf8_ = true;    // False if the XML declaration names an encoding of single bytes.
  std::size_t steps_ = 0;  // Tags, comments and attributes.
};

// Values of attributes in SVG: numbers, lengths, flags and words, with the place of every error.

/// Walks the value of an attribute. Numbers are separated by blanks, possibly with one comma, or by
/// nothing if a sign or a second point separates them.
class SvgValue {
 public:
  /// `cursor` stands at the value.
  SvgValue(TextCursor cursor, std::string_view value, NumberReader& numbers)
      : start_(cursor), cursor_(std::move(cursor)), rest_(value), numbers_(numbers) {}

  /// Skips blanks; returns true if nothing follows. Throws if a comma has promised more.
  bool at_end();
  /// Returns the next byte, or 0. Requires a call of at_end() first.
  char peek() const { return rest_.empty() ? '\0' : rest_.front(); }
  const char* position() const { return rest_.data(); }
  /// Skips a byte that belongs to no number.
  void skip();

  /// Returns a finite number, and skips the characters that separate it from the next number.
  double number();
  /// Does the same for a number with a unit: px counts as none, in, cm, mm, pt and pc are
  /// converted, a percentage is one of `whole` unless this is 0, others fail.
  double length(double whole);
  /// Returns one digit, 0 or 1, which needs no separator.
  bool flag();
  /// Returns a word of letters.
  std::string_view word();
  void take(char c);

  [[noreturn]] void fail(ErrorCode code, const std::string& message, const char* where) const;
  [[noreturn]] void fail_expected(const std::string& what) const;
  /// Returns a cursor at the number read last.
  const TextCursor& cursor() const { return cursor_; }

 private:
  double number_alone();
  void skip_separator();
  void skip_blanks();

  TextCursor start_;
  TextCursor cursor_;
  std::string_view rest_;
  NumberReader& numbers_;
  const char* comma_ = nullptr;  // The separator before the position, if there is one.
  ReadNumber number_;
};

}  // namespace plumb
