// The command `plumb solid repair`, the options that mend meshes, and the hints that name them.

#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "refusal.h"
#include "run_program.h"

namespace plumb::testing::repair_command_test {
namespace {

using Json = nlohmann::json;
using Words = std::vector<std::string>;

const std::string kFlipped = "corpus/solids/flipped-box.off";
const std::string kDoubled = "corpus/solids/double-sided-box.off";
const std::string kOpen = "corpus/solids/open-box.off";
const std::string kLastBits = "corpus/solids/last-bits.stl";

class RepairProgram : public ::testing::Test {
 protected:
  std::string file(const std::string& name) const { return (scratch_ / name).string(); }
  std::string holding(const std::string& text, const std::string& name) const {
    write_file(scratch_ / name, text);
    return file(name);
  }

  const ScratchDirectory scratch_;
};

Json info(const std::string& file, Words more = {}) {
  more.insert(more.begin(), {"solid", "info", file, "--json"});
  const RunResult result = run(more);
  EXPECT_EQ(result.code, 0) << result.err;
  return result.code == 0 ? Json::parse(result.out) : Json();
}

double volume(const std::string& file, const Words& more = {}) {
  const Json json = info(file, more);
  return json.is_null() ? -1 : json["volume"]["double"].get<double>();
}

/// The options of each hint in a message: "; --weld 1e-08 --reorient mends it; --surface reads it
/// ..." has two.
std::vector<Words> hints(const std::string& message) {
  std::vector<Words> found;
  std::size_t at = 0;
  while ((at = message.find("; --", at)) != std::string::npos) {
    std::istringstream in(message.substr(at + 2));
    Words words;
    for (std::string word; in >> word && word != "mends" && word != "reads";) words.push_back(word);
    found.push_back(words);
    ++at;
  }
  return found;
}

/// Meshes of every kind that is refused, with the number of hints that are expected.
struct Refused {
  const char* name;
  std::string text;
  std::size_t hints;
  const char* says;
};

std::string off(const std::string& points, const std::string& faces) {
  const auto lines = [](const std::string& text) {
    return std::to_string(std::count(text.begin(), text.end(), '\n'));
  };
  return "OFF\n" + lines(points) + ' ' + lines(faces) + " 0\n" + points + faces;
}

const std::string kPoints = "0 0 0\n1 0 0\n0 1 0\n1 1 0\n0 0 1\n1 0 1\n0 1 1\n1 1 1\n";
const Words kSides{"4 0 2 3 1\n", "4 4 5 7 6\n", "4 0 1 5 4\n",
                   "4 2 6 7 3\n", "4 0 4 6 2\n", "4 1 3 7 5\n"};

std::string all_sides() {
  std::string text;
  for (const std::string& side : kSides) text += side;
  return text;
}

std::string sides_from(std::size_t first) {
  std::string text;
  for (std::size_t i = first; i < kSides.size(); ++i) text += kSides[i];
  return text;
}

std::string reversed_sides() {
  return "4 1 3 2 0\n4 6 7 5 4\n4 4 5 1 0\n4 3 7 6 2\n4 2 6 4 0\n4 5 7 3 1\n";
}

std::vector<Refused> refused() {
  const std::string first_flipped = "4 1 3 2 0\n" + sides_from(1);
  return {
      {"flipped.off", off(kPoints, first_flipped), 2,
       "no holes, but 1 face is flipped: 0 (0-based)"},
      {"half.off", off(kPoints, "4 1 3 2 0\n4 6 7 5 4\n4 4 5 1 0\n" + sides_from(3)), 2,
       "3 faces are flipped: 0, 1, 2 (0-based)"},
      {"open.off", off(kPoints, sides_from(1)), 2, "the mesh is open: 1 border(s)"},
      {"both.off", off(kPoints, "4 6 7 5 4\n" + sides_from(2)), 2,
       "besides, 1 face is flipped: 0 (0-based)"},
      {"twice.off", off(kPoints, all_sides() + kSides[2]), 2, "the mesh is open: 1 border(s)"},
      {"doubled.off", off(kPoints, all_sides() + reversed_sides()), 3,
       "encloses nothing: every face is there in both directions"},
      {"mixed.off", off(kPoints, first_flipped + "4 0 2 3 1\n" + reversed_sides().substr(10)), 3,
       "encloses nothing: every face is there in both directions"},
      {"doubled-open.off", off(kPoints, sides_from(1) + reversed_sides().substr(10)), 3,
       "encloses nothing: every face is there in both directions"},
      {"doubled-walls.off", off(kPoints, kSides[0] + kSides[1] + "4 1 3 2 0\n4 6 7 5 4\n"), 2,
       "encloses nothing: every face is there in both directions"},
      {"sheet.off", off(kPoints, kSides[0]), 1, "the mesh is open: 1 border(s)"},
      {"flat.off", off("0 0 0\n1 1 1\n2 2 2\n", "3 0 1 2\n"), 2,
       "encloses nothing: none of its faces has an area"},
      {"moebius.off",
       off("3 0 0\n4 0 0\n0 3 1\n0 4 1\n-3 0 1\n-4 0 2\n0 -3 0\n0 -3 1\n",
           "4 0 2 3 1\n4 2 4 5 3\n4 4 6 7 5\n4 6 1 0 7\n"),
       1, "one side only"},
      {"last-bits.stl", read_file(kLastBits), 2, "the mesh is open"},
  };
}

TEST_F(RepairProgram, ColoursStay) {
  const std::string header =
      "ply\nformat ascii 1.0\nelement vertex 8\nproperty double x\nproperty double y\n"
      "property double z\nelement face 6\nproperty list uchar int vertex_indices\n"
      "property uchar red\nproperty uchar green\nproperty uchar blue\nend_header\n";
  std::string faces;
  for (std::size_t f = 0; f < kSides.size(); ++f) {
    const std::string side = f == 2 ? "4 4 5 1 0" : kSides[f].substr(0, kSides[f].size() - 1);
    faces += side + ' ' + std::to_string(f + 1) + " 0 0\n";
  }
  const std::string box = holding(header + kPoints + faces, "box.ply");
  const auto colours = [&](const Words& more) {
    Words words{"solid", "repair", box, "-o", file("out.ply"), "--format", "ply-text"};
    words.insert(words.end(), more.begin(), more.end());
    const RunResult result = run(words);
    EXPECT_EQ(result.code, 0) << result.err;
    std::istringstream in(read_file(file("out.ply")));
    Words found;
    for (std::string line; std::getline(in, line);) {
      if (line.ends_with(" 0 0") && line.starts_with("4 ")) {
        found.push_back(line.substr(10));
      }
    }
    return found;
  };
  EXPECT_EQ(colours({}), (Words{"1 0 0", "2 0 0", "3 0 0", "4 0 0", "5 0 0", "6 0 0"}));
  EXPECT_EQ(colours({"--keep", "none"}), Words());

  // OBJ has the colours as materials in a file beside it; STL has none, and a note says so.
  EXPECT_EQ(run({"solid", "repair", box, "-o", file("out.obj")}).code, 0);
  EXPECT_NE(read_file(file("out.obj")).find("mtllib out.mtl"), std::string::npos);
  EXPECT_NE(read_file(file("out.mtl")).find("Kd"), std::string::npos);
  const RunResult stl = run({"solid", "repair", box, "-o", file("out.stl")});
  EXPECT_NE(stl.err.find("out.stl: not written, because the format does not hold them: colours"),
            std::string::npos)
      << stl.err;
}

TEST_F(RepairProgram, every_hint_leads_to_a_valid_file) {
  for (const Refused& mesh : refused()) {
    SCOPED_TRACE(mesh.name);
    const std::string path = holding(mesh.text, mesh.name);
    for (const Words& command : {Words{"solid", "info", path}, Words{"audit", path},
                                 Words{"view", path, "-o", file("a.svg")},
                                 Words{"solid", "union", path, path, "-o", file("a.nef")}}) {
      const RunResult result = run(command);
      expect_refusal(result, path + ": ", mesh.says);
      const std::vector<Words> found = hints(result.err);
      EXPECT_EQ(found.size(), mesh.hints) << result.err;
      for (const Words& hint : found) {
        Words followed = command;
        followed.insert(followed.end(), hint.begin(), hint.end());
        const RunResult answer = run(followed);
        EXPECT_EQ(answer.code, 0) << result.err << answer.err;
        if (command[1] != "union") continue;
        EXPECT_EQ(run({"audit", file("a.nef")}).code, 0) << result.err;
        const bool may_be_flat = hint[0] == "--surface" || hint[0] == "--allow-empty";
        EXPECT_EQ(volume(file("a.nef")) > 0, !may_be_flat) << result.err;
      }
    }
  }
}

TEST_F(RepairProgram, options_mend_what_is_read) {
  EXPECT_EQ(volume(kFlipped, {"--reorient"}), 2);
  EXPECT_EQ(volume(kDoubled, {"--one-side"}), 2);
  EXPECT_EQ(volume(kOpen, {"--fill-holes", "4"}), 2);
  EXPECT_NEAR(volume(kLastBits, {"--weld", "1e-6"}), 1.0 / 6, 1e-6);
  EXPECT_EQ(info(kDoubled, {"--allow-empty"})["empty"], true);
  expect_refusal(run({"solid", "info", kOpen, "--fill-holes", "3"}), kOpen, "--fill-holes 4");
  expect_refusal(run({"solid", "info", kLastBits, "--weld", "1e-9"}), kLastBits, "--weld 1e-");
  const RunResult told = run({"solid", "info", kFlipped, "--reorient"});
  EXPECT_TRUE(contains(told.err, "flipped: 0")) << told.err;
}

TEST_F(RepairProgram, options_that_mend_are_for_meshes) {
  for (const Words& more : {Words{"--weld", "1"}, Words{"--reorient"}, Words{"--allow-empty"},
                            Words{"--fill-holes", "9"}, Words{"--one-side"}}) {
    for (const Words& command : {Words{"convex", "check", "corpus/plane/star.wkt"},
                                 Words{"audit", "corpus/plane/star.wkt"},
                                 Words{"audit", "corpus/maps/us-states.clean.map"}}) {
      Words words = command;
      words.insert(words.end(), more.begin(), more.end());
      EXPECT_TRUE(contains(run(words).err, "for meshes"));
    }
  }
  for (const std::string bad : {"-1", "nan", "inf", "x", "1e999"}) {
    const RunResult result = run({"solid", "info", "corpus/solids/l-block.off", "--weld", bad});
    EXPECT_EQ(result.code, 2) << bad;
    EXPECT_TRUE(contains(result.err, "--weld: expected a distance")) << result.err;
  }
  expect_refusal(run({"solid", "info", "corpus/solids/l-block.off", "--weld", "1e308"}),
                 "corpus/solids/l-block.off", "encloses nothing");
}

TEST_F(RepairProgram, meshes_are_mended_as_meshes) {
  for (const std::string name : {"a.off", "a.obj", "a.stl", "a.ply", "a.nef"}) {
    const RunResult result = run({"solid", "repair", kFlipped, "-o", file(name)});
    EXPECT_EQ(result.code, 0) << result.err;
    // STL has triangles.
    EXPECT_EQ(result.out, std::string("8 vertices, ") + (name == "a.stl" ? "12" : "6") +
                              " faces, closed\n"
                              "faces that disagreed with their neighbours, flipped: 0\n");
    EXPECT_EQ(volume(file(name), {"--rule", "positive"}), 2) << name;
  }
  EXPECT_EQ(read_file(file("a.off")),
            "OFF\n8 6 0\n0 0 0\n2 0 0\n2 1 0\n0 1 0\n0 0 1\n2 0 1\n2 1 1\n0 1 1\n"
            "4 0 3 2 1\n4 4 5 6 7\n4 0 1 5 4\n4 1 2 6 5\n4 2 3 7 6\n4 3 0 4 7\n");
  EXPECT_EQ(run({"solid", "repair", kDoubled, "-o", file("d.off")}).code, 0);
  EXPECT_EQ(volume(file("d.off")), 2);
}

TEST_F(RepairProgram, a_mesh_that_stays_open_is_written) {
  const RunResult open = run({"solid", "repair", kOpen, "-o", file("o.ply")});
  EXPECT_EQ(open.code, 1);
  EXPECT_EQ(open.out,
            "8 vertices, 5 faces, open: 1 border, the longest of 4 edges\n"
            "nothing was mended\n--fill-holes 4 closes it\n");
  EXPECT_EQ(run({"solid", "repair", file("o.ply"), "--fill-holes", "4", "-o", file("c.off")}).code,
            0);
  EXPECT_EQ(volume(file("c.off")), 2);
  // .nef has sets only.
  EXPECT_EQ(run({"solid", "repair", kOpen, "-o", file("o.nef")}).code, 2);
  EXPECT_FALSE(fs::exists(file("o.nef")));
  expect_refusal(run({"solid", "repair", holding("plumb-nef3 1\n", "a.nef")}), file("a.nef"),
                 "a mesh is needed");
}

TEST_F(RepairProgram, the_report_goes_where_the_mesh_does_not) {
  const RunResult only = run({"solid", "repair", kFlipped});
  EXPECT_TRUE(contains(only.out, "flipped: 0"));
  const RunResult mesh = run({"solid", "repair", kFlipped, "--format", "off"});
  EXPECT_TRUE(mesh.out.starts_with("OFF\n")) << mesh.out;
  EXPECT_TRUE(contains(mesh.err, "flipped: 0")) << mesh.err;
  const RunResult json = run({"solid", "repair", kLastBits, "--weld", "1e-6", "--json"});
  EXPECT_EQ(json.code, 0);
  const Json report = Json::parse(json.out);
  EXPECT_EQ(report["closed"], true);
  EXPECT_EQ(report["vertices"], 4);
  EXPECT_EQ(report["faces"], 4);
  EXPECT_EQ(report["welded"], 3);
  EXPECT_LT(report["farthest"], 2e-7);
  EXPECT_GT(report["farthest"], 1e-7);
}

}  // namespace
}  // namespace plumb::testing::repair_command_test
