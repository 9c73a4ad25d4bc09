// Decides exactly whether a list of cycles is a planar subdivision. Reports all defects with their
// places, or the regions of the subdivision.
//
// Notation: a listed cycle uses the directed edges (half-edges) between its consecutive corners.
// The twin of (u, v) is (v, u). An undirected edge is a pair {u, v} that is used in at least one
// direction. Ids of vertices and cycles are positions in the input, 0-based.
//
// Main flow of check_map() (docs/maps.md defines every defect):
//  1. match_twins       buckets the half-edges by their lesser vertex: duplicate, open and twin
//                       defects
//  2. classify_open     follows chains of open edges: each is a gap in the coverage or a missing
//                       outer boundary
//  3. find_contacts     finds, in one sweep over the undirected edges, every pair that intersects
//                       anywhere but at a common vertex, the order of edges around each vertex, and
//                       the edge below the first vertex of each component (docs/design/sweep.md)
//  4. trace_orbits      traces the faces of the induced planar graph, which are the orbits of
//                       next-around-vertex, and finds the mixed ones; only if steps 1 to 3 found
//                       no duplicate, open or crossing defect
//  5. nest_components   puts each component into the face above the edge below its first vertex
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

/// What is required of outer boundaries.
enum class OuterRule {
  Listed,  ///< The outer boundary of every component must be listed, clockwise.
  Infer,   ///< Clockwise chains of open edges become the missing outer cycles, with a warning.
  /// Open edges are no defect; a component inside a listed face is one (Nested) unless its outside
  /// is listed.
  Ignore,
};

/// The verdict on a list of cycles (docs/maps.md). The first of these that applies is given.
enum class MapVerdict {
  Valid,                  ///< There is no defect.
  NotAPlanarSubdivision,  ///< There are Duplicate defects.
  Open,                   ///< There are Open defects and no Duplicate ones.
  Superposed              ///< There are defects of other kinds only.
};

/// The kinds of defects (definitions: docs/maps.md).
enum class DefectKind {
  Duplicate,  ///< A directed edge is used more than once.
  Open,       ///< The twin of a directed edge is not used.
  Crossing,   ///< Two undirected edges intersect elsewhere than at a common vertex.
  Twin,       ///< One cycle uses an edge in both directions.
  Mixed,      ///< A face of the induced graph is bounded by other cycles than a region may be.
  Nested      ///< A component lies in a listed face, and its outside is not listed.
};

/// Options of check_map().
struct MapCheckOptions {
  OuterRule outer = OuterRule::Listed;  ///< What is required of outer boundaries.
  bool merge_vertices = false;       ///< Whether vertices with equal coordinates are merged first.
  std::uint64_t max_defects = 1000;  ///< Limit of described defects; counts are always complete.
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
  std::vector<std::uint32_t> cycles;        ///< The listed cycles concerned, ascending.
  /// The edges concerned: undirected for Crossing and Twin, otherwise directed. For Mixed and
  /// Nested this is one edge of the boundary of the face or of the component.
  std::vector<MapEdge> edges;
  std::optional<RationalPoint2> point;  ///< The exact place; the first point of an overlap.
  Point2 near{};                        ///< The doubles nearest to that point.
  std::string hint;                     ///< What is wrong and how to correct it.
};

/// The numbers of all defects, including those that are not described (definitions: docs/maps.md).
struct MapDefectCounts {
  std::uint64_t duplicate = 0;  ///< Repeated uses of a directed edge.
  std::uint64_t open = 0;       ///< Directed edges without a twin; 0 under OuterRule::Ignore.
  /// Pairs of undirected edges that intersect elsewhere than at a common vertex.
  std::uint64_t crossing = 0;
  std::uint64_t twin = 0;  ///< Undirected edges with both half-edges in one cycle.
  /// Mixed faces; without a value unless duplicate = open = crossing = 0.
  std::optional<std::uint64_t> mixed;
  std::uint64_t nested = 0;  ///< Nested components; always 0 except under OuterRule::Ignore.
};

/// The kinds of warnings: what is unusual but no defect.
enum class WarningKind {
  Pinch,           ///< A face touches itself at a vertex.
  IsolatedVertex,  ///< No cycle uses a vertex.
  InferredOuter,   ///< An outer cycle was added (OuterRule::Infer).
  MergedVertex     ///< A vertex was merged into a lower-numbered one with equal coordinates.
};

/// One warning.
struct MapWarning {
  WarningKind kind;          ///< The kind of warning.
  std::uint32_t vertex = 0;  ///< The vertex concerned; for InferredOuter the added cycle.
  std::string text;          ///< One sentence for the user.
};

/// A face of the subdivision, bounded by at most one outer cycle and any number of holes.
struct MapRegion {
  /// The counter-clockwise cycle around the region; without a value for the unbounded region.
  std::optional<std::uint32_t> outer;
  std::vector<std::uint32_t> holes;  ///< The clockwise cycles that bound its holes, ascending.
};

/// The result of check_map().
struct MapReport {
  MapVerdict verdict = MapVerdict::Valid;  ///< Whether the map is valid, and if not, why.
  std::size_t vertices = 0;                ///< Number of listed vertices.
  std::size_t edges = 0;                   ///< Number of undirected edges.
  std::size_t cycles = 0;                  ///< Number of cycles, inferred ones included.
  std::size_t components = 0;              ///< Number of connected components of the edge graph.
  MapDefectCounts counts;                  ///< The numbers of all defects.
  /// At most max_defects defects, sorted by kind, then by place in the input.
  std::vector<MapDefect> defects;
  /// The warnings, kind by kind. Of each kind except InferredOuter at most max_defects are listed;
  /// one more then gives the number of the others.
  std::vector<MapWarning> warnings;
  /// The regions, the unbounded one first; empty unless the verdict is Valid.
  std::vector<MapRegion> regions;
  Map map;  ///< The map that was checked, with vertices merged and outer cycles added.
};

/// Checks a map and returns the verdict with all defects or all regions. Throws
/// Error{DegenerateFace} if a cycle has fewer than 3 corners, also after vertices are merged, or
/// repeats a corner in a row; Error{BadIndex} if a corner is not the index of a vertex;
/// ResourceLimit and Cancelled as the Context demands. Cost: see the head of this file.
MapReport check_map(Map map, const MapCheckOptions& options = {},
                    Context& context = unlimited_context());

/// Returns the half-edge structure of a valid map. It has one loop per listed cycle and one face
/// per region, in the order of report.regions; vertices that no cycle uses are not in it. Throws
/// Error{BadArgument} unless the verdict is Valid and every edge has a twin (a map that is valid
/// under OuterRule::Ignore may have open edges).
DcelFromCycles to_dcel(const MapReport& report);

}  // namespace plumb
#pragma GCC visibility pop
