// The commands `plumb convex ...` from outside.

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "run_program.h"

namespace plumb::testing {
namespace {

using Json = nlohmann::json;

const std::string kBlock = "corpus/solids/l-block.off";

std::string polyhedron(const std::string& name) { return "corpus/polyhedra/test_" + name + ".off"; }

TEST(ConvexProgram, check_says_why) {
  EXPECT_EQ(run({"convex", "check", polyhedron("zero"), "--json"}).out,
            "{\"convex\":true,\"reflex_edges\":0,\"faces\":[]}\n");
  const RunResult result = run({"convex", "check", polyhedron("three"), "--json"});
  EXPECT_EQ(result.code, 1);
  const Json json = Json::parse(result.out);
  EXPECT_EQ(json["convex"], false);
  EXPECT_EQ(json["reflex_edges"], 2);
  EXPECT_EQ(json["faces"], (Json{2, 3, 4, 5}));  // the four beside the two edges at vertex 6
  EXPECT_EQ(run({"convex", "check", "corpus/solids/two-tetrahedra.off"}).code, 1);
}

TEST(ConvexProgram, decompose_writes_a_file_for_each_piece) {
  const ScratchDirectory scratch;
  const fs::path directory = scratch / "pieces";
  const RunResult result = run({"convex", "decompose", kBlock, "-o", directory.string(), "--json"});
  ASSERT_EQ(result.code, 0) << result.err;
  const Json json = Json::parse(result.out);
  EXPECT_EQ(json["pieces"], 2);
  EXPECT_EQ(json["reflex_edges"], 1);
  EXPECT_EQ(json["volume_matches"], true);
  for (const char* name : {"piece_0001.off", "piece_0002.off"}) {
    EXPECT_EQ(run({"convex", "check", (directory / name).string()}).code, 0) << name;
  }
  EXPECT_FALSE(fs::exists(directory / "piece_0003.off"));
  const std::string whole = (scratch / "whole.off").string();
  run({"solid", "union", (directory / "piece_0001.off").string(),
       (directory / "piece_0002.off").string(), "-o", whole});
  EXPECT_EQ(run({"solid", "compare", whole, kBlock}).code, 0);
}

TEST(ConvexProgram, decompose_takes_unbounded_sets) {
  const ScratchDirectory scratch;
  const std::string outside = (scratch / "outside.nef").string();
  run({"solid", "complement", kBlock, "-o", outside});
  const fs::path directory = scratch / "pieces";
  const RunResult result =
      run({"convex", "decompose", outside, "--closed", "-o", directory.string(), "--json"});
  ASSERT_EQ(result.code, 0) << result.err;
  EXPECT_TRUE(Json::parse(result.out)["volume_matches"].is_null());
  EXPECT_EQ(run({"convex", "check", (directory / "piece_0001.nef").string(), "--json"}).code, 0);
}

TEST(ConvexProgram, report_is_that_of_the_notes) {
  std::vector<std::string> words{"convex", "report"};
  for (const char* name : {"zero", "one", "two", "three", "four"}) {
    words.push_back(polyhedron(name));
  }
  const RunResult result = run(words);
  EXPECT_EQ(result.code, 0) << result.err;
  EXPECT_TRUE(
      result.out.starts_with("1 - TestZero: IsPolyhedronConvex SUCCESS\n"
                             "2 - TestOne: IsPolyhedronConvex FAILED\n"));
  EXPECT_TRUE(result.out.ends_with(
      "18 - TestFour: IsPolyhedronConvex 2 SUCCESS\n"
      "Total Tests done: 18, Number Success Tests: 14, Number Error Tests: 4\n"));
}

TEST(ConvexProgram, refuses_what_it_cannot_do) {
  for (const std::vector<std::string>& words :
       {std::vector<std::string>{"convex", "check", "nowhere.off"},
        std::vector<std::string>{"convex", "decompose", kBlock, "-o", "-"},
        std::vector<std::string>{"convex", "decompose", kBlock, "--method", "luck"}}) {
    const RunResult result = run(words);
    EXPECT_EQ(result.code, 2);
    EXPECT_EQ(result.out, "");
    EXPECT_NE(result.err, "");
  }
}

TEST(ConvexProgram, minkowski_adds_two_solids) {
  const RunResult result = run({"convex", "minkowski", kBlock, polyhedron("zero"), "--json"});
  ASSERT_EQ(result.code, 0) << result.err;
  EXPECT_EQ(Json::parse(result.out)["bounded"], true);
  EXPECT_EQ(run({"convex", "minkowski", kBlock, "no-such-file.off"}).code, 2);
}

}  // namespace
}  // namespace plumb::testing
