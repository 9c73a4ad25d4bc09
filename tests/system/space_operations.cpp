// Sets of space, what is taken out of them, convex pieces and sums.
#include <array>
#include <memory>
#include <string>
#include <vector>

#include "generate/counted_memory.h"
#include "plumb/convex/convexity.h"
#include "plumb/convex/decompose.h"
#include "plumb/convex/minkowski.h"
#include "plumb/convex/walls.h"
#include "plumb/io/mesh_io.h"
#include "plumb/io/solid_io.h"
#include "plumb/space/canonical.h"
#include "plumb/space/local_maps.h"
#include "plumb/space/mesh_arrays.h"
#include "plumb/space/repair_mesh.h"
#include "plumb/space/rounded_mesh.h"
#include "plumb/space/space_audit.h"
#include "plumb/space/space_measure.h"
#include "plumb/space/space_shells.h"
#include "plumb/space/to_mesh.h"
#include "system/digest.h"
#include "system/public_operations.h"

namespace plumb::testing {
namespace {

Nef3 solid(const char* path) {
  Context context;
  return read_solid_file(path, {}, context).set;
}

struct Solids {
  Nef3 block = solid("corpus/solids/l-block.off");
  Nef3 ball = solid("corpus/solids/tetrahedron.off");
  Nef3 unbounded = Nef3::half_space({1, 1, 1, -1}, Boundary::Open);
  std::vector<Nef3> several{block, ball, !ball};
  PolygonMesh mesh;
  std::vector<RationalPoint3> points{{0, 0, 0}, {Rational(1, 3), 1, 0}, {2, 2, 2}};
  std::vector<HalfSpace3> corner{{{1, 0, 0, -1}}, {{0, 1, 0, -1}}, {{1, 1, 1, 4}}};
  std::vector<double> coordinates{0, 0, 0, 1, 0, 0, 0, 1, 0};
  std::vector<std::uint32_t> triangle{0, 1, 2};

  Solids() {
    Context context;
    mesh = read_mesh_file("corpus/solids/tetrahedron.off", {}, {}, context).mesh;
  }
};

std::shared_ptr<const Solids> solids() {
  static const auto made = std::make_shared<const Solids>();
  return made;
}

std::uint64_t inputs() {
  return digest_of(solids()->block) ^ digest_of(solids()->ball) ^ digest_of(solids()->unbounded);
}

std::uint64_t digest_of_pieces(const std::vector<Nef3>& pieces) {
  Digest out;
  for (const Nef3& piece : pieces) out.add(digest_of(piece));
  return out.value();
}

std::uint64_t digest_of_mesh(const PolygonMesh& mesh) {
  Digest out;
  write_mesh(out, mesh, MeshFormat::Obj);
  return out.value();
}

/// An operation that makes a set.
auto set(auto make) {
  return [make](Context& own) { return digest_of(make(own)); };
}

}  // namespace

OperationRoom space_operations() {
  const auto s = solids();
  return {
      "space",
      inputs,
      {
          {"block - ball", set([s](Context&) { return s->block - s->ball; })},
          {"combine",
           set([s](Context& own) { return boolean_op(s->block, !s->ball, kUnion, own); })},
          {"combine with selectors", set([s](Context& own) {
             return boolean_op(s->block, {{}, [](EdgeId) { return false; }, {}, {}}, s->ball, {},
                               kUnion, own);
           })},
          {"combine with a plane", set([s](Context& own) {
             return boolean_op(s->block, {1, 2, 3, -1}, Section::ClosedHalfSpace, kIntersection,
                               own);
           })},
          {"union_of", set([s](Context& own) { return union_of(s->several, own); })},
          {"intersection_of", set([s](Context& own) { return intersection_of(s->several, own); })},
          {"an unbounded operand", set([s](Context&) { return s->unbounded * s->ball; })},
          {"!ball", set([s](Context&) { return !s->ball; })},
          {"boundary", set([s](Context&) { return s->ball.boundary(); })},
          {"interior", set([s](Context&) { return s->ball.interior(); })},
          {"closure", set([s](Context&) { return s->unbounded.closure(); })},
          {"transformed", set([s](Context&) {
             return s->ball.transformed({{{{2, 1, 0}, {0, 1, 0}, {0, 0, 1}}}, {1, 0, 0}});
           })},
          {"half_space", set([](Context&) {
             return Nef3::half_space({1, 2, 3, 4}, {0, 0, 0}, Boundary::Closed);
           })},
          {"plane", set([](Context&) {
             return Nef3::plane({1, 2, 3, 4});
           })},
          {"intersection", set([s](Context& own) { return Nef3::intersection(s->corner, own); })},
          {"mesh", set([s](Context& own) {
             return Nef3::from_mesh(s->mesh, {.rule = WindingRule::NonZero}, own);
           })},
          {"mended mesh", set([s](Context& own) {
             PolygonMesh mesh = s->mesh;
             mesh.points.push_back(mesh.points[mesh.corners[0]]);
             mesh.points.back().x += 1e-9;
             mesh.corners[0] = static_cast<std::uint32_t>(mesh.points.size() - 1);
             repair_mesh(mesh, {.weld = 1e-6, .reorient = true, .fill_holes = 3}, own);
             return Nef3::from_mesh(mesh, {}, own);
           })},
          {"facet", set([](Context&) {
             return Nef3::facet(std::array<Point3, 3>{{{0, 0, 0}, {1, 0, 0}, {0, 1, 1}}});
           })},
          {"segment", set([s](Context&) { return Nef3::segment(s->points[0], s->points[1]); })},
          {"polyline", set([s](Context& own) { return Nef3::polyline(s->points, own); })},
          {"points", set([s](Context& own) { return Nef3::points(s->points, own); })},
          {"from_complex",
           set([s](Context& own) { return Nef3::from_complex(own_copy(s->ball.complex()), own); })},
          {"with_origins", set([s](Context&) {
             return s->ball.with_origins(std::array<std::uint32_t, 4>{{3, 2, 1, 0}});
           })},
          {"with_bounded_volumes",
           set([s](Context&) { return s->ball.boundary().with_bounded_volumes(); })},
          {"canonical", set([s](Context& own) { return canonical(s->block, own); })},
          {"comparisons",
           [s](Context&) {
             return std::uint64_t{s->block.is_subset_of(s->ball)} +
                    2 * std::uint64_t{s->block == s->ball};
           }},
          {"questions",
           [s](Context&) {
             return std::uint64_t{s->block.is_bounded()} + 2 * std::uint64_t{s->block.is_simple()} +
                    4 * std::uint64_t{s->block.is_convex()};
           }},
          {"locate",
           [s](Context&) {
             const Nef3 fresh = !s->block;
             return std::uint64_t{fresh.contains(Point3{1, 1, 1})} +
                    2 * std::uint64_t{fresh.has_on_boundary(Point3{1, 0, 0})};
           }},
          {"shoot",
           [s](Context&) {
             const Nef3 fresh = !s->block;
             return std::uint64_t{fresh.shoot_to_boundary({5, 5, 5}, {-1, -1, -1}).has_value()};
           }},
      }};
}

OperationRoom extraction_operations() {
  const auto s = solids();
  return {
      "extraction",
      inputs,
      {
          {"mesh_of_complex",
           [s](Context& own) {
             return digest_of_mesh(
                 mesh_of_complex(s->block.complex(), {.keeps_exact = true}, own).mesh);
           }},
          {"soup_of_complex",
           [s](Context& own) {
             return digest_of_mesh(soup_of_complex(s->block.complex(), {}, own).mesh);
           }},
          {"mesh_of_sides",
           [s](Context& own) {
             const SpaceComplex& c = s->block.complex();
             return digest_of_mesh(mesh_of_sides(c, boundary_sides(c), {}, own).mesh);
           }},
          {"shells",
           [s](Context& own) {
             const SpaceShells shells(s->block.complex());
             return digest_of_mesh(
                        mesh_of_shell(shells, ShellId(0), ShellSolid::Other, {}, own).mesh) ^
                    digest_of(set_of_shell(s->block, shells, ShellId(0), ShellMarks::All, own));
           }},
          {"measures",
           [s](Context& own) {
             const SpaceComplex& c = s->block.complex();
             return std::uint64_t{marked_volume(c, own) == Rational(1)} +
                    2 * std::uint64_t{marked_centroid(c, own).has_value()} +
                    4 * std::uint64_t{surface_area(c, own).has_value()};
           }},
          {"check_rounding",
           [s](Context& own) {
             return std::uint64_t{check_rounding(s->mesh, 10, own).is_sound()};
           }},
          {"audit",
           [s](Context& own) {
             return std::uint64_t{audit(s->block.complex(), AuditForm::Minimal, own).has_value()};
           }},
          {"local_map",
           [s](Context&) {
             LocalMap map;
             local_map(s->block.complex(), VertexId(0), map);
             return map.map.face_count();
           }},
          {"complex_of_mesh, of arrays",
           [s](Context& own) {
             const MeshView mesh = mesh_of_triangles(s->coordinates, s->triangle);
             return complex_of_mesh(mesh, {.surface = true}, own).complex.facet_count();
           }},
      }};
}

OperationRoom convex_operations() {
  const auto s = solids();
  const auto pieces = [s](DecomposeMethod method) {
    return [s, method](Context& own) {
      return digest_of_pieces(decompose(s->block, {method}, own).pieces);
    };
  };
  return {
      "convex",
      inputs,
      {
          {"decompose by cuts", pieces(DecomposeMethod::Cuts)},
          {"decompose by walls", pieces(DecomposeMethod::Walls)},
          {"decompose by the best", pieces(DecomposeMethod::Best)},
          {"wall_subdivision",
           [s](Context& own) { return wall_subdivision(s->block, {}, own).facet_count(); }},
          {"minkowski_sum",
           set([s](Context& own) { return minkowski_sum(s->block, s->ball, own); })},
          {"minkowski_erosion",
           set([s](Context& own) { return minkowski_erosion(s->block, s->ball, own); })},
          {"polyhedral_ball", set([](Context& own) { return polyhedral_ball(1, 1, own); })},
          {"is_convex_mesh",
           [s](Context& own) { return std::uint64_t{is_convex_mesh(s->mesh, own)}; }},
          {"convexity_of_mesh",
           [s](Context& own) { return std::uint64_t{convexity_of_mesh(s->mesh, own).is_convex}; }},
          {"convexity_of_set, reflex_edges",
           [s](Context& own) {
             return convexity_of_set(s->block, own).reflex_edges +
                    reflex_edges(s->block.complex()).size();
           }},
      }};
}

}  // namespace plumb::testing
