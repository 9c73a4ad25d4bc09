// The triangles of the sources of a set, with their planes in the tables of the set. Internal.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "plumb/base/context.h"
#include "plumb/space/set/growing_complex.h"
#include "plumb/space/set/moved_planes.h"
#include "plumb/space/set/planes_by_corners.h"
#include "plumb/space/source_mesh.h"

namespace plumb {

/// A triangle of a source, or of a face of a source that is a polygon.
struct SourceTriangle {
  std::uint32_t source;  ///< The index of its source.
  std::uint32_t face;    ///< The face of the source; 0 for a plane.
  /// Its corners as indices of mesh.corners of the source. For a plane, indices of three of its
  /// points.
  std::array<std::uint32_t, 3> corner;
  PlaneId plane;  ///< Its plane.
  /// Whether the set that the source bounds is on the positive side of the plane.
  bool is_opposite;
  /// The input points of the tables at the corners. Valid if they define the plane.
  std::array<InputPointId, 3> input = {};
};

/// Consecutive triangles of SourceTriangles, as their indices there.
struct TriangleRange {
  std::uint32_t first = 0;  ///< The first triangle.
  std::uint32_t end = 0;    ///< One after the last triangle.

  /// Returns whether there is no triangle.
  bool is_empty() const { return first == end; }
  /// Returns the number of triangles.
  std::uint32_t size() const { return end - first; }
  /// Returns the triangle with index i of the range.
  std::uint32_t operator[](std::uint32_t i) const { return first + i; }
};

/// The corners of a triangle that are doubles; null for others.
using CornerPoints = std::array<const Point3*, 3>;

/// Returns the index of the corner with these coordinates, or 3.
std::size_t corner_index(const CornerPoints& corners, const Point3& p);

/// The triangles of all sources in planes of facets, sorted by their planes, then by their sources
/// and faces. Planes have ids in the order in which sets were made, so what belongs to neighbouring
/// facets is close in memory. Points of a source get a place in the tables when they are asked for,
/// because most of them never are.
class SourceTriangles {
 public:
  /// Finds the planes of the triangles of all sources. Planes that the tables of `complex` do not
  /// have are added to them. A moved triangle gets a plane only if a facet of `complex` lies in its
  /// plane. Keeps a reference to `complex`. Throws the errors of the Context.
  SourceTriangles(std::span<const PlacedSource> sources, GrowingComplex& complex, Context& context);

  /// Returns a triangle.
  const SourceTriangle& operator[](std::uint32_t t) const { return triangles_[t]; }
  /// Returns the triangles in a plane, in the order of their sources and faces. If no facet lies in
  /// the plane, the range is empty.
  TriangleRange in_plane(PlaneId plane) const {
    if (plane.value() + std::size_t{1} >= begin_.size()) return {};
    return {begin_[plane.value()], begin_[plane.value() + std::size_t{1}]};
  }
  /// Returns the sources.
  std::span<const PlacedSource> sources() const { return sources_; }
  /// Returns the mesh of the source of a triangle.
  const PolygonMesh& mesh_of(const SourceTriangle& t) const {
    return sources_[t.source].source->mesh;
  }
  /// Returns the place of corner i of a triangle. Adds it to the tables if they do not have it.
  SpacePoint place(const SourceTriangle& t, std::size_t i) {
    if (t.input[i].is_valid()) return SpacePoint(t.input[i]);
    return place(t.source, point_index(t, i));
  }
  /// Returns the coordinates of a point of the mesh of a source in the set if they are doubles that
  /// need no arithmetic, otherwise nullptr. The result is valid until the tables change.
  const Point3* doubles(std::uint32_t source, std::uint32_t point) {
    const SpacePoint known = moves_[source] ? place(source, point) : places_[source][point];
    if (!known.is_valid()) return &sources_[source].source->mesh.points[point];
    return known.is_input() ? &planes().point(known.input()) : nullptr;
  }
  /// Returns the same for corner i of a triangle.
  const Point3* doubles(const SourceTriangle& t, std::size_t i) {
    if (t.input[i].is_valid()) return &planes().point(t.input[i]);
    return doubles(t.source, point_index(t, i));
  }
  /// Places the corners of a moved triangle, so that doubles() does not change the tables.
  void place_if_moved(const SourceTriangle& t) {
    if (!moves_[t.source]) return;
    for (std::size_t i = 0; i < 3; ++i) place(t, i);
  }
  /// Whether a constructed point has the same definition as corner i of a triangle. Requires that
  /// the triangle was not moved or that place_if_moved() was called. A result of false does not
  /// mean that the points are different.
  bool has_definition_of(const SourceTriangle& t, std::size_t i, SpacePoint p) const;
  /// Returns doubles() of the three corners of a triangle.
  CornerPoints corner_points(const SourceTriangle& t) {
    return {doubles(t, 0), doubles(t, 1), doubles(t, 2)};
  }
  /// Returns i if the definition of a constructed point in the plane of a triangle says that it
  /// lies on the line of the corners i and i + 1, otherwise 3. In general position, most points at
  /// which a triangle is cut are of this kind. `corners` has the corner_points() of the triangle.
  std::size_t edge_of(const SourceTriangle& t, const CornerPoints& corners, SpacePoint p) const;
  /// Whether a triangle stands for its whole plane.
  bool is_plane(const SourceTriangle& t) const {
    return sources_[t.source].source->plane.has_value();
  }

  /// Whether both triangles, which lie in one plane, have the same source, material, group and id,
  /// and channels that are the same affine functions.
  bool has_same_attributes(std::uint32_t s, std::uint32_t t);
  /// Whether both triangles have the same source, which has no channels, and the same material,
  /// group and id.
  bool has_same_constants(std::uint32_t s, std::uint32_t t) const;

 private:
  /// Returns the point of the mesh at corner i of a triangle; for a plane, one of its three points.
  std::uint32_t point_index(const SourceTriangle& t, std::size_t i) const {
    return is_plane(t) ? t.corner[i] : mesh_of(t).corners[t.corner[i]];
  }
  SpacePoint place(std::uint32_t source, std::uint32_t point) {
    SpacePoint& known = places_[source][point];
    if (known.is_valid()) return known;
    const Point3& at = sources_[source].source->mesh.points[point];
    known = moves_[source] ? image_of(*moves_[source], at)
                           : SpacePoint(complex_.changed_tables().planes.add_point(at));
    return known;
  }
  const PlaneTable& planes() const { return complex_.tables().planes; }
  SpacePoint image_of(const MovedPlanes::Map& map, const Point3& point);
  void add_exact_points(std::uint32_t source, Context& context);
  void find_moved_planes(std::uint32_t source, std::size_t first, std::size_t end,
                         const MovedPlanes& wanted, Context& context);
  void add_triangles(std::uint32_t source, Context& context);
  std::vector<std::uint8_t> find_planes_of_facets(std::span<const std::size_t> first_of_source,
                                                  Context& context);
  bool take_plane_of_corners(SourceTriangle& t, PlaneId plane) const;
  void find_planes(std::uint32_t source, std::span<const std::uint32_t> triangles,
                   const PlanesByCorners& known, Context& context);
  void intern_planes(std::span<const std::uint32_t> triangles, Context& context);
  void set_plane(SourceTriangle& t, OrientedPlane plane) const;
  void sort_by_plane(std::size_t planes);
  std::size_t edge_of_neighbour(const SourceTriangle& t, SpacePoint p) const;
  bool has_same_face_attributes(const SourceTriangle& s, const SourceTriangle& t) const;
  bool has_same_channels(const SourceTriangle& s, const SourceTriangle& t);

  std::span<const PlacedSource> sources_;
  GrowingComplex& complex_;
  // For each source, the places of its points. If a place is not valid, it is the point itself, or
  // the image of the point if the source was moved.
  std::vector<std::vector<SpacePoint>> places_;
  // For each source, whether its map mirrors.
  std::vector<std::uint8_t> is_mirrored_;
  // For each source, its map if it moves a mesh.
  std::vector<std::optional<MovedPlanes::Map>> moves_;
  std::vector<SourceTriangle> triangles_;
  std::vector<std::uint32_t> begin_;  // For each plane, its first triangle.
};

/// Whether the map leaves all points where they are.
bool is_identity(const AffineMap3& map);

}  // namespace plumb
