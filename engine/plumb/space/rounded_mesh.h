// Checks whether rounding the vertices of a mesh to doubles has broken the mesh.
//
// Main flow of check_rounding():
//  1. doubtful_faces  selects the faces that may be degenerate, reversed or crossed by other faces
//                     after rounding (mesh/doubtful_faces.h). For all other faces, a computation
//                     with doubles proves that they have none of these defects
//  2. check_faces     calls complex_of_mesh() for the selected faces with rounded coordinates, and
//                     takes the defects from the report of this call. Then it compares the normals
//                     of the selected faces before and after rounding
//
// Cost: O(V) for V vertices if all their coordinates are doubles. Otherwise, the check builds a
// tree of O(n) boxes, tests the pairs whose boxes meet, and calls complex_of_mesh() for the faces
// of step 1.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "plumb/base/context.h"
#include "plumb/space/mesh_arrays.h"

#pragma GCC visibility push(default)
namespace plumb {

/// The type of number to which coordinates are rounded.
enum class CoordinateType : std::uint8_t {
  Double,  ///< Doubles.
  Float,   ///< Floats, as in binary STL. In memory, their values are stored as doubles.
};

/// Returns the number of the given type that is nearest to `value`. The writers of files and the
/// functions that check meshes all use this function, so they round in the same way. Throws
/// Error{NumberOutOfRange} if `value` rounds to an infinity. Requires that the rounding mode is to
/// nearest.
double nearest_coordinate(double value, CoordinateType type);

/// Returns the exponent e of the last digit of `value` in the given type: near `value`, the numbers
/// of this type are the multiples of 2^e. Requires a finite value.
int last_digit_exponent(double value, CoordinateType type);

/// Rounds the coordinates of a point to the nearest numbers of the type. Returns an upper bound for
/// the distance by which the point moved. If `is_constructed` is true, the coordinates were already
/// rounded once, from an exact point to the nearest doubles. In this case, the bound is for the
/// distance from the exact point. Throws as nearest_coordinate() does.
double round_point(Point3& point, bool is_constructed, CoordinateType type);

/// Rounds all points of a mesh to the nearest numbers of the type. Afterwards, mesh.exact lists the
/// points that moved, with the coordinates that they had before. Returns an upper bound for the
/// distances by which points moved. Throws as nearest_coordinate() does. O(points).
double round_points(PolygonMesh& mesh, CoordinateType type);

/// The effects of rounding on a mesh. Faces and vertices are given by their indices in the mesh.
/// Every list is in ascending order. If the list beyond_doubles is not empty, all other members
/// except rounded_vertices are left empty or 0.
struct RoundingReport {
  using FacePair = std::pair<std::uint32_t, std::uint32_t>;  ///< Two faces of the mesh.

  /// Number of vertices whose exact coordinates are not doubles.
  std::uint64_t rounded_vertices = 0;
  /// Vertices with a coordinate that rounds to an infinity.
  std::vector<std::uint32_t> beyond_doubles;
  std::uint64_t vertices_merged =
      0;  ///< Number of vertices that coincide with another vertex after rounding.
  std::vector<std::uint32_t> degenerate;  ///< Faces that have no area after rounding.
  std::vector<std::uint32_t> flipped;     ///< Faces whose normal is reversed by rounding.
  std::vector<std::uint32_t> not_simple;  ///< Faces that cross themselves after rounding.
  std::vector<FacePair> doubled;          ///< Pairs of faces that coincide after rounding.
  std::uint64_t crossing_count = 0;       ///< Number of pairs of facets that cross after rounding.
  std::vector<FacePair> crossings;        ///< The first pairs of faces that cross.
  /// Polygons that are not planar after rounding. Neighbouring faces still fit together, but a
  /// program that reads the mesh must triangulate these polygons. The function complex_of_mesh()
  /// splits each of them into constrained Delaunay triangles, and tests the triangles for
  /// crossings.
  std::vector<std::uint32_t> not_planar;

  /// Whether the mesh is intact after rounding. A mesh counts as intact even if some of its
  /// polygons are no longer planar.
  bool is_sound() const {
    return beyond_doubles.empty() && vertices_merged == 0 && degenerate.empty() &&
           flipped.empty() && not_simple.empty() && doubled.empty() && crossing_count == 0;
  }
};

/// Returns the effects of rounding on the mesh. At most `max_listed` crossings are listed, but
/// crossing_count counts all crossings. Requires that no two faces of the mesh cross or coincide
/// before rounding. Throws the errors of the Context.
RoundingReport check_rounding(const PolygonMesh& mesh, std::uint64_t max_listed,
                              Context& context = unlimited_context());

}  // namespace plumb
#pragma GCC visibility pop
