// A tree of CPU time by phase and job, and the replay of this tree for a number of threads.
//
// Each thread has an open node. The time since the thread last read its clock belongs to this node;
// opening and closing a node reads the clock and moves on. Objects on the stack open and close the
// nodes, so the nodes are closed in reverse order, even if an exception is thrown. A node is
// complete before it moves into the steps of the node around it, so no pointer to an open node
// becomes invalid.
//
// The nodes of the jobs of a section are in one array that does not grow. Each job writes to its
// own node. The time that the thread that starts the jobs spends between them belongs to the node
// around the section, because starting threads is serial work.
// Tested by tests/base/work_log_test.cpp.

#include "plumb/base/internal/work_log.h"

#include <algorithm>
#include <cstdio>
#include <ctime>
#include <numeric>
#include <utility>

namespace plumb {
namespace {

thread_local WorkNode* open_node = nullptr;  // Null if the thread does not record.
thread_local double last_reading = 0;

double thread_seconds() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

/// Counts the time since the last reading for the open node, if there is one, and opens `next`.
void open(WorkNode* next) {
  const double now = thread_seconds();
  if (open_node != nullptr) open_node->seconds += now - last_reading;
  last_reading = now;
  open_node = next;
}

template <class Function>
double sum_of_steps(const WorkNode& node, const Function& function) {
  double sum = 0;
  for (const std::vector<WorkNode>& step : node.steps) sum += function(step);
  return sum;
}

double total_of(const std::vector<WorkNode>& step) {
  return std::accumulate(step.begin(), step.end(), 0.0, [](double sum, const WorkNode& node) {
    return sum + total_seconds(node);
  });
}

/// Returns the time when the last job of a section ends. Each job in turn is started by the thread
/// that becomes free first.
double end_of_section(const std::vector<WorkNode>& jobs, unsigned threads) {
  const auto workers = static_cast<unsigned>(std::min<std::size_t>(threads, jobs.size()));
  std::vector<double> free_at(workers, 0);
  for (const WorkNode& job : jobs) {
    *std::min_element(free_at.begin(), free_at.end()) += seconds_with(job, threads / workers);
  }
  return *std::max_element(free_at.begin(), free_at.end());
}

}  // namespace

double total_seconds(const WorkNode& node) { return node.seconds + sum_of_steps(node, total_of); }

double parallel_seconds(const WorkNode& node) {
  return sum_of_steps(node, [](const std::vector<WorkNode>& step) {
    return step.size() > 1 ? total_of(step) : parallel_seconds(step.front());
  });
}

double seconds_with(const WorkNode& node, unsigned threads) {
  return node.seconds + sum_of_steps(node, [threads](const std::vector<WorkNode>& step) {
           return end_of_section(step, threads);
         });
}

// ---------------------------------------------------------------- the table

namespace {

/// A phase with the phases within it.
struct PhaseSum {
  PhaseWork work;
  std::vector<PhaseSum> within;
};

void add(const WorkNode& node, PhaseWork& work) {
  work.seconds += total_seconds(node);
  work.parallel += parallel_seconds(node);
  for (std::size_t i = 0; i < work.predicted.size(); ++i) {
    work.predicted[i] += seconds_with(node, PhaseWork::kThreads[i]);
  }
}

PhaseSum& phase_within(PhaseSum& sum, std::string_view name) {
  const auto known = std::find_if(sum.within.begin(), sum.within.end(),
                                  [&](const PhaseSum& phase) { return phase.work.phase == name; });
  if (known != sum.within.end()) return *known;
  PhaseSum& added = sum.within.emplace_back();
  added.work.phase = name;
  added.work.depth = sum.work.depth + 1;
  return added;
}

/// Adds the phases within a node. Jobs are not phases. The phases within a job belong to the phase
/// around the job.
void add_phases(const WorkNode& node, PhaseSum& sum) {
  for (const std::vector<WorkNode>& step : node.steps) {
    for (const WorkNode& part : step) {
      if (part.phase.empty()) {
        add_phases(part, sum);
      } else {
        PhaseSum& phase = phase_within(sum, part.phase);
        add(part, phase.work);
        add_phases(part, phase);
      }
    }
  }
}

void list(PhaseSum& sum, std::vector<PhaseWork>& rows) {
  rows.push_back(std::move(sum.work));
  for (PhaseSum& phase : sum.within) list(phase, rows);
}

/// Returns part / whole, or `otherwise` if the whole is too short for the clock.
double ratio(double part, double whole, double otherwise) {
  return whole > 0 ? part / whole : otherwise;
}

}  // namespace

std::vector<PhaseWork> phases_of(const WorkNode& node, std::string whole) {
  PhaseSum sum;
  sum.work.phase = std::move(whole);
  add(node, sum.work);
  add_phases(node, sum);
  std::vector<PhaseWork> rows;
  list(sum, rows);
  return rows;
}

std::vector<std::string> phase_table(const std::vector<PhaseWork>& rows) {
  std::array<char, 128> line{};
  std::vector<std::string> lines;
  const auto add_line = [&](const auto&... values) {
    std::snprintf(line.data(), line.size(), values...);
    lines.emplace_back(line.data());
  };
  add_line("%-34s %9s %9s  %6s %6s %6s", "phase", "CPU s", "parallel", "x2", "x8", "x16");
  for (const PhaseWork& row : rows) {
    const std::string name = std::string(2 * row.depth, ' ') + row.phase;
    std::array<double, PhaseWork::kThreads.size()> gain{};
    for (std::size_t i = 0; i < gain.size(); ++i) {
      gain[i] = ratio(row.seconds, row.predicted[i], 1);
    }
    add_line("%-34.34s %9.4f %7.0f %%  %6.2f %6.2f %6.2f", name.c_str(), row.seconds,
             100 * ratio(row.parallel, row.seconds, 0), gain[0], gain[1], gain[2]);
  }
  return lines;
}

// ---------------------------------------------------------------- recording

WorkLog::WorkLog() { open(&root_); }

WorkLog::~WorkLog() { open_node = nullptr; }

WorkNode WorkLog::finish() {
  open(nullptr);
  return std::move(root_);
}

void WorkPhase::begin() {
  if (open_node == nullptr) return;
  around_ = open_node;
  open(&node_);
}

void WorkPhase::end() {
  if (around_ == nullptr) return;
  open(around_);
  around_->steps.emplace_back().push_back(std::move(node_));
}

void WorkPhase::next(std::string_view name) {
  if (around_ == nullptr) return;
  end();
  node_ = {name, 0, {}};
  begin();
}

WorkSection::WorkSection(std::size_t jobs) : around_(open_node) {
  if (around_ != nullptr) jobs_.resize(jobs);
}

WorkSection::~WorkSection() {
  if (around_ != nullptr && !jobs_.empty()) around_->steps.push_back(std::move(jobs_));
}

WorkSection::Job::Job(WorkSection& section, std::size_t job)
    : around_(open_node), is_recorded_(section.around_ != nullptr) {
  if (is_recorded_) open(&section.jobs_[job]);
}

WorkSection::Job::~Job() {
  if (is_recorded_) open(around_);
}

}  // namespace plumb
