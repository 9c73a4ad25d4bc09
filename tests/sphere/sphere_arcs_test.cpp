// Checks turns, places, crossings and walks along great circles against integer vectors, and the
// parts of random maps against a search over the links of the map.
#include "plumb/sphere/arcs/sphere_arcs.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <set>
#include <vector>

#include "plumb/sphere/nef_sphere.h"
#include "plumb/testing/dice.h"

namespace plumb::sphere_arcs_test {

using testing::Dice;
using Vector = std::array<std::int64_t, 3>;

std::int64_t dot(const Vector& u, const Vector& v) {
  return u[0] * v[0] + u[1] * v[1] + u[2] * v[2];
}
Vector cross(const Vector& u, const Vector& v) {
  return {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
}
Vector signed_by(bool is_opposite, const Vector& v) {
  return is_opposite ? Vector{-v[0], -v[1], -v[2]} : v;
}
Sign sign(std::int64_t x) { return x > 0 ? Sign::Positive : x < 0 ? Sign::Negative : Sign::Zero; }

/// Orders vectors orthogonal to an axis by the angle from a first one, counter-clockwise.
struct Turns {
  Vector axis;
  Vector from;

  std::array<std::int64_t, 2> flat(const Vector& v) const {
    return {dot(v, from), dot(v, cross(axis, from))};
  }
  TurnClass of(const Vector& v) const {
    const auto [a, b] = flat(v);
    if (b != 0) return b > 0 ? TurnClass::Left : TurnClass::Right;
    return a > 0 ? TurnClass::None : TurnClass::Back;
  }
  bool is_before(const Vector& u, const Vector& v) const {
    const auto [a, b] = flat(u);
    const auto [c, d] = flat(v);
    const bool far_u = b < 0 || (b == 0 && a < 0);
    const bool far_v = d < 0 || (d == 0 && c < 0);
    return far_u != far_v ? far_v : a * d - b * c > 0;
  }
  /// Whether v lies strictly between, where a turn to the first one itself is a whole one.
  bool is_between(const Vector& to, const Vector& v) const {
    if (of(v) == TurnClass::None) return false;
    return of(to) == TurnClass::None || is_before(v, to);
  }
};

/// The thirteen circles of normals in {-1, 0, 1}^3, of which up to four pass through a direction.
struct Circles {
  PlaneTable planes;
  std::vector<Vector> normal;

  Circles() {
    for (int code = 14; code < 27; ++code) {  // those after 0 have a positive leading coordinate
      const Vector n{code / 9 - 1, code / 3 % 3 - 1, code % 3 - 1};
      normal.push_back(n);
      planes.intern(static_cast<double>(n[0]), static_cast<double>(n[1]), static_cast<double>(n[2]),
                    0);
    }
  }
  std::uint32_t count() const { return static_cast<std::uint32_t>(normal.size()); }
  Vector at(SphereDirection u) const { return cross(normal[u.p.value()], normal[u.q.value()]); }
  std::vector<CirclePlace> places(std::uint32_t circle) const {
    std::vector<CirclePlace> result;
    for (std::uint32_t m = 0; m < count(); ++m) {
      for (const bool opposite : {false, true}) {
        if (m != circle) result.push_back({PlaneId(m), opposite});
      }
    }
    return result;
  }
  Vector heading(OrientedPlane h, const Vector& u) const {
    return signed_by(h.is_opposite(), cross(normal[h.plane().value()], u));
  }
  std::vector<OrientedPlane> headings(const Vector& u) const {
    std::vector<OrientedPlane> result;
    for (std::uint32_t m = 0; m < count(); ++m) {
      for (const bool opposite : {false, true}) {
        if (dot(normal[m], u) == 0) result.push_back({PlaneId(m), opposite});
      }
    }
    return result;
  }
};

TEST(SphereArcs, DirectionsHaveTheirPlacesOnCircles) {
  const Circles all;
  for (std::uint32_t p = 0; p < all.count(); ++p) {
    for (std::uint32_t q = 0; q < all.count(); ++q) {
      if (p == q) continue;
      const SphereDirection u{PlaneId(p), PlaneId(q)};
      for (std::uint32_t c = 0; c < all.count(); ++c) {
        ASSERT_EQ(side_of(all.planes, u, PlaneId(c)), sign(dot(all.at(u), all.normal[c])));
        if (c != p) {
          const SphereDirection v{PlaneId(c), PlaneId(p)};
          const bool parallel = cross(all.at(u), all.at(v)) == Vector{0, 0, 0};
          const bool same = parallel && dot(all.at(u), all.at(v)) > 0;
          ASSERT_EQ(is_same(all.planes, u, v), same);
          ASSERT_EQ(is_opposite(all.planes, u, v), parallel && !same);
        }
        if (dot(all.at(u), all.normal[c]) != 0) continue;
        const CirclePlace place = place_on(all.planes, PlaneId(c), u);
        const Vector there = all.at(direction_of(PlaneId(c), place));
        ASSERT_EQ(cross(there, all.at(u)), (Vector{0, 0, 0}));
        ASSERT_GT(dot(there, all.at(u)), 0);
      }
    }
  }
}

TEST(SphereArcs, TurnsOnACircleAreThoseOfVectors) {
  const Circles all;
  Dice dice(1);
  for (std::uint32_t c = 0; c < all.count(); ++c) {
    const PlaneId circle(c);
    const std::vector<CirclePlace> places = all.places(c);
    for (const CirclePlace from : places) {
      const Turns turns{all.normal[c], all.at(direction_of(circle, from))};
      for (const CirclePlace x : places) {
        const Vector u = all.at(direction_of(circle, x));
        ASSERT_EQ(turn_on(all.planes, circle, from, x), turns.of(u));
        const CirclePlace y = places[dice.below(places.size())];
        const Vector v = all.at(direction_of(circle, y));
        ASSERT_EQ(is_before_on(all.planes, circle, from, x, y), turns.is_before(u, v));
        ASSERT_EQ(is_between_on(all.planes, circle, from, y, x), turns.is_between(v, u));
      }
    }
  }
}

TEST(SphereArcs, TurnsAtADirectionAreThoseOfVectors) {
  const Circles all;
  for (std::uint32_t p = 0; p < all.count(); ++p) {
    for (std::uint32_t q = 0; q < all.count(); ++q) {
      if (p == q) continue;
      const SphereDirection u{PlaneId(p), PlaneId(q)};
      const Vector axis = all.at(u);
      const std::vector<OrientedPlane> headings = all.headings(axis);
      for (const OrientedPlane from : headings) {
        const Turns turns{axis, all.heading(from, axis)};
        for (const OrientedPlane x : headings) {
          ASSERT_EQ(turn_at(all.planes, u, from, x), turns.of(all.heading(x, axis)));
          for (const OrientedPlane y : headings) {
            ASSERT_EQ(is_before_at(all.planes, u, from, x, y),
                      turns.is_before(all.heading(x, axis), all.heading(y, axis)));
          }
        }
      }
    }
  }
}

/// A map of one arc, without marks; of a whole circle through one point if `is_round`.
SphereMap one_arc(PlaneId circle, CirclePlace from, CirclePlace to, bool is_round) {
  SphereMap map;
  map.circle = {circle};
  map.direction = {direction_of(circle, from), direction_of(circle, to)};
  map.origin = {0, is_round ? 0U : 1U};
  return map;
}

TEST(SphereArcs, ArcsOfAnyLengthHoldThePlacesBetweenTheirEnds) {
  const Circles all;
  for (std::uint32_t c = 0; c < all.count(); c += 2) {
    const PlaneId circle(c);
    const std::vector<CirclePlace> places = all.places(c);
    for (const CirclePlace from : places) {
      const Turns turns{all.normal[c], all.at(direction_of(circle, from))};
      for (const CirclePlace to : places) {
        const Vector end = all.at(direction_of(circle, to));
        const SphereMap map = one_arc(circle, from, to, turns.of(end) == TurnClass::None);
        for (std::uint32_t d = 0; d < all.count(); ++d) {
          if (d == c) continue;
          const Vector ahead = cross(all.normal[c], all.normal[d]);
          const ArcCrossings found = crossings(all.planes, map, 0, PlaneId(d));
          ASSERT_EQ(found.ahead, turns.is_between(end, ahead));
          ASSERT_EQ(found.behind, turns.is_between(end, signed_by(true, ahead)));
          const SphereDirection u{PlaneId(d), circle};
          ASSERT_EQ(is_on_arc(all.planes, map, 0, u), found.behind);
        }
      }
    }
    SphereMap loop;
    loop.circle = {circle};
    loop.origin = {kNone, kNone};
    const ArcCrossings found = crossings(all.planes, loop, 0, PlaneId(c == 0 ? 1 : 0));
    EXPECT_TRUE(found.ahead && found.behind);
  }
}

TEST(SphereArcs, AHeadingLeavesWithinTheSectorOfTheNextHalfArcClockwise) {
  const Circles all;
  Dice dice(2);
  for (int round = 0; round < 300; ++round) {
    const std::uint32_t p = dice.below(all.count());
    const std::uint32_t q = (p + 1 + dice.below(all.count() - 1)) % all.count();
    const SphereDirection u{PlaneId(p), PlaneId(q)};
    const Vector axis = all.at(u);
    std::vector<OrientedPlane> kept;
    for (const OrientedPlane h : all.headings(axis)) {
      if (kept.empty() || dice.below(2) == 0) kept.push_back(h);
    }
    const Turns turns{axis, all.heading(kept[0], axis)};
    std::sort(kept.begin(), kept.end(), [&](OrientedPlane g, OrientedPlane h) {
      return turns.is_before(all.heading(h, axis), all.heading(g, axis));  // clockwise
    });
    SphereMap map;
    map.direction = {u};
    map.next.resize(2 * kept.size());
    std::vector<std::uint32_t> half;
    for (const OrientedPlane h : kept) {
      half.push_back(static_cast<std::uint32_t>(2 * half.size()) + (h.is_opposite() ? 1U : 0U));
      map.circle.push_back(h.plane());
    }
    for (std::size_t i = 0; i < half.size(); ++i) {
      map.next[SphereMap::twin(half[i])] = half[(i + 1) % half.size()];
    }
    map.first_out = {half[dice.below(half.size())]};
    for (const OrientedPlane heading : all.headings(axis)) {
      const Turns to_left{axis, all.heading(heading, axis)};
      std::size_t last = 0;
      bool runs_along = false;
      for (std::size_t i = 0; i < kept.size(); ++i) {
        if (kept[i] == heading) runs_along = true;
        if (to_left.is_before(all.heading(kept[last], axis), all.heading(kept[i], axis))) last = i;
      }
      ASSERT_EQ(sector_at(all.planes, map, 0, heading), runs_along ? kNone : half[last]);
    }
  }
}

/// A set of few coordinates with isolated points, slits, loops and islands.
NefSphere any_set(Dice& dice) {
  const auto any = [&] {
    while (true) {
      const SphereVector v(static_cast<double>(dice.between(-1, 1)),
                           static_cast<double>(dice.between(-2, 2)),
                           static_cast<double>(dice.between(-2, 2)));
      if (!v.is_zero()) return v;
    }
  };
  NefSphere set;
  for (std::uint32_t leaves = dice.below(7); leaves > 0; --leaves) {
    const SphereVector u = any();
    const SphereVector v = any();
    if (dice.below(3) == 0) {
      set ^= NefSphere::point(u);
    } else if (dice.below(3) == 0) {
      set ^= NefSphere::half_sphere(u, Boundary::Open);
    } else if (!cross(u, v).is_zero()) {
      set ^= NefSphere::arc(u, v, dice.below(2) == 0 ? Boundary::Open : Boundary::Closed);
    }
  }
  return set;
}

TEST(SphereArcs, AWalkGoesOnInTheFaceThatItWasLeftIn) {
  Dice dice(3);
  for (int round = 0; round < 60; ++round) {
    const NefSphere set = any_set(dice);
    const SphereMap& map = set.map();
    for (std::uint32_t a = 0; a < map.arc_count(); ++a) {
      const PlaneId c = map.circle[a];
      for (std::uint32_t b = 0; b < map.arc_count(); ++b) {
        if (map.circle[b] == c) continue;
        const CirclePlace start{map.circle[b], false};
        std::vector<PathHit> hits;
        walk_leg(set.planes(), map, c, start, start, hits);
        std::size_t expected = 0;
        for (const SphereDirection u : map.direction) {
          if (side_of(set.planes(), u, c) == Sign::Zero) ++expected;
        }
        for (std::uint32_t e = 0; e < map.arc_count(); ++e) {
          if (map.circle[e] == c) continue;
          const SphereDirection u{c, map.circle[e]};
          if (is_on_arc(set.planes(), map, e, u)) ++expected;
          if (is_on_arc(set.planes(), map, e, u.opposite())) ++expected;
        }
        ASSERT_EQ(hits.size(), expected);
        for (std::size_t i = 0; i < hits.size(); ++i) {
          const PathHit& hit = hits[i];
          const PathHit& later = hits[(i + 1) % hits.size()];
          if (i > 0) {
            ASSERT_TRUE(is_before_on(set.planes(), c, start, hits[i - 1].place, hit.place));
          }
          ASSERT_EQ(hit.exit.is_valid(), later.entry.is_valid());
          if (hit.exit.is_valid()) {
            ASSERT_EQ(face_of(map, hit.exit), face_of(map, later.entry));
          }
        }
      }
    }
  }
}

TEST(SphereArcs, LinksOfPartsJoinTheCyclesOfEachFace) {
  Dice dice(4);
  std::size_t most_parts = 0;
  for (int round = 0; round < 150; ++round) {
    const NefSphere set = any_set(dice);
    const SphereMap& map = set.map();
    SphereParts parts;
    parts.find(set.planes(), map);
    const auto points = static_cast<std::uint32_t>(map.point_count());
    const auto halves = static_cast<std::uint32_t>(map.origin.size());

    std::vector<std::uint32_t> part(points + map.arc_count(), kNone);
    std::uint32_t part_count = 0;
    for (std::uint32_t i = 0; i < part.size(); ++i) {
      if (part[i] != kNone) continue;
      part[i] = part_count++;
      for (bool grows = true; grows;) {
        grows = false;
        for (std::uint32_t h = 0; h < halves; ++h) {
          if (map.origin[h] == kNone) continue;
          std::uint32_t& arc = part[points + h / 2];
          std::uint32_t& point = part[map.origin[h]];
          if (arc == point) continue;
          grows = true;
          arc = point = std::min(arc, point);
        }
      }
    }
    most_parts = std::max<std::size_t>(most_parts, part_count);
    ASSERT_EQ(parts.count(), part_count);
    for (std::uint32_t h = 0; h < halves; ++h) {
      if (map.origin[h] != kNone) {
        ASSERT_EQ(parts.of_arc(h / 2), parts.of_point(map.origin[h]));
      }
    }

    if (map.arc_count() == 0) continue;
    std::vector<std::uint32_t> joined;  // half-arcs, then points
    make_singles(joined, halves + points);
    for (std::uint32_t h = 0; h < halves; ++h) unite(joined, h, map.next[h]);
    const auto number = [&](SphereSlot s) {
      return s.half_arc != kNone ? s.half_arc : halves + s.point;
    };
    for (const SphereParts::Link& link : parts.links()) {
      ASSERT_EQ(face_of(map, link.first), face_of(map, link.second));
      unite(joined, number(link.first), number(link.second));
    }
    std::set<std::uint32_t> roots;
    for (std::uint32_t h = 0; h < halves; ++h) roots.insert(find_root(joined, h));
    for (std::uint32_t v = 0; v < points; ++v) {
      if (map.first_out[v] == kNone) roots.insert(find_root(joined, halves + v));
    }
    ASSERT_EQ(roots.size(), map.face_count());
  }
  EXPECT_GT(most_parts, 3U);
}

}  // namespace plumb::sphere_arcs_test
