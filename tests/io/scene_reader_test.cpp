// Scenes: what they say, where their points lie, and what is refused.

#include "plumb/io/scene_reader.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <memory>
#include <string>
#include <vector>

#include "expect_refusals.h"
#include "generate/surface_meshes.h"
#include "plumb/io/surface/scene_parser.h"
#include "plumb/predicates/error.h"
#include "plumb/surface/trace.h"

namespace plumb::testing::scene_reader_test {
namespace {

const ReadOptions kOptions{"some.file", false};
const ReadOptions kExact{"some.file", true};

SurfaceScene made(const std::string& text, const ReadOptions& options = kOptions,
                  SurfaceMesh mesh = grid_surface(2)) {
  Context context;
  return make_scene(parse_scene(text, options, context),
                    std::make_shared<const SurfaceMesh>(std::move(mesh)), text, options, context);
}

/// A scene of points on the grid of 2 x 2 squares, with one polygon.
std::string scene(const std::string& points, const std::string& polygon) {
  return R"({"model": "m.off", "points": [)" + points + R"(], "polygons": [[)" + polygon + "]]}";
}

TEST(scene_reader, says_what_is_written) {
  Context context;
  const ParsedScene text = parse_scene(
      R"({"model": "a/b.obj", "name": {"x": [1, {"y": "z"}, null, 2, -3, 4.5]}, "by": "hand", "n": null,
          "is": true, "of": 7, "outside": 7, "shapes": [[1, 0], []],
          "points": [[0, 0.25, 0.5], [1, 0, 1], [2, "1/3", "1/3"]], "polygons": [[0, 1, 2], [2]]})",
      kOptions, context);
  EXPECT_EQ(text.model, "a/b.obj");
  EXPECT_EQ(text.outside, 7U);
  EXPECT_EQ(text.points.face, (std::vector<std::uint32_t>{0, 1, 2}));
  EXPECT_EQ(text.points.weights.approx(0), (Point2{.25, .5}));
  EXPECT_EQ(text.points.weights.exact(2).x, Rational(1) / 3);
  EXPECT_EQ(text.polygons.items, (std::vector<std::uint32_t>{0, 1, 2, 2}));
  EXPECT_EQ(text.polygons.begin, (std::vector<std::uint32_t>{0, 3, 4}));
  EXPECT_EQ(text.shapes->begin, (std::vector<std::uint32_t>{0, 2, 2}));
}

TEST(scene_reader, points_lie_on_vertices_edges_and_in_faces) {
  const SurfaceScene s = made(scene(
      "[0, 0, 0], [0, 1, 0], [0, 0.0, 1e0], [0, 0.3, 0.7], [0, 0, 0.5], [0, 0.5, 0], [0, 0.2, 0.2]",
      "0"));
  const SurfacePointTable& p = s.polygons.points;
  ASSERT_EQ(p.size(), 7U);
  const std::vector<SurfacePlace> places{
      SurfacePlace::Vertex, SurfacePlace::Vertex, SurfacePlace::Vertex, SurfacePlace::Edge,
      SurfacePlace::Edge,   SurfacePlace::Edge,   SurfacePlace::Face};
  for (std::size_t i = 0; i < places.size(); ++i) {
    EXPECT_EQ(p.place(SurfacePointId(i)), places[i]) << i;
  }
  EXPECT_EQ(p.vertex(SurfacePointId(2)), VertexId(4));
}

/// Faces 0 and 1 of the grid share the diagonal from vertex 0 to vertex 4: (w, 0, u) and (1 - u, u,
/// 0).
TEST(scene_reader, one_point_from_two_faces) {
  for (int tenths = 1; tenths < 10; ++tenths) {
    const std::string t = "0." + std::to_string(tenths), rest = "0." + std::to_string(10 - tenths);
    const SurfaceScene s =
        made(scene("[0, 0, " + t + "], [1, " + t + ", 0], [2, 0.3, " + rest + "e-3], [0, " + t +
                       ", " + rest + "], [3, 0.1, " + rest + "e-2]",
                   "0"));
    const SurfacePointTable& p = s.polygons.points;
    EXPECT_TRUE(p.is_same(SurfacePointId(0), SurfacePointId(1))) << t;
    EXPECT_EQ(p.place(SurfacePointId(3)), SurfacePlace::Edge) << t;
  }
}

/// Face 0 is (0, 1, 4) and face 3 is (1, 5, 4): they share the edge from 1 to 4, given by its other
/// end.
TEST(scene_reader, decimals_that_no_doubles_add_up_to) {
  for (const ReadOptions& options : {kOptions, kExact}) {
    for (int hundredths = 1; hundredths < 100; ++hundredths) {
      const auto decimal = [](int n) { return (n < 10 ? "0.0" : "0.") + std::to_string(n); };
      const std::string t = decimal(hundredths), rest = decimal(100 - hundredths);
      const SurfaceScene s =
          made(scene("[0, " + rest + ", " + t + "], [3, 0, " + t + "]", "0, 1"), options);
      const SurfacePointTable& p = s.polygons.points;
      EXPECT_EQ(p.place(SurfacePointId(0)), SurfacePlace::Edge);
      EXPECT_TRUE(p.is_same(SurfacePointId(0), SurfacePointId(1))) << t;
      EXPECT_EQ(s.polygons.point.size(), 0U);
    }
  }
}

/// A fraction means itself, whatever is written beside it.
TEST(scene_reader, fractions_beside_decimals) {
  const SurfaceScene s =
      made(scene(R"([0, "1/3", 0.25], [0, "1/3", "1/4"], [0, 0, "1/3"], [1, "1/3", 0.0],
                                       [0, 0.1, "1/3"], [0, "2/3", "1/3"])",
                 "0"));
  const SurfacePointTable& p = s.polygons.points;
  EXPECT_TRUE(p.is_same(SurfacePointId(0), SurfacePointId(1)));
  EXPECT_TRUE(p.is_same(SurfacePointId(2), SurfacePointId(3)));
  EXPECT_EQ(p.exact(SurfacePointId(4)).x, Rational(0.1));
  EXPECT_EQ(p.exact(SurfacePointId(4)).y, Rational(1, 3));
  EXPECT_EQ(p.place(SurfacePointId(5)), SurfacePlace::Edge);
}

TEST(scene_reader, a_hair_inside_is_inside) {
  const SurfaceScene s =
      made(scene("[0, 1e-300, 0.5], [0, 0.5, 0.499999999999999], [0, 1e-17, 1e-17]", "0"));
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(s.polygons.points.place(SurfacePointId(i)), SurfacePlace::Face) << i;
  }
  const SurfaceScene beyond = made(scene("[0, 0.58, 0.42000000000000004], [0, -1e-17, 0.5]", "0"));
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(beyond.polygons.points.place(SurfacePointId(i)), SurfacePlace::Edge) << i;
  }
}

/// A weight below zero by a hair beside one above 1 by as much: they add up to 1.
TEST(scene_reader, a_hair_beyond_a_corner_is_the_corner) {
  const std::string above = R"("9007199254740993/9007199254740992")";
  const std::string below = R"("-1/9007199254740992")";
  const SurfaceScene s = made(scene(
      "[0, " + above + ", " + below + "], [0, " + below + ", " + above + "], [0, 1, " + below + "]",
      "0"));
  const SurfacePointTable& p = s.polygons.points;
  for (std::size_t i = 0; i < 3; ++i) {
    ASSERT_EQ(p.place(SurfacePointId(i)), SurfacePlace::Vertex) << i;
  }
  EXPECT_EQ(p.vertex(SurfacePointId(0)), VertexId(1));
  EXPECT_EQ(p.vertex(SurfacePointId(1)), VertexId(4));
  EXPECT_EQ(p.vertex(SurfacePointId(2)), VertexId(1));
}

/// Weights that a program computed so that they should add up to 1, but for the last bit.
TEST(scene_reader, a_rounding_below_one_is_one) {
  const std::string points =
      "[0, 0.58, 0.41999999999999998], [0, 0.1, 0.8999999999999999], [0, 0.5, 0.49999999999999978]";
  const SurfaceScene s = made(scene(points, "0"));
  const SurfaceScene exact = made(scene(points, "0"), kExact);
  const SurfaceScene fractions =
      made(scene(R"([0, "1/2", "4999999999999999/10000000000000000"])", "0"));
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(s.polygons.points.place(SurfacePointId(i)), SurfacePlace::Edge) << i;
    EXPECT_EQ(exact.polygons.points.place(SurfacePointId(i)), SurfacePlace::Face) << i;
  }
  EXPECT_EQ(fractions.polygons.points.place(SurfacePointId(0)), SurfacePlace::Face);
}

/// A decimal is the nearest double, and so zero.
TEST(scene_reader, weights_too_small_for_a_double) {
  const SurfaceScene s = made(scene("[0, 1e-5000, 0.5], [0, 0.5, -1e-400], [0, 1e-400, 0]", "0"));
  EXPECT_EQ(s.polygons.points.place(SurfacePointId(0)), SurfacePlace::Edge);
  EXPECT_EQ(s.polygons.points.place(SurfacePointId(1)), SurfacePlace::Edge);
  EXPECT_EQ(s.polygons.points.place(SurfacePointId(2)), SurfacePlace::Vertex);
}

/// Two triangles back to back share every edge: points name the face.
TEST(scene_reader, paths_run_in_the_face_that_points_name) {
  const std::vector<Point3> points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  for (const std::string face : {"0", "1"}) {
    const SurfaceScene s =
        made(scene("[" + face + ", 0.5, 0], [" + face + ", 0.5, 0.5], [" + face + ", 0, 0.5]",
                   "0, 1, 2"),
             kOptions, SurfaceMesh(points, {{0, 1, 2}, {0, 2, 1}}));
    ASSERT_EQ(s.polygons.face.size(), 3U);
    for (const FaceId f : s.polygons.face) EXPECT_EQ(f.value(), face == "0" ? 0U : 1U);
  }
}

TEST(scene_reader, no_shapes_and_levels) {
  const std::string head = R"({"model": "m", "points": [[0, 0.1, 0.1]], "polygons": [[0]], )";
  EXPECT_FALSE(made(head + R"("x": 1})").shapes.has_value());
  const SurfaceScene none = made(head + R"("shapes": []})");
  ASSERT_TRUE(none.shapes.has_value());
  EXPECT_TRUE(none.shapes->empty());
  const SurfaceScene s = made(head + R"("levels": [[0, 7, -2]]})");
  ASSERT_EQ(s.levels.size(), 1U);
  EXPECT_EQ(s.levels[0].face, FaceId(7));
  EXPECT_EQ(s.levels[0].label, -2);
}

TEST(scene_reader, faces_that_were_turned_around) {
  const std::vector<Point3> points{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  const SurfaceMesh mesh(points, {{0, 1, 2}, {0, 3, 2}});
  ASSERT_TRUE(mesh.is_flipped(FaceId(1)));
  const SurfaceScene s = made(scene("[1, 0.25, 0.5], [1, 0, 0.125], [0, 0, 0.125]", "0"), kOptions,
                              SurfaceMesh(points, {{0, 1, 2}, {0, 3, 2}}));
  const Point3 at = s.polygons.points.position(SurfacePointId(0));
  EXPECT_EQ(at, (Point3{.5, .75, 0}));
  EXPECT_TRUE(s.polygons.points.is_same(SurfacePointId(1), SurfacePointId(2)));
}

TEST(scene_reader, polygons_are_traced) {
  const SurfaceScene s =
      made(scene("[0, 0.5, 0.25], [7, 0.5, 0.25], [5, 0.25, 0.5]", "0, 1, 2, 2"));
  EXPECT_NO_THROW(require_valid(s.polygons));
  std::size_t controls = 0;
  for (const std::uint8_t is_control : s.polygons.is_control) controls += is_control;
  EXPECT_EQ(controls, 3U);
}

/// The room of the spider and the fly (tests/surface/shortest_strip_test.cpp).
TEST(scene_reader, paths_may_be_shortest) {
  const std::string head =
      R"({"model": "m", "points": [[8, "5/12", "1/2"], [10, "5/12", "1/12"]], "polygons": [[0, 1]])";
  const auto length = [&](const std::string& more) {
    std::vector<Point3> points;
    for (int i = 0; i < 8; ++i) {
      points.push_back({(i & 1) != 0 ? 30. : 0, (i & 2) != 0 ? 12. : 0, (i & 4) != 0 ? 12. : 0});
    }
    const SurfaceScene s = made(head + more + "}", kOptions,
                                SurfaceMesh(points, {{0, 2, 1},
                                                     {1, 2, 3},
                                                     {4, 5, 6},
                                                     {5, 7, 6},
                                                     {0, 1, 4},
                                                     {1, 5, 4},
                                                     {2, 6, 3},
                                                     {3, 6, 7},
                                                     {0, 4, 6},
                                                     {0, 6, 2},
                                                     {1, 3, 7},
                                                     {1, 7, 5}}));
    return polygon_length(s.polygons, 0);
  };
  EXPECT_NEAR(length(R"(, "paths": "shortest")"), 80, 1e-9);
  EXPECT_EQ(length(R"(, "paths": "local")"), length(""));
  EXPECT_GT(length(""), 80.1);
}

TEST(scene_reader, reads_the_model_beside_the_scene) {
  namespace fs = std::filesystem;
  const fs::path folder = fs::temp_directory_path() / "plumb-scene-test";
  fs::create_directories(folder / "meshes");
  std::ofstream(folder / "meshes" / "square.obj")
      << "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n";
  std::ofstream(folder / "a.json")
      << R"({"model": "meshes/square.obj", "points": [[0, 0.5, 0.25], [1, 0.5, 0.25]], "polygons": [[0, 1]]})";
  Context context;
  const SceneFile file = read_scene_file((folder / "a.json").string(), {}, context);
  EXPECT_EQ(file.scene.mesh->face_count(), 2U);
  EXPECT_EQ(file.scene.polygons.size(), 1U);
  std::ofstream(folder / "b.json") << R"({"model": "gone.obj", "points": [], "polygons": []})";
  try {
    read_scene_file((folder / "b.json").string(), {}, context);
    ADD_FAILURE() << "read a model that is not there";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::CannotOpen);
  }
  std::ofstream(folder / "meshes" / "three.obj")
      << "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nv 1 1 1\nf 1 2 3\nf 1 2 4\nf 1 2 5\n";
  std::ofstream(folder / "c.json")
      << R"({"model": "meshes/three.obj", "points": [], "polygons": []})";
  try {
    read_scene_file((folder / "c.json").string(), {}, context);
    ADD_FAILURE() << "read what is no manifold";
  } catch (const Error& error) {
    EXPECT_EQ(error.place().file, (folder / "meshes/three.obj").string());
  }
  fs::remove_all(folder);
}

/// A scene of a stranger must not show what other files hold.
TEST(scene_reader, names_no_file_outside_of_its_folder) {
  namespace fs = std::filesystem;
  const fs::path folder = fs::temp_directory_path() / "plumb-scene-test-outside";
  fs::create_directories(folder / "scenes");
  std::ofstream(folder / "secret.off") << "secret words\n";
  fs::remove(folder / "scenes" / "link.off");
  fs::create_symlink(folder / "secret.off", folder / "scenes" / "link.off");
  const std::string scene = (folder / "scenes" / "a.json").string();
  const std::string outside = (folder / "secret.off").string();
  Context context;
  for (const std::string& name : {outside, std::string("../secret.off"), std::string("link.off")}) {
    std::ofstream(scene) << R"({"model": ")" << name << R"(", "points": [], "polygons": []})";
    try {
      read_scene_file(scene, {}, context);
      ADD_FAILURE() << "read " << name;
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ErrorCode::CannotOpen);
      EXPECT_EQ(error.place().file, scene);
      EXPECT_EQ(std::string(error.what()).find("secret words"), std::string::npos);
      EXPECT_NE(std::string(error.what()).find("does not lie in the folder"), std::string::npos);
    }
  }
  std::ofstream(folder / "square.off") << "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
  std::ofstream(scene) << R"({"model": "../square.off", "points": [], "polygons": []})";
  ReadOptions anywhere;
  anywhere.named_files = NamedFiles::Anywhere;
  EXPECT_EQ(read_scene_file(scene, anywhere, context).scene.mesh->face_count(), 1U);
  fs::remove_all(folder);
}

/// A face that gives no triangle would shift the numbers of the faces after it.
TEST(scene_reader, refuses_models_with_faces_without_area) {
  namespace fs = std::filesystem;
  const fs::path folder = fs::temp_directory_path() / "plumb-scene-degenerate-test";
  fs::create_directories(folder);
  std::ofstream(folder / "a.json")
      << R"({"model": "m.obj", "points": [[1, 0.5, 0.25], [1, 0.25, 0.5]], "polygons": [[0, 1]]})";
  const auto read = [&](const std::string& face) {
    std::ofstream(folder / "m.obj")
        << "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3\n" + face + "f 1 3 4\nsurf 0 1\n";
    Context context;
    return read_scene_file((folder / "a.json").string(), {}, context);
  };
  EXPECT_EQ(read("").warnings,
            std::vector<std::string>{"geometry that was not read: free-form surfaces"});
  for (const std::string face : {"f 1 3\n", "f 2\n", "f\n", "f 1 3 3\n", "f 1 3 3 4\n"}) {
    try {
      read(face);
      ADD_FAILURE() << "read a model with " << face;
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ErrorCode::DegenerateFace) << face;
      EXPECT_EQ(error.place().file, (folder / "m.obj").string());
      EXPECT_NE(error.message().find("face 1"), std::string::npos) << error.message();
    }
  }
  std::ofstream(folder / "m.stl")
      << "solid\nfacet normal 0 0 1 outer loop vertex 0 0 0 vertex 0 0 0 "
         "vertex 1 0 0 endloop endfacet\nfacet normal 0 0 1 outer loop "
         "vertex 0 0 0 vertex 1 0 0 vertex 0 1 0 endloop endfacet\n"
         "endsolid\n";
  std::ofstream(folder / "b.json")
      << R"({"model": "m.stl", "points": [[0, 0.5, 0.25], [0, 0.25, 0.5]], "polygons": [[0, 1]]})";
  Context context;
  try {
    read_scene_file((folder / "b.json").string(), {}, context);
    ADD_FAILURE() << "read a model without its first face";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::DegenerateFace);
    EXPECT_EQ(error.place().file, (folder / "m.stl").string());
  }
  fs::remove_all(folder);
}

std::vector<HostileText> hostile_scenes() {
  const std::string head = R"({"model": "m", )";
  const std::string triangle = R"("points": [[0, 0.1, 0.1], [1, 0.1, 0.1], [2, 0.1, 0.1]], )";
  return {
      {"empty", "", 1, 1, "not JSON"},
      {"a list", "[]", 1, 1, "expected an object"},
      {"a number", " 7", 1, 2, "expected an object"},
      {"zero byte", head + R"("points": [], "polygons": []})" + std::string("\0\0x", 3), 1, 45,
       "byte 0x00"},
      {"no model", R"({"points": [], "polygons": []})", 1, 1, "needs \"model\""},
      {"no points", head + R"("polygons": []})", 1, 1, "needs \"points\""},
      {"no polygons", head + R"("points": []})", 1, 1, "needs \"polygons\""},
      {"cut off", head + R"("points": [[0, 0.)", 1, 33, "not JSON"},
      {"twice", head + "\n\"model\": \"n\"}", 2, 1, "given twice"},
      {"model no name", R"({"model": 7})", 1, 11, "expected a file name"},
      {"a text", R"("scene")", 1, 1, "expected an object"},
      {"model a list", R"({"model": []})", 1, 11, "expected a file name"},
      {"model an object", R"({"model": {}})", 1, 11, "expected a file name"},
      {"model with a zero", R"({"model": "a\u0000b"})", 1, 11, "expected a file name"},
      {"points an object", head + "\n\"points\": {}}", 2, 11, "expected a list"},
      {"outside a list", head + "\n\"outside\": [1]}", 2, 12, "index of a face"},
      {"outside a word", head + "\n\"outside\": true}", 2, 12, "index of a face"},
      {"outside negative", head + "\n\"outside\": -1}", 2, 12, "expected an index"},
      {"paths a number", head + "\n\"paths\": 1}", 2, 10, "\"local\" or \"shortest\""},
      {"paths of another kind", head + "\n\"paths\": \"long\"}", 2, 10, "\"shortest\""},
      {"outside huge", head + "\n\"outside\": 99999999999}", 2, 12, "too large"},
      {"polygon no list", head + "\n\"polygons\": [7]}", 2, 14, "a list of indices"},
      {"level no list", head + "\n\"levels\": [7]}", 2, 12, "a level [shape"},
      {"level no shape", head + "\n\"levels\": [[true]]}", 2, 13, "expected an index"},
      {"face a text", head + "\n\"points\": [[\"0\", 0, 0]]}", 2, 13, "index of a face"},
      {"weight empty", head + "\n\"points\": [[3, \"\", 0]]}", 2, 16, "a fraction"},
      {"weight with a blank", head + "\n\"points\": [[3, \"1 /3\", 0]]}", 2, 16, "a fraction"},
      {"weight escaped", head + "\n\"points\": [[3, \"1\\/3\", 0]]}", 2, 16, "a fraction"},
      {"model empty", R"({"model": ""})", 1, 11, "expected a file name"},
      {"model too long", R"({"model": ")" + std::string(4096, 'a') + "\"}", 1, 11, "a file name"},
      {"points no list", head + "\n\"points\": 3}", 2, 11, "expected a list"},
      {"point no list", head + "\n\"points\": [3]}", 2, 12, "expected a point"},
      {"point too short", head + "\n\"points\": [[3, 0.5]]}", 2, 19, "too few"},
      {"point too long", head + "\n\"points\": [[3, 0.5, 0.1, 0.2]]}", 2, 26, "too many"},
      {"face no integer", head + "\n\"points\": [[3.5, 0, 0]]}", 2, 13, "index of a face"},
      {"face negative", head + "\n\"points\": [[-3, 0, 0]]}", 2, 13, "index of a face"},
      {"face huge", head + "\n\"points\": [[99999999999, 0, 0]]}", 2, 13, "too large"},
      {"weight no number", head + "\n\"points\": [[3, true, 0]]}", 2, 16, "expected a number"},
      {"weight no fraction", head + "\n\"points\": [[3, \"x\", 0]]}", 2, 17, "expected"},
      {"weight over zero", head + "\n\"points\": [[3, \"1/0\", 0]]}", 2, 19, "denominator is 0"},
      {"outside below", head + "\n\"points\": [[3, -0.1, 0]]}", 2, 12, "outside its face"},
      {"outside above", head + "\n\"points\": [[3, 0.6, 0.6]]}", 2, 12, "outside its face"},
      {"outside far", head + "\n\"points\": [[3, 1e300, 1e300]]}", 2, 12, "outside its face"},
      {"number bomb", head + "\n\"points\": [[3, 1e999999999, 0]]}", 2, 26, "too large"},
      {"no face", head + "\n" + R"("points": [[8, 0, 0]], "polygons": []})", 2, 12, "no face 8"},
      {"no point", head + triangle + "\n\"polygons\": [[0, 3]]}", 2, 18, "no point 3"},
      {"index nested", head + triangle + "\n\"polygons\": [[[0]]]}", 2, 15, "expected an index"},
      {"index a string", head + triangle + "\n\"polygons\": [[\"0\"]]}", 2, 15,
       "expected an index"},
      {"index a decimal", head + triangle + "\n\"polygons\": [[0.0]]}", 2, 15, "expected an index"},
      {"no polygon", head + triangle + "\"polygons\": [[0]],\n\"shapes\": [[0, 1]]}", 2, 16,
       "no polygon 1"},
      {"outside no face", head + triangle + "\"polygons\": [],\n\"outside\": 8}", 2, 12,
       "no face 8"},
      {"no shape", head + triangle + "\"polygons\": [[0]],\n\"levels\": [[1, 0, 0]]}", 2, 12,
       "no shape 1"},
      {"level no face", head + triangle + "\"polygons\": [[0]],\n\"levels\": [[0, 8, 0]]}", 2, 12,
       "no face 8"},
      {"level twice", head + triangle + "\"polygons\": [[0]],\n\"levels\": [[0, 1, 0], [0, 2, 0]]}",
       2, 23, "second level"},
      {"level too short", head + triangle + "\"polygons\": [[0]],\n\"levels\": [[0, 1]]}", 2, 17,
       "too few"},
      {"level too long", head + triangle + "\"polygons\": [[0]],\n\"levels\": [[0, 1, 2, 3]]}", 2,
       22, "too many"},
      {"level no label", head + triangle + "\"polygons\": [[0]],\n\"levels\": [[0, 1, 0.5]]}", 2,
       19, "expected a label"},
      {"level huge", head + triangle + "\"polygons\": [[0]],\n\"levels\": [[0, 1, -99999999999]]}",
       2, 19, "too large"},
      {"deep", head + "\n\"points\": " + repeated("[", 100000), 2, 13, "index of a face"},
      {"not text", std::string("{\"model\": \"\xff\"}"), 1, 12, "not JSON"},
      {"after the end", head + triangle + "\"polygons\": []}\n}", 2, 1, "not JSON"},
  };
}

TEST(scene_reader, refuses_with_places) {
  expect_refusals(hostile_scenes(), [](const std::string& text) { made(text); });
}

TEST(scene_reader, deep_lists_in_members_without_meaning_are_passed_over) {
  const std::string deep = repeated("[", 50000) + repeated("]", 50000);
  EXPECT_NO_THROW(made(R"({"x": )" + deep + R"(, "model": "m", "points": [], "polygons": []})"));
}

TEST(scene_reader, control_points_on_two_components) {
  const std::vector<Point3> points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0},
                                   {5, 0, 0}, {6, 0, 0}, {5, 1, 0}};
  const SurfaceMesh mesh(points, {{0, 1, 2}, {3, 4, 5}});
  const std::string text = R"({"model": "m", "points": [[0, 0.5, 0.25], [1, 0.5, 0.25]],)"
                           "\n"
                           R"("polygons": [[0, 0], [0, 0, 1]]})";
  try {
    made(text, kOptions, mesh);
    ADD_FAILURE() << "traced from one component to another";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::BadShape);
    EXPECT_EQ(error.place().line, 2U);
    EXPECT_NE(error.message().find("point 0 (face 0) and point 1 (face 1)"), std::string::npos)
        << error.message();
  }
}

TEST(scene_reader, memory_is_limited) {
  std::string points = "[0,0.1,0.1]";
  for (int i = 0; i < 2000; ++i) points += ",[0,0.1,0.1]";
  Limits limits;
  limits.max_memory_bytes = 20000;
  Context context(limits);
  try {
    parse_scene(scene(points, "0"), kOptions, context);
    ADD_FAILURE() << "read beyond the limit";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::ResourceLimit);
    EXPECT_EQ(error.place().line, 1U);
  }
}

}  // namespace
}  // namespace plumb::testing::scene_reader_test
