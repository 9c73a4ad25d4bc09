#include "set_output.h"

#include <filesystem>

#include "plumb/base/error.h"

namespace plumb::cli {

std::string SetOutput::title() const {
  return path_ == "-" ? "" : std::filesystem::path(path_).filename().string();
}

void SetOutput::open_streams(Session& session) {
  const CommonOptions& common = session.options();
  if (!common.out.empty() || !common.format.empty() || !common.json) {
    path_ = common.out.empty() ? "-" : common.out;
    session.outputs().add(path_, [this](std::ostream& out) { file_.write(out); });
  }
  if (common.json) {
    session.outputs().add("-", [this](std::ostream& out) { out << json_.dump() << '\n'; });
  }
}

void SetOutput::prepare(const std::function<nlohmann::ordered_json()>& info,
                        const std::function<ReadyFile()>& make, bool strict, Session& session) {
  if (session.options().json) json_ = info();
  if (path_.empty()) return;
  try {
    file_ = make();
  } catch (const Error& error) {
    if (error.code() != ErrorCode::CannotWrite) throw;
    throw Error(error.code(), error.message(), {name()});
  }
  if (!strict || file_.losses.empty()) return;
  throw Error(ErrorCode::CannotWrite, "--strict: " + file_.losses.front(), {name()});
}

void SetOutput::deliver(Session& session) {
  session.deliver();
  for (const std::string& loss : file_.losses) session.note(name() + ": warning: " + loss);
}

}  // namespace plumb::cli
