// Flattening and joining of the curves of drawings.
//
// SvgOutline flattens: each curve becomes a ring of it, whose points are a chain here. An arc is
// given in quarters, so that even a coarse tolerance keeps its shape. A spline is cut into Bezier
// curves, one for each span between knots: control point k of a span [a, b] of degree d is the
// blossom (polar form) of the spline at d - k times a and k times b. Blossoms of rational splines
// are taken in homogeneous coordinates.
//
// Open chains are the edges of a graph whose nodes are ends that are joined. If an even number of
// ends meets in each node, the edges can be cut into closed walks, and under the even-odd rule
// every way of doing so encloses the same points. So the walks are taken as they come.
//
// Tested by tests/io/dxf_test.cpp.
#include "plumb/io/plane/dxf_curves.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <numeric>
#include <span>
#include <utility>

#include "plumb/base/internal/degrees.h"
#include "plumb/io/text/text_output.h"
#include "plumb/predicates/arithmetic/elementary.h"
#include "plumb/predicates/error.h"

namespace plumb {
namespace {

constexpr double kRadian = std::numbers::pi / 180;
constexpr double kQuarterTurn = 90;

Point2 on_arc(const DxfCurve& curve, double degrees) {
  const Point2 turn = unit_vector(degrees);
  return {curve.centre.x + turn.x * curve.u.x + turn.y * curve.v.x,
          curve.centre.y + turn.x * curve.u.y + turn.y * curve.v.y};
}

/// Adds curves to an outline.
class CurveFlattener {
 public:
  CurveFlattener(const DxfCurves& drawing, SvgOutline& outline)
      : drawing_(drawing), outline_(outline) {}

  /// Adds one ring, unless the curve is a single point.
  void add(const DxfCurve& curve, const TextCursor& at) {
    outline_.set_transform(curve.transform);
    switch (curve.kind) {
      case DxfKind::Arc:
        add_arc(curve, at);
        break;
      case DxfKind::Spline:
        add_spline(curve, at);
        break;
      default:
        add_polyline(curve, at);
    }
    outline_.end_shape();
  }

 private:
  void add_arc(const DxfCurve& curve, const TextCursor& at) {
    outline_.move_to(at, on_arc(curve, curve.from));
    for (std::uint32_t i = 1; i <= curve.chords; ++i) {
      outline_.line_to(at, on_arc(curve, curve.from + (curve.to - curve.from) * i / curve.chords));
    }
    double from = curve.chords > 0 ? curve.to : curve.from;
    while (from < curve.to) {
      const double next = std::min(from + kQuarterTurn, curve.to);
      outline_.arc_to(at, curve.centre, curve.u, curve.v, from * kRadian, next * kRadian,
                      on_arc(curve, next));
      from = next;
    }
  }

  void add_polyline(const DxfCurve& curve, const TextCursor& at) {
    const DxfVertex* const v = drawing_.vertices.data();
    outline_.move_to(at, v[curve.first_vertex].p);
    for (std::uint32_t i = curve.first_vertex; i + 1 < curve.end_vertex; ++i) {
      add_side(v[i], v[i + 1].p, at);
    }
    if (curve.is_closed) add_side(v[curve.end_vertex - 1], v[curve.first_vertex].p, at);
  }

  /// Adds a side of a polyline. The centre of an arc lies on the bisector of its chord.
  void add_side(const DxfVertex& a, Point2 b, const TextCursor& at) {
    if (a.bulge == 0 || a.p == b) return outline_.line_to(at, b);
    const double reach = (1 - a.bulge * a.bulge) / (4 * a.bulge);
    const Point2 chord{b.x - a.p.x, b.y - a.p.y};
    const Point2 centre{(a.p.x + b.x) / 2 - reach * chord.y, (a.p.y + b.y) / 2 + reach * chord.x};
    const Point2 u{a.p.x - centre.x, a.p.y - centre.y};
    const Point2 v{-u.y, u.x};
    const double angle = 4 * arc_tangent(a.bulge, 1);
    const double quarters = std::max(1.0, std::ceil(std::fabs(angle) / (std::numbers::pi / 2)));
    for (double q = 0; q < quarters; ++q) {
      const double from = angle * q / quarters, to = angle * (q + 1) / quarters;
      const auto [c, s] = direction_at(to);
      const Point2 end{centre.x + c * u.x + s * v.x, centre.y + c * u.y + s * v.y};
      outline_.arc_to(at, centre, u, v, from, to, q + 1 < quarters ? end : b);
    }
  }

  // ---------------------------------------------------------------- splines

  using Control = std::array<WeightedPoint, kMostSplineDegree + 1>;

  WeightedPoint control_point(std::uint32_t vertex) const {
    const auto& [p, bulge, w] = drawing_.vertices[vertex];
    return {p.x * w, p.y * w, w};
  }

  /// Returns the blossom of the span that begins with knot `span` at `degree` parameters: at the
  /// end of the span for the last `ends` of them, at its begin for the others.
  WeightedPoint blossom(const DxfCurve& curve, std::uint32_t span, std::uint32_t ends) const {
    const std::uint32_t degree = curve.degree;
    const double* const t = &drawing_.knots[curve.first_knot];
    Control d;
    for (std::uint32_t j = 0; j <= degree; ++j) {
      d[j] = control_point(curve.first_vertex + span - degree + j);
    }
    for (std::uint32_t r = 1; r <= degree; ++r) {
      const double at = t[r <= degree - ends ? span : span + 1];
      for (std::uint32_t j = degree; j >= r; --j) {
        const double low = t[span - degree + j], high = t[span + 1 + j - r];
        const double share = (at - low) / (high - low);
        d[j] = {d[j - 1].x + share * (d[j].x - d[j - 1].x),
                d[j - 1].y + share * (d[j].y - d[j - 1].y),
                d[j - 1].w + share * (d[j].w - d[j - 1].w)};
      }
    }
    return d[degree];
  }

  void add_spline(const DxfCurve& curve, const TextCursor& at) {
    const double* const t = &drawing_.knots[curve.first_knot];
    const std::uint32_t degree = curve.degree;
    const std::uint32_t points = curve.end_vertex - curve.first_vertex;
    bool is_first = true;
    for (std::uint32_t span = degree; span < points; ++span) {
      outline_.step();
      if (!(t[span] < t[span + 1])) continue;
      Control control;
      for (std::uint32_t k = 0; k <= degree; ++k) control[k] = blossom(curve, span, k);
      if (is_first) outline_.move_to(at, place(control[0]));
      is_first = false;
      add_bezier(std::span(control).first(degree + 1), at);
    }
    if (is_first) outline_.move_to(at, drawing_.vertices[curve.first_vertex].p);
  }

  static Point2 place(const WeightedPoint& p) { return {p.x / p.w, p.y / p.w}; }

  void add_bezier(std::span<const WeightedPoint> control, const TextCursor& at) {
    const std::size_t degree = control.size() - 1;
    const bool is_rational = std::any_of(control.begin(), control.end(),
                                         [](const WeightedPoint& p) { return p.w != 1; });
    if (degree == 1) return outline_.line_to(at, place(control[1]));
    if (degree > 3 || is_rational) return outline_.rational_to(at, control);
    if (degree == 2) return outline_.quadratic_to(at, place(control[1]), place(control[2]));
    outline_.cubic_to(at, place(control[1]), place(control[2]), place(control[3]));
  }

  const DxfCurves& drawing_;
  SvgOutline& outline_;
};

/// An open chain: points of a drawing, and the place in the file.
struct OpenChain {
  std::uint32_t ring;
  const char* where;
  bool is_computed;  ///< Whether its ends are computed, not stated.
  double reach;      ///< The distance within which it joins another end.
  std::array<std::uint32_t, 2> nodes{};
  bool is_used = false;
};

/// Joins open chains to rings.
class ChainJoiner {
 public:
  ChainJoiner(SvgDrawing& drawing, std::string_view text, const std::string& name,
              bool closes_open_chains, Context& context)
      : drawing_(drawing),
        text_(text),
        name_(name),
        closes_open_chains_(closes_open_chains),
        context_(context) {}

  void add(const OpenChain& chain) { chains_.push_back(chain); }

  /// Returns the number of ends of lines that join() moved to other ends.
  std::size_t moved() const { return moved_; }

  /// Returns the number of open chains that join() closed.
  std::size_t closed() const { return closed_; }

  /// Calls `take` with the points of each ring.
  template <class Take>
  void join(Take take) {
    for (const bool is_computed : {false, true}) {
      for (OpenChain& chain : chains_) {
        if (chain.is_computed == is_computed) find_nodes(chain);
      }
    }
    if (closes_open_chains_) {
      take_open_chains(take);
    } else {
      require_even();
    }
    for (std::uint32_t c = 0; c < chains_.size(); ++c) {
      if (!chains_[c].is_used) take(walk_from(c));
    }
  }

 private:
  using Key = std::pair<double, double>;

  Point2& end_of(const OpenChain& chain, std::size_t end) {
    const std::uint32_t begin = drawing_.ring_begin[chain.ring];
    return drawing_.points[end == 0 ? begin : drawing_.ring_begin[chain.ring + 1] - 1];
  }

  /// Finds the nodes at the ends of a chain. An end that was computed moves to its node.
  void find_nodes(OpenChain& chain) {
    const auto number = static_cast<std::uint32_t>(&chain - chains_.data());
    for (std::size_t end = 0; end < 2; ++end) {
      Point2& p = end_of(chain, end);
      const Point2 other = end_of(chain, 1 - end);
      const bool can_close = !chain.is_computed && drawing_.ring(chain.ring).size() > 3;
      const Key key = nearest_node(p, chain.reach, can_close ? nullptr : &other);
      if (!chain.is_computed && key != Key{p.x, p.y}) ++moved_;
      p = {key.first, key.second};
      const auto next = static_cast<std::uint32_t>(ends_.size());
      const auto [node, is_new] = nodes_.try_emplace(key, next);
      if (is_new) ends_.emplace_back();
      chain.nodes[end] = node->second;
      ends_[node->second].push_back(2 * number + static_cast<std::uint32_t>(end));
    }
  }

  /// Returns the nearest node within `reach`, or the point itself if there is none. The other end
  /// of a short curve does not count as a node.
  Key nearest_node(Point2 p, double reach, const Point2* other) {
    Key best{p.x + 0.0, p.y + 0.0};
    double least = reach;
    constexpr double kLowest = -std::numeric_limits<double>::infinity();
    for (auto node = nodes_.lower_bound({p.x - reach, kLowest});
         node != nodes_.end() && node->first.first <= p.x + reach; ++node) {
      watch();
      if (other != nullptr && node->first == Key{other->x, other->y}) continue;
      const double distance = std::hypot(node->first.first - p.x, node->first.second - p.y);
      if (distance > least || (distance == least && least < reach)) continue;
      least = distance;
      best = node->first;
    }
    return best;
  }

  /// Finds the walks that end at nodes with an odd number of ends. Afterwards, all nodes have even
  /// numbers of ends. A walk that begins at an odd node ends at another odd node.
  template <class Take>
  void take_open_chains(Take take) {
    std::vector<char> is_odd(ends_.size(), 0);
    for (std::uint32_t node = 0; node < ends_.size(); ++node) {
      is_odd[node] = ends_[node].size() % 2 != 0 ? 1 : 0;
    }
    for (std::uint32_t start = 0; start < ends_.size(); ++start) {
      if (is_odd[start] == 0) continue;
      is_odd[start] = 0;
      std::vector<Point2> ring;
      std::uint32_t node = start;
      while (node == start || is_odd[node] == 0) node = append(next_unused(node), ring);
      is_odd[node] = 0;
      const std::uint32_t last = ends_[node].back();
      ring.push_back(end_of(chains_[last / 2], last % 2));
      ++closed_;
      take(ring);
    }
  }

  void require_even() {
    std::vector<std::uint32_t> degree(ends_.size());
    for (std::uint32_t node = 0; node < ends_.size(); ++node) {
      degree[node] = static_cast<std::uint32_t>(ends_[node].size());
    }
    for (const OpenChain& chain : chains_) {
      for (std::size_t end = 0; end < 2; ++end) {
        if (degree[chain.nodes[end]] % 2 != 0) fail_open(chain, end, degree[chain.nodes[end]]);
      }
    }
  }

  [[noreturn]] void fail_open(const OpenChain& chain, std::size_t end, std::uint32_t degree) {
    const Point2 p = end_of(chain, end);
    const std::string where = "(" + format_double(p.x) + ", " + format_double(p.y) + ")";
    const auto line = static_cast<std::size_t>(1 + std::count(text_.data(), chain.where, '\n'));
    std::string message =
        degree == 1 ? "the chain of lines is open: its end " + where + " meets no other end"
                    : std::to_string(degree) + " ends of lines meet at " + where +
                          ", where a closed chain has an even number";
    if (degree == 1) {
      const double distance = distance_of_next_end(p);
      if (std::isfinite(distance)) {
        message += "; the nearest one is " + format_double(distance) + " away";
      }
    }
    throw Error(ErrorCode::BadShape, std::move(message), {name_, line, 1});
  }

  double distance_of_next_end(Point2 p) const {
    double least = std::numeric_limits<double>::infinity();
    for (const auto& [key, node] : nodes_) {
      const double distance = std::hypot(key.first - p.x, key.second - p.y);
      if (distance > 0) least = std::min(least, distance);
    }
    return least;
  }

  /// Walks from a chain until the walk returns to its start. Each node has an even number of ends
  /// that are not used, so only the start can stop the walk.
  std::vector<Point2> walk_from(std::uint32_t first) {
    std::vector<Point2> ring;
    const std::uint32_t start = chains_[first].nodes[0];
    std::uint32_t at = 2 * first;
    for (;;) {
      const std::uint32_t node = append(at, ring);
      if (node == start) return ring;
      at = next_unused(node);
    }
  }

  std::uint32_t next_unused(std::uint32_t node) {
    std::vector<std::uint32_t>& ends = ends_[node];
    while (chains_[ends.back() / 2].is_used) ends.pop_back();
    return ends.back();
  }

  /// Uses a chain from one of its ends. Appends its points without the last one, and returns the
  /// node at its other end.
  std::uint32_t append(std::uint32_t end, std::vector<Point2>& ring) {
    OpenChain& chain = chains_[end / 2];
    chain.is_used = true;
    std::vector<Point2> points(drawing_.ring(chain.ring).begin(), drawing_.ring(chain.ring).end());
    if (end % 2 != 0) std::reverse(points.begin(), points.end());
    points.pop_back();
    ring.insert(ring.end(), points.begin(), points.end());
    return chain.nodes[end % 2 == 0 ? 1 : 0];
  }

  void watch() {
    constexpr std::size_t kStepsPerCheckpoint = 4096;
    if (++steps_ % kStepsPerCheckpoint == 0) context_.checkpoint("join", steps_, 0);
  }

  SvgDrawing& drawing_;
  std::string_view text_;
  const std::string& name_;
  bool closes_open_chains_;
  Context& context_;
  std::vector<OpenChain> chains_;
  std::map<Key, std::uint32_t> nodes_;
  std::vector<std::vector<std::uint32_t>> ends_;  // For each node, the chains and their ends.
  std::size_t steps_ = 0;
  std::size_t moved_ = 0;
  std::size_t closed_ = 0;
};

/// Adds rings to a collector.
class RingAdder {
 public:
  RingAdder(TextCursor at, bool is_one_polygon, ShapeCollector& shapes)
      : at_(std::move(at)), is_one_polygon_(is_one_polygon), shapes_(shapes) {}

  template <class Points>
  void add(const Points& points) {
    constexpr std::size_t kFewest = 3;
    if (points.size() < kFewest) return shapes_.pass_over("lines that enclose nothing");
    const std::uint32_t first = shapes_.position_count();
    for (const Point2& p : points) add_point(p);
    add_point(points.front());
    shapes_.add_ring(first, shapes_.position_count());
    if (!is_one_polygon_) shapes_.end_polygon();
  }
  void finish() { shapes_.end_polygon(); }

 private:
  void add_point(Point2 p) {
    x_.set(p.x + 0.0);
    y_.set(p.y + 0.0);
    shapes_.add_position(at_, x_, y_);
  }

  TextCursor at_;
  bool is_one_polygon_;
  ShapeCollector& shapes_;
  ReadNumber x_, y_;
};

/// Whether the curve alone is a ring. A spline ends at its last control point if its first and last
/// knots are repeated.
bool is_ring(const DxfCurves& drawing, const DxfCurve& curve) {
  if (curve.is_closed) return true;
  if (curve.kind == DxfKind::Arc) return curve.to - curve.from >= 360;
  if (curve.kind == DxfKind::Spline) {
    const auto& knot = drawing.knots;
    const bool is_clamped = knot[curve.first_knot + 1] == knot[curve.first_knot + curve.degree] &&
                            knot[curve.end_knot - 2] == knot[curve.end_knot - 1 - curve.degree];
    if (!is_clamped) return false;
  }
  return drawing.vertices[curve.first_vertex].p == drawing.vertices[curve.end_vertex - 1].p;
}

/// Returns the greatest distance between ends of lines that rounding may cause.
double reach_of_rounding(const SvgDrawing& drawing) {
  constexpr double kShare = 0x1p-40;
  double largest = 0;
  for (const Point2& p : drawing.points) {
    largest = std::max({largest, std::fabs(p.x), std::fabs(p.y)});
  }
  return largest * kShare;
}

/// Flattens all curves. On return, `curve_of_ring` has the curve of each ring.
SvgDrawing flattened(const DxfCurves& drawing, SvgOutline outline, TextCursor& cursor,
                     std::vector<std::uint32_t>& curve_of_ring, Context& context) {
  constexpr std::uint32_t kCurvesPerCheckpoint = 1024;
  CurveFlattener flattener(drawing, outline);
  for (std::uint32_t c = 0; c < drawing.curves.size(); ++c) {
    if (c % kCurvesPerCheckpoint == 0) context.checkpoint("flatten", c, drawing.curves.size());
    cursor.move_to(drawing.curves[c].where);
    flattener.add(drawing.curves[c], cursor);
    while (curve_of_ring.size() < outline.ring_count()) curve_of_ring.push_back(c);
  }
  return outline.take();
}

}  // namespace

double extent_of(const DxfCurves& drawing) {
  constexpr double kFar = std::numeric_limits<double>::infinity();
  Point2 low{kFar, kFar}, high{-kFar, -kFar};
  const auto take = [&](Point2 p, Point2 reach) {
    low = {std::min(low.x, p.x - reach.x), std::min(low.y, p.y - reach.y)};
    high = {std::max(high.x, p.x + reach.x), std::max(high.y, p.y + reach.y)};
  };
  for (const DxfCurve& curve : drawing.curves) {
    const SvgTransform& t = curve.transform;
    if (curve.kind == DxfKind::Arc) {
      const Point2 u = applied({t.a, t.b, t.c, t.d, 0, 0}, curve.u);
      const Point2 v = applied({t.a, t.b, t.c, t.d, 0, 0}, curve.v);
      take(applied(t, curve.centre), {std::hypot(u.x, v.x), std::hypot(u.y, v.y)});
    }
    for (std::uint32_t i = curve.first_vertex; i < curve.end_vertex; ++i) {
      take(applied(t, drawing.vertices[i].p), {0, 0});
    }
  }
  return low.x > high.x ? 0 : std::max(high.x - low.x, high.y - low.y);
}

void add_dxf_rings(const DxfCurves& drawing, std::string_view text, const ReadOptions& options,
                   const DxfRingRules& rules, ShapeCollector& shapes, Context& context) {
  constexpr double kThousandth = 1e-3;
  const double by_itself = extent_of(drawing) * kThousandth;
  std::optional<double> tolerance = options.curve_tolerance;
  if (!tolerance && by_itself > 0 && std::isfinite(by_itself)) tolerance = by_itself;
  std::vector<std::uint32_t> curve_of_ring;
  TextCursor cursor(text, options.name);
  SvgDrawing flat =
      flattened(drawing, SvgOutline(text, tolerance, context), cursor, curve_of_ring, context);
  const double reach = reach_of_rounding(flat);
  std::vector<std::uint32_t> order(flat.ring_count());  // The rings, sorted by area.
  std::iota(order.begin(), order.end(), 0U);
  const auto area_of = [&](std::uint32_t r) { return drawing.curves[curve_of_ring[r]].area; };
  std::stable_sort(order.begin(), order.end(),
                   [&](std::uint32_t a, std::uint32_t b) { return area_of(a) < area_of(b); });
  MemoryCharge charge(context);
  std::size_t moved = 0, closed = 0;
  for (std::size_t i = 0; i < order.size();) {
    const std::uint32_t area = area_of(order[i]);
    ChainJoiner joiner(flat, text, options.name, rules.closes_open_chains, context);
    RingAdder rings(cursor, rules.is_one_polygon, shapes);
    for (; i < order.size() && area_of(order[i]) == area; ++i) {
      const std::uint32_t r = order[i];
      const DxfCurve& curve = drawing.curves[curve_of_ring[r]];
      if (is_ring(drawing, curve)) {
        rings.add(flat.ring(r));
        continue;
      }
      // The memory of the chain, two nodes and their ends.
      constexpr std::uint64_t kChainBytes = 256;
      charge.add(kChainBytes, "the chains of lines");
      const bool is_computed = curve.kind != DxfKind::Polyline;
      joiner.add({r, curve.where, is_computed, is_computed ? tolerance.value_or(0) : reach});
    }
    joiner.join([&rings](const std::vector<Point2>& ring) { rings.add(ring); });
    rings.finish();
    moved += joiner.moved();
    closed += joiner.closed();
  }
  if (moved > 0) {
    shapes.note("ends of lines that are apart by rounding only were joined (" +
                std::to_string(moved) + ")");
  }
  if (closed > 0) {
    shapes.note("open chains of lines were closed by straight lines, as OpenSCAD does (" +
                std::to_string(closed) + ")");
  }
}

}  // namespace plumb
