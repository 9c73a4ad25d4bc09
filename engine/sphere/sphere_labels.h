// Phase "label" of an overlay: the faces of the overlaid map, and in which pair of cells each of its
// cells lies. Internal to engine/sphere.
//
// Main flow of build():
//  1. label_around   at a point of both maps the ring says in which face of the one the pieces of the
//                    other run
//  2. flood          that face holds along pieces, over points that the other map does not touch
//  3. label_parts    connected parts that touch nothing of a map learn from parts beside them in which
//                    face of it they lie (sphere_parts.h)
//  4. number_faces   classes of cycles that bound one face
// Cost: O(n), and a walk of O(n log n) for each part but one.
#pragma once

#include <array>
#include <vector>

#include "plumb/sphere/sphere_overlay.h"
#include "plumb/sphere/sphere_parts.h"
#include "plumb/sphere/sphere_pieces.h"

namespace plumb {

/// Keeps its memory between calls.
class SphereLabels {
 public:
  /// Turns the cycles of pieces.map into faces; fills `cells`. `limits` are looked at between steps; may be null.
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
