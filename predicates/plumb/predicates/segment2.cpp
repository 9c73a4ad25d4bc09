// The relations of segments, lines and points of the plane, from orientation signs and the
// lexicographic order alone.
//
// Two segments are related by the sides of the line of each on which the ends of the other lie. If
// both ends of one are strictly on one side, the segments are disjoint; if all four signs are zero,
// they are on one line, where the order of the ends decides; otherwise there is exactly one common
// point, and the signs that are zero say whose end it is. Only crossing_point() constructs numbers.
//
// The templates serve points of doubles and of rationals, which are instantiated at the end.
//
// Tested by tests/predicates/segment2_test.cpp.

#include "plumb/predicates/segment2.h"

#include "plumb/predicates/arithmetic/double_bits.h"
#include "plumb/predicates/input_predicates.h"
#include "plumb/predicates/plane/point2_exact.h"
#include "plumb/predicates/rational_predicates.h"
#include "plumb/predicates/rounding.h"

namespace plumb {

namespace {

/// The ends of a segment in lexicographic order.
template <class Point>
struct Range {
  const Point& low;
  const Point& high;
};

template <class Point>
Range<Point> range(const BasicSegment2<Point>& s) {
  if (compare_xy(s.source, s.target) == Sign::Positive) return {s.target, s.source};
  return {s.source, s.target};
}

/// Returns the relation of two segments on one line, from the order of their ends.
template <class Point>
SegmentRelation relation_on_a_line(const Range<Point>& s, const Range<Point>& t) {
  const Sign s_to_t = compare_xy(s.high, t.low);
  const Sign t_to_s = compare_xy(t.high, s.low);
  if (s_to_t == Sign::Negative || t_to_s == Sign::Negative) return SegmentRelation::Disjoint;
  if (s_to_t == Sign::Zero || t_to_s == Sign::Zero) return SegmentRelation::ShareEndpoint;
  const Sign low = compare_xy(s.low, t.low);
  const Sign high = compare_xy(s.high, t.high);
  if (low == Sign::Zero && high == Sign::Zero) return SegmentRelation::Equal;
  if (low != Sign::Positive && high != Sign::Negative) return SegmentRelation::Covers;
  if (low != Sign::Negative && high != Sign::Positive) return SegmentRelation::IsCovered;
  return SegmentRelation::Overlap;
}

/// The sides of a line on which the two ends of a segment lie.
struct Sides {
  Sign source;
  Sign target;
  bool are_same() const { return source == target && source != Sign::Zero; }
  bool has_zero() const { return source == Sign::Zero || target == Sign::Zero; }
  bool are_zero() const { return source == Sign::Zero && target == Sign::Zero; }
};

template <class Point>
Sides sides(const BasicSegment2<Point>& line, const BasicSegment2<Point>& s) {
  return {orient2d(line.source, line.target, s.source),
          orient2d(line.source, line.target, s.target)};
}

RationalPoint2 exact_point(const Point2& p) { return {exact_rational(p.x), exact_rational(p.y)}; }
const RationalPoint2& exact_point(const RationalPoint2& p) { return p; }

/// Returns the common point of two segments on one line that share only an end.
template <class Point>
const Point& shared_end(const BasicSegment2<Point>& s, const BasicSegment2<Point>& t) {
  const bool is_source =
      compare_xy(s.source, t.source) == Sign::Zero || compare_xy(s.source, t.target) == Sign::Zero;
  return is_source ? s.source : s.target;
}

}  // namespace

Sign compare_xy(const Point2& p, const Point2& q) {
  const Sign by_x = compare(p.x, q.x);
  return by_x != Sign::Zero ? by_x : compare(p.y, q.y);
}

Sign compare_xy(const RationalPoint2& p, const RationalPoint2& q) {
  const int by_x = p.x.compare(q.x);
  return sign_of(by_x != 0 ? by_x : p.y.compare(q.y));
}

// For g++, the definition of a template determines its visibility, not the declaration in the
// header.
#pragma GCC visibility push(default)
template <class Point>
Sign compare_along(const BasicSegment2<Point>& direction, const Point& p, const Point& q) {
  return compare_xy(p, q) * compare_xy(direction.target, direction.source);
}

/// A point on the line lies between the ends if it comes after one and before the other in the
/// lexicographic order, which is monotone along the line.
template <class Point>
PlaceOnSegment place_on(const BasicSegment2<Point>& s, const Point& p) {
  if (orient2d(s.source, s.target, p) != Sign::Zero) return PlaceOnSegment::Off;
  const Sign from_source = compare_xy(s.source, p);
  const Sign to_target = compare_xy(p, s.target);
  if (from_source == Sign::Zero) return PlaceOnSegment::Source;
  if (to_target == Sign::Zero) return PlaceOnSegment::Target;
  return from_source == to_target ? PlaceOnSegment::Inside : PlaceOnSegment::Off;
}

template <class Point>
SegmentRelation relation(const BasicSegment2<Point>& s, const BasicSegment2<Point>& t) {
  const Sides of_t = sides(s, t);
  if (of_t.are_same()) return SegmentRelation::Disjoint;
  if (of_t.are_zero()) return relation_on_a_line(range(s), range(t));
  const Sides of_s = sides(t, s);
  if (of_s.are_same()) return SegmentRelation::Disjoint;
  // Each segment meets the other's line, and the lines differ. So there is one common point, and an
  // end of t on the line of s is that point.
  if (of_t.has_zero()) {
    return of_s.has_zero() ? SegmentRelation::ShareEndpoint : SegmentRelation::IsTouched;
  }
  return of_s.has_zero() ? SegmentRelation::Touches : SegmentRelation::Cross;
}

template <class Point>
LineRelation relation_to_line(const BasicSegment2<Point>& line, const BasicSegment2<Point>& s) {
  const Sides of_s = sides(line, s);
  if (of_s.are_zero()) return LineRelation::Inside;
  if (of_s.are_same()) {
    return of_s.source == Sign::Positive ? LineRelation::Left : LineRelation::Right;
  }
  if (!of_s.has_zero()) return LineRelation::Crosses;
  const bool is_left = of_s.source == Sign::Positive || of_s.target == Sign::Positive;
  return is_left ? LineRelation::TouchesFromLeft : LineRelation::TouchesFromRight;
}

template <class Point>
RationalPoint2 crossing_point(const BasicSegment2<Point>& s, const BasicSegment2<Point>& t) {
  detail::Scratch2& scratch = detail::Scratch2::fresh();
  const auto line = [&](const BasicSegment2<Point>& l) {
    return scratch.cross(scratch.point(l.source), scratch.point(l.target));
  };
  const detail::Triple p = scratch.cross(line(s), line(t));
  return {detail::to_rational(p.x, p.w), detail::to_rational(p.y, p.w)};
}

template <class Point>
std::optional<RationalPoint2> meeting_point(const BasicSegment2<Point>& s,
                                            const BasicSegment2<Point>& t) {
  const SegmentRelation r = relation(s, t);
  if (!meet_in_a_point(r)) return std::nullopt;
  if (r == SegmentRelation::ShareEndpoint) return exact_point(shared_end(s, t));
  return crossing_point(s, t);
}

#pragma GCC visibility pop

template Sign compare_along(const Segment2&, const Point2&, const Point2&);
template PlaceOnSegment place_on(const Segment2&, const Point2&);
template SegmentRelation relation(const Segment2&, const Segment2&);
template LineRelation relation_to_line(const Segment2&, const Segment2&);
template RationalPoint2 crossing_point(const Segment2&, const Segment2&);
template std::optional<RationalPoint2> meeting_point(const Segment2&, const Segment2&);

template Sign compare_along(const RationalSegment2&, const RationalPoint2&, const RationalPoint2&);
template PlaceOnSegment place_on(const RationalSegment2&, const RationalPoint2&);
template SegmentRelation relation(const RationalSegment2&, const RationalSegment2&);
template LineRelation relation_to_line(const RationalSegment2&, const RationalSegment2&);
template RationalPoint2 crossing_point(const RationalSegment2&, const RationalSegment2&);
template std::optional<RationalPoint2> meeting_point(const RationalSegment2&,
                                                     const RationalSegment2&);

}  // namespace plumb
