// Layers in formats that GDAL reads and writes (docs/formats.md, "Layers"), if plumb is built with
// it (PLUMB_WITH_GDAL). A layer is read as a GeoJSON text, which read_layer() and the reader of
// plane sets take, so that every rule of GeoJSON holds for it.
//
// Main flow of read_gdal_layer():
//  1. open      opens the file with the only driver that belongs to the extension. Few other
//               drivers are registered, and none of them opens network addresses or files elsewhere
//  2. features  geometries go through WKB and the reader of plumb (wkb.h); fields become properties
//
// Errors: CannotOpen, UnknownFormat, Syntax, BadArgument, CannotWrite, ResourceLimit, Cancelled.
#pragma once

#include <ostream>
#include <string>
#include <vector>

#include "plumb/base/context.h"
#include "plumb/io/layer_io.h"
#include "plumb/plane/layer.h"

namespace plumb {

/// Whether the extension of a path belongs to a format of which GDAL reads the files for plumb.
bool is_gdal_format(const std::string& path);

/// Whether plumb is built with GDAL.
bool has_gdal();

/// Returns the features of a layer of the file as a GeoJSON text, with the coordinate reference
/// system as "crs". `object` is the name of the layer; if it is empty, the first layer that may
/// have polygons is read. Appends sentences about contents that were not read to `notes`. The
/// memory of the text stays charged to `context`. Requires is_gdal_format(path) and has_gdal().
std::string read_gdal_layer(const std::string& path, const std::string& object,
                            std::vector<std::string>& notes, Context& context);

/// Writes a layer as the bytes of a file of a driver of GDAL, "GPKG" or "FlatGeobuf". Integers that
/// are all different become the ids of GeoPackage; other ids become a field "id". `crs` is a name
/// "urn:ogc:def:crs:EPSG::CODE" or a WKT of a coordinate reference system, or empty. Throws
/// Error{BadArgument} if plumb is not built with GDAL.
void write_gdal_layer(std::ostream& out, const Layer& layer, const std::string& crs,
                      const char* driver, Context& context);

/// Returns a layer as the files of a shapefile. Throws as write_gdal_layer() does.
Shapefile gdal_shapefile(const Layer& layer, const std::string& crs, Context& context);

}  // namespace plumb
