// Slabs of facets of many corners against the locator, limits of time and memory while they are
// built, and the leaves of box trees: every vertex and edge belongs to one of them.
#include "plumb/space/boolean/contact_leaves.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>
#include <stop_token>
#include <vector>

#include "generate/mesh_solid.h"
#include "generate/meshes.h"
#include "generate/space_scenes.h"
#include "generate/voxel_mesh.h"
#include "plumb/predicates/error.h"
#include "plumb/predicates/plane_signs.h"
#include "plumb/predicates/point3_signs.h"
#include "plumb/space/complex/space_boxes.h"
#include "plumb/space/nef3.h"
#include "plumb/space/planar/facet_site.h"
#include "plumb/space/space_locator.h"

namespace plumb::contact_leaves_test {
namespace {

using testing::Dice;
using testing::SpaceScene;

using Lay = RationalPoint3 (*)(const Rational& x, const Rational& y);

const std::array<Lay, 3> kLays = {[](const Rational& x, const Rational& y) {
                                    return RationalPoint3{x, y, x + 2 * y};
                                  },
                                  [](const Rational& x, const Rational& y) {
                                    return RationalPoint3{x / 3, (x - y) / 7, y};
                                  },
                                  [](const Rational& x, const Rational& y) {
                                    return RationalPoint3{-x, 2 * x, 3 - y};
                                  }};

/// A comb in a plane, with a square hole, a slit and a vertex inside below each tooth; there are
/// many columns of equal height along both axes.
SpaceComplex comb(int teeth, Lay lay) {
  SpaceScene scene;
  const auto at = [&](int x, int y) {
    scene.points.push_back(lay(x, y));
    return static_cast<std::uint32_t>(scene.points.size() - 1);
  };
  testing::SceneFacet facet;
  facet.cycles.push_back({at(0, 0), at(4 * teeth, 0)});
  for (int i = teeth - 1; i >= 0; --i) {
    facet.cycles[0].push_back(at(4 * i + 4, 10 - i % 3));
    facet.cycles[0].push_back(at(4 * i + 2, 4 + i % 2));
  }
  facet.cycles[0].push_back(at(0, 10));
  for (int i = 0; i < teeth; ++i) {
    const int x = 4 * i + 1;
    facet.cycles.push_back({at(x, 1), at(x, 2), at(x + 1, 2), at(x + 1, 1)});
    if (i + 1 < teeth) facet.cycles.push_back({at(x + 2, 1), at(x + 3, 1 + 2 * (i % 2))});
    facet.inner.push_back(at(x, 3));
  }
  scene.facets.push_back(facet);
  return testing::complex_without_volumes(scene);
}

TEST(ContactLeaves, SlabsSayWhatTheLocatorSays) {
  Dice dice(7);
  Context context;
  std::array<int, 4> seen{};
  for (const Lay lay : kLays) {
    SpaceComplex c = comb(9, lay);
    const auto tables = copy(*c.tables);
    c.tables = tables;
    const FacetSlabs slabs(c, FacetId(0), context);
    const SpaceLocator locator(c);
    const auto compare = [&](const RationalPoint3& p) {
      const SpacePoint x = add_point(*tables, p);
      const SpaceItem found = slabs.site(PlacedPoint(c.points(), c.points(), x));
      const SpaceItem there = locator.on_item(p);
      EXPECT_EQ(found.code(), there.code());
      ++seen[there.is_valid() ? static_cast<std::size_t>(there.kind()) : 3];
    };
    for (int x = -1; x <= 37; ++x) {
      for (int y = -1; y <= 11; ++y) compare(lay(x, y));
    }
    for (int i = 0; i < 200; ++i) {
      compare(lay(Rational(dice.between(-2, 75), 2), Rational(dice.between(-1, 22), 2)));
    }
  }
  EXPECT_GT(seen[0], 200);
  for (const int count : seen) EXPECT_GT(count, 100);
}

/// Common points of the facet's plane and two others, which are in no table of the complex.
TEST(ContactLeaves, SitesOfCrossingsAreThoseOfTheirPoints) {
  Dice dice(8);
  Context context;
  int inside = 0;
  for (const Lay lay : kLays) {
    SpaceComplex c = comb(9, lay);
    const auto tables = copy(*c.tables);
    c.tables = tables;
    std::vector<PlaneId> planes;
    for (int i = 0; i < 12; ++i) {
      const auto number = [&] { return Rational(dice.between(-3, 3)); };
      const Rational x(dice.between(0, 72), 2), y(dice.between(0, 20), 2);
      const RationalPoint3 p = lay(x, y), n{number(), number(), Rational(dice.between(1, 3))};
      planes.push_back(tables->planes.intern(n.x, n.y, n.z, Rational(-testing::dot(n, p))).plane());
    }
    const FacetId f(0);
    const FacetSites walks(c, {}, context), sites(c, {&f, 1}, context);
    const SpaceLocator locator(c);
    for (const PlaneId p : planes) {
      for (const PlaneId q : planes) {
        if (det3_sign(c.planes(), p, q, c.facet_plane[0]) == Sign::Zero) continue;
        Point3Table crossing(c.planes());
        const RationalPoint3 x = exact(crossing, crossing.add(p, q, c.facet_plane[0]));
        const SpaceItem there = locator.on_item(x);
        EXPECT_EQ(walks.site(f, p, q, context).code(), there.code());
        EXPECT_EQ(sites.site(f, p, q, context).code(), there.code());
        inside += there == SpaceItem(f) ? 1 : 0;
      }
    }
  }
  EXPECT_GT(inside, 20);
}

/// A plane without some cubes and a star, whose facets reach to infinity and touch themselves. A
/// vertex of a facet is found as itself; for other points the walk along the boundary is asked.
TEST(ContactLeaves, SlabsOfUnboundedFacets) {
  Dice dice(9);
  Context context;
  const Nef3 cubes = testing::solid(voxel_mesh(testing::random_voxels(dice, {7, 6, 2}, 6)));
  const Nef3 plane = Nef3::plane({0, 0, 1, -1}) - cubes - testing::solid(testing::star_prism(7));
  const Rational third(1, 3);
  const Nef3 skewed = plane.transformed(
      {{{{2 * third, third, -third}, {-third, 4 * third, third}, {third, -2 * third, 5 * third}}},
       {third, 2 * third, 7 * third}});
  std::size_t corners = 0, others = 0;
  for (const Nef3* set : {&plane, &skewed}) {
    const SpaceComplex& c = set->complex();
    for (std::uint32_t f = 0; f < c.facet_count(); ++f) {
      const FacetSlabs slabs(c, FacetId(f), context);
      std::vector<std::uint8_t> is_of_facet(c.vertex_count(), 0);
      for (const VertexId v : c.inner_of(FacetId(f))) is_of_facet[v.value()] = 1;
      for (std::uint32_t u = 0; u < c.use_count(); ++u) {
        if (c.use_facet[u] == FacetId(f)) is_of_facet[c.use_origin(UseId(u)).value()] = 1;
      }
      for (std::uint32_t v = 0; v < c.vertex_count(); ++v) {
        const SpacePoint p = c.vertex_point[v];
        if (side(c.points(), p, c.facet_plane[f]) != Sign::Zero) continue;
        const SpaceItem found = slabs.site(PlacedPoint(c.points(), c.points(), p));
        const bool is_corner = is_of_facet[v] != 0;
        const SpaceItem there = is_corner ? SpaceItem(VertexId(v)) : facet_site(c, FacetId(f), p);
        EXPECT_EQ(found.code(), there.code());
        ++(is_corner ? corners : others);
      }
    }
  }
  EXPECT_GT(corners, 100U);
  EXPECT_GT(others, 100U);
}

Context stopped() {
  std::stop_source source;
  source.request_stop();
  return Context({}, source.get_token());
}

TEST(ContactLeaves, SlabsKeepToLimits) {
  const SpaceComplex c = comb(90, kLays[0]);
  const FacetId f(0);
  // As often as it takes for slabs to be built.
  const auto ask = [&](const FacetSites& sites, Context own) {
    for (std::uint32_t v = 0; v < 100; ++v) {
      EXPECT_EQ(sites.site(f, c.vertex_point[v], own).code(), SpaceItem(VertexId(v)).code());
    }
  };
  Limits little_memory, little_time;
  little_memory.max_memory_bytes = 100'000;
  little_time.max_seconds = 1e-9;
  Context context, tight(little_memory);
  EXPECT_THROW(ask(FacetSites(c, {&f, 1}, tight), Context()), Error);
  EXPECT_NO_THROW(tight.charge_memory(100'000, "all of it"));  // nothing is kept

  const FacetSites sites(c, {&f, 1}, context);
  EXPECT_THROW(ask(sites, stopped()), Error);
  EXPECT_THROW(ask(sites, Context(little_time)), Error);
  ask(sites, Context());  // who comes next tries again
  ask(sites, stopped());  // and now they are there
}

// ---------------------------------------------------------------- leaves

bool holds(const Box3& box, const Box3& part) {
  Box3 both = box;
  both.add(part);
  return both == box;
}

/// A leaf without a surface has a box because of what belongs to it; a vertex, an edge belongs to
/// one leaf, whose box holds it.
void expect_owned(const SpaceComplex& c) {
  const ContactLeaves leaves(c, box_of(c));
  LeafCache cache(leaves);
  std::vector<int> vertices(c.vertex_count(), 0), edges(c.edge_count(), 0);
  for (std::size_t i = 0; i < leaves.boxes().size(); ++i) {
    const LeafItems& items = cache[i];
    EXPECT_TRUE(leaves[i].facet.is_valid() || !items.vertices().empty()) << i;
    for (const VertexId v : items.own_vertices()) {
      ++vertices[v.value()];
      EXPECT_TRUE(holds(leaves.boxes()[i], box_of(c, v)));
    }
    for (const LeafEdge& e : items.edges()) {
      ++edges[e.edge.value()];
      EXPECT_TRUE(holds(leaves.boxes()[i], box_of(c, e.edge)));
      EXPECT_EQ(items.vertices()[e.from], c.origin[2 * e.edge.value()]);
      EXPECT_EQ(items.vertices()[e.to], c.origin[2 * e.edge.value() + 1]);
      // Flat: there are no two facets in different planes around it.
      std::vector<PlaneId> planes;
      for (std::uint32_t u = 0; u < c.use_count(); ++u) {
        if (SpaceComplex::edge_of(c.use_halfedge[u]) != e.edge) continue;
        planes.push_back(c.facet_plane[c.use_facet[u].value()]);
      }
      std::ranges::sort(planes);
      EXPECT_EQ(e.is_flat, planes.empty() || planes.front() == planes.back());
      EXPECT_TRUE(!e.is_flat || items.has_flat_edges());
    }
  }
  EXPECT_EQ(std::ranges::count(vertices, 1), std::ptrdiff_t(c.vertex_count()));
  EXPECT_EQ(std::ranges::count(edges, 1), std::ptrdiff_t(c.edge_count()));
}

TEST(ContactLeaves, OwnEveryVertexAndEdgeOnce) {
  for (const Lay lay : kLays) expect_owned(comb(12, lay));
  Dice dice(5);
  for (int i = 0; i < 3; ++i) {
    const Nef3 voxels =
        testing::solid(voxel_mesh(testing::random_voxels(dice, {5, 4, 2}, 4 + 2 * i)));
    expect_owned(voxels.complex());
  }
  expect_owned(testing::solid(testing::star_prism(20)).complex());
  for (int i = 0; i < 20; ++i) expect_owned(testing::complex_of(testing::random_scene(dice)));
}

/// The prism over a polygon of n corners; its sides come first, so that every edge belongs to one
/// of them.
PolygonMesh sides_then_caps(std::uint32_t n) {
  PolygonMesh mesh;
  for (const double z : {0.0, 5.0}) {
    for (std::uint32_t i = 0; i < n; ++i) {
      const double x = i;
      mesh.points.push_back({x, x * (x - n), z});  // on a parabola: convex, counter-clockwise
    }
  }
  for (std::uint32_t i = 0; i < n; ++i) {
    const std::uint32_t j = (i + 1) % n;
    mesh.add_face(std::array<std::uint32_t, 4>{i, j, n + j, n + i});
  }
  std::vector<std::uint32_t> low, high;
  for (std::uint32_t i = 0; i < n; ++i) {
    low.push_back(n - 1 - i);
    high.push_back(n + i);
  }
  mesh.add_face(low);
  mesh.add_face(high);
  return mesh;
}

/// (A leaf that owned nothing had an empty box in a turned frame, which made that frame look
/// useless.)
TEST(ContactLeaves, AreFewWithinReach) {
  const Nef3 prism = testing::solid(sides_then_caps(12));
  const SpaceComplex& c = prism.complex();
  expect_owned(c);
  EXPECT_EQ(ContactLeaves(c, box_of(c)).boxes().size(), 14U);  // corners of caps belong to sides
  EXPECT_TRUE(ContactLeaves(c, box_of(c)).large_facets().empty());
  EXPECT_EQ(ContactLeaves(c, Box3{{-9, -99, 5}, {99, 99, 9}}).boxes().size(),
            13U);  // not the bottom
  EXPECT_TRUE(ContactLeaves(c, Box3{{-9, -99, 6}, {99, 99, 9}}).boxes().empty());
  const SpaceComplex flat = comb(3, kLays[0]), large = comb(9, kLays[0]);
  EXPECT_TRUE(ContactLeaves(flat, box_of(flat)).large_facets().empty()) << "25 corners";
  EXPECT_EQ(ContactLeaves(large, box_of(large)).large_facets().size(), 1U);
}

}  // namespace
}  // namespace plumb::contact_leaves_test
