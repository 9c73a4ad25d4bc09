// Complexes with one item at a wrong place, each with the complaint that it must cause, and all
// orders of facets around an edge, of which one is right.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "generate/space_scenes.h"
#include "plumb/predicates/point3_signs.h"
#include "plumb/space/audit/audit_parts.h"

namespace plumb::audit_places_test {

using testing::rational_point;
using testing::SpaceScene;

std::string complaint(const SpaceComplex& c, std::uint8_t has_fan = 0) {
  Context context;
  const std::vector<std::uint8_t> fans(c.vertex_count(), has_fan);
  const auto flaw = audit_places(c, fans, context);
  return flaw ? flaw->invariant : "";
}

/// A box, an edge and a vertex alone.
SpaceComplex box() {
  SpaceScene scene;
  testing::add_box(scene, rational_point(0, 0, 0), rational_point(4, 4, 4));
  scene.add_free_edge(rational_point(4, 4, 4), rational_point(5, 6, 7));
  scene.add_point(rational_point(9, 9, 9));
  return testing::complex_of(scene);
}

std::string complaint_of(const std::function<void(SpaceComplex&)>& damage) {
  SpaceComplex c = box();
  damage(c);
  return complaint(c);
}

TEST(AuditPlaces, NamesTheWrongPlace) {
  using C = SpaceComplex;
  EXPECT_EQ(complaint_of([](C&) {}), "");
  EXPECT_EQ(complaint_of([](C& c) { c.vertex_point.back() = c.vertex_point[0]; }),
            "vertices have different points");
  for (const std::size_t e : {std::size_t{0}, box().edge_count() - 1}) {
    EXPECT_EQ(complaint_of([e](C& c) { c.edge_planes[e][0] = c.edge_planes[e][1]; }),
              "the planes of an edge cross");
    EXPECT_EQ(complaint_of([e](C& c) { std::swap(c.edge_planes[e][0], c.edge_planes[e][1]); }),
              "an edge runs as its planes say");
    EXPECT_EQ(complaint_of([e](C& c) {
                const std::shared_ptr<SpaceTables> tables = copy(*c.tables);
                c.vertex_point[c.origin[2 * e + 1].value()] =
                    add_point(*tables, {Rational(1, 3), Rational(2, 7), 50});
                c.tables = tables;
              }),
              "the ends of an edge lie on its planes");
  }
  EXPECT_EQ(complaint_of([](C& c) { c.facet_plane[0] = c.facet_plane[2]; }),
            "the edges of a facet lie in its plane");
}

// Five pages of a book: all orders that begin with the first page.
TEST(AuditPlaces, TakesOneOrderAroundAnEdge) {
  SpaceScene scene;
  const RationalPoint3 low = rational_point(0, 0, 0), high = rational_point(0, 0, 1);
  for (const auto& [x, y] : {std::pair{1, 0}, {-1, 0}, {2, 1}, {0, -1}, {2, 3}}) {
    scene.add_facet({low, high, rational_point(x, y, 0)});
  }
  const SpaceComplex c = testing::complex_of(scene);
  ASSERT_EQ(complaint(c), "");
  std::vector<UseId> ring;
  for (std::size_t e = 0; e < c.edge_count(); ++e) {
    const UseId first = c.edge_use[e];
    if (c.use_radial[first.value()] == first) continue;
    UseId u = first;
    do {
      ring.push_back(u);
      u = c.use_radial[u.value()];
    } while (u != first);
  }
  ASSERT_EQ(ring.size(), 5U);
  const std::vector<UseId> right = ring;
  std::sort(ring.begin() + 1, ring.end());
  do {
    SpaceComplex turned = c;
    for (std::size_t i = 0; i < 5; ++i) turned.use_radial[ring[i].value()] = ring[(i + 1) % 5];
    EXPECT_EQ(complaint(turned),
              ring == right ? "" : "facets turn counter-clockwise around an edge");
  } while (std::next_permutation(ring.begin() + 1, ring.end()));
}

// One edge on another, opposite to it, and beside it, all from one vertex.
TEST(AuditPlaces, ComparesDirectionsUnlessThereIsAFan) {
  const auto with_edge_to = [](int x, int y, int z) {
    SpaceScene scene;
    scene.add_free_edge(rational_point(0, 0, 0), rational_point(1, 2, 3));
    scene.add_free_edge(rational_point(0, 0, 0), rational_point(x, y, z));
    return testing::complex_of(scene);
  };
  EXPECT_EQ(complaint(with_edge_to(2, 4, 6)), "edges leave a vertex in different directions");
  EXPECT_EQ(complaint(with_edge_to(2, 4, 6), 1), "");
  EXPECT_EQ(complaint(with_edge_to(-2, -4, -6)), "");
  EXPECT_EQ(complaint(with_edge_to(2, 4, 5)), "");
}

// Two corners that cross at a vertex, and an edge within a corner.
TEST(AuditPlaces, KeepsCornersApart) {
  const auto with_corner = [](const RationalPoint3& a, const RationalPoint3& b) {
    SpaceScene scene;
    scene.add_facet({rational_point(0, 0, 0), rational_point(4, 0, 0), rational_point(0, 4, 0)});
    scene.add_facet({rational_point(0, 0, 0), a, b});
    return complaint(testing::complex_without_volumes(scene));
  };
  EXPECT_EQ(with_corner(rational_point(1, 1, 1), rational_point(1, 1, -1)), "corners do not cross");
  EXPECT_EQ(with_corner(rational_point(1, 1, 0), rational_point(0, 0, 1)),
            "a corner turns to the next edge in its plane");
  EXPECT_EQ(with_corner(rational_point(-1, 1, 1), rational_point(-1, 1, -1)), "");
}

}  // namespace plumb::audit_places_test
