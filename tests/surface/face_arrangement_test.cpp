// Checks the arrangement of segments in a face against exact coordinates: pieces of segments have
// disjoint interiors and add up, pieces of the face follow Euler's formula, islands lie within.
#include "plumb/surface/cells/face_arrangement.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "plumb/testing/dice.h"

namespace plumb::face_arrangement_test {

using testing::Dice;
using Ends = std::pair<std::uint32_t, std::uint32_t>;

/// A face with points at multiples of 1 / size, and one polygon along each segment.
struct Face {
  explicit Face(std::int64_t n) : size(n) {}

  void add_point(std::int64_t x, std::int64_t y) {
    in.points.inputs.push_back(Point2{static_cast<double>(x) / static_cast<double>(size),
                                      static_cast<double>(y) / static_cast<double>(size)});
  }
  /// The boundary, where `side` says which multiples from 1 to size - 1 on a side are points.
  template <class IsThere>
  void add_ring(const IsThere& is_there) {
    for (std::int64_t i = 0; i < 3 * size; ++i) {
      const std::int64_t along = i % size;
      if (along != 0 && !is_there()) continue;
      if (i == size) in.corner_1 = static_cast<std::uint32_t>(in.points.inputs.size());
      if (i < size) add_point(along, 0);
      if (i >= size && i < 2 * size) add_point(size - along, along);
      if (i >= 2 * size) add_point(0, size - along);
    }
    in.ring_size = static_cast<std::uint32_t>(in.points.inputs.size());
  }
  std::uint32_t inner(std::int64_t x, std::int64_t y) {
    const auto [at, is_new] =
        known.try_emplace({x, y}, static_cast<std::uint32_t>(in.points.inputs.size()));
    if (is_new) add_point(x, y);
    return at->second;
  }
  /// Unless the segment is there already or runs along the boundary.
  void add_segment(std::uint32_t from, std::uint32_t to) {
    if (from == to || !pairs.insert(std::minmax(from, to)).second) return;
    if (from < in.ring_size && to < in.ring_size) {
      const Point2 a = in.points.inputs.approx(from), b = in.points.inputs.approx(to);
      if ((a.x == 0 && b.x == 0) || (a.y == 0 && b.y == 0)) return;
      if (a.x + a.y == 1 && b.x + b.y == 1) return;
    }
    std::vector<SignedEntry> term{{static_cast<std::uint32_t>(given.size()), 1}};
    ASSERT_TRUE(bundles.add_sum(term));
    in.segments.push_back({from, to, static_cast<std::uint32_t>(bundles.size() - 1), 1});
    given.emplace_back(from, to);
  }
  RationalPoint2 at(std::uint32_t p) const { return exact(PlanePointsView(in.points), p); }

  std::int64_t size;
  FaceArrangement in;
  SurfaceBundles bundles;
  std::map<std::pair<std::int64_t, std::int64_t>, std::uint32_t> known;
  std::set<Ends> pairs;
  std::vector<Ends> given;
};

Rational turn(const RationalPoint2& a, const RationalPoint2& b, const RationalPoint2& p) {
  return Rational((b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x));
}
bool is_less(const RationalPoint2& p, const RationalPoint2& q) {
  return p.x != q.x ? p.x < q.x : p.y < q.y;
}
int sign(const Rational& x) { return x > 0 ? 1 : x < 0 ? -1 : 0; }

/// Whether two closed segments have a point in common that is inside one of them.
bool interiors_meet(const RationalPoint2& a, const RationalPoint2& b, const RationalPoint2& c,
                    const RationalPoint2& d) {
  const int of_c = sign(turn(a, b, c)), of_d = sign(turn(a, b, d));
  const int of_a = sign(turn(c, d, a)), of_b = sign(turn(c, d, b));
  if (of_c * of_d < 0 && of_a * of_b < 0) return true;
  const auto is_inside = [](int side, const RationalPoint2& p, const RationalPoint2& from,
                            const RationalPoint2& to) {
    return side == 0 && is_less(from, p) && is_less(p, to);
  };
  return is_inside(of_c, c, a, b) || is_inside(of_d, d, a, b) || is_inside(of_a, a, c, d) ||
         is_inside(of_b, b, c, d) || (of_c == 0 && of_d == 0 && a == c && b == d);
}

void expect_arcs(const Face& face) {
  const FaceArrangement& in = face.in;
  std::vector<RationalPoint2> at;
  for (std::uint32_t p = 0; p < in.points.size(); ++p) at.push_back(face.at(p));
  for (std::size_t i = 0; i < in.arcs.size(); ++i) {
    const FaceArc& a = in.arcs[i];
    EXPECT_TRUE(is_less(at[a.from], at[a.to]));
    const FaceSegment& s = in.segments[a.segment];
    EXPECT_EQ(sign(turn(at[s.from], at[s.to], at[a.from])), 0);
    EXPECT_EQ(sign(turn(at[s.from], at[s.to], at[a.to])), 0);
    for (std::size_t j = 0; j < i; ++j) {
      const FaceArc& b = in.arcs[j];
      ASSERT_FALSE(interiors_meet(at[a.from], at[a.to], at[b.from], at[b.to])) << i << ' ' << j;
    }
  }
  std::vector<RationalPoint2> used;
  std::set<std::uint32_t> ids;
  for (const FaceArc& a : in.arcs) ids.insert({a.from, a.to});
  for (const std::uint32_t p : ids) used.push_back(at[p]);
  std::ranges::sort(used, is_less);
  EXPECT_TRUE(std::ranges::adjacent_find(used) == used.end());
  // Along each polygon's segment its arcs follow each other from end to end.
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::int64_t> balance;
  for (const FaceArc& a : in.arcs) {
    for (const SignedEntry& e : face.bundles[a.bundle]) {
      const auto& [from, to] = face.given[e.id];
      EXPECT_EQ(e.value * a.sign, is_less(at[from], at[to]) ? 1 : -1);
      EXPECT_EQ(sign(turn(at[from], at[to], at[a.from])), 0);
      balance[{e.id, a.from}] += e.value * a.sign;
      balance[{e.id, a.to}] -= e.value * a.sign;
    }
  }
  for (std::uint32_t id = 0; id < face.given.size(); ++id) {
    --balance[{id, face.given[id].first}];
    ++balance[{id, face.given[id].second}];
  }
  for (const auto& [where, sum] : balance) EXPECT_EQ(sum, 0) << where.first;
}

std::uint32_t target(const FaceArrangement& in, std::uint32_t h) {
  if (h < in.ring_size) return h + 1 < in.ring_size ? h + 1 : 0;
  return in.origin(((h - in.ring_size) ^ 1U) + in.ring_size);
}

/// How often a loop runs around a point, by what it crosses to the left of it.
int winding(const Face& face, std::uint32_t first, const RationalPoint2& p) {
  int sum = 0;
  std::uint32_t h = first;
  do {
    const RationalPoint2 a = face.at(face.in.origin(h)), b = face.at(target(face.in, h));
    if (a.y <= p.y && p.y < b.y && turn(a, b, p) < 0) --sum;
    if (b.y <= p.y && p.y < a.y && turn(a, b, p) > 0) ++sum;
    h = face.in.next[h];
  } while (h != first);
  return sum;
}

void expect_pieces(const Face& face) {
  const FaceArrangement& in = face.in;
  const std::uint32_t n = in.halfedge_count();
  ASSERT_EQ(in.next.size(), n);
  std::vector<std::uint32_t> part(in.points.size());
  for (std::uint32_t p = 0; p < part.size(); ++p) part[p] = p < in.ring_size ? 0 : p;
  for (bool grows = true; grows;) {
    grows = false;
    for (const FaceArc& a : in.arcs) {
      const std::uint32_t least = std::min(part[a.from], part[a.to]);
      grows = grows || part[a.from] != part[a.to];
      part[a.from] = part[a.to] = least;
    }
  }
  std::set<std::uint32_t> nodes, parts;
  for (std::uint32_t h = 0; h < n; ++h) {
    nodes.insert(in.origin(h));
    parts.insert(part[in.origin(h)]);
    EXPECT_EQ(in.origin(in.next[h]), target(in, h));
    EXPECT_EQ(in.piece[in.next[h]], in.piece[h]);
    EXPECT_LT(in.piece[h], in.piece_count);
  }
  const std::size_t edges = in.ring_size + in.arcs.size();
  EXPECT_EQ(in.piece_count, edges - nodes.size() + parts.size());
  EXPECT_EQ(std::set<std::uint32_t>(in.next.begin(), in.next.end()).size(), n);

  std::map<std::uint32_t, std::uint32_t> outer;  // of a piece: a half-edge of its outer loop
  std::map<std::uint32_t, Rational> area;
  for (const FaceArrangement::Loop& loop : in.loops) {
    EXPECT_EQ(loop.piece, in.piece[loop.halfedge]);
    Rational twice;
    std::uint32_t h = loop.halfedge;
    do {
      twice += turn({0, 0}, face.at(in.origin(h)), face.at(target(in, h)));
      h = in.next[h];
    } while (h != loop.halfedge);
    EXPECT_EQ(loop.is_hole, twice <= 0);
    EXPECT_EQ(outer.contains(loop.piece), loop.is_hole);  // the outer one comes first
    if (loop.is_hole) continue;
    outer[loop.piece] = loop.halfedge;
    area[loop.piece] = twice;
  }
  EXPECT_EQ(outer.size(), in.piece_count);
  for (const FaceArrangement::Loop& loop : in.loops) {
    if (!loop.is_hole) continue;
    RationalPoint2 left = face.at(in.origin(loop.halfedge));
    for (std::uint32_t h = in.next[loop.halfedge]; h != loop.halfedge; h = in.next[h]) {
      if (is_less(face.at(in.origin(h)), left)) left = face.at(in.origin(h));
    }
    std::uint32_t best = kNone;
    for (const auto& [piece, first] : outer) {
      if (winding(face, first, left) == 1 && (best == kNone || area[piece] < area[best])) {
        best = piece;
      }
    }
    EXPECT_EQ(loop.piece, best);
  }
}

TEST(FaceArrangement, AFaceWithoutSegmentsIsOnePiece) {
  Face face(4);
  face.add_ring([] { return true; });
  face.in.run(face.bundles, unlimited_context());
  EXPECT_EQ(face.in.piece_count, 1U);
  EXPECT_EQ(face.in.halfedge_count(), 12U);
  expect_pieces(face);
}

TEST(FaceArrangement, RandomSegmentsOfAFewPointsAreArranged) {
  std::size_t most_crossings = 0;
  for (std::uint64_t seed = 0; seed < 60 && !::testing::Test::HasFailure(); ++seed) {
    SCOPED_TRACE(seed);
    Dice dice(seed);
    Face face(seed % 2 == 0 ? 4 : 8);  // of 4 there are three inner points: many overlaps
    face.add_ring([&] { return dice.below(2) == 0; });
    std::vector<std::uint32_t> points;
    for (std::uint32_t r = 0; r < face.in.ring_size; ++r) points.push_back(r);
    for (int i = 0; i < 8; ++i) {
      const std::int64_t x = dice.between(1, face.size - 2);
      points.push_back(face.inner(x, dice.between(1, face.size - 1 - x)));
    }
    for (std::uint32_t i = dice.below(14); i > 0; --i) {
      face.add_segment(points[dice.below(points.size())], points[dice.below(points.size())]);
    }
    face.in.run(face.bundles, unlimited_context());
    expect_arcs(face);
    expect_pieces(face);
    most_crossings = std::max(most_crossings, face.in.points.crossings.size());
  }
  EXPECT_GT(most_crossings, 10U);
}

/// Above eight islands a sweep finds what lies below them, above 32 segments a tree the contacts.
TEST(FaceArrangement, ManyIslandsLieInThePieceBelowThem) {
  for (std::uint64_t seed = 0; seed < 4 && !::testing::Test::HasFailure(); ++seed) {
    SCOPED_TRACE(seed);
    Dice dice(seed);
    Face face(32);
    face.add_ring([&] { return dice.below(8) == 0; });
    for (int i = 0; i < 22; ++i) {
      const std::int64_t r = 1 + dice.between(0, 3);
      const std::int64_t x = dice.between(1, 29 - r),
                         y = dice.between(1, std::max<std::int64_t>(1, 29 - r - x));
      if (x + y + r > 31) continue;
      const std::uint32_t a = face.inner(x, y), b = face.inner(x + r, y), c = face.inner(x, y + r);
      face.add_segment(a, b);
      face.add_segment(b, c);
      if (i % 4 != 0) face.add_segment(c, a);
    }
    face.in.run(face.bundles, unlimited_context());
    expect_arcs(face);
    expect_pieces(face);
    std::size_t holes = 0;
    for (const FaceArrangement::Loop& loop : face.in.loops) holes += loop.is_hole ? 1 : 0;
    EXPECT_GT(holes, 3U);
  }
}

/// What runs there and back cancels, and its pieces go.
TEST(FaceArrangement, OppositeOverlapsOfOnePolygonCancel) {
  Face face(8);
  face.add_ring([] { return false; });
  const std::uint32_t a = face.inner(1, 1), b = face.inner(2, 1), c = face.inner(3, 1),
                      d = face.inner(4, 1);
  std::vector<SignedEntry> term{{0, 1}};
  ASSERT_TRUE(face.bundles.add_sum(term));
  face.in.segments = {{a, c, 0, 1}, {d, b, 0, 1}};
  face.in.run(face.bundles, unlimited_context());
  ASSERT_EQ(face.in.arcs.size(), 2U);
  EXPECT_EQ(face.in.arcs[0].sign * face.bundles[face.in.arcs[0].bundle][0].value, 1);
  EXPECT_EQ(face.in.arcs[1].sign * face.bundles[face.in.arcs[1].bundle][0].value, -1);
  EXPECT_TRUE(face.in.arcs[0].to == b && face.in.arcs[1].from == c);
}

}  // namespace plumb::face_arrangement_test
