// Checks cells and their borders, for boxes on a flat mesh, against unit squares that are joined
// where no side of a box runs between them.
#include "plumb/surface/cells/surface_cells.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "generate/surface_scenes.h"
#include "plumb/testing/dice.h"

namespace plumb::surface_cells_test {

using testing::Dice;
using testing::SurfaceDrawing;

constexpr std::uint32_t kFaces = 3;  // squares of the mesh in a row
constexpr std::int64_t kFine = 4;    // unit squares in a row of each
constexpr std::int64_t kSize = kFaces * kFine;

struct Box {
  std::array<std::int64_t, 2> low, high;
};

/// The mesh in unit squares; a mesh square holds kFine times kFine of them.
class Squares {
 public:
  explicit Squares(const std::vector<Box>& boxes) : part_(kSize * kSize) {
    for (const Box& b : boxes) {
      for (std::int64_t y = b.low[1]; y < b.high[1]; ++y) {
        walls_.insert({b.low[0] - 1, y, b.low[0], y});
        walls_.insert({b.high[0] - 1, y, b.high[0], y});
      }
      for (std::int64_t x = b.low[0]; x < b.high[0]; ++x) {
        walls_.insert({x, b.low[1] - 1, x, b.low[1]});
        walls_.insert({x, b.high[1] - 1, x, b.high[1]});
      }
    }
    for (std::size_t i = 0; i < part_.size(); ++i) part_[i] = i;
    for (bool grows = true; grows;) {
      grows = false;
      for_neighbours([&](std::size_t i, std::size_t j, bool is_wall) {
        if (is_wall || part_[i] == part_[j]) return;
        part_[i] = part_[j] = std::min(part_[i], part_[j]);
        grows = true;
      });
    }
  }
  std::size_t part(std::int64_t x, std::int64_t y) const { return part_[index(x, y)]; }
  const std::vector<std::size_t>& parts() const { return part_; }

  template <class Visit>
  void for_neighbours(const Visit& visit) const {
    for (std::int64_t y = 0; y < kSize; ++y) {
      for (std::int64_t x = 0; x < kSize; ++x) {
        if (x + 1 < kSize) visit(index(x, y), index(x + 1, y), walls_.contains({x, y, x + 1, y}));
        if (y + 1 < kSize) visit(index(x, y), index(x, y + 1), walls_.contains({x, y, x, y + 1}));
      }
    }
  }

 private:
  static std::size_t index(std::int64_t x, std::int64_t y) {
    return static_cast<std::size_t>(y * kSize + x);
  }
  std::vector<std::size_t> part_;
  std::set<std::array<std::int64_t, 4>> walls_;
};

/// Boxes on a shuffled grid, cut, and the part of each cell.
struct Divided {
  SurfaceDrawing drawing;
  Squares squares;
  SurfaceArrangement arrangement;
  SurfaceCells cells;
  std::vector<std::size_t> part;  ///< per cell

  Divided(const std::vector<Box>& boxes, std::uint64_t shuffle)
      : drawing(testing::grid_mesh(kFaces, kFaces, shuffle)), squares(boxes) {
    const auto at = [](const std::array<std::int64_t, 2>& p) {
      return RationalPoint2{Rational(Rational(p[0]) / kFine), Rational(Rational(p[1]) / kFine)};
    };
    for (const Box& b : boxes) drawing.add_box(at(b.low), at(b.high));
    arrangement = slice(drawing.scene.polygons, unlimited_context());
    cells = make_cells(*drawing.scene.mesh, arrangement, unlimited_context());
    part.assign(cells.size(), kSize * kSize);
  }
};

std::vector<Box> any_boxes(Dice& dice) {
  std::vector<Box> boxes(dice.below(6));
  for (Box& b : boxes) {
    for (const std::size_t i : {0U, 1U}) {
      b.low[i] = dice.between(1, kSize - 3);
      b.high[i] = dice.between(b.low[i] + 1, kSize - 1);
    }
  }
  return boxes;
}

/// Finds the parts of cells by corners of faces, where no cell is seen twice with another part.
void find_parts(Divided& d) {
  const SurfaceMesh& mesh = *d.drawing.scene.mesh;
  for (std::uint32_t f = 0; f < mesh.face_count(); ++f) {
    const Point3& corner = mesh.point(mesh.corner(FaceId(f), 0));
    Point3 towards{0, 0, 0};  // the middle of the face, seen from the corner
    for (const std::size_t i : {1U, 2U}) {
      const Point3& p = mesh.point(mesh.corner(FaceId(f), i));
      towards = {towards.x + p.x - corner.x, towards.y + p.y - corner.y, 0};
    }
    const auto x = static_cast<std::int64_t>(corner.x) * kFine - (towards.x < 0 ? 1 : 0);
    const auto y = static_cast<std::int64_t>(corner.y) * kFine - (towards.y < 0 ? 1 : 0);
    const std::size_t part = d.squares.part(x, y);
    std::size_t& known = d.part[cell_at_corner(d.arrangement, d.cells, FaceId(f)).value()];
    EXPECT_TRUE(known == kSize * kSize || known == part) << f;
    known = part;
  }
}

TEST(SurfaceCells, AreSquaresWithNoSideOfABoxBetweenThem) {
  for (std::uint64_t seed = 0; seed < 25 && !::testing::Test::HasFailure(); ++seed) {
    SCOPED_TRACE(seed);
    Dice dice(seed);
    const std::vector<Box> boxes = any_boxes(dice);
    Divided d(boxes, seed);
    find_parts(d);
    std::map<std::size_t, std::int64_t> areas;
    for (const std::size_t p : d.squares.parts()) ++areas[p];
    ASSERT_EQ(d.cells.size(), areas.size());
    std::vector<double> expected, area;
    for (const auto& [part, count] : areas) {
      expected.push_back(static_cast<double>(count) / (kFine * kFine));
    }
    area = d.cells.area;
    std::ranges::sort(expected);
    std::ranges::sort(area);
    for (std::size_t i = 0; i < area.size(); ++i) EXPECT_NEAR(area[i], expected[i], 1e-12);
    std::set<std::size_t> seen;
    for (std::uint32_t c = 0; c < d.cells.size(); ++c) {
      if (d.part[c] == kSize * kSize) continue;
      EXPECT_TRUE(seen.insert(d.part[c]).second);
      EXPECT_NEAR(d.cells.area[c], static_cast<double>(areas[d.part[c]]) / (kFine * kFine), 1e-12);
      // Boxes keep away from the border, so all of it is in one cell.
      EXPECT_EQ(d.cells.is_at_border[c] != 0, d.part[c] == d.squares.part(0, 0));
    }
    EXPECT_EQ(std::ranges::count(d.cells.is_at_border, 1), 1);

    std::set<std::pair<std::size_t, std::size_t>> beside;
    d.squares.for_neighbours([&](std::size_t i, std::size_t j, bool is_wall) {
      const auto& parts = d.squares.parts();
      if (is_wall) beside.insert(std::minmax(parts[i], parts[j]));
    });
    std::set<std::pair<CellId, CellId>> linked;
    for (const CellEdge& e : d.cells.edges) {
      EXPECT_LE(e.from, e.to);
      linked.emplace(e.from, e.to);
    }
    EXPECT_EQ(linked.size(), beside.size());
  }
}

/// Labels of the box that a cell edge names grow by one into it.
TEST(SurfaceCells, EdgesLeadIntoTheBoxesTheyName) {
  Divided d({{{2, 2}, {9, 9}}, {{4, 4}, {6, 6}}, {{9, 2}, {11, 9}}}, 5);
  ASSERT_EQ(d.cells.size(), 4U);
  const auto cell_of_area = [&](double units) {
    for (std::uint32_t c = 0; c < d.cells.size(); ++c) {
      if (std::fabs(d.cells.area[c] * kFine * kFine - units) < 1e-9) return CellId(c);
    }
    return CellId();
  };
  const CellId big = cell_of_area(45), small = cell_of_area(4), right = cell_of_area(14),
               outside = cell_of_area(81);
  std::map<std::pair<CellId, CellId>, std::map<std::uint32_t, std::int32_t>> jumps;
  for (const CellEdge& e : d.cells.edges) {
    for (const SignedEntry& m : d.arrangement.bundles[e.bundle]) {
      jumps[{e.from, e.to}][m.id] = m.value * e.sign;
      jumps[{e.to, e.from}][m.id] = -m.value * e.sign;
    }
  }
  using Jump = std::map<std::uint32_t, std::int32_t>;
  EXPECT_EQ(d.cells.edges.size(), 4U);
  EXPECT_EQ((jumps[{outside, big}]), (Jump{{0, 1}}));
  EXPECT_EQ((jumps[{big, small}]), (Jump{{1, 1}}));
  EXPECT_EQ((jumps[{outside, right}]), (Jump{{2, 1}}));
  EXPECT_EQ((jumps[{big, right}]), (Jump{{0, -1}, {2, 1}}));
}

/// The borders of any cells have these to their left: by area and by length.
TEST(SurfaceCells, BordersRunAroundTheSelectedCells) {
  for (std::uint64_t seed = 0; seed < 25 && !::testing::Test::HasFailure(); ++seed) {
    SCOPED_TRACE(seed);
    Dice dice(seed);
    const std::vector<Box> boxes = any_boxes(dice);
    Divided d(boxes, seed + 1);
    std::vector<std::uint32_t> all;
    for (std::uint32_t p = 0; p < boxes.size(); ++p) all.push_back(p);
    std::vector<std::uint8_t> is_selected(d.cells.size());
    double expected = 0;
    for (std::size_t c = 0; c < is_selected.size(); ++c) {
      is_selected[c] = dice.below(2) == 0 ? 1 : 0;
      if (is_selected[c] == 0) continue;
      expected += d.cells.area[c];
      if (d.cells.is_at_border[c] != 0) expected -= kFaces * kFaces;
    }
    const SurfacePolygons borders = trace_borders(d.drawing.scene.polygons, d.arrangement, d.cells,
                                                  is_selected, all, unlimited_context());
    require_valid(borders);
    double area = 0, length = 0;
    for (std::size_t p = 0; p < borders.size(); ++p) {
      for (std::uint32_t i = borders.begin[p]; i < borders.begin[p + 1]; ++i) {
        const Point3 a = borders.points.position(borders.point[i]);
        const Point3 b = borders.points.position(borders.point[borders.next(p, i)]);
        area += (a.x * b.y - a.y * b.x) / 2;
        length += std::hypot(b.x - a.x, b.y - a.y);
      }
    }
    EXPECT_NEAR(area, expected, 1e-9);
    // Arcs between a selected cell and another, each once.
    double around = 0;
    for (std::size_t i = 0; i < d.arrangement.arc_count(); ++i) {
      const HalfedgeId h = d.arrangement.arc_halfedge[i], t = d.arrangement.twin[h.value()];
      const auto selected = [&](HalfedgeId g) {
        return is_selected[d.cells.of_piece[d.arrangement.piece[g.value()].value()].value()];
      };
      if (selected(h) == selected(t)) continue;
      SurfacePointTable ends(*d.drawing.scene.mesh);
      const auto at = [&](NodeId n) {
        return ends.position(
            add_node_point(d.arrangement, d.drawing.scene.polygons.points, n, ends));
      };
      const Point3 a = at(d.arrangement.origin[h.value()]), b = at(d.arrangement.target(h));
      around += std::hypot(b.x - a.x, b.y - a.y);
    }
    EXPECT_NEAR(length, around, 1e-9);
  }
}

}  // namespace plumb::surface_cells_test
