// The sources of a set: the meshes from which the set was made, with their attributes. The result
// of an operation on sets of space has the sources of its operands. From these sources,
// mesh_with_attributes() (mesh_with_attributes.h) finds for each face of a result the face of a
// source that contains it.
//
// Flow: Nef3::with_source() adds a source to a set that was made from a mesh. Booleans join the
// lists of sources of their operands. Nef3::transformed() changes the maps of the sources
// (PlacedSource::map). All sets that have a source share its mesh, which is never copied.
//
// Cost: an operation on sets takes O(number of sources) to make the list of the result. A set
// without sources only has an additional null pointer. Errors: Error{BadArgument} if the sizes of
// arrays are not consistent. Source: docs/attributes.md.
#pragma once

#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "plumb/base/context.h"
#include "plumb/space/mesh_arrays.h"
#include "plumb/space/mesh_attributes.h"
#include "plumb/space/nef3.h"

#pragma GCC visibility push(default)
namespace plumb {

struct FaceTriangle;

/// What mesh_with_attributes() computes once for a source and keeps for the next set with the same
/// source: the triangles of its polygons. A copy of a source keeps nothing. Several threads can use
/// it at once.
class SourceTrianglesCache {
 public:
  /// The triangles, or null.
  using Triangles = std::shared_ptr<const std::vector<FaceTriangle>>;

  SourceTrianglesCache() = default;
  /// Makes a cache without triangles.
  SourceTrianglesCache(const SourceTrianglesCache& /*other*/) noexcept {}
  /// Forgets the triangles of this cache.
  SourceTrianglesCache& operator=(const SourceTrianglesCache& /*other*/) {
    set(nullptr);
    return *this;
  }
  ~SourceTrianglesCache() = default;

  /// Returns what set() was given last, or null.
  Triangles get() const {
    const std::lock_guard lock(mutex_);
    return triangles_;
  }
  /// Keeps triangles in place of those that were kept before.
  void set(Triangles triangles) {
    const std::lock_guard lock(mutex_);
    triangles_ = std::move(triangles);
  }

 private:
  mutable std::mutex mutex_;
  Triangles triangles_;
};

/// A source: a mesh from which a set was made. Several sets can share it, so it must not change.
struct MeshSource {
  std::string name;           ///< A name for the user, such as the name of a file. Can be empty.
  PolygonMesh mesh;           ///< The points and faces of the mesh.
  MeshAttributes attributes;  ///< The attributes of faces and corners. Can be empty.
  /// If this has a value, the source is not a mesh but the boundary of the half-space below this
  /// plane. In this case the mesh is empty. The attributes describe a single face, and there are no
  /// channels.
  std::optional<Plane3> plane = {};
  mutable SourceTrianglesCache triangles = {};  ///< Used by plumb alone.
};

/// Returns a copy of the mesh that a view describes. It is used to make a source from arrays. Cost:
/// O(n) for n corners.
[[nodiscard]] PolygonMesh copied_mesh(const MeshView& mesh);

/// A source, and the map that was applied to it.
struct PlacedSource {
  std::shared_ptr<const MeshSource> source;  ///< The mesh; not null.
  /// The map from points of the mesh to points of the set.
  AffineMap3 map;
};

/// Checks a source. Throws Error{BadArgument} unless all of these conditions hold:
///   - Each array of the attributes is empty or complete (mesh_attributes.h).
///   - Each channel has a width of 1 or more, and all channels have different names.
///   - Each index of a material, a group or a point is in range.
///   - If the source is a plane, its normal is not zero.
void require_consistent(const MeshSource& source);

/// Returns the set that the mesh of a source bounds, and adds this source to the set. If the source
/// is a plane, the set is the closed half-space below the plane. The function calls
/// Nef3::from_mesh() or Nef3::half_space(), and then Nef3::with_source(). Throws what these
/// functions throw.
[[nodiscard]] Nef3 from_source(std::shared_ptr<const MeshSource> source,
                               const FromMeshOptions& options = {},
                               Context& context = unlimited_context());

}  // namespace plumb
#pragma GCC visibility pop
