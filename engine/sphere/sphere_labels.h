// Phase "label" of an overlay: the faces of the overlaid map, and in which pair of cells each of its
// cells lies. Internal to engine/sphere.
//
// Main flow of build():
//  1. label_around   at a point of both maps the ring says in which face of the one the pieces of the
//                    other run
//  2. flood          that face holds along pieces, over points that the other map does not touch
//  3. part           connected parts of the overlay
//  4. join_parts     each part walks to the first one: cycles that follow each other on the way bound
//                    one face, and tell a part that touches nothing of a map where in it it lies
//  5. number_faces   classes of cycles
// Cost: O(n), and a walk of O(n log n) for each part but one.
#pragma once

#include <array>
#include <vector>

#include "plumb/sphere/sphere_overlay.h"
#include "plumb/sphere/sphere_path.h"
#include "plumb/sphere/sphere_pieces.h"

namespace plumb {

/// Keeps its memory between calls.
class SphereLabels {
 public:
  /// Turns the cycles of pieces.map into faces; fills `cells`.
  void build(const PlaneTable& planes, const SphereMap& a, const SphereMap& b,
             const SphereContacts& contacts, SpherePieces& pieces, SphereOrigins& cells);

 private:
  struct Link {
    SphereSlot first;
    SphereSlot second;
  };

  void take_known(const SphereContacts& contacts);
  void label_around(std::size_t k, std::uint32_t point);
  void set_label(std::size_t k, std::uint32_t half, std::uint32_t face);
  void flood(std::size_t k);
  void part();
  void join_parts();
  void walk_from(std::uint32_t point, std::uint32_t root_arc);
  void link(SphereSlot first, SphereSlot second);
  void label_parts(std::size_t k);
  bool pass_label(std::size_t k, SphereSlot from, SphereSlot to);
  void number_faces(SphereOrigins& cells);
  void fill_cells(SphereOrigins& cells);

  SphereCell half_cell(std::size_t k, std::uint32_t half) const;
  std::uint32_t face_at(std::size_t k, SphereSlot slot) const;
  std::uint32_t part_of(SphereSlot slot);
  std::uint32_t cycle_of(SphereSlot slot) const;
  std::uint32_t part_of_piece(std::uint32_t piece);

  const PlaneTable* planes_ = nullptr;
  std::array<const SphereMap*, 2> map_{};
  SpherePieces* pieces_ = nullptr;
  std::vector<std::array<SphereCell, 2>> point_cell_;     // not valid: not known
  std::array<std::vector<std::uint32_t>, 2> label_;       // per piece that is no part of an
                                                          // arc of map k: its face there
  std::vector<std::uint32_t> stack_;                      // pieces to flood from
  std::vector<std::uint32_t> part_;                       // union-find: points, then pieces
  std::array<std::vector<std::uint32_t>, 2> part_label_;  // per root in part_
  std::vector<std::uint32_t> class_;                      // union-find: cycles
  std::vector<std::uint32_t> face_number_;                // per root in class_
  std::vector<Link> links_;
  std::vector<PathHit> hits_;
};

}  // namespace plumb
