// This header includes everything that most programs need: the sets of the plane, of the sphere and
// of space, and the conversions between sets and meshes or polygons. Other tasks need other
// headers:
//   - The headers of plumb/io read and write files.
//   - The headers of plumb/picture draw pictures.
//   - The header plumb/plane/map_check.h checks maps.
//   - The header plumb/convex/decompose.h cuts sets into convex parts.
//   - The headers of plumb/model make and measure models: primitives, hulls, extrusions, slices.
//   - The header plumb/surface/surface.h combines polygons on surfaces.
#pragma once

#include "plumb/base/context.h"
#include "plumb/base/version.h"
#include "plumb/plane/nef2.h"
#include "plumb/plane/plane_arrays.h"
#include "plumb/plane/plane_rounding.h"
#include "plumb/predicates/error.h"
#include "plumb/space/mesh_arrays.h"
#include "plumb/space/nef3.h"
#include "plumb/sphere/nef_sphere.h"
