// Which outputs a command writes, and in which format. A command has a table of formats, each with
// members `name` ("svg") and `extension` (".svg").
#pragma once

#include <filesystem>
#include <string>

#include "plumb/base/error.h"
#include "session.h"

namespace plumb::cli {

/// "text, json, svg".
template <class Table>
std::string names_of(const Table& formats) {
  std::string names;
  for (const auto& format : formats)
    names += (names.empty() ? "" : ", ") + std::string(format.name);
  return names;
}

/// ".txt, .json, .svg", each once.
template <class Table>
std::string extensions_of(const Table& formats) {
  std::string names;
  for (const auto& format : formats) {
    if (names.find(format.extension) == names.npos)
      names += (names.empty() ? "" : ", ") + std::string(format.extension);
  }
  return names;
}

/// Errors: Usage.
template <class Table>
const auto& format_named(const Table& formats, const std::string& name) {
  for (const auto& format : formats) {
    if (format.name == name) return format;
  }
  throw Error(ErrorCode::Usage, "--format: '" + name + "' is none of " + names_of(formats));
}

/// Errors: UnknownFormat.
template <class Table>
const auto& format_of_file(const Table& formats, const std::string& path) {
  const std::string extension = std::filesystem::path(path).extension().string();
  for (const auto& format : formats) {
    if (format.extension == extension) return format;
  }
  throw Error(ErrorCode::UnknownFormat,
              "no format has the extension '" + extension + "'; use " + extensions_of(formats) +
                  " or --format",
              {path});
}

/// Calls add(path, format) for what -o, --format and --json ask for; when they ask for nothing and
/// standard output is not taken, for text on it. Errors: Usage, UnknownFormat.
template <class Table, class Add>
void add_outputs(const CommonOptions& options, const Table& formats, bool is_stdout_free,
                 const Add& add) {
  if (options.out == "-" && options.format.empty()) {
    throw Error(ErrorCode::Usage, "-o - needs --format " + names_of(formats));
  }
  const std::string out = options.out.empty() && !options.format.empty() ? "-" : options.out;
  if (!out.empty()) {
    const auto& format = options.format.empty() ? format_of_file(formats, out)
                                                : format_named(formats, options.format);
    const bool is_said_twice = options.json && out == "-" && format.name == "json";
    if (!is_said_twice) add(out, format);
  }
  if (options.json) add("-", format_named(formats, "json"));
  if (out.empty() && !options.json && is_stdout_free) add("-", format_named(formats, "text"));
}

}  // namespace plumb::cli
