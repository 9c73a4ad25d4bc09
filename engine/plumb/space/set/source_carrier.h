// Hands the sources of sets from operands to results. Internal.
#pragma once

#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "plumb/space/nef3.h"
#include "plumb/space/source_mesh.h"

namespace plumb {

/// What is done with lists of sources. A null list means that there are none.
struct SourceLists {
  using List = std::shared_ptr<const std::vector<PlacedSource>>;  ///< The list of a set.

  /// Returns the sources of the first list, followed by the sources of the second list that are not
  /// in the first list.
  static List joined(const List& first, const List& second);
  /// Returns the sources of sets in their order.
  static List joined(std::span<const Nef3> sets);
  /// Returns the list after a map has been applied to the set.
  static List mapped(const List& list, const AffineMap3& map);
};

/// Reads and sets the sources of a set. nef3.h, which names this struct as a friend, gives it the
/// visibility of what it exports; what is compiled in a file of its own is therefore in the base.
struct SourceCarrier : SourceLists {
  /// Returns the list of a set.
  static const List& of(const Nef3& set) { return set.sources_; }
  /// Returns the set with another list.
  static Nef3 put(List list, Nef3 set) {
    set.sources_ = std::move(list);
    return set;
  }
};

}  // namespace plumb
