// The same bytes and the same errors, whatever the number of threads.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <sstream>
#include <stop_token>
#include <string>
#include <utility>
#include <vector>

#include "generate/meshes.h"
#include "generate/voxel_mesh.h"
#include "plumb/io/nef3_writer.h"
#include "plumb/predicates/error.h"
#include "plumb/space/nef3.h"
#include "plumb/space/space_audit.h"
#include "plumb/space/to_mesh.h"
#include "plumb/testing/dice.h"

namespace plumb::testing::threads_test {
namespace {

constexpr unsigned kMostThreads = 4;
constexpr std::array<MarkFunction, 4> kFunctions{kUnion, kIntersection, kDifference,
                                                 kSymmetricDifference};

Context with_threads(unsigned threads, Limits limits = {}, std::stop_token stop = {}) {
  return Context(limits, std::move(stop), {}, threads);
}

// ---------------------------------------------------------------- scenes

/// From a dozen faces to some thousands: on a coarse grid, so that faces of both lie in one plane,
/// or not at all.
PolygonMesh random_solid(Dice& dice) {
  const auto coordinate = [&] { return static_cast<double>(dice.between(-4, 4)) / 8; };
  const double x = coordinate();
  const double y = coordinate();
  const double z = coordinate();
  const Point3 at{x, y, z};
  switch (dice.below(5)) {
    case 0:
      return box_mesh(at, {x + 1, y + 0.75, z + 1.5});
    case 1:
      return moved(voxel_mesh(random_voxels(dice, {14, 12, 10}, 4)), {8 * x, 8 * y, 8 * z});
    case 2:  // crosses itself
      return joined(icosphere_mesh(3, 1, at), icosphere_mesh(3, 0.75, {z, x, y}));
    default:
      return icosphere_mesh(static_cast<int>(dice.between(2, 4)), 1, at);
  }
}

std::string text_of(const Nef3& set) {
  std::ostringstream out;
  write_nef3(out, set.complex());
  return std::move(out).str();
}

void write_mesh_of(const Nef3& set, const ToMeshOptions& options, Context& context,
                   std::ostream& out) {
  const MeshOfComplex made = mesh_of_complex(set.complex(), options, context);
  for (const Point3& p : made.mesh.points) out << p.x << ' ' << p.y << ' ' << p.z << '\n';
  for (const auto& [v, vertex] : made.rounded) out << v << ' ' << vertex.value() << '\n';
  for (std::size_t f = 0; f < made.mesh.face_count(); ++f) {
    for (const std::uint32_t v : made.mesh.face(f)) out << v << ' ';
    out << made.facet[f].value() << '\n';
  }
  out << made.report.dropped.total() << ' ' << made.report.closed.total() << ' '
      << made.report.filled.total() << '\n';
}

/// All that comes of two meshes: the sets, a Boolean, its triangles and polygons.
std::string outcome(const std::array<PolygonMesh, 2>& meshes, MarkFunction f, unsigned threads) {
  Context context = with_threads(threads);
  std::vector<Nef3> sets = Nef3::from_meshes(meshes, {.rule = WindingRule::NonZero}, context);
  std::ostringstream out;
  out << text_of(sets[0]) << text_of(sets[1]);
  const Nef3 both = boolean_op(std::move(sets[0]), std::move(sets[1]), f, context);
  EXPECT_FALSE(audit(both.complex(), AuditForm::Minimal));
  out << text_of(both) << std::hexfloat;
  for (const MeshFaces faces : {MeshFaces::Triangles, MeshFaces::PlanarPolygons}) {
    for (const bool splits : {false, true}) {
      write_mesh_of(both, {.faces = faces, .split_vertices = splits}, context, out);
    }
  }
  return std::move(out).str();
}

TEST(Threads, GiveTheSameBytes) {
  for (std::uint64_t seed = 0; seed < 12; ++seed) {
    Dice dice(seed);
    PolygonMesh a = random_solid(dice);
    PolygonMesh b = random_solid(dice);
    const std::array<PolygonMesh, 2> meshes{std::move(a), std::move(b)};
    const MarkFunction f = kFunctions[seed % kFunctions.size()];
    const std::string expected = outcome(meshes, f, 1);
    for (unsigned threads = 2; threads <= kMostThreads; ++threads) {
      ASSERT_EQ(outcome(meshes, f, threads), expected) << "seed " << seed << ", " << threads;
    }
  }
}

// So large that each step is divided into ranges for 16 threads, and crossing in many faces.
TEST(Threads, GiveTheSameBytesOfALargeUnion) {
  const std::array<PolygonMesh, 2> meshes{icosphere_mesh(5, 1, {}),
                                          icosphere_mesh(5, 1, {0.3, 0.2, 0.1})};
  const std::string expected = outcome(meshes, kUnion, 1);
  for (const unsigned threads : {2U, 16U}) {
    ASSERT_EQ(outcome(meshes, kUnion, threads), expected) << threads;
  }
}

// ---------------------------------------------------------------- errors

std::string error_of(const std::function<void()>& work) {
  try {
    work();
  } catch (const Error& e) {
    return e.what();
  }
  return "none";
}

TEST(Threads, GiveTheErrorOfTheFirstMesh) {
  PolygonMesh open = icosphere_mesh(3, 1, {});
  open.corners.resize(open.corners.size() - 3);
  open.face_begin.pop_back();
  PolygonMesh bad = icosphere_mesh(1, 1, {});
  bad.points[0].x = std::numeric_limits<double>::quiet_NaN();
  const PolygonMesh good = icosphere_mesh(2, 1, {});
  const std::vector<std::vector<PolygonMesh>> inputs{{open, bad}, {bad, open}, {good, open, bad}};
  for (const auto& meshes : inputs) {
    const auto error = [&](unsigned threads) {
      return error_of([&] {
        Context context = with_threads(threads);
        Nef3::from_meshes(meshes, {.rule = WindingRule::Positive}, context);
      });
    };
    const std::string expected = error(1);
    EXPECT_NE(expected, "none");
    for (unsigned threads = 2; threads <= kMostThreads; ++threads) {
      EXPECT_EQ(error(threads), expected);
    }
  }
}

TEST(Threads, ObeyLimitsAndStops) {
  const std::array<PolygonMesh, 2> meshes{icosphere_mesh(4, 1, {}),
                                          icosphere_mesh(4, 1, {0.5, 0.25, 0})};
  for (unsigned threads = 1; threads <= kMostThreads; ++threads) {
    Context plain = with_threads(threads);
    const std::vector<Nef3> sets =
        Nef3::from_meshes(meshes, {.rule = WindingRule::Positive}, plain);
    Limits limits;
    limits.max_memory_bytes = 100'000;
    std::stop_source stop;
    stop.request_stop();
    for (Context context :
         {with_threads(threads, limits), with_threads(threads, {}, stop.get_token())}) {
      EXPECT_THROW(Nef3::from_meshes(meshes, {.rule = WindingRule::Positive}, context), Error);
      EXPECT_THROW(boolean_op(sets[0], sets[1], kUnion, context), Error);
    }
    EXPECT_EQ(boolean_op(sets[0], sets[1], kUnion, plain), sets[0] + sets[1]);
  }
}

}  // namespace
}  // namespace plumb::testing::threads_test
