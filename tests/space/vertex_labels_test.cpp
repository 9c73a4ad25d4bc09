// Labels of vertices against the locator of the other operand, and carriers of vertices against
// their sphere maps added one by one.
#include "plumb/space/boolean/vertex_labels.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <memory>
#include <vector>

#include "generate/meshes.h"
#include "generate/space_scenes.h"
#include "generate/voxel_mesh.h"
#include "plumb/predicates/point3_signs.h"
#include "plumb/space/boolean/boolean_op.h"
#include "plumb/space/from_mesh.h"
#include "plumb/space/query/volumes.h"
#include "plumb/space/space_audit.h"
#include "plumb/space/space_locator.h"

namespace plumb::vertex_labels_test {
namespace {

using testing::Dice;
using testing::SpaceScene;

/// Boxes, a tetrahedron and a chain on a small grid, so that contacts of all kinds are frequent.
SpaceComplex random_operand(Dice& dice) {
  SpaceScene scene;
  const auto number = [&dice](int low, int high) { return Rational(dice.between(low, high)); };
  const auto point = [&](int low, int high) {
    const Rational x = number(low, high), y = number(low, high);
    return RationalPoint3{x, y, number(low, high)};
  };
  const RationalPoint3 low = point(0, 2), side = point(1, 3);
  testing::add_box(scene, low, testing::operator+(low, side));
  if (dice.below(2) == 0) {
    testing::add_box(scene, {7, 0, 0}, {9, 2, number(1, 4)});
    testing::add_tetrahedron(scene, {{{-1, 0, 0}, {-4, 1, 0}, {-3, 3, 1}, {-3, 0, number(1, 3)}}});
  }
  if (dice.below(2) == 0) {
    const RationalPoint3 from{number(0, 6), -2, 0}, to{number(0, 6), -3, 5};
    scene.add_free_edge(from, to);
    scene.add_free_edge(to, {8, -2, number(0, 3)});
    scene.add_point({number(0, 9), -5, 1});
  }
  if (dice.below(3) == 0) testing::add_box(scene, {-6, -6, -6}, {12, 12, 12});  // around all
  return testing::complex_of(scene);
}

struct Meeting {
  explicit Meeting(Dice& dice)
      : a(random_operand(dice)),
        b(random_operand(dice)),
        tables(unite_tables(a, b)),
        contacts(find_contacts(a, b, *tables, context)) {}

  Context context;
  SpaceComplex a;
  SpaceComplex b;
  std::shared_ptr<SpaceTables> tables;
  std::vector<Contact> contacts;
};

TEST(VertexLabels, KnowWhatContactsTouch) {
  std::size_t on_vertices = 0, on_edges = 0;
  for (std::uint64_t seed = 0; seed < 30; ++seed) {
    Dice dice(seed);
    const Meeting m(dice);
    for (const std::size_t operand : {0U, 1U}) {
      const SpaceComplex& c = operand == 0 ? m.a : m.b;
      const TouchedComplex touched(c, m.contacts, operand);
      std::vector<std::uint32_t> vertices(c.vertex_count(), TouchedComplex::kUntouched);
      std::vector<std::vector<std::uint32_t>> edges(c.edge_count());
      for (std::uint32_t i = 0; i < m.contacts.size(); ++i) {
        const SpaceItem item = operand == 0 ? m.contacts[i].a : m.contacts[i].b;
        if (item.kind() == SpaceItem::Kind::Vertex) vertices[item.index()] = i, ++on_vertices;
        if (item.kind() == SpaceItem::Kind::Edge) edges[item.index()].push_back(i), ++on_edges;
      }
      EXPECT_EQ(touched.contact_of_vertex, vertices);
      for (std::uint32_t e = 0; e < c.edge_count(); ++e) {
        const auto begin = touched.edge_contacts.begin();
        std::vector<std::uint32_t> known(begin + touched.edge_begin[e],
                                         begin + touched.edge_begin[e + 1]);
        std::ranges::sort(known);
        EXPECT_EQ(known, edges[e]);
        EXPECT_EQ(touched.is_touched(EdgeId(e)), !edges[e].empty());
      }
    }
  }
  EXPECT_GT(on_vertices, 50U);
  EXPECT_GT(on_edges, 50U);
}

TEST(VertexLabels, AreWhereTheLocatorFindsVertices) {
  std::size_t touched_count = 0, outside = 0, inside = 0;
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    SCOPED_TRACE(seed);
    Dice dice(seed);
    Meeting m(dice);
    for (const std::size_t operand : {0U, 1U}) {
      const SpaceComplex& own = operand == 0 ? m.a : m.b;
      const SpaceComplex& other = operand == 0 ? m.b : m.a;
      const TouchedComplex touched(own, m.contacts, operand);
      const std::vector<VolumeId> label =
          label_vertices(touched, other, m.contacts, operand, *m.tables, m.context);
      ASSERT_EQ(label.size(), own.vertex_count());
      const SpaceLocator locator(other);
      for (std::uint32_t v = 0; v < own.vertex_count(); ++v) {
        const SpaceItem there = locator.locate(exact(own.points(), own.vertex_point[v]));
        const bool is_touched = there.kind() != SpaceItem::Kind::Volume;
        EXPECT_EQ(touched.is_touched(VertexId(v)), is_touched);
        EXPECT_EQ(label[v].is_valid(), !is_touched);
        if (is_touched) {
          ++touched_count;
          continue;
        }
        EXPECT_EQ(label[v], there.volume()) << "vertex " << v;
        ++(label[v] == VolumeId(0) ? outside : inside);
      }
    }
  }
  EXPECT_GT(touched_count, 60U);
  EXPECT_GT(outside, 60U);
  EXPECT_GT(inside, 30U);
}

TEST(VertexLabels, OfNothingAreVolume0) {
  Dice dice(1);
  SpaceComplex a = random_operand(dice), b = testing::complex_of({});
  const auto tables = unite_tables(a, b);
  Context context;
  const TouchedComplex touched(a, {}, 0);
  for (const VolumeId v : label_vertices(touched, b, {}, 0, *tables, context)) {
    EXPECT_EQ(v, VolumeId(0));
  }
}

// ---------------------------------------------------------------- carriers

/// The volumes inside a mesh and all of their boundary are marked.
SpaceComplex solid_complex(const PolygonMesh& mesh) {
  Context context;
  MeshComplex made = complex_of_mesh(mesh, {}, context);
  SpaceComplex& c = made.complex;
  label_volumes(c, context);
  const std::vector<std::int32_t> winding = winding_numbers(c, made.jump);
  for (std::size_t v = 0; v < winding.size(); ++v) c.volume_mark[v] = winding[v] > 0 ? 1 : 0;
  for (auto* marks :
       std::initializer_list<std::vector<Mark>*>{&c.vertex_mark, &c.edge_mark, &c.facet_mark}) {
    marks->assign(marks->size(), 1);
  }
  return std::move(c);
}

/// Two edge uses at each of its edges, and inside no facet: by counting.
bool has_pairs_of_uses(const SpaceComplex& c, VertexId v) {
  if (c.star_of(v).empty() || c.vertex_facet[v.value()].is_valid()) return false;
  return std::ranges::all_of(c.star_of(v), [&](HalfedgeId h) {
    return std::ranges::count_if(c.use_halfedge, [&](HalfedgeId g) {
             return SpaceComplex::edge_of(g) == SpaceComplex::edge_of(h);
           }) == 2;
  });
}

TEST(VertexCarrier, RingsAreWhatSphereMapsSay) {
  std::size_t rings = 0, several = 0, others = 0;
  for (std::uint64_t seed = 0; seed < 5; ++seed) {
    SCOPED_TRACE(seed);
    Dice dice(seed);
    const PolygonMesh voxels = voxel_mesh(testing::random_voxels(dice, {3, 3, 3}, 4));
    const SpaceComplex c = solid_complex(voxels);
    const auto tables = copy(*c.tables);
    SphereOverlay overlay(tables->planes);
    SpaceDraft one_by_one(tables), at_once(tables);
    VertexCarrier maps(c, one_by_one, overlay), direct(c, at_once, overlay);
    LocalMap local;
    for (std::uint32_t v = 0; v < c.vertex_count(); ++v) {
      EXPECT_EQ(direct.may_have_ring(VertexId(v)), has_pairs_of_uses(c, VertexId(v)));
      if (!direct.may_have_ring(VertexId(v))) {
        ++others;
        continue;
      }
      const std::vector<VertexCarrier::Remarked> list = {{VertexId(v), {1, 0, kBeyond}}};
      const std::size_t added = direct.add_rings(list);
      local_map(c, VertexId(v), local);
      EXPECT_EQ(added == 1, local.map.face_count() == 2);
      ++(added == 1 ? rings : several);
      if (added == 0) continue;
      local.map.centre_mark ^= 1U;
      for (auto* marks : {&local.map.point_mark, &local.map.arc_mark, &local.map.face_mark}) {
        for (Mark& m : *marks) m ^= 1U;
      }
      maps.add(VertexId(v), local);
    }
    EXPECT_EQ(at_once.maps.direction, one_by_one.maps.direction);
    EXPECT_EQ(at_once.maps.point_mark, one_by_one.maps.point_mark);
    EXPECT_EQ(at_once.maps.first_out, one_by_one.maps.first_out);
    EXPECT_EQ(at_once.maps.circle, one_by_one.maps.circle);
    EXPECT_EQ(at_once.maps.arc_mark, one_by_one.maps.arc_mark);
    EXPECT_EQ(at_once.maps.origin, one_by_one.maps.origin);
    EXPECT_EQ(at_once.maps.next, one_by_one.maps.next);
    EXPECT_EQ(at_once.maps.face, one_by_one.maps.face);
    EXPECT_EQ(at_once.maps.face_mark, one_by_one.maps.face_mark);
    EXPECT_EQ(at_once.vertex_point, one_by_one.vertex_point);
    EXPECT_EQ(at_once.vertex_mark, one_by_one.vertex_mark);
    EXPECT_EQ(at_once.vertex_of_point, one_by_one.vertex_of_point);
    EXPECT_EQ(at_once.arc_origin, one_by_one.arc_origin);
    EXPECT_EQ(direct.point_of(), maps.point_of());
  }
  EXPECT_GT(rings, 50U);
  EXPECT_GT(several, 0U);
  EXPECT_GT(others, 5U);
}

/// A cube of many triangles: vertices within its sides dissolve, those within its edges become
/// places there, and what is joined is a cube.
TEST(VertexCarrier, SimplifiedVerticesMakeAMinimalComplex) {
  Context context;
  const SpaceComplex c = solid_complex(testing::grid_cube_mesh(3, {0, 0, 0}));
  const auto tables = copy(*c.tables);
  SphereOverlay overlay(tables->planes);
  SpaceDraft forgotten(tables), draft(tables);
  VertexCarrier carrier(c, forgotten, overlay);
  LocalMap local;
  for (int round = 0; round < 2; ++round) {
    carrier.start(round == 0 ? forgotten : draft);
    EXPECT_TRUE(
        std::ranges::all_of(carrier.point_of(), [](std::uint32_t p) { return p == kNone; }));
    for (std::uint32_t v = 0; v < c.vertex_count(); ++v) {
      local_map(c, VertexId(v), local);
      carrier.add_simplified(VertexId(v), local);
    }
  }
  carrier.face_ends();
  EXPECT_EQ(draft.vertex_count(), 8U + 12U * 2U);
  const SpaceComplex joined = assemble(std::move(draft), context);
  EXPECT_FALSE(audit(joined, AuditForm::Minimal));
  EXPECT_EQ(joined.vertex_count(), 8U);
  EXPECT_EQ(joined.edge_count(), 12U);
  EXPECT_EQ(joined.facet_count(), 6U);
  EXPECT_EQ(joined.volume_mark, (std::vector<Mark>{0, 1}));
}

}  // namespace
}  // namespace plumb::vertex_labels_test
