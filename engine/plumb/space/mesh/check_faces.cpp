// Finds the defects of faces that rounding may have damaged.
//
// The faces are read again as a mesh of their own, with rounded coordinates, and complex_of_mesh()
// reports its defects. Merged vertices are counted against those that coincided before. A face is
// flipped if the scalar product of its area vectors before and after rounding is negative.
//
// Tested by tests/space/rounded_mesh_test.cpp.
#include "plumb/space/mesh/check_faces.h"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "plumb/predicates/arithmetic/vectors.h"
#include "plumb/predicates/rounding.h"
#include "plumb/space/from_mesh.h"
#include "plumb/space/mesh/mesh_vertices.h"

namespace plumb {
namespace {

/// Checks one mesh.
class FaceCheck {
 public:
  FaceCheck(const PolygonMesh& mesh, const DoubtfulFaces& doubtful, std::uint64_t max_listed,
            Context& context)
      : mesh_(mesh), doubtful_(doubtful), max_listed_(max_listed), context_(context) {}

  RoundingReport run() {
    if (!doubtful_.faces.empty()) judge();
    for (const std::uint32_t f : doubtful_.flipped) {
      if (is_flipped(f)) report_.flipped.push_back(f);
    }
    return std::move(report_);
  }

 private:
  /// Reads the doubtful faces as a mesh, and reports their defects.
  void judge() {
    PolygonMesh near = doubtful_mesh();
    MeshOptions options;
    options.surface = true;
    options.max_listed = max_listed_;
    auto exact = std::exchange(near.exact, {});
    const MeshReport found = complex_of_mesh(near, options, context_).report;
    near.exact = std::move(exact);
    report_.vertices_merged = found.vertices_merged;
    if (found.vertices_merged > 0) report_.vertices_merged -= merged_before(near);
    report_.degenerate = faces(found.degenerate);
    report_.not_simple = faces(found.not_simple);
    report_.not_planar = faces(found.not_planar);
    report_.doubled = faces(found.doubled);
    report_.crossing_count = found.crossing_count;
    report_.crossings = faces(found.crossings);
  }
  /// Returns a mesh of the doubtful faces and their vertices, in order.
  PolygonMesh doubtful_mesh() const {
    std::vector<std::uint32_t> vertices;
    for (const std::uint32_t f : doubtful_.faces) {
      const auto face = mesh_.face(f);
      vertices.insert(vertices.end(), face.begin(), face.end());
    }
    std::ranges::sort(vertices);
    vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
    PolygonMesh result;
    for (const std::uint32_t v : vertices) {
      const auto number = static_cast<std::uint32_t>(result.points.size());
      result.points.push_back(mesh_.points[v]);
      if (const auto* const exact = exact_of(v)) result.exact.emplace_back(number, *exact);
    }
    std::vector<std::uint32_t> corners;
    for (const std::uint32_t f : doubtful_.faces) {
      corners.clear();
      for (const std::uint32_t v : mesh_.face(f)) {
        const auto found = std::ranges::lower_bound(vertices, v);
        corners.push_back(static_cast<std::uint32_t>(found - vertices.begin()));
      }
      result.add_face(corners);
    }
    return result;
  }
  /// Returns the number of vertices that coincide before rounding, because they were split on
  /// purpose.
  static std::uint64_t merged_before(const PolygonMesh& near) {
    SpaceTables tables;
    return merge_equal_points(near, tables).merged;
  }
  /// Returns the faces of the mesh that correspond to doubtful faces.
  std::vector<std::uint32_t> faces(std::vector<std::uint32_t> near) const {
    for (std::uint32_t& f : near) f = doubtful_.faces[f];
    return near;
  }
  std::vector<RoundingReport::FacePair> faces(std::vector<RoundingReport::FacePair> near) const {
    for (auto& [f, g] : near) {
      f = doubtful_.faces[f];
      g = doubtful_.faces[g];
    }
    return near;
  }

  // ---------------------------------------------------------------- flipped

  /// Whether the scalar product of the area vectors of a face before and after rounding is
  /// negative.
  bool is_flipped(std::uint32_t f) const {
    const std::array<Rational, 3> now = area(f, false), then = area(f, true);
    return dot(now, then) < 0;
  }
  /// Returns twice the area vector of a face, with exact or rounded vertices.
  std::array<Rational, 3> area(std::uint32_t f, bool is_exact) const {
    std::array<Rational, 3> sum;
    std::array<Rational, 3> before = point(mesh_.face(f).back(), is_exact);
    for (const std::uint32_t v : mesh_.face(f)) {
      const std::array<Rational, 3> p = point(v, is_exact), part = cross(before, p);
      for (std::size_t k = 0; k < 3; ++k) sum[k] += part[k];
      before = p;
    }
    return sum;
  }
  std::array<Rational, 3> point(std::uint32_t v, bool is_exact) const {
    const RationalPoint3* const exact = is_exact ? exact_of(v) : nullptr;
    if (exact != nullptr) return {exact->x, exact->y, exact->z};
    const Point3& p = mesh_.points[v];
    return {exact_rational(p.x), exact_rational(p.y), exact_rational(p.z)};
  }

  /// Returns the coordinates of a vertex before rounding, or null if it was not rounded.
  const RationalPoint3* exact_of(std::uint32_t v) const {
    const auto found =
        std::ranges::lower_bound(mesh_.exact, v, {}, [](const auto& e) { return e.first; });
    return found != mesh_.exact.end() && found->first == v ? &found->second : nullptr;
  }

  const PolygonMesh& mesh_;
  const DoubtfulFaces& doubtful_;
  std::uint64_t max_listed_;
  Context& context_;
  RoundingReport report_;
};

}  // namespace

RoundingReport check_faces(const PolygonMesh& mesh, const DoubtfulFaces& doubtful,
                           std::uint64_t max_listed, Context& context) {
  return FaceCheck(mesh, doubtful, max_listed, context).run();
}

}  // namespace plumb
