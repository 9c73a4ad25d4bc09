// Heights from an image in PNG, as OpenSCAD's surface() takes them.
#pragma once

#include <string>
#include <string_view>

#include "plumb/base/context.h"
#include "plumb/io/csg/surface_file.h"

namespace plumb {

/// Whether a file begins with the signature of PNG.
bool is_png(std::string_view bytes);

/// Returns a height for each pixel: 100 for white and 0 for black, the last row of the image first.
/// The opacity has no effect. If `is_inverted` is true, pixel values v from 0 to 255 become 1 - v,
/// as in OpenSCAD. Errors: BadShape for a file that is no image or ends early; ResourceLimit for
/// more than kMostHeights pixels, or for more than fit in memory as a solid; UnknownFormat if the
/// program was built without libpng. All name the file.
HeightGrid read_height_image(std::string_view bytes, const std::string& name, bool is_inverted,
                             MemoryCharge& charge, Context& context);

}  // namespace plumb
