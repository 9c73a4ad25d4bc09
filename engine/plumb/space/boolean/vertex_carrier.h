// Vertices of a complex that go into a draft as they are, but for their marks.
//
// Around most vertices the corners of facets make one ring, with an edge of two facets between any
// two neighbours. Their sphere maps go straight into the draft, many at once: their points are the
// half-edges, their arcs the corners, their two faces the sides of the ring. The others go by
// local_map().
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "plumb/base/marks.h"
#include "plumb/space/boolean/assemble.h"
#include "plumb/space/local_maps.h"
#include "plumb/space/space_complex.h"
#include "plumb/sphere/overlay/sphere_overlay.h"

namespace plumb {

/// Carries vertices of a complex into drafts and remembers where their half-edges went.
class VertexCarrier {
 public:
  /// A vertex and what the marks 0, 1 and kBeyond around it become.
  struct Remarked {
    VertexId vertex;
    std::array<Mark, 3> becomes;
  };

  VertexCarrier(const SpaceComplex& complex, SpaceDraft& draft, SphereOverlay& overlay)
      : complex_(complex),
        draft_(&draft),
        overlay_(overlay),
        point_of_(complex.origin.size(), SphereMap::kNone) {}

  /// Forgets what was carried, in time proportional to that, and goes on with another draft.
  void start(SpaceDraft& draft);

  /// Adds `local`, the map of v with other marks; it must be minimal.
  void add(VertexId v, const LocalMap& local);
  /// Brings the map into minimal form first; adds nothing if v is no vertex any more, and a place
  /// inside an edge if it is that.
  void add_simplified(VertexId v, LocalMap& local);
  /// The same as add() of each, up to the first whose corners make several rings; returns how many
  /// it added. Requires vertices with may_have_ring(), minimal with the new marks.
  std::size_t add_rings(std::span<const Remarked> vertices);
  /// Are all its edges between two facets, and is it inside none?
  bool may_have_ring(VertexId v) const;

  /// Lets the two ends of every edge carried face each other.
  void face_ends();

  /// Per half-edge: the point of the draft it became, or kNone.
  const std::vector<std::uint32_t>& point_of() const { return point_of_; }

 private:
  bool write_ring(const Remarked& remarked, std::uint32_t vertex, const SpaceDraft::Offsets& at);
  void write_face_marks(FacetId of_first_arc, const std::array<Mark, 3>& becomes,
                        std::uint32_t face);
  bool link_ring(std::span<const HalfedgeId> star, const SpaceDraft::Offsets& at);
  std::array<UseId, 2> two_uses(HalfedgeId h) const;
  std::uint32_t half_arc(UseId u, HalfedgeId h) const;

  const SpaceComplex& complex_;
  SpaceDraft* draft_;
  SphereOverlay& overlay_;
  std::vector<std::uint32_t> point_of_;
  std::vector<HalfedgeId> carried_;        // those with an entry there
  std::vector<std::uint32_t> arc_of_use_;  // of the ring at hand
  std::vector<std::uint32_t> origin_ids_;
  SphereOrigins kept_;
};

}  // namespace plumb
