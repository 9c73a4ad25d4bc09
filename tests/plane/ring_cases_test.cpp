// Rings as they should not be, after the families of the published OGC and JTS suites; coordinates
// and answers are our own, small enough that each is right by hand.

#include <gtest/gtest.h>

#include <vector>

#include "case_sets.h"

namespace plumb::testing::ring_cases_test {
namespace {

struct Ring {
  const char* name;
  const char* wkt;
  const char* area;
  std::size_t polygons;  ///< faces
  std::size_t holes;     ///< of all of them; one that touches its shell at one point is a hole
};

const std::vector<Ring> kRings{
    {"a hole", kFrame, "32", 1, 1},
    {"a hole that touches the shell at a corner of both",
     "POLYGON ((0 0, 6 0, 6 6, 0 6, 0 0), (0 0, 3 1, 1 3, 0 0))", "32", 1, 1},
    {"a hole whose corner lies on an edge of the shell",
     "POLYGON ((0 0, 6 0, 6 6, 0 6, 0 0), (3 0, 4 2, 2 2, 3 0))", "34", 1, 1},
    {"a hole that cuts the shell in two, touching twice",
     "POLYGON ((0 0, 6 0, 6 6, 0 6, 0 0), (3 0, 4 3, 3 6, 2 3, 3 0))", "30", 2, 0},
    {"a hole with an edge on the shell",
     "POLYGON ((0 0, 6 0, 6 6, 0 6, 0 0), (2 0, 4 0, 4 2, 2 2, 2 0))", "32", 1, 0},
    {"a hole as large as the shell",
     "POLYGON ((0 0, 6 0, 6 6, 0 6, 0 0), (0 0, 6 0, 6 6, 0 6, 0 0))", "0", 0, 0},
    {"a hole that reaches out of the shell",
     "POLYGON ((0 0, 6 0, 6 6, 0 6, 0 0), (4 2, 8 2, 8 4, 4 4, 4 2))", "36", 2, 0},
    {"a hole outside of the shell: an area more",
     "POLYGON ((0 0, 2 0, 2 2, 0 2, 0 0), (4 0, 5 0, 5 1, 4 1, 4 0))", "5", 2, 0},
    {"holes that touch at a corner",
     "POLYGON ((0 0, 6 0, 6 6, 0 6, 0 0), (1 1, 3 1, 3 3, 1 3, 1 1), (3 3, 5 3, 5 5, 3 5, 3 3))",
     "28", 1, 2},
    {"holes in a chain from side to side: the shell in two",
     "POLYGON ((0 0, 6 0, 6 6, 0 6, 0 0), (0 3, 1 2, 3 3, 1 4, 0 3), (3 3, 5 2, 6 3, 5 4, 3 3))",
     "30", 2, 0},
    {"four holes around an island that touches them",
     "POLYGON ((0 0, 6 0, 6 6, 0 6, 0 0), (1 3, 3 1, 2 3, 1 3), (3 1, 5 3, 3 2, 3 1), "
     "(5 3, 3 5, 4 3, 5 3), (3 5, 1 3, 3 4, 3 5))",
     "32", 2, 1},
    {"a hole within a hole: an island",
     "POLYGON ((0 0, 8 0, 8 8, 0 8, 0 0), (1 1, 7 1, 7 7, 1 7, 1 1), (2 2, 6 2, 6 6, 2 6, 2 2))",
     "44", 2, 1},
    {"nested five deep",
     "POLYGON ((0 0, 10 0, 10 10, 0 10, 0 0), (1 1, 9 1, 9 9, 1 9, 1 1), (2 2, 8 2, 8 8, 2 8, 2 "
     "2), "
     "(3 3, 7 3, 7 7, 3 7, 3 3), (4 4, 6 4, 6 6, 4 6, 4 4))",
     "60", 3, 2},
    {"an island in a hole, as polygons",
     "MULTIPOLYGON (((0 0, 6 0, 6 6, 0 6, 0 0), (1 1, 5 1, 5 5, 1 5, 1 1)), ((2 2, 3 2, 3 3, 2 "
     "2)))",
     "41/2", 2, 1},
    {"an island that fills its hole, as polygons",
     "MULTIPOLYGON (((0 0, 6 0, 6 6, 0 6, 0 0), (1 1, 5 1, 5 5, 1 5, 1 1)), "
     "((1 1, 5 1, 5 5, 1 5, 1 1)))",
     "36", 1, 0},
    {"the same polygon three times",
     "MULTIPOLYGON (((0 0, 2 0, 0 2, 0 0)), ((0 0, 0 2, 2 0, 0 0)), ((2 0, 0 2, 0 0, 2 0)))", "2",
     1, 0},
    {"polygons that overlap",
     "MULTIPOLYGON (((0 0, 4 0, 4 4, 0 4, 0 0)), ((2 2, 6 2, 6 6, 2 6, 2 2)))", "28", 1, 0},
    {"polygons with a common edge",
     "MULTIPOLYGON (((0 0, 4 0, 4 4, 0 4, 0 0)), ((4 1, 6 1, 6 3, 4 3, 4 1)))", "20", 1, 0},
    {"polygons around a hole",
     "MULTIPOLYGON (((0 0, 4 0, 4 1, 1 1, 1 4, 0 4, 0 0)), "
     "((4 4, 1 4, 1 3, 3 3, 3 1, 4 1, 4 4)))",
     "12", 1, 1},
    {"a bow-tie", "POLYGON ((0 0, 4 4, 4 0, 0 4, 0 0))", "8", 2, 0},
    {"a bow-tie with its crossing as a corner", "POLYGON ((0 0, 2 2, 4 0, 4 4, 2 2, 0 4, 0 0))",
     "8", 2, 0},
    {"a pentagram: the middle is out by even and odd", "POLYGON ((0 0, 6 0, 0 6, 3 -3, 6 6, 0 0))",
     "15", 5, 0},
    {"a shell that touches itself from inside",
     "POLYGON ((0 0, 8 0, 8 8, 4 8, 2 4, 6 4, 4 8, 0 8, 0 0))", "56", 1, 1},
    {"a shell that touches itself from outside",
     "POLYGON ((0 0, 4 0, 4 4, 2 4, 2 1, 2 4, 0 4, 0 0))", "16", 1, 0},
    {"a shell that encloses a hole along a bridge",
     "POLYGON ((0 0, 6 0, 6 3, 4 3, 4 2, 2 2, 2 4, 4 4, 4 3, 6 3, 6 6, 0 6, 0 0))", "32", 1, 1},
    {"a ring that turns back on itself", "POLYGON ((0 0, 4 0, 8 0, 4 0, 4 4, 0 4, 0 0))", "16", 1,
     0},
    {"a ring without area", "POLYGON ((0 0, 4 0, 8 0, 0 0))", "0", 0, 0},
    {"a ring of one point", "POLYGON ((1 1, 1 1, 1 1, 1 1))", "0", 0, 0},
    {"repeated corners", "POLYGON ((0 0, 0 0, 4 0, 4 0, 4 0, 4 4, 0 4, 0 0, 0 0))", "16", 1, 0},
    {"a corner in the middle of every edge",
     "POLYGON ((0 0, 2 0, 4 0, 4 2, 4 4, 2 4, 0 4, 0 2, 0 0))", "16", 1, 0},
    {"a ring run twice", "POLYGON ((0 0, 4 0, 4 4, 0 4, 0 0, 4 0, 4 4, 0 4, 0 0))", "0", 0, 0},
    {"two triangles in one ring, the same way round",
     "POLYGON ((0 0, 4 0, 2 4, 0 0, 8 0, 4 8, 0 0))", "24", 1, 0},
};

TEST(RingCases, have_the_areas_and_parts_argued_by_hand) {
  for (const Ring& ring : kRings) {
    SCOPED_TRACE(ring.name);
    const Nef2 set = set_of_wkt(ring.wkt);
    EXPECT_FALSE(set.audit());
    EXPECT_TRUE(set.is_closed() && set.is_bounded());
    EXPECT_EQ(set.area(), Rational(ring.area));
    std::size_t holes = 0;
    const PlaneParts parts = set.regularization().parts();
    for (const PolygonWithHoles2& polygon : parts.polygons) holes += polygon.holes.size();
    EXPECT_EQ(parts.polygons.size(), ring.polygons);
    EXPECT_EQ(holes, ring.holes);
  }
}

TEST(RingCases, of_one_meaning_are_one_set) {
  const std::vector<std::vector<const char*>> same{
      {kSquare, "POLYGON ((4 4, 4 0, 0 0, 0 4, 4 4))",
       "POLYGON ((0 0, 2 0, 4 0, 4 2, 4 4, 2 4, 0 4, 0 2, 0 0))",
       "MULTIPOLYGON (((0 0, 4 0, 4 4, 0 0)), ((0 0, 4 4, 0 4, 0 0)))",
       "MULTIPOLYGON (((0 0, 3 0, 3 4, 0 4, 0 0)), ((2 0, 4 0, 4 4, 2 4, 2 0)))",
       "GEOMETRYCOLLECTION (POLYGON ((0 0, 4 0, 4 4, 0 4, 0 0)), LINESTRING (0 0, 4 4), POINT (1 "
       "3))"},
      {kFrame, "POLYGON ((2 2, 4 2, 4 4, 2 4, 2 2), (0 0, 6 0, 6 6, 0 6, 0 0))",
       "POLYGON ((0 0, 0 6, 6 6, 6 0, 0 0), (2 2, 2 4, 4 4, 4 2, 2 2))",
       "MULTIPOLYGON (((0 0, 6 0, 6 2, 2 2, 2 6, 0 6, 0 0)), ((6 6, 2 6, 2 4, 4 4, 4 2, 6 2, 6 "
       "6)))"},
      {"POLYGON ((0 0, 4 4, 4 0, 0 4, 0 0))", "POLYGON ((0 0, 2 2, 4 0, 4 4, 2 2, 0 4, 0 0))",
       "MULTIPOLYGON (((0 0, 2 2, 0 4, 0 0)), ((2 2, 4 0, 4 4, 2 2)))"},
      {"LINESTRING (0 0, 6 0)", "LINESTRING (6 0, 3 0, 0 0)",
       "MULTILINESTRING ((0 0, 4 0), (2 0, 6 0))", "LINESTRING (0 0, 6 0, 2 0, 5 0)",
       "GEOMETRYCOLLECTION (LINESTRING (0 0, 6 0), MULTIPOINT (0 0, 1 0, 6 0))"},
  };
  for (const auto& texts : same) {
    for (const char* const text : texts) {
      EXPECT_TRUE(set_of_wkt(text) == set_of_wkt(texts.front())) << text;
    }
  }
}

}  // namespace
}  // namespace plumb::testing::ring_cases_test
