// Pictures of results as the bytes of a file.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "plumb/base/context.h"
#include "plumb/picture/surface_scene.h"
#include "plumb/plane/map_check.h"
#include "plumb/plane/nef2.h"
#include "plumb/space/nef3.h"
#include "plumb/surface/surface.h"

namespace plumb::cli {

enum class Picture : std::uint8_t { Png, Svg, Html, Glb };

std::string picture_of(const Nef3& set, Picture picture, const std::string& title,
                       Context& context);
/// Several sets, each in a colour of its own, moved apart (pieces_scene.h).
std::string picture_of(std::span<const Nef3> sets, double apart, Picture picture,
                       const std::string& title, Context& context);
/// `shown` is what an image shows; a page has all layers, to be turned on and off.
std::string picture_of(const SurfaceDivision& division, const SurfaceResult* result,
                       SurfaceLayer shown, Picture picture, const std::string& title,
                       Context& context);
std::string picture_of(const Nef2& set, Picture picture, const std::string& title);
std::string picture_of(const MapReport& report, Picture picture, const std::string& title);

}  // namespace plumb::cli
