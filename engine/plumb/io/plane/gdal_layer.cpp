// Layers through GDAL, by its C interface.
//
// GDAL is a large library that reads untrusted files with its own code, so its use is restricted.
// Only the drivers below are registered, plugins are not loaded, the path must name an ordinary
// file or folder, and is made absolute (so it cannot begin like "GPKG:" or "/vsi"), and none of
// these drivers follows names in a file to places outside of its folder. Geometries leave GDAL as
// WKB, whose reader checks them.
//
// A layer is written to a file in memory (/vsimem/), whose bytes are then copied to the output. So
// an output is complete or absent, as for all other formats. All times in the file are fixed, so
// equal layers give equal bytes.
//
// Without PLUMB_WITH_GDAL this file has only the messages of its errors.
// Tested by tests/io/gdal_layer_test.cpp.
#include "plumb/io/plane/gdal_layer.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <string_view>

#include "plumb/io/text/file_names.h"
#include "plumb/predicates/error.h"

#ifdef PLUMB_WITH_GDAL
#include <gdal.h>
#include <ogr_api.h>
#include <ogr_srs_api.h>
#include <ogrsf_frmts.h>

#include <atomic>
#include <bit>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <map>
#include <memory>
#include <mutex>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <sstream>
#include <utility>

#include "plumb/io/plane/geojson.h"
#include "plumb/io/plane/wkb.h"
#include "plumb/io/text/input_cursors.h"
#endif

namespace plumb {
namespace {

struct GdalFormat {
  std::string_view extension;
  const char* driver;
};

constexpr std::array kGdalFormats{
    GdalFormat{".gpkg", "GPKG"},
    GdalFormat{".fgb", "FlatGeobuf"},
    GdalFormat{".shp", "ESRI Shapefile"},
    GdalFormat{".gdb", "OpenFileGDB"},
    GdalFormat{".kml", "KML"},
    GdalFormat{".mif", "MapInfo File"},
};

const GdalFormat* gdal_format(const std::string& path) {
  const std::string extension = std::filesystem::path(path).extension().string();
  const auto* const found =
      std::find_if(kGdalFormats.begin(), kGdalFormats.end(),
                   [&](const GdalFormat& format) { return format.extension == extension; });
  return found == kGdalFormats.end() ? nullptr : &*found;
}

}  // namespace

bool is_gdal_format(const std::string& path) { return gdal_format(path) != nullptr; }

#ifndef PLUMB_WITH_GDAL

bool has_gdal() { return false; }

std::string read_gdal_layer(const std::string& path, const std::string& /*object*/,
                            std::vector<std::string>& /*notes*/, Context& /*context*/) {
  throw Error(ErrorCode::UnknownFormat, "plumb is built without GDAL", {path});
}

void write_gdal_layer(std::ostream& /*out*/, const Layer& /*layer*/, const std::string& /*crs*/,
                      const char* driver, Context& /*context*/) {
  throw Error(ErrorCode::BadArgument,
              std::string(driver) +
                  " is written by GDAL, and plumb is built without it; write "
                  "GeoJSON, which ogr2ogr converts");
}

Shapefile gdal_shapefile(const Layer& layer, const std::string& crs, Context& context) {
  std::ostream nowhere(nullptr);
  write_gdal_layer(nowhere, layer, crs, "A shapefile", context);
  return {};
}

#else

bool has_gdal() { return true; }

namespace {

using Json = nlohmann::ordered_json;

void register_drivers() {
  static std::once_flag once;
  std::call_once(once, [] {
    CPLSetConfigOption("GDAL_DRIVER_PATH", "disable");
    RegisterOGRShape();
    RegisterOGRGeoPackage();
    RegisterOGRFlatGeobuf();
    RegisterOGROpenFileGDB();
    RegisterOGRKML();
    RegisterOGRTAB();
  });
}

/// While an object of this class exists, it collects the first error of GDAL, so that GDAL prints
/// no messages.
class GdalMessages {
 public:
  GdalMessages() { CPLPushErrorHandlerEx(&GdalMessages::take, this); }
  ~GdalMessages() { CPLPopErrorHandler(); }
  GdalMessages(const GdalMessages&) = delete;
  GdalMessages& operator=(const GdalMessages&) = delete;

  bool has_failed() const { return has_failed_; }
  /// Throws the error that GDAL reported.
  [[noreturn]] void fail(ErrorCode code, const std::string& what, const std::string& file) const {
    throw Error(code, what + (text_.empty() ? "" : ": " + plumb::quoted(text_)), {file});
  }

 private:
  static void CPL_STDCALL take(CPLErr kind, CPLErrorNum /*number*/, const char* text) {
    auto* const self = static_cast<GdalMessages*>(CPLGetErrorHandlerUserData());
    if (kind < CE_Failure || self->has_failed_) return;
    self->has_failed_ = true;
    self->text_ = text;
  }

  bool has_failed_ = false;
  std::string text_;
};

struct CloseDataset {
  void operator()(void* set) const { GDALClose(set); }
};
using Dataset = std::unique_ptr<void, CloseDataset>;

struct DestroyFeature {
  void operator()(OGRFeatureH feature) const { OGR_F_Destroy(feature); }
};
using Feature = std::unique_ptr<std::remove_pointer_t<OGRFeatureH>, DestroyFeature>;

// ---------------------------------------------------------------- reading

/// Returns the absolute path of a file or folder that exists.
std::string local_path(const std::string& path) {
  std::error_code error;
  const std::filesystem::path whole =
      std::filesystem::absolute(path_of(path), error).lexically_normal();
  if (!error && !std::filesystem::exists(whole, error) && !error) {
    error = std::make_error_code(std::errc::no_such_file_or_directory);
  }
  if (error) throw Error(ErrorCode::CannotOpen, error.message(), {path});
  std::string name = file_name_of(whole);
  if (name.starts_with("/vsi")) {
    throw Error(ErrorCode::CannotOpen, "paths that begin with /vsi are not opened", {path});
  }
  return name;
}

Dataset opened(const std::string& path, const GdalMessages& messages) {
  const std::array<const char*, 2> drivers{gdal_format(path)->driver, nullptr};
  Dataset set(GDALOpenEx(local_path(path).c_str(), GDAL_OF_VECTOR | GDAL_OF_READONLY,
                         drivers.data(), nullptr, nullptr));
  if (!set) messages.fail(ErrorCode::Syntax, "GDAL cannot read this file", path);
  return set;
}

/// Whether the type of a layer states that the layer has only points or lines, or no geometries.
bool lacks_polygons(OGRLayerH layer) {
  const OGRwkbGeometryType type = wkbFlatten(OGR_L_GetGeomType(layer));
  return type == wkbNone || type == wkbPoint || type == wkbMultiPoint || type == wkbLineString ||
         type == wkbMultiLineString || type == wkbCircularString || type == wkbCompoundCurve ||
         type == wkbMultiCurve;
}

/// Returns the layer of that name. Without a name, returns the first layer that may have polygons,
/// or the first layer.
OGRLayerH chosen_layer(const Dataset& set, const std::string& path, const std::string& object,
                       std::vector<std::string>& notes) {
  std::vector<OGRLayerH> layers;
  for (int i = 0; i < GDALDatasetGetLayerCount(set.get()); ++i) {
    layers.push_back(GDALDatasetGetLayer(set.get(), i));
  }
  const auto is_wanted = [&](OGRLayerH layer) {
    return object.empty() ? !lacks_polygons(layer) : OGR_L_GetName(layer) == object;
  };
  auto found = std::find_if(layers.begin(), layers.end(), is_wanted);
  if (found == layers.end() && object.empty()) found = layers.begin();
  OGRLayerH const chosen = found == layers.end() ? nullptr : *found;
  std::string others;
  for (OGRLayerH const layer : layers) {
    if (layer == chosen) continue;
    others += (others.empty() ? "" : ", ") + plumb::quoted(OGR_L_GetName(layer));
  }
  if (chosen == nullptr) {
    const std::string what =
        others.empty() ? "the file has no layer"
                       : "there is no layer " + plumb::quoted(object) + "; the file has " + others;
    throw Error(ErrorCode::BadArgument, what, {path});
  }
  if (object.empty() && !others.empty()) {
    notes.push_back("passed over: layers " + others +
                    " (--object NAME of plumb map reads another one)");
  }
  return chosen;
}

Json list_of_field(OGRFeatureH feature, int i, OGRFieldType type) {
  Json list = Json::array();
  int count = 0;
  if (type == OFTIntegerList) {
    const int* const values = OGR_F_GetFieldAsIntegerList(feature, i, &count);
    for (int k = 0; k < count; ++k) list.push_back(values[k]);
  } else if (type == OFTInteger64List) {
    const GIntBig* const values = OGR_F_GetFieldAsInteger64List(feature, i, &count);
    for (int k = 0; k < count; ++k) list.push_back(std::int64_t{values[k]});
  } else if (type == OFTRealList) {
    const double* const values = OGR_F_GetFieldAsDoubleList(feature, i, &count);
    for (int k = 0; k < count; ++k) list.push_back(values[k]);
  } else {
    char** const values = OGR_F_GetFieldAsStringList(feature, i);
    for (char** value = values; value != nullptr && *value != nullptr; ++value) {
      list.push_back(std::string(*value));
    }
  }
  return list;
}

/// Returns the value of a field. Dates become texts, and bytes become hexadecimal digits.
Json value_of_field(OGRFeatureH feature, int i) {
  if (OGR_F_IsFieldNull(feature, i) != 0) return nullptr;
  OGRFieldDefnH const field = OGR_F_GetFieldDefnRef(feature, i);
  const OGRFieldType type = OGR_Fld_GetType(field);
  switch (type) {
    case OFTInteger:
      if (OGR_Fld_GetSubType(field) == OFSTBoolean) {
        return OGR_F_GetFieldAsInteger(feature, i) != 0;
      }
      return OGR_F_GetFieldAsInteger(feature, i);
    case OFTInteger64:
      return std::int64_t{OGR_F_GetFieldAsInteger64(feature, i)};
    case OFTReal:
      return OGR_F_GetFieldAsDouble(feature, i);  // NaN and infinity are written as null.
    case OFTIntegerList:
    case OFTInteger64List:
    case OFTRealList:
    case OFTStringList:
      return list_of_field(feature, i, type);
    default:
      return std::string(OGR_F_GetFieldAsString(feature, i));
  }
}

Json properties_of(OGRFeatureH feature) {
  Json properties = Json::object();
  for (int i = 0; i < OGR_F_GetFieldCount(feature); ++i) {
    if (OGR_F_IsFieldSet(feature, i) == 0) continue;
    properties[OGR_Fld_GetNameRef(OGR_F_GetFieldDefnRef(feature, i))] = value_of_field(feature, i);
  }
  return properties;
}

std::string wkb_of(OGRGeometryH geometry) {
  std::string bytes(OGR_G_WkbSizeEx(geometry), '\0');
  // GDAL returns bytes through a pointer to unsigned bytes.
  auto* const begin = reinterpret_cast<unsigned char*>(bytes.data());
  if (OGR_G_ExportToIsoWkb(geometry, wkbNDR, begin) != OGRERR_NONE) bytes.clear();
  return bytes;
}

/// Returns the name of a coordinate reference system: the code of its authority, or WKT.
std::string crs_name(OGRSpatialReferenceH crs) {
  const char* const authority = OSRGetAuthorityName(crs, nullptr);
  const char* const code = OSRGetAuthorityCode(crs, nullptr);
  if (authority != nullptr && code != nullptr) {
    return "urn:ogc:def:crs:" + std::string(authority) + "::" + code;
  }
  char* text = nullptr;
  const std::array<const char*, 2> options{"FORMAT=WKT2_2019", nullptr};
  std::string wkt;
  if (OSRExportToWktEx(crs, &text, options.data()) == OGRERR_NONE && text != nullptr) wkt = text;
  CPLFree(text);
  return wkt;
}

std::string dumped(const Json& json) {
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

/// Writes the features of a layer of GDAL as GeoJSON.
class GeoJsonOfLayer {
 public:
  GeoJsonOfLayer(OGRLayerH layer, const std::string& path, Context& context)
      : layer_(layer), path_(path), context_(context) {}

  std::string text(const GdalMessages& messages) {
    text_ = R"({"type":"FeatureCollection",)";
    if (OGRSpatialReferenceH const crs = OGR_L_GetSpatialRef(layer_); crs != nullptr) {
      const Json name = {{"type", "name"}, {"properties", {{"name", crs_name(crs)}}}};
      text_ += "\"crs\":" + dumped(name) + ',';
    }
    text_ += "\"features\":[";
    OGR_L_ResetReading(layer_);
    while (const Feature feature{OGR_L_GetNextFeature(layer_)}) add(feature.get());
    if (messages.has_failed()) messages.fail(ErrorCode::Syntax, "GDAL cannot read on", path_);
    text_ += "\n]}\n";
    return std::move(text_);
  }

  const std::set<std::string>& notes() const { return notes_; }

 private:
  void add(OGRFeatureH feature) {
    const std::size_t before = text_.size();
    text_ += count_++ == 0 ? "\n" : ",\n";
    text_ += R"({"type":"Feature",)";
    const char* const id_column = OGR_L_GetFIDColumn(layer_);
    if (id_column != nullptr && *id_column != '\0') {
      text_ += "\"id\":" + std::to_string(OGR_F_GetFID(feature)) + ',';
    }
    text_ += "\"properties\":" + dumped(properties_of(feature)) + ",\"geometry\":";
    add_geometry(OGR_F_GetGeometryRef(feature));
    text_ += '}';
    context_.charge_memory(text_.size() - before, "the text of the layer");
    if (count_ % 64 == 0) context_.checkpoint("read", count_, 0);
  }

  void add_geometry(OGRGeometryH geometry) {
    if (geometry == nullptr || OGR_G_IsEmpty(geometry) != 0) {
      text_ += "null";
      return;
    }
    constexpr std::uint64_t kCopies = 8;  // The memory of WKB, shapes and text.
    MemoryCharge memory(context_);
    memory.add(kCopies * OGR_G_WkbSizeEx(geometry), "a feature of the layer");
    const std::string name = path_ + ", feature " + std::to_string(count_);
    Context unlimited;
    const PlaneFile file = read_wkb(wkb_of(geometry), {.name = name}, unlimited);
    notes_.insert(file.notes.begin(), file.notes.end());
    std::ostringstream out;
    write_geojson(out, file.shapes, unlimited);
    text_ += out.str();
  }

  OGRLayerH layer_;
  const std::string& path_;
  Context& context_;
  std::size_t count_ = 0;
  std::string text_;
  std::set<std::string> notes_;
};

}  // namespace

std::string read_gdal_layer(const std::string& path, const std::string& object,
                            std::vector<std::string>& notes, Context& context) {
  register_drivers();
  const GdalMessages messages;
  context.checkpoint("read", 0, 0);
  const Dataset set = opened(path, messages);
  GeoJsonOfLayer reader(chosen_layer(set, path, object, notes), path, context);
  std::string text = reader.text(messages);
  notes.insert(notes.end(), reader.notes().begin(), reader.notes().end());
  return text;
}

// ---------------------------------------------------------------- writing

namespace {

/// The type of a field that can represent all values of a property.
enum class FieldKind : std::uint8_t { Nothing, Boolean, Integer, Real, Text };

FieldKind kind_of_value(const Json& value) {
  if (value.is_null()) return FieldKind::Nothing;
  if (value.is_boolean()) return FieldKind::Boolean;
  if (value.is_number_unsigned() &&
      value.get<std::uint64_t>() > std::uint64_t{std::numeric_limits<std::int64_t>::max()}) {
    return FieldKind::Real;
  }
  if (value.is_number_integer()) return FieldKind::Integer;
  return value.is_number() ? FieldKind::Real : FieldKind::Text;
}

FieldKind joined_kind(FieldKind a, FieldKind b) {
  if (a == b || b == FieldKind::Nothing) return a;
  if (a == FieldKind::Nothing) return b;
  const auto is_number = [](FieldKind kind) {
    return kind == FieldKind::Integer || kind == FieldKind::Real;
  };
  return is_number(a) && is_number(b) ? FieldKind::Real : FieldKind::Text;
}

Json parsed(std::string_view text) {
  return text.empty() ? Json() : Json::parse(text.begin(), text.end(), nullptr, false);
}

/// The fields of a layer, in the order in which the features use them.
struct FieldTable {
  std::vector<std::pair<std::string, FieldKind> > fields;
  std::map<std::string, std::size_t> place;
  bool has_number_ids = false;  ///< Whether all ids are different integers from 0 on.
  bool has_id_field = false;    ///< Whether ids go to a field.

  void add(const std::string& name, FieldKind kind) {
    const auto [found, is_new] = place.try_emplace(name, fields.size());
    if (is_new) fields.push_back({name, FieldKind::Nothing});
    FieldKind& known = fields[found->second].second;
    known = joined_kind(known, kind);
  }
};

FieldTable fields_of(const Layer& layer, bool keeps_number_ids, Context& context) {
  FieldTable table;
  std::set<std::int64_t> numbers;
  FieldKind id_kind = FieldKind::Nothing;
  bool all_numbers = true;
  for (std::size_t f = 0; f < layer.feature_count(); ++f) {
    if (f % 256 == 0) context.checkpoint("fields", f, layer.feature_count());
    const Json id = parsed(layer.id(f));
    id_kind = joined_kind(id_kind, kind_of_value(id));
    all_numbers = all_numbers && kind_of_value(id) == FieldKind::Integer &&
                  id.get<std::int64_t>() >= 0 && numbers.insert(id.get<std::int64_t>()).second;
    const Json properties = parsed(layer.properties(f));
    if (!properties.is_object()) continue;
    for (const auto& [name, value] : properties.items()) table.add(name, kind_of_value(value));
  }
  table.has_number_ids = keeps_number_ids && all_numbers;
  table.has_id_field = !table.has_number_ids && id_kind != FieldKind::Nothing &&
                       table.place.find("id") == table.place.end();
  if (table.has_id_field) table.add("id", id_kind);
  return table;
}

void add_fields(OGRLayerH layer, const FieldTable& table) {
  for (const auto& [name, kind] : table.fields) {
    const OGRFieldType type = kind == FieldKind::Boolean   ? OFTInteger
                              : kind == FieldKind::Integer ? OFTInteger64
                              : kind == FieldKind::Real    ? OFTReal
                                                           : OFTString;
    OGRFieldDefnH const field = OGR_Fld_Create(name.c_str(), type);
    if (kind == FieldKind::Boolean) OGR_Fld_SetSubType(field, OFSTBoolean);
    OGR_L_CreateField(layer, field, 1);
    OGR_Fld_Destroy(field);
  }
}

/// Returns the text of a value in a field of texts.
std::string text_of(const Json& value) {
  return value.is_string() ? value.get<std::string>() : dumped(value);
}

void set_field(OGRFeatureH feature, int i, FieldKind kind, const Json& value) {
  if (value.is_null()) {
    OGR_F_SetFieldNull(feature, i);
  } else if (kind == FieldKind::Boolean) {
    OGR_F_SetFieldInteger(feature, i, value.get<bool>() ? 1 : 0);
  } else if (kind == FieldKind::Integer) {
    OGR_F_SetFieldInteger64(feature, i, value.get<std::int64_t>());
  } else if (kind == FieldKind::Real) {
    OGR_F_SetFieldDouble(feature, i, value.get<double>());
  } else {
    OGR_F_SetFieldString(feature, i, text_of(value).c_str());
  }
}

/// The polygons of a feature as WKB of a MultiPolygon, in the byte order of this machine.
class MultiPolygonBytes {
 public:
  MultiPolygonBytes(const Layer& layer, std::size_t feature) {
    const std::uint32_t begin = layer.feature_begin[feature];
    const std::uint32_t end = layer.feature_begin[feature + 1];
    head(wkbMultiPolygon, end - begin);
    for (std::uint32_t p = begin; p < end; ++p) {
      head(wkbPolygon, layer.polygon_begin[p + 1] - layer.polygon_begin[p]);
      for (std::size_t r = layer.polygon_begin[p]; r < layer.polygon_begin[p + 1]; ++r) {
        ring(layer, layer.ring(r));
      }
    }
  }
  const std::string& bytes() const { return bytes_; }

 private:
  template <class T>
  void put(T value) {
    const std::size_t at = bytes_.size();
    bytes_.resize(at + sizeof value);
    std::memcpy(bytes_.data() + at, &value, sizeof value);
  }
  void head(std::uint32_t type, std::uint32_t count) {
    bytes_ += std::endian::native == std::endian::little ? '\1' : '\0';
    put(type);
    put(count);
  }
  void ring(const Layer& layer, std::span<const std::uint32_t> corners) {
    put(static_cast<std::uint32_t>(corners.size() + 1));
    for (std::size_t i = 0; i <= corners.size(); ++i) {
      const Point2 p = layer.points.approx(corners[i < corners.size() ? i : 0]);
      put(p.x);
      put(p.y);
    }
  }

  std::string bytes_;
};

struct DestroyCrs {
  void operator()(OGRSpatialReferenceH crs) const { OSRDestroySpatialReference(crs); }
};
using Crs = std::unique_ptr<std::remove_pointer_t<OGRSpatialReferenceH>, DestroyCrs>;

/// Returns the reference system of a name, or null if it is unknown. The function opens no files
/// and no addresses.
Crs crs_named(const std::string& name) {
  constexpr std::string_view kEpsg = "urn:ogc:def:crs:EPSG:";
  if (name.empty()) return nullptr;
  Crs crs(OSRNewSpatialReference(nullptr));
  OSRSetAxisMappingStrategy(crs.get(), OAMS_TRADITIONAL_GIS_ORDER);
  OGRErr error = OGRERR_NONE;
  if (name.starts_with(kEpsg)) {
    error = OSRImportFromEPSG(crs.get(), std::atoi(name.c_str() + name.rfind(':') + 1));
  } else if (name.starts_with("urn:ogc:def:crs:OGC:") && name.ends_with(":CRS84")) {
    error = OSRSetWellKnownGeogCS(crs.get(), "CRS84");
  } else {
    std::string text = name;
    char* begin = text.data();
    error = OSRImportFromWkt(crs.get(), &begin);
  }
  return error == OGRERR_NONE ? std::move(crs) : nullptr;
}

/// A file in memory with a unique name. The destructor removes the file.
class MemoryFile {
 public:
  explicit MemoryFile(const std::string& extension) : MemoryFile(new_stem(), extension) {}
  MemoryFile(const std::string& stem, const std::string& extension) : name_(stem + extension) {}
  /// Returns a path without an extension that no other file has.
  static std::string new_stem() {
    static std::atomic<std::uint64_t> count{0};
    return "/vsimem/plumb/" + std::to_string(count++);
  }
  ~MemoryFile() { VSIUnlink(name_.c_str()); }
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;
  const std::string& name() const { return name_; }
  /// Returns the bytes, or none if GDAL has not written the file.
  std::string_view bytes() const {
    vsi_l_offset size = 0;
    const GByte* const bytes = VSIGetMemFileBuffer(name_.c_str(), &size, FALSE);
    if (bytes == nullptr) return {};
    return {reinterpret_cast<const char*>(bytes), static_cast<std::size_t>(size)};
  }
  void copy_to(std::ostream& out) const {
    out.write(bytes().data(), static_cast<std::streamsize>(bytes().size()));
  }

 private:
  std::string name_;
};

/// While an object of this class exists, the time that files state is fixed.
class FixedTime {
 public:
  FixedTime() { CPLSetThreadLocalConfigOption("OGR_CURRENT_DATE", "1980-01-01T00:00:00.000Z"); }
  ~FixedTime() { CPLSetThreadLocalConfigOption("OGR_CURRENT_DATE", nullptr); }
  FixedTime(const FixedTime&) = delete;
  FixedTime& operator=(const FixedTime&) = delete;
};

/// Appends the features of a layer to a layer of GDAL.
class FeatureWriter {
 public:
  FeatureWriter(const Layer& layer, const FieldTable& table, OGRLayerH to)
      : layer_(layer), table_(table), to_(to) {}

  bool write(std::size_t f) const {
    const Feature feature(OGR_F_Create(OGR_L_GetLayerDefn(to_)));
    const Json id = parsed(layer_.id(f));
    if (table_.has_number_ids) OGR_F_SetFID(feature.get(), id.get<std::int64_t>());
    Json properties = parsed(layer_.properties(f));
    if (!properties.is_object()) properties = Json::object();
    if (table_.has_id_field) properties["id"] = id;
    for (const auto& [name, value] : properties.items()) {
      const std::size_t i = table_.place.at(name);
      set_field(feature.get(), static_cast<int>(i), table_.fields[i].second, value);
    }
    if (layer_.feature_begin[f] < layer_.feature_begin[f + 1]) set_geometry(feature.get(), f);
    return OGR_L_CreateFeature(to_, feature.get()) == OGRERR_NONE;
  }

 private:
  void set_geometry(OGRFeatureH feature, std::size_t f) const {
    const MultiPolygonBytes wkb(layer_, f);
    OGRGeometryH geometry = nullptr;
    OGR_G_CreateFromWkb(wkb.bytes().data(), nullptr, &geometry,
                        static_cast<int>(wkb.bytes().size()));
    if (geometry != nullptr) OGR_F_SetGeometryDirectly(feature, geometry);
  }

  const Layer& layer_;
  const FieldTable& table_;
  OGRLayerH to_;
};

/// Writes all features of a layer, and closes the file.
void write_features(Dataset set, const Layer& layer, const std::string& crs,
                    const FieldTable& table, const std::array<const char*, 2>& options,
                    const GdalMessages& messages, const char* driver, Context& context) {
  const auto require = [&](bool is_done) {
    if (!is_done) messages.fail(ErrorCode::CannotWrite, "GDAL cannot write the layer", driver);
  };
  require(set != nullptr);
  OGRLayerH const to = GDALDatasetCreateLayer(set.get(), "layer", crs_named(crs).get(),
                                              wkbMultiPolygon, options.data());
  require(to != nullptr);
  add_fields(to, table);
  const bool has_transactions = OGR_L_TestCapability(to, OLCTransactions) != 0;
  if (has_transactions) require(OGR_L_StartTransaction(to) == OGRERR_NONE);
  const FeatureWriter writer(layer, table, to);
  for (std::size_t f = 0; f < layer.feature_count(); ++f) {
    if (f % 64 == 0) context.checkpoint("write", f, layer.feature_count());
    require(writer.write(f));
  }
  if (has_transactions) require(OGR_L_CommitTransaction(to) == OGRERR_NONE);
  set.reset();
  require(!messages.has_failed());
}

/// The numbers of entries that exceed the table of a shapefile. It has names of 10 bytes, texts of
/// 254 bytes, and numbers of 24 characters with 15 digits after the point.
struct TableLosses {
  std::size_t names = 0, texts = 0, numbers = 0;

  void add(FieldKind kind, const Json& value) {
    constexpr std::size_t kMostText = 254;
    constexpr int kCharacters = 24, kDigits = 15;
    if (kind == FieldKind::Text && !value.is_null()) {
      if (text_of(value).size() > kMostText) ++texts;
    } else if (kind == FieldKind::Real && value.is_number()) {
      const auto number = value.get<double>();
      std::array<char, 512> text{};
      const int size =
          std::snprintf(text.data(), text.size(), "%*.*f", kCharacters, kDigits, number);
      if (size != kCharacters || std::strtod(text.data(), nullptr) != number) ++numbers;
    }
  }

  std::vector<std::string> notes() const {
    std::vector<std::string> result;
    const auto note = [&](std::size_t count, const char* what) {
      if (count > 0) result.push_back(what + (" (" + std::to_string(count) + ')'));
    };
    note(names, "shortened: names of properties of more than 10 bytes");
    note(texts, "cut: texts of more than 254 bytes");
    note(numbers, "rounded: numbers that need more than 15 digits behind the point");
    return result;
  }
};

TableLosses losses_of(const Layer& layer, const FieldTable& table, Context& context) {
  constexpr std::size_t kMostName = 10;
  TableLosses losses;
  for (const auto& [name, kind] : table.fields) losses.names += name.size() > kMostName ? 1 : 0;
  for (std::size_t f = 0; f < layer.feature_count(); ++f) {
    if (f % 256 == 0) context.checkpoint("fields", f, layer.feature_count());
    const Json properties = parsed(layer.properties(f));
    if (table.has_id_field)
      losses.add(table.fields[table.place.at("id")].second, parsed(layer.id(f)));
    if (!properties.is_object()) continue;
    for (const auto& [name, value] : properties.items()) {
      losses.add(table.fields[table.place.at(name)].second, value);
    }
  }
  return losses;
}

/// Throws Error{BadArgument} if a feature has no polygons. For FlatGeobuf, GDAL would drop such
/// features silently.
void require_polygons(const Layer& layer) {
  for (std::size_t f = 0; f < layer.feature_count(); ++f) {
    if (layer.feature_begin[f] < layer.feature_begin[f + 1]) continue;
    throw Error(ErrorCode::BadArgument, "feature " + std::to_string(f + 1) +
                                            " has no polygons, and FlatGeobuf has no place for it; "
                                            "write a GeoPackage or GeoJSON");
  }
}

}  // namespace

void write_gdal_layer(std::ostream& out, const Layer& layer, const std::string& crs,
                      const char* driver, Context& context) {
  register_drivers();
  const GdalMessages messages;
  const FixedTime time;
  const bool is_package = std::string_view(driver) == "GPKG";
  if (!is_package) require_polygons(layer);
  const FieldTable table = fields_of(layer, is_package, context);
  const MemoryFile file(is_package ? ".gpkg" : ".fgb");
  Dataset set(
      GDALCreate(GDALGetDriverByName(driver), file.name().c_str(), 0, 0, 0, GDT_Unknown, nullptr));
  // The spatial index of FlatGeobuf would change the order of features.
  write_features(std::move(set), layer, crs, table,
                 {is_package ? nullptr : "SPATIAL_INDEX=NO", nullptr}, messages, driver, context);
  file.copy_to(out);
}

Shapefile gdal_shapefile(const Layer& layer, const std::string& crs, Context& context) {
  constexpr const char* kDriver = "ESRI Shapefile";
  register_drivers();
  const GdalMessages messages;
  const FixedTime time;
  const FieldTable table = fields_of(layer, false, context);
  const std::string stem = MemoryFile::new_stem();
  const MemoryFile shp(stem, ".shp"), shx(stem, ".shx"), dbf(stem, ".dbf"), prj(stem, ".prj"),
      cpg(stem, ".cpg");
  CPLSetThreadLocalConfigOption("DBF_DATE_LAST_UPDATE", "1980-01-01");
  Dataset set(
      GDALCreate(GDALGetDriverByName(kDriver), shp.name().c_str(), 0, 0, 0, GDT_Unknown, nullptr));
  const std::array<const char*, 2> options{"ENCODING=UTF-8", nullptr};
  write_features(std::move(set), layer, crs, table, options, messages, kDriver, context);
  return {std::string(shp.bytes()), std::string(shx.bytes()),
          std::string(dbf.bytes()), std::string(prj.bytes()),
          std::string(cpg.bytes()), losses_of(layer, table, context).notes()};
}

#endif

}  // namespace plumb
