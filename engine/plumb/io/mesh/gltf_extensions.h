// Extensions of glTF by what they do to the shape, and what a reader says of those that it does not
// read.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "plumb/io/mesh/gltf_document.h"

namespace plumb {

/// What an extension changes.
enum class GltfEffect : std::uint8_t {
  None,   ///< Only how things look, sound, move or are called.
  Read,   ///< The shape, and the reader follows it.
  Shape,  ///< The shape, and the reader does not follow it.
  Unknown,
};

/// Returns the effect of an extension.
GltfEffect effect_of_extension(std::string_view name);

/// What a reader says of the extensions that a document uses and that it does not read.
struct GltfExtensions {
  std::vector<std::string> notes;     ///< Those that it does not know.
  std::vector<std::string> warnings;  ///< Those that change the shape.
};

/// Throws Error{UnknownFormat} if the document requires an extension that may change the shape and
/// is not read. Returns sentences that name those that the document only uses.
GltfExtensions check_extensions(const GltfDocument& document, Context& context);

}  // namespace plumb
