// How callers of the C interface name pictures.
#pragma once

#include <string>

#include "plumb/picture/pictures.h"
#include "plumb/picture/surface_scene.h"

namespace plumb::c {

/// Returns how a picture is made. `format` is "html", "svg", "glb" or "png". Throws
/// Error{UnknownFormat} for any other.
PictureOptions picture(const std::string& format, std::string title);
/// Returns the layer of a surface of a name of kSurfaceLayerNames. Throws Error{BadArgument} for
/// any other, and for "result" if there is none.
SurfaceLayer surface_layer(const std::string& name, bool has_result);

}  // namespace plumb::c
