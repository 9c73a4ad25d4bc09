// Reads scenes: polygons on a mesh (docs/formats.md, "Scenes").
//
//   {"model": FILE, "points": [[face, u, v], ..], "polygons": [[point, ..], ..],
//    "shapes"?: [[polygon, ..], ..], "outside"?: face, "levels"?: [[shape, face, label], ..],
//    "svg"?: {"file": FILE, "center": [face, u, v], "scale": length, "angle"?: degrees,
//    "tolerance"?: length}}
//
// Indices count from 0. The numbers u and v are the weights of the second and the third vertex of
// the face; faces are numbered as the model lists them, with larger polygons cut into fans in
// order. FILE is looked up in the folder of the scene. A weight is a JSON number or a string with a
// fraction, "1/3". Members with other names are ignored.
//
// Main flow of read_scene_file:
//  1. parse      reads the text, and keeps the place of each index and weight
//  2. model      reads the mesh (mesh_io.h), cuts it into triangles and makes a SurfaceMesh
//  3. points     puts each point on a vertex, on an edge or into a face, exactly (below)
//  4. trace      leads polygons from point to point (trace.h), straight within a face that both
//                points name
//  5. draw       reads each "svg" (one, or a list) once (svg_reader.h), puts its points onto the
//                surface by straight lines from the centre (exponential_map.h), and joins them by
//                traces; each element becomes a shape, after the shapes of the scene
//
// The numbers as they are written, decimals included, decide where a point lies: [f, 0.3, 0.7] lies
// on the edge and equals [g, 0.7, 0] across it, although no doubles add up to that. A decimal is
// then rounded once to the nearest double, unless that would move the point off its edge, onto an
// edge, or out of its face. If u or v is a decimal and u + v differs from 1 by at most 2^-52, the
// sum is taken for 1; a point outside its face by no more than that is accepted.
//
// Cost: O(bytes), and the cost of tracing. Errors, thrown with their place: the errors of JSON and
// of the model; BadIndex; BadShape for a point outside its face, for control points that no path
// joins, and for points of drawings beyond the border; ResourceLimit; Cancelled.
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
  /// The notes of the readers of mesh and drawings, with the names of their files, for people.
  std::vector<std::string> notes;
};

/// Reads the scene in the file `path`, or in standard input if `path` is "-", with its mesh and its
/// drawings. `options.name` is ignored. Throws the errors stated above.
SceneFile read_scene_file(const std::string& path, ReadOptions options = {},
                          Context& context = unlimited_context());

/// Returns the surface of a mesh, with each polygon cut into a fan of triangles, in order. Throws
/// as SurfaceMesh does. Cost: O(n).
SurfaceMesh fanned_surface(const PolygonMesh& mesh);

}  // namespace plumb
#pragma GCC visibility pop
