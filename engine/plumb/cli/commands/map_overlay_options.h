// The overlay of two layers, as a part of the command `plumb map overlay`.
#pragma once

#include <string>

#include "plumb/cli/session/session.h"

namespace plumb::cli {

/// The options of the overlay of layers.
struct LayerOverlayWords {
  std::string keep;                         ///< all, first, both or first-only; empty means all.
  bool with_areas = false;                  ///< Whether pairs get their areas.
  std::string first_object, second_object;  ///< The objects of TopoJSON files to read.
};

/// Whether a file is a layer, by its extension or, if that is unknown, by its first bytes. Standard
/// input is none. Throws Error{UnknownFormat} for a format that needs GDAL.
bool is_layer_file(const std::string& path);

/// Reads two layers, and writes their overlay.
ExitCode overlay_layer_files(Session& session, const std::string& first, const std::string& second,
                             const LayerOverlayWords& words);

}  // namespace plumb::cli
