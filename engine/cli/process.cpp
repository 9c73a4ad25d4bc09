#include "process.h"

#include <gmp.h>
#include <sys/resource.h>
#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <new>

#include "exit_code.h"
#include "plumb/base/keep_freed_memory.h"
#include "plumb/io/output_file.h"

namespace plumb::cli {
namespace {

std::stop_source& stop_source() {
  static std::stop_source source;
  return source;
}

[[noreturn]] void leave(ExitCode code) {
  remove_temporary_files();
  ::_exit(static_cast<int>(code));
}

/// request_stop() is an atomic exchange as long as no stop callback is registered, and none is.
extern "C" void on_stop_signal(int) {
  if (!stop_source().request_stop()) leave(ExitCode::Cancelled);
}

extern "C" void on_abort(int) { leave(ExitCode::Internal); }

/// No SA_RESTART: a read that waits for input ends, and notices the stop.
void handle(int signal, void (*handler)(int)) {
  struct sigaction action {};
  action.sa_handler = handler;
  ::sigaction(signal, &action, nullptr);
}

void* require(void* memory) {
  if (memory == nullptr) throw std::bad_alloc();
  return memory;
}

void* gmp_allocate(std::size_t size) { return require(std::malloc(size)); }
void* gmp_reallocate(void* memory, std::size_t, std::size_t size) {
  return require(std::realloc(memory, size));
}
void gmp_free(void* memory, std::size_t) { std::free(memory); }

std::uint64_t address_space_now() {
  std::uint64_t pages = 0;
  if (std::FILE* file = std::fopen("/proc/self/statm", "r")) {
    unsigned long long read = 0;
    if (std::fscanf(file, "%llu", &read) == 1) pages = read;
    std::fclose(file);
  }
  return pages * static_cast<std::uint64_t>(::sysconf(_SC_PAGESIZE));
}

}  // namespace

bool is_stop_requested() { return stop_source().stop_requested(); }

std::stop_token prepare_process() {
  stop_source();  // made before a signal can ask for it
  handle(SIGINT, on_stop_signal);
  handle(SIGTERM, on_stop_signal);
  handle(SIGPIPE, SIG_IGN);
  handle(SIGXFSZ, SIG_IGN);
  handle(SIGABRT, on_abort);
  ::mp_set_memory_functions(gmp_allocate, gmp_reallocate, gmp_free);
  keep_freed_memory();
  use_huge_pages();
  return stop_source().get_token();
}

void limit_address_space(std::uint64_t bytes) {
  constexpr std::uint64_t kSlack = std::uint64_t{64} << 20U;
  rlimit limit{};
  if (::getrlimit(RLIMIT_AS, &limit) != 0) return;
  const rlim_t wanted = address_space_now() + bytes + kSlack;
  if (limit.rlim_cur != RLIM_INFINITY && limit.rlim_cur <= wanted) return;
  limit.rlim_cur = wanted;
  ::setrlimit(RLIMIT_AS, &limit);
}

}  // namespace plumb::cli
