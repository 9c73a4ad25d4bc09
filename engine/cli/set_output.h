// Where the result of a command on sets goes, in the plane and in space, and what is said of it.
#pragma once

#include <cstddef>
#include <functional>
#include <iterator>
#include <nlohmann/json.hpp>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

#include "format_choice.h"
#include "session.h"

namespace plumb::cli {

/// A set made ready for a file: all work and all judgement is done.
struct ReadyFile {
  std::function<void(std::ostream&)> write;
  std::vector<std::string> losses;  ///< what the file will not say; one sentence each
};

/// The file or stream for a set, opened before the work: a path that cannot be written costs nothing.
/// Without -o and --format the set goes to standard output in a format that it chooses itself; with --json
/// nothing but the object does.
class SetOutput {
 public:
  /// `formats` is a table as in format_choice.h.
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

  /// `info` and `make` are called for what is wanted only. Under `strict` a file that would not say all is not
  /// written. Errors: those of `make`, CannotWrite with the name of the file.
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

}  // namespace plumb::cli
