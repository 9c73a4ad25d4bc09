// Ids of the cells of a divided surface.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <vector>

#include "plumb/base/ids.h"
#include "plumb/predicates/error.h"
#include "plumb/predicates/point.h"

#pragma GCC visibility push(default)
namespace plumb {

using NodeId =
    StrongId<struct SurfaceNodeTag>;  ///< A point at which arcs or pieces of mesh edges end.
using ArcId =
    StrongId<struct SurfaceArcTag>;  ///< A part of one or more polygons between two nodes.
/// A part of one face, bounded by arcs and sides of the face.
using PieceId = StrongId<struct SurfacePieceTag>;
/// A connected component of the surface after the arcs are removed. A cell consists of pieces and
/// of whole faces.
using CellId = StrongId<struct SurfaceCellTag>;

/// An integer that belongs to a polygon or a shape. A list of entries represents a sparse vector:
/// the ids in the list are ascending, and no value is zero.
struct SignedEntry {
  std::uint32_t id;    ///< The index of the polygon or shape.
  std::int32_t value;  ///< The integer. It is not zero in a list.
  friend auto operator<=>(const SignedEntry&, const SignedEntry&) = default;
};

/// Returns `sum` as the value of an entry. The negative of the result is a valid value, too. Throws
/// Error{NumberOutOfRange} if the absolute value of `sum` is 2^31 or more.
inline std::int32_t entry_value(std::int64_t sum) {
  constexpr std::int64_t kMost = std::numeric_limits<std::int32_t>::max();
  if (sum > kMost || sum < -kMost) {
    throw Error(ErrorCode::NumberOutOfRange,
                "a polygon or shape winds around a cell 2^31 times or more");
  }
  return static_cast<std::int32_t>(sum);
}

// A triangle mesh as a surface. For each side of a triangle, the mesh stores the adjacent triangle.
//
// Half-edge 3 f + i runs from corner i of face f to corner i + 1, with the face to its left. The
// twin of a half-edge is the half-edge of the same edge in the adjacent face. A half-edge at the
// border has no twin. The constructor stores coordinates but does not use them. So triangles may
// have area zero, the mesh may intersect itself, and several vertices may have the same
// coordinates.
//
// Main flow of the constructor:
//  1. check     checks that corners are indices of points, and that each face has three different
//               corners
//  2. pair      pairs the half-edges of each edge by counting sort, and checks that no edge has
//               more than two half-edges
//  3. orient    visits faces from neighbour to neighbour, and flips faces so that twins run in
//               opposite directions
//  4. fans      checks that the faces around each vertex are one fan or one closed ring
//
// Cost: O(n) for n faces. Memory: 60 bytes for each face. Design: docs/design/surface.md.

/// A triangle, given by the point indices of its three corners.
using SurfaceTriangle = std::array<std::uint32_t, 3>;

/// An oriented triangle mesh that is a 2-manifold, closed or with border. The mesh may have any
/// number of components, and each component may have any genus. The mesh is immutable.
class SurfaceMesh {
 public:
  /// Makes an empty mesh.
  SurfaceMesh() = default;
  /// Makes the mesh of the given triangles. In each component, some faces are flipped so that all
  /// faces of the component have consistent orientations. There are two ways to do this. The
  /// constructor chooses the way in which fewer faces are flipped; in case of a tie, the first face
  /// of the component is not flipped. If a face is flipped, its last two corners are exchanged, and
  /// is_flipped() returns true for the face. Cost: O(n) for n faces. Throws:
  /// - Error{BadIndex} if a corner is not the index of a point,
  /// - Error{DegenerateFace} if a face has a repeated corner,
  /// - Error{BadShape} if the triangles are not an orientable manifold; the error lists up to ten
  ///   places where the triangles violate this condition,
  /// - Error{ResourceLimit} if there are more faces or points than ids can number.
  SurfaceMesh(std::vector<Point3> points, std::vector<SurfaceTriangle> triangles);

  std::size_t vertex_count() const { return points_.size(); }  ///< Returns the number of points.
  std::size_t face_count() const { return corners_.size(); }   ///< Returns the number of triangles.
  /// Returns the number of edges.
  std::size_t edge_count() const { return edge_halfedge_.size(); }
  /// Returns the number of components. Faces that share an edge are in one component.
  std::size_t component_count() const { return component_count_; }

  /// Returns the coordinates of the vertex.
  const Point3& point(VertexId v) const { return points_[v]; }
  /// Returns the indices of the face's three vertices.
  const SurfaceTriangle& corners(FaceId f) const { return corners_[f]; }
  /// Returns corner i of the face. Requires that i < 3.
  VertexId corner(FaceId f, std::size_t i) const { return VertexId(corners_[f][i]); }
  /// Whether the face was flipped. If it was flipped, this mesh has the second and the third corner
  /// of the input in exchanged order. So the weights of these two corners are exchanged, too.
  bool is_flipped(FaceId f) const { return is_flipped_[f] != 0; }
  /// Returns the index of the face's component. Components are in the order of the lowest face
  /// index in each component.
  std::uint32_t component(FaceId f) const { return component_[f]; }

  /// Returns side 0, 1 or 2 of the face. The side runs from the corner with the same index to the
  /// next corner.
  static HalfedgeId halfedge(FaceId f, std::size_t side) {
    return HalfedgeId(std::size_t{3} * f.value() + side);
  }
  /// Returns the face to the left of the half-edge.
  static FaceId face(HalfedgeId h) { return FaceId(h.value() / 3); }
  /// Returns the index (0, 1 or 2) of the half-edge among the sides of its face.
  static std::size_t side(HalfedgeId h) { return h.value() % 3; }
  /// Returns the next side of the face.
  static HalfedgeId next(HalfedgeId h) {
    return HalfedgeId(h.value() % 3 == 2 ? h.value() - 2 : h.value() + 1);
  }
  /// Returns the previous side of the face.
  static HalfedgeId prev(HalfedgeId h) { return next(next(h)); }
  /// Returns the vertex where the half-edge starts.
  VertexId origin(HalfedgeId h) const { return corner(face(h), side(h)); }
  /// Returns the vertex where the half-edge ends.
  VertexId target(HalfedgeId h) const { return origin(next(h)); }
  /// Returns the half-edge of the same edge in the adjacent face. It is invalid at the border.
  HalfedgeId twin(HalfedgeId h) const { return twin_[h]; }
  /// Whether the half-edge lies at the border: no face lies to its right.
  bool is_border(HalfedgeId h) const { return !twin(h).is_valid(); }
  /// Returns the edge of the half-edge.
  EdgeId edge(HalfedgeId h) const { return edge_[h]; }
  /// Returns one half-edge of the edge: the half-edge in the face with the lower index.
  HalfedgeId halfedge(EdgeId e) const { return edge_halfedge_[e]; }
  /// Whether the half-edge starts at that end of its edge which has the lower vertex index.
  bool is_upward(HalfedgeId h) const { return origin(h) < target(h); }
  VertexId lower(EdgeId e) const;  ///< Returns the end with the lower index.
  VertexId upper(EdgeId e) const;  ///< Returns the end with the higher index.
  /// Returns a half-edge that starts in v, or an invalid id if v has no face. If v lies at the
  /// border, the result is the first half-edge in counter-clockwise order around v. So repeated
  /// steps from h to twin(prev(h)) always visit all half-edges that start in v.
  HalfedgeId halfedge(VertexId v) const { return vertex_halfedge_[v]; }

 private:
  void check_corners() const;
  void pair_halfedges();
  void orient_faces();
  void number_edges();
  void find_fans();

  IdVector<VertexId, Point3> points_;
  IdVector<FaceId, SurfaceTriangle> corners_;
  IdVector<FaceId, std::uint8_t> is_flipped_;
  IdVector<FaceId, std::uint32_t> component_;
  std::size_t component_count_ = 0;
  IdVector<HalfedgeId, HalfedgeId> twin_;
  IdVector<HalfedgeId, EdgeId> edge_;
  IdVector<EdgeId, HalfedgeId> edge_halfedge_;
  IdVector<VertexId, HalfedgeId> vertex_halfedge_;
};

}  // namespace plumb
#pragma GCC visibility pop
