// Layers in GeoJSON and TopoJSON.

#include "plumb/io/layer_io.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "plumb/predicates/error.h"

namespace plumb::layer_io_test {
namespace {

using Json = nlohmann::json;

Layer read(const std::string& text, const std::string& object = "") {
  return read_layer(text, {"some.file", object}).layer;
}

std::string written(const Layer& layer) {
  std::ostringstream out;
  write_layer_geojson(out, layer);
  return out.str();
}

std::string feature(const std::string& members, const std::string& geometry) {
  return R"({"type":"Feature",)" + members + R"("geometry":)" + geometry + '}';
}

std::string collection(const std::string& features) {
  return R"({"type":"FeatureCollection","features":[)" + features + "]}";
}

const std::string kSquare = R"({"type":"Polygon","coordinates":[[[0,0],[4,0],[4,4],[0,4],[0,0]]]})";

TEST(LayerReader, keeps_ids_and_properties) {
  const std::string properties =
      R"({"name":"a \"b\" ]}","n":[1,{"x":"\\"}],"big":12345678901234567890})";
  const Layer layer = read(
      collection(feature(R"("id":"DE","properties":)" + properties + ',', kSquare) + ',' +
                 feature(R"("id":7,"properties":null,)", "null") + ',' + feature("", kSquare)));
  ASSERT_EQ(layer.feature_count(), 3U);
  EXPECT_EQ(layer.id(0), "\"DE\"");
  EXPECT_EQ(layer.properties(0), properties);
  EXPECT_EQ(layer.id(1), "7");
  EXPECT_EQ(layer.properties(1), "null");
  EXPECT_EQ(layer.id(2), "");
  EXPECT_EQ(layer.polygon_count(), 2U);
  const std::string text = written(layer);
  EXPECT_EQ(written(read(text)), text);
  EXPECT_EQ(Json::parse(text)["features"][0]["geometry"], Json::parse(kSquare));
  EXPECT_TRUE(Json::parse(text)["features"][1]["geometry"].is_null());
}

TEST(LayerReader, reads_polygons_in_any_nesting) {
  const std::string multi = R"({"type":"MultiPolygon","coordinates":[[[[0,0],[1,0],[0,1],[0,0]]],)"
                            R"([[[5,5],[9,5],[5,9],[5,5]],[[6,6],[6,7],[7,6],[6,6]]]]})";
  const Layer layer = read(R"({"type":"GeometryCollection","geometries":[)" + multi + ',' +
                           kSquare + R"(,{"type":"Point","coordinates":[1,2]}]})");
  EXPECT_EQ(layer.feature_count(), 1U);
  EXPECT_EQ(layer.polygon_count(), 3U);
  EXPECT_EQ(layer.ring_count(), 4U);
  EXPECT_EQ(layer.polygon_begin, (std::vector<std::uint32_t>{0, 1, 3, 4}));
}

TEST(LayerReader, reads_sequences_as_one_collection) {
  std::vector<std::string> features;
  for (int i = 0; i < 3; ++i) {
    const std::string x = std::to_string(i), to = std::to_string(i + 1);
    features.push_back(R"({"type":"Feature","id":)" + x + R"(,"properties":{"{\"":"}"},)" +
                       R"("geometry":{"type":"Polygon","coordinates":[[[)" + x + ",0],[" + to +
                       ",0],[" + to + ",1],[" + x + ",0]]]}}");
  }
  const std::string list = features[0] + ',' + features[1] + ',' + features[2];
  const Layer expected =
      read_layer(R"({"type":"FeatureCollection","features":[)" + list + "]}").layer;
  ASSERT_EQ(expected.feature_count(), 3U);
  for (const auto& [before, after] : std::vector<std::pair<std::string, std::string>>{
           {"", "\n"}, {"\x1e", "\n"}, {"\x1e", ""}, {"", ""}, {" ", "\r\n\r\n"}}) {
    std::string text;
    for (const std::string& feature : features) text += before + feature + after;
    EXPECT_TRUE(begins_like_layer(text));
    const Layer layer = read_layer(text).layer;
    ASSERT_EQ(layer.feature_count(), 3U) << text;
    EXPECT_EQ(layer.ring_corners, expected.ring_corners);
    EXPECT_EQ(layer.json, expected.json);
    for (std::uint32_t i = 0; i < layer.points.size(); ++i) {
      EXPECT_EQ(layer.points.approx(i).x, expected.points.approx(i).x);
    }
  }
  // What is wrong with a value is told with its place in the whole text.
  const std::string good = features[0] + '\n';
  for (const auto& [bad, place] : std::vector<std::pair<std::string, std::string>>{
           {R"({"type":"Feature")", "2:18"},
           {R"(  {"type":"Topology","arcs":[]})", "2:3: a Topology after other values"},
           {"[1]", "2:1: expected an object"},
           {R"({"type":"Point"} x)", "2:18"}}) {
    try {
      static_cast<void>(read_layer(good + bad, {.name = "seq", .object = {}}));
      ADD_FAILURE() << bad;
    } catch (const Error& error) {
      EXPECT_NE(std::string(error.what()).find("seq:" + place), std::string::npos) << error.what();
    }
  }
}

TEST(LayerReader, leaves_out_rings_without_three_positions) {
  const LayerFile file = read_layer(feature(
      "", R"({"type":"Polygon","coordinates":[[[0,0],[0,0],[1,0],[0,0]],[],[[1,1],[2,1]]]})"));
  EXPECT_EQ(file.layer.feature_count(), 1U);
  EXPECT_EQ(file.layer.polygon_count(), 0U);
  ASSERT_EQ(file.notes.size(), 1U);
  EXPECT_NE(file.notes[0].find("(3)"), std::string::npos) << file.notes[0];
}

const std::string kTopology =
    R"({"type":"Topology","transform":{"scale":[0.5,0.25],"translate":[10,20]},"arcs":[)"
    R"([[0,0],[0,8]],[[0,8],[-4,0],[0,-8],[4,0]],[[0,0],[4,0],[0,8],[-4,0]]],"objects":{)"
    R"("halves":{"type":"GeometryCollection","geometries":[)"
    R"({"type":"Polygon","arcs":[[0,1]],"id":"west","properties":{"n":1}},)"
    R"({"type":"MultiPolygon","arcs":[[[2,-1]]],"id":"east"},{"type":null}]},)"
    R"("all":{"type":"Polygon","arcs":[[1,2]]}}})";

TEST(LayerReader, joins_the_arcs_of_a_topology) {
  const LayerFile file = read_layer(kTopology);
  const Layer& layer = file.layer;
  ASSERT_EQ(layer.feature_count(), 3U);
  EXPECT_EQ(layer.id(0), "\"west\"");
  EXPECT_EQ(layer.properties(0), R"({"n":1})");
  const Json json = Json::parse(written(layer));
  EXPECT_EQ(json["features"][0]["geometry"]["coordinates"],
            Json::parse("[[[10,20],[10,22],[8,22],[8,20],[10,20]]]"));
  EXPECT_EQ(json["features"][1]["geometry"]["coordinates"],
            Json::parse("[[[10,20],[12,20],[12,22],[10,22],[10,20]]]"));
  ASSERT_EQ(file.notes.size(), 1U);
  EXPECT_NE(file.notes[0].find("objects 'all'"), std::string::npos) << file.notes[0];
  EXPECT_EQ(read(kTopology, "all").feature_count(), 1U);
  EXPECT_TRUE(repair_layer(layer).report.regions.empty());
}

std::string topology_of(const Layer& layer) {
  std::ostringstream out;
  write_layer_topojson(out, layer);
  return out.str();
}

TEST(LayerWriter, shares_arcs_in_topojson) {
  for (const char* const file :
       {"corpus/layers/districts.geojson", "corpus/layers/fields.geojson"}) {
    const Layer layer = repair_layer(read_layer_file(file).layer).layer;
    const std::string text = topology_of(layer);
    EXPECT_EQ(written(repair_layer(read(text)).layer), written(layer))
        << "a repair begins rings at the same corners";
    std::vector<std::pair<Json, Json>> edges;
    const Json topology = Json::parse(text);
    for (const Json& arc : topology["arcs"]) {
      for (std::size_t i = 0; i + 1 < arc.size(); ++i) {
        edges.emplace_back(std::min(arc[i], arc[i + 1]), std::max(arc[i], arc[i + 1]));
      }
    }
    EXPECT_LT(edges.size(), layer.ring_corners.size()) << "rings share edges";
    std::sort(edges.begin(), edges.end());
    EXPECT_EQ(std::unique(edges.begin(), edges.end()), edges.end()) << "each edge is written once";
  }
}

TEST(LayerWriter, keeps_features_without_polygons_in_topojson) {
  const Layer layer = read(collection(feature(R"("id":7,"properties":null,)", "null")));
  const Layer again = read(topology_of(layer));
  ASSERT_EQ(again.feature_count(), 1U);
  EXPECT_EQ(again.id(0), "7");
  EXPECT_EQ(again.polygon_count(), 0U);
}

TEST(LayerWriter, writes_a_feature_a_line_in_wkt) {
  const Layer layer =
      read(collection(feature("", kSquare) + ',' + feature("", "null") + ',' +
                      feature("", R"({"type":"MultiPolygon","coordinates":[[[[0,0],[1,0],)"
                                  R"([0,1],[0,0]]],[[[5,5],[6,5],[5,6.5],[5,5]]]]})")));
  std::ostringstream out;
  write_layer_wkt(out, layer);
  EXPECT_EQ(out.str(),
            "POLYGON ((0 0,4 0,4 4,0 4,0 0))\nPOLYGON EMPTY\n"
            "MULTIPOLYGON (((0 0,1 0,0 1,0 0)),((5 5,6 5,5 6.5,5 5)))\n");
  const Layer again = read(out.str());
  EXPECT_EQ(again.feature_begin, layer.feature_begin);
  EXPECT_EQ(again.polygon_count(), 3U);
}

TEST(LayerReader, takes_a_multipolygon_of_wkt_and_wkb_for_one_feature) {
  const std::string square = "((0 0,4 0,4 4,0 4,0 0))", other = "((5 0,9 0,9 4,5 0))";
  const std::string both = square + ',' + other;
  EXPECT_EQ(read("MULTIPOLYGON(" + both + ")").feature_count(), 1U);
  EXPECT_EQ(read("MULTISURFACE(" + both + ")").feature_count(), 1U);
  EXPECT_EQ(read("TIN(((0 0,4 0,4 4,0 0)),((0 0,4 4,0 4,0 0)))").feature_count(), 2U);
  const Layer mixed = read("POLYGON" + square + "\nMULTIPOLYGON(" + both + ")\nPOLYGON" + other +
                           "GEOMETRYCOLLECTION(POLYGON" + square + ",MULTIPOLYGON(" + both + "))");
  EXPECT_EQ(mixed.feature_begin, (std::vector<std::uint32_t>{0, 1, 3, 4, 5, 7}));
  // A ring that is a point has no polygon in the layer.
  const Layer thin = read("MULTIPOLYGON(((1 1,1 1,1 1,1 1))," + both + ")POLYGON" + square);
  EXPECT_EQ(thin.feature_begin.size(), 3U);
  // The multipolygon of two triangles, of one ring each.
  std::string hex =
      "0106000000"
      "02000000";
  for (int i = 0; i < 2; ++i) {
    hex +=
        "0103000000"
        "01000000"
        "04000000" +
        std::string(32, '0') + std::string(12, '0') + "F03F" + std::string(32, '0') +
        std::string(12, '0') + "F03F" + std::string(32, '0');
  }
  const Layer triangles = read(hex);
  EXPECT_EQ(triangles.feature_count(), 1U);
  EXPECT_EQ(triangles.polygon_count(), 2U);
  EXPECT_EQ(read(hex + '\n' + hex).feature_count(), 2U);
}

TEST(LayerReader, keeps_geometries_without_polygons_as_features) {
  const std::string square = "((0 0,4 0,4 4,0 4,0 0))";
  const Layer layer =
      read("POLYGON EMPTY\nPOLYGON" + square + "\nMULTIPOLYGON EMPTY\nPOLYGON(())\n" +
           "MULTIPOLYGON(EMPTY," + square + ")\nPOINT(1 2)\nPOLYGON" + square);
  EXPECT_EQ(layer.feature_begin, (std::vector<std::uint32_t>{0, 0, 1, 1, 1, 2, 2, 3}));
  // Members of collections are features, and an empty collection is one feature.
  const Layer members = read("GEOMETRYCOLLECTION(POLYGON" + square + ",POLYGON EMPTY,POLYGON" +
                             square + ")GEOMETRYCOLLECTION EMPTY");
  EXPECT_EQ(members.feature_begin, (std::vector<std::uint32_t>{0, 1, 1, 2, 2}));
  EXPECT_EQ(read("TIN EMPTY").feature_count(), 1U);
  // An empty polygon, an empty multipolygon and an empty point in WKB.
  const std::string polygon = "010300000000000000", multi = "010600000000000000";
  const std::string point = "0101000000000000000000F87F000000000000F87F";
  EXPECT_EQ(read(polygon + '\n' + multi + '\n' + point).feature_count(), 3U);
  EXPECT_EQ(read("0106000000"
                 "01000000" +
                 polygon)
                .feature_count(),
            1U);
  EXPECT_EQ(read("0107000000"
                 "02000000" +
                 polygon + multi)
                .feature_count(),
            2U);
  for (const std::string geometry :
       {R"({"type":"Polygon","coordinates":[]})", R"({"type":"MultiPolygon","coordinates":[]})",
        R"({"type":"GeometryCollection","geometries":[]})"}) {
    EXPECT_EQ(read(collection(feature(R"("id":7,)", geometry))).id(0), "7");
  }
}

TEST(LayerReader, keeps_features_whose_geometry_has_no_type) {
  for (const std::string geometry : {R"({"type":null})", R"({"id":"a","type":null})", "{}"}) {
    const LayerFile file = read_layer(collection(
        feature(R"("id":"a","properties":{"x":1},)", geometry) + ',' + feature("", kSquare)));
    EXPECT_EQ(file.layer.feature_begin, (std::vector<std::uint32_t>{0, 0, 1}));
    EXPECT_EQ(file.layer.id(0), "\"a\"");
    EXPECT_EQ(file.notes,
              (std::vector<std::string>{"read as null: geometries without a type (1)"}));
  }
  EXPECT_THROW(read(collection(feature("", R"({"coordinates":[]})"))), Error);
  EXPECT_THROW(read(collection(feature("", R"({"type":7})"))), Error);
  // Null among the geometries of a TopoJSON object.
  const Layer layer =
      read(R"({"type":"Topology","arcs":[[[0,0],[1,0],[1,1],[0,0]]],"objects":{"a":{"type":)"
           R"("GeometryCollection","geometries":[null,{"type":"Polygon","arcs":[[0]],"id":1},)"
           R"({"type":null,"id":2}]}}})");
  EXPECT_EQ(layer.feature_begin, (std::vector<std::uint32_t>{0, 0, 1, 1}));
  EXPECT_EQ(layer.id(0), "");
  EXPECT_EQ(layer.id(2), "2");
  EXPECT_THROW(read(R"({"type":"Topology","arcs":[],"objects":{"a":{"type":)"
                    R"("GeometryCollection","geometries":[7]}}})"),
               Error);
}

TEST(LayerReports, name_features_whose_rings_enclose_nothing) {
  // A ring that runs twice round, a hole that is its outer ring, and a ring without area.
  const Layer layer = read(collection(
      feature("",
              R"({"type":"Polygon","coordinates":[[[0,0],[1,0],[1,1],[0,0],[1,0],[1,1],[0,0]]]})") +
      ',' +
      feature("", R"({"type":"Polygon","coordinates":[[[3,0],[4,0],[4,1],[3,0]],)"
                  R"([[3,0],[4,0],[4,1],[3,0]]]})") +
      ',' + feature("", R"({"type":"Polygon","coordinates":[[[5,0],[6,1],[7,2],[5,0]]]})") + ',' +
      feature("", "null") + ',' + feature("", kSquare)));
  const LayerReport report = repair_layer(layer).report;
  EXPECT_EQ(report.emptied, (std::vector<std::uint32_t>{0, 1, 2}));
  std::ostringstream text;
  write_layer_report_text(text, layer, report);
  EXPECT_NE(text.str().find("feature 2 has no area left\n"), std::string::npos) << text.str();
}

TEST(LayerReports, name_holes_that_do_not_lie_in_their_polygons) {
  const Layer layer = read(collection(
      feature(R"("id":"a",)", R"({"type":"Polygon","coordinates":[[[0,0],[4,0],[4,4],[0,4],[0,0]],)"
                              R"([[6,1],[8,1],[8,2],[6,1]]]})")));
  const LayerReport report = check_layer(layer);
  std::ostringstream text, json, geojson;
  write_layer_report_text(text, layer, report);
  EXPECT_NE(text.str().find("1 nesting\nnesting of feature 1 (\"a\"): a hole lies outside of its "
                            "outer ring, or in another hole, at 6 1\n"),
            std::string::npos)
      << text.str();
  write_layer_report_json(json, layer, report);
  EXPECT_NE(json.str().find(R"("nestings":1)"), std::string::npos) << json.str();
  write_layer_report_geojson(geojson, layer, report);
  EXPECT_NE(geojson.str().find(R"("kind":"nesting")"), std::string::npos);
  EXPECT_NE(geojson.str().find(R"({"type":"Point","coordinates":[6,1]})"), std::string::npos);
}

std::string notes_of(const std::string& text) {
  std::string notes;
  for (const std::string& note : read_layer(text).notes) notes += note + '\n';
  return notes;
}

TEST(LayerReader, reads_properties_that_are_no_numbers_as_null) {
  const std::string text = collection(
      feature(
          R"("id":NaN,"properties":{"NaN":NaN,"a":[-Infinity,1, Infinity],"b":"NaN \"Infinity"},)",
          kSquare) +
      ',' + feature(R"("properties":{"x":-0.5},)", kSquare));
  const Layer layer = read(text);
  EXPECT_EQ(layer.id(0), "null");
  EXPECT_EQ(layer.properties(0), R"({"NaN":null,"a":[null,1, null],"b":"NaN \"Infinity"})");
  EXPECT_EQ(layer.properties(1), R"({"x":-0.5})");
  EXPECT_EQ(notes_of(text), "not JSON, replaced: words such as NaN by null (4)\n");
  for (const char* const bad : {"NaN", "Infinity", "-Infinity"}) {
    try {
      read("\n{\"type\":\"Polygon\",\"coordinates\":[[[0,\n" + std::string(bad) + "]]]}");
      ADD_FAILURE() << bad;
    } catch (const Error& error) {
      EXPECT_EQ(std::string(error.what()),
                "some.file:3:1: a coordinate that is null or not finite");
    }
  }
  EXPECT_EQ(notes_of(collection(feature(R"("properties":{"x":1.#QNAN},)", kSquare))),
            "not JSON, replaced: words such as NaN by null (1)\n");
  EXPECT_THROW(read("NaN"), Error);
}

TEST(LayerReader, names_what_it_passes_over) {
  EXPECT_EQ(notes_of(R"({"type":"Polygon","coordinates":[[[0,0,7],[1,0,7],[0,1,7],[0,0,7]]]})"),
            "passed over: numbers of positions after x and y\n");
  EXPECT_EQ(notes_of(R"({"type":"Topology","arcs":[[[0,0,1],[4,0],[4,4],[0,0]]],"objects":{"a":)"
                     R"({"type":"Polygon","arcs":[[0]]}}})"),
            "passed over: numbers of positions after x and y\n");
  EXPECT_EQ(notes_of(R"({"type":"FeatureCollection","time":1,"bbox":[0,0,4,4],"features":[)" +
                     feature(R"("place":null,)", kSquare) + "]}"),
            "passed over: members 'place', 'time'\n");
}

TEST(LayerReader, keeps_the_name_of_the_coordinate_reference_system) {
  const std::string crs =
      R"("crs":{"type":"name","properties":{"name":"urn:ogc:def:crs:EPSG::2056"}})";
  const LayerFile file = read_layer(R"({"type":"FeatureCollection",)" + crs + R"(,"features":[)" +
                                    feature("", kSquare) + "]}");
  EXPECT_EQ(file.crs, "urn:ogc:def:crs:EPSG::2056");
  EXPECT_TRUE(file.notes.empty());
  std::ostringstream out, report;
  write_layer_geojson(out, file.layer, file.crs);
  EXPECT_EQ(read_layer(out.str()).crs, file.crs);
  write_layer_report_geojson(report, file.layer, check_layer(file.layer), file.crs);
  EXPECT_EQ(Json::parse(report.str())["crs"], Json::parse('{' + crs + '}')["crs"]);
  EXPECT_EQ(notes_of(R"({"type":"FeatureCollection","features":[],"crs":{"type":"link"}})"),
            "passed over: a \"crs\" without a name\n");
}

TEST(LayerReader, prefers_an_object_with_polygons) {
  const LayerFile file =
      read_layer(R"({"type":"Topology","arcs":[[[0,0],[4,0],[4,4],[0,0]]],"objects":{)"
                 R"("places":{"type":"GeometryCollection","geometries":[)"
                 R"({"type":"Point","coordinates":[1,1]}]},)"
                 R"("areas":{"type":"GeometryCollection","geometries":[{"type":null},)"
                 R"({"type":"Polygon","arcs":[[0]]}]}}})");
  EXPECT_EQ(file.layer.feature_count(), 2U);
  ASSERT_EQ(file.notes.size(), 1U);
  EXPECT_NE(file.notes[0].find("objects 'places'"), std::string::npos) << file.notes[0];
}

TEST(LayerReader, closes_rings_of_arcs_with_a_note) {
  const LayerFile file = read_layer(
      R"({"type":"Topology","arcs":[[[0,0],[4,0],[4,4],[0,1]]],"objects":{"a":{"type":"Polygon",)"
      R"("arcs":[[0]]}}})");
  EXPECT_EQ(file.layer.ring(0).size(), 4U);
  ASSERT_EQ(file.notes.size(), 1U);
  EXPECT_NE(file.notes[0].find("closed by an edge"), std::string::npos);
  EXPECT_NE(file.notes[0].find("(1)"), std::string::npos);
}

TEST(LayerReader, names_the_command_that_converts_other_formats) {
  try {
    read_layer_file("some/parcels.parquet");
    ADD_FAILURE();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::UnknownFormat);
    EXPECT_NE(std::string(error.what()).find("ogr2ogr -f GeoJSON"), std::string::npos);
  }
  EXPECT_TRUE(begins_like_layer(" {"));
  EXPECT_TRUE(begins_like_layer("polygon ((0 0"));
  EXPECT_FALSE(begins_like_layer("4 1\n0 0"));
}

TEST(LayerReader, calls_features_by_ids_and_names) {
  const Layer layer = read(collection(
      feature(R"("id":"FR","properties":{"name":"Fr\u00e9"},)", "null") + ',' +
      feature(R"("properties":{"NAME":"x","name":3},)", "null") + ',' + feature("", "null")));
  EXPECT_EQ(feature_title(layer, 0), R"(feature 1 ("FR", "Fr\u00e9"))");
  EXPECT_EQ(feature_title(layer, 1), R"(feature 2 ("x"))");
  EXPECT_EQ(feature_title(layer, 2), "feature 3");
}

TEST(LayerReader, refuses_with_the_place) {
  const std::vector<std::pair<std::string, std::string>> wrong{
      {"", "some.file:1:1"},
      {"[]", "some.file:1:1: expected an object"},
      {"{\"type\":7}", "some.file:1:1: an object without"},
      {"{\"type\":\"Curve\"}", "some.file:1:1: expected a geometry, found 'Curve'"},
      {R"({"type":"Feature","properties":null,"geometry":5})",
       "some.file:1:48: expected a geometry or null"},
      {"{\"type\":\"FeatureCollection\"}", "some.file:1:1: expected a list \"features\""},
      {collection("\n7"), "some.file:2:1: expected an object"},
      {collection("\n" + kSquare), "some.file:2:1: expected a Feature"},
      {R"({"type":"Polygon","coordinates":[[
[0]]]})",
       "some.file:2:1: a position needs two numbers"},
      {R"({"type":"Polygon","coordinates":[[[0,
"1"]]]})",
       "some.file:2:1: expected a number"},
      {R"({"type":"Polygon","coordinates":[[[0,1e999]]]})", "some.file:1:"},
      {R"({"type":"Topology","arcs":[],"objects":{"a":{"type":"Polygon","arcs":[[
0]]}}})",
       "some.file:2:1: there is no such arc"},
      {R"({"type":"Topology","arcs":[],"objects":{"a":{"type":"Polygon","arcs":[[-1.5]]}}})",
       "some.file:1:72: there is no such arc"},
      {R"({"type":"Topology","arcs":[],"objects":{}})", "some.file: the file has no object"},
  };
  for (const auto& [text, message] : wrong) {
    try {
      read(text);
      ADD_FAILURE() << "accepted: " << text;
    } catch (const Error& error) {
      EXPECT_TRUE(std::string(error.what()).starts_with(message)) << error.what() << '\n' << text;
    }
  }
}

TEST(LayerReader, says_which_objects_there_are) {
  try {
    read(kTopology, "none");
    ADD_FAILURE();
  } catch (const Error& error) {
    EXPECT_EQ(std::string(error.what()),
              "some.file: there is no object 'none'; the file has 'halves', 'all'");
  }
}

TEST(LayerReader, survives_every_cut) {
  for (std::size_t size = 0; size < kTopology.size(); ++size) {
    EXPECT_THROW(read(kTopology.substr(0, size)), Error) << size;
  }
}

}  // namespace
}  // namespace plumb::layer_io_test
