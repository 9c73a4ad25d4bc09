// Small solids in special positions: every Boolean and operator of topology in plumb and in CGAL's
// Nef_polyhedron_3.
//
//   space_agreement [--scenes N] [--first SEED] [--out DIR] [--json FILE]      (default 10000
//   scenes)
//
// A scene is a random expression over boxes, tetrahedra and prisms with corners on a grid of 4 x 4
// x 4. At every node of it the numbers of vertices, edges, facets and volumes, how many of each are
// marked, the mark of the outer volume and the exact volume are compared, up to the first
// difference in a scene. That goes to DIR as files: the operands (SEED_a.nef, SEED_b.nef) and what
// differs (SEED.txt), with the verdict of the brute-force twin of tests/oracle on plumb's answer.
// Exit 1 when the twin is not of plumb's opinion, or plumb crashed.
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Nef_polyhedron_3.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Polyhedron_incremental_builder_3.h>
#include <fmt/core.h>
#include <sys/mman.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "../report/report.h"
#include "generate/space_solids.h"
#include "oracle/nef3_check.h"
#include "peer_report.h"
#include "plumb/io/nef3_writer.h"
#include "plumb/space/space_audit.h"
#include "plumb/space/space_measure.h"
#include "plumb/testing/dice.h"
#include "random_expression.h"

namespace plumb::bench {
namespace {

using testing::Dice;
using testing::ExactPoint3;
using testing::MeshLeaf;
using testing::SetOperator;
using testing::SpaceSetPointer;

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using CgalMesh = CGAL::Polyhedron_3<Kernel>;
using CgalNef = CGAL::Nef_polyhedron_3<Kernel>;

// ---------------------------------------------------------------- scenes

constexpr const char* kPeer = "CGAL Nef_polyhedron_3";
constexpr const char* kAgrees = "agrees with plumb";  ///< the twin

/// The same set three times.
struct Solid {
  SpaceSetPointer expression;
  Nef3 ours;
  CgalNef theirs;
};

ExactPoint3 any_point(Dice& dice) {
  ExactPoint3 p;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    testing::coordinate(p, axis) = dice.between(0, 3);
  }
  return p;
}

MeshLeaf any_box(Dice& dice) {
  for (;;) {
    const ExactPoint3 p = any_point(dice);
    const ExactPoint3 q = any_point(dice);
    if (p.x != q.x && p.y != q.y && p.z != q.z) return testing::box(p, q);
  }
}

MeshLeaf any_tetrahedron(Dice& dice) {
  for (;;) {
    const ExactPoint3 a = any_point(dice);
    const ExactPoint3 b = any_point(dice);
    const ExactPoint3 c = any_point(dice);
    const ExactPoint3 d = any_point(dice);
    if (dot(cross(b - a, c - a), d - a) != 0) return testing::tetrahedron(a, b, c, d);
  }
}

MeshLeaf any_prism(Dice& dice) {
  const std::size_t axis = dice.below(3);
  const std::int64_t low = dice.between(0, 2);
  const std::int64_t high = dice.between(low + 1, 3);
  for (;;) {
    const ExactPoint3 a = any_point(dice);
    const ExactPoint3 b = any_point(dice);
    const ExactPoint3 c = any_point(dice);
    const ExactPoint3 normal = cross(b - a, c - a);
    if (testing::coordinate(normal, axis) != 0) {
      return testing::prism({a, b, c}, axis, low, high);
    }
  }
}

MeshLeaf any_mesh(Dice& dice) {
  const std::uint32_t kind = dice.below(4);
  if (kind < 2) return any_box(dice);
  return kind == 2 ? any_tetrahedron(dice) : any_prism(dice);
}

class BuildMesh : public CGAL::Modifier_base<CgalMesh::HalfedgeDS> {
 public:
  explicit BuildMesh(const MeshLeaf& mesh) : mesh_(mesh) {}
  void operator()(CgalMesh::HalfedgeDS& result) override {
    CGAL::Polyhedron_incremental_builder_3<CgalMesh::HalfedgeDS> builder(result, true);
    builder.begin_surface(mesh_.points.size(), mesh_.faces.size());
    for (const ExactPoint3& p : mesh_.points) {
      Point3 at;
      testing::as_double(p, at);
      builder.add_vertex(Kernel::Point_3(at.x, at.y, at.z));
    }
    for (const auto& face : mesh_.faces) builder.add_facet(face.begin(), face.end());
    builder.end_surface();
  }

 private:
  const MeshLeaf& mesh_;
};

Solid any_leaf(Dice& dice) {
  const MeshLeaf mesh = any_mesh(dice);
  CgalMesh built;
  BuildMesh build(mesh);
  built.delegate(build);
  const SpaceSetPointer expression = testing::space_set(mesh);
  return {expression, testing::to_nef(*expression), CgalNef(built)};
}

CgalNef apply(SetOperator op, const CgalNef& a, const CgalNef& b) {
  switch (op) {
    case SetOperator::Union:
      return a + b;
    case SetOperator::Intersection:
      return a * b;
    case SetOperator::Difference:
      return a - b;
    case SetOperator::SymmetricDifference:
      return a ^ b;
    case SetOperator::Complement:
      return !a;
    case SetOperator::Interior:
      return a.interior();
    case SetOperator::Closure:
      return a.closure();
    case SetOperator::Boundary:
      return a.boundary();
    case SetOperator::Exterior:
      return (!a).interior();
    default:
      return a.regularization();
  }
}

// ---------------------------------------------------------------- what is compared

/// As text, so that a difference can be read.
struct Facts {
  std::string counts;
  std::string volume;
  friend bool operator==(const Facts&, const Facts&) = default;
};

template <class Marks>
std::string tally(std::string_view name, const Marks& marks) {
  std::size_t all = 0;
  std::size_t marked = 0;
  for (const auto mark : marks) {
    if (mark == kBeyond) continue;
    ++all;
    marked += mark != 0 ? 1 : 0;
  }
  return fmt::format("{} {} ({} marked), ", name, all, marked);
}

Facts facts_of(const Nef3& set) {
  const SpaceComplex& c = set.complex();
  const auto volume = marked_volume(c);
  return {tally("vertices", c.vertex_mark) + tally("edges", c.edge_mark) +
              tally("facets", c.facet_mark) + tally("volumes", c.volume_mark) +
              fmt::format("outside {}", static_cast<int>(c.volume_mark[0])),
          volume ? volume->str() : "infinite"};
}

/// Six times the volume behind a facet, seen from the origin; negative, as cycles run in CGAL.
Kernel::FT cone(CgalNef::Halffacet_const_handle facet) {
  Kernel::FT sum = 0;
  for (auto cycle = facet->facet_cycles_begin(); cycle != facet->facet_cycles_end(); ++cycle) {
    if (!cycle.is_shalfedge()) continue;
    const CgalNef::SHalfedge_const_handle begin = cycle;
    CgalNef::SHalfedge_around_facet_const_circulator at(begin);
    const auto end = at;
    const Kernel::Point_3 first = at->source()->source()->point();
    const auto vector = [](const Kernel::Point_3& p) { return p - CGAL::ORIGIN; };
    do {
      const Kernel::Point_3 p = at->source()->source()->point();
      const Kernel::Point_3 q = at->next()->source()->source()->point();
      sum += CGAL::determinant(vector(first), vector(p), vector(q));
    } while (++at != end);
  }
  return sum;
}

std::string to_text(const Kernel::FT& number) {
  std::ostringstream out;
  out << CGAL::exact(number);
  return out.str();
}

/// The volumes of a set, the outer one first: the facets of any other see a positive volume before
/// them. (The first in CGAL's own order is not always the outer one.)
std::pair<std::vector<Mark>, std::string> volumes_of(const CgalNef& set) {
  std::map<const void*, Kernel::FT> size;
  for (auto f = set.halffacets_begin(); f != set.halffacets_end(); ++f) {
    size[&*f->incident_volume()] -= cone(f);
  }
  std::vector<Mark> marks{0};
  Kernel::FT sum = 0;
  for (auto c = set.volumes_begin(); c != set.volumes_end(); ++c) {
    const Kernel::FT& own = size[&*c];
    if (own <= 0) {
      marks.front() = c->mark() ? 1 : 0;
      continue;
    }
    marks.push_back(c->mark() ? 1 : 0);
    if (c->mark()) sum += own;
  }
  return {marks, marks.front() != 0 ? "infinite" : to_text(sum / 6)};
}

Facts facts_of(const CgalNef& set) {
  std::vector<Mark> vertices;
  std::vector<Mark> edges;
  std::vector<Mark> facets;
  for (auto v = set.vertices_begin(); v != set.vertices_end(); ++v) vertices.push_back(v->mark());
  for (auto e = set.halfedges_begin(); e != set.halfedges_end(); ++e) {
    if (!e->is_twin()) edges.push_back(e->mark());
  }
  for (auto f = set.halffacets_begin(); f != set.halffacets_end(); ++f) {
    if (!f->is_twin()) facets.push_back(f->mark());
  }
  const auto [volumes, size] = volumes_of(set);
  return {tally("vertices", vertices) + tally("edges", edges) + tally("facets", facets) +
              tally("volumes", volumes) + fmt::format("outside {}", static_cast<int>(volumes[0])),
          size};
}

struct Step {
  SetOperator op;
  Solid a;
  Solid b;
  Solid result;
};

/// What the processes of all scenes count, in memory that they share.
struct Tally {
  std::size_t compared = 0;
  std::size_t different = 0;
  bool is_in_cgal = false;
};

/// One scene: two to four leaves, each opened now and then, joined by Booleans; up to the first
/// difference.
class Scene {
 public:
  Scene(std::uint64_t seed, std::string directory, Tally& tally)
      : seed_(seed), directory_(std::move(directory)), tally_(tally) {}

  void run() {
    Dice dice(seed_);
    draw_expression(
        dice, 3, [](Dice& d) { return any_leaf(d); },
        [this](SetOperator op, const Solid& a, const Solid& b) { return applied(op, a, b); },
        [this] { return differs_; });
  }

 private:
  Solid applied(SetOperator op, const Solid& a, const Solid& b) {
    if (differs_) return a;
    const SpaceSetPointer second = testing::is_binary(op) ? b.expression : nullptr;
    Step step{op, a, b, {testing::apply(op, a.expression, second), {}, {}}};
    step.result.ours = testing::apply(op, a.ours, b.ours);
    const Facts own = facts_of(step.result.ours);
    tally_.is_in_cgal = true;
    step.result.theirs = apply(op, a.theirs, b.theirs);
    const Facts theirs = facts_of(step.result.theirs);
    tally_.is_in_cgal = false;
    compare(step, own, theirs);
    return step.result;
  }

  void compare(const Step& step, const Facts& ours, const Facts& theirs) {
    ++tally_.compared;
    if (ours == theirs) return;
    ++tally_.different;
    differs_ = true;
    write(step, ours, theirs);
  }

  void write(const Step& step, const Facts& ours, const Facts& theirs) const {
    std::filesystem::create_directories(directory_);
    const std::string name = fmt::format("{}/{}", directory_, seed_);
    std::ofstream a(name + "_a.nef");
    write_nef3(a, step.a.ours.complex());
    std::ofstream b(name + "_b.nef");
    write_nef3(b, step.b.ours.complex());
    const std::string twin = testing::disagreement(*step.result.expression);
    // Line by line what PeerReport::Judgement holds.
    std::ofstream text(name + ".txt");
    text << testing::name_of(step.op) << ": " << testing::to_text(*step.result.expression) << '\n'
         << ours.counts << ", volume " << ours.volume << '\n'
         << theirs.counts << ", volume " << theirs.volume << '\n'
         << (twin.empty() ? kAgrees : twin) << '\n';
  }

  std::uint64_t seed_;
  std::string directory_;
  Tally& tally_;
  bool differs_ = false;
};

/// In a process of its own: a crash ends one scene. True unless it crashed.
bool ends_well(std::uint64_t seed, const std::string& directory, Tally& tally) {
  return run_apart([&] { Scene(seed, directory, tally).run(); }).is_well;
}

/// What the process of the scene has left in the file.
PeerReport::Judgement judgement(std::uint64_t seed, const std::string& directory) {
  PeerReport::Judgement result{kPeer, "", "", "", false};
  std::string twin;
  std::ifstream text(fmt::format("{}/{}.txt", directory, seed));
  std::getline(text, result.input);
  std::getline(text, result.ours);
  std::getline(text, result.theirs);
  std::getline(text, twin);
  result.is_ours_right = twin == kAgrees;
  return result;
}

int run(std::uint64_t first, std::uint64_t scenes, const std::string& directory,
        const std::string& json) {
  void* const shared =
      mmap(nullptr, sizeof(Tally), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  auto& tally = *new (shared) Tally;
  PeerReport report("Random expressions of small solids beside CGAL, judged by brute force");
  report.use("CGAL", CGAL_VERSION_STR);
  std::size_t crashed = 0;
  for (std::uint64_t seed = first; seed < first + scenes; ++seed) {
    const std::size_t before = tally.different;
    if (!ends_well(seed, directory, tally)) {
      ++crashed;
      report.judge({kPeer, fmt::format("seed {}", seed), tally.is_in_cgal ? "no crash" : "crashed",
                    tally.is_in_cgal ? "crashed" : "", tally.is_in_cgal});
      tally.is_in_cgal = false;
    } else if (tally.different > before) {
      const PeerReport::Judgement found = judgement(seed, directory);
      fmt::print("seed {}: {} is wrong of {}\n", seed, found.is_ours_right ? "CGAL" : "PLUMB",
                 found.input);
      report.judge(found);
    }
  }
  report.judged_of(tally.compared);
  fmt::print("{} scenes, {} sets compared, {} different, {} scenes crashed\n", scenes,
             tally.compared, tally.different, crashed);
  return report.finish(json);
}

}  // namespace
}  // namespace plumb::bench

int main(int argc, char** argv) {
  CLI::App app{"Solids in plumb and in CGAL's Nef_polyhedron_3"};
  std::uint64_t scenes = 10000;
  std::uint64_t first = 0;
  std::string directory = "space-differences", json;
  app.add_option("--scenes", scenes, "how many (default 10000)");
  app.add_option("--first", first, "seed of the first (default 0)");
  app.add_option("--out", directory, "where differences go");
  app.add_option("--json", json, "write them there, too");
  CLI11_PARSE(app, argc, argv);
  return plumb::bench::run(first, scenes, directory, json);
}
