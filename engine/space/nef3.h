// Nef polyhedra in space: every set that unions, intersections and complements make from open and
// closed half-spaces. Open or closed at every facet, edge and vertex, bounded or not, with dangling
// facets and edges, isolated points, parts that touch along edges or at vertices.
//
// A set is held as its unique minimal complex (space_complex.h): vertices, edges, facets and volumes,
// each with a mark that says whether it belongs to the set. Around every vertex the complex is a
// sphere map (sphere_map.h), and all operations work on these.
//
// Main flow of a Boolean (combine.h):
//  1. meet      where items of one operand touch items of the other; exact, found by boxes
//  2. locate    the other vertices lie in volumes of the other operand: flood, or one ray
//  3. overlay   of two sphere maps at each contact, marks through the function, minimal form
//  4. join      half-edges paired along lines, corners to cycles, cycles to facets, shells to volumes
// Unary topology operators re-mark and simplify in O(n).
//
// A Nef3 is an immutable value: copies share what they hold and cost O(1); const members may be called
// from several threads at once. Every operation gives the strong guarantee. Booleans add no planes:
// numbers never grow, whatever the number of operations.
//
// Cost: Booleans O((n + m + c) log(n + m + c)) for c pairs of boxes that meet; unary operations
// O(n). Errors: Error{NotFinite}, Error{BadArgument} where said; ResourceLimit and Cancelled by the
// Context. Source: Nef 1978; Hachenberger, Kettner, Mehlhorn, CGTA 38 (2007) 64-99.
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
#include "plumb/plane/nef2.h"
#include "plumb/predicates/rational_point.h"
#include "plumb/space/from_mesh.h"
#include "plumb/space/space_complex.h"
#include "plumb/space/space_locator.h"

#pragma GCC visibility push(default)
namespace plumb {

/// a x + b y + c z + d = 0 with (a, b, c) not zero. Below: a x + b y + c z + d < 0.
struct Plane3 {
  Rational a;  ///< normal, x
  Rational b;  ///< normal, y
  Rational c;  ///< normal, z
  Rational d;  ///< offset
};

/// What lies below a plane, with or without the plane.
struct HalfSpace3 {
  Plane3 plane;                          ///< the half-space lies below
  Boundary boundary = Boundary::Closed;  ///< is the plane part of it?
};

/// x -> matrix x + offset.
struct AffineMap3 {
  std::array<std::array<Rational, 3>, 3> matrix;  ///< rows
  std::array<Rational, 3> offset;                 ///< added last
};

/// Where a point lies.
struct SpaceLocation {
  SpaceItem item;       ///< vertex, edge, facet or volume
  bool marked = false;  ///< does the point belong to the set?
};

/// Marks of a complex, one for each item; those of the frame are not read.
struct SpaceMarks {
  std::vector<Mark> vertex;  ///< per vertex of the complex
  std::vector<Mark> edge;    ///< per edge
  std::vector<Mark> facet;   ///< per facet
  std::vector<Mark> volume;  ///< per volume
};

/// Items that a user sees: those of the frame are left out.
struct SpaceCounts {
  std::size_t vertices = 0;        ///< corners and isolated points
  std::size_t edges = 0;           ///< facets' edges and free ones
  std::size_t facets = 0;          ///< bounded or not
  std::size_t volumes = 0;         ///< with the unbounded ones
  std::size_t marked_volumes = 0;  ///< those that belong to the set
  friend bool operator==(const SpaceCounts&, const SpaceCounts&) = default;
};

// A friend that is declared in its class alone g++ does not export.
class Nef3;
Nef3 operator+(const Nef3& a, const Nef3& b);   ///< union
Nef3 operator*(const Nef3& a, const Nef3& b);   ///< intersection
Nef3 operator-(const Nef3& a, const Nef3& b);   ///< the first without the second
Nef3 operator^(const Nef3& a, const Nef3& b);   ///< symmetric difference
bool operator==(const Nef3& a, const Nef3& b);  ///< the same set?
bool operator<=(const Nef3& a, const Nef3& b);  ///< inclusion

/// A set of space: an immutable value, see above.
class Nef3 {
 public:
  // --- sets to start from ---------------------------------------------------------------------

  Nef3();                                 ///< the empty set
  static Nef3 empty() { return Nef3(); }  ///< No point.
  static Nef3 space();                    ///< Every point.

  /// Below the plane. Throws Error{BadArgument} when a = b = c = 0.
  static Nef3 half_space(const Plane3& plane, Boundary boundary);
  /// The side of the plane on which `kept` lies. Also throws when it lies on the plane.
  static Nef3 half_space(const Plane3& plane, const RationalPoint3& kept, Boundary boundary);
  /// The points of a plane. Throws Error{BadArgument} when a = b = c = 0.
  static Nef3 plane(const Plane3& plane);
  /// The intersection of any number of half-spaces; of none: the whole space.
  static Nef3 intersection(std::span<const HalfSpace3> half_spaces, Context& context);

  /// The volumes of a closed mesh with a winding number inside the rule, with their boundary. The mesh may
  /// cross itself, overlap, be doubled or inside out: a soup whose directed edges cancel. Throws
  /// Error{BadShape} for an open mesh: look at the report of complex_of_mesh() first.
  static Nef3 mesh(const MeshView& mesh, WindingRule rule, Context& context);
  static Nef3 mesh(MeshComplex mesh, WindingRule rule, Context& context);
  /// mesh() of each, several at a time where the context has threads.
  static std::vector<Nef3> meshes(std::span<const PolygonMesh> meshes, WindingRule rule,
                                  Context& context);
  /// The facets of a mesh, open or closed, crossing or not, with their boundary.
  static Nef3 surface(MeshComplex mesh, Context& context);
  /// A closed polygon in a plane. Throws Error{BadShape} unless it is planar and simple.
  static Nef3 facet(std::span<const Point3> corners);
  static Nef3 facet(std::span<const RationalPoint3> corners);
  /// All points between two, with them; one point if they are equal.
  static Nef3 segment(const RationalPoint3& a, const RationalPoint3& b);
  /// Closed segments from point to point.
  static Nef3 polyline(std::span<const RationalPoint3> points, Context& context);
  /// Several: polyline i is points[begin[i]] ... points[begin[i + 1] - 1]; `begin` ends with the number of points.
  /// Throws Error{BadArgument} unless it rises from 0 to that.
  static Nef3 polylines(std::span<const RationalPoint3> points,
                        std::span<const std::uint32_t> begin, Context& context);
  static Nef3 point(const RationalPoint3& at);  ///< One point.
  /// Isolated points; equal ones are one.
  static Nef3 points(std::span<const RationalPoint3> points, Context& context);

  /// Any complex, brought into minimal form. Requires audit(complex, false) to be clean.
  static Nef3 from_complex(SpaceComplex complex, Context& context);
  /// A complex in minimal form: nothing is done or checked. audit() tells.
  static Nef3 from_minimal(SpaceComplex complex) { return Nef3(std::move(complex)); }
  /// This set's complex with other marks (sizes must agree: Error{BadArgument}); those of the frame are
  /// not changed. O(n).
  Nef3 with_marks(const SpaceMarks& marks, Context& context) const;
  /// This set with other facet_origin ids (one for each facet of complex(): Error{BadArgument}). They
  /// follow facets through operations: a facet has the least id among those at its corners
  /// of the facets it came from, and pieces of one plane side by side are one facet. Not compared by ==.
  Nef3 with_origins(std::span<const std::uint32_t> facet_origin) const;
  /// All bounded volumes belong to it, too: what its boundary encloses. O(n).
  Nef3 with_bounded_volumes() const;

  // --- reading --------------------------------------------------------------------------------

  const SpaceComplex& complex() const;  ///< The minimal complex: all items with their marks.
  /// The complex of a set that is given up; copied if another set shares it.
  SpaceComplex taken() &&;
  SpaceCounts counts() const;  ///< How many items there are. O(n).

  bool is_empty() const;    ///< Is there no point in it? O(1).
  bool is_space() const;    ///< Is every point in it? O(1).
  bool is_bounded() const;  ///< Is it inside some ball? O(n).
  /// Is it its own closure (its own interior)? O(n).
  bool is_closed() const;
  bool is_open() const;  ///< Is it its own interior? O(n).
  /// Is the boundary a 2-manifold with the set on one side: no dangling parts, every edge between two
  /// facets, every vertex on one cone? Marks of the boundary do not matter. O(n).
  bool is_simple() const;
  /// Does it hold the segment between any two of its points? Open, closed, unbounded, flat: any set; the
  /// empty one does. Expected O(n).
  bool is_convex() const;

  /// Does the point belong to the set? As locate().
  bool contains(const RationalPoint3& p) const { return locate(p).marked; }
  /// The same for doubles. Throws Error{NotFinite}.
  bool contains(const Point3& p) const { return locate(p).marked; }
  /// Where a point lies. The first call builds a tree of boxes, O(n log n); then O(log n) expected.
  SpaceLocation locate(const RationalPoint3& p) const;
  /// Throws Error{NotFinite}.
  SpaceLocation locate(const Point3& p) const;
  /// marked[i] = contains(points[i]); for many threads, give each a part. Throws Error{BadArgument} unless
  /// the sizes agree, Error{NotFinite}.
  void contains(std::span<const Point3> points, std::span<Mark> marked) const;
  /// Is it a point of the boundary: on a vertex, edge or facet?
  bool has_on_boundary(const RationalPoint3& p) const;
  bool has_on_boundary(const Point3& p) const;

  /// The first item that the ray from p meets and `accepts` takes, and where: the item that holds p at p;
  /// a volume, or a facet or edge that the ray runs along, where the ray enters it. Throws
  /// Error{BadArgument} when the direction is zero. A few locations for each item passed.
  std::optional<SpaceHit> shoot(const RationalPoint3& p, const RationalPoint3& direction,
                                const std::function<bool(SpaceItem)>& accepts) const;
  /// The first item of the set. (The point need not belong to it: a volume begins beyond it.)
  std::optional<SpaceHit> shoot_to_marked(const RationalPoint3& p,
                                          const RationalPoint3& direction) const;
  /// The first vertex, edge or facet.
  std::optional<SpaceHit> shoot_to_boundary(const RationalPoint3& p,
                                            const RationalPoint3& direction) const;

  /// Memory of the complex and its tables, in bytes, without the locator. Copies share it. O(planes).
  std::size_t bytes() const;

  // --- operations -----------------------------------------------------------------------------

  Nef3 operator!() const;  ///< All other points. O(n).
  Nef3 interior() const;   ///< Without its boundary. O(n).
  Nef3 closure() const;    ///< With its boundary. O(n).
  Nef3 boundary() const;  ///< The points around which there are points of the set and others. O(n).
  /// The interior of the complement.
  Nef3 exterior() const { return (!*this).interior(); }
  /// The image under an invertible map. Throws Error{BadArgument} for a singular matrix. O(n) (transform.h).
  Nef3 transformed(const AffineMap3& map) const;
  /// The closure of the interior.
  Nef3 regularization() const { return interior().closure(); }

  Nef3& operator+=(const Nef3& other) { return *this = *this + other; }  ///< union with another set
  /// Intersection with another set.
  Nef3& operator*=(const Nef3& other) { return *this = *this * other; }
  Nef3& operator-=(const Nef3& other) { return *this = *this - other; }  ///< without another set
  /// Symmetric difference with another set.
  Nef3& operator^=(const Nef3& other) { return *this = *this ^ other; }
  friend Nef3 operator+(const Nef3& a, const Nef3& b);
  friend Nef3 operator*(const Nef3& a, const Nef3& b);
  friend Nef3 operator-(const Nef3& a, const Nef3& b);
  friend Nef3 operator^(const Nef3& a, const Nef3& b);

  /// The same set? Expected O(n): minimal complexes are compared vertex by vertex.
  friend bool operator==(const Nef3& a, const Nef3& b);
  /// Inclusion.
  friend bool operator<=(const Nef3& a, const Nef3& b);
  friend bool operator<(const Nef3& a, const Nef3& b) { return a <= b && !(a == b); }
  friend bool operator>=(const Nef3& a, const Nef3& b) { return b <= a; }
  friend bool operator>(const Nef3& a, const Nef3& b) { return b < a; }

 private:
  struct [[gnu::visibility("hidden")]] State;
  explicit Nef3(SpaceComplex minimal);
  friend Nef3 combine(Nef3 a, Nef3 b, MarkFunction f, Context& context);
  static std::optional<Nef3> combined_apart(Nef3& a, Nef3& b, MarkFunction f);
  const SpaceLocator& locator() const;

  std::shared_ptr<const State> state_;
};

/// Which marks take part in an operation: those of the items accepted; others count as unmarked. An
/// empty function accepts all.
struct SpaceSelector {
  std::function<bool(VertexId)> vertex;  ///< empty: all
  std::function<bool(EdgeId)> edge;      ///< empty: all
  std::function<bool(FacetId)> facet;    ///< empty: all
  std::function<bool(VolumeId)> volume;  ///< empty: all
};

/// The points p with f(p in a, p in b). With kUnion, kIntersection, ... what + * - ^ do. Sets that are moved
/// in give their memory to the result.
Nef3 combine(Nef3 a, Nef3 b, MarkFunction f, Context& context);
/// The same, with the items of each operand that a selector accepts.
Nef3 combine(const Nef3& a, const SpaceSelector& select_a, const Nef3& b,
             const SpaceSelector& select_b, MarkFunction f, Context& context);
/// f(a, half-space below the plane) or, for PlaneOnly, f(a, plane): work near the plane alone.
enum class Section : std::uint8_t { ClosedHalfSpace, OpenHalfSpace, PlaneOnly };
/// F(a, half-space below the plane) or, for PlaneOnly, f(a, plane): work near the plane alone.
Nef3 combine(const Nef3& a, const Plane3& plane, Section section, MarkFunction f, Context& context);
/// Union (intersection) of any number of sets, pairwise in a balanced tree. Of none: the empty set (the
/// whole space).
Nef3 union_of(std::span<const Nef3> sets, Context& context);
Nef3 intersection_of(std::span<const Nef3> sets, Context& context);  ///< See union_of().

}  // namespace plumb
#pragma GCC visibility pop
