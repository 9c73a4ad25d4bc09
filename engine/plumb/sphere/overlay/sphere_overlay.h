// Booleans of sphere maps: two maps are laid over each other, their marks combined, and the result
// brought into minimal form.
//
// Main flow of boolean_op():
//  1. cross      finds where arcs cross at n_c1 x n_c2, overlap on equal circles, or pass through
//                points: every arc is cut where the other map touches it
//  2. link       puts the pieces around each point in circular order, and finds orbits and parts
//  3. label      finds the pair of cells in which each cell lies: across an arc the pair changes to
//                that of the arc's other side; a part that meets nothing of the other map takes
//                its face from the parts beside it
//  4. select     looks up the marks of the pairs in the table
//  5. simplify   removes arcs equal to both their faces, then points inside an arc or a face
// Where an edge pierces a facet, steps 1 to 3 are written down directly (sphere_overlay.cpp).
//
// Cost: O(n m) for small maps (about 64 arcs each, the case of nearly every vertex of a solid);
// O((n + m + k) log(n + m)) for large ones with k pairs whose bounds meet. All memory is kept
// between calls. Source: P. Hachenberger, L. Kettner, K. Mehlhorn, Computational Geometry 38
// (2007), section 4; docs/design/sphere.md.
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "plumb/base/context.h"
#include "plumb/sphere/sphere_map.h"

namespace plumb {

/// For each cell of the combined map, the cell of each operand in which it lies. A cell that
/// simplification made of several has the pair of one of them.
struct SphereOrigins {
  using Pair = std::array<SphereCell, 2>;  ///< A cell of a and a cell of b.
  std::vector<Pair> point;                 ///< One pair for each point.
  std::vector<Pair> arc;                   ///< One pair for each arc.
  std::vector<Pair> face;                  ///< One pair for each face.
};

/// Computes Booleans and minimal forms of sphere maps over one table of planes. Keeps its memory
/// between calls.
class SphereOverlay {
 public:
  /// Makes an object for maps over `planes`, which must outlive it; planes may be added.
  explicit SphereOverlay(const PlaneTable& planes);
  ~SphereOverlay();
  SphereOverlay(const SphereOverlay&) = delete;
  SphereOverlay& operator=(const SphereOverlay&) = delete;

  /// Sets `out` to the minimal map of table(mark in a, mark in b). Requires that `out` is no
  /// operand. If there is a context, an overlay of large maps charges the memory that it needs in
  /// addition to the maps, until it ends. It throws the errors of the Context.
  void boolean_op(const SphereMap& a, const SphereMap& b, const MarkTable& table, SphereMap& out,
                  SphereOrigins& origins, Context* context = nullptr);

  /// Brings a map into minimal form. First removes each arc that has the same mark as both faces
  /// beside it. Then removes each point that only divides an arc or a loop, or lies in a face, and
  /// has the same mark. Returns whether anything changed. Sets `kept` to the former cell of each
  /// cell that is left. If several cells were merged, it is one of them. Cost: O(n a(n)) for n
  /// cells, without arithmetic: two arcs of one circle at a point are opposite there.
  bool simplify(SphereMap& map, SphereOrigins* kept = nullptr);

 private:
  struct Work;
  std::unique_ptr<Work> work_;
};

/// Returns the kind of the cell at the centre of a map: a volume, a facet, an edge or a vertex.
/// Requires a minimal map.
PyramidKind classify(const PlaneTable& planes, const SphereMap& map);

/// Returns the cell of the map in which a direction lies. The planes of the direction need not
/// contain the centre. Cost: O(size of the map).
SphereCell locate(const PlaneTable& planes, const SphereMap& map, SphereDirection direction);

}  // namespace plumb
