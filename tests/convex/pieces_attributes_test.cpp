// Convex pieces with the attributes of the sources of their set: each face of a source is covered
// once by facets of pieces, and walls inside the set have no source.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include "generate/meshes.h"
#include "generate/voxel_mesh.h"
#include "plumb/convex/decompose.h"
#include "plumb/convex/walls.h"
#include "plumb/predicates/rational_point.h"
#include "plumb/space/mesh_with_attributes.h"
#include "plumb/testing/dice.h"

namespace plumb::testing::pieces_attributes_test {
namespace {

/// Returns a source with an id for each face, and the coordinates of corners as a channel.
std::shared_ptr<const MeshSource> source_of(PolygonMesh mesh, std::uint32_t first_id) {
  MeshSource source{"mesh", std::move(mesh), {}};
  MeshChannel place{"place", 3, {}};
  for (const std::uint32_t v : source.mesh.corners) {
    const Point3& p = source.mesh.points[v];
    place.values.insert(place.values.end(), {p.x, p.y, p.z});
  }
  source.attributes.channels = {std::move(place)};
  for (std::uint32_t f = 0; f < source.mesh.face_count(); ++f) {
    source.attributes.face_id.push_back(first_id + f);
  }
  return std::make_shared<const MeshSource>(std::move(source));
}

std::array<Point3, 3> corners_of(const PolygonMesh& mesh, std::size_t f) {
  const auto face = mesh.face(f);
  return {mesh.points[face[0]], mesh.points[face[1]], mesh.points[face[2]]};
}

double area_of(const std::array<Point3, 3>& t) {
  const Point3 u{t[1].x - t[0].x, t[1].y - t[0].y, t[1].z - t[0].z};
  const Point3 v{t[2].x - t[0].x, t[2].y - t[0].y, t[2].z - t[0].z};
  return std::hypot(u.y * v.z - u.z * v.y, u.z * v.x - u.x * v.z, u.x * v.y - u.y * v.x) / 2;
}

bool is_in_volume(const Nef3& set, const std::array<Point3, 3>& t) {
  const auto mean = [&](double Point3::*x) {
    return Rational((Rational(t[0].*x) + Rational(t[1].*x) + Rational(t[2].*x)) / 3);
  };
  const SpaceLocation at =
      set.locate(RationalPoint3{mean(&Point3::x), mean(&Point3::y), mean(&Point3::z)});
  return at.marked && at.item.kind() == SpaceItem::Kind::Volume;
}

/// The facets of pieces of a set that is bounded by one source cover each of its faces once. All
/// other facets are inside the set.
void expect_covered(const Nef3& set, const MeshSource& source, const std::vector<Nef3>& pieces) {
  std::vector<double> covered(source.mesh.face_count(), 0);
  for (const Nef3& piece : pieces) {
    ASSERT_EQ(piece.sources().size(), 1U);
    const MeshWithAttributes made = mesh_with_attributes(piece);
    for (std::size_t f = 0; f < made.mesh.face_count(); ++f) {
      const std::array<Point3, 3> t = corners_of(made.mesh, f);
      const FaceSource from = made.source[f];
      if (from.source == FaceSource::kNone) {
        EXPECT_EQ(made.attributes.face_id[f], MeshAttributes::kNone);
        EXPECT_TRUE(is_in_volume(set, t));
        continue;
      }
      EXPECT_FALSE(from.is_flipped);
      EXPECT_EQ(made.attributes.face_id[f], source.attributes.face_id[from.face]);
      covered[from.face] += area_of(t);
      for (std::size_t i = 0; i < 3; ++i) {
        const double* const place = &made.attributes.channels[0].values[9 * f + 3 * i];
        EXPECT_NEAR(place[0], t[i].x, 1e-12);
        EXPECT_NEAR(place[1], t[i].y, 1e-12);
        EXPECT_NEAR(place[2], t[i].z, 1e-12);
      }
    }
  }
  for (std::size_t f = 0; f < covered.size(); ++f) {
    EXPECT_NEAR(covered[f], area_of(corners_of(source.mesh, f)), 1e-9) << "face " << f;
  }
}

TEST(PiecesWithAttributes, CoverEachFaceOfTheSourceOnce) {
  for (std::uint64_t seed = 0; seed < 12; ++seed) {
    SCOPED_TRACE(seed);
    Dice dice(seed);
    const PolygonMesh mesh = fanned(voxel_mesh(random_voxels(dice, {3, 3, 2}, 5)));
    const auto source = source_of(mesh, 100);
    const Nef3 set = from_source(source);
    for (const DecomposeMethod method :
         {DecomposeMethod::Cuts, DecomposeMethod::Walls, DecomposeMethod::Best}) {
      const bool closed = dice.below(2) == 0;
      SCOPED_TRACE(static_cast<int>(method) * 2 + (closed ? 1 : 0));
      expect_covered(set, *source, decompose(set, {method, closed}).pieces);
    }
    expect_covered(set, *source, decompose_by_walls(set).pieces);
  }
}

TEST(PiecesWithAttributes, DanglingPartsHaveTheSourcesOfTheSet) {
  const Nef3 box = from_source(source_of(fanned(box_mesh({0, 0, 0}, {2, 2, 2})), 0));
  const std::vector<RationalPoint3> line{{1, 1, 1}, {3, 3, 3}};
  const Nef3 set = box + Nef3::polyline(line);
  const ConvexPieces found = decompose(set);
  ASSERT_EQ(found.pieces.size(), 2U);
  for (const Nef3& piece : found.pieces) EXPECT_EQ(piece.sources().size(), 1U);
}

TEST(PiecesWithAttributes, WallsInFacesThatAreGoneHaveTheirAttributes) {
  // The first box stands on a face of the second one, so the only wall of the two pieces is the
  // face of the first box in which the boxes meet.
  const auto first = source_of(fanned(box_mesh({0, 1, 1}, {2, 3, 3})), 0);
  const auto second = source_of(fanned(box_mesh({2, 0, 0}, {4, 4, 4})), 100);
  const Nef3 set = from_source(first) + from_source(second);
  for (const bool closed : {false, true}) {
    const ConvexPieces found = decompose(set, {.closed = closed});
    ASSERT_EQ(found.pieces.size(), 2U);
    double area = 0;
    for (const Nef3& piece : found.pieces) {
      ASSERT_EQ(piece.sources().size(), 2U);
      const MeshWithAttributes made = mesh_with_attributes(piece);
      for (std::size_t f = 0; f < made.mesh.face_count(); ++f) {
        ASSERT_NE(made.source[f].source, FaceSource::kNone);
        EXPECT_FALSE(made.source[f].is_flipped);
        area += area_of(corners_of(made.mesh, f));
      }
    }
    EXPECT_EQ(area, 6 * 4 + 2 * 16 + 4 * 8);
  }
}

TEST(PiecesWithAttributes, SetsWithoutSourcesGivePiecesWithout) {
  const Nef3 set = Nef3::from_mesh(comb_prism(3));
  for (const Nef3& piece : decompose(set).pieces) EXPECT_TRUE(piece.sources().empty());
}

}  // namespace
}  // namespace plumb::testing::pieces_attributes_test
