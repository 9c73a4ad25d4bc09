// The parts that pictures are made of.
#include "plumb/picture/plane/plane_view.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <random>

#include "plumb/picture/map/map_marks.h"
#include "plumb/picture/svg/sheet.h"
#include "plumb/picture/svg/svg_text.h"
#include "svg_checks.h"

namespace plumb::plane_view_test {
namespace {

TEST(SvgText, EscapesWhatXmlForbids) {
  EXPECT_EQ(xml_escaped("a<b>&\"'"), "a&lt;b&gt;&amp;&quot;&#39;");
  EXPECT_EQ(xml_escaped("\xC3\xA9\xE2\x82\xAC\xF0\x9F\x8C\x8D"),
            "\xC3\xA9\xE2\x82\xAC\xF0\x9F\x8C\x8D");
  const std::string r = "\xEF\xBF\xBD";
  for (const char* bad : {"\x01", "\x7F", "\xFF", "\xC0", "\x80"})
    EXPECT_EQ(xml_escaped(bad), r) << bad;
  EXPECT_EQ(xml_escaped("\xC0\x80"), r + r);          // overlong
  EXPECT_EQ(xml_escaped("\xED\xA0\x80"), r + r + r);  // surrogate
  EXPECT_EQ(xml_escaped("\xEF\xBF\xBF"), r + r + r);  // no character of XML
  EXPECT_EQ(xml_escaped("\xE2\x82"), r + r);          // cut off
}

TEST(SvgText, NumbersAreShortAndFinite) {
  EXPECT_EQ(svg_number(1.0 / 3), "0.33");
  EXPECT_EQ(svg_number(-0.001), "0");
  EXPECT_EQ(svg_number(250), "250");
  EXPECT_EQ(svg_number(std::nan("")), "0");
  EXPECT_EQ(svg_number(-INFINITY), "-1e+05");
}

TEST(SvgText, WrappingKeepsTheWordsAndTheWidth) {
  const std::string text = "one two three four five six seven eight nine ten";
  std::string joined;
  for (const std::string& line : wrapped(text, 10, 80, 99)) {
    EXPECT_LE(text_width(line, 10), 80);
    joined += (joined.empty() ? "" : " ") + line;
  }
  EXPECT_EQ(joined, text);
  const auto cut = wrapped(text, 10, 80, 2);
  EXPECT_EQ(cut.size(), 2U);
  EXPECT_NE(cut[1].find("\xE2\x80\xA6"), std::string::npos);
  for (const std::string& line : wrapped(std::string(500, 'w'), 10, 80, 3))
    EXPECT_LE(text_width(line, 10), 84);
}

TEST(PathData, ErrorsDoNotAddUp) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> any(0, 900);
  std::vector<Point2> wanted;
  PathData path;
  for (int ring = 0; ring < 20; ++ring) {
    for (int i = 0; i < 50; ++i) {
      wanted.push_back({any(random), any(random)});
      if (i == 0)
        path.move_to(wanted.back());
      else
        path.line_to(wanted.back());
    }
    path.close();
  }
  std::vector<Point2> seen;
  for (const auto& ring : testing::read_path(path.data())) {
    seen.insert(seen.end(), ring.begin(), ring.end());
  }
  ASSERT_EQ(seen.size(), wanted.size());
  for (std::size_t i = 0; i < seen.size(); ++i) {
    EXPECT_NEAR(seen[i].x, wanted[i].x, 0.051);
    EXPECT_NEAR(seen[i].y, wanted[i].y, 0.051);
  }
}

double area(const std::vector<Point2>& ring) {
  double sum = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point2 p = ring[i], q = ring[(i + 1) % ring.size()];
    sum += p.x * q.y - p.y * q.x;
  }
  return sum / 2;
}

TEST(View, ClippedAreasOfAPartitionAddUp) {
  // A triangle fan around a point: clipping must neither lose nor invent area.
  const View view({0, 0, 100, 100}, {-.3, -.3, .3, .3});
  double sum = 0;
  const Point2 c = {.1, -.2};
  for (int i = 0; i < 12; ++i) {
    const double a = i * M_PI / 6, b = (i + 1) * M_PI / 6;
    const auto part = view.clipped({c,
                                    {c.x + 2 * std::cos(a), c.y + 2 * std::sin(a)},
                                    {c.x + 2 * std::cos(b), c.y + 2 * std::sin(b)}});
    for (const Point2& p : part) EXPECT_TRUE(view.window().grown(1e-12).contains(p));
    sum += area(part);
  }
  EXPECT_NEAR(sum, view.window().width() * view.window().height(), 1e-12);
}

TEST(View, ClipsSegmentsToTheWindow) {
  const View view({0, 0, 100, 100}, {-.3, -.3, .3, .3});
  EXPECT_FALSE(view.clipped({-1, .9}, {1, .9}));
  EXPECT_FALSE(view.clipped({-1, .2}, {-.2, 1.2}));  // past the corner
  const auto seen = view.clipped({-1, -1}, {1, 1});
  ASSERT_TRUE(seen);
  EXPECT_NEAR(seen->first.x, view.window().left, 1e-12);
  EXPECT_NEAR(seen->second.y, view.window().bottom, 1e-12);
}

TEST(View, UpIsUp) {
  const View view({0, 0, 100, 100}, {-1, -1, 1, 1});
  EXPECT_LT(view.place({0, 1}).y, view.place({0, -1}).y);
  EXPECT_LT(view.place({-1, 0}).x, view.place({1, 0}).x);
}

TEST(LabelPlacer, LabelsNeverOverlapNorLeaveTheFrame) {
  const Rectangle frame = {0, 0, 300, 200};
  LabelPlacer room(frame);
  std::mt19937 random(5);
  std::uniform_real_distribution<double> x(0, 300), y(0, 200);
  std::vector<Rectangle> placed;
  for (int i = 0; i < 200; ++i) {
    if (const auto r = room.place({x(random), y(random)}, 40, 20, 12)) placed.push_back(*r);
  }
  EXPECT_GT(placed.size(), 20U);
  EXPECT_LT(placed.size(), 76U);  // more than the frame can hold
  for (std::size_t i = 0; i < placed.size(); ++i) {
    EXPECT_TRUE(frame.contains(placed[i]));
    for (std::size_t k = 0; k < i; ++k) EXPECT_FALSE(placed[i].overlaps(placed[k]));
  }
}

TEST(Tints, NeighboursDiffer) {
  // A fan: every face meets the centre, only consecutive ones are neighbours. And a ring of faces.
  Map fan;
  for (int i = 0; i <= 500; ++i) fan.points.push_back({1.0 * i, 0});
  for (std::uint32_t i = 1; i <= 500; ++i)
    fan.add_cycle(std::vector<std::uint32_t>{0, i, i % 500 + 1});
  const auto colours = colour_cycles(fan);
  for (std::size_t i = 0; i < 500; ++i) EXPECT_NE(colours[i], colours[(i + 1) % 500]) << i;
}

TEST(Marks, GroupLabels) {
  const std::map<std::vector<std::size_t>, std::string> cases = {
      {{0}, "1"},
      {{2, 3}, "3, 4"},
      {{2, 3, 4},
       "3\xE2\x80\x93"
       "5"},
      {{0, 8}, "1, 9"},
      {{0, 1, 2, 8},
       "1\xE2\x80\x93"
       "3, 9"},
      {{0, 2, 4, 6, 8}, "1, 3, 5, \xE2\x80\xA6"},
  };
  for (const auto& [members, text] : cases) EXPECT_EQ(group_label(members, 6), text);
}

}  // namespace
}  // namespace plumb::plane_view_test
