// The commands that make, move and measure models, from outside.

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "run_program.h"

namespace plumb::testing::model_command_test {
namespace {

using Json = nlohmann::json;
using Words = std::vector<std::string>;

const std::string kBlock = "corpus/solids/l-block.off";

class ModelProgram : public ::testing::Test {
 protected:
  std::string file(const std::string& name) const { return (scratch_ / name).string(); }
  std::string holding(const std::string& text, const std::string& name) const {
    write_file(scratch_ / name, text);
    return file(name);
  }
  /// Runs a command that writes a solid, and returns what is known of it.
  Json made(Words words) const {
    const std::string out = file("made.nef");
    words.insert(words.end(), {"-o", out, "--json"});
    const RunResult result = run(words);
    EXPECT_EQ(result.code, 0) << result.err;
    return result.code == 0 ? Json::parse(result.out) : Json();
  }
  std::string volume(const Words& words) const { return made(words)["volume"]["exact"]; }

  const ScratchDirectory scratch_;
};

TEST_F(ModelProgram, makes_shapes) {
  EXPECT_EQ(volume({"solid", "make", "box", "--size", "1,2,3/2"}), "3");
  EXPECT_EQ(volume({"solid", "make", "cube", "--size", "1,2,3/2"}), "3");
  EXPECT_EQ(volume({"solid", "make", "cone", "--segments", "4", "--height", "3"}), "2");
  EXPECT_EQ(volume({"solid", "make", "cylinder", "--segments", "4", "--radius", "2"}), "8");
  const Json sphere = made({"solid", "make", "sphere", "--segments", "16"});
  EXPECT_EQ(sphere["convex"], true);
  EXPECT_EQ(sphere["vertices"], 128);
  EXPECT_EQ(made({"solid", "make", "torus"})["simple"], true);
}

TEST_F(ModelProgram, transforms) {
  const std::string block = volume({"solid", "transform", kBlock, "--translate", "1,2,3"});
  EXPECT_EQ(volume({"solid", "transform", kBlock, "--rotate", "1,1,0,33"}), block);
  EXPECT_EQ(volume({"solid", "transform", kBlock, "--mirror", "1,2,3"}), block);
  EXPECT_EQ(volume({"solid", "transform", kBlock, "--resize", "1,1,1"}).find('-'),
            std::string::npos);
  run({"solid", "transform", kBlock, "--rotate", "0,0,1,90", "-o", file("turned.nef")});
  run({"solid", "transform", file("turned.nef"), "--rotate", "0,0,1,-90", "-o", file("back.nef")});
  EXPECT_EQ(run({"solid", "compare", kBlock, file("back.nef")}).code, 0);
}

TEST_F(ModelProgram, extrudes_and_slices) {
  const std::string square = holding("POLYGON((1 0,3 0,3 2,1 2,1 0))", "square.wkt");
  EXPECT_EQ(volume({"solid", "extrude", square, "--height", "3/2"}), "6");
  EXPECT_EQ(volume({"solid", "extrude", square, "--height", "3", "--scale", "0.5,0.5"}), "7");
  run({"solid", "extrude", square, "--height", "2", "--centre", "-o", file("solid.nef")});
  EXPECT_EQ(run({"solid", "slice", file("solid.nef"), "--z", "-1"}).out,
            "POLYGON ((1 0, 3 0, 3 2, 1 2, 1 0))\n");
  EXPECT_EQ(run({"solid", "project", file("solid.nef")}).out,
            "POLYGON ((1 0, 3 0, 3 2, 1 2, 1 0))\n");
  EXPECT_EQ(volume({"solid", "revolve", square, "--steps", "4"}), "32");
  const RunResult open = run({"solid", "slice", file("solid.nef"), "--z", "5"});
  EXPECT_EQ(open.out, "GEOMETRYCOLLECTION EMPTY\n");
}

/// One feature for each height, whose geometry is that of the slice alone.
TEST_F(ModelProgram, writes_slices_at_several_heights) {
  const std::string block = kBlock;
  const Json stack = Json::parse(run({"solid", "slice", block, "--z", "0", "--z", "1", "--every",
                                      "1/4", "--format", "geojson"})
                                     .out);
  ASSERT_EQ(stack["features"].size(), 5U);
  EXPECT_EQ(stack["type"], "FeatureCollection");
  EXPECT_EQ(stack["features"][3]["id"], "z=3/4");
  EXPECT_EQ(stack["features"][3]["properties"]["z"], 0.75);
  EXPECT_EQ(stack["features"][3]["geometry"],
            Json::parse(run({"solid", "slice", block, "--z", "3/4", "--format", "geojson"}).out));
  const Words pair{"solid", "slice", block, "--z", "9", "--z", "1/2"};
  Words to_file = pair, to_json = pair;
  to_file.insert(to_file.end(), {"-o", file("pair.geojson")});
  to_json.push_back("--json");
  EXPECT_EQ(run(to_file).code, 0);
  const Json facts = Json::parse(run(to_json).out);
  ASSERT_EQ(facts["slices"].size(), 2U);
  EXPECT_EQ(facts["slices"][0]["z"]["exact"], "9");
  EXPECT_EQ(facts["slices"][0]["empty"], true);
  EXPECT_EQ(facts["slices"][1]["area"],
            Json::parse(run({"solid", "slice", block, "--z", "1/2", "--json"}).out)["area"]);
  for (const Words& rest :
       std::vector<Words>{{"--format", "wkt"},
                          {},
                          {"--format", "geojson", "--z", "2/2"},
                          {"--format", "geojson", "--every", "0"},
                          {"--format", "geojson", "--every", "-1"},
                          {"--format", "geojson", "--every", "1e-9"},
                          {"--format", "geojson", "--every", "1", "--z", "2"}}) {
    Words words{"solid", "slice", block, "--z", "0", "--z", "1"};
    words.insert(words.end(), rest.begin(), rest.end());
    const RunResult refused = run(words);
    EXPECT_EQ(refused.code, 2) << refused.err;
    EXPECT_EQ(refused.out, "");
  }
}

/// The square in which two cubes touch leaves as a polygon.
TEST_F(ModelProgram, writes_a_contact_as_a_polygon) {
  run({"solid", "make", "box", "-o", file("a.nef")});
  run({"solid", "transform", file("a.nef"), "--translate", "0,0,1", "-o", file("b.nef")});
  run({"solid", "intersection", file("a.nef"), file("b.nef"), "-o", file("contact.nef")});
  EXPECT_EQ(run({"solid", "slice", file("contact.nef"), "--z", "1"}).out,
            "POLYGON ((0 0, 1 0, 1 1, 0 1, 0 0))\n");
}

TEST_F(ModelProgram, lists_components) {
  run({"solid", "make", "box", "-o", file("a.nef")});
  run({"solid", "transform", file("a.nef"), "--translate", "3,0,0", "-o", file("b.nef")});
  run({"solid", "union", file("a.nef"), file("b.nef"), "-o", file("both.nef")});
  EXPECT_EQ(run({"solid", "components", file("both.nef")}).out,
            "2 components\n"
            "1: 6 facets, volume 1, genus 0, box (0 0 0) to (1 1 1)\n"
            "2: 6 facets, volume 1, genus 0, box (3 0 0) to (4 1 1)\n");
  const Json json = Json::parse(run({"solid", "components", file("both.nef"), "--json"}).out);
  EXPECT_EQ(json["components"].size(), 2U);
  EXPECT_EQ(volume({"solid", "hull", file("a.nef"), file("b.nef")}), "4");
}

TEST_F(ModelProgram, examples_of_the_help_work) {
  for (const std::string name : {"make", "hull", "offset", "transform", "extrude", "revolve",
                                 "slice", "project", "components", "distance"}) {
    const std::string text = run({"solid", name, "--help"}).out;
    const std::size_t start = text.find("  ./plumb solid " + name);
    ASSERT_NE(start, std::string::npos) << text;
    std::istringstream example(text.substr(start + 10, text.find('\n', start) - start - 10));
    Words words;
    for (std::string word; example >> word;) {
      words.push_back(word.starts_with("out.") ? file(word) : word);
    }
    EXPECT_EQ(run(words).code, 0) << text;
  }
}

TEST_F(ModelProgram, refuses_wrong_usage) {
  const std::string square = holding("POLYGON((-1 0,3 0,3 2,1 2,-1 0))", "square.wkt");
  for (const Words& words :
       std::vector<Words>{{"solid", "make", "egg"},
                          {"solid", "make", "box", "--size", "1,2"},
                          {"solid", "make", "box", "--size", "1,2,0"},
                          {"solid", "make", "sphere", "--segments", "2"},
                          {"solid", "make", "sphere", "--radius", "nan"},
                          {"solid", "transform", kBlock, "--scale", "1,1,0"},
                          {"solid", "transform", kBlock, "--rotate", "0,0,0,1"},
                          {"solid", "extrude", square},
                          {"solid", "extrude", square, "--height", "-1"},
                          {"solid", "revolve", square},
                          {"solid", "slice", kBlock},
                          {"solid", "slice", square, "--z", "1"}}) {
    const RunResult refused = run(words);
    EXPECT_EQ(refused.code, 2) << words[1] << ' ' << words[2] << refused.out;
    EXPECT_EQ(refused.out, "");
  }
}

}  // namespace
}  // namespace plumb::testing::model_command_test
