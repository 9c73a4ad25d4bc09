// Meshes, and polygons on them whose exact paths are known without a tracer.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "plumb/predicates/rational_point.h"
#include "plumb/surface/surface.h"

namespace plumb::testing {

using MeshPointer = std::shared_ptr<const SurfaceMesh>;

/// Squares [0, columns] x [0, rows] of the plane z = 0, each cut in two by a diagonal; vertex (x,
/// y) is y (columns + 1) + x. `shuffle`: seed of a random order of vertices and faces, and turn of
/// each; 0: none.
MeshPointer grid_mesh(std::uint32_t columns, std::uint32_t rows, std::uint64_t shuffle = 0);
/// Vertex (i, j) is i * minor + j: i the long way around, j the short way. A meridian has constant
/// i.
MeshPointer torus_mesh(std::uint32_t major, std::uint32_t minor);
/// Rings of `around` vertices at heights 0 ... up; open at both ends.
MeshPointer cylinder_mesh(std::uint32_t around, std::uint32_t up);
/// [0, 1]^3 with a diagonal in every face.
MeshPointer cube_mesh();
/// A cube with every face a grid of n x n squares: a sphere.
MeshPointer sphere_mesh(std::uint32_t n);
/// All parts side by side as one mesh.
MeshPointer joined_meshes(std::span<const MeshPointer> parts);
/// `handles` tori in a row, joined along triangles: of that genus.
MeshPointer chain_of_tori(std::uint32_t handles, std::uint32_t major, std::uint32_t minor);

/// A closed walk on edges of a mesh: any bytes are one. The first chooses where it starts, the
/// others where it goes on; then it leads home on a shortest way.
std::vector<std::uint32_t> closed_walk(const SurfaceMesh& mesh,
                                       std::span<const std::uint8_t> steps);

/// Polygons being drawn on a mesh.
class SurfaceDrawing {
 public:
  explicit SurfaceDrawing(MeshPointer mesh);

  SurfaceScene scene;

  SurfacePointId vertex(std::uint32_t v) { return points().add_vertex(VertexId(v)); }
  /// `weight`: that of b.
  SurfacePointId on_edge(std::uint32_t a, std::uint32_t b, const Rational& weight);
  /// A point of a mesh in the plane z = 0 (grid_mesh).
  SurfacePointId at(const Rational& x, const Rational& y);

  /// Consecutive points lie in one face (the first one found). All are control points.
  void add_polygon(std::span<const SurfacePointId> corners);
  /// Along the straight lines between points of a flat mesh.
  void add_flat_polygon(std::span<const RationalPoint2> corners);
  /// Along the edges between vertices.
  void add_vertex_polygon(std::span<const std::uint32_t> vertices);
  void add_box(const RationalPoint2& low, const RationalPoint2& high);

 private:
  SurfacePointTable& points() { return scene.polygons.points; }
  FaceId common_face(SurfacePointId p, SurfacePointId q) const;
  void add_flat_leg(const RationalPoint2& from, const RationalPoint2& to);
};

}  // namespace plumb::testing
