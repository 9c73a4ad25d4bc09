// Cuts the faces of sources into triangles, and finds the corner of the face at each corner of a
// triangle.
//
// Triangles are made of vertices. A polygon that touches itself, as one with a hole and a bridge to
// it does, has several corners at one vertex, which may have different numbers. Around such a
// vertex, the triangles between the two edges of a corner belong to this corner. So each corner
// walks over the triangles from the edge that leaves it to the edge that ends at it. If a polygon
// is cut without one of these edges, as along a bridge, the corners there have the same vertex on
// both sides, and the first one stands for all.
//
// Tested by tests/space/mesh_with_attributes_test.cpp.
#include "plumb/space/set/source_faces.h"

#include <algorithm>
#include <span>
#include <utility>

#include "plumb/space/mesh/mesh_facets.h"
#include "plumb/space/mesh/mesh_vertices.h"
#include "plumb/space/repair_mesh.h"

namespace plumb {
namespace {

/// A triangle of vertices.
using VertexTriangle = std::array<std::uint32_t, 3>;

/// Finds the corners of one face at the corners of its triangles.
class CornerFinder {
 public:
  /// `vertices` has the vertex of each corner of the face, whose first corner has the index `begin`
  /// in the mesh.
  CornerFinder(std::span<const std::uint32_t> vertices, std::uint32_t begin)
      : vertices_(vertices), begin_(begin) {
    for (std::uint32_t i = 0; i < vertices.size(); ++i) first_.emplace_back(vertices[i], i);
    std::sort(first_.begin(), first_.end());
    const auto is_same = [](const auto& a, const auto& b) { return a.first == b.first; };
    has_repeats_ = std::adjacent_find(first_.begin(), first_.end(), is_same) != first_.end();
  }

  /// Appends the triangles with their corners.
  void add(std::uint32_t face, std::span<const VertexTriangle> triangles,
           std::vector<FaceTriangle>& result) {
    const std::size_t first = result.size();
    for (const VertexTriangle& t : triangles) {
      result.push_back({face, {first_at(t[0]), first_at(t[1]), first_at(t[2])}});
    }
    if (has_repeats_) choose_corners(triangles, std::span(result).subspan(first));
  }

 private:
  /// A directed edge, and the corner of a triangle that it leaves.
  struct Leaving {
    std::array<std::uint32_t, 2> edge;
    std::uint32_t corner;  // 3 t + i for corner i of triangle t.
  };

  std::uint32_t first_at(std::uint32_t vertex) const {
    const auto at = std::partition_point(first_.begin(), first_.end(),
                                         [&](const auto& f) { return f.first < vertex; });
    return begin_ + at->second;
  }

  /// Gives each corner the triangles between its edges.
  void choose_corners(std::span<const VertexTriangle> triangles, std::span<FaceTriangle> result) {
    std::vector<Leaving> leaving;
    for (std::uint32_t t = 0; t < triangles.size(); ++t) {
      for (std::uint32_t i = 0; i < 3; ++i) {
        leaving.push_back({{triangles[t][i], triangles[t][(i + 1) % 3]}, 3 * t + i});
      }
    }
    std::sort(leaving.begin(), leaving.end(),
              [](const Leaving& a, const Leaving& b) { return a.edge < b.edge; });
    std::vector<std::uint8_t> is_chosen(leaving.size(), 0);
    const std::size_t n = vertices_.size();
    for (std::uint32_t c = 0; c < n; ++c) {
      const std::uint32_t at = vertices_[c], last = vertices_[(c + n - 1) % n];
      std::uint32_t next = vertices_[(c + 1) % n];
      while (next != last) {
        const std::array edge{at, next};
        const auto found = std::partition_point(leaving.begin(), leaving.end(),
                                                [&](const Leaving& l) { return l.edge < edge; });
        if (found == leaving.end() || found->edge != edge) break;
        if (std::exchange(is_chosen[found->corner], std::uint8_t{1}) != 0) break;
        result[found->corner / 3].corner[found->corner % 3] = begin_ + c;
        next = triangles[found->corner / 3][(found->corner + 2) % 3];
      }
    }
  }

  std::span<const std::uint32_t> vertices_;
  std::uint32_t begin_;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> first_;  // Vertices with their corners.
  bool has_repeats_ = false;
};

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

/// Cuts faces, one after the other.
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
  PolygonMesh cut_;                      // The mesh in triangles; faces of two corners stay.
  std::vector<std::uint32_t> vertices_;  // For each point, the vertex that equal points share.
  MeshFacets facets_;
  std::vector<std::uint8_t> is_irregular_;
  std::size_t next_cut_ = 0;
  std::size_t next_facet_ = 0;
  std::vector<VertexTriangle> triangles_;
  std::vector<std::uint32_t> face_vertices_;
};

}  // namespace

std::vector<FaceTriangle> triangles_of_faces(const PolygonMesh& mesh, Context& context) {
  std::vector<FaceTriangle> result;
  result.reserve(mesh.corners.size() / 3);
  bool has_polygons = false;
  for (std::uint32_t f = 0; f < mesh.face_count(); ++f) {
    has_polygons = has_polygons || mesh.face(f).size() > 3;
  }
  if (has_polygons) {
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

}  // namespace plumb
