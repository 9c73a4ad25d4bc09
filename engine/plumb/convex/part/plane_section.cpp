// The section of a piece with a plane T, as directed segments with the section to their left, and
// the component of it that a reflex edge bounds.
//
// In each face that T crosses, chords are found by walking along the line of face and plane:
// events, where the line enters or leaves the face, are sorted along the line and paired. A corner
// on the line is an event if the line continues into the corner's sector. Edges in T contribute a
// segment for each side on which T runs inside the solid. Segments are linked to cycles by taking,
// at each vertex, the next one clockwise; nesting of cycles by exact winding numbers gives the
// outer cycle and the holes of the seed's component.
//
// Invariant: events of a face alternate between start and end, which PLUMB_CHECK asserts. The
// section is refused, and no cut is made, if the surface touches the component in a single point. A
// wall with such a point would touch itself in a vertex that is missing in its boundary. Argument:
// docs/design/walls.md, section Cuts; B. Chazelle, SIAM Journal on Computing 13 (1984). Declared in
// part/surface_cut.h. Tested by tests/convex/cut_surface_test.cpp.
#include <algorithm>
#include <utility>

#include "plumb/convex/part/surface_cut.h"
#include "plumb/predicates/error.h"
#include "plumb/predicates/plane_signs.h"
#include "plumb/predicates/point3_signs.h"
#include "plumb/space/planar/facet_site.h"

namespace plumb {

bool PlaneSection::find(std::span<const FaceId> faces, PlaneId plane, HalfedgeId seed) {
  faces_ = faces;
  plane_ = plane;
  events_.clear();
  segments_.clear();
  puncture_ = {};
  ++stamp_;
  find_sides();
  find_segments();
  link_cycles();
  return select(seed) && !is_punctured();
}

// ---------------------------------------------------------------- sides

/// Computes the side of every vertex of the piece once.
void PlaneSection::find_sides() {
  side_.resize(s_.point.size());
  vertex_stamp_.resize(s_.point.size(), 0);
  zeros_.clear();
  const auto set = [this](VertexId v, Sign sign) {
    if (sign == Sign::Zero && vertex_stamp_[v] != stamp_) zeros_.push_back(v);
    side_[v] = sign;
    vertex_stamp_[v] = stamp_;
  };
  // All corners of faces in T are on T, so their exact signs are not computed.
  for (const FaceId f : faces_) {
    if (s_.face(f).plane.plane() != plane_) continue;
    s_.for_each_half(f, [&](HalfedgeId h) { set(s_.half(h).origin, Sign::Zero); });
  }
  for (const FaceId f : faces_) {
    s_.for_each_half(f, [&](HalfedgeId h) {
      const VertexId v = s_.half(h).origin;
      if (vertex_stamp_[v] == stamp_) return;
      set(v, side(s_.points(), s_.point[v], plane_));
    });
  }
}

// ---------------------------------------------------------------- segments

void PlaneSection::find_segments() {
  half_stamp_.resize(s_.halves.size(), 0);
  crossing_.resize(s_.halves.size());
  for (const FaceId f : faces_) {
    bool is_below = false, is_above = false;
    s_.for_each_half(f, [&](HalfedgeId h) {
      const Sign sign = side_of(s_.half(h).origin);
      is_below |= sign == Sign::Negative;
      is_above |= sign == Sign::Positive;
      if (sign == Sign::Zero && h < s_.half(h).twin && side_of(s_.target(h)) == Sign::Zero) {
        add_edge(h);
      }
    });
    if (is_below && is_above) find_chords(f);
  }
}

/// Finds the events of a face along u, and pairs them to form chords.
void PlaneSection::find_chords(FaceId f) {
  const std::size_t first = events_.size();
  s_.for_each_half(f, [&](HalfedgeId h) {
    const Sign here = side_of(s_.half(h).origin), there = side_of(s_.target(h));
    if (here == Sign::Zero) {
      add_corner(f, h);
    } else if (there != Sign::Zero && there != here) {
      const bool goes_up = here == Sign::Negative;
      events_.push_back({h, crossing(h), true, goes_up, !goes_up, 0, {}});
    }
  });
  pair_events(f, first);
}

/// Returns the class of a direction in a face. Classes are numbered counter-clockwise: 0 along u, 1
/// below T, 2 against u, 3 above T.
std::uint8_t PlaneSection::class_of(FaceId f, HalfedgeId h, VertexId end, bool is_reversed) const {
  const Sign sign = side_of(end);
  if (sign != Sign::Zero) return sign == Sign::Negative ? 1 : 3;
  const OrientedPlane n = s_.face(f).plane;
  const CutSurface::Half& half = s_.half(h);
  Sign along = same_direction(s_.planes(), n.plane(), plane_, n.plane(), half.other) * half.along *
               n.orientation();
  if (is_reversed) along = along * Sign::Negative;
  return along == Sign::Positive ? 0 : 2;
}

// The corner's sector runs counter-clockwise from `out` to `in`. The line starts or ends at the
// corner if u, or its opposite, lies strictly within that sector.
void PlaneSection::add_corner(FaceId f, HalfedgeId h) {
  const CutSurface::Half& half = s_.half(h);
  const HalfedgeId before = half.prev;
  const std::uint8_t out = class_of(f, h, s_.target(h), false);
  const std::uint8_t in = class_of(f, before, s_.half(before).origin, true);
  const auto turn = [out](std::uint8_t to) { return (to + 4U - out) % 4U; };
  unsigned sector = turn(in);
  if (sector == 0 && s_.turn_at(h) != Sign::Positive)
    // At the tip of an edge that ends inside of the face, the sector is a full turn.
    sector = 4;
  const auto holds = [&](std::uint8_t to) { return turn(to) > 0 && turn(to) < sector; };
  const bool starts = holds(0), ends = holds(2);
  if (starts || ends) events_.push_back({h, half.origin, false, starts, ends, out, {}});
}

// At a vertex, the end of a chord precedes the start of the next chord. Up to two events are sorted
// without exact comparisons.
void PlaneSection::pair_events(FaceId f, std::size_t first) {
  const OrientedPlane n = s_.face(f).plane;
  const auto begin = events_.begin() + static_cast<std::ptrdiff_t>(first);
  const auto order = [](const Event& e) { return e.starts ? (e.ends ? 1 : 2) : 0; };
  if (events_.size() - first > 2) {
    std::sort(begin, events_.end(), [&](const Event& a, const Event& b) {
      if (a.vertex != b.vertex) {
        const Sign sign = order_along_line(s_.points(), n.plane(), plane_, s_.point[a.vertex],
                                           s_.point[b.vertex]) *
                          n.orientation();
        if (sign != Sign::Zero) return sign == Sign::Positive;
      }
      return order(a) < order(b);
    });
  } else if (events_.size() - first == 2 && begin->ends) {
    std::swap(begin[0], begin[1]);
  }
  // Chords have the direction u with the lower part on their left. The section has the opposite
  // direction.
  const CirclePlace against_u{n.plane(), n.is_opposite()};
  std::uint32_t open = kNone;
  for (std::size_t i = first; i < events_.size(); ++i) {
    const Event& event = events_[i];
    PLUMB_CHECK(event.ends == (open != kNone));
    if (event.ends) {
      Segment chord{event.vertex,
                    events_[open].vertex,
                    against_u,
                    open,
                    static_cast<std::uint32_t>(i),
                    f,
                    {},
                    kNone,
                    kNone,
                    {},
                    {}};
      segments_.push_back(chord);
      open = kNone;
    }
    if (event.starts) open = static_cast<std::uint32_t>(i);
  }
  PLUMB_CHECK(open == kNone);
}

/// Returns the vertex where the edge of h crosses T. Both half-edges share this vertex.
VertexId PlaneSection::crossing(HalfedgeId h) {
  const HalfedgeId key = std::min(h, s_.half(h).twin);
  if (half_stamp_[key] != stamp_) {
    half_stamp_[key] = stamp_;
    const CutSurface::Half& half = s_.half(key);
    Point3Table& points = s_.tables->points;
    const bool has_line = half.line[0].is_valid();
    crossing_[key] = VertexId(s_.point.size());
    s_.point.push_back(has_line ? points.add(half.line[0], half.line[1], plane_)
                                : points.add(s_.plane_of(key).plane(), half.other, plane_));
  }
  return crossing_[key];
}

Sign PlaneSection::lean(HalfedgeId h) const {
  const OrientedPlane n = s_.plane_of(h);
  if (n.plane() == plane_) return Sign::Zero;
  const CutSurface::Half& half = s_.half(h);
  return same_direction(s_.planes(), n.plane(), half.other, n.plane(), plane_) * half.along *
         n.orientation();
}

/// Adds a segment for each side of the edge on which T is strictly inside of the solid. A direction
/// is inside if it is behind both faces or, at a reflex edge, behind one of them.
void PlaneSection::add_edge(HalfedgeId h) {
  const HalfedgeId t = s_.half(h).twin;
  const Sign first = lean(h), second = lean(t) * Sign::Negative;
  const auto is_inside = [&](Sign behind) {
    return s_.half(h).is_reflex ? first == behind || second == behind
                                : first == behind && second == behind;
  };
  if (is_inside(Sign::Negative)) add_edge_segment(h);
  if (is_inside(Sign::Positive)) add_edge_segment(t);
}

void PlaneSection::add_edge_segment(HalfedgeId h) {
  const CutSurface::Half& half = s_.half(h);
  const PlaneId p = s_.plane_of(h).plane();
  const SphereDirection runs = half.along == Sign::Positive ? SphereDirection{p, half.other}
                                                            : SphereDirection{half.other, p};
  Segment edge{half.origin,
               s_.target(h),
               place_on(s_.planes(), plane_, runs),
               kNone,
               kNone,
               {},
               h,
               kNone,
               kNone,
               {},
               {}};
  segments_.push_back(edge);
}

// ---------------------------------------------------------------- cycles

/// Segments are sorted by the vertices at which they start. Usually, one segment starts at a vertex
/// of the section. If several segments start, the turn on T decides.
void PlaneSection::link_cycles() {
  outgoing_.resize(segments_.size());
  for (std::uint32_t i = 0; i < segments_.size(); ++i) outgoing_[i] = i;
  const auto from = [this](std::uint32_t i) { return segments_[i].from; };
  std::stable_sort(outgoing_.begin(), outgoing_.end(),
                   [&](std::uint32_t a, std::uint32_t b) { return from(a) < from(b); });
  for (Segment& in : segments_) {
    const auto begin = std::lower_bound(outgoing_.begin(), outgoing_.end(), in.to,
                                        [&](std::uint32_t a, VertexId v) { return from(a) < v; });
    auto end = begin;
    while (end != outgoing_.end() && from(*end) == in.to) ++end;
    PLUMB_CHECK(begin != end);
    in.next = end - begin == 1 ? *begin : clockwise_next(in, {begin, end});
  }
  first_of_cycle_.clear();
  for (std::uint32_t i = 0; i < segments_.size(); ++i) {
    if (segments_[i].cycle != kNone) continue;
    const auto cycle = static_cast<std::uint32_t>(first_of_cycle_.size());
    first_of_cycle_.push_back(i);
    for (std::uint32_t j = i; segments_[j].cycle == kNone; j = segments_[j].next) {
      segments_[j].cycle = cycle;
    }
  }
}

/// Returns the next segment of a cycle. The section lies clockwise from the reverse of the segment
/// to the first segment that starts at the vertex.
std::uint32_t PlaneSection::clockwise_next(const Segment& in,
                                           std::span<const std::uint32_t> out) const {
  const CirclePlace back = in.place.opposite();
  std::uint32_t best = out[0];
  for (const std::uint32_t i : out.subspan(1)) {
    if (is_before_on(s_.planes(), plane_, back, segments_[best].place, segments_[i].place)) {
      best = i;
    }
  }
  return best;
}

std::vector<RingSide> PlaneSection::ring_of(std::uint32_t first) const {
  std::vector<RingSide> ring;
  std::uint32_t i = first;
  do {
    const Segment& segment = segments_[i];
    ring.push_back({segment.from, segment.to, segment.place.other, segment.place.sign()});
    i = segment.next;
  } while (i != first);
  return ring;
}

/// Selects the cycle with the seed. If there are several cycles, their nesting must be found to see
/// which belong to the same component.
bool PlaneSection::select(HalfedgeId seed) {
  const HalfedgeId twin = s_.half(seed).twin;
  const auto found = std::find_if(segments_.begin(), segments_.end(), [&](const Segment& segment) {
    return segment.half.is_valid() && (segment.half == seed || segment.half == twin);
  });
  if (found == segments_.end()) return false;
  is_selected_.assign(first_of_cycle_.size(), 0);
  is_selected_[found->cycle] = 1;
  return first_of_cycle_.size() == 1 || select_part(found->cycle);
}

/// Selects the cycle around the seed's component and the holes directly inside of it. Returns false
/// if one ring lies on another, because their nesting is then not clear.
bool PlaneSection::select_part(std::uint32_t seed_cycle) {
  const std::size_t count = first_of_cycle_.size();
  std::vector<std::vector<RingSide>> rings(count);
  std::vector<std::uint8_t> hole(count);
  for (std::size_t c = 0; c < count; ++c) {
    rings[c] = ring_of(first_of_cycle_[c]);
    hole[c] = is_hole(s_, OrientedPlane(plane_, false), rings[c]) ? 1 : 0;
  }
  if (std::find(hole.begin(), hole.end(), 1) == hole.end()) return true;
  bool is_clear = true;
  const auto lies_in = [&](std::size_t inner, std::size_t outer) {
    const RingPlace place = place_in(s_, plane_, rings[outer], rings[inner]);
    is_clear = is_clear && place != RingPlace::On;
    return place == RingPlace::Inside;
  };
  // Returns the innermost ring around a hole.
  const auto around = [&](std::size_t c) {
    std::size_t best = count;
    for (std::size_t o = 0; o < count; ++o) {
      if (hole[o] == 0 && lies_in(c, o) && (best == count || lies_in(o, best))) best = o;
    }
    return best;
  };
  const std::size_t outer = hole[seed_cycle] != 0 ? around(seed_cycle) : seed_cycle;
  if (!is_clear || outer == count) return false;
  is_selected_[outer] = 1;
  for (std::size_t c = 0; c < count; ++c) {
    if (hole[c] != 0 && lies_in(c, outer) && around(c) == outer) is_selected_[c] = 1;
  }
  return is_clear;
}

/// Whether the surface touches the plane in a single point of the component. A cut would make a
/// piece that touches itself in a point that is missing in one of its faces.
bool PlaneSection::is_punctured() {
  const auto is_on_segment = [this](VertexId v) {
    const auto at =
        std::lower_bound(outgoing_.begin(), outgoing_.end(), v,
                         [this](std::uint32_t i, VertexId w) { return segments_[i].from < w; });
    return at != outgoing_.end() && segments_[*at].from == v;
  };
  for (const VertexId v : zeros_) {
    if (is_on_segment(v)) continue;
    bool is_inside = false;
    for (std::size_t c = 0; c < first_of_cycle_.size(); ++c) {
      if (is_selected_[c] == 0) continue;
      const RingPlace place = place_in(s_, plane_, ring_of(first_of_cycle_[c]), v);
      if (place == RingPlace::On) puncture_ = v;
      is_inside ^= place == RingPlace::Inside;
    }
    if (is_inside) puncture_ = v;
    if (puncture_.is_valid()) return true;
  }
  return false;
}

}  // namespace plumb
