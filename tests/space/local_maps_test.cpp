// Sphere maps of all items of scenes: what lies in a direction is what the locator finds a tiny
// step that way, with its mark. There are free edges, lone vertices, slits and touching solids.
#include "plumb/space/local_maps.h"

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include "generate/space_scenes.h"
#include "plumb/predicates/point3_signs.h"
#include "plumb/space/planar/facet_triangles.h"
#include "plumb/space/space_locator.h"
#include "plumb/sphere/overlay/sphere_overlay.h"
#include "plumb/sphere/sphere_audit.h"

namespace plumb::local_maps_test {
namespace {

using testing::cross;
using testing::Dice;
using testing::SpaceScene;
using testing::operator+;
using testing::operator*;

class MapCheck {
 public:
  MapCheck(const SpaceScene& scene, Dice& dice)
      : dice_(dice), complex_(testing::complex_of(scene)), tables_(copy(*complex_.tables)) {
    complex_.tables = tables_;
    for (std::vector<Mark>* marks :
         std::initializer_list<std::vector<Mark>*>{&complex_.vertex_mark, &complex_.edge_mark,
                                                   &complex_.facet_mark, &complex_.volume_mark}) {
      for (Mark& m : *marks) m = static_cast<Mark>(dice.below(2));
    }
    planes_ = complex_.facet_plane;
    for (int i = 0; i < 4; ++i) {
      const auto number = [&] { return static_cast<double>(dice.between(-4, 4)); };
      const double a = number(), b = number();
      planes_.push_back(tables_->planes.intern(a, b, 5, number()).plane());
    }
  }

  /// Looks in some directions from a point of every item, most of them along or within items.
  void run(int directions) {
    const SpaceLocator locator(complex_);
    std::vector<RationalPoint3> at;
    for (const SpacePoint p : complex_.vertex_point) at.push_back(exact(complex_.points(), p));
    for (std::uint32_t v = 0; v < at.size(); ++v) check(VertexId(v), at[v], locator, directions);
    for (std::uint32_t e = 0; e < complex_.edge_count(); ++e) {
      const RationalPoint3& from = at[complex_.origin[2 * e].value()];
      const RationalPoint3& to = at[complex_.origin[2 * e + 1].value()];
      check(EdgeId(e), Rational(1, 2) * (from + to), locator, directions);
    }
    FacetTriangles triangles(complex_);
    for (std::uint32_t f = 0; f < complex_.facet_count(); ++f) {
      RationalPoint3 inside{0, 0, 0};
      triangles.for_each(FacetId(f), [&](VertexId a, VertexId b, VertexId c) {
        inside = Rational(1, 3) * (at[a.value()] + at[b.value()] + at[c.value()]);
      });
      check(FacetId(f), inside, locator, directions);
    }
  }
  std::array<int, 4> seen() const { return seen_; }

 private:
  Mark mark_of(SpaceItem item) const {
    switch (item.kind()) {
      case SpaceItem::Kind::Vertex:
        return complex_.vertex_mark[item.index()];
      case SpaceItem::Kind::Edge:
        return complex_.edge_mark[item.index()];
      case SpaceItem::Kind::Facet:
        return complex_.facet_mark[item.index()];
      case SpaceItem::Kind::Volume:
        break;
    }
    return complex_.volume_mark[item.index()];
  }
  Mark mark_of(SphereCell cell) const {
    if (cell.kind() == SphereCell::Kind::Point) return local_.map.point_mark[cell.index()];
    if (cell.kind() == SphereCell::Kind::Arc) return local_.map.arc_mark[cell.index()];
    return local_.map.face_mark[cell.index()];
  }
  RationalPoint3 normal(PlaneId p) const {
    const IntegerRow row = complex_.planes().primitive(p);
    return {row[0], row[1], row[2]};
  }

  void check(SpaceItem item, const RationalPoint3& at, const SpaceLocator& locator,
             int directions) {
    local_map(complex_, item, local_);
    EXPECT_EQ(local_.map.centre_mark, mark_of(item));
    EXPECT_FALSE(audit(complex_.planes(), local_.map, AuditForm::Any)) << "item " << item.code();
    for (int i = 0; i < directions; ++i) {
      PlaneId p = planes_[dice_.below(planes_.size())];
      PlaneId q = planes_[dice_.below(planes_.size())];
      if (dice_.below(3) == 0 && complex_.edge_count() > 0) {  // along an edge
        const auto& planes = complex_.edge_planes[dice_.below(complex_.edge_count())];
        p = planes[0];
        q = planes[1];
        if (dice_.below(2) == 0) std::swap(p, q);
      }
      const RationalPoint3 d = cross(normal(p), normal(q));
      if (d == RationalPoint3{0, 0, 0}) continue;
      const Rational tiny = Rational(1) / Rational(Integer(1) << 60U);
      const SpaceItem there = locator.locate(at + tiny * d);
      const SphereCell cell = locate(complex_.planes(), local_.map, {p, q});
      ASSERT_EQ(local_.item(cell).code(), there.code()) << "from item " << item.code();
      EXPECT_EQ(mark_of(cell), mark_of(there));
      ++seen_[static_cast<std::size_t>(there.kind())];
    }
  }

  Dice& dice_;
  SpaceComplex complex_;
  std::shared_ptr<SpaceTables> tables_;
  std::vector<PlaneId> planes_;
  LocalMap local_;
  std::array<int, 4> seen_{};
};

void expect_all_kinds(const std::array<int, 4>& seen) {
  EXPECT_EQ(seen[0], 0) << "no step is a tiny one if it reaches a vertex";
  for (std::size_t k = 1; k < 4; ++k) EXPECT_GT(seen[k], 20) << k;
}

/// Four facets at an edge, two rings at a vertex, a facet with a hole, and several edges from a
/// vertex inside a facet, some of which lie in one line.
TEST(LocalMaps, OfTouchingSolids) {
  SpaceScene scene;
  testing::add_box(scene, {0, 0, 0}, {1, 1, 1});
  testing::add_box(scene, {1, 1, 0}, {2, 2, 1});
  testing::add_box(scene, {2, 2, 1}, {3, 3, 2});
  testing::add_frame_box(scene, {6, 0, 0}, {9, 3, 2});
  Dice dice(1);
  MapCheck check(scene, dice);
  check.run(16);
  expect_all_kinds(check.seen());
}

TEST(LocalMaps, OfFreeEdgesAndInnerVertices) {
  SpaceScene scene;
  scene.add_facet({{0, 0, 0}, {6, 0, 0}, {6, 6, 0}, {0, 6, 0}});
  const std::uint32_t inner = scene.add_point({2, 2, 0});
  scene.facets[0].inner = {inner, scene.add_point({4, 4, 0})};
  for (const RationalPoint3& to : {RationalPoint3{2, 2, 3}, {2, 2, -3}, {3, 2, 1}, {2, 1, -1}}) {
    scene.add_free_edge({2, 2, 0}, to);
  }
  scene.add_facet({{2, 2, 3}, {3, 2, 4}, {2, 3, 4}});
  scene.add_free_edge({6, 6, 0}, {7, 7, 1});
  scene.add_free_edge({6, 6, 0}, {6, 6, 1});
  scene.add_point({9, 9, 9});
  Dice dice(2);
  MapCheck check(scene, dice);
  check.run(32);
  expect_all_kinds(check.seen());
}

/// A solid around which another one hangs at a vertex, from inside: parts of the map of that vertex
/// are nested, and their faces must be found by arithmetic.
TEST(LocalMaps, OfNestedCones) {
  SpaceScene scene;
  testing::add_tetrahedron(scene, {{{0, 0, 0}, {20, 0, 0}, {0, 20, 0}, {0, 0, 20}}});
  testing::add_tetrahedron(scene, {{{0, 0, 0}, {3, 2, 2}, {2, 3, 2}, {2, 2, 3}}});
  scene.add_free_edge({0, 0, 0}, {1, 1, 5});
  scene.add_free_edge({0, 0, 0}, {-1, -1, -1});
  testing::add_tetrahedron(scene, {{{0, 0, 0}, {-3, -2, 2}, {-2, -3, 2}, {-2, -2, 3}}});
  Dice dice(3);
  MapCheck check(scene, dice);
  check.run(30);
  expect_all_kinds(check.seen());
}

TEST(LocalMaps, OfRandomScenes) {
  for (std::uint64_t seed = 0; seed < 5; ++seed) {
    SCOPED_TRACE(seed);
    Dice dice(seed);
    MapCheck(testing::random_scene(dice), dice).run(4);
  }
}

}  // namespace
}  // namespace plumb::local_maps_test
