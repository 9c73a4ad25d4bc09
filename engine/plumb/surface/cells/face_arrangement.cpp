// The arrangement of segments within one face of a surface, in the plane of the face's parameters.
//
// Segments are compared in pairs whose boxes meet. Crossings stay implicit, as two segments; equal
// crossings are united as neighbours in the order along a segment. This finds all equal crossings,
// because any two segments through a point meet there (docs/design/surface.md, section Slicing,
// Lemma 1). So no predicate compares two crossings except along a common segment, and the degree
// stays 5.
//
// The boundary of the face is part of the arrangement: half-edges r < ring_size run along it.
// Components that do not reach it (islands) are holes of some piece. It is the piece above the arc
// just below their leftmost point, found by looking at every arc if there are few islands, else by
// a sweep from left to right whose status holds the arcs over the current point in order. Arcs do
// not cross, so that order is well defined.
// Tested by tests/surface/surface_plane_test.cpp and tests/surface/surface_arrangement_test.cpp.
#include "plumb/surface/cells/face_arrangement.h"

#include <algorithm>
#include <iterator>
#include <numeric>
#include <set>
#include <tuple>
#include <utility>

#include "plumb/base/internal/union_find.h"
#include "plumb/predicates/rounding.h"

namespace plumb {
namespace {

// If there are at most so many segments, all pairs are compared.
constexpr std::size_t kFewSegments = 32;
// The memory of a contact, with its share of a crossing.
constexpr std::uint64_t kContactBytes = 64;
constexpr double kRough = 0x1p-44;
// If there are at most so many islands, each examines every arc.
constexpr std::size_t kFewIslands = 8;
constexpr std::uint32_t kPointsPerCheckpoint = 4096;

Box3 box_of(const PlanePoints& points, const FaceSegment& s) {
  const Point2 a = points.inputs.approx(s.from), b = points.inputs.approx(s.to);
  Box3 box;
  box.low = {std::min(a.x, b.x), std::min(a.y, b.y), 0};
  box.high = {std::max(a.x, b.x), std::max(a.y, b.y), 0};
  return box;
}

}  // namespace

void FaceArrangement::clear() {
  points.inputs = PointTable2();
  points.crossings.clear();
  ring_size = 0;
  corner_1 = 0;
  segments.clear();
  contacts_.clear();
  overlaps_ = false;
  arcs.clear();
}

void FaceArrangement::run(SurfaceBundles& bundles, Context& context) {
  orient_segments();
  find_contacts(context);
  const auto checkpoint = [&] {
    if (segments.size() + contacts_.size() > kPointsPerCheckpoint) {
      context.checkpoint("slice", 0, 1);
    }
  };
  checkpoint();
  split();
  checkpoint();
  if (overlaps_) merge_overlaps(bundles);
  link(context);
  checkpoint();
  trace_loops();
  nest(context);
}

// ---------------------------------------------------------------- contacts

void FaceArrangement::orient_segments() {
  for (FaceSegment& s : segments) {
    if (compare(s.from, s.to) == Sign::Negative) continue;
    std::swap(s.from, s.to);
    s.sign = -s.sign;
  }
}

/// Finds all contacts. Rounding is monotone: if boxes of rounded points are apart, so are the
/// segments.
void FaceArrangement::find_contacts(Context& context) {
  const auto n = static_cast<std::uint32_t>(segments.size());
  boxes_.clear();
  if (n > 1) {
    for (const FaceSegment& s : segments) boxes_.push_back(box_of(points, s));
  }
  if (n > kFewSegments) {
    MemoryCharge charge(context);
    std::size_t pairs = 0, charged = 0;
    BoxTree(boxes_).for_each_pair_inside([&](std::uint32_t s, std::uint32_t t) {
      meet(s, t);
      if (++pairs % 4096 != 0) return;
      context.checkpoint("contacts in a face", pairs, pairs);
      charge.add(kContactBytes * (contacts_.size() - charged), "contacts in a face");
      charged = contacts_.size();
    });
    return;
  }
  for (std::uint32_t s = 0; s < n; ++s) {
    for (std::uint32_t t = s + 1; t < n; ++t) {
      if (boxes_[s].meets(boxes_[t])) meet(s, t);
    }
  }
}

/// Whether the point lies strictly inside the segment. Requires that it is on the segment's line.
bool FaceArrangement::is_inside(std::uint32_t point, const FaceSegment& s) const {
  return compare(s.from, point) == Sign::Negative && compare(point, s.to) == Sign::Negative;
}

// Adds the contacts of two segments. Four sides decide. If both ends of one segment are on the same
// side of the other's line, there is no contact. A zero is an end on a line. Four zeros mean that
// the segments are collinear, and may overlap.
void FaceArrangement::meet(std::uint32_t s, std::uint32_t t) {
  const FaceSegment &p = segments[s], &q = segments[t];
  const auto touch = [&](bool is_on_line, std::uint32_t point, std::uint32_t segment) {
    const FaceSegment& on = segments[segment];
    if (is_on_line && point != on.from && point != on.to && is_inside(point, on)) {
      contacts_.push_back({segment, point});
      return true;
    }
    return false;
  };
  const Sign from = side(p, q.from);
  const Sign to = side(p, q.to);
  if (from == to && from != Sign::Zero) return;
  if (from == Sign::Zero && to == Sign::Zero) {
    const bool overlap[] = {touch(true, q.from, s), touch(true, q.to, s), touch(true, p.from, t),
                            touch(true, p.to, t)};
    if (overlap[0] || overlap[1] || overlap[2] || overlap[3]) overlaps_ = true;
    return;
  }
  const Sign from_back = side(q, p.from);
  const Sign to_back = side(q, p.to);
  if (from_back == to_back) return;
  if (from != Sign::Zero && to != Sign::Zero && from_back != Sign::Zero && to_back != Sign::Zero) {
    const auto id = static_cast<std::uint32_t>(points.size());
    points.crossings.push_back(make_crossing(points.inputs, p.from, p.to, q.from, q.to));
    contacts_.push_back({s, id});
    contacts_.push_back({t, id});
    return;
  }
  touch(from == Sign::Zero, q.from, s);
  touch(to == Sign::Zero, q.to, s);
  touch(from_back == Sign::Zero, p.from, t);
  touch(to_back == Sign::Zero, p.to, t);
}

// ---------------------------------------------------------------- pieces of segments

std::uint32_t FaceArrangement::representative(std::uint32_t point) const {
  while (!is_given(point)) {
    const std::uint32_t other = same_[point - points.inputs.size()];
    if (other == point) break;
    point = other;
  }
  return point;
}

/// Unites two points. Given points have the lower ids, so they become the representatives.
void FaceArrangement::unite(std::uint32_t i, std::uint32_t j) {
  i = representative(i);
  j = representative(j);
  if (i == j) return;
  if (i < j) std::swap(i, j);
  same_[i - points.inputs.size()] = j;
}

/// Rounds crossings of nearly parallel lines from their exact coordinates, because their
/// approximations are too inaccurate for measuring.
void FaceArrangement::sharpen() {
  for (Crossing2& c : points.crossings) {
    if (c.radius <= kRough) continue;
    const RationalPoint2 at = exact(points.inputs, c);
    c.x = nearest_double(at.x);
    c.y = nearest_double(at.y);
    c.radius = 0x1p-52;
  }
}

// Divides each segment at its contacts. First, consecutive contacts that are equal are united. Then
// arcs are made between the representatives.
void FaceArrangement::split() {
  sharpen();
  same_.resize(points.crossings.size());
  std::iota(same_.begin(), same_.end(), static_cast<std::uint32_t>(points.inputs.size()));
  std::sort(contacts_.begin(), contacts_.end(), [&](const Contact& a, const Contact& b) {
    if (a.segment != b.segment) return a.segment < b.segment;
    return a.point != b.point && compare(a.point, b.point) == Sign::Negative;
  });
  for (std::size_t i = 1; i < contacts_.size(); ++i) {
    const Contact &a = contacts_[i - 1], &b = contacts_[i];
    if (a.segment == b.segment && a.point != b.point && compare(a.point, b.point) == Sign::Zero) {
      unite(a.point, b.point);
    }
  }
  std::size_t at = 0;
  for (std::uint32_t s = 0; s < segments.size(); ++s) {
    const FaceSegment& segment = segments[s];
    std::uint32_t last = segment.from;
    const auto add = [&](std::uint32_t point) {
      if (point == last) return;
      arcs.push_back({last, point, s, segment.bundle, segment.sign});
      last = point;
    };
    for (; at < contacts_.size() && contacts_[at].segment == s; ++at) {
      add(representative(contacts_[at].point));
    }
    add(segment.to);
  }
}

void FaceArrangement::merge_overlaps(SurfaceBundles& bundles) {
  std::sort(arcs.begin(), arcs.end(), [](const FaceArc& a, const FaceArc& b) {
    return std::tie(a.from, a.to, a.segment) < std::tie(b.from, b.to, b.segment);
  });
  std::size_t kept = 0;
  for (std::size_t i = 0, j = 0; i < arcs.size(); i = j) {
    while (j < arcs.size() && arcs[j].from == arcs[i].from && arcs[j].to == arcs[i].to) ++j;
    FaceArc merged = arcs[i];
    if (j > i + 1) {
      terms_.clear();
      for (std::size_t k = i; k < j; ++k) {
        for (const SignedEntry& e : bundles[arcs[k].bundle]) {
          terms_.push_back({e.id, e.value * arcs[k].sign});
        }
      }
      if (!bundles.add_sum(terms_)) continue;
      merged.bundle = static_cast<std::uint32_t>(bundles.size() - 1);
      merged.sign = 1;
    }
    arcs[kept++] = merged;
  }
  arcs.resize(kept);
}

// ---------------------------------------------------------------- half-edges

/// Whether g precedes h, counter-clockwise, of two half-edges of arcs that leave the same point. On
/// the boundary, all half-edges lie within less than a half turn. At other points, the order begins
/// straight below.
bool FaceArrangement::turns_before(std::uint32_t g, std::uint32_t h) const {
  const bool is_on_ring = origin(g) < ring_size;
  const bool same_half = is_reverse(g) == is_reverse(h);
  if (!is_on_ring && !same_half) return is_reverse(h);
  const FaceSegment& s = segments[arcs[(g - ring_size) / 2].segment];
  const FaceSegment& t = segments[arcs[(h - ring_size) / 2].segment];
  const Sign turn = cross_sign(points.inputs, s.from, s.to, t.from, t.to);
  return turn == (same_half ? Sign::Positive : Sign::Negative);
}

/// Sorts half-edges by origin with a counting sort, and by angle around each point. The reverse of
/// a half-edge is followed by the half-edge before it in counter-clockwise order. On the boundary,
/// the ring closes the fan.
void FaceArrangement::link(Context& context) {
  const std::uint32_t n = halfedge_count();
  out_begin_.assign(points.size() + 1, 0);
  for (std::uint32_t h = ring_size; h < n; ++h) ++out_begin_[origin(h) + 1];
  for (std::uint32_t p = 0; p < points.size(); ++p) out_begin_[p + 1] += out_begin_[p];
  out_.resize(n - ring_size);
  for (std::uint32_t h = n; h-- > ring_size;) out_[--out_begin_[origin(h) + 1]] = h;
  // The half-edges of point p now begin at entry p + 1, that is, every entry is one place too far.
  out_begin_.erase(out_begin_.begin());
  out_begin_.push_back(n - ring_size);

  next.resize(n);
  for (std::uint32_t p = 0; p < points.size(); ++p) {
    if ((p + 1) % kPointsPerCheckpoint == 0) context.checkpoint("slice", 0, 1);
    const auto begin = out_.begin() + out_begin_[p], end = out_.begin() + out_begin_[p + 1];
    const auto degree = end - begin;
    const bool is_on_ring = p < ring_size;
    if (degree > (is_on_ring ? 1 : 2)) {
      std::sort(begin, end,
                [&](std::uint32_t g, std::uint32_t h) { return g != h && turns_before(g, h); });
    }
    for (auto i = begin; i != end; ++i) {
      const bool is_first = i == begin;
      next[reverse(*i)] = !is_first ? *(i - 1) : (is_on_ring ? p : *(end - 1));
    }
    if (is_on_ring) {
      next[p == 0 ? ring_size - 1 : p - 1] = degree > 0 ? *(end - 1) : p;
    }
  }
}

void FaceArrangement::trace_loops() {
  const std::uint32_t n = halfedge_count();
  loop_of_.assign(n, kNone);
  loops.clear();
  for (std::uint32_t first = 0; first < n; ++first) {
    if (loop_of_[first] != kNone) continue;
    const auto id = static_cast<std::uint32_t>(loops.size());
    loops.push_back({kNone, first, false});
    for (std::uint32_t h = first; loop_of_[h] == kNone; h = next[h]) loop_of_[h] = id;
  }
}

// ---------------------------------------------------------------- nesting

/// Finds the leftmost point of each component that does not reach the boundary, which is part 0.
void FaceArrangement::find_islands() {
  islands_.clear();
  if (points.size() == ring_size) return;
  UnionFind parts(points.size());
  for (std::uint32_t r = 1; r < ring_size; ++r) parts.unite(0, r);
  for (const FaceArc& a : arcs) parts.unite(a.from, a.to);
  for (std::uint32_t p = ring_size; p < points.size(); ++p) {
    if (out_begin_[p] != out_begin_[p + 1] && parts.root(p) != 0) islands_.push_back(p);
  }
  if (islands_.empty()) return;
  std::sort(islands_.begin(), islands_.end(), [&](std::uint32_t p, std::uint32_t q) {
    return p != q && compare(p, q) == Sign::Negative;
  });
  // The first point of each part is its leftmost.
  std::vector<std::uint8_t> is_seen(points.size());
  std::erase_if(islands_,
                [&](std::uint32_t p) { return std::exchange(is_seen[parts.root(p)], 1) != 0; });
}

/// Numbers pieces by their outer loops. A loop is a hole if it is the outside of an island. It then
/// belongs to the piece of the half-edge below the island.
void FaceArrangement::nest(Context& context) {
  find_islands();
  // The half-edge that leaves the leftmost point of an island last, in angular order, has the
  // outside of the island on its left. Points with only two half-edges have not been sorted, so the
  // function searches for the greatest half-edge.
  const auto outside_of = [&](std::uint32_t p) -> Loop& {
    const auto last =
        std::max_element(out_.begin() + out_begin_[p], out_.begin() + out_begin_[p + 1],
                         [&](std::uint32_t g, std::uint32_t h) { return turns_before(g, h); });
    return loops[loop_of_[*last]];
  };
  for (const std::uint32_t p : islands_) outside_of(p).is_hole = true;
  piece_count = 0;
  for (Loop& l : loops) {
    if (!l.is_hole) l.piece = piece_count++;
  }
  find_below(context);
  for (std::size_t i = 0; i < islands_.size(); ++i) {
    outside_of(islands_[i]).piece = loops[loop_of_[below_[i]]].piece;
  }
  piece.resize(halfedge_count());
  for (std::uint32_t h = 0; h < piece.size(); ++h) piece[h] = loops[loop_of_[h]].piece;
  if (islands_.empty()) return;
  std::stable_sort(loops.begin(), loops.end(), [](const Loop& a, const Loop& b) {
    return std::tie(a.piece, a.is_hole) < std::tie(b.piece, b.is_hole);
  });
}

/// Whether the arc passes below the point.
bool FaceArrangement::is_below(const FaceArc& a, std::uint32_t point) const {
  if (compare(a.from, point) != Sign::Negative) return false;
  if (compare(point, a.to) != Sign::Negative) return false;
  return side(segments[a.segment], point) == Sign::Positive;
}

/// Whether a is lower than b. Requires that the two arcs do not cross, and that a point exists
/// below which, or above which, both pass.
bool FaceArrangement::is_lower(const FaceArc& a, const FaceArc& b) const {
  const FaceSegment &s = segments[a.segment], &t = segments[b.segment];
  if (a.from == b.from) {
    return cross_sign(points.inputs, s.from, s.to, t.from, t.to) == Sign::Positive;
  }
  if (compare(a.from, b.from) == Sign::Negative) {
    return side(s, b.from) == Sign::Positive;
  }
  return side(t, a.from) == Sign::Negative;
}

/// Returns the half-edge along side 0, the lowest of all, below an inner point.
std::uint32_t FaceArrangement::side_below(std::uint32_t point) const {
  // The other sides lead back to the left.
  std::uint32_t low = 0, high = corner_1;
  while (high - low > 1) {
    const std::uint32_t middle = low + (high - low) / 2;
    (compare(middle, point) == Sign::Negative ? low : high) = middle;
  }
  return low;
}

/// Finds the highest half-edge that passes below each island's leftmost point.
void FaceArrangement::find_below(Context& context) {
  below_.assign(islands_.size(), kNone);
  if (islands_.empty()) return;
  if (islands_.size() > kFewIslands) {
    sweep_below(context);
    return;
  }
  for (std::size_t i = 0; i < islands_.size(); ++i) {
    std::uint32_t best = kNone;
    for (std::uint32_t a = 0; a < arcs.size(); ++a) {
      if (is_below(arcs[a], islands_[i]) && (best == kNone || is_lower(arcs[best], arcs[a]))) {
        best = a;
      }
    }
    below_[i] = best == kNone ? side_below(islands_[i]) : ring_size + 2 * best;
  }
}

/// Computes the same result by a sweep from left to right over all points. The status has the arcs
/// at the current point in order.
void FaceArrangement::sweep_below(Context& context) {
  struct Lower {
    using is_transparent = void;
    const FaceArrangement& in;
    struct Point {
      std::uint32_t id;
    };
    bool operator()(std::uint32_t a, std::uint32_t b) const {
      return a != b && in.is_lower(in.arcs[a], in.arcs[b]);
    }
    bool operator()(std::uint32_t a, Point p) const {
      return in.side(in.segments[in.arcs[a].segment], p.id) == Sign::Positive;
    }
  };
  using Status = std::set<std::uint32_t, Lower>;
  Status status(Lower{*this});
  std::vector<Status::iterator> place(arcs.size());
  std::size_t island = 0;
  const std::vector<std::uint32_t> order = points_in_order();
  for (std::size_t i = 0; i < order.size(); ++i) {
    if (i % kPointsPerCheckpoint == 0) context.checkpoint("nesting in a face", i, order.size());
    const std::uint32_t p = order[i];
    const auto leaving = std::span(out_).subspan(out_begin_[p], out_begin_[p + 1] - out_begin_[p]);
    for (const std::uint32_t h : leaving) {
      if (is_reverse(h)) status.erase(place[(h - ring_size) / 2]);
    }
    if (island < islands_.size() && islands_[island] == p) {
      const auto above = status.lower_bound(Lower::Point{p});
      below_[island++] =
          above == status.begin() ? side_below(p) : ring_size + 2 * *std::prev(above);
    }
    for (const std::uint32_t h : leaving) {
      if (!is_reverse(h)) place[(h - ring_size) / 2] = status.insert((h - ring_size) / 2).first;
    }
  }
}

/// Returns the points in which arcs end, from left to right.
std::vector<std::uint32_t> FaceArrangement::points_in_order() const {
  std::vector<std::uint32_t> order;
  for (std::uint32_t p = 0; p < points.size(); ++p) {
    if (out_begin_[p] != out_begin_[p + 1]) order.push_back(p);
  }
  std::sort(order.begin(), order.end(), [&](std::uint32_t p, std::uint32_t q) {
    return p != q && compare(p, q) == Sign::Negative;
  });
  return order;
}

}  // namespace plumb
