// Whether two minimal complexes describe the same set, and new numbers for cells that follow from
// the set alone (canonical.h). Internal.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "plumb/base/context.h"
#include "plumb/space/space_complex.h"

namespace plumb {

/// Whether two complexes describe the same set. Vertices are matched by the fingerprints of their
/// points; at each the sphere maps must agree. As every cell has a vertex in its closure, nothing
/// else can differ. Requires minimal complexes. Expected O(n), besides merging tables.
bool is_same(const SpaceComplex& a, const SpaceComplex& b);

/// Whether the arrays are equal, and what the tables say of planes and points. Sets that were made
/// in the same way have equal arrays. If the result is false, the sets may still be equal. O(n)
/// comparisons of numbers, few if it is false.
bool is_identical(const SpaceComplex& a, const SpaceComplex& b);

// The canonical order of cells.

/// Cells of one kind in their new order, and the new number of each.
template <class Id>
class NewOrder {
 public:
  /// Starts the order of so many cells.
  explicit NewOrder(std::size_t items = 0) : number_(items) { ids_.reserve(items); }

  /// Gives a cell the next number.
  void append(Id id) {
    number_[id.value()] = Id(ids_.size());
    ids_.push_back(id);
  }
  /// Whether the cell has a number.
  bool has(Id id) const { return number_[id.value()].is_valid(); }
  /// Returns the new number; an invalid id stays invalid.
  Id operator()(Id id) const { return id.is_valid() ? number_[id.value()] : id; }
  /// Returns the old ids in the new order.
  const std::vector<Id>& ids() const { return ids_; }

 private:
  std::vector<Id> ids_;
  std::vector<Id> number_;
};

/// New numbers for all cells of a minimal complex. They depend on the set alone.
struct CanonicalOrder {
  NewOrder<VertexId> vertices;  ///< They are sorted lexicographically by their points.
  NewOrder<EdgeId> edges;       ///< They are sorted by their vertices, the lesser one first.
  NewOrder<FacetId> facets;     ///< They are sorted by their least corners.
  NewOrder<UseId> uses;         ///< They come facet by facet, along the cycles.
  NewOrder<VolumeId> volumes;   ///< They come by first appearance at facets, edges, vertices.
  /// The use at which each cycle starts, by its old id; facet by facet, in the new order.
  std::vector<UseId> cycles;

  /// Whether half-edge 2e does not start at the lesser vertex, so that it becomes an odd one.
  bool is_turned(const SpaceComplex& complex, EdgeId e) const {
    const std::size_t h = 2 * std::size_t{e.value()};
    return vertices(complex.origin[h]) > vertices(complex.origin[h + 1]);
  }
  /// Returns the new number of a half-edge.
  HalfedgeId halfedge(const SpaceComplex& complex, HalfedgeId h) const {
    const EdgeId e = SpaceComplex::edge_of(h);
    const bool is_reverse = SpaceComplex::is_reverse(h) != is_turned(complex, e);
    return HalfedgeId(2 * std::size_t{edges(e).value()} + (is_reverse ? 1U : 0U));
  }
};

/// Returns the canonical order of a complex. Requires a minimal complex. O(n log n) comparisons of
/// points.
CanonicalOrder canonical_order(const SpaceComplex& complex, Context& context);

}  // namespace plumb
