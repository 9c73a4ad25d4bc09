// Sets of curves that grow and shrink by one at a time and share what they have in common.
//
// Notation: a set is a number. Below the number of curves it is that one curve; an invalid one is the
// empty set; the others are roots of treaps whose nodes are never changed: a new set has new nodes on the
// path to the change, and all others of the old one. The priority of a curve is a hash of its
// number, so a set has one shape, however it came about.
//
// Within one change of several steps (begin_change) the nodes it has made itself are used again: the
// sets between its steps are lost, and a set of m built in one change takes m nodes.
//
// Cost: expected O(log m) time and nodes for a change of a set of m; a set of one costs no memory.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "plumb/base/ids.h"

#pragma GCC visibility push(default)
namespace plumb {

class SegmentSets {
 public:
  using Set = StrongId<struct SegmentSetTag>;
  static constexpr std::size_t kBytesPerNode = 24;  ///< 12, in an array that grows by doubling

  SegmentSets() = default;
  explicit SegmentSets(std::size_t curve_count) : curves_(curve_count) {}

  /// Starts a change: of the sets that with() and without() return until the next one only the
  /// last is kept, and each step has to go on from the one before. Before the first change all are
  /// kept.
  void begin_change();
  /// Requires that s is not in the set.
  Set with(Set set, SegmentId s);
  /// Requires that s is in the set.
  Set without(Set set, SegmentId s);

  /// Appends the curves of the set, ascending. O(their number).
  void append(Set set, std::vector<SegmentId>& curves) const;

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
  /// Made by the change at hand?
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
  // Nodes from here on are of the change at hand.
  std::size_t own_from_ = std::numeric_limits<std::size_t>::max();
  Set free_;  // a node of it that is free; a list by `left`
};

}  // namespace plumb
#pragma GCC visibility pop
