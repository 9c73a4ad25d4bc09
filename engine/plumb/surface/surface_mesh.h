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

using NodeId = StrongId<struct SurfaceNodeTag>;    ///< A point where arcs and sides of faces end.
using ArcId = StrongId<struct SurfaceArcTag>;      ///< A piece of polygons between two nodes.
using PieceId = StrongId<struct SurfacePieceTag>;  ///< A part of one face between arcs.
/// A connected part of the surface: pieces and whole faces with no polygon between them.
using CellId = StrongId<struct SurfaceCellTag>;

/// An integer that belongs to a polygon or a shape. A list of these is a sparse vector: ids ascend
/// and no value is zero.
struct SignedEntry {
  std::uint32_t id;    ///< The number of the polygon or shape.
  std::int32_t value;  ///< The integer; not zero in a list.
  friend auto operator<=>(const SignedEntry&, const SignedEntry&) = default;
};

/// Returns a sum as the value of an entry. The negative of the result is representable, too. Throws
/// Error{NumberOutOfRange} if the absolute value is 2^31 or more.
inline std::int32_t entry_value(std::int64_t sum) {
  constexpr std::int64_t kMost = std::numeric_limits<std::int32_t>::max();
  if (sum > kMost || sum < -kMost) {
    throw Error(ErrorCode::NumberOutOfRange,
                "a polygon or shape winds around a cell 2^31 times or more");
  }
  return static_cast<std::int32_t>(sum);
}

// A triangle mesh as a surface: the triangle on the other side of each side.
//
// Half-edge 3 f + i runs from corner i of face f to corner i + 1, with the face to its left. Its
// twin lies in the face across; a half-edge at the border has none. Coordinates take no part, so
// triangles of area zero, meshes that intersect themselves and coincident vertices are allowed.
//
// Main flow of the constructor:
//  1. check     checks that ids exist and that each face has three different corners
//  2. pair      pairs the half-edges of each edge by counting sort; an edge has at most two
//  3. orient    flips faces, by a flood, until twins run against each other
//  4. fans      checks that the faces around each vertex are one fan or one closed ring
//
// Cost: O(n). Memory: 60 bytes for each face. Design: docs/design/surface.md.

using SurfaceTriangle = std::array<std::uint32_t, 3>;  ///< The indices of three points.

/// An oriented triangle mesh that is a 2-manifold, closed or with border, with any number of
/// components of any genus. Immutable.
class SurfaceMesh {
 public:
  /// Makes an empty mesh.
  SurfaceMesh() = default;
  /// Makes the mesh of the triangles. Faces of a component are oriented like its first face;
  /// is_flipped() says which faces were flipped, so that their last two corners are exchanged.
  /// Throws Error{BadIndex} for a corner that is no point, Error{DegenerateFace} for a face with a
  /// repeated corner, Error{BadShape} with up to ten places if the triangles are not an orientable
  /// manifold, and Error{ResourceLimit} if there are more faces or points than ids. O(n).
  SurfaceMesh(std::vector<Point3> points, std::vector<SurfaceTriangle> triangles);

  std::size_t vertex_count() const { return points_.size(); }  ///< Returns the number of points.
  std::size_t face_count() const { return corners_.size(); }   ///< Returns the number of triangles.
  /// Returns the number of edges.
  std::size_t edge_count() const { return edge_halfedge_.size(); }
  /// Returns the number of components, which are connected across edges.
  std::size_t component_count() const { return component_count_; }

  /// Returns the coordinates of the vertex.
  const Point3& point(VertexId v) const { return points_[v.value()]; }
  /// Returns the numbers of the face's three vertices.
  const SurfaceTriangle& corners(FaceId f) const { return corners_[f.value()]; }
  /// Returns corner i of the face. Requires that i < 3.
  VertexId corner(FaceId f, std::size_t i) const { return VertexId(corners_[f.value()][i]); }
  /// Whether the face was flipped. The weight of the given second corner is then that of the third.
  bool is_flipped(FaceId f) const { return is_flipped_[f.value()] != 0; }
  /// Returns the number of the face's component. Components are numbered by their lowest faces.
  std::uint32_t component(FaceId f) const { return component_[f.value()]; }

  /// Returns side 0, 1 or 2, which runs from the corner of that number to the next.
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
  /// Returns the half-edge in the face across; invalid at the border.
  HalfedgeId twin(HalfedgeId h) const { return twin_[h.value()]; }
  /// Whether no face lies on the other side.
  bool is_border(HalfedgeId h) const { return !twin(h).is_valid(); }
  /// Returns the edge of the half-edge.
  EdgeId edge(HalfedgeId h) const { return edge_[h.value()]; }
  /// Returns the half-edge of the edge that lies in the lower face.
  HalfedgeId halfedge(EdgeId e) const { return edge_halfedge_[e.value()]; }
  /// Whether the half-edge runs from the lower vertex of its edge to the higher.
  bool is_upward(HalfedgeId h) const { return origin(h) < target(h); }
  VertexId lower(EdgeId e) const;  ///< Returns the end with the lower number.
  VertexId upper(EdgeId e) const;  ///< Returns the end with the higher number.
  /// Returns a half-edge that starts in v; invalid if v has no face. At the border it is the one
  /// from which turning counter-clockwise, by twin(prev(h)), visits all half-edges that start in v.
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
