// Rounds random scenes of space that are nearly degenerate: rounded_scenes [SCENES [FIRST]]
//
// A scene is one Boolean of two solids of generate/near_solids.h. It is smaller than the scenes of
// valid_mesh_test, so that a hundred thousand of them can be judged by brute force
// (oracle/valid_mesh_check.h). FIRST is the seed of the first scene, so a long run can be done in
// parts. Prints the numbers of scenes, of meshes that rounding damages, and of wrong results. Exit
// status 1 if a result is wrong.
#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <span>
#include <string>
#include <vector>

#include "generate/near_solids.h"
#include "oracle/valid_mesh_check.h"
#include "plumb/testing/dice.h"

namespace plumb::testing {
namespace {

constexpr std::uint64_t kStandard = 1000;

struct SceneCounts {
  std::uint64_t rounded = 0;   ///< Sets with coordinates that are not numbers of the output type.
  std::uint64_t damaged = 0;   ///< Meshes that need a repair after rounding to nearest numbers.
  std::uint64_t changed = 0;   ///< Meshes whose topology a repair changes.
  std::uint32_t rounds = 0;    ///< The greatest number of rounds of a repair.
  std::uint64_t too_many = 0;  ///< Repairs that go on on a coarser grid.
  std::uint64_t wrong = 0;
};

void count_repair(const RoundingRepair& repair, SceneCounts& counts) {
  counts.rounded += repair.rounded_vertices > 0 ? 1 : 0;
  counts.damaged += repair.rounds > 0 ? 1 : 0;
  counts.changed += repair.changes_topology ? 1 : 0;
  counts.rounds = std::max(counts.rounds, repair.rounds);
  counts.too_many += repair.coarse_rounds > 0 ? 1 : 0;
}

void judge_scene(std::uint64_t seed, SceneCounts& counts) {
  Dice dice(seed);
  const std::vector<std::uint8_t> bytes = random_near_solids(dice, 2);
  const std::span<const std::uint8_t> program(bytes);
  const auto last = program.subspan(kNearSolidRecord);
  const Nef3 set = apply_near_solid(apply_near_solid({}, program.first(kNearSolidRecord)), last);
  const NearSolidOutput out = near_solid_output(last);
  ValidMesh valid;
  const std::string wrong = valid_mesh_disagreement(set, out.type, out.faces, &valid);
  count_repair(valid.repair, counts);
  if (wrong.empty()) return;
  ++counts.wrong;
  std::printf("scene %llu: %s\n", static_cast<unsigned long long>(seed), wrong.c_str());
}

int judge_scenes(std::uint64_t first, std::uint64_t scenes) {
  SceneCounts counts;
  for (std::uint64_t seed = first; seed < first + scenes; ++seed) judge_scene(seed, counts);
  const auto number = [](std::uint64_t n) { return static_cast<unsigned long long>(n); };
  std::printf(
      "%llu scenes from %llu: %llu rounded, %llu damaged, %llu with another topology, "
      "%llu on coarser grids, at most %llu rounds, %llu wrong\n",
      number(scenes), number(first), number(counts.rounded), number(counts.damaged),
      number(counts.changed), number(counts.too_many), number(counts.rounds), number(counts.wrong));
  return counts.wrong == 0 ? 0 : 1;
}

}  // namespace
}  // namespace plumb::testing

int main(int argc, char** argv) {
  const auto argument = [&](int i, std::uint64_t otherwise) {
    return argc > i ? std::strtoull(argv[i], nullptr, 10) : otherwise;
  };
  return plumb::testing::judge_scenes(argument(2, 0), argument(1, plumb::testing::kStandard));
}
