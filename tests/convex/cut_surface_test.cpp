// Single cuts of a surface, along any plane through any reflex edge: every point of the set belongs
// to one side.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "generate/mesh_solid.h"
#include "generate/meshes.h"
#include "generate/voxel_mesh.h"
#include "oracle/pieces_check.h"
#include "plumb/convex/decompose.h"
#include "plumb/convex/part/choose_plane.h"
#include "plumb/convex/part/cut_set.h"
#include "plumb/convex/part/surface_cut.h"
#include "plumb/io/solid_io.h"
#include "plumb/predicates/point3_signs.h"
#include "plumb/space/complex/space_tables.h"
#include "plumb/testing/dice.h"

namespace plumb::testing::cut_surface_test {
namespace {

// ---------------------------------------------------------------- the oracle

/// How many rings of half-edges own each vertex, and how many edges between the same ends their
/// insides. One cut leaves the same vertices and edges on both sides.
class Owners {
 public:
  explicit Owners(const CutSurface& surface) : s_(surface) {
    std::vector<std::uint8_t> is_seen(s_.halves.size(), 0);
    for (std::size_t i = 0; i < s_.halves.size(); ++i) {
      const HalfedgeId h(i);
      const CutSurface::Half& half = s_.half(h);
      if (h < half.twin) {
        edge_[std::minmax(half.origin.value(), s_.target(h).value())] += half.mark;
      }
      if (is_seen[i] == 0) vertex_[half.origin.value()] += ring_mark(h, is_seen);
    }
  }

  /// Empty, or a point that none or several own.
  std::string flaw(const Nef3& set) const {
    if (has_torn_ring_) return "marks differ around a ring";
    for (const auto& [v, count] : vertex_) {
      const std::string found = flaw_at(set, at(v), count);
      if (!found.empty()) return "vertex " + found;
    }
    for (const auto& [ends, count] : edge_) {
      const RationalPoint3 a = at(ends.first), b = at(ends.second);
      const std::string found =
          flaw_at(set, {(a.x + b.x) / 2, (a.y + b.y) / 2, (a.z + b.z) / 2}, count);
      if (!found.empty()) return "edge " + found;
    }
    return {};
  }

 private:
  int ring_mark(HalfedgeId first, std::vector<std::uint8_t>& is_seen) {
    const Mark mark = s_.half(first).origin_mark;
    HalfedgeId h = first;
    do {
      is_seen[h.value()] = 1;
      has_torn_ring_ |= s_.half(h).origin_mark != mark;
      h = s_.half(s_.half(h).prev).twin;
    } while (h != first);
    return mark;
  }
  RationalPoint3 at(std::uint32_t v) const { return exact(s_.points(), s_.point[v]); }
  static std::string flaw_at(const Nef3& set, const RationalPoint3& p, int owners) {
    if (owners == (set.contains(p) ? 1 : 0)) return {};
    return p.x.str() + " " + p.y.str() + " " + p.z.str() + " has " + std::to_string(owners) +
           " owners";
  }

  const CutSurface& s_;
  std::map<std::uint32_t, int> vertex_;
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> edge_;
  bool has_torn_ring_ = false;
};

// ---------------------------------------------------------------- all cuts

/// Every plane of a face, and through another vertex, at every reflex edge.
class AllCuts {
 public:
  explicit AllCuts(const Nef3& set) : set_(set), surface_(cut_surface_of(set.complex())) {}

  std::string run() {
    if (!surface_) return "no surface";
    for (std::size_t i = 0; i < surface_->halves.size(); ++i) {
      const HalfedgeId h(i);
      if (!surface_->half(h).is_reflex || surface_->half(h).twin < h) continue;
      std::vector<PlaneId> planes{surface_->plane_of(h).plane(),
                                  surface_->plane_of(surface_->half(h).twin).plane()};
      CutSurface surface = *surface_;
      surface.tables = copy(*surface.tables);
      for (std::size_t v = 0; v < surface.point.size(); ++v) {
        const PlaneId plane = plane_through(surface, h, surface.point[v]);
        if (plane.is_valid()) planes.push_back(plane);
      }
      for (const PlaneId plane : planes) {
        const std::string flaw = cut(surface, h, plane);
        if (!flaw.empty()) return flaw;
      }
    }
    return {};
  }
  int cuts() const { return cuts_; }

 private:
  /// Where all points are input points.
  static PlaneId plane_through(CutSurface& surface, HalfedgeId h, SpacePoint c) {
    const SpacePoint a = surface.point[surface.half(h).origin.value()],
                     b = surface.point[surface.target(h).value()];
    if (!a.is_input() || !b.is_input() || !c.is_input() || a == c || b == c) return {};
    const OrientedPlane plane = surface.tables->planes.intern(a.input(), b.input(), c.input());
    return plane.is_valid() ? plane.plane() : PlaneId();
  }

  std::string cut(CutSurface surface, HalfedgeId seed, PlaneId plane) {
    std::vector<FaceId> faces;
    for (std::size_t f = 0; f < surface.faces.size(); ++f) faces.push_back(FaceId(f));
    const CutPieces pieces = PlaneCut(surface).run(faces, plane, seed);
    if (pieces.empty()) return {};
    ++cuts_;
    return Owners(surface).flaw(set_);
  }

  const Nef3& set_;
  std::optional<CutSurface> surface_;
  int cuts_ = 0;
};

void expect_owners(const Nef3& set, const std::string& name, int least_cuts) {
  for (const Nef3& each : {set, set.interior()}) {
    AllCuts cuts(each);
    EXPECT_EQ(cuts.run(), "") << name;
    EXPECT_GE(cuts.cuts(), least_cuts) << name;
  }
}

/// A pit whose bottom is the edge from (x, 3, z) to (x, 5, z).
Nef3 pit(double x, double z) {
  return solid(
      make_mesh({{x, 3, z}, {x, 5, z}, {x - 1, 1, 9}, {x + 1, 1, 9}, {x + 1, 7, 9}, {x - 1, 7, 9}},
                {{0, 3, 2}, {1, 5, 4}, {0, 1, 4, 3}, {0, 2, 5, 1}, {2, 3, 4, 5}}));
}

// The plane through the bottom edges touches both pits from below: no face stays below it there.
TEST(PlaneCut, OwnsTheBottomsOfPits) {
  const Nef3 block = solid(box_mesh({0, 0, 0}, {8, 8, 8}));
  expect_owners(block - pit(2, 4).interior() - pit(5, 4).interior(), "two pits", 20);
  expect_owners(block - pit(2, 4) - pit(5, 3), "two open pits", 20);
}

TEST(PlaneCut, OwnsEveryPointOnce) {
  expect_owners(solid(box_mesh({0, 0, 0}, {9, 9, 9})) - solid(box_mesh({3, 3, -1}, {5, 5, 10})),
                "a shaft", 4);
  for (std::uint64_t seed = 0; seed < 30 && !HasFailure(); ++seed) {
    Dice dice(seed);
    const int tenths = static_cast<int>(dice.between(4, 9));
    const Nef3 set = solid(voxel_mesh(random_voxels(dice, {2, 2, 2}, tenths)));
    if (cut_surface_of(set.complex())) expect_owners(set, "voxels " + std::to_string(seed), 0);
  }
}

// Two pits above three grooves: pieces once lost the end of a pit's bottom edge.
TEST(PlaneCut, KeepsVerticesOfTentPits) {
  const std::string path = "corpus/regress/convex/tent_pits.nef";
  Context context;
  const Nef3 set = read_solid_file(path, {}, context).set;
  for (const DecomposeMethod method :
       {DecomposeMethod::Cuts, DecomposeMethod::Walls, DecomposeMethod::Best}) {
    EXPECT_EQ(flaw_of_pieces(set, decompose(set, {method, false}, context), false), "");
  }
}

// ---------------------------------------------------------------- one plane an edge

/// By the rule Fixed alone; expects right pieces, and no more than the bound. Returns how many.
std::size_t pieces_by_fixed_planes(const Nef3& set, const std::string& name) {
  Context context;
  std::optional<CutSurface> surface = cut_surface_of(set.complex());
  if (!surface) return 0;
  std::vector<FaceId> all;
  for (std::size_t f = 0; f < surface->faces.size(); ++f) all.push_back(FaceId(f));
  if (touches_itself(*surface, all)) return 0;
  const SolidPieces cut = cut_solid(*surface, CutRule::Fixed, context);
  EXPECT_TRUE(cut.stuck.empty()) << name;
  ConvexPieces result;
  for (const auto& faces : cut.convex) {
    result.pieces.push_back(set_of_piece(*surface, faces, false, context));
  }
  EXPECT_EQ(flaw_of_pieces(set, result, false), "") << name;
  EXPECT_LE(result.pieces.size(), bound_of_cuts(1, cut.reflex_edges)) << name;
  EXPECT_EQ(bound_of_cuts(1, cut.reflex_edges), most_pieces(cut.reflex_edges));
  return result.pieces.size();
}

TEST(FixedPlanes, KeepTheBoundOfCombsStarsAndTerrains) {
  EXPECT_EQ(pieces_by_fixed_planes(solid(box_mesh({0, 0, 0}, {1, 1, 1})), "a box"), 1U);
  for (int tips = 3; tips < 7; ++tips) {
    EXPECT_GT(pieces_by_fixed_planes(solid(star_prism(tips)), "star"), 1U);
  }
  for (int notches = 0; notches < 4; ++notches) {
    const Nef3 comb = solid(comb_block(notches, 3));
    EXPECT_GT(pieces_by_fixed_planes(comb, "comb " + std::to_string(notches)), 3U);
    pieces_by_fixed_planes(comb.interior(), "open comb " + std::to_string(notches));
  }
  for (std::uint64_t seed = 0; seed < 6; ++seed) {
    Dice dice(seed);
    pieces_by_fixed_planes(solid(voxel_mesh(random_terrain(dice, 4, 3, 4))),
                           "terrain " + std::to_string(seed));
  }
}

TEST(FixedPlanes, KeepTheBoundOfVoxels) {
  std::size_t count = 0;
  for (std::uint64_t seed = 0; seed < 150 && !HasFailure(); ++seed) {
    Dice dice(seed);
    const int tenths = static_cast<int>(dice.between(5, 9));
    const Nef3 set = solid(voxel_mesh(random_voxels(dice, {2, 3, 2}, tenths)));
    count += pieces_by_fixed_planes(set, "voxels " + std::to_string(seed));
  }
  EXPECT_GT(count, 100U);
}

/// A pit in a block, from its tip to a triangle outside.
Nef3 pit_to(Point3 tip, Point3 a, Point3 b, Point3 c) {
  Context context;
  const PolygonMesh mesh = make_mesh({tip, a, b, c}, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}});
  return Nef3::from_mesh(mesh, {.rule = WindingRule::NonZero}, context).interior();
}

/// Is there an edge whose own plane a tip touches, so that nothing can be cut?
bool has_blocked_edge(const Nef3& set) {
  const CutSurface whole = *cut_surface_of(set.complex());
  std::vector<HalfedgeId> reflex;
  std::vector<FaceId> all;
  for (std::size_t h = 0; h < whole.halves.size(); ++h) {
    const CutSurface::Half& half = whole.halves[h];
    if (half.is_reflex && HalfedgeId(h) < half.twin) reflex.push_back(HalfedgeId(h));
  }
  for (std::size_t f = 0; f < whole.faces.size(); ++f) all.push_back(FaceId(f));
  for (const HalfedgeId h : reflex) {
    CutSurface surface = whole;
    surface.tables = copy(*whole.tables);
    Context context;
    const FixedPlanes planes(surface, reflex, context);
    PlaneCut cut(surface);
    if (cut.run(all, planes.plane(surface.half(h).edge), h).empty()) {
      EXPECT_TRUE(cut.puncture().is_valid());
      return true;
    }
  }
  return false;
}

// A step, whose edge runs along y at x = 4, z = 4, for y < 8. Tips in the way of its planes: above
// that at z = 4, beside that at x = 4, and one on the edge's line that touches every plane of the
// pencil that the edge could be cut by.
TEST(FixedPlanes, PassTipsOfPits) {
  const Nef3 step =
      solid(box_mesh({0, 0, 0}, {8, 12, 8})) - solid(box_mesh({4, -1, 4}, {9, 8, 9})).interior();
  const Nef3 above = pit_to({2, 2, 4}, {1, 1, 9}, {3, 1, 9}, {2, 3, 9});
  const Nef3 beside = pit_to({4, 5, 2}, {9, 4, 1}, {9, 6, 1}, {9, 5, 3});
  const Nef3 on_line = pit_to({4, 9, 4}, {-3, 9, 10}, {-1, 8, 10}, {-1, 10, 10});
  for (const Nef3& set : {step, step - above, step - beside, step - above - beside, step - on_line,
                          step - above - beside - on_line}) {
    pieces_by_fixed_planes(set, "pits");
  }
  EXPECT_FALSE(has_blocked_edge(step - above - beside));
  EXPECT_TRUE(has_blocked_edge(step - on_line));
}

}  // namespace
}  // namespace plumb::testing::cut_surface_test
