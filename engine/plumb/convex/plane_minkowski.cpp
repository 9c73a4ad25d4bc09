// Minkowski sums of sets of the plane by convolution.
//
// Directions are ordered by angle, beginning just after the direction straight down: first those
// that lead lexicographically upward, then the others. A convex ring begins at its
// lexicographically least corner, so its edges have ascending angles. The support of a direction d
// is the corner k with angle(edge k - 1) <= angle(d) < angle(edge k), cyclically. It is extreme to
// the right of d.
//
// Convolution follows the border of the first operand with the set on the left. Along an edge, the
// support of its direction is added. At a corner where the border turns left, the border of the
// convex ring is followed from the support of the incoming direction to the support of the outgoing
// direction. At a corner where the border turns right, the border of the ring is followed backward.
// All directions are compared by exact predicates on one table, which has the vertices of the first
// operand and then the corners of the ring.
//
// Tested by tests/convex/plane_minkowski_test.cpp.
#include "plumb/convex/plane_minkowski.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "plumb/convex/plane_partition.h"
#include "plumb/predicates/error.h"
#include "plumb/predicates/point_table2.h"

namespace plumb {
namespace {

constexpr std::size_t kCornersPerSumCheckpoint = 256;
constexpr std::uint64_t kBytesPerSumCorner = 120;  // The point has exact coordinates and an index.

// A ring with one corner is a point. A ring with two corners is a segment.
using ConvexRing = std::vector<RationalPoint2>;

/// Returns the corners of a closed convex set.
ConvexRing ring_of(const Nef2& convex, Context& context) {
  PlaneParts parts = convex.parts(context);
  if (!parts.polygons.empty()) return std::move(parts.polygons.front().outer);
  if (!parts.lines.empty()) return {parts.lines.front().front(), parts.lines.front().back()};
  return {parts.points.front()};
}

bool is_lexicographically_less(const RationalPoint2& a, const RationalPoint2& b) {
  const int by_x = a.x.compare(b.x);
  return by_x != 0 ? by_x < 0 : a.y < b.y;
}

/// The convolution of the border of a closed set with a convex ring.
class Convolution {
 public:
  Convolution(const PlaneComplex& set, ConvexRing ring, Context& context)
      : set_(set), ring_(std::move(ring)), context_(context), charge_(context) {
    std::rotate(ring_.begin(),
                std::min_element(ring_.begin(), ring_.end(), is_lexicographically_less),
                ring_.end());
    vertices_.reserve(set_.vertex_count());
    for (std::size_t v = 0; v < set_.vertex_count(); ++v) {
      vertices_.push_back(exact(set_.points, set_.vertex_point[VertexId(v)]));
      table_.push_back(vertices_.back().x, vertices_.back().y);
    }
    for (const RationalPoint2& corner : ring_) table_.push_back(corner.x, corner.y);
  }

  /// Returns the sum of the set and the convex hull of the ring.
  Nef2 enclosed() {
    for (std::size_t f = 0; f < set_.face_count(); ++f) {
      if (set_.mark(FaceId(f))) add_face(FaceId(f));
    }
    for (std::size_t e = 0; e < set_.edge_count(); ++e) {
      if (is_free(EdgeId(e))) add_edge(first_half(EdgeId(e)));
    }
    for (std::size_t v = 0; v < set_.vertex_count(); ++v) {
      if (set_.dcel.is_isolated(VertexId(v))) add_copy(VertexId(v));
    }
    return Nef2::polygons(points_, corners_, begin_, WindingRule::Positive, Boundary::Closed,
                          context_);
  }

 private:
  /// A direction from one point of the table to another.
  struct Direction {
    std::uint32_t from, to;
  };

  bool is_free(EdgeId e) const {
    const HalfedgeId h = first_half(e);
    return !set_.mark(set_.dcel.face(h)) && !set_.mark(set_.dcel.face(twin(h)));
  }
  Direction direction(HalfedgeId h) const {
    return {set_.dcel.origin(h).value(), set_.dcel.target(h).value()};
  }
  Direction ring_edge(std::size_t k) const {
    const auto first = static_cast<std::uint32_t>(vertices_.size());
    const std::size_t next = k + 1 < ring_.size() ? k + 1 : 0;
    return {first + static_cast<std::uint32_t>(k), first + static_cast<std::uint32_t>(next)};
  }
  bool leads_up(Direction d) const { return compare_xy(table_, d.from, d.to) == Sign::Negative; }
  Sign turn(Direction a, Direction b) const {
    return cross_sign(table_, a.from, a.to, b.from, b.to);
  }
  bool is_at_most(Direction a, Direction b) const {
    const bool up = leads_up(a);
    return up != leads_up(b) ? up : turn(a, b) != Sign::Negative;
  }
  /// Returns the support of a direction: its index in the ring.
  std::size_t support(Direction d) const {
    std::size_t less = 0, most = ring_.size();
    while (less < most) {
      const std::size_t middle = (less + most) / 2;
      if (is_at_most(ring_edge(middle), d)) {
        less = middle + 1;
      } else {
        most = middle;
      }
    }
    return less == ring_.size() ? 0 : less;
  }
  std::size_t after(std::size_t k) const { return k + 1 < ring_.size() ? k + 1 : 0; }
  std::size_t before(std::size_t k) const { return k != 0 ? k - 1 : ring_.size() - 1; }

  void add_face(FaceId f) {
    for (const LoopId l : set_.dcel.loops_of(f)) {
      const HalfedgeId first = set_.dcel.first(l).halfedge();
      add_copy(set_.dcel.origin(first));
      std::size_t at = support(direction(set_.dcel.prev(first)));
      for (const HalfedgeId h : set_.dcel.along(l)) at = turn_at(h, at);
      end_chain();
    }
  }
  /// Follows the ring at the origin of h, from `at` to the support of h. Returns this support.
  std::size_t turn_at(HalfedgeId h, std::size_t at) {
    const VertexId v = set_.dcel.origin(h);
    const Direction out = direction(h);
    const std::size_t end = support(out);
    const bool turns_left = turn(direction(set_.dcel.prev(h)), out) == Sign::Positive;
    push(v, at);
    while (at != end) {
      at = turns_left ? after(at) : before(at);
      push(v, at);
    }
    return end;
  }
  /// Adds the sum of an edge and the ring. Each end of the edge gets one half of the ring.
  void add_edge(HalfedgeId h) {
    const std::size_t right = support(direction(h));
    const std::size_t left = support(direction(twin(h)));
    for (std::size_t k = right; k != left; k = after(k)) push(set_.dcel.target(h), k);
    push(set_.dcel.target(h), left);
    for (std::size_t k = left; k != right; k = after(k)) push(set_.dcel.origin(h), k);
    push(set_.dcel.origin(h), right);
    end_chain();
  }
  /// Adds the ring at a vertex.
  void add_copy(VertexId v) {
    for (std::size_t k = 0; k < ring_.size(); ++k) push(v, k);
    end_chain();
  }

  void push(VertexId v, std::size_t k) {
    if (corners_.size() % kCornersPerSumCheckpoint == 0) {
      context_.checkpoint("sum", 0, 0);
      charge_.add(kCornersPerSumCheckpoint * kBytesPerSumCorner, "the Minkowski sum");
    }
    const RationalPoint2& a = vertices_[v.value()];
    corners_.push_back(static_cast<std::uint32_t>(points_.size()));
    points_.push_back(a.x + ring_[k].x, a.y + ring_[k].y);
  }
  void end_chain() { begin_.push_back(static_cast<std::uint32_t>(corners_.size())); }

  const PlaneComplex& set_;
  ConvexRing ring_;
  Context& context_;
  MemoryCharge charge_;
  std::vector<RationalPoint2> vertices_;  ///< The vertices of the set.
  PointTable2 table_;  ///< The vertices of the set, then the corners of the ring.
  PointTable2 points_;
  std::vector<std::uint32_t> corners_;
  std::vector<std::uint32_t> begin_ = {0};
};

/// Returns the sum of a closed set and the convex hull of a ring.
Nef2 sum_with_ring(const Nef2& set, const ConvexRing& ring, Context& context) {
  if (ring.size() > 1) return Convolution(set.complex(), ring, context).enclosed();
  AffineMap2 shift;
  shift.x0 = ring.front().x;
  shift.y0 = ring.front().y;
  return set.transformed(shift, context);
}

std::vector<Nef2> closed_pieces(const Nef2& set, Context& context) {
  return decompose(set, {PartitionMethod::Diagonals, true}, context).pieces;
}

Nef2 sum_of_closed(const Nef2& a, const Nef2& b, Context& context) {
  const std::vector<Nef2> pieces_a = closed_pieces(a, context);
  const std::vector<Nef2> pieces_b = closed_pieces(b, context);
  const bool splits_b = pieces_b.size() <= pieces_a.size();
  std::vector<Nef2> sums;
  for (const Nef2& piece : splits_b ? pieces_b : pieces_a) {
    sums.push_back(sum_with_ring(splits_b ? a : b, ring_of(piece, context), context));
  }
  return union_of(sums, context);
}

/// A relatively open convex cell.
struct OpenCell {
  Nef2 closure;
  ConvexRing ring;        ///< Corners of the closure.
  bool is_whole = false;  ///< Whether it is not in the border of another cell of its piece.
};

Nef2 closed_polygon(const ConvexRing& ring, Context& context) {
  PointTable2 points;
  std::vector<std::uint32_t> corners;
  for (const RationalPoint2& p : ring) {
    corners.push_back(static_cast<std::uint32_t>(points.size()));
    points.push_back(p.x, p.y);
  }
  const std::vector<std::uint32_t> begin{0, static_cast<std::uint32_t>(ring.size())};
  return Nef2::polygons(points, corners, begin, WindingRule::NonZero, Boundary::Closed, context);
}

/// Appends the marked cells of a convex piece.
void append_cells(const Nef2& piece, std::vector<OpenCell>& cells, Context& context) {
  const PlaneComplex& c = piece.complex();
  const auto at = [&](VertexId v) { return exact(c.points, c.vertex_point[v]); };
  const auto append = [&](ConvexRing ring, bool is_whole) {
    Nef2 closure = closed_polygon(ring, context);
    cells.push_back({std::move(closure), std::move(ring), is_whole});
  };
  const bool has_face = piece.counts().marked_faces != 0;
  const bool has_edge = c.edge_count() != 0;
  if (has_face) append(ring_of(piece.closure(context), context), true);
  for (std::size_t e = 0; e < c.edge_count(); ++e) {
    const HalfedgeId h = first_half(EdgeId(e));
    if (c.mark(EdgeId(e))) append({at(c.dcel.origin(h)), at(c.dcel.target(h))}, !has_face);
  }
  for (std::size_t v = 0; v < c.vertex_count(); ++v) {
    if (c.mark(VertexId(v))) append({at(VertexId(v))}, !has_face && !has_edge);
  }
}

std::vector<OpenCell> open_cells(const Nef2& set, Context& context) {
  const PlanePieces split = decompose(set, {PartitionMethod::Diagonals, false}, context);
  std::vector<OpenCell> cells;
  for (const Nef2& piece : split.pieces) append_cells(piece, cells, context);
  return cells;
}

/// Returns a closed convex set without its border, or without the ends of a segment.
Nef2 relative_interior(const Nef2& convex, Context& context) {
  if (convex.counts().marked_faces != 0) return convex.interior(context);
  if (convex.counts().edges == 0) return convex;
  PlaneMarks marks = convex.marks();
  std::fill(marks.vertex.begin(), marks.vertex.end(), std::uint8_t{0});
  return convex.with_marks(std::move(marks), context);
}

Nef2 sum_of_cells(const Nef2& a, const Nef2& b, Context& context) {
  const std::vector<OpenCell> cells_a = open_cells(a, context);
  const std::vector<OpenCell> cells_b = open_cells(b, context);
  const auto is_body = [](const OpenCell& cell) { return cell.ring.size() > 2; };
  std::vector<Nef2> sums;
  for (const OpenCell& s : cells_a) {
    for (const OpenCell& t : cells_b) {
      if ((is_body(s) && !t.is_whole) || (is_body(t) && !s.is_whole)) continue;
      context.checkpoint("sum", 0, 0);
      const Nef2 sum = sum_with_ring(s.closure, t.ring, context);
      sums.push_back(relative_interior(sum, context));
    }
  }
  return union_of(sums, context);
}

}  // namespace

Nef2 minkowski_sum(const Nef2& a, const Nef2& b, Context& context) {
  if (a.is_empty() || b.is_empty()) return Nef2::empty();
  if (!a.is_bounded() || !b.is_bounded()) {
    throw Error(ErrorCode::BadArgument, "a Minkowski sum needs bounded sets");
  }
  const bool are_closed = a.is_closed() && b.is_closed();
  return are_closed ? sum_of_closed(a, b, context) : sum_of_cells(a, b, context);
}

Nef2 minkowski_sum(std::span<const Nef2> sets, Context& context) {
  if (std::any_of(sets.begin(), sets.end(), [](const Nef2& set) { return set.is_empty(); })) {
    return Nef2::empty();
  }
  if (sets.empty()) return Nef2::point({0, 0});
  Nef2 sum = sets[0];
  for (const Nef2& set : sets.subspan(1)) sum = minkowski_sum(sum, set, context);
  return sum;
}

}  // namespace plumb
