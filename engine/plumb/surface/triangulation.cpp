// Triangulations of divided surfaces. A face that nothing touches is one triangle of the result.
// Every piece of a touched face is triangulated on its own, between its nodes, and made Delaunay by
// flips; then triangles are joined across sides, arcs and mesh edges. So neighbouring triangles
// always share whole sides.
//
// PiecePoints has the predicates of the triangulator in the plane of the face's parameters.
// Orientation and order are affine, so they are those of (u, v). The in-circle test is not; it
// measures by the quadratic form E u^2 + 2 F u v + G v^2 of the face, whose coefficients are scalar
// products of two sides. Both have a filter stage with a proved bound (above the functions) and a
// stage in rationals. Tested by tests/surface/triangulation_test.cpp.

#include "plumb/surface/triangulation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "plumb/predicates/error.h"
#include "plumb/predicates/input/rung_counters.h"
#include "plumb/predicates/rational_predicates.h"
#include "plumb/predicates/rounding.h"
#include "plumb/predicates/segment2.h"
#include "plumb/space/planar/triangulate.h"
#include "plumb/surface/cells/surface_arrangement.h"
#include "plumb/surface/cells/surface_cells.h"
#include "plumb/surface/surface.h"

namespace plumb {

/// The nodes around a piece of a face as points of the plane, with the distances of the face.
/// Orientation and order are those of (u, v). Distances are |u p + v q|, p and q the sides of the
/// face from its first corner: (E, F, G) = (p p, p q, q q), taken exactly from the doubles of the
/// mesh. Stages: rounded points with a radius; rationals.
class PiecePoints final : public PlanarPoints {
 public:
  explicit PiecePoints(const SurfaceDivision& division);

  /// Removes all points, and begins a new face.
  void reset(FaceId f);
  /// Appends a node that lies in the face.
  void push_back(NodeId n);

  std::uint32_t size() const override { return static_cast<std::uint32_t>(at_.size()); }
  Sign orient(std::uint32_t i, std::uint32_t j, std::uint32_t k) const override;
  Sign compare(std::uint32_t i, std::uint32_t j) const override;
  Sign incircle(std::uint32_t i, std::uint32_t j, std::uint32_t k, std::uint32_t l) const override;

 private:
  struct Entry {
    Point2 mid;
    double radius;  ///< Bound on the error of both coordinates.
    NodeId node;
  };
  const RationalPoint2& exact_point(std::uint32_t i) const;
  const std::array<Rational, 3>& exact_form() const;

  const SurfaceMesh& mesh_;
  const SurfaceArrangement& a_;
  const SurfacePointTable& points_;
  FaceId face_;
  std::array<double, 3> form_{};  // The rounded values of E, F and G.
  double form_scale_ = 0;         // The value of E + 2 |F| + G.
  std::vector<Entry> at_;
  mutable std::optional<std::array<Rational, 3>> exact_form_;
  mutable std::vector<std::optional<RationalPoint2>> exact_;
};

PiecePoints::PiecePoints(const SurfaceDivision& division)
    : mesh_(division.mesh()),
      a_(division.arrangement()),
      points_(division.scene().polygons.points) {}

void PiecePoints::reset(FaceId f) {
  face_ = f;
  at_.clear();
  exact_.clear();
  exact_form_.reset();
  const Point3 &o = mesh_.point(mesh_.corner(f, 0)), &a = mesh_.point(mesh_.corner(f, 1)),
               &b = mesh_.point(mesh_.corner(f, 2));
  const Point3 p{a.x - o.x, a.y - o.y, a.z - o.z}, q{b.x - o.x, b.y - o.y, b.z - o.z};
  form_ = {p.x * p.x + p.y * p.y + p.z * p.z, p.x * q.x + p.y * q.y + p.z * q.z,
           q.x * q.x + q.y * q.y + q.z * q.z};
  form_scale_ = form_[0] + 2 * std::fabs(form_[1]) + form_[2];
}

/// Appends a node. The rounded weights of an input point are in [0, 1], and their error is at most
/// 2^-53. The radius 2^-52 also covers the rounding of 1 - t.
void PiecePoints::push_back(NodeId n) {
  if (a_.is_crossing(n)) {
    const SurfaceCrossing& c = a_.crossing(n);
    at_.push_back({c.approx, c.radius, n});
    return;
  }
  if (!a_.is_input(n)) {
    const std::uint32_t v = a_.corner(n).value();
    const SurfaceTriangle& t = mesh_.corners(face_);
    at_.push_back({{t[1] == v ? 1.0 : 0.0, t[2] == v ? 1.0 : 0.0}, 0, n});
    return;
  }
  at_.push_back({points_.approx_in(a_.input(n), face_), 0x1p-52, n});
}

const RationalPoint2& PiecePoints::exact_point(std::uint32_t i) const {
  if (exact_.size() < at_.size()) exact_.resize(at_.size());
  if (!exact_[i]) exact_[i] = exact_node(a_, points_, at_[i].node, face_);
  return *exact_[i];
}

const std::array<Rational, 3>& PiecePoints::exact_form() const {
  if (!exact_form_) {
    const auto corner = [&](std::size_t i) {
      const Point3& p = mesh_.point(mesh_.corner(face_, i));
      return RationalPoint3{exact_rational(p.x), exact_rational(p.y), exact_rational(p.z)};
    };
    const RationalPoint3 o = corner(0), a = corner(1), b = corner(2);
    const RationalPoint3 p{a.x - o.x, a.y - o.y, a.z - o.z}, q{b.x - o.x, b.y - o.y, b.z - o.z};
    exact_form_ = {p.x * p.x + p.y * p.y + p.z * p.z, p.x * q.x + p.y * q.y + p.z * q.z,
                   q.x * q.x + q.y * q.y + q.z * q.z};
  }
  return *exact_form_;
}

namespace {

/// Returns the determinant of the rows (x, y, E x x + 2 F x y + G y y) for a, b and c.
template <class Number, class Point>
Number circle_determinant(const std::array<Number, 3>& form, const Point& a, const Point& b,
                          const Point& c) {
  const auto lift = [&](const Point& p) {
    return Number(form[0] * p.x * p.x + 2 * form[1] * p.x * p.y + form[2] * p.y * p.y);
  };
  return Number((a.x * b.y - a.y * b.x) * lift(c) + (b.x * c.y - b.y * c.x) * lift(a) +
                (c.x * a.y - c.y * a.x) * lift(b));
}

}  // namespace

Sign PiecePoints::orient(std::uint32_t i, std::uint32_t j, std::uint32_t k) const {
  const Entry &a = at_[i], &b = at_[j], &c = at_[k];
  // The rounding of a difference is at most 2^-50 for coordinates in [0, 1].
  const double radii = 2 * std::max({a.radius, b.radius, c.radius});
  const FilteredSign s = turn_of_nearby(a.mid, b.mid, c.mid, radii + 0x1p-50);
  if (is_decided(s)) return decide(Predicate::Orient2d, Rung::Filter, s);
  return orient2d(exact_point(i), exact_point(j), exact_point(k));
}

Sign PiecePoints::compare(std::uint32_t i, std::uint32_t j) const {
  const Entry &a = at_[i], &b = at_[j];
  const double x = a.mid.x - b.mid.x;
  if (std::fabs(x) > 2 * (a.radius + b.radius)) return sign_of(x);
  return compare_xy(exact_point(i), exact_point(j));
}

/// The in-circle test. Let M be the largest difference, e <= M / 8 the errors, and K = E + 2 |F| +
/// G. E, F and G are off by 2^-50 K (differences of coordinates are rounded once). So a lift, at
/// most K M^2, is off by 3 e K M + 2^-47 K M^2; a cross product, at most 2 M^2, is off by 5 e M +
/// 2^-50 M^2; and each of the three terms by 11 e K M^3 + 2^-45 K M^4. The bound is twice that and
/// more. No relevant number underflows for K >= 2^-500 and M >= 2^-100.
Sign PiecePoints::incircle(std::uint32_t i, std::uint32_t j, std::uint32_t k,
                           std::uint32_t l) const {
  const Entry &a = at_[i], &b = at_[j], &c = at_[k], &d = at_[l];
  const double e = 2 * std::max({a.radius, b.radius, c.radius, d.radius}) + 0x1p-52;
  const auto from_d = [](const Point2& p, const Point2& o) { return Point2{p.x - o.x, p.y - o.y}; };
  const Point2 p = from_d(a.mid, d.mid), q = from_d(b.mid, d.mid), r = from_d(c.mid, d.mid);
  const double m = std::max({std::fabs(p.x), std::fabs(p.y), std::fabs(q.x), std::fabs(q.y),
                             std::fabs(r.x), std::fabs(r.y)});
  const double error = 72 * (e + 0x1p-44 * m) * form_scale_ * m * m * m;
  const bool is_in_range = form_scale_ >= 0x1p-500 && form_scale_ <= 0x1p500 && m >= 0x1p-100;
  const double value = circle_determinant(form_, p, q, r);
  if (is_in_range && e <= m / 8 && std::fabs(value) > error) {
    return decide(Predicate::Incircle, Rung::Filter, filtered(sign_of(value)));
  }
  count_rung(Predicate::Incircle, Rung::Big);
  const RationalPoint2& o = exact_point(l);
  const auto exactly = [&](std::uint32_t n) {
    return RationalPoint2{exact_point(n).x - o.x, exact_point(n).y - o.y};
  };
  return sign_of(circle_determinant(exact_form(), exactly(i), exactly(j), exactly(k)));
}

namespace {

// The result takes 44 bytes, and the sides of the mesh take 12.
constexpr std::uint64_t kBytesPerTriangle = 56;
constexpr std::uint64_t kBytesPerPoint = 32;

class SurfaceTriangulator {
 public:
  explicit SurfaceTriangulator(const SurfaceDivision& division)
      : d_(division),
        mesh_(division.mesh()),
        a_(division.arrangement()),
        cells_(division.cells()),
        points_(division) {}

  SurfaceTriangulation run(Context& context) {
    MemoryCharge memory(context);
    const std::size_t triangles = mesh_.face_count() + a_.halfedge_count();
    memory.add(
        kBytesPerTriangle * triangles + kBytesPerPoint * (mesh_.vertex_count() + a_.node_count()),
        "triangles of a surface");
    reserve(triangles);
    add_points();
    side_of_halfedge_.assign(a_.halfedge_count(), kNone);
    side_of_mesh_.assign(3 * mesh_.face_count(), kNone);
    for (std::uint32_t f = 0; f < mesh_.face_count(); ++f) {
      if (f % 4096 == 0) context.checkpoint("triangulate", f, mesh_.face_count());
      const std::uint32_t slot = a_.slot_of_face[f];
      if (slot == kNone) {
        add_whole(FaceId(f));
        continue;
      }
      for (std::uint32_t p = a_.piece_begin[slot].value(); p < a_.piece_begin[slot + 1].value();
           ++p) {
        add_piece(PieceId(p), FaceId(f));
      }
    }
    sew();
    return std::move(out_);
  }

 private:
  /// Reserves memory. Whole faces are triangles, and most pieces have fewer triangles than sides.
  void reserve(std::size_t triangles) {
    const std::size_t points = mesh_.vertex_count() + a_.node_count();
    out_.points.reserve(points);
    out_.node.reserve(points);
    out_.triangles.reserve(triangles);
    out_.face.reserve(triangles);
    out_.cell.reserve(triangles);
    out_.across.reserve(3 * triangles);
    out_.arc.reserve(3 * triangles);
  }

  /// Adds the vertices of the mesh, then the other nodes in which half-edges start.
  void add_points() {
    out_.node.assign(mesh_.vertex_count(), NodeId{});
    for (std::uint32_t v = 0; v < mesh_.vertex_count(); ++v) {
      out_.points.push_back(mesh_.point(VertexId(v)));
    }
    point_of_node_.assign(a_.node_count(), kNone);
    for (const NodeId n : a_.origin) {
      std::uint32_t& point = point_of_node_[n];
      if (point != kNone) continue;
      const VertexId v = vertex_of(n);
      point = v.is_valid() ? v.value() : static_cast<std::uint32_t>(out_.points.size());
      if (v.is_valid()) {
        out_.node[point] = n;
        continue;
      }
      out_.points.push_back(node_position(d_, n));
      out_.node.push_back(n);
    }
  }
  VertexId vertex_of(NodeId n) const {
    const SurfacePointTable& points = d_.scene().polygons.points;
    if (a_.is_crossing(n)) return {};
    if (!a_.is_input(n)) return a_.corner(n);
    const SurfacePointId p = a_.input(n);
    return points.place(p) == SurfacePlace::Vertex ? points.vertex(p) : VertexId{};
  }

  std::uint32_t add_triangle(const SurfaceTriangle& t, FaceId f, CellId c) {
    const auto first = static_cast<std::uint32_t>(3 * out_.triangles.size());
    out_.triangles.push_back(t);
    out_.face.push_back(f);
    out_.cell.push_back(c);
    out_.across.insert(out_.across.end(), 3, kNone);
    out_.arc.insert(out_.arc.end(), 3, ArcId{});
    return first;
  }
  void add_whole(FaceId f) {
    const std::uint32_t first = add_triangle(mesh_.corners(f), f, cells_.of_face[f]);
    for (std::uint32_t i = 0; i < 3; ++i) side_of_mesh_[3 * f.value() + i] = first + i;
  }

  // ---------------------------------------------------------------- pieces

  /// Triangulates a piece between its nodes. A triangle without inner nodes is taken as it is.
  void add_piece(PieceId p, FaceId f) {
    gather(p);
    local_.clear();
    if (edges_.size() == 3 && nodes_.size() == 3) {
      local_.push_back({edges_[0][0], edges_[1][0], edges_[2][0]});
    } else {
      points_.reset(f);
      for (const NodeId n : nodes_) points_.push_back(n);
      PLUMB_CHECK(triangulate(points_, edges_, local_));
      make_delaunay(points_, edges_, local_);
    }
    sides_.clear();
    for (const IndexTriangle& t : local_) {
      SurfaceTriangle named;
      for (std::size_t i = 0; i < 3; ++i) named[i] = point_of_node_[nodes_[t[i]].value()];
      const std::uint32_t first = add_triangle(named, f, cells_.of_piece[p]);
      for (std::uint32_t i = 0; i < 3; ++i) {
        sides_.push_back({{t[i], t[(i + 1) % 3]}, first + i});
      }
    }
    std::sort(sides_.begin(), sides_.end());
    join_sides();
  }

  /// Collects the half-edges around a piece, in the order of its loops, as edges between its nodes
  /// in ascending order.
  void gather(PieceId p) {
    halfedges_.clear();
    nodes_.clear();
    for (std::uint32_t l = a_.loop_begin[p]; l < a_.loop_begin[p.value() + 1]; ++l) {
      HalfedgeId h = a_.loop[l];
      do {
        halfedges_.push_back(h);
        nodes_.push_back(a_.origin[h]);
        h = a_.next[h];
      } while (h != a_.loop[l]);
    }
    std::sort(nodes_.begin(), nodes_.end());
    nodes_.erase(std::unique(nodes_.begin(), nodes_.end()), nodes_.end());
    const auto local = [&](NodeId n) {
      return static_cast<std::uint32_t>(std::lower_bound(nodes_.begin(), nodes_.end(), n) -
                                        nodes_.begin());
    };
    edges_.clear();
    for (const HalfedgeId h : halfedges_) {
      edges_.push_back({local(a_.origin[h]), local(a_.target(h))});
    }
  }

  /// A side of a triangle, between two local points.
  struct Side {
    IndexEdge ends;
    std::uint32_t side;
    friend auto operator<=>(const Side&, const Side&) = default;
  };
  std::uint32_t side_between(std::uint32_t from, std::uint32_t to) const {
    const IndexEdge ends = {from, to};
    const auto at = std::lower_bound(sides_.begin(), sides_.end(), Side{ends, 0});
    return at != sides_.end() && at->ends == ends ? at->side : kNone;
  }
  /// Joins triangles of the piece across common sides. Sides along half-edges of the piece are no
  /// neighbours within the piece, and are joined across arcs later.
  void join_sides() {
    for (const Side& s : sides_) {
      out_.across[s.side] = side_between(s.ends[1], s.ends[0]);
    }
    for (std::size_t i = 0; i < halfedges_.size(); ++i) {
      const std::uint32_t side = side_between(edges_[i][0], edges_[i][1]);
      side_of_halfedge_[halfedges_[i].value()] = side;
      out_.across[side] = kNone;
      out_.arc[side] = a_.arc[halfedges_[i]];
    }
  }

  // ---------------------------------------------------------------- between pieces and faces

  // Joins triangles across arcs and across the edges of faces. A face that is not touched has no
  // node inside its sides, so a touched neighbour has exactly one half-edge there.
  void sew() {
    for (std::uint32_t h = 0; h < a_.halfedge_count(); ++h) {
      const HalfedgeId t = a_.twin[h];
      if (t.is_valid()) out_.across[side_of_halfedge_[h]] = side_of_halfedge_[t];
    }
    for (std::uint32_t h = 0; h < 3 * mesh_.face_count(); ++h) {
      const HalfedgeId t = mesh_.twin(HalfedgeId(h));
      if (side_of_mesh_[h] == kNone || !t.is_valid()) continue;
      std::uint32_t other = side_of_mesh_[t];
      if (other == kNone) {
        const std::uint32_t slot = a_.slot_of_face[SurfaceMesh::face(t)];
        other = side_of_halfedge_[a_.side_begin[4 * slot + SurfaceMesh::side(t)]];
        out_.across[other] = side_of_mesh_[h];
      }
      out_.across[side_of_mesh_[h]] = other;
    }
  }

  const SurfaceDivision& d_;
  const SurfaceMesh& mesh_;
  const SurfaceArrangement& a_;
  const SurfaceCells& cells_;
  PiecePoints points_;
  IdVector<NodeId, std::uint32_t> point_of_node_;
  IdVector<HalfedgeId, std::uint32_t> side_of_halfedge_;
  IdVector<HalfedgeId, std::uint32_t> side_of_mesh_;  // The sides of whole faces.
  // Scratch memory for one piece.
  std::vector<HalfedgeId> halfedges_;
  std::vector<NodeId> nodes_;
  std::vector<IndexEdge> edges_;
  std::vector<IndexTriangle> local_;
  std::vector<Side> sides_;
  SurfaceTriangulation out_;
};

}  // namespace

SurfaceTriangulation triangulate_surface(const SurfaceDivision& division, Context& context) {
  return SurfaceTriangulator(division).run(context);
}

Point3 node_position(const SurfaceDivision& division, NodeId node) {
  const SurfaceArrangement& a = division.arrangement();
  const SurfaceMesh& mesh = division.mesh();
  if (a.is_input(node)) return division.scene().polygons.points.position(a.input(node));
  if (!a.is_crossing(node)) return mesh.point(a.corner(node));
  const SurfaceCrossing& c = a.crossing(node);
  const Point3 &p = mesh.point(mesh.corner(c.face, 0)), &q = mesh.point(mesh.corner(c.face, 1)),
               &r = mesh.point(mesh.corner(c.face, 2));
  const double u = c.approx.x, v = c.approx.y, w = 1 - u - v;
  return {w * p.x + u * q.x + v * r.x, w * p.y + u * q.y + v * r.y, w * p.z + u * q.z + v * r.z};
}

}  // namespace plumb
