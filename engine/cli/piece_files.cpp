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

void PieceFiles::note_losses(std::string_view better, Session& session) const {
  if (changed_ == 0) return;
  session.note(directory_ + ": warning: " + std::to_string(changed_) + " of " +
               counted(files_.size(), "file") + " do not say all (--format " + std::string(better) +
               " does); of " + worst_ + ": " + worst_losses_.back());
}

void PieceFiles::commit(const std::vector<std::string_view>& extensions, const std::string& input) {
  commit_all(files_);
  if (!is_wanted()) return;
  made_->keep();
  std::error_code failed;
  std::filesystem::directory_iterator at(directory_, failed);
  for (; !failed && at != std::filesystem::directory_iterator(); at.increment(failed)) {
    std::error_code ignored;
    if (!is_older(at->path().filename().string(), extensions)) continue;
    if (!at->is_regular_file(ignored)) continue;
    if (std::filesystem::equivalent(at->path(), input, ignored)) continue;
    std::filesystem::remove(at->path(), ignored);
  }
}

bool PieceFiles::is_older(const std::string& name,
                          const std::vector<std::string_view>& extensions) const {
  std::size_t number = 0;
  const auto [end, failed] = std::from_chars(name.data() + std::min(kStem.size(), name.size()),
                                             name.data() + name.size(), number);
  if (failed != std::errc() || number <= files_.size()) return false;
  return std::ranges::any_of(
      extensions, [&](std::string_view extension) { return name == file_name(number, extension); });
}

}  // namespace plumb::cli
