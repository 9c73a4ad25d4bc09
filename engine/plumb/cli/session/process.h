// What the program asks of the system for its own process, where POSIX and Windows differ.
#pragma once

#include <unistd.h>

#include <csignal>
#include <cstdint>

namespace plumb::cli::process {

/// Calls `handler` whenever the signal arrives. On POSIX, a read that waits for input ends then. On
/// Windows, a signal is Ctrl-C, or comes from the process itself.
void handle(int signal, void (*handler)(int));

/// Makes a write to a closed pipe, or beyond the largest size of a file, fail as any other write.
void ignore_failed_writes();

/// Returns the bytes of address space (on Windows, of memory promised to the process) in use.
std::uint64_t memory_now();

/// Makes allocations fail beyond this many bytes, unless a lower limit holds.
void limit_memory(std::uint64_t bytes);

/// Makes standard input and output carry bytes as they are. Windows would change ends of lines.
void use_bytes_in_standard_streams();

/// Whether a descriptor is a regular file.
bool is_regular_file(int descriptor);

/// Threads started while it exists get no signals, so that these interrupt what the first thread
/// waits for. Windows runs handlers in threads of their own.
class BlockedSignals {
 public:
  BlockedSignals();
  ~BlockedSignals();
  BlockedSignals(const BlockedSignals&) = delete;
  BlockedSignals& operator=(const BlockedSignals&) = delete;

#ifndef _WIN32
 private:
  sigset_t before_;
#endif
};

}  // namespace plumb::cli::process
