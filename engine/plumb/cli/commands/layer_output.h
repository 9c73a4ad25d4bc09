// The output of commands whose result is a layer: the formats, and what is written to standard
// output in addition.
#pragma once

#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <ostream>
#include <string>
#include <string_view>

#include "plumb/cli/files/outputs.h"
#include "plumb/cli/session/session.h"
#include "plumb/io/layer_io.h"
#include "plumb/io/text/input_cursors.h"
#include "plumb/plane/layer.h"
#include "plumb/predicates/error.h"

namespace plumb::cli {

/// A format of layers, with the function that writes it. If the format keeps the name of a
/// coordinate reference system, `write_crs` is the function that writes the name, too.
struct LayerFormat {
  std::string_view name;
  std::string_view extension;
  void (*write)(std::ostream&, const Layer&, Context&);
  void (*write_crs)(std::ostream&, const Layer&, const std::string&, Context&) = nullptr;
  bool needs_gdal = false;
};

inline constexpr std::array kLayerFormats{
    LayerFormat{"geojson", ".geojson", nullptr, write_layer_geojson},
    LayerFormat{"geojson", ".json", nullptr, write_layer_geojson},
    LayerFormat{"topojson", ".topojson", write_layer_topojson},
    LayerFormat{"wkt", ".wkt", write_layer_wkt},
    LayerFormat{"gpkg", ".gpkg", nullptr, write_layer_gpkg, true},
    LayerFormat{"fgb", ".fgb", nullptr, write_layer_fgb, true},
    LayerFormat{"shp", ".shp", nullptr, nullptr, true},
};

/// Returns the format that -o and --format ask for; null if they ask for no layer. Throws
/// Error{Usage} and Error{UnknownFormat}.
inline const LayerFormat* layer_format(const CommonOptions& common) {
  if (!common.format.empty()) return &format_named(kLayerFormats, common.format);
  if (common.out.empty()) return nullptr;
  if (common.out == "-") throw Error(ErrorCode::Usage, "-o - needs --format geojson");
  return &format_of_file(kLayerFormats, common.out);
}

/// Opens the files of a shapefile. All of them are made when the first one is written.
inline void add_shapefile(Session& session, const std::string& out,
                          const std::function<const Layer&()>& layer, const std::string& crs) {
  if (out == "-") throw Error(ErrorCode::Usage, "a shapefile is several files: -o OUT.shp");
  const std::string stem = out.substr(0, out.size() - (out.ends_with(".shp") ? 4 : 0));
  const auto files = std::make_shared<std::optional<Shapefile>>();
  const auto add = [&](const char* extension, std::string Shapefile::*part) {
    session.outputs().add(stem + extension, [=, &session, &crs](std::ostream& stream) {
      if (!*files) {
        *files = layer_shapefile(layer(), crs, session.context());
        for (const std::string& note : (*files)->notes) session.note(out + ": " + note);
      }
      stream << (**files).*part;
    });
  };
  add(".shp", &Shapefile::shp);
  add(".shx", &Shapefile::shx);
  add(".dbf", &Shapefile::dbf);
  add(".prj", &Shapefile::prj);
  add(".cpg", &Shapefile::cpg);
}

/// Opens the output of a layer before the work. `crs` names the coordinate reference system when
/// the layer is written. Returns whether the layer goes to standard output.
inline bool open_layer_output(Session& session, const std::function<const Layer&()>& layer,
                              const std::string& crs) {
  const CommonOptions& common = session.options();
  const LayerFormat* const format = layer_format(common);
  if (format == nullptr) return false;
  const std::string out = common.out.empty() ? "-" : common.out;
  if (format->needs_gdal && !is_read_by_gdal("x" + std::string(format->extension))) {
    throw Error(ErrorCode::UnknownFormat,
                "plumb is built without GDAL, which writes this format; write GeoJSON, which "
                "ogr2ogr converts",
                {out});
  }
  if (format->name == "shp") {
    add_shapefile(session, out, layer, crs);
    return false;
  }
  session.outputs().add(out, [&session, &crs, layer, format](std::ostream& stream) {
    if (format->write_crs != nullptr) {
      format->write_crs(stream, layer(), crs, session.context());
    } else {
      format->write(stream, layer(), session.context());
    }
  });
  return out == "-";
}

/// Refuses a file that has points or lines and no polygons.
inline void require_polygons(const LayerFile& read, const std::string& file) {
  const std::string lack = lack_of_polygons(read);
  if (!lack.empty()) throw Error(ErrorCode::BadShape, lack, {input_name(file)});
}

/// Adds a note if the coordinate reference system of a layer differs from the system of an earlier
/// layer, or if the format of the output cannot represent it.
inline void note_crs(Session& session, const std::string& file, const std::string& crs,
                     const std::string& earlier) {
  if (crs.empty()) return;
  if (!earlier.empty() && crs != earlier) {
    session.note(input_name(file) + ": the coordinate reference system is " + plumb::quoted(crs) +
                 ", that of the first layer is " + plumb::quoted(earlier) +
                 "; coordinates are not converted");
    return;
  }
  const LayerFormat* const format = layer_format(session.options());
  if (format == nullptr || format->write_crs != nullptr || format->needs_gdal) return;
  session.note(input_name(file) + ": passed over: \"crs\" " + plumb::quoted(crs) +
               " (GeoJSON keeps it, and the formats of GDAL)");
}

/// Reads a layer, and prints the notes of its reader. Sets `crs` to the coordinate reference system
/// of the layer, unless an earlier layer has the same system.
inline Layer read_layer_operand(Session& session, const std::string& file,
                                const LayerReadOptions& options, std::string& crs) {
  session.begin("read");
  LayerFile read = read_layer_file(file, options, session.context());
  require_polygons(read, file);
  for (const std::string& note : read.notes) session.note(input_name(file) + ": " + note);
  note_crs(session, file, read.crs, crs);
  if (crs.empty()) crs = std::move(read.crs);
  return std::move(read.layer);
}

}  // namespace plumb::cli
