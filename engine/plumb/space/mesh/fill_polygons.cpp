// Faces for holes, and triangles for faces.
//
// A hole need not be planar. Any choice of triangles closes it, because their boundary is always
// the chain. Triangles of least total area follow the surroundings; they are found by dynamic
// programming over parts of the chain (G. Barequet, M. Sharir, Filling gaps in the boundary of a
// polyhedron, Computer Aided Geometric Design 12, 1995). Areas are compared in doubles, because any
// choice is valid. Whether a chain is planar is decided exactly, so a hole in a plane becomes one
// face of that plane.
//
// A face is triangulated in the first view along an axis in which it is simple, because in such a
// view the triangles cover it once. Views are tried in the order of the projected area.
//
// Tested by tests/space/fill_polygons_test.cpp.

#include "plumb/space/mesh/fill_polygons.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "plumb/predicates/arithmetic/vectors.h"
#include "plumb/predicates/point3_signs.h"
#include "plumb/space/mesh/face_corners.h"
#include "plumb/space/mesh/mesh_facets.h"
#include "plumb/space/mesh/mesh_vertices.h"
#include "plumb/space/planar/facet_triangles.h"
#include "plumb/space/repair_mesh.h"

namespace plumb {
namespace {

constexpr std::size_t kMostTriangulated = 100;

using Vector3 = std::array<double, 3>;
using Chain = std::span<const std::uint32_t>;

Vector3 minus(const Point3& a, const Point3& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }

/// Whether all points of a chain lie in one plane.
bool is_planar(Chain chain, std::span<const SpacePoint> place, SpaceTables& tables) {
  OrientedPlane plane;
  for (std::size_t i = 2; i < chain.size() && !plane.is_valid(); ++i) {
    plane = plane_through(tables, place[chain[i - 2]], place[chain[i - 1]], place[chain[i]]);
  }
  return !plane.is_valid() || std::ranges::all_of(chain, [&](std::uint32_t v) {
    return side(tables.points, place[v], plane.plane()) == Sign::Zero;
  });
}

/// Finds the triangulation of least area.
class LeastArea {
 public:
  LeastArea(const PolygonMesh& mesh, Chain chain)
      : mesh_(mesh),
        chain_(chain),
        size_(chain.size()),
        area_(size_ * size_, 0.0),
        apex_(size_ * size_, 0) {}

  std::vector<IndexTriangle> run() {
    // The part from i to j is closed by the triangle i, m, j with the best m between them.
    for (std::size_t length = 2; length < size_; ++length) {
      for (std::size_t i = 0; i + length < size_; ++i) close(i, i + length);
    }
    std::vector<IndexTriangle> triangles;
    std::vector<std::pair<std::size_t, std::size_t>> parts{{0, size_ - 1}};
    while (!parts.empty()) {
      const auto [i, j] = parts.back();
      parts.pop_back();
      if (j - i < 2) continue;
      const std::size_t m = apex_[i * size_ + j];
      triangles.push_back({chain_[i], chain_[m], chain_[j]});
      parts.emplace_back(m, j);
      parts.emplace_back(i, m);
    }
    return triangles;
  }

 private:
  void close(std::size_t i, std::size_t j) {
    double best = std::numeric_limits<double>::infinity();
    std::size_t apex = i + 1;
    for (std::size_t m = i + 1; m < j; ++m) {
      const double sum = area_[i * size_ + m] + area_[m * size_ + j] + area(i, m, j);
      if (!(sum < best)) continue;
      best = sum;
      apex = m;
    }
    area_[i * size_ + j] = best;
    apex_[i * size_ + j] = apex;
  }

  double area(std::size_t i, std::size_t j, std::size_t k) const {
    const Point3 &a = mesh_.points[chain_[i]], &b = mesh_.points[chain_[j]],
                 &c = mesh_.points[chain_[k]];
    const Vector3 n = cross(minus(b, a), minus(c, a));
    return std::hypot(n[0], n[1], n[2]);
  }

  const PolygonMesh& mesh_;
  Chain chain_;
  std::size_t size_;
  std::vector<double> area_;  // The least area of each part.
  std::vector<std::size_t> apex_;
};

// ---------------------------------------------------------------- faces

/// Triangulates polygons one after the other.
class FaceCutter {
 public:
  FaceCutter(const PolygonMesh& mesh, const MeshVertices& vertices, const Point3Table& table,
             Context& context)
      : mesh_(mesh), vertices_(vertices), context_(context), flat_(table) {}

  /// Returns triangles of corners of the face: indices of points.
  std::span<const IndexTriangle> cut(Chain face) {
    triangles_.clear();
    list_corners(face);
    if (shown_.size() == face.size()) {  // Every corner is used once.
      for (const std::size_t axis : axes(face)) {
        if (cut_in({axis, false}) || cut_in({axis, true})) return triangles_;
      }
    }
    for (std::size_t i = 2; i < face.size(); ++i) {
      triangles_.push_back({face[0], face[i - 1], face[i]});
    }
    return triangles_;
  }

 private:
  /// Lists the points of the face, ascending, each once.
  void list_corners(Chain face) {
    shown_.assign(face.begin(), face.end());
    std::ranges::sort(shown_);
    shown_.erase(std::unique(shown_.begin(), shown_.end()), shown_.end());
    local_.clear();
    for (const std::uint32_t p : face) {
      const auto at = std::ranges::lower_bound(shown_, p);
      local_.push_back(static_cast<std::uint32_t>(at - shown_.begin()));
    }
  }

  /// Returns the axes in the order of the area in the view along them, the largest first.
  std::array<std::size_t, 3> axes(Chain face) const {
    Vector3 sum{};
    const Point3& o = mesh_.points[face[0]];
    for (std::size_t i = 2; i < face.size(); ++i) {
      const Vector3 n = cross(minus(mesh_.points[face[i - 1]], o), minus(mesh_.points[face[i]], o));
      for (std::size_t k = 0; k < 3; ++k) sum[k] += n[k];
    }
    std::array<std::size_t, 3> order{0, 1, 2};
    std::ranges::stable_sort(
        order, [&](std::size_t i, std::size_t j) { return std::fabs(sum[i]) > std::fabs(sum[j]); });
    return order;
  }

  /// Triangulates the face in a view in which it is simple and counter-clockwise.
  bool cut_in(FlatView view) {
    flat_.reset(view);
    for (const std::uint32_t p : shown_) flat_.push_back(vertices_.point[vertices_.of_point[p]]);
    if (!is_injective() || shape_of(flat_, local_, context_) != PolygonShape::Simple) return false;
    const std::vector<IndexEdge> edges = boundary_of(local_);
    if (!triangulate(flat_, edges, triangles_)) {
      triangles_.clear();
      return false;
    }
    make_delaunay(flat_, edges, triangles_);
    for (IndexTriangle& t : triangles_) t = {shown_[t[0]], shown_[t[1]], shown_[t[2]]};
    return true;
  }

  /// Whether no two corners coincide in the view, as shape_of() requires.
  bool is_injective() {
    order_.resize(shown_.size());
    std::iota(order_.begin(), order_.end(), 0U);
    std::ranges::sort(order_, [&](std::uint32_t i, std::uint32_t j) {
      return flat_.compare(i, j) == Sign::Negative;
    });
    return std::ranges::adjacent_find(order_, [&](std::uint32_t i, std::uint32_t j) {
             return flat_.compare(i, j) == Sign::Zero;
           }) == order_.end();
  }

  const PolygonMesh& mesh_;
  const MeshVertices& vertices_;
  Context& context_;
  FlatPoints flat_;
  std::vector<std::uint32_t> shown_;  // For each entry of flat_, its point.
  std::vector<std::uint32_t> local_;  // For each corner, its entry of flat_.
  std::vector<std::uint32_t> order_;
  std::vector<IndexTriangle> triangles_;
};

}  // namespace

std::uint32_t fill_hole(PolygonMesh& mesh, Chain chain, std::span<const SpacePoint> place,
                        SpaceTables& tables) {
  if (chain.size() == 3 || chain.size() > kMostTriangulated || is_planar(chain, place, tables)) {
    mesh.add_face(chain);
    return 1;
  }
  const std::vector<IndexTriangle> triangles = LeastArea(mesh, chain).run();
  for (const IndexTriangle& t : triangles) mesh.add_face(t);
  return static_cast<std::uint32_t>(triangles.size());
}

PolygonMesh triangulated(const PolygonMesh& mesh, Context& context) {
  PolygonMesh result;
  result.points = mesh.points;
  result.exact = mesh.exact;
  SpaceTables tables;
  const MeshVertices vertices = merge_equal_points(mesh, tables);
  FaceCutter cutter(mesh, vertices, tables.points, context);
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    if (f % 4096 == 0) context.checkpoint("triangles of faces", f, mesh.face_count());
    const auto face = mesh.face(f);
    if (face.size() <= 3) {
      result.add_face(face);
      continue;
    }
    for (const IndexTriangle& t : cutter.cut(face)) result.add_face(t);
  }
  return result;
}

PolygonMesh triangulated(const PolygonMesh& mesh, MeshAttributes& attributes, Context& context) {
  require_sizes(attributes, mesh.face_count(), mesh.corners.size());
  PolygonMesh result = triangulated(mesh, context);
  if (attributes.empty()) return result;
  SpaceTables tables;
  const std::vector<std::uint32_t> vertex = merge_equal_points(mesh, tables).of_point;
  FaceOrigins origins;
  origins.is_reversed.assign(result.face_count(), 0);
  std::vector<std::uint32_t> vertices;
  std::vector<VertexTriangle> triangles;
  std::vector<FaceTriangle> found;
  for (std::uint32_t f = 0, next = 0; f < mesh.face_count(); ++f) {
    if (f % 4096 == 0) context.checkpoint("triangles of faces", f, mesh.face_count());
    const auto face = mesh.face(f);
    const std::size_t count = face.size() <= 3 ? 1 : face.size() - 2;
    origins.face.insert(origins.face.end(), count, f);
    if (face.size() <= 3) {
      for (std::uint32_t c = mesh.face_begin[f]; c < mesh.face_begin[f + 1]; ++c) {
        origins.corner.push_back(c);
      }
      ++next;
      continue;
    }
    vertices.clear();
    for (const std::uint32_t p : face) vertices.push_back(vertex[p]);
    triangles.clear();
    for (std::size_t i = 0; i < count; ++i, ++next) {
      const auto t = result.face(next);
      triangles.push_back({vertex[t[0]], vertex[t[1]], vertex[t[2]]});
    }
    found.clear();
    CornerFinder(vertices, mesh.face_begin[f]).add(f, triangles, found);
    for (const FaceTriangle& t : found) {
      origins.corner.insert(origins.corner.end(), t.corner.begin(), t.corner.end());
    }
  }
  attributes = carried(attributes, result, origins);
  return result;
}

}  // namespace plumb
