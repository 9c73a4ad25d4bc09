// What a second and further threads bring, by capability that has them: wall time, one thread and
// several in turn.
//
//   threads [--most PERCENT] [--json FILE]
//
// 1, 2 and 4 threads, where there are as many cores. Ratio: time with one to time with so many,
// median, least and greatest of the rounds. Then, for each capability, the table of work_log.h:
// CPU time by phase with 2, 8 and 16 threads, and the ratio that cores of their own would give.
#include <fmt/core.h>

#include <algorithm>
#include <chrono>
#include <functional>
#include <stop_token>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "../complexity/cpu_time.h"
#include "../report/report.h"
#include "../text_of.h"
#include "generate/mesh_solid.h"
#include "generate/meshes.h"
#include "generate/voxel_mesh.h"
#include "macro_report.h"
#include "plumb/base/internal/parallel.h"
#include "plumb/base/internal/work_log.h"
#include "plumb/convex/minkowski.h"
#include "plumb/io/mesh_io.h"
#include "plumb/space/to_mesh.h"

namespace plumb::bench {
namespace {

using Work = std::function<void(Context&)>;

struct Job {
  std::string capability;
  std::string input;
  Work work;
};

double wall_seconds(const Work& work, unsigned threads) {
  Context context(Limits{}, std::stop_token{}, ProgressCallback{}, threads);
  const auto start = std::chrono::steady_clock::now();
  work(context);
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

nlohmann::ordered_json compared(const Job& job, unsigned threads, int rounds) {
  std::vector<double> one, many, ratios;
  for (int i = 0; i < rounds; ++i) {
    one.push_back(wall_seconds(job.work, 1));
    many.push_back(wall_seconds(job.work, threads));
    ratios.push_back(one.back() / many.back());
  }
  const double least_one = std::ranges::min(one), least_many = std::ranges::min(many);
  const nlohmann::ordered_json ratio = spread(std::move(ratios));
  fmt::print("{:34} {:28} {} threads: {:.4f} s, one: {:.4f} s, ratio {}\n", job.capability,
             job.input, threads, least_many, least_one, spread_text(ratio));
  std::fflush(stdout);
  return {{"capability", job.capability}, {"input", job.input},
          {"threads", threads},           {"one", least_one},
          {"many", least_many},           {"ratio", ratio}};
}

/// Prints the CPU time of a job by phase, and the ratio to the CPU time with one thread that so
/// many cores give.
void print_phases(const Job& job) {
  const auto recorded = [&](unsigned threads) {
    Context context(Limits{}, std::stop_token{}, ProgressCallback{}, threads);
    WorkLog log;
    job.work(context);
    return log.finish();
  };
  const double one = total_seconds(recorded(1));
  for (const unsigned threads : PhaseWork::kThreads) {
    const WorkNode work = recorded(threads);
    fmt::print("\n{}, {} threads: predicted ratio {:.2f}\n", job.capability, threads,
               one / seconds_with(work, threads));
    for (const std::string& line : phase_table(phases_of(work, job.input))) {
      fmt::print("{}\n", line);
    }
  }
}

void add_jobs(std::vector<Job>& jobs, const std::string& input, const PolygonMesh& a,
              const PolygonMesh& b) {
  const std::vector<PolygonMesh> meshes{a, b};
  jobs.push_back({"two meshes become sets", input, [meshes](Context& context) {
                    static_cast<void>(
                        Nef3::from_meshes(meshes, {.rule = WindingRule::Positive}, context));
                  }});
  const std::vector<Nef3> sets{testing::solid(a), testing::solid(b)};
  jobs.push_back({"union of two sets", input, [sets](Context& context) {
                    static_cast<void>(boolean_op(sets[0], sets[1], kUnion, context));
                  }});
  jobs.push_back({"union, from meshes to triangles", input, [meshes](Context& context) {
                    std::vector<Nef3> both =
                        Nef3::from_meshes(meshes, {.rule = WindingRule::Positive}, context);
                    const Nef3 set =
                        boolean_op(std::move(both[0]), std::move(both[1]), kUnion, context);
                    static_cast<void>(mesh_of_complex(
                        set.complex(), {MeshFaces::Triangles, false, false}, context));
                  }});
}

/// Every set meets the next ones.
void add_jobs_of_many(std::vector<Job>& jobs, std::size_t count, int depth) {
  std::vector<Nef3> sets;
  for (std::size_t i = 0; i < count; ++i) {
    const double x = 0.07 * static_cast<double>(i);
    sets.push_back(testing::solid(testing::icosphere_mesh(depth, 1, {x, x / 3, x / 7})));
  }
  const std::string input = fmt::format("{} icospheres of 20 * 4^{}", count, depth);
  jobs.push_back({"union of many sets", input,
                  [sets](Context& context) { static_cast<void>(union_of(sets, context)); }});
  jobs.push_back({"intersection of many sets", input,
                  [sets](Context& context) { static_cast<void>(intersection_of(sets, context)); }});
}

/// Two operands, each read by a job of its own, as the program does.
void add_reading(std::vector<Job>& jobs, const std::string& input, const PolygonMesh& mesh) {
  const std::string text =
      text_of([&](std::ostream& out) { write_mesh(out, mesh, MeshFormat::Off); });
  jobs.push_back({"two files become meshes", input, [text](Context& context) {
                    run_jobs(context, 2, [&](std::size_t, Context& own) {
                      static_cast<void>(read_mesh(text, MeshFormat::Off, {}, own));
                    });
                  }});
}

void add_sum(std::vector<Job>& jobs, int teeth) {
  const Nef3 set = testing::solid(testing::comb_block(teeth, teeth));
  jobs.push_back(
      {"Minkowski sum", fmt::format("two blocks with {} + {} notches", teeth, teeth),
       [set](Context& context) { static_cast<void>(minkowski_sum(set, set, context)); }});
}

int run(const MacroOptions& options, nlohmann::ordered_json& rows) {
  const bool is_short = options.most < 50;
  const int depth = is_short ? 2 : 6;
  std::vector<Job> jobs;
  add_jobs(jobs, fmt::format("icospheres of 20 * 4^{}", depth),
           testing::icosphere_mesh(depth, 1, {0, 0, 0}),
           testing::icosphere_mesh(depth, 1, {0.3, 0.2, 0.1}));
  add_reading(jobs, fmt::format("icosphere of 20 * 4^{}", depth),
              testing::icosphere_mesh(depth, 1, {0, 0, 0}));
  add_jobs_of_many(jobs, is_short ? 4 : 32, is_short ? 1 : 3);
  add_sum(jobs, is_short ? 1 : 4);
  const unsigned cores = std::max(1U, std::thread::hardware_concurrency());
  for (const Job& job : jobs) {
    for (const unsigned threads : {2U, 4U}) {
      if (threads <= cores || (is_short && threads == 2)) {
        rows.push_back(compared(job, threads, is_short ? 1 : 5));
      }
    }
  }
  for (const Job& job : jobs) print_phases(job);
  return 0;
}

}  // namespace
}  // namespace plumb::bench

int main(int argc, char** argv) {
  plumb::bench::keep_freed_memory();
  return plumb::bench::macro_main("threads", "Threads", argc, argv, plumb::bench::run);
}
