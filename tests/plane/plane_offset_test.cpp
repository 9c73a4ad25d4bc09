// Offsets of sets of the plane: exact distances from the set decide which points an offset must
// have, and which it must not.
#include "plumb/plane/plane_offset.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "generate/plane_families.h"
#include "generate/test_share.h"
#include "plumb/predicates/error.h"
#include "plumb/predicates/rounding.h"
#include "plumb/testing/dice.h"

namespace plumb::testing::plane_offset_test {
namespace {

using Points = std::vector<Point2>;

Nef2 polygon(const Points& points) { return Nef2::polygon(points); }
Nef2 box(double x, double y, double to_x, double to_y, Boundary boundary = Boundary::Closed) {
  const Points corners{{x, y}, {to_x, y}, {to_x, to_y}, {x, to_y}};
  return Nef2::polygon(corners, boundary);
}
Nef2 segment(Point2 a, Point2 b) { return Nef2::polyline(Points{a, b}); }
Nef2 grown(const Nef2& set, double distance, OffsetJoin join) {
  return offset(set, distance, {.join = join});
}

RationalPoint2 at(const PlaneComplex& c, VertexId v) { return exact(c.points, c.vertex_point[v]); }
Rational dot(const RationalPoint2& a, const RationalPoint2& b) { return a.x * b.x + a.y * b.y; }

/// Returns the square of the distance from p to the nearest cell on the border of a closed set.
Rational squared_distance_to_border(const Nef2& set, const RationalPoint2& p) {
  const PlaneComplex& c = set.complex();
  std::vector<Rational> squares;
  for (std::size_t v = 0; v < c.vertex_count(); ++v) {
    const RationalPoint2 d = p - at(c, VertexId(v));
    squares.push_back(dot(d, d));
  }
  for (std::size_t e = 0; e < c.edge_count(); ++e) {
    const HalfedgeId h = first_half(EdgeId(e));
    const RationalPoint2 a = at(c, c.dcel.origin(h));
    const RationalPoint2 along = at(c, c.dcel.target(h)) - a;
    const RationalPoint2 d = p - a;
    const Rational t = dot(d, along) / dot(along, along);
    if (t < 0 || t > 1) continue;
    const Rational across = d.x * along.y - d.y * along.x;
    squares.push_back(across * across / dot(along, along));
  }
  return *std::min_element(squares.begin(), squares.end());
}

/// What the distance says about a round offset: points must be in it, or out of it, unless they are
/// nearly at the distance.
void expect_round_offset(const Nef2& set, double distance) {
  const double chord_error = std::fabs(distance) / 50;
  const Nef2 result = offset(set, distance, {.chord_error = chord_error});
  EXPECT_FALSE(result.audit());
  EXPECT_TRUE(result.is_closed());
  const Rational most = Rational(std::fabs(distance)) * Rational(1 + 0x1p-40);
  const Rational least =
      Rational(std::fabs(distance)) * Rational(1 - 0x1p-40) - Rational(chord_error);
  for (int x = -12; x <= 36; ++x) {
    for (int y = -12; y <= 36; ++y) {
      const RationalPoint2 p{Rational(x) / 4, Rational(y) / 4};
      const bool was_inside = set.contains(p);
      const Rational square = squared_distance_to_border(set, p);
      SCOPED_TRACE(std::to_string(x) + "/4 " + std::to_string(y) + "/4");
      if (distance > 0) {
        if (was_inside || square <= least * least) {
          ASSERT_TRUE(result.contains(p));
        } else if (square > most * most) {
          ASSERT_FALSE(result.contains(p));
        }
      } else {
        if (!was_inside || square < least * least) {
          ASSERT_FALSE(result.contains(p));
        } else if (square > most * most) {
          ASSERT_TRUE(result.contains(p));
        }
      }
    }
  }
}

std::vector<Nef2> closed_sets() {
  const Nef2 ring = box(0, 0, 4, 4) - box(1, 1, 3, 3, Boundary::Open);
  return {
      box(0, 0, 2, 3),
      polygon({{0, 0}, {3, 0}, {3, 1}, {1, 1}, {1, 3}, {0, 3}}),
      ring,
      ring + segment({4, 4}, {6, 5}) + Nef2::point({2, 2}) + segment({6, 5}, {5, 6}),
      box(0, 0, 1, 1) + box(1, 1, 2, 2),
      polygon({{0, 0}, {5, 1}, {1, 1}, {0.5, 4}}),
  };
}

TEST(PlaneOffset, KeepsItsDistance) {
  for (const Nef2& set : closed_sets()) {
    for (const double distance : {0.125, 0.75, 1.5, -0.125, -0.4, -2.0}) {
      SCOPED_TRACE(distance);
      expect_round_offset(set, distance);
    }
  }
}

TEST(PlaneOffset, OfRandomPolygonsKeepsItsDistance) {
  for (std::uint64_t seed = 0; seed < share_of(30); ++seed) {
    SCOPED_TRACE(seed);
    Dice dice(seed);
    Nef2 set = polygon(lattice_polygon(dice, 3 + dice.below(9), 7));
    if (seed % 3 == 0) set += segment({1, 1}, {8, 7}) + Nef2::point({7, 1});
    expect_round_offset(set, 0.375);
    expect_round_offset(set, -0.25);
  }
}

TEST(PlaneOffset, OfBoxesIsExact) {
  const Nef2 square = box(0, 0, 2, 2);
  EXPECT_EQ(grown(square, 1, OffsetJoin::Mitre), box(-1, -1, 3, 3));
  EXPECT_EQ(grown(square, 1, OffsetJoin::Bevel).area(), Rational(4 + 8 + 2));
  EXPECT_EQ(grown(square, -0.5, OffsetJoin::Round), box(0.5, 0.5, 1.5, 1.5));
  EXPECT_TRUE(grown(square, -1, OffsetJoin::Round).is_empty());
  EXPECT_TRUE(grown(square, -7, OffsetJoin::Mitre).is_empty());
  EXPECT_EQ(grown(segment({0, 0}, {3, 0}), 1, OffsetJoin::Bevel), box(0, -1, 3, 1));
  EXPECT_EQ(grown(Nef2::point({1, 2}), 1, OffsetJoin::Mitre), box(0, 1, 2, 3));
  EXPECT_EQ(grown(Nef2::point({0, 0}), 1, OffsetJoin::Bevel).area(), Rational(2));
  // A hole shrinks and closes.
  const Nef2 ring = box(0, 0, 6, 6) - box(2, 2, 4, 4, Boundary::Open);
  EXPECT_EQ(grown(ring, 0.5, OffsetJoin::Mitre),
            box(-0.5, -0.5, 6.5, 6.5) - box(2.5, 2.5, 3.5, 3.5, Boundary::Open));
  EXPECT_EQ(grown(ring, 1, OffsetJoin::Mitre), box(-1, -1, 7, 7));
  EXPECT_EQ(grown(ring, -1, OffsetJoin::Mitre).area(), Rational(0));
}

TEST(PlaneOffset, CutsMitresAtTheirLimit) {
  const Nef2 thin = polygon({{0, 0}, {8, -0.5}, {8, 0.5}});
  const auto reach = [&](double limit) {
    const Nef2 far = offset(thin, 1, {.join = OffsetJoin::Mitre, .mitre_limit = limit});
    double least = 0;
    for (const std::uint32_t p : far.complex().vertex_point) {
      least = std::min(least, approx(far.complex().points, p).x);
    }
    return -least;
  };
  EXPECT_NEAR(reach(2), 1, 1e-9);  // Square: across the bisector, at the distance.
  EXPECT_GT(reach(100), 15);
}

TEST(PlaneOffset, HasAsManyChordsAsAsked) {
  const Nef2 disk = offset(Nef2::point({0, 0}), 1, {.circle_segments = 12});
  EXPECT_EQ(disk.counts().vertices, 12U);
  EXPECT_NEAR(nearest_double(*disk.area()), 3, 1e-9);  // The regular polygon of 12 corners.
  const Nef2 fine = offset(Nef2::point({0, 0}), 1, {.chord_error = 1e-6});
  EXPECT_NEAR(nearest_double(*fine.area()), 3.14159265358979, 5e-6);
}

bool has_vertex_near(const Nef2& set, Point2 p) {
  const PlaneComplex& c = set.complex();
  for (std::size_t v = 0; v < c.vertex_count(); ++v) {
    const RationalPoint2 q = at(c, VertexId(v));
    if (std::hypot(nearest_double(q.x) - p.x, nearest_double(q.y) - p.y) < 1e-12) return true;
  }
  return false;
}

// An arc of a quarter turn and steps of 2 pi / 5, 2 pi / 8 and 2 pi / 10: 1.25, 2 and 2.5 steps.
// The chords begin at the edge that comes first when the set is on the left.
TEST(PlaneOffset, HasChordsOfAnAngle) {
  const Nef2 square = box(0, 0, 10, 10);
  const auto stepped = [](const Nef2& set, double by, int steps) {
    return offset(set, by, {.arc_step = 2 * std::numbers::pi / steps});
  };
  EXPECT_EQ(stepped(square, 1, 5).area(), Rational(142));
  EXPECT_EQ(stepped(square, 1, 8), offset(square, 1, {.circle_segments = 8}));
  const double angle = std::numbers::pi / 5, s = std::sin(angle), c = std::cos(angle);
  const Nef2 round = stepped(square, 1, 10);
  EXPECT_EQ(round.complex().vertex_count(), 16U);
  EXPECT_TRUE(has_vertex_near(round, {10 + c, 10 + s}));
  EXPECT_FALSE(has_vertex_near(round, {10 + s, 10 + c}));
  const Nef2 corner = square - box(3, 3, 11, 11);
  const Nef2 shrunk = stepped(corner, -1, 10);
  EXPECT_TRUE(has_vertex_near(shrunk, {3 - s, 3 - c}));
  EXPECT_FALSE(has_vertex_near(shrunk, {3 - c, 3 - s}));
  EXPECT_THROW(static_cast<void>(offset(square, 1, {.arc_step = 4})), Error);
  EXPECT_THROW(static_cast<void>(offset(square, 1, {.arc_step = -1})), Error);
}

TEST(PlaneOffset, OfZeroIsTheRegularization) {
  const Nef2 set = box(0, 0, 2, 2, Boundary::Open) + segment({2, 2}, {5, 5});
  EXPECT_EQ(grown(set, 0, OffsetJoin::Round), box(0, 0, 2, 2));
  EXPECT_TRUE(grown(Nef2::empty(), 1, OffsetJoin::Round).is_empty());
}

TEST(PlaneOffset, OfExtremeCoordinates) {
  const double tiny = 0x1p-1070;
  const Nef2 small = grown(box(0, 0, tiny, 2 * tiny), tiny, OffsetJoin::Mitre);
  EXPECT_EQ(small, box(-tiny, -tiny, 2 * tiny, 3 * tiny));
  const double huge = 0x1p1000;
  const Nef2 large = grown(polygon({{0, 0}, {huge, huge}, {0, 2 * huge}}), huge, OffsetJoin::Round);
  EXPECT_FALSE(large.audit());
}

TEST(PlaneOffset, RefusesWhatItCannotDo) {
  const Nef2 square = box(0, 0, 1, 1);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(static_cast<void>(offset(square, nan)), Error);
  EXPECT_THROW(static_cast<void>(offset(!square, 1)), Error);
  EXPECT_THROW(static_cast<void>(offset(square, 1, {.mitre_limit = 0.5})), Error);
  EXPECT_THROW(static_cast<void>(offset(square, 1, {.chord_error = -1})), Error);
  EXPECT_THROW(static_cast<void>(offset(square, 1, {.circle_segments = 2})), Error);
}

}  // namespace
}  // namespace plumb::testing::plane_offset_test
