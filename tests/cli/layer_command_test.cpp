// The command `plumb map repair` from outside.

#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "refusal.h"
#include "run_program.h"

namespace plumb::testing::layer_command_test {
namespace {

using Json = nlohmann::json;

const std::string kFields = "corpus/layers/fields.geojson";

TEST(MapRepairProgram, writes_a_coverage_with_ids_and_properties) {
  const ScratchDirectory scratch;
  const std::string out = (scratch / "out.geojson").string();
  const RunResult result = run({"map", "repair", kFields, "-o", out, "--json"});
  ASSERT_EQ(result.code, 0) << result.err;
  const Json report = Json::parse(result.out);
  EXPECT_EQ(report["features"], 4);
  EXPECT_GE(report["overlaps"], 2);
  const Json before = Json::parse(read_file(kFields)), after = Json::parse(read_file(out));
  ASSERT_EQ(after["features"].size(), 4U);
  for (std::size_t f = 0; f < 4; ++f) {
    EXPECT_EQ(after["features"][f]["id"], before["features"][f]["id"]);
    EXPECT_EQ(after["features"][f]["properties"], before["features"][f]["properties"]);
  }
  const RunResult checked = run({"map", "check", out});
  EXPECT_EQ(checked.out.find("superposed"), std::string::npos) << checked.out;
  const RunResult again = run({"map", "repair", out, "-o", "-", "--format", "geojson"});
  EXPECT_EQ(again.out, read_file(out)) << "a second repair changes nothing";
}

TEST(MapRepairProgram, dry_run_says_whether_there_are_defects) {
  const RunResult broken = run({"map", "repair", kFields, "--dry-run"});
  EXPECT_EQ(broken.code, 1);
  EXPECT_TRUE(contains(broken.out, "overlap of feature 1 (\"north\"), feature 2 (\"south\"): area"))
      << broken.out;
  EXPECT_TRUE(contains(broken.out, "; goes to feature 4 (\"pond\")")) << broken.out;
  const ScratchDirectory scratch;
  const std::string out = (scratch / "out.geojson").string();
  ASSERT_EQ(run({"map", "repair", kFields, "-o", out}).code, 0);
  EXPECT_EQ(run({"map", "repair", out, "--dry-run"}).code, 0);
}

TEST(MapRepairProgram, changes_are_a_layer_of_their_own) {
  const RunResult result = run({"map", "repair", kFields, "--changes", "-", "--rule", "first"});
  ASSERT_EQ(result.code, 0) << result.err;
  const Json changes = Json::parse(result.out);
  const Json report = Json::parse(run({"map", "repair", kFields, "--json", "--rule", "first"}).out);
  ASSERT_EQ(changes["features"].size(), report["regions"].size());
  for (std::size_t i = 0; i < report["regions"].size(); ++i) {
    EXPECT_EQ(changes["features"][i]["properties"], report["regions"][i]);
    EXPECT_FALSE(changes["features"][i]["geometry"].is_null());
  }
}

/// The only region of a layer of two features with the ids 10 and 9, and the options.
Json only_region(const std::vector<std::string>& options) {
  const ScratchDirectory scratch;
  const std::string file = (scratch / "pair.geojson").string();
  write_file(file, R"({"type":"FeatureCollection","features":[
{"type":"Feature","id":10,"properties":{"name":"flat"},"geometry":{"type":"Polygon","coordinates":
[[[0,0],[10,0],[10,2],[0,2],[0,0]]]}},
{"type":"Feature","id":9,"properties":{"name":"high"},"geometry":{"type":"Polygon","coordinates":
[[[8,0],[12,0],[12,9],[8,9],[8,0]]]}}]})");
  std::vector<std::string> arguments{"map", "repair", file, "--json", "--dry-run"};
  arguments.insert(arguments.end(), options.begin(), options.end());
  const RunResult dry = run(arguments);
  EXPECT_EQ(dry.code, 1) << dry.err;
  arguments[4] = "-o";
  arguments.insert(arguments.begin() + 5, (scratch / "out.geojson").string());
  EXPECT_EQ(run(arguments).out, dry.out) << "--dry-run reports what repair does";
  const Json regions = Json::parse(dry.out)["regions"];
  EXPECT_EQ(regions.size(), 1U);
  return regions[0];
}

TEST(MapRepairProgram, ids_and_names_select_owners) {
  EXPECT_EQ(only_region({"--rule", "first"})["to"]["id"], 10);
  EXPECT_EQ(only_region({"--rule", "lowest-id"})["to"]["id"], 9) << "numbers, not texts";
  EXPECT_EQ(only_region({"--rule", "largest"})["to"]["id"], 9);
  EXPECT_EQ(only_region({"--rule", "largest", "--prefer", "10", "9"})["to"]["id"], 10);
  EXPECT_EQ(only_region({"--prefer", "flat", "high"})["to"]["id"], 10);
  expect_refusal(run({"map", "repair", kFields, "--prefer", "north", "west"}),
                 "plumb: ", "no feature has the id or the name 'west'");
}

TEST(MapRepairProgram, fills_gaps_that_open_outwards) {
  const ScratchDirectory scratch;
  const std::string file = (scratch / "channel.geojson").string();
  write_file(file, R"({"type":"FeatureCollection","features":[
{"type":"Feature","id":"a","properties":null,"geometry":{"type":"Polygon","coordinates":
[[[0,0],[4,0],[4,9],[0,9],[0,0]]]}},
{"type":"Feature","id":"b","properties":null,"geometry":{"type":"Polygon","coordinates":
[[[4.25,0],[9,0],[9,9],[4.25,9],[4.25,0]]]}}]})");
  EXPECT_EQ(run({"map", "check", file}).code, 0);
  const RunResult checked = run({"map", "check", file, "--gaps-below", "0.5"});
  EXPECT_EQ(checked.code, 1);
  EXPECT_TRUE(contains(checked.out,
                       "open gap between feature 1 (\"a\"), feature 2 (\"b\"): "
                       "area 2.25, width 0.24324324324324326, at 4 0"))
      << checked.out;
  EXPECT_EQ(run({"map", "check", file, "--gaps-below", "0.5", "--enclosed-only"}).code, 0);
  const std::string out = (scratch / "out.geojson").string();
  ASSERT_EQ(run({"map", "repair", file, "--gaps-below", "0.5", "-o", out}).code, 0);
  EXPECT_EQ(run({"map", "check", out, "--gaps-below", "0.5"}).code, 0);
  EXPECT_EQ(
      run({"map", "repair", file, "--gaps-below", "0.5", "--enclosed-only", "--dry-run"}).code, 0);
}

TEST(MapRepairProgram, refuses_what_it_cannot_do) {
  const ScratchDirectory scratch;
  const std::string out = (scratch / "out.geojson").string();
  expect_refusal(run({"map", "repair", kFields, "-o", out, "--dry-run"}),
                 "plumb: ", "--dry-run writes no layer");
  expect_refusal(run({"map", "repair", kFields, "-o", "x.svg"}), "x.svg: ", "no format has");
  expect_refusal(run({"map", "repair", "corpus/maps/us-states.map", "-o", out}),
                 "corpus/maps/us-states.map:1:", "JSON");
  expect_refusal(run({"map", "repair", kFields, "--gaps-below", "-1"}), "plumb: ", "--gaps-below");
  EXPECT_TRUE(scratch.files().empty());
}

// --------------------------------------------------- check, dissolve, simplify, overlay

const std::string kDistricts = "corpus/layers/districts.geojson";

TEST(MapCheckOfLayers, reports_regions) {
  const RunResult broken = run({"map", "check", kFields});
  EXPECT_EQ(broken.code, 1);
  EXPECT_TRUE(broken.out.starts_with("4 features, 2 overlaps, 0 gaps")) << broken.out;
  EXPECT_EQ(broken.out.find("goes to"), std::string::npos);
  EXPECT_EQ(run({"map", "check", kFields, "--gaps-below", "1", "--json"}).out.find("\"gaps\":0"),
            std::string::npos)
      << "the hole is a gap if wide gaps are wanted";
  EXPECT_EQ(run({"map", "check", kDistricts}).code, 0) << "a lake is no defect";
  EXPECT_EQ(run({"map", "check", kDistricts, "--gaps-below", "100"}).code, 1);
}

/// A layer without polygons would be free of defects; features without a geometry may be there.
TEST(MapCheckOfLayers, points_and_lines_alone_are_no_layer) {
  const ScratchDirectory scratch;
  const auto file = [&](const std::string& name, const std::string& text) {
    const std::string path = (scratch / name).string();
    write_file(path, text);
    return path;
  };
  const std::string line =
      file("a.geojson", R"({"type": "LineString", "coordinates": [[0, 0], [1, 1]]})");
  const std::string points = file("b.wkt", "MULTIPOINT (0 0, 1 1)");
  for (const std::string& path : {line, points}) {
    expect_refusal(run({"map", "check", path}), path, "points or lines, but no polygons");
    expect_refusal(run({"map", "dissolve", path, "-o", (scratch / "o.geojson").string()}), path,
                   "plumb plane reads it");
  }
  const std::string nothing =
      file("c.geojson", R"({"type": "Feature", "properties": {}, "geometry": null})");
  EXPECT_EQ(run({"map", "check", nothing}).code, 0);
}

TEST(MapCheckOfLayers, writes_defects_as_geojson_and_pages) {
  const ScratchDirectory scratch;
  const std::string defects = (scratch / "defects.geojson").string();
  const std::string page = (scratch / "page.html").string();
  EXPECT_EQ(
      run({"map", "check", kFields, "-o", defects, "--svg", (scratch / "a.svg").string()}).code, 1);
  const Json json = Json::parse(read_file(defects));
  ASSERT_EQ(json["features"].size(), 3U);
  EXPECT_EQ(json["features"][1]["properties"]["area"], 9);
  EXPECT_EQ(json["features"][1]["properties"]["features"][1]["id"], "pond");
  EXPECT_EQ(run({"map", "check", kFields, "-o", page}).code, 1);
  EXPECT_TRUE(contains(read_file(page), "<details id=\"r1\">"));
  EXPECT_EQ(run({"map", "check", "corpus/maps/us-states.map", "-o", page}).code, 1);
  EXPECT_TRUE(contains(read_file(page), "<!DOCTYPE html>"));
}

TEST(MapDissolve, unites_features_and_adds_numbers) {
  const RunResult result = run(
      {"map", "dissolve", kDistricts, "--by", "state", "--sum", "people", "--format", "geojson"});
  ASSERT_EQ(result.code, 0) << result.err;
  const Json features = Json::parse(result.out)["features"];
  ASSERT_EQ(features.size(), 2U);
  EXPECT_EQ(features[0]["properties"], Json::parse(R"({"state":"west","people":20008})"));
  expect_refusal(run({"map", "dissolve", kDistricts, "--by", "crop"}), "plumb: ", "no feature has");
  expect_refusal(run({"map", "dissolve", kDistricts, "--sum", "name"}), "plumb: ", "is no number");
  const RunResult overlaps = run({"map", "dissolve", kFields, "--by", "crop"});
  EXPECT_TRUE(contains(overlaps.err, "2 overlaps went to the first feature")) << overlaps.err;
}

TEST(MapSimplify, keeps_features_and_stays_a_coverage) {
  const ScratchDirectory scratch;
  const std::string out = (scratch / "out.topojson").string();
  const RunResult result =
      run({"map", "simplify", kDistricts, "--percent", "40", "-o", out, "--json"});
  ASSERT_EQ(result.code, 0) << result.err;
  const Json json = Json::parse(result.out);
  EXPECT_EQ(json["features"], 6);
  const std::size_t before = json["corners_before"], fixed = json["fixed"];
  EXPECT_EQ(json["corners_after"], fixed + (2 * (before - fixed) + 4) / 5) << "40 % of the others";
  EXPECT_EQ(run({"map", "check", out}).code, 0);
  expect_refusal(run({"map", "simplify", kDistricts}),
                 "plumb: ", "--tolerance AREA, --percent P or --within D");
  const Json near =
      Json::parse(run({"map", "simplify", kDistricts, "--within", "0.2", "--json"}).out);
  EXPECT_LE(near["borders_moved_by"], 0.2);
  EXPECT_LT(near["corners_after"], near["corners_before"]);
  expect_refusal(run({"map", "simplify", kDistricts, "--percent", "101"}), "plumb: ", "--percent");
}

TEST(MapOverlayOfLayers, carries_the_properties_of_both) {
  const ScratchDirectory scratch;
  const std::string out = (scratch / "out.geojson").string();
  const RunResult result = run(
      {"map", "overlay", kDistricts, kFields, "--keep", "both", "--areas", "-o", out, "--json"});
  ASSERT_EQ(result.code, 0) << result.err;
  const Json report = Json::parse(result.out);
  EXPECT_EQ(report["pairs"], report["both"]);
  EXPECT_EQ(report["overlaps"], Json::parse("[0,2]"));
  const Json features = Json::parse(read_file(out))["features"];
  ASSERT_EQ(features.size(), report["pairs"].get<std::size_t>());
  for (const char* const name : {"name", "state", "crop", "id_1", "id_2", "area"}) {
    EXPECT_TRUE(features[0]["properties"].contains(name)) << name;
  }
  EXPECT_EQ(run({"map", "check", out}).code, 0);
}

TEST(MapOverlayOfLayers, says_that_coordinates_are_not_converted) {
  const ScratchDirectory scratch;
  const auto layer_of = [&](const std::string& file, const std::string& crs) {
    const std::string path = (scratch / file).string();
    std::ofstream(path) << R"({"type":"FeatureCollection","crs":{"type":"name","properties":{)"
                        << R"("name":")" << crs << R"("}},"features":[{"type":"Feature",)"
                        << R"("properties":null,"geometry":{"type":"Polygon","coordinates":)"
                        << "[[[0,0],[1,0],[0,1],[0,0]]]}}]}";
    return path;
  };
  const std::string a = layer_of("a.geojson", "urn:ogc:def:crs:EPSG::2056"),
                    b = layer_of("b.geojson", "urn:ogc:def:crs:EPSG::4326"),
                    out = (scratch / "out.geojson").string();
  const RunResult different = run({"map", "overlay", a, b, "-o", out});
  EXPECT_EQ(different.code, 0);
  EXPECT_TRUE(contains(different.err, "coordinates are not converted")) << different.err;
  EXPECT_EQ(Json::parse(read_file(out))["crs"]["properties"]["name"], "urn:ogc:def:crs:EPSG::2056");
  EXPECT_EQ(run({"map", "overlay", a, a, "-o", out}).err, "");
  EXPECT_EQ(run({"map", "check", a}).err, "");
  const RunResult wkt = run({"map", "repair", a, "-o", (scratch / "out.wkt").string()});
  EXPECT_TRUE(contains(wkt.err, "passed over: \"crs\"")) << wkt.err;
}

TEST(MapOverlayOfLayers, refuses_what_does_not_fit) {
  expect_refusal(run({"map", "overlay", kDistricts, "corpus/maps/us-states.map"}),
                 "corpus/maps/us-states.map:1:", "JSON");
  expect_refusal(run({"map", "overlay", kDistricts, kFields, "--grid", "1"}),
                 "plumb: ", "are for maps");
  expect_refusal(run({"map", "overlay", "a.kmz", kFields}), "a.kmz: ", "ogr2ogr");
  expect_refusal(run({"map", "check", "a.parquet"}), "a.parquet: ", "ogr2ogr");
}

// Whether plumb is built with GDAL or not, the command works or names the way.
TEST(LayersOfGdal, go_through_every_command_or_are_refused) {
  const ScratchDirectory scratch;
  const std::string package = (scratch / "fields.gpkg").string();
  const RunResult written = run({"map", "repair", kFields, "-o", package});
  if (written.code == 2) {
    EXPECT_TRUE(contains(written.err, "built without GDAL")) << written.err;
    expect_refusal(run({"map", "check", "a.gpkg"}), "a.gpkg: ", "ogr2ogr");
    expect_refusal(run({"plane", "info", "a.gpkg"}), "a.gpkg: ", "");
    GTEST_SKIP() << "built without GDAL";
  }
  ASSERT_EQ(written.code, 0) << written.err;
  const RunResult direct = run({"map", "repair", kFields, "-o", "-", "--format", "geojson"});
  const RunResult through =
      run({"map", "repair", package, "-o", "-", "--format", "geojson", "--enclosed-only"});
  const Json before = Json::parse(direct.out), after = Json::parse(through.out);
  ASSERT_EQ(after["features"].size(), before["features"].size());
  for (std::size_t f = 0; f < 4; ++f) {
    EXPECT_EQ(after["features"][f]["properties"]["id"], before["features"][f]["id"]);
  }
  EXPECT_EQ(run({"map", "check", package}).code, 0);
  EXPECT_EQ(run({"map", "overlay", package, kFields, "-o", (scratch / "o.fgb").string()}).code, 0);
  EXPECT_EQ(run({"map", "dissolve", package, "-o", (scratch / "d.gpkg").string()}).code, 0);
  EXPECT_EQ(run({"map", "simplify", package, "--percent", "50"}).code, 0);
  const RunResult set = run({"plane", "info", package});
  EXPECT_EQ(set.code, 0) << set.err;
  EXPECT_EQ(run({"map", "check", package, "--object", "none"}).code, 2);
  EXPECT_EQ(run({"map", "check", (scratch / "none.gpkg").string()}).code, 2);
  const std::string shape = (scratch / "s.shp").string();
  EXPECT_EQ(run({"map", "repair", kFields, "-o", shape}).err, "");
  EXPECT_EQ(run({"map", "check", shape}).code, 0);
  expect_refusal(run({"map", "repair", kFields, "-o", "-", "--format", "shp"}),
                 "plumb: ", "several files");
}

}  // namespace
}  // namespace plumb::testing::layer_command_test
