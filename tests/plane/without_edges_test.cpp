// Complexes of which edges were left out, beside arrangements of the edges that are left.
#include <gtest/gtest.h>

#include <cstdint>
#include <random>
#include <span>
#include <vector>

#include "generate/test_share.h"
#include "plumb/plane/arrangement.h"
#include "plumb/plane/complex/plane_draft.h"
#include "plumb/plane/layer/labelled_layer.h"
#include "plumb/plane/plane_audit.h"

namespace plumb::testing::without_edges_test {
namespace {

using Random = std::mt19937_64;

PlaneComplex random_complex(Random& random) {
  PlanePoints points;
  std::vector<SweepCurve> curves;
  const auto coordinate = [&] { return static_cast<double>(random() % 7); };
  const std::size_t count = 1 + random() % 12;
  for (std::uint32_t i = 0; i < count; ++i) {
    const double x = coordinate(), y = coordinate();
    points.inputs.push_back({x, y});
    const double u = coordinate(), v = coordinate();
    points.inputs.push_back({u, v});
    curves.push_back({2 * i, 2 * i + 1, 2 * i, 2 * i + 1});
  }
  return arrange(points, curves, {}).complex;
}

std::vector<std::uint8_t> random_choice(std::size_t count, Random& random) {
  std::vector<std::uint8_t> choice;
  for (std::size_t i = 0; i < count; ++i) choice.push_back(random() % 3 != 0 ? 1 : 0);
  return choice;
}

/// Returns the arrangement of the kept edges, each a curve of its own.
PlaneComplex arranged(const PlaneComplex& complex, const std::vector<std::uint8_t>& is_kept) {
  std::vector<SweepCurve> curves;
  for (std::size_t e = 0; e < is_kept.size(); ++e) {
    if (is_kept[e] == 0) continue;
    const HalfedgeId h = first_half(EdgeId(e));
    curves.push_back({complex.vertex_point[complex.dcel.origin(h)],
                      complex.vertex_point[complex.dcel.target(h)], complex.line[e].a,
                      complex.line[e].b});
  }
  return arrange(complex.points, curves, {}).complex;
}

void expect_same(const PlaneComplex& a, const PlaneComplex& b) {
  ASSERT_EQ(a.vertex_count(), b.vertex_count());
  ASSERT_EQ(a.edge_count(), b.edge_count());
  ASSERT_EQ(a.face_count(), b.face_count());
  for (std::size_t h = 0; h < a.dcel.halfedge_count(); ++h) {
    const HalfedgeId id(h);
    ASSERT_EQ(a.dcel.next(id), b.dcel.next(id));
    ASSERT_EQ(a.dcel.face(id), b.dcel.face(id));
    ASSERT_EQ(a.dcel.origin(id), b.dcel.origin(id));
  }
  for (std::size_t v = 0; v < a.vertex_count(); ++v) {
    ASSERT_TRUE(exact(a.points, a.vertex_point[v]) == exact(b.points, b.vertex_point[v]));
  }
}

/// Returns for each vertex whether it lies between two edges on one line.
std::vector<std::uint8_t> straight_vertices(const PlaneComplex& complex) {
  std::vector<std::uint8_t> is_straight;
  for (std::size_t v = 0; v < complex.vertex_count(); ++v) {
    std::vector<PlaneLine> lines;
    for (const HalfedgeId h : complex.dcel.around(VertexId(v))) {
      lines.push_back(complex.line[edge_of(h)]);
    }
    const bool is_between =
        lines.size() == 2 && cross_sign(complex.points.inputs, lines[0].a, lines[0].b, lines[1].a,
                                        lines[1].b) == Sign::Zero;
    is_straight.push_back(is_between ? 1 : 0);
  }
  return is_straight;
}

TEST(WithoutEdges, IsTheArrangementOfTheOthers) {
  Random random(1);
  for (std::uint64_t round = 0; round < share_of(400) && !HasFailure(); ++round) {
    SCOPED_TRACE(round);
    const PlaneComplex complex = random_complex(random);
    const std::vector<std::uint8_t> is_kept = random_choice(complex.edge_count(), random);
    const std::vector<std::uint8_t> corners(complex.vertex_count(), 1);
    const ReducedComplex reduced = without_edges(complex, is_kept, corners);
    expect_same(reduced.complex, arranged(complex, is_kept));
  }
}

TEST(WithoutEdges, JoinsEdgesAtVerticesThatAreNoCorners) {
  Random random(2);
  for (std::uint64_t round = 0; round < share_of(400) && !HasFailure(); ++round) {
    SCOPED_TRACE(round);
    const PlaneComplex complex = random_complex(random);
    const std::vector<std::uint8_t> is_kept = random_choice(complex.edge_count(), random);
    const PlaneComplex whole = arranged(complex, is_kept);
    const std::vector<std::uint8_t> is_straight = straight_vertices(whole);
    const std::vector<std::uint8_t> corners(complex.vertex_count(), 0);
    const PlaneComplex joined = without_edges(complex, is_kept, corners).complex;
    EXPECT_FALSE(audit(joined, AuditForm::Any));
    ASSERT_EQ(joined.face_count(), whole.face_count());
    std::size_t v = 0;
    for (std::size_t i = 0; i < whole.vertex_count(); ++i) {
      if (is_straight[i] != 0) continue;
      ASSERT_LT(v, joined.vertex_count());
      EXPECT_TRUE(exact(joined.points, joined.vertex_point[v]) ==
                  exact(whole.points, whole.vertex_point[i]));
      ++v;
    }
    EXPECT_EQ(v, joined.vertex_count());
    EXPECT_EQ(joined.edge_count() + whole.vertex_count(), whole.edge_count() + v);
  }
}

struct Ends {
  RationalPoint2 from, to;
};

Ends ends(const PlaneComplex& complex, HalfedgeId h) {
  return {exact(complex.points, complex.vertex_point[complex.dcel.origin(h)]),
          exact(complex.points, complex.vertex_point[complex.dcel.target(h)])};
}

/// Whether two segments begin at one point and run the same way.
bool begins(const Ends& a, const Ends& b) {
  const Rational ax = a.to.x - a.from.x, ay = a.to.y - a.from.y;
  const Rational bx = b.to.x - b.from.x, by = b.to.y - b.from.y;
  return a.from == b.from && ax * by == ay * bx && ax * bx + ay * by > 0;
}

/// Expects that the labels beside an edge are those beside its first piece.
void expect_labels_of_first_piece(const LabelledComplex& kept, HalfedgeId h,
                                  const PlaneComplex& complex,
                                  const std::vector<std::uint32_t>& label) {
  const auto kept_label = [&](HalfedgeId k) {
    return kept.label[kept.complex.dcel.face(k).value()];
  };
  std::size_t pieces = 0;
  for (std::size_t e = 0; e < complex.edge_count(); ++e) {
    const HalfedgeId g = first_half(EdgeId(e));
    if (!begins(ends(complex, g), ends(kept.complex, h))) continue;
    ++pieces;
    EXPECT_EQ(kept_label(h), label[complex.dcel.face(g).value()]);
    EXPECT_EQ(kept_label(twin(h)), label[complex.dcel.face(twin(g)).value()]);
  }
  EXPECT_EQ(pieces, 1U);
}

TEST(WithoutEdges, KeepsTheLabelsOfFaces) {
  Random random(3);
  for (std::uint64_t round = 0; round < share_of(400) && !HasFailure(); ++round) {
    SCOPED_TRACE(round);
    const PlaneComplex complex = random_complex(random);
    std::vector<std::uint32_t> label;
    for (std::size_t f = 0; f < complex.face_count(); ++f) {
      label.push_back(static_cast<std::uint32_t>(random() % 3));
    }
    Context context;
    const LabelledComplex kept = without_inner_edges(complex, label, {}, context);
    EXPECT_FALSE(audit(kept.complex, AuditForm::Any));
    ASSERT_EQ(kept.label.size(), kept.complex.face_count());
    EXPECT_EQ(kept.label[0], label[0]);
    for (std::size_t e = 0; e < kept.complex.edge_count(); ++e) {
      const HalfedgeId h = first_half(EdgeId(e));
      EXPECT_NE(kept.label[kept.complex.dcel.face(h).value()],
                kept.label[kept.complex.dcel.face(twin(h)).value()]);
      expect_labels_of_first_piece(kept, h, complex, label);
    }
  }
}

}  // namespace
}  // namespace plumb::testing::without_edges_test
