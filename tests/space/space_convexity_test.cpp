// Convexity of sets of space: cases that can be argued by hand, and random sets against segments
// between many of their points, decided on the cells of all planes (space_cells.h).

#include "plumb/space/query/space_convexity.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "generate/space_solids.h"
#include "generate/test_share.h"
#include "oracle/space_set.h"
#include "plumb/space/nef3.h"
#include "plumb/testing/dice.h"

namespace plumb::testing::space_convexity_test {
namespace {

/// A set of the engine and the expression it was made by.
struct Pair {
  Nef3 nef;
  SpaceSetPointer twin;
};
Pair operator+(const Pair& a, const Pair& b) {
  return {a.nef + b.nef, apply(SetOperator::Union, a.twin, b.twin)};
}
Pair operator*(const Pair& a, const Pair& b) {
  return {a.nef * b.nef, apply(SetOperator::Intersection, a.twin, b.twin)};
}
Pair operator-(const Pair& a, const Pair& b) {
  return {a.nef - b.nef, apply(SetOperator::Difference, a.twin, b.twin)};
}
Pair operator!(const Pair& a) { return {!a.nef, apply(SetOperator::Complement, a.twin)}; }

using Ints = std::array<int, 3>;
constexpr bool kOpen = false;

ExactPoint3 exact(const Ints& p) { return {p[0], p[1], p[2]}; }
RationalPoint3 rational(const Ints& p) { return {p[0], p[1], p[2]}; }

Pair below(int a, int b, int c, int d, bool closed = true) {
  return {Nef3::half_space({a, b, c, d}, closed ? Boundary::Closed : Boundary::Open),
          half_space(a, b, c, d, closed)};
}
Pair plane(int a, int b, int c, int d) { return below(a, b, c, d) * below(-a, -b, -c, -d); }
Pair point(const Ints& p) { return {Nef3::point(rational(p)), space_set(PointsLeaf{{exact(p)}})}; }
Pair segment(const Ints& p, const Ints& q) {
  return {Nef3::segment(rational(p), rational(q)), space_set(ChainsLeaf{{{exact(p), exact(q)}}})};
}
Pair everything() { return {Nef3::whole(), apply(SetOperator::Complement, empty_space())}; }
Pair nothing() { return {Nef3::empty(), empty_space()}; }
/// Flat where low and high agree.
Pair box(const Ints& low, const Ints& high, bool closed = true) {
  Pair result = everything();
  for (std::size_t axis = 0; axis < 3; ++axis) {
    Ints n{};
    n[axis] = 1;
    result = result * below(n[0], n[1], n[2], -high[axis], closed);
    result = result * below(-n[0], -n[1], -n[2], low[axis], closed);
  }
  return result;
}
/// The segment without its ends.
Pair inner_segment(const Ints& p, const Ints& q) { return segment(p, q) - point(p) - point(q); }

// ---------------------------------------------------------------- the oracle

/// Every point is homogeneous, (v, w) with w > 0: sums of such are between.
CellPoint3 operator+(const CellPoint3& p, const CellPoint3& q) {
  return {{p.v.x + q.v.x, p.v.y + q.v.y, p.v.z + q.v.z}, p.w + q.w};
}
CellPoint3 operator*(const BigInt& s, const CellPoint3& p) { return {s * p.v, s * p.w}; }

/// What a set holds of a cube that no crossing of its planes lies outside of.
class SegmentOracle {
 public:
  explicit SegmentOracle(const SpaceSet& set)
      : cells_(with_cube(set)), marks_(marks_of(set, cells_)) {
    for (std::size_t c = 0; c < cells_.size(); ++c) {
      const auto& signs = cells_[c].signs;
      is_marked_[{signs.positive, signs.negative}] = marks_[c];
      if (marks_[c] && is_in_cube(cells_[c].point)) inside_.push_back(c);
    }
  }

  /// Does no segment between points of the set that are tried leave it? Points in each marked cell,
  /// in turn against points in any and in one of the same line or plane (at most `limit` pairs): of
  /// many cells, few have a segment through a gap that lies in a line.
  bool is_convex(Dice& dice, std::size_t limit) const {
    if (inside_.empty()) return true;
    for (std::size_t i = 0; i < limit; ++i) {
      const std::size_t a = inside_[i / 2 % inside_.size()];
      const std::size_t b = i % 2 == 0 ? any_of(inside_, dice) : any_of(mates_of(a, dice), dice);
      const CellPoint3 p = random_point(a, dice);
      if (!holds_segment(p, random_point(b, dice))) return false;
    }
    return true;
  }

 private:
  static constexpr int kCube = 32;
  static std::vector<CellPlane> with_cube(const SpaceSet& set) {
    std::vector<CellPlane> planes;
    add_planes(set, planes);
    for (const int side : {-kCube, kCube}) {
      planes.push_back(plane_of(1, 0, 0, side));
      planes.push_back(plane_of(0, 1, 0, side));
      planes.push_back(plane_of(0, 0, 1, side));
    }
    return planes;
  }
  static bool is_in_cube(const ExactPoint3& p) {
    return abs(p.x) <= kCube && abs(p.y) <= kCube && abs(p.z) <= kCube;
  }

  static std::size_t any_of(const std::vector<std::size_t>& cells, Dice& dice) {
    return cells[dice.below(cells.size())];
  }
  /// Marked cells within some of the planes through the cell: itself, at least.
  std::vector<std::size_t> mates_of(std::size_t cell, Dice& dice) const {
    std::uint64_t planes = 0;
    for (std::size_t i = 0; i < cells_.planes().size(); ++i)
      planes |= std::uint64_t{dice.below(2)} << i;
    planes &= cells_.planes_through(cell);
    std::vector<std::size_t> mates;
    for (const std::size_t c : inside_) {
      if ((planes & ~cells_.planes_through(c)) == 0) mates.push_back(c);
    }
    return mates;
  }

  /// In the cell; near one of its corners or anywhere.
  CellPoint3 random_point(std::size_t cell, Dice& dice) const {
    const auto& corners = cells_[cell].corners;
    if (corners.empty()) return cells_[cell].sample;
    const std::size_t near = dice.below(corners.size());
    const BigInt heavy = BigInt(1) << dice.below(10);
    CellPoint3 sum{{0, 0, 0}, 0};
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const BigInt weight = i == near ? heavy : BigInt(dice.between(1, 4));
      sum = sum + weight * cells_[corners[i]].sample;
    }
    return sum;
  }

  /// Cell by cell: where the segment passes a plane, and between.
  bool holds_segment(const CellPoint3& p, const CellPoint3& q) const {
    using Weights = std::pair<BigInt, BigInt>;
    std::vector<Weights> sides, at{{1, 0}, {0, 1}};
    for (const CellPlane& plane : cells_.planes()) {
      const BigInt a = dot(plane.n, p.v) + plane.d * p.w, b = dot(plane.n, q.v) + plane.d * q.w;
      sides.emplace_back(a, b);
      if (a * b < 0) at.emplace_back(abs(b), abs(a));
    }
    std::sort(at.begin(), at.end(), [](const Weights& s, const Weights& t) {
      return s.second * t.first < t.second * s.first;
    });
    for (std::size_t i = 0; i < at.size(); ++i) {
      if (!is_marked(sides, at[i])) return false;
      if (i == 0) continue;
      const Weights between{at[i - 1].first + at[i].first, at[i - 1].second + at[i].second};
      if (!is_marked(sides, between)) return false;
    }
    return true;
  }

  bool is_marked(const std::vector<std::pair<BigInt, BigInt>>& sides,
                 const std::pair<BigInt, BigInt>& at) const {
    SpaceCells::Signs signs;
    for (std::size_t i = 0; i < sides.size(); ++i) {
      signs.set(i, BigInt(at.first * sides[i].first + at.second * sides[i].second).sign());
    }
    return is_marked_.at({signs.positive, signs.negative});
  }

  SpaceCells cells_;
  CellMarks marks_;
  std::map<std::pair<std::uint64_t, std::uint64_t>, bool> is_marked_;
  std::vector<std::size_t> inside_;  // marked cells in the cube
};

// ---------------------------------------------------------------- by hand

struct Case {
  std::string name;
  Pair set;
  bool is_convex;
};

/// The oracle must agree with the hand.
void expect(const std::vector<Case>& cases) {
  Dice dice(20);
  for (const Case& c : cases) {
    EXPECT_EQ(c.set.nef.is_convex(), c.is_convex) << c.name;
    EXPECT_EQ(SegmentOracle(*c.set.twin).is_convex(dice, 1000), c.is_convex) << c.name;
  }
}

const Ints kLow{0, 0, 0}, kHigh{2, 2, 2};

TEST(Convexity, Solids) {
  const Pair cube = box(kLow, kHigh), open = box(kLow, kHigh, kOpen);
  expect({{"nothing", nothing(), true},
          {"everything", everything(), true},
          {"everything but a point", !point({1, 1, 1}), false},
          {"cube", cube, true},
          {"open cube", open, true},
          {"complement of a cube", !cube, false},
          {"pyramid", box(kLow, {2, 2, 9}) * below(1, 0, 1, -3) * below(0, 1, 1, -3), true},
          {"two cubes", cube + box({3, 0, 0}, {4, 2, 2}), false},
          {"two cubes with a common facet", cube + box({2, 0, 0}, {4, 2, 2}), true},
          {"open cubes with a common facet", open + box({2, 0, 0}, {4, 2, 2}, kOpen), false},
          {"two cubes with a common edge", cube + box({2, 2, 0}, {4, 4, 2}), false},
          {"L", cube + box({2, 0, 0}, {4, 1, 2}), false},
          {"cube with a shaft", box(kLow, {3, 3, 3}) - box({1, 1, 0}, {2, 2, 3}), false},
          {"cube with a void", box(kLow, {3, 3, 3}) - box({1, 1, 1}, {2, 2, 2}), false},
          {"wedges at an edge",
           below(1, 0, 0, 0) * below(0, 1, 0, 0) + below(-1, 0, 0, 0) * below(0, -1, 0, 0), false},
          {"octants at a point",
           below(1, 0, 0, 0) * below(0, 1, 0, 0) * below(0, 0, 1, 0) +
               below(-1, 0, 0, 0) * below(0, -1, 0, 0) * below(0, 0, -1, 0),
           false},
          {"cube with a slit", cube - segment({1, 1, 1}, {1, 1, 2}), false},
          {"cube cut in two", cube - plane(1, 0, 0, -1), false},
          {"cube without an inner point", cube - point({1, 1, 1}), false},
          {"cube and a point", cube + point({3, 3, 3}), false},
          {"cube and a segment", cube + segment({2, 1, 1}, {3, 1, 1}), false},
          {"cube and a flap", cube + box({2, 0, 2}, {3, 2, 2}), false}});
}

TEST(Convexity, MarksOfABody) {
  const Pair cube = box(kLow, kHigh), open = box(kLow, kHigh, kOpen);
  const Pair facet = box({0, 0, 2}, kHigh), edge = segment({0, 0, 2}, {2, 0, 2});
  const Pair inside =
      facet - plane(1, 0, 0, 0) - plane(1, 0, 0, -2) - plane(0, 1, 0, 0) - plane(0, 1, 0, -2);
  expect(
      {{"no vertex", cube - point({0, 0, 0}), true},
       {"no two vertices", cube - point({0, 0, 0}) - point({2, 0, 0}), true},
       {"no inner point of an edge", cube - point({1, 0, 0}), false},
       {"no inner point of a facet", cube - point({1, 1, 0}), false},
       {"no edge, both ends", cube - inner_segment({0, 0, 2}, {2, 0, 2}), false},
       {"no edge, one end", cube - edge + point({0, 0, 2}), true},
       {"no edge, no end", cube - edge, true},
       {"half an edge", cube - segment({1, 0, 2}, {2, 0, 2}), true},
       {"half an edge and its far end", cube - segment({1, 0, 2}, {2, 0, 2}) + point({2, 0, 2}),
        false},
       {"no inside of a facet", cube - inside, false},
       {"no facet", cube - facet, true},
       {"no facet, an edge", cube - facet + edge, true},
       {"no facet, an edge without ends", cube - facet + inner_segment({0, 0, 2}, {2, 0, 2}), true},
       {"no facet, a vertex", cube - facet + point({2, 2, 2}), true},
       {"no facet, a point", cube - facet + point({1, 1, 2}), true},
       {"no facet, two vertices", cube - facet + point({2, 2, 2}) + point({0, 0, 2}), false},
       {"no facet, two edges", cube - facet + edge + segment({0, 0, 2}, {0, 2, 2}), false},
       {"no facet, a diagonal", cube - facet + segment({0, 0, 2}, {2, 2, 2}), true},
       {"half a facet", cube - (facet * below(-1, 0, 0, 1)), true},
       {"half a facet and a corner", cube - (facet * below(-1, 0, 0, 1)) + point({2, 0, 2}), false},
       {"a slit facet", cube - segment({1, 0, 2}, {1, 1, 2}), false},
       {"a quarter facet missing", cube - (facet * below(-1, 0, 0, 1) * below(0, -1, 0, 1)), false},
       {"open and a vertex", open + point(kHigh), true},
       {"open and an edge", open + edge, true},
       {"open and two far vertices", open + point(kLow) + point(kHigh), true},
       {"open and two near vertices", open + point(kLow) + point({2, 2, 0}), false},
       {"open and two facets", open + inside + box(kLow, {2, 2, 0}), true},
       {"open and a disk", open + box({0, 0, 2}, {1, 1, 2}), true},
       {"open and two disks", open + box({0, 0, 2}, {1, 1, 2}) + box({1, 1, 2}, kHigh), false}});
}

TEST(Convexity, Unbounded) {
  const Pair half = below(0, 0, 1, 0), open = below(0, 0, 1, 0, kOpen);
  const Pair line = plane(0, 0, 1, 0) * plane(1, 0, 0, 0);
  expect({{"half-space", half, true},
          {"open half-space", open, true},
          {"open half-space and a line", open + line, true},
          {"open half-space and a half-line", open + line * below(0, 1, 0, 0), true},
          {"open half-space and two half-lines",
           open + line * below(0, 1, 0, 0) + line * below(0, -1, 0, 1), false},
          {"open half-space and two points", open + point({0, 0, 0}) + point({1, 0, 0}), false},
          {"half-space without a line", half - line, false},
          {"half-space without half its plane", half - plane(0, 0, 1, 0) * below(1, 0, 0, 0), true},
          {"slab", half * below(0, 0, -1, -1), true},
          {"slab of x and y", below(1, -1, 0, 0) * below(-1, 1, 0, -1), true},
          {"two half-spaces", half + below(0, 0, -1, 1), false},
          {"wedge", half * below(1, 0, 0, 0), true},
          {"reflex wedge", half + below(1, 0, 0, 0), false},
          {"space without a half-space", !half, true},
          {"space without a plane", !plane(0, 0, 1, 0), false},
          {"octant", half * below(1, 0, 0, 0) * below(0, 1, 0, 0), true}});
}

TEST(Convexity, Flat) {
  const Pair square = box(kLow, {2, 2, 0});
  const Pair line = plane(0, 0, 1, 0) * plane(1, 0, 0, 0);
  expect(
      {{"point", point(kLow), true},
       {"two points", point(kLow) + point(kHigh), false},
       {"segment", segment(kLow, kHigh), true},
       {"segment without ends", inner_segment(kLow, kHigh), true},
       {"segment without its middle", segment(kLow, kHigh) - point({1, 1, 1}), false},
       {"segment and its prolongation", segment(kLow, {1, 1, 1}) + segment({1, 1, 1}, kHigh), true},
       {"segment and a point", segment(kLow, kHigh) + point({3, 3, 3}), false},
       {"bent", segment(kLow, {2, 0, 0}) + segment({2, 0, 0}, {2, 2, 0}), false},
       {"line", line, true},
       {"half-line", line * below(0, 1, 0, 0), true},
       {"line without a point", line - point(kLow), false},
       {"plane", plane(1, 2, 3, 4), true},
       {"plane without a point", plane(0, 0, 1, 0) - point(kLow), false},
       {"plane and a point", plane(0, 0, 1, 0) + point({0, 0, 1}), false},
       {"plane and a line across", plane(0, 0, 1, 0) + plane(1, 0, 0, 0) * plane(0, 1, 0, 0),
        false},
       {"two planes", plane(0, 0, 1, 0) + plane(0, 0, 1, 1), false},
       {"half-plane", plane(0, 0, 1, 0) * below(1, 0, 0, 0), true},
       {"open half-plane and half its line",
        plane(0, 0, 1, 0) * below(1, 0, 0, 0, kOpen) + line * below(0, 1, 0, 0), true},
       {"square", square, true},
       {"square without a corner", square - point(kLow), true},
       {"square without a side, with ends", square - inner_segment(kLow, {2, 0, 0}), false},
       {"square without half a side", square - segment(kLow, {1, 0, 0}), true},
       {"square with a slit", square - segment(kLow, {1, 1, 0}), false},
       {"square with a hole", box(kLow, {3, 3, 0}) - box({1, 1, 0}, {2, 2, 0}), false},
       {"square without its centre", square - point({1, 1, 0}), false},
       {"square with an antenna", square + segment({2, 0, 0}, {3, 0, 0}), false},
       {"flat L", square + box({2, 0, 0}, {3, 1, 0}), false},
       {"squares at a corner", square + box({2, 2, 0}, {3, 3, 0}), false},
       {"roof", square + box({2, 0, 0}, {2, 2, 2}), false}});
}

// ---------------------------------------------------------------- at random

Ints random_ints(Dice& dice) {
  const auto number = [&dice] { return static_cast<int>(dice.below(3)); };
  return {number(), number(), number()};
}

/// Mostly convex: a cube, half-spaces, a plane cut by some, or less.
Pair random_base(Dice& dice) {
  const auto random_half_space = [&dice] {
    const auto number = [&dice] { return static_cast<int>(dice.between(-1, 1)); };
    const Ints n{number(), number(), number()};
    const int a = n == Ints{} ? 1 : n[0];
    const int d = static_cast<int>(dice.between(-2, 0));
    return below(a, n[1], n[2], d, dice.below(2) == 0);
  };
  switch (dice.below(5)) {
    case 0:
      return box(kLow, kHigh, dice.below(2) == 0);
    case 1:
      return box(kLow, kHigh) * random_half_space();
    case 2:
      return plane(0, 0, 1, -1) * random_half_space() * random_half_space();
    case 3:
      return segment(random_ints(dice), {2, 1, 3});
    default:
      return random_half_space() * random_half_space();
  }
}

/// Of the grid that the cubes are on, so that it is part of a boundary more often than not.
Pair random_change(Dice& dice) {
  Ints p = random_ints(dice), q = random_ints(dice);
  if (p == q) return point(p);
  const std::size_t kind = dice.below(4);
  if (kind == 0) return point(p);
  if (kind == 1) return segment(p, q);
  if (kind == 2) return inner_segment(p, q);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (p[axis] > q[axis]) std::swap(p[axis], q[axis]);
  }
  return box(p, q);
}

TEST(Convexity, RandomSetsAgainstSegments) {
  constexpr std::uint64_t kSeed = 4711;
  Dice dice(kSeed);
  std::size_t convex = 0, others = 0;
  for (std::size_t round = 0; round < share_of(150); ++round) {
    Pair set = random_base(dice);
    for (std::size_t changes = dice.below(3); changes > 0; --changes) {
      const Pair change = random_change(dice);
      set = dice.below(2) == 0 ? set + change : set - change;
    }
    const bool claim = set.nef.is_convex();
    ++(claim ? convex : others);
    const SegmentOracle oracle(*set.twin);
    ASSERT_EQ(oracle.is_convex(dice, claim ? 200 : 3000), claim)
        << "seed " << kSeed << ", round " << round << ": " << to_text(*set.twin);
  }
  EXPECT_GT(convex, share_of(30));
  EXPECT_GT(others, share_of(30));
}

}  // namespace
}  // namespace plumb::testing::space_convexity_test
