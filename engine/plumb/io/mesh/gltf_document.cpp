// Access to the JSON document of a glTF file and to its buffers.
//
// Every number of the document is checked when it is read, and each buffer has as many bytes as it
// announces, so that later steps can compare offsets with lengths.
// Tested by tests/io/gltf_test.cpp.
#include "plumb/io/mesh/gltf_document.h"

#include <utility>

namespace plumb {
namespace {

constexpr std::uint64_t kMostCount = std::uint64_t{1} << 53U;

}  // namespace

GltfDocument::GltfDocument(std::string_view bytes, const GltfLoader& loader,
                           const ReadOptions& options, Context& context)
    : container_(open_gltf(bytes, options.name)),
      loader_(loader),
      context_(context),
      charge_(context),
      lenient_(
          container_.json, options.name,
          [this](std::size_t byte, ErrorCode code, const std::string& what) {
            container_.fail(byte, code, what);
          },
          context),
      json_(lenient_.values()),
      bytes_read_(bytes.size()) {
  if (!json_.is_object(kDocument)) container_.fail(0, ErrorCode::Syntax, "expected an object");
  require_version();
}

GltfDocument::~GltfDocument() {
  for (const auto& [index, bytes] : loaded_) context_.release_memory(bytes.size());
}

/// Requires version 2. Without this check, any other JSON, such as GeoJSON, would be an empty
/// document.
void GltfDocument::require_version() const {
  const auto asset = object(kDocument, "asset");
  if (asset && text(*asset, "version").starts_with("2.")) return;
  fail(ErrorCode::UnknownFormat, "asset",
       "does not say version 2 of glTF; version 1 is not read: export the model as glTF 2.0");
}

bool GltfDocument::is_true(Id object, std::string_view member) const {
  const auto found = json_.find(object, member);
  return found && json_.is_true(*found);
}

bool GltfDocument::is_false(Id object, std::string_view member) const {
  const auto found = json_.find(object, member);
  return found && json_.is_false(*found);
}

std::optional<GltfDocument::Id> GltfDocument::object(Id object, std::string_view member) const {
  const auto found = json_.find(object, member);
  return found && json_.is_object(*found) ? found : std::nullopt;
}

std::optional<GltfDocument::Id> GltfDocument::extension(Id object, std::string_view name) const {
  const auto all = this->object(object, "extensions");
  return all ? this->object(*all, name) : std::nullopt;
}

JsonValues::Items GltfDocument::list(Id object, const char* member,
                                     const std::string& where) const {
  const auto found = json_.find(object, member);
  if (!found) return {&json_, 0, 0};
  if (!json_.is_list(*found)) fail(ErrorCode::Syntax, where, std::string(member) + " is no list");
  return json_.items(*found);
}

std::string GltfDocument::text(Id object, const char* member) const {
  const auto found = json_.find(object, member);
  return found && json_.is_text(*found) ? json_.text(*found) : std::string();
}

std::size_t GltfDocument::count(Id object, const char* member, std::optional<std::size_t> otherwise,
                                const std::string& where) const {
  const auto found = json_.find(object, member);
  if (!found) {
    if (!otherwise) fail(ErrorCode::Syntax, where, std::string("needs ") + member);
    return *otherwise;
  }
  const auto count = json_.count(*found);
  if (!count || *count > kMostCount) {
    fail(ErrorCode::Syntax, where, std::string(member) + " is no count");
  }
  return static_cast<std::size_t>(*count);
}

const std::vector<GltfDocument::Id>& GltfDocument::entries(const char* list_name) {
  const auto [at, is_new] = entries_.try_emplace(list_name);
  if (!is_new) return at->second;
  const JsonValues::Items all = list(kDocument, list_name, "the document");
  const std::size_t count = all.size();
  charge_.add(count * sizeof(Id), "the JSON");
  at->second.reserve(count);
  for (const Id each : all) at->second.push_back(each);
  return at->second;
}

GltfDocument::Id GltfDocument::item(const char* list_name, std::size_t index) {
  const std::vector<Id>& all = entries(list_name);
  if (index >= all.size()) fail(ErrorCode::BadIndex, entry(list_name, index), "there is none");
  if (!json_.is_object(all[index])) fail(ErrorCode::Syntax, entry(list_name, index), "no object");
  return all[index];
}

std::string_view GltfDocument::buffer(std::size_t index) {
  const auto known = buffers_.find(index);
  if (known != buffers_.end()) return known->second;
  return buffers_.emplace(index, found_buffer(index)).first->second;
}

bool GltfDocument::can_open_buffer(std::size_t index) {
  const auto [at, is_new] = can_open_.try_emplace(index);
  if (is_new) at->second = finds_buffer(index);
  return at->second;
}

bool GltfDocument::finds_buffer(std::size_t index) {
  const Id object = item("buffers", index);
  if (!has(object, "uri")) {
    for (const char* name : {"EXT_meshopt_compression", "KHR_meshopt_compression"}) {
      const auto stands_for = extension(object, name);
      if (stands_for && is_true(*stands_for, "fallback")) return false;
    }
    return index == 0 && container_.chunk.has_value();
  }
  try {
    buffer(index);
  } catch (const Error& error) {
    if (error.code() == ErrorCode::CannotOpen) return false;
    throw;
  }
  return true;
}

std::string_view GltfDocument::found_buffer(std::size_t index) {
  const Id object = item("buffers", index);
  const std::string where = entry("buffers", index);
  const std::size_t length = count(object, "byteLength", {}, where);
  const auto uri = json_.find(object, "uri");
  std::string_view bytes;
  if (!uri) {
    if (index != 0 || !container_.chunk) fail(ErrorCode::Syntax, where, "no bytes are there");
    bytes = *container_.chunk;
  } else {
    if (!json_.is_text(*uri)) fail(ErrorCode::Syntax, where, "uri is no text");
    bytes = loaded(index, *uri, where);
  }
  if (length > bytes.size()) {
    fail(ErrorCode::CountMismatch, where,
         std::to_string(length) + " bytes are announced, " + std::to_string(bytes.size()) +
             " are there");
  }
  return bytes.substr(0, length);
}

std::string_view GltfDocument::loaded(std::size_t index, Id uri, const std::string& where) {
  return with_where(where, [&]() -> std::string_view {
    const auto plain = json_.plain_text(uri);
    std::string bytes = plain ? bytes_of_uri(*plain, loader_, context_)
                              : bytes_of_uri(json_.text(uri), loader_, context_);
    bytes_read_ += bytes.size();
    return loaded_.emplace(index, std::move(bytes)).first->second;
  });
}

}  // namespace plumb
