// The commands `plumb solid csg` and `plumb plane csg` from outside.

#include <gtest/gtest.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "refusal.h"
#include "run_program.h"

namespace plumb::testing::csg_command_test {
namespace {

using Json = nlohmann::json;
using Words = std::vector<std::string>;

const std::string kBracket = "corpus/csg/bracket.csg";
const std::string kGasket = "corpus/csg/gasket.csg";

/// Tests that write files.
class CsgProgram : public ::testing::Test {
 protected:
  std::string file(const std::string& name) const { return (scratch_ / name).string(); }
  std::string holding(const std::string& text, const std::string& name) const {
    write_file(file(name), text);
    return file(name);
  }

  ScratchDirectory scratch_;
};

std::string exact_volume(const Words& words) {
  const RunResult result = run(words);
  EXPECT_EQ(result.code, 0) << result.err;
  return Json::parse(result.out)["volume"]["exact"];
}

TEST_F(CsgProgram, writes_the_same_set_in_every_exact_way) {
  const std::string nef = file("bracket.nef");
  EXPECT_EQ(run({"solid", "csg", kBracket, "--canonical", "-o", nef}).code, 0);
  EXPECT_EQ(run({"audit", nef}).code, 0);
  EXPECT_EQ(exact_volume({"solid", "csg", kBracket, "--json"}),
            exact_volume({"solid", "info", nef, "--json"}));
}

TEST_F(CsgProgram, threads_change_no_byte) {
  const std::string one = file("one.nef"), four = file("four.nef");
  EXPECT_EQ(run({"solid", "csg", kBracket, "-o", one}).code, 0);
  EXPECT_EQ(run({"solid", "csg", kBracket, "--threads", "4", "-o", four}).code, 0);
  EXPECT_EQ(read_file(one), read_file(four));
}

const std::string kColored =
    "color([1, 0, 0, 1]) { difference() { cube(size = [4, 4, 4]); color([0, 0, 1, 1])\n"
    "{ multmatrix([[1, 0, 0, 2], [0, 1, 0, 2], [0, 0, 1, 2], [0, 0, 0, 1]]) { cube(4); } } } }\n"
    "color(\"lime\", alpha = 0.4) { multmatrix([[1, 0, 0, 9], [0, 1, 0, 0], [0, 0, 1, 0],\n"
    "[0, 0, 0, 1]]) { sphere(r = 1, $fn = 8); } }\n";

TEST_F(CsgProgram, writes_colours_that_every_format_reads_again) {
  const std::string model = holding(kColored, "m.csg");
  for (const std::string format : {"obj", "ply", "off", "glb", "3mf"}) {
    SCOPED_TRACE(format);
    const std::string out = file("m." + format);
    const RunResult made = run({"solid", "csg", model, "-o", out});
    if (made.err.find("libzip") != std::string::npos) continue;  // Built without 3MF.
    ASSERT_EQ(made.code, 0) << made.err;
    EXPECT_EQ(made.err, "");
    // A model that imports the file has its colours.
    const std::string again = holding("import(file = \"m." + format + "\");", "again.csg");
    const RunResult read = run({"solid", "csg", again, "-o", file("again.off")});
    ASSERT_EQ(read.code, 0) << read.err;
    const std::string text = read_file(file("again.off"));
    EXPECT_NE(text.find(" 255 0 0"), std::string::npos) << text;
    EXPECT_NE(text.find(" 0 255 0 102"), std::string::npos) << text;
    EXPECT_EQ(text.find(" 0 0 255"), std::string::npos) << text;
  }
}

TEST_F(CsgProgram, colours_can_be_left_out) {
  const std::string model = holding(kColored, "m.csg");
  const std::string plain = file("plain.off"), ids = file("ids.off");
  EXPECT_EQ(run({"solid", "csg", model, "--keep", "none", "-o", plain}).code, 0);
  EXPECT_EQ(run({"solid", "csg", model, "--keep", "ids", "-o", ids}).code, 0);
  EXPECT_EQ(read_file(plain), read_file(ids));
  EXPECT_EQ(read_file(plain).find("255"), std::string::npos);
}

TEST_F(CsgProgram, notes_name_colours_that_are_lost) {
  const std::string hull = holding("hull() { color(\"red\") { cube(); } }", "h.csg");
  const RunResult made = run({"solid", "csg", hull, "-o", file("h.off")});
  EXPECT_EQ(made.code, 0);
  EXPECT_NE(made.err.find("1:1: hull: the colours of its children are left out"), std::string::npos)
      << made.err;
}

TEST_F(CsgProgram, explains_the_tree) {
  const RunResult result = run({"solid", "csg", kBracket, "--explain", "-o", file("a.off")});
  EXPECT_EQ(result.code, 0);
  EXPECT_NE(result.err.find("seconds   cells  node\n"), std::string::npos) << result.err;
  EXPECT_NE(result.err.find("  hull at line 10\n"), std::string::npos) << result.err;
  EXPECT_NE(result.err.find("union at line 3, together with the node above\n"), std::string::npos)
      << result.err;
  EXPECT_NE(result.err.find("cylinder at line 13\n"), std::string::npos) << result.err;
  EXPECT_EQ(result.err.find("not needed"), std::string::npos) << result.err;
}

TEST_F(CsgProgram, tells_sets_of_plane_and_space_apart) {
  expect_refusal(run({"solid", "csg", kGasket}), kGasket, "use plumb plane csg");
  expect_refusal(run({"plane", "csg", kBracket}), kBracket, "use plumb solid csg");
  const RunResult plane = run({"plane", "csg", kGasket, "--json"});
  EXPECT_EQ(plane.code, 0) << plane.err;
  EXPECT_EQ(Json::parse(plane.out)["bounded"], true);
}

TEST_F(CsgProgram, imports_only_from_below_the_model) {
  const std::string model = holding(
      "import(file = \"" + fs::absolute("corpus/csg/pyramid.off").string() + "\");", "m.csg");
  expect_refusal(run({"solid", "csg", model}), model + ":1:1", "does not lie in the folder");
  EXPECT_EQ(exact_volume({"solid", "csg", model, "--anywhere", "--json"}), "1");
}

TEST_F(CsgProgram, refuses_with_the_place_and_writes_nothing) {
  const std::string out = file("out.off");
  const std::string text =
      holding("cube();\ntext(text = \"x\", direction = \"up\");\n", "text.csg");
  expect_refusal(run({"solid", "csg", text, "-o", out}), text + ":2:1", "the direction of text()");
  const std::string open =
      holding("union() {\n polyhedron(points = [[0,0,0],[1,0,0],[0,1,0]], faces = [[0,1,2]]);\n}\n",
              "open.csg");
  expect_refusal(run({"solid", "csg", open, "-o", out}), open + ":2:2", "polyhedron: ");
  const std::string huge = holding(
      "cube(size = [1e308, 1e308, 1e308], center = true);\n"
      "multmatrix([[1e308,0,0,0],[0,1,0,0],[0,0,1,0],[0,0,0,1]]) "
      "{ cube(); multmatrix([[1e308,0,0,0],[0,1,0,0],[0,0,1,0],"
      "[0,0,0,1]]) { cube(); } }\n",
      "huge.csg");
  const RunResult beyond = run({"solid", "csg", huge, "-o", out});
  EXPECT_EQ(beyond.code, 2) << beyond.err;
  EXPECT_FALSE(fs::exists(out));
}

/// Sets PATH for the programs that a test runs.
class SearchPath {
 public:
  explicit SearchPath(const std::string& path) : before_(std::getenv("PATH")) {
    setenv("PATH", path.c_str(), 1);
  }
  ~SearchPath() { setenv("PATH", before_.c_str(), 1); }

 private:
  std::string before_;
};

/// A script stands for openscad: it writes its model as it is, or fails.
TEST_F(CsgProgram, reads_programs_through_openscad) {
  const std::string model = holding("cube(size = [1, 2, 3]);", "model.scad");
  {
    const SearchPath nothing(file("none"));
    expect_refusal(run({"solid", "csg", model}), model, "needs the program openscad");
  }
  const std::string script = holding(
      "#!/bin/sh\n[ \"$1 $2 $3\" = \"-o - --export-format=csg\" ] || exit 3\n"
      "grep -q sphere \"$4\" && exit 1\nexec cat \"$4\"\n",
      "openscad");
  fs::permissions(script, fs::perms::owner_all);
  const SearchPath found(file("") + ":/usr/bin:/bin");
  EXPECT_EQ(exact_volume({"solid", "csg", model, "--json"}), "6");
  const std::string bad = holding("sphere(", "bad.scad");
  expect_refusal(run({"solid", "csg", bad}), bad, "openscad cannot read this model");
  const std::string refused = holding("cube();\nfrob();", "refused.scad");
  expect_refusal(run({"solid", "csg", refused}), refused + " (as .csg):2:1", "frob");
}

/// Tests of what remains of openscad once the program has ended. A script stands for it: it starts
/// a process in the background that writes a file again and again.
class OpenscadThatNeverEnds : public CsgProgram {
 protected:
  /// Runs the program on a model, with a script that ends with `rest`.
  RunResult run_with(
      const std::string& rest, const Words& options,
      const std::function<void(pid_t)>& meanwhile = [](pid_t) {}) {
    const std::string script = holding(
        "#!/bin/sh\n(while :; do echo x >>'" + beats() + "'; sleep 0.02; done) >&2 &\n" + rest,
        "openscad");
    fs::permissions(script, fs::perms::owner_all);
    const SearchPath found(file("") + ":/usr/bin:/bin");
    Words words{"solid", "csg", holding("cube();", "m.scad"), "-o", file("out.off")};
    words.insert(words.end(), options.begin(), options.end());
    RunOptions during;
    during.meanwhile = meanwhile;
    return run(words, during);
  }
  std::string beats() const { return file("beats"); }
  void wait_for_beats() const {
    while (!fs::exists(beats())) ::usleep(1000);
  }
  void expect_nothing_runs() const {
    ASSERT_TRUE(fs::exists(beats()));
    const auto before = fs::file_size(beats());
    ::usleep(300'000);
    EXPECT_EQ(fs::file_size(beats()), before);
  }
  void expect_nothing_remains() const {
    expect_nothing_runs();
    EXPECT_FALSE(fs::exists(file("out.off")));
  }
};

const Words kHalfASecond{"--limit-seconds", "0.5"};

TEST_F(OpenscadThatNeverEnds, ends_at_the_time_limit) {
  // It waits; it has closed its output; it never stops writing; it ignores what asks it to end.
  for (const std::string rest :
       {"wait", "exec >&-\nwait", "exec yes", "trap '' TERM INT HUP PIPE\nwait\nwait"}) {
    SCOPED_TRACE(rest);
    const RunResult result = run_with(rest, kHalfASecond);
    EXPECT_EQ(result.code, 3) << result.err;
    EXPECT_NE(result.err.find("--limit-seconds"), std::string::npos) << result.err;
    expect_nothing_remains();
  }
}

TEST_F(OpenscadThatNeverEnds, ends_at_the_memory_limit) {
  const RunResult result = run_with("exec yes", {"--limit-memory", "20", "--limit-seconds", "60"});
  EXPECT_EQ(result.code, 3) << result.err;
  EXPECT_NE(result.err.find("--limit-memory"), std::string::npos) << result.err;
  expect_nothing_remains();
}

/// What openscad started ends even if openscad itself has ended before.
TEST_F(OpenscadThatNeverEnds, ends_with_an_error_and_with_an_answer) {
  const std::string once_started = "while [ ! -e '" + beats() + "' ]; do sleep 0.01; done\n";
  const RunResult failed = run_with(once_started + "exit 1", {});
  EXPECT_EQ(failed.code, 2) << failed.err;
  expect_nothing_remains();
  const RunResult done = run_with(once_started + "echo 'cube();'", {});
  EXPECT_EQ(done.code, 0) << done.err;
  expect_nothing_runs();
  EXPECT_TRUE(fs::exists(file("out.off")));
}

TEST_F(OpenscadThatNeverEnds, ends_with_a_signal) {
  struct Case {
    int signal;
    int code;
  };
  // A stop is taken at a checkpoint, and a terminal that is closed ends the program at once.
  for (const auto& [signal, code] :
       {Case{SIGINT, 4}, {SIGTERM, 4}, {SIGHUP, -SIGHUP}, {SIGQUIT, -SIGQUIT}}) {
    SCOPED_TRACE(signal);
    fs::remove(beats());
    const RunResult result = run_with("wait", {}, [&, sent = signal](pid_t program) {
      wait_for_beats();
      ::kill(program, sent);
    });
    EXPECT_EQ(result.code, code) << result.err;
    expect_nothing_remains();
  }
}

/// The second signal does not wait for a checkpoint. The program is stopped until both are there,
/// and both are handled before it goes on.
TEST_F(OpenscadThatNeverEnds, ends_with_two_signals) {
  const RunResult result = run_with("wait", {}, [&](pid_t program) {
    wait_for_beats();
    ::kill(program, SIGSTOP);
    ::kill(program, SIGINT);
    ::kill(program, SIGTERM);
    ::kill(program, SIGCONT);
  });
  EXPECT_EQ(result.code, 4) << result.err;
  EXPECT_EQ(result.err, "");
  expect_nothing_remains();
}

}  // namespace
}  // namespace plumb::testing::csg_command_test
