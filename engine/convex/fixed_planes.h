// One plane for each reflex edge of a solid, fixed before anything is cut: the classical rule, with which the number
// of pieces has a bound (cuts.h).
//
// A tip is a vertex where several reflex edges meet. Where all of them lead to one side of a plane through the tip,
// the solid may touch the plane there from one side, and PlaneSection::find() fails.
//
// The plane of an edge: that of a face at it, of the first that holds no such tip, else the first of the pencil between
// both with that property, by small integer factors. A tip off the edge's line lies in one plane of the
// pencil, so one is found. Of tips on the line nothing is asked.
//
// Each plane enters the solid on one side of its edge only: after the cut both angles are at most half a turn.
// Cost: O(n + r t) signs for r reflex edges and t ends of reflex edges at tips, as a rule.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "plumb/base/context.h"
#include "plumb/convex/cut_surface.h"

namespace plumb {

class FixedPlanes {
 public:
  /// Of the reflex edges of a surface that has not been cut.
  FixedPlanes(CutSurface& surface, std::span<const HalfedgeId> reflex, Context& context);

  PlaneId plane(EdgeId e) const { return plane_[e.value()]; }

 private:
  void find_tips(std::span<const HalfedgeId> reflex);
  PlaneId choose(HalfedgeId h);
  PlaneId choose_between(HalfedgeId h);
  bool may_touch(PlaneId p, std::array<PlaneId, 2> line) const;
  Sign side_of(VertexId v, PlaneId p) const;

  CutSurface& s_;
  std::vector<std::array<VertexId, 2>> spokes_;  // from tips to the other ends, by tips
  std::vector<PlaneId> plane_;                   // per edge
};

}  // namespace plumb
