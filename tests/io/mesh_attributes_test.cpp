// Attributes of meshes in files: what is read, what is written, and that both agree.
//
// The laws hold for random meshes with random attributes: every corner of the mesh that is read
// again has the point and the numbers that it had, and every face its colour, group and id, as far
// as lost_attributes() does not name them. The files of the other tests are written by hand, in the
// dialects of other programs.
#include "plumb/space/mesh_attributes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <optional>
#include <random>
#include <sstream>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "plumb/io/mesh/glb.h"
#include "plumb/io/mesh_io.h"
#include "plumb/predicates/error.h"
#include "plumb/space/nef3.h"

namespace plumb::mesh_attributes_test {
namespace {

using Color = std::array<double, 4>;
constexpr std::uint32_t kNone = MeshAttributes::kNone;
constexpr std::array kFormats{MeshFormat::Off, MeshFormat::ExactOff, MeshFormat::Obj,
                              MeshFormat::Ply, MeshFormat::PlyText};

ReadOptions wanted() {
  ReadOptions options;
  options.attributes = true;
  return options;
}

MeshFile read(const std::string& bytes, MeshFormat format) {
  return read_mesh(bytes, format, wanted());
}

std::string written(const PolygonMesh& mesh, const MeshAttributes& attributes, MeshFormat format) {
  std::ostringstream out;
  write_mesh(out, mesh, attributes, format);
  return out.str();
}

const MeshChannel* find(const MeshAttributes& attributes, const std::string& name) {
  const auto found = std::find_if(attributes.channels.begin(), attributes.channels.end(),
                                  [&](const MeshChannel& channel) { return channel.name == name; });
  return found == attributes.channels.end() ? nullptr : &*found;
}

std::optional<Color> color_of(const MeshAttributes& attributes, std::size_t face) {
  if (attributes.face_material.empty() || attributes.face_material[face] == kNone) return {};
  return attributes.materials[attributes.face_material[face]].color;
}

std::vector<double> corner(const MeshAttributes& attributes, const std::string& name,
                           std::size_t c) {
  const MeshChannel* const channel = find(attributes, name);
  if (channel == nullptr) return {};
  const auto first = channel->values.begin() + static_cast<std::ptrdiff_t>(c * channel->width);
  return {first, first + channel->width};
}

bool has_note(const MeshFile& file, const std::string& part) {
  return std::any_of(file.notes.begin(), file.notes.end(),
                     [&](const std::string& note) { return note.find(part) != note.npos; });
}

/// A folder that is removed at the end.
class Folder {
 public:
  explicit Folder(const std::string& name)
      : path_(std::filesystem::temp_directory_path() /
              (name + std::to_string(std::random_device{}()))) {
    std::filesystem::create_directory(path_);
  }
  ~Folder() { std::filesystem::remove_all(path_); }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  std::string file(const std::string& name) const { return (path_ / name).string(); }
  void put(const std::string& name, const std::string& text) const {
    std::ofstream(file(name)) << text;
  }

 private:
  std::filesystem::path path_;
};

// ---------------------------------------------------------------- laws

class Random {
 public:
  explicit Random(std::uint32_t seed) : engine_(seed) {}
  std::uint32_t below(std::uint32_t n) { return static_cast<std::uint32_t>(engine_() % n); }
  bool coin() { return below(2) == 0; }
  double number() { return static_cast<double>(below(2001)) / 1000 - 1; }
  /// A part of a colour: a byte, or another number from 0 to 1.
  double part(bool of_bytes) {
    return of_bytes ? below(256) / 255.0 : static_cast<double>(below(1001)) / 1000;
  }

 private:
  std::mt19937 engine_;
};

PolygonMesh random_mesh(Random& random) {
  PolygonMesh mesh;
  const std::uint32_t points = 3 + random.below(6);
  for (std::uint32_t i = 0; i < points; ++i) {
    mesh.points.push_back({static_cast<double>(i), random.number(), random.number()});
  }
  const std::uint32_t faces = 1 + random.below(8);
  for (std::uint32_t f = 0; f < faces; ++f) {
    std::vector<std::uint32_t> face(3 + random.below(3));
    for (std::uint32_t& v : face) v = random.below(points);
    mesh.add_face(face);
  }
  return mesh;
}

MeshChannel random_channel(Random& random, const std::string& name, std::uint32_t width,
                           const PolygonMesh& mesh) {
  MeshChannel channel{name, width, {}};
  const bool of_bytes = random.coin();
  const bool of_faces = random.coin();  // Whether the corners of a face agree.
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    std::vector<double> values;
    for (std::size_t c = 0; c < mesh.face(f).size(); ++c) {
      if (c > 0 && of_faces) {
        channel.values.insert(channel.values.end(), values.begin(), values.end());
        continue;
      }
      values.clear();
      for (std::uint32_t i = 0; i < width; ++i) {
        values.push_back(name == "color" ? random.part(of_bytes) : random.number());
      }
      channel.values.insert(channel.values.end(), values.begin(), values.end());
    }
  }
  return channel;
}

std::vector<std::uint32_t> random_entries(Random& random, std::size_t count, std::size_t size) {
  std::vector<std::uint32_t> entries(size);
  for (std::uint32_t& entry : entries) {
    const std::uint32_t choice = random.below(static_cast<std::uint32_t>(count) + 1);
    entry = choice == count ? kNone : choice;
  }
  entries[0] = 0;
  return entries;
}

MeshAttributes random_attributes(Random& random, const PolygonMesh& mesh) {
  MeshAttributes attributes;
  const auto add = [&](const char* name, std::uint32_t width) {
    if (random.coin()) attributes.channels.push_back(random_channel(random, name, width, mesh));
  };
  add("color", 3 + random.below(2));
  add("normal", 3);
  add("texcoord_0", 2);
  add("texcoord_1", 2);
  add("heat", 1);
  const std::size_t faces = mesh.face_count();
  if (random.coin()) {
    const bool of_bytes = random.coin();
    for (std::uint32_t m = 0; m < 3; ++m) {
      const double opacity = random.coin() ? 1 : random.part(of_bytes);
      attributes.materials.push_back(
          {"m " + std::to_string(m),
           Color{random.part(of_bytes), random.part(of_bytes), random.part(of_bytes), opacity},
           m == 1 ? "bark 1.png" : ""});
    }
    attributes.face_material = random_entries(random, 3, faces);
  }
  if (random.coin()) {
    attributes.groups = {"left", "right"};
    attributes.face_group = random_entries(random, 2, faces);
  }
  if (random.coin()) {
    attributes.face_id.resize(faces);
    for (std::uint32_t& id : attributes.face_id) id = random.below(1000);
  }
  return attributes;
}

/// Whether the two meshes have the same points at all corners.
void expect_same_faces(const PolygonMesh& a, const PolygonMesh& b) {
  ASSERT_EQ(a.face_begin, b.face_begin);
  for (std::size_t c = 0; c < a.corners.size(); ++c) {
    EXPECT_EQ(a.points[a.corners[c]], b.points[b.corners[c]]) << "corner " << c;
  }
}

void expect_same_channels(const MeshAttributes& in, const MeshAttributes& out,
                          const std::string& lost, std::size_t corners) {
  for (const MeshChannel& channel : in.channels) {
    const bool is_lost = lost.find("channel '" + channel.name + "'") != lost.npos;
    ASSERT_EQ(find(out, channel.name) == nullptr, is_lost) << channel.name << ": " << lost;
    if (is_lost) continue;
    const bool drops_opacity = lost.find("opacity") != lost.npos && channel.name == "color";
    for (std::size_t c = 0; c < corners; ++c) {
      std::vector<double> values = corner(in, channel.name, c);
      if (drops_opacity) values.resize(3);
      EXPECT_EQ(corner(out, channel.name, c), values) << channel.name << " at corner " << c;
    }
  }
}

/// Names of entries per face, with "" for none.
template <class Entry>
std::vector<std::string> names_of(const std::vector<std::uint32_t>& of_faces,
                                  const std::vector<Entry>& entries, std::size_t faces) {
  std::vector<std::string> names(faces);
  for (std::size_t f = 0; f < of_faces.size(); ++f) {
    if (of_faces[f] == kNone) continue;
    if constexpr (std::is_same_v<Entry, MeshMaterial>) {
      names[f] = entries[of_faces[f]].name;
    } else {
      names[f] = entries[of_faces[f]];
    }
  }
  return names;
}

class RoundTrip : public ::testing::TestWithParam<MeshFormat> {};

TEST_P(RoundTrip, KeepsWhatIsNotNamedAsLost) {
  const MeshFormat format = GetParam();
  const bool is_ply = format == MeshFormat::Ply || format == MeshFormat::PlyText;
  for (std::uint32_t seed = 0; seed < 60; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const PolygonMesh mesh = random_mesh(random);
    const MeshAttributes in = random_attributes(random, mesh);
    const std::string lost = lost_attributes(in, format);
    const Folder folder("attributes");
    const std::string path = folder.file("mesh");
    write_mesh_file(path, mesh, in, format);
    const MeshFile file = read_mesh_file(path, format, wanted());
    EXPECT_TRUE(file.warnings.empty());
    expect_same_faces(file.mesh, mesh);
    const MeshAttributes& out = file.attributes;
    expect_same_channels(in, out, lost, mesh.corners.size());
    const std::size_t faces = mesh.face_count();
    if (lost.find("ids") == lost.npos) {
      EXPECT_EQ(out.face_id, in.face_id);
    }
    if (lost.find("groups") == lost.npos) {
      EXPECT_EQ(names_of(out.face_group, out.groups, faces),
                names_of(in.face_group, in.groups, faces));
    }
    if (lost.find("names") == lost.npos) {
      EXPECT_EQ(names_of(out.face_material, out.materials, faces),
                names_of(in.face_material, in.materials, faces));
    }
    if (format == MeshFormat::Obj) continue;  // Colours are in the library, tested below.
    for (std::size_t f = 0; f < faces && !in.face_material.empty(); ++f) {
      const std::optional<Color> stated = color_of(in, f);
      EXPECT_EQ(color_of(out, f), is_ply ? stated.value_or(Color{1, 1, 1, 1}) : stated);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Formats, RoundTrip, ::testing::ValuesIn(kFormats));

TEST(MeshAttributes, ObjKeepsColoursAndTexturesInItsLibrary) {
  for (std::uint32_t seed = 0; seed < 20; ++seed) {
    Random random(seed);
    const PolygonMesh mesh = random_mesh(random);
    const MeshAttributes in = random_attributes(random, mesh);
    const Folder folder("library");
    write_mesh_file(folder.file("a b.obj"), mesh, in);
    const MeshFile file = read_mesh_file(folder.file("a b.obj"), {}, wanted());
    EXPECT_TRUE(file.notes.empty());
    EXPECT_EQ(std::filesystem::exists(folder.file("a b.mtl")), !in.face_material.empty());
    for (std::size_t f = 0; f < in.face_material.size(); ++f) {
      EXPECT_EQ(color_of(file.attributes, f), color_of(in, f));
      if (in.face_material[f] == kNone) continue;
      EXPECT_EQ(file.attributes.materials[file.attributes.face_material[f]].texture,
                in.materials[in.face_material[f]].texture);
    }
  }
}

TEST(MeshAttributes, AMeshWithoutAttributesIsWrittenAsBefore) {
  Random random(7);
  const PolygonMesh mesh = random_mesh(random);
  for (const MeshFormat format : kFormats) {
    std::ostringstream out;
    write_mesh(out, mesh, format);
    EXPECT_EQ(written(mesh, {}, format), out.str());
  }
}

TEST(MeshAttributes, ASplitMeshIsTheSameSet) {
  PolygonMesh cube;
  for (std::uint32_t i = 0; i < 8; ++i) {
    cube.points.push_back({i % 2 * 1.0, i / 2 % 2 * 1.0, i / 4 * 1.0});
  }
  const std::vector<std::vector<std::uint32_t>> faces{{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                                                      {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
  MeshAttributes attributes;
  attributes.channels.push_back({"texcoord_0", 2, {}});
  for (std::size_t f = 0; f < faces.size(); ++f) {
    cube.add_face(faces[f]);
    for (std::size_t c = 0; c < 4; ++c) {
      attributes.channels[0].values.push_back(static_cast<double>(f));
      attributes.channels[0].values.push_back(static_cast<double>(c));
    }
  }
  for (const MeshFormat format : {MeshFormat::Off, MeshFormat::Ply}) {
    const MeshFile file = read(written(cube, attributes, format), format);
    EXPECT_EQ(file.mesh.points.size(), 24U);
    EXPECT_TRUE(Nef3::from_mesh(file.mesh) == Nef3::from_mesh(cube));
  }
  EXPECT_EQ(read(written(cube, attributes, MeshFormat::Obj), MeshFormat::Obj).mesh.points.size(),
            8U);
}

TEST(MeshAttributes, AreReadOnlyIfWanted) {
  const std::string off = "COFF\n3 1 0\n0 0 0 1 0 0\n1 0 0\n0 1 0\n3 0 1 2 255 0 0\n";
  const MeshFile file = read_mesh(off, MeshFormat::Off);
  EXPECT_TRUE(file.attributes.empty());
  EXPECT_TRUE(has_note(file, "passed over: colours of vertices, colours of faces"));
  const MeshFile kept = read(off, MeshFormat::Off);
  EXPECT_FALSE(kept.attributes.empty());
  EXPECT_TRUE(kept.notes.empty());
}

TEST(MeshAttributes, MustBeComplete) {
  Random random(3);
  const PolygonMesh mesh = random_mesh(random);
  std::ostringstream out;
  const auto refuses = [&](const MeshAttributes& attributes) {
    for (const MeshFormat format : {MeshFormat::Off, MeshFormat::Obj, MeshFormat::Ply}) {
      EXPECT_THROW(write_mesh(out, mesh, attributes, format), Error);
    }
    EXPECT_TRUE(out.str().empty());
  };
  const std::size_t faces = mesh.face_count();
  refuses({{{"heat", 1, std::vector<double>(mesh.corners.size() + 1)}}, {}, {}, {}, {}, {}});
  refuses({{{"heat", 0, {}}}, {}, {}, {}, {}, {}});
  refuses({{}, {}, std::vector<std::uint32_t>(faces, 0), {}, {}, {}});  // No such material.
  refuses({{}, {}, {}, {}, std::vector<std::uint32_t>(faces, 0), {}});
  refuses({{}, {}, {}, {}, {}, std::vector<std::uint32_t>(faces + 1, 0)});
}

// ---------------------------------------------------------------- OFF

constexpr const char* kOffPoints = "0 0 0\n1 0 0\n0 1 0\n";

std::vector<std::optional<Color>> off_colors(const std::string& colors) {
  std::string text = "OFF\n3 " + std::to_string(std::count(colors.begin(), colors.end(), ';')) +
                     " 0\n" + kOffPoints;
  std::istringstream in(colors);
  for (std::string color; std::getline(in, color, ';');) text += "3 0 1 2 " + color + '\n';
  const MeshFile file = read(text, MeshFormat::Off);
  std::vector<std::optional<Color>> all;
  for (std::size_t f = 0; f < file.mesh.face_count(); ++f) {
    all.push_back(color_of(file.attributes, f));
  }
  return all;
}

TEST(OffAttributes, ColoursOfFacesHaveSeveralForms) {
  using Colors = std::vector<std::optional<Color>>;
  EXPECT_EQ(off_colors("255 0 51;0 0 255 51;"),
            (Colors{Color{1, 0, 51 / 255.0, 1}, Color{0, 0, 1, 51 / 255.0}}));
  EXPECT_EQ(off_colors("1 0 0;0.5 0.25 0 0.5;"),
            (Colors{Color{1, 0, 0, 1}, Color{0.5, 0.25, 0, 0.5}}));
  // One file has both: what is written with a point and is at most 1 is a part.
  EXPECT_EQ(off_colors("255 1 0;1.0 0.0 0.5;"),
            (Colors{Color{1, 1 / 255.0, 0, 1}, Color{1, 0, 0.5, 1}}));
  EXPECT_EQ(off_colors("255 0 0;;0 255 0;"), (Colors{Color{1, 0, 0, 1}, {}, Color{0, 1, 0, 1}}));
  EXPECT_EQ(off_colors("nan 0 0;"), (Colors{Color{0, 0, 0, 1}}));
}

TEST(OffAttributes, AMaterialThatNoFaceHasDoesNotMatter) {
  MeshFile file =
      read(std::string("OFF\n3 1 0\n") + kOffPoints + "3 0 1 2 255 0 51\n", MeshFormat::Off);
  const std::string text = written(file.mesh, file.attributes, MeshFormat::Off);
  file.attributes.materials.push_back({"", Color{0.3, 0.3, 0.3, 1}, ""});
  EXPECT_EQ(written(file.mesh, file.attributes, MeshFormat::Off), text);
}

TEST(OffAttributes, AnIndexOfAColourIsTheNameOfAMaterial) {
  const std::string text = std::string("OFF\n3 2 0\n") + kOffPoints + "3 0 1 2 7\n3 2 1 0 12\n";
  const MeshFile file = read(text, MeshFormat::Off);
  ASSERT_EQ(file.attributes.materials.size(), 2U);
  EXPECT_EQ(file.attributes.materials[1].name, "12");
  EXPECT_FALSE(file.attributes.materials[1].color);
  EXPECT_EQ(written(file.mesh, file.attributes, MeshFormat::Off), text);
}

TEST(OffAttributes, NumbersOfVerticesFollowTheKeyword) {
  const MeshFile file = read(
      "STCNOFF\n3 1 0\n0 0 0 0 0 1 255 0 0 0.5 0.25\n1 0 0 0 1 0 0 255 0 255 1 2\n"
      "0 1 0 1 0 0 0 0 51 3 4\n3 2 0 1\n",
      MeshFormat::Off);
  EXPECT_EQ(corner(file.attributes, "normal", 0), (std::vector<double>{1, 0, 0}));
  EXPECT_EQ(corner(file.attributes, "normal", 1), (std::vector<double>{0, 0, 1}));
  EXPECT_EQ(corner(file.attributes, "color", 0), (std::vector<double>{0, 0, 0.2, 1}));
  EXPECT_EQ(corner(file.attributes, "color", 1), (std::vector<double>{1, 0, 0, 1}));
  EXPECT_EQ(corner(file.attributes, "texcoord_0", 0), (std::vector<double>{3, 4}));
  EXPECT_EQ(corner(file.attributes, "texcoord_0", 1), (std::vector<double>{0.5, 0.25}));
}

TEST(OffAttributes, VerticesWithoutAColourAreWhite) {
  const MeshFile file =
      read("COFF\n3 1 0\n0 0 0 255 0 0 255\n1 0 0\n0 1 0\n3 0 1 2\n", MeshFormat::Off);
  EXPECT_EQ(corner(file.attributes, "color", 0), (std::vector<double>{1, 0, 0, 1}));
  EXPECT_EQ(corner(file.attributes, "color", 2), (std::vector<double>{1, 1, 1, 1}));
}

TEST(OffAttributes, RecordsMayShareLines) {
  const MeshFile file = read(
      "COFF 3 1 0 0 0 0 1 0 0 1 1 0 0 0 1 0 1\n0 1 0 0 0 1 1 3 2 1 0 0.5 0 0 1\n", MeshFormat::Off);
  EXPECT_EQ(corner(file.attributes, "color", 0), (std::vector<double>{0, 0, 1, 1}));
  EXPECT_EQ(color_of(file.attributes, 0), (Color{0.5, 0, 0, 1}));
}

TEST(OffAttributes, AreReadFromTheBinaryForm) {
  std::string bytes = "COFF BINARY\n";
  const auto integer = [&](std::uint32_t value) {
    for (int shift = 24; shift >= 0; shift -= 8) bytes += static_cast<char>(value >> shift & 0xffU);
  };
  const auto number = [&](float value) { integer(std::bit_cast<std::uint32_t>(value)); };
  for (const std::uint32_t count : {3U, 1U, 0U}) integer(count);
  for (int v = 0; v < 3; ++v) {
    for (const bool is_one : {v == 1, v == 2, false, v == 0, v == 1, v == 2, true}) {
      number(is_one ? 1.0F : 0.0F);
    }
  }
  for (const std::uint32_t index : {3U, 0U, 1U, 2U, 3U}) integer(index);
  for (const float part : {0.5F, 0.25F, 0.0F}) number(part);
  const MeshFile file = read(bytes, MeshFormat::Off);
  EXPECT_EQ(corner(file.attributes, "color", 1), (std::vector<double>{0, 1, 0, 1}));
  EXPECT_EQ(color_of(file.attributes, 0), (Color{0.5, 0.25, 0, 1}));
}

// ---------------------------------------------------------------- OBJ

TEST(ObjAttributes, ReferencesCountFromBothEnds) {
  const MeshFile file = read(
      "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0.5 0.25 9\nvt 1\nvn 0 0 1\nf 1/1/1 2/-1 3//-1\n"
      "f 3/3 2 1\nvt 7 8\n",
      MeshFormat::Obj);
  EXPECT_EQ(corner(file.attributes, "texcoord_0", 0), (std::vector<double>{0.5, 0.25}));
  EXPECT_EQ(corner(file.attributes, "texcoord_0", 1), (std::vector<double>{1, 0}));
  EXPECT_EQ(corner(file.attributes, "texcoord_0", 2), (std::vector<double>{0, 0}));
  EXPECT_EQ(corner(file.attributes, "texcoord_0", 3), (std::vector<double>{7, 8}));
  EXPECT_EQ(corner(file.attributes, "normal", 0), (std::vector<double>{0, 0, 1}));
  EXPECT_EQ(corner(file.attributes, "normal", 2), (std::vector<double>{0, 0, 1}));
  EXPECT_TRUE(file.notes.empty());
  const MeshFile far = read("v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 1 1\nf 1/1 2/9 3/-4\n", MeshFormat::Obj);
  EXPECT_TRUE(has_note(far, "vt or vn that there is not, which are read as 0: 2"));
}

TEST(ObjAttributes, MaterialsAndGroupsHoldUntilTheNext) {
  const MeshFile file = read(
      "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\no part\nusemtl dark wood # old\nf 1 2 3\ng side\n"
      "usemtl (null)\nf 1 2 3\nusemtl dark wood\ng default\nf 1 2 3\n",
      MeshFormat::Obj);
  const MeshAttributes& a = file.attributes;
  EXPECT_EQ(names_of(a.face_material, a.materials, 4),
            (std::vector<std::string>{"", "dark wood", "", "dark wood"}));
  EXPECT_EQ(names_of(a.face_group, a.groups, 4),
            (std::vector<std::string>{"", "part", "side", ""}));
  EXPECT_EQ(a.materials.size(), 1U);
}

TEST(ObjAttributes, ALibraryGivesColours) {
  const Folder folder("mtl");
  folder.put("a.obj",
             "mtllib one.mtl two.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl red\nf 1 2 3\n"
             "usemtl glass\nf 1 2 3\nusemtl plain\nf 1 2 3\n");
  folder.put("one.mtl", "newmtl red\r\n\tKd 1 0 0\r\nmap_Kd -s 1 1 1 bark.png\r\nnewmtl other\n");
  folder.put("two.mtl", "Kd 1 1 1\nnewmtl glass\nKd 0.5\nKd spectral x.rfl\nTr 0.75\n");
  const MeshFile file = read_mesh_file(folder.file("a.obj"), {}, wanted());
  EXPECT_TRUE(file.notes.empty());
  EXPECT_EQ(color_of(file.attributes, 0), (Color{1, 0, 0, 1}));
  EXPECT_EQ(file.attributes.materials[0].texture, "bark.png");
  EXPECT_EQ(color_of(file.attributes, 1), (Color{0.5, 0.5, 0.5, 0.25}));
  EXPECT_EQ(color_of(file.attributes, 2), std::nullopt);
  EXPECT_EQ(file.attributes.materials.size(), 3U);
}

TEST(ObjAttributes, ALibraryMayHaveANameThatLooksLikeAComment) {
  const Folder folder("mtl_comment");
  const std::string faces = "\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl red\nf 1 2 3\n";
  folder.put("part #1.mtl", "newmtl red\nKd 1 0 0\n");
  folder.put("part.mtl", "newmtl red\nKd 0 0 1\n");
  folder.put("a.obj", "mtllib part #1.mtl" + faces);
  folder.put("b.obj", "mtllib part.mtl # the part" + faces);
  const MeshFile a = read_mesh_file(folder.file("a.obj"), {}, wanted());
  EXPECT_TRUE(a.notes.empty());
  EXPECT_EQ(color_of(a.attributes, 0), (Color{1, 0, 0, 1}));
  const MeshFile b = read_mesh_file(folder.file("b.obj"), {}, wanted());
  EXPECT_TRUE(b.notes.empty());
  EXPECT_EQ(color_of(b.attributes, 0), (Color{0, 0, 1, 1}));
  // What is written next to such a name is read again.
  write_mesh_file(folder.file("c #2.obj"), a.mesh, a.attributes);
  const MeshFile c = read_mesh_file(folder.file("c #2.obj"), {}, wanted());
  EXPECT_EQ(color_of(c.attributes, 0), (Color{1, 0, 0, 1}));
}

TEST(ObjAttributes, ALibraryThatCannotBeReadIsANote) {
  const Folder folder("mtl");
  const std::string rest = "\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl red\nf 1 2 3\n";
  for (const std::string name : {"missing.mtl", "../../etc/passwd", "/etc/passwd"}) {
    folder.put("a.obj", "mtllib " + name + rest);
    const MeshFile file = read_mesh_file(folder.file("a.obj"), {}, wanted());
    EXPECT_TRUE(has_note(file, "the library was not read"));
    EXPECT_EQ(file.attributes.materials.at(0).name, "red");
  }
  EXPECT_TRUE(has_note(read("mtllib a.mtl" + rest, MeshFormat::Obj), "folder of the file"));
}

TEST(ObjAttributes, ColoursFollowTheCoordinatesOfVertices) {
  const MeshFile file =
      read("v 0 0 0 1 0 0\nv 1 0 0 1 0 0.5 0\nv 0 1 0\nf 1 2 3\n", MeshFormat::Obj);
  EXPECT_EQ(corner(file.attributes, "color", 0), (std::vector<double>{1, 0, 0}));
  EXPECT_EQ(corner(file.attributes, "color", 1), (std::vector<double>{0, 0.5, 0}));
  EXPECT_EQ(corner(file.attributes, "color", 2), (std::vector<double>{1, 1, 1}));
}

TEST(ObjAttributes, NamesThatAReaderWouldNotTakeAreChanged) {
  Random random(1);
  const PolygonMesh mesh = random_mesh(random);
  MeshAttributes in;
  in.materials = {{"", {}, {}}, {"a\nv 1 1 1", {}, {}}, {"a #b", {}, {}}, {"a _b", {}, {}}};
  in.face_material.assign(mesh.face_count(), 0);
  for (std::uint32_t f = 0; f < mesh.face_count(); ++f) in.face_material[f] = f % 4;
  const MeshFile file = read(written(mesh, in, MeshFormat::Obj), MeshFormat::Obj);
  expect_same_faces(file.mesh, mesh);
  EXPECT_EQ(file.attributes.face_material, in.face_material);
}

// ---------------------------------------------------------------- PLY

std::string ply(const std::string& of_vertices, const std::string& faces,
                const std::string& records) {
  return "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
         "property float z\n" +
         of_vertices + faces + "end_header\n" + records;
}

TEST(PlyAttributes, PropertiesOfVerticesBecomeChannels) {
  const MeshFile file =
      read(ply("property float nx\nproperty float ny\nproperty float nz\nproperty uchar red\n"
               "property uchar green\nproperty uchar blue\nproperty float quality\n"
               "property float s\nproperty float t\nproperty float w_0\nproperty float w_1\n",
               "element face 1\nproperty list uchar int vertex_indices\n",
               "0 0 0 0 0 1 255 51 0 0.5 1 2 3 4\n1 0 0 0 1 0 0 0 0 nan 0 0 0 0\n"
               "0 1 0 1 0 0 0 0 0 0 0 0 0 0\n3 0 1 2\n"),
           MeshFormat::Ply);
  EXPECT_EQ(corner(file.attributes, "normal", 1), (std::vector<double>{0, 1, 0}));
  EXPECT_EQ(corner(file.attributes, "color", 0), (std::vector<double>{1, 0.2, 0}));
  EXPECT_EQ(corner(file.attributes, "quality", 0), (std::vector<double>{0.5}));
  EXPECT_EQ(corner(file.attributes, "texcoord_0", 0), (std::vector<double>{1, 2}));
  EXPECT_EQ(corner(file.attributes, "w", 0), (std::vector<double>{3, 4}));
  ASSERT_EQ(file.notes.size(), 1U);
  EXPECT_TRUE(has_note(file, "read as 0: 1"));
}

TEST(PlyAttributes, PropertiesOfFacesStayWithTheirFaces) {
  // The triangles of the strip come before the faces, and have no colour.
  const MeshFile file = read(
      ply("",
          "element tristrips 1\nproperty list int int vertex_indices\nelement face 2\n"
          "property list uchar int vertex_indices\nproperty uchar red\nproperty uchar green\n"
          "property uchar blue\nproperty uchar alpha\nproperty int face_id\nproperty float heat\n",
          "0 0 0\n1 0 0\n0 1 0\n4 0 1 2 0\n3 0 1 2 255 0 0 51 17 0.5\n3 2 1 0 0 0 255 255 -1 1\n"),
      MeshFormat::Ply);
  ASSERT_EQ(file.mesh.face_count(), 4U);
  EXPECT_EQ(color_of(file.attributes, 1), std::nullopt);
  EXPECT_EQ(color_of(file.attributes, 2), (Color{1, 0, 0, 0.2}));
  EXPECT_EQ(color_of(file.attributes, 3), (Color{0, 0, 1, 1}));
  EXPECT_EQ(file.attributes.face_id, (std::vector<std::uint32_t>{kNone, kNone, 17, kNone}));
  EXPECT_EQ(corner(file.attributes, "heat", 0), (std::vector<double>{0}));
  EXPECT_EQ(corner(file.attributes, "heat", 6), (std::vector<double>{0.5}));
  EXPECT_EQ(corner(file.attributes, "heat", 9), (std::vector<double>{1}));
}

TEST(PlyAttributes, IdsOfMoreThan32BitsAreNamed) {
  const auto with_id = [](const std::string& id) {
    return read(
        ply("", "element face 1\nproperty list int int vertex_index\nproperty uint face_id\n",
            "0 0 0\n1 0 0\n0 1 0\n3 0 1 2 " + id + "\n"),
        MeshFormat::Ply);
  };
  EXPECT_EQ(with_id("4294967294").attributes.face_id, std::vector<std::uint32_t>{4294967294});
  EXPECT_TRUE(with_id("4294967295").notes.empty()) << "what plumb writes for a face without an id";
  const MeshFile file = with_id("4294967296");
  EXPECT_EQ(file.attributes.face_id, std::vector<std::uint32_t>{kNone});
  EXPECT_TRUE(has_note(file, "numbers of more than 32 bits of face_id"));
}

TEST(PlyAttributes, TextureCoordinatesMayBeAListOfTheFace) {
  const MeshFile file =
      read(ply("property float s\nproperty float t\n",
               "element face 2\nproperty list uchar int vertex_indices\n"
               "property list uchar float texcoord\n",
               "0 0 0 9 9\n1 0 0 9 9\n0 1 0 9 9\n3 0 1 2 6 1 2 3 4 5 6\n3 0 1 2 2 1 2\n"),
           MeshFormat::Ply);
  EXPECT_EQ(corner(file.attributes, "texcoord_0", 1), (std::vector<double>{3, 4}));
  EXPECT_EQ(corner(file.attributes, "texcoord_0", 3), (std::vector<double>{0, 0}));
  EXPECT_TRUE(has_note(file, "texcoord of faces with another number of corners"));
}

TEST(PlyAttributes, TheNumberOfPropertiesIsLimited) {
  std::string properties;
  std::string values;
  for (int i = 0; i < 40; ++i) {
    properties += "property float p" + std::to_string(i) + '\n';
    values += " 1";
  }
  const MeshFile file =
      read(ply(properties, "element face 1\nproperty list int int vertex_index\n",
               "0 0 0" + values + "\n1 0 0" + values + "\n0 1 0" + values + "\n3 0 1 2\n"),
           MeshFormat::Ply);
  EXPECT_EQ(file.attributes.channels.size(), 32U);
  EXPECT_TRUE(has_note(file, "p32"));
}

TEST(PlyAttributes, AChannelIsNoCoordinate) {
  Random random(5);
  const PolygonMesh mesh = random_mesh(random);
  MeshAttributes in;
  in.channels = {random_channel(random, "x", 1, mesh)};
  const MeshFile file = read(written(mesh, in, MeshFormat::Ply), MeshFormat::Ply);
  expect_same_faces(file.mesh, mesh);
  EXPECT_EQ(corner(file.attributes, "channel_x", 0), corner(in, "x", 0));
}

/// Triangles are sorted by material, so the law compares faces by their corners.
TEST(GltfAttributes, MaterialsComeBack) {
  PolygonMesh mesh;
  mesh.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  for (const std::array<std::uint32_t, 3>& face :
       {std::array<std::uint32_t, 3>{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}) {
    mesh.add_face(face);
  }
  MeshAttributes attributes;
  attributes.materials = {{"first \"one\"", Color{0.25, 0.5, 1, 1}, ""},
                          {"glass", Color{0, 1, 0, 0.5}, ""}};
  attributes.face_material = {1, kNone, 0, 1};
  const MeshFile file = read(written(mesh, attributes, MeshFormat::Gltf), MeshFormat::Gltf);
  ASSERT_EQ(file.mesh.face_count(), 4U);
  ASSERT_EQ(file.attributes.face_material.size(), 4U);
  const auto is_face = [&](std::size_t f, std::size_t g) {  // Equal up to the first corner.
    std::vector<Point3> a, b;
    for (const std::uint32_t v : file.mesh.face(f)) a.push_back(file.mesh.points[v]);
    for (const std::uint32_t v : mesh.face(g)) b.push_back(mesh.points[v]);
    for (int turn = 0; turn < 3; ++turn) {
      if (a == b) return true;
      std::rotate(a.begin(), a.begin() + 1, a.end());
    }
    return false;
  };
  std::size_t found = 0;
  for (std::size_t f = 0; f < 4; ++f) {
    for (std::size_t g = 0; g < 4; ++g) {
      if (!is_face(f, g)) continue;
      ++found;
      EXPECT_EQ(color_of(file.attributes, f), color_of(attributes, g));
    }
  }
  EXPECT_EQ(found, 4U);
  EXPECT_EQ(file.attributes.materials[0].name, "first \"one\"");
  EXPECT_TRUE(
      read_mesh(written(mesh, attributes, MeshFormat::Gltf), MeshFormat::Gltf).attributes.empty());
}

/// A closed strip of triangles over a square grid has vertices whose corners agree, and others
/// whose corners do not.
TEST(GltfAttributes, ChannelsAndTexturesComeBack) {
  PolygonMesh mesh;
  mesh.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {9, 9, 9}};  // The last is unused.
  for (const std::array<std::uint32_t, 3>& face :
       {std::array<std::uint32_t, 3>{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}) {
    mesh.add_face(face);
  }
  MeshAttributes attributes;
  attributes.materials = {{"wood", Color{1, 1, 1, 1}, "wood grain #1.png"},
                          {"", Color{0, 1, 0, 1}, ""},
                          {"brick", Color{1, 1, 1, 1}, "brick.jpg"}};
  attributes.face_material = {2, 0, 1, 0};
  MeshChannel color{"color", 4, {}}, normal{"normal", 3, {}};
  MeshChannel first{"texcoord_0", 2, {}}, second{"texcoord_1", 2, {}};
  for (std::size_t c = 0; c < 12; ++c) {
    const Point3& p = mesh.points[mesh.corners[c]];
    const double side = c / 3 < 2 ? 0.25 : 0.5;  // Differs from face to face at a vertex.
    color.values.insert(color.values.end(), {p.x, side, p.z, 0.75});
    first.values.insert(first.values.end(), {p.x, p.y + side});
    second.values.insert(second.values.end(), {-3, 0.125 * p.z});
    const std::array<double, 3> n =
        c / 3 == 2 ? std::array<double, 3>{0, 0, 0} : std::array<double, 3>{0, -0.5, 0};
    normal.values.insert(normal.values.end(), n.begin(), n.end());
  }
  attributes.channels = {first, second, normal, color};
  const std::string bytes = written(mesh, attributes, MeshFormat::Gltf);
  EXPECT_NE(bytes.find("wood%20grain%20%231.png"), std::string::npos);
  const MeshFile file = read(bytes, MeshFormat::Gltf);
  EXPECT_TRUE(file.notes.empty());
  ASSERT_EQ(file.mesh.face_count(), 4U);
  std::size_t found = 0;
  for (std::size_t f = 0; f < 4; ++f) {
    for (std::size_t g = 0; g < 4; ++g) {
      if (file.mesh.points[file.mesh.face(f)[0]] != mesh.points[mesh.face(g)[0]] ||
          file.mesh.points[file.mesh.face(f)[1]] != mesh.points[mesh.face(g)[1]] ||
          file.mesh.points[file.mesh.face(f)[2]] != mesh.points[mesh.face(g)[2]]) {
        continue;
      }
      ++found;
      const MeshMaterial& from = attributes.materials[attributes.face_material[g]];
      const MeshMaterial& to = file.attributes.materials[file.attributes.face_material[f]];
      EXPECT_EQ(to.texture, from.texture);
      EXPECT_EQ(to.name, from.name);
      for (const std::string name : {"color", "texcoord_0", "texcoord_1", "normal"}) {
        const MeshChannel *a = find(file.attributes, name), *b = find(attributes, name);
        ASSERT_NE(a, nullptr) << name;
        ASSERT_EQ(a->width, b->width) << name;
        const std::size_t count = 3 * a->width;
        std::vector<double> expected(
            b->values.begin() + static_cast<std::ptrdiff_t>(count * g),
            b->values.begin() + static_cast<std::ptrdiff_t>(count * (g + 1)));
        if (name == "normal") {
          // Of length 1; a face without normals has its own, here (1, 1, 1) / sqrt 3.
          const double third = static_cast<float>(1 / std::sqrt(3.0));
          expected = g == 2 ? std::vector<double>(9, third)
                            : std::vector<double>{0, -1, 0, 0, -1, 0, 0, -1, 0};
        }
        for (std::size_t i = 0; i < count; ++i) {
          EXPECT_FLOAT_EQ(static_cast<float>(a->values[count * f + i]),
                          static_cast<float>(expected[i]))
              << name;
        }
      }
    }
  }
  EXPECT_EQ(found, 4U);
}

TEST(GltfAttributes, AMaterialThatThereIsNotIsRefused) {
  const std::string bytes = R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],)"
                            R"("nodes":[{"mesh":0}],"meshes":[{"primitives":[{"attributes":)"
                            R"({"POSITION":0},"material":2}]}],"buffers":[{"byteLength":36,"uri":)"
                            R"("data:;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA"}],)"
                            R"("bufferViews":[{"buffer":0,"byteLength":36}],"accessors":)"
                            R"([{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3"}]})";
  EXPECT_EQ(read_mesh(bytes, MeshFormat::Gltf).mesh.face_count(), 1U);
  EXPECT_THROW(read(bytes, MeshFormat::Gltf), Error);
}

TEST(LostAttributes, NamesWhatAFormatDoesNotHold) {
  MeshAttributes all;
  all.channels = {{"color", 4, {}}, {"heat", 1, {}}};
  all.materials = {{"oak", Color{1, 0, 0, 1}, "oak.png"}};
  all.face_material = {0};
  all.groups = {"g"};
  all.face_group = {0};
  all.face_id = {1};
  const std::string begin = "not written, because the format does not hold them: ";
  EXPECT_EQ(lost_attributes(all, MeshFormat::Off),
            begin + "names of materials, textures, groups, ids of faces, channel 'heat'");
  EXPECT_EQ(lost_attributes(all, MeshFormat::Obj),
            begin + "ids of faces, opacity of vertices, channel 'heat'");
  EXPECT_EQ(lost_attributes(all, MeshFormat::Gltf),
            begin + "textures, groups, ids of faces, channel 'heat'");
  EXPECT_EQ(lost_attributes(all, MeshFormat::ThreeMf),
            begin + "textures, ids of faces, channel 'heat'");
  all.channels.push_back({"texcoord_0", 2, {}});
  all.channels.push_back({"texcoord_2", 2, {}});
  EXPECT_EQ(lost_attributes(all, MeshFormat::Gltf),
            begin + "groups, ids of faces, channel 'heat', channel 'texcoord_2'");
  all.channels.resize(2);
  EXPECT_EQ(lost_attributes(all, MeshFormat::Ply), begin + "names of materials, textures, groups");
  EXPECT_EQ(lost_attributes(all, MeshFormat::Stl),
            begin +
                "colours of faces, names of materials, textures, groups, ids of faces, "
                "channel 'color', channel 'heat'");
  EXPECT_EQ(lost_attributes({}, MeshFormat::Stl), "");
}

TEST(GltfAttributes, FilesOfFourGibibytesAreRefused) {
  require_glb_size(0xffffffff);
  try {
    require_glb_size(0x100000000);
    FAIL() << "not refused";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::CannotWrite);
    EXPECT_EQ(error.message(),
              "the file would have 4294967296 bytes, but binary glTF cannot have more than "
              "4294967295");
  }
}

TEST(MeshAttributes, HundredThousandMaterialsComeBack) {
  constexpr std::uint32_t kMaterials = 100'000;
  PolygonMesh mesh;
  mesh.points = {{0, 0, 0}, {1, 0, 0}};
  MeshAttributes in;
  for (std::uint32_t m = 0; m < kMaterials; ++m) {
    mesh.points.push_back({0.25, 0.5, static_cast<double>(m)});
    mesh.add_face(std::array<std::uint32_t, 3>{0, 1, m + 2});
    in.materials.push_back({"m" + std::to_string(m), Color{1, 0.5, 0.25, 1}, ""});
    in.face_material.push_back(kMaterials - 1 - m);
  }
  for (const MeshFormat format : {MeshFormat::Obj, MeshFormat::Gltf}) {
    const MeshFile file = read(written(mesh, in, format), format);
    const MeshAttributes& out = file.attributes;
    ASSERT_EQ(file.mesh.face_count(), kMaterials);
    ASSERT_EQ(out.materials.size(), kMaterials);
    std::vector<std::uint8_t> is_known(kMaterials, 0);
    for (std::uint32_t f = 0; f < kMaterials; ++f) {
      const double height = file.mesh.points[file.mesh.face(f)[2]].z;
      const auto m = kMaterials - 1 - static_cast<std::uint32_t>(height);
      ASSERT_EQ(out.materials[out.face_material[f]].name, "m" + std::to_string(m));
      is_known[m] = 1;
    }
    EXPECT_EQ(std::count(is_known.begin(), is_known.end(), 1), kMaterials);
  }
}

}  // namespace
}  // namespace plumb::mesh_attributes_test
