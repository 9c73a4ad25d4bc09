// The sweep over the edges of a map: contacts of edges, and the rotation system.
//
// A pair of edges is counted at the first point that both edges have in common. It is not counted
// at an event where it arrives in one bundle, because it was counted before. It is not counted at a
// common vertex, unless it leaves the vertex in one bundle. The number of pairs at an event may be
// quadratic in the edges there, so pairs are counted by sorting: all pairs less the legal ones.
// Only the pairs that are described are examined one by one.
//
// Without contacts, the order of incoming and outgoing edges at each event is the rotation system,
// and the edge below the first vertex of a component says where that component lies.
// docs/design/sweep.md proves the sweep, docs/maps.md describes the check.
//
// Tested by tests/plane/map_check_test.cpp and tests/plane/map_check_property_test.cpp.

#include "plumb/plane/check/map_contacts.h"

#include <algorithm>
#include <span>
#include <tuple>
#include <utility>

#include "plumb/plane/sweep/sweep_curves.h"

namespace plumb {
namespace {

constexpr std::size_t kMembersPerCheckpoint = std::size_t{1} << 16U;

std::uint64_t pairs(std::uint64_t n) { return n * (n - 1) / 2; }

// Returns the sum of pairs(length) over the runs of equal keys in a sorted range.
template <class Range, class Key>
std::uint64_t pairs_in_runs(const Range& sorted, const Key& key) {
  std::uint64_t sum = 0;
  std::uint64_t run = 0;
  for (std::size_t i = 0; i < sorted.size(); ++i) {
    run = i > 0 && key(sorted[i]) == key(sorted[i - 1]) ? run + 1 : 1;
    sum += run - 1;
  }
  return sum;
}

// An edge at an event that is not plain.
struct Member {
  std::uint32_t edge;
  std::uint32_t incoming;  // The bundle with which it arrives, or kNone.
  std::uint32_t outgoing;  // The bundle with which it leaves, or kNone.
  std::uint32_t vertex;    // Its end point here, or kNone if it passes through.
  std::uint32_t second;    // The other end point of a zero-length edge, or kNone.
};

// An end point at the event, and its edge.
struct EndHere {
  std::uint32_t vertex;
  std::uint32_t incoming;
  std::uint32_t outgoing;
};

bool share_bundle(std::uint32_t p, std::uint32_t q) { return p == q && p != kNone; }

bool share_vertex(const Member& p, const Member& q) {
  return share_bundle(p.vertex, q.vertex) || share_bundle(p.vertex, q.second) ||
         share_bundle(p.second, q.vertex) || share_bundle(p.second, q.second);
}

// Whether a pair is reported at this event, that is, whether this event is the first common point.
// A pair that arrives in one bundle was reported before. A pair with a common vertex here is legal
// unless it leaves in one bundle.
bool is_told_here(const Member& p, const Member& q) {
  if (share_bundle(p.incoming, q.incoming)) return false;
  return share_bundle(p.outgoing, q.outgoing) || !share_vertex(p, q);
}

EdgeContact::Kind kind_of(const Member& p, const Member& q) {
  if (share_bundle(p.outgoing, q.outgoing)) return EdgeContact::Kind::Overlap;
  const int vertices = static_cast<int>(p.vertex != kNone) + static_cast<int>(q.vertex != kNone);
  if (vertices == 2) return EdgeContact::Kind::Alias;
  return vertices == 1 ? EdgeContact::Kind::Touch : EdgeContact::Kind::Cross;
}

class ContactCollector final : public SweepVisitor {
 public:
  ContactCollector(const MapEdges& edges, const MapComponents& components,
                   std::uint64_t max_described, MapContacts& result, Context& context)
      : edges_(edges),
        components_(components),
        max_described_(max_described),
        result_(result),
        context_(context),
        memory_(context),
        at_event_(charged(edges.ends.size())) {
    result_.rotation.orbit_next.assign(edges.halfedge_count(), kNone);
    result_.rotation.order.assign(components.of_vertex.size(), kNone);
    result_.rotation.edge_below.assign(components.count, kNone);
    is_placed_.assign(components.count, 0);
  }

  bool on_event(const SweepEvent& event) override {
    for (const std::uint32_t v : event.points) result_.rotation.order[v] = events_;
    if (!event.plain) collect_contacts(event);
    for (const std::uint32_t v : event.points) place_component(event, v);
    if (result_.count == 0) {
      for (const std::uint32_t v : event.points) link_around(event, v);
    }
    ++events_;
    return true;
  }

 private:
  void place_component(const SweepEvent& event, std::uint32_t v);
  void link_around(const SweepEvent& event, std::uint32_t v);

  std::size_t charged(std::size_t edge_count) {
    memory_.add(edge_count * SweepMembers::kBytesPerCurve, "contacts of edges");
    return edge_count;
  }
  void collect_contacts(const SweepEvent& event);
  void look_at_limits();
  void gather_members(const SweepEvent& event);
  void gather_ends();
  std::uint64_t count_contacts();
  template <class Bundle>
  std::uint64_t pairs_with_common_end(const Bundle& bundle);
  void describe_contacts(const SweepEvent& event);
  void describe_across_vertices(const SweepEvent& event);
  void describe_overlaps(const SweepEvent& event);
  void describe_zero_length(const SweepEvent& event);
  void describe_pair(const SweepEvent& event, const Member& p, const Member& q);
  void note_vertices_on_edges(const SweepEvent& event);

  bool is_here(std::uint32_t v) const { return result_.rotation.order[v] == events_; }
  bool is_full() const { return result_.described.size() >= max_described_; }

  const MapEdges& edges_;
  const MapComponents& components_;
  std::uint64_t max_described_;
  MapContacts& result_;
  Context& context_;
  MemoryCharge memory_;
  std::uint32_t events_ = 0;
  std::size_t members_since_checkpoint_ = 0;
  std::vector<char> is_placed_;      // Whether the first vertex of each component has been reached.
  std::vector<std::uint32_t> ring_;  // Half-edges that leave a vertex, counter-clockwise.
  SweepMembers at_event_;
  std::vector<Member> members_;
  std::vector<EndHere> ends_;  // Sorted by vertex.
};

// ---------------------------------------------------------------- rotation system

void ContactCollector::place_component(const SweepEvent& event, std::uint32_t v) {
  const std::uint32_t component = components_.of_vertex[v];
  if (is_placed_[component] != 0) return;
  is_placed_[component] = 1;
  if (event.below.is_valid()) result_.rotation.edge_below[component] = event.below.value();
}

// Links the half-edges at a vertex counter-clockwise from straight down: first the outgoing edges
// from bottom to top, then the incoming edges from top to bottom. Zero-length edges have no
// direction, and may have any place in this order.
void ContactCollector::link_around(const SweepEvent& event, std::uint32_t v) {
  ring_.clear();
  const auto add = [&](SegmentId s) {
    const SweepSegment& e = edges_.ends[s.value()];
    if (e.from == v) ring_.push_back(2 * s.value());
    if (e.to == v) ring_.push_back(2 * s.value() + 1);
  };
  for (const SegmentId s : event.starts) add(s);
  for (auto s = event.ends.rbegin(); s != event.ends.rend(); ++s) add(*s);
  for (const SegmentId s : event.zero_length) add(s);
  for (std::size_t i = 0; i < ring_.size(); ++i) {
    const std::uint32_t after = ring_[i + 1 == ring_.size() ? 0 : i + 1];
    result_.rotation.orbit_next[after ^ 1U] = ring_[i];
  }
}

// ---------------------------------------------------------------- counting

void ContactCollector::collect_contacts(const SweepEvent& event) {
  gather_members(event);
  look_at_limits();
  gather_ends();
  const std::uint64_t found = count_contacts();
  result_.count += found;
  if (found == 0) return;
  if (!is_full()) describe_contacts(event);
  note_vertices_on_edges(event);
}

// The sweep counts events, but a bundle of one event may contain every edge of the map.
void ContactCollector::look_at_limits() {
  members_since_checkpoint_ += members_.size();
  if (members_since_checkpoint_ < kMembersPerCheckpoint) return;
  members_since_checkpoint_ = 0;
  context_.checkpoint("sweep", events_,
                      std::max<std::uint64_t>(events_, components_.of_vertex.size()));
}

// Collects the edges at an event, one entry for each, sorted by edge.
void ContactCollector::gather_members(const SweepEvent& event) {
  members_.clear();
  const auto add = [&](SegmentId s, std::uint32_t incoming, std::uint32_t outgoing) {
    const SweepSegment& e = edges_.ends[s.value()];
    const bool from_here = is_here(e.from);
    const bool to_here = is_here(e.to);
    const std::uint32_t vertex = from_here ? e.from : (to_here ? e.to : kNone);
    members_.push_back(
        {s.value(), incoming, outgoing, vertex, from_here && to_here ? e.to : kNone});
  };
  at_event_.update(event);
  for (const SweepIncidence& i : at_event_.incoming()) add(i.segment, i.bundle, kNone);
  for (const SweepIncidence& i : at_event_.outgoing()) add(i.segment, kNone, i.bundle);
  for (const SegmentId s : event.zero_length) add(s, kNone, kNone);
  // An edge that passes through has two entries, the arriving one first, as kNone is the greatest
  // number. They are joined.
  std::sort(members_.begin(), members_.end(), [](const Member& p, const Member& q) {
    return std::tie(p.edge, p.incoming) < std::tie(q.edge, q.incoming);
  });
  std::size_t kept = 0;
  for (const Member& m : members_) {
    if (kept > 0 && members_[kept - 1].edge == m.edge) {
      members_[kept - 1].outgoing = m.outgoing;
    } else {
      members_[kept++] = m;
    }
  }
  members_.resize(kept);
}

void ContactCollector::gather_ends() {
  ends_.clear();
  for (const Member& m : members_) {
    if (m.vertex != kNone) ends_.push_back({m.vertex, m.incoming, m.outgoing});
    if (m.second != kNone) ends_.push_back({m.second, m.incoming, m.outgoing});
  }
}

// Returns the number of pairs for which is_told_here() holds, by counting the other pairs. Two
// edges have at most one common vertex, so the pairs with a common vertex and no common bundle are
// a sum over vertices.
std::uint64_t ContactCollector::count_contacts() {
  const auto arrival = [](const Member& m) { return m.incoming; };
  std::sort(members_.begin(), members_.end(),
            [&](const Member& p, const Member& q) { return arrival(p) < arrival(q); });
  const auto arriving = std::find_if(members_.begin(), members_.end(),
                                     [](const Member& m) { return m.incoming == kNone; });
  std::uint64_t legal = pairs_in_runs(std::span(members_.begin(), arriving), arrival);
  legal += pairs_with_common_end([](const EndHere&) { return 0U; });
  legal -= pairs_with_common_end([](const EndHere& e) { return e.incoming; });
  legal -= pairs_with_common_end([](const EndHere& e) { return e.outgoing; });
  return pairs(members_.size()) - legal;
}

// Returns the number of pairs of edges that end here in the same vertex and have the same bundle.
// An edge without a bundle (kNone) belongs to no pair.
template <class Bundle>
std::uint64_t ContactCollector::pairs_with_common_end(const Bundle& bundle) {
  const auto key = [&](const EndHere& e) { return std::pair(bundle(e), e.vertex); };
  std::sort(ends_.begin(), ends_.end(),
            [&](const EndHere& p, const EndHere& q) { return key(p) < key(q); });
  const auto last = std::find_if(ends_.begin(), ends_.end(),
                                 [&](const EndHere& e) { return bundle(e) == kNone; });
  return pairs_in_runs(std::span(ends_.begin(), last), key);
}

// ---------------------------------------------------------------- describing

// Describes the same pairs one by one. The legal pairs, of which there may be very many, are not
// visited.
void ContactCollector::describe_contacts(const SweepEvent& event) {
  std::sort(members_.begin(), members_.end(), [](const Member& p, const Member& q) {
    return std::tie(p.second, p.vertex, p.edge) > std::tie(q.second, q.vertex, q.edge);
  });
  describe_across_vertices(event);
  describe_overlaps(event);
  describe_zero_length(event);
}

// Describes pairs without a common vertex. Members without `second` come first, grouped by vertex.
// Each member without a vertex is a group of its own.
void ContactCollector::describe_across_vertices(const SweepEvent& event) {
  std::size_t ordinary = 0;
  while (ordinary < members_.size() && members_[ordinary].second == kNone) ++ordinary;
  std::size_t group_end = 0;
  for (std::size_t i = 0; i < ordinary && !is_full(); ++i) {
    if (members_[i].vertex == kNone) group_end = i + 1;
    while (group_end <= i || (group_end < ordinary && members_[i].vertex != kNone &&
                              members_[group_end].vertex == members_[i].vertex)) {
      ++group_end;
    }
    for (std::size_t j = group_end; j < ordinary && !is_full(); ++j) {
      if (is_told_here(members_[i], members_[j])) describe_pair(event, members_[i], members_[j]);
    }
  }
}

// Describes pairs with a common vertex that leave in one bundle.
void ContactCollector::describe_overlaps(const SweepEvent& event) {
  std::vector<Member> leaving;
  for (const Member& m : members_) {
    if (m.outgoing != kNone && m.vertex != kNone) leaving.push_back(m);
  }
  std::sort(leaving.begin(), leaving.end(), [](const Member& p, const Member& q) {
    return std::tie(p.outgoing, p.vertex, p.edge) < std::tie(q.outgoing, q.vertex, q.edge);
  });
  for (std::size_t i = 0; i < leaving.size(); ++i) {
    for (std::size_t j = i + 1; j < leaving.size() && !is_full(); ++j) {
      if (leaving[j].outgoing != leaving[i].outgoing || leaving[j].vertex != leaving[i].vertex)
        break;
      describe_pair(event, leaving[i], leaving[j]);
    }
  }
}

void ContactCollector::describe_zero_length(const SweepEvent& event) {
  for (std::size_t i = members_.size(); i-- > 0 && members_[i].second != kNone;) {
    for (std::size_t j = 0; j < i && !is_full(); ++j) {
      if (is_told_here(members_[i], members_[j])) describe_pair(event, members_[i], members_[j]);
    }
  }
}

void ContactCollector::describe_pair(const SweepEvent& event, const Member& p, const Member& q) {
  EdgeContact contact;
  contact.kind = kind_of(p, q);
  contact.edge_a = std::min(p.edge, q.edge);
  contact.edge_b = std::max(p.edge, q.edge);
  if (event.crossing != nullptr) {
    contact.crossing = *event.crossing;
  } else {
    const std::uint32_t either = p.vertex != kNone ? p.vertex : q.vertex;
    contact.vertex = either != kNone ? either : event.points.front();
  }
  result_.described.push_back(contact);
}

void ContactCollector::note_vertices_on_edges(const SweepEvent& event) {
  for (const Member& m : members_) {
    if (m.vertex != kNone) continue;
    for (const std::uint32_t v : event.points) {
      if (result_.on_edge.size() >= max_described_) return;
      result_.on_edge.push_back({m.edge, v});
    }
  }
}

}  // namespace

MapContacts find_contacts(const Map& map, const MapEdges& edges, const MapComponents& components,
                          std::uint64_t max_described, Context& context) {
  MapContacts contacts;
  ContactCollector collector(edges, components, max_described, contacts, context);
  sweep(map.points, edges.ends, collector, context);
  std::sort(contacts.described.begin(), contacts.described.end(),
            [](const EdgeContact& p, const EdgeContact& q) {
              return std::tie(p.edge_a, p.edge_b) < std::tie(q.edge_a, q.edge_b);
            });
  std::stable_sort(contacts.on_edge.begin(), contacts.on_edge.end(),
                   [](const VertexOnEdge& p, const VertexOnEdge& q) { return p.edge < q.edge; });
  return contacts;
}

}  // namespace plumb
