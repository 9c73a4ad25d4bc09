// The connected parts of a set of space, and the genus of its boundary.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "plumb/base/context.h"
#include "plumb/space/nef3.h"

#pragma GCC visibility push(default)
namespace plumb {

/// Returns the connected components of a set, in the order of their least cells: volumes first,
/// then facets, edges and vertices. Two marked cells are connected if one lies in the border of the
/// other. So two cubes that share a vertex are one component if the vertex belongs to the set, and
/// two components if it does not. Cost: O(n) for the search, and O(n) for each component.
[[nodiscard]] std::vector<Nef3> components(const Nef3& set, Context& context = unlimited_context());

/// Returns the sum of the genera of the components of the boundary: the number of handles. Returns
/// nullopt if the set is not simple (Nef3::is_simple()) or is unbounded, since its boundary is then
/// not a closed surface. O(n).
[[nodiscard]] std::optional<std::uint64_t> genus(const Nef3& set);

}  // namespace plumb
#pragma GCC visibility pop
