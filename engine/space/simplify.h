// Bringing a complex into minimal form after marks were changed: items that do not differ from what is
// around them go.
//
// Main flow of simplified():
//  1. look      is it minimal already? Flat passes over facets, edges and vertices; sphere maps are made only
//               of vertices with exactly two half-edges, which may be places inside an edge
//  2. carry     else the map of every vertex is simplified and put into a draft
//  3. join      (space_draft.h)
#pragma once

#include <cstdint>
#include <vector>

#include "plumb/base/context.h"
#include "plumb/space/local_maps.h"
#include "plumb/space/space_complex.h"
#include "plumb/space/space_draft.h"
#include "plumb/sphere/sphere_overlay.h"

namespace plumb {

/// The same set in minimal form. O(n); a minimal complex is given back as it is.
SpaceComplex simplified(SpaceComplex complex, Context& context);

/// Carries vertices of a complex into drafts and remembers where their half-edges went.
class VertexCarrier {
 public:
  VertexCarrier(const SpaceComplex& complex, SpaceDraft& draft, SphereOverlay& overlay)
      : complex_(complex),
        draft_(&draft),
        overlay_(overlay),
        point_of_(complex.origin.size(), SphereMap::kNone) {}

  /// Forgets what was carried, in time proportional to that, and goes on with another draft.
  void start(SpaceDraft& draft);

  /// Adds `local`, the map of v with other marks; it must be minimal.
  void add(VertexId v, const LocalMap& local);
  /// Brings the map into minimal form first; adds nothing if v is no vertex any more, and a place inside an
  /// edge if it is that.
  void add_simplified(VertexId v, LocalMap& local);

  /// Lets the two ends of every edge carried face each other.
  void face_ends();

  /// Per half-edge: the point of the draft it became, or kNone.
  const std::vector<std::uint32_t>& point_of() const { return point_of_; }

 private:
  const SpaceComplex& complex_;
  SpaceDraft* draft_;
  SphereOverlay& overlay_;
  std::vector<std::uint32_t> point_of_;
  std::vector<HalfedgeId> carried_;  // those with an entry there
  std::vector<std::uint32_t> origin_ids_;
  SphereOrigins kept_;
};

}  // namespace plumb
