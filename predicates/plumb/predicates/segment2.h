// Predicates on segments of the plane. They compute the position of a point relative to a segment,
// and the position of a segment relative to a line. They also find the way in which two segments
// intersect. The coordinates are doubles or exact rationals.
//
// A segment contains its two ends, which are different points. The interior of a segment is the
// segment without its ends. Every result is exact. All results are computed from orient2d() and
// compare_xy(). So one implementation handles points with double coordinates and points with
// rational coordinates.
#pragma once

#include <cstdint>
#include <optional>

#include "plumb/predicates/point.h"
#include "plumb/predicates/rational_point.h"
#include "plumb/predicates/sign.h"

#pragma GCC visibility push(default)
namespace plumb {

/// A directed segment. `Point` is Point2 or RationalPoint2. Requires source != target.
template <class Point>
struct BasicSegment2 {
  Point source;  ///< The start point.
  Point target;  ///< The end point.
  friend bool operator==(const BasicSegment2&, const BasicSegment2&) = default;
};
using Segment2 = BasicSegment2<Point2>;                  ///< A segment with double coordinates.
using RationalSegment2 = BasicSegment2<RationalPoint2>;  ///< A segment with rational coordinates.

/// Compares p and q lexicographically (x, then y). This is a total order.
Sign compare_xy(const Point2& p, const Point2& q);
Sign compare_xy(const RationalPoint2& p, const RationalPoint2& q);

/// Compares p and q in the direction of a segment: Negative if p comes before q. Requires that p
/// and q lie on the line through the segment. Swapping p and q, or reversing the segment, flips the
/// sign.
template <class Point>
Sign compare_along(const BasicSegment2<Point>& direction, const Point& p, const Point& q);

/// The position of a point relative to a segment.
enum class PlaceOnSegment : std::uint8_t {
  Off,     ///< The point is not on the segment, but may be on its line.
  Source,  ///< The point is the source.
  Inside,  ///< The point is in the interior of the segment.
  Target,  ///< The point is the target.
};

/// Returns the position of p relative to s. Reversing the segment exchanges Source and Target.
template <class Point>
PlaceOnSegment place_on(const BasicSegment2<Point>& s, const Point& p);

/// The way in which two segments intersect.
enum class SegmentRelation : std::uint8_t {
  Disjoint,       ///< There is no common point.
  Cross,          ///< The one common point is interior to both segments.
  Touches,        ///< The one common point is an end of the first segment and inside the second.
  IsTouched,      ///< The one common point is an end of the second segment and inside the first.
  ShareEndpoint,  ///< The one common point is an end of both segments.
  Overlap,        ///< The common part is a segment, and neither segment contains the other.
  Covers,         ///< The second segment is a proper part of the first.
  IsCovered,      ///< The first segment is a proper part of the second.
  Equal,          ///< The two segments are the same point set.
};

/// Returns the way in which s and t intersect. If the two segments are exchanged, the result is
/// mirrored: relation(s, t) equals mirrored(relation(t, s)). Reversing s or t does not change the
/// result. The cost is two or four calls of orient2d. Two calls are enough if both ends of t lie on
/// the line through s, or strictly on the same side of it.
template <class Point>
SegmentRelation relation(const BasicSegment2<Point>& s, const BasicSegment2<Point>& t);

/// Returns the relation of the same two segments after they are exchanged.
constexpr SegmentRelation mirrored(SegmentRelation r) {
  switch (r) {
    case SegmentRelation::Touches:
      return SegmentRelation::IsTouched;
    case SegmentRelation::IsTouched:
      return SegmentRelation::Touches;
    case SegmentRelation::Covers:
      return SegmentRelation::IsCovered;
    case SegmentRelation::IsCovered:
      return SegmentRelation::Covers;
    default:
      return r;
  }
}

/// Whether the segments have exactly one common point.
constexpr bool meet_in_a_point(SegmentRelation r) {
  return r >= SegmentRelation::Cross && r <= SegmentRelation::ShareEndpoint;
}

/// The position of a segment relative to a directed line.
enum class LineRelation : std::uint8_t {
  Left,              ///< The segment is strictly left of the line.
  Right,             ///< The segment is strictly right of the line.
  TouchesFromLeft,   ///< One end is on the line; the rest of the segment is left of the line.
  TouchesFromRight,  ///< One end is on the line; the rest of the segment is right of the line.
  Crosses,           ///< The ends lie strictly on different sides.
  Inside,            ///< The segment is a part of the line.
};

/// Returns the position of s relative to the directed line through the segment `line`. Reversing
/// `line` exchanges left and right; reversing s does not change the result. Cost: two calls of
/// orient2d.
template <class Point>
LineRelation relation_to_line(const BasicSegment2<Point>& line, const BasicSegment2<Point>& s);

/// Returns the intersection of the line through s and the line through t. Requires that the lines
/// are not parallel.
template <class Point>
RationalPoint2 crossing_point(const BasicSegment2<Point>& s, const BasicSegment2<Point>& t);

/// Returns the common point of s and t if there is exactly one. Otherwise returns no value.
template <class Point>
std::optional<RationalPoint2> meeting_point(const BasicSegment2<Point>& s,
                                            const BasicSegment2<Point>& t);

}  // namespace plumb
#pragma GCC visibility pop
