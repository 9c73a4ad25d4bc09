// The output of commands whose result is a layer: the formats, and what goes to standard output
// besides.
#pragma once

#include <array>
#include <functional>
#include <ostream>
#include <string>
#include <string_view>

#include "plumb/cli/files/outputs.h"
#include "plumb/cli/session/session.h"
#include "plumb/io/layer_io.h"
#include "plumb/plane/layer.h"

namespace plumb::cli {

/// A format of layers.
struct LayerFormat {
  std::string_view name;
  std::string_view extension;
  void (*write)(std::ostream&, const Layer&, Context&);
};

inline constexpr std::array kLayerFormats{
    LayerFormat{"geojson", ".geojson", write_layer_geojson},
    LayerFormat{"geojson", ".json", write_layer_geojson},
    LayerFormat{"topojson", ".topojson", write_layer_topojson},
    LayerFormat{"wkt", ".wkt", write_layer_wkt},
};

/// Returns the format that -o and --format ask for; null if they ask for no layer. Throws
/// Error{Usage} and Error{UnknownFormat}.
inline const LayerFormat* layer_format(const CommonOptions& common) {
  if (!common.format.empty()) return &format_named(kLayerFormats, common.format);
  if (common.out.empty()) return nullptr;
  if (common.out == "-") throw Error(ErrorCode::Usage, "-o - needs --format geojson");
  return &format_of_file(kLayerFormats, common.out);
}

/// Opens the output of a layer before the work. Returns whether the layer goes to standard output.
inline bool open_layer_output(Session& session, const std::function<const Layer&()>& layer) {
  const CommonOptions& common = session.options();
  const LayerFormat* const format = layer_format(common);
  if (format == nullptr) return false;
  const std::string out = common.out.empty() ? "-" : common.out;
  session.outputs().add(out, [&session, layer, format](std::ostream& stream) {
    format->write(stream, layer(), session.context());
  });
  return out == "-";
}

/// Reads a layer, and prints the notes of its reader.
inline Layer read_layer_operand(Session& session, const std::string& file,
                                const LayerReadOptions& options) {
  session.begin("read");
  LayerFile read = read_layer_file(file, options, session.context());
  for (const std::string& note : read.notes) session.note(input_name(file) + ": " + note);
  return std::move(read.layer);
}

}  // namespace plumb::cli
