#include "plumb/plane/sweep_members.h"

namespace plumb {

void SweepMembers::update(const SweepEvent& event) {
  list_incoming(event);
  list_outgoing(event);
}

void SweepMembers::list_incoming(const SweepEvent& event) {
  incoming_.clear();
  begin_.assign(1, 0);
  for (std::size_t i = 0; i < event.incoming.size(); ++i) {
    const SegmentId head = head_[event.incoming[i].value()];
    for (SegmentId s = head.is_valid() ? head : event.incoming[i]; s.is_valid();
         s = next_[s.value()]) {
      incoming_.push_back({s, static_cast<std::uint32_t>(i)});
    }
    begin_.push_back(incoming_.size());
  }
  for (const SegmentId s : event.ends) is_ended_[s.value()] = 1;
}

void SweepMembers::list_outgoing(const SweepEvent& event) {
  outgoing_.clear();
  for (std::size_t i = 0; i < event.outgoing.size(); ++i) {
    const auto bundle = static_cast<std::uint32_t>(i);
    const std::size_t first = outgoing_.size();
    if (const std::uint32_t in = event.came_from(i); in != SweepEvent::kNew) {
      for (std::size_t k = begin_[in]; k < begin_[in + 1]; ++k) {
        const SegmentId s = incoming_[k].segment;
        if (is_ended_[s.value()] == 0) outgoing_.push_back({s, bundle});
      }
    }
    for (const SegmentId s : event.starting_in(i)) outgoing_.push_back({s, bundle});
    head_[event.outgoing[i].value()] = outgoing_[first].segment;
    for (std::size_t k = first; k < outgoing_.size(); ++k) {
      const bool is_last = k + 1 == outgoing_.size();
      next_[outgoing_[k].segment.value()] = is_last ? SegmentId() : outgoing_[k + 1].segment;
    }
  }
}

}  // namespace plumb
