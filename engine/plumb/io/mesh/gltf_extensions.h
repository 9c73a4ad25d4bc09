// The extensions of glTF: how they change the shape, and the messages about extensions that the
// reader does not read.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "plumb/io/mesh/gltf_document.h"

namespace plumb {

/// The parts of a file that an extension changes.
enum class GltfEffect : std::uint8_t {
  None,   ///< Only how things look, sound, move or are called.
  Read,   ///< The shape, and the reader follows it.
  Shape,  ///< The shape, and the reader does not follow it.
  Unknown,
};

/// Returns the effect of an extension.
GltfEffect effect_of_extension(std::string_view name);

/// Messages about extensions that a document uses, but that the reader does not read.
struct GltfExtensions {
  std::vector<std::string> notes;     ///< Sentences about unknown extensions.
  std::vector<std::string> warnings;  ///< Sentences about extensions that change the shape.
};

/// Throws Error{UnknownFormat} if the document requires an extension that may change the shape and
/// is not read. Returns sentences that name the extensions that the document uses but does not
/// require.
GltfExtensions check_extensions(const GltfDocument& document, Context& context);

}  // namespace plumb
