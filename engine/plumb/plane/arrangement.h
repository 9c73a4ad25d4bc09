// The arrangement of curves. A curve is a segment, a ray or a line. The arrangement consists of the
// vertices, edges and faces into which the curves divide the plane. For each edge, the arrangement
// records which curves contain the edge.
//
// Main flow of arrange():
//  1. in_sweep_order  renumbers points and curves in the order of the sweep, so that memory is read
//                     in sequence. This step is omitted if a coordinate of a point is not a double
//                     (arrangement.cpp).
//  2. sweep           visits all events in one exact sweep (sweep.h, docs/design/sweep.md)
//  3. PlaneBuilder    makes an edge for each part of a curve between two vertices, and replaces the
//                     new indices of points and curves by their indices in the input
//  4. PlaneAssembler  traces the boundaries of the faces, and finds the face that contains each
//                     connected component
//
// Cost: O((n + k) log n) for n curves and k crossings. This bound also holds if curves overlap. For
// example, suppose that n segments on one line contain each other, like the intervals [-i, i]. Then
// there are about n^2 pairs of an edge and a curve that contains it. The bound O((n + k) log n)
// holds all the same, because the class SegmentSets does not store each pair separately.
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

/// A family of sets of curves that share memory. An arrangement has one such set for each edge.
/// This set contains the curves that run along the edge. The sets are persistent balanced trees
/// (treaps: R. Seidel, C. R. Aragon, Randomized search trees, Algorithmica 16, 1996).
///
/// An id (Set) names a set. There are three forms of ids:
///   - An id less than the number of curves names the set that consists of this one curve.
///   - The invalid id names the empty set.
///   - Any other id names the root of a treap, whose nodes never change.
/// Adding or removing a curve makes a new set and leaves the old set unchanged. The new set has new
/// nodes only on the path from the root to the added or removed node. It shares all other nodes
/// with the old set. The priority of a curve in a treap is a hash of the index of the curve. So the
/// shape of a treap depends only on its curves, and not on the order in which they were added.
///
/// Several steps, each of which adds or removes one curve, may be joined to one change
/// (begin_change()). A step may overwrite nodes that earlier steps of the same change made. So a
/// set of m curves that is built in one change takes at most m nodes, but the intermediate sets of
/// the change are lost.
///
/// Cost: a step that changes a set of m curves takes expected O(log m) time and makes expected
/// O(log m) nodes. A set of one curve needs no node.
class SegmentSets {
 public:
  /// The id of a set. The invalid id stands for the empty set.
  using Set = StrongId<struct SegmentSetTag>;
  /// Memory of a node in bytes. A node has 12 bytes. The array of nodes grows by doubling, so up to
  /// 24 bytes are allocated for each node.
  static constexpr std::size_t kBytesPerNode = 24;

  SegmentSets() = default;  ///< Makes a family of sets over no curves.
  /// Makes a family of sets over the curves 0, ..., curve_count - 1.
  explicit SegmentSets(std::size_t curve_count) : curves_(curve_count) {}

  /// Starts a change, which lasts until the next call of begin_change(). Each call of with() or
  /// without() is a step of the change. The first step may start from any valid set. Every later
  /// step must start from the result of the previous step. After the change, only the result of its
  /// last step is valid. All sets that were valid before the change stay valid.
  void begin_change();
  /// Returns the set with s added. Requires that s is not in the set. Throws Error{ResourceLimit}
  /// if the number of nodes exceeds the range of 32-bit ids.
  Set with(Set set, SegmentId s);
  /// Returns the set with s removed. Requires that s is in the set. Throws as with() does.
  Set without(Set set, SegmentId s);

  /// Appends the curves of the set to `curves`, in ascending order. Cost: O(size of the set).
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
  /// Whether the current change made the root node of the set.
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
  // All nodes from this index on were made by the current change.
  std::size_t own_from_ = std::numeric_limits<std::size_t>::max();
  Set free_;  // First free node of the current change. `left` links the free nodes to a list.
};

// --- arrangements -----------------------------------------------------------------------------

/// The subdivision of the plane by curves.
struct Arrangement {
  /// The subdivision. No cell is marked. The subdivision need not be minimal, because every end
  /// point of a curve is a vertex. This holds even for an end point in the interior of another
  /// curve on the same line.
  PlaneComplex complex;
  SegmentSets origin_sets;  ///< Sets of curves, shared by all edges.
  /// For each edge that is not a frame edge (plane_complex.h), the set of the curves that contain
  /// the edge. The set belongs to origin_sets.
  std::vector<SegmentSets::Set> origins;

  /// Returns the curves that contain edge e, in ascending order. Requires that e is not a frame
  /// edge. Cost: O(number of these curves).
  std::vector<SegmentId> origins_of(EdgeId e) const {
    std::vector<SegmentId> curves;
    origin_sets.append(origins[e.value()], curves);
    return curves;
  }
};

/// Returns the arrangement of curves and points. `isolated` contains indices of points that become
/// vertices even if no curve meets them. Curves of length zero become vertices, too. The members
/// `a` and `b` of a SweepCurve are two input points that define its line, and `from` and `to` are
/// its ends. Requires that each bounded end lies on this line. Throws:
///   - Error{BadIndex} if an index is not the index of a point, or if a or b of a curve is not the
///     index of an input point
///   - ResourceLimit if a limit of the Context is exceeded, and Cancelled if a stop is requested
Arrangement arrange(const PlanePoints& points, std::span<const SweepCurve> curves,
                    std::span<const std::uint32_t> isolated,
                    Context& context = unlimited_context());

/// Returns the arrangement of segments between input points. Segments of length zero become
/// vertices. A point that is not the end of a segment becomes a vertex only if a segment passes
/// through it. The requirements and errors are the same as for the function above.
Arrangement arrange(PointTable2 points, std::span<const SweepSegment> segments,
                    Context& context = unlimited_context());

}  // namespace plumb
#pragma GCC visibility pop
