// WorkLog: the CPU time of an operation by phase, and what several threads can save.
//
// While a WorkLog exists, its thread and the jobs that this thread starts (parallel.h) record their
// CPU time in a tree. Each node of the tree is a phase, a job, or the whole. A node has CPU seconds
// of its own, and a list of steps that ran one after the other. A step is one phase, or a section
// of jobs that may run at the same time.
//
// The function seconds_with() computes the time of this tree for any number of threads, with the
// rules of run_jobs(). Jobs begin in the order of their indices. If there are more threads than
// jobs, a job may use the remaining threads. CPU time does not depend on what other programs do, so
// the prediction holds on a busy machine, and also for more threads than the machine has cores. The
// prediction leaves out what threads lose by sharing caches and memory channels.
//
// Cost: without a log, one test for each phase and each call of run_jobs(). With a log, two
// readings of the clock for each phase and each job. Tested by tests/base/work_log_test.cpp.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#pragma GCC visibility push(default)
namespace plumb {

/// The work of one phase, of one job or of a whole operation.
struct WorkNode {
  std::string_view phase;  ///< The name of the phase; empty for a job and for the whole.
  double seconds = 0;      ///< CPU time outside of the steps.
  /// The steps in their order. A step of one node is serial: a phase, or a job alone. A step of
  /// several nodes is a section of jobs.
  std::vector<std::vector<WorkNode>> steps;
};

/// Returns the CPU time of the node with all its steps.
double total_seconds(const WorkNode& node);

/// Returns the part of total_seconds() that was spent in sections of jobs.
double parallel_seconds(const WorkNode& node);

/// Returns the time that the node takes with so many threads (>= 1), each on a core of its own.
/// With one thread, this is total_seconds(). It is never less than total_seconds() / threads.
double seconds_with(const WorkNode& node, unsigned threads);

/// The work of one phase: the sums over all its runs that lie within the same outer phases.
struct PhaseWork {
  static constexpr std::array<unsigned, 3> kThreads{2, 8, 16};

  std::string phase;
  std::size_t depth = 0;  ///< The number of phases that contain it.
  double seconds = 0;     ///< The sum of total_seconds().
  double parallel = 0;    ///< The sum of parallel_seconds().
  /// seconds_with() for kThreads, where all threads work for this phase alone.
  std::array<double, kThreads.size()> predicted{};
};

/// Returns the whole (depth 0, named `whole`), followed by its phases in the order in which they
/// first occur; the phases within a phase follow it.
std::vector<PhaseWork> phases_of(const WorkNode& node, std::string whole);

/// Returns a table as lines of text. The first line is a header. Each further line has the CPU
/// seconds of a row, its parallel share in percent, and the predicted ratios of time for kThreads.
std::vector<std::string> phase_table(const std::vector<PhaseWork>& rows);

/// Records the work of the calling thread from construction to finish() or destruction. At most one
/// log of a thread exists at a time.
class WorkLog {
 public:
  WorkLog();
  ~WorkLog();
  WorkLog(const WorkLog&) = delete;
  WorkLog& operator=(const WorkLog&) = delete;

  /// Ends the recording and returns the work. Requires that no phase and no job is open.
  WorkNode finish();

 private:
  WorkNode root_;
};

/// Records its lifetime as a phase, if the calling thread records. Requires that the name outlives
/// the log.
class WorkPhase {
 public:
  explicit WorkPhase(std::string_view name) : node_{name, 0, {}} { begin(); }
  ~WorkPhase() { end(); }
  WorkPhase(const WorkPhase&) = delete;
  WorkPhase& operator=(const WorkPhase&) = delete;

  /// Ends this phase and begins the next one in its place.
  void next(std::string_view name);

 private:
  void begin();
  void end();

  WorkNode node_;
  WorkNode* around_ = nullptr;  // Null if nothing is recorded.
};

/// Records a section of jobs, if the thread that constructs it records.
class WorkSection {
 public:
  explicit WorkSection(std::size_t jobs);
  /// Adds the section to the node that is open. Requires that all jobs have ended.
  ~WorkSection();
  WorkSection(const WorkSection&) = delete;
  WorkSection& operator=(const WorkSection&) = delete;

  /// Records its lifetime as a job of the section, on any thread.
  class Job {
   public:
    Job(WorkSection& section, std::size_t job);
    ~Job();
    Job(const Job&) = delete;
    Job& operator=(const Job&) = delete;

   private:
    WorkNode* around_ = nullptr;  // The node that was open on this thread, possibly none.
    bool is_recorded_;
  };

 private:
  WorkNode* around_;
  std::vector<WorkNode> jobs_;
};

}  // namespace plumb
#pragma GCC visibility pop
