// The unique minimal form of a marked map on the sphere. Internal; SphereOverlay::simplify() is the
// entry point.
//
// Main flow of run():
//  1. drop_arcs     drops each arc that has the same mark as both faces beside it; these faces
//                   become one face
//  2. judge_points  drops each point that keeps no arc and has the mark of its face, and each point
//                   between two arcs of one circle that has their mark
//  3. chain_arcs    makes one arc of those through dropped points, or a loop of a closed chain
//  4. link_points   makes the rings of the points that stay
//  5. number_faces  numbers the classes of merged faces, by the least of each
// Cost: O(n a(n)) with the inverse Ackermann function a, without arithmetic: two different arcs of
// one circle at a point are opposite there. Why the form is unique: docs/design/boolean.md, Lemma
// 2.
#pragma once

#include <vector>

#include "plumb/sphere/sphere_map.h"

namespace plumb {

/// Brings maps into minimal form. Keeps its memory between calls.
class SphereSimplifier {
 public:
  /// Writes the minimal form of `in` to `out`, another map, and returns true; or returns false, and
  /// leaves `out` as it is, if `in` is minimal.
  bool run(const SphereMap& in, SphereMap& out);

  // After run() has returned true: for each point, arc and face of `out`, the corresponding cell of
  // `in`. If several cells were merged, it is one of them.
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

  std::vector<std::uint32_t> parent_;     // Union-find over old faces.
  std::vector<std::uint8_t> is_kept_;     // Whether each old arc stays.
  std::vector<std::uint32_t> goes_on_;    // The next arc of the chain of each old arc, or kNone.
  std::vector<std::uint32_t> new_point_;  // The new number of each old point; kNone if dropped.
  std::vector<std::uint32_t> new_half_;   // The new number of old half-arcs at the ends of chains.
  std::vector<std::uint32_t> new_face_;   // The new number of each old face.
  std::vector<std::uint32_t> kept_here_;  // Kept half-arcs that leave a point, clockwise.
  std::vector<std::uint32_t> old_point_;
  std::vector<std::uint32_t> old_arc_;
  std::vector<std::uint32_t> old_face_;
  std::vector<std::uint8_t> is_chained_;  // Whether each old arc is in a chain already.
};

}  // namespace plumb
