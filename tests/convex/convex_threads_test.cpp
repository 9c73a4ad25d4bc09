// Decompositions and Minkowski sums are the same, byte by byte, whatever the number of threads.
#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <sstream>
#include <stop_token>
#include <string>
#include <utility>
#include <vector>

#include "generate/mesh_solid.h"
#include "generate/meshes.h"
#include "generate/voxel_mesh.h"
#include "plumb/convex/decompose.h"
#include "plumb/convex/minkowski.h"
#include "plumb/io/nef3_writer.h"
#include "plumb/predicates/error.h"
#include "plumb/space/nef3.h"
#include "plumb/testing/dice.h"

namespace plumb::testing::convex_threads_test {
namespace {

constexpr unsigned kMostThreads = 4;

Context with_threads(unsigned threads, Limits limits = {}, std::stop_token stop = {}) {
  return Context(limits, std::move(stop), {}, threads);
}

std::string text_of(const Nef3& set) {
  std::ostringstream out;
  write_nef3(out, set.complex());
  return std::move(out).str();
}

/// Blocks of cubes in three places, so that the set has several parts.
Nef3 random_parts(Dice& dice) {
  std::vector<Nef3> parts;
  for (int i = 0; i < 3; ++i) {
    const PolygonMesh mesh = voxel_mesh(random_voxels(dice, {4, 3, 3}, 2));
    parts.push_back(solid(moved(mesh, {10.0 * i, 0, 0})));
  }
  return union_of(parts);
}

std::string pieces_of(const Nef3& set, DecomposeMethod method, Context& context) {
  const ConvexPieces pieces = decompose(set, {method, true}, context);
  std::string text = std::to_string(pieces.pieces.size()) + '\n';
  for (const Nef3& piece : pieces.pieces) text += text_of(piece);
  return text;
}

TEST(ConvexThreads, GiveTheSamePieces) {
  for (std::uint64_t seed = 0; seed < 4; ++seed) {
    Dice dice(seed);
    const Nef3 set = random_parts(dice);
    for (const DecomposeMethod method : {DecomposeMethod::Best, DecomposeMethod::Cuts}) {
      Context one;
      const std::string expected = pieces_of(set, method, one);
      for (unsigned threads = 2; threads <= kMostThreads; ++threads) {
        Context several = with_threads(threads);
        ASSERT_EQ(pieces_of(set, method, several), expected) << seed << ", " << threads;
      }
    }
  }
}

TEST(ConvexThreads, GiveTheSameSum) {
  for (std::uint64_t seed = 0; seed < 3; ++seed) {
    Dice dice(seed);
    const Nef3 a = solid(voxel_mesh(random_voxels(dice, {3, 2, 2}, 2)));
    const Nef3 b = solid(comb_block(1, 1));
    for (const bool is_open : {false, true}) {
      const Nef3 other = is_open ? b.interior() : b;
      const std::string expected = text_of(minkowski_sum(a, other));
      for (unsigned threads = 2; threads <= kMostThreads; ++threads) {
        Context several = with_threads(threads);
        ASSERT_EQ(text_of(minkowski_sum(a, other, several)), expected) << seed << ", " << threads;
      }
    }
  }
}

TEST(ConvexThreads, ObeyLimitsAndStops) {
  Dice dice(1);
  const Nef3 set = random_parts(dice), block = solid(comb_block(2, 2));
  for (unsigned threads = 1; threads <= kMostThreads; ++threads) {
    Limits limits;
    limits.max_memory_bytes = 20'000;
    std::stop_source stop;
    stop.request_stop();
    for (Context context :
         {with_threads(threads, limits), with_threads(threads, {}, stop.get_token())}) {
      EXPECT_THROW(decompose(set, {}, context), Error);
      EXPECT_THROW(minkowski_sum(block, block, context), Error);
    }
    Context memory = with_threads(threads, limits);
    EXPECT_THROW(minkowski_sum(block, block, memory), Error);
    EXPECT_NO_THROW(memory.charge_memory(limits.max_memory_bytes, "all of it was given back"));
  }
}

}  // namespace
}  // namespace plumb::testing::convex_threads_test
