// Minkowski sums of two convex bodies, facet by facet of the sum.
//
// Directions (second half of this file) finds the outer normals of the sum: normals of facets of
// one operand, whose extreme face in the other is reached by climbing from the face of a
// neighbouring facet, and normals n = d x e of two extreme edges, found by turning about each edge
// d of one operand and gift-wrapping the other (EdgeWalk). Climbing terminates at a maximum because
// the body is convex.
//
// SumBuilder merges the boundary cycles of the two faces in each direction by angle, as in the sum
// of two convex polygons (M. de Berg et al., Computational Geometry, chapter 13), and names each
// corner by its pair (a, b). Invariant: one vertex of the sum has one pair, so facets fit together
// by names alone and no point is ever compared. A vertex whose coordinates are doubles becomes an
// input point. Any other vertex is the common point of three facets. Proof: docs/design/walls.md,
// section Minkowski sums.
// Declared in sum/convex_sum.h, whose opening comment gives the main flow.
// Tested by tests/convex/minkowski_test.cpp.
#include "plumb/convex/sum/convex_sum.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "plumb/predicates/arithmetic/seeded_hash.h"
#include "plumb/predicates/error.h"
#include "plumb/predicates/point3_signs.h"
#include "plumb/predicates/rounding.h"
#include "plumb/space/mesh/link_facets.h"

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

/// Reads a body from the minimal complex of a closed convex set.
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

  /// Whether the outer side of the facet is the positive side of its plane. For a polygon, this
  /// means that the facet is its front.
  bool is_outer_side_positive(FacetId f) const {
    return c_.volume_mark[c_.facet_volume[f][0]] == 0;
  }

  void add_facet(FacetId f) {
    const UseId first = c_.cycles_of(f)[0];
    UseId u = first;
    do {
      out_.corner.push_back(c_.use_origin(u).value());
      u = c_.use_next[u];
    } while (u != first);
    if (!is_outer_side_positive(f)) {
      std::reverse(out_.corner.begin() + out_.facet_begin.back(), out_.corner.end());
    }
    out_.facet_begin.push_back(static_cast<std::uint32_t>(out_.corner.size()));
    add_normal(c_.facet_plane[f], is_outer_side_positive(f) ? 1 : -1);
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

  /// Adds an edge with the facets beside it. Seen from outside, the left facet is the one that runs
  /// forward along the edge. The other facet of a flat body is its back.
  void add_edge(std::uint32_t e, bool is_flat) {
    ConvexBody::Edge edge{{c_.origin[2 * e].value(), c_.origin[2 * e + 1].value()}, {kNone, kNone}};
    const UseId any = c_.edge_use[e];
    if (any.is_valid()) {
      const UseId other = c_.use_radial[any];
      const bool is_left = runs_forward(any);
      edge.side[is_left ? 0 : 1] = c_.use_facet[any].value();
      edge.side[is_left ? 1 : 0] = is_flat ? 1 : c_.use_facet[other].value();
    }
    out_.edge.push_back(edge);
  }

  /// Whether the facet lies, seen from outside, to the left of half-edge 2e.
  bool runs_forward(UseId u) const {
    const bool is_forward = !SpaceComplex::is_reverse(c_.use_halfedge[u]);
    return is_forward == is_outer_side_positive(c_.use_facet[u]);
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
  // This is the memory for the numbers of a point, in bytes.
  constexpr std::size_t kLimbBytes = 6 * 32;
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
  if (n == 2) body.edge = {{{0, 1}, {kNone, kNone}}};
  if (n == 3) {
    body.edge = {{{0, 1}, {0, 1}}, {{1, 2}, {0, 1}}, {{2, 0}, {0, 1}}};
    add_polygon_facets(body);
  }
  return body;
}

namespace {

/// Steps 3 and 4: makes facets from the faces of the operands, in one complex.
class SumBuilder {
 public:
  SumBuilder(const ConvexBody& a, const ConvexBody& b, Context& context)
      : a_(a), b_(b), tables_(std::make_shared<SpaceTables>()), memory_(context) {}

  /// Makes one facet of the sum. Its plane has the direction's normal and goes through the sum of
  /// any pair of its corners.
  void add_facet(const FacetDirection& d) {
    if (facets_.size() >= charged_) charge();
    cycle_.clear();
    merge(d);
    const auto [i, j] = names_[cycle_[0]];
    const Rational offset = -(dot(d.normal, a_.point[i]) + dot(d.normal, b_.point[j]));
    const OrientedPlane plane = tables_->planes.intern(d.normal.x, d.normal.y, d.normal.z, offset);
    PLUMB_CHECK(plane.is_valid() && cycle_.size() >= 3);
    // Cycles are stored as seen from the positive side of the plane.
    if (plane.is_opposite()) std::reverse(cycle_.begin(), cycle_.end());
    std::rotate(cycle_.begin(), std::min_element(cycle_.begin(), cycle_.end()), cycle_.end());
    facets_.corner.insert(facets_.corner.end(), cycle_.begin(), cycle_.end());
    facets_.begin.push_back(static_cast<std::uint32_t>(facets_.corner.size()));
    facets_.plane.push_back(plane.plane());
    facets_.jump.push_back(0);
    facets_.origin.push_back(static_cast<std::uint32_t>(facets_.origin.size()));
    outer_side_.push_back(plane.is_opposite() ? 1 : 0);
  }

  /// Links the facets by the pairs that represent their corners. The complex is already minimal: no
  /// two facets share a plane, and every vertex is extreme.
  Nef3 finish(bool is_flat, SumMarks marks) {
    SpaceComplex c = linked(is_flat);
    const Mark boundary = marks == SumMarks::Closed ? 1 : 0;
    std::fill(c.facet_mark.begin(), c.facet_mark.end(), is_flat ? Mark{1} : boundary);
    std::fill(c.edge_mark.begin(), c.edge_mark.end(), boundary);
    std::fill(c.vertex_mark.begin(), c.vertex_mark.end(), boundary);
    return Nef3::from_minimal_unchecked(std::move(c));
  }

  /// Makes a sum of dimension 3, with the given marks of its facets. `mark_of` returns the marks of
  /// its edges and vertices.
  Nef3 finish(std::span<const Mark> facet_mark, const FaceMarker& mark_of) {
    SpaceComplex c = linked(false);
    std::copy(facet_mark.begin(), facet_mark.end(), c.facet_mark.begin());
    for (std::uint32_t v = 0; v < c.vertex_count(); ++v) {
      c.vertex_mark[v] =
          mark_of(0, std::span(&names_[v].first, 1), std::span(&names_[v].second, 1));
    }
    for (std::uint32_t e = 0; e < c.edge_count(); ++e) {
      const Name from = names_[c.origin[2 * e].value()], to = names_[c.origin[2 * e + 1].value()];
      const std::array<std::uint32_t, 2> of_a{from.first, to.first}, of_b{from.second, to.second};
      c.edge_mark[e] = mark_of(1, std::span(of_a).first(of_a[0] == of_a[1] ? 1 : 2),
                               std::span(of_b).first(of_b[0] == of_b[1] ? 1 : 2));
    }
    return Nef3::from_minimal_unchecked(std::move(c));
  }

 private:
  using Name = std::pair<std::uint32_t, std::uint32_t>;

  /// Returns the complex of the facets with the marks of its volumes.
  SpaceComplex linked(bool is_flat) {
    make_points(is_flat);
    const MeshLinks links = link_corners(facets_, names_.size());
    SpaceComplex c = link_facets(facets_, links, point_, tables_);
    const VolumeId outside(0), inside(is_flat ? 0U : 1U);
    c.volume_mark.assign(is_flat ? 1 : 2, 1);
    c.volume_mark[0] = 0;
    for (std::size_t f = 0; f < c.facet_count(); ++f) {
      c.facet_volume[f][outer_side_[f]] = outside;
      c.facet_volume[f][1U - outer_side_[f]] = inside;
    }
    return c;
  }

  /// Charges memory for as many further facets as are charged already, so the cost is amortised.
  void charge() {
    constexpr std::size_t kFew = 64, kBytesPerFacet = 400;
    const std::size_t more = std::max(kFew, charged_);
    memory_.add(kBytesPerFacet * more, "a convex sum");
    charged_ += more;
  }

  std::uint32_t vertex(std::uint32_t i, std::uint32_t j) {
    const auto next = static_cast<std::uint32_t>(names_.size());
    const auto hash = static_cast<std::uint32_t>(SeededHash()(std::uint64_t{i} << 32U | j));
    const std::uint32_t found = number_.find_or_add(
        hash, next, [&](std::uint32_t name) { return names_[name] == Name(i, j); });
    if (found == next) names_.emplace_back(i, j);
    return found;
  }

  // ---- merging two cycles

  /// Returns the lexicographically least corner. At this corner, both cycles begin with the same
  /// direction, so the merge can start there.
  static std::size_t least(const ConvexBody& body, std::span<const std::uint32_t> cycle) {
    const auto is_less = [&](std::uint32_t v, std::uint32_t w) {
      const RationalPoint3 &p = body.point[v], &q = body.point[w];
      if (p.x != q.x) return p.x < q.x;
      return p.y != q.y ? p.y < q.y : p.z < q.z;
    };
    return static_cast<std::size_t>(std::min_element(cycle.begin(), cycle.end(), is_less) -
                                    cycle.begin());
  }

  /// Merges the two cycles. The corners are counter-clockwise, seen along the normal. Each step
  /// takes the edge that comes first by angle, or both edges if they are parallel.
  void merge(const FacetDirection& direction) {
    const std::span<const std::uint32_t> a = direction.face_a, b = direction.face_b;
    const std::size_t first_a = least(a_, a), first_b = least(b_, b);
    const std::size_t edges_a = a.size() == 1 ? 0 : a.size();
    const std::size_t edges_b = b.size() == 1 ? 0 : b.size();
    const auto at = [](std::span<const std::uint32_t> cycle, std::size_t first, std::size_t i) {
      return cycle[(first + i) % cycle.size()];
    };
    std::size_t i = 0, j = 0;
    while (i < edges_a || j < edges_b) {
      const std::uint32_t v = at(a, first_a, i), w = at(b, first_b, j);
      cycle_.push_back(vertex(v, w));
      Sign turn = i == edges_a ? Sign::Negative : Sign::Positive;
      if (i < edges_a && j < edges_b) {
        turn = turn_of(direction, {v, at(a, first_a, i + 1)}, {w, at(b, first_b, j + 1)});
      }
      if (turn != Sign::Negative) ++i;
      if (turn != Sign::Positive) ++j;
    }
  }

  /// Returns the turn from an edge of a to an edge of b about the normal.
  Sign turn_of(const FacetDirection& direction, Name of_a, Name of_b) const {
    const BallVector d = a_.rough_point[of_a.second] - a_.rough_point[of_a.first];
    const BallVector e = b_.rough_point[of_b.second] - b_.rough_point[of_b.first];
    const FilteredSign s = dot(direction.rough_normal, cross(d, e)).sign();
    if (is_decided(s)) return decided(s);
    return sign_of(dot(direction.normal, cross(a_.point[of_a.second] - a_.point[of_a.first],
                                               b_.point[of_b.second] - b_.point[of_b.first])));
  }

  // ---- vertices

  void make_points(bool is_flat) {
    const Incidence facets(facets_, names_.size());
    for (std::uint32_t v = 0; v < names_.size(); ++v) {
      point_.push_back(make_point(v, is_flat ? std::span<const std::uint32_t>() : facets.of(v)));
    }
  }

  /// The facets at each vertex.
  class Incidence {
   public:
    Incidence(const MeshFacets& facets, std::size_t vertices) : begin_(vertices + 1, 0) {
      for (const std::uint32_t v : facets.corner) ++begin_[v + 1];
      for (std::size_t v = 0; v < vertices; ++v) begin_[v + 1] += begin_[v];
      facet_.resize(facets.corner.size());
      std::vector<std::uint32_t> at(begin_.begin(), begin_.end() - 1);
      for (std::uint32_t f = 0; f < facets.size(); ++f) {
        for (const std::uint32_t v : facets.corners(f)) facet_[at[v]++] = f;
      }
    }
    std::span<const std::uint32_t> of(std::uint32_t v) const {
      return std::span(facet_).subspan(begin_[v], begin_[v + 1] - begin_[v]);
    }

   private:
    std::vector<std::uint32_t> begin_, facet_;
  };

  /// Returns an input point if doubles can represent the sum. Otherwise, returns the common point
  /// of three facets around the vertex.
  SpacePoint make_point(std::uint32_t v, std::span<const std::uint32_t> facets) {
    const auto [i, j] = names_[v];
    const RationalPoint3 &p = a_.point[i], &q = b_.point[j];
    const RationalPoint3 sum{p.x + q.x, p.y + q.y, p.z + q.z};
    if (facets.empty() || is_double(sum)) return add_point(*tables_, sum);
    const std::vector<PlaneId>& plane = facets_.plane;
    SpacePoint x;
    for (std::size_t k = 2; k < facets.size() && !x.is_valid(); ++k) {
      x = tables_->points.add(plane[facets[0]], plane[facets[1]], plane[facets[k]]);
    }
    PLUMB_CHECK(x.is_valid());  // Three of the planes meet only in the vertex.
    return x;
  }

  static bool is_double(const RationalPoint3& p) {
    const auto is = [](const Rational& x) { return round_to_double(x).error == Sign::Zero; };
    return is(p.x) && is(p.y) && is(p.z);
  }

  const ConvexBody& a_;
  const ConvexBody& b_;
  std::shared_ptr<SpaceTables> tables_;
  IdIndex number_;           // An index of names_.
  std::vector<Name> names_;  // Pairs of vertices of a and b.
  std::vector<SpacePoint> point_;
  MeshFacets facets_;
  // The outer side of each facet's plane; 0 is the positive side.
  std::vector<std::uint32_t> outer_side_;
  std::vector<std::uint32_t> cycle_;
  MemoryCharge memory_;
  std::size_t charged_ = 0;  // The number of facets for which memory was charged.
};

RationalPoint3 sum_of(const RationalPoint3& p, const RationalPoint3& q) {
  return {p.x + q.x, p.y + q.y, p.z + q.z};
}

/// Returns the sum of two points, of a segment and a point, or of parallel segments.
Nef3 thin_sum(const ConvexBody& a, const ConvexBody& b, SumMarks marks) {
  std::vector<RationalPoint3> points;
  for (const RationalPoint3& p : a.point) {
    for (const RationalPoint3& q : b.point) points.push_back(sum_of(p, q));
  }
  const auto is_less = [](const RationalPoint3& p, const RationalPoint3& q) {
    if (p.x != q.x) return p.x < q.x;
    return p.y != q.y ? p.y < q.y : p.z < q.z;
  };
  const auto [least, greatest] = std::minmax_element(points.begin(), points.end(), is_less);
  if (*least == *greatest) return Nef3::point(*least);
  SpaceComplex c = Nef3::segment(*least, *greatest).complex();
  if (marks == SumMarks::Open) c.vertex_mark.assign(c.vertex_count(), 0);
  return Nef3::from_minimal_unchecked(std::move(c));
}

bool is_zero(const RationalPoint3& v) { return v.x == 0 && v.y == 0 && v.z == 0; }

/// Returns the normal of a plane that is parallel to both operands, or zero if there is none.
RationalPoint3 common_normal(const ConvexBody& a, const ConvexBody& b) {
  if (a.dimension == 3 || b.dimension == 3) return {0, 0, 0};
  if (a.dimension < 2 && b.dimension < 2) {
    if (a.dimension == 0 || b.dimension == 0) return {0, 0, 0};
    return cross(a.point[1] - a.point[0], b.point[1] - b.point[0]);
  }
  const ConvexBody& flat = a.dimension == 2 ? a : b;
  const ConvexBody& other = a.dimension == 2 ? b : a;
  const RationalPoint3& n = flat.normal[0];
  for (const RationalPoint3& p : other.point) {
    if (dot(n, p - other.point[0]) != 0) return {0, 0, 0};
  }
  return n;
}

/// Returns the whole of an operand that is planar. It is its own face in the direction of the
/// plane's normal. The corners are counter-clockwise about that normal.
std::vector<std::uint32_t> flat_face(const ConvexBody& body, const RationalPoint3& normal) {
  if (body.dimension == 0) return {0};
  if (body.dimension == 1) return {0, 1};
  const std::size_t f = dot(body.normal[0], normal) > 0 ? 0 : 1;
  return {body.corners(f).begin(), body.corners(f).end()};
}

}  // namespace

Nef3 convex_sum(const ConvexBody& a, const ConvexBody& b, SumMarks marks, Context& context) {
  context.checkpoint("convex sum", 0, 1);
  const RationalPoint3 normal = common_normal(a, b);
  const bool is_flat = !is_zero(normal);
  if (a.dimension < 2 && b.dimension < 2 && !is_flat) return thin_sum(a, b, marks);
  SumBuilder builder(a, b, context);
  if (is_flat) {
    const auto face_a = flat_face(a, normal), face_b = flat_face(b, normal);
    const BallVector unknown{{Ball::unknown(), Ball::unknown(), Ball::unknown()}};
    builder.add_facet({normal, unknown, face_a, face_b});
  } else {
    for_each_direction(
        a, b, [&](const FacetDirection& d) { builder.add_facet(d); }, context);
  }
  return builder.finish(is_flat, marks);
}

Nef3 convex_sum(const ConvexBody& a, const ConvexBody& b, const FaceMarker& mark_of,
                Context& context) {
  context.checkpoint("convex sum", 0, 1);
  SumBuilder builder(a, b, context);
  std::vector<Mark> facet_mark;
  const auto add = [&](const FacetDirection& d) {
    builder.add_facet(d);
    facet_mark.push_back(mark_of(2, d.face_a, d.face_b));
  };
  for_each_direction(a, b, add, context);
  return builder.finish(facet_mark, mark_of);
}

// The directions of the facets of a sum (for_each_direction()).
namespace {

/// A direction, as exact numbers and as balls.
struct Heading {
  const RationalPoint3& exact;
  const BallVector& rough;
};

Heading normal_of(const ConvexBody& body, std::uint32_t f) {
  return {body.normal[f], body.rough_normal[f]};
}

/// The step between two vertices of a body. Its rationals are computed when they are needed.
struct Step {
  const ConvexBody* body;
  std::uint32_t from;
  std::uint32_t to;
  BallVector rough;

  Step(const ConvexBody& of, std::uint32_t i, std::uint32_t j)
      : body(&of), from(i), to(j), rough(of.rough_point[j] - of.rough_point[i]) {}
  RationalPoint3 exact() const { return body->point[to] - body->point[from]; }
};

Sign dot_sign(const Step& w, const Heading& n) {
  const FilteredSign s = dot(w.rough, n.rough).sign();
  return is_decided(s) ? decided(s) : sign_of(dot(w.exact(), n.exact));
}

/// Returns the sign of det(d, v, w).
Sign det_sign(const Step& d, const Step& v, const Step& w) {
  const FilteredSign s = dot(cross(d.rough, v.rough), w.rough).sign();
  return is_decided(s) ? decided(s) : sign_of(dot(cross(d.exact(), v.exact()), w.exact()));
}

/// Returns the sign of det(d, n, w). It is Positive if w is ahead when a direction turns about d
/// away from n.
Sign ahead_sign(const Step& d, const Heading& n, const Step& w) {
  const FilteredSign s = dot(cross(d.rough, n.rough), w.rough).sign();
  return is_decided(s) ? decided(s) : sign_of(dot(cross(d.exact(), n.exact), w.exact()));
}

/// Returns a vertex that is greatest in the direction. The function climbs from vertex to vertex.
/// On a convex body, a local maximum is a global maximum.
std::uint32_t climb(const ConvexBody& body, std::uint32_t v, const Heading& n) {
  for (;;) {
    std::uint32_t better = kNone;
    for (const std::uint32_t w : body.star(v)) {
      if (dot_sign(Step(body, v, w), n) != Sign::Positive) continue;
      better = w;
      break;
    }
    if (better == kNone) return v;
    v = better;
  }
}

/// Visits the facets of a body, each after a facet beside it. The call visit(facet, vertex to start
/// from) returns the vertex where it ended.
template <class Visit>
void for_each_facet_nearby(const ConvexBody& body, const Visit& visit) {
  std::vector<std::vector<std::uint32_t>> beside(body.facet_count());
  for (const ConvexBody::Edge& e : body.edge) {
    beside[e.side[0]].push_back(e.side[1]);
    beside[e.side[1]].push_back(e.side[0]);
  }
  std::vector<std::uint32_t> queue{0}, start(body.facet_count(), kNone);
  start[0] = 0;
  for (std::size_t i = 0; i < queue.size(); ++i) {
    const std::uint32_t end = visit(queue[i], start[queue[i]]);
    for (const std::uint32_t g : beside[queue[i]]) {
      if (start[g] != kNone) continue;
      start[g] = end;
      queue.push_back(g);
    }
  }
}

/// The vertices of the other operand around which the walk about one edge turns.
class EdgeWalk {
 public:
  /// `d` is the edge about which the walk turns, and `body` is the other operand.
  EdgeWalk(const ConvexBody& body, const Step& d, const Heading& from, const Heading& to)
      : body_(body), d_(d), from_(from), to_(to) {}

  /// Calls visit(v, w) for every edge of the body that is not parallel to d and is extreme in a
  /// direction strictly between the two directions. Requires that v is extreme in the first
  /// direction.
  template <class Visit>
  void run(std::uint32_t v, const Visit& visit) {
    settle(v);
    for (;;) {
      gather_next();
      if (next_.empty() || dot_sign(next_[0], to_) != Sign::Positive) return;
      if (next_.size() == 1) visit(next_[0].from, next_[0].to);
      cross_over();
    }
  }

 private:
  /// Leaves the first direction, and moves as far ahead as the extreme face in that direction
  /// allows.
  void settle(std::uint32_t v) {
    for (bool moves = true; moves;) {
      moves = false;
      for (const std::uint32_t w : body_.star(v)) {
        const Step step(body_, v, w);
        if (dot_sign(step, from_) != Sign::Zero) continue;
        if (ahead_sign(d_, from_, step) != Sign::Positive) continue;
        v = w;
        moves = true;
        break;
      }
    }
    stand_at(v);
  }

  /// Sets the position to v, and to the other end of an edge parallel to d if there is one.
  void stand_at(std::uint32_t v) {
    at_ = {v, kNone};
    for (const std::uint32_t w : body_.star(v)) {
      const Step step(body_, v, w);
      if (dot_sign(step, from_) == Sign::Zero && ahead_sign(d_, from_, step) == Sign::Zero) {
        at_[1] = w;
      }
    }
  }

  /// Collects the edges that the walk meets next, which all have one direction seen along d (gift
  /// wrapping).
  void gather_next() {
    next_.clear();
    for (const std::uint32_t v : at_) {
      if (v == kNone) continue;
      for (const std::uint32_t w : body_.star(v)) {
        if (w == at_[0] || w == at_[1]) continue;
        const Step step(body_, v, w);
        const Sign turn = next_.empty() ? Sign::Zero : det_sign(d_, next_[0], step);
        if (turn == Sign::Negative) next_.clear();
        if (turn != Sign::Positive) next_.push_back(step);
      }
    }
  }

  /// Moves to the far end of the edge or facet that contains next_, by climbing along it.
  void cross_over() {
    const Step first = next_[0];
    std::uint32_t v = first.to;
    if (next_.size() > 1) {
      const RationalPoint3 along = first.exact(), d = d_.exact();
      const RationalPoint3 normal = cross(along, d), ahead = cross(d, normal);
      for (bool moves = true; moves;) {
        moves = false;
        for (const std::uint32_t w : body_.star(v)) {
          const RationalPoint3 step = body_.point[w] - body_.point[v];
          if (dot(step, normal) != 0 || dot(step, ahead) <= 0) continue;
          v = w;
          moves = true;
          break;
        }
      }
    }
    stand_at(v);
  }

  const ConvexBody& body_;
  const Step& d_;
  Heading from_, to_;
  std::array<std::uint32_t, 2> at_{};
  std::vector<Step> next_;
};

/// The directions of a sum, seen from the operand `own`, which has facets. `is_swapped` states that
/// `own` is the second operand.
class Directions {
 public:
  Directions(const ConvexBody& own, const ConvexBody& other, bool is_swapped,
             const std::function<void(const FacetDirection&)>& visit)
      : own_(own), other_(other), is_swapped_(is_swapped), visit_(visit) {
    facets_at_.resize(other.point.size());
    for (std::uint32_t f = 0; f < other.facet_count(); ++f) {
      for (const std::uint32_t v : other.corners(f)) facets_at_[v].push_back(f);
    }
  }

  /// Finds a vertex of the other operand for each facet of `own` and visits the directions, except
  /// those with a facet on the other side if `skips_common`.
  void facets(bool skips_common) {
    extreme_.resize(own_.facet_count());
    for_each_facet_nearby(own_, [&](std::uint32_t f, std::uint32_t start) {
      extreme_[f] = climb(other_, start, normal_of(own_, f));
      face_of(extreme_[f], normal_of(own_, f));
      if (!skips_common || face_.size() < 3) emit(normal_of(own_, f), own_.corners(f), face_);
      return extreme_[f];
    });
  }

  /// Visits the directions of pairs of edges. Requires that facets() was called before.
  void edges(Context& context) {
    for (std::size_t e = 0; e < own_.edge.size(); ++e) {
      if (e % 1024 == 0) context.checkpoint("convex sum", e, own_.edge.size());
      walk(own_.edge[e]);
    }
  }

 private:
  void walk(const ConvexBody::Edge& edge) {
    const Step d(own_, edge.end[0], edge.end[1]);
    const auto [left, right] = edge.side;
    EdgeWalk walk(other_, d, normal_of(own_, left), normal_of(own_, right));
    walk.run(extreme_[left], [&](std::uint32_t v, std::uint32_t w) {
      const Step step(other_, v, w);
      const RationalPoint3 normal = cross(step.exact(), d.exact());
      const BallVector rough = cross(step.rough, d.rough);
      const std::array<std::uint32_t, 2> other{v, w};
      emit({normal, rough}, edge.end, other);
    });
  }

  /// Sets face_ to the face of the other operand in a direction. Requires that v is one of its
  /// vertices.
  void face_of(std::uint32_t v, const Heading& n) {
    face_.assign(1, v);
    for (const std::uint32_t w : other_.star(v)) {
      if (dot_sign(Step(other_, v, w), n) == Sign::Zero) face_.push_back(w);
    }
    if (face_.size() < 3) return;
    const auto f = std::find_if(facets_at_[v].begin(), facets_at_[v].end(), [&](std::uint32_t g) {
      return is_parallel(other_.normal[g], n.exact);
    });
    PLUMB_CHECK(f != facets_at_[v].end());
    face_.assign(other_.corners(*f).begin(), other_.corners(*f).end());
  }

  static bool is_parallel(const RationalPoint3& m, const RationalPoint3& n) {
    const RationalPoint3 c = cross(m, n);
    return c.x == 0 && c.y == 0 && c.z == 0 && dot(m, n) > 0;
  }

  void emit(const Heading& normal, std::span<const std::uint32_t> own,
            std::span<const std::uint32_t> other) {
    if (is_swapped_) {
      visit_({normal.exact, normal.rough, other, own});
    } else {
      visit_({normal.exact, normal.rough, own, other});
    }
  }

  const ConvexBody& own_;
  const ConvexBody& other_;
  bool is_swapped_;
  const std::function<void(const FacetDirection&)>& visit_;
  std::vector<std::vector<std::uint32_t>> facets_at_;  // The facets at each vertex of other_.
  std::vector<std::uint32_t> extreme_;  // For each facet of own_, an extreme vertex of other_.
  std::vector<std::uint32_t> face_;
};

}  // namespace

void for_each_direction(const ConvexBody& a, const ConvexBody& b,
                        const std::function<void(const FacetDirection&)>& visit, Context& context) {
  PLUMB_CHECK(a.facet_count() + b.facet_count() > 0);
  Directions of_a(a, b, false, visit), of_b(b, a, true, visit);
  if (a.facet_count() > 0) of_a.facets(false);
  if (b.facet_count() > 0) of_b.facets(a.facet_count() > 0);
  // Both operands would find the same crossings of arcs, so one operand is enough.
  (a.facet_count() > 0 ? of_a : of_b).edges(context);
}

}  // namespace plumb
