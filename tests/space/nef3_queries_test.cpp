// What a set can be asked besides membership: rays, soups, origins; and selective Booleans.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <vector>

#include "generate/space_program.h"
#include "oracle/nef3_check.h"
#include "plumb/predicates/error.h"
#include "plumb/space/space_audit.h"

namespace plumb::testing::nef3_queries_test {
namespace {

using Range = std::array<int, 2>;

Nef3 box(Range x, Range y, Range z) {
  Context context;
  return Nef3::intersection(std::array{HalfSpace3{{-1, 0, 0, x[0]}}, HalfSpace3{{1, 0, 0, -x[1]}},
                                       HalfSpace3{{0, -1, 0, y[0]}}, HalfSpace3{{0, 1, 0, -y[1]}},
                                       HalfSpace3{{0, 0, -1, z[0]}}, HalfSpace3{{0, 0, 1, -z[1]}}},
                            context);
}

Nef3 square(int z) {
  return Nef3::facet(std::array{Point3{0, 0, 1.0 * z}, Point3{4, 0, 1.0 * z}, Point3{4, 4, 1.0 * z},
                                Point3{0, 4, 1.0 * z}});
}

SpaceSetPointer random_set(Dice& dice, std::size_t records) {
  return space_set_of_program(random_space_program(dice, ProgramValues::Plain, records), 7);
}

// ---------------------------------------------------------------- rays

TEST(Rays, MeetMarkedItemsAndBoundaries) {
  const Nef3 solid = box({0, 4}, {0, 4}, {0, 4}) - box({1, 3}, {1, 3}, {1, 3});
  const RationalPoint3 middle{2, 2, 2}, right{1, 0, 0};
  EXPECT_FALSE(solid.has_on_boundary(middle));
  EXPECT_TRUE(solid.has_on_boundary(Point3{3, 2, 2}));
  EXPECT_TRUE(solid.has_on_boundary(RationalPoint3{4, 4, Rational(1, 3)}));
  const auto wall = solid.shoot_to_boundary(middle, right);
  ASSERT_TRUE(wall.has_value());
  EXPECT_EQ(wall->location.item.kind(), SpaceItem::Kind::Facet);
  EXPECT_EQ(wall->point, (RationalPoint3{3, 2, 2}));
  // The wall of the void does not belong to the solid: its inside is met where it begins.
  const auto inside = solid.shoot(middle, right);
  ASSERT_TRUE(inside.has_value());
  EXPECT_EQ(inside->location.item.kind(), SpaceItem::Kind::Volume);
  EXPECT_EQ(inside->point, (RationalPoint3{3, 2, 2}));
  EXPECT_TRUE(solid.locate(Point3{3.5, 2, 2}).item == inside->location.item);
  EXPECT_FALSE(solid.shoot_to_boundary({5, 2, 2}, right).has_value());
  EXPECT_FALSE(solid.shoot({5, 2, 2}, right).has_value());
  EXPECT_EQ(solid.shoot({-7, 2, 2}, right)->point, (RationalPoint3{0, 2, 2}));
  EXPECT_EQ(solid.shoot_to_boundary({4, 2, 2}, right)->point, (RationalPoint3{4, 2, 2}));
  EXPECT_THROW(solid.shoot_to_boundary(middle, {0, 0, 0}), Error);
  // Along an edge: the edge is entered behind its end.
  const auto edge = solid.shoot_if(
      {-1, 0, 0}, right, [](SpaceItem item) { return item.kind() == SpaceItem::Kind::Edge; });
  ASSERT_TRUE(edge.has_value());
  EXPECT_EQ(edge->point, (RationalPoint3{0, 0, 0}));
}

/// Items along a ray are those at its points: between cells of all planes nothing changes.
TEST(Rays, AgreeWithPointsOnThem) {
  for (std::uint64_t seed = 0; seed < 40 && !HasFailure(); ++seed) {
    SCOPED_TRACE(seed);
    Dice dice(seed);
    const auto set = random_set(dice, 4);
    const Nef3 a = to_nef(*set);
    const auto number = [&dice] { return Rational(dice.between(-2, 10), 2); };
    const Rational px = number(), py = number(), pz = number();
    const std::int64_t dx = dice.between(-2, 2), dy = dice.between(-2, 2);
    const RationalPoint3 p{px, py, pz}, d{dx, dy, dice.between(1, 3)};
    const auto at = [&](const Rational& t) {
      return RationalPoint3{p.x + t * d.x, p.y + t * d.y, p.z + t * d.z};
    };
    std::vector<Rational> stops{0};
    const SpaceCells cells = cells_of(*set);
    for (const CellPlane& cell_plane : cells.planes()) {
      const Plane3 plane = to_plane(cell_plane);
      const Rational climb = plane.a * d.x + plane.b * d.y + plane.c * d.z;
      if (climb == 0) continue;
      const Rational t = -(plane.a * p.x + plane.b * p.y + plane.c * p.z + plane.d) / climb;
      if (t > 0) stops.push_back(t);
    }
    std::sort(stops.begin(), stops.end());
    stops.erase(std::unique(stops.begin(), stops.end()), stops.end());
    std::optional<Rational> marked, boundary;
    for (std::size_t i = 0; i < stops.size(); ++i) {
      const Rational next = i + 1 < stops.size() ? stops[i + 1] : Rational(stops[i] + 2);
      for (const Rational& t : {stops[i], Rational((stops[i] + next) / 2)}) {
        if (!marked && a.contains(at(t))) marked = stops[i];
        if (!boundary && a.has_on_boundary(at(t))) boundary = stops[i];
      }
    }
    const auto hit = a.shoot(p, d), wall = a.shoot_to_boundary(p, d);
    ASSERT_EQ(hit.has_value(), marked.has_value());
    ASSERT_EQ(wall.has_value(), boundary.has_value());
    if (hit) {
      EXPECT_EQ(hit->point, at(*marked));
    }
    if (wall) {
      EXPECT_EQ(wall->point, at(*boundary));
    }
  }
}

TEST(ManyPoints, AreLocatedLikeOne) {
  const Nef3 solid = box({0, 4}, {0, 4}, {0, 4}) - box({1, 3}, {1, 3}, {1, 3});
  std::vector<Point3> points;
  for (int i = 0; i < 125; ++i)
    points.push_back({1.0 * (i % 5), 1.0 * (i / 5 % 5), 0.75 * (i / 25)});
  std::vector<Mark> marked(points.size());
  solid.contains(points, marked);
  for (std::size_t i = 0; i < points.size(); ++i) {
    EXPECT_EQ(marked[i] == 1, solid.contains(points[i]));
  }
  EXPECT_THROW(solid.contains(points, std::span(marked).first(3)), Error);
  EXPECT_GT(solid.bytes(), 1000U);
  EXPECT_LT(solid.bytes(), 100000U);
}

// ---------------------------------------------------------------- soups

TEST(Soups, HoldEveryFacet) {
  Context context;
  const Nef3 set = box({0, 4}, {0, 4}, {0, 4}) + square(7) +
                   (Nef3::half_space({0, 0, -1, 20}, Boundary::Closed) + Nef3::point({9, 9, 9}));
  const MeshOfComplex soup = soup_of_complex(set.complex(), {MeshFaces::Polygons}, context);
  EXPECT_EQ(soup.mesh.face_count(), 7U);
  EXPECT_TRUE(soup.report.is_unbounded);
  EXPECT_EQ(soup.report.dropped.facets, 0U);
  EXPECT_EQ(soup.report.dropped.vertices, 5U) << "the point, and the corners of the square";
  MeshOptions options;
  options.surface = true;
  const Nef3 sheets = Nef3::from_facets(complex_of_mesh(soup.mesh, options, context), context);
  EXPECT_TRUE(sheets == box({0, 4}, {0, 4}, {0, 4}).boundary() + square(7));
}

// ---------------------------------------------------------------- origins

Nef3 with_first_origin(const Nef3& set, std::uint32_t first) {
  std::vector<std::uint32_t> origin(set.complex().facet_count());
  for (std::uint32_t& id : origin) id = first++;
  return set.with_origins(origin);
}

/// Every facet of a result lies in the plane of an operand's facet that has its id.
TEST(Origins, SurviveBooleans) {
  const Nef3 a = with_first_origin(box({0, 4}, {0, 4}, {0, 4}), 100);
  const Nef3 b = with_first_origin(box({2, 6}, {1, 5}, {0, 3}), 200);
  const auto plane_of = [&](std::uint32_t id) {
    const SpaceComplex& c = (id < 200 ? a : b).complex();
    return c.planes().primitive(c.facet_plane[id % 100]);
  };
  for (const Nef3& result : {a + b, a * b, a - b, b - a, a ^ b, (a - b) + b, (!a + b).closure()}) {
    const SpaceComplex& c = result.complex();
    ASSERT_GT(c.facet_count(), 0U);
    for (std::size_t f = 0; f < c.facet_count(); ++f) {
      if (c.facet_mark[f] == kBeyond) continue;
      const std::uint32_t id = c.facet_origin[f];
      ASSERT_TRUE((id >= 100 && id < 106) || (id >= 200 && id < 206));
      EXPECT_EQ(c.planes().primitive(c.facet_plane[f]), plane_of(id));
    }
  }
  // What lies side by side in a plane is one facet, with the lesser id.
  const Nef3 wide = box({0, 4}, {0, 4}, {0, 4}) + box({4, 6}, {0, 4}, {0, 4});
  EXPECT_EQ(wide.counts().facets, 6U);
  const Nef3 left = with_first_origin(box({0, 4}, {0, 4}, {0, 4}), 10);
  const Nef3 right = with_first_origin(box({4, 6}, {0, 4}, {0, 4}), 20);
  for (const Nef3& both : {left + right, right + left}) {
    const auto& origin = both.complex().facet_origin;
    EXPECT_EQ(std::ranges::count_if(origin, [](std::uint32_t id) { return id < 20; }), 5);
    EXPECT_TRUE(both == wide) << "origins are not compared";
  }
  EXPECT_THROW(left.with_origins(std::array{1U}), Error);
}

// ---------------------------------------------------------------- selective Booleans

bool is_chosen(SpaceItem item, std::uint64_t salt) {
  return ((item.code() * 0x9e3779b97f4a7c15U + salt) >> 33U) % 3 != 0;
}

SpaceSelector selector(std::uint64_t salt) {
  return {[salt](VertexId v) { return is_chosen(v, salt); },
          [salt](EdgeId e) { return is_chosen(e, salt); },
          [salt](FacetId f) { return is_chosen(f, salt); },
          [salt](VolumeId v) { return is_chosen(v, salt); }};
}

/// The twin's marks, without those of items that are not chosen.
CellMarks chosen(const SpaceCells& cells, const TwoSpaceSets& sets, std::uint64_t salt) {
  CellMarks marks = sets.twin;
  for (std::size_t c = 0; c < cells.size(); ++c) {
    const SpaceItem item = sets.engine.locate(to_rational(cells[c].point)).item;
    marks[c] = marks[c] && is_chosen(item, salt);
  }
  return marks;
}

TEST(SelectiveBooleans, CountOthersAsUnmarked) {
  for (std::uint64_t seed = 0; seed < 24 && !HasFailure(); ++seed) {
    SCOPED_TRACE(seed);
    Dice dice(seed);
    Context context;
    const auto one = random_set(dice, 3);
    const auto two = random_set(dice, 2);
    const auto op = static_cast<SetOperator>(seed % 4);
    const SpaceCells cells = cells_of(*apply(op, one, two));
    const TwoSpaceSets a{to_nef(*one), marks_of(*one, cells)};
    const TwoSpaceSets b{to_nef(*two), marks_of(*two, cells)};
    const TwoSpaceSets result{
        boolean_op(a.engine, selector(seed), b.engine, selector(~seed), function_of(op), context),
        combined(function_of(op), chosen(cells, a, seed), chosen(cells, b, ~seed))};
    EXPECT_EQ(difference(cells, result), "");
    EXPECT_TRUE(boolean_op(a.engine, {}, b.engine, {}, function_of(op), context) ==
                boolean_op(a.engine, b.engine, function_of(op), context));
  }
}

}  // namespace
}  // namespace plumb::testing::nef3_queries_test
