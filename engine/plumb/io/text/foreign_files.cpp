// Kinds of files by their first bytes.
//
// Three tables are searched in order: signatures, which begin a file; names of root elements of
// XML; and words that texts of a kind have near their beginning. A signature of text must be
// followed by the end of a word, so a table whose first column is called "OFFICE" is no OFF. Only
// files that a reader has refused are examined. So a wrong guess makes a message wrong, but never a
// result. Tested by tests/io/foreign_files_test.cpp.
#include "plumb/io/text/foreign_files.h"

#include <algorithm>
#include <array>
#include <cstddef>

#include "plumb/io/text/input_cursors.h"

namespace plumb {
namespace {

constexpr std::size_t kMostSearched = 4096;
constexpr std::string_view kForeignBlanks = " \t\r\n";

using namespace std::string_view_literals;

constexpr std::string_view kUnpack = "unpack it first";
constexpr std::string_view kExportMesh = "export a mesh of it, as OFF, OBJ, STL, PLY, glTF or 3MF";
constexpr std::string_view kExportDrawing = "save the drawing as SVG or DXF in text";
constexpr std::string_view kConvert =
    "GDAL converts it: ogr2ogr -f GeoJSON -lco COORDINATE_PRECISION=17 layer.geojson FILE";
constexpr std::string_view kRename = "give the file its own extension";

/// A kind of file: the bytes by which it is recognised, its name, the advice to the user, and the
/// name of its reader, if plumb has one.
struct ForeignKind {
  std::string_view sign;
  std::string_view what;
  std::string_view advice;
  std::string_view reader = {};
};

constexpr std::array kSignatures{
    ForeignKind{"\xFF\xFE"sv, "text in UTF-16", "save it as UTF-8"},
    ForeignKind{"\xFE\xFF"sv, "text in UTF-16", "save it as UTF-8"},
    ForeignKind{"\x1F\x8B"sv, "a file packed by gzip", kUnpack},
    ForeignKind{"BZh"sv, "a file packed by bzip2", kUnpack},
    ForeignKind{"\xFD"
                "7zXZ\0"sv,
                "a file packed by xz", kUnpack},
    ForeignKind{"\x28\xB5\x2F\xFD"sv, "a file packed by zstd", kUnpack},
    ForeignKind{"7z\xBC\xAF"sv, "a 7-Zip archive", kUnpack},
    ForeignKind{"PK\x03\x04"sv, "a ZIP archive",
                "unpack it first, or, if it is a 3MF file, give it the extension .3mf", "3MF"},
    ForeignKind{"ISO-10303-21"sv, "a STEP model, which has curved surfaces", kExportMesh},
    ForeignKind{"Kaydara FBX Binary"sv, "an FBX file", kExportMesh},
    ForeignKind{"; FBX "sv, "an FBX file", kExportMesh},
    ForeignKind{"#VRML"sv, "a VRML file", kExportMesh},
    ForeignKind{"#X3D"sv, "an X3D file", kExportMesh},
    ForeignKind{"# vtk DataFile"sv, "a VTK file", kExportMesh},
    ForeignKind{"$MeshFormat"sv, "a Gmsh file", kExportMesh},
    ForeignKind{"    -1\n"sv, "a universal file (UNV)", kExportMesh},
    ForeignKind{"    -1\r\n"sv, "a universal file (UNV)", kExportMesh},
    ForeignKind{"BLENDER"sv, "a file of Blender", kExportMesh},
    ForeignKind{"OCTM"sv, "an OpenCTM file", kExportMesh},
    ForeignKind{"$Comments"sv, "a Gmsh file", kExportMesh},
    ForeignKind{"DRACO"sv, "a Draco file", kExportMesh},
    ForeignKind{"xof "sv, "a DirectX file", kExportMesh},
    ForeignKind{"#usda"sv, "a USD file", kExportMesh},
    ForeignKind{"PXR-USDC"sv, "a USD file", kExportMesh},
    ForeignKind{"3D Geometry File Format"sv, "a file of Rhino", kExportMesh},
    ForeignKind{"glTF"sv, "binary glTF", "give the file the extension .glb", "glTF"},
    ForeignKind{"ply\n"sv, "PLY", "give the file the extension .ply", "PLY"},
    ForeignKind{"ply\r"sv, "PLY", "give the file the extension .ply", "PLY"},
    ForeignKind{"plumb-nef2 "sv, "a set of the plane", "give the file the extension .nef2", "nef2"},
    ForeignKind{"plumb-nef3 "sv, "a set of space", "give the file the extension .nef", "nef3"},
    ForeignKind{"version https://git-lfs"sv, "a pointer of Git LFS, not the file itself",
                "fetch the file with 'git lfs pull'"},
    ForeignKind{"SQLite format 3\0"sv, "a GeoPackage or another SQLite database", kConvert},
    ForeignKind{"\0\0\x27\x0A"sv, "a shapefile", kConvert},
    ForeignKind{"fgb\x03"sv, "FlatGeobuf", kConvert},
    ForeignKind{"PAR1"sv, "a Parquet file", kConvert},
    ForeignKind{"%PDF"sv, "a PDF file", kExportDrawing},
    ForeignKind{"%!PS"sv, "a PostScript file", kExportDrawing},
    ForeignKind{"AC10"sv, "a DWG drawing", kExportDrawing},
    ForeignKind{"AutoCAD Binary DXF"sv, "binary DXF", "save it as DXF in text (ASCII)", "DXF"},
    ForeignKind{"\x89PNG"sv, "a picture (PNG)", "trace its outlines first"},
    ForeignKind{"\xFF\xD8\xFF"sv, "a picture (JPEG)", "trace its outlines first"},
    ForeignKind{"GIF8"sv, "a picture (GIF)", "trace its outlines first"},
};

/// Root elements of XML, without the prefix of their name space.
constexpr std::array kRoots{
    ForeignKind{"COLLADA", "a COLLADA file", kExportMesh},
    ForeignKind{"X3D", "an X3D file", kExportMesh},
    ForeignKind{"amf", "an AMF file", "give the file the extension .amf", "AMF"},
    ForeignKind{"VTKFile", "a VTK file", kExportMesh},
    ForeignKind{"kml", "a KML file", kConvert},
    ForeignKind{"gpx", "a GPX file", kConvert},
    ForeignKind{"osm", "an OpenStreetMap file", kConvert},
    ForeignKind{"FeatureCollection", "a GML file", kConvert},
    ForeignKind{"Polygon", "a GML file", kConvert},
    ForeignKind{"MultiSurface", "a GML file", kConvert},
    ForeignKind{"MultiPolygon", "a GML file", kConvert},
    ForeignKind{"svg", "an SVG drawing", "give the file the extension .svg", "SVG"},
    ForeignKind{"html", "a web page (HTML)", "perhaps a download failed: fetch the file again"},
};

/// Words near the beginning of JSON. The word that comes first in the file determines the kind.
constexpr std::array kJsonWords{
    ForeignKind{"\"Topology\"", "TopoJSON", "plumb map reads it; 'map dissolve' writes GeoJSON",
                "TopoJSON"},
    ForeignKind{"\"esriGeometry", "JSON of ArcGIS", kConvert},
    ForeignKind{"\"rings\"", "JSON of ArcGIS", kConvert},
    ForeignKind{"\"elements\"", "OpenStreetMap data as JSON",
                "osmtogeojson converts it to GeoJSON"},
    ForeignKind{"\"asset\"", "glTF", "give the file the extension .gltf", "glTF"},
    ForeignKind{"\"BufferGeometry\"", "JSON of three.js", kExportMesh},
    ForeignKind{"\"FeatureCollection\"", "GeoJSON", kRename, "GeoJSON"},
    ForeignKind{"\"coordinates\"", "GeoJSON", kRename, "GeoJSON"},
};

/// First words of texts, in capital letters, without what follows.
constexpr std::array kFirstWords{
    ForeignKind{"OFF", "OFF", "give the file the extension .off", "OFF"},
    ForeignKind{"COFF", "OFF", "give the file the extension .off", "OFF"},
    ForeignKind{"NOFF", "OFF", "give the file the extension .off", "OFF"},
    ForeignKind{"MESHVERSIONFORMATTED", "a Medit file", kExportMesh},
    ForeignKind{"*HEADING", "an Abaqus file", kExportMesh},
    ForeignKind{"*NODE", "an Abaqus file", kExportMesh},
};

/// Beginnings of first words of WKT, in capital letters.
constexpr std::array<std::string_view, 9> kWktWords{"POINT",    "LINESTRING", "POLYGON",
                                                    "MULTI",    "GEOMETRYC",  "CURVE",
                                                    "COMPOUND", "CIRCULAR",   "SRID"};

constexpr std::string_view kSolids = "OFF OBJ STL PLY glTF 3MF AMF nef3";
constexpr std::string_view kPlaneSets = "WKT WKB GeoJSON SVG DXF nef2";

/// Returns the advice to the user. If the file would have to be renamed, but another family of
/// commands reads it, the advice names this family.
std::string_view advice_for(const ForeignKind& kind, bool reads_solids, bool reads_layers) {
  const bool is_known = !kind.reader.empty() && kind.advice.starts_with("give");
  if (is_known && !reads_solids && kSolids.find(kind.reader) != kSolids.npos) {
    return "plumb solid reads it";
  }
  if (is_known && (reads_solids || reads_layers) &&
      kPlaneSets.find(kind.reader) != kPlaneSets.npos) {
    return "plumb plane reads it";
  }
  return kind.advice;
}

bool is_own(const ForeignKind& kind, std::string_view own) {
  return !kind.reader.empty() && own.find(kind.reader) != own.npos;
}

template <class Kinds, class Test>
const ForeignKind* find_kind(const Kinds& kinds, Test test) {
  const auto found = std::find_if(kinds.begin(), kinds.end(), test);
  return found == kinds.end() ? nullptr : &*found;
}

char upper(char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; }

/// Whether the words are equal, without regard to the case of their letters.
bool equals(std::string_view a, std::string_view b) {
  return std::ranges::equal(a, b, {}, upper, upper);
}

/// Returns the name of the root element without its prefix, or an empty text if there is none.
std::string_view root_of(std::string_view xml) {
  constexpr std::string_view kAfterName = " \t\r\n/>";
  for (std::size_t at = xml.find('<'); at != xml.npos; at = xml.find('<', at + 1)) {
    std::string_view name = xml.substr(at + 1);
    if (name.starts_with('!') && equals(name.substr(0, 13), "!DOCTYPE HTML")) return "html";
    if (name.empty() || name.front() == '!' || name.front() == '?') continue;
    name = name.substr(0, name.find_first_of(kAfterName));
    return name.substr(name.find(':') + 1);
  }
  return {};
}

/// Whether one of the first lines is a vertex of OBJ.
bool has_vertex_line(std::string_view text) {
  const std::size_t at = text.starts_with("v ") ? 0 : text.find("\nv ");
  if (at == text.npos) return false;
  const std::string_view number = text.substr(text.find(' ', at) + 1, 2);
  return number.find_first_of("-+.0123456789") != number.npos;
}

/// Whether the text begins like WKB in hexadecimal digits: a byte order, and a code below 256 in
/// that order.
bool begins_like_hexadecimal_wkb(std::string_view text) {
  constexpr std::size_t kLeast = 18;  // The number of digits of an empty list.
  if (text.starts_with("\\x") || text.starts_with("0x")) text.remove_prefix(2);
  const std::string_view word = text.substr(0, text.find_first_of(kForeignBlanks));
  const bool is_order = word.starts_with("01") || word.starts_with("00");
  return is_order && word.size() >= kLeast &&
         word.find_first_not_of("0123456789abcdefABCDEF") == word.npos;
}

/// Whether a polygon, a line or a point of WKT begins after a quote or a column separator.
bool has_quoted_geometry(std::string_view text) {
  constexpr std::string_view kBefore = "\"',;\t";
  for (const std::string_view name : {"POLYGON", "MULTIPOLYGON", "LINESTRING", "POINT"}) {
    for (std::size_t at = text.find(name); at != text.npos; at = text.find(name, at + 1)) {
      if (at > 0 && kBefore.find(text[at - 1]) != kBefore.npos) return true;
    }
  }
  return false;
}

/// Whether the first line is that of an IGES file. Its 73rd column has the name of its section.
bool begins_like_iges(std::string_view text) {
  constexpr std::size_t kColumn = 72;
  return text.size() > kColumn && text.substr(kColumn).starts_with("S      1");
}

/// Whether the first chunk, which is the whole file, begins with the chunk of the version or of the
/// editor, as in 3D Studio.
bool begins_like_3ds(std::string_view bytes) {
  constexpr std::size_t kSecondChunk = 6;
  if (!bytes.starts_with("MM") || bytes.size() < kSecondChunk + 2) return false;
  const std::string_view second = bytes.substr(kSecondChunk, 2);
  return second == "\x02\0"sv || second == "\x3D\x3D"sv;
}

/// Whether one of the first lines is the card of a grid point, or begins the cards of Nastran.
bool has_nastran_card(std::string_view text) {
  return text.find("\nGRID") != text.npos || text.find("\nBEGIN BULK") != text.npos;
}

/// Returns the kind of a text that begins with an ordinary word.
const ForeignKind* kind_of_text(std::string_view text) {
  static constexpr ForeignKind kStl{"", "STL", "give the file the extension .stl", "STL"};
  static constexpr ForeignKind kObj{"", "OBJ", "give the file the extension .obj", "OBJ"};
  static constexpr ForeignKind kDxf{"", "DXF", "give the file the extension .dxf", "DXF"};
  static constexpr ForeignKind kWkt{"", "WKT", "give the file the extension .wkt", "WKT"};
  static constexpr ForeignKind kWkb{"", "WKB", "give the file the extension .wkb", "WKB"};
  if (begins_like_hexadecimal_wkb(text)) return &kWkb;
  static constexpr ForeignKind kTable{
      "", "a table with geometries",
      "leave only the column of geometries, a geometry a line without quotes, or convert it: "
      "ogr2ogr -f GeoJSON -lco COORDINATE_PRECISION=17 layer.geojson FILE"};
  const std::string_view word = text.substr(0, text.find_first_of(" \t\r\n("));
  const std::string_view second = [&] {
    std::string_view rest = text.substr(word.size());
    rest.remove_prefix(std::min(rest.find_first_not_of(kForeignBlanks), rest.size()));
    return rest.substr(0, rest.find_first_of(kForeignBlanks));
  }();
  if (equals(word, "SOLID") && text.find("facet") != text.npos) return &kStl;
  if (word == "0" && second == "SECTION") return &kDxf;
  if (const auto* kind = find_kind(kFirstWords, [&](auto& k) { return equals(word, k.sign); })) {
    return kind;
  }
  const bool is_wkt = std::ranges::any_of(kWktWords, [&](std::string_view begin) {
    return equals(word.substr(0, begin.size()), begin);
  });
  if (is_wkt) return &kWkt;
  static constexpr ForeignKind kNastran{"", "a Nastran file", kExportMesh};
  if (has_nastran_card(text)) return &kNastran;
  if (has_vertex_line(text)) return &kObj;
  return has_quoted_geometry(text) ? &kTable : nullptr;
}

const ForeignKind* kind_of(std::string_view bytes) {
  const auto* const signature =
      find_kind(kSignatures, [&](const auto& kind) { return bytes.starts_with(kind.sign); });
  if (signature != nullptr) return signature;
  static constexpr ForeignKind kIges{"", "an IGES model, which has curved surfaces", kExportMesh};
  if (begins_like_iges(bytes)) return &kIges;
  static constexpr ForeignKind k3ds{"", "a 3DS file", kExportMesh};
  if (begins_like_3ds(bytes)) return &k3ds;
  take_prefix(bytes, "\xEF\xBB\xBF");
  bytes.remove_prefix(std::min(bytes.find_first_not_of(kForeignBlanks), bytes.size()));
  if (bytes.starts_with('<')) {
    const std::string_view root = root_of(bytes);
    return find_kind(kRoots, [&](const auto& kind) { return equals(root, kind.sign); });
  }
  if (bytes.starts_with('{') || bytes.starts_with('[')) {
    const auto* const first = std::ranges::min_element(
        kJsonWords, {}, [&](const auto& kind) { return bytes.find(kind.sign); });
    return bytes.find(first->sign) == bytes.npos ? nullptr : first;
  }
  return kind_of_text(bytes);
}

}  // namespace

std::optional<std::string> foreign_kind(std::string_view bytes, std::string_view own,
                                        std::optional<FileReaders> readers) {
  const ForeignKind* const kind = kind_of(bytes.substr(0, kMostSearched));
  if (kind == nullptr || is_own(*kind, own)) return {};
  const bool reads_solids =
      readers ? *readers == FileReaders::Solids : kSolids.find(own) != kSolids.npos;
  const bool reads_layers = own.find("TopoJSON") != own.npos;
  return "this is " + std::string(kind->what) + "; " +
         std::string(advice_for(*kind, reads_solids, reads_layers));
}

}  // namespace plumb
