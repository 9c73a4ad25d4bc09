// The images of textures, as files that a page or a GLB file embeds unchanged.
//
// An image is never decoded here. Only its type and its size are read, from the first bytes of the
// file, and images beyond a bound are refused, because the program that shows the picture decodes
// them. docs/attributes.md (Pictures) says which pictures show textures.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

#pragma GCC visibility push(default)
namespace plumb {

/// The file of an image.
struct TextureImage {
  static constexpr std::uint32_t kMostPixels = 16384;  ///< The greatest width and height.
  /// The greatest number of bytes of one file.
  static constexpr std::uint64_t kMostBytes = std::uint64_t{64} << 20U;

  std::string type;   ///< "image/png" or "image/jpeg".
  std::string bytes;  ///< The bytes of the file.
};

/// Returns the image whose file has these bytes. Throws Error{BadArgument} with a few words if this
/// is not a file of PNG or JPEG, if its header is damaged, or if it exceeds a bound of
/// TextureImage. O(n) for n bytes.
TextureImage texture_image(std::string bytes);

/// Returns the image that a material of a mesh names, or nothing if it is not to be shown. The
/// arguments are the name of the source (MeshSource::name) and that of the texture
/// (MeshMaterial::texture). The function decides which files may be read.
using TextureLoader =
    std::function<std::optional<TextureImage>(const std::string& source, const std::string& name)>;

}  // namespace plumb
#pragma GCC visibility pop
