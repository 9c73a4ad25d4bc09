// The map of the tests: easy to edit, exact, independent of the engine; and its way into the
// engine.
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "plumb/plane/map.h"
#include "plumb/testing/exact.h"

namespace plumb::testing {

using Cycle = std::vector<std::uint32_t>;  ///< vertex indices, 0-based

/// What plumb::Map holds, in a form made for editing and brute force.
struct TestMap {
  std::vector<ExactPoint> points;
  std::vector<Cycle> cycles;

  std::uint32_t add_point(BigRational x, BigRational y);
  std::size_t corner_count() const;
};

/// Points that are doubles go in as doubles, all others as rationals.
Map to_map(const TestMap& map);
TestMap from_map(const Map& map);

/// The text format of `plumb map check`, for messages and for files.
std::string to_text(const TestMap& map);

/// Twice the signed area of a cycle; positive = counter-clockwise.
BigRational doubled_area(const TestMap& map, const Cycle& cycle);

/// Appends one cycle for every closed chain of missing twins. Requires that at most one directed
/// edge without twin starts at each vertex (a boundary without pinches).
void append_missing_cycles(TestMap& map);

// Changes that keep a valid map valid (and a defective one equally defective). `order` is any
// permutation of the vertices or cycles.
TestMap relabelled(const TestMap& map, const std::vector<std::uint32_t>& order);
TestMap reordered(const TestMap& map, const std::vector<std::uint32_t>& order);
TestMap rotated(const TestMap& map, std::uint32_t by);  ///< every cycle begins `by` corners later
TestMap scaled(const TestMap& map, const BigRational& factor);
TestMap translated(const TestMap& map, const BigRational& dx, const BigRational& dy);
TestMap axes_swapped(const TestMap& map);  ///< mirrored at x = y, all cycles reversed

/// Both maps in one list, the second one's vertices after those of the first.
TestMap joined(const TestMap& first, const TestMap& second);

}  // namespace plumb::testing
