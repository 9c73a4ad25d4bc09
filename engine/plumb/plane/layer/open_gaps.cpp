// Finds bridges, and decides about the cells between them.
//
// The places of bridges are decided in doubles. They select some of many similar cuts, and no cut
// needs to end exactly at a given place. A bridge that ends inside of an edge extends a little into
// the feature behind the edge, so that the exact arrangement finds the crossing. If a bridge leaves
// the open face sooner, or ends too soon, it cuts off a different part, or none. The parts that are
// cut off are measured exactly, and only the measures decide.
//
// A bridge inside a gap has no effect, because the gap has one owner. So a bridge beside a shorter
// bridge may be left out. If the number of border edges within the width is bounded, this leaves
// O(n) bridges.
//
// Tested by tests/plane/open_gaps_test.cpp.
#include "plumb/plane/layer/open_gaps.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <tuple>
#include <utility>

#include "plumb/base/internal/box_tree.h"
#include "plumb/plane/plane_measure.h"
#include "plumb/predicates/arithmetic/rational_sum.h"
#include "plumb/predicates/rounding.h"

namespace plumb {
namespace {

constexpr std::uint32_t kOpen = LayerRegion::kNobody;
constexpr std::size_t kPairsPerCheckpoint = 1024;
// The greatest part of the border of a gap that its mouths may make up.
constexpr double kMostMouth = 1.0 / 2;

Point2 minus(Point2 a, Point2 b) { return {a.x - b.x, a.y - b.y}; }
double dot(Point2 a, Point2 b) { return a.x * b.x + a.y * b.y; }
double cross(Point2 a, Point2 b) { return a.x * b.y - a.y * b.x; }
double distance(Point2 a, Point2 b) { return std::hypot(a.x - b.x, a.y - b.y); }
Point2 between(Point2 a, Point2 b, double t) {
  return {a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)};
}

/// An edge between a feature and an open face, which lies on the left of ab.
struct BorderEdge {
  Point2 a, b;
  std::uint32_t first, second;  // The points a and b in the complex.
  std::uint32_t feature;
};

/// An end of a bridge.
struct BridgeEnd {
  Point2 at;
  // The point in the complex, or kNone if the end is inside of an edge.
  std::uint32_t point = kNone;
};

/// A bridge that begins at a corner.
struct BridgeDraft {
  BridgeEnd from, to;
  double length;
};

/// The point of an edge that is nearest to p, as a parameter that may lie outside of [0, 1].
double foot_on(const BorderEdge& edge, Point2 p) {
  const Point2 along = minus(edge.b, edge.a);
  return dot(minus(p, edge.a), along) / dot(along, along);
}

/// The foot of p on the line of an edge. If the edge is parallel to an axis, the direction from p
/// to its foot is exact.
Point2 foot_below(const BorderEdge& edge, Point2 p) {
  const Point2 along = minus(edge.b, edge.a);
  const double t = cross(along, minus(p, edge.a)) / dot(along, along);
  return {p.x + t * along.y, p.y - t * along.x};
}

bool faces(const BorderEdge& edge, Point2 p) {
  return cross(minus(edge.b, edge.a), minus(p, edge.a)) > 0;
}

/// Finds the bridges between pairs of edges.
class BridgeSearch {
 public:
  BridgeSearch(const PlaneComplex& complex, std::span<const std::uint32_t> owner, double below,
               Context& context)
      : complex_(complex), below_(below), context_(context), memory_(context) {
    for (std::size_t e = 0; e < complex.edge_count(); ++e) add_edge(EdgeId(e), owner);
  }

  Bridges find() {
    visit_pairs();
    keep_short_drafts();
    for (const BridgeDraft& draft : drafts_) add_bridge(draft);
    return std::move(bridges_);
  }

 private:
  void add_edge(EdgeId e, std::span<const std::uint32_t> owner);
  Box3 box_around(const BorderEdge& edge) const;
  void visit_pairs();
  void meet(const BorderEdge& e, const BorderEdge& f);
  void cross_from(const BridgeEnd& corner, const BorderEdge& f, std::uint32_t shared);
  void cross_at_bound(const BorderEdge& e, const BorderEdge& f, std::uint32_t shared);
  void add_draft(const BridgeEnd& from, const BridgeEnd& to);
  void keep_short_drafts();
  void add_bridge(const BridgeDraft& draft);
  std::uint32_t end_of(const BridgeEnd& end, Point2 other);

  const PlaneComplex& complex_;
  double below_;
  Context& context_;
  MemoryCharge memory_;
  std::vector<BorderEdge> edges_;
  std::vector<BridgeDraft> drafts_;
  Bridges bridges_;
};

void BridgeSearch::add_edge(EdgeId e, std::span<const std::uint32_t> owner) {
  const HalfedgeId h = first_half(e);
  const std::uint32_t left = owner[complex_.dcel.face(h).value()];
  const std::uint32_t right = owner[complex_.dcel.face(twin(h)).value()];
  if ((left == kOpen) == (right == kOpen)) return;
  const HalfedgeId along = left == kOpen ? h : twin(h);
  const std::uint32_t a = complex_.vertex_point[complex_.dcel.origin(along)];
  const std::uint32_t b = complex_.vertex_point[complex_.dcel.target(along)];
  edges_.push_back(
      {approx(complex_.points, a), approx(complex_.points, b), a, b, left == kOpen ? right : left});
}

/// Returns a box that meets the box of another edge if the edges are closer than the bound.
Box3 BridgeSearch::box_around(const BorderEdge& edge) const {
  const double margin = below_ / 2;
  Box3 box;
  box.low = {std::min(edge.a.x, edge.b.x) - margin, std::min(edge.a.y, edge.b.y) - margin, 0};
  box.high = {std::max(edge.a.x, edge.b.x) + margin, std::max(edge.a.y, edge.b.y) + margin, 0};
  return box;
}

void BridgeSearch::visit_pairs() {
  constexpr std::size_t kTreeBytes = 76;
  memory_.add(edges_.size() * (sizeof(BorderEdge) + sizeof(Box3) + kTreeBytes), "open gaps");
  std::vector<Box3> boxes;
  boxes.reserve(edges_.size());
  for (const BorderEdge& edge : edges_) boxes.push_back(box_around(edge));
  const BoxTree tree(boxes);
  std::size_t pairs = 0;
  tree.for_each_pair_inside([&](std::uint32_t i, std::uint32_t j) {
    if (pairs++ % kPairsPerCheckpoint == 0) context_.checkpoint("open gaps", 0, 0);
    if (edges_[i].feature != edges_[j].feature) {
      meet(edges_[std::min(i, j)], edges_[std::max(i, j)]);
    }
  });
}

/// Adds the bridges between two edges of different features.
void BridgeSearch::meet(const BorderEdge& e, const BorderEdge& f) {
  const std::uint32_t shared = e.first == f.second   ? e.first
                               : e.second == f.first ? e.second
                                                     : kNone;
  cross_from({e.a, e.first}, f, shared);
  cross_from({e.b, e.second}, f, shared);
  cross_from({f.a, f.first}, e, shared);
  cross_from({f.b, f.second}, e, shared);
  cross_at_bound(e, f, shared);
  cross_at_bound(f, e, shared);
}

/// Whether a bridge from p to q cuts off a triangle that is a short dent, in which two edges of its
/// border meet at a corner.
bool is_dent(Point2 p, Point2 q, Point2 corner) {
  return distance(p, q) > kMostMouth * (distance(p, corner) + distance(corner, q));
}

/// Adds the bridge from a corner to the nearest point of f. The edges may have an end in common.
void BridgeSearch::cross_from(const BridgeEnd& corner, const BorderEdge& f, std::uint32_t shared) {
  if (corner.point == f.first || corner.point == f.second) return;
  const double t = foot_on(f, corner.at);
  if (!(t > 0)) {
    if (f.first != shared) add_draft(corner, {f.a, f.first});
    return;
  }
  if (!(t < 1)) {
    if (f.second != shared) add_draft(corner, {f.b, f.second});
    return;
  }
  if (!faces(f, corner.at)) return;
  const BridgeEnd foot{foot_below(f, corner.at)};
  if (shared != kNone && is_dent(corner.at, foot.at, shared == f.first ? f.a : f.b)) return;
  add_draft(corner, foot);
}

/// Adds the bridge from a point inside of e to a point inside of f, at the place where the distance
/// of e and f reaches the bound. It cuts off the part of a channel that is too wide.
void BridgeSearch::cross_at_bound(const BorderEdge& e, const BorderEdge& f, std::uint32_t shared) {
  constexpr double kAllowed = 1 - 1e-6;
  const Point2 along = minus(f.b, f.a);
  const double length = std::hypot(along.x, along.y);
  const double at_a = cross(along, minus(e.a, f.a)) / length;
  const double at_b = cross(along, minus(e.b, f.a)) / length;
  const double t = (kAllowed * below_ - at_a) / (at_b - at_a);
  if (!(t > 0 && t < 1)) return;
  const Point2 p = between(e.a, e.b, t);
  const double s = foot_on(f, p);
  if (!(s > 0 && s < 1)) return;
  const BridgeEnd foot{foot_below(f, p)};
  if (shared != kNone && is_dent(p, foot.at, shared == f.first ? f.a : f.b)) return;
  if (faces(e, foot.at)) add_bridge({{p}, foot, distance(p, foot.at)});
}

void BridgeSearch::add_draft(const BridgeEnd& from, const BridgeEnd& to) {
  const double length = distance(from.at, to.at);
  if (length < below_ && length > 0) drafts_.push_back({from, to, length});
}

/// For each corner, keeps the bridges that have no shorter bridge near them. This means that the
/// disc around a bridge contains no end of a shorter bridge. Each bridge between two corners is
/// kept once.
void BridgeSearch::keep_short_drafts() {
  const auto key = [](const BridgeDraft& d) {
    return std::tuple(d.from.point, d.length, d.to.point, d.to.at.x, d.to.at.y);
  };
  memory_.add(drafts_.size() * sizeof(BridgeDraft), "open gaps");
  std::sort(drafts_.begin(), drafts_.end(),
            [&](const BridgeDraft& a, const BridgeDraft& b) { return key(a) < key(b); });
  std::size_t kept = 0, group = 0;
  for (std::size_t i = 0; i < drafts_.size(); ++i) {
    const BridgeDraft draft = drafts_[i];
    if (kept == 0 || drafts_[kept - 1].from.point != draft.from.point) group = kept;
    bool is_kept = true;
    for (std::size_t k = group; k < kept && is_kept; ++k) {
      const Point2 q = drafts_[k].to.at;
      is_kept = key(drafts_[k]) != key(draft) &&
                !(dot(minus(draft.from.at, q), minus(draft.to.at, q)) < 0);
    }
    if (is_kept) drafts_[kept++] = draft;
  }
  drafts_.resize(kept);
}

void BridgeSearch::add_bridge(const BridgeDraft& draft) {
  const std::uint32_t from = end_of(draft.from, draft.to.at);
  bridges_.segments.push_back({from, end_of(draft.to, draft.from.at)});
}

/// Returns the point at which a bridge ends. It is a corner, or a point beyond the edge, seen from
/// the other end. A bridge that ends in a crossing is prolonged, too, because the exact coordinates
/// of crossings are long.
std::uint32_t BridgeSearch::end_of(const BridgeEnd& end, Point2 other) {
  constexpr double kBeyond = 1.0 / 64, kRounding = 0x1p-48;
  const PointTable2& inputs = complex_.points.inputs;
  if (end.point >= inputs.size()) {
    const double most = std::max(std::fabs(end.at.x), std::fabs(end.at.y));
    const double beyond = std::max(kBeyond, kRounding * most / distance(end.at, other));
    bridges_.points.push_back(between(other, end.at, 1 + beyond));
  } else if (inputs.is_double(end.point)) {
    bridges_.points.push_back(end.at);
  } else {
    const RationalPoint2 corner = inputs.exact(end.point);
    bridges_.points.push_back(corner.x, corner.y);
  }
  return static_cast<std::uint32_t>(bridges_.points.size() - 1);
}

/// The data about a class of open faces.
struct OpenCell {
  double area = 0;
  double perimeter = 0;
  bool is_narrow = false;
};

/// The data about a class of narrow cells.
struct NarrowRegion {
  double area = 0;
  double border = 0;  // The length along features.
  double mouths = 0;  // The length of the bridges to cells that are not narrow.
  std::uint32_t feature = kOpen;
  bool has_two_features = false;

  void add_features(FeatureList features) {
    for (const std::uint32_t f : features) {
      has_two_features = has_two_features || (feature != kOpen && feature != f);
      feature = f;
    }
  }
  bool is_gap(const OpenGapRule& rule) const {
    const double perimeter = border + mouths, width = 2 * area / perimeter;
    if (!has_two_features || !(mouths > 0) || mouths > kMostMouth * border) return false;
    if (!(width < rule.below)) return false;
    return !rule.is_default || width < rule.rounding || width * width / area < rule.slender;
  }
};

/// Joins open faces across bridges.
class OpenCellJoin {
 public:
  OpenCellJoin(const CoveredCells& cells, UnionFind& classes, const OpenGapRule& rule,
               Context& context)
      : cells_(cells),
        complex_(cells.complex()),
        classes_(classes),
        rule_(rule),
        context_(context),
        cell_(complex_.face_count()),
        regions_(complex_.face_count()),
        region_(complex_.face_count()),
        is_gap_(complex_.face_count(), 0) {}

  std::vector<std::uint8_t> join();

 private:
  /// Calls visit(e, cell on the left, cell on the right) for the edges between different cells.
  template <class Visit>
  void for_each_border(const Visit& visit) {
    for (std::size_t e = 0; e < complex_.edge_count(); ++e) {
      const HalfedgeId h = first_half(EdgeId(e));
      const std::uint32_t l = classes_.root(complex_.dcel.face(h).value());
      const std::uint32_t r = classes_.root(complex_.dcel.face(twin(h)).value());
      if (l != r) visit(EdgeId(e), l, r);
    }
  }
  double length_of_edge(EdgeId e) const {
    const HalfedgeId h = first_half(e);
    return distance(approx(complex_.points, complex_.vertex_point[complex_.dcel.origin(h)]),
                    approx(complex_.points, complex_.vertex_point[complex_.dcel.target(h)]));
  }
  bool is_open(std::uint32_t face) const { return cells_.features(FaceId(face)).empty(); }
  void find_bridges();
  void measure_cells();
  void measure_regions();
  void add_border(std::uint32_t cell, std::uint32_t beyond, double length);
  void join_cells();

  /// A bridge between two open cells.
  struct Link {
    std::uint32_t l, r;
    double length;
  };

  const CoveredCells& cells_;
  const PlaneComplex& complex_;
  UnionFind& classes_;
  const OpenGapRule& rule_;
  Context& context_;
  std::vector<Link> links_;
  std::vector<OpenCell> cell_;  // For each root of a class.
  UnionFind regions_;           // Unites the roots of narrow cells.
  std::vector<NarrowRegion> region_;
  std::vector<std::uint8_t> is_gap_;
};

std::vector<std::uint8_t> OpenCellJoin::join() {
  find_bridges();
  measure_cells();
  measure_regions();
  join_cells();
  return std::move(is_gap_);
}

/// Finds the bridges. Marks the cells at bridges, except the outside, so that they are measured.
void OpenCellJoin::find_bridges() {
  for_each_border([&](EdgeId e, std::uint32_t l, std::uint32_t r) {
    if (!cells_.is_open_bridge(e)) return;
    links_.push_back({l, r, length_of_edge(e)});
    for (const std::uint32_t c : {l, r}) cell_[c].is_narrow = c != 0;
  });
}

void OpenCellJoin::measure_cells() {
  if (links_.empty()) return;
  std::vector<RationalSum> area(cell_.size());
  for (std::uint32_t f = 1; f < cell_.size(); ++f) {
    if (f % kFacesPerCheckpoint == 0) context_.checkpoint("open gaps", f, cell_.size());
    const std::uint32_t c = classes_.root(f);
    if (cell_[c].is_narrow) area[c].add(face_area(complex_, FaceId(f)).value_or(0));
  }
  for_each_border([&](EdgeId e, std::uint32_t l, std::uint32_t r) {
    for (const std::uint32_t c : {l, r}) {
      if (cell_[c].is_narrow) cell_[c].perimeter += length_of_edge(e);
    }
  });
  for (std::size_t c = 0; c < cell_.size(); ++c) {
    if (!cell_[c].is_narrow) continue;
    cell_[c].area = nearest_double(area[c].total());
    cell_[c].is_narrow = 2 * cell_[c].area < rule_.below * cell_[c].perimeter;
  }
}

/// Unites narrow cells that share a bridge, and measures the united cells.
void OpenCellJoin::measure_regions() {
  for (const Link& link : links_) {
    if (cell_[link.l].is_narrow && cell_[link.r].is_narrow) regions_.unite(link.l, link.r);
  }
  for (std::uint32_t c = 0; c < cell_.size(); ++c) {
    if (cell_[c].is_narrow) region_[regions_.root(c)].area += cell_[c].area;
  }
  for (const Link& link : links_) {
    if (cell_[link.l].is_narrow == cell_[link.r].is_narrow) continue;
    region_[regions_.root(cell_[link.l].is_narrow ? link.l : link.r)].mouths += link.length;
  }
  for_each_border([&](EdgeId e, std::uint32_t l, std::uint32_t r) {
    if (cell_[l].is_narrow && !is_open(r)) add_border(l, r, length_of_edge(e));
    if (cell_[r].is_narrow && !is_open(l)) add_border(r, l, length_of_edge(e));
  });
}

void OpenCellJoin::add_border(std::uint32_t cell, std::uint32_t beyond, double length) {
  NarrowRegion& region = region_[regions_.root(cell)];
  region.border += length;
  region.add_features(cells_.features(FaceId(beyond)));
}

/// Unites the cells at both sides of each bridge that is not a mouth of a gap.
void OpenCellJoin::join_cells() {
  const auto is_of_gap = [&](std::uint32_t cell) {
    return cell_[cell].is_narrow && region_[regions_.root(cell)].is_gap(rule_);
  };
  std::vector<std::uint32_t> gaps;
  for (const Link& link : links_) {
    const bool is_left = is_of_gap(link.l), is_right = is_of_gap(link.r);
    if (is_left == is_right) classes_.unite(link.l, link.r);
    if (is_left) gaps.push_back(link.l);
    if (is_right) gaps.push_back(link.r);
  }
  for (const std::uint32_t cell : gaps) is_gap_[classes_.root(cell)] = 1;
}

}  // namespace

Bridges open_gap_bridges(const PlaneComplex& complex, std::span<const std::uint32_t> owner,
                         double below, Context& context) {
  if (!(below > 0)) return {};
  return BridgeSearch(complex, owner, below, context).find();
}

std::vector<std::uint8_t> join_open_cells(const CoveredCells& cells, UnionFind& classes,
                                          const OpenGapRule& rule, Context& context) {
  return OpenCellJoin(cells, classes, rule, context).join();
}

}  // namespace plumb
