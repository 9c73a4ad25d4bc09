// Components and genus.
#include "plumb/model/parts.h"

#include <gtest/gtest.h>

#include <vector>

#include "plumb/model/primitives.h"

namespace plumb::testing::parts_test {
namespace {

Nef3 cube(int x, int y, int z) {
  return Nef3::from_mesh(box_mesh({1, 1, 1}, Placement::Corner)).translated({x, y, z});
}

/// The components are not empty, disjoint, and their union is the set.
void expect_components(const Nef3& set, std::size_t count) {
  const std::vector<Nef3> parts = components(set);
  EXPECT_EQ(parts.size(), count);
  for (std::size_t i = 0; i < parts.size(); ++i) {
    EXPECT_FALSE(parts[i].is_empty());
    EXPECT_EQ(components(parts[i]).size(), 1U);
    for (std::size_t j = 0; j < i; ++j) EXPECT_TRUE((parts[i] * parts[j]).is_empty());
  }
  EXPECT_EQ(union_of(parts), set);
}

TEST(Components, OfCubes) {
  expect_components(Nef3::empty(), 0);
  expect_components(cube(0, 0, 0), 1);
  expect_components(cube(0, 0, 0) + cube(2, 0, 0), 2);
  expect_components(cube(0, 0, 0) + cube(1, 1, 1), 1);
  expect_components((cube(0, 0, 0) + cube(1, 1, 1)) - Nef3::point({1, 1, 1}), 2);
  expect_components(cube(0, 0, 0).interior() + cube(1, 0, 0).interior(), 2);
  expect_components(cube(0, 0, 0) + cube(1, 0, 0).interior(), 1);
}

TEST(Components, OfFlatParts) {
  const Nef3 wire = Nef3::segment({0, 0, 0}, {3, 0, 0});
  expect_components(wire - Nef3::point({1, 0, 0}), 2);
  expect_components(wire + Nef3::point({5, 5, 5}) + cube(0, 3, 0), 3);
  const std::vector<Point3> square{{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}};
  const Nef3 facet = Nef3::facet(square);
  expect_components(facet - Nef3::point({1, 1, 0}), 1);
  expect_components(facet - Nef3::segment({0, 0, 0}, {2, 2, 0}), 2);
  // A point in a hole of a facet, and a cube in a void.
  const Nef3 large = Nef3::from_mesh(box_mesh({5, 5, 5}, Placement::Corner));
  const Nef3 shell =
      large - Nef3::from_mesh(box_mesh({3, 3, 3}, Placement::Corner)).translated({1, 1, 1});
  expect_components(shell + cube(2, 2, 2), 2);
}

TEST(Genus, OfSurfaces) {
  EXPECT_EQ(genus(cube(0, 0, 0)), 0U);
  EXPECT_EQ(genus(Nef3::from_mesh(torus_mesh(3, 1, 8, 6))), 1U);
  const Nef3 plate = Nef3::from_mesh(box_mesh({5, 5, 1}, Placement::Corner));
  EXPECT_EQ(genus(plate - cube(1, 1, 0) - cube(3, 3, 0)), 2U);
  EXPECT_EQ(genus(cube(0, 0, 0) + cube(3, 0, 0)), 0U);
  EXPECT_EQ(genus(Nef3::empty()), 0U);
  EXPECT_FALSE(genus(cube(0, 0, 0) + cube(1, 1, 0)));
  EXPECT_FALSE(genus(Nef3::whole()));
}

}  // namespace
}  // namespace plumb::testing::parts_test
