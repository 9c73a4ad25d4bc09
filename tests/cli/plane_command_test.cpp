// The commands `plumb plane ...` and `plumb audit` from outside.

#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "../io/hostile_shapes.h"
#include "plumb/predicates/rational.h"
#include "refusal.h"
#include "run_program.h"

namespace plumb::testing::plane_command_test {
namespace {

using Json = nlohmann::json;
using Words = std::vector<std::string>;

const std::string kStar = "corpus/plane/star.wkt";
const std::string kFrame = "corpus/plane/frame.geojson";
const std::string kCorner = "corpus/plane/quadrant.nef2";

Json info(const std::string& file) {
  const RunResult result = run({"plane", "info", file, "--json"});
  EXPECT_EQ(result.code, 0) << result.err;
  return Json::parse(result.out);
}

/// Are two files the same set? Their symmetric difference says so.
bool is_same_set(const std::string& a, const std::string& b) {
  const RunResult result = run({"plane", "symmetric-difference", a, b, "--json"});
  EXPECT_EQ(result.code, 0) << result.err;
  return Json::parse(result.out)["empty"];
}

const std::vector<std::string> kBinary{"union", "intersection", "difference",
                                       "symmetric-difference"};
const std::vector<std::string> kUnary{"complement", "interior", "closure", "boundary",
                                      "regularize"};

TEST(PlaneProgram, draws_results_and_sets) {
  const ScratchDirectory scratch;
  const std::string svg = (scratch / "out.svg").string();
  const RunResult drawn = run({"plane", "union", kStar, kCorner, "-o", svg, "--json"});
  EXPECT_EQ(drawn.code, 0) << drawn.err;
  EXPECT_EQ(drawn.err, "") << "an unbounded set is no loss in a picture";
  EXPECT_EQ(Json::parse(drawn.out)["bounded"], false);
  EXPECT_TRUE(read_file(svg).starts_with("<svg"));
  const RunResult piped = run({"plane", "complement", kFrame, "--format", "svg", "--strict"});
  EXPECT_EQ(piped.code, 0) << piped.err;
  EXPECT_TRUE(piped.out.starts_with("<svg")) << piped.out.substr(0, 200);
  const std::string set = (scratch / "set.svg").string();
  EXPECT_EQ(Json::parse(run({"plane", "info", kStar, "--svg", set, "--json"}).out), info(kStar));
  EXPECT_TRUE(contains(read_file(set), "star.wkt"));
}

/// The ids of the features of a GeoJSON text; null for features without one.
Json ids_of(const std::string& text) {
  const Json layer = Json::parse(text);
  Json ids = Json::array();
  for (const Json& feature : layer["features"]) {
    ids.push_back(feature.contains("id") ? feature["id"] : Json());
  }
  return ids;
}

TEST(PlaneProgram, keeps_the_features_of_its_operands) {
  const ScratchDirectory scratch;
  const auto layer = [&](const std::string& name, const std::vector<std::pair<int, int>>& squares) {
    Json features = Json::array();
    for (const auto& [id, x] : squares) {
      const Json ring{{x, 0}, {x + 4, 0}, {x + 4, 4}, {x, 4}, {x, 0}};
      features.push_back(
          {{"type", "Feature"},
           {"id", id},
           {"properties", {{"x", x}}},
           {"geometry", {{"type", "Polygon"}, {"coordinates", Json::array({ring})}}}});
    }
    const std::string file = (scratch / name).string();
    write_file(file, Json{{"type", "FeatureCollection"}, {"features", features}}.dump());
    return file;
  };
  const std::string a = layer("a.geojson", {{1, 0}, {2, 4}}), b = layer("b.geojson", {{3, 6}});
  const std::string box = (scratch / "box.wkt").string(), out = (scratch / "out.geojson").string();
  write_file(box, "POLYGON((1 1,20 1,20 3,1 3,1 1))");
  const auto kept = [&](Words words) {
    words.insert(words.end(), {"--keep", "ids", "-o", out});
    const RunResult result = run(words);
    EXPECT_EQ(result.code, 0) << result.err;
    EXPECT_EQ(result.err, "") << "nothing is passed over";
    EXPECT_TRUE(is_same_set(out, out));
    return ids_of(read_file(out));
  };
  EXPECT_EQ(kept({"plane", "union", a, b}), (Json{1, 2, 3}));
  EXPECT_EQ(kept({"plane", "union", a, b, box}), (Json{1, 2, 3, nullptr}));
  EXPECT_EQ(kept({"plane", "intersection", b, a}), Json::array({3}));
  EXPECT_EQ(kept({"plane", "intersection", a, b}), Json::array({2}));
  EXPECT_EQ(kept({"plane", "difference", a, box}), (Json{1, 2}));
  EXPECT_EQ(kept({"plane", "regularize", b}), Json::array({3}));
  // The parts make the same set as without features.
  const std::string whole = (scratch / "whole.wkt").string();
  EXPECT_EQ(kept({"plane", "symmetric-difference", a, box}), (Json{1, 2, nullptr}));
  EXPECT_EQ(run({"plane", "symmetric-difference", a, box, "-q", "-o", whole}).code, 0);
  EXPECT_TRUE(is_same_set(out, whole));
  for (const Words& more :
       {Words{"-o", whole}, Words{"-o", out, "--raw"}, Words{"-o", out, "--grid", "1"},
        Words{"-o", out, "--exact-decimals"}}) {
    Words words{"plane", "union", a, b, "--keep", "ids"};
    words.insert(words.end(), more.begin(), more.end());
    EXPECT_EQ(run(words).code, 2);
  }
  const RunResult lines = run({"plane", "boundary", a, "--keep", "ids", "-o", out});
  EXPECT_TRUE(contains(lines.err, "lines and points were left out")) << lines.err;
  EXPECT_EQ(run({"plane", "boundary", a, "--keep", "ids", "-o", out, "--strict"}).code, 2);
}

TEST(PlaneProgram, examples_of_the_help_work) {
  const ScratchDirectory scratch;
  for (const std::string name :
       {"plane union", "plane intersection", "plane difference", "plane symmetric-difference",
        "plane complement", "plane interior", "plane closure", "plane boundary", "plane regularize",
        "plane minkowski", "plane offset", "plane simplify", "plane triangulate", "plane voronoi",
        "plane arrange", "plane info", "plane locate", "plane distance", "audit"}) {
    Words words;
    std::istringstream help(name + " --help");
    for (std::string word; help >> word;) words.push_back(word);
    const std::string text = run(words).out;
    const std::size_t start = text.find("  ./plumb " + name);
    ASSERT_NE(start, std::string::npos) << text;
    std::istringstream example(text.substr(start + 10, text.find('\n', start) - start - 10));
    words.clear();
    for (std::string word; example >> word;) {
      words.push_back(word.starts_with("out.") ? (scratch / word).string() : word);
    }
    const RunResult result = run(words);
    EXPECT_EQ(result.code, 0) << text << result.err;
    const bool has_file = std::find(words.begin(), words.end(), "-o") != words.end();
    EXPECT_EQ(result.out.empty(), has_file) << text;
  }
}

TEST(PlaneProgram, lists_its_commands) {
  const std::string text = run({"plane", "--help"}).out;
  for (const auto& names :
       {kBinary, kUnary, Words{"minkowski", "offset", "simplify", "info", "locate", "distance"}}) {
    for (const std::string& name : names) EXPECT_TRUE(contains(text, "plane " + name)) << text;
  }
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) EXPECT_LE(line.size(), 90U) << line;
}

TEST(PlaneProgram, combines_many_sets) {
  const ScratchDirectory scratch;
  Words words{"plane", "union"};
  for (int i = 0; i < 5; ++i) {
    const std::string x = std::to_string(i), to = std::to_string(i + 2);
    const auto path = scratch / (x + ".wkt");
    write_file(path, "POLYGON((" + x + " 0," + to + " 0," + to + " 1," + x + " 1," + x + " 0))");
    words.push_back(path.string());
  }
  EXPECT_EQ(run(words).out, "POLYGON ((0 0, 6 0, 6 1, 0 1, 0 0))\n");
  words[1] = "intersection";
  words.resize(4);
  EXPECT_EQ(run(words).out, "POLYGON ((1 0, 2 0, 2 1, 1 1, 1 0))\n");
  const RunResult twice = run({"plane", "union", "-", words[2], "-"});
  EXPECT_EQ(twice.code, 2);
  EXPECT_TRUE(contains(twice.err, "standard input")) << twice.err;
}

TEST(PlaneProgram, adds_offsets_and_reads_by_a_rule) {
  const ScratchDirectory scratch;
  const std::string square = (scratch / "square.wkt").string();
  write_file(square, "POLYGON((0 0,2 0,2 2,0 2,0 0))");
  EXPECT_EQ(run({"plane", "minkowski", square, square}).out,
            "POLYGON ((0 0, 4 0, 4 4, 0 4, 0 0))\n");
  EXPECT_EQ(run({"plane", "offset", square, "--by", "1/2", "--join", "mitre"}).out,
            "POLYGON ((-0.5 -0.5, 2.5 -0.5, 2.5 2.5, -0.5 2.5, -0.5 -0.5))\n");
  EXPECT_EQ(run({"plane", "offset", square, "--by", "-0.5"}).out,
            "POLYGON ((0.5 0.5, 1.5 0.5, 1.5 1.5, 0.5 1.5, 0.5 0.5))\n");
  for (const Words& wrong : {Words{"--by", "nan"}, Words{"--by", "1", "--segments", "2"},
                             Words{"--by", "1", "--mitre-limit", "0"}, Words{}}) {
    Words words{"plane", "offset", square};
    words.insert(words.end(), wrong.begin(), wrong.end());
    const RunResult refused = run(words);
    EXPECT_EQ(refused.code, 2) << refused.out;
    EXPECT_EQ(refused.out, "");
  }
  const std::string twice = (scratch / "twice.wkt").string();
  write_file(twice, "POLYGON((0 0,4 0,4 4,0 4,0 0,4 0,4 4,0 4,0 0))");
  EXPECT_TRUE(contains(run({"plane", "info", twice, "--rule", "nonzero"}).out, "area 16"));
  EXPECT_TRUE(contains(run({"plane", "info", twice}).err, "overlap"));
}

TEST(PlaneProgram, simplifies_within_what_it_is_told) {
  const ScratchDirectory scratch;
  const std::string dented = (scratch / "dented.wkt").string();
  write_file(dented, "POLYGON((0 0,1.5 0,2 0.5,2.5 0,4 0,4 4,0 4,0 0))");
  const std::string square = "POLYGON ((0 0, 4 0, 4 4, 0 4, 0 0))\n";
  for (const Words& wide :
       {Words{"--tolerance", "0.25"}, Words{"--tolerance", "1", "--within", "0.6"}}) {
    Words words{"plane", "simplify", dented};
    words.insert(words.end(), wide.begin(), wide.end());
    const RunResult result = run(words);
    EXPECT_EQ(result.out, square) << result.err;
    EXPECT_TRUE(contains(result.err, "4 of 7 corners left; no border moved by more than 0.5"))
        << result.err;
  }
  EXPECT_EQ(run({"plane", "simplify", dented, "--within", "0.3"}).out,
            run({"plane", "closure", dented}).out);
  for (const Words& wrong :
       {Words{dented}, Words{dented, "--within", "-1"}, Words{dented, "--percent", "200"},
        Words{"corpus/plane/quadrant.nef2", "--percent", "50"}}) {
    Words words{"plane", "simplify"};
    words.insert(words.end(), wrong.begin(), wrong.end());
    const RunResult refused = run(words);
    EXPECT_EQ(refused.code, 2) << refused.out;
    EXPECT_EQ(refused.out, "");
  }
}

TEST(PlaneProgram, writes_wkb_that_it_reads) {
  const ScratchDirectory scratch;
  const std::string wkb = (scratch / "frame.wkb").string();
  ASSERT_EQ(run({"plane", "closure", kFrame, "-o", wkb}).code, 0);
  EXPECT_EQ(info(wkb), info(kFrame));
  EXPECT_TRUE(is_same_set(wkb, kFrame));
  EXPECT_EQ(run({"plane", "closure", kFrame, "--format", "wkb"}).out, read_file(wkb));
}

/// The closure of a sum is the sum of the closures, which is all that WKT can hold.
TEST(PlaneProgram, writes_the_closure_of_a_sum) {
  const ScratchDirectory scratch;
  const auto path = [&](const std::string& name) { return (scratch / name).string(); };
  write_file(scratch / "square.wkt", "POLYGON((0 0,2 0,2 2,0 2,0 0))");
  write_file(scratch / "line.wkt", "LINESTRING(0 0,2 0)");
  run({"plane", "difference", path("square.wkt"), path("line.wkt"), "-o", path("half.nef2")});
  run({"plane", "minkowski", path("half.nef2"), path("half.nef2"), "-o", path("sum.nef2")});
  EXPECT_EQ(run({"plane", "locate", path("sum.nef2"), "1", "0"}).out, "edge, not in the set\n");
  EXPECT_EQ(run({"plane", "minkowski", path("half.nef2"), path("half.nef2")}).out,
            run({"plane", "closure", path("sum.nef2")}).out);
}

TEST(PlaneProgram, tells_what_a_set_is_like) {
  const ScratchDirectory scratch;
  const auto file = [&](const std::string& text) {
    write_file(scratch / "a.wkt", text);
    return info((scratch / "a.wkt").string());
  };
  EXPECT_EQ(file("POLYGON ((0 0, 5 0, 0 5, 0 0))"),
            Json::parse(R"({"vertices":3,"edges":3,"faces":2,"bounded":true,"empty":false,)"
                        R"("area":{"exact":"25/2","double":12.5}})"));
  EXPECT_EQ(file("POLYGON ((0 0, 4 0, 4 4, 0 4, 0 0))")["area"]["exact"], "16");
  EXPECT_EQ(file("POINT EMPTY"),
            Json::parse(R"({"vertices":0,"edges":0,"faces":1,"bounded":true,"empty":true,)"
                        R"("area":{"exact":"0","double":0.0}})"));
  EXPECT_EQ(info(kCorner),
            Json::parse(R"({"vertices":1,"edges":2,"faces":2,"bounded":false,"empty":false,)"
                        R"("area":null})"));
  EXPECT_TRUE(contains(run({"plane", "info", kCorner}).out, "unbounded"));
}

/// |A + B| = |A| + |B| - |A * B| and so on, exactly, through files.
TEST(PlaneProgram, tells_it_in_words) {
  const ScratchDirectory scratch;
  const auto words = [&](const std::string& wkt) {
    write_file(scratch / "a.wkt", wkt);
    return run({"plane", "info", (scratch / "a.wkt").string()}).out;
  };
  const std::string triangle = words("POLYGON((0 0, 3 0, 0 1, 0 0))");
  EXPECT_TRUE(contains(triangle, "bounded\narea 3/2")) << triangle;
  const std::string nothing = words("POLYGON EMPTY");
  EXPECT_TRUE(contains(nothing, "bounded, empty\narea 0")) << nothing;
}

TEST(PlaneProgram, areas_add_up_exactly) {
  const auto area = [](const Json& json) {
    return Rational(json["area"]["exact"].get<std::string>());
  };
  const auto area_of = [&](const std::string& operation) {
    const RunResult result = run({"plane", operation, kStar, kFrame, "--json"});
    EXPECT_EQ(result.code, 0) << result.err;
    return area(Json::parse(result.out));
  };
  const Rational a = area(info(kStar));
  const Rational b = area(info(kFrame));
  const Rational both = area_of("intersection");
  EXPECT_GT(both, 0);
  EXPECT_EQ(area_of("union"), a + b - both);
  EXPECT_EQ(area_of("difference"), a - both);
  EXPECT_EQ(area_of("symmetric-difference"), a + b - 2 * both);
}

TEST(PlaneProgram, operations_keep_their_laws) {
  const ScratchDirectory scratch;
  const auto path = [&](const std::string& name) { return (scratch / name).string(); };
  const auto make = [&](const Words& words, const std::string& name) {
    Words arguments{"plane"};
    arguments.insert(arguments.end(), words.begin(), words.end());
    arguments.insert(arguments.end(), {"-o", path(name)});
    const RunResult result = run(arguments);
    EXPECT_EQ(result.code, 0) << result.err;
    EXPECT_EQ(result.out, "");
    EXPECT_EQ(run({"audit", path(name)}).code, 0);
    return path(name);
  };
  for (const std::string& b : {kFrame, kCorner}) {
    const std::string not_a = make({"complement", kStar}, "not_a.nef2");
    const std::string not_b = make({"complement", b}, "not_b.nef2");
    // De Morgan, and A - B = A * !B
    const std::string neither = make({"intersection", not_a, not_b}, "neither.nef2");
    EXPECT_TRUE(is_same_set(make({"complement", neither}, "either.nef2"),
                            make({"union", kStar, b}, "union.nef2")));
    EXPECT_TRUE(is_same_set(make({"difference", kStar, b}, "difference.nef2"),
                            make({"intersection", kStar, not_b}, "only_a.nef2")));
    // closure and interior are dual; the boundary is what lies between them
    const std::string inside = make({"interior", b}, "interior.nef2");
    EXPECT_TRUE(
        is_same_set(inside, make({"complement", make({"closure", not_b}, "c.nef2")}, "dual.nef2")));
    EXPECT_TRUE(is_same_set(
        make({"boundary", b}, "boundary.nef2"),
        make({"difference", make({"closure", b}, "closure.nef2"), inside}, "between.nef2")));
    EXPECT_TRUE(is_same_set(make({"regularize", b}, "regular.nef2"),
                            make({"closure", inside}, "closed.nef2")));
    EXPECT_FALSE(is_same_set(inside, b));
  }
}

TEST(PlaneProgram, locates_points) {
  const std::vector<std::pair<Words, const char*>> points{
      {{"0", "0"}, R"({"on":"vertex","marked":true})"},
      {{"1/3", "0"}, R"({"on":"edge","marked":true})"},
      {{"0", "1e-300"}, R"({"on":"edge","marked":true})"},
      {{"123456789012345678901234567890", "0.1"}, R"({"on":"face","marked":true})"},
      {{"-1", "2"}, R"({"on":"face","marked":false})"},
      {{"2", "-1/7"}, R"({"on":"face","marked":false})"},
      {{"-.5", "-1e-5"}, R"({"on":"face","marked":false})"},
      {{"-0.0", "+0"}, R"({"on":"vertex","marked":true})"},
  };
  for (const auto& [point, expected] : points) {
    const RunResult result = run({"plane", "locate", kCorner, point[0], point[1], "--json"});
    EXPECT_EQ(result.code, 0) << result.err;
    EXPECT_EQ(Json::parse(result.out), Json::parse(expected)) << point[0] << ' ' << point[1];
  }
  EXPECT_EQ(run({"plane", "locate", kCorner, "1", "1"}).out, "face, in the set\n");
  // 0.1 as a double is not 1/10: the edge from (0, 0) to (1, 10) goes through (1/10, 1) only.
  const ScratchDirectory scratch;
  write_file(scratch / "a.wkt", "LINESTRING (0 0, 1 10)");
  const std::string line = (scratch / "a.wkt").string();
  const auto on = [&](const Words& more) {
    Words words{"plane", "locate", line, "0.1", "1", "--json"};
    words.insert(words.end(), more.begin(), more.end());
    return Json::parse(run(words).out)["on"];
  };
  EXPECT_EQ(on({}), "face");
  EXPECT_EQ(on({"--exact-decimals"}), "edge");
}

TEST(PlaneProgram, writes_every_format_and_reads_it_back) {
  const ScratchDirectory scratch;
  const auto path = [&](const std::string& name) { return (scratch / name).string(); };
  for (const std::string name : {"a.wkt", "a.geojson", "a.json", "a.nef2"}) {
    EXPECT_EQ(run({"plane", "closure", kFrame, "-o", path(name)}).code, 0);
    EXPECT_TRUE(is_same_set(path(name), kFrame)) << name;
    RunOptions from_stdin;
    from_stdin.in = path(name);
    EXPECT_EQ(run({"plane", "info", "-", "--json"}, from_stdin).out,
              run({"plane", "info", kFrame, "--json"}).out)
        << name;
  }
  EXPECT_EQ(scratch.files(), (Words{"a.geojson", "a.json", "a.nef2", "a.wkt"}));
  for (const std::string format : {"wkt", "geojson", "nef2"}) {
    const std::string file = read_file(path("a." + format));
    EXPECT_EQ(run({"plane", "closure", kFrame, "--format", format}).out, file);
    EXPECT_EQ(run({"plane", "closure", kFrame, "-o", "-", "--format", format}).out, file);
  }
  EXPECT_EQ(run({"plane", "closure", kFrame}).out, read_file(path("a.wkt")));
  EXPECT_TRUE(run({"plane", "closure", kCorner}).out.starts_with("plumb-nef2 1\n"));
}

TEST(PlaneProgram, says_what_a_file_does_not_say) {
  const ScratchDirectory scratch;
  const auto path = [&](const std::string& name) { return (scratch / name).string(); };
  write_file(scratch / "tiny.wkt",
             "POLYGON ((1/3 1/3, 33333333333333333333334/100000000000000000000000 1/3, 1/3 "
             "33333333333333333333334/100000000000000000000000, 1/3 1/3))");
  write_file(scratch / "point.wkt", "POINT (0 9)");
  const std::vector<std::pair<Words, const char*>> cases{
      {{"complement", kStar}, "unbounded sets need .nef2"},
      {{"difference", kStar, path("point.wkt")}, "missing inside"},
      {{"closure", path("tiny.wkt")}, "rounding"},
  };
  for (const auto& [words, part] : cases) {
    for (const std::string name : {"out.wkt", "out.geojson"}) {
      Words arguments{"plane"};
      arguments.insert(arguments.end(), words.begin(), words.end());
      arguments.insert(arguments.end(), {"-o", path(name)});
      const RunResult result = run(arguments);
      EXPECT_EQ(result.code, 0);
      EXPECT_TRUE(result.err.starts_with(path(name) + ": ")) << result.err;
      EXPECT_TRUE(contains(result.err, part)) << result.err;
      EXPECT_TRUE(fs::remove(path(name)));
      arguments.push_back("--quiet");
      EXPECT_EQ(run(arguments).err, "");
      EXPECT_TRUE(fs::remove(path(name)));
      arguments.back() = "--strict";
      expect_refusal(run(arguments), path(name) + ": ", part);
      EXPECT_EQ(scratch.files(), (Words{"point.wkt", "tiny.wkt"}));
    }
    Words arguments{"plane"};
    arguments.insert(arguments.end(), words.begin(), words.end());
    arguments.insert(arguments.end(), {"-o", path("o.nef2"), "--strict"});
    const RunResult exact = run(arguments);
    EXPECT_EQ(exact.code, 0);
    EXPECT_EQ(exact.err, "");
    EXPECT_TRUE(fs::remove(path("o.nef2")));
  }
  EXPECT_EQ(run({"plane", "interior", kStar}).err, "") << "a border is no loss";
  expect_refusal(run({"plane", "interior", kStar, "--strict"}), "stdout: ", "closure");
}

/// Files without a telling extension, from another program: each is known by how it begins.
TEST(PlaneProgram, reads_dialects_and_says_what_it_drops) {
  struct Dialect {
    std::string text;
    std::string note;
  };
  const std::string feature =
      R"({"type":"Feature","properties":{"a":NaN},"geometry":{"type":"Polygon",)"
      R"("coordinates":[[[0,0,1],[4,0,1],[4,3,NaN],[0,0,1]]]}})";
  const std::string heights = "passed over: heights (Z)\n";
  const std::string systems = "passed over: coordinate reference systems\n";
  const std::string members = "passed over: 'properties', numbers of positions after x and y\n";
  const std::vector<Dialect> dialects{
      {"POLYGON ((0 0, 4 0, 4 3, 0 0));\n", ""},
      {"polygonz((0 0 1,4 0 1,4 3 nan,0 0 1))", heights},
      {"SRID=4326;POLYGON((0 0,4 0,4 3,0 0))", systems},
      {"<http://www.opengis.net/def/crs/OGC/1.3/CRS84> POLYGON((0 0,4 0,4 3,0 0))", systems},
      {"TIN (((0 0, 4 0, 4 3, 0 0)))", ""},
      {feature + "\n" + feature + "\n", members},
      {"\x1e" + feature + "\n", members},
      {"01030000000100000004000000"
       "0000000000000000000000000000000000000000000010400000000000000000"
       "0000000000001040000000000000084000000000000000000000000000000000\n",
       ""}};
  const ScratchDirectory scratch;
  const std::string file = (scratch / "any").string();
  for (const auto& [text, note] : dialects) {
    SCOPED_TRACE(text);
    write_file(file, text);
    for (const Words& words : {Words{"plane", "info", file}, Words{"convex", "check", file}}) {
      const RunResult result = run(words);
      EXPECT_EQ(result.code, 0);
      EXPECT_EQ(result.err, note.empty() ? "" : file + ": " + note);
    }
    EXPECT_TRUE(contains(run({"plane", "info", file}).out, "area 6\n"));
    EXPECT_EQ(run({"plane", "info", file, "--quiet"}).err, "");
    EXPECT_EQ(run({"audit", file}).code, 0);
  }
}

TEST(PlaneProgram, says_that_a_file_with_content_is_the_empty_set) {
  const ScratchDirectory scratch;
  const std::string file = (scratch / "a.wkt").string();
  write_file(file, "POLYGON EMPTY");
  EXPECT_TRUE(contains(run({"plane", "info", file}).err, file + ": the file has no point"));
}

/// A decimal step is a decimal: 0.1 is a tenth.
TEST(PlaneProgram, rounds_to_a_grid) {
  const ScratchDirectory scratch;
  const std::string out = (scratch / "out.wkt").string();
  EXPECT_EQ(run({"plane", "union", kStar, kFrame, "--grid", "0.1", "-o", out}).code, 0);
  const std::string once = run({"plane", "closure", out, "--grid", "0.1"}).out;
  EXPECT_EQ(once, run({"plane", "closure", out}).out);
  EXPECT_EQ(run({"plane", "union", kStar, kFrame, "--grid", "1/10"}).out, once);
}

TEST(PlaneProgram, refuses_hostile_files_and_leaves_no_output) {
  const ScratchDirectory scratch;
  const std::vector<std::pair<std::string, std::vector<HostileText>>> formats{
      {".wkt", hostile_wkt()}, {".geojson", hostile_geojson()}, {".nef2", hostile_nef2()}};
  for (const auto& [extension, texts] : formats) {
    const std::string bad = (scratch / ("bad" + extension)).string();
    for (const HostileText& hostile : texts) {
      SCOPED_TRACE(hostile.name);
      write_file(bad, hostile.bytes);
      const RunResult result =
          run({"plane", "union", kStar, bad, "-o", (scratch / "out.nef2").string(), "--json"});
      const std::string place =
          bad + ":" + std::to_string(hostile.line) + ":" + std::to_string(hostile.column) + ": ";
      expect_refusal(result, place, hostile.message);
    }
    EXPECT_EQ(scratch.files(), Words{"bad" + extension});
    fs::remove(bad);
  }
}

TEST(PlaneProgram, refuses_wrong_usage) {
  const std::vector<std::pair<Words, const char*>> wrong{
      {{"plane"}, "second word"},
      {{"plane", "unoin", kStar, kFrame}, "'plane union'"},
      {{"plane", "union", kStar}, "B is required"},
      {{"plane", "complement", kStar, kFrame}, ""},
      {{"plane", "union", "-", "-"}, "standard input"},
      {{"plane", "union", kStar, kFrame, "-o", "-"}, "needs --format"},
      {{"plane", "union", kStar, kFrame, "--format", "off"}, "'off'"},
      {{"plane", "union", kStar, kFrame, "--format", "wkt", "--json"}, "only one output"},
      {{"plane", "locate", kStar, "1"}, "Y is required"},
      {{"plane", "locate", kStar, "1", "x"}, "Y: expected a number, found 'x'"},
      {{"plane", "locate", kStar, "1/0", "1"}, "X: the denominator is 0"},
      {{"plane", "locate", kStar, "1 2", "1"}, "X: expected a number"},
      {{"plane", "locate", kStar, "", "1"}, "X: expected a number"},
      {{"plane", "locate", kStar, "nan", "1"}, "'nan'"},
      {{"plane", "info", kStar, "--strict"}, "--strict"},
      {{"plane", "union", kStar, kFrame, "--grid", "0"}, "--grid: the step must be positive"},
      {{"plane", "union", kStar, kFrame, "--grid", "x"}, "--grid: expected a number"},
      {{"plane", "union", kStar, kFrame, "--grid", "1", "--raw"}, "exclude each other"},
      {{"plane", "union", kStar, kStar, "--raw", "--format", "nef2"}, "WKT, GeoJSON"},
      {{"plane", "union", kStar, kStar, "--grid", "1", "--format", "svg"}, "WKT, GeoJSON"},
  };
  for (const auto& [arguments, part] : wrong) {
    SCOPED_TRACE(::testing::PrintToString(arguments));
    expect_refusal(run(arguments), "plumb: ", part);
  }
  expect_refusal(run({"plane", "closure", kStar, "-o", "out.off"}), "out.off: ", "'.off'");
  expect_refusal(run({"plane", "info", "no/such.wkt"}), "no/such.wkt: ", "No such file");
}

TEST(PlaneProgram, stops_at_its_limits) {
  const ScratchDirectory scratch;
  std::string text;
  for (int i = 0; i < 60000; ++i) text += "POINT (" + std::to_string(i) + " 1)\n";
  write_file(scratch / "many.wkt", text);
  for (const Words& limit : {Words{"--limit-memory", "1"}, Words{"--limit-seconds", "0.000001"}}) {
    const RunResult result = run({"plane", "closure", (scratch / "many.wkt").string(), "-o",
                                  (scratch / "out.nef2").string(), limit[0], limit[1]});
    EXPECT_EQ(result.code, 3) << result.err;
    EXPECT_EQ(result.out, "");
    EXPECT_TRUE(contains(result.err, limit[0])) << result.err;
    EXPECT_EQ(scratch.files(), Words{"many.wkt"});
  }
}

TEST(AuditProgram, judges_what_is_in_a_file) {
  for (const std::string& file :
       {kStar, kFrame, kCorner, std::string("corpus/maps/world-countries.clean.map")}) {
    const RunResult result = run({"audit", file, "--json"});
    EXPECT_EQ(result.code, 0) << result.out << result.err;
    EXPECT_EQ(Json::parse(result.out)["ok"], true);
  }
  const ScratchDirectory scratch;
  const std::string bad = (scratch / "bad.nef2").string();
  for (const auto& [name, text] : contradictory_nef2()) {
    SCOPED_TRACE(name);
    write_file(bad, text);
    const RunResult result = run({"audit", bad});
    EXPECT_EQ(result.code, 1) << result.err;
    EXPECT_TRUE(result.out.starts_with("broken: ")) << result.out;
    EXPECT_EQ(result.err, "");
    EXPECT_EQ(Json::parse(run({"audit", bad, "--json"}).out)["ok"], false);
    expect_refusal(run({"plane", "info", bad}), bad + ":", ": ");
  }
  const RunResult map = run({"audit", "corpus/maps/us-counties.map"});
  EXPECT_EQ(map.code, 1);
  EXPECT_TRUE(contains(map.out, "not a planar subdivision")) << map.out;
  write_file(bad, "plumb-nef2 1\n0 0 0\n");
  expect_refusal(run({"audit", bad}), bad + ":2:", "number of edges");
}

TEST(PlaneProgram, triangulates) {
  const ScratchDirectory scratch;
  const std::string off = (scratch / "out.off").string();
  const RunResult result = run({"plane", "triangulate", kStar, "-o", off, "--json"});
  EXPECT_EQ(result.code, 0) << result.err;
  const Json counts = Json::parse(result.out);
  EXPECT_TRUE(read_file(off).starts_with("OFF\n" + counts["points"].dump() + " " +
                                         counts["triangles"].dump() + " 0\n"));
  const std::string layer = (scratch / "out.geojson").string();
  EXPECT_EQ(run({"plane", "triangulate", kStar, "-o", layer}).code, 0);
  EXPECT_NEAR(info(layer)["area"]["double"].get<double>(),
              info(kStar)["area"]["double"].get<double>(), 1e-9);
  expect_refusal(run({"plane", "triangulate", kCorner}), kCorner, "unbounded");
}

/// The cells fill the box, and the faces fill what the edges bound.
TEST(PlaneProgram, makes_cells_and_faces) {
  const ScratchDirectory scratch;
  const std::string cells = (scratch / "cells.geojson").string();
  const RunResult result =
      run({"plane", "voronoi", kStar, "--box", "-20,-20,20,20", "-o", cells, "--json"});
  EXPECT_EQ(result.code, 0) << result.err;
  EXPECT_EQ(Json::parse(result.out)["cells"], info(kStar)["vertices"]);
  EXPECT_EQ(info(cells)["area"]["exact"], "1600");
  expect_refusal(run({"plane", "voronoi", kStar, "--box", "1,2"}), "plumb", "--box");
  expect_refusal(run({"plane", "voronoi", kStar, "--box", "1,2,1,3"}), "plumb", "--box");
  const std::string faces = (scratch / "faces.geojson").string();
  EXPECT_EQ(run({"plane", "arrange", kStar, kFrame, "-o", faces}).code, 0);
  const Json layer = Json::parse(read_file(faces));
  EXPECT_GT(layer["features"].size(), 10U);
  EXPECT_EQ(layer["features"][0]["properties"]["in"], Json::array({kStar}));
}

}  // namespace
}  // namespace plumb::testing::plane_command_test
