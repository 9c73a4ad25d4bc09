// Defects on purpose: a valid map, one change, and what a checker must then say.
//
// Every change keeps all other parts of the map as they were, so "nothing else is reported" can be
// asked for. Changes that add geometry make it so small that it meets nothing but its host.
#pragma once

#include <cstdint>
#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

#include "generate/test_map.h"
#include "plumb/plane/map_check.h"

namespace plumb::testing {

/// What check_map has to report under OuterRule::Listed. A missing count or list is not derivable
/// without judging the map (the brute-force twin does that).
struct DefectExpectation {
  std::string refused;  ///< when not empty: check_map throws, for this reason
  std::optional<MapVerdict> verdict = MapVerdict::Valid;
  std::optional<std::uint64_t> duplicate = 0;
  std::optional<std::uint64_t> open = 0;
  std::optional<std::uint64_t> crossing = 0;
  std::optional<std::uint64_t> twin = 0;
  std::optional<std::uint64_t> mixed = 0;
  std::vector<MapEdge> open_edges;                 ///< directed; complete when open is known
  std::vector<MapEdge> duplicate_edges;            ///< directed
  std::vector<std::pair<MapEdge, MapEdge>> pairs;  ///< crossing, undirected
  std::vector<ExactPoint> places;                  ///< of the crossings, in the order of `pairs`
};

struct DefectiveMap {
  TestMap map;
  DefectExpectation expected;
};

/// Where a change is made: cycle `cycle`, at its corner or edge `corner` (taken modulo its length).
struct DefectPlace {
  std::uint32_t cycle = 0;
  std::uint32_t corner = 0;
};

/// One kind of change. `valid` must be valid under OuterRule::Listed, without repeated positions.
struct MapDefectMaker {
  std::string name;
  DefectiveMap (*make)(const TestMap& valid, DefectPlace place);
};

/// Prints the name (GoogleTest looks for it).
void PrintTo(const MapDefectMaker& maker, std::ostream* out);

/// drop-face, drop-outer, duplicate-face, flip-face, flip-all, move-vertex, t-junction, t-both,
/// overlap, island, island-open, far-island, far-island-open, frame, spike, alias-vertex,
/// repeat-vertex, two-corners, bad-index, sliver, isolated-vertex.
const std::vector<MapDefectMaker>& map_defect_makers();

}  // namespace plumb::testing
