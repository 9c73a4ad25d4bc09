// The direction that walls run along, and the planes that hold it (internal to walls).
#pragma once

#include <array>
#include <span>
#include <vector>

#include "plumb/predicates/rational.h"
#include "plumb/space/space_complex.h"

namespace plumb {

/// "Up" is a vector of integers; "vertical" is along it.
class Vertical {
 public:
  /// Requires a direction that is not zero. The tables must outlive it; walls are interned there.
  Vertical(const std::array<Integer, 3>& direction, SpaceTables& tables);

  /// Does the (canonical) normal point up? Zero: the plane is vertical.
  Sign rise(PlaneId p);
  /// Requires planes of one line.
  bool is_vertical(const std::array<PlaneId, 2>& line) {
    return rise(line[0]) == Sign::Zero && rise(line[1]) == Sign::Zero;
  }
  /// The vertical plane through a line that is not vertical: of the pencil of the two.
  OrientedPlane through(const std::array<PlaneId, 2>& line);
  /// A vertical plane through a point, another one than `avoided`.
  PlaneId through(SpacePoint x, PlaneId avoided);

  /// A coordinate plane that is not vertical. Its normal points up.
  PlaneId level() const { return PlaneId(axis_); }
  std::size_t axis() const { return axis_; }
  /// How far aside one goes along `axis` for a unit along axis(), in doubles.
  double slope(std::size_t axis) const;

 private:
  std::array<Integer, 3> direction_;
  SpaceTables& tables_;
  std::size_t axis_ = 0;
  std::vector<FilteredSign> rise_;  // per plane; Unsure: not asked yet
};

// Half-planes that end at an edge, in their circular order: which lie inside the sector of a volume
// (internal to walls).

/// The half-plane of the plane that runs, from the edge, along sense (n x d): n the plane's normal,
/// d the direction of half-edge 2e. That of a use has the sense of its half-edge: Positive for 2e.
struct HalfPlane {
  PlaneId plane;
  Sign sense = Sign::Positive;
};

/// What a volume fills around an edge, counter-clockwise about half-edge 2e. Without uses: all
/// around.
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

// What the items of a complex leave in a vertical plane (internal to walls).
//
// Notation
//   W         the vertical plane; h = n_W x n_H with the level plane H: "ahead" is along h
//   station   a vertical line of W: a point on it, and another vertical plane through it
//   obstacle  a straight piece of the section of a facet with W, or an edge in W; not vertical. It
//             lies in `plane`, which is not vertical, from one station ahead to another
//
// Obstacles of one complex meet in their ends only. What is vertical in W is left out: nothing is
// seen of it from above or below.
//
// Signs. For a plane p, u = n_p x n_W: (u x up).n_W = |n_W|^2 (n_p.up), while (h x up).n_W =
// -|n_W|^2 (n_H.up) < 0: u runs back where p rises. So does the half-plane of W above a level line.

struct Station {
  SpacePoint point;
  PlaneId cross;
};

struct Obstacle {
  PlaneId plane;
  SpaceItem owner;               ///< facet or edge
  Station from, to;              ///< `to` is ahead of `from`
  SpaceItem from_item, to_item;  ///< vertex, or edge that crosses W
};

class WallSection {
 public:
  /// Points are added to `tables`, those of the complex.
  WallSection(const SpaceComplex& complex, SpaceTables& tables, Vertical& vertical, PlaneId wall)
      : c_(complex), tables_(tables), vertical_(vertical), wall_(wall) {}

  /// Adds the obstacles of a facet; edges in W are noted.
  void add(FacetId f);
  /// The same of an edge, if it is in W.
  void note(EdgeId e);
  /// Adds the edges noted, each once.
  void add_edges();

  const std::vector<Obstacle>& obstacles() const { return obstacles_; }
  PlaneId wall() const { return wall_; }

  /// Of an edge in W that is not vertical.
  Obstacle obstacle(EdgeId e);
  Station station(VertexId v);
  /// Positive: the point of W is ahead of the station.
  Sign ahead(SpacePoint x, const Station& s) const;
  /// Positive: the point is above the plane, which is not vertical.
  Sign above(SpacePoint x, PlaneId plane) const;
  /// Positive: the first obstacle is above the second. Requires that stations of both overlap;
  /// Zero: they are one.
  Sign above(const Obstacle& x, const Obstacle& y) const;
  /// Where an obstacle's plane is at a station.
  SpacePoint corner(const Station& s, PlaneId plane);

 private:
  /// A point of a facet's boundary on W, or a vertex inside it.
  struct Cut {
    SpacePoint point;
    SpaceItem item;
    int crossings;  ///< of the boundary with a line beside W, on its negative side
  };

  void gather(FacetId f);
  void gather(UseId cycle);
  void order(PlaneId plane);
  bool is_side(const Cut& a, const Cut& b) const;
  Station station(const Cut& cut);

  const SpaceComplex& c_;
  SpaceTables& tables_;
  Vertical& vertical_;
  PlaneId wall_;
  std::vector<Obstacle> obstacles_;
  std::vector<EdgeId> edges_;  // in W, not vertical
  // of the facet at hand
  std::vector<Cut> cuts_;
  std::vector<EdgeId> sides_;  // in W
};

}  // namespace plumb
