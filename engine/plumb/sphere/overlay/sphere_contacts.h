// What an overlay of large sphere maps may use. Internal to engine/sphere.
#pragma once

#include <array>
#include <cstdint>
#include <utility>
#include <vector>

#include "plumb/base/context.h"
#include "plumb/sphere/arcs/sphere_arcs.h"

namespace plumb {

/// Charges one overlay as it grows, up to its end.
class SphereLimits {
 public:
  explicit SphereLimits(Context& context) : context_(context), memory_(context) {}

  /// Call every few thousand steps, with what has been found so far.
  void look(std::uint64_t pairs, std::uint64_t crossings) {
    context_.checkpoint("overlay", 0, 0);
    const std::uint64_t bytes = kBytesPerPair * pairs + kBytesPerCrossing * crossings;
    if (bytes <= charged_) return;
    memory_.add(bytes - charged_, "an overlay of the sphere");
    charged_ = bytes;
  }

 private:
  static constexpr std::uint64_t kBytesPerPair = 16;        // eight, in arrays that double
  static constexpr std::uint64_t kBytesPerCrossing = 1200;  // a point and a piece more of two arcs

  Context& context_;
  MemoryCharge memory_;
  std::uint64_t charged_ = 0;
};

/// Between two steps; nothing where an overlay is so small that there are no limits.
inline void look(SphereLimits* limits) {
  if (limits != nullptr) limits->look(0, 0);
}

// Phase "cross" of an overlay: every place where two maps meet. Internal to engine/sphere.
//
// Main flow of find():
//  1. make_tables    small maps: each point of one map against each circle of the other; these are
//                    the only det3 of the phase but those that order points within one half-circle
//     find_pairs     large maps: pairs of items whose bounds meet (sphere_bounds.h); signs are then
//                    asked one by one
//  2. join_points    equal points of both maps become one
//  3. add_points_on  points of one map strictly inside arcs of the other
//  4. add_crossings  arcs of different circles: both must hold the same one of the two points of
//                    their circles strictly inside, which the sides of their ends tell
// Arcs of one circle need nothing more: where they overlap, ends of one lie inside the other.
// Cost: O(n m) for small maps; O((n + m) log(n + m) + pairs) for large ones.

/// Keeps its memory between calls, but for the bounds of large maps.
class SphereContacts {
 public:
  /// A point strictly inside an arc.
  struct Stop {
    std::uint32_t arc;
    std::uint32_t point;  ///< of the overlay
    CirclePlace place;    ///< on the arc's circle
  };

  /// Pairs of items up to which tables are faster than boxes: about 64 arcs with their points each.
  static constexpr std::size_t kMostTabled = 128 * 128;

  /// Are there so few items that tables are made?
  static bool are_small(const SphereMap& a, const SphereMap& b,
                        std::size_t most_tabled = kMostTabled) {
    return (a.point_count() + a.arc_count()) * (b.point_count() + b.arc_count()) <= most_tabled;
  }

  /// `limits` are looked at where no tables are made; may be null.
  void find(const PlaneTable& planes, const SphereMap& a, const SphereMap& b,
            std::size_t most_tabled = kMostTabled, SphereLimits* limits = nullptr);

  // Per point of the overlay: those of a, those of b only, crossings.
  std::vector<SphereDirection> direction;
  /// The point or arc of each map it lies in or on; not valid: in a face, not said which.
  std::vector<std::array<SphereCell, 2>> cell;

  std::array<std::vector<std::uint32_t>, 2> point_of;  ///< per point of each map: of the overlay
  std::array<std::vector<Stop>, 2> stops;              ///< in no order
  bool shares_circles = false;

 private:
  using Pair = std::pair<std::uint32_t, std::uint32_t>;
  /// Kinds of pairs: an item of a, an item of b.
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
  std::array<std::vector<PlaneId>, 2> circles_;          // each once, by id
  std::array<std::vector<std::uint32_t>, 2> circle_of_;  // per arc: into circles_
  std::vector<std::uint32_t> equal_;                     // per point of b: that of a, or kNone

  bool is_tabled_ = false;
  std::array<std::vector<Sign>, 2> sides_;              // points of k x circles of the other
  std::array<std::vector<ArcCrossings>, 2> crossings_;  // arcs of k x circles of the other
  std::array<std::vector<Pair>, 4> pairs_;              // per PairKind
};

}  // namespace plumb
