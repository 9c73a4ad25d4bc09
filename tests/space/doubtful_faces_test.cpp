// doubtful_faces() against brute force: pairs of faces that meet outside common vertices and edges
// are listed, and meshes that are far from damage give no face.
#include "plumb/space/mesh/doubtful_faces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "generate/meshes.h"
#include "generate/test_share.h"
#include "oracle/valid_mesh_check.h"
#include "plumb/testing/dice.h"

namespace plumb::doubtful_faces_test {
namespace {

using testing::Dice;
using testing::icosphere_mesh;
using testing::joined;
using testing::make_mesh;

using Flags = std::vector<std::uint8_t>;

DoubtfulFaces doubts(const PolygonMesh& mesh, const Flags& is_checked) {
  return doubtful_faces(mesh, is_checked, unlimited_context());
}
DoubtfulFaces all_doubts(const PolygonMesh& mesh) {
  return doubts(mesh, Flags(mesh.face_count(), 1));
}

TEST(DoubtfulFaces, SmoothMeshesHaveNone) {
  const PolygonMesh sphere = icosphere_mesh(3, 1, {0.1, 0.2, 0.3});
  EXPECT_TRUE(all_doubts(sphere).faces.empty());
  EXPECT_TRUE(all_doubts(testing::fanned(testing::box_mesh({0, 0, 0}, {1, 2, 3}))).faces.empty());
  EXPECT_TRUE(all_doubts(PolygonMesh{}).faces.empty());
}

TEST(DoubtfulFaces, OnlyFacesThatAreCheckedCount) {
  const PolygonMesh crossing =
      joined(icosphere_mesh(2, 1, {0, 0, 0}), icosphere_mesh(2, 1, {0.5, 0, 0}));
  EXPECT_TRUE(doubts(crossing, Flags(crossing.face_count(), 0)).faces.empty());
  EXPECT_FALSE(all_doubts(crossing).faces.empty());
}

/// Random triangles on few places, so that many share vertices, lie in one plane, or are flat.
PolygonMesh random_triangles(Dice& dice) {
  std::vector<Point3> points;
  const auto noise = [&] {
    return dice.below(3) != 0 ? 0 : std::ldexp(static_cast<double>(dice.between(-3, 3)), -52);
  };
  for (int i = 0; i < 8; ++i) {
    const auto coordinate = [&] { return static_cast<double>(dice.between(0, 3)) + noise(); };
    points.push_back({coordinate(), coordinate(), coordinate()});
  }
  PolygonMesh mesh = make_mesh(points, {});
  for (int i = 0; i < 12; ++i) {
    const testing::Face face{dice.below(8), dice.below(8), dice.below(8)};
    if (testing::has_area(mesh, face)) mesh.add_face(face);
  }
  return mesh;
}

TEST(DoubtfulFaces, ListEveryPairThatMeets) {
  const std::uint64_t cases = testing::case_count(500);
  std::uint64_t certain = 0, meeting = 0;
  for (std::uint64_t i = 0; i < cases; ++i) {
    Dice dice(i);
    const PolygonMesh mesh = random_triangles(dice);
    Flags is_checked;
    for (std::size_t f = 0; f < mesh.face_count(); ++f) {
      is_checked.push_back(static_cast<std::uint8_t>(dice.below(2)));
    }
    const DoubtfulFaces found = doubts(mesh, is_checked);
    const auto is_listed = [&](std::uint32_t f) {
      return std::ranges::binary_search(found.faces, f);
    };
    for (std::uint32_t f = 0; f < mesh.face_count(); ++f) {
      for (std::uint32_t g = 0; g < f; ++g) {
        if (is_checked[f] + is_checked[g] == 0) continue;
        const bool is_certain = !is_listed(f) || !is_listed(g);
        const bool meet = testing::meet_elsewhere(mesh, mesh.face(f), mesh.face(g));
        EXPECT_FALSE(is_certain && meet) << "scene " << i << ": " << g << ' ' << f;
        certain += is_certain ? 1 : 0;
        meeting += meet ? 1 : 0;
      }
    }
  }
  EXPECT_GT(certain, cases);  // The filter is of use even here.
  EXPECT_GT(meeting, cases);
}

/// Two triangles with a common vertex, an edge or nothing in common, in general position: those
/// that do not meet are proved to be apart.
TEST(DoubtfulFaces, PairsInGeneralPositionAreDecided) {
  std::uint64_t wrong = 0, apart = 0;
  for (std::uint64_t i = 0; i < 2000; ++i) {
    Dice dice(i);
    std::vector<Point3> points;
    const auto coordinate = [&] {
      return std::ldexp(static_cast<double>(dice.below(1U << 20)), -20);
    };
    for (int k = 0; k < 6; ++k) points.push_back({coordinate(), coordinate(), coordinate()});
    const auto shared = static_cast<std::uint32_t>(i % 3);
    const testing::Face second = shared == 0   ? testing::Face{3, 4, 5}
                                 : shared == 1 ? testing::Face{2, 3, 4}
                                               : testing::Face{2, 1, 3};
    const PolygonMesh mesh = make_mesh(points, {{0, 1, 2}, second});
    if (testing::meet_elsewhere(mesh, mesh.face(0), mesh.face(1))) continue;
    ++apart;
    wrong += all_doubts(mesh).faces.empty() ? 0 : 1;
  }
  EXPECT_GT(apart, 1000U);
  EXPECT_EQ(wrong, 0U);
}

/// Applies a random linear map without kernel, so that no axis is special.
void turn(Dice& dice, std::vector<Point3>& points) {
  const auto factor = [&] { return static_cast<double>(dice.between(-1, 1)); };
  const double a = factor(), b = factor(), c = factor();
  const bool is_mirrored = dice.below(2) == 0;
  for (Point3& p : points) {
    p.y += a * p.x;
    p.z += b * p.x + c * p.y;
    p = is_mirrored ? Point3{p.z, p.y, p.x} : Point3{p.y, p.z, p.x};
  }
}

/// Triangles around a vertex, in the order of their edges or in another order, so that they may go
/// around it several times, or fold back, or leave an edge open.
PolygonMesh random_umbrella(Dice& dice) {
  std::vector<Point3> points = {{0, 0, 0}};
  const std::uint32_t count = 3 + dice.below(5), stride = 1 + dice.below(count - 1);
  for (std::uint32_t i = 0; i < count; ++i) {
    const double angle = 6.283185307179586 * i / count;
    const double height = static_cast<double>(dice.between(-4, 4)) / 4;
    points.push_back({std::cos(angle), std::sin(angle), height});
  }
  if (dice.below(4) == 0) std::swap(points[1], points[2]);
  turn(dice, points);
  std::vector<testing::Face> faces;
  std::uint32_t at = 0;
  do {
    const std::uint32_t next = (at + stride) % count;
    faces.push_back({0, 1 + at, 1 + next});
    at = next;
  } while (at != 0);
  if (dice.below(4) == 0) faces.pop_back();
  return make_mesh(points, faces);
}

/// All pairs share a vertex. Those that meet elsewhere are listed, and many umbrellas give no face.
TEST(DoubtfulFaces, TrianglesAroundAVertexAreListedIfTheyMeetElsewhere) {
  std::uint64_t meeting = 0, sound = 0;
  for (std::uint64_t i = 0; i < 2000; ++i) {
    Dice dice(i);
    const PolygonMesh mesh = random_umbrella(dice);
    const std::vector<std::uint32_t> found = all_doubts(mesh).faces;
    sound += found.empty() ? 1 : 0;
    for (std::uint32_t f = 0; f < mesh.face_count(); ++f) {
      for (std::uint32_t g = 0; g < f; ++g) {
        if (!testing::meet_elsewhere(mesh, mesh.face(f), mesh.face(g))) continue;
        ++meeting;
        EXPECT_TRUE(std::ranges::binary_search(found, f) && std::ranges::binary_search(found, g))
            << "scene " << i << ": " << g << ' ' << f;
      }
    }
  }
  EXPECT_GT(meeting, 100U);
  EXPECT_GT(sound, 100U);
}

/// The corners of walls, floors and ramps: edges and normals are parallel to axes, or are sums of
/// these.
TEST(DoubtfulFaces, CornersOfBlocksHaveNone) {
  PolygonMesh blocks = testing::fanned(testing::box_mesh({0, 0, 0}, {1, 1, 1}));
  for (int i = 0; i < 200; ++i) {
    Dice dice(static_cast<std::uint64_t>(i));
    PolygonMesh turned = blocks;
    turn(dice, turned.points);
    EXPECT_TRUE(all_doubts(turned).faces.empty()) << i;
  }
}

/// Few small triangles to be checked among many others of all sizes, most of which are far away
/// from the first ones.
TEST(DoubtfulFaces, FewCheckedFacesAmongManyMeetTheListedOnes) {
  constexpr std::uint32_t kChecked = 12, kAll = 240;
  std::uint64_t meeting = 0;
  for (std::uint64_t i = 0; i < 16; ++i) {
    Dice dice(i);
    PolygonMesh mesh;
    Flags is_checked;
    const auto coordinate = [&](double around, double size) {
      return around + size * std::ldexp(static_cast<double>(dice.between(-1024, 1024)), -10);
    };
    for (std::uint32_t f = 0; f < kAll; ++f) {
      const bool is_first = f < kChecked;
      const int exponent = static_cast<int>(is_first ? 2 + dice.below(3) : dice.below(9));
      const double size = std::ldexp(1, -exponent), reach = is_first ? 0.25 : 0.5;
      const Point3 at = {coordinate(0, reach), coordinate(3, reach), coordinate(1e3, reach)};
      for (int k = 0; k < 3; ++k) {
        mesh.points.push_back(
            {coordinate(at.x, size), coordinate(at.y, size), coordinate(at.z, size)});
      }
      const testing::Face face{3 * f, 3 * f + 1, 3 * f + 2};
      if (!testing::has_area(mesh, face)) continue;
      mesh.add_face(face);
      is_checked.push_back(is_first ? 1 : 0);
    }
    const std::vector<std::uint32_t> found = doubts(mesh, is_checked).faces;
    for (std::uint32_t f = 0; f < mesh.face_count() && is_checked[f] != 0; ++f) {
      for (std::uint32_t g = f + 1; g < mesh.face_count(); ++g) {
        if (!testing::meet_elsewhere(mesh, mesh.face(f), mesh.face(g))) continue;
        ++meeting;
        EXPECT_TRUE(std::ranges::binary_search(found, f) && std::ranges::binary_search(found, g))
            << "scene " << i << ": " << f << ' ' << g;
      }
    }
  }
  EXPECT_GT(meeting, 100U);
}

/// A fan with so many triangles that their pairs are not all tested: nothing is left out.
TEST(DoubtfulFaces, TooManyPairsGiveAllFaces) {
  std::vector<Point3> points = {{0, 0, 1}};
  std::vector<testing::Face> faces;
  constexpr std::uint32_t kCount = 600;
  for (std::uint32_t i = 0; i < kCount; ++i) {
    const double angle = 6.283185307179586 * i / kCount;
    points.push_back({std::cos(angle), std::sin(angle), 0});
    faces.push_back({0, 1 + i, 1 + (i + 1) % kCount});
  }
  const PolygonMesh mesh = make_mesh(points, faces);
  EXPECT_EQ(all_doubts(mesh).faces.size(), kCount);
}

/// A thin triangle may be flipped: if its corners may have moved by a unit of a double, or of a
/// float if its corners are floats.
TEST(DoubtfulFaces, ThinTrianglesMayBeFlipped) {
  const auto thin = [](double x, double height) {
    return make_mesh({{0, 0, 0}, {x, 0, 0}, {0.5, height, 0}}, {{0, 1, 2}});
  };
  const double not_float = 1 + 0x1p-40;
  EXPECT_TRUE(all_doubts(thin(not_float, 0x1p-30)).flipped.empty());
  EXPECT_EQ(all_doubts(thin(not_float, 0x1p-52)).flipped.size(), 1U);
  EXPECT_EQ(all_doubts(thin(1, 0x1p-24)).flipped.size(), 1U);
  EXPECT_EQ(all_doubts(thin(1, 0)).faces.size(), 1U);
}

}  // namespace
}  // namespace plumb::doubtful_faces_test
