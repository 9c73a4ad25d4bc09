// Outlines of text(): what does not depend on which fonts are installed. The numbers are compared
// with those of OpenSCAD in tests/system/openscad_test.py.
#include "plumb/io/csg/text_outlines.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "plumb/csg/evaluate.h"
#include "plumb/io/csg_reader.h"
#include "plumb/predicates/error.h"

namespace plumb::text_outlines_test {
namespace {

struct Box {
  double left = 1e300, right = -1e300, bottom = 1e300, top = -1e300;
};

Box box_of(const TextOutlines& outlines) {
  Box box;
  for (const GlyphOutline& glyph : outlines.glyphs) {
    for (const auto& [x, y] : glyph.points) {
      box = {std::min(box.left, x), std::max(box.right, x), std::min(box.bottom, y),
             std::max(box.top, y)};
    }
  }
  return box;
}

TextOutlines outlines_of(const TextRequest& request) {
  Context context;
  return text_outlines(request, context);
}

std::optional<ErrorCode> error_of(const TextRequest& request) {
  try {
    (void)outlines_of(request);
  } catch (const Error& error) {
    return error.code();
  }
  return {};
}

/// A build without FreeType, and a machine without any font, refuse all texts.
class TextShapes : public ::testing::Test {
 protected:
  void SetUp() override {
    if (error_of({.text = "a"}) == ErrorCode::UnknownFormat) GTEST_SKIP() << "no font";
  }
};

TEST_F(TextShapes, AreClosedPathsOfThreePointsOrMore) {
  const TextOutlines outlines = outlines_of({.text = "a B8%"});
  EXPECT_EQ(outlines.glyphs.size(), 4U);  // A blank has no outline.
  for (const GlyphOutline& glyph : outlines.glyphs) {
    std::size_t points = 0;
    for (const std::uint32_t size : glyph.path_sizes) {
      EXPECT_GE(size, 3U);
      points += size;
    }
    EXPECT_EQ(points, glyph.points.size());
  }
}

TEST_F(TextShapes, GrowWithTheSize) {
  const Box once = box_of(outlines_of({.text = "Hxg"}));
  const Box twice = box_of(outlines_of({.text = "Hxg", .size = 20}));
  EXPECT_NEAR(twice.right, 2 * once.right, 1e-9);
  EXPECT_NEAR(twice.top, 2 * once.top, 1e-9);
  EXPECT_NEAR(twice.bottom, 2 * once.bottom, 1e-9);
}

TEST_F(TextShapes, AreMovedByTheirAlignment) {
  const TextRequest request{.text = "Hxg"};
  const auto aligned = [&](const char* across, const char* along) {
    TextRequest other = request;
    other.halign = across;
    other.valign = along;
    return box_of(outlines_of(other));
  };
  const Box plain = box_of(outlines_of(request));
  const Box right = aligned("right", "baseline"), centre = aligned("center", "baseline");
  EXPECT_LT(right.right, plain.right);
  EXPECT_NEAR(centre.left, (plain.left + right.left) / 2, 1e-9);
  const Box top = aligned("left", "top"), bottom = aligned("left", "bottom");
  // Heights are rounded up to 1 / 1600 of the size.
  EXPECT_LE(top.top, plain.top / 20);
  EXPECT_GE(bottom.bottom, plain.bottom / 20);
  EXPECT_NEAR(aligned("left", "center").top, (top.top + bottom.top) / 2, 1e-9);
}

TEST_F(TextShapes, RunInFourDirections) {
  const auto points_of = [](const std::string& text, TextDirection direction) {
    std::vector<std::array<double, 2>> points;
    const TextOutlines outlines = outlines_of({.text = text, .direction = direction});
    for (const GlyphOutline& glyph : outlines.glyphs) {
      points.insert(points.end(), glyph.points.begin(), glyph.points.end());
    }
    return points;
  };
  EXPECT_EQ(points_of("pWl", TextDirection::Left), points_of("lWp", TextDirection::Right));
  EXPECT_EQ(points_of("pWl", TextDirection::Up), points_of("lWp", TextDirection::Down));
  // A combining mark stays behind its letter.
  EXPECT_EQ(points_of("a\u0301W", TextDirection::Left),
            points_of("Wa\u0301", TextDirection::Right));
  EXPECT_NE(points_of("pWl", TextDirection::Up), points_of("pWl", TextDirection::Down));
  // Downwards, each character lies below the one before, and all lie around x = 0.
  const TextOutlines down = outlines_of({.text = "HHH", .direction = TextDirection::Down});
  ASSERT_EQ(down.glyphs.size(), 3U);
  for (std::size_t i = 0; i < 3; ++i) {
    const Box box = box_of({{down.glyphs[i]}, {}, true});
    EXPECT_TRUE(box.left < 0 && box.right > 0 && box.top < 0);
    if (i > 0) {
      EXPECT_LT(box.top, box_of({{down.glyphs[i - 1]}, {}, true}).bottom);
    }
  }
  const auto aligned = [](const std::string& halign, const std::string& valign) {
    return box_of(outlines_of(
        {.text = "HHH", .direction = TextDirection::Down, .halign = halign, .valign = valign}));
  };
  EXPECT_NEAR(aligned("right", "top").right - aligned("left", "top").right,
              2 * (aligned("center", "top").right - aligned("left", "top").right), 1e-9);
  EXPECT_GT(aligned("left", "top").bottom, 0);
  EXPECT_NEAR(aligned("left", "top").top + aligned("left", "bottom").top,
              2 * aligned("left", "center").top, 1e-9);
}

TEST_F(TextShapes, ApproachCurvesWithMoreChords) {
  const auto points = [](std::uint32_t chords) {
    std::size_t count = 0;
    for (const GlyphOutline& g : outlines_of({.text = "o", .chords = chords}).glyphs) {
      count += g.points.size();
    }
    return count;
  };
  EXPECT_GT(points(2), 7U);
  EXPECT_GT(points(20), 5 * points(2));
}

TEST_F(TextShapes, RefuseWhatIsNoTextOrTooLong) {
  EXPECT_EQ(error_of({.text = "a\xff"}), ErrorCode::Syntax);
  EXPECT_EQ(error_of({.text = "\xe2\x82"}), ErrorCode::Syntax);
  EXPECT_EQ(error_of({.text = "\xed\xa0\x80"}), ErrorCode::Syntax);  // half of a surrogate pair
  EXPECT_EQ(error_of({.text = std::string(kMostTextBytes + 1, 'a')}), ErrorCode::ResourceLimit);
  EXPECT_TRUE(outlines_of({.text = ""}).glyphs.empty());
}

TEST_F(TextShapes, TakeNoFileFromTheNameOfAFont) {
  const TextOutlines plain = outlines_of({.text = "a"});
  EXPECT_EQ(outlines_of({.text = "a", .font = ":file=/etc/passwd"}).glyphs.size(),
            plain.glyphs.size());
  EXPECT_FALSE(outlines_of({.text = "a", .font = "/etc/passwd"}).is_named);
  EXPECT_TRUE(outlines_of({.text = "a", .font = plain.family}).is_named);
}

TEST_F(TextShapes, MakeAGroupOfPolygons) {
  const CsgRead read =
      read_csg("m.csg", "linear_extrude(1) { text(\"i o\"); square(0.5); } cube();");
  const Nef3 both = evaluate(read.tree).solid;
  EXPECT_GT(both.counts().facets, 20U);
  EXPECT_TRUE(both.contains(Point3{0.25, 0.25, 0.5}));
  const CsgRead empty = read_csg("m.csg", "text(\"a\", size = 0);");
  EXPECT_EQ(empty.tree.nodes.size(), 2U);
  EXPECT_EQ(empty.notes.size(), 1U);
}

TEST_F(TextShapes, NameWhatIsIgnored) {
  const auto notes_of = [](const std::string& parameters) {
    return read_csg("m.csg", "text(" + parameters + ");").notes.size();
  };
  const std::string font = ", font = \"" + outlines_of({.text = "a"}).family + "\"";
  EXPECT_EQ(notes_of("text = \"a\", halign = \"right\", valign = \"top\"" + font), 0U);
  EXPECT_EQ(notes_of("text = \"a\", halign = \"nowhere\"" + font), 1U);
  EXPECT_EQ(notes_of("text = \"a\", valign = \"left\"" + font), 1U);
  EXPECT_EQ(notes_of("text = \"a\", halign = 2" + font), 1U);
  EXPECT_EQ(notes_of("text = 12" + font), 1U);
}

}  // namespace
}  // namespace plumb::text_outlines_test
