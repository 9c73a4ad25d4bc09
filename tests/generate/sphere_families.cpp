#include "generate/sphere_families.h"

#include <array>
#include <cmath>
#include <memory>
#include <numbers>
#include <utility>

#include "plumb/sphere/set/sphere_vectors.h"
#include "plumb/testing/dice.h"

namespace plumb::testing {
namespace {

using Triangle = std::array<SphereVector, 3>;

/// Place i of a spiral from pole to pole, each with the same share of the sphere;
/// counter-clockwise.
Triangle triangle_at(std::size_t i, std::size_t count) {
  const double share = 1 / static_cast<double>(count);
  const double z = 1 - (2 * static_cast<double>(i) + 1) * share;
  const double r = std::sqrt(1 - z * z);
  const double turn = static_cast<double>(i) * std::numbers::pi * (3 - std::sqrt(5.0));
  const double x = r * std::cos(turn);
  const double y = r * std::sin(turn);
  const double size = 0.5 * std::sqrt(share);
  const auto corner = [&](double east, double north) {
    return SphereVector(x - size * (east * y / r + north * z * x / r),
                        y + size * (east * x / r - north * z * y / r), z + size * north * r);
  };
  return {corner(-1, -0.5), corner(1, -0.7), corner(0.1, 1)};
}

/// A corner is where two sides' circles cross; every triangle is a face of its own, all else face
/// 0.
void add_triangle(PlaneTable& planes, SphereMap& map, const Triangle& corners) {
  const auto first_arc = static_cast<std::uint32_t>(map.arc_count());
  const auto inside = static_cast<std::uint32_t>(map.face_count());
  std::array<OrientedPlane, 3> side;
  for (std::size_t k = 0; k < 3; ++k) {
    side[k] = intern_circle(planes, cross(corners[k], corners[(k + 1) % 3]));
  }
  const auto along = [&](std::uint32_t k) {  // the half-arc with the triangle to its left
    return 2 * (first_arc + k % 3) + (side[k % 3].is_opposite() ? 1U : 0U);
  };
  map.origin.resize(2 * first_arc + 6);
  map.next.resize(2 * first_arc + 6);
  map.face.resize(2 * first_arc + 6);
  for (std::uint32_t k = 0; k < 3; ++k) {
    const OrientedPlane before = side[(k + 2) % 3];
    const SphereDirection u{before.plane(), side[k].plane()};
    map.direction.push_back(before.is_opposite() == side[k].is_opposite() ? u : u.opposite());
    map.circle.push_back(side[k].plane());
    const std::uint32_t h = along(k);
    const std::uint32_t back = SphereMap::twin(h);
    map.first_out.push_back(h);
    map.origin[h] = first_arc + k;
    map.origin[back] = first_arc + (k + 1) % 3;
    map.next[h] = along(k + 1);
    map.next[back] = SphereMap::twin(along(k + 2));
    map.face[h] = inside;
    map.face[back] = 0;
  }
  map.face_mark.push_back(1);
}

}  // namespace

NefSphere scattered_triangles(std::size_t count) {
  auto planes = std::make_shared<PlaneTable>();
  SphereMap map;
  map.face_mark.push_back(0);
  for (std::size_t i = 0; i < count; ++i) add_triangle(*planes, map, triangle_at(i, count));
  map.point_mark.assign(map.point_count(), 1);
  map.point_face.assign(map.point_count(), kNone);
  map.arc_mark.assign(map.arc_count(), 1);
  return NefSphere::from_minimal_unchecked({std::move(planes), std::move(map)});
}

NefSphere crown(std::size_t n, double turn, double low, double high) {
  std::vector<SphereVector> corners;
  for (std::size_t i = 0; i < n; ++i) {
    const double angle =
        (static_cast<double>(i) + turn) * 2 * std::numbers::pi / static_cast<double>(n);
    corners.emplace_back(std::cos(angle), std::sin(angle), i % 2 == 0 ? low : high);
  }
  return NefSphere::polygon(corners, Boundary::Closed);
}

std::vector<SphereVector> any_directions(std::size_t count, std::uint64_t seed) {
  Dice dice(seed);
  std::vector<SphereVector> all;
  const auto coordinate = [&] { return static_cast<double>(dice.between(-1000, 1000)) + 0.5; };
  for (std::size_t i = 0; i < count; ++i) {
    const double x = coordinate();
    const double y = coordinate();
    all.emplace_back(x, y, coordinate());
  }
  return all;
}

}  // namespace plumb::testing
