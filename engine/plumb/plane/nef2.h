// Nef polyhedra in the plane. A Nef polyhedron in the plane is a set that can be made from finitely
// many open and closed half-planes by unions, intersections and complements. Each edge and each
// vertex of its boundary may belong to the set or not. The set may be unbounded. The set may have
// isolated points, slits, rays and lines.
//
// A set is stored as its unique minimal complex (plane_complex.h). The complex consists of
// vertices, edges and faces. The mark of each cell states whether the cell belongs to the set.
// Equal sets have equal complexes.
//
// Main flow of every Boolean operation:
//  1. SweepInput        collects the edges of all operands as curves. All curves refer to one
//                       common table of points.
//  2. sweep             visits all events in one exact sweep (sweep.h), which handles rays and
//                       lines like segments
//  3. PlaneBuilder      gives each face of the arrangement a label, which lists the faces of the
//                       operands that contain this face. At each event, labels are computed from
//                       bottom to top. A rule computes the mark of each cell from the labels. An
//                       edge is kept only if its mark differs from the mark of a face beside it. A
//                       vertex is dropped in two cases: if it lies inside a straight edge with the
//                       same mark, or inside a face with the same mark.
//  4. PlaneAssembler    joins the ends at infinity by the edges of the frame, and traces the
//                       boundaries of faces. Then, for each connected component, it finds the face
//                       that contains the component. Finally, it removes points that are not used.
// Unary topological operators set new marks and remove redundant cells. These operators take O(n)
// and need no sweep.
//
// A Nef2 is an immutable value. Copies share their complex and cost O(1). Several threads may call
// const members of the same set concurrently. Every operation gives the strong exception guarantee.
//
// Cost: binary operations take O((n + k) log n) for n edges and k crossings. Unary operations take
// O(n). locate() takes O(log^2 n). The first call of locate() for a set also builds an index, in
// O(n log^2 n). Memory is O(n). In the comments of members, n is the number of edges, too.
//
// Errors: all functions throw Error{NotFinite} for coordinates that are not finite. All functions
// throw ResourceLimit if a limit of the Context is exceeded, and Cancelled if a stop is requested.
// A function throws Error{BadArgument} only if its comment states this.
//
// Source: W. Bieri and W. Nef, Elementary set operations with d-dimensional polyhedra, LNCS 333
// (1988); M. Seel, Implementation of planar Nef polyhedra, MPI-I-2001-1-003 (2001). This library
// replaces Seel's infimaximal frame by a frame without coordinates (docs/design/frame.md).
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

/// A directed line from a through b. The left side of the line consists of the points p with
/// cross(b - a, p - a) > 0.
struct Line2 {
  RationalPoint2 a;  ///< A point on the line.
  RationalPoint2 b;  ///< Another point on the line, different from a.

  /// Returns the line { a x + b y + c = 0 }, directed so that a x + b y + c < 0 on its left. Throws
  /// Error{BadArgument} if a and b are both 0.
  [[nodiscard]] static Line2 from_coefficients(const Rational& a, const Rational& b,
                                               const Rational& c);
};

/// An affine map (x, y) -> (x', y') with x' = xx * x + xy * y + x0 and y' = yx * x + yy * y + y0.
struct AffineMap2 {
  Rational xx = 1;  ///< Coefficient of x in x'.
  Rational xy = 0;  ///< Coefficient of y in x'.
  Rational x0 = 0;  ///< Constant term of x'.
  Rational yx = 0;  ///< Coefficient of x in y'.
  Rational yy = 1;  ///< Coefficient of y in y'.
  Rational y0 = 0;  ///< Constant term of y'.
};

/// The result of shoot() or shoot_to_boundary(): a cell that a ray meets, and the first point of
/// this cell on the ray. A face does not contain its boundary. So if the ray enters a face, `point`
/// is the point where the ray crosses the boundary of the face.
struct PlaneHit {
  PlaneLocation location;  ///< The cell that the ray meets.
  RationalPoint2 point;    ///< The point where the ray meets the cell.
};

/// A polygon with holes. The boundary of the polygon consists of rings. No ring visits a point
/// twice. Different rings may touch each other at points.
struct PolygonWithHoles2 {
  std::vector<RationalPoint2> outer;               ///< The outer ring, counter-clockwise.
  std::vector<std::vector<RationalPoint2>> holes;  ///< The rings of the holes, clockwise.
};

/// The closure of a set, as polygons, lines and points. Every part of the closure is listed once,
/// with the highest possible dimension.
struct PlaneParts {
  std::vector<PolygonWithHoles2> polygons;  ///< Closures of the bounded marked faces.
  /// Chains of segments. None of these segments lies on the boundary of a marked face. A closed
  /// chain repeats its first point at its end.
  std::vector<std::vector<RationalPoint2>> lines;
  std::vector<RationalPoint2> points;  ///< Isolated points.
  bool dropped_unbounded = false;      ///< Whether unbounded faces, rays or lines were left out.
  /// Whether the set is not closed. If it is not closed, its closure has additional points.
  bool dropped_open = false;
  /// Whether some of the additional points do not lie on the border of the closure. Such points
  /// fill a crack or a puncture in a face, or a gap of one point between two edges. The value is
  /// false if every additional point lies on the border of a face of the closure, or is an end of a
  /// chain of edges. The value is usually false for a difference of closed sets.
  bool filled = false;
};

class Nef2;

/// Whether the closure of a set has additional points that are not on the border of the closure
/// (PlaneParts::filled). O(n).
[[nodiscard]] bool closure_fills_inside(const Nef2& set);

/// The counts of the cells of a set. Cells of the frame are not counted.
struct PlaneCounts {
  std::size_t vertices = 0;      ///< Corners, ends and isolated vertices.
  std::size_t edges = 0;         ///< Segments, rays and lines.
  std::size_t faces = 0;         ///< Bounded and unbounded faces.
  std::size_t marked_faces = 0;  ///< Faces that belong to the set.
  friend bool operator==(const PlaneCounts&, const PlaneCounts&) = default;
};

/// Selects cells of an operand. The operation uses the marks of accepted cells, and treats all
/// other cells as unmarked. An empty function accepts every cell.
struct PlaneSelector {
  std::function<bool(VertexId)> vertex;  ///< Accepts vertices.
  std::function<bool(EdgeId)> edge;      ///< Accepts edges.
  std::function<bool(FaceId)> face;      ///< Accepts faces.
};

// These declarations have no visibility attributes, because g++ warns about attributes here if the
// classes are already defined.
#pragma GCC visibility push(hidden)
class PlaneLocator;
class PlaneTrapezoids;
#pragma GCC visibility pop

/// Returns the set of the points p for which f(p in a, p in b) is true.
[[nodiscard]] Nef2 boolean_op(const Nef2& a, const Nef2& b, MarkFunction f,
                              Context& context = unlimited_context());
/// Returns boolean_op(a', b', f). The set a' is made from a: all cells that `select_a` does not
/// accept become unmarked. The set b' is made in the same way from b and `select_b`.
[[nodiscard]] Nef2 boolean_op(const Nef2& a, const PlaneSelector& select_a, const Nef2& b,
                              const PlaneSelector& select_b, MarkFunction f,
                              Context& context = unlimited_context());
/// Returns the union of any number of sets. The union is computed by a balanced binary tree of
/// unions of two sets. The union of no sets is empty.
[[nodiscard]] Nef2 union_of(std::span<const Nef2> sets, Context& context = unlimited_context());
/// Returns the intersection of any number of sets, computed in the same way as union_of(). The
/// intersection of no sets is the whole plane.
[[nodiscard]] Nef2 intersection_of(std::span<const Nef2> sets,
                                   Context& context = unlimited_context());
/// Returns the points of a that belong to none of the other sets.
[[nodiscard]] Nef2 difference_of(const Nef2& a, std::span<const Nef2> others,
                                 Context& context = unlimited_context());

// The operators of Nef's algebra. These operators are declared outside the class because g++ does
// not export a friend that is declared only inside its class.
[[nodiscard]] Nef2 operator+(const Nef2& a, const Nef2& b);  ///< Returns the union.
[[nodiscard]] Nef2 operator*(const Nef2& a, const Nef2& b);  ///< Returns the intersection.
[[nodiscard]] Nef2 operator-(const Nef2& a, const Nef2& b);  ///< Returns the difference.
/// Returns the symmetric difference: the points that belong to exactly one of the two sets. (In the
/// library Manifold, `^` is the intersection.)
[[nodiscard]] Nef2 operator^(const Nef2& a, const Nef2& b);
[[nodiscard]] bool operator==(const Nef2& a, const Nef2& b);  ///< Whether both sets are equal.

/// A set of the plane. The head of this file describes such sets.
class Nef2 {
 public:
  // --- types that all classes of sets have (nef_set.h) -----------------------------------------

  using Point = RationalPoint2;    ///< An element of the set.
  using Complex = PlaneComplex;    ///< The representation of the set.
  using Marks = PlaneMarks;        ///< One mark for each cell.
  using Counts = PlaneCounts;      ///< Counts of cells.
  using Location = PlaneLocation;  ///< The cell that contains a point.
  using Hit = PlaneHit;            ///< The first cell that a ray meets.
  using Selector = PlaneSelector;  ///< The cells whose marks an operation uses.
  using Flaw = DcelFlaw;           ///< A broken invariant and its location.

  // --- constructors ----------------------------------------------------------------------------

  Nef2();                                               ///< Makes the empty set.
  [[nodiscard]] static Nef2 empty() { return Nef2(); }  ///< Returns the set without points.
  [[nodiscard]] static Nef2 whole();                    ///< Returns the plane.

  /// Returns the half-plane to the left of a line. Throws Error{BadArgument} if line.a equals
  /// line.b.
  [[nodiscard]] static Nef2 half_plane(const Line2& line, Boundary boundary);
  /// Returns the half-plane that is bounded by `line` and contains the point `kept`. Throws
  /// Error{BadArgument} if `kept` lies on the line, or if line.a equals line.b.
  [[nodiscard]] static Nef2 half_plane(const Line2& line, const RationalPoint2& kept,
                                       Boundary boundary);
  /// Returns the set of the points of a line. Throws Error{BadArgument} if line.a equals line.b.
  [[nodiscard]] static Nef2 line(const Line2& line);
  /// Returns the ray from line.a through line.b. The origin line.a belongs to the set if `boundary`
  /// is Closed. Throws Error{BadArgument} if line.a equals line.b.
  [[nodiscard]] static Nef2 ray(const Line2& line, Boundary boundary);

  /// Returns the set that is bounded by closed chains of points. Chain c has the points
  /// corners[chain_begin[c]], ..., corners[chain_begin[c + 1] - 1]. The last point of a chain is
  /// joined to its first point. The chains divide the plane into faces. A face belongs to the set
  /// if `rule` accepts its winding number. `boundary` decides which edges and vertices on the
  /// chains belong to the set:
  ///   Closed  An edge belongs to the set in two cases: if a face beside it belongs to the set, or
  ///           if the chains run over the edge equally often in both directions (a spike). A vertex
  ///           belongs to the set if an edge or face around it belongs to the set, or if the vertex
  ///           is a chain of one point.
  ///   Open    Usually no edge on a chain belongs to the set. The exception is an edge at which no
  ///           chain separates inside from outside. To test an edge, start at the winding number of
  ///           the face on one side, and cross the chains that run over the edge one after the
  ///           other. The edge belongs to the set if `rule` accepts the winding number before and
  ///           after each crossing, for every order of the chains. A vertex belongs to the set if
  ///           all edges and faces around it belong to the set.
  [[nodiscard]] static Nef2 polygons(const PointTable2& points,
                                     std::span<const std::uint32_t> corners,
                                     std::span<const std::uint32_t> chain_begin, WindingRule rule,
                                     Boundary boundary, Context& context = unlimited_context());
  /// Returns the set that is bounded by one closed chain of points, according to
  /// WindingRule::NonZero. The direction of the chain does not matter. If there are no points, the
  /// set is empty.
  [[nodiscard]] static Nef2 polygon(std::span<const Point2> points,
                                    Boundary boundary = Boundary::Closed,
                                    Context& context = unlimited_context());
  /// Returns the set of the points on open chains. Segments join consecutive points of a chain. A
  /// chain of one point adds this point to the set. The arrays have the same form as in polygons().
  [[nodiscard]] static Nef2 polylines(const PointTable2& points,
                                      std::span<const std::uint32_t> corners,
                                      std::span<const std::uint32_t> chain_begin,
                                      Context& context = unlimited_context());
  /// Returns the union of the closed segments between consecutive points.
  [[nodiscard]] static Nef2 polyline(std::span<const Point2> points,
                                     Context& context = unlimited_context());
  /// Returns the set that consists of the given points. Points may be equal.
  [[nodiscard]] static Nef2 points(const PointTable2& points,
                                   Context& context = unlimited_context());
  [[nodiscard]] static Nef2 point(const RationalPoint2& point);  ///< Returns the set of one point.

  /// Returns the union of the chosen regions of a checked subdivision. If `boundary` is Closed, the
  /// result is the closure of this union. If `boundary` is Open, the result is the interior of the
  /// closure. The region report.regions[r] is chosen if chosen[r] is not 0. Throws
  /// Error{BadArgument} if the verdict is not Valid, or if `chosen` and report.regions have
  /// different sizes.
  [[nodiscard]] static Nef2 subdivision(const MapReport& report,
                                        std::span<const std::uint8_t> chosen, Boundary boundary,
                                        Context& context = unlimited_context());

  /// Returns the set that a complex with its marks represents. The complex need not be minimal,
  /// because the function makes it minimal. Requires that audit(complex, AuditForm::Any) finds no
  /// flaw.
  [[nodiscard]] static Nef2 from_complex(PlaneComplex complex,
                                         Context& context = unlimited_context());
  /// Returns the set that a complex represents. Requires that audit(complex, AuditForm::Minimal)
  /// finds no flaw. This function does not call audit(); a call of audit() for the result does.
  [[nodiscard]] static Nef2 from_minimal_unchecked(PlaneComplex complex) {
    return Nef2(std::move(complex));
  }
  /// Returns the set that the complex of this set represents after its marks are replaced by
  /// `marks`. Throws Error{BadArgument} if `marks` does not have exactly one mark for each cell.
  /// O(n).
  [[nodiscard]] Nef2 with_marks(PlaneMarks marks, Context& context = unlimited_context()) const;

  // --- reading ---------------------------------------------------------------------------------

  /// Returns the minimal complex: vertices, half-edges and faces, with their geometry and marks.
  [[nodiscard]] const PlaneComplex& complex() const&;
  /// Returns the complex of a temporary or moved set. The complex is moved out of the set. If other
  /// sets share the complex, it is copied.
  [[nodiscard]] PlaneComplex complex() &&;
  [[nodiscard]] PlaneMarks marks() const;    ///< Returns the marks of all cells.
  [[nodiscard]] PlaneCounts counts() const;  ///< Returns the counts of cells. O(n).
  /// Returns the memory of the complex in bytes. Copies of a set share this memory. The index of
  /// locate() is not included.
  [[nodiscard]] std::size_t bytes() const;

  [[nodiscard]] bool is_empty() const;    ///< Whether the set has no points. O(1).
  [[nodiscard]] bool is_whole() const;    ///< Whether the set is the plane. O(1).
  [[nodiscard]] bool is_bounded() const;  ///< Whether the set lies in some disk. O(n).
  [[nodiscard]] bool is_closed() const;   ///< Whether the set equals its closure. O(n).
  [[nodiscard]] bool is_open() const;     ///< Whether the set equals its interior. O(n).
  /// Whether every point of this set belongs to `other`. The test costs as much as the difference
  /// of the two sets.
  [[nodiscard]] bool is_subset_of(const Nef2& other, Context& context = unlimited_context()) const;

  /// Whether the point belongs to the set. The test costs as much as locate().
  [[nodiscard]] bool contains(const RationalPoint2& p,
                              Context& context = unlimited_context()) const {
    return locate(p, context).marked;
  }
  /// Whether the point belongs to the set. Throws Error{NotFinite} if a coordinate is not finite.
  [[nodiscard]] bool contains(Point2 p, Context& context = unlimited_context()) const {
    return locate(p, context).marked;
  }
  /// Returns the cell that contains a point. The first call builds an index; each later call takes
  /// O(log^2 n).
  [[nodiscard]] PlaneLocation locate(const RationalPoint2& p,
                                     Context& context = unlimited_context()) const;
  /// Returns the cell that contains a point. Throws Error{NotFinite} if a coordinate is not finite.
  [[nodiscard]] PlaneLocation locate(Point2 p, Context& context = unlimited_context()) const;
  /// Whether the point lies on the boundary of the set. Isolated points and slits belong to the
  /// boundary.
  [[nodiscard]] bool has_on_boundary(const RationalPoint2& p,
                                     Context& context = unlimited_context()) const;

  /// Returns the first marked cell that the ray from `origin` meets, or nullopt if the ray meets no
  /// marked cell. The first cell on the ray is the cell that contains `origin`. Throws
  /// Error{BadArgument} if the direction is zero. The first call builds an index. In this index,
  /// vertical lines cut the faces into trapezoids. Each later call takes O(log n) for each cell
  /// that the ray passes, plus O(1) for each trapezoid that it passes.
  [[nodiscard]] std::optional<PlaneHit> shoot(const RationalPoint2& origin,
                                              const RationalPoint2& direction,
                                              Context& context = unlimited_context()) const;
  /// Returns the first vertex or edge that the ray meets, whether it is marked or not. Returns
  /// nullopt if the ray meets no vertex and no edge. If `origin` lies on a vertex or edge, the
  /// function returns this vertex or edge. Errors and cost are the same as for shoot().
  [[nodiscard]] std::optional<PlaneHit> shoot_to_boundary(
      const RationalPoint2& origin, const RationalPoint2& direction,
      Context& context = unlimited_context()) const;

  /// Returns the exact area, or nullopt if the area is infinite. Cost: O(n) additions of rational
  /// numbers.
  [[nodiscard]] std::optional<Rational> area(Context& context = unlimited_context()) const;
  /// Returns area(). Generic code can call measure() for sets of the plane and for sets of space,
  /// because Nef3::measure() returns the volume.
  [[nodiscard]] std::optional<Rational> measure(Context& context = unlimited_context()) const {
    return area(context);
  }

  /// Returns the closure of the set as polygons, lines and points. O(n log n).
  [[nodiscard]] PlaneParts parts(Context& context = unlimited_context()) const;

  /// Checks every invariant from scratch. Returns the first broken invariant and its location, or
  /// nullopt if all invariants hold. O(n log n).
  [[nodiscard]] std::optional<DcelFlaw> audit(Context& context = unlimited_context()) const;

  // --- operations ------------------------------------------------------------------------------

  /// Returns the set of the points that do not belong to this set. O(n).
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

  /// Returns the image of the set under an invertible affine map. Throws Error{BadArgument} if the
  /// determinant of the map is 0. O(n log n).
  [[nodiscard]] Nef2 transformed(const AffineMap2& map,
                                 Context& context = unlimited_context()) const;

  [[nodiscard]] Nef2 operator!() const { return complement(); }  ///< Returns complement().
  /// Unites this set with another set.
  Nef2& operator+=(const Nef2& other) { return *this = *this + other; }
  /// Intersects this set with another set.
  Nef2& operator*=(const Nef2& other) { return *this = *this * other; }
  /// Removes the points of another set from this set.
  Nef2& operator-=(const Nef2& other) { return *this = *this - other; }
  /// Replaces this set by its symmetric difference with another set.
  Nef2& operator^=(const Nef2& other) { return *this = *this ^ other; }
  friend bool operator==(const Nef2& a, const Nef2& b);

 private:
  struct [[gnu::visibility("hidden")]] State;
  explicit Nef2(PlaneComplex minimal);
  const PlaneLocator& locator() const;
  const PlaneTrapezoids& trapezoids() const;

  std::shared_ptr<State> state_;  // Changed only by a set that is its sole owner.
};

}  // namespace plumb
#pragma GCC visibility pop
