#include "generate/meshes.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace plumb::testing {

PolygonMesh make_mesh(std::vector<Point3> points, const std::vector<Face>& faces) {
  PolygonMesh mesh;
  mesh.points = std::move(points);
  for (const Face& f : faces) mesh.add_face(f);
  return mesh;
}

PolygonMesh box_mesh(Point3 a, Point3 b) {
  return prism_mesh({{a.x, a.y}, {b.x, a.y}, {b.x, b.y}, {a.x, b.y}}, a.z, b.z);
}

PolygonMesh tetrahedron_mesh(Point3 a, Point3 b, Point3 c, Point3 d) {
  return make_mesh({a, b, c, d}, {{0, 1, 2}, {1, 0, 3}, {2, 1, 3}, {0, 2, 3}});
}

PolygonMesh prism_mesh(const std::vector<Point2>& polygon, double low, double high) {
  const auto n = static_cast<std::uint32_t>(polygon.size());
  PolygonMesh mesh;
  Face bottom, top;
  for (const double z : {low, high}) {
    for (const Point2& p : polygon) mesh.points.push_back({p.x, p.y, z});
  }
  for (std::uint32_t i = 0; i < n; ++i) {
    bottom.push_back(n - 1 - i);
    top.push_back(n + i);
  }
  mesh.add_face(bottom);
  mesh.add_face(top);
  for (std::uint32_t i = 0; i < n; ++i) {
    const std::uint32_t j = (i + 1) % n;
    mesh.add_face(std::array{i, j, n + j, n + i});
  }
  return mesh;
}

namespace {

/// Splits triangles in four, new vertices on the unit sphere.
class Subdivision {
 public:
  explicit Subdivision(std::vector<Point3>& points) : points_(points) {}

  std::vector<Face> split(const std::vector<Face>& faces) {
    std::vector<Face> result;
    for (const Face& f : faces) {
      const std::uint32_t a = middle(f[0], f[1]), b = middle(f[1], f[2]), c = middle(f[2], f[0]);
      for (const Face& part : {Face{f[0], a, c}, {f[1], b, a}, {f[2], c, b}, {a, b, c}}) {
        result.push_back(part);
      }
    }
    return result;
  }

 private:
  std::uint32_t middle(std::uint32_t i, std::uint32_t j) {
    const auto [at, is_new] = middle_.try_emplace(std::minmax(i, j), points_.size());
    if (is_new) {
      const Point3 p = points_[i], q = points_[j];
      Point3 m{p.x + q.x, p.y + q.y, p.z + q.z};
      const double length = std::sqrt(m.x * m.x + m.y * m.y + m.z * m.z);
      points_.push_back({m.x / length, m.y / length, m.z / length});
    }
    return at->second;
  }

  std::vector<Point3>& points_;
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middle_;
};

}  // namespace

PolygonMesh icosphere_mesh(int depth, double radius, Point3 centre) {
  const double a = 0.525731112119133606, b = 0.850650808352039932;
  std::vector<Point3> points = {{-a, 0, b}, {a, 0, b},  {-a, 0, -b}, {a, 0, -b},
                                {0, b, a},  {0, b, -a}, {0, -b, a},  {0, -b, -a},
                                {b, a, 0},  {-b, a, 0}, {b, -a, 0},  {-b, -a, 0}};
  std::vector<Face> faces = {{0, 1, 4},  {0, 4, 9},  {9, 4, 5},  {4, 8, 5},  {4, 1, 8},
                             {8, 1, 10}, {8, 10, 3}, {5, 8, 3},  {5, 3, 2},  {2, 3, 7},
                             {7, 3, 10}, {7, 10, 6}, {7, 6, 11}, {11, 6, 0}, {0, 6, 1},
                             {6, 10, 1}, {9, 11, 0}, {9, 2, 11}, {9, 5, 2},  {7, 11, 2}};
  Subdivision subdivision(points);
  for (int i = 0; i < depth; ++i) faces = subdivision.split(faces);
  for (Point3& p : points) {
    p = {centre.x + radius * p.x, centre.y + radius * p.y, centre.z + radius * p.z};
  }
  return make_mesh(std::move(points), faces);
}

PolygonMesh grid_cube_mesh(std::uint32_t n, Point3 low) {
  PolygonMesh mesh;
  std::map<std::array<std::uint32_t, 3>, std::uint32_t> vertices;
  const auto vertex = [&](const std::array<std::uint32_t, 3>& at) {
    const auto next = static_cast<std::uint32_t>(mesh.points.size());
    const auto [place, is_new] = vertices.try_emplace(at, next);
    if (is_new) mesh.points.push_back({low.x + at[0], low.y + at[1], low.z + at[2]});
    return place->second;
  };
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (const std::uint32_t side : {0U, n}) {
      const auto corner = [&](std::uint32_t i, std::uint32_t j) {
        std::array<std::uint32_t, 3> at{};
        at[axis] = side;
        at[(axis + 1) % 3] = i;
        at[(axis + 2) % 3] = j;
        return vertex(at);
      };
      for (std::uint32_t i = 0; i < n; ++i) {
        for (std::uint32_t j = 0; j < n; ++j) {
          const std::uint32_t a = corner(i, j), b = corner(i + 1, j), c = corner(i + 1, j + 1),
                              d = corner(i, j + 1);
          mesh.add_face(side == 0 ? std::array{a, d, c} : std::array{a, b, c});
          mesh.add_face(side == 0 ? std::array{a, c, b} : std::array{a, c, d});
        }
      }
    }
  }
  return mesh;
}

PolygonMesh reversed(PolygonMesh mesh) {
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    std::reverse(mesh.corners.begin() + mesh.face_begin[f],
                 mesh.corners.begin() + mesh.face_begin[f + 1]);
  }
  return mesh;
}

PolygonMesh joined(PolygonMesh a, const PolygonMesh& b) {
  const auto shift = static_cast<std::uint32_t>(a.points.size());
  a.points.insert(a.points.end(), b.points.begin(), b.points.end());
  for (const auto& [i, p] : b.exact) a.exact.emplace_back(i + shift, p);
  for (std::size_t f = 0; f < b.face_count(); ++f) {
    Face face(b.face(f).begin(), b.face(f).end());
    for (std::uint32_t& v : face) v += shift;
    a.add_face(face);
  }
  return a;
}

PolygonMesh moved(PolygonMesh mesh, Point3 by) {
  for (Point3& p : mesh.points) p = {p.x + by.x, p.y + by.y, p.z + by.z};
  return mesh;
}

PolygonMesh turned(PolygonMesh mesh, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  for (Point3& p : mesh.points) p = {c * p.x - s * p.y, s * p.x + c * p.y, p.z};
  return mesh;
}

PolygonMesh fanned(const PolygonMesh& mesh) {
  PolygonMesh result;
  result.points = mesh.points;
  result.exact = mesh.exact;
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    const auto face = mesh.face(f);
    for (std::size_t i = 2; i < face.size(); ++i) {
      result.add_face(std::array{face[0], face[i - 1], face[i]});
    }
  }
  return result;
}

}  // namespace plumb::testing
