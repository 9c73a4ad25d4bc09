// Checks from scratch, by exact predicates, whether a complex satisfies all invariants of
// space_complex.h.
//
// Main flow of audit(), in which each step relies on the steps before it:
//  1. links     sizes, ids, stars, uses, radial cycles, boundary cycles and free cells agree
//  2. places    planes and vertices are distinct, edges run as their planes say, facets turn
//               counter-clockwise around edges, sphere maps are drawn without crossings
//  3. cycles    boundary cycles are simple, the outer cycle is first and counter-clockwise, holes
//               lie inside it and apart from each other
//  4. meeting   cells meet only in common vertices and edges
//  5. marks     volumes are those that find_volumes() finds, the frame is sound, and the complex is
//               minimal if the AuditForm is Minimal
#pragma once

#include <optional>
#include <string>

#include "plumb/base/context.h"
#include "plumb/space/space_complex.h"

#pragma GCC visibility push(default)
namespace plumb {

/// A broken invariant and the cells concerned.
struct SpaceFlaw {
  std::string invariant;  ///< The condition that does not hold.
  std::string place;      ///< The cells concerned, such as "edge 3, facet 5".
};

/// Returns the first flaw found, or nothing. Every id is checked before it is used, so the id of a
/// plane or point that does not exist is a flaw and does no harm. For AuditForm::Minimal, a cell
/// that could be removed without changing the set is a flaw, too (a Nef3 is minimal). Throws what
/// the context throws.
///
/// Cost: O(n log n + pairs of boxes that meet). Two kinds of cells cost more:
/// - A facet with k vertices, edges or holes inside it, or in the box of its surface, costs O(k)
///   times the number of cycles in whose boxes these vertices, edges or holes lie.
/// - A vertex of degree d around which the corners form no fan (mesh_topology.h) costs O(d^2).
///
/// Memory: about as much as the complex.
std::optional<SpaceFlaw> audit(const SpaceComplex& complex, AuditForm form,
                               Context& context = unlimited_context());

}  // namespace plumb
#pragma GCC visibility pop
