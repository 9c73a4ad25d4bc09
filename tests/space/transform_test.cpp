// Affine images of any set: against the set made of mapped planes and points, and the laws of maps.
#include <gtest/gtest.h>

#include <algorithm>

#include "generate/meshes.h"
#include "generate/space_program.h"
#include "generate/space_solids.h"
#include "oracle/nef3_check.h"
#include "plumb/predicates/error.h"
#include "plumb/space/boolean/frame.h"
#include "plumb/space/space_audit.h"

namespace plumb::testing::transform_test {
namespace {

// ---------------------------------------------------------------- maps

AffineMap3 inverse(const AffineMap3& map) {
  const RationalMatrix columns = cofactors(map.matrix);
  const Rational det = determinant(map.matrix);
  AffineMap3 result;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) result.matrix[i][j] = columns[j][i] / det;
    result.offset[i] = -plumb::dot(result.matrix[i], map.offset);
  }
  return result;
}

/// x -> second(first(x)).
AffineMap3 after(const AffineMap3& second, const AffineMap3& first) {
  AffineMap3 result;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      const RationalRow column{first.matrix[0][j], first.matrix[1][j], first.matrix[2][j]};
      result.matrix[i][j] = plumb::dot(second.matrix[i], column);
    }
    result.offset[i] = plumb::dot(second.matrix[i], first.offset) + second.offset[i];
  }
  return result;
}

const Rational kThird(1, 3), kThreeFifths(3, 5), kFourFifths(4, 5);

/// One of each kind, then random ones.
AffineMap3 some_map(Dice& dice, std::uint64_t kind) {
  switch (kind) {
    case 0:
      return {{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}, {1, -2, kThird}};
    case 1:
      return {{{{0, -1, 0}, {1, 0, 0}, {0, 0, 1}}}, {0, 0, 0}};
    case 2:
      return {{{{0, 0, 3}, {-3, 0, 0}, {0, 3, 0}}}, {7, 0, 1}};
    case 3:
      return {{{{2, 0, 0}, {0, 1, 0}, {0, 0, kThird}}}, {0, 0, 0}};
    case 4:
      return {{{{1, 1, 0}, {0, 1, 0}, {0, 0, 1}}}, {0, kThird, 0}};
    case 5:
      return {{{{kThreeFifths, -kFourFifths, 0}, {kFourFifths, kThreeFifths, 0}, {0, 0, 1}}},
              {1, 1, 1}};
    case 6:
      return {{{{-1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}, {5, 0, 0}};
    case 8:  // Doubles, so that images of points have a power of two as denominator.
      return {{{{0.6, -0.8, 0}, {0.8, 0.6, 0}, {0, 0, 0.7}}}, {0.1, -0.25, 0x1p-70}};
    case 9:
      return {{{{0.5, 0, 0}, {0, -4, 0}, {0, 0, 1}}}, {0.75, 0, 0x1p-1060}};
    case 10:  // Some doubles go to doubles, others do not.
      return {{{{0, 1, 0}, {-1, 0, 0}, {0, 0, 0.1}}}, {0.1, 0x1p53, -7}};
    default:
      break;
  }
  AffineMap3 map;
  do {
    for (std::size_t i = 0; i < 3; ++i) {
      for (Rational& x : map.matrix[i]) x = dice.between(-3, 3);
      const std::int64_t above = dice.between(-5, 5);
      map.offset[i] = Rational(above, dice.between(1, 3));
    }
  } while (determinant(map.matrix) == 0);
  return map;
}

// ---------------------------------------------------------------- expressions under maps

ExactPoint3 image(const AffineMap3& map, const ExactPoint3& p) {
  const auto coordinate = [&](std::size_t i) -> BigRational {
    const auto& row = map.matrix[i];
    return exact_of(row[0]) * p.x + exact_of(row[1]) * p.y + exact_of(row[2]) * p.z +
           exact_of(map.offset[i]);
  };
  return {coordinate(0), coordinate(1), coordinate(2)};
}

/// By three of its points, and one on its positive side.
CellPlane image(const AffineMap3& map, const CellPlane& plane) {
  const ExactPoint3 n{plane.n.x, plane.n.y, plane.n.z};
  const ExactPoint3 foot = BigRational(-plane.d, dot(plane.n, plane.n)) * n;
  ExactPoint3 u = cross(n, {1, 0, 0});
  if (u == ExactPoint3{}) u = cross(n, {0, 1, 0});
  const CellPlane result =
      plane_through(image(map, foot), image(map, foot + u), image(map, foot + cross(n, u)));
  return side(result, cell_point(image(map, foot + n))) > 0 ? result : opposite(result);
}

struct Mapped {
  const AffineMap3& map;

  Chain3 operator()(Chain3 points) const {
    for (ExactPoint3& p : points) p = image(map, p);
    return points;
  }
  SpaceSetPointer operator()(const HalfSpaceLeaf& h) const {
    return space_set(HalfSpaceLeaf{image(map, h.plane), h.closed});
  }
  SpaceSetPointer operator()(const PlaneLeaf& p) const {
    return space_set(PlaneLeaf{image(map, p.plane)});
  }
  SpaceSetPointer operator()(MeshLeaf m) const {
    m.points = (*this)(m.points);
    if (determinant(map.matrix) < 0) {
      for (auto& face : m.faces) std::reverse(face.begin(), face.end());
    }
    return space_set(m);
  }
  SpaceSetPointer operator()(const PolygonLeaf& p) const {
    return space_set(PolygonLeaf{(*this)(p.corners)});
  }
  SpaceSetPointer operator()(ChainsLeaf c) const {
    for (Chain3& chain : c.chains) chain = (*this)(chain);
    return space_set(c);
  }
  SpaceSetPointer operator()(const PointsLeaf& p) const {
    return space_set(PointsLeaf{(*this)(p.points)});
  }
  SpaceSetPointer operator()(const SpaceOperation& o) const {
    return testing::apply(o.op, std::visit(*this, o.first->node),
                          o.second ? std::visit(*this, o.second->node) : nullptr);
  }
};

SpaceSetPointer mapped(const SpaceSet& set, const AffineMap3& map) {
  return std::visit(Mapped{map}, set.node);
}

/// Meshes of more than one solid: engine_nef3.cpp takes them with coordinates in doubles only.
bool has_mesh_of_many(const SpaceSet& set) {
  if (const auto* mesh = std::get_if<MeshLeaf>(&set.node)) return mesh->points.size() > 8;
  const auto* o = std::get_if<SpaceOperation>(&set.node);
  return o != nullptr &&
         (has_mesh_of_many(*o->first) || (o->second && has_mesh_of_many(*o->second)));
}

SpaceSetPointer random_set(Dice& dice, std::size_t records,
                           ProgramValues values = ProgramValues::Plain) {
  for (;;) {
    const auto set = space_set_of_program(random_space_program(dice, values, records), 8);
    if (!has_mesh_of_many(*set)) return set;
  }
}

void expect_clean(const Nef3& set) {
  const auto flaw = audit(set.complex(), AuditForm::Minimal);
  EXPECT_FALSE(flaw.has_value()) << flaw->invariant << " at " << flaw->place;
}

TEST(MappedSets, AreSetsOfMappedPlanes) {
  std::size_t unbounded = 0;
  for (std::uint64_t seed = 0; seed < 240 && !HasFailure(); ++seed) {
    SCOPED_TRACE(seed);
    Dice dice(seed);
    const AffineMap3 map = some_map(dice, seed % 12);
    const auto values = static_cast<ProgramValues>(seed % 7 == 0 ? seed / 7 % kProgramValues : 0);
    const auto set = random_set(dice, 2 + seed % 5, values);
    SCOPED_TRACE(to_text(*set));
    const Nef3 a = to_nef(*set), image = a.transformed(map);
    expect_clean(image);
    EXPECT_TRUE(image == to_nef(*mapped(*set, map)));
    EXPECT_TRUE(image.transformed(inverse(map)) == a);
    unbounded += has_frame(a.complex()) ? 1 : 0;
  }
  EXPECT_GT(unbounded, 80U);
}

TEST(MappedSets, HoldTheMappedPoints) {
  for (std::uint64_t seed = 100; seed < 110 && !HasFailure(); ++seed) {
    SCOPED_TRACE(seed);
    Dice dice(seed);
    const AffineMap3 map = some_map(dice, 7);
    const auto set = random_set(dice, 3);
    const Nef3 image = to_nef(*set).transformed(map);
    const SpaceCells cells = cells_of(*set);
    const CellMarks marks = marks_of(*set, cells);
    for (std::size_t c = 0; c < cells.size(); ++c) {
      EXPECT_EQ(image.contains(to_rational(transform_test::image(map, cells[c].point))), marks[c]);
    }
  }
}

TEST(MappedSets, ObeyTheLaws) {
  for (std::uint64_t seed = 200; seed < 260 && !HasFailure(); ++seed) {
    SCOPED_TRACE(seed);
    Dice dice(seed);
    const AffineMap3 map = some_map(dice, seed % 10), next = some_map(dice, 7);
    const auto one = random_set(dice, 3);
    const auto two = random_set(dice, 2);
    const Nef3 a = to_nef(*one), b = to_nef(*two);
    const Nef3 ma = a.transformed(map), mb = b.transformed(map);
    EXPECT_TRUE((a + b).transformed(map) == ma + mb);
    EXPECT_TRUE((a ^ b).transformed(map) == (ma ^ mb));
    EXPECT_TRUE((a - b).closure().transformed(map) == (ma - mb).closure());
    EXPECT_TRUE((!a).transformed(map) == !ma);
    EXPECT_TRUE(ma.transformed(next) == a.transformed(after(next, map)));
    EXPECT_EQ(ma.counts(), a.counts());
    EXPECT_EQ(ma.is_bounded(), a.is_bounded());
  }
}

/// Sets of many planes are mapped in integers of fixed widths, while these hold the numbers, which
/// grow with each map. Vertices keep their ids, and a clean set has its vertices on its planes.
TEST(MappedSets, OfManyPlanesAreExact) {
  for (std::uint64_t seed = 0; seed < 12 && !HasFailure(); ++seed) {
    SCOPED_TRACE(seed);
    Dice dice(seed);
    Context context;
    Nef3 set = Nef3::from_mesh(icosphere_mesh(1, 1, {0.1, 0.2, 0.3}),
                               {.rule = WindingRule::Positive}, context);
    set = set - set.transformed(some_map(dice, seed % 12));
    const Nef3 first = set;
    AffineMap3 back = some_map(dice, 0);
    for (std::uint64_t step = 0; step < 5 && !HasFailure(); ++step) {
      const AffineMap3 map = some_map(dice, step == 3 ? 8 : (seed + 5 * step) % 12);
      const Nef3 image = set.transformed(map);
      expect_clean(image);
      const SpaceComplex &from = set.complex(), &to = image.complex();
      ASSERT_EQ(from.vertex_count(), to.vertex_count());
      for (std::size_t v = 0; v < from.vertex_count(); ++v) {
        const RationalPoint3 x = exact(from.points(), from.vertex_point[VertexId(v)]);
        EXPECT_EQ(
            exact(to.points(), to.vertex_point[VertexId(v)]),
            to_rational(transform_test::image(map, {exact_of(x.x), exact_of(x.y), exact_of(x.z)})));
      }
      back = step == 0 ? inverse(map) : after(back, inverse(map));
      set = image;
    }
    EXPECT_TRUE(set.transformed(back) == first);
  }
}

// ---------------------------------------------------------------- the box in which a set is mapped

/// Planes and lines towards the corners and edges of the frame: a shift changes what meets there.
TEST(MappedSets, TowardsCornersOfTheFrame) {
  const AffineMap3 shift{{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}, {3, 0, -1}};
  const Nef3 diagonal = Nef3::plane({1, -1, 0, 0}), other = Nef3::plane({0, 1, -1, 0});
  EXPECT_FALSE(is_general(diagonal.complex(), frame_box().normal));
  EXPECT_TRUE(is_general(Nef3::plane({1, 0, 0, 5}).complex(), frame_box().normal));
  EXPECT_TRUE(diagonal.transformed(shift) == Nef3::plane({1, -1, 0, -3}));
  const Nef3 both = diagonal + other;
  expect_clean(both.transformed(shift));
  EXPECT_TRUE(both.transformed(shift) == Nef3::plane({1, -1, 0, -3}) + Nef3::plane({0, 1, -1, -1}));
  const Nef3 line = diagonal * other;
  EXPECT_TRUE(line.transformed(shift) == Nef3::plane({1, -1, 0, -3}) * Nef3::plane({0, 1, -1, -1}));
  const Nef3 ray = line * Nef3::half_space({1, 0, 0, 0}, Boundary::Closed);
  EXPECT_TRUE(ray.transformed(shift) ==
              line.transformed(shift) * Nef3::half_space({1, 0, 0, -3}, Boundary::Closed));
}

/// Numbers that have passed through a map and its inverse have common factors, which do not stay.
TEST(MappedSets, DoNotGrowWithTheNumberOfMaps) {
  const AffineMap3 turn{
      {{{kThreeFifths, -kFourFifths, 0}, {kFourFifths, kThreeFifths, 0}, {0, 0, 1}}},
      {kThird, 0, 0}};
  const AffineMap3 shear{{{{0.1, 0.7, 0}, {0, 0.3, 1}, {1, 0, 0.9}}}, {1, 2, 3}};
  for (const AffineMap3& map : {turn, shear}) {
    Dice dice(5);
    const Nef3 a = to_nef(*random_set(dice, 5)).transformed(map);
    Nef3 moved = a;
    const std::size_t bytes = moved.transformed(inverse(map)).transformed(map).bytes();
    for (int i = 0; i < 12; ++i) moved = moved.transformed(inverse(map)).transformed(map);
    EXPECT_TRUE(moved == a);
    EXPECT_LE(moved.bytes(), bytes + bytes / 4);
  }
}

/// A point where an edge meets a plane is defined by input points. Under maps of doubles to
/// doubles, these stay input points.
TEST(MappedSets, KeepPointsOfEdgesShort) {
  Dice dice(3);
  const Nef3 a = to_nef(*space_set(tetrahedron({0, 0, 0}, {8, 0, 0}, {0, 8, 0}, {0, 0, 8})));
  const Nef3 cut = a - a.transformed({{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}, {1, 2, 0.5}});
  const AffineMap3 mirror{{{{0, -1, 0}, {1, 0, 0}, {0, 0, 2}}}, {5, 0, 0.25}};
  const Nef3 image = cut.transformed(mirror);
  expect_clean(image);
  EXPECT_TRUE(image.transformed(inverse(mirror)) == cut);
  const auto planes_of_coefficients = [](const SpaceComplex& c) {
    return std::count_if(c.facet_plane.begin(), c.facet_plane.end(),
                         [&](PlaneId p) { return c.planes().source(p).is_explicit(); });
  };
  EXPECT_EQ(planes_of_coefficients(image.complex()), planes_of_coefficients(cut.complex()));
  const AffineMap3 turn = some_map(dice, 8);
  expect_clean(cut.transformed(turn));
  EXPECT_TRUE(cut.transformed(turn).transformed(inverse(turn)) == cut);
}

TEST(MappedSets, KeepNoPlaneOfABox) {
  const AffineMap3 shear{{{{1, 2, 0}, {0, 1, 0}, {0, 3, -1}}}, {kThird, 0, 7}};
  const Nef3 wedge = Nef3::half_space({1, -1, 0, 0}, Boundary::Closed) *
                     Nef3::half_space({1, 1, 0, 0}, Boundary::Closed);
  Nef3 moved = wedge;
  for (int i = 0; i < 8; ++i) moved = moved.transformed(shear).transformed(inverse(shear));
  EXPECT_TRUE(moved == wedge);
  const PlaneTable& planes = moved.complex().planes();
  EXPECT_LE(planes.size(), 11U) << "three axes, two planes, six of the frame";
  EXPECT_THROW(wedge.transformed({{{{1, 0, 0}, {1, 0, 0}, {0, 0, 1}}}, {0, 0, 0}}), Error);
}

}  // namespace
}  // namespace plumb::testing::transform_test
