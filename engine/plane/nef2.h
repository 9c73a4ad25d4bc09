// Nef polyhedra in the plane: every set that unions, intersections and complements make from open
// and closed half-planes. Open or closed along every edge and at every vertex, bounded or not, with
// isolated points, slits, rays and lines.
//
// A set is held as its unique minimal complex (plane_complex.h): vertices, edges and faces, each
// with a mark that says whether it belongs to the set. Equal sets have equal complexes.
//
// Main flow of every operation:
//  1. PlaneScene        the edges of all operands as curves over one table of points
//  2. sweep             one exact sweep (sweep.h); unbounded curves are ordinary ones
//  3. PlaneBuilder      carries a label upward through each event (the operands' faces just there),
//                       asks the rule for marks and keeps an edge only if its mark differs from a
//                       face beside it, a vertex only if it is no mere point of its edge or face
//  4. PlaneAssembler    joins unbounded ends into the frame, traces the boundaries, nests
//                       components in the face below them, compacts the points
// Unary topology operators re-mark and simplify in O(n), without a sweep.
//
// A Nef2 is an immutable value: copies share what they hold and cost O(1); const members may be
// called from several threads at once. Every operation gives the strong guarantee.
//
// Cost: binary operations O((n + k) log n) for n edges and k crossings; unary ones O(n); locate
// O(log^2 n) after O(n log^2 n) once per set; memory O(n). Errors: Error{NotFinite} for coordinates
// that are no numbers, Error{BadArgument} where said; ResourceLimit and Cancelled by the Context.
// Source: Nef 1978; Seel, Implementation of planar Nef polyhedra, MPI-I-2001-1-003 (2001), whose
// infimaximal frame is here a frame of no coordinates at all.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "plumb/base/context.h"
#include "plumb/base/marks.h"
#include "plumb/plane/map_check.h"
#include "plumb/plane/plane_complex.h"

#pragma GCC visibility push(default)
namespace plumb {

/// Which winding numbers are inside.
enum class WindingRule : std::uint8_t { NonZero, EvenOdd, Positive };

/// A directed line. Left of it is the side of points p with (b - a) x (p - a) > 0.
struct Line2 {
  RationalPoint2 a;  ///< a point on it
  RationalPoint2 b;  ///< different from a

  /// { a x + b y + c = 0 }, directed so that a x + b y + c < 0 lies to the left. Throws
  /// Error{BadArgument} when a = b = 0.
  static Line2 from_coefficients(const Rational& a, const Rational& b, const Rational& c);
};

/// An affine map: (x, y) -> (xx x + xy y + x0, yx x + yy y + y0).
struct AffineMap2 {
  /// Of x' = xx x + xy y + x0.
  Rational xx = 1, xy = 0, x0 = 0;  ///< Of x' = xx x + xy y + x0.
  /// Of y' = yx x + yy y + y0.
  Rational yx = 0, yy = 1, y0 = 0;  ///< Of y' = yx x + yy y + y0.
};

/// Where a point lies: exactly one id is valid.
struct PlaneLocation {
  VertexId vertex;      ///< valid: the point lies on it
  EdgeId edge;          ///< valid: the point lies on it
  FaceId face;          ///< valid: the point lies in it
  bool marked = false;  ///< does the point belong to the set?
  friend bool operator==(const PlaneLocation&, const PlaneLocation&) = default;
};

/// What a ray meets, and the first point of it there (the infimum: of a face entered over its open
/// boundary it is the point on that boundary).
struct RayHit {
  PlaneLocation on;      ///< what the ray meets
  RationalPoint2 point;  ///< where
};

/// A polygon with holes: rings without repeated points, the outer one counter-clockwise, holes
/// clockwise. Rings may touch at points.
struct PolygonWithHoles2 {
  std::vector<RationalPoint2> outer;               ///< counter-clockwise
  std::vector<std::vector<RationalPoint2>> holes;  ///< clockwise
};

/// The closure of a set by dimension, nothing listed twice.
struct PlaneParts {
  std::vector<PolygonWithHoles2> polygons;         ///< closures of bounded marked faces
  std::vector<std::vector<RationalPoint2>> lines;  ///< chains; closed ones repeat their first point
  std::vector<RationalPoint2> points;              ///< isolated ones
  bool dropped_unbounded = false;                  ///< unbounded faces, rays or lines were left out
  bool dropped_open = false;  ///< the set was not closed: the parts are its closure
};

class [[gnu::visibility("hidden")]] PlaneLocator;
class [[gnu::visibility("hidden")]] PlaneTrapezoids;

// A friend that is declared in its class alone g++ does not export.
class Nef2;
Nef2 operator+(const Nef2& a, const Nef2& b);   ///< union
Nef2 operator*(const Nef2& a, const Nef2& b);   ///< intersection
Nef2 operator-(const Nef2& a, const Nef2& b);   ///< the first without the second
Nef2 operator^(const Nef2& a, const Nef2& b);   ///< symmetric difference
bool operator==(const Nef2& a, const Nef2& b);  ///< the same set?
bool operator<=(const Nef2& a, const Nef2& b);  ///< inclusion

/// A set of the plane: an immutable value, see above.
class Nef2 {
 public:
  // --- sets to start from ---------------------------------------------------------------------

  Nef2();                                 ///< the empty set
  static Nef2 empty() { return Nef2(); }  ///< No point.
  static Nef2 plane();                    ///< Every point.

  /// Left of the line. Throws Error{BadArgument} when line.a = line.b.
  static Nef2 half_plane(const Line2& line, Boundary boundary);
  /// The side of the line on which `kept` lies. Throws Error{BadArgument} when it lies on the line.
  static Nef2 half_plane(const Line2& line, const RationalPoint2& kept, Boundary boundary);
  /// The whole line.
  static Nef2 line(const Line2& line);
  /// From line.a on through line.b, with or without its origin. Same errors.
  static Nef2 ray(const Line2& line, Boundary boundary);

  /// Closed chains of points by a rule of winding numbers: chain c is
  /// corners[chain_begin[c], chain_begin[c + 1]), its last point is joined to the first.
  ///   Closed  the inside with everything on the chains next to it; where as many chains run one way
  ///           as the other (a spike: there and back) a marked edge, of one point a marked point
  ///   Open    the inside without what lies on the chains: a piece that lies on chains is inside
  ///           only if its winding numbers are, in whatever order the chains there are crossed; a
  ///           vertex only if everything around it is
  static Nef2 polygons(const PointTable2& points, std::span<const std::uint32_t> corners,
                       std::span<const std::uint32_t> chain_begin, WindingRule rule,
                       Boundary boundary, Context& context);
  /// One chain, under WindingRule::NonZero: direction does not matter. No point: the empty set.
  static Nef2 polygon(std::span<const Point2> points, Boundary boundary = Boundary::Closed);
  /// Open chains: consecutive points are joined; a chain of one point is that point.
  static Nef2 polylines(const PointTable2& points, std::span<const std::uint32_t> corners,
                        std::span<const std::uint32_t> chain_begin, Context& context);
  static Nef2 polyline(std::span<const Point2> points);  ///< Closed segments from point to point.
  /// Isolated points; equal ones are one.
  static Nef2 points(const PointTable2& points, Context& context);
  static Nef2 point(const RationalPoint2& point);  ///< One point.

  /// The chosen regions of a checked subdivision: the closure or interior of their union; chosen[r]
  /// is about report.regions[r]. Throws Error{BadArgument} unless the verdict is Valid and sizes agree.
  static Nef2 subdivision(const MapReport& report, std::span<const std::uint8_t> chosen,
                          Boundary boundary, Context& context);

  /// Any complex, brought into minimal form; its marks say what belongs to the set. Requires
  /// audit(complex, false) to be clean.
  static Nef2 from_complex(PlaneComplex complex);
  /// A complex that is in minimal form already: nothing is done or checked. audit() tells.
  static Nef2 from_minimal(PlaneComplex complex) { return Nef2(std::move(complex)); }
  /// This set's complex with other marks (sizes must agree: Error{BadArgument}). O(n).
  Nef2 with_marks(PlaneMarks marks) const;

  // --- reading --------------------------------------------------------------------------------

  /// The minimal complex: iteration over vertices, half-edges and faces, their geometry and marks.
  const PlaneComplex& complex() const;

  bool is_empty() const;  ///< Is there no point in it? O(1).
  bool is_plane() const;  ///< Is every point in it? O(1).
  /// Does the set lie in some disk?
  bool is_bounded() const;
  /// Is it its own closure (its own interior)? O(n).
  bool is_closed() const;
  bool is_open() const;  ///< Is it its own interior? O(n).

  /// Does the point belong to the set? As locate().
  bool contains(const RationalPoint2& p) const { return locate(p).marked; }
  /// The same for doubles. Throws Error{NotFinite}.
  bool contains(Point2 p) const { return locate(p).marked; }
  /// Where a point lies. O(log^2 n) after the first call, which builds the locator without
  /// limits.
  PlaneLocation locate(const RationalPoint2& p) const;
  /// Throws Error{NotFinite}.
  PlaneLocation locate(Point2 p) const;
  /// Does p lie on the boundary of the set? (Isolated points and slits are boundary.)
  bool has_on_boundary(const RationalPoint2& p) const;

  /// The first marked element met from `origin` (inclusive) in `direction`, or none. O(log n) for
  /// each element met, O(1) for each trapezoid of the vertical decomposition of its faces, after the
  /// first call, which builds locator and trapezoids without limits. Throws Error{BadArgument} for
  /// the zero direction.
  std::optional<RayHit> shoot(const RationalPoint2& origin, const RationalPoint2& direction) const;
  /// The first vertex or edge of the complex met, marked or not; one `origin` lies on is met at
  /// once.
  std::optional<RayHit> shoot_to_boundary(const RationalPoint2& origin,
                                          const RationalPoint2& direction) const;

  /// The exact area; none when it is infinite. O(n) rational terms.
  std::optional<Rational> area() const;

  /// Polygons, lines and points of the closure.
  PlaneParts parts() const;

  // --- operations -----------------------------------------------------------------------------

  Nef2 complement() const;      ///< All other points.
  Nef2 interior() const;        ///< Without its boundary.
  Nef2 closure() const;         ///< With its boundary.
  Nef2 boundary() const;        ///< closure - interior
  Nef2 exterior() const;        ///< interior of the complement
  Nef2 regularization() const;  ///< closure of the interior

  /// Throws Error{BadArgument} when the map has determinant 0. O(n log n).
  Nef2 transformed(const AffineMap2& map) const;

  Nef2 operator!() const { return complement(); }                        ///< complement()
  Nef2& operator+=(const Nef2& other) { return *this = *this + other; }  ///< union with another set
  /// Intersection with another set.
  Nef2& operator*=(const Nef2& other) { return *this = *this * other; }
  Nef2& operator-=(const Nef2& other) { return *this = *this - other; }  ///< without another set
  /// Symmetric difference with another set.
  Nef2& operator^=(const Nef2& other) { return *this = *this ^ other; }
  friend Nef2 operator+(const Nef2& a, const Nef2& b);
  friend Nef2 operator*(const Nef2& a, const Nef2& b);
  friend Nef2 operator-(const Nef2& a, const Nef2& b);
  friend Nef2 operator^(const Nef2& a, const Nef2& b);

  /// The same set? O(n): minimal complexes are compared.
  friend bool operator==(const Nef2& a, const Nef2& b);
  /// Inclusion.
  friend bool operator<=(const Nef2& a, const Nef2& b);
  friend bool operator<(const Nef2& a, const Nef2& b) { return a <= b && !(a == b); }
  friend bool operator>=(const Nef2& a, const Nef2& b) { return b <= a; }
  friend bool operator>(const Nef2& a, const Nef2& b) { return b < a; }

  /// Every invariant, from scratch; names the first one broken and where. O(n log n).
  std::optional<DcelFlaw> audit() const;

 private:
  struct [[gnu::visibility("hidden")]] State;
  explicit Nef2(PlaneComplex minimal);
  const PlaneLocator& locator() const;
  const PlaneTrapezoids& trapezoids() const;

  std::shared_ptr<const State> state_;
};

/// Which marks take part in an operation: those of the elements accepted; others count as unmarked.
/// An empty function accepts all.
struct PlaneSelector {
  std::function<bool(VertexId)> vertex;  ///< empty: all
  std::function<bool(EdgeId)> edge;      ///< empty: all
  std::function<bool(FaceId)> face;      ///< empty: all
};

/// The points p with f(p in a, p in b). With kUnion, kIntersection, ... what + * - ^ do.
Nef2 combine(const Nef2& a, const Nef2& b, MarkFunction f, Context& context);
/// The same, with the elements of each operand that a selector accepts.
Nef2 combine(const Nef2& a, const PlaneSelector& select_a, const Nef2& b,
             const PlaneSelector& select_b, MarkFunction f, Context& context);
/// Union (intersection) of any number of sets, pairwise in a balanced tree. Of none: the empty set
/// (the plane).
Nef2 union_of(std::span<const Nef2> sets, Context& context);
Nef2 intersection_of(std::span<const Nef2> sets, Context& context);  ///< See union_of().

}  // namespace plumb
#pragma GCC visibility pop
