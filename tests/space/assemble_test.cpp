// Complexes taken apart into the sphere maps of their vertices and joined again are what they were:
// compared item by item at points of all items.
#include "plumb/space/boolean/assemble.h"

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <vector>

#include "generate/space_scenes.h"
#include "plumb/predicates/point3_signs.h"
#include "plumb/space/local_maps.h"
#include "plumb/space/planar/facet_triangles.h"
#include "plumb/space/space_audit.h"
#include "plumb/space/space_locator.h"

namespace plumb::assemble_test {
namespace {

using testing::Dice;
using testing::SpaceScene;
using testing::operator+;
using testing::operator*;

/// A complex with random marks.
SpaceComplex marked(const SpaceScene& scene, Dice& dice) {
  SpaceComplex c = testing::complex_of(scene);
  for (auto* marks : std::initializer_list<std::vector<Mark>*>{&c.vertex_mark, &c.edge_mark,
                                                               &c.facet_mark, &c.volume_mark}) {
    for (Mark& m : *marks) m = static_cast<Mark>(dice.below(2));
  }
  return c;
}

/// Takes vertices of a complex apart; the points of half-edges are remembered.
struct Pieces {
  explicit Pieces(const SpaceComplex& given, std::shared_ptr<SpaceTables> tables)
      : complex(given), draft(std::move(tables)), point_of(given.origin.size(), kNone) {}

  std::uint32_t add(SpaceItem item, SpacePoint at, bool passed) {
    local_map(complex, item, local);
    std::vector<std::uint32_t> origins;
    for (const FacetId f : local.facet) origins.push_back(complex.facet_origin[f.value()]);
    return draft.add(at, local.map, passed, origins).point;
  }
  void add(VertexId v) {
    const std::uint32_t first = add(v, complex.vertex_point[v.value()], false);
    for (std::uint32_t i = 0; i < local.halfedge.size(); ++i) {
      point_of[local.halfedge[i].value()] = first + i;
    }
  }
  void face(std::uint32_t p, std::uint32_t q) {
    draft.twin[p] = q;
    draft.twin[q] = p;
  }
  void face_ends() {
    for (std::uint32_t h = 0; h < point_of.size(); h += 2) {
      if (point_of[h] != kNone) face(point_of[h], point_of[h + 1]);
    }
  }

  const SpaceComplex& complex;
  SpaceDraft draft;
  std::vector<std::uint32_t> point_of;
  LocalMap local;
};

/// The items of both are the same, with their marks, origins and volumes.
class SameCheck {
 public:
  SameCheck(const SpaceComplex& a, const SpaceComplex& b) : a_(a), b_(b), locator_(b) {}

  void run() {
    const auto flaw = audit(b_, AuditForm::Any);
    ASSERT_FALSE(flaw) << flaw->invariant << " at " << flaw->place;
    EXPECT_EQ(a_.vertex_count(), b_.vertex_count());
    EXPECT_EQ(a_.edge_count(), b_.edge_count());
    EXPECT_EQ(a_.use_count(), b_.use_count());
    EXPECT_EQ(a_.facet_count(), b_.facet_count());
    EXPECT_EQ(a_.volume_count(), b_.volume_count());
    std::vector<RationalPoint3> at;
    for (const SpacePoint p : a_.vertex_point) at.push_back(exact(a_.points(), p));
    for (std::uint32_t v = 0; v < at.size(); ++v) {
      const SpaceItem w = found(VertexId(v), at[v]);
      EXPECT_EQ(a_.vertex_mark[v], b_.vertex_mark[w.index()]);
      same_volume(a_.vertex_volume[v], b_.vertex_volume[w.index()]);
    }
    for (std::uint32_t e = 0; e < a_.edge_count(); ++e) {
      const RationalPoint3 ends = at[a_.origin[2 * e].value()] + at[a_.origin[2 * e + 1].value()];
      const SpaceItem g = found(EdgeId(e), Rational(1, 2) * ends);
      EXPECT_EQ(a_.edge_mark[e], b_.edge_mark[g.index()]);
      same_volume(a_.edge_volume[e], b_.edge_volume[g.index()]);
    }
    FacetTriangles triangles(a_);
    for (std::uint32_t f = 0; f < a_.facet_count(); ++f) {
      RationalPoint3 inside{0, 0, 0};
      triangles.for_each(FacetId(f), [&](VertexId i, VertexId j, VertexId k) {
        inside = Rational(1, 3) * (at[i.value()] + at[j.value()] + at[k.value()]);
      });
      const SpaceItem g = found(FacetId(f), inside);
      EXPECT_EQ(a_.facet_mark[f], b_.facet_mark[g.index()]);
      EXPECT_EQ(a_.facet_origin[f], b_.facet_origin[g.index()]);
      EXPECT_EQ(a_.cycles_of(FacetId(f)).size(), b_.cycles_of(g.facet()).size());
      EXPECT_EQ(a_.inner_of(FacetId(f)).size(), b_.inner_of(g.facet()).size());
      for (const std::size_t side : {0U, 1U}) {
        same_volume(a_.facet_volume[f][side], b_.facet_volume[g.index()][side]);
      }
    }
  }

 private:
  SpaceItem found(SpaceItem item, const RationalPoint3& at) const {
    const SpaceItem there = locator_.on_item(at);
    EXPECT_TRUE(there.is_valid() && there.kind() == item.kind()) << item.code();
    return there.is_valid() && there.kind() == item.kind() ? there : item;
  }
  void same_volume(VolumeId v, VolumeId w) {
    ASSERT_EQ(v.is_valid(), w.is_valid());
    if (!v.is_valid()) return;
    EXPECT_EQ(volume_.try_emplace(v, w).first->second, w);
    EXPECT_EQ(a_.volume_mark[v.value()], b_.volume_mark[w.value()]);
  }

  const SpaceComplex& a_;
  const SpaceComplex& b_;
  SpaceLocator locator_;
  std::map<VolumeId, VolumeId> volume_;
};

void expect_same(const SpaceComplex& a, const SpaceComplex& b) { SameCheck(a, b).run(); }

SpaceScene difficult_scene() {
  SpaceScene scene;
  testing::add_box(scene, {0, 0, 0}, {1, 1, 1});
  testing::add_box(scene, {1, 1, 0}, {2, 2, 1});  // four facets at an edge
  testing::add_box(scene, {2, 2, 1}, {3, 3, 2});  // two rings at a vertex
  testing::add_frame_box(scene, {6, 0, 0}, {9, 3, 2});
  scene.add_facet({{0, 0, 5}, {6, 0, 5}, {6, 6, 5}, {0, 6, 5}});
  scene.facets.back().inner = {scene.add_point({2, 2, 5}), scene.add_point({4, 4, 5})};
  scene.add_free_edge({2, 2, 5}, {2, 2, 7});
  scene.add_facet({{0, 8, 5}, {6, 8, 5}, {6, 9, 5}, {0, 9, 5}});  // another one in that plane
  scene.add_point({9, 9, 9});
  return scene;
}

TEST(Assemble, NothingIsOneVolume) {
  const auto tables = std::make_shared<SpaceTables>();
  Context context;
  const SpaceComplex c = assemble(SpaceDraft(tables), context);
  EXPECT_EQ(c.volume_mark, std::vector<Mark>{0});
  EXPECT_EQ(c.vertex_count() + c.edge_count() + c.facet_count(), 0U);
  EXPECT_FALSE(audit(c, AuditForm::Minimal));
}

TEST(Assemble, JoinsWhatWasTakenApart) {
  Context context;
  for (std::uint64_t seed = 0; seed < 12; ++seed) {
    SCOPED_TRACE(seed);
    Dice dice(seed);
    const SpaceComplex c =
        marked(seed == 0 ? difficult_scene() : testing::random_scene(dice), dice);
    Pieces pieces(c, copy(*c.tables));
    // From the last vertex to the first, so that no number is kept by chance.
    for (std::size_t v = c.vertex_count(); v-- > 0;) pieces.add(VertexId(v));
    pieces.face_ends();
    expect_same(c, assemble(std::move(pieces.draft), context));
  }
}

/// Every edge is cut at places that are no vertices.
TEST(Assemble, PlacesInsideEdgesAreSpliced) {
  Context context;
  Dice dice(7);
  const SpaceComplex c = marked(difficult_scene(), dice);
  const auto tables = copy(*c.tables);
  Pieces pieces(c, tables);
  for (std::uint32_t v = 0; v < c.vertex_count(); ++v) pieces.add(VertexId(v));
  for (std::uint32_t e = 0; e < c.edge_count(); ++e) {
    std::uint32_t open = pieces.point_of[2 * e];
    for (std::uint32_t i = 0; i < e % 3; ++i) {
      const std::uint32_t forward = pieces.add(EdgeId(e), c.vertex_point[0], true);
      pieces.face(open, forward + 1);
      open = forward;
    }
    pieces.face(open, pieces.point_of[2 * e + 1]);
  }
  expect_same(c, assemble(std::move(pieces.draft), context));
}

TEST(Assemble, DraftsAreAppendedAndCutBack) {
  Context context;
  Dice dice(8);
  SpaceScene scene;
  testing::add_box(scene, {0, 0, 0}, {1, 1, 1});
  for (int i = 0; i < 20; ++i) scene.add_point({-1, i, 0});
  testing::add_frame_box(scene, {6, 0, 0}, {9, 3, 2});
  scene.add_free_edge({6, 9, 0}, {9, 9, 0});
  const SpaceComplex c = marked(scene, dice);
  const auto tables = copy(*c.tables);
  for (const std::size_t cut : {8U, 28U}) {
    Pieces first(c, tables), second(c, tables);
    for (std::uint32_t v = 0; v < c.vertex_count(); ++v) {
      (v < cut ? first : second).add(VertexId(v));
    }
    first.face_ends();
    second.face_ends();
    const SpaceDraft::Offsets end = first.draft.end();
    first.add(EdgeId(0), c.vertex_point[0], true);  // and drop it again
    first.draft.resize(cut, end.point, end.arc, end.face);
    first.draft.reserve_more(c.vertex_count(), 1, 2, 3);
    const std::array<SpaceDraft*, 1> more{&second.draft};
    Context threads({}, {}, {}, cut == 8 ? 1 : 3);
    first.draft.take_all(more, threads);
    EXPECT_EQ(second.draft.vertex_count(), 0U);
    expect_same(c, assemble(std::move(first.draft), context));
  }
}

}  // namespace
}  // namespace plumb::assemble_test
