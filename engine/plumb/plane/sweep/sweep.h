// One exact plane sweep for everything that asks where segments of the plane meet.
//
// It computes, for straight segments between the points of a table, every place where segments
// start, end, cross, touch or overlap, in lexicographic (x, then y) order, and the order of the
// segments below, through and above each such place. Decisions are predicates on input points and
// on implicit crossings; no coordinate is ever rounded, so any degeneracy is an ordinary case.
//
// Notation: a curve is a segment, a ray or a line. It runs from its lexicographically lesser end
// (left) to the greater one (right); a vertical curve runs upward. Ends at infinity need no
// coordinates: curves from the left are in the status at the start, steeper ones below; a vertical
// end at infinity is an event before (after) all points of its x; two curves to the right infinity
// cross there if and only if the lower is steeper. A bundle is a maximal set of collinear segments
// that overlap just left (incoming) or just right (outgoing) of an event. The status is the list of
// bundles met by the sweep line, bottom to top.
//
// Main flow of sweep():
//  1. rank_points         sort the end points once; equal points get equal ranks
//  2. collect_starts      segments by their left end; zero-length ones are kept apart
//     start_unbounded     curves from the left infinity fill the status, in one event
//  3. next_event          the next end point or pending crossing, with everything that equals it
//  4. take_enders         plain events (one point, nothing passes through, nothing overlaps): the
//                         segments that end here stand side by side in the status
//  5. take_all_through    other events: walk the status both ways while bundles contain the point
//     group_ends          the segments that end here, by bundle
//  6. order_starters      by direction; segments of one direction form a bundle, or join one that
//                         goes on
//  7. replace_in_status   incoming bundles make room for outgoing ones
//  8. test_neighbours     two bundles that became neighbours: a crossing is queued, a touch marks
//                         the end point as not plain
//  9. on_event            the visitor sees the finished event
// 10. end_unbounded       what is left in the status ends at the right infinity, in one event
//
// Invariants: neighbours in the status have been tested (8) since they became neighbours; so an
// event reached without mark and without crossing is plain, and costs no arithmetic but its own. A
// bundle is known by the one of its segments that ends last; so it ends when that one does, and no
// event looks at segments that just pass through in a bundle.
//
// Cost: O((n + k) log n) expected for n segments and k event-bundle incidences (n nested segments
// on one line: 2n of them), one orientation test per new neighbour pair in the plain case; O(n +
// pending crossings) memory. Source: Bentley and Ottmann 1979; degeneracies after Mehlhorn and
// Näher, LEDA (1999), chapter 10.7.
#pragma once

#include <cstdint>
#include <limits>
#include <span>

#include "plumb/base/context.h"
#include "plumb/base/ids.h"
#include "plumb/predicates/plane/plane_points.h"

#pragma GCC visibility push(default)
namespace plumb {

/// A segment by the indices of its end points; any direction. Equal coordinates of both ends are
/// allowed (a zero-length segment), equal indices are not.
struct SweepSegment {
  std::uint32_t from;
  std::uint32_t to;
};

/// A segment, ray or line: the part of the line a -> b from `from` to `to`. The ends are points of
/// any kind on that line, in its direction, or kUnbounded; a and b are input points of different
/// coordinates (unless from and to are equal points: a zero-length segment).
struct SweepCurve {
  static constexpr std::uint32_t kUnbounded = std::numeric_limits<std::uint32_t>::max();

  std::uint32_t from;
  std::uint32_t to;
  std::uint32_t a;
  std::uint32_t b;
};

/// What kind of place an event is. The first and the last come at most once, first and last.
enum class SweepPlace : std::uint8_t {
  LeftInfinity,   ///< all curves from the left infinity: outgoing only
  VerticalStart,  ///< coincident vertical curves from below: outgoing only, one bundle
  Point,
  VerticalEnd,    ///< coincident vertical curves go up to infinity: incoming only, one bundle
  RightInfinity,  ///< all curves to the right infinity: incoming only
};

/// Everything that happens at one place. The spans are valid during the call only. A bundle is
/// named by the one of its curves that reaches furthest right; as it was when the bundle last left
/// a place.
struct SweepEvent {
  static constexpr std::uint32_t kNew = std::numeric_limits<std::uint32_t>::max();

  SweepPlace place = SweepPlace::Point;
  std::span<const std::uint32_t> points;   ///< end points lying here; empty: a mere crossing
  const Crossing2* crossing = nullptr;     ///< set when points is empty (and place is Point)
  std::span<const SegmentId> incoming;     ///< bundles just left of the event, bottom to top
  std::span<const SegmentId> outgoing;     ///< bundles just right of it, bottom to top
  std::span<const SegmentId> ends;         ///< curves that end here, by bundle; none at infinity
  std::span<const SegmentId> starts;       ///< curves that start here, by bundle
  std::span<const SegmentId> zero_length;  ///< zero-length segments lying here
  SegmentId below;                         ///< the bundle next below the event, if any
  bool plain = false;  ///< one point, no overlap, every segment here starts or ends at that point

  // Of events that are not plain, behind the functions below.
  std::span<const std::uint32_t> arrived_as;  ///< per outgoing bundle
  std::span<const std::uint32_t> ends_end;    ///< per incoming bundle, into ends
  std::span<const std::uint32_t> starts_end;  ///< per outgoing bundle, into starts

  /// The incoming bundle that goes on in an outgoing one; kNew: all its curves start here.
  std::uint32_t came_from(std::size_t out) const { return plain ? kNew : arrived_as[out]; }
  /// The curves of an incoming bundle that end here.
  std::span<const SegmentId> ending_in(std::size_t in) const {
    return plain ? incoming.subspan(in, 1) : part(ends, ends_end, in);
  }
  /// The curves of an outgoing bundle that start here.
  std::span<const SegmentId> starting_in(std::size_t out) const {
    return plain ? outgoing.subspan(out, 1) : part(starts, starts_end, out);
  }
  /// Does every curve here start or end here, each in a bundle of its own?
  bool has_ends_only() const;

 private:
  static std::span<const SegmentId> part(std::span<const SegmentId> all,
                                         std::span<const std::uint32_t> end, std::size_t i) {
    if (all.empty()) return {};
    const std::size_t begin = i == 0 ? 0 : end[i - 1];
    return all.subspan(begin, end[i] - begin);
  }
};

class [[gnu::visibility("hidden")]] SweepCurves;

class SweepVisitor {
 public:
  virtual ~SweepVisitor() = default;
  /// Called once before the first event. `curves` stays valid during the sweep.
  virtual void on_start(const SweepCurves& curves) { static_cast<void>(curves); }
  /// Called once for every event, in lexicographic order. Returning false stops the sweep.
  virtual bool on_event(const SweepEvent& event) = 0;
};

/// Sweeps all segments. Throws only what the visitor or the context throws.
void sweep(const PointTable2& points, std::span<const SweepSegment> segments, SweepVisitor& visitor,
           Context& context);

/// Sweeps all curves; each of the points `stops` is an event too, even where nothing starts or
/// ends.
void sweep(const PlanePointsView& points, std::span<const SweepCurve> curves,
           std::span<const std::uint32_t> stops, SweepVisitor& visitor, Context& context);

}  // namespace plumb
#pragma GCC visibility pop
