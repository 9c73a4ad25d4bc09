// Malformed WKT, GeoJSON and .nef2 as data: shared by the readers' tests and the program's.
#pragma once

#include <string>
#include <vector>

#include "hostile_text.h"

namespace plumb::testing {

inline std::vector<HostileText> hostile_wkt() {
  const std::string million(1'000'000, '7');
  return {
      {"empty", "", 1, 1, "no content"},
      {"only blank lines and comments", "\n  \n# nothing\n", 4, 1, "no content"},
      {"binary with zero bytes", bytes_with_nul("\0\0\0\1\2", 5), 1, 1, "byte 0x00"},
      {"a lone carriage return", "POINT\n(1\r2)\n", 2, 3, "carriage return"},
      {"another word", "SQUARE (1 2)", 1, 1, "expected POINT"},
      {"a word that begins well", "POINTS (1 2)", 1, 1, "'POINTS'"},
      {"a number", "  1 2", 1, 3, "'1'"},
      {"a parenthesis", "(1 2)", 1, 1, "'('"},
      {"SRID without a number", "SRID=x;POINT (1 2)", 1, 1, "SRID=NUMBER;, found 'SRID=x'"},
      {"SRID without a semicolon", "SRID=4326 POINT (1 2)", 1, 11, "';', found 'POINT'"},
      {"SRID without a geometry", "SRID=4326;", 1, 11, "a geometry, found the end"},
      {"two SRIDs", "SRID=1;SRID=2;POINT (1 2)", 1, 8, "found 'SRID=2'"},
      {"an open URI", "<http://a/CRS84 POINT (1 2)", 1, 17, "'>', found 'POINT'"},
      {"only semicolons", ";\n;;\n", 3, 1, "no content"},
      {"a semicolon within", "LINESTRING (0 0; 1 1)", 1, 16, "',' or ')', found ';'"},
      {"a circle", "CIRCULARSTRING (0 0, 1 1, 2 0)", 1, 1, "ST_CurveToLine"},
      {"a curve with heights", "\nCompoundCurveZ ((0 0 1, 1 1 1))", 2, 1, "curves are not read"},
      {"a curved ring", "CURVEPOLYGON(CIRCULARSTRING(0 0,4 0,4 4,0 4,0 0))", 1, 14,
       "'CIRCULARSTRING': curves"},
      {"a curve in a MULTICURVE", "MULTICURVE ((0 0, 1 1), CIRCULARSTRING (0 0, 1 1, 2 0))", 1, 25,
       "curves are not read"},
      {"a polygon in a MULTICURVE", "MULTICURVE (POLYGON ((0 0, 1 0, 0 1, 0 0)))", 1, 13,
       "a LINESTRING or '(', found 'POLYGON'"},
      {"a line in a TIN", "TIN (LINESTRING (0 0, 1 1))", 1, 6, "a POLYGON or '('"},
      {"the globe", "FULLGLOBE", 1, 1, "whole plane"},
      {"a surface in space", "TIN Z (((0 0 0, 1 0 0, 0 1 1, 0 0 0)))", 1, 28, "heights differ"},
      {"faces at different heights",
       "POLYHEDRALSURFACE (((0 0 0, 1 0 0, 0 1 0, 0 0 0)), ((0 0 1, 1 0 1, 0 1 1, 0 0 1)))", 1, 58,
       "heights differ"},
      {"no parenthesis", "POINT 1 2", 1, 7, "'(' or EMPTY"},
      {"nothing after the word", "POINT", 1, 6, "'(' or EMPTY, found the end of the file"},
      {"truncated in a position", "POINT (1", 1, 9, "a number, found the end"},
      {"truncated after a position", "POINT (1 2\n\n", 3, 1, "',' or ')', found the end"},
      {"truncated in a list", "LINESTRING (1 2,", 1, 17, "a number, found the end"},
      {"one coordinate", "POINT (1)", 1, 9, "expected a number, found ')'"},
      {"five coordinates", "POINT (1 2 3 4 5)", 1, 16, "',' or ')'"},
      {"four with a height announced", "POINTZ (1 2 3 4)", 1, 15, "',' or ')'"},
      {"a position of more numbers", "LINESTRING (0 0, 1 1 1)", 1, 22, "',' or ')'"},
      {"a position of fewer numbers", "LINESTRING (0 0 1, 1 1)", 1, 23, "a number, found ')'"},
      {"a word for a height", "POINT (1 2 high)", 1, 12, "a number, found 'high'"},
      {"NULL for y", "POINT (1 NULL)", 1, 10, "a number, found 'NULL'"},
      {"an open nan", "POINT (1 2 nan(ind", 1, 19, "')', found the end"},
      {"two dimensions", "POINTZ M (1 2 3)", 1, 8, "'(' or EMPTY, found 'M'"},
      {"two with a height announced", "POINT Z (1 2)", 1, 13, "expected a number, found ')'"},
      {"two commas", "LINESTRING (0 0,, 1 1)", 1, 17, "a number, found ','"},
      {"a comma at the end", "LINESTRING (0 0, 1 1,)", 1, 22, "a number, found ')'"},
      {"a comma within a position", "LINESTRING (0, 0 1, 1)", 1, 14, "a number, found ','"},
      {"parentheses that never close", "POLYGON ((0 0, 1 0, 0 1, 0 0)", 1, 30, "found the end"},
      {"one more parenthesis", "POINT (1 2))", 1, 12, "')'"},
      {"geometries with a comma", "POINT (1 2), POINT (3 4)", 1, 12, "','"},
      {"a polygon of positions", "POLYGON (0 0, 1 0, 0 1, 0 0)", 1, 10, "'(' or EMPTY, found '0'"},
      {"a line of rings", "LINESTRING ((0 0, 1 1))", 1, 13, "a number, found '('"},
      {"a point of two positions", "POINT (1 2, 3 4)", 1, 16, "more than one position"},
      {"a line of one position", "LINESTRING (1 2)", 1, 16, "at least 2"},
      {"a ring of three positions", "POLYGON ((0 0, 1 0, 0 0))", 1, 24, "at least 4"},
      {"a ring over several lines", "POLYGON ((0 0,\n1 0,\n0 0\n  ))", 4, 3, "at least 4"},
      {"an open ring of two positions", "POLYGON ((0 0, 9 0, 0 9), (1 1, 2 1))", 1, 36,
       "at least 4"},
      {"nan", "POINT (nan 0)", 1, 8, "'nan'"},
      {"-inf", "POINT (0 -inf)", 1, 10, "'-inf'"},
      {"hexadecimal", "POINT (0x1p3 0)", 1, 8, "'0x1p3'"},
      {"1/0", "POINT (0 1/0)", 1, 12, "denominator is 0"},
      {"1/2/3", "POINT (0 1/2/3)", 1, 10, "'1/2/3'"},
      {"1e400", "POINT (0 1e400)", 1, 10, "largest double"},
      {"1e999999999", "POINT (1e999999999 0)", 1, 8, "largest double"},
      {"10^6 digits", "POINT (0 " + million + ")", 1, 10, "1000000 characters"},
      {"on the second line", "POINT (1 2)\nPOINT (1 x)\n", 2, 10, "'x'"},
      {"65 collections", repeated("GEOMETRYCOLLECTION(", 65) + "POINT(1 2)" + repeated(")", 65), 1,
       65 * 19 + 1, "more than 64"},
      {"10^5 collections", repeated("GEOMETRYCOLLECTION(", 100'000), 1, 65 * 19 + 1,
       "more than 64"},
      {"10^5 collections, one a line", repeated("GEOMETRYCOLLECTION(\n", 100'000), 66, 1,
       "more than 64"},
  };
}

inline std::vector<HostileText> hostile_geojson() {
  const std::string million(1'000'000, '7');
  const auto polygon = [](const std::string& coordinates) {
    return R"({"type":"Polygon","coordinates":)" + coordinates + "}";
  };
  return {
      {"empty", "", 1, 1, "no content"},
      {"blank", " \n\n", 3, 1, "no content"},
      {"binary with zero bytes", bytes_with_nul("\0\0\0\1\2", 5), 1, 1, "not JSON"},
      {"words", "hello (1 2)", 1, 1, "not JSON: invalid literal 'hello'"},
      {"a number", "12", 1, 1, "expected an object"},
      {"a string", "\"Point\"", 1, 1, "expected an object"},
      {"null", "null", 1, 1, "expected an object"},
      {"an array", "[]", 1, 1, "expected an object"},
      {"an object without a type", "\n {\"coordinates\": [1, 2]}", 2, 2, "without \"type\""},
      {"truncated", R"({"type":"Point","coordinates":[1,)", 1, 34, "unexpected end of input"},
      {"the second object has no type", R"({"type":"Point","coordinates":[1,2]} {})", 1, 38,
       "without \"type\""},
      {"the second value is a number", R"({"type":"Point","coordinates":[1,2]} 3)", 1, 38,
       "expected an object"},
      {"objects with a comma", R"({"type":"Point","coordinates":[1,2]},{})", 1, 37,
       "a value, found ','"},
      {"truncated in the second line",
       "{\"type\":\"Point\",\"coordinates\":[1,2]}\n{\"type\":\"Point\",", 2, 17,
       "unexpected end of input"},
      {"a record separator in an object", "{\x1e}", 1, 2, "byte 0x1e"},
      {"a comma too many", R"({"type":"Point","coordinates":[1,2,]})", 1, 36, "not JSON"},
      {"a comment", R"({"type":"Point", // here
"coordinates":[1,2]})",
       1, 18, "not JSON"},
      {"Latin-1 in a type", "{\"type\":\"caf\xE9\"}", 1, 9, "none of GeoJSON's"},
      {"Latin-1 outside of strings", "{\xE9}", 1, 2, "byte 0xe9"},
      {"a name that does not end", "{\"type", 1, 2, "does not end"},
      {"a property that does not end", "{\"a\":\"x", 1, 6, "does not end"},
      {"a list of another bracket", R"({"properties":[{"a":[1}]}])", 1, 23, "']', found '}'"},
      {"a member without a value", R"({"properties":})", 1, 15, "a value, found '}'"},
      {"a member without a colon", R"({"type" "Point"})", 1, 9, "':', found '\"Point'"},
      {"a property that never closes", R"({"properties":{"a":[1,2)", 1, 24,
       "unexpected end of input"},
      {"a control character in a string", "{\"a\nb\":1}", 1, 4, "control character"},
      {"another type", R"({"type":"Sphere","objects":{}})", 1, 9, "none of GeoJSON's"},
      {"a type in lower case", R"({"type":"point","coordinates":[1,2]})", 1, 9,
       "none of GeoJSON's"},
      {"a type that is a number", R"({"type":3})", 1, 9, "expected a string in \"type\""},
      {"a type that is an object", R"({"type":{}})", 1, 9, "expected a string"},
      {"two types", R"({"type":"Point","type":"Point"})", 1, 17, "given twice"},
      {"coordinates that are missing", R"({"type":"Point"})", 1, 1, "needs \"coordinates\""},
      {"coordinates that are null", R"({"type":"Point","coordinates":null})", 1, 31,
       "expected an array"},
      {"coordinates that are an object", R"({"type":"Point","coordinates":{}})", 1, 31,
       "expected an array"},
      {"a string for a coordinate", R"({"type":"Point","coordinates":["1",2]})", 1, 32,
       "a number or an array"},
      {"null for a coordinate", R"({"type":"Point","coordinates":[null,2]})", 1, 32,
       "a number or an array"},
      {"an object for a coordinate", R"({"type":"Point","coordinates":[{},2]})", 1, 32,
       "a number or an array"},
      {"one coordinate", R"({"type":"Point","coordinates":[1]})", 1, 33, "needs two numbers"},
      {"an empty position", R"({"type":"LineString","coordinates":[[1,2],[],[3,4]]})", 1, 44,
       "needs two numbers"},
      {"an empty position at the start", R"({"type":"LineString","coordinates":[[],[1,2],[3,4]]})",
       1, 38, "needs two numbers"},
      {"a list in a position", R"({"type":"Point","coordinates":[1,[2]]})", 1, 34, "unevenly"},
      {"a number among positions", R"({"type":"MultiPoint","coordinates":[[1,2],3]})", 1, 43,
       "unevenly"},
      {"a number after an empty list", R"({"type":"MultiPoint","coordinates":[[],3,4]})", 1, 40,
       "unevenly"},
      {"too deep", R"({"type":"Point","coordinates":[[1,2]]})", 1, 31, "in 0 lists"},
      {"too shallow", R"({"coordinates":[[0,0],[1,0],[0,1],[0,0]],"type":"Polygon"})", 1, 16,
       "in 2 lists"},
      {"too deep and empty", R"({"type":"Point","coordinates":[[]]})", 1, 31, "in 0 lists"},
      {"nested 10^6 deep", polygon(repeated("[", 1'000'000)), 1, 1'000'033, "not JSON"},
      {"a line of one position", R"({"type":"LineString","coordinates":[[1,2]]})", 1, 42,
       "at least 2"},
      {"a ring of three positions", polygon("[[[0,0],[1,0],[0,0]]]"), 1, 52, "at least 4"},
      {"an open ring of two positions", polygon("[[[0,0],[9,0],[0,9]],\n[[1,1],[2,1]]]"), 2, 13,
       "at least 4"},
      {"a position of a Feature", R"({"type":"Feature","coordinates":[1,2],"geometry":null})", 1, 1,
       "has no \"coordinates\""},
      {"a collection without geometries", R"({"type":"GeometryCollection"})", 1, 1,
       "needs \"geometries\""},
      {"a geometry that is an array", R"({"type":"Feature","geometry":[]})", 1, 30,
       "an object or null"},
      {"a geometry that is a Feature",
       R"({"type":"Feature","geometry":{"type":"Feature",)"
       R"("geometry":null}})",
       1, 30, "expected a geometry"},
      {"features that are geometries",
       R"({"type":"FeatureCollection","features":[{"type":"Point","coordinates":[1,2]}]})", 1, 41,
       "expected a Feature"},
      {"a feature that is null", R"({"type":"FeatureCollection","features":[null]})", 1, 41,
       "expected an object"},
      {"geometries that are an object", R"({"type":"GeometryCollection","geometries":{}})", 1, 43,
       "expected an array"},
      {"a FeatureCollection in a GeometryCollection",
       R"({"type":"GeometryCollection","geometries":[{"type":"FeatureCollection","features":[]}]})",
       1, 44, "expected a geometry"},
      {"nan", R"({"type":"Point","coordinates":[NaN,2]})", 1, 32, "not JSON: invalid literal"},
      {"-Infinity", R"({"type":"Point","coordinates":[1,-Infinity]})", 1, 34, "'-Infinity'"},
      {"nan for a type", R"({"type":NaN})", 1, 9, "'NaN'"},
      {"true for a geometry", R"({"type":"Feature","geometry":true})", 1, 30, "an object or null"},
      {"a plus", R"({"type":"Point","coordinates":[+1,2]})", 1, 32, "not JSON"},
      {"a fraction", R"({"type":"Point","coordinates":[1/3,2]})", 1, 33, "not JSON"},
      {"1e400", R"({"type":"Point","coordinates":[1e400,2]})", 1, 32, "largest double"},
      {"a zero byte", R"({"type":"Point","coordinates":[1,2]})" + std::string("\n\0}", 3), 2, 1,
       "byte 0x00"},
      {"1e999999999", R"({"type":"Point","coordinates":[1e999999999,2]})", 1, 32, "largest double"},
      {"10^6 digits", R"({"type":"Point","coordinates":[)" + million + ",2]}", 1, 32,
       "1000000 characters"},
      {"5000 digits after the point",
       R"({"type":"Point","coordinates":[0.)" + std::string(5000, '7') + ",2]}", 1, 32,
       "5002 characters"},
      {"collections nested too deep",
       repeated(R"({"type":"GeometryCollection","geometries":[)", 70), 1, 65 * 43 + 1,
       "more than 64"},
  };
}

/// The quadrant x >= 0, y >= 0; cases below break one thing each.
inline const std::string kQuadrant =
    "plumb-nef2 1\n3 0 1 2 0\n0 0\n1 0\n0 1\n1 1\n1 0 1 2 1 1 0\n1 0 1 3 1 0 1\n";

inline std::string replaced(std::string text, const std::string& from, const std::string& to) {
  return text.replace(text.find(from), from.size(), to);
}

inline std::vector<HostileText> hostile_nef2() {
  const auto with = [](const std::string& from, const std::string& to) {
    return replaced(kQuadrant, from, to);
  };
  // Two lines that cross at (1/2, 1/2): crossing 1 is point 5.
  const std::string crossing = "plumb-nef2 1\n4 1 1 0 0\n0 0\n1 1\n0 1\n1 0\n1 2 3 4\n5 1\n";
  return {
      {"empty", "", 1, 1, "plumb-nef2 1"},
      {"a map", "3 2\n0 0\n", 1, 1, "plumb-nef2 1"},
      {"a comment first", "# x\n" + kQuadrant, 2, 1, "first line"},
      {"another version", with("nef2 1", "nef2 2"), 1, 13, "version '2'"},
      {"no version", with("nef2 1", "nef2"), 1, 11, "version ''"},
      {"more in the first line", with("nef2 1", "nef2 1 x"), 1, 14, "'x'"},
      {"nothing else", "plumb-nef2 1\n", 2, 1, "numbers of points"},
      {"a word for a count", with("3 0 1 2 0", "three 0 1 2 0"), 2, 1, "'three'"},
      {"a count is missing", with("3 0 1 2 0", "3 0 1 2"), 2, 8, "the mark of the bottom face"},
      {"more counts", with("3 0 1 2 0", "3 0 1 2 0 0"), 2, 11, "four numbers and a mark"},
      {"a mark of 2", with("3 0 1 2 0", "3 0 1 2 2"), 2, 9, "0 or 1, found '2'"},
      {"2^31 points", with("3 0 1 2 0", "2147483648 0 1 2 0"), 2, 1, "too short"},
      {"2^32 - 2 crossings", with("3 0 1 2 0", "3 4294967294 1 2 0"), 2, 1, "too short"},
      {"2^32 edges", with("3 0 1 2 0", "3 0 1 4294967296 0"), 2, 7, "at most"},
      {"one coordinate", with("1 0\n", "1\n"), 4, 2, "point 2 needs two numbers"},
      {"three coordinates", with("1 0\n", "1 0 0\n"), 4, 5, "after the two numbers of point 2"},
      {"nan", with("1 0\n", "nan 0\n"), 4, 1, "'nan'"},
      {"1/0", with("1 0\n", "1/0 0\n"), 4, 3, "denominator is 0"},
      {"truncated in the points", "plumb-nef2 1\n3 0 0 0 0\n0 0\n1 0       \n", 5, 1,
       "point 3 of 3"},
      {"a vertex at no point", with("1 1\n", "4 1\n"), 6, 1, "vertex 1 names point '4'"},
      {"a vertex at point 0", with("1 1\n", "0 1\n"), 6, 1, "ids run from 1 to 3"},
      {"a vertex without mark", with("1 1\n", "1\n"), 6, 2, "the mark of the vertex"},
      {"a vertex with two marks", with("1 1\n", "1 1 1\n"), 6, 5, "of vertex 1"},
      {"an edge from nowhere", with("1 0 1 2", "2 0 1 2"), 7, 1, "edge 1 names vertex '2'"},
      {"a negative end", with("1 0 1 2", "1 -1 1 2"), 7, 3, "ids run from 0 to 1"},
      {"an edge without marks", with("1 0 1 2 1 1 0", "1 0 1 2      "), 7, 14,
       "the mark of the edge"},
      {"a line through one point", with("1 0 1 2", "1 0 2 2"), 7, 4, "two equal points"},
      {"a line of a crossing", with("1 0 1 2", "1 0 1 4"), 7, 7, "ids run from 1 to 3"},
      {"an edge with four marks", with("1 1 0\n", "1 1 0 0\n"), 7, 15, "of edge 1"},
      {"more records", kQuadrant + "1 0 1 2 1 1 0\n", 9, 1, "after the last record; line 2"},
      {"parallel lines cross", replaced(crossing, "1 2 3 4", "1 2 2 1"), 7, 1, "parallel"},
      {"a crossing of a crossing", replaced(crossing, "1 2 3 4", "1 2 3 5"), 7, 7,
       "crossing 1 names point '5'"},
      {"three points cross", replaced(crossing, "1 2 3 4", "1 2 3"), 7, 6, "the number of a point"},
      {"five points cross", replaced(crossing, "1 2 3 4", "1 2 3 4 1"), 7, 9, "four points"},
  };
}

/// Records that are well-formed and no complex of a set, or not its minimal one.
inline std::vector<std::pair<const char*, std::string>> contradictory_nef2() {
  const auto with = [](const std::string& from, const std::string& to) {
    return replaced(kQuadrant, from, to);
  };
  const std::string head = "plumb-nef2 1\n";
  return {
      {"an edge that is not needed", with("1 0 1 2 1 1 0", "1 0 1 2 1 1 1")},
      {"marks of one face that disagree", with("1 0 1 3 1 0 1", "1 0 1 3 1 0 0")},
      {"the bottom face is another", with("3 0 1 2 0", "3 0 1 2 1")},
      {"edges out of order",
       replaced(with("1 0 1 2 1 1 0\n", ""), "1 0 1 3 1 0 1\n", "1 0 1 3 1 0 1\n1 0 1 2 1 1 0\n")},
      {"a line that runs the other way", with("1 0 1 2", "1 0 2 1")},
      {"a vertex that is not on its edge", with("1 1\n", "2 1\n")},
      {"a vertex that is not needed", head + "1 0 1 0 1\n0 0\n1 1\n"},
      {"vertices out of order", head + "2 0 2 0 0\n1 0\n0 0\n1 1\n2 1\n"},
      {"the same vertex twice", head + "2 0 2 0 0\n0 0\n0 0\n1 1\n2 1\n"},
      {"an edge of length 0", head + "2 0 1 1 0\n0 0\n1 0\n1 1\n1 1 1 2 1 0 0\n"},
      {"edges that cross", head +
                               "4 0 4 2 0\n0 0\n0 1\n1 0\n1 1\n1 1\n2 1\n3 1\n4 1\n1 4 1 4 1 0 0\n"
                               "2 3 2 3 1 0 0\n"},
      {"edges that overlap",
       head + "3 0 3 2 0\n0 0\n1 0\n2 0\n1 1\n2 1\n3 1\n1 2 1 2 1 0 0\n1 3 1 3 1 0 0\n"},
      {"a boundary that does not close", head + "2 0 2 1 0\n0 0\n1 0\n1 1\n2 1\n1 2 1 2 1 1 0\n"},
  };
}

}  // namespace plumb::testing
