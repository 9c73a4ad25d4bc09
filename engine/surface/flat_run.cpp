#include "plumb/surface/flat_run.h"

#include <array>

#include "plumb/predicates/input_predicates.h"
#include "plumb/predicates/rounding.h"

namespace plumb {
namespace {

constexpr std::size_t kDoors = 1024;  // a checkpoint

/// A plane of faces, seen along an axis that it is not parallel to.
class FlatView {
 public:
  FlatView(const SurfaceMesh& mesh, FaceId f) : mesh_(mesh), corners_(corners(f)) {
    for (dropped_ = 0; dropped_ < 3 && turn(f) == Sign::Zero;) ++dropped_;
    if (dropped_ < 3) turn_ = turn(f);
  }

  bool is_valid() const { return dropped_ < 3; }
  /// Does a face that shares a side with one of this plane continue it?
  bool has(FaceId f) const {
    for (const Point3& p : corners(f)) {
      if (orient3d(corners_[0], corners_[1], corners_[2], p) != Sign::Zero) return false;
    }
    return turn(f) == turn_;
  }
  RationalPoint2 at(VertexId v) const {
    const Point2 p = seen(mesh_.point(v));
    return {exact_rational(p.x), exact_rational(p.y)};
  }
  RationalPoint2 at(const SurfacePointTable& points, SurfacePointId p, FaceId f) const {
    const RationalPoint2 w = points.exact_in(p, f);
    const RationalPoint2 a = at(mesh_.corner(f, 0)), b = at(mesh_.corner(f, 1)),
                         c = at(mesh_.corner(f, 2));
    return {a.x + w.x * (b.x - a.x) + w.y * (c.x - a.x),
            a.y + w.x * (b.y - a.y) + w.y * (c.y - a.y)};
  }

 private:
  std::array<Point3, 3> corners(FaceId f) const {
    return {mesh_.point(mesh_.corner(f, 0)), mesh_.point(mesh_.corner(f, 1)),
            mesh_.point(mesh_.corner(f, 2))};
  }
  Point2 seen(const Point3& p) const {
    return dropped_ == 0 ? Point2{p.y, p.z} : dropped_ == 1 ? Point2{p.z, p.x} : Point2{p.x, p.y};
  }
  Sign turn(FaceId f) const {
    const std::array<Point3, 3> c = corners(f);
    return orient2d(seen(c[0]), seen(c[1]), seen(c[2]));
  }

  const SurfaceMesh& mesh_;
  std::array<Point3, 3> corners_;
  int dropped_ = 0;  // coordinate; 3: the face has no area
  Sign turn_ = Sign::Zero;
};

/// Twice the area of a, b, p.
Rational area(const RationalPoint2& a, const RationalPoint2& along, const RationalPoint2& p) {
  return along.x * (p.y - a.y) - along.y * (p.x - a.x);
}

}  // namespace

std::optional<std::vector<Rational>> flat_run(const SurfacePointTable& points,
                                              std::span<const HalfedgeId> doors,
                                              const FlatRunEnd& from, const FlatRunEnd& to,
                                              Context& context) {
  const SurfaceMesh& mesh = points.mesh();
  if (doors.empty()) return {};
  const FaceId first = SurfaceMesh::face(doors.front());
  const FaceId last = SurfaceMesh::face(mesh.twin(doors.back()));
  const FlatView view(mesh, first);
  if (!view.is_valid()) return {};
  for (const HalfedgeId door : doors) {
    if (!view.has(SurfaceMesh::face(mesh.twin(door)))) return {};
  }
  const auto end_at = [&](const FlatRunEnd& end, FaceId f) {
    return end.vertex.is_valid() ? view.at(end.vertex) : view.at(points, end.point, f);
  };
  const RationalPoint2 a = end_at(from, first), b = end_at(to, last);
  const RationalPoint2 along{b.x - a.x, b.y - a.y};
  std::vector<Rational> parts;
  parts.reserve(doors.size());
  for (const HalfedgeId door : doors) {
    if (parts.size() % kDoors == 0) context.checkpoint("trace", parts.size(), doors.size());
    const Rational origin = area(a, along, view.at(mesh.origin(door)));
    const Rational target = area(a, along, view.at(mesh.target(door)));
    if (origin * target >= 0) return {};
    parts.push_back(origin / (origin - target));
  }
  return parts;
}

}  // namespace plumb
