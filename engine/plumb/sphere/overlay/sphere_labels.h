// Phase "link" of an overlay: arcs are cut where the other map touches them, overlapping pieces
// become one, and the pieces are put around their points. Internal to engine/sphere.
//
// Main flow of build():
//  1. sort_stops   the stops of each arc in its order
//  2. cut_arcs     pieces between them; a loop with stops is cut into ordinary arcs
//  3. merge        pieces of one circle that leave one point are the same piece
//  4. link_rings   half-arcs around each point in circular order: known where one map only is
//                  present, sorted by headings where both are
//  5. trace        orbits of next: each is one boundary cycle
#pragma once

#include <array>
#include <vector>

#include "plumb/sphere/arcs/sphere_arcs.h"
#include "plumb/sphere/overlay/sphere_contacts.h"
#include "plumb/sphere/overlay/sphere_overlay.h"

namespace plumb {

/// Keeps its memory between calls.
class SpherePieces {
 public:
  /// `limits` are looked at between steps; may be null.
  void build(const PlaneTable& planes, const SphereMap& a, const SphereMap& b,
             SphereContacts& contacts, SphereLimits* limits = nullptr);

  /// Points of the contacts; one arc for each piece; without marks. face: the cycle of each
  /// half-arc; point_face: of isolated points, numbers following the cycles.
  SphereMap map;
  /// Per piece: the arc of each map that it is a part of, or kNone.
  std::vector<std::array<std::uint32_t, 2>> arc;
  /// Cycles of half-arcs; then one for each isolated point.
  std::uint32_t cycle_count = 0;

 private:
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
  // Per half-arc of each map: the half of a piece that leaves its origin.
  std::array<std::vector<std::uint32_t>, 2> leaving_;
  // Per point inside an arc of a map: the halves of pieces that leave it forward and backward.
  std::array<std::vector<Halves>, 2> through_;
  std::vector<std::uint32_t> ring_;  // half-arcs around a point, clockwise
};

// Phase "label" of an overlay: the faces of the overlaid map, and in which pair of cells each of
// its cells lies. Internal to engine/sphere.
//
// Main flow of build():
//  1. label_around   at a point of both maps the ring says in which face of the one the pieces of
//                    the other run
//  2. flood          that face holds along pieces, over points that the other map does not touch
//  3. label_parts    connected parts that touch nothing of a map learn from parts beside them in
//                    which face of it they lie (sphere_arcs.h)
//  4. number_faces   classes of cycles that bound one face
// Cost: O(n), and a walk of O(n log n) for each part but one.

/// Keeps its memory between calls.
class SphereLabels {
 public:
  /// Turns the cycles of pieces.map into faces; fills `cells`. `limits` are looked at between
  /// steps; may be null.
  void build(const PlaneTable& planes, const SphereMap& a, const SphereMap& b,
             const SphereContacts& contacts, SpherePieces& pieces, SphereOrigins& cells,
             SphereLimits* limits = nullptr);

 private:
  void take_known(const SphereContacts& contacts);
  void label_around(std::size_t k, std::uint32_t point);
  void set_label(std::size_t k, std::uint32_t half, std::uint32_t face);
  void flood(std::size_t k);
  void join_cycles();
  void label_parts(std::size_t k);
  bool pass_label(std::size_t k, SphereSlot from, SphereSlot to);
  void number_faces(SphereOrigins& cells);
  void fill_cells(SphereOrigins& cells);

  SphereCell half_cell(std::size_t k, std::uint32_t half) const;
  std::uint32_t face_at(std::size_t k, SphereSlot slot) const;
  std::uint32_t cycle_of(SphereSlot slot) const;

  const PlaneTable* planes_ = nullptr;
  std::array<const SphereMap*, 2> map_{};
  SpherePieces* pieces_ = nullptr;
  std::vector<std::array<SphereCell, 2>> point_cell_;  // not valid: not known
  std::array<std::vector<std::uint32_t>, 2> label_;    // per piece that is no part of an
                                                       // arc of map k: its face there
  std::vector<std::uint32_t> stack_;                   // pieces to flood from
  SphereParts parts_;
  std::array<std::vector<std::uint32_t>, 2> part_label_;  // per part
  std::vector<std::uint32_t> class_;                      // union-find: cycles
  std::vector<std::uint32_t> face_number_;                // per root in class_
};

}  // namespace plumb
