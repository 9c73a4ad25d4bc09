// The images of textures, as files that a page or a GLB file embeds unchanged.
//
// plumb does not decode images. It reads only the type and the size of an image, from the first
// bytes of its file. The program that shows the picture decodes the image, so images that are too
// large are refused. docs/attributes.md (Pictures) says which pictures show textures.
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

/// Returns the image whose file has these bytes. Throws Error{BadArgument} if the file is neither
/// PNG nor JPEG, if its header is damaged, or if the image exceeds a bound of TextureImage. O(n)
/// for n bytes.
TextureImage texture_image(std::string bytes);

/// A function that returns the image of a texture, or nullopt if the texture should not be shown.
/// The arguments are the name of the source (MeshSource::name) and the name of the texture
/// (MeshMaterial::texture). The function decides which files may be read.
using TextureLoader =
    std::function<std::optional<TextureImage>(const std::string& source, const std::string& name)>;

}  // namespace plumb
#pragma GCC visibility pop
