// Pairs of shapes against what is argued by hand of each.

#include <gtest/gtest.h>

#include <string>

#include "overlay_pairs.h"

namespace plumb::testing::overlay_cases_test {
namespace {

Pieces pieces_of(const Nef2& set) {
  const PlaneParts parts = set.parts();
  Pieces pieces{parts.polygons.size(), 0, parts.points.size()};
  for (const auto& line : parts.lines) pieces.segments += line.size() - 1;
  return pieces;
}

char dimension(const Nef2& set) {
  if (!set.interior().is_empty()) return '2';
  const PlaneMarks& marks = set.complex().marks;
  for (const auto mark : marks.edge) {
    if (mark != 0) return '1';
  }
  return set.is_empty() ? 'F' : '0';
}

/// Dimensions of what interior, boundary and exterior of one have in common with those of the
/// other, row by row; F where that is nothing. For sets that are the closures of their interiors.
std::string nine_intersections(const Nef2& a, const Nef2& b) {
  std::string matrix;
  for (const Nef2& of_a : {a.interior(), a.boundary(), a.exterior()}) {
    for (const Nef2& of_b : {b.interior(), b.boundary(), b.exterior()}) {
      matrix += dimension(of_a * of_b);
    }
  }
  return matrix;
}

std::string transposed(const std::string& m) {
  return {m[0], m[3], m[6], m[1], m[4], m[7], m[2], m[5], m[8]};
}

TEST(OverlayCases, have_the_areas_and_parts_argued_by_hand) {
  for (const Pair& pair : kPairs) {
    SCOPED_TRACE(pair.name);
    const Nef2 a = set_of_wkt(pair.a);
    const Nef2 b = set_of_wkt(pair.b);
    const Rational area_a(pair.area_a);
    const Rational area_b(pair.area_b);
    const Rational both(pair.area_both);
    EXPECT_EQ(a.area(), area_a);
    EXPECT_EQ(b.area(), area_b);
    EXPECT_EQ((a * b).area(), both);
    EXPECT_EQ((a + b).area(), area_a + area_b - both);
    EXPECT_EQ((a - b).area(), area_a - both);
    EXPECT_EQ((b - a).area(), area_b - both);
    EXPECT_EQ((a ^ b).area(), area_a + area_b - 2 * both);
    EXPECT_EQ(pieces_of(a * b), pair.both);
    EXPECT_EQ(pieces_of(a + b), pair.either);
    for (const Nef2& set : {a * b, a + b, a - b, a ^ b}) EXPECT_FALSE(set.audit());
  }
}

TEST(OverlayCases, have_the_nine_intersections_argued_by_hand) {
  for (const Pair& pair : kPairs) {
    if (pair.matrix == nullptr) continue;
    SCOPED_TRACE(pair.name);
    const Nef2 a = set_of_wkt(pair.a);
    const Nef2 b = set_of_wkt(pair.b);
    EXPECT_EQ(nine_intersections(a, b), pair.matrix);
    EXPECT_EQ(nine_intersections(b, a), transposed(pair.matrix));
  }
}

}  // namespace
}  // namespace plumb::testing::overlay_cases_test
