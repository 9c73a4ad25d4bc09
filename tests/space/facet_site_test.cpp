// Facets of many corners: which cycles and vertices lie in which facet, and Booleans of such
// facets.
#include "plumb/space/planar/facet_site.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <stop_token>
#include <string>
#include <vector>

#include "generate/mesh_solid.h"
#include "generate/meshes.h"
#include "generate/voxel_mesh.h"
#include "plumb/predicates/error.h"
#include "plumb/space/nef3.h"
#include "plumb/space/space_audit.h"
#include "plumb/space/space_measure.h"
#include "plumb/testing/dice.h"

namespace plumb::testing::facet_site_test {
namespace {

Nef3 box(Point3 low, Point3 high) { return solid(box_mesh(low, high)); }

/// All coordinates become fractions, and planes turn: vertices are common points of three planes.
Nef3 skewed(const Nef3& set) {
  const auto third = [](int n) { return Rational(n) / 3; };
  return set.transformed({{{{third(2), third(1), third(-1)},
                            {third(-1), third(4), third(1)},
                            {third(1), third(-2), third(5)}}},
                          {third(1), third(2), third(7)}});
}

Rational volume(const Nef3& set) { return marked_volume(set.complex()).value(); }

struct Named {
  std::string name;
  Nef3 set;
};

/// A square of size 9 with single points, slits and a square taken out, of which another one is put
/// back.
Nef3 pierced_square() {
  Context context;
  const auto square = [](double low, double high) {
    return Nef3::facet(
        std::array<Point3, 4>{{{low, low, 0}, {high, low, 0}, {high, high, 0}, {low, high, 0}}});
  };
  Nef3 set = square(0, 9) - square(3, 6).interior() - square(3, 6) + square(4, 5);
  for (int i = 1; i < 9; ++i) {
    const Rational x = i, y = Rational(2 * i + 1) / 17;
    set -= Nef3::point({x, y, 0});
    set -= Nef3::segment({x, Rational(15) / 2, 0}, {x + Rational(1) / 2, Rational(17) / 2, 0});
    set += Nef3::segment({x, Rational(7), 0}, {x, Rational(7), 1});
  }
  return set;
}

std::vector<Named> sets() {
  Context context;
  Dice dice(5);
  std::vector<Named> found;
  for (int i = 0; i < 3; ++i) {
    found.push_back({"voxels " + std::to_string(i),
                     solid(voxel_mesh(random_voxels(dice, {9, 7, 2}, 4 + 2 * i)))});
  }
  found.push_back({"plate", solid(voxel_mesh(pierced_plate(4)))});
  found.push_back({"star", solid(star_prism(20))});
  found.push_back({"comb", solid(comb_block(12, 1))});
  found.push_back({"pierced square", pierced_square()});
  const Nef3 plane = Nef3::plane({0, 0, 1, -1});
  found.push_back({"pierced plane", plane - found[0].set - solid(star_prism(7))});
  const std::size_t plain = found.size();
  for (std::size_t i = 0; i < plain; ++i) {
    found.push_back({"skewed " + found[i].name, skewed(found[i].set)});
  }
  return found;
}

void expect_sound(const Nef3& set, const std::string& name) {
  const auto flaw = audit(set.complex(), AuditForm::Minimal);
  EXPECT_FALSE(flaw) << name << ": " << flaw->invariant << " at " << flaw->place;
}

// ---------------------------------------------------------------- cycles in facets

/// The facets know what belongs together, and the audit looks into each.
TEST(LargeFacets, CyclesAreNestedAsFacetsSay) {
  Dice dice(8);
  Context context;
  std::size_t holes = 0, inner = 0;
  for (const auto& [name, set] : sets()) {
    expect_sound(set, name);
    const SpaceComplex& c = set.complex();
    for (std::uint32_t p = 0; p < c.planes().size(); ++p) {
      std::vector<UseId> cycles;
      std::vector<VertexId> points;
      for (std::uint32_t f = 0; f < c.facet_count(); ++f) {
        if (c.facet_plane[f] != PlaneId(p)) continue;
        cycles.insert(cycles.end(), c.cycles_of(FacetId(f)).begin(), c.cycles_of(FacetId(f)).end());
        points.insert(points.end(), c.inner_of(FacetId(f)).begin(), c.inner_of(FacetId(f)).end());
      }
      for (std::size_t i = cycles.size(); i > 1; --i)
        std::swap(cycles[i - 1], cycles[dice.below(i)]);
      const CycleNesting nesting = nest_cycles(c, PlaneId(p), cycles, points, context);
      for (std::size_t i = 0; i < cycles.size(); ++i) {
        const FacetId f = c.use_facet[cycles[i].value()];
        EXPECT_EQ(cycles[nesting.of_cycle[i]], c.cycles_of(f)[0]) << name;
        holes += nesting.of_cycle[i] != i ? 1 : 0;
      }
      for (std::size_t i = 0; i < points.size(); ++i) {
        const FacetId f = c.vertex_facet[points[i].value()];
        EXPECT_EQ(cycles[nesting.of_point[i]], c.cycles_of(f)[0]) << name;
        ++inner;
      }
    }
  }
  EXPECT_GT(holes, 80U);
  EXPECT_GT(inner, 20U);
}

// ---------------------------------------------------------------- Booleans

/// Columns two apart, `size` by `size` of them.
Nef3 columns(int size, double low, double high) {
  PolygonMesh mesh;
  for (int i = 0; i < size * size; ++i) {
    const double x = 2 * (i % size) + 1, y = 2 * (i / size) + 1;
    mesh = joined(std::move(mesh), box_mesh({x, y, low}, {x + 1, y + 1, high}));
  }
  return solid(mesh);
}

/// A square with 196 square holes, the first such facet of a plate.
struct PiercedFacet {
  Nef3 set = box({0, 0, 0}, {30, 30, 2}) - columns(14, 1, 3);
  FacetId facet = [this] {
    const SpaceComplex& c = set.complex();
    std::uint32_t f = 0;
    while (f < c.facet_count() && c.cycles_of(FacetId(f)).size() <= 100) ++f;
    return FacetId(f);
  }();
};

Context stopped() {
  std::stop_source source;
  source.request_stop();
  return Context({}, source.get_token());
}

TEST(LargeFacets, NestingKeepsToLimits) {
  const PiercedFacet pierced;
  const SpaceComplex& c = pierced.set.complex();
  const FacetId f = pierced.facet;
  ASSERT_LT(f.value(), c.facet_count());
  const auto nest = [&](Context context) {
    return nest_cycles(c, c.facet_plane[f.value()], c.cycles_of(f), {}, context).of_cycle;
  };
  EXPECT_EQ(nest(Context()), std::vector<std::uint32_t>(197, 0));
  Limits limits;
  limits.max_memory_bytes = 100'000;  // of 788 corners
  EXPECT_THROW(nest(Context(limits)), Error);
  EXPECT_THROW(nest(stopped()), Error);
}

/// Boxes in holes, parts of facets in holes of others, all in two planes.
TEST(LargeFacets, ColumnsThroughASlab) {
  constexpr int kSize = 7;
  constexpr unsigned kColumns = kSize * kSize;
  const Nef3 slab = box({0, 0, 0}, {2 * kSize + 1, 2 * kSize + 1, 1}), all = columns(kSize, -1, 2);
  const Nef3 plate = slab - all;
  expect_sound(plate, "plate");
  EXPECT_TRUE(plate.closure() == solid(voxel_mesh(pierced_plate(kSize))));
  EXPECT_EQ(plate.counts().facets, 6 + 4 * kColumns);
  EXPECT_EQ(plate.counts().volumes, 2U);
  const Nef3 parity = slab ^ all;
  expect_sound(parity, "parity");
  EXPECT_TRUE(parity == (slab + all) - slab * all);
  EXPECT_EQ(parity.counts().marked_volumes, 2 * kColumns + 1);
  EXPECT_EQ(parity.counts().volumes, 3 * kColumns + 2);
  EXPECT_EQ(volume(plate), volume(slab) - volume(slab * all));
  EXPECT_TRUE(skewed(parity) == (skewed(slab) ^ skewed(all)));
}

/// Large facets of both in one plane, and edges through large facets.
TEST(LargeFacets, StarsOverStars) {
  const Nef3 star = solid(star_prism(40));
  const Nef3 moved_star = solid(moved(star_prism(40), {0.25, 0.125, 0.5}));
  const Nef3 flush_star = solid(moved(star_prism(40), {0.25, 0.125, 0}));
  for (const Nef3& other : {moved_star, flush_star, star}) {
    const Nef3 both = star + other, common = star * other;
    expect_sound(both, "union");
    expect_sound(common, "intersection");
    EXPECT_EQ(volume(both) + volume(common), volume(star) + volume(other));
    EXPECT_TRUE((star ^ other) == both - common);
  }
}

}  // namespace
}  // namespace plumb::testing::facet_site_test
