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

/// Ends the process, and the group of EndsWithProcess, without any further work. Async-signal-safe.
[[noreturn]] void end_now(int code);

/// Sets the handler of alarm_after().
void handle_alarm(void (*handler)(int));
/// Calls the handler once, after this wall time, instead of at a time that was set before. On
/// Windows, there are no alarms. May be called by a signal handler.
void alarm_after(double seconds);

/// Makes allocations fail once the memory of the process has grown by `bytes`, unless a lower limit
/// holds. The memory of the stacks of `threads` threads that start later is added. On Linux,
/// private writable memory counts; on Windows, memory promised to the process. Elsewhere the
/// function does nothing.
void limit_growth(std::uint64_t bytes, unsigned threads);

/// Returns the bytes of address space that the system grants the process, for instance by
/// `ulimit -v`; the largest number if there is no such limit, and on Windows.
std::uint64_t granted_memory();

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
  /// Returns the signals that were blocked before.
  const sigset_t& before() const { return before_; }

 private:
  sigset_t before_;
#endif
};

#ifndef _WIN32
/// The processes of a group live no longer than the object, and end with this process: in
/// end_now(), and when SIGHUP or SIGQUIT ends it, which a terminal does not send to the group. At
/// most one object exists.
class EndsWithProcess {
 public:
  /// `group` is the id of a child that leads a group of its own, and that is not waited for before
  /// the object ends.
  explicit EndsWithProcess(pid_t group);
  ~EndsWithProcess();
  EndsWithProcess(const EndsWithProcess&) = delete;
  EndsWithProcess& operator=(const EndsWithProcess&) = delete;
};
#endif

}  // namespace plumb::cli::process
