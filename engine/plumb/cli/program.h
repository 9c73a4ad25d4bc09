// The program: finds the command, parses its options, runs it, and turns errors into exit codes.
#pragma once

#include <stop_token>
#include <string>
#include <vector>

#include "plumb/cli/session/session.h"

namespace plumb::cli {

/// Runs a command. `arguments` come without the program's name. Prints errors to standard error;
/// never throws.
ExitCode run_program(const std::vector<std::string>& arguments, std::stop_token stop) noexcept;

}  // namespace plumb::cli
