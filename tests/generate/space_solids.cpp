#include "generate/space_solids.h"

#include <algorithm>

namespace plumb::testing {
namespace {

using Polygon = std::vector<std::size_t>;

// Corner i has the upper coordinate along axis k exactly when bit k of i is set.
constexpr std::array<std::array<std::size_t, 4>, 6> kBoxFaces = {
    {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}}};

ExactPoint3 corner(const ExactPoint3& low, const ExactPoint3& high, std::size_t i) {
  return {(i & 1U) != 0 ? high.x : low.x, (i & 2U) != 0 ? high.y : low.y,
          (i & 4U) != 0 ? high.z : low.z};
}

BigRational area_along(const Chain3& polygon, std::size_t axis) {
  ExactPoint3 normal;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    normal = normal + cross(polygon[i], polygon[(i + 1) % polygon.size()]);
  }
  return coordinate(normal, axis);
}

}  // namespace

BigRational& coordinate(ExactPoint3& p, std::size_t axis) {
  return axis == 0 ? p.x : axis == 1 ? p.y : p.z;
}
const BigRational& coordinate(const ExactPoint3& p, std::size_t axis) {
  return axis == 0 ? p.x : axis == 1 ? p.y : p.z;
}

MeshLeaf box(const ExactPoint3& p, const ExactPoint3& q) {
  const ExactPoint3 low{std::min(p.x, q.x), std::min(p.y, q.y), std::min(p.z, q.z)};
  const ExactPoint3 high{std::max(p.x, q.x), std::max(p.y, q.y), std::max(p.z, q.z)};
  MeshLeaf mesh;
  for (std::size_t i = 0; i < 8; ++i) mesh.points.push_back(corner(low, high, i));
  for (const auto& face : kBoxFaces) mesh.faces.emplace_back(face.begin(), face.end());
  return mesh;
}

MeshLeaf tetrahedron(const ExactPoint3& a, const ExactPoint3& b, const ExactPoint3& c,
                     const ExactPoint3& d) {
  MeshLeaf mesh{{a, b, c, d}, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}};
  return dot(cross(b - a, c - a), d - a) > 0 ? mesh : inside_out(std::move(mesh));
}

MeshLeaf prism(const Chain3& polygon, std::size_t axis, const BigRational& low,
               const BigRational& high) {
  MeshLeaf mesh;
  const std::size_t n = polygon.size();
  for (const BigRational& height : {low, high}) {
    for (ExactPoint3 p : polygon) {
      coordinate(p, axis) = height;
      mesh.points.push_back(p);
    }
  }
  Polygon bottom;
  Polygon top;
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t next = (i + 1) % n;
    bottom.insert(bottom.begin(), i);
    top.push_back(n + i);
    mesh.faces.push_back({i, next, n + next, n + i});
  }
  mesh.faces.push_back(bottom);
  mesh.faces.push_back(top);
  return area_along(polygon, axis) > 0 ? mesh : inside_out(std::move(mesh));
}

MeshLeaf inside_out(MeshLeaf mesh) {
  for (Polygon& face : mesh.faces) std::reverse(face.begin(), face.end());
  return mesh;
}

MeshLeaf together(MeshLeaf first, const MeshLeaf& second) {
  const std::size_t shift = first.points.size();
  first.points.insert(first.points.end(), second.points.begin(), second.points.end());
  for (Polygon face : second.faces) {
    for (std::size_t& v : face) v += shift;
    first.faces.push_back(std::move(face));
  }
  return first;
}

MeshLeaf moved(MeshLeaf mesh, const ExactPoint3& by) {
  for (ExactPoint3& p : mesh.points) p = p + by;
  return mesh;
}

PolygonLeaf rectangle(const ExactPoint3& p, const ExactPoint3& q, std::size_t axis,
                      const BigRational& height) {
  const std::size_t u = (axis + 1) % 3;
  const std::size_t v = (axis + 2) % 3;
  PolygonLeaf polygon;
  for (const auto& [first, second] : {std::pair{&p, &p}, {&q, &p}, {&q, &q}, {&p, &q}}) {
    ExactPoint3 c;
    coordinate(c, axis) = height;
    coordinate(c, u) = coordinate(*first, u);
    coordinate(c, v) = coordinate(*second, v);
    polygon.corners.push_back(c);
  }
  return polygon;
}

SpaceSetPointer half_space(int a, int b, int c, int d, bool closed) {
  return space_set(HalfSpaceLeaf{plane_of(a, b, c, d), closed});
}

// ---------------------------------------------------------------- pairs

std::vector<SolidPair> overlapping_boxes() {
  // In halves: before, meets, overlaps, starts, equals, started by, finished by, contains,
  // finishes, overlapped by, met by, after, during.
  static constexpr std::array<std::array<int, 2>, 13> kWays = {{{0, 2},
                                                                {0, 4},
                                                                {2, 6},
                                                                {4, 6},
                                                                {4, 8},
                                                                {4, 10},
                                                                {2, 8},
                                                                {2, 10},
                                                                {6, 8},
                                                                {6, 10},
                                                                {8, 10},
                                                                {10, 12},
                                                                {5, 7}}};
  const auto extent = [](std::size_t way, std::size_t end) {
    return BigRational(kWays[way][end], 2);
  };
  std::vector<SolidPair> pairs;
  const SpaceSetPointer fixed = space_set(box({2, 2, 2}, {4, 4, 4}));
  for (std::size_t i = 0; i < 13; ++i) {
    for (std::size_t j = 0; j <= i; ++j) {
      for (std::size_t k = 0; k <= j; ++k) {
        const ExactPoint3 low{extent(i, 0), extent(j, 0), extent(k, 0)};
        const ExactPoint3 high{extent(i, 1), extent(j, 1), extent(k, 1)};
        pairs.push_back(
            {"[2,4]^3 and " + to_text(low) + to_text(high), fixed, space_set(box(low, high))});
      }
    }
  }
  return pairs;
}

std::vector<SolidPair> special_pairs() {
  const MeshLeaf cube = box({0, 0, 0}, {2, 2, 2});
  const auto set = [](MeshLeaf mesh) { return space_set(std::move(mesh)); };
  const BigRational half(1, 2);
  const MeshLeaf core = box({half, 1, 1}, {1, 1 + half, 1 + half});
  const MeshLeaf shell = together(cube, inside_out(core));
  const MeshLeaf wedge = prism({{0, 0, 0}, {2, 0, 0}, {0, 2, 0}}, 2, 0, 2);
  const MeshLeaf needle = tetrahedron({0, 0, 0}, {1000, 1, 0}, {1000, 0, 1}, {1001, 1, 1});
  const ExactPoint3 slid{BigRational(1, 3), 0, 0};
  return {
      {"identical cubes", set(cube), set(cube)},
      {"identical needles", set(needle), set(needle)},
      {"touching at a vertex", set(cube), set(moved(cube, {2, 2, 2}))},
      {"touching along an edge", set(cube), set(moved(cube, {2, 2, 0}))},
      {"touching along part of an edge", set(cube), set(moved(cube, {2, 2, 1}))},
      {"touching in a facet", set(cube), set(moved(cube, {2, 0, 0}))},
      {"touching in part of a facet", set(cube), set(moved(cube, {2, 1, 1}))},
      {"a vertex on a facet", set(cube),
       set(tetrahedron({1, 1, 2}, {0, 1, 3}, {2, 2, 3}, {2, 0, 3}))},
      {"a vertex on an edge", set(cube),
       set(tetrahedron({1, 0, 2}, {0, 0, 3}, {2, 1, 3}, {2, -1, 3}))},
      {"an edge on a facet", set(cube),
       set(tetrahedron({1, 1, 2}, {1, 1 + half, 2}, {0, 1, 3}, {2, 1, 3}))},
      {"an edge across an edge", set(cube),
       set(tetrahedron({1, -1, 2}, {1, 1, 2}, {0, 0, 3}, {2, 0, 3}))},
      {"slid along a face", set(cube), set(moved(cube, slid))},
      {"a wedge slid along its slope", set(wedge), set(moved(wedge, {1, -1, 0}))},
      {"a wedge in a cube", set(cube), set(wedge)},
      {"a void and what fills it", set(shell), set(core)},
      {"a void and what touches it inside", set(shell),
       set(box({half, 1, 1}, {1, 1 + half, BigRational(5, 4)}))},
      {"needles across", set(needle),
       set(tetrahedron({1, 0, 0}, {0, 1000, 1}, {1, 1000, 0}, {1, 1001, 1}))},
  };
}

}  // namespace plumb::testing
