// The phase "cross" of an overlay of sphere maps (sphere_overlay.h): every place where two maps
// meet; and the limits that an overlay of large maps observes. Internal to engine/sphere.
//
// Main flow of SphereContacts::find():
//  1. make_tables    for small maps: computes the side of each point of one map on each circle of
//                    the other, the only det3 of the phase except those that order points within
//                    one half-circle
//     find_pairs     for large maps: finds pairs of items whose bounds meet (sphere_bounds.h);
//                    signs are then asked one by one
//  2. join_points    makes one of equal points of both maps
//  3. add_points_on  finds points of one map strictly inside arcs of the other
//  4. add_crossings  finds where arcs of different circles cross: both must have the same one of
//                    the two common points of their circles strictly inside, which follows from the
//                    sides of their ends (docs/design/sphere.md, Lemma 1)
// Arcs of one circle need nothing more: where they overlap, ends of one lie inside the other or at
// its ends. Cost: O(n m) for small maps; O((n + m) log(n + m) + pairs) for large ones.
#pragma once

#include <array>
#include <cstdint>
#include <utility>
#include <vector>

#include "plumb/base/context.h"
#include "plumb/sphere/arcs/sphere_arcs.h"

namespace plumb {

/// Charges the memory of one overlay to a context as it grows; frees the charge in the end.
class SphereLimits {
 public:
  explicit SphereLimits(Context& context) : context_(context), memory_(context) {}

  /// Charges the memory of the contacts that have been found so far, and throws the errors of the
  /// Context. To be called every few thousand steps.
  void look(std::uint64_t pairs, std::uint64_t crossings) {
    context_.checkpoint("overlay", 0, 0);
    const std::uint64_t bytes = kBytesPerPair * pairs + kBytesPerCrossing * crossings;
    if (bytes <= charged_) return;
    memory_.add(bytes - charged_, "an overlay of the sphere");
    charged_ = bytes;
  }

 private:
  static constexpr std::uint64_t kBytesPerPair = 16;  // Eight, in arrays that grow by doubling.
  static constexpr std::uint64_t kBytesPerCrossing =
      1200;  // A point, and a piece more of two arcs.

  Context& context_;
  MemoryCharge memory_;
  std::uint64_t charged_ = 0;
};

/// Looks at the limits between two steps. Small overlays have none.
inline void look(SphereLimits* limits) {
  if (limits != nullptr) limits->look(0, 0);
}

/// The points of an overlay. Keeps its memory between calls, except the bounds of large maps.
class SphereContacts {
 public:
  /// A point of the overlay strictly inside an arc of a map.
  struct Stop {
    std::uint32_t arc;    ///< The arc.
    std::uint32_t point;  ///< The point of the overlay.
    CirclePlace place;    ///< The place on the arc's circle.
  };

  /// The number of pairs of items up to which tables are faster than boxes: about 64 arcs with
  /// their points in each map.
  static constexpr std::size_t kMostTabled = 128 * 128;

  /// Whether the number of items is so small that tables are made.
  static bool are_small(const SphereMap& a, const SphereMap& b,
                        std::size_t most_tabled = kMostTabled) {
    return (a.point_count() + a.arc_count()) * (b.point_count() + b.arc_count()) <= most_tabled;
  }

  /// Finds all contacts of two maps. Looks at `limits` where no tables are made, unless it is null.
  void find(const PlaneTable& planes, const SphereMap& a, const SphereMap& b,
            std::size_t most_tabled = kMostTabled, SphereLimits* limits = nullptr);

  /// The points of the overlay: the points of a, then the points that only b has, then crossings.
  std::vector<SphereDirection> direction;
  /// For each point of the overlay the point or arc of each map on which it lies; not valid if it
  /// lies in a face, which is not known here.
  std::vector<std::array<SphereCell, 2>> cell;

  std::array<std::vector<std::uint32_t>, 2> point_of;  ///< The overlay's point of each map's point.
  std::array<std::vector<Stop>, 2> stops;              ///< The stops of each map, in no order.
  bool shares_circles = false;                         ///< Whether the maps have a common circle.

 private:
  using Pair = std::pair<std::uint32_t, std::uint32_t>;
  /// The kinds of pairs of an item of a and an item of b.
  enum PairKind : std::size_t { PointPoint, PointArc, ArcPoint, ArcArc };

  void number_circles(const SphereMap& map, std::size_t k);
  void make_tables();
  void find_pairs();
  template <class Visit>
  void for_each_pair(PairKind kind, Visit visit) const;
  void look_at_limits() const;

  void join_points();
  void add_points_on(std::size_t k);
  void add_crossings();
  void add_crossing(std::uint32_t a, std::uint32_t b, bool is_opposite);
  std::uint32_t add(SphereDirection u, SphereCell in_a, SphereCell in_b);

  Sign side(std::size_t k, std::uint32_t point, std::uint32_t circle) const;
  Sign compute_side(std::size_t k, std::uint32_t point, std::uint32_t circle) const;
  ArcCrossings crossings_of(std::size_t k, std::uint32_t arc, std::uint32_t circle) const;
  ArcCrossings compute_crossings(std::size_t k, std::uint32_t arc, std::uint32_t circle) const;

  const PlaneTable* planes_ = nullptr;
  SphereLimits* limits_ = nullptr;
  std::array<const SphereMap*, 2> map_{};
  std::array<std::vector<PlaneId>, 2> circles_;          // Each circle once, sorted by id.
  std::array<std::vector<std::uint32_t>, 2> circle_of_;  // Index in circles_ for each arc.
  std::vector<std::uint32_t> equal_;  // For each point of b the equal one of a, or kNone.

  bool is_tabled_ = false;
  std::array<std::vector<Sign>, 2> sides_;              // Points of k by circles of the other map.
  std::array<std::vector<ArcCrossings>, 2> crossings_;  // Arcs of k by circles of the other map.
  std::array<std::vector<Pair>, 4> pairs_;              // The pairs of each PairKind.
};

}  // namespace plumb
