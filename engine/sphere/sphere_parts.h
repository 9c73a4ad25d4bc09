// Connected parts of a map, and which of their cycles bound one face. Internal.
//
// Each part but one walks to a given arc (sphere_path.h). What follows each other on a walk bounds one
// face; and since the faces and parts of a sphere form a tree, the walks tell this of all cycles: on its
// way a walk passes through every face between its ends. Reads no face and no mark of the map.
// Cost: O(n a(n)), and O(n log n) for each part but one.
#pragma once

#include <vector>

#include "plumb/sphere/sphere_path.h"

namespace plumb {

// Union-find: the root of a set is its least member.
inline std::uint32_t find_root(std::vector<std::uint32_t>& parent, std::uint32_t i) {
  while (parent[i] != i) i = parent[i] = parent[parent[i]];
  return i;
}
void unite(std::vector<std::uint32_t>& parent, std::uint32_t i, std::uint32_t j);
void make_singles(std::vector<std::uint32_t>& parent, std::size_t count);

/// Keeps its memory between calls.
class SphereParts {
 public:
  /// Two places on the boundary of one face, of different parts or not.
  struct Link {
    SphereSlot first;
    SphereSlot second;
  };

  void find(const PlaneTable& planes, const SphereMap& map);

  // Parts are named by numbers below bound(), not all of which are used.
  std::uint32_t bound() const { return static_cast<std::uint32_t>(parent_.size()); }
  std::uint32_t of_point(std::uint32_t v) { return find_root(parent_, v); }
  std::uint32_t of_arc(std::uint32_t a) { return find_root(parent_, point_count_ + a); }
  std::uint32_t of(SphereSlot slot) {
    return slot.half_arc != SphereMap::kNone ? of_arc(slot.half_arc / 2) : of_point(slot.point);
  }
  std::size_t count() const;

  /// Unite what they link, and the cycles of one face are one. Without arcs none: there is one face.
  const std::vector<Link>& links() const { return links_; }

 private:
  void walk_from(const PlaneTable& planes, const SphereMap& map, std::uint32_t point,
                 std::uint32_t root_arc);

  std::uint32_t point_count_ = 0;
  std::vector<std::uint32_t> parent_;  // points, then arcs
  std::vector<Link> links_;
  std::vector<PathHit> hits_;
};

}  // namespace plumb
