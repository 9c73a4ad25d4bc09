// Encodes images with libpng (encode_png.h). Tested by tests/cli/view_command_test.cpp.
#include "plumb/picture/png/encode_png.h"

#include <png.h>

#include <stdexcept>

namespace plumb {

std::string encode_png(const Image& image) {
  png_image header{};
  header.version = PNG_IMAGE_VERSION;
  header.width = image.width;
  header.height = image.height;
  header.format = PNG_FORMAT_RGB;
  png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(header);
  std::string bytes(size, '\0');
  if (png_image_write_to_memory(&header, bytes.data(), &size, 0, image.rgb.data(), 0, nullptr) ==
      0) {
    throw std::runtime_error("libpng: " + std::string(header.message));
  }
  bytes.resize(size);
  return bytes;
}

}  // namespace plumb
