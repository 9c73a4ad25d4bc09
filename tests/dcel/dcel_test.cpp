// Dcel::from_cycles: what was listed is what is read back.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "fixtures.h"
#include "plumb/predicates/error.h"
namespace plumb::test::dcel_test {
namespace {
std::string told(const std::optional<DcelFlaw>& flaw) {
  return flaw ? flaw->invariant + " at " + flaw->place : "";
}
/// Every corner position keeps its directed edge, cycle, successor and twin.
void expect_same_as_listed(const Listing& g, const DcelFromCycles& built) {
  const Dcel& d = built.dcel;
  const auto twins = g.twins();
  const auto& at = built.halfedge_of_corner;
  for (std::uint32_t c = 0; c < g.face_of_cycle.size(); ++c) {
    EXPECT_EQ(d.face(LoopId(c)).value(), g.face_of_cycle[c]);
    for (std::uint32_t p = g.cycle_begin[c]; p < g.cycle_begin[c + 1]; ++p) {
      const HalfedgeId h = at[p];
      EXPECT_EQ(d.origin(h).value(), g.corners[p]);
      EXPECT_EQ(d.target(h).value(), g.next_corner(c, p));
      EXPECT_EQ(d.loop(h), LoopId(c));
      EXPECT_EQ(d.next(h), at[p + 1 < g.cycle_begin[c + 1] ? p + 1 : g.cycle_begin[c]]);
      EXPECT_EQ(twin(h), at[twins[p]]);
    }
    EXPECT_EQ(d.first(LoopId(c)), Corner(at[g.cycle_begin[c]]));
  }
}
TEST(DcelBuild, KeepsWhatIsListed) {
  for (const Listing& g : {grid(1), grid(2), grid(7), pinched(), nested()}) {
    const auto built = g.build();
    EXPECT_EQ(told(built.dcel.audit()), "");
    EXPECT_EQ(told(built.dcel.audit_planar()), "");
    expect_same_as_listed(g, built);
  }
}
TEST(DcelBuild, NumbersEdgesByFirstUse) {
  const Listing g = grid(5);
  const auto built = g.build();
  std::uint32_t edges = 0;
  for (const HalfedgeId h : built.halfedge_of_corner) {
    if (edge_of(h).value() < edges) continue;
    EXPECT_EQ(h, first_half(EdgeId(edges)));
    ++edges;
  }
  EXPECT_EQ(edges, built.dcel.edge_count());
}
TEST(DcelBuild, FirstHalfedgeOfAVertexIsItsFirstCorner) {
  const Listing g = grid(4);
  const auto built = g.build();
  for (std::uint32_t v = 0; v < g.vertices; ++v) {
    const auto p = std::find(g.corners.begin(), g.corners.end(), v) - g.corners.begin();
    EXPECT_EQ(built.dcel.halfedge(VertexId(v)),
              built.halfedge_of_corner[static_cast<std::size_t>(p)]);
  }
}
TEST(DcelBuild, WalksAroundVerticesAlongLoopsAndThroughFaces) {
  const auto built = grid(2).build();
  const Dcel& d = built.dcel;
  std::vector<std::uint32_t> neighbours;  // of the middle, counter-clockwise
  for (const HalfedgeId h : d.around(VertexId(4))) neighbours.push_back(d.target(h).value());
  const auto east = std::find(neighbours.begin(), neighbours.end(), 5U);
  ASSERT_NE(east, neighbours.end());
  std::rotate(neighbours.begin(), east, neighbours.end());
  EXPECT_EQ(neighbours, (std::vector<std::uint32_t>{5, 7, 3, 1}));
  for (const HalfedgeId h : d.around(VertexId(4))) EXPECT_EQ(d.turn_right(d.turn_left(h)), h);
  std::vector<std::uint32_t> square;
  for (const HalfedgeId h : d.along(LoopId(1))) square.push_back(d.origin(h).value());
  EXPECT_EQ(square, (std::vector<std::uint32_t>{0, 1, 4, 3}));
  const auto tree = nested().build();
  std::vector<LoopId> loops;
  for (const LoopId l : tree.dcel.loops_of(FaceId(3))) loops.push_back(l);
  EXPECT_EQ(loops, (std::vector<LoopId>{LoopId(5), LoopId(7)}));
}
TEST(DcelBuild, KeepsIsolatedVerticesAndHoles) {
  const auto built = nested().build();
  const Dcel& d = built.dcel;
  EXPECT_TRUE(d.is_isolated(VertexId(9)));
  EXPECT_FALSE(d.halfedge(VertexId(9)).is_valid());
  EXPECT_EQ(d.face(d.isolated_loop(VertexId(10))), FaceId(3));
  EXPECT_EQ(d.vertex_at(d.first(d.isolated_loop(VertexId(10)))), VertexId(10));
  for ([[maybe_unused]] const HalfedgeId h : d.along(d.isolated_loop(VertexId(9)))) ADD_FAILURE();
  for ([[maybe_unused]] const HalfedgeId h : d.around(VertexId(9))) ADD_FAILURE();
  EXPECT_FALSE(d.contains(VertexId(11)));
  EXPECT_EQ(d.vertex_count(), 11U);
  EXPECT_EQ(d.vertex_slots(), 12U);
}
TEST(DcelBuild, NoticesPinches) {
  EXPECT_TRUE(pinched().build().dcel.has_pinches());
  EXPECT_FALSE(nested().build().dcel.has_pinches());
  Listing passing = pinched();  // one outer cycle through the vertex twice: no pinch
  passing.corners.clear();
  passing.cycle_begin = {0};
  passing.face_of_cycle.clear();
  passing.add({0, 1, 2}, 1);
  passing.add({0, 3, 4}, 2);
  passing.add({0, 2, 1, 0, 4, 3}, 0);
  EXPECT_FALSE(passing.build().dcel.has_pinches());
  EXPECT_EQ(told(passing.build().dcel.audit_planar()), "");
}
TEST(DcelBuild, EmptyListing) {
  const auto built = Listing{}.build();
  EXPECT_EQ(told(built.dcel.audit()), "");
  EXPECT_EQ(built.dcel.face_count(), 0U);
}
TEST(DcelBuildDeathTest, RefusesTwinsThatAreNone) {
  const Listing g = grid(2);
  auto build = [&g](std::vector<std::uint32_t> twin) {
    Dcel::from_cycles(g.vertices, g.corners, g.cycle_begin, twin, g.face_of_cycle);
  };
  auto self = g.twins();
  self[3] = 3;
  EXPECT_THROW(build(self), BrokenInvariant);
  auto swapped = g.twins();
  std::swap(swapped[0], swapped[1]);
  EXPECT_THROW(build(swapped), BrokenInvariant);
  auto crossed = g.twins();  // an involution still, but joining edges of other vertices
  std::swap(crossed[0], crossed[1]);
  crossed[crossed[0]] = 0;
  crossed[crossed[1]] = 1;
  EXPECT_THROW(build(crossed), BrokenInvariant);
}
}  // namespace
}  // namespace plumb::test::dcel_test
