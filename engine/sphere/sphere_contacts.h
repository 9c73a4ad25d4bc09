// Phase "cross" of an overlay: every place where two maps meet. Internal to engine/sphere.
//
// Main flow of find():
//  1. number_circles  the circles of each map, each once
//  2. find_sides      each point of one map against each circle of the other: the only det3 of the
//                     phase but those that order points within one half-circle
//  3. join_points     equal points of both maps become one
//  4. add_points_on   points of one map strictly inside arcs of the other
//  5. add_crossings   arcs of different circles: both must hold the same one of the two points of
//                     their circles strictly inside, which the sides of their ends tell
// Arcs of one circle need nothing more: where they overlap, ends of one lie inside the other.
#pragma once

#include <array>
#include <vector>

#include "plumb/sphere/sphere_arcs.h"

namespace plumb {

/// Keeps its memory between calls.
class SphereContacts {
 public:
  /// A point strictly inside an arc.
  struct Stop {
    std::uint32_t arc;
    std::uint32_t point;  ///< of the overlay
    CirclePlace place;    ///< on the arc's circle
  };

  void find(const PlaneTable& planes, const SphereMap& a, const SphereMap& b);

  // Per point of the overlay: those of a, those of b only, crossings.
  std::vector<SphereDirection> direction;
  /// The point or arc of each map it lies in or on; not valid: in a face, not said which.
  std::vector<std::array<SphereCell, 2>> cell;

  std::array<std::vector<std::uint32_t>, 2> point_of;  ///< per point of each map: of the overlay
  std::array<std::vector<Stop>, 2> stops;              ///< in no order
  bool shares_circles = false;

 private:
  void number_circles(const SphereMap& map, std::size_t k);
  void find_sides(std::size_t k);
  void find_crossings(std::size_t k);
  void join_points();
  std::uint32_t find_equal(std::uint32_t point_of_b) const;
  void add_points_on(std::size_t k);
  void add_crossings();
  void add_crossing(std::uint32_t a, std::uint32_t b, bool is_opposite);
  std::uint32_t add(SphereDirection u, SphereCell in_a, SphereCell in_b);
  Sign side(std::size_t k, std::uint32_t point, std::uint32_t circle) const {
    return sides_[k][point * circles_[1 - k].size() + circle];
  }

  const PlaneTable* planes_ = nullptr;
  std::array<const SphereMap*, 2> map_{};
  std::array<std::vector<PlaneId>, 2> circles_;          // each once, by id
  std::array<std::vector<std::uint32_t>, 2> circle_of_;  // per arc: into circles_
  std::array<std::vector<Sign>, 2> sides_;               // points of k x circles of the other
  std::array<std::vector<ArcCrossings>, 2> crossings_;   // arcs of k x circles of the other
};

}  // namespace plumb
