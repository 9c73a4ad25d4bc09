// Defects on purpose: a valid map, one change, and what a checker must then say.
//
// Every change keeps all other parts of the map as they were, so "nothing else is reported" can be
// asked for. Changes that add geometry make it so small that it meets nothing but its host. Several
// defects go into one map side by side (combined()).
#pragma once

#include <cstdint>
#include <iosfwd>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "plumb/plane/map_check.h"
#include "plumb/testing/test_map.h"

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

/// drop-face, drop-outer     a cycle is missing
/// duplicate-face            a cycle is listed twice
/// flip-face, flip-all       a cycle, or every one, runs the other way
/// move-vertex               a vertex lies far outside: its edges run across the map
/// t-junction, t-both        an edge has one vertex more for one of its faces, or (no defect) for
///                           both
/// overlap                   a square lies over the middle of an edge island, island-open       a
/// square nested in a face, with its outer cycle (no defect) or without far-island(-open), frame
/// the same beside and around the map spike                     an edge that goes nowhere
/// alias-vertex              a corner at a second vertex of the same position repeat-vertex,
/// two-corners, bad-index   what check_map refuses sliver                    a T-junction closed by
/// a triangle without area isolated-vertex           of no cycle (no defect) self-touch,
/// touching-hole a hole that touches its face's boundary in a vertex, in one cycle with it
///                           or on its own (no defect)
/// lens                      the two faces at an edge bulge over each other
const std::vector<MapDefectMaker>& map_defect_makers();

/// The one of that name, which has to be one of these.
const MapDefectMaker& map_defect_maker(std::string_view name);

/// All maps in one, side by side with a gap, and what is then to be said of them together: defects
/// add up. One that has to be refused has the whole refused.
DefectiveMap combined(std::span<const DefectiveMap> parts);

/// Giant or tiny coordinates: the same defects, at places times `factor`. Requires factor > 0.
DefectiveMap scaled(const DefectiveMap& defective, const BigRational& factor);

}  // namespace plumb::testing
