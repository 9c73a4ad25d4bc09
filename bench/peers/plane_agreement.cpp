// Small polygons and half-planes in special positions: every Boolean and operator of topology in
// plumb and in CGAL's Nef_polyhedron_2.
//
//   plane_agreement [--scenes N] [--first SEED] [--json FILE]      (default 10000 scenes)
//
// A scene is a random expression over triangles, rectangles and half-planes through points of a
// grid of 4 x 4. At every node of it the numbers of vertices, edges and faces are compared, and how
// many of each are marked, up to the first difference in a scene. The brute-force twin of
// tests/oracle judges plumb's answer of a set that differs. Exit 1 when the twin is not of plumb's
// opinion, or plumb crashed.
//
// Scenes run in batches, each in a process of its own; the scenes of a batch that crashes run again
// one by one.
#include <CGAL/Exact_integer.h>
#include <CGAL/Filtered_extended_homogeneous.h>
#include <CGAL/Nef_polyhedron_2.h>
#include <fmt/core.h>
#include <sys/mman.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "../report/report.h"
#include "oracle/nef2_check.h"
#include "oracle/plane_set.h"
#include "peer_report.h"
#include "plumb/testing/dice.h"
#include "random_expression.h"

namespace plumb::bench {
namespace {

using testing::Dice;
using testing::ExactPoint;
using testing::PlaneSetPointer;
using testing::SetOperator;

using Kernel = CGAL::Filtered_extended_homogeneous<CGAL::Exact_integer>;
using CgalNef = CGAL::Nef_polyhedron_2<Kernel>;

constexpr const char* kPeer = "CGAL Nef_polyhedron_2";
constexpr std::uint64_t kBatch = 50;

// ---------------------------------------------------------------- scenes

/// A point of the grid.
struct Place {
  std::int64_t x, y;
  ExactPoint exact() const { return {x, y}; }
  CgalNef::Point in_cgal() const { return {CGAL::Exact_integer(x), CGAL::Exact_integer(y)}; }
};

Place any_place(Dice& dice) {
  const std::int64_t x = dice.between(0, 3);
  return {x, dice.between(0, 3)};
}

std::int64_t turn(Place a, Place b, Place c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// The same set three times.
struct Shape {
  PlaneSetPointer expression;
  Nef2 ours;
  CgalNef theirs;
};

/// Returns a polygon whose corners are in counter-clockwise order.
Shape polygon(const std::vector<Place>& corners, bool is_closed) {
  testing::Chain chain;
  std::vector<CgalNef::Point> points;
  for (const Place& p : corners) {
    chain.push_back(p.exact());
    points.push_back(p.in_cgal());
  }
  const Boundary boundary = is_closed ? Boundary::Closed : Boundary::Open;
  const PlaneSetPointer set =
      testing::set_of(testing::SetPolygons{{chain}, WindingRule::NonZero, boundary});
  const auto included = is_closed ? CgalNef::INCLUDED : CgalNef::EXCLUDED;
  return {set, testing::to_nef(*set), CgalNef(points.begin(), points.end(), included)};
}

Shape any_triangle(Dice& dice, bool is_closed) {
  for (;;) {
    std::array<Place, 3> p{any_place(dice), any_place(dice), any_place(dice)};
    const std::int64_t area = turn(p[0], p[1], p[2]);
    if (area < 0) std::swap(p[1], p[2]);
    if (area != 0) return polygon({p.begin(), p.end()}, is_closed);
  }
}

Shape any_rectangle(Dice& dice, bool is_closed) {
  for (;;) {
    const Place p = any_place(dice), q = any_place(dice);
    if (p.x >= q.x || p.y >= q.y) continue;
    return polygon({p, {q.x, p.y}, q, {p.x, q.y}}, is_closed);
  }
}

Shape any_half_plane(Dice& dice, bool is_closed) {
  for (;;) {
    const Place a = any_place(dice), b = any_place(dice);
    if (a.x == b.x && a.y == b.y) continue;
    const PlaneSetPointer set = testing::set_of(
        testing::SetHalfPlane{a.exact(), b.exact(), is_closed ? Boundary::Closed : Boundary::Open});
    const CgalNef::Line line(a.in_cgal(), b.in_cgal());
    return {set, testing::to_nef(*set),
            CgalNef(line, is_closed ? CgalNef::INCLUDED : CgalNef::EXCLUDED)};
  }
}

Shape any_leaf(Dice& dice) {
  const bool is_closed = dice.below(3) != 0;
  const std::uint32_t kind = dice.below(5);
  if (kind < 2) return any_triangle(dice, is_closed);
  return kind < 4 ? any_rectangle(dice, is_closed) : any_half_plane(dice, is_closed);
}

CgalNef apply(SetOperator op, const CgalNef& a, const CgalNef& b) {
  switch (op) {
    case SetOperator::Union:
      return a.join(b);
    case SetOperator::Intersection:
      return a.intersection(b);
    case SetOperator::Difference:
      return a.difference(b);
    case SetOperator::SymmetricDifference:
      return a.symmetric_difference(b);
    case SetOperator::Complement:
      return a.complement();
    case SetOperator::Interior:
      return a.interior();
    case SetOperator::Closure:
      return a.closure();
    case SetOperator::Boundary:
      return a.boundary();
    case SetOperator::Exterior:
      return a.complement().interior();
    default:
      return a.regularization();
  }
}

// ---------------------------------------------------------------- what is compared

/// Numbers of vertices, edges and faces, and of marked ones.
struct Facts {
  std::array<std::size_t, 3> all{};
  std::array<std::size_t, 3> marked{};
  friend bool operator==(const Facts&, const Facts&) = default;

  void count(std::size_t kind, bool mark) {
    ++all[kind];
    marked[kind] += mark ? 1 : 0;
  }
  std::string text() const {
    return fmt::format("{} vertices ({} marked), {} edges ({} marked), {} faces ({} marked)",
                       all[0], marked[0], all[1], marked[1], all[2], marked[2]);
  }
};

Facts facts_of(const Nef2& set) {
  Facts facts;
  const PlaneMarks marks = set.marks();
  for (const std::uint8_t mark : marks.vertex) facts.count(0, mark != 0);
  for (const std::uint8_t mark : marks.edge) facts.count(1, mark != 0);
  for (const std::uint8_t mark : marks.face) facts.count(2, mark != 0);
  return facts;
}

/// Without the frame, with which CGAL surrounds a set, and the face outside of it, the first one.
Facts facts_of(const CgalNef& set) {
  Facts facts;
  const CgalNef::Explorer explorer = set.explorer();
  for (auto v = explorer.vertices_begin(); v != explorer.vertices_end(); ++v) {
    if (explorer.is_standard(v)) facts.count(0, explorer.mark(v));
  }
  for (auto e = explorer.halfedges_begin(); e != explorer.halfedges_end(); ++e) {
    const bool is_first = &*e < &*explorer.twin(e);
    if (is_first && !explorer.is_frame_edge(e)) facts.count(1, explorer.mark(e));
  }
  for (auto f = ++explorer.faces_begin(); f != explorer.faces_end(); ++f) {
    facts.count(2, explorer.mark(f));
  }
  return facts;
}

/// What the processes of all scenes count, in memory that they share.
struct Tally {
  std::size_t compared = 0;
  std::size_t different = 0;
  std::size_t wrong = 0;  ///< Sets of plumb that the twin contradicts.
  bool is_in_cgal = false;
};

/// One scene: two to five leaves, each opened now and then, joined by Booleans; up to the first
/// difference.
class Scene {
 public:
  Scene(std::uint64_t seed, Tally& tally) : seed_(seed), tally_(tally) {}

  void run() {
    Dice dice(seed_);
    draw_expression(
        dice, 4, [](Dice& d) { return any_leaf(d); },
        [this](SetOperator op, const Shape& a, const Shape& b) { return applied(op, a, b); },
        [this] { return differs_; });
  }

 private:
  Shape applied(SetOperator op, const Shape& a, const Shape& b) {
    if (differs_) return a;
    const PlaneSetPointer second = testing::is_binary(op) ? b.expression : nullptr;
    Shape result{testing::apply(op, a.expression, second), testing::apply(op, a.ours, b.ours), {}};
    const Facts own = facts_of(result.ours);
    tally_.is_in_cgal = true;
    result.theirs = apply(op, a.theirs, b.theirs);
    const Facts theirs = facts_of(result.theirs);
    tally_.is_in_cgal = false;
    ++tally_.compared;
    if (own != theirs) report(result, own, theirs);
    return result;
  }

  void report(const Shape& set, const Facts& own, const Facts& theirs) {
    differs_ = true;
    ++tally_.different;
    const std::string twin = testing::disagreement(*set.expression);
    if (!twin.empty()) ++tally_.wrong;
    fmt::print("seed {}: {} is wrong of {}\n  plumb: {}\n  CGAL:  {}\n{}", seed_,
               twin.empty() ? "CGAL" : "PLUMB", testing::to_text(*set.expression), own.text(),
               theirs.text(), twin.empty() ? "" : "  twin:  " + twin + '\n');
    std::fflush(stdout);
  }

  std::uint64_t seed_;
  Tally& tally_;
  bool differs_ = false;
};

/// Runs scenes in a process of its own. Returns what it printed; no value if it crashed.
std::optional<std::string> printed(std::uint64_t first, std::uint64_t end, Tally& tally) {
  const Tally before = tally;
  const Finished finished = run_apart([&] {
    for (std::uint64_t seed = first; seed < end; ++seed) Scene(seed, tally).run();
  });
  if (finished.is_well) return finished.output;
  const bool is_in_cgal = tally.is_in_cgal;
  tally = before;
  tally.is_in_cgal = is_in_cgal;
  return std::nullopt;
}

int run(std::uint64_t first, std::uint64_t scenes, const std::string& json) {
  void* const shared =
      mmap(nullptr, sizeof(Tally), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  auto& tally = *new (shared) Tally;
  PeerReport report("Random expressions of small polygons beside CGAL, judged by brute force");
  report.use("CGAL", CGAL_VERSION_STR);
  std::size_t crashed = 0;
  const auto run_scenes = [&](std::uint64_t begin, std::uint64_t end) {
    const std::size_t different = tally.different, wrong = tally.wrong;
    const auto text = printed(begin, end, tally);
    if (!text) return false;
    fmt::print("{}", *text);
    for (std::size_t i = different; i < tally.different; ++i) {
      const bool is_ours_right = i - different >= tally.wrong - wrong;
      report.judge({kPeer, fmt::format("seeds {} to {}", begin, end - 1), "", "", is_ours_right});
    }
    return true;
  };
  for (std::uint64_t begin = first; begin < first + scenes; begin += kBatch) {
    const std::uint64_t end = std::min(begin + kBatch, first + scenes);
    if (run_scenes(begin, end)) continue;
    for (std::uint64_t seed = begin; seed < end; ++seed) {
      if (run_scenes(seed, seed + 1)) continue;
      ++crashed;
      fmt::print("seed {}: {} crashed\n", seed, tally.is_in_cgal ? "CGAL" : "PLUMB");
      report.judge({kPeer, fmt::format("seed {}", seed), tally.is_in_cgal ? "no crash" : "crashed",
                    tally.is_in_cgal ? "crashed" : "", tally.is_in_cgal});
    }
  }
  report.judged_of(tally.compared);
  fmt::print("{} scenes from {}: {} sets compared, {} different, {} wrong of plumb, {} crashed\n",
             scenes, first, tally.compared, tally.different, tally.wrong, crashed);
  return report.finish(json);
}

}  // namespace
}  // namespace plumb::bench

int main(int argc, char** argv) {
  CLI::App app{"Sets of the plane in plumb and in CGAL's Nef_polyhedron_2"};
  std::uint64_t scenes = 10000;
  std::uint64_t first = 0;
  std::string json;
  app.add_option("--scenes", scenes, "how many (default 10000)");
  app.add_option("--first", first, "seed of the first (default 0)");
  app.add_option("--json", json, "write them there, too");
  CLI11_PARSE(app, argc, argv);
  return plumb::bench::run(first, scenes, json);
}
