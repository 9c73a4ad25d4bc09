// What walls ask of a complex (internal to walls): the direction that walls hold (Vertical), the
// sectors of volumes around an edge (SectorTest), and the section of the complex with a vertical
// plane (WallSection).
//
// Notation
//   up        a vector of integers; "vertical" means along it
//   W         the vertical plane. With h = n_W x n_H, H the level plane, "ahead" means along h
//   station   a vertical line of W: a point on it, and another vertical plane through it
//   obstacle  a straight piece of the section of a facet with W, or an edge in W; not vertical. It
//             lies in `plane`, which is not vertical, from one station ahead to another
//
// Obstacles of one complex meet in their ends only. What is vertical in W is left out: nothing of
// it is seen from above or below.
//
// Signs. For a plane p let u = n_p x n_W. Then (u x up).n_W = |n_W|^2 (n_p.up), while (h x up).n_W
// = -|n_W|^2 (n_H.up) < 0: u runs back if p rises. So does the half-plane of W above a level line.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "plumb/predicates/rational.h"
#include "plumb/space/space_complex.h"

namespace plumb {

/// The direction that is vertical, and the planes that hold it.
class Vertical {
 public:
  /// Requires a direction that is not zero. The tables must outlive this object; walls are interned
  /// there.
  Vertical(const std::array<Integer, 3>& direction, SpaceTables& tables);

  /// Returns Positive if the canonical normal points up, and Zero if the plane is vertical. Known
  /// signs are kept.
  Sign rise(PlaneId p);
  /// Whether the line is vertical. Requires two planes of it.
  bool is_vertical(const std::array<PlaneId, 2>& line) {
    return rise(line[0]) == Sign::Zero && rise(line[1]) == Sign::Zero;
  }
  /// Returns the vertical plane through a line that is not vertical; it is of the pencil of the two
  /// planes.
  OrientedPlane through(const std::array<PlaneId, 2>& line);
  /// Returns a vertical plane through a point, different from `avoided`.
  PlaneId through(SpacePoint x, PlaneId avoided);

  /// Returns a coordinate plane that is not vertical. Its normal points up.
  PlaneId level() const { return PlaneId(axis_); }
  std::size_t axis() const { return axis_; }
  /// Returns how far aside one goes along `axis` for a unit along axis(), in doubles.
  double slope(std::size_t axis) const;

 private:
  std::array<Integer, 3> direction_;
  SpaceTables& tables_;
  std::size_t axis_ = 0;
  IdVector<PlaneId, FilteredSign> rise_;  // Sign for each plane; Unsure until it is asked for.
};

// Half-planes that end at an edge, in their circular order, and which of them lie inside the sector
// of a volume.

/// The half-plane of the plane that runs, from the edge, along sense (n x d), with n the plane's
/// normal and d the direction of half-edge 2e. That of an edge use has the sense of its half-edge:
/// Positive for 2e.
struct HalfPlane {
  PlaneId plane;
  Sign sense = Sign::Positive;
};

/// What a volume fills around an edge, counter-clockwise about half-edge 2e; all around if the edge
/// has no uses.
struct Sector {
  EdgeId edge;
  VolumeId volume;
  UseId first;  ///< First edge use; invalid for an edge without uses.
  /// The next edge use; if it is the same, the volume is all around but for this facet.
  UseId second;
};

/// Sets `sectors` to all sectors of marked volumes around an edge.
void sectors_of(const SpaceComplex& complex, EdgeId e, std::vector<Sector>& sectors);

/// Angles between half-planes at an edge, by exact signs.
class SectorTest {
 public:
  explicit SectorTest(const SpaceComplex& complex) : c_(complex) {}

  /// Whether the sector spans more than half a turn.
  bool is_reflex(const Sector& s) const;
  /// Whether the half-plane lies strictly inside the sector.
  bool holds(const Sector& s, HalfPlane h) const;
  /// Whether the half-plane lies strictly inside the sector and neither part is reflex then.
  bool is_resolved_by(const Sector& s, HalfPlane h) const;

  /// Returns the half-plane of an edge use.
  HalfPlane of_use(UseId u) const {
    return {c_.facet_plane[c_.use_facet[u]],
            SpaceComplex::is_reverse(c_.use_halfedge[u]) ? Sign::Negative : Sign::Positive};
  }

 private:
  /// Returns the turn from one half-plane to the other: 0 none, 1 less than half a turn, 2 half a
  /// turn, 3 more.
  int turn(EdgeId e, HalfPlane from, HalfPlane to) const;
  Sign sine(EdgeId e, HalfPlane from, HalfPlane to) const;

  const SpaceComplex& c_;
};

/// A vertical line of W, by a point on it and another vertical plane through it.
struct Station {
  SpacePoint point;
  PlaneId cross;
};

/// A straight piece of the section that is not vertical.
struct Obstacle {
  PlaneId plane;
  SpaceItem owner;               ///< Facet or edge.
  Station from, to;              ///< Ends; `to` is ahead of `from`.
  SpaceItem from_item, to_item;  ///< The kind of each end: a vertex, or an edge that crosses W.
};

/// The section of a complex with a vertical plane, as obstacles.
class WallSection {
 public:
  /// Points are added to `tables`, the tables of the complex.
  WallSection(const SpaceComplex& complex, SpaceTables& tables, Vertical& vertical, PlaneId wall)
      : c_(complex), tables_(tables), vertical_(vertical), wall_(wall) {}

  /// Adds the obstacles of a facet and notes its edges in W.
  void add(FacetId f);
  /// Notes an edge, if it is in W.
  void note(EdgeId e);
  /// Adds the edges that were noted, each once.
  void add_edges();

  const std::vector<Obstacle>& obstacles() const { return obstacles_; }
  PlaneId wall() const { return wall_; }

  /// Returns the obstacle of an edge in W that is not vertical.
  Obstacle obstacle(EdgeId e);
  /// Returns the station of a vertex in W.
  Station station(VertexId v);
  /// Returns Positive if the point of W is ahead of the station.
  Sign ahead(SpacePoint x, const Station& s) const;
  /// Returns Positive if the point is above the plane, which is not vertical.
  Sign above(SpacePoint x, PlaneId plane) const;
  /// Returns Positive if the first obstacle is above the second, and Zero if they are one. Requires
  /// that the stations of both overlap.
  Sign above(const Obstacle& x, const Obstacle& y) const;
  /// Returns the point of an obstacle's plane at a station.
  SpacePoint corner(const Station& s, PlaneId plane);

 private:
  /// A point of a facet's boundary on W, or a vertex inside the facet.
  struct Cut {
    SpacePoint point;
    SpaceItem item;
    int crossings;  ///< Crossings of the boundary with a line beside W, on its negative side.
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
  std::vector<EdgeId> edges_;  // Edges in W that are not vertical.
  // Scratch of the facet at hand.
  std::vector<Cut> cuts_;
  std::vector<EdgeId> sides_;  // Sides of the facet in W.
};

}  // namespace plumb
