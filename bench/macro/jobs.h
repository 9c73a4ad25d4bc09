// The capabilities that `capabilities` measures, room by room, and what their tables share.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "../complexity/cpu_time.h"
#include "../text_of.h"
#include "macro_report.h"
#include "plumb/plane/map.h"
#include "plumb/space/mesh_arrays.h"

namespace plumb::bench {

using Once = std::function<Timing()>;

struct Job {
  std::string capability;
  std::string input;
  bool is_real;  ///< a file of the corpus, not generated
  std::string unit;
  std::function<Once()> prepare;
};

void add_flat_jobs(std::vector<Job>& jobs, const MacroOptions& options);  ///< plane and sphere
void add_solid_jobs(std::vector<Job>& jobs, const MacroOptions& options);
void add_convex_jobs(std::vector<Job>& jobs, const MacroOptions& options);
void add_surface_jobs(std::vector<Job>& jobs, const MacroOptions& options);
void add_file_jobs(std::vector<Job>& jobs, const MacroOptions& options);
void add_picture_jobs(std::vector<Job>& jobs, const MacroOptions& options);

/// Times `work`; `size` tells the size of what it made.
template <class Work, class Size>
Once timed(Work work, Size size) {
  return [=] {
    const double start = cpu_seconds();
    const auto result = work();
    const double seconds = cpu_seconds() - start;
    return Timing{seconds, static_cast<double>(size(result))};
  };
}

/// The same, of a size that is known before.
template <class Work>
Once timed_of(std::size_t size, Work work) {
  return timed(std::move(work), [size](const auto&) { return size; });
}

/// Of what `write(std::ostream&)` writes, in bytes.
template <class Write>
Once writing(Write write) {
  return timed([write] { return text_of(write); },
               [](const std::string& text) { return text.size(); });
}

Map map_of(const std::string& file);
PolygonMesh mesh_of(const std::string& file);
/// A seventh of its width to the right, and less the other ways.
PolygonMesh shifted(const PolygonMesh& mesh);

}  // namespace plumb::bench
