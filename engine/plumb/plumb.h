// The sets of plane, sphere and space, and the meshes and polygons that they come from and go to:
// all that most programs include. Files are read and written by the headers of plumb/io, pictures
// drawn by those of plumb/picture; maps are checked by plumb/plane/map_check.h, sets cut into
// convex parts by plumb/convex/decompose.h, polygons on surfaces combined by
// plumb/surface/surface.h.
#pragma once

#include "plumb/base/context.h"
#include "plumb/base/version.h"
#include "plumb/plane/nef2.h"
#include "plumb/plane/plane_arrays.h"
#include "plumb/predicates/error.h"
#include "plumb/space/mesh_arrays.h"
#include "plumb/space/nef3.h"
#include "plumb/sphere/nef_sphere.h"
