// How operations on sets of space grow, family by family (growth.h says how it is measured). The
// chain of subtractions fails, too, when a plane of its result has a coefficient of more than 160
// bits: Booleans add no planes.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <memory>
#include <stdexcept>
#include <utility>
#include <vector>

#include "generate/mesh_solid.h"
#include "generate/meshes.h"
#include "generate/voxel_mesh.h"
#include "growth.h"
#include "plumb/predicates/error.h"
#include "plumb/space/nef3.h"
#include "plumb/space/to_mesh.h"
#include "plumb/testing/dice.h"

namespace plumb::bench {
namespace {

using testing::Dice;
using testing::solid;

/// Unit cubes two apart, size^3 of them.
std::vector<Nef3> separated_cubes(std::size_t size) {
  std::vector<Nef3> sets;
  for (std::size_t i = 0; i < size * size * size; ++i) {
    const Point3 low{2.0 * static_cast<double>(i % size),
                     2.0 * static_cast<double>(i / size % size),
                     2.0 * static_cast<double>(i / size / size)};
    sets.push_back(solid(testing::box_mesh(low, {low.x + 1, low.y + 1, low.z + 1})));
  }
  return sets;
}

/// n thin tetrahedra along a diagonal, so that the boxes of all overlap.
Nef3 needles(std::size_t n, double shift) {
  PolygonMesh mesh;
  const double far = 64;
  for (std::size_t i = 0; i < n; ++i) {
    const double x = static_cast<double>(i % 32) * 4 + shift;
    const double y = static_cast<double>(i / 32) * 4 + shift;
    const auto first = static_cast<std::uint32_t>(mesh.points.size());
    mesh.points.push_back({x, -x + y, y});
    mesh.points.push_back({x + 1, -x + y, y});
    mesh.points.push_back({x, -x + y + 1, y});
    mesh.points.push_back({x + far * 16, -x + y + far * 16, y + far * 16});
    for (const auto& [a, b, c] :
         {std::array<std::uint32_t, 3>{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}) {
      mesh.add_face(std::array{first + a, first + b, first + c});
    }
  }
  return solid(mesh);
}

/// Tangent planes of a sphere, their normals anywhere.
std::vector<HalfSpace3> tangent_planes(std::size_t n) {
  Dice dice(1);
  std::vector<HalfSpace3> result;
  while (result.size() < n) {
    const std::int64_t a = dice.between(-1000000, 1000000);
    const std::int64_t b = dice.between(-1000000, 1000000);
    const std::int64_t c = dice.between(-1000000, 1000000);
    const double length = std::sqrt(static_cast<double>(a * a + b * b + c * c));
    if (length < 100000 || length > 1000000) continue;
    result.push_back({{a, b, c, -static_cast<std::int64_t>(256 * length)}, Boundary::Closed});
  }
  return result;
}

/// Square columns, a width apart, through the plate that they leave holes in.
PolygonMesh columns(std::size_t size) {
  PolygonMesh mesh;
  for (std::size_t i = 0; i < size * size; ++i) {
    const double x = 2 * static_cast<double>(i % size) + 1;
    const double y = 2 * static_cast<double>(i / size) + 1;
    mesh = testing::joined(std::move(mesh), testing::box_mesh({x, y, -1}, {x + 1, y + 1, 2}));
  }
  return mesh;
}

/// Times `make`, which is given a context.
template <class Make>
Work made(std::size_t size, Make make) {
  return measured(static_cast<double>(size), [make = std::move(make)] {
    Context context;
    return make(context);
  });
}

Work united_cubes(std::size_t side) {
  return made(side * side * side, [cubes = separated_cubes(side)](Context& context) {
    return union_of(cubes, context);
  });
}

Work cubes_one_by_one(std::size_t side) {
  return made(side * side * side, [cubes = separated_cubes(side)](Context& context) {
    Nef3 all;
    for (const Nef3& cube : cubes) all = boolean_op(std::move(all), cube, kUnion, context);
    return all;
  });
}

Work united_needles(std::size_t n) {
  return made(n, [a = needles(n, 0), b = needles(n, 2)](Context& context) {
    return boolean_op(a, b, kUnion, context);
  });
}

Work hull_of_half_spaces(std::size_t n) {
  return made(n, [planes = tangent_planes(n)](Context& context) {
    return Nef3::intersection(planes, context);
  });
}

std::vector<Nef3> half_spaces(std::size_t n) {
  std::vector<Nef3> sets;
  for (const HalfSpace3& h : tangent_planes(n))
    sets.push_back(Nef3::half_space(h.plane, h.boundary));
  return sets;
}

Work half_spaces_one_by_one(std::size_t n) {
  return made(n, [sets = half_spaces(n)](Context& context) {
    Nef3 all = Nef3::whole();
    for (const Nef3& set : sets) all = boolean_op(std::move(all), set, kIntersection, context);
    return all;
  });
}

Nef3 parity_of(const std::vector<Nef3>& sets, Context& context) {
  std::vector<Nef3> level = sets;
  while (level.size() > 1) {
    std::vector<Nef3> pairs;
    for (std::size_t i = 0; i + 1 < level.size(); i += 2) {
      pairs.push_back(boolean_op(level[i], level[i + 1], kSymmetricDifference, context));
    }
    if (level.size() % 2 == 1) pairs.push_back(level.back());
    level = std::move(pairs);
  }
  return std::move(level.front());
}

/// Any three of the planes meet in a vertex of the result, however it is computed.
Work half_space_parity(std::size_t n) {
  const std::vector<Nef3> sets = half_spaces(n);
  Context own;
  const std::size_t vertices = parity_of(sets, own).counts().vertices;
  if (vertices != n * (n - 1) * (n - 2) / 6) throw std::runtime_error("vertices are missing");
  return made(vertices, [sets](Context& context) { return parity_of(sets, context); });
}

Work complement_and_interior(std::size_t depth) {
  const Nef3 ball = solid(testing::icosphere_mesh(static_cast<int>(depth), 1, {0, 0, 0}));
  const SpaceCounts counts = ball.counts();
  return made(counts.vertices + counts.edges + counts.facets,
              [ball](Context&) { return (!ball).interior(); });
}

/// Two spheres that cross, each of 20 * 4^depth triangles.
std::array<PolygonMesh, 2> crossing_spheres(std::size_t depth) {
  const int d = static_cast<int>(depth);
  return {testing::icosphere_mesh(d, 1, {0, 0, 0}),
          testing::icosphere_mesh(d, 1, {0.5, 0.25, 0.125})};
}

PolygonMesh triangles_of(const Nef3& set, Context& context) {
  return mesh_of_complex(set.complex(), {MeshFaces::Triangles, false, false}, context).mesh;
}

Work triangles_of_union(std::size_t depth) {
  const auto [a, b] = crossing_spheres(depth);
  const Nef3 both = solid(a) + solid(b);
  return made(both.complex().facet_count(),
              [both](Context& context) { return triangles_of(both, context); });
}

/// Two meshes become sets, these one, and that triangles.
Work whole_path(std::size_t depth) {
  const auto meshes = std::make_shared<const std::array<PolygonMesh, 2>>(crossing_spheres(depth));
  return made((*meshes)[0].face_count() + (*meshes)[1].face_count(), [meshes](Context& context) {
    return triangles_of(
        boolean_op(Nef3::from_mesh((*meshes)[0], {.rule = WindingRule::Positive}, context),
                   Nef3::from_mesh((*meshes)[1], {.rule = WindingRule::Positive}, context), kUnion,
                   context),
        context);
  });
}

/// 1,000 points anywhere in a box around a ball; `ask(ball, point)`. The locator is made before.
template <class Ask>
Work asked_in_ball(std::size_t depth, Ask ask) {
  const Nef3 ball = solid(testing::icosphere_mesh(static_cast<int>(depth), 1, {0, 0, 0}));
  Dice dice(7);
  const auto coordinate = [&] {
    return 1e-6 * static_cast<double>(dice.between(-1200000, 1200000));
  };
  std::vector<Point3> points;
  for (int i = 0; i < 1000; ++i) {
    const double x = coordinate(), y = coordinate();
    points.push_back({x, y, coordinate()});
  }
  static_cast<void>(ball.contains(points[0]));
  return made(ball.complex().facet_count(), [ball, points, ask](Context&) {
    return std::ranges::count_if(points, [&](const Point3& p) { return ask(ball, p); });
  });
}
Work locate_in_ball(std::size_t depth) {
  return asked_in_ball(depth, [](const Nef3& in, const Point3& p) { return in.contains(p); });
}
Work shoot_in_ball(std::size_t depth) {
  return asked_in_ball(depth, [](const Nef3& in, const Point3& p) {
    const RationalPoint3 from{Rational(p.x), Rational(p.y), Rational(p.z)};
    return in.shoot_to_boundary(from, {3, 2, 1}).has_value();
  });
}

/// Two facets with all holes, and as many facets in these.
Work columns_and_slab(std::size_t size) {
  const double side = 2 * static_cast<double>(size) + 1;
  return made(size * size, [slab = solid(testing::box_mesh({0, 0, 0}, {side, side, 1})),
                            all = solid(columns(size))](Context& context) {
    return boolean_op(slab, all, kSymmetricDifference, context);
  });
}

/// Every corner of one plate is looked for in a large facet of the other.
Work plates(std::size_t size) {
  const PolygonMesh mesh = testing::voxel_mesh(testing::pierced_plate(static_cast<int>(size)));
  return made(size * size,
              [plate = solid(mesh), other = solid(testing::moved(mesh, {0.5, 0.25, 0}))](
                  Context& context) { return boolean_op(plate, other, kUnion, context); });
}

Work set_of_mesh(std::size_t size, PolygonMesh of) {
  return made(size, [mesh = std::move(of)](Context& context) {
    return Nef3::from_mesh(mesh, {.rule = WindingRule::Positive}, context);
  });
}

/// Two facets with all corners, and thin walls in all directions.
Work star_mesh(std::size_t tips) {
  return set_of_mesh(tips, testing::star_prism(static_cast<int>(tips)));
}

/// Two vertices with all triangles.
Work cone_mesh(std::size_t sides) {
  return set_of_mesh(sides, testing::cone_mesh(static_cast<int>(sides), 1));
}

/// The union of two cones whose thin sides run in all directions, so that boxes along any one set
/// of axes nearly all overlap.
Work crossing_cones(std::size_t sides) {
  const PolygonMesh mesh = testing::cone_mesh(static_cast<int>(sides), 1);
  return made(sides,
              [cone = solid(mesh), other = solid(testing::moved(mesh, {0.125, 0.03125, 0.125}))](
                  Context& context) { return boolean_op(cone, other, kUnion, context); });
}

/// Two facets whose triangles meet in few vertices.
Work comb_mesh(std::size_t teeth) {
  return set_of_mesh(teeth, testing::comb_prism(static_cast<int>(teeth)));
}

/// Triangles of which no two share a vertex, with corners anywhere in a cube: every edge is a
/// border, and its box contains many of the other vertices.
Work triangle_soup(std::size_t triangles) {
  Dice dice(7);
  PolygonMesh mesh;
  const auto draw = [&] { return static_cast<double>(dice.between(-1'000'000, 1'000'000)); };
  for (std::uint32_t i = 0; i < 3 * triangles; ++i) mesh.points.push_back({draw(), draw(), draw()});
  for (std::uint32_t i = 0; i < mesh.points.size(); i += 3) {
    mesh.add_face(std::array{i, i + 1, i + 2});
  }
  return measured(static_cast<double>(triangles), [mesh = std::move(mesh)] {
    Context context;
    return complex_of_mesh(mesh, {}, context).report.borders.size();
  });
}

/// The largest coefficient of a plane of the set, in bits.
std::size_t most_bits(const Nef3& set) {
  std::size_t most = 0;
  const SpaceComplex& c = set.complex();
  for (const PlaneId p : c.facet_plane) {
    for (const Integer& x : c.planes().primitive(p)) {
      if (x != 0) most = std::max<std::size_t>(most, msb(abs(x)) + 1);
    }
  }
  return most;
}

struct Drilled {
  Nef3 block;
  std::size_t facets_written = 0;
};

/// A drill moves through a block.
Drilled drilled(const std::vector<Nef3>& drills, Context& context) {
  Drilled result{solid(testing::box_mesh({0, 0, 0}, {1000, 100, 100}))};
  for (const Nef3& drill : drills) {
    result.block = boolean_op(std::move(result.block), drill, kDifference, context);
    result.facets_written += result.block.complex().facet_count();
  }
  return result;
}

Work drill(std::size_t steps) {
  std::vector<Nef3> drills;
  for (std::size_t i = 0; i < steps; ++i) {
    const double x = 3.25 + 4.75 * static_cast<double>(i);
    drills.push_back(solid(testing::icosphere_mesh(2, 7, {x, 50.5, 97.25})));
  }
  Context own;
  const Drilled once = drilled(drills, own);
  if (most_bits(once.block) > 160) throw std::runtime_error("a plane of more than 160 bits");
  return made(once.facets_written,
              [drills = std::move(drills)](Context& context) { return drilled(drills, context); });
}

const std::vector<Family> kFamilies{
    {"separated-cubes",
     "union_of, O((n + k) log n)",
     "cubes",
     {1, 1},
     {5, 7, 10, 13, 17, 24},
     united_cubes,
     1.2},
    {"cubes-one-by-one",
     "n unions, each of which looks at n boxes",
     "cubes",
     {2, 0},
     {3, 5, 6, 7, 10, 14},
     cubes_one_by_one,
     1.6},
    {"needles",
     "Boolean of sets whose boxes along the axes all overlap",
     "needles",
     {1, 1},
     {40, 100, 250, 630, 1600, 4000},
     united_needles,
     1.3},
    {"half-spaces-intersection",
     "n half-spaces, O(n^2) or O(n log n) in the note on Nef polyhedra",
     "half-spaces",
     {1, 1},
     {160, 400, 1000, 2500, 6400, 16000},
     hull_of_half_spaces,
     1.3},
    {"half-spaces-one-by-one",
     "the same, one after the other",
     "half-spaces",
     {2, 0},
     {5, 12, 30, 80, 200, 500},
     half_spaces_one_by_one,
     2.2},
    {"half-spaces-parity",
     "the symmetric difference of 8 to 48 half-spaces: its size is cubic",
     "vertices of the result",
     {1, 1},
     {8, 12, 16, 24, 32, 48},
     half_space_parity,
     1.25},
    {"columns-through-a-slab",
     "symmetric difference; two facets with all holes",
     "columns",
     {1, 1},
     {6, 9, 14, 23, 38, 60},
     columns_and_slab,
     1.25},
    {"pierced-plates",
     "union; corners looked for in large facets",
     "holes",
     {1, 1},
     {5, 8, 12, 20, 32, 50},
     plates,
     1.25},
    {"star-prisms",
     "a set of a mesh, thin walls in all directions",
     "tips",
     {1, 1},
     {160, 400, 1000, 2500, 6400, 16000},
     star_mesh,
     1.25},
    {"cones",
     "a set of a mesh, two vertices with n triangles",
     "sides",
     {1, 1},
     {160, 400, 1000, 2500, 6400, 16000},
     cone_mesh,
     1.25},
    {"crossing-cones",
     "union of two cones; the boxes of their sides nearly all overlap",
     "sides",
     {1, 1},
     {160, 400, 1000, 2500, 6400, 16000},
     crossing_cones,
     1.25},
    {"comb-prisms",
     "a set of a mesh, two facets whose triangles share few vertices",
     "teeth",
     {1, 1},
     {40, 100, 250, 630, 1600, 4000},
     comb_mesh,
     1.25},
    {"triangle-soup",
     "large triangles that share no vertex: a mesh refused with all its borders",
     "triangles",
     {1.34, 0},
     {160, 400, 1000, 2500, 6400, 16000},
     triangle_soup},
    {"complement-interior",
     "complement and interior, O(n) in the note on Nef polyhedra",
     "items",
     {1, 0},
     {1, 2, 3, 4, 5, 6},
     complement_and_interior,
     1.15},
    {"triangles-of-union",
     "conversion to a mesh, O(n) in the note on Nef polyhedra",
     "facets",
     {1, 1},
     {1, 2, 3, 4, 5, 6},
     triangles_of_union,
     1.15},
    {"meshes-to-triangles",
     "the whole path: two meshes become sets, these one, that triangles",
     "triangles",
     {1, 1},
     {2, 3, 4, 5, 6, 7},
     whole_path,
     1.15},
    {"ball-locate",
     "1,000 points; O(n) a point in the note on Nef polyhedra",
     "facets",
     {0, 1},
     {1, 2, 3, 4, 5, 6},
     locate_in_ball,
     0.3},
    {"ball-shoot",
     "1,000 rays; a question to every facet would be O(n) a ray",
     "facets",
     {0, 1},
     {1, 2, 3, 4, 5, 6},
     shoot_in_ball,
     0.3},
    {"drill",
     "a chain of subtractions, linear in what is written",
     "facets written",
     {1, 0},
     {5, 10, 20, 40, 80, 160},
     drill,
     1.15},
};

}  // namespace
}  // namespace plumb::bench

int main(int argc, char** argv) {
  return plumb::bench::growth_main("Growth of operations on sets of space", plumb::bench::kFamilies,
                                   argc, argv);
}
