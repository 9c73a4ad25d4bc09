// Strips of triangles of a mesh, for paths that are found in doubles. The first part lays out faces
// in the plane, each beside the face before it. The second part finds strips between two points
// (trace.h, exponential_map.h).
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

/// The corners of a face in the plane, in the order of the mesh, counter-clockwise.
using FaceCorners = std::array<Point2, 3>;

/// Returns the face laid out with corner `first` at the origin and the next corner to the right of
/// it.
FaceCorners laid_out(const SurfaceMesh& mesh, std::span<const Point3> positions, FaceId f,
                     std::size_t first);
/// Lays out the face on the other side of a door, beside the face that the door leads out of.
/// `corners` are the corners of that face. Requires that there is a face on the other side.
FaceCorners laid_out_across(const SurfaceMesh& mesh, std::span<const Point3> positions,
                            const FaceCorners& corners, HalfedgeId door);

/// Returns the angle, from 0 to pi, of the face of h at the origin of h.
double corner_angle(const SurfaceMesh& mesh, std::span<const Point3> positions, HalfedgeId h);

/// Returns the weights of the three corners of a face in a point of that face, computed from the
/// approximate parameters of the point.
std::array<double, 3> weights_in(const SurfacePointTable& table, SurfacePointId p, FaceId f);

/// Vectors of doubles for layouts in the plane.
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

// Strips of faces between two points of a mesh, for tracing (trace.h). A strip is found over the
// dual graph, led to the other side of a vertex, and shortened. Doubles choose among strips. A
// rounding error can change the choice, but the result is always a strip.

/// A sequence of faces in which each face shares a side with the next one. `doors` are the shared
/// sides, as half-edges of the faces that they lead out of.
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

/// Returns the faces that contain a point. The faces around a vertex are in order around it. An
/// isolated vertex has no faces.
std::vector<FaceId> faces_at(const SurfacePointTable& points, SurfacePointId p);

/// Finds and shortens strips, and keeps the working memory for many strips on one mesh. Costs
/// O(faces) once, then O(faces visited) for each strip.
class StripFinder {
 public:
  /// `positions` are the positions of the vertices, scaled so that no product of two coordinates
  /// overflows.
  StripFinder(const SurfaceMesh& mesh, std::span<const Point3> positions);

  /// Returns a strip whose length, measured by the centroids of its faces, is short (A* search).
  /// Returns no value if no strip leads from one end to the other. Ties go to the lower face, so
  /// the answer does not depend on the platform's heap.
  std::optional<FaceStrip> find(const StripEnd& from, const StripEnd& to, Context& context);

  /// Keeps the part of the strip from the last face that contains its start to the next face that
  /// contains its end. Within this part, removes every detour from a face back to the same face.
  /// The shortest path in the strip does not become longer.
  void shorten(FaceStrip& strip, const StripEnd& from, const StripEnd& to);

 private:
  struct Visit {
    std::uint32_t round = 0;  // Round of find() or shorten(); an older entry counts as absent.
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

  Visit& visit(FaceId f) { return visits_[f.value()]; }
  void offer(FaceId f, double cost, HalfedgeId door);
  FaceStrip collected(FaceId last) const;
  Point3 centroid(FaceId f) const;

  const SurfaceMesh& mesh_;
  std::span<const Point3> positions_;
  std::vector<Visit> visits_;
  std::uint32_t round_ = 0;
  std::vector<Entry> heap_;
  Point3 goal_;
};

/// Returns the half-edges that a way around a vertex crosses, clockwise or counter-clockwise. The
/// half-edge `from` leaves the vertex, and the way leads from the face of `from` to the face `to`
/// at the same vertex. Returns no value if the border is in the way.
std::optional<std::vector<HalfedgeId>> doors_around(const SurfaceMesh& mesh, HalfedgeId from,
                                                    FaceId to, bool clockwise);

/// Calls visit(h) for the half-edges that leave v.
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
