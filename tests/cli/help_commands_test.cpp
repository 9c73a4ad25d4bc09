// What the program says of itself is true: examples of the help and of documents, JSON schemas,
// completion, the manual page.

#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "json_schema.h"
#include "run_program.h"

namespace plumb::testing::help_commands_test {
namespace {

using Words = std::vector<std::string>;

Words lines_of(const std::string& text) {
  Words lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

Words words_of(const std::string& text) {
  std::istringstream in(text);
  return {std::istream_iterator<std::string>(in), {}};
}

/// What follows a line `title`, up to an empty line.
Words block(const std::string& text, const std::string& title) {
  const Words lines = lines_of(text);
  const auto begin = std::find(lines.begin(), lines.end(), title);
  if (begin == lines.end()) return {};
  return {begin + 1, std::find(begin, lines.end(), "")};
}

/// The lower-case words that a row of the help starts with.
Words command_of(const std::string& row) {
  Words words;
  for (const std::string& word : words_of(row.substr(0, row.find("  ", 2)))) {
    const bool is_name = word.find_first_not_of("abcdefghijklmnopqrstuvwxyz-") == word.npos;
    if (!is_name) break;
    words.push_back(word);
  }
  return words;
}

/// All commands, found as a reader of the help finds them.
std::vector<Words> all_commands() {
  std::vector<Words> found;
  for (const std::string& row : block(run({"--help"}).out, "Commands:")) {
    const Words words = command_of(row);
    if (row.find(words.at(0) + " ...") == row.npos) {
      found.push_back(words);
      continue;
    }
    for (const std::string& inner : block(run({words.at(0), "--help"}).out, "Commands:")) {
      found.push_back(command_of(inner));
    }
  }
  return found;
}

std::string help_of(Words command) {
  command.push_back("--help");
  const RunResult result = run(command);
  EXPECT_EQ(result.code, 0) << command.at(0);
  EXPECT_EQ(result.err, "");
  return result.out;
}

/// The root of the repository as examples want it, but where they can leave files.
class ExampleFolder {
 public:
  ExampleFolder() {
    fs::create_directory_symlink(fs::absolute("corpus"), scratch_ / "corpus");
    fs::create_symlink(PLUMB_PROGRAM, scratch_ / "plumb");
  }

  RunResult shell(const std::string& script) const {
    const std::string out = (scratch_ / ".out").string(), err = (scratch_ / ".err").string();
    write_file(scratch_ / ".script", "cd '" + (scratch_ / "").string() + "'\n" + script + '\n');
    const std::string command =
        "bash '" + (scratch_ / ".script").string() + "' >'" + out + "' 2>'" + err + "' </dev/null";
    const int status = std::system(command.c_str());
    RunResult result;
    result.code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    result.out = read_file(out);
    result.err = read_file(err);
    return result;
  }
  std::string read(const std::string& file) const { return read_file(scratch_ / file); }

 private:
  ScratchDirectory scratch_;
};

/// Nothing if --json of `command` printed what its schema says.
std::string misfit(const std::string& schema_file, const std::string& out) {
  const auto json = nlohmann::json::parse(out, nullptr, false);
  if (json.is_discarded()) return "no JSON: " + out.substr(0, 200);
  return JsonSchema(nlohmann::json::parse(read_file(schema_file))).misfit(json);
}

TEST(Help, fits_a_screen_and_names_every_command_once) {
  const std::string help = run({"--help"}).out;
  const Words lines = lines_of(help);
  EXPECT_LE(lines.size(), 24U);
  for (const std::string& line : lines) EXPECT_LE(line.size(), 80U) << line;
  const std::vector<Words> commands = all_commands();
  EXPECT_GE(commands.size(), 40U);
  EXPECT_EQ(std::set<Words>(commands.begin(), commands.end()).size(), commands.size());
}

/// All but examples, which are to be pasted.
void expect_fits(const std::string& help, std::size_t most_lines) {
  const Words lines = lines_of(help);
  EXPECT_LE(lines.size(), most_lines);
  for (const std::string& line : lines) {
    EXPECT_TRUE(line.size() <= 80 || line.starts_with("  ./plumb ")) << line;
  }
}

TEST(Help, of_groups_and_commands_fits_80_columns) {
  for (const char* group : {"map", "plane", "solid", "convex", "surface"}) {
    expect_fits(run({group, "--help"}).out, 40);
  }
  for (const Words& command : all_commands()) expect_fits(help_of(command), 40);
}

TEST(Help, has_examples_that_work_and_schemas_that_fit) {
  for (const Words& command : all_commands()) {
    SCOPED_TRACE(::testing::PrintToString(command));
    const std::string help = help_of(command);
    const Words examples = block(help, "Example:");
    ASSERT_EQ(examples.size(), 1U) << help;
    const std::size_t place = help.find("JSON: ");
    ASSERT_NE(place, help.npos);
    const std::string schema = words_of(help.substr(place + 6)).at(0);
    ASSERT_TRUE(fs::exists(schema)) << schema;
    if (command.at(0) == "demo") continue;  // program_test
    const ExampleFolder folder;
    const RunResult plain = folder.shell(examples[0]);
    EXPECT_TRUE(plain.code == 0 || plain.code == 1) << plain.code << plain.err;
    const RunResult json = folder.shell(examples[0] + " --json");
    EXPECT_EQ(json.code, plain.code) << json.err;
    EXPECT_EQ(misfit(schema, json.out), "");
  }
}

TEST(Help, has_an_example_for_every_group) {
  for (const char* group : {"map", "plane", "solid", "convex", "surface"}) {
    const Words example = block(run({group, "--help"}).out, "Example:");
    ASSERT_EQ(example.size(), 1U) << group;
    EXPECT_NE(example[0].find(group), std::string::npos);
  }
}

/// Lines of a document that call the program; the demo is for program_test.
Words commands_of(const fs::path& page) {
  Words commands = lines_of(read_file(page));
  std::erase_if(commands, [](const std::string& line) {
    return !line.starts_with("    ./plumb ") || line.starts_with("    ./plumb demo ");
  });
  return commands;
}

TEST(Documents, have_commands_that_work_when_pasted) {
  std::size_t found = 0;
  std::vector<fs::path> pages{"README.md"};
  for (const auto& entry : fs::directory_iterator("docs")) {
    if (entry.path().extension() == ".md") pages.push_back(entry.path());
  }
  for (const fs::path& page : pages) {
    const ExampleFolder folder;
    folder.shell(
        "cp corpus/solids/l-block.off A.off; cp corpus/solids/tetrahedron.off B.off; "
        "./plumb solid union A.off B.off -o any.nef");
    for (const std::string& command : commands_of(page)) {
      const RunResult result = folder.shell(command);
      EXPECT_TRUE(result.code == 0 || result.code == 1) << page << command << result.err;
      ++found;
    }
  }
  EXPECT_GT(found, 20U);
}

/// Those without images in them, whose bytes depend on zlib.
TEST(Documents, show_pictures_that_the_program_makes) {
  const std::vector<std::pair<const char*, const char*>> cases{
      {"us-counties.svg", "./plumb map check corpus/maps/us-counties.map --svg us-counties.svg"},
      {"frame-pieces.svg",
       "./plumb plane difference corpus/plane/frame.geojson corpus/plane/star.wkt -o "
       "frame-without-star.nef2 && ./plumb convex decompose frame-without-star.nef2 --svg "
       "frame-pieces.svg"},
  };
  const ExampleFolder folder;
  for (const auto& [picture, commands] : cases) {
    folder.shell(commands);
    const bool is_shown = folder.read(picture) == read_file(fs::path("docs/pictures") / picture);
    EXPECT_TRUE(is_shown) << picture;
  }
}

TEST(Json, fits_its_schema_whatever_the_answer) {
  const std::vector<std::pair<const char*, const char*>> cases{
      {"map-check", "map check corpus/maps/us-states.clean.map"},
      {"map-check", "map check corpus/layers/fields.geojson"},
      {"map-check", "map check corpus/layers/fields.geojson --edges"},
      {"map-overlay", "map overlay corpus/layers/fields.geojson corpus/layers/districts.geojson"},
      {"map-repair", "map repair corpus/layers/fields.geojson"},
      {"plane-set", "plane complement corpus/plane/star.wkt"},
      {"plane-set", "plane info corpus/plane/quadrant.nef2"},
      {"solid-set", "solid complement corpus/solids/l-block.off"},
      {"solid-set", "solid csg corpus/csg/bracket.csg"},
      {"plane-set", "plane csg corpus/csg/gasket.csg"},
      {"solid-slice", "solid slice corpus/solids/l-block.off --z 1/2"},
      {"solid-slice", "solid slice corpus/solids/l-block.off --z 0 --z 1 --every 1/2"},
      {"locate", "solid locate corpus/solids/l-block.off 9 9 9"},
      {"distance", "solid distance corpus/solids/l-block.off corpus/solids/tetrahedron.obj"},
      {"distance", "plane distance corpus/plane/star.wkt corpus/plane/quadrant.nef2"},
      {"solid-compare", "solid compare corpus/solids/l-block.off corpus/solids/tetrahedron.obj"},
      {"solid-repair", "solid repair corpus/solids/open-box.off"},
      {"solid-repair", "solid repair corpus/solids/double-sided-box.off --one-side"},
      {"convex-check", "convex check corpus/solids/l-block.off"},
      {"convex-decompose", "convex decompose corpus/solids/l-block.off --closed"},
      {"surface-cells", "surface cells corpus/scenes/torus-loops.json --repair"},
      {"surface-boolean", "surface boolean corpus/scenes/torus.json --op '!A'"},
      {"surface-path", "surface path corpus/scenes/room.json"},
      {"audit", "audit corpus/maps/us-counties.map"},
      {"view", "view corpus/plane/star.wkt -o star.svg"},
  };
  const ExampleFolder folder;
  for (const auto& [schema, arguments] : cases) {
    const RunResult result = folder.shell("./plumb " + std::string(arguments) + " --json");
    EXPECT_EQ(misfit("docs/schema/" + std::string(schema) + ".schema.json", result.out), "")
        << arguments << result.err;
  }
}

TEST(Json, schema_checker_finds_what_does_not_fit) {
  const JsonSchema schema(nlohmann::json::parse(R"({
    "type": "object", "required": ["n"], "additionalProperties": false,
    "properties": {"n": {"$ref": "#/$defs/count"}, "l": {"type": "array", "maxItems": 1}},
    "$defs": {"count": {"oneOf": [{"type": "integer", "minimum": 0}, {"type": "null"}]}}})"));
  const auto misfit = [&](const char* text) { return schema.misfit(nlohmann::json::parse(text)); };
  EXPECT_EQ(misfit(R"({"n": 3, "l": [1]})"), "");
  EXPECT_EQ(misfit(R"({"n": null})"), "");
  for (const char* text : {"[]", "{}", R"({"n": -1})", R"({"n": "3"})", R"({"n": 1.5})",
                           R"({"n": 1, "m": 2})", R"({"n": 1, "l": [1, 2]})"}) {
    EXPECT_NE(misfit(text), "") << text;
  }
  EXPECT_NE(JsonSchema(nlohmann::json::parse(R"({"not": {}})")).misfit(1), "");
}

TEST(Streams, dash_is_standard_input_and_output) {
  const std::vector<std::pair<const char*, const char*>> cases{
      {"corpus/maps/us-counties.map", "map check - -o - --format geojson"},
      {"corpus/layers/fields.geojson", "map check -"},
      {"corpus/layers/fields.geojson", "map repair - -o - --format geojson"},
      {"corpus/layers/fields.geojson", "map dissolve - -o - --format wkt"},
      {"corpus/layers/fields.geojson", "map simplify - --tolerance 1"},
      {"corpus/layers/fields.geojson", "map overlay - corpus/layers/districts.geojson"},
      {"corpus/plane/star.wkt", "plane union - corpus/plane/frame.geojson -o - --format nef2"},
      {"corpus/plane/quadrant.nef2", "plane locate - 0 0"},
      {"corpus/solids/l-block.off", "solid info -"},
      {"corpus/solids/l-block.off",
       "solid difference - corpus/solids/tetrahedron.obj -o - --format off"},
      {"corpus/solids/l-block.off", "solid eval '!A' A=- -o - --format nef"},
      {"corpus/solids/octahedron.txt", "solid halfspaces - -o - --format stl"},
      {"corpus/csg/bracket.csg", "solid csg - -o - --format off"},
      {"corpus/solids/flipped-box.off", "solid repair - -o - --format off"},
      {"corpus/solids/l-block.off", "convex check -"},
      {"corpus/solids/l-block.off", "convex decompose -"},
      {"corpus/solids/l-block.off", "view - -o - --format svg"},
      {"corpus/plane/star.wkt", "audit -"},
  };
  const ExampleFolder folder;
  for (const auto& [file, arguments] : cases) {
    const std::string text = arguments;
    std::string named = text;
    const std::size_t dash = text.find("A=-") == text.npos ? text.find(" -") + 1 : text.find("-");
    named.replace(dash, 1, file);
    const RunResult piped = folder.shell("cat " + std::string(file) + " | ./plumb " + text);
    const RunResult opened = folder.shell("./plumb " + named);
    EXPECT_LE(piped.code, 1) << text << piped.err;
    EXPECT_EQ(piped.code, opened.code) << text;
    EXPECT_FALSE(piped.out.empty()) << text;
    const bool has_name = text.find("view") != text.npos;
    EXPECT_TRUE(has_name || piped.out == opened.out) << text;
  }
  for (const char* command : {"completion bash", "manual", "self-test"}) {
    const std::string text = command;
    EXPECT_EQ(folder.shell("./plumb " + text + " -o -").out, folder.shell("./plumb " + text).out);
  }
}

/// What bash offers after `line`.
std::set<std::string> completed(const ExampleFolder& folder, const std::string& line) {
  const RunResult result = folder.shell(
      "compopt() { :; }\nsource <(./plumb completion bash)\ncomplete -p plumb >/dev/null || exit "
      "9\n"
      "COMP_WORDS=(" +
      line +
      ")\nCOMP_CWORD=$((${#COMP_WORDS[@]} - 1))\n_plumb\n"
      "printf '%s\\n' \"${COMPREPLY[@]}\"");
  EXPECT_EQ(result.code, 0);
  EXPECT_EQ(result.err, "");
  const Words words = lines_of(result.out);
  return {words.begin(), words.end()};
}

TEST(Completion, offers_commands_options_words_and_files) {
  const ExampleFolder folder;
  using Set = std::set<std::string>;
  EXPECT_EQ(completed(folder, "plumb so"), Set{"solid"});
  EXPECT_EQ(completed(folder, "plumb map ''"),
            (Set{"check", "dissolve", "overlay", "repair", "simplify", "--help"}));
  EXPECT_EQ(completed(folder, "plumb solid sec"), Set{"section"});
  EXPECT_EQ(completed(folder, "plumb solid section --si"), Set{"--side"});
  EXPECT_EQ(completed(folder, "plumb solid section --side ''"), (Set{"closed", "open", "plane"}));
  EXPECT_EQ(completed(folder, "plumb view --js"), Set{"--json"});
  EXPECT_EQ(completed(folder, "plumb audit cor"), Set{"corpus"});
  for (const Words& command : all_commands()) {
    std::string line = "plumb";
    for (const std::string& word : command) line += ' ' + word;
    EXPECT_TRUE(completed(folder, line + " --out").contains("--output")) << line;
  }
}

TEST(Manual, names_every_command_and_has_no_warnings) {
  const ExampleFolder folder;
  const std::string page = folder.shell("./plumb manual").out;
  EXPECT_TRUE(page.starts_with(".TH PLUMB 1"));
  for (const Words& command : all_commands()) {
    std::string title = ".SS plumb";
    for (const std::string& word : command) title += ' ' + word;
    for (std::size_t at = 0; (at = title.find('-', at)) != title.npos; at += 2) {
      title.insert(at, "\\");
    }
    EXPECT_NE(page.find(title), page.npos) << title;
  }
  static const std::set<std::string> kRequests{".TH", ".SH", ".SS", ".TP", ".PP",
                                               ".EX", ".EE", ".B",  ".I"};
  for (const std::string& line : lines_of(page)) {
    EXPECT_TRUE(!line.starts_with('.') || kRequests.contains(words_of(line).at(0))) << line;
  }
  const RunResult formatted = folder.shell(
      "command -v groff >/dev/null || exit 0\n./plumb manual | groff -man -ww -Tutf8 -z 2>&1");
  EXPECT_EQ(formatted.code, 0);
  EXPECT_EQ(formatted.out, "");
}

}  // namespace
}  // namespace plumb::testing::help_commands_test
