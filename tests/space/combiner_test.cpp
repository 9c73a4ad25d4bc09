// The combiner of two operands: its result at sample points against the function of their marks, in
// one part or several; and origins of facets that lie on each other.
#include "plumb/space/boolean/combiner.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "generate/space_scenes.h"
#include "plumb/predicates/point3_signs.h"
#include "plumb/space/nef3.h"
#include "plumb/space/space_audit.h"
#include "plumb/space/space_locator.h"

namespace plumb::combiner_test {
namespace {

using testing::Dice;
using testing::SpaceScene;

const CommonOrigin kLesser = [](std::uint32_t a, std::uint32_t b) { return std::min(a, b); };

SpaceComplex marked_box(const RationalPoint3& low, const RationalPoint3& high) {
  SpaceScene scene;
  testing::add_box(scene, low, high);
  SpaceComplex c = testing::complex_of(scene);
  for (auto* marks :
       std::initializer_list<std::vector<Mark>*>{&c.vertex_mark, &c.edge_mark, &c.facet_mark})
    marks->assign(marks->size(), 1);
  c.volume_mark = {0, 1};
  return c;
}

/// A box and things hanging in space, closed, open, or a mixture, in minimal form.
SpaceComplex random_operand(Dice& dice) {
  const auto number = [&dice](int low, int high) { return Rational(dice.between(low, high)); };
  const RationalPoint3 low{number(0, 2), number(0, 2), number(0, 2)};
  SpaceScene scene;
  testing::add_box(scene, low, {low.x + number(1, 3), low.y + number(1, 3), low.z + number(1, 3)});
  if (dice.below(2) == 0) {
    testing::add_tetrahedron(scene, {{{-1, 0, 0}, {-4, 1, 0}, {-3, 3, 1}, {-3, 0, number(1, 3)}}});
  }
  scene.add_free_edge({number(0, 6), -2, 0}, {number(0, 6), -3, 3});
  scene.add_point({number(0, 6), -5, 1});
  SpaceComplex c = testing::complex_of(scene);
  for (auto* marks :
       std::initializer_list<std::vector<Mark>*>{&c.vertex_mark, &c.edge_mark, &c.facet_mark}) {
    for (Mark& m : *marks) m = static_cast<Mark>(dice.below(4) == 0 ? 0 : 1);
  }
  for (std::size_t v = 1; v < c.volume_count(); ++v) c.volume_mark[v] = dice.below(3) == 0 ? 0 : 1;
  return Nef3::from_complex(std::move(c)).complex();
}

/// Two operands, met and labelled.
struct Operands {
  Operands(SpaceComplex first, SpaceComplex second)
      : a(std::move(first)),
        b(std::move(second)),
        tables(unite_tables(a, b)),
        contacts(find_contacts(a, b, *tables, context)),
        touched{TouchedComplex(a, contacts, 0), TouchedComplex(b, contacts, 1)},
        labels{label_vertices(touched[0], b, contacts, 0, *tables, context),
               label_vertices(touched[1], a, contacts, 1, *tables, context)} {}

  Combiner combiner(const MarkTable& f, const CommonOrigin& origin) const {
    return {{&a, &b}, tables, contacts, f, origin};
  }
  SpaceComplex assembled(CombinedDraft draft) {
    SpaceComplex result = assemble(std::move(draft.vertices), context);
    if (result.vertex_count() == 0) result.volume_mark[0] = draft.outside;
    return result;
  }
  SpaceComplex whole(const MarkTable& f, const CommonOrigin& origin = kLesser) {
    Combiner one = combiner(f, origin);
    one.overlay_contacts(context);
    for (const std::size_t i : {0U, 1U}) one.keep_vertices(i, touched[i], labels[i], context);
    return assembled(one.finish());
  }

  Context context;
  SpaceComplex a;
  SpaceComplex b;
  std::shared_ptr<SpaceTables> tables;
  std::vector<Contact> contacts;
  std::array<TouchedComplex, 2> touched;
  std::array<std::vector<VolumeId>, 2> labels;
};

class Marks {
 public:
  explicit Marks(const SpaceComplex& complex) : complex_(complex), locator_(complex) {}
  Mark at(const RationalPoint3& p) const {
    const SpaceItem item = locator_.locate(p);
    switch (item.kind()) {
      case SpaceItem::Kind::Vertex:
        return complex_.vertex_mark[item.index()];
      case SpaceItem::Kind::Edge:
        return complex_.edge_mark[item.index()];
      case SpaceItem::Kind::Facet:
        return complex_.facet_mark[item.index()];
      case SpaceItem::Kind::Volume:
        break;
    }
    return complex_.volume_mark[item.index()];
  }

 private:
  const SpaceComplex& complex_;
  SpaceLocator locator_;
};

/// Vertices of both, contacts, and points halfway between some of them.
std::vector<RationalPoint3> sample_points(const Operands& o, Dice& dice) {
  std::vector<RationalPoint3> points;
  for (const SpaceComplex* c : {&o.a, &o.b}) {
    for (const SpacePoint p : c->vertex_point) points.push_back(exact(c->points(), p));
  }
  for (const Contact& c : o.contacts) points.push_back(exact(o.tables->points, c.point));
  const std::size_t corners = points.size();
  for (int i = 0; i < 150; ++i) {
    const RationalPoint3 &p = points[dice.below(corners)], &q = points[dice.below(corners)];
    points.push_back(testing::operator*(Rational(1, 2), testing::operator+(p, q)));
  }
  return points;
}

TEST(Combiner, MarksAreThoseOfTheFunction) {
  std::array<int, 2> seen{};
  for (std::uint64_t seed = 0; seed < 16; ++seed) {
    SCOPED_TRACE(seed);
    Dice dice(seed);
    const SpaceComplex first = random_operand(dice);
    Operands o(first, random_operand(dice));
    const auto bit = [&](unsigned i) { return ((seed >> i) & 1U) != 0; };
    const MarkFunction f{bit(0), bit(1), bit(2), bit(3)};
    const SpaceComplex result = o.whole(MarkTable(f));
    const auto flaw = audit(result, AuditForm::Minimal);
    ASSERT_FALSE(flaw) << flaw->invariant << " at " << flaw->place;
    const Marks a(o.a), b(o.b), marks(result);
    for (const RationalPoint3& p : sample_points(o, dice)) {
      EXPECT_EQ(marks.at(p) == 1, f(a.at(p) == 1, b.at(p) == 1));
      ++seen[marks.at(p)];
    }
  }
  EXPECT_GT(seen[0], 200);
  EXPECT_GT(seen[1], 200);
}

TEST(Combiner, OperandsThatAreEqual) {
  Dice dice(20);
  const SpaceComplex c = random_operand(dice);
  Operands o(c, c);
  EXPECT_TRUE(Nef3::from_complex(o.whole(MarkTable(kUnion))) == Nef3::from_complex(c));
  const SpaceComplex nothing = o.whole(MarkTable(kDifference));
  EXPECT_EQ(nothing.vertex_count(), 0U);
  EXPECT_EQ(nothing.volume_mark, std::vector<Mark>{0});
  const SpaceComplex everything = o.whole(MarkTable(MarkFunction{true, false, false, true}));
  EXPECT_EQ(everything.vertex_count(), 0U);
  EXPECT_EQ(everything.volume_mark, std::vector<Mark>{1}) << "the mark of what is outside of both";
}

TEST(Combiner, PartsMakeTheWhole) {
  for (std::uint64_t seed = 30; seed < 36; ++seed) {
    SCOPED_TRACE(seed);
    Dice dice(seed);
    const SpaceComplex first = random_operand(dice);
    Operands o(first, random_operand(dice));
    const MarkTable f(kSymmetricDifference);
    std::vector<std::size_t> begin{0};
    while (begin.back() < o.contacts.size()) {
      begin.push_back(std::min(o.contacts.size(), begin.back() + 1 + dice.below(4)));
    }
    std::vector<std::optional<Combiner>> parts(begin.size() - 1 + 2);
    for (std::optional<Combiner>& part : parts) {
      part.emplace(std::array<const SpaceComplex*, 2>{&o.a, &o.b}, o.tables, o.contacts, f,
                   kLesser);
    }
    for (std::size_t k = 0; k + 1 < begin.size(); ++k) {
      parts[k]->overlay_contacts(begin[k], begin[k + 1], o.context);
    }
    for (const std::size_t i : {1U, 0U}) {
      parts[parts.size() - 1 - i]->keep_vertices(i, o.touched[i], o.labels[i], o.context);
    }
    Combiner all = o.combiner(f, kLesser);
    Context context({}, {}, {}, 1 + static_cast<unsigned>(seed % 3));
    all.append(parts, context);
    const SpaceComplex joined = o.assembled(all.finish());
    EXPECT_FALSE(audit(joined, AuditForm::Minimal));
    EXPECT_TRUE(Nef3::from_complex(joined) == Nef3::from_complex(o.whole(f)));
  }
}

/// Of two boxes side by side the facets in common planes have both origins, others their own.
TEST(Combiner, FacetsOfBothAskForTheirOrigin) {
  SpaceComplex a = marked_box({0, 0, 0}, {2, 2, 2}), b = marked_box({1, 0, 0}, {3, 2, 3});
  for (std::uint32_t i = 0; i < 6; ++i) {
    a.facet_origin[i] = 10 + i;
    b.facet_origin[i] = 20 + i;
  }
  Operands o(std::move(a), std::move(b));
  const CommonOrigin both = [](std::uint32_t of_a, std::uint32_t of_b) {
    EXPECT_TRUE(of_a / 10 == 1 && of_b / 10 == 2);
    return 1000 + 100 * (of_a - 10) + of_b;
  };
  const SpaceComplex c = o.whole(MarkTable(kIntersection), both);
  ASSERT_EQ(c.facet_count(), 6U);
  const SpaceLocator of_a(o.a), of_b(o.b);
  for (std::uint32_t f = 0; f < 6; ++f) {
    // The middle of the rectangle, halfway between opposite corners.
    const UseId u = c.cycles_of(FacetId(f))[0];
    const UseId w = c.use_next[c.use_next[u.value()].value()];
    const RationalPoint3 p = exact(c.points(), c.vertex_point[c.use_origin(u).value()]);
    const RationalPoint3 q = exact(c.points(), c.vertex_point[c.use_origin(w).value()]);
    const RationalPoint3 middle = testing::operator*(Rational(1, 2), testing::operator+(p, q));
    const SpaceItem in_a = of_a.on_item(middle), in_b = of_b.on_item(middle);
    ASSERT_TRUE(in_a.is_valid() || in_b.is_valid());
    const std::uint32_t x = in_a.is_valid() ? o.a.facet_origin[in_a.index()] : 0;
    const std::uint32_t y = in_b.is_valid() ? o.b.facet_origin[in_b.index()] : 0;
    EXPECT_EQ(c.facet_origin[f], x != 0 && y != 0 ? 1000 + 100 * (x - 10) + y : x + y);
  }
}

}  // namespace
}  // namespace plumb::combiner_test
