// Properties of dissolved and overlaid layers.

#include "plumb/io/layer_properties.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "plumb/predicates/error.h"

namespace plumb::layer_properties_test {
namespace {

/// A layer of features without polygons.
Layer layer_of(const std::vector<std::pair<std::string, std::string>>& features) {
  Layer layer;
  for (const auto& [id, properties] : features) layer.end_feature(id, properties);
  return layer;
}

using Numbers = std::vector<std::uint32_t>;

TEST(FeatureGroups, are_numbered_by_their_first_features) {
  const Layer layer = layer_of({{"1", R"({"a":"x"})"},
                                {"2", R"({"b":1})"},
                                {"3", R"({"a":"\u0078","b":2})"},
                                {"4", "null"},
                                {"5", R"({"a":"y","a":"x"})"}});
  const FeatureGroups groups = group_features(layer, "a");
  EXPECT_EQ(groups.count, 2U);
  EXPECT_EQ(groups.group, (Numbers{0, 1, 0, 1, 0}))
      << "escapes are resolved, the last value counts";
  EXPECT_EQ(one_group(layer).count, 1U);
  EXPECT_EQ(one_group(Layer()).count, 0U);
}

TEST(FeatureGroups, need_a_property_that_some_feature_has) {
  EXPECT_THROW(group_features(layer_of({{"1", "{}"}}), "a"), Error);
  EXPECT_EQ(group_features(Layer(), "a").count, 0U);
}

/// Makes groups, and returns the properties of each group.
Layer merged(const Layer& layer, const FeatureGroups& groups,
             const std::vector<std::string>& sums) {
  Layer shapes;
  for (std::size_t g = 0; g < groups.count; ++g) shapes.end_feature("", "");
  return with_group_properties(shapes, layer, groups, sums);
}

TEST(GroupProperties, are_those_that_all_features_have) {
  const Layer layer = layer_of({{"7", R"({"same":[1, 2],"a":1,"text":"x","n":0.1})"},
                                {"7", R"({"n":0.2,"text":"\u0078","same":[1, 2],"a":2})"},
                                {"8", R"({"n":null,"same":12345678901234567890123})"}});
  const FeatureGroups groups{{0, 0, 1}, 2};
  const Layer result = merged(layer, groups, {});
  EXPECT_EQ(result.id(0), "7");
  EXPECT_EQ(result.properties(0), R"({"same":[1, 2],"text":"x"})");
  EXPECT_EQ(result.id(1), "8");
  EXPECT_EQ(result.properties(1), R"({"n":null,"same":12345678901234567890123})");
  const Layer all = merged(layer, one_group(layer), {});
  EXPECT_EQ(all.id(0), "");
  EXPECT_EQ(all.properties(0), "{}");
}

TEST(GroupProperties, add_exactly) {
  const Layer layer = layer_of({{"", R"({"n":9007199254740993,"x":0.1})"},
                                {"", R"({"n":9007199254740993,"x":1e300})"},
                                {"", R"({"n":-1,"x":-1e300})"},
                                {"", R"({"x":null})"}});
  const Layer sum = merged(layer, one_group(layer), {"n", "x"});
  EXPECT_EQ(sum.properties(0), R"({"n":18014398509481985,"x":0.1})");
  const FeatureGroups apart{{0, 0, 0, 1}, 2};
  EXPECT_EQ(merged(layer, apart, {"n"}).properties(1), R"({"x":null,"n":null})");
  EXPECT_THROW(merged(layer, one_group(layer), {"none"}), Error);
  const Layer text = layer_of({{"", R"({"n":"1"})"}});
  EXPECT_THROW(merged(text, one_group(text), {"n"}), Error);
}

TEST(PairProperties, of_the_same_name_get_numbers) {
  const Layer first = layer_of({{"\"F\"", R"({"name":"f","a":1})"}, {"", R"({"name":"g"})"}});
  const Layer second = layer_of({{"9", R"({"name":"s","id_1":3})"}});
  LayerOverlay overlay;
  overlay.pairs = {{0, 0}, {1, LayerRegion::kNobody}, {LayerRegion::kNobody, 0}};
  for (std::size_t i = 0; i < overlay.pairs.size(); ++i) overlay.layer.end_feature("", "");
  overlay.area = {Rational(1) / 4, 2, 3};
  const Layer named = with_pair_properties(overlay, first, second);
  EXPECT_EQ(named.properties(0),
            R"({"name_1":"f","a":1,"name_2":"s","id_1":3,"id_1_":"F","id_2":9,"area":0.25})");
  EXPECT_EQ(named.properties(1), R"({"name_1":"g","area":2})");
  EXPECT_EQ(named.properties(2), R"({"name_2":"s","id_1":3,"id_2":9,"area":3})");
}

}  // namespace
}  // namespace plumb::layer_properties_test
