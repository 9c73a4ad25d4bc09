// Half-planes that end at an edge, in their circular order: which lie inside the sector of a volume
// (internal to walls).
#pragma once

#include <vector>

#include "plumb/space/space_complex.h"

namespace plumb {

/// The half-plane of the plane that runs, from the edge, along sense (n x d): n the plane's normal, d the direction of
/// half-edge 2e. That of a use has the sense of its half-edge: Positive for 2e.
struct HalfPlane {
  PlaneId plane;
  Sign sense = Sign::Positive;
};

/// What a volume fills around an edge, counter-clockwise about half-edge 2e. Without uses: all around.
struct Sector {
  EdgeId edge;
  VolumeId volume;
  UseId first;   ///< invalid: an edge without uses
  UseId second;  ///< the next one; the same: all around but this facet
};

/// All sectors of marked volumes around an edge.
void sectors_of(const SpaceComplex& complex, EdgeId e, std::vector<Sector>& sectors);

class SectorTest {
 public:
  explicit SectorTest(const SpaceComplex& complex) : c_(complex) {}

  /// More than half a turn?
  bool is_reflex(const Sector& s) const;
  /// Strictly inside?
  bool holds(const Sector& s, HalfPlane h) const;
  /// Strictly inside, and no part is reflex then?
  bool is_resolved_by(const Sector& s, HalfPlane h) const;

  HalfPlane of_use(UseId u) const {
    return {c_.facet_plane[c_.use_facet[u.value()].value()],
            SpaceComplex::is_reverse(c_.use_halfedge[u.value()]) ? Sign::Negative : Sign::Positive};
  }

 private:
  /// From one to the other: 0 none, 1 less than half a turn, 2 half a turn, 3 more.
  int turn(EdgeId e, HalfPlane from, HalfPlane to) const;
  Sign sine(EdgeId e, HalfPlane from, HalfPlane to) const;

  const SpaceComplex& c_;
};

}  // namespace plumb
