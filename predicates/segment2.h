// Segments of the plane: where a point lies on one, how two meet, how one lies to a line. For
// doubles and for exact rationals alike.
//
// A segment is closed and has two different ends. Its inside is the segment without its ends. Every
// answer is exact; all follow from orient2d and compare_xy alone, so there is one implementation.
#pragma once

#include <cstdint>
#include <optional>

#include "plumb/predicates/point.h"
#include "plumb/predicates/rational_point.h"
#include "plumb/predicates/sign.h"

#pragma GCC visibility push(default)
namespace plumb {

/// `Point` is Point2 or RationalPoint2. Requires source != target.
template <class Point>
struct BasicSegment2 {
  Point source;  ///< where it begins
  Point target;  ///< where it ends
  friend bool operator==(const BasicSegment2&, const BasicSegment2&) = default;
};
using Segment2 = BasicSegment2<Point2>;                  ///< of doubles
using RationalSegment2 = BasicSegment2<RationalPoint2>;  ///< of fractions

/// Lexicographic order (x, then y); a total order.
Sign compare_xy(const Point2& p, const Point2& q);
Sign compare_xy(const RationalPoint2& p, const RationalPoint2& q);

/// Order of two points of a line in the direction of the segment on it: Negative when p comes
/// before q. Requires p and q to lie on the line of `direction`. Swapping p and q, or reversing the
/// direction, flips the sign.
template <class Point>
Sign compare_along(const BasicSegment2<Point>& direction, const Point& p, const Point& q);

/// Where a point lies.
enum class PlaceOnSegment : std::uint8_t {
  Off,     ///< not on the segment (perhaps on its line)
  Source,  ///< at the source
  Inside,
  Target,
};

/// Reversing the segment swaps Source and Target.
template <class Point>
PlaceOnSegment place_on(const BasicSegment2<Point>& s, const Point& p);

/// How two segments meet.
enum class SegmentRelation : std::uint8_t {
  Disjoint,       ///< no common point
  Cross,          ///< one common point, inside both
  Touches,        ///< one common point: an end of the first, inside the second
  IsTouched,      ///< one common point: an end of the second, inside the first
  ShareEndpoint,  ///< one common point, an end of both
  Overlap,        ///< a common segment; each has a part of its own
  Covers,         ///< the second is a proper part of the first
  IsCovered,      ///< the first is a proper part of the second
  Equal,          ///< the same points
};

/// relation(s, t) = mirrored(relation(t, s)); reversing s or t changes nothing; Equal iff the ends
/// are the same two points. Cost: two orient2d when t lies on one side of s, else four.
template <class Point>
SegmentRelation relation(const BasicSegment2<Point>& s, const BasicSegment2<Point>& t);

/// The relation seen from the other segment.
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

/// Exactly one common point?
constexpr bool meet_in_a_point(SegmentRelation r) {
  return r >= SegmentRelation::Cross && r <= SegmentRelation::ShareEndpoint;
}

/// How a segment lies to a line.
enum class LineRelation : std::uint8_t {
  Left,              ///< strictly left of the line
  Right,             ///< strictly right
  TouchesFromLeft,   ///< one end on the line, the rest left
  TouchesFromRight,  ///< one end on the line, the rest right
  Crosses,           ///< the line meets the inside, the ends lie on different sides
  Inside,            ///< a part of the line
};

/// Where segment s lies to the line through `line`, seen along its direction. Reversing the line
/// swaps Left and Right; reversing s changes nothing. Cost: two orient2d.
template <class Point>
LineRelation relation_to_line(const BasicSegment2<Point>& line, const BasicSegment2<Point>& s);

/// The point common to the lines of s and t. Requires cross_sign(s, t) != Zero.
template <class Point>
RationalPoint2 crossing_point(const BasicSegment2<Point>& s, const BasicSegment2<Point>& t);

/// The common point when there is exactly one.
template <class Point>
std::optional<RationalPoint2> meeting_point(const BasicSegment2<Point>& s,
                                            const BasicSegment2<Point>& t);

}  // namespace plumb
#pragma GCC visibility pop
