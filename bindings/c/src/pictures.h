// Pictures as the bytes of a file: "html", "svg", "glb" or "png".
#pragma once

#include <span>
#include <string>

#include "plumb/base/context.h"
#include "plumb/plane/map_check.h"
#include "plumb/plane/nef2.h"
#include "plumb/space/nef3.h"
#include "plumb/surface/surface.h"

namespace plumb::c {

/// Throws Error{UnknownFormat} for any other format, before the work.
std::string picture_of(const Nef3& set, const std::string& format, const std::string& title,
                       Context& context);
std::string picture_of(std::span<const Nef3> sets, double apart, const std::string& format,
                       const std::string& title, Context& context);
std::string picture_of(const Nef2& set, const std::string& format, const std::string& title,
                       Context& context);
std::string picture_of(const MapReport& report, const std::string& format,
                       const std::string& title);
/// `layer` is a name of kSurfaceLayerNames. Throws Error{BadArgument} for any other, and for
/// "result" without a result.
std::string picture_of(const SurfaceDivision& division, const SurfaceResult* result,
                       const std::string& layer, const std::string& format,
                       const std::string& title, Context& context);

}  // namespace plumb::c
