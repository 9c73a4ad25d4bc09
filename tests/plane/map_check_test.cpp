// check_map against the truth table, against the catalogue of seeded defects, and against the table
// in corpus/ whose figures follow from the definitions.
#include "plumb/plane/map_check.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <sstream>

#include "plane/checked.h"
#include "plumb/testing/map_defects.h"
#include "plumb/testing/map_families.h"
#include "plumb/testing/small_maps.h"

namespace plumb::testing::map_check_test {
namespace {

int mixed_or_none(const MapReport& report) {
  return report.counts.mixed ? static_cast<int>(*report.counts.mixed) : -1;
}

// ---------------------------------------------------------------- the truth table

class TruthTable : public ::testing::TestWithParam<SmallMap> {};

TEST_P(TruthTable, VerdictAndCounts) {
  const SmallMap& wanted = GetParam();
  const MapReport got = checked(parse_map(wanted.text), {wanted.outer, wanted.merge});
  EXPECT_EQ(got.verdict, wanted.verdict);
  EXPECT_EQ(got.counts.duplicate, wanted.duplicate);
  EXPECT_EQ(got.counts.open, wanted.open);
  EXPECT_EQ(got.counts.crossing, wanted.crossing);
  EXPECT_EQ(got.counts.twin, wanted.twin);
  EXPECT_EQ(mixed_or_none(got), wanted.mixed);
  EXPECT_EQ(got.counts.nested, wanted.nested);
  EXPECT_EQ(got.components, wanted.components);
}

TEST_P(TruthTable, AgreesWithTheTwinUnderEveryRule) {
  const TestMap map = parse_map(GetParam().text);
  for (const OuterRule outer : kOuterRules) {
    for (const bool merge : {false, true}) {
      EXPECT_EQ(disagreement(map, {outer, merge}), "");
    }
  }
}

INSTANTIATE_TEST_SUITE_P(MapCheck, TruthTable, ::testing::ValuesIn(small_maps()));

// ---------------------------------------------------------------- seeded defects

std::vector<MapEdge> edges_of(const MapReport& report, DefectKind kind) {
  std::vector<MapEdge> edges;
  for (const MapDefect& defect : report.defects) {
    if (defect.kind == kind) edges.insert(edges.end(), defect.edges.begin(), defect.edges.end());
  }
  return edges;
}

bool lies_within(const std::vector<MapEdge>& wanted, const std::vector<MapEdge>& found) {
  return std::all_of(wanted.begin(), wanted.end(), [&](const MapEdge& e) {
    return std::find(found.begin(), found.end(), e) != found.end();
  });
}

MapEdge undirected(MapEdge e) { return e.from < e.to ? e : MapEdge{e.to, e.from}; }

bool names_pair(const MapDefect& defect, const std::pair<MapEdge, MapEdge>& pair) {
  if (defect.kind != DefectKind::Crossing || defect.edges.size() != 2) return false;
  const MapEdge a = undirected(defect.edges[0]), b = undirected(defect.edges[1]);
  const MapEdge p = undirected(pair.first), q = undirected(pair.second);
  return (a == p && b == q) || (a == q && b == p);
}

void expect_pairs(const MapReport& report, const DefectExpectation& wanted) {
  for (std::size_t i = 0; i < wanted.pairs.size(); ++i) {
    const auto found =
        std::find_if(report.defects.begin(), report.defects.end(),
                     [&](const MapDefect& d) { return names_pair(d, wanted.pairs[i]); });
    ASSERT_NE(found, report.defects.end()) << "pair " << i;
    ASSERT_TRUE(found->point.has_value());
    EXPECT_EQ(exact_of(*found->point), wanted.places[i]) << "pair " << i;
  }
}

void expect_known(const std::optional<std::uint64_t>& wanted,
                  const std::optional<std::uint64_t>& got, const char* what) {
  if (wanted) {
    EXPECT_EQ(got, wanted) << what;
  }
}

void expect_counts(const MapReport& report, const DefectExpectation& wanted) {
  if (wanted.verdict) {
    EXPECT_EQ(report.verdict, *wanted.verdict);
  }
  expect_known(wanted.duplicate, report.counts.duplicate, "duplicate");
  expect_known(wanted.open, report.counts.open, "open");
  expect_known(wanted.crossing, report.counts.crossing, "crossing");
  expect_known(wanted.twin, report.counts.twin, "twin");
  expect_known(wanted.mixed, report.counts.mixed, "mixed");
}

void expect_told(const DefectiveMap& defective) {
  if (!defective.expected.refused.empty()) {
    EXPECT_TRUE(is_refused(defective.map)) << defective.expected.refused;
    return;
  }
  const MapReport report = checked(defective.map);
  expect_counts(report, defective.expected);
  EXPECT_TRUE(lies_within(defective.expected.open_edges, edges_of(report, DefectKind::Open)));
  EXPECT_TRUE(
      lies_within(defective.expected.duplicate_edges, edges_of(report, DefectKind::Duplicate)));
  expect_pairs(report, defective.expected);
}

class SeededDefect : public ::testing::TestWithParam<MapDefectMaker> {};

// The counts of all kinds are expected, so nothing else may be reported either.
TEST_P(SeededDefect, IsFoundAndLocatedInEveryFamily) {
  for (const MapFamily& family : map_families()) {
    const TestMap valid = family.make(20);
    for (const DefectPlace place : {DefectPlace{0, 0}, DefectPlace{7, 1}, DefectPlace{19, 2}}) {
      SCOPED_TRACE(std::string(family.name) + ", cycle " + std::to_string(place.cycle));
      expect_told(GetParam().make(valid, place));
    }
  }
}

TEST_P(SeededDefect, AgreesWithTheTwinUnderEveryRule) {
  for (const MapFamily& family : map_families()) {
    const TestMap map = GetParam().make(family.make(12), {5, 1}).map;
    for (const OuterRule outer : kOuterRules) {
      EXPECT_EQ(disagreement(map, {outer, false}), "") << family.name;
      EXPECT_EQ(disagreement(map, {outer, true}), "") << family.name;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(MapCheck, SeededDefect, ::testing::ValuesIn(map_defect_makers()),
                         [](const auto& tested) {
                           std::string name = tested.param.name;
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });

// Every pair of defects in one map, and every defect in giant and in tiny coordinates.
TEST_P(SeededDefect, IsFoundBesideEveryOther) {
  const DefectiveMap one = GetParam().make(grid(2), {1, 2});
  for (const MapDefectMaker& maker : map_defect_makers()) {
    SCOPED_TRACE(maker.name);
    const DefectiveMap both[] = {one, maker.make(hexagons(2, 7), {2, 1})};
    expect_told(combined(both));
    EXPECT_EQ(disagreement(combined(both).map), "");
  }
}

TEST_P(SeededDefect, IsFoundInGiantAndTinyCoordinates) {
  const DefectiveMap defective = GetParam().make(jittered_triangles(2, 5), {3, 1});
  for (const int exponent : {900, -1000, 3000})
    expect_told(scaled(defective, power_of_two(exponent)));
}

TEST(SeededDefects, AddUp) {
  std::vector<DefectiveMap> all;
  for (const MapDefectMaker& maker : map_defect_makers()) {
    const DefectiveMap one = maker.make(grid(2), {0, 1});
    if (one.expected.refused.empty()) all.push_back(one);
  }
  const DefectiveMap together = combined(all);
  EXPECT_EQ(together.expected.verdict, MapVerdict::NotAPlanarSubdivision);
  EXPECT_GT(together.expected.open, 20U);
  expect_told(together);
}

// ---------------------------------------------------------------- the table in corpus/

struct Row {
  std::string family, defect, verdict, outer;
  std::uint32_t faces = 0, cycle = 0, corner = 0;
  std::string duplicate, open, crossing, twin, mixed, nested;
};

std::vector<Row> rows_of(const std::string& path) {
  std::ifstream in(path);
  std::vector<Row> rows;
  for (std::string line; std::getline(in, line);) {
    if (line.empty() || line[0] == '#') continue;
    std::istringstream fields(line);
    Row& r = rows.emplace_back();
    fields >> r.family >> r.faces >> r.defect >> r.cycle >> r.corner >> r.outer >> r.verdict >>
        r.duplicate >> r.open >> r.crossing >> r.twin >> r.mixed >> r.nested;
    EXPECT_FALSE(fields.fail()) << line;
  }
  return rows;
}

TestMap map_of(const Row& row) {
  TestMap map;
  for (const MapFamily& family : map_families()) {
    if (family.name == row.family) map = family.make(row.faces);
  }
  if (row.defect == "none") return map;
  return map_defect_maker(row.defect).make(map, {row.cycle, row.corner}).map;
}

OuterRule rule_of(const Row& row) {
  if (row.outer == "infer") return OuterRule::Infer;
  return row.outer == "ignore" ? OuterRule::Ignore : OuterRule::Listed;
}

std::string name_of(MapVerdict verdict) {
  static constexpr const char* kNames[] = {"valid", "not-a-planar-subdivision", "open",
                                           "superposed"};
  return kNames[static_cast<int>(verdict)];
}

void expect_count(const std::string& wanted, const std::optional<std::uint64_t>& got,
                  const char* what) {
  if (wanted == "?") return;
  EXPECT_EQ(wanted, got ? std::to_string(*got) : "-") << what;
}

void expect_row(const Row& row) {
  SCOPED_TRACE(row.family + " " + row.defect + " " + row.outer);
  if (row.verdict == "refused") {
    EXPECT_TRUE(is_refused(map_of(row), {rule_of(row), false}));
    return;
  }
  const MapReport report = checked(map_of(row), {rule_of(row), false});
  EXPECT_EQ(name_of(report.verdict), row.verdict);
  expect_count(row.duplicate, report.counts.duplicate, "duplicate");
  expect_count(row.open, report.counts.open, "open");
  expect_count(row.crossing, report.counts.crossing, "crossing");
  expect_count(row.twin, report.counts.twin, "twin");
  expect_count(row.mixed, report.counts.mixed, "mixed");
  expect_count(row.nested, report.counts.nested, "nested");
}

TEST(GeneratedMaps, AreJudgedAsTheTableSays) {
  const std::vector<Row> rows = rows_of("corpus/maps/generated.tsv");
  ASSERT_GE(rows.size(), 50U);
  for (const Row& row : rows) expect_row(row);
}

// ---------------------------------------------------------------- refusals

/// What check_map says when it refuses a map.
std::string refusal_of(const TestMap& map, OracleOptions options = {}) {
  try {
    checked(map, options);
  } catch (const Error& error) {
    return error.what();
  }
  return "not refused";
}

/// A triangle, and a second face.
TestMap triangle_and(std::vector<std::uint32_t> face) {
  TestMap map;
  for (const auto& [x, y] : {std::pair(0, 0), {4, 0}, {0, 2}, {9, 9}, {12, 9}, {9, 9}}) {
    map.add_point(x, y);
  }
  map.cycles = {{0, 1, 2}, std::move(face)};
  return map;
}

TEST(Refusals, NumberFacesAndVerticesFromOne) {
  EXPECT_NE(refusal_of(triangle_and({0, 1, 6})).find("face 2 uses vertex 7 of 6"),
            std::string::npos);
  OracleOptions merging;
  merging.merge_vertices = true;
  EXPECT_NE(refusal_of(triangle_and({3, 4, 5}), merging).find("face 2 collapses"),
            std::string::npos);
}

// ---------------------------------------------------------------- half-edge structures

/// A square in a square: regions are faces, also that with a hole, and the unbounded one.
TEST(ToDcel, FacesAreRegions) {
  TestMap map;
  for (const int size : {3, 1}) {
    for (const auto& [x, y] : {std::pair(-1, -1), {1, -1}, {1, 1}, {-1, 1}}) {
      map.add_point(size * x, size * y);
    }
  }
  map.cycles = {{0, 1, 2, 3}, {7, 6, 5, 4}, {4, 5, 6, 7}, {3, 2, 1, 0}};
  const MapReport report = checked(map);
  ASSERT_EQ(report.verdict, MapVerdict::Valid);
  ASSERT_EQ(report.regions.size(), 3U);
  const DcelFromCycles made = to_dcel(report);
  EXPECT_EQ(made.dcel.face_count(), 3U);
  std::size_t cycles = 0;
  for (std::uint32_t r = 0; r < report.regions.size(); ++r) {
    std::vector<std::uint32_t> of_region = report.regions[r].holes;
    if (report.regions[r].outer) of_region.push_back(*report.regions[r].outer);
    for (const std::uint32_t c : of_region) {
      ++cycles;
      const HalfedgeId h = made.halfedge_of_corner[report.map.cycle_begin[c]];
      EXPECT_EQ(made.dcel.face(h), FaceId(r)) << "cycle " << c;
    }
  }
  EXPECT_EQ(cycles, 4U);
}

}  // namespace
}  // namespace plumb::testing::map_check_test
