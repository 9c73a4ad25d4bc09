// A sphere map: the neighbourhood of a point, drawn on a small sphere around it. Everything that a
// marked subdivision of space looks like near that point (its centre) is a subdivision of the
// sphere by great circles, with a mark for each item and one for the centre.
//
//   point      an edge of space that leaves the centre          mark of the edge
//   arc        a facet corner at the centre                     mark of the facet
//   face       a volume at the centre                           mark of the volume
//
// Notation. A circle is a plane through the centre; only its normal is read. A direction is the
// cross product of two normals, so no length is ever needed and no square root appears. Each arc a
// has two half-arcs: 2a runs counter-clockwise about the (canonical) normal of circle[a], with the
// positive side of the plane to its left, seen from outside the sphere; 2a+1 runs the other way.
// An arc may be longer than a half-circle; one that starts and ends at the same point is a whole
// circle; one without points (origin kNone) is a loop. Two circles always cross, so a map has at most
// one loop, and then every other arc lies strictly on one side of it.
//
// Invariants: audit(). All planes of one map come from one PlaneTable and different planes have
// different normals there (they pass through the centre).
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "plumb/base/marks.h"
#include "plumb/predicates/plane_table.h"

#pragma GCC visibility push(default)
namespace plumb {

/// The direction n_p x n_q of two planes that are not parallel; {q, p} is the opposite one.
struct SphereDirection {
  PlaneId p;                                                     ///< a plane through the centre
  PlaneId q;                                                     ///< another one
  constexpr SphereDirection opposite() const { return {q, p}; }  ///< The antipode.
  friend bool operator==(const SphereDirection&, const SphereDirection&) = default;
};

/// An item of a map, in 32 bits. Default-constructed: none.
class SphereCell {
 public:
  /// Of cells.
  enum class Kind : std::uint32_t { Point, Arc, Face };

  constexpr SphereCell() = default;
  /// The cell of a kind with that number.
  constexpr SphereCell(Kind kind, std::uint32_t index)
      : code_((static_cast<std::uint32_t>(kind) << 30U) | index) {}
  /// The point with that number.
  static constexpr SphereCell point(std::uint32_t i) { return {Kind::Point, i}; }
  /// The arc with that number.
  static constexpr SphereCell arc(std::uint32_t i) { return {Kind::Arc, i}; }
  /// The face with that number.
  static constexpr SphereCell face(std::uint32_t i) { return {Kind::Face, i}; }

  constexpr bool is_valid() const { return code_ != ~std::uint32_t{0}; }   ///< Is it any cell?
  constexpr Kind kind() const { return static_cast<Kind>(code_ >> 30U); }  ///< Requires is_valid().
  /// Its number among its kind.
  constexpr std::uint32_t index() const { return code_ & 0x3fffffffU; }
  friend constexpr auto operator<=>(SphereCell, SphereCell) = default;

 private:
  std::uint32_t code_ = ~std::uint32_t{0};
};

/// A marked subdivision of the sphere, in flat arrays; invariants above.
struct SphereMap {
  static constexpr std::uint32_t kNone = ~std::uint32_t{0};  ///< no point, no half-arc, no face

  // per point
  std::vector<SphereDirection> direction;  ///< all different
  std::vector<Mark> point_mark;            ///< is it in the set?
  std::vector<std::uint32_t> first_out;    ///< a half-arc that leaves the point; kNone: isolated
  std::vector<std::uint32_t> point_face;   ///< of isolated points: the face around it; else kNone

  // per arc
  std::vector<PlaneId> circle;  ///< the plane it lies in
  std::vector<Mark> arc_mark;   ///< is it in the set?

  // per half-arc
  std::vector<std::uint32_t> origin;  ///< point; kNone: a loop
  std::vector<std::uint32_t> next;    ///< the half-arc that follows along the face to the left
  std::vector<std::uint32_t> face;    ///< the face to the left

  std::vector<Mark> face_mark;  ///< per face
  Mark centre_mark = 0;         ///< of the centre itself: the vertex that the map is around

  std::size_t point_count() const { return direction.size(); }  ///< Ends of arcs and isolated ones.
  std::size_t arc_count() const { return circle.size(); }  ///< Half-arcs 2a and 2a + 1 are arc a.
  std::size_t face_count() const { return face_mark.size(); }  ///< All of them.
  /// The other direction of the same arc.
  static std::uint32_t twin(std::uint32_t half_arc) { return half_arc ^ 1U; }
  /// Where a half-arc ends; kNone: a loop.
  std::uint32_t target(std::uint32_t half_arc) const { return origin[twin(half_arc)]; }
  /// Is it a whole circle, without a point on it?
  bool is_loop(std::uint32_t arc) const { return origin[2 * std::size_t{arc}] == kNone; }
  /// The half-arc that leaves the same point next clockwise, seen from outside.
  std::uint32_t clockwise(std::uint32_t half_arc) const { return next[twin(half_arc)]; }

  /// Empties all arrays and keeps their memory.
  void clear();
};

/// What the set that a map describes is invariant under near the centre (of a minimal map).
enum class PyramidKind : std::uint8_t {
  Volume,  ///< nothing but one face, with the centre's mark
  Facet,   ///< one loop, with the centre's mark
  Edge,    ///< two opposite points with the centre's mark, joined by half-circles or alone
  Vertex,  ///< anything else
};

}  // namespace plumb
#pragma GCC visibility pop
