// The arrangement of segments, rays and lines: every vertex, edge and face into which they divide
// the plane, and for each edge the set of curves that it is part of.
//
// Main flow of arrange():
//  1. in_sweep_order  renumbers points and curves along the sweep, for locality, if all points are
//                     doubles (arrangement.cpp)
//  2. sweep           visits all events in one exact sweep (sweep.h, docs/design/sweep.md)
//  3. PlaneBuilder    keeps every part of a curve and restores the numbers of the input
//  4. PlaneAssembler  traces the boundaries and nests components
//
// Cost: O((n + k) log n) for n curves and k crossings, overlaps included: the edges of n nested
// segments on one line come from n^2 curves in all, but their sets share memory (SegmentSets).
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "plumb/base/context.h"
#include "plumb/base/ids.h"
#include "plumb/plane/plane_complex.h"
#include "plumb/plane/sweep/sweep.h"

#pragma GCC visibility push(default)
namespace plumb {

// --- sets of curves ---------------------------------------------------------------------------

/// Sets of curves that share memory, as persistent balanced trees (treaps: R. Seidel, C. R. Aragon,
/// Randomized search trees, Algorithmica 16, 1996). They record which curves each edge of an
/// arrangement is part of.
///
/// A set is a number. A number less than the number of curves is the set of that one curve; an
/// invalid one is the empty set; the others are roots of treaps whose nodes never change. A changed
/// set has new nodes on the path to the change and shares all others with the old set. The priority
/// of a curve is a hash of its number, so the shape of a set does not depend on how it was made.
///
/// Within one change of several steps (begin_change()), nodes that the change itself made are
/// reused: the sets between its steps are lost, and a set of m curves built in one change takes
/// at most m nodes.
///
/// Cost: expected O(log m) time and nodes to change a set of m curves; a set of one curve takes no
/// memory.
class SegmentSets {
 public:
  /// The number of a set. An invalid one is the empty set.
  using Set = StrongId<struct SegmentSetTag>;
  /// Memory of a node in bytes: 12, times 2 for an array that grows by doubling.
  static constexpr std::size_t kBytesPerNode = 24;

  SegmentSets() = default;  ///< Makes a family of sets over no curves.
  /// Makes a family of sets over the curves 0, ..., curve_count - 1.
  explicit SegmentSets(std::size_t curve_count) : curves_(curve_count) {}

  /// Starts a change. Of the sets that with() and without() return until the next change starts,
  /// only the last one stays valid, and each step must start from the result of the step before.
  /// Before the first change all sets stay valid.
  void begin_change();
  /// Returns the set with s added. Requires that s is not in the set. Throws Error{ResourceLimit}
  /// if the nodes exceed ids of 32 bits.
  Set with(Set set, SegmentId s);
  /// Returns the set with s removed. Requires that s is in the set. Errors as with().
  Set without(Set set, SegmentId s);

  /// Appends the curves of the set to `curves`, ascending. O(size of the set).
  void append(Set set, std::vector<SegmentId>& curves) const;

  /// Returns the number of nodes of all sets together.
  std::size_t node_count() const { return nodes_.size(); }

 private:
  struct Node {
    SegmentId key;
    Set left;
    Set right;
  };
  struct Halves {
    Set less;
    Set greater;
  };

  bool is_one(Set set) const { return set.value() < curves_; }
  /// Whether the node was made by the current change.
  bool is_own(Set set) const { return !is_one(set) && set.value() - curves_ >= own_from_; }
  Node& node(Set set) { return nodes_[set.value() - curves_]; }
  const Node& node(Set set) const { return nodes_[set.value() - curves_]; }
  SegmentId key(Set set) const { return is_one(set) ? SegmentId(set.value()) : node(set).key; }
  Set left(Set set) const { return is_one(set) ? Set() : node(set).left; }
  Set right(Set set) const { return is_one(set) ? Set() : node(set).right; }
  Set make(SegmentId key, Set left, Set right);
  Set with_halves(Set set, Set left, Set right);
  void release(Set set);
  Halves split(Set set, SegmentId at);
  Set join(Set less, Set greater);

  std::size_t curves_ = 0;
  std::vector<Node> nodes_;
  // Nodes from this index on were made by the current change.
  std::size_t own_from_ = std::numeric_limits<std::size_t>::max();
  Set free_;  // First node of the current change that is free; the free ones are linked by `left`.
};

// --- arrangements -----------------------------------------------------------------------------

/// The subdivision of the plane by curves.
struct Arrangement {
  /// The subdivision. No cell is marked. It is not minimal: an end point of a curve in the interior
  /// of another one is a vertex.
  PlaneComplex complex;
  SegmentSets origin_sets;  ///< Sets of curves, shared by all edges.
  /// For each ordinary edge, the curves that it is part of: a set of origin_sets.
  std::vector<SegmentSets::Set> origins;

  /// Returns the curves that an edge is part of, ascending. Requires that e is an ordinary edge.
  /// O(number of these curves).
  std::vector<SegmentId> origins_of(EdgeId e) const {
    std::vector<SegmentId> curves;
    origin_sets.append(origins[e.value()], curves);
    return curves;
  }
};

/// Returns the arrangement of curves and points. `isolated` holds indices of points that become
/// vertices even if no curve meets them, as do curves of length zero. Requires that the indices of
/// curves are in range and the ends of a curve lie on its line (SweepCurve). Throws ResourceLimit
/// and Cancelled as the Context demands.
Arrangement arrange(const PlanePoints& points, std::span<const SweepCurve> curves,
                    std::span<const std::uint32_t> isolated,
                    Context& context = unlimited_context());

/// Returns the arrangement of segments between input points. Segments of length zero become
/// vertices. Requirements and errors as above.
Arrangement arrange(PointTable2 points, std::span<const SweepSegment> segments,
                    Context& context = unlimited_context());

}  // namespace plumb
#pragma GCC visibility pop
