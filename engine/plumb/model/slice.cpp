// Slices and shadows.
//
// The result of a Boolean with a plane z = c is flat: all its facets lie in this plane. Its edges
// are curves of the arrangement from which the subdivision of the plane is made. They cross
// nowhere, so each edge of the arrangement is one edge of the flat set, and takes its mark; the
// face on a side takes the mark of the facet on this side, if there is one.
//
// Unbounded edges: an edge of the flat set that ends on the frame is a ray or a line. Its end on
// the frame is f + R i, where R is larger than every number (docs/design/frame.md). As this point
// stays on the line of the edge for every R, f is a point of the line, and i its direction.
//
// Tested by tests/model/slice_test.cpp.
#include "plumb/model/slice.h"

#include <algorithm>
#include <array>
#include <utility>

#include "plumb/plane/arrangement.h"
#include "plumb/predicates/error.h"
#include "plumb/predicates/point3_signs.h"
#include "plumb/space/planar/facet_triangles.h"

namespace plumb {
namespace {

void require_bounded_set(const Nef3& set) {
  if (set.is_bounded()) return;
  throw Error(ErrorCode::BadArgument, "an unbounded set cannot be projected");
}

/// Returns the x and y of all vertices.
PointTable2 projected_vertices(const SpaceComplex& c) {
  PointTable2 points;
  points.reserve(c.vertex_count());
  for (const SpacePoint p : c.vertex_point) {
    const RationalPoint3 at = exact(c.points(), p);
    points.push_back(at.x, at.y);
  }
  return points;
}

/// Returns Positive if the normal of a plane points upward, Zero if the plane is vertical.
Sign upward(const SpaceComplex& c, FacetId f) {
  return sign_of(c.planes().coefficients(c.facet_plane[f])[2]);
}

/// Makes a set of the plane from a set of space whose cells all lie in one plane that is not
/// vertical.
class Flattening {
 public:
  Flattening(const SpaceComplex& flat, Context& context) : c_(flat), context_(context) {}

  Nef2 set() {
    add_vertices();
    for (std::uint32_t e = 0; e < c_.edge_count(); ++e) {
      if (c_.edge_mark[EdgeId(e)] != kBeyond) add_edge(EdgeId(e));
    }
    Arrangement arrangement = arrange(PlanePoints{points_, {}}, curves_, vertices_, context_);
    PlaneComplex plane = std::move(arrangement.complex);
    for (std::size_t v = 0; v < plane.vertex_count(); ++v) {
      plane.marks.vertex[VertexId(v)] = c_.vertex_mark[VertexId(vertices_[v])];
    }
    for (std::size_t e = 0; e < plane.edge_count(); ++e) {
      // The set of origins contains one curve.
      const Edge& edge = edges_[arrangement.origins[e].value()];
      plane.marks.edge[EdgeId(e)] = c_.edge_mark[edge.of];
      mark_faces(plane, EdgeId(e), edge);
    }
    if (curves_.empty()) mark_only_face(plane);
    return Nef2::from_complex(std::move(plane), context_);
  }

 private:
  /// An edge of the flat set.
  struct Edge {
    EdgeId of;
    bool is_ascending;  ///< Whether its first half-edge runs to lexicographically greater points.
  };

  bool is_far(VertexId v) const { return c_.points().depends_on_frame(c_.vertex_point[v]); }

  /// Adds a point for each vertex. The point of a vertex on the frame is its finite part. Lists the
  /// other vertices in lexicographic order, in which the arrangement numbers its vertices.
  void add_vertices() {
    for (std::uint32_t v = 0; v < c_.vertex_count(); ++v) {
      const SpacePoint p = c_.vertex_point[VertexId(v)];
      if (is_far(VertexId(v))) {
        const RationalPoint3 finite = exact_parts(c_.points(), p).finite;
        points_.push_back(finite.x, finite.y);
      } else {
        const RationalPoint3 at = exact(c_.points(), p);
        points_.push_back(at.x, at.y);
        vertices_.push_back(v);
      }
    }
    std::sort(vertices_.begin(), vertices_.end(), [this](std::uint32_t v, std::uint32_t w) {
      return compare_xy(points_, v, w) == Sign::Negative;
    });
  }

  void add_edge(EdgeId e) {
    const VertexId v = c_.origin[first_half(e)], w = c_.target(first_half(e));
    SweepCurve curve{v.value(), w.value(), v.value(), w.value()};
    if (is_far(v)) {
      curve.from = SweepCurve::kUnbounded;
      curve.a = is_far(w) ? v.value() : w.value();
      curve.b = add_beside(curve.a, v, -1);
    } else if (is_far(w)) {
      curve.b = add_beside(curve.a, w, 1);
    }
    if (is_far(w)) curve.to = SweepCurve::kUnbounded;
    curves_.push_back(curve);
    edges_.push_back({e, compare_xy(points_, curve.a, curve.b) == Sign::Negative});
  }
  /// Adds a point of a line: a given point of the line, moved in the direction of a vertex on the
  /// frame, or in the opposite direction if `factor` is -1.
  std::uint32_t add_beside(std::uint32_t point, VertexId far, int factor) {
    const RationalPoint3 i = exact_parts(c_.points(), c_.vertex_point[far]).infinite;
    const RationalPoint2 at = points_.exact(point);
    points_.push_back(at.x + factor * i.x, at.y + factor * i.y);
    return static_cast<std::uint32_t>(points_.size() - 1);
  }

  /// Marks the faces beside an edge of the plane by the facets beside the edge of space.
  void mark_faces(PlaneComplex& plane, EdgeId e, const Edge& edge) {
    const UseId first = c_.edge_use[edge.of];
    if (!first.is_valid()) return;
    UseId u = first;
    do {
      const FacetId f = c_.use_facet[u];
      if (c_.facet_mark[f] == 1) {
        const HalfedgeId h = first_half(e);  // The first half-edge is ascending.
        const bool is_along = SpaceComplex::is_reverse(c_.use_halfedge[u]) != edge.is_ascending;
        // Seen from the positive side of its plane, the facet is on the left of its use.
        const bool is_left = is_along == (upward(c_, f) == Sign::Positive);
        plane.marks.face[plane.dcel.face(is_left ? h : twin(h))] = 1;
      }
      u = c_.use_radial[u];
    } while (u != first);
  }
  /// Marks the face of a plane without edges: its facet reaches the frame on all sides.
  void mark_only_face(PlaneComplex& plane) {
    for (const Mark mark : c_.facet_mark) {
      if (mark == 1) plane.marks.face[FaceId(0)] = 1;
    }
  }

  const SpaceComplex& c_;
  Context& context_;
  PointTable2 points_;
  std::vector<SweepCurve> curves_;
  std::vector<Edge> edges_;              ///< The edge of each curve.
  std::vector<std::uint32_t> vertices_;  ///< Those that are not on the frame.
};

/// The projections of the cells of a set.
class Projection {
 public:
  explicit Projection(const SpaceComplex& complex) : c_(complex) {}

  Nef2 covered(Context& context) {
    for (std::uint32_t f = 0; f < c_.facet_count(); ++f) add_facet(FacetId(f));
    for (std::uint32_t e = 0; e < c_.edge_count(); ++e) {
      if (!c_.edge_use[EdgeId(e)].is_valid()) add_line(EdgeId(e));
    }
    for (std::uint32_t v = 0; v < c_.vertex_count(); ++v) {
      if (c_.star_of(VertexId(v)).empty()) add_line_end(VertexId(v));
    }
    const PointTable2 points = projected_vertices(c_);
    const std::array<Nef2, 2> parts{
        Nef2::polygons(points, rings_, ring_begin_, WindingRule::Positive, Boundary::Closed,
                       context),
        Nef2::polylines(points, lines_, line_begin_, context)};
    return union_of(parts, context);
  }

 private:
  /// Adds the borders of a facet, directed such that the facet is on their left. If the set is a
  /// solid, the facets that look upward cover its shadow, and every vertical facet lies in the
  /// shadow of another facet.
  void add_facet(FacetId f) {
    const auto [above, below] = c_.facet_volume[f];
    const bool is_free = c_.volume_mark[above] == c_.volume_mark[below];
    const Sign up = upward(c_, f);
    if (up == Sign::Zero) {
      if (is_free) add_vertical(f);
      return;
    }
    const bool looks_up = (c_.volume_mark[below] == 1) == (up == Sign::Positive);
    if (!is_free && !looks_up) return;
    for (const UseId cycle : c_.cycles_of(f)) {
      const auto begin = static_cast<std::ptrdiff_t>(rings_.size());
      UseId u = cycle;
      do {
        rings_.push_back(c_.use_origin(u).value());
        u = c_.use_next[u];
      } while (u != cycle);
      if (up == Sign::Negative) std::reverse(rings_.begin() + begin, rings_.end());
      ring_begin_.push_back(static_cast<std::uint32_t>(rings_.size()));
    }
  }
  void add_vertical(FacetId f) {
    for (const UseId cycle : c_.cycles_of(f)) {
      UseId u = cycle;
      do {
        add_line(SpaceComplex::edge_of(c_.use_halfedge[u]));
        u = c_.use_next[u];
      } while (u != cycle);
    }
  }
  void add_line(EdgeId e) {
    lines_.push_back(c_.origin[first_half(e)].value());
    add_line_end(c_.target(first_half(e)));
  }
  void add_line_end(VertexId v) {
    lines_.push_back(v.value());
    line_begin_.push_back(static_cast<std::uint32_t>(lines_.size()));
  }

  const SpaceComplex& c_;
  std::vector<std::uint32_t> rings_;
  std::vector<std::uint32_t> ring_begin_ = {0};
  std::vector<std::uint32_t> lines_;
  std::vector<std::uint32_t> line_begin_ = {0};
};

}  // namespace

Nef2 slice(const Nef3& set, const Rational& height, Context& context) {
  const Plane3 plane{0, 0, 1, -height};
  const Nef3 flat = boolean_op(set, plane, Section::PlaneOnly, kIntersection, context);
  return Flattening(flat.complex(), context).set();
}

std::vector<Nef2> slices(const Nef3& set, std::span<const Rational> heights, Context& context) {
  std::vector<Nef2> result;
  for (const Rational& height : heights) result.push_back(slice(set, height, context));
  return result;
}

Nef2 shadow(const Nef3& set, Context& context) {
  require_bounded_set(set);
  const Nef3 closed = set.closure(context);
  return Projection(closed.complex()).covered(context);
}

}  // namespace plumb
