// The surface of a set, prepared for cuts: what the tests of cutting begin with.
#pragma once

#include <cstddef>
#include <vector>

#include "plumb/convex/part/cut_surface.h"
#include "plumb/space/complex/space_tables.h"
#include "plumb/space/nef3.h"

namespace plumb::testing {

/// A surface on tables of its own, all its faces, and one half of each reflex edge.
struct CutScene {
  CutSurface surface;
  std::vector<FaceId> faces;
  std::vector<HalfedgeId> reflex;

  explicit CutScene(const Nef3& set) : surface(*cut_surface_of(set.complex())) {
    surface.tables = copy(*surface.tables);
    for (std::size_t f = 0; f < surface.faces.size(); ++f) faces.emplace_back(f);
    for (std::size_t h = 0; h < surface.halves.size(); ++h) {
      const CutSurface::Half& half = surface.halves[h];
      if (half.is_reflex && HalfedgeId(h) < half.twin) reflex.emplace_back(h);
    }
  }
};

}  // namespace plumb::testing
