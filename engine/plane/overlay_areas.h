// Do the cells of an overlay add up to the regions they were cut from? Exactly.
#pragma once

#include <cstdint>
#include <vector>

#include "plumb/base/context.h"
#include "plumb/plane/map_overlay.h"

#pragma GCC visibility push(default)
namespace plumb {

/// Exact areas of cells and of the regions they were cut from.
struct OverlayAreas {
  std::vector<Rational> cell;           ///< per face of the complex; 0 for the unbounded one
  std::vector<Rational> first, second;  ///< per region, of its listed cycles; 0 for region 0
  /// Bounded regions whose cells do not have their area together. None, or there is a bug.
  std::vector<std::uint32_t> wrong_first, wrong_second;

  /// Do the cells of every region have its area together?
  bool add_up() const { return wrong_first.empty() && wrong_second.empty(); }
};

/// Requires the overlay of these two reports. O(n) exact terms. Throws what the context throws.
OverlayAreas measure(const MapOverlay& overlay, const MapReport& first, const MapReport& second,
                     Context& context);

/// The area that the bounded regions of a map cover together.
Rational sum_of(const std::vector<Rational>& areas);

}  // namespace plumb
#pragma GCC visibility pop
