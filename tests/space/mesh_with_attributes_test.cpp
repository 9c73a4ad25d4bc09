// mesh_with_attributes() against oracles: unit squares of a grid for scenes of cubes, brute-force
// location for scenes in general position, and functions of the point as channels.
#include "plumb/space/mesh_with_attributes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "generate/meshes.h"
#include "generate/near_solids.h"
#include "oracle/valid_mesh_check.h"
#include "plumb/predicates/error.h"
#include "plumb/space/nef3.h"
#include "plumb/space/repair_mesh.h"
#include "plumb/testing/dice.h"

namespace plumb::mesh_with_attributes_test {
namespace {

using testing::box_mesh;
using testing::Dice;
using testing::fanned;
using testing::grid_cube_mesh;
using testing::icosphere_mesh;

using SharedSource = std::shared_ptr<const MeshSource>;

/// Returns a source with ids and two channels: the coordinates of the corner and random numbers.
SharedSource random_source(PolygonMesh mesh, Dice& dice) {
  MeshSource source{"random", std::move(mesh), {}};
  MeshAttributes& attributes = source.attributes;
  MeshChannel place{"place", 3, {}}, noise{"noise", 2, {}};
  for (const std::uint32_t v : source.mesh.corners) {
    const Point3& p = source.mesh.points[v];
    place.values.insert(place.values.end(), {p.x, p.y, p.z});
    for (int k = 0; k < 2; ++k) noise.values.push_back(static_cast<double>(dice.between(0, 99)));
  }
  attributes.channels = {std::move(place), std::move(noise)};
  for (std::uint32_t f = 0; f < source.mesh.face_count(); ++f) {
    attributes.face_id.push_back(dice.below(1000));
  }
  return std::make_shared<const MeshSource>(std::move(source));
}

/// Returns a source with materials only, one for each face of the mesh.
SharedSource plain_source(PolygonMesh mesh) {
  MeshSource source{"plain", std::move(mesh), {}};
  for (std::uint32_t f = 0; f < source.mesh.face_count(); ++f) {
    source.attributes.materials.push_back({"m" + std::to_string(f), {}, {}});
    source.attributes.face_material.push_back(f);
  }
  return std::make_shared<const MeshSource>(std::move(source));
}

std::array<Point3, 3> corners_of(const PolygonMesh& mesh, std::size_t f) {
  const auto face = mesh.face(f);
  return {mesh.points[face[0]], mesh.points[face[1]], mesh.points[face[2]]};
}

Point3 cross(const std::array<Point3, 3>& t) {
  const Point3 u{t[1].x - t[0].x, t[1].y - t[0].y, t[1].z - t[0].z};
  const Point3 v{t[2].x - t[0].x, t[2].y - t[0].y, t[2].z - t[0].z};
  return {u.y * v.z - u.z * v.y, u.z * v.x - u.x * v.z, u.x * v.y - u.y * v.x};
}

double dot(const Point3& a, const Point3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

/// Returns the weights of a point in a triangle of space by areas, in doubles.
std::array<double, 3> weights_in(const std::array<Point3, 3>& t, const Point3& p) {
  const Point3 n = cross(t);
  std::array<double, 3> weights{};
  for (std::size_t i = 0; i < 3; ++i) {
    weights[i] = dot(cross({p, t[(i + 1) % 3], t[(i + 2) % 3]}), n) / dot(n, n);
  }
  return weights;
}

const MeshChannel& channel(const MeshAttributes& attributes, const std::string& name) {
  for (const MeshChannel& c : attributes.channels) {
    if (c.name == name) return c;
  }
  throw Error(ErrorCode::BadArgument, "no channel " + name);
}

/// Checks the sizes of all arrays of a result and the order of its faces.
void expect_complete(const MeshWithAttributes& made, std::size_t sources) {
  const std::size_t faces = made.mesh.face_count();
  ASSERT_EQ(made.source.size(), faces);
  ASSERT_EQ(made.run_begin.size(), sources + 2);
  EXPECT_EQ(made.run_begin.front(), 0U);
  EXPECT_EQ(made.run_begin.back(), faces);
  for (std::size_t run = 0; run <= sources; ++run) {
    for (std::uint32_t f = made.run_begin[run]; f < made.run_begin[run + 1]; ++f) {
      const std::uint32_t source = made.source[f].source;
      EXPECT_EQ(run == sources ? FaceSource::kNone : run, source);
    }
  }
  for (const MeshChannel& c : made.attributes.channels) {
    EXPECT_EQ(c.values.size(), made.mesh.corners.size() * c.width);
  }
  require_consistent({"", made.mesh, made.attributes});
}

// ---------------------------------------------------------------- cubes on a grid

constexpr int kSide = 4;     // The side of a cube. A power of two: diagonals cross at doubles.
constexpr int kExtent = 12;  // Of the grid.

struct CubeScene {
  std::vector<std::array<int, 3>> low;
  std::vector<MarkFunction> op;  // The operation that takes in each cube but the first.
};

bool contains(const std::array<int, 3>& low, const std::array<int, 3>& cell) {
  for (std::size_t i = 0; i < 3; ++i) {
    if (cell[i] < low[i] || cell[i] >= low[i] + kSide) return false;
  }
  return true;
}

bool is_inside(const CubeScene& scene, const std::array<int, 3>& cell) {
  bool inside = contains(scene.low[0], cell);
  for (std::size_t i = 1; i < scene.low.size(); ++i) {
    inside = scene.op[i](inside, contains(scene.low[i], cell));
  }
  return inside;
}

/// The owner of a unit square: its source, whether it is flipped, and its direction.
using Owner = std::tuple<std::uint32_t, bool, std::size_t, bool>;

/// Returns the number of unit squares of each owner, square by square.
std::map<Owner, double> squares(const CubeScene& scene) {
  std::map<Owner, double> area;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (int n = 0; n < kExtent * kExtent * kExtent; ++n) {
      const std::array<int, 3> cell{n % kExtent, n / kExtent % kExtent, n / kExtent / kExtent};
      std::array<int, 3> below = cell;
      --below[axis];
      const bool above_in = is_inside(scene, cell), below_in = is_inside(scene, below);
      if (above_in == below_in) continue;
      Owner best{FaceSource::kNone, true, axis, below_in};
      for (std::uint32_t s = 0; s < scene.low.size(); ++s) {
        const bool in_above = contains(scene.low[s], cell),
                   in_below = contains(scene.low[s], below);
        if (in_above == in_below) continue;
        const bool is_flipped = in_above != above_in;
        const bool is_better =
            std::get<0>(best) == FaceSource::kNone || (std::get<1>(best) && !is_flipped);
        if (is_better) best = {s, is_flipped, axis, below_in};
      }
      area[best] += 1;
    }
  }
  return area;
}

/// Returns the area of each owner in a mesh. All areas of these scenes are doubles.
std::map<Owner, double> areas(const MeshWithAttributes& made) {
  std::map<Owner, double> area;
  for (std::size_t f = 0; f < made.mesh.face_count(); ++f) {
    const Point3 n = cross(corners_of(made.mesh, f));
    const std::array<double, 3> c{n.x, n.y, n.z};
    std::size_t axis = 0;
    for (std::size_t i = 1; i < 3; ++i) axis = c[i] != 0 ? i : axis;
    area[{made.source[f].source, made.source[f].is_flipped, axis, c[axis] > 0}] +=
        std::fabs(c[axis]) / 2;
  }
  return area;
}

CubeScene random_cubes(Dice& dice, bool has_differences) {
  CubeScene scene;
  const std::int64_t count = dice.between(2, 5);
  for (std::int64_t i = 0; i < count; ++i) {
    std::array<int, 3> low{};
    for (int& x : low) x = static_cast<int>(dice.between(1, kExtent - kSide - 1)) / 2 * 2;
    scene.low.push_back(low);
    const std::uint32_t kind = has_differences ? dice.below(4) : 0;
    scene.op.push_back(kind == 3 ? kSymmetricDifference : kind >= 1 ? kDifference : kUnion);
  }
  return scene;
}

PolygonMesh cube_mesh(const std::array<int, 3>& low) {
  const Point3 at{static_cast<double>(low[0]), static_cast<double>(low[1]),
                  static_cast<double>(low[2])};
  return fanned(box_mesh(at, {at.x + kSide, at.y + kSide, at.z + kSide}));
}

Nef3 set_of(const CubeScene& scene, Dice& dice, std::vector<SharedSource>& sources) {
  Nef3 set;
  for (std::size_t i = 0; i < scene.low.size(); ++i) {
    sources.push_back(random_source(cube_mesh(scene.low[i]), dice));
    const Nef3 cube = from_source(sources.back());
    set = i == 0 ? cube : boolean_op(set, cube, scene.op[i]);
  }
  return set;
}

/// Checks the values of a result at its corners: the coordinates exactly where the point is a
/// double, and the random numbers by weights in doubles.
void expect_values(const MeshWithAttributes& made, std::span<const SharedSource> sources,
                   bool is_exact) {
  const MeshChannel& place = channel(made.attributes, "place");
  const MeshChannel& noise = channel(made.attributes, "noise");
  for (std::size_t f = 0; f < made.mesh.face_count(); ++f) {
    const FaceSource from = made.source[f];
    ASSERT_NE(from.source, FaceSource::kNone);
    const MeshSource& source = *sources[from.source];
    EXPECT_EQ(made.attributes.face_id[f], source.attributes.face_id[from.face]);
    const std::array<Point3, 3> triangle = corners_of(source.mesh, from.face);
    for (std::size_t i = 0; i < 3; ++i) {
      const Point3 p = made.mesh.points[made.mesh.corners[3 * f + i]];
      const std::array<double, 3> xyz{p.x, p.y, p.z};
      for (std::size_t k = 0; k < 3; ++k) {
        const double value = place.values[(3 * f + i) * 3 + k];
        if (is_exact) {
          EXPECT_EQ(value, xyz[k]);
        }
        EXPECT_NEAR(value, xyz[k], 1e-12);
      }
      const std::array<double, 3> weights = weights_in(triangle, p);
      for (std::size_t k = 0; k < 2; ++k) {
        double expected = 0;
        const auto& values = channel(source.attributes, "noise").values;
        for (std::size_t j = 0; j < 3; ++j) {
          EXPECT_GE(weights[j], -1e-9) << "the face is not in its source";
          expected += weights[j] * values[(3 * from.face + j) * 2 + k];
        }
        EXPECT_NEAR(noise.values[(3 * f + i) * 2 + k], expected, 1e-7);
      }
    }
  }
}

TEST(MeshWithAttributes, AreasOfSourcesAddUpExactly) {
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    SCOPED_TRACE(seed);
    Dice dice(seed);
    const CubeScene scene = random_cubes(dice, seed % 3 != 0);
    std::vector<SharedSource> sources;
    const Nef3 set = set_of(scene, dice, sources);
    for (const PieceJoin join : {PieceJoin::None, PieceJoin::SameAttributes}) {
      const MeshWithAttributes made =
          mesh_with_attributes(set, {.join = join, .type = CoordinateType::Double});
      expect_complete(made, set.sources().size());
      EXPECT_EQ(made.repair.rounded_vertices, 0U);
      EXPECT_EQ(areas(made), squares(scene));
      expect_values(made, sources, true);
      EXPECT_EQ(Nef3::from_mesh(made.mesh), set.regularization());
    }
  }
}

// Materials that do not change over the faces of a cube leave no cut along the diagonals.
TEST(MeshWithAttributes, JoinsPiecesOfEqualAttributes) {
  for (std::uint64_t seed = 0; seed < 30; ++seed) {
    SCOPED_TRACE(seed);
    Dice dice(seed);
    const CubeScene scene = random_cubes(dice, true);
    Nef3 set;
    for (std::size_t i = 0; i < scene.low.size(); ++i) {
      MeshSource source{"cube", cube_mesh(scene.low[i]), {}};
      MeshChannel place{"place", 3, {}};
      for (const std::uint32_t v : source.mesh.corners) {
        const Point3& p = source.mesh.points[v];
        place.values.insert(place.values.end(), {p.x, 2 * p.y, p.z - 1});
      }
      source.attributes.channels = {place};
      const Nef3 cube = from_source(std::make_shared<const MeshSource>(std::move(source)));
      set = i == 0 ? cube : boolean_op(set, cube, scene.op[i]);
    }
    const MeshWithAttributes made = mesh_with_attributes(set);
    EXPECT_EQ(areas(made), squares(scene));
    const auto& values = channel(made.attributes, "place").values;
    for (std::size_t c = 0; c < made.mesh.corners.size(); ++c) {
      const Point3& p = made.mesh.points[made.mesh.corners[c]];
      EXPECT_EQ(values[3 * c], p.x);
      EXPECT_EQ(values[3 * c + 1], 2 * p.y);
      EXPECT_EQ(values[3 * c + 2], p.z - 1);
    }
    // Vertices are integer points: the diagonals, which cross elsewhere, too, are gone.
    for (const Point3& p : made.mesh.points) {
      EXPECT_EQ(p.x + p.y + p.z, std::floor(p.x) + std::floor(p.y) + std::floor(p.z));
    }
  }
  const SharedSource cube = plain_source(box_mesh({0, 0, 0}, {1, 1, 1}));
  EXPECT_EQ(mesh_with_attributes(from_source(cube)).mesh.face_count(), 12U);
}

// ---------------------------------------------------------------- general position

TEST(MeshWithAttributes, SpheresInGeneralPositionKeepTheirTriangles) {
  for (std::uint64_t seed = 0; seed < 8; ++seed) {
    SCOPED_TRACE(seed);
    Dice dice(seed);
    const auto coordinate = [&] { return static_cast<double>(dice.between(-1000, 1000)) / 1511; };
    std::vector<SharedSource> sources;
    Nef3 set;
    for (int i = 0; i < 3; ++i) {
      const Point3 centre{coordinate(), coordinate(), coordinate()};
      sources.push_back(random_source(icosphere_mesh(2, 1 + coordinate() / 3, centre), dice));
      const Nef3 sphere = from_source(sources.back());
      set = i == 0 ? sphere : boolean_op(set, sphere, i == 1 ? kUnion : kDifference);
    }
    const MeshWithAttributes made = mesh_with_attributes(set);
    expect_complete(made, 3);
    expect_values(made, sources, false);
    EXPECT_EQ(made.mesh.face_count(),
              valid_mesh(set, {.faces = MeshFaces::Triangles}).made.mesh.face_count());
    for (std::size_t f = 0; f < made.mesh.face_count(); ++f) {
      const FaceSource from = made.source[f];
      const Point3 n = cross(corners_of(made.mesh, f));
      const Point3 m = cross(corners_of(sources[from.source]->mesh, from.face));
      EXPECT_EQ(from.is_flipped, from.source == 2);
      EXPECT_EQ(dot(n, m) < 0, from.is_flipped);
    }
  }
}

// A set of cubes whose faces are grids of triangles is cut by spheres: facets of many triangles,
// whose cuts end at edges that other facets share.
TEST(MeshWithAttributes, GridsCutBySpheresAreValidMeshes) {
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    SCOPED_TRACE(seed);
    Dice dice(seed);
    const auto coordinate = [&] { return static_cast<double>(dice.between(0, 4000)) / 1013; };
    std::vector<SharedSource> sources{random_source(grid_cube_mesh(4, {0, 0, 0}), dice),
                                      random_source(grid_cube_mesh(3, {1, 1, 2}), dice)};
    const Point3 centre{coordinate(), coordinate(), coordinate()};
    sources.push_back(random_source(icosphere_mesh(1, 1.7, centre), dice));
    const Nef3 set = from_source(sources[0]) + from_source(sources[1]) - from_source(sources[2]);
    const MeshWithAttributes made = mesh_with_attributes(set, {.join = PieceJoin::None});
    expect_complete(made, 3);
    expect_values(made, sources, false);
    MeshReport report;
    FromMeshOptions options;
    options.report = &report;
    const Nef3 read = Nef3::from_mesh(made.mesh, options);
    EXPECT_FALSE(report.crosses_itself());
    EXPECT_NEAR(static_cast<double>(*read.volume()), static_cast<double>(*set.volume()), 1e-9);
  }
}

// ---------------------------------------------------------------- maps, planes, chains

/// A turn by the angle of a triangle of sides 3, 4 and 5, with a scale of `z` along z.
AffineMap3 turn_map(const Rational& z) {
  const Rational c = Rational(3) / 5, s = Rational(4) / 5, zero = 0;
  return {{{{c, -s, zero}, {s, c, zero}, {zero, zero, z}}}, {Rational(1) / 3, 2, zero}};
}

TEST(MeshWithAttributes, MapsMoveSourcesAndTurnNormals) {
  for (const int z : {1, 3, -1, -2}) {
    SCOPED_TRACE(z);
    PolygonMesh mesh = icosphere_mesh(2, 1, {0.25, 0.5, 0});
    MeshSource source{"sphere", mesh, {}};
    MeshChannel place{"place", 3, {}}, normal{"normal", 3, {}};
    for (std::size_t f = 0; f < mesh.face_count(); ++f) {
      const Point3 n = cross(corners_of(mesh, f));
      const double length = std::sqrt(dot(n, n));
      for (const std::uint32_t v : mesh.face(f)) {
        const Point3& p = mesh.points[v];
        place.values.insert(place.values.end(), {p.x, p.y, p.z});
        normal.values.insert(normal.values.end(), {n.x / length, n.y / length, n.z / length});
      }
    }
    source.attributes.channels = {place, normal};
    const auto shared = std::make_shared<const MeshSource>(std::move(source));
    const AffineMap3 map = turn_map(z);
    const Nef3 box = from_source(plain_source(box_mesh({-3, -3, -9}, {3, 3, 0.125})));
    const Nef3 set = from_source(shared).transformed(map).transformed(map);
    const Nef3 carved = box - set;
    const MeshWithAttributes made = mesh_with_attributes(carved);
    expect_complete(made, 2);
    EXPECT_LT(made.run_begin[1], made.run_begin[2]) << "the sphere leaves no faces";
    EXPECT_EQ(made.run_begin[2], made.run_begin[3]);
    for (std::uint32_t f = made.run_begin[1]; f < made.run_begin[2]; ++f) {
      EXPECT_TRUE(made.source[f].is_flipped);
      const Point3 n = cross(corners_of(made.mesh, f));
      for (std::size_t c = std::size_t{3} * f; c < 3 * (std::size_t{f} + 1); ++c) {
        const Point3& p = made.mesh.points[made.mesh.corners[c]];
        const double* at = &channel(made.attributes, "place").values[3 * c];
        const auto once = [&](const std::array<double, 3>& x) {
          return std::array<double, 3>{0.6 * x[0] - 0.8 * x[1] + 1.0 / 3,
                                       0.8 * x[0] + 0.6 * x[1] + 2, z * x[2]};
        };
        const std::array<double, 3> image = once(once({at[0], at[1], at[2]}));
        EXPECT_NEAR(image[0], p.x, 1e-12);
        EXPECT_NEAR(image[1], p.y, 1e-12);
        EXPECT_NEAR(image[2], p.z, 1e-12);
        const double* m = &channel(made.attributes, "normal").values[3 * c];
        const double along = n.x * m[0] + n.y * m[1] + n.z * m[2];
        if (dot(n, n) > 1e-12) {
          EXPECT_NEAR(along / std::sqrt(dot(n, n)), 1, 1e-6);
        }
      }
    }
  }
}

/// A face of a result: its source, and its corners with all their numbers, the least corner first.
using StatedFace = std::tuple<std::uint32_t, std::uint32_t, bool, std::vector<std::vector<double>>>;

std::vector<StatedFace> stated_faces(const MeshWithAttributes& made) {
  std::vector<StatedFace> faces;
  for (std::size_t f = 0; f < made.mesh.face_count(); ++f) {
    std::vector<std::vector<double>> corners;
    for (std::size_t c = made.mesh.face_begin[f]; c < made.mesh.face_begin[f + 1]; ++c) {
      const Point3& p = made.mesh.points[made.mesh.corners[c]];
      auto& numbers = corners.emplace_back(std::vector<double>{p.x, p.y, p.z});
      for (const MeshChannel& channel : made.attributes.channels) {
        const auto first = channel.values.begin() + static_cast<std::ptrdiff_t>(c * channel.width);
        numbers.insert(numbers.end(), first, first + channel.width);
      }
    }
    std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
    const FaceSource& from = made.source[f];
    faces.emplace_back(from.source, from.face, from.is_flipped, std::move(corners));
  }
  std::sort(faces.begin(), faces.end());
  return faces;
}

// Sets that were moved have the same faces and numbers as sets of moved meshes. The coordinates
// are multiples of 2^-20, so that moved points are doubles. Many spheres hide each other.
TEST(MeshWithAttributes, MovedSourcesAreLikeMovedMeshes) {
  Dice dice(11);
  PolygonMesh sphere = icosphere_mesh(1, 1, {0, 0, 0});
  for (Point3& p : sphere.points) {
    for (double* x : {&p.x, &p.y, &p.z}) *x = std::ldexp(std::round(std::ldexp(*x, 20)), -20);
  }
  const SharedSource source = random_source(sphere, dice);
  for (int round = 0; round < 4; ++round) {
    std::vector<Nef3> moved, of_moved_meshes;
    for (int i = 0; i < 8; ++i) {
      const auto step = [&] { return static_cast<double>(dice.between(-6, 6)) / 4; };
      const Point3 by{i / 4. - 1, step(), step()};  // All are different.
      moved.push_back(from_source(source).transformed(
          {{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}, {by.x, by.y, by.z}}));
      MeshSource other = *source;
      for (Point3& p : other.mesh.points) p = {p.x + by.x, p.y + by.y, p.z + by.z};
      of_moved_meshes.push_back(from_source(std::make_shared<const MeshSource>(std::move(other))));
    }
    const MeshWithAttributes a = mesh_with_attributes(union_of(moved));
    const MeshWithAttributes b = mesh_with_attributes(union_of(of_moved_meshes));
    EXPECT_EQ(stated_faces(a), stated_faces(b)) << round;
  }
}

TEST(MeshWithAttributes, HalfSpacesHaveNoSource) {
  const SharedSource cube = plain_source(box_mesh({0, 0, 0}, {2, 2, 2}));
  const Nef3 set = from_source(cube) * Nef3::half_space({0, 0, 1, -1}, Boundary::Closed);
  const MeshWithAttributes made = mesh_with_attributes(set);
  expect_complete(made, 1);
  double without = 0;
  for (std::size_t f = 0; f < made.mesh.face_count(); ++f) {
    if (made.source[f].source != FaceSource::kNone) continue;
    without += cross(corners_of(made.mesh, f)).z / 2;
    EXPECT_EQ(made.attributes.face_material[f], MeshAttributes::kNone);
  }
  EXPECT_EQ(without, 4);
}

// The id of a half-space is that of its cut, also where the half-space was moved or subtracted, and
// where the cut lies in the plane of a face of the box.
TEST(MeshWithAttributes, HalfSpacesCanHaveIds) {
  const auto half_space = [](const Plane3& plane, std::uint32_t id) {
    MeshSource source{"cut", {}, {}};
    source.plane = plane;
    source.attributes.face_id = {id};
    return from_source(std::make_shared<const MeshSource>(std::move(source)));
  };
  Dice dice(1);
  const Nef3 box = from_source(random_source(fanned(box_mesh({0, 0, 0}, {4, 4, 4})), dice));
  const auto area_of = [](const Nef3& set, std::uint32_t source, std::uint32_t id, bool flipped) {
    const MeshWithAttributes made = mesh_with_attributes(set);
    double area = 0;
    for (std::size_t f = 0; f < made.mesh.face_count(); ++f) {
      if (made.source[f] != FaceSource{source, 0, flipped}) continue;
      EXPECT_EQ(made.attributes.face_id[f], id);
      const Point3 n = cross(corners_of(made.mesh, f));
      area += std::sqrt(dot(n, n)) / 2;
    }
    return area;
  };
  // The plane y + z = 4 cuts the cube along diagonals.
  const Nef3 half = half_space({0, 1, 1, -3}, 77).translated({0, 1, 0});
  EXPECT_NEAR(area_of(box * half, 1, 77, false), 16 * std::sqrt(2.0), 1e-12);
  EXPECT_NEAR(area_of(box - half, 1, 77, true), 16 * std::sqrt(2.0), 1e-12);
  const Nef3 below = half_space({0, 0, 1, -4}, 88);
  EXPECT_EQ(area_of(below * box, 0, 88, false), 16);
  EXPECT_EQ(area_of(box * below, 1, 88, false), 0);
  MeshSource bad{"bad", box_mesh({0, 0, 0}, {1, 1, 1}), {}};
  bad.plane = Plane3{0, 0, 1, 0};
  EXPECT_THROW(require_consistent(bad), Error);
}

// A material of the box is a face of the box, and keeps its plane and side through the chain.
TEST(MeshWithAttributes, MaterialsFollowTheirSourcesThroughChains) {
  const SharedSource a = plain_source(box_mesh({0, 0, 0}, {4, 4, 4}));
  const SharedSource b = plain_source(icosphere_mesh(1, 1.5, {4, 3.9, 3.8}));
  const Nef3 set = (!(!from_source(a) + from_source(b))).regularization();
  const MeshWithAttributes made = mesh_with_attributes(set.closure());
  expect_complete(made, 2);
  ASSERT_EQ(made.attributes.materials.size(), 6U + 80U);
  for (std::size_t f = 0; f < made.mesh.face_count(); ++f) {
    const std::uint32_t first = made.source[f].source == 0 ? 0 : 6;
    EXPECT_EQ(made.attributes.face_material[f], first + made.source[f].face);
    EXPECT_EQ(made.source[f].is_flipped, made.source[f].source == 1);
  }
}

// ---------------------------------------------------------------- polygons

/// Returns twice the vector area of a face.
Point3 vector_area(const PolygonMesh& mesh, std::size_t f) {
  const auto face = mesh.face(f);
  Point3 sum{};
  for (std::size_t i = 1; i + 1 < face.size(); ++i) {
    const Point3 n = cross({mesh.points[face[0]], mesh.points[face[i]], mesh.points[face[i + 1]]});
    sum = {sum.x + n.x, sum.y + n.y, sum.z + n.z};
  }
  return sum;
}

/// Returns the triangles of each face, as corners of the mesh. Requires faces whose corners are
/// different points.
std::vector<std::vector<std::array<std::uint32_t, 3>>> triangles_of(const PolygonMesh& mesh) {
  const PolygonMesh cut = triangulated(mesh);
  std::vector<std::vector<std::array<std::uint32_t, 3>>> result(mesh.face_count());
  std::size_t next = 0;
  for (std::uint32_t f = 0; f < mesh.face_count(); ++f) {
    const auto face = mesh.face(f);
    for (std::size_t k = 2; k < face.size(); ++k) {
      std::array<std::uint32_t, 3> t{};
      for (std::size_t i = 0; i < 3; ++i) {
        const auto at = std::find(face.begin(), face.end(), cut.face(next)[i]);
        t[i] = mesh.face_begin[f] + static_cast<std::uint32_t>(at - face.begin());
      }
      result[f].push_back(t);
      ++next;
    }
  }
  return result;
}

/// Returns the numbers of a channel at a point of a face, from the triangle that contains the point
/// best.
std::vector<double> numbers_at(const MeshSource& source, const std::string& name, const Point3& p,
                               std::span<const std::array<std::uint32_t, 3>> triangles) {
  const MeshChannel& from = channel(source.attributes, name);
  double best = -1e300;
  std::vector<double> numbers(from.width);
  for (const auto& t : triangles) {
    std::array<Point3, 3> corners{};
    for (std::size_t i = 0; i < 3; ++i) corners[i] = source.mesh.points[source.mesh.corners[t[i]]];
    const std::array<double, 3> weights = weights_in(corners, p);
    const double least = std::min({weights[0], weights[1], weights[2]});
    if (least <= best) continue;
    best = least;
    for (std::uint32_t k = 0; k < from.width; ++k) {
      numbers[k] = 0;
      for (std::size_t i = 0; i < 3; ++i) {
        numbers[k] += weights[i] * from.values[std::size_t{t[i]} * from.width + k];
      }
    }
  }
  EXPECT_GT(best, -1e-9) << "the point is not in the face";
  return numbers;
}

/// Checks the numbers at each corner against the triangles of the source face.
void expect_numbers(const MeshWithAttributes& made, std::span<const SharedSource> sources) {
  std::vector<std::vector<std::vector<std::array<std::uint32_t, 3>>>> triangles;
  for (const SharedSource& source : sources) triangles.push_back(triangles_of(source->mesh));
  for (std::size_t f = 0; f < made.mesh.face_count(); ++f) {
    const FaceSource from = made.source[f];
    ASSERT_NE(from.source, FaceSource::kNone);
    const auto& of_face = triangles[from.source][from.face];
    for (std::uint32_t c = made.mesh.face_begin[f]; c < made.mesh.face_begin[f + 1]; ++c) {
      const Point3& p = made.mesh.points[made.mesh.corners[c]];
      for (const char* name : {"place", "noise"}) {
        const MeshChannel& to = channel(made.attributes, name);
        const auto numbers = numbers_at(*sources[from.source], name, p, of_face);
        for (std::uint32_t k = 0; k < to.width; ++k) {
          EXPECT_NEAR(to.values[std::size_t{c} * to.width + k], numbers[k], 1e-7);
        }
      }
    }
  }
}

/// Checks the numbers inside triangles: a random point of each has the numbers of the source face
/// at this point.
void expect_samples(const MeshWithAttributes& made, std::span<const SharedSource> sources,
                    Dice& dice) {
  std::vector<std::vector<std::vector<std::array<std::uint32_t, 3>>>> triangles;
  for (const SharedSource& source : sources) triangles.push_back(triangles_of(source->mesh));
  const MeshChannel& to = channel(made.attributes, "noise");
  for (std::size_t f = 0; f < made.mesh.face_count(); ++f) {
    const FaceSource from = made.source[f];
    ASSERT_EQ(made.mesh.face(f).size(), 3U);
    const double u = static_cast<double>(1 + dice.below(499)) / 1000, v = u * u;
    const std::array<double, 3> weight{1 - u - v, u, v};
    const std::array<Point3, 3> t = corners_of(made.mesh, f);
    Point3 p{};
    std::array<double, 2> found{};
    for (std::size_t i = 0; i < 3; ++i) {
      p = {p.x + weight[i] * t[i].x, p.y + weight[i] * t[i].y, p.z + weight[i] * t[i].z};
      for (std::size_t k = 0; k < 2; ++k) found[k] += weight[i] * to.values[(3 * f + i) * 2 + k];
    }
    const auto numbers =
        numbers_at(*sources[from.source], "noise", p, triangles[from.source][from.face]);
    EXPECT_NEAR(found[0], numbers[0], 1e-7);
    EXPECT_NEAR(found[1], numbers[1], 1e-7);
  }
}

/// Returns the area of each owner in a mesh of polygons.
std::map<Owner, double> polygon_areas(const MeshWithAttributes& made) {
  std::map<Owner, double> area;
  for (std::size_t f = 0; f < made.mesh.face_count(); ++f) {
    const Point3 n = vector_area(made.mesh, f);
    const std::array<double, 3> c{n.x, n.y, n.z};
    std::size_t axis = 0;
    for (std::size_t i = 1; i < 3; ++i) axis = c[i] != 0 ? i : axis;
    area[{made.source[f].source, made.source[f].is_flipped, axis, c[axis] > 0}] +=
        std::fabs(c[axis]) / 2;
  }
  return area;
}

// Cubes with faces of four corners, written as polygons: areas of sources are exact, and so are the
// numbers at corners.
TEST(MeshWithAttributes, PolygonsOfCubesHaveExactAreas) {
  std::size_t polygons = 0;
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    SCOPED_TRACE(seed);
    Dice dice(seed);
    const CubeScene scene = random_cubes(dice, seed % 3 != 0);
    std::vector<SharedSource> sources;
    Nef3 set;
    for (std::size_t i = 0; i < scene.low.size(); ++i) {
      const auto& low = scene.low[i];
      const Point3 at{static_cast<double>(low[0]), static_cast<double>(low[1]),
                      static_cast<double>(low[2])};
      PolygonMesh box = box_mesh(at, {at.x + kSide, at.y + kSide, at.z + kSide});
      sources.push_back(random_source(std::move(box), dice));
      const Nef3 cube = from_source(sources.back());
      set = i == 0 ? cube : boolean_op(set, cube, scene.op[i]);
    }
    for (const PieceJoin join : {PieceJoin::None, PieceJoin::SameAttributes, PieceJoin::SameFace}) {
      for (const MeshFaces faces : {MeshFaces::Triangles, MeshFaces::PlanarPolygons}) {
        const MeshWithAttributes made =
            mesh_with_attributes(set, {join, CoordinateType::Double, faces});
        expect_complete(made, set.sources().size());
        EXPECT_EQ(polygon_areas(made), squares(scene));
        expect_numbers(made, sources);
        if (faces == MeshFaces::Triangles) expect_samples(made, sources, dice);
        EXPECT_EQ(Nef3::from_mesh(made.mesh), set.regularization());
        for (std::size_t f = 0; f < made.mesh.face_count(); ++f) {
          polygons += made.mesh.face(f).size() > 3 ? 1 : 0;
        }
      }
    }
  }
  EXPECT_GT(polygons, 1000U);
}

/// Returns the corners of each face as coordinates, the least corner first, sorted.
std::vector<std::vector<std::array<double, 3>>> cycles_of(const PolygonMesh& mesh) {
  std::vector<std::vector<std::array<double, 3>>> cycles;
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    std::vector<std::array<double, 3>> cycle;
    for (const std::uint32_t v : mesh.face(f)) {
      cycle.push_back({mesh.points[v].x, mesh.points[v].y, mesh.points[v].z});
    }
    std::rotate(cycle.begin(), std::min_element(cycle.begin(), cycle.end()), cycle.end());
    cycles.push_back(std::move(cycle));
  }
  std::sort(cycles.begin(), cycles.end());
  return cycles;
}

/// Returns a cube of n x n squares on each side.
PolygonMesh grid_of_squares(int n) {
  std::map<std::array<int, 3>, std::uint32_t> index;
  PolygonMesh mesh;
  const auto point = [&](const std::array<int, 3>& at) {
    const auto [known, is_new] = index.emplace(at, mesh.points.size());
    if (is_new) mesh.points.push_back({double(at[0]), double(at[1]), double(at[2])});
    return known->second;
  };
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (int side = 0; side < 2; ++side) {
      for (int i = 0; i < n * n; ++i) {
        std::array<std::uint32_t, 4> face{};
        for (std::size_t k = 0; k < 4; ++k) {
          std::array<int, 3> at{};
          at[axis] = side * n;
          at[(axis + 1) % 3] = i % n + (k == 1 || k == 2 ? 1 : 0);
          at[(axis + 2) % 3] = i / n + (k >= 2 ? 1 : 0);
          face[side == 1 ? k : 3 - k] = point(at);
        }
        mesh.add_face(face);
      }
    }
  }
  return mesh;
}

// Faces that nothing touches are the faces of the input, with the numbers of their corners, even if
// these do not lie on one affine function.
TEST(MeshWithAttributes, UntouchedFacesStay) {
  Dice dice(5);
  const AttributeOptions options{PieceJoin::SameFace, CoordinateType::Double,
                                 MeshFaces::PlanarPolygons};
  const SharedSource box = random_source(box_mesh({0, 0, 0}, {3, 4, 5}), dice);
  const std::array alone{box};
  const MeshWithAttributes made = mesh_with_attributes(from_source(box), options);
  EXPECT_EQ(cycles_of(made.mesh), cycles_of(box->mesh));
  expect_numbers(made, alone);

  // Squares in one plane stay apart if their channels are affine over each of them.
  MeshSource squares{"squares", grid_of_squares(3), {}};
  MeshChannel place{"place", 3, {}};
  for (const std::uint32_t v : squares.mesh.corners) {
    const Point3& p = squares.mesh.points[v];
    place.values.insert(place.values.end(), {p.x, p.y, p.z});
  }
  squares.attributes.channels = {place};
  const auto shared = std::make_shared<const MeshSource>(std::move(squares));
  const Nef3 grid = from_source(shared);
  EXPECT_EQ(cycles_of(mesh_with_attributes(grid, options).mesh), cycles_of(shared->mesh));
  const AttributeOptions joined{PieceJoin::SameAttributes, CoordinateType::Double,
                                MeshFaces::PlanarPolygons};
  EXPECT_EQ(mesh_with_attributes(grid, joined).mesh.face_count(), 6U);

  // A far smaller cube takes away a corner; the squares that it does not touch stay.
  const Nef3 corner = from_source(plain_source(box_mesh({2.5, 2.5, 2.5}, {4, 4, 4})));
  const auto before = cycles_of(shared->mesh);
  const auto after = cycles_of(mesh_with_attributes(grid - corner, options).mesh);
  std::vector<std::vector<std::array<double, 3>>> same;
  std::set_intersection(before.begin(), before.end(), after.begin(), after.end(),
                        std::back_inserter(same));
  EXPECT_EQ(same.size(), before.size() - 3);
}

// A polygon gets a vertex inside an edge from a cut that ends there. Its numbers do not change.
TEST(MeshWithAttributes, PolygonsOfSpheresAndBoxesHaveTheNumbersOfTheirFaces) {
  for (std::uint64_t seed = 0; seed < 12; ++seed) {
    SCOPED_TRACE(seed);
    Dice dice(seed);
    const auto coordinate = [&] { return static_cast<double>(dice.between(0, 4000)) / 1013; };
    std::vector<SharedSource> sources{random_source(grid_of_squares(4), dice),
                                      random_source(box_mesh({1, 1, 2}, {5, 3, 6}), dice)};
    sources.push_back(
        random_source(icosphere_mesh(1, 1.7, {coordinate(), coordinate(), coordinate()}), dice));
    const Nef3 set = from_source(sources[0]) + from_source(sources[1]) - from_source(sources[2]);
    for (const PieceJoin join : {PieceJoin::SameAttributes, PieceJoin::SameFace}) {
      for (const MeshFaces faces : {MeshFaces::PlanarPolygons, MeshFaces::Triangles}) {
        const MeshWithAttributes made =
            mesh_with_attributes(set, {join, CoordinateType::Double, faces});
        expect_complete(made, 3);
        expect_numbers(made, sources);
        if (faces == MeshFaces::Triangles) expect_samples(made, sources, dice);
        MeshReport report;
        FromMeshOptions options;
        options.report = &report;
        const Nef3 read = Nef3::from_mesh(made.mesh, options);
        EXPECT_FALSE(report.crosses_itself());
        EXPECT_TRUE(report.not_planar.empty());
        EXPECT_NEAR(static_cast<double>(*read.volume()), static_cast<double>(*set.volume()), 1e-9);
      }
    }
  }
}

// from_mesh() cuts a polygon that is not planar into triangles. Each of them knows its face.
TEST(MeshWithAttributes, PolygonsThatAreNotPlanarHaveASource) {
  for (std::uint64_t seed = 0; seed < 30; ++seed) {
    SCOPED_TRACE(seed);
    Dice dice(seed);
    PolygonMesh mesh = grid_of_squares(2);
    for (Point3& p : mesh.points) {
      p.x += static_cast<double>(dice.below(8)) / 32;
      p.y += static_cast<double>(dice.below(8)) / 32;
      p.z += static_cast<double>(dice.below(8)) / 32;
    }
    const SharedSource source = random_source(mesh, dice);
    const Nef3 warped = from_source(source);
    for (const AffineMap3& map : {turn_map(1), AffineMap3(turn_map(-2))}) {
      for (const Nef3& set : {warped, warped.transformed(map)}) {
        const Nef3 half = set * Nef3::half_space({1, 2, 3, -7}, Boundary::Closed);
        const MeshWithAttributes whole = mesh_with_attributes(set);
        const MeshWithAttributes cut = mesh_with_attributes(half);
        EXPECT_EQ(whole.run_begin[1], whole.mesh.face_count());
        double without = 0;
        for (std::size_t f = cut.run_begin[1]; f < cut.mesh.face_count(); ++f) {
          const Point3 n = vector_area(cut.mesh, f);
          without += std::sqrt(dot(n, n)) / 2;
          EXPECT_NEAR(std::fabs(n.x + 2 * n.y + 3 * n.z), std::sqrt(14 * dot(n, n)), 1e-9);
        }
        EXPECT_GT(without, 0);
      }
    }
    const MeshWithAttributes made = mesh_with_attributes(warped);
    for (std::size_t f = 0; f < made.mesh.face_count(); ++f) {
      const auto face = source->mesh.face(made.source[f].face);
      for (std::uint32_t c = made.mesh.face_begin[f]; c < made.mesh.face_begin[f + 1]; ++c) {
        const Point3& p = made.mesh.points[made.mesh.corners[c]];
        const auto at = std::find_if(face.begin(), face.end(),
                                     [&](std::uint32_t v) { return source->mesh.points[v] == p; });
        ASSERT_NE(at, face.end()) << "a corner is none of its face";
        const auto corner = source->mesh.face_begin[made.source[f].face] +
                            static_cast<std::size_t>(at - face.begin());
        for (std::size_t k = 0; k < 2; ++k) {
          EXPECT_EQ(channel(made.attributes, "noise").values[2 * c + k],
                    channel(source->attributes, "noise").values[2 * corner + k]);
        }
      }
    }
  }
}

/// Returns a block with a hole from top to bottom. Its top and its bottom are polygons with a
/// bridge to the hole, whose ends are corners twice.
PolygonMesh block_with_bridges() {
  PolygonMesh mesh;
  for (const double z : {0.0, 1.0}) {
    for (const double r : {4.0, 1.0}) {
      mesh.points.insert(
          mesh.points.end(),
          {{5 - r, 5 - r, z}, {5 + r, 5 - r, z}, {5 + r, 5 + r, z}, {5 - r, 5 + r, z}});
    }
  }
  const std::array<std::uint32_t, 10> top{8, 9, 10, 11, 8, 12, 15, 14, 13, 12};
  std::array<std::uint32_t, 10> bottom{};
  for (std::size_t i = 0; i < 10; ++i) bottom[9 - i] = top[i] - 8;
  mesh.add_face(top);
  mesh.add_face(bottom);
  for (std::uint32_t i = 0; i < 4; ++i) {
    const std::uint32_t j = (i + 1) % 4;
    mesh.add_face(std::array{i, j, j + 8, i + 8});
    mesh.add_face(std::array{j + 4, i + 4, i + 12, j + 12});
  }
  return mesh;
}

// Numbers on an edge of the block are linear between its ends, whatever triangles its top has.
TEST(MeshWithAttributes, PolygonsWithBridgesKeepTheNumbersOfTheirEdges) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    SCOPED_TRACE(seed);
    Dice dice(seed);
    MeshSource source{"block", block_with_bridges(), {}};
    std::vector<double> at_point;
    for (std::size_t v = 0; v < 16; ++v) at_point.push_back(static_cast<double>(dice.below(100)));
    MeshChannel noise{"noise", 1, {}};
    for (const std::uint32_t v : source.mesh.corners) noise.values.push_back(at_point[v]);
    source.attributes.channels = {noise};
    const auto shared = std::make_shared<const MeshSource>(std::move(source));
    const double a = static_cast<double>(dice.between(1, 9)),
                 b = static_cast<double>(dice.between(-9, 9));
    const Nef3 set =
        from_source(shared) * Nef3::half_space({a, b, 0, -5 * (a + b)}, Boundary::Closed);
    const MeshWithAttributes made = mesh_with_attributes(set);
    const MeshChannel& found = channel(made.attributes, "noise");
    std::size_t checked = 0;
    for (std::uint32_t f = 0; f < made.run_begin[1]; ++f) {
      for (std::uint32_t c = 3 * f; c < 3 * (f + 1); ++c) {
        const Point3& p = made.mesh.points[made.mesh.corners[c]];
        for (std::uint32_t ring = 0; ring < 4; ++ring) {
          for (std::uint32_t i = 0; i < 4; ++i) {
            const std::uint32_t v = 4 * ring + i, w = 4 * ring + (i + 1) % 4;
            const Point3 &from = shared->mesh.points[v], &to = shared->mesh.points[w];
            const Point3 u{to.x - from.x, to.y - from.y, to.z - from.z};
            const Point3 x{p.x - from.x, p.y - from.y, p.z - from.z};
            const double t = dot(u, x) / dot(u, u);
            const Point3 off{x.x - t * u.x, x.y - t * u.y, x.z - t * u.z};
            if (dot(off, off) > 1e-20 || t < 0 || t > 1) continue;
            EXPECT_NEAR(found.values[c], (1 - t) * at_point[v] + t * at_point[w], 1e-9);
            ++checked;
          }
        }
      }
    }
    EXPECT_GT(checked, 20U);
  }
}

// Corners that are written as floats are corners of their source nevertheless.
TEST(MeshWithAttributes, FloatsKeepTheNumbersOfCorners) {
  Dice dice(9);
  const SharedSource sphere = random_source(icosphere_mesh(2, 1, {0.1, 0.2, 0.3}), dice);
  const Nef3 set =
      from_source(sphere) - from_source(random_source(box_mesh({0, 0, 0}, {2, 2, 2}), dice));
  const MeshWithAttributes made = mesh_with_attributes(
      set, {PieceJoin::SameAttributes, CoordinateType::Float, MeshFaces::Triangles});
  const MeshChannel& to = channel(made.attributes, "noise");
  const MeshChannel& from = channel(sphere->attributes, "noise");
  std::size_t copied = 0;
  for (std::uint32_t f = 0; f < made.run_begin[1]; ++f) {
    const std::uint32_t face = made.source[f].face;
    for (std::uint32_t c = 3 * f; c < 3 * (f + 1); ++c) {
      const Point3& p = made.mesh.points[made.mesh.corners[c]];
      for (std::uint32_t k = 3 * face; k < 3 * (face + 1); ++k) {
        const Point3& q = sphere->mesh.points[sphere->mesh.corners[k]];
        const Point3 near{static_cast<float>(q.x), static_cast<float>(q.y),
                          static_cast<float>(q.z)};
        if (near != p) continue;
        ++copied;
        EXPECT_EQ(to.values[2 * c], from.values[2 * k]);
        EXPECT_EQ(to.values[2 * c + 1], from.values[2 * k + 1]);
      }
    }
  }
  EXPECT_GT(copied, 500U);
}

// ---------------------------------------------------------------- lists of sources

TEST(MeshWithAttributes, ListsOfSourcesHaveNoDuplicates) {
  const SharedSource a = plain_source(box_mesh({0, 0, 0}, {2, 2, 2}));
  const SharedSource b = plain_source(box_mesh({1, 1, 1}, {3, 3, 3}));
  const Nef3 set_a = from_source(a), set_b = from_source(b);
  const auto names = [](const Nef3& set) {
    std::vector<const MeshSource*> list;
    for (const PlacedSource& s : set.sources()) list.push_back(s.source.get());
    return list;
  };
  const std::vector<const MeshSource*> ab{a.get(), b.get()}, ba{b.get(), a.get()};
  EXPECT_EQ(names(set_a + set_b), ab);
  EXPECT_EQ(names(set_b - set_a), ba);
  EXPECT_EQ(names((set_a + set_b) * set_a), ab);
  const std::array<Nef3, 4> sets{set_b, set_a, set_b, set_a};
  EXPECT_EQ(names(union_of(sets)), ba);
  EXPECT_EQ(names(intersection_of(sets)), ba);
  EXPECT_EQ(names(difference_of(set_a, sets)), ab);
  EXPECT_EQ((set_a + set_a.translated({1, 0, 0})).sources().size(), 2U);
  EXPECT_EQ((set_a + set_a.translated({1, 0, 0}).translated({-1, 0, 0})).sources().size(), 1U);
  EXPECT_EQ(set_a, Nef3::from_mesh(a->mesh));
  EXPECT_TRUE(set_a.with_sources({}).sources().empty());
  EXPECT_EQ(names((!!set_a).interior().closure().boundary().exterior()), names(set_a));
}

TEST(MeshWithAttributes, SetsWithoutSourcesGiveTheValidMesh) {
  const Nef3 set = Nef3::from_mesh(icosphere_mesh(2, 1, {0, 0, 0})) +
                   Nef3::from_mesh(box_mesh({0, 0, 0}, {1, 1, 1}));
  const MeshWithAttributes made = mesh_with_attributes(set);
  expect_complete(made, 0);
  EXPECT_TRUE(made.attributes.empty());
  EXPECT_EQ(made.mesh.face_count(),
            valid_mesh(set, {.faces = MeshFaces::Triangles}).made.mesh.face_count());
}

TEST(MeshWithAttributes, RejectsWhatDoesNotFit) {
  const auto is_rejected = [](MeshSource source) {
    try {
      static_cast<void>(from_source(std::make_shared<const MeshSource>(std::move(source))));
    } catch (const Error& error) {
      return error.code() == ErrorCode::BadArgument;
    }
    return false;
  };
  const PolygonMesh box = box_mesh({0, 0, 0}, {1, 1, 1});
  const std::vector<double> values(box.corners.size());
  const auto with = [&](const auto& change) {
    MeshSource source{"", box, {}};
    change(source.attributes);
    return source;
  };
  using Attributes = MeshAttributes;
  EXPECT_TRUE(is_rejected(with([&](Attributes& a) { a.channels = {{"a", 2, values}}; })));
  EXPECT_TRUE(is_rejected(with([&](Attributes& a) { a.channels = {{"a", 0, {}}}; })));
  EXPECT_TRUE(is_rejected(with([&](Attributes& a) {
    a.channels = {{"a", 1, values}, {"a", 1, values}};
  })));
  EXPECT_TRUE(is_rejected(with([&](Attributes& a) { a.face_material = {0, 0, 0, 0, 0, 0}; })));
  EXPECT_TRUE(is_rejected(with([&](Attributes& a) { a.face_id = {1, 2}; })));
  EXPECT_FALSE(is_rejected(with([&](Attributes& a) { a.channels = {{"a", 1, values}}; })));
  EXPECT_THROW(static_cast<void>(from_source(nullptr)), Error);
  EXPECT_THROW(static_cast<void>(mesh_with_attributes(Nef3::whole())), Error);
}

// ---------------------------------------------------------------- repairs

/// Checks that each corner of a face is near its source triangle: neither farther from its plane
/// nor farther beyond its edges than the repair moved the boundary, up to the roundings of this
/// test.
void expect_near_sources(const MeshWithAttributes& made, std::span<const SharedSource> sources) {
  for (std::size_t f = 0; f < made.mesh.face_count(); ++f) {
    const FaceSource from = made.source[f];
    ASSERT_NE(from.source, FaceSource::kNone);
    const std::array<Point3, 3> t = corners_of(sources[from.source]->mesh, from.face);
    const Point3 n = cross(t);
    const double length = std::sqrt(dot(n, n));
    for (const std::uint32_t v : made.mesh.face(f)) {
      const Point3& p = made.mesh.points[v];
      const double off = dot(n, {p.x - t[0].x, p.y - t[0].y, p.z - t[0].z}) / length;
      const double most = 2 * made.repair.largest_move + 1e-9;
      EXPECT_LE(std::fabs(off), most);
      for (std::size_t i = 0; i < 3; ++i) {
        const Point3 &a = t[i], &b = t[(i + 1) % 3];
        const Point3 inward = cross({Point3{0, 0, 0}, n, {b.x - a.x, b.y - a.y, b.z - a.z}});
        const double inside = dot(inward, {p.x - a.x, p.y - a.y, p.z - a.z});
        EXPECT_GE(inside, -most * std::sqrt(dot(inward, inward)));
      }
    }
  }
}

// Rounding damages these scenes. The mesh is valid nevertheless, and numbers stay between those of
// the corners of the source triangle.
TEST(MeshWithAttributes, RepairedMeshesAreValid) {
  std::uint64_t repaired = 0;
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    SCOPED_TRACE(seed);
    Dice dice(seed);
    std::vector<SharedSource> sources;
    const std::vector<std::uint8_t> bytes = testing::random_near_solids(dice, 3);
    Nef3 set;
    for (std::size_t at = 0; at + testing::kNearSolidRecord <= bytes.size();
         at += testing::kNearSolidRecord) {
      const std::span record = std::span(bytes).subspan(at, testing::kNearSolidRecord);
      const Nef3 next = testing::apply_near_solid(Nef3::empty(), record);
      if (next.is_empty()) continue;
      sources.push_back(
          random_source(next.to_polygons({.faces = MeshFaces::Triangles}).mesh, dice));
      set = boolean_op(set, from_source(sources.back()),
                       at == 0 || dice.below(2) == 0 ? kUnion : kDifference);
    }
    const MeshWithAttributes made = mesh_with_attributes(set, {.join = PieceJoin::None});
    expect_complete(made, set.sources().size());
    repaired += made.repair.rounds > 0 ? 1 : 0;
    MeshReport report;
    FromMeshOptions options;
    options.report = &report;
    static_cast<void>(Nef3::from_mesh(made.mesh, options));
    EXPECT_FALSE(report.crosses_itself());
    EXPECT_TRUE(report.degenerate.empty());
    expect_near_sources(made, sources);
    if (made.mesh.face_count() == 0) continue;
    for (const double value : channel(made.attributes, "noise").values) {
      EXPECT_GE(value, 0);
      EXPECT_LE(value, 99.000001);
    }
  }
  EXPECT_GT(repaired, 0U);
}

}  // namespace
}  // namespace plumb::mesh_with_attributes_test
