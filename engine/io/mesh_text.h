// What the writers of mesh formats have in common.
#pragma once

#include "plumb/io/text_output.h"
#include "plumb/space/polygon_mesh.h"

namespace plumb {

/// "x y z", as format_double().
void write_coordinates(TextOutput& out, const Point3& p);

/// A line for each face: how many corners, and the corners from 0.
void write_face_lines(TextOutput& out, const PolygonMesh& mesh);

/// Throws Error{NumberOutOfRange} when a vertex lies beyond the largest double. For writers that round.
void require_doubles(const PolygonMesh& mesh);

/// Throws Error{BadArgument} when a face is no triangle.
void require_triangles(const PolygonMesh& mesh);

}  // namespace plumb
