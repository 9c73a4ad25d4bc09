// Nef polyhedra in space: every set that unions, intersections and complements make from open and
// closed half-spaces. A set is open or closed at every facet, edge and vertex, bounded or not, and
// may have dangling facets and edges, isolated points, and parts that touch along edges or at
// vertices.
//
// A set is held as its unique minimal complex (space_complex.h): vertices, edges, facets and
// volumes, each with a mark that says whether it belongs to the set. Around every vertex the
// complex is a sphere map (sphere_map.h), and all operations work on these.
//
// Main flow of a Boolean (boolean_op.h):
//  1. contacts  finds where cells of one operand touch cells of the other; exact, filtered by boxes
//  2. locate    finds the volume of the other operand around each other vertex: a flood, or one ray
//  3. overlay   overlays the two sphere maps at each contact, applies the function of marks and
//               brings the result into minimal form
//  4. assemble  pairs half-edges along lines, joins corners to cycles, cycles to facets, and shells
//               to volumes
// Unary topology operators re-mark and simplify in O(n).
//
// A Nef3 is an immutable value: copies share their complex and cost O(1), and const members may be
// called from several threads at once. Every operation gives the strong exception guarantee.
// Booleans add no planes: numbers never grow, whatever the number of operations.
//
// Cost: Booleans take O((n + m + c) log(n + m + c)) for c pairs of boxes that meet; unary
// operations take O(n). Errors: Error{NotFinite}, Error{BadArgument} where stated; ResourceLimit
// and Cancelled as the Context demands. Source: W. Bieri and W. Nef, Elementary set operations with
// d-dimensional polyhedra, LNCS 333 (1988); P. Hachenberger, L. Kettner, K. Mehlhorn, Computational
// Geometry 38 (2007) 64-99; docs/design/boolean.md.
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
#include "plumb/predicates/rational_point.h"
#include "plumb/space/from_mesh.h"
#include "plumb/space/space_audit.h"
#include "plumb/space/space_complex.h"
#include "plumb/space/to_mesh.h"

#pragma GCC visibility push(default)
namespace plumb {

/// The plane a x + b y + c z + d = 0 with (a, b, c) not zero. A point lies below it if
/// a x + b y + c z + d < 0.
struct Plane3 {
  Rational a;  ///< First coordinate of the normal.
  Rational b;  ///< Second coordinate of the normal.
  Rational c;  ///< Third coordinate of the normal.
  Rational d;  ///< Offset.
};

/// The points below a plane, with the plane if `boundary` is Closed.
struct HalfSpace3 {
  Plane3 plane;                          ///< The half-space lies below it.
  Boundary boundary = Boundary::Closed;  ///< Whether the plane belongs to the half-space.
};

/// The affine map x -> matrix x + offset.
struct AffineMap3 {
  std::array<std::array<Rational, 3>, 3> matrix;  ///< Rows of the linear part.
  std::array<Rational, 3> offset;                 ///< The translation, applied last.
};

/// Where a point lies.
struct SpaceLocation {
  SpaceItem item;       ///< The vertex, edge, facet or volume.
  bool marked = false;  ///< Whether the point belongs to the set.
};

/// The first cell that a ray meets, and the first point of that cell on the ray. For a volume, or
/// for a facet or edge along which the ray runs, this is where the ray enters it.
struct SpaceHit {
  SpaceLocation location;  ///< The cell that is met.
  RationalPoint3 point;    ///< Where it is met.
};

/// One mark for each cell of a complex; those of the frame are not read.
struct SpaceMarks {
  std::vector<Mark> vertex;  ///< One mark for each vertex.
  std::vector<Mark> edge;    ///< One mark for each edge.
  std::vector<Mark> facet;   ///< One mark for each facet.
  std::vector<Mark> volume;  ///< One mark for each volume.
  friend bool operator==(const SpaceMarks&, const SpaceMarks&) = default;
};

/// The numbers of cells that a user sees; cells of the frame are not counted.
struct SpaceCounts {
  std::size_t vertices = 0;        ///< Corners and isolated vertices.
  std::size_t edges = 0;           ///< Edges of facets and free edges.
  std::size_t facets = 0;          ///< Bounded and unbounded facets.
  std::size_t volumes = 0;         ///< Bounded and unbounded volumes.
  std::size_t marked_volumes = 0;  ///< Volumes that belong to the set.
  friend bool operator==(const SpaceCounts&, const SpaceCounts&) = default;
};

/// Selects the marks that take part in an operation: those of the cells that are accepted. Other
/// cells count as unmarked. An empty function accepts every cell.
struct SpaceSelector {
  std::function<bool(VertexId)> vertex;  ///< Accepts vertices.
  std::function<bool(EdgeId)> edge;      ///< Accepts edges.
  std::function<bool(FacetId)> facet;    ///< Accepts facets.
  std::function<bool(VolumeId)> volume;  ///< Accepts volumes.
};

/// Which part of space a cut keeps.
enum class Section : std::uint8_t {
  ClosedHalfSpace,  ///< The points below the plane and on it.
  OpenHalfSpace,    ///< The points below the plane.
  PlaneOnly,        ///< The points on the plane.
};

class SpaceLocator;
class Nef3;

/// Returns the points p for which f(p in a, p in b) holds. Sets that are moved in give their memory
/// to the result.
[[nodiscard]] Nef3 boolean_op(Nef3 a, Nef3 b, MarkFunction f,
                              Context& context = unlimited_context());
/// Returns the same as boolean_op(a, b, f), where only the cells that the selectors accept count as
/// marked.
[[nodiscard]] Nef3 boolean_op(const Nef3& a, const SpaceSelector& select_a, const Nef3& b,
                              const SpaceSelector& select_b, MarkFunction f,
                              Context& context = unlimited_context());
/// Returns the points p for which f(p in a, p in section) holds. Only what lies near the plane
/// costs work.
[[nodiscard]] Nef3 boolean_op(const Nef3& a, const Plane3& plane, Section section, MarkFunction f,
                              Context& context = unlimited_context());
/// Returns the union of any number of sets, computed pairwise in a balanced tree. The union of no
/// sets is empty.
[[nodiscard]] Nef3 union_of(std::span<const Nef3> sets, Context& context = unlimited_context());
/// Returns the intersection of any number of sets, as union_of() does. The intersection of no sets
/// is the whole space.
[[nodiscard]] Nef3 intersection_of(std::span<const Nef3> sets,
                                   Context& context = unlimited_context());

// The operators of Nef's algebra. Declared here because g++ does not export a friend that is
// declared in its class alone.
[[nodiscard]] Nef3 operator+(const Nef3& a, const Nef3& b);  ///< Returns the union.
[[nodiscard]] Nef3 operator*(const Nef3& a, const Nef3& b);  ///< Returns the intersection.
[[nodiscard]] Nef3 operator-(const Nef3& a, const Nef3& b);  ///< Returns the difference.
/// Returns the symmetric difference: the points of exactly one of the sets. (In Manifold `^` is the
/// intersection.)
[[nodiscard]] Nef3 operator^(const Nef3& a, const Nef3& b);
[[nodiscard]] bool operator==(const Nef3& a, const Nef3& b);  ///< Whether both are the same set.

/// A set of space. See the head of this file.
class Nef3 {
 public:
  // --- types of the grammar of sets (nef_set.h) -------------------------------------------------

  using Point = RationalPoint3;    ///< What the set consists of.
  using Complex = SpaceComplex;    ///< What represents the set.
  using Marks = SpaceMarks;        ///< One mark for each cell.
  using Counts = SpaceCounts;      ///< Numbers of cells.
  using Location = SpaceLocation;  ///< Where a point lies.
  using Hit = SpaceHit;            ///< What a ray meets.
  using Selector = SpaceSelector;  ///< Which cells take part in an operation.
  using Flaw = SpaceFlaw;          ///< A broken invariant.

  // --- meshes, the way in and the way out -------------------------------------------------------

  /// Returns the set that triangles bound, by options.rule: the volumes inside, with their
  /// boundary. Triangle t has the corners triangles[3 t], ..., triangles[3 t + 2],
  /// counter-clockwise seen from outside; point i is (xyz[3 i], xyz[3 i + 1], xyz[3 i + 2]). The
  /// mesh must be closed, but may cross itself, overlap, be doubled or inside out. Throws OpenMesh
  /// if it is not closed, Error{BadArgument} if a size is no multiple of three, Error{BadIndex} for
  /// a corner without a point, Error{NotFinite}.
  [[nodiscard]] static Nef3 from_mesh(std::span<const double> xyz,
                                      std::span<const std::uint32_t> triangles,
                                      const FromMeshOptions& options = {},
                                      Context& context = unlimited_context());
  /// Returns the same for polygons with any number of corners, in arrays that the view names.
  [[nodiscard]] static Nef3 from_mesh(const MeshView& mesh, const FromMeshOptions& options = {},
                                      Context& context = unlimited_context());
  /// Returns the same for a mesh that owns its arrays.
  [[nodiscard]] static Nef3 from_mesh(const PolygonMesh& mesh, const FromMeshOptions& options = {},
                                      Context& context = unlimited_context());
  /// Returns from_mesh() of each mesh, several at a time if the context has threads.
  [[nodiscard]] static std::vector<Nef3> from_meshes(std::span<const PolygonMesh> meshes,
                                                     const FromMeshOptions& options = {},
                                                     Context& context = unlimited_context());
  /// Returns the volumes of a mesh that complex_of_mesh() has read, with their boundary. Throws
  /// OpenMesh if it is not closed.
  [[nodiscard]] static Nef3 from_mesh_complex(MeshComplex mesh, WindingRule rule,
                                              Context& context = unlimited_context());
  /// Returns the facets of a mesh that complex_of_mesh() has read, closed or not, with their
  /// boundary.
  [[nodiscard]] static Nef3 from_facets(MeshComplex mesh, Context& context = unlimited_context());

  /// Returns the boundary of the closure of the interior as triangles in plain arrays, with
  /// coordinates rounded to the nearest doubles. Throws Error{BadArgument} if the set is unbounded.
  [[nodiscard]] TriangleMesh to_mesh(Context& context = unlimited_context()) const;
  /// Returns the same as polygons or triangles, with the facet behind each face and a report of
  /// what the mesh does not say of the set.
  [[nodiscard]] MeshOfComplex to_polygons(const ToMeshOptions& options = {},
                                          Context& context = unlimited_context()) const;

  // --- other sets to start from -----------------------------------------------------------------

  Nef3();                                               ///< Makes the empty set.
  [[nodiscard]] static Nef3 empty() { return Nef3(); }  ///< Returns the set without points.
  [[nodiscard]] static Nef3 whole();                    ///< Returns the whole space.

  /// Returns the points below a plane. Throws Error{BadArgument} if a = b = c = 0.
  [[nodiscard]] static Nef3 half_space(const Plane3& plane, Boundary boundary);
  /// Returns the side of the plane on which `kept` lies. Throws Error{BadArgument} if `kept` lies
  /// on the plane, or a = b = c = 0.
  [[nodiscard]] static Nef3 half_space(const Plane3& plane, const RationalPoint3& kept,
                                       Boundary boundary);
  /// Returns the points of a plane. Throws Error{BadArgument} if a = b = c = 0.
  [[nodiscard]] static Nef3 plane(const Plane3& plane);
  /// Returns the intersection of any number of half-spaces. Of none it is the whole space.
  [[nodiscard]] static Nef3 intersection(std::span<const HalfSpace3> half_spaces,
                                         Context& context = unlimited_context());
  /// Returns a closed polygon in a plane. Throws Error{BadShape} unless it is planar and simple.
  [[nodiscard]] static Nef3 facet(std::span<const Point3> corners,
                                  Context& context = unlimited_context());
  /// Returns a closed polygon with exact corners. Throws Error{BadShape} unless it is planar and
  /// simple.
  [[nodiscard]] static Nef3 facet(std::span<const RationalPoint3> corners,
                                  Context& context = unlimited_context());
  /// Returns the points between two points, with these; one point if they are equal.
  [[nodiscard]] static Nef3 segment(const RationalPoint3& a, const RationalPoint3& b);
  /// Returns the closed segments from point to point.
  [[nodiscard]] static Nef3 polyline(std::span<const RationalPoint3> points,
                                     Context& context = unlimited_context());
  /// Returns several polylines: number i has the points points[begin[i]], ...,
  /// points[begin[i + 1] - 1]; `begin` ends with the number of points. Throws Error{BadArgument}
  /// unless `begin` rises from 0 to that.
  [[nodiscard]] static Nef3 polylines(std::span<const RationalPoint3> points,
                                      std::span<const std::uint32_t> begin,
                                      Context& context = unlimited_context());
  [[nodiscard]] static Nef3 point(const RationalPoint3& at);  ///< Returns the set of one point.
  /// Returns the set of these points; equal points are one.
  [[nodiscard]] static Nef3 points(std::span<const RationalPoint3> points,
                                   Context& context = unlimited_context());

  /// Returns the set that a complex and its marks describe. The complex is brought into minimal
  /// form. Requires that audit(complex, AuditForm::Any) finds no flaw.
  [[nodiscard]] static Nef3 from_complex(SpaceComplex complex,
                                         Context& context = unlimited_context());
  /// Returns the set of a complex that is in minimal form already. Nothing is done or checked;
  /// audit() finds out.
  [[nodiscard]] static Nef3 from_minimal_unchecked(SpaceComplex complex) {
    return Nef3(std::move(complex));
  }
  /// Returns the set of this set's complex with other marks; those of the frame stay. Throws
  /// Error{BadArgument} unless there is one mark for each cell. O(n).
  [[nodiscard]] Nef3 with_marks(const SpaceMarks& marks,
                                Context& context = unlimited_context()) const;
  /// Returns this set with other facet_origin ids, one for each facet of complex(). They follow
  /// facets through operations: a facet has the least id of the facets it came from, and pieces of
  /// one plane side by side are one facet. == does not compare them. Throws Error{BadArgument}
  /// unless there is one id for each facet.
  [[nodiscard]] Nef3 with_origins(std::span<const std::uint32_t> facet_origin) const;
  /// Returns this set with all bounded volumes added: what its boundary encloses. O(n).
  [[nodiscard]] Nef3 with_bounded_volumes(Context& context = unlimited_context()) const;

  // --- reading ----------------------------------------------------------------------------------

  /// Returns the minimal complex: all cells with their marks.
  [[nodiscard]] const SpaceComplex& complex() const&;
  /// Returns the complex of a set that is given up, without a copy unless the set shares it.
  [[nodiscard]] SpaceComplex complex() &&;
  [[nodiscard]] SpaceMarks marks() const;    ///< Returns the marks of all cells.
  [[nodiscard]] SpaceCounts counts() const;  ///< Returns the numbers of cells. O(n).
  /// Returns the memory of the complex and its tables in bytes, without the index for location.
  /// Copies share it. O(planes).
  [[nodiscard]] std::size_t bytes() const;

  [[nodiscard]] bool is_empty() const;    ///< Whether the set has no points. O(1).
  [[nodiscard]] bool is_whole() const;    ///< Whether the set is the whole space. O(1).
  [[nodiscard]] bool is_bounded() const;  ///< Whether the set lies in some ball. O(n).
  [[nodiscard]] bool is_closed() const;   ///< Whether the set is its own closure. O(n).
  [[nodiscard]] bool is_open() const;     ///< Whether the set is its own interior. O(n).
  /// Whether the boundary is a 2-manifold with the set on one side: no dangling parts, two facets
  /// at every edge, one cone at every vertex. Marks of the boundary do not matter. O(n).
  [[nodiscard]] bool is_simple() const;
  /// Whether the set contains the segment between any two of its points. Any set may be asked:
  /// open, unbounded or flat; the empty set is convex. Expected O(n).
  [[nodiscard]] bool is_convex() const;
  /// Whether every point of this set belongs to `other`. Costs a difference.
  [[nodiscard]] bool is_subset_of(const Nef3& other, Context& context = unlimited_context()) const;

  /// Whether the point belongs to the set. Costs as locate().
  [[nodiscard]] bool contains(const RationalPoint3& p,
                              Context& context = unlimited_context()) const {
    return locate(p, context).marked;
  }
  /// Whether the point belongs to the set. Throws Error{NotFinite}.
  [[nodiscard]] bool contains(const Point3& p, Context& context = unlimited_context()) const {
    return locate(p, context).marked;
  }
  /// Sets marked[i] to contains(points[i]). To use threads, give each a part. Throws
  /// Error{BadArgument} unless the sizes agree, Error{NotFinite}.
  void contains(std::span<const Point3> points, std::span<Mark> marked,
                Context& context = unlimited_context()) const;
  /// Returns the cell on which a point lies. The first call builds an index in O(n log n); then
  /// O(log n) expected.
  [[nodiscard]] SpaceLocation locate(const RationalPoint3& p,
                                     Context& context = unlimited_context()) const;
  /// Returns the cell on which a point lies. Throws Error{NotFinite}.
  [[nodiscard]] SpaceLocation locate(const Point3& p, Context& context = unlimited_context()) const;
  /// Whether the point lies on a vertex, edge or facet.
  [[nodiscard]] bool has_on_boundary(const RationalPoint3& p,
                                     Context& context = unlimited_context()) const;
  /// Whether the point lies on a vertex, edge or facet. Throws Error{NotFinite}.
  [[nodiscard]] bool has_on_boundary(const Point3& p, Context& context = unlimited_context()) const;

  /// Returns the first marked cell that the ray from `origin` meets, which may be that of `origin`,
  /// or nothing. The point of the hit need not belong to the set: an open volume begins beyond it.
  /// Throws Error{BadArgument} for the direction zero. Costs a few locations for each cell passed.
  [[nodiscard]] std::optional<SpaceHit> shoot(const RationalPoint3& origin,
                                              const RationalPoint3& direction,
                                              Context& context = unlimited_context()) const;
  /// Returns the first vertex, edge or facet that the ray meets, marked or not. Errors and cost as
  /// shoot().
  [[nodiscard]] std::optional<SpaceHit> shoot_to_boundary(
      const RationalPoint3& origin, const RationalPoint3& direction,
      Context& context = unlimited_context()) const;
  /// Returns the first cell that the ray meets and `accepts` takes. Errors and cost as shoot().
  [[nodiscard]] std::optional<SpaceHit> shoot_if(const RationalPoint3& origin,
                                                 const RationalPoint3& direction,
                                                 const std::function<bool(SpaceItem)>& accepts,
                                                 Context& context = unlimited_context()) const;

  /// Returns the exact volume, or nothing if it is infinite. O(n) rational terms.
  [[nodiscard]] std::optional<Rational> volume(Context& context = unlimited_context()) const;
  /// Returns volume(): the measure of the dimension, for code that serves plane and space.
  [[nodiscard]] std::optional<Rational> measure(Context& context = unlimited_context()) const {
    return volume(context);
  }

  /// Checks every invariant from scratch and returns the first one that is broken, with its place,
  /// or nothing. Cost as audit() of space_audit.h.
  [[nodiscard]] std::optional<SpaceFlaw> audit(Context& context = unlimited_context()) const;

  // --- operations -------------------------------------------------------------------------------

  /// Returns the points that do not belong to the set. O(n).
  [[nodiscard]] Nef3 complement(Context& context = unlimited_context()) const;
  /// Returns the set without its boundary. O(n).
  [[nodiscard]] Nef3 interior(Context& context = unlimited_context()) const;
  /// Returns the set with its boundary. O(n).
  [[nodiscard]] Nef3 closure(Context& context = unlimited_context()) const;
  /// Returns the points in every neighbourhood of which there are points of the set and others.
  /// O(n).
  [[nodiscard]] Nef3 boundary(Context& context = unlimited_context()) const;
  /// Returns the interior of the complement. O(n).
  [[nodiscard]] Nef3 exterior(Context& context = unlimited_context()) const;
  /// Returns the closure of the interior. O(n).
  [[nodiscard]] Nef3 regularization(Context& context = unlimited_context()) const;

  /// Returns the image under an invertible map. Throws Error{BadArgument} for a singular matrix.
  /// O(n).
  [[nodiscard]] Nef3 transformed(const AffineMap3& map,
                                 Context& context = unlimited_context()) const;
  /// Returns the set moved by a vector. O(n).
  [[nodiscard]] Nef3 translated(const RationalPoint3& by,
                                Context& context = unlimited_context()) const;

  [[nodiscard]] Nef3 operator!() const { return complement(); }  ///< Returns complement().
  /// Unites this set with another one.
  Nef3& operator+=(const Nef3& other) { return *this = *this + other; }
  /// Intersects this set with another one.
  Nef3& operator*=(const Nef3& other) { return *this = *this * other; }
  /// Removes the points of another set.
  Nef3& operator-=(const Nef3& other) { return *this = *this - other; }
  /// Replaces this set by the symmetric difference with another one.
  Nef3& operator^=(const Nef3& other) { return *this = *this ^ other; }
  friend bool operator==(const Nef3& a, const Nef3& b);

 private:
  struct [[gnu::visibility("hidden")]] State;
  explicit Nef3(SpaceComplex minimal);
  friend Nef3 boolean_op(Nef3 a, Nef3 b, MarkFunction f, Context& context);
  static std::optional<Nef3> combined_apart(Nef3& a, Nef3& b, MarkFunction f);
  const SpaceLocator& locator() const;

  std::shared_ptr<State> state_;  // Changed only while one set alone holds it.
};

}  // namespace plumb
#pragma GCC visibility pop
