#include "plumb/cli/session/process.h"

#include <fcntl.h>
#include <sys/stat.h>

#ifdef _WIN32
#include <windows.h>
// This header requires windows.h.
#include <io.h>
#include <psapi.h>
#else
#include <sys/resource.h>
#ifdef __linux__
#include <sys/syscall.h>
#endif
#include <sys/time.h>
#include <unistd.h>
#endif
#if defined(__GLIBC__)
#include <malloc.h>
#endif

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdio>
#include <limits>

namespace plumb::cli::process {

namespace {

#ifndef _WIN32
// The group of the running EndsWithProcess; 0 if there is none.
std::atomic<pid_t> group_to_end = 0;
static_assert(std::atomic<pid_t>::is_always_lock_free);
#endif

/// Ends the group. The function is async-signal-safe.
void end_group() {
#ifndef _WIN32
  const pid_t group = group_to_end;
  if (group != 0) ::kill(-group, SIGKILL);
#endif
}

}  // namespace

/// On Linux, the system call is made directly. In _exit(), sanitizers search for leaks and use
/// locks that the interrupted thread may hold.
void end_now(int code) {
  end_group();
#ifdef __linux__
  ::syscall(SYS_exit_group, code);
#endif
  ::_exit(code);
}

bool is_regular_file(int descriptor) {
  struct stat status {};
  return ::fstat(descriptor, &status) == 0 && S_ISREG(status.st_mode);
}

namespace {

// Sanitizers map memory for their own use, and end the process if the system refuses it. They also
// use locks, and a handler must not wait for a lock.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
[[maybe_unused]] constexpr bool kIsSanitized = true;
#elif defined(__has_feature)
[[maybe_unused]] constexpr bool kIsSanitized =
    __has_feature(address_sanitizer) || __has_feature(thread_sanitizer);
#else
[[maybe_unused]] constexpr bool kIsSanitized = false;
#endif

}  // namespace

#ifdef _WIN32

namespace {

// When the handler of a signal starts, the default action of the signal is restored. The handler
// therefore installs itself again, for the second signal.
using Handler = void (*)(int);
Handler handlers[NSIG];

extern "C" void call_handler(int signal) {
  std::signal(signal, call_handler);
  handlers[signal](signal);
}

}  // namespace

void handle(int signal, void (*handler)(int)) {
  handlers[signal] = handler;
  std::signal(signal, call_handler);
}

void ignore_failed_writes() {}

void handle_alarm(void (* /*handler*/)(int)) {}
void alarm_after(double /*seconds*/) {}

void use_bytes_in_standard_streams() {
  ::_setmode(STDIN_FILENO, O_BINARY);
  ::_setmode(STDOUT_FILENO, O_BINARY);
}

namespace {

std::uint64_t memory_now() {
  PROCESS_MEMORY_COUNTERS counters{};
  const bool is_known =
      ::GetProcessMemoryInfo(::GetCurrentProcess(), &counters, sizeof(counters)) != 0;
  return is_known ? counters.PagefileUsage : 0;
}

}  // namespace

void limit_growth(std::uint64_t bytes, unsigned threads) {
  constexpr std::uint64_t kStack = std::uint64_t{1} << 20;
  const HANDLE job = ::CreateJobObjectA(nullptr, nullptr);
  if (job == nullptr) return;
  JOBOBJECT_EXTENDED_LIMIT_INFORMATION limits{};
  limits.BasicLimitInformation.LimitFlags = JOB_OBJECT_LIMIT_PROCESS_MEMORY;
  limits.ProcessMemoryLimit = static_cast<SIZE_T>(memory_now() + bytes + kStack * threads);
  ::SetInformationJobObject(job, JobObjectExtendedLimitInformation, &limits, sizeof(limits));
  ::AssignProcessToJobObject(job, ::GetCurrentProcess());
  ::CloseHandle(job);  // The job exists as long as its process.
}

std::uint64_t granted_memory() { return std::numeric_limits<std::uint64_t>::max(); }

BlockedSignals::BlockedSignals() {}
BlockedSignals::~BlockedSignals() {}

#else

void handle(int signal, void (*handler)(int)) {
  struct sigaction action {};
  action.sa_handler = handler;  // The flag SA_RESTART is not set.
  ::sigaction(signal, &action, nullptr);
}

void ignore_failed_writes() {
  handle(SIGPIPE, SIG_IGN);
  handle(SIGXFSZ, SIG_IGN);
}

void handle_alarm(void (*handler)(int)) { handle(SIGALRM, handler); }

void alarm_after(double seconds) {
  if (kIsSanitized) return;
  constexpr double kLongest = 1e9, kMicroseconds = 1e6;
  const double whole = std::floor(std::min(seconds, kLongest));
  itimerval timer{};
  timer.it_value.tv_sec = static_cast<time_t>(whole);
  // The value must be below a million. A value of 0 seconds and 0 microseconds would cancel the
  // timer.
  timer.it_value.tv_usec = static_cast<suseconds_t>(
      std::max(1.0, (std::min(seconds, kLongest) - whole) * (kMicroseconds - 1)));
  ::setitimer(ITIMER_REAL, &timer, nullptr);
}

void use_bytes_in_standard_streams() {}

namespace {

/// Returns the private writable memory of the process, which the system compares with RLIMIT_DATA.
std::uint64_t private_memory() {
  std::uint64_t kilobytes = 0;
  if (std::FILE* file = std::fopen("/proc/self/status", "r")) {
    char line[256];
    unsigned long long read = 0;
    while (std::fgets(line, sizeof(line), file) != nullptr) {
      if (std::sscanf(line, "VmData: %llu kB", &read) == 1) kilobytes = read;
    }
    std::fclose(file);
  }
  return kilobytes << 10U;
}

/// Returns the number of bytes that malloc holds, but that are not in use. If this is more than
/// `most`, the memory at the end of the heap is returned to the system first.
std::uint64_t free_memory_of_heap(std::uint64_t most) {
#if defined(__GLIBC__)
  if (::mallinfo2().fordblks > most) ::malloc_trim(0);
  return ::mallinfo2().fordblks;
#else
  static_cast<void>(most);
  return 0;
#endif
}

/// Makes all threads that start later allocate memory from one heap. If a thread had an arena of
/// its own, the memory that it frees would count, but other threads could not use it.
void share_heap() {
#if defined(__GLIBC__)
  ::mallopt(M_ARENA_MAX, 1);
#endif
}

/// Returns the greatest possible size of the stack of a thread.
std::uint64_t bytes_of_stack() {
  constexpr rlim_t kUsual = rlim_t{8} << 20;
  rlimit limit{};
  const bool is_known = ::getrlimit(RLIMIT_STACK, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY;
  return is_known ? limit.rlim_cur : kUsual;
}

}  // namespace

void limit_growth(std::uint64_t bytes, unsigned threads) {
  if (kIsSanitized) return;
  if (threads > 0) share_heap();
  const std::uint64_t free = free_memory_of_heap(bytes);
  const std::uint64_t mapped = private_memory();
  rlimit limit{};
  if (mapped == 0 || ::getrlimit(RLIMIT_DATA, &limit) != 0) return;
  const std::uint64_t used = mapped - std::min(free, mapped);
  const auto wanted = static_cast<rlim_t>(used + bytes + bytes_of_stack() * threads);
  if (limit.rlim_cur != RLIM_INFINITY && limit.rlim_cur <= wanted) return;
  limit.rlim_cur = wanted;
  ::setrlimit(RLIMIT_DATA, &limit);
}

std::uint64_t granted_memory() {
  rlimit limit{};
  const bool is_limited = ::getrlimit(RLIMIT_AS, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY;
  return is_limited ? limit.rlim_cur : std::numeric_limits<std::uint64_t>::max();
}

BlockedSignals::BlockedSignals() {
  sigset_t all;
  ::sigfillset(&all);
  ::pthread_sigmask(SIG_BLOCK, &all, &before_);
}
BlockedSignals::~BlockedSignals() { ::pthread_sigmask(SIG_SETMASK, &before_, nullptr); }

namespace {

/// The signal ends the process when the handler returns, because it is blocked until then.
extern "C" void end_group_and_process(int signal) {
  end_group();
  std::signal(signal, SIG_DFL);
  ::raise(signal);
}

/// Replaces only the handler `from`. For example, nohup ignores SIGHUP, and this must not change.
void replace_handler(int signal, void (*from)(int), void (*to)(int)) {
  struct sigaction now {};
  if (::sigaction(signal, nullptr, &now) == 0 && now.sa_handler == from) handle(signal, to);
}

}  // namespace

EndsWithProcess::EndsWithProcess(pid_t group) {
  group_to_end = group;
  for (const int signal : {SIGHUP, SIGQUIT}) {
    replace_handler(signal, SIG_DFL, end_group_and_process);
  }
}
EndsWithProcess::~EndsWithProcess() {
  end_group();
  group_to_end = 0;
  for (const int signal : {SIGHUP, SIGQUIT}) {
    replace_handler(signal, end_group_and_process, SIG_DFL);
  }
}

#endif

}  // namespace plumb::cli::process
