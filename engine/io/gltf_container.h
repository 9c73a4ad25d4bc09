// What glTF files are made of: a JSON document, and buffers of bytes it names.
//
//   - "glTF" at the beginning: binary, chunks of JSON and of bytes; else the text is the JSON
//   - a buffer is the chunk of bytes, base64 in its name (data:), or a file in the same folder
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "plumb/base/context.h"
#include "plumb/base/error.h"

namespace plumb {

struct GltfContainer {
  std::string_view file;  ///< all bytes
  std::string name;
  bool is_binary = false;
  std::string_view json;
  std::optional<std::string_view> chunk;  ///< of bytes

  /// FILE:LINE:COLUMN in a text, FILE: at byte N in a binary file; `byte` of the JSON.
  [[noreturn]] void fail(std::size_t byte, ErrorCode code, const std::string& what) const;
};

/// `bytes` must outlive it. Errors: UnknownFormat, CountMismatch, Syntax, with the byte.
GltfContainer open_gltf(std::string_view bytes, const std::string& name);

/// The bytes of a file in the folder of the one that is read, charged; `name` has no slashes.
using GltfLoader = std::function<std::string(const std::string& name)>;

/// The bytes that a uri names, charged as many as they are. Throws errors without a place: UnknownFormat, Syntax; CannotOpen for files
/// that are not in the folder, or all if `loader` is empty; what it throws.
std::string bytes_of_uri(std::string_view uri, const GltfLoader& loader, Context& context);

}  // namespace plumb
