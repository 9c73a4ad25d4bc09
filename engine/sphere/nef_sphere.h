// Nef polyhedra on the sphere: every set of directions that unions, intersections and complements make
// from open and closed half-spheres. Open or closed along every arc and at every point, with isolated
// points, slits of great circles, whole circles.
//
// A set is held as its unique minimal map (sphere_map.h): points, arcs (one of them may be a loop, a
// whole circle without a point) and faces, each with a mark that says whether it belongs to the set.
// Equal sets have equal maps, up to numbering. centre_mark is not used.
//
// Directions are vectors other than zero; their length means nothing, so no coordinate is a square
// root. A great circle is given by a normal; its positive side is the half-sphere around the normal,
// which lies to the left of who goes counter-clockwise about it, seen from outside.
//
// Main flow of every operation:
//  1. one table   the circles of both operands in one table of planes; nothing to do if they share one
//  2. combine     SphereOverlay: cross, link, label, select, simplify (sphere_overlay.h)
// Unary topology operators re-mark and simplify in O(n).
//
// A NefSphere is an immutable value: copies share what they hold and cost O(1); const members may be
// called from several threads at once. Every operation gives the strong guarantee.
//
// Cost: binary operations as SphereOverlay::combine; unary ones O(n); location and shooting O(n) a call, besides a
// copy of the planes. Who asks one set often makes a SphereLocator (sphere_locator.h).
// Errors: Error{NotFinite} for coordinates that are no numbers, Error{BadArgument} where said and for
// the vector zero; ResourceLimit and Cancelled by the Context.
// Source: Hachenberger, Kettner, Mehlhorn, CGTA 38 (2007), section 4; SPACE.md 4.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "plumb/base/context.h"
#include "plumb/base/marks.h"
#include "plumb/sphere/sphere_audit.h"
#include "plumb/sphere/sphere_map.h"

#pragma GCC visibility push(default)
namespace plumb {

/// A direction, or a normal.
struct SphereVector {
  Rational x;  ///< of a vector of any length but 0
  Rational y;  ///< of a vector of any length but 0
  Rational z;  ///< of a vector of any length but 0

  /// Coordinates as they are.
  SphereVector(Rational a, Rational b, Rational c)
      : x(std::move(a)), y(std::move(b)), z(std::move(c)) {}
  /// Taken exactly; integers, too, up to 2^53. Throws Error{NotFinite}.
  SphereVector(double a, double b, double c);

  bool is_zero() const { return x == 0 && y == 0 && z == 0; }  ///< Is it no direction?
  /// The antipode.
  SphereVector opposite() const { return {Rational(-x), Rational(-y), Rational(-z)}; }
  friend bool operator==(const SphereVector&, const SphereVector&) = default;
};
Rational dot(const SphereVector& u, const SphereVector& v);        ///< The inner product.
SphereVector cross(const SphereVector& u, const SphereVector& v);  ///< The vector product.
/// The same direction, whatever the lengths?
bool is_same_direction(const SphereVector& u, const SphereVector& v);

/// One arc of a boundary: from `from` counter-clockwise about `normal`, to the `from` of the next one.
struct SphereSide {
  SphereVector from;    ///< where it begins
  SphereVector normal;  ///< of its circle's plane: the side is to the left of it
};

/// Where a direction lies.
struct SphereLocation {
  SphereCell cell;      ///< point, arc or face
  bool marked = false;  ///< does the direction belong to the set?
  friend bool operator==(const SphereLocation&, const SphereLocation&) = default;
};

/// What one meets on a great circle, and the first direction of it there (the infimum: of a face
/// entered over its open boundary it is the direction on that boundary).
struct SphereHit {
  SphereLocation on;       ///< what is met
  SphereVector direction;  ///< where
};

/// One mark for each item.
struct SphereItemMarks {
  std::vector<Mark> point;  ///< per point
  std::vector<Mark> arc;    ///< per arc
  std::vector<Mark> face;   ///< per face
};

/// The boundary of a face: of each cycle one half-arc, and the isolated points inside.
struct SphereFaceBoundary {
  std::vector<std::uint32_t> half_arcs;  ///< one of each cycle
  std::vector<std::uint32_t> points;     ///< isolated ones in it
};
/// What bounds a face of a map. O(size of the map).
SphereFaceBoundary face_boundary(const SphereMap& map, std::uint32_t face);

// A friend that is declared in its class alone g++ does not export.
class NefSphere;
NefSphere operator+(const NefSphere& a, const NefSphere& b);  ///< union
NefSphere operator*(const NefSphere& a, const NefSphere& b);  ///< intersection
NefSphere operator-(const NefSphere& a, const NefSphere& b);  ///< the first without the second
NefSphere operator^(const NefSphere& a, const NefSphere& b);  ///< symmetric difference
bool operator==(const NefSphere& a, const NefSphere& b);      ///< the same set?
bool operator<=(const NefSphere& a, const NefSphere& b);      ///< inclusion

/// A set of the sphere: an immutable value, see above.
class NefSphere {
 public:
  // --- sets to start from ---------------------------------------------------------------------

  NefSphere();                ///< the empty set
  static NefSphere empty();   ///< No direction.
  static NefSphere sphere();  ///< Every direction.

  /// The directions u with normal . u > 0, or >= 0.
  static NefSphere half_sphere(const SphereVector& normal, Boundary boundary);
  /// The great circle normal . u = 0.
  static NefSphere circle(const SphereVector& normal);
  /// The intersection of the half-spheres of these normals. Of none: the sphere.
  static NefSphere convex(std::span<const SphereVector> normals, Boundary boundary);

  /// Left of a closed chain of arcs. Each side runs counter-clockwise about its normal to the next
  /// side's `from`, at most once around; one side alone is a whole circle. Throws Error{BadArgument}
  /// when a `from` is not on the circles of both sides there, or the chain meets itself. No side: the
  /// empty set.
  static NefSphere region(std::span<const SphereSide> sides, Boundary boundary);
  /// Left of the closed chain of the shorter arcs between consecutive corners. Throws
  /// Error{BadArgument} also when two consecutive corners are the same or opposite.
  static NefSphere polygon(std::span<const SphereVector> corners, Boundary boundary);

  /// From `from` counter-clockwise about the normal to `to`, a whole circle when they are the same;
  /// `boundary` says whether the ends belong to it. Throws Error{BadArgument} when one is not on the
  /// circle.
  static NefSphere arc(const SphereVector& from, const SphereVector& to, const SphereVector& normal,
                       Boundary boundary = Boundary::Closed);
  /// The shorter arc. Throws Error{BadArgument} when the ends are the same or opposite.
  static NefSphere arc(const SphereVector& from, const SphereVector& to,
                       Boundary boundary = Boundary::Closed);
  static NefSphere point(const SphereVector& direction);  ///< One direction.
  /// Isolated directions; equal ones are one.
  static NefSphere points(std::span<const SphereVector> directions);

  /// The set that a map describes, in minimal form; planes count by their normals, kBeyond as
  /// unmarked. Throws Error{BadArgument} unless audit(planes, map, false) is clean.
  static NefSphere from_map(const PlaneTable& planes, const SphereMap& map);
  /// A map in minimal form already, over planes through the centre: nothing is done or checked.
  /// audit() tells.
  static NefSphere from_minimal(std::shared_ptr<const PlaneTable> planes, SphereMap map);
  /// This set's map with other marks (sizes must agree: Error{BadArgument}). O(n).
  NefSphere with_marks(SphereItemMarks marks) const;

  // --- reading --------------------------------------------------------------------------------

  /// The minimal map: points, arcs, faces, links and marks; and the planes that it names.
  const SphereMap& map() const;
  const PlaneTable& planes() const { return *shared_planes(); }    ///< The circles of the map.
  const std::shared_ptr<const PlaneTable>& shared_planes() const;  ///< The same, to be kept.
  SphereItemMarks marks() const;                                   ///< Of all items of the map.
  /// An exact vector of a point; of a circle its canonical normal, about which half-arc 2a runs
  /// counter-clockwise.
  SphereVector direction(std::uint32_t point) const;
  /// Of the circle of an arc: the positive side lies left of half-arc 2 arc.
  SphereVector normal(std::uint32_t arc) const;

  bool is_empty() const;   ///< Is there no direction in it? O(1).
  bool is_sphere() const;  ///< Is every direction in it? O(1).
  /// Is it its own closure (its own interior)? O(n).
  bool is_closed() const;
  bool is_open() const;  ///< Is it its own interior? O(n).

  /// Does the direction belong to the set? As locate().
  bool contains(const SphereVector& direction) const { return locate(direction).marked; }
  /// Where a direction lies. Throws Error{BadArgument} for zero. O(n).
  SphereLocation locate(const SphereVector& direction) const;
  /// Many at once: up to 16 share the copy of the planes, more a SphereLocator, O(n log n) to make.
  std::vector<SphereLocation> locate(std::span<const SphereVector> directions) const;
  /// Is it on the boundary of the set? (Isolated points and slits are boundary.)
  bool has_on_boundary(const SphereVector& direction) const;

  /// The first marked item met from `origin` (inclusive) on the great circle towards `towards`, going
  /// once around; or none. Throws Error{BadArgument} when the two are the same or opposite. O(n), and a sort of
  /// what is met.
  std::optional<SphereHit> shoot(const SphereVector& origin, const SphereVector& towards) const;
  /// The first point or arc of the map met, marked or not; one that `origin` lies on is met at once.
  std::optional<SphereHit> shoot_to_boundary(const SphereVector& origin,
                                             const SphereVector& towards) const;

  // --- operations -----------------------------------------------------------------------------

  NefSphere complement() const;      ///< All other directions.
  NefSphere interior() const;        ///< Without its boundary.
  NefSphere closure() const;         ///< With its boundary.
  NefSphere boundary() const;        ///< closure - interior
  NefSphere exterior() const;        ///< interior of the complement
  NefSphere regularization() const;  ///< closure of the interior

  NefSphere operator!() const { return complement(); }  ///< complement()
  /// Union with another set.
  NefSphere& operator+=(const NefSphere& other) { return *this = *this + other; }
  /// Intersection with another set.
  NefSphere& operator*=(const NefSphere& other) { return *this = *this * other; }
  /// Without another set.
  NefSphere& operator-=(const NefSphere& other) { return *this = *this - other; }
  /// Symmetric difference with another set.
  NefSphere& operator^=(const NefSphere& other) { return *this = *this ^ other; }
  friend NefSphere operator+(const NefSphere& a, const NefSphere& b);
  friend NefSphere operator*(const NefSphere& a, const NefSphere& b);
  friend NefSphere operator-(const NefSphere& a, const NefSphere& b);
  friend NefSphere operator^(const NefSphere& a, const NefSphere& b);

  /// The same set?
  friend bool operator==(const NefSphere& a, const NefSphere& b);
  /// Inclusion.
  friend bool operator<=(const NefSphere& a, const NefSphere& b);
  friend bool operator<(const NefSphere& a, const NefSphere& b) { return a <= b && !(a == b); }
  friend bool operator>=(const NefSphere& a, const NefSphere& b) { return b <= a; }
  friend bool operator>(const NefSphere& a, const NefSphere& b) { return b < a; }

  /// Every invariant, from scratch; names the first one broken and where.
  std::optional<DcelFlaw> audit() const;

 private:
  struct [[gnu::visibility("hidden")]] State;
  explicit NefSphere(std::shared_ptr<const State> state) : state_(std::move(state)) {}

  std::shared_ptr<const State> state_;
};

/// Which marks take part in an operation: those of the items accepted, by index; others count as
/// unmarked. An empty function accepts all.
struct SphereSelector {
  std::function<bool(std::uint32_t)> point;  ///< empty: all
  std::function<bool(std::uint32_t)> arc;    ///< empty: all
  std::function<bool(std::uint32_t)> face;   ///< empty: all
};

/// The directions u with f(u in a, u in b). With kUnion, kIntersection, ... what + * - ^ do.
NefSphere combine(const NefSphere& a, const NefSphere& b, MarkFunction f, Context& context);
/// The same, with the items of each operand that a selector accepts.
NefSphere combine(const NefSphere& a, const SphereSelector& select_a, const NefSphere& b,
                  const SphereSelector& select_b, MarkFunction f, Context& context);
/// Union (intersection) of any number of sets, pairwise in a balanced tree. Of none: the empty set
/// (the sphere).
NefSphere union_of(std::span<const NefSphere> sets, Context& context);
NefSphere intersection_of(std::span<const NefSphere> sets, Context& context);  ///< See union_of().

}  // namespace plumb
#pragma GCC visibility pop
