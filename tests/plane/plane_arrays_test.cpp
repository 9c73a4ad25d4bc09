// Points and maps of the plane from and to plain arrays.
#include "plumb/plane/plane_arrays.h"

#include <gtest/gtest.h>

#include <functional>
#include <limits>
#include <optional>
#include <vector>

#include "plumb/io/plane_io.h"
#include "plumb/plane/map_check.h"
#include "plumb/plane/nef2.h"
#include "plumb/predicates/error.h"

namespace plumb::testing::plane_arrays_test {
namespace {

using Doubles = std::vector<double>;
using Indices = std::vector<std::uint32_t>;

const Doubles kSquare = {0, 0, 1, 0, 1, 1, 0, 1};
const Indices kBegin = {0, 3, 6, 10};
const Indices kCorners = {0, 1, 3, 1, 2, 3, 3, 2, 1, 0};  // two triangles, and around them

ErrorCode code(const std::function<void()>& make) {
  try {
    make();
  } catch (const Error& error) {
    return error.code();
  }
  return ErrorCode::CannotOpen;
}

TEST(PlaneArrays, go_in_and_come_out) {
  EXPECT_EQ(coordinates_of(points_of(kSquare)), kSquare);
  EXPECT_EQ(points_of({}).size(), 0U);
  EXPECT_TRUE(coordinates_of({}).empty());
  PointTable2 thirds;
  thirds.push_back(Rational(1) / 3, Rational(2));
  EXPECT_EQ(coordinates_of(thirds), (Doubles{1.0 / 3, 2})) << "the nearest doubles";
}

TEST(PlaneArrays, are_a_map_that_keeps_them) {
  std::optional<Doubles> xy = kSquare;
  std::optional<Indices> corners = kCorners;
  const Map map = map_of_cycles(*xy, kBegin, *corners);
  xy.reset();
  corners.reset();
  Context context;
  const MapReport report = check_map(map, {}, context);
  EXPECT_EQ(report.verdict, MapVerdict::Valid);
  EXPECT_EQ(report.regions.size(), 3U);
  EXPECT_EQ(coordinates_of(report.map.points), kSquare);
  EXPECT_EQ(report.map.corners, kCorners);
  EXPECT_EQ(report.map.cycle_begin, kBegin);
  EXPECT_EQ(to_dcel(report).dcel.audit(), std::nullopt);
}

TEST(PlaneArrays, go_through_a_set_and_come_back) {
  Context context;
  const auto set = [&](const Doubles& xy, const Indices& corners, const Indices& begin) {
    return Nef2::polygons(points_of(xy), corners, begin, WindingRule::NonZero, Boundary::Closed,
                          context);
  };
  Doubles moved = kSquare;
  for (double& x : moved) x += .5;
  const Nef2 both = set(kSquare, {0, 1, 2, 3}, {0, 4}) + set(moved, {0, 1, 2, 3}, {0, 4});
  const PlaneShapes shapes = to_shapes(both.parts(), context);
  const Doubles xy = coordinates_of(shapes.points);
  EXPECT_EQ(xy.size(), 2 * 8U);
  EXPECT_EQ(set(xy, shapes.ring_corners, shapes.ring_begin), both);
}

TEST(PlaneArrays, refuse_what_does_not_agree) {
  const Doubles three(3), many(8, std::numeric_limits<double>::infinity());
  EXPECT_EQ(code([&] { points_of(three); }), ErrorCode::BadArgument);
  EXPECT_EQ(code([&] { points_of(many); }), ErrorCode::NotFinite);
  const std::vector<Indices> begins = {{}, {1, 10}, {0, 9}, {0, 11}, {0, 6, 3, 10}};
  for (const Indices& begin : begins) {
    EXPECT_EQ(code([&] { map_of_cycles(kSquare, begin, kCorners); }), ErrorCode::BadArgument);
  }
  Context context;
  const auto judge = [&](const Indices& begin, const Indices& corners) {
    return code([&] { check_map(map_of_cycles(kSquare, begin, corners), {}, context); });
  };
  EXPECT_EQ(judge({0, 3}, {0, 1, 4}), ErrorCode::BadIndex);
  EXPECT_EQ(judge({0, 2}, {0, 1}), ErrorCode::DegenerateFace);
}

}  // namespace
}  // namespace plumb::testing::plane_arrays_test
