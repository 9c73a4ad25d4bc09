// Descriptions of defects and warnings: places in rationals, the order of kinds, limits, and hints
// that name faces and vertices from one, as files do.
#include "plumb/plane/check/map_describe.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "plumb/plane/map_check.h"

namespace plumb::map_describe_test {

using Cycle = std::vector<std::uint32_t>;
using Places = std::vector<std::array<double, 2>>;

Map listing(const Places& places, const std::vector<Cycle>& cycles) {
  Map map;
  for (const auto& [x, y] : places) map.points.push_back(Point2{x, y});
  for (const Cycle& c : cycles) map.add_cycle(c);
  return map;
}

/// A report on a map, and what was found of its edges, before anything is described.
struct Checked {
  MapFindings findings;
  MapReport report;

  explicit Checked(const Map& map) {
    report.map = map;
    findings.edges = match_twins(map);
    findings.components = connect(map, findings.edges);
    findings.contacts =
        find_contacts(map, findings.edges, findings.components, 1000, unlimited_context());
    if (findings.edges.extra_uses.empty()) {
      findings.chains = trace_open_chains(map, findings.edges);
    }
  }
};

/// Two squares over each other, one of them listed twice, and a face that runs back on itself.
Map defective() {
  return listing({{0, 0}, {4, 0}, {4, 4}, {0, 4}, {2, 2}, {6, 2}, {6, 6}, {2, 6}, {9, 9}, {9, 0}},
                 {{0, 1, 2, 3}, {0, 1, 2, 3}, {4, 5, 6, 7}, {8, 9, 5, 9}});
}

TEST(MapDescribe, DefectsComeByKindAndLimitsKeepTheFirst) {
  Checked all(defective());
  describe_defects(all.findings, 1000, all.report);
  const std::vector<MapDefect>& defects = all.report.defects;
  const auto count = [&](DefectKind kind) {
    return std::ranges::count_if(defects, [&](const MapDefect& d) { return d.kind == kind; });
  };
  EXPECT_EQ(count(DefectKind::Duplicate), 4);
  EXPECT_EQ(count(DefectKind::Open), 8);
  EXPECT_EQ(count(DefectKind::Crossing), 2);
  EXPECT_EQ(count(DefectKind::Twin), 2);
  EXPECT_TRUE(std::ranges::is_sorted(defects, {}, &MapDefect::kind));
  for (std::size_t limit = 0; limit <= defects.size() + 1; ++limit) {
    Checked some(defective());
    describe_defects(some.findings, limit, some.report);
    ASSERT_EQ(some.report.defects.size(), std::min(limit, defects.size()));
    for (std::size_t i = 0; i < some.report.defects.size(); ++i) {
      EXPECT_EQ(some.report.defects[i].hint, defects[i].hint);
    }
  }
  all.report.defects.clear();
  all.findings.open_is_defect = false;
  describe_defects(all.findings, 1000, all.report);
  EXPECT_EQ(count(DefectKind::Open), 0);
}

/// Defects of one edge are in its middle, crossings where the edges meet.
TEST(MapDescribe, PlacesAreExact) {
  Checked checked(defective());
  describe_defects(checked.findings, 1000, checked.report);
  std::vector<RationalPoint2> crossings;
  for (const MapDefect& defect : checked.report.defects) {
    ASSERT_TRUE(defect.point.has_value());
    EXPECT_EQ(Rational(defect.near.x), defect.point->x);
    EXPECT_TRUE(std::ranges::is_sorted(defect.cycles));
    if (defect.kind == DefectKind::Crossing) {
      crossings.push_back(*defect.point);
      EXPECT_EQ(defect.cycles, (Cycle{0, 1, 2}));
      continue;
    }
    const RationalPoint2 p = checked.report.map.points.exact(defect.edges.at(0).from);
    const RationalPoint2 q = checked.report.map.points.exact(defect.edges.at(0).to);
    EXPECT_EQ(defect.point->x + defect.point->x, p.x + q.x);
    EXPECT_EQ(defect.point->y + defect.point->y, p.y + q.y);
  }
  ASSERT_EQ(crossings.size(), 2U);
  EXPECT_NE(crossings[0], crossings[1]);
  for (const RationalPoint2& p : crossings) {
    EXPECT_TRUE((p == RationalPoint2{2, 4}) || (p == RationalPoint2{4, 2}));
  }
}

/// Two squares, on the edge between them k vertices that the right one alone knows, in any order of
/// numbers.
Map t_junctions(const Cycle& order, bool is_healed) {
  Places places{{0, 0}, {0, 8}, {-8, 8}, {-8, 0}, {8, 0}, {8, 8}};
  Cycle between(order.size());
  for (const std::uint32_t at : order) {
    between[at] = static_cast<std::uint32_t>(places.size());
    places.push_back({0, static_cast<double>(at + 1)});
  }
  Cycle left = {0, 1, 2, 3}, right = {4, 5, 1}, outer = {0, 3, 2, 1, 5, 4};
  if (is_healed) left.insert(left.begin() + 1, between.begin(), between.end());
  right.insert(right.end(), between.rbegin(), between.rend());
  right.push_back(0);
  return listing(places, {left, right, outer});
}

bool has_hint(const MapReport& report, const std::string& wanted) {
  return std::ranges::any_of(
      report.defects, [&](const MapDefect& d) { return d.hint.find(wanted) != std::string::npos; });
}

/// What a hint says of a T-junction heals it.
TEST(MapDescribe, HintsSpellTheVerticesOnAnEdgeInOrder) {
  Cycle order = {0, 1, 2};
  do {
    const MapReport report = check_map(t_junctions(order, false));
    ASSERT_EQ(report.verdict, MapVerdict::Open);
    std::string path = "1";
    for (std::uint32_t at = 0; at < order.size(); ++at) {
      path += "-" + std::to_string(7 + (std::ranges::find(order, at) - order.begin()));
    }
    EXPECT_TRUE(has_hint(report, "T-junction, edge 1-2 is covered by " + path +
                                     "-2; insert the vertices between into face 1"));
    EXPECT_EQ(check_map(t_junctions(order, true)).verdict, MapVerdict::Valid);
  } while (std::ranges::next_permutation(order).found);
}

/// A dozen vertices are named; of more there are dots. The cycle that is missing runs backwards.
TEST(MapDescribe, HintsNameADozenVertices) {
  for (const std::uint32_t corners : {5U, 12U, 13U, 30U}) {
    Places places;
    Cycle cycle;
    for (std::uint32_t i = 0; i < corners; ++i) {
      places.push_back({static_cast<double>(i), static_cast<double>(i * i)});
      cycle.push_back(i);
    }
    const MapReport report = check_map(listing(places, {cycle}));
    ASSERT_EQ(report.counts.open, corners);
    EXPECT_EQ(has_hint(report, "..."), corners > 12) << report.defects[0].hint;
    const std::string size = std::to_string(corners);
    EXPECT_TRUE(has_hint(report, "missing outer boundary of " + size + " edges"));
    std::ranges::reverse(cycle);
    EXPECT_TRUE(has_hint(check_map(listing(places, {cycle})), "gap of " + size + " edges"));
  }
}

/// A polygon of `sides` corners and a ring of quadrangles around it, all listed the wrong way
/// round, and a triangle at a corner of the ring: edges of all quadrangles bound the polygon.
Map turned_ring(std::uint32_t sides) {
  Places places;
  for (std::uint32_t i = 0; i < 2 * sides; ++i) {
    const double angle = (i / 2) * 6.28318530717959 / sides;
    const double radius = i % 2 == 0 ? 1 : 2;
    places.push_back({radius * std::cos(angle), radius * std::sin(angle)});
  }
  places.insert(places.end(), {{3, -1}, {3, 1}});
  Cycle polygon, around;
  std::vector<Cycle> cycles;
  for (std::uint32_t i = 0; i < 2 * sides; i += 2) {
    const std::uint32_t next = (i + 2) % (2 * sides);
    polygon.insert(polygon.begin(), i);
    around.push_back(i + 1);
    cycles.push_back({i, next, next + 1, i + 1});
  }
  const std::uint32_t more = 2 * sides;
  cycles.insert(cycles.end(), {polygon, around, {1, more, more + 1}, {1, more + 1, more}});
  return listing(places, cycles);
}

TEST(MapDescribe, MixedDefectsNameSixteenCycles) {
  for (const std::uint32_t sides : {3U, 16U, 17U, 40U}) {
    const MapReport report = check_map(turned_ring(sides));
    ASSERT_EQ(report.counts.mixed, sides + 1);
    std::size_t most = 0;
    for (const MapDefect& defect : report.defects) most = std::max(most, defect.cycles.size());
    EXPECT_EQ(most, std::clamp(sides, 4U, 16U));
    EXPECT_TRUE(has_hint(report, "edges of " + std::to_string(sides) + " listed faces"));
  }
}

/// Two triangles that meet in the origin, and a vertex of nobody, numbered in any rotation.
TEST(MapDescribe, WarningsNameTheirVertexWhateverItsNumber) {
  const Places places{{0, 0}, {-2, -1}, {-2, 1}, {2, -1}, {2, 1}, {5, 5}};
  for (std::uint32_t by = 0; by < 6; ++by) {
    Places moved(6);
    for (std::uint32_t i = 0; i < 6; ++i) moved[(i + by) % 6] = places[i];
    std::vector<Cycle> cycles = {{0, 2, 1}, {0, 3, 4}, {0, 4, 3, 0, 1, 2}};
    for (Cycle& c : cycles) {
      for (std::uint32_t& v : c) v = (v + by) % 6;
    }
    const MapReport report = check_map(listing(moved, cycles));
    EXPECT_EQ(report.verdict, MapVerdict::Valid);
    ASSERT_EQ(report.warnings.size(), 2U);
    EXPECT_EQ(report.warnings[0].kind, WarningKind::Pinch);
    EXPECT_EQ(report.warnings[0].vertex, by);
    EXPECT_EQ(report.warnings[1].kind, WarningKind::IsolatedVertex);
    EXPECT_EQ(report.warnings[1].vertex, (5 + by) % 6);
  }
}

/// Of each kind a limited number is spelled out; one more warning says how many others there are.
/// A merged vertex is in no cycle, but not isolated.
TEST(MapDescribe, WarningsBeyondTheLimitAreCounted) {
  for (std::size_t limit = 0; limit < 8; ++limit) {
    Checked checked(listing(Places(9, {1, 1}), {}));
    checked.findings.merged = {2, 3, 7};
    describe_warnings(checked.findings, limit, checked.report);
    for (const WarningKind kind : {WarningKind::MergedVertex, WarningKind::IsolatedVertex}) {
      const Cycle all =
          kind == WarningKind::MergedVertex ? Cycle{2, 3, 7} : Cycle{0, 1, 4, 5, 6, 8};
      std::vector<MapWarning> found;
      for (const MapWarning& w : checked.report.warnings) {
        if (w.kind == kind) found.push_back(w);
      }
      const std::size_t spelled = std::min(limit, all.size());
      ASSERT_EQ(found.size(), spelled + (spelled < all.size() ? 1 : 0));
      for (std::size_t i = 0; i < spelled; ++i) {
        EXPECT_EQ(found[i].vertex, all[i]);
        EXPECT_EQ(found[i].text.find("vertex " + std::to_string(all[i] + 1) + " "), 0U);
      }
      if (spelled == all.size()) continue;
      EXPECT_NE(found.back().text.find(" " + std::to_string(all.size() - spelled) + " more"),
                std::string::npos);
    }
  }
}

}  // namespace plumb::map_describe_test
