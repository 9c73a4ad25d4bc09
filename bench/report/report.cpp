#include "report.h"

#include <fmt/core.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <exception>
#include <fstream>
#include <stdexcept>
#include <utility>

namespace plumb::bench {
namespace {

std::string read_all(int end) {
  std::string text;
  std::array<char, 4096> part{};
  for (ssize_t count = 0; (count = read(end, part.data(), part.size())) > 0;) {
    text.append(part.data(), static_cast<std::size_t>(count));
  }
  return text;
}

[[noreturn]] void run_child(int output, const std::function<void()>& work) {
  int status = 1;
  dup2(output, STDOUT_FILENO);
  close(output);
  try {
    work();
    if (std::fflush(stdout) == 0) status = 0;
  } catch (const std::exception& error) {
    fmt::print(stderr, "{}\n", error.what());
  }
  _exit(status);
}

}  // namespace

nlohmann::ordered_json spread(std::vector<double> values) {
  std::ranges::sort(values);
  return {{"least", values.front()},
          {"median", values[values.size() / 2]},
          {"greatest", values.back()}};
}

std::string spread_text(const nlohmann::ordered_json& spread) {
  return fmt::format("{:.3f} ({:.3f} .. {:.3f})", spread["median"].get<double>(),
                     spread["least"].get<double>(), spread["greatest"].get<double>());
}

int write_json(const std::string& file, const nlohmann::ordered_json& json, int status) {
  if (file.empty()) return status;
  std::ofstream out(file);
  if ((out << json.dump(1) << '\n').flush()) return status;
  fmt::print(stderr, "{}: cannot be written\n", file);
  return 2;
}

Finished run_apart(const std::function<void()>& work) {
  std::array<int, 2> ends{};
  if (pipe(ends.data()) != 0) throw std::runtime_error("no pipe");
  std::fflush(stdout);
  const pid_t child = fork();
  if (child < 0) throw std::runtime_error("no process");
  if (child == 0) {
    close(ends[0]);
    run_child(ends[1], work);
  }
  close(ends[1]);
  Finished result;
  result.output = read_all(ends[0]);
  close(ends[0]);
  int status = 0;
  rusage usage{};
  if (wait4(child, &status, 0, &usage) != child) return result;
  result.is_well = status == 0;
  result.megabytes = static_cast<double>(usage.ru_maxrss) / 1024;
  return result;
}

}  // namespace plumb::bench
