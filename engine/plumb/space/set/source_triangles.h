// The triangles of the sources of a set, with their planes in the tables of the set. Internal.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "plumb/base/context.h"
#include "plumb/space/complex/space_tables.h"
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

/// The triangles of all sources that have an area.
class SourceTriangles {
 public:
  /// Places the points of all sources and interns the planes of their triangles in `tables`. Throws
  /// what the context throws.
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
  /// Returns the place of corner i of a triangle.
  SpacePoint place(const SourceTriangle& t, std::size_t i) const {
    const std::uint32_t corner = t.corner[i];
    return places_[t.source]
                  [is_plane(t) ? corner : sources_[t.source].source->mesh.corners[corner]];
  }
  /// Whether a triangle stands for its whole plane.
  bool is_plane(const SourceTriangle& t) const {
    return sources_[t.source].source->plane.has_value();
  }

  /// Whether both triangles, which lie in one plane, have the same source, material, group and id,
  /// and channels that are the same affine functions.
  bool has_same_attributes(std::uint32_t s, std::uint32_t t) const;
  /// Whether both triangles have the same source, which has no channels, and the same material,
  /// group and id.
  bool has_same_constants(std::uint32_t s, std::uint32_t t) const;

 private:
  void intern_planes(std::uint32_t source, std::size_t first, SpaceTables& tables);
  void sort_by_plane(std::size_t planes);
  bool has_same_face_attributes(const SourceTriangle& s, const SourceTriangle& t) const;
  bool has_same_channels(const SourceTriangle& s, const SourceTriangle& t) const;

  std::span<const PlacedSource> sources_;
  const SpaceTables& tables_;
  std::vector<std::vector<SpacePoint>> places_;  // For each source, the places of its points.
  std::vector<SourceTriangle> triangles_;
  std::vector<std::uint32_t> begin_;     // For each plane, where its triangles start in by_plane_.
  std::vector<std::uint32_t> by_plane_;  // Triangles, sorted by planes.
};

/// Returns the barycentric weights of a point with respect to a triangle, seen along the axis
/// nearest to the normal of its plane. They add up to 1.
std::array<Rational, 3> barycentric_weights(const PlaneTable& planes, PlaneId plane,
                                            const std::array<RationalPoint3, 3>& triangle,
                                            const RationalPoint3& at);

/// Whether the map leaves all points where they are.
bool is_identity(const AffineMap3& map);

}  // namespace plumb
