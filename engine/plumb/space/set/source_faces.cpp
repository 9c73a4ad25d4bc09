// Cuts the faces of sources into triangles, and finds the corner of the face at each corner of a
// triangle (mesh/face_corners.h).
//
// Tested by tests/space/mesh_with_attributes_test.cpp.
#include "plumb/space/set/source_faces.h"

#include <memory>
#include <span>
#include <utility>

#include "plumb/space/mesh/face_corners.h"
#include "plumb/space/mesh/mesh_facets.h"
#include "plumb/space/mesh/mesh_vertices.h"
#include "plumb/space/repair_mesh.h"

namespace plumb {
namespace {

/// Returns 1 for each face that is not planar or not simple.
std::vector<std::uint8_t> irregular_faces(const MeshReport& report, std::size_t faces) {
  std::vector<std::uint8_t> result(faces, 0);
  for (const auto* const list : {&report.not_planar, &report.not_simple}) {
    for (const std::uint32_t f : *list) result[f] = 1;
  }
  return result;
}

/// Returns a facet that is a triangle, in the direction of its face.
VertexTriangle triangle_of(const MeshFacets& facets, std::size_t f) {
  const auto c = facets.corners(f);
  if (facets.jump[f] > 0) return {c[0], c[2], c[1]};
  return {c[0], c[1], c[2]};
}

/// Triangulates faces, one after the other.
class FaceTriangles {
 public:
  FaceTriangles(const PolygonMesh& mesh, Context& context)
      : mesh_(mesh), cut_(triangulated(mesh, context)) {
    SpaceTables tables;
    MeshReport report;
    MeshVertices merged = merge_equal_points(mesh, tables);
    facets_ = flatten_mesh(mesh, merged, tables, report, context);
    vertices_ = std::move(merged.of_point);
    is_irregular_ = irregular_faces(report, mesh.face_count());
  }

  /// Appends the triangles of the next face, which has the index f.
  void add(std::uint32_t f, std::vector<FaceTriangle>& result) {
    const std::size_t size = mesh_.face(f).size();
    const std::size_t first = next_cut_, cuts = size <= 3 ? 1 : size - 2;
    next_cut_ += cuts;
    triangles_.clear();
    while (next_facet_ < facets_.size() && facets_.origin[next_facet_] < f) ++next_facet_;
    if (is_irregular_[f] != 0) {
      for (std::size_t i = next_facet_; i < facets_.size() && facets_.origin[i] == f; ++i) {
        if (facets_.corners(i).size() == 3) triangles_.push_back(triangle_of(facets_, i));
      }
    } else if (size >= 3) {
      for (std::size_t i = first; i < first + cuts; ++i) {
        const auto t = cut_.face(i);
        triangles_.push_back({vertices_[t[0]], vertices_[t[1]], vertices_[t[2]]});
      }
    }
    face_vertices_.clear();
    for (const std::uint32_t p : mesh_.face(f)) face_vertices_.push_back(vertices_[p]);
    CornerFinder(face_vertices_, mesh_.face_begin[f]).add(f, triangles_, result);
  }

 private:
  const PolygonMesh& mesh_;
  // The mesh with triangulated faces. Faces with two corners are kept.
  PolygonMesh cut_;
  // For each point, the common vertex of all points that are equal to it.
  std::vector<std::uint32_t> vertices_;
  MeshFacets facets_;
  std::vector<std::uint8_t> is_irregular_;
  std::size_t next_cut_ = 0;
  std::size_t next_facet_ = 0;
  std::vector<VertexTriangle> triangles_;
  std::vector<std::uint32_t> face_vertices_;
};

bool has_polygons(const PolygonMesh& mesh) {
  for (std::uint32_t f = 0; f < mesh.face_count(); ++f) {
    if (mesh.face(f).size() > 3) return true;
  }
  return false;
}

}  // namespace

std::vector<FaceTriangle> triangles_of_faces(const PolygonMesh& mesh, Context& context) {
  std::vector<FaceTriangle> result;
  result.reserve(mesh.corners.size() / 3);
  if (has_polygons(mesh)) {
    FaceTriangles faces(mesh, context);
    for (std::uint32_t f = 0; f < mesh.face_count(); ++f) faces.add(f, result);
    return result;
  }
  for (std::uint32_t f = 0; f < mesh.face_count(); ++f) {
    const std::uint32_t begin = mesh.face_begin[f];
    if (mesh.face(f).size() == 3) result.push_back({f, {begin, begin + 1, begin + 2}});
  }
  return result;
}

SourceTrianglesCache::Triangles triangles_of_source(const MeshSource& source, Context& context) {
  const bool is_kept = has_polygons(source.mesh);
  if (auto kept = is_kept ? source.triangles.get() : nullptr) return kept;
  auto triangles =
      std::make_shared<const std::vector<FaceTriangle>>(triangles_of_faces(source.mesh, context));
  if (is_kept) source.triangles.set(triangles);
  return triangles;
}

}  // namespace plumb
