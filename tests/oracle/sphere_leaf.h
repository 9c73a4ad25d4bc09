// The sets of the sphere that programs start from: what they contain, by inequalities alone, and
// the same in the engine.
#pragma once

#include <string>
#include <vector>

#include "oracle/sphere_check.h"

namespace plumb::testing {

struct SphereLeaf {
  enum Kind : std::uint8_t {
    HalfSphere,  ///< around v[0]
    Circle,      ///< orthogonal to v[0]
    Arc,         ///< the shorter one from v[0] to v[1]
    LongArc,     ///< the other one, as an arc from v[1] to v[0]
    RoundArc,    ///< from v[0] once around towards v[1]
    Points,      ///< all vectors
    Triangle,    ///< left of v[0], v[1], v[2]
    Lune,        ///< left of the half-circles about v[0] and back about v[1]
    Convex,      ///< the intersection of half-spheres around all vectors
    Kinds
  };
  Kind kind;
  Boundary boundary;
  std::vector<SphereVector> v;

  /// Does the engine take it (the ends of an arc are neither the same nor opposite ...)?
  bool is_valid() const;
  /// Circles that bound it or make its ends crossings.
  std::vector<CellVector> normals() const;
  bool contains(const CellVector& u) const;
  NefSphere to_nef() const;
  std::string to_text() const;

 private:
  std::vector<CellVector> cells() const;
};

}  // namespace plumb::testing
