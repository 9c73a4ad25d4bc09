// The command `plumb view` from outside: every kind of file as every kind of picture.

#include <gtest/gtest.h>

#include <cstring>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <vector>

#include "refusal.h"
#include "run_program.h"

namespace plumb::testing::view_command_test {
namespace {

using Json = nlohmann::json;
using Words = std::vector<std::string>;

const std::string kBlock = "corpus/solids/l-block.off";

struct Sample {
  std::string file;
  std::string kind;
};

const std::vector<Sample> kSamples{
    {"corpus/maps/world-countries.clean.map", "map"},
    {"corpus/maps/world-countries.map", "map"},
    {"corpus/plane/star.wkt", "plane"},
    {"corpus/plane/frame.geojson", "plane"},
    {"corpus/plane/quadrant.nef2", "plane"},
    {kBlock, "solid"},
    {"corpus/solids/l-block.obj", "solid"},
    {"corpus/solids/l-block.ply", "solid"},
    {"corpus/solids/tetrahedron.stl", "solid"},
    {"corpus/solids/tetrahedron.binary.stl", "solid"},
};

std::uint32_t word_at(const std::string& bytes, std::size_t at) {
  std::uint32_t word = 0;
  std::memcpy(&word, bytes.data() + at, sizeof word);
  return word;
}

/// The two chunks of a GLB, and that the header tells their sizes.
std::pair<Json, std::string> chunks_of(const std::string& glb) {
  EXPECT_EQ(glb.substr(0, 4), "glTF");
  EXPECT_EQ(word_at(glb, 4), 2U);
  EXPECT_EQ(word_at(glb, 8), glb.size());
  const std::uint32_t text = word_at(glb, 12);
  EXPECT_EQ(glb.substr(16, 4), "JSON");
  EXPECT_EQ(text % 4, 0U);
  const Json json = Json::parse(glb.substr(20, text));
  if (20 + text == glb.size()) return {json, ""};
  const std::uint32_t data = word_at(glb, 20 + text);
  EXPECT_EQ(glb.substr(24 + text, 4), std::string_view("BIN\0", 4));
  EXPECT_EQ(28 + text + data, glb.size());
  return {json, glb.substr(28 + text)};
}

/// Accessors lie in their views, views in the buffer, indices below the number of vertices.
void expect_glb(const std::string& glb) {
  const auto [json, data] = chunks_of(glb);
  EXPECT_EQ(json["asset"]["version"], "2.0");
  EXPECT_LE(json["buffers"][0]["byteLength"], data.size());
  for (const Json& primitive : json["meshes"][0]["primitives"]) {
    const Json& position =
        json["accessors"][primitive["attributes"]["POSITION"].get<std::size_t>()];
    const Json& index = json["accessors"][primitive["indices"].get<std::size_t>()];
    EXPECT_EQ(position["min"].size(), 3U);
    const bool has_triangles = primitive["mode"] == 4;
    EXPECT_EQ(has_triangles, primitive["attributes"].contains("NORMAL"));
    EXPECT_EQ(index["count"].get<std::size_t>() % (has_triangles ? 3 : 2), 0U);
    const Json& view = json["bufferViews"][index["bufferView"].get<std::size_t>()];
    EXPECT_EQ(view["byteLength"], 4 * index["count"].get<std::size_t>());
    const std::size_t begin = view["byteOffset"];
    for (std::size_t i = 0; i < index["count"]; ++i) {
      EXPECT_LT(word_at(data, begin + 4 * i), position["count"].get<std::uint32_t>());
    }
  }
}

void expect_html(const std::string& html, const std::string& title) {
  EXPECT_TRUE(html.starts_with("<!DOCTYPE html>"));
  EXPECT_TRUE(html.ends_with("</html>\n"));
  EXPECT_TRUE(contains(html, "<title>" + title + "</title>"));
  for (const std::string foreign : {"src=\"http", "href=\"http", "url(http", "@import", "fetch("}) {
    EXPECT_FALSE(contains(html, foreign)) << foreign;
  }
}

class ViewProgram : public ::testing::Test {
 protected:
  std::string drawn(const std::string& file, const std::string& name,
                    const Words& more = {}) const {
    Words words{"view", file, "-o", (scratch_ / name).string()};
    words.insert(words.end(), more.begin(), more.end());
    const RunResult result = run(words);
    EXPECT_EQ(result.code, 0) << file << ": " << result.err;
    return read_file(scratch_ / name);
  }
  std::string made(Words words, const std::string& name) const {
    words.insert(words.end(), {"-o", (scratch_ / name).string()});
    EXPECT_EQ(run(words).code, 0);
    return (scratch_ / name).string();
  }

  const ScratchDirectory scratch_;
};

TEST_F(ViewProgram, draws_every_kind_of_file) {
  for (const auto& [file, kind] : kSamples) {
    const std::string title = fs::path(file).filename();
    EXPECT_TRUE(drawn(file, "a.png").starts_with("\x89PNG\r\n\x1a\n")) << file;
    const std::string svg = drawn(file, "a.svg");
    EXPECT_TRUE(svg.starts_with("<svg") && contains(svg, title)) << file;
    expect_html(drawn(file, "a.html"), title);
    expect_glb(drawn(file, "a.glb"));
    const RunResult told = run({"view", file, "-o", (scratch_ / "a.svg").string(), "--json"});
    EXPECT_EQ(Json::parse(told.out), Json({{"kind", kind}, {"format", "svg"}})) << file;
  }
}

/// What comes from standard input is told by how it begins.
TEST_F(ViewProgram, tells_what_standard_input_is) {
  for (const auto& [file, kind] : kSamples) {
    RunOptions from_file;
    from_file.in = file;
    const RunResult told =
        run({"view", "-", "-o", (scratch_ / "a.svg").string(), "--json"}, from_file);
    EXPECT_EQ(told.code, 0) << file << told.err;
    EXPECT_EQ(Json::parse(told.out)["kind"], kind) << file;
  }
}

/// Its header is free: it may begin like a map, or like WKT.
TEST_F(ViewProgram, tells_binary_stl_by_its_length) {
  const std::string stl = made(
      {"solid", "closure", "corpus/solids/l-block.obj", "--format", "stl-binary"}, "block.stl");
  const std::string bytes = read_file(stl);
  for (const std::string header : {"3D cube", "POINT of a drill"}) {
    RunOptions from_file;
    from_file.in = (scratch_ / "any").string();
    write_file(from_file.in, header + std::string(80 - header.size(), '\0') + bytes.substr(80));
    const RunResult told = run({"solid", "info", "-", "--json"}, from_file);
    EXPECT_EQ(told.code, 0) << header << told.err;
  }
}

TEST_F(ViewProgram, draws_sets_that_are_no_solids) {
  const std::string open = made({"solid", "interior", kBlock}, "open.nef");
  EXPECT_TRUE(contains(drawn(open, "a.svg"), "open facet"));
  const std::string flat = made({"solid", "boundary", kBlock}, "flat.nef");
  EXPECT_TRUE(contains(drawn(flat, "a.svg"), "sheet"));
  const std::string rest = made({"solid", "complement", kBlock}, "rest.nef");
  EXPECT_TRUE(contains(drawn(rest, "a.svg"), "goes on to infinity"));
  const std::string nothing = made({"solid", "difference", kBlock, kBlock}, "nothing.nef");
  EXPECT_TRUE(contains(drawn(nothing, "a.svg"), "no point at all"));
  const std::string all = made({"solid", "union", rest, kBlock}, "all.nef");
  EXPECT_TRUE(contains(drawn(all, "a.svg"), "every point"));
  for (const std::string& file : {open, flat, rest, nothing, all}) {
    EXPECT_TRUE(drawn(file, "a.png").starts_with("\x89PNG"));
    expect_html(drawn(file, "a.html"), fs::path(file).filename());
    EXPECT_EQ(drawn(file, "a.glb").substr(0, 4), "glTF");
  }
}

TEST_F(ViewProgram, sheets_need_no_volume) {
  write_file(scratch_ / "open.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
  const std::string file = (scratch_ / "open.off").string();
  expect_refusal(run({"view", file, "-o", (scratch_ / "a.svg").string()}), file, "--surface");
  EXPECT_FALSE(fs::exists(scratch_ / "a.svg"));
  EXPECT_TRUE(contains(drawn(file, "a.svg", {"--surface"}), "sheet"));
}

/// Names and coordinates as nobody should choose them.
TEST_F(ViewProgram, survives_odd_names_and_places) {
  const std::string name = "<b>&\"' \xff.off";
  write_file(scratch_ / name,
             "OFF\n4 4 0\n1e300 0 0\n-1e300 5e-324 0\n0 1e300 0\n0 0 1e-300\n"
             "3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n");
  for (const std::string picture : {"a.png", "a.svg", "a.html", "a.glb"}) {
    const std::string bytes = drawn((scratch_ / name).string(), picture);
    EXPECT_FALSE(picture != "a.glb" && contains(bytes, "<b>&")) << picture;
    EXPECT_FALSE(contains(bytes, ":nan") || contains(bytes, "null,")) << picture;
  }
}

TEST_F(ViewProgram, shows_colours) {
  write_file(scratch_ / "a.mtl", "newmtl red\nKd 1 0 0\nnewmtl blue\nKd 0 0 1\n");
  const std::string file = (scratch_ / "a.obj").string();
  write_file(file,
             "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nusemtl red\nf 1 3 2\nf 1 2 4\n"
             "usemtl blue\nf 2 3 4\nf 1 4 3\n");
  const auto materials = [&](const Words& more) {
    const auto [json, data] = chunks_of(drawn(file, "a.glb", more));
    return json["materials"].dump();
  };
  const std::string coloured = materials({}), plain = materials({"--keep", "none"});
  EXPECT_TRUE(contains(coloured, "#ff0000")) << coloured;
  EXPECT_TRUE(contains(coloured, "#0000ff")) << coloured;
  EXPECT_FALSE(contains(plain, "#ff0000")) << plain;
  EXPECT_TRUE(contains(drawn(file, "a.html"), "colours"));
}

/// A PNG file of one grey pixel.
std::string tiny_png() {
  const std::string_view bytes(
      "\x89PNG\r\n\x1a\n\0\0\0\rIHDR\0\0\0\1\0\0\0\1\x08\0\0\0\0\x3a\x7e\x9b\x55"
      "\0\0\0\nIDATx\x9c\x63\x68\0\0\0\x82\0\x81\x77\xcd\x72\xb6\0\0\0\0IEND\xae\x42\x60\x82",
      67);
  return std::string(bytes);
}

// The image lies beside the mesh. Images elsewhere are not opened, and what is no image or too wide
// is not embedded.
TEST_F(ViewProgram, shows_textures) {
  const std::string png = tiny_png();
  const std::string file = (scratch_ / "below/a.obj").string();
  fs::create_directory(scratch_ / "below");
  write_file(file,
             "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nvt 0 0\nvt 1 0.25\nvt 0 1\n"
             "usemtl a\nf 1/1 3/2 2/3\nf 1/1 2/2 4/3\nusemtl b\nf 2 3 4\nf 1 4 3\n");
  const auto with_texture = [&](const std::string& name) {
    write_file(scratch_ / "below/a.mtl", "newmtl a\nKd 1 0 0\nmap_Kd " + name + "\nnewmtl b\n");
  };
  write_file(scratch_ / "below/a.png", png);
  with_texture("a.png");
  EXPECT_TRUE(contains(drawn(file, "a.html"), "[\"data:image/png;base64,iVBORw0KGgo"));
  const std::string glb = drawn(file, "a.glb");
  expect_glb(glb);
  const auto [json, data] = chunks_of(glb);
  EXPECT_EQ(json["images"].size(), 1U);
  const Json& view = json["bufferViews"][json["images"][0]["bufferView"].get<std::size_t>()];
  EXPECT_EQ(data.substr(view["byteOffset"], view["byteLength"]), png);
  std::size_t textured = 0;
  for (const Json& mesh : json["meshes"]) {
    const Json& primitive = mesh["primitives"][0];
    if (!primitive["attributes"].contains("TEXCOORD_0")) continue;
    ++textured;
    const Json& material = json["materials"][primitive["material"].get<std::size_t>()];
    EXPECT_EQ(material["pbrMetallicRoughness"]["baseColorTexture"]["index"], 0);
    EXPECT_EQ(json["accessors"][primitive["indices"].get<std::size_t>()]["count"], 6);
    const Json& places =
        json["accessors"][primitive["attributes"]["TEXCOORD_0"].get<std::size_t>()];
    EXPECT_EQ(places["count"], 6);
    const std::size_t at =
        json["bufferViews"][places["bufferView"].get<std::size_t>()]["byteOffset"];
    std::multiset<float> heights;  // v points down in glTF.
    for (std::size_t i = 0; i < 6; ++i) {
      float v = 0;
      std::memcpy(&v, data.data() + at + 8 * i + 4, sizeof v);
      heights.insert(v);
    }
    EXPECT_EQ(heights, (std::multiset<float>{0, 0, 0.75, 0.75, 1, 1}));
  }
  EXPECT_EQ(textured, 1U);

  const auto told = [&](const std::string& picture) {
    const RunResult result = run({"view", file, "-o", (scratch_ / picture).string()});
    EXPECT_EQ(result.code, 0);
    EXPECT_TRUE(picture.ends_with(".png") || !contains(read_file(scratch_ / picture), "image/png"));
    return result.err;
  };
  EXPECT_TRUE(contains(told("a.png"), "textures are not drawn"));
  write_file(scratch_ / "secret.png", png);
  with_texture("../secret.png");
  EXPECT_TRUE(contains(told("a.html"), "does not lie in the folder"));
  with_texture("absent.png");
  EXPECT_TRUE(contains(told("a.html"), "No such file"));
  with_texture("a.mtl");
  EXPECT_TRUE(contains(told("a.html"), "neither a PNG nor a JPEG"));
  std::string wide = png;
  wide[17] = 1;  // 65537 pixels.
  write_file(scratch_ / "below/wide.png", wide);
  with_texture("wide.png");
  EXPECT_TRUE(contains(told("a.glb"), "wider or higher than 16384"));
}

TEST_F(ViewProgram, wrong_usage_is_refused) {
  expect_refusal(run({"view", kBlock}), "plumb: ", "view needs -o OUT");
  expect_refusal(run({"view", kBlock, "-o", "-"}), "plumb: ", "--format png, svg, html, glb");
  expect_refusal(run({"view", kBlock, "-o", (scratch_ / "a.off").string()}), "", "use .png");
  expect_refusal(run({"view", "no-such.off", "-o", (scratch_ / "a.svg").string()}), "no-such.off",
                 "No such file");
  EXPECT_TRUE(scratch_.files().empty());
  EXPECT_TRUE(run({"view", kBlock, "-o", "-", "--format", "glb"}).out.starts_with("glTF"));
}

TEST_F(ViewProgram, draws_several_solids_moved_apart) {
  const ScratchDirectory scratch;
  const std::string out = (scratch / "out").string();
  const Words files{kBlock, "corpus/solids/tetrahedron.off"};
  for (const char* extension : {".png", ".svg", ".html", ".glb"}) {
    Words arguments{"view", files[0], files[1], "--explode", "0.3", "-o", out + extension};
    EXPECT_EQ(run(arguments).code, 0) << extension;
    EXPECT_GT(fs::file_size(out + extension), 1000U);
  }
  EXPECT_NE(read_file(out + ".html").find("l-block.off and 1 more"), std::string::npos);
  // Moved further apart they make another picture.
  EXPECT_EQ(run({"view", files[0], files[1], "--explode", "3", "-o", out + "2.png"}).code, 0);
  EXPECT_NE(read_file(out + ".png"), read_file(out + "2.png"));
  EXPECT_EQ(run({"view", kBlock, "--explode", "1", "-o", out + ".png"}).code, 0);
  for (const char* wrong : {"-1", "nan", "far"}) {
    expect_refusal(run({"view", kBlock, "--explode", wrong, "-o", out + ".png"}), "plumb: ", "");
  }
  EXPECT_EQ(run({"solid", "complement", kBlock, "-o", out + ".nef"}).code, 0);
  expect_refusal(run({"view", out + ".nef", "--explode", "1", "-o", out + ".png"}),
                 "plumb: ", "unbounded");
  expect_refusal(run({"view", files[0], "corpus/plane/star.wkt", "-o", out + ".png"}), "corpus",
                 "");
}

}  // namespace
}  // namespace plumb::testing::view_command_test
