// Strips of triangles of a mesh. Such strips are used to find paths by computations in doubles
// (trace.h, exponential_map.h). A strip is a sequence of faces in which each face shares a side
// with the next face; this side is a door of the strip. The first part of this header lays out the
// faces of a strip in the plane, each face beside the face before it. The second part finds strips
// between two points.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "plumb/base/context.h"
#include "plumb/base/ids.h"
#include "plumb/predicates/point.h"
#include "plumb/surface/surface_mesh.h"
#include "plumb/surface/surface_path.h"

#pragma GCC visibility push(default)
namespace plumb {

/// The positions of vertices, multiplied by 2^-exponent so that no product of two coordinates
/// overflows.
struct ScaledPositions {
  std::vector<Point3> at;
  int exponent = 0;
};
/// Returns the positions of the vertices, scaled so that the absolute values of coordinates are at
/// most 1.
ScaledPositions scaled_positions(const SurfaceMesh& mesh);

/// The corners of a face that is laid out in the plane. They are in the corner order of the mesh,
/// which is counter-clockwise in the plane.
using FaceCorners = std::array<Point2, 3>;

/// Lays a face out in the plane. Corner `first` is at the origin, and the next corner is on the
/// positive x axis.
FaceCorners laid_out(const SurfaceMesh& mesh, std::span<const Point3> positions, FaceId f,
                     std::size_t first);
/// Lays out a face beside a face that is laid out already. `corners` are the corners of the face
/// that is laid out already, and `door` is a half-edge of this face. The result is the layout of
/// the face on the other side of the door. Requires that there is a face on the other side.
FaceCorners laid_out_across(const SurfaceMesh& mesh, std::span<const Point3> positions,
                            const FaceCorners& corners, HalfedgeId door);

/// Returns the angle of the face of h at the origin of h. The angle is between 0 and pi.
double corner_angle(const SurfaceMesh& mesh, std::span<const Point3> positions, HalfedgeId h);

/// Returns the weights of a point with respect to the three corners of a face. The point must lie
/// in the face. The weights are computed from the approximate parameters of the point.
std::array<double, 3> weights_in(const SurfacePointTable& table, SurfacePointId p, FaceId f);

/// Operations on vectors of doubles, for layouts in the plane.
namespace layout {

inline Point2 operator-(Point2 a, Point2 b) { return {a.x - b.x, a.y - b.y}; }
inline double cross(Point2 a, Point2 b) { return a.x * b.y - a.y * b.x; }
inline double dot(Point2 a, Point2 b) { return a.x * b.x + a.y * b.y; }
inline double length(Point2 a) { return std::hypot(a.x, a.y); }

inline Point2 combined(const FaceCorners& p, const std::array<double, 3>& w) {
  return {w[0] * p[0].x + w[1] * p[1].x + w[2] * p[2].x,
          w[0] * p[0].y + w[1] * p[1].y + w[2] * p[2].y};
}

}  // namespace layout

// Strips of faces between two points of a mesh, for tracing (trace.h). A strip is found by a search
// in the dual graph of the mesh. A strip passes a vertex on one side. If the strip becomes shorter
// on the other side of the vertex, it is changed to that side. After that, detours are removed. All
// lengths are computed in doubles. A rounding error can change which strip is chosen, but the
// result is always a valid strip.

/// A sequence of faces in which each face shares a side with the next one. `doors` lists the shared
/// sides. Each door is given as the half-edge in the first of the two faces that share the side.
struct FaceStrip {
  FaceId first;
  std::vector<HalfedgeId> doors;
};

/// An end of a path, with its scaled position in doubles.
struct StripEnd {
  const SurfacePointTable* table;
  SurfacePointId point;
  Point3 at;

  /// Whether the point lies in the face or on its boundary.
  bool lies_in(FaceId f) const { return table->is_in(point, f); }
};

/// Returns the faces that contain a point. If the point is a vertex, the faces are in their cyclic
/// order around the vertex. An isolated vertex has no faces.
std::vector<FaceId> faces_at(const SurfacePointTable& points, SurfacePointId p);

/// Finds and shortens strips. An object reuses its working memory for many strips on one mesh. The
/// constructor takes time linear in the number of faces of the mesh. Each strip takes time linear
/// in the number of faces visited.
class StripFinder {
 public:
  /// `positions` are the positions of the vertices, scaled so that no product of two coordinates
  /// overflows.
  StripFinder(const SurfaceMesh& mesh, std::span<const Point3> positions);

  /// Returns a short strip from one end to the other, found by an A* search. The search measures
  /// the length of a strip along the centroids of its faces. Returns no value if no strip leads
  /// from one end to the other. The search has a lower bound for the lengths of strips through each
  /// face. If two faces have the same bound, the face with the lower index is visited first. So the
  /// result is the same on all platforms.
  std::optional<FaceStrip> find(const StripEnd& from, const StripEnd& to, Context& context);

  /// Shortens a strip from `from` to `to`. The new strip begins at the last face of the strip that
  /// contains `from`. It ends at the first face after this face that contains `to`. If the strip
  /// visits a face several times between these two faces, the detour between the visits is removed.
  /// The shortest path in the strip does not become longer.
  void shorten(FaceStrip& strip, const StripEnd& from, const StripEnd& to);

 private:
  struct Visit {
    std::uint32_t round = 0;  // Number of the call that made the entry; older entries are void.
    bool is_done = false;
    double cost = 0;
    HalfedgeId door;         // Half-edge through which the face was entered.
    std::uint32_t last = 0;  // Last position in the strip, for shorten().
  };
  struct Entry {
    double bound;
    FaceId face;
  };
  static bool is_later(const Entry& a, const Entry& b) {
    return a.bound != b.bound ? a.bound > b.bound : a.face > b.face;
  }

  Visit& visit(FaceId f) { return visits_[f]; }
  void offer(FaceId f, double cost, HalfedgeId door);
  FaceStrip collected(FaceId last) const;
  Point3 centroid(FaceId f) const;

  const SurfaceMesh& mesh_;
  std::span<const Point3> positions_;
  IdVector<FaceId, Visit> visits_;
  std::uint32_t round_ = 0;
  std::vector<Entry> heap_;
  Point3 goal_;
};

/// Returns the half-edges that are crossed on a way around a vertex. The vertex is the origin of
/// the half-edge `from`. The way starts in the face of `from` and ends in the face `to`, which is
/// also at the vertex. The way is clockwise if `clockwise` is true, otherwise counter-clockwise.
/// Returns no value if the way would cross the border of the mesh.
std::optional<std::vector<HalfedgeId>> doors_around(const SurfaceMesh& mesh, HalfedgeId from,
                                                    FaceId to, bool clockwise);

/// Calls visit(h) for each half-edge h that leaves v.
template <class Visit>
void for_halfedges_from(const SurfaceMesh& mesh, VertexId v, const Visit& visit) {
  const HalfedgeId first = mesh.halfedge(v);
  for (HalfedgeId h = first; h.is_valid();) {
    visit(h);
    h = mesh.twin(SurfaceMesh::prev(h));
    if (h == first) return;
  }
}

}  // namespace plumb
#pragma GCC visibility pop
