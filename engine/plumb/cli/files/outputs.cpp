// Results as files, and pictures as bytes.
//
// SetOutput opens its file before the work and prepares all bytes that can fail before any are
// written, so a run either leaves a complete file or none.
// Tested by tests/cli/view_command_test.cpp, tests/cli/plane_command_test.cpp and
// tests/cli/solid_command_test.cpp.
#include "plumb/cli/files/outputs.h"

#include <filesystem>
#include <string>
#include <utility>

#include "plumb/io/solid/solid_text.h"
#include "plumb/io/text/file_names.h"
#include "plumb/picture/png/encode_png.h"
#include "plumb/predicates/error.h"

namespace plumb::cli {

std::string SetOutput::title() const {
  return path_ == "-" ? "" : file_name_of(path_of(path_).filename());
}

std::string SetOutput::material_library() const { return material_library_of(path_); }

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
    const bool names_place = !error.place().file.empty();
    if (names_place ||
        (error.code() != ErrorCode::CannotWrite && error.code() != ErrorCode::NumberOutOfRange)) {
      throw;
    }
    throw Error(error.code(), error.message(), {name()});
  }
  if (file_.write_library && !material_library().empty()) {
    const auto path = path_of(path_).replace_extension(".mtl");
    session.outputs().add(file_name_of(path), file_.write_library);
  }
  if (!strict) return;
  for (const std::vector<std::string>* const told : {&file_.losses, &file_.changes}) {
    if (told->empty()) continue;
    throw Error(ErrorCode::CannotWrite, "--strict: " + told->front(), {name()});
  }
}

void SetOutput::deliver(Session& session) {
  session.deliver();
  for (const std::string& loss : file_.losses) session.note(name() + ": warning: " + loss);
  if (!file_.dropped.empty()) session.note(name() + ": " + file_.dropped);
}

PictureOptions picture(PictureFormat format, std::string title) {
  return {format, std::move(title), encode_png};
}

}  // namespace plumb::cli
