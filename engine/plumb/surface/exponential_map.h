// The exponential map of a mesh at a point of the mesh, the centre. The map takes an offset, which
// is a vector of the plane, to a point of the mesh. This point is the end of a straight line on the
// mesh that starts at the centre. The map is used to place plane drawings on surfaces.
//
// The line of an offset (x, y) leaves the centre in the direction of this vector, and has the
// length of this vector. The caller names a face that contains the centre. The x axis and the y
// axis lie in the plane of this face. To get the x axis, take the direction from the first to the
// second corner of the face, in the corner order of the input (SurfaceMesh::is_flipped()). Then
// turn this direction counter-clockwise by a given angle. The y axis is a quarter turn further
// counter-clockwise. If the mesh around the centre is flat, the map preserves the shapes of
// drawings there (it is a similarity).
//
// Suppose that the centre is a vertex inside the mesh, and that the full angle around this vertex
// is not a whole turn. In this case, angles between directions are multiplied by the ratio of the
// full angle to a whole turn. So all directions are spread evenly around the vertex. One direction
// does not change: the direction of the half-edge of the named face that leaves the vertex. If the
// centre is a vertex at the border, angles are not multiplied, and some of the lines leave the
// mesh.
//
// Main flow of ExponentialMap::add:
//  1. aim     chooses the face at the centre that the line enters. It unfolds this face and the
//             line into the plane
//  2. cross   follows the line across side after side, and lays out each new face beside the face
//             before it. The third corner of the new face decides which side the line crosses next.
//             If the line runs along a side, rounding decides which of the two faces at this side
//             the line passes through
//  3. pass    is taken if the line passes a vertex so closely that the direction of the line and
//             the direction towards the vertex differ by at most 2^-40. It continues the line
//             behind this vertex. If the full angle of an inner vertex is not a whole turn, the
//             line is continued so that the angles on both of its sides are equal. Then the line is
//             a straightest geodesic. At a vertex of the border, the line is continued so that the
//             angle on one side is half a turn
//  4. land    computes the weights of the end of the line in the last face. Weights below 2^-40 are
//             replaced by zero, so that the point lies on an edge or a vertex
//
// Steps 1 to 4 are computed in doubles. The resulting point is stored exactly and does not change
// later. Source: K. Polthier and M. Schmies, Straightest geodesics on polyhedral surfaces,
// Mathematical Visualization (1998). Design: docs/design/surface.md.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "plumb/base/context.h"
#include "plumb/surface/strip/face_strip.h"
#include "plumb/surface/surface_mesh.h"
#include "plumb/surface/surface_path.h"

#pragma GCC visibility push(default)
namespace plumb {

/// Maps offsets in a plane to the ends of straight lines on a mesh. All lines start at the same
/// point of the mesh.
class ExponentialMap {
 public:
  /// Makes the map around `centre`, which is a row of `points`. The x axis is the direction of the
  /// first side of `face`, turned counter-clockwise by `angle` degrees. Requires that the centre
  /// lies in `face` and that `angle` is finite. The mesh must outlive the map. Cost: O(n) for n
  /// vertices.
  ExponentialMap(const SurfacePointTable& points, SurfacePointId centre, FaceId face, double angle);

  /// Appends to `points` the point of the mesh that belongs to an offset, and returns the row of
  /// this point. Returns no value if the line leaves the mesh at its border. The offset is in units
  /// of the mesh. Requires that the offset is finite and that `points` is a table over the same
  /// mesh. The cost is linear in the number of faces that the line crosses, plus the degrees of the
  /// vertices that it passes. If the centre is a vertex, O(log degree) is added. Throws
  /// Error{ResourceLimit} if the line crosses too many faces: the limit is several times the number
  /// of faces of the mesh. Throws the errors of the Context.
  std::optional<SurfacePointId> add(Point2 offset, SurfacePointTable& points,
                                    Context& context = unlimited_context()) const;

 private:
  struct Line;
  /// The sectors of the faces around a vertex, counter-clockwise.
  struct Fan {
    std::vector<HalfedgeId> halfedges;  ///< The half-edges that leave the vertex.
    /// For each half-edge, the angle from the first half-edge to this half-edge. The last entry is
    /// the full angle.
    std::vector<double> angles = {0};
    bool is_at_border = false;  ///< Whether the vertex lies at the border.

    double full_angle() const { return angles.back(); }
    double angle_before(HalfedgeId h) const;
  };

  Fan fan_of(VertexId v) const;
  Line aim_from_inside(Point2 along) const;
  std::optional<Line> aim_from_corner(Point2 along) const;
  std::optional<Line> aim_from_vertex(const Fan& fan, double angle, double length) const;
  std::optional<Line> aim(Point2 offset, std::uint64_t most_faces) const;
  std::optional<std::size_t> vertex_ahead(const Line& line) const;
  static bool is_flat(const Line& line, std::size_t corner, const Fan& fan);
  static std::size_t way_out(const Line& line);
  static double part_at_side(const Line& line, std::size_t side);
  std::optional<Line> beyond_vertex(const Line& line, std::size_t corner, double part,
                                    const Fan& fan) const;
  SurfacePointId land(const Line& line, SurfacePointTable& points) const;

  const SurfaceMesh& mesh_;
  ScaledPositions positions_;
  FaceId face_;
  std::array<double, 3> weights_;
  std::size_t corner_ = kInside;  // The corner of face_ that is the centre, or kInside.
  Fan fan_;                       // The sectors of the faces around the centre if it is a vertex.
  double angle_before_ = 0;       // The angle of the corner `corner_` in fan_.
  Point2 x_axis_;                 // The x axis in the layout of face_.

  static constexpr std::size_t kInside = 3;
};

}  // namespace plumb
#pragma GCC visibility pop
