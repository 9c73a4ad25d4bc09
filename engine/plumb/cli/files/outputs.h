// Which outputs a command writes, and in which format. A command has a table of formats, each with
// members `name` ("svg") and `extension` (".svg").
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <iterator>
#include <nlohmann/json.hpp>
#include <optional>
#include <ostream>
#include <span>
#include <string>
#include <vector>

#include "plumb/base/context.h"
#include "plumb/cli/session/session.h"
#include "plumb/picture/surface_scene.h"
#include "plumb/plane/map_check.h"
#include "plumb/plane/nef2.h"
#include "plumb/predicates/error.h"
#include "plumb/space/nef3.h"
#include "plumb/surface/surface.h"

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

// Where the result of a command on sets goes, in the plane and in space, and what is said of it.

/// A set made ready for a file: all work and all judgement is done.
struct ReadyFile {
  std::function<void(std::ostream&)> write;
  std::vector<std::string> losses;  ///< what the file will not say; one sentence each
};

/// The file or stream for a set, opened before the work: a path that cannot be written costs
/// nothing. Without -o and --format the set goes to standard output in a format that it chooses
/// itself; with --json nothing but the object does.
class SetOutput {
 public:
  /// `formats` is a table as in outputs.h.
  template <class Table>
  void open(const Table& formats, Session& session) {
    const CommonOptions& common = session.options();
    if (common.out == "-" && common.format.empty()) {
      throw Error(ErrorCode::Usage, "-o - needs --format " + names_of(formats));
    }
    const auto* const first = &*std::begin(formats);
    if (!common.format.empty()) {
      format_ = &format_named(formats, common.format) - first;
    } else if (!common.out.empty()) {
      format_ = &format_of_file(formats, common.out) - first;
    }
    open_streams(session);
  }

  /// Which of the formats was asked for, if any.
  std::optional<std::ptrdiff_t> format() const { return format_; }
  /// What the file is called, without folders; empty for standard output.
  std::string title() const;

  /// `info` and `make` are called for what is wanted only. Under `strict` a file that would not say
  /// all is not written. Errors: those of `make`, CannotWrite with the name of the file.
  void prepare(const std::function<nlohmann::ordered_json()>& info,
               const std::function<ReadyFile()>& make, bool strict, Session& session);
  void deliver(Session& session);

 private:
  void open_streams(Session& session);
  std::string name() const { return path_ == "-" ? "stdout" : path_; }

  std::string path_;  // empty: the set is not written
  std::optional<std::ptrdiff_t> format_;
  ReadyFile file_;
  nlohmann::ordered_json json_;
};

// Pictures of results as the bytes of a file.

enum class Picture : std::uint8_t { Png, Svg, Html, Glb };

std::string picture_of(const Nef3& set, Picture picture, const std::string& title,
                       Context& context);
/// Several sets, each in a colour of its own, moved apart (space_scene.h).
std::string picture_of(std::span<const Nef3> sets, double apart, Picture picture,
                       const std::string& title, Context& context);
/// `shown` is what an image shows; a page has all layers, to be turned on and off.
std::string picture_of(const SurfaceDivision& division, const SurfaceResult* result,
                       SurfaceLayer shown, Picture picture, const std::string& title,
                       Context& context);
std::string picture_of(const Nef2& set, Picture picture, const std::string& title);
std::string picture_of(const MapReport& report, Picture picture, const std::string& title);

}  // namespace plumb::cli
