// Numbers on the command line, and exact ones for people to read.
#pragma once

#include <string>

#include "plumb/predicates/rational.h"
#include "session.h"

namespace plumb::cli {

/// A number given as an argument, by the rules for numbers in files. `name` is said in Error{Usage}.
Rational read_number_argument(const std::string& text, const std::string& name, Session& session);

/// Exactly, unless that is longer than a person reads (areas of doubles can have thousands of digits): then the
/// nearest double, and how many digits the exact number has.
std::string readable(const Rational& value);

}  // namespace plumb::cli
