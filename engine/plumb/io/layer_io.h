// Reads and writes layers of features (docs/formats.md, "Layers"). Layers are read from GeoJSON,
// TopoJSON, WKT and WKB, and written as GeoJSON, TopoJSON and WKT. If plumb is built with GDAL,
// GeoPackage, FlatGeobuf and other formats are read, too. Reports of checks and repairs are written
// as text, JSON and GeoJSON.
//
// Main flow of read_layer():
//  1. JsonValues     lists the JSON values of the text. If the input is a sequence of JSON texts,
//                    the step lists the values of each text. The texts of a sequence are separated
//                    by the character that RFC 8142 prescribes, or stand on separate lines
//  2. LayerReader    reads the features of a GeoJSON text, or the arcs and geometries of one object
//                    of a TopoJSON text. The texts of ids and properties are kept unchanged
//
// WKT and WKB are read by the readers of plane_io.h.
//
// Coordinates are the nearest doubles. A quantised TopoJSON text lists integers and a transform.
// The reader computes the coordinates of the points from these numbers, in doubles. A point of an
// arc has the same coordinates in all features that use the arc.
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
  /// In a TopoJSON file: the name of the object to be read. In a file that GDAL reads: the name of
  /// the layer. If the name is empty, the first object or layer that has polygons is read.
  std::string object;
};

/// A layer read from a file.
struct LayerFile {
  Layer layer;  ///< The features in the order of the file.
  /// Notes for a human reader. They report contents of the file that are not in `layer`, and
  /// polygons that seem to cross the antimeridian.
  std::vector<std::string> notes;
  /// Whether the file has points or lines, which are left out.
  bool has_points_or_lines = false;
  /// The coordinate reference system that the file names with "crs", or an empty text. It is also
  /// `layer.crs`.
  std::string crs;
};

/// Returns the layer that a GeoJSON, TopoJSON, WKT or WKB text describes. The features of the layer
/// are:
///   - in WKT and WKB: each polygon and each MULTIPOLYGON, without id and properties; members of
///     collections and faces of a TIN are features of their own. An empty geometry is a feature
///   - in GeoJSON: each feature of a FeatureCollection, or the whole text if it is a feature or a
///     geometry. A sequence of texts gives one layer
///   - in TopoJSON: each geometry of the object
/// Points and lines are left out. If a feature consists of points and lines only, the layer
/// contains the feature without polygons. Rings with fewer than three different positions are left
/// out. The memory of the layer stays charged to `context`. Throws Error{BadArgument} if a TopoJSON
/// text lacks the object, and the errors that the head of this file states.
LayerFile read_layer(std::string_view text, const LayerReadOptions& options = {},
                     Context& context = unlimited_context());

/// Returns a sentence for a layer without polygons whose file has points or lines. The sentence
/// states that the file has only points or lines, and names the commands or functions that read
/// such a file. Returns an empty text for all other files.
std::string lack_of_polygons(const LayerFile& file);

/// Whether a text begins like a text in one of the formats of layers: JSON, WKT or WKB.
bool begins_like_layer(std::string_view text);

/// Throws Error{UnknownFormat} if the extension of `path` belongs to a geographic format that plumb
/// cannot read. If plumb is built without GDAL, it cannot read .shp, .gpkg and some other formats.
/// The message names a command that converts the file.
void require_layer_format(const std::string& path);

/// Whether the extension of `path` belongs to a format whose files GDAL reads for plumb, such as
/// .gpkg, and plumb is built with GDAL (PLUMB_WITH_GDAL).
bool is_read_by_gdal(const std::string& path);

/// A file as a text for read_layer().
struct LayerText {
  std::string text;                ///< The contents of the file, or a GeoJSON text.
  std::vector<std::string> notes;  ///< Contents of the file that are not in `text`.
};

/// Returns the contents of the file `path`, or of standard input if `path` is "-". If GDAL reads
/// the format of the file, returns its features as GeoJSON. The memory of the text stays charged to
/// `context`. Throws the errors of require_layer_format(), and the errors that the head of this
/// file states.
LayerText read_layer_text(const std::string& path, const LayerReadOptions& options = {},
                          Context& context = unlimited_context());

/// Reads the file `path`, or standard input if `path` is "-". `options.name` is ignored. Throws the
/// errors of require_layer_format(), and the errors that the head of this file states.
LayerFile read_layer_file(const std::string& path, LayerReadOptions options = {},
                          Context& context = unlimited_context());

/// Writes a layer as a GeoJSON FeatureCollection (RFC 7946), with one feature on each line.
/// Coordinates are the nearest doubles. Features without polygons have the geometry null. If the
/// layer has the name of a coordinate reference system, the file has a member "crs" with this name,
/// as GeoJSON had it before RFC 7946 and as GDAL reads it. Exceptions of `out` reach the caller.
void write_layer_geojson(std::ostream& out, const Layer& layer,
                         Context& context = unlimited_context());

/// Writes a layer like the function above, but with `crs` instead of Layer::crs.
void write_layer_geojson(std::ostream& out, const Layer& layer, const std::string& crs,
                         Context& context = unlimited_context());

/// Writes a layer as TopoJSON. The file has one object, with the name "layer". Borders are written
/// as arcs. A border that several features share is written only once. Coordinates are the nearest
/// doubles, and are not quantised. Exceptions of `out` reach the caller.
void write_layer_topojson(std::ostream& out, const Layer& layer,
                          Context& context = unlimited_context());

/// Writes the polygons of a layer as WKT, with one feature on each line. Ids and properties are not
/// written. Coordinates are the nearest doubles. Exceptions of `out` reach the caller.
void write_layer_wkt(std::ostream& out, const Layer& layer, Context& context = unlimited_context());

/// Writes a layer as a GeoPackage, through GDAL: one table "layer" of multipolygons. Ids that are
/// different integers are the ids of the table; other ids become a column "id". Each property
/// becomes a column. `crs` is LayerFile::crs. Throws Error{BadArgument} if plumb is built without
/// GDAL, and Error{CannotWrite} if GDAL cannot write the file. Exceptions of `out` reach the
/// caller.
void write_layer_gpkg(std::ostream& out, const Layer& layer, const std::string& crs,
                      Context& context = unlimited_context());

/// Writes a layer as FlatGeobuf, through GDAL, as write_layer_gpkg() does. Ids become a column
/// "id". Also throws Error{BadArgument} if a feature has no polygons, because the format cannot
/// store such a feature.
void write_layer_fgb(std::ostream& out, const Layer& layer, const std::string& crs,
                     Context& context = unlimited_context());

/// The files of a shapefile, whose names differ in the extension only.
struct Shapefile {
  std::string shp;  ///< The polygons.
  std::string shx;  ///< The places in `shp` where the features begin.
  std::string dbf;  ///< The properties.
  std::string prj;  ///< The coordinate reference system, or an empty text.
  std::string cpg;  ///< The encoding of the texts, which is UTF-8.
  /// Sentences about contents that the format cannot store. Names of more than 10 bytes are
  /// shortened, texts of more than 254 bytes are cut, and numbers have at most 15 digits behind the
  /// point.
  std::vector<std::string> notes;
};

/// Returns a layer as a shapefile, through GDAL. Ids become a column "id". `crs` is LayerFile::crs.
/// Throws Error{BadArgument} if plumb is built without GDAL, and Error{CannotWrite} if GDAL cannot
/// write the file.
Shapefile layer_shapefile(const Layer& layer, const std::string& crs,
                          Context& context = unlimited_context());

/// Returns the property "name", "NAME" or "Name" of a feature, if it is a text.
std::optional<std::string> feature_name(const Layer& layer, std::uint32_t feature);

/// Returns the title of a feature in reports, such as `feature 3 ("FR", "France")`. The title
/// consists of the number of the feature (counted from 1), its id, and the value of its property
/// "name" or "NAME". An id or a property that the feature lacks is omitted. The title is ASCII
/// text.
std::string feature_title(const Layer& layer, std::uint32_t feature);

/// Returns a place to look at: the point of a crossing, or a corner of another region or of the
/// ring of a nesting. Returns nothing if rounding leaves nothing of the region.
std::optional<Point2> place_of(const LayerReport& report, std::size_t region);

/// Writes the regions of a report, which are overlaps, gaps, holes, crossings and nestings, as a
/// GeoJSON FeatureCollection. Each region is written with its polygons, its area, its width, its
/// features (LayerReport::features) and its owner. A crossing or a nesting is a point. `layer` is
/// the layer that was checked or repaired.
void write_layer_report_geojson(std::ostream& out, const Layer& layer, const LayerReport& report,
                                Context& context = unlimited_context());

/// Writes a report like the function above, but with `crs` instead of Layer::crs.
void write_layer_report_geojson(std::ostream& out, const Layer& layer, const LayerReport& report,
                                const std::string& crs, Context& context = unlimited_context());

/// Writes a report for people: one line for each region, and a summary.
void write_layer_report_text(std::ostream& out, const Layer& layer, const LayerReport& report);

/// Writes a report as one JSON object (docs/schema/map-repair.schema.json).
void write_layer_report_json(std::ostream& out, const Layer& layer, const LayerReport& report);

}  // namespace plumb
#pragma GCC visibility pop
