#include "plumb/io/plane/wkt.h"

#include <gtest/gtest.h>

#include <cfenv>
#include <sstream>
#include <string>
#include <tuple>
#include <vector>

#include "expect_refusals.h"
#include "hostile_shapes.h"
#include "plumb/io/plane/wkt.h"

namespace plumb::wkt_test {
namespace {

PlaneShapes read(const std::string& text, bool exact_decimals = false, Limits limits = {}) {
  Context context(limits);
  return read_wkt(text, {"some.file", exact_decimals}, context).shapes;
}

std::vector<std::string> notes_of(const std::string& text) {
  Context context;
  return read_wkt(text, {"some.file"}, context).notes;
}

std::string written(const PlaneShapes& shapes) {
  std::ostringstream out;
  Context context;
  write_wkt(out, shapes, context);
  return out.str();
}

TEST(WktReader, refuses_hostile_texts_with_their_place) {
  testing::expect_refusals(testing::hostile_wkt(), [](const std::string& text) { read(text); });
}

TEST(WktReader, accepts_what_the_format_allows) {
  const std::vector<std::pair<std::string, std::vector<std::string>>> same{
      {"POINT (1 2)\n",
       {"POINT (1 2)", "point(1 2)", "Point  ( 1\t2 )\r\n", "POINT\n(\n1\n2\n)\n", "POINT (+1 2.0)",
        "# a point\n\n  POINT (1 2) \n# that was it", "\xEF\xBB\xBFPOINT (1 2)", "POINT (3/3 2e0)",
        "POINT Z (1 2 3)", "POINT M (1 2 3)", "point zm (1 2 3 4)", "MULTIPOINT (1 2)",
        "MULTIPOINT ((1 2))", "MULTIPOINT (EMPTY, 1 2)", "GEOMETRYCOLLECTION (POINT (1 2))",
        "GEOMETRYCOLLECTION (POINT EMPTY, GEOMETRYCOLLECTION (POINT (1 2)))",
        "GEOMETRYCOLLECTION Z (POINT Z (1 2 3))", "POINT EMPTY POINT (1 2)",
        // Dialects: PostGIS, SQL Server, GeoSPARQL, JTS, C libraries.
        "SRID=4326;POINT(1 2)", "srid=-1 ; point (1 2);", "POINT (1 2 3)", "POINT (1 2 3 4)",
        "POINTZ (1 2 3)", "pointm(1 2 3)", "PointZM (1 2 3 4)", "POINT Z (1 2 NaN)",
        "POINT (1 2 NULL 4)", "POINT ZM (1 2 -inf +Infinity)", "POINT M (1 2 -nan(ind))",
        "POINT (1 2 1.#QNAN)", "POINT Z (1 2 1e999999)", "MULTIPOINT Z ((1 2 3))",
        "MULTIPOINTZ (1 2 3)", "GEOMETRYCOLLECTION Z (POINT (1 2 3))",
        "GEOMETRYCOLLECTIONM (POINTM (1 2 3), POINT EMPTY)",
        "<http://www.opengis.net/def/crs/OGC/1.3/CRS84> POINT (1 2)",
        "<urn:ogc:def:crs:OGC::CRS84>POINT (1 2)", ";;POINT (1 2);", "MULTIPOINT ((), (1 2))",
        "POINT () POINT (1 2)", "TIN EMPTY; POINT (1 2)"}},
      {"MULTIPOINT ((1 2), (3 4))\n",
       {"MULTIPOINT (1 2, 3 4)", "MULTIPOINT ((1 2), 3 4)", "POINT (1 2)\nPOINT (3 4)\n",
        "POINT (1 2) POINT (3 4)", "POINT(1 2)POINT(3 4)", "POINT (1 2);POINT (3 4);\n",
        "SRID=1;POINT (1 2)\nSRID=2;POINT (3 4)", "POINT Z (1 2 3) POINT (3 4)",
        "GEOMETRYCOLLECTION (POINT (1 2), POINT (3 4))"}},
      {"LINESTRING (0 0, 1 1, 0 0)\n",
       {"linestring (0 0,1 1 , 0 0)", "MULTILINESTRING ((0 0, 1 1, 0 0))",
        "MULTILINESTRING (EMPTY, (0 0, 1 1, 0 0))", "MULTICURVE ((0 0, 1 1, 0 0))",
        "MULTICURVE Z (LINESTRING Z (0 0 7, 1 1 7, 0 0 7))",
        "LINESTRING (0 0 1 2, 1 1 3 4, 0 0 5 6)"}},
      {"POLYGON ((0 0, 3 0, 0 3, 0 0), (1 1, 2 1, 1 2, 1 1))\n",
       {"POLYGON((0 0,3 0,0 3,0 0),(1 1,2 1,1 2,1 1))",
        "CURVEPOLYGON((0 0,3 0,0 3,0 0),(1 1,2 1,1 2,1 1))",
        "CURVEPOLYGON(LINESTRING(0 0,3 0,0 3,0 0),(1 1,2 1,1 2,1 1))",
        "# caf\xE9\rPOLYGON((0 0,3 0,0 3,0 0),\r(1 1,2 1,1 2,1 1))\r",
        "MULTISURFACE (CURVEPOLYGON Z ((0 0 1, 3 0 1, 0 3 1, 0 0 1), (1 1 1, 2 1 1, 1 2 1, 1 1 "
        "1)))",
        "POLYGON (EMPTY, (0 0, 3 0, 0 3, 0 0), EMPTY, (1 1, 2 1, 1 2, 1 1))",
        "MULTIPOLYGON (((0 0, 3 0, 0 3, 0 0), (1 1, 2 1, 1 2, 1 1)))",
        "MULTIPOLYGON (EMPTY, ((0 0, 3 0, 0 3, 0 0), (1 1, 2 1, 1 2, 1 1)), EMPTY)",
        "MULTISURFACE (((0 0, 3 0, 0 3, 0 0), (1 1, 2 1, 1 2, 1 1)))",
        "MULTISURFACE (EMPTY, POLYGON ((0 0, 3 0, 0 3, 0 0), (1 1, 2 1, 1 2, 1 1)))",
        "POLYGON((0 0 5,3 0 6,0 3 7,0 0 5),(1 1 0,2 1 0,1 2 0,1 1 0))",
        "POLYGONZ((0 0 5,3 0 6,0 3 7,0 0 5),(1 1 0,2 1 0,1 2 0,1 1 0))"}},
      {"MULTIPOLYGON (((0 0, 1 0, 0 1, 0 0)), ((5 5, 6 5, 5 6, 5 5)))\n",
       {"POLYGON ((0 0, 1 0, 0 1, 0 0)) POLYGON ((5 5, 6 5, 5 6, 5 5))",
        "LINEARRING (0 0, 1 0, 0 1, 0 0) LINEARRING Z (5 5 1, 6 5 1, 5 6 1, 5 5 1)",
        "TRIANGLE ((0 0, 1 0, 0 1, 0 0)); TRIANGLE ((5 5, 6 5, 5 6, 5 5))",
        "TIN (((0 0, 1 0, 0 1, 0 0)), ((5 5, 6 5, 5 6, 5 5)))",
        "TIN Z (((0 0 7, 1 0 7, 0 1 7.0, 0 0 7)), TRIANGLE Z ((5 5 7, 6 5 nan, 5 6 7, 5 5 7)))",
        "TIN M (((0 0 1, 1 0 2, 0 1 3, 0 0 4)), ((5 5 6, 6 5 7, 5 6 8, 5 5 9)))",
        "POLYHEDRALSURFACE (((0 0 7, 1 0 7, 0 1 7, 0 0 7)), ((5 5 7, 6 5 7, 5 6 7, 5 5 7)))",
        "TIN (((0 0 1, 1 0 1, 0 1 1, 0 0 1))) TIN (((5 5 2, 6 5 2, 5 6 2, 5 5 2)))"}},
      {"GEOMETRYCOLLECTION EMPTY\n",
       {"POINT EMPTY", "LINESTRING empty", "POLYGON EMPTY", "MULTIPOINT EMPTY",
        "MULTILINESTRING EMPTY", "MULTIPOLYGON EMPTY", "GEOMETRYCOLLECTION EMPTY", "POINT Z EMPTY",
        "MULTIPOLYGON (EMPTY, (EMPTY))", "POINT ()", "POLYGON ()", "POLYGON (())", "TIN Z EMPTY",
        "MULTIPOLYGON (((), ()), EMPTY)", "GEOMETRYCOLLECTION ()", "LINEARRING EMPTY"}},
      {"GEOMETRYCOLLECTION (POLYGON ((0 0, 1 0, 0 1, 0 0)), LINESTRING (0 0, 5 5), POINT (7 8))\n",
       {"POINT (7 8)\nLINESTRING (0 0, 5 5)\nPOLYGON ((0 0, 1 0, 0 1, 0 0))"}},
  };
  for (const auto& [expected, texts] : same) {
    for (const std::string& text : texts) {
      EXPECT_EQ(written(read(text)), expected) << text;
    }
  }
}

// The closing position may be missing. If the ends differ by 1e-300, the edge has this length.
TEST(WktReader, closes_rings_with_a_note) {
  const auto note = [](int rings) {
    return std::vector<std::string>{
        "closed by an edge: rings that end elsewhere than they start (" + std::to_string(rings) +
        ")"};
  };
  const std::vector<std::tuple<std::string, std::string, std::vector<std::string>>> cases{
      {"POLYGON ((0 0, 9 0, 0 9), (1 1, 2 1, 1 2))",
       "POLYGON ((0 0, 9 0, 0 9, 0 0), (1 1, 2 1, 1 2, 1 1))\n", note(2)},
      {"POLYGON ((0 0, 9 0, 0 9, 0 0), (1 1, 2 1, 1 2))",
       "POLYGON ((0 0, 9 0, 0 9, 0 0), (1 1, 2 1, 1 2, 1 1))\n", note(1)},
      {"POLYGON ((0 0, 1 0, 1 1, 0 1e-300))", "POLYGON ((0 0, 1 0, 1 1, 0 1e-300, 0 0))\n",
       note(1)},
      {"TRIANGLE ((0 0, 1 0, 0 1))", "POLYGON ((0 0, 1 0, 0 1, 0 0))\n", note(1)},
      {"POLYGON ((0 0, 1 0, 0 1, 0 0))", "POLYGON ((0 0, 1 0, 0 1, 0 0))\n", {}},
  };
  for (const auto& [text, expected, notes] : cases) {
    EXPECT_EQ(written(read(text)), expected) << text;
    EXPECT_EQ(notes_of(text), notes) << text;
  }
}

TEST(WktReader, names_what_it_drops_once) {
  const std::vector<std::pair<std::string, std::vector<std::string>>> cases{
      {"POINT (1 2)", {}},
      {"MULTIPOINT (EMPTY, (1 2)); LINEARRING EMPTY", {}},
      {"POINT Z EMPTY", {}},
      {"MULTIPOINT (1 2 3, 4 5 6)", {"passed over: heights (Z)"}},
      {"POINT M (1 2 3) POINTM (4 5 nan)", {"passed over: measures (M)"}},
      {"SRID=1;POINT ZM (1 2 3 4)\n<http://a/b> POINT (1 2)",
       {"passed over: coordinate reference systems, heights (Z), measures (M)"}},
      {"LINEARRING (0 0, 1 0, 0 1, 0 0) LINEARRING (0 0, 1 0, 0 1, 0 0)",
       {"a LINEARRING is read as the polygon that it bounds"}},
  };
  for (const auto& [text, notes] : cases) EXPECT_EQ(notes_of(text), notes) << text;
}

TEST(WktReader, knows_how_its_dialects_begin) {
  for (const std::string text :
       {"POINT (1 2)", "polygonz((", "Tin", "CircularString (0 0", "COMPOUNDCURVEZM (", "FULLGLOBE",
        "SRID=4326;x", "srid=", "<http://a>", "<urn:b>POINT", "GEOMETRYCOLLECTION"}) {
    EXPECT_TRUE(begins_like_wkt(text)) << text;
  }
  for (const std::string text : {"", "POINTS (1 2)", "v 1 2 3", "OFF", "<?xml?>", "<svg>",
                                 "solid t", "1 2", "SRI", "(0 0)", "M", "mtllib a.mtl"}) {
    EXPECT_FALSE(begins_like_wkt(text)) << text;
  }
}

TEST(WktReader, takes_64_nested_collections) {
  const std::string text =
      testing::repeated("GEOMETRYCOLLECTION(", 64) + "POINT(1 2)" + testing::repeated(")", 64);
  EXPECT_EQ(read(text).single_points.size(), 1U);
}

TEST(WktReader, reads_numbers_exactly) {
  const PlaneShapes shapes =
      read("MULTIPOINT (1/3 -22/7, 9007199254740993 123456789012345678901234567890, 0.1 5e-324)");
  EXPECT_EQ(shapes.points.exact(0), (RationalPoint2{Rational(1, 3), Rational(-22, 7)}));
  EXPECT_EQ(shapes.points.exact(1), (RationalPoint2{Rational("9007199254740993"),
                                                    Rational("123456789012345678901234567890")}));
  EXPECT_EQ(shapes.points.exact(2), (RationalPoint2{Rational(0.1), Rational(5e-324)}));
  EXPECT_EQ(read("POINT (0.1 0)", true).points.exact(0).x, Rational(1, 10));
}

TEST(WktReader, rounds_to_nearest_in_every_rounding_mode) {
  for (const int mode : {FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO}) {
    std::fesetround(mode);
    const PlaneShapes shapes = read("POINT (0.1 0.3)");
    EXPECT_EQ(std::fegetround(), mode);
    std::fesetround(FE_TONEAREST);
    EXPECT_EQ(shapes.points.approx(0), (Point2{0.1, 0.3}));
  }
}

TEST(WktReader, keeps_to_its_limits) {
  const std::string text = "MULTIPOINT (" + testing::repeated("1 2,", 20000) + "1 2)";
  Limits limits;
  limits.max_memory_bytes = 20000 * sizeof(Point2);
  EXPECT_THROW(read(text, false, limits), Error);
  limits.max_memory_bytes *= 3;
  EXPECT_EQ(read(text, false, limits).single_points.size(), 20001U);
  std::stop_source source;
  source.request_stop();
  Context context({}, source.get_token());
  EXPECT_THROW(read_wkt("POINT (1 2)", {}, context), Error);
}

TEST(WktWriter, writes_doubles_that_read_back) {
  PlaneShapes shapes;
  const std::vector<Point2> points{{0.1, -0.3333333333333333}, {1e23, 5e-324}, {-7, 1e15}};
  for (const Point2 p : points) {
    shapes.single_points.push_back(static_cast<std::uint32_t>(shapes.points.size()));
    shapes.points.push_back(p);
  }
  const PlaneShapes copy = read(written(shapes));
  for (std::uint32_t i = 0; i < points.size(); ++i) EXPECT_EQ(copy.points.approx(i), points[i]);
  EXPECT_NE(written(shapes).find("(-7 1000000000000000)"), std::string::npos) << written(shapes);
}

}  // namespace
}  // namespace plumb::wkt_test
