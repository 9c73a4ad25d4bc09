// Exact points and polylines on a surface.
//
// There are three kinds of points. A point can be a vertex. A point inside an edge is stored once
// for both faces of the edge. A point inside a face is given by rational weights. A tracer returns
// polylines through such points. A SurfaceDivision cuts the surface along such polylines. The
// borders of a region are such polylines, too. Proofs: docs/design/surface.md.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "plumb/predicates/point_table2.h"
#include "plumb/surface/surface_mesh.h"

#pragma GCC visibility push(default)
namespace plumb {

using SurfacePointId = StrongId<struct SurfacePointTag>;  ///< A row of a SurfacePointTable.

/// The kind of the cell of least dimension that contains a point.
enum class SurfacePlace : std::uint32_t { Vertex, Edge, Face };

/// An append-only table of points of a mesh. Each point is stored on the cell of least dimension
/// that contains it. For example, the point t = 0 of an edge is stored as a vertex. Equal points
/// may be stored more than once.
///
/// A point in a face has the parameters (u, v). Here u is the weight of the second corner of the
/// face, and v is the weight of its third corner. The corners are in the order of the mesh
/// (SurfaceMesh::is_flipped()). A point on an edge has the parameter t, which is the weight of the
/// end with the higher vertex index. Doubles are read as exact numbers.
///
/// Functions that add a point return the row of the point. They throw Error{BadIndex} if the
/// vertex, edge or face does not exist, and Error{BadArgument} if the point is not finite or lies
/// outside the face or edge.
class SurfacePointTable {
 public:
  /// Makes an empty table. The mesh must outlive the table.
  explicit SurfacePointTable(const SurfaceMesh& mesh) : mesh_(&mesh) {}

  SurfacePointId add_vertex(VertexId v);           ///< Appends a vertex of the mesh.
  SurfacePointId add_on_edge(EdgeId e, double t);  ///< Appends the point t on an edge.
  /// Appends the point t of an edge. Here t is an exact number.
  SurfacePointId add_on_edge(EdgeId e, const Rational& t);
  /// Appends the point with the parameters (u, v) in a face. A point on a side of the face is
  /// stored on the edge of this side. A point at a corner is stored on the vertex of this corner.
  SurfacePointId add_in_face(FaceId f, double u, double v);
  /// Appends the point with the exact parameters (u, v) in a face.
  SurfacePointId add_in_face(FaceId f, const Rational& u, const Rational& v);

  std::size_t size() const { return item_.size(); }  ///< Returns the number of rows.
  /// Returns the kind of the cell on which the point is stored.
  SurfacePlace place(SurfacePointId p) const { return static_cast<SurfacePlace>(item_[p] >> 30U); }
  /// Returns the vertex on which the point is stored. Requires that place(p) is Vertex.
  VertexId vertex(SurfacePointId p) const { return VertexId(index(p)); }
  /// Returns the edge that contains the point. Requires that place(p) is Edge.
  EdgeId edge(SurfacePointId p) const { return EdgeId(index(p)); }
  /// Returns the face that contains the point. Requires that place(p) is Face.
  FaceId face(SurfacePointId p) const { return FaceId(index(p)); }

  /// Returns the parameters of all points. They are (0, 0) for a vertex, (t, 0) for a point on an
  /// edge, and (u, v) for a point in a face. PointTable2::approx() of the returned table gives the
  /// nearest doubles.
  const PointTable2& parameters() const { return parameters_; }
  /// Returns the entry of parameters() for the point, rounded to the nearest doubles.
  Point2 approx(SurfacePointId p) const { return parameters_.approx(p.value()); }
  /// Returns the exact entry of parameters() for the point.
  RationalPoint2 exact(SurfacePointId p) const { return parameters_.exact(p.value()); }

  /// Whether p and q are the same point of the surface. The test is exact.
  bool is_same(SurfacePointId p, SurfacePointId q) const;
  /// Whether the point lies in the face or on its boundary.
  bool is_in(SurfacePointId p, FaceId f) const;
  /// Appends to the table `to` the parameters (u, v) that the point has in the face f. This
  /// function and the next two functions require is_in(p, f).
  void append_local(SurfacePointId p, FaceId f, PointTable2& to) const;
  /// Returns the parameters (u, v) that the point has in the face f. Both parameters have an error
  /// of at most 2^-52.
  Point2 approx_in(SurfacePointId p, FaceId f) const;
  /// Returns the exact parameters (u, v) that the point has in the face f.
  RationalPoint2 exact_in(SurfacePointId p, FaceId f) const;
  /// Returns the position of the point in space, rounded.
  Point3 position(SurfacePointId p) const;

  const SurfaceMesh& mesh() const { return *mesh_; }  ///< Returns the mesh of the points.

 private:
  std::uint32_t index(SurfacePointId p) const { return item_[p] & 0x3fffffffU; }
  SurfacePointId add(SurfacePlace place, std::uint32_t index);
  SurfacePointId add_on_side(FaceId f, std::size_t side, const Rational& weight);
  /// Returns the side of the face that contains a point, or an invalid id if no side contains it.
  /// Requires that the point lies on an edge.
  HalfedgeId side_in(SurfacePointId p, FaceId f) const;

  const SurfaceMesh* mesh_;
  // The top two bits contain the SurfacePlace. The other bits contain the index of the cell.
  IdVector<SurfacePointId, std::uint32_t> item_;
  PointTable2 parameters_;
};

// Polylines on a surface.

/// A traced polyline. Segment i runs straight from points[i] to points[i + 1] in faces[i]. This
/// face contains both points. If the segment runs along an edge, faces[i] may be either of the two
/// faces at the edge. A path of length zero has one point and no face.
struct SurfacePath {
  std::vector<SurfacePointId> points;  ///< The points in order.
  std::vector<FaceId> faces;  ///< The face of each segment. There is one face fewer than points.
};

/// The kind of the point at which a segment of a polygon starts. The caller gave the control
/// points. A path point is a point where a traced path crosses an edge.
enum class SegmentStart : std::uint8_t { ControlPoint, PathPoint };

/// Closed polygons over one table of points, in flat arrays. Polygon p has the entries begin[p] to
/// begin[p + 1] - 1. Segment i of the polygon runs in face[i] from point[i] to the next point. The
/// last segment ends at the first point. Consecutive points may be equal. If a polygon runs around
/// a region counter-clockwise, this region is to its left.
struct SurfacePolygons {
  /// Makes an empty list of polygons. The mesh must outlive the list.
  explicit SurfacePolygons(const SurfaceMesh& mesh) : points(mesh) {}

  SurfacePointTable points;                ///< The table that all polygons share.
  std::vector<std::uint32_t> begin = {0};  ///< The first entry of each polygon; size() + 1 values.
  std::vector<SurfacePointId> point;       ///< The point at each entry.
  std::vector<FaceId> face;                ///< The face of the segment that starts at each entry.
  /// For each entry, 1 if its point is a control point, and 0 if it is a path point. The caller
  /// gave the control points. A path point is a point where a traced path crosses an edge.
  std::vector<std::uint8_t> is_control;

  std::size_t size() const { return begin.size() - 1; }  ///< Returns the number of polygons.
  /// Returns the entry that follows entry i in polygon p. The first entry follows the last entry.
  std::uint32_t next(std::size_t p, std::uint32_t i) const {
    return i + 1 == begin[p + 1] ? begin[p] : i + 1;
  }
  /// Returns the points of polygon p in order.
  std::span<const SurfacePointId> points_of(std::size_t p) const {
    return std::span(point).subspan(begin[p], begin[p + 1] - begin[p]);
  }

  /// Appends a segment to the polygon under construction. The segment starts at `from`, which is a
  /// point of the kind `start`, and runs in the face `in`.
  void add_segment(SurfacePointId from, FaceId in, SegmentStart start);
  /// Appends all segments of a path between two control points to the polygon under construction.
  void add_leg(const SurfacePath& leg);
  /// Ends the polygon under construction. The last segment of the polygon ends at its first point.
  /// A polygon may have no segments.
  void close();
};

/// Throws Error{BadArgument} unless both ends of every segment lie in the face of the segment. The
/// error contains the indices of the polygon and of the segment. Cost: O(n) for n segments.
void require_valid(const SurfacePolygons& polygons);

}  // namespace plumb
#pragma GCC visibility pop
