// Reads scenes. A scene consists of polygons on a mesh (docs/formats.md, "Scenes"). The file of a
// scene contains a JSON object of the following form. A "?" marks an optional member.
//
//   {"model": FILE, "points": [[face, u, v], ..], "polygons": [[point, ..], ..],
//    "shapes"?: [[polygon, ..], ..], "outside"?: face, "levels"?: [[shape, face, label], ..],
//    "paths"?: "local" or "shortest",
//    "svg"?: {"file": FILE, "center": [face, u, v], "scale": length, "angle"?: degrees,
//    "tolerance"?: length}}
//
// Indices are 0-based. Faces are triangles, numbered in the order of the model. If a polygon of the
// model has more than three corners, the polygon is cut into a fan of triangles. These triangles
// are numbered one after the other. In a point, u and v are the barycentric weights of the second
// and the third vertex of the face. A weight is a JSON number, or a string with a fraction such as
// "1/3". A relative path FILE is relative to the folder of the scene file. Members with other names
// are ignored.
//
// Main flow of read_scene_file:
//  1. parse      reads the text, and records the position of each index and each weight in the text
//  2. model      reads the mesh (mesh_io.h), cuts it into triangles, and makes a SurfaceMesh
//  3. points     decides exactly for each point whether it is a vertex, lies on an edge, or lies in
//                the interior of a face (see "Exact decisions")
//  4. trace      joins consecutive points of each polygon by a path on the surface. This path is
//                called a trace (trace.h). If the two points are given with the same face, the
//                trace is straight. If "paths" is "shortest", traces are shortest paths.
//  5. draw       reads the drawings with svg_reader.h. The member "svg" is one drawing or a list of
//                drawings. Each point of a drawing is put onto the surface along a straight line
//                that starts at the point given by the member "center" (exponential_map.h). Traces
//                join consecutive points of a drawing. Each element of a drawing becomes a shape.
//                These shapes are numbered after the member "shapes".
//
// Exact decisions: the exact values of the written numbers decide where a point lies, even if the
// numbers are decimals. For example, [f, 0.3, 0.7] lies on an edge of face f, because
// 0.3 + 0.7 = 1. The exact sum of the doubles nearest to 0.3 and 0.7 is not 1. The same point may
// also be given in the face g on the other side of this edge, for example as [g, 0.7, 0]. After
// the decision, each decimal is rounded once to the nearest double. A decimal keeps its exact value
// if rounding it would move the point off its edge, onto an edge, or out of its face.
//
// Tolerance: suppose that u or v is a decimal, and that u + v differs from 1 by at most 2^-52. Then
// the point is treated as if u + v were 1. A point outside its face is accepted if u, v and 1 - u -
// v are all at least -2^-52. Such a point is moved to the border of the face.
//
// Cost: O(bytes), plus the cost of tracing.
//
// An error names the position in the file where it was found. The errors are:
//   - the errors of the JSON reader, and the errors of the reader of the model
//   - DegenerateFace if the model has a face of fewer than three different corners
//   - BadIndex
//   - BadShape for a point outside its face, and for two consecutive points that no path joins.
//     Also BadShape for a point of a drawing that would lie beyond the border of the surface
//   - ResourceLimit and Cancelled
#pragma once

#include <cstddef>
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
  /// The number of points in the member "points". These points are the first elements of
  /// scene.polygons.points.
  std::size_t point_count = 0;
  std::string model;  ///< The path of the mesh.
  /// Notes for a human reader about contents of the mesh and of the drawings that were left out.
  /// Each note names the file with these contents.
  std::vector<std::string> notes;
  /// Warnings for a human reader about geometry in the file of the mesh that is not in the scene. A
  /// program should show warnings even if it does not show notes.
  std::vector<std::string> warnings;
};

/// Reads a scene, its mesh and its drawings. The scene is in the file `path`, or in standard input
/// if `path` is "-". `options.name` is ignored. Throws the errors that the head of this file
/// states.
SceneFile read_scene_file(const std::string& path, ReadOptions options = {},
                          Context& context = unlimited_context());

/// Returns the surface of a mesh in which each polygon is cut into a fan of triangles. The
/// triangles are in the order of the polygons. Throws the errors of the constructor of SurfaceMesh.
/// Cost: O(n) for n corners of polygons.
SurfaceMesh fanned_surface(const PolygonMesh& mesh);

}  // namespace plumb
#pragma GCC visibility pop
