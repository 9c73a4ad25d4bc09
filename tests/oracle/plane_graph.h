// The complex that cells and their marks amount to, and how it differs from the engine's: the twin
// of PlaneComplex, element by element.
//
// Cells that are not needed melt into what lies around them. Which are needed:
//   minimal_graph       an edge whose mark differs from a face beside it; a vertex around which not
//                       everything is alike, nor just one straight edge passes
//   arrangement_graph   an edge some curve runs along; a vertex that is an end of a curve,
//                       isolated, or where curves of two directions meet
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "generate/curve_scenes.h"
#include "oracle/plane_set.h"
#include "plumb/plane/plane_complex.h"

namespace plumb::testing {

struct PlaneGraph {
  static constexpr std::size_t kNone = static_cast<std::size_t>(-1);

  struct Vertex {
    ExactPoint point;
    bool mark = false;
    std::size_t face = kNone;  ///< of an isolated vertex
  };
  struct Edge {
    std::size_t from = kNone;  ///< the lexicographically lesser end; kNone: at infinity
    std::size_t to = kNone;
    CellLine line;  ///< runs from -> to
    bool mark = false;
    std::size_t left = kNone;
    std::size_t right = kNone;
    std::size_t cell = kNone;  ///< one of its cells
  };
  struct Face {
    bool mark = false;
    bool unbounded = false;
  };
  /// What a cell is part of.
  struct Element {
    int dimension = 2;
    std::size_t index = 0;
    friend bool operator==(const Element&, const Element&) = default;
  };

  std::vector<Vertex> vertices;  ///< in lexicographic order
  std::vector<Edge> edges;
  std::vector<Face> faces;
  std::vector<Element> element_of;  ///< per cell
};

PlaneGraph minimal_graph(const LineCells& cells, const CellMarks& marks);

/// `cells` must be those of lines_of(scene).
PlaneGraph arrangement_graph(const LineCells& cells, const CurveScene& scene);
std::vector<CellLine> lines_of(const CurveScene& scene);

/// Which element of the engine's complex each element of a graph is.
struct GraphMatch {
  std::string difference;  ///< empty: they are the same, and the rest is valid
  std::vector<VertexId> vertex;
  std::vector<EdgeId> edge;
  std::vector<FaceId> face;
};

/// Compares geometry, incidences and marks, and checks the numbering that plane_complex.h promises.
GraphMatch match(const PlaneComplex& complex, const PlaneGraph& graph, const LineCells& cells);

}  // namespace plumb::testing
