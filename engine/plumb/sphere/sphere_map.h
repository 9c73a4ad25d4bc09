// A sphere map: the neighbourhood of a point, drawn on a small sphere around it. Near that point
// (the centre) a marked subdivision of space is a cone, so it is described by a subdivision of the
// sphere by great circles, with a mark for each cell and one for the centre.
//
//   cell of the map   cell of space that it is part of          its mark
//   point             an edge that leaves the centre            mark of the edge
//   arc               a facet with a corner at the centre       mark of the facet
//   face              a volume that touches the centre          mark of the volume
//
// Notation: a circle is a plane through the centre; only the normal of the plane is read. A
// direction is the cross product of two normals, so no length is ever needed and no square root
// appears. Each arc a has two half-arcs: 2a runs counter-clockwise about the (canonical) normal of
// circle[a], with the positive side of the plane to its left, seen from outside the sphere; 2a + 1
// runs the other way. An arc may be longer than a half-circle. An arc that starts and ends at the
// same point is a whole circle; a whole circle without a point (origin kNone) is a loop. Two
// circles always cross, so a map has at most one loop, and then every other arc lies strictly on
// one side of it.
//
// Invariants: audit() (sphere_audit.h) checks them. All planes of a map come from one PlaneTable,
// and different planes have different normals there, since they all pass through the centre.
// Source: docs/design/sphere.md.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "plumb/base/marks.h"
#include "plumb/predicates/space/plane_table.h"

#pragma GCC visibility push(default)
namespace plumb {

/// The direction n_p x n_q, where n_p and n_q are the normals of two planes that are not parallel.
/// {q, p} is the opposite direction.
struct SphereDirection {
  PlaneId p;  ///< A plane through the centre.
  PlaneId q;  ///< Another plane through the centre.
  /// Returns the antipode.
  constexpr SphereDirection opposite() const { return {q, p}; }
  friend bool operator==(const SphereDirection&, const SphereDirection&) = default;
};

/// The id of a cell of a map, in 32 bits. Default-constructed it names no cell.
class SphereCell {
 public:
  /// The kinds of cells.
  enum class Kind : std::uint32_t { Point, Arc, Face };

  constexpr SphereCell() = default;
  /// Makes the id of the cell of a kind with number `index`, which must be less than 2^30.
  constexpr SphereCell(Kind kind, std::uint32_t index)
      : code_((static_cast<std::uint32_t>(kind) << 30U) | index) {}
  /// Returns the id of point i.
  static constexpr SphereCell point(std::uint32_t i) { return {Kind::Point, i}; }
  /// Returns the id of arc i.
  static constexpr SphereCell arc(std::uint32_t i) { return {Kind::Arc, i}; }
  /// Returns the id of face i.
  static constexpr SphereCell face(std::uint32_t i) { return {Kind::Face, i}; }

  /// Whether the id names a cell.
  constexpr bool is_valid() const { return code_ != ~std::uint32_t{0}; }
  /// Returns the kind of the cell. Requires is_valid().
  constexpr Kind kind() const { return static_cast<Kind>(code_ >> 30U); }
  /// Returns the number of the cell among those of its kind. Requires is_valid().
  constexpr std::uint32_t index() const { return code_ & 0x3fffffffU; }
  friend constexpr auto operator<=>(SphereCell, SphereCell) = default;

 private:
  std::uint32_t code_ = ~std::uint32_t{0};
};

/// A marked subdivision of the sphere, in flat arrays. The head of this file states the invariants.
/// A mark is 0, 1 or kBeyond (marks.h).
struct SphereMap {
  /// Stands for no point, no half-arc or no face.

  // For each point:
  std::vector<SphereDirection> direction;  ///< The direction of the point; all are different.
  std::vector<Mark> point_mark;            ///< Whether the point belongs to the set.
  /// A half-arc that leaves the point; kNone if the point is isolated.
  std::vector<std::uint32_t> first_out;
  /// The face around the point if the point is isolated, otherwise kNone.
  std::vector<std::uint32_t> point_face;

  // For each arc:
  std::vector<PlaneId> circle;  ///< The plane in which the arc lies.
  std::vector<Mark> arc_mark;   ///< Whether the arc belongs to the set.

  // For each half-arc:
  std::vector<std::uint32_t> origin;  ///< The point where it starts; kNone for a loop.
  std::vector<std::uint32_t> next;    ///< The next half-arc along the face to the left.
  std::vector<std::uint32_t> face;    ///< The face to the left.

  std::vector<Mark> face_mark;  ///< For each face, whether it belongs to the set.
  Mark centre_mark = 0;         ///< Whether the centre itself belongs to the set.

  /// Returns the number of points, isolated ones included.
  std::size_t point_count() const { return direction.size(); }
  /// Returns the number of arcs. Arc a consists of half-arcs 2a and 2a + 1.
  std::size_t arc_count() const { return circle.size(); }
  /// Returns the number of faces.
  std::size_t face_count() const { return face_mark.size(); }
  /// Returns the other half-arc of the same arc.
  static std::uint32_t twin(std::uint32_t half_arc) { return half_arc ^ 1U; }
  /// Returns the point where a half-arc ends, or kNone for a loop.
  std::uint32_t target(std::uint32_t half_arc) const { return origin[twin(half_arc)]; }
  /// Whether an arc is a loop: a whole circle without a point.
  bool is_loop(std::uint32_t arc) const { return origin[2 * std::size_t{arc}] == kNone; }
  /// Returns the half-arc that leaves the same point next in clockwise order, seen from outside.
  std::uint32_t clockwise(std::uint32_t half_arc) const { return next[twin(half_arc)]; }

  /// Empties all arrays but keeps their memory.
  void clear();
};

/// The kind of cell of space in which the centre of a minimal map lies. Near the centre the set is
/// invariant under translations along that cell.
enum class PyramidKind : std::uint8_t {
  Volume,  ///< The map is a single face with the mark of the centre.
  Facet,   ///< The map has only one loop, with the mark of the centre.
  Edge,    ///< Two opposite points with the centre's mark, isolated or joined by half-circles.
  Vertex,  ///< Any other map.
};

}  // namespace plumb
#pragma GCC visibility pop
