// plumb surface ... from outside: known answers, formats, pictures, refusals.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <nlohmann/json.hpp>
#include <numbers>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "refusal.h"
#include "run_program.h"

namespace plumb::testing::surface_command_test {
namespace {

using Json = nlohmann::json;
using Words = std::vector<std::string>;
using Weights = std::array<double, 2>;

// ---------------------------------------------------------------- models and scenes

/// The square [0, n] x [0, n] in unit squares, each cut from lower left to upper right.
std::string grid_obj(int n) {
  std::ostringstream out;
  for (int y = 0; y <= n; ++y) {
    for (int x = 0; x <= n; ++x) out << "v " << x << ' ' << y << " 0\n";
  }
  for (int y = 0; y < n; ++y) {
    for (int x = 0; x < n; ++x) {
      const int a = (n + 1) * y + x + 1;
      out << "f " << a << ' ' << a + 1 << ' ' << a + n + 2 << "\nf " << a << ' ' << a + n + 2 << ' '
          << a + n + 1 << '\n';
    }
  }
  return out.str();
}

/// A torus of quads, `at` apart on the axis x: vertex i tube + j. Quad i tube + j lies between i, i
/// + 1 and j, j + 1.
std::string torus_obj(int ring, int tube, double at, int first_vertex) {
  std::ostringstream out;
  out.precision(17);
  for (int i = 0; i < ring; ++i) {
    for (int j = 0; j < tube; ++j) {
      const double s = 2 * std::numbers::pi * i / ring, t = 2 * std::numbers::pi * j / tube;
      const double r = 1 + .4 * std::cos(t);
      out << "v " << at + r * std::cos(s) << ' ' << r * std::sin(s) << ' ' << .4 * std::sin(t)
          << '\n';
    }
  }
  for (int i = 0; i < ring; ++i) {
    for (int j = 0; j < tube; ++j) {
      const int i2 = (i + 1) % ring, j2 = (j + 1) % tube;
      out << 'f';
      for (const int v : {i * tube + j, i2 * tube + j, i2 * tube + j2, i * tube + j2}) {
        out << ' ' << v + first_vertex;
      }
      out << '\n';
    }
  }
  return out.str();
}

/// Builds the text of a scene.
class SceneBuilder {
 public:
  explicit SceneBuilder(std::string model) : json_{{"model", std::move(model)}} {
    json_["points"] = Json::array();
    json_["polygons"] = Json::array();
  }
  /// A place of a grid of n x n squares, or the same on a torus of quads.
  std::size_t add(int n, double x, double y) {
    const int i = static_cast<int>(x), j = static_cast<int>(y);
    const double dx = x - i, dy = y - j;
    const int square = 2 * (n * j + i);
    json_["points"].push_back(dy <= dx ? Json{square, dx - dy, dy} : Json{square + 1, dx, dy - dx});
    return json_["points"].size() - 1;
  }
  std::size_t add_point(int face, double u, double v) {
    json_["points"].push_back({face, u, v});
    return json_["points"].size() - 1;
  }
  void add_polygon(const std::vector<std::size_t>& points) { json_["polygons"].push_back(points); }
  void add_box(int n, double x, double y, double x2, double y2) {
    const std::size_t a = add(n, x, y), b = add(n, x2, y), c = add(n, x2, y2), d = add(n, x, y2);
    add_polygon({a, b, c, d});
  }
  void set(const std::string& name, const Json& value) { json_[name] = value; }
  std::string text() const { return json_.dump(); }

 private:
  Json json_;
};

constexpr int kRing = 12, kTube = 8;

/// Around the tube of the torus, through the middles of the first triangles at i.
std::vector<std::size_t> add_meridian(SceneBuilder& scene, int i, bool is_upward) {
  std::vector<std::size_t> points;
  for (int k = 0; k < kTube; ++k) {
    const int j = is_upward ? k : kTube - 1 - k;
    points.push_back(scene.add_point(2 * (kTube * i + j), .25, .25));
  }
  scene.add_polygon(points);
  return points;
}
void add_longitude(SceneBuilder& scene, int j) {
  std::vector<std::size_t> points;
  for (int i = 0; i < kRing; ++i) points.push_back(scene.add_point(2 * (kTube * i + j), .25, .25));
  scene.add_polygon(points);
}

class SurfaceProgram : public ::testing::Test {
 protected:
  void SetUp() override {
    write_file(scratch_ / "grid.obj", grid_obj(20));
    write_file(scratch_ / "torus.obj", torus_obj(kRing, kTube, 0, 1));
    write_file(scratch_ / "tori.obj",
               torus_obj(kRing, kTube, 0, 1) + torus_obj(kRing, kTube, 4, kRing * kTube + 1));
  }
  std::string scene(const SceneBuilder& builder, const std::string& name = "scene.json") const {
    write_file(scratch_ / name, builder.text());
    return (scratch_ / name).string();
  }
  static Json answer(Words words) {
    words.push_back("--json");
    const RunResult result = run(words);
    EXPECT_EQ(result.code, 0) << result.err;
    return result.code == 0 ? Json::parse(result.out) : Json();
  }
  static Json cells(const std::string& file) { return answer({"surface", "cells", file}); }
  static void expect_boolean(const std::string& file, const std::string& op, double area,
                             std::size_t loops, const Words& more = {}) {
    Words words{"surface", "boolean", file, "--op", op};
    words.insert(words.end(), more.begin(), more.end());
    const Json json = answer(words);
    EXPECT_NEAR(json["area"].get<double>(), area, 1e-9) << op;
    EXPECT_EQ(json["loops"], loops) << op;
  }
  std::string two_boxes() const {
    SceneBuilder s("grid.obj");
    s.add_box(20, 2.25, 2.125, 10.25, 10.125);
    s.add_box(20, 6.5, 6.375, 14.5, 14.375);
    return scene(s);
  }

  const ScratchDirectory scratch_;
};

// ---------------------------------------------------------------- known answers

TEST_F(SurfaceProgram, two_boxes) {
  const std::string file = two_boxes();
  const Json json = cells(file);
  EXPECT_EQ(json["triangles"], 800);
  EXPECT_EQ(json["crossings"], 2);
  EXPECT_EQ(json["cells"], 4);
  EXPECT_EQ(json["cell_edges"], 4);
  EXPECT_EQ(json["labels"][0], Json::array());
  double sum = 0;
  for (const Json& area : json["areas"]) sum += area.get<double>();
  EXPECT_NEAR(sum, 400, 1e-9);
  const double common = 3.75 * 3.75;
  expect_boolean(file, "A + B", 128 - common, 1);
  expect_boolean(file, "A * B", common, 1);
  expect_boolean(file, "A - B", 64 - common, 1);
  expect_boolean(file, "A ^ B", 128 - 2 * common, 2);
  expect_boolean(file, "!(s0 + s1)", 400 - 128 + common, 1);
}

TEST_F(SurfaceProgram, nested_boxes_the_same_box_and_a_shared_side) {
  SceneBuilder nested("grid.obj");
  nested.add_box(20, 2.5, 2.25, 12.5, 12.25);
  nested.add_box(20, 4.5, 4.25, 8.5, 8.25);
  std::string file = scene(nested);
  expect_boolean(file, "A + B", 100, 1);
  expect_boolean(file, "A * B", 16, 1);
  expect_boolean(file, "A - B", 84, 2);
  SceneBuilder same("grid.obj");
  same.add_box(20, 2.5, 2.25, 10.5, 10.25);
  same.add_box(20, 2.5, 2.25, 10.5, 10.25);
  file = scene(same);
  EXPECT_EQ(cells(file)["cells"], 2);
  expect_boolean(file, "A + B", 64, 1);
  expect_boolean(file, "A * B", 64, 1);
  expect_boolean(file, "A - B", 0, 0);
  SceneBuilder shared("grid.obj");
  shared.add_box(20, 2.5, 2.25, 10.5, 10.25);
  shared.add_box(20, 10.5, 2.25, 14.5, 10.25);
  file = scene(shared);
  EXPECT_EQ(cells(file)["cells"], 3);
  expect_boolean(file, "A + B", 96, 1);
  expect_boolean(file, "A * B", 0, 0);
  expect_boolean(file, "A - B", 64, 1);
}

TEST_F(SurfaceProgram, boxes_on_mesh_lines_and_through_vertices) {
  SceneBuilder s("grid.obj");
  s.add_box(20, 2, 2, 6, 6);
  s.add_box(20, 4, 4, 9, 9);
  s.add_box(20, 6, 2, 8, 4);
  const std::string file = scene(s);
  expect_boolean(file, "A + B", 16 + 25 - 4, 1);
  expect_boolean(file, "A * B", 4, 1);
  expect_boolean(file, "A + C", 20, 1);
  expect_boolean(file, "B * C", 0, 0);
  expect_boolean(file, "B + C", 29, 1);  // they share the side from (6, 4) to (8, 4)
}

TEST_F(SurfaceProgram, a_figure_eight_by_every_rule) {
  SceneBuilder s("grid.obj");
  const std::size_t a = s.add(20, 4, 4), b = s.add(20, 10, 10), c = s.add(20, 10, 4),
                    d = s.add(20, 4, 10);
  s.add_polygon({a, b, c, d});
  const std::string file = scene(s);
  const Json json = cells(file);
  EXPECT_EQ(json["cells"], 3);
  EXPECT_EQ(json["crossings"], 1);
  expect_boolean(file, "A", 18, 2);
  expect_boolean(file, "A", 18, 2, {"--rule", "nonzero"});
  expect_boolean(file, "A", 9, 1, {"--rule", "positive"});
}

TEST_F(SurfaceProgram, meridians_of_a_torus) {
  SceneBuilder one("torus.obj");
  add_meridian(one, 2, true);
  const std::string file = scene(one);
  const Json lone = cells(file);
  EXPECT_EQ(lone["cells"], 1);
  EXPECT_EQ(lone["shapes"][0]["separates"], false);
  EXPECT_EQ(lone["shapes"][0]["separates_mod2"], false);
  EXPECT_FALSE(lone["shapes"][0]["cycle"].empty());
  expect_refusal(run({"surface", "boolean", file, "--op", "A"}), "plumb: --op 'A'",
                 "does not separate");
  for (const bool is_opposite : {true, false}) {
    SceneBuilder two("torus.obj");
    add_meridian(two, 2, true);
    add_meridian(two, 5, !is_opposite);
    two.set("shapes", {{0, 1}});
    const std::string pair = scene(two);
    const Json json = cells(pair);
    EXPECT_EQ(json["cells"], 2);
    EXPECT_EQ(json["polygons"][0]["separates"], false);
    EXPECT_EQ(json["shapes"][0]["separates"], is_opposite);
    EXPECT_EQ(json["shapes"][0]["separates_mod2"], true);
    const double a = json["areas"][0], b = json["areas"][1];
    EXPECT_NEAR(std::min(a, b) / (a + b), 3. / kRing, 1e-3);
    expect_boolean(pair, "A", json["labels"][0].empty() ? b : a, 2);
  }
  SceneBuilder both("torus.obj");
  add_meridian(both, 2, true);
  add_longitude(both, 3);
  EXPECT_EQ(cells(scene(both))["cells"], 1);
}

TEST_F(SurfaceProgram, repairs_on_request_what_does_not_separate) {
  SceneBuilder s("torus.obj");
  add_meridian(s, 2, true);
  add_longitude(s, 3);
  s.add_polygon({0, 1, 2, 3, 4, 5, 6, 7});
  s.set("shapes", {{0}, {1}, {0, 1}});
  const std::string file = scene(s);
  const Json json = answer({"surface", "cells", file, "--repair"});
  ASSERT_EQ(json["repairs"].size(), 3U);
  for (const Json& shape : json["shapes"]) EXPECT_EQ(shape["separates"], true);
  for (const Json& repair : json["repairs"]) {
    EXPECT_EQ(repair["class"].size(), 2U);
    EXPECT_FALSE(repair["polygons"].empty());
  }
  EXPECT_EQ(run({"surface", "boolean", file, "--op", "A * B"}).code, 2);
  EXPECT_EQ(run({"surface", "boolean", file, "--op", "A * B", "--repair"}).code, 0);
  EXPECT_FALSE(answer({"surface", "cells", two_boxes(), "--repair"}).contains("repairs"));
}

TEST_F(SurfaceProgram, a_box_on_each_of_two_tori) {
  SceneBuilder s("tori.obj");
  const int second = 2 * kRing * kTube;
  for (const int offset : {0, second}) {
    const auto at = [&](int i, int j) {
      return s.add_point(offset + 2 * (kTube * i + j), .25, .25);
    };
    const std::size_t a = at(2, 1), b = at(3, 1), c = at(3, 2), d = at(2, 2);
    s.add_polygon({a, b, c, d});
  }
  const std::string file = scene(s);
  const Json json = cells(file);
  EXPECT_EQ(json["cells"], 4);
  const double box = std::min(json["areas"][0].get<double>(), json["areas"][1].get<double>());
  expect_boolean(file, "A + B", 2 * box, 2);
  expect_boolean(file, "A * B", 0, 0);
  expect_boolean(file, "A - B", box, 1);
  SceneBuilder torn("tori.obj");
  const std::size_t a = torn.add_point(0, .25, .25), b = torn.add_point(second, .25, .25);
  torn.add_polygon({a, b});
  const std::string bad = scene(torn);
  expect_refusal(run({"surface", "cells", bad}), bad + ":1:", "different components");
}

TEST_F(SurfaceProgram, outside_may_be_named) {
  SceneBuilder s("grid.obj");
  s.add_box(20, 2.5, 2.25, 12.5, 12.25);
  s.set("outside", 2 * (20 * 5 + 5));
  expect_boolean(scene(s), "A", 300, 1, {"--rule", "nonzero"});
}

TEST_F(SurfaceProgram, shortest_paths) {
  SceneBuilder s("grid.obj");
  s.add(20, 2.25, 3.5);
  s.add(20, 14.25, 8.5);
  const std::string file = scene(s), out = (scratch_ / "path.obj").string();
  for (const Words& more : {Words{}, Words{"--local"}, Words{"--from", "1", "--to", "0"}}) {
    Words words{"surface", "path", file, "-o", out};
    words.insert(words.end(), more.begin(), more.end());
    const Json json = answer(words);
    EXPECT_NEAR(json["length"].get<double>(), 13, 1e-12);
    EXPECT_EQ(json["points"].size(), json["faces"].size() + 1);
    std::ifstream in(out);
    std::size_t vertices = 0;
    std::string line;
    while (std::getline(in, line) && line.starts_with("v ")) ++vertices;
    EXPECT_EQ(vertices, json["points"].size());
    EXPECT_TRUE(line.starts_with("l 1 2"));
  }
  EXPECT_EQ(run({"surface", "path", file, "--to", "0"}).out, "length 0, 0 segments\n");
  expect_refusal(run({"surface", "path", file, "--to", "2"}), "plumb: no point 2",
                 "the scene has 2");
  expect_refusal(run({"surface", "path", file, "-o", "path.off"}), "plumb: ", "-o OUT.obj");
  SceneBuilder torn("tori.obj");
  torn.add_point(0, .25, .25);
  torn.add_point(2 * kRing * kTube, .25, .25);
  expect_refusal(run({"surface", "path", scene(torn)}), "plumb: ", "different components");
}

TEST_F(SurfaceProgram, lengths_of_polygons) {
  const Json json = cells(two_boxes());
  for (const Json& polygon : json["polygons"]) EXPECT_NEAR(polygon["length"], 32, 1e-12);
}

// ---------------------------------------------------------------- files

TEST_F(SurfaceProgram, results_are_scenes_again) {
  const std::string file = two_boxes();
  fs::create_directories(scratch_ / "deeper");
  for (const std::string op : {"A + B", "A * B", "A - B", "A ^ B", "!A", "!(A + B)", "!(A - A)"}) {
    const std::string out = (scratch_ / "deeper/result.json").string();
    const Json first = answer({"surface", "boolean", file, "--op", op, "-o", out});
    // The model lies in another folder than the result.
    expect_boolean(out, "A", first["area"], first["loops"], {"--anywhere"});
    expect_boolean(out, "A", first["area"], first["loops"], {"--anywhere", "--rule", "positive"});
    expect_boolean(out, "!A", 400 - first["area"].get<double>(), first["loops"], {"--anywhere"});
  }
}

// What grows faster than the file, as cycles of many shapes do, is charged.
TEST_F(SurfaceProgram, memory_is_limited) {
  SceneBuilder s("torus.obj");
  add_meridian(s, 2, true);
  add_meridian(s, 7, true);
  s.set("shapes", std::vector<std::vector<int>>(30000, {0, 1}));
  const RunResult result = run({"surface", "cells", scene(s), "--json", "--limit-memory", "8"});
  EXPECT_EQ(result.code, 3);
  EXPECT_TRUE(result.out.empty());
}

TEST_F(SurfaceProgram, writes_cells_in_groups) {
  const std::string file = two_boxes();
  const auto written = [&](const std::string& name, const Words& command) {
    Words words = command;
    words.insert(words.end(), {"-o", (scratch_ / name).string()});
    EXPECT_EQ(run(words).code, 0);
    return read_file(scratch_ / name);
  };
  const Words all{"surface", "cells", file}, some{"surface", "boolean", file, "--op", "A - B"};
  const std::string obj = written("a.obj", all);
  for (const char* group : {"g cell_0\n", "g cell_1\n", "g cell_2\n", "g cell_3\n"}) {
    EXPECT_TRUE(contains(obj, group));
  }
  const std::string part = written("b.obj", some);
  EXPECT_TRUE(contains(part, "g cell_1\n") && !contains(part, "g cell_0\n"));
  EXPECT_EQ(run({"surface", "cells", file, "-o", (scratch_ / "a.ply").string()}).code, 0);
  EXPECT_TRUE(contains(written("a.ply", all), "property int cell"));
  const std::string glb = written("a.glb", all);
  EXPECT_EQ(glb.substr(0, 4), "glTF");
  EXPECT_TRUE(contains(glb, R"("name":"cell 3")"));
  const std::string dot = written("a.dot", all);
  EXPECT_TRUE(dot.starts_with("digraph cells {") && contains(dot, "c0 -> c1 [label=\"+0\"]"));
  // The triangles of a closed cell are a mesh that other commands read.
  const Json info = answer({"solid", "info", (scratch_ / "a.obj").string(), "--surface"});
  EXPECT_EQ(info["bounded"], true);
}

TEST_F(SurfaceProgram, draws_every_layer_in_every_format) {
  const std::string file = two_boxes();
  for (const std::string what : {"polygons", "slices", "cells", "labels", "result"}) {
    for (const std::string extension : {".png", ".svg", ".html", ".glb"}) {
      const fs::path out = scratch_ / ("picture" + extension);
      const RunResult result =
          run({"surface", "draw", file, "--what", what, "--op", "A ^ B", "-o", out.string()});
      EXPECT_EQ(result.code, 0) << result.err;
      EXPECT_GT(read_file(out).size(), 1000U);
    }
  }
  const std::string svg = read_file(scratch_ / "picture.svg");
  EXPECT_TRUE(contains(svg, "result"));
  run({"surface", "draw", file, "--what", "labels", "-o", (scratch_ / "l.svg").string()});
  const std::string labels = read_file(scratch_ / "l.svg");
  for (const char* text : {">A</text>", ">B</text>", ">A+B</text>", ">0</text>"}) {
    EXPECT_TRUE(contains(labels, text)) << text;
  }
  const std::string html = read_file(scratch_ / "picture.html");
  for (const char* name : {"polygons", "slices", "cells", "labels", "result"}) {
    EXPECT_TRUE(contains(html, "\"name\":\"" + std::string(name) + '"')) << name;
  }
}

/// Standard output holds what the file would.
TEST_F(SurfaceProgram, writes_to_standard_output) {
  const std::string file = two_boxes();
  for (const std::string format : {"obj", "ply", "glb", "dot"}) {
    const std::string out = (scratch_ / ("cells." + format)).string();
    EXPECT_EQ(run({"surface", "cells", file, "-o", out}).code, 0) << format;
    const RunResult direct = run({"surface", "cells", file, "--format", format});
    EXPECT_EQ(direct.code, 0) << direct.err;
    if (format != "glb") {  // which holds its name
      EXPECT_EQ(direct.out, read_file(out)) << format;
    }
    EXPECT_EQ(run({"surface", "cells", file, "--format", format, "-o", "-"}).out, direct.out);
  }
  // What is drawn of a result is what is selected: a mesh that other commands read.
  const std::string glb = (scratch_ / "result.glb").string();
  EXPECT_EQ(run({"surface", "boolean", file, "--op", "A ^ B", "-o", glb}).code, 0);
  EXPECT_EQ(answer({"solid", "info", glb, "--surface"})["bounded"], true);
  const RunResult svg = run({"surface", "draw", file, "--what", "cells", "--format", "svg"});
  EXPECT_TRUE(contains(svg.out, "</svg>")) << svg.err;
  EXPECT_EQ(run({"surface", "draw", file, "--what", "cells", "--format", "svg", "-o", "-"}).out,
            svg.out);
}

// ---------------------------------------------------------------- refusals

TEST_F(SurfaceProgram, tells_names_in_files_without_control_characters) {
  const std::string scene = (scratch_ / "orders.json").string();
  std::ofstream(scene)
      << R"({"model": "a\u001b[31m\nfake.json:1:1: b\u007f.off", "points": [], "polygons": []})";
  const RunResult result = run({"surface", "cells", scene});
  EXPECT_EQ(result.code, 2);
  EXPECT_TRUE(contains(result.err, "a?[31m?fake.json:1:1: b?.off")) << result.err;
  EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1) << result.err;
}

TEST_F(SurfaceProgram, refuses_what_cannot_be) {
  const std::string file = two_boxes();
  const auto boolean = [&](const std::string& op) {
    return run({"surface", "boolean", file, "--op", op, "-o", (scratch_ / "no.obj").string()});
  };
  expect_refusal(boolean("A +"), "plumb: --op", "is missing");
  expect_refusal(boolean("A + C"), "plumb: --op", "no shape is named C");
  EXPECT_FALSE(fs::exists(scratch_ / "no.obj"));
  expect_refusal(run({"surface", "cells", file, "-o", "-"}), "plumb: ", "-o - needs --format");
  expect_refusal(run({"surface", "cells", file, "--format", "obj", "--json"}),
                 "plumb: ", "cannot both be standard output");
  for (const Words& more : {Words{}, Words{"-o", "-"}}) {
    Words words{"surface", "draw", file, "--what", "cells"};
    words.insert(words.end(), more.begin(), more.end());
    expect_refusal(run(words), "plumb: ", "draw needs -o OUT");
  }
  expect_refusal(
      run({"surface", "draw", file, "--what", "result", "-o", (scratch_ / "no.png").string()}),
      "plumb: ", "needs --op");
  expect_refusal(run({"surface", "cells", file, "-o", (scratch_ / "a.xyz").string()}),
                 (scratch_ / "a.xyz").string() + ": ", "no format");
  const std::string bad = (scratch_ / "bad.json").string();
  write_file(bad, "{\"model\": \"grid.obj\",\n \"points\": [[800, 0, 0]], \"polygons\": []}");
  expect_refusal(run({"surface", "cells", bad, "--json"}), bad + ":2:13: ", "no face 800");
  write_file(scratch_ / "three.obj",
             "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nv 1 1 1\n"
             "f 1 2 3\nf 1 2 4\nf 1 2 5\n");
  write_file(bad, R"({"model": "three.obj", "points": [], "polygons": []})");
  expect_refusal(run({"surface", "cells", bad}), (scratch_ / "three.obj").string() + ": ",
                 "not a manifold");
}

}  // namespace
}  // namespace plumb::testing::surface_command_test
