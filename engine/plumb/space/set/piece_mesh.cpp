// The mesh of the pieces of a boundary (piece_mesh.h). Tested by
// tests/space/mesh_with_attributes_test.cpp.
#include "plumb/space/set/piece_mesh.h"

#include <cstddef>
#include <vector>

#include "plumb/predicates/point3_signs.h"
#include "plumb/predicates/space/rounded_point3.h"

namespace plumb {
namespace {

/// Whether attributes do not change between two pieces. The pieces may lie in different planes.
bool have_same_constants(const CutBoundary& cut, const SourceTriangles& triangles, std::uint32_t p,
                         std::uint32_t q) {
  const std::uint32_t s = cut.pieces[p].triangle, t = cut.pieces[q].triangle;
  if (p == q) return true;
  return s == kNone || t == kNone ? s == t : triangles.has_same_constants(s, t);
}

/// Returns 1 for each vertex between pieces whose attributes differ.
std::vector<std::uint8_t> mixed_vertices(const CutBoundary& cut, const SourceTriangles& triangles,
                                         std::size_t vertices) {
  std::vector<std::uint32_t> piece_at(vertices, kNone);
  std::vector<std::uint8_t> is_mixed(vertices, 0);
  for (std::size_t f = 0; f < cut.piece.size(); ++f) {
    for (const VertexId v : cut.face(f)) {
      std::uint32_t& known = piece_at[v.value()];
      if (known == kNone) known = cut.piece[f];
      if (is_mixed[v.value()] != 0) continue;
      if (!have_same_constants(cut, triangles, known, cut.piece[f])) is_mixed[v.value()] = 1;
    }
  }
  return is_mixed;
}

}  // namespace

MeshToRound mesh_of_pieces(const CutBoundary& cut, const SourceTriangles& triangles,
                           const SpaceComplex& complex) {
  MeshToRound result{{}, {}, &complex, {}, true};
  PolygonMesh& mesh = result.made.mesh;
  const std::size_t vertices = complex.vertex_point.size();
  const std::vector<std::uint8_t> is_mixed = mixed_vertices(cut, triangles, vertices);
  std::vector<std::uint32_t> index(vertices, kNone);
  mesh.face_begin = cut.face_begin;
  mesh.corners.reserve(cut.corners.size());
  for (const VertexId v : cut.corners) {
    std::uint32_t& at = index[v.value()];
    if (at == kNone) {
      at = static_cast<std::uint32_t>(mesh.points.size());
      const RoundedPoint3 rounded_at = rounded(complex.points(), complex.vertex_point[v]);
      mesh.points.push_back(rounded_at.at);
      if (!rounded_at.is_exact) result.made.rounded.emplace_back(at, v);
      if (is_mixed[v.value()] != 0) result.kept.push_back(at);
    }
    mesh.corners.push_back(at);
  }
  std::vector<FacetId> facets;
  facets.reserve(cut.piece.size());
  result.made.facet.reserve(cut.piece.size());
  for (const std::uint32_t p : cut.piece) {
    facets.push_back(cut.pieces[p].facet);
    result.made.facet.push_back(FacetId(p));
  }
  result.solid = solids_at(complex, facets);
  return result;
}

}  // namespace plumb
