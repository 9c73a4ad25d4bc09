// Sets of space from meshes, without further questions.
#pragma once

#include "plumb/base/context.h"
#include "plumb/space/mesh_arrays.h"
#include "plumb/space/nef3.h"

namespace plumb::testing {

/// What a closed mesh winds around. Throws what Nef3::from_mesh() throws.
inline Nef3 solid(const PolygonMesh& mesh, WindingRule rule = WindingRule::Positive) {
  Context context;
  return Nef3::from_mesh(mesh, {.rule = rule}, context);
}

}  // namespace plumb::testing
