// The different points of polygons, and where they lie along edges.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "plumb/base/context.h"
#include "plumb/surface/cells/surface_arrangement.h"

namespace plumb {

/// Nodes of input points: those on edges first, by edge and t; then vertices, then points in faces.
struct SurfaceNodes {
  std::vector<SurfacePointId> point;      ///< per node
  std::vector<NodeId> of_entry;           ///< per entry of the polygons
  std::vector<EdgeId> edges;              ///< those with nodes inside, ascending
  std::vector<std::uint32_t> edge_begin;  ///< per such edge and one more: its nodes, ascending by t
  std::vector<std::uint32_t> slot_of_edge;  ///< per mesh edge: index into edges, or kNone
  std::uint32_t vertices_begin = 0;
  std::uint32_t faces_begin = 0;
  std::vector<NodeId> of_vertex;  ///< per mesh vertex

  std::uint32_t count_on(EdgeId e) const {
    const std::uint32_t slot = slot_of_edge[e.value()];
    return slot == SurfaceArrangement::kNone ? 0 : edge_begin[slot + 1] - edge_begin[slot];
  }
  /// The first node inside an edge with count_on() > 0; the others follow it.
  std::uint32_t first_on(EdgeId e) const { return edge_begin[slot_of_edge[e.value()]]; }
};

/// Expected O(n log n) for n entries, and O(mesh) to set up.
SurfaceNodes make_nodes(const SurfacePolygons& polygons, Context& context);

}  // namespace plumb
