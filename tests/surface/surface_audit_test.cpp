// Checks that the audit accepts divided surfaces and names the invariant that each damage breaks.
#include "plumb/surface/surface_audit.h"

#include <gtest/gtest.h>

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "generate/surface_scenes.h"
#include "plumb/surface/cells/surface_arrangement.h"
#include "plumb/surface/cells/surface_cells.h"

namespace plumb::surface_audit_test {

using testing::grid_mesh;
using testing::SurfaceDrawing;
using testing::torus_mesh;

/// Two boxes that cross in faces and on edges, and one of them again.
SurfaceScene boxes() {
  SurfaceDrawing drawing(grid_mesh(3, 3));
  const auto at = [](std::int64_t x, std::int64_t y) {
    return RationalPoint2{Rational(Rational(x) / 10), Rational(Rational(y) / 10)};
  };
  drawing.add_box(at(3, 4), at(18, 21));
  drawing.add_box(at(11, 13), at(26, 27));
  drawing.add_box(at(11, 13), at(26, 27));
  return drawing.scene;
}

/// A division owns its parts, so that a test may change them.
SurfaceArrangement& arrangement(const SurfaceDivision& d) {
  return const_cast<SurfaceArrangement&>(d.arrangement());
}
SurfaceCells& cells(const SurfaceDivision& d) { return const_cast<SurfaceCells&>(d.cells()); }

struct Damage {
  std::string flaw;  ///< How it begins.
  std::function<void(const SurfaceDivision&)> make;
};

TEST(SurfaceAudit, NamesTheInvariantBroken) {
  const std::vector<Damage> damages{
      {"sizes", [](const auto& d) { arrangement(d).twin.pop_back(); }},
      {"next is no permutation",
       [](const auto& d) { arrangement(d).next[0] = arrangement(d).next[1]; }},
      {"no such node",
       [](const auto& d) { arrangement(d).origin[2] = NodeId(d.arrangement().node_count()); }},
      {"twin",
       [](const auto& d) {
         for (HalfedgeId& t : arrangement(d).twin) {
           if (t.is_valid()) {
             t = HalfedgeId();
             return;
           }
         }
       }},
      {"half-edge of arc",
       [](const auto& d) {
         std::swap(arrangement(d).arc_halfedge[0], arrangement(d).arc_halfedge[1]);
       }},
      {"areas of pieces", [](const auto& d) { arrangement(d).piece_share[0] += 0.01; }},
      {"slot", [](const auto& d) { ++arrangement(d).piece_slot.back(); }},
      {"loops", [](const auto& d) { arrangement(d).loop.pop_back(); }},
      {"a polygon ends",
       [](const auto& d) {
         HalfedgeId& h = arrangement(d).arc_halfedge[0];
         h = d.arrangement().twin[h.value()];
       }},
      {"two nodes in one place",
       [](const auto& d) { arrangement(d).crossings.push_back(arrangement(d).crossings.back()); }},
      {"graph of cells", [](const auto& d) { cells(d).edges.pop_back(); }},
      {"cell edge", [](const auto& d) { std::swap(cells(d).edges[0].from, cells(d).edges[0].to); }},
      {"label at arc",
       [](const auto& d) {
         for (std::uint32_t c = 0; c < d.cell_count(); ++c) {
           for (const SignedEntry& e : d.labels(CellId(c))) {
             ++const_cast<SignedEntry&>(e).value;
             return;
           }
         }
       }},
  };
  EXPECT_EQ(audit(SurfaceDivision(boxes())).value_or(""), "");
  for (const Damage& damage : damages) {
    const SurfaceDivision division(boxes());
    damage.make(division);
    const std::string flaw = audit(division).value_or("");
    EXPECT_EQ(flaw.substr(0, damage.flaw.size()), damage.flaw) << flaw;
  }
}

/// Each piece is given to each other cell in turn.
TEST(SurfaceAudit, FindsEveryPieceInAWrongCell) {
  const SurfaceDivision division(boxes());
  std::vector<CellId>& of_piece = cells(division).of_piece;
  for (CellId& c : of_piece) {
    const CellId right = c;
    for (std::uint32_t other = 0; other < division.cell_count(); ++other) {
      c = CellId(other);
      EXPECT_EQ(audit(division).has_value(), c != right);
    }
    c = right;
  }
}

/// One meridian of a torus does not separate it; two of one direction do so modulo 2 alone.
TEST(SurfaceAudit, AsksCertificatesToProveWhatTheySay) {
  SurfaceDrawing drawing(torus_mesh(4, 3));
  drawing.add_vertex_polygon(std::vector<std::uint32_t>{0, 1, 2});
  drawing.add_vertex_polygon(std::vector<std::uint32_t>{3, 4, 5});
  drawing.scene.shapes = std::vector<std::vector<std::uint32_t>>{{0}, {0, 1}};
  const SurfaceDivision division(drawing.scene);
  EXPECT_EQ(audit(division).value_or(""), "");
  auto& first = const_cast<Separation&>(division.shape_separation(0));
  auto& second = const_cast<Separation&>(division.shape_separation(1));
  ASSERT_FALSE(first.over_z || first.mod_2);
  ASSERT_FALSE(second.over_z);
  ASSERT_TRUE(second.mod_2);
  const auto flaw = [&] { return audit(division).value_or("none").substr(0, 12); };
  const Separation proven = first;
  first.cycle.clear();
  EXPECT_EQ(flaw(), "no cycle at ");
  first.cycle = {proven.cycle[0]};
  EXPECT_NE(flaw(), "none");
  first = proven;
  second.mod_2 = false;
  EXPECT_NE(flaw(), "none");
}

}  // namespace plumb::surface_audit_test
