// Booleans of sphere maps: two maps laid over each other, marks combined, minimal form.
//
// Main flow of boolean_op():
//  1. cross      arcs meet at n_c1 x n_c2, overlap on equal circles, pass through points: every arc
//                is cut where the other map touches it
//  2. link       pieces around each point in circular order; orbits; components
//  3. label      each cell gets the pair of cells it lies in: across an arc the pair changes as its
//                sides say; a component that meets nothing of the other map asks once where it lies
//                Where an edge pierces a facet, all of this is known (sphere_overlay.cpp).
//  4. select     marks of the pairs through the table
//  5. simplify   arcs equal to both faces go, then points inside an arc or a face
//
// Cost: O(n m) for small maps (below 64 arcs, the case of nearly every vertex of a solid);
// O((n + m + k) log(n + m)) for large ones. All memory is kept between calls.
// Source: Hachenberger, Kettner, Mehlhorn, CGTA 38 (2007), section 4; SPACE.md 4.
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "plumb/base/context.h"
#include "plumb/sphere/sphere_map.h"

namespace plumb {

/// Per item of the combined map, the item of each operand it lies in (its own item for a point of
/// both). Items merged by simplification: one of them.
struct SphereOrigins {
  using Pair = std::array<SphereCell, 2>;
  std::vector<Pair> point;
  std::vector<Pair> arc;
  std::vector<Pair> face;
};

class SphereOverlay {
 public:
  /// The planes must outlive it; planes may be added.
  explicit SphereOverlay(const PlaneTable& planes);
  ~SphereOverlay();
  SphereOverlay(const SphereOverlay&) = delete;
  SphereOverlay& operator=(const SphereOverlay&) = delete;

  /// `out` (not an operand) becomes the minimal map of table(mark in a, mark in b). Of large maps,
  /// memory beyond that of the maps is charged to `context` until the end, and its time is looked
  /// at.
  void boolean_op(const SphereMap& a, const SphereMap& b, const MarkTable& table, SphereMap& out,
                  SphereOrigins& origins, Context* context = nullptr);

  /// Brings a map into minimal form: arcs whose mark is that of both faces go, then points that are
  /// mere points of an arc, a loop or a face. Returns whether anything changed. Per remaining item,
  /// `kept` says which item it was (of merged ones: one of them). O(size), no arithmetic but for
  /// points between two arcs of one circle.
  bool simplify(SphereMap& map, SphereOrigins* kept = nullptr);

 private:
  struct Work;
  std::unique_ptr<Work> work_;
};

/// Requires a minimal map.
PyramidKind classify(const PlaneTable& planes, const SphereMap& map);

/// The item of the map that the direction hits. Its planes need not pass through the centre.
/// O(size).
SphereCell locate(const PlaneTable& planes, const SphereMap& map, SphereDirection direction);

}  // namespace plumb
