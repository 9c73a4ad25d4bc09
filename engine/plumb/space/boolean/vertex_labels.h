// The phase `locate` of a Boolean: in which volume of the other operand does each vertex without a
// contact lie?
//
// Main flow:
//  1. an edge without contacts lies in one volume: vertices joined by such edges have the same
//     label
//  2. seeds: at a contact the other operand's sphere map says where each edge leads
//  3. a group without seeds asks one ray
//
// Expected O(vertices + edges + seeds); a ray for each group without contacts.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "plumb/base/context.h"
#include "plumb/base/marks.h"
#include "plumb/space/boolean/assemble.h"
#include "plumb/space/boolean/find_contacts.h"
#include "plumb/space/local_maps.h"
#include "plumb/space/space_complex.h"
#include "plumb/sphere/overlay/sphere_overlay.h"

namespace plumb {

/// One operand of a Boolean with what its contacts touch.
struct TouchedComplex {
  const SpaceComplex& complex;
  std::vector<std::uint32_t> contact_of_vertex;  ///< index of the contact, or kUntouched
  std::vector<std::uint32_t> edge_begin;         ///< edge_count() + 1 entries into edge_contacts
  std::vector<std::uint32_t> edge_contacts;      ///< contacts inside each edge, in no order

  static constexpr std::uint32_t kUntouched = ~std::uint32_t{0};

  /// `operand` 0 or 1: which item of the contacts is ours.
  TouchedComplex(const SpaceComplex& touched, std::span<const Contact> contacts,
                 std::size_t operand);
  bool is_touched(VertexId v) const { return contact_of_vertex[v.value()] != kUntouched; }
  bool is_touched(EdgeId e) const { return edge_begin[e.value()] != edge_begin[e.value() + 1]; }
};

/// Per vertex of operand 0 or 1 (`own`) the volume of `other` it lies in; not valid for touched
/// ones. `tables` hold the points of both.
std::vector<VolumeId> label_vertices(const TouchedComplex& own, const SpaceComplex& other,
                                     std::span<const Contact> contacts, std::size_t operand,
                                     const SpaceTables& tables, Context& context);

// Vertices of a complex that go into a draft as they are, but for their marks.
//
// Around most vertices the corners of facets make one ring, with an edge of two facets between any
// two neighbours. Their sphere maps go straight into the draft, many at once: their points are the
// half-edges, their arcs the corners, their two faces the sides of the ring. The others go by
// local_map().

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
        point_of_(complex.origin.size(), kNone) {}

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
