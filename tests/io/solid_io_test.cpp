// Sets from mesh files: what is turned, what is cut, what is told, and what is refused.
#include "plumb/io/solid_io.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "generate/mesh_solid.h"
#include "generate/meshes.h"
#include "plumb/io/mesh_io.h"
#include "plumb/predicates/error.h"
#include "plumb/testing/dice.h"

namespace plumb::testing::solid_io_test {
namespace {

/// A file that is gone with the object.
class MeshFile {
 public:
  explicit MeshFile(const PolygonMesh& mesh) {
    std::ofstream out(path_);
    write_mesh(out, mesh, MeshFormat::Off);
  }
  ~MeshFile() { std::filesystem::remove(path_); }
  MeshFile(const MeshFile&) = delete;
  MeshFile& operator=(const MeshFile&) = delete;
  const std::string& path() const { return path_; }

 private:
  std::string path_ = (std::filesystem::temp_directory_path() /
                       ("plumb-solid-sets-" + std::to_string(::getpid()) + ".off"))
                          .string();
};

SolidRead read(const PolygonMesh& mesh, const SolidReadOptions& options = {}) {
  const MeshFile file(mesh);
  Context context;
  return read_solid_file(file.path(), options, context);
}

bool has_note(const SolidRead& read, const std::string& part) {
  return std::ranges::any_of(
      read.notes, [&](const std::string& note) { return note.find(part) != std::string::npos; });
}

const PolygonMesh kCube = box_mesh({0, 0, 0}, {2, 2, 2});
const PolygonMesh kOther = box_mesh({1, 1, 1}, {3, 3, 3});

/// A tetrahedron with a face of one corner, of two corners, with a repeated corner and with none,
/// as real files have them. `first` is the number of the first vertex, `face` begins a face.
std::string faces_without_area(int first, const std::string& face, bool has_counts) {
  std::string text;
  for (const std::vector<int>& corners : std::vector<std::vector<int>>{
           {0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 3, 2}, {1}, {1, 2}, {3, 2, 2}, {}}) {
    text += face;
    if (has_counts) text += std::to_string(corners.size());
    for (const int v : corners) text += ' ' + std::to_string(v + first);
    text += '\n';
  }
  return text;
}

TEST(SolidSets, FacesWithoutAreaAreLeftOutAndNamed) {
  const std::string points[] = {"0 0 0\n", "1 0 0\n", "0 1 0\n", "0 0 1\n"};
  std::string plain, lettered;
  for (const std::string& p : points) {
    plain += p;
    lettered += "v " + p;
  }
  const std::string counted = plain + faces_without_area(0, "", true);
  const std::pair<std::string, std::string> files[] = {
      {"a.off", "OFF\n4 8 0\n" + counted},
      {"a.obj", lettered + faces_without_area(1, "f", false)},
      {"a.ply",
       "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\n"
       "property float z\nelement face 8\nproperty list uchar int vertex_indices\nend_header\n" +
           counted}};
  for (const auto& [name, text] : files) {
    Context context;
    const SolidRead read = read_solid(name, text, {}, context);
    EXPECT_TRUE(read.set == solid(tetrahedron_mesh({0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {0, 0, 1})))
        << name;
    EXPECT_TRUE(has_note(read, "faces without area, left out: 4, 5, 6, 7")) << name;
  }
}

TEST(SolidSets, WhatOtherProgramsWriteIsRead) {
  const Nef3 expected = solid(tetrahedron_mesh({0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {0, 0, 1}));
  std::size_t files = 0;
  for (const auto& entry : std::filesystem::directory_iterator("corpus/regress/meshes")) {
    Context context;
    const SolidRead read = read_solid_file(entry.path().string(), {}, context);
    EXPECT_TRUE(read.set == expected) << entry.path();
    ++files;
  }
  EXPECT_GE(files, 15U);
}

/// Files without any face, and what must be said of each.
const std::pair<std::pair<std::string, std::string>, std::string> kFilesWithoutFaces[] = {
    {{"a.obj", "v 0 0 0\n"}, "the file has 1 vertex but no faces"},
    {{"a.obj", "v 0 0 0\nv 1 0 0\np 1\nl 1 2\n"},
     "the file has 2 vertices but no faces; passed over: points, lines"},
    {{"a.obj", "v 0 0 0\nsurf 0 1 0 1 1 1 1 1\n"},
     "the file has 1 vertex but no faces; geometry that was not read: free-form surfaces"},
    {{"a.obj", "call b.obj\n"},
     "the file has no faces; geometry that was not read: other files (call)"},
    {{"a.off", "OFF\n2 0 0\n0 0 0\n1 0 0\n"}, "the file has 2 vertices but no faces"},
};

TEST(SolidSets, FilesWithoutFacesAreRefusedOrEmptyOnRequest) {
  for (const auto& [file, expected] : kFilesWithoutFaces) {
    Context context;
    try {
      read_solid(file.first, file.second, {}, context);
      ADD_FAILURE() << "was read: " << file.second;
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ErrorCode::BadShape);
      EXPECT_EQ(error.place().file, file.first);
      EXPECT_EQ(error.message(),
                expected + "; export it as polygons; --surface reads it as the empty set");
    }
    SolidReadOptions options;
    options.surface = true;
    const SolidRead empty = read_solid(file.first, file.second, options, context);
    EXPECT_TRUE(empty.set.is_empty());
    ASSERT_FALSE(empty.warnings.empty());
    EXPECT_EQ(empty.warnings.back(), expected + "; the set is empty");
  }
}

TEST(SolidSets, FilesOfNothingAreEmpty) {
  for (const auto& [name, text] : std::vector<std::pair<std::string, std::string>>{
           {"a.off", "OFF\n0 0 0\n"}, {"a.obj", "# plumb\n"}, {"a.stl", "solid a\nendsolid a\n"}}) {
    Context context;
    const SolidRead read = read_solid(name, text, {}, context);
    EXPECT_TRUE(read.set.is_empty());
    EXPECT_TRUE(read.warnings.empty());
  }
}

TEST(SolidSets, TwoOverlappingSolidsInOneFileAreTheirUnion) {
  Context context;
  const SolidRead read = read_solid_file("corpus/solids/two-tetrahedra.off", {}, context);
  const Nef3 one = solid(tetrahedron_mesh({0, 0, 0}, {0, 3, 0}, {3, 0, 0}, {0, 0, 3}));
  const Nef3 two = solid(tetrahedron_mesh({1, 0, 0}, {1, 3, 0}, {4, 0, 0}, {1, 0, 3}));
  EXPECT_TRUE(read.set == one + two);
  EXPECT_TRUE(has_note(read, "crosses itself"));
  EXPECT_FALSE(has_note(read, "turned"));
}

TEST(SolidSets, CrossingsAreToldNotRefused) {
  const SolidRead crossing = read(joined(kCube, kOther));
  EXPECT_TRUE(crossing.set == solid(kCube) + solid(kOther));
  EXPECT_TRUE(has_note(crossing, "the mesh crosses itself and is cut there; 6 pair(s) of faces"));
  EXPECT_TRUE(read(kCube).notes.empty());
  EXPECT_FALSE(has_note(read(joined(kCube, moved(kCube, {2, 2, 0}))), "crosses"));
}

TEST(SolidSets, WithoutARuleComponentsAreTurned) {
  const PolygonMesh mesh = joined(kCube, reversed(kOther));
  const SolidRead turned = read(mesh);
  EXPECT_TRUE(turned.set == solid(kCube) + solid(kOther));
  EXPECT_TRUE(has_note(turned, "components that were inside out, turned; their first faces: 6"));
  for (const WindingRule rule :
       {WindingRule::Positive, WindingRule::NonZero, WindingRule::EvenOdd}) {
    SolidReadOptions options;
    options.rule = rule;
    const SolidRead kept = read(mesh, options);
    EXPECT_TRUE(kept.set == solid(mesh, rule));
    EXPECT_FALSE(has_note(kept, "turned"));
  }
}

TEST(SolidSets, OpenMeshesAreRefusedOrSurfaces) {
  PolygonMesh open = joined(kCube, kOther);
  open.face_begin.pop_back();
  open.corners.resize(open.face_begin.back());
  EXPECT_THROW(read(open), Error);
  SolidReadOptions options;
  options.surface = true;
  const SolidRead surface = read(open, options);
  EXPECT_TRUE(has_note(surface, "crosses itself"));
  EXPECT_EQ(surface.set.counts().marked_volumes, 0U);
  EXPECT_TRUE(surface.set.contains(Point3{1, 2, 1.5}));  // where faces cross
  EXPECT_FALSE(surface.set.contains(Point3{0.5, 0.5, 0.5}));
}

TEST(SolidSets, MeshesThatEncloseNothingAreRefused) {
  const PolygonMesh doubled = joined(kCube, reversed(kCube));
  const PolygonMesh inside_out = reversed(kCube);
  EXPECT_THROW(read(doubled), EnclosesNothing);
  SolidReadOptions options;
  options.rule = WindingRule::Positive;
  EXPECT_THROW(read(inside_out, options), EnclosesNothing);
  options.may_be_empty = true;
  EXPECT_TRUE(read(inside_out, options).set.is_empty());
  EXPECT_TRUE(read(doubled, options).set.is_empty());
  options = {};
  options.surface = true;
  EXPECT_FALSE(read(doubled, options).set.is_empty());
}

TEST(SolidSets, MeshesAreMendedOnRequest) {
  SolidReadOptions options;
  options.repair.doubled = DoubledFaces::Drop;
  const SolidRead single = read(joined(kCube, reversed(kCube)), options);
  EXPECT_TRUE(single.set == solid(kCube));
  EXPECT_TRUE(has_note(single, "faces with the corners of an earlier one, dropped: 6, 7"));
  PolygonMesh open = kCube;
  open.face_begin.pop_back();
  open.corners.resize(open.face_begin.back());
  options.repair = {.fill_holes = 4};
  EXPECT_TRUE(read(open, options).set == solid(kCube));
  options.repair = {.fill_holes = 3};
  EXPECT_THROW(read(open, options), OpenMesh);
}

// The remedy is the mildest one, and adds to what was asked for.
TEST(SolidSets, RemediesAreOnesThatHelp) {
  PolygonMesh flipped = kCube;
  std::reverse(flipped.corners.begin(), flipped.corners.begin() + 4);
  EXPECT_EQ(remedy_for(flipped, {}), (RepairOptions{.reorient = true}));
  PolygonMesh open = kCube;
  open.face_begin.pop_back();
  open.corners.resize(open.face_begin.back());
  EXPECT_EQ(remedy_for(open, {}), (RepairOptions{.fill_holes = 4}));
  SolidReadOptions turning;
  turning.repair.reorient = true;
  EXPECT_EQ(remedy_for(open, turning), (RepairOptions{.reorient = true, .fill_holes = 4}));
  EXPECT_EQ(remedy_for(joined(kCube, reversed(kCube)), {}),
            (RepairOptions{.doubled = DoubledFaces::Drop}));
  EXPECT_EQ(remedy_for(reversed(kCube), {.rule = WindingRule::Positive}),
            (RepairOptions{.reorient = true}));
  PolygonMesh apart = kCube;  // A corner in two places.
  apart.points.push_back({2, 2 + 0x1p-20, 2});
  *std::ranges::find(apart.corners, 6U) = 8;
  const auto welded = remedy_for(apart, {});
  ASSERT_TRUE(welded);
  EXPECT_EQ(*welded, (RepairOptions{.weld = 1e-6}));
  PolygonMesh sheet;
  sheet.points = kCube.points;
  sheet.add_face(kCube.face(0));
  EXPECT_EQ(remedy_for(sheet, {}), std::nullopt);
}

/// Returns the faces of a mesh with points of their own, each of which is moved by at most `most`
/// along each axis.
PolygonMesh torn(const PolygonMesh& mesh, double most) {
  Dice dice(29);
  PolygonMesh result;
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    std::vector<std::uint32_t> face;
    for (const std::uint32_t v : mesh.face(f)) {
      const auto move = [&] { return most * static_cast<double>(dice.between(-100, 100)) / 100; };
      const Point3 p = mesh.points[v];
      face.push_back(static_cast<std::uint32_t>(result.points.size()));
      result.points.push_back({p.x + move(), p.y + move(), p.z + move()});
    }
    result.add_face(face);
  }
  return result;
}

// A heap of loose faces is welded with a tolerance that is much shorter than its edges, and a hole
// that is left is filled.
TEST(SolidSets, RemediesOfTornMeshesAreTolerances) {
  const PolygonMesh sphere = icosphere_mesh(2, 1, {0, 0, 0});
  for (const auto& [most, weld] : {std::pair(2e-8, 1e-7), {2e-5, 1e-4}, {2e-4, 1e-3}}) {
    PolygonMesh loose = torn(sphere, most);
    EXPECT_EQ(remedy_for(loose, {}), (RepairOptions{.weld = weld})) << most;
    loose.face_begin.pop_back();
    loose.corners.resize(loose.face_begin.back());
    EXPECT_EQ(remedy_for(loose, {}), (RepairOptions{.weld = weld, .fill_holes = 3})) << most;
  }
  EXPECT_EQ(remedy_for(torn(sphere, 0.05), {}), std::nullopt);
}

}  // namespace
}  // namespace plumb::testing::solid_io_test
