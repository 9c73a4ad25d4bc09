// The grammar that the sets of plane, sphere and space share: the same code, with the same laws,
// for all three.
#include "plumb/base/nef_set.h"

#include <gtest/gtest.h>

#include <stop_token>
#include <vector>

#include "plumb/plumb.h"

namespace plumb::nef_set_test {
namespace {

static_assert(NefSet<Nef2> && NefSet<NefSphere> && NefSet<Nef3>);
static_assert(MeasurableNefSet<Nef2> && MeasurableNefSet<Nef3> && !MeasurableNefSet<NefSphere>);
static_assert(!NefSet<int>);

/// For each kind of set: two half-spaces of its kind with different boundaries, a point of both and
/// a point of neither.
template <class Set>
struct Sample;

template <>
struct Sample<Nef2> {
  Nef2 a = Nef2::half_plane(Line2::from_coefficients(1, 0, 0), Boundary::Closed);  // x <= 0
  Nef2 b = Nef2::half_plane(Line2::from_coefficients(0, 1, 0), Boundary::Open);    // y < 0
  RationalPoint2 of_both{-1, -1}, of_neither{1, 1}, direction{1, 1};
};

template <>
struct Sample<NefSphere> {
  NefSphere a = NefSphere::half_sphere({-1.0, 0.0, 0.0}, Boundary::Closed);
  NefSphere b = NefSphere::half_sphere({0.0, -1.0, 0.0}, Boundary::Open);
  SphereVector of_both{-1.0, -1.0, 0.0}, of_neither{1.0, 1.0, 0.0}, direction{1.0, -1.0, 0.0};
};

template <>
struct Sample<Nef3> {
  Nef3 a = Nef3::half_space({1, 0, 0, 0}, Boundary::Closed);
  Nef3 b = Nef3::half_space({0, 1, 0, 0}, Boundary::Open);
  RationalPoint3 of_both{-1, -1, 0}, of_neither{1, 1, 0}, direction{1, 1, 0};
};

template <class Set>
class NefSetGrammar : public testing::Test {};
using Sets = testing::Types<Nef2, NefSphere, Nef3>;
TYPED_TEST_SUITE(NefSetGrammar, Sets);

TYPED_TEST(NefSetGrammar, ObeysTheLawsOfSets) {
  const Sample<TypeParam> s;
  const TypeParam &a = s.a, &b = s.b;
  EXPECT_EQ(!(a + b), !a * !b);
  EXPECT_EQ(a - b, a * !b);
  EXPECT_EQ(a ^ b, (a - b) + (b - a));
  EXPECT_EQ(boolean_op(a, b, kUnion), a + b);
  EXPECT_EQ(boolean_op(a, {}, b, {}, kDifference), a - b);
  EXPECT_EQ(union_of(std::vector<TypeParam>{a, b, !a}), TypeParam::whole());
  EXPECT_EQ(intersection_of(std::vector<TypeParam>{a, b, !a}), TypeParam::empty());
  EXPECT_TRUE((a * b).is_subset_of(a) && !(a + b).is_subset_of(a));
  EXPECT_TRUE(TypeParam().is_empty() && TypeParam::whole().is_whole());
  EXPECT_EQ(a.interior() + a.boundary(), a.closure());
  EXPECT_EQ(a.exterior(), a.complement().interior());
}

/// A - B of closed sets is not closed; users of meshes want its closure without dangling parts.
TYPED_TEST(NefSetGrammar, RegularizesByName) {
  const Sample<TypeParam> s;
  const TypeParam& a = s.a;
  const TypeParam b = s.b.closure();
  EXPECT_FALSE((a - b).is_closed());
  EXPECT_TRUE(regularized_difference(a, b).is_closed());
  EXPECT_EQ(regularized_difference(a, b), (a - b).closure());
  EXPECT_EQ(regularized_union(a, b), a + b);
  EXPECT_EQ(regularized_symmetric_difference(a, b), (a ^ b).closure());
  // They only touch: a with the closure of its complement.
  EXPECT_FALSE((a * (!a).closure()).is_empty());
  EXPECT_TRUE(regularized_intersection(a, (!a).closure()).is_empty());
}

TYPED_TEST(NefSetGrammar, AnswersTheSameQuestions) {
  const Sample<TypeParam> s;
  const TypeParam both = s.a * s.b;
  EXPECT_TRUE(both.contains(s.of_both) && !both.contains(s.of_neither));
  EXPECT_TRUE(both.locate(s.of_both).marked);
  EXPECT_FALSE(both.has_on_boundary(s.of_both));
  EXPECT_FALSE(both.is_closed() || both.is_open());
  EXPECT_FALSE(both.audit().has_value());
  EXPECT_GT(both.bytes(), 0U);
  EXPECT_EQ(TypeParam::from_complex(both.complex()), both);
  EXPECT_EQ(TypeParam::from_minimal_unchecked(both.complex()), both);
  EXPECT_EQ(both.with_marks(both.marks()), both);
}

TYPED_TEST(NefSetGrammar, ShootsFromAPointOfTheSet) {
  const Sample<TypeParam> s;
  const TypeParam both = s.a * s.b;
  const auto hit = both.shoot(s.of_both, s.direction);
  ASSERT_TRUE(hit.has_value());
  EXPECT_TRUE(hit->location.marked);
  const auto wall = both.shoot_to_boundary(s.of_both, s.direction);
  ASSERT_TRUE(wall.has_value());
  EXPECT_TRUE(both.has_on_boundary(wall->point));
}

/// Whatever grows with its input accepts a context and looks at it.
TYPED_TEST(NefSetGrammar, StopsWhenTheContextSaysSo) {
  const Sample<TypeParam> s;
  std::stop_source stop;
  stop.request_stop();
  Context context({}, stop.get_token());
  const auto is_cancelled = [](auto&& operation) {
    try {
      operation();
    } catch (const Error& error) {
      return error.code() == ErrorCode::Cancelled;
    }
    return false;
  };
  const TypeParam &a = s.a, &b = s.b;
  EXPECT_TRUE(is_cancelled([&] { (void)boolean_op(a, b, kUnion, context); }));
  EXPECT_TRUE(is_cancelled([&] { (void)a.is_subset_of(b, context); }));
  EXPECT_TRUE(is_cancelled([&] { (void)a.complement(context); }));
  EXPECT_TRUE(is_cancelled([&] { (void)a.interior(context); }));
  EXPECT_TRUE(is_cancelled([&] { (void)a.locate(s.of_both, context); }));
  EXPECT_TRUE(is_cancelled([&] { (void)a.shoot(s.of_both, s.direction, context); }));
  EXPECT_TRUE(is_cancelled([&] { (void)a.audit(context); }));
}

}  // namespace
}  // namespace plumb::nef_set_test
