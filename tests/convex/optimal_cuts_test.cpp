// Regions cut by diagonals: triangulations by Euler's formula, sight between corners against all
// pairs of segments, and the fewest pieces against all sets of diagonals.
#include "plumb/convex/region/optimal_cuts.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "oracle/partition_check.h"
#include "plumb/plane/nef2.h"
#include "plumb/predicates/segment2.h"
#include "plumb/testing/dice.h"

namespace plumb::optimal_cuts_test {

using Points = std::vector<Point2>;

/// A chain below and one above it on a small lattice: simple, with many corners on common lines.
Points random_polygon(testing::Dice& dice) {
  const int columns = static_cast<int>(dice.between(3, 4));
  Points points;
  for (int x = 0; x <= columns; ++x) {
    points.push_back({static_cast<double>(x), static_cast<double>(dice.between(0, 2))});
  }
  for (int x = columns; x >= 0; --x) {
    points.push_back({static_cast<double>(x), static_cast<double>(dice.between(3, 5))});
  }
  return points;
}

PlaneRegion region_of(const Nef2& set) {
  RegionMaker maker(set.complex());
  for (std::uint32_t f = 0; f < set.complex().face_count(); ++f) {
    if (set.complex().mark(FaceId(f))) return maker.region(FaceId(f));
  }
  return {};
}

std::size_t reflex_halves(const PlaneRegion& r) {
  std::size_t count = 0;
  for (std::uint32_t i = 0; i < r.halfedge_count(); ++i) {
    const HalfedgeId h(i);
    count += r.is_inside(h) && r.is_reflex(h) ? 1 : 0;
  }
  return count;
}
std::size_t inner_halves(const PlaneRegion& r) {
  std::size_t count = 0;
  for (std::uint32_t i = 0; i < r.halfedge_count(); ++i) count += r.is_inside(HalfedgeId(i));
  return count;
}

Nef2 square(double low, double high) {
  return Nef2::polygon(Points{{low, low}, {high, low}, {high, high}, {low, high}});
}
/// With holes, slits and points inside.
std::vector<Nef2> sets_with_holes() {
  const Nef2 nine = square(0, 9);
  return {nine - square(1, 2),
          nine - square(1, 2) - square(4, 8),
          nine - Nef2::polyline(Points{{1, 2}, {5, 3}}),
          nine - Nef2::point({4, 4}),
          nine - Nef2::polyline(Points{{0, 0}, {2, 1}}),
          nine - Nef2::polygon(Points{{0, 0}, {2, 1}, {1, 2}}, Boundary::Open)};
}

/// Corners, boundary loops: n - 2 triangles and two more for each hole.
TEST(OptimalCuts, TrianglesAreAsManyAsEulerSays) {
  testing::Dice dice(1);
  std::vector<Nef2> sets = sets_with_holes();
  for (int i = 0; i < 10; ++i) sets.push_back(Nef2::polygon(random_polygon(dice)));
  for (const Nef2& set : sets) {
    PlaneRegion r = region_of(set);
    const std::size_t vertices = r.vertex_count(), sides = inner_halves(r);
    const std::size_t loops = r.loops.size();
    triangulate(r, unlimited_context());
    EXPECT_EQ(r.vertex_count(), vertices);
    EXPECT_EQ(r.count_loops(), sides + 2 * (loops - 1) - 2);
    EXPECT_EQ(inner_halves(r), 3 * r.count_loops());
    for (std::uint32_t i = 0; i < r.halfedge_count(); ++i) {
      const HalfedgeId h(i);
      if (!r.is_inside(h)) continue;
      EXPECT_EQ(r.after(r.after(r.after(h))), h);
      EXPECT_EQ(r.side(r.heading(h), r.point(r.target(r.after(h)))), Sign::Positive);
    }
  }
}

TEST(OptimalCuts, DiagonalsLeaveNoReflexCornerAndNoneIsSuperfluous) {
  testing::Dice dice(2);
  std::vector<Nef2> sets = sets_with_holes();
  for (int i = 0; i < 30; ++i) sets.push_back(Nef2::polygon(random_polygon(dice)));
  for (const Nef2& set : sets) {
    PlaneRegion r = region_of(set);
    const std::size_t reflex = r.count_reflex_corners();
    const auto rings = static_cast<std::size_t>(
        std::ranges::count_if(r.loops, [](const Corner& c) { return c.is_halfedge(); }));
    cut_by_diagonals(r, unlimited_context());
    EXPECT_EQ(reflex_halves(r), 0U);
    EXPECT_LE(r.count_loops() + rings, 2 * reflex + 2);
    for (std::uint32_t e = 0; e < r.is_cut.size(); ++e) {
      const HalfedgeId h = first_half(EdgeId(e));
      if (r.is_cut[e] == 0 || !r.is_inside(h)) continue;
      PlaneRegion without = r;
      without.remove_edge(h);
      EXPECT_GT(reflex_halves(without), 0U);
    }
  }
}

/// Neighbours, or a segment inside that meets the boundary in its ends alone.
TEST(OptimalCuts, CornersSeeEachOtherAlongSegmentsInside) {
  testing::Dice dice(3);
  std::size_t seen = 0, hidden = 0;
  for (int round = 0; round < 30; ++round) {
    const Nef2 set = Nef2::polygon(random_polygon(dice)), inside = set.interior();
    const PlaneRegion r = region_of(set);
    const std::vector<HalfedgeId> corners = corners_of(r);
    const std::size_t n = corners.size();
    std::vector<RationalPoint2> at;
    for (const HalfedgeId h : corners) at.push_back(exact(r.points, r.point(r.start(h))));
    const auto sees = [&](std::size_t i, std::size_t j) {
      if (j + 1 == i || (j == 0 && i + 1 == n)) return true;
      const RationalSegment2 sight{at[i], at[j]};
      for (std::size_t k = 0; k < n; ++k) {
        const SegmentRelation met = relation(sight, RationalSegment2{at[k], at[(k + 1) % n]});
        if (met != SegmentRelation::Disjoint && met != SegmentRelation::ShareEndpoint) return false;
      }
      return inside.contains(RationalPoint2{(at[i].x + at[j].x) / 2, (at[i].y + at[j].y) / 2});
    };
    const auto found = lesser_corners_seen(r, unlimited_context());
    ASSERT_EQ(found.size(), n);
    for (std::size_t i = 0; i < n; ++i) {
      std::vector<std::uint32_t> expected;
      for (std::uint32_t j = 0; j < i; ++j) {
        if (sees(i, j)) expected.push_back(j);
      }
      EXPECT_EQ(found[i], expected) << i;
      seen += expected.size();
      hidden += i - expected.size();
    }
  }
  EXPECT_GT(seen, 100U);
  EXPECT_GT(hidden, 100U);
}

TEST(OptimalCuts, PiecesAreTheFewestOfAllSetsOfDiagonals) {
  testing::Dice dice(4);
  std::size_t pieces = 0;
  for (int round = 0; round < 16; ++round) {
    const Nef2 set = Nef2::polygon(random_polygon(dice));
    PlaneRegion r = region_of(set);
    const std::size_t vertices = r.vertex_count();
    cut_optimally(r, unlimited_context());
    EXPECT_EQ(reflex_halves(r), 0U);
    EXPECT_EQ(r.vertex_count(), vertices);
    EXPECT_EQ(r.count_loops(), testing::fewest_pieces_by_diagonals(set.parts().polygons.front()));
    pieces += r.count_loops();
  }
  EXPECT_GT(pieces, 32U);
}

}  // namespace plumb::optimal_cuts_test
