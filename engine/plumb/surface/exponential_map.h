// The exponential map of a mesh: it maps offsets to the ends of straight lines that start at one
// point of the mesh. It places plane drawings on surfaces.
//
// An offset (x, y) is mapped to the end of the straight line that leaves the centre in the
// direction of (x, y) and is as long as (x, y). The axes are laid out in a face at the centre,
// which the caller names. The x axis has the direction of the side from the first to the second
// corner of that face, in the corner order of the input (SurfaceMesh::is_flipped()), turned
// counter-clockwise by an angle. The y axis is a quarter turn further counter-clockwise. Where the
// surroundings of the centre are flat, the map is a similarity.
//
// A centre may be a vertex inside the mesh whose full angle is not a whole turn. Then all
// directions are spread evenly over the full angle, starting at the side of the named face that
// leaves the vertex. At a vertex of the border the directions are not spread, and some of them lead
// off the mesh.
//
// Main flow of ExponentialMap::add:
//  1. aim     chooses a face at the centre and lays it out in the plane, with the line
//  2. cross   crosses side after side, and lays out each next face beside the last; the third
//             corner decides which side comes next. A line along a side passes through either face
//             beside it, depending on rounding
//  3. pass    continues the line behind a vertex within 2^-40 of its direction. If the full angle
//             of an inner vertex is not a whole turn, the angles on both sides of the line are
//             equal there, so that it is a straightest geodesic. At a vertex of the border, the
//             angle on one side is half a turn
//  4. land    computes the weights in the last face; weights below 2^-40 become zero, so that the
//             point lies on an edge or a vertex
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
  /// Makes the map around `centre`, which is a row of `points`. The x axis is turned by `angle`
  /// degrees against the first side of `face`. Requires that the centre lies in `face` and that
  /// `angle` is finite. The mesh must outlive the map. O(n).
  ExponentialMap(const SurfacePointTable& points, SurfacePointId centre, FaceId face, double angle);

  /// Appends the point at an offset to `points` and returns its row. Returns no value if the line
  /// leaves the mesh at its border. The offset is in units of the mesh. Requires that the offset is
  /// finite and that `points` is a table over the same mesh. Costs O(faces crossed + degrees of the
  /// vertices passed), and O(log degree) more if the centre is a vertex. Throws
  /// Error{ResourceLimit} if the line crosses more faces than it would in several rounds over the
  /// whole mesh, and what the context throws.
  std::optional<SurfacePointId> add(Point2 offset, SurfacePointTable& points,
                                    Context& context = unlimited_context()) const;

 private:
  struct Line;
  /// The corners around a vertex, counter-clockwise.
  struct Fan {
    std::vector<HalfedgeId> halfedges;  ///< The half-edges that leave the vertex.
    /// The angle from the first half-edge to each, then the full angle.
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
  Fan fan_;                       // The corners around the centre if it is a vertex.
  double angle_before_ = 0;       // The angle of that corner in fan_.
  Point2 x_axis_;                 // The x axis in the layout of face_.

  static constexpr std::size_t kInside = 3;
};

}  // namespace plumb
#pragma GCC visibility pop
