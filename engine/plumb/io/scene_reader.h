// Reads scenes. A scene consists of polygons on a mesh (docs/formats.md, "Scenes"). Its file is a
// JSON object of this form, in which "?" marks optional members:
//
//   {"model": FILE, "points": [[face, u, v], ..], "polygons": [[point, ..], ..],
//    "shapes"?: [[polygon, ..], ..], "outside"?: face, "levels"?: [[shape, face, label], ..],
//    "svg"?: {"file": FILE, "center": [face, u, v], "scale": length, "angle"?: degrees,
//    "tolerance"?: length}}
//
// Indices are 0-based. Faces are triangles, numbered in the order of the model. A larger polygon of
// the model counts as the triangles of its fan, in order. In a point, u and v are the barycentric
// weights of the second and the third vertex of the face. A weight is a JSON number, or a string
// with a fraction such as "1/3". A relative FILE starts from the folder of the scene. Members with
// other names are ignored.
//
// Main flow of read_scene_file:
//  1. parse      reads the text, and records the position of each index and weight in it
//  2. model      reads the mesh (mesh_io.h), cuts it into triangles, and makes a SurfaceMesh
//  3. points     decides exactly on which vertex, on which edge or in which face each point lies
//                (see below)
//  4. trace      traces each polygon from one of its points to the next (trace.h). Between two
//                points given in the same face, the trace is straight.
//  5. draw       reads each drawing of "svg", which is one object or a list, with svg_reader.h.
//                Puts the points of a drawing onto the surface, along straight lines from its
//                centre (exponential_map.h). Joins these points by traces. Each element of a
//                drawing becomes a shape. These shapes follow the shapes of the scene.
//
// Exact decisions: the numbers as written decide where a point lies. This holds for decimals, too.
// For example, [f, 0.3, 0.7] lies on an edge of face f, because 0.3 + 0.7 = 1. This would not hold
// for the doubles nearest to 0.3 and 0.7. In the face g across this edge, the same point may be
// [g, 0.7, 0]. After the decision, a decimal is rounded once to the nearest double. It is not
// rounded if this would move the point off its edge, onto an edge, or out of its face.
//
// Tolerance: if u or v is a decimal and u + v differs from 1 by at most 2^-52, the sum counts as 1.
// A point slightly outside its face is accepted and moved to the border of the face. It is accepted
// if none of u, v and 1 - u - v is less than -2^-52.
//
// Cost: O(bytes), plus the cost of tracing.
//
// Errors name their position in the file:
//   - the errors of JSON and of the model
//   - BadIndex
//   - BadShape for a point outside its face, for control points that no path joins, and for points
//     of drawings beyond the border of the surface
//   - ResourceLimit and Cancelled
#pragma once

#include <string>
#include <vector>

#include "plumb/base/context.h"
#include "plumb/io/read_options.h"
#include "plumb/space/mesh_arrays.h"
#include "plumb/surface/surface.h"

#pragma GCC visibility push(default)
namespace plumb {

/// A scene read from a file.
struct SceneFile {
  SurfaceScene scene;  ///< The input of SurfaceDivision.
  std::string model;   ///< The path of the mesh.
  /// Notes of the readers of the mesh and the drawings, for a human reader. Each note names its
  /// file.
  std::vector<std::string> notes;
};

/// Reads the scene in the file `path`, or in standard input if `path` is "-", with its mesh and its
/// drawings. `options.name` is ignored. Throws the errors stated above.
SceneFile read_scene_file(const std::string& path, ReadOptions options = {},
                          Context& context = unlimited_context());

/// Returns the surface of a mesh in which each polygon is cut into a fan of triangles. The
/// triangles are in the order of the polygons. Throws the errors of the constructor of SurfaceMesh.
/// Cost: O(n).
SurfaceMesh fanned_surface(const PolygonMesh& mesh);

}  // namespace plumb
#pragma GCC visibility pop
