// The complex that cells and their marks amount to, and how it differs from the engine's: the twin
// of SpaceComplex, element by element.
//
// Near a point a set looks like a cone, its pyramid. The pyramid of every point of a cell is made
// of the cells around it, and invariant
//   along everything             if all cells around are marked alike,
//   along a plane through it     if the marks depend only on the side of that plane,
//   along a line through it      if the marks depend only on the sides of the planes through that
//   line.
// Vertices, edges, facets and volumes are the connected parts of the places where the greatest such
// dimension is 0, 1, 2, 3: a matter of the set alone.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "oracle/space_set.h"
#include "plumb/space/space_complex.h"

namespace plumb::testing {

struct SpaceGraph {
  static constexpr std::size_t kNone = static_cast<std::size_t>(-1);

  struct Vertex {
    ExactPoint3 point;
    bool mark = false;
    std::size_t cell = kNone;
    std::size_t facet = kNone;   ///< that it lies inside of: a disk around it, without edges
    std::size_t volume = kNone;  ///< that it lies in, alone
  };
  struct Edge {
    CellLine3 line;            ///< undirected
    std::size_t from = kNone;  ///< the vertex where it starts along the line; kNone: at infinity
    std::size_t to = kNone;
    bool mark = false;
    std::size_t cell = kNone;    ///< one of its cells
    std::size_t volume = kNone;  ///< of an edge without facets
  };
  struct Facet {
    std::size_t plane = kNone;  ///< of the cells
    bool mark = false;
    bool unbounded = false;
    std::array<std::size_t, 2> volume{kNone, kNone};  ///< on the positive and negative side
  };
  struct Volume {
    bool mark = false;
    bool unbounded = false;
  };
  /// What a cell is part of.
  struct Element {
    int dimension = 3;
    std::size_t index = 0;
    friend bool operator==(const Element&, const Element&) = default;
  };

  std::vector<Vertex> vertices;  ///< in lexicographic order
  std::vector<Edge> edges;
  std::vector<Facet> facets;
  std::vector<Volume> volumes;
  std::vector<Element> element_of;  ///< per cell

  bool has_unbounded_facets_or_edges() const;
};

SpaceGraph minimal_graph(const SpaceCells& cells, const CellMarks& marks);

/// Which element of the engine's complex each element of a graph is.
struct SpaceMatch {
  std::string difference;  ///< empty: they are the same, and the rest is valid
  std::vector<VertexId> vertex;
  std::vector<EdgeId> edge;
  std::vector<FacetId> facet;
  std::vector<VolumeId> volume;

  SpaceItem item(const SpaceGraph::Element& element) const;
};

/// Compares geometry, incidences and marks. Items of the engine's frame (marked kBeyond) are
/// skipped; there must be some exactly when a facet or an edge of the graph is unbounded.
SpaceMatch match(const SpaceComplex& complex, const SpaceGraph& graph, const SpaceCells& cells);

}  // namespace plumb::testing
