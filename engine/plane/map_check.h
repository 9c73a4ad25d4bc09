// Is a list of regions a planar subdivision? All defects, with places; or the regions.
//
// Notation: a listed cycle c uses the directed edges ("half-edges") between its consecutive
// corners; half-edge h is the h-th corner of the listing. twin(u,v) = (v,u). An undirected edge
// is a pair {u,v} used in at least one direction. Ids are positions in the input, 0-based.
//
// Main flow of check_map (source: note dcel.pt.txt, with exact and near-linear means):
//  1. match_twins         bucket the half-edges by their lesser vertex: duplicates, open, twin
//  2. classify_open       chains of open edges: a gap in the coverage, or a missing outer boundary
//  3. find_contacts       one sweep over the undirected edges: every pair that meets anywhere but at
//                         a common vertex, the order of edges around each vertex, and for the first
//                         vertex of each component the edge below it
//  4. trace_orbits        faces of the induced planar graph (only when 1 to 3 found nothing): orbits
//                         of next-around-vertex; those mixed of several cycles
//  5. nest_components     each component hangs in the face of the edge below its first vertex
//  6. describe_defects    in a fixed order, exact points, hints
//
// Cost: O((n + k) log n) time for n corners and k crossings, O(n + defects kept) memory.
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

/// What is demanded of outer boundaries.
enum class OuterRule {
  Listed,  ///< the outer boundary of every component must be listed, clockwise
  Infer,   ///< chains of open edges become the missing outer cycles, and are noted
  Ignore,  ///< border edges are no defect; a component inside a face is one (kind Nested)
};

/// What a list of cycles is: the first that holds of its defects (docs/maps.md).
enum class MapVerdict { Valid, NotAPlanarSubdivision, Open, Superposed };

/// What can be wrong (definitions: docs/maps.md).
enum class DefectKind { Duplicate, Open, Crossing, Twin, Mixed, Nested };

/// How a map is judged.
struct MapCheckOptions {
  OuterRule outer = OuterRule::Listed;  ///< what is demanded of outer boundaries
  bool merge_vertices = false;          ///< vertices with equal coordinates become one first
  std::uint64_t max_defects = 1000;     ///< how many to describe; counts are always complete
};

/// An edge by its ends.
struct MapEdge {
  std::uint32_t from;  ///< vertex
  std::uint32_t to;    ///< vertex
  friend bool operator==(const MapEdge&, const MapEdge&) = default;
};

/// One defect, with everything a person needs to find and mend it.
struct MapDefect {
  DefectKind kind = DefectKind::Duplicate;  ///< what it is
  std::vector<std::uint32_t> cycles;        ///< listed cycles concerned, ascending
  std::vector<MapEdge> edges;           ///< Duplicate, Open: directed; Crossing, Twin: undirected
  std::optional<RationalPoint2> point;  ///< where exactly; the first point of an overlap
  Point2 near{};                        ///< nearest doubles of that point
  std::string hint;                     ///< what it is and what to do, one sentence
};

/// Numbers of *all* defects, however many are described (definitions: docs/maps.md).
struct MapDefectCounts {
  std::uint64_t duplicate = 0;  ///< extra uses of a directed edge
  std::uint64_t open = 0;       ///< directed edges without a twin (border edges under Ignore: 0)
  std::uint64_t crossing = 0;   ///< pairs of undirected edges meeting elsewhere than at a vertex
  std::uint64_t twin = 0;       ///< undirected edges with both half-edges in one cycle
  std::optional<std::uint64_t> mixed;  ///< none unless duplicate = open = crossing = 0
  std::uint64_t nested = 0;            ///< only under OuterRule::Ignore
};

/// What is odd but no defect.
enum class WarningKind { Pinch, IsolatedVertex, InferredOuter, MergedVertex };

/// Something odd that is no defect.
struct MapWarning {
  WarningKind kind;          ///< what it is
  std::uint32_t vertex = 0;  ///< or a cycle, for InferredOuter
  std::string text;          ///< one sentence
};

/// A face of the subdivision: one outer cycle (none for the unbounded face) and its holes.
struct MapRegion {
  std::optional<std::uint32_t> outer;  ///< listed cycle
  std::vector<std::uint32_t> holes;    ///< listed clockwise cycles lying in it, ascending
};

/// All that check_map() found.
struct MapReport {
  MapVerdict verdict = MapVerdict::Valid;  ///< the answer
  std::size_t vertices = 0;                ///< as listed
  std::size_t edges = 0;                   ///< undirected
  std::size_t cycles = 0;                  ///< as listed (inferred ones included)
  std::size_t components = 0;              ///< connected parts of the edge graph
  MapDefectCounts counts;                  ///< of all defects
  std::vector<MapDefect> defects;    ///< at most max_defects, by kind, then by place in the input
  std::vector<MapWarning> warnings;  ///< in the order of their places
  std::vector<MapRegion> regions;    ///< only when valid; the unbounded region first
  Map map;                           ///< the map that was judged (merged, outer cycles added)
};

/// Judges `map`. Requires at least 3 corners a cycle, no repeated consecutive corner, indices in
/// range (the reader sees to that; violations throw Error{BadIndex or DegenerateFace}).
MapReport check_map(Map map, const MapCheckOptions& options, Context& context);

/// The half-edge structure of a valid map: one loop per listed cycle, one face per region (in the
/// order of report.regions). Vertices of no cycle are not in it. Throws Error{BadArgument} unless
/// the verdict is Valid and no border is open (OuterRule::Ignore may leave some).
DcelFromCycles to_dcel(const MapReport& report);

}  // namespace plumb
#pragma GCC visibility pop
