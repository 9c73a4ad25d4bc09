// Step 3 of a Boolean, and a part of step 5: finds the volume of the other operand in which each
// vertex without a contact lies, and carries vertices into a draft with new marks.
//
// Main flow of label_vertices():
//  1. flood  vertices that edges without contacts join lie in one volume, so they form a group
//  2. seeds  at a contact, the other operand's sphere map says into which volume each edge leads
//  3. ray    a group without seeds asks one ray
//
// Expected O(vertices + edges + seeds), and a ray for each group without contacts. Proof:
// docs/design/boolean.md, Lemma 4.
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

/// One operand of a Boolean with the contacts of each of its vertices and edges.
struct TouchedComplex {
  const SpaceComplex& complex;  ///< The operand.
  IdVector<VertexId, std::uint32_t>
      contact_of_vertex;                       ///< The contact of each vertex, or kUntouched.
  IdVector<EdgeId, std::uint32_t> edge_begin;  ///< Starts in edge_contacts, edge_count() + 1.
  std::vector<std::uint32_t> edge_contacts;    ///< Contacts inside each edge, in no order.

  static constexpr std::uint32_t kUntouched = ~std::uint32_t{0};  ///< Names no contact.

  /// Sorts the contacts by the cells of operand 0 or 1. Keeps a reference to the complex. O(n +
  /// contacts).
  TouchedComplex(const SpaceComplex& touched, std::span<const Contact> contacts,
                 std::size_t operand);
  /// Whether the vertex takes part in a contact.
  bool is_touched(VertexId v) const { return contact_of_vertex[v] != kUntouched; }
  /// Whether there is a contact inside the edge.
  bool is_touched(EdgeId e) const { return edge_begin[e] != edge_begin[e.value() + 1]; }
};

/// Returns for each vertex of `own`, which is operand 0 or 1, the volume of `other` in which it
/// lies; invalid for vertices with a contact. `tables` has the points of both.
IdVector<VertexId, VolumeId> label_vertices(const TouchedComplex& own, const SpaceComplex& other,
                                            std::span<const Contact> contacts, std::size_t operand,
                                            const SpaceTables& tables, Context& context);

// Vertices of a complex that go into a draft as they are, but for their marks.
//
// Around most vertices the corners of facets make one ring, with an edge of two facets between any
// two neighbours. The sphere maps of such vertices are written straight into the draft, many at
// once: their points are the half-edges, their arcs the corners, their two faces the sides of the
// ring. Other vertices are added by local_map().

/// Carries vertices of a complex into drafts and remembers where their half-edges went.
class VertexCarrier {
 public:
  /// A vertex, and the marks that replace the marks 0, 1 and kBeyond around it.
  struct Remarked {
    VertexId vertex;              ///< The vertex.
    std::array<Mark, 3> becomes;  ///< The new mark for each old one.
  };

  /// Keeps references to all arguments. Takes 4 bytes for each half-edge.
  VertexCarrier(const SpaceComplex& complex, SpaceDraft& draft, SphereOverlay& overlay)
      : complex_(complex),
        draft_(&draft),
        overlay_(overlay),
        point_of_(complex.origin.size(), kNone) {}

  /// Forgets the vertices that were carried, in time proportional to their number, and continues
  /// with another draft.
  void start(SpaceDraft& draft);

  /// Adds `local`, the map of v with other marks. Requires that it is minimal.
  void add(VertexId v, const LocalMap& local);
  /// Brings the map into minimal form and adds it. If v is not a vertex of the result, adds no
  /// vertex. If v is then a place inside an edge, adds this place.
  void add_simplified(VertexId v, LocalMap& local);
  /// Adds vertices as add() does, up to the first whose corners make several rings, and returns how
  /// many it added. Requires vertices with may_have_ring() whose maps are minimal with the new
  /// marks.
  std::size_t add_rings(std::span<const Remarked> vertices);
  /// Whether all edges of the vertex lie between two facets and it is inside no facet. O(degree).
  bool may_have_ring(VertexId v) const;

  /// Pairs the two ends of every edge that was carried.
  void face_ends();

  /// Returns for each half-edge the point of the draft that it became, or kNone.
  const IdVector<HalfedgeId, std::uint32_t>& point_of() const { return point_of_; }

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
  IdVector<HalfedgeId, std::uint32_t> point_of_;
  std::vector<HalfedgeId> carried_;            // Half-edges with an entry there.
  IdVector<UseId, std::uint32_t> arc_of_use_;  // The arcs of the corners of the vertex at hand.
  std::vector<std::uint32_t> origin_ids_;
  SphereOrigins kept_;
};

}  // namespace plumb
