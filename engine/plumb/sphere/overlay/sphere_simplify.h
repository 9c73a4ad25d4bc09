// The unique minimal form of a marked map on the sphere. Internal; SphereOverlay::simplify is the
// door.
//
// Main flow of run():
//  1. drop_arcs     an arc goes if its mark is that of both faces beside it; these become one
//  2. judge_points  a point that keeps no arc goes if its mark is that of its face; one between two
//                   arcs of one circle goes if its mark is theirs
//  3. chain_arcs    arcs through gone points become one; a closed chain of them becomes a loop
//  4. link_points   rings of the points that stay
//  5. number_faces  classes of merged faces, by the least of each
// Cost: O(n a(n)), no arithmetic: two different arcs of one circle at a point lie opposite.
#pragma once

#include <vector>

#include "plumb/sphere/sphere_map.h"

namespace plumb {

/// Keeps its memory between calls.
class SphereSimplifier {
 public:
  /// Writes the minimal form of `in` to `out`, another map. False: `in` is minimal, `out`
  /// untouched.
  bool run(const SphereMap& in, SphereMap& out);

  /// After run() returned true: per item of `out` the item of `in` it was (of merged ones: one).
  const std::vector<std::uint32_t>& old_point() const { return old_point_; }
  const std::vector<std::uint32_t>& old_arc() const { return old_arc_; }
  const std::vector<std::uint32_t>& old_face() const { return old_face_; }

 private:
  bool drop_arcs(const SphereMap& in);
  bool judge_points(const SphereMap& in);
  bool is_mere(const SphereMap& in, std::uint32_t v);
  void collect_kept(const SphereMap& in, std::uint32_t v);
  void place_points(const SphereMap& in, SphereMap& out);
  void chain_arcs(const SphereMap& in, SphereMap& out);
  void add_chain(const SphereMap& in, std::uint32_t first, SphereMap& out);
  void link_points(const SphereMap& in, SphereMap& out);
  void number_faces(const SphereMap& in, SphereMap& out);
  std::uint32_t find(std::uint32_t face);

  std::vector<std::uint32_t> parent_;     // per old face
  std::vector<std::uint8_t> is_kept_;     // per old arc
  std::vector<std::uint32_t> goes_on_;    // per old arc: the next one of its chain
  std::vector<std::uint32_t> new_point_;  // per old point; kNone: gone
  std::vector<std::uint32_t> new_half_;   // per old half-arc at the end of a chain
  std::vector<std::uint32_t> new_face_;   // per old face
  std::vector<std::uint32_t> kept_here_;  // half-arcs that leave a point, clockwise
  std::vector<std::uint32_t> old_point_;
  std::vector<std::uint32_t> old_arc_;
  std::vector<std::uint32_t> old_face_;
  std::vector<std::uint8_t> is_chained_;  // per old arc
};

}  // namespace plumb
