#include "piece_files.h"

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <utility>

#include "plumb/base/error.h"
#include "plumb/picture/sheet.h"

namespace plumb::cli {
namespace {

constexpr std::string_view kStem = "piece_";

std::string file_name(std::size_t piece, std::string_view extension) {
  std::string number = std::to_string(piece);
  if (number.size() < 4) number.insert(0, 4 - number.size(), '0');
  return std::string(kStem) + number + std::string(extension);
}

/// Of the file's name; 0: no piece in one of the extensions has it.
std::size_t piece_number(const std::string& name, const std::vector<std::string_view>& extensions) {
  std::size_t number = 0;
  const auto [end, failed] = std::from_chars(name.data() + std::min(kStem.size(), name.size()),
                                             name.data() + name.size(), number);
  const auto is_name = [&](std::string_view extension) {
    return name == file_name(number, extension);
  };
  return failed == std::errc() && std::ranges::any_of(extensions, is_name) ? number : 0;
}

}  // namespace

PieceFiles::PieceFiles(std::string directory) : directory_(std::move(directory)) {
  if (directory_.empty()) return;
  if (directory_ == "-") throw Error(ErrorCode::Usage, "-o needs a directory");
  made_.emplace(directory_);
}

void PieceFiles::add(std::string_view extension, const std::vector<std::string>& losses,
                     const std::function<void(std::ostream&)>& write) {
  const std::string name = file_name(files_.size() + 1, extension);
  if (!losses.empty()) ++changed_;
  if (losses.size() > worst_losses_.size()) {
    worst_ = name;
    worst_losses_ = losses;
  }
  const auto path = std::filesystem::path(directory_) / name;
  files_.push_back(std::make_unique<OutputFile>(path.string()));
  write(files_.back()->stream());
  files_.back()->finish();
}

void PieceFiles::open_picture(const std::string& path,
                              const std::vector<std::string_view>& extensions) {
  namespace fs = std::filesystem;
  if (path == "-") throw Error(ErrorCode::Usage, "--svg needs a file");
  if (is_wanted()) {
    std::error_code ignored;  // what is no path cannot be opened either
    const fs::path picture = fs::weakly_canonical(path, ignored);
    const bool is_beside = fs::equivalent(picture.parent_path(), directory_, ignored);
    if (is_beside && piece_number(picture.filename().string(), extensions) > 0) {
      throw Error(ErrorCode::Usage, "--svg has the name of a piece", {.file = path});
    }
  }
  picture_ = std::make_unique<OutputFile>(path);
}

void PieceFiles::finish_picture(std::string_view bytes) {
  picture_->stream() << bytes;
  picture_->finish();
}

void PieceFiles::note_losses(std::string_view better, Session& session) const {
  if (changed_ == 0) return;
  session.note(directory_ + ": warning: " + std::to_string(changed_) + " of " +
               counted(files_.size(), "file") + " do not say all (--format " + std::string(better) +
               " does); of " + worst_ + ": " + worst_losses_.back());
}

void PieceFiles::commit(const std::vector<std::string_view>& extensions, const std::string& input) {
  const std::size_t pieces = files_.size();
  if (picture_) files_.push_back(std::move(picture_));
  commit_all(files_);
  if (!is_wanted()) return;
  made_->keep();
  std::error_code failed;
  std::filesystem::directory_iterator at(directory_, failed);
  for (; !failed && at != std::filesystem::directory_iterator(); at.increment(failed)) {
    std::error_code ignored;
    if (piece_number(at->path().filename().string(), extensions) <= pieces) continue;
    if (!at->is_regular_file(ignored)) continue;
    if (std::filesystem::equivalent(at->path(), input, ignored)) continue;
    std::filesystem::remove(at->path(), ignored);
  }
}

}  // namespace plumb::cli
