// Where the result of a command on solids goes, and what is said of it.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <ostream>
#include <string>

#include "plumb/io/solid_text.h"
#include "plumb/space/nef3.h"
#include "session.h"

namespace plumb::cli {

/// The object of `plumb solid info --json`.
nlohmann::ordered_json solid_json(const Nef3& set);
void write_solid_info(std::ostream& out, const Nef3& set);

/// The file or stream for a set, opened before the work: a path that cannot be written costs nothing. Without
/// -o and --format: .nef on standard output; with --json nothing but the object.
class SolidOutput {
 public:
  void open(Session& session);
  /// Under `strict`, a file that would not say all is not written.
  void prepare(const Nef3& set, bool strict, Session& session);
  void deliver(Session& session);

 private:
  std::string name() const { return path_ == "-" ? "stdout" : path_; }

  std::string path_;  // empty: the set is not written
  SolidFormat format_;
  std::optional<SolidText> text_;
  nlohmann::ordered_json json_;
};

}  // namespace plumb::cli
