// Encodes an image as PNG with libpng. The libraries do not depend on libpng, so this header is not
// public, and its source belongs to the program and to the C interface.
#pragma once

#include <string>

#include "plumb/picture/canvas.h"

namespace plumb {

/// Returns the bytes of a PNG file. Throws std::runtime_error with the message of libpng.
std::string encode_png(const Image& image);

}  // namespace plumb
