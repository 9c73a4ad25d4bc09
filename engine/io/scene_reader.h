// Reads scenes: polygons on a mesh (docs/formats.md, "Scenes").
//
//   {"model": FILE, "points": [[face, u, v], ..], "polygons": [[point, ..], ..],
//    "shapes"?: [[polygon, ..], ..], "outside"?: face, "levels"?: [[shape, face, label], ..],
//    "svg"?: {"file": FILE, "center": [face, u, v], "scale": length, "angle"?: degrees, "tolerance"?: length}}
//
// Indices count from 0; u, v are the weights of the second and the third vertex of the face, as the model lists
// them, larger polygons cut into fans in order. FILE is sought beside the scene. A weight is a JSON number or
// a string with a fraction: "1/3". Members of other names mean nothing.
//
// Main flow of read_scene_file:
//  1. parse      the text, each index and weight with its place
//  2. model      by any reader of meshes (solid_io.h); triangles; SurfaceMesh
//  3. points     on a vertex, an edge or in a face, exactly (below)
//  4. trace      polygons from point to point (trace.h); straight in the face that both points name
//  5. draw       each "svg" (one, or a list): read once (svg_reader.h), its points put onto the surface by straight lines
//                from the centre (exponential_map.h), joined by traces; a shape for each of its elements, after
//                those of the scene
//
// Where a point lies is decided by the numbers as they are written, decimals too: [f, 0.3, 0.7] is on the edge,
// and the same as [g, 0.7, 0] across it, though no doubles add up to that. Then what a decimal gave is rounded to
// the nearest double, once, unless that would move the point off its edge, onto one, or out of its face. With a
// decimal among them u + v misses 1 by up to 2^-52 where 1 is meant: then it is. And nothing that lies outside by
// that much is refused.
//
// Cost: O(bytes), and the tracing. Errors, with their place: those of JSON and of the model; BadIndex; BadShape
// for a point outside its face, for control points that no path joins, and for
// points of drawings beyond the border; ResourceLimit; Cancelled.
#pragma once

#include <string>
#include <vector>

#include "plumb/base/context.h"
#include "plumb/io/read_options.h"
#include "plumb/space/polygon_mesh.h"
#include "plumb/surface/surface.h"

#pragma GCC visibility push(default)
namespace plumb {

/// A scene as it was read.
struct SceneFile {
  SurfaceScene scene;  ///< what SurfaceDivision takes
  std::string model;   ///< the path of its mesh
  std::vector<std::string>
      notes;  ///< of the readers of mesh and drawings, with their files, for people
};

/// Reads scene, mesh and drawings; "-" is standard input. Of `options` the name is not used. Throws as above.
SceneFile read_scene_file(const std::string& path, ReadOptions options, Context& context);

/// Polygons as fans of triangles, in order. Throws as SurfaceMesh does. O(n).
SurfaceMesh fanned_surface(const PolygonMesh& mesh);

}  // namespace plumb
#pragma GCC visibility pop
