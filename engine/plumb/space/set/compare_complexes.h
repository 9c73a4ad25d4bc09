// Do two minimal complexes describe the same set?
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "plumb/base/context.h"
#include "plumb/space/space_complex.h"

namespace plumb {

/// Vertices are matched by the fingerprints of their points; at each the sphere maps must agree. As
/// every item has a vertex in its closure, nothing else can differ. Requires minimal complexes.
/// Expected O(n) besides merging tables.
bool is_same(const SpaceComplex& a, const SpaceComplex& b);

/// Are the arrays equal, and what the tables say of planes and points? So they are of sets made in
/// the same way. False says nothing of the sets. O(n) comparisons of numbers, few if it is false.
bool is_identical(const SpaceComplex& a, const SpaceComplex& b);

// New numbers for the items of a minimal complex, which follow from the set alone (canonical.h).
// Internal.

/// Items in their new order, and the new number of each.
template <class Id>
class NewOrder {
 public:
  explicit NewOrder(std::size_t items = 0) : number_(items) { ids_.reserve(items); }

  /// Gives an item the next number.
  void append(Id id) {
    number_[id.value()] = Id(ids_.size());
    ids_.push_back(id);
  }
  bool has(Id id) const { return number_[id.value()].is_valid(); }
  /// The new number; an id that is not valid stays so.
  Id operator()(Id id) const { return id.is_valid() ? number_[id.value()] : id; }
  /// Old ids in the new order.
  const std::vector<Id>& ids() const { return ids_; }

 private:
  std::vector<Id> ids_;
  std::vector<Id> number_;
};

struct CanonicalOrder {
  NewOrder<VertexId> vertices;
  NewOrder<EdgeId> edges;
  NewOrder<FacetId> facets;
  NewOrder<UseId> uses;
  NewOrder<VolumeId> volumes;
  std::vector<UseId>
      cycles;  ///< old ids: where each cycle starts, facet by facet, in the new order

  /// Does the edge run the other way in the new order: not from its lesser vertex?
  bool is_turned(const SpaceComplex& complex, EdgeId e) const {
    const std::size_t h = 2 * std::size_t{e.value()};
    return vertices(complex.origin[h]) > vertices(complex.origin[h + 1]);
  }
  /// The new number of a half-edge.
  HalfedgeId halfedge(const SpaceComplex& complex, HalfedgeId h) const {
    const EdgeId e = SpaceComplex::edge_of(h);
    const bool is_reverse = SpaceComplex::is_reverse(h) != is_turned(complex, e);
    return HalfedgeId(2 * std::size_t{edges(e).value()} + (is_reverse ? 1U : 0U));
  }
};

/// Requires a minimal complex. O(n log n).
CanonicalOrder canonical_order(const SpaceComplex& complex, Context& context);

}  // namespace plumb
