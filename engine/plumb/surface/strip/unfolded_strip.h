// Where a straight line crosses sides of faces that lie in one plane: exactly.
//
// On flat parts of a mesh this needs no roots: lines that overlap, touch or meet in one point in
// that plane do so on the surface, too, wherever they begin and end.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "plumb/base/context.h"
#include "plumb/predicates/point.h"
#include "plumb/predicates/rational.h"
#include "plumb/surface/strip/face_strip.h"
#include "plumb/surface/surface_mesh.h"
#include "plumb/surface/surface_path.h"

namespace plumb {

/// A point of a strip of faces: a vertex, or else one of a table.
struct FlatRunEnd {
  VertexId vertex;  ///< invalid: `point`
  SurfacePointId point;
};

/// The line from a point in the face of doors.front() to one in the face beyond doors.back(): which
/// part of the way from the origin of each door to its target it crosses it at. None unless all
/// those faces lie in one plane, none folded back, and the line passes strictly inside all doors.
/// Cost: O(doors); most often the first predicate says no. Errors: Cancelled, ResourceLimit.
std::optional<std::vector<Rational>> flat_run(const SurfacePointTable& points,
                                              std::span<const HalfedgeId> doors,
                                              const FlatRunEnd& from, const FlatRunEnd& to,
                                              Context& context);

// A strip of faces laid out in the plane, and the shortest path in it.

/// A point of the path: the start, the end, a vertex, or a place inside a door.
struct StripStop {
  Point2 at;
  VertexId vertex;          ///< invalid: no vertex
  std::uint32_t door = 0;   ///< one that it lies on
  double part = 0;          ///< of the way from the origin of the door to its target, if inside it
  std::uint32_t first = 0;  ///< it lies in faces first .. last of the strip
  std::uint32_t last = 0;
  bool is_left = false;  ///< of a vertex: the target of its doors
};

/// Faces first .. last of a strip, around a bend with less than half a turn on its other side.
struct StripTurn {
  VertexId vertex;
  std::uint32_t first, last;
  bool is_left;
  double gain;  ///< how much of half a turn is missing
};

class UnfoldedStrip {
 public:
  /// Lays the faces out and finds the bends. O(doors), but for strips that wind much.
  UnfoldedStrip(const SurfaceMesh& mesh, std::span<const Point3> positions, const FaceStrip& strip,
                const StripEnd& from, const StripEnd& to);

  double path_length() const;
  /// Bends where the strip should be led around the other side, in their order.
  std::vector<StripTurn> turns() const;
  /// All points of the path: from, bends, places in doors, to. Vertices that it would pass by very
  /// closely are bends here.
  std::vector<StripStop> stops() const;

 private:
  void lay_out(const StripEnd& from, const StripEnd& to);
  void pull();
  void add_bend(std::size_t door, bool is_left);

  VertexId right_vertex(std::size_t door) const { return mesh_.origin(strip_.doors[door]); }
  VertexId left_vertex(std::size_t door) const { return mesh_.target(strip_.doors[door]); }
  bool has(std::size_t door, VertexId v) const {
    return left_vertex(door) == v || right_vertex(door) == v;
  }
  StripStop vertex_stop(std::size_t door, bool is_left) const;
  /// The part of a door on the line from a to b.
  double part_on(std::size_t door, Point2 a, Point2 b) const;
  /// The first door from a to b that the straight line between them passes at a vertex; b.first if
  /// none.
  std::uint32_t first_vertex_door(const StripStop& a, const StripStop& b) const;
  void add_stops(const StripStop& a, const StripStop& b, std::vector<StripStop>& stops) const;
  std::array<std::uint32_t, 2> faces_at(std::size_t bend) const;
  double strip_angle(std::size_t bend) const;
  /// The angle around an inner vertex; infinite at the border.
  double full_angle(VertexId v) const;

  const SurfaceMesh& mesh_;
  std::span<const Point3> positions_;
  const FaceStrip& strip_;
  std::vector<Point2> right_, left_;  // of each door: its origin, its target
  std::vector<StripStop> bends_;      // with both ends
};

}  // namespace plumb
