// Exact points and polylines on a surface.
//
// A point is one of the following: a vertex; a point inside an edge, stored once for both faces; or
// a point inside a face, given by rational weights. A tracer returns polylines over such points, a
// division cuts along them, and the borders of a region are such polylines. Proofs:
// docs/design/surface.md.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "plumb/predicates/point_table2.h"
#include "plumb/surface/surface_mesh.h"

#pragma GCC visibility push(default)
namespace plumb {

using SurfacePointId = StrongId<struct SurfacePointTag>;  ///< A row of a SurfacePointTable.

/// The cell of least dimension that contains a point.
enum class SurfacePlace : std::uint32_t { Vertex, Edge, Face };

/// An append-only table of points of a mesh. Each point is stored on the cell of least dimension
/// that contains it. For example, the point t = 0 of an edge is stored as a vertex. Equal points
/// may be stored more than once.
///
/// In a face, (u, v) are the weights of its second and third corner, in the corner order of the
/// mesh (SurfaceMesh::is_flipped()). On an edge, t is the weight of the vertex with the higher
/// index. Doubles are read as exact numbers.
///
/// Functions that add a point return its row. They throw Error{BadIndex} if the vertex, edge or
/// face does not exist, and Error{BadArgument} if the point is not finite or lies outside the face
/// or edge.
class SurfacePointTable {
 public:
  /// Makes an empty table. The mesh must outlive the table.
  explicit SurfacePointTable(const SurfaceMesh& mesh) : mesh_(&mesh) {}

  SurfacePointId add_vertex(VertexId v);           ///< Appends a vertex of the mesh.
  SurfacePointId add_on_edge(EdgeId e, double t);  ///< Appends the point t of an edge.
  /// Appends the point t of an edge, given exactly.
  SurfacePointId add_on_edge(EdgeId e, const Rational& t);
  /// Appends the point (u, v) of a face. A point on a side or corner of the face is stored on that
  /// edge or vertex.
  SurfacePointId add_in_face(FaceId f, double u, double v);
  /// Appends the point (u, v) of a face, given exactly.
  SurfacePointId add_in_face(FaceId f, const Rational& u, const Rational& v);

  std::size_t size() const { return item_.size(); }  ///< Returns the number of rows.
  /// Returns the kind of cell on which the point is stored.
  SurfacePlace place(SurfacePointId p) const {
    return static_cast<SurfacePlace>(item_[p.value()] >> 30U);
  }
  /// Returns the vertex of the point. Requires that place(p) is Vertex.
  VertexId vertex(SurfacePointId p) const { return VertexId(index(p)); }
  /// Returns the edge that contains the point. Requires that place(p) is Edge.
  EdgeId edge(SurfacePointId p) const { return EdgeId(index(p)); }
  /// Returns the face that contains the point. Requires that place(p) is Face.
  FaceId face(SurfacePointId p) const { return FaceId(index(p)); }

  /// Returns the parameters of all points: (0, 0) for a vertex, (t, 0) on an edge, (u, v) in a
  /// face. The approx() of this table returns the nearest doubles.
  const PointTable2& parameters() const { return parameters_; }
  /// Returns the point's row of parameters(), rounded to the nearest doubles.
  Point2 approx(SurfacePointId p) const { return parameters_.approx(p.value()); }
  /// Returns the point's row of parameters().
  RationalPoint2 exact(SurfacePointId p) const { return parameters_.exact(p.value()); }

  /// Whether p and q are the same point of the surface, exactly.
  bool is_same(SurfacePointId p, SurfacePointId q) const;
  /// Whether the point lies in the face or on its boundary.
  bool is_in(SurfacePointId p, FaceId f) const;
  /// Appends the (u, v) of the point in a face. Requires is_in(p, f); so do the next two functions.
  void append_local(SurfacePointId p, FaceId f, PointTable2& to) const;
  /// Returns the (u, v) of the point in a face, each within 2^-52 of the exact value.
  Point2 approx_in(SurfacePointId p, FaceId f) const;
  /// Returns the exact (u, v) of the point in a face.
  RationalPoint2 exact_in(SurfacePointId p, FaceId f) const;
  /// Returns the position of the point in space, rounded.
  Point3 position(SurfacePointId p) const;

  const SurfaceMesh& mesh() const { return *mesh_; }  ///< Returns the mesh of the points.

 private:
  std::uint32_t index(SurfacePointId p) const { return item_[p.value()] & 0x3fffffffU; }
  SurfacePointId add(SurfacePlace place, std::uint32_t index);
  SurfacePointId add_on_side(FaceId f, std::size_t side, const Rational& weight);
  /// Returns the side of the face on which a point of an edge lies; invalid if there is none.
  HalfedgeId side_in(SurfacePointId p, FaceId f) const;

  const SurfaceMesh* mesh_;
  // The SurfacePlace in the top two bits, the index of the cell below.
  std::vector<std::uint32_t> item_;
  PointTable2 parameters_;
};

// Polylines on a surface.

/// A traced polyline. Segment i runs straight from points[i] to points[i + 1] in faces[i], which
/// contains both. For a segment along an edge, it may be either of the two faces. A path of length
/// zero has one point and no face.
struct SurfacePath {
  std::vector<SurfacePointId> points;  ///< The points in order.
  std::vector<FaceId> faces;  ///< The face of each segment. There is one face fewer than points.
};

/// Closed polygons over one table of points, in flat arrays. Polygon p has the entries begin[p] to
/// begin[p + 1] - 1. Segment i of the polygon runs in face[i] from point[i] to the next point. The
/// last segment leads back to the first point. Consecutive points may be equal. The left side of a
/// polygon is the region that it runs around counter-clockwise.
struct SurfacePolygons {
  /// Makes an empty list of polygons. The mesh must outlive the list.
  explicit SurfacePolygons(const SurfaceMesh& mesh) : points(mesh) {}

  SurfacePointTable points;                ///< The table that all polygons share.
  std::vector<std::uint32_t> begin = {0};  ///< The first entry of each polygon; size() + 1 values.
  std::vector<SurfacePointId> point;       ///< The point at each entry.
  std::vector<FaceId> face;                ///< The face of the segment that starts at each entry.
  std::vector<std::uint8_t>
      is_control;  ///< 1 for given points, 0 where a traced path crosses an edge.

  std::size_t size() const { return begin.size() - 1; }  ///< Returns the number of polygons.
  /// Returns the entry after i in polygon p, cyclically.
  std::uint32_t next(std::size_t p, std::uint32_t i) const {
    return i + 1 == begin[p + 1] ? begin[p] : i + 1;
  }
  /// Returns the points of polygon p in order.
  std::span<const SurfacePointId> points_of(std::size_t p) const {
    return std::span(point).subspan(begin[p], begin[p + 1] - begin[p]);
  }

  /// Appends to the polygon under construction a segment that starts at a point and runs in a face.
  void add_segment(SurfacePointId from, FaceId in, bool from_is_control);
  /// Appends all segments of a path between two control points to the polygon under construction.
  void add_leg(const SurfacePath& leg);
  /// Ends the polygon under construction. Its last segment leads back to its first point. A polygon
  /// may have no segments.
  void close();
};

/// Throws Error{BadArgument} unless both ends of every segment lie in the face of the segment. The
/// error has the indices of the polygon and the segment. O(n).
void require_valid(const SurfacePolygons& polygons);

}  // namespace plumb
#pragma GCC visibility pop
