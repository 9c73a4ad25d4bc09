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

#include <span>
#include <vector>

#include "plumb/base/context.h"
#include "plumb/space/boolean/find_contacts.h"

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

}  // namespace plumb
