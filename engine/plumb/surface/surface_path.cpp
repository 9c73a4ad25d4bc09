// Points on a surface and polygons through them.
//
// A point is a vertex, a parameter t on an edge, stored once for both faces, or weights (u, v)
// inside a face; it is normalised when it is added, so a point has one place and equal points are
// found by comparing numbers. Parameters are doubles where doubles hold them, else rationals
// (PointTable2). Within a face, points are given in the coordinates of the triangle (0, 0), (1, 0),
// (0, 1): exact_in() exactly, append_local() as doubles if nothing is lost. Theory:
// docs/design/surface.md, section A face is a plane.
// Tested by tests/surface/surface_arrangement_test.cpp and tests/surface/surface_test.cpp.
#include "plumb/surface/surface_path.h"

#include <cmath>
#include <string>

#include "plumb/predicates/error.h"
#include "plumb/predicates/input_predicates.h"
#include "plumb/predicates/rounding.h"

namespace plumb {
namespace {

[[noreturn]] void refuse(const std::string& what) { throw Error(ErrorCode::BadArgument, what); }

/// Sets r to 1 - t and returns whether that is exact. If the rounded difference r is at least 1/2,
/// 1 - r is exact; if it is less, t is above 1/2 and r itself is exact.
bool subtract_from_one(double t, double& r) {
  r = 1 - t;
  return 1 - r == t;
}

/// Returns (u, v) of a point on a side, given the weight of the corner that the side runs to.
RationalPoint2 on_side(std::size_t side, const Rational& weight) {
  if (side == 0) return {weight, 0};
  if (side == 1) return {1 - weight, weight};
  return {0, 1 - weight};
}

}  // namespace

SurfacePointId SurfacePointTable::add(SurfacePlace place, std::uint32_t index) {
  item_.push_back((static_cast<std::uint32_t>(place) << 30U) | index);
  return SurfacePointId(item_.size() - 1);
}

SurfacePointId SurfacePointTable::add_vertex(VertexId v) {
  if (v.value() >= mesh_->vertex_count()) {
    throw Error(ErrorCode::BadIndex, "no vertex " + std::to_string(v.value()));
  }
  parameters_.push_back(Point2{0, 0});
  return add(SurfacePlace::Vertex, v.value());
}

SurfacePointId SurfacePointTable::add_on_edge(EdgeId e, double t) {
  if (e.value() >= mesh_->edge_count()) {
    throw Error(ErrorCode::BadIndex, "no edge " + std::to_string(e.value()));
  }
  if (!(t >= 0 && t <= 1)) refuse("a point of an edge with t outside [0, 1]");
  if (t == 0) return add_vertex(mesh_->lower(e));
  if (t == 1) return add_vertex(mesh_->upper(e));
  parameters_.push_back(Point2{t, 0});
  return add(SurfacePlace::Edge, e.value());
}

SurfacePointId SurfacePointTable::add_on_edge(EdgeId e, const Rational& t) {
  if (e.value() >= mesh_->edge_count()) {
    throw Error(ErrorCode::BadIndex, "no edge " + std::to_string(e.value()));
  }
  if (t < 0 || t > 1) refuse("a point of an edge with t outside [0, 1]");
  if (t == 0) return add_vertex(mesh_->lower(e));
  if (t == 1) return add_vertex(mesh_->upper(e));
  parameters_.push_back(t, Rational(0));
  return add(SurfacePlace::Edge, e.value());
}

/// Adds a point on a side of a face. `weight` is the weight of the vertex to which the side leads.
SurfacePointId SurfacePointTable::add_on_side(FaceId f, std::size_t side, const Rational& weight) {
  const HalfedgeId h = SurfaceMesh::halfedge(f, side);
  return add_on_edge(mesh_->edge(h), mesh_->is_upward(h) ? weight : Rational(1 - weight));
}

/// Doubles are used only for points that are strictly inside of the face by an exact sign. Points
/// on sides are normalised with rationals.
SurfacePointId SurfacePointTable::add_in_face(FaceId f, double u, double v) {
  if (f.value() >= mesh_->face_count()) {
    throw Error(ErrorCode::BadIndex, "no face " + std::to_string(f.value()));
  }
  if (!std::isfinite(u) || !std::isfinite(v)) refuse("weights that are not finite");
  const Sign inside = orient2d(Point2{1, 0}, Point2{0, 1}, Point2{u, v});
  if (u <= 0 || v <= 0 || inside != Sign::Positive) {
    return add_in_face(f, exact_rational(u), exact_rational(v));
  }
  parameters_.push_back(Point2{u, v});
  return add(SurfacePlace::Face, f.value());
}

SurfacePointId SurfacePointTable::add_in_face(FaceId f, const Rational& u, const Rational& v) {
  if (f.value() >= mesh_->face_count()) {
    throw Error(ErrorCode::BadIndex, "no face " + std::to_string(f.value()));
  }
  const Rational sum = u + v;
  if (u < 0 || v < 0 || sum > 1) refuse("a point outside its face");
  if (v == 0) return add_on_side(f, 0, u);
  if (u == 0) return add_on_side(f, 2, 1 - v);
  if (sum == 1) return add_on_side(f, 1, v);
  parameters_.push_back(u, v);
  return add(SurfacePlace::Face, f.value());
}

bool SurfacePointTable::is_same(SurfacePointId p, SurfacePointId q) const {
  return item_[p] == item_[q] && compare_xy(parameters_, p.value(), q.value()) == Sign::Zero;
}

HalfedgeId SurfacePointTable::side_in(SurfacePointId p, FaceId f) const {
  for (std::size_t i = 0; i < 3; ++i) {
    const HalfedgeId h = SurfaceMesh::halfedge(f, i);
    if (mesh_->edge(h) == edge(p)) return h;
  }
  return {};
}

bool SurfacePointTable::is_in(SurfacePointId p, FaceId f) const {
  switch (place(p)) {
    case SurfacePlace::Vertex: {
      const SurfaceTriangle& t = mesh_->corners(f);
      return t[0] == index(p) || t[1] == index(p) || t[2] == index(p);
    }
    case SurfacePlace::Edge:
      return side_in(p, f).is_valid();
    case SurfacePlace::Face:
      return face(p) == f;
  }
  return false;
}

/// A point of an edge stays a pair of doubles if both t and 1 - t are doubles, because then its
/// coordinates in either face are exact.
void SurfacePointTable::append_local(SurfacePointId p, FaceId f, PointTable2& to) const {
  if (place(p) == SurfacePlace::Edge && parameters_.is_double(p.value())) {
    const HalfedgeId h = side_in(p, f);
    const double t = approx(p).x;
    double other = 0;
    if (subtract_from_one(t, other)) {
      const double weight = mesh_->is_upward(h) ? t : other;
      const double rest = mesh_->is_upward(h) ? other : t;
      constexpr std::size_t kFirst = 0, kSecond = 1;
      const std::size_t side = SurfaceMesh::side(h);
      to.push_back(side == kFirst    ? Point2{weight, 0}
                   : side == kSecond ? Point2{rest, weight}
                                     : Point2{0, rest});
      return;
    }
  }
  if (place(p) == SurfacePlace::Face && parameters_.is_double(p.value())) {
    to.push_back(approx(p));
    return;
  }
  if (place(p) == SurfacePlace::Vertex) {
    to.push_back(approx_in(p, f));
    return;
  }
  const RationalPoint2 at = exact_in(p, f);
  to.push_back(at.x, at.y);
}

Point2 SurfacePointTable::approx_in(SurfacePointId p, FaceId f) const {
  if (place(p) == SurfacePlace::Face) return approx(p);
  if (place(p) == SurfacePlace::Vertex) {
    const SurfaceTriangle& t = mesh_->corners(f);
    return {t[1] == index(p) ? 1.0 : 0.0, t[2] == index(p) ? 1.0 : 0.0};
  }
  const HalfedgeId h = side_in(p, f);
  const double t = approx(p).x, weight = mesh_->is_upward(h) ? t : 1 - t;
  const std::size_t side = SurfaceMesh::side(h);
  if (side == 0) return {weight, 0};
  return {side == 1 ? 1 - weight : 0, side == 1 ? weight : 1 - weight};
}

RationalPoint2 SurfacePointTable::exact_in(SurfacePointId p, FaceId f) const {
  if (place(p) == SurfacePlace::Face) return exact(p);
  if (place(p) == SurfacePlace::Vertex) {
    const SurfaceTriangle& t = mesh_->corners(f);
    return {t[1] == index(p) ? 1 : 0, t[2] == index(p) ? 1 : 0};
  }
  const HalfedgeId h = side_in(p, f);
  const Rational t = exact(p).x;
  return on_side(SurfaceMesh::side(h), mesh_->is_upward(h) ? t : Rational(1 - t));
}

Point3 SurfacePointTable::position(SurfacePointId p) const {
  const auto mix = [](const Point3& a, double s, const Point3& b, double t, const Point3& c,
                      double w) {
    return Point3{s * a.x + t * b.x + w * c.x, s * a.y + t * b.y + w * c.y,
                  s * a.z + t * b.z + w * c.z};
  };
  const Point2 at = approx(p);
  switch (place(p)) {
    case SurfacePlace::Vertex:
      return mesh_->point(vertex(p));
    case SurfacePlace::Edge: {
      const Point3& a = mesh_->point(mesh_->lower(edge(p)));
      const Point3& b = mesh_->point(mesh_->upper(edge(p)));
      return mix(a, 1 - at.x, b, at.x, b, 0);
    }
    case SurfacePlace::Face:
      break;
  }
  const FaceId f = face(p);
  return mix(mesh_->point(mesh_->corner(f, 0)), 1 - at.x - at.y, mesh_->point(mesh_->corner(f, 1)),
             at.x, mesh_->point(mesh_->corner(f, 2)), at.y);
}

void SurfacePolygons::add_segment(SurfacePointId from, FaceId in, SegmentStart start) {
  point.push_back(from);
  face.push_back(in);
  is_control.push_back(start == SegmentStart::ControlPoint ? 1 : 0);
}

void SurfacePolygons::add_leg(const SurfacePath& leg) {
  for (std::size_t i = 0; i < leg.faces.size(); ++i) {
    add_segment(leg.points[i], leg.faces[i],
                i == 0 ? SegmentStart::ControlPoint : SegmentStart::PathPoint);
  }
}

void SurfacePolygons::close() { begin.push_back(static_cast<std::uint32_t>(point.size())); }

void require_valid(const SurfacePolygons& polygons) {
  const SurfacePointTable& points = polygons.points;
  for (std::size_t p = 0; p < polygons.size(); ++p) {
    for (std::uint32_t i = polygons.begin[p]; i < polygons.begin[p + 1]; ++i) {
      const FaceId f = polygons.face[i];
      const auto is_good = [&](SurfacePointId q) {
        return q.value() < points.size() && points.is_in(q, f);
      };
      if (f.value() < points.mesh().face_count() && is_good(polygons.point[i]) &&
          is_good(polygons.point[polygons.next(p, i)])) {
        continue;
      }
      throw Error(ErrorCode::BadArgument, "polygon " + std::to_string(p) + ", segment " +
                                              std::to_string(i - polygons.begin[p]) +
                                              ": an end is not in its face");
    }
  }
}

}  // namespace plumb
