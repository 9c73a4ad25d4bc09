// Checks from scratch, by exact predicates, whether a complex satisfies all invariants of
// space_complex.h.
//
// Main flow of audit(), in which each step relies on the steps before it:
//  1. links     checks that the sizes of arrays, ids, stars, uses, radial cycles, boundary cycles
//               and free cells are consistent
//  2. places    checks that no two planes and no two vertices are equal. Each edge must have the
//               direction that its planes define. The facets around an edge must be in
//               counter-clockwise order. The arcs of a sphere map must not cross
//  3. cycles    checks that boundary cycles are simple. The outer cycle of a facet must be its
//               first cycle and run counter-clockwise. Holes must lie inside the outer cycle, and
//               no hole may lie inside another hole
//  4. meeting   checks that cells meet only in common vertices and edges
//  5. marks     compares the volumes with the volumes that find_volumes() finds, and checks that
//               the frame is valid. If the AuditForm is Minimal, the complex must be minimal, too
#pragma once

#include <optional>
#include <string>

#include "plumb/base/context.h"
#include "plumb/space/space_complex.h"

#pragma GCC visibility push(default)
namespace plumb {

/// An invariant that does not hold, and the cells that violate it.
struct SpaceFlaw {
  std::string invariant;  ///< The condition that does not hold.
  std::string place;      ///< The cells that violate it, such as "edge 3, facet 5".
};

/// Returns the first flaw that was found, or nullopt if there is no flaw. Every id is checked
/// before it is used. So an id that is out of range is reported as a flaw and never used. For
/// AuditForm::Minimal, a cell that could be removed without changing the set is a flaw, too. The
/// complex of every Nef3 is minimal. Throws the errors of the Context.
///
/// Cost: O(n log n + c), where n is the number of cells, and c is the number of pairs of cells
/// whose boxes meet. Two kinds of cells cost more:
/// - Let k be the number of vertices, edges and holes that lie inside a facet or in its box. The
///   facet costs O(k) times the number of cycles whose boxes contain these vertices, edges and
///   holes.
/// - A vertex of degree d costs O(d^2) if the sectors of the facets at it do not form a fan
///   (mesh_topology.h).
///
/// The audit takes about as much memory as the complex.
std::optional<SpaceFlaw> audit(const SpaceComplex& complex, AuditForm form,
                               Context& context = unlimited_context());

}  // namespace plumb
#pragma GCC visibility pop
