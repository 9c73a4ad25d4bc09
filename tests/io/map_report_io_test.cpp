#include "plumb/io/map_report_io.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>
#include <numeric>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "plumb/io/map_io.h"
#include "plumb/plane/map_check.h"

namespace plumb::map_report_io_test {
namespace {

MapReport report_on(const std::string& text, const MapCheckOptions& options = {}) {
  Context context;
  return check_map(read_map(text, {}, context), options, context);
}

std::string file_text(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

template <class Writer>
std::string written(Writer writer, const MapReport& report) {
  std::ostringstream out;
  writer(out, report);
  return out.str();
}

/// A DCEL listing as read back, by rules of its own: no engine code.
struct Listing {
  struct Halfedge {
    std::size_t origin, twin, face, next, prev;
  };
  std::size_t vertex_count = 0, edge_count = 0, face_count = 0;
  std::vector<std::pair<std::string, std::string>> points{{}};  // 1-based, like all here
  std::vector<std::size_t> of_vertex{0}, of_face{0};
  std::vector<Halfedge> halfedges{{}};

  explicit Listing(const std::string& text) {
    std::istringstream in(text);
    in >> vertex_count >> edge_count >> face_count;
    for (std::size_t v = 0; v < vertex_count; ++v) {
      std::pair<std::string, std::string> point;
      std::size_t h = 0;
      in >> point.first >> point.second >> h;
      points.push_back(point);
      of_vertex.push_back(h);
    }
    for (std::size_t f = 0; f < face_count; ++f) {
      std::size_t h = 0;
      in >> h;
      of_face.push_back(h);
    }
    Halfedge h{};
    while (in >> h.origin >> h.twin >> h.face >> h.next >> h.prev) halfedges.push_back(h);
    EXPECT_TRUE(in.eof());
  }
};

/// Every law of a DCEL, and that it is the one of `cycles`.
void expect_dcel_of(const Listing& list, const Map& map) {
  const std::size_t count = list.halfedges.size() - 1;
  ASSERT_EQ(list.vertex_count, map.vertex_count());
  ASSERT_EQ(list.face_count, map.cycle_count());
  ASSERT_EQ(count, 2 * list.edge_count);
  ASSERT_EQ(count, map.corners.size());
  std::set<std::pair<std::size_t, std::size_t>> directed;
  for (std::size_t h = 1; h <= count; ++h) {
    const Listing::Halfedge& e = list.halfedges[h];
    ASSERT_TRUE(e.twin >= 1 && e.twin <= count && e.next >= 1 && e.next <= count && e.prev >= 1 &&
                e.prev <= count);
    EXPECT_EQ(e.origin, map.corners[h - 1] + 1) << "numbered in input order of use";
    EXPECT_NE(e.twin, h);
    EXPECT_EQ(list.halfedges[e.twin].twin, h);
    EXPECT_EQ(list.halfedges[e.next].prev, h);
    EXPECT_EQ(list.halfedges[e.prev].next, h);
    EXPECT_EQ(list.halfedges[e.next].face, e.face);
    EXPECT_EQ(list.halfedges[e.next].origin, list.halfedges[e.twin].origin);
    EXPECT_TRUE(directed.emplace(e.origin, list.halfedges[e.twin].origin).second);
  }
  for (std::size_t f = 1; f <= list.face_count; ++f) {
    ASSERT_EQ(list.of_face[f], map.cycle_begin[f - 1] + 1);
    std::size_t h = list.of_face[f];
    for (const std::uint32_t vertex : map.cycle(f - 1)) {
      EXPECT_EQ(list.halfedges[h].face, f);
      EXPECT_EQ(list.halfedges[h].origin, vertex + 1);
      h = list.halfedges[h].next;
    }
    EXPECT_EQ(h, list.of_face[f]) << "the cycle closes";
  }
  for (std::size_t v = 1; v <= list.vertex_count; ++v) {
    const std::size_t h = list.of_vertex[v];
    const bool is_used = std::count(map.corners.begin(), map.corners.end(), v - 1) > 0;
    EXPECT_EQ(h != 0, is_used);
    if (h != 0) {
      EXPECT_EQ(list.halfedges[h].origin, v);
    }
  }
}

TEST(MapListing, is_a_dcel_of_the_cycles) {
  const std::vector<std::string> maps{
      "3 2\n0 0\n1 0\n0 1\n1 2 3\n3 2 1\n",
      "5 2\n1/3 0\n1 0.5\n0 9007199254740993\n7 7\n8 8\n1 2 3\n2 1 3\n",  // isolated vertices
      // island
      "8 4\n0 0\n9 0\n9 9\n0 9\n3 3\n6 3\n6 6\n3 6\n1 2 3 4\n4 3 2 1\n5 6 7 8\n8 7 6 5\n",
      "0 0\n",
  };
  for (const std::string& text : maps) {
    const MapReport report = report_on(text);
    ASSERT_EQ(report.verdict, MapVerdict::Valid) << text;
    expect_dcel_of(Listing(written(write_map_report_text, report)), report.map);
  }
}

TEST(MapListing, is_a_dcel_of_a_real_map) {
  const MapReport report = report_on(file_text("corpus/maps/us-states.clean.map"));
  const Listing list(written(write_map_report_text, report));
  ASSERT_EQ(report.verdict, MapVerdict::Valid);
  ASSERT_EQ(list.halfedges.size(), report.map.corners.size() + 1);
  EXPECT_EQ(list.edge_count, report.edges);
  for (std::size_t h = 1; h < list.halfedges.size(); ++h) {
    const Listing::Halfedge& e = list.halfedges[h];
    ASSERT_EQ(list.halfedges[e.twin].twin, h);
    ASSERT_EQ(list.halfedges[e.next].prev, h);
    ASSERT_EQ(list.halfedges[e.next].origin, list.halfedges[e.twin].origin);
  }
}

TEST(MapListing, prints_coordinates_exactly) {
  const MapReport report = report_on("3 2\n1/3 0\n100000 0.1\n0 9007199254740993\n1 2 3\n3 2 1\n");
  const Listing list(written(write_map_report_text, report));
  const std::vector<std::pair<std::string, std::string>> expected{
      {}, {"1/3", "0"}, {"100000", "0.1"}, {"0", "9007199254740993"}};
  EXPECT_EQ(list.points, expected);
}

TEST(MapListing, gives_border_edges_no_twin_when_borders_are_ignored) {
  const MapReport report =
      report_on("4 2\n0 0\n1 0\n1 1\n0 1\n1 2 3\n1 3 4\n", {.outer = OuterRule::Ignore});
  ASSERT_EQ(report.verdict, MapVerdict::Valid);
  const Listing list(written(write_map_report_text, report));
  std::vector<std::size_t> twins;
  for (const Listing::Halfedge& e : list.halfedges) twins.push_back(e.twin);
  EXPECT_EQ(twins, (std::vector<std::size_t>{0, 0, 0, 4, 3, 0, 0}));
}

TEST(MapReportText, says_the_headline_first_then_a_line_per_defect) {
  const std::vector<std::pair<std::string, std::string>> maps{
      {"3 2\n0 0\n1 0\n0 1\n1 2 3\n2 3 1\n", "not a planar subdivision"},
      {"3 1\n0 0\n1 0\n0 1\n1 2 3\n", "open"},
      {"4 2\n0 0\n1 1\n1 0\n0 1\n1 2 3 4\n4 3 2 1\n", "superposed"},
  };
  for (const auto& [text, headline] : maps) {
    const MapReport report = report_on(text);
    std::istringstream lines(written(write_map_report_text, report));
    std::string line;
    std::getline(lines, line);
    EXPECT_EQ(line, headline);
    std::size_t count = 0;
    while (std::getline(lines, line)) {
      EXPECT_TRUE(line.starts_with(std::to_string(++count) + ". ")) << line;
    }
    EXPECT_EQ(count, report.defects.size());
  }
}

nlohmann::json json_of(const std::string& text) {
  return nlohmann::json::parse(written(write_map_report_json, report_on(text)));
}

TEST(MapReportJson, has_the_members_of_the_contract) {
  const auto json = json_of("4 2\n0 0\n3 3\n4 0\n0 3\n1 2 3 4\n4 3 2 1\n");
  EXPECT_EQ(json["verdict"], "superposed");
  EXPECT_EQ(json["vertices"], 4);
  EXPECT_EQ(json["edges"], 4);
  EXPECT_EQ(json["faces"], 2);
  EXPECT_EQ(json["components"], 1);
  EXPECT_EQ(json["counts"]["crossing"], 1);
  EXPECT_EQ(json["counts"]["duplicate"], 0);
  EXPECT_TRUE(json["counts"]["mixed"].is_null());
  EXPECT_FALSE(json.contains("regions"));
  ASSERT_EQ(json["defects"].size(), 1U);
  const auto& defect = json["defects"][0];
  EXPECT_EQ(defect["kind"], "crossing");
  EXPECT_EQ(defect["faces"], (std::vector<int>{1, 2}));
  EXPECT_EQ(defect["edges"].size(), 2U);
  // The diagonal y = x meets 3x + 4y = 12.
  EXPECT_EQ(defect["point"], (std::vector<std::string>{"12/7", "12/7"}));
  EXPECT_EQ(defect["near"], (std::vector<double>{12.0 / 7, 12.0 / 7}));
  EXPECT_TRUE(defect["hint"].is_string());
}

TEST(MapReportJson, lists_regions_with_their_holes) {
  const auto json =
      json_of("8 4\n0 0\n9 0\n9 9\n0 9\n3 3\n6 3\n6 6\n3 6\n1 2 3 4\n4 3 2 1\n5 6 7 8\n8 7 6 5\n");
  EXPECT_EQ(json["verdict"], "valid");
  const auto expected = nlohmann::json::parse(
      R"([{"outer":null,"holes":[2]},{"outer":1,"holes":[4]},{"outer":3,"holes":[]}])");
  EXPECT_EQ(json["regions"], expected);
  EXPECT_TRUE(json["defects"].empty());
}

TEST(MapReportJson, names_warnings) {
  const auto json = json_of("4 2\n0 0\n1 0\n0 1\n5 5\n1 2 3\n3 2 1\n");
  ASSERT_EQ(json["warnings"].size(), 1U);
  EXPECT_EQ(json["warnings"][0]["kind"], "isolated-vertex");
  EXPECT_EQ(json["warnings"][0]["vertex"], 4);
}

TEST(MapReportGeoJson, is_a_feature_per_defect) {
  const MapReport report = report_on(file_text("corpus/maps/us-counties.map"));
  const auto json = nlohmann::json::parse(written(write_map_report_geojson, report));
  EXPECT_EQ(json["type"], "FeatureCollection");
  ASSERT_EQ(json["features"].size(), report.defects.size());
  for (const auto& feature : json["features"]) {
    EXPECT_EQ(feature["type"], "Feature");
    EXPECT_TRUE(feature["properties"]["kind"].is_string());
    EXPECT_FALSE(feature["geometry"].is_null());
  }
}

}  // namespace
}  // namespace plumb::map_report_io_test
