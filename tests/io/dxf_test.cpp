// DXF and SVG as sets of the plane. Areas of curves are compared with formulas, within what the
// tolerance allows; straight drawings are compared exactly with sets of the same corners; written
// files are read again.
#include "plumb/io/plane/dxf.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include "plane_sets.h"
#include "plumb/io/plane_io.h"
#include "plumb/plane/plane_measure.h"
#include "plumb/predicates/error.h"
#include "plumb/predicates/rounding.h"

namespace plumb::dxf_test {
namespace {

/// A pair: a code and a value.
std::string pair(int code, const std::string& value) {
  return " " + std::to_string(code) + "\n" + value + "\n";
}

std::string drawing(const std::string& entities, const std::string& header = "") {
  return pair(0, "SECTION") + pair(2, "HEADER") + header + pair(0, "ENDSEC") + pair(0, "SECTION") +
         pair(2, "ENTITIES") + entities + pair(0, "ENDSEC") + pair(0, "EOF");
}

/// An entity whose values are listed as "code value code value ...".
std::string entity(const std::string& name, const std::string& values) {
  std::string text = pair(0, name);
  std::istringstream words(values);
  std::string code, value;
  while (words >> code >> value) text += pair(std::stoi(code), value);
  return text;
}

std::string line(const std::string& a, const std::string& b, const std::string& c,
                 const std::string& d) {
  return entity("LINE", "10 " + a + " 20 " + b + " 11 " + c + " 21 " + d);
}

PlaneRead read(const std::string& text, PlaneFormat format = PlaneFormat::Dxf,
               std::optional<double> tolerance = {}, RingRule rule = RingRule::Odd) {
  Context context;
  ReadOptions options{"some.file"};
  options.curve_tolerance = tolerance;
  options.rings = rule;
  return read_plane_set(text, format, options, context);
}

Nef2 wkt(const std::string& text) { return read(text, PlaneFormat::Wkt).set; }

double area_of(const Nef2& set) { return nearest_double(marked_area(set.complex()).value()); }

bool has_note(const PlaneRead& read, const std::string& part) {
  return std::any_of(read.notes.begin(), read.notes.end(),
                     [&](const std::string& note) { return note.find(part) != note.npos; });
}

const std::string kSquare =
    entity("LWPOLYLINE", "90 4 70 1 10 0 20 0 10 4 20 0 10 4 20 4 10 0 20 4");

TEST(DxfReader, reads_straight_drawings_exactly) {
  const Nef2 square = wkt("POLYGON ((0 0, 4 0, 4 4, 0 4, 0 0))");
  EXPECT_EQ(read(drawing(kSquare)).set, square);
  const std::string old = pair(0, "POLYLINE") + pair(70, "1") + entity("VERTEX", "10 0 20 0") +
                          entity("VERTEX", "10 4 20 0") + entity("VERTEX", "10 4 20 4") +
                          entity("VERTEX", "10 0 20 4") + pair(0, "SEQEND");
  EXPECT_EQ(read(drawing(old)).set, square);
  // Lines in any order and direction.
  const std::string lines = line("4", "4", "4", "0") + line("0", "0", "4", "0") +
                            line("0", "4", "4", "4") + line("0", "4", "0.0", "-0.0");
  EXPECT_EQ(read(drawing(lines)).set, square);
  std::string crlf;
  for (const char c : drawing(lines)) crlf += c == '\n' ? "\r\n" : std::string(1, c);
  EXPECT_EQ(read(crlf).set, square);
}

TEST(DxfReader, a_ring_in_a_ring_is_a_hole) {
  const std::string inner =
      entity("LWPOLYLINE", "90 4 70 1 10 1 20 1 10 2 20 1 10 2 20 2 10 1 20 2");
  const Nef2 frame = wkt("POLYGON ((0 0, 4 0, 4 4, 0 4, 0 0), (1 1, 2 1, 2 2, 1 2, 1 1))");
  EXPECT_EQ(read(drawing(kSquare + inner)).set, frame);
  EXPECT_EQ(read(drawing(inner + kSquare)).set, frame);
  const Nef2 filled = wkt("POLYGON ((0 0, 4 0, 4 4, 0 4, 0 0))");
  EXPECT_EQ(read(drawing(inner + kSquare), PlaneFormat::Dxf, {}, RingRule::NonZero).set, filled);
}

TEST(DxfReader, chains_that_touch_at_a_point_are_rings) {
  const std::string two = line("0", "0", "1", "0") + line("1", "0", "1", "1") +
                          line("1", "1", "0", "0") + line("1", "1", "2", "1") +
                          line("2", "1", "2", "2") + line("2", "2", "1", "1");
  EXPECT_EQ(read(drawing(two)).set,
            wkt("MULTIPOLYGON (((0 0, 1 0, 1 1, 0 0)), ((1 1, 2 1, 2 2, 1 1)))"));
}

/// Chords lie inside a convex curve of length `length`, at most `tolerance` away from it.
void expect_area(const Nef2& set, double area, double length, double tolerance) {
  EXPECT_LE(area_of(set), area * (1 + 1e-12));
  EXPECT_GE(area_of(set), area - length * tolerance);
}

TEST(DxfReader, keeps_curves_within_the_tolerance) {
  constexpr double kPi = std::numbers::pi;
  const std::string circle = drawing(entity("CIRCLE", "10 5 20 -7 40 3"));
  const std::string ellipse = drawing(entity("ELLIPSE", "10 1 20 2 11 0 21 4 40 0.5"));
  const std::string half_disc = drawing(entity("LWPOLYLINE", "90 2 70 1 10 0 20 0 10 4 20 0 42 1"));
  // One control point at the middle: the parabola encloses two thirds of the triangle.
  const std::string parabola =
      drawing(entity("SPLINE", "71 2 40 0 40 0 40 0 40 1 40 1 40 1 10 0 20 0 10 2 20 4 10 4 20 0") +
              line("0", "0", "4", "0"));
  std::size_t last = 0;
  for (const double tolerance : {0.1, 1e-3, 1e-5}) {
    const auto at = [&](const std::string& text) {
      return read(text, PlaneFormat::Dxf, tolerance).set;
    };
    expect_area(at(circle), 9 * kPi, 6 * kPi, tolerance);
    expect_area(at(ellipse), 8 * kPi, 20, tolerance);
    expect_area(at(half_disc), 2 * kPi, 2 * kPi, tolerance);
    expect_area(at(parabola), 16.0 / 3, 10, tolerance);
    const std::size_t vertices = at(circle).counts().vertices;
    EXPECT_GT(vertices, last);
    last = vertices;
  }
  EXPECT_EQ(read(circle).set, read(circle, PlaneFormat::Dxf, 6e-3).set);  // A thousandth.
}

TEST(DxfReader, a_cubic_spline_with_inner_knots_is_its_bezier_curves) {
  // The spline has the Bezier points (0,0) (0,2) (1,3) (2,3) and (2,3) (3,3) (4,2) (4,0).
  const std::string spline = drawing(entity("SPLINE",
                                            "71 3 40 0 40 0 40 0 40 0 40 1 40 2 40 2 40 2 40 2 "
                                            "10 0 20 0 10 0 20 2 10 2 20 4 10 4 20 2 10 4 20 0") +
                                     line("4", "0", "0", "0"));
  const std::string path =
      "<svg viewBox=\"0 0 4 4\"><path d=\"M0 4C0 2 1 1 2 1C3 1 4 2 4 4Z\"/></svg>";
  const Nef2 a = read(spline, PlaneFormat::Dxf, 1e-4).set;
  const Nef2 b = read(path, PlaneFormat::Svg, 1e-4).set;
  EXPECT_EQ(a.counts().vertices, b.counts().vertices);
  EXPECT_NEAR(area_of(a), area_of(b), 1e-12);
}

/// Nine control points, every second of which has the weight of a right angle: a circle of radius
/// 3, as programs write it that know only splines.
TEST(DxfReader, a_rational_spline_can_be_a_circle) {
  constexpr double kPi = std::numbers::pi;
  std::string groups = "70 1 71 2 40 0 40 0 40 0 40 1 40 1 40 2 40 2 40 3 40 3 40 4 40 4 40 4";
  constexpr std::array<std::array<int, 2>, 9> kControl{
      {{3, 0}, {3, 3}, {0, 3}, {-3, 3}, {-3, 0}, {-3, -3}, {0, -3}, {3, -3}, {3, 0}}};
  for (std::size_t k = 0; k < kControl.size(); ++k) {
    groups += k % 2 == 0 ? " 41 1" : " 41 0.70710678118654757";
  }
  for (const auto& [x, y] : kControl) {
    groups += " 10 " + std::to_string(x) + " 20 " + std::to_string(y);
  }
  for (const double tolerance : {0.1, 1e-3, 1e-5}) {
    const Nef2 set = read(drawing(entity("SPLINE", groups)), PlaneFormat::Dxf, tolerance).set;
    expect_area(set, 9 * kPi, 6 * kPi, tolerance);
  }
}

TEST(DxfReader, a_spline_of_degree_five_is_the_curve_of_lower_degree_that_it_is_raised_from) {
  // The parabola of (0, 0), (2, 4), (4, 0), with its degree raised to five.
  const std::string raised = drawing(
      entity("SPLINE",
             "71 5 40 0 40 0 40 0 40 0 40 0 40 0 40 1 40 1 40 1 40 1 40 1 40 1 10 0 20 0 10 0.8 "
             "20 1.6 10 1.6 20 2.4 10 2.4 20 2.4 10 3.2 20 1.6 10 4 20 0") +
      line("0", "0", "4", "0"));
  for (const double tolerance : {0.1, 1e-3, 1e-5}) {
    expect_area(read(raised, PlaneFormat::Dxf, tolerance).set, 16.0 / 3, 10, tolerance);
  }
}

/// Without control points: through fit points. Sixteen points of a circle determine it to some
/// thousandths; two points determine a line.
TEST(DxfReader, a_spline_without_control_points_goes_through_its_fit_points) {
  constexpr double kPi = std::numbers::pi;
  constexpr int kPoints = 16;
  std::string groups = "70 1 71 3";
  for (int k = 0; k < kPoints; ++k) {
    const double angle = 2 * kPi * k / kPoints;
    groups += " 11 " + std::to_string(std::cos(angle)) + " 21 " + std::to_string(std::sin(angle));
  }
  const PlaneRead closed = read(drawing(entity("SPLINE", groups)), PlaneFormat::Dxf, 1e-5);
  EXPECT_NEAR(area_of(closed.set), kPi, 1e-3);
  EXPECT_TRUE(has_note(closed, "drawn through their fit points: 1"));

  const auto area_under = [](const std::string& spline) {
    const std::string text = drawing(entity("SPLINE", spline) + line("4", "0", "0", "0") +
                                     line("0", "0", "0", "1") + line("4", "0", "4", "1"));
    return area_of(read(text, PlaneFormat::Dxf, 1e-6).set);
  };
  EXPECT_NEAR(area_under("71 3 11 0 21 1 11 4 21 1"), 4, 1e-9);
  EXPECT_NEAR(area_under("71 3 11 0 21 1 11 1 21 1 11 1 21 1 11 3 21 1 11 4 21 1"), 4, 1e-9);
  // Directions of unit length: with r the root of a half, Hermite's cubic has y = 1 + 4 r (t - t^2)
  // and x' = 24 (t - t^2) + 4 r (1 - 6 (t - t^2)).
  EXPECT_NEAR(area_under("71 3 12 1 22 1 13 1 23 -1 11 0 21 1 11 4 21 1"),
              4 + 16 * std::numbers::sqrt2 / 10 - 8.0 / 30, 1e-5);
}

TEST(DxfReader, joins_ends_of_arcs_to_lines) {
  // The computed ends of the arc are off by rounding, and by what six digits of the angle leave.
  const std::string slot = line("0.3", "0.1", "0.3", "1.1") +
                           entity("ARC", "10 0.8 20 1.1 40 0.5 50 0 51 180.000003") +
                           line("1.3", "1.1", "1.3", "0.1") + line("1.3", "0.1", "0.3", "0.1");
  const PlaneRead result = read(drawing(slot), PlaneFormat::Dxf, 1e-4);
  EXPECT_EQ(result.set.counts().faces, 2U);
  expect_area(result.set, 1 + std::numbers::pi / 8, 2, 2e-4);
}

TEST(DxfReader, a_drawing_seen_from_below_is_mirrored) {
  const std::string below = entity("LWPOLYLINE", "90 3 70 1 230 -1 10 0 20 0 10 4 20 0 10 0 20 4");
  EXPECT_EQ(read(drawing(below)).set, wkt("POLYGON ((0 0, -4 0, 0 4, 0 0))"));
}

/// A block with the base point (1, 2) and the corners (1, 2), (3, 2), (1, 3).
const std::string kTriangle = entity("LWPOLYLINE", "90 3 70 1 10 1 20 2 10 3 20 2 10 1 20 3");

std::string block(const std::string& name, const std::string& entities) {
  return entity("BLOCK", "8 0 2 " + name + " 10 1 20 2") + entities + pair(0, "ENDBLK");
}

std::string with_blocks(const std::string& blocks, const std::string& entities) {
  return pair(0, "SECTION") + pair(2, "BLOCKS") + blocks + pair(0, "ENDSEC") + drawing(entities);
}

TEST(DxfReader, inserts_place_blocks) {
  const auto placed = [](const std::string& values) {
    return read(with_blocks(block("a", kTriangle), entity("INSERT", "2 a " + values))).set;
  };
  EXPECT_EQ(placed("10 0 20 0"), wkt("POLYGON ((0 0, 2 0, 0 1, 0 0))"));
  EXPECT_EQ(placed("10 5 20 7"), wkt("POLYGON ((5 7, 7 7, 5 8, 5 7))"));
  EXPECT_EQ(placed("10 0 20 0 41 3 42 -2"), wkt("POLYGON ((0 0, 6 0, 0 -2, 0 0))"));
  EXPECT_EQ(placed("10 5 20 0 41 3 50 90"), wkt("POLYGON ((5 0, 5 6, 4 0, 5 0))"));
  EXPECT_EQ(placed("10 5 20 0 230 -1"), wkt("POLYGON ((-5 0, -7 0, -5 1, -5 0))"));
  // The steps of the array turn with the block, and are not scaled.
  EXPECT_EQ(placed("10 0 20 0 41 2 50 90 70 2 71 2 44 10 45 20"),
            wkt("MULTIPOLYGON (((0 0, 0 4, -1 0, 0 0)), ((0 10, 0 14, -1 10, 0 10)), "
                "((-20 0, -20 4, -21 0, -20 0)), ((-20 10, -20 14, -21 10, -20 10)))"));
}

TEST(DxfReader, blocks_in_blocks_are_placed_by_both_inserts) {
  const std::string blocks =
      block("outer", entity("INSERT", "2 inner 10 2 20 2 41 2")) + block("inner", kTriangle);
  EXPECT_EQ(read(with_blocks(blocks, entity("INSERT", "2 outer 10 0 20 0 50 90"))).set,
            wkt("POLYGON ((0 1, 0 5, -1 1, 0 1))"));
}

TEST(DxfReader, lines_of_inserted_blocks_join) {
  const std::string two_sides = line("1", "2", "3", "2") + line("3", "2", "3", "4");
  const std::string half = entity("INSERT", "2 half 10 0.1 20 0.7 50 33");
  const std::string rest = line("1", "2", "3", "4");
  const PlaneRead result = read(with_blocks(block("half", two_sides) + block("rest", rest),
                                            half + entity("INSERT", "2 rest 10 0.1 20 0.7 50 33")));
  EXPECT_NEAR(area_of(result.set), 2, 1e-12);
}

TEST(DxfReader, a_block_can_stand_anywhere_in_the_text) {
  const std::string filler(9999, ' ');
  const std::string far = entity("LWPOLYLINE", "90 3 70 1 10 11 20 2 10 13 20 2 10 11 20 3");
  const std::string blocks = block("b", kTriangle) + pair(999, filler) + block("a", far);
  const Nef2 both = wkt("MULTIPOLYGON (((0 0, 2 0, 0 1, 0 0)), ((10 0, 12 0, 10 1, 10 0)))");
  const std::string a = entity("INSERT", "2 a 10 0 20 0"), b = entity("INSERT", "2 b 10 0 20 0");
  EXPECT_EQ(read(with_blocks(blocks, a + b)).set, both);
  EXPECT_EQ(read(with_blocks(blocks, b + a)).set, both);
  const PlaneRead with_square = read(with_blocks(blocks, a + pair(999, filler) + kSquare));
  EXPECT_EQ(area_of(with_square.set), 17);
}

TEST(DxfReader, layer_0_of_a_block_is_the_layer_of_the_insert) {
  const std::string on_red =
      entity("LWPOLYLINE", "8 red 90 3 70 1 10 11 20 2 10 13 20 2 10 11 20 3");
  const std::string text =
      with_blocks(block("a", kTriangle + on_red), entity("INSERT", "8 blue 2 a 10 0 20 0"));
  const auto layer = [&](const char* name) {
    Context context;
    return read_dxf_set(text, {.layer = name}, ReadOptions{"some.file"}, context).set;
  };
  EXPECT_EQ(layer("blue"), wkt("POLYGON ((0 0, 2 0, 0 1, 0 0))"));
  EXPECT_EQ(layer("red"), wkt("POLYGON ((10 0, 12 0, 10 1, 10 0))"));
  EXPECT_EQ(area_of(layer("0")), 0);
}

TEST(DxfReader, blocks_without_inserts_are_not_read) {
  const std::string wrong = block("a", entity("CIRCLE", "40 -1")) + block("b", kTriangle);
  EXPECT_EQ(read(with_blocks(wrong, kSquare)).set, read(drawing(kSquare)).set);
  const PlaneRead result = read(with_blocks("", kSquare + entity("INSERT", "2 a 10 0 20 0")));
  EXPECT_TRUE(has_note(result, "inserts of blocks that are missing (1)"));
}

TEST(DxfReader, refuses_blocks_in_themselves_and_too_many_inserts) {
  const auto code_of = [](const std::string& text) {
    try {
      read(text);
    } catch (const Error& error) {
      EXPECT_GT(error.place().line, 1U);
      return error.code();
    }
    ADD_FAILURE() << "was read";
    return ErrorCode::Syntax;
  };
  const std::string first = entity("INSERT", "2 b0 10 0 20 0");
  const std::string cycle = block("b0", entity("INSERT", "2 b1 10 0 20 0")) + block("b1", first);
  EXPECT_EQ(code_of(with_blocks(cycle, first)), ErrorCode::BadShape);
  for (const char* times : {"70 1", "70 2"}) {
    std::string nested;
    for (int i = 0; i < 99; ++i) {
      nested += block("b" + std::to_string(i),
                      entity("INSERT", "2 b" + std::to_string(i + 1) + " 10 0 20 0 " + times));
    }
    EXPECT_EQ(code_of(with_blocks(nested + block("b99", ""), first)), ErrorCode::ResourceLimit);
  }
  std::string bomb;  // Without a curve at the bottom, only the steps are bounded.
  for (int i = 0; i < 40; ++i) {
    bomb += block("b" + std::to_string(i),
                  entity("INSERT", "2 b" + std::to_string(i + 1) + " 10 0 20 0 70 2"));
  }
  EXPECT_EQ(code_of(with_blocks(bomb + block("b40", ""), first)), ErrorCode::ResourceLimit);
}

TEST(DxfReader, joins_ends_of_lines_that_only_rounding_separates) {
  const auto triangle = [](const std::string& end) {
    return drawing(line("0", "0", "4", "0") + line("4", "0", "4", "4") + line("4", "4", "0", end));
  };
  const PlaneRead result = read(triangle("2e-13"));
  EXPECT_EQ(result.set, wkt("POLYGON ((0 0, 4 0, 4 4, 0 0))"));
  EXPECT_TRUE(has_note(result, "apart by rounding only were joined (1)"));
  EXPECT_FALSE(has_note(read(triangle("0")), "rounding"));
  EXPECT_NO_THROW(read(triangle("3.6e-12")));  // The reach is 4 / 2^40, which is 3.64e-12.
  EXPECT_THROW(read(triangle("3.7e-12")), Error);
}

TEST(DxfReader, names_of_blocks_have_no_case) {
  EXPECT_EQ(read(with_blocks(block("Part", kTriangle), entity("INSERT", "2 pART 10 0 20 0"))).set,
            wkt("POLYGON ((0 0, 2 0, 0 1, 0 0))"));
}

/// A hatch with these borders, and with what follows the borders in files.
std::string hatch(int borders, const std::string& values, const std::string& style = "0") {
  return entity("HATCH", "10 0 20 0 30 0 210 0 220 0 230 1 70 1 71 0 91 " +
                             std::to_string(borders) + " " + values + " 75 " + style +
                             " 76 1 98 1 10 77 20 77");
}
const std::string kSquareBorder =
    "92 2 72 0 73 1 93 4 10 0 20 0 10 4 20 0 10 4 20 4 10 0 20 4 97 0";
const std::string kHoleBorder =
    "92 16 93 4 72 1 10 1 20 1 11 2 21 1 72 1 10 2 20 1 11 2 21 2 "
    "72 1 10 2 20 2 11 1 21 2 72 1 10 1 20 2 11 1 21 1 97 1";

/// Filled polygons unite, also where they overlap.
TEST(DxfReader, filled_polygons_are_areas) {
  const std::string square = "10 0 20 0 11 2 21 0 12 0 22 2 13 2 23 2";
  const auto area = [](const std::string& entities) {
    return area_of(read(drawing(entities), PlaneFormat::Dxf).set);
  };
  EXPECT_EQ(area(entity("SOLID", square)), 4);
  EXPECT_EQ(area(entity("TRACE", square) + entity("SOLID", square + " 210 0 220 0 230 -1")), 8);
  EXPECT_EQ(area(entity("SOLID", "10 0 20 0 11 2 21 0 12 0 22 2 13 0 23 2")), 2);
  EXPECT_EQ(area(entity("SOLID", "10 0 20 0 11 2 21 0 12 0 22 2")), 2);
  EXPECT_EQ(area(entity("3DFACE", "10 0 20 0 11 2 21 0 12 2 22 2 13 0 23 2 33 7")), 4);
  EXPECT_EQ(area(entity("SOLID", square) + entity("SOLID", square)), 4);
  EXPECT_EQ(area(entity("SOLID", "10 0 20 0 11 0 21 0 12 0 22 0 13 0 23 0")), 0);
}

TEST(DxfReader, splines_without_length_are_named) {
  const PlaneRead result = read(
      drawing(entity("SPLINE", "71 1 40 3 40 3 40 3 40 3 10 0 20 0 10 1 20 1")), PlaneFormat::Dxf);
  EXPECT_TRUE(result.set.is_empty());
  ASSERT_FALSE(result.notes.empty());
  EXPECT_NE(result.notes[0].find("splines without length, whose knots are all equal (1)"),
            std::string::npos)
      << result.notes[0];
}

TEST(DxfReader, hatches_are_areas_of_their_own) {
  const Nef2 square = wkt("POLYGON ((0 0, 4 0, 4 4, 0 4, 0 0))");
  EXPECT_EQ(read(drawing(hatch(1, kSquareBorder))).set, square);
  // The lines of the border may be there, too, and the hatch may be there twice.
  EXPECT_EQ(read(drawing(kSquare + hatch(1, kSquareBorder) + hatch(1, kSquareBorder))).set, square);
  const Nef2 frame = wkt("POLYGON ((0 0, 4 0, 4 4, 0 4, 0 0), (1 1, 2 1, 2 2, 1 2, 1 1))");
  const std::string both = kSquareBorder + " " + kHoleBorder;
  EXPECT_EQ(read(drawing(hatch(2, both))).set, frame);
  EXPECT_EQ(read(drawing(hatch(2, both, "2"))).set, square);  // Islands are ignored.
  // Two inserts of a hatch overlap.
  const std::string inserts = entity("INSERT", "2 a 10 1 20 2") + entity("INSERT", "2 a 10 3 20 2");
  EXPECT_EQ(read(with_blocks(block("a", hatch(1, kSquareBorder)), inserts)).set,
            wkt("POLYGON ((0 0, 6 0, 6 4, 0 4, 0 0))"));
}

TEST(DxfReader, borders_of_hatches_have_all_curves) {
  constexpr double kPi = std::numbers::pi;
  const auto area = [](const std::string& border) {
    return area_of(read(drawing(hatch(1, border)), PlaneFormat::Dxf, 1e-6).set);
  };
  constexpr double kNear = 1e-4;
  EXPECT_NEAR(area("92 2 72 1 73 1 93 2 10 0 20 0 42 1 10 4 20 0 42 1"), 4 * kPi, kNear);
  EXPECT_NEAR(area("92 0 93 1 72 2 10 1 20 1 40 2 50 0 51 360 73 1 97 0"), 4 * kPi, kNear);
  const std::string chord = "92 0 93 2 72 1 10 -2 20 0 11 2 21 0 ";
  EXPECT_NEAR(area(chord + "72 2 10 0 20 0 40 2 50 0 51 180 73 1 97 0"), 2 * kPi, kNear);
  // Clockwise angles are measured the other way: this is the same upper half.
  EXPECT_NEAR(area(chord + "72 2 10 0 20 0 40 2 50 180 51 360 73 0"), 2 * kPi, kNear);
  EXPECT_NEAR(area("92 0 93 3 72 1 10 0 20 0 11 2 21 0 72 2 10 0 20 0 40 2 50 0 51 90 73 1 "
                   "72 1 10 0 20 2 11 0 21 0"),
              kPi, kNear);
  EXPECT_NEAR(area(chord + "72 3 10 0 20 0 11 2 21 0 40 0.5 50 0 51 180 73 1"), kPi, kNear);
  // An eighth of a turn of a flat ellipse ends at its point on the line x = y.
  const std::string end = "0.894427190999916";
  EXPECT_NEAR(
      area("92 0 93 3 72 1 10 0 20 0 11 2 21 0 72 3 10 0 20 0 11 2 21 0 40 0.5 50 0 51 45 73 1 "
           "72 1 10 " +
           end + " 20 " + end + " 11 0 21 0"),
      std::atan2(2.0, 1.0), kNear);
  EXPECT_NEAR(
      area("92 0 93 2 72 1 10 0 20 0 11 4 21 0 72 4 94 2 73 0 74 0 95 6 96 3 40 0 40 0 40 0 "
           "40 1 40 1 40 1 10 4 20 0 10 2 20 4 10 0 20 0 97 0"),
      16.0 / 3, kNear);
}

TEST(DxfReader, names_what_it_does_not_read) {
  const PlaneRead result =
      read(drawing(kSquare + entity("TEXT", "10 0 20 0 40 2") + entity("TEXT", "10 0") +
                       entity("CIRCLE", "8 holes 10 2 20 2 40 1 30 7"),
                   pair(9, "$INSUNITS") + pair(70, "1")));
  EXPECT_TRUE(has_note(result, "TEXT (2)"));
  EXPECT_TRUE(has_note(result, "heights (Z)"));
  EXPECT_TRUE(has_note(result, "'0', 'holes'"));
  EXPECT_TRUE(has_note(result, "the inch"));
}

TEST(DxfReader, refuses_what_is_wrong_with_its_line) {
  struct Case {
    std::string text;
    std::size_t line;
    std::string message;
  };
  const std::string open =
      line("0", "0", "4", "0") + line("4", "0", "4", "4") + line("4", "4", "0", "0.001");
  const Case cases[] = {
      {"x\ny\n", 1, "code of a group, found 'x'"},
      {"AutoCAD Binary DXF\r\n", 1, "binary DXF"},
      {pair(0, "SECTION") + pair(2, "ENTITIES"), 4, "without EOF"},
      {pair(0, "SECTION") + " 2", 3, "value of the last group"},
      {drawing(entity("LINE", "10 0 20 0 11 a 21 0")), 18, "expected a number, found 'a'"},
      {drawing(entity("LINE", "10 0 20 0 11 1e999 21 0")), 18, "largest double"},
      {drawing(entity("LINE", "10 0 20 0 11 1")), 11, "LINE lacks a value with the code 21"},
      {drawing(open), 11, "(0, 0) meets no other end; the nearest one is 0.001 away"},
      {drawing(kSquare + line("9", "9", "8", "8")), 33, "meets no other end"},
      {drawing(entity("ARC", "10 0 20 0 40 -1 50 0 51 9")), 11, "negative radius"},
      {drawing(entity("CIRCLE", "10 0 20 0 40 1 210 1")), 11, "another plane"},
      {drawing(entity("SPLINE", "71 26 10 0 20 0")), 11, "another degree than 1 to 25"},
      {drawing(entity("SPLINE", "71 1 10 0 20 0 41 0")), 11, "a weight that is not above zero"},
      {drawing(entity("SPLINE", "71 1 10 0 20 0 41 1 41 1")), 11, "more weights than control"},
      {drawing(entity("SPLINE", "71 2 40 0 10 0 20 0")), 11, "1 control points and 1 knots"},
      {drawing(entity("SPLINE", "71 1 40 3 40 2 10 0 20 0")), 11, "knots that descend"},
      {drawing(entity("INSERT", "2 a 10 0 20 0 210 1")), 11, "INSERT lies in another plane"},
      {drawing(entity("HATCH", "91 1 92 2 93 3 10 0 20 0")), 11,
       "HATCH lacks a value with the code 10 in a border"},
      {drawing(entity("HATCH", "91 1e300 92 0 93 0")), 11, "lacks a value with the code 92"},
      {drawing(entity("HATCH", "91 1 92 0 93 1 72 5")), 11, "border of another kind"},
      {drawing(entity("HATCH", "91 1 92 0 93 1 72 1 10 0 20 0 11 4 21 0")), 11,
       "meets no other end"},
  };
  for (const Case& c : cases) {
    try {
      read(c.text);
      ADD_FAILURE() << "was read: " << c.message;
    } catch (const Error& error) {
      EXPECT_EQ(error.place().file, "some.file");
      EXPECT_EQ(error.place().line, c.line) << error.what();
      EXPECT_NE(error.message().find(c.message), std::string::npos) << error.what();
    }
  }
}

TEST(DxfReader, a_fine_tolerance_ends_at_a_limit) {
  try {
    read(drawing(entity("CIRCLE", "10 0 20 0 40 1e9")), PlaneFormat::Dxf, 1e-9);
    ADD_FAILURE() << "was read";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::ResourceLimit) << error.what();
  }
}

std::string written(const Nef2& set, PlaneLosses* losses = nullptr) {
  const PlaneText text(set, PlaneFormat::Dxf);
  if (losses != nullptr) *losses = text.losses();
  std::ostringstream out;
  text.write(out);
  return out.str();
}

TEST(DxfWriter, writes_what_is_read_again) {
  for (const char* text :
       {"POLYGON ((0 0, 9 0, 9 9, 0 9, 0 0), (1 1, 1 4, 4 4, 4 1, 1 1), (5 5, 5 6, 6 6, 5 5))",
        "MULTIPOLYGON (((0 0, 1 0, 1 1, 0 0)), ((1 1, 2 1, 2 2, 1 1)), ((0.1 7, 0.3 8, 0 8, 0.1 "
        "7)))",
        "POLYGON EMPTY"}) {
    const Nef2 set = wkt(text);
    PlaneLosses losses;
    EXPECT_EQ(read(written(set, &losses)).set, set) << text;
    EXPECT_FALSE(losses.any());
  }
}

TEST(DxfWriter, says_that_lines_and_points_are_left_out) {
  const Nef2 set = wkt("GEOMETRYCOLLECTION (POLYGON ((0 0, 1 0, 1 1, 0 0)), POINT (5 5))");
  PlaneLosses losses;
  EXPECT_EQ(read(written(set, &losses)).set, wkt("POLYGON ((0 0, 1 0, 1 1, 0 0))"));
  EXPECT_TRUE(losses.thin);
  EXPECT_TRUE(losses.any());
  EXPECT_EQ(losses.sentences().size(), 1U);
}

// ---------------------------------------------------------------- SVG as a set

TEST(SvgSet, each_shape_encloses_by_its_own_rule) {
  const auto star = [](const std::string& attributes) {
    return read("<svg viewBox=\"0 0 9 9\"><path " + attributes +
                    " d=\"M0 9H9V0H0Z M3 6H6V3H3Z\"/></svg>",
                PlaneFormat::Svg)
        .set;
  };
  const Nef2 full = wkt("POLYGON ((0 0, 9 0, 9 9, 0 9, 0 0))");
  const Nef2 frame = wkt("POLYGON ((0 0, 9 0, 9 9, 0 9, 0 0), (3 3, 6 3, 6 6, 3 6, 3 3))");
  EXPECT_EQ(star(""), full);
  EXPECT_EQ(star("fill-rule=\"evenodd\""), frame);
  EXPECT_EQ(star("style=\"fill:red; fill-rule: evenodd\""), frame);
  EXPECT_EQ(star("fill-rule=\"evenodd\" style=\"fill-rule:nonzero\""), full);
  const std::string group =
      "<svg viewBox=\"0 0 9 9\"><g fill-rule=\"evenodd\"><path d=\"M0 9H9V0H0Z M3 6H6V3H3Z\"/></g>"
      "<rect x=\"4\" y=\"4\" width=\"1\" height=\"1\"/></svg>";
  EXPECT_EQ(read(group, PlaneFormat::Svg).set,
            wkt("MULTIPOLYGON (((0 0, 9 0, 9 9, 0 9, 0 0), (3 3, 6 3, 6 6, 3 6, 3 3)), "
                "((4 4, 5 4, 5 5, 4 5, 4 4)))"));
}

TEST(SvgSet, stands_on_the_lower_left_corner_in_millimetres) {
  const auto square = [](const std::string& attributes) {
    return read("<svg " + attributes + "><rect width=\"4\" height=\"2\"/></svg>", PlaneFormat::Svg)
        .set;
  };
  EXPECT_EQ(square("viewBox=\"0 0 10 10\""), wkt("POLYGON ((0 8, 4 8, 4 10, 0 10, 0 8))"));
  EXPECT_EQ(square("viewBox=\"-1 -1 10 10\" width=\"10mm\""),
            wkt("POLYGON ((1 7, 5 7, 5 9, 1 9, 1 7))"));
  EXPECT_EQ(square("viewBox=\"0 0 10 10\" width=\"2cm\" height=\"2cm\""),
            wkt("POLYGON ((0 16, 8 16, 8 20, 0 20, 0 16))"));
}

TEST(PlaneFormats, drawings_are_known_by_name_and_text) {
  EXPECT_EQ(plane_format_of("a.dxf"), PlaneFormat::Dxf);
  EXPECT_EQ(plane_format_of("a.svg"), PlaneFormat::Svg);
  EXPECT_EQ(guess_plane_format(drawing("")), PlaneFormat::Dxf);
  EXPECT_EQ(guess_plane_format("999\ncomment\n  0\nSECTION\n"), PlaneFormat::Dxf);
  EXPECT_EQ(guess_plane_format("\n<svg/>"), PlaneFormat::Svg);
  EXPECT_EQ(guess_plane_format("<?xml version=\"1.0\"?><svg/>"), PlaneFormat::Svg);
  EXPECT_EQ(guess_plane_format("<http://a/CRS84> POINT (1 2)"), PlaneFormat::Wkt);
  EXPECT_THROW(PlaneText(Nef2(), PlaneFormat::Svg), Error);
  EXPECT_TRUE(has_note(read(drawing("")), "no point, line or polygon"));
}

}  // namespace
}  // namespace plumb::dxf_test
