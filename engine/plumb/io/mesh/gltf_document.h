// The JSON document of a glTF file, read on demand: members, lists of entries, and buffers.
//
// GltfDocument is a lazy view. Lists of entries and buffers are found on first use, kept, and
// charged to the context. A member that is missing, has the wrong type or names an entry that does
// not exist is an error that names its object: "FILE: accessors[3]: what".
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "plumb/base/context.h"
#include "plumb/io/mesh/gltf_parts.h"
#include "plumb/io/read_options.h"
#include "plumb/io/text/json_reader.h"
#include "plumb/io/text/lenient_json.h"
#include "plumb/predicates/error.h"

namespace plumb {

class GltfDocument {
 public:
  using Id = JsonValues::Id;
  static constexpr Id kDocument = JsonValues::kDocument;

  /// Keeps the bytes, the loader and the context, which must outlive it. Throws the errors of
  /// open_gltf() and JsonValues, and Error{UnknownFormat} if the document does not say version 2.
  GltfDocument(std::string_view bytes, const GltfLoader& loader, const ReadOptions& options,
               Context& context);
  /// Releases the memory of buffers.
  ~GltfDocument();
  GltfDocument(const GltfDocument&) = delete;
  GltfDocument& operator=(const GltfDocument&) = delete;

  const JsonValues& json() const { return json_; }
  /// Returns the parts of the document that are not JSON.
  JsonReplaced replaced() const { return lenient_.replaced(); }

  [[noreturn]] void fail(ErrorCode code, const std::string& where, const std::string& what) const {
    throw Error(code, where + ": " + what, {container_.name});
  }
  /// Returns `read()`. An error without a place gets the file and `where`.
  template <class Read>
  auto with_where(const std::string& where, Read read) const {
    try {
      return read();
    } catch (const Error& error) {
      if (!error.place().file.empty() || error.code() == ErrorCode::ResourceLimit ||
          error.code() == ErrorCode::Cancelled) {
        throw;
      }
      fail(error.code(), where, error.message());
    }
  }

  /// Returns "nodes[3]".
  static std::string entry(const char* list, std::size_t index) {
    return std::string(list) + '[' + std::to_string(index) + ']';
  }

  /// Whether the object has the member.
  bool has(Id object, std::string_view member) const {
    return json_.find(object, member).has_value();
  }
  /// Whether the object has the member, and it is true (or false, for is_false()).
  bool is_true(Id object, std::string_view member) const;
  bool is_false(Id object, std::string_view member) const;

  /// Returns a member that is an object; no value if it is missing or anything else.
  std::optional<Id> object(Id object, std::string_view member) const;
  /// Returns an extension of an object.
  std::optional<Id> extension(Id object, std::string_view name) const;
  /// Returns the list that a member is; an empty one if it is missing.
  JsonValues::Items list(Id object, const char* member, const std::string& where) const;
  /// Returns the text that a member is; an empty one if it is missing or anything else.
  std::string text(Id object, const char* member) const;
  /// Returns a member that is a whole number and fits a size. A missing member counts as
  /// `otherwise`; if there is none, that is an error.
  std::size_t count(Id object, const char* member, std::optional<std::size_t> otherwise,
                    const std::string& where) const;
  /// Returns as many numbers as `otherwise` has, or `otherwise` if the member is missing.
  template <std::size_t N>
  std::array<double, N> numbers(Id object, const char* member, std::array<double, N> otherwise,
                                const std::string& where) const;

  /// Returns the entries of a list of the document, for access by number.
  const std::vector<Id>& entries(const char* list_name);
  /// Returns an entry of a list of the document. Throws unless it is an object.
  Id item(const char* list_name, std::size_t index);

  /// Returns as many bytes as the buffer says. Files are read on first use.
  std::string_view buffer(std::size_t index);
  /// Whether buffer() can return bytes: false if the buffer only stands for bytes that are
  /// compressed elsewhere, and if its file cannot be opened.
  bool can_open_buffer(std::size_t index);
  /// Returns how many bytes the file has, with the buffers that were read so far.
  std::size_t bytes_read() const { return bytes_read_; }

 private:
  void require_version() const;
  bool finds_buffer(std::size_t index);
  std::string_view found_buffer(std::size_t index);
  std::string_view loaded(std::size_t index, Id uri, const std::string& where);

  GltfContainer container_;
  const GltfLoader& loader_;
  Context& context_;
  MemoryCharge charge_;  // Of lists of entries.
  LenientJson lenient_;
  const JsonValues& json_;  // Of lenient_.
  std::size_t bytes_read_;
  std::map<std::string_view, std::vector<Id>> entries_;  // Per list that was used.
  std::map<std::size_t, std::string> loaded_;            // Buffers that are no chunk.
  std::map<std::size_t, std::string_view> buffers_;
  std::map<std::size_t, bool> can_open_;
};

template <std::size_t N>
std::array<double, N> GltfDocument::numbers(Id object, const char* member,
                                            std::array<double, N> otherwise,
                                            const std::string& where) const {
  if (!has(object, member)) return otherwise;
  const JsonValues::Items all = list(object, member, where);
  if (all.size() != N) {
    fail(ErrorCode::CountMismatch, where,
         std::string(member) + " has not " + std::to_string(N) + " numbers");
  }
  std::size_t i = 0;
  for (const Id each : all) {
    if (!json_.is_number(each)) fail(ErrorCode::Syntax, where, std::string(member) + ": no number");
    otherwise[i++] = json_.number(each);
  }
  return otherwise;
}

}  // namespace plumb
