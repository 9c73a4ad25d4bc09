// A set taken apart by dimension: its parts are disjoint, together the set, and each is one cell of
// its dimension with boundary.
#include "plumb/convex/wall/set_parts.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "generate/mesh_solid.h"
#include "generate/meshes.h"

namespace plumb::set_parts_test {

Nef3 box(Point3 low, Point3 high) { return testing::solid(testing::box_mesh(low, high)); }
Nef3 square(double x, double y, double size) {
  return Nef3::facet(
      std::vector<Point3>{{x, y, 0}, {x + size, y, 0}, {x + size, y + size, 0}, {x, y + size, 0}});
}

/// Dimensions of the parts; checks all that is asked of them.
std::vector<int> dimensions_of(const Nef3& set) {
  Nef3 sum = Nef3::empty();
  std::vector<int> dimensions;
  for (const SetPart& part : parts_of(set, unlimited_context())) {
    EXPECT_FALSE(part.set.audit());
    EXPECT_TRUE((sum * part.set).is_empty());
    sum = sum + part.set;
    dimensions.push_back(part.dimension);
    const SpaceComplex& c = part.set.complex();
    EXPECT_EQ(std::ranges::count(c.volume_mark, Mark{1}), part.dimension == 3 ? 1 : 0);
    if (part.dimension < 3) {
      EXPECT_EQ(std::ranges::count(c.facet_mark, Mark{1}), part.dimension == 2 ? 1 : 0);
    }
    if (part.dimension < 2) {
      EXPECT_EQ(std::ranges::count(c.edge_mark, Mark{1}), part.dimension == 1 ? 1 : 0);
    }
    if (part.dimension == 0) {
      EXPECT_EQ(c.vertex_count(), 1U);
    }
  }
  EXPECT_TRUE(sum == set);
  EXPECT_TRUE(std::ranges::is_sorted(dimensions, std::ranges::greater()));
  return dimensions;
}

TEST(SetParts, NothingHasNoneAndOneCellOne) {
  using Dimensions = std::vector<int>;
  EXPECT_EQ(dimensions_of(Nef3::empty()), Dimensions());
  EXPECT_EQ(dimensions_of(Nef3::whole()), Dimensions{3});
  EXPECT_EQ(dimensions_of(Nef3::point({1, 2, 3})), Dimensions{0});
  EXPECT_EQ(dimensions_of(Nef3::segment({0, 0, 0}, {1, 2, 3})), Dimensions{1});
  EXPECT_EQ(dimensions_of(square(0, 0, 2)), Dimensions{2});
  EXPECT_EQ(dimensions_of(box({0, 0, 0}, {1, 1, 1})), Dimensions{3});
}

/// What touches a volume is beside it; what is common goes to one.
TEST(SetParts, CellsOfAllDimensionsThatTouch) {
  const Nef3 two = box({0, 0, 0}, {2, 2, 2}) + box({2, 2, 0}, {4, 4, 2});  // with a common edge
  EXPECT_EQ(dimensions_of(two), (std::vector<int>{3, 3}));
  EXPECT_EQ(dimensions_of(two.interior() + Nef3::segment({2, 2, 0}, {2, 2, 2})),
            (std::vector<int>{3, 3}));
  const Nef3 flag = two + square(4, 4, 3) + square(7, 4, 3).interior();
  EXPECT_EQ(dimensions_of(flag), (std::vector<int>{3, 3, 2}));
  EXPECT_EQ(dimensions_of(flag + Nef3::segment({0, 0, 0}, {-1, -1, -1}) + Nef3::point({9, 9, 9})),
            (std::vector<int>{3, 3, 2, 1, 0}));
  EXPECT_EQ(dimensions_of(Nef3::segment({0, 0, 0}, {2, 0, 0}) - Nef3::point({1, 0, 0})),
            (std::vector<int>{1, 1}));
}

/// Facets with slits, holes and points of their own or taken away.
TEST(SetParts, FacetsKeepWhatIsInsideThem) {
  const Nef3 sheet = square(0, 0, 6);
  const Nef3 slit = Nef3::segment({1, 1, 0}, {3, 2, 0});
  const Nef3 hole = square(4, 4, 1);
  const Nef3 dot = Nef3::point({2, 5, 0});
  const Nef3 whisker = Nef3::segment({5, 1, 0}, {5, 1, 2});
  EXPECT_EQ(dimensions_of(sheet - slit), std::vector<int>{2});
  EXPECT_EQ(dimensions_of(sheet - hole - dot), std::vector<int>{2});
  EXPECT_EQ(dimensions_of(sheet - slit - hole - dot + whisker), (std::vector<int>{2, 1}));
  EXPECT_EQ(dimensions_of(sheet - hole + dot + Nef3::point({4.5, 4.5, 0}) + whisker),
            (std::vector<int>{2, 1, 0}));
}

TEST(SetParts, UnboundedSetsToo) {
  const Nef3 half = Nef3::half_space({0, 0, 1, 0}, Boundary::Open);  // z < 0
  const Nef3 apart = box({0, 0, 1}, {2, 2, 3}) + half;
  EXPECT_EQ(dimensions_of(apart), (std::vector<int>{3, 3}));
  const Nef3 plane = Nef3::plane({0, 0, 1, -5});
  EXPECT_EQ(dimensions_of(apart + plane + Nef3::point({0, 0, 4})), (std::vector<int>{3, 3, 2, 0}));
  EXPECT_EQ(dimensions_of(plane - Nef3::plane({1, 0, 0, 0})), (std::vector<int>{2, 2}));
}

/// Meanwhile they have an id that no wall has, and ids below those of walls stay.
TEST(SetParts, FacetsWithoutNamesGetThemBack) {
  const Nef3 cube = box({0, 0, 0}, {1, 1, 1});
  const std::vector<std::uint32_t> origins = {7, kNoOrigin, kWallOrigin, 0, kUnnamed - 1, 3};
  const Nef3 set = cube.with_origins(origins);
  EXPECT_TRUE(has_unnamed(set));
  const Nef3 named = with_names(set);
  EXPECT_FALSE(has_unnamed(named));
  std::vector<Nef3> pieces = {named};
  remove_names(pieces);
  const std::vector<std::uint32_t> expected = {7, kNoOrigin, kNoOrigin, 0, kUnnamed - 1, 3};
  EXPECT_EQ(pieces[0].complex().facet_origin, expected);
  EXPECT_FALSE(has_unnamed(cube.with_origins(std::vector<std::uint32_t>(6, kUnnamed))));
  for (const SetPart& part : parts_of(set + Nef3::point({5, 5, 5}), unlimited_context())) {
    std::vector<std::uint32_t> kept = part.set.complex().facet_origin, all = origins;
    std::ranges::sort(kept);
    std::ranges::sort(all);
    if (part.dimension == 3) {
      EXPECT_EQ(kept, all);
    }
  }
}

}  // namespace plumb::set_parts_test
