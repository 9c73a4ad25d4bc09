// The overlay of what an edge and a facet look like where the one pierces the other: lunes, two opposite points joined by
// half-circles, and a circle that crosses all of these. Internal to engine/sphere.
//
// Main flow of build():
//  1. is the one map like this, and the other? On which side of the circle is the first point?
//  2. each half-circle is cut where the circle crosses it, and the circle there: all links are known
//  3. each face is the part of a lune on one side of the circle
// Cost: O(half-circles), one sign.
#pragma once

#include <vector>

#include "plumb/sphere/sphere_overlay.h"

namespace plumb {

/// Keeps its memory between calls.
class SphereLunes {
 public:
  /// Fills `out`, but for its marks, and `cells`, the pair of cells that each cell of it lies in. False if the maps are not
  /// like this; then both are left as they are.
  bool build(const PlaneTable& planes, const SphereMap& a, const SphereMap& b, SphereMap& out,
             SphereOrigins& cells);

 private:
  using Pair = SphereOrigins::Pair;

  Pair pair(SphereCell of_lunes, SphereCell of_circle) const;
  SphereCell face_on(Sign side) const;
  Sign start_side(std::uint32_t i) const;
  void add_points();
  void add_arc(PlaneId circle, std::uint32_t from, std::uint32_t to, const Pair& cells);
  void cut_half_circles();
  void cut_circle();
  void link_crossing(std::uint32_t i, std::uint32_t leaving, std::uint32_t arriving);
  void link_ends();
  void number_faces();
  std::uint32_t face(std::uint32_t lune, Sign side);

  const SphereMap* lunes_ = nullptr;
  const SphereMap* circle_ = nullptr;
  bool has_lunes_first_ = false;  // are the lunes of map a?
  Sign first_side_ = Sign::Zero;  // of the circle: that of point 0 of the lunes
  SphereMap* out_ = nullptr;
  SphereOrigins* cells_ = nullptr;
  std::vector<std::uint32_t> lune_of_piece_;  // per piece of the circle: the face of the lunes
  std::vector<std::uint32_t> number_;         // per face of the lunes and side: the face, or kNone
};

}  // namespace plumb
