// Images as PNG. Only the program needs a library for it.
#pragma once

#include <string>

#include "plumb/picture/canvas.h"

namespace plumb::cli {

std::string png_bytes(const Image& image);

}  // namespace plumb::cli
