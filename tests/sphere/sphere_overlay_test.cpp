// Overlays of sphere maps against the cells of all their circles.
#include "plumb/sphere/overlay/sphere_overlay.h"

#include <gtest/gtest.h>

#include <map>

#include "generate/test_share.h"
#include "oracle/sphere_check.h"
#include "plumb/testing/dice.h"

namespace plumb::testing::sphere_overlay_test {
namespace {

MarkFunction function_of(unsigned bits) {
  return {(bits & 1U) != 0, (bits & 2U) != 0, (bits & 4U) != 0, (bits & 8U) != 0};
}

// A map of the engine beside the twin's marks.
struct Twins {
  SphereMap map;
  CellMarks marks;
};

class Family {
 public:
  Family(Dice& dice, std::size_t circles, std::int64_t reach)
      : Family(dice, any_normals(dice, circles, reach)) {}
  Family(Dice& dice, std::vector<CellVector> normals)
      : dice_(dice), normals_(std::move(normals)), cells_(normals_) {}

  Twins half_sphere() {
    const CellVector& n = normals_[dice_.below(normals_.size())];
    const bool closed = dice_.below(2) == 0;
    const bool other_side = dice_.below(2) == 0;
    return set_of_circle(n, closed, !other_side, other_side);
  }

  // A half-sphere, a circle or what is left without one.
  Twins any_of_circle(const CellVector& n) {
    const bool on = dice_.below(2) == 0, above = dice_.below(2) == 0;
    const bool below = on == above ? !on : dice_.below(2) == 0;
    return set_of_circle(n, on, above, below);
  }

  // `above`: on the side of n.
  Twins set_of_circle(const CellVector& n, bool on, bool above, bool below) {
    Twins result;
    const OrientedPlane plane =
        planes_.intern(to_rational(BigRational(n[0])), to_rational(BigRational(n[1])),
                       to_rational(BigRational(n[2])), Rational(0));
    SphereMap& map = result.map;
    map.circle = {plane.plane()};
    const auto mark = [](bool is_in) { return static_cast<Mark>(is_in ? 1 : 0); };
    map.arc_mark = {mark(on)};
    map.origin = {kNone, kNone};
    map.next = {0, 1};
    map.face = {0, 1};
    map.face_mark = {mark(plane.is_opposite() ? below : above),
                     mark(plane.is_opposite() ? above : below)};
    for (std::size_t c = 0; c < cells_.size(); ++c) {
      const int side = dot(n, cells_[c].sample).sign();
      result.marks.push_back(side == 0 ? on : side > 0 ? above : below);
    }
    return result;
  }

  Twins boolean_op(const Twins& a, const Twins& b, MarkFunction f) {
    Twins result;
    SphereOrigins origins;
    overlay_.boolean_op(a.map, b.map, MarkTable(f), result.map, origins);
    for (std::size_t c = 0; c < cells_.size(); ++c) {
      result.marks.push_back(f(a.marks[c], b.marks[c]));
    }
    EXPECT_EQ(difference(planes_, result.map, cells_, result.marks), "");
    expect_origins(a.map, b.map, f, result.map, origins);
    return result;
  }

  // A random expression of `leaves` half-spheres.
  Twins any_set(std::size_t leaves) {
    if (leaves == 1) return half_sphere();
    const std::size_t left = 1 + dice_.below(leaves - 1);
    const Twins a = any_set(left);
    const Twins b = any_set(leaves - left);
    return boolean_op(a, b, function_of(dice_.below(16)));
  }

 private:
  static std::vector<CellVector> any_normals(Dice& dice, std::size_t count, std::int64_t reach) {
    std::vector<CellVector> normals;
    while (normals.size() < count) {
      const CellVector n{dice.between(-reach, reach), dice.between(-reach, reach),
                         dice.between(-reach, reach)};
      if (n != CellVector{0, 0, 0}) normals.push_back(n);
    }
    return normals;
  }

  static Mark mark_of(const SphereMap& map, SphereCell cell) {
    switch (cell.kind()) {
      case SphereCell::Kind::Point:
        return map.point_mark[cell.index()];
      case SphereCell::Kind::Arc:
        return map.arc_mark[cell.index()];
      case SphereCell::Kind::Face:
        break;
    }
    return map.face_mark[cell.index()];
  }

  void expect_origins(const SphereMap& a, const SphereMap& b, MarkFunction f, const SphereMap& map,
                      const SphereOrigins& origins) {
    const auto expect = [&](const std::vector<SphereOrigins::Pair>& pairs,
                            const std::vector<Mark>& marks) {
      ASSERT_EQ(pairs.size(), marks.size());
      for (std::size_t i = 0; i < pairs.size(); ++i) {
        const Mark in_a = mark_of(a, pairs[i][0]);
        const Mark in_b = mark_of(b, pairs[i][1]);
        EXPECT_EQ(marks[i] != 0, f(in_a != 0, in_b != 0));
      }
    };
    expect(origins.point, map.point_mark);
    expect(origins.arc, map.arc_mark);
    expect(origins.face, map.face_mark);
    for (std::size_t v = 0; v < map.point_count(); ++v) {
      EXPECT_EQ(locate(planes_, a, map.direction[v]), origins.point[v][0]);
      EXPECT_EQ(locate(planes_, b, map.direction[v]), origins.point[v][1]);
    }
  }

  Dice& dice_;
  std::vector<CellVector> normals_;
  SphereCells cells_;
  PlaneTable planes_;
  SphereOverlay overlay_{planes_};
};

TEST(SphereCells, OfCoordinateCirclesAreThoseOfAnOctahedron) {
  const SphereCells cells({});
  EXPECT_EQ(cells.size(), 6U + 12U + 8U);
}

TEST(SphereOverlay, OfFewCirclesIsTheTwins) {
  for (std::uint64_t seed = 0; seed < share_of(400) && !HasFailure(); ++seed) {
    SCOPED_TRACE(seed);
    Dice dice(seed);
    Family family(dice, 1 + dice.below(4), 1);
    family.any_set(1 + dice.below(10));
  }
}

TEST(SphereOverlay, OfMoreCirclesIsTheTwins) {
  for (std::uint64_t seed = 0; seed < share_of(100) && !HasFailure(); ++seed) {
    SCOPED_TRACE(seed);
    Dice dice(seed);
    Family family(dice, 4 + dice.below(4), 2);
    family.any_set(4 + dice.below(10));
  }
}

/// Circles through two opposite points make lunes, of which some are joined; then a circle that
/// crosses them, or one more of theirs, on either side.
TEST(SphereOverlay, OfLunesAndACircleIsTheTwins) {
  std::map<std::size_t, int> seen;  // per number of half-circles
  for (std::uint64_t seed = 0; seed < 200 && !HasFailure(); ++seed) {
    SCOPED_TRACE(seed);
    Dice dice(seed);
    const auto any = [&] {
      CellVector v;
      do {
        v = {dice.between(-2, 2), dice.between(-2, 2), dice.between(-2, 2)};
      } while (v == CellVector{0, 0, 0});
      return v;
    };
    const CellVector axis = any();
    std::vector<CellVector> normals;
    for (const std::size_t count = 2 + dice.below(4); normals.size() < count;) {
      const CellVector n = cross(axis, any());
      if (n != CellVector{0, 0, 0}) normals.push_back(n);
    }
    const CellVector across = any();
    normals.push_back(across);
    Family family(dice, normals);
    Twins lunes = family.any_of_circle(normals[0]);
    for (std::size_t leaves = 1 + dice.below(6); leaves > 0; --leaves) {
      const Twins other = family.any_of_circle(normals[dice.below(normals.size() - 1)]);
      lunes = family.boolean_op(lunes, other, function_of(dice.below(16)));
    }
    const Twins half = family.any_of_circle(across);
    ++seen[lunes.map.point_count() == 2 ? lunes.map.arc_count() : 0];
    for (int i = 0; i < 2; ++i) {
      const MarkFunction f = function_of(dice.below(16));
      family.boolean_op(lunes, half, f);
      family.boolean_op(half, lunes, f);
    }
  }
  for (const std::size_t arcs : {1U, 2U, 3U, 4U}) EXPECT_GT(seen[arcs], 4) << arcs;
}

}  // namespace
}  // namespace plumb::testing::sphere_overlay_test
