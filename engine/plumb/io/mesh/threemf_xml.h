// Elements of an XML text that arrives in blocks, if plumb is built with expat.
//
// The text is hostile input. A document type is refused, and with it every entity that a text could
// declare. Elements may be nested 256 deep, a tag may have 1 MiB, and a text may have 4096
// different names: the parser keeps no more. Errors have the place TEXT:LINE:COLUMN: Syntax, and
// the exceptions of the listener without a place.
#pragma once

#include <cstddef>
#include <cstdint>
#include <exception>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "plumb/predicates/error.h"

namespace plumb {

/// The start of an element. The texts are valid until the listener returns.
class XmlTag {
 public:
  /// `attributes` alternates names and values, and ends with a null pointer. A name with a name
  /// space has the form SPACE|NAME.
  XmlTag(std::string_view full_name, const char** attributes);

  std::string_view space;  ///< The name space; empty if there is none.
  std::string_view name;   ///< The name without its name space.

  /// Returns the value of an attribute without a name space.
  [[nodiscard]] std::optional<std::string_view> attribute(std::string_view name) const;
  /// Returns the value of an attribute of a name space.
  [[nodiscard]] std::optional<std::string_view> attribute(std::string_view space,
                                                          std::string_view name) const;

 private:
  const char** attributes_;
};

/// Takes the events of a text. A function that throws ends the reading.
class XmlListener {
 public:
  virtual ~XmlListener() = default;
  /// An element starts.
  virtual void start(const XmlTag& tag) = 0;
  /// The element that started last, and has not ended, ends.
  virtual void end() = 0;
  /// A part of the text between elements.
  virtual void text(std::string_view /*part*/) {}
  /// The start of the next element declares a prefix of a name space.
  virtual void declare(std::string_view /*prefix*/, std::string_view /*space*/) {}
};

/// Reads one text.
class XmlStream {
 public:
  /// `name` is the text in messages. The listener must outlive it.
  XmlStream(std::string name, XmlListener& listener);
  ~XmlStream();
  XmlStream(const XmlStream&) = delete;
  XmlStream& operator=(const XmlStream&) = delete;

  /// Reads the next block.
  void feed(std::string_view block);
  /// Ends the text.
  void finish();
  /// Returns the place of the current event.
  [[nodiscard]] TextPlace place() const;
  /// Throws at the current event.
  [[noreturn]] void fail(ErrorCode code, std::string message) const {
    throw Error(code, std::move(message), place());
  }

 private:
  struct Parser;
  std::unique_ptr<Parser> parser_;
};

}  // namespace plumb
