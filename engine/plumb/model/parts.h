// Computes the connected components of a set of space, and the genus of its boundary.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "plumb/base/context.h"
#include "plumb/space/nef3.h"

#pragma GCC visibility push(default)
namespace plumb {

/// Returns the connected components of a set. Components are ordered by their first cells, where
/// volumes come before facets, facets before edges, and edges before vertices. Two marked cells are
/// connected if one of them lies in the boundary of the other. For example, two cubes that share a
/// vertex form one component if the vertex belongs to the set, and two components otherwise. Cost
/// for a set of n cells: O(n) for the search, and O(n) for each component.
[[nodiscard]] std::vector<Nef3> components(const Nef3& set, Context& context = unlimited_context());

/// Returns the number of handles of the boundary, which is the sum of the genera of its components.
/// Returns nullopt if the set is unbounded or not simple (Nef3::is_simple()), because its boundary
/// is then not a closed surface. Cost: O(n) for n cells.
[[nodiscard]] std::optional<std::uint64_t> genus(const Nef3& set);

}  // namespace plumb
#pragma GCC visibility pop
