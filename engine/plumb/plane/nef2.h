// Nef polyhedra in the plane: every set that unions, intersections and complements make from open
// and closed half-planes. A set is open or closed along every edge and at every vertex, bounded or
// not, and may have isolated points, slits, rays and lines.
//
// A set is held as its unique minimal complex (plane_complex.h): vertices, edges and faces, each
// with a mark that says whether it belongs to the set. Equal sets have equal complexes.
//
// Main flow of every operation:
//  1. SweepInput        collects the edges of all operands as curves over one table of points
//  2. sweep             visits all events in one exact sweep (sweep.h); unbounded curves are
//                       ordinary
//  3. PlaneBuilder      carries a label upward through each event (the operands' faces just there),
//                       asks the rule for marks and keeps an edge only if its mark differs from a
//                       face beside it, a vertex only if it is more than a point of its edge or
//                       face
//  4. PlaneAssembler    joins unbounded ends into the frame, traces the boundaries, nests
//                       components in the face below them, compacts the points
// Unary topology operators re-mark and simplify in O(n), without a sweep.
//
// A Nef2 is an immutable value: copies share their complex and cost O(1), and const members may be
// called from several threads at once. Every operation gives the strong exception guarantee.
//
// Cost: binary operations take O((n + k) log n) for n edges and k crossings, unary ones O(n), and
// locate O(log^2 n) after O(n log^2 n) once per set. Memory is O(n). Errors: Error{NotFinite} for
// coordinates that are not finite, Error{BadArgument} where stated; ResourceLimit and Cancelled as
// the Context demands. Source: W. Bieri and W. Nef, Elementary set operations with d-dimensional
// polyhedra, LNCS 333 (1988); M. Seel, Implementation of planar Nef polyhedra, MPI-I-2001-1-003
// (2001), whose infimaximal frame is replaced by a frame without coordinates
// (docs/design/frame.md).
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
#include "plumb/base/nef_set.h"
#include "plumb/plane/map_check.h"
#include "plumb/plane/plane_complex.h"

#pragma GCC visibility push(default)
namespace plumb {

/// A directed line. Its left side consists of the points p with (b - a) x (p - a) > 0.
struct Line2 {
  RationalPoint2 a;  ///< A point on the line.
  RationalPoint2 b;  ///< Another point on the line, different from a.

  /// Returns the line { a x + b y + c = 0 }, directed so that a x + b y + c < 0 on its left. Throws
  /// Error{BadArgument} if a = b = 0.
  [[nodiscard]] static Line2 from_coefficients(const Rational& a, const Rational& b,
                                               const Rational& c);
};

/// An affine map: (x, y) -> (xx x + xy y + x0, yx x + yy y + y0).
struct AffineMap2 {
  Rational xx = 1;  ///< Coefficient of x in x'.
  Rational xy = 0;  ///< Coefficient of y in x'.
  Rational x0 = 0;  ///< Constant of x'.
  Rational yx = 0;  ///< Coefficient of x in y'.
  Rational yy = 1;  ///< Coefficient of y in y'.
  Rational y0 = 0;  ///< Constant of y'.
};

/// The first cell that a ray meets, and the first point of that cell on the ray. For a face that
/// the ray enters through an open boundary this is the infimum: the point on that boundary.
struct PlaneHit {
  PlaneLocation location;  ///< The cell that is met.
  RationalPoint2 point;    ///< Where it is met.
};

/// A polygon with holes. No ring repeats a point; rings may touch each other at points.
struct PolygonWithHoles2 {
  std::vector<RationalPoint2> outer;               ///< Counter-clockwise.
  std::vector<std::vector<RationalPoint2>> holes;  ///< Clockwise.
};

/// The closure of a set, sorted by dimension; nothing is listed twice.
struct PlaneParts {
  std::vector<PolygonWithHoles2> polygons;  ///< Closures of the bounded marked faces.
  /// Chains of segments that bound no marked face. A closed chain repeats its first point.
  std::vector<std::vector<RationalPoint2>> lines;
  std::vector<RationalPoint2> points;  ///< Isolated points.
  bool dropped_unbounded = false;      ///< Whether unbounded faces, rays or lines were left out.
  bool dropped_open = false;  ///< Whether the set was not closed, so that parts were added.
  /// Whether points inside the closure were added: of a crack or puncture in a face, or of a gap
  /// between two edges. False if only ends and borders were added, as after every difference.
  bool filled = false;
};

/// The numbers of cells that a user sees; cells of the frame are not counted.
struct PlaneCounts {
  std::size_t vertices = 0;      ///< Corners, ends and isolated vertices.
  std::size_t edges = 0;         ///< Segments, rays and lines.
  std::size_t faces = 0;         ///< Bounded and unbounded faces.
  std::size_t marked_faces = 0;  ///< Faces that belong to the set.
  friend bool operator==(const PlaneCounts&, const PlaneCounts&) = default;
};

/// Selects the marks that take part in an operation: those of the cells that are accepted. Other
/// cells count as unmarked. An empty function accepts every cell.
struct PlaneSelector {
  std::function<bool(VertexId)> vertex;  ///< Accepts vertices.
  std::function<bool(EdgeId)> edge;      ///< Accepts edges.
  std::function<bool(FaceId)> face;      ///< Accepts faces.
};

class [[gnu::visibility("hidden")]] PlaneLocator;
class [[gnu::visibility("hidden")]] PlaneTrapezoids;
class Nef2;

/// Returns the points p for which f(p in a, p in b) holds.
[[nodiscard]] Nef2 boolean_op(const Nef2& a, const Nef2& b, MarkFunction f,
                              Context& context = unlimited_context());
/// Returns the same as boolean_op(a, b, f), where only the cells that the selectors accept count as
/// marked.
[[nodiscard]] Nef2 boolean_op(const Nef2& a, const PlaneSelector& select_a, const Nef2& b,
                              const PlaneSelector& select_b, MarkFunction f,
                              Context& context = unlimited_context());
/// Returns the union of any number of sets, computed pairwise in a balanced tree. The union of no
/// sets is empty.
[[nodiscard]] Nef2 union_of(std::span<const Nef2> sets, Context& context = unlimited_context());
/// Returns the intersection of any number of sets, as union_of() does. The intersection of no sets
/// is the plane.
[[nodiscard]] Nef2 intersection_of(std::span<const Nef2> sets,
                                   Context& context = unlimited_context());

// The operators of Nef's algebra. Declared here because g++ does not export a friend that is
// declared in its class alone.
[[nodiscard]] Nef2 operator+(const Nef2& a, const Nef2& b);  ///< Returns the union.
[[nodiscard]] Nef2 operator*(const Nef2& a, const Nef2& b);  ///< Returns the intersection.
[[nodiscard]] Nef2 operator-(const Nef2& a, const Nef2& b);  ///< Returns the difference.
/// Returns the symmetric difference: the points of exactly one of the sets. (In Manifold `^` is the
/// intersection.)
[[nodiscard]] Nef2 operator^(const Nef2& a, const Nef2& b);
[[nodiscard]] bool operator==(const Nef2& a, const Nef2& b);  ///< Whether both are the same set.

/// A set of the plane. See the head of this file.
class Nef2 {
 public:
  // --- types of the grammar of sets (nef_set.h) -------------------------------------------------

  using Point = RationalPoint2;    ///< What the set consists of.
  using Complex = PlaneComplex;    ///< What represents the set.
  using Marks = PlaneMarks;        ///< One mark for each cell.
  using Counts = PlaneCounts;      ///< Numbers of cells.
  using Location = PlaneLocation;  ///< Where a point lies.
  using Hit = PlaneHit;            ///< What a ray meets.
  using Selector = PlaneSelector;  ///< Which cells take part in an operation.
  using Flaw = DcelFlaw;           ///< A broken invariant.

  // --- sets to start from -----------------------------------------------------------------------

  Nef2();                                               ///< Makes the empty set.
  [[nodiscard]] static Nef2 empty() { return Nef2(); }  ///< Returns the set without points.
  [[nodiscard]] static Nef2 whole();                    ///< Returns the plane.

  /// Returns the half-plane to the left of a line. Throws Error{BadArgument} if line.a = line.b.
  [[nodiscard]] static Nef2 half_plane(const Line2& line, Boundary boundary);
  /// Returns the half-plane on that side of the line on which `kept` lies. Throws
  /// Error{BadArgument} if `kept` lies on the line, or line.a = line.b.
  [[nodiscard]] static Nef2 half_plane(const Line2& line, const RationalPoint2& kept,
                                       Boundary boundary);
  /// Returns the points of a line. Throws Error{BadArgument} if line.a = line.b.
  [[nodiscard]] static Nef2 line(const Line2& line);
  /// Returns the ray from line.a through line.b, with its origin if `boundary` is Closed. Throws
  /// Error{BadArgument} if line.a = line.b.
  [[nodiscard]] static Nef2 ray(const Line2& line, Boundary boundary);

  /// Returns the set that closed chains of points bound under a winding rule. Chain c has the
  /// points corners[chain_begin[c]], ..., corners[chain_begin[c + 1] - 1]; its last point is joined
  /// to the first.
  ///   Closed  The inside with everything on the chains next to it. Where as many chains run one
  ///           way as the other (a spike: there and back) there is a marked edge; a chain of one
  ///           point is a marked point.
  ///   Open    The inside without what lies on the chains. A piece that lies on chains is inside
  ///           only if its winding numbers are, in whatever order the chains there are crossed; a
  ///           vertex only if everything around it is.
  [[nodiscard]] static Nef2 polygons(const PointTable2& points,
                                     std::span<const std::uint32_t> corners,
                                     std::span<const std::uint32_t> chain_begin, WindingRule rule,
                                     Boundary boundary, Context& context = unlimited_context());
  /// Returns the set that one chain bounds under WindingRule::NonZero, so that its direction does
  /// not matter. A chain without points gives the empty set.
  [[nodiscard]] static Nef2 polygon(std::span<const Point2> points,
                                    Boundary boundary = Boundary::Closed,
                                    Context& context = unlimited_context());
  /// Returns the points of open chains: consecutive points are joined by segments. A chain of one
  /// point is that point. The arrays are those of polygons().
  [[nodiscard]] static Nef2 polylines(const PointTable2& points,
                                      std::span<const std::uint32_t> corners,
                                      std::span<const std::uint32_t> chain_begin,
                                      Context& context = unlimited_context());
  /// Returns the closed segments from point to point.
  [[nodiscard]] static Nef2 polyline(std::span<const Point2> points,
                                     Context& context = unlimited_context());
  /// Returns the set of these points; equal points are one.
  [[nodiscard]] static Nef2 points(const PointTable2& points,
                                   Context& context = unlimited_context());
  [[nodiscard]] static Nef2 point(const RationalPoint2& point);  ///< Returns the set of one point.

  /// Returns the closure or the interior of the union of chosen regions of a checked subdivision;
  /// chosen[r] belongs to report.regions[r]. Throws Error{BadArgument} unless the verdict is Valid
  /// and the sizes agree.
  [[nodiscard]] static Nef2 subdivision(const MapReport& report,
                                        std::span<const std::uint8_t> chosen, Boundary boundary,
                                        Context& context = unlimited_context());

  /// Returns the set that a complex and its marks describe. The complex is brought into minimal
  /// form. Requires that audit(complex, AuditForm::Any) finds no flaw.
  [[nodiscard]] static Nef2 from_complex(PlaneComplex complex,
                                         Context& context = unlimited_context());
  /// Returns the set of a complex that is in minimal form already. Nothing is done or checked;
  /// audit() finds out.
  [[nodiscard]] static Nef2 from_minimal_unchecked(PlaneComplex complex) {
    return Nef2(std::move(complex));
  }
  /// Returns the set of this set's complex with other marks. Throws Error{BadArgument} unless there
  /// is one mark for each cell. O(n).
  [[nodiscard]] Nef2 with_marks(PlaneMarks marks, Context& context = unlimited_context()) const;

  // --- reading ----------------------------------------------------------------------------------

  /// Returns the minimal complex: vertices, half-edges and faces, their geometry and marks.
  [[nodiscard]] const PlaneComplex& complex() const&;
  /// Returns the complex of a set that is given up, without a copy unless the set shares it.
  [[nodiscard]] PlaneComplex complex() &&;
  [[nodiscard]] PlaneMarks marks() const;    ///< Returns the marks of all cells.
  [[nodiscard]] PlaneCounts counts() const;  ///< Returns the numbers of cells. O(n).
  /// Returns the memory of the complex in bytes, without the index for location. Copies share it.
  [[nodiscard]] std::size_t bytes() const;

  [[nodiscard]] bool is_empty() const;    ///< Whether the set has no points. O(1).
  [[nodiscard]] bool is_whole() const;    ///< Whether the set is the plane. O(1).
  [[nodiscard]] bool is_bounded() const;  ///< Whether the set lies in some disk. O(n).
  [[nodiscard]] bool is_closed() const;   ///< Whether the set is its own closure. O(n).
  [[nodiscard]] bool is_open() const;     ///< Whether the set is its own interior. O(n).
  /// Whether every point of this set belongs to `other`. Costs a difference.
  [[nodiscard]] bool is_subset_of(const Nef2& other, Context& context = unlimited_context()) const;

  /// Whether the point belongs to the set. Costs as locate().
  [[nodiscard]] bool contains(const RationalPoint2& p,
                              Context& context = unlimited_context()) const {
    return locate(p, context).marked;
  }
  /// Whether the point belongs to the set. Throws Error{NotFinite}.
  [[nodiscard]] bool contains(Point2 p, Context& context = unlimited_context()) const {
    return locate(p, context).marked;
  }
  /// Returns the cell on which a point lies. O(log^2 n) after the first call, which builds an
  /// index.
  [[nodiscard]] PlaneLocation locate(const RationalPoint2& p,
                                     Context& context = unlimited_context()) const;
  /// Returns the cell on which a point lies. Throws Error{NotFinite}.
  [[nodiscard]] PlaneLocation locate(Point2 p, Context& context = unlimited_context()) const;
  /// Whether the point lies on the boundary of the set. Isolated points and slits are boundary.
  [[nodiscard]] bool has_on_boundary(const RationalPoint2& p,
                                     Context& context = unlimited_context()) const;

  /// Returns the first marked cell that the ray from `origin` meets, which may be that of `origin`,
  /// or nothing. Throws Error{BadArgument} for the direction zero. O(log n) for each cell met, O(1)
  /// for each trapezoid of the vertical decomposition of its faces, after the first call, which
  /// builds an index.
  [[nodiscard]] std::optional<PlaneHit> shoot(const RationalPoint2& origin,
                                              const RationalPoint2& direction,
                                              Context& context = unlimited_context()) const;
  /// Returns the first vertex or edge that the ray meets, marked or not; one on which `origin` lies
  /// is met at once. Errors and cost as shoot().
  [[nodiscard]] std::optional<PlaneHit> shoot_to_boundary(
      const RationalPoint2& origin, const RationalPoint2& direction,
      Context& context = unlimited_context()) const;

  /// Returns the exact area, or nothing if it is infinite. O(n) rational terms.
  [[nodiscard]] std::optional<Rational> area(Context& context = unlimited_context()) const;
  /// Returns area(): the measure of the dimension, for code that serves plane and space.
  [[nodiscard]] std::optional<Rational> measure(Context& context = unlimited_context()) const {
    return area(context);
  }

  /// Returns the polygons, lines and points of the closure. O(n log n).
  [[nodiscard]] PlaneParts parts(Context& context = unlimited_context()) const;

  /// Checks every invariant from scratch and returns the first one that is broken, with its place,
  /// or nothing. O(n log n).
  [[nodiscard]] std::optional<DcelFlaw> audit(Context& context = unlimited_context()) const;

  // --- operations -------------------------------------------------------------------------------

  /// Returns the points that do not belong to the set. O(n).
  [[nodiscard]] Nef2 complement(Context& context = unlimited_context()) const;
  /// Returns the set without its boundary. O(n).
  [[nodiscard]] Nef2 interior(Context& context = unlimited_context()) const;
  /// Returns the set with its boundary. O(n).
  [[nodiscard]] Nef2 closure(Context& context = unlimited_context()) const;
  /// Returns the closure without the interior. O(n).
  [[nodiscard]] Nef2 boundary(Context& context = unlimited_context()) const;
  /// Returns the interior of the complement. O(n).
  [[nodiscard]] Nef2 exterior(Context& context = unlimited_context()) const;
  /// Returns the closure of the interior. O(n).
  [[nodiscard]] Nef2 regularization(Context& context = unlimited_context()) const;

  /// Returns the image under an invertible map. Throws Error{BadArgument} if the determinant is 0.
  /// O(n log n).
  [[nodiscard]] Nef2 transformed(const AffineMap2& map,
                                 Context& context = unlimited_context()) const;

  [[nodiscard]] Nef2 operator!() const { return complement(); }  ///< Returns complement().
  /// Unites this set with another one.
  Nef2& operator+=(const Nef2& other) { return *this = *this + other; }
  /// Intersects this set with another one.
  Nef2& operator*=(const Nef2& other) { return *this = *this * other; }
  /// Removes the points of another set.
  Nef2& operator-=(const Nef2& other) { return *this = *this - other; }
  /// Replaces this set by the symmetric difference with another one.
  Nef2& operator^=(const Nef2& other) { return *this = *this ^ other; }
  friend bool operator==(const Nef2& a, const Nef2& b);

 private:
  struct [[gnu::visibility("hidden")]] State;
  explicit Nef2(PlaneComplex minimal);
  const PlaneLocator& locator() const;
  const PlaneTrapezoids& trapezoids() const;

  std::shared_ptr<State> state_;  // changed only by who holds it alone
};

}  // namespace plumb
#pragma GCC visibility pop
