// The triangles of the sources of a set, with their planes in the tables of the set. Internal.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "plumb/base/context.h"
#include "plumb/space/complex/space_tables.h"
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
};

/// The triangles of all sources that have an area. Points of a source get a place in the tables
/// when they are asked for, because most of them never are.
class SourceTriangles {
 public:
  /// Finds the planes of the triangles of all sources, and adds to `tables` those that it does not
  /// have. Throws what the context throws.
  SourceTriangles(std::span<const PlacedSource> sources, SpaceTables& tables, Context& context);

  /// Returns a triangle.
  const SourceTriangle& operator[](std::uint32_t t) const { return triangles_[t]; }
  /// Returns the triangles in a plane, in the order of their sources and faces.
  std::span<const std::uint32_t> in_plane(PlaneId plane) const {
    if (plane.value() + std::size_t{1} >= begin_.size()) return {};
    const std::uint32_t first = begin_[plane.value()];
    return std::span(by_plane_).subspan(first, begin_[plane.value() + std::size_t{1}] - first);
  }
  /// Returns the sources.
  std::span<const PlacedSource> sources() const { return sources_; }
  /// Returns the mesh of the source of a triangle.
  const PolygonMesh& mesh_of(const SourceTriangle& t) const {
    return sources_[t.source].source->mesh;
  }
  /// Returns the place of corner i of a triangle. Adds it to the tables if they do not have it.
  SpacePoint place(const SourceTriangle& t, std::size_t i) {
    return place(t.source, point_index(t, i));
  }
  /// Returns the coordinates of a point of the mesh of a source in the set if they are doubles that
  /// need no arithmetic, otherwise nullptr. The result is valid until the tables change.
  const Point3* doubles(std::uint32_t source, std::uint32_t point) const {
    const SpacePoint known = places_[source][point];
    if (!known.is_valid()) return &sources_[source].source->mesh.points[point];
    return known.is_input() ? &tables_.planes.point(known.input()) : nullptr;
  }
  /// Returns the same for corner i of a triangle.
  const Point3* doubles(const SourceTriangle& t, std::size_t i) const {
    return doubles(t.source, point_index(t, i));
  }
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
    known = SpacePoint(tables_.planes.add_point(sources_[source].source->mesh.points[point]));
    return known;
  }
  void add_triangles(std::uint32_t source, Context& context);
  void find_planes(std::uint32_t source, std::size_t first, const PlanesByCorners& known,
                   Context& context);
  void intern_planes(std::span<const std::uint32_t> triangles, Context& context);
  void set_plane(SourceTriangle& t, OrientedPlane plane) const;
  void sort_by_plane(std::size_t planes);
  bool has_same_face_attributes(const SourceTriangle& s, const SourceTriangle& t) const;
  bool has_same_channels(const SourceTriangle& s, const SourceTriangle& t);

  std::span<const PlacedSource> sources_;
  SpaceTables& tables_;
  // For each source, the places of its points. A place that is not valid is the point itself.
  std::vector<std::vector<SpacePoint>> places_;
  std::vector<std::uint8_t> is_mirrored_;  // For each source, whether its map mirrors.
  std::vector<SourceTriangle> triangles_;
  std::vector<std::uint32_t> begin_;     // For each plane, where its triangles start in by_plane_.
  std::vector<std::uint32_t> by_plane_;  // Triangles, sorted by planes.
};

/// Whether the map leaves all points where they are.
bool is_identity(const AffineMap3& map);

}  // namespace plumb
