// The command `plumb map repair` from outside.

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "refusal.h"
#include "run_program.h"

namespace plumb::testing::layer_command_test {
namespace {

using Json = nlohmann::json;

const std::string kFields = "corpus/layers/fields.geojson";

TEST(MapRepairProgram, writes_a_coverage_with_ids_and_properties) {
  const ScratchDirectory scratch;
  const std::string out = (scratch / "out.geojson").string();
  const RunResult result = run({"map", "repair", kFields, "-o", out, "--json"});
  ASSERT_EQ(result.code, 0) << result.err;
  const Json report = Json::parse(result.out);
  EXPECT_EQ(report["features"], 4);
  EXPECT_GE(report["overlaps"], 2);
  const Json before = Json::parse(read_file(kFields)), after = Json::parse(read_file(out));
  ASSERT_EQ(after["features"].size(), 4U);
  for (std::size_t f = 0; f < 4; ++f) {
    EXPECT_EQ(after["features"][f]["id"], before["features"][f]["id"]);
    EXPECT_EQ(after["features"][f]["properties"], before["features"][f]["properties"]);
  }
  const RunResult checked = run({"map", "check", out});
  EXPECT_EQ(checked.out.find("superposed"), std::string::npos) << checked.out;
  const RunResult again = run({"map", "repair", out, "-o", "-", "--format", "geojson"});
  EXPECT_EQ(again.out, read_file(out)) << "a second repair changes nothing";
}

TEST(MapRepairProgram, dry_run_says_whether_there_are_defects) {
  const RunResult broken = run({"map", "repair", kFields, "--dry-run"});
  EXPECT_EQ(broken.code, 1);
  EXPECT_TRUE(contains(broken.out, "overlap of feature 1 (\"north\"), feature 2 (\"south\"): area"))
      << broken.out;
  EXPECT_TRUE(contains(broken.out, "; goes to feature 4 (\"pond\")")) << broken.out;
  const ScratchDirectory scratch;
  const std::string out = (scratch / "out.geojson").string();
  ASSERT_EQ(run({"map", "repair", kFields, "-o", out}).code, 0);
  EXPECT_EQ(run({"map", "repair", out, "--dry-run"}).code, 0);
}

TEST(MapRepairProgram, changes_are_a_layer_of_their_own) {
  const RunResult result = run({"map", "repair", kFields, "--changes", "-", "--rule", "first"});
  ASSERT_EQ(result.code, 0) << result.err;
  const Json changes = Json::parse(result.out);
  const Json report = Json::parse(run({"map", "repair", kFields, "--json", "--rule", "first"}).out);
  ASSERT_EQ(changes["features"].size(), report["regions"].size());
  for (std::size_t i = 0; i < report["regions"].size(); ++i) {
    EXPECT_EQ(changes["features"][i]["properties"], report["regions"][i]);
    EXPECT_FALSE(changes["features"][i]["geometry"].is_null());
  }
}

TEST(MapRepairProgram, refuses_what_it_cannot_do) {
  const ScratchDirectory scratch;
  const std::string out = (scratch / "out.geojson").string();
  expect_refusal(run({"map", "repair", kFields, "-o", out, "--dry-run"}),
                 "plumb: ", "--dry-run writes no layer");
  expect_refusal(run({"map", "repair", kFields, "-o", "x.svg"}), "x.svg: ", "no format has");
  expect_refusal(run({"map", "repair", "corpus/maps/us-states.map", "-o", out}),
                 "corpus/maps/us-states.map:1:", "JSON");
  expect_refusal(run({"map", "repair", kFields, "--gaps-below", "-1"}), "plumb: ", "--gaps-below");
  EXPECT_TRUE(scratch.files().empty());
}

}  // namespace
}  // namespace plumb::testing::layer_command_test
