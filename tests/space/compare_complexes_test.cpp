// One set from items in many orders: it stays the same set with one canonical order, and one other
// mark or place makes it another one.
#include "plumb/space/set/compare_complexes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <tuple>
#include <vector>

#include "generate/space_scenes.h"
#include "plumb/predicates/point3_signs.h"
#include "plumb/testing/dice.h"

namespace plumb::compare_complexes_test {

using testing::Dice;
using testing::rational_point;
using testing::SpaceScene;

/// A box, a sheet with a hole, an edge and a vertex alone.
SpaceScene scene(int height = 9) {
  SpaceScene s;
  testing::add_box(s, rational_point(0, 0, 0), rational_point(4, 5, 6));
  s.add_facet({rational_point(8, 0, 0), rational_point(8, 6, 0), rational_point(8, 6, 6),
               rational_point(8, 0, 6)},
              {{rational_point(8, 2, 2), rational_point(8, 2, 4), rational_point(8, 4, 4),
                rational_point(8, 4, 2)}});
  s.add_free_edge(rational_point(4, 5, 6), rational_point(5, 7, height));
  s.add_point(rational_point(20, 2, 2));
  return s;
}

/// All of the boundary marked, and the volumes not: no item can go.
SpaceComplex marked(const SpaceScene& s) {
  SpaceComplex c = testing::complex_of(s);
  c.vertex_mark.assign(c.vertex_count(), 1);
  c.edge_mark.assign(c.edge_count(), 1);
  c.facet_mark.assign(c.facet_count(), 1);
  return c;
}

template <class T>
void shuffle(std::vector<T>& list, Dice& dice) {
  for (std::size_t i = list.size(); i > 1; --i) std::swap(list[i - 1], list[dice.below(i)]);
}

SpaceScene shuffled(const SpaceScene& s, Dice& dice) {
  std::vector<std::uint32_t> old, number(s.points.size());
  for (std::uint32_t i = 0; i < s.points.size(); ++i) old.push_back(i);
  shuffle(old, dice);
  SpaceScene result = s;
  for (std::uint32_t i = 0; i < old.size(); ++i) {
    number[old[i]] = i;
    result.points[i] = s.points[old[i]];
  }
  for (testing::SceneFacet& f : result.facets) {
    const bool is_reversed = dice.below(2) == 0;
    for (auto& cycle : f.cycles) {
      for (std::uint32_t& v : cycle) v = number[v];
      if (is_reversed) std::ranges::reverse(cycle);
      std::rotate(cycle.begin(), cycle.begin() + dice.below(cycle.size()), cycle.end());
    }
  }
  for (auto& [a, b] : result.free_edges) {
    a = number[a];
    b = number[b];
    if (dice.below(2) == 0) std::swap(a, b);
  }
  shuffle(result.facets, dice);
  return result;
}

RationalPoint3 place(const SpaceComplex& c, VertexId v) {
  return exact(c.points(), c.vertex_point[v.value()]);
}

TEST(CompareComplexes, OrdersDoNotMatter) {
  Dice dice(91);
  const SpaceComplex c = marked(scene());
  EXPECT_TRUE(is_same(c, c));
  EXPECT_TRUE(is_identical(c, marked(scene())));
  for (int round = 0; round < 20; ++round) {
    const SpaceComplex d = marked(shuffled(scene(), dice));
    EXPECT_TRUE(is_same(c, d) && is_same(d, c));
    EXPECT_FALSE(is_identical(c, d));
  }
}

TEST(CompareComplexes, OneMarkOrPlaceMakesAnotherSet) {
  Dice dice(92);
  const SpaceComplex c = marked(scene());
  const SpaceComplex other = marked(scene(8));
  EXPECT_FALSE(is_same(c, other) || is_identical(c, other));
  for (std::size_t which = 0; which < 4; ++which) {
    SpaceComplex d = c, e = marked(shuffled(scene(), dice));
    // A mark that may change without making any item of the complex superfluous.
    const auto change = [which](SpaceComplex& x) {
      const auto free_edge = static_cast<std::size_t>(
          std::ranges::find_if(x.edge_use, [](UseId u) { return !u.is_valid(); }) -
          x.edge_use.begin());
      const auto of_sheet = static_cast<std::size_t>(
          std::ranges::find_if(x.facet_volume, [](const auto& v) { return v[0] == v[1]; }) -
          x.facet_volume.begin());
      const UseId u = x.cycles_of(FacetId(of_sheet))[0];
      if (which == 0) x.volume_mark[1] = 1;
      if (which == 1) x.edge_mark[x.use_halfedge[u.value()].value() / 2] = 0;
      if (which == 2) x.vertex_mark[x.use_origin(u).value()] = 0;
      if (which == 3) x.vertex_mark[x.origin[2 * free_edge].value()] = 0;
    };
    change(d);
    EXPECT_FALSE(is_same(c, d)) << which;
    EXPECT_FALSE(is_same(d, e)) << which;
    EXPECT_FALSE(is_identical(c, d)) << which;
    SpaceComplex same = c;
    change(same);
    EXPECT_TRUE(is_same(d, same) && is_identical(d, same)) << which;
  }
}

// Ids and numbers undo each other, and places in the new order are those of any other order.
TEST(CompareComplexes, CanonicalOrderFollowsFromTheSet) {
  Dice dice(93);
  Context context;
  using Ends = std::tuple<std::uint32_t, std::uint32_t>;
  std::vector<RationalPoint3> places;
  std::vector<Ends> ends;
  for (int round = 0; round < 10; ++round) {
    const SpaceComplex c = marked(shuffled(scene(), dice));
    const CanonicalOrder order = canonical_order(c, context);
    const auto expect_permutation = [](const auto& of, std::size_t count) {
      ASSERT_EQ(of.ids().size(), count);
      for (std::size_t i = 0; i < count; ++i) EXPECT_EQ(of(of.ids()[i]).value(), i);
    };
    expect_permutation(order.vertices, c.vertex_count());
    expect_permutation(order.edges, c.edge_count());
    expect_permutation(order.facets, c.facet_count());
    expect_permutation(order.uses, c.use_count());
    expect_permutation(order.volumes, c.volume_count());
    EXPECT_EQ(order.cycles.size(), c.cycle.size());
    std::vector<RationalPoint3> found;
    for (const VertexId v : order.vertices.ids()) found.push_back(place(c, v));
    std::vector<Ends> found_ends;
    for (const EdgeId e : order.edges.ids()) {
      const HalfedgeId h(2 * std::size_t{e.value()});
      const std::uint32_t a = order.vertices(c.origin[h.value()]).value();
      const std::uint32_t b = order.vertices(c.target(h)).value();
      EXPECT_EQ(order.is_turned(c, e), a > b);
      EXPECT_EQ(order.halfedge(c, h).value(), 2 * order.edges(e).value() + (a > b ? 1U : 0U));
      found_ends.emplace_back(std::min(a, b), std::max(a, b));
    }
    if (round > 0) {
      EXPECT_EQ(found, places);
      EXPECT_EQ(found_ends, ends);
    }
    places = found;
    ends = found_ends;
  }
}

}  // namespace plumb::compare_complexes_test
