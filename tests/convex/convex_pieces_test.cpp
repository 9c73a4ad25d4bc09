// Convex pieces of sets, judged by tests/oracle/pieces_check.h: each convex, together the set, none
// twice.

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <string>
#include <vector>

#include "generate/mesh_solid.h"
#include "generate/meshes.h"
#include "generate/space_program.h"
#include "generate/voxel_mesh.h"
#include "oracle/nef3_check.h"
#include "oracle/pieces_check.h"
#include "plumb/convex/decompose.h"
#include "plumb/convex/part/cut_set.h"
#include "plumb/convex/sum/volume_sum.h"
#include "plumb/io/mesh_io.h"
#include "plumb/predicates/error.h"

namespace plumb::testing::convex_pieces_test {
namespace {

constexpr DecomposeOptions kCuts{DecomposeMethod::Cuts, false};
constexpr DecomposeOptions kBest{DecomposeMethod::Best, false};

std::size_t piece_count(const Nef3& set, const DecomposeOptions& options) {
  Context context;
  return decompose(set, options, context).pieces.size();
}

/// Pieces are right by both methods, open and closed.
void expect_pieces(const Nef3& set, const std::string& name) {
  for (const DecomposeMethod method : {DecomposeMethod::Cuts, DecomposeMethod::Best}) {
    for (const bool closed : {false, true}) {
      Context context;
      const ConvexPieces pieces = decompose(set, {method, closed}, context);
      EXPECT_EQ(flaw_of_pieces(set, pieces, closed), "") << name << (closed ? ", closed" : "");
    }
  }
}

PolygonMesh polyhedron(const std::string& name) {
  Context context;
  return read_mesh_file("corpus/polyhedra/test_" + name + ".off", std::nullopt, {}, context).mesh;
}

// ---------------------------------------------------------------- the five polyhedra

const std::vector<std::pair<std::string, std::size_t>> kFive{
    {"zero", 1}, {"one", 2}, {"two", 2}, {"three", 3}, {"four", 2}};

TEST(FivePolyhedra, GiveAsManyPiecesAsTheNoteSays) {
  for (const auto& [name, pieces] : kFive) {
    const Nef3 set = solid(polyhedron(name));
    EXPECT_EQ(piece_count(set, kCuts), pieces) << name;
    EXPECT_EQ(piece_count(set, kBest), pieces) << name;
    expect_pieces(set, name);
  }
}

PolygonMesh with_axes(PolygonMesh mesh, const std::array<std::size_t, 3>& axes) {
  for (Point3& p : mesh.points) {
    const std::array<double, 3> at{p.x, p.y, p.z};
    p = {at[axes[0]], at[axes[1]], at[axes[2]]};
  }
  const bool is_odd = axes != std::array<std::size_t, 3>{0, 1, 2} &&
                      axes != std::array<std::size_t, 3>{1, 2, 0} &&
                      axes != std::array<std::size_t, 3>{2, 0, 1};
  return is_odd ? reversed(std::move(mesh)) : mesh;
}

PolygonMesh with_faces(const PolygonMesh& mesh, const std::vector<std::size_t>& order) {
  PolygonMesh result;
  result.points = mesh.points;
  for (const std::size_t f : order) result.add_face(mesh.face(f));
  return result;
}

PolygonMesh with_vertices(PolygonMesh mesh, Dice& dice) {
  std::vector<std::uint32_t> to(mesh.points.size());
  std::iota(to.begin(), to.end(), 0U);
  for (std::size_t i = to.size(); i > 1; --i) std::swap(to[i - 1], to[dice.below(i)]);
  const std::vector<Point3> points = mesh.points;
  for (std::size_t i = 0; i < to.size(); ++i) mesh.points[to[i]] = points[i];
  for (std::uint32_t& corner : mesh.corners) corner = to[corner];
  return mesh;
}

// Every order of the faces, the vertices in another each time; the axes in turn.
TEST(FivePolyhedra, DoNotDependOnOrders) {
  for (const auto& [name, pieces] : kFive) {
    const PolygonMesh mesh = polyhedron(name);
    std::vector<std::size_t> order(mesh.face_count());
    std::iota(order.begin(), order.end(), 0U);
    std::array<std::size_t, 3> axes{0, 1, 2};
    Dice dice(1);
    std::size_t count = 0;
    do {
      const PolygonMesh turned = with_vertices(with_axes(with_faces(mesh, order), axes), dice);
      const std::size_t found = piece_count(solid(turned), kCuts);
      ASSERT_EQ(found, pieces) << name << ", order " << count;
      if (!std::next_permutation(axes.begin(), axes.end())) axes = {0, 1, 2};
      ++count;
    } while (std::next_permutation(order.begin(), order.end()) && (name == "three" || count < 200));
  }
}

// ---------------------------------------------------------------- solids

TEST(Decompose, CutsCombsAndStarsIntoFewPieces) {
  for (int tips = 3; tips < 9; ++tips) {
    const Nef3 star = solid(star_prism(tips));
    expect_pieces(star, "star " + std::to_string(tips));
    EXPECT_LE(piece_count(star, kBest), static_cast<std::size_t>(tips) + 1);
  }
  for (int top = 0; top < 4; ++top) {
    for (int bottom = 0; bottom < 4; ++bottom) {
      const Nef3 comb = solid(comb_block(top, bottom));
      const auto r = static_cast<std::size_t>(top + bottom);
      expect_pieces(comb, "comb " + std::to_string(top) + ", " + std::to_string(bottom));
      EXPECT_LE(piece_count(comb, kBest), static_cast<std::size_t>((top + 1) * (bottom + 1)));
      EXPECT_LE(piece_count(comb, kCuts), bound_of_cuts(1, r));
    }
  }
}

TEST(Decompose, KeepsWallsApartFromFacets) {
  Context context;
  const PolygonMesh mesh = polyhedron("four");
  const ConvexPieces result = decompose(solid(mesh), kCuts, context);
  std::size_t walls = 0;
  for (const Nef3& piece : result.pieces) {
    const SpaceComplex& c = piece.complex();
    for (std::size_t f = 0; f < c.facet_count(); ++f) {
      if (is_wall(c, FacetId(f))) {
        ++walls;
      } else {
        EXPECT_LT(c.facet_origin[f], mesh.face_count());
      }
    }
  }
  EXPECT_GE(walls, 1U);  // seen from one side the cut may prolong a facet
  EXPECT_LE(walls, result.pieces.size());
}

// Cells that touch along edges and at vertices, voids, several components, facets with holes.
TEST(Decompose, CutsRandomLatticeSolids) {
  for (std::uint64_t seed = 0; seed < 24 && !HasFailure(); ++seed) {
    Dice dice(seed);
    const int tenths = static_cast<int>(dice.between(3, 9));
    expect_pieces(solid(voxel_mesh(random_voxels(dice, {3, 2, 2}, tenths))),
                  "voxels " + std::to_string(seed));
  }
}

/// A block with grooves along y above and below, of which Booleans made every vertex: no plane
/// through a groove's edge and a vertex of the input resolves two of them, sums of the faces'
/// equations do.
Nef3 block_with_grooves(double shift) {
  const auto groove = [](double x, double side) {
    std::vector<Point3> p;
    for (const double y : {-5., 5.}) {
      p.insert(p.end(), {{x - 1, y, 9 * side}, {x + 1, y, 9 * side}, {x, y, side}});
    }
    Context context;
    return Nef3::from_mesh(
        make_mesh(p, {{0, 1, 2}, {5, 4, 3}, {0, 3, 4, 1}, {1, 4, 5, 2}, {2, 5, 3, 0}}),
        {.rule = WindingRule::NonZero}, context);
  };
  Nef3 set = solid(box_mesh({-4, -3, -3}, {4, 3, 3}));
  for (const double x : {-2., 0., 2.}) set = set - groove(x, 1) - groove(x + shift, -1);
  return set;
}

TEST(Decompose, CutsAlongTwoEdgesThatBooleansMade) {
  for (const double shift : {0., .125, .25}) {
    const Nef3 set = block_with_grooves(shift);
    EXPECT_EQ(piece_count(set, kCuts), 4U) << shift;
    expect_pieces(set, "grooves");
  }
}

TEST(Decompose, CutsTerrainsWithinTheBound) {
  for (std::uint64_t seed = 0; seed < 8 && !HasFailure(); ++seed) {
    Dice dice(seed);
    const Nef3 terrain = solid(voxel_mesh(random_terrain(dice, 4, 3, 4)));
    Context context;
    const ConvexPieces pieces = decompose(terrain, kCuts, context);
    EXPECT_EQ(flaw_of_pieces(terrain, pieces, false), "") << seed;
    EXPECT_LE(pieces.pieces.size(), bound_of_cuts(1, pieces.reflex_edges)) << seed;
  }
}

TEST(Decompose, CutsVoidsAndHoles) {
  const Nef3 block = solid(box_mesh({0, 0, 0}, {9, 9, 9}));
  const Nef3 small = solid(box_mesh({3, 3, 3}, {5, 5, 5}));
  const Nef3 other = solid(box_mesh({6, 6, 6}, {8, 8, 8}));
  const Nef3 shaft = solid(box_mesh({3, 3, -1}, {5, 5, 10}));
  const Nef3 slot = solid(box_mesh({-1, 6, 3}, {10, 8, 5}));
  expect_pieces(block - small, "a void");
  expect_pieces(block - small - other, "two voids");
  expect_pieces(block - shaft, "a shaft");
  expect_pieces(block - shaft - slot, "two shafts");
  expect_pieces(block - small + solid(box_mesh({3.5, 3.5, 3.5}, {4, 4, 4})), "a block in a void");
}

// Touching volumes, each with a void; what they share belongs to one.
TEST(Decompose, TakesSetsOfManyVolumes) {
  Nef3 set;
  for (int i = 0; i < 3; ++i) {
    const double x = 4 * i;
    set += solid(box_mesh({x, x, 0}, {x + 4, x + 4, 4})) -
           solid(box_mesh({x + 1, x + 1, 1}, {x + 2, x + 2, 2}));
  }
  expect_pieces(set, "blocks on edges");
  expect_pieces(set.interior() + Nef3::segment({0, 0, 4}, {12, 12, 4}), "open blocks, a bar");
  EXPECT_EQ(piece_count(set, kBest), 18U);
}

// Two towers on a base that share an edge; slants and pits so that cuts run across the edge,
// through one of them.
TEST(Decompose, CutsTowersThatShareAnEdge) {
  const Nef3 base = solid(box_mesh({-4, -4, -2}, {4, 4, 0}));
  const Nef3 towers =
      solid(box_mesh({0, 0, 0}, {4, 4, 8})) + solid(box_mesh({-4, -4, 0}, {0, 0, 8}));
  const Nef3 slant =
      solid(make_mesh({{0, 0, 3}, {9, 0, 3}, {0, 9, 3}, {9, 9, 3}, {0, 0, 5}, {0, 9, 5}},
                      {{0, 2, 3, 1}, {0, 1, 4}, {2, 5, 3}, {0, 4, 5, 2}, {1, 3, 5, 4}}));
  const Nef3 cross = solid(box_mesh({1, -9, 4}, {2, 9, 6}));
  expect_pieces(base + towers, "towers");
  expect_pieces((base + towers) - slant, "a slant notch");
  expect_pieces((base + towers) - slant - cross, "a notch and a groove");
  expect_pieces(base + (towers - slant).interior() + cross, "open towers and a bar");
}

// Planes that cut off a tip at a time need more pieces than walls along the bars.
TEST(Decompose, TakesTheFewerPieces) {
  for (std::uint64_t seed = 0; seed < 12 && !HasFailure(); ++seed) {
    Dice dice(seed);
    const Nef3 set = solid(voxel_mesh(random_voxels(dice, {3, 3, 2}, 6)));
    const std::size_t best = piece_count(set, kBest);
    EXPECT_LE(best, piece_count(set, kCuts)) << seed;
    EXPECT_LE(best, piece_count(set, {DecomposeMethod::Walls, false})) << seed;
  }
}

// Of one volume, where greedy cuts give more pieces than are allowed: it is cut again by the other
// rule.
TEST(Decompose, FallsBackOnTheClassicalRule) {
  Dice dice(2);
  const Nef3 terrain = solid(voxel_mesh(random_terrain(dice, 3, 3, 3)));
  const Nef3 hollow = solid(box_mesh({0, 0, 0}, {6, 6, 6})) - solid(box_mesh({2, 2, 2}, {4, 4, 4}));
  for (const Nef3& set : {solid(polyhedron("three")), solid(comb_block(2, 3)), solid(star_prism(7)),
                          terrain, terrain.interior(), hollow}) {
    for (const DecomposeMethod method : {DecomposeMethod::Cuts, DecomposeMethod::Best}) {
      for (const bool closed : {false, true}) {
        Context context;
        const SetPart part{set, 3};
        const std::size_t greedy = cut_set(part, {method, closed}, context).size();
        ConvexPieces pieces;
        pieces.pieces = cut_set(part, {method, closed}, context, 0);
        EXPECT_EQ(flaw_of_pieces(set, pieces, closed), "") << (closed ? "closed" : "");
        EXPECT_LE(pieces.pieces.size(), greedy);
      }
    }
  }
}

// ---------------------------------------------------------------- any set

TEST(Decompose, TakesAnySet) {
  const Nef3 below = Nef3::half_space({0, 0, 1, 0}, Boundary::Closed);
  const Nef3 beside = Nef3::half_space({1, 0, 0, 0}, Boundary::Open);
  const Nef3 before = Nef3::half_space({0, 1, 0, 0}, Boundary::Closed);
  const Nef3 box = solid(box_mesh({0, 0, 0}, {2, 2, 2}));
  const std::vector<RationalPoint3> ell{{0, 0, 5}, {3, 0, 5}, {3, 1, 5},
                                        {1, 1, 5}, {1, 3, 5}, {0, 3, 5}};
  EXPECT_EQ(piece_count(Nef3::empty(), kBest), 0U);
  EXPECT_EQ(piece_count(Nef3::whole(), kBest), 1U);
  EXPECT_EQ(piece_count(below + beside, kBest), 2U);
  EXPECT_EQ(piece_count(Nef3::facet(ell), kBest), 2U);
  expect_pieces(below + beside, "three quarters of space");
  expect_pieces(below + beside + before, "seven octants");
  expect_pieces(!box, "outside of a box");
  expect_pieces(!box.interior(), "outside of an open box");
  expect_pieces(Nef3::plane({0, 0, 1, 0}) - box, "a plane with a hole");
  expect_pieces(Nef3::facet(ell), "an L");
  expect_pieces(Nef3::facet(ell) - Nef3::point({RationalPoint3{1, 1, 5}}),
                "an L without its corner");
  expect_pieces(box - Nef3::segment({0, 0, 0}, {2, 2, 2}), "a box without a diagonal");
  expect_pieces(box - Nef3::point({1, 1, 1}), "a box without its middle");
  expect_pieces(box - Nef3::facet(std::vector<RationalPoint3>{{1, 1, 1}, {2, 1, 1}, {2, 2, 1}}),
                "a slit box");
  expect_pieces(box.boundary(), "the surface of a box");
  expect_pieces(box.interior() + Nef3::segment({-1, 1, 1}, {3, 1, 1}) + Nef3::point({7, 7, 7}),
                "an open box on a spit, and a point");
}

TEST(Decompose, TakesRandomSets) {
  for (std::uint64_t seed = 0; seed < 40 && !HasFailure(); ++seed) {
    Dice dice(seed);
    const auto values = static_cast<ProgramValues>(seed % 3);
    const std::size_t records = 3 + seed % 4;
    const auto set = space_set_of_program(random_space_program(dice, values, records), 9);
    expect_pieces(to_nef(*set), "seed " + std::to_string(seed));
  }
}

TEST(VolumeSum, SeesWhatIsMissing) {
  Context context;
  const Nef3 set = solid(comb_block(2, 3));
  std::vector<Nef3> pieces = decompose(set, kBest, context).pieces;
  EXPECT_EQ(do_volumes_add_up(set, pieces, context), true);
  EXPECT_EQ(do_volumes_add_up(!set, pieces, context), std::nullopt);
  EXPECT_EQ(do_volumes_add_up(set - Nef3::plane({1, 0, 0, 0}), pieces, context), true);
  const Nef3 last = pieces.back();
  pieces.pop_back();
  EXPECT_EQ(do_volumes_add_up(set, pieces, context), false);
  pieces.push_back(last);
  pieces.push_back(last);
  EXPECT_EQ(do_volumes_add_up(set, pieces, context), false);
}

TEST(Decompose, CanBeStopped) {
  std::stop_source stop;
  stop.request_stop();
  Context context({}, stop.get_token());
  EXPECT_THROW(decompose(solid(comb_block(3, 3)), kBest, context), Error);
}

}  // namespace
}  // namespace plumb::testing::convex_pieces_test
