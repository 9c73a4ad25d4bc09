// The locator against brute force in rationals over all items of random small scenes, full of ties.
#include "plumb/space/space_locator.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <ostream>
#include <thread>
#include <vector>

#include "generate/meshes.h"
#include "generate/space_scenes.h"
#include "generate/test_share.h"
#include "plumb/predicates/point3_signs.h"
#include "plumb/predicates/rounding.h"
#include "plumb/space/from_mesh.h"
#include "plumb/space/query/volumes.h"
#include "plumb/testing/dice.h"

namespace plumb {

static std::ostream& operator<<(std::ostream& out, SpaceItem item) {
  if (!item.is_valid()) return out << "nothing";
  return out << "VEFW"[static_cast<std::size_t>(item.kind())] << item.index();
}
static std::ostream& operator<<(std::ostream& out, const RationalPoint3& p) {
  return out << p.x << ' ' << p.y << ' ' << p.z;
}

namespace testing::space_locator_test {
namespace {

bool is_zero(const RationalPoint3& v) { return v.x == 0 && v.y == 0 && v.z == 0; }

// --- the twin: every item of the scene, in rationals

struct Met {
  Rational t;
  RationalPoint3 at;
};

class Brute {
 public:
  explicit Brute(const SpaceComplex& complex) : complex_(complex) {
    for (const SpacePoint p : complex.vertex_point) points_.push_back(exact(complex.points(), p));
    for (std::size_t f = 0; f < complex.facet_count(); ++f) normals_.push_back(normal(f));
  }

  const std::vector<RationalPoint3>& points() const { return points_; }
  std::pair<RationalPoint3, RationalPoint3> ends(std::size_t e) const {
    return {points_[complex_.origin[2 * e].value()], points_[complex_.origin[2 * e + 1].value()]};
  }

  SpaceItem on_item(const RationalPoint3& p) const {
    for (std::size_t v = 0; v < points_.size(); ++v) {
      if (points_[v] == p) return VertexId(v);
    }
    for (std::size_t e = 0; e < complex_.edge_count(); ++e) {
      const auto [a, b] = ends(e);
      if (is_zero(cross(b - a, p - a)) && dot(a - p, b - p) < 0) return EdgeId(e);
    }
    for (std::size_t f = 0; f < complex_.facet_count(); ++f) {
      if (is_inside(f, p)) return FacetId(f);
    }
    return {};
  }

  std::optional<SpaceItemHit> shoot(const RationalPoint3& o, const RationalPoint3& d) const {
    std::vector<Met> met;
    for (const RationalPoint3& p : points_) {
      if (is_zero(cross(d, p - o))) met.push_back({dot(p - o, d), p});
    }
    for (std::size_t e = 0; e < complex_.edge_count(); ++e) meet_edge(e, o, d, met);
    for (std::size_t f = 0; f < complex_.facet_count(); ++f) meet_facet(f, o, d, met);
    std::erase_if(met, [](const Met& m) { return m.t <= 0; });
    if (met.empty()) return std::nullopt;
    const auto first = std::min_element(met.begin(), met.end(),
                                        [](const Met& m, const Met& n) { return m.t < n.t; });
    return SpaceItemHit{on_item(first->at), first->at};
  }

 private:
  RationalPoint3 normal(std::size_t f) const {
    RationalPoint3 sum{0, 0, 0};
    for_each_edge(complex_.cycles_of(FacetId(f)).first(1),
                  [&](const auto& a, const auto& b) { sum = sum + cross(a, b); });
    return sum;
  }

  template <class Visit>
  void for_each_edge(std::span<const UseId> cycles, Visit visit) const {
    for (const UseId first : cycles) {
      UseId u = first;
      do {
        const UseId next = complex_.use_next[u.value()];
        visit(points_[complex_.use_origin(u).value()], points_[complex_.use_origin(next).value()]);
        u = next;
      } while (u != first);
    }
  }

  /// Requires p on no vertex and edge. A ray in the facet's plane crosses the boundary oddly often.
  bool is_inside(std::size_t f, const RationalPoint3& p) const {
    const RationalPoint3& n = normals_[f];
    const UseId first = complex_.cycles_of(FacetId(f))[0];
    if (dot(n, p - points_[complex_.use_origin(first).value()]) != 0) return false;
    const RationalPoint3 ray =
        n.x != 0 || n.y != 0 ? RationalPoint3{n.y, -n.x, 0} : RationalPoint3{1, 0, 0};
    const RationalPoint3 left = cross(n, ray);
    bool inside = false;
    for_each_edge(complex_.cycles_of(FacetId(f)), [&](const auto& a, const auto& b) {
      const Rational s = dot(left, a - p), t = dot(left, b - p);
      if ((s > 0) == (t > 0)) return;
      if (dot(ray, a - p) * t - dot(ray, b - p) * s == 0) ADD_FAILURE() << "on the boundary";
      if ((dot(ray, a - p) * t - dot(ray, b - p) * s > 0) == (t > s)) inside = !inside;
    });
    return inside;
  }

  /// o + t d on the edge, where they cross. t is scaled as for vertices: by |d|^2.
  void meet_edge(std::size_t e, const RationalPoint3& o, const RationalPoint3& d,
                 std::vector<Met>& met) const {
    const auto [a, b] = ends(e);
    const RationalPoint3 n = cross(d, b - a);
    if (is_zero(n) || dot(n, a - o) != 0) return;
    const Rational t = dot(cross(a - o, b - a), n) / dot(n, n);
    const RationalPoint3 at = o + t * d;
    if (dot(a - at, b - at) < 0) met.push_back({t * dot(d, d), at});
  }

  void meet_facet(std::size_t f, const RationalPoint3& o, const RationalPoint3& d,
                  std::vector<Met>& met) const {
    const RationalPoint3& n = normals_[f];
    if (dot(n, d) == 0) return;
    const UseId first = complex_.cycles_of(FacetId(f))[0];
    const RationalPoint3& a = points_[complex_.use_origin(first).value()];
    const Rational t = dot(n, a - o) / dot(n, d);
    const RationalPoint3 at = o + t * d;
    const SpaceItem item = on_item(at);
    if (item == SpaceItem(FacetId(f))) met.push_back({t * dot(d, d), at});
  }

  const SpaceComplex& complex_;
  std::vector<RationalPoint3> points_;
  std::vector<RationalPoint3> normals_;
};

// --- points to ask about

class Questions {
 public:
  Questions(const SpaceComplex& complex, const Brute& brute, Dice& dice)
      : complex_(complex), brute_(brute), dice_(dice) {}

  /// On a vertex, an edge, near or on a facet's plane, on a line of coordinates through vertices,
  /// anywhere.
  RationalPoint3 point() {
    const RationalPoint3 a = vertex(), b = vertex(), c = vertex();
    switch (dice_.below(6)) {
      case 0:
        return a;
      case 1: {
        if (complex_.edge_count() == 0) return a;
        const auto [p, q] = brute_.ends(dice_.below(complex_.edge_count()));
        return p + Rational(dice_.between(0, 4), 4) * (q - p);
      }
      case 2:
        return in_facet();
      case 3:
        return {a.x, b.y, c.z};
      case 4:
        return a + Rational(dice_.between(-2, 6), 4) * (b - a);
      default:
        return {grid(), grid(), grid()};
    }
  }
  /// Between two vertices that are likely to be of one piece.
  RationalPoint3 point_between() {
    const std::size_t n = brute_.points().size(), i = dice_.below(n);
    const RationalPoint3 &a = brute_.points()[i], &b = brute_.points()[(i + dice_.below(9)) % n];
    return a + Rational(dice_.between(1, 3), 4) * (b - a);
  }
  RationalPoint3 direction() {
    for (;;) {
      RationalPoint3 d = vertex() - vertex();
      if (dice_.below(3) == 0) d = {sign(), sign(), sign()};
      if (!is_zero(d)) return d;
    }
  }

 private:
  RationalPoint3 vertex() {
    if (dice_.below(8) == 0) return {grid(), grid(), grid()};
    return brute_.points()[dice_.below(brute_.points().size())];
  }
  Rational grid() { return Rational(dice_.between(-2, 26), 2); }
  int sign() { return static_cast<int>(dice_.between(-1, 1)); }

  /// On the plane of some facet, inside or not: three corners with weights.
  RationalPoint3 in_facet() {
    if (complex_.facet_count() == 0) return vertex();
    const UseId u = complex_.cycles_of(FacetId(dice_.below(complex_.facet_count())))[0];
    const UseId v = complex_.use_next[u.value()], w = complex_.use_next[v.value()];
    const auto at = [&](UseId x) { return brute_.points()[complex_.use_origin(x).value()]; };
    return at(u) + Rational(dice_.between(0, 4), 4) * (at(v) - at(u)) +
           Rational(dice_.between(0, 4), 4) * (at(w) - at(u));
  }

  const SpaceComplex& complex_;
  const Brute& brute_;
  Dice& dice_;
};

std::optional<Point3> as_doubles(const RationalPoint3& p) {
  const RoundedDouble x = round_to_double(p.x), y = round_to_double(p.y), z = round_to_double(p.z);
  const bool is_exact = x.error == Sign::Zero && y.error == Sign::Zero && z.error == Sign::Zero;
  if (!is_exact) return std::nullopt;
  return Point3{x.value, y.value, z.value};
}

void expect_equal(const std::optional<SpaceItemHit>& found,
                  const std::optional<SpaceItemHit>& expected) {
  ASSERT_EQ(found.has_value(), expected.has_value());
  if (!found) return;
  EXPECT_EQ(found->item, expected->item);
  EXPECT_EQ(found->point, expected->point);
}

TEST(SpaceLocator, AgreesWithBruteForce) {
  std::array<int, 4> on_kind{}, hit_kind{};
  for (std::uint64_t seed = 0; seed < 150; ++seed) {
    Dice dice(seed);
    const SpaceComplex complex = complex_without_volumes(random_scene(dice));
    const SpaceLocator locator(complex);
    const Brute brute(complex);
    Questions ask(complex, brute, dice);
    for (int i = 0; i < 8; ++i) {
      const RationalPoint3 p = ask.point(), d = ask.direction();
      SCOPED_TRACE(::testing::Message() << "seed " << seed << " at " << p << " towards " << d);
      const SpaceItem on = brute.on_item(p);
      EXPECT_EQ(locator.on_item(p), on);
      const auto hit = brute.shoot(p, d);
      expect_equal(locator.shoot(p, d), hit);
      const auto q = as_doubles(p), e = as_doubles(d);
      if (q) {
        EXPECT_EQ(locator.on_item(*q), on);
      }
      if (q && e) expect_equal(locator.shoot(*q, *e), hit);
      ++on_kind[on.is_valid() ? static_cast<std::size_t>(on.kind()) : 3];
      ++hit_kind[hit ? static_cast<std::size_t>(hit->item.kind()) : 3];
      if (HasFailure()) return;
    }
  }
  for (const int count : on_kind) EXPECT_GT(count, 40);
  for (const int count : hit_kind) EXPECT_GT(count, 40);
}

TEST(SpaceLocator, ShootsLeftFromVertices) {
  std::array<int, 4> hit_kind{};
  for (std::uint64_t seed = 1000; seed < 1060; ++seed) {
    Dice dice(seed);
    const SpaceComplex complex = complex_without_volumes(random_scene(dice));
    const SpaceLocator locator(complex);
    const Brute brute(complex);
    for (std::size_t v = 0; v < complex.vertex_count(); v += 3) {
      const auto hit = brute.shoot(brute.points()[v], rational_point(-1, 0, 0));
      const SpaceItem expected = hit ? hit->item : SpaceItem();
      ASSERT_EQ(locator.shoot_left(complex.vertex_point[v]), expected) << seed << ' ' << v;
      ++hit_kind[hit ? static_cast<std::size_t>(expected.kind()) : 3];
    }
  }
  for (const int count : hit_kind) EXPECT_GT(count, 30);
}

// --- volumes

/// What a generic ray meets first is a facet, whose side knows the volume.
VolumeId brute_volume(const SpaceComplex& complex, const Brute& brute, const RationalPoint3& p) {
  for (int i = 1; i < 100; ++i) {
    const RationalPoint3 d{Rational(1009, 1000 + i), Rational(517 + i, 800), Rational(13 - i, 17)};
    const auto hit = brute.shoot(p, d);
    if (!hit) return VolumeId(0);
    if (hit->item.kind() != SpaceItem::Kind::Facet) continue;
    const FacetId f = hit->item.facet();
    const IntegerRow row = complex.planes().coefficients(complex.facet_plane[f.value()]);
    const bool from_positive = dot({row[0], row[1], row[2]}, d) < 0;
    return complex.facet_volume[f.value()][from_positive ? 0 : 1];
  }
  ADD_FAILURE() << "no generic ray";
  return {};
}

TEST(SpaceLocator, FindsVolumes) {
  std::size_t inside = 0;
  for (std::uint64_t seed = 2000; seed < 2120; ++seed) {
    Dice dice(seed);
    const SpaceComplex complex = complex_of(random_scene(dice));
    const SpaceLocator locator(complex);
    const Brute brute(complex);
    Questions ask(complex, brute, dice);
    for (int i = 0; i < 8; ++i) {
      const RationalPoint3 p = i % 2 == 0 ? ask.point() : ask.point_between();
      const SpaceItem on = brute.on_item(p);
      const SpaceItem expected = on.is_valid() ? on : SpaceItem(brute_volume(complex, brute, p));
      ASSERT_EQ(locator.locate(p), expected) << "seed " << seed << " at " << p;
      const auto q = as_doubles(p);
      if (q) {
        ASSERT_EQ(locator.locate(*q), expected) << "seed " << seed << " at " << p;
      }
      inside += expected.kind() == SpaceItem::Kind::Volume && expected.index() != 0 ? 1 : 0;
    }
  }
  EXPECT_GT(inside, 50U);
}

TEST(SpaceLocator, NestedBoxes) {
  SpaceScene scene;
  for (int i = 0; i < 4; ++i) {
    add_box(scene, rational_point(i, i, i), rational_point(10 - i, 10 - i, 10 - i));
  }
  const SpaceComplex complex = complex_of(scene);
  ASSERT_EQ(complex.volume_count(), 5U);
  const SpaceLocator locator(complex);
  EXPECT_EQ(locator.volume_of(Point3{-1, 5, 5}), VolumeId(0));
  for (std::uint32_t i = 0; i < 4; ++i) {
    // Straight to the left of corners, edges and facets of inner boxes.
    for (const double y : {i + 0.5, 4.0, 5.0}) {
      EXPECT_EQ(locator.volume_of(Point3{i + 0.5, y, 5}), VolumeId(i + 1));
      EXPECT_EQ(locator.volume_of(Point3{9.5 - i, y, 4}), VolumeId(i + 1));
    }
  }
}

// --- the frame

SpaceScene framed_scene(Dice& dice) {
  SpaceScene scene = random_scene(dice);
  add_slabs(scene, {-27, 27 + static_cast<int>(dice.below(3))}, Rational(dice.below(3), 4));
  return scene;
}

TEST(SpaceLocator, SeesThroughTheFrame) {
  std::size_t hits = 0, beyond = 0;
  for (std::uint64_t seed = 3000; seed < 3000 + share_of(25); ++seed) {
    Dice dice(seed);
    const SpaceComplex finite = complex_of(framed_scene(dice));
    SpaceComplex complex = framed(finite);
    Context context;
    label_volumes(complex, context);
    ASSERT_EQ(complex.volume_count(), finite.volume_count());
    EXPECT_EQ(complex.facet_volume, finite.facet_volume);
    const SpaceLocator locator(complex);
    const Brute brute(finite);
    for (std::size_t v = 0; v < complex.vertex_count(); v += 2) {
      const auto hit = brute.shoot(brute.points()[v], rational_point(-1, 0, 0));
      const SpaceItem expected = hit ? hit->item : SpaceItem();
      ASSERT_EQ(locator.shoot_left(complex.vertex_point[v]), expected) << seed << ' ' << v;
    }
    for (int i = 0; i < 8; ++i) {
      const auto near = [&] { return Rational(dice.between(-90, 90), 2); };
      const RationalPoint3 p{near(), near(), near()}, d{near(), near(), near()};
      SCOPED_TRACE(::testing::Message() << "seed " << seed << " at " << p << " towards " << d);
      const SpaceItem on = brute.on_item(p);
      ASSERT_EQ(locator.on_item(p), on);
      const SpaceItem expected = on.is_valid() ? on : SpaceItem(brute_volume(finite, brute, p));
      ASSERT_EQ(locator.locate(p), expected);
      auto hit = brute.shoot(p, d);
      const bool is_beyond = hit && (abs(hit->point.x) == kFar || abs(hit->point.y) == kFar ||
                                     abs(hit->point.z) == kFar);
      if (is_beyond) hit.reset();
      expect_equal(locator.shoot(p, d), hit);
      beyond += is_beyond ? 1 : 0;
      hits += hit ? 1 : 0;
    }
  }
  EXPECT_GT(beyond, share_of(10));
  EXPECT_GT(hits, share_of(10));
}

TEST(SpaceLocator, ManyThreadsAskOne) {
  Context context;
  SpaceComplex complex = complex_of_mesh(icosphere_mesh(2, 1, {}), {}, context).complex;
  label_volumes(complex, context);
  const SpaceLocator locator(complex);
  std::vector<Point3> points;
  Dice dice(7);
  const auto coordinate = [&] { return static_cast<double>(dice.between(-64, 64)) / 48; };
  for (int i = 0; i < 2000; ++i) points.push_back({coordinate(), coordinate(), coordinate()});
  std::vector<SpaceItem> expected(points.size()), found(points.size());
  locator.locate(points, expected);
  std::vector<std::thread> threads;
  for (std::size_t i = 0; i < 4; ++i) {
    threads.emplace_back([&, i] {
      locator.locate(std::span(points).subspan(500 * i, 500),
                     std::span(found).subspan(500 * i, 500));
    });
  }
  for (std::thread& t : threads) t.join();
  EXPECT_EQ(found, expected);
  std::size_t inside = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Point3& p = points[i];
    const double length = p.x * p.x + p.y * p.y + p.z * p.z;
    if (length < 0.9 || length > 1.01) {
      ASSERT_EQ(found[i], SpaceItem(VolumeId(length < 0.9 ? 1 : 0)));
    }
    inside += found[i] == SpaceItem(VolumeId(1)) ? 1 : 0;
  }
  EXPECT_GT(inside, 200U);
}

// Very many plates in the way, all closer together than they are wide: if each query met all, this
// test would take very long.
TEST(SpaceLocator, MeetsFewOfManyPlates) {
  constexpr std::uint32_t kPlates = 20000;
  PolygonMesh mesh;
  for (std::uint32_t i = 0; i < kPlates; ++i) {
    const double x = static_cast<double>(i) / kPlates;
    mesh.points.insert(mesh.points.end(), {{x, 0, 0}, {x, 1, 0}, {x, 0, 1}});
    mesh.add_face(std::array{3 * i, 3 * i + 1, 3 * i + 2});
  }
  Context context;
  MeshOptions options;
  options.surface = true;
  SpaceComplex complex = complex_of_mesh(mesh, options, context).complex;
  label_volumes(complex, context);
  EXPECT_EQ(complex.volume_count(), 1U);
  const SpaceLocator locator(complex);
  for (std::uint32_t i = 0; i < kPlates; ++i) {
    const double x = mesh.points[3 * i].x;
    const Point3 origin{x + 0.25 / kPlates, 0.25, 0.25};
    const auto left = locator.shoot(origin, Point3{-1, 0, 0});
    ASSERT_TRUE(left.has_value());
    ASSERT_EQ(left->point, (RationalPoint3{Rational(x), Rational(1, 4), Rational(1, 4)}));
    ASSERT_EQ(left->item.kind(), SpaceItem::Kind::Facet);
  }
}

TEST(SpaceLocator, EmptyComplex) {
  SpaceComplex complex = complex_of({});
  const SpaceLocator locator(complex);
  EXPECT_FALSE(locator.on_item(Point3{}).is_valid());
  EXPECT_FALSE(locator.shoot(Point3{}, Point3{1, 0, 0}).has_value());
  EXPECT_EQ(locator.locate(Point3{}), SpaceItem(VolumeId(0)));
}

}  // namespace
}  // namespace testing::space_locator_test
}  // namespace plumb
