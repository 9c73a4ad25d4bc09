// Random solids of every family, by every method: the pieces are convex, disjoint, and make up the
// set. And what once failed elsewhere.
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <array>
#include <string>
#include <vector>

#include "generate/meshes.h"
#include "generate/voxel_mesh.h"
#include "oracle/pieces_check.h"
#include "plumb/convex/decompose.h"
#include "plumb/predicates/error.h"

namespace plumb::testing::decompose_property_test {
namespace {

constexpr std::array kMethods{DecomposeMethod::Cuts, DecomposeMethod::Walls, DecomposeMethod::Best};

Nef3 solid(const PolygonMesh& mesh) {
  Context context;
  return Nef3::from_mesh(mesh, {.rule = WindingRule::NonZero}, context);
}
Nef3 box(Point3 low, Point3 high) { return solid(box_mesh(low, high)); }

std::string flaw(const Nef3& set, DecomposeMethod method, bool closed) {
  Context context;
  return flaw_of_pieces(set, decompose(set, {method, closed}, context), closed);
}

int between(int low, int high) { return *rc::gen::inRange(low, high + 1); }

/// By one method, open or closed.
void require_pieces(const Nef3& set) {
  const DecomposeMethod method = kMethods[static_cast<std::size_t>(between(0, 2))];
  const bool closed = between(0, 1) == 1;
  RC_ASSERT(flaw(set, method, closed) == "");
}

/// Of solids without holes and voids.
void require_few_cuts(const Nef3& set) {
  Context context;
  const ConvexPieces pieces = decompose(set, {DecomposeMethod::Cuts, false}, context);
  RC_ASSERT(pieces.pieces.size() <= bound_of_cuts(1, pieces.reflex_edges));
}

template <class Law>
void expect_law(const Law& law) {
  EXPECT_TRUE(rc::check(law));
}

// ---------------------------------------------------------------- families

/// One change of a set: what it takes four points of a lattice for. Zeros, to which numbers shrink,
/// are the simplest.
using Change = std::array<std::uint8_t, 5>;

Point3 lattice_point(std::uint8_t code) {
  return {static_cast<double>(code % 5), static_cast<double>(code / 5 % 5),
          static_cast<double>(code / 25 % 5)};
}
RationalPoint3 exact(Point3 p) { return {p.x, p.y, p.z}; }

Nef3 changed(const Nef3& set, const Change& change) {
  const Point3 a = lattice_point(change[0]), b = lattice_point(change[1]),
               c = lattice_point(change[2]), d = lattice_point(change[3]);
  try {
    switch (change[4] % 6) {
      case 0:
        return set - solid(make_mesh({a, b, c, d}, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}));
      case 1:
        return set - solid(make_mesh({a, b, c, d}, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}))
                         .interior();
      case 2:
        return set ^ solid(make_mesh({a, b, c, d}, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}));
      case 3:
        return set - Nef3::facet(std::vector<RationalPoint3>{exact(a), exact(b), exact(c)});
      case 4:
        return set - Nef3::segment(exact(a), exact(b));
      default:
        return set - Nef3::point(exact(a));
    }
  } catch (const Error&) {  // flat
    return set;
  }
}

std::vector<Change> any_changes(std::size_t most) {
  const auto change = rc::gen::container<Change>(rc::gen::inRange<std::uint8_t>(0, 125));
  auto changes = *rc::gen::container<std::vector<Change>>(change);
  if (changes.size() > most) changes.resize(most);
  return changes;
}

TEST(Pieces, OfLatticePolyhedra) {
  expect_law([] {
    Nef3 set = box({0, 0, 0}, {4, 4, 4});
    for (const Change& change : any_changes(3)) set = changed(set, change);
    require_pieces(set);
  });
}

/// Axes in another order, and slanted.
Nef3 turned(const Nef3& set) {
  const auto first = static_cast<std::size_t>(between(0, 2));
  AffineMap3 map;
  for (std::size_t i = 0; i < 3; ++i) map.matrix[i][(i + first) % 3] = 1;
  map.matrix[0][(first + 1) % 3] = between(0, 2);
  return set.transformed(map);
}

TEST(Pieces, OfCombsAndStars) {
  expect_law([] {
    const int top = between(0, 3);
    const int bottom = between(0, 3);
    require_pieces(turned(solid(comb_block(top, bottom))));
    require_few_cuts(turned(solid(comb_block(top + between(0, 5), bottom + between(0, 5)))));
    require_pieces(turned(solid(star_prism(between(3, 9)))));
  });
}

TEST(Pieces, OfPrismsWithHoles) {
  expect_law([] {
    Nef3 set = box({0, 0, 0}, {8, 8, 2});
    for (int i = between(1, 3); i > 0; --i) {
      const auto x = static_cast<double>(between(0, 6));
      const auto y = static_cast<double>(between(0, 6));
      const auto low = static_cast<double>(between(-1, 1));
      const auto wide = static_cast<double>(between(1, 2));
      set -= solid(prism_mesh({{x, y}, {x + 2, y}, {x + 1, y + wide}}, low, 3));
    }
    require_pieces(turned(set));
  });
}

TEST(Pieces, OfSolidsWithVoids) {
  expect_law([] {
    Nef3 set = box({0, 0, 0}, {9, 9, 9});
    for (int i = between(1, 2); i > 0; --i) {
      const auto x = static_cast<double>(between(1, 5));
      const auto y = static_cast<double>(between(1, 5));
      const auto z = static_cast<double>(between(1, 5));
      set -= solid(tetrahedron_mesh({x, y, z}, {x, y + 2, z}, {x + 3, y, z}, {x, y, z + 3}));
    }
    require_pieces(turned(set));
  });
}

TEST(Pieces, OfTerrains) {
  expect_law([] {
    Dice dice(*rc::gen::arbitrary<std::uint64_t>());
    const int width = between(1, 3);
    const int depth = between(1, 3);
    const Nef3 terrain = turned(solid(voxel_mesh(random_terrain(dice, width, depth, 3))));
    require_pieces(terrain);
    require_few_cuts(terrain);
  });
}

// ---------------------------------------------------------------- what failed elsewhere

/// By all methods.
void expect_pieces(const Nef3& set, const std::string& name) {
  for (const DecomposeMethod method : kMethods) {
    EXPECT_EQ(flaw(set, method, false), "") << name << ", method " << static_cast<int>(method);
  }
}

// Reported of another library: a facet with a hole gave a piece without points.
TEST(Pieces, OfFacetsWithHolesAreNotEmpty) {
  const Nef3 slab = box({0, 0, 0}, {9, 9, 2});
  const Nef3 pillar = box({3, 3, 2}, {6, 6, 5});
  const Nef3 shaft = box({4, 4, -1}, {5, 5, 6});
  for (const Nef3& set : {slab + pillar, slab - box({3, 3, 1}, {6, 6, 3}), slab + pillar - shaft,
                          slab - shaft, slab + pillar + box({3, 3, -3}, {6, 6, 0})}) {
    expect_pieces(set, "a facet with a hole");
    Context context;
    for (const DecomposeMethod method : kMethods) {
      for (const Nef3& piece : decompose(set, {method, false}, context).pieces) {
        EXPECT_EQ(piece.counts().marked_volumes, 1U);
      }
    }
  }
}

/// Steps around a post: the cell above a step lies above itself a turn later.
Nef3 winding_stairs(int steps) {
  constexpr std::array<Point2, 5> kAround{{{4, 0}, {0, 4}, {-4, 0}, {0, -4}, {4, 0}}};
  Nef3 set;
  for (int i = 0; i < steps; ++i) {
    const auto at = static_cast<std::size_t>(i % 4);
    set += solid(prism_mesh({{0, 0}, kAround[at], kAround[at + 1]}, i, i + 1.5));
  }
  return set;
}

// Reported of another library: it went on for ever.
TEST(Pieces, OfWindingSolidsComeToAnEnd) {
  expect_pieces(winding_stairs(6), "six stairs");
  expect_pieces(box({-5, -5, -1}, {5, 5, 8}) - winding_stairs(5), "a winding hole");
  // Two wedges that share the line their reflex edges lie on.
  const Nef3 wedge = solid(prism_mesh({{0, 0}, {4, 1}, {4, 4}, {1, 4}}, 0, 2));
  expect_pieces(box({-4, -4, 0}, {4, 4, 6}) - wedge -
                    wedge.transformed({{{{-1, 0, 0}, {0, -1, 0}, {0, 0, 1}}}, {0, 0, 3}}),
                "wedges back to back");
}

// Reported of another library: coplanar facets and edges made it stop with a failed assertion.
TEST(Pieces, OfCoplanarNotchesAreFound) {
  Nef3 set = box({0, 0, 0}, {9, 9, 6});
  for (const double x : {1.0, 4.0, 7.0}) {
    set -= box({x, -1, 4}, {x + 1, 10, 7});
    set -= box({x, -1, -1}, {x + 1, 4, 2});
  }
  expect_pieces(set, "notches of one depth, above one another");
  set -= box({-1, 4, 4}, {10, 5, 7});
  expect_pieces(set, "and across");
  expect_pieces(solid(fanned(comb_block(2, 2))), "faces in triangles");
  expect_pieces(solid(fanned(voxel_mesh([] {
                  Dice dice(3);
                  return random_terrain(dice, 4, 4, 3);
                }()))),
                "a terrain of triangles");
}

}  // namespace
}  // namespace plumb::testing::decompose_property_test
