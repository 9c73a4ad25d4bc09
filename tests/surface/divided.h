// Divides a scene and audits what comes out.
#pragma once

#include <gtest/gtest.h>

#include "generate/surface_scenes.h"
#include "plumb/surface/surface_audit.h"

namespace plumb::testing {

inline SurfaceDivision divide(const SurfaceDrawing& drawing) {
  Context context;
  SurfaceDivision division(drawing.scene, context);
  EXPECT_EQ(audit(division).value_or(""), "");
  return division;
}

}  // namespace plumb::testing
