// Subdivisions laid over each other: every cell against brute force, and areas that add up exactly.
#include "plumb/plane/map_overlay.h"

#include <gtest/gtest.h>

#include <fstream>
#include <map>
#include <sstream>

#include "generate/dice.h"
#include "generate/map_families.h"
#include "generate/small_maps.h"
#include "oracle/nef2_check.h"
#include "plane/checked.h"
#include "plumb/base/error.h"
#include "plumb/plane/plane_measure.h"
#include "plumb/predicates/polygon.h"

namespace plumb::testing {
namespace {

MapOverlay overlaid(const MapReport& first, const MapReport& second) {
  Context context;
  return overlay_maps(first, second, context);
}

// The cycles of a region as chains.
std::vector<Chain> rings_of(const TestMap& map, const MapRegion& region) {
  std::vector<std::uint32_t> cycles = region.holes;
  if (region.outer) cycles.push_back(*region.outer);
  std::vector<Chain> rings;
  for (const std::uint32_t c : cycles) {
    Chain& ring = rings.emplace_back();
    for (const std::uint32_t v : map.cycles[c]) ring.push_back(map.points[v]);
  }
  return rings;
}

// The region of each cell that lies on no edge; the unbounded one where there is no other.
std::vector<std::uint32_t> regions_of(const MapReport& report, const LineCells& cells) {
  const TestMap map = from_map(report.map);
  std::vector<std::uint32_t> region(cells.size(), 0);
  for (std::uint32_t r = 1; r < report.regions.size(); ++r) {
    const SetPolygons set{rings_of(map, report.regions[r]), WindingRule::NonZero, Boundary::Open};
    const CellMarks inside = marks_of(PlaneSet{set}, cells);
    for (std::size_t c = 0; c < cells.size(); ++c) {
      if (inside[c]) region[c] = r;
    }
  }
  return region;
}

void add_edges(const TestMap& map, CurveScene& scene) {
  for (const Cycle& cycle : map.cycles) {
    for (std::size_t i = 0; i < cycle.size(); ++i) {
      const ExactPoint& p = map.points[cycle[i]];
      const ExactPoint& q = map.points[cycle[(i + 1) % cycle.size()]];
      scene.curves.push_back({p, q, p, q});
    }
  }
}

TEST(MapOverlay, MatchesBruteForce) {
  for (std::uint64_t seed = 0; seed < 60 && !HasFailure(); ++seed) {
    SCOPED_TRACE(seed);
    const std::uint32_t shapes = 1 + static_cast<std::uint32_t>(seed) % 3;
    const TestMap one = random_subdivision(shapes, 4, seed);
    const TestMap two = random_subdivision(shapes, 4, seed + 1000);
    const MapReport first = checked(one);
    const MapReport second = checked(two);
    ASSERT_EQ(first.verdict, MapVerdict::Valid);
    ASSERT_EQ(second.verdict, MapVerdict::Valid);
    const MapOverlay overlay = overlaid(first, second);
    const auto flaw = audit(overlay.complex, false);
    ASSERT_FALSE(flaw.has_value()) << flaw->invariant << " at " << flaw->place;

    CurveScene scene;
    add_edges(one, scene);
    add_edges(two, scene);
    const LineCells cells(lines_of(scene));
    const PlaneGraph graph = arrangement_graph(cells, scene);
    const GraphMatch found = match(overlay.complex, graph, cells);
    ASSERT_EQ(found.difference, "");
    const std::vector<std::uint32_t> in_first = regions_of(first, cells);
    const std::vector<std::uint32_t> in_second = regions_of(second, cells);
    for (std::size_t c = 0; c < cells.size(); ++c) {
      if (cells[c].dimension != 2) continue;
      const FaceId f = found.face[graph.element_of[c].index];
      const MapOverlay::Origin expected{in_first[c], in_second[c]};
      EXPECT_EQ(overlay.origin[f.value()], expected) << to_text(cells[c].point);
    }
  }
}

// Any choice of the regions of a map is a set: closed it has everything next to a chosen region; open
// it has the same closure, and of the rest nothing.
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

Rational area_of(const MapReport& report, const MapRegion& region) {
  Rational doubled = twice_polygon_area(report.map.points, report.map.cycle(*region.outer));
  for (const std::uint32_t hole : region.holes) {
    doubled += twice_polygon_area(report.map.points, report.map.cycle(hole));
  }
  return doubled / 2;
}

// The cells of a region have its area; those in no bounded region of the other map are counted too.
void expect_areas_add_up(const MapReport& first, const MapReport& second) {
  const MapOverlay overlay = overlaid(first, second);
  ASSERT_EQ(overlay.origin.size(), overlay.complex.face_count());
  std::vector<Rational> in_first(first.regions.size());
  std::vector<Rational> in_second(second.regions.size());
  for (std::size_t i = 0; i < overlay.origin.size(); ++i) {
    const std::optional<Rational> area = face_area(overlay.complex, FaceId(i));
    const MapOverlay::Origin origin = overlay.origin[i];
    if (!area) {
      EXPECT_EQ(origin, (MapOverlay::Origin{0, 0}));
      continue;
    }
    EXPECT_GT(*area, 0);
    in_first[origin.first] += *area;
    in_second[origin.second] += *area;
  }
  for (std::size_t r = 1; r < first.regions.size(); ++r) {
    EXPECT_EQ(in_first[r], area_of(first, first.regions[r])) << "first map, region " << r;
  }
  for (std::size_t r = 1; r < second.regions.size(); ++r) {
    EXPECT_EQ(in_second[r], area_of(second, second.regions[r])) << "second map, region " << r;
  }
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
}  // namespace plumb::testing
