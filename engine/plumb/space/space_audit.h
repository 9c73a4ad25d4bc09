// Checks from scratch, by exact predicates, whether a complex satisfies all invariants of
// space_complex.h.
//
// Main flow of audit(), in which each step relies on the steps before it:
//  1. links     sizes of arrays, ids, stars, uses, radial cycles, boundary cycles and free cells
//               are consistent
//  2. places    planes are distinct, and so are vertices; edges have the direction that their
//               planes define; facets around each edge are in counter-clockwise order; arcs of
//               sphere maps do not cross
//  3. cycles    boundary cycles are simple; the outer cycle of each facet is first and
//               counter-clockwise; holes lie inside the outer cycle and outside each other
//  4. meeting   cells meet only in common vertices and edges
//  5. marks     volumes are the same as those that find_volumes() finds; the frame is valid; if the
//               AuditForm is Minimal, the complex is minimal
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

/// Returns the first flaw found, or nothing. Every id is checked before it is used. So the id of a
/// plane or point that does not exist is reported as a flaw, and is never used. For
/// AuditForm::Minimal, a cell that could be removed without changing the set is a flaw, too. The
/// complex of every Nef3 is minimal. Throws what the context throws.
///
/// Cost: O(n log n + c), where c is the number of pairs of boxes of cells that meet. Two kinds of
/// cells cost more:
/// - Consider a facet, and the k vertices, edges and holes that lie inside the facet or in its box.
///   The facet costs O(k) times the number of cycles in whose boxes these items lie.
/// - A vertex of degree d costs O(d^2) if the corners around it do not form a fan
///   (mesh_topology.h).
///
/// Memory: about as much as the complex.
std::optional<SpaceFlaw> audit(const SpaceComplex& complex, AuditForm form,
                               Context& context = unlimited_context());

}  // namespace plumb
#pragma GCC visibility pop
