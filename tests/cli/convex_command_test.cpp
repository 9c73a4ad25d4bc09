// The commands `plumb convex ...` from outside.

#include <gtest/gtest.h>

#include <array>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "plumb/predicates/rational.h"
#include "refusal.h"
#include "run_program.h"

namespace plumb::testing::convex_command_test {
namespace {

using Json = nlohmann::json;
using Words = std::vector<std::string>;

const std::string kBlock = "corpus/solids/l-block.off";

std::string polyhedron(const std::string& name) { return "corpus/polyhedra/test_" + name + ".off"; }

/// Two blocks that cross: of each the other cuts faces in several facets.
std::string crossing_blocks() {
  std::string points, faces;
  int first = 0;
  for (const auto& [x, y, z] : {std::array{9, 1, 1}, {1, 9, 1}}) {
    for (int i = 0; i < 8; ++i) {
      points += std::to_string(i & 1 ? x : -x) + " " + std::to_string(i & 2 ? y : -y) + " " +
                std::to_string(i & 4 ? z : -z) + "\n";
    }
    for (const auto& face : {std::array{0, 2, 3, 1},
                             {4, 5, 7, 6},
                             {0, 1, 5, 4},
                             {2, 6, 7, 3},
                             {0, 4, 6, 2},
                             {1, 3, 7, 5}}) {
      faces += "4";
      for (const int corner : face) faces += " " + std::to_string(first + corner);
      faces += "\n";
    }
    first += 8;
  }
  return "OFF\n16 12 0\n" + points + faces;
}

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

/// Writes an L-shaped prism whose faces have one of two materials, and returns its path.
std::string coloured_block(const ScratchDirectory& scratch, const std::string& name) {
  const std::string file = (scratch / (name + ".obj")).string();
  write_file(file, "mtllib " + name + ".mtl\n" +
                       "v 0 0 0\nv 2 0 0\nv 2 1 0\nv 1 1 0\nv 1 2 0\nv 0 2 0\n"
                       "v 0 0 1\nv 2 0 1\nv 2 1 1\nv 1 1 1\nv 1 2 1\nv 0 2 1\n"
                       "usemtl red\nf 6 5 4 3 2 1\nf 7 8 9 10 11 12\n"
                       "usemtl blue\nf 1 2 8 7\nf 2 3 9 8\nf 3 4 10 9\nf 4 5 11 10\n"
                       "f 5 6 12 11\nf 6 1 7 12\n");
  write_file((scratch / (name + ".mtl")).string(), "newmtl red\nKd 1 0 0\nnewmtl blue\nKd 0 0 1\n");
  return file;
}

TEST(ConvexProgram, decompose_keeps_materials) {
  const ScratchDirectory scratch;
  const std::string file = coloured_block(scratch, "block"), pieces = (scratch / "pieces").string();
  const RunResult result = run({"convex", "decompose", file, "--format", "obj", "-o", pieces});
  ASSERT_EQ(result.code, 0) << result.err;
  EXPECT_NE(result.err.find("faces on cuts have no attributes"), std::string::npos) << result.err;
  for (const std::string name : {"piece_0001", "piece_0002"}) {
    const std::string obj = read_file(pieces + "/" + name + ".obj"),
                      mtl = read_file(pieces + "/" + name + ".mtl");
    EXPECT_EQ(obj.find("mtllib " + name + ".mtl\n"), obj.find("mtllib")) << obj;
    EXPECT_NE(obj.find("usemtl red\n"), std::string::npos) << obj;
    EXPECT_NE(obj.find("usemtl blue\n"), std::string::npos) << obj;
    EXPECT_NE(mtl.find("newmtl red\n"), std::string::npos) << mtl;
  }
  // One note for all files, and none if nothing is kept.
  const std::string note = "not written, because the format does not hold them";
  const RunResult stl = run({"convex", "decompose", file, "--format", "stl", "-o", pieces});
  ASSERT_NE(stl.err.find(note), std::string::npos) << stl.err;
  EXPECT_EQ(stl.err.find(note, stl.err.find(note) + 1), std::string::npos) << stl.err;
  EXPECT_EQ(stl.err.find("faces on cuts"), std::string::npos) << stl.err;
  const RunResult plain =
      run({"convex", "decompose", file, "--format", "obj", "--keep", "none", "-o", pieces});
  EXPECT_EQ(plain.err.find("faces on cuts"), std::string::npos) << plain.err;
  EXPECT_EQ(read_file(pieces + "/piece_0001.obj").find("usemtl"), std::string::npos);
}

TEST(ConvexProgram, decompose_removes_no_library_of_its_input) {
  const ScratchDirectory scratch;
  const std::string file = coloured_block(scratch, "piece_0007");
  const std::string library = (scratch / "piece_0007.mtl").string(),
                    other = (scratch / "piece_0008.mtl").string();
  write_file(other, "newmtl old\n");
  const std::string folder = (scratch / "").string();
  ASSERT_EQ(run({"convex", "decompose", file, "-o", folder}).code, 0);
  EXPECT_TRUE(fs::exists(file));
  EXPECT_TRUE(fs::exists(library));
  EXPECT_FALSE(fs::exists(other));
}

TEST(ConvexProgram, decompose_by_every_method_and_in_every_format) {
  const ScratchDirectory scratch;
  for (const char* method : {"cuts", "walls"}) {
    const fs::path directory = scratch / method;
    const RunResult result = run({"convex", "decompose", kBlock, "--method", method, "--format",
                                  "nef", "-o", directory.string(), "--json"});
    ASSERT_EQ(result.code, 0) << result.err;
    const Json json = Json::parse(result.out);
    EXPECT_EQ(json["volume_matches"], true) << method;
    Words whole{"solid", "eval", "", "-o", (scratch / "whole.nef").string()};
    for (std::size_t i = 1; i <= json["pieces"]; ++i) {
      const std::string name = "piece_000" + std::to_string(i);
      EXPECT_EQ(run({"convex", "check", (directory / (name + ".nef")).string()}).code, 0) << name;
      whole[2] += (i == 1 ? "" : "+") + name;
      whole.push_back(name + "=" + (directory / (name + ".nef")).string());
    }
    EXPECT_EQ(run(whole).code, 0);
    EXPECT_EQ(run({"solid", "compare", whole[4], kBlock}).code, 0) << method;
  }
  for (const char* method : {"diagonals", "optimal"}) {
    expect_refusal(run({"convex", "decompose", kBlock, "--method", method}),
                   "plumb: ", "is for sets of the plane");
  }
  expect_refusal(run({"convex", "decompose", kBlock, "--svg", "-"}), "plumb: ", "needs a file");
}

TEST(ConvexProgram, decompose_leaves_no_folder_when_it_fails) {
  const ScratchDirectory scratch;
  const std::string far = (scratch / "far.off").string(), pieces = (scratch / "pieces").string();
  const std::string big = "1" + std::string(400, '0');
  write_file(far, "OFF\n4 4 0\n0 0 0\n" + big + " 0 0\n0 1 0\n0 0 1\n" +
                      "3 0 2 1\n3 0 1 3\n3 1 2 3\n3 0 3 2\n");
  EXPECT_EQ(run({"convex", "decompose", far, "-o", pieces}).code, 2);
  EXPECT_EQ(scratch.files(), std::vector<std::string>{"far.off"});
}

TEST(ConvexProgram, decompose_removes_pieces_of_an_earlier_run_alone) {
  const ScratchDirectory scratch;
  const fs::path directory = scratch / "pieces";
  fs::create_directories(directory);
  const std::vector<std::string> old{"piece_0003.off", "piece_12345.nef"};
  const std::vector<std::string> others{"piece_3.off",     "piece_00003.off", "piece_0003.txt",
                                        "piece_0003.off~", "apiece_0003.off", "notes"};
  for (const auto* names : {&old, &others}) {
    for (const std::string& name : *names) write_file(directory / name, name);
  }
  fs::create_directories(directory / "piece_0004.off");
  const std::string input = (directory / "piece_0007.off").string();
  fs::copy_file(kBlock, input);
  ASSERT_EQ(run({"convex", "decompose", input, "-o", directory.string()}).code, 0);
  EXPECT_TRUE(fs::is_directory(directory / "piece_0004.off"));
  EXPECT_EQ(read_file(input), read_file(kBlock)) << "what is read is not removed";
  for (const std::string& name : old) EXPECT_FALSE(fs::exists(directory / name)) << name;
  for (const std::string& name : others) EXPECT_TRUE(fs::exists(directory / name)) << name;
}

/// Two columns of two cubes each, of unit squares, that touch along an edge.
std::string touching_columns() {
  std::map<std::array<int, 3>, std::size_t> number;
  std::string points, faces;
  std::size_t count = 0;
  const auto corner = [&](std::array<int, 3> p) {
    const auto [at, is_new] = number.try_emplace(p, number.size());
    if (is_new) {
      points +=
          std::to_string(p[0]) + ' ' + std::to_string(p[1]) + ' ' + std::to_string(p[2]) + '\n';
    }
    return ' ' + std::to_string(at->second);
  };
  for (const int column : {0, 1}) {
    for (const int z : {0, 1}) {
      for (std::size_t axis = 0; axis < 3; ++axis) {
        for (const int end : {0, 1}) {
          if (axis == 2 && end != z) continue;  // between the two
          std::array<int, 3> low{column, column, z};
          low[axis] += end;
          std::array<int, 3> x = low, y = low, both = low;
          const std::size_t first = (axis + 1) % 3, second = (axis + 2) % 3;
          ++x[first], ++y[second], ++both[first], ++both[second];
          if (end == 0) std::swap(x, y);
          faces += '4' + corner(low) + corner(x) + corner(both) + corner(y) + '\n';
          ++count;
        }
      }
    }
  }
  return "OFF\n" + std::to_string(number.size()) + ' ' + std::to_string(count) + " 0\n" + points +
         faces;
}

// Faces of a mesh that is no manifold: all that fail, also those that are one facet of its set.
TEST(ConvexProgram, check_lists_every_face_that_fails) {
  const ScratchDirectory scratch;
  const std::string file = (scratch / "columns.off").string();
  write_file(file, touching_columns());
  for (const Words& more : {Words{}, Words{"--rule", "odd"}}) {
    Words words{"convex", "check", file, "--json"};
    words.insert(words.end(), more.begin(), more.end());
    const RunResult result = run(words);
    EXPECT_EQ(result.code, 1);
    const Json json = Json::parse(result.out);
    // Of each column's ten squares the four on the planes x = 1 and y = 1 have the other column
    // behind them.
    EXPECT_EQ(json["faces"].size(), 8U) << result.out;
    EXPECT_EQ(json["reflex_edges"],
              0);  // a quarter turn of solid on both sides of the edge they share
  }
}

// A set of several volumes: facets that come from one face are in its list once.
TEST(ConvexProgram, check_lists_faces_of_a_set_once_and_in_order) {
  const ScratchDirectory scratch;
  const std::string file = (scratch / "crossing.off").string();
  write_file(file, crossing_blocks());
  const RunResult result = run({"convex", "check", file, "--json"});
  EXPECT_EQ(result.code, 1);
  const auto faces = Json::parse(result.out)["faces"].get<std::vector<int>>();
  ASSERT_GT(faces.size(), 2U);
  for (std::size_t i = 1; i < faces.size(); ++i) EXPECT_LT(faces[i - 1], faces[i]);
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

TEST(ConvexProgram, decompose_cuts_sets_of_the_plane) {
  const ScratchDirectory scratch;
  const std::string file = (scratch / "frame.wkt").string();
  write_file(file, "POLYGON((0 0,4 0,4 4,0 4,0 0),(1 1,1 2,2 2,2 1,1 1))\n");
  const fs::path directory = scratch / "pieces";
  const RunResult result =
      run({"convex", "decompose", file, "--closed", "-o", directory.string(), "--json"});
  ASSERT_EQ(result.code, 0) << result.err;
  EXPECT_EQ(result.out, "{\"pieces\":4,\"reflex_edges\":4,\"volume_matches\":true}\n");
  EXPECT_EQ(result.err, "");  // closed polygons: WKT says all
  std::string whole = (directory / "piece_0001.wkt").string();
  for (const char* name : {"piece_0002.wkt", "piece_0003.wkt", "piece_0004.wkt"}) {
    const std::string sum = (scratch / name).string();
    ASSERT_EQ(run({"plane", "union", whole, (directory / name).string(), "-o", sum}).code, 0);
    whole = sum;
  }
  const RunResult difference = run({"plane", "symmetric-difference", whole, file, "--json"});
  EXPECT_EQ(Json::parse(difference.out)["empty"], true);
}

TEST(ConvexProgram, decompose_chooses_formats_and_methods_in_the_plane) {
  const ScratchDirectory scratch;
  const fs::path directory = scratch / "pieces";
  const RunResult outside = run({"convex", "decompose", "corpus/plane/quadrant.nef2", "-o",
                                 directory.string(), "--method", "cuts"});
  EXPECT_EQ(outside.code, 0) << outside.err;
  EXPECT_EQ(outside.out, "1 convex piece, 0 reflex corners\n");
  EXPECT_TRUE(fs::exists(directory / "piece_0001.nef2"));
  for (const char* method : {"diagonals", "optimal"}) {
    const RunResult star = run({"convex", "decompose", "corpus/plane/star.wkt", "--method", method,
                                "--format", "geojson", "-o", directory.string()});
    EXPECT_EQ(star.code, 0) << star.err;
    EXPECT_TRUE(fs::exists(directory / "piece_0002.geojson"));
  }
}

Rational area_of_file(const fs::path& file) {
  const Json info = Json::parse(run({"plane", "info", file.string(), "--json"}).out);
  return Rational(info["area"]["exact"].get<std::string>());
}

TEST(ConvexProgram, decompose_rounds_pieces_of_the_plane_together) {
  const ScratchDirectory scratch;
  const std::string a = (scratch / "a.wkt").string(), b = (scratch / "b.wkt").string();
  const std::string set = (scratch / "set.nef2").string();
  write_file(a, "POLYGON((0 0,7 1,3 3,6 8,1 5,-4 9,-1 4,0 0))\n");
  write_file(b, "POLYGON((-3 -1,5 2,4 11,1 4,-2 7,-3 -1))\n");
  ASSERT_EQ(run({"plane", "intersection", a, b, "-o", set}).code, 0);
  const fs::path directory = scratch / "pieces";
  const RunResult result =
      run({"convex", "decompose", set, "--method", "cuts", "-o", directory.string()});
  ASSERT_EQ(result.code, 0) << result.err;
  EXPECT_NE(result.err.find("1 piece is not quite convex"), std::string::npos) << result.err;
  // Pieces do not overlap: their areas add up to the area of their union.
  std::vector<std::string> files;
  Rational sum = 0;
  for (const fs::directory_entry& piece : fs::directory_iterator(directory)) {
    files.push_back(piece.path().string());
    sum += area_of_file(piece.path());
  }
  ASSERT_EQ(files.size(), 4U);
  std::string whole = files.front();
  for (std::size_t i = 1; i < files.size(); ++i) {
    const std::string next = (scratch / ("whole" + std::to_string(i) + ".nef2")).string();
    ASSERT_EQ(run({"plane", "union", whole, files[i], "-o", next}).code, 0);
    whole = next;
  }
  EXPECT_EQ(sum, area_of_file(whole));
}

TEST(ConvexProgram, check_takes_sets_of_the_plane) {
  EXPECT_EQ(run({"convex", "check", "corpus/plane/quadrant.nef2", "--json"}).out,
            "{\"convex\":true,\"reflex_edges\":0,\"faces\":[],\"corners\":[]}\n");
  const RunResult frame = run({"convex", "check", "corpus/plane/frame.geojson", "--json"});
  EXPECT_EQ(frame.code, 1);
  EXPECT_EQ(Json::parse(frame.out)["reflex_edges"], 4);
  EXPECT_EQ(Json::parse(frame.out)["faces"], Json{1});
  EXPECT_EQ(Json::parse(frame.out)["corners"].size(), 1U);
  const ScratchDirectory scratch;
  const std::string bent_line = (scratch / "bent.wkt").string();
  write_file(bent_line, "LINESTRING(0 0, 1 0, 1 1)\n");
  const std::string step_file = (scratch / "step.wkt").string();
  write_file(step_file, "POLYGON((0 0, 2 0, 2 1, 1/2 1, 1/2 2, 0 2, 0 0))\n");
  const RunResult bent = run({"convex", "check", bent_line});
  EXPECT_EQ(bent.code, 1);
  EXPECT_EQ(bent.out, "not convex\n0 reflex corners, 1 connected part\n");
  const RunResult step = run({"convex", "check", step_file});
  EXPECT_EQ(step.out,
            "not convex\n1 reflex corner, 1 connected part\n"
            "face 1: reflex corner at 1/2 1\n");
  EXPECT_EQ(Json::parse(run({"convex", "check", step_file, "--json"}).out)["corners"],
            Json::parse(R"([["1/2", "1"]])"));
  // The text rounds long numbers; here they are whole.
  const std::string far = "1" + std::string(300, '0');
  write_file(step_file, "POLYGON((0 0," + far + " 0," + far + " 1,2/" + far + " 1,2/" + far +
                            " 2,0 2,0 0))\n");
  EXPECT_EQ(Json::parse(run({"convex", "check", step_file, "--json"}).out)["corners"][0][0],
            "1/5" + std::string(299, '0'));
}

/// A tetrahedron, as the JSON of glTF.
const std::string kTetrahedronGltf =
    R"({"extras": {"type": "none \" {"}, "asset": {"version": "2.0"}, "scene": 0,
 "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],
 "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}],
 "accessors": [
  {"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3", "min": [0, 0, 0],
   "max": [1, 1, 1]},
  {"bufferView": 1, "componentType": 5121, "count": 12, "type": "SCALAR"}],
 "bufferViews": [{"buffer": 0, "byteLength": 48}, {"buffer": 0, "byteOffset": 48, "byteLength": 12}],
 "buffers": [{"byteLength": 60, "uri": "data:application/octet-stream;base64,)"
    "AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAA"
    "gD8AAAAAAAAAAAAAAAAAAIA/AAIBAAEDAQIDAAMC"
    R"("}]})";

// Told from GeoJSON, which begins with the same brace.
TEST(ConvexProgram, takes_gltf_without_an_extension_for_a_solid) {
  const ScratchDirectory scratch;
  const std::string file = (scratch / "tetrahedron").string();
  write_file(file, kTetrahedronGltf);
  RunOptions from_file;
  from_file.in = file;
  EXPECT_EQ(run({"convex", "check", "-"}, from_file).out, "convex\n");
  EXPECT_EQ(run({"convex", "decompose", "-"}, from_file).out, "1 convex piece, 0 reflex edges\n");
  EXPECT_EQ(run({"audit", file}).code, 0);
  const std::string picture = (scratch / "a.svg").string();
  const RunResult drawn = run({"view", file, "-o", picture, "--json"});
  EXPECT_EQ(drawn.out, "{\"kind\":\"solid\",\"format\":\"svg\"}\n") << drawn.err;
  from_file.in = "corpus/plane/frame.geojson";
  EXPECT_EQ(run({"convex", "check", "-"}, from_file).code, 1);
  const std::string tagged = (scratch / "tagged").string();
  write_file(tagged, R"({"asset": {}, "type": "Point", "coordinates": [1, 2]})");
  EXPECT_EQ(run({"convex", "check", tagged}).out, "convex\n");
}

TEST(ConvexProgram, decompose_draws_pieces) {
  const ScratchDirectory scratch;
  for (const auto& [file, mark] : {std::pair{"corpus/plane/star.wkt", "class=\"piece\""},
                                   std::pair{"corpus/plane/quadrant.nef2", "class=\"piece\""},
                                   std::pair{"corpus/solids/l-block.off", "cuts hatched"}}) {
    const std::string picture = (scratch / "pieces.svg").string();
    const RunResult result = run({"convex", "decompose", file, "--svg", picture, "--json"});
    ASSERT_EQ(result.code, 0) << result.err;
    const std::string svg = read_file(picture);
    EXPECT_TRUE(svg.starts_with("<svg")) << file;
    EXPECT_NE(svg.find(mark), std::string::npos) << file;
  }
  const std::string outside = (scratch / "outside.nef").string();
  run({"solid", "complement", kBlock, "-o", outside});
  const std::string none = (scratch / "none.svg").string();
  const RunResult refused = run({"convex", "decompose", outside, "--svg", none});
  EXPECT_EQ(refused.code, 2);
  EXPECT_EQ(refused.err, outside + ": --svg draws the pieces of bounded solids only\n");
  EXPECT_FALSE(fs::exists(none));
}

TEST(ConvexProgram, decompose_draws_no_cuts_where_none_are) {
  const ScratchDirectory scratch;
  const std::string file = (scratch / "thin.wkt").string();
  const std::string picture = (scratch / "thin.svg").string();
  write_file(file, "GEOMETRYCOLLECTION(LINESTRING(0 0,5 5),POINT(7 1))\n");
  ASSERT_EQ(run({"convex", "decompose", file, "--svg", picture}).code, 0);
  EXPECT_EQ(read_file(picture).find("between two pieces"), std::string::npos);
  ASSERT_EQ(run({"convex", "decompose", "corpus/plane/star.wkt", "--svg", picture}).code, 0);
  EXPECT_NE(read_file(picture).find("between two pieces"), std::string::npos);
}

TEST(ConvexProgram, decompose_keeps_picture_and_pieces_apart) {
  const ScratchDirectory scratch;
  const std::string outside = (scratch / "outside.nef").string();
  run({"solid", "complement", kBlock, "-o", outside});
  const std::string pieces = (scratch / "pieces").string();
  const std::string star = "corpus/plane/star.wkt";
  for (const auto& [file, picture] : {std::pair{outside, "/a.svg"},
                                      {star, "/piece_0001.wkt"},
                                      {star, "/../pieces/piece_0070.nef2"},
                                      {kBlock, "/piece_0001.off"}}) {
    const RunResult result =
        run({"convex", "decompose", file, "-o", pieces, "--svg", pieces + picture});
    EXPECT_EQ(result.code, 2) << picture;
    EXPECT_NE(result.err, "");
    EXPECT_EQ(scratch.files(), std::vector<std::string>{"outside.nef"}) << picture;
  }
  const std::string beside = pieces + "/piece_0001.svg";
  EXPECT_EQ(run({"convex", "decompose", star, "-o", pieces, "--svg", beside}).code, 0);
  EXPECT_TRUE(read_file(beside).starts_with("<svg"));
  EXPECT_TRUE(fs::exists(pieces + "/piece_0001.wkt"));
}

TEST(ConvexProgram, says_where_a_solid_is_needed) {
  for (const Words& words :
       {Words{"convex", "minkowski", "corpus/plane/star.wkt", "corpus/plane/star.wkt"},
        Words{"convex", "minkowski", kBlock, "corpus/plane/quadrant.nef2"},
        Words{"convex", "report", "corpus/plane/frame.geojson"},
        Words{"convex", "check", "corpus/maps/us-states.clean.map"},
        Words{"solid", "info", "corpus/plane/star.wkt"}}) {
    const RunResult result = run(words);
    EXPECT_EQ(result.code, 2);
    EXPECT_EQ(result.out, "");
    EXPECT_NE(result.err.find(", where a solid is needed: .off"), std::string::npos) << result.err;
  }
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
        std::vector<std::string>{"convex", "decompose", kBlock, "--method", "luck"},
        std::vector<std::string>{"convex", "decompose", kBlock, "--method", "optimal"},
        std::vector<std::string>{"convex", "decompose", "corpus/plane/star.wkt", "--method",
                                 "walls"},
        std::vector<std::string>{"convex", "decompose", "corpus/plane/star.wkt", "--surface"},
        std::vector<std::string>{"convex", "check", "corpus/plane/star.wkt", "--surface"},
        std::vector<std::string>{"convex", "decompose", "corpus/plane/frame.geojson", "--method",
                                 "optimal"}}) {
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
}  // namespace plumb::testing::convex_command_test
