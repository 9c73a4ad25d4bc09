// The commands `plumb map check` of polygons and `plumb map overlay` from outside.

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "plumb/predicates/rational.h"
#include "refusal.h"
#include "run_program.h"

namespace plumb::testing::map_commands_test {
namespace {

using Json = nlohmann::json;
using Words = std::vector<std::string>;

const std::string kStates = "corpus/maps/us-states.clean.map";
const std::string kCounties = "corpus/maps/us-counties.clean.map";
const std::string kDefective = "corpus/maps/us-counties.map";

/// Twice the signed areas of the cycles of a map of integers, in 64 bits: the twin of the engine's.
std::vector<std::int64_t> twice_cycle_areas(const std::string& file) {
  std::ifstream in(file);
  std::size_t n = 0, f = 0;
  in >> n >> f;
  std::vector<std::pair<std::int64_t, std::int64_t>> points(n);
  for (auto& [x, y] : points) in >> x >> y;
  std::string line;
  std::getline(in, line);
  std::vector<std::int64_t> areas;
  while (areas.size() < f && std::getline(in, line)) {
    std::istringstream words(line);
    std::vector<std::size_t> cycle;
    for (std::size_t v = 0; words >> v;) cycle.push_back(v - 1);
    if (cycle.empty()) continue;
    std::int64_t sum = 0;
    for (std::size_t i = 0; i < cycle.size(); ++i) {
      const auto [ax, ay] = points[cycle[i]];
      const auto [bx, by] = points[cycle[(i + 1) % cycle.size()]];
      sum += ax * by - ay * bx;
    }
    areas.push_back(sum);
  }
  return areas;
}

/// By the cycle around it (1-based): the area of every bounded region, holes taken off.
std::map<std::uint64_t, Rational> region_areas(const std::string& file) {
  const std::vector<std::int64_t> twice = twice_cycle_areas(file);
  const Json report = Json::parse(run({"map", "check", file, "--json"}).out);
  std::map<std::uint64_t, Rational> areas;
  for (const Json& region : report["regions"]) {
    if (region["outer"].is_null()) continue;
    const std::uint64_t outer = region["outer"];
    std::int64_t sum = twice[outer - 1];
    for (const std::uint64_t hole : region["holes"]) sum += twice[hole - 1];
    areas[outer] = Rational(sum) / 2;
  }
  return areas;
}

std::string feature(const std::string& rings) {
  return R"({"type":"Feature","properties":{},"geometry":{"type":"Polygon","coordinates":[)" +
         rings + "]}}";
}

std::string collection(const std::string& first, const std::string& second) {
  return R"({"type":"FeatureCollection","features":[)" + feature(first) + "," + feature(second) +
         "]}";
}

const std::string kLeft = "[[0,0],[10,0],[10,3],[10,7],[10,10],[0,10],[0,0]]";

TEST(MapCheckOfPolygons, names_features_and_coordinates_of_a_gap) {
  const ScratchDirectory scratch;
  const fs::path file = scratch / "gap.geojson";
  write_file(file,
             collection(kLeft, "[[10,0],[20,0],[20,10],[10,10],[10,7],[11,5],[10,3],[10,0]]"));
  const RunResult result = run({"map", "check", file.string(), "--edges", "-q"});
  EXPECT_EQ(result.code, 1);
  EXPECT_TRUE(result.out.starts_with("open\n1. open; face 1;")) << result.out;
  EXPECT_TRUE(contains(result.out,
                       "gap of 3 edges in the coverage; list the missing face "
                       "(10,7) (10,3) (11,5)\n"))
      << result.out;
}

TEST(MapCheckOfPolygons, names_features_that_overlap) {
  const ScratchDirectory scratch;
  const fs::path file = scratch / "overlap.json";
  write_file(file, collection(kLeft, "[[10,0],[20,0],[20,10],[10,10],[10,7],[9,5],[10,3],[10,0]]"));
  const RunResult result = run({"map", "check", file.string(), "--edges", "-q"});
  EXPECT_EQ(result.code, 1);
  EXPECT_TRUE(contains(result.out, "regions 1 and 2 overlap between vertices (10,3) and (10,7)"))
      << result.out;
}

TEST(MapCheckOfPolygons, accepts_a_coverage_with_a_hole_that_touches) {
  const ScratchDirectory scratch;
  const fs::path file = scratch / "coverage.txt";
  write_file(file,
             "MULTIPOLYGON (((0 0, 5 0, 10 0, 10 10, 0 10, 0 0), (5 0, 3 4, 7 4, 5 0)), "
             "((5 0, 7 4, 3 4, 5 0)))");
  const RunResult result = run({"map", "check", file.string(), "--edges", "--json"});
  EXPECT_EQ(result.code, 0) << result.out << result.err;
  EXPECT_EQ(Json::parse(result.out)["regions"],
            Json::parse(
                R"([{"outer":null,"holes":[4]},{"outer":1,"holes":[3]},{"outer":2,"holes":[]}])"));
  EXPECT_EQ(run({"map", "check", file.string(), "--outer", "listed"}).code, 1);
}

/// What a difference writes is a region of a map.
TEST(MapCheckOfPolygons, accepts_what_a_difference_writes) {
  const ScratchDirectory scratch;
  write_file(scratch / "square.wkt", "POLYGON ((0 0, 10 0, 10 10, 0 10, 0 0))");
  write_file(scratch / "hole.wkt", "POLYGON ((5 0, 7 4, 3 4, 5 0))");
  const std::string rest = (scratch / "rest.wkt").string();
  ASSERT_EQ(run({"plane", "difference", (scratch / "square.wkt").string(),
                 (scratch / "hole.wkt").string(), "-o", rest, "-q"})
                .code,
            0);
  const RunResult result = run({"map", "check", rest, "--outer", "ignore", "--json"});
  EXPECT_EQ(result.code, 0) << result.out << result.err;
}

/// The area of a GeoJSON polygon, holes taken off.
double polygon_area(const Json& rings) {
  double sum = 0;
  for (const Json& ring : rings) {
    EXPECT_EQ(ring.front(), ring.back());
    const double x0 = ring[0][0], y0 = ring[0][1];
    for (std::size_t i = 0; i + 1 < ring.size(); ++i) {
      const double ax = ring[i][0], ay = ring[i][1], bx = ring[i + 1][0], by = ring[i + 1][1];
      sum += (ax - x0) * (by - y0) - (ay - y0) * (bx - x0);
    }
  }
  return sum / 2;
}

TEST(MapOverlayProgram, areas_of_states_over_counties_add_up_exactly) {
  const ScratchDirectory scratch;
  const std::string file = (scratch / "cells.geojson").string();
  const RunResult result = run({"map", "overlay", kStates, kCounties, "-o", file, "--json"});
  ASSERT_EQ(result.code, 0) << result.err;
  RecordProperty("seconds", std::to_string(result.user_seconds));
  const Json summary = Json::parse(result.out);
  EXPECT_EQ(summary["areas_add_up"], true);
  const Json cells = Json::parse(read_file(file));
  EXPECT_EQ(cells["features"].size() + 1, summary["faces"]);
  std::map<std::string, std::map<std::uint64_t, Rational>> sums;
  Rational both = 0;
  for (const Json& cell : cells["features"]) {
    const Json& properties = cell["properties"];
    const Rational area(properties["area"]["exact"].get<std::string>());
    EXPECT_GT(area, 0);
    for (const char* map : {"a", "b"}) {
      if (!properties[map].is_null()) sums[map][properties[map].get<std::uint64_t>()] += area;
    }
    if (!properties["a"].is_null() && !properties["b"].is_null()) both += area;
    const double told = properties["area"]["double"];
    EXPECT_NEAR(polygon_area(cell["geometry"]["coordinates"]), told, 1e-6 * told + 1e-3);
  }
  EXPECT_EQ(sums["a"], region_areas(kStates));
  EXPECT_EQ(sums["b"], region_areas(kCounties));
  EXPECT_EQ(both, Rational(summary["both"]["area"]["exact"].get<std::string>()));
}

TEST(MapOverlayProgram, counts_are_the_same_both_ways_round) {
  const Json ab = Json::parse(run({"map", "overlay", kStates, kCounties, "--json"}).out);
  const Json ba = Json::parse(run({"map", "overlay", kCounties, kStates, "--json"}).out);
  for (const char* key : {"vertices", "edges", "faces", "both", "neither"}) {
    EXPECT_EQ(ab[key], ba[key]) << key;
  }
  EXPECT_EQ(ab["a"], ba["b"]);
  EXPECT_EQ(ab["only_a"], ba["only_b"]);
}

TEST(MapOverlayProgram, a_map_over_itself_is_itself) {
  const Json json = Json::parse(run({"map", "overlay", kStates, kStates, "--json"}).out);
  EXPECT_EQ(json["a"], json["b"]);
  EXPECT_EQ(json["both"]["cells"], json["a"]["regions"]);
  EXPECT_EQ(json["both"]["area"], json["a"]["area"]);
  EXPECT_EQ(json["only_a"]["cells"], 0);
  EXPECT_EQ(json["only_b"]["cells"], 0);
}

TEST(MapOverlayProgram, writes_what_is_asked_where_it_is_asked) {
  const ScratchDirectory scratch;
  const std::string svg = (scratch / "out.svg").string();
  const RunResult result = run({"map", "overlay", kStates, kStates, "-o", svg});
  EXPECT_EQ(result.code, 0) << result.err;
  EXPECT_EQ(result.out, "");
  EXPECT_TRUE(read_file(svg).starts_with("<svg"));
  const RunResult text = run({"map", "overlay", kStates, kStates});
  EXPECT_TRUE(contains(text.out, "add up to every region's, exactly")) << text.out;
  const RunResult piped = run({"map", "overlay", kStates, kStates, "-o", "-", "--format", "svg"});
  EXPECT_EQ(piped.out, read_file(svg));
}

/// Strips that are turned against each other: crossings are no doubles.
TEST(MapOverlayProgram, rounds_all_cells_together) {
  const ScratchDirectory scratch;
  const std::string a = (scratch / "a.map").string(), b = (scratch / "b.map").string();
  write_file(a, "6 2\n0 0\n0.3 0\n1 0\n1 1\n0.7 1\n0 1\n1 2 5 6\n2 3 4 5\n");
  write_file(b, "6 2\n0 0\n1 0\n1 0.9\n1 1\n0 1\n0 0.1\n1 2 3 6\n6 3 4 5\n");
  const Words overlay{"map", "overlay", a, b, "--infer-outer", "--format", "geojson"};
  const auto with = [&](const Words& more) {
    Words arguments = overlay;
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run(arguments);
  };
  const RunResult rounded = with({"--strict"});
  EXPECT_EQ(rounded.code, 0);
  EXPECT_EQ(Json::parse(rounded.out)["features"].size(), 4U);
  EXPECT_EQ(with({"--raw"}).out, rounded.out) << "nothing breaks here";
  // On a grid of halves the four cells remain, with corners at multiples of a half.
  const RunResult coarse = with({"--grid", "1/2"});
  EXPECT_EQ(coarse.code, 0);
  const Json written = Json::parse(coarse.out);
  for (const Json& feature : written["features"]) {
    for (const Json& ring : feature["geometry"]["coordinates"]) {
      for (const Json& position : ring) {
        for (const Json& c : position)
          EXPECT_EQ(c.get<double>() * 2, std::round(c.get<double>() * 2));
      }
    }
  }
  const RunResult collapsed = with({"--grid", "3", "--strict"});
  EXPECT_EQ(collapsed.code, 2);
  EXPECT_TRUE(contains(collapsed.err, "rounding to the grid changed the shape")) << collapsed.err;
  EXPECT_EQ(with({"--grid", "0"}).code, 2);
  EXPECT_EQ(run({"map", "overlay", a, b, "--infer-outer", "--raw"}).code, 2);
}

TEST(MapOverlayProgram, refuses_what_it_cannot_overlay) {
  const ScratchDirectory scratch;
  const std::string out = (scratch / "out.geojson").string();
  const std::vector<std::pair<Words, std::string>> wrong{
      {{kStates, kDefective}, kDefective + ": no planar subdivision to overlay: not a planar"},
      {{kDefective, kStates}, kDefective + ": "},
      {{kStates, "no/such.map"}, "no/such.map: "},
      {{kStates}, "plumb: "},
      {{"-", "-"}, "plumb: only one of the maps"},
      {{kStates, kStates, "--format", "pdf"}, "plumb: --format: 'pdf' is none of text, json, svg"},
  };
  for (const auto& [files, message] : wrong) {
    Words arguments{"map", "overlay"};
    arguments.insert(arguments.end(), files.begin(), files.end());
    arguments.insert(arguments.end(), {"-o", out, "--json"});
    const RunResult result = run(arguments);
    EXPECT_EQ(result.code, 2) << message;
    EXPECT_EQ(result.out, "");
    EXPECT_TRUE(told_by(result).starts_with(message)) << result.err;
    EXPECT_EQ(scratch.files(), Words{});
  }
}

TEST(MapOverlayProgram, stops_at_its_limits) {
  const ScratchDirectory scratch;
  const RunResult result = run({"map", "overlay", kStates, kCounties, "--limit-seconds", "0.000001",
                                "-o", (scratch / "out.svg").string()});
  EXPECT_EQ(result.code, 3);
  EXPECT_EQ(scratch.files(), Words{});
}

TEST(MapOverlayProgram, completes_outer_boundaries_on_request) {
  const ScratchDirectory scratch;
  const std::string open = (scratch / "open.map").string();
  write_file(open, "4 1\n0 0\n3 0\n3 1\n0 1\n1 2 3 4\n");
  EXPECT_EQ(run({"map", "overlay", open, open}).code, 2);
  const RunResult result = run({"map", "overlay", open, open, "--infer-outer", "--json"});
  ASSERT_EQ(result.code, 0) << result.err;
  EXPECT_EQ(Json::parse(result.out)["both"]["area"]["exact"], "3");
}

}  // namespace
}  // namespace plumb::testing::map_commands_test
