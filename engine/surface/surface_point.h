// Points of a surface, exact: a vertex; a point inside an edge, stored once for both faces; a point inside a face.
#pragma once

#include <cstdint>
#include <vector>

#include "plumb/predicates/point_table2.h"
#include "plumb/surface/surface_mesh.h"

#pragma GCC visibility push(default)
namespace plumb {

using SurfacePointId = StrongId<struct SurfacePointTag>;  ///< a row of a table

/// What a point lies on: the least item that holds it.
enum class SurfacePlace : std::uint32_t { Vertex, Edge, Face };

/// Append-only. Points are stored as what they are: adding a point of an edge whose t is 0 adds a vertex. Equal
/// points may be stored more than once.
///
/// In a face, (u, v) are the weights of its second and third corner as the mesh orders them
/// (SurfaceMesh::is_flipped); on an edge, t is the weight of the vertex with the higher index. Doubles mean
/// themselves. Errors of adding: Error{BadIndex}; Error{BadArgument} outside the face or edge, or not finite.
class SurfacePointTable {
 public:
  /// The mesh has to outlive the table.
  explicit SurfacePointTable(const SurfaceMesh& mesh) : mesh_(&mesh) {}

  SurfacePointId add_vertex(VertexId v);                    ///< A vertex of the mesh.
  SurfacePointId add_on_edge(EdgeId e, double t);           ///< A point of an edge, by t.
  SurfacePointId add_on_edge(EdgeId e, const Rational& t);  ///< The same, exactly.
  /// A point of a face, by (u, v); on a side or corner it becomes that.
  SurfacePointId add_in_face(FaceId f, double u, double v);
  /// The same, exactly.
  SurfacePointId add_in_face(FaceId f, const Rational& u, const Rational& v);

  std::size_t size() const { return item_.size(); }  ///< Rows.
  /// What it lies on.
  SurfacePlace place(SurfacePointId p) const {
    return static_cast<SurfacePlace>(item_[p.value()] >> 30U);
  }
  VertexId vertex(SurfacePointId p) const { return VertexId(index(p)); }  ///< Requires that place.
  EdgeId edge(SurfacePointId p) const { return EdgeId(index(p)); }        ///< Requires that place.
  FaceId face(SurfacePointId p) const { return FaceId(index(p)); }        ///< Requires that place.

  /// (t, 0) or (u, v); (0, 0) of a vertex. approx(): the nearest doubles.
  const PointTable2& parameters() const { return parameters_; }
  /// Its row of parameters(), rounded.
  Point2 approx(SurfacePointId p) const { return parameters_.approx(p.value()); }
  /// Its row of parameters().
  RationalPoint2 exact(SurfacePointId p) const { return parameters_.exact(p.value()); }

  /// The same point of the surface?
  bool is_same(SurfacePointId p, SurfacePointId q) const;
  /// Does it lie in the face or on its boundary?
  bool is_in(SurfacePointId p, FaceId f) const;
  /// Appends its (u, v) in a face it lies in.
  void append_local(SurfacePointId p, FaceId f, PointTable2& to) const;
  /// The same, rounded: each within 2^-52.
  Point2 approx_in(SurfacePointId p, FaceId f) const;
  /// Its (u, v) in a face it lies in, exactly.
  RationalPoint2 exact_in(SurfacePointId p, FaceId f) const;
  /// In space, rounded.
  Point3 position(SurfacePointId p) const;

  const SurfaceMesh& mesh() const { return *mesh_; }  ///< What the points lie on.

 private:
  std::uint32_t index(SurfacePointId p) const { return item_[p.value()] & 0x3fffffffU; }
  SurfacePointId add(SurfacePlace place, std::uint32_t index);
  SurfacePointId add_on_side(FaceId f, std::size_t side, const Rational& weight);
  /// Of a point on an edge: the side of the face that is the edge; invalid if none is.
  HalfedgeId side_in(SurfacePointId p, FaceId f) const;

  const SurfaceMesh* mesh_;
  std::vector<std::uint32_t> item_;  // place in the top two bits
  PointTable2 parameters_;
};

}  // namespace plumb
#pragma GCC visibility pop
