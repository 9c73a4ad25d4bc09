// Drafts that complexes are taken apart into and finished from again, and simplified complexes:
// audits, the membership of points, and definitions over all cells.
#include "plumb/plane/complex/plane_draft.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <vector>

#include "plane/random_complex.h"
#include "plumb/plane/nef2.h"  // Declares PlaneLocator with its visibility, before its definition.
#include "plumb/plane/plane_audit.h"
#include "plumb/plane/query/plane_locator.h"
#include "plumb/testing/dice.h"

namespace plumb::plane_draft_test {

using testing::random_complex;

/// The ordinary cells of a complex, without its frame and its faces.
PlaneDraft draft_of(const PlaneComplex& c) {
  PlaneDraft draft;
  for (std::size_t v = 0; v < c.vertex_count(); ++v) {
    const VertexId same = draft.add_vertex(c.vertex_point[v], c.marks.vertex[v] != 0);
    EXPECT_EQ(same, VertexId(v));
    if (c.dcel.is_isolated(same)) draft.isolated.push_back(same);
  }
  for (std::size_t i = 0; i < c.edge_count(); ++i) {
    const EdgeId e(i);
    const HalfedgeId h = first_half(e);
    const VertexId from = c.dcel.origin(h), to = c.dcel.target(h);
    draft.add_edge(c.is_at_infinity(from) ? VertexId() : from, c.line[i], c.mark(e),
                   c.mark(c.dcel.face(h)), c.mark(c.dcel.face(twin(h))));
    if (!c.is_at_infinity(to)) draft.end_edge(e, to);
  }
  for (std::size_t v = 0; v < c.vertex_count(); ++v) {
    std::vector<HalfedgeId> leaving;
    for (const HalfedgeId h : c.dcel.around(VertexId(v))) leaving.push_back(h);
    draft.link_ring(leaving);
  }
  for (std::size_t v = c.vertex_count(); v < c.dcel.vertex_count(); ++v) {
    for (std::size_t h = 0; h < 2 * c.edge_count(); ++h) {
      if (c.dcel.target(HalfedgeId(h)) == VertexId(v)) draft.ends.emplace_back(h);
    }
  }
  draft.bottom_mark = c.marks.face[0];
  return draft;
}

void expect_same_links(const PlaneComplex& a, const PlaneComplex& b) {
  ASSERT_EQ(a.dcel.halfedge_count(), b.dcel.halfedge_count());
  ASSERT_EQ(a.dcel.face_count(), b.dcel.face_count());
  for (std::size_t i = 0; i < a.dcel.halfedge_count(); ++i) {
    const HalfedgeId h(i);
    EXPECT_EQ(a.dcel.origin(h), b.dcel.origin(h));
    EXPECT_EQ(a.dcel.next(h), b.dcel.next(h));
    EXPECT_EQ(a.dcel.face(h), b.dcel.face(h));
  }
  EXPECT_TRUE(a.line == b.line && a.vertex_point == b.vertex_point && a.marks == b.marks);
}

/// Whatever numbers the classes of faces have, and whatever points nothing refers to.
TEST(PlaneDraft, IsFinishedAsTheComplexItCameFrom) {
  testing::Dice dice(1);
  for (int round = 0; round < 150; ++round) {
    const PlaneComplex c = random_complex(dice);
    PlaneDraft draft = draft_of(c);
    PlanePoints points = c.points;
    const auto inputs = static_cast<std::uint32_t>(points.inputs.size());
    points.inputs.push_back(Point2{77, 77});  // all crossings move up by one
    for (std::uint32_t& p : draft.vertex_point) p += p >= inputs ? 1 : 0;
    if (!points.crossings.empty()) points.crossings.push_back(points.crossings.front());
    const HalfedgeId bottom = close_frame(draft);
    EXPECT_EQ(bottom.is_valid(), c.has_frame());
    const PlaneLoops loops = trace_loops(draft);
    const auto last = static_cast<std::uint32_t>(c.dcel.face_count() - 1);
    PlaneFaceClasses classes;
    classes.class_count = last + 1;
    classes.bottom = last;
    for (const HalfedgeId h : loops.first) {
      classes.of_loop.push_back(last - c.dcel.face(h).value());
    }
    for (const VertexId v : draft.isolated) {
      classes.of_isolated.push_back(last - c.dcel.face(c.dcel.isolated_loop(v)).value());
    }
    if (bottom.is_valid()) {
      EXPECT_EQ(classes.of_loop[loops.loop_of[bottom.value()]], classes.bottom);
    }
    const FinishedDraft finished = finish(draft, loops, classes, points);
    expect_same_links(finished.complex, c);
    EXPECT_EQ(finished.complex.points.size(), c.points.size());
    EXPECT_FALSE(audit(finished.complex, AuditForm::Any).has_value());
    ASSERT_EQ(finished.first_of_face.size(), c.face_count());
    for (std::size_t f = 0; f < c.face_count(); ++f) {
      HalfedgeId least;
      for (std::size_t h = c.dcel.halfedge_count(); h-- > 0;) {
        if (c.dcel.face(HalfedgeId(h)) == FaceId(f)) least = HalfedgeId(h);
      }
      EXPECT_EQ(finished.first_of_face[f], least);
    }
  }
}

TEST(PlaneDraft, LoopsAreChainsAndKnowTheirLeastVertex) {
  testing::Dice dice(2);
  for (int round = 0; round < 150; ++round) {
    PlaneDraft draft = draft_of(random_complex(dice));
    close_frame(draft);
    const PlaneLoops loops = trace_loops(draft);
    const std::vector<VertexId> least = least_vertices(draft, loops);
    std::vector<HalfedgeId> first(loops.count());
    std::vector<VertexId> expected(loops.count());
    std::vector<bool> is_along_frame(loops.count());
    for (std::size_t h = draft.next.size(); h-- > 0;) {
      const std::uint32_t loop = loops.loop_of[h];
      ASSERT_LT(loop, loops.count());
      EXPECT_EQ(loops.loop_of[draft.next[h].value()], loop);
      first[loop] = HalfedgeId(h);
      expected[loop] = std::min(expected[loop], draft.origin[h]);
      if (draft.origin[h].value() >= draft.vertex_count()) is_along_frame[loop] = true;
    }
    EXPECT_EQ(loops.first, first);
    EXPECT_TRUE(std::ranges::is_sorted(first));
    for (std::size_t l = 0; l < least.size(); ++l) {
      EXPECT_EQ(least[l], is_along_frame[l] ? VertexId() : expected[l]);
    }
  }
}

/// The set stays; what is left is minimal, so that a second time changes nothing.
TEST(PlaneDraft, SimplifyKeepsTheSetAndNothingElse) {
  testing::Dice dice(3);
  std::size_t gone = 0;
  for (int round = 0; round < 150; ++round) {
    const PlaneComplex c = random_complex(dice, round % 2 == 0 ? 2 : 12);
    const PlaneComplex simple = simplify(c);
    const auto flaw = audit(simple, AuditForm::Minimal);
    EXPECT_FALSE(flaw.has_value()) << flaw->invariant << " at " << flaw->place;
    expect_same_links(simplify(simple), simple);
    gone += c.vertex_count() - simple.vertex_count();
    for (std::size_t e = 0; e < simple.edge_count(); ++e) {
      const HalfedgeId h = first_half(EdgeId(e));
      const bool mark = simple.mark(EdgeId(e));
      EXPECT_TRUE(simple.mark(simple.dcel.face(h)) != mark ||
                  simple.mark(simple.dcel.face(twin(h))) != mark);
    }
    const PlaneLocator before(c), after(simple);
    std::vector<RationalPoint2> places;
    for (const std::uint32_t p : c.vertex_point) places.push_back(exact(c.points, p));
    for (std::size_t i = places.size(); i-- > 1;) {
      const RationalPoint2 &p = places[i], &q = places[i - 1];
      places.push_back({(p.x + q.x) / 2, (p.y + q.y) / 2});
    }
    for (int x = -1; x <= 8; ++x) {
      for (int y = -2; y <= 8; ++y) places.push_back({Rational(x) / 2, Rational(y) / 2});
    }
    for (const RationalPoint2& p : places) {
      EXPECT_EQ(after.locate(p).marked, before.locate(p).marked);
    }
  }
  EXPECT_GT(gone, 100U);
}

/// Of edges and vertices: of everything around them, all or any is marked.
TEST(PlaneDraft, InteriorsAndClosuresLookAtEverythingAround) {
  testing::Dice dice(4);
  for (int round = 0; round < 150; ++round) {
    const PlaneComplex c = random_complex(dice);
    PlaneMarks all = c.marks, any = c.marks;
    const auto add = [](std::uint8_t& in_all, std::uint8_t& in_any, bool mark) {
      in_all = in_all != 0 && mark ? 1 : 0;
      in_any = in_any != 0 || mark ? 1 : 0;
    };
    for (std::size_t i = 0; i < 2 * c.edge_count(); ++i) {
      const HalfedgeId h(i);
      const bool in_face = c.mark(c.dcel.face(h));
      add(all.edge[i / 2], any.edge[i / 2], in_face);
      for (const VertexId v : {c.dcel.origin(h), c.dcel.target(h)}) {
        if (c.is_at_infinity(v)) continue;
        add(all.vertex[v.value()], any.vertex[v.value()], in_face);
        add(all.vertex[v.value()], any.vertex[v.value()], c.mark(edge_of(h)));
      }
    }
    for (std::size_t i = 0; i < c.vertex_count(); ++i) {
      if (!c.dcel.is_isolated(VertexId(i))) continue;
      add(all.vertex[i], any.vertex[i], c.mark(c.dcel.face(c.dcel.isolated_loop(VertexId(i)))));
    }
    EXPECT_TRUE(interior_marks(c) == all);
    EXPECT_TRUE(closure_marks(c) == any);
  }
}

}  // namespace plumb::plane_draft_test
