// Pictures of layers: well-formed, with every region named once, whatever the coordinates.

#include "plumb/picture/layer_svg.h"

#include <gtest/gtest.h>

#include <sstream>
#include <string>

#include "plumb/io/layer_io.h"
#include "svg_checks.h"

namespace plumb::testing::layer_svg_test {
namespace {

Layer fields() { return read_layer_file("corpus/layers/fields.geojson").layer; }

std::string svg_of(const Layer& layer, const LayerReport& report) {
  std::ostringstream out;
  write_layer_svg(out, layer, report, {.title = "a <b> & c"});
  return out.str();
}

std::string html_of(const Layer& layer, const LayerReport& report, std::size_t close_ups = 200) {
  std::ostringstream out;
  write_layer_html(out, layer, report, {.title = "a <b> & c", .max_close_ups = close_ups});
  return out.str();
}

std::size_t count_of(const std::string& text, const std::string& part) {
  std::size_t count = 0;
  for (std::size_t at = text.find(part); at != text.npos; at = text.find(part, at + 1)) ++count;
  return count;
}

TEST(LayerSvg, is_sound_and_lists_every_region) {
  const Layer layer = fields();
  const LayerReport report = check_layer(layer);
  const std::string svg = svg_of(layer, report);
  expect_sound(svg);
  EXPECT_EQ(count_of(svg, "class=\"feature\""), layer.feature_count());
  for (const char* const part : {"1. overlap of feature 1", "2. overlap of feature 2",
                                 "3. hole between", "a &lt;b&gt; &amp; c", ">defects<"}) {
    EXPECT_NE(svg.find(part), svg.npos) << part;
  }
  const Layer repaired = repair_layer(layer).layer;
  EXPECT_NE(svg_of(repaired, check_layer(repaired)).find(">coverage<"), std::string::npos);
}

TEST(LayerHtml, has_a_close_up_of_every_region) {
  const Layer layer = fields();
  const LayerReport report = check_layer(layer);
  const std::string page = html_of(layer, report);
  ASSERT_EQ(report.regions.size(), 3U);
  for (std::size_t i = 1; i <= report.regions.size(); ++i) {
    EXPECT_EQ(count_of(page, "<details id=\"r" + std::to_string(i) + "\">"), 1U);
  }
  EXPECT_EQ(count_of(page, "<svg"), 1 + report.regions.size());
  EXPECT_EQ(count_of(page, "href=\"#r"), 2U) << "a link for each defect";
  EXPECT_EQ(page.find("nan"), page.npos);
  // Words of the page are no part of its picture, which a narrow screen makes small.
  for (const char* const word : {"<h1>a &lt;b&gt; &amp; c</h1>", ">defects</span> 4 features",
                                 "<b>overlap</b> several features cover it"}) {
    EXPECT_EQ(count_of(page, word), 1U) << word;
    EXPECT_TRUE(page.find(word) < page.find("<svg") || page.find(word) > page.find("</svg>"));
  }
  EXPECT_EQ(count_of(html_of(layer, report, 1), "<details"), 1U);
  EXPECT_NE(html_of(layer, report, 1).find("2 regions not listed"), std::string::npos);
}

TEST(LayerSvg, is_sound_for_empty_and_for_extreme_layers) {
  expect_sound(svg_of(Layer(), check_layer(Layer())));
  for (const double size : {1e-300, 1e-12, 1e150, 1e300}) {
    Layer layer;
    for (const Point2 p : {Point2{0, 0}, Point2{size, 0}, Point2{0, size}})
      layer.points.push_back(p);
    layer.ring_corners = {0, 1, 2};
    layer.end_ring();
    layer.end_polygon();
    layer.end_feature("\"<id>\"", R"({"name":"<&>"})");
    layer.ring_corners.insert(layer.ring_corners.end(), {0, 1, 2});
    layer.end_ring();
    layer.end_polygon();
    layer.end_feature("", "");
    const LayerReport report = check_layer(layer);
    EXPECT_EQ(report.count(LayerRegionKind::Overlap), 1U);
    expect_sound(svg_of(layer, report));
    EXPECT_EQ(html_of(layer, report).find("nan"), std::string::npos) << size;
  }
}

}  // namespace
}  // namespace plumb::testing::layer_svg_test
