// Meshes that are seen to be star-shaped, held against the search for crossings and components,
// which they spare; and meshes that look so from every facet, but wind twice around their centre.
#include "plumb/space/mesh/star_shape.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include "generate/meshes.h"
#include "plumb/base/context.h"
#include "plumb/predicates/rounding.h"
#include "plumb/space/mesh/link_facets.h"
#include "plumb/space/mesh/mesh_crossings.h"
#include "plumb/space/mesh/mesh_topology.h"
#include "plumb/testing/dice.h"

namespace plumb::star_shape_test {
namespace {

using testing::Dice;
using testing::Face;

/// What is found of a mesh with and without the test.
struct Found {
  bool is_plain = false;
  Sign star = Sign::Zero;
  MeshComponents components;
  std::size_t crossings = 0;
};

Found look_at(const PolygonMesh& mesh) {
  Context context;
  MeshReport report;
  const auto tables = std::make_shared<SpaceTables>();
  const MeshVertices vertices = merge_equal_points(mesh, *tables);
  const MeshFacets facets = flatten_mesh(mesh, vertices, *tables, report, context);
  const MeshLinks links = link_corners(facets, vertices.point.size());
  Found found;
  found.is_plain = is_plainly_closed(facets, links);
  if (!found.is_plain) return found;
  found.star = star_orientation(facets, vertices.point, tables->points);
  const SpaceComplex complex = link_facets(facets, links, vertices.point, tables);
  found.components = find_components(complex, facets.jump);
  const std::vector<std::uint8_t> no_fans(complex.vertex_count(), 0);
  found.crossings = find_mesh_crossings(complex, no_fans, context).size();
  return found;
}

PolygonMesh turned_over(const PolygonMesh& mesh) {
  PolygonMesh result;
  result.points = mesh.points;
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    std::vector<std::uint32_t> face(mesh.face(f).begin(), mesh.face(f).end());
    std::ranges::reverse(face);
    result.add_face(face);
  }
  return result;
}

/// The same mesh at a third of its size. Most of its vertices are not doubles.
PolygonMesh third_of(PolygonMesh mesh) {
  for (std::uint32_t v = 0; v < mesh.points.size(); ++v) {
    Point3& p = mesh.points[v];
    mesh.exact.emplace_back(v, RationalPoint3{exact_rational(p.x) / 3, exact_rational(p.y) / 3,
                                              exact_rational(p.z) / 3});
    p = {p.x / 3, p.y / 3, p.z / 3};
  }
  return mesh;
}

/// A sphere whose vertices move along their radii, or anywhere, by up to `share` of the radius.
PolygonMesh rough_sphere(Dice& dice, int depth, double share, bool along_radii) {
  PolygonMesh mesh = testing::icosphere_mesh(depth, 1, {0, 0, 0});
  const auto random = [&] { return share * static_cast<double>(dice.between(-1000, 1000)) / 1000; };
  for (Point3& p : mesh.points) {
    const double factor = 1 + random();
    if (along_radii) {
      p = {p.x * factor, p.y * factor, p.z * factor};
    } else {
      p = {p.x + random(), p.y + random(), p.z + random()};
    }
  }
  return mesh;
}

// A mesh that is seen to be star-shaped has no crossings and one component, of that orientation.
TEST(StarShape, SparesSearchesThatFindNothing) {
  Dice dice(97);
  std::size_t stars = 0, others = 0, crossing = 0;
  for (int round = 0; round < 120; ++round) {
    const double share = static_cast<double>(dice.between(1, 60)) / 100;
    PolygonMesh mesh = rough_sphere(dice, 1 + round % 2, share, round % 3 != 0);
    const bool is_turned = dice.below(2) == 0;
    if (is_turned) mesh = turned_over(mesh);
    if (dice.below(2) == 0) mesh = third_of(std::move(mesh));
    const Found found = look_at(mesh);
    ASSERT_TRUE(found.is_plain);
    crossing += found.crossings > 0 ? 1 : 0;
    if (found.star == Sign::Zero) {
      ++others;
      continue;
    }
    ++stars;
    EXPECT_EQ(found.star, is_turned ? Sign::Negative : Sign::Positive);
    EXPECT_EQ(found.crossings, 0U);
    ASSERT_EQ(found.components.volume.size(), 1U);
    EXPECT_EQ(found.components.volume[0], found.star);
    EXPECT_EQ(std::ranges::count(found.components.of_facet, 0U),
              static_cast<std::ptrdiff_t>(found.components.of_facet.size()));
  }
  EXPECT_GT(stars, 20U);
  EXPECT_GT(others, 20U);
  EXPECT_GT(crossing, 5U);
}

// Convex meshes are star-shaped around every mean of their vertices, whatever their place and size.
TEST(StarShape, SeesConvexMeshes) {
  Dice dice(98);
  for (int round = 0; round < 60; ++round) {
    const auto random = [&] {
      return std::ldexp(static_cast<double>(dice.between(-999, 999)), -9);
    };
    const Point3 low{random(), random(), random()};
    const double size = std::ldexp(1.0, static_cast<int>(dice.between(-3, 6)));
    const Point3 high{low.x + size, low.y + 2 * size, low.z + size / 2};
    EXPECT_EQ(look_at(testing::box_mesh(low, high)).star, Sign::Positive);
    EXPECT_EQ(look_at(turned_over(testing::box_mesh(low, high))).star, Sign::Negative);
    EXPECT_EQ(look_at(testing::icosphere_mesh(2, size, low)).star, Sign::Positive);
    EXPECT_EQ(look_at(third_of(testing::box_mesh(low, high))).star, Sign::Positive);
    EXPECT_EQ(look_at(third_of(testing::icosphere_mesh(2, size, low))).star, Sign::Positive);
  }
}

/// Two apexes above and below n points on a circle, of which each is joined to the one `step`
/// further.
PolygonMesh bipyramid(std::uint32_t n, std::uint32_t step) {
  std::vector<Point3> points{{0, 0, 1}, {0, 0, -1}};
  std::vector<Face> faces;
  for (std::uint32_t i = 0; i < n; ++i) {
    const double angle = 6.283185307179586 * i / n;
    points.push_back({std::cos(angle), std::sin(angle), 0});
    const std::uint32_t a = 2 + i, b = 2 + (i + step) % n;
    faces.push_back({0, a, b});
    faces.push_back({1, b, a});
  }
  return testing::make_mesh(points, faces);
}

// All facets of a bipyramid over a star polygon face away from the centre, which it surrounds
// several times, so that its facets cross.
TEST(StarShape, CountsHowOftenTheCentreIsSurrounded) {
  for (const auto& [n, step] : {std::pair{5U, 1U}, {7U, 1U}, {5U, 2U}, {7U, 2U}, {7U, 3U}}) {
    const Found found = look_at(bipyramid(n, step));
    ASSERT_TRUE(found.is_plain);
    EXPECT_EQ(found.star, step == 1 ? Sign::Positive : Sign::Zero) << n << "/" << step;
    EXPECT_EQ(found.crossings > 0, step != 1);
    EXPECT_EQ(look_at(third_of(bipyramid(n, step))).star, found.star) << n << "/" << step;
  }
}

// Two boxes, one box in another one, and a notched prism with no point that sees all of it.
TEST(StarShape, LeavesOtherMeshesToTheSearches) {
  const auto both = [](PolygonMesh a, const PolygonMesh& b) {
    const auto shift = static_cast<std::uint32_t>(a.points.size());
    a.points.insert(a.points.end(), b.points.begin(), b.points.end());
    for (std::size_t f = 0; f < b.face_count(); ++f) {
      std::vector<std::uint32_t> face(b.face(f).begin(), b.face(f).end());
      for (std::uint32_t& v : face) v += shift;
      a.add_face(face);
    }
    return a;
  };
  const PolygonMesh box = testing::box_mesh({-1, -1, -1}, {1, 1, 1});
  const PolygonMesh inner = testing::box_mesh({-0.5, -0.5, -0.5}, {0.5, 0.5, 0.5});
  EXPECT_EQ(look_at(both(box, testing::box_mesh({2, 0, 0}, {3, 1, 1}))).star, Sign::Zero);
  EXPECT_EQ(look_at(both(box, inner)).star, Sign::Zero);
  EXPECT_EQ(look_at(both(box, turned_over(inner))).star, Sign::Zero);
  const std::vector<Point2> notched{{0, 0}, {9, 0}, {9, 9}, {8, 9}, {8, 1}, {1, 1}, {1, 9}, {0, 9}};
  EXPECT_EQ(look_at(testing::prism_mesh(notched, 0, 1)).star, Sign::Zero);
}

}  // namespace
}  // namespace plumb::star_shape_test
