// Labelled edges, their arrangement, and the labels of faces by winding numbers.
//
// A piece of an arrangement may be part of several edges. Its jump is the formal sum of the labels
// above these edges, minus the labels below them. Nearly always the piece is part of one edge, and
// the jump is a pair of labels; that case takes no memory of its own. A walk over the faces from
// face 0 adds jumps. Nearly all faces are wound round once by one label (a clear face); the other
// faces get an explicit list of winding numbers.
//
// Tested by tests/plane/plane_rounding_test.cpp; docs/design/rounding.md has the proofs.

#include "plumb/plane/rounding/labelled_edges.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "plumb/predicates/segment2.h"

namespace plumb {
namespace {

/// The winding number of a label, or a change of it.
struct Winding {
  std::uint32_t label;
  std::int32_t number;
};
using Windings = std::vector<Winding>;

/// Sorts by label, adds the numbers of equal labels, and drops zeros.
void normalize(Windings& sum) {
  std::sort(sum.begin(), sum.end(),
            [](const Winding& v, const Winding& w) { return v.label < w.label; });
  std::size_t kept = 0;
  for (std::size_t i = 0; i < sum.size();) {
    Winding total = sum[i];
    for (++i; i < sum.size() && sum[i].label == total.label; ++i) total.number += sum[i].number;
    if (total.number != 0) sum[kept++] = total;
  }
  sum.resize(kept);
}

/// Collects the pieces of an arrangement.
class PieceCollector {
 public:
  PieceCollector(const LabelledEdges& scene, const Arrangement& arrangement, EdgeTrace& trace)
      : scene_(scene),
        arrangement_(arrangement),
        trace_(trace),
        piece_count_(scene.edges.size(), 0) {}

  EdgePieces collect() {
    const PlaneComplex& complex = arrangement_.complex;
    pieces_.begin.reserve(complex.edge_count() + 1);
    pieces_.edges.reserve(complex.edge_count());
    for (std::size_t i = 0; i < complex.edge_count(); ++i) {
      pieces_.begin.push_back(static_cast<std::uint32_t>(pieces_.edges.size()));
      add(EdgeId(i));
    }
    pieces_.begin.push_back(static_cast<std::uint32_t>(pieces_.edges.size()));
    for (std::size_t i = 0; i < piece_count_.size(); ++i) {
      if (piece_count_[i] > 1) trace_.is_bent[scene_.edges[i].source] = 1;
    }
    return std::move(pieces_);
  }

 private:
  void add(EdgeId e) {
    curves_.clear();
    arrangement_.origin_sets.append(arrangement_.origins[e.value()], curves_);
    for (const SegmentId s : curves_) ++piece_count_[s.value()];
    const Dcel& dcel = arrangement_.complex.dcel;
    LabelledEdge piece = scene_.edges[curves_.front().value()];
    piece.from = dcel.origin(first_half(e)).value();
    piece.to = dcel.target(first_half(e)).value();
    if (curves_.size() == 1) {
      pieces_.edges.push_back(piece);
    } else {
      add_sum(piece);
    }
  }

  /// Adds the sum of the current curves, as pairs of a label whose number increases and a label
  /// whose number decreases.
  void add_sum(LabelledEdge piece) {
    Windings jump;
    for (const SegmentId s : curves_) {
      const LabelledEdge& edge = scene_.edges[s.value()];
      jump.push_back({edge.above, 1});
      jump.push_back({edge.below, -1});
      piece.is_line = piece.is_line || edge.is_line;
      piece.drift = std::max(piece.drift, edge.drift);
    }
    normalize(jump);
    if (jump.empty()) {
      trace_.folded += piece.is_line ? 0 : 1;
      piece.below = piece.above;
      if (piece.is_line) pieces_.edges.push_back(piece);
      return;
    }
    auto up = jump.begin(), down = jump.begin();
    for (;;) {
      while (up != jump.end() && up->number <= 0) ++up;
      while (down != jump.end() && down->number >= 0) ++down;
      // Both reach the end at the same time, because the numbers of a jump add up to zero.
      if (up == jump.end() || down == jump.end()) return;
      --up->number;
      ++down->number;
      piece.above = up->label;
      piece.below = down->label;
      pieces_.edges.push_back(piece);
    }
  }

  const LabelledEdges& scene_;
  const Arrangement& arrangement_;
  EdgeTrace& trace_;
  EdgePieces pieces_;
  std::vector<std::uint32_t> piece_count_;  // The number of pieces of each edge of the scene.
  std::vector<SegmentId> curves_;           // The edges that contain the current piece.
};

/// Walks over all faces from face 0, and adds jumps.
class FaceWalk {
 public:
  FaceWalk(const PlaneComplex& complex, const EdgePieces& pieces)
      : complex_(complex), pieces_(pieces) {
    labels_.label.assign(complex.face_count(), kNone);
    is_known_.assign(complex.face_count(), 0);
    mixed_of_.assign(complex.face_count(), kNone);
    group_halfedges();
  }

  FaceLabels run() {
    std::vector<FaceId> todo{FaceId(0)};
    is_known_[FaceId(0)] = 1;
    labels_.label[FaceId(0)] = 0;
    while (!todo.empty()) {
      const FaceId f = todo.back();
      todo.pop_back();
      for (std::uint32_t i = begin_[f.value()]; i < begin_[f.value() + 1]; ++i) {
        const HalfedgeId h = of_face_[i];
        const FaceId g = complex_.dcel.face(twin(h));
        if (is_known_[g] != 0) continue;
        is_known_[g] = 1;
        cross(f, h, g);
        todo.push_back(g);
      }
    }
    return std::move(labels_);
  }

 private:
  void group_halfedges() {
    const std::size_t halfedges = 2 * complex_.edge_count();
    begin_.assign(complex_.face_count() + 1, 0);
    for (std::size_t h = 0; h < halfedges; ++h) ++begin_[face(h) + 1];
    for (std::size_t f = 0; f + 1 < begin_.size(); ++f) begin_[f + 1] += begin_[f];
    std::vector<std::uint32_t> end(begin_.begin(), begin_.end() - 1);
    of_face_.resize(halfedges);
    for (std::size_t h = 0; h < halfedges; ++h) of_face_[end[face(h)]++] = HalfedgeId(h);
  }
  std::uint32_t face(std::size_t h) const { return complex_.dcel.face(HalfedgeId(h)).value(); }

  /// Labels face g, which lies to the right of half-edge h of face f.
  void cross(FaceId f, HalfedgeId h, FaceId g) {
    const auto pieces = pieces_.of(edge_of(h));
    const bool leaves_up = h != first_half(edge_of(h));
    if (mixed_of_[f] == kNone && pieces.size() <= 1) {
      const std::uint32_t near = pieces.empty() ? labels_.label[f]
                                 : leaves_up    ? pieces[0].below
                                                : pieces[0].above;
      if (near == labels_.label[f]) {
        labels_.label[g] = pieces.empty() ? near : leaves_up ? pieces[0].above : pieces[0].below;
        return;
      }
    }
    Windings sum = mixed_of_[f] == kNone ? Windings{{labels_.label[f], 1}} : mixed_[mixed_of_[f]];
    for (const LabelledEdge& piece : pieces) {
      sum.push_back({leaves_up ? piece.above : piece.below, 1});
      sum.push_back({leaves_up ? piece.below : piece.above, -1});
    }
    normalize(sum);
    set(g, std::move(sum));
  }

  void set(FaceId g, Windings sum) {
    const auto best =
        std::max_element(sum.begin(), sum.end(), [](const Winding& v, const Winding& w) {
          return v.number != w.number ? v.number < w.number : v.label < w.label;
        });
    labels_.label[g] = best->label;  // There is such a label, because the numbers add up to 1.
    if (sum.size() == 1) return;
    labels_.is_clear = false;
    mixed_of_[g] = static_cast<std::uint32_t>(mixed_.size());
    mixed_.push_back(std::move(sum));
  }

  const PlaneComplex& complex_;
  const EdgePieces& pieces_;
  // The index in of_face_ at which the half-edges of each face begin.
  std::vector<std::uint32_t> begin_;
  std::vector<HalfedgeId> of_face_;
  IdVector<FaceId, std::uint8_t> is_known_;
  IdVector<FaceId, std::uint32_t> mixed_of_;  // The entry of mixed_, or kNone for clear faces.
  std::vector<Windings> mixed_;
  FaceLabels labels_;
};

}  // namespace

EdgePieces pieces_of(const PlaneComplex& exact) {
  IdVector<FaceId, std::uint32_t> label(exact.dcel.face_count(), 0);
  for (std::size_t f = 1; f < exact.face_count(); ++f) {
    if (!exact.has_frame() || !is_unbounded(exact, FaceId(f))) {
      label[f] = static_cast<std::uint32_t>(f);
    }
  }
  EdgePieces pieces;
  pieces.begin.reserve(exact.edge_count() + 1);
  for (std::uint32_t e = 0; e < exact.edge_count(); ++e) {
    pieces.begin.push_back(static_cast<std::uint32_t>(pieces.edges.size()));
    const HalfedgeId h = first_half(EdgeId(e));
    const VertexId from = exact.dcel.origin(h), to = exact.dcel.target(h);
    if (exact.is_at_infinity(from) || exact.is_at_infinity(to)) continue;
    const FaceId above = exact.dcel.face(h), below = exact.dcel.face(twin(h));
    const bool is_line = exact.mark(EdgeId(e)) && !exact.mark(above) && !exact.mark(below);
    if (label[above] == label[below] && !is_line) continue;
    pieces.edges.push_back({from.value(), to.value(), label[above], label[below], e, is_line, 0});
  }
  pieces.begin.push_back(static_cast<std::uint32_t>(pieces.edges.size()));
  return pieces;
}

Arrangement arrange_edges(const LabelledEdges& scene, Context& context) {
  PlanePoints points;
  points.inputs.reserve(scene.points.size() + scene.lone.size());
  for (const Point2& p : scene.points) points.inputs.push_back(p);
  std::vector<std::uint32_t> stops;
  for (const Point2& p : scene.lone) {
    stops.push_back(static_cast<std::uint32_t>(points.inputs.size()));
    points.inputs.push_back(p);
  }
  std::vector<SweepCurve> curves;
  curves.reserve(scene.edges.size());
  for (const LabelledEdge& e : scene.edges) curves.push_back({e.from, e.to, e.from, e.to});
  return arrange(points, curves, stops, context);
}

EdgePieces pieces_of(const LabelledEdges& scene, const Arrangement& arrangement, EdgeTrace& trace) {
  return PieceCollector(scene, arrangement, trace).collect();
}

double sum_above(double a, double b) {
  if (a == 0 || b == 0) return a == 0 ? b : a;
  return std::nextafter(a + b, std::numeric_limits<double>::infinity());
}

void append_edge(LabelledEdges& scene, LabelledEdge edge) {
  scene.drift = std::max(scene.drift, edge.drift);
  const Sign order = compare_xy(scene.points[edge.from], scene.points[edge.to]);
  if (order == Sign::Zero) {
    if (edge.is_line) scene.lone.push_back(scene.points[edge.from]);
    return;
  }
  if (order == Sign::Positive) {
    std::swap(edge.from, edge.to);
    std::swap(edge.above, edge.below);
  }
  scene.edges.push_back(edge);
}

LabelledEdges placed(const EdgePieces& pieces, std::span<const VertexPlace> places,
                     std::vector<Point2> lone) {
  LabelledEdges scene;
  scene.lone = std::move(lone);
  scene.points.reserve(places.size());
  for (const VertexPlace& place : places) scene.points.push_back(place.at);
  scene.edges.reserve(pieces.edges.size());
  for (LabelledEdge edge : pieces.edges) {
    const double move = std::max(places[edge.from].move, places[edge.to].move);
    edge.drift = sum_above(edge.drift, move);
    append_edge(scene, edge);
  }
  return scene;
}

FaceLabels face_labels(const PlaneComplex& complex, const EdgePieces& pieces) {
  return FaceWalk(complex, pieces).run();
}

}  // namespace plumb
