// Local repair: rounds that find the edges that meet a moved edge, arrange only these edges, and
// round the crossings.
//
// Before each round all edges that have not moved meet only in common ends. A tree over the boxes
// of all edges finds the candidates for each moved edge, and exact relations of segments decide.
// Only edges that meet at other places are arranged, with a table of points of their own. In later
// rounds rounding to the nearest doubles may creep: a crossing of two long edges that are nearly
// parallel goes on by one ulp in each round. Therefore, in these rounds, all edges that pass a
// crossing within half a step are bent to it, as in snap rounding.
//
// The caller arranges all edges once more, so nothing depends on a repair that was too small.
//
// Tested by tests/plane/plane_rounding_test.cpp; docs/design/rounding.md has the proofs.

#include "plumb/plane/rounding/local_repair.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "plumb/base/internal/box_tree.h"
#include "plumb/plane/rounding/vertex_places.h"
#include "plumb/predicates/rounding.h"
#include "plumb/predicates/segment2.h"

namespace plumb {
namespace {

constexpr int kRoundsOfDoubles = 4;  // The number of rounds with rounding to the nearest doubles.
constexpr std::size_t kEdgesPerCheckpoint = 1024;

class LocalRepair {
 public:
  LocalRepair(LabelledEdges& scene, EdgeTrace& trace, Context& context)
      : scene_(scene), trace_(trace), context_(context) {}

  /// Makes one round. On return, `moved` has the edges that were moved in this round. Returns
  /// whether any edges had to be arranged.
  bool run(std::vector<std::uint32_t>& moved, int level) {
    find_meetings(moved);
    moved.clear();
    if (std::none_of(meets_.begin(), meets_.end(), [](std::uint8_t m) { return m != 0; })) {
      return false;
    }
    arrange_meeting_edges(moved, level);
    if (level > 0) bend_to_crossings(moved, level);
    return true;
  }

 private:
  Segment2 segment(std::uint32_t e) const {
    return {scene_.points[scene_.edges[e].from], scene_.points[scene_.edges[e].to]};
  }
  Box3 box(std::uint32_t e) const {
    const Segment2 s = segment(e);
    Box3 box;
    box.low = {s.source.x, std::min(s.source.y, s.target.y), 0};
    box.high = {s.target.x, std::max(s.source.y, s.target.y), 0};
    return box;
  }

  /// Finds the edges that meet a moved edge in a point other than a common end.
  void find_meetings(const std::vector<std::uint32_t>& moved) {
    std::vector<Box3> boxes;
    boxes.reserve(scene_.edges.size());
    for (std::uint32_t e = 0; e < scene_.edges.size(); ++e) boxes.push_back(box(e));
    const BoxTree tree(boxes);
    meets_.assign(scene_.edges.size(), 0);
    std::size_t done = 0;
    for (const std::uint32_t e : moved) {
      if (done++ % kEdgesPerCheckpoint == 0) context_.checkpoint("repair", done, moved.size());
      const Segment2 s = segment(e);
      tree.for_each_meeting(boxes[e], [&](std::uint32_t other) {
        if (other == e) return;
        const SegmentRelation how = relation(s, segment(other));
        if (how == SegmentRelation::Disjoint || how == SegmentRelation::ShareEndpoint) return;
        meets_[e] = meets_[other] = 1;
      });
    }
  }

  /// Replaces the edges that meet other edges by the pieces of their arrangement.
  void arrange_meeting_edges(std::vector<std::uint32_t>& moved, int level) {
    LabelledEdges part;
    std::vector<LabelledEdge> kept;
    for (std::uint32_t e = 0; e < scene_.edges.size(); ++e) {
      LabelledEdge edge = scene_.edges[e];
      if (meets_[e] == 0) {
        kept.push_back(edge);
        continue;
      }
      for (std::uint32_t* const end : {&edge.from, &edge.to}) {
        part.points.push_back(scene_.points[*end]);
        *end = static_cast<std::uint32_t>(part.points.size() - 1);
      }
      part.edges.push_back(edge);
    }
    const Arrangement arrangement = arrange_edges(part, context_);
    const EdgePieces pieces = pieces_of(part, arrangement, trace_);
    const std::vector<VertexPlace> places =
        places_of_crossings(arrangement.complex, level, context_);
    scene_.edges = std::move(kept);
    crossings_.clear();
    const auto first = static_cast<std::uint32_t>(scene_.points.size());
    for (const VertexPlace& place : places) {
      if (place.is_new) crossings_.push_back(static_cast<std::uint32_t>(scene_.points.size()));
      scene_.points.push_back(place.at);
    }
    for (LabelledEdge edge : pieces.edges) {
      const VertexPlace &from = places[edge.from], &to = places[edge.to];
      const bool has_moved = from.is_new || to.is_new;
      edge.drift = sum_above(edge.drift, std::max(from.move, to.move));
      edge.from += first;
      edge.to += first;
      const std::size_t before = scene_.edges.size();
      append_edge(scene_, edge);
      if (has_moved && scene_.edges.size() > before) {
        moved.push_back(static_cast<std::uint32_t>(before));
      }
    }
  }

  /// A crossing to which an edge is bent.
  struct Bend {
    std::uint32_t edge;
    std::uint32_t point;
  };

  /// Bends all edges that pass a rounded crossing within half a step to the crossing.
  void bend_to_crossings(std::vector<std::uint32_t>& moved, int level) {
    std::vector<Box3> boxes;
    boxes.reserve(scene_.edges.size());
    for (std::uint32_t e = 0; e < scene_.edges.size(); ++e) boxes.push_back(box(e));
    const BoxTree tree(boxes);
    std::vector<Bend> bends;
    for (const std::uint32_t c : crossings_) {
      const Point2 at = scene_.points[c];
      const double half = local_step(at, level) / 2;
      if (!std::isfinite(half)) continue;
      Box3 around;
      around.low = {at.x - 2 * half, at.y - 2 * half, 0};
      around.high = {at.x + 2 * half, at.y + 2 * half, 0};
      tree.for_each_meeting(around, [&](std::uint32_t e) {
        const Segment2 s = segment(e);
        const bool is_end =
            compare_xy(s.source, at) == Sign::Zero || compare_xy(s.target, at) == Sign::Zero;
        if (!is_end && meets_square(s.source, s.target, at, half)) bends.push_back({e, c});
      });
    }
    std::sort(bends.begin(), bends.end(), [this](const Bend& a, const Bend& b) {
      return a.edge != b.edge ? a.edge < b.edge : is_before(a.edge, a.point, b.point);
    });
    bend(bends, moved, level);
  }

  /// Replaces each edge by the path through the points to which it is bent. `bends` are sorted by
  /// edge, and then along the edge. `moved` has the edges that have been moved, on entry and on
  /// return.
  void bend(const std::vector<Bend>& bends, std::vector<std::uint32_t>& moved, int level) {
    const std::vector<LabelledEdge> old = std::exchange(scene_.edges, {});
    std::vector<std::uint8_t> is_moved(old.size(), 0);
    for (const std::uint32_t e : moved) is_moved[e] = 1;
    for (const Bend& b : bends) is_moved[b.edge] = trace_.is_bent[old[b.edge].source] = 1;
    moved.clear();
    auto next = bends.begin();
    for (std::uint32_t e = 0; e < old.size(); ++e) {
      LabelledEdge piece = old[e];
      const std::size_t before = scene_.edges.size();
      for (; next != bends.end() && next->edge == e; ++next) {
        piece.to = next->point;
        const double half = local_step(scene_.points[next->point], level) / 2;
        piece.drift = std::max(piece.drift, sum_above(old[e].drift, half));
        append_edge(scene_, piece);
        piece.from = next->point;
      }
      piece.to = old[e].to;
      append_edge(scene_, piece);
      if (is_moved[e] == 0) continue;
      for (std::size_t i = before; i < scene_.edges.size(); ++i) {
        scene_.edges[i].drift = piece.drift;
        moved.push_back(static_cast<std::uint32_t>(i));
      }
    }
  }

  /// Whether point p comes before point q along an edge.
  bool is_before(std::uint32_t e, std::uint32_t p, std::uint32_t q) const {
    const auto difference = [](double a, double b) {
      return exact_rational(a) - exact_rational(b);
    };
    const Segment2 s = segment(e);
    const Point2 a = scene_.points[p], b = scene_.points[q];
    const Rational along = difference(b.x, a.x) * difference(s.target.x, s.source.x) +
                           difference(b.y, a.y) * difference(s.target.y, s.source.y);
    return along.sign() > 0;
  }

  LabelledEdges& scene_;
  EdgeTrace& trace_;
  Context& context_;
  std::vector<std::uint8_t> meets_;
  std::vector<std::uint32_t> crossings_;  // The points of the crossings in this round.
};

}  // namespace

int level_of_round(int round) { return std::max(0, round + 1 - kRoundsOfDoubles); }

void repair_locally(LabelledEdges& scene, std::vector<std::uint32_t> moved, int& round,
                    int most_rounds, EdgeTrace& trace, Context& context) {
  LocalRepair repair(scene, trace, context);
  while (!moved.empty() && round < most_rounds) {
    if (repair.run(moved, level_of_round(round))) ++round;
  }
}

}  // namespace plumb
