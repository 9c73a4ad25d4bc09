// Rounding of subdivisions and sets to doubles and to grids.
//
// PlaneRounder has a scene of labelled edges between doubles. It arranges the scene; where the
// arrangement has crossings, it makes the next scene from the pieces, either with each crossing
// rounded (and repaired locally), or with all vertices snapped to a common grid. If an arrangement
// has no crossings, it is the result, except that edges between equal faces are left out. So the
// result is valid in any case, because the last arrangement has checked it.
//
// Termination: only kMostRounds rounds are local. Every later round doubles the step of the grid,
// and hot pixels need one of these rounds (docs/design/rounding.md, Lemma 2). Even without this
// lemma all vertices would be one point in the end.
//
// Tested by tests/plane/plane_rounding_test.cpp.

#include "plumb/plane/plane_rounding.h"

#include <algorithm>
#include <numeric>
#include <optional>
#include <utility>

#include "plumb/plane/complex/plane_draft.h"
#include "plumb/plane/rounding/labelled_edges.h"
#include "plumb/plane/rounding/local_repair.h"
#include "plumb/plane/rounding/vertex_places.h"
#include "plumb/predicates/error.h"
#include "plumb/predicates/rounding.h"
#include "plumb/predicates/segment2.h"

namespace plumb {
namespace {

constexpr int kMostRounds = 12;  // The greatest number of local rounds.
constexpr std::size_t kEdgesPerCheckpoint = 256;
constexpr const char* kRoundingPhase = "round";
// The memory of the scene, the arrangement and its pieces. The arrangement charges its own memory
// separately.
constexpr std::uint64_t kBytesPerEdge = 200;

bool is_double(const PlaneComplex& complex, std::uint32_t p) {
  const PlanePointsView points(complex.points);
  return points.is_input(p) && points.inputs().is_double(p);
}

bool has_only_doubles(const PlaneComplex& complex) {
  return std::all_of(complex.vertex_point.begin(), complex.vertex_point.end(),
                     [&](std::uint32_t p) { return is_double(complex, p); });
}

bool has_crossings(const PlaneComplex& complex) {
  return std::any_of(complex.vertex_point.begin(), complex.vertex_point.end(),
                     [&](std::uint32_t p) { return p >= complex.points.inputs.size(); });
}

std::vector<Point2> points_at(const std::vector<VertexPlace>& places) {
  std::vector<Point2> points;
  points.reserve(places.size());
  for (const VertexPlace& place : places) points.push_back(place.at);
  return points;
}

/// Returns the result if nothing has to be rounded.
RoundedSubdivision unchanged(const PlaneComplex& exact, Context& context) {
  RoundedSubdivision result{exact, {}, {}};
  for (std::size_t f = 0; f < exact.face_count(); ++f) result.exact_face.push_back(FaceId(f));
  result.report.largest_ulp =
      exact.vertex_count() == 0
          ? 0
          : ulp_of(largest_coordinate(points_at(nearest_places(exact, context))));
  return result;
}

/// Returns the vertex at a point, or an invalid id. Requires vertices at doubles.
VertexId vertex_at(const PlaneComplex& complex, Point2 p) {
  const auto at = [&complex](std::uint32_t i) { return complex.points.inputs.approx(i); };
  const auto found = std::lower_bound(
      complex.vertex_point.begin(), complex.vertex_point.end(), p,
      [&](std::uint32_t i, Point2 q) { return compare_xy(at(i), q) == Sign::Negative; });
  const bool is_there =
      found != complex.vertex_point.end() && compare_xy(at(*found), p) == Sign::Zero;
  return is_there ? VertexId(static_cast<std::size_t>(found - complex.vertex_point.begin()))
                  : VertexId();
}

/// Returns the pieces of a complex, one for each edge.
EdgePieces one_piece_each(std::vector<LabelledEdge> edges) {
  EdgePieces pieces;
  pieces.begin.resize(edges.size() + 1);
  std::iota(pieces.begin.begin(), pieces.begin.end(), std::uint32_t{0});
  pieces.edges = std::move(edges);
  return pieces;
}

class PlaneRounder {
 public:
  PlaneRounder(const PlaneComplex& exact, Context& context)
      : exact_(exact), context_(context), memory_(context) {
    memory_.add(kBytesPerEdge * exact.edge_count(), "the rounding of the plane");
    trace_.is_bent.assign(exact.edge_count(), 0);
  }

  RoundedSubdivision to_doubles() {
    std::vector<VertexPlace> places = nearest_places(exact_, context_);
    nearest_ = points_at(places);
    image_ = nearest_;
    scene_ = placed(pieces_of(exact_), places, lone_points());
    for (const VertexPlace& place : places) drift_ = std::max(drift_, place.move);
    return repaired(kMostRounds, {});
  }

  RoundedSubdivision to_grid(const Rational& step) {
    nearest_ = points_at(nearest_places(exact_, context_));
    const HotPixels pixels(exact_, step, context_);
    for (std::size_t v = 0; v < exact_.vertex_count(); ++v) {
      image_.push_back(pixels.places()[pixels.pixel_of(VertexId(v))]);
    }
    drift_ = pixels.move();
    snap(pieces_of(exact_), pixels, lone_points());
    return repaired(0, step);
  }

 private:
  /// Returns the places of isolated vertices that belong to the set.
  std::vector<Point2> lone_points() const {
    std::vector<Point2> lone;
    for (std::size_t v = 0; v < exact_.vertex_count(); ++v) {
      const bool is_lone = exact_.dcel.is_isolated(VertexId(v)) && exact_.mark(VertexId(v));
      if (is_lone) lone.push_back(image_[v]);
    }
    return lone;
  }

  RoundedSubdivision repaired(int most_rounds, std::optional<Rational> step);
  void round_crossings(const EdgePieces& pieces, const PlaneComplex& complex, int most_rounds);
  void snap_again(const EdgePieces& pieces, const PlaneComplex& complex, Rational& step);
  void snap(const EdgePieces& pieces, const HotPixels& pixels, std::vector<Point2> lone);
  RoundedSubdivision finished(Arrangement arrangement);
  std::vector<std::uint8_t> leave_out_folded(const PlaneComplex& complex, const EdgePieces& pieces,
                                             const FaceLabels& labels);
  void set_marks(const EdgePieces& pieces, RoundedSubdivision& result) const;
  PlaneRoundingReport report(const RoundedSubdivision& result) const;
  std::size_t count_merged() const;

  const PlaneComplex& exact_;
  Context& context_;
  MemoryCharge memory_;
  LabelledEdges scene_;
  EdgeTrace trace_;
  std::vector<Point2> nearest_;  // The nearest doubles of each exact vertex.
  std::vector<Point2> image_;    // The current place of each exact vertex.
  double drift_ = 0;             // A bound for the moves of all points in earlier scenes.
  int round_ = 0;
};

/// Arranges and repairs the scene until there are no crossings. After `most_rounds` rounds,
/// vertices are snapped to a grid. Its first step is `step`, or one unit in the last place.
RoundedSubdivision PlaneRounder::repaired(int most_rounds, std::optional<Rational> step) {
  for (;;) {
    Arrangement arrangement = arrange_edges(scene_, context_);
    if (!has_crossings(arrangement.complex)) return finished(std::move(arrangement));
    context_.checkpoint(kRoundingPhase, 0, 0);
    const EdgePieces pieces = pieces_of(scene_, arrangement, trace_);
    context_.checkpoint(kRoundingPhase, 0, 0);
    drift_ = std::max(drift_, scene_.drift);
    if (round_ < most_rounds) {
      round_crossings(pieces, arrangement.complex, most_rounds);
      continue;
    }
    if (!step) step = exact_rational(ulp_of(largest_coordinate(image_)));
    snap_again(pieces, arrangement.complex, *step);
  }
}

void PlaneRounder::round_crossings(const EdgePieces& pieces, const PlaneComplex& complex,
                                   int most_rounds) {
  const std::vector<VertexPlace> places =
      places_of_crossings(complex, level_of_round(round_++), context_);
  scene_ = placed(pieces, places, std::move(scene_.lone));
  std::vector<std::uint32_t> moved;
  for (std::uint32_t e = 0; e < scene_.edges.size(); ++e) {
    const LabelledEdge& edge = scene_.edges[e];
    if (places[edge.from].is_new || places[edge.to].is_new) moved.push_back(e);
  }
  repair_locally(scene_, std::move(moved), round_, most_rounds, trace_, context_);
}

/// Snaps the arrangement to the grid, and doubles the step for the next round.
void PlaneRounder::snap_again(const EdgePieces& pieces, const PlaneComplex& complex,
                              Rational& step) {
  const HotPixels pixels(complex, step, context_);
  const auto place = [&pixels](Point2 p) {
    return pixels.place_of({exact_rational(p.x), exact_rational(p.y)});
  };
  std::vector<Point2> lone = std::move(scene_.lone);
  for (Point2& p : lone) p = place(p);
  for (Point2& p : image_) p = place(p);
  snap(pieces, pixels, std::move(lone));
  step *= 2;
}

/// Makes the scene of pieces that are routed through hot pixels.
void PlaneRounder::snap(const EdgePieces& pieces, const HotPixels& pixels,
                        std::vector<Point2> lone) {
  scene_ = {};
  scene_.points = pixels.places();
  scene_.lone = std::move(lone);
  std::vector<std::uint32_t> route;
  std::size_t done = 0;
  for (LabelledEdge edge : pieces.edges) {
    if (done++ % kEdgesPerCheckpoint == 0)
      context_.checkpoint(kRoundingPhase, done, pieces.edges.size());
    route.clear();
    pixels.route(VertexId(edge.from), VertexId(edge.to), route);
    if (route.size() > 2) trace_.is_bent[edge.source] = 1;
    edge.drift = sum_above(edge.drift, pixels.move());
    if (route.size() == 1) route.push_back(route.front());
    for (std::size_t i = 0; i + 1 < route.size(); ++i) {
      edge.from = route[i];
      edge.to = route[i + 1];
      append_edge(scene_, edge);
    }
  }
}

RoundedSubdivision PlaneRounder::finished(Arrangement arrangement) {
  context_.checkpoint(kRoundingPhase, 0, 0);
  EdgePieces pieces = pieces_of(scene_, arrangement, trace_);
  context_.checkpoint(kRoundingPhase, 0, 0);
  FaceLabels labels = face_labels(arrangement.complex, pieces);
  context_.checkpoint(kRoundingPhase, 0, 0);
  const std::vector<std::uint8_t> is_kept = leave_out_folded(arrangement.complex, pieces, labels);
  context_.checkpoint(kRoundingPhase, 0, 0);
  if (scene_.edges.size() == arrangement.complex.edge_count()) {
    // No edge was left out.
  } else if (scene_.lone.empty()) {
    const std::vector<std::uint8_t> all_corners(arrangement.complex.vertex_count(), 1);
    ReducedComplex reduced = without_edges(arrangement.complex, is_kept, all_corners);
    arrangement.complex = std::move(reduced.complex);
    pieces = one_piece_each(scene_.edges);
    FaceLabels merged;
    for (const FaceId f : reduced.merged) merged.label.push_back(labels.label[f]);
    labels = std::move(merged);
  } else {
    arrangement = arrange_edges(scene_, context_);
    context_.checkpoint(kRoundingPhase, 0, 0);
    pieces = pieces_of(scene_, arrangement, trace_);
    labels = face_labels(arrangement.complex, pieces);
    PLUMB_CHECK(labels.is_clear);
  }
  RoundedSubdivision result;
  result.complex = std::move(arrangement.complex);
  for (const std::uint32_t label : labels.label) result.exact_face.push_back(FaceId(label));
  set_marks(pieces, result);
  result.report = report(result);
  return result;
}

/// Makes the scene of the edges between different faces, and of the lines. Each of them gets the
/// labels of the faces beside it, so every face has one clear label. Returns for each edge whether
/// it is in the scene.
std::vector<std::uint8_t> PlaneRounder::leave_out_folded(const PlaneComplex& complex,
                                                         const EdgePieces& pieces,
                                                         const FaceLabels& labels) {
  std::vector<std::uint8_t> is_kept(complex.edge_count(), 0);
  LabelledEdges kept;
  kept.lone = std::move(scene_.lone);
  kept.drift = scene_.drift;
  for (const std::uint32_t p : complex.vertex_point) {
    kept.points.push_back(complex.points.inputs.approx(p));
  }
  for (std::size_t i = 0; i < complex.edge_count(); ++i) {
    const auto of_edge = pieces.of(EdgeId(i));
    if (of_edge.empty()) continue;
    LabelledEdge edge = of_edge.front();
    const HalfedgeId h = first_half(EdgeId(i));
    edge.above = labels.label[complex.dcel.face(h)];
    edge.below = labels.label[complex.dcel.face(twin(h))];
    if (edge.above == edge.below && !edge.is_line) {
      ++trace_.folded;
    } else {
      kept.edges.push_back(edge);
      is_kept[i] = 1;
    }
  }
  scene_ = std::move(kept);
  return is_kept;
}

void PlaneRounder::set_marks(const EdgePieces& pieces, RoundedSubdivision& result) const {
  PlaneComplex& c = result.complex;
  for (std::size_t f = 0; f < c.face_count(); ++f) {
    const FaceId exact = result.exact_face[FaceId(f)];
    const bool is_left_out = exact == FaceId(0) && exact_.has_frame();
    c.marks.face[f] = !is_left_out && exact_.mark(exact) ? 1 : 0;
  }
  for (std::size_t i = 0; i < c.edge_count(); ++i) {
    const EdgeId e(i);
    const HalfedgeId h = first_half(e);
    const bool is_line = !pieces.of(e).empty() && pieces.of(e).front().is_line;
    const bool mark = is_line || c.mark(c.dcel.face(h)) || c.mark(c.dcel.face(twin(h)));
    c.marks.edge[i] = mark ? 1 : 0;
    if (!mark) continue;
    c.marks.vertex[c.dcel.origin(h)] = 1;
    c.marks.vertex[c.dcel.target(h)] = 1;
  }
  for (const Point2& p : scene_.lone) {
    if (const VertexId v = vertex_at(c, p); v.is_valid()) c.marks.vertex[v] = 1;
  }
}

PlaneRoundingReport PlaneRounder::report(const RoundedSubdivision& result) const {
  PlaneRoundingReport report;
  for (std::size_t v = 0; v < image_.size(); ++v) {
    if (compare_xy(image_[v], nearest_[v]) != Sign::Zero) ++report.vertices_moved;
  }
  report.vertices_merged = count_merged();
  report.edges_bent =
      static_cast<std::size_t>(std::count(trace_.is_bent.begin(), trace_.is_bent.end(), 1));
  report.edges_folded = trace_.folded;
  std::vector<std::uint8_t> is_there(exact_.face_count(), 0);
  for (const FaceId f : result.exact_face) is_there[f.value()] = 1;
  for (std::size_t f = 1; f < exact_.face_count(); ++f) {
    const bool is_bounded = !exact_.has_frame() || !is_unbounded(exact_, FaceId(f));
    if (is_bounded && is_there[f] == 0) ++report.collapsed;
  }
  report.largest_move = std::max(drift_, scene_.drift);
  if (!nearest_.empty()) report.largest_ulp = ulp_of(largest_coordinate(nearest_));
  return report;
}

/// Returns the number of exact vertices without the number of their places.
std::size_t PlaneRounder::count_merged() const {
  std::vector<Point2> sorted = image_;
  const auto is_less = [](const Point2& p, const Point2& q) {
    return compare_xy(p, q) == Sign::Negative;
  };
  // Rounding keeps the order of most vertices, so the places are nearly sorted.
  if (!std::is_sorted(sorted.begin(), sorted.end(), is_less)) {
    std::sort(sorted.begin(), sorted.end(), is_less);
  }
  std::size_t merged = 0;
  for (std::size_t i = 1; i < sorted.size(); ++i) {
    if (compare_xy(sorted[i - 1], sorted[i]) == Sign::Zero) ++merged;
  }
  return merged;
}

/// Whether all vertices are doubles at their places on the grid.
bool is_on_grid(const PlaneComplex& complex, const Rational& step, Context& context) {
  if (!has_only_doubles(complex)) return false;
  const HotPixels pixels(complex, step, context);
  for (std::size_t v = 0; v < complex.vertex_count(); ++v) {
    const Point2 at = complex.points.inputs.approx(complex.vertex_point[v]);
    if (compare_xy(at, pixels.places()[pixels.pixel_of(VertexId(v))]) != Sign::Zero) return false;
  }
  return true;
}

void require_positive(const Rational& step) {
  if (step.sign() > 0) return;
  throw Error(ErrorCode::BadArgument, "the step of a grid must be positive");
}

RoundedSet set_of(RoundedSubdivision rounded, Context& context) {
  return {Nef2::from_complex(std::move(rounded.complex), context), rounded.report};
}

}  // namespace

RoundedSubdivision round_to_doubles(const PlaneComplex& exact, Context& context) {
  if (!exact.has_frame() && has_only_doubles(exact)) return unchanged(exact, context);
  return PlaneRounder(exact, context).to_doubles();
}

RoundedSubdivision round_to_grid(const PlaneComplex& exact, const Rational& step,
                                 Context& context) {
  require_positive(step);
  if (!exact.has_frame() && is_on_grid(exact, step, context)) return unchanged(exact, context);
  return PlaneRounder(exact, context).to_grid(step);
}

RoundedSet round_to_doubles(const Nef2& set, Context& context) {
  const Nef2 closed = set.is_closed() ? set : set.closure(context);
  if (!closed.complex().has_frame() && has_only_doubles(closed.complex())) {
    return {closed, unchanged(closed.complex(), context).report};
  }
  return set_of(round_to_doubles(closed.complex(), context), context);
}

RoundedSet round_to_grid(const Nef2& set, const Rational& step, Context& context) {
  const Nef2 closed = set.is_closed() ? set : set.closure(context);
  return set_of(round_to_grid(closed.complex(), step, context), context);
}

}  // namespace plumb
