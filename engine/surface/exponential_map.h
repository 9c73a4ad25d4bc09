// The exponential map: where straight lines from a point of a mesh lead. It puts drawings on surfaces.
//
// An offset (x, y) goes to the end of the straight line that leaves the centre in the direction of (x, y) and is as
// long as (x, y). In the face that is named the axis x runs along the side from its first to its second corner (as
// the mesh was given: SurfaceMesh::is_flipped), turned counter-clockwise by an angle; y is a quarter turn further
// counter-clockwise. Flat surroundings of the centre are mapped by a similarity.
//
// Around a vertex inside the mesh with a full angle other than a whole turn all directions are spread evenly, from
// the side of the named face that leaves the vertex. At the border they are not: some lead off the mesh.
//
// Main flow of ExponentialMap::add:
//  1. aim     a face at the centre and the line in it, laid out in the plane
//  2. cross   side after side, each next face laid out beside the last: the third corner decides where it goes on.
//             A line along a side goes through either face beside it, as rounding has it
//  3. pass    a vertex with another angle than a whole turn that lies within 2^-40 of the line's direction is passed
//             with equal angles on both sides (a straightest line: Polthier and Schmies 1998), at the border with half
//             a turn on one side
//  4. land    weights in the last face; those below 2^-40 are zero: the point lies on an edge or a vertex
//
// All of it in doubles; what was found is exact from 4 on.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "plumb/base/context.h"
#include "plumb/surface/face_layout.h"
#include "plumb/surface/surface_mesh.h"
#include "plumb/surface/surface_point.h"

#pragma GCC visibility push(default)
namespace plumb {

/// Offsets in a plane as straight lines on a mesh, from one of its points.
class ExponentialMap {
 public:
  /// Around `centre`, a point of `points` that lies in `face`. `angle` in degrees, finite. The mesh has to
  /// outlive the map. O(n).
  ExponentialMap(const SurfacePointTable& points, SurfacePointId centre, FaceId face, double angle);

  /// Appends the point at an offset, in units of the mesh and finite, to a table over the same mesh. None when the
  /// line leaves the mesh at its border. Cost: O(faces crossed + degrees of the vertices passed), and O(log degree)
  /// of the centre if it is a vertex. Errors: ResourceLimit for a line that crosses more faces than several rounds
  /// over the whole mesh; Cancelled.
  std::optional<SurfacePointId> add(Point2 offset, SurfacePointTable& points,
                                    Context& context) const;

 private:
  struct Line;
  /// The corners around a vertex, counter-clockwise.
  struct Fan {
    std::vector<HalfedgeId> halfedges;  ///< leave the vertex
    std::vector<double> angles = {0};   ///< from the first to each, and the full angle
    bool is_at_border = false;

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
  std::size_t corner_ = kInside;  // of the face, if the centre is that vertex
  Fan fan_;                       // around it then
  double angle_before_ = 0;       // of that corner in it
  Point2 x_axis_;                 // in the layout of the face

  static constexpr std::size_t kInside = 3;
};

}  // namespace plumb
#pragma GCC visibility pop
