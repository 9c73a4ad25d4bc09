// Strips of faces between two points of a mesh, for tracing (trace.h): found over the dual graph, led to the
// other side of a vertex, cut short. Doubles choose; whatever they choose is a strip.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "plumb/base/context.h"
#include "plumb/base/ids.h"
#include "plumb/predicates/point.h"
#include "plumb/surface/surface_mesh.h"
#include "plumb/surface/surface_point.h"

#pragma GCC visibility push(default)
namespace plumb {

/// Faces, each across a side of the one before. `doors` are those sides, as half-edges of the face they lead
/// out of.
struct FaceStrip {
  FaceId first;
  std::vector<HalfedgeId> doors;
};

/// An end of a path, with where it lies in the doubles of the tracer.
struct StripEnd {
  const SurfacePointTable* table;
  SurfacePointId point;
  Point3 at;

  /// In the face or on its boundary?
  bool lies_in(FaceId f) const { return table->is_in(point, f); }
};

/// The faces that a point lies in, those around a vertex in order. An isolated vertex has none.
std::vector<FaceId> faces_at(const SurfacePointTable& points, SurfacePointId p);

/// Working memory for many strips on one mesh: O(faces) once, then O(faces looked at).
class StripFinder {
 public:
  /// `positions` are those of the vertices, scaled so that no product of two overflows.
  StripFinder(const SurfaceMesh& mesh, std::span<const Point3> positions);

  /// Short by the centroids of its faces (A*). None when no strip leads from one end to the other.
  /// Ties go to the lower face: the same answer everywhere.
  std::optional<FaceStrip> find(const StripEnd& from, const StripEnd& to, Context& context);

  /// Cuts out what leads back to a face, and faces at the ends that are left at the end itself. A path in
  /// the strip does not become longer.
  void shorten(FaceStrip& strip, const StripEnd& from, const StripEnd& to);

 private:
  struct Visit {
    std::uint32_t round = 0;  // of find() or shorten(): anything older was never there
    bool is_done = false;
    double cost = 0;
    HalfedgeId door;         // through which it was entered
    std::uint32_t last = 0;  // of shorten(): where in the strip
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

/// The half-edges crossed on the way around a vertex, clockwise or counter-clockwise, from the face of `from`,
/// which leaves the vertex, to another face at it. None when the border is in the way.
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
