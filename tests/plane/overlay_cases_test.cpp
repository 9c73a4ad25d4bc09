// Overlay and validity cases after the families of the published OGC and JTS suites: pairs of
// shapes in every degenerate position, and rings as they should not be. Coordinates and answers are
// our own, small enough that each is right by hand: areas, numbers of parts, and the nine
// intersections of interior, boundary and exterior.

#include <gtest/gtest.h>

#include <ostream>
#include <string>
#include <vector>

#include "plumb/io/plane_io.h"
#include "plumb/plane/nef2.h"

namespace plumb::testing {
namespace {

Nef2 set_of(const std::string& wkt) {
  Context context;
  return read_plane_set(wkt, PlaneFormat::Wkt, {"case"}, context);
}

/// What a closed set consists of.
struct Pieces {
  std::size_t polygons = 0;
  std::size_t segments = 0;  ///< in no polygon
  std::size_t points = 0;    ///< in no polygon and on no segment
  friend bool operator==(const Pieces&, const Pieces&) = default;
  friend std::ostream& operator<<(std::ostream& out, const Pieces& p) {
    return out << p.polygons << " polygons, " << p.segments << " segments, " << p.points
               << " points";
  }
};

Pieces pieces_of(const Nef2& set) {
  const PlaneParts parts = set.parts();
  Pieces pieces{parts.polygons.size(), 0, parts.points.size()};
  for (const auto& line : parts.lines) pieces.segments += line.size() - 1;
  return pieces;
}

char dimension(const Nef2& set) {
  if (!set.interior().is_empty()) return '2';
  const PlaneMarks& marks = set.complex().marks;
  for (const auto mark : marks.edge) {
    if (mark != 0) return '1';
  }
  return set.is_empty() ? 'F' : '0';
}

/// Dimensions of what interior, boundary and exterior of one have in common with those of the
/// other, row by row; F where that is nothing. For sets that are the closures of their interiors.
std::string nine_intersections(const Nef2& a, const Nef2& b) {
  std::string matrix;
  for (const Nef2& of_a : {a.interior(), a.boundary(), a.exterior()}) {
    for (const Nef2& of_b : {b.interior(), b.boundary(), b.exterior()}) {
      matrix += dimension(of_a * of_b);
    }
  }
  return matrix;
}

std::string transposed(const std::string& m) {
  return {m[0], m[3], m[6], m[1], m[4], m[7], m[2], m[5], m[8]};
}

// ---------------------------------------------------------------- pairs

struct Pair {
  const char* name;
  const char* a;
  const char* b;
  const char* area_a;
  const char* area_b;
  const char* area_both;
  Pieces both;
  Pieces either;
  const char* matrix;  ///< nullptr where one has lines or points
};

const char* const kSquare = "POLYGON ((0 0, 4 0, 4 4, 0 4, 0 0))";
const char* const kFrame = "POLYGON ((0 0, 6 0, 6 6, 0 6, 0 0), (2 2, 4 2, 4 4, 2 4, 2 2))";

const std::vector<Pair> kPairs{
    // Two areas.
    {"equal",
     kSquare,
     "POLYGON ((4 4, 0 4, 0 0, 4 0, 4 4))",
     "16",
     "16",
     "16",
     {1, 0, 0},
     {1, 0, 0},
     "2FFF1FFF2"},
    {"equal, with a corner more on an edge",
     kSquare,
     "POLYGON ((0 0, 2 0, 4 0, 4 1, 4 4, 0 4, 0 0))",
     "16",
     "16",
     "16",
     {1, 0, 0},
     {1, 0, 0},
     "2FFF1FFF2"},
    {"apart",
     kSquare,
     "POLYGON ((5 0, 6 0, 6 1, 5 0))",
     "16",
     "1/2",
     "0",
     {},
     {2, 0, 0},
     "FF2FF1212"},
    {"corner at corner",
     kSquare,
     "POLYGON ((4 4, 6 4, 6 6, 4 6, 4 4))",
     "16",
     "4",
     "0",
     {0, 0, 1},
     {2, 0, 0},
     "FF2F01212"},
    {"corner on an edge",
     kSquare,
     "POLYGON ((4 1, 6 0, 6 2, 4 1))",
     "16",
     "2",
     "0",
     {0, 0, 1},
     {2, 0, 0},
     "FF2F01212"},
    {"two corners on an edge",
     kSquare,
     "POLYGON ((4 1, 6 0, 6 4, 4 3, 5 2, 4 1))",
     "16",
     "5",
     "0",
     {0, 0, 2},
     {2, 0, 0},
     "FF2F01212"},
    {"a common edge",
     kSquare,
     "POLYGON ((4 0, 6 0, 6 4, 4 4, 4 0))",
     "16",
     "8",
     "0",
     {0, 1, 0},
     {1, 0, 0},
     "FF2F11212"},
    {"part of an edge in common",
     kSquare,
     "POLYGON ((4 1, 6 1, 6 3, 4 3, 4 1))",
     "16",
     "4",
     "0",
     {0, 1, 0},
     {1, 0, 0},
     "FF2F11212"},
    {"edges in common that overlap",
     kSquare,
     "POLYGON ((4 2, 6 2, 6 7, 4 7, 4 2))",
     "16",
     "10",
     "0",
     {0, 1, 0},
     {1, 0, 0},
     "FF2F11212"},
    {"an edge and a corner in common",
     kSquare,
     "POLYGON ((4 0, 6 0, 6 4, 4 4, 5 2, 4 1, 4 0))",
     "16",
     "13/2",
     "0",
     {0, 1, 1},
     {1, 0, 0},
     "FF2F11212"},
    {"corners in each other",
     kSquare,
     "POLYGON ((2 2, 6 2, 6 6, 2 6, 2 2))",
     "16",
     "16",
     "4",
     {1, 0, 0},
     {1, 0, 0},
     "212101212"},
    {"a cross",
     "POLYGON ((0 2, 6 2, 6 4, 0 4, 0 2))",
     "POLYGON ((2 0, 4 0, 4 6, 2 6, 2 0))",
     "12",
     "12",
     "4",
     {1, 0, 0},
     {1, 0, 0},
     "212101212"},
    {"overlap along collinear edges",
     kSquare,
     "POLYGON ((2 0, 6 0, 6 4, 2 4, 2 0))",
     "16",
     "16",
     "8",
     {1, 0, 0},
     {1, 0, 0},
     "212111212"},
    {"six-pointed star",
     "POLYGON ((0 0, 6 0, 3 6, 0 0))",
     "POLYGON ((0 4, 6 4, 3 -2, 0 4))",
     "18",
     "18",
     "12",
     {1, 0, 0},
     {1, 0, 0},
     "212101212"},
    {"crossing at no double",
     "POLYGON ((0 0, 3 1, 0 1, 0 0))",
     "POLYGON ((0 0, 1 0, 1 1, 0 0))",
     "3/2",
     "1/2",
     "1/3",
     {1, 0, 0},
     {1, 0, 0},
     "212101212"},
    {"inside",
     "POLYGON ((1 1, 2 1, 2 2, 1 1))",
     kSquare,
     "1/2",
     "16",
     "1/2",
     {1, 0, 0},
     {1, 0, 0},
     "2FF1FF212"},
    {"inside, a corner on an edge",
     "POLYGON ((1 1, 2 1, 2 4, 1 1))",
     kSquare,
     "3/2",
     "16",
     "3/2",
     {1, 0, 0},
     {1, 0, 0},
     "2FF10F212"},
    {"inside, an edge in common",
     "POLYGON ((1 4, 1 2, 3 2, 3 4, 1 4))",
     kSquare,
     "4",
     "16",
     "4",
     {1, 0, 0},
     {1, 0, 0},
     "2FF11F212"},
    {"both touch and cross",
     kSquare,
     "POLYGON ((0 0, 2 2, 6 0, 6 4, 4 4, 3 6, 0 0))",
     "16",
     "16",
     "7",
     {1, 0, 0},
     {1, 0, 0},
     "212101212"},
    {"hole and its filling",
     kFrame,
     "POLYGON ((2 2, 4 2, 4 4, 2 4, 2 2))",
     "32",
     "4",
     "0",
     {0, 4, 0},
     {1, 0, 0},
     "FF2F112F2"},
    {"in a hole",
     kFrame,
     "POLYGON ((5/2 5/2, 7/2 5/2, 3 3, 5/2 5/2))",
     "32",
     "1/4",
     "0",
     {},
     {2, 0, 0},
     "FF2FF1212"},
    {"in a hole, a corner on its rim",
     kFrame,
     "POLYGON ((2 3, 3 5/2, 3 7/2, 2 3))",
     "32",
     "1/2",
     "0",
     {0, 0, 1},
     {2, 0, 0},
     "FF2F01212"},
    {"in a hole, from corner to corner",
     kFrame,
     "POLYGON ((2 2, 4 4, 3 4, 2 3, 2 2))",
     "32",
     "3/2",
     "0",
     {0, 2, 0},
     {1, 0, 0},
     "FF2F11212"},
    {"over a hole",
     kFrame,
     "POLYGON ((1 1, 5 1, 5 5, 1 5, 1 1))",
     "32",
     "16",
     "12",
     {1, 0, 0},
     {1, 0, 0},
     "2121F12F2"},
    {"hole in hole",
     kFrame,
     "POLYGON ((0 0, 6 0, 6 6, 0 6, 0 0), (1 1, 5 1, 5 5, 1 5, 1 1))",
     "32",
     "20",
     "20",
     {1, 0, 0},
     {1, 0, 0},
     "212F11FF2"},
    {"holes that cross",
     kFrame,
     "POLYGON ((0 0, 6 0, 6 6, 0 6, 0 0), (3 3, 5 3, 5 5, 3 5, 3 3))",
     "32",
     "32",
     "29",
     {1, 0, 0},
     {1, 0, 0},
     "212111212"},
    {"combs",
     "POLYGON ((0 0, 1 0, 1 9, 2 9, 2 0, 3 0, 3 9, 4 9, 4 0, 5 0, 5 10, 0 10, 0 0))",
     "POLYGON ((-1 1, 8 1, 8 6, -1 6, -1 5, 7 5, 7 4, -1 4, -1 3, 7 3, 7 2, -1 2, -1 1))",
     "32",
     "29",
     "9",
     {9, 0, 0},
     {1, 0, 0},
     "212101212"},
    {"collinear spikes",
     "POLYGON ((0 0, 8 0, 4 4, 0 0))",
     "POLYGON ((2 0, 6 0, 4 -4, 2 0))",
     "16",
     "8",
     "0",
     {0, 1, 0},
     {1, 0, 0},
     "FF2F11212"},
    {"many at one corner",
     "MULTIPOLYGON (((0 0, 2 1, 2 -1, 0 0)), ((0 0, -2 1, -2 -1, 0 0)))",
     "MULTIPOLYGON (((0 0, 1 2, -1 2, 0 0)), ((0 0, 1 -2, -1 -2, 0 0)))",
     "4",
     "4",
     "0",
     {0, 0, 1},
     {4, 0, 0},
     "FF2F01212"},
    {"a pinwheel that closes",
     "MULTIPOLYGON (((0 0, 2 0, 2 2, 0 0)), ((0 0, -2 0, -2 -2, 0 0)))",
     "MULTIPOLYGON (((0 0, 2 2, 0 2, 0 0)), ((0 0, -2 -2, 0 -2, 0 0)))",
     "4",
     "4",
     "0",
     {0, 1, 0},
     {2, 0, 0},
     "FF2F11212"},

    // An area and lines.
    {"line through",
     kSquare,
     "LINESTRING (-2 2, 6 2)",
     "16",
     "0",
     "0",
     {0, 1, 0},
     {1, 2, 0},
     nullptr},
    {"line inside",
     kSquare,
     "LINESTRING (1 1, 2 3, 3 1)",
     "16",
     "0",
     "0",
     {0, 2, 0},
     {1, 0, 0},
     nullptr},
    {"line along an edge and on",
     kSquare,
     "LINESTRING (2 0, 7 0)",
     "16",
     "0",
     "0",
     {0, 1, 0},
     {1, 1, 0},
     nullptr},
    {"line past a corner",
     kSquare,
     "LINESTRING (3 6, 6 0)",
     "16",
     "0",
     "0",
     {0, 0, 1},
     {1, 2, 0},
     nullptr},
    {"line that ends on an edge",
     kSquare,
     "LINESTRING (4 2, 8 2)",
     "16",
     "0",
     "0",
     {0, 0, 1},
     {1, 1, 0},
     nullptr},
    {"line over a hole",
     kFrame,
     "LINESTRING (0 3, 6 3)",
     "32",
     "0",
     "0",
     {0, 2, 0},
     {1, 1, 0},
     nullptr},
    {"line on the rim of a hole",
     kFrame,
     "LINESTRING (2 2, 4 2, 4 4)",
     "32",
     "0",
     "0",
     {0, 2, 0},
     {1, 0, 0},
     nullptr},
    {"line from rim to rim",
     kFrame,
     "LINESTRING (2 2, 4 4)",
     "32",
     "0",
     "0",
     {0, 0, 2},
     {1, 1, 0},
     nullptr},
    {"in and out at the corners",
     kSquare,
     "LINESTRING (-1 -1, 5 5)",
     "16",
     "0",
     "0",
     {0, 1, 0},
     {1, 2, 0},
     nullptr},
    {"ring and its area",
     kSquare,
     "LINESTRING (0 0, 4 0, 4 4, 0 4, 0 0)",
     "16",
     "0",
     "0",
     {0, 4, 0},
     {1, 0, 0},
     nullptr},

    // Lines.
    {"lines that cross",
     "LINESTRING (0 0, 4 4)",
     "LINESTRING (0 4, 4 0)",
     "0",
     "0",
     "0",
     {0, 0, 1},
     {0, 4, 0},
     nullptr},
    {"lines that overlap",
     "LINESTRING (0 0, 4 0)",
     "LINESTRING (6 0, 2 0)",
     "0",
     "0",
     "0",
     {0, 1, 0},
     {0, 1, 0},
     nullptr},
    {"lines end to end",
     "LINESTRING (0 0, 2 1)",
     "LINESTRING (2 1, 4 2)",
     "0",
     "0",
     "0",
     {0, 0, 1},
     {0, 1, 0},
     nullptr},
    {"lines end to end with a bend",
     "LINESTRING (0 0, 2 1)",
     "LINESTRING (2 1, 4 0)",
     "0",
     "0",
     "0",
     {0, 0, 1},
     {0, 2, 0},
     nullptr},
    {"end on the inside of a line",
     "LINESTRING (0 0, 4 0)",
     "LINESTRING (2 0, 2 3)",
     "0",
     "0",
     "0",
     {0, 0, 1},
     {0, 3, 0},
     nullptr},
    {"overlap and a crossing",
     "LINESTRING (0 0, 6 0)",
     "LINESTRING (1 0, 3 0, 4 1, 5 -1)",
     "0",
     "0",
     "0",
     {0, 1, 1},
     {0, 6, 0},
     nullptr},
    {"one inside the other",
     "LINESTRING (0 0, 6 3)",
     "LINESTRING (2 1, 4 2)",
     "0",
     "0",
     "0",
     {0, 1, 0},
     {0, 1, 0},
     nullptr},
    {"ten lines through a point, two by two",
     "MULTILINESTRING ((-1 -1, 1 1), (-1 1, 1 -1))",
     "MULTILINESTRING ((-1 0, 1 0), (0 -1, 0 1))",
     "0",
     "0",
     "0",
     {0, 0, 1},
     {0, 8, 0},
     nullptr},

    // Points.
    {"point inside", kSquare, "POINT (1 1)", "16", "0", "0", {0, 0, 1}, {1, 0, 0}, nullptr},
    {"point on an edge", kSquare, "POINT (4 3)", "16", "0", "0", {0, 0, 1}, {1, 0, 0}, nullptr},
    {"point at a corner", kSquare, "POINT (4 4)", "16", "0", "0", {0, 0, 1}, {1, 0, 0}, nullptr},
    {"point outside", kSquare, "POINT (5 5)", "16", "0", "0", {}, {1, 0, 1}, nullptr},
    {"point in a hole", kFrame, "POINT (3 3)", "32", "0", "0", {}, {1, 0, 1}, nullptr},
    {"points on and off a line",
     "LINESTRING (0 0, 3 1)",
     "MULTIPOINT (0 0, 3/2 1/2, 1 1, 3 1)",
     "0",
     "0",
     "0",
     {0, 0, 3},
     {0, 1, 1},
     nullptr},
    {"point at point",
     "POINT (1 2)",
     "MULTIPOINT (1 2, 2 1)",
     "0",
     "0",
     "0",
     {0, 0, 1},
     {0, 0, 2},
     nullptr},

    // Everything.
    {"collections",
     "GEOMETRYCOLLECTION (POLYGON ((0 0, 4 0, 4 4, 0 4, 0 0)), LINESTRING (2 2, 8 2), POINT (9 9))",
     "GEOMETRYCOLLECTION (POLYGON ((6 0, 10 0, 10 4, 6 4, 6 0)), LINESTRING (2 2, 2 6), "
     "MULTIPOINT (9 9, 1 1))",
     "16",
     "16",
     "0",
     {0, 2, 2},
     {2, 2, 1},
     nullptr},
    {"nothing", "POLYGON EMPTY", kSquare, "0", "16", "0", {}, {1, 0, 0}, "FFFFFF212"},
};

TEST(OverlayCases, have_the_areas_and_parts_argued_by_hand) {
  for (const Pair& pair : kPairs) {
    SCOPED_TRACE(pair.name);
    const Nef2 a = set_of(pair.a);
    const Nef2 b = set_of(pair.b);
    const Rational area_a(pair.area_a);
    const Rational area_b(pair.area_b);
    const Rational both(pair.area_both);
    EXPECT_EQ(a.area(), area_a);
    EXPECT_EQ(b.area(), area_b);
    EXPECT_EQ((a * b).area(), both);
    EXPECT_EQ((a + b).area(), area_a + area_b - both);
    EXPECT_EQ((a - b).area(), area_a - both);
    EXPECT_EQ((b - a).area(), area_b - both);
    EXPECT_EQ((a ^ b).area(), area_a + area_b - 2 * both);
    EXPECT_EQ(pieces_of(a * b), pair.both);
    EXPECT_EQ(pieces_of(a + b), pair.either);
    for (const Nef2& set : {a * b, a + b, a - b, a ^ b}) EXPECT_FALSE(set.audit());
  }
}

TEST(OverlayCases, have_the_nine_intersections_argued_by_hand) {
  for (const Pair& pair : kPairs) {
    if (pair.matrix == nullptr) continue;
    SCOPED_TRACE(pair.name);
    const Nef2 a = set_of(pair.a);
    const Nef2 b = set_of(pair.b);
    EXPECT_EQ(nine_intersections(a, b), pair.matrix);
    EXPECT_EQ(nine_intersections(b, a), transposed(pair.matrix));
  }
}

// ---------------------------------------------------------------- rings

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
    const Nef2 set = set_of(ring.wkt);
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
      EXPECT_TRUE(set_of(text) == set_of(texts.front())) << text;
    }
  }
}

}  // namespace
}  // namespace plumb::testing
