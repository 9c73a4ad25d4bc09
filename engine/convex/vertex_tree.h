// Vertices of a complex in boxes: is there one strictly on a side of a plane?
#pragma once

#include <span>
#include <vector>

#include "plumb/base/box_tree.h"
#include "plumb/space/space_complex.h"

namespace plumb {

/// Built in O(n log n). A query looks at the boxes that the plane may leave a part of on that side: O(log n)
/// for a face of a convex surface, early out when many vertices qualify.
class VertexTree {
 public:
  VertexTree(const SpaceComplex& complex, std::vector<VertexId> vertices);

  /// Some vertex strictly on that side; not valid: none.
  VertexId find(PlaneId plane, Sign side) const;

 private:
  static constexpr std::size_t kLeaf = 8;

  void build(std::size_t begin, std::size_t end, std::size_t node);
  VertexId find(PlaneId plane, Sign side, std::size_t begin, std::size_t end,
                std::size_t node) const;
  bool can_hold(PlaneId plane, Sign side, const Box3& box) const;

  const SpaceComplex& c_;
  std::vector<VertexId> vertices_;
  std::vector<Box3> boxes_;  // of a full binary tree; node i has 2i + 1 and 2i + 2
};

}  // namespace plumb
