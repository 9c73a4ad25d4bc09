// The program from outside: exit codes, what goes to which stream, and which files are left.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <csignal>
#include <nlohmann/json.hpp>
#include <regex>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

#include "../io/hostile_maps.h"
#include "json_schema.h"
#include "refusal.h"
#include "run_program.h"

namespace plumb::testing::program_test {
namespace {

using Words = std::vector<std::string>;

const std::string kValid = "corpus/maps/us-states.clean.map";
const std::string kDefective = "corpus/maps/us-counties.map";

// Bounds on time and memory are promises of the program, not of a sanitizer's checks, shadow and
// quarantine: those cost several times as much, and more on a slow machine.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool kMeasures = false;
#elif defined(__has_feature)
constexpr bool kMeasures = !__has_feature(address_sanitizer) && !__has_feature(thread_sanitizer);
#else
constexpr bool kMeasures = true;
#endif

std::string first_line(const std::string& text) { return text.substr(0, text.find('\n')); }

TEST(Program, prints_its_version) {
  const RunResult result = run({"--version"});
  EXPECT_EQ(result.code, 0);
  EXPECT_TRUE(result.out.starts_with("plumb ")) << result.out;
  EXPECT_EQ(std::count(result.out.begin(), result.out.end(), '\n'), 1);
  EXPECT_EQ(std::count(result.out.begin(), result.out.end(), '.'), 2);
}

TEST(Program, suggests_what_was_meant) {
  const std::vector<std::pair<Words, std::string>> typos{
      {{"slef-test"}, "'self-test'"},
      {{"map", "chekc", "x"}, "'map check'"},
      {{"check", "x"}, "'map check'"},
      {{"dmeo"}, "'demo'"},
      {{"slid"}, "'solid'"},
      {{"--json", "map", "check", "x"}, "after the command"},
      {{"map", "check", "--jsno", "x"}, "'--json'"},
      {{"map", "check", "--max-defect", "3", "x"}, "--max-defects"},
      {{"solid", "unoin", "x"}, "'solid union'"},
      {{"slid", "union", "x"}, "'solid union'"},
      {{"convex", "decompose", "x", "--mehtod", "cuts"}, "'--method'"},
      {{"completion", "bsh"}, "'completion bash'"},
  };
  for (const auto& [arguments, guess] : typos) {
    const RunResult result = run(arguments);
    expect_refusal(result, "plumb: ", guess);
  }
}

TEST(Program, suggests_nothing_that_is_far_off) {
  for (const Words& arguments : std::vector<Words>{{"frobnicate"},
                                                   {"frobnicate", "x"},
                                                   {"plane", "frobnicate"},
                                                   {"map", "check", "--frobnicate", "x"}}) {
    const RunResult result = run(arguments);
    expect_refusal(result, "plumb: ", "");
    EXPECT_FALSE(contains(result.err, "did you mean")) << result.err;
  }
}

TEST(Program, helps_however_it_is_asked) {
  const std::string text = run({"--help"}).out;
  EXPECT_TRUE(contains(text, "Usage: plumb COMMAND")) << text;
  for (const char* word : {"-h", "help"}) EXPECT_EQ(run({word}).out, text) << word;
  EXPECT_EQ(run({"map", "check", "-h"}).out, run({"map", "check", "--help"}).out);
  expect_refusal(run({std::string(10000, 'x')}), "plumb: ", "xxx");
}

TEST(Program, refuses_wrong_usage) {
  const std::vector<Words> wrong{
      {},
      {"map"},
      {"qwertyuiop"},
      {"map", "check"},
      {"map", "check", kValid, kValid},
      {"map", "check", kValid, "--outer", "maybe"},
      {"map", "check", kValid, "--max-defects", "many"},
      {"map", "check", kValid, "--max-defects", "-1"},
      {"map", "check", kValid, "--threads", "0"},
      {"map", "check", kValid, "--limit-seconds", "-1"},
      {"map", "check", kValid, "--limit-seconds", "nan"},
      {"map", "check", kValid, "--limit-memory", "0"},
      {"map", "check", kValid, "--progress", "--quiet"},
      {"map", "check", kValid, "-o", "-"},
      {"map", "check", kValid, "--format", "pdf"},
      {"map", "check", kValid, "--json", "--svg", "-"},
      {"map", "check", kValid, "--json", "--format", "text"},
      {"map", "check", kValid, "--svg"},
      {"map", "check", kValid, "-o", ""},
  };
  for (const Words& arguments : wrong) {
    SCOPED_TRACE(::testing::PrintToString(arguments));
    expect_refusal(run(arguments), "plumb: ", "");
  }
  expect_refusal(run({"map", "check", kValid, "-o", "out.pdf"}), "out.pdf: ", "'.pdf'");
}

TEST(MapCheckProgram, lists_a_valid_map) {
  const RunResult result = run({"map", "check", kValid});
  EXPECT_EQ(result.code, 0);
  const std::string counts = first_line(result.out);
  EXPECT_EQ(std::count(counts.begin(), counts.end(), ' '), 2) << counts;
}

TEST(MapCheckProgram, a_valid_map_is_valid_by_every_rule_for_its_outside) {
  for (const char* rule : {"listed", "infer", "ignore"}) {
    EXPECT_EQ(run({"map", "check", kValid, "--outer", rule}).code, 0) << rule;
  }
}

// Control characters of eight bits begin commands for a terminal, too.
TEST(Program, prints_no_control_characters_of_names) {
  for (const std::string control : {"\x1b[m", "\xc2\x9bm", "\x9bm", "\x7f", "\xc2"}) {
    const RunResult result = run({"map", "check", "none" + control + ".map"});
    EXPECT_EQ(result.code, 2);
    EXPECT_EQ(result.err.find(control), std::string::npos) << result.err;
    EXPECT_TRUE(result.err.starts_with("none?")) << result.err;
  }
  const std::string name = "caf\xc3\xa9\xe2\x82\xac\xf0\x9f\x98\x80.map";
  EXPECT_TRUE(run({"map", "check", name}).err.starts_with(name));
}

// Not on a terminal: a line for each phase, and nothing that only a terminal understands.
TEST(MapCheckProgram, tells_its_phases_in_a_file) {
  const RunResult result = run({"map", "check", kValid, "--progress"});
  EXPECT_EQ(result.code, 0);
  EXPECT_EQ(result.out, run({"map", "check", kValid}).out);
  EXPECT_FALSE(result.err.empty());
  EXPECT_EQ(result.err.find_first_of("\r\x1b"), std::string::npos) << result.err;
}

TEST(MapCheckProgram, says_what_is_wrong_with_a_defective_map) {
  const RunResult result = run({"map", "check", kDefective});
  EXPECT_EQ(result.code, 1);
  EXPECT_EQ(first_line(result.out), "not a planar subdivision");
}

TEST(MapCheckProgram, prints_one_json_object) {
  for (const auto& [file, code] : {std::pair{kValid, 0}, std::pair{kDefective, 1}}) {
    const RunResult result = run({"map", "check", file, "--json"});
    EXPECT_EQ(result.code, code);
    const auto json = nlohmann::json::parse(result.out);
    EXPECT_EQ(json["verdict"] == "valid", code == 0);
  }
}

TEST(MapCheckProgram, what_is_asked_twice_is_said_once) {
  EXPECT_EQ(run({"map", "check", kValid, "--json", "--format", "json", "-o", "-"}).out,
            run({"map", "check", kValid, "--json"}).out);
}

TEST(MapCheckProgram, keeps_counts_complete_whatever_is_described) {
  const auto all = nlohmann::json::parse(run({"map", "check", kDefective, "--json"}).out);
  const RunResult few = run({"map", "check", kDefective, "--json", "--max-defects", "3"});
  const auto json = nlohmann::json::parse(few.out);
  EXPECT_EQ(json["counts"], all["counts"]);
  EXPECT_EQ(json["defects"].size(), 3U);
  EXPECT_TRUE(contains(few.err, "3 of")) << few.err;
}

TEST(MapCheckProgram, reads_standard_input) {
  RunOptions options;
  options.in = kDefective;
  const RunResult piped = run({"map", "check", "-"}, options);
  EXPECT_EQ(piped.code, 1);
  EXPECT_EQ(piped.out, run({"map", "check", kDefective}).out);
}

TEST(MapCheckProgram, writes_what_is_asked_where_it_is_asked) {
  const ScratchDirectory scratch;
  const auto path = [&](const char* name) { return (scratch / name).string(); };
  const RunResult result = run({"map", "check", kDefective, "-o", path("r.json"), "--svg",
                                path("r.svg"), "--geojson", path("r.geojson")});
  EXPECT_EQ(result.code, 1);
  EXPECT_EQ(result.out, "");
  EXPECT_EQ(scratch.files(), (Words{"r.geojson", "r.json", "r.svg"}));
  EXPECT_EQ(read_file(path("r.json")), run({"map", "check", kDefective, "--json"}).out);
  EXPECT_EQ(nlohmann::json::parse(read_file(path("r.geojson")))["type"], "FeatureCollection");
  const RunResult svg = run({"map", "check", kDefective, "-o", "-", "--format", "svg"});
  EXPECT_EQ(svg.out, read_file(path("r.svg")));
}

TEST(MapCheckProgram, refuses_hostile_maps_and_leaves_no_file) {
  const ScratchDirectory scratch;
  const std::string map = (scratch / "bad.map").string();
  for (const HostileText& hostile : hostile_maps()) {
    SCOPED_TRACE(hostile.name);
    write_file(map, hostile.bytes);
    const RunResult result =
        run({"map", "check", map, "--json", "--svg", (scratch / "out.svg").string(), "--geojson",
             (scratch / "out.geojson").string()});
    const std::string place =
        map + ":" + std::to_string(hostile.line) + ":" + std::to_string(hostile.column) + ": ";
    expect_refusal(result, place, hostile.message);
    EXPECT_EQ(scratch.files(), Words{"bad.map"});
  }
}

TEST(MapCheckProgram, keeps_old_outputs_when_it_fails) {
  const ScratchDirectory scratch;
  write_file(scratch / "out.svg", "old");
  const RunResult result =
      run({"map", "check", "no/such.map", "--svg", (scratch / "out.svg").string()});
  expect_refusal(result, "no/such.map: ", "No such file");
  EXPECT_EQ(read_file(scratch / "out.svg"), "old");
}

TEST(MapCheckProgram, names_paths_it_cannot_read_or_write) {
  const ScratchDirectory scratch;
  const std::string other = (scratch / "other.geojson").string();
  const auto with_svg = [&](const std::string& svg) {
    return run({"map", "check", kValid, "--svg", svg, "--geojson", other});
  };
  expect_refusal(run({"map", "check", "corpus"}), "corpus: ", "directory");
  expect_refusal(with_svg("/dev/full"), "/dev/full: ", "No space left");
  expect_refusal(with_svg((scratch / "no/out.svg").string()), (scratch / "no/out.svg").string(),
                 "No such file");
  expect_refusal(with_svg((scratch / "").string()), (scratch / "").string(), "directory");
  expect_refusal(with_svg("/proc/out.svg"), "/proc/out.svg: ", "");
  EXPECT_EQ(scratch.files(), Words{});
}

TEST(MapCheckProgram, reports_a_full_disk_behind_standard_output) {
  const ScratchDirectory scratch;
  RunOptions options;
  options.out = "/dev/full";
  const RunResult result =
      run({"map", "check", kValid, "--svg", (scratch / "out.svg").string()}, options);
  EXPECT_EQ(result.code, 2);
  EXPECT_EQ(result.err, "stdout: No space left on device\n");
  EXPECT_EQ(scratch.files(), Words{});
}

TEST(MapCheckProgram, ends_quietly_when_the_pipe_is_closed) {
  const ScratchDirectory scratch;
  const std::string pipe = (scratch / "pipe").string();
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  RunOptions options;
  options.out = pipe;
  options.meanwhile = [&](pid_t) { ::close(::open(pipe.c_str(), O_RDONLY)); };
  const RunResult result =
      run({"map", "check", kValid, "--svg", (scratch / "out.svg").string()}, options);
  EXPECT_EQ(result.code, 141);
  EXPECT_EQ(result.err, "");
  EXPECT_EQ(scratch.files(), Words{"pipe"});
}

TEST(MapCheckProgram, stops_at_its_limits) {
  const ScratchDirectory scratch;
  const std::string svg = (scratch / "out.svg").string();
  const std::vector<Words> limits{{"--limit-memory", "1"}, {"--limit-seconds", "0.000001"}};
  for (const Words& limit : limits) {
    Words arguments{"map", "check", kDefective, "--json", "--svg", svg};
    arguments.insert(arguments.end(), limit.begin(), limit.end());
    const RunResult result = run(arguments);
    EXPECT_EQ(result.code, 3) << limit[0];
    EXPECT_EQ(result.out, "");
    EXPECT_TRUE(contains(result.err, limit[0])) << result.err;
    EXPECT_EQ(scratch.files(), Words{});
  }
}

/// Until the program has opened its output beside a file there, or has ended.
void wait_for_output(const ScratchDirectory& scratch, pid_t child) {
  siginfo_t ended{};
  while (scratch.files().size() < 2 && ended.si_pid == 0) {
    std::this_thread::yield();
    ::waitid(P_PID, static_cast<id_t>(child), &ended, WEXITED | WNOHANG | WNOWAIT);
  }
}

TEST(MapCheckProgram, is_cancelled_by_a_signal) {
  const ScratchDirectory scratch;
  const std::string pipe = (scratch / "pipe").string();
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  for (const int signal : {SIGINT, SIGTERM}) {
    RunOptions options;
    options.in = pipe;  // opened for both directions: never ends, so the program waits
    options.meanwhile = [&](pid_t child) {
      wait_for_output(scratch, child);
      ::kill(child, signal);
    };
    const RunResult result =
        run({"map", "check", "-", "--svg", (scratch / "out.svg").string()}, options);
    EXPECT_EQ(result.code, 4);
    EXPECT_EQ(result.out, "");
    EXPECT_EQ(scratch.files(), Words{"pipe"});
  }
}

/// Takes minutes.
const Words kLongJob{"convex", "minkowski", "corpus/solids/bunny.off", "corpus/solids/ball.off"};

TEST(Signals, end_a_long_job_and_leave_nothing) {
  const ScratchDirectory scratch;
  write_file(scratch / "sum.off", "old");
  for (const int signal : {SIGINT, SIGTERM}) {
    std::chrono::steady_clock::time_point sent;
    RunOptions options;
    options.meanwhile = [&](pid_t child) {
      wait_for_output(scratch, child);
      std::this_thread::sleep_for(std::chrono::milliseconds(300));
      sent = std::chrono::steady_clock::now();
      ::kill(child, signal);
    };
    Words arguments = kLongJob;
    arguments.insert(arguments.end(), {"-o", (scratch / "sum.off").string()});
    const RunResult result = run(arguments, options);
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - sent;
    EXPECT_EQ(result.code, 4) << result.err;
    EXPECT_EQ(result.out, "");
    EXPECT_EQ(scratch.files(), Words{"sum.off"});
    EXPECT_EQ(read_file(scratch / "sum.off"), "old");
    EXPECT_TRUE(took.count() < 2 || !kMeasures) << took.count();
  }
}

/// What a terminal that is standard error gets to see.
std::string seen_on_terminal(const Words& arguments) {
  const int terminal = ::posix_openpt(O_RDWR | O_NOCTTY);
  if (terminal < 0 || ::grantpt(terminal) != 0 || ::unlockpt(terminal) != 0) return "no terminal";
  const std::string name = ::ptsname(terminal);
  const int keep_open = ::open(name.c_str(), O_RDWR | O_NOCTTY);
  const pid_t child = ::fork();
  if (child == 0) become_program(arguments, "/dev/null", "/dev/null", name);
  std::string seen;
  std::thread reader([&] {
    char bytes[4096];
    for (ssize_t n = 0; (n = ::read(terminal, bytes, sizeof bytes)) > 0;) {
      seen.append(bytes, static_cast<std::size_t>(n));
    }
  });
  int status = 0;
  ::waitpid(child, &status, 0);
  ::close(keep_open);  // the last one: the reader ends
  reader.join();
  ::close(terminal);
  return seen;
}

/// What one line of the bar says.
struct Shown {
  int percent = 0;
  bool tells_time_left = false;
};

/// The lines of the bar, each checked for itself.
std::vector<Shown> bar_lines(const std::string& seen) {
  const std::regex line("[A-Za-z -]+\\[#*\\.*\\] +([0-9]+)%(  [0-9]+ s (left|so far))?");
  std::vector<Shown> lines;
  for (std::size_t at = 0; (at = seen.find("\r\x1b[K", at)) != seen.npos;) {
    at += 4;
    const std::string text = seen.substr(at, seen.find('\r', at) - at);
    std::smatch match;
    if (!std::regex_match(text, match, line)) continue;  // a message
    EXPECT_LT(text.size(), 80U) << text;
    lines.push_back({std::stoi(match[1]), match[3] == "left"});
  }
  return lines;
}

/// Corners at whole numbers, with `digits` behind each.
void write_grid_map(const std::string& file, std::uint32_t n, const std::string& digits = "") {
  std::string text = std::to_string((n + 1) * (n + 1)) + ' ' + std::to_string(n * n) + '\n';
  for (std::uint32_t i = 0; i < (n + 1) * (n + 1); ++i) {
    text += std::to_string(i % (n + 1)) + digits + ' ';
    text += std::to_string(i / (n + 1)) + digits + '\n';
  }
  for (std::uint32_t i = 0; i < n * n; ++i) {
    const std::uint32_t v = i / n * (n + 1) + i % n + 1;
    for (const std::uint32_t w : {v, v + 1, v + n + 2, v + n + 1}) text += std::to_string(w) + ' ';
    text += '\n';
  }
  write_file(file, text);
}

void write_star(const std::string& file, std::uint32_t corners) {
  std::string text = "POLYGON ((";
  for (std::uint32_t i = 0; i <= corners; ++i) {
    const double angle = 6.283185307179586 * (i % corners) / corners;
    const double radius = i % 2 == 0 ? 1000 : 1500;
    text += (i > 0 ? ", " : "") + std::to_string(radius * std::cos(angle)) + ' ' +
            std::to_string(radius * std::sin(angle));
  }
  write_file(file, text + "))\n");
}

/// Writes five copies of a solid, an OFF file of triangles, that do not meet.
void write_copies(const std::string& file, const std::string& solid) {
  constexpr std::size_t kCopies = 5;
  std::istringstream in(read_file(solid));
  std::string keyword;
  std::size_t vertices = 0, faces = 0, edges = 0;
  in >> keyword >> vertices >> faces >> edges;
  std::vector<std::array<double, 3>> points(vertices);
  for (auto& p : points) in >> p[0] >> p[1] >> p[2];
  std::vector<std::array<std::size_t, 4>> triangles(faces);
  for (auto& t : triangles) in >> t[0] >> t[1] >> t[2] >> t[3];
  std::ostringstream out;
  out << "OFF\n" << kCopies * vertices << ' ' << kCopies * faces << " 0\n";
  for (std::size_t i = 0; i < kCopies; ++i) {
    const double shift = 100 * static_cast<double>(i);
    for (const auto& p : points) out << p[0] + shift << ' ' << p[1] << ' ' << p[2] << '\n';
  }
  for (std::size_t i = 0; i < kCopies; ++i) {
    const std::size_t first = i * vertices;
    for (const auto& t : triangles) {
      out << "3 " << t[1] + first << ' ' << t[2] + first << ' ' << t[3] + first << '\n';
    }
  }
  write_file(file, out.str());
}

/// Of every kind of command one that takes longer than a second, from which on the bar tells time;
/// its inputs are written into a directory.
std::vector<Words> long_jobs(const ScratchDirectory& scratch) {
  const std::string map = (scratch / "grid.map").string(), star = (scratch / "star.wkt").string();
  const std::string coarse = (scratch / "coarse.map").string();
  const std::string shifted = (scratch / "shifted.map").string();
  write_grid_map(map, 1500);
  write_grid_map(coarse, 300);
  write_grid_map(shifted, 300, ".5");
  write_star(star, 2'000'000);
  const std::string solids = (scratch / "solids.off").string();
  write_copies(solids, "corpus/solids/bunny.off");
  return {{"map", "check", map, "--outer", "infer"},
          {"plane", "difference", star, "corpus/plane/frame.geojson", "--format", "nef2"},
          {"plane", "info", star},
          {"map", "overlay", coarse, shifted, "--infer-outer"},
          {"audit", star},
          {"view", star, "--format", "svg"},
          {"convex", "decompose", solids, "-o", (scratch / "pieces").string()},
          kLongJob};
}

TEST(Progress, tells_percentage_and_time_left_on_a_terminal) {
  const ScratchDirectory scratch;
  for (Words arguments : long_jobs(scratch)) {
    SCOPED_TRACE(::testing::PrintToString(arguments));
    arguments.insert(arguments.end(), {"--limit-seconds", "3"});
    const std::string seen = seen_on_terminal(arguments);
    const std::vector<Shown> lines = bar_lines(seen);
    EXPECT_GT(lines.size(), 5U) << seen.substr(0, 400);
    EXPECT_TRUE(std::ranges::is_sorted(lines, {}, &Shown::percent)) << seen;
    EXPECT_TRUE(std::ranges::any_of(lines, &Shown::tells_time_left)) << seen;
    EXPECT_EQ(seen.find('[', seen.rfind("\r\x1b[K") + 4), seen.npos)
        << "the bar is wiped at the end";
  }
}

TEST(Progress, goes_from_little_to_nearly_all) {
  const ScratchDirectory scratch;
  const std::string star = (scratch / "star.wkt").string();
  write_star(star, kMeasures ? 1'500'000 : 300'000);
  // When it is drawn depends on the clock: on a busy machine the program may not run for a while,
  // at its end, too.
  int first = 100, last = 0;
  for (int run = 0; run < 5 && (first >= 30 || (last <= 70 && kMeasures)); ++run) {
    const std::vector<Shown> lines = bar_lines(seen_on_terminal({"plane", "info", star}));
    ASSERT_GT(lines.size(), 5U);
    first = lines.front().percent;
    last = lines.back().percent;
  }
  EXPECT_LT(first, 30);
  // The stages are weighted as an optimised program takes time for them.
  EXPECT_TRUE(last > 70 || !kMeasures) << last;
}

TEST(Progress, is_not_shown_if_unwanted) {
  Words arguments = kLongJob;
  arguments.insert(arguments.end(), {"--limit-seconds", "0.5", "--quiet"});
  EXPECT_EQ(seen_on_terminal(arguments).find('['), std::string::npos);
}

TEST(Json, has_errors_as_one_object_on_standard_error) {
  const ScratchDirectory scratch;
  const std::string bad = (scratch / "a \"b\".off").string();
  write_file(bad, "OFF\n1 0 0\n0 0 x\n");
  struct Case {
    Words arguments;
    int exit_code;
    std::string code, file;
    int line, column;  // 0: null
  };
  const std::vector<Case> cases{
      {{"solid", "info", bad, "--json"}, 2, "syntax", bad, 3, 5},
      {{"solid", "info", "no-such-file", "--json"}, 2, "cannot-open", "no-such-file", 0, 0},
      {{"solid", "info", "--json"}, 2, "usage", "", 0, 0},
      {{"map", "check", kDefective, "--json", "--limit-memory", "1"},
       3,
       "resource-limit",
       kDefective,
       1,
       11},
      {{"map", "check", kDefective, "--json", "--limit-seconds", "1e-6"},
       3,
       "resource-limit",
       "",
       0,
       0},
      {{"solid", "union", "corpus/solids/l-block.off", "corpus/solids/l-block.off", "--json", "-o",
        (scratch / "no/out.off").string()},
       2,
       "cannot-write",
       (scratch / "no/out.off").string(),
       0,
       0},
  };
  for (const Case& c : cases) {
    SCOPED_TRACE(::testing::PrintToString(c.arguments));
    const RunResult result = run(c.arguments);
    EXPECT_EQ(result.code, c.exit_code);
    EXPECT_EQ(result.out, "");
    const nlohmann::json error = nlohmann::json::parse(result.err).at("error");
    EXPECT_EQ(error.at("code"), c.code) << error;
    EXPECT_FALSE(error.at("message").get<std::string>().empty());
    const nlohmann::json file = c.file.empty() ? nlohmann::json() : nlohmann::json(c.file);
    EXPECT_EQ(error.at("file"), file) << error;
    for (const auto& [name, value] : {std::pair("line", c.line), std::pair("column", c.column)}) {
      EXPECT_EQ(error.at(name), value == 0 ? nlohmann::json() : nlohmann::json(value)) << error;
    }
  }
}

/// Tetrahedra that cross each other, with coordinates that are fractions of `digits` digits.
void write_number_bomb(const std::string& file, std::size_t digits, int count,
                       std::uint64_t seed = 7) {
  std::ostringstream out;
  out << "OFF\n" << 4 * count << ' ' << 4 * count << " 0\n";
  std::uint64_t state = seed;
  const auto number = [&](int digit) {
    std::string above(1, static_cast<char>('1' + digit)), below = "1";
    for (std::size_t i = 1; i < digits; ++i) {
      state = state * 6364136223846793005U + 1442695040888963407U;
      above += static_cast<char>('0' + (state >> 40U) % 10);
      below += static_cast<char>('0' + (state >> 50U) % 10);
    }
    return above + "/" + below;
  };
  for (int i = 0; i < 4 * count; ++i) {
    for (int axis = 1; axis <= 3; ++axis) out << number(i % 4 == axis ? 7 : 0) << ' ';
    out << '\n';
  }
  for (int i = 0; i < 4 * count; i += 4) {
    out << "3 " << i << ' ' << i + 2 << ' ' << i + 1 << "\n3 " << i << ' ' << i + 1 << ' ' << i + 3
        << "\n3 " << i << ' ' << i + 3 << ' ' << i + 2 << "\n3 " << i + 1 << ' ' << i + 2 << ' '
        << i + 3 << '\n';
  }
  write_file(file, out.str());
}

TEST(Limits, hold_for_numbers_of_thousands_of_digits) {
  const ScratchDirectory scratch;
  const std::string bomb = (scratch / "bomb.off").string();
  write_number_bomb(bomb, 9000, 1);
  const RunResult refused = run({"solid", "info", bomb});
  EXPECT_EQ(refused.code, 2);
  EXPECT_TRUE(contains(refused.err, "--digits")) << refused.err;
  write_number_bomb(bomb, 2040, 10);
  for (const double limit : {0.3, 0.7, 1.5}) {
    const RunResult result = run({"solid", "info", bomb, "--limit-seconds", std::to_string(limit)});
    EXPECT_EQ(result.code, 3);
    EXPECT_TRUE(contains(result.err, "raise --limit-seconds")) << result.err;
    EXPECT_TRUE(!kMeasures || result.user_seconds < limit + 0.15) << result.user_seconds;
  }
}

/// Corners of results have many times the digits of those of the operands.
TEST(ExactOff, holds_results_of_thousands_of_digits) {
  const ScratchDirectory scratch;
  const std::string a = (scratch / "a.off").string(), b = (scratch / "b.off").string();
  const std::string off = (scratch / "c.off").string(), nef = (scratch / "c.nef").string();
  write_number_bomb(a, 300, 1, 7);
  write_number_bomb(b, 300, 1, 8);
  const Words both{"solid", "intersection", a, b, "-o"};
  Words to_off = both, to_nef = both;
  to_off.insert(to_off.end(), {off, "--format", "off-exact"});
  to_nef.push_back(nef);
  ASSERT_EQ(run(to_off).code, 0);
  ASSERT_EQ(run(to_nef).code, 0);
  const std::string text = read_file(off);
  std::size_t longest = 0;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find_first_of(" \n", at), text.size());
    longest = std::max(longest, end - at);
    at = end + 1;
  }
  EXPECT_GT(longest, 1200U);
  const RunResult same = run({"solid", "compare", off, nef});
  EXPECT_TRUE(same.out.starts_with("equal")) << same.out << same.err;
}

TEST(ExactOff, names_the_limit_of_fractions) {
  const ScratchDirectory scratch;
  const std::string off = (scratch / "long.off").string();
  write_file(off, "OFF\n1 0 0\n0 " + std::string(17000, '1') + "/3 0\n");
  const RunResult result = run({"solid", "info", off});
  EXPECT_EQ(result.code, 2);
  EXPECT_TRUE(contains(result.err, "at most 16384 digits are read")) << result.err;
}

TEST(Limits, bound_the_memory_of_the_whole_command) {
  const ScratchDirectory scratch;
  const std::string out = (scratch / "out.nef").string();
  const Words job{"solid", "union", "corpus/solids/bunny.off", "corpus/solids/bunny.off",
                  "-o",    out};
  const double base = run({"--version"}).megabytes;
  for (const int limit : {2, 8, 20}) {
    Words arguments = job;
    arguments.insert(arguments.end(), {"--limit-memory", std::to_string(limit)});
    const RunResult result = run(arguments);
    EXPECT_TRUE(result.code == 0 || result.code == 3) << result.code << result.err;
    EXPECT_EQ(scratch.files().size(), result.code == 0 ? 1U : 0U);
    fs::remove(out);
    // The libraries that a command needs are a part of its base.
    constexpr double kLibraries = 8;
    EXPECT_TRUE(!kMeasures || result.megabytes < base + kLibraries + 1.1 * limit)
        << limit << " MB: " << result.megabytes;
  }
}

/// The shares of phases that --timings prints: the name, CPU seconds, percent, three ratios.
TEST(Timings, name_phases_and_change_no_output) {
  const ScratchDirectory scratch;
  const std::string a = (scratch / "a.off").string(), b = (scratch / "b.off").string();
  ASSERT_EQ(run({"solid", "make", "sphere", "-o", a}).code, 0);
  ASSERT_EQ(run({"solid", "make", "torus", "-o", b}).code, 0);
  const Words words{"solid", "union", a, b, "--format", "off", "-o", "-"};
  const RunResult expected = run(words);
  for (const char* const threads : {"1", "2"}) {
    Words timed = words;
    timed.insert(timed.end(), {"--threads", threads, "--timings"});
    const RunResult result = run(timed);
    EXPECT_EQ(result.code, expected.code);
    EXPECT_EQ(result.out, expected.out);
    std::istringstream lines(result.err);
    std::string line;
    double whole = 0, sum = 0;
    std::vector<std::string> phases;
    while (std::getline(lines, line)) {
      if (line.size() != 76 || line.starts_with("phase ")) continue;
      const std::size_t depth = line.find_first_not_of(' ') / 2;
      phases.push_back(line.substr(2 * depth, line.find("  ", 2 * depth) - 2 * depth));
      std::istringstream numbers(line.substr(34));
      double seconds = -1, share = -1;
      std::array<double, 3> gain{};
      std::string percent;
      numbers >> seconds >> share >> percent >> gain[0] >> gain[1] >> gain[2];
      EXPECT_TRUE(share >= 0 && share <= 100 && percent == "%") << line;
      EXPECT_TRUE(1 <= gain[0] && gain[0] <= gain[1] && gain[1] <= gain[2]) << line;
      EXPECT_TRUE(gain[0] <= 2 && gain[1] <= 8 && gain[2] <= 16) << line;
      if (depth == 0) whole = seconds;
      if (depth == 1) sum += seconds;
      EXPECT_TRUE(share == 0 || threads != std::string("1")) << line;
    }
    for (const char* const phase : {"command", "reading", "Boolean", "writing"}) {
      EXPECT_EQ(std::count(phases.begin(), phases.end(), phase), 1) << result.err;
    }
    EXPECT_GT(whole, 0);
    EXPECT_LE(sum, whole + 0.0001 * static_cast<double>(phases.size())) << result.err;
  }
}

/// Threads that read at the same time need more memory; if there is too little, they take turns.
TEST(Limits, of_memory_stop_no_threads_that_one_would_not_stop) {
  const ScratchDirectory scratch;
  const std::string a = (scratch / "a.off").string(), b = (scratch / "b.off").string();
  const auto make = [](const std::string& file, const std::string& radius) {
    return run({"solid", "make", "torus", "--segments", "90", "--radius", radius, "-o", file}).code;
  };
  ASSERT_EQ(make(a, "1") + make(b, "1.1"), 0);
  const auto is_enough = [&](int megabytes, const std::string& threads) {
    const RunResult result =
        run({"solid", "union", a, b, "-o", (scratch / "out.nef").string(), "--threads", threads,
             "--limit-memory", std::to_string(megabytes)});
    EXPECT_TRUE(result.code == 0 || result.code == 3) << result.code << result.err;
    return result.code == 0;
  };
  int least = 4;
  while (least < 100 && !is_enough(least, "1")) ++least;
  EXPECT_GT(least, 8);
  for (const char* const threads : {"2", "4"}) {
    EXPECT_TRUE(is_enough(least + least / 10 + 1, threads)) << least << " MB, " << threads;
  }
}

/// Exact decimals expand beyond what the reader allows, one by one or all together.
int expected_code(const std::string& bomb, bool exact) {
  if (!exact) return 0;
  return bomb == "exact decimals"                               ? 3
         : bomb == "small exponents" || bomb == "long decimals" ? 2
                                                                : 0;
}

/// "2 s per MB of input and 10x the file plus 64 MB", on maps of one bomb repeated.
TEST(MapCheckProgram, bounds_time_and_memory_on_bombs) {
  const ScratchDirectory scratch;
  const std::string map = (scratch / "bomb.map").string();
  const std::string digits(4000, '7');
  const std::vector<std::pair<const char*, std::string>> lines{
      {"exact decimals", "1e4000 1e-4000\n"},
      {"long fractions", digits.substr(2000) + "/" + digits.substr(2001) + "1 " + digits + "\n"},
      {"long decimals", "0." + digits + " 7." + digits + "\n"},
      {"small exponents", "1e-999999999 1e-99999\n"},
      {"fractions", "1/3 2/7\n"},
      {"large integers", "99999999999999999999 18446744073709551616\n"},
  };
  for (const auto& [name, line] : lines) {
    for (const bool exact : {false, true}) {
      if (!exact && contains(line, "1e4000")) continue;  // larger than any double
      const std::size_t count = 1'000'000 / line.size() + 1;
      std::string text = std::to_string(count) + " 0\n";
      for (std::size_t i = 0; i < count; ++i) text += line;
      write_file(map, text);
      Words arguments{"map", "check", map, "--json", "--digits", "4096"};
      if (exact) arguments.push_back("--exact-decimals");
      const RunResult result = run(arguments);
      const double megabytes = static_cast<double>(text.size()) / 1e6;
      EXPECT_EQ(result.code, expected_code(name, exact)) << name << exact;
      if (kMeasures) {
        EXPECT_LT(result.user_seconds, 2 * megabytes) << name << exact;
        EXPECT_LT(result.megabytes, 10 * megabytes + 64) << name << exact;
      }
      RecordProperty(std::string(name) + (exact ? " exact" : ""),
                     std::to_string(result.user_seconds) + " s, " +
                         std::to_string(result.megabytes) + " MB, exit " +
                         std::to_string(result.code));
    }
  }
}

TEST(Demo, leaves_a_page_with_pictures) {
  const ScratchDirectory scratch;
  const RunResult result = run({"demo", "--json", "-o", (scratch / "demo").string()});
  EXPECT_EQ(result.code, 0) << result.err;
  EXPECT_EQ(JsonSchema(nlohmann::json::parse(read_file("docs/schema/demo.schema.json")))
                .misfit(nlohmann::json::parse(result.out)),
            "");
  EXPECT_TRUE(contains(result.out, "3759 cycles")) << result.out;
  const std::string page = read_file(scratch / "demo/index.html");
  EXPECT_TRUE(contains(page, "src=\"data:image/svg+xml,%3Csvg"));
  EXPECT_FALSE(contains(page, "src=\"http"));
  for (const char* name : {"us-counties.svg",
                           "star-or-quadrant.svg",
                           "star-without-quadrant.svg",
                           "states-over-counties.svg",
                           "states-over-counties.geojson",
                           "bunny-or-ball.svg",
                           "bunny-and-ball.svg",
                           "bunny-without-ball.svg",
                           "mould.svg",
                           "bunny-without-ball.nef",
                           "bunny-without-ball.off",
                           "bracket.svg",
                           "bracket.off",
                           "torus-polygons.svg",
                           "torus-result.svg",
                           "bunny-labels.svg",
                           "bunny-labels.html",
                           "test_four-pieces.svg",
                           "comb-pieces.svg",
                           "comb-pieces.html"}) {
    EXPECT_TRUE(fs::exists(scratch / (std::string("demo/") + name))) << name;
    EXPECT_TRUE(contains(page, name) || !std::string_view(name).ends_with(".svg")) << name;
  }
  for (const std::string name : {"star-or-quadrant.svg", "star-without-quadrant.svg"}) {
    EXPECT_EQ(read_file(scratch / ("demo/" + name)), read_file("docs/pictures/" + name)) << name;
  }
}

TEST(SelfTest, answers_in_text_and_json) {
  EXPECT_TRUE(run({"self-test"}).out.starts_with("ok"));
  EXPECT_EQ(nlohmann::json::parse(run({"self-test", "--json"}).out)["ok"], true);
}

}  // namespace
}  // namespace plumb::testing::program_test
