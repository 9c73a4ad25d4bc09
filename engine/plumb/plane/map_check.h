// Decides exactly whether a list of cycles is a planar subdivision. For a planar subdivision,
// check_map() reports its regions. For any other list, check_map() reports all defects with their
// positions.
//
// Notation: a directed edge (half-edge) is a pair (u, v) of vertices. A listed cycle uses the
// directed edge from each of its corners to the next corner. The twin of (u, v) is (v, u). An
// undirected edge is a pair {u, v} such that a cycle uses (u, v) or (v, u). The id of a vertex or
// cycle is its 0-based index in the input.
//
// Main flow of check_map() (docs/maps.md defines every defect):
//  1. match_twins       sorts the half-edges into buckets by the lesser of their two vertex ids,
//                       and finds the duplicate, open and twin defects
//  2. find_contacts     makes one sweep over the undirected edges (docs/design/sweep.md). The sweep
//                         finds:
//                         - every pair of edges with a common point that is not a common vertex
//                         - the order of the edges around each vertex
//                         - for each component, the edge below its first vertex
//  3. classify_open     follows chains of open edges. An edge is open if a cycle uses one of its
//                       half-edges and no cycle uses the other. There are three kinds of chains. A
//                       chain bounds a gap between the listed faces, or it bounds an overlap of
//                       regions, or it is an outer boundary that is not listed.
//  4. trace_orbits      traces the boundaries of the faces of the induced graph, and finds the
//                       mixed faces. The induced graph is the planar graph of all undirected edges.
//                       At each vertex, the order of the edges around the vertex determines the
//                       next half-edge of a boundary. This step is taken only if steps 1 to 3 found
//                       no duplicate, open or crossing defect.
//  5. nest_components   finds the face that contains each component. Step 2 found the edge below
//                       the first vertex of the component. The component lies in the face above
//                       this edge.
//  6. settle_touching_rings  finds regions whose rings touch each other at vertices. The faces of
//                       these regions are not mixed. This step is taken only if step 4 found mixed
//                       faces.
//  7. describe_defects  describes the defects in a fixed order. A description has the exact point
//                       of the defect and a hint for the user. Some hints name the regions that
//                       overlap. To find these regions, the step computes the arrangement of all
//                       edges (check/map_claims.h).
//
// Cost: O((n + k) log n) time and O(n + d) memory for n corners, k crossings and d described
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
  /// If an outer boundary is not listed, its edges form a clockwise chain of open edges. Such a
  /// chain is added as an outer cycle, and a warning reports this. There is one exception: if a
  /// chain bounds an overlap of regions and no edges cross, the chain is not added. Its edges are
  /// reported as open.
  Infer,
  /// An open edge is not a defect. But if a component lies inside a listed face, the outer boundary
  /// of the component must be listed. If it is not listed, the component is a Nested defect.
  Ignore,
};

/// The verdict on a list of cycles (docs/maps.md). If there are several kinds of defects, the first
/// kind of defect in this list determines the verdict.
enum class MapVerdict {
  Valid,                  ///< There is no defect.
  NotAPlanarSubdivision,  ///< There are Duplicate defects.
  Open,                   ///< There are Open defects and no Duplicate defects.
  Superposed              ///< There are defects, but no Duplicate defects and no Open defects.
};

/// The kinds of defects (definitions: docs/maps.md).
enum class DefectKind {
  Duplicate,  ///< A directed edge is used more than once.
  Open,       ///< A cycle uses a directed edge, but no cycle uses its twin.
  Crossing,   ///< Two undirected edges have a common point that is not a common vertex.
  Twin,       ///< One cycle uses an edge in both directions.
  /// The boundary of a face of the induced graph does not consist of the listed cycles as required.
  /// The outer boundary of a bounded face must be one counter-clockwise listed cycle. There is one
  /// exception. The counter-clockwise cycle of a region may touch clockwise cycles of the same
  /// region at vertices. These clockwise cycles may also touch each other. The region can then fall
  /// into several faces, and the boundary of such a face may consist of parts of several of these
  /// cycles. The outer boundary of a component must consist of clockwise listed cycles only.
  Mixed,
  Nested  ///< A component lies in a listed face, but the component's outer boundary is not listed.
};

/// Options of check_map().
struct MapCheckOptions {
  OuterRule outer = OuterRule::Listed;  ///< The requirement on outer boundaries.
  /// Whether vertices with equal coordinates are merged before the check.
  bool merge_vertices = false;
  /// The largest number of defects that are described. Defects that are not described are counted,
  /// too.
  std::uint64_t max_defects = 1000;
  /// Whether hints name vertices by their coordinates instead of their numbers. Set this to true if
  /// the file from which the map was made does not number its vertices.
  bool name_places = false;
};

/// An edge, named by its end vertices.
struct MapEdge {
  std::uint32_t from;  ///< The first vertex.
  std::uint32_t to;    ///< The second vertex.
  friend bool operator==(const MapEdge&, const MapEdge&) = default;
};

/// One defect, with everything that a user needs to find and correct the defect.
struct MapDefect {
  DefectKind kind = DefectKind::Duplicate;  ///< The kind of defect.
  /// The ids of the listed cycles at which the defect occurs, in ascending order.
  std::vector<std::uint32_t> cycles;
  /// The edges at which the defect occurs. The edges of Crossing and Twin defects are undirected;
  /// the edges of all other defects are directed. A Mixed defect has one edge, which lies on the
  /// boundary of the face. A Nested defect has one edge, which lies on the boundary of the
  /// component.
  std::vector<MapEdge> edges;
  /// The exact position of the defect. For two edges that overlap, this is their first common
  /// point.
  std::optional<RationalPoint2> point;
  Point2 near{};     ///< The doubles nearest to the coordinates of `point`.
  std::string hint;  ///< A sentence that explains the defect and how to correct it.
};

/// The counts of all defects, including defects that are not described (definitions: docs/maps.md).
struct MapDefectCounts {
  std::uint64_t duplicate = 0;  ///< Repeated uses of a directed edge.
  std::uint64_t open = 0;       ///< Directed edges without a twin; 0 under OuterRule::Ignore.
  /// Pairs of undirected edges with a common point that is not a common vertex.
  std::uint64_t crossing = 0;
  std::uint64_t twin = 0;  ///< Undirected edges with both half-edges in one cycle.
  /// Mixed faces. This count has a value only if `duplicate`, `open` and `crossing` are all 0.
  std::optional<std::uint64_t> mixed;
  std::uint64_t nested = 0;  ///< Nested components; always 0 except under OuterRule::Ignore.
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

/// A region of the subdivision. The boundary of a region consists of at most one outer cycle, and
/// of clockwise cycles for the holes. If cycles touch each other or themselves at vertices, the
/// region may have several faces.
struct MapRegion {
  /// Id of the counter-clockwise cycle around the region. The unbounded region has no such cycle.
  std::optional<std::uint32_t> outer;
  /// Ids of the clockwise cycles that bound the holes of the region, in ascending order.
  std::vector<std::uint32_t> holes;
};

/// The result of check_map().
struct MapReport {
  MapVerdict verdict = MapVerdict::Valid;  ///< Whether the map is valid, or why not.
  std::size_t vertices = 0;                ///< Number of listed vertices.
  std::size_t edges = 0;                   ///< Number of undirected edges.
  std::size_t cycles = 0;                  ///< Number of cycles, including inferred cycles.
  std::size_t components = 0;              ///< Number of connected components of the edge graph.
  MapDefectCounts counts;                  ///< The counts of all defects.
  /// The described defects, at most max_defects. Defects are sorted by kind. Defects of the same
  /// kind are sorted by their position in the input.
  std::vector<MapDefect> defects;
  /// The warnings, sorted by kind. At most max_defects warnings of each kind are listed. If there
  /// are more warnings of a kind, one further warning states how many warnings of this kind are not
  /// listed. The kind InferredOuter has no such limit.
  std::vector<MapWarning> warnings;
  /// The regions. The unbounded region comes first. Only a map with the verdict Valid has regions.
  std::vector<MapRegion> regions;
  Map map;  ///< The checked map, after vertices were merged and outer cycles were added.
};

/// Checks a map. The returned report has the verdict. The report also has all regions of a valid
/// map, or the defects of any other map. Throws:
///   - Error{DegenerateFace} if two consecutive corners of a listed cycle are the same vertex, or
///     if a cycle has fewer than 3 corners. If vertices are merged, these conditions are checked
///     before and after merging.
///   - Error{BadIndex} if a corner is not the index of a vertex
///   - ResourceLimit if a limit of the Context is exceeded, and Cancelled if a stop is requested
/// The cost is stated at the head of this file.
MapReport check_map(Map map, const MapCheckOptions& options = {},
                    Context& context = unlimited_context());

/// Returns the half-edge structure of a valid map. The structure has one loop for each cycle of
/// report.map, and one face for each region, in the order of report.regions. Vertices that no cycle
/// uses are left out. Throws Error{BadArgument} if the verdict is not Valid. Also throws
/// Error{BadArgument} if a cycle uses a directed edge, but no cycle uses the twin of this edge. A
/// map that is valid under OuterRule::Ignore may have such edges.
DcelFromCycles to_dcel(const MapReport& report);

}  // namespace plumb
#pragma GCC visibility pop
