// The exact plane sweep. It finds all points where curves of the plane meet.
//
// The sweep visits every point where curves start, end, cross, touch or overlap. Each such point is
// an event. The events are visited in lexicographic order of (x, y). For each event, the sweep
// reports the curves through the point and their order from bottom to top. It also reports the
// nearest curve below the point. All decisions are made by exact predicates on input points and
// crossings. A crossing is stored as the two lines that cross. No coordinate is ever rounded, so
// the input may have any degeneracies.
//
// Curves: a curve is a segment, a ray or a line. Its left end is the lexicographically lesser end,
// and its right end is the lexicographically greater end. A curve runs from left to right, and a
// vertical curve runs upward.
//
// Bundles: a bundle is a maximal set of curves that lie on the same line and overlap next to an
// event. The curves of an incoming bundle overlap just left of the event. The curves of an outgoing
// bundle overlap just right of the event.
//
// Status: the status is the list of the bundles that the sweep line meets, from bottom to top.
//
// Infinity: ends of curves at infinity have no coordinates. The sweep treats them as follows:
//   - Curves from the left infinity are in the status at the start. Of two such curves with
//     different slopes, the curve with the greater slope is below the other.
//   - The event at which a vertical curve without a lower end starts comes before all points with
//     the same x. The event at which a vertical curve without an upper end ends comes after all
//     points with the same x.
//   - Two curves to the right infinity cross before they reach infinity if and only if the lower
//     curve has the greater slope.
//
// Main flow of sweep():
//  1. rank_points         sorts the end points once, and gives each point a rank. Equal points get
//                         equal ranks.
//  2. collect_starts      groups the curves by their left ends, and stores curves of length zero
//                         separately
//     start_unbounded     fills the status with the curves from the left infinity, in one event
//  3. advance             takes the next point, which is an end point or a pending crossing, and
//                         all end points and crossings that are equal to this point
//  4. take_enders         is taken at a plain event, and finds the curves that end at the event.
//                         These curves are neighbours in the status. An event is plain if it has
//                         one end point, no curve passes through it, and no curves overlap.
//  5. take_all_through    is taken at any other event, and finds the bundles that contain the
//                         point. For this, it walks up and down in the status from the point
//     group_ends          groups the curves that end at the event by bundle
//  6. order_starters      sorts the curves that start at the event by direction. Curves with the
//                         same direction form a bundle. If an incoming bundle continues in this
//                         direction, the curves join this incoming bundle.
//  7. replace_in_status   replaces the incoming bundles by the outgoing bundles
//  8. test_neighbours     tests every pair of bundles that became neighbours in the status. If the
//                         two bundles cross, their crossing becomes pending. If the bundles touch
//                         in an end point, the event of this point is marked as not plain.
//  9. on_event            passes the event with its curves to the visitor
// 10. end_unbounded       ends all bundles that remain in the status. This is one event, at the
//                         right infinity.
//
// Invariants: step 8 has tested all pairs of bundles that are neighbours in the status. So an event
// is plain if it is not marked as not plain, and if no crossing is pending at its point. No
// arithmetic is needed to decide whether an event is plain. In the status, a bundle is represented
// by the curve of the bundle that ends last. So the bundle ends when this curve ends. An event
// through which a bundle passes takes no time for the other curves of the bundle. The proofs are in
// docs/design/sweep.md.
//
// Cost: expected O((n + k) log n) time. Here n is the number of curves, and k is the number of
// incidences between events and bundles. For example, n nested segments on one line have 2 n
// incidences. At a plain event, the sweep computes one orientation sign for each new pair of
// neighbours. Memory: O(n + pending crossings).
//
// Sources: J. L. Bentley, T. A. Ottmann, Algorithms for reporting and counting geometric
// intersections, IEEE Transactions on Computers C-28 (1979). Degeneracies are handled as in K.
// Mehlhorn, S. Näher, LEDA, Cambridge University Press (1999), section 10.7.
#pragma once

#include <cstdint>
#include <limits>
#include <span>

#include "plumb/base/context.h"
#include "plumb/base/ids.h"
#include "plumb/predicates/plane/plane_points.h"

#pragma GCC visibility push(default)
namespace plumb {

/// A segment, given by the indices of its two end points in any order. The indices are different,
/// but the two points may have equal coordinates. Then the segment has length zero.
struct SweepSegment {
  std::uint32_t from;  ///< Index of one end point.
  std::uint32_t to;    ///< Index of the other end point.
};

/// A segment, ray or line. The curve is a part of the directed line through the input points a and
/// b. The curve starts at the point `from` and ends at the point `to`. Both points lie on the line,
/// and `from` comes before `to` in the direction from a to b. Each of the points `from` and `to` is
/// an input point or a crossing. If the curve is unbounded at one end, the index for this end is
/// kUnbounded. The points a and b have different coordinates. A segment of length zero is an
/// exception: its a and b may be equal, and its `from` and `to` are equal points.
struct SweepCurve {
  static constexpr std::uint32_t kUnbounded = std::numeric_limits<std::uint32_t>::max();

  std::uint32_t from;  ///< The start: the index of a point, or kUnbounded.
  std::uint32_t to;    ///< The end: the index of a point, or kUnbounded.
  std::uint32_t a;     ///< Index of an input point on the line.
  std::uint32_t b;     ///< Index of an input point that comes after a on the line.
};

/// The kinds of events. LeftInfinity can only be the first event, and RightInfinity only the last.
enum class SweepPlace : std::uint8_t {
  LeftInfinity,   ///< All curves without a left end start, as outgoing bundles.
  VerticalStart,  ///< A bundle of vertical curves starts. These curves have no lower end.
  Point,          ///< An end point, a stop (see sweep()) or a crossing.
  VerticalEnd,    ///< A bundle of vertical curves ends. These curves have no upper end.
  RightInfinity,  ///< All curves without a right end end here, as incoming bundles.
};

/// An event at a point or at infinity (SweepPlace), with the curves that start, end or pass there.
/// The spans are valid only during the call of on_event(). Each bundle is represented by one of its
/// curves. The representative is the curve of the bundle that ends last. Curves can join a bundle
/// at an event, so an outgoing bundle and the incoming bundle can have different representatives.
struct SweepEvent {
  static constexpr std::uint32_t kNew = std::numeric_limits<std::uint32_t>::max();

  SweepPlace place = SweepPlace::Point;  ///< The kind of the event.
  /// The indices of all end points of curves and of all stops (see sweep()) that lie at the event.
  /// The list is empty if the event is only a crossing.
  std::span<const std::uint32_t> points;
  /// The crossing at the event, if `place` is Point and `points` is empty; otherwise null.
  const Crossing2* crossing = nullptr;
  std::span<const SegmentId> incoming;  ///< Bundles just left of the event, bottom to top.
  std::span<const SegmentId> outgoing;  ///< Bundles just right of the event, bottom to top.
  /// Curves that end at the event, grouped by bundle. Empty at infinity.
  std::span<const SegmentId> ends;
  std::span<const SegmentId> starts;       ///< Curves that start at the event, grouped by bundle.
  std::span<const SegmentId> zero_length;  ///< Segments of length zero at the event.
  SegmentId below;                         ///< The nearest bundle below the event, if any.
  /// Whether the event is plain. It is plain if it has one point, no curves overlap, and every
  /// curve at the event starts or ends at this point.
  bool plain = false;

  // These members are set only for events that are not plain. The functions below read these
  // members.
  /// The result of came_from() for each outgoing bundle.
  std::span<const std::uint32_t> arrived_as;
  /// For each incoming bundle, the index in `ends` just after the last curve of this bundle.
  std::span<const std::uint32_t> ends_end;
  /// For each outgoing bundle, the index in `starts` just after the last curve of this bundle.
  std::span<const std::uint32_t> starts_end;

  /// Returns the index of the incoming bundle that continues in outgoing bundle `out`, or kNew if
  /// all curves of the outgoing bundle start at the event.
  std::uint32_t came_from(std::size_t out) const { return plain ? kNew : arrived_as[out]; }
  /// Returns the curves of an incoming bundle that end at the event.
  std::span<const SegmentId> ending_in(std::size_t in) const {
    return plain ? incoming.subspan(in, 1) : part(ends, ends_end, in);
  }
  /// Returns the curves of an outgoing bundle that start at the event.
  std::span<const SegmentId> starting_in(std::size_t out) const {
    return plain ? outgoing.subspan(out, 1) : part(starts, starts_end, out);
  }
  /// Whether every curve at the event starts or ends at the event, and no two of these curves
  /// belong to the same bundle.
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

/// Receives the events of a sweep.
class SweepVisitor {
 public:
  virtual ~SweepVisitor() = default;
  /// Called once before the first event. `curves` stays valid during the sweep.
  virtual void on_start(const SweepCurves& curves) { static_cast<void>(curves); }
  /// Called once for every event, in lexicographic order. If the function returns false, the sweep
  /// stops.
  virtual bool on_event(const SweepEvent& event) = 0;
};

/// Sweeps over all segments. Throws only exceptions of the visitor or the context.
void sweep(const PointTable2& points, std::span<const SweepSegment> segments, SweepVisitor& visitor,
           Context& context);

/// Sweeps over all curves. `stops` contains indices of points. Each of these points is an event,
/// even if no curve starts or ends at the point. Throws only exceptions of the visitor or the
/// context.
void sweep(const PlanePointsView& points, std::span<const SweepCurve> curves,
           std::span<const std::uint32_t> stops, SweepVisitor& visitor, Context& context);

}  // namespace plumb
#pragma GCC visibility pop
