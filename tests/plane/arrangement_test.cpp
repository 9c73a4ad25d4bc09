// Arrangements of segments, rays, lines and points against brute force: every vertex, edge and
// face, and the curves each edge came from.
#include "plumb/plane/arrangement.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <utility>
#include <vector>

#include "generate/curve_scenes.h"
#include "generate/test_share.h"
#include "oracle/arrangement_check.h"
#include "plumb/predicates/error.h"

namespace plumb::testing::arrangement_test {
namespace {

Arrangement arranged(const EngineScene& scene) {
  Context context;
  return arrange(scene.points, scene.curves, scene.isolated, context);
}

class Arrangements : public ::testing::TestWithParam<SceneKind> {};

TEST_P(Arrangements, MatchBruteForce) {
  const bool is_wild = GetParam() == SceneKind::Wild;
  const std::uint64_t rounds = share_of(is_wild ? 20 : 200);
  for (std::uint64_t seed = 0; seed < rounds && !HasFailure(); ++seed) {
    SCOPED_TRACE(seed);
    const std::uint32_t curves = static_cast<std::uint32_t>(seed) % (is_wild ? 4 : 7);
    const CurveScene scene = random_curves(GetParam(), curves, seed);
    EXPECT_EQ(disagreement(scene, seed), "") << to_text(scene);
  }
}

// The order in which curves are given only changes their numbers.
TEST_P(Arrangements, DoNotDependOnTheOrderOfInputs) {
  for (std::uint64_t seed = 0; seed < 50 && !HasFailure(); ++seed) {
    CurveScene scene = random_curves(GetParam(), 8, seed);
    const Arrangement first = arranged(to_engine(scene, seed));
    std::reverse(scene.curves.begin(), scene.curves.end());
    const Arrangement second = arranged(to_engine(scene, seed + 1));
    ASSERT_EQ(first.complex.vertex_count(), second.complex.vertex_count());
    ASSERT_EQ(first.complex.edge_count(), second.complex.edge_count());
    ASSERT_EQ(first.complex.face_count(), second.complex.face_count());
    for (std::size_t h = 0; h < first.complex.dcel.halfedge_count(); ++h) {
      ASSERT_EQ(first.complex.dcel.next(HalfedgeId(h)), second.complex.dcel.next(HalfedgeId(h)));
      ASSERT_EQ(first.complex.dcel.face(HalfedgeId(h)), second.complex.dcel.face(HalfedgeId(h)));
    }
    for (std::size_t e = 0; e < first.complex.edge_count(); ++e) {
      std::vector<std::uint32_t> turned;
      for (const SegmentId s : second.origins_of(EdgeId(e))) {
        turned.push_back(static_cast<std::uint32_t>(scene.curves.size()) - 1 - s.value());
      }
      std::reverse(turned.begin(), turned.end());
      std::vector<std::uint32_t> origins;
      for (const SegmentId s : first.origins_of(EdgeId(e))) origins.push_back(s.value());
      ASSERT_EQ(origins, turned);
    }
  }
}

std::string name_of_kind(const ::testing::TestParamInfo<SceneKind>& tested) {
  static constexpr const char* kNames[] = {"Grid", "Concurrent", "Fractions", "Wild"};
  return kNames[static_cast<int>(tested.param)];
}

INSTANTIATE_TEST_SUITE_P(Scenes, Arrangements, ::testing::ValuesIn(kSceneKinds), name_of_kind);

struct Counts {
  std::size_t vertices, edges, faces;
  friend bool operator==(const Counts&, const Counts&) = default;
};

Counts counts(const Arrangement& a) {
  return {a.complex.vertex_count(), a.complex.edge_count(), a.complex.face_count()};
}

TEST(Arrangement, OfNothingIsOneFace) { EXPECT_EQ(counts(arranged({})), (Counts{0, 0, 1})); }

// n lines in general position: n (n - 1) / 2 crossings, n^2 edges, and one face more than both.
TEST(Arrangement, OfLinesInGeneralPosition) {
  for (std::uint32_t n = 1; n <= 40; ++n) {
    EngineScene scene;
    for (std::uint32_t i = 0; i < n; ++i) {  // y = i x - i^2: tangents of a parabola
      const double slope = i;
      scene.points.inputs.push_back({0, -slope * slope});
      scene.points.inputs.push_back({1, slope - slope * slope});
      scene.curves.push_back({SweepCurve::kUnbounded, SweepCurve::kUnbounded, 2 * i, 2 * i + 1});
    }
    const std::size_t crossings = n * (n - 1) / 2;
    EXPECT_EQ(counts(arranged(scene)), (Counts{crossings, n * n, crossings + n + 1}));
  }
}

// n lines through one point: one vertex, 2 n rays, 2 n faces.
TEST(Arrangement, OfConcurrentLines) {
  for (std::uint32_t n = 1; n <= 30; ++n) {
    EngineScene scene;
    scene.points.inputs.push_back({7, -3});
    for (std::uint32_t i = 0; i < n; ++i) {
      scene.points.inputs.push_back({8, -3 + static_cast<double>(i)});
      scene.curves.push_back({SweepCurve::kUnbounded, SweepCurve::kUnbounded, 0, i + 1});
    }
    const std::size_t two_n = 2 * std::size_t{n};
    EXPECT_EQ(counts(arranged(scene)), n == 1 ? (Counts{0, 1, 2}) : (Counts{1, two_n, two_n}));
  }
}

// ---------------------------------------------------------------- overlaps

// Segments [first, last] of one line, by places along it.
using Interval = std::pair<std::uint32_t, std::uint32_t>;

/// On the line y = 3 x, or upright.
EngineScene on_a_line(const std::vector<Interval>& intervals, bool upright) {
  EngineScene scene;
  for (const auto& [first, last] : intervals) {
    const auto i = static_cast<std::uint32_t>(scene.points.inputs.size());
    for (const std::uint32_t at : {first, last}) {
      const double x = upright ? 0 : at;
      scene.points.inputs.push_back({x, 3.0 * at});
    }
    scene.curves.push_back({i, i + 1, i, i + 1});
  }
  return scene;
}

// Along a line every edge is between neighbouring ends, and comes from all intervals around it.
void expect_intervals(const std::vector<Interval>& intervals, bool upright) {
  const Arrangement a = arranged(on_a_line(intervals, upright));
  for (std::size_t e = 0; e < a.complex.edge_count(); ++e) {
    const HalfedgeId h = first_half(EdgeId(e));
    const auto at = [&](VertexId v) {
      return a.complex.points.inputs.approx(a.complex.vertex_point[v.value()]).y / 3;
    };
    const double from = at(a.complex.dcel.origin(h));
    const double to = at(a.complex.dcel.target(h));
    std::vector<SegmentId> expected;
    for (std::size_t i = 0; i < intervals.size(); ++i) {
      if (intervals[i].first <= from && to <= intervals[i].second) expected.emplace_back(i);
    }
    ASSERT_EQ(a.origins_of(EdgeId(e)), expected) << "edge " << e;
    ASSERT_FALSE(expected.empty());
  }
}

TEST(Overlaps, OfRandomIntervals) {
  for (std::uint64_t seed = 0; seed < 60 && !::testing::Test::HasFailure(); ++seed) {
    SCOPED_TRACE(seed);
    Dice dice(seed);
    std::vector<Interval> intervals;
    const std::uint32_t places = 2 + dice.below(40);
    for (std::uint32_t i = dice.below(40); i > 0; --i) {
      const std::uint32_t first = dice.below(places);
      intervals.emplace_back(first, first + 1 + dice.below(places));
    }
    expect_intervals(intervals, seed % 2 == 0);
  }
}

std::vector<Interval> nested(std::uint32_t n) {
  std::vector<Interval> intervals;
  for (std::uint32_t i = 0; i < n; ++i) intervals.emplace_back(i, 2 * n - i);
  return intervals;
}

TEST(Overlaps, OfNestedIntervals) {
  for (const bool upright : {false, true}) {
    expect_intervals(nested(60), upright);
  }
}

// The edges of n nested segments come from n^2 curves in all. Their sets share what they have in
// common: an edge adds what changes.
TEST(Overlaps, OfNestedIntervalsTakeLittle) {
  const std::uint32_t n = 20000;
  const Arrangement a = arranged(on_a_line(nested(n), false));
  ASSERT_EQ(a.complex.edge_count(), 2 * std::size_t{n} - 1);
  EXPECT_EQ(a.origins_of(EdgeId(n - 1)).size(), n);
  EXPECT_LE(a.origin_sets.node_count(), 2 * std::size_t{n} * 40);
}

// Of what one event makes only the last set stays.
TEST(Overlaps, OfDuplicatesTakeANodeEach) {
  const std::uint32_t n = 20000;
  const std::vector<Interval> same(n, Interval(0, 1));
  const Arrangement a = arranged(on_a_line(same, false));
  ASSERT_EQ(a.complex.edge_count(), 1U);
  EXPECT_EQ(a.origins_of(EdgeId(0)).size(), n);
  EXPECT_LE(a.origin_sets.node_count(), n);
}

// Sets made in any order, all of them kept; or several steps in one change, the last of them kept.
void expect_sets_stay(int steps_a_change) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    Dice dice(seed);
    const std::uint32_t curves = 1 + dice.below(60);
    SegmentSets sets(curves);
    std::vector<SegmentSets::Set> made(1);
    std::vector<std::set<SegmentId>> expected(1);
    for (int change = 0; change < 200; ++change) {
      if (steps_a_change > 1) sets.begin_change();
      const std::size_t from = dice.below(made.size());
      SegmentSets::Set set = made[from];
      std::set<SegmentId> next = expected[from];
      for (int step = 0; step < steps_a_change; ++step) {
        const SegmentId s(dice.below(curves));
        const bool is_there = next.erase(s) != 0;
        set = is_there ? sets.without(set, s) : sets.with(set, s);
        if (!is_there) next.insert(s);
      }
      made.push_back(set);
      expected.push_back(next);
    }
    for (std::size_t i = 0; i < made.size(); ++i) {
      std::vector<SegmentId> found;
      sets.append(made[i], found);
      ASSERT_EQ(found, std::vector<SegmentId>(expected[i].begin(), expected[i].end()));
    }
  }
}

TEST(Overlaps, SetsShareAndStayAsTheyWere) {
  for (const int steps_a_change : {1, 2, 7, 100}) expect_sets_stay(steps_a_change);
}

// Unbounded curves in a box that holds all their crossings are the same inside it: each end at
// infinity becomes a vertex on the box.
TEST_P(Arrangements, AreThoseOfCurvesClippedToALargeBox) {
  if (GetParam() == SceneKind::Wild) GTEST_SKIP() << "no box is large enough to be cheap";
  for (std::uint64_t seed = 0; seed < 100 && !HasFailure(); ++seed) {
    SCOPED_TRACE(seed);
    CurveScene scene = random_curves(GetParam(), 8, seed);
    const Arrangement open = arranged(to_engine(scene, seed));
    std::size_t ends = open.complex.dcel.vertex_count() - open.complex.vertex_count();
    const BigRational left = -power_of_two(40) - BigRational(1, 11);  // no line of the scene meets
    const BigRational right = power_of_two(40) + BigRational(1, 13);  // a corner
    const BigRational low = -power_of_two(40) - BigRational(1, 17);
    const BigRational high = power_of_two(40) + BigRational(1, 19);
    const std::vector<ExactPoint> box{{left, low}, {right, low}, {right, high}, {left, high}};
    for (TestCurve& c : scene.curves) {
      const auto clipped = [&](bool at_end) {
        std::optional<ExactPoint> best;
        for (std::size_t i = 0; i < 4; ++i) {
          const TestCurve side{box[i], box[(i + 1) % 4], box[i], box[(i + 1) % 4]};
          const auto p = crossing_of(c, side);
          if (!p || !side.contains(*p)) continue;
          const bool forward = (c.a < c.b) == at_end;
          if (!best || (forward ? *best < *p : *p < *best)) best = p;
        }
        return best;
      };
      const auto from = c.from ? c.from : clipped(false);
      const auto to = c.to ? c.to : clipped(true);
      c.from = from;
      c.to = to;
    }
    for (std::size_t i = 0; i < 4; ++i) {
      scene.curves.push_back({box[i], box[(i + 1) % 4], box[i], box[(i + 1) % 4]});
    }
    const Arrangement boxed = arranged(to_engine(scene, seed));
    EXPECT_EQ(boxed.complex.vertex_count(), open.complex.vertex_count() + ends + 4);
    EXPECT_EQ(boxed.complex.edge_count(), open.complex.edge_count() + ends + 4);
    EXPECT_EQ(boxed.complex.face_count(), open.complex.face_count() + 1);
  }
}

// An index beyond the points is refused before anything is read through it.
TEST(ArrangementIndices, AreCheckedBeforeUse) {
  PlanePoints points;
  for (const double x : {0.0, 1.0, 2.0}) points.inputs.push_back(x, x);
  const SweepCurve good{0, 1, 0, 1};
  const auto code_of = [&](const SweepCurve& curve, std::uint32_t isolated) {
    try {
      (void)arrange(points, std::vector{good, curve}, std::vector{isolated});
    } catch (const Error& error) {
      return error.code();
    }
    return ErrorCode::Usage;
  };
  for (const std::uint32_t bad : {3U, 1U << 31U}) {
    EXPECT_EQ(code_of({bad, 1, 0, 1}, 2), ErrorCode::BadIndex);
    EXPECT_EQ(code_of({0, bad, 0, 1}, 2), ErrorCode::BadIndex);
    EXPECT_EQ(code_of({0, 1, bad, 1}, 2), ErrorCode::BadIndex);
    EXPECT_EQ(code_of({0, 1, 0, bad}, 2), ErrorCode::BadIndex);
    EXPECT_EQ(code_of(good, bad), ErrorCode::BadIndex);
  }
  EXPECT_EQ(code_of({0, 1, SweepCurve::kUnbounded, 1}, 2), ErrorCode::BadIndex);
  EXPECT_EQ(code_of({SweepCurve::kUnbounded, 1, 0, 1}, 2), ErrorCode::Usage);
  PointTable2 table;
  table.push_back(0.0, 0.0);
  EXPECT_THROW((void)arrange(table, std::vector{SweepSegment{0, 1}}), Error);
}

}  // namespace
}  // namespace plumb::testing::arrangement_test
