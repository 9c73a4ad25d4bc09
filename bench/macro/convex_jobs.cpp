// Capabilities of convexity.
#include <fmt/core.h>

#include "generate/mesh_solid.h"
#include "generate/meshes.h"
#include "generate/voxel_mesh.h"
#include "jobs.h"
#include "plumb/convex/convexity.h"
#include "plumb/convex/decompose.h"
#include "plumb/convex/minkowski.h"

namespace plumb::bench {
namespace {

const std::string kBunny = "corpus/solids/bunny.off";
const std::string kBlock = "corpus/solids/l-block.off";

Once convexity_test(const PolygonMesh& mesh) {
  return timed_of(mesh.face_count(), [mesh] {
    Context context;
    return is_convex_mesh(mesh, context);
  });
}

/// Reflex edges and faces that fail.
Once evidence(const PolygonMesh& mesh) {
  return timed_of(mesh.face_count(), [mesh] {
    Context context;
    return convexity_of_mesh(mesh, context);
  });
}

Once decomposition_of(const PolygonMesh& mesh) {
  return timed(
      [set = testing::solid(mesh)] {
        Context context;
        return decompose(set, {}, context);
      },
      [](const ConvexPieces& result) { return result.pieces.size(); });
}

Once sum_of(const PolygonMesh& mesh) {
  return timed(
      [set = testing::solid(mesh)] {
        Context context;
        return minkowski_sum(set, set, context);
      },
      [](const Nef3& sum) { return sum.counts().facets; });
}

}  // namespace

void add_convex_jobs(std::vector<Job>& jobs, const MacroOptions& options) {
  const int depth = options.most < 50 ? 3 : 6;
  const auto sphere = [depth] { return testing::icosphere_mesh(depth, 1, {0, 0, 0}); };
  const std::string icosphere = fmt::format("icosphere of 20 * 4^{}", depth);
  jobs.push_back(
      {"is it convex?", kBunny, true, "faces", [] { return convexity_test(mesh_of(kBunny)); }});
  jobs.push_back(
      {"is it convex?", icosphere, false, "faces", [=] { return convexity_test(sphere()); }});
  jobs.push_back(
      {"where is it not convex?", kBunny, true, "faces", [] { return evidence(mesh_of(kBunny)); }});
  const auto teeth = static_cast<int>(options.size(32, 2));
  const std::string comb = fmt::format("block with {} + {} notches", teeth, teeth);
  jobs.push_back({"where is it not convex?", comb, false, "faces",
                  [teeth] { return evidence(testing::comb_block(teeth, teeth)); }});
  jobs.push_back(
      {"convex pieces", kBlock, true, "pieces", [] { return decomposition_of(mesh_of(kBlock)); }});
  jobs.push_back({"convex pieces", comb, false, "pieces",
                  [teeth] { return decomposition_of(testing::comb_block(teeth, teeth)); }});
  jobs.push_back({"Minkowski sum", "two of " + kBlock, true, "facets",
                  [] { return sum_of(mesh_of(kBlock)); }});
  const auto few = static_cast<int>(options.size(4, 1));
  jobs.push_back({"Minkowski sum", fmt::format("two blocks with {} + {} notches", few, few), false,
                  "facets", [few] { return sum_of(testing::comb_block(few, few)); }});
}

}  // namespace plumb::bench
