// The work of phases and jobs is counted once, and its replay obeys the bounds of any schedule.

#include "plumb/base/internal/work_log.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <ctime>
#include <random>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "plumb/base/context.h"
#include "plumb/base/internal/parallel.h"

namespace plumb::work_log_test {
namespace {

double cpu_seconds() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

/// Computes for so many seconds of CPU time.
void compute_for(double seconds) {
  const double end = cpu_seconds() + seconds;
  while (cpu_seconds() < end) {
  }
}

WorkNode job(double seconds) { return {{}, seconds, {}}; }

WorkNode phase(std::string_view name, double seconds,
               std::vector<std::vector<WorkNode>> steps = {}) {
  return {name, seconds, std::move(steps)};
}

WorkNode random_node(std::mt19937& random, int depth) {
  WorkNode node = job(static_cast<double>(random() % 100) / 64);
  for (auto steps = depth > 0 ? random() % 4 : 0; steps > 0; --steps) {
    std::vector<WorkNode>& step = node.steps.emplace_back();
    for (auto jobs = 1 + random() % 6; jobs > 0; --jobs) {
      step.push_back(random_node(random, depth - 1));
    }
    if (step.size() == 1) step.front().phase = "phase";
  }
  return node;
}

/// The longest chain of work that no number of threads can shorten.
double longest_chain(const WorkNode& node) {
  double length = node.seconds;
  for (const auto& step : node.steps) {
    double longest = 0;
    for (const WorkNode& part : step) longest = std::max(longest, longest_chain(part));
    length += longest;
  }
  return length;
}

// All times are multiples of 1/64 and small, so sums of doubles are exact.

TEST(WorkLog, PredictionsStayWithinTheBoundsOfEverySchedule) {
  for (unsigned seed = 0; seed < 200; ++seed) {
    std::mt19937 random(seed);
    const WorkNode node = random_node(random, 3);
    const double total = total_seconds(node), parallel = parallel_seconds(node);
    EXPECT_GE(parallel, 0);
    EXPECT_LE(parallel, total);
    EXPECT_EQ(seconds_with(node, 1), total);
    for (const unsigned threads : {2U, 3U, 8U, 16U}) {
      const double predicted = seconds_with(node, threads);
      EXPECT_GE(predicted, longest_chain(node));
      EXPECT_GE(predicted * threads, total);
      EXPECT_LE(predicted, total);
      EXPECT_GE(predicted, total - parallel);
    }
    EXPECT_EQ(seconds_with(node, 1'000'000), longest_chain(node));
  }
}

TEST(WorkLog, JobsBeginInTheirOrder) {
  // With two threads: 3 | 1, then 1 after the first 1, then 2 after both.
  const WorkNode node = phase("", 0.5, {{job(3), job(1), job(1), job(2)}});
  EXPECT_EQ(seconds_with(node, 2), 0.5 + 4);
  EXPECT_EQ(seconds_with(node, 4), 0.5 + 3);
}

TEST(WorkLog, JobsUseTheThreadsThatAreLeftOver) {
  const WorkNode inner = phase("", 0, {{job(1), job(1), job(1), job(1)}});
  const WorkNode node = phase("", 0, {{inner, inner}});
  EXPECT_EQ(seconds_with(node, 2), 4);
  EXPECT_EQ(seconds_with(node, 4), 2);
  EXPECT_EQ(seconds_with(node, 8), 1);
}

TEST(WorkLog, RowsAddUpWhatBelongsToOnePhase) {
  const WorkNode read = phase("read", 1, {{phase("parse", 2)}});
  const WorkNode sum = phase("sum", 3, {{job(4), phase("", 5, {{phase("part", 1)}})}});
  const WorkNode node = phase("", 0.5, {{phase("", 0, {{read}}), phase("", 0, {{read}})}, {sum}});
  const std::vector<PhaseWork> rows = phases_of(node, "all");
  ASSERT_EQ(rows.size(), 5U);
  const std::vector<std::string> names{"all", "read", "parse", "sum", "part"};
  const std::vector<std::size_t> depths{0, 1, 2, 1, 2};
  const std::vector<double> seconds{19.5, 6, 4, 13, 1}, parallel{16, 0, 0, 10, 0},
      with_two{12.5, 6, 4, 9, 1};
  for (std::size_t i = 0; i < rows.size(); ++i) {
    EXPECT_EQ(rows[i].phase, names[i]);
    EXPECT_EQ(rows[i].depth, depths[i]) << names[i];
    EXPECT_EQ(rows[i].seconds, seconds[i]) << names[i];
    EXPECT_EQ(rows[i].parallel, parallel[i]) << names[i];
    EXPECT_EQ(rows[i].predicted[0], with_two[i]) << names[i];
  }
  const std::vector<std::string> table = phase_table(rows);
  ASSERT_EQ(table.size(), 1 + rows.size());
  for (const std::string& line : table) EXPECT_EQ(line.size(), table[0].size()) << line;
  EXPECT_NE(table[1].find("82 %    1.56"), std::string::npos) << table[1];
}

TEST(WorkLog, RecordsPhasesAndJobsOfAllThreads) {
  constexpr double kUnit = 0.004;
  for (const unsigned threads : {2U, 4U}) {
    Context context({}, {}, {}, threads);
    const double before = cpu_seconds();
    WorkLog log;
    {
      WorkPhase phase("serial");
      compute_for(kUnit);
      phase.next("parallel");
      run_jobs(context, 4, [&](std::size_t i, Context&) {
        const WorkPhase inner("job");
        compute_for(i == 0 ? 2 * kUnit : kUnit);
      });
    }
    const WorkNode node = log.finish();
    const double own = cpu_seconds() - before;
    ASSERT_EQ(node.steps.size(), 2U);
    const WorkNode& serial = node.steps[0][0];
    const WorkNode& parallel = node.steps[1][0];
    EXPECT_EQ(serial.phase, "serial");
    EXPECT_GE(serial.seconds, kUnit);
    EXPECT_EQ(parallel.phase, "parallel");
    ASSERT_EQ(parallel.steps.size(), 1U);
    ASSERT_EQ(parallel.steps[0].size(), 4U);
    for (const WorkNode& one : parallel.steps[0]) {
      EXPECT_GE(total_seconds(one), kUnit);
      ASSERT_EQ(one.steps.size(), 1U);
      EXPECT_EQ(one.steps[0][0].phase, "job");
    }
    EXPECT_GE(total_seconds(node), 6 * kUnit);
    EXPECT_GE(parallel_seconds(node), 5 * kUnit);
    EXPECT_LE(total_seconds(node) - parallel_seconds(node), own) << "serial work is the caller's";
  }
}

TEST(WorkLog, OneThreadHasNoParallelShare) {
  Context context;
  WorkLog log;
  run_jobs(context, 4, [](std::size_t, Context&) { compute_for(0.001); });
  const WorkNode node = log.finish();
  EXPECT_GE(total_seconds(node), 0.004);
  EXPECT_EQ(parallel_seconds(node), 0);
}

TEST(WorkLog, AFailedPhaseIsClosed) {
  WorkLog log;
  const auto fail = [] {
    const WorkPhase outer("outer");
    const WorkPhase inner("inner");
    throw std::runtime_error("failed");
  };
  EXPECT_THROW(fail(), std::runtime_error);
  { const WorkPhase after("after"); }
  const WorkNode node = log.finish();
  ASSERT_EQ(node.steps.size(), 2U);
  EXPECT_EQ(node.steps[0][0].phase, "outer");
  EXPECT_EQ(node.steps[1][0].phase, "after");
}

TEST(WorkLog, NothingIsRecordedWithoutALog) {
  { const WorkPhase before("before"); }
  WorkLog log;
  const WorkNode node = log.finish();
  EXPECT_TRUE(node.steps.empty());
  { const WorkPhase after("after"); }
}

}  // namespace
}  // namespace plumb::work_log_test
