// Subdivisions laid over each other: every cell against brute force, and areas that add up exactly.
#include "plumb/plane/map_overlay.h"

#include <gtest/gtest.h>

#include <fstream>
#include <map>
#include <sstream>

#include "oracle/nef2_check.h"
#include "oracle/overlay_check.h"
#include "plane/checked.h"
#include "plumb/predicates/error.h"
#include "plumb/testing/dice.h"
#include "plumb/testing/map_families.h"
#include "plumb/testing/small_maps.h"

namespace plumb::testing::map_overlay_test {
namespace {

MapOverlay overlaid(const MapReport& first, const MapReport& second) {
  Context context;
  return overlay_maps(first, second, context);
}

TEST(MapOverlay, MatchesBruteForce) {
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    const std::uint32_t shapes = 1 + static_cast<std::uint32_t>(seed) % 3;
    EXPECT_EQ(overlay_disagreement(random_subdivision(shapes, 4, seed),
                                   random_subdivision(shapes, 4, seed + 1000)),
              "")
        << seed;
  }
}

// Any choice of the regions of a map is a set: closed it has everything next to a chosen region;
// open it has the same closure, and of the rest nothing.
TEST(MapOverlay, ChosenRegionsOfAMapAreASet) {
  for (std::uint64_t seed = 0; seed < 100 && !HasFailure(); ++seed) {
    SCOPED_TRACE(seed);
    const TestMap map = random_subdivision(1 + static_cast<std::uint32_t>(seed) % 4, 4, seed);
    const MapReport report = checked(map);
    Dice dice(seed);
    std::vector<std::uint8_t> chosen(report.regions.size());
    for (std::uint8_t& c : chosen) c = static_cast<std::uint8_t>(dice.below(2));
    CurveScene scene;
    add_edges(map, scene);
    const LineCells cells(lines_of(scene));
    const std::vector<std::uint32_t> region = regions_of(report, cells);
    CellMarks faces(cells.size());
    for (std::size_t c = 0; c < cells.size(); ++c) {
      faces[c] = cells[c].dimension == 2 && chosen[region[c]] != 0;
    }
    const CellMarks expected = closure_of(cells, faces);
    Context context;
    const Nef2 closed = Nef2::subdivision(report, chosen, Boundary::Closed, context);
    const Nef2 open = Nef2::subdivision(report, chosen, Boundary::Open, context);
    EXPECT_EQ(deep_difference(cells, {closed, expected}), "");
    EXPECT_EQ(difference(cells, {open.closure(), expected}), "");
    EXPECT_TRUE(open.is_open());
    EXPECT_EQ(open.area(), closed.area());
    chosen.push_back(1);
    EXPECT_THROW(Nef2::subdivision(report, chosen, Boundary::Open, context), Error);
  }
}

// ---------------------------------------------------------------- areas

void expect_areas_add_up(const MapReport& first, const MapReport& second) {
  const MapOverlay overlay = overlaid(first, second);
  ASSERT_EQ(overlay.origin.size(), overlay.complex.face_count());
  EXPECT_EQ(areas_that_differ(first, second, overlay), "");
}

TEST(MapOverlay, AreasOfGeneratedMapsAddUp) {
  for (const MapFamily& family : map_families()) {
    for (const MapFamily& other : map_families()) {
      SCOPED_TRACE(std::string(family.name) + " over " + std::string(other.name));
      expect_areas_add_up(checked(family.make(20)), checked(other.make(30)));
    }
  }
}

TEST(MapOverlay, OfAMapWithItselfIsTheMap) {
  for (const MapFamily& family : map_families()) {
    SCOPED_TRACE(family.name);
    const MapReport report = checked(family.make(25));
    const MapOverlay overlay = overlaid(report, report);
    EXPECT_EQ(overlay.complex.edge_count(), report.edges);
    EXPECT_EQ(overlay.complex.face_count(), report.regions.size());
    for (const MapOverlay::Origin& origin : overlay.origin) EXPECT_EQ(origin.first, origin.second);
  }
}

std::string text_of(const std::string& name) {
  std::ifstream in("corpus/maps/" + name);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

TEST(MapOverlay, StatesOverCountiesHaveTheAreaOfBoth) {
  const MapReport states = checked(parse_map(text_of("us-states.clean.map")));
  const MapReport counties = checked(parse_map(text_of("us-counties.clean.map")));
  ASSERT_EQ(states.verdict, MapVerdict::Valid);
  ASSERT_EQ(counties.verdict, MapVerdict::Valid);
  expect_areas_add_up(states, counties);
}

TEST(MapOverlay, RefusesAMapThatIsNone) {
  TestMap open = grid(2);
  open.cycles.pop_back();
  const MapReport good = checked(grid(2));
  for (const OuterRule rule : {OuterRule::Listed, OuterRule::Ignore}) {
    const MapReport bad = checked(open, {rule, false});
    for (const auto& [first, second] : {std::pair(&good, &bad), std::pair(&bad, &good)}) {
      try {
        overlaid(*first, *second);
        ADD_FAILURE() << "not refused";
      } catch (const Error& error) {
        EXPECT_EQ(error.code(), ErrorCode::BadArgument);
      }
    }
  }
}

}  // namespace
}  // namespace plumb::testing::map_overlay_test
