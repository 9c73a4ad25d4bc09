#include "plumb/cli/session/process.h"

#include <fcntl.h>
#include <sys/stat.h>

#ifdef _WIN32
#include <windows.h>
// Needs the header above it.
#include <io.h>
#include <psapi.h>
#else
#include <sys/resource.h>
#endif

#include <cstdio>

namespace plumb::cli::process {

bool is_regular_file(int descriptor) {
  struct stat status {};
  return ::fstat(descriptor, &status) == 0 && S_ISREG(status.st_mode);
}

#ifdef _WIN32

namespace {

// A signal whose handler runs gets its default action back. That is undone here, for the second
// signal.
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

void use_bytes_in_standard_streams() {
  ::_setmode(STDIN_FILENO, O_BINARY);
  ::_setmode(STDOUT_FILENO, O_BINARY);
}

std::uint64_t memory_now() {
  PROCESS_MEMORY_COUNTERS counters{};
  const bool is_known =
      ::GetProcessMemoryInfo(::GetCurrentProcess(), &counters, sizeof(counters)) != 0;
  return is_known ? counters.PagefileUsage : 0;
}

void limit_memory(std::uint64_t bytes) {
  const HANDLE job = ::CreateJobObjectA(nullptr, nullptr);
  if (job == nullptr) return;
  JOBOBJECT_EXTENDED_LIMIT_INFORMATION limits{};
  limits.BasicLimitInformation.LimitFlags = JOB_OBJECT_LIMIT_PROCESS_MEMORY;
  limits.ProcessMemoryLimit = static_cast<SIZE_T>(bytes);
  ::SetInformationJobObject(job, JobObjectExtendedLimitInformation, &limits, sizeof(limits));
  ::AssignProcessToJobObject(job, ::GetCurrentProcess());
  ::CloseHandle(job);  // The job lives as long as its process.
}

BlockedSignals::BlockedSignals() {}
BlockedSignals::~BlockedSignals() {}

#else

void handle(int signal, void (*handler)(int)) {
  struct sigaction action {};
  action.sa_handler = handler;  // Without SA_RESTART.
  ::sigaction(signal, &action, nullptr);
}

void ignore_failed_writes() {
  handle(SIGPIPE, SIG_IGN);
  handle(SIGXFSZ, SIG_IGN);
}

void use_bytes_in_standard_streams() {}

std::uint64_t memory_now() {
  std::uint64_t pages = 0;
  if (std::FILE* file = std::fopen("/proc/self/statm", "r")) {
    unsigned long long read = 0;
    if (std::fscanf(file, "%llu", &read) == 1) pages = read;
    std::fclose(file);
  }
  return pages * static_cast<std::uint64_t>(::sysconf(_SC_PAGESIZE));
}

void limit_memory(std::uint64_t bytes) {
  rlimit limit{};
  if (::getrlimit(RLIMIT_AS, &limit) != 0) return;
  const auto wanted = static_cast<rlim_t>(bytes);
  if (limit.rlim_cur != RLIM_INFINITY && limit.rlim_cur <= wanted) return;
  limit.rlim_cur = wanted;
  ::setrlimit(RLIMIT_AS, &limit);
}

BlockedSignals::BlockedSignals() {
  sigset_t all;
  ::sigfillset(&all);
  ::pthread_sigmask(SIG_BLOCK, &all, &before_);
}
BlockedSignals::~BlockedSignals() { ::pthread_sigmask(SIG_SETMASK, &before_, nullptr); }

#endif

}  // namespace plumb::cli::process
