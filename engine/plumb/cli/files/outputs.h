// The outputs of commands: which outputs a command writes and in which formats, results that are
// sets, and how pictures are made. A command has a table of formats, each with members `name`
// ("svg") and `extension` (".svg").
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
#include <utility>
#include <vector>

#include "plumb/base/context.h"
#include "plumb/cli/session/session.h"
#include "plumb/io/plane_io.h"
#include "plumb/picture/pictures.h"
#include "plumb/predicates/error.h"

namespace plumb::cli {

/// Returns the names, as in "text, json, svg".
template <class Table>
std::string names_of(const Table& formats) {
  std::string names;
  for (const auto& format : formats)
    names += (names.empty() ? "" : ", ") + std::string(format.name);
  return names;
}

/// Returns the extensions, as in ".txt, .json, .svg", each once.
template <class Table>
std::string extensions_of(const Table& formats) {
  std::string names;
  for (const auto& format : formats) {
    if (names.find(format.extension) == names.npos)
      names += (names.empty() ? "" : ", ") + std::string(format.extension);
  }
  return names;
}

/// Returns the format of a name. Throws Error{Usage} if there is none.
template <class Table>
const auto& format_named(const Table& formats, const std::string& name) {
  for (const auto& format : formats) {
    if (format.name == name) return format;
  }
  throw Error(ErrorCode::Usage, "--format: '" + name + "' is none of " + names_of(formats));
}

/// Returns the format of a file by its extension. Throws Error{UnknownFormat} if there is none.
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

/// Calls add(path, format) for each output that -o, --format and --json ask for. If they ask for
/// nothing and standard output is free, calls it for text on standard output. Throws Error{Usage}
/// and Error{UnknownFormat}.
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

// Results that are sets of the plane or of space, and the messages about them.

/// A set prepared for a file: all work and all checks are done.
struct ReadyFile {
  std::function<void(std::ostream&)> write;
  std::vector<std::string> losses;  ///< What the file will leave out; one sentence each.
  /// What the file will say otherwise, one sentence each, that only --strict minds: that the
  /// closure of the set is written, and that rounding needed a repair.
  std::vector<std::string> changes;
  std::string dropped = {};  ///< A sentence on attributes that the file does not hold, or empty.
  /// Writes the material library, a file beside this one; empty if there is none.
  std::function<void(std::ostream&)> write_library = {};
};

/// The file or stream for a set, opened before the work: a path that cannot be written costs
/// nothing. Without -o and --format the set goes to standard output in a format that it chooses
/// itself; with --json nothing but the object does.
class SetOutput {
 public:
  /// Opens the output. `formats` is a table as described above.
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

  /// Sets how coordinates become doubles in shapes.
  void set_rounding(PlaneWriteOptions rounding) { rounding_ = std::move(rounding); }
  const PlaneWriteOptions& rounding() const { return rounding_; }
  /// Sets whether the faces of input meshes stay apart.
  void set_keeps_faces(bool keeps_faces) { keeps_faces_ = keeps_faces; }
  bool keeps_faces() const { return keeps_faces_; }
  /// Sets whether all faces of meshes are triangles.
  void set_writes_triangles(bool writes_triangles) { writes_triangles_ = writes_triangles; }
  bool writes_triangles() const { return writes_triangles_; }
  /// Returns which of the formats was asked for, if any.
  std::optional<std::ptrdiff_t> format() const { return format_; }
  /// Returns the name of a material library beside the file, without folders; empty for standard
  /// output.
  std::string material_library() const;
  /// Returns the name of the file without folders; empty for standard output.
  std::string title() const;

  /// Prepares the output. `info` and `make` are called only if they are needed. Under `strict`, a
  /// file that would leave something out is not written. Throws the exceptions of `make`, and
  /// Error{CannotWrite} with the name of the file.
  void prepare(const std::function<nlohmann::ordered_json()>& info,
               const std::function<ReadyFile()>& make, bool strict, Session& session);
  /// Writes the output.
  void deliver(Session& session);

 private:
  void open_streams(Session& session);
  std::string name() const { return path_ == "-" ? "stdout" : path_; }

  std::string path_;  // Empty if the set is not written.
  std::optional<std::ptrdiff_t> format_;
  PlaneWriteOptions rounding_;
  bool keeps_faces_ = false;
  bool writes_triangles_ = false;
  ReadyFile file_;
  nlohmann::ordered_json json_;
};

/// Returns how a picture is made, with the encoder of PNG.
PictureOptions picture(PictureFormat format, std::string title);

}  // namespace plumb::cli
