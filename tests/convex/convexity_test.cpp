// Convexity of meshes and sets: cases that can be argued by hand, and random meshes against brute
// force.

#include "plumb/convex/convexity.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "generate/meshes.h"
#include "generate/voxel_mesh.h"
#include "plumb/io/mesh_io.h"
#include "plumb/predicates/error.h"
#include "plumb/predicates/input_predicates.h"
#include "plumb/space/from_mesh.h"

namespace plumb::testing::convexity_test {
namespace {

/// Two pyramids over a ring of points around the z axis, which runs around `turns` times.
PolygonMesh double_pyramid(int points, int turns) {
  std::vector<Point3> at{{0, 0, 3}, {0, 0, -3}};
  std::vector<Face> faces;
  const int n = points * turns;
  for (int i = 0; i < n; ++i) {
    const double angle = 6.283185307179586 * (i % points) / points;
    at.push_back({4 * std::cos(angle), 4 * std::sin(angle), 0});
    const auto a = static_cast<std::uint32_t>(2 + i),
               b = static_cast<std::uint32_t>(2 + (i + 1) % n);
    faces.push_back({a, b, 0});
    faces.push_back({b, a, 1});
  }
  return make_mesh(std::move(at), faces);
}

TEST(ConvexMesh, IsTheSurfaceOfOneConvexBody) {
  const PolygonMesh box = box_mesh({0, 0, 0}, {1, 2, 3});
  EXPECT_TRUE(is_convex_mesh(box));
  EXPECT_TRUE(is_convex_mesh(reversed(box)));
  EXPECT_TRUE(is_convex_mesh(fanned(box)));  // pairs of faces in one plane
  EXPECT_TRUE(is_convex_mesh(reversed(fanned(box))));
  EXPECT_TRUE(is_convex_mesh(icosphere_mesh(3, 5, {1, 2, 3})));
  EXPECT_TRUE(is_convex_mesh(double_pyramid(5, 1)));
  EXPECT_TRUE(is_convex_mesh(tetrahedron_mesh({0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {0, 0, 5e-324})));
}

/// A prism over a regular polygon on a lattice of many places: sides are planar quads, ends have
/// many corners.
PolygonMesh regular_prism(int corners, double x) {
  std::vector<Point2> polygon;
  for (int i = 0; i < corners; ++i) {
    const double angle = 6.283185307179586 * i / corners;
    polygon.push_back({x * std::cos(angle), x * std::sin(angle)});
  }
  return prism_mesh(polygon, -1, 1);
}

TEST(ConvexMesh, MayHaveFacesOfManyCorners) {
  EXPECT_TRUE(is_convex_mesh(regular_prism(40, 8)));
  EXPECT_TRUE(is_convex_mesh(reversed(regular_prism(40, 8))));
  // A corner in the middle of an edge, of one face and of both.
  const std::vector<Point3> at{{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}, {0, 0, 2},
                               {2, 0, 2}, {2, 2, 2}, {0, 2, 2}, {1, 0, 0}};
  const auto cube = [&](const Face& bottom, const Face& front) {
    return make_mesh(at, {bottom, {4, 5, 6, 7}, front, {3, 7, 6, 2}, {0, 4, 7, 3}, {1, 2, 6, 5}});
  };
  EXPECT_TRUE(is_convex_mesh(cube({0, 3, 2, 1, 8}, {0, 8, 1, 5, 4})));
  EXPECT_TRUE(is_convex_mesh(cube({8, 0, 3, 2, 1}, {8, 1, 5, 4, 0})));
  // A polygon that goes around twice.
  PolygonMesh twice = regular_prism(20, 8);
  PolygonMesh wound;
  wound.points = twice.points;
  for (std::size_t f = 0; f < twice.face_count(); ++f) {
    const auto face = twice.face(f);
    Face corners(face.begin(), face.end());
    if (face.size() > 4) corners.insert(corners.end(), face.begin(), face.end());
    wound.add_face(corners);
  }
  EXPECT_FALSE(is_convex_mesh(wound));
}

/// By the slow way, which looks at no planes of faces; none for what makes no mesh.
std::optional<bool> is_convex_by_set(const PolygonMesh& mesh) {
  Context context;
  try {
    const MeshComplex complex = complex_of_mesh(mesh, {}, context);
    const MeshReport& report = complex.report;
    if (!report.is_closed() || report.crosses_itself() || !report.doubled.empty()) return false;
    const Nef3 set = Nef3::from_mesh(mesh, {.rule = WindingRule::NonZero}, context);
    return !set.is_empty() && set.is_convex();
  } catch (const Error&) {
    return std::nullopt;
  }
}

// Prisms of any outline: what the fast way says is what the set says.
TEST(ConvexMesh, OfPolygonsIsConvexWhereItsSetIs) {
  int convex = 0, others = 0;
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    Dice dice(seed);
    std::vector<Point2> outline{{0, 0}};
    const auto far = static_cast<double>(dice.between(1, 4));
    outline.push_back({far, 0});
    for (int i = 0; i < 3; ++i) {
      const auto x = static_cast<double>(dice.between(0, 4));
      const auto y = static_cast<double>(dice.between(1, 4));
      outline.push_back({x, y});
    }
    const PolygonMesh mesh = prism_mesh(outline, 0, 3);
    if (const std::optional<bool> expected = is_convex_by_set(mesh)) {
      EXPECT_EQ(is_convex_mesh(mesh), *expected) << seed;
      ++(*expected ? convex : others);
    }
  }
  EXPECT_GT(convex, 10);
  EXPECT_GT(others, 10);
}

// A pyramid over very many corners: its tip is an end of all of them.
TEST(ConvexMesh, PairsEdgesOfAFanInLinearTime) {
  EXPECT_TRUE(is_convex_mesh(double_pyramid(20000, 1)));
}

/// The same mesh from another face and corner on.
PolygonMesh begun_at(const PolygonMesh& mesh, std::size_t face, std::size_t corner) {
  std::vector<Face> faces;
  for (std::size_t i = 0; i < mesh.face_count(); ++i) {
    const std::size_t f = (face + i) % mesh.face_count();
    Face corners(mesh.corners.begin() + mesh.face_begin[f],
                 mesh.corners.begin() + mesh.face_begin[f + 1]);
    std::rotate(corners.begin(),
                corners.begin() + static_cast<std::ptrdiff_t>(corner % corners.size()),
                corners.end());
    faces.push_back(std::move(corners));
  }
  return make_mesh(mesh.points, faces);
}

// The middle of three corners is rounded onto one of them.
TEST(ConvexMesh, MayHaveCornersAlmostOnALine) {
  const PolygonMesh mesh = prism_mesh({{0, 1}, {1, 1}, {2, 1 + 0x1p-52}, {2, 3}, {0, 3}}, 0, 1);
  for (std::size_t face = 0; face < mesh.face_count(); ++face) {
    for (std::size_t corner = 0; corner < 5; ++corner) {
      EXPECT_TRUE(is_convex_mesh(begun_at(mesh, face, corner))) << face << ' ' << corner;
    }
  }
}

TEST(ConvexMesh, HasTheCornersItNamesAndFinitePoints) {
  PolygonMesh wrong = box_mesh({0, 0, 0}, {1, 1, 1});
  wrong.corners[7] = 99;
  EXPECT_THROW(is_convex_mesh(wrong), Error);
  wrong = box_mesh({0, 0, 0}, {1, 1, 1});
  wrong.points[3].y = HUGE_VAL;
  EXPECT_THROW(is_convex_mesh(wrong), Error);
  EXPECT_TRUE(is_convex_mesh(box_mesh({-1.7e308, -1, -1}, {1.7e308, 1, 1})));
}

TEST(ConvexMesh, DoesNotWindTwice) {
  EXPECT_FALSE(is_convex_mesh(double_pyramid(5, 2)));
  EXPECT_FALSE(is_convex_mesh(double_pyramid(3, 4)));
}

TEST(ConvexMesh, IsClosedConnectedAndOneSurface) {
  const PolygonMesh box = box_mesh({0, 0, 0}, {1, 1, 1});
  PolygonMesh open = box;
  open.corners.resize(open.corners.size() - 4);
  open.face_begin.pop_back();
  EXPECT_FALSE(is_convex_mesh(open));
  EXPECT_FALSE(is_convex_mesh(fanned(open)));
  for (const Point3 by : {Point3{5, 0, 0}, Point3{1, 0, 0}, Point3{0, 0, 0}}) {
    EXPECT_FALSE(is_convex_mesh(joined(box, moved(box, by))));
    EXPECT_FALSE(is_convex_mesh(fanned(joined(box, moved(box, by)))));
  }
  EXPECT_FALSE(is_convex_mesh(PolygonMesh{}));
}

TEST(ConvexMesh, HasNoReflexEdge) {
  EXPECT_FALSE(is_convex_mesh(star_prism(5)));
  EXPECT_FALSE(is_convex_mesh(fanned(comb_block(1, 0))));
}

/// Faces with a vertex strictly on either side, by all signs. Requires planar faces with a turn at
/// their second corner.
std::vector<std::uint32_t> failing_by_force(const PolygonMesh& mesh) {
  std::vector<std::uint32_t> failing;
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    const auto corner = [&](std::size_t i) { return mesh.points[mesh.face(f)[i]]; };
    bool is_above = false, is_below = false;
    for (const Point3& p : mesh.points) {
      const Sign sign = orient3d(corner(0), corner(1), corner(2), p);
      is_above |= sign == Sign::Negative;
      is_below |= sign == Sign::Positive;
    }
    if (is_above && is_below) failing.push_back(static_cast<std::uint32_t>(f));
  }
  return failing;
}

void expect_evidence(const PolygonMesh& mesh) {
  Context context;
  const ConvexityEvidence evidence = convexity_of_mesh(mesh, context);
  std::vector<std::uint32_t> faces;
  for (const FailingFace& failing : evidence.faces) {
    faces.push_back(failing.face);
    const auto corner = [&](std::size_t i) { return mesh.points[mesh.face(failing.face)[i]]; };
    EXPECT_EQ(orient3d(corner(0), corner(1), corner(2), mesh.points[failing.vertex]),
              Sign::Negative);
  }
  if (!evidence.is_convex) {
    EXPECT_EQ(faces, failing_by_force(mesh));
  }
}

PolygonMesh mesh_of_file(const std::string& path) {
  Context context;
  return read_mesh_file(path, std::nullopt, {}, context).mesh;
}

TEST(ConvexityEvidence, NamesTheFacesOfTheFivePolyhedra) {
  const std::vector<std::size_t> reflex{0, 1, 1, 2, 1};
  const std::vector<std::string> names{"zero", "one", "two", "three", "four"};
  for (std::size_t i = 0; i < names.size(); ++i) {
    const PolygonMesh mesh = mesh_of_file("corpus/polyhedra/test_" + names[i] + ".off");
    Context context;
    const ConvexityEvidence evidence = convexity_of_mesh(mesh, context);
    EXPECT_EQ(evidence.reflex_edges, reflex[i]) << names[i];
    EXPECT_EQ(evidence.is_convex, i == 0) << names[i];
    expect_evidence(mesh);
  }
}

TEST(ConvexityEvidence, IsThatOfBruteForce) {
  expect_evidence(star_prism(7));
  expect_evidence(comb_block(2, 3));
  expect_evidence(fanned(comb_block(3, 1)));
  for (std::uint64_t seed = 0; seed < 30; ++seed) {
    Dice dice(seed);
    expect_evidence(voxel_mesh(random_voxels(dice, {3, 2, 2}, 7)));
  }
  PolygonMesh dented =
      icosphere_mesh(4, 1, {});  // as many triangles as are sorted (mesh_vertices.h)
  Point3& in = dented.points[100];
  in = {in.x / 2, in.y / 2, in.z / 2};
  expect_evidence(dented);
}

// Reflex edges of the mesh are those of the set, where no two faces lie in one plane side by side.
TEST(ConvexityEvidence, OfMeshAndSetAgree) {
  for (const PolygonMesh& mesh : {star_prism(6), comb_block(2, 2), comb_block(0, 3)}) {
    Context context;
    const Nef3 set = Nef3::from_mesh(mesh, {.rule = WindingRule::Positive}, context);
    EXPECT_EQ(convexity_of_mesh(mesh, context).reflex_edges,
              convexity_of_set(set, context).reflex_edges);
    EXPECT_EQ(convexity_of_mesh(reversed(mesh), context).reflex_edges,
              convexity_of_set(set, context).reflex_edges);
  }
}

TEST(ConvexityEvidence, OfSetsHasAnAnswerForEveryKind) {
  Context context;
  const Nef3 below = Nef3::half_space({0, 0, 1, 0}, Boundary::Closed);
  const Nef3 beside = Nef3::half_space({1, 0, 0, 0}, Boundary::Open);
  const Nef3 box =
      Nef3::from_mesh(box_mesh({0, 0, 0}, {2, 2, 2}), {.rule = WindingRule::Positive}, context);
  const auto of = [&](const Nef3& set) { return convexity_of_set(set, context); };
  for (const Nef3& set : {Nef3::empty(), Nef3::whole(), below, below * beside, box, box.interior(),
                          Nef3::point({1, 2, 3}), Nef3::plane({1, 1, 1, 0})}) {
    EXPECT_TRUE(of(set).is_convex);
    EXPECT_EQ(of(set).reflex_edges, 0U);
    EXPECT_TRUE(of(set).faces.empty());
  }
  EXPECT_EQ(of(below + beside).reflex_edges, 1U);
  EXPECT_FALSE(of(below + beside).is_convex);
  EXPECT_EQ(of(!box).reflex_edges, 12U);
  const Nef3 slit =
      box - Nef3::facet(std::vector<RationalPoint3>{{1, 1, 1}, {2, 1, 1}, {2, 2, 1}, {1, 2, 1}});
  EXPECT_EQ(of(slit).reflex_edges, 2U);  // two of its sides run inside the box
  EXPECT_EQ(of(box - Nef3::segment({0, 0, 0}, {2, 2, 2})).reflex_edges, 1U);
  const ConvexityEvidence holed = of(box - Nef3::point({0, 0, 1}));
  EXPECT_FALSE(holed.is_convex);  // a point of an edge is missing
  EXPECT_EQ(holed.reflex_edges, 0U);
  EXPECT_TRUE(holed.faces.empty());
}

}  // namespace
}  // namespace plumb::testing::convexity_test
