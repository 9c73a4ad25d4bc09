// Every capability on real and on generated inputs: CPU time and the largest resident set, a
// process for each. Exit status 1 when one of them fails.
//
//   capabilities [--most PERCENT] [--json FILE]     (from the root of the tree: corpus/)
#include <fmt/core.h>

#include <algorithm>
#include <exception>
#include <string>
#include <vector>

#include "generate/meshes.h"
#include "jobs.h"
#include "macro_report.h"
#include "plumb/io/map_io.h"
#include "plumb/io/mesh_io.h"

namespace plumb::bench {

Map map_of(const std::string& file) {
  Context context;
  return read_map_file(file, {}, context);
}

PolygonMesh mesh_of(const std::string& file) {
  Context context;
  return read_mesh_file(file, {}, {}, context).mesh;
}

PolygonMesh shifted(const PolygonMesh& mesh) {
  double low = mesh.points[0].x, high = low;
  for (const Point3& p : mesh.points) low = std::min(low, p.x), high = std::max(high, p.x);
  const double step = (high - low) / 7;
  return testing::moved(mesh, {step, step / 2, step / 3});
}

namespace {

/// False when it failed; the row says why.
bool measure(const Job& job, nlohmann::ordered_json& row) {
  row = {{"capability", job.capability},
         {"input", job.input},
         {"kind", job.is_real ? "real" : "generated"}};
  try {
    const Measured m = in_own_process(job.prepare);
    row.update(
        {{"size", m.size}, {"unit", job.unit}, {"seconds", m.seconds}, {"megabytes", m.megabytes}});
    if (!m.calls.empty()) row["calls"] = m.calls;
    fmt::print("{:36} {:44} {:9.0f} {:10} {:10.6f} s {:7.1f} MB\n", job.capability, job.input,
               m.size, job.unit, m.seconds, m.megabytes);
  } catch (const std::exception& error) {
    row["failure"] = error.what();
    fmt::print("{:36} {:44} FAILED: {}\n", job.capability, job.input, error.what());
  }
  std::fflush(stdout);
  return !row.contains("failure");
}

int run(const MacroOptions& options, nlohmann::ordered_json& rows) {
  std::vector<Job> jobs;
  add_flat_jobs(jobs, options);
  add_solid_jobs(jobs, options);
  add_convex_jobs(jobs, options);
  add_surface_jobs(jobs, options);
  add_picture_jobs(jobs, options);
  add_file_jobs(jobs, options);
  int status = 0;
  for (const Job& job : jobs) {
    if (!measure(job, rows.emplace_back())) status = 1;
  }
  return status;
}

}  // namespace
}  // namespace plumb::bench

int main(int argc, char** argv) {
  return plumb::bench::macro_main("capabilities", "Capabilities on real and generated inputs", argc,
                                  argv, plumb::bench::run);
}
