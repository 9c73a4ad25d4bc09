// Volumes, centroids and areas of solids where they are known, and laws where they are not.
#include "plumb/space/space_measure.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "generate/meshes.h"
#include "generate/space_scenes.h"
#include "plumb/predicates/error.h"
#include "plumb/predicates/rounding.h"
#include "plumb/space/nef3.h"
#include "plumb/space/space_locator.h"
#include "plumb/testing/dice.h"

namespace plumb::testing::space_measure_test {
namespace {

RationalPoint3 at(int x, int y, int z) { return rational_point(x, y, z); }

/// The complex with marks on the volumes of some points.
SpaceComplex marked(const SpaceScene& scene, const std::vector<Point3>& inside) {
  SpaceComplex complex = complex_of(scene);
  const SpaceLocator locator(complex);
  for (const Point3& p : inside) complex.volume_mark[locator.volume_of(p).value()] = 1;
  return complex;
}

void expect_measures(const SpaceComplex& complex, const Rational& volume,
                     const RationalPoint3& centroid, double area) {
  EXPECT_EQ(marked_volume(complex), volume);
  EXPECT_EQ(marked_centroid(complex), centroid);
  const auto found = surface_area(complex);
  ASSERT_TRUE(found.has_value());
  EXPECT_NEAR(*found, area, area * 0x1p-50);
}

const Rational kHalf(1, 2);

TEST(SpaceMeasure, Box) {
  SpaceScene scene;
  add_box(scene, at(1, 2, 3), at(3, 5, 7));
  expect_measures(marked(scene, {{2, 3, 4}}), 24, {2, 7 * kHalf, 5}, 52);
}

TEST(SpaceMeasure, Tetrahedron) {
  SpaceScene scene;
  add_tetrahedron(scene, {at(0, 0, 0), at(1, 0, 0), at(0, 1, 0), at(0, 0, 1)});
  const Rational quarter(1, 4);
  expect_measures(marked(scene, {{0.125, 0.125, 0.125}}), Rational(1, 6),
                  {quarter, quarter, quarter}, 1.5 + std::sqrt(3.0) / 2);
}

TEST(SpaceMeasure, BoxAroundAVoid) {
  SpaceScene scene;
  add_box(scene, at(0, 0, 0), at(4, 4, 4));
  add_box(scene, at(0, 0, 0) + RationalPoint3{1, 1, 1}, at(2, 2, 2));
  // 64 at (2, 2, 2) without 1 at (3/2, 3/2, 3/2).
  const Rational c = (128 - 3 * kHalf) / 63;
  expect_measures(marked(scene, {{3, 3, 3}}), 63, {c, c, c}, 96 + 6);
  expect_measures(marked(scene, {{3, 3, 3}, {1.5, 1.5, 1.5}}), 64, at(2, 2, 2), 96);
  expect_measures(marked(scene, {{1.5, 1.5, 1.5}}), 1, {3 * kHalf, 3 * kHalf, 3 * kHalf}, 6);
}

TEST(SpaceMeasure, PrismWithAShaft) {
  SpaceScene scene;
  add_frame_box(scene, at(0, 0, 0), at(3, 3, 6));
  const SpaceComplex complex = marked(scene, {{0.5, 0.5, 0.5}});
  ASSERT_EQ(complex.volume_count(), 2U);
  expect_measures(complex, 48, {3 * kHalf, 3 * kHalf, 3}, 4 * 18 + 4 * 6 + 2 * 8);
}

/// Over an L: facets that are not convex, seen from a corner where they turn back.
TEST(SpaceMeasure, ReflexPrism) {
  const std::vector<RationalPoint3> bottom = {at(1, 1, 0), at(1, 3, 0), at(0, 3, 0),
                                              at(0, 0, 0), at(3, 0, 0), at(3, 1, 0)};
  SpaceScene scene;
  std::vector<RationalPoint3> top;
  for (const RationalPoint3& p : bottom) top.push_back(p + at(0, 0, 2));
  scene.add_facet(bottom);
  scene.add_facet(top);
  for (std::size_t i = 0; i < bottom.size(); ++i) {
    const std::size_t j = (i + 1) % bottom.size();
    scene.add_facet({bottom[i], bottom[j], top[j], top[i]});
  }
  const Rational c = (3 * kHalf * 3 + 2 * kHalf) / 5;
  expect_measures(marked(scene, {{0.5, 0.5, 1}}), 10, {c, c, 1}, 2 * 5 + 12 * 2);
}

TEST(SpaceMeasure, NothingMarked) {
  SpaceScene scene;
  add_box(scene, at(0, 0, 0), at(1, 1, 1));
  const SpaceComplex complex = complex_of(scene);
  EXPECT_EQ(marked_volume(complex), Rational(0));
  EXPECT_FALSE(marked_centroid(complex).has_value());
  EXPECT_EQ(surface_area(complex), 0.0);
}

TEST(SpaceMeasure, InfiniteVolume) {
  SpaceScene scene;
  add_box(scene, at(0, 0, 0), at(1, 1, 1));
  SpaceComplex complex = complex_of(scene);
  complex.volume_mark[0] = 1;
  EXPECT_FALSE(marked_volume(complex).has_value());
  EXPECT_FALSE(marked_centroid(complex).has_value());
  EXPECT_EQ(surface_area(complex), 6.0);
}

TEST(SpaceMeasure, Frame) {
  SpaceScene scene;
  add_slabs(scene, {2, 5}, kHalf);
  add_box(scene, at(-3, 0, 0), at(-1, 2, 2));
  SpaceComplex complex = framed(complex_of(scene));
  const SpaceLocator locator(complex);
  const VolumeId box = locator.volume_of(Point3{-2, 1, 1});
  const VolumeId slab = locator.volume_of(Point3{3, 0, 0});
  complex.volume_mark[0] = kBeyond;
  complex.volume_mark[box.value()] = 1;
  expect_measures(complex, 8, at(-2, 1, 1), 24);
  complex.volume_mark[slab.value()] = 1;
  EXPECT_FALSE(marked_volume(complex).has_value());
  EXPECT_FALSE(marked_centroid(complex).has_value());
  EXPECT_FALSE(surface_area(complex).has_value());
}

TEST(SpaceMeasure, FarFromTheOriginNothingIsLost) {
  SpaceScene scene;
  const RationalPoint3 low{exact_rational(0x1p200), exact_rational(0x1p60), Rational(1, 3)};
  add_box(scene, low, low + at(1, 1, 1));
  SpaceComplex complex = complex_of(scene);
  complex.volume_mark[1] = 1;
  expect_measures(complex, 1, low + kHalf * at(1, 1, 1), 6);
}

/// Of all volumes together; each is marked alone and with others.
TEST(SpaceMeasure, RandomScenesAddUp) {
  std::size_t volumes = 0;
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    Dice dice(seed);
    SpaceComplex complex = complex_of(random_scene(dice));
    if (complex.volume_count() == 1) continue;
    Rational sum = 0;
    RationalPoint3 moment{0, 0, 0};
    for (std::size_t v = 1; v < complex.volume_count(); ++v) {
      complex.volume_mark.assign(complex.volume_count(), 0);
      complex.volume_mark[v] = 1;
      const auto volume = marked_volume(complex);
      ASSERT_TRUE(volume.has_value() && *volume > 0) << seed;
      sum += *volume;
      moment = moment + *volume * *marked_centroid(complex);
    }
    complex.volume_mark.assign(complex.volume_count(), 1);
    complex.volume_mark[0] = 0;
    EXPECT_EQ(marked_volume(complex), sum) << seed;
    EXPECT_EQ(*marked_volume(complex) * *marked_centroid(complex), moment) << seed;
    volumes += complex.volume_count() - 1;
  }
  EXPECT_GT(volumes, 60U);
}

/// x -> A x + t: volumes grow by |det A| = 5, centroids move along; areas with rotations only.
TEST(SpaceMeasure, AffineMaps) {
  for (std::uint64_t seed = 100; seed < 120; ++seed) {
    Dice dice(seed);
    const SpaceScene scene = random_scene(dice);
    SpaceScene sheared = scene, turned = scene;
    const auto map = [](const RationalPoint3& p) {
      return RationalPoint3{2 * p.x + p.y, p.y + p.z + 1, p.x - 3 * p.z - Rational(1, 3)};
    };
    for (RationalPoint3& p : sheared.points) p = map(p);
    for (RationalPoint3& p : turned.points) {
      p = Rational(1, 5) * RationalPoint3{3 * p.x - 4 * p.y, 4 * p.x + 3 * p.y, 5 * p.z};
    }
    std::array<SpaceComplex, 3> all = {complex_of(scene), complex_of(sheared), complex_of(turned)};
    for (SpaceComplex& complex : all) {
      complex.volume_mark.assign(complex.volume_count(), 1);
      complex.volume_mark[0] = 0;
    }
    EXPECT_EQ(*marked_volume(all[1]), 5 * *marked_volume(all[0])) << seed;
    const auto centroid = marked_centroid(all[0]);
    if (!centroid) continue;
    EXPECT_EQ(marked_centroid(all[1]), map(*centroid)) << seed;
    EXPECT_EQ(marked_volume(all[2]), marked_volume(all[0])) << seed;
    const double area = *surface_area(all[0]);
    EXPECT_NEAR(*surface_area(all[2]), area, area * 0x1p-49) << seed;
  }
}

TEST(SpaceMeasure, KeepsToLimits) {
  Context context;
  const Nef3 ball =
      Nef3::from_mesh(icosphere_mesh(2, 1, {0, 0, 0}), {.rule = WindingRule::Positive}, context);
  const SpaceComplex& c = ball.complex();
  EXPECT_EQ(marked_volume(c, context), marked_volume(c));
  Limits limits;
  limits.max_seconds = 1e-9;
  Context late(limits);
  EXPECT_THROW(marked_volume(c, late), Error);
  EXPECT_THROW(marked_centroid(c, late), Error);
  EXPECT_THROW(surface_area(c, late), Error);
}

}  // namespace
}  // namespace plumb::testing::space_measure_test
