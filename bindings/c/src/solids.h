// What the sources of solids share.
#pragma once

#include "handles.h"
#include "plumb/space/to_mesh.h"
#include "plumb/space/valid_mesh.h"

namespace plumb::c {

plumb_to_mesh_report to_mesh_report(const ToMeshReport& made, const RoundingRepair& repair);

}  // namespace plumb::c
