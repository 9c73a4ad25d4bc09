// Areas and boundary rings of the faces of a complex, exactly.
//
// A sum of many fractions is expensive if their denominators differ. The area of a set is therefore
// summed over vertices and not over edges (VertexAreas), so that the long numbers of a crossing
// occur in one term, and the fractions are added in a balanced tree (rational_sum.h).
//
// The rings of a face skip edges that have the face on both sides. A ring is cut where it reaches a
// vertex again, so each ring is a simple cycle.
//
// Tested by tests/plane/nef2_test.cpp and tests/plane/map_overlay_test.cpp.

#include "plumb/plane/plane_measure.h"

#include <algorithm>
#include <utility>

#include "plumb/predicates/arithmetic/rational_sum.h"

namespace plumb {
namespace {

RationalPoint2 point(const PlaneComplex& c, VertexId v) {
  return exact(c.points, c.vertex_point[v]);
}

/// Returns twice the signed area of the triangle of the origin and a half-edge.
Rational twice_area_below(const PlaneComplex& c, HalfedgeId h) {
  const RationalPoint2 p = point(c, c.dcel.origin(h));
  const RationalPoint2 q = point(c, c.dcel.target(h));
  return p.x * q.y - p.y * q.x;
}

/// The area as a sum over vertices, not edges. The triangle of the origin and a piece from p to q
/// of the line through a and b has the area (t(q) - t(p)) (a x b) / 2, where a + t (b - a) are the
/// points of the line. So the long numbers of a vertex are in one term only, and two denominators
/// have hardly any common factor. Vertices that are ends of their lines, as in a polygon that
/// crosses nothing, have t = 0 or 1; their terms are short and are added apart.
class VertexAreas {
 public:
  VertexAreas(const PlaneComplex& complex, Context& context)
      : c_(complex), context_(context), charge_(context) {
    charge_.add(kVertexBytes * complex.vertex_count(), "the area");
    twice_.resize(complex.vertex_count());
  }

  Rational total() {
    for (std::size_t i = 0; i < c_.edge_count(); ++i) {
      if (i % kEdgesPerCheckpoint == 0) context_.checkpoint("area", i, c_.edge_count());
      const HalfedgeId h = first_half(EdgeId(i));
      const bool left = c_.mark(c_.dcel.face(h)), right = c_.mark(c_.dcel.face(twin(h)));
      if (left != right) add(left ? h : twin(h));
    }
    twice_.push_back(at_ends_.total());
    return sum_of_fractions(twice_, [&] { context_.checkpoint("area", 0, 1); }) / 2;
  }

 private:
  static constexpr std::size_t kEdgesPerCheckpoint = 64;
  // The memory of the numbers, and of their products on all levels.
  static constexpr std::uint64_t kVertexBytes = 512;

  /// Returns t of p = a + t (b - a).
  static Rational place_between(const RationalPoint2& a, const RationalPoint2& b,
                                const RationalPoint2& p) {
    return a.x != b.x ? (p.x - a.x) / (b.x - a.x) : (p.y - a.y) / (b.y - a.y);
  }

  void add(HalfedgeId h) {
    const PlaneLine line = c_.line[edge_of(h)];
    const RationalPoint2 a = c_.points.inputs.exact(line.a), b = c_.points.inputs.exact(line.b);
    const Rational moment = a.x * b.y - a.y * b.x;
    const auto add_part = [&](VertexId v, int sign) {
      const std::uint32_t at = c_.vertex_point[v];
      if (at == line.b) at_ends_.add(sign * moment);
      if (at == line.a || at == line.b) return;
      twice_[v] += sign * place_between(a, b, point(c_, v)) * moment;
    };
    add_part(c_.dcel.origin(h), -1);
    add_part(c_.dcel.target(h), 1);
  }

  const PlaneComplex& c_;
  Context& context_;
  MemoryCharge charge_;
  IdVector<VertexId, Rational> twice_;  // The term of each vertex, without ends of lines.
  RationalSum at_ends_;
};

bool is_along_frame(const PlaneComplex& c, LoopId l) {
  for (const HalfedgeId h : c.dcel.along(l)) {
    if (c.is_frame(h)) return true;
  }
  return false;
}

template <class Id>
std::size_t index_in(const std::vector<Id>& sorted, Id id) {
  return static_cast<std::size_t>(std::lower_bound(sorted.begin(), sorted.end(), id) -
                                  sorted.begin());
}

// The rings of one face. Edges that have the face on both sides are skipped. If a walk reaches a
// vertex again, the ring is cut there.
class FaceRings {
 public:
  FaceRings(const PlaneComplex& complex, FaceId face) : complex_(complex), face_(face) {
    for (const LoopId l : complex.dcel.loops_of(face)) {
      for (const HalfedgeId h : complex.dcel.along(l)) {
        if (is_border(h)) border_.push_back(h);
      }
    }
    std::sort(border_.begin(), border_.end());
    is_walked_.assign(border_.size(), 0);
    for (const HalfedgeId h : border_) corners_.push_back(complex.dcel.origin(h));
    std::sort(corners_.begin(), corners_.end());
    position_.assign(corners_.size(), kOff);
  }

  std::vector<std::vector<VertexId>> trace() {
    for (std::size_t i = 0; i < border_.size(); ++i) {
      if (is_walked_[i] == 0) walk(border_[i]);
    }
    return std::move(rings_);
  }

 private:
  static constexpr std::size_t kOff = static_cast<std::size_t>(-1);

  bool is_border(HalfedgeId h) const { return complex_.dcel.face(twin(h)) != face_; }
  HalfedgeId next_border(HalfedgeId h) const {
    HalfedgeId n = complex_.dcel.next(h);
    while (!is_border(n)) n = complex_.dcel.next(twin(n));
    return n;
  }

  void walk(HalfedgeId start) {
    HalfedgeId h = start;
    do {
      is_walked_[index_in(border_, h)] = 1;
      visit(complex_.dcel.origin(h));
      h = next_border(h);
    } while (h != start);
    cut(0);
  }
  void visit(VertexId v) {
    std::size_t& seen = position_[index_in(corners_, v)];
    if (seen != kOff) cut(seen);
    seen = walk_.size();
    walk_.push_back(v);
  }
  void cut(std::size_t from) {
    const auto begin = walk_.begin() + static_cast<std::ptrdiff_t>(from);
    for (auto v = begin; v != walk_.end(); ++v) position_[index_in(corners_, *v)] = kOff;
    rings_.emplace_back(begin, walk_.end());
    walk_.erase(begin, walk_.end());
  }

  const PlaneComplex& complex_;
  FaceId face_;
  std::vector<HalfedgeId> border_;  // The half-edges of the border, sorted.
  std::vector<std::uint8_t> is_walked_;
  std::vector<VertexId> corners_;  // Their origins, sorted, with repetitions.
  std::vector<std::size_t>
      position_;  // The place of each vertex in walk_, by its first index in corners_.
  std::vector<VertexId> walk_;
  std::vector<std::vector<VertexId>> rings_;
};

/// Whether a ring is counter-clockwise. The turn at its least vertex decides.
bool is_counter_clockwise(const PlaneComplex& c, const std::vector<VertexId>& ring) {
  const auto least = std::min_element(ring.begin(), ring.end());
  const VertexId before = least == ring.begin() ? ring.back() : *(least - 1);
  const VertexId after = least + 1 == ring.end() ? ring.front() : *(least + 1);
  const auto edge_line = [&](VertexId to) {
    for (const HalfedgeId h : c.dcel.around(*least)) {
      if (c.dcel.target(h) == to) return c.line[edge_of(h)];
    }
    return PlaneLine{};
  };
  const PlaneLine out = edge_line(after);
  const PlaneLine in = edge_line(before);
  return cross_sign(c.points.inputs, out.a, out.b, in.a, in.b) == Sign::Positive;
}

}  // namespace

std::optional<Rational> face_area(const PlaneComplex& complex, FaceId f) {
  if (is_unbounded(complex, f)) return std::nullopt;
  RationalSum sum;
  for (const LoopId l : complex.dcel.loops_of(f)) {
    for (const HalfedgeId h : complex.dcel.along(l)) {
      if (complex.dcel.face(twin(h)) != f) sum.add(twice_area_below(complex, h));
    }
  }
  return sum.total() / 2;
}

std::optional<Rational> marked_area(const PlaneComplex& complex, Context& context) {
  for (std::size_t f = 0; f < complex.face_count(); ++f) {
    if (complex.mark(FaceId(f)) && is_unbounded(complex, FaceId(f))) return std::nullopt;
  }
  return VertexAreas(complex, context).total();
}

std::vector<std::vector<VertexId>> face_rings(const PlaneComplex& complex, FaceId f) {
  std::vector<std::vector<VertexId>> rings = FaceRings(complex, f).trace();
  std::stable_partition(rings.begin(), rings.end(), [&](const std::vector<VertexId>& ring) {
    return is_counter_clockwise(complex, ring);
  });
  return rings;
}

bool is_unbounded(const PlaneComplex& complex, FaceId f) {
  if (f == FaceId(0)) return true;
  for (const LoopId l : complex.dcel.loops_of(f)) {
    if (is_along_frame(complex, l)) return true;
  }
  return false;
}

}  // namespace plumb
