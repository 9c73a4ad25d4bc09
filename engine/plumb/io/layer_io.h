// Reads layers of features from GeoJSON, TopoJSON, WKT and WKB, and writes layers as GeoJSON,
// TopoJSON and WKT, and reports of checks and repairs as text, JSON and GeoJSON (docs/formats.md,
// "Layers").
//
// Main flow of read_layer():
//  1. JsonValues     lists the values of the text, or of each text of a sequence (RFC 8142, or one
//                    feature on each line)
//  2. LayerReader    follows the features of a GeoJSON text, or the arcs and geometries of an
//                    object of a TopoJSON text. Ids and properties are kept as they stand.
//
// WKT and WKB are read by the readers of plane_io.h.
//
// Coordinates are the nearest doubles. The coordinates of a quantised TopoJSON text are computed in
// doubles from its transform, so a point of an arc has the same coordinates in all features.
//
// Errors: Syntax, NumberOutOfRange and BadShape name the file, line and column. The other errors
// are CannotOpen, BadArgument, ResourceLimit and Cancelled. Cost: O(bytes).
#pragma once

#include <cstdint>
#include <iosfwd>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "plumb/base/context.h"
#include "plumb/plane/layer.h"

#pragma GCC visibility push(default)
namespace plumb {

/// Options of reading a layer.
struct LayerReadOptions {
  std::string name = "input";  ///< The name of the file in messages.
  std::string object;          ///< The object of a TopoJSON file. If empty, the first one is read.
};

/// A layer read from a file.
struct LayerFile {
  Layer layer;  ///< The features in the order of the file.
  /// Contents of the file that are not in `layer`, and whether polygons seem to cross the
  /// antimeridian.
  std::vector<std::string> notes;
};

/// Returns the layer that a GeoJSON, TopoJSON, WKT or WKB text describes. In WKT and WKB, each
/// polygon is one feature, without id and properties. A FeatureCollection has a feature
/// for each of its features; a geometry is one feature. A sequence of GeoJSON texts is one layer.
/// In TopoJSON each geometry of the object is one feature. Points and lines are left out; a feature
/// that has nothing else stays, without polygons. Rings with fewer than three different positions
/// are left out. The memory of the layer stays charged to `context`. Throws Error{BadArgument} if a
/// TopoJSON text lacks the object, and the errors that the head of this file states.
LayerFile read_layer(std::string_view text, const LayerReadOptions& options = {},
                     Context& context = unlimited_context());

/// Whether a text is a layer: JSON, WKT or WKB, by how it begins.
bool begins_like_layer(std::string_view text);

/// Throws Error{UnknownFormat} with the command that converts the file, if the extension of `path`
/// is that of a format of geographic data which plumb does not read, such as .shp and .gpkg.
void require_layer_format(const std::string& path);

/// Reads the file `path`, or standard input if `path` is "-". `options.name` is ignored. Throws the
/// errors of require_layer_format(), and those that the head of this file states.
LayerFile read_layer_file(const std::string& path, LayerReadOptions options = {},
                          Context& context = unlimited_context());

/// Writes a layer as a FeatureCollection (RFC 7946), one feature a line. Coordinates are the
/// nearest doubles. Features without polygons have the geometry null. Exceptions of `out` reach the
/// caller.
void write_layer_geojson(std::ostream& out, const Layer& layer,
                         Context& context = unlimited_context());

/// Writes a layer as TopoJSON, with one object "layer". Borders that features share are arcs, which
/// are written once. Coordinates are the nearest doubles, and are not quantised. Exceptions of
/// `out` reach the caller.
void write_layer_topojson(std::ostream& out, const Layer& layer,
                          Context& context = unlimited_context());

/// Writes the polygons of a layer as WKT, one feature a line, without ids and properties.
/// Coordinates are the nearest doubles. Exceptions of `out` reach the caller.
void write_layer_wkt(std::ostream& out, const Layer& layer, Context& context = unlimited_context());

/// Returns the property "name", "NAME" or "Name" of a feature, if it is a text.
std::optional<std::string> feature_name(const Layer& layer, std::uint32_t feature);

/// Returns what a feature is called in reports, such as `feature 3 ("FR", "France")`: its number
/// from 1, its id, and its property "name" or "NAME", if it has them; in ASCII.
std::string feature_title(const Layer& layer, std::uint32_t feature);

/// Writes the regions of a report as a FeatureCollection: overlaps, gaps and holes with their
/// polygons, areas, widths, features and owners. `layer` is the layer that was repaired.
void write_layer_report_geojson(std::ostream& out, const Layer& layer, const LayerReport& report,
                                Context& context = unlimited_context());

/// Writes a report for people: one line for each region, and a summary.
void write_layer_report_text(std::ostream& out, const Layer& layer, const LayerReport& report);

/// Writes a report as one JSON object (docs/schema/map-repair.schema.json).
void write_layer_report_json(std::ostream& out, const Layer& layer, const LayerReport& report);

}  // namespace plumb
#pragma GCC visibility pop
