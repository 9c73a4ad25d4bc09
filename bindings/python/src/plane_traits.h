// What the grammar of sets has to know of sets of the plane.
#pragma once

#include "plumb/plane/nef2.h"
#include "set_grammar.h"

namespace plumb::python {

template <>
struct SetTraits<Nef2> {
  static constexpr std::size_t kDimension = 2;
  static constexpr const char* kShootDoc =
      "Return the first marked cell that the ray from `origin` meets, and where the ray meets it, "
      "or None.";

  static RationalPoint2 point_of(const Exact<2>& p) { return {p.value[0], p.value[1]}; }
  static std::vector<Rational> coordinates(const RationalPoint2& p) { return {p.x, p.y}; }
  static Cell cell_of(const PlaneLocation& location) {
    if (location.vertex.is_valid()) return {"vertex", location.vertex.value(), location.marked};
    if (location.edge.is_valid()) return {"edge", location.edge.value(), location.marked};
    return {"face", location.face.value(), location.marked};
  }
  static std::string repr(const Nef2& set) {
    const PlaneCounts n = set.counts();
    return "<plumb.PlaneSet: " + std::to_string(n.vertices) + " vertices, " +
           std::to_string(n.edges) + " edges, " + std::to_string(n.faces) + " faces (" +
           std::to_string(n.marked_faces) + " marked)>";
  }
};

}  // namespace plumb::python
