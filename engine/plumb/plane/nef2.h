// Nef polyhedra in the plane. These are the sets that can be made from open and closed half-planes
// by unions, intersections and complements. Each edge and each vertex of the boundary may belong to
// the set or not. A set may be unbounded, and may have isolated points, slits, rays and lines.
//
// A set is stored as its unique minimal complex (plane_complex.h). The complex consists of
// vertices, edges and faces. The mark of each cell states whether the cell belongs to the set.
// Equal sets have equal complexes.
//
// Main flow of every Boolean operation:
//  1. SweepInput        collects the edges of all operands as curves, with one common table of
//                       points
//  2. sweep             visits all events in one exact sweep (sweep.h), which handles rays and
//                       lines like segments
//  3. PlaneBuilder      labels each face of the arrangement with the faces of the operands that
//                       contain it, upward through each event. A rule computes the mark of each
//                       cell from the labels. An edge is kept only if its mark differs from the
//                       mark of a face beside it. A vertex is dropped if it is only a point of one
//                       straight edge, or of one face, with the same mark.
//  4. PlaneAssembler    joins the ends at infinity by the edges of the frame, traces the boundaries
//                       of faces, nests each component in the face below it, and removes points
//                       that are not used
// Unary topological operators set new marks and remove redundant cells. They take O(n) and make no
// sweep.
//
// A Nef2 is an immutable value. Copies share their complex and cost O(1). Several threads may call
// const members of the same set concurrently. Every operation gives the strong exception guarantee.
//
// Cost: binary operations take O((n + k) log n) for n edges and k crossings. Unary operations take
// O(n). locate() takes O(log^2 n), after an index has been built once per set in O(n log^2 n).
// Memory is O(n).
//
// Errors: Error{NotFinite} for coordinates that are not finite; Error{BadArgument} where stated;
// ResourceLimit and Cancelled as the Context demands.
//
// Source: W. Bieri and W. Nef, Elementary set operations with d-dimensional polyhedra, LNCS 333
// (1988); M. Seel, Implementation of planar Nef polyhedra, MPI-I-2001-1-003 (2001). Here a frame
// without coordinates replaces Seel's infimaximal frame (docs/design/frame.md).
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

/// A directed line from a through b. Its left side consists of the points p with
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

/// The first cell that a ray meets, and the first point of that cell on the ray. If the ray enters
/// a face through a boundary that does not belong to the set, the face has no first point on the
/// ray. Then `point` is the point where the ray crosses this boundary.
struct PlaneHit {
  PlaneLocation location;  ///< The cell that the ray meets.
  RationalPoint2 point;    ///< The point where the ray meets the cell.
};

/// A polygon with holes. Its boundary consists of rings. No ring repeats a point, but rings may
/// touch each other at points.
struct PolygonWithHoles2 {
  std::vector<RationalPoint2> outer;               ///< The outer ring, counter-clockwise.
  std::vector<std::vector<RationalPoint2>> holes;  ///< The rings of the holes, clockwise.
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

/// The counts of the ordinary cells. Cells of the frame are not counted.
struct PlaneCounts {
  std::size_t vertices = 0;      ///< Corners, ends and isolated vertices.
  std::size_t edges = 0;         ///< Segments, rays and lines.
  std::size_t faces = 0;         ///< Bounded and unbounded faces.
  std::size_t marked_faces = 0;  ///< Faces that belong to the set.
  friend bool operator==(const PlaneCounts&, const PlaneCounts&) = default;
};

/// Selects the cells of an operand whose marks an operation uses. A cell that is not accepted
/// counts as unmarked. An empty function accepts every cell.
struct PlaneSelector {
  std::function<bool(VertexId)> vertex;  ///< Accepts vertices.
  std::function<bool(EdgeId)> edge;      ///< Accepts edges.
  std::function<bool(FaceId)> face;      ///< Accepts faces.
};

class [[gnu::visibility("hidden")]] PlaneLocator;
class [[gnu::visibility("hidden")]] PlaneTrapezoids;
class Nef2;

/// Returns the set of the points p for which f(p in a, p in b) is true.
[[nodiscard]] Nef2 boolean_op(const Nef2& a, const Nef2& b, MarkFunction f,
                              Context& context = unlimited_context());
/// Returns boolean_op(a, b, f) of the operands in which only accepted cells keep their marks: a
/// cell that the selector of its operand does not accept counts as unmarked.
[[nodiscard]] Nef2 boolean_op(const Nef2& a, const PlaneSelector& select_a, const Nef2& b,
                              const PlaneSelector& select_b, MarkFunction f,
                              Context& context = unlimited_context());
/// Returns the union of any number of sets. The union is computed from pairs in a balanced binary
/// tree. The union of zero sets is empty.
[[nodiscard]] Nef2 union_of(std::span<const Nef2> sets, Context& context = unlimited_context());
/// Returns the intersection of any number of sets, computed in the same way as union_of(). The
/// intersection of zero sets is the plane.
[[nodiscard]] Nef2 intersection_of(std::span<const Nef2> sets,
                                   Context& context = unlimited_context());

// The operators of Nef's algebra. They are declared here because g++ does not export a friend that
// is declared only inside its class.
[[nodiscard]] Nef2 operator+(const Nef2& a, const Nef2& b);  ///< Returns the union.
[[nodiscard]] Nef2 operator*(const Nef2& a, const Nef2& b);  ///< Returns the intersection.
[[nodiscard]] Nef2 operator-(const Nef2& a, const Nef2& b);  ///< Returns the difference.
/// Returns the symmetric difference: the points that belong to exactly one of the two sets. (In the
/// library Manifold, `^` is the intersection.)
[[nodiscard]] Nef2 operator^(const Nef2& a, const Nef2& b);
[[nodiscard]] bool operator==(const Nef2& a, const Nef2& b);  ///< Whether both are the same set.

/// A set of the plane. The head of this file describes it.
class Nef2 {
 public:
  // --- types of the grammar of sets (nef_set.h) -------------------------------------------------

  using Point = RationalPoint2;    ///< An element of the set.
  using Complex = PlaneComplex;    ///< The representation of the set.
  using Marks = PlaneMarks;        ///< One mark for each cell.
  using Counts = PlaneCounts;      ///< Counts of cells.
  using Location = PlaneLocation;  ///< The cell that contains a point.
  using Hit = PlaneHit;            ///< The first cell that a ray meets.
  using Selector = PlaneSelector;  ///< The cells whose marks an operation uses.
  using Flaw = DcelFlaw;           ///< A broken invariant.

  // --- sets to start from -----------------------------------------------------------------------

  Nef2();                                               ///< Makes the empty set.
  [[nodiscard]] static Nef2 empty() { return Nef2(); }  ///< Returns the set without points.
  [[nodiscard]] static Nef2 whole();                    ///< Returns the plane.

  /// Returns the half-plane to the left of a line. Throws Error{BadArgument} if line.a equals
  /// line.b.
  [[nodiscard]] static Nef2 half_plane(const Line2& line, Boundary boundary);
  /// Returns the half-plane bounded by the line that contains the point `kept`. Throws
  /// Error{BadArgument} if `kept` lies on the line, or if line.a equals line.b.
  [[nodiscard]] static Nef2 half_plane(const Line2& line, const RationalPoint2& kept,
                                       Boundary boundary);
  /// Returns the set of the points of a line. Throws Error{BadArgument} if line.a equals line.b.
  [[nodiscard]] static Nef2 line(const Line2& line);
  /// Returns the ray from line.a through line.b. The origin line.a belongs to the set if `boundary`
  /// is Closed. Throws Error{BadArgument} if line.a equals line.b.
  [[nodiscard]] static Nef2 ray(const Line2& line, Boundary boundary);

  /// Returns the set that closed chains of points bound. Chain c has the points
  /// corners[chain_begin[c]], ..., corners[chain_begin[c + 1] - 1]. Its last point is joined to its
  /// first point. A face belongs to the set if `rule` accepts its winding number. `boundary`
  /// decides about the edges and vertices on the chains:
  ///   Closed  An edge belongs to the set in two cases: if a face beside it does, or if the chains
  ///           run over it equally often in both directions (a spike). A vertex belongs to the set
  ///           if an edge or face around it does, or if it is a chain of one point.
  ///   Open    Usually no edge on a chain belongs to the set. The exception is an edge that can be
  ///           crossed without leaving the inside: the rule must accept the winding number after
  ///           each crossed chain, for every order of the chains that run over the edge. A vertex
  ///           belongs to the set if all edges and faces around it do.
  [[nodiscard]] static Nef2 polygons(const PointTable2& points,
                                     std::span<const std::uint32_t> corners,
                                     std::span<const std::uint32_t> chain_begin, WindingRule rule,
                                     Boundary boundary, Context& context = unlimited_context());
  /// Returns the set that one closed chain bounds under WindingRule::NonZero. The direction of the
  /// chain does not matter. A chain without points gives the empty set.
  [[nodiscard]] static Nef2 polygon(std::span<const Point2> points,
                                    Boundary boundary = Boundary::Closed,
                                    Context& context = unlimited_context());
  /// Returns the set of the points on open chains. Segments join consecutive points of a chain. A
  /// chain of one point contributes this point. The arrays have the form that polygons() takes.
  [[nodiscard]] static Nef2 polylines(const PointTable2& points,
                                      std::span<const std::uint32_t> corners,
                                      std::span<const std::uint32_t> chain_begin,
                                      Context& context = unlimited_context());
  /// Returns the union of the closed segments between consecutive points.
  [[nodiscard]] static Nef2 polyline(std::span<const Point2> points,
                                     Context& context = unlimited_context());
  /// Returns the set of these points. Equal points count once.
  [[nodiscard]] static Nef2 points(const PointTable2& points,
                                   Context& context = unlimited_context());
  [[nodiscard]] static Nef2 point(const RationalPoint2& point);  ///< Returns the set of one point.

  /// Returns the union of chosen regions of a checked subdivision: the closure of the union if
  /// `boundary` is Closed, the interior of the closure if it is Open. The flag chosen[r] selects
  /// report.regions[r]. Throws Error{BadArgument} if the verdict is not Valid, or if `chosen` and
  /// report.regions have different sizes.
  [[nodiscard]] static Nef2 subdivision(const MapReport& report,
                                        std::span<const std::uint8_t> chosen, Boundary boundary,
                                        Context& context = unlimited_context());

  /// Returns the set that a complex with its marks represents. The complex need not be minimal; the
  /// function brings it into minimal form. Requires that audit(complex, AuditForm::Any) finds no
  /// flaw.
  [[nodiscard]] static Nef2 from_complex(PlaneComplex complex,
                                         Context& context = unlimited_context());
  /// Returns the set of a complex that is already in minimal form. This function checks nothing.
  /// audit() checks whether the complex is sound and minimal.
  [[nodiscard]] static Nef2 from_minimal_unchecked(PlaneComplex complex) {
    return Nef2(std::move(complex));
  }
  /// Returns the set represented by the complex of this set with the given marks. Throws
  /// Error{BadArgument} if `marks` does not have exactly one mark for each cell. O(n).
  [[nodiscard]] Nef2 with_marks(PlaneMarks marks, Context& context = unlimited_context()) const;

  // --- reading ----------------------------------------------------------------------------------

  /// Returns the minimal complex: vertices, half-edges and faces, with their geometry and marks.
  [[nodiscard]] const PlaneComplex& complex() const&;
  /// Returns the complex of an expiring set. The complex is moved out, or copied if other sets
  /// share it.
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
  /// Whether every point of this set belongs to `other`. The cost is that of a set difference.
  [[nodiscard]] bool is_subset_of(const Nef2& other, Context& context = unlimited_context()) const;

  /// Whether the point belongs to the set. The cost is that of locate().
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

  /// Returns the first marked cell that the ray from `origin` meets, or nullopt if it meets none.
  /// The first cell of the ray is the one that contains `origin`. Throws Error{BadArgument} if the
  /// direction is zero. The first call builds an index. Later calls take O(log n) for each cell on
  /// the way, plus O(1) for each trapezoid on the way (of the vertical decomposition of the faces).
  [[nodiscard]] std::optional<PlaneHit> shoot(const RationalPoint2& origin,
                                              const RationalPoint2& direction,
                                              Context& context = unlimited_context()) const;
  /// Returns the first vertex or edge that the ray meets, whether marked or not, or nullopt if it
  /// meets none. If `origin` lies on a vertex or edge, this is the first one. Errors and cost are
  /// those of shoot().
  [[nodiscard]] std::optional<PlaneHit> shoot_to_boundary(
      const RationalPoint2& origin, const RationalPoint2& direction,
      Context& context = unlimited_context()) const;

  /// Returns the exact area, or nullopt if it is infinite. Cost: the sum of O(n) rational terms.
  [[nodiscard]] std::optional<Rational> area(Context& context = unlimited_context()) const;
  /// Returns area(). Nef3::measure() returns the volume, so generic code can call measure() for
  /// sets of the plane and of space.
  [[nodiscard]] std::optional<Rational> measure(Context& context = unlimited_context()) const {
    return area(context);
  }

  /// Returns the closure as polygons, lines and points. O(n log n).
  [[nodiscard]] PlaneParts parts(Context& context = unlimited_context()) const;

  /// Checks every invariant from scratch. Returns the first broken invariant and where it is
  /// broken, or nullopt if all hold. O(n log n).
  [[nodiscard]] std::optional<DcelFlaw> audit(Context& context = unlimited_context()) const;

  // --- operations -------------------------------------------------------------------------------

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

  std::shared_ptr<State> state_;  // Changed only by a set that is its sole owner.
};

}  // namespace plumb
#pragma GCC visibility pop
