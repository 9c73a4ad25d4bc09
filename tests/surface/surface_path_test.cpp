// Checks points of a mesh against rational positions in space, on whichever cell they are stored,
// and polylines over them.
#include "plumb/surface/surface_path.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <limits>
#include <string>
#include <vector>

#include "generate/surface_scenes.h"
#include "plumb/predicates/error.h"
#include "plumb/predicates/rounding.h"
#include "plumb/testing/dice.h"

namespace plumb::surface_path_test {

using testing::Dice;
using testing::MeshPointer;
using Place = std::array<Rational, 3>;

/// Where the weights (u, v) of a face lie in space.
Place place(const SurfaceMesh& mesh, FaceId f, const RationalPoint2& at) {
  Place sum;
  const std::array<Rational, 3> weights{Rational(1 - at.x - at.y), at.x, at.y};
  for (std::size_t i = 0; i < 3; ++i) {
    const Point3& p = mesh.point(mesh.corner(f, i));
    sum[0] += weights[i] * exact_rational(p.x);
    sum[1] += weights[i] * exact_rational(p.y);
    sum[2] += weights[i] * exact_rational(p.z);
  }
  return sum;
}

template <class Work>
ErrorCode refusal(const Work& work) {
  try {
    work();
  } catch (const Error& e) {
    return e.code();
  }
  return ErrorCode::Usage;
}

/// Adds random points of a face, often on its sides and corners.
RationalPoint2 any_weights(Dice& dice) {
  const std::int64_t whole = dice.between(1, 6);
  const std::int64_t u = dice.between(0, whole);
  return {Rational(Rational(u) / whole), Rational(Rational(dice.between(0, whole - u)) / whole)};
}

TEST(SurfacePath, PointsKeepTheirPlacesInAllFacesThatTheyLieIn) {
  const MeshPointer mesh = testing::torus_mesh(4, 3);
  SurfacePointTable points(*mesh);
  Dice dice(1);
  std::array<std::size_t, 3> stored{};
  for (int round = 0; round < 200; ++round) {
    const FaceId f(dice.below(mesh->face_count()));
    const RationalPoint2 at = any_weights(dice);
    const SurfacePointId p = points.add_in_face(f, at.x, at.y);
    const std::array<Rational, 3> weights{Rational(1 - at.x - at.y), at.x, at.y};
    const auto zeros = std::count(weights.begin(), weights.end(), Rational(0));
    EXPECT_EQ(static_cast<long>(points.place(p)), 2 - zeros);
    ++stored[static_cast<std::size_t>(points.place(p))];
    const Place expected = place(*mesh, f, at);
    std::size_t faces = 0;
    for (std::uint32_t g = 0; g < mesh->face_count(); ++g) {
      if (!points.is_in(p, FaceId(g))) continue;
      ++faces;
      const RationalPoint2 there = points.exact_in(p, FaceId(g));
      EXPECT_TRUE(place(*mesh, FaceId(g), there) == expected);
      PointTable2 local;
      points.append_local(p, FaceId(g), local);
      EXPECT_TRUE(local.exact(0) == there);
      const Point2 near = points.approx_in(p, FaceId(g));
      EXPECT_LE(abs(Rational(exact_rational(near.x) - there.x)), exact_rational(0x1p-52));
      EXPECT_LE(abs(Rational(exact_rational(near.y) - there.y)), exact_rational(0x1p-52));
    }
    EXPECT_TRUE(points.is_in(p, f));
    EXPECT_EQ(faces, zeros == 0 ? 1U : zeros == 1 ? 2U : 6U);
    const Point3 rounded = points.position(p);
    EXPECT_NEAR(rounded.x, nearest_double(expected[0]), 1e-13);
    EXPECT_NEAR(rounded.y, nearest_double(expected[1]), 1e-13);
    EXPECT_NEAR(rounded.z, nearest_double(expected[2]), 1e-13);
  }
  for (const std::size_t count : stored) EXPECT_GT(count, 10U);
}

/// Doubles count exactly, also where 1 - t is none.
TEST(SurfacePath, DoublesAreTakenExactly) {
  const MeshPointer mesh = testing::grid_mesh(1, 1);
  SurfacePointTable points(*mesh);
  for (const double t : {0x1p-60, 0.1, 0.5, 1 - 0x1p-53}) {
    for (std::uint32_t e = 0; e < mesh->edge_count(); ++e) {
      const SurfacePointId p = points.add_on_edge(EdgeId(e), t);
      const SurfacePointId q = points.add_on_edge(EdgeId(e), exact_rational(t));
      EXPECT_TRUE(points.is_same(p, q));
      for (const std::uint32_t f : {0U, 1U}) {
        if (!points.is_in(p, FaceId(f))) continue;
        PointTable2 local;
        points.append_local(p, FaceId(f), local);
        const RationalPoint2 at = local.exact(0);
        EXPECT_TRUE(at == points.exact_in(q, FaceId(f)));
        const SurfacePointId again = points.add_in_face(FaceId(f), at.x, at.y);
        EXPECT_TRUE(points.is_same(again, p));
      }
    }
  }
  const SurfacePointId inside = points.add_in_face(FaceId(0), 0x1p-70, 0.5);
  EXPECT_EQ(points.place(inside), SurfacePlace::Face);
  EXPECT_EQ(points.place(points.add_in_face(FaceId(0), 0.5, 0.5)), SurfacePlace::Edge);
  EXPECT_FALSE(points.is_same(inside, points.add_in_face(FaceId(0), 0x1p-71, 0.5)));
  EXPECT_FALSE(points.is_same(inside, points.add_in_face(FaceId(1), 0x1p-70, 0.5)));
  EXPECT_TRUE(points.is_same(points.add_vertex(VertexId(0)), points.add_on_edge(EdgeId(0), 0.0)) ==
              (mesh->lower(EdgeId(0)) == VertexId(0)));
}

TEST(SurfacePath, RefusesWhatIsNoPointOfTheMesh) {
  const MeshPointer mesh = testing::grid_mesh(1, 1);
  SurfacePointTable points(*mesh);
  const auto in_face = [&](double u, double v) {
    return refusal([&] { points.add_in_face(FaceId(0), u, v); });
  };
  EXPECT_EQ(in_face(0.5, 0.5), ErrorCode::Usage);
  EXPECT_EQ(in_face(0.5 + 0x1p-53, 0.5), ErrorCode::BadArgument);
  EXPECT_EQ(in_face(-0x1p-1074, 0.5), ErrorCode::BadArgument);
  EXPECT_EQ(in_face(0.5, std::numeric_limits<double>::quiet_NaN()), ErrorCode::BadArgument);
  const auto on_edge = [&](double t) { return refusal([&] { points.add_on_edge(EdgeId(0), t); }); };
  EXPECT_EQ(on_edge(1), ErrorCode::Usage);
  EXPECT_EQ(on_edge(1 + 0x1p-52), ErrorCode::BadArgument);
  EXPECT_EQ(on_edge(std::numeric_limits<double>::quiet_NaN()), ErrorCode::BadArgument);
  EXPECT_EQ(refusal([&] { points.add_on_edge(EdgeId(0), Rational(-1)); }), ErrorCode::BadArgument);
  EXPECT_EQ(refusal([&] { points.add_vertex(VertexId(4)); }), ErrorCode::BadIndex);
  EXPECT_EQ(refusal([&] { points.add_on_edge(EdgeId(5), 0.5); }), ErrorCode::BadIndex);
  EXPECT_EQ(refusal([&] { points.add_in_face(FaceId(2), 0.1, 0.1); }), ErrorCode::BadIndex);
  EXPECT_EQ(points.size(), 2U);  // those that were taken
}

TEST(SurfacePath, PolygonsNameTheSegmentThatLeavesItsFace) {
  const MeshPointer mesh = testing::grid_mesh(1, 1);
  SurfacePolygons polygons(*mesh);
  SurfacePath leg;
  for (std::size_t i = 0; i < 3; ++i) {
    leg.points.push_back(polygons.points.add_vertex(mesh->corner(FaceId(0), i)));
  }
  leg.faces = {FaceId(0), FaceId(0)};
  polygons.close();  // one without segments
  polygons.add_leg(leg);
  polygons.add_segment(leg.points[2], FaceId(0), SegmentStart::ControlPoint);
  polygons.close();
  require_valid(polygons);
  EXPECT_EQ(polygons.size(), 2U);
  EXPECT_TRUE(polygons.points_of(0).empty());
  EXPECT_EQ(polygons.is_control, (std::vector<std::uint8_t>{1, 0, 1}));
  EXPECT_EQ(polygons.next(1, 0), 1U);
  EXPECT_EQ(polygons.next(1, 2), 0U);
  for (std::uint32_t i = 0; i < 3; ++i) {
    SurfacePolygons bad = polygons;
    bad.face[i] = FaceId(1);
    const std::uint32_t next = bad.next(1, i);
    const bool is_shared =
        bad.points.is_in(bad.point[i], FaceId(1)) && bad.points.is_in(bad.point[next], FaceId(1));
    std::string message;
    try {
      require_valid(bad);
    } catch (const Error& e) {
      message = e.what();
    }
    const std::string named = "polygon 1, segment " + std::to_string(i);
    EXPECT_EQ(message.find(named) != std::string::npos, !is_shared) << message;
    bad = polygons;
    bad.face[i] = FaceId(2);
    EXPECT_EQ(refusal([&] { require_valid(bad); }), ErrorCode::BadArgument);
  }
}

}  // namespace plumb::surface_path_test
