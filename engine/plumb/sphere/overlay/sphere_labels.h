// Two phases of an overlay of sphere maps (sphere_overlay.h): SpherePieces links, SphereLabels
// finds faces. Internal to engine/sphere.
//
// SpherePieces cuts arcs where the other map touches them, makes one of overlapping pieces, and
// puts the pieces around their points. Main flow of SpherePieces::build():
//  1. sort_stops   sorts the stops of each arc along it
//  2. cut_arcs     makes the pieces between them; a loop with stops is cut into ordinary arcs
//  3. merge        makes one piece of all pieces of one circle that leave one point
//  4. link_rings   puts half-arcs around each point in circular order, which is known where only
//                  one map is present, and sorted by headings where both are
//  5. trace        finds the orbits of next, each of which is one boundary cycle
#pragma once

#include <array>
#include <vector>

#include "plumb/sphere/arcs/sphere_arcs.h"
#include "plumb/sphere/overlay/sphere_contacts.h"
#include "plumb/sphere/overlay/sphere_overlay.h"

namespace plumb {

/// The pieces of the arcs of two maps. Keeps its memory between calls.
class SpherePieces {
 public:
  /// Makes the pieces of two maps with the given contacts, whose stops it sorts. Looks at `limits`
  /// between steps, unless it is null.
  void build(const PlaneTable& planes, const SphereMap& a, const SphereMap& b,
             SphereContacts& contacts, SphereLimits* limits = nullptr);

  /// The overlaid map: the points of the contacts and one arc for each piece, without marks. In
  /// this map, `face` is the cycle of each half-arc, and `point_face` of an isolated point is a
  /// number that follows the numbers of the cycles.
  SphereMap map;
  /// For each piece the arc of each map of which it is a part, or kNone.
  std::vector<std::array<std::uint32_t, 2>> arc;
  /// The number of cycles of half-arcs, without isolated points.
  std::uint32_t cycle_count = 0;

 private:
  /// A part of an arc between two points of the overlay.
  struct Piece {
    PlaneId circle;
    std::uint32_t from;
    std::uint32_t to;
    std::array<std::uint32_t, 2> arc;
  };
  using Halves = std::array<std::uint32_t, 2>;

  void sort_stops(std::size_t k, SphereContacts& contacts);
  void cut_arcs(std::size_t k, const SphereContacts& contacts);
  void cut_arc(std::size_t k, std::uint32_t a, const SphereContacts::Stop* first,
               const SphereContacts::Stop* last, const SphereContacts& contacts);
  void merge();
  void place_pieces(const SphereContacts& contacts);
  void note_leaving(std::uint32_t half, std::size_t k, const SphereContacts& contacts);
  void link_rings(const SphereContacts& contacts);
  void add_ring(std::size_t k, std::uint32_t point, const SphereContacts& contacts);
  void sort_ring(std::uint32_t point);
  void trace();

  const PlaneTable* planes_ = nullptr;
  std::array<const SphereMap*, 2> map_{};
  std::vector<Piece> pieces_;
  // For each half-arc of each map, the half of a piece that leaves its origin.
  std::array<std::vector<std::uint32_t>, 2> leaving_;
  // For each point inside an arc of a map, the halves of pieces that leave it forward and backward.
  std::array<std::vector<Halves>, 2> through_;
  std::vector<std::uint32_t> ring_;  // Half-arcs around a point, clockwise.
};

// SphereLabels finds the faces of the overlaid map, and the pair of cells in which each of its
// cells lies. Main flow of SphereLabels::build():
//  1. label_around   reads off the ring of a point that lies on a map in which face of it the
//                    pieces of the other map run
//  2. flood          carries that face along pieces, over points that the map does not touch
//  3. label_parts    gives connected parts that touch nothing of a map the face of parts beside
//                    them (sphere_arcs.h)
//  4. number_faces   numbers the classes of cycles that bound one face
// Cost: O(n), and a walk of O(n log n) for each part but one.

/// The faces of an overlay and the cells of the operands. Keeps its memory between calls.
class SphereLabels {
 public:
  /// Makes faces of the cycles of pieces.map, and fills `cells`. Looks at `limits` between steps,
  /// unless it is null.
  void build(const PlaneTable& planes, const SphereMap& a, const SphereMap& b,
             const SphereContacts& contacts, SpherePieces& pieces, SphereOrigins& cells,
             SphereLimits* limits = nullptr);

 private:
  void take_known(const SphereContacts& contacts);
  void label_around(std::size_t k, std::uint32_t point);
  void set_label(std::size_t k, std::uint32_t half, std::uint32_t face);
  void flood(std::size_t k);
  void join_cycles();
  void label_parts(std::size_t k, SphereLimits* limits);
  bool pass_label(std::size_t k, SphereSlot from, SphereSlot to);
  void number_faces(SphereOrigins& cells);
  void fill_cells(SphereOrigins& cells);

  SphereCell half_cell(std::size_t k, std::uint32_t half) const;
  std::uint32_t face_at(std::size_t k, SphereSlot slot) const;
  std::uint32_t cycle_of(SphereSlot slot) const;

  const PlaneTable* planes_ = nullptr;
  std::array<const SphereMap*, 2> map_{};
  SpherePieces* pieces_ = nullptr;
  std::vector<std::array<SphereCell, 2>> point_cell_;  // Invalid as long as it is unknown.
  // For each piece that is no part of an arc of map k, its face there, or kNone if not known.
  std::array<std::vector<std::uint32_t>, 2> label_;
  std::vector<std::uint32_t> stack_;  // Pieces from which to flood.
  SphereParts parts_;
  std::array<std::vector<std::uint32_t>, 2> part_label_;  // The face of map k, for each part.
  std::vector<std::uint32_t> class_;                      // Union-find over cycles.
  std::vector<std::uint32_t> face_number_;                // The face of each root in class_.
};

}  // namespace plumb
