// Phase "link" of an overlay: arcs are cut where the other map touches them, overlapping pieces become
// one, and the pieces are put around their points. Internal to engine/sphere.
//
// Main flow of build():
//  1. sort_stops   the stops of each arc in its order
//  2. cut_arcs     pieces between them; a loop with stops is cut into ordinary arcs
//  3. merge        pieces of one circle that leave one point are the same piece
//  4. link_rings   half-arcs around each point in circular order: known where one map only is present,
//                  sorted by headings where both are
//  5. trace        orbits of next: each is one boundary cycle
#pragma once

#include <array>
#include <vector>

#include "plumb/sphere/sphere_contacts.h"

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

}  // namespace plumb
