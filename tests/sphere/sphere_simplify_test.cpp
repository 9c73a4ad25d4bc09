// Checks the minimal form of sphere maps: cells that are mere parts of others go one by one, and
// a set refined by another one is the minimal map of the set again.
#include "plumb/sphere/overlay/sphere_simplify.h"

#include <gtest/gtest.h>

#include <vector>

#include "plumb/sphere/nef_sphere.h"
#include "plumb/sphere/overlay/sphere_labels.h"
#include "plumb/sphere/sphere_audit.h"
#include "plumb/testing/dice.h"

namespace plumb::sphere_simplify_test {

using testing::Dice;

/// A circle in four arcs of the planes x = 0 and y = 0 and z = 0, around z; every mark is 1 but
/// that of the face below.
struct Equator {
  PlaneTable planes;
  SphereMap map;

  Equator() {
    const PlaneId x = planes.intern(1.0, 0.0, 0.0, 0.0).plane();
    const PlaneId y = planes.intern(0.0, 1.0, 0.0, 0.0).plane();
    const PlaneId z = planes.intern(0.0, 0.0, 1.0, 0.0).plane();
    map.direction = {{y, z}, {z, x}, {z, y}, {x, z}};  // x, y, -x, -y
    map.point_mark.assign(4, 1);
    map.point_face.assign(4, kNone);
    map.arc_mark.assign(4, 1);
    map.face_mark = {1, 0};
    for (std::uint32_t i = 0; i < 4; ++i) {
      map.circle.push_back(z);
      map.first_out.push_back(2 * i);
      map.origin.insert(map.origin.end(), {i, (i + 1) % 4});
      map.next.insert(map.next.end(), {2 * ((i + 1) % 4), 2 * ((i + 3) % 4) + 1});
      map.face.insert(map.face.end(), {0, 1});
    }
  }
  /// Simplifies and returns the numbers of points, arcs and faces.
  std::vector<std::size_t> simplified(SphereMap& out) const {
    EXPECT_FALSE(audit(planes, map, AuditForm::Any).has_value());
    SphereSimplifier simplifier;
    if (!simplifier.run(map, out)) out = map;
    EXPECT_EQ(audit(planes, out, AuditForm::Minimal).value_or(DcelFlaw{}).invariant, "");
    return {out.point_count(), out.arc_count(), out.face_count()};
  }
};

using Counts = std::vector<std::size_t>;

TEST(SphereSimplify, MerePointsGoAndAClosedChainBecomesALoop) {
  SphereMap out;
  Equator equator;
  EXPECT_EQ(equator.simplified(out), (Counts{0, 1, 2}));
  EXPECT_TRUE(out.is_loop(0));
  EXPECT_EQ(out.face_mark, (std::vector<Mark>{1, 0}));
  equator.map.point_mark[2] = 0;
  EXPECT_EQ(equator.simplified(out), (Counts{1, 1, 2}));
  EXPECT_EQ(out.direction[0], equator.map.direction[2]);
  EXPECT_EQ(out.origin, (std::vector<std::uint32_t>{0, 0}));
  equator.map.arc_mark[0] = 0;  // its two ends stay, as they lie between arcs of unequal marks
  EXPECT_EQ(equator.simplified(out), (Counts{3, 3, 2}));
  equator.map.point_mark.assign(4, 0);
  EXPECT_EQ(equator.simplified(out), (Counts{4, 4, 2}));
  EXPECT_FALSE(SphereSimplifier().run(equator.map, out));
}

TEST(SphereSimplify, ArcsGoOnlyIfBothFacesHaveTheirMark) {
  SphereMap out;
  Equator equator;
  equator.map.face_mark = {1, 1};
  EXPECT_EQ(equator.simplified(out), (Counts{0, 0, 1}));
  equator.map.arc_mark[1] = 0;  // a slit, whose ends have the mark of the face
  EXPECT_EQ(equator.simplified(out), (Counts{2, 1, 1}));
  EXPECT_EQ(out.arc_mark, (std::vector<Mark>{0}));
  EXPECT_EQ(out.next, (std::vector<std::uint32_t>{1, 0}));
  equator.map.arc_mark[1] = 1;
  equator.map.point_mark[3] = 0;  // an isolated point
  EXPECT_EQ(equator.simplified(out), (Counts{1, 0, 1}));
  EXPECT_EQ(out.point_face, (std::vector<std::uint32_t>{0}));
  equator.map.face_mark = {0, 1};
  equator.map.point_mark.assign(4, 0);
  equator.map.arc_mark.assign(4, 0);
  EXPECT_EQ(equator.simplified(out), (Counts{0, 1, 2}));
}

NefSphere any_set(Dice& dice) {
  const auto any = [&] {
    while (true) {
      const SphereVector v(static_cast<double>(dice.between(-1, 1)),
                           static_cast<double>(dice.between(-2, 2)),
                           static_cast<double>(dice.between(-1, 1)));
      if (!v.is_zero()) return v;
    }
  };
  NefSphere set;
  for (std::uint32_t leaves = dice.below(6); leaves > 0; --leaves) {
    const SphereVector u = any();
    const SphereVector v = any();
    const std::uint32_t kind = dice.below(4);
    if (kind == 0) set ^= NefSphere::half_sphere(u, Boundary::Closed);
    if (kind == 1) set ^= NefSphere::point(u);
    if (kind > 1 && !cross(u, v).is_zero()) set ^= NefSphere::arc(u, v);
  }
  return set;
}

TEST(SphereSimplify, ASetCutByAnotherIsItsMinimalMapAgain) {
  Dice dice(1);
  std::size_t cut = 0;
  for (int round = 0; round < 150; ++round) {
    SCOPED_TRACE(round);
    const NefSphere a = any_set(dice);
    const NefSphere other = any_set(dice);
    PlaneTable planes(a.planes());
    SphereMap b = other.map();
    const std::vector<PlaneId> to = planes.merge(other.planes());
    for (PlaneId& c : b.circle) c = to[c.value()];
    for (SphereDirection& u : b.direction) u = {to[u.p.value()], to[u.q.value()]};
    SphereContacts contacts;
    SpherePieces pieces;
    SphereOrigins cells;
    contacts.find(planes, a.map(), b);
    pieces.build(planes, a.map(), b, contacts);
    SphereLabels().build(planes, a.map(), b, contacts, pieces, cells);
    SphereMap& in = pieces.map;
    const auto mark = [&](const SphereOrigins::Pair& pair) {
      const SphereCell cell = pair[0];
      const SphereMap& map = a.map();
      return cell.kind() == SphereCell::Kind::Point ? map.point_mark[cell.index()]
             : cell.kind() == SphereCell::Kind::Arc ? map.arc_mark[cell.index()]
                                                    : map.face_mark[cell.index()];
    };
    for (const auto& pair : cells.point) in.point_mark.push_back(mark(pair));
    for (const auto& pair : cells.arc) in.arc_mark.push_back(mark(pair));
    for (const auto& pair : cells.face) in.face_mark.push_back(mark(pair));
    in.centre_mark = 1;

    SphereSimplifier simplifier;
    SphereMap out;
    const bool is_minimal =
        in.point_count() == a.map().point_count() && in.arc_count() == a.map().arc_count();
    ASSERT_EQ(simplifier.run(in, out), !is_minimal);
    if (is_minimal) continue;
    ++cut;
    ASSERT_EQ(audit(planes, out, AuditForm::Minimal).value_or(DcelFlaw{}).invariant, "");
    ASSERT_EQ(out.point_count(), a.map().point_count());
    ASSERT_EQ(out.arc_count(), a.map().arc_count());
    ASSERT_EQ(out.face_count(), a.map().face_count());
    EXPECT_EQ(out.centre_mark, 1);
    for (std::uint32_t v = 0; v < out.point_count(); ++v) {
      const SphereCell at = locate(planes, a.map(), out.direction[v]);
      ASSERT_EQ(at.kind(), SphereCell::Kind::Point);
      EXPECT_EQ(out.point_mark[v], a.map().point_mark[at.index()]);
      EXPECT_EQ(out.direction[v], in.direction[simplifier.old_point()[v]]);
    }
    for (std::uint32_t i = 0; i < out.arc_count(); ++i) {
      const std::uint32_t old = simplifier.old_arc()[i];
      EXPECT_EQ(out.circle[i], in.circle[old]);
      EXPECT_EQ(out.arc_mark[i], in.arc_mark[old]);
      for (const std::uint32_t side : {0U, 1U}) {  // the old faces became the new ones
        const std::uint32_t face = simplifier.old_face()[out.face[2 * i + side]];
        EXPECT_EQ(cells.face[face][0], cells.face[in.face[2 * old + side]][0]);
      }
    }
    for (std::uint32_t f = 0; f < out.face_count(); ++f) {
      EXPECT_EQ(out.face_mark[f], in.face_mark[simplifier.old_face()[f]]);
    }
  }
  EXPECT_GT(cut, 50U);
}

}  // namespace plumb::sphere_simplify_test
