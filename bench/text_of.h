// What a writer writes, in memory.
#pragma once

#include <sstream>
#include <string>
#include <utility>

namespace plumb::bench {

/// Of `write(std::ostream&)`.
template <class Write>
std::string text_of(Write write) {
  std::ostringstream out;
  write(out);
  return std::move(out).str();
}

}  // namespace plumb::bench
