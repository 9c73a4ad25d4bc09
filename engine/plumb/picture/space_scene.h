// Makes scenes of sets of space. A set is stored as the complex that has no superfluous cells, its
// minimal complex (nef3.h). A scene shows the facets and edges of this complex. A vertex is shown
// as a dot only if the edges at the vertex do not show whether it belongs to the set.
// exploded_scene() shows several sets in one scene and moves the sets apart. coloured_scene() shows
// a set in the colours of the meshes from which it was made.
//
// Main flow of scene_of(set):
//  1. window  makes the window, a box (SpaceWindow). The box contains all vertices. The box also
//             contains at least one point of each facet without vertices, and at least one point of
//             each line without vertices.
//  2. cut     intersects an unbounded set with the interior of the box, exactly
//  3. draw    adds points, facets (as triangles between vertices), edges and dots. Facets on the
//             border of the box get Paint::Cut. Edges and points on this border are left out.
#pragma once

#include <span>

#include "plumb/base/context.h"
#include "plumb/picture/scene.h"
#include "plumb/picture/texture_image.h"
#include "plumb/space/nef3.h"

#pragma GCC visibility push(default)
namespace plumb {

/// Returns the scene of a set. Cost: O(n log n) for n cells.
Scene scene_of(const Nef3& set, Context& context = unlimited_context());

/// Whether a set has a source with colours: a material with a colour, or a channel "color".
bool has_colours(const Nef3& set);

/// Whether a source of the set has texture coordinates, and a material with a texture.
bool has_textures(const Nef3& set);

/// Returns the scene of a set in the colours of its sources (mesh_with_attributes.h). The facets
/// beside marked volumes are divided into triangles. A triangle has the colour of its material,
/// multiplied by the mean of the channel "color" at its corners. So that the scene has few colours,
/// the red, green and blue of this mean are rounded to one of 16 values each. All triangles with
/// the same colour form a group. If the set is unbounded or has no colours, the function returns
/// scene_of(set). If a material has a texture, the source has texture coordinates
/// ("texcoord_0"), and `load_texture` returns the image, then the triangles show this image. The
/// function is called once for each texture of a source. Cost: the cost of mesh_with_attributes().
Scene coloured_scene(const Nef3& set, Context& context = unlimited_context(),
                     const TextureLoader& load_texture = {});

/// Returns a scene of several sets in one layer. Each set is a group with its own colour. Each set
/// is moved away from the middle of all sets. The distance of this move is `apart` times the
/// distance between the middle of the set and the middle of all sets. If `apart` is 0, the sets are
/// not moved. Throws Error{BadArgument} if a set is unbounded, if `apart` is negative or not
/// finite, or if a point would be moved beyond the largest double. Cost: O(n log n) for n cells of
/// all sets.
Scene exploded_scene(std::span<const Nef3> sets, double apart,
                     Context& context = unlimited_context());

}  // namespace plumb
#pragma GCC visibility pop
