// Two checked subdivisions laid over each other: the cells of both at once.
//
// Main flow of overlay_maps(): the edges of both maps are swept together; a label, the pair of
// regions, is carried upward through every event (plane_builder.h). O((n + k) log n).
#pragma once

#include <cstdint>
#include <vector>

#include "plumb/base/context.h"
#include "plumb/plane/map_check.h"
#include "plumb/plane/plane_complex.h"

#pragma GCC visibility push(default)
namespace plumb {

/// Two maps as one subdivision.
struct MapOverlay {
  /// A region of each map; region 0 is the unbounded one.
  struct Origin {
    std::uint32_t first;   ///< region of the first map
    std::uint32_t second;  ///< region of the second map
    friend bool operator==(const Origin&, const Origin&) = default;
  };

  PlaneComplex complex;        ///< every edge of either map; nothing marked
  std::vector<Origin> origin;  ///< per face of the complex: the regions it is part of
};

/// Requires both reports to be Valid without open borders (Error{BadArgument}).
MapOverlay overlay_maps(const MapReport& first, const MapReport& second, Context& context);

/// One subdivision as a complex; the second region of every origin is 0. Same requirement.
MapOverlay overlay_map(const MapReport& report, Context& context);

}  // namespace plumb
#pragma GCC visibility pop
