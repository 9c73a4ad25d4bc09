// Files of another kind than the one that is read: messages say what they are. Readers of all
// formats, files in corpus/reports/29-other-kinds and made here.
#include "plumb/io/text/foreign_files.h"

#include <gtest/gtest.h>

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "plumb/io/layer_io.h"
#include "plumb/io/map_io.h"
#include "plumb/io/mesh_io.h"
#include "plumb/io/plane_io.h"

namespace plumb {
namespace {

using namespace std::string_literals;

struct Foreign {
  std::string bytes;
  std::string says;
};

std::vector<Foreign> foreign_files() {
  const std::string packed = "\x1F\x8B\x08\0\0\0\0\0"s;
  const std::string wide = "\xFF\xFEO\0F\0F\0\n\0"s;
  return {
      {packed, "packed by gzip; unpack it first"},
      {wide, "UTF-16; save it as UTF-8"},
      {"\xFE\xFF\0O"s, "UTF-16"},
      {"BZh91AY", "bzip2"},
      {"ISO-10303-21;\nHEADER;\n", "a STEP model"},
      {std::string(72, ' ') + "S      1\n", "an IGES model"},
      {"Kaydara FBX Binary  \0\x1A\0"s, "an FBX file"},
      {"#VRML V2.0 utf8\nShape {}\n", "a VRML file"},
      {"# vtk DataFile Version 3.0\nx\nASCII\n", "a VTK file"},
      {" MeshVersionFormatted 2\n Dimension\n 3\n", "a Medit file"},
      {"*Heading\n a part\n*NODE\n", "an Abaqus file"},
      {"$ Created by a mesher\nGRID           1       00.00E+001.00E+00\n", "a Nastran file"},
      {"    -1\n  2411\n         1\n", "a universal file"},
      {"MM\x20\0\0\0\x02\0\x0A\0\0\0"s, "a 3DS file"},
      {"<?xml version='1.0'?>\n<!-- a -->\n<COLLADA xmlns='x'/>", "a COLLADA file"},
      {"<kml:kml xmlns:kml='x'/>", "a KML file"},
      {"<!doctype html>\n<p>404", "a web page"},
      {"<HTML><body>404", "a web page"},
      {"version https://git-lfs.github.com/spec/v1\noid sha256:1\n", "git lfs pull"},
      {"SQLite format 3\0 "s, "GeoPackage"},
      {"\0\0\x27\x0A\0\0\0\0"s, "a shapefile; GDAL converts it"},
      {"fgb\x03 fgb", "FlatGeobuf"},
      {"%PDF-1.4\n", "a PDF file"},
      {"AC1027\0\0"s, "a DWG drawing"},
      {"\x89PNG\r\n\x1A\n", "a picture (PNG)"},
      {"{\"geometryType\": \"esriGeometryPolygon\"}", "JSON of ArcGIS"},
      {"id,shape\n1,\"POLYGON ((0 0, 1 0, 0 1, 0 0))\"\n", "a table with geometries"},
      {"\"POLYGON ((0 0, 1 0, 0 1, 0 0))\"\n", "without quotes"},
  };
}

template <class Read>
void expect_told(const Foreign& file, Read read) {
  try {
    read();
    ADD_FAILURE() << "was read: " << file.bytes;
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::UnknownFormat) << error.what();
    EXPECT_NE(error.message().find(file.says), std::string::npos) << error.what();
    EXPECT_EQ(error.place().file, "a.file");
    EXPECT_EQ(error.place().line, 0U);
  }
}

ReadOptions named() { return {.name = "a.file"}; }

TEST(foreign_files, readers_of_all_formats_name_them) {
  Context context;
  for (const Foreign& file : foreign_files()) {
    for (const MeshFormat format :
         {MeshFormat::Off, MeshFormat::Obj, MeshFormat::Ply, MeshFormat::Gltf, MeshFormat::Stl}) {
      expect_told(file, [&] { (void)read_mesh(file.bytes, format, named(), context); });
    }
    for (const PlaneFormat format :
         {PlaneFormat::Wkt, PlaneFormat::GeoJson, PlaneFormat::Svg, PlaneFormat::Dxf}) {
      expect_told(file, [&] { (void)read_plane_set(file.bytes, format, named(), context); });
    }
    LayerReadOptions layer;
    layer.name = "a.file";
    expect_told(file, [&] { (void)read_layer(file.bytes, layer, context); });
    expect_told(file, [&] { (void)read_map(file.bytes, named(), context); });
  }
}

/// The formats that plumb reads, each given to the readers of the others.
TEST(foreign_files, formats_are_told_from_one_another) {
  struct Own {
    MeshFormat format;
    std::string bytes;
    std::string says;
  };
  const std::vector<Own> files{
      {MeshFormat::Off, "OFF\n1 0 0\n0 0 0\n", "this is OFF"},
      {MeshFormat::Obj, "# x\no a\nv 0 0 0\nv 1 0 0\n", "this is OBJ"},
      {MeshFormat::Ply, "ply\nformat ascii 1.0\nend_header\n", "this is PLY"},
      {MeshFormat::Gltf, R"({"asset": {"version": "2.0"}})", "this is glTF"},
      {MeshFormat::Stl, "solid a\nfacet normal 0 0 0\n", "this is STL"},
  };
  Context context;
  for (const Own& reader : files) {
    for (const Own& file : files) {
      const Foreign foreign{file.bytes, file.says};
      const auto read = [&] { (void)read_mesh(file.bytes, reader.format, named(), context); };
      if (&reader != &file) {
        expect_told(foreign, read);
        continue;
      }
      try {
        read();
      } catch (const Error& error) {
        EXPECT_EQ(error.message().find("this is"), std::string::npos) << error.what();
      }
    }
    expect_told({reader.bytes, reader.says},
                [&] { (void)read_plane_set(reader.bytes, PlaneFormat::Wkt, named(), context); });
  }
}

/// A file that a reader accepts may begin as a file of another kind does.
TEST(foreign_files, only_refused_files_are_looked_at) {
  Context context;
  const std::string comment = "# vtk DataFile\nv 0 0 0\n";
  EXPECT_EQ(read_mesh(comment, MeshFormat::Obj, named(), context).mesh.points.size(), 1U);
}

TEST(foreign_files, words_of_other_texts_are_not_signatures) {
  for (const std::string_view text :
       {"OFFICE 1\n", "value 1\n", "solid state\n", "<xml/>", "{\"a\": 1}", "", "1 2 3\n4 5 6\n"}) {
    EXPECT_EQ(foreign_kind(text, "PLY"), std::nullopt) << text;
  }
}

/// The message of the reader says more than the kind, if this is the kind that it reads.
TEST(foreign_files, own_kinds_keep_their_messages) {
  Context context;
  for (const std::string text :
       {"CURVEPOLYGON (CIRCULARSTRING (0 0, 1 1, 2 0, 0 0), (0 0,POLYGON", "SRID = 1; POLYGON",
        "polygon ((0 0, 1 0))", "MULTISURFACE (POLYGON ((0 0,1 0)),POLYGON ((0 0,1 0)))"}) {
    try {
      (void)read_plane_set(text, PlaneFormat::Wkt, named(), context);
      ADD_FAILURE() << "was read: " << text;
    } catch (const Error& error) {
      EXPECT_EQ(error.message().find("this is"), std::string::npos) << error.what();
    }
  }
}

/// Words of a kind may occur as names in another one: what comes first tells the kind.
TEST(foreign_files, the_first_word_tells_the_kind) {
  EXPECT_EQ(foreign_kind(R"({"type": "FeatureCollection", "properties": {"asset": 1})", "GeoJSON"),
            std::nullopt);
  EXPECT_EQ(foreign_kind(R"({"asset": {"version": "2.0"}, "extras": {"rings": 1})", "glTF"),
            std::nullopt);
  EXPECT_EQ(foreign_kind("mtllib \"POLYGON\".mtl\nv 0 0 0\n", "OBJ"), std::nullopt);
}

/// A program whose command reads solids gives advice for solids, whatever it took the file for.
TEST(foreign_files, advice_is_for_the_readers_given) {
  EXPECT_EQ(foreign_kind("OFF\n", "WKT"), "this is OFF; plumb solid reads it");
  EXPECT_EQ(foreign_kind("OFF\n", "WKT", FileReaders::Solids),
            "this is OFF; give the file the extension .off");
  EXPECT_EQ(foreign_kind("<svg/>", "GeoJSON TopoJSON WKT WKB"),
            "this is an SVG drawing; plumb plane reads it");
}

}  // namespace
}  // namespace plumb
