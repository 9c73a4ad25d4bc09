// Arrays with one wrong entry, each with the complaint that it must cause, and the place of points
// in a facet with a hole, which inequalities tell.
#include <gtest/gtest.h>

#include <functional>
#include <memory>
#include <string>

#include "generate/space_scenes.h"
#include "plumb/predicates/point3_signs.h"
#include "plumb/space/audit/audit_parts.h"

namespace plumb::audit_links_test {

using testing::rational_point;
using testing::SpaceScene;

/// A square with a hole and a vertex inside, an edge and a vertex alone.
SpaceComplex sheet() {
  SpaceScene scene;
  scene.add_facet({rational_point(0, 0, 1), rational_point(6, 0, 1), rational_point(6, 6, 1),
                   rational_point(0, 6, 1)},
                  {{rational_point(2, 2, 1), rational_point(2, 4, 1), rational_point(4, 4, 1),
                    rational_point(4, 2, 1)}});
  scene.facets[0].inner.push_back(scene.add_point(rational_point(1, 1, 1)));
  scene.add_free_edge(rational_point(0, 0, 3), rational_point(1, 0, 3));
  scene.add_point(rational_point(9, 9, 9));
  return testing::complex_of(scene);
}

std::string complaint(const std::function<void(SpaceComplex&)>& damage) {
  Context context;
  SpaceComplex c = sheet();
  damage(c);
  const auto flaw = audit_links(c, context);
  return flaw ? flaw->invariant : "";
}

std::string complaint_of_cycles(const std::function<void(SpaceComplex&)>& damage) {
  Context context;
  SpaceComplex c = sheet();
  damage(c);
  const auto flaw = audit_cycles(c, context);
  return flaw ? flaw->invariant : "";
}

TEST(AuditLinks, TakesWhatIsSound) {
  EXPECT_EQ(complaint([](SpaceComplex&) {}), "");
  EXPECT_EQ(complaint_of_cycles([](SpaceComplex&) {}), "");
}

TEST(AuditLinks, NamesTheWrongEntry) {
  using C = SpaceComplex;
  EXPECT_EQ(complaint([](C& c) { c.facet_origin.push_back(0); }),
            "arrays have one entry for each item");
  EXPECT_EQ(complaint([](C& c) { c.inner_begin[1] = 0; }), "lists cover their arrays");
  EXPECT_EQ(complaint([](C& c) { c.volume_mark[0] = kBeyond + 1; }), "marks are 0, 1 or beyond");
  EXPECT_EQ(complaint([](C& c) { c.edge_planes[8][0] = PlaneId(c.planes().size()); }),
            "an edge has two planes");
  EXPECT_EQ(complaint([](C& c) { c.facet_volume[0][1] = VolumeId(1); }),
            "ids name items that are there");
  EXPECT_EQ(complaint([](C& c) { c.star[0] = HalfedgeId(c.origin.size()); }),
            "ids name items that are there");
  EXPECT_EQ(complaint([](C& c) { c.origin[1] = c.origin[0]; }), "an edge has two ends");
  EXPECT_EQ(complaint([](C& c) { c.star[1] = c.star[0]; }), "a star lists a half-edge once");
  EXPECT_EQ(complaint([](C& c) { c.use_prev[0] = UseId(0); }), "prev undoes next");
  EXPECT_EQ(complaint([](C& c) { c.use_radial[0] = c.use_next[0]; }),
            "a radial cycle stays at its edge");
  EXPECT_EQ(complaint([](C& c) { c.cycle[1] = c.use_next[c.cycle[0].value()]; }),
            "a facet lists a cycle once");
  EXPECT_EQ(complaint([](C& c) { c.vertex_facet[c.inner[0].value()] = FacetId(); }),
            "a facet lists the vertices inside it");
  EXPECT_EQ(complaint([](C& c) { c.edge_volume[0] = VolumeId(0); }),
            "an edge has uses or lies in a volume");
  EXPECT_EQ(complaint([](C& c) { c.vertex_volume[0] = VolumeId(0); }),
            "a vertex alone lies in a volume");
}

TEST(AuditLinks, NamesTheWrongCycle) {
  using C = SpaceComplex;
  EXPECT_EQ(complaint_of_cycles([](C& c) { std::swap(c.cycle[0], c.cycle[1]); }),
            "the first cycle runs around its facet");
  const auto moved_to = [](int x, int y) {
    return [x, y](C& c) {
      const std::shared_ptr<SpaceTables> tables = copy(*c.tables);
      c.vertex_point[c.inner[0].value()] = add_point(*tables, rational_point(x, y, 1));
      c.tables = tables;
    };
  };
  EXPECT_EQ(complaint_of_cycles(moved_to(5, 1)), "");
  for (const auto& [x, y] : {std::pair{3, 3}, {7, 1}, {6, 1}, {2, 3}, {4, 4}}) {
    EXPECT_EQ(complaint_of_cycles(moved_to(x, y)), "an inner vertex lies inside its facet");
  }
}

// Every half-integer place in and around the square: level with corners, on sides and their lines.
TEST(AuditLinks, PlacesPointsInAFacetWithAHole) {
  Context context;
  SpaceComplex c = sheet();
  const std::shared_ptr<SpaceTables> tables = copy(*c.tables);
  SpaceAuditSteps step(context, 0);
  for (int x = -2; x <= 14; ++x) {
    for (int y = -2; y <= 14; ++y) {
      const SpacePoint p = add_point(*tables, {Rational(x, 2), Rational(y, 2), 1});
      const auto is_within = [&](int low, int high) {
        return x >= low && x <= high && y >= low && y <= high;
      };
      const bool is_on =
          (is_within(0, 12) && !is_within(1, 11)) || (is_within(4, 8) && !is_within(5, 7));
      const FacetPlace place = place_in_facet(c, FacetId(0), tables->points, p, step);
      EXPECT_EQ(place.on.is_valid(), is_on) << x << ' ' << y;
      const bool is_inside = !is_on && is_within(0, 12) && !is_within(4, 8);
      EXPECT_EQ(place.is_inside, is_inside) << x << ' ' << y;
    }
  }
}

}  // namespace plumb::audit_links_test
