#include "plumb/io/plane/geojson.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "expect_refusals.h"
#include "hostile_shapes.h"
#include "plumb/io/plane/geojson.h"

namespace plumb::geojson_test {
namespace {

PlaneShapes read(const std::string& text, bool exact_decimals = false, Limits limits = {}) {
  Context context(limits);
  return read_geojson(text, {"some.file", exact_decimals}, context).shapes;
}

std::vector<std::string> notes_of(const std::string& text) {
  Context context;
  return read_geojson(text, {"some.file"}, context).notes;
}

std::string written(const PlaneShapes& shapes) {
  std::ostringstream out;
  Context context;
  write_geojson(out, shapes, context);
  return out.str();
}

TEST(GeoJsonReader, refuses_hostile_texts_with_their_place) {
  testing::expect_refusals(testing::hostile_geojson(), [](const std::string& text) { read(text); });
}

const std::string kPoint = R"({"type":"Point","coordinates":[1,2]})";
const std::string kPolygon =
    R"({"type":"Polygon","coordinates":[[[0,0],[3,0],[0,3],[0,0]],[[1,1],[2,1],[1,2],[1,1]]]})";

TEST(GeoJsonReader, accepts_what_the_format_allows) {
  const std::vector<std::pair<std::string, std::vector<std::string>>> same{
      {kPoint,
       {kPoint, "\xEF\xBB\xBF" + kPoint, R"( { "coordinates" : [ 1 , 2.0 ] ,
 "type" : "Point" } )",
        R"({"type":"Point","coordinates":[1,2,300]})",
        R"({"type":"MultiPoint","coordinates":[[1,2]]})",
        R"({"type":"Point","coordinates":[10e-1,2],"bbox":[1,2,1,2],"crs":{"type":"name",)"
        R"("coordinates":[[],{}]}})",
        R"({"type":"Feature","geometry":)" + kPoint +
            R"(,"properties":{"type":"x","coordinates":0}})",
        R"({"geometry":)" + kPoint + R"(,"id":7,"properties":null,"type":"Feature"})",
        R"({"type":"FeatureCollection","features":[{"type":"Feature","geometry":null,)"
        R"("properties":{}},{"type":"Feature","geometry":)" +
            kPoint + "}]}",
        R"({"features":[{"type":"Feature","geometry":{"type":"GeometryCollection","geometries":[)" +
            kPoint + R"(]}}],"type":"FeatureCollection"})",
        R"({"type":"GeometryCollection","geometries":[null,)" + kPoint + ",null]}",
        R"({"type":"FeatureCollection","features":[{"type":"Feature","id":1},)"
        R"({"type":"Feature","geometry":)" +
            kPoint + "}]}",
        R"({"a":1,"b":-1.5e3,"c":"x","d":[1,[2,{"e":3}]],"type":"Point","f":true,)"
        R"("coordinates":[1,2],"g":null})",
        // What is dropped may be anything that has an end.
        R"({"type":"Point","coordinates":[1,2],"a":NaN,"b":[-Infinity,inf,nan,+1],"c":undefined})",
        R"({"type":"Point","coordinates":[1,2,NaN]})",
        R"({"type":"Point","coordinates":[1,2,null]})",
        R"({"type":"Point","coordinates":[1,2,-inf,1e999999]})",
        "{\"type\":\"Point\",\"coordinates\":[1,2],\"caf\xE9\":\"caf\xE9\t\n\"}",
        R"({"type":"Point","coordinates":[1,2],"a":"\\\"\\\\","b":{"c":"]}","d":["\u12"]}})",
        R"({"\u0074ype":"Po\u0069nt","coordinates":[1,2]})",
        R"({"type":"MultiPoint","coordinates":[[],[1,2],[]]})",
        // Sequences.
        "\x1e" + kPoint + "\n", R"({"type":"Feature","geometry":null})" + kPoint,
        kPoint + "\n\n" + R"({"type":"FeatureCollection","features":[]})" + "\r\n"}},
      {R"({"type":"MultiPoint","coordinates":[[1,2],[3,4]]})",
       {R"({"type":"MultiPoint","coordinates":[[1,2],[3,4]]})",
        "\x1e" + kPoint + "\n\x1e" + R"({"type":"Point","coordinates":[3,4]})" + "\n",
        R"({"type":"Feature","geometry":)" + kPoint + "}\n" +
            R"({"type":"Feature","geometry":{"type":"Point","coordinates":[3,4]}})"}},
      {R"({"type":"LineString","coordinates":[[0,0],[1,1]]})",
       {R"({"type":"LineString","coordinates":[[0,0],[1,1]]})",
        R"({"type":"MultiLineString","coordinates":[[],[[0,0],[1,1]],[]]})"}},
      {R"({"type":"MultiLineString","coordinates":[[[0,0],[1,1]],[[2,2],[3,3]]]})",
       {R"({"coordinates":[[[0,0],[1,1]],[[2,2],[3,3]]],"type":"MultiLineString"})"}},
      {kPolygon,
       {kPolygon, R"({"type":"MultiPolygon","coordinates":[[],[[],[[0,0],[3,0],[0,3],[0,0]],[],)"
                  R"([[1,1],[2,1],[1,2],[1,1]]],[]]})"}},
      {R"({"type":"MultiPolygon","coordinates":[[[[0,0],[1,0],[0,1],[0,0]]],)"
       R"([[[5,5],[6,5],[5,6],[5,5]]]]})",
       {R"({"type":"GeometryCollection","geometries":[)"
        R"({"type":"Polygon","coordinates":[[[0,0],[1,0],[0,1],[0,0]]]},)"
        R"({"type":"Polygon","coordinates":[[[5,5],[6,5],[5,6],[5,5]]]}]})"}},
      {R"({"type":"GeometryCollection","geometries":[]})",
       {R"({"type":"Point","coordinates":[]})",
        R"({"type":"MultiPolygon","coordinates":[[[]],[]]})",
        R"({"type":"Polygon","coordinates":[]})", R"({"type":"FeatureCollection","features":[]})",
        R"({"type":"Feature","geometry":null})"}},
  };
  for (const auto& [expected, texts] : same) {
    EXPECT_TRUE(nlohmann::json::accept(expected));
    for (const std::string& text : texts) EXPECT_EQ(written(read(text)), expected + '\n') << text;
  }
}

TEST(GeoJsonReader, reads_numbers_by_the_rules_of_all_formats) {
  const PlaneShapes shapes = read(
      R"({"type":"MultiPoint","coordinates":[[9007199254740993,-123456789012345678901234567890],)"
      R"([-0,0.1],[1E2,18446744073709551616]]})");
  EXPECT_EQ(shapes.points.exact(0), (RationalPoint2{Rational("9007199254740993"),
                                                    Rational("-123456789012345678901234567890")}));
  EXPECT_EQ(shapes.points.exact(1), (RationalPoint2{0, Rational(0.1)}));
  EXPECT_EQ(shapes.points.exact(2), (RationalPoint2{100, Rational("18446744073709551616")}));
  const auto x = [](const std::string& number, bool exact_decimals) {
    const std::string text = R"({"type":"Point","coordinates":[)" + number + ",0]}";
    return read(text, exact_decimals).points.exact(0).x;
  };
  EXPECT_EQ(x("0.1", true), Rational(1, 10));
  EXPECT_EQ(x("1e1000", true), Rational("1" + std::string(1000, '0')));
  EXPECT_EQ(x(std::string(1000, '9'), false), Rational(std::string(1000, '9')));
}

TEST(GeoJsonReader, names_what_it_drops_once) {
  const auto feature = [](const std::string& members) {
    return R"({"type":"Feature",)" + members + R"("geometry":)" + kPoint + "}\n";
  };
  const std::vector<std::pair<std::string, std::vector<std::string>>> cases{
      {kPoint, {}},
      {feature(R"("properties":{},"id":null,"bbox":[],)"), {}},
      {feature(R"("properties":{"a":1},)") + feature(R"("properties":{"b":2},"id":7,)"),
       {"passed over: 'properties', 'id'"}},
      {R"({"type":"MultiPoint","coordinates":[[1,2,3],[1,2,4]],"crs":{"type":"name"}})",
       {"passed over: 'crs', numbers of positions after x and y"}},
      {R"({"type":"Polygon","coordinates":[[[0,0],[9,0],[0,9]],[[1,1],[2,1],[1,2],[1,1]]]})",
       {"closed by an edge: rings that end elsewhere than they start (1)"}},
      {R"({"type":"Point","coordinates":[1,2,null]})",
       {"passed over: numbers of positions after x and y"}},
  };
  for (const auto& [text, notes] : cases) EXPECT_EQ(notes_of(text), notes) << text;
  std::string many;
  for (int i = 10; i < 99; ++i) many += feature("\"n" + std::to_string(i) + "\":1,");
  ASSERT_EQ(notes_of(many).size(), 1U);
  EXPECT_TRUE(notes_of(many)[0].starts_with("passed over: 'n10', 'n11', ")) << notes_of(many)[0];
  EXPECT_TRUE(notes_of(many)[0].ends_with(", 'n21', other members")) << notes_of(many)[0];
}

TEST(GeoJsonReader, skips_what_is_deep) {
  const std::string deep =
      testing::repeated("[{\"a\":", 100'000) + "0" + testing::repeated("}]", 100'000);
  EXPECT_EQ(read(R"({"properties":)" + deep + R"(,"type":"Feature","geometry":)" + kPoint + "}")
                .single_points.size(),
            1U);
}

TEST(GeoJsonReader, keeps_to_its_limits) {
  const std::string text =
      R"({"type":"MultiPoint","coordinates":[)" + testing::repeated("[1,2],", 20000) + "[1,2]]}";
  Limits limits;
  limits.max_memory_bytes = 20000 * sizeof(Point2);
  EXPECT_THROW(read(text, false, limits), Error);
  limits.max_memory_bytes *= 3;
  EXPECT_EQ(read(text, false, limits).single_points.size(), 20001U);
  std::stop_source source;
  source.request_stop();
  Context context({}, source.get_token());
  EXPECT_THROW(read_geojson(kPoint, {}, context), Error);
}

}  // namespace
}  // namespace plumb::geojson_test
