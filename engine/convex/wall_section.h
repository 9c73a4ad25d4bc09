// What the items of a complex leave in a vertical plane (internal to walls).
//
// Notation
//   W         the vertical plane; h = n_W x n_H with the level plane H: "ahead" is along h
//   station   a vertical line of W: a point on it, and another vertical plane through it
//   obstacle  a straight piece of the section of a facet with W, or an edge in W; not vertical. It lies in `plane`,
//             which is not vertical, from one station ahead to another
//
// Obstacles of one complex meet in their ends only. What is vertical in W is left out: nothing is seen of it from above
// or below.
//
// Signs. For a plane p, u = n_p x n_W: (u x up).n_W = |n_W|^2 (n_p.up), while (h x up).n_W = -|n_W|^2 (n_H.up) < 0:
// u runs back where p rises. So does the half-plane of W above a level line.
#pragma once

#include <span>
#include <vector>

#include "plumb/convex/vertical.h"
#include "plumb/space/space_complex.h"

namespace plumb {

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
  /// Positive: the first obstacle is above the second. Requires that stations of both overlap; Zero: they are one.
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
