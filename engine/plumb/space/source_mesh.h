// The meshes that a set was made from, with their attributes. A set keeps them through all
// operations of space, so that mesh_with_attributes() (mesh_with_attributes.h) can tell, for each
// face of a result, the face of an input that it is a part of.
//
// Flow: with_source() of a set attaches a mesh to the set that was made from this mesh. Booleans
// join the lists of their operands, and transformed() applies its map to the places of the sources.
// The mesh itself is shared and never copied.
//
// Cost: an operation on sets takes O(number of sources) for the lists. Sets without sources pay for
// a null pointer. Errors: Error{BadArgument} for arrays that do not fit each other. Source:
// docs/attributes.md.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>

#include "plumb/base/context.h"
#include "plumb/space/mesh_arrays.h"
#include "plumb/space/mesh_attributes.h"
#include "plumb/space/nef3.h"

#pragma GCC visibility push(default)
namespace plumb {

/// A mesh that a set was made from. It is shared by sets, so it must not change.
struct MeshSource {
  std::string name;           ///< A name for the user, for instance that of a file. Can be empty.
  PolygonMesh mesh;           ///< The points and faces of the mesh.
  MeshAttributes attributes;  ///< What belongs to its faces and corners. Can be empty.
  /// If given, the source is the boundary of the half-space below this plane. The mesh is then
  /// empty, and the attributes have no channels and are those of one face.
  std::optional<Plane3> plane = {};
};

/// Returns the mesh that a view shows, for a source of arrays. O(n).
[[nodiscard]] PolygonMesh copied_mesh(const MeshView& mesh);

/// A source and its place.
struct PlacedSource {
  std::shared_ptr<const MeshSource> source;  ///< The mesh; not null.
  AffineMap3 map;                            ///< Maps the points of the mesh to the set.
};

/// Throws Error{BadArgument} unless each array of the attributes is empty or complete, each channel
/// has a width of 1 or more, all channels have different names, and each index of a material, a
/// group or a point is in range. For a plane, also throws if the normal is zero.
void require_consistent(const MeshSource& source);

/// Returns the set that a mesh bounds, with the mesh as its source. This is Nef3::from_mesh()
/// followed by Nef3::with_source(). If the source is a plane, returns the closed half-space below
/// it. Throws what they throw.
[[nodiscard]] Nef3 from_source(std::shared_ptr<const MeshSource> source,
                               const FromMeshOptions& options = {},
                               Context& context = unlimited_context());

}  // namespace plumb
#pragma GCC visibility pop
