// Is an overlay of two maps what brute force says it is? By all cells of all lines through their
// edges.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "generate/curve_scenes.h"
#include "oracle/line_cells.h"
#include "plumb/plane/map_overlay.h"
#include "plumb/testing/test_map.h"

namespace plumb::testing {

/// The edges of a map become curves of a scene.
void add_edges(const TestMap& map, CurveScene& scene);

/// Per cell the region of the map it is part of; the unbounded one where it lies on an edge, too.
std::vector<std::uint32_t> regions_of(const MapReport& report, const LineCells& cells);

/// Empty: every region of both maps has the area of its cells together; else the first that has
/// not.
std::string areas_that_differ(const MapReport& first, const MapReport& second,
                              const MapOverlay& overlay);

/// Requires valid maps. Overlays them and looks at every vertex, edge and face, at the pair of
/// regions of every face, and at areas. Empty: all as brute force says; else the first difference
/// in words.
std::string overlay_disagreement(const TestMap& one, const TestMap& two);

}  // namespace plumb::testing
