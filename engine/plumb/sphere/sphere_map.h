// A sphere map describes a marked subdivision of space near one of its points, the centre. Near the
// centre, every cell of the subdivision is a cone with its apex at the centre. So the intersections
// of the cells with a small sphere around the centre determine the cells near the centre. These
// intersections form a subdivision of the sphere by arcs of great circles. A sphere map consists of
// this subdivision and of marks. It has one mark for each cell of the subdivision of the sphere,
// and one mark for the centre.
//
//   cell of the map   cell of space that contains it            mark of the cell
//   point             an edge that leaves the centre            mark of the edge
//   arc               a facet with a corner at the centre       mark of the facet
//   face              a volume that touches the centre          mark of the volume
//
// Circles: a great circle is given by a plane through the centre. Only the normal of the plane is
// used.
//
// Directions: a direction is given as the cross product of the normals of two planes. The length of
// this product has no meaning, so no square root is needed.
//
// Arcs: arc a consists of half-arcs 2 a and 2 a + 1. Half-arc 2 a runs counter-clockwise about the
// canonical normal of circle[a]. Seen from outside the sphere, the positive side of the plane lies
// to the left of this half-arc. Half-arc 2 a + 1 runs in the opposite direction. An arc may be
// longer than a half-circle. An arc that starts and ends at the same point is a whole circle.
//
// Loops: a loop is a whole circle without a point. The origin of its half-arcs is kNone. Two great
// circles always cross, so a map has at most one loop. If a map has a loop, no other arc meets it:
// every arc except the loop lies strictly on one side of the loop.
//
// Invariants: sphere_audit.h lists the invariants of a map, and audit() checks them. All planes of
// a map belong to one PlaneTable. All these planes pass through the centre, so different planes
// have different normals. Source: docs/design/sphere.md.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "plumb/base/marks.h"
#include "plumb/predicates/space/plane_table.h"

#pragma GCC visibility push(default)
namespace plumb {

/// The direction cross(n_p, n_q), where n_p and n_q are the normals of the planes p and q. The
/// planes are not parallel. The opposite direction is {q, p}.
struct SphereDirection {
  PlaneId p;  ///< A plane through the centre.
  PlaneId q;  ///< Another plane through the centre.
  /// Returns the antipode.
  constexpr SphereDirection opposite() const { return {q, p}; }
  friend bool operator==(const SphereDirection&, const SphereDirection&) = default;
};

/// The id of a cell of a map, in 32 bits. A default-constructed id is invalid.
class SphereCell {
 public:
  /// The kinds of cells.
  enum class Kind : std::uint32_t { Point, Arc, Face };

  constexpr SphereCell() = default;
  /// Makes the id of the cell that has the given kind and index. Requires that `index` is less than
  /// 2^30.
  constexpr SphereCell(Kind kind, std::uint32_t index)
      : code_((static_cast<std::uint32_t>(kind) << 30U) | index) {}
  /// Returns the id of point i.
  static constexpr SphereCell point(std::uint32_t i) { return {Kind::Point, i}; }
  /// Returns the id of arc i.
  static constexpr SphereCell arc(std::uint32_t i) { return {Kind::Arc, i}; }
  /// Returns the id of face i.
  static constexpr SphereCell face(std::uint32_t i) { return {Kind::Face, i}; }

  /// Whether the id is valid.
  constexpr bool is_valid() const { return code_ != ~std::uint32_t{0}; }
  /// Returns the kind of the cell. Requires is_valid().
  constexpr Kind kind() const { return static_cast<Kind>(code_ >> 30U); }
  /// Returns the index of the cell among the cells of its kind. Requires is_valid().
  constexpr std::uint32_t index() const { return code_ & 0x3fffffffU; }
  friend constexpr auto operator<=>(SphereCell, SphereCell) = default;

 private:
  std::uint32_t code_ = ~std::uint32_t{0};
};

/// A marked subdivision of the sphere, in flat arrays. The head of this file explains the terms. A
/// mark is 0, 1 or kBeyond (marks.h). The index kNone means that there is no such point, half-arc
/// or face.
struct SphereMap {
  // For each point:
  std::vector<SphereDirection> direction;  ///< The direction. No two points have equal directions.
  std::vector<Mark> point_mark;            ///< Whether the point belongs to the set.
  /// A half-arc that leaves the point; kNone if the point is isolated.
  std::vector<std::uint32_t> first_out;
  /// The face around the point if the point is isolated, otherwise kNone.
  std::vector<std::uint32_t> point_face;

  // For each arc:
  std::vector<PlaneId> circle;  ///< The plane in which the arc lies.
  std::vector<Mark> arc_mark;   ///< Whether the arc belongs to the set.

  // For each half-arc:
  std::vector<std::uint32_t> origin;  ///< The point where the half-arc starts; kNone for a loop.
  std::vector<std::uint32_t> next;    ///< The next half-arc around the face to the left.
  std::vector<std::uint32_t> face;    ///< The face to the left of the half-arc.

  std::vector<Mark> face_mark;  ///< For each face, whether it belongs to the set.
  Mark centre_mark = 0;         ///< Whether the centre itself belongs to the set.

  /// Returns the number of points, including isolated points.
  std::size_t point_count() const { return direction.size(); }
  /// Returns the number of arcs. Arc a consists of half-arcs 2 a and 2 a + 1.
  std::size_t arc_count() const { return circle.size(); }
  /// Returns the number of faces.
  std::size_t face_count() const { return face_mark.size(); }
  /// Returns the other half-arc of the same arc.
  static std::uint32_t twin(std::uint32_t half_arc) { return half_arc ^ 1U; }
  /// Returns the point where a half-arc ends, or kNone for a loop.
  std::uint32_t target(std::uint32_t half_arc) const { return origin[twin(half_arc)]; }
  /// Whether an arc is a loop, that is, a whole circle without a point.
  bool is_loop(std::uint32_t arc) const { return origin[2 * std::size_t{arc}] == kNone; }
  /// Returns the half-arc that follows `half_arc` in the ring of half-arcs that leave the same
  /// point. Seen from outside the sphere, this ring is in clockwise order.
  std::uint32_t clockwise(std::uint32_t half_arc) const { return next[twin(half_arc)]; }

  /// Empties all arrays but keeps their memory.
  void clear();
};

/// The kind of the cell of space that contains the centre of a minimal map. The kind follows from
/// the shape of the map. If the cell is not a vertex, the set near the centre does not change under
/// small translations along the cell.
enum class PyramidKind : std::uint8_t {
  Volume,  ///< The map consists of one face, which has the mark of the centre.
  Facet,   ///< The map has one loop, which has the mark of the centre, and no other arc or point.
  /// The map has exactly two points. The two points are opposite directions, and both have the mark
  /// of the centre. Either both points are isolated, or each arc is a half-circle that joins them.
  Edge,
  Vertex,  ///< The map has none of the shapes above.
};

}  // namespace plumb
#pragma GCC visibility pop
