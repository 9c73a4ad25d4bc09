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

using NodeId = StrongId<struct SurfaceNodeTag>;  ///< A point where arcs and sides of faces end.
using ArcId = StrongId<struct SurfaceArcTag>;    ///< A part of polygons between two nodes.
/// A part of one face, bounded by arcs and sides of the face.
using PieceId = StrongId<struct SurfacePieceTag>;
/// A connected part of the surface: pieces and whole faces that no polygon separates from each
/// other.
using CellId = StrongId<struct SurfaceCellTag>;

/// An integer that belongs to a polygon or a shape. A list of entries is a sparse vector: ids are
/// ascending and no value is zero.
struct SignedEntry {
  std::uint32_t id;    ///< The index of the polygon or shape.
  std::int32_t value;  ///< The integer. It is not zero in a list.
  friend auto operator<=>(const SignedEntry&, const SignedEntry&) = default;
};

/// Returns `sum` as the value of an entry. Its negative can be the value of an entry, too. Throws
/// Error{NumberOutOfRange} if the absolute value of `sum` is 2^31 or more.
inline std::int32_t entry_value(std::int64_t sum) {
  constexpr std::int64_t kMost = std::numeric_limits<std::int32_t>::max();
  if (sum > kMost || sum < -kMost) {
    throw Error(ErrorCode::NumberOutOfRange,
                "a polygon or shape winds around a cell 2^31 times or more");
  }
  return static_cast<std::int32_t>(sum);
}

// A triangle mesh as a surface. For each side of a triangle it stores the adjacent triangle.
//
// Half-edge 3 f + i runs from corner i of face f to corner i + 1, with the face to its left. Its
// twin is the half-edge of the same edge in the adjacent face. A half-edge at the border has no
// twin. Coordinates are not read, so triangles of area zero, meshes that intersect themselves and
// coincident vertices are allowed.
//
// Main flow of the constructor:
//  1. check     checks that ids exist and that each face has three different corners
//  2. pair      pairs the half-edges of each edge by counting sort; at most two share an edge
//  3. orient    flips faces, by a flood, until twins run in opposite directions
//  4. fans      checks that the faces around each vertex are one fan or one closed ring
//
// Cost: O(n). Memory: 60 bytes for each face. Design: docs/design/surface.md.

/// The indices of its three corners among the points.
using SurfaceTriangle = std::array<std::uint32_t, 3>;

/// An oriented triangle mesh that is a 2-manifold, closed or with border. It may have any number of
/// components of any genus. The mesh is immutable.
class SurfaceMesh {
 public:
  /// Makes an empty mesh.
  SurfaceMesh() = default;
  /// Makes the mesh of the triangles. All faces of a component are oriented like its first face.
  /// The last two corners of a face that has to be flipped are exchanged; is_flipped() reports such
  /// faces. O(n). Throws:
  /// - Error{BadIndex} if a corner is not the index of a point,
  /// - Error{DegenerateFace} if a face has a repeated corner,
  /// - Error{BadShape} with up to ten places if the triangles are not an orientable manifold,
  /// - Error{ResourceLimit} if there are more faces or points than ids.
  SurfaceMesh(std::vector<Point3> points, std::vector<SurfaceTriangle> triangles);

  std::size_t vertex_count() const { return points_.size(); }  ///< Returns the number of points.
  std::size_t face_count() const { return corners_.size(); }   ///< Returns the number of triangles.
  /// Returns the number of edges.
  std::size_t edge_count() const { return edge_halfedge_.size(); }
  /// Returns the number of components. Faces that share an edge are in one component.
  std::size_t component_count() const { return component_count_; }

  /// Returns the coordinates of the vertex.
  const Point3& point(VertexId v) const { return points_[v.value()]; }
  /// Returns the indices of the face's three vertices.
  const SurfaceTriangle& corners(FaceId f) const { return corners_[f.value()]; }
  /// Returns corner i of the face. Requires that i < 3.
  VertexId corner(FaceId f, std::size_t i) const { return VertexId(corners_[f.value()][i]); }
  /// Whether the face was flipped. The second corner of the input is then the third corner here,
  /// and has its weight.
  bool is_flipped(FaceId f) const { return is_flipped_[f.value()] != 0; }
  /// Returns the index of the face's component. Components are in the order of their lowest faces.
  std::uint32_t component(FaceId f) const { return component_[f.value()]; }

  /// Returns side 0, 1 or 2 of the face. It runs from the corner with the same index to the next
  /// corner.
  static HalfedgeId halfedge(FaceId f, std::size_t side) {
    return HalfedgeId(std::size_t{3} * f.value() + side);
  }
  /// Returns the face to the left of the half-edge.
  static FaceId face(HalfedgeId h) { return FaceId(h.value() / 3); }
  /// Returns which side of its face the half-edge is: 0, 1 or 2.
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
  HalfedgeId twin(HalfedgeId h) const { return twin_[h.value()]; }
  /// Whether the half-edge lies at the border: no face lies to its right.
  bool is_border(HalfedgeId h) const { return !twin(h).is_valid(); }
  /// Returns the edge of the half-edge.
  EdgeId edge(HalfedgeId h) const { return edge_[h.value()]; }
  /// Returns the half-edge of the edge that lies in the lower face.
  HalfedgeId halfedge(EdgeId e) const { return edge_halfedge_[e.value()]; }
  /// Whether the half-edge runs from the lower vertex of its edge to the higher one.
  bool is_upward(HalfedgeId h) const { return origin(h) < target(h); }
  VertexId lower(EdgeId e) const;  ///< Returns the end with the lower index.
  VertexId upper(EdgeId e) const;  ///< Returns the end with the higher index.
  /// Returns a half-edge that starts in v; invalid if v has no face. If v lies at the border, it is
  /// the first half-edge counter-clockwise around v: repeated steps from h to twin(prev(h)) visit
  /// all half-edges that start in v.
  HalfedgeId halfedge(VertexId v) const { return vertex_halfedge_[v.value()]; }

 private:
  void check_corners() const;
  void pair_halfedges();
  void orient_faces();
  void number_edges();
  void find_fans();

  std::vector<Point3> points_;
  std::vector<SurfaceTriangle> corners_;
  std::vector<std::uint8_t> is_flipped_;
  std::vector<std::uint32_t> component_;
  std::size_t component_count_ = 0;
  std::vector<HalfedgeId> twin_;
  std::vector<EdgeId> edge_;
  std::vector<HalfedgeId> edge_halfedge_;
  std::vector<HalfedgeId> vertex_halfedge_;
};

}  // namespace plumb
#pragma GCC visibility pop
