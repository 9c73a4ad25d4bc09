// The data of cut_boundary(): pieces, regions of facets, and vertices on edges. Internal.
//
// A region is a part of a facet that is triangulated separately. Invariant: a region without an
// outline is a whole facet. The vertices inside of edges are collected while planes are cut, and
// sorted before regions become faces; so all facets at an edge get the same vertices.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "plumb/base/context.h"
#include "plumb/predicates/sign.h"
#include "plumb/space/mesh_with_attributes.h"
#include "plumb/space/set/cut_boundary.h"
#include "plumb/space/set/growing_complex.h"
#include "plumb/space/set/source_triangles.h"
#include "plumb/space/space_complex.h"

namespace plumb {

/// An edge of the boundary of a region, with the region on its left, seen from the positive side.
struct RegionEdge {
  VertexId from;
  VertexId to;
  EdgeId edge;  // The edge of the complex that contains it, or an invalid id for a cut.
};

/// The outline of a region.
struct Outline {
  std::vector<RegionEdge> edges;
  std::vector<VertexId> inner;  // The vertices inside.
};

/// A part of a facet that is triangulated separately.
struct Region {
  std::uint32_t piece;
  bool is_reversed;  // Whether the outside is on the negative side of the plane.
  PlaneId plane;
  // The index of the outline in CutState::outlines, or kNone for a whole facet.
  std::uint32_t outline;
};

/// Calls visit(u) for each use of the boundary of a facet.
template <class Visit>
void for_each_use(const SpaceComplex& c, FacetId f, const Visit& visit) {
  for (const UseId first : c.cycles_of(f)) {
    UseId u = first;
    do {
      visit(u);
      u = c.use_next[u];
    } while (u != first);
  }
}

/// The vertices that cuts have made inside of edges of the complex.
class EdgeCuts {
 public:
  explicit EdgeCuts(const GrowingComplex& complex) : complex_(complex) {}

  void add(EdgeId e, VertexId v) { cuts_.emplace_back(e, v); }
  bool is_empty() const { return cuts_.empty(); }
  /// Sorts the vertices along their edges, and merges equal ones.
  void sort();
  /// Returns the vertex into which a vertex was merged.
  VertexId merged(VertexId v) const;
  /// Whether an edge has vertices inside.
  bool has(EdgeId e) const;
  /// Appends the vertices between two points of an edge, in their order from the first one.
  void append_between(const RegionEdge& part, std::vector<VertexId>& vertices) const;

 private:
  using Cut = std::pair<EdgeId, VertexId>;

  Sign compare(VertexId v, VertexId w) const;
  std::pair<std::vector<Cut>::const_iterator, std::vector<Cut>::const_iterator> of(EdgeId e) const;

  const GrowingComplex& complex_;
  std::vector<Cut> cuts_;
  std::vector<std::pair<VertexId, VertexId>> merged_;
};

/// The data that cutting the facets of a plane reads and changes.
struct CutState {
  GrowingComplex& growing;
  SourceTriangles& sources;
  const AttributeOptions& options;
  Context& context;
  std::vector<BoundaryPiece> pieces;
  std::vector<Region> regions;
  std::vector<Outline> outlines;  // The outlines of the regions that are not whole facets.
  EdgeCuts edge_cuts;

  const SpaceComplex& complex() const { return growing.get(); }
  const SpaceTables& tables() const { return growing.tables(); }
  void add_region(std::uint32_t piece, bool is_reversed, PlaneId plane, Outline outline) {
    regions.push_back({piece, is_reversed, plane, static_cast<std::uint32_t>(outlines.size())});
    outlines.push_back(std::move(outline));
  }
  Outline& outline_of_region(std::uint32_t region) { return outlines[regions[region].outline]; }
};

/// Whether the source of a triangle has channels.
bool has_channels(const CutState& state, const SourceTriangle& t);

}  // namespace plumb
