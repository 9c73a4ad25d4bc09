// Nef polyhedra in space: every set that unions, intersections and complements make from open and
// closed half-spaces. A set is open or closed at each facet, edge and vertex, and may be unbounded.
// It may have dangling facets and edges, isolated points, and parts that touch along edges or at
// vertices.
//
// A set is stored as its unique minimal complex (space_complex.h). The complex consists of
// vertices, edges, facets and volumes, each with a mark that says whether it belongs to the set.
// The intersection of the complex with a small sphere around a vertex is a sphere map
// (sphere_map.h). All operations work on sphere maps.
//
// Main flow of a Boolean (boolean_op.h):
//  1. contacts  finds where cells of one operand touch cells of the other; exact, filtered by boxes
//  2. locate    finds the volume of the other operand around each vertex without a contact, by a
//               flood or one ray
//  3. overlay   overlays the two sphere maps at each contact, applies the function of marks and
//               brings the result into minimal form
//  4. assemble  pairs half-edges along lines, joins corners to cycles, cycles to facets, and shells
//               to volumes
// The unary topology operators (interior(), closure(), ...) change marks and simplify the complex
// in O(n).
//
// A Nef3 is an immutable value. Copies share their complex and cost O(1), and several threads may
// call const members at the same time. Every operation gives the strong exception guarantee.
// Booleans add no planes, so numbers never grow, however many operations follow each other.
//
// Cost: Booleans of sets of sizes n and m take O((n + m + c) log(n + m + c)) for c pairs of boxes
// that meet; unary operations take O(n). Errors: Error{NotFinite} and Error{BadArgument} where
// stated; ResourceLimit and Cancelled as the Context demands. Source: W. Bieri and W. Nef,
// Elementary set operations with d-dimensional polyhedra, LNCS 333 (1988); P. Hachenberger, L.
// Kettner, K. Mehlhorn, Computational Geometry 38 (2007) 64-99; docs/design/boolean.md.
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

/// The points below a plane, together with the plane if `boundary` is Closed.
struct HalfSpace3 {
  Plane3 plane;                          ///< The plane; the half-space lies below it.
  Boundary boundary = Boundary::Closed;  ///< Whether the plane belongs to the half-space.
};

/// The affine map x -> matrix * x + offset.
struct AffineMap3 {
  std::array<std::array<Rational, 3>, 3> matrix;  ///< Rows of the linear part.
  std::array<Rational, 3> offset;                 ///< The translation, applied last.
};

/// The location of a point: the cell that contains it, and whether it belongs to the set.
struct SpaceLocation {
  SpaceItem item;       ///< The vertex, edge, facet or volume that contains the point.
  bool marked = false;  ///< Whether the point belongs to the set.
};

/// The first cell that a ray meets, and the first point of that cell on the ray. If the ray runs
/// inside the cell (a volume, or a facet or edge along the ray), the point is where the ray enters
/// the cell.
struct SpaceHit {
  SpaceLocation location;  ///< The cell, and whether it is marked.
  RationalPoint3 point;    ///< The first point of the cell on the ray.
};

/// One mark for each cell of a complex. Marks of cells of the frame are not read.
struct SpaceMarks {
  std::vector<Mark> vertex;  ///< One mark for each vertex.
  std::vector<Mark> edge;    ///< One mark for each edge.
  std::vector<Mark> facet;   ///< One mark for each facet.
  std::vector<Mark> volume;  ///< One mark for each volume.
  friend bool operator==(const SpaceMarks&, const SpaceMarks&) = default;
};

/// Counts of the cells of a set, without the cells of the frame.
struct SpaceCounts {
  std::size_t vertices = 0;        ///< Corners and isolated vertices.
  std::size_t edges = 0;           ///< Edges of facets and free edges.
  std::size_t facets = 0;          ///< Bounded and unbounded facets.
  std::size_t volumes = 0;         ///< Bounded and unbounded volumes.
  std::size_t marked_volumes = 0;  ///< Volumes that belong to the set.
  friend bool operator==(const SpaceCounts&, const SpaceCounts&) = default;
};

/// Selects the cells whose marks take part in an operation: the cells that the functions accept.
/// Other cells count as unmarked. An empty function accepts every cell.
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

/// Returns the points p for which f(p in a, p in b) holds. The result reuses the memory of sets
/// that are moved in.
[[nodiscard]] Nef3 boolean_op(Nef3 a, Nef3 b, MarkFunction f,
                              Context& context = unlimited_context());
/// Returns the same as boolean_op(a, b, f), where only the cells that the selectors accept count as
/// marked.
[[nodiscard]] Nef3 boolean_op(const Nef3& a, const SpaceSelector& select_a, const Nef3& b,
                              const SpaceSelector& select_b, MarkFunction f,
                              Context& context = unlimited_context());
/// Returns the points p for which f(p in a, p in section) holds. Only the cells near the plane cost
/// work.
[[nodiscard]] Nef3 boolean_op(const Nef3& a, const Plane3& plane, Section section, MarkFunction f,
                              Context& context = unlimited_context());
/// Returns the union of any number of sets, computed pairwise in a balanced tree. If there are no
/// sets, the union is empty.
[[nodiscard]] Nef3 union_of(std::span<const Nef3> sets, Context& context = unlimited_context());
/// Returns the intersection of any number of sets, computed as by union_of(). If there are no sets,
/// the intersection is the whole space.
[[nodiscard]] Nef3 intersection_of(std::span<const Nef3> sets,
                                   Context& context = unlimited_context());

// The operators of Nef's algebra. They are declared here because g++ does not export a friend that
// is declared in its class only.
[[nodiscard]] Nef3 operator+(const Nef3& a, const Nef3& b);  ///< Returns the union.
[[nodiscard]] Nef3 operator*(const Nef3& a, const Nef3& b);  ///< Returns the intersection.
[[nodiscard]] Nef3 operator-(const Nef3& a, const Nef3& b);  ///< Returns the difference.
/// Returns the symmetric difference: the points of exactly one of the sets. (In the library
/// Manifold, `^` is the intersection.)
[[nodiscard]] Nef3 operator^(const Nef3& a, const Nef3& b);
[[nodiscard]] bool operator==(const Nef3& a, const Nef3& b);  ///< Whether both are the same set.

/// A set of space. The head of this file describes it.
class Nef3 {
 public:
  // --- types of the grammar of sets (nef_set.h) -------------------------------------------------

  using Point = RationalPoint3;    ///< A point of space.
  using Complex = SpaceComplex;    ///< The complex that stores the set.
  using Marks = SpaceMarks;        ///< One mark for each cell.
  using Counts = SpaceCounts;      ///< Counts of cells.
  using Location = SpaceLocation;  ///< The location of a point.
  using Hit = SpaceHit;            ///< The first cell that a ray meets.
  using Selector = SpaceSelector;  ///< The cells that take part in an operation.
  using Flaw = SpaceFlaw;          ///< A broken invariant.

  // --- meshes, the way in and the way out -------------------------------------------------------

  /// Returns the set that triangles bound: the volumes that are inside by options.rule, with their
  /// boundary. Triangle t has the corners triangles[3 t], ..., triangles[3 t + 2],
  /// counter-clockwise seen from outside. Point i is (xyz[3 i], xyz[3 i + 1], xyz[3 i + 2]). The
  /// mesh must be closed, unless options.surface is set. It may cross itself, overlap, be doubled
  /// or inside out. Throws:
  /// - OpenMesh if the mesh is not closed,
  /// - Error{BadArgument} if the size of an array is not a multiple of three,
  /// - Error{BadIndex} if a corner is not the index of a point,
  /// - Error{NotFinite} if a coordinate is not finite.
  [[nodiscard]] static Nef3 from_mesh(std::span<const double> xyz,
                                      std::span<const std::uint32_t> triangles,
                                      const FromMeshOptions& options = {},
                                      Context& context = unlimited_context());
  /// Returns the same for polygons with any number of corners, in the arrays of a view.
  [[nodiscard]] static Nef3 from_mesh(const MeshView& mesh, const FromMeshOptions& options = {},
                                      Context& context = unlimited_context());
  /// Returns the same for a mesh that owns its arrays.
  [[nodiscard]] static Nef3 from_mesh(const PolygonMesh& mesh, const FromMeshOptions& options = {},
                                      Context& context = unlimited_context());
  /// Returns from_mesh() of each mesh. If the context has threads, several meshes are read at the
  /// same time.
  [[nodiscard]] static std::vector<Nef3> from_meshes(std::span<const PolygonMesh> meshes,
                                                     const FromMeshOptions& options = {},
                                                     Context& context = unlimited_context());
  /// Returns the volumes that are inside by the rule, with their boundary, for a mesh that
  /// complex_of_mesh() has read. Throws OpenMesh if the mesh is not closed.
  [[nodiscard]] static Nef3 from_mesh_complex(MeshComplex mesh, WindingRule rule,
                                              Context& context = unlimited_context());
  /// Returns the facets with their boundary, for a mesh that complex_of_mesh() has read. The mesh
  /// may be open.
  [[nodiscard]] static Nef3 from_facets(MeshComplex mesh, Context& context = unlimited_context());

  /// Returns the boundary of the closure of the interior as triangles in plain arrays, with
  /// coordinates rounded to the nearest doubles. Throws Error{BadArgument} if the set is unbounded.
  [[nodiscard]] TriangleMesh to_mesh(Context& context = unlimited_context()) const;
  /// Returns the same boundary as polygons or triangles, with the facet that each face comes from.
  /// The report says what the mesh does not represent of the set.
  [[nodiscard]] MeshOfComplex to_polygons(const ToMeshOptions& options = {},
                                          Context& context = unlimited_context()) const;

  // --- other sets to start from -----------------------------------------------------------------

  Nef3();                                               ///< Makes the empty set.
  [[nodiscard]] static Nef3 empty() { return Nef3(); }  ///< Returns the set without points.
  [[nodiscard]] static Nef3 whole();                    ///< Returns the whole space.

  /// Returns the points below a plane, with the plane if `boundary` is Closed. Throws
  /// Error{BadArgument} if a, b and c are all 0.
  [[nodiscard]] static Nef3 half_space(const Plane3& plane, Boundary boundary);
  /// Returns the side of the plane on which `kept` lies, with the plane if `boundary` is Closed.
  /// Throws Error{BadArgument} if `kept` lies on the plane, or if a, b and c are all 0.
  [[nodiscard]] static Nef3 half_space(const Plane3& plane, const RationalPoint3& kept,
                                       Boundary boundary);
  /// Returns the points of a plane. Throws Error{BadArgument} if a, b and c are all 0.
  [[nodiscard]] static Nef3 plane(const Plane3& plane);
  /// Returns the intersection of any number of half-spaces. If there are none, it is the whole
  /// space.
  [[nodiscard]] static Nef3 intersection(std::span<const HalfSpace3> half_spaces,
                                         Context& context = unlimited_context());
  /// Returns the closed polygon with these corners. Throws Error{BadShape} if the polygon is not
  /// planar or not simple.
  [[nodiscard]] static Nef3 facet(std::span<const Point3> corners,
                                  Context& context = unlimited_context());
  /// Returns the closed polygon with exact corners. Throws Error{BadShape} if the polygon is not
  /// planar or not simple.
  [[nodiscard]] static Nef3 facet(std::span<const RationalPoint3> corners,
                                  Context& context = unlimited_context());
  /// Returns the closed segment from a to b. If a equals b, it is one point.
  [[nodiscard]] static Nef3 segment(const RationalPoint3& a, const RationalPoint3& b);
  /// Returns the union of the closed segments from each point to the next.
  [[nodiscard]] static Nef3 polyline(std::span<const RationalPoint3> points,
                                     Context& context = unlimited_context());
  /// Returns the union of several polylines. Polyline i has the points points[begin[i]], ...,
  /// points[begin[i + 1] - 1]. Throws Error{BadArgument} unless `begin` rises from 0 to the number
  /// of points.
  [[nodiscard]] static Nef3 polylines(std::span<const RationalPoint3> points,
                                      std::span<const std::uint32_t> begin,
                                      Context& context = unlimited_context());
  [[nodiscard]] static Nef3 point(const RationalPoint3& at);  ///< Returns the set of one point.
  /// Returns the set of these points. Equal points become one vertex.
  [[nodiscard]] static Nef3 points(std::span<const RationalPoint3> points,
                                   Context& context = unlimited_context());

  /// Returns the set that a complex and its marks describe. The complex is brought into minimal
  /// form. Requires that audit(complex, AuditForm::Any) finds no flaw.
  [[nodiscard]] static Nef3 from_complex(SpaceComplex complex,
                                         Context& context = unlimited_context());
  /// Returns the set of a complex that is in minimal form already. Nothing is checked here; audit()
  /// checks the result.
  [[nodiscard]] static Nef3 from_minimal_unchecked(SpaceComplex complex) {
    return Nef3(std::move(complex));
  }
  /// Returns the set that the complex of this set describes with other marks. Marks of the frame
  /// stay as they are. Throws Error{BadArgument} unless there is one mark for each cell. O(n).
  [[nodiscard]] Nef3 with_marks(const SpaceMarks& marks,
                                Context& context = unlimited_context()) const;
  /// Returns this set with other facet_origin ids, one for each facet of complex(). Operations pass
  /// the ids on. A facet of a result has the least id of the facets that it came from; neighbouring
  /// facets in one plane become one facet. The operator == does not compare ids. Throws
  /// Error{BadArgument} unless there is one id for each facet.
  [[nodiscard]] Nef3 with_origins(std::span<const std::uint32_t> facet_origin) const;
  /// Returns this set with all bounded volumes of its complex added: the volumes that its boundary
  /// encloses. O(n).
  [[nodiscard]] Nef3 with_bounded_volumes(Context& context = unlimited_context()) const;

  // --- reading ----------------------------------------------------------------------------------

  /// Returns the minimal complex: all cells with their marks.
  [[nodiscard]] const SpaceComplex& complex() const&;
  /// Returns the complex of a set that is an rvalue. The complex is copied only if other sets share
  /// it.
  [[nodiscard]] SpaceComplex complex() &&;
  [[nodiscard]] SpaceMarks marks() const;    ///< Returns the marks of all cells.
  [[nodiscard]] SpaceCounts counts() const;  ///< Returns the counts of cells. O(n).
  /// Returns the memory of the complex and its tables in bytes, without the index for location.
  /// Copies of the set share this memory. O(planes).
  [[nodiscard]] std::size_t bytes() const;

  [[nodiscard]] bool is_empty() const;    ///< Whether the set has no points. O(1).
  [[nodiscard]] bool is_whole() const;    ///< Whether the set is the whole space. O(1).
  [[nodiscard]] bool is_bounded() const;  ///< Whether the set lies in some ball. O(n).
  [[nodiscard]] bool is_closed() const;   ///< Whether the set is its own closure. O(n).
  [[nodiscard]] bool is_open() const;     ///< Whether the set is its own interior. O(n).
  /// Whether the boundary is a 2-manifold with the set on one side. This means that there are no
  /// dangling parts, two facets at every edge, and one cone at every vertex. Marks of the boundary
  /// do not matter. O(n).
  [[nodiscard]] bool is_simple() const;
  /// Whether the set contains the segment between any two of its points. The set may be open,
  /// unbounded or flat. The empty set is convex. Expected O(n).
  [[nodiscard]] bool is_convex() const;
  /// Whether every point of this set belongs to `other`. Costs as much as a difference.
  [[nodiscard]] bool is_subset_of(const Nef3& other, Context& context = unlimited_context()) const;

  /// Whether the point belongs to the set. Costs as much as locate().
  [[nodiscard]] bool contains(const RationalPoint3& p,
                              Context& context = unlimited_context()) const {
    return locate(p, context).marked;
  }
  /// Whether the point belongs to the set. Throws Error{NotFinite} if a coordinate is not finite.
  [[nodiscard]] bool contains(const Point3& p, Context& context = unlimited_context()) const {
    return locate(p, context).marked;
  }
  /// Sets marked[i] to contains(points[i]). To use several threads, give each thread a part of the
  /// points. Throws Error{BadArgument} unless the sizes agree, and Error{NotFinite} if a coordinate
  /// is not finite.
  void contains(std::span<const Point3> points, std::span<Mark> marked,
                Context& context = unlimited_context()) const;
  /// Returns the cell on which a point lies. The first call builds an index in O(n log n). Then a
  /// call takes O(log n) expected.
  [[nodiscard]] SpaceLocation locate(const RationalPoint3& p,
                                     Context& context = unlimited_context()) const;
  /// Returns the cell on which a point lies. Throws Error{NotFinite} if a coordinate is not finite.
  [[nodiscard]] SpaceLocation locate(const Point3& p, Context& context = unlimited_context()) const;
  /// Whether the point lies on a vertex, edge or facet.
  [[nodiscard]] bool has_on_boundary(const RationalPoint3& p,
                                     Context& context = unlimited_context()) const;
  /// Whether the point lies on a vertex, edge or facet. Throws Error{NotFinite} if a coordinate is
  /// not finite.
  [[nodiscard]] bool has_on_boundary(const Point3& p, Context& context = unlimited_context()) const;

  /// Returns the first marked cell that the ray from `origin` meets, or nothing if the ray meets no
  /// marked cell. The cell that contains `origin` counts, too. The point of the hit need not belong
  /// to the set: an open volume begins beyond that point. Throws Error{BadArgument} if the
  /// direction is zero. Costs a few calls of locate() for each cell that the ray passes.
  [[nodiscard]] std::optional<SpaceHit> shoot(const RationalPoint3& origin,
                                              const RationalPoint3& direction,
                                              Context& context = unlimited_context()) const;
  /// Returns the first vertex, edge or facet that the ray meets, marked or not. Has the errors and
  /// the cost of shoot().
  [[nodiscard]] std::optional<SpaceHit> shoot_to_boundary(
      const RationalPoint3& origin, const RationalPoint3& direction,
      Context& context = unlimited_context()) const;
  /// Returns the first cell on the ray for which `accepts` returns true. Has the errors and the
  /// cost of shoot().
  [[nodiscard]] std::optional<SpaceHit> shoot_if(const RationalPoint3& origin,
                                                 const RationalPoint3& direction,
                                                 const std::function<bool(SpaceItem)>& accepts,
                                                 Context& context = unlimited_context()) const;

  /// Returns the exact volume, or nothing if it is infinite. O(n) rational terms.
  [[nodiscard]] std::optional<Rational> volume(Context& context = unlimited_context()) const;
  /// Returns volume(). The name is the same in the plane, for code that serves both dimensions.
  [[nodiscard]] std::optional<Rational> measure(Context& context = unlimited_context()) const {
    return volume(context);
  }

  /// Checks every invariant from scratch. Returns the first broken invariant and the cells
  /// concerned, or nothing if all hold. Costs as much as audit() of space_audit.h.
  [[nodiscard]] std::optional<SpaceFlaw> audit(Context& context = unlimited_context()) const;

  // --- operations -------------------------------------------------------------------------------

  /// Returns the points that do not belong to the set. O(n).
  [[nodiscard]] Nef3 complement(Context& context = unlimited_context()) const;
  /// Returns the set without its boundary. O(n).
  [[nodiscard]] Nef3 interior(Context& context = unlimited_context()) const;
  /// Returns the set with its boundary. O(n).
  [[nodiscard]] Nef3 closure(Context& context = unlimited_context()) const;
  /// Returns the boundary: the points whose every neighbourhood contains both points of the set and
  /// points outside it. O(n).
  [[nodiscard]] Nef3 boundary(Context& context = unlimited_context()) const;
  /// Returns the interior of the complement. O(n).
  [[nodiscard]] Nef3 exterior(Context& context = unlimited_context()) const;
  /// Returns the closure of the interior. O(n).
  [[nodiscard]] Nef3 regularization(Context& context = unlimited_context()) const;

  /// Returns the image of the set under an invertible map. Throws Error{BadArgument} if the matrix
  /// is singular. O(n).
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

  std::shared_ptr<State> state_;  // The state is changed only while a single set refers to it.
};

}  // namespace plumb
#pragma GCC visibility pop
