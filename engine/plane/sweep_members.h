// All curves of the bundles at an event, for visitors that have to look at every one of them.
//
// An event costs the number of curves there, also of those that pass through in a bundle: of n
// nested segments on one line n^2 / 2 in all. Visitors that can do with what changes at an event
// ask the event itself.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "plumb/plane/sweep.h"

namespace plumb {

/// A curve at an event; curves of equal `bundle` overlap on that side of the event.
struct SweepIncidence {
  SegmentId segment;
  std::uint32_t bundle;  ///< 0, 1, ... from bottom to top
};

class SweepMembers {
 public:
  static constexpr std::size_t kBytesPerCurve = 9;

  explicit SweepMembers(std::size_t curve_count)
      : next_(curve_count), head_(curve_count), is_ended_(curve_count, 0) {}

  /// To be told of every event that is not plain; plain ones may be left out.
  void update(const SweepEvent& event);

  /// Of the last event told: bottom to top.
  std::span<const SweepIncidence> incoming() const { return incoming_; }
  std::span<const SweepIncidence> outgoing() const { return outgoing_; }

 private:
  void list_incoming(const SweepEvent& event);
  void list_outgoing(const SweepEvent& event);

  std::vector<SegmentId> next_;  // per curve: the next one of its bundle
  std::vector<SegmentId> head_;  // per curve that names a bundle: its first; invalid: just itself
  std::vector<char> is_ended_;   // per curve
  std::vector<SweepIncidence> incoming_;
  std::vector<SweepIncidence> outgoing_;
  std::vector<std::size_t> begin_;  // per incoming bundle, into incoming_; and one more
};

}  // namespace plumb
