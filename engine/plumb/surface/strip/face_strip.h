// Strips of triangles of a mesh, for paths that are found in doubles: faces laid out in the plane,
// each beside the one before, and strips between two points (trace.h, exponential_map.h).
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

/// Vertices times 2^-exponent, so that no product of two of their coordinates overflows.
struct ScaledPositions {
  std::vector<Point3> at;
  int exponent = 0;
};
/// Returns the vertices scaled so that coordinates are at most 1.
ScaledPositions scaled_positions(const SurfaceMesh& mesh);

/// The corners of a face in the plane, in the order of the mesh, counter-clockwise.
using FaceCorners = std::array<Point2, 3>;

/// Returns the face with corner `first` at the origin and the next corner to the right of it.
FaceCorners laid_out(const SurfaceMesh& mesh, std::span<const Point3> positions, FaceId f,
                     std::size_t first);
/// Returns the face across a door, given the corners of the face that the door leads out of.
/// Requires that there is one.
FaceCorners laid_out_across(const SurfaceMesh& mesh, std::span<const Point3> positions,
                            const FaceCorners& corners, HalfedgeId door);

/// Returns the angle of the face of h at the origin of h, from 0 to pi.
double corner_angle(const SurfaceMesh& mesh, std::span<const Point3> positions, HalfedgeId h);

/// Returns the weights of a point, by its approximate parameters, among three corners of one of its
/// faces.
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

// Strips of faces between two points of a mesh, for tracing (trace.h): found over the dual graph,
// led to the other side of a vertex, cut short. Doubles choose; whatever they choose is a strip.

/// Faces, each across a side of the one before. `doors` are those sides, as half-edges of the faces
/// that they lead out of.
struct FaceStrip {
  FaceId first;
  std::vector<HalfedgeId> doors;
};

/// An end of a path, with its position in the doubles of the tracer.
struct StripEnd {
  const SurfacePointTable* table;
  SurfacePointId point;
  Point3 at;

  /// Whether the point lies in the face or on its boundary.
  bool lies_in(FaceId f) const { return table->is_in(point, f); }
};

/// Returns the faces that a point lies in, those around a vertex in order. An isolated vertex has
/// none.
std::vector<FaceId> faces_at(const SurfacePointTable& points, SurfacePointId p);

/// Working memory for many strips on one mesh: O(faces) once, then O(faces looked at).
class StripFinder {
 public:
  /// `positions` are those of the vertices, scaled so that no product of two overflows.
  StripFinder(const SurfaceMesh& mesh, std::span<const Point3> positions);

  /// Returns a strip that is short as measured by the centroids of its faces (A*); no value if no
  /// strip leads from one end to the other. Ties go to the lower face, so the answer does not
  /// depend on the platform's heap.
  std::optional<FaceStrip> find(const StripEnd& from, const StripEnd& to, Context& context);

  /// Cuts out what leads back to a face, and faces at the ends that are left at the end itself. A
  /// path in the strip does not become longer.
  void shorten(FaceStrip& strip, const StripEnd& from, const StripEnd& to);

 private:
  struct Visit {
    std::uint32_t round = 0;  // Round of find() or shorten(); an older entry counts as absent.
    bool is_done = false;
    double cost = 0;
    HalfedgeId door;         // Half-edge through which the face was entered.
    std::uint32_t last = 0;  // Last place in the strip, for shorten().
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

/// Returns the half-edges crossed on the way around a vertex, clockwise or counter-clockwise, from
/// the face of `from`, which leaves the vertex, to another face at it; no value if the border is in
/// the way.
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
