// The basic sets of the plane: half-planes, lines, polygons, polylines, points, and regions of
// checked maps.
//
// Chains of points become curves with winding jumps: across a curve of a polygon the winding number
// changes by 1, across a slit (a line or polyline) it does not. One sweep with WindingNumberRule
// then gives the minimal complex of the points that the winding rule selects, however the chains
// cross or overlap (docs/design/sweep.md).
//
// Declared in plumb/plane/nef2.h.
// Tested by tests/plane/nef2_test.cpp and tests/plane/nef2_property_test.cpp.

#include <algorithm>
#include <array>
#include <numeric>
#include <utility>

#include "plumb/plane/complex/plane_draft.h"
#include "plumb/plane/complex/plane_rules.h"
#include "plumb/plane/map_overlay.h"
#include "plumb/plane/nef2.h"
#include "plumb/predicates/arithmetic/double_bits.h"
#include "plumb/predicates/error.h"
#include "plumb/predicates/rational_predicates.h"

namespace plumb {
namespace {

/// Chains of points as curves with winding jumps.
struct ChainScene {
  SweepInput scene;
  std::vector<std::int8_t> jump;
  std::vector<std::uint8_t> is_point;

  explicit ChainScene(const PointTable2& points) : is_point(points.size(), 0) {
    scene.points.inputs = points;
  }

  void add_edge(std::uint32_t from, std::uint32_t to, std::int8_t winding_jump) {
    if (from == to) return;
    scene.curves.push_back({from, to, from, to});
    jump.push_back(winding_jump);
  }
  void add_point(std::uint32_t p) {
    scene.stops.push_back(p);
    is_point[p] = 1;
  }
  bool is_one_point(std::span<const std::uint32_t> chain) const {
    return std::all_of(chain.begin(), chain.end(), [&](std::uint32_t p) {
      return compare_xy(scene.points.inputs, p, chain.front()) == Sign::Zero;
    });
  }
  Nef2 build(WindingRule rule, Boundary boundary, Context& context, std::int32_t bottom = 0) {
    WindingNumberRule labels(scene.curves, std::move(jump), std::move(is_point), rule, boundary,
                             bottom);
    return Nef2::from_minimal_unchecked(build_complex(scene, labels, context));
  }
};

/// Throws Error{BadArgument} unless the chains cover all corners and refer to existing points.
void require_chains(const PointTable2& points, std::span<const std::uint32_t> corners,
                    std::span<const std::uint32_t> chain_begin) {
  const bool is_cover = !chain_begin.empty() && chain_begin.front() == 0 &&
                        chain_begin.back() == corners.size() &&
                        std::is_sorted(chain_begin.begin(), chain_begin.end());
  const bool in_range = std::all_of(corners.begin(), corners.end(),
                                    [&](std::uint32_t p) { return p < points.size(); });
  if (!is_cover || !in_range) {
    throw Error(ErrorCode::BadArgument, "chains must cover all corners and name points there are");
  }
}

template <class AddChain>
void for_each_chain(std::span<const std::uint32_t> corners,
                    std::span<const std::uint32_t> chain_begin, AddChain add) {
  for (std::size_t c = 0; c + 1 < chain_begin.size(); ++c) {
    const auto chain = corners.subspan(chain_begin[c], chain_begin[c + 1] - chain_begin[c]);
    if (!chain.empty()) add(chain);
  }
}

/// Returns a table of points. Throws Error{NotFinite}.
PointTable2 table_of(std::span<const Point2> points) {
  PointTable2 table;
  table.reserve(points.size());
  for (const Point2& p : points) {
    if (!is_finite(p.x) || !is_finite(p.y)) {
      throw Error(ErrorCode::NotFinite, "the coordinates of a point must be finite numbers");
    }
    table.push_back(p);
  }
  return table;
}

/// One chain of all points in their order.
struct OneChain {
  std::vector<std::uint32_t> corners;
  std::array<std::uint32_t, 2> begin;

  explicit OneChain(std::size_t n) : corners(n), begin{0, static_cast<std::uint32_t>(n)} {
    std::iota(corners.begin(), corners.end(), std::uint32_t{0});
  }
};

/// Returns a table of the two points of a line. Throws Error{BadArgument} if they are equal.
PointTable2 table_of(const Line2& line) {
  if (line.a == line.b) {
    throw Error(ErrorCode::BadArgument, "a line needs two different points");
  }
  PointTable2 table;
  table.push_back(line.a.x, line.a.y);
  table.push_back(line.b.x, line.b.y);
  return table;
}

/// Returns the part of a line that begins at `from`, or the whole line, as a slit.
Nef2 slit(const Line2& line, std::uint32_t from) {
  ChainScene chains(table_of(line));
  chains.scene.curves.push_back({from, SweepCurve::kUnbounded, 0, 1});
  chains.jump.push_back(0);
  Context& context = unlimited_context();
  return chains.build(WindingRule::NonZero, Boundary::Closed, context);
}

/// Whether the place far down, and then much further to the left, lies to the left of a -> b. Face
/// 0 contains this place.
bool is_bottom_on_left(const Line2& line) {
  const Sign by_x = sign_of(line.b.x.compare(line.a.x));
  return by_x != Sign::Zero ? by_x == Sign::Negative : line.a.y < line.b.y;
}

}  // namespace

Line2 Line2::from_coefficients(const Rational& a, const Rational& b, const Rational& c) {
  if (a == 0 && b == 0) {
    throw Error(ErrorCode::BadArgument, "a line needs a coefficient of x or y that is not 0");
  }
  const RationalPoint2 on = b != 0 ? RationalPoint2{0, -c / b} : RationalPoint2{-c / a, 0};
  return {on, {on.x - b, on.y + a}};
}

Nef2 Nef2::half_plane(const Line2& line, Boundary boundary) {
  ChainScene chains(table_of(line));
  chains.scene.curves.push_back({SweepCurve::kUnbounded, SweepCurve::kUnbounded, 0, 1});
  chains.jump.push_back(1);
  Context& context = unlimited_context();
  return chains.build(WindingRule::Positive, boundary, context, is_bottom_on_left(line) ? 1 : 0);
}

Nef2 Nef2::half_plane(const Line2& line, const RationalPoint2& kept, Boundary boundary) {
  if (line.a == line.b) return half_plane(line, boundary);
  const Sign side = orient2d(line.a, line.b, kept);
  if (side == Sign::Zero) {
    throw Error(ErrorCode::BadArgument, "the point on the kept side lies on the line");
  }
  return half_plane(side == Sign::Positive ? line : Line2{line.b, line.a}, boundary);
}

Nef2 Nef2::line(const Line2& line) { return slit(line, SweepCurve::kUnbounded); }

Nef2 Nef2::ray(const Line2& line, Boundary boundary) {
  Nef2 closed = slit(line, 0);
  if (boundary == Boundary::Closed) return closed;
  PlaneMarks marks = closed.complex().marks;
  marks.vertex[0] = 0;
  return closed.with_marks(std::move(marks));
}

Nef2 Nef2::polygons(const PointTable2& points, std::span<const std::uint32_t> corners,
                    std::span<const std::uint32_t> chain_begin, WindingRule rule, Boundary boundary,
                    Context& context) {
  require_chains(points, corners, chain_begin);
  ChainScene chains(points);
  chains.scene.curves.reserve(corners.size());
  chains.jump.reserve(corners.size());
  for_each_chain(corners, chain_begin, [&](std::span<const std::uint32_t> chain) {
    if (chains.is_one_point(chain)) {
      chains.add_point(chain.front());
      return;
    }
    for (std::size_t i = 0; i < chain.size(); ++i) {
      chains.add_edge(chain[i], chain[i + 1 < chain.size() ? i + 1 : 0], 1);
    }
  });
  return chains.build(rule, boundary, context);
}

Nef2 Nef2::polygon(std::span<const Point2> points, Boundary boundary, Context& context) {
  const OneChain chain(points.size());
  return polygons(table_of(points), chain.corners, chain.begin, WindingRule::NonZero, boundary,
                  context);
}

Nef2 Nef2::polylines(const PointTable2& points, std::span<const std::uint32_t> corners,
                     std::span<const std::uint32_t> chain_begin, Context& context) {
  require_chains(points, corners, chain_begin);
  ChainScene chains(points);
  for_each_chain(corners, chain_begin, [&](std::span<const std::uint32_t> chain) {
    if (chains.is_one_point(chain)) {
      chains.add_point(chain.front());
      return;
    }
    for (std::size_t i = 0; i + 1 < chain.size(); ++i) chains.add_edge(chain[i], chain[i + 1], 0);
  });
  return chains.build(WindingRule::NonZero, Boundary::Closed, context);
}

Nef2 Nef2::polyline(std::span<const Point2> points, Context& context) {
  const OneChain chain(points.size());
  return polylines(table_of(points), chain.corners, chain.begin, context);
}

Nef2 Nef2::points(const PointTable2& points, Context& context) {
  ChainScene chains(points);
  for (std::uint32_t i = 0; i < points.size(); ++i) chains.add_point(i);
  return chains.build(WindingRule::NonZero, Boundary::Closed, context);
}

Nef2 Nef2::point(const RationalPoint2& point) {
  PointTable2 table;
  table.push_back(point.x, point.y);
  Context& context = unlimited_context();
  return points(table, context);
}

Nef2 Nef2::subdivision(const MapReport& report, std::span<const std::uint8_t> chosen,
                       Boundary boundary, Context& context) {
  if (chosen.size() != report.regions.size()) {
    throw Error(ErrorCode::BadArgument, "one choice is needed for each region");
  }
  MapOverlay map = overlay_map(report, context);
  PlaneComplex& complex = map.complex;
  for (std::size_t f = 0; f < complex.face_count(); ++f) {
    complex.marks.face[f] = chosen[map.origin[f].first] != 0 ? 1 : 0;
  }
  if (boundary == Boundary::Open) {
    complex.marks.edge.assign(complex.edge_count(), 1);
    complex.marks.vertex.assign(complex.vertex_count(), 1);
  }
  complex.marks = boundary == Boundary::Open ? interior_marks(complex) : closure_marks(complex);
  return from_complex(std::move(complex));
}

}  // namespace plumb
