#include "plumb/convex/convex_body.h"

#include <algorithm>
#include <cmath>

#include "plumb/base/error.h"
#include "plumb/predicates/point3_signs.h"
#include "plumb/predicates/rounding.h"

namespace plumb {
namespace {

Ball ball_of(const Rational& x) {
  const double nearest = nearest_double(x);
  if (!std::isfinite(nearest)) return Ball::unknown();
  return Ball::about(nearest, std::fabs(nearest) * 0x1p-53);
}

BallVector balls_of(const RationalPoint3& p) {
  return {{ball_of(p.x), ball_of(p.y), ball_of(p.z)}};
}

BallVector balls_of(const PointBox& box) {
  BallVector v;
  for (std::size_t i = 0; i < 3; ++i) v.at[i] = Ball::about(box.mid[i], box.radius);
  return v;
}

class BodyReader {
 public:
  explicit BodyReader(const SpaceComplex& complex) : c_(complex) {}

  ConvexBody run() {
    PLUMB_CHECK(c_.vertex_count() > 0);
    add_points();
    for (std::uint32_t f = 0; f < c_.facet_count(); ++f) add_facet(FacetId(f));
    const bool is_flat = c_.volume_count() == 1;
    if (is_flat && c_.facet_count() == 1) add_back();
    add_edges(is_flat);
    out_.dimension = !is_flat ? 3 : c_.facet_count() == 1 ? 2 : c_.edge_count() == 1 ? 1 : 0;
    return std::move(out_);
  }

 private:
  void add_points() {
    for (std::uint32_t v = 0; v < c_.vertex_count(); ++v) {
      out_.point.push_back(exact(c_.points(), c_.vertex_point[v]));
      out_.rough_point.push_back(balls_of(c_.points().box(c_.vertex_point[v])));
    }
  }

  /// Of a polygon: its positive side.
  bool is_outer_side_positive(FacetId f) const {
    return c_.volume_mark[c_.facet_volume[f.value()][0].value()] == 0;
  }

  void add_facet(FacetId f) {
    const UseId first = c_.cycles_of(f)[0];
    UseId u = first;
    do {
      out_.corner.push_back(c_.use_origin(u).value());
      u = c_.use_next[u.value()];
    } while (u != first);
    if (!is_outer_side_positive(f)) {
      std::reverse(out_.corner.begin() + out_.facet_begin.back(), out_.corner.end());
    }
    out_.facet_begin.push_back(static_cast<std::uint32_t>(out_.corner.size()));
    add_normal(c_.facet_plane[f.value()], is_outer_side_positive(f) ? 1 : -1);
  }

  void add_normal(PlaneId plane, int sign) {
    const IntegerRow row = c_.planes().coefficients(plane);
    out_.normal.push_back(
        {Rational(sign * row[0]), Rational(sign * row[1]), Rational(sign * row[2])});
    const PlaneRow& rough = c_.planes().row(plane);
    BallVector n;
    for (std::size_t i = 0; i < 3; ++i)
      n.at[i] = Ball::about(sign * rough.n[i], rough.normal_error);
    out_.rough_normal.push_back(n);
  }

  void add_back() {
    const std::vector<std::uint32_t> front = out_.corner;
    out_.corner.insert(out_.corner.end(), front.rbegin(), front.rend());
    out_.facet_begin.push_back(static_cast<std::uint32_t>(out_.corner.size()));
    add_normal(c_.facet_plane[0], -1);
  }

  void add_edges(bool is_flat) {
    out_.star_begin = {0};
    for (std::uint32_t v = 0; v < c_.vertex_count(); ++v) {
      for (const HalfedgeId h : c_.star_of(VertexId(v))) {
        out_.neighbour.push_back(c_.target(h).value());
      }
      out_.star_begin.push_back(static_cast<std::uint32_t>(out_.neighbour.size()));
    }
    for (std::uint32_t e = 0; e < c_.edge_count(); ++e) add_edge(e, is_flat);
  }

  /// Facet and sense of a use, seen from outside.
  void add_edge(std::uint32_t e, bool is_flat) {
    ConvexBody::Edge edge{{c_.origin[2 * e].value(), c_.origin[2 * e + 1].value()},
                          {ConvexBody::kNone, ConvexBody::kNone}};
    const UseId any = c_.edge_use[e];
    if (any.is_valid()) {
      const UseId other = c_.use_radial[any.value()];
      const bool is_left = runs_forward(any);
      edge.side[is_left ? 0 : 1] = c_.use_facet[any.value()].value();
      edge.side[is_left ? 1 : 0] = is_flat ? 1 : c_.use_facet[other.value()].value();
    }
    out_.edge.push_back(edge);
  }

  /// Seen from outside, does the facet lie to the left of half-edge 2e?
  bool runs_forward(UseId u) const {
    const bool is_forward = !SpaceComplex::is_reverse(c_.use_halfedge[u.value()]);
    return is_forward == is_outer_side_positive(c_.use_facet[u.value()]);
  }

  const SpaceComplex& c_;
  ConvexBody out_;
};

void add_polygon_facets(ConvexBody& body) {
  const RationalPoint3 n = cross(body.point[1] - body.point[0], body.point[2] - body.point[0]);
  body.corner = {0, 1, 2, 2, 1, 0};
  body.facet_begin = {0, 3, 6};
  body.normal = {n, {-n.x, -n.y, -n.z}};
  for (const RationalPoint3& normal : body.normal) body.rough_normal.push_back(balls_of(normal));
}

}  // namespace

ConvexBody convex_body_of(const SpaceComplex& complex) { return BodyReader(complex).run(); }

std::size_t memory_bytes(const ConvexBody& body) {
  constexpr std::size_t kLimbBytes = 6 * 32;  // of the numbers of a point
  const auto bytes = [](const auto&... arrays) {
    return ((arrays.capacity() * sizeof(arrays[0])) + ...);
  };
  return kLimbBytes * (body.point.size() + body.normal.size()) +
         bytes(body.point, body.rough_point, body.star_begin, body.neighbour, body.edge,
               body.facet_begin, body.corner, body.normal, body.rough_normal);
}

ConvexBody convex_body_of(std::span<const RationalPoint3> points) {
  PLUMB_CHECK(!points.empty() && points.size() <= 3);
  ConvexBody body;
  body.dimension = static_cast<unsigned>(points.size() - 1);
  body.point.assign(points.begin(), points.end());
  for (const RationalPoint3& p : points) body.rough_point.push_back(balls_of(p));
  const auto n = static_cast<std::uint32_t>(points.size());
  body.star_begin = {0};
  for (std::uint32_t v = 0; v < n; ++v) {
    for (std::uint32_t w = 0; w < n; ++w) {
      if (w != v) body.neighbour.push_back(w);
    }
    body.star_begin.push_back(static_cast<std::uint32_t>(body.neighbour.size()));
  }
  if (n == 2) body.edge = {{{0, 1}, {ConvexBody::kNone, ConvexBody::kNone}}};
  if (n == 3) {
    body.edge = {{{0, 1}, {0, 1}}, {{1, 2}, {0, 1}}, {{2, 0}, {0, 1}}};
    add_polygon_facets(body);
  }
  return body;
}

}  // namespace plumb
