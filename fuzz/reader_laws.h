// What every reader keeps, whatever the bytes: for fuzz targets of readers.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <string_view>

#include "plumb/predicates/error.h"

namespace plumb::fuzz {

inline void require(bool holds, const char* law) {
  if (holds) return;
  std::fprintf(stderr, "broken: %s\n", law);
  std::abort();
}

/// The name that targets give their file.
inline constexpr const char* kFileName = "fuzzed";

/// An error names the file, a line of it, and a column in that line.
inline void require_place(const Error& error, std::string_view text) {
  const TextPlace& place = error.place();
  require(place.file == kFileName, "an error names the file");
  const auto lines = static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n')) + 1;
  require(place.line >= 1 && place.line <= lines, "an error's line is one of the file");
  std::string_view rest = text;
  for (std::size_t i = 1; i < place.line; ++i) rest.remove_prefix(rest.find('\n') + 1);
  const std::size_t length = rest.substr(0, rest.find('\n')).size();
  require(place.column >= 1 && place.column <= length + 1, "an error's column lies in its line");
}

/// In text with a line and a column inside the file; elsewhere with the file at least.
inline void require_binary_place(const Error& error, std::string_view bytes) {
  if (error.place().line != 0) return require_place(error, bytes);
  require(error.place().file == kFileName, "an error names the file");
}

}  // namespace plumb::fuzz
