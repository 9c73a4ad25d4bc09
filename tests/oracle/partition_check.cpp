#include "oracle/partition_check.h"

#include <algorithm>
#include <array>

#include "plumb/predicates/rational_predicates.h"
#include "plumb/predicates/segment2.h"

namespace plumb::testing {
namespace {

std::size_t count_marked(const std::vector<std::uint8_t>& marks) {
  return static_cast<std::size_t>(std::ranges::count(marks, 1));
}

/// The open half-planes at the sides of the marked faces, intersected.
Nef2 kernel(const Nef2& piece) {
  const PlaneComplex& c = piece.complex();
  Nef2 kernel = Nef2::whole();
  for (std::uint32_t e = 0; e < c.edge_count(); ++e) {
    const HalfedgeId h = first_half(EdgeId(e));
    const Line2 up{c.points.inputs.exact(c.line[e].a), c.points.inputs.exact(c.line[e].b)};
    if (c.mark(c.dcel.face(h))) kernel *= Nef2::half_plane(up, Boundary::Open);
    if (c.mark(c.dcel.face(twin(h)))) kernel *= Nef2::half_plane({up.b, up.a}, Boundary::Open);
  }
  return kernel;
}

/// Of one dimension and, without its boundary, convex.
bool is_one_cell(const Nef2& piece) {
  const PlaneComplex& c = piece.complex();
  if (count_marked(c.marks.face) > 0) {
    return piece.interior() == kernel(piece) && piece.is_subset_of(piece.regularization());
  }
  if (count_marked(c.marks.edge) > 0) return c.edge_count() == 1 && c.vertex_count() <= 2;
  return c.vertex_count() == 1 && count_marked(c.marks.vertex) == 1;
}

Nef2 without_boundary(const Nef2& closed_piece) {
  PlaneMarks marks = closed_piece.complex().marks;
  if (count_marked(marks.face) > 0) return closed_piece.interior();
  if (count_marked(marks.edge) > 0) marks.vertex.assign(marks.vertex.size(), 0);
  return closed_piece.with_marks(marks);
}

}  // namespace

std::string flaw_of_partition(const Nef2& set, const PlanePieces& pieces, bool closed) {
  Context context;
  std::size_t i = 0;
  for (const Nef2& piece : pieces.pieces) {
    const std::string name = "piece " + std::to_string(i++) + " ";
    if (const auto flaw = piece.audit()) return name + flaw->invariant + " " + flaw->place;
    if (!is_one_cell(piece)) return name + "is not convex, or of several dimensions";
  }
  if (union_of(pieces.pieces, context) != (closed ? set.closure() : set)) {
    return "the union is another set";
  }
  for (std::size_t k = 0; k < pieces.pieces.size(); ++k) {
    for (std::size_t j = 0; j < k; ++j) {
      const Nef2 &a = pieces.pieces[j], &b = pieces.pieces[k];
      const Nef2 common = closed ? without_boundary(a) * without_boundary(b) : a * b;
      if (!common.is_empty()) {
        return "pieces " + std::to_string(j) + " and " + std::to_string(k) + " meet";
      }
    }
  }
  return do_areas_add_up(set, pieces.pieces, context).value_or(true) ? ""
                                                                     : "the areas do not add up";
}

// ---------------------------------------------------------------- all sets of diagonals

namespace {

using Pair = std::array<std::size_t, 2>;

class AllDiagonals {
 public:
  explicit AllDiagonals(const PolygonWithHoles2& polygon) {
    add_ring(polygon.outer);
    for (const auto& hole : polygon.holes) add_ring(hole);
    rings_ = 1 + polygon.holes.size();
    for (std::size_t i = 0; i < points_.size(); ++i) {
      for (std::size_t j = i + 1; j < points_.size(); ++j) {
        if (is_diagonal({i, j})) diagonals_.push_back({i, j});
      }
    }
    fill_tables();
  }

  std::size_t fewest() {
    best_ = diagonals_.size() + 1;
    choose(0, 0);
    return best_ + 2 - rings_;  // one diagonal joins each hole, each other one parts a piece
  }

 private:
  void add_ring(const std::vector<RationalPoint2>& ring) {
    const std::size_t begin = points_.size(), n = ring.size();
    for (std::size_t i = 0; i < n; ++i) sides_.push_back({begin + i, begin + (i + 1) % n});
    points_.insert(points_.end(), ring.begin(), ring.end());
  }
  RationalSegment2 segment(Pair p) const { return {points_[p[0]], points_[p[1]]}; }

  bool is_diagonal(Pair p) const {
    for (const Pair& side : sides_) {
      const SegmentRelation r = relation(segment(p), segment(side));
      if (r != SegmentRelation::Disjoint && r != SegmentRelation::ShareEndpoint) return false;
    }
    const RationalPoint2 &a = points_[p[0]], &b = points_[p[1]];
    return is_inside({(a.x + b.x) / 2, (a.y + b.y) / 2});
  }
  bool is_inside(const RationalPoint2& p) const {
    bool is_in = false;
    for (const Pair& side : sides_) {
      const RationalPoint2 &a = points_[side[0]], &b = points_[side[1]];
      if ((a.y > p.y) == (b.y > p.y)) continue;
      if (orient2d(a, b, p) == (b.y > a.y ? Sign::Positive : Sign::Negative)) is_in = !is_in;
    }
    return is_in;
  }

  /// What the search asks again and again.
  void fill_tables() {
    const std::size_t n = points_.size();
    for (std::size_t i = 0; i < n * n * n; ++i) {
      turns_.push_back(orient2d(points_[i / n / n], points_[i / n % n], points_[i % n]));
    }
    for (const Pair& a : diagonals_) {
      for (const Pair& b : diagonals_) {
        const SegmentRelation r = relation(segment(a), segment(b));
        const bool is_apart = r == SegmentRelation::Disjoint || r == SegmentRelation::ShareEndpoint;
        crossings_.push_back(is_apart ? 0 : 1);
      }
    }
  }
  Sign turn(std::size_t a, std::size_t b, std::size_t c) const {
    const std::size_t n = points_.size();
    return turns_[(a * n + b) * n + c];
  }

  /// Diagonals are sorted by their first end: of a vertex below that of the next one, all are
  /// decided. Where every wedge is convex no hole is left apart, as its outermost vertex would have
  /// one that is not.
  void choose(std::size_t at, std::size_t vertex) {
    if (chosen_.size() >= best_) return;
    const bool is_end = at == diagonals_.size();
    for (; vertex < (is_end ? points_.size() : diagonals_[at][0]); ++vertex) {
      if (!are_wedges_convex(vertex)) return;
    }
    if (is_end) {
      best_ = chosen_.size();
      return;
    }
    choose(at + 1, vertex);
    const auto crosses = [&](std::size_t i) { return crossings_[i * diagonals_.size() + at] != 0; };
    if (std::ranges::any_of(chosen_, crosses)) return;
    chosen_.push_back(at);
    choose(at + 1, vertex);
    chosen_.pop_back();
  }

  bool are_wedges_convex(std::size_t v) const {
    std::size_t out = v, in = v;
    std::vector<std::size_t> ends;
    for (const Pair& s : sides_) {
      if (s[0] == v) out = s[1];
      if (s[1] == v) in = s[0];
    }
    for (const std::size_t i : chosen_) {
      const Pair& d = diagonals_[i];
      if (d[0] == v || d[1] == v) ends.push_back(d[0] == v ? d[1] : d[0]);
    }
    std::ranges::sort(ends, [&](std::size_t a, std::size_t b) {
      const bool far_a = is_beyond_half(v, out, a), far_b = is_beyond_half(v, out, b);
      if (far_a != far_b) return far_b;
      return turn(v, a, b) == Sign::Positive;
    });
    ends.push_back(in);
    std::size_t from = out;
    for (const std::size_t to : ends) {
      if (is_beyond_half(v, from, to)) return false;
      from = to;
    }
    return true;
  }
  /// More than half a turn from one to the other?
  bool is_beyond_half(std::size_t v, std::size_t from, std::size_t to) const {
    return turn(v, from, to) == Sign::Negative;
  }

  std::vector<RationalPoint2> points_;
  std::vector<Pair> sides_, diagonals_;
  std::vector<Sign> turns_;              // of three points each
  std::vector<std::uint8_t> crossings_;  // of two diagonals each
  std::vector<std::size_t> chosen_;      // diagonals
  std::size_t rings_ = 0;
  std::size_t best_ = 0;
};

}  // namespace

std::size_t fewest_pieces_by_diagonals(const PolygonWithHoles2& polygon) {
  return AllDiagonals(polygon).fewest();
}

}  // namespace plumb::testing
