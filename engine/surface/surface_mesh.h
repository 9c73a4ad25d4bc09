// A triangle mesh as a surface: which triangle lies across each side.
//
// Half-edge 3 f + i runs from corner i of face f to corner i + 1, with the face to its left. Its twin lies in
// the face across; at the border it has none. Nothing here looks at coordinates, so triangles of area zero,
// meshes that cross themselves and vertices in one place are ordinary.
//
// Main flow of the constructor:
//  1. check     ids, three different corners a face
//  2. pair      half-edges of one edge by counting sort: at most two
//  3. orient    a flood turns faces around until twins run against each other
//  4. fans      the faces around each vertex are one fan or one closed ring
//
// Cost: O(n). Memory: 60 bytes a face. Errors: Error{BadIndex}, Error{DegenerateFace}; Error{BadShape} for
// what is no orientable manifold, with places.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "plumb/base/ids.h"
#include "plumb/predicates/point.h"

#pragma GCC visibility push(default)
namespace plumb {

using SurfaceTriangle = std::array<std::uint32_t, 3>;  ///< indices of three points

/// Closed or with border, of any number of components and any genus. Immutable.
class SurfaceMesh {
 public:
  SurfaceMesh() = default;
  /// Faces of a component are turned to agree with its first; is_flipped() tells which. Their last two corners
  /// are then exchanged.
  SurfaceMesh(std::vector<Point3> points, std::vector<SurfaceTriangle> triangles);

  std::size_t vertex_count() const { return points_.size(); }       ///< Points given.
  std::size_t face_count() const { return corners_.size(); }        ///< Triangles given.
  std::size_t edge_count() const { return edge_halfedge_.size(); }  ///< Sides, each once.
  std::size_t component_count() const { return component_count_; }  ///< Parts connected by edges.

  const Point3& point(VertexId v) const { return points_[v.value()]; }  ///< Its coordinates.
  /// Its three vertices, by number.
  const SurfaceTriangle& corners(FaceId f) const { return corners_[f.value()]; }
  /// Its corner 0, 1 or 2.
  VertexId corner(FaceId f, std::size_t i) const { return VertexId(corners_[f.value()][i]); }
  /// Was it turned around? Then what was weight of its second corner is that of its third.
  bool is_flipped(FaceId f) const { return is_flipped_[f.value()] != 0; }
  /// Components are numbered by their least face.
  std::uint32_t component(FaceId f) const { return component_[f.value()]; }

  /// Side 0, 1 or 2, from the corner of that number to the next.
  static HalfedgeId halfedge(FaceId f, std::size_t side) {
    return HalfedgeId(std::size_t{3} * f.value() + side);
  }
  static FaceId face(HalfedgeId h) { return FaceId(h.value() / 3); }  ///< The face to its left.
  static std::size_t side(HalfedgeId h) {
    return h.value() % 3;
  }  ///< Which side of its face it is.
  /// The side after it.
  static HalfedgeId next(HalfedgeId h) {
    return HalfedgeId(h.value() % 3 == 2 ? h.value() - 2 : h.value() + 1);
  }
  static HalfedgeId prev(HalfedgeId h) { return next(next(h)); }            ///< The side before it.
  VertexId origin(HalfedgeId h) const { return corner(face(h), side(h)); }  ///< Where it begins.
  VertexId target(HalfedgeId h) const { return origin(next(h)); }           ///< Where it ends.
  /// Invalid at the border.
  HalfedgeId twin(HalfedgeId h) const { return twin_[h.value()]; }
  /// Has it no face on its other side?
  bool is_border(HalfedgeId h) const { return !twin(h).is_valid(); }
  /// The edge that it is a direction of.
  EdgeId edge(HalfedgeId h) const { return edge_[h.value()]; }
  /// Of the two, the one in the lower face.
  HalfedgeId halfedge(EdgeId e) const { return edge_halfedge_[e.value()]; }
  /// Does it run from the lower vertex of its edge to the higher?
  bool is_upward(HalfedgeId h) const { return origin(h) < target(h); }
  VertexId lower(EdgeId e) const;  ///< The end with the lower number.
  VertexId upper(EdgeId e) const;  ///< The end with the higher number.
  /// A half-edge that starts in v; at the border the one from which turning counter-clockwise
  /// (twin(prev(h))) visits all. Invalid where no face is.
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
