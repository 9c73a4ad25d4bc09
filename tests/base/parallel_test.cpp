// Jobs on several threads do what a loop does: all of them, with the error of the first that fails.

#include "plumb/base/internal/parallel.h"

#include <gtest/gtest.h>

#include <array>
#include <atomic>
#include <chrono>
#include <cstddef>
#include <numeric>
#include <stop_token>
#include <string_view>
#include <thread>
#include <vector>

#include "plumb/base/internal/restarted_jobs.h"
#include "plumb/predicates/error.h"

namespace plumb::parallel_test {
namespace {

Context with_threads(unsigned threads, Limits limits = {}) {
  return Context(limits, {}, {}, threads);
}

/// What checkpoints throw once the job is stopped; fails when it never is.
void wait_for_stop(Context& context) {
  const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(20);
  while (std::chrono::steady_clock::now() < end) {
    context.checkpoint("waiting", 0, 1);
    std::this_thread::yield();
  }
  ADD_FAILURE() << "a job after one that failed was not stopped";
}

TEST(Parallel, EveryJobIsDoneOnce) {
  for (const unsigned threads : {1U, 2U, 3U, 8U}) {
    for (const std::size_t jobs : {0U, 1U, 2U, 1000U}) {
      Context context = with_threads(threads);
      std::vector<int> done(jobs, 0);
      run_jobs(context, jobs, [&](std::size_t i, Context&) { ++done[i]; });
      EXPECT_EQ(std::vector<int>(jobs, 1), done) << threads << " threads, " << jobs << " jobs";
    }
  }
}

TEST(Parallel, TheErrorIsThatOfTheFirstJobThatFails) {
  for (const unsigned threads : {1U, 2U, 4U}) {
    Context context = with_threads(threads);
    std::vector<int> done(40, 0);
    try {
      run_jobs(context, 40, [&](std::size_t i, Context& own) {
        if (i == 7) {
          std::this_thread::sleep_for(std::chrono::milliseconds(5));
          throw Error(ErrorCode::BadArgument, "job 7");
        }
        if (i == 9) throw Error(ErrorCode::BadArgument, "job 9");
        if (i > 9) wait_for_stop(own);
        done[i] = 1;
      });
      FAIL() << "nothing was thrown";
    } catch (const Error& error) {
      EXPECT_EQ("job 7", error.message());
    }
    EXPECT_EQ(7, std::accumulate(done.begin(), done.begin() + 7, 0)) << "jobs before are finished";
  }
}

TEST(Parallel, JobsWithinStoppedJobsStop) {
  Context context = with_threads(4);
  EXPECT_THROW(run_jobs(context, 2,
                        [&](std::size_t i, Context& own) {
                          if (i == 0) throw Error(ErrorCode::BadArgument, "first");
                          run_jobs(own, 2,
                                   [](std::size_t, Context& inner) { wait_for_stop(inner); });
                        }),
               Error);
}

TEST(Parallel, MemoryIsChargedTogether) {
  Limits limits;
  limits.max_memory_bytes = 1000;
  Context context = with_threads(2, limits);
  std::atomic<int> tried = 0;
  // Each job holds 600 of 1000 bytes until the other asked too: one of them must be refused.
  EXPECT_THROW(run_jobs(context, 2,
                        [&](std::size_t, Context& own) {
                          MemoryCharge charge(own);
                          try {
                            charge.add(600, "job");
                          } catch (const Error&) {
                            ++tried;
                            throw;
                          }
                          ++tried;
                          while (tried < 2) std::this_thread::yield();
                        }),
               Error);
  EXPECT_NO_THROW(context.charge_memory(1000, "all of it was given back"));
}

TEST(Parallel, RefusedMemoryIsReportedWithFigures) {
  Context context(Limits{.max_memory_bytes = 1000});
  context.charge_memory(300, "the first part");
  try {
    context.charge_memory(701, "the second part");
    ADD_FAILURE() << "nothing was thrown";
  } catch (const Error& error) {
    const std::string message = error.what();
    for (const char* const part : {"the second part", " 701 ", " 1000 ", " 700"}) {
      EXPECT_NE(message.find(part), std::string::npos) << message;
    }
  }
}

/// Jobs that each need nearly all of the memory, and that all hold some at the same time.
TEST(RestartedJobs, NeedNoMoreMemoryThanALoop) {
  for (const unsigned threads : {1U, 2U, 4U}) {
    Context context = with_threads(threads, {.max_memory_bytes = 100});
    std::atomic<unsigned> begun = 0;
    std::vector<int> done(4, 0);
    run_restarted_jobs(context, 4, [&](std::size_t i, Context& own) {
      MemoryCharge memory(own);
      memory.add(20, "some");
      for (++begun; begun < threads;) std::this_thread::yield();
      memory.add(75, "the rest");
      ++done[i];
    });
    EXPECT_EQ(std::vector<int>(4, 1), done) << threads;
    context.charge_memory(100, "all is released");
  }
}

TEST(RestartedJobs, FailAsALoopFails) {
  for (const unsigned threads : {1U, 2U, 4U}) {
    Context context = with_threads(threads, {.max_memory_bytes = 100});
    std::vector<int> done(8, 0);
    try {
      run_restarted_jobs(context, 8, [&](std::size_t i, Context& own) {
        if (i == 3) own.charge_memory(101, "job 3");
        if (i == 4) throw Error(ErrorCode::BadArgument, "job 4");
        done[i] = 1;
      });
      ADD_FAILURE() << "no error, " << threads << " threads";
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ErrorCode::ResourceLimit);
      EXPECT_NE(std::string_view(error.what()).find("job 3"), std::string_view::npos);
    }
    for (const std::size_t i : {0U, 1U, 2U}) EXPECT_EQ(done[i], 1);
    EXPECT_EQ(done[3] + done[4], 0);
  }
}

TEST(Parallel, AStopOfTheOperationStopsItsJobs) {
  std::stop_source stop;
  Context context(Limits(), stop.get_token(), {}, 2);
  try {
    run_jobs(context, 3, [&](std::size_t, Context& own) {
      stop.request_stop();
      wait_for_stop(own);
    });
    FAIL() << "nothing was thrown";
  } catch (const Error& error) {
    EXPECT_EQ(ErrorCode::Cancelled, error.code());
  }
}

TEST(Parallel, ThreadsAreSharedAmongFewJobs) {
  Context context = with_threads(6);
  std::array<unsigned, 2> threads{};
  run_jobs(context, 2, [&](std::size_t i, Context& own) { threads[i] = own.threads(); });
  EXPECT_EQ((std::array<unsigned, 2>{3, 3}), threads);
}

/// At most 20 reports a second, but the end of a phase is told.
TEST(Progress, IsNotToldTooOften) {
  std::size_t told = 0;
  Context context({}, {}, [&](std::string_view, std::uint64_t, std::uint64_t) { ++told; });
  const auto start = std::chrono::steady_clock::now();
  for (int i = 0; i < 10000; ++i) context.checkpoint("of unknown length", 0, 0);
  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
  EXPECT_LE(static_cast<double>(told), 1 + 20 * taken.count());
  told = 0;
  context.checkpoint("done", 7, 7);
  EXPECT_EQ(told, 1U);
}

}  // namespace
}  // namespace plumb::parallel_test
