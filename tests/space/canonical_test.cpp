// Equal sets are the same bytes in canonical form, however they were made.
#include "plumb/space/canonical.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <sstream>
#include <stop_token>
#include <string>
#include <vector>

#include "generate/meshes.h"
#include "generate/space_program.h"
#include "generate/test_share.h"
#include "oracle/nef3_check.h"
#include "oracle/program_property.h"
#include "plumb/io/mesh_io.h"
#include "plumb/io/nef3_reader.h"
#include "plumb/io/nef3_writer.h"
#include "plumb/predicates/error.h"
#include "plumb/space/set/compare_complexes.h"
#include "plumb/space/space_audit.h"
#include "plumb/testing/dice.h"

namespace plumb::testing::canonical_test {
namespace {

std::string text_of(const Nef3& set) {
  std::ostringstream out;
  write_nef3(out, set.complex());
  return std::move(out).str();
}

Nef3 canonical_of(const Nef3& set) {
  Context context;
  return canonical(set, context);
}

std::string bytes_of(const Nef3& set) { return text_of(canonical_of(set)); }

Nef3 read(const std::string& text) {
  Context context;
  return Nef3::from_minimal_unchecked(read_nef3(text, {"canonical.nef", false}, context));
}

/// The set itself, in minimal form, which canonical() leaves as it is, in a file too.
void expect_canonical_form(const Nef3& set) {
  const Nef3 form = canonical_of(set);
  EXPECT_TRUE(form == set);
  EXPECT_EQ(form.counts(), set.counts());
  const auto flaw = audit(form.complex(), AuditForm::Minimal);
  EXPECT_FALSE(flaw) << flaw->invariant << ": " << flaw->place;
  EXPECT_TRUE(is_identical(canonical_of(form).complex(), form.complex()));
  const Nef3 copy = read(text_of(form));
  EXPECT_TRUE(is_identical(copy.complex(), form.complex()));
  EXPECT_EQ(bytes_of(copy), text_of(form));
}

struct Route {
  const char* name;
  Nef3 set;
};

AffineMap3 mapping(const std::array<std::array<Rational, 3>, 3>& matrix, const Rational& by) {
  return {matrix, {by, -by, 2 * by}};
}

/// The first set again, by way of the second.
std::vector<Route> routes(const Nef3& a, const Nef3& b) {
  const std::array<std::array<Rational, 3>, 3> same{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  const std::array<std::array<Rational, 3>, 3> third{
      {{Rational(1, 3), 0, 0}, {0, -1, 0}, {0, 0, 1}}};
  const std::array<std::array<Rational, 3>, 3> thrice{{{3, 0, 0}, {0, -1, 0}, {0, 0, 1}}};
  const Rational by(22, 7);
  return {{"parts", (a - b) + (a * b)},
          {"parts the other way round", (b * a) + (a - b)},
          {"absorption", a * (b + a)},
          {"difference twice", (b ^ a) ^ b},
          {"complement twice", !(!a + !(a + b))},
          {"there and back", a.transformed(mapping(same, by)).transformed(mapping(same, -by))},
          {"scaled and back", a.transformed(mapping(third, 0)).transformed(mapping(thrice, 0))},
          {"a file", read(text_of(a))}};
}

void expect_one_form(const Nef3& a, const Nef3& b) {
  expect_canonical_form(a);
  const std::string bytes = bytes_of(a);
  for (const Route& route : routes(a, b)) {
    EXPECT_TRUE(route.set == a) << route.name;
    EXPECT_EQ(bytes_of(route.set), bytes) << route.name;
  }
  EXPECT_EQ(bytes_of(b) == bytes, a == b);
  EXPECT_NE(bytes_of(!a), bytes);
}

// ---------------------------------------------------------------- any sets

class CanonicalSets : public ::testing::TestWithParam<int> {};

TEST_P(CanonicalSets, DoNotTellHowTheyWereMade) {
  const auto values = static_cast<ProgramValues>(GetParam());
  const std::uint64_t rounds = share_of(values == ProgramValues::Plain ? 50 : 12);
  for (std::uint64_t seed = 0; seed < rounds && !HasFailure(); ++seed) {
    SCOPED_TRACE(seed);
    Dice dice(seed * kProgramValues + static_cast<std::uint64_t>(GetParam()));
    const auto one = space_set_of_program(random_space_program(dice, values, 2 + seed % 5), 9);
    const auto two = space_set_of_program(random_space_program(dice, values, 2), 9);
    SCOPED_TRACE(to_text(*one) + "\n" + to_text(*two));
    expect_one_form(to_nef(*one), to_nef(*two));
  }
}

std::string name_of_values(const ::testing::TestParamInfo<int>& tested) {
  static constexpr const char* kNames[] = {"Plain", "Tenths", "Thirds", "Far",
                                           "Large", "Small",  "Uneven", "Long"};
  return kNames[tested.param];
}

INSTANTIATE_TEST_SUITE_P(Values, CanonicalSets, ::testing::Range(0, kProgramValues),
                         name_of_values);

TEST(Canonical, AnyProgramHasOneForm) {
  const auto set_of = [](std::span<const std::uint8_t> program) {
    return to_nef(*space_set_of_program(program, 9));
  };
  expect_no_flaw_of_programs("one form", 10, [&](std::span<const std::uint8_t> program) {
    return first_failure([&] {
      expect_one_form(set_of(part_of_program(program, 0, 2)),
                      set_of(part_of_program(program, 1, 2)));
    });
  });
}

// ---------------------------------------------------------------- meshes

template <class T>
void shuffle(std::vector<T>& items, Dice& dice) {
  for (std::size_t i = items.size(); i > 1; --i) std::swap(items[i - 1], items[dice.below(i)]);
}

/// Vertices and faces in another order, faces from another corner on.
PolygonMesh shuffled(const PolygonMesh& mesh, Dice& dice) {
  std::vector<std::uint32_t> vertices(mesh.points.size()), faces(mesh.face_count());
  for (std::uint32_t i = 0; i < vertices.size(); ++i) vertices[i] = i;
  for (std::uint32_t i = 0; i < faces.size(); ++i) faces[i] = i;
  shuffle(vertices, dice);
  shuffle(faces, dice);
  PolygonMesh result;
  result.points.resize(vertices.size());
  for (std::size_t i = 0; i < vertices.size(); ++i) result.points[vertices[i]] = mesh.points[i];
  for (const std::uint32_t f : faces) {
    std::vector<std::uint32_t> face;
    for (const std::uint32_t v : mesh.face(f)) face.push_back(vertices[v]);
    std::rotate(face.begin(), face.begin() + dice.below(face.size()), face.end());
    result.add_face(face);
  }
  return result;
}

Nef3 set_of(const PolygonMesh& mesh) {
  Context context;
  return Nef3::from_mesh(mesh, {.rule = WindingRule::NonZero}, context);
}

TEST(Canonical, OrderOfFacesAndVerticesIsNotTold) {
  Context context;
  const PolygonMesh hole =
      read_mesh_file("corpus/solids/square-hole.off", {}, {}, context).mesh;  // facets with holes
  const PolygonMesh hollow = joined(box_mesh({-3, -3, -3}, {3, 3, 3}),
                                    reversed(icosphere_mesh(1, 1, {0.25, 0, 0})));  // a void
  const PolygonMesh crossing =
      joined(icosphere_mesh(2, 1, {0, 0, 0}), box_mesh({-0.0, 0, 0.3}, {2, 2, 2}));
  Dice dice(1);
  for (const PolygonMesh& mesh : {hole, hollow, crossing}) {
    const Nef3 set = set_of(mesh);
    const std::string bytes = bytes_of(set);
    expect_canonical_form(set);
    for (int i = 0; i < 3; ++i) EXPECT_EQ(bytes_of(set_of(shuffled(mesh, dice))), bytes);
    EXPECT_EQ(bytes_of(set_of(fanned(mesh))), bytes) << "triangles are joined";
    EXPECT_NE(bytes_of(set.interior()), bytes);
  }
}

// ---------------------------------------------------------------- what is given in several ways

Plane3 across(std::size_t axis, const Rational& at) {
  std::array<Rational, 3> n{0, 0, 0};
  n[axis] = 1;
  return {n[0], n[1], n[2], -at};
}

TEST(Canonical, PointsOfAnyPlanes) {
  const Rational third(1, 3);
  const RationalPoint3 at{third, 2, -5 * third};
  const Nef3 point = Nef3::point(at);
  Nef3 met = Nef3::plane({1, 1, 1, -2 + 4 * third}) * Nef3::plane({3, 0, 0, -1}) *
             Nef3::plane({1, -1, 0, 2 - third});
  EXPECT_EQ(bytes_of(met), bytes_of(point));
  // On a line, in a plane: with one or two planes of their own.
  const Nef3 plane = Nef3::plane({1, 1, 1, -2 + 4 * third});
  EXPECT_EQ(bytes_of(plane - met), bytes_of(plane - point));
  EXPECT_NE(bytes_of(plane - met), bytes_of(plane));
  const Nef3 line = plane * Nef3::plane({3, 0, 0, -1});
  EXPECT_EQ(bytes_of(line - met), bytes_of(line - point));
  // A point that doubles hold, without the sign of zero.
  const Nef3 origin = Nef3::point({0, 0, 0});
  met = Nef3::plane({1, 2, 3, 0}) * Nef3::plane({3, 2, 1, 0}) * Nef3::plane({1, -1, 0, 0});
  EXPECT_EQ(bytes_of(met), bytes_of(origin));
  Context context;
  const Nef3 box = set_of(box_mesh({-0.0, -0.0, -0.0}, {1, 1, 1}));
  EXPECT_EQ(bytes_of(box), bytes_of(set_of(box_mesh({0, 0, 0}, {1, 1, 1}))));
}

TEST(Canonical, EdgesOfAnyPlanes) {
  const auto slab = [](std::size_t axis, const Rational& from, const Rational& to) {
    const Plane3 low = across(axis, from), high = across(axis, to);
    return !Nef3::half_space(low, Boundary::Open) * Nef3::half_space(high, Boundary::Closed);
  };
  const std::vector<std::array<RationalPoint3, 2>> ends{
      {{{0, 0, 0}, {3, 0, 0}}},
      {{{0, 0, 0}, {3, 3, 0}}},
      {{{0, 1, 0}, {3, 4, 5}}},
      {{{0, Rational(1, 7), 1}, {3, Rational(22, 7), Rational(2, 3)}}}};
  for (const auto& [a, b] : ends) {
    // Through both ends: planes that hold one more point.
    const auto plane_with = [&a = a, &b = b](const RationalPoint3& c) {
      const Rational ux = b.x - a.x, uy = b.y - a.y, uz = b.z - a.z;
      const Rational vx = c.x - a.x, vy = c.y - a.y, vz = c.z - a.z;
      const Rational x = uy * vz - uz * vy, y = uz * vx - ux * vz, z = ux * vy - uy * vx;
      return Nef3::plane({x, y, z, -(x * a.x + y * a.y + z * a.z)});
    };
    const Nef3 line = plane_with({1, 7, 2}) * plane_with({-5, 2, 11});
    const Nef3 other = plane_with({4, -3, 1}) * plane_with({1, 1, -9});
    EXPECT_EQ(bytes_of(line), bytes_of(other)) << "to infinity";
    const Nef3 segment = Nef3::segment(a, b);
    EXPECT_EQ(bytes_of(line * slab(0, 0, 3)), bytes_of(segment));
    EXPECT_EQ(bytes_of(Nef3::segment(b, a)), bytes_of(segment));
    expect_canonical_form(segment);
  }
  // Edges of a facet alone: the other plane is nobody's.
  const Nef3 square =
      Nef3::facet(std::array<Point3, 4>{{{0, 0, 1}, {3, 0, 1}, {3, 3, 4}, {0, 3, 4}}});
  const Nef3 cut = Nef3::plane({0, 1, -1, 1}) * slab(0, 0, 3) * slab(1, 0, 3);
  const Nef3 again = Nef3::plane({0, 1, -1, 1}) * slab(0, 0, 3) * slab(2, 1, 4);
  EXPECT_EQ(bytes_of(cut), bytes_of(square));
  EXPECT_EQ(bytes_of(again), bytes_of(square));
}

TEST(Canonical, IdsOfFacetsAreDropped) {
  const Nef3 set = set_of(box_mesh({0, 0, 0}, {1, 1, 1}));
  std::vector<std::uint32_t> origins(set.complex().facet_count());
  for (std::uint32_t& id : origins) id = static_cast<std::uint32_t>(&id - origins.data()) % 3;
  EXPECT_EQ(bytes_of(set.with_origins(origins)), bytes_of(set));
}

TEST(Canonical, NothingAndEverything) {
  EXPECT_EQ(bytes_of(Nef3()), text_of(Nef3()));
  EXPECT_EQ(bytes_of(!Nef3()), text_of(Nef3::whole()));
  const Nef3 below = Nef3::half_space(across(2, 1), Boundary::Open);
  expect_one_form(below, Nef3::half_space({1, 1, 1, 0}, Boundary::Closed));
}

// ---------------------------------------------------------------- limits

TEST(Canonical, CanBeStoppedAndLimited) {
  const Nef3 set = set_of(icosphere_mesh(2, 1, {0, 0, 0}));
  std::stop_source stop;
  stop.request_stop();
  Context stopped(Limits{}, stop.get_token());
  EXPECT_THROW(canonical(set, stopped), Error);
  Limits small;
  small.max_memory_bytes = set.bytes();
  Context limited(small);
  EXPECT_THROW(canonical(set, limited), Error);
}

}  // namespace
}  // namespace plumb::testing::canonical_test
