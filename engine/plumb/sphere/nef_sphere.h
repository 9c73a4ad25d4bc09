// Nef polyhedra on the sphere: every set of directions that unions, intersections and complements
// make from open and closed half-spheres. A set is open or closed along every arc and at every
// point, and may have isolated points, slits of great circles and whole circles.
//
// A set is held as its unique minimal map (sphere_map.h): points, arcs (one of them may be a loop,
// a whole circle without a point) and faces, each with a mark that says whether it belongs to the
// set. Equal sets have equal maps, up to numbering. centre_mark is not used.
//
// Directions are vectors other than zero; their length means nothing, so no coordinate is a square
// root. A great circle is given by a normal. Its positive side is the half-sphere around the
// normal, which lies to the left of a walk counter-clockwise about the normal, seen from outside.
//
// Main flow of every operation:
//  1. one table   brings the circles of both operands into one table of planes
//  2. boolean_op  overlays the maps: SphereOverlay crosses, links, labels, selects, simplifies
// Unary topology operators re-mark and simplify in O(n).
//
// A NefSphere is an immutable value: copies share their map and cost O(1), and const members may be
// called from several threads at once. Every operation gives the strong exception guarantee.
//
// Cost: binary operations as SphereOverlay::boolean_op, unary ones O(n); location and shooting take
// O(n) a call, besides a copy of the planes. To ask one set often, make a SphereLocator. Errors:
// Error{NotFinite} for coordinates that are not finite, Error{BadArgument} where stated and for the
// zero vector; ResourceLimit and Cancelled as the Context demands. Source: P. Hachenberger, L.
// Kettner, K. Mehlhorn, Boolean operations on 3D selective Nef complexes, Computational Geometry 38
// (2007), section 4; docs/design/sphere.md.
#pragma once

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
#include "plumb/sphere/sphere_audit.h"
#include "plumb/sphere/sphere_map.h"

#pragma GCC visibility push(default)
namespace plumb {

/// A direction, or the normal of a great circle.
struct SphereVector {
  Rational x;  ///< First coordinate of a vector of any length but 0.
  Rational y;  ///< Second coordinate.
  Rational z;  ///< Third coordinate.

  /// Takes the coordinates as they are.
  SphereVector(Rational a, Rational b, Rational c)
      : x(std::move(a)), y(std::move(b)), z(std::move(c)) {}
  /// Takes the coordinates exactly, integers up to 2^53 included. Throws Error{NotFinite}.
  SphereVector(double a, double b, double c);

  /// Whether all coordinates are 0, so that this is no direction.
  [[nodiscard]] bool is_zero() const { return x == 0 && y == 0 && z == 0; }
  /// Returns the antipode.
  [[nodiscard]] SphereVector opposite() const { return {Rational(-x), Rational(-y), Rational(-z)}; }
  friend bool operator==(const SphereVector&, const SphereVector&) = default;
};
/// Returns the inner product.
[[nodiscard]] Rational dot(const SphereVector& u, const SphereVector& v);
/// Returns the vector product.
[[nodiscard]] SphereVector cross(const SphereVector& u, const SphereVector& v);
/// Whether two vectors have the same direction, whatever their lengths.
[[nodiscard]] bool is_same_direction(const SphereVector& u, const SphereVector& v);

/// One arc of a boundary. It runs from `from` counter-clockwise about `normal` to the `from` of the
/// next side.
struct SphereSide {
  SphereVector from;    ///< Where the arc begins.
  SphereVector normal;  ///< The normal of its circle; the set lies to the left.
};

/// Where a direction lies.
struct SphereLocation {
  SphereCell cell;      ///< The point, arc or face.
  bool marked = false;  ///< Whether the direction belongs to the set.
  friend bool operator==(const SphereLocation&, const SphereLocation&) = default;
};

/// The first cell that a walk along a great circle meets, and the first direction of that cell on
/// the way. For a face that is entered through an open boundary this is the infimum: the direction
/// on that boundary.
struct SphereHit {
  SphereLocation location;  ///< The cell that is met.
  SphereVector point;       ///< Where it is met.
};

/// One mark for each cell.
struct SphereMarks {
  std::vector<Mark> point;  ///< One mark for each point.
  std::vector<Mark> arc;    ///< One mark for each arc.
  std::vector<Mark> face;   ///< One mark for each face.
  friend bool operator==(const SphereMarks&, const SphereMarks&) = default;
};

/// The numbers of cells.
struct SphereCounts {
  std::size_t points = 0;        ///< Ends of arcs and isolated points.
  std::size_t arcs = 0;          ///< Arcs and whole circles.
  std::size_t faces = 0;         ///< Regions of the sphere.
  std::size_t marked_faces = 0;  ///< Faces that belong to the set.
  friend bool operator==(const SphereCounts&, const SphereCounts&) = default;
};

/// A map of the sphere with the planes through the centre that it names.
struct SphereComplex {
  std::shared_ptr<const PlaneTable> planes;  ///< The planes of the circles; never null.
  SphereMap map;                             ///< Points, arcs, faces, links and marks.
};

/// Selects the marks that take part in an operation: those of the cells that are accepted, by
/// index. Other cells count as unmarked. An empty function accepts every cell.
struct SphereSelector {
  std::function<bool(std::uint32_t)> point;  ///< Accepts points.
  std::function<bool(std::uint32_t)> arc;    ///< Accepts arcs.
  std::function<bool(std::uint32_t)> face;   ///< Accepts faces.
};

/// The boundary of a face.
struct SphereFaceBoundary {
  std::vector<std::uint32_t> half_arcs;  ///< One half-arc of each boundary cycle.
  std::vector<std::uint32_t> points;     ///< The isolated points inside the face.
};
/// Returns what bounds a face of a map. O(size of the map).
[[nodiscard]] SphereFaceBoundary face_boundary(const SphereMap& map, std::uint32_t face);

class NefSphere;

/// Returns the directions u for which f(u in a, u in b) holds.
[[nodiscard]] NefSphere boolean_op(const NefSphere& a, const NefSphere& b, MarkFunction f,
                                   Context& context = unlimited_context());
/// Returns the same as boolean_op(a, b, f), where only the cells that the selectors accept count as
/// marked.
[[nodiscard]] NefSphere boolean_op(const NefSphere& a, const SphereSelector& select_a,
                                   const NefSphere& b, const SphereSelector& select_b,
                                   MarkFunction f, Context& context = unlimited_context());
/// Returns the union of any number of sets, computed pairwise in a balanced tree. The union of no
/// sets is empty.
[[nodiscard]] NefSphere union_of(std::span<const NefSphere> sets,
                                 Context& context = unlimited_context());
/// Returns the intersection of any number of sets, as union_of() does. The intersection of no sets
/// is the sphere.
[[nodiscard]] NefSphere intersection_of(std::span<const NefSphere> sets,
                                        Context& context = unlimited_context());

// The operators of Nef's algebra. Declared here because g++ does not export a friend that is
// declared in its class alone.
[[nodiscard]] NefSphere operator+(const NefSphere& a, const NefSphere& b);  ///< Returns the union.
/// Returns the intersection.
[[nodiscard]] NefSphere operator*(const NefSphere& a, const NefSphere& b);
/// Returns the difference.
[[nodiscard]] NefSphere operator-(const NefSphere& a, const NefSphere& b);
/// Returns the symmetric difference: the directions of exactly one of the sets.
[[nodiscard]] NefSphere operator^(const NefSphere& a, const NefSphere& b);
/// Whether both are the same set.
[[nodiscard]] bool operator==(const NefSphere& a, const NefSphere& b);

/// A set of the sphere. See the head of this file.
class NefSphere {
 public:
  // --- types of the grammar of sets (nef_set.h) -------------------------------------------------

  using Point = SphereVector;       ///< What the set consists of: directions.
  using Complex = SphereComplex;    ///< What represents the set.
  using Marks = SphereMarks;        ///< One mark for each cell.
  using Counts = SphereCounts;      ///< Numbers of cells.
  using Location = SphereLocation;  ///< Where a direction lies.
  using Hit = SphereHit;            ///< What a walk along a great circle meets.
  using Selector = SphereSelector;  ///< Which cells take part in an operation.
  using Flaw = DcelFlaw;            ///< A broken invariant.

  // --- sets to start from -----------------------------------------------------------------------

  NefSphere();                             ///< Makes the empty set.
  [[nodiscard]] static NefSphere empty();  ///< Returns the set without directions.
  [[nodiscard]] static NefSphere whole();  ///< Returns the sphere.

  /// Returns the directions u with normal . u > 0, or >= 0 if `boundary` is Closed.
  [[nodiscard]] static NefSphere half_sphere(const SphereVector& normal, Boundary boundary);
  /// Returns the great circle normal . u = 0.
  [[nodiscard]] static NefSphere circle(const SphereVector& normal);
  /// Returns the intersection of the half-spheres of these normals. Of none it is the sphere.
  [[nodiscard]] static NefSphere convex(std::span<const SphereVector> normals, Boundary boundary,
                                        Context& context = unlimited_context());

  /// Returns the region to the left of a closed chain of arcs. Each side runs counter-clockwise
  /// about its normal to the next side's `from`, at most once around; one side alone is a whole
  /// circle. No side gives the empty set. Throws Error{BadArgument} if a `from` does not lie on the
  /// circles of both sides there, or if the chain meets itself.
  [[nodiscard]] static NefSphere region(std::span<const SphereSide> sides, Boundary boundary);
  /// Returns the region to the left of the closed chain of the shorter arcs between consecutive
  /// corners. Throws Error{BadArgument} as region(), and if two consecutive corners are the same or
  /// opposite.
  [[nodiscard]] static NefSphere polygon(std::span<const SphereVector> corners, Boundary boundary);

  /// Returns the arc from `from` counter-clockwise about the normal to `to`, which is a whole
  /// circle if they are the same. The ends belong to it if `boundary` is Closed. Throws
  /// Error{BadArgument} if one of them does not lie on the circle.
  [[nodiscard]] static NefSphere arc(const SphereVector& from, const SphereVector& to,
                                     const SphereVector& normal,
                                     Boundary boundary = Boundary::Closed);
  /// Returns the shorter arc. Throws Error{BadArgument} if the ends are the same or opposite.
  [[nodiscard]] static NefSphere arc(const SphereVector& from, const SphereVector& to,
                                     Boundary boundary = Boundary::Closed);
  /// Returns the set of one direction.
  [[nodiscard]] static NefSphere point(const SphereVector& direction);
  /// Returns the set of these directions; equal ones are one.
  [[nodiscard]] static NefSphere points(std::span<const SphereVector> directions,
                                        Context& context = unlimited_context());

  /// Returns the set that a map and its marks describe, in minimal form. Planes count by their
  /// normals alone, kBeyond as unmarked. Throws Error{BadArgument} unless audit(planes, map, AuditForm::Any)
  /// finds no flaw.
  [[nodiscard]] static NefSphere from_complex(SphereComplex complex,
                                              Context& context = unlimited_context());
  /// Returns the set of a map that is in minimal form already, over planes through the centre.
  /// Nothing is done or checked; audit() finds out.
  [[nodiscard]] static NefSphere from_minimal_unchecked(SphereComplex complex);
  /// Returns the set of this set's map with other marks. Throws Error{BadArgument} unless there is
  /// one mark for each cell. O(n).
  [[nodiscard]] NefSphere with_marks(SphereMarks marks,
                                     Context& context = unlimited_context()) const;

  // --- reading ----------------------------------------------------------------------------------

  /// Returns the minimal map with its planes.
  [[nodiscard]] const SphereComplex& complex() const&;
  /// Returns the map of a set that is given up, without a copy unless the set shares it.
  [[nodiscard]] SphereComplex complex() &&;
  /// Returns complex().map.
  [[nodiscard]] const SphereMap& map() const { return complex().map; }
  /// Returns the planes of the circles of the map.
  [[nodiscard]] const PlaneTable& planes() const { return *complex().planes; }
  [[nodiscard]] SphereMarks marks() const;    ///< Returns the marks of all cells.
  [[nodiscard]] SphereCounts counts() const;  ///< Returns the numbers of cells. O(n).
  [[nodiscard]] std::size_t bytes() const;    ///< Returns the memory of the map in bytes.
  /// Returns an exact vector of a point; for a point of a circle without other points, its
  /// canonical normal, about which half-arc 2a runs counter-clockwise.
  [[nodiscard]] SphereVector direction(std::uint32_t point) const;
  /// Returns the normal of the circle of an arc. Its positive side lies left of half-arc 2 arc.
  [[nodiscard]] SphereVector normal(std::uint32_t arc) const;

  [[nodiscard]] bool is_empty() const;   ///< Whether the set has no directions. O(1).
  [[nodiscard]] bool is_whole() const;   ///< Whether the set is the sphere. O(1).
  [[nodiscard]] bool is_closed() const;  ///< Whether the set is its own closure. O(n).
  [[nodiscard]] bool is_open() const;    ///< Whether the set is its own interior. O(n).
  /// Whether every direction of this set belongs to `other`. Costs a difference.
  [[nodiscard]] bool is_subset_of(const NefSphere& other,
                                  Context& context = unlimited_context()) const;

  /// Whether the direction belongs to the set. Costs as locate().
  [[nodiscard]] bool contains(const SphereVector& direction,
                              Context& context = unlimited_context()) const {
    return locate(direction, context).marked;
  }
  /// Returns the cell on which a direction lies. Throws Error{BadArgument} for the zero vector.
  /// O(n).
  [[nodiscard]] SphereLocation locate(const SphereVector& direction,
                                      Context& context = unlimited_context()) const;
  /// Locates many directions at once: up to 16 share the copy of the planes, more share a
  /// SphereLocator, which takes O(n log n) to make.
  [[nodiscard]] std::vector<SphereLocation> locate(std::span<const SphereVector> directions,
                                                   Context& context = unlimited_context()) const;
  /// Whether the direction lies on the boundary of the set. Isolated points and slits are boundary.
  [[nodiscard]] bool has_on_boundary(const SphereVector& direction,
                                     Context& context = unlimited_context()) const;

  /// Returns the first marked cell that a walk from `origin` along the great circle towards
  /// `towards` meets, once around, which may be that of `origin`; or nothing. Throws
  /// Error{BadArgument} if the two are the same or opposite. O(n), and a sort of what is met.
  [[nodiscard]] std::optional<SphereHit> shoot(const SphereVector& origin,
                                               const SphereVector& towards,
                                               Context& context = unlimited_context()) const;
  /// Returns the first point or arc that the walk meets, marked or not; one on which `origin` lies
  /// is met at once. Errors and cost as shoot().
  [[nodiscard]] std::optional<SphereHit> shoot_to_boundary(
      const SphereVector& origin, const SphereVector& towards,
      Context& context = unlimited_context()) const;

  /// Checks every invariant from scratch and returns the first one that is broken, with its place,
  /// or nothing.
  [[nodiscard]] std::optional<DcelFlaw> audit(Context& context = unlimited_context()) const;

  // --- operations -------------------------------------------------------------------------------

  /// Returns the directions that do not belong to the set. O(n).
  [[nodiscard]] NefSphere complement(Context& context = unlimited_context()) const;
  /// Returns the set without its boundary. O(n).
  [[nodiscard]] NefSphere interior(Context& context = unlimited_context()) const;
  /// Returns the set with its boundary. O(n).
  [[nodiscard]] NefSphere closure(Context& context = unlimited_context()) const;
  /// Returns the closure without the interior. O(n).
  [[nodiscard]] NefSphere boundary(Context& context = unlimited_context()) const;
  /// Returns the interior of the complement. O(n).
  [[nodiscard]] NefSphere exterior(Context& context = unlimited_context()) const;
  /// Returns the closure of the interior. O(n).
  [[nodiscard]] NefSphere regularization(Context& context = unlimited_context()) const;

  [[nodiscard]] NefSphere operator!() const { return complement(); }  ///< Returns complement().
  /// Unites this set with another one.
  NefSphere& operator+=(const NefSphere& other) { return *this = *this + other; }
  /// Intersects this set with another one.
  NefSphere& operator*=(const NefSphere& other) { return *this = *this * other; }
  /// Removes the directions of another set.
  NefSphere& operator-=(const NefSphere& other) { return *this = *this - other; }
  /// Replaces this set by the symmetric difference with another one.
  NefSphere& operator^=(const NefSphere& other) { return *this = *this ^ other; }
  friend bool operator==(const NefSphere& a, const NefSphere& b);

 private:
  explicit NefSphere(std::shared_ptr<SphereComplex> complex) : complex_(std::move(complex)) {}

  std::shared_ptr<SphereComplex> complex_;  // changed only by who holds it alone
};

}  // namespace plumb
#pragma GCC visibility pop
