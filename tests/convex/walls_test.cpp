// Vertical walls: pieces are convex, disjoint, and make up the set; how many there are; which
// facets are walls.
#include "plumb/convex/walls.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "generate/mesh_solid.h"
#include "generate/meshes.h"
#include "oracle/pieces_check.h"
#include "plumb/convex/decompose.h"
#include "plumb/predicates/error.h"
#include "plumb/predicates/point3_signs.h"
#include "plumb/space/space_audit.h"
#include "plumb/testing/dice.h"

namespace plumb::testing::walls_test {
namespace {

Nef3 box(Point3 low, Point3 high) { return solid(box_mesh(low, high)); }

// ---------------------------------------------------------------- what is asked

/// Empty, or what is wrong with the pieces, open or closed.
std::string fault(const Nef3& set, bool closed) {
  Context context;
  const ConvexPieces pieces = decompose_by_walls(set, {DecomposeMethod::Walls, closed}, context);
  return flaw_of_pieces(set, pieces, closed);
}
std::string fault(const Nef3& set) {
  const std::string open = fault(set, false), closed = fault(set, true);
  return open.empty() ? closed : open;
}

std::size_t piece_count(const Nef3& set) {
  Context context;
  return decompose_by_walls(set, {DecomposeMethod::Walls, false}, context).pieces.size();
}

// ---------------------------------------------------------------- families

/// A slab with V-shaped grooves along x on top, and with them along y below: every upper wall
/// crosses every lower one.
Nef3 crossed_grooves(int count) {
  Nef3 set = box({0, 0, 0}, {static_cast<double>(4 * count), static_cast<double>(4 * count), 10});
  for (int i = 0; i < count; ++i) {
    const double at = 4 * i + 2, end = 4 * count + 1;
    const auto groove = [&](double low, double high, bool along_x) {
      std::vector<Point3> p;
      for (const double t : {-1.0, end}) {
        for (const auto& [s, z] : {std::pair{at - 1, high}, {at + 1, high}, {at, low}}) {
          p.push_back(along_x ? Point3{t, s, z} : Point3{s, t, z});
        }
      }
      Context context;
      return Nef3::from_mesh(
          make_mesh(p, {{0, 1, 2}, {5, 4, 3}, {0, 3, 4, 1}, {1, 4, 5, 2}, {2, 5, 3, 0}}),
          {.rule = WindingRule::NonZero}, context);
    };
    set -= groove(6, 11, true);
    set -= groove(4, -1, false);
  }
  return set;
}

/// A star-shaped prism with `rays` points.
Nef3 star(int rays) {
  std::vector<Point2> outline;
  for (int i = 0; i < 2 * rays; ++i) {
    const double angle = M_PI * i / rays, radius = i % 2 == 0 ? 8 : 3;
    outline.push_back({std::round(64 * radius * std::cos(angle)) / 64,
                       std::round(64 * radius * std::sin(angle)) / 64});
  }
  return solid(prism_mesh(outline, 0, 1));
}

Nef3 permuted(const Nef3& set, std::array<std::size_t, 3> axes) {
  AffineMap3 map;
  for (std::size_t i = 0; i < 3; ++i) map.matrix[i][axes[i]] = 1;
  return set.transformed(map);
}

TEST(Walls, LeaveAConvexSetAlone) {
  EXPECT_EQ(piece_count(box({0, 0, 0}, {1, 2, 3})), 1U);
  EXPECT_EQ(piece_count(box({0, 0, 0}, {1, 2, 3}).interior()), 1U);
  EXPECT_EQ(piece_count(Nef3::empty()), 0U);
}

TEST(Walls, CutAnLBlockInTwo) {
  const Nef3 block = box({0, 0, 0}, {2, 2, 1}) - box({1, 1, -1}, {3, 3, 2});
  EXPECT_EQ(fault(block), "");
  EXPECT_EQ(piece_count(block), 2U);
  EXPECT_EQ(fault(block.closure()), "");
  EXPECT_EQ(fault(block.interior()), "");
}

TEST(Walls, GoBothWaysFromEveryGroove) {
  for (int n = 1; n <= 4; ++n) {
    const Nef3 set = crossed_grooves(n);
    const auto k = static_cast<std::size_t>(n);
    EXPECT_LE(piece_count(set), (k + 1) * (k + 1)) << n;
    EXPECT_EQ(fault(set), "") << n;
  }
}

TEST(Walls, DoNotDependOnTheOrderOfAxes) {
  const Nef3 grooves = crossed_grooves(3), rays = star(7);
  std::array<std::size_t, 3> axes{0, 1, 2};
  do {
    EXPECT_EQ(piece_count(permuted(grooves, axes)), 8U);
    EXPECT_EQ(piece_count(permuted(rays, axes)), 8U);
  } while (std::next_permutation(axes.begin(), axes.end()));
}

TEST(Walls, MakeAtMostOnePieceMoreForEachRay) {
  for (const int n : {3, 4, 5, 8}) {
    EXPECT_LE(piece_count(star(n)), static_cast<std::size_t>(n) + 1) << n;
    EXPECT_EQ(fault(star(n)), "") << n;
  }
}

TEST(Walls, AreToldFromFacets) {
  const Nef3 block = box({0, 0, 0}, {2, 2, 1}) - box({1, 1, -1}, {3, 3, 2});
  const std::size_t facets = block.complex().facet_count();
  for (const Nef3& set :
       {block, block.with_origins(std::vector<std::uint32_t>(facets, kNoOrigin))}) {
    Context context;
    const SpaceComplex cut = wall_subdivision(set, {}, context);
    EXPECT_FALSE(audit(cut, AuditForm::Any).has_value());
    std::size_t walls = 0;
    for (std::size_t f = 0; f < cut.facet_count(); ++f) {
      const auto& [above, below] = cut.facet_volume[f];
      const bool is_between =
          cut.volume_mark[above.value()] == 1 && cut.volume_mark[below.value()] == 1;
      EXPECT_EQ(is_wall(cut, FacetId(f)), is_between);
      walls += is_between;
    }
    EXPECT_EQ(walls, 1U);
    EXPECT_EQ(Nef3::from_complex(cut, context), block);
  }
}

TEST(Walls, CutVoidsComponentsAndPartsThatTouch) {
  const Nef3 hollow = box({0, 0, 0}, {6, 6, 6}) - box({2, 2, 2}, {4, 4, 4});
  EXPECT_EQ(fault(hollow), "");
  EXPECT_EQ(fault(hollow + box({7, 0, 0}, {8, 1, 1})), "");
  // Two boxes on a common edge, and two on a common corner: nothing is reflex but in the ring
  // around.
  const Nef3 on_edge = box({0, 0, 0}, {1, 1, 1}) + box({1, 1, 0}, {2, 2, 1});
  EXPECT_EQ(piece_count(on_edge), 2U);
  EXPECT_EQ(fault(on_edge), "");
  EXPECT_EQ(fault(box({0, 0, 0}, {1, 1, 1}) + box({1, 1, 1}, {2, 2, 2})), "");
  // A ring: facets with holes, which CGAL once made an empty piece of.
  EXPECT_EQ(fault(box({0, 0, 0}, {6, 6, 2}) - box({2, 2, -1}, {4, 4, 3})), "");
  EXPECT_EQ(fault(box({0, 0, 0}, {6, 6, 2}) + box({2, 2, 2}, {4, 4, 3})), "");
}

TEST(Walls, GoThroughSlits) {
  const Nef3 cube = box({0, 0, 0}, {4, 4, 4});
  const std::vector<RationalPoint3> flat{{1, 1, 2}, {3, 1, 2}, {2, 3, 2}};
  const std::vector<RationalPoint3> upright{{1, 1, 1}, {3, 2, 1}, {2, Rational(3, 2), 3}};
  EXPECT_EQ(fault(cube - Nef3::facet(flat)), "");
  EXPECT_EQ(fault(cube - Nef3::facet(upright)), "");
  EXPECT_EQ(fault(cube - Nef3::segment({1, 1, 1}, {2, 2, 2})), "");
  EXPECT_EQ(fault(cube - Nef3::segment({1, 1, 1}, {1, 1, 2})), "");
  EXPECT_EQ(fault(cube - Nef3::segment({1, 1, 1}, {1, 1, 4})), "");
  EXPECT_EQ(fault(cube - Nef3::point({1, 2, 1})), "");
  EXPECT_EQ(fault(cube - Nef3::point({1, 2, 1}) - Nef3::point({1, 1, 1})), "");
  EXPECT_EQ(fault(cube - Nef3::point({1, Rational(1, 3), 1}) - Nef3::point({1, 1, 4})), "");
}

TEST(Walls, KeepMarks) {
  Context context;
  const Nef3 block = box({0, 0, 0}, {2, 2, 1}) - box({1, 1, -1}, {3, 3, 2});
  const Nef3 half_open =
      block * Nef3::half_space({0, 0, 1, -1}, Boundary::Open) - Nef3::segment({0, 0, 0}, {2, 0, 0});
  EXPECT_EQ(fault(half_open), "");
  const auto closed = decompose_by_walls(half_open, {DecomposeMethod::Walls, true}, context).pieces;
  for (const Nef3& piece : closed) EXPECT_TRUE(piece.is_closed() && piece.is_convex());
  EXPECT_EQ(union_of(closed, context), half_open.closure());
}

TEST(Walls, NeedABoundedSet) {
  Context context;
  const Nef3 wedge = !(Nef3::half_space({1, 0, 0, 0}, Boundary::Closed) *
                       Nef3::half_space({0, 1, 0, 0}, Boundary::Closed));
  EXPECT_EQ(piece_count(wedge), 2U);  // by planes
  EXPECT_THROW(wall_subdivision(Nef3::whole(), {}, context), Error);
}

/// Of a plane's integers or a point's coordinates.
std::size_t longest_number(const SpaceComplex& c) {
  std::size_t bits = 0;
  const auto take = [&bits](const Integer& n) {
    if (n != 0) bits = std::max<std::size_t>(bits, msb(abs(n)) + 1);
  };
  for (const PlaneId plane : c.facet_plane) {
    for (const Integer& n : c.planes().primitive(plane)) take(n);
  }
  return bits;
}

// Tetrahedra with coordinates of 53 bits, united or taken out of a block: walls are planes of short
// numbers.
TEST(Walls, HaveShortNumbers) {
  std::size_t longest = 0;
  for (std::uint64_t seed = 0; seed < 8; ++seed) {
    Dice dice(seed);
    const auto coordinate = [&] {
      return static_cast<double>(dice.between(0, (std::int64_t{1} << 53U) - 1)) * 0x1p-52;
    };
    const bool is_union = seed % 4 != 0;  // reflex edges where two cross
    Nef3 set = is_union ? Nef3::empty() : box({0, 0, 0}, {2, 2, 2});
    for (int i = 0; i < 3; ++i) {
      std::vector<Point3> p;
      for (int k = 0; k < 4; ++k) {
        const double x = coordinate();
        const double y = coordinate();
        const double z = coordinate();
        p.push_back({x, y, z});
      }
      Context context;
      const Nef3 cut = Nef3::from_mesh(make_mesh(p, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}),
                                       {.rule = WindingRule::NonZero}, context);
      set = is_union ? set + cut : set - cut;
    }
    Context context;
    longest = std::max(longest, longest_number(wall_subdivision(set, {{0, 0, 1}}, context)));
  }
  EXPECT_LT(longest, 800U);
  RecordProperty("longest", static_cast<int>(longest));
}

TEST(Walls, CutTheBoundedVolumesOfUnboundedSets) {
  const Nef3 outside = !box({-5, -5, -5}, {15, 15, 15});
  const Nef3 inside = crossed_grooves(2);
  const Nef3 set = outside + inside + Nef3::segment({12, 12, 12}, {13, 12, 12});
  EXPECT_EQ(fault(set), "");
  Context context;
  const std::size_t around =
      decompose(outside, {DecomposeMethod::Cuts, false}, context).pieces.size();
  EXPECT_EQ(piece_count(set), around + piece_count(inside) + 1);
  EXPECT_EQ(fault(outside), "");
}

TEST(Walls, MakeConvexPiecesOfRandomSolids) {
  EXPECT_TRUE(rc::check([](std::uint64_t seed) {
    Dice dice(seed);
    const auto corner = [&] { return static_cast<double>(dice.between(0, 4)); };
    Nef3 set = box({0, 0, 0}, {4, 4, 4});
    for (int i = 0; i < 3; ++i) {
      std::vector<Point3> p;
      for (int k = 0; k < 4; ++k) {
        const double x = corner();
        const double y = corner();
        const double z = corner();
        p.push_back({x, y, z});
      }
      Context context;
      const Nef3 cut = Nef3::from_mesh(make_mesh(p, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}),
                                       {.rule = WindingRule::NonZero}, context);
      set = dice.below(3) == 0 ? set ^ cut : dice.below(2) == 0 ? set - cut : set - cut.interior();
    }
    RC_ASSERT(fault(set, seed % 2 == 0) == "");
  }));
}

// ---------------------------------------------------------------- walls and ids

/// Between the corners.
RationalPoint3 middle_of(const SpaceComplex& c, FacetId f) {
  RationalPoint3 sum{0, 0, 0};
  int count = 0;
  const UseId first = c.cycles_of(f)[0];
  UseId u = first;
  do {
    const RationalPoint3 p = exact(c.points(), c.vertex_point[c.use_origin(u).value()]);
    sum = {sum.x + p.x, sum.y + p.y, sum.z + p.z};
    ++count;
    u = c.use_next[u.value()];
  } while (u != first);
  return {sum.x / count, sum.y / count, sum.z / count};
}

/// Facets of pieces that lie in no facet of the set are walls, others are not; those of facets
/// without an id neither.
void expect_walls(const Nef3& set, const ConvexPieces& pieces) {
  const SpaceComplex& whole = set.complex();
  std::size_t walls = 0;
  for (const Nef3& piece : pieces.pieces) {
    const SpaceComplex& c = piece.complex();
    for (std::uint32_t f = 0; f < c.facet_count(); ++f) {
      if (c.facet_mark[f] == kBeyond) continue;
      const IntegerRow row = c.planes().primitive(c.facet_plane[f]);
      const auto is_of_set = [&](std::size_t g) {
        return whole.facet_mark[g] != kBeyond &&
               whole.planes().primitive(whole.facet_plane[g]) == row;
      };
      bool is_in_plane = false;
      for (std::size_t g = 0; g < whole.facet_count(); ++g) is_in_plane |= is_of_set(g);
      EXPECT_TRUE(is_in_plane || is_wall(c, FacetId(f)));
      walls += is_wall(c, FacetId(f)) ? 1 : 0;
      const bool is_bounded = std::ranges::all_of(c.cycles_of(FacetId(f)), [&](UseId first) {
        UseId u = first;
        do {
          if (c.vertex_mark[c.use_origin(u).value()] == kBeyond) return false;
          u = c.use_next[u.value()];
        } while (u != first);
        return true;
      });
      if (is_bounded && is_wall(c, FacetId(f))) {
        EXPECT_EQ(set.locate(middle_of(c, FacetId(f))).item.kind(), SpaceItem::Kind::Volume);
      }
    }
  }
  EXPECT_GT(walls, 0U);
}

void expect_walls(const Nef3& set, const DecomposeOptions& options) {
  Context context;
  expect_walls(set, decompose(set, options, context));
  const bool has_walls = options.method == DecomposeMethod::Walls;
  if (has_walls) expect_walls(set, decompose_by_walls(set, options, context));
}

TEST(Walls, AreToldFromFacetsWithoutIds) {
  Context context;
  const auto half_space = [](int a, int b, int c, int d) {
    return Nef3::half_space(Plane3{a, b, c, d}, Boundary::Closed);
  };
  const Nef3 block = half_space(1, 0, 0, -8) * half_space(-1, 0, 0, 0) * half_space(0, 1, 0, -8) *
                     half_space(0, -1, 0, 0) * half_space(0, 0, 1, -8) * half_space(0, 0, -1, 0);
  const Nef3 notch = half_space(-1, 0, 0, 4) * half_space(0, 0, -1, 4);
  const Nef3 groove = half_space(-2, 1, 0, 9) * half_space(2, 1, 0, -15);
  for (const DecomposeMethod method :
       {DecomposeMethod::Cuts, DecomposeMethod::Walls, DecomposeMethod::Best}) {
    expect_walls(block - notch, {method, false});
    expect_walls(block - notch - groove, {method, true});
    expect_walls(!block, {method, false});  // unbounded
    expect_walls(solid(box_mesh({0, 0, 0}, {8, 8, 8})) - notch, {method, false});
    const Nef3 shell = block - half_space(1, 1, 1, -9) * half_space(-1, -1, -1, 6);
    expect_walls(shell - Nef3::point({7, 7, 7}), {method, false});
  }
  // Walls of pieces that are cut again are facets like others.
  const ConvexPieces pieces = decompose(block - notch, {DecomposeMethod::Cuts, false}, context);
  const ConvexPieces again = decompose(pieces.pieces[0], {DecomposeMethod::Cuts, false}, context);
  ASSERT_EQ(again.pieces.size(), 1U);
  const SpaceComplex& c = again.pieces[0].complex();
  for (std::uint32_t f = 0; f < c.facet_count(); ++f) EXPECT_FALSE(is_wall(c, FacetId(f)));
}

}  // namespace
}  // namespace plumb::testing::walls_test
