#include <string>
#include <vector>

#include "process.h"
#include "program.h"

int main(int argc, char** argv) {
  const std::stop_token stop = plumb::cli::prepare_process();
  const std::vector<std::string> arguments(argv + (argc > 0 ? 1 : 0), argv + argc);
  return static_cast<int>(plumb::cli::run_program(arguments, stop));
}
