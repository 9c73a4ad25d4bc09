// Meshes that are damaged on purpose, and mended.
#include "plumb/space/repair_mesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "generate/meshes.h"
#include "generate/voxel_mesh.h"
#include "oracle/repair_check.h"
#include "plumb/predicates/error.h"
#include "plumb/space/from_mesh.h"
#include "plumb/space/mesh/mesh_orientation.h"
#include "plumb/space/nef3.h"
#include "plumb/testing/dice.h"

namespace plumb::testing::repair_mesh_test {
namespace {

using Faces = std::vector<std::uint32_t>;

const PolygonMesh kCube = box_mesh({0, 0, 0}, {2, 2, 2});
const RepairOptions kSafe{.weld = 0,
                          .doubled = DoubledFaces::DropIfBetter,
                          .reorient = true,
                          .fill_holes = 0,
                          .fill_holes_below = 0};

RepairReport mended(PolygonMesh& mesh, const RepairOptions& options) {
  const RepairReport report = repair_mesh(mesh, options);
  EXPECT_EQ(report.is_closed(), complex_of_mesh(mesh).report.is_closed());
  return report;
}

/// The corners of every face as points of their own.
PolygonMesh as_soup(const PolygonMesh& mesh) {
  PolygonMesh soup;
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    Faces face;
    for (const std::uint32_t v : mesh.face(f)) {
      face.push_back(static_cast<std::uint32_t>(soup.points.size()));
      soup.points.push_back(mesh.points[v]);
    }
    soup.add_face(face);
  }
  return soup;
}

PolygonMesh without(const PolygonMesh& mesh, const Faces& faces) {
  PolygonMesh rest;
  rest.points = mesh.points;
  for (std::uint32_t f = 0; f < mesh.face_count(); ++f) {
    if (std::ranges::find(faces, f) == faces.end()) rest.add_face(mesh.face(f));
  }
  return rest;
}

TEST(RepairMesh, ACorrectMeshStaysAsItIs) {
  const PolygonMesh hollow =
      joined(box_mesh({-5, -5, -5}, {9, 9, 9}), reversed(kCube));  // A void is inside out.
  PolygonMesh wall = joined(kCube, moved(kCube, {2, 0, 0}));
  for (const PolygonMesh& mesh : {kCube, hollow, icosphere_mesh(2, 1, {0, 0, 0})}) {
    PolygonMesh after = mesh;
    const RepairReport report = mended(after, kSafe);
    EXPECT_FALSE(report.has_changed());
    EXPECT_EQ(after.corners, mesh.corners);
    EXPECT_EQ(after.points, mesh.points);
  }
  // The wall between two solids has a face of each. Both stay.
  const RepairReport report = mended(wall, kSafe);
  EXPECT_TRUE(report.doubled.empty());
  EXPECT_EQ(wall.face_count(), 12U);
  EXPECT_EQ(wall.points.size(), 12U);
  EXPECT_EQ(report.equal, 4U);
}

TEST(RepairMesh, FlippedFacesAreTurned) {
  for (std::uint32_t f = 0; f < 6; ++f) {
    PolygonMesh mesh = kCube;
    reverse_faces(mesh, Faces{f});
    EXPECT_THROW((void)Nef3::from_mesh(mesh), OpenMesh);
    const RepairReport report = mended(mesh, kSafe);
    EXPECT_EQ(report.flipped, Faces{f});
    EXPECT_TRUE(Nef3::from_mesh(mesh, {.rule = WindingRule::Positive}) == Nef3::from_mesh(kCube));
  }
}

TEST(RepairMesh, InsideOutMeshesAreTurnedButVoidsAreNot) {
  PolygonMesh mesh = joined(reversed(box_mesh({-5, -5, -5}, {9, 9, 9})), reversed(kCube));
  reverse_faces(mesh, Faces{8});
  const RepairReport report = mended(mesh, kSafe);
  EXPECT_EQ(report.flipped, Faces{8});
  EXPECT_EQ(report.turned, Faces{0});
  const Nef3 expected = Nef3::from_mesh(joined(box_mesh({-5, -5, -5}, {9, 9, 9}), reversed(kCube)));
  EXPECT_TRUE(Nef3::from_mesh(mesh, {.rule = WindingRule::Positive}) == expected);
}

TEST(RepairMesh, OneSideOfADoubleSidedMeshStays) {
  for (const RepairOptions& options :
       {kSafe, RepairOptions{.doubled = DoubledFaces::Drop, .reorient = true}}) {
    PolygonMesh mesh = joined(kCube, reversed(kCube));
    std::rotate(mesh.corners.begin(), mesh.corners.begin() + 4, mesh.corners.end());
    EXPECT_TRUE(Nef3::from_mesh(mesh).is_empty());
    const RepairReport report = mended(mesh, options);
    EXPECT_EQ(report.doubled.size(), 6U);
    EXPECT_EQ(mesh.face_count(), 6U);
    EXPECT_TRUE(Nef3::from_mesh(mesh) == Nef3::from_mesh(kCube));
  }
}

TEST(RepairMesh, AClosedSurfaceListedTwiceIsDroppedOnce) {
  // Twice in the same direction; another solid beside it stays.
  PolygonMesh mesh = joined(joined(kCube, moved(kCube, {9, 0, 0})), kCube);
  const RepairReport report = mended(mesh, kSafe);
  EXPECT_EQ(report.doubled.size(), 6U);
  EXPECT_EQ(mesh.face_count(), 12U);
  EXPECT_TRUE(report.is_closed());
  EXPECT_TRUE(Nef3::from_mesh(mesh) == Nef3::from_mesh(joined(kCube, moved(kCube, {9, 0, 0}))));
}

TEST(RepairMesh, AFaceListedTwiceIsDroppedOnce) {
  for (const bool is_reversed : {false, true}) {
    PolygonMesh mesh = kCube;
    Faces copy(kCube.face(3).begin(), kCube.face(3).end());
    std::rotate(copy.begin(), copy.begin() + 2, copy.end());
    if (is_reversed) std::ranges::reverse(copy);
    mesh.add_face(copy);
    EXPECT_FALSE(complex_of_mesh(mesh).report.is_closed());
    const RepairReport report = mended(mesh, kSafe);
    ASSERT_EQ(report.doubled.size(), 1U);
    EXPECT_EQ(report.doubled[0], std::pair(6U, 3U));
    EXPECT_TRUE(Nef3::from_mesh(mesh) == Nef3::from_mesh(kCube));
  }
}

TEST(RepairMesh, DegenerateFacesAreDropped) {
  PolygonMesh mesh = kCube;
  mesh.add_face(std::array{1U, 2U});
  mesh.add_face(std::array{1U, 2U, 1U});
  mesh.add_face(std::array{4U, 4U, 4U});
  mesh.add_face(std::span<const std::uint32_t>());
  mesh.points.push_back({7, 7, 7});
  const RepairReport report = mended(mesh, RepairOptions{});
  EXPECT_EQ(report.degenerate, (Faces{6, 7, 8, 9}));
  EXPECT_EQ(report.unused, 1U);
  EXPECT_EQ(mesh.face_count(), 6U);
  EXPECT_EQ(mesh.points.size(), 8U);
}

TEST(RepairMesh, HolesAreFilledUpToASize) {
  const PolygonMesh ball = icosphere_mesh(2, 1, {0, 0, 0});
  PolygonMesh open = without(joined(ball, moved(kCube, {5, 0, 0})), {0, 17, 320});
  PolygonMesh part = open;
  RepairReport report = mended(part, {.fill_holes = 3});
  EXPECT_EQ(report.filled, (Faces{3, 3}));
  EXPECT_EQ(report.holes.size(), 1U);
  EXPECT_EQ(report.holes[0].size(), 4U);
  // By the diagonals of their boxes: the triangles are small, the square is 2 wide.
  PolygonMesh wide = open;
  EXPECT_EQ(mended(wide, {.fill_holes_below = 1}).filled, (Faces{3, 3}));
  wide = open;
  EXPECT_EQ(mended(wide, {.fill_holes_below = 2.9}).filled, (Faces{3, 3, 4}));
  report = mended(open, {.fill_holes = 4});
  EXPECT_EQ(report.filled, (Faces{3, 3, 4}));
  EXPECT_EQ(report.added, 3U);
  EXPECT_TRUE(Nef3::from_mesh(open) == Nef3::from_mesh(joined(ball, moved(kCube, {5, 0, 0}))));
}

// A large hole that is not planar, with a flipped face beside it.
TEST(RepairMesh, HolesNeedNotBePlanar) {
  PolygonMesh ball = icosphere_mesh(2, 1, {0, 0, 0});
  Faces gone;
  for (std::uint32_t f = 0; f < 24; ++f) gone.push_back(f);
  PolygonMesh open = without(ball, gone);
  reverse_faces(open, Faces{100});
  const RepairReport report = mended(open, {.fill_holes = 1000});
  EXPECT_EQ(report.flipped, Faces{100});
  EXPECT_TRUE(report.is_closed());
  EXPECT_EQ(Nef3::from_mesh(open).counts().marked_volumes, 1U);
}

TEST(RepairMesh, LastBitsAreWelded) {
  Dice dice(44);
  const PolygonMesh ball = fanned(icosphere_mesh(2, 3, {1, 2, 3}));
  for (int round = 0; round < 10; ++round) {
    PolygonMesh soup = as_soup(ball);
    for (Point3& p : soup.points) {
      for (double* const x : {&p.x, &p.y, &p.z}) {
        *x += (static_cast<double>(dice.below(5)) - 2) * 1e-7;
      }
    }
    EXPECT_FALSE(complex_of_mesh(soup).report.is_closed());
    PolygonMesh weak = soup;
    EXPECT_FALSE(mended(weak, {.weld = 1e-9}).is_closed());
    const RepairReport report = mended(soup, {.weld = 1e-6});
    EXPECT_TRUE(report.is_closed());
    EXPECT_LE(report.farthest, 1e-6);
    EXPECT_EQ(soup.points.size(), ball.points.size());
    EXPECT_EQ(soup.face_count(), ball.face_count());
  }
}

TEST(RepairMesh, ExactPointsKeepTheirCoordinates) {
  PolygonMesh mesh = kCube;
  for (Point3& p : mesh.points) p = {p.x / 3, p.y / 3, p.z / 3};
  for (std::uint32_t v = 0; v < 8; ++v) {
    const Point3& p = kCube.points[v];
    mesh.exact.emplace_back(
        v, RationalPoint3{Rational(p.x) / 3, Rational(p.y) / 3, Rational(p.z) / 3});
  }
  const Nef3 expected = Nef3::from_mesh(mesh);
  PolygonMesh damaged = joined(PolygonMesh{}, mesh);
  damaged.points.insert(damaged.points.begin(), Point3{9, 9, 9});  // Used by no face.
  for (std::uint32_t& v : damaged.corners) ++v;
  damaged.exact = mesh.exact;
  for (auto& [v, p] : damaged.exact) ++v;
  reverse_faces(damaged, Faces{4});
  EXPECT_EQ(mended(damaged, kSafe).flipped, Faces{4});
  EXPECT_TRUE(Nef3::from_mesh(damaged) == expected);
}

// Whatever is damaged, the report says whether the result is closed, and filling closes it.
TEST(RepairMesh, DamagedVoxelsAreMendedOrTheReportSaysSo) {
  Dice dice(45);
  for (int round = 0; round < 60; ++round) {
    PolygonMesh mesh = voxel_mesh(random_voxels(dice, {3, 3, 2}, 6));
    const auto count = static_cast<std::uint32_t>(mesh.face_count());
    Faces flips, gone;
    for (std::uint32_t f = 0; f < count; ++f) {
      if (dice.below(8) == 0) flips.push_back(f);
      if (dice.below(12) == 0) gone.push_back(f);
    }
    reverse_faces(mesh, flips);
    mesh = without(mesh, gone);
    if (mesh.face_count() == 0) continue;
    for (const DoubledFaces doubled :
         {DoubledFaces::Keep, DoubledFaces::DropIfBetter, DoubledFaces::Drop}) {
      PolygonMesh after = mesh;
      mended(after, {.doubled = doubled, .reorient = true});
      after = mesh;
      const RepairReport report =
          mended(after, {.doubled = doubled, .reorient = dice.below(2) == 0, .fill_holes = 1000});
      EXPECT_TRUE(report.is_closed() || !report.one_sided.empty());
    }
  }
}

/// Polygons between few points, with spikes and repeated corners; many of them both ways round.
PolygonMesh random_soup(Dice& dice) {
  PolygonMesh mesh;
  const std::uint32_t points = 3 + dice.below(8), width = 2 + dice.below(3);
  const auto at = [&] { return static_cast<double>(dice.below(width)); };
  for (std::uint32_t i = 0; i < points; ++i) mesh.points.push_back({at(), at(), at()});
  for (std::uint32_t f = 1 + dice.below(14); f > 0; --f) {
    Faces face(dice.below(3) > 0 ? 3 : dice.below(7));
    for (std::uint32_t& v : face) v = dice.below(points);
    mesh.add_face(face);
    std::ranges::reverse(face);
    if (dice.below(3) == 0) mesh.add_face(face);
  }
  return mesh;
}

TEST(RepairMesh, SoupsAreJudgedAsTheyAreRead) {
  Dice dice(46);
  for (int round = 0; round < 3000; ++round) {
    PolygonMesh mesh = random_soup(dice);
    const RepairOptions options{.weld = dice.below(3) > 0 ? 0 : 0.5 * dice.below(4),
                                .doubled = static_cast<DoubledFaces>(dice.below(3)),
                                .reorient = dice.below(2) == 0,
                                .fill_holes = dice.below(2) == 0 ? 0 : dice.below(30)};
    mended(mesh, options);
  }
}

/// Random programs of faces, judged by brute force.
TEST(RepairMesh, ReportsHold) {
  Dice dice(47);
  for (int round = 0; round < 2000 && !HasFailure(); ++round) {
    std::vector<std::uint8_t> program((2 + dice.below(14)) * kRepairRecord);
    const std::uint32_t points = 1 + dice.below(54);  // Few points make closed meshes likely.
    for (std::uint8_t& byte : program) byte = static_cast<std::uint8_t>(dice.below(points));
    for (std::size_t i = 0; i < program.size(); i += kRepairRecord) {
      program[i] = static_cast<std::uint8_t>(dice.below(3) == 0 ? dice.below(256) : 3);
    }
    EXPECT_EQ(repair_of_program_disagreement(program), "") << "round " << round;
  }
}

// Three faces with the same corners, one of them reversed, in a component that is inside out: all
// three have to be turned. Found among random soups.
TEST(RepairMesh, DoubledFacesAreTurnedTogether) {
  PolygonMesh mesh =
      make_mesh({{1, 0, 0}, {1, 1, 0}, {0, 1, 1}, {0, 1, 0}, {1, 1, 1}, {1, 1, 0}, {0, 0, 1}},
                {{3, 1, 3, 3, 5, 3},
                 {2, 0, 2},
                 {2, 2, 5, 5},
                 {4, 1, 5, 0, 6},
                 {6, 5, 0},
                 {0, 5, 6},
                 {2, 2, 0},
                 {0, 2, 2},
                 {3, 2, 0},
                 {0, 2, 3},
                 {1, 4, 6, 5, 0},
                 {4, 2, 3},
                 {3, 0, 5},
                 {4, 5, 0},
                 {5, 4, 6},
                 {1, 5, 2},
                 {4, 3, 1, 6, 6, 2},
                 {2, 6, 6, 1, 3, 4}});
  EXPECT_TRUE(mended(mesh, {.reorient = true, .fill_holes = 15}).is_closed());
}

/// Returns attributes in which each face and each corner has numbers of its own: face f has the id
/// 10 + f, and corner i of face f has the numbers of its point and f.
MeshAttributes own_attributes(const PolygonMesh& mesh) {
  MeshAttributes attributes;
  attributes.materials = {{"red", {}, {}}};
  MeshChannel at{"at", 4, {}}, normal{"normal", 3, {}}, color{"color", 3, {}};
  for (std::uint32_t f = 0; f < mesh.face_count(); ++f) {
    attributes.face_id.push_back(10 + f);
    attributes.face_material.push_back(0);
    for (const std::uint32_t v : mesh.face(f)) {
      const Point3& p = mesh.points[v];
      at.values.insert(at.values.end(), {p.x, p.y, p.z, static_cast<double>(f)});
      normal.values.insert(normal.values.end(), {1, 2, 3});
      color.values.insert(color.values.end(), {0.5, 0.5, 0.5});
    }
  }
  attributes.channels = {at, normal, color};
  return attributes;
}

/// Expects at each corner the numbers of own_attributes(), and at faces with the id kNone the
/// numbers of new faces. Returns the ids of faces whose normals are negated.
Faces expect_own(const PolygonMesh& mesh, const MeshAttributes& attributes) {
  Faces reversed;
  EXPECT_EQ(attributes.face_id.size(), mesh.face_count());
  for (std::uint32_t f = 0; f < mesh.face_count(); ++f) {
    const std::uint32_t id = attributes.face_id[f];
    const bool is_new = id == MeshAttributes::kNone;
    EXPECT_EQ(attributes.face_material[f], is_new ? MeshAttributes::kNone : 0);
    const double turn = attributes.channels[1].values[3 * std::size_t{mesh.face_begin[f]}];
    if (turn < 0) reversed.push_back(id);
    for (std::size_t c = mesh.face_begin[f]; c < mesh.face_begin[f + 1]; ++c) {
      const double* const at = &attributes.channels[0].values[4 * c];
      const double* const normal = &attributes.channels[1].values[3 * c];
      const Point3 p = is_new ? Point3{0, 0, 0} : mesh.points[mesh.corners[c]];
      EXPECT_EQ((Point3{at[0], at[1], at[2]}), p) << f;
      EXPECT_EQ(at[3], is_new ? 0 : id - 10.0);
      EXPECT_EQ(normal[1], 2 * turn);
      EXPECT_EQ(normal[2], 3 * turn);
      EXPECT_EQ(attributes.channels[2].values[3 * c], is_new ? 1 : 0.5);
    }
  }
  return reversed;
}

TEST(RepairMesh, AttributesStayWithTheirFaces) {
  // A cube without its last face, with face 1 flipped, face 2 listed twice, a face without area,
  // and repeated corners and a spike in face 3. Every corner is a point of its own.
  PolygonMesh mesh = kCube;
  mesh.corners.resize(mesh.face_begin[5]);
  mesh.face_begin.resize(6);
  std::reverse(mesh.corners.begin() + 4, mesh.corners.begin() + 8);
  const Faces second(mesh.face(2).begin(), mesh.face(2).end());
  mesh.add_face(second);
  mesh.add_face(std::array<std::uint32_t, 3>{0, 1, 1});
  const auto third = mesh.corners.begin() + mesh.face_begin[3];
  const std::uint32_t a = third[0], b = third[1], other = second[0] == b ? second[1] : second[0];
  mesh.corners.insert(third + 1, {a, a});
  mesh.corners.insert(mesh.corners.begin() + mesh.face_begin[3] + 4, {other, b});
  for (std::size_t f = 4; f < mesh.face_begin.size(); ++f) mesh.face_begin[f] += 4;
  mesh = as_soup(mesh);
  const PolygonMesh given = mesh;
  MeshAttributes attributes = own_attributes(mesh);
  RepairOptions options = kSafe;
  options.doubled = DoubledFaces::Drop;
  options.fill_holes = 4;
  PolygonMesh plain = mesh;
  const RepairReport report = repair_mesh(plain, options);
  EXPECT_EQ(repair_mesh(mesh, attributes, options).flipped, report.flipped);
  EXPECT_EQ(mesh.corners, plain.corners);
  EXPECT_EQ(mesh.face_begin, plain.face_begin);
  EXPECT_TRUE(report.is_closed());
  EXPECT_EQ(attributes.face_id, (Faces{10, 11, 12, 13, 14, MeshAttributes::kNone}));
  EXPECT_EQ(expect_own(mesh, attributes), (Faces{11}));

  PolygonMesh cut = triangulated(mesh, attributes);
  EXPECT_EQ(cut.corners, triangulated(mesh).corners);
  EXPECT_EQ(cut.face_count(), 12);
  EXPECT_EQ(expect_own(cut, attributes), (Faces{11, 11}));

  PolygonMesh refused = given;
  MeshAttributes incomplete = own_attributes(given);
  incomplete.face_id.pop_back();
  EXPECT_THROW(repair_mesh(refused, incomplete, options), Error);
  EXPECT_EQ(refused.corners, given.corners);
  EXPECT_THROW((void)triangulated(given, incomplete), Error);
}

TEST(RepairMesh, AnErrorLeavesTheMesh) {
  PolygonMesh mesh = kCube;
  EXPECT_THROW(repair_mesh(mesh, {.weld = -1}), Error);
  mesh.corners[3] = 99;
  const PolygonMesh before = mesh;
  EXPECT_THROW(repair_mesh(mesh, kSafe), Error);
  EXPECT_EQ(mesh.corners, before.corners);
  mesh.corners[3] = 0;
  mesh.points[2].x = std::nan("");
  EXPECT_THROW(repair_mesh(mesh, kSafe), Error);
  EXPECT_EQ(mesh.face_count(), 6U);
}

TEST(RepairMesh, SaysWhatWasDone) {
  PolygonMesh mesh = kCube;
  EXPECT_TRUE(sentences(mended(mesh, kSafe)).empty());
  reverse_faces(mesh, Faces{2, 4});
  mesh.add_face(std::array{1U, 2U});
  const std::vector<std::string> said = sentences(mended(mesh, kSafe));
  EXPECT_EQ(said, (std::vector<std::string>{
                      "faces with fewer than three different corners, dropped: 6",
                      "faces that disagreed with their neighbours, flipped: 2, 4"}));
}

}  // namespace
}  // namespace plumb::testing::repair_mesh_test
