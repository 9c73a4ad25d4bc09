// The commands `plumb solid ...` from outside.

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "plumb/predicates/rational.h"
#include "refusal.h"
#include "run_program.h"

namespace plumb::testing::solid_command_test {
namespace {

using Json = nlohmann::json;
using Words = std::vector<std::string>;

const std::string kBlock = "corpus/solids/l-block.off";
const std::string kCorner = "corpus/solids/tetrahedron.off";

const Words kBinary{"union", "intersection", "difference", "symmetric-difference"};
const Words kUnary{"complement", "interior", "closure", "boundary", "regularize"};

Json parsed(const RunResult& result) {
  EXPECT_EQ(result.code, 0) << result.err;
  return Json::parse(result.out);
}

Json info(const std::string& file) { return parsed(run({"solid", "info", file, "--json"})); }

bool is_equal(const std::string& a, const std::string& b) {
  const RunResult result = run({"solid", "compare", a, b, "--json"});
  const bool equal = Json::parse(result.out)["equal"];
  EXPECT_EQ(result.code, equal ? 0 : 1);
  return equal;
}

Rational volume(const Json& json) { return Rational(json["volume"]["exact"].get<std::string>()); }

/// Any command, with a file of its own for the result.
class SolidProgram : public ::testing::Test {
 protected:
  std::string file(const std::string& name) const { return (scratch_ / name).string(); }
  std::string made(Words words, const std::string& name) const {
    words.insert(words.begin(), "solid");
    words.insert(words.end(), {"-o", file(name)});
    const RunResult result = run(words);
    EXPECT_EQ(result.code, 0) << result.err;
    EXPECT_EQ(result.out, "");
    return file(name);
  }
  std::string holding(const std::string& text, const std::string& name) const {
    write_file(scratch_ / name, text);
    return file(name);
  }
  bool exists(const std::string& name) const { return fs::exists(scratch_ / name); }

  const ScratchDirectory scratch_;
};

TEST_F(SolidProgram, examples_of_the_help_work) {
  std::istringstream list(run({"solid", "--help"}).out);
  std::size_t count = 0;
  for (std::string line; std::getline(list, line);) {
    if (!line.starts_with("  solid ")) continue;
    const std::string name = line.substr(8, line.find(' ', 8) - 8);
    const std::string text = run({"solid", name, "--help"}).out;
    const std::size_t start = text.find("  ./plumb solid " + name);
    ASSERT_NE(start, std::string::npos) << text;
    // By a shell, as a user does: an expression is quoted.
    const std::string example = text.substr(start + 10, text.find('\n', start) - start - 10);
    const std::string root = fs::current_path().string();
    std::string command = "root='" + root + "'; cd '" + file(".") +
                          "' && ln -sfn \"$root/corpus\" corpus && '" + PLUMB_PROGRAM + "' " +
                          example + " >/dev/null 2>&1";
    EXPECT_EQ(std::system(command.c_str()), 0) << example;
    ++count;
  }
  EXPECT_EQ(count, kBinary.size() + kUnary.size() + 18);
}

/// What is written is what is read, in every format; .nef says all, meshes the closure.
TEST_F(SolidProgram, every_format_goes_in_and_out) {
  const std::string exact = made({"difference", kBlock, kCorner}, "exact.nef");
  const std::string closed = made({"closure", exact}, "closed.nef");
  EXPECT_FALSE(is_equal(exact, closed));
  for (const std::string name : {"a.off", "a.obj", "a.stl", "a.ply", "a.glb", "a.3mf", "a.nef"}) {
    const std::string copy = made({"closure", exact}, name);
    EXPECT_TRUE(is_equal(copy, closed)) << name;
    EXPECT_EQ(info(copy)["volume"]["exact"], "17/6") << name;
    EXPECT_EQ(run({"audit", copy}).code, 0) << name;
    RunOptions from_file;
    from_file.in = copy;
    const RunResult piped = run({"solid", "info", "-", "--json"}, from_file);
    EXPECT_EQ(piped.out, run({"solid", "info", copy, "--json"}).out) << name;
  }
  for (const std::string format :
       {"off", "off-exact", "obj", "stl", "stl-binary", "ply", "ply-text", "glb", "3mf", "nef"}) {
    const RunResult result = run({"solid", "closure", exact, "-o", "-", "--format", format});
    EXPECT_EQ(result.code, 0) << result.err;
    EXPECT_TRUE(is_equal(holding(result.out, "copy"), closed)) << format;
  }
}

TEST_F(SolidProgram, an_empty_set_is_no_glb) {
  const RunResult result = run({"solid", "difference", kBlock, kBlock, "-o", file("empty.glb")});
  EXPECT_EQ(result.code, 2) << result.err;
  EXPECT_NE(result.err.find("the set has no volume"), std::string::npos) << result.err;
  EXPECT_FALSE(exists("empty.glb"));
}

TEST_F(SolidProgram, binary_commands_read_each_format_beside_each) {
  const std::string nef = made({"interior", kBlock}, "a.nef");
  for (const std::string& other :
       {std::string("corpus/solids/l-block.obj"), std::string("corpus/solids/l-block.ply"), nef}) {
    for (const std::string& command : kBinary) {
      const std::string out = made({command, nef, other}, "out.nef");
      EXPECT_EQ(info(out)["marked_volumes"],
                command == "union" || command == "intersection" ? 1 : 0);
    }
  }
  EXPECT_TRUE(is_equal(made({"union", nef, kBlock}, "u.nef"), kBlock));
  EXPECT_TRUE(is_equal(made({"intersection", nef, kBlock}, "i.nef"), nef));
}

/// |A + B| = |A| + |B| - |A * B|, exactly, through files.
// Neither of what is written nor of what is noted, in the order of the files.
TEST_F(SolidProgram, threads_change_no_byte) {
  const std::string inside_out =
      holding("OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 1 2\n3 0 3 1\n3 0 2 3\n3 1 3 2\n",
              "inside-out.off");
  const std::vector<Words> commands{
      {"solid", "union", inside_out, kBlock, "--format", "nef", "-o", "-"},
      {"solid", "eval", "a-b+c", "a=" + kBlock, "b=" + inside_out, "c=" + kCorner, "--json"},
      {"solid", "compare", inside_out, kCorner},
      {"solid", "difference", file("none.off"), file("none either.off")},
  };
  for (const Words& words : commands) {
    const RunResult expected = run(words);
    EXPECT_NE(expected.out + expected.err, "");
    for (const char* threads : {"2", "5"}) {
      Words with_threads = words;
      with_threads.insert(with_threads.end(), {"--threads", threads});
      const RunResult result = run(with_threads);
      EXPECT_EQ(result.code, expected.code);
      EXPECT_EQ(result.out, expected.out);
      EXPECT_EQ(result.err, expected.err);
    }
  }
}

TEST_F(SolidProgram, canonical_files_of_equal_sets_are_the_same) {
  const auto canonical = [&](Words words, const std::string& name) {
    words.push_back("--canonical");
    return read_file(made(words, name));
  };
  const std::string either = canonical({"union", kBlock, kCorner}, "either.nef");
  EXPECT_EQ(canonical({"union", kCorner, kBlock}, "again.nef"), either);
  EXPECT_EQ(canonical({"eval", "(A-B)+(B-A)+A*B", "A=" + kBlock, "B=" + kCorner}, "parts.nef"),
            either);
  EXPECT_EQ(canonical({"complement", made({"complement", file("parts.nef")}, "rest.nef")}, "c.nef"),
            either);
  EXPECT_NE(canonical({"interior", file("either.nef")}, "open.nef"), either);
}

// A polygon without holes of n corners has n - 2 triangles: three sides of the cube without a
// corner have six corners, three are whole, and the cut has three squares.
TEST_F(SolidProgram, triangles_on_request) {
  const std::string cube = made({"make", "box", "--size", "2,2,2"}, "cube.off");
  const std::string corner = made({"make", "box"}, "corner.off");
  const auto sizes_of_faces = [&](const std::string& name, const Words& more) {
    Words words{"difference", cube, corner};
    words.insert(words.end(), more.begin(), more.end());
    std::istringstream in(read_file(made(words, name)));
    std::map<int, int> count;
    for (std::string line; std::getline(in, line);) {
      if (line.rfind("f ", 0) == 0) ++count[static_cast<int>(std::ranges::count(line, ' '))];
    }
    return count;
  };
  EXPECT_EQ(sizes_of_faces("p.obj", {}), (std::map<int, int>{{4, 6}, {6, 3}}));
  EXPECT_EQ(sizes_of_faces("t.obj", {"--triangles"}), (std::map<int, int>{{3, 6 * 2 + 3 * 4}}));
  EXPECT_TRUE(is_equal(file("p.obj"), file("t.obj")));

  const std::string red = holding(
      "color([1, 0, 0, 1]) { difference() { cube(size = [2, 2, 2], center = false); "
      "cube(size = [1, 1, 1], center = false); } }",
      "red.csg");
  const auto has_polygon = [&](const Words& more) {
    Words words{"csg", red};
    words.insert(words.end(), more.begin(), more.end());
    return contains(read_file(made(words, "red.off")), "\n6 ");
  };
  EXPECT_TRUE(has_polygon({}));
  EXPECT_FALSE(has_polygon({"--triangles"}));

  const RunResult nef = run({"solid", "closure", cube, "--triangles", "-o", file("c.nef")});
  EXPECT_EQ(nef.code, 2);
  EXPECT_TRUE(contains(nef.err, "--triangles needs a format of meshes")) << nef.err;
  EXPECT_FALSE(exists("c.nef"));
}

// The checkerboard has 8 * 8 squares on each side. A box cuts off 3 * 3 * 3 unit cubes at a corner.
TEST_F(SolidProgram, faces_stay_apart_on_request) {
  const std::string board = "corpus/solids/checkerboard.obj";
  const std::string corner = made({"make", "box", "--size", "3,3,3"}, "corner.nef");
  const auto faces = [&](const std::string& name, const Words& more) {
    Words words{"difference", board, corner, "--keep", "none", "-q"};
    words.insert(words.end(), more.begin(), more.end());
    const std::string off = read_file(made(words, name));
    std::size_t vertices = 0, count = 0;
    std::istringstream(off.substr(off.find('\n'))) >> vertices >> count;
    return count;
  };
  EXPECT_EQ(faces("joined.off", {}), 9U);
  // Three squares of 9 are gone; the three walls of the corner have no faces of a mesh.
  EXPECT_EQ(faces("apart.off", {"--keep-faces"}), 6 * 64 - 3 * 9 + 3U);
  EXPECT_TRUE(is_equal(file("joined.off"), file("apart.off")));
  for (const std::string command : {"slice", "project"}) {
    EXPECT_FALSE(contains(run({"solid", command, "--help"}).out, "--keep")) << command;
  }
}

TEST_F(SolidProgram, volumes_add_up) {
  const auto of = [](const std::string& command) {
    return volume(parsed(run({"solid", command, kBlock, kCorner, "--json"})));
  };
  EXPECT_EQ(of("union"), volume(info(kBlock)) + volume(info(kCorner)) - of("intersection"));
  EXPECT_EQ(of("difference"), volume(info(kBlock)) - of("intersection"));
  EXPECT_EQ(of("symmetric-difference"), of("union") - of("intersection"));
}

TEST_F(SolidProgram, unbounded_sets_need_nef) {
  for (const std::string name : {"out.off", "out.obj", "out.stl", "out.ply"}) {
    for (const Words& more : {Words{}, Words{"--json"}, Words{"--strict"}}) {
      Words words{"solid", "complement", kBlock, "-o", file(name)};
      words.insert(words.end(), more.begin(), more.end());
      expect_refusal(run(words), file(name) + ": ", "reaches to infinity");
      EXPECT_FALSE(exists(name));
    }
  }
  expect_refusal(run({"solid", "complement", kBlock, "--format", "off"}), "stdout: ", ".nef can");
  const std::string rest = made({"complement", kBlock, "--strict"}, "rest.nef");
  EXPECT_EQ(info(rest)["bounded"], false);
  EXPECT_EQ(info(rest)["volume"], nullptr);
  EXPECT_TRUE(contains(run({"solid", "info", rest}).out, "unbounded"));
  EXPECT_TRUE(is_equal(made({"interior", made({"complement", rest}, "again.nef")}, "in.nef"),
                       made({"interior", kBlock}, "open.nef")));
}

TEST_F(SolidProgram, a_half_space_has_one_facet) {
  const std::string half = holding("1 0 0 0 open\n", "half.txt");
  const Json json = info(made({"halfspaces", half}, "half.nef"));
  EXPECT_EQ(json,
            Json::parse(R"({"vertices":0,"edges":0,"facets":1,"volumes":2,"marked_volumes":1,)"
                        R"("bounded":false,"empty":false,"simple":true,"convex":true,)"
                        R"("volume":null})"));
  const auto locate = [&](const char* x) {
    return parsed(run({"solid", "locate", file("half.nef"), x, "0", "0", "--json"}));
  };
  EXPECT_EQ(locate("0"), Json::parse(R"({"on":"facet","marked":false})"));
  EXPECT_EQ(locate("-1/3"), Json::parse(R"({"on":"volume","marked":true})"));
}

TEST_F(SolidProgram, what_a_mesh_cannot_say_is_told) {
  const RunResult open = run({"solid", "interior", kBlock, "-o", file("a.off")});
  EXPECT_EQ(open.code, 0);
  EXPECT_EQ(open.err, "") << "a mesh is a closed solid";
  EXPECT_TRUE(is_equal(file("a.off"), kBlock));
  const RunResult difference = run({"solid", "difference", kBlock, kCorner, "-o", file("d.off")});
  EXPECT_EQ(difference.code, 0);
  EXPECT_EQ(difference.err, "");
  const RunResult flat = run({"solid", "boundary", kBlock, "-o", file("b.off")});
  EXPECT_TRUE(contains(flat.err, "8 facets, 18 edges, 12 vertices")) << flat.err;
  expect_refusal(run({"solid", "interior", kBlock, "-o", file("c.off"), "--strict"}), file("c.off"),
                 "--strict: the set is not closed");
  expect_refusal(run({"solid", "boundary", kBlock, "-o", file("c.off"), "--strict"}), file("c.off"),
                 "--strict: left out");
  EXPECT_FALSE(exists("c.off"));
  EXPECT_EQ(run({"solid", "interior", kBlock, "-o", file("c.nef"), "--strict"}).code, 0);
}

/// The exact volume of rounded coordinates has hundreds of digits: text does not print them, JSON
/// does.
TEST_F(SolidProgram, long_numbers_are_for_programs) {
  const std::string mesh = holding(
      "OFF\n4 4 0\n0.1 0.2 0.3\n1e20 0.7 1e-9\n0.3 1e-20 1e10\n0.9 1e18 0.11\n"
      "3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n",
      "long.off");
  const std::string text = run({"solid", "info", mesh}).out;
  const std::string exact = info(mesh)["volume"]["exact"];
  const auto digits = exact.size() - (contains(exact, "/") ? 1 : 0);
  EXPECT_GT(digits, 100U);
  EXPECT_FALSE(contains(text, exact.substr(0, 40))) << text;
  EXPECT_TRUE(contains(text, "the exact number has " + std::to_string(digits) + " digits")) << text;
  EXPECT_TRUE(contains(run({"solid", "info", kBlock}).out, "\nvolume 3\n"));
}

/// A file called .nef is one, whatever it begins with; without a name, its beginning tells.
TEST_F(SolidProgram, nef_files_are_told_by_name_or_by_their_beginning) {
  const std::string nef = made({"complement", kBlock}, "a.nef");
  const std::string text = read_file(nef);
  EXPECT_EQ(info(holding("\xEF\xBB\xBF" + text, "mark.nef")), info(nef));
  EXPECT_EQ(info(holding("\xEF\xBB\xBF" + text, "mark")), info(nef));
  EXPECT_EQ(info(holding(text, "noname")), info(nef));
  for (const std::string wrong : {"v 0 0 0\n", "garbage", "plumb-nef2 1\n", "OFF\n"}) {
    const std::string bad = holding(wrong, "bad.nef");
    for (const Words& words : {Words{"solid", "info", bad}, Words{"audit", bad}}) {
      expect_refusal(run(words), bad + ":1:1: ", "plumb-nef3");
    }
  }
  expect_refusal(run({"solid", "info", holding(text, "a.off")}), file("a.off") + ": ",
                 "give the file the extension .nef");
}

/// Each kind of item of an octant, told alike in words and in JSON.
TEST_F(SolidProgram, text_says_where_a_point_lies) {
  const std::string octant = made(
      {"halfspaces", holding("-1 0 0 0 closed\n0 -1 0 0 open\n0 0 -1 0 closed\n", "octant.txt")},
      "octant.nef");
  const std::vector<std::pair<Words, const char*>> places{
      {{"0", "0", "0"}, "vertex"},  {{"3", "0", "0"}, "edge"},   {{"0", "1", "0"}, "edge"},
      {{"0", "1/7", "2"}, "facet"}, {{"1", "1", "1"}, "volume"}, {{"-1", "1", "1"}, "volume"}};
  for (const auto& [point, item] : places) {
    Words words{"solid", "locate", octant};
    words.insert(words.end(), point.begin(), point.end());
    const std::string text = run(words).out;
    words.push_back("--json");
    const Json json = parsed(run(words));
    EXPECT_EQ(json["on"], item);
    EXPECT_EQ(json["marked"], point[0][0] != '-' && point[1] != "0") << text;
    EXPECT_TRUE(contains(text, item)) << text;
  }
}

TEST_F(SolidProgram, text_says_how_two_sets_lie) {
  const std::string open = made({"interior", kBlock}, "open.nef");
  const std::string rest = made({"complement", kBlock}, "rest.nef");
  const auto compare = [](const std::string& a, const std::string& b) {
    return run({"solid", "compare", a, b}).out;
  };
  EXPECT_EQ(compare(kBlock, kBlock), "equal\n");
  EXPECT_EQ(compare(open, kBlock), "A lies in B\n");
  EXPECT_EQ(compare(kBlock, open), "B lies in A\n");
  EXPECT_EQ(compare(kBlock, rest), "disjoint\n");
  const auto half = [&](const char* plane, const char* name) {
    return made({"section", kBlock, "--plane", plane, "--side", "closed"}, name);
  };
  EXPECT_EQ(compare(half("1,0,0,-1/2", "x.nef"), half("0,1,0,-1/2", "y.nef")), "they overlap\n");
  const std::string nothing = made({"difference", kBlock, kBlock}, "nothing.nef");
  EXPECT_TRUE(contains(run({"solid", "info", nothing}).out, "bounded, empty")) << nothing;
  EXPECT_TRUE(contains(run({"solid", "info", kCorner}).out, "simple, convex\nvolume "));
  EXPECT_TRUE(contains(run({"solid", "info", kBlock}).out, "simple, not convex\n"));
  const std::string sides = made({"boundary", kBlock}, "boundary.nef");
  EXPECT_TRUE(contains(run({"solid", "info", sides}).out, "not simple"));
}

/// Whatever plane cuts, what lies within and what lies beyond are the set, and share nothing.
TEST_F(SolidProgram, sections_add_up) {
  for (const char* plane : {"0,0,-1,1/2", "1,1,1,-1"}) {
    for (const char* side : {"closed", "open", "plane"}) {
      Words words{"section", kBlock, "--plane", plane, "--side", side};
      const std::string inside = made(words, "inside.nef");
      words.insert(words.end(), {"--keep", "outside"});
      const std::string outside = made(words, "outside.nef");
      EXPECT_TRUE(is_equal(made({"union", inside, outside}, "all.nef"), kBlock)) << plane << side;
      EXPECT_EQ(info(made({"intersection", inside, outside}, "both.nef"))["empty"], true);
    }
  }
}

/// Two cubes that overlap, the second inside out: the rules of docs/space.md.
TEST_F(SolidProgram, rules_say_what_is_inside) {
  std::string text = "OFF\n16 12 0\n";
  for (const int low : {0, 1}) {
    for (int i = 0; i < 8; ++i) {
      text += std::to_string(low + (i & 1) * 2) + ' ' + std::to_string(low + (i >> 1 & 1) * 2) +
              ' ' + std::to_string(low + (i >> 2) * 2) + '\n';
    }
  }
  for (const int first : {0, 8}) {
    for (std::array face : {std::array{0, 2, 3, 1},
                            {4, 5, 7, 6},
                            {0, 1, 5, 4},
                            {2, 6, 7, 3},
                            {0, 4, 6, 2},
                            {1, 3, 7, 5}}) {
      if (first != 0) std::swap(face[0], face[2]);
      text += '4';
      for (const int corner : face) text += ' ' + std::to_string(first + corner);
      text += '\n';
    }
  }
  const std::string cubes = holding(text, "cubes.off");
  const auto by = [&](const char* rule) {
    return volume(parsed(run({"solid", "info", cubes, "--rule", rule, "--json"})));
  };
  EXPECT_EQ(by("positive"), 7);
  EXPECT_EQ(by("nonzero"), 14);
  EXPECT_EQ(by("odd"), 14);
  EXPECT_EQ(volume(info(cubes)), 15);
}

TEST_F(SolidProgram, warns_of_geometry_that_is_not_read_even_if_quiet) {
  const std::string mesh = holding(
      "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\nvw 1\nsurf 0 1 0 1 "
      "1\n",
      "a.obj");
  const std::string warning = mesh + ": warning: geometry that was not read: free-form surfaces\n";
  const std::string note = mesh + ": passed over: unknown statements 'vw'\n";
  for (const Words& words :
       {Words{"solid", "info", mesh}, Words{"solid", "interior", mesh, "-o", file("b.nef")},
        Words{"convex", "check", mesh}}) {
    EXPECT_EQ(run(words).err, note + warning) << words[1];
    Words quiet = words;
    quiet.push_back("--quiet");
    EXPECT_EQ(run(quiet).err, warning) << words[1];
  }
}

/// Returns the box from (o, o, o) to (o + 2, o + 2, o + 2) as OFF, with a colour behind each face.
std::string colored_box(int o, const std::string& color) {
  std::string text = "OFF\n8 6 0\n";
  for (int i = 0; i < 8; ++i) {
    for (const int bit : {i & 1, i >> 1 & 1, i >> 2}) text += std::to_string(o + 2 * bit) + ' ';
    text += '\n';
  }
  for (const char* face : {"0 2 3 1", "4 5 7 6", "0 1 5 4", "2 6 7 3", "0 4 6 2", "1 3 7 5"}) {
    text += "4 " + std::string(face) + ' ' + color + '\n';
  }
  return text;
}

/// Returns how many lines of a file end with these words.
std::ptrdiff_t lines_with(const std::string& path, const std::string& ending) {
  std::ifstream in(path);
  std::ptrdiff_t count = 0;
  for (std::string line; std::getline(in, line);) count += line.ends_with(ending) ? 1 : 0;
  return count;
}

TEST_F(SolidProgram, keeps_the_colours_of_faces) {
  const std::string red = holding(colored_box(0, "255 0 0"), "red.off");
  const std::string blue = holding(colored_box(1, "0 0 255"), "blue.off");
  const Words united{"solid", "union", red, blue, "-o"};
  const auto write = [&](const std::string& name, const Words& more) {
    Words words = united;
    words.push_back(file(name));
    words.insert(words.end(), more.begin(), more.end());
    const RunResult result = run(words);
    EXPECT_EQ(result.code, 0);
    return result.err;
  };
  EXPECT_EQ(write("u.off", {}), "");
  EXPECT_GT(lines_with(file("u.off"), " 255 0 0"), 0);
  EXPECT_GT(lines_with(file("u.off"), " 0 0 255"), 0);
  EXPECT_EQ(write("u.obj", {}), "");
  EXPECT_EQ(lines_with(file("u.obj"), "mtllib u.mtl"), 1);
  EXPECT_EQ(lines_with(file("u.mtl"), "Kd 1 0 0"), 1);
  EXPECT_EQ(lines_with(file("u.mtl"), "Kd 0 0 1"), 1);
  EXPECT_EQ(write("u.stl", {}), file("u.stl") +
                                    ": not written, because the format does not hold "
                                    "them: colours of faces\n");
  EXPECT_EQ(write("plain.off", {"--keep", "ids"}), "");
  EXPECT_EQ(lines_with(file("plain.off"), " 255 0 0"), 0);
  const std::string notes = write("none.off", {"--keep", "none"});
  EXPECT_EQ(notes,
            red + ": passed over: colours of faces\n" + blue + ": passed over: colours of faces\n");
  const auto measured = [&](const std::string& name) { return volume(info(file(name))); };
  for (const char* name : {"u.off", "u.obj", "u.stl", "none.off"}) EXPECT_EQ(measured(name), 15);
}

TEST_F(SolidProgram, only_materials_that_faces_have_are_written) {
  std::string library;
  for (int i = 0; i < 1000; ++i) library += "newmtl m" + std::to_string(i) + "\nKd 0.5 0 0\n";
  holding(library, "many.mtl");
  const std::string mesh = holding(
      "mtllib many.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nusemtl m700\nf 1 3 2\n"
      "f 1 2 4\nusemtl m30\nf 2 3 4\nf 1 4 3\n",
      "many.obj");
  EXPECT_EQ(run({"solid", "closure", mesh, "-o", file("few.obj")}).code, 0);
  EXPECT_EQ(read_file(file("few.mtl")),
            "# plumb\nnewmtl m700\nKd 0.5 0 0\nd 1\nnewmtl m30\nKd 0.5 0 0\nd 1\n");
  EXPECT_EQ(lines_with(file("few.obj"), "usemtl m700"), 1);
  EXPECT_EQ(lines_with(file("few.obj"), "usemtl m30"), 1);
}

TEST_F(SolidProgram, files_without_faces_are_refused) {
  const std::string mesh = holding("OFF 2 0 0\n0 0 0\n1 0 0\n", "a.off");
  for (const char* group : {"solid", "convex"}) {
    const Words words{group, group == std::string("solid") ? "info" : "check", mesh};
    expect_refusal(run(words), mesh, "has 2 vertices but no faces");
  }
  const RunResult empty = run({"solid", "info", mesh, "--surface", "--quiet"});
  EXPECT_EQ(empty.code, 0);
  EXPECT_EQ(empty.err,
            mesh + ": warning: the file has 2 vertices but no faces; the set is empty\n");
}

TEST_F(SolidProgram, wrong_usage_is_refused) {
  const auto refuse = [](Words words, const std::string& part) {
    words.insert(words.begin(), "solid");
    expect_refusal(run(words), "", part);
  };
  refuse({"union", "-", "-"}, "only one of the sets");
  refuse({"compare", "-", "-"}, "only one of the sets");
  refuse({"eval", "A+B", "A=-", "B=-"}, "only one of the sets");
  refuse({"union", kBlock, kBlock, "-o", "-"}, "needs --format");
  refuse({"union", kBlock, kBlock, "-o", file("a.txt")},
         "use .off, .obj, .stl, .ply, .glb, .3mf, .nef or --format");
  refuse({"eval", "A+", "A=" + kBlock}, "expression:1:3");
  refuse({"eval", "A+B", "A=" + kBlock}, "no file for 'B'");
  for (const char* binding : {"A", "=", "=a.off", "A="}) {
    refuse({"eval", "A+B", "B=" + kBlock, binding}, "expected NAME=FILE");
  }
  refuse({"eval", "A", "A=" + kBlock, "A=" + kCorner}, "two files for 'A'");
  refuse({"eval", "A", "A=" + kBlock, "B=" + kCorner}, "the expression has no 'B'");
  refuse({"section", kBlock, "--plane", "0,0,0,1", "--side", "open"}, "all zero");
  refuse({"section", kBlock, "--plane", "1,0,0", "--side", "open"}, "four numbers");
  refuse({"locate", kBlock, "1", "x", "2"}, "Y: expected a number");
  refuse({"info", "no-such.nef"}, "No such file");
  EXPECT_TRUE(scratch_.files().empty());
}

}  // namespace
}  // namespace plumb::testing::solid_command_test
