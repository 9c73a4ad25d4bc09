// The brute-force twin of check_map: integers and rationals of Boost, all pairs, sets and maps.
//
// Slow (quadratic and worse) and meant to be obviously right. It shares the vocabulary of
// plumb/plane/map_check.h and no code. Definitions:
//   duplicate  uses of a directed edge beyond the first, summed
//   open       directed edges (each counted once) whose twin no cycle uses; 0 under Ignore
//   crossing   unordered pairs of distinct undirected edges whose common points are not just the
//              place of a vertex of both
//   twin       undirected edges both of whose directions are used by one cycle
//   mixed      orbits of "next half-edge around vertices"; S = listed cycles on the orbit. Mixed
//              are orbits of positive area with |S| > 1, or S = {c} and c has no positive area; of
//              the others those with |S| > 1 and not all of S clockwise, or S = {c} and c has
//              positive area. But an orbit of positive area is not mixed if its face is a part of a
//              region of rings: the cycles that bound common faces, directly or by way of others,
//              have winding number 1 at their left sides and 0 at their right sides, and exactly
//              one of them runs counter-clockwise (0, -1 and none if one of the faces is
//              unbounded). Only when duplicate = open = crossing = 0.
//   nested     components whose innermost surrounding orbit bears a listed cycle, and whose own
//              outer orbit has a half-edge that is not listed; only under Ignore, when mixed is
//              known
// Under Infer, a clockwise chain of missing half-edges becomes a cycle, unless nothing crosses and
// the chain goes round an overlap: the outer boundary of the face at every half-edge of it bears a
// counter-clockwise cycle, and the least ones of these are not all the same.
#pragma once

#include <optional>
#include <vector>

#include "plumb/plane/map_check.h"
#include "plumb/testing/test_map.h"

namespace plumb::testing {

/// A defect reduced to what is beyond dispute. Undirected edges have from < to; edges ascend.
struct OracleDefect {
  DefectKind kind;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> edges;
  /// Ascending. Duplicate: the first user and this one; Open: the first user; Crossing: all users
  /// of both edges; Twin: the least that uses both directions; Mixed: S; Nested: none.
  std::vector<std::uint32_t> cycles;
  std::optional<ExactPoint> point;  ///< Crossing: the least common point, by x, then y
  friend bool operator==(const OracleDefect&, const OracleDefect&) = default;
};
bool operator<(const OracleDefect& a, const OracleDefect& b);

struct OracleReport {
  MapVerdict verdict = MapVerdict::Valid;
  std::size_t edges = 0;
  std::size_t cycles = 0;
  std::size_t components = 0;
  MapDefectCounts counts;
  std::vector<OracleDefect> defects;  ///< all of them, sorted
  std::vector<MapRegion> regions;     ///< only when valid; unbounded first, then by outer cycle
  std::vector<Cycle> inferred;        ///< cycles added under Infer
  /// Some edge joins two vertices with equal coordinates. It has no direction, so the order of
  /// edges around its ends, and with it mixed and nested, is undefined. (Such an edge either
  /// crosses others or is a spike: the map is defective anyway.)
  bool has_zero_length_edge = false;
};

struct OracleOptions {
  OuterRule outer = OuterRule::Listed;
  bool merge_vertices = false;
};

/// A reason why check_map must refuse the map (after merging), or empty.
std::string refusal(const TestMap& map, const OracleOptions& options);

/// Requires refusal() to be empty.
OracleReport judge(const TestMap& map, const OracleOptions& options);

/// What of `report` the oracle can speak about, in the oracle's form.
std::vector<OracleDefect> defects_of(const MapReport& report);

/// Empty when `report` agrees with `expected` in verdict, counts, defects, components and regions;
/// else the first difference in words. What is undefined is not compared.
std::string difference(const MapReport& report, const OracleReport& expected);

}  // namespace plumb::testing
