// Decides exactly whether a list of cycles is a planar subdivision. If it is, check_map() reports
// the regions of the subdivision. Otherwise it reports all defects and where they are.
//
// Notation: a listed cycle uses the directed edges (half-edges) between its consecutive corners.
// The twin of (u, v) is (v, u). An undirected edge is a pair {u, v} that is used in at least one
// direction. The id of a vertex or cycle is its 0-based index in the input.
//
// Main flow of check_map() (docs/maps.md defines every defect):
//  1. match_twins       sorts the half-edges into buckets by the lesser of their two vertex ids,
//                       and finds the duplicate, open and twin defects
//  2. classify_open     follows chains of open edges. Each chain bounds a gap in the coverage or is
//                       a missing outer boundary.
//  3. find_contacts     makes one sweep over the undirected edges (docs/design/sweep.md). It finds:
//                         - every pair of edges that intersect elsewhere than at a common vertex
//                         - the order of the edges around each vertex
//                         - for each component, the edge below its first vertex
//  4. trace_orbits      traces the faces of the induced graph, that is, the planar graph of all
//                       undirected edges, and finds the mixed faces. A face is traced from each
//                       half-edge to the next one, which the order of the edges around a vertex
//                       determines. This step is taken only if steps 1 to 3 found no duplicate,
//                       open or crossing defect.
//  5. nest_components   puts each component into a face: step 3 found the edge below the first
//                       vertex of the component, and the face is the one above this edge
//  6. describe_defects  describes the defects in a fixed order, with exact points and hints
//
// Cost: O((n + k) log n) time for n corners and k crossings; O(n + d) memory for d described
// defects.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "plumb/base/context.h"
#include "plumb/base/ids.h"
#include "plumb/dcel/dcel.h"
#include "plumb/plane/map.h"

#pragma GCC visibility push(default)
namespace plumb {

/// The requirement on outer boundaries.
enum class OuterRule {
  Listed,  ///< The outer boundary of every component must be listed, clockwise.
  Infer,   ///< Clockwise chains of open edges become the missing outer cycles, with a warning.
  /// Open edges are no defects. A component that lies inside a listed face is a Nested defect,
  /// unless the outer boundary of the component is listed.
  Ignore,
};

/// The verdict on a list of cycles (docs/maps.md). If several verdicts apply, the first of them in
/// this list is given.
enum class MapVerdict {
  Valid,                  ///< There is no defect.
  NotAPlanarSubdivision,  ///< There are Duplicate defects.
  Open,                   ///< There are Open defects and no Duplicate defects.
  Superposed              ///< There are defects, but none of the kinds Duplicate and Open.
};

/// The kinds of defects (definitions: docs/maps.md).
enum class DefectKind {
  Duplicate,  ///< A directed edge is used more than once.
  Open,       ///< A directed edge is used, but its twin is not.
  Crossing,   ///< Two undirected edges intersect elsewhere than at a common vertex.
  Twin,       ///< One cycle uses an edge in both directions.
  /// The boundary of a face of the induced graph differs from the listed cycles. The boundary of a
  /// bounded face must be one counter-clockwise cycle. The boundary of the outside of a component
  /// must consist of clockwise cycles only.
  Mixed,
  Nested  ///< A component lies in a listed face, and its outer boundary is not listed.
};

/// Options of check_map().
struct MapCheckOptions {
  OuterRule outer = OuterRule::Listed;  ///< The requirement on outer boundaries.
  bool merge_vertices = false;  ///< Whether vertices with equal coordinates are merged first.
  /// The largest number of defects that are described. The counts of defects are always complete.
  std::uint64_t max_defects = 1000;
};

/// An edge, named by its end vertices.
struct MapEdge {
  std::uint32_t from;  ///< The first vertex.
  std::uint32_t to;    ///< The second vertex.
  friend bool operator==(const MapEdge&, const MapEdge&) = default;
};

/// One defect, with everything a user needs to find and correct it.
struct MapDefect {
  DefectKind kind = DefectKind::Duplicate;  ///< The kind of defect.
  /// The ids of the listed cycles that have the defect, in ascending order.
  std::vector<std::uint32_t> cycles;
  /// The edges that have the defect. They are undirected for Crossing and Twin, otherwise directed.
  /// A Mixed defect has one edge of the boundary of the face. A Nested defect has one edge of the
  /// boundary of the component.
  std::vector<MapEdge> edges;
  /// The exact point where the defect is. For edges that overlap it is the first common point.
  std::optional<RationalPoint2> point;
  Point2 near{};     ///< The doubles nearest to the coordinates of `point`.
  std::string hint;  ///< A sentence that explains the defect and how to correct it.
};

/// The counts of all defects, including those that are not described (definitions: docs/maps.md).
struct MapDefectCounts {
  std::uint64_t duplicate = 0;  ///< Repeated uses of a directed edge.
  std::uint64_t open = 0;       ///< Directed edges without a twin; 0 under OuterRule::Ignore.
  /// Pairs of undirected edges that intersect elsewhere than at a common vertex.
  std::uint64_t crossing = 0;
  std::uint64_t twin = 0;  ///< Undirected edges with both half-edges in one cycle.
  /// Mixed faces. Set only if `duplicate`, `open` and `crossing` are all 0.
  std::optional<std::uint64_t> mixed;
  std::uint64_t nested = 0;  ///< Nested components. Only OuterRule::Ignore can make it positive.
};

/// The kinds of warnings. A warning reports something unusual that is not a defect.
enum class WarningKind {
  Pinch,           ///< A face touches itself at a vertex.
  IsolatedVertex,  ///< No cycle uses a vertex.
  InferredOuter,   ///< An outer cycle was added (OuterRule::Infer).
  MergedVertex     ///< A vertex was merged into a vertex with equal coordinates and a lower id.
};

/// One warning.
struct MapWarning {
  WarningKind kind;          ///< The kind of warning.
  std::uint32_t vertex = 0;  ///< Id of the vertex; for InferredOuter, id of the added cycle.
  std::string text;          ///< One sentence for the user.
};

/// A face of the subdivision, bounded by at most one outer cycle and any number of holes.
struct MapRegion {
  /// Id of the counter-clockwise cycle around the region. The unbounded region has none.
  std::optional<std::uint32_t> outer;
  /// Ids of the clockwise cycles that bound the holes of the region, in ascending order.
  std::vector<std::uint32_t> holes;
};

/// The result of check_map().
struct MapReport {
  MapVerdict verdict = MapVerdict::Valid;  ///< Whether the map is valid. If not, the reason.
  std::size_t vertices = 0;                ///< Number of listed vertices.
  std::size_t edges = 0;                   ///< Number of undirected edges.
  std::size_t cycles = 0;                  ///< Number of cycles, including inferred cycles.
  std::size_t components = 0;              ///< Number of connected components of the edge graph.
  MapDefectCounts counts;                  ///< The counts of all defects.
  /// The described defects, at most max_defects. They are sorted by kind, and within a kind by
  /// their position in the input.
  std::vector<MapDefect> defects;
  /// The warnings, sorted by kind. At most max_defects warnings of each kind are listed, and then
  /// one more warning that states how many are not listed. InferredOuter has no such limit.
  std::vector<MapWarning> warnings;
  /// The regions, the unbounded region first. Only a map with the verdict Valid has regions.
  std::vector<MapRegion> regions;
  Map map;  ///< The map that was checked, with vertices merged and outer cycles added.
};

/// Checks a map and returns the verdict with all defects or all regions. Throws:
///   - Error{DegenerateFace} if two consecutive corners of a listed cycle are the same vertex, or
///     if a cycle has fewer than 3 corners, before or after vertices are merged
///   - Error{BadIndex} if a corner is not the index of a vertex
///   - ResourceLimit and Cancelled as the Context demands
/// The head of this file states the cost.
MapReport check_map(Map map, const MapCheckOptions& options = {},
                    Context& context = unlimited_context());

/// Returns the half-edge structure of a valid map. It has one loop for each listed cycle, and one
/// face for each region, in the order of report.regions. It does not contain vertices that no cycle
/// uses. Throws Error{BadArgument} if the verdict is not Valid or a directed edge has no twin. A
/// map that is valid under OuterRule::Ignore may have such edges.
DcelFromCycles to_dcel(const MapReport& report);

}  // namespace plumb
#pragma GCC visibility pop
