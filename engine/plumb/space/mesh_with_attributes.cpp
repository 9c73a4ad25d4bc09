// Makes the mesh of the pieces of a boundary, rounds it, and computes the attributes of its faces.
//
// The pieces come from cut_boundary(). Their mesh is rounded and repaired like every valid mesh.
// Its faces keep the indices of their pieces meanwhile; so each face of the result knows its piece,
// and from this its source, even if a repair has moved or divided it. The numbers at corners are
// filled in at the end (set/corner_values.h), when the points are known.
//
// Tested by tests/space/mesh_with_attributes_test.cpp.
#include "plumb/space/mesh_with_attributes.h"

#include <algorithm>
#include <numeric>
#include <span>
#include <utility>

#include "plumb/predicates/error.h"
#include "plumb/space/boolean/frame.h"
#include "plumb/space/mesh/closure_report.h"
#include "plumb/space/set/corner_values.h"
#include "plumb/space/set/cut_boundary.h"
#include "plumb/space/set/piece_mesh.h"
#include "plumb/space/set/round_mesh.h"
#include "plumb/space/set/source_triangles.h"

namespace plumb {
namespace {

// ---------------------------------------------------------------- the mesh

/// Throws unless the closure of the interior is bounded.
void require_bounded(const SpaceComplex& complex) {
  const std::vector<std::uint8_t> is_far = unbounded_volumes(complex);
  for (std::size_t v = 0; v < complex.volume_count(); ++v) {
    if (is_far[v] != 0 && complex.volume_mark[v] == 1) {
      throw Error(ErrorCode::BadArgument, "an unbounded set has no mesh");
    }
  }
}

/// Sorts faces by their sources, and fills the array of runs.
void sort_by_source(std::size_t sources, std::vector<std::uint32_t>& piece,
                    MeshWithAttributes& result, const std::vector<FaceSource>& source_of_piece) {
  PolygonMesh& mesh = result.mesh;
  const auto run_of = [&](std::size_t f) {
    return std::min<std::size_t>(source_of_piece[piece[f]].source, sources);
  };
  result.run_begin.assign(sources + 2, 0);
  for (std::size_t f = 0; f < piece.size(); ++f) ++result.run_begin[run_of(f) + 1];
  std::partial_sum(result.run_begin.begin(), result.run_begin.end(), result.run_begin.begin());
  result.source.reserve(piece.size());
  const auto run_is_less = [&](std::uint32_t f, std::uint32_t g) {
    return source_of_piece[f].source < source_of_piece[g].source;
  };
  if (!std::is_sorted(piece.begin(), piece.end(), run_is_less)) {
    std::vector<std::uint32_t> next(result.run_begin.begin(), result.run_begin.end() - 1);
    std::vector<std::uint32_t> order(piece.size());
    for (std::uint32_t f = 0; f < order.size(); ++f) order[next[run_of(f)]++] = f;
    PolygonMesh sorted;
    sorted.points = std::move(mesh.points);
    sorted.corners.reserve(mesh.corners.size());
    sorted.face_begin.reserve(mesh.face_begin.size());
    std::vector<std::uint32_t> sorted_piece;
    sorted_piece.reserve(piece.size());
    for (const std::uint32_t f : order) {
      sorted.add_face(mesh.face(f));
      sorted_piece.push_back(piece[f]);
    }
    mesh = std::move(sorted);
    piece = std::move(sorted_piece);
  }
  for (const std::uint32_t p : piece) result.source.push_back(source_of_piece[p]);
}

// ---------------------------------------------------------------- attributes of faces

/// Appends the materials and groups of all sources, and those of each face.
void fill_faces(std::span<const PlacedSource> sources, MeshWithAttributes& result) {
  MeshAttributes& to = result.attributes;
  bool has_material = false, has_group = false, has_id = false;
  std::vector<std::uint32_t> first_material, first_group;
  for (const PlacedSource& placed : sources) {
    const MeshAttributes& from = placed.source->attributes;
    first_material.push_back(static_cast<std::uint32_t>(to.materials.size()));
    first_group.push_back(static_cast<std::uint32_t>(to.groups.size()));
    to.materials.insert(to.materials.end(), from.materials.begin(), from.materials.end());
    to.groups.insert(to.groups.end(), from.groups.begin(), from.groups.end());
    has_material = has_material || !from.face_material.empty();
    has_group = has_group || !from.face_group.empty();
    has_id = has_id || !from.face_id.empty();
  }
  const auto value_at = [](const std::vector<std::uint32_t>& of_face, std::uint32_t face,
                           std::uint32_t first) {
    if (of_face.empty() || of_face[face] == MeshAttributes::kNone) return MeshAttributes::kNone;
    return of_face[face] + first;
  };
  for (const FaceSource& face : result.source) {
    static const MeshAttributes kNothing;
    const bool has_source = face.source != FaceSource::kNone;
    const MeshAttributes& from = has_source ? sources[face.source].source->attributes : kNothing;
    const std::uint32_t material = has_source ? first_material[face.source] : 0;
    const std::uint32_t group = has_source ? first_group[face.source] : 0;
    if (has_material) to.face_material.push_back(value_at(from.face_material, face.face, material));
    if (has_group) to.face_group.push_back(value_at(from.face_group, face.face, group));
    if (has_id) to.face_id.push_back(value_at(from.face_id, face.face, 0));
  }
}

std::vector<FaceSource> sources_of(const CutBoundary& cut, const SourceTriangles& triangles) {
  std::vector<FaceSource> sources;
  sources.reserve(cut.pieces.size());
  for (const BoundaryPiece& piece : cut.pieces) {
    FaceSource source;
    if (piece.triangle != kNone) {
      const SourceTriangle& triangle = triangles[piece.triangle];
      source = {triangle.source, triangle.face, piece.is_flipped};
    }
    sources.push_back(source);
  }
  return sources;
}

}  // namespace

MeshWithAttributes mesh_with_attributes(const Nef3& set, const AttributeOptions& options,
                                        Context& context) {
  require_bounded(set.complex());
  MemoryCharge memory(context);
  memory.add(2 * set.bytes(), "a set with attributes");
  constexpr std::uint64_t kPlaceBytes = 64, kCornerBytes = 64;
  for (const PlacedSource& placed : set.sources()) {
    const PolygonMesh& mesh = placed.source->mesh;
    memory.add(kPlaceBytes * mesh.points.size() + kCornerBytes * mesh.corners.size(),
               "the sources of a set");
  }
  AttributeOptions used = options;
  if (options.type == CoordinateType::Float) used.faces = MeshFaces::Triangles;
  GrowingComplex complex(set.complex());
  SourceTriangles triangles(set.sources(), complex, context);
  const CutBoundary cut = cut_boundary(complex, triangles, used, context);

  MeshToRound input = mesh_of_pieces(cut, triangles, complex.get());
  PlacesBeforeRounding places(input, used.type);
  ValidMesh valid = round_mesh(std::move(input), {.faces = used.faces}, used.type, context);

  MeshWithAttributes result;
  result.mesh = std::move(valid.made.mesh);
  result.repair = valid.repair;
  result.report = closure_report(set.complex());
  std::vector<std::uint32_t> piece;
  for (const FacetId id : valid.made.facet) piece.push_back(id.value());
  sort_by_source(set.sources().size(), piece, result, sources_of(cut, triangles));
  fill_faces(set.sources(), result);
  fill_channels({cut, complex, triangles, places, used.type}, piece, result, context);
  return result;
}

}  // namespace plumb
