// Which listed regions claim which places of the plane, whether the map is a subdivision or not.
//
// The edges of the map divide the plane into the faces of an arrangement, in which crossings and
// overlaps of edges are resolved. A half-edge of the map has one piece for each edge of the
// arrangement on it. A region claims a face if its outer boundary, a counter-clockwise listed
// cycle, lists a half-edge with the face at its left. Two regions that claim one face overlap
// there. So do a region that lists one side of an edge and another one that claims the face at the
// other side, where no cycle lists it: the claim goes on across the edge.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "plumb/base/context.h"
#include "plumb/plane/check/map_edges.h"

namespace plumb {

/// The claims of the regions of a map.
class MapClaims {
 public:
  static constexpr std::uint32_t kNoCycle = MapEdges::kNoCycle;
  static constexpr std::uint32_t kNoEdge = kNoCycle;

  /// Makes claims that are not known.
  MapClaims() = default;
  /// Finds the claims of all regions. O((n + k) log n) for k contacts of edges. Throws
  /// ResourceLimit and Cancelled as the context says.
  MapClaims(const Map& map, const MapEdges& edges, Context& context);

  bool is_known() const { return is_known_; }
  /// Whether the ends of edge e are different points.
  bool has_length(std::uint32_t e) const { return piece_begin_[e] != piece_begin_[e + 1]; }
  /// Whether a cycle is the outer boundary of a region, because it runs counter-clockwise.
  bool is_region(std::uint32_t cycle) const { return is_region_[cycle] != 0; }
  /// Returns the faces left of those pieces of half-edge h that no cycle lists, ascending.
  std::vector<std::uint32_t> unlisted_faces(std::uint32_t h) const;
  /// Of the regions other than `but` that claim one of these faces, returns the region with the
  /// least index, or kNoCycle if there is none. O(number of faces).
  std::uint32_t other_claimant(const std::vector<std::uint32_t>& faces, std::uint32_t but) const;
  /// Whether a region, and no other one, claims a face.
  bool is_only_claimant(std::uint32_t region, std::uint32_t face) const {
    return claims(face).size() == 1 && claims(face).front() == region;
  }
  /// Returns another edge of the map than the edge of h, from which a cycle lists the left side of
  /// the first piece of h. Returns kNoEdge if there is none.
  std::uint32_t lister_beside(std::uint32_t h) const;
  /// Returns a region of `first` and another one of `second` that claim one face beside edge e.
  std::optional<std::pair<std::uint32_t, std::uint32_t>> overlap_beside(
      std::uint32_t e, std::span<const std::uint32_t> first,
      std::span<const std::uint32_t> second) const;

 private:
  class Collector;

  std::span<const std::uint32_t> pieces(std::uint32_t e) const {
    return {pieces_.data() + piece_begin_[e], pieces_.data() + piece_begin_[e + 1]};
  }
  std::span<const std::uint32_t> claims(std::uint32_t face) const {
    return {claims_.data() + claim_begin_[face], claims_.data() + claim_begin_[face + 1]};
  }

  bool is_known_ = false;
  std::vector<char> is_region_;              // For each listed cycle.
  std::vector<std::uint32_t> piece_begin_;   // For each edge of the map, its first piece.
  std::vector<std::uint32_t> pieces_;        // Half-edges of the arrangement along half-edge 2 e.
  std::vector<std::uint32_t> face_left_of_;  // For each half-edge of the arrangement.
  std::vector<std::uint32_t> lister_;        // An edge of the map that lists it, or kNoEdge.
  std::vector<std::uint32_t> claim_begin_;   // For each face of the arrangement, its first claim.
  std::vector<std::uint32_t> claims_;        // Regions, ascending within a face.
};

}  // namespace plumb
