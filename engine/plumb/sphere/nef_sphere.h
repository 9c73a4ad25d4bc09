// Nef polyhedra on the sphere. A Nef polyhedron on the sphere is a set of directions that can be
// made from finitely many open and closed half-spheres by unions, intersections and complements.
// Each arc and each point of its boundary may belong to the set or not. The set may have isolated
// points, slits along great circles, and whole great circles.
//
// A set is stored as its unique minimal map (sphere_map.h). The map consists of points, arcs and
// faces. At most one of the arcs is a loop, that is, a whole great circle on which there is no
// point of the map. The mark of each cell states whether the cell belongs to the set. Equal sets
// have equal maps, except for the numbering of the cells. The member SphereMap::centre_mark has no
// meaning for such a map.
//
// A direction is given by a vector other than zero. The length of the vector has no meaning, so
// coordinates never need square roots. A great circle is given by a normal. The positive side of
// the circle is the open half-sphere that contains the normal. Walk along the circle
// counter-clockwise about the normal. Seen from outside the sphere, the positive side lies to the
// left of this walk.
//
// Main flow of every Boolean operation:
//  1. one table   collects the planes of all circles of both operands in one table
//  2. boolean_op  overlays the maps with a SphereOverlay. The overlay finds the intersections of
//                 arcs, links half-arcs, labels cells, computes the marks of cells, and removes
//                 redundant cells.
// Unary topological operators set new marks and remove redundant cells. These operators take O(n).
//
// A NefSphere is an immutable value. Copies share their map and cost O(1). Several threads may call
// const members of the same set concurrently. Every operation gives the strong exception guarantee.
//
// Cost: a binary operation costs as much as SphereOverlay::boolean_op(). A unary operation takes
// O(n) for n cells. A point location or ray shooting takes O(n), and copies the table of planes.
// For many queries in the same set, a SphereLocator is faster.
//
// Errors: all functions throw Error{NotFinite} for coordinates that are not finite, and
// Error{BadArgument} for the zero vector. They also throw the errors of the Context. Further
// reasons for Error{BadArgument} are stated at the functions.
//
// Source: P. Hachenberger, L. Kettner, K. Mehlhorn, Boolean operations on 3D selective Nef
// complexes, Computational Geometry 38 (2007), section 4; docs/design/sphere.md.
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
  Rational x;  ///< First coordinate. The length of the vector has no meaning.
  Rational y;  ///< Second coordinate.
  Rational z;  ///< Third coordinate.

  /// Constructs the vector with these coordinates.
  SphereVector(Rational a, Rational b, Rational c)
      : x(std::move(a)), y(std::move(b)), z(std::move(c)) {}
  /// Constructs the vector with these coordinates. The coordinates are not rounded. (Every integer
  /// with an absolute value up to 2^53 is a double.) Throws Error{NotFinite} if a coordinate is not
  /// finite.
  SphereVector(double a, double b, double c);

  /// Whether all coordinates are 0. The zero vector is not a direction.
  [[nodiscard]] bool is_zero() const { return x == 0 && y == 0 && z == 0; }
  /// Returns the vector in the opposite direction.
  [[nodiscard]] SphereVector opposite() const { return {Rational(-x), Rational(-y), Rational(-z)}; }
  friend bool operator==(const SphereVector&, const SphereVector&) = default;
};
/// Returns the inner product.
[[nodiscard]] Rational dot(const SphereVector& u, const SphereVector& v);
/// Returns the vector product.
[[nodiscard]] SphereVector cross(const SphereVector& u, const SphereVector& v);
/// Whether two vectors have the same direction, whatever their lengths.
[[nodiscard]] bool is_same_direction(const SphereVector& u, const SphereVector& v);

/// One side of a boundary. A side is an arc that starts at `from`, runs counter-clockwise about
/// `normal`, and ends at the `from` of the next side.
struct SphereSide {
  SphereVector from;    ///< The start of the arc.
  SphereVector normal;  ///< The normal of the arc's circle. The set lies to the left of the arc.
};

/// The cell that contains a direction.
struct SphereLocation {
  SphereCell cell;      ///< The point, arc or face that contains the direction.
  bool marked = false;  ///< Whether the direction belongs to the set.
  friend bool operator==(const SphereLocation&, const SphereLocation&) = default;
};

/// The result of shoot() or shoot_to_boundary(): a cell that a walk along a great circle meets, and
/// the first direction of this cell on the walk. A face does not contain its boundary. So if the
/// walk enters a face, `point` is the direction where the walk crosses the boundary of the face.
struct SphereHit {
  SphereLocation location;  ///< The cell that the walk meets.
  SphereVector point;       ///< The direction where the walk meets the cell.
};

/// One mark for each cell.
struct SphereMarks {
  std::vector<Mark> point;  ///< One mark for each point.
  std::vector<Mark> arc;    ///< One mark for each arc.
  std::vector<Mark> face;   ///< One mark for each face.
  friend bool operator==(const SphereMarks&, const SphereMarks&) = default;
};

/// The number of cells of each kind.
struct SphereCounts {
  std::size_t points = 0;        ///< Ends of arcs and isolated points.
  std::size_t arcs = 0;          ///< Arcs and whole circles.
  std::size_t faces = 0;         ///< Regions of the sphere.
  std::size_t marked_faces = 0;  ///< Faces that belong to the set.
  friend bool operator==(const SphereCounts&, const SphereCounts&) = default;
};

/// A map of the sphere, together with a table of planes. The ids of planes in the map refer to this
/// table. The planes pass through the centre of the sphere.
struct SphereComplex {
  std::shared_ptr<const PlaneTable> planes;  ///< The planes of the circles; never null.
  SphereMap map;                             ///< Points, arcs, faces, links and marks.
};

/// Selects cells of an operand. The operation uses the marks of accepted cells, and treats all
/// other cells as unmarked. Each function takes the index of a cell. An empty function accepts
/// every cell.
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
/// Returns the boundary of a face of a map. Cost: O(size of the map).
[[nodiscard]] SphereFaceBoundary face_boundary(const SphereMap& map, std::uint32_t face);

class NefSphere;

/// Returns the set of the directions u for which f(u in a, u in b) is true.
[[nodiscard]] NefSphere boolean_op(const NefSphere& a, const NefSphere& b, MarkFunction f,
                                   Context& context = unlimited_context());
/// Returns boolean_op(a', b', f). Here a' is the set a after all cells that `select_a` does not
/// accept have been unmarked. The set b' is made in the same way from b and `select_b`.
[[nodiscard]] NefSphere boolean_op(const NefSphere& a, const SphereSelector& select_a,
                                   const NefSphere& b, const SphereSelector& select_b,
                                   MarkFunction f, Context& context = unlimited_context());
/// Returns the union of any number of sets. The union is computed by a balanced binary tree of
/// unions of two sets. The union of no sets is empty.
[[nodiscard]] NefSphere union_of(std::span<const NefSphere> sets,
                                 Context& context = unlimited_context());
/// Returns the intersection of any number of sets. It is computed in the same way as the union in
/// union_of(). The intersection of no sets is the whole sphere.
[[nodiscard]] NefSphere intersection_of(std::span<const NefSphere> sets,
                                        Context& context = unlimited_context());

// The operators of Nef's algebra. These operators are declared outside the class because g++ does
// not export a friend that is declared only inside its class.
[[nodiscard]] NefSphere operator+(const NefSphere& a, const NefSphere& b);  ///< Returns the union.
/// Returns the intersection.
[[nodiscard]] NefSphere operator*(const NefSphere& a, const NefSphere& b);
/// Returns the difference.
[[nodiscard]] NefSphere operator-(const NefSphere& a, const NefSphere& b);
/// Returns the symmetric difference: the directions that belong to exactly one of the two sets.
[[nodiscard]] NefSphere operator^(const NefSphere& a, const NefSphere& b);
/// Whether a and b are the same set.
[[nodiscard]] bool operator==(const NefSphere& a, const NefSphere& b);

/// A set of directions. The head of this file describes how the set is stored.
class NefSphere {
 public:
  // --- types that all classes of sets have (nef_set.h) -----------------------------------------

  using Point = SphereVector;       ///< An element of the set: a direction.
  using Complex = SphereComplex;    ///< The representation of the set.
  using Marks = SphereMarks;        ///< One mark for each cell.
  using Counts = SphereCounts;      ///< Counts of cells.
  using Location = SphereLocation;  ///< The cell that contains a direction.
  using Hit = SphereHit;            ///< The first cell that a walk along a great circle meets.
  using Selector = SphereSelector;  ///< The cells whose marks an operation uses.
  using Flaw = DcelFlaw;            ///< A broken invariant and its location.

  // --- constructors ----------------------------------------------------------------------------

  NefSphere();                             ///< Makes the empty set.
  [[nodiscard]] static NefSphere empty();  ///< Returns the set without directions.
  [[nodiscard]] static NefSphere whole();  ///< Returns the sphere.

  /// Returns the half-sphere around `normal`. If `boundary` is Open, it consists of the directions
  /// u with dot(normal, u) > 0. If `boundary` is Closed, it consists of the directions u with
  /// dot(normal, u) >= 0.
  [[nodiscard]] static NefSphere half_sphere(const SphereVector& normal, Boundary boundary);
  /// Returns the great circle of the directions u with dot(normal, u) = 0.
  [[nodiscard]] static NefSphere circle(const SphereVector& normal);
  /// Returns the intersection of the half-spheres with these normals. If there are no normals, the
  /// result is the whole sphere.
  [[nodiscard]] static NefSphere convex(std::span<const SphereVector> normals, Boundary boundary,
                                        Context& context = unlimited_context());

  /// Returns the region to the left of a closed chain of arcs. Each side runs counter-clockwise
  /// about its normal, from its own `from` to the `from` of the next side. A side runs at most once
  /// around its circle. If a chain has only one side, this side is a whole circle. A chain without
  /// sides gives the empty set. Throws Error{BadArgument} if the chain meets itself. The `from` of
  /// each side must lie both on the circle of this side and on the circle of the previous side.
  /// Otherwise, Error{BadArgument} is thrown.
  [[nodiscard]] static NefSphere region(std::span<const SphereSide> sides, Boundary boundary);
  /// Returns the region to the left of a closed chain of arcs. Each arc is the shortest arc between
  /// two consecutive corners. Throws Error{BadArgument} if two consecutive corners are equal or
  /// opposite directions, or if the chain meets itself.
  [[nodiscard]] static NefSphere polygon(std::span<const SphereVector> corners, Boundary boundary);

  /// Returns the arc that starts at `from`, runs counter-clockwise about `normal`, and ends at
  /// `to`. If `from` and `to` are the same direction, the arc is a whole circle. The ends of the
  /// arc belong to the set if `boundary` is Closed. Throws Error{BadArgument} if `from` or `to`
  /// does not lie on the circle with this normal.
  [[nodiscard]] static NefSphere arc(const SphereVector& from, const SphereVector& to,
                                     const SphereVector& normal,
                                     Boundary boundary = Boundary::Closed);
  /// Returns the shortest arc between two directions. The ends of the arc belong to the set if
  /// `boundary` is Closed. Throws Error{BadArgument} if `from` and `to` are equal or opposite
  /// directions.
  [[nodiscard]] static NefSphere arc(const SphereVector& from, const SphereVector& to,
                                     Boundary boundary = Boundary::Closed);
  /// Returns the set of one direction.
  [[nodiscard]] static NefSphere point(const SphereVector& direction);
  /// Returns the set of these directions. Equal directions count once.
  [[nodiscard]] static NefSphere points(std::span<const SphereVector> directions,
                                        Context& context = unlimited_context());

  /// Returns the set that a map with its marks represents. The map need not be minimal, because the
  /// function makes it minimal. Only the normals of the planes are used. Cells with the mark
  /// kBeyond are treated as unmarked. Throws Error{BadArgument} if audit(planes, map,
  /// AuditForm::Any) finds a flaw.
  [[nodiscard]] static NefSphere from_complex(SphereComplex complex,
                                              Context& context = unlimited_context());
  /// Returns the set of a map. Requires that audit(planes, map, AuditForm::Minimal) finds no flaw,
  /// and that the planes of the map pass through the centre. This function checks neither of the
  /// two requirements. audit() of the result checks the first one.
  [[nodiscard]] static NefSphere from_minimal_unchecked(SphereComplex complex);
  /// Returns the set that the map of this set represents after its marks are replaced by `marks`.
  /// Throws Error{BadArgument} if the number of marks differs from the number of cells. O(n).
  [[nodiscard]] NefSphere with_marks(SphereMarks marks,
                                     Context& context = unlimited_context()) const;

  // --- reading ---------------------------------------------------------------------------------

  /// Returns the minimal map with its planes.
  [[nodiscard]] const SphereComplex& complex() const&;
  /// Returns the map, with its planes, of a set that is temporary or is moved from. The map is
  /// moved out of the set. If other sets share the map, it is copied.
  [[nodiscard]] SphereComplex complex() &&;
  /// Returns complex().map.
  [[nodiscard]] const SphereMap& map() const { return complex().map; }
  /// Returns the planes of the circles of the map.
  [[nodiscard]] const PlaneTable& planes() const { return *complex().planes; }
  [[nodiscard]] SphereMarks marks() const;    ///< Returns the marks of all cells.
  [[nodiscard]] SphereCounts counts() const;  ///< Returns the counts of cells. O(n).
  [[nodiscard]] std::size_t bytes() const;    ///< Returns the memory of the map in bytes.
  /// Returns the direction of a point of the map. The coordinates are integers without a common
  /// factor.
  [[nodiscard]] SphereVector direction(std::uint32_t point) const;
  /// Returns the normal of the circle of an arc. Half-arc 2 a of arc a runs counter-clockwise about
  /// this normal. The coordinates are integers without a common factor.
  [[nodiscard]] SphereVector normal(std::uint32_t arc) const;

  [[nodiscard]] bool is_empty() const;   ///< Whether the set has no directions. O(1).
  [[nodiscard]] bool is_whole() const;   ///< Whether the set is the sphere. O(1).
  [[nodiscard]] bool is_closed() const;  ///< Whether the set equals its closure. O(n).
  [[nodiscard]] bool is_open() const;    ///< Whether the set equals its interior. O(n).
  /// Whether every direction of this set belongs to `other`. This costs as much as the difference
  /// of the two sets.
  [[nodiscard]] bool is_subset_of(const NefSphere& other,
                                  Context& context = unlimited_context()) const;

  /// Whether the direction belongs to the set. This costs as much as locate().
  [[nodiscard]] bool contains(const SphereVector& direction,
                              Context& context = unlimited_context()) const {
    return locate(direction, context).marked;
  }
  /// Returns the cell that contains a direction. Throws Error{BadArgument} for the zero vector.
  /// O(n).
  [[nodiscard]] SphereLocation locate(const SphereVector& direction,
                                      Context& context = unlimited_context()) const;
  /// Returns one cell for each direction: the cell that contains the direction. For up to 16
  /// directions, the function makes one copy of the planes and locates each direction in O(n). For
  /// more directions, it builds one SphereLocator in O(n log n) and uses it for all directions.
  [[nodiscard]] std::vector<SphereLocation> locate(std::span<const SphereVector> directions,
                                                   Context& context = unlimited_context()) const;
  /// Whether the direction lies on the boundary of the set. Isolated points and slits belong to the
  /// boundary.
  [[nodiscard]] bool has_on_boundary(const SphereVector& direction,
                                     Context& context = unlimited_context()) const;

  /// Returns the first marked cell on a walk along a great circle, or nullopt if the walk meets no
  /// marked cell. The walk starts at `origin`, takes the shorter way to `towards`, and continues
  /// along the circle until it returns to `origin`. The first cell on the walk is the cell that
  /// contains `origin`. Throws Error{BadArgument} if `origin` and `towards` are equal or opposite
  /// directions. Cost: O(n) for n cells, plus sorting the cells on the circle.
  [[nodiscard]] std::optional<SphereHit> shoot(const SphereVector& origin,
                                               const SphereVector& towards,
                                               Context& context = unlimited_context()) const;
  /// Returns the first point or arc of the map on the walk of shoot(), whether or not it is marked.
  /// Returns nullopt if the walk meets no point and no arc. If `origin` lies on a point or arc, the
  /// function returns this point or arc. Errors and cost are the same as for shoot().
  [[nodiscard]] std::optional<SphereHit> shoot_to_boundary(
      const SphereVector& origin, const SphereVector& towards,
      Context& context = unlimited_context()) const;

  /// Checks every invariant from scratch. Returns the first broken invariant and the place where it
  /// is broken, or nullopt if all invariants hold.
  [[nodiscard]] std::optional<DcelFlaw> audit(Context& context = unlimited_context()) const;

  // --- operations ------------------------------------------------------------------------------

  /// Returns the set of the directions that do not belong to this set. O(n).
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
  /// Replaces this set by the union of this set and another set.
  NefSphere& operator+=(const NefSphere& other) { return *this = *this + other; }
  /// Replaces this set by the intersection of this set and another set.
  NefSphere& operator*=(const NefSphere& other) { return *this = *this * other; }
  /// Removes the directions of another set from this set.
  NefSphere& operator-=(const NefSphere& other) { return *this = *this - other; }
  /// Replaces this set by the symmetric difference of this set and another set.
  NefSphere& operator^=(const NefSphere& other) { return *this = *this ^ other; }
  friend bool operator==(const NefSphere& a, const NefSphere& b);

 private:
  explicit NefSphere(std::shared_ptr<SphereComplex> complex) : complex_(std::move(complex)) {}

  std::shared_ptr<SphereComplex> complex_;  // Changed only by a set that is its sole owner.
};

}  // namespace plumb
#pragma GCC visibility pop
