// Contacts of random and special complexes against all pairs of items in rational coordinates.
// PLUMB_CASES=n: n random scenes instead of the short run.
#include "plumb/space/boolean/find_contacts.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <utility>

#include "generate/complex_draft.h"
#include "generate/test_share.h"
#include "oracle/contacts.h"
#include "plumb/predicates/point3_signs.h"
#include "plumb/space/boolean/thin_leaves.h"

namespace plumb::find_contacts_test {
namespace {

using testing::BigRational;
using testing::ComplexDraft;
using testing::Dice;
using testing::ExactPoint3;
using testing::ExpectedContact;

std::string name_of(SpaceItem item) {
  return std::string(1, "vefc"[static_cast<std::size_t>(item.kind())]) +
         std::to_string(item.index());
}
std::string name_of(SpaceItem a, SpaceItem b) { return name_of(a) + " x " + name_of(b); }

/// How often each kind of contact was seen, so that a family that tests nothing is noticed.
using Census = std::map<std::string, int>;

struct Scene {
  ComplexDraft a;
  ComplexDraft b;
};

void check(const Scene& scene, Dice& dice, Census& census) {
  const auto tables = std::make_shared<SpaceTables>();
  const SpaceComplex a = build_complex(scene.a, tables, dice);
  const SpaceComplex b = build_complex(scene.b, tables, dice);
  Context context;
  const std::vector<Contact> contacts = find_contacts(a, b, *tables, context);
  const std::vector<ExpectedContact> expected = contacts_by_force(scene.a, a, scene.b, b);
  std::vector<std::string> found_names, expected_names;
  for (const Contact& c : contacts) found_names.push_back(name_of(c.a, c.b));
  for (const ExpectedContact& c : expected) expected_names.push_back(name_of(c.a, c.b));
  ASSERT_EQ(found_names, expected_names);  // sorted, each once
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    EXPECT_EQ(testing::exact_of(exact(tables->points, contacts[i].point)), expected[i].point)
        << found_names[i];
    const bool has_a = contacts[i].a.kind() == SpaceItem::Kind::Vertex;
    const bool has_b = contacts[i].b.kind() == SpaceItem::Kind::Vertex;
    if (has_a || has_b) {
      EXPECT_TRUE(contacts[i].point == (has_a ? a.vertex_point[contacts[i].a.index()]
                                              : b.vertex_point[contacts[i].b.index()]));
    }
    ++census[{name_of(contacts[i].a)[0], name_of(contacts[i].b)[0]}];
  }
}

ExactPoint3 random_point(Dice& dice, int size) {
  return {BigRational(dice.between(0, size)), BigRational(dice.between(0, size)),
          BigRational(dice.between(0, size))};
}

ComplexDraft random_tetrahedron(Dice& dice, int size) {
  for (;;) {
    const ExactPoint3 p = random_point(dice, size), q = random_point(dice, size),
                      r = random_point(dice, size), s = random_point(dice, size);
    if (dot(cross(q - p, r - p), s - p) != 0) return testing::tetrahedron_draft({p, q, r, s});
  }
}

ComplexDraft random_box(Dice& dice, int size) {
  const ExactPoint3 low = random_point(dice, size - 1);
  return testing::box_draft(low, low + ExactPoint3{1, 1, 1} + random_point(dice, 2));
}

/// Not convex; more corners than a leaf of find_contacts() takes.
ComplexDraft random_prism(Dice& dice, int) {
  const std::vector<std::vector<std::array<int, 2>>> kPolygons = {
      {{0, 0}, {3, 0}, {3, 1}, {1, 1}, {1, 3}, {0, 3}},
      {{0, 0}, {3, 0}, {3, 3}, {2, 3}, {2, 1}, {1, 1}, {1, 3}, {0, 3}},
      {{0, 0},
       {4, 0},
       {4, 1},
       {3, 1},
       {3, 2},
       {4, 2},
       {4, 3},
       {0, 3},
       {0, 2},
       {1, 2},
       {1, 1},
       {0, 1}},
      {{0, 0}, {4, 1}, {2, 1}, {4, 2}, {2, 2}, {4, 3}, {2, 3}, {4, 4}, {0, 4}, {2, 2}},
      {{0, 0}, {2, 0}, {1, 2}}};
  const auto& polygon = kPolygons[dice.below(kPolygons.size())];
  const int low = static_cast<int>(dice.between(0, 2));
  return testing::prism_draft(polygon, low, low + static_cast<int>(dice.between(1, 2)));
}

/// A facet with a hole, a slit and vertices inside, dangling in space.
ComplexDraft random_sheet(Dice& dice, int) {
  ComplexDraft draft;
  const int z = static_cast<int>(dice.between(0, 3));
  const auto at = [&](int x, int y) { return draft.add({x, y, z}); };
  ComplexDraft::Facet facet;
  facet.cycles.push_back({at(0, 0), at(6, 0), at(6, 5), at(0, 5)});
  if (dice.below(2) == 0) facet.cycles.push_back({at(1, 1), at(1, 3), at(3, 3), at(3, 1)});
  if (dice.below(2) == 0) facet.cycles.push_back({at(4, 1), at(5, 3)});
  if (dice.below(2) == 0) facet.inner = {at(1, 4), at(4, 4)};
  draft.facets.push_back(facet);
  return draft;
}

/// Two facets in one plane with an edge between them.
ComplexDraft split_square(Dice& dice, int) {
  ComplexDraft draft;
  const int z = static_cast<int>(dice.between(0, 2));
  for (const auto& [x, y] : {std::pair(0, 0), {3, 0}, {3, 3}, {0, 3}}) draft.add({x, y, z});
  const bool is_odd = dice.below(2) == 1;
  draft.facets.push_back(
      {{is_odd ? ComplexDraft::Cycle{0, 1, 2} : ComplexDraft::Cycle{1, 2, 3}}, {}});
  draft.facets.push_back(
      {{is_odd ? ComplexDraft::Cycle{0, 2, 3} : ComplexDraft::Cycle{0, 1, 3}}, {}});
  return draft;
}

ComplexDraft random_chain(Dice& dice, int size) {
  ComplexDraft draft;
  for (int i = 0; i < 4; ++i) {
    const ExactPoint3 p = random_point(dice, size);
    if (!draft.points.empty() && draft.points.back() == p) continue;
    const std::uint32_t v = draft.add(p);
    if (v > 0) draft.free_edges.push_back({v - 1, v});
  }
  return draft;
}

ComplexDraft random_points(Dice& dice, int size) {
  ComplexDraft draft;
  for (int i = 0; i < 5; ++i) draft.add(random_point(dice, size));
  return draft;
}

/// Moves the corners of a plane's coordinates about.
ComplexDraft turned(ComplexDraft draft, std::uint32_t axis) {
  for (ExactPoint3& p : draft.points) {
    if (axis == 1) p = {p.y, p.z, p.x};
    if (axis == 2) p = {p.z, p.x, p.y};
  }
  return draft;
}
ComplexDraft moved(ComplexDraft draft, const ExactPoint3& by) {
  for (ExactPoint3& p : draft.points) p = p + by;
  return draft;
}

using Make = ComplexDraft (*)(Dice&, int);
constexpr Make kShapes[] = {random_tetrahedron, random_box,   random_prism, random_sheet,
                            split_square,       random_chain, random_points};

ComplexDraft random_shape(Dice& dice, int size) {
  const Make make = kShapes[dice.below(std::size(kShapes))];
  ComplexDraft shape = make(dice, size);
  shape = turned(std::move(shape), dice.below(3));
  return moved(std::move(shape), random_point(dice, 1));
}

/// The same linear map for both: nothing stays parallel to an axis, or is a double.
void shear(Scene& scene, Dice& dice) {
  const ExactPoint3 x{3, dice.between(-1, 1), 1}, y{1, 2, dice.between(-1, 1)}, z{-1, 1, 2};
  const BigRational scale = dice.below(2) == 0 ? BigRational(1) : BigRational(1) / 3;
  for (ComplexDraft* draft : {&scene.a, &scene.b}) {
    for (ExactPoint3& p : draft->points) p = scale * (p.x * x + p.y * y + p.z * z);
  }
}

/// Thin tetrahedra along a diagonal, so many that their boxes are compared in a frame of their own.
ComplexDraft needles(Dice& dice, int count) {
  ComplexDraft draft;
  while (count > 0) {
    const int x = static_cast<int>(dice.between(0, 8)), y = static_cast<int>(dice.between(0, 8));
    const ExactPoint3 base{x, y, -x - y};
    const ExactPoint3 p = base + random_point(dice, 1), q = base + random_point(dice, 2);
    const ExactPoint3 r = base + random_point(dice, 2), tip = base + ExactPoint3{60, 60, 60};
    if (dot(cross(q - p, r - p), tip - p) == 0) continue;
    draft.add(testing::tetrahedron_draft({p, q, r, tip}));
    --count;
  }
  return draft;
}

TEST(Meet, AgreesWithAllPairsOnNeedles) {
  Census census;
  for (std::uint64_t seed = 0; seed < 3; ++seed) {
    Dice dice(seed);
    Scene scene{needles(dice, 14), needles(dice, 14)};
    if (seed == 2) scene.b.add(random_chain(dice, 9));
    check(scene, dice, census);
  }
  EXPECT_GT(census["ef"] + census["fe"], 10);
}

TEST(Meet, AgreesWithAllPairsOnRandomShapes) {
  Census census;
  const std::uint64_t cases = testing::case_count(240);
  for (std::uint64_t seed = 0; seed < cases; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Dice dice(seed);
    const int size = static_cast<int>(dice.between(2, 4));
    Scene scene{random_shape(dice, size), random_shape(dice, size)};
    if (dice.below(4) == 0) scene.a.add(random_shape(dice, size));
    if (dice.below(3) == 0) shear(scene, dice);
    check(scene, dice, census);
    if (::testing::Test::HasFatalFailure()) return;
  }
  for (const char* pair : {"vv", "ve", "ev", "vf", "fv", "ee", "ef", "fe"}) {
    EXPECT_GE(census[pair], static_cast<int>(cases / 10)) << pair;
  }
}

TEST(Meet, AgreesWithAllPairsOnSimilarShapes) {
  Census census;
  for (std::uint64_t seed = 0; seed < testing::case_count(60); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Dice dice(seed);
    const ComplexDraft shape = random_shape(dice, 3);
    ExactPoint3 by{0, 0, 0};  // identical operands
    if (seed % 3 == 1) by.x = 1;
    if (seed % 3 == 2) by = {BigRational(1) / 2, dice.between(0, 1), 0};
    Scene scene{shape, moved(shape, by)};
    if (dice.below(2) == 0) shear(scene, dice);
    check(scene, dice, census);
    if (::testing::Test::HasFatalFailure()) return;
  }
}

/// Whether a cell is a part of what a leaf covers: a surface with its boundary, a chain of edges, a
/// vertex.
bool covers(const SpaceComplex& c, const ContactLeaf& leaf, SpaceItem item) {
  if (item == leaf.bare || (leaf.facet.is_valid() && item == SpaceItem(leaf.facet))) return true;
  const auto is_of_edge = [&](EdgeId e) {
    const HalfedgeId h(2 * std::size_t{e.value()});
    return item == SpaceItem(e) || item == SpaceItem(c.origin[h]) || item == SpaceItem(c.target(h));
  };
  const auto is_of_use = [&](UseId u) {
    return is_of_edge(SpaceComplex::edge_of(c.use_halfedge[u]));
  };
  if (leaf.bare.is_valid()) {
    return leaf.bare.kind() == SpaceItem::Kind::Edge && is_of_edge(leaf.bare.edge());
  }
  if (!leaf.facet.is_valid()) {
    UseId u = leaf.first;
    for (std::uint32_t i = 0; i < leaf.count; ++i, u = c.use_next[u]) {
      if (is_of_use(u)) return true;
    }
    return false;
  }
  const auto inner = c.inner_of(leaf.facet);
  if (std::ranges::any_of(inner, [&](VertexId v) { return item == SpaceItem(v); })) return true;
  for (std::size_t u = 0; u < c.use_count(); ++u) {
    if (c.use_facet[UseId(u)] == leaf.facet && is_of_use(UseId(u))) return true;
  }
  return false;
}

/// Expects that trees of oriented boxes find all pairs of leaves that have a contact in common.
void check_thin_leaves(const Scene& scene, Dice& dice, int& expected) {
  const auto tables = std::make_shared<SpaceTables>();
  const SpaceComplex a = build_complex(scene.a, tables, dice);
  const SpaceComplex b = build_complex(scene.b, tables, dice);
  Context context;
  const std::vector<Contact> contacts = find_contacts(a, b, *tables, context);
  const ContactLeaves xs(a, box_of(b)), ys(b, box_of(a));
  std::set<std::pair<std::size_t, std::size_t>> found;
  ThinLeaves::for_each_pair(
      ThinLeaves(xs, [] {}), ThinLeaves(ys, [] {}),
      [&](std::size_t x, std::size_t y) { found.emplace(x, y); }, [] {});
  for (const Contact& contact : contacts) {
    for (std::size_t x = 0; x < xs.boxes().size(); ++x) {
      if (!covers(a, xs[x], contact.a)) continue;
      for (std::size_t y = 0; y < ys.boxes().size(); ++y) {
        if (!covers(b, ys[y], contact.b)) continue;
        ++expected;
        EXPECT_TRUE(found.contains({x, y})) << name_of(contact.a, contact.b);
      }
    }
  }
}

TEST(Meet, OrientedBoxesFindAllLeavesThatMeet) {
  int expected = 0;
  for (std::uint64_t seed = 0; seed < testing::case_count(120); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Dice dice(seed);
    Scene scene{random_shape(dice, 3), random_shape(dice, 3)};
    if (seed % 10 == 0) scene = {needles(dice, 14), needles(dice, 14)};
    if (dice.below(2) == 0) scene.a.add(random_shape(dice, 3));
    if (dice.below(3) == 0) shear(scene, dice);
    check_thin_leaves(scene, dice, expected);
  }
  EXPECT_GT(expected, static_cast<int>(8 * testing::case_count(120)));
}

std::size_t contact_count(const ComplexDraft& a, const ComplexDraft& b) {
  const auto tables = std::make_shared<SpaceTables>();
  Dice dice(1);
  const SpaceComplex x = build_complex(a, tables, dice), y = build_complex(b, tables, dice);
  Context context;
  return find_contacts(x, y, *tables, context).size();
}

TEST(Meet, ApartOrEmptyHasNone) {
  const ComplexDraft box = testing::box_draft({0, 0, 0}, {1, 1, 1});
  EXPECT_EQ(contact_count(box, moved(box, {0, 0, 2})), 0U);
  EXPECT_EQ(contact_count(box, {}), 0U);
  EXPECT_EQ(contact_count({}, box), 0U);
  EXPECT_EQ(contact_count({}, {}), 0U);
  // One inside the other.
  EXPECT_EQ(contact_count(box, testing::box_draft({-1, -1, -1}, {2, 2, 2})), 0U);
}

TEST(Meet, CountsOfBoxes) {
  const ComplexDraft box = testing::box_draft({0, 0, 0}, {2, 2, 2});
  EXPECT_EQ(contact_count(box, box), 8U);
  EXPECT_EQ(contact_count(box, moved(box, {1, 1, 1})), 6U);            // EF
  EXPECT_EQ(contact_count(box, moved(box, {2, 0, 0})), 4U);            // VV
  EXPECT_EQ(contact_count(box, moved(box, {2, 2, 0})), 2U);            // VV
  EXPECT_EQ(contact_count(box, moved(box, {2, 2, 2})), 1U);            // VV
  EXPECT_EQ(contact_count(box, moved(box, {2, 1, 1})), 1U + 1U + 2U);  // VF FV EE
  EXPECT_EQ(contact_count(box, moved(box, {1, 0, 0})), 8U);            // VE EV
}

TEST(Meet, StopsWhenAsked) {
  ComplexDraft row;
  Dice dice(1);
  for (int i = 0; i < 20; ++i) row.add(random_points(dice, 0));
  const auto tables = std::make_shared<SpaceTables>();
  const SpaceComplex x = build_complex(row, tables, dice);
  std::stop_source source;
  source.request_stop();
  Context context({}, source.get_token());
  EXPECT_ANY_THROW(find_contacts(x, x, *tables, context));
}

}  // namespace
}  // namespace plumb::find_contacts_test
