// A strip of faces laid out in the plane, the shortest path in it, and the exact places where a
// straight line crosses sides of faces that lie in one plane.
//
// On flat parts of a mesh exact places need no roots: lines that overlap, touch or meet in one
// point in that plane do so on the surface, too, wherever they begin and end.
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

/// A point of a strip of faces: a vertex, or else a point of a table.
struct FlatRunEnd {
  VertexId vertex;  ///< Invalid if `point` is meant.
  SurfacePointId point;
};

/// Returns, for the line from a point in the face of doors.front() to one in the face beyond
/// doors.back(), where it crosses each door: the part of the way from the origin of the door to its
/// target. Returns no value unless all those faces lie in one plane, none folded back, and the line
/// passes strictly inside all doors. Cost: O(doors); usually the first predicate already fails.
/// Throws Error{Cancelled} and Error{ResourceLimit}.
std::optional<std::vector<Rational>> flat_run(const SurfacePointTable& points,
                                              std::span<const HalfedgeId> doors,
                                              const FlatRunEnd& from, const FlatRunEnd& to,
                                              Context& context);

// The shortest path in an unfolded strip.

/// A point of the path: the start, the end, a vertex, or a place inside a door.
struct StripStop {
  Point2 at;
  VertexId vertex;         ///< Invalid if this is no vertex.
  std::uint32_t door = 0;  ///< A door that it lies on.
  /// Part of the way from the origin of the door to its target, if inside the door.
  double part = 0;
  std::uint32_t first = 0;  ///< It lies in the faces `first` to `last` of the strip.
  std::uint32_t last = 0;
  bool is_left = false;  ///< For a vertex: whether it is the target of its doors.
};

/// The faces `first` to `last` of a strip, around a bend with less than half a turn on its other
/// side.
struct StripTurn {
  VertexId vertex;
  std::uint32_t first, last;
  bool is_left;
  double gain;  ///< The part of a half turn that is missing, in radians.
};

/// A strip laid out in the plane, with the shortest path in it.
class UnfoldedStrip {
 public:
  /// Lays the faces out and finds the bends. Cost: O(doors), except for strips that wind much.
  UnfoldedStrip(const SurfaceMesh& mesh, std::span<const Point3> positions, const FaceStrip& strip,
                const StripEnd& from, const StripEnd& to);

  /// Returns the length of the path in scaled units.
  double path_length() const;
  /// Returns the bends where the strip should be led around the other side, in their order.
  std::vector<StripTurn> turns() const;
  /// Returns all points of the path: start, bends, places in doors, end. Vertices that the path
  /// would pass very closely count as bends here.
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
  /// Returns the part of a door that lies on the line from a to b.
  double part_on(std::size_t door, Point2 a, Point2 b) const;
  /// Returns the first door from a to b that the straight line between them passes at a vertex, or
  /// b.first if there is none.
  std::uint32_t first_vertex_door(const StripStop& a, const StripStop& b) const;
  void add_stops(const StripStop& a, const StripStop& b, std::vector<StripStop>& stops) const;
  std::array<std::uint32_t, 2> faces_at(std::size_t bend) const;
  double strip_angle(std::size_t bend) const;
  /// Returns the angle around an inner vertex; infinite at the border.
  double full_angle(VertexId v) const;

  const SurfaceMesh& mesh_;
  std::span<const Point3> positions_;
  const FaceStrip& strip_;
  std::vector<Point2> right_, left_;  // Origin and target of each door.
  std::vector<StripStop> bends_;      // Bends, with both ends.
};

}  // namespace plumb
