#include "plumb/io/plane_io.h"

#include <gtest/gtest.h>

#include <cfenv>
#include <sstream>
#include <string>
#include <vector>

#include "expect_refusals.h"
#include "hostile_shapes.h"
#include "oracle/shape_oracle.h"
#include "plane_sets.h"
#include "plumb/io/plane/nef2_format.h"
#include "plumb/io/plane/wkt.h"

namespace plumb::plane_io_test {
namespace {

using testing::Dice;

constexpr std::uint64_t kSeeds = 300;

Nef2 read(const std::string& text, bool exact_decimals = false) {
  Context context;
  return read_plane_set(text, guess_plane_format(text), {"some.file", exact_decimals}, context).set;
}

PlaneText prepared(const Nef2& set, PlaneFormat format) {
  Context context;
  return PlaneText(set, format, context);
}

std::string written(const Nef2& set, PlaneFormat format) {
  std::ostringstream out;
  Context context;
  prepared(set, format).write(out, context);
  return out.str();
}

void expect_sound(const Nef2& set) {
  const auto flaw = set.audit();
  EXPECT_FALSE(flaw) << flaw->invariant << " at " << flaw->place;
}

// ---------------------------------------------------------------- what shapes mean

TEST(PlaneShapes, mean_the_union_of_closed_regions) {
  const std::vector<std::pair<std::string, std::string>> equal{
      {"POLYGON ((0 0, 2 0, 2 2, 0 2, 0 0))", "POLYGON ((0 0, 0 2, 2 2, 2 0, 0 0))"},
      {"POLYGON ((0 0, 2 0, 2 2, 0 2, 0 0)) POLYGON ((1 0, 3 0, 3 2, 1 2, 1 0))",
       "POLYGON ((0 0, 3 0, 3 2, 0 2, 0 0))"},
      {"MULTIPOLYGON (((0 0, 1 0, 1 1, 0 1, 0 0)), ((1 1, 1 0, 2 0, 2 1, 1 1)))",
       "POLYGON ((0 0, 2 0, 2 1, 0 1, 0 0))"},
      // a hole is a hole whatever its direction, and filled by another polygon
      {"POLYGON ((0 0, 9 0, 9 9, 0 9, 0 0), (3 3, 6 3, 6 6, 3 6, 3 3)) POINT (20 20)",
       "POLYGON ((0 0, 9 0, 9 9, 0 9, 0 0), (3 3, 3 6, 6 6, 6 3, 3 3)) POINT (20 20)"},
      {"POLYGON ((0 0, 9 0, 9 9, 0 9, 0 0), (3 3, 6 3, 6 6, 3 6, 3 3)) "
       "POLYGON ((3 3, 6 3, 6 6, 3 6, 3 3))",
       "POLYGON ((0 0, 9 0, 9 9, 0 9, 0 0))"},
      // an island in the hole of the same polygon
      {"POLYGON ((0 0, 9 0, 9 9, 0 9, 0 0), (1 1, 8 1, 8 8, 1 8, 1 1), (3 3, 6 3, 6 6, 3 6, 3 3))",
       "POLYGON ((0 0, 9 0, 9 9, 0 9, 0 0), (1 1, 8 1, 8 8, 1 8, 1 1)) "
       "POLYGON ((3 3, 6 3, 6 6, 3 6, 3 3))"},
      // a bow-tie is two triangles, with and without a corner where it crosses itself
      {"POLYGON ((0 0, 2 2, 2 0, 0 2, 0 0))",
       "POLYGON ((0 0, 1 1, 0 2, 0 0)) POLYGON ((2 2, 2 0, 1 1, 2 2))"},
      {"POLYGON ((0 0, 1 1, 2 2, 2 0, 1 1, 0 2, 0 0)) POINT (9 9)",
       "POLYGON ((0 0, 1 1, 0 2, 0 0)) POLYGON ((2 2, 2 0, 1 1, 2 2)) POINT (9 9)"},
      {"POLYGON ((0 0, 1 1, 2 2, 2 0, 1 1, 0 2, 0 0)) POLYGON ((2 0, 3 0, 3 2, 2 2, 2 0))",
       "POLYGON ((0 0, 1 1, 0 2, 0 0)) POLYGON ((1 1, 2 0, 3 0, 3 2, 2 2, 1 1))"},
      // twice around is outside by the even-odd rule
      {"POLYGON ((0 0, 1 0, 0 1, 0 0, 1 0, 0 1, 0 0))", "POLYGON EMPTY"},
      {"POLYGON ((0 0, 1 0, 0 1, 0 0, 1 0, 0 1, 0 0)) POLYGON ((5 5, 6 5, 5 6, 5 5))",
       "POLYGON ((5 5, 6 5, 5 6, 5 5))"},
      // a spike, a ring on a line, a ring at a point
      {"POLYGON ((0 0, 1 0, 1 5, 1 0, 2 0, 2 2, 0 2, 0 0))",
       "POLYGON ((0 0, 2 0, 2 2, 0 2, 0 0)) LINESTRING (1 2, 1 5)"},
      {"POLYGON ((0 0, 2 2, 1 1, 0 0)) POLYGON ((5 5, 6 5, 5 6, 5 5))",
       "LINESTRING (0 0, 2 2) POLYGON ((5 5, 6 5, 5 6, 5 5))"},
      {"POLYGON ((3 3, 3 3, 3 3, 3 3)) POLYGON ((5 5, 6 5, 5 6, 5 5))",
       "POINT (3 3) POLYGON ((5 5, 6 5, 5 6, 5 5))"},
      // repeated corners, rings that touch at corners
      {"POLYGON ((0 0, 0 0, 2 0, 2 0, 2 2, 0 0)) POINT (9 9)",
       "POLYGON ((0 0, 2 0, 2 2, 0 0)) POINT (9 9)"},
      {"POLYGON ((0 0, 4 0, 4 4, 0 4, 0 0), (0 0, 1 2, 2 1, 0 0)) POINT (9 9)",
       "POLYGON ((0 0, 4 0, 4 4, 0 4, 0 0, 1 2, 2 1, 0 0)) POINT (9 9)"},
      // lines and points within or beside
      {"LINESTRING (0 0, 2 0) LINESTRING (1 0, 3 0) POINT (2 0)", "LINESTRING (0 0, 3 0)"},
      {"LINESTRING (0 0, 2 2) LINESTRING (0 2, 2 0) POINT (1 1)",
       "MULTILINESTRING ((0 0, 1 1), (1 1, 2 2), (0 2, 1 1, 2 0))"},
      {"POLYGON ((0 0, 2 0, 2 2, 0 2, 0 0)) POINT (1 1) LINESTRING (1 1, 5 1)",
       "POLYGON ((0 0, 2 0, 2 2, 0 2, 0 0)) LINESTRING (2 1, 5 1)"},
      {"LINESTRING (1 1, 1 1)", "POINT (1 1)"},
      {"GEOMETRYCOLLECTION EMPTY", "POLYGON EMPTY"},
  };
  for (const auto& [a, b] : equal) {
    EXPECT_EQ(read(a), read(b)) << a;
    expect_sound(read(a));
  }
  EXPECT_TRUE(read("GEOMETRYCOLLECTION EMPTY").is_empty());
  EXPECT_EQ(read("POLYGON ((0 0, 2 2, 2 0, 0 2, 0 0))").area(), Rational(2));
}

TEST(PlaneShapes, hold_the_points_that_their_twin_holds) {
  for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
    Dice dice(seed);
    const std::string text = testing::any_wkt(dice);
    Context context;
    const PlaneShapes shapes = read_wkt(text, {}, context).shapes;
    const testing::ShapeTwin twin(shapes);
    const Nef2 set = to_set(shapes, context);
    for (const testing::ExactPoint& p : testing::telling_points(shapes, 60)) {
      const testing::ShapePlace place = twin.place(p);
      if (place == testing::ShapePlace::OnRing) continue;
      const RationalPoint2 q{testing::to_rational(p.x), testing::to_rational(p.y)};
      EXPECT_EQ(set.contains(q), place == testing::ShapePlace::Inside)
          << "seed " << seed << " at " << q.x << ' ' << q.y << '\n'
          << text;
    }
  }
}

TEST(PlaneShapes, hold_points_beyond_the_largest_double) {
  const Rational far("1" + std::string(320, '0'));
  const Nef2 line = read("LINESTRING (0 0, " + far.str() + " 2)");
  EXPECT_TRUE(line.contains(RationalPoint2{far, 2}));
  EXPECT_TRUE(line.contains(RationalPoint2{far / 2, 1}));
  EXPECT_FALSE(line.contains(RationalPoint2{far * 2, 4}));
  EXPECT_FALSE(line.contains(RationalPoint2{far, 1}));
}

/// Many polygons in one file are what they are one by one.
TEST(PlaneShapes, do_not_depend_on_what_else_is_in_the_file) {
  for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
    Dice dice(seed);
    const std::string text = testing::any_wkt(dice);
    Nef2 one_by_one;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) one_by_one += read(line);
    EXPECT_EQ(read(text), one_by_one) << "seed " << seed << '\n' << text;
    expect_sound(one_by_one);
    EXPECT_TRUE(one_by_one.is_closed());
  }
}

// ---------------------------------------------------------------- rounds

TEST(PlaneText, keeps_closed_bounded_sets_of_doubles) {
  for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
    Dice dice(seed);
    const std::string text = testing::any_wkt(dice);
    const Nef2 set = read(text);
    for (const PlaneFormat format : {PlaneFormat::Wkt, PlaneFormat::GeoJson}) {
      const PlaneText ready = prepared(set, format);
      EXPECT_FALSE(ready.losses().unbounded || ready.losses().open) << text;
      std::ostringstream out;
      Context context;
      ready.write(out, context);
      const Nef2 copy = read(out.str());
      expect_sound(copy);
      // Crossings are rounded: what comes back is a set of doubles, and then nothing changes.
      EXPECT_EQ(copy, round_to_doubles(set).set) << text << out.str();
      EXPECT_EQ(written(copy, format), out.str()) << text;
      EXPECT_FALSE(prepared(copy, format).losses().any()) << text;
      EXPECT_TRUE(ready.losses().is_reshaped() || copy.counts() == set.counts()) << text;
    }
  }
}

TEST(PlaneText, keeps_every_set_in_nef2) {
  for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
    Dice dice(seed);
    Nef2 set = read(testing::any_wkt(dice));
    for (int i = 0; i < 4; ++i) {
      const bool with_unbounded = dice.below(2) == 0;
      set = testing::changed(
          set, with_unbounded ? testing::any_unbounded(dice) : read(testing::any_wkt(dice)), dice);
    }
    SCOPED_TRACE(seed);
    const PlaneText ready = prepared(set, PlaneFormat::Nef2);
    EXPECT_FALSE(ready.losses().any());
    const std::string text = written(set, PlaneFormat::Nef2);
    const Nef2 copy = read(text);
    EXPECT_EQ(copy, set) << text;
    EXPECT_EQ(written(copy, PlaneFormat::Nef2), text);
    expect_sound(copy);
  }
}

TEST(PlaneText, writes_the_closure_and_says_so) {
  const Nef2 square = read("POLYGON ((0 0, 4 0, 4 4, 0 4, 0 0)) LINESTRING (0 0, 9 9)");
  for (const PlaneFormat format : {PlaneFormat::Wkt, PlaneFormat::GeoJson}) {
    const PlaneText open = prepared(square.interior(), format);
    EXPECT_TRUE(open.losses().open);
    EXPECT_FALSE(open.losses().unbounded || open.losses().is_reshaped());
    EXPECT_EQ(read(written(square.interior(), format)), square.regularization());
    EXPECT_FALSE(prepared(square, format).losses().any());
  }
}

TEST(PlaneText, leaves_out_what_is_unbounded_and_says_so) {
  const Nef2 square = read("POLYGON ((0 0, 4 0, 4 4, 0 4, 0 0))");
  const Nef2 outside = square.complement() + read("POLYGON ((1 1, 2 1, 2 2, 1 1))");
  const PlaneText text = prepared(outside, PlaneFormat::Wkt);
  EXPECT_TRUE(text.losses().unbounded);
  EXPECT_FALSE(text.losses().sentences().empty());
  const Nef2 kept = read(written(outside, PlaneFormat::Wkt));
  EXPECT_TRUE(kept.is_subset_of(outside.closure()));
  EXPECT_TRUE(kept.contains(Point2{1.5, 1.25}));
  EXPECT_FALSE(kept.contains(Point2{100, 100}));
  EXPECT_EQ(written(Nef2::whole(), PlaneFormat::Wkt), "GEOMETRYCOLLECTION EMPTY\n");
}

TEST(PlaneText, says_when_rounding_changes_the_shape) {
  // A triangle around (1/3, 1/3), so small that its corners round to one double.
  const std::string tiny =
      "POLYGON ((1/3 1/3, 33333333333333333333334/100000000000000000000000 1/3, "
      "1/3 33333333333333333333334/100000000000000000000000, 1/3 1/3))";
  const PlaneText text = prepared(read(tiny), PlaneFormat::Wkt);
  EXPECT_TRUE(text.losses().is_reshaped());
  EXPECT_EQ(text.losses().rounding.collapsed, 1U);
  EXPECT_EQ(text.losses().rounding.vertices_merged, 2U);
  ASSERT_EQ(text.losses().sentences().size(), 1U);
  EXPECT_TRUE(text.losses().sentences()[0].starts_with(
      "rounding to doubles changed the shape: 1 face was left out and 2 vertices were merged"))
      << text.losses().sentences()[0];
  EXPECT_EQ(written(read(tiny), PlaneFormat::Wkt), "GEOMETRYCOLLECTION EMPTY\n");
  // One of ordinary size is rounded without harm.
  EXPECT_FALSE(prepared(read("POLYGON ((1/3 1/3, 5 1/3, 1/3 7, 1/3 1/3))"), PlaneFormat::Wkt)
                   .losses()
                   .any());
}

/// Pairs whose results were written with rings that cross themselves, without a word.
TEST(PlaneText, writes_valid_shapes_for_pairs_that_round_badly) {
  const std::vector<std::pair<std::string, std::string>> pairs{
      {"POLYGON ((1 0, 3 2, 1.0000000000000002 3, 1.0000000000000002 4, 1 0))",
       "POLYGON ((0 1, 2 1, 2 2.5, 0 2.5, 0 1))"},
      {"POLYGON ((0 0, 1 0.1, 3 0.3, 0.7 0.7, 0 0))", "POLYGON ((0.1 0, 0.3 0.1, 2 0.1, 0.1 0))"},
  };
  for (const auto& [a, b] : pairs) {
    for (const Nef2& set : {read(a) + read(b), read(a) * read(b), read(a) - read(b)}) {
      for (const PlaneFormat format : {PlaneFormat::Wkt, PlaneFormat::GeoJson}) {
        const std::string text = written(set, format);
        EXPECT_EQ(read(text), round_to_doubles(set).set) << text;
        EXPECT_EQ(written(read(text), format), text);
      }
    }
  }
}

TEST(PlaneText, writes_nearest_doubles_without_repair_if_asked) {
  const std::string tiny =
      "POLYGON ((1/3 1/3, 33333333333333333333334/100000000000000000000000 1/3, "
      "1/3 33333333333333333333334/100000000000000000000000, 1/3 1/3))";
  Context context;
  const PlaneText raw(read(tiny), PlaneFormat::Wkt, {.rounding = OutputRounding::Nearest}, context);
  std::ostringstream out;
  raw.write(out, context);
  EXPECT_EQ(out.str(),
            "POLYGON ((0.3333333333333333 0.3333333333333333, 0.3333333333333333 "
            "0.3333333333333333, 0.3333333333333333 0.3333333333333333, 0.3333333333333333 "
            "0.3333333333333333))\n");
  ASSERT_EQ(raw.losses().sentences().size(), 1U);
  EXPECT_TRUE(raw.losses().sentences()[0].starts_with("the nearest doubles are not a valid shape"));
}

TEST(PlaneText, rounds_to_a_grid_if_asked) {
  Context context;
  const Nef2 star = read("POLYGON ((0 10, 6 -8, -10 3, 10 3, -6 -8, 0 10))");
  const PlaneText text(star, PlaneFormat::Wkt, {.grid = Rational(1) / 2}, context);
  std::ostringstream out;
  text.write(out, context);
  const Nef2 copy = read(out.str());
  EXPECT_EQ(copy, round_to_grid(star, Rational(1) / 2).set);
  for (const std::uint32_t p : copy.complex().vertex_point) {
    const RationalPoint2 at = exact(copy.complex().points, p);
    EXPECT_TRUE((at.x * 2).is_whole() && (at.y * 2).is_whole());
  }
}

TEST(PlaneText, refuses_coordinates_beyond_the_largest_double) {
  const std::string text = "POINT (" + std::string(400, '9') + " 0)";
  EXPECT_THROW(prepared(read(text), PlaneFormat::Wkt), Error);
  EXPECT_THROW(prepared(read(text), PlaneFormat::GeoJson), Error);
  EXPECT_EQ(read(written(read(text), PlaneFormat::Nef2)), read(text));
}

// ---------------------------------------------------------------- .nef2

TEST(Nef2Reader, reads_the_quadrant_of_the_documentation) {
  const Nef2 right = Nef2::half_plane({{0, 0}, {0, 1}}, {1, 0}, Boundary::Closed);
  const Nef2 upper = Nef2::half_plane({{0, 0}, {1, 0}}, {0, 1}, Boundary::Closed);
  EXPECT_EQ(read(testing::kQuadrant), right * upper);
  Context context;
  EXPECT_EQ(read_plane_set_file("corpus/plane/quadrant.nef2", {}, {}, context).set, right * upper);
}

TEST(Nef2Reader, refuses_hostile_texts_with_their_place) {
  testing::expect_refusals(testing::hostile_nef2(), [](const std::string& text) {
    Context context;
    read_nef2(text, {"some.file"}, context);
  });
}

TEST(Nef2Reader, refuses_records_that_are_no_set) {
  for (const auto& [name, text] : testing::contradictory_nef2()) {
    Context context;
    EXPECT_NO_THROW(read_nef2_records(text, {"some.file"}, context)) << name;
    try {
      read_nef2(text, {"some.file"}, context);
      ADD_FAILURE() << name << " was read";
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ErrorCode::BadShape) << name;
      EXPECT_EQ(error.place().file, "some.file");
      const std::string& message = error.message();
      const bool names_record = message.starts_with("vertex ") || message.starts_with("edge ");
      EXPECT_EQ(error.place().line > 0, names_record) << message;
    }
  }
}

TEST(Nef2Reader, names_the_line_of_a_record_at_fault) {
  // The second edge leaves the x-axis for the line y = x.
  const std::string text =
      "plumb-nef2 1\n\n3 0 1 2 0\n0 0\n1 0\n1 1\n# the corner\n1 1\n1 0 1 2 1 1 0\n\n"
      "1 0 1 3 1 1 1\n";
  Context context;
  try {
    read_nef2(text, {"some.file"}, context);
    ADD_FAILURE() << "read";
  } catch (const Error& error) {
    EXPECT_EQ(std::string(error.what()).substr(0, 16), "some.file:11:1: ") << error.what();
  }
}

TEST(Nef2Reader, keeps_every_number) {
  const std::string text =
      "MULTIPOINT (0.1 5e-324, 1/3 -22/7, 1.7976931348623157e308 -1e-300, "
      "123456789012345678901234567890 9007199254740993, 36028797018963968 -36028797018963967)";
  const std::string nef2 = written(read(text), PlaneFormat::Nef2);
  EXPECT_EQ(read(nef2), read(text));
  EXPECT_EQ(nef2.find_first_of(".eE", nef2.find('\n')), std::string::npos) << nef2;
}

TEST(Nef2Writer, writes_the_same_in_every_rounding_mode) {
  const Nef2 star = read("POLYGON ((0 10, 6 -8, -10 3, 10 3, -6 -8, 0 10))");
  const std::string text = written(star, PlaneFormat::Nef2);
  for (const int mode : {FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO}) {
    std::fesetround(mode);
    const std::string again = written(read(text), PlaneFormat::Nef2);
    std::fesetround(FE_TONEAREST);
    EXPECT_EQ(again, text);
  }
}

TEST(PlaneFormat, is_told_by_the_extension_or_the_text) {
  EXPECT_EQ(plane_format_of("a/b.wkt"), PlaneFormat::Wkt);
  EXPECT_EQ(plane_format_of("b.geojson"), PlaneFormat::GeoJson);
  EXPECT_EQ(plane_format_of("b.json"), PlaneFormat::GeoJson);
  EXPECT_EQ(plane_format_of("b.c.nef2"), PlaneFormat::Nef2);
  EXPECT_EQ(plane_format_of("b.wkb"), PlaneFormat::Wkb);
  EXPECT_EQ(plane_format_of("wkt"), std::nullopt);
  EXPECT_EQ(plane_format_of("-"), std::nullopt);
  EXPECT_EQ(guess_plane_format(" \n{}"), PlaneFormat::GeoJson);
  EXPECT_EQ(guess_plane_format("\x1e{}\n"), PlaneFormat::GeoJson);
  EXPECT_EQ(guess_plane_format("\xEF\xBB\xBFplumb-nef2 1"), PlaneFormat::Nef2);
  EXPECT_EQ(guess_plane_format("# x\nPOINT EMPTY"), PlaneFormat::Wkt);
  EXPECT_EQ(guess_plane_format(""), PlaneFormat::Wkt);
  EXPECT_EQ(guess_plane_format("010700000000000000\n"), PlaneFormat::Wkb);
  EXPECT_EQ(guess_plane_format(std::string("\0\0\0\0\7\0\0\0\0", 9)), PlaneFormat::Wkb);
  EXPECT_EQ(plane_format_of("a.json", "POINT EMPTY"), PlaneFormat::GeoJson);
  EXPECT_EQ(plane_format_of("a.txt", "{}"), PlaneFormat::GeoJson);
}

TEST(ReadPlaneSet, says_that_a_file_with_content_is_the_empty_set) {
  const auto notes_of = [](const std::string& text) {
    Context context;
    return read_plane_set(text, guess_plane_format(text), {}, context).notes;
  };
  const std::vector<std::string> nothing{
      "the file has no point, line or polygon, so the set is empty"};
  EXPECT_EQ(notes_of("POLYGON EMPTY"), nothing);
  EXPECT_EQ(notes_of(R"({"type":"FeatureCollection","features":[]})"), nothing);
  EXPECT_EQ(notes_of(R"({"type":"Feature","geometry":null})"), nothing);
  EXPECT_EQ(notes_of("POLYGON ((0 0, 1 0, 0 1, 0 0, 1 0, 0 1, 0 0))"),
            std::vector<std::string>{
                "the rings of the polygon overlap; the even-odd rule decided what they enclose"});
  // What is more than an empty geometry is told by a warning.
  const auto warnings_of = [](const std::string& text) {
    Context context;
    return read_plane_set(text, guess_plane_format(text), {}, context).warnings;
  };
  EXPECT_TRUE(warnings_of("POLYGON EMPTY").empty());
  EXPECT_EQ(warnings_of("POLYGON ((0 0, 1 0, 0 1, 0 0, 1 0, 0 1, 0 0))"),
            std::vector<std::string>{
                "the rings of the file enclose nothing by the rule \"odd\", so the set is empty"});
  EXPECT_EQ(warnings_of(R"({"type":"Feature","geometry":null,"place":{"type":"Point"}})"), nothing);
  EXPECT_EQ(warnings_of("<svg><text>A</text></svg>"), nothing);
  EXPECT_TRUE(notes_of("POINT (1 2)").empty());
  EXPECT_TRUE(notes_of("plumb-nef2 1\n0 0 0 0 0\n").empty());
}

TEST(ReadPlaneSet, counts_geometries_of_geojson_that_are_null) {
  constexpr std::string_view kText =
      R"({"type":"FeatureCollection","features":[{"type":"Feature","geometry":null},)"
      R"({"type":"Feature","id":7},{"type":"Feature","geometry":{"type":"GeometryCollection",)"
      R"("geometries":[null,{"type":"Point","coordinates":[1,2]}]}}]})";
  Context context;
  const PlaneRead read = read_plane_set(kText, PlaneFormat::GeoJson, {}, context);
  EXPECT_EQ(read.set, Nef2::point({1, 2}));
  EXPECT_EQ(read.notes,
            (std::vector<std::string>{"passed over: 'id', geometries that are null (3)"}));
}

/// Returns the area and the number of notes of a text under each rule: odd, nonzero, positive,
/// negative.
std::vector<Rational> areas_by_rule(const std::string& text) {
  std::vector<Rational> areas;
  for (const RingRule rule :
       {RingRule::Odd, RingRule::NonZero, RingRule::Positive, RingRule::Negative}) {
    ReadOptions options;
    options.rings = rule;
    areas.push_back(read_plane_set(text, PlaneFormat::Wkt, options).set.area().value());
  }
  return areas;
}

TEST(ReadPlaneSet, encloses_by_the_rule_that_is_asked_for) {
  using Areas = std::vector<Rational>;
  const std::string twice = "POLYGON((0 0,4 0,4 4,0 4,0 0,4 0,4 4,0 4,0 0))";
  const std::string holes =
      "POLYGON((0 0,10 0,10 10,0 10,0 0),(2 2,6 2,6 6,2 6,2 2),"
      "(4 4,8 4,8 8,4 8,4 4))";
  const std::string outside = "POLYGON((0 0,10 0,10 10,0 10,0 0),(8 2,12 2,12 6,8 6,8 2))";
  EXPECT_EQ(areas_by_rule(twice), (Areas{0, 16, 16, 0}));
  EXPECT_EQ(areas_by_rule(holes), (Areas{76, 76, 72, 4}));
  EXPECT_EQ(areas_by_rule(outside), (Areas{100, 100, 92, 8}));
  // Rings of one direction that overlap, and a clockwise one.
  EXPECT_EQ(areas_by_rule("MULTIPOLYGON(((0 0,4 0,4 4,0 4,0 0)),((2 2,2 6,6 6,6 2,2 2)))"),
            (Areas{28, 24, 12, 12}));
  // Lines and points belong to the set whatever the rule.
  ReadOptions negative;
  negative.rings = RingRule::Negative;
  EXPECT_EQ(read_plane_set("GEOMETRYCOLLECTION(POINT(9 9),LINESTRING(0 0,1 1))", PlaneFormat::Wkt,
                           negative)
                .set.counts()
                .vertices,
            3U);
}

TEST(ReadPlaneSet, says_that_the_rule_matters) {
  const auto notes = [](const std::string& text) {
    return read_plane_set(text, PlaneFormat::Wkt).notes.size();
  };
  EXPECT_EQ(notes("POLYGON((0 0,10 0,10 10,0 10,0 0),(2 2,6 2,6 6,2 6,2 2),(4 4,8 4,8 8,4 8,4 4))"),
            1U);
  EXPECT_EQ(notes("POLYGON((0 0,10 0,10 10,0 10,0 0),(8 2,12 2,12 6,8 6,8 2))"), 1U);
  // A bow-tie encloses nothing twice; a hole may run either way and touch the outer ring.
  EXPECT_EQ(notes("POLYGON((0 0,2 2,2 0,0 2,0 0))"), 0U);
  EXPECT_EQ(notes("POLYGON((0 0,9 0,9 9,0 9,0 0),(0 0,2 1,1 2,0 0))"), 0U);
  EXPECT_EQ(notes("MULTIPOLYGON(((0 0,4 0,4 4,0 4,0 0)),((2 2,2 6,6 6,6 2,2 2)))"), 0U);
}

TEST(PlaneText, refuses_to_write_what_can_only_be_read) {
  EXPECT_THROW(prepared(Nef2::empty(), PlaneFormat::Svg), Error);
  EXPECT_EQ(read("01030000000100000004000000"
                 "0000000000000000000000000000000000000000000010400000000000000000"
                 "0000000000001040000000000000084000000000000000000000000000000000"),
            read("POLYGON ((0 0, 4 0, 4 3, 0 0))"));
}

TEST(ReadPlaneSetFile, gives_back_the_memory_of_the_text) {
  Limits limits;
  limits.max_memory_bytes = 1 << 20;
  Context context(limits);
  for (int i = 0; i < 3; ++i) {
    EXPECT_FALSE(read_plane_set_file("corpus/plane/star.wkt", {}, {}, context).set.is_empty());
  }
  EXPECT_THROW(read_plane_set_file("no/such.wkt", {}, {}, context), Error);
}

}  // namespace
}  // namespace plumb::plane_io_test
