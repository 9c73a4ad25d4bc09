// Faces of sets of the plane copied into regions of their own: which corners are reflex and what
// leads into them, against the point set itself and orientations in small integers.
#include "plumb/convex/region/plane_region.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <vector>

#include "plumb/plane/nef2.h"
#include "plumb/predicates/rational_predicates.h"

namespace plumb::plane_region_test {

using Points = std::vector<Point2>;

Nef2 polygon(const Points& points, Boundary boundary = Boundary::Closed) {
  return Nef2::polygon(points, boundary);
}
Nef2 square() { return polygon({{0, 0}, {4, 0}, {4, 4}, {0, 4}}); }

/// Of the only marked face.
PlaneRegion region_of(const Nef2& set) {
  RegionMaker maker(set.complex());
  for (std::uint32_t f = 0; f < set.complex().face_count(); ++f) {
    if (set.complex().mark(FaceId(f))) return maker.region(FaceId(f));
  }
  return {};
}

RationalPoint2 at(const PlaneRegion& r, VertexId v) { return exact(r.points, r.point(v)); }

std::vector<HalfedgeId> inner_halves(const PlaneRegion& r) {
  std::vector<HalfedgeId> all;
  for (std::uint32_t i = 0; i < r.halfedge_count(); ++i) {
    if (r.is_inside(HalfedgeId(i))) all.emplace_back(i);
  }
  return all;
}

/// Every inner half-edge has one after it that starts at its end, and comes after one.
void expect_linked(const PlaneRegion& r) {
  for (const HalfedgeId h : inner_halves(r)) {
    EXPECT_EQ(r.start(r.after(h)), r.target(h));
    EXPECT_EQ(r.before(r.after(h)), h);
  }
}

/// With slits, a hole that touches the boundary, and a flat corner where a point is missing.
std::vector<Nef2> bounded_sets() {
  const Nef2 slit = Nef2::polyline(Points{{0, 0}, {2, 1}});
  return {polygon({{0, 0}, {4, 0}, {4, 1}, {1, 1}, {1, 4}, {0, 4}}),
          polygon({{0, 0}, {2, 0}, {4, 0}, {2, 1}, {0, 4}, {0, 2}}),
          square() - slit,
          square() - polygon({{1, 1}, {3, 1}, {2, 3}}),
          square() - polygon({{0, 0}, {2, 1}, {1, 2}}, Boundary::Open),
          square() - Nef2::polyline(Points{{1, 2}, {3, 2}}) - Nef2::point({1, 1}),
          square() - Nef2::point({2, 0})};
}

TEST(PlaneRegion, ReflexCornersTurnRight) {
  const std::vector<std::size_t> reflex = {1, 1, 1, 3, 2, 3, 0};
  const std::vector<std::size_t> loops = {1, 1, 1, 2, 1, 3, 1};
  const std::vector<Nef2> sets = bounded_sets();
  for (std::size_t i = 0; i < sets.size(); ++i) {
    SCOPED_TRACE(i);
    const PlaneRegion r = region_of(sets[i]);
    EXPECT_TRUE(r.is_bounded());
    expect_linked(r);
    EXPECT_EQ(r.loops.size(), loops[i]);
    EXPECT_EQ(r.count_reflex_corners(), reflex[i]);
    for (const HalfedgeId h : inner_halves(r)) {
      const HalfedgeId before = r.before(h);
      const Sign turn = orient2d(at(r, r.start(before)), at(r, r.start(h)), at(r, r.target(h)));
      const bool is_end = before == twin(h);  // of a slit
      EXPECT_EQ(r.is_reflex(h), is_end || turn == Sign::Negative);
    }
  }
}

/// A step from the corner that way is inside; along a side it is on the boundary.
TEST(PlaneRegion, WhatLeadsIntoACornerLeadsInside) {
  std::size_t into = 0, others = 0;
  for (const Nef2& set : bounded_sets()) {
    const PlaneRegion r = region_of(set);
    const Nef2 inside = set.interior();
    for (const HalfedgeId h : inner_halves(r)) {
      const RationalPoint2 from = at(r, r.start(h));
      // Where several corners share a vertex, a step does not tell them apart.
      const auto halves = inner_halves(r);
      if (std::ranges::count_if(halves, [&](HalfedgeId k) { return r.start(k) == r.start(h); }) > 1)
        continue;
      for (const HalfedgeId other : halves) {
        for (const Heading x : {r.heading(other), r.heading(other).reversed()}) {
          RationalPoint2 a = r.points.inputs.exact(x.line.a), b = r.points.inputs.exact(x.line.b);
          if (x.back) std::swap(a, b);
          const RationalPoint2 step{from.x + (b.x - a.x) / 1000, from.y + (b.y - a.y) / 1000};
          EXPECT_EQ(r.leads_into(h, x), inside.contains(step));
          ++(r.leads_into(h, x) ? into : others);
        }
      }
    }
  }
  EXPECT_GT(into, 20U);
  EXPECT_GT(others, 20U);
}

/// Against coordinates; a heading reversed flips all of them.
TEST(PlaneRegion, HeadingsHaveSidesAndAnOrder) {
  const PlaneRegion r = region_of(bounded_sets()[1]);
  for (std::uint32_t a = 0; a < r.vertex_count(); ++a) {
    for (std::uint32_t b = 0; b < r.vertex_count(); ++b) {
      if (a == b) continue;
      const Heading x = r.from_to(VertexId(a), VertexId(b));
      EXPECT_EQ(compare_xy(r.points, x.line.a, x.line.b), Sign::Negative);
      const RationalPoint2 p = at(r, VertexId(a)), q = at(r, VertexId(b));
      EXPECT_EQ(r.ahead(x, r.point(VertexId(b)), r.point(VertexId(a))), Sign::Positive);
      for (std::uint32_t c = 0; c < r.vertex_count(); ++c) {
        const Sign side = orient2d(p, q, at(r, VertexId(c)));
        EXPECT_EQ(r.side(x, r.point(VertexId(c))), side);
        EXPECT_EQ(r.side(x.reversed(), r.point(VertexId(c))), -side);
        if (c == a) continue;
        const Heading y = r.from_to(VertexId(a), VertexId(c));
        EXPECT_EQ(r.cross(x, y), side);
        EXPECT_EQ(r.cross(x, y.reversed()), -side);
      }
    }
  }
}

/// A cut parts a loop, and without it the region is what it was.
TEST(PlaneRegion, CutsAreTakenAwayAgain) {
  const PlaneRegion before = region_of(polygon({{0, 0}, {4, 0}, {4, 4}, {0, 4}}));
  const std::vector<HalfedgeId> halves = inner_halves(before);
  for (const HalfedgeId from : halves) {
    const HalfedgeId to = before.after(before.after(from));
    PlaneRegion r = before;
    const HalfedgeId cut = r.add_edge(from, to, r.from_to(r.start(from), r.start(to)));
    EXPECT_EQ(r.start(cut), before.start(from));
    EXPECT_EQ(r.target(cut), before.start(to));
    EXPECT_EQ(r.count_loops(), 2U);
    expect_linked(r);
    EXPECT_EQ(r.heading(cut).back, compare_xy(r.points, r.point(r.start(cut)),
                                              r.point(r.target(cut))) == Sign::Positive);
    r.remove_edge(cut);
    EXPECT_EQ(r.count_loops(), 1U);
    for (const HalfedgeId h : halves) EXPECT_EQ(r.after(h), before.after(h));
    EXPECT_EQ(inner_halves(r), halves);
  }
}

/// Of an edge with the region on one side, and of a slit with it on both.
TEST(PlaneRegion, ASplitEdgeGoesThroughItsVertex) {
  for (const Nef2& set : {square(), square() - Nef2::polyline(Points{{1, 2}, {3, 2}})}) {
    const PlaneRegion before = region_of(set);
    for (const HalfedgeId h : inner_halves(before)) {
      PlaneRegion r = before;
      const VertexId v = r.add_vertex(r.point(r.start(h)), false), to = r.target(h);
      const HalfedgeId on = r.split_edge(h, v);
      EXPECT_EQ(r.after(h), on);
      EXPECT_EQ(r.start(on), v);
      EXPECT_EQ(r.target(h), v);
      EXPECT_EQ(r.target(on), to);
      EXPECT_EQ(r.heading(on).back, r.heading(h).back);
      expect_linked(r);
      EXPECT_EQ(r.count_loops(), before.count_loops());
      EXPECT_EQ(inner_halves(r).size(),
                inner_halves(before).size() + (before.is_inside(twin(h)) ? 2 : 1));
    }
  }
}

TEST(PlaneRegion, AtInfinityNoCornerIsReflex) {
  const Nef2 half = Nef2::half_plane({{0, 0}, {1, 3}}, Boundary::Open);
  EXPECT_FALSE(region_of(half).is_bounded());
  EXPECT_EQ(region_of(half).count_reflex_corners(), 0U);
  for (const Nef2& set : {Nef2::whole() - square(), Nef2::whole() - Nef2::point({1, 2})}) {
    const PlaneRegion r = region_of(set);
    EXPECT_FALSE(r.is_bounded());
    expect_linked(r);
    EXPECT_EQ(r.loops.size(), 2U);
    EXPECT_EQ(r.count_reflex_corners(), set.complex().vertex_count() > 2 ? 4U : 1U);
  }
  EXPECT_EQ(region_of(Nef2::whole()).count_loops(), 1U);
}

/// What several faces share goes to one of them, and only what the set has.
TEST(PlaneRegion, EveryMarkedVertexHasOneOwner) {
  const Nef2 two = square() + polygon({{4, 4}, {8, 4}, {8, 8}});
  const Nef2 cut = square() - Nef2::polyline(Points{{0, 0}, {4, 4}}) + Nef2::point({4, 4});
  for (const Nef2& set : {two, cut}) {
    const PlaneComplex& c = set.complex();
    RegionMaker maker(c);
    std::vector<RationalPoint2> owned;
    for (std::uint32_t f = 0; f < c.face_count(); ++f) {
      if (!c.mark(FaceId(f))) continue;
      const PlaneRegion r = maker.region(FaceId(f));
      for (std::uint32_t v = 0; v < r.vertex_count(); ++v) {
        if (r.vertex_mark[v] != 0) owned.push_back(at(r, VertexId(v)));
      }
    }
    std::size_t marked = 0;
    for (std::uint32_t v = 0; v < c.vertex_count(); ++v) {
      if (!c.mark(VertexId(v))) continue;
      ++marked;
      EXPECT_TRUE(maker.owner(VertexId(v)).is_valid());
    }
    EXPECT_EQ(owned.size(), marked);
    for (const RationalPoint2& p : owned) EXPECT_EQ(std::ranges::count(owned, p), 1);
  }
}

}  // namespace plumb::plane_region_test
