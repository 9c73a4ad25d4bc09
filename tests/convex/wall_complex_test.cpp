// Complexes cut by walls: marks and ids of the walls, and the volumes between them, by their
// measures and as sets.
#include "plumb/convex/wall/wall_complex.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <vector>

#include "generate/mesh_solid.h"
#include "generate/meshes.h"
#include "plumb/convex/decompose.h"

namespace plumb::wall_complex_test {

Nef3 box(Point3 low, Point3 high) { return testing::solid(testing::box_mesh(low, high)); }

/// Upright polygons to be put into a set.
class Walls {
 public:
  explicit Walls(const Nef3& set) : complex_(set.complex()), tables_(copy(*complex_.tables)) {
    complex_.tables = tables_;
  }
  /// Corners either way around; points are added anew for each wall.
  void add(const std::vector<Point3>& corners) {
    const InputPointId first = tables_->planes.add_points(corners);
    const auto id = [&](std::size_t i) { return InputPointId(first.value() + i); };
    const OrientedPlane plane = tables_->planes.intern(id(0), id(1), id(2));
    WallPolygon wall{plane.plane(), {}};
    for (std::size_t i = 0; i < corners.size(); ++i) wall.corners.emplace_back(id(i));
    if (plane.is_opposite()) std::reverse(wall.corners.begin(), wall.corners.end());
    walls_.push_back(wall);
  }
  void across_x(double x, double low, double high) {
    add({{x, low, low}, {x, high, low}, {x, high, high}, {x, low, high}});
  }
  void across_y(double y, double low, double high) {
    add({{low, y, low}, {high, y, low}, {high, y, high}, {low, y, high}});
  }
  SpaceComplex cut() { return with_walls(complex_, tables_, walls_, unlimited_context()); }

 private:
  SpaceComplex complex_;
  std::shared_ptr<SpaceTables> tables_;
  std::vector<WallPolygon> walls_;
};

std::size_t wall_count(const SpaceComplex& c) {
  std::size_t count = 0;
  for (std::uint32_t f = 0; f < c.facet_count(); ++f) {
    const bool is_new = is_wall(c, FacetId(f));
    EXPECT_TRUE(!is_new || c.facet_mark[f] == kBeyond);
    for (const VolumeId v : c.facet_volume[f]) {
      if (is_new) {
        EXPECT_EQ(c.volume_mark[v.value()], 1);
      }
    }
    count += is_new ? 1 : 0;
  }
  return count;
}

/// Walls become cells of the set.
void mark_walls(SpaceComplex& c) {
  for (std::vector<Mark>* marks :
       std::initializer_list<std::vector<Mark>*>{&c.vertex_mark, &c.edge_mark, &c.facet_mark}) {
    std::replace(marks->begin(), marks->end(), kBeyond, Mark{1});
  }
}

/// Of all marked volumes, ascending.
std::vector<Rational> measures(SpaceComplex c) {
  mark_walls(c);
  std::vector<Rational> all;
  for (const Nef3& set : volumes_as_sets(c, unlimited_context())) {
    EXPECT_FALSE(set.audit());
    all.push_back(*set.volume());
  }
  std::ranges::sort(all);
  return all;
}

TEST(WallComplex, ACubeIsCutByWhatIsInside) {
  const Nef3 cube = box({0, 0, 0}, {6, 6, 6});
  Walls none(cube);
  EXPECT_EQ(wall_count(none.cut()), 0U);
  Walls one(cube);
  one.across_x(2, -1, 9);
  EXPECT_EQ(wall_count(one.cut()), 1U);
  EXPECT_EQ(measures(one.cut()), (std::vector<Rational>{72, 144}));
  Walls apart(cube);
  apart.across_x(8, -1, 9);  // outside
  apart.across_x(6, 0, 6);   // a face
  EXPECT_EQ(wall_count(apart.cut()), 0U);
  EXPECT_EQ(measures(apart.cut()), (std::vector<Rational>{216}));
  Walls loose(cube);
  loose.across_x(3, 1, 5);  // does not reach the boundary
  EXPECT_EQ(wall_count(loose.cut()), 1U);
  EXPECT_EQ(measures(loose.cut()), (std::vector<Rational>{216}));
}

/// Each crosses the other; the same wall twice, and one in the plane of another, is no other wall.
TEST(WallComplex, WallsMayCrossAndOverlap) {
  const Nef3 cube = box({0, 0, 0}, {6, 6, 6});
  Walls cross(cube);
  cross.across_x(2, -1, 9);
  cross.across_y(1, -1, 9);
  cross.across_x(2, -2, 8);
  cross.across_y(1, -1, 9);
  EXPECT_EQ(wall_count(cross.cut()), 4U);
  EXPECT_EQ(measures(cross.cut()), (std::vector<Rational>{12, 24, 60, 120}));
  Walls meet(cube);  // with a common side, of points with ids of their own
  meet.across_x(2, 0, 6);
  meet.add({{2, 3, 0}, {6, 3, 0}, {6, 3, 6}, {2, 3, 6}});
  meet.add({{2, 3, 6}, {2, 3, 0}, {0, 5, 0}, {0, 5, 6}});
  EXPECT_EQ(measures(meet.cut()), (std::vector<Rational>{24, 48, 72, 72}));
}

/// Of an open set the walls, too, and of two volumes either.
TEST(WallComplex, VolumesAreDisjointSetsWithTheirBoundary) {
  const Nef3 step = box({0, 0, 0}, {6, 6, 6}) - box({3, -1, 3}, {9, 9, 9});
  const Nef3 far = box({10, 0, 0}, {12, 6, 6}).interior();
  for (const Nef3& set : {step, step.interior(), step.closure() + far}) {
    Walls walls(set);
    walls.across_x(3, -1, 19);
    walls.across_y(2, -1, 19);
    walls.across_x(11, -1, 19);
    SpaceComplex c = walls.cut();
    mark_walls(c);
    Nef3 sum = Nef3::empty();
    Rational volume = 0;
    for (const Nef3& piece : volumes_as_sets(c, unlimited_context())) {
      EXPECT_FALSE(piece.audit());
      EXPECT_TRUE((sum * piece).is_empty());
      sum = sum + piece;
      volume += *piece.volume();
      EXPECT_TRUE(piece.is_subset_of(set));
    }
    EXPECT_TRUE(sum == set);
    EXPECT_EQ(volume, *set.volume());
  }
}

TEST(WallComplex, WhatIsBesideNoVolumeIsTheRest) {
  const Nef3 cube = box({0, 0, 0}, {2, 2, 2});
  const Nef3 flag = Nef3::facet(std::vector<Point3>{{2, 2, 2}, {5, 2, 2}, {5, 4, 2}});
  const Nef3 whisker = Nef3::segment({0, 0, 0}, {-2, -1, 0});
  const Nef3 dot = Nef3::point({9, 9, 9});
  for (const Nef3& volumes : {cube, cube.interior(), cube + box({7, 7, 7}, {8, 8, 8})}) {
    const Nef3 set = volumes + flag + whisker + dot;
    const Nef3 expected = set - set.interior().closure();
    EXPECT_TRUE(without_volumes(set, unlimited_context()) == expected);
    Nef3 sum = expected;
    for (const Nef3& piece : volumes_as_sets(set.complex(), unlimited_context())) {
      sum = sum + piece;
    }
    EXPECT_TRUE(sum == set);
  }
  EXPECT_TRUE(without_volumes(cube, unlimited_context()).is_empty());
}

}  // namespace plumb::wall_complex_test
