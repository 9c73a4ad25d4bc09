// Primitives of constructive solid geometry.
//
// Vertices of circles are radius * cosine and radius * sine, each rounded once more; cosine and
// sine are exact where degrees allow it. Faces of cylinders are exactly planar, because their edges
// along the axis are parallel. Spheres and cones are hulls of their vertices (hull_mesh), which
// triangulates their faces such that the solid is convex.
//
// Tested by tests/model/primitives_test.cpp.
#include "plumb/model/primitives.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <numbers>
#include <vector>

#include "plumb/model/hull.h"
#include "plumb/predicates/arithmetic/double_bits.h"
#include "plumb/predicates/arithmetic/elementary.h"
#include "plumb/predicates/error.h"

namespace plumb {
namespace {

constexpr double kMostChords = 0x1p20;
constexpr double kLeastRadius = 0x1p-20;  // A smaller circle becomes a triangle, as in OpenSCAD.

void require_finite_numbers(std::initializer_list<double> numbers) {
  for (const double number : numbers) {
    if (!is_finite(number)) {
      throw Error(ErrorCode::NotFinite, "the sizes of a primitive must be finite numbers");
    }
  }
}

void require_size(bool is_right, const char* message) {
  if (!is_right) throw Error(ErrorCode::BadArgument, message);
}

/// Returns the sine of an angle of 0 to 90 degrees.
double sine_in_quadrant(double angle) {
  if (angle == 30) return 0.5;
  if (angle == 45) return std::numbers::sqrt2 / 2;
  if (angle == 60) return std::numbers::sqrt3 / 2;
  if (angle == 90) return 1;
  return angle <= 45 ? sine(angle * std::numbers::pi / 180)
                     : cosine((90 - angle) * std::numbers::pi / 180);
}

/// Returns the corners of a regular polygon in the plane at the height z.
std::vector<Point3> circle(double radius, std::uint32_t chords, double z) {
  std::vector<Point3> points;
  for (std::uint32_t i = 0; i < chords; ++i) {
    const double angle = 360. * i / chords;
    points.push_back({radius * cosine_of_degrees(angle), radius * sine_of_degrees(angle), z});
  }
  return points;
}

void require_chords(std::uint32_t chords) {
  require_size(chords >= 3, "a circle needs at least 3 chords");
  if (chords > kMostChords) {
    throw Error(ErrorCode::ResourceLimit, "a circle has more than 1048576 chords");
  }
}

/// Charges memory for the points of a solid that consists of circles. Throws Error{ResourceLimit}
/// if there are too many points.
void charge_circles(std::uint64_t circles, std::uint64_t chords, MemoryCharge& memory) {
  constexpr std::uint64_t kMostPoints = std::uint64_t{1} << 30, kBytesPerPoint = 120;
  if (circles * chords > kMostPoints) {
    throw Error(ErrorCode::ResourceLimit, "a solid has more than 2^30 corners");
  }
  memory.add(kBytesPerPoint * circles * chords, "a solid");
}

}  // namespace

double sine_of_degrees(double angle) {
  const double turn = std::remainder(angle, 360);  // The angle is in [-180, 180].
  const double magnitude = std::fabs(turn);
  const double sine = sine_in_quadrant(magnitude <= 90 ? magnitude : 180 - magnitude);
  return turn < 0 ? -sine : sine;
}

double cosine_of_degrees(double angle) {
  const double magnitude = std::fabs(std::remainder(angle, 360));
  return magnitude <= 90 ? sine_in_quadrant(90 - magnitude) : -sine_in_quadrant(magnitude - 90);
}

std::uint32_t chords_of(double radius, const CircleDivision& division) {
  require_finite_numbers({radius, division.count, division.angle, division.length});
  if (radius < kLeastRadius) return 3;
  double chords = std::floor(division.count);
  if (division.count <= 0) {
    require_size(division.angle > 0 && division.length > 0,
                 "the least angle and the least length of a chord must be positive");
    const double by_length = 2 * std::numbers::pi * radius / division.length;
    chords = std::ceil(std::max(std::min(360 / division.angle, by_length), 5.));
  }
  if (chords > kMostChords) {
    throw Error(ErrorCode::ResourceLimit, "a circle has more than 1048576 chords");
  }
  return static_cast<std::uint32_t>(std::max(chords, 3.));
}

PolygonMesh box_mesh(const std::array<double, 3>& size, Placement placement) {
  require_finite_numbers({size[0], size[1], size[2]});
  require_size(size[0] / 2 > 0 && size[1] / 2 > 0 && size[2] / 2 > 0,
               "a box needs positive lengths");
  const double low = placement == Placement::Centred ? -0.5 : 0;
  PolygonMesh mesh;
  for (std::uint32_t corner = 0; corner < 8; ++corner) {
    const auto at = [&](std::uint32_t axis) {
      return size[axis] * (low + static_cast<double>(corner >> axis & 1U));
    };
    mesh.points.push_back({at(0), at(1), at(2)});
  }
  constexpr std::uint32_t kFaces[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                                          {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
  for (const auto& face : kFaces) mesh.add_face(face);
  return mesh;
}

PolygonMesh sphere_mesh(double radius, std::uint32_t chords, Context& context) {
  require_finite_numbers({radius});
  require_size(radius > 0, "a sphere needs a positive radius");
  require_chords(chords);
  const std::uint32_t rings = (chords + 1) / 2;
  MemoryCharge memory(context);
  charge_circles(rings, chords, memory);
  std::vector<Point3> points;
  for (std::uint32_t i = 0; i < rings; ++i) {
    context.checkpoint("sphere", i, rings);
    const double polar = 180. * (i + 0.5) / rings;
    const std::vector<Point3> ring =
        circle(radius * sine_of_degrees(polar), chords, radius * cosine_of_degrees(polar));
    points.insert(points.end(), ring.begin(), ring.end());
  }
  return hull_mesh(points, context);
}

PolygonMesh cylinder_mesh(double height, double bottom_radius, double top_radius,
                          std::uint32_t chords, Placement placement, Context& context) {
  require_finite_numbers({height, bottom_radius, top_radius});
  require_size(height > 0, "a cylinder needs a positive height");
  require_size(bottom_radius >= 0 && top_radius >= 0 && bottom_radius + top_radius > 0,
               "a cylinder needs radii of at least 0, one of them positive");
  require_chords(chords);
  const double low = placement == Placement::Centred ? -height / 2 : 0;
  const auto end = [&](double radius, double z) {
    return radius > 0 ? circle(radius, chords, z) : std::vector<Point3>{{0, 0, z}};
  };
  const std::vector<Point3> bottom = end(bottom_radius, low);
  const std::vector<Point3> top = end(top_radius, low + height);
  std::vector<Point3> points = bottom;
  points.insert(points.end(), top.begin(), top.end());
  if (bottom_radius != top_radius) return hull_mesh(points, context);
  PolygonMesh mesh;
  mesh.points = std::move(points);
  std::vector<std::uint32_t> low_face, high_face;
  for (std::uint32_t i = 0; i < chords; ++i) {
    const std::uint32_t next = i + 1 < chords ? i + 1 : 0;
    mesh.add_face(std::array{i, next, next + chords, i + chords});
    low_face.push_back(chords - 1 - i);
    high_face.push_back(chords + i);
  }
  mesh.add_face(low_face);
  mesh.add_face(high_face);
  return mesh;
}

PolygonMesh torus_mesh(double radius, double tube_radius, std::uint32_t chords,
                       std::uint32_t tube_chords, Context& context) {
  require_finite_numbers({radius, tube_radius});
  require_size(tube_radius > 0 && radius > tube_radius,
               "the tube of a torus needs a positive radius that is less than that of the torus");
  require_chords(chords);
  require_chords(tube_chords);
  MemoryCharge memory(context);
  charge_circles(chords, tube_chords, memory);
  PolygonMesh mesh;
  for (std::uint32_t i = 0; i < chords; ++i) {
    context.checkpoint("torus", i, chords);
    const double around = 360. * i / chords;
    for (std::uint32_t j = 0; j < tube_chords; ++j) {
      const double angle = 360. * j / tube_chords;
      const double from_axis = radius + tube_radius * cosine_of_degrees(angle);
      mesh.points.push_back({from_axis * cosine_of_degrees(around),
                             from_axis * sine_of_degrees(around),
                             tube_radius * sine_of_degrees(angle)});
    }
  }
  for (std::uint32_t i = 0; i < chords; ++i) {
    const std::uint32_t here = i * tube_chords, next = (i + 1 < chords ? i + 1 : 0) * tube_chords;
    for (std::uint32_t j = 0; j < tube_chords; ++j) {
      const std::uint32_t k = j + 1 < tube_chords ? j + 1 : 0;
      mesh.add_face(std::array{here + j, next + j, next + k});
      mesh.add_face(std::array{here + j, next + k, here + k});
    }
  }
  return mesh;
}

Nef2 rectangle(const std::array<double, 2>& size, Placement placement) {
  require_finite_numbers({size[0], size[1]});
  require_size(size[0] / 2 > 0 && size[1] / 2 > 0, "a rectangle needs positive lengths");
  const double low = placement == Placement::Centred ? -0.5 : 0;
  const double x = size[0] * low, y = size[1] * low;
  const double to_x = size[0] * (low + 1), to_y = size[1] * (low + 1);
  const std::array<Point2, 4> corners{{{x, y}, {to_x, y}, {to_x, to_y}, {x, to_y}}};
  return Nef2::polygon(corners);
}

Nef2 disk(double radius, std::uint32_t chords, Context& context) {
  require_finite_numbers({radius});
  require_size(radius > 0, "a disk needs a positive radius");
  require_chords(chords);
  std::vector<Point2> corners;
  for (const Point3& p : circle(radius, chords, 0)) corners.push_back({p.x, p.y});
  return Nef2::polygon(corners, Boundary::Closed, context);
}

}  // namespace plumb
