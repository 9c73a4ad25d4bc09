// The exact plane sweep, which finds where curves of the plane meet.
//
// For straight segments between the points of a table it computes every place where segments start,
// end, cross, touch or overlap, in lexicographic order (x, then y), and the order of the segments
// below, through and above each such place. Decisions are predicates on input points and on
// implicit crossings. No coordinate is ever rounded, so every degeneracy is an ordinary case.
//
// Notation: a curve is a segment, a ray or a line. It runs from its lexicographically lesser end
// (left) to the greater one (right); a vertical curve runs upward. Ends at infinity need no
// coordinates: curves from the left are in the status at the start, steeper ones below; a vertical
// end at infinity is an event before (after) all points of its x; two curves to the right infinity
// cross before it if and only if the lower is steeper. A bundle is a maximal set of curves on one
// line that overlap just left (incoming) or just right (outgoing) of an event. The status is the
// list of bundles that the sweep line meets, bottom to top.
//
// Main flow of sweep():
//  1. rank_points         sorts the end points once; equal points get equal ranks
//  2. collect_starts      groups the curves by their left ends, and keeps those of zero length
//                         apart
//     start_unbounded     fills the status with the curves from the left infinity, in one event
//  3. advance             takes the next end point or pending crossing, and all that are equal to
//                         it
//  4. take_enders         at plain events (one point, nothing passes through, nothing overlaps)
//                         finds the curves that end here side by side in the status
//  5. take_all_through    at other events walks the status both ways while bundles contain the
//                         point
//     group_ends          groups the curves that end here by bundle
//  6. order_starters      sorts starting curves by direction; those of one direction form a bundle,
//                         or join one that continues
//  7. replace_in_status   replaces incoming bundles by outgoing ones
//  8. test_neighbours     tests two bundles that became neighbours: a crossing is queued, a touch
//                         marks the end point as not plain
//  9. on_event            gives the finished event to the visitor
// 10. end_unbounded       ends all that is left in the status at the right infinity, in one event
//
// Invariants: neighbours in the status have been tested (8) since they became neighbours, so an
// event that is reached without a mark and without a crossing is plain, and costs no arithmetic
// other than its own. A bundle is known by the curve of it that ends last, so it ends when that
// curve does, and no event looks at curves that just pass through in a bundle. docs/design/sweep.md
// has the proofs.
//
// Cost: O((n + k) log n) expected for n curves and k incidences of events and bundles (n nested
// segments on one line have 2 n), with one orientation sign for each new pair of neighbours in the
// plain case; O(n + pending crossings) memory. Sources: J. L. Bentley, T. A. Ottmann, Algorithms
// for reporting and counting geometric intersections, IEEE Transactions on Computers C-28 (1979);
// degeneracies after K. Mehlhorn, S. Näher, LEDA, Cambridge University Press (1999), section 10.7.
#pragma once

#include <cstdint>
#include <limits>
#include <span>

#include "plumb/base/context.h"
#include "plumb/base/ids.h"
#include "plumb/predicates/plane/plane_points.h"

#pragma GCC visibility push(default)
namespace plumb {

/// A segment by the indices of its end points, in any direction. Both ends may have equal
/// coordinates (a zero-length segment), but not equal indices.
struct SweepSegment {
  std::uint32_t from;  ///< One end.
  std::uint32_t to;    ///< The other end.
};

/// A segment, ray or line: the part of the line a -> b from `from` to `to`. The ends are points of
/// any kind on that line, in its direction, or kUnbounded; a and b are input points of different
/// coordinates (unless from and to are equal points: a zero-length segment).
struct SweepCurve {
  static constexpr std::uint32_t kUnbounded = std::numeric_limits<std::uint32_t>::max();

  std::uint32_t from;  ///< The start, a point or kUnbounded.
  std::uint32_t to;    ///< The end, a point or kUnbounded.
  std::uint32_t a;     ///< An input point of the line.
  std::uint32_t b;     ///< A later input point of the line.
};

/// The kind of place of an event. LeftInfinity and RightInfinity come at most once, as the first
/// and the last event.
enum class SweepPlace : std::uint8_t {
  LeftInfinity,   ///< All curves from the left infinity, as outgoing bundles.
  VerticalStart,  ///< Coincident vertical curves from below, as one outgoing bundle.
  Point,          ///< An end point, a stop or a crossing.
  VerticalEnd,    ///< Coincident vertical curves that go up to infinity, as one incoming bundle.
  RightInfinity,  ///< All curves to the right infinity, as incoming bundles.
};

/// An event: everything that happens at one place. The spans are valid during the call only. A
/// bundle is given by the curve of it that ends last, as it was when the bundle last left a place.
struct SweepEvent {
  static constexpr std::uint32_t kNew = std::numeric_limits<std::uint32_t>::max();

  SweepPlace place = SweepPlace::Point;    ///< The kind of place.
  std::span<const std::uint32_t> points;   ///< End points and stops here; none at a mere crossing.
  const Crossing2* crossing = nullptr;     ///< Set if there are no points and `place` is Point.
  std::span<const SegmentId> incoming;     ///< Bundles just left of the event, bottom to top.
  std::span<const SegmentId> outgoing;     ///< Bundles just right of it, bottom to top.
  std::span<const SegmentId> ends;         ///< Curves that end here, by bundle; none at infinity.
  std::span<const SegmentId> starts;       ///< Curves that start here, by bundle.
  std::span<const SegmentId> zero_length;  ///< Segments of zero length here.
  SegmentId below;                         ///< The bundle next below the event, if any.
  /// Whether there is one point and no overlap, and every curve here starts or ends at that point.
  bool plain = false;

  // For events that are not plain; read by the functions below.
  std::span<const std::uint32_t> arrived_as;  ///< What came_from() returns for outgoing bundles.
  std::span<const std::uint32_t> ends_end;    ///< Where each incoming bundle's part of ends stops.
  std::span<const std::uint32_t>
      starts_end;  ///< Where each outgoing bundle's part of starts stops.

  /// Returns the incoming bundle that continues in an outgoing one, or kNew if all curves of the
  /// outgoing one start here.
  std::uint32_t came_from(std::size_t out) const { return plain ? kNew : arrived_as[out]; }
  /// Returns the curves of an incoming bundle that end here.
  std::span<const SegmentId> ending_in(std::size_t in) const {
    return plain ? incoming.subspan(in, 1) : part(ends, ends_end, in);
  }
  /// Returns the curves of an outgoing bundle that start here.
  std::span<const SegmentId> starting_in(std::size_t out) const {
    return plain ? outgoing.subspan(out, 1) : part(starts, starts_end, out);
  }
  /// Whether every curve here starts or ends here, each in a bundle of its own.
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

/// Takes the events of a sweep.
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

/// Sweeps all curves. Each of the points `stops` is an event, too, even if no curve starts or ends
/// there. Throws only what the visitor or the context throws.
void sweep(const PlanePointsView& points, std::span<const SweepCurve> curves,
           std::span<const std::uint32_t> stops, SweepVisitor& visitor, Context& context);

}  // namespace plumb
#pragma GCC visibility pop
