// Step 5 of scene_reader.h: a drawing goes onto the surface.
#pragma once

#include "plumb/base/context.h"
#include "plumb/io/scene_text.h"
#include "plumb/surface/surface.h"
#include "plumb/surface/trace.h"

namespace plumb {

/// Appends the rings of a drawing as polygons, and its shapes, which scene.shapes must hold; `centre` is a point of
/// scene.polygons in `face`. Errors have their place in the file of the drawing: BadShape for points beyond the border,
/// ResourceLimit for those too far away; Cancelled.
void add_drawing(const DrawingFile& file, const ParsedScene::Drawing& how, SurfacePointId centre,
                 FaceId face, Tracer& tracer, SurfaceScene& scene, Context& context);

/// Of the faces in the component of `face`, the first whose first corner is farthest from a point, as the crow flies: there
/// labels of drawings are zero.
FaceId farthest_face(const SurfaceMesh& mesh, const Point3& from, FaceId face);

}  // namespace plumb
