// The audit of a complex against changes of every kind: whatever place, line or mark is changed
// must be found, and what is changed into itself must not.
#include "plumb/plane/plane_audit.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "plumb/plane/nef2.h"
#include "plumb/predicates/error.h"

namespace plumb::plane_audit_test {

Line2 line(int ax, int ay, int bx, int by) {
  return {RationalPoint2{ax, ay}, RationalPoint2{bx, by}};
}
RationalPoint2 point(int x, int y) { return {x, y}; }

/// Two lines that cross, a triangle without a point inside, and a point.
PlaneComplex sound_complex() {
  const std::vector<Point2> triangle{{20, 1}, {27, 3}, {23, 9}};
  const Nef2 set = Nef2::line(line(0, 0, 3, 1)) + Nef2::line(line(0, 3, 2, -1)) +
                   Nef2::polygon(triangle) - Nef2::point(point(23, 4)) + Nef2::point(point(40, 2));
  return set.complex();
}

/// Whatever point a vertex is given but its own, and whatever line an edge.
TEST(PlaneAudit, FindsEveryChangedPlace) {
  const PlaneComplex sound = sound_complex();
  ASSERT_FALSE(audit(sound, AuditForm::Minimal).has_value());
  const auto inputs = static_cast<std::uint32_t>(sound.points.inputs.size());
  for (const AuditForm form : {AuditForm::Minimal, AuditForm::Any}) {
    for (std::size_t v = 0; v < sound.vertex_count(); ++v) {
      PlaneComplex changed = sound;
      for (std::uint32_t& p = changed.vertex_point[v] = 0; p <= sound.points.size(); ++p) {
        const bool is_same = p < sound.points.size() &&
                             compare_xy(sound.points, p, sound.vertex_point[v]) == Sign::Zero;
        EXPECT_EQ(audit(changed, form).has_value(), !is_same) << v << ' ' << p;
      }
    }
    for (std::size_t e = 0; e < sound.edge_count(); ++e) {
      const PlaneLine own = sound.line[e];
      PlaneComplex changed = sound;
      for (std::uint32_t a = 0; a <= inputs; ++a) {
        for (std::uint32_t b = 0; b <= inputs; ++b) {
          changed.line[e] = {a, b};
          const bool is_same = a < inputs && b < inputs &&
                               compare_xy(sound.points.inputs, a, b) == Sign::Negative &&
                               orient2d(sound.points.inputs, own.a, own.b, a) == Sign::Zero &&
                               orient2d(sound.points.inputs, own.a, own.b, b) == Sign::Zero;
          EXPECT_EQ(audit(changed, form).has_value(), !is_same) << e << ' ' << a << ' ' << b;
        }
      }
    }
  }
}

void expect_flaw(const PlaneComplex& complex, const std::string& invariant) {
  for (const AuditForm form : {AuditForm::Minimal, AuditForm::Any}) {
    const auto flaw = audit(complex, form);
    ASSERT_TRUE(flaw.has_value()) << invariant;
    EXPECT_NE(flaw->invariant.find(invariant), std::string::npos) << flaw->invariant;
  }
}

/// The same elements over other points: f of every coordinate.
PlaneComplex moved_inputs(PlaneComplex complex, Point2 (*f)(Point2)) {
  PointTable2 points;
  for (std::uint32_t i = 0; i < complex.points.inputs.size(); ++i) {
    points.push_back(f(complex.points.inputs.approx(i)));
  }
  for (Crossing2& c : complex.points.crossings) c = make_crossing(points, c.a, c.b, c.c, c.d);
  complex.points.inputs = points;
  return complex;
}

TEST(PlaneAudit, NamesTheInvariantBroken) {
  const PlaneComplex sound = sound_complex();
  expect_flaw(PlaneComplex{}, "there is a face");
  PlaneComplex changed = sound;
  changed.marks.vertex.push_back(0);
  expect_flaw(changed, "has a mark");
  changed = sound;
  changed.marks.edge.pop_back();
  expect_flaw(changed, "has a mark");
  changed = sound;
  changed.marks.face.clear();
  expect_flaw(changed, "has a mark");
  changed = sound;
  changed.line.pop_back();
  changed.marks.edge.pop_back();
  expect_flaw(changed, "as many edges as vertices");
  // Mirrored points: the order from left to right stays, that around the crossing does not.
  expect_flaw(moved_inputs(sound,
                           [](Point2 p) {
                             return Point2{p.x, -p.y};
                           }),
              "edges leave a vertex counter-clockwise");
  // Two segments that are moved across each other.
  const std::vector<Point2> low{{0, 0}, {4, 1}}, high{{1, 3}, {3, 4}};
  const Nef2 segments = Nef2::polyline(low) + Nef2::polyline(high);
  const PlaneComplex crossed = moved_inputs(segments.complex(), [](Point2 p) {
    return p == Point2{1, 3} ? Point2{1, -3} : p;
  });
  for (const AuditForm form : {AuditForm::Minimal, AuditForm::Any})
    EXPECT_TRUE(audit(crossed, form).has_value());
  // A triangle that is moved away from what was inside it.
  const std::vector<Point2> around{{-9, -9}, {9, -9}, {0, 9}}, inside{{0, 0}, {1, 1}};
  const Nef2 nested = Nef2::polygon(around, Boundary::Open) - Nef2::polyline(inside);
  const PlaneComplex outside = moved_inputs(nested.complex(), [](Point2 p) {
    return p.x < -5 || p.x > 5 || p.y > 5 ? Point2{p.x, p.y + 20} : p;
  });
  for (const AuditForm form : {AuditForm::Minimal, AuditForm::Any})
    EXPECT_TRUE(audit(outside, form).has_value());
}

/// A vertex inside a straight edge is sound, but not minimal; and minimal means that marks differ.
TEST(PlaneAudit, TellsWhatCouldGo) {
  const std::vector<Point2> triangle{{0, 0}, {4, 1}, {2, 5}};
  for (const Boundary boundary : {Boundary::Open, Boundary::Closed}) {
    PlaneComplex complex = Nef2::polygon(triangle, boundary).complex();
    for (std::uint8_t& mark : complex.marks.face) mark = 1;
    for (std::uint8_t& mark : complex.marks.edge) mark = 1;
    for (std::uint8_t& mark : complex.marks.vertex) mark = 1;
    EXPECT_FALSE(audit(complex, AuditForm::Any).has_value());
    EXPECT_TRUE(audit(complex, AuditForm::Minimal).has_value());
    EXPECT_TRUE(Nef2::from_complex(complex) == Nef2::whole());
  }
}

TEST(PlaneAudit, KeepsToItsLimits) {
  Limits limits;
  limits.max_memory_bytes = 1;
  Context context(limits);
  for (const AuditForm form : {AuditForm::Minimal, AuditForm::Any}) {
    try {
      audit(sound_complex(), form, context);
      ADD_FAILURE();
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ErrorCode::ResourceLimit);
    }
  }
}

}  // namespace plumb::plane_audit_test
