// Faces as features: areas add up, and each feature is a face.
#include "plumb/plane/plane_faces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "plumb/predicates/plane/plane_points.h"

namespace plumb::testing::plane_faces_test {
namespace {

Rational twice_area(const Layer& layer, std::size_t feature) {
  Rational sum = 0;
  for (std::uint32_t p = layer.feature_begin[feature]; p < layer.feature_begin[feature + 1]; ++p) {
    for (std::uint32_t r = layer.polygon_begin[p]; r < layer.polygon_begin[p + 1]; ++r) {
      sum += twice_polygon_area(layer.points, layer.ring(r));
    }
  }
  return sum;
}

/// Two crossing squares in outline make three faces; a third one inside makes a hole.
TEST(PlaneFaces, LinesBoundFaces) {
  const std::vector<Point2> a{{0, 0}, {6, 0}, {6, 6}, {0, 6}, {0, 0}};
  const std::vector<Point2> b{{4, 4}, {8, 4}, {8, 8}, {4, 8}, {4, 4}};
  const std::vector<Point2> c{{1, 1}, {2, 1}, {2, 2}, {1, 2}, {1, 1}};
  const std::vector<Point2> dangling{{6, 0}, {9, -3}};
  const Nef2 lines =
      Nef2::polyline(a) + Nef2::polyline(b) + Nef2::polyline(c) + Nef2::polyline(dangling);
  const Layer faces = layer_of_faces(lines.complement());
  ASSERT_EQ(faces.feature_count(), 4U);
  std::vector<Rational> areas;
  for (std::size_t f = 0; f < 4; ++f) areas.push_back(twice_area(faces, f) / 2);
  std::sort(areas.begin(), areas.end());
  EXPECT_EQ(areas, (std::vector<Rational>{1, 4, 12, 31}));
}

/// A hole that touches the outer ring makes two rings that share a point, and no ring visits a
/// point twice.
TEST(PlaneFaces, RingsAreSimple) {
  const std::vector<Point2> square{{0, 0}, {4, 0}, {4, 4}, {0, 4}};
  const std::vector<Point2> hole{{0, 0}, {2, 1}, {1, 2}};
  const Layer faces = layer_of_faces(Nef2::polygon(square) - Nef2::polygon(hole));
  ASSERT_EQ(faces.feature_count(), 1U);
  ASSERT_EQ(faces.ring_count(), 2U);
  EXPECT_EQ(faces.ring(0).size(), 4U);
  EXPECT_EQ(faces.ring(1).size(), 3U);
  EXPECT_EQ(twice_area(faces, 0), 2 * 16 - 3);
}

TEST(PlaneFaces, UnboundedFacesAreLeftOut) {
  EXPECT_EQ(layer_of_faces(Nef2::whole()).feature_count(), 0U);
  EXPECT_EQ(layer_of_faces(Nef2::empty()).feature_count(), 0U);
}

}  // namespace
}  // namespace plumb::testing::plane_faces_test
