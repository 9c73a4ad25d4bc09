// Calls of expat.
//
// The parser calls functions of C, through which no exception may pass: guarded() keeps an
// exception and stops the parser, and feed() throws it again. A tag is kept by the parser until it
// is complete and is scanned again with each block, so its length is bounded. The parser keeps
// names until the text ends, so the number of different names is limited.
//
// Without PLUMB_WITH_3MF this file is never reached: no archive can be opened.
// Tested by tests/io/threemf_test.cpp.
#include "plumb/io/mesh/threemf_xml.h"

#include <algorithm>
#include <functional>
#include <new>
#include <type_traits>
#include <unordered_set>
#include <utility>

#include "plumb/io/text/input_cursors.h"

#ifdef PLUMB_WITH_3MF
#include <expat.h>
#endif

namespace plumb {
namespace {

constexpr char kSpaceEnd = '|';  // The character between a name space and a name.

}  // namespace

XmlTag::XmlTag(std::string_view full_name, const char** attributes) : attributes_(attributes) {
  const std::size_t end = full_name.rfind(kSpaceEnd);
  if (end != full_name.npos) space = full_name.substr(0, end);
  name = full_name.substr(end == full_name.npos ? 0 : end + 1);
}

std::optional<std::string_view> XmlTag::attribute(std::string_view wanted) const {
  for (const char** a = attributes_; *a != nullptr; a += 2) {
    if (wanted == *a) return a[1];
  }
  return {};
}

std::optional<std::string_view> XmlTag::attribute(std::string_view wanted_space,
                                                  std::string_view wanted) const {
  for (const char** a = attributes_; *a != nullptr; a += 2) {
    const std::string_view full = *a;
    const std::size_t end = full.rfind(kSpaceEnd);
    if (end != full.npos && full.substr(0, end) == wanted_space && full.substr(end + 1) == wanted) {
      return a[1];
    }
  }
  return {};
}

#ifdef PLUMB_WITH_3MF

namespace {

constexpr std::size_t kMostDepth = 256;
constexpr std::int64_t kMostTagBytes = std::int64_t{1} << 20U;
constexpr std::size_t kMostNames = 4096;
constexpr std::size_t kMostNameBytes = 4096;

/// Allows searches for a string view among strings.
struct NameHash {
  using is_transparent = void;
  std::size_t operator()(std::string_view name) const {
    return std::hash<std::string_view>{}(name);
  }
};

struct ParserFree {
  void operator()(XML_Parser parser) const { XML_ParserFree(parser); }
};

}  // namespace

struct XmlStream::Parser {
  Parser(std::string text_name, XmlListener& events)
      : name(std::move(text_name)), listener(events), xml(XML_ParserCreateNS(nullptr, kSpaceEnd)) {
    if (xml == nullptr) throw std::bad_alloc();
    XML_SetUserData(xml.get(), this);
    XML_SetElementHandler(xml.get(), start, end);
    XML_SetCharacterDataHandler(xml.get(), text);
    XML_SetNamespaceDeclHandler(xml.get(), declare, nullptr);
    XML_SetStartDoctypeDeclHandler(xml.get(), refuse_document_type);
  }

  static Parser& of(void* user) { return *static_cast<Parser*>(user); }

  TextPlace place() const {
    return {name, XML_GetCurrentLineNumber(xml.get()),
            static_cast<std::size_t>(XML_GetCurrentColumnNumber(xml.get())) + 1};
  }

  /// Calls the listener. An exception stops the parser and is kept.
  template <class Call>
  void guarded(Call call) {
    if (thrown) return;
    try {
      call();
    } catch (const Error& error) {
      const bool has_place = !error.place().file.empty() || error.code() == ErrorCode::Cancelled;
      thrown = has_place ? std::current_exception()
                         : std::make_exception_ptr(Error(error.code(), error.message(), place()));
    } catch (...) {
      thrown = std::current_exception();
    }
    if (thrown) XML_StopParser(xml.get(), XML_FALSE);
  }

  /// Counts a name that expat stores, once. There are only few names of one or two bytes.
  void count_name(std::string_view full) {
    if (full.size() <= 2 || names.find(full) != names.end()) return;
    if (full.size() > kMostNameBytes) throw Error(ErrorCode::ResourceLimit, "a name is too long");
    names.emplace(full);
    if (names.size() > kMostNames) {
      throw Error(ErrorCode::ResourceLimit,
                  "more than " + std::to_string(kMostNames) + " different names");
    }
  }

  static void XMLCALL start(void* user, const XML_Char* full, const XML_Char** attributes) {
    Parser& self = of(user);
    self.guarded([&] {
      if (++self.depth > kMostDepth) {
        throw Error(ErrorCode::ResourceLimit,
                    "elements are nested more than " + std::to_string(kMostDepth) + " deep");
      }
      self.count_name(full);
      for (const XML_Char** a = attributes; *a != nullptr; a += 2) self.count_name(*a);
      self.listener.start(XmlTag(full, attributes));
    });
  }
  static void XMLCALL end(void* user, const XML_Char* /*full*/) {
    Parser& self = of(user);
    self.guarded([&] {
      --self.depth;
      self.listener.end();
    });
  }
  static void XMLCALL text(void* user, const XML_Char* part, int length) {
    Parser& self = of(user);
    self.guarded([&] { self.listener.text({part, static_cast<std::size_t>(length)}); });
  }
  static void XMLCALL declare(void* user, const XML_Char* prefix, const XML_Char* space) {
    Parser& self = of(user);
    self.guarded([&] {
      self.count_name(space == nullptr ? "" : space);
      self.count_name(prefix == nullptr ? "" : prefix);
      self.listener.declare(prefix == nullptr ? "" : prefix, space == nullptr ? "" : space);
    });
  }
  static void XMLCALL refuse_document_type(void* user, const XML_Char* /*name*/,
                                           const XML_Char* /*system*/, const XML_Char* /*public*/,
                                           int /*has_subset*/) {
    of(user).guarded(
        [] { throw Error(ErrorCode::Syntax, "a document type (DOCTYPE), which is not allowed"); });
  }

  void parse(std::string_view block, bool is_last) {
    const auto size = static_cast<int>(block.size());
    const bool is_read = XML_Parse(xml.get(), block.data(), size, is_last ? 1 : 0) == XML_STATUS_OK;
    if (thrown) std::rethrow_exception(thrown);
    if (!is_read) {
      throw Error(ErrorCode::Syntax, std::string(XML_ErrorString(XML_GetErrorCode(xml.get()))),
                  place());
    }
    fed += size;
    if (fed - static_cast<std::int64_t>(XML_GetCurrentByteIndex(xml.get())) > kMostTagBytes) {
      throw Error(ErrorCode::ResourceLimit, "a tag or a comment of more than 1 MiB", place());
    }
  }

  std::string name;
  XmlListener& listener;
  std::unique_ptr<std::remove_pointer_t<XML_Parser>, ParserFree> xml;
  std::exception_ptr thrown;
  std::unordered_set<std::string, NameHash, std::equal_to<>> names;
  std::size_t depth = 0;
  std::int64_t fed = 0;
};

XmlStream::XmlStream(std::string name, XmlListener& listener)
    : parser_(std::make_unique<Parser>(std::move(name), listener)) {}
XmlStream::~XmlStream() = default;

void XmlStream::feed(std::string_view block) {
  constexpr std::size_t kMost = std::size_t{1} << 16U;
  for (; !block.empty(); block.remove_prefix(std::min(kMost, block.size()))) {
    parser_->parse(block.substr(0, kMost), false);
  }
}

void XmlStream::finish() { parser_->parse({}, true); }

TextPlace XmlStream::place() const { return parser_->place(); }

#else

struct XmlStream::Parser {};

XmlStream::XmlStream(std::string /*name*/, XmlListener& /*listener*/) {}
XmlStream::~XmlStream() = default;
void XmlStream::feed(std::string_view /*block*/) {}
void XmlStream::finish() {}
TextPlace XmlStream::place() const { return {}; }

#endif

}  // namespace plumb
