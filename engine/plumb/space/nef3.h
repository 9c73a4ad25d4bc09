// Nef polyhedra in space. A Nef polyhedron is a set that can be made from finitely many open and
// closed half-spaces by unions, intersections and complements. Each facet, edge and vertex of its
// boundary may or may not belong to the set. The set may be unbounded. It may have dangling facets
// and edges, isolated points, and parts that touch along edges or at vertices.
//
// A set is stored as its unique minimal complex (space_complex.h). The complex consists of
// vertices, edges, facets and volumes. Each of these cells has a mark that states whether its
// points belong to the set. The intersection of the complex with a small sphere around a vertex is
// a sphere map (sphere_map.h). All operations work on sphere maps.
//
// Main flow of a Boolean (boolean_op.h):
//  1. contacts  finds the points where cells of one operand meet cells of the other operand. Such a
//               point is called a contact. Two cells are tested only if their boxes meet. The tests
//               are exact
//  2. locate    takes each vertex that is not a contact, and finds the volume of the other operand
//               that contains this vertex. For this, it walks along edges from a vertex whose
//               volume is known, or shoots one ray
//  3. overlay   overlays the sphere maps of the two operands at each contact. It computes the marks
//               of the new map from the marks of both maps, and brings the new map into minimal
//               form
//  4. assemble  pairs half-edges along lines, links corners into cycles, groups cycles into facets,
//               and groups shells into volumes
// The unary topology operators (interior(), closure(), ...) change marks and simplify the complex
// in O(n).
//
// A Nef3 is an immutable value. Copies share their complex and cost O(1), and several threads may
// call const members at the same time. Every operation gives the strong exception guarantee.
// Booleans add no planes, so the lengths of numbers do not grow, even in a long sequence of
// Booleans.
//
// Cost: a Boolean of two sets of sizes n and m takes O((n + m + c) log(n + m + c)), where c is the
// number of pairs of cells whose boxes meet. Unary operations take O(n). In the comments of
// members, n is the number of cells of the set. Errors: functions throw Error{NotFinite} and
// Error{BadArgument} where their comments say so. Functions with a Context also throw the errors of
// the Context. Source: W. Bieri and W. Nef, Elementary set operations with d-dimensional polyhedra,
// LNCS 333 (1988); P. Hachenberger, L. Kettner, K. Mehlhorn, Computational Geometry 38 (2007)
// 64-99; docs/design/boolean.md.
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

/// The plane a x + b y + c z + d = 0 with (a, b, c) not zero. A point lies below the plane if a x +
/// b y + c z + d < 0.
struct Plane3 {
  Rational a;  ///< First coordinate of the normal.
  Rational b;  ///< Second coordinate of the normal.
  Rational c;  ///< Third coordinate of the normal.
  Rational d;  ///< The constant term of the equation.
};

/// The points below a plane, together with the plane if `boundary` is Closed.
struct HalfSpace3 {
  Plane3 plane;                          ///< The plane; the half-space lies below it.
  Boundary boundary = Boundary::Closed;  ///< Whether the plane belongs to the half-space.
};

/// The affine map x -> matrix * x + offset.
struct AffineMap3 {
  std::array<std::array<Rational, 3>, 3> matrix;  ///< Rows of the linear part.
  std::array<Rational, 3> offset;  ///< The translation, which is applied after the linear part.
};

/// The location of a point: the cell that contains the point, and whether the point belongs to the
/// set.
struct SpaceLocation {
  SpaceItem item;       ///< The vertex, edge, facet or volume that contains the point.
  bool marked = false;  ///< Whether the point belongs to the set.
};

/// The first cell that a ray meets, and the first point of this cell on the ray. If the ray passes
/// through a volume, runs inside a facet or runs along an edge, this point is where the ray enters
/// the cell.
struct SpaceHit {
  SpaceLocation location;  ///< The cell, and whether it is marked.
  RationalPoint3 point;    ///< The first point of the cell on the ray.
};

/// One mark for each cell of a complex. If a cell belongs to the frame, its mark is not read.
struct SpaceMarks {
  std::vector<Mark> vertex;  ///< One mark for each vertex.
  std::vector<Mark> edge;    ///< One mark for each edge.
  std::vector<Mark> facet;   ///< One mark for each facet.
  std::vector<Mark> volume;  ///< One mark for each volume.
  friend bool operator==(const SpaceMarks&, const SpaceMarks&) = default;
};

/// The number of cells of each kind in a set. Cells of the frame are not counted.
struct SpaceCounts {
  std::size_t vertices = 0;        ///< Corners and isolated vertices.
  std::size_t edges = 0;           ///< Edges of facets and free edges.
  std::size_t facets = 0;          ///< Bounded and unbounded facets.
  std::size_t volumes = 0;         ///< Bounded and unbounded volumes.
  std::size_t marked_volumes = 0;  ///< Volumes that belong to the set.
  friend bool operator==(const SpaceCounts&, const SpaceCounts&) = default;
};

/// Selects the cells whose marks are used in an operation. A cell is selected if the function for
/// its kind returns true. Cells that are not selected count as unmarked. An empty function selects
/// every cell of its kind.
struct SpaceSelector {
  std::function<bool(VertexId)> vertex;  ///< Accepts vertices.
  std::function<bool(EdgeId)> edge;      ///< Accepts edges.
  std::function<bool(FacetId)> facet;    ///< Accepts facets.
  std::function<bool(VolumeId)> volume;  ///< Accepts volumes.
};

/// The second operand of a Boolean of a set and a plane: the plane, or the half-space below it.
enum class Section : std::uint8_t {
  ClosedHalfSpace,  ///< The points below the plane and on it.
  OpenHalfSpace,    ///< The points below the plane.
  PlaneOnly,        ///< The points on the plane.
};

class SpaceLocator;
class Nef3;
struct MeshSource;    // source_mesh.h
struct PlacedSource;  // source_mesh.h

/// Returns the points p for which f(p in a, p in b) holds. If an operand is moved into the call,
/// the result reuses its memory.
[[nodiscard]] Nef3 boolean_op(Nef3 a, Nef3 b, MarkFunction f,
                              Context& context = unlimited_context());
/// Returns boolean_op(a, b, f), with one difference: cells that the selectors do not select count
/// as unmarked.
[[nodiscard]] Nef3 boolean_op(const Nef3& a, const SpaceSelector& select_a, const Nef3& b,
                              const SpaceSelector& select_b, MarkFunction f,
                              Context& context = unlimited_context());
/// Returns the points p for which f(p in a, p in section) holds. `section` selects the plane or a
/// half-space below it. Cells that are far from the plane cost almost no time.
[[nodiscard]] Nef3 boolean_op(const Nef3& a, const Plane3& plane, Section section, MarkFunction f,
                              Context& context = unlimited_context());
/// Returns the union of any number of sets. It is computed by a balanced tree of unions of two
/// sets. Sets that are close together are united first. So the tree depends on the sizes and
/// positions of the sets, and not on the order in which they are given. If there are no sets, the
/// union is empty.
[[nodiscard]] Nef3 union_of(std::span<const Nef3> sets, Context& context = unlimited_context());
/// Returns the intersection of any number of sets, computed in the same way as the union. If there
/// are no sets, the intersection is the whole space.
[[nodiscard]] Nef3 intersection_of(std::span<const Nef3> sets,
                                   Context& context = unlimited_context());
/// Returns the points of a that belong to none of the other sets. The function first computes the
/// union of the other sets, and then subtracts this union from a. Sets whose boxes do not meet the
/// box of a are ignored.
[[nodiscard]] Nef3 difference_of(const Nef3& a, std::span<const Nef3> others,
                                 Context& context = unlimited_context());

// The operators of Nef's algebra. They are declared here because g++ does not export a friend
// function that is declared only inside its class.
[[nodiscard]] Nef3 operator+(const Nef3& a, const Nef3& b);  ///< Returns the union.
[[nodiscard]] Nef3 operator*(const Nef3& a, const Nef3& b);  ///< Returns the intersection.
[[nodiscard]] Nef3 operator-(const Nef3& a, const Nef3& b);  ///< Returns the difference.
/// Returns the symmetric difference: the points that belong to exactly one of the two sets. (In the
/// library Manifold, `^` is the intersection.)
[[nodiscard]] Nef3 operator^(const Nef3& a, const Nef3& b);
[[nodiscard]] bool operator==(const Nef3& a, const Nef3& b);  ///< Whether both sets are equal.

/// A set of points in space. The head of this file describes how the set is stored.
class Nef3 {
 public:
  // --- types that all classes of sets have (nef_set.h) -----------------------------------------

  using Point = RationalPoint3;    ///< A point of space.
  using Complex = SpaceComplex;    ///< The complex that stores the set.
  using Marks = SpaceMarks;        ///< One mark for each cell.
  using Counts = SpaceCounts;      ///< Counts of cells.
  using Location = SpaceLocation;  ///< The location of a point.
  using Hit = SpaceHit;            ///< The first cell that a ray meets.
  using Selector = SpaceSelector;  ///< The cells that take part in an operation.
  using Flaw = SpaceFlaw;          ///< A broken invariant and its location.

  // --- conversion from and to meshes -----------------------------------------------------------

  /// Returns the set that is bounded by triangles. The set consists of the volumes that are inside
  /// according to options.rule, and of the boundaries of these volumes. Triangle t has the corners
  /// triangles[3 t], ..., triangles[3 t + 2], counter-clockwise seen from outside. Point i is
  /// (xyz[3 i], xyz[3 i + 1], xyz[3 i + 2]). The mesh must be closed, unless options.surface is
  /// set. The mesh may cross or overlap itself, it may contain a triangle twice, and it may be
  /// inside out. Throws:
  /// - OpenMesh if the mesh is not closed,
  /// - Error{BadArgument} if the size of an array is not a multiple of three,
  /// - Error{BadIndex} if a corner is not the index of a point,
  /// - Error{NotFinite} if a coordinate is not finite.
  [[nodiscard]] static Nef3 from_mesh(std::span<const double> xyz,
                                      std::span<const std::uint32_t> triangles,
                                      const FromMeshOptions& options = {},
                                      Context& context = unlimited_context());
  /// Returns the set that is bounded by polygons, as the function above does for triangles. The
  /// polygons may have any number of corners. A view of the caller's arrays describes them.
  [[nodiscard]] static Nef3 from_mesh(const MeshView& mesh, const FromMeshOptions& options = {},
                                      Context& context = unlimited_context());
  /// Does the same as the function above for a mesh that owns its arrays.
  [[nodiscard]] static Nef3 from_mesh(const PolygonMesh& mesh, const FromMeshOptions& options = {},
                                      Context& context = unlimited_context());
  /// Calls from_mesh() for each mesh, and returns the resulting sets. If the context has several
  /// threads, several meshes are converted at the same time.
  [[nodiscard]] static std::vector<Nef3> from_meshes(std::span<const PolygonMesh> meshes,
                                                     const FromMeshOptions& options = {},
                                                     Context& context = unlimited_context());
  /// Makes a set from a mesh that complex_of_mesh() has read. The set consists of the volumes that
  /// are inside according to `rule`, and of the boundaries of these volumes. Throws OpenMesh if the
  /// mesh is not closed.
  [[nodiscard]] static Nef3 from_mesh_complex(MeshComplex mesh, WindingRule rule,
                                              Context& context = unlimited_context());
  /// Makes a set from a mesh that complex_of_mesh() has read. The set consists of the facets of the
  /// mesh and of the boundaries of these facets. The mesh may be open.
  [[nodiscard]] static Nef3 from_facets(MeshComplex mesh, Context& context = unlimited_context());

  /// Returns the boundary of regularization() as triangles in plain arrays. The triangles meet only
  /// in common corners and edges, even after their coordinates have been rounded to doubles.
  /// valid_mesh() (valid_mesh.h) returns the same mesh with a report on rounding. mesh_of_complex()
  /// (to_mesh.h) rounds to the nearest doubles, even if triangles then cross. Throws
  /// Error{BadArgument} if the set is unbounded, and Error{NumberOutOfRange} if a coordinate is
  /// larger than the largest double.
  [[nodiscard]] TriangleMesh to_mesh(Context& context = unlimited_context()) const;
  /// Returns the boundary of regularization() as a mesh of polygons or triangles. The result also
  /// states, for each face of the mesh, from which facet of the set it was made. A report counts
  /// the cells of the set that the mesh does not represent. The mesh is valid after rounding, like
  /// the mesh of to_mesh(). There is one exception: if options.keeps_exact is set, the points are
  /// rounded to the nearest doubles, and the mesh also lists the exact coordinates.
  [[nodiscard]] MeshOfComplex to_polygons(const ToMeshOptions& options = {},
                                          Context& context = unlimited_context()) const;

  // --- other constructors ----------------------------------------------------------------------

  Nef3();                                               ///< Makes the empty set.
  [[nodiscard]] static Nef3 empty() { return Nef3(); }  ///< Returns the set without points.
  [[nodiscard]] static Nef3 whole();                    ///< Returns the whole space.

  /// Returns the points below a plane. If `boundary` is Closed, the points of the plane belong to
  /// the set, too. Throws Error{BadArgument} if a, b and c are all 0.
  [[nodiscard]] static Nef3 half_space(const Plane3& plane, Boundary boundary);
  /// Returns the points on the same side of the plane as `kept`. If `boundary` is Closed, the
  /// points of the plane belong to the set, too. Throws Error{BadArgument} if `kept` lies on the
  /// plane, or if a, b and c are all 0.
  [[nodiscard]] static Nef3 half_space(const Plane3& plane, const RationalPoint3& kept,
                                       Boundary boundary);
  /// Returns the set of all points of a plane. Throws Error{BadArgument} if a, b and c are all 0.
  [[nodiscard]] static Nef3 plane(const Plane3& plane);
  /// Returns the intersection of any number of half-spaces. If there are no half-spaces, the result
  /// is the whole space.
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
  /// Returns the closed segment from a to b. If a equals b, the result is the set of one point.
  [[nodiscard]] static Nef3 segment(const RationalPoint3& a, const RationalPoint3& b);
  /// Returns the union of the closed segments from each point to the next point in the list.
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

  /// Returns the set that a complex and its marks describe. This function brings the complex into
  /// minimal form. Requires that audit(complex, AuditForm::Any) finds no flaw.
  [[nodiscard]] static Nef3 from_complex(SpaceComplex complex,
                                         Context& context = unlimited_context());
  /// Returns the set that a complex represents. Requires that the complex is in minimal form. The
  /// function does not check this requirement. A call of audit() for the result checks it.
  [[nodiscard]] static Nef3 from_minimal_unchecked(SpaceComplex complex) {
    return Nef3(std::move(complex));
  }
  /// Returns the set that the complex of this set describes after its marks are replaced by
  /// `marks`. The marks of cells of the frame are not replaced. Throws Error{BadArgument} if the
  /// number of marks is not the number of cells. O(n).
  [[nodiscard]] Nef3 with_marks(const SpaceMarks& marks,
                                Context& context = unlimited_context()) const;
  /// Returns this set with other facet_origin ids, one for each facet of complex(). The results of
  /// operations keep these ids. Several facets can become one facet, for instance if they are
  /// neighbours in the same plane. The new facet then gets the least id of these facets. The
  /// operator == does not compare ids. Throws Error{BadArgument} if the number of ids is not the
  /// number of facets.
  [[nodiscard]] Nef3 with_origins(std::span<const std::uint32_t> facet_origin) const;
  /// Returns this set with one source: the mesh from which the set was made. The function
  /// mesh_with_attributes() (mesh_with_attributes.h) takes attributes from the sources of a set.
  /// The result shares the complex of this set. The result of an operation has the sources of all
  /// operands, in the order of the operands and without duplicates. The operator == does not
  /// compare sources. Throws Error{BadArgument} if the pointer is null or require_consistent()
  /// (source_mesh.h) rejects the source. Takes O(size of the source).
  [[nodiscard]] Nef3 with_source(std::shared_ptr<const MeshSource> source) const;
  /// Returns this set with a list of sources in place of its own. Throws Error{BadArgument} if a
  /// pointer is null. Cost: O(number of sources).
  [[nodiscard]] Nef3 with_sources(std::span<const PlacedSource> sources) const;
  /// Returns the union of this set and all bounded volumes of its complex. The bounded volumes are
  /// the volumes that the boundary of the set encloses. O(n).
  [[nodiscard]] Nef3 with_bounded_volumes(Context& context = unlimited_context()) const;

  // --- reading ---------------------------------------------------------------------------------

  /// Returns the minimal complex: all cells with their marks.
  [[nodiscard]] const SpaceComplex& complex() const&;
  /// Returns the complex of a temporary or moved set. The complex is copied only if other sets
  /// share it.
  [[nodiscard]] SpaceComplex complex() &&;
  [[nodiscard]] SpaceMarks marks() const;    ///< Returns the marks of all cells.
  [[nodiscard]] SpaceCounts counts() const;  ///< Returns the counts of cells. O(n).
  /// Returns the memory of the complex and its tables in bytes. The index for locate() is not
  /// included. Copies of the set share this memory. O(planes).
  [[nodiscard]] std::size_t bytes() const;
  /// Returns the sources of the set, in the order of the operands from which the set was made. The
  /// span is valid as long as this set or a copy of it exists. O(1).
  [[nodiscard]] std::span<const PlacedSource> sources() const;

  [[nodiscard]] bool is_empty() const;    ///< Whether the set has no points. O(1).
  [[nodiscard]] bool is_whole() const;    ///< Whether the set is the whole space. O(1).
  [[nodiscard]] bool is_bounded() const;  ///< Whether the set lies in some ball. O(n).
  [[nodiscard]] bool is_closed() const;   ///< Whether the set is its own closure. O(n).
  [[nodiscard]] bool is_open() const;     ///< Whether the set is its own interior. O(n).
  /// Whether the boundary is a 2-manifold with the interior of the set on one of its sides. This
  /// means that there are no dangling parts, and that every edge has exactly two facets. In
  /// addition, the interior of the set near each vertex is a single cone. It does not matter which
  /// cells of the boundary belong to the set. O(n).
  [[nodiscard]] bool is_simple() const;
  /// Whether the set contains the segment between any two of its points. The set may be open,
  /// unbounded or flat. The empty set is convex. Takes O(n) expected time.
  [[nodiscard]] bool is_convex() const;
  /// Whether every point of this set belongs to `other`. This costs as much as the difference of
  /// the two sets.
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
  /// points. Throws Error{BadArgument} if the two spans differ in size, and Error{NotFinite} if a
  /// coordinate is not finite.
  void contains(std::span<const Point3> points, std::span<Mark> marked,
                Context& context = unlimited_context()) const;
  /// Returns the cell on which a point lies. The first call builds an index in O(n log n). Every
  /// later call takes O(log n) expected time.
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

  /// Returns the first marked cell that the ray from `origin` meets, or nullopt if the ray meets no
  /// marked cell. If the cell that contains `origin` is marked, it is the result. The point of the
  /// hit need not belong to the set. For example, if the ray enters an open volume, the point is on
  /// the boundary of the volume. Throws Error{BadArgument} if the direction is zero. Costs a few
  /// calls of locate() for each cell that the ray passes.
  [[nodiscard]] std::optional<SpaceHit> shoot(const RationalPoint3& origin,
                                              const RationalPoint3& direction,
                                              Context& context = unlimited_context()) const;
  /// Returns the first vertex, edge or facet that the ray meets, whether or not it is marked.
  /// Errors and cost are the same as for shoot().
  [[nodiscard]] std::optional<SpaceHit> shoot_to_boundary(
      const RationalPoint3& origin, const RationalPoint3& direction,
      Context& context = unlimited_context()) const;
  /// Returns the first cell on the ray for which `accepts` returns true. Errors and cost are the
  /// same as for shoot().
  [[nodiscard]] std::optional<SpaceHit> shoot_if(const RationalPoint3& origin,
                                                 const RationalPoint3& direction,
                                                 const std::function<bool(SpaceItem)>& accepts,
                                                 Context& context = unlimited_context()) const;

  /// Returns the exact volume, or nullopt if the volume is infinite. Cost: a sum of O(n) rational
  /// numbers for n edges of facets.
  [[nodiscard]] std::optional<Rational> volume(Context& context = unlimited_context()) const;
  /// Returns volume(). Nef2 has a function of the same name, so that generic code can handle both
  /// dimensions.
  [[nodiscard]] std::optional<Rational> measure(Context& context = unlimited_context()) const {
    return volume(context);
  }

  /// Checks every invariant from scratch. Returns the first broken invariant and the cells that
  /// violate it, or nullopt if all invariants hold. Costs as much as audit() of space_audit.h.
  [[nodiscard]] std::optional<SpaceFlaw> audit(Context& context = unlimited_context()) const;

  // --- operations ------------------------------------------------------------------------------

  /// Returns the points that do not belong to the set. O(n).
  [[nodiscard]] Nef3 complement(Context& context = unlimited_context()) const;
  /// Returns the interior: the set without the points of its boundary. O(n).
  [[nodiscard]] Nef3 interior(Context& context = unlimited_context()) const;
  /// Returns the closure: the union of the set and its boundary. O(n).
  [[nodiscard]] Nef3 closure(Context& context = unlimited_context()) const;
  /// Returns the boundary. A point belongs to the boundary if each neighbourhood of the point
  /// contains points of the set and also points outside the set. O(n).
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
  /// Replaces this set by the union of this set and another set.
  Nef3& operator+=(const Nef3& other) { return *this = *this + other; }
  /// Replaces this set by the intersection of this set and another set.
  Nef3& operator*=(const Nef3& other) { return *this = *this * other; }
  /// Removes the points of another set from this set.
  Nef3& operator-=(const Nef3& other) { return *this = *this - other; }
  /// Replaces this set by the symmetric difference of this set and another set.
  Nef3& operator^=(const Nef3& other) { return *this = *this ^ other; }
  friend bool operator==(const Nef3& a, const Nef3& b);

 private:
  struct [[gnu::visibility("hidden")]] State;
  explicit Nef3(SpaceComplex minimal);
  friend Nef3 boolean_op(Nef3 a, Nef3 b, MarkFunction f, Context& context);
  friend struct SourceCarrier;
  static std::optional<Nef3> combined_apart(Nef3& a, Nef3& b, MarkFunction f);
  const SpaceLocator& locator() const;

  std::shared_ptr<State> state_;  // The state is changed only while a single set refers to it.
  std::shared_ptr<const std::vector<PlacedSource>> sources_;  // Null if there are none.
};

}  // namespace plumb
#pragma GCC visibility pop
