// Booleans of complexes, with planes and of parts that lie apart, at sample points against the
// function of the operands' marks; and what becomes of their tables.
#include "plumb/space/boolean/boolean_op.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include "generate/space_scenes.h"
#include "plumb/predicates/point3_signs.h"
#include "plumb/predicates/rounding.h"
#include "plumb/space/complex/space_boxes.h"
#include "plumb/space/nef3.h"
#include "plumb/space/space_audit.h"
#include "plumb/space/space_locator.h"

namespace plumb::boolean_op_test {
namespace {

using testing::Dice;
using testing::SpaceScene;

/// The bounded volumes are full; the other marks are 1, or random, in minimal form.
SpaceComplex full(const SpaceScene& scene, Dice* dice = nullptr) {
  SpaceComplex c = testing::complex_of(scene);
  for (auto* marks : std::initializer_list<std::vector<Mark>*>{&c.vertex_mark, &c.edge_mark,
                                                               &c.facet_mark, &c.volume_mark}) {
    for (Mark& m : *marks) m = dice == nullptr || dice->below(3) != 0 ? 1 : 0;
  }
  c.volume_mark[0] = 0;
  return Nef3::from_complex(std::move(c)).complex();
}

SpaceComplex box(const RationalPoint3& low, const RationalPoint3& high) {
  SpaceScene scene;
  testing::add_box(scene, low, high);
  return full(scene);
}

class Marks {
 public:
  explicit Marks(const SpaceComplex& complex) : complex_(complex), locator_(complex) {}
  bool at(const RationalPoint3& p) const {
    const SpaceItem item = locator_.locate(p);
    const std::array<const std::vector<Mark>*, 4> marks{
        &complex_.vertex_mark, &complex_.edge_mark, &complex_.facet_mark, &complex_.volume_mark};
    return (*marks[static_cast<std::size_t>(item.kind())])[item.index()] == 1;
  }

 private:
  const SpaceComplex& complex_;
  SpaceLocator locator_;
};

std::vector<RationalPoint3> points_of(const SpaceComplex& c) {
  std::vector<RationalPoint3> points;
  for (const SpacePoint p : c.vertex_point) points.push_back(exact(c.points(), p));
  return points;
}

/// Vertices of all, and points halfway between some.
std::vector<RationalPoint3> samples(std::initializer_list<const SpaceComplex*> of, Dice& dice) {
  std::vector<RationalPoint3> points;
  for (const SpaceComplex* c : of) {
    for (const RationalPoint3& p : points_of(*c)) points.push_back(p);
  }
  const std::size_t corners = points.size();
  for (int i = 0; i < 120; ++i) {
    const RationalPoint3 &p = points[dice.below(corners)], &q = points[dice.below(corners)];
    points.push_back(testing::operator*(Rational(1, 2), testing::operator+(p, q)));
  }
  return points;
}

void expect_minimal(const SpaceComplex& c) {
  const auto flaw = audit(c, AuditForm::Minimal);
  EXPECT_FALSE(flaw) << flaw->invariant << " at " << flaw->place;
}

TEST(BooleanOp, TablesAreUnitedInPlaceIfNobodyElseNeedsThem) {
  SpaceComplex a = box({0, 0, 0}, {3, 3, 3});
  SpaceComplex b = box({1, 1, 0}, {Rational(4, 3), 2, Rational(7, 3)});
  const SpaceComplex old_a = a, old_b = b;  // they keep their tables
  const auto of_a = points_of(a), of_b = points_of(b);
  const std::size_t planes = a.planes().size();
  const auto shared = unite_tables(a, b);
  EXPECT_NE(shared.get(), old_a.tables.get()) << "another complex needs them as they are";
  EXPECT_EQ(old_a.planes().size(), planes);
  EXPECT_TRUE(a.tables == shared && b.tables == shared);
  EXPECT_EQ(points_of(a), of_a);
  EXPECT_EQ(points_of(b), of_b);
  expect_minimal(a);
  expect_minimal(b);
  // The plane z = 0 holds a facet of each.
  EXPECT_LT(a.planes().size(), planes + old_b.planes().size());

  SpaceComplex c = box({0, 0, 0}, {1, 1, 1}), d = box({2, 2, 2}, {3, 3, 3});
  const void* own = c.tables.get();
  EXPECT_EQ(unite_tables(c, d).get(), own);
  SpaceComplex e = c;  // c, d and e refer to one table: d lets go, but e does not
  EXPECT_NE(unite_tables(c, d).get(), own);
  EXPECT_EQ(points_of(e), points_of(c));
}

TEST(BooleanOp, MarksAreThoseOfTheFunction) {
  Context context;
  for (std::uint64_t seed = 0; seed < 8; ++seed) {
    SCOPED_TRACE(seed);
    Dice dice(seed);
    const SpaceComplex a = full(testing::random_scene(dice), &dice);
    const SpaceComplex b = full(testing::random_scene(dice), &dice);
    const std::array<MarkFunction, 4> functions{kUnion, kIntersection, kDifference,
                                                kSymmetricDifference};
    const MarkFunction f = functions[seed % 4];
    const SpaceComplex c = boolean_op(a, b, f, context);
    expect_minimal(c);
    const Marks of_a(a), of_b(b), of_c(c);
    for (const RationalPoint3& p : samples({&a, &b, &c}, dice)) {
      EXPECT_EQ(of_c.at(p), f(of_a.at(p), of_b.at(p)));
    }
  }
}

/// Where marks differ, kBeyond included.
TEST(BooleanOp, TablesOfMarksAreCombinedOnGivenTables) {
  Context context;
  Dice dice(9);
  SpaceComplex a = box({0, 0, 0}, {2, 2, 2}), b = box({1, 0, 1}, {3, 2, 2});
  for (auto* marks :
       std::initializer_list<std::vector<Mark>*>{&b.vertex_mark, &b.edge_mark, &b.facet_mark}) {
    marks->assign(marks->size(), 0);  // open, so that what lies in facets of both differs
  }
  const auto tables = unite_tables(a, b);
  std::vector<std::array<std::uint32_t, 2>> asked;
  const CommonOrigin origin = [&](std::uint32_t of_a, std::uint32_t of_b) {
    asked.push_back({of_a, of_b});
    return 77U;
  };
  const SpaceComplex c = boolean_op_on(tables, a, b, MarkTable::unequal(), origin, context);
  EXPECT_EQ(c.tables, tables);
  expect_minimal(c);
  EXPECT_FALSE(asked.empty());
  EXPECT_EQ(std::ranges::count(c.facet_origin, 77U), 3) << "in y = 0, y = 2 and z = 2";
  const Marks of_a(a), of_b(b), of_c(c);
  for (const RationalPoint3& p : samples({&a, &b, &c}, dice)) {
    EXPECT_EQ(of_c.at(p), of_a.at(p) != of_b.at(p));
  }
}

TEST(BooleanOp, HalfSpacesAndPlanesCut) {
  Context context;
  const std::array<PlaneSet, 5> sets{PlaneSet::OpenBelow, PlaneSet::ClosedBelow,
                                     PlaneSet::OpenAbove, PlaneSet::ClosedAbove, PlaneSet::Plane};
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    SCOPED_TRACE(seed);
    Dice dice(seed);
    SpaceScene scene;
    testing::add_box(scene, {0, 0, 0}, {2, 2, 2});
    testing::add_frame_box(scene, {3, 0, 0}, {6, 3, 2});
    scene.add_free_edge({0, 4, 0}, {1, 5, 2});
    const SpaceComplex a = full(scene, &dice);
    const auto tables = copy(*a.tables);
    const double sign = seed % 2 == 0 ? 1 : -1;  // both orientations of the plane
    const double x = static_cast<double>(dice.between(-1, 1));
    const double y = static_cast<double>(dice.between(-1, 1));
    const double d = static_cast<double>(dice.between(-4, 0));
    const OrientedPlane plane = tables->planes.intern(sign * x, sign * y, sign, sign * d);
    const PlaneSet h = sets[seed % sets.size()];
    const MarkFunction f = seed % 3 == 0 ? kIntersection : kDifference;
    const SpaceComplex c = boolean_op_with_plane(a, plane, h, f, tables, context);
    expect_minimal(c);
    const Marks of_a(a), of_c(c);
    for (const RationalPoint3& p : samples({&a, &c}, dice)) {
      const Rational value =
          exact_rational(sign) *
          (exact_rational(x) * p.x + exact_rational(y) * p.y + p.z + exact_rational(d));
      const bool is_below = h == PlaneSet::OpenBelow || h == PlaneSet::ClosedBelow;
      const bool has_plane = h == PlaneSet::ClosedBelow || h == PlaneSet::ClosedAbove;
      const bool in_h = h == PlaneSet::Plane ? value == 0
                        : value == 0         ? has_plane
                                             : (value < 0) == is_below;
      EXPECT_EQ(of_c.at(p), f(of_a.at(p), in_h));
    }
  }
  for (int i = 0; i <= static_cast<int>(PlaneSet::BeyondAbove); ++i) {
    const auto h = static_cast<PlaneSet>(i);
    EXPECT_EQ(opposite(opposite(h)), h);
    EXPECT_EQ(opposite(h) == h, h == PlaneSet::Plane);
  }
}

bool are_apart(const SpaceComplex& a, const SpaceComplex& b) {
  const std::array<Box3, 1> of_a{box_of(a)}, of_b{box_of(b)};
  return plumb::are_apart(BoxedComplex{a, of_a}, BoxedComplex{b, of_b});
}

TEST(BooleanOp, ApartIsWhatNothingSurrounds) {
  SpaceScene walls, with_void;
  testing::add_box(walls, {0, 0, 0}, {9, 9, 1});
  testing::add_box(walls, {0, 0, 2}, {1, 9, 9});
  testing::add_box(walls, {8, 0, 2}, {9, 9, 9});
  testing::add_box(walls, {2, 0, 2}, {7, 1, 9});
  testing::add_box(walls, {2, 8, 2}, {7, 9, 9});
  const SpaceComplex pit = full(walls);
  testing::add_box(walls, {0, 0, 10}, {9, 9, 11});
  const SpaceComplex covered = full(walls);
  testing::add_box(with_void, {0, 0, 0}, {9, 9, 9});
  testing::add_box(with_void, {1, 1, 1}, {8, 8, 8});
  const SpaceComplex hollow = full(with_void), pin = box({4, 4, 4}, {5, 5, 5});
  EXPECT_TRUE(are_apart(pin, box({6, 4, 4}, {7, 5, 5})));
  EXPECT_TRUE(are_apart(pit, pin)) << "the way up is free";
  EXPECT_TRUE(are_apart(pin, pit));
  EXPECT_FALSE(are_apart(covered, pin)) << "no way along an axis is free";
  EXPECT_FALSE(are_apart(pin, covered));
  EXPECT_FALSE(are_apart(hollow, pin)) << "in a bounded volume";
  EXPECT_FALSE(are_apart(pin, hollow));
  EXPECT_FALSE(are_apart(pit, box({4, 4, 4}, {10, 5, 5}))) << "through a wall";
  EXPECT_FALSE(are_apart(pin, box({5, 5, 5}, {6, 6, 6}))) << "at a corner";
  EXPECT_FALSE(are_apart(pin, testing::complex_of({})));
}

TEST(BooleanOp, WhatLiesApartIsAppended) {
  Context context;
  Dice dice(11);
  SpaceScene left, right;
  testing::add_frame_box(left, {0, 0, 0}, {9, 9, 2});
  left.add_free_edge({0, 0, 3}, {1, 1, 4});
  testing::add_box(right, {4, 4, Rational(19, 3)}, {5, 5, 8});
  right.add_facet({{20, 0, 0}, {26, 0, 0}, {26, 6, 0}, {20, 6, 0}},
                  {{{21, 1, 0}, {21, 2, 0}, {22, 2, 0}}});
  right.facets.back().inner = {right.add_point({24, 4, 0})};
  right.add_free_edge({24, 4, 0}, {24, 4, 2});
  right.add_point({30, 0, 0});
  for (const bool is_swapped : {false, true}) {
    const SpaceComplex a = full(is_swapped ? right : left), b = full(is_swapped ? left : right);
    const SpaceComplex c = appended(a, b);
    expect_minimal(c);
    EXPECT_EQ(c.vertex_count(), a.vertex_count() + b.vertex_count());
    EXPECT_EQ(c.volume_count(), a.volume_count() + b.volume_count() - 1);
    const Marks of_a(a), of_b(b), of_c(c);
    for (const RationalPoint3& p : samples({&a, &b}, dice)) {
      EXPECT_EQ(of_c.at(p), of_a.at(p) || of_b.at(p));
    }
    EXPECT_TRUE(Nef3::from_complex(c) == Nef3::from_complex(boolean_op(a, b, kUnion, context)));
  }
}

}  // namespace
}  // namespace plumb::boolean_op_test
