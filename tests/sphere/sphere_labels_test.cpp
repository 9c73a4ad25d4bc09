// Checks the pieces of two maps laid over each other, and the pair of cells that each cell of the
// overlay lies in: by the audit, by locating directions and by the faces beside pieces.
#include "plumb/sphere/overlay/sphere_labels.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "plumb/sphere/set/sphere_vectors.h"
#include "plumb/sphere/sphere_audit.h"
#include "plumb/testing/dice.h"

namespace plumb::sphere_labels_test {

using testing::Dice;

/// Two maps over one table of planes, laid over each other.
struct Overlaid {
  PlaneTable planes;
  std::array<SphereMap, 2> map;
  SphereContacts contacts;
  SpherePieces pieces;
  SphereOrigins cells;
  std::size_t cycles;  ///< before they become faces

  Overlaid(const NefSphere& first, const NefSphere& second)
      : planes(first.planes()), map{first.map(), second.map()} {
    const std::vector<PlaneId> to = planes.merge(second.planes());
    for (PlaneId& c : map[1].circle) c = to[c.value()];
    for (SphereDirection& u : map[1].direction) u = {to[u.p.value()], to[u.q.value()]};
    contacts.find(planes, map[0], map[1]);
    pieces.build(planes, map[0], map[1], contacts);
    cycles = pieces.cycle_count;
    SphereLabels().build(planes, map[0], map[1], contacts, pieces, cells);
    pieces.map.point_mark.assign(pieces.map.point_count(), 0);
    pieces.map.arc_mark.assign(pieces.map.arc_count(), 0);
    pieces.map.face_mark.assign(cells.face.size(), 0);
  }
  /// The face of map k that the face of the overlay at a half-arc of it lies in.
  SphereCell face_of(std::uint32_t half, std::size_t k) const {
    return cells.face[pieces.map.face[half]][k];
  }
};

SphereVector any_vector(Dice& dice) {
  while (true) {
    const SphereVector v(static_cast<double>(dice.between(-2, 2)),
                         static_cast<double>(dice.between(-2, 2)),
                         static_cast<double>(dice.between(-1, 1)));
    if (!v.is_zero()) return v;
  }
}

/// A set of few arcs, points and half-spheres, with islands.
NefSphere any_set(Dice& dice) {
  NefSphere set;
  for (std::uint32_t leaves = dice.below(6); leaves > 0; --leaves) {
    const SphereVector u = any_vector(dice);
    const SphereVector v = any_vector(dice);
    const std::uint32_t kind = dice.below(4);
    if (kind == 0) set ^= NefSphere::half_sphere(u, Boundary::Closed);
    if (kind == 1) set ^= NefSphere::point(u);
    if (kind > 1 && !cross(u, v).is_zero()) set ^= NefSphere::arc(u, v, Boundary::Open);
  }
  return set;
}

void expect_labels(Overlaid& of) {
  const SphereMap& map = of.pieces.map;
  ASSERT_EQ(audit(of.planes, map, AuditForm::Any).value_or(DcelFlaw{}).invariant, "");
  ASSERT_EQ(of.cells.point.size(), map.point_count());
  ASSERT_EQ(of.cells.arc.size(), map.arc_count());
  for (std::size_t k = 0; k < 2; ++k) {
    const SphereMap& own = of.map[k];
    for (std::uint32_t v = 0; v < map.point_count(); ++v) {
      EXPECT_EQ(of.cells.point[v][k], locate(of.planes, own, map.direction[v]));
      if (map.first_out[v] == kNone && of.cells.point[v][k].kind() != SphereCell::Kind::Arc) {
        const SphereCell at = of.cells.point[v][k];
        const std::uint32_t face =
            at.kind() == SphereCell::Kind::Face ? at.index() : own.point_face[at.index()];
        EXPECT_EQ(of.cells.face[map.point_face[v]][k], SphereCell::face(face));
      }
    }
    for (std::uint32_t i = 0; i < map.arc_count(); ++i) {
      const SphereCell at = of.cells.arc[i][k];
      const std::uint32_t a = of.pieces.arc[i][k];
      if (a != kNone) {
        EXPECT_EQ(at, SphereCell::arc(a));
        EXPECT_EQ(map.circle[i], own.circle[a]);
        EXPECT_EQ(of.face_of(2 * i, k), SphereCell::face(own.face[2 * a]));
        EXPECT_EQ(of.face_of(2 * i + 1, k), SphereCell::face(own.face[2 * a + 1]));
      } else {
        EXPECT_EQ(at.kind(), SphereCell::Kind::Face);
        EXPECT_EQ(of.face_of(2 * i, k), at);
        EXPECT_EQ(of.face_of(2 * i + 1, k), at);
      }
    }
  }
  for (std::uint32_t i = 0; i < map.arc_count(); ++i) {
    EXPECT_TRUE(of.pieces.arc[i][0] != kNone || of.pieces.arc[i][1] != kNone);
  }
}

/// The middle of a piece that is shorter than a half-circle lies where its label says.
void expect_middles(Overlaid& of) {
  const SphereMap map = of.pieces.map;
  for (std::uint32_t i = 0; i < map.arc_count(); ++i) {
    if (map.is_loop(i)) continue;
    const SphereVector u = exact_direction(of.planes, map.direction[map.origin[2 * i]]);
    const SphereVector v = exact_direction(of.planes, map.direction[map.origin[2 * i + 1]]);
    if (dot(cross(u, v), exact_normal(of.planes, map.circle[i])) <= 0) continue;
    const SphereVector sum{Rational(u.x + v.x), Rational(u.y + v.y), Rational(u.z + v.z)};
    const SphereDirection middle = intern_direction(of.planes, sum);
    for (std::size_t k = 0; k < 2; ++k) {
      EXPECT_EQ(locate(of.planes, of.map[k], middle), of.cells.arc[i][k]);
    }
  }
}

TEST(SphereLabels, CellsLieWhereTheyAreLocated) {
  Dice dice(1);
  for (int round = 0; round < 150 && !::testing::Test::HasFailure(); ++round) {
    SCOPED_TRACE(round);
    const NefSphere a = any_set(dice);
    Overlaid of(a, round % 10 == 0 ? a : any_set(dice));
    expect_labels(of);
    expect_middles(of);
  }
}

/// Parts that touch nothing of the other map learn from parts beside them, in any order.
TEST(SphereLabels, PartsThatTouchNothingAreLabelledAcrossEachOther) {
  const auto triangle = [](double reach) {
    return std::vector<SphereVector>{{reach, 0, 1}, {-reach, reach, 1}, {-reach, -reach, 1}};
  };
  NefSphere odd;
  NefSphere even;
  for (int i = 0; i < 6; ++i) {
    (i % 2 == 0 ? even : odd) ^= NefSphere::polygon(triangle(1 << i), Boundary::Closed);
    (i % 2 == 0 ? even : odd) ^= NefSphere::polygon(triangle(0.75 * (1 << i)), Boundary::Open);
  }
  const SphereVector north(0, 0, 1);
  even ^= NefSphere::point(north);
  odd ^= NefSphere::point(north.opposite());
  for (const bool is_swapped : {false, true}) {
    Overlaid of(is_swapped ? odd : even, is_swapped ? even : odd);
    expect_labels(of);
    EXPECT_EQ(of.cells.face.size(), 13U);  // six rings, their two sides each a triangle
    EXPECT_EQ(of.cycles, 24U);
  }
}

TEST(SphereLabels, MapsWithoutArcsHaveOneFace) {
  const SphereVector x(1, 0, 0), y(0, 1, 0);
  const std::array<NefSphere, 3> sets{NefSphere(), NefSphere::point(x),
                                      NefSphere::points(std::vector{x, y})};
  for (const NefSphere& a : sets) {
    for (const NefSphere& b : sets) {
      Overlaid of(a, b);
      expect_labels(of);
      EXPECT_EQ(of.cells.face.size(), 1U);
      EXPECT_EQ(of.pieces.map.point_count(),
                std::max(a.map().point_count(), b.map().point_count()));
    }
  }
}

/// Overlapping arcs of one circle become one piece; a loop is cut where it is touched.
TEST(SphereLabels, OverlapsAreOnePieceAndLoopsAreCutAtStops) {
  const SphereVector x(1, 0, 0), y(0, 1, 0), z(0, 0, 1), between(1, 1, 0), minus(-1, 1, 0);
  const auto pieces = [](const NefSphere& a, const NefSphere& b) {
    Overlaid of(a, b);
    expect_labels(of);
    std::array<std::size_t, 3> count{};  // of the first map alone, of the second alone, of both
    for (const auto& [first, second] : of.pieces.arc) {
      ++count[first == kNone ? 1 : second == kNone ? 0 : 2];
    }
    return count;
  };
  using Count = std::array<std::size_t, 3>;
  const NefSphere round = NefSphere::circle(z);
  EXPECT_EQ(pieces(round, round), (Count{0, 0, 1}));
  EXPECT_EQ(pieces(round, NefSphere::point(x)), (Count{1, 0, 0}));
  EXPECT_EQ(pieces(round, NefSphere::arc(x, y)), (Count{1, 0, 1}));
  EXPECT_EQ(pieces(NefSphere::circle(x), round), (Count{2, 2, 0}));
  EXPECT_EQ(pieces(NefSphere::arc(x, y), NefSphere::arc(between, minus)), (Count{1, 1, 1}));
  EXPECT_EQ(pieces(NefSphere::arc(x, y), NefSphere::arc(y, x, z)), (Count{1, 1, 0}));
}

}  // namespace plumb::sphere_labels_test
